//! One display: how its bytes are laid out and what its codes look like.

use crate::codes::{Codes, WrongLength};
use crate::light::Response;
use crate::packing::{Grid, Packing};
use crate::theme::Theme;

/// A display.
///
/// Describe one that is not listed here by naming what differs from one that is:
///
/// ```
/// use aquatint_simulator::{Panel, Theme};
///
/// let small = Panel { name: "SSD1306 128x32", height: 32, ..Panel::SSD1306_128X64 };
/// assert_eq!(small.with_theme(Theme::OLED_BLUE).byte_len(), 512);
/// ```
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Panel {
    /// What to call it.
    pub name: &'static str,
    /// Pixels in a row.
    pub width: u32,
    /// Rows.
    pub height: u32,
    /// Bits a pixel: 1, 2, 4 or 8. A depth between these works and wastes bits of each byte; 0
    /// counts as 1, and more than 8 as 8.
    pub bits: u8,
    /// Which bits of which byte hold which pixel.
    pub packing: Packing,
    /// How much light each code gives.
    pub response: Response,
    /// The colours of the darkest and the lightest code.
    pub theme: Theme,
}

impl Panel {
    /// The common small OLED: one bit a pixel, in pages.
    pub const SSD1306_128X64: Self = Self {
        name: "SSD1306 128x64",
        width: 128,
        height: 64,
        bits: 1,
        packing: Packing::PagesLsbTop,
        response: Response::LinearLight,
        theme: Theme::OLED_WHITE,
    };

    /// Sharp's memory LCD LS027B7DH01: one bit a pixel, in rows. These are the bytes of the lines
    /// alone, without the line addresses and trailers of its serial protocol.
    pub const SHARP_400X240: Self = Self {
        name: "Sharp memory LCD 400x240",
        width: 400,
        height: 240,
        bits: 1,
        packing: Packing::RowsMsbFirst,
        response: Response::LinearLight,
        theme: Theme::MEMORY_LCD,
    };

    /// A grey OLED: four bits a pixel, the left pixel in the high nibble. The controller's default
    /// table spaces pulse widths, and so light, evenly.
    pub const SSD1322_256X64: Self = Self {
        name: "SSD1322 256x64",
        width: 256,
        height: 64,
        bits: 4,
        packing: Packing::RowsMsbFirst,
        response: Response::LinearLight,
        theme: Theme::OLED_GREY,
    };

    /// A grey OLED as QEMU emulates it: four bits a pixel, the left pixel in the high nibble, each
    /// code shown as the sRGB value of the same fraction.
    pub const SSD0323_128X64: Self = Self {
        name: "SSD0323 128x64",
        width: 128,
        height: 64,
        bits: 4,
        packing: Packing::RowsMsbFirst,
        response: Response::Srgb,
        theme: Theme::OLED_GREY,
    };

    /// The same panel in other colours.
    #[must_use]
    pub const fn with_theme(self, theme: Theme) -> Self {
        Self { theme, ..self }
    }

    /// How many bytes a full frame has.
    #[must_use]
    pub fn byte_len(&self) -> usize {
        self.packing.byte_len(self.grid())
    }

    /// Takes a full frame apart, as the controller does.
    ///
    /// # Errors
    ///
    /// [`WrongLength`] unless there are exactly [`Panel::byte_len`] bytes.
    pub fn codes(&self, bytes: &[u8]) -> Result<Codes, WrongLength> {
        WrongLength::check(self.byte_len(), bytes.len())?;
        let grid = self.grid();
        Ok(Codes {
            width: self.width,
            height: self.height,
            levels: grid.levels(),
            values: self.packing.decode(bytes, grid),
        })
    }

    /// The sRGB colour the eye sees where the panel shows `code`.
    #[must_use]
    pub fn colour(&self, code: u8) -> [u8; 3] {
        self.theme.mix(self.response.light(code, self.grid().levels()))
    }

    fn grid(&self) -> Grid {
        Grid::new(self.width, self.height, self.bits)
    }
}

#[cfg(test)]
mod tests {
    use super::Panel;
    use crate::{Response, Theme};

    const BLACK_AND_WHITE: Theme = Theme { name: "black and white", dark: [0; 3], light: [255; 3], gap: [0; 3] };

    #[test]
    fn frames_are_as_long_as_the_data_sheets_say() {
        assert_eq!(Panel::SSD1306_128X64.byte_len(), 1024);
        assert_eq!(Panel::SHARP_400X240.byte_len(), 12_000);
        assert_eq!(Panel::SSD1322_256X64.byte_len(), 8192);
        assert_eq!(Panel::SSD0323_128X64.byte_len(), 4096);
    }

    #[test]
    fn one_bit_is_dark_or_light() {
        for theme in Theme::ALL {
            let panel = Panel::SSD1306_128X64.with_theme(theme);
            assert_eq!(panel.colour(0), theme.dark);
            assert_eq!(panel.colour(1), theme.light);
        }
    }

    #[test]
    fn the_middle_code_tells_the_responses_apart() {
        let panel = Panel::SSD1322_256X64.with_theme(BLACK_AND_WHITE);
        let linear = Panel { response: Response::LinearLight, ..panel };
        assert_eq!(linear.colour(8), [193; 3]);
        let encoded = Panel { response: Response::Srgb, ..panel };
        assert_eq!(encoded.colour(8), [136; 3]);
    }

    #[test]
    fn qemu_shows_each_code_times_seventeen() {
        let panel = Panel::SSD0323_128X64.with_theme(BLACK_AND_WHITE);
        for code in 0..16 {
            assert_eq!(panel.colour(code), [code * 17; 3]);
        }
    }
}
