//! Primitive assembly: which vertices make a triangle. Lecture 2.2.2.
//!
//! ```text
//!   triangles          strip             fan             polygons
//!    b────d          b────d────f        b───c          b─────c
//!    │╲   │          │╲   │╲   │        │ ╱ │╲        ╱       ╲
//!    │  ╲ │          │  ╲ │  ╲ │        a───d e      a         d
//!    a────c          a────c────e                      ╲───e───╱
//!   abc, cbd…        abcdef             abcd         5; abcde
//!   6 a quad         2 a quad                        1 a corner, 1 a face
//! ```
//!
//! - **Takes** indices as they lie in flash.
//! - **Gives** triangles, wound as the primitive is: of a strip every other one is turned around.
//! - **Memory** none.
//! - **Cost** a few instructions a triangle.

/// Ends a strip or a fan; what follows begins the next one.
pub const RESTART: u16 = u16::MAX;

/// How indices make triangles.
#[derive(Clone, Copy, Debug)]
pub enum Assembly<'a> {
    /// Three vertices each.
    Triangles(&'a [[u16; 3]]),
    /// Each vertex makes a triangle with the two before it. [`RESTART`] begins another strip.
    Strip(&'a [u16]),
    /// Each vertex makes a triangle with the one before it and the first. [`RESTART`] begins another fan.
    Fan(&'a [u16]),
    /// Convex polygons of any number of corners.
    Polygons {
        /// How many corners each has.
        counts: &'a [u8],
        /// The corners of all of them.
        indices: &'a [u16],
    },
}

/// A triangle, and of which face it is a part.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct Face {
    /// Its vertices, counter-clockwise.
    pub corners: [u16; 3],
    /// The number of the polygon; where there are none, that of the triangle.
    pub number: usize,
}

/// The triangles of an [`Assembly`] in their order. Of strips, fans and polygons those are left out of which two
/// corners are the same vertex.
#[derive(Clone, Debug)]
pub struct Faces<'a> {
    assembly: Assembly<'a>,
    /// What these count depends on the assembly.
    at: usize,
    start: usize,
    number: usize,
}

impl<'a> Assembly<'a> {
    /// The triangles, and of which face each is.
    #[must_use]
    pub const fn faces(self) -> Faces<'a> {
        Faces { assembly: self, at: 0, start: 0, number: 0 }
    }

    /// The triangles.
    ///
    /// ```
    /// use aquatint::model::assembly::{Assembly, RESTART};
    ///
    /// let strip = Assembly::Strip(&[0, 1, 2, 3, RESTART, 5, 6, 7]);
    /// assert!(strip.triangles().eq([[0, 1, 2], [2, 1, 3], [5, 6, 7]]));
    /// let house = Assembly::Polygons { counts: &[5], indices: &[0, 1, 2, 3, 4] };
    /// assert!(house.triangles().eq([[0, 1, 2], [0, 2, 3], [0, 3, 4]]));
    /// ```
    pub fn triangles(self) -> impl Iterator<Item = [u16; 3]> + use<'a> {
        self.faces().map(|face| face.corners)
    }

    /// How many faces there are: polygons, or triangles.
    pub(super) const fn face_count(self) -> usize {
        if let Self::Polygons { counts, .. } = self {
            return counts.len();
        }
        let (mut faces, mut count) = (self.faces(), 0);
        while faces.step().is_some() {
            count += 1;
        }
        count
    }

    /// Whether the corners of polygons are three at least each, and add up.
    pub(super) const fn adds_up(self) -> bool {
        let Self::Polygons { counts, indices } = self else { return true };
        let (mut sum, mut polygon) = (0_usize, 0);
        while polygon < counts.len() {
            if counts[polygon] < 3 {
                return false;
            }
            sum = sum.saturating_add(counts[polygon] as usize);
            polygon += 1;
        }
        sum == indices.len()
    }

    /// The first index, or of triangles the first triangle, that names none of `count` vertices.
    pub(super) const fn first_wrong(self, count: usize) -> Option<usize> {
        let (indices, restarts) = match self {
            Self::Triangles(triangles) => (triangles.as_flattened(), false),
            Self::Strip(indices) | Self::Fan(indices) => (indices, true),
            Self::Polygons { indices, .. } => (indices, false),
        };
        let mut at = 0;
        while at < indices.len() {
            if indices[at] as usize >= count && !(restarts && indices[at] == RESTART) {
                return Some(if let Self::Triangles(_) = self { at / 3 } else { at });
            }
            at += 1;
        }
        None
    }
}

impl Faces<'_> {
    /// The next triangle; also for constants.
    const fn step(&mut self) -> Option<Face> {
        match self.assembly {
            Assembly::Triangles(triangles) => self.next_of(triangles),
            Assembly::Strip(indices) => self.next_of_run(indices, false),
            Assembly::Fan(indices) => self.next_of_run(indices, true),
            Assembly::Polygons { counts, indices } => self.next_of_polygons(counts, indices),
        }
    }

    /// These are taken as they are: `at` counts them.
    const fn next_of(&mut self, triangles: &[[u16; 3]]) -> Option<Face> {
        if self.at >= triangles.len() {
            return None;
        }
        let face = Face { corners: triangles[self.at], number: self.at };
        self.at += 1;
        Some(face)
    }

    /// Of a strip or a fan: `at` is the first of three indices in a row, `start` where the run begins.
    const fn next_of_run(&mut self, indices: &[u16], is_fan: bool) -> Option<Face> {
        while self.at < indices.len().saturating_sub(2) {
            let (at, start) = (self.at, self.start);
            let [a, b, c] = [index_at(indices, at), index_at(indices, at + 1), index_at(indices, at + 2)];
            self.at += 1;
            if a == RESTART {
                self.start = self.at;
            } else if b != RESTART && c != RESTART {
                let first = if is_fan { index_at(indices, start) } else { a };
                let turned = !is_fan && at.wrapping_sub(start) % 2 == 1;
                let corners = if turned { [b, a, c] } else { [first, b, c] };
                if !is_degenerate(corners) {
                    self.number += 1;
                    return Some(Face { corners, number: self.number - 1 });
                }
            }
        }
        None
    }

    /// Of a polygon: `at` counts its triangles, `start` is where it begins, `number` counts the polygons.
    const fn next_of_polygons(&mut self, counts: &[u8], indices: &[u16]) -> Option<Face> {
        while self.number < counts.len() {
            let (count, second) = (counts[self.number] as usize, self.start + self.at + 1);
            if self.at + 2 >= count || second + 1 >= indices.len() {
                (self.start, self.at, self.number) = (self.start + count, 0, self.number + 1);
                continue;
            }
            self.at += 1;
            let [a, b, c] = [self.start, second, second + 1];
            let corners = [index_at(indices, a), index_at(indices, b), index_at(indices, c)];
            if !is_degenerate(corners) {
                return Some(Face { corners, number: self.number });
            }
        }
        None
    }
}

/// An index; behind the end there is nothing but restarts.
const fn index_at(indices: &[u16], at: usize) -> u16 {
    if at < indices.len() { indices[at] } else { RESTART }
}

const fn is_degenerate([a, b, c]: [u16; 3]) -> bool {
    a == b || b == c || c == a
}

impl Iterator for Faces<'_> {
    type Item = Face;

    #[inline]
    fn next(&mut self) -> Option<Face> {
        self.step()
    }
}
