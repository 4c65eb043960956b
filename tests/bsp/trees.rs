//! How trees are built, what they refuse, and that no list of numbers makes a walk endless.

use std::collections::BTreeSet;

use aquatint::{
    Model, Point3, Point4, Scalar,
    hidden::{
        bsp::{BuildError, Choice, List, MOST_CUTS, NONE, Node, Piece, Split, Tree, TreeArrays, TreeError, Triangles},
        solid_bsp::SolidTree,
    },
    model::{assembly::Assembly, mesh::Mesh, revolved::Parts, solids::CUBE},
};
use proptest::prelude::*;

use super::{
    exact::Random,
    shapes::{self, LARGE, Memory, Shape},
};

fn depth(tree: &Tree<'_>) -> usize {
    let mut depths = vec![1; tree.nodes().len()];
    for (at, node) in tree.nodes().iter().enumerate().skip(1) {
        depths[at] = depths[usize::from(node.parent)] + 1;
    }
    depths.into_iter().max().unwrap_or(0)
}

fn most_cuts(tree: &Tree<'_>) -> usize {
    let count = |piece: &Piece| {
        let mut cut = piece.cut;
        core::iter::from_fn(|| {
            let split = tree.cuts().get(usize::from(cut))?;
            cut = split.before;
            Some(())
        })
        .count()
    };
    tree.pieces().iter().map(count).max().unwrap_or(0)
}

/// What the documentation says about sizes: pieces for each triangle, at most, without a tolerance and with one of two steps.
#[test]
fn meshes_take_about_twice_as_many_pieces() {
    let mut random = Random(5);
    let all = [
        (shapes::torus(28, 18), [2.2, 1.9]),
        (shapes::bunny(), [2.4, 2.3]),
        (shapes::sphere(16, 16), [1.4, 1.0]),
        (shapes::soup("soup", 100, 2500, &mut random), [3.5, 3.5]),
        (shapes::crossing(100, &mut random), [20.0, 20.0]),
    ];
    let choices = [1, 5, 20].map(Choice::best_of);
    for choice in choices.iter().flat_map(|choice| [0, 2].map(|tolerance| choice.with_tolerance(tolerance))) {
        for (shape, most) in &all {
            let mut memory = Memory::new(LARGE);
            let tree = memory.build_by(shape, choice).expect("room");
            let (count, pieces) = (shape.triangles.len(), tree.pieces().len());
            let ratio = f64::from(u32::try_from(pieces).unwrap()) / f64::from(u32::try_from(count).unwrap());
            println!(
                "{}: {count} triangles, {} nodes, {ratio:.2} pieces a triangle, {} deep, {} cuts a piece; {choice:?}",
                shape.name,
                tree.nodes().len(),
                depth(&tree),
                most_cuts(&tree)
            );
            let most = most[usize::from(choice.tolerance > 0)];
            assert!(ratio >= 1.0 && (choice.candidates == 1 || ratio <= most), "{ratio} > {most}");
            assert_eq!(tree.cuts().len(), 2 * (pieces - count), "two cuts a split");
        }
    }
}

/// One element less in any list, and it is that list which is full.
#[test]
fn lists_that_are_too_short_are_told() {
    let shape = shapes::crossing(12, &mut Random(3));
    let mut memory = Memory::new(LARGE);
    let tree = memory.build(&shape, 5).expect("room");
    let needed = [tree.nodes().len(), tree.pieces().len(), tree.cuts().len()];
    let same = (tree.nodes().to_vec(), tree.pieces().to_vec(), tree.cuts().to_vec());
    let mut memory = Memory::new(needed);
    let tree = memory.build(&shape, 5).expect("just enough");
    assert_eq!((tree.nodes().to_vec(), tree.pieces().to_vec(), tree.cuts().to_vec()), same);
    for (list, name) in [List::Nodes, List::Pieces, List::Cuts].into_iter().enumerate() {
        for less in 1..=needed[list] {
            let mut room = needed;
            room[list] -= less;
            assert_eq!(Memory::new(room).build(&shape, 5).unwrap_err(), BuildError::Full(name));
        }
    }
}

