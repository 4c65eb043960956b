//! A light, and how a target shows it: what is found once for all runs of one light.
//!
//! ```text
//!   row 0   #...#...   found with the first run in it …
//!   row 1   ........
//!   row 2   ..#...#.   … and used by those in rows 10, 18 …
//! ```

use crate::{colour::Light, num::index};

/// A light for many runs on one target, which keeps in it how it shows that light: 12 bytes.
///
/// ```
/// use aquatint::{Dithered, Frame, Levels, Light, Rows, Shade, Target};
/// use embedded_graphics::pixelcolor::BinaryColor;
///
/// let mut frame = Frame::<BinaryColor, Rows, _>::with_array([0; 4], 8, 4)?;
/// let mut dithered = Dithered::new(&mut frame, Levels::ONE_BIT);
/// let mut half = Shade::new(Light(32_768));
/// for row in 0..4 {
///     dithered.fill_shade(row, 0..8, &mut half)?;
/// }
/// assert_eq!(frame.bytes(), [0b1010_1010, 0b0101_0101, 0b1010_1010, 0b0101_0101]);
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct Shade {
    light: Light,
    /// The darker of the two codes that show it …
    code: u8,
    /// … and of which eight rows it is known …
    known: u8,
    /// … in which columns they show the brighter one.
    rows: [u8; 8],
}

impl Shade {
    /// A light that no target has seen.
    #[must_use]
    pub const fn new(light: Light) -> Self {
        Self { light, code: 0, known: 0, rows: [0; 8] }
    }

    /// The light.
    #[inline]
    #[must_use]
    pub const fn light(&self) -> Light {
        self.light
    }

    /// The darker code and the columns of the brighter one in a row, of which every eighth is alike; found if they are not
    /// known.
    #[inline]
    pub(crate) fn in_row(&mut self, row: i32, find: impl FnOnce(Light) -> (u8, u8)) -> (u8, u8) {
        let phase = row & 7;
        if self.known >> phase & 1 == 0 {
            let (code, byte) = find(self.light);
            (self.code, self.known) = (code, self.known | 1 << phase);
            if let Some(place) = self.rows.get_mut(index(phase)) {
                *place = byte;
            }
        }
        (self.code, self.rows.get(index(phase)).copied().unwrap_or_default())
    }
}
