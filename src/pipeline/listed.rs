//! The faces of several instances that show in a picture, in a list that is lent.

use core::{convert::Infallible, ops::Range};

use heapless::vec::Vec;

use super::{
    Bounds, DrawError, Instance, MeshVertex, Scene, each_clipped, each_piece,
    fragments::{MeshTriangle, Piece},
    prepared,
    surface::Surface,
};
use crate::{
    edge::reached_by,
    fragment::shade::Shading,
    geometry::{face::Side, light::Lighting},
    illumination::Illumination,
    model::assembly::Face,
    num::{low_index, low_u8},
    space::Rect,
};

/// A face that shows in the picture: 12 bytes.
#[derive(Clone, Copy, Debug)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct ListedFace {
    corners: [u16; 3],
    number: u16,
    instance: u8,
    side: Side,
    /// Which piece of a face that is clipped, from 1 on; 0 for a whole one.
    piece: u8,
}

/// The instance of a face, and where the face is.
type OnScreen<'l, 's, S, I> = (&'l Surface<'s, S, I>, Piece<<S as Shading>::Attributes>);

impl ListedFace {
    /// `None` for faces with a number of more than 16 bits.
    fn new(triangle: &MeshTriangle, piece: u8, instance: u8) -> Option<Self> {
        let MeshTriangle { face: Face { corners, number }, side } = *triangle;
        Some(Self { corners, number: u16::try_from(number).ok()?, instance, side, piece })
    }

    pub(super) const fn instance(&self) -> u8 {
        self.instance
    }

    /// The triangle of its mesh.
    pub(super) fn triangle(&self) -> MeshTriangle {
        MeshTriangle { face: Face { corners: self.corners, number: self.number.into() }, side: self.side }
    }

    /// Its instance, and where it is on the screen.
    pub(super) fn placed<'l, 's, S: Shading, I: Illumination>(
        &self,
        surfaces: &'l [Surface<'s, S, I>],
    ) -> Option<OnScreen<'l, 's, S, I>> {
        let surface = surfaces.get(usize::from(self.instance))?;
        Some((surface, self.piece(surface)?))
    }

    /// Where it is on the screen. Clipped pieces are cut anew, and counted.
    fn piece<S: Shading, I: Illumination>(&self, surface: &Surface<'_, S, I>) -> Option<Piece<S::Attributes>> {
        if self.piece == 0 {
            return surface.vertices_of(self.corners).map(Piece::of_vertices);
        }
        let mut left = self.piece;
        each_clipped(surface, self.triangle().face, &mut |_, piece| {
            left -= 1;
            if left == 0 { Err(*piece) } else { Ok(()) }
        })
        .err()
    }
}

/// Shows each face of which something is in a window: what is listed of it, its instance, where it is, and the box of its
/// pixels there. `take` tells whether there was room.
pub(super) fn list<'s, S: Shading, I: Illumination>(
    surfaces: &[Surface<'s, S, I>],
    window: Rect,
    take: &mut impl FnMut(ListedFace, &Surface<'s, S, I>, &Piece<S::Attributes>, Rect) -> bool,
) -> Result<(), DrawError<Infallible>> {
    let (mut needed, mut taken, mut pieces) = (0_usize, 0_usize, Pieces::default());
    for (instance, surface) in surfaces.iter().enumerate() {
        let instance = low_u8(low_index(instance));
        let Ok(()) = each_piece::<_, _, Infallible>(surface, &mut |triangle, piece| {
            let number = pieces.count((instance, triangle.face), piece.clipped.is_some());
            let pixels = reached_by(&piece.positions).intersection(window);
            if !pixels.is_empty() {
                needed = needed.saturating_add(1);
                let listed = ListedFace::new(triangle, number, instance);
                let is_taken = listed.is_some_and(|listed| take(listed, surface, piece, pixels));
                taken = taken.saturating_add(usize::from(is_taken));
            }
            Ok(())
        });
    }
    if taken < needed { Err(DrawError::TooFewFaces { needed }) } else { Ok(()) }
}

/// Counts the pieces of faces that are clipped, from 1 on; whole ones have number 0.
#[derive(Default)]
struct Pieces {
    last: Option<(u8, Face)>,
    number: u8,
}

impl Pieces {
    fn count(&mut self, face: (u8, Face), is_clipped: bool) -> u8 {
        let again = self.last == Some(face);
        self.last = Some(face);
        self.number = if !is_clipped {
            0
        } else if again {
            self.number.saturating_add(1)
        } else {
            1
        };
        self.number
    }
}

/// Vertex processing of all instances; those of which nothing is seen are left out.
///
/// Into a list that is there: surfaces are too large to be handed around on the stack of a small core.
#[inline(never)]
pub(super) fn prepare<'s, S: Shading, B: Bounds, L: Lighting, const N: usize>(
    instances: &'s [Instance<'_, S, B>; N],
    scene: &Scene<L>,
    vertices: &'s mut [MeshVertex],
    surfaces: &mut Vec<Surface<'s, S, L::Illumination>, N>,
) -> Result<(), DrawError<Infallible>> {
    let counts = instances.iter().map(|instance| instance.mesh.positions().len());
    let (needed, mut left) = (counts.fold(0, usize::saturating_add), vertices);
    if left.len() < needed {
        return Err(DrawError::TooFewVertices { needed });
    }
    for instance in instances {
        let (own, others) = left.split_at_mut_checked(instance.mesh.positions().len()).unwrap_or_default();
        left = others;
        if let Some(surface) = prepared(instance, scene, own)? {
            // There is room for as many as there are instances.
            let _ = surfaces.push(surface);
        }
    }
    Ok(())
}

#[inline]
pub(super) fn intersection(a: Range<i32>, b: &Range<i32>) -> Range<i32> {
    a.start.max(b.start)..a.end.min(b.end)
}
