//! Ways through a tree, by the links to parents: no recursion, no stack.

use super::{NONE, Node, Piece, Tree};
use crate::space::{Model, Point4};

/// What is visited of a node, and in which order: one side, then the node, then the other.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Plan {
    pub(crate) front_is_first: bool,
    /// Whether something is visited on the first and on the second side.
    pub(crate) first: bool,
    pub(crate) second: bool,
}

/// A walk through the nodes that are planned, each after its first side.
///
/// A node is asked for its plan when it is reached. The last 32 plans are remembered on the way down; only below that are
/// nodes asked once more on the way up.
#[derive(Clone, Debug)]
pub(crate) struct Walk<'t> {
    nodes: &'t [Node],
    here: u16,
    step: Step,
    /// Two bits a node, of the nodes above.
    plans: u64,
    known: u32,
}

#[derive(Clone, Copy, Debug)]
enum Step {
    /// A node has been reached from above.
    Arrive,
    /// A node has been given; perhaps its second side is next.
    Given { front_is_first: bool, second: bool },
    /// All of a node has been visited.
    Leave,
}

impl<'t> Walk<'t> {
    pub(super) const fn new(nodes: &'t [Node]) -> Self {
        let here = if nodes.is_empty() { NONE } else { 0 };
        Self { nodes, here, step: Step::Arrive, plans: 0, known: 0 }
    }

    /// Leaves out the second side of the node that was given last.
    pub(crate) fn leave(&mut self) {
        if let Step::Given { .. } = self.step {
            self.step = Step::Leave;
        }
    }

    /// The next node.
    pub(crate) fn next(&mut self, plan: &impl Fn(&Node) -> Plan) -> Option<&'t Node> {
        loop {
            let node = self.nodes.get(usize::from(self.here))?;
            match self.step {
                Step::Arrive => {
                    let plan = plan(node);
                    let first = node.child(plan.front_is_first);
                    if plan.first && first != NONE {
                        self.descend(first, plan);
                    } else {
                        return Some(self.given(node, plan));
                    }
                }
                Step::Given { front_is_first, second } => {
                    let child = node.child(!front_is_first);
                    if second && child != NONE {
                        self.descend(child, Plan { front_is_first, first: true, second });
                    } else {
                        self.step = Step::Leave;
                    }
                }
                Step::Leave => {
                    let parent = self.nodes.get(usize::from(node.parent))?;
                    let was_front = parent.front == self.here;
                    let plan = self.recalled().unwrap_or_else(|| plan(parent));
                    self.here = node.parent;
                    if plan.front_is_first == was_front {
                        return Some(self.given(parent, plan));
                    }
                }
            }
        }
    }

    fn given(&mut self, node: &'t Node, plan: Plan) -> &'t Node {
        let Plan { front_is_first, second, .. } = plan;
        self.step = Step::Given { front_is_first, second };
        node
    }

    fn descend(&mut self, child: u16, plan: Plan) {
        self.plans = self.plans << 2 | u64::from(plan.front_is_first) << 1 | u64::from(plan.second);
        self.known = (self.known + 1).min(u64::BITS / 2);
        (self.here, self.step) = (child, Step::Arrive);
    }

    /// The plan of the node above.
    fn recalled(&mut self) -> Option<Plan> {
        self.known = self.known.checked_sub(1)?;
        let plan = Plan { front_is_first: self.plans & 2 != 0, first: true, second: self.plans & 1 != 0 };
        self.plans >>= 2;
        Some(plan)
    }
}

/// The pieces of a tree in the order in which an eye sees them: see [`Tree::back_to_front`].
#[derive(Clone, Debug)]
pub struct Ordered<'t> {
    tree: Tree<'t>,
    walk: Walk<'t>,
    eye: Point4<Model>,
    nearest_first: bool,
    /// Of those in the plane of the node.
    piece: u16,
}

impl<'t> Ordered<'t> {
    pub(super) const fn new(tree: Tree<'t>, eye: Point4<Model>, nearest_first: bool) -> Self {
        Self { tree, walk: Walk::new(tree.nodes), eye, nearest_first, piece: NONE }
    }
}

impl<'t> Iterator for Ordered<'t> {
    type Item = &'t Piece;

    fn next(&mut self) -> Option<&'t Piece> {
        let Self { tree, walk, eye, nearest_first, piece } = self;
        while *piece == NONE {
            let plan = |node: &Node| {
                let faces = tree.plane(node).is_none_or(|plane| plane.faces(eye));
                Plan { front_is_first: faces == *nearest_first, first: true, second: true }
            };
            *piece = walk.next(&plan)?.first;
        }
        let found = tree.pieces.get(usize::from(*piece))?;
        *piece = found.next;
        Some(found)
    }
}
