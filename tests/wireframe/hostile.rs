//! Whatever comes in: pixels inside, or an error.

use core::fmt::Debug;

use super::*;
use aquatint::{
    BoundingSphere, ClipPlane,
    fragment::shade::Plain,
    geometry::face::Faces,
    pipeline::{DrawError, MOST_PLANES},
};
use proptest::{prelude::*, sample::select};

const VIEW: Rect = Rect::new(0, 0, 24, 16);

fn scalar() -> impl Strategy<Value = Scalar> {
    prop_oneof![
        6 => (-200_000..200_000_i32).prop_map(Scalar::from_bits),
        2 => any::<i32>().prop_map(|bits| Scalar::from_bits(bits >> 7)),
        1 => any::<i32>().prop_map(Scalar::from_bits),
        1 => select(vec![Scalar::MIN, Scalar::MAX, Scalar::ZERO, Scalar::DELTA, -Scalar::DELTA]),
    ]
}

fn matrix<A: Debug, B: Debug>() -> impl Strategy<Value = Matrix<A, B>> {
    prop::array::uniform4(prop::array::uniform4(scalar())).prop_map(Matrix::from_rows)
}

fn coordinate() -> impl Strategy<Value = i16> {
    prop_oneof![any::<i16>(), select(vec![i16::MIN, 0, i16::MAX])]
}

fn faces() -> impl Strategy<Value = Faces> {
    select(vec![Faces::Front, Faces::Back, Faces::Both])
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(2000))]
    #[test]
    fn any_mesh_under_any_matrix(
        positions in prop::collection::vec(prop::array::uniform3(coordinate()), 1..9),
        corners in prop::collection::vec(prop::array::uniform3(any::<u16>()), 0..12),
        placement in prop_oneof![matrix(), Just(Matrix::IDENTITY)],
        projection in prop_oneof![matrix(), Just(scene(VIEW).camera.projection)],
        bias in (any::<i16>(), any::<i8>()), faces in faces(),
        planes in prop::collection::vec(prop::array::uniform4(scalar()), 0..=MOST_PLANES),
    ) {
        let count = u16::try_from(positions.len()).expect("few");
        let triangles: Vec<_> = corners.iter().map(|triangle| triangle.map(|index| index % count)).collect();
        let normals = vec![[i8::MIN, 0, i8::MAX]; positions.len()];
        let mesh = Mesh::new(&positions, &normals, &triangles).expect("in range");
        let mut instance = Instance::new(mesh, placement);
        instance.material.faces = faces;
        instance.material.bias = DepthBias { constant: bias.0, slope: bias.1 };
        let planes: Vec<_> = planes.into_iter().filter_map(|plane| ClipPlane::new(plane).ok()).collect();
        let instance = instance.with_planes(&planes).with_bounds(BoundingSphere::new(Point3::ORIGIN, 400_000));
        let mut scene = scene(VIEW);
        scene.camera.projection = projection;
        // The canvas itself asserts that all is inside.
        let mut canvas = Canvas::<Light>::new(VIEW);
        let mut memory = [0_u16; 24 * 16];
        let mut depth = DepthBuffer::new(&mut memory, VIEW).expect("enough");
        let result = with_workspace(&mut depth, |workspace| draw_wireframe(&instance, &scene, workspace, &mut canvas));
        prop_assert!(matches!(result, Ok(()) | Err(DrawError::OutOfRange)));
        let faces = with_workspace(&mut depth, |workspace| draw_mesh(&instance, &scene, workspace, &mut canvas));
        prop_assert_eq!(faces, result);
        if result.is_err() {
            prop_assert!(canvas.pixels.iter().all(|pixel| pixel.0 == 0));
        }
    }
}

#[test]
fn a_short_workspace_is_an_error_before_anything_is_drawn() {
    let mut canvas = Canvas::new(VIEW);
    let mut workspace = Workspace { vertices: &mut [MeshVertex::EMPTY; 7], hidden: &mut Convex };
    let cube = Instance::new(SQUARES, turned(20.0, 20.0));
    let result = draw_wireframe(&cube, &scene(VIEW), &mut workspace, &mut canvas);
    assert_eq!(result, Err(DrawError::TooFewVertices { needed: 8 }));
    let far = Instance { placement: Matrix::translation(number(9000.0), number(0.0), number(0.0)), ..cube };
    let mut workspace = Workspace { vertices: &mut [MeshVertex::EMPTY; 8], hidden: &mut Convex };
    assert_eq!(draw_wireframe(&far, &scene(VIEW), &mut workspace, &mut canvas), Err(DrawError::OutOfRange));
    assert!(canvas.pixels.iter().all(|pixel| pixel.0 == 0));
}

#[test]
fn empty_windows_and_views_beside_the_target_draw_nothing() {
    let cube = Instance::new(SQUARES, turned(20.0, 20.0));
    for bounds in [Rect::new(0, 0, 0, 0), Rect::new(100, 100, 110, 105)] {
        assert!(edges(&cube, &scene(VIEW), bounds).pixels.iter().all(|pixel| pixel.0 == 0));
    }
}

#[test]
fn the_error_of_a_target_stops_the_picture() {
    /// Fails at the third run.
    struct Third(u32);

    impl Target for Third {
        type Color = char;
        type Error = u32;

        fn bounds(&self) -> Rect {
            VIEW
        }

        fn fill_run<const N: usize>(&mut self, _: i32, _: Range<i32>, _: [char; N]) -> Result<(), u32> {
            self.0 += 1;
            if self.0 < 3 { Ok(()) } else { Err(self.0) }
        }

        fn write_run(&mut self, _: i32, _: Range<i32>, _: impl Iterator<Item = Option<char>>) -> Result<(), u32> {
            unreachable!("lines of one colour are fills")
        }
    }

    let cube = Instance::new(SQUARES, turned(20.0, 20.0)).with_material(Material::new(Plain('#')));
    let result = with_workspace(&mut Convex, |workspace| draw_wireframe(&cube, &scene(VIEW), workspace, &mut Third(0)));
    assert_eq!(result, Err(DrawError::Target(3)));
}
