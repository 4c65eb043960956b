//! From packed bytes to a picture.

use crate::codes::WrongLength;
use crate::panel::Panel;
use crate::picture::Picture;
use crate::zoom::Zoom;

impl Panel {
    /// What the panel shows when it is sent these bytes.
    ///
    /// # Errors
    ///
    /// [`WrongLength`] unless there are exactly [`Panel::byte_len`] bytes.
    pub fn render(&self, bytes: &[u8], zoom: Zoom) -> Result<Picture, WrongLength> {
        let codes = self.codes(bytes)?;
        let zoom = zoom.fitted(self.width, self.height);
        let colours: Vec<_> = (0..=u8::MAX).take(usize::from(codes.levels)).map(|code| self.colour(code)).collect();
        let width = self.width * zoom.scale;
        let height = self.height * zoom.scale;
        let gap_row = self.theme.gap.repeat(width as usize);

        let mut rgb = Vec::with_capacity(gap_row.len() * height as usize);
        for row in codes.values.chunks_exact(self.width.max(1) as usize) {
            let lit_row = self.lit_row(row.iter().map(|&code| colours[usize::from(code)]), zoom);
            for _ in zoom.gap..zoom.scale {
                rgb.extend_from_slice(&lit_row);
            }
            for _ in 0..zoom.gap {
                rgb.extend_from_slice(&gap_row);
            }
        }
        Picture::from_rgb(width, height, rgb)
    }

    fn lit_row(&self, colours: impl Iterator<Item = [u8; 3]>, zoom: Zoom) -> Vec<u8> {
        let lit = (zoom.scale - zoom.gap) as usize;
        let gap = self.theme.gap.repeat(zoom.gap as usize);
        let mut row = Vec::new();
        for colour in colours {
            row.extend_from_slice(&colour.repeat(lit));
            row.extend_from_slice(&gap);
        }
        row
    }
}

#[cfg(test)]
mod tests {
    use crate::{Panel, Theme, WrongLength, Zoom};

    const TWO_BY_TWO: Panel = Panel { width: 2, height: 2, ..Panel::SHARP_400X240 };

    fn drawn(zoom: Zoom) -> Vec<String> {
        let picture = TWO_BY_TWO.render(&[0b1000_0000, 0b0100_0000], zoom).expect("two bytes");
        let Theme { dark, light, .. } = TWO_BY_TWO.theme;
        let character = |x, y| match picture.pixel(x, y) {
            Some(colour) if colour == light => '#',
            Some(colour) if colour == dark => '.',
            _ => ' ',
        };
        (0..picture.height()).map(|y| (0..picture.width()).map(|x| character(x, y)).collect()).collect()
    }

    #[test]
    fn pixel_for_pixel() {
        assert_eq!(drawn(Zoom::NONE), ["#.", ".#"]);
    }

    #[test]
    fn a_gap_is_right_of_each_pixel_and_below() {
        assert_eq!(drawn(Zoom { scale: 3, gap: 1 }), ["## .. ", "## .. ", "      ", ".. ## ", ".. ## ", "      "]);
    }

    #[test]
    fn an_impossible_zoom_is_made_possible() {
        let all_gap = Zoom { scale: 2, gap: u32::MAX };
        assert_eq!(drawn(all_gap), ["# . ", "    ", ". # ", "    "]);
        assert_eq!(drawn(Zoom { scale: 0, gap: 5 }), ["#.", ".#"]);
    }

    #[test]
    fn a_panel_without_pixels_gives_a_picture_without() {
        for (width, height) in [(0, 0), (0, 7), (7, 0)] {
            let panel = Panel { width, height, ..TWO_BY_TWO };
            let picture = panel.render(&[], Zoom::NONE).expect("no bytes");
            assert_eq!((picture.width(), picture.height()), (width, height));
        }
    }

    #[test]
    fn too_few_bytes_are_refused() {
        let error = TWO_BY_TWO.render(&[0], Zoom::NONE).expect_err("one byte of two");
        let (expected, found) = (2, 1);
        assert_eq!(error, WrongLength { expected, found });
        assert_eq!(error.to_string(), "expected 2 bytes, found 1");
    }
}
