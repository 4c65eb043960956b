//! The conductor: from the vertices of a mesh to light on a target. Lecture 1.1.2 and 2.
//!
//! ```text
//!   mesh ─▶ transform, light ─▶ clip ─▶ project ─▶ back faces ─▶ triangles ─▶ depth ─▶ light
//!           each vertex once             each triangle ……………………………… each pixel
//! ```
//!
//! The only module that knows more than one stage. Each function here is one arrow.

use core::{error::Error, fmt, ops::Range};

use heapless::vec::Vec;

use crate::{
    clip::{
        sutherland_hodgman::{self, Crossing, Cut},
        volume::{self, Plane},
    },
    colour::Light,
    error::OutOfRange,
    geometry::{
        face::is_front,
        light::Lamp,
        transform::MeshTransform,
        viewport::{ScreenPoint, Viewport},
    },
    hidden::depth::{DepthBuffer, is_nearer},
    illumination::Illumination,
    matrix::Matrix,
    model::mesh::Mesh,
    num::{Scalar, high_u16},
    raster::triangle::Triangle,
    space::{Clip, Model, Point2, Point4, Rect, View, World},
    span::Sink,
    target::Target,
    vary::{Ramp, Vertex},
};

/// A mesh, put somewhere.
#[derive(Clone, Copy, Debug)]
pub struct Instance<'a> {
    /// What.
    pub mesh: Mesh<'a>,
    /// Where: any rotations and translations, and scales that are the same along all axes.
    pub placement: Matrix<Model, World>,
}

/// From where, through what, onto which part of the screen, and in what light.
#[derive(Clone, Copy, Debug)]
pub struct Camera {
    /// The place and direction of the eye.
    pub view: Matrix<World, View>,
    /// The lens.
    pub projection: Matrix<View, Clip>,
    /// The pixels that the view fills.
    pub viewport: Viewport,
    /// The light of the scene.
    pub lamp: Lamp,
}

/// A vertex after transform and light: 12 bytes. Lend the pipeline one for each vertex of a mesh.
#[derive(Clone, Copy, Debug, Default)]
pub struct MeshVertex {
    /// [`UNPROJECTED`](Self::UNPROJECTED) when it must be clipped first.
    position: Point2,
    depth: u16,
    light: Light,
}

/// What the pipeline works in.
#[derive(Debug)]
pub struct Workspace<'w, 'd> {
    /// One for each vertex of the largest mesh; their contents do not matter.
    pub vertices: &'w mut [MeshVertex],
    /// Shared by all instances of a picture; clear it between pictures.
    pub depth: &'w mut DepthBuffer<'d>,
}

/// Why a mesh was not drawn.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum DrawError<E> {
    /// The workspace holds fewer vertices than the mesh has. Nothing was drawn.
    TooFewVertices {
        /// How many are needed.
        needed: usize,
    },
    /// Placement, view and projection may take a vertex more than 4096 from the origin of clip
    /// space. Nothing was drawn.
    OutOfRange,
    /// The target failed while drawing.
    Target(E),
}

impl<E: fmt::Display> fmt::Display for DrawError<E> {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::TooFewVertices { needed } => write!(f, "{needed} vertices are needed"),
            Self::OutOfRange => OutOfRange.fmt(f),
            Self::Target(error) => error.fmt(f),
        }
    }
}

impl<E: Error + 'static> Error for DrawError<E> {
    fn source(&self) -> Option<&(dyn Error + 'static)> {
        if let Self::Target(error) = self { Some(error) } else { None }
    }
}

/// Draws a mesh: lit at its vertices, Gouraud shaded, hidden surfaces removed by depth.
///
/// Where it covers pixels of the workspace's depth buffer and of `target`, the nearest surface stays.
/// Give it [`Dithered`](crate::Dithered) on a frame, or any other target of light. A target that
/// is a band of a picture, with a depth buffer of that band, gets the same pixels as the whole.
///
/// Memory: 12 bytes a vertex and 2 bytes a pixel, lent by the caller; about 1 kB of stack.
///
/// # Errors
/// [`DrawError`].
pub fn draw_mesh<T: Target<Color = Light>>(
    instance: &Instance<'_>,
    camera: &Camera,
    workspace: &mut Workspace<'_, '_>,
    target: &mut T,
) -> Result<(), DrawError<T::Error>> {
    let mesh = instance.mesh;
    let to_clip = instance.placement.then(&camera.view).then(&camera.projection);
    let transform = MeshTransform::new(&to_clip).map_err(|OutOfRange| DrawError::OutOfRange)?;
    let needed = mesh.positions().len();
    let vertices = workspace.vertices.get_mut(..needed).ok_or(DrawError::TooFewVertices { needed })?;
    process_vertices(instance, camera, &transform, vertices);

    let bounds = camera.viewport.rect().intersection(workspace.depth.window()).intersection(target.bounds());
    let mut fragments = Fragments { depth: workspace.depth, bounds, target };
    for [a, b, c] in mesh.triangles() {
        let at = |index: u16| vertices.get(usize::from(index)).copied().unwrap_or_default();
        let corners = [at(a), at(b), at(c)];
        if corners.iter().all(MeshVertex::is_projected) {
            draw_front(&corners, &mut fragments).map_err(DrawError::Target)?;
        } else {
            let place = |index: u16| mesh.positions().get(usize::from(index)).copied().unwrap_or_default();
            let clip =
                |index, corner: MeshVertex| ClipVertex { point: transform.apply(place(index)), light: corner.light };
            let [p, q, r] = corners;
            let polygon = clipped([clip(a, p), clip(b, q), clip(c, r)]);
            draw_fan(&polygon, camera.viewport, &mut fragments).map_err(DrawError::Target)?;
        }
    }
    Ok(())
}

