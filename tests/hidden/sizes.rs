//! The bytes that the documentation tells.

use aquatint::{
    Shade,
    fragment::shade::{Flat, Gouraud, Shading},
    hidden::{
        bsp::{Node, Piece, Split},
        object_space::{ComparedFace, PartBound},
        painter::{PieceCorner, PieceCut, SortedPiece},
        raycast,
        scanline::VisibleRun,
    },
    pipeline::{ActiveFace, ListedFace, MeshVertex, RowBucket, SceneMemory, WaitingFace},
};

#[test]
fn lists_take_what_is_told() {
    assert_eq!([size_of::<MeshVertex>(), size_of::<ListedFace>(), size_of::<Shade>()], [12; 3]);
    assert_eq!([size_of::<WaitingFace>(), size_of::<RowBucket>(), size_of::<VisibleRun>()], [16, 4, 6]);
    assert_eq!([size_of::<SortedPiece>(), size_of::<PieceCorner>(), size_of::<PieceCut>()], [20, 12, 32]);
    assert_eq!([size_of::<ComparedFace>(), size_of::<PartBound>()], [36, 40]);
    assert_eq!([size_of::<Node>(), size_of::<Piece>(), size_of::<Split>()], [10, 6, 4]);
    assert_eq!([size_of::<raycast::Node>(), size_of::<raycast::Shape>()], [16, 40]);
}

/// The face of one row is the only one that depends on the shading.
#[test]
fn an_active_face_has_about_a_hundred() {
    let sizes = [size_of::<ActiveFace<<Flat as Shading>::Face>>(), size_of::<ActiveFace<<Gouraud as Shading>::Face>>()];
    assert!(sizes.iter().all(|size| (96..=112).contains(size)), "{sizes:?}");
}

/// That of the README: some lengths are words of the machine.
#[test]
fn a_scene_of_an_icosahedron_takes_two_kilobytes() {
    let size = size_of::<SceneMemory<12, 12, 12>>();
    assert!(size <= 2_100, "{size}");
}
