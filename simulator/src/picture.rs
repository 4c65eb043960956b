//! What the eye sees.

use crate::codes::WrongLength;

/// A picture in sRGB, three bytes a pixel.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Picture {
    width: u32,
    height: u32,
    rgb: Vec<u8>,
}

impl Picture {
    /// The widest margin [`Picture::above`] draws.
    pub const WIDEST_MARGIN: u32 = 1024;

    /// A picture of red, green and blue bytes, row by row from the top.
    ///
    /// # Errors
    ///
    /// [`WrongLength`] unless there are three bytes a pixel.
    pub fn from_rgb(width: u32, height: u32, rgb: Vec<u8>) -> Result<Self, WrongLength> {
        WrongLength::check(byte_len(width, height), rgb.len())?;
        Ok(Self { width, height, rgb })
    }

    /// A picture of one colour.
    #[must_use]
    pub fn filled(width: u32, height: u32, colour: [u8; 3]) -> Self {
        let rgb = colour.repeat(byte_len(width, height) / 3);
        Self { width, height, rgb }
    }

    /// Pixels in a row.
    #[must_use]
    pub fn width(&self) -> u32 {
        self.width
    }

    /// Rows.
    #[must_use]
    pub fn height(&self) -> u32 {
        self.height
    }

    /// Red, green and blue bytes, row by row from the top.
    #[must_use]
    pub fn rgb(&self) -> &[u8] {
        &self.rgb
    }

    /// The colour at column `x` of row `y`, or `None` outside the picture.
    #[must_use]
    pub fn pixel(&self, x: u32, y: u32) -> Option<[u8; 3]> {
        if x >= self.width || y >= self.height {
            return None;
        }
        let start = (y as usize * self.width as usize + x as usize) * 3;
        let &[red, green, blue] = self.rgb.get(start..start + 3)? else {
            return None;
        };
        Some([red, green, blue])
    }

    /// One picture above the other, each in the middle, for a figure of several panels.
    ///
    /// There is a margin between pictures and around all of them, of [`Picture::WIDEST_MARGIN`] at
    /// most.
    #[must_use]
    pub fn above(pictures: &[Self], margin: u32, background: [u8; 3]) -> Self {
        let margin = margin.min(Self::WIDEST_MARGIN);
        let widest = pictures.iter().map(Self::width).max().unwrap_or(0);
        let height = pictures
            .iter()
            .fold(margin, |height, picture| height.saturating_add(picture.height).saturating_add(margin));
        let width = widest.saturating_add(2 * margin);
        let mut figure = Self::filled(width, height, background);
        let mut top = margin;
        for picture in pictures {
            figure.paste(picture, (width - picture.width) / 2, top);
            top = top.saturating_add(picture.height).saturating_add(margin);
        }
        figure
    }

    /// Copies a picture that fits whole.
    fn paste(&mut self, picture: &Self, left: u32, top: u32) {
        let stride = self.width as usize * 3;
        let length = picture.width as usize * 3;
        let first = top as usize * stride + left as usize * 3;
        let rows = picture.rgb.chunks_exact(length.max(1));
        for (row, source) in rows.enumerate() {
            let start = first + row * stride;
            self.rgb[start..start + length].copy_from_slice(source);
        }
    }
}

fn byte_len(width: u32, height: u32) -> usize {
    (width as usize).saturating_mul(height as usize).saturating_mul(3)
}

#[cfg(test)]
mod tests {
    use super::Picture;
    use crate::WrongLength;

    const RED: [u8; 3] = [255, 0, 0];
    const BLUE: [u8; 3] = [0, 0, 255];
    const GREY: [u8; 3] = [9, 9, 9];

    fn drawn(picture: &Picture) -> Vec<String> {
        let character = |x, y| match picture.pixel(x, y) {
            Some(RED) => 'r',
            Some(BLUE) => 'b',
            _ => '.',
        };
        (0..picture.height()).map(|y| (0..picture.width()).map(|x| character(x, y)).collect()).collect()
    }

    #[test]
    fn pictures_stand_one_above_the_other_in_the_middle() {
        let wide = Picture::filled(4, 1, RED);
        let narrow = Picture::filled(2, 2, BLUE);
        let figure = Picture::above(&[wide, narrow], 1, GREY);
        assert_eq!(drawn(&figure), ["......", ".rrrr.", "......", "..bb..", "..bb..", "......"]);
    }

    #[test]
    fn a_figure_of_nothing_is_its_margin() {
        assert_eq!(Picture::above(&[], 1, GREY), Picture::filled(2, 1, GREY));
        let empty = Picture::above(&[Picture::filled(0, 0, RED)], 0, GREY);
        assert_eq!((empty.width(), empty.height()), (0, 0));
    }

    #[test]
    fn the_margin_has_an_end() {
        let figure = Picture::above(&[], u32::MAX, GREY);
        assert_eq!((figure.width(), figure.height()), (2048, 1024));
    }

    #[test]
    fn three_bytes_a_pixel_are_asked_for() {
        let error = WrongLength { expected: 6, found: 5 };
        assert_eq!(Picture::from_rgb(2, 1, vec![0; 5]), Err(error));
        assert!(Picture::from_rgb(u32::MAX, u32::MAX, vec![]).is_err());
        assert_eq!(Picture::filled(1, 1, RED).pixel(1, 0), None);
    }
}
