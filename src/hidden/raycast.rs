//! Rays per pixel: for each of them, what it hits first. Lecture 5.2.
//!
//! ```text
//!                 │ ·          ╭───╮
//!        eye ●────┼─·─────────▶│   │╲ given back:           a ray for each pixel centre;
//!                 │ ·          ╰───╯  ╲  a mirror           nearest hit, then from there
//!            pixels            ╱        ▼                   a ray to the lamp, and one more
//!                         to the lamp: shadows              where there is a mirror
//! ```
//!
//! - **Takes** a [`Ray`], and [`Objects`]: a slice of [`Shape`]s, or a [`Hierarchy`] over one.
//! - **Gives** the nearest [`Hit`]: distance, place, normal, and the number of the shape.
//! - **Range** the world is the cube of ±[`REACH`] (64) along all axes. What lies outside is refused when a shape or a ray is made;
//!   planes end at its borders.
//! - **Memory** 40 bytes a shape; a hierarchy 32 bytes more, lent by the caller.
//! - **Error** places are within 2⁻¹⁵ of the ray, and of the exact place along it; of triangles 2⁻¹⁹ over the cosine at which they are
//!   struck come to that. A sphere may be off by 2⁻¹⁹ sideways, which moves grazing hits by up to 2⁻⁹·√r. Normals are within
//!   2⁻¹² of the exact ones, those of spheres within 2⁻¹⁵/r more.
//! - **Cost** no division and no floating point but for what is hit. A box that is missed costs twelve products of 32 bits, and a
//!   ray through `k` shapes of a surface looks at [some log₂ k](Hierarchy) of them. In instructions of a Cortex-M0:
//!
//! | | |
//! |---|---|
//! | a ray, and the beginning of its search | 1,000 and 400 |
//! | a shape of a slice that is missed by its box | 340 |
//! | a triangle that is missed within its box | 1,500 |
//! | what is hit first, with its normal: plane, block, sphere, triangle | 2,400, 2,600, 3,800, 4,200 |
//! | the nearest of 8, 64, 512 triangles side by side, in a slice | 8,700, 28,900, 173,800 |
//! | in a hierarchy | 7,400, 10,100, 13,400 |
//! | a pixel of five shapes with shadows and a mirror, [drawn](crate::pipeline::draw_rays) from a slice, from a hierarchy | 7,500, 6,400 |

mod block;
mod bounds;
mod hierarchy;
mod median;
mod plane;
mod ray;
mod search;
mod sphere;
mod triangle;

pub use block::Block;
use bounds::Bounds;
pub use hierarchy::{Hierarchy, HierarchyError, MOST_SHAPES, Node};
pub use plane::Plane;
pub use ray::Ray;
pub use search::Objects;
pub use sphere::Sphere;
pub use triangle::Triangle;

use crate::{
    error::OutOfRange,
    num::{Scalar, format_fixed},
    space::{Point3, Vector3, World},
};

/// How far from zero a coordinate of shapes and rays may be: 64.
pub const REACH: Scalar = Scalar::from_bits(64 << 16);

/// How far above a surface the rays begin that leave it, so that they do not hit it again: 2⁻¹⁰.
pub const BIAS: Scalar = Scalar::from_bits(1 << 6);

/// Something that a ray can hit.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub enum Shape {
    /// A ball.
    Sphere(Sphere),
    /// An endless plane.
    Plane(Plane),
    /// A triangle, as of a mesh.
    Triangle(Triangle),
    /// A box along the axes.
    Block(Block),
}

impl Shape {
    /// Something to fill an array with: no ray hits it.
    pub const NOTHING: Self = Self::Triangle(Triangle::POINT);

    /// A box around it; a plane has none.
    #[inline]
    fn bounds(&self) -> Option<Bounds> {
        match self {
            Self::Sphere(sphere) => Some(sphere.bounds()),
            Self::Plane(_) => None,
            Self::Triangle(triangle) => Some(triangle.bounds()),
            Self::Block(block) => Some(block.bounds()),
        }
    }

    /// The parameter at which a ray hits it first.
    fn hit(&self, ray: &Ray) -> Option<u32> {
        match self {
            Self::Sphere(sphere) => sphere.hit(ray),
            Self::Plane(plane) => plane.hit(ray),
            Self::Triangle(triangle) => triangle.hit(ray),
            Self::Block(block) => block.hit(ray),
        }
    }

    /// At right angles to it in a place of its surface, of any length, to any side.
    fn normal(&self, place: [i32; 3]) -> [i32; 3] {
        match self {
            Self::Sphere(sphere) => sphere.normal(place),
            Self::Plane(flat) => flat.normal(),
            Self::Triangle(triangle) => triangle.normal(),
            Self::Block(block) => block.normal(place),
        }
    }
}

/// Where a ray hits a shape.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[non_exhaustive]
pub struct Hit {
    /// From the origin of the ray.
    pub distance: Scalar,
    /// Where.
    pub position: Point3<World>,
    /// Of length 1, at right angles to the surface, towards where the ray came from.
    pub normal: Vector3<World>,
    /// Which shape, counted from 0.
    pub number: usize,
}

format_fixed! {
    impl[] |it: Hit| "Hit {{ distance: {}, position: {}, normal: {}, number: {} }}",
    Fixed(it.distance), it.position, it.normal, it.number
}

impl Hit {
    /// The ray from here in a direction, from a [`BIAS`] above the surface: towards a lamp far away.
    #[must_use]
    pub fn towards(&self, direction: Vector3<World>) -> Ray {
        Ray::along(self.lifted(), [direction.x, direction.y, direction.z].map(|v| v.to_bits().into()))
    }

    /// The ray from here to a place, from a [`BIAS`] above the surface: towards a lamp that is near.
    ///
    /// # Errors
    /// [`OutOfRange`] for a place more than [`REACH`] from zero along an axis.
    pub fn ray_to(&self, place: Point3<World>) -> Result<Ray, OutOfRange> {
        let [x, y, z] = self.lifted().map(Scalar::from_bits);
        Ray::between(Point3::new(x, y, z), place)
    }

    /// The place above the surface.
    fn lifted(&self) -> [i32; 3] {
        let Self { position: p, normal: n, .. } = self;
        [(p.x, n.x), (p.y, n.y), (p.z, n.z)].map(|(place, normal)| {
            let lifted = place.to_bits().saturating_add((normal.to_bits().saturating_add(1 << 9)) >> 10);
            lifted.clamp(-REACH.to_bits(), REACH.to_bits())
        })
    }
}
