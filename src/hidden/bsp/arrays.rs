//! Trees that are built while compiling.

use super::{Arena, BuildError, Choice, Node, Piece, Split, Tree, Triangles, build::beginning};

/// Arrays that own a tree, for constants: it is built while compiling, and lies in flash.
///
/// ```
/// use aquatint::hidden::bsp::{Choice, Tree, TreeArrays, Triangles};
///
/// const SHAPE: Triangles = Triangles::new(
///     &[[0, 0, 0], [16384, 0, 0], [0, 16384, 0], [0, 0, 16384]],
///     &[[0, 2, 1], [0, 1, 3], [0, 3, 2], [1, 2, 3]],
/// );
/// static ARRAYS: TreeArrays<4, 4, 0> = match TreeArrays::build(SHAPE, Choice::best_of(5)) {
///     Ok(arrays) => arrays,
///     Err(_) => panic!("too small"),
/// };
/// static TREE: Tree = ARRAYS.tree();
/// assert_eq!(TREE.nodes().len(), 4);
/// ```
#[derive(Clone, Debug)]
pub struct TreeArrays<'a, const NODES: usize, const PIECES: usize, const CUTS: usize> {
    triangles: Triangles<'a>,
    nodes: [Node; NODES],
    pieces: [Piece; PIECES],
    cuts: [Split; CUTS],
    counts: [usize; 3],
}

impl<'a, const NODES: usize, const PIECES: usize, const CUTS: usize> TreeArrays<'a, NODES, PIECES, CUTS> {
    /// Builds a tree, as [`Arena::build`] does.
    ///
    /// # Errors
    /// [`BuildError`].
    pub const fn build(triangles: Triangles<'a>, choice: Choice) -> Result<Self, BuildError> {
        let (mut nodes, mut pieces) = ([Node::EMPTY; NODES], [Piece::EMPTY; PIECES]);
        let mut cuts = [Split::EMPTY; CUTS];
        let mut arena = Arena::new(&mut nodes, &mut pieces, &mut cuts);
        match arena.fill(&triangles, choice) {
            Ok(()) => {}
            Err(error) => return Err(error),
        }
        let counts = [arena.node_count, arena.piece_count, arena.cut_count];
        Ok(Self { triangles, nodes, pieces, cuts, counts })
    }

    /// The tree.
    #[must_use]
    pub const fn tree(&self) -> Tree<'_> {
        let [nodes, pieces, cuts] = self.counts;
        Tree {
            triangles: self.triangles,
            nodes: beginning(&self.nodes, nodes),
            pieces: beginning(&self.pieces, pieces),
            cuts: beginning(&self.cuts, cuts),
        }
    }
}
