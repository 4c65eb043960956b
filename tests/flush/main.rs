//! From a packed frame to a real panel: functions to copy, each with the proof of what it puts on the wires.
//!
//! | panel | file | by | bus writes | bytes | taken in place |
//! |---|---|---|---|---|---|
//! | SSD1306, SPI | `oled_spi` | `ssd1306` | 3 | 1030 | 1 of 1 |
//! | | | what changed | 2 a window, 1 a page | 6 a window | all |
//! | SSD1306, I²C | `oled_i2c` | `ssd1306` | 66 | 1096 | 0 of 64 |
//! | | | one transaction | 3 | 1032 | 1 of 1 |
//! | | | prefix in memory | 2 | 1032 | 1 of 1 |
//! | SSD1306, async SPI | `oled_async` | hand | 2 | 1030 | 1 of 1 |
//! | SSD1680 e-paper 122×250 | `epaper` | `weact-studio-epd` | 43 | 16,059 | 4 of 4 |
//! | | | what changed | 30 a window, 5 | 42 a window + 3 times its bytes, 157 | all of full width |
//! | SSD1680 e-paper 128×296 | `epaper` | `epd-waveshare` | 4740 | 4740 | 0 of 4736 |
//! | Sharp LS027B7DH01 | `sharp` | hand | 481 | 12,482 | 240 of 240 |
//! | | | lines that changed | 2 a line, 1 | 52 a line, 2 | all |
//! | | | addresses in memory | 1 | 12,482 | 1 of 1 |
//! | SSD1322 256×64 | `grey_oled` | hand | 6 | 8199 | 1 of 1 |
//! | | | what changed | 5 a window, 1 a row | 7 a window | all |
//! | SSD1327 128×128 | `grey_oled` | hand | 2 | 8198 | 1 of 1 |
//! | ST7565 128×64 | `st7565_lcd` | `st7565` | 24 | 1048 | 8 of 8 |
//! | ST7789 240×240, shapes | `tft` | `mipidsi` | 7 a span | 11 + 2 a pixel | no frame |
//! | ST7789 240×240, from 4 bits | `tft` | `mipidsi` | 119 | 115,211 | widened to RGB565 |
//!
//! "Taken in place" is proved by address: the slice that reached the bus is the frame's own memory.

mod bus;
mod epaper;
mod grey_oled;
mod oled_async;
mod oled_i2c;
mod oled_spi;
mod sharp;
mod st7565_lcd;
mod tft;

use std::{convert::Infallible, fmt::Debug};

use aquatint::{
    Code, Dithered, FillStyle, Frame, Levels, Light, OnDrawTarget, Point2, Polygon, Rect, Target,
    display::layout::Layout,
};
use aquatint_simulator::Panel;
use embedded_graphics::{image::GetPixel, pixelcolor::BinaryColor, prelude::*, primitives::Rectangle};

/// A ramp of light to the bottom right, dithered, and a triangle: no row, column or byte like its neighbours.
fn draw_picture<D>(target: &mut D, levels: Levels)
where
    D: DrawTarget<Color: Code, Error = Infallible>,
{
    let Rect { right, bottom, .. } = target.bounding_box().into();
    let mut on_target = OnDrawTarget::new(target);
    let mut dithered = Dithered::new(&mut on_target, levels);
    let end = right + 3 * bottom;
    for row in 0..bottom {
        let light = |column| u16::try_from((column + 3 * row) * 65_535 / end).expect("16 bits");
        let Ok(()) = dithered.write_run(row, 0..right, (0..right).map(|column| Some(Light(light(column)))));
    }
    let triangle = [(1, 2), (right - 2, bottom / 3), (right / 4, bottom - 3)].map(|(x, y)| Point2::corner(x, y));
    let contours = [&triangle[..]];
    let polygon = Polygon::new(&contours).expect("in range");
    let Ok(()) = polygon.into_styled(FillStyle::new(D::Color::from_code(0xFF))).draw(target);
}

/// What the panel makes of the bytes that arrived is what the frame holds.
fn assert_shows<C, L, B>(panel: Panel, received: &[u8], frame: &Frame<C, L, B>)
where
    C: Code + Debug,
    L: Layout<C>,
    B: AsRef<[u8]>,
{
    let codes = panel.codes(received).expect("a whole frame");
    let Size { width, height } = frame.size();
    for point in frame.bounding_box().points() {
        let shown = codes.get(point.x.cast_unsigned(), point.y.cast_unsigned());
        assert_eq!(shown.map(C::from_code), frame.pixel(point), "{point}");
    }
    assert_eq!((codes.width, codes.height), (width, height));
    let both = [0, C::from_code(0xFF).code()].iter().all(|code| codes.values.contains(code));
    assert!(both, "a picture with black and white in it");
}

/// Draws the picture on a frame, and again on a plain list of pixels, which must agree.
fn drawn<C, L, B>(mut frame: Frame<C, L, B>, levels: Levels) -> Frame<C, L, B>
where
    C: Code + Debug,
    L: Layout<C>,
    B: AsRef<[u8]> + AsMut<[u8]>,
{
    draw_picture(&mut frame, levels);
    let mut plain =
        Plain { area: frame.bounding_box(), pixels: vec![C::from_code(0); frame.bounding_box().points().count()] };
    draw_picture(&mut plain, levels);
    for (point, pixel) in plain.area.points().zip(plain.pixels) {
        assert_eq!(frame.pixel(point), Some(pixel), "{point}");
    }
    frame
}

/// One bit a pixel, dithered.
fn one_bit<L, B>(frame: Frame<BinaryColor, L, B>) -> Frame<BinaryColor, L, B>
where
    L: Layout<BinaryColor>,
    B: AsRef<[u8]> + AsMut<[u8]>,
{
    drawn(frame, Levels::ONE_BIT)
}

/// Pixels in rows, not packed.
struct Plain<C> {
    area: Rectangle,
    pixels: Vec<C>,
}

impl<C> Dimensions for Plain<C> {
    fn bounding_box(&self) -> Rectangle {
        self.area
    }
}

impl<C: PixelColor> DrawTarget for Plain<C> {
    type Color = C;
    type Error = Infallible;

    fn draw_iter<I: IntoIterator<Item = Pixel<C>>>(&mut self, pixels: I) -> Result<(), Infallible> {
        let width = self.area.size.width;
        for Pixel(point, color) in pixels.into_iter().filter(|Pixel(point, _)| self.area.contains(*point)) {
            self.pixels[(point.y.cast_unsigned() * width + point.x.cast_unsigned()) as usize] = color;
        }
        Ok(())
    }
}
