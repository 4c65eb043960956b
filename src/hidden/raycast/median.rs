//! Halving: the leaves of a box to both sides of their median, without sorting and without a worst case.

use core::mem::swap;

use super::{bounds::Bounds, hierarchy::Node, ray::Axis};

/// Twice the middle of a box is at most so far from zero.
const FARTHEST: i32 = 1 << 15;

/// Brings the `first` leaves, along the longest axis of the box around all of them, to the front; gives that box.
///
/// The median is found bit by bit: 17 times its leaves are counted.
pub(super) fn halve(leaves: &mut [Node], first: usize) -> Bounds {
    let whole = leaves.iter().fold(Bounds::EMPTY, |all, leaf| all.union(&leaf.bounds));
    let axis = Axis::of(whole.size());
    let middle = |leaf: &Node| {
        let [.., middle] = axis.last(leaf.bounds.middle());
        middle
    };
    // The first leaves are below `high`, but not all of them below `low`.
    let (mut low, mut high) = (-FARTHEST, FARTHEST);
    while high - low > 1 {
        let between = i32::midpoint(low, high);
        let below = leaves.iter().filter(|leaf| middle(leaf) < between).count();
        if below > first { high = between } else { low = between }
    }
    // Those at the median itself may go to either side.
    let below = to_front(leaves, |leaf| middle(leaf) < low);
    to_front(leaves.get_mut(below..).unwrap_or_default(), |leaf| middle(leaf) == low);
    whole
}

/// Brings those that `belong` to the front; gives their number.
fn to_front(nodes: &mut [Node], belongs: impl Fn(&Node) -> bool) -> usize {
    let (mut count, mut others) = (0, nodes.iter_mut());
    while let Some(front) = others.next() {
        if !belongs(front) {
            let Some(back) = others.rfind(|node| belongs(node)) else { break };
            swap(front, back);
        }
        count += 1;
    }
    count
}
