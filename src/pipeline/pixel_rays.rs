//! A ray for each pixel centre of a view.

use core::{iter::successors, ops::Range};

use super::Camera;
use crate::{
    error::describe,
    hidden::raycast::{REACH, Ray},
    matrix::Matrix,
    num::Scalar,
    space::{Clip, Rect, World},
};

/// Why a camera sends no rays.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub enum NoRays {
    /// There is no eye from which all rays come: the camera has no perspective, or cannot be undone.
    NoEye,
    /// The eye is more than [`REACH`] from zero along an axis.
    OutOfRange,
}

describe! { NoRays,
    Self::NoEye => "the camera has no eye";
    Self::OutOfRange => "the eye is out of range";
}

/// The rays of a camera, from its eye through the centres of the pixels. Near and far planes play no part.
///
/// Directions are linear in column and row, so that each is the one before it and a step:
///
/// ```text
///   x = u·w and y = v·w are two planes through the eye for each place u, v of the view, and the ray is where they meet:
///   (X − u W) × (Y − v W)  =  X × Y + u Y × W + v W × X        of the rows X, Y, W of the matrix to clip space
/// ```
///
/// The products are exact; 60 bits of the largest are kept. 82,000 instructions of a Cortex-M0 to set up, no division a pixel.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct PixelRays {
    eye: [i32; 3],
    rect: Rect,
    /// Through the centre of pixel (0, 0), and what each column and row add.
    first: [i64; 3],
    across: [i64; 3],
    down: [i64; 3],
}

impl PixelRays {
    /// The rays of a camera.
    ///
    /// # Errors
    /// [`NoRays`].
    pub fn new(camera: &Camera) -> Result<Self, NoRays> {
        let Camera { view, projection, viewport } = camera;
        let [[.., x], [.., y], _, [.., w]] = projection.rows();
        if [x, y, w].iter().any(|&&shift| shift != 0) || view.inverse().is_none() {
            return Err(NoRays::NoEye);
        }
        let eye = view.eye();
        let eye = [eye.x, eye.y, eye.z].map(Scalar::to_bits);
        if eye.iter().any(|v| v.unsigned_abs() > REACH.to_bits().unsigned_abs()) {
            return Err(NoRays::OutOfRange);
        }
        let rect = viewport.rect();
        let [first, across, down] = directions(&view.then(projection), rect).ok_or(NoRays::NoEye)?;
        Ok(Self { eye, rect, first, across, down })
    }

    /// The pixels of the view.
    #[must_use]
    pub const fn rect(&self) -> Rect {
        self.rect
    }

    /// The rays of some pixels of a row, as far as they are in the view.
    pub fn run(&self, row: i32, columns: Range<i32>) -> impl Iterator<Item = Ray> + use<> {
        let columns = self.rect.clip_run(row, columns).unwrap_or(0..0);
        let Self { eye, first, across, down, .. } = *self;
        let along = |from: [i64; 3], steps: i32, step: [i64; 3]| {
            let steps = i64::from(steps);
            added(from, step.map(|v| v.wrapping_mul(steps)))
        };
        let start = along(along(first, row, down), columns.start, across);
        let directions = successors(Some(start), move |&direction| Some(added(direction, across)));
        columns.zip(directions).map(move |(_, direction)| Ray::along(eye, direction))
    }
}

fn added([a, b, c]: [i64; 3], [x, y, z]: [i64; 3]) -> [i64; 3] {
    // Within the view they are below 2⁶¹.
    [a.wrapping_add(x), b.wrapping_add(y), c.wrapping_add(z)]
}

/// The direction through pixel (0, 0), and the steps; `None` if the rows are in one plane.
fn directions(to_clip: &Matrix<World, Clip>, rect: Rect) -> Option<[[i64; 3]; 3]> {
    let [x, y, _, w] = to_clip.rows().map(|[x, y, z, _]| [x, y, z].map(|v| i128::from(v.to_bits())));
    let (middle, right, up) = (cross(x, y), cross(y, w), cross(w, x));
    // Ahead is where w grows.
    let ahead = w.iter().zip(middle).map(|(a, b)| a * b).sum::<i128>().signum();
    if ahead == 0 {
        return None;
    }
    let Rect { left, top, right: end, bottom } = rect;
    let [width, height] = [end - left, bottom - top].map(i128::from);
    // The centre of pixel (x, y) is at (2 x + 1 − left − right) / width from the middle, and so downwards.
    let [x0, y0] = [1 - left - end, 1 - top - bottom].map(i128::from);
    let times = |vector: [i128; 3], by: i128| vector.map(|v| v * by * ahead);
    let (right, down) = (times(right, height), times(up, -width));
    let corner = plus(right.map(|v| v * x0), down.map(|v| v * y0));
    let first = plus(times(middle, width * height), corner);
    let (across, down) = (right.map(|v| 2 * v), down.map(|v| 2 * v));
    let size = |vector: &[i128; 3]| vector.iter().fold(0, |most: u128, v| most.max(v.unsigned_abs()));
    let most = size(&first) + 4096 * (size(&across) + size(&down));
    let shift = (u128::BITS - most.leading_zeros()).saturating_sub(60);
    Some([first, across, down].map(|vector| vector.map(|v| i64::try_from(v >> shift).unwrap_or(0))))
}

fn plus([a, b, c]: [i128; 3], [x, y, z]: [i128; 3]) -> [i128; 3] {
    [a + x, b + y, c + z]
}

/// Elements have 32 bits, so products 64.
fn cross([a, b, c]: [i128; 3], [x, y, z]: [i128; 3]) -> [i128; 3] {
    [b * z - c * y, c * x - a * z, a * y - b * x]
}
