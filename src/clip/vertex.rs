//! Vertices in clip space, with whatever they carry.
//!
//! ```text
//!   ●━━━━━━━━━┿━ ━ ━ ○      the place and all attributes are cut at the same fraction of the edge
//!   x y z w   │  x y z w
//!   light, uv │  light, uv
//! ```
//!
//! Before the perspective divide everything is linear along an edge: the four coordinates, light, texture
//! coordinates. So one [`ClipVertex`] with a list of attributes serves every way to fill a triangle or to draw a line.

use crate::space::{Clip, Point3, Point4};

use super::crossing::{Crossing, Cut, Mixer};

/// A vertex that has a place in clip space.
pub trait Homogeneous: Copy {
    /// The place.
    fn point(&self) -> Point4<Clip>;
}

/// A place in clip space and `N` attributes of it: 16 bytes and 2 for each attribute, filled up to a multiple of 4.
///
/// ```
/// use aquatint::{ClipVertex, Clip, Point4, Scalar, clip::{liang_barsky_3d, volume::Volume}};
///
/// let vertex = |x: i32, light| {
///     let [x, nil, one] = [x, 0, 1].map(Scalar::from_num);
///     ClipVertex { point: Point4::<Clip>::new(x, nil, nil, one), attributes: [light] }
/// };
/// let (start, end) = liang_barsky_3d::clip((vertex(0, 1000), vertex(2, 3000)), Volume::View).unwrap();
/// assert_eq!((start, end), (vertex(0, 1000), vertex(1, 2000)));
/// ```
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct ClipVertex<const N: usize> {
    /// Place in clip space.
    pub point: Point4<Clip>,
    /// What is interpolated along the edges.
    pub attributes: [u16; N],
}

impl Homogeneous for Point4<Clip> {
    #[inline]
    fn point(&self) -> Point4<Clip> {
        *self
    }
}

impl<const N: usize> Homogeneous for ClipVertex<N> {
    #[inline]
    fn point(&self) -> Point4<Clip> {
        self.point
    }
}

impl<const N: usize> Cut for ClipVertex<N> {
    fn cut(inside: Self, outside: Self, crossing: Crossing) -> Self {
        let mixer = Mixer::new(crossing);
        Self {
            point: point_between(inside.point, outside.point, &mixer),
            attributes: mixer.attributes(inside.attributes, outside.attributes),
        }
    }
}

impl<S: Copy> Cut for Point4<S> {
    fn cut(inside: Self, outside: Self, crossing: Crossing) -> Self {
        point_between(inside, outside, &Mixer::new(crossing))
    }
}

impl<S: Copy> Cut for Point3<S> {
    fn cut(inside: Self, outside: Self, crossing: Crossing) -> Self {
        let mixer = Mixer::new(crossing);
        Self::new(
            mixer.scalar(inside.x, outside.x),
            mixer.scalar(inside.y, outside.y),
            mixer.scalar(inside.z, outside.z),
        )
    }
}

fn point_between<S: Copy>(inside: Point4<S>, outside: Point4<S>, mixer: &Mixer) -> Point4<S> {
    Point4::new(
        mixer.scalar(inside.x, outside.x),
        mixer.scalar(inside.y, outside.y),
        mixer.scalar(inside.z, outside.z),
        mixer.scalar(inside.w, outside.w),
    )
}
