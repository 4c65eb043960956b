//! What is lost when a mesh is quantised.

use super::obj::{OwnedMesh, RawMesh, centred};

/// The greatest of some errors, and the root of the mean of their squares.
#[derive(Clone, Copy, Debug, Default)]
struct Errors {
    most: f64,
    squares: f64,
    count: f64,
}

impl Errors {
    fn of(errors: impl Iterator<Item = f64>) -> Self {
        errors.fold(Self::default(), |all, error| Self {
            most: all.most.max(error),
            squares: all.squares + error * error,
            count: all.count + 1.0,
        })
    }

    fn mean(self) -> f64 {
        if self.count > 0.0 { (self.squares / self.count).sqrt() } else { 0.0 }
    }
}

/// Some lines: sizes, and errors of places, normals and texture coordinates.
pub fn of(raw: &RawMesh, owned: &OwnedMesh) -> Result<String, String> {
    let (middle, radius) = raw.sphere()?;
    let places = Errors::of(raw.positions.iter().zip(&owned.positions).map(|(raw, quantised)| {
        let exact = centred(raw, middle);
        let back = quantised.map(|v| f64::from(v) / 16_384.0 * radius);
        exact.iter().zip(back).map(|(a, b)| (a - b) * (a - b)).sum::<f64>().sqrt()
    }));
    let normals = Errors::of(raw.shading_normals().iter().zip(&owned.normals).filter_map(|(raw, quantised)| {
        let (a, b) = (raw.map(f64::from), quantised.map(f64::from));
        let dot = |a: [f64; 3], b: [f64; 3]| a.iter().zip(b).map(|(a, b)| a * b).sum::<f64>();
        let cosine = dot(a, b) / (dot(a, a) * dot(b, b)).sqrt();
        cosine.is_finite().then(|| cosine.clamp(-1.0, 1.0).acos().to_degrees())
    }));
    let flash = 9 * owned.positions.len() + 4 * owned.uv.len() + 6 * owned.triangles.len();
    let mille = 1000.0 / (2.0 * radius);
    let mut lines = vec![
        format!("{} vertices, {} triangles, {flash} bytes of flash", owned.positions.len(), owned.triangles.len()),
        format!(
            "places: off by {:.3e} units at most, {:.3e} rms ({:.4} and {:.4} per mille of the size)",
            places.most,
            places.mean(),
            places.most * mille,
            places.mean() * mille
        ),
        format!("normals: off by {:.2} degrees at most, {:.2} rms", normals.most, normals.mean()),
    ];
    if !owned.uv.is_empty() {
        let uv = Errors::of(raw.uv.iter().zip(&owned.uv).flat_map(|(raw, quantised)| {
            let [u, v] = quantised.map(|v| f64::from(v) / 4096.0);
            [(f64::from(raw[0]) - u).abs(), (1.0 - f64::from(raw[1]) - v).abs()]
        }));
        lines.push(format!("texture: off by {:.5} of its width at most, {:.5} rms", uv.most, uv.mean()));
    }
    Ok(lines.join("\n"))
}