#[test]
fn a_triangle_that_is_cut_too_often_is_told() {
    // Walls one after the other, and what reaches through all of them comes last.
    let wall = |x: i16| [[x * 200, -9000, -9000], [x * 200, 9000, -9000], [x * 200, 0, 9000]];
    let long = [[-1000, 0, 0], [15_000, 10, 0], [15_000, 0, 10]];
    let of = |count: i16| Shape::of("walls", (0..count).map(wall).chain([long]));
    let most = i16::try_from(MOST_CUTS).expect("few");
    let (fits, too_many) = (of(most), of(most + 1));
    assert_eq!(Memory::new(LARGE).build(&fits, 1).expect("as often as it goes").pieces().len(), 2 * MOST_CUTS + 1);
    let triangle = u16::try_from(MOST_CUTS + 1).expect("few");
    assert_eq!(Memory::new(LARGE).build(&too_many, 1).unwrap_err(), BuildError::TooManyCuts { triangle });
    assert!(Memory::new(LARGE).build(&too_many, 20).is_ok(), "cut in halves, it is cut less often");
}

#[test]
fn planes_that_split_least_are_taken_then_those_that_halve() {
    // Parallel walls: none splits another.
    let wall = |x: i16| [[x * 200, 0, 0], [x * 200, 9000, 0], [x * 200, 0, 9000]];
    let walls = Shape::of("walls", (0..15).map(wall));
    let depth_of = |candidates: usize| depth(&Memory::new(LARGE).build(&walls, candidates).expect("room"));
    assert_eq!([1, 15].map(depth_of), [15, 4]);
    // The first wall is crossed by all others, which are parallel.
    let across = [[-900, 1000, 1000], [9000, 1000, 1000], [-900, 1000, 1500]];
    let crossed = Shape::of("crossed", [across].into_iter().chain((0..7).map(wall)));
    let pieces_of = |candidates: usize| Memory::new(LARGE).build(&crossed, candidates).expect("room").pieces().len();
    assert_eq!([0, 1, 8].map(pieces_of), [15, 15, 15], "a crossing is a split of either");
    let root = |candidates: usize| Memory::new(LARGE).build(&crossed, candidates).expect("room").nodes()[0].face;
    assert_eq!([1, 8].map(root), [0, 4], "the middle one splits one, the first splits seven");
}

#[test]
fn what_lies_in_one_plane_is_one_node_the_first_drawn_last() {
    let square =
        [[[0, 0, 5], [9, 0, 5], [9, 9, 5]], [[0, 0, 5], [9, 9, 5], [0, 9, 5]], [[0, 0, 5], [0, 9, 5], [9, 0, 5]]];
    let shape = Shape::of("square", square.into_iter().chain([[[0, 0, 0]; 3], [[0, 0, 0], [1, 1, 1], [2, 2, 2]]]));
    let mut memory = Memory::new([1, 3, 0]);
    let tree = memory.build(&shape, 5).expect("without area they take no room");
    for z in [-9, 0, 9] {
        let eye = Point4::new(Scalar::ZERO, Scalar::ZERO, Scalar::from_num(z), Scalar::ONE);
        assert!(tree.back_to_front(eye).map(|piece| piece.triangle).eq([2, 1, 0]));
    }
}

#[test]
fn nothing_has_an_empty_tree() {
    let (shape, mut memory) = (Shape::default(), Memory::new([0; 3]));
    let tree = memory.build(&shape, 5).expect("nothing needs no room");
    assert_eq!(tree.back_to_front(Point4::new(Scalar::ONE, Scalar::ONE, Scalar::ONE, Scalar::ONE)).count(), 0);
}

const fn list_of<'a>(mesh: &Mesh<'a>) -> Triangles<'a> {
    match mesh.assembly() {
        Assembly::Triangles(list) => Triangles::new(mesh.positions(), list),
        _ => panic!("no list"),
    }
}

