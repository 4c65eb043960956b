//! The picture by rays: for each pixel what its ray hits, the light there, its shadow and one mirror. Lecture 5.2.
//!
//! ```text
//!   pixels ─▶ ray ─▶ nearest hit ─▶ lamp, unless a ray to it is blocked ─▶ light ─▶ target
//!                         └─ mirror: ray ─▶ nearest hit ─▶ lamp, unless … ─┘
//! ```
//!
//! No frame and no depth buffer: rows are made one after the other, so bands of a picture are the same as the whole.

use super::{Instance, PixelRays};
use crate::{
    colour::Light,
    error::{OutOfRange, describe},
    geometry::light::{Lamp, ModelLamp},
    hidden::raycast::{Hit, Objects, Ray, Shape, Triangle},
    illumination::Illumination,
    matrix::Matrix,
    num::{Scalar, saturate_i16},
    space::{Model, Point3},
    target::Target,
};

/// How a shape gives back light.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct Finish {
    /// In all directions alike, out of 65535: how white it is.
    pub diffuse: u16,
    /// How much of what is seen is seen in the mirror, out of 65535.
    pub mirror: u16,
}

impl Finish {
    /// White and no mirror.
    pub const MATTE: Self = Self { diffuse: u16::MAX, mirror: 0 };
    /// Nearly all mirror.
    pub const MIRROR: Self = Self { diffuse: u16::MAX, mirror: 55_000 };
}

/// What rays find.
///
/// ```
/// use aquatint::{
///     Angle, Dithered, Frame, Levels, Light, Matrix, Point3, Rect, Rows, Scalar, Vector3,
///     geometry::{light::Lamp, projection::Lens, viewport::Viewport},
///     hidden::raycast::{Plane, Shape, Sphere},
///     pipeline::{Camera, Finish, PixelRays, Raycast, draw_rays},
/// };
/// use embedded_graphics::pixelcolor::BinaryColor;
///
/// let [nil, one, four] = [0, 1, 4].map(Scalar::from_num);
/// let up = Vector3::new(nil, one, nil);
/// let floor = Plane::new(Point3::new(nil, -one, nil), up)?;
/// let ball = Sphere::new(Point3::ORIGIN, one)?;
/// let scene = Raycast {
///     objects: &[Shape::Plane(floor), Shape::Sphere(ball)][..],
///     finishes: &[Finish::MATTE, Finish::MIRROR],
///     lamp: Lamp { direction: Vector3::new(one, one, one), ambient: Light(6_000), diffuse: Light(50_000) },
///     background: Light(20_000),
/// };
///
/// let lens = Lens { field_of_view: Angle::from_degrees(50.0), aspect: one * 2, near: one, far: four * 8 };
/// let camera = Camera {
///     view: Matrix::look_at(Point3::new(nil, one, four), Point3::ORIGIN, up).expect("they differ"),
///     projection: Matrix::perspective(lens).expect("a lens"),
///     viewport: Viewport::new(Rect::new(0, 0, 128, 64)).expect("pixels"),
/// };
/// let rays = PixelRays::new(&camera).expect("an eye");
/// let mut frame = Frame::<BinaryColor, Rows, _>::with_array([0; 1024], 128, 64).unwrap();
/// draw_rays(&scene, &rays, &mut Dithered::new(&mut frame, Levels::ONE_BIT)).unwrap();
/// # Ok::<(), aquatint::OutOfRange>(())
/// ```
#[derive(Clone, Copy, Debug)]
pub struct Raycast<'a, O> {
    /// A slice of shapes, or a [hierarchy](crate::hidden::raycast::Hierarchy).
    pub objects: O,
    /// Of each shape, by its number; the last one is for all shapes from there on. [Matte](Finish::MATTE) if there is none.
    pub finishes: &'a [Finish],
    /// What throws shadows, and the light that is in them.
    pub lamp: Lamp,
    /// What is seen where nothing is.
    pub background: Light,
}

