//! The light on a point of a surface: what shading asks of a scene.

use crate::colour::Light;

/// The light on a point of a surface, in the object's own space.
pub trait Illumination {
    /// `position` 2.14 as in a mesh, `normal` of length 2^14 (2.14).
    fn on(&self, position: [i16; 3], normal: [i16; 3]) -> Light;

    /// The same for a mesh's normal of length 127: cheaper.
    fn on_vertex(&self, position: [i16; 3], normal: [i8; 3]) -> Light {
        self.on(position, normal.map(|n| i16::from(n) * 129))
    }
}

/// A vector of any length but zero as one of length 2^14.
#[must_use]
pub fn unit_normal([x, y, z]: [i32; 3]) -> [i16; 3] {
    let squares: i64 = [x, y, z].iter().map(|&v| i64::from(v) * i64::from(v)).sum();
    let length = i64::try_from(squares.unsigned_abs().isqrt()).unwrap_or(1).max(1);
    [x, y, z].map(|v| crate::num::saturate_i16((i64::from(v) << 14) / length))
}
