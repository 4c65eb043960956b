//! The lecture's own example, 5.8.6: the first of its polygons splits the fourth into 4 and 4'.
//!
//! ```text
//!     │         │         │ 4'
//!   2 │       3 │         │
//!     │                   │
//!         ───────── 1     ┼      y ↑
//!                         │        └─▶ x
//!             ─── 5       │ 4
//!                         │
//! ```

use aquatint::{
    Point4, Scalar,
    hidden::bsp::{NONE, Split, Tree},
};

use super::shapes::{Memory, Shape};

/// Walls seen from above, each a triangle that stands; the front is on the right of its way. In 1000ths.
const WALLS: [[[i16; 2]; 2]; 5] = [
    [[500, 0], [-500, 0]],
    [[-1000, 1000], [-1000, 300]],
    [[0, 1000], [0, 500]],
    [[1000, -1000], [1000, 1000]],
    [[0, -800], [500, -600]],
];

fn walls() -> Shape {
    let wall = |[[x, y], [to_x, to_y]]: [[i16; 2]; 2]| {
        [[x, y, -900], [to_x, to_y, -900], [i16::midpoint(x, to_x), i16::midpoint(y, to_y), 900]]
            .map(|place| place.map(|v| v * 16))
    };
    Shape::of("walls", WALLS.map(wall))
}

/// The number of a polygon as the lecture writes it: the front half of a split one has a dash.
fn name(tree: &Tree<'_>, piece: u16) -> String {
    let piece = tree.pieces()[usize::from(piece)];
    let is_front = tree.cuts().get(usize::from(piece.cut)).is_some_and(Split::is_front);
    format!("{}{}", piece.triangle + 1, if is_front { "'" } else { "" })
}

/// `1[back][front]`.
fn nested(tree: &Tree<'_>, node: u16) -> String {
    if node == NONE {
        return String::new();
    }
    let node = tree.nodes()[usize::from(node)];
    format!("{}[{}][{}]", name(tree, node.first), nested(tree, node.back), nested(tree, node.front))
}

#[test]
fn the_polygons_are_split_as_in_the_lecture() {
    let (shape, mut memory) = (walls(), Memory::new([6, 6, 2]));
    let tree = memory.build(&shape, 1).expect("room");
    assert_eq!(tree.pieces().len(), 6, "the fourth is split");
    // Back of 1: 4; back of 4: 5. Front of 1: 2; back of 2: 3; back of 3: 4'.
    assert_eq!(nested(&tree, 0), "1[4[5[][]][]][2[3[4'[][]][]][]]");
}

#[test]
fn it_is_drawn_far_side_node_near_side() {
    let (shape, mut memory) = (walls(), Memory::new([6, 6, 2]));
    let tree = memory.build(&shape, 1).expect("room");
    let seen = |x: f64, y: f64, nearest_first: bool| {
        let eye = Point4::new(Scalar::from_num(x), Scalar::from_num(y), Scalar::ZERO, Scalar::ONE);
        let order = if nearest_first { tree.front_to_back(eye) } else { tree.back_to_front(eye) };
        let index = |piece| tree.pieces().iter().position(|other| core::ptr::eq(other, piece)).expect("of the list");
        order.map(|piece| name(&tree, u16::try_from(index(piece)).expect("few"))).collect::<Vec<_>>().join(" ")
    };
    assert_eq!(seen(0.2, 5.0, false), "4 5 1 2 3 4'");
    assert_eq!(seen(0.2, 5.0, true), "4' 3 2 1 5 4");
    assert_eq!(seen(5.0, -5.0, false), "2 3 4' 1 5 4");
    assert_eq!(seen(-5.0, -5.0, false), "4' 3 2 1 4 5");
}
