//! Depth sort: the pixels of a depth buffer, but where two faces are at almost the same depth.

use core::convert::Infallible;

use aquatint::{
    Clip, Light, Matrix, Model, Scalar,
    fragment::shade::Shading,
    geometry::{face::Faces, transform::MeshTransform},
    hidden::convex::Convex,
    pipeline::{DepthSortMemory, DrawError, Instance, MeshVertex, Workspace, draw_mesh, draw_sorted},
};
use heapless::Vec as Room;
use proptest::{prelude::*, strategy::ValueTree, test_runner::TestRunner};

use crate::{
    numbered::{apart, face_of, instances},
    picture::{GROUND, Picture},
    scanline::by_depth_of,
    scenes::{self, Thing, Things, WINDOW, scene},
};

/// With room for so many pieces, corners and cuts.
fn sorted<const PIECES: usize, const CORNERS: usize, const CUTS: usize>(
    instances: &[Instance<'_, impl Shading<Color = Light>>; 3],
    vertices: usize,
) -> (Picture, Result<(), DrawError<Infallible>>) {
    let mut picture = Picture::new(WINDOW);
    let memory = DepthSortMemory {
        vertices: &mut vec![MeshVertex::EMPTY; vertices],
        faces: &mut *Box::new(Room::<_, PIECES>::new()),
        pieces: &mut *Box::new(Room::<_, PIECES>::new()),
        corners: &mut *Box::new(Room::<_, CORNERS>::new()),
        cuts: &mut *Box::new(Room::<_, CUTS>::new()),
    };
    let result = draw_sorted(instances, &scene(), memory, &mut picture);
    (picture, result)
}

/// The depth of a face along the screen, in 24 bits, in floating point: what is added a pixel to the right, a pixel down, the
/// depth in the corner of the screen, and how much it changes over the face.
struct Depth {
    across: f64,
    down: f64,
    origin: f64,
    range: f64,
}

impl Depth {
    fn of(thing: &Thing, face: usize) -> Self {
        let to_clip = thing.placement.then(&scene().camera.view).then(&scene().camera.projection);
        let transform = MeshTransform::new(&to_clip).expect("in range");
        let corners = thing.triangles[face].map(|corner| {
            let point: aquatint::Point4<Clip> = transform.apply(thing.positions[usize::from(corner)]);
            let [x, y, z, w] = [point.x, point.y, point.z, point.w].map(|v| v.to_num::<f64>());
            let (width, height) = (f64::from(WINDOW.width()), f64::from(WINDOW.height()));
            let [left, top] = [WINDOW.left, WINDOW.top].map(f64::from);
            let place = [left * w + f64::midpoint(w, x) * width, top * w + (w - y) / 2.0 * height, w];
            (place, (w - z) / 2.0 * 16_777_216.0)
        });
        let [a, b, c] = corners.map(|(place, _)| place);
        let cross = |[a, b, c]: [f64; 3], [d, e, f]: [f64; 3]| [b * f - c * e, c * d - a * f, a * e - b * d];
        let volume = a.iter().zip(cross(b, c)).map(|(a, b)| a * b).sum::<f64>();
        let sides = [cross(b, c), cross(c, a), cross(a, b)];
        let along = |axis: usize| sides.iter().zip(&corners).map(|(side, (_, d))| side[axis] * d).sum::<f64>() / volume;
        let depths =
            corners.map(|([_, _, w], d)| if w > 0.1 { (d / w).clamp(0.0, 16_777_216.0) } else { 16_777_216.0 });
        let range = depths.iter().fold(0.0, |most: f64, d| most.max(*d))
            - depths.iter().fold(f64::MAX, |least, d| least.min(*d));
        Self { across: along(0), down: along(1), origin: along(2), range }
    }

    fn at(&self, column: i32, row: i32) -> f64 {
        self.origin + self.across * (f64::from(column) + 0.5) + self.down * (f64::from(row) + 0.5)
    }

    /// Four units of 22 bits, an eighth of a pixel's worth, and as much as planes of depth are rounded.
    fn tolerance(&self) -> f64 {
        16.0 + (self.across.abs() + self.down.abs()) / 8.0 + self.range / 4096.0
    }
}

fn check(things: &Things) -> Result<(), TestCaseError> {
    let things = apart(things);
    let (instances, vertices) = (instances(&things), things.vertices());
    let picture = sorted_of(&instances, vertices);
    check_ties(&things, &picture, &by_depth_of(&instances, vertices))?;
    // Pieces of a face are the face: its pixels are given as often as without splits.
    prop_assert_eq!(picture.writes, all_faces(&instances, things.vertices()).writes);
    Ok(())
}

/// Two pictures of numbered faces may differ where two of them are at the same depth.
pub fn check_ties(things: &Things, picture: &Picture, depth: &Picture) -> Result<(), TestCaseError> {
    let mut wrong = 0;
    for (column, row) in picture.differing(depth) {
        let [own, other] = [picture, depth].map(|picture| picture.at(row, column));
        prop_assert!(own != GROUND && other != GROUND, "{} {} {:?} {:?}", column, row, own, other);
        let [own, other] = [own, other].map(|Light(number)| {
            let (thing, face) = face_of(things, number);
            Depth::of(thing, face)
        });
        let difference = (own.at(column, row) - other.at(column, row)).abs();
        wrong += usize::from(difference > own.tolerance() + other.tolerance());
    }
    // Once in some ten thousand scenes, beside a split between faces almost in one plane.
    prop_assert!(wrong <= 1, "{} pixels", wrong);
    Ok(())
}

/// With room for anything.
pub fn sorted_of(instances: &[Instance<'_, impl Shading<Color = Light>>; 3], vertices: usize) -> Picture {
    let (picture, result) = sorted::<20_000, 65_000, 20_000>(instances, vertices);
    assert_eq!(result, Ok(()));
    picture
}

/// All faces as they come.
fn all_faces(instances: &[Instance<'_, impl Shading<Color = Light>>; 3], vertices: usize) -> Picture {
    let (mut picture, mut vertices) = (Picture::new(WINDOW), vec![MeshVertex::EMPTY; vertices]);
    for instance in instances {
        let mut workspace = Workspace { vertices: &mut vertices, hidden: &mut Convex };
        draw_mesh(instance, &scene(), &mut workspace, &mut picture).expect("in range");
    }
    picture
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(300))]

    #[test]
    fn soups_are_those_of_the_depth_buffer(things in scenes::soups()) {
        check(&things)?;
    }

    /// With little room all is drawn or nothing.
    #[test]
    fn too_many_splits_are_told_before_anything_is_drawn(things in scenes::soups()) {
        let (things, vertices) = (apart(&things), things.triangles() * 3);
        let instances = instances(&things);
        let (all, _) = sorted::<10_000, 65_000, 10_000>(&instances, vertices);
        for (picture, result) in [
            sorted::<32, 65_000, 10_000>(&instances, vertices),
            sorted::<10_000, 120, 10_000>(&instances, vertices),
            sorted::<10_000, 65_000, 7>(&instances, vertices),
        ] {
            match result {
                Ok(()) => prop_assert_eq!(picture.differing(&all), []),
                Err(DrawError::TooFewPieces) => prop_assert!(picture.writes.iter().all(|&writes| writes == 0)),
                Err(error) => prop_assert!(false, "{}", error),
            }
        }
    }
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(25))]

    #[test]
    fn solids_are_those_of_the_depth_buffer(things in scenes::solids()) {
        check(&things)?;
    }
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(4))]

    #[test]
    fn bunnies_are_those_of_the_depth_buffer(things in scenes::bunnies()) {
        check(&things)?;
    }
}

