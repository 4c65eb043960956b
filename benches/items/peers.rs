//! What the items are drawn on, and how aquatint and its peers draw a line and a triangle there.

use core::{convert::Infallible, fmt::Debug};

use aquatint::{Code, FillStyle, Frame, Line, Point2, Polygon, StrokeStyle, Window, display::layout::Layout};
use display_interface::{DataFormat, DisplayError, WriteOnlyDataCommand};
use embedded_graphics::{
    Drawable,
    draw_target::DrawTarget,
    framebuffer::Framebuffer,
    geometry::Point,
    pixelcolor::{BinaryColor, PixelColor},
    primitives::{self, Primitive, PrimitiveStyle},
};
use ssd1306::{Ssd1306, mode::BufferedGraphicsMode, prelude::*};

/// The shapes that not everybody draws by embedded-graphics; these are embedded-graphics' own.
pub trait Shapes: DrawTarget<Color: From<BinaryColor>, Error: Debug> + Sized {
    /// A line one pixel wide.
    fn line(&mut self, [start, end]: [Point; 2], color: Self::Color) -> Result<(), Self::Error> {
        primitives::Line::new(start, end).into_styled(PrimitiveStyle::with_stroke(color, 1)).draw(self)
    }

    /// A filled triangle.
    fn triangle(&mut self, [a, b, c]: [Point; 3], color: Self::Color) -> Result<(), Self::Error> {
        primitives::Triangle::new(a, b, c).into_styled(PrimitiveStyle::with_fill(color)).draw(self)
    }
}

/// A whole picture in memory.
pub trait Surface: Shapes {
    /// Shows the packed picture to `look`, in the same order for all who draw on the same panel.
    #[cfg_attr(target_os = "none", expect(dead_code, reason = "pictures are compared on the desk"))]
    fn picture(&self, look: impl FnOnce(&[u8]));
}

impl<C: Code + From<BinaryColor>, L: Layout<C>> Shapes for Frame<C, L, &mut [u8]> {
    fn line(&mut self, ends: [Point; 2], color: C) -> Result<(), Infallible> {
        stroke(ends, color, self)
    }

    fn triangle(&mut self, corners: [Point; 3], color: C) -> Result<(), Infallible> {
        fill(&corners.map(|Point { x, y }| Point2::corner(x, y)), color, self)
    }
}

impl<T: Shapes> Shapes for Window<'_, T> {
    fn line(&mut self, ends: [Point; 2], color: T::Color) -> Result<(), T::Error> {
        stroke(ends, color, self)
    }

    fn triangle(&mut self, corners: [Point; 3], color: T::Color) -> Result<(), T::Error> {
        fill(&corners.map(|Point { x, y }| Point2::corner(x, y)), color, self)
    }
}

impl<C: Code + From<BinaryColor>, L: Layout<C>> Surface for Frame<C, L, &mut [u8]> {
    fn picture(&self, look: impl FnOnce(&[u8])) {
        look(self.bytes());
    }
}

fn stroke<D: DrawTarget>([start, end]: [Point; 2], color: D::Color, target: &mut D) -> Result<(), D::Error> {
    Line::new(start, end).into_styled(StrokeStyle::new(color)).draw(target)
}

/// Fills one contour.
pub fn fill<D: DrawTarget>(corners: &[Point2], color: D::Color, target: &mut D) -> Result<(), D::Error> {
    let contours = [corners];
    // Corners out of range would show as a picture that differs from the peer's, or is empty.
    let Ok(polygon) = Polygon::new(&contours) else { return Ok(()) };
    polygon.into_styled(FillStyle::new(color)).draw(target)
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
