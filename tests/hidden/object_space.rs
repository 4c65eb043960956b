//! Object space: the pixels of a depth buffer of 32 bits, each given once.

use aquatint::{
    Light,
    fragment::shade::{Flat, Gouraud, Phong, Shading},
    pipeline::{DrawError, Instance, MeshVertex, ObjectSpaceMemory, draw_compared},
};
use heapless::Vec as Room;
use proptest::{prelude::*, strategy::ValueTree, test_runner::TestRunner};

use crate::{
    picture::Picture,
    scanline::by_depth,
    scenes::{self, Things, WINDOW, scene},
};

/// With room for so many faces and bounds.
fn drawn<const FACES: usize, const BOUNDS: usize>(
    things: &Things,
    shading: impl Shading<Color = Light> + Copy,
    vertices: usize,
) -> (Picture, Result<(), DrawError<core::convert::Infallible>>) {
    drawn_of::<FACES, BOUNDS>(&things.instances(shading), vertices)
}

fn drawn_of<const FACES: usize, const BOUNDS: usize>(
    instances: &[Instance<'_, impl Shading<Color = Light>>; 3],
    vertices: usize,
) -> (Picture, Result<(), DrawError<core::convert::Infallible>>) {
    let mut picture = Picture::new(WINDOW);
    let memory = ObjectSpaceMemory {
        vertices: &mut vec![MeshVertex::EMPTY; vertices],
        faces: &mut *Box::new(Room::<_, FACES>::new()),
        compared: &mut *Box::new(Room::<_, FACES>::new()),
        bounds: &mut *Box::new(Room::<_, BOUNDS>::new()),
    };
    let result = draw_compared(instances, &scene(), memory, &mut picture);
    (picture, result)
}

/// With room for anything.
pub fn compared(instances: &[Instance<'_, impl Shading<Color = Light>>; 3], vertices: usize) -> Picture {
    let (picture, result) = drawn_of::<8_000, 16_000>(instances, vertices);
    assert_eq!(result, Ok(()));
    picture
}

fn check<S: Shading<Color = Light> + Copy>(things: &Things, shading: S) -> Result<(), TestCaseError> {
    let (picture, result) = drawn::<4_000, 16_000>(things, shading, things.vertices());
    prop_assert_eq!(result, Ok(()));
    prop_assert_eq!(picture.differing(&by_depth(things, shading)), []);
    prop_assert!(picture.writes.iter().all(|&writes| writes <= 1), "each pixel once");
    Ok(())
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(300))]

    #[test]
    fn soups_are_those_of_the_depth_buffer(things in scenes::soups()) {
        check(&things, Gouraud)?;
        check(&things, Flat)?;
        check(&things, Phong)?;
    }

    /// What is told to be enough is; with less, all is drawn or nothing.
    #[test]
    fn room_is_told_before_anything_is_drawn(things in scenes::soups()) {
        let depth = by_depth(&things, Gouraud);
        let (picture, result) = drawn::<100, 6>(&things, Gouraud, things.vertices());
        match result {
            Ok(()) => prop_assert_eq!(picture.differing(&depth), []),
            Err(DrawError::TooFewBounds { needed }) => {
                prop_assert!(needed > 6 && picture.writes.iter().all(|&writes| writes == 0));
            }
            Err(error) => prop_assert!(false, "{}", error),
        }
    }
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(25))]

    #[test]
    fn solids_are_those_of_the_depth_buffer(things in scenes::solids()) {
        check(&things, Gouraud)?;
    }
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(3))]

    #[test]
    fn bunnies_are_those_of_the_depth_buffer(things in scenes::bunnies()) {
        check(&things, Gouraud)?;
    }
}

#[test]
fn too_little_room_is_told() {
    let mut runner = TestRunner::deterministic();
    let things = scenes::solids().new_tree(&mut runner).expect("a scene").current();
    let few = things.vertices() - 1;
    let (empty, result) = drawn::<1_000, 0>(&things, Gouraud, few);
    assert_eq!(result, Err(DrawError::TooFewVertices { needed: few + 1 }));
    assert_eq!(empty.writes.iter().sum::<u16>(), 0);
    let (empty, result) = drawn::<7, 0>(&things, Gouraud, few + 1);
    let Err(DrawError::TooFewFaces { needed }) = result else { panic!("{result:?}") };
    assert!(needed > 7 && needed <= things.triangles());
    assert_eq!(empty.writes.iter().sum::<u16>(), 0);
    let (empty, result) = drawn::<1_000, 0>(&things, Gouraud, few + 1);
    let Err(DrawError::TooFewBounds { needed }) = result else { panic!("{result:?}") };
    assert!(needed > 0 && needed <= 4 * things.triangles());
    assert_eq!(empty.writes.iter().sum::<u16>(), 0);
}
