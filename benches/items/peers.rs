//! What the items are drawn on, and how the peers of aquatint draw there.

use core::{convert::Infallible, fmt::Debug};

use display_interface::{DataFormat, DisplayError, WriteOnlyDataCommand};
use embedded_graphics::{
    Drawable,
    draw_target::{DrawTarget, DrawTargetExt},
    framebuffer::Framebuffer,
    geometry::Point,
    image::{Image, ImageRaw},
    mono_font::{MonoTextStyle, ascii::FONT_6X10},
    pixelcolor::{BinaryColor, PixelColor},
    primitives::{self, Primitive, PrimitiveStyle},
    text::Text,
};
use ssd1306::{Ssd1306, mode::BufferedGraphicsMode, prelude::*};

use super::pictures::{BITS_SIZE, bits};

/// What not everybody draws by embedded-graphics; these are embedded-graphics' own ways.
pub trait Shapes: DrawTarget<Color: From<BinaryColor>, Error: Debug> + Sized {
    /// A line one pixel wide.
    fn line(&mut self, [start, end]: [Point; 2], color: Self::Color) -> Result<(), Self::Error> {
        primitives::Line::new(start, end).into_styled(PrimitiveStyle::with_stroke(color, 1)).draw(self)
    }

    /// A filled triangle.
    fn triangle(&mut self, [a, b, c]: [Point; 3], color: Self::Color) -> Result<(), Self::Error> {
        primitives::Triangle::new(a, b, c).into_styled(PrimitiveStyle::with_fill(color)).draw(self)
    }

    /// The outline of a circle, one pixel wide, from its top left corner and its diameter.
    fn circle(&mut self, corner: Point, diameter: u32, color: Self::Color) -> Result<(), Self::Error> {
        let style = PrimitiveStyle::with_stroke(color, 1);
        primitives::Circle::new(corner, diameter).into_styled(style).draw(self)
    }

    /// A filled circle.
    fn disc(&mut self, corner: Point, diameter: u32, color: Self::Color) -> Result<(), Self::Error> {
        primitives::Circle::new(corner, diameter).into_styled(PrimitiveStyle::with_fill(color)).draw(self)
    }

    /// Text in `FONT_6X10`.
    fn text(&mut self, text: &str, at: Point, color: Self::Color) -> Result<(), Self::Error> {
        write_text(self, text, at, color)
    }

    /// The picture of [`bits`].
    fn image(&mut self, at: Point) -> Result<(), Self::Error> {
        draw_image(self, at)
    }
}

/// Those who fill polygons of any number of corners.
pub trait Polygons: Surface {
    fn polygon(&mut self, corners: &[Point], color: Self::Color) -> Result<(), Self::Error>;
}

/// Text as embedded-graphics writes it.
pub fn write_text<D: DrawTarget>(target: &mut D, text: &str, at: Point, color: D::Color) -> Result<(), D::Error> {
    Text::new(text, at, MonoTextStyle::new(&FONT_6X10, color)).draw(target).map(drop)
}

/// The bits as embedded-graphics draws them.
pub fn draw_image<D: DrawTarget<Color: From<BinaryColor>>>(target: &mut D, at: Point) -> Result<(), D::Error> {
    let image = ImageRaw::<BinaryColor>::new(bits(), BITS_SIZE.width);
    Image::new(&image, at).draw(&mut target.color_converted())
}

/// A whole picture in memory.
pub trait Surface: Shapes {
    /// Shows the packed picture to `look`, in the same order for all who draw on the same panel.
    #[cfg_attr(target_os = "none", expect(dead_code, reason = "pictures are compared on the desk"))]
    fn picture(&self, look: impl FnOnce(&[u8]));
}

impl<C, R, O, const W: usize, const H: usize, const N: usize> Shapes for Framebuffer<C, R, O, W, H, N>
where
    C: PixelColor<Raw = R> + From<BinaryColor>,
    Self: DrawTarget<Color = C, Error = Infallible>,
{
}

impl<C, R, O, const W: usize, const H: usize, const N: usize> Surface for Framebuffer<C, R, O, W, H, N>
where
    C: PixelColor<Raw = R> + From<BinaryColor>,
    Self: DrawTarget<Color = C, Error = Infallible>,
{
    fn picture(&self, look: impl FnOnce(&[u8])) {
        look(self.data());
    }
}

/// An SSD1306 with the buffer of its driver, on no bus.
pub type Oled = Ssd1306<Bus, DisplaySize128x64, BufferedGraphicsMode<DisplaySize128x64>>;

pub fn ssd1306() -> Oled {
    let bus = Bus { bytes: [0; 1024], sent: 0 };
    Ssd1306::new(bus, DisplaySize128x64, DisplayRotation::Rotate0).into_buffered_graphics_mode()
}

impl Shapes for Oled {}

impl Surface for Oled {
    /// What the driver would send, because it does not show its buffer: the whole picture, since it
    /// was cleared and not sent.
    fn picture(&self, look: impl FnOnce(&[u8])) {
        let mut copy = self.clone();
        copy.flush().expect("the bus takes a whole picture");
        look(&copy.release().bytes);
    }
}

/// Keeps the bytes that a panel would get.
#[derive(Clone, Debug)]
pub struct Bus {
    bytes: [u8; 1024],
    sent: usize,
}

impl WriteOnlyDataCommand for Bus {
    fn send_commands(&mut self, _commands: DataFormat<'_>) -> Result<(), DisplayError> {
        Ok(())
    }

    fn send_data(&mut self, data: DataFormat<'_>) -> Result<(), DisplayError> {
        let DataFormat::U8(data) = data else { return Err(DisplayError::DataFormatNotImplemented) };
        let end = self.sent + data.len();
        self.bytes.get_mut(self.sent..end).ok_or(DisplayError::BusWriteError)?.copy_from_slice(data);
        self.sent = end;
        Ok(())
    }
}
