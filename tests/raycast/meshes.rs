//! Meshes as shapes.

use aquatint::{
    Matrix, Model, Point3, Scalar, World,
    hidden::raycast::{REACH, Shape, Triangle},
    model::{mesh::Mesh, solids::CUBE},
    pipeline::{Instance, MeshShapesError, mesh_shapes},
};

/// The triangles of a placed mesh, and where their corners are, in 2⁻¹⁶.
pub fn shapes_of(mesh: Mesh<'_>, placement: Matrix<Model, World>) -> (Vec<Shape>, Vec<[[i32; 3]; 3]>) {
    let mut shapes = vec![Shape::NOTHING; mesh.triangles().count()];
    mesh_shapes(&Instance::new(mesh, placement), &mut shapes).expect("in range");
    let corner = |index: u16| {
        let [x, y, z] = mesh.positions()[usize::from(index)].map(|v| Scalar::from_bits(i32::from(v) * 4));
        let p = placement.transform_point(Point3::new(x, y, z));
        [p.x, p.y, p.z].map(Scalar::to_bits)
    };
    (shapes, mesh.triangles().map(|triangle| triangle.map(corner)).collect())
}

#[test]
fn each_triangle_is_a_shape() {
    let (shapes, corners) = shapes_of(CUBE, Matrix::translation(Scalar::ONE, Scalar::ZERO, Scalar::ZERO));
    assert_eq!(shapes.len(), 12);
    for (shape, corners) in shapes.iter().zip(corners) {
        let corners = corners.map(|place| {
            let [x, y, z] = place.map(Scalar::from_bits);
            Point3::new(x, y, z)
        });
        assert_eq!(*shape, Shape::Triangle(Triangle::new(corners).expect("in range")));
    }
}

#[test]
fn meshes_that_do_not_fit_are_refused() {
    let cube = Instance::new(CUBE, Matrix::IDENTITY);
    let mut shapes = [Shape::NOTHING; 13];
    assert_eq!(mesh_shapes(&cube, &mut shapes[..11]), Err(MeshShapesError::TooFewShapes { needed: 12 }));
    assert_eq!(mesh_shapes(&cube, &mut shapes), Ok(12));
    assert_eq!(shapes[12], Shape::NOTHING);
    let far = Instance::new(CUBE, Matrix::translation(REACH, Scalar::ZERO, Scalar::ZERO));
    assert_eq!(mesh_shapes(&far, &mut shapes), Err(MeshShapesError::OutOfRange));
}
