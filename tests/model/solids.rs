//! Solids are closed, wound counter-clockwise, and have normals of the right length in the right direction.

use std::collections::{BTreeMap, BTreeSet};

use aquatint::model::{
    mesh::Mesh,
    revolved::{Parts, sphere_triangles, torus_triangles, vertices},
    solids::{CUBE, CUBE_FACES, DODECAHEDRON, ICOSAHEDRON, OCTAHEDRON, TETRAHEDRON},
};

type Vector = [f64; 3];

fn dot(a: Vector, b: Vector) -> f64 {
    a.iter().zip(b).map(|(a, b)| a * b).sum()
}

fn minus(a: Vector, b: Vector) -> Vector {
    [a[0] - b[0], a[1] - b[1], a[2] - b[2]]
}

fn unit(v: Vector) -> Vector {
    let length = dot(v, v).sqrt();
    v.map(|v| v / length)
}

/// The normal of a triangle, twice its area long.
fn upright([a, b, c]: [Vector; 3]) -> Vector {
    let ([ax, ay, az], [bx, by, bz]) = (minus(b, a), minus(c, a));
    [ay * bz - az * by, az * bx - ax * bz, ax * by - ay * bx]
}

fn places(mesh: &Mesh, triangle: [u16; 3]) -> [Vector; 3] {
    triangle.map(|i| mesh.positions()[usize::from(i)].map(|v| f64::from(v) / 16_384.0))
}

/// Six times the volume.
fn volume(mesh: &Mesh) -> f64 {
    mesh.triangles().map(|t| dot(places(mesh, t)[0], upright(places(mesh, t)))).sum()
}

/// Every edge between two places is there once in each direction, and corners − edges + triangles is as told.
fn assert_closed(mesh: &Mesh, euler: i64) {
    let (mut edges, mut corners, mut count) = (BTreeMap::new(), BTreeSet::new(), 0_i64);
    for triangle in mesh.triangles() {
        let [a, b, c] = triangle.map(|i| mesh.positions()[usize::from(i)]);
        for edge in [(a, b), (b, c), (c, a)] {
            assert_ne!(edge.0, edge.1, "an edge without length");
            *edges.entry(edge).or_insert(0) += 1;
            corners.insert(edge.0);
        }
        count += 1;
    }
    for (&(from, to), &uses) in &edges {
        assert_eq!((uses, edges.get(&(to, from))), (1, Some(&1)), "the edge from {from:?} to {to:?}");
    }
    let sizes = [corners.len(), edges.len() / 2].map(|n| i64::try_from(n).expect("few"));
    assert_eq!(sizes[0] - sizes[1] + count, euler);
    assert!(volume(mesh) > 0.0, "inside out");
}

/// Lengths of 127 within rounding, and on the outer side of each triangle.
fn assert_normals(mesh: &Mesh, most_degrees: f64) {
    for normal in mesh.normals().iter().chain(mesh.face_normals().unwrap_or_default()) {
        let length = dot(normal.map(f64::from), normal.map(f64::from)).sqrt();
        assert!((126.0..=128.0).contains(&length), "{normal:?} has a length of {length}");
    }
    for triangle in mesh.triangles() {
        let upright = unit(upright(places(mesh, triangle)));
        for corner in triangle {
            let normal = unit(mesh.normals()[usize::from(corner)].map(f64::from));
            let degrees = dot(upright, normal).acos().to_degrees();
            assert!(degrees <= most_degrees, "{degrees} at {corner} of {triangle:?}");
        }
    }
}

#[test]
fn platonic_solids() {
    let solids = [
        (TETRAHEDRON, 4, 71.0),
        (CUBE, 12, 55.0),
        (CUBE_FACES, 12, 0.5),
        (OCTAHEDRON, 8, 55.0),
        (ICOSAHEDRON, 20, 38.0),
        (DODECAHEDRON, 12, 38.0),
    ];
    for (solid, faces, degrees) in solids {
        assert_closed(&solid, 2);
        assert_normals(&solid, degrees);
        for place in solid.positions() {
            let length = dot(place.map(f64::from), place.map(f64::from)).sqrt();
            assert!((length - 16_384.0).abs() < 1.0, "{length}");
        }
        let normals = solid.face_normals().expect("normals of faces");
        assert_eq!(normals.len(), faces);
        for face in solid.faces() {
            let exact = unit(upright(places(&solid, face.corners)));
            assert!(dot(exact, unit(normals[face.number].map(f64::from))) > 0.9999, "{face:?}");
        }
    }
    assert_eq!(DODECAHEDRON.triangles().count(), 36);
    let uv = CUBE_FACES.uv().expect("texture coordinates");
    assert!(uv.chunks(4).all(|face| face == [[0, 4096], [4096, 4096], [4096, 0], [0, 0]]));
}

static BALL: Parts<{ vertices(12, 6) }, { sphere_triangles(12, 6) }> = Parts::sphere::<12, 6>();
static RING: Parts<{ vertices(16, 8) }, { torus_triangles(16, 8) }> = Parts::torus::<16, 8>(5_000);
static CAN: Parts<{ vertices(9, 5) }, { torus_triangles(9, 2) }> = Parts::cylinder::<9>();
static CONE: Parts<{ vertices(7, 3) }, { torus_triangles(7, 1) }> = Parts::cone::<7>();
static GRID: Parts<{ vertices(4, 3) }, { torus_triangles(4, 3) }> = Parts::grid::<4, 3>();

#[test]
fn round_solids() {
    let meshes = [BALL.mesh(), RING.mesh(), CAN.mesh(), CONE.mesh()].map(|mesh| mesh.expect("few vertices"));
    for (mesh, (euler, degrees, six_volumes)) in
        meshes.iter().zip([(2, 21.0, 22.4), (0, 26.0, 6.72), (2, 21.0, 34.7), (2, 27.0, 10.95)])
    {
        assert_closed(mesh, euler);
        assert_normals(mesh, degrees);
        let volume = volume(mesh);
        assert!((volume - six_volumes).abs() < six_volumes * 0.002, "{volume}");
        let uv = mesh.uv().expect("texture coordinates");
        assert!(uv.iter().flatten().all(|v| (0..=4096).contains(v)));
    }
    // A seam: the first and the last column are at the same place with u of 0 and 1.
    let (ball, uv) = (meshes[0].positions(), meshes[0].uv().expect("texture coordinates"));
    assert_eq!((ball[13], uv[13], uv[25]), (ball[25], [0, 3413], [4096, 3413]));
}

#[test]
fn a_grid_is_flat_and_faces_up() {
    let grid = GRID.mesh().expect("few vertices");
    assert_eq!((grid.positions().len(), grid.triangles().count()), (20, 24));
    for triangle in grid.triangles() {
        let [x, y, z] = upright(places(&grid, triangle));
        assert!(x.abs() < 1e-9 && y > 0.1 && z.abs() < 1e-9);
    }
    let area: f64 = grid.triangles().map(|t| upright(places(&grid, t))[1]).sum();
    assert!((area - 8.0).abs() < 1e-9, "{area}");
    let uv = grid.uv().expect("texture coordinates");
    assert_eq!((grid.positions()[0], uv[0]), ([-16_384, 0, 16_384], [0, 4096]));
    assert_eq!((grid.positions()[19], uv[19]), ([16_384, 0, -16_384], [4096, 0]));
}
