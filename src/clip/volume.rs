//! The boundaries in clip space, before the perspective divide. Lecture 3.1.3 and 3.5.
//!
//! Visible is −w ≤ x, y, z ≤ w. In front of that stands a plane of its own, w ≥ ⅛: dividing by a
//! `w` of zero or less is what makes triangles behind the eye reappear upside down.
//!
//! ```text
//!   ╲ · · · · · · · · · · · · · ╱      the guard band: −4w ≤ x, y ≤ 4w
//!     ╲     ╲ far       ╱     ╱
//!       ╲     ╲───────╱     ╱          the view: −w ≤ x, y, z ≤ w
//!         ╲ near╲───╱     ╱
//!           · ───╱─╲─── ·              w ≥ ⅛
//!                eye
//! ```
//!
//! For triangles the boundary to the sides is not the edge of the view but a *guard band* four times as wide.
//! Triangles are drawn exactly up to the window by the rasteriser anyway; cutting them only where
//! their coordinates would leave the number range means that almost none is ever cut, and that an
//! edge both of whose ends are within the guard band is the same edge for both its triangles.

use crate::{
    num::{Scalar, bits},
    space::{Clip, GUARD_BAND, LEAST_W, Point4},
};

use super::{vertex::Homogeneous, window::Boundary};

/// What is kept: everything between near and far, as far to the sides as this.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub enum Volume {
    /// What is seen: −w ≤ x, y ≤ w.
    #[default]
    View,
    /// What can be drawn: −4w ≤ x, y ≤ 4w.
    GuardBand,
}

/// One boundary of the volume.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub enum Plane {
    /// In front of the eye: w ≥ ⅛. First, so that the others may rely on it.
    Eye,
    /// Not nearer than the near plane: z ≥ −w.
    Near,
    /// Not farther than the far plane: z ≤ w.
    Far,
    /// x ≥ −w; −4w for the guard band.
    Left,
    /// x ≤ w; 4w for the guard band.
    Right,
    /// y ≥ −w; −4w for the guard band.
    Bottom,
    /// y ≤ w; 4w for the guard band.
    Top,
}

/// A [`Plane`] of a [`Volume`]: a boundary for every vertex in clip space.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct Face {
    volume: Volume,
    plane: Plane,
}

/// The guard band as a power of two.
const GUARD_BAND_LOG2: u32 = GUARD_BAND.trailing_zeros();
const _: () = assert!(GUARD_BAND == 1 << GUARD_BAND_LOG2);

/// While w is nearer to zero than this, 4w is a number of 32 bits.
const W_LIMIT: i32 = 1 << (31 - GUARD_BAND_LOG2);

impl Volume {
    /// Its boundaries, in the order of [`Plane::ALL`].
    #[must_use]
    pub fn faces(self) -> [Face; 7] {
        Plane::ALL.map(|plane| Face { volume: self, plane })
    }

    /// Whether a point lies beyond no boundary.
    ///
    /// Four comparisons of 32 bits while w is below 8192, as it is where coordinates keep to
    /// [`CLIP_LIMIT`](crate::CLIP_LIMIT). Right for all coordinates.
    #[inline]
    #[must_use]
    pub fn is_inside(self, point: &Point4<Clip>) -> bool {
        let [x, y, z, w] = [point.x, point.y, point.z, point.w].map(Scalar::to_bits);
        if !(LEAST_W.to_bits()..W_LIMIT).contains(&w) {
            return w > 0 && self.exact_outcode(point) == 0;
        }
        // −side ≤ v ≤ side, in one comparison.
        let within = |v: i32, side: i32| bits(v.wrapping_add(side)) <= bits(side) << 1;
        let side = w << self.width_log2();
        within(x, side) && within(y, side) && within(z, w)
    }

    /// The outcode of a point: one bit for each of [`Plane::ALL`] beyond which it lies. Lecture 3.5.2.
    ///
    /// Seven comparisons of 32 bits while w is within ±8192. Right for all coordinates.
    ///
    /// ```
    /// use aquatint::{Clip, Point4, Scalar, clip::volume::Volume};
    ///
    /// let [nil, one, two] = [0, 1, 2].map(Scalar::from_num);
    /// // Beside the view, to the right; yet it can be drawn.
    /// let point = Point4::<Clip>::new(two, nil, nil, one);
    /// assert_eq!([Volume::View, Volume::GuardBand].map(|volume| volume.outcode(&point)), [0b001_0000, 0]);
    /// ```
    #[inline]
    #[must_use]
    pub fn outcode(self, point: &Point4<Clip>) -> u8 {
        let [x, y, z, w] = [point.x, point.y, point.z, point.w].map(Scalar::to_bits);
        if !(-W_LIMIT..W_LIMIT).contains(&w) {
            return self.exact_outcode(point);
        }
        let side = w << self.width_log2();
        // !v is −v − 1, which always fits: −v > side.
        u8::from(w < LEAST_W.to_bits())
            | u8::from(!z >= w) << 1
            | u8::from(z > w) << 2
            | u8::from(!x >= side) << 3
            | u8::from(x > side) << 4
            | u8::from(!y >= side) << 5
            | u8::from(y > side) << 6
    }

