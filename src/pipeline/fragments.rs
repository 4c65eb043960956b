//! Fragment processing: what happens to the spans of one triangle.

use core::ops::Range;

use super::{surface::Surface, vertex::MeshVertex};
use crate::{
    fragment::shade::{Corner, Facet, Placed, Shading},
    geometry::{
        face::Side,
        viewport::{FARTHEST, NEAREST, Viewport, fine},
    },
    hidden::{
        Hidden,
        within::{Region, Within},
    },
    illumination::Illumination,
    model::assembly::Face,
    num::{Scalar, low_i32},
    raster::triangle::spans,
    slopes::Slopes,
    space::{Point2, Rect},
    span::Sink,
    target::Target,
    vary::{Plane, Ramp},
};

/// How much nearer to the eye than it is a surface is taken to be: for lines and decals on others.
///
/// The depth test then sees it in front of what it lies on. Both parts are in units of a 16-bit depth buffer:
/// what is always added, and what is added for each unit that the depth changes from a pixel to the next, which
/// steep surfaces need. Negative numbers push away.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct DepthBias {
    /// Added everywhere.
    pub constant: i16,
    /// Times the steepness.
    pub slope: i8,
}

impl DepthBias {
    /// None.
    pub const NONE: Self = Self { constant: 0, slope: 0 };

    /// For faces that lines are drawn on: so far back that all lines of a [wireframe](super::draw_wireframe) are
    /// seen that lie on them, in a depth buffer of 16 bits or more.
    ///
    /// A pixel of a line lies up to half a pixel beside it, where a steep face is at another depth.
    pub const BEHIND_LINES: Self = Self { constant: -2, slope: -1 };

    /// Depths of 31 bits, moved; they stay in range.
    pub(super) fn moved<const N: usize>(self, depths: [u32; N], steepness: u32) -> [u32; N] {
        let [farthest, nearest] = [FARTHEST, NEAREST].map(|depth| i64::from(fine(depth)));
        let bias = (i64::from(self.constant) << 15) + i64::from(self.slope) * i64::from(steepness);
        depths.map(|depth| low_i32((i64::from(depth) + bias).max(farthest).min(nearest)).cast_unsigned())
    }
}

/// A triangle of the mesh.
#[derive(Clone, Copy, Debug)]
pub(super) struct MeshTriangle {
    pub(super) face: Face,
    pub(super) side: Side,
}

/// A triangle on the screen: one of the mesh, or a piece of one that clipping has left.
#[derive(Clone, Copy, Debug)]
pub(super) struct Piece<A> {
    pub(super) positions: [Point2; 3],
    /// In 31 bits.
    pub(super) depths: [u32; 3],
    /// Distances from the eye and what is carried, if clipping has made the corners.
    pub(super) clipped: Option<[(Scalar, A); 3]>,
}

impl<A> Piece<A> {
    #[inline]
    pub(super) fn of_vertices([a, b, c]: [&MeshVertex; 3]) -> Self {
        Self {
            positions: [a.position(), b.position(), c.position()],
            depths: [a.depth(), b.depth(), c.depth()],
            clipped: None,
        }
    }
}

/// Where fragments go, and what decides about them.
pub(super) struct Fragments<'f, H, T> {
    pub(super) hidden: &'f mut H,
    pub(super) target: &'f mut T,
    pub(super) bounds: Rect,
}

impl<'f, H: Hidden, T: Target> Fragments<'f, H, T> {
    /// Where all three of viewport, `hidden` and `target` are.
    pub(super) fn new(viewport: Viewport, hidden: &'f mut H, target: &'f mut T) -> Self {
        let bounds = viewport.rect().intersection(hidden.bounds()).intersection(target.bounds());
        Self { hidden, target, bounds }
    }

    /// Draws one triangle, whichever side it shows.
    #[inline]
    pub(super) fn draw<S: Shading<Color = T::Color>, I: Illumination>(
        &mut self,
        surface: &Surface<'_, S, I>,
        triangle: &MeshTriangle,
        piece: &Piece<S::Attributes>,
    ) -> Result<(), T::Error> {
        spans(&piece.positions, &mut Painter { fragments: self, surface, triangle, piece, begun: None })
    }
}

impl<H: Hidden, T: Target> Fragments<'_, H, T> {
    /// Draws what of a triangle is in a region.
    pub(super) fn draw_within<S: Shading<Color = T::Color>, I: Illumination, R: Region + ?Sized>(
        &mut self,
        region: &R,
        surface: &Surface<'_, S, I>,
        (triangle, piece): (&MeshTriangle, &Piece<S::Attributes>),
    ) -> Result<(), T::Error> {
        let mut within = Within::new(self.hidden, region);
        let mut part = Fragments { hidden: &mut within, target: self.target, bounds: self.bounds };
        part.draw(surface, triangle, piece)
    }
}

