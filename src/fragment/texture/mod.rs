//! Textures: pictures that are laid over surfaces, in light. Lecture 1.5 and 2.4.2.
//!
//! ```text
//!   bytes in flash       codes           lights of the codes       light at (u, v)
//!   0b0110_1001    ──▶   0 1 1 0 …  ──▶  [black, white]      ──▶   sampler: wrap, then filter
//! ```
//!
//! - **Takes** rows of codes of 1, 2, 4 or 8 bits, the leftmost texel in the high bits, each row from the beginning of a
//!   byte; or lights. Width and height are powers of two up to 4096, so that a texture repeats without a division.
//! - **Gives** the [`Light`] of a texel, and through a [`Sampler`] that of any place.
//! - **Memory** none: texels and tables stay where they are, in flash.
//! - **Cost** of a texel: a byte, a shift and a load from the table. No division, nothing of 64 bits.
//!
//! Codes are not [`Light`], so a texture comes with a table that says what its codes stand for; by the length of
//! the table it knows how many bits a texel has. The table may be that of a panel's levels, or be changed between two
//! pictures, to fade a wall in or to let a lamp flicker.

mod sampler;

pub use sampler::{Bilinear, ClampToEdge, Filter, Mirror, Nearest, Repeat, Sampler, Wrap};

use crate::{colour::Light, error::describe, num::count};

/// A texture is at most this wide, and this high.
const MOST_TEXELS: u32 = 4096;

/// Why bytes or lights are no texture.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub enum TextureError {
    /// Width or height is no power of two from 1 to 4096.
    Size,
    /// There are fewer bytes, or lights, than the texture has.
    TooSmall {
        /// How many are needed.
        needed: usize,
    },
}

describe! {
    TextureError,
    Self::Size => "width or height is no power of two from 1 to 4096";
    Self::TooSmall { needed } => "{needed} bytes or lights are needed";
}

/// Something that has a light at each place of a grid.
pub trait Texels {
    /// Width and height, each as a power of two from 0 to 12.
    fn size_log2(&self) -> [u32; 2];

    /// The light of a texel, counted from the upper left. Beside the texture, that of some other texel, or black.
    fn texel(&self, column: u32, row: u32) -> Light;
}

impl<T: Texels> Texels for &T {
    #[inline]
    fn size_log2(&self) -> [u32; 2] {
        (**self).size_log2()
    }

    #[inline]
    fn texel(&self, column: u32, row: u32) -> Light {
        (**self).texel(column, row)
    }
}

/// What the codes of a texture stand for: a table of 2, 4, 16 or 256 lights, or [`Srgb`].
pub trait CodeLights: Copy {
    /// Bits a code: 1, 2, 4 or 8.
    const BITS: u32;

    /// The light of a code; bits above [`BITS`](Self::BITS) play no part.
    fn light(&self, code: u8) -> Light;
}

/// A table of `N` lights: 2, 4, 16 or 256. With another number of them a program does not compile.
impl<const N: usize> CodeLights for &[Light; N] {
    const BITS: u32 = {
        assert!(N == 2 || N == 4 || N == 16 || N == 256, "a table of 2, 4, 16 or 256 lights");
        N.trailing_zeros()
    };

    #[inline]
    fn light(&self, code: u8) -> Light {
        // The mask keeps the code inside of the table, so that there is no test.
        self.get(usize::from(code) & (N - 1)).copied().unwrap_or(Light::BLACK)
    }
}

/// Codes of 8 bits, as in the grey picture files of everybody.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct Srgb;

impl CodeLights for Srgb {
    const BITS: u32 = 8;

    #[inline]
    fn light(&self, code: u8) -> Light {
        Light::from_srgb(code)
    }
}

/// The lights of 1-bit codes: black and white.
pub const BLACK_AND_WHITE: [Light; 2] = [Light::BLACK, Light::WHITE];
/// The lights of 2-bit codes that are four equal steps of sRGB.
pub const SRGB_4: [Light; 4] = equal_steps();
/// The lights of 4-bit codes that are sixteen equal steps of sRGB.
pub const SRGB_16: [Light; 16] = equal_steps();

const fn equal_steps<const N: usize>() -> [Light; N] {
    let (mut lights, mut code, mut srgb) = ([Light::BLACK; N], 0, 0_u8);
    while code < N {
        lights[code] = Light::from_srgb(srgb);
        srgb = srgb.saturating_add(if N == 4 { 85 } else { 17 });
        code += 1;
    }
    lights
}