const RING: Parts<45, 64> = Parts::torus::<8, 4>(16_000);
const RING_MESH: Mesh<'static> = match RING.mesh() {
    Ok(mesh) => mesh,
    Err(_) => panic!("a mesh"),
};
static CUBE_ARRAYS: TreeArrays<'_, 12, 12, 0> = match TreeArrays::build(list_of(&CUBE), Choice::best_of(12)) {
    Ok(arrays) => arrays,
    Err(_) => panic!("too small"),
};
static CUBE_TREE: Tree<'_> = CUBE_ARRAYS.tree();
static RING_ARRAYS: TreeArrays<'_, 160, 160, 200> = match TreeArrays::build(list_of(&RING_MESH), Choice::best_of(5)) {
    Ok(arrays) => arrays,
    Err(_) => panic!("too small"),
};
static RING_TREE: Tree<'_> = RING_ARRAYS.tree();

#[test]
fn trees_that_the_compiler_has_built_are_those_of_run_time() {
    for (tree, candidates) in [(&CUBE_TREE, 12), (&RING_TREE, 5)] {
        let mut memory = Memory::new(LARGE);
        let built = memory.arena().build(tree.triangles(), Choice::best_of(candidates)).expect("room");
        assert_eq!(tree.nodes(), built.nodes());
        assert_eq!(tree.pieces(), built.pieces());
        assert_eq!(tree.cuts(), built.cuts());
    }
    assert!(CUBE_TREE.pieces().len() == 12 && !RING_TREE.cuts().is_empty());
}

fn eye() -> impl Strategy<Value = Point4<Model>> {
    let number = || prop_oneof![any::<i32>(), -200_000..200_000, Just(i32::MIN), Just(i32::MAX), Just(0)];
    let w = prop_oneof![Just(0), Just(65_536), Just(-65_536), any::<i32>()];
    (number(), number(), number(), w).prop_map(|(x, y, z, w)| {
        let [x, y, z, w] = [x, y, z, w].map(Scalar::from_bits);
        Point4::new(x, y, z, w)
    })
}

fn corner() -> impl Strategy<Value = [i16; 3]> {
    prop::array::uniform3(prop_oneof![any::<i16>(), -3..3_i16, Just(i16::MIN), Just(i16::MAX)])
}

fn link(most: u16) -> impl Strategy<Value = u16> {
    prop_oneof![3 => 0..most, 2 => Just(NONE), 1 => any::<u16>()]
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(2000))]

    /// Triangles of any numbers: a tree or an error; from any eye each piece comes once, the second order is the first
    /// backwards.
    #[test]
    fn any_triangles_have_a_tree(
        triangles in prop::collection::vec(prop::array::uniform3(corner()), 0..12), candidates in 0..9_usize, eye in eye(),
    ) {
        let (shape, mut memory) = (Shape::of("any", triangles), Memory::new([400; 3]));
        let Ok(tree) = memory.build(&shape, candidates) else { return Ok(()) };
        let order: Vec<_> = tree.back_to_front(eye).collect();
        prop_assert_eq!(order.len(), tree.pieces().len());
        let shown: BTreeSet<_> = order.iter().map(|piece| piece.triangle).collect();
        for triangle in 0..shape.list().count() {
            let flat = Shape::of("one", [shape.corners(triangle)]);
            let has_area = Memory::new([1, 1, 0]).build(&flat, 1).is_ok_and(|tree| !tree.nodes().is_empty());
            prop_assert_eq!(shown.contains(&u16::try_from(triangle).expect("few")), has_area);
        }
        let mut nearest_first: Vec<_> = tree.front_to_back(eye).map(core::ptr::from_ref).collect();
        nearest_first.sort_unstable();
        let mut farthest_first: Vec<_> = order.into_iter().map(core::ptr::from_ref).collect();
        farthest_first.sort_unstable();
        prop_assert_eq!(&nearest_first, &farthest_first);
        nearest_first.dedup();
        prop_assert_eq!(nearest_first.len(), farthest_first.len());
    }

    /// Lists of any numbers: refused, or walks end.
    #[test]
    fn any_lists_are_refused_or_are_walked(
        nodes in prop::collection::vec((0..3_u16, link(5), link(5), link(5), link(5)), 0..5),
        pieces in prop::collection::vec((0..3_u16, link(4), link(4)), 0..4),
        cuts in prop::collection::vec((any::<bool>(), link(4), link(4)), 0..4), eye in eye(),
    ) {
        let shape = shapes::crossing(3, &mut Random(8));
        let nodes: Vec<_> = nodes
            .into_iter()
            .map(|(face, parent, front, back, first)| Node { face, parent, front, back, first })
            .collect();
        let pieces: Vec<_> = pieces.into_iter().map(|(triangle, cut, next)| Piece { triangle, cut, next }).collect();
        let cuts: Vec<_> = cuts
            .into_iter()
            .map(|(is_back, node, before)| Split { side: node | u16::from(is_back) << 15, before })
            .collect();
        if let Ok(tree) = Tree::new(shape.list(), &nodes, &pieces, &cuts) {
            prop_assert!(tree.back_to_front(eye).count() <= pieces.len());
            let solid = SolidTree::new(tree);
            let [a, b] = [Point3::new(eye.x, eye.y, eye.z), Point3::ORIGIN];
            let _ = (solid.place(a), solid.first_hit(a, b));
        }
    }
}

