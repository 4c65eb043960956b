//! The conductor: from the vertices of a mesh to light on a target. Lecture 1.1.2 and 2.
//!
//! ```text
//!   mesh ─▶ transform, light ─▶ clip ─▶ project ─▶ faces ─▶ triangles ─▶ depth ─▶ shade
//!           each vertex once             each triangle ……………………………… each pixel
//! ```
//!
//! [`draw_mesh`] fills faces, by any [`Shading`]; [`draw_wireframe`] draws their edges. Both take the same [`Instance`]s, which
//! planes may [cut](Instance::with_planes) and [bounds](Instance::with_bounds) may leave out as a whole. [`draw_rays`] goes the other
//! way: from each pixel to what is seen there.
//!
//! The only module that knows more than one stage. Each function here is one arrow.

mod bounds;
mod depth_sort;
mod draw_error;
mod draw_scene;
mod eye;
mod fragments;
mod listed;
mod object_space;
mod pixel_rays;
mod raycast;
mod scanline;
mod surface;
mod tree;
mod unpainted;
mod vertex;
mod wireframe;

use heapless::vec::Vec;

use crate::{
    clip::{clip_plane::ClipPlane, half_space::HalfSpace, volume::Plane},
    error::OutOfRange,
    fragment::shade::{Gouraud, Shading},
    geometry::{
        face::{self, Faces, Side, signed_area},
        light::{Lamp, Lighting, Lit, Surface as Reflectance},
        transform::MeshTransform,
        viewport::{ScreenPoint, Viewport, fine},
    },
    hidden::Hidden,
    illumination::Illumination,
    matrix::Matrix,
    model::{
        assembly::{Assembly, Face},
        mesh::Mesh,
    },
    space::{Clip, Model, Point2, Point3, View, World, twice_area},
    target::Target,
};
pub use bounds::Bounds;
pub use depth_sort::{DepthSortMemory, draw_sorted};
pub use draw_error::DrawError;
pub use draw_scene::{SceneMemory, draw_scene};
pub use fragments::DepthBias;
use fragments::{Fragments, MeshTriangle, Piece};
pub use listed::ListedFace;
pub use object_space::{ObjectSpaceMemory, draw_compared};
pub use pixel_rays::{NoRays, PixelRays};
pub use raycast::{Finish, MeshShapesError, Raycast, draw_rays, mesh_shapes};
pub use scanline::{ActiveFace, RowBucket, ScanlineMemory, Scanlines, WaitingFace};
use surface::Surface;
pub use tree::{TreeInstance, draw_tree};
pub use unpainted::Unpainted;
use vertex::ClipVertex;
pub use vertex::MeshVertex;
pub use wireframe::draw_wireframe;

/// A mesh, put somewhere, and what it is made of.
#[derive(Clone, Copy, Debug)]
pub struct Instance<'a, S = Gouraud, B = ()> {
    /// What.
    pub mesh: Mesh<'a>,
    /// Where: any rotations and translations, and scales that are the same along all axes.
    pub placement: Matrix<Model, World>,
    /// What it looks like.
    pub material: Material<S>,
    /// Planes that cut it, as the camera [sees them](Camera::clip_plane); what lies beyond one of them is not drawn. At most
    /// [`MOST_PLANES`].
    pub planes: &'a [ClipPlane],
    /// Where all of it lies, if that is known: see [`with_bounds`](Self::with_bounds).
    pub bounds: B,
}

impl<'a> Instance<'a> {
    /// A closed solid, matte and Gouraud shaded.
    #[must_use]
    pub const fn new(mesh: Mesh<'a>, placement: Matrix<Model, World>) -> Self {
        Self { mesh, placement, material: Material::new(Gouraud), planes: &[], bounds: () }
    }
}

