//! Sorting of edges, which are large: each is copied once and never swapped.

use super::edge::{AreaEdge, Curved};

/// Insertion sort: between rows almost nothing changes its place, and the code is small.
#[inline]
pub(super) fn sort_by_key<C: Curved, K: PartialOrd>(edges: &mut [AreaEdge<C>], key: impl Fn(&AreaEdge<C>) -> K) {
    if edges.is_sorted_by_key(&key) {
        return;
    }
    for end in 2..=edges.len() {
        let Some([sorted @ .., last]) = edges.get_mut(..end) else { return };
        let mut free = last;
        let moved = key(free);
        if sorted.last().is_none_or(|edge| key(edge) <= moved) {
            continue;
        }
        let edge = *free;
        for left in sorted.iter_mut().rev().take_while(|left| key(left) > moved) {
            *free = *left;
            free = left;
        }
        *free = edge;
    }
}
