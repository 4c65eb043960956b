//! The list of edges of a scan conversion, which looks ahead.
//!
//! In front are the *active* edges, which reach into the present row; behind them, unsorted, wait as many of
//! those that begin next as there is room for, so that the outline is not traced again for each of them:
//!
//! ```text
//!   │ active, by column │ waiting │ room │        all edges that begin above row `known` are here
//! ```

use core::ops::Range;

use heapless::vec::VecView;

use crate::list::swap;

/// An edge that reaches into some rows.
pub(super) trait RowEdge {
    /// The first of its rows, or the row it was made for if that is lower.
    fn first_row(&self) -> i32;

    /// The first row behind.
    fn end_row(&self) -> i32;
}

/// Edges in memory of the caller's.
pub(super) struct ActiveList<'l, E> {
    edges: &'l mut VecView<E>,
    /// How many of the edges are active.
    active: usize,
    /// The list holds every edge that begins above this row and is not over yet.
    known: i32,
    /// From a row that is not known to this one there are always more active edges than the list can hold.
    crowded: i32,
}

impl<'l, E: RowEdge> ActiveList<'l, E> {
    pub(super) fn new(edges: &'l mut VecView<E>) -> Self {
        Self { edges, active: 0, known: i32::MIN, crowded: i32::MIN }
    }

    /// Whether the active edges of a row are all here; else there are more than the list can hold.
    #[inline]
    pub(super) fn knows(&self, row: i32) -> bool {
        row < self.known
    }

    #[inline]
    pub(super) fn active(&mut self) -> &mut [E] {
        self.edges.get_mut(..self.active).unwrap_or_default()
    }

    /// Brings the list up to `row`: drops the edges that have ended, makes those active that begin. Where none
    /// waits any more, `collect` has to [offer](Self::offer) all of the outline again.
    pub(super) fn enter(&mut self, row: i32, collect: impl FnOnce(&mut Self)) {
        if row < self.crowded {
            return;
        }
        if row >= self.known {
            self.edges.clear();
            (self.active, self.known) = (0, i32::MAX);
            collect(self);
            if self.known <= row {
                self.edges.clear();
            }
        } else {
            let waiting = self.edges.len().wrapping_sub(self.active);
            self.edges.retain(|edge| row < edge.end_row());
            // Those that wait have not ended.
            self.active = self.edges.len().wrapping_sub(waiting);
        }
        for place in self.active..self.edges.len() {
            if self.edges.get(place).is_some_and(|edge| edge.first_row() <= row) {
                swap(self.edges, place, self.active);
                self.active = self.active.wrapping_add(1);
            }
        }
    }

    /// Takes an edge of these rows, made for the row that is said, if there is room for it or it begins before others.
    #[inline]
    pub(super) fn offer(&mut self, edge: Range<i32>, row: i32, make: impl FnOnce(i32) -> E) {
        let first_row = edge.start.max(row);
        if row >= edge.end {
            return;
        }
        if first_row < self.known && self.make_room(first_row) {
            // There is room.
            let _ = self.edges.push(make(first_row));
        } else if first_row == row {
            self.crowd(edge.end, || make(row));
        }
    }

    /// The rows of which edges are still of interest while they are [offered](Self::offer) for a row.
    #[inline]
    pub(super) fn open_rows(&self, row: i32) -> Range<i32> {
        row..self.known.max(row.saturating_add(1))
    }

    /// Keeps, of too many edges that are active at once, those that end last: until the next one ends there are too many.
    #[cold]
    fn crowd(&mut self, end: i32, make: impl FnOnce() -> E) {
        let first = self.edges.iter_mut().min_by_key(|edge| edge.end_row());
        let ended = match first {
            Some(first) if first.end_row() < end => core::mem::replace(first, make()).end_row(),
            _ => end,
        };
        self.crowded = self.crowded.max(ended);
    }

    /// Gives up the latest edges for one that begins earlier; whether there is room then.
    #[inline]
    fn make_room(&mut self, first_row: i32) -> bool {
        while self.edges.is_full() {
            let latest = self.edges.iter().map(RowEdge::first_row).fold(first_row, i32::max);
            self.known = latest;
            if latest == first_row {
                return false;
            }
            self.edges.retain(|edge| edge.first_row() < latest);
        }
        true
    }

    /// The first row below `row` in which other edges are active.
    pub(super) fn next_change(&self, row: i32) -> i32 {
        if self.known <= row {
            return self.crowded.max(row.saturating_add(1));
        }
        let (active, waiting) = self.edges.split_at_checked(self.active).unwrap_or_default();
        let end = active.iter().map(RowEdge::end_row).fold(self.known, i32::min);
        waiting.iter().map(RowEdge::first_row).fold(end, i32::min)
    }
}

/// Insertion sort: between rows almost nothing changes its place, and the code is small. Each edge is copied once and never
/// swapped: some are large.
#[inline]
pub(super) fn sort_by_key<E: Copy, K: PartialOrd>(edges: &mut [E], key: impl Fn(&E) -> K) {
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