impl<'a, S, B> Instance<'a, S, B> {
    /// The same of another material.
    #[must_use]
    pub fn with_material<R>(self, material: Material<R>) -> Instance<'a, R, B> {
        let Self { mesh, placement, planes, bounds, .. } = self;
        Instance { mesh, placement, material, planes, bounds }
    }

    /// The same, cut by planes.
    ///
    /// Whatever is cut is open: draw [both sides](Faces::Both) of it, or its inside is not seen. Planes cut pixels, depths,
    /// edges and all that is carried alike. Each vertex is transformed once more, and compared with each plane.
    ///
    /// ```
    /// use aquatint::{HalfSpace, Matrix, Scalar, Vector3, World, geometry::face::Faces, pipeline::Instance};
    /// # use aquatint::{Angle, Rect, View, geometry::{projection::Lens, viewport::Viewport}, pipeline::Camera};
    /// # let one = Scalar::ONE;
    /// # let lens = Lens { field_of_view: Angle::from_degrees(40.0), aspect: one, near: one, far: one * 8 };
    /// # let camera = Camera {
    /// #     view: Matrix::<World, View>::translation(Scalar::ZERO, Scalar::ZERO, one * -3),
    /// #     projection: Matrix::perspective(lens).unwrap(),
    /// #     viewport: Viewport::new(Rect::new(0, 0, 64, 64)).unwrap(),
    /// # };
    /// use aquatint::model::solids::CUBE;
    ///
    /// // What lies below half the height.
    /// let down = Vector3::new(Scalar::ZERO, -Scalar::ONE, Scalar::ZERO);
    /// let below = HalfSpace::<World>::new(down, Scalar::from_num(0.5))?;
    /// let planes = [camera.clip_plane(&below).expect("a camera")];
    /// let mut bowl = Instance::new(CUBE, Matrix::IDENTITY).with_planes(&planes);
    /// bowl.material.faces = Faces::Both;
    /// # Ok::<(), aquatint::OutOfRange>(())
    /// ```
    #[must_use]
    pub fn with_planes(self, planes: &'a [ClipPlane]) -> Self {
        Self { planes, ..self }
    }

    /// The same with a [sphere](crate::BoundingSphere) or a [box](crate::BoundingBox3) around its mesh. If the camera sees
    /// nothing of that, no vertex is looked at.
    ///
    /// ```
    /// use aquatint::{BoundingSphere, Matrix, Model, Point3, model::solids::CUBE, pipeline::Instance};
    ///
    /// // The built-in solids fit the unit sphere; a bit more for rounded places.
    /// let ball = BoundingSphere::<Model>::new(Point3::ORIGIN, 65_540);
    /// let cube = Instance::new(CUBE, Matrix::IDENTITY).with_bounds(ball);
    /// # let _ = cube;
    /// ```
    #[must_use]
    pub fn with_bounds<C: Bounds>(self, bounds: C) -> Instance<'a, S, C> {
        let Self { mesh, placement, material, planes, .. } = self;
        Instance { mesh, placement, material, planes, bounds }
    }
}

/// What a surface looks like.
#[derive(Clone, Copy, Debug)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct Material<S = Gouraud> {
    /// How its pixels get their colours.
    pub shading: S,
    /// How it gives back light.
    pub surface: Reflectance,
    /// Which of its sides are drawn.
    pub faces: Faces,
    /// How much nearer it is taken to be.
    pub bias: DepthBias,
}

impl<S> Material<S> {
    /// Matte, and seen from the front only.
    #[must_use]
    pub const fn new(shading: S) -> Self {
        Self { shading, surface: Reflectance::MATTE, faces: Faces::Front, bias: DepthBias::NONE }
    }
}

/// From where, through what, and onto which part of the screen.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct Camera {
    /// The place and direction of the eye.
    pub view: Matrix<World, View>,
    /// The lens.
    pub projection: Matrix<View, Clip>,
    /// The pixels that the view fills.
    pub viewport: Viewport,
}

impl Camera {
    /// A boundary in the world, as instances are [cut by it](Instance::with_planes). Once a picture, 37,000 instructions on a
    /// Cortex-M0.
    ///
    /// `None` if view and projection together cannot be undone.
    #[must_use]
    pub fn clip_plane(&self, side: &HalfSpace<World>) -> Option<ClipPlane> {
        side.in_clip_space(&self.view.then(&self.projection))
    }
}

/// What all instances of a picture have in common.
#[derive(Clone, Copy, Debug)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct Scene<L = Lamp> {
    /// The eye.
    pub camera: Camera,
    /// The light: a [`Lamp`], or several.
    pub light: L,
}

