//! The scanline algorithm: the pixels of a depth buffer of 32 bits, each given once.

use aquatint::{
    Light, Rect,
    fragment::{
        shade::{Flat, Gouraud, Phong, Shading, Textured},
        texture::{LightTexture, Sampler},
    },
    hidden::depth::DepthBuffer,
    pipeline::{
        DrawError, Instance, MeshVertex, RowBucket, ScanlineMemory, Scanlines, SceneMemory, Workspace, draw_mesh,
        draw_scene,
    },
};
use heapless::Vec as Room;
use proptest::{prelude::*, strategy::ValueTree, test_runner::TestRunner};

use crate::{
    picture::Picture,
    scenes::{self, Things, WINDOW, scene},
};

/// All instances into one depth buffer, in their order.
pub fn by_depth<S: Shading<Color = Light> + Copy>(things: &Things, shading: S) -> Picture {
    by_depth_of(&things.instances(shading), things.vertices())
}

/// The same, of instances with at most so many vertices.
pub fn by_depth_of(instances: &[Instance<'_, impl Shading<Color = Light>>], vertices: usize) -> Picture {
    let (mut picture, mut depths) = (Picture::new(WINDOW), vec![0_u32; Picture::new(WINDOW).lights.len()]);
    let mut hidden = DepthBuffer::new(&mut depths, WINDOW).expect("large enough");
    let mut vertices = vec![MeshVertex::EMPTY; vertices];
    for instance in instances {
        let mut workspace = Workspace { vertices: &mut vertices, hidden: &mut hidden };
        draw_mesh(instance, &scene(), &mut workspace, &mut picture).expect("in range");
    }
    picture
}

/// Row by row.
pub fn by_rows_of(instances: &[Instance<'_, impl Shading<Color = Light>>; 3], vertices: usize) -> Picture {
    in_window::<_, 512>(instances, vertices, (WINDOW, 60))
}

/// The same with so many runs.
fn by_rows<S: Shading<Color = Light> + Copy, const RUNS: usize>(
    things: &Things,
    shading: S,
    window: (Rect, usize),
) -> Picture {
    in_window::<_, RUNS>(&things.instances(shading), things.vertices(), window)
}

/// The same in a window, with so many buckets.
fn in_window<S: Shading<Color = Light>, const RUNS: usize>(
    instances: &[Instance<'_, S>; 3],
    vertices: usize,
    (window, buckets): (Rect, usize),
) -> Picture {
    let (mut vertices, mut buckets) = (vec![MeshVertex::EMPTY; vertices], vec![RowBucket::EMPTY; buckets]);
    let (mut faces, mut active) = (Box::new(Room::<_, 10_000>::new()), Box::new(Room::<_, 6_000>::new()));
    let (mut order, mut runs) = (Room::<_, 6_000>::new(), Room::<_, RUNS>::new());
    let memory = ScanlineMemory {
        vertices: &mut vertices,
        faces: &mut *faces,
        buckets: &mut buckets,
        active: &mut *active,
        order: &mut order,
        runs: &mut runs,
    };
    let mut picture = Picture::new(WINDOW);
    let mut rows = Scanlines::new(window, memory);
    assert_eq!(rows.row(), None);
    rows.begin(instances, &scene()).expect("room enough");
    let mut expected = window.rows();
    while let Some(row) = rows.row() {
        assert_eq!(Some(row), expected.next());
        rows.draw_row(&mut picture).expect("in memory");
    }
    assert_eq!(expected.next(), None);
    rows.draw_row(&mut picture).expect("nothing more");
    picture
}

fn check<S: Shading<Color = Light> + Copy>(things: &Things, shading: S) -> Result<(), TestCaseError> {
    let (depth, rows) = (by_depth(things, shading), by_rows::<S, 512>(things, shading, (WINDOW, 60)));
    prop_assert_eq!(rows.differing(&depth), []);
    prop_assert!(rows.writes.iter().all(|&writes| writes <= 1), "each pixel once");
    Ok(())
}

/// A picture in stripes, so that every texel matters.
fn stripes() -> impl Shading<Color = Light> + Copy {
    static TEXELS: [Light; 64] = {
        let (mut texels, mut at) = ([Light::BLACK; 64], 0);
        while at < 64 {
            texels[at as usize] = Light(1_000 * at + 500);
            at += 1;
        }
        texels
    };
    Textured::new(Sampler::new(LightTexture::new(&TEXELS, 8, 8).expect("powers of two")), Gouraud)
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(600))]

    #[test]
    fn soups_are_those_of_the_depth_buffer(things in scenes::soups()) {
        check(&things, Gouraud)?;
        check(&things, Flat)?;
        check(&things, Phong)?;
        check(&things, stripes())?;
    }

    #[test]
    fn solids_are_those_of_the_depth_buffer(things in scenes::solids()) {
        check(&things, Gouraud)?;
        check(&things, Flat)?;
    }

    /// With one bucket for all rows, with runs for three columns, and in a window, nothing changes.
    #[test]
    fn little_room_changes_no_pixel(things in scenes::soups(), top in 2..62, left in -3..93, buckets in 1..70_usize) {
        let whole = by_rows::<_, 512>(&things, Gouraud, (WINDOW, 60));
        prop_assert_eq!(by_rows::<_, 1>(&things, Gouraud, (WINDOW, buckets)).differing(&whole), []);
        let few = by_rows::<_, 5>(&things, Gouraud, (WINDOW, 1));
        prop_assert_eq!(few.differing(&whole), []);
        let window = Rect { top, left, ..WINDOW };
        let part = by_rows::<_, 512>(&things, Gouraud, (window, buckets));
        for (column, row) in part.differing(&whole) {
            prop_assert!(row < top || column < left, "{}, {}", column, row);
        }
    }
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(40))]

    #[test]
    fn bunnies_are_those_of_the_depth_buffer(things in scenes::bunnies()) {
        check(&things, Gouraud)?;
    }
}

#[test]
fn too_little_room_is_told_before_anything_is_drawn() {
    let mut runner = TestRunner::deterministic();
    let things = scenes::solids().new_tree(&mut runner).expect("a scene").current();
    let instances = things.instances(Gouraud);
    let mut picture = Picture::new(WINDOW);
    let mut memory = SceneMemory::<8, 8, 8>::NEW;
    let few = draw_scene(&instances, &scene(), &mut memory, &mut picture).unwrap_err();
    assert_eq!(few, DrawError::TooFewVertices { needed: things.vertices() });
    let mut memory = SceneMemory::<1_000, 8, 8>::NEW;
    let Err(DrawError::TooFewFaces { needed }) = draw_scene(&instances, &scene(), &mut memory, &mut picture) else {
        panic!("faces");
    };
    assert!(needed > 8 && needed <= things.triangles());
    let mut memory = SceneMemory::<1_000, 1_000, 2>::NEW;
    let Err(DrawError::TooFewActive { needed }) = draw_scene(&instances, &scene(), &mut memory, &mut picture) else {
        panic!("active faces");
    };
    assert!(needed > 2);
    assert_eq!(picture.writes.iter().sum::<u16>(), 0);
    let mut memory = SceneMemory::<1_000, 1_000, 400>::NEW;
    draw_scene(&instances, &scene(), &mut memory, &mut picture).expect("room enough");
    assert_eq!(picture.differing(&by_depth(&things, Gouraud)), []);
}
