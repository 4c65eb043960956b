//! Shading: from what the corners of a triangle carry to the colours of its pixels. Lecture 2.2.2 and 2.4.3.
//!
//! ```text
//!              once a corner         once a triangle that is seen       each pixel seen
//!   Plain      ─                     ─                                  ─
//!   Flat                             light of the face                  ─
//!   Gouraud    light of the vertex   plane of light                     an addition
//!   Phong      normal, place         planes of both                     the light there
//!   Textured   texture coordinates   perspective planes                 a texel
//!   Shader     your closure          planes of what it gives            your closure
//! ```
//!
//! Each is a type, so that a program has the code of what it uses, and no choice is made a pixel. They nest:
//! `Textured::new(sampler, Gouraud)` is a lit texture, [`Mapped`] changes the colours of any of them, [`Fogged`]
//! hides what is far, and [`Stippled`] leaves out pixels.
//!
//! Lights and normals are linear on the screen, as in the lecture; texture coordinates are right in perspective.

mod fogged;
mod gouraud;
mod line;
mod mapped;
mod perspective;
mod phong;
mod shader;
mod textured;

pub use fogged::Fogged;
pub use gouraud::{Flat, Gouraud, Unlit};
pub use line::{LineShading, Plain};
pub use mapped::{Mapped, Stippled};
pub use perspective::{Perspective, PerspectiveRun};
pub use phong::Phong;
pub use shader::Shader;
pub use textured::{Affine, Textured};

use core::ops::Range;

use crate::{
    colour::Light, illumination::Illumination, num::Scalar, slopes::Slopes, space::Point2, target::Target,
    vary::Varying,
};

/// A corner of a triangle, as the mesh has it. What a mesh has not is zero, but for `color`, which is white.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct Corner {
    /// Of the vertex, in its mesh.
    pub index: u16,
    /// Place in the object's own space, 2.14.
    pub position: [i16; 3],
    /// Normal of length 127; towards the eye on a back face.
    pub normal: [i8; 3],
    /// Texture coordinates, 4.12: 4096 is the width of a texture.
    pub uv: [i16; 2],
    /// The vertex's own colour: how much of each light it gives back.
    pub color: Light,
    /// The light on it, if the shading [needs](Shading::NEEDS_LIGHT) it.
    pub light: Light,
}

/// A corner on the screen, perhaps one that clipping has made.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Placed<A> {
    /// Place on the screen.
    pub position: Point2,
    /// Distance in front of the eye, for [what is right in perspective](Shading::NEEDS_W).
    pub w: Scalar,
    /// What it carries.
    pub attributes: A,
}

/// A triangle on the screen: all of one of the mesh, or a piece that clipping has left.
#[derive(Clone, Copy, Debug)]
pub struct Facet<'f, A> {
    /// The corners of the whole triangle.
    pub corners: &'f [Corner; 3],
    /// The normal of the whole triangle, if the mesh has one.
    pub normal: Option<[i8; 3]>,
    /// The corners of the piece.
    pub placed: &'f [Placed<A>; 3],
    /// Its slopes.
    pub slopes: &'f Slopes,
}

impl<'f, A> Facet<'f, A> {
    /// The same with other things carried.
    #[inline]
    const fn with_placed<B>(&self, placed: &'f [Placed<B>; 3]) -> Facet<'f, B> {
        Facet { corners: self.corners, normal: self.normal, placed, slopes: self.slopes }
    }
}

/// How the pixels of triangles get their colours.
pub trait Shading {
    /// What is carried from the corners over the triangle.
    type Attributes: Varying;
    /// What is computed once for a triangle of which a pixel is seen.
    type Face;
    /// What a pixel is given.
    type Color: Copy;
    /// Whether the light at the vertices is needed.
    const NEEDS_LIGHT: bool = false;
    /// Whether distances from the eye are needed.
    const NEEDS_W: bool = false;
    /// Whether a pixel by itself is cheap, so that short runs are drawn pixel by pixel.
    const IS_CHEAP: bool = false;
    /// Whether some pixels may get no colour. They hide nothing then.
    const DROPS: bool = false;

    /// What a corner carries.
    fn corner(&self, corner: &Corner) -> Self::Attributes;

    /// Begins a triangle.
    fn face<I: Illumination>(&self, light: &I, facet: &Facet<'_, Self::Attributes>) -> Self::Face;

    /// The colours from a pixel on to the right, without end.
    fn colors<I: Illumination>(
        &self,
        light: &I,
        face: &Self::Face,
        at: (i32, i32),
    ) -> impl Iterator<Item = Option<Self::Color>>;

    /// Draws a run of pixels that are all seen, of a shading that [drops](Self::DROPS) none; `run` is its row and its
    /// columns. The face may keep what the next runs of it can use.
    ///
    /// # Errors
    /// What the target says.
    #[inline]
    fn paint<I: Illumination, T: Target<Color = Self::Color>>(
        &self,
        light: &I,
        face: &mut Self::Face,
        (row, columns): (i32, Range<i32>),
        target: &mut T,
    ) -> Result<(), T::Error> {
        let colors = self.colors(light, face, (row, columns.start));
        // Each is some: nothing ends.
        target.write_all(row, columns, colors.map_while(|color| color))
    }
}

/// A signed number as an attribute, which is unsigned.
#[inline]
const fn offset(value: i16) -> u16 {
    value.cast_unsigned() ^ 0x8000
}