/// A square of two faces, 2 × `half` wide, at a distance; in one plane with others of the same distance.
fn square(half: i16, distance: i32, aside: i32) -> Thing {
    let corners = [[-half, -half, 0], [half, -half, 0], [half, half, 0], [-half, half, 0]];
    let [x, z] = [aside, -distance].map(Scalar::from_bits);
    Thing {
        positions: corners.to_vec(),
        normals: vec![[0, 0, 127]; 4],
        triangles: vec![[0, 1, 2], [0, 2, 3]],
        placement: Matrix::translation(x, Scalar::ZERO, z),
    }
}

/// Faces in one plane: the earlier one is seen, to the pixel, in whatever order they come.
#[test]
fn of_faces_in_one_plane_the_earlier_one_is_seen() {
    for sizes in [[9_000, 12_000, 15_000], [15_000, 12_000, 9_000], [12_000, 12_000, 12_000], [12_000, 15_000, 9_000]] {
        for aside in [0, 9_000] {
            let mut place = -aside;
            let things = sizes.map(|half| {
                place += aside;
                square(half, 0x2_8000, place)
            });
            let things = apart(&Things { things, faces: Faces::Both });
            let instances = instances(&things);
            let (picture, result) = sorted::<20, 100, 20>(&instances, things.vertices());
            assert_eq!(result, Ok(()));
            let depth = by_depth_of(&instances, things.vertices());
            assert_eq!(picture.differing(&depth), [], "{sizes:?} {aside}");
            assert!(depth.writes.iter().any(|&writes| writes > 0));
        }
    }
}

/// Any numbers at all: nothing panics, and if it is drawn, each face fills its pixels.
#[test]
fn any_numbers_are_drawn_or_refused() {
    let ends = [i16::MIN, -1, 0, 1, i16::MAX];
    let positions: Vec<_> =
        ends.into_iter().flat_map(|x| ends.into_iter().flat_map(move |y| ends.map(|z| [x, y, z]))).collect();
    let count = positions.len();
    for (step, scale, z) in
        [(1, 1 << 16, -0x8000), (7, 1 << 17, -0x1_0000), (31, 3 << 16, 0), (43, 1, -0x8000), (11, 0, 0)]
    {
        let corner = |at: usize| u16::try_from(at * step % count).expect("few");
        let thing = Thing {
            positions: positions.clone(),
            normals: vec![[0, 0, -128]; count],
            triangles: (0..24).map(|face| [corner(3 * face), corner(3 * face + 1), corner(5 * face + 2)]).collect(),
            placement: Matrix::<Model, Model>::scale(Scalar::from_bits(scale)).then(&Matrix::translation(
                Scalar::ZERO,
                Scalar::ZERO,
                Scalar::from_bits(z),
            )),
        };
        let things = Things { things: [thing.clone(), thing.clone(), thing], faces: Faces::Both };
        check(&things).expect("as the depth buffer");
    }
}

#[test]
fn too_little_room_is_told() {
    let mut runner = TestRunner::deterministic();
    let things = apart(&scenes::solids().new_tree(&mut runner).expect("a scene").current());
    let instances = instances(&things);
    let (empty, result) = sorted::<1_000, 3_000, 0>(&instances, things.vertices() - 1);
    assert_eq!(result, Err(DrawError::TooFewVertices { needed: things.vertices() }));
    assert_eq!(empty.writes.iter().sum::<u16>(), 0);
    for (empty, result) in
        [sorted::<7, 3_000, 0>(&instances, things.vertices()), sorted::<1_000, 23, 0>(&instances, things.vertices())]
    {
        let Err(DrawError::TooFewFaces { needed }) = result else { panic!("{result:?}") };
        assert!(needed > 7 && needed <= things.triangles());
        assert_eq!(empty.writes.iter().sum::<u16>(), 0);
    }
}