/// Runs of so many pixels are drawn one by one, if that is cheap.
const SHORT: i32 = 3;

/// What is computed of a triangle when the first of its pixels is seen.
pub(super) struct Begun<F> {
    pub(super) face: F,
    pub(super) depth: Plane<1>,
}

/// One triangle on its way to the target.
struct Painter<'p, 'f, S: Shading, I, H, T> {
    fragments: &'p mut Fragments<'f, H, T>,
    surface: &'p Surface<'p, S, I>,
    triangle: &'p MeshTriangle,
    piece: &'p Piece<S::Attributes>,
    begun: Option<Begun<S::Face>>,
}

/// Begins a triangle. Most small triangles end before this, because they hold no pixel's centre.
#[inline(never)]
pub(super) fn begin<S: Shading, I: Illumination>(
    surface: &Surface<'_, S, I>,
    triangle: &MeshTriangle,
    piece: &Piece<S::Attributes>,
    uses_depth: bool,
) -> Begun<S::Face> {
    let corners = surface.corners(triangle);
    let slopes = Slopes::new(&piece.positions);
    let placed = place(surface, triangle, piece, &corners);
    let facet = Facet { corners: &corners, normal: surface.face_normal(triangle), placed: &placed, slopes: &slopes };
    let face = surface.shading.face(&surface.light, &facet);
    let depth = if uses_depth { depth_plane(surface.bias, &slopes, piece.depths) } else { Plane::LEVEL };
    Begun { face, depth }
}

/// The corners with what they carry.
#[inline]
fn place<S: Shading, I: Illumination>(
    surface: &Surface<'_, S, I>,
    triangle: &MeshTriangle,
    piece: &Piece<S::Attributes>,
    corners: &[Corner; 3],
) -> [Placed<S::Attributes>; 3] {
    let [a, b, c] = piece.positions;
    let [p, q, r] = piece.clipped.unwrap_or_else(|| {
        let [i, j, k] = triangle.face.corners;
        let [p, q, r] = corners;
        [(i, p), (j, q), (k, r)].map(|(index, corner)| (surface.w(index), surface.shading.corner(corner)))
    });
    [(a, p), (b, q), (c, r)].map(|(position, (w, attributes))| Placed { position, w, attributes })
}

/// The depths of a triangle over the screen, with its bias.
#[inline]
pub(super) fn depth_plane(bias: DepthBias, slopes: &Slopes, depths: [u32; 3]) -> Plane<1> {
    let plane = slopes.depth_plane(depths);
    if bias == DepthBias::NONE {
        return plane;
    }
    slopes.depth_plane(bias.moved(depths, plane.steepest()))
}

impl<S, I, H, T> Sink for Painter<'_, '_, S, I, H, T>
where
    S: Shading,
    I: Illumination,
    H: Hidden,
    T: Target<Color = S::Color>,
{
    type Error = T::Error;

    #[inline]
    fn bounds(&self) -> Rect {
        self.fragments.bounds
    }

    #[inline]
    fn span(&mut self, row: i32, columns: Range<i32>, (): ()) -> Result<(), T::Error> {
        let Surface { shading, light, .. } = self.surface;
        let Begun { face, depth } =
            self.begun.get_or_insert_with(|| begin(self.surface, self.triangle, self.piece, H::USES_DEPTH));
        let Fragments { hidden, target, .. } = &mut *self.fragments;
        let depth_at = |column| if H::USES_DEPTH { depth.at(row, column) } else { Ramp::new([0], [0]) };
        if S::IS_CHEAP && columns.end.wrapping_sub(columns.start) <= SHORT {
            for column in columns {
                if hidden.sees(row, column, depth_at(column)) {
                    let color = shading.colors(light, face, (row, column)).next().flatten();
                    color.map_or(Ok(()), |color| target.set(row, column, color))?;
                }
            }
            return Ok(());
        }
        let depth = depth_at(columns.start);
        if S::DROPS {
            let colors = shading.colors(light, face, (row, columns.start));
            let colors = hidden.filter(row, columns.clone(), depth, colors);
            target.write_run(row, columns, colors)
        } else {
            hidden.split(row, columns, depth, |part| shading.paint(light, face, (row, part), *target))
        }
    }
}
