//! Samplers: the light of a texture at any place.
//!
//! ```text
//!   wrap       Repeat         ClampToEdge     Mirror           filter    Nearest       Bilinear
//!              abcabcabc      aaaabcccc       cbaabccba                  the texel     the four around,
//!                 ^^^            ^^^             ^^^                     it is in      by their nearness
//! ```
//!
//! Places are counted in texels, in signed 16.16 numbers: `u` to the right, `v` downwards, from the corner of the first
//! texel. So the centre of texel `(x, y)` is at `(x + ½, y + ½)`, as on the screen, and a texture that is drawn texel for
//! pixel keeps its texels by either filter. All numbers are places of a texture.
//!
//! How it wraps and how it is filtered are types, so nothing is asked for a pixel.

use core::marker::PhantomData;

use super::Texels;
use crate::{
    colour::Light,
    num::{bits, high_u16},
};

/// How a texture goes on beyond its edges.
pub trait Wrap {
    /// The texel that stands at a place, along one axis of `mask + 1` texels: `0 ..= mask`.
    fn wrap(texel: i32, mask: u32) -> u32;
}

/// Again and again.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct Repeat;

/// With the texels of its edge.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct ClampToEdge;

/// Forth and back.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct Mirror;

impl Wrap for Repeat {
    #[inline]
    fn wrap(texel: i32, mask: u32) -> u32 {
        bits(texel) & mask
    }
}

impl Wrap for ClampToEdge {
    #[inline]
    fn wrap(texel: i32, mask: u32) -> u32 {
        bits(texel.max(0)).min(mask)
    }
}

impl Wrap for Mirror {
    #[inline]
    fn wrap(texel: i32, mask: u32) -> u32 {
        // Every second copy runs backwards: with all bits turned round.
        let is_turned = bits(texel) & mask.wrapping_add(1) != 0;
        (if is_turned { !bits(texel) } else { bits(texel) }) & mask
    }
}

/// How the light between the centres of texels is found.
pub trait Filter {
    /// The light at a place, in 16.16 texels. `masks` are width and height, less one.
    fn sample<W: Wrap>(texels: &impl Texels, masks: [u32; 2], place: [i32; 2]) -> Light;
}

/// The light of the texel that a place is in.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct Nearest;

/// Between the centres of the four texels around, in linear light: within 1/256 of the white.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct Bilinear;

impl Filter for Nearest {
    #[inline]
    fn sample<W: Wrap>(texels: &impl Texels, [columns, rows]: [u32; 2], [u, v]: [i32; 2]) -> Light {
        texels.texel(W::wrap(u >> 16, columns), W::wrap(v >> 16, rows))
    }
}

impl Filter for Bilinear {
    #[inline]
    fn sample<W: Wrap>(texels: &impl Texels, [columns, rows]: [u32; 2], [u, v]: [i32; 2]) -> Light {
        let ((left, right, across), (above, below, down)) = (around::<W>(u, columns), around::<W>(v, rows));
        let row = |row: u32| {
            let [near, far] = [texels.texel(left, row).0, texels.texel(right, row).0].map(u32::from);
            mixed(near, far, across)
        };
        // 16 bits of light and 8 of each weight: 32 are just enough, with the half for rounding.
        Light(high_u16(mixed(row(above), row(below), down).wrapping_add(0x8000)))
    }
}

/// The texels with the centres before and behind a place, and its way from the first to the second in 256ths.
#[inline]
fn around<W: Wrap>(place: i32, mask: u32) -> (u32, u32, u32) {
    // Less half a texel, rounded to 256ths. Half of it, so that it fits.
    let from_centre = (place >> 1) - (0x7F80 >> 1);
    let texel = from_centre >> 15;
    (W::wrap(texel, mask), W::wrap(texel + 1, mask), bits(from_centre) >> 7 & 0xFF)
}

