//! One scene, every method: one picture.
//!
//! Three meshes become one, as a tree needs it, and each face gets a number for its light. Row by row and in object space it is
//! the picture of a depth buffer of 32 bits to the pixel; sorted by depth and by a tree it may differ where two faces are at
//! the same depth, as nearly as numbers are rounded. Rays, which know no rounded corners, are compared in `tests/raycast/`.

use aquatint::{
    Light,
    hidden::{
        bsp::{Arena, Choice, Node, Piece, Split, Triangles},
        convex::Convex,
    },
    pipeline::{MeshVertex, TreeInstance, Workspace, draw_tree},
};
use proptest::prelude::*;

use crate::{
    numbered::{apart, instances},
    object_space, painter,
    picture::Picture,
    scanline::{by_depth_of, by_rows_of},
    scenes::{self, Thing, Things, WINDOW, scene},
};

/// The faces of all things as one mesh, where the first one stands.
fn merged(things: &Things) -> Things {
    let [first, others @ ..] = &things.things;
    let mut all = first.clone();
    for thing in others {
        let before = u16::try_from(all.positions.len()).expect("few");
        all.positions.extend(&thing.positions);
        all.normals.extend(&thing.normals);
        all.triangles.extend(thing.triangles.iter().map(|corners| corners.map(|corner| corner + before)));
    }
    let nothing = || Thing { positions: vec![], normals: vec![], triangles: vec![], placement: first.placement };
    Things { things: [all, nothing(), nothing()], faces: things.faces }
}

fn by_tree(things: &Things) -> Picture {
    let ([thing, ..], [instance, ..]) = (&things.things, instances(things));
    let room = 64 * (thing.triangles.len() + 1);
    let (mut nodes, mut pieces, mut cuts) =
        (vec![Node::EMPTY; room], vec![Piece::EMPTY; room], vec![Split::EMPTY; room]);
    let arena = Arena::new(&mut nodes, &mut pieces, &mut cuts);
    let tree =
        arena.build(Triangles::new(&thing.positions, &thing.triangles), Choice::best_of(5)).expect("room enough");
    let (mut picture, mut vertices) = (Picture::new(WINDOW), vec![MeshVertex::EMPTY; thing.positions.len()]);
    let mut workspace = Workspace { vertices: &mut vertices, hidden: &mut Convex };
    draw_tree(&TreeInstance { instance, tree }, &scene(), &mut workspace, &mut picture).expect("in range");
    picture
}

/// A scene of one mesh.
fn check(things: &Things) -> Result<(), TestCaseError> {
    let things = apart(things);
    let (instances, vertices) = (instances(&things), things.vertices());
    let depth = by_depth_of(&instances, vertices);
    prop_assert_eq!(by_rows_of(&instances, vertices).differing(&depth), []);
    prop_assert_eq!(object_space::compared(&instances, vertices).differing(&depth), []);
    painter::check_ties(&things, &painter::sorted_of(&instances, vertices), &depth)?;
    painter::check_ties(&things, &by_tree(&things), &depth)?;
    prop_assert!(depth.lights.iter().all(|&Light(number)| number > 0));
    Ok(())
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(200))]

    #[test]
    fn soups_in_every_way(things in scenes::soups()) {
        check(&merged(&things))?;
    }

    #[test]
    fn solids_in_every_way(things in scenes::solids()) {
        check(&merged(&things))?;
    }
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(4))]

    #[test]
    fn bunnies_in_every_way(mut things in scenes::bunnies()) {
        // Alone: faces as large as those of a cube would be cut by it too often.
        let [_, others @ ..] = &mut things.things;
        for thing in others {
            thing.triangles.clear();
        }
        check(&things)?;
    }
}