/// Each way to be wrong by one link.
#[test]
fn wrong_links_are_told() {
    let shape = shapes::crossing(6, &mut Random(4));
    let mut memory = Memory::new(LARGE);
    let tree = memory.build(&shape, 1).expect("room");
    let (nodes, pieces, cuts) = (tree.nodes().to_vec(), tree.pieces().to_vec(), tree.cuts().to_vec());
    let with_node = |at: usize, node: Node| {
        let mut nodes = nodes.clone();
        nodes[at] = node;
        Tree::new(shape.list(), &nodes, &pieces, &cuts).unwrap_err()
    };
    let last = u16::try_from(nodes.len() - 1).expect("few");
    assert_eq!(with_node(0, Node { front: 0, ..nodes[0] }), TreeError::Node(0), "its own child");
    assert_eq!(with_node(0, Node { front: last + 1, ..nodes[0] }), TreeError::Node(0), "no node");
    assert_eq!(with_node(0, Node { front: last, ..nodes[0] }), TreeError::Node(0), "another's child");
    assert_eq!(with_node(0, Node { back: nodes[0].front, ..nodes[0] }), TreeError::Node(0), "twins");
    assert_eq!(with_node(0, Node { face: 6, ..nodes[0] }), TreeError::Node(0), "no triangle");
    assert_eq!(with_node(0, Node { first: NONE, ..nodes[0] }), TreeError::PieceLists, "a piece is lost");
    let with_piece = |piece: Piece| {
        let mut pieces = pieces.clone();
        pieces[2] = piece;
        Tree::new(shape.list(), &nodes, &pieces, &cuts).unwrap_err()
    };
    assert_eq!(with_piece(Piece { triangle: 6, ..pieces[2] }), TreeError::Piece(2));
    assert_eq!(with_piece(Piece { cut: 60_000, ..pieces[2] }), TreeError::Piece(2));
    assert_eq!(with_piece(Piece { next: 2, ..pieces[2] }), TreeError::PieceLists, "endless");
    let with_cut = |cut: Split| {
        let mut cuts = cuts.clone();
        cuts[1] = cut;
        Tree::new(shape.list(), &nodes, &pieces, &cuts).unwrap_err()
    };
    assert_eq!(with_cut(Split { before: 1, ..cuts[1] }), TreeError::Cut(1), "endless");
    assert_eq!(with_cut(Split { side: last + 1, ..cuts[1] }), TreeError::Cut(1));
}
