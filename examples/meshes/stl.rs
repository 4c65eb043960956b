//! STL files, text and binary: triangles without shared vertices.

use super::obj::RawMesh;

/// The bytes of a binary file before its triangles: a header that says nothing, and how many there are.
const HEADER: usize = 84;
/// The bytes of a triangle: its normal, three corners, and two that say nothing.
const TRIANGLE: usize = 50;

/// Both kinds. Normals are left away, because those of the faces are not those of the vertices.
pub fn read(bytes: &[u8]) -> Result<RawMesh, String> {
    let positions = match bytes.get(80..HEADER) {
        // The text kind begins with this word, but so do some headers: a length that fits decides.
        Some(count) if !bytes.trim_ascii_start().starts_with(b"solid") || fits(count, bytes) => binary(count, bytes)?,
        _ => text(bytes)?,
    };
    let count = u32::try_from(positions.len()).map_err(|_| "is too large")?;
    let triangles = (0..count / 3).map(|i| [3 * i, 3 * i + 1, 3 * i + 2]).collect();
    Ok(RawMesh { positions, triangles, ..RawMesh::default() })
}

fn number(bytes: &[u8]) -> usize {
    bytes.try_into().map_or(0, |bytes| usize::try_from(u32::from_le_bytes(bytes)).unwrap_or(usize::MAX))
}

fn fits(count: &[u8], bytes: &[u8]) -> bool {
    number(count).checked_mul(TRIANGLE).and_then(|length| length.checked_add(HEADER)) == Some(bytes.len())
}

fn binary(count: &[u8], bytes: &[u8]) -> Result<Vec<[f32; 3]>, String> {
    if !fits(count, bytes) {
        return Err(format!("is not an STL file: {} bytes for {} triangles", bytes.len(), number(count)));
    }
    let float = |four: &[u8]| four.try_into().map_or(f32::NAN, f32::from_le_bytes);
    let corner = |twelve: &[u8]| [float(&twelve[..4]), float(&twelve[4..8]), float(&twelve[8..])];
    // Without the normal and the last two bytes.
    let corners = |triangle: &[u8]| triangle[12..48].chunks_exact(12).map(corner).collect::<Vec<_>>();
    Ok(bytes[HEADER..].chunks_exact(TRIANGLE).flat_map(corners).collect())
}

fn text(bytes: &[u8]) -> Result<Vec<[f32; 3]>, String> {
    let text = std::str::from_utf8(bytes).map_err(|_| "is not an STL file: neither text nor long enough")?;
    let (mut positions, mut ended) = (vec![], false);
    for (number, line) in (1..).zip(text.lines()) {
        let words: Vec<_> = line.split_whitespace().collect();
        match words[..] {
            ["vertex", x, y, z] => {
                let [x, y, z] = [x, y, z].map(str::parse::<f32>);
                let wrong = |_| format!("has no numbers in line {number}");
                positions.push([x.map_err(wrong)?, y.map_err(wrong)?, z.map_err(wrong)?]);
            }
            ["endloop"] if positions.len() % 3 != 0 => return Err(format!("has no triangle before line {number}")),
            ["endsolid", ..] => ended = true,
            [] | ["solid" | "facet" | "outer" | "endloop" | "endfacet", ..] => {}
            _ => return Err(format!("is not an STL file: line {number}")),
        }
    }
    if ended && positions.len() % 3 == 0 { Ok(positions) } else { Err("ends before its last triangle".into()) }
}