/// A texture of codes, in flash.
///
/// A constant one is checked while compiling:
///
/// ```
/// use aquatint::{Light, fragment::texture::{BLACK_AND_WHITE, Sampler, Texture}};
///
/// // Checks: a 1-bit texture of 2 × 2 texels. Each row begins with a byte of its own.
/// type Bits = Texture<'static, &'static [Light; 2]>;
/// const CHECKS: Bits = match Texture::new(&[0b1000_0000, 0b0100_0000], 2, 2, &BLACK_AND_WHITE) {
///     Ok(texture) => texture,
///     Err(_) => panic!("no texture"),
/// };
/// let sampler = Sampler::new(CHECKS);
/// let one = 1 << 16;
/// assert_eq!([0, one, 2 * one].map(|u| sampler.sample(u, 0)), [Light::WHITE, Light::BLACK, Light::WHITE]);
/// ```
#[derive(Clone, Copy, Debug)]
pub struct Texture<'a, L> {
    bytes: &'a [u8],
    lights: L,
    size_log2: [u32; 2],
    /// Texels from row to row, as a power of two: whole bytes.
    stride_log2: u32,
}

impl<'a, L: CodeLights> Texture<'a, L> {
    /// Borrows rows of codes; what is behind the last row is not used.
    ///
    /// # Errors
    /// [`TextureError`]: the size is not one of a texture, or there are too few bytes.
    pub const fn new(bytes: &'a [u8], width: u32, height: u32, lights: L) -> Result<Self, TextureError> {
        let Some(size_log2) = log2_of(width, height) else { return Err(TextureError::Size) };
        let [width_log2, height_log2] = size_log2;
        let stride_log2 = if width_log2 < Self::BYTE_LOG2 { Self::BYTE_LOG2 } else { width_log2 };
        let needed = count(1 << (stride_log2 - Self::BYTE_LOG2 + height_log2));
        if bytes.len() < needed {
            return Err(TextureError::TooSmall { needed });
        }
        Ok(Self { bytes, lights, size_log2, stride_log2 })
    }

    /// Texels in a byte, as a power of two.
    const BYTE_LOG2: u32 = (8 / L::BITS).trailing_zeros();
}

impl<L: CodeLights> Texels for Texture<'_, L> {
    #[inline]
    fn size_log2(&self) -> [u32; 2] {
        self.size_log2
    }

    #[inline]
    fn texel(&self, column: u32, row: u32) -> Light {
        let place = (row << self.stride_log2) | column;
        let byte = element(self.bytes, place >> Self::BYTE_LOG2).unwrap_or(0);
        // From the high end of the byte.
        let behind = !place & ((1 << Self::BYTE_LOG2) - 1);
        self.lights.light(byte >> (behind * L::BITS))
    }
}

/// A texture of lights: two bytes a texel, and no table to look in.
///
/// ```
/// use aquatint::{Light, fragment::texture::{LightTexture, Texels}};
///
/// let lights = [10, 20, 30, 40].map(Light);
/// let texture = LightTexture::new(&lights, 2, 2).unwrap();
/// assert_eq!(texture.texel(1, 1), Light(40));
/// ```
#[derive(Clone, Copy, Debug)]
pub struct LightTexture<'a> {
    lights: &'a [Light],
    size_log2: [u32; 2],
}

impl<'a> LightTexture<'a> {
    /// Borrows lights, row by row; what is behind the last row is not used.
    ///
    /// # Errors
    /// [`TextureError`]: the size is not one of a texture, or there are too few lights.
    pub const fn new(lights: &'a [Light], width: u32, height: u32) -> Result<Self, TextureError> {
        let Some(size_log2) = log2_of(width, height) else { return Err(TextureError::Size) };
        let needed = count(1 << (size_log2[0] + size_log2[1]));
        if lights.len() < needed {
            return Err(TextureError::TooSmall { needed });
        }
        Ok(Self { lights, size_log2 })
    }
}

impl Texels for LightTexture<'_> {
    #[inline]
    fn size_log2(&self) -> [u32; 2] {
        self.size_log2
    }

    #[inline]
    fn texel(&self, column: u32, row: u32) -> Light {
        let [width_log2, _] = self.size_log2;
        element(self.lights, (row << width_log2) | column).unwrap_or(Light::BLACK)
    }
}

/// Width and height as powers of two, if they are those of a texture.
const fn log2_of(width: u32, height: u32) -> Option<[u32; 2]> {
    let are_powers = width.is_power_of_two() && height.is_power_of_two();
    if !are_powers || width > MOST_TEXELS || height > MOST_TEXELS {
        return None;
    }
    Some([width.trailing_zeros(), height.trailing_zeros()])
}

#[inline]
fn element<T: Copy>(all: &[T], at: u32) -> Option<T> {
    usize::try_from(at).ok().and_then(|at| all.get(at)).copied()
}