/// What the pipeline works in.
#[derive(Debug)]
pub struct Workspace<'w, H> {
    /// One for each vertex of the largest mesh; their contents do not matter.
    pub vertices: &'w mut [MeshVertex],
    /// What decides who is in front: a [`DepthBuffer`](crate::hidden::depth::DepthBuffer), shared by all instances of a picture and cleared between
    /// pictures, or [`Convex`](crate::hidden::convex::Convex).
    pub hidden: &'w mut H,
}

/// Draws a mesh: transformed, lit, clipped, shaded, hidden surfaces removed.
///
/// Where it covers pixels of the workspace's depth buffer and of `target`, the nearest surface stays.
/// Give it [`Dithered`](crate::Dithered) on a frame, or any other target of the shading's colour. A target that
/// is a band of a picture, with a depth buffer of that band, gets the same pixels as the whole.
///
/// Memory: 12 bytes a vertex and those of the depth buffer, lent by the caller; three to six kB of stack, by the shading.
///
/// # Errors
/// [`DrawError`].
pub fn draw_mesh<S, B, L, H, T>(
    instance: &Instance<'_, S, B>,
    scene: &Scene<L>,
    workspace: &mut Workspace<'_, H>,
    target: &mut T,
) -> Result<(), DrawError<T::Error>>
where
    S: Shading,
    B: Bounds,
    L: Lighting,
    H: Hidden,
    T: Target<Color = S::Color>,
{
    let Some(surface) = prepared(instance, scene, workspace.vertices)? else { return Ok(()) };
    let mut fragments = Fragments::new(surface.viewport, workspace.hidden, target);
    each_piece(&surface, &mut |triangle, piece| fragments.draw(&surface, triangle, piece)).map_err(DrawError::Target)
}

/// Vertex processing: everything that is done before the first triangle is looked at. `None` if nothing is seen.
///
/// Out of line, so that its matrices are off the stack when the triangles are drawn.
#[inline(never)]
fn prepared<'s, S: Shading, B: Bounds, L: Lighting, E>(
    instance: &'s Instance<'_, S, B>,
    scene: &Scene<L>,
    vertices: &'s mut [MeshVertex],
) -> Result<Option<Surface<'s, S, L::Illumination>>, DrawError<E>> {
    let Instance { mesh, placement, material, planes, bounds } = instance;
    let Camera { view, projection, viewport } = scene.camera;
    let to_clip = placement.then(&view).then(&projection);
    let transform = MeshTransform::new(&to_clip).map_err(|OutOfRange| DrawError::OutOfRange)?;
    if planes.len() > MOST_PLANES {
        return Err(DrawError::TooManyPlanes);
    }
    let needed = mesh.positions().len();
    let vertices = vertices.get_mut(..needed).ok_or(DrawError::TooFewVertices { needed })?;
    if bounds.are_outside(&to_clip) {
        return Ok(None);
    }
    let eye = if L::NEEDS_EYE { view.eye() } else { Point3::ORIGIN };
    let lit = Lit { placement, eye, surface: material.surface };
    let surface = Surface {
        mesh,
        shading: &material.shading,
        light: scene.light.for_object(&lit),
        transform,
        planes,
        viewport,
        faces: material.faces,
        bias: material.bias,
        vertices: &[],
    };
    surface.process_vertices(vertices);
    Ok(Some(Surface { vertices, ..surface }))
}

/// Every triangle that shows a side that is wanted, cut in pieces where it must be.
///
/// Out of line, so that it has the registers of a small core for itself.
#[inline(never)]
fn each_piece<S: Shading, I: Illumination, E>(
    surface: &Surface<'_, S, I>,
    take: &mut impl FnMut(&MeshTriangle, &Piece<S::Attributes>) -> Result<(), E>,
) -> Result<(), E> {
    // Plain triangles by the slice, without asking each time what they are.
    let (list, others) = match surface.mesh.assembly() {
        Assembly::Triangles(list) => (list, None),
        _ => (&[][..], Some(surface.mesh.faces())),
    };
    let listed = list.iter().enumerate().map(|(number, &corners)| Face { corners, number });
    for face in listed.chain(others.into_iter().flatten()) {
        let Some(vertices @ [a, b, c]) = surface.vertices_of(face.corners) else { continue };
        // Twice its area; nearly all triangles are short ones.
        let area = match MeshVertex::short_area(a, b, c) {
            Some(area) => area.into(),
            None if vertices.iter().all(|vertex| vertex.is_projected()) => {
                twice_area(a.position(), b.position(), c.position())
            }
            None => {
                each_clipped(surface, face, take)?;
                continue;
            }
        };
        if let Some(side) = surface.faces.shows(area) {
            take(&MeshTriangle { face, side }, &Piece::of_vertices(vertices))?;
        }
    }
    Ok(())
}