    /// [`outcode`](Self::outcode) by the distances.
    #[cold]
    #[inline(never)]
    fn exact_outcode(self, point: &Point4<Clip>) -> u8 {
        Plane::ALL.iter().rev().fold(0, |code, &plane| code << 1 | u8::from(self.distance(plane, point) < 0))
    }

    /// How far inside of a boundary a point lies, in units of 2⁻¹⁶; negative outside.
    #[inline]
    fn distance(self, plane: Plane, point: &Point4<Clip>) -> i64 {
        let [x, y, z, w] = [point.x, point.y, point.z, point.w].map(|v| i64::from(v.to_bits()));
        let side = w << self.width_log2();
        match plane {
            Plane::Eye => w - i64::from(LEAST_W.to_bits()),
            Plane::Near => w + z,
            Plane::Far => w - z,
            Plane::Left => side + x,
            Plane::Right => side - x,
            Plane::Bottom => side + y,
            Plane::Top => side - y,
        }
    }

    const fn width_log2(self) -> u32 {
        match self {
            Self::View => 0,
            Self::GuardBand => GUARD_BAND_LOG2,
        }
    }
}

impl Plane {
    /// All of them, in the order in which to clip.
    pub const ALL: [Self; 7] = [Self::Eye, Self::Near, Self::Far, Self::Left, Self::Right, Self::Bottom, Self::Top];

    /// How far inside of the guard band's plane a point lies, in units of 2⁻¹⁶; negative outside.
    #[must_use]
    pub fn distance(self, point: &Point4<Clip>) -> i64 {
        Volume::GuardBand.distance(self, point)
    }
}

impl Face {
    /// Which of the planes it is.
    #[must_use]
    pub const fn plane(self) -> Plane {
        self.plane
    }
}

impl<V: Homogeneous> Boundary<V> for Face {
    #[inline]
    fn distance(&self, vertex: &V) -> i64 {
        self.volume.distance(self.plane, &vertex.point())
    }
}

/// [`Volume::outcode`] of the guard band.
///
/// Zero: may be projected. Two points with a common bit: nothing between them is visible.
#[inline]
#[must_use]
pub fn outcode(point: &Point4<Clip>) -> u8 {
    Volume::GuardBand.outcode(point)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::num::saturate_i32;
    use proptest::prelude::*;

    fn point(x: i32, y: i32, z: i32, w: i32) -> Point4<Clip> {
        let [x, y, z, w] = [x, y, z, w].map(Scalar::from_num);
        Point4::new(x, y, z, w)
    }

    #[test]
    fn every_side_has_its_bit() {
        assert_eq!(outcode(&point(0, 0, 0, 1)), 0);
        assert_eq!(outcode(&point(4, -4, 1, 1)), 0, "on the boundary is inside");
        let outside = [point(0, 0, -2, 1), point(0, 0, 2, 1), point(-5, 0, 0, 1), point(5, 0, 0, 1)];
        assert_eq!(outside.map(|p| outcode(&p)), [2, 4, 8, 16]);
        assert_eq!([point(0, -5, 0, 1), point(0, 5, 0, 1)].map(|p| outcode(&p)), [32, 64]);
        assert_eq!(outcode(&point(0, 0, 0, 0)), 1, "w = 0 is behind the eye plane alone");
        assert_eq!(outcode(&point(0, 0, 0, -1)), 0b111_1111, "behind the eye is outside of everything");
        assert_eq!(Volume::View.outcode(&point(4, -4, 1, 1)), 16 | 32, "beside the view");
        assert_eq!(Volume::View.outcode(&point(1, -1, 1, 1)), 0);
    }

    /// Numbers near each other's multiples, and the ends of the range.
    fn places() -> impl Strategy<Value = [i32; 4]> {
        let w = prop_oneof![
            -20..20_i32,
            8180..8200_i32,
            any::<i32>(),
            (0..6_i32).prop_map(|v| i32::MIN + v),
            (0..6_i32).prop_map(|v| i32::MAX - v),
            (-3..3_i32, 0..4_u32).prop_map(|(v, shift)| (1 << (31 - shift)) ^ v),
        ];
        let times = prop::sample::select(&[-4_i64, -1, 0, 1, 4]);
        let near = move || (times.clone(), -2..=2_i64, any::<i32>(), 0..4_u8);
        (w, prop::array::uniform3(near())).prop_map(|(w, sides)| {
            let [x, y, z] = sides.map(
                |(times, more, any, kind)| {
                    if kind == 0 { any } else { saturate_i32(i64::from(w) * times + more) }
                },
            );
            [x, y, z, w]
        })
    }

    proptest! {
        #![proptest_config(ProptestConfig::with_cases(50_000))]
        #[test]
        fn comparisons_in_32_bits_say_what_the_distances_say(place in places()) {
            let [x, y, z, w] = place.map(Scalar::from_bits);
            let point = Point4::new(x, y, z, w);
            for volume in [Volume::View, Volume::GuardBand] {
                let exact = volume.exact_outcode(&point);
                prop_assert_eq!(volume.outcode(&point), exact, "{:?}", volume);
                prop_assert_eq!(volume.is_inside(&point), exact == 0, "{:?}", volume);
            }
        }
    }
}
