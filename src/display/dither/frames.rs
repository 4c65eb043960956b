//! Grey from frames: a pixel that is on in some of `N` frames looks grey.
//!
//! The threshold of a pixel depends on its place and on the number of the frame:
//!
//! ```text
//!   (rank × N + (frame + 5 × rank) mod N + ½) / 16 N       rank: 4 × 4, N: 2, 3, 4 … 16
//! ```
//!
//! With 2, 3, 4 or 8 frames that makes 33, 49, 65 or 129 shades on one bit. Neighbours are on in different frames:
//! the mean of a 4 × 4 block changes by one pixel from frame to frame, while the same shades with all pixels in
//! step would flash the whole area.
//!
//! **Flicker.** A pixel repeats every N frames, so it flickers at refresh / N. Keep that at 45 to 60 Hz or above: an
//! SSD1306 at 128 frames a second takes 2 frames (64 Hz, calm) or 3 (43 Hz, slight), and 4 (32 Hz) is seen.
//! A frame that is missed or doubled changes the shade, so send frames from the panel's frame pulse or a timer.
//!
//! - **Takes** the number of the frame.
//! - **Gives** a [`Mask`].
//! - **Memory** 32 bytes.
//! - **Cost** sixteen divisions a frame, a load a pixel.

use super::{BAYER_4X4, Mask, rank::Cells};
use crate::{error::describe, num::high_u16, phase::phase};

/// The mask of one frame of a series.
///
/// ```
/// use aquatint::{Dithered, Frame, FrameRateControl, Levels, Light, Pages, Target};
/// use embedded_graphics::pixelcolor::BinaryColor;
///
/// let mut frame = Frame::<BinaryColor, Pages, _>::with_array([0; 1024], 128, 64).unwrap();
/// let mut on = 0;
/// for number in 0..3 {
///     let mask = FrameRateControl::new(3, number)?;
///     let mut dithered = Dithered::new(&mut frame, Levels::ONE_BIT).with_method(mask);
///     for row in 0..64 {
///         dithered.fill_run(row, 0..128, [Light(9_000)]).unwrap();
///     }
///     on += frame.bytes()[0].count_ones() + frame.bytes()[1].count_ones() + frame.bytes()[2].count_ones()
///         + frame.bytes()[3].count_ones(); // two blocks of 4 × 4
/// }
/// assert_eq!(on, 2 * 7); // 7 / 48 of the light, where one frame has 2 / 16 or 3 / 16
/// # Ok::<(), aquatint::display::dither::OddFrames>(())
/// ```
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct FrameRateControl {
    thresholds: [[u16; 4]; 4],
}

/// The number of frames of a series is not 1 to 16.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct OddFrames;

describe! { OddFrames, Self => "the number of frames is not 1 to 16"; }

impl FrameRateControl {
    /// The mask of frame `number`, counted on and on, of series of `frames`.
    ///
    /// # Errors
    /// [`OddFrames`].
    pub const fn new(frames: u8, number: u32) -> Result<Self, OddFrames> {
        if frames == 0 || frames > 16 {
            return Err(OddFrames);
        }
        let (count, mut thresholds) = (frames as u32, [[0; 4]; 4]);
        let (mut y, number) = (0, number % count);
        while y < 4 {
            let mut x = 0;
            while x < 4 {
                let rank = BAYER_4X4.rank(x, y) as u32;
                let place = rank * count + (number + 5 * rank) % count;
                // (place + ½) / 16 N of 65536, rounded down.
                thresholds[y][x] = high_u16((2 * place + 1) * (1_u32 << 27).div_ceil(count));
                x += 1;
            }
            y += 1;
        }
        Ok(Self { thresholds })
    }
}

impl Mask for FrameRateControl {
    const REPEATS: bool = true;

    #[inline]
    fn threshold(&self, column: i32, row: i32) -> u16 {
        phase(&self.thresholds, row).and_then(|row| phase(&row, column)).unwrap_or_default()
    }

    #[inline]
    fn row(&self, row: i32, column: i32) -> impl Iterator<Item = u16> {
        let [first, second, third, fourth] = &self.thresholds;
        let row = match row & 3 {
            0 => first,
            1 => second,
            2 => third,
            _ => fourth,
        };
        Cells::new(row, column)
    }
}