/// So many planes may cut an instance: those of a box.
pub const MOST_PLANES: usize = 6;

/// A triangle gains at most one vertex at each plane, and at each boundary of the volume.
type ClippedTriangle<A> = Vec<ClipVertex<A>, { 3 + Plane::ALL.len() + MOST_PLANES }>;

/// A triangle of which some corners cannot be projected: what is inside of the volume, as a fan.
#[inline(never)]
fn each_clipped<S: Shading, I: Illumination, E>(
    surface: &Surface<'_, S, I>,
    face: Face,
    take: &mut impl FnMut(&MeshTriangle, &Piece<S::Attributes>) -> Result<(), E>,
) -> Result<(), E> {
    // What the corners carry depends on the side that is seen, which only the projected pieces tell.
    for side in [Side::Front, Side::Back] {
        if surface.faces.includes(side) {
            let (triangle, mut polygon) = (MeshTriangle { face, side }, ClippedTriangle::new());
            clip(surface, &triangle, &mut polygon);
            each_of_fan(surface, &triangle, &polygon, take)?;
        }
    }
    Ok(())
}

/// The part of a triangle that may be projected. Out of line, so that the list it works in is off the stack then.
#[inline(never)]
fn clip<S: Shading, I: Illumination>(
    surface: &Surface<'_, S, I>,
    triangle: &MeshTriangle,
    polygon: &mut ClippedTriangle<S::Attributes>,
) {
    for corner in surface.corners(triangle) {
        let point = surface.transform.apply(corner.position);
        // There is room for three.
        let _ = polygon.push(ClipVertex { point, attributes: surface.shading.corner(&corner) });
    }
    surface.clip(polygon, &mut ClippedTriangle::new());
}

/// A convex polygon, as a fan of triangles of the side that is wanted. Out of line: nothing of it is needed while clipping.
#[inline(never)]
fn each_of_fan<S: Shading, I: Illumination, E>(
    surface: &Surface<'_, S, I>,
    triangle: &MeshTriangle,
    polygon: &[ClipVertex<S::Attributes>],
    take: &mut impl FnMut(&MeshTriangle, &Piece<S::Attributes>) -> Result<(), E>,
) -> Result<(), E> {
    let project = |vertex: &ClipVertex<S::Attributes>| {
        let ScreenPoint { position, depth } = surface.project(&vertex.point);
        (position, fine(depth), (vertex.point.w, vertex.attributes))
    };
    let start = inward_corner(polygon.iter().map(|vertex| surface.project(&vertex.point).position), triangle.side);
    let mut corners = polygon.iter().cycle().skip(start).take(polygon.len()).map(project);
    let Some((first, mut second)) = corners.next().zip(corners.next()) else { return Ok(()) };
    for third in corners {
        let corners = [first, second, third];
        second = third;
        let piece = Piece {
            positions: corners.map(|corner| corner.0),
            depths: corners.map(|corner| corner.1),
            clipped: Some(corners.map(|corner| corner.2)),
        };
        let [a, b, c] = piece.positions;
        if face::side(a, b, c) == Some(triangle.side) {
            take(triangle, &piece)?;
        }
    }
    Ok(())
}

/// The corner that a fan begins at. Rounded to sixteenths of a pixel, a corner of almost 180 degrees may point inwards:
/// from there all others are seen, from others a triangle would reach over it.
fn inward_corner(places: impl Iterator<Item = Point2> + Clone, side: Side) -> usize {
    let (here, next) = (places.clone().cycle().skip(1), places.clone().cycle().skip(2));
    let turns = places.zip(here).zip(next).map(|((before, here), next)| match side {
        Side::Front => signed_area(before, here, next),
        Side::Back => signed_area(next, here, before),
    });
    let most = turns.enumerate().max_by_key(|&(_, inwards)| inwards).filter(|&(_, inwards)| inwards > 0);
    most.map_or(0, |(before, _)| before.saturating_add(1))
}