/// Draws what the rays of a view find: every pixel of it that the target has.
///
/// The light of a pixel takes one ray, one more to the lamp where that shines on it, and twice as many in a mirror; what
/// a mirror shows has no mirror itself.
///
/// # Errors
/// What the target says.
pub fn draw_rays<O, T>(scene: &Raycast<'_, O>, rays: &PixelRays, target: &mut T) -> Result<(), T::Error>
where
    O: Objects,
    T: Target<Color: From<Light>>,
{
    let tracer = Tracer { scene, lamp: scene.lamp.in_model_space(&Matrix::IDENTITY) };
    let seen = rays.rect().intersection(target.bounds());
    if seen.is_empty() {
        return Ok(());
    }
    for row in seen.rows() {
        target.write_all(row, seen.columns(), rays.run(row, seen.columns()).map(|ray| tracer.seen(&ray).into()))?;
    }
    Ok(())
}

/// A scene on its way.
struct Tracer<'s, 'a, O> {
    scene: &'s Raycast<'a, O>,
    /// In the world, as if it were an object.
    lamp: ModelLamp,
}

impl<O: Objects> Tracer<'_, '_, O> {
    /// The light that comes back along a ray.
    fn seen(&self, ray: &Ray) -> Light {
        let Some(hit) = self.scene.objects.nearest(ray) else { return self.scene.background };
        let (lit, mirror) = (self.lit(&hit), self.finish(&hit).mirror);
        if mirror == 0 {
            return lit;
        }
        let mirrored = self.scene.objects.nearest(&ray.reflected(&hit));
        let mirrored = mirrored.map_or(self.scene.background, |other| self.lit(&other));
        Light(lit.reflected(u16::MAX - mirror).0.saturating_add(mirrored.reflected(mirror).0))
    }

    /// The lamp's light where a ray has hit, and only the light of the shadow if something is in between.
    fn lit(&self, hit: &Hit) -> Light {
        let normal = [hit.normal.x, hit.normal.y, hit.normal.z].map(|v| saturate_i16((v.to_bits() >> 2).into()));
        let (bright, dark) = (self.lamp.on([0; 3], normal), self.lamp.on([0; 3], [0; 3]));
        let is_dark = bright == dark || self.scene.objects.is_hit(&hit.towards(self.scene.lamp.direction));
        (if is_dark { dark } else { bright }).reflected(self.finish(hit).diffuse)
    }

    fn finish(&self, hit: &Hit) -> Finish {
        let finishes = self.scene.finishes;
        *finishes.get(hit.number).or(finishes.last()).unwrap_or(&Finish::MATTE)
    }
}

/// Why a mesh was not made shapes.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub enum MeshShapesError {
    /// There is not one shape for each triangle.
    TooFewShapes {
        /// How many are needed.
        needed: usize,
    },
    /// A corner is more than [`REACH`](crate::hidden::raycast::REACH) from zero along an axis.
    OutOfRange,
}

describe! { MeshShapesError,
    Self::TooFewShapes { needed } => "{needed} shapes are needed";
    Self::OutOfRange => "{OutOfRange}";
}

/// Puts the triangles of a mesh, where it is placed, into the first of some shapes; gives how many they are.
///
/// For a further mesh, lend what is behind them. Planes that cut the instance play no part, and both sides of its faces are seen.
///
/// # Errors
/// [`MeshShapesError`].
///
/// ```
/// use aquatint::{Matrix, hidden::raycast::{Hierarchy, Node, Shape}, model::solids::CUBE, pipeline::{Instance, mesh_shapes}};
///
/// let mut shapes = [Shape::NOTHING; 20];
/// let used = mesh_shapes(&Instance::new(CUBE, Matrix::IDENTITY), &mut shapes)?;
/// let mut nodes = [Node::default(); 2 * 20];
/// let hierarchy = Hierarchy::new(&shapes[..used], &mut nodes).expect("two for each");
/// # let _ = hierarchy;
/// # assert_eq!(used, 12);
/// # Ok::<(), aquatint::pipeline::MeshShapesError>(())
/// ```
pub fn mesh_shapes<S, B>(instance: &Instance<'_, S, B>, shapes: &mut [Shape]) -> Result<usize, MeshShapesError> {
    let (mesh, needed) = (instance.mesh, instance.mesh.triangles().count());
    let shapes = shapes.get_mut(..needed).ok_or(MeshShapesError::TooFewShapes { needed })?;
    let corner = |index: u16| {
        let place = mesh.positions().get(usize::from(index)).copied().unwrap_or_default();
        // 2.14 to 16.16.
        let [x, y, z] = place.map(|v| Scalar::from_bits(i32::from(v) << 2));
        let world = instance.placement.transform_point(Point3::<Model>::new(x, y, z));
        Point3::new(world.x, world.y, world.z)
    };
    for (shape, triangle) in shapes.iter_mut().zip(mesh.triangles()) {
        let triangle = Triangle::new(triangle.map(corner)).map_err(|OutOfRange| MeshShapesError::OutOfRange)?;
        *shape = Shape::Triangle(triangle);
    }
    Ok(needed)
}