/// Vertex transform and lighting, once for each vertex.
fn process_vertices(instance: &Instance<'_>, camera: &Camera, transform: &MeshTransform, vertices: &mut [MeshVertex]) {
    let lamp = camera.lamp.in_model_space(&instance.placement);
    let mesh = instance.mesh;
    for ((vertex, &position), &normal) in vertices.iter_mut().zip(mesh.positions()).zip(mesh.normals()) {
        let (point, light) = (transform.apply(position), lamp.on_vertex(position, normal));
        *vertex = if volume::outcode(&point) == 0 {
            MeshVertex::new(camera.viewport.project(&point), light)
        } else {
            MeshVertex { light, ..MeshVertex::UNPROJECTED }
        };
    }
}

impl MeshVertex {
    /// Something to fill an array with. All its bytes are zero, so that a static array takes no flash.
    pub const EMPTY: Self = Self { position: Point2::from_sixteenths(0, 0), depth: 0, light: Light::BLACK };

    /// A place that no projected vertex has.
    const UNPROJECTED: Self =
        Self { position: Point2::from_sixteenths(i32::MIN, i32::MIN), depth: 0, light: Light::BLACK };

    const fn new(point: ScreenPoint, light: Light) -> Self {
        Self { position: point.position, depth: high_u16(point.depth << 8), light }
    }

    fn is_projected(&self) -> bool {
        self.position.x.to_bits() != i32::MIN
    }

    const fn attributes(&self) -> Vertex<2> {
        Vertex { position: self.position, attributes: [self.depth, self.light.0] }
    }
}

/// A vertex in clip space.
#[derive(Clone, Copy, Debug)]
struct ClipVertex {
    point: Point4<Clip>,
    light: Light,
}

impl Cut for ClipVertex {
    fn cut(inside: Self, outside: Self, crossing: Crossing) -> Self {
        let scalar = |a: Scalar, b: Scalar| Scalar::from_bits(crossing.coordinate(a.to_bits(), b.to_bits()));
        let (a, b) = (inside.point, outside.point);
        Self {
            point: Point4::new(scalar(a.x, b.x), scalar(a.y, b.y), scalar(a.z, b.z), scalar(a.w, b.w)),
            light: Light(crossing.attribute(inside.light.0, outside.light.0)),
        }
    }
}

/// A triangle gains at most one vertex at each of the seven planes.
type ClippedTriangle = Vec<ClipVertex, { 3 + Plane::ALL.len() }>;

/// The part of a triangle inside the volume that may be projected.
fn clipped(corners: [ClipVertex; 3]) -> ClippedTriangle {
    let (mut polygon, mut next) = (ClippedTriangle::new(), ClippedTriangle::new());
    let codes = corners.map(|corner| volume::outcode(&corner.point));
    let [a, b, c] = codes;
    if a & b & c != 0 || polygon.extend_from_slice(&corners).is_err() {
        return polygon;
    }
    for (index, plane) in Plane::ALL.into_iter().enumerate() {
        if (a | b | c) >> index & 1 != 0 {
            // There is room: see the capacity. Were there not, less would be drawn.
            let _ = sutherland_hodgman::clip(&polygon, |vertex| plane.distance(&vertex.point), &mut next);
            core::mem::swap(&mut polygon, &mut next);
        }
    }
    polygon
}

/// A convex polygon, as a fan of triangles.
fn draw_fan<T: Target<Color = Light>>(
    polygon: &[ClipVertex],
    viewport: Viewport,
    fragments: &mut Fragments<'_, '_, T>,
) -> Result<(), T::Error> {
    let project = |vertex: &ClipVertex| MeshVertex::new(viewport.project(&vertex.point), vertex.light);
    let [first, rest @ ..] = polygon else { return Ok(()) };
    let first = project(first);
    for pair in rest.windows(2) {
        if let [second, third] = pair {
            draw_front(&[first, project(second), project(third)], fragments)?;
        }
    }
    Ok(())
}

/// A triangle on the screen, unless it shows its back.
fn draw_front<T: Target<Color = Light>>(
    corners: &[MeshVertex; 3],
    fragments: &mut Fragments<'_, '_, T>,
) -> Result<(), T::Error> {
    let [a, b, c] = corners.map(|corner| corner.position);
    if !is_front(a, b, c) {
        return Ok(());
    }
    // Projected corners are within the guard band, so always in range.
    match Triangle::new(corners.map(|corner| corner.attributes())) {
        Ok(triangle) => triangle.spans(fragments),
        Err(_) => Ok(()),
    }
}

/// Fragment processing: the depth test and the light of each pixel in one pass.
struct Fragments<'f, 'd, T> {
    depth: &'f mut DepthBuffer<'d>,
    bounds: Rect,
    target: &'f mut T,
}

impl<T: Target<Color = Light>> Sink<Ramp<2>> for Fragments<'_, '_, T> {
    type Error = T::Error;

    fn bounds(&self) -> Rect {
        self.bounds
    }

    fn span(&mut self, row: i32, columns: Range<i32>, ramp: Ramp<2>) -> Result<(), T::Error> {
        let Some(stored) = self.depth.run(row, columns.clone()) else { return Ok(()) };
        let fragments = stored.iter_mut().zip(ramp);
        let lights = fragments.map(|(stored, [depth, light])| is_nearer(stored, depth).then_some(Light(light)));
        self.target.write_run(row, columns, lights)
    }
}
