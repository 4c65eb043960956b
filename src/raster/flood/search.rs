//! The search: from row to row, by words of the visited bitmap. It reads the picture and never writes it.
//!
//! ```text
//!   row y − 1   ·▒▒▒··▒▒▒▒··      found: its free runs that touch
//!                 │    │
//!   row y       ··████████··      an entry: words of a row in which pixels are visited
//!                      │
//!   row y + 1   ······▒▒▒▒▒▒▒──▶  found, and followed into the next word
//! ```
//!
//! Every run is marked when it is found, so it is found once. Words side by side in which something was found
//! are one entry of the queue; one that does not fit makes its row dirty. When the queue is empty, a dirty row is
//! taken as one entry of all its words: either something is found next to it, or it is clean. So the search
//! ends, and ends complete, with a queue of any length.

use core::ops::Range;

use embedded_graphics::geometry::Point;

use super::{
    Connectivity,
    queue::{Queue, Run},
    visited::Visited,
};
use crate::{
    num::{index, low_index},
    runs::{FIRST, Inside, LAST, Runs},
    space::Rect,
};

pub(super) struct Search<'s, 'm, P: Runs> {
    pub(super) picture: &'s P,
    pub(super) inside: Inside<P::Color>,
    pub(super) window: Rect,
    pub(super) connectivity: Connectivity,
    pub(super) queue: Queue<'s>,
    pub(super) visited: &'s mut Visited<'m>,
}

/// From word to word along a row.
struct Way {
    step: usize,
    /// The pixels at which a word is entered and left.
    near: u32,
    far: u32,
}

const LEFTWARDS: Way = Way { step: usize::MAX, near: LAST, far: FIRST };
const RIGHTWARDS: Way = Way { step: 1, near: FIRST, far: LAST };

impl<P: Runs> Search<'_, '_, P> {
    /// Visits the region around a pixel of the window.
    pub(super) fn from(&mut self, seed: Point) {
        let column = index(seed.x.wrapping_sub(self.window.left));
        let row = index(seed.y.wrapping_sub(self.window.top));
        let (word, bit) = (column / 32, FIRST >> (low_index(column) % 32));
        let (found_in, _) = self.sweep(row, word..word + 1, |_, _| bit);
        self.put(row, found_in);
        while let Some(run) = self.next() {
            self.enter(run, usize::MAX);
            self.enter(run, 1);
        }
    }

    /// What to look around from: the oldest entry, or a dirty row.
    #[inline]
    fn next(&mut self) -> Option<Run> {
        self.queue.pop().or_else(|| {
            let row = self.visited.take_dirty()?;
            Some(Run::new(row, &self.visited.columns()))
        })
    }

    /// Visits what touches a run in the row `step` further on, and what touches that, as long as there is only
    /// one way: straight on.
    #[inline(never)]
    fn enter(&mut self, run: Run, step: usize) {
        let (mut from, mut words) = (run.row(), run.columns());
        let mut row = from.wrapping_add(step);
        if self.connectivity == Connectivity::Four && self.visited.covers(row, from, words.clone()) {
            return;
        }
        while row < self.visited.height() {
            let (found_in, is_more) = match self.connectivity {
                Connectivity::Four => self.sweep(row, words, |visited, word| visited.word(from, word)),
                Connectivity::Eight => self.sweep_corners(row, from, words),
            };
            if found_in.is_empty() || is_more {
                self.put(row, found_in);
                return;
            }
            (from, words, row) = (row, found_in, row.wrapping_add(step));
        }
    }

    /// What is found may always touch more in the row where the search comes from.
    #[inline(never)]
    fn sweep_corners(&mut self, row: usize, from: usize, words: Range<usize>) -> (Range<usize>, bool) {
        let wider = words.start.saturating_sub(1)..(words.end + 1).min(self.visited.stride());
        (self.sweep(row, wider, |visited, word| spread(visited, from, &words, word)).0, true)
    }

    /// Visits the runs of a row that hold one of the pixels that `reach` gives for its words.
    ///
    /// Words side by side in which something is found are one entry. The last is given, and whether more is
    /// found than was reached; the others are put into the queue.
    #[inline]
    fn sweep(
        &mut self,
        row: usize,
        words: Range<usize>,
        reach: impl Fn(&Visited, usize) -> u32,
    ) -> (Range<usize>, bool) {
        self.visited.cover(row, &words);
        let (mut found_in, mut goes_on, mut more) = (words.start..words.start, 0, 0);
        for word in words.clone() {
            let reached = reach(self.visited, word);
            let found = self.visit(row, word, reached | goes_on);
            if found != 0 {
                more |= found & !reached;
                // What goes on from the word before has been followed.
                let start = if found & FIRST & !goes_on == 0 { word } else { self.follow(row, word, &LEFTWARDS) };
                more |= u32::from(start < word);
                if found_in.is_empty() {
                    found_in.start = start;
                } else if start > found_in.end {
                    self.put(row, found_in);
                    found_in = start..start;
                }
                found_in = found_in.start.min(start)..word + 1;
            }
            // The last pixel of this word touches the first of the next.
            goes_on = found << 31;
        }
        if goes_on != 0 {
            found_in.end = self.follow(row, words.end.wrapping_sub(1), &RIGHTWARDS) + 1;
            more |= u32::from(found_in.end > words.end);
        }
        (found_in, more != 0)
    }

    /// Follows a run out of a word; gives the last word that it reaches.
    #[inline(never)]
    fn follow(&mut self, row: usize, mut word: usize, way: &Way) -> usize {
        loop {
            let next = word.wrapping_add(way.step);
            if next >= self.visited.stride() {
                return word;
            }
            self.visited.cover(row, &(next..next + 1));
            let found = self.visit(row, next, way.near);
            if found == 0 {
                return word;
            }
            word = next;
            if found & way.far == 0 {
                return word;
            }
        }
    }

    /// Visits the runs of a valid word that hold a seed; gives what is new.
    #[inline]
    fn visit(&mut self, row: usize, word: usize, seeds: u32) -> u32 {
        let free = !self.visited.word(row, word);
        if seeds & free == 0 { 0 } else { self.ask(row, word, (seeds, free)) }
    }

    /// Asks the picture.
    #[expect(clippy::inline_always, reason = "saves a tenth of the time, and it is called in three places only")]
    #[inline(always)]
    fn ask(&mut self, row: usize, word: usize, (seeds, free): (u32, u32)) -> u32 {
        let free = free & self.visited.existing(word);
        let x = self.window.left.wrapping_add_unsigned(low_index(32 * word));
        let y = self.window.top.wrapping_add_unsigned(low_index(row));
        let found = self.picture.runs(Point::new(x, y), self.inside, seeds & free, free) & free;
        self.visited.mark(row, word, found);
        found
    }

    /// Remembers words of a row in which something was found.
    #[inline(never)]
    fn put(&mut self, row: usize, words: Range<usize>) {
        if !words.is_empty() && !self.queue.push(Run::new(row, &words)) {
            self.visited.mark_dirty(row);
        }
    }
}

/// The pixels of a word that touch, by a side or a corner, those visited in some words of the row next to it.
#[inline]
fn spread(visited: &Visited, from: usize, words: &Range<usize>, word: usize) -> u32 {
    let at = |word: usize| if words.contains(&word) { visited.word(from, word) } else { 0 };
    let here = at(word);
    let beside = (at(word.wrapping_sub(1)) << 31) | (at(word.wrapping_add(1)) >> 31);
    here | (here << 1) | (here >> 1) | beside
}
