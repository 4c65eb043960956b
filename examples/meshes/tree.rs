//! The BSP tree of a mesh, to Rust.

use aquatint::{
    hidden::bsp::{Arena, Choice, Node, Piece, Split, Triangles},
    model::mesh::Mesh,
};

/// What makes a cut.
const SPLIT: &str = "const fn c(side: u16, before: u16) -> Split { Split { side, before } }\n";

/// An expression of type `(Mesh<'static>, Tree<'static>)`, checked by the compiler that includes it.
pub fn source(mesh: &Mesh, mesh_source: &str) -> Result<String, String> {
    let triangles: Vec<_> = mesh.triangles().collect();
    let (mut nodes, mut pieces) = (vec![Node::EMPTY; 32_768], vec![Piece::EMPTY; 65_535]);
    let mut cuts = vec![Split::EMPTY; 65_535];
    let arena = Arena::new(&mut nodes, &mut pieces, &mut cuts);
    let tree = arena.build(Triangles::new(mesh.positions(), &triangles), Choice::best_of(20));
    let tree = tree.map_err(|error| format!("has no tree: {error}"))?;
    let nodes =
        tree.nodes().iter().map(|&Node { face, parent, front, back, first }| [face, parent, front, back, first]);
    let pieces = tree.pieces().iter().map(|&Piece { triangle, cut, next }| [triangle, cut, next]);
    let cuts = tree.cuts().iter().map(|&Split { side, before }| [side, before]);
    let (nodes, pieces, cuts) = (calls('n', nodes), calls('p', pieces), calls('c', cuts));
    // Without cuts nothing would call it.
    let split = if cuts.is_empty() { "" } else { SPLIT };
    Ok(format!(
        "{{
use aquatint::{{hidden::bsp::{{Node, Piece, Split, Tree, Triangles}}, model::{{assembly::Assembly, mesh::Mesh}}}};
const fn n(face: u16, parent: u16, front: u16, back: u16, first: u16) -> Node {{ Node {{ face, parent, front, back, first }} }}
const fn p(triangle: u16, cut: u16, next: u16) -> Piece {{ Piece {{ triangle, cut, next }} }}
{split}const MESH: Mesh<'static> = {mesh_source};
const LIST: &[[u16; 3]] = match MESH.assembly() {{ Assembly::Triangles(list) => list, _ => panic!() }};
const NODES: &[Node] = &[{nodes}];
const PIECES: &[Piece] = &[{pieces}];
const CUTS: &[Split] = &[{cuts}];
match Tree::new(Triangles::new(MESH.positions(), LIST), NODES, PIECES, CUTS) {{
    Ok(tree) => (MESH, tree),
    Err(_) => panic!(),
}}
}}
"
    ))
}

/// Calls of a function, eight a line.
fn calls<const N: usize>(name: char, all: impl Iterator<Item = [u16; N]>) -> String {
    let call = |numbers: [u16; N]| name.to_string() + &format!("({numbers:?}),").replace([' ', '[', ']'], "");
    let all: Vec<_> = all.map(call).collect();
    all.chunks(8).map(|line| line.concat() + "\n").collect()
}
