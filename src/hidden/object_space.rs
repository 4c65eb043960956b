//! Object space: each face is compared with every other face, and what none of them hides is shown. Lecture 5.1.
//!
//! ```text
//!    ┌────────┐         ┌──┬──┬──┐      what is left of P: the parts outside of an edge of Q
//!    │ P ╱╲   │         │  │╱╲│  │      and inside of those before it, and the part inside of
//!    │  ╱Q ╲  │   ──▶   │  ╱  ╲  │      all edges where P is in front of Q; each of them is
//!    │  ‾‾‾‾  │         ├──────  │      compared with the next face
//!    └────────┘         └────────┘
//! ```
//!
//! A part is its face and some *halves* of the screen, not corners: the inner side of an edge is told by the rule of
//! rasterisation, and who is in front by the depths that a depth buffer would compare. Nothing is rounded, so no pixel is
//! lost, none is shown twice, and the picture is that of a [`DepthBuffer<u32>`](super::depth::DepthBuffer) to the pixel.
//!
//! - **Takes** triangles on the screen, with the planes of their depths.
//! - **Gives** for each the parts of it that are seen.
//! - **Memory** 36 bytes a face, and 40 for each half that bounds the part at hand: at most four for each face whose box meets
//!   that of the part's face. Lent by the caller.
//! - **Cost** grows with the square of the number of faces: every pair is compared, row by row where their boxes meet.
//!
//! I. E. Sutherland, R. F. Sproull, R. A. Schumacker, "A characterization of ten hidden-surface algorithms", ACM Computing
//! Surveys 6(1), 1974.

use core::ops::Range;

use heapless::vec::VecView;

use super::{
    scanline::{Full, where_ahead},
    within::Region,
};
use crate::{
    cut::Cut,
    edge::reached_by,
    num::{bits, index_u16},
    space::{Point2, Rect, twice_area},
    vary::Plane,
};

/// A triangle on the screen and its depths, as others are compared with it: 36 bytes.
#[derive(Clone, Copy, Debug)]
pub struct ComparedFace {
    /// Clockwise on the screen.
    corners: [Point2; 3],
    /// In pixel (0, 0), in 31 bits; modulo 2³² where the face does not reach so far.
    depth: u32,
    /// What is added a column to the right, and a row down.
    across: u32,
    down: u32,
}

impl ComparedFace {
    /// Of corners in any order.
    pub(crate) fn new([a, b, c]: [Point2; 3], plane: &Plane<1>) -> Self {
        let corners = if twice_area(a, b, c) < 0 { [a, c, b] } else { [a, b, c] };
        let ([depth], [across], [down]) = (plane.at(0, 0).fine(), plane.across, plane.down);
        Self { corners, depth, across, down }
    }

    /// The inner side of an edge, by its number.
    fn edge(&self, number: u8) -> Cut {
        let [a, b, c] = self.corners;
        let (from, to) = match number {
            0 => (a, b),
            1 => (b, c),
            _ => (c, a),
        };
        Cut::of_edge(from, to)
    }

    /// Where this is in front of another; of two that are equally near, one `wins_ties`.
    fn before(&self, other: &Self, wins_ties: bool) -> Lead {
        Lead {
            value: self.depth.wrapping_sub(other.depth),
            across: self.across.wrapping_sub(other.across),
            down: self.down.wrapping_sub(other.down),
            wins_ties,
        }
    }

    /// The box of its pixels in a window.
    fn pixels(&self, window: Rect) -> Rect {
        reached_by(&self.corners).intersection(window)
    }
}

/// The pixels in which one face is in front of another, of those that both have.
#[derive(Clone, Copy, Debug)]
struct Lead {
    /// In pixel (0, 0), modulo 2³²; what is added a column to the right, and a row down.
    value: u32,
    across: u32,
    down: u32,
    wins_ties: bool,
}

/// A half of the screen.
#[derive(Clone, Copy, Debug)]
enum Half {
    Edge(Cut),
    Lead(Lead),
}

impl Region for Half {
    #[inline]
    fn keep(&self, row: i32, columns: Range<i32>) -> Range<i32> {
        match self {
            Self::Edge(cut) => cut.keep(row, columns),
            Self::Lead(_) if columns.is_empty() => columns,
            Self::Lead(Lead { value, across, down, wins_ties }) => {
                where_ahead((value.wrapping_add(down.wrapping_mul(bits(row))), *across), *wins_ties, columns)
            }
        }
    }
}

/// A half of the screen that bounds the part of a face at hand: 40 bytes.
#[derive(Clone, Copy, Debug)]
pub struct PartBound {
    half: Half,
    /// The face that it comes from.
    rival: u16,
    /// It is outside of this edge; what is inside comes later.
    outside: Option<u8>,
}

impl Region for PartBound {
    #[inline]
    fn keep(&self, row: i32, columns: Range<i32>) -> Range<i32> {
        self.half.keep(row, columns)
    }
}

