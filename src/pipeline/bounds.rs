//! What is known of where a whole mesh lies, to leave it out at the price of some planes. Lecture 3.4.1.

use crate::{
    clip::{
        bounding_box_3d::BoundingBox3,
        bounding_sphere::BoundingSphere,
        bounds::Verdict,
        frustum::{BoundingVolume, Frustum},
    },
    matrix::Matrix,
    space::{Clip, Model},
};

/// Bounds of a mesh: none, or a volume that holds all of its vertices.
///
/// A program whose instances have none has no code for them.
pub trait Bounds {
    /// Whether they are certainly outside of the view.
    fn are_outside(&self, to_clip: &Matrix<Model, Clip>) -> bool;
}

/// Nothing is known.
impl Bounds for () {
    #[inline]
    fn are_outside(&self, _to_clip: &Matrix<Model, Clip>) -> bool {
        false
    }
}

/// Seven square roots, and 21 products.
impl Bounds for BoundingSphere<Model> {
    fn are_outside(&self, to_clip: &Matrix<Model, Clip>) -> bool {
        is_outside(self, to_clip)
    }
}

/// Tighter around long things; 42 products.
impl Bounds for BoundingBox3<Model> {
    fn are_outside(&self, to_clip: &Matrix<Model, Clip>) -> bool {
        is_outside(self, to_clip)
    }
}

fn is_outside(volume: &impl BoundingVolume<Model>, to_clip: &Matrix<Model, Clip>) -> bool {
    Frustum::new(to_clip).is_ok_and(|frustum| volume.against(&frustum) == Verdict::Outside)
}
