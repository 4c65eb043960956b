//! Pictures of small scenes by comparing each face with all others: no memory for pixels. Lecture 5.1.

use core::convert::Infallible;

use heapless::vec::{Vec, VecView};

use super::{
    Bounds, DrawError, Instance, MeshVertex, Scene,
    fragments::{Fragments, depth_plane},
    listed::{ListedFace, list, prepare},
    surface::Surface,
};
use crate::{
    fragment::shade::Shading,
    geometry::light::Lighting,
    hidden::{
        convex::Convex,
        object_space::{ComparedFace, PartBound, VisibleParts, most_bounds, numbers},
    },
    illumination::Illumination,
    slopes::Slopes,
    space::Rect,
    target::Target,
};

/// What [`draw_compared`] works in, lent by the caller.
#[derive(Debug)]
pub struct ObjectSpaceMemory<'m> {
    /// One for each vertex of all instances.
    pub vertices: &'m mut [MeshVertex],
    /// Room for the faces that show in the picture: those that face the eye, about half of closed solids.
    pub faces: &'m mut VecView<ListedFace>,
    /// As much as for faces.
    pub compared: &'m mut VecView<ComparedFace>,
    /// Four for each face that may meet one and the same face on the screen are always enough. Mostly few are needed, which
    /// a look at all parts before the first is drawn must find out then.
    pub bounds: &'m mut VecView<PartBound>,
}

/// Draws a scene in object space: what is seen of each face is found by comparing it with every other face.
///
/// The picture is that of [`draw_mesh`](super::draw_mesh) with a depth buffer of 32 bits, to the pixel, and each pixel is given
/// once. It is the method for scenes of some ten faces, whatever the size of the picture, and for targets that must not be
/// given a pixel twice, or that take the pixels of a face together. For more faces take [`draw_scene`](super::draw_scene).
///
/// Memory: 12 bytes a vertex, 48 a face, 40 a bound; none for pixels. Cost: see [`object_space`](crate::hidden::object_space).
///
/// ```
/// # use aquatint::{Angle, Frame, Levels, Dithered, Light, Matrix, Rect, Rows, Scalar, Vector3, View, World};
/// # use aquatint::{geometry::{light::Lamp, projection::Lens, viewport::Viewport}, pipeline::{Camera, MeshVertex, Scene}};
/// # use embedded_graphics::pixelcolor::BinaryColor;
/// use aquatint::{model::solids::TETRAHEDRON, pipeline::{Instance, ObjectSpaceMemory, draw_compared}};
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
/// let memory = ObjectSpaceMemory {
///     vertices: &mut [MeshVertex::EMPTY; 24],
///     faces: &mut Vec::<_, 8>::new(),
///     compared: &mut Vec::<_, 8>::new(),
///     bounds: &mut Vec::<_, 28>::new(),
/// };
/// draw_compared(&pair, &scene, memory, &mut target)?;
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
///
/// # Errors
/// [`DrawError`]. Nothing is drawn if there is not enough room.
pub fn draw_compared<S, B, L, T, const N: usize>(
    instances: &[Instance<'_, S, B>; N],
    scene: &Scene<L>,
    memory: ObjectSpaceMemory<'_>,
    target: &mut T,
) -> Result<(), DrawError<T::Error>>
where
    S: Shading,
    B: Bounds,
    L: Lighting,
    T: Target<Color = S::Color>,
{
    const { assert!(N <= 256, "the instance of a face is a byte") };
    const { assert!(!S::DROPS, "a shading that leaves out pixels does not hide what is behind them") };
    let ObjectSpaceMemory { vertices, faces, compared, bounds } = memory;
    let window = target.bounds().intersection(scene.camera.viewport.rect());
    let mut surfaces = Vec::<_, N>::new();
    prepare(instances, scene, vertices, &mut surfaces).map_err(DrawError::before_drawing)?;
    list_compared(&surfaces, window, faces, compared).map_err(DrawError::before_drawing)?;
    check_room(compared, bounds, window).map_err(DrawError::before_drawing)?;
    let mut hidden = Convex;
    let mut fragments = Fragments::new(scene.camera.viewport, &mut hidden, target);
    for (number, face) in numbers(compared).zip(faces.iter()) {
        let Some(mut parts) = VisibleParts::new(compared, number, bounds, window) else { continue };
        let Some((surface, piece)) = face.placed(&surfaces) else { continue };
        // There is room: that was found out.
        while parts.advance() == Ok(true) {
            let drawn = fragments.draw_within(parts.bounds(), surface, (&face.triangle(), &piece));
            drawn.map_err(DrawError::Target)?;
        }
    }
    Ok(())
}

/// Puts the faces that show into both lists.
#[inline(never)]
fn list_compared<S: Shading, I: Illumination>(
    surfaces: &[Surface<'_, S, I>],
    window: Rect,
    faces: &mut VecView<ListedFace>,
    compared: &mut VecView<ComparedFace>,
) -> Result<(), DrawError<Infallible>> {
    faces.clear();
    compared.clear();
    list(surfaces, window, &mut |listed, surface, piece, _| {
        if faces.len() >= usize::from(u16::MAX) || compared.is_full() {
            return false;
        }
        let plane = depth_plane(surface.bias, &Slopes::new(&piece.positions), piece.depths);
        faces.push(listed).is_ok() && compared.push(ComparedFace::new(piece.positions, &plane)).is_ok()
    })
}

/// Finds out whether there is room for the bounds of all parts.
#[inline(never)]
fn check_room(
    compared: &[ComparedFace],
    bounds: &mut VecView<PartBound>,
    window: Rect,
) -> Result<(), DrawError<Infallible>> {
    let needed = most_bounds(compared, window);
    if needed <= bounds.capacity() {
        return Ok(());
    }
    for number in numbers(compared) {
        let Some(mut parts) = VisibleParts::new(compared, number, bounds, window) else { continue };
        while parts.advance().map_err(|_| DrawError::TooFewBounds { needed })? {}
    }
    Ok(())
}
