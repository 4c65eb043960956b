//! Faces that wait for their first row, and those that reach into the present one.

use core::ops::Range;

use super::buckets::NONE;
use crate::{
    fragment::shade::Shading,
    geometry::face::Side,
    hidden::scanline::RowDepth,
    illumination::Illumination,
    model::assembly::Face,
    num::low_i16,
    pipeline::{
        each_clipped,
        fragments::{Begun, MeshTriangle, Piece, begin},
        surface::Surface,
    },
    raster::walk::{Walk, rows},
    space::Rect,
};

/// A face that shows in the picture: 16 bytes.
#[derive(Clone, Copy, Debug)]
pub struct ListedFace {
    corners: [u16; 3],
    number: u16,
    pub(super) first_row: i16,
    /// The next face of its bucket.
    pub(super) next: u16,
    pub(super) instance: u8,
    side: Side,
    /// Which piece of a face that is clipped, from 1 on; 0 for a whole one.
    piece: u8,
}

/// A face that reaches into the present row.
#[derive(Clone, Debug)]
pub struct ActiveFace<F> {
    walk: Walk,
    /// Its pixels in the row, as far as they lie in the window; maybe none, then the end may be before the start.
    pub(super) columns: Range<i32>,
    pub(super) depth: RowDepth,
    /// What is added to the depth from row to row.
    down: u32,
    pub(super) end_row: i16,
    pub(super) instance: u8,
    pub(super) face: F,
}

impl ListedFace {
    /// A piece of a triangle that has its first row in a picture; `None` for faces with a number of more than 16 bits.
    pub(super) fn new(triangle: &MeshTriangle, piece: u8, first_row: i32, instance: u8) -> Option<Self> {
        let MeshTriangle { face: Face { corners, number }, side } = *triangle;
        let (number, first_row) = (u16::try_from(number).ok()?, low_i16(first_row));
        Some(Self { corners, number, first_row, next: NONE, instance, side, piece })
    }

    /// Takes it up in a row; `order` is its place among all faces.
    pub(super) fn begin<S: Shading, I: Illumination>(
        &self,
        surface: &Surface<'_, S, I>,
        (row, order): (i32, u16),
        window: Rect,
    ) -> Option<ActiveFace<S::Face>> {
        let triangle =
            MeshTriangle { face: Face { corners: self.corners, number: self.number.into() }, side: self.side };
        let piece = self.piece(surface, triangle.face)?;
        let walk = Walk::new(&piece.positions, row)?;
        let Begun { face, depth } = begin(surface, &triangle, &piece, true);
        let [at_origin] = depth.at(row, 0).fine();
        let ([across], [down]) = (depth.across, depth.down);
        let end_row = low_i16(rows(&piece.positions).end.min(window.bottom));
        let depth = RowDepth { depth: at_origin, across, order };
        let columns = intersection(walk.columns(), &window.columns());
        Some(ActiveFace { walk, columns, depth, down, end_row, instance: self.instance, face })
    }

    /// Its corners on the screen. Clipped pieces are cut anew, and counted.
    fn piece<S: Shading, I: Illumination>(
        &self,
        surface: &Surface<'_, S, I>,
        face: Face,
    ) -> Option<Piece<S::Attributes>> {
        if self.piece == 0 {
            return Some(Piece::of_vertices(&surface.vertices_of(face)));
        }
        let mut left = self.piece;
        each_clipped(surface, face, &mut |_, piece| {
            left -= 1;
            if left == 0 { Err(*piece) } else { Ok(()) }
        })
        .err()
    }
}

impl<F> ActiveFace<F> {
    /// Goes down to a row.
    #[inline]
    pub(super) fn advance(&mut self, row: i32, window: &Range<i32>) {
        self.walk.advance(row);
        self.columns = intersection(self.walk.columns(), window);
        self.depth.depth = self.depth.depth.wrapping_add(self.down);
    }
}

#[inline]
pub(super) fn intersection(a: Range<i32>, b: &Range<i32>) -> Range<i32> {
    a.start.max(b.start)..a.end.min(b.end)
}