/// How many bounds a part of some face may have at most: four for each other face whose box meets its own.
pub(crate) fn most_bounds(faces: &[ComparedFace], window: Rect) -> usize {
    let boxes = || faces.iter().map(|face| face.pixels(window));
    let met = |own: Rect| boxes().filter(|other| !own.intersection(*other).is_empty()).count();
    // A face meets itself, too.
    let rivals = boxes().map(met).max().unwrap_or(0).saturating_sub(1);
    rivals.saturating_mul(4)
}

/// What is done next with the part at hand.
enum Step {
    /// Look whether a face hides some of it.
    Compare(u16),
    /// Take away what that face hides, from one of its edges on.
    Subtract(u16, u8),
    /// Leave it, and take up the last that waits.
    Back,
}

/// The parts of one face that no other hides, one after the other.
pub(crate) struct VisibleParts<'c> {
    faces: &'c [ComparedFace],
    bounds: &'c mut VecView<PartBound>,
    number: u16,
    face: ComparedFace,
    edges: [Cut; 3],
    pixels: Rect,
    is_begun: bool,
}

impl<'c> VisibleParts<'c> {
    /// Of the face with a number; works in the list.
    pub(crate) fn new(
        faces: &'c [ComparedFace],
        number: u16,
        bounds: &'c mut VecView<PartBound>,
        window: Rect,
    ) -> Option<Self> {
        let face = *faces.get(usize::from(number))?;
        bounds.clear();
        let edges = [face.edge(0), face.edge(1), face.edge(2)];
        Some(Self { faces, bounds, number, face, edges, pixels: face.pixels(window), is_begun: false })
    }

    /// What bounds the part at hand, besides the edges of its face.
    pub(crate) fn bounds(&self) -> &[PartBound] {
        self.bounds.as_slice()
    }

    /// Goes to the next part: `false` after the last.
    pub(crate) fn advance(&mut self) -> Result<bool, Full> {
        let mut step = if core::mem::replace(&mut self.is_begun, true) { Step::Back } else { Step::Compare(0) };
        loop {
            step = match step {
                Step::Compare(rival) if usize::from(rival) >= self.faces.len() => return Ok(true),
                Step::Compare(rival) if self.is_hidden_by(rival) => Step::Subtract(rival, 0),
                Step::Compare(rival) => Step::Compare(rival.saturating_add(1)),
                Step::Subtract(rival, edge) => self.subtract(rival, edge)?,
                Step::Back => match self.turn_back()? {
                    Some(step) => step,
                    None => return Ok(false),
                },
            }
        }
    }

    /// Goes back to the last part outside of an edge, and on with what is inside of it.
    fn turn_back(&mut self) -> Result<Option<Step>, Full> {
        while let Some(PartBound { half, rival, outside }) = self.bounds.pop() {
            if let (Half::Edge(cut), Some(edge)) = (half, outside) {
                self.push(Half::Edge(cut.other()), rival, None)?;
                return Ok(Some(Step::Subtract(rival, edge.saturating_add(1))));
            }
        }
        Ok(None)
    }

    /// Takes away what a face hides of the part, from one of its edges on; goes on with the first part that is left.
    fn subtract(&mut self, rival: u16, first_edge: u8) -> Result<Step, Full> {
        let Some(other) = self.faces.get(usize::from(rival)) else { return Ok(Step::Back) };
        let next = Step::Compare(rival.saturating_add(1));
        for edge in first_edge..3 {
            let outside = Half::Edge(other.edge(edge).other());
            if self.has_pixels(&[outside]) {
                return self.push(outside, rival, Some(edge)).map(|()| next);
            }
        }
        let ahead = Half::Lead(self.face.before(other, self.number < rival));
        if self.has_pixels(&[ahead]) { self.push(ahead, rival, None).map(|()| next) } else { Ok(Step::Back) }
    }

    fn push(&mut self, half: Half, rival: u16, outside: Option<u8>) -> Result<(), Full> {
        self.bounds.push(PartBound { half, rival, outside }).map_err(|_| Full)
    }

    /// Whether a face hides a pixel of the part.
    fn is_hidden_by(&self, rival: u16) -> bool {
        let Some(other) = self.faces.get(usize::from(rival)).filter(|_| rival != self.number) else { return false };
        if self.pixels.intersection(other.pixels(self.pixels)).is_empty() {
            return false;
        }
        let [a, b, c] = [0, 1, 2].map(|edge| Half::Edge(other.edge(edge)));
        self.has_pixels(&[a, b, c, Half::Lead(other.before(&self.face, rival < self.number))])
    }

    /// Whether the part has a pixel in all of some halves.
    fn has_pixels(&self, halves: &[Half]) -> bool {
        self.pixels.rows().any(|row| {
            let columns = self.edges.keep(row, self.pixels.columns());
            let columns = self.bounds.as_slice().keep(row, columns);
            !halves.keep(row, columns).is_empty()
        })
    }
}

/// Places of faces in a list of at most 65,535.
pub(crate) fn numbers(faces: &[ComparedFace]) -> Range<u16> {
    0..index_u16(faces.len())
}