/// 256 times what is between two numbers: differences and products are right modulo 2³².
#[inline]
const fn mixed(near: u32, far: u32, way: u32) -> u32 {
    (near << 8).wrapping_add(far.wrapping_sub(near).wrapping_mul(way))
}

/// A texture, how it goes on beyond its edges, and how it is filtered.
///
/// ```
/// use aquatint::Light;
/// use aquatint::fragment::texture::{Bilinear, ClampToEdge, LightTexture, Sampler};
///
/// let lights = [0, 1000].map(Light);
/// let ramp = LightTexture::new(&lights, 2, 1).unwrap();
/// let sampler = Sampler::new(ramp).with_wrap(ClampToEdge).with_filter(Bilinear);
/// // At the centres of both texels, between them, and beyond.
/// let quarters = [2, 6, 4, 5, 99].map(|quarter| sampler.sample(quarter << 14, 0).0);
/// assert_eq!(quarters, [0, 1000, 500, 750, 1000]);
/// ```
#[derive(Clone, Copy, Debug)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct Sampler<T, W = Repeat, F = Nearest> {
    texels: T,
    size_log2: [u32; 2],
    /// Width and height, less one.
    masks: [u32; 2],
    modes: PhantomData<(W, F)>,
}

impl<T: Texels> Sampler<T> {
    /// A texture that repeats, and whose texels are seen as squares.
    pub fn new(texels: T) -> Self {
        let size_log2 = texels.size_log2().map(|log2| log2.min(MOST_LOG2));
        Self { texels, size_log2, masks: size_log2.map(|log2| (1 << log2) - 1), modes: PhantomData }
    }
}

/// No axis has more texels than this power of two.
const MOST_LOG2: u32 = super::MOST_TEXELS.trailing_zeros();

impl<T: Texels, W: Wrap, F: Filter> Sampler<T, W, F> {
    /// The same with another continuation: [`Repeat`], [`ClampToEdge`] or [`Mirror`].
    #[must_use]
    pub fn with_wrap<Other: Wrap>(self, _wrap: Other) -> Sampler<T, Other, F> {
        let Self { texels, size_log2, masks, .. } = self;
        Sampler { texels, size_log2, masks, modes: PhantomData }
    }

    /// The same with another filter: [`Nearest`] or [`Bilinear`].
    #[must_use]
    pub fn with_filter<Other: Filter>(self, _filter: Other) -> Sampler<T, W, Other> {
        let Self { texels, size_log2, masks, .. } = self;
        Sampler { texels, size_log2, masks, modes: PhantomData }
    }

    /// The light at a place, in signed 16.16 texels.
    ///
    /// Bilinear, it reads four texels and multiplies three times.
    #[inline]
    pub fn sample(&self, u: i32, v: i32) -> Light {
        F::sample::<W>(&self.texels, self.masks, [u, v])
    }

    /// How far a texture coordinate of a mesh is to be shifted to the left to be a place: 4 to 16, for each axis.
    ///
    /// Such coordinates are unsigned 4.12 numbers: 4096 is the width of the texture, or its height. The bits of a
    /// place of 32,768 texels and more are those of one that many texels before the texture: where the texture repeats
    /// or is mirrored, that makes no difference.
    #[must_use]
    pub fn uv_shifts(&self) -> [u32; 2] {
        self.size_log2.map(|log2| log2 + 4)
    }

    /// How far a coordinate with 28 fraction bits, 2²⁸ being the width of the texture or its height, is to be shifted to
    /// the right to be a place.
    #[inline]
    pub(crate) fn fine_shifts(&self) -> [u32; 2] {
        self.size_log2.map(|log2| 12 - log2)
    }

    /// The light at texture coordinates of a mesh, in unsigned 4.12 textures.
    #[inline]
    pub fn sample_uv(&self, uv: [u16; 2]) -> Light {
        let ([u, v], [right, down]) = (uv.map(u32::from), self.uv_shifts());
        self.sample((u << right).cast_signed(), (v << down).cast_signed())
    }
}
