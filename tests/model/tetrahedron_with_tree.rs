{
use aquatint::{hidden::bsp::{Node, Piece, Split, Tree, Triangles}, model::{assembly::Assembly, mesh::Mesh}};
const fn n(face: u16, parent: u16, front: u16, back: u16, first: u16) -> Node { Node { face, parent, front, back, first } }
const fn p(triangle: u16, cut: u16, next: u16) -> Piece { Piece { triangle, cut, next } }
const MESH: Mesh<'static> = match aquatint::model::mesh::Mesh::new(
&[[9459,9459,9459],[-9459,9459,-9459],[-9459,-9459,9459],[9459,-9459,-9459],
],
&[[73,73,73],[-73,73,-73],[-73,-73,73],[73,-73,-73],
],
&[[0,1,2],[0,2,3],[0,3,1],[2,1,3],
],
) {
    Ok(mesh) => mesh,
    Err(_) => panic!(),
}
;
const LIST: &[[u16; 3]] = match MESH.assembly() { Assembly::Triangles(list) => list, _ => panic!() };
const NODES: &[Node] = &[n(0,65535,65535,1,3),n(1,0,65535,2,2),n(2,1,65535,3,1),n(3,2,65535,65535,0),
];
const PIECES: &[Piece] = &[p(3,65535,65535),p(2,65535,65535),p(1,65535,65535),p(0,65535,65535),
];
const CUTS: &[Split] = &[];
match Tree::new(Triangles::new(MESH.positions(), LIST), NODES, PIECES, CUTS) {
    Ok(tree) => (MESH, tree),
    Err(_) => panic!(),
}
}
