//! Vertex processing: a mesh that has been transformed and lit.

use heapless::vec::VecView;

use super::vertex::{ClipVertex, MeshVertex};
use crate::{
    clip::{clip_plane::ClipPlane, sutherland_hodgman_3d, volume::Volume, window::Boundary},
    colour::Light,
    fragment::shade::{Corner, Shading},
    geometry::{
        face::{Faces, Side},
        transform::MeshTransform,
        viewport::{ScreenPoint, Viewport},
    },
    illumination::Illumination,
    model::mesh::Mesh,
    num::Scalar,
    pipeline::fragments::{DepthBias, MeshTriangle},
    space::{Clip, Point4},
    vary::Varying,
};

/// A mesh on its way to the screen.
pub(super) struct Surface<'s, S, I> {
    pub(super) mesh: &'s Mesh<'s>,
    pub(super) shading: &'s S,
    pub(super) light: I,
    pub(super) transform: MeshTransform,
    pub(super) planes: &'s [ClipPlane],
    pub(super) viewport: Viewport,
    pub(super) faces: Faces,
    pub(super) bias: DepthBias,
    /// After [`process_vertices`](Self::process_vertices).
    pub(super) vertices: &'s [MeshVertex],
}

impl<S: Shading, I: Illumination> Surface<'_, S, I> {
    /// Vertex transform and lighting, once for each vertex.
    pub(super) fn process_vertices(&self, vertices: &mut [MeshVertex]) {
        for ((vertex, &position), &normal) in vertices.iter_mut().zip(self.mesh.positions()).zip(self.mesh.normals()) {
            let point = self.transform.apply(position);
            *vertex = if Volume::GuardBand.is_inside(&point) {
                MeshVertex::new(self.viewport.project(&point))
            } else {
                MeshVertex::UNPROJECTED
            };
            if S::NEEDS_LIGHT && self.faces != Faces::Back {
                vertex.front = self.light.on_vertex(position, normal);
            }
            if S::NEEDS_LIGHT && self.faces != Faces::Front {
                vertex.back = self.light.on_vertex(position, turned(normal));
            }
        }
        if !self.planes.is_empty() {
            self.cut_vertices(vertices);
        }
    }

    /// Sends vertices beyond a plane of the user's to the clipper. In a second pass, so that without planes nobody asks.
    #[inline(never)]
    fn cut_vertices(&self, vertices: &mut [MeshVertex]) {
        for (vertex, &position) in vertices.iter_mut().zip(self.mesh.positions()) {
            let point = self.transform.apply(position);
            if self.planes.iter().any(|plane| plane.distance(&point) < 0) {
                *vertex = vertex.unprojected();
            }
        }
    }

    /// Leaves the part of a polygon that may be projected, inside of all planes. Works in both lists.
    pub(super) fn clip<A: Varying>(&self, polygon: &mut VecView<ClipVertex<A>>, spare: &mut VecView<ClipVertex<A>>) {
        // There is room: see their capacity. Were there not, nothing would be drawn.
        if sutherland_hodgman_3d::clip(polygon, spare, self.planes, Volume::GuardBand).is_err() {
            polygon.clear();
        }
    }

    /// Perspective divide and viewport, out of line: for what has been clipped.
    #[inline(never)]
    pub(super) fn project(&self, point: &Point4<Clip>) -> ScreenPoint {
        self.viewport.project(point)
    }

    /// One of the vertices.
    #[inline]
    pub(super) fn vertex(&self, index: u16) -> MeshVertex {
        self.vertices.get(usize::from(index)).copied().unwrap_or_default()
    }

    /// Those of a face. All are there: a mesh has checked its indices.
    #[inline]
    pub(super) fn vertices_of(&self, [a, b, c]: [u16; 3]) -> Option<[&MeshVertex; 3]> {
        let vertex = |index: u16| self.vertices.get(usize::from(index));
        Some([vertex(a)?, vertex(b)?, vertex(c)?])
    }

    /// Where a vertex is in the object's own space.
    #[inline]
    pub(super) fn position(&self, index: u16) -> [i16; 3] {
        self.mesh.positions().get(usize::from(index)).copied().unwrap_or_default()
    }

    /// Its distance in front of the eye, if anybody asks.
    #[inline]
    pub(super) fn w(&self, index: u16) -> Scalar {
        if S::NEEDS_W { self.transform.apply_w(self.position(index)) } else { Scalar::ZERO }
    }

    /// The normal of a whole triangle, towards the eye.
    #[inline]
    pub(super) fn face_normal(&self, triangle: &MeshTriangle) -> Option<[i8; 3]> {
        let normal = self.mesh.face_normals()?.get(triangle.face.number).copied()?;
        Some(if triangle.side == Side::Back { turned(normal) } else { normal })
    }

    /// What shading may know of the corners.
    #[inline]
    pub(super) fn corners(&self, triangle: &MeshTriangle) -> [Corner; 3] {
        let [a, b, c] = triangle.face.corners;
        [self.corner(a, triangle.side), self.corner(b, triangle.side), self.corner(c, triangle.side)]
    }

    #[inline]
    pub(super) fn corner(&self, index: u16, side: Side) -> Corner {
        let at = usize::from(index);
        let normal = self.mesh.normals().get(at).copied().unwrap_or_default();
        Corner {
            index,
            position: self.position(index),
            normal: if side == Side::Back { turned(normal) } else { normal },
            uv: self.mesh.uv().and_then(|uv| uv.get(at).copied()).unwrap_or_default(),
            color: self.mesh.lights().and_then(|lights| lights.get(at).copied()).unwrap_or(Light::WHITE),
            light: if S::NEEDS_LIGHT { self.light_at(index, side) } else { Light::BLACK },
        }
    }

    /// The light on a vertex.
    #[inline]
    fn light_at(&self, index: u16, side: Side) -> Light {
        let Some(vertex) = self.vertices.get(usize::from(index)) else { return Light::BLACK };
        if side == Side::Back { vertex.back } else { vertex.front }
    }
}

/// A normal the other way around; −128 becomes 127.
#[inline]
fn turned(normal: [i8; 3]) -> [i8; 3] {
    normal.map(i8::saturating_neg)
}
