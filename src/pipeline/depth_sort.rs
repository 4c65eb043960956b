//! The painter's algorithm over a whole scene: faces from the farthest to the nearest, no memory for pixels. Lecture 5.7.

use core::convert::Infallible;

use heapless::vec::{Vec, VecView};

use super::{
    Bounds, DepthBias, DrawError, Instance, MeshVertex, Scene,
    fragments::{Fragments, Piece, depth_plane},
    listed::{ListedFace, list, prepare},
    surface::Surface,
};
use crate::{
    fragment::shade::Shading,
    geometry::light::Lighting,
    hidden::{
        convex::Convex,
        painter::{DepthSort, PieceCorner, PieceCut, SortedPiece},
    },
    illumination::Illumination,
    slopes::Slopes,
    space::Rect,
    target::Target,
};

/// What [`draw_sorted`] works in, lent by the caller.
#[derive(Debug)]
pub struct DepthSortMemory<'m> {
    /// One for each vertex of all instances.
    pub vertices: &'m mut [MeshVertex],
    /// Room for the faces that show in the picture: those that face the eye, about half of closed solids.
    pub faces: &'m mut VecView<ListedFace>,
    /// As much as for faces, and one more for each split.
    pub pieces: &'m mut VecView<SortedPiece>,
    /// Three for each face, and for each split the number of corners of what is split and four; at most 65,535.
    pub corners: &'m mut VecView<PieceCorner>,
    /// Two for each split.
    pub cuts: &'m mut VecView<PieceCut>,
}

/// Draws a scene by depth sort: from the farthest face to the nearest, those split that hide each other.
///
/// What is seen is what a depth buffer shows; where two faces are at [almost](crate::hidden::painter) the same depth, either
/// may be the one that is. Of faces in one plane the earlier one is seen.
///
/// It is the method for shadings that depend on what is behind: it draws all that shows, so leaves with holes
/// ([dropped](Shading::DROPS) pixels) and translucent surfaces are right, which no other method does. Pixels are given once
/// for each face that covers them, so a target should be cheap to write. For opaque scenes of many faces take
/// [`draw_scene`](super::draw_scene); for one solid that does not change, [`draw_tree`](super::draw_tree).
///
/// Memory: 12 bytes a vertex, 68 a face, and at each split 20 and two cuts of 32 and seven or more corners of 12; none for
/// pixels. Cost: see [`painter`](crate::hidden::painter).
///
/// ```
/// # use aquatint::{Angle, Frame, Levels, Dithered, Light, Matrix, Rect, Rows, Scalar, Vector3, View, World};
/// # use aquatint::{geometry::{light::Lamp, projection::Lens, viewport::Viewport}, pipeline::{Camera, MeshVertex, Scene}};
/// # use embedded_graphics::pixelcolor::BinaryColor;
/// use aquatint::{model::solids::TETRAHEDRON, pipeline::{DepthSortMemory, Instance, draw_sorted}};
/// use heapless::Vec;
/// # let one = Scalar::ONE;
/// # let lens = Lens { field_of_view: Angle::from_degrees(40.0), aspect: one, near: one, far: one * 8 };
/// # let camera = Camera {
/// #     view: Matrix::<World, View>::translation(Scalar::ZERO, Scalar::ZERO, one * -5),
/// #     projection: Matrix::perspective(lens)?,
/// #     viewport: Viewport::new(Rect::new(0, 0, 64, 64))?,
/// # };
/// # let direction = Vector3::new(one, one, one);
/// # let scene = Scene { camera, light: Lamp { direction, ambient: Light(9000), diffuse: Light(50_000) } };
/// # let mut frame = Frame::<BinaryColor, Rows, _>::with_array([0; 512], 64, 64)?;
/// # let mut target = Dithered::new(&mut frame, Levels::ONE_BIT);
///
/// // Two solids, one through the other.
/// let pair = [0.0, 90.0].map(|angle| Instance::new(TETRAHEDRON, Matrix::rotation_z(Angle::from_degrees(angle))));
/// let memory = DepthSortMemory {
///     vertices: &mut [MeshVertex::EMPTY; 24],
///     faces: &mut Vec::<_, 8>::new(),
///     pieces: &mut Vec::<_, 24>::new(),
///     corners: &mut Vec::<_, 160>::new(),
///     cuts: &mut Vec::<_, 32>::new(),
/// };
/// draw_sorted(&pair, &scene, memory, &mut target)?;
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
///
/// # Errors
/// [`DrawError`]. Nothing is drawn if there is not enough room.
pub fn draw_sorted<S, B, L, T, const N: usize>(
    instances: &[Instance<'_, S, B>; N],
    scene: &Scene<L>,
    memory: DepthSortMemory<'_>,
    target: &mut T,
) -> Result<(), DrawError<T::Error>>
where
    S: Shading,
    B: Bounds,
    L: Lighting,
    T: Target<Color = S::Color>,
{
    const { assert!(N <= 256, "the instance of a face is a byte") };
    let DepthSortMemory { vertices, faces, pieces, corners, cuts } = memory;
    let window = target.bounds().intersection(scene.camera.viewport.rect());
    let mut surfaces = Vec::<_, N>::new();
    prepare(instances, scene, vertices, &mut surfaces).map_err(DrawError::before_drawing)?;
    let mut sorted = DepthSort::new(pieces, corners, cuts, scene.camera.viewport.rect());
    list_sorted(&surfaces, window, faces, &mut sorted).map_err(DrawError::before_drawing)?;
    sorted.order().map_err(|_| DrawError::TooFewPieces)?;
    let mut hidden = Convex;
    let mut fragments = Fragments::new(scene.camera.viewport, &mut hidden, target);
    for (face, chain) in sorted.pieces() {
        let Some(face) = faces.get(usize::from(face)) else { continue };
        let Some((surface, piece)) = face.placed(&surfaces) else { continue };
        let drawn = fragments.draw_within(&chain, surface, (&face.triangle(), &piece));
        drawn.map_err(DrawError::Target)?;
    }
    Ok(())
}

/// Puts the faces that show into the list and among the pieces.
#[inline(never)]
fn list_sorted<S: Shading, I: Illumination>(
    surfaces: &[Surface<'_, S, I>],
    window: Rect,
    faces: &mut VecView<ListedFace>,
    sorted: &mut DepthSort<'_>,
) -> Result<(), DrawError<Infallible>> {
    faces.clear();
    let room = faces.capacity().min(sorted.room());
    list(surfaces, window, &mut |listed, surface, piece, _| {
        faces.len() < room
            && faces.push(listed).is_ok()
            && sorted.add(&piece.positions, biased(surface.bias, piece)).is_ok()
    })
}

/// The depths of the corners, with their bias.
fn biased<A>(bias: DepthBias, piece: &Piece<A>) -> [u32; 3] {
    if bias == DepthBias::NONE {
        return piece.depths;
    }
    let plane = depth_plane(DepthBias::NONE, &Slopes::new(&piece.positions), piece.depths);
    bias.moved(piece.depths, plane.steepest())
}
