//! A whole scene in one call: the way for those who do not want to choose.

use core::{convert::Infallible, fmt};

use heapless::vec::Vec;

use super::{
    ActiveFace, Bounds, DrawError, Instance, MeshVertex, RowBucket, ScanlineMemory, Scanlines, Scene, WaitingFace,
};
use crate::{
    fragment::shade::{Gouraud, Shading},
    geometry::light::Lighting,
    hidden::scanline::VisibleRun,
    target::Target,
};

/// What a scene is drawn in: room for so many vertices, faces that show, and faces that reach into the same row.
///
/// 12 bytes a vertex, 16 a face, 100 an active face of Gouraud shading, 256 for buckets of rows; nothing for pixels. A const, so
/// that it can be a `static`.
pub struct SceneMemory<const VERTICES: usize, const FACES: usize, const ACTIVE: usize, S: Shading = Gouraud> {
    vertices: [MeshVertex; VERTICES],
    faces: Vec<WaitingFace, FACES>,
    buckets: [RowBucket; BUCKETS],
    active: Vec<ActiveFace<S::Face>, ACTIVE>,
    order: Vec<u16, ACTIVE>,
    runs: Vec<VisibleRun, ACTIVE>,
}

/// Buckets for the rows of a picture: of four rows each on a panel with 240.
const BUCKETS: usize = 64;

impl<const VERTICES: usize, const FACES: usize, const ACTIVE: usize, S: Shading>
    SceneMemory<VERTICES, FACES, ACTIVE, S>
{
    /// Room, and nothing in it.
    pub const NEW: Self = Self {
        vertices: [MeshVertex::EMPTY; VERTICES],
        faces: Vec::new(),
        buckets: [RowBucket::EMPTY; BUCKETS],
        active: Vec::new(),
        order: Vec::new(),
        runs: Vec::new(),
    };

    /// The same as [views](ScanlineMemory), for [`Scanlines`].
    pub fn lend(&mut self) -> ScanlineMemory<'_, S::Face> {
        let Self { vertices, faces, buckets, active, order, runs } = self;
        ScanlineMemory { vertices, faces, buckets, active, order, runs }
    }
}

impl<const VERTICES: usize, const FACES: usize, const ACTIVE: usize, S: Shading> fmt::Debug
    for SceneMemory<VERTICES, FACES, ACTIVE, S>
{
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "SceneMemory<{VERTICES}, {FACES}, {ACTIVE}>")
    }
}

/// Draws a scene: any number of instances of one [`Shading`], hidden surfaces removed among all of them.
///
/// By [`Scanlines`]: no depth buffer, each pixel is given once, and what no surface covers stays as it is. Who has the
/// memory for a depth of each pixel, or instances of several shadings, calls [`draw_mesh`](super::draw_mesh) for each
/// instance instead.
///
/// ```
/// use aquatint::{Dithered, Frame, Levels, Matrix, Rect, Rows, Scalar, Vector3, World, View, Angle, Light};
/// use aquatint::{geometry::{light::Lamp, projection::Lens, viewport::Viewport}, model::solids::CUBE};
/// use aquatint::pipeline::{Camera, Instance, Scene, SceneMemory, draw_scene};
/// use embedded_graphics::pixelcolor::BinaryColor;
///
/// let [nil, one, three] = [0, 1, 3].map(Scalar::from_num);
/// let lens = Lens { field_of_view: Angle::from_degrees(47.0), aspect: one * 2, near: one, far: one * 8 };
/// let camera = Camera {
///     view: Matrix::<World, View>::translation(nil, nil, -three),
///     projection: Matrix::perspective(lens)?,
///     viewport: Viewport::new(Rect::new(0, 0, 128, 64))?,
/// };
/// let light = Lamp { direction: Vector3::new(one, one, three), ambient: Light(4_000), diffuse: Light(60_000) };
///
/// // Two cubes, one through the other.
/// let cubes = [0.0, 30.0].map(|angle| Instance::new(CUBE, Matrix::rotation_y(Angle::from_degrees(angle))));
/// let mut memory = SceneMemory::<48, 24, 24>::NEW;
/// let mut frame = Frame::<BinaryColor, Rows, _>::with_array([0; 1024], 128, 64)?;
/// draw_scene(&cubes, &Scene { camera, light }, &mut memory, &mut Dithered::new(&mut frame, Levels::ONE_BIT))?;
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
///
/// # Errors
/// [`DrawError`]. Nothing is drawn if there is not enough room.
pub fn draw_scene<S, B, L, T, const N: usize, const VERTICES: usize, const FACES: usize, const ACTIVE: usize>(
    instances: &[Instance<'_, S, B>; N],
    scene: &Scene<L>,
    memory: &mut SceneMemory<VERTICES, FACES, ACTIVE, S>,
    target: &mut T,
) -> Result<(), DrawError<T::Error>>
where
    S: Shading,
    B: Bounds,
    L: Lighting,
    T: Target<Color = S::Color>,
{
    let mut picture = Scanlines::new(target.bounds(), memory.lend());
    picture.begin(instances, scene).map_err(DrawError::<Infallible>::before_drawing)?;
    while picture.row().is_some() {
        picture.draw_row(target).map_err(DrawError::Target)?;
    }
    Ok(())
}
