//! The slow truth about a frame: every pixel by itself, and by hand where it lies in the bytes.
#![allow(dead_code, reason = "each test file uses a part")]

pub mod drawings;
pub mod steps;

use core::{convert::Infallible, fmt::Debug};

use aquatint::{Code, Frame, Rect, Spacing, Target, display::layout::Layout};
use embedded_graphics::{
    Pixel,
    draw_target::DrawTarget,
    geometry::{OriginDimensions, Point, Size},
    image::GetPixel,
    pixelcolor::PixelColor,
};

/// Calls a generic function for each packing that a panel may have.
macro_rules! on_every_layout {
    ($check:ident($($argument:expr),*)) => {
        $check::<BinaryColor, Rows>(Packing::Rows, $($argument),*);
        $check::<BinaryColor, Rows<LsbFirst>>(Packing::RowsLsbFirst, $($argument),*);
        $check::<BinaryColor, Inverted<Rows>>(Packing::RowsInverted, $($argument),*);
        $check::<BinaryColor, Pages>(Packing::Pages, $($argument),*);
        $check::<BinaryColor, Pages<MsbFirst>>(Packing::PagesMsbFirst, $($argument),*);
        $check::<BinaryColor, Inverted<Pages>>(Packing::PagesInverted, $($argument),*);
        $check::<BinaryColor, Columns>(Packing::Columns, $($argument),*);
        $check::<BinaryColor, Columns<LsbFirst>>(Packing::ColumnsLsbFirst, $($argument),*);
        $check::<Gray2, Rows>(Packing::Rows, $($argument),*);
        $check::<Gray2, Rows<LsbFirst>>(Packing::RowsLsbFirst, $($argument),*);
        $check::<Gray2, Planes>(Packing::Planes, $($argument),*);
        $check::<Gray2, Planes<LsbFirst>>(Packing::PlanesLsbFirst, $($argument),*);
        $check::<Gray4, Rows>(Packing::Rows, $($argument),*);
        $check::<Gray4, Rows<LsbFirst>>(Packing::RowsLsbFirst, $($argument),*);
        $check::<Gray4, Inverted<Rows>>(Packing::RowsInverted, $($argument),*);
        $check::<Gray8, Rows>(Packing::Rows, $($argument),*);
    };
}

/// What memory holds that nothing was drawn on.
pub const GUARD: u8 = 0xA5;

/// How a display packs its pixels.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Packing {
    /// Rows of pixels, the leftmost in the highest bits.
    Rows,
    /// The same, the leftmost in the lowest bits.
    RowsLsbFirst,
    /// Rows with every bit turned over.
    RowsInverted,
    /// Bytes of eight rows, the topmost in the lowest bit.
    Pages,
    /// The same, the topmost in the highest bit.
    PagesMsbFirst,
    /// Pages with every bit turned over.
    PagesInverted,
    /// Columns of pixels, the topmost in the highest bit.
    Columns,
    /// The same, the topmost in the lowest bit.
    ColumnsLsbFirst,
    /// Rows of the low bits, then rows of the high bits.
    Planes,
    /// The same, the leftmost in the lowest bit.
    PlanesLsbFirst,
}

/// Where one bit of a pixel is in memory.
struct Place {
    line: usize,
    byte: usize,
    bit: usize,
}

impl Packing {
    /// Where bit `number` of the code of `bits` bits of a pixel is, in a picture of some height.
    fn place(self, (x, y): (usize, usize), height: usize, (number, bits): (usize, usize)) -> Place {
        // Bits are counted from the lowest; the first pixel of a byte has the highest.
        let from_high = |at: usize| Place { line: y, byte: at * bits / 8, bit: 8 - bits - at * bits % 8 + number };
        let from_low = |at: usize| Place { line: y, byte: at * bits / 8, bit: at * bits % 8 + number };
        let plane = |bit: usize| Place { line: y + number * height, byte: x / 8, bit };
        match self {
            Self::Rows | Self::RowsInverted => from_high(x),
            Self::RowsLsbFirst => from_low(x),
            Self::Pages | Self::PagesInverted => Place { line: y / 8, byte: x, bit: y % 8 },
            Self::PagesMsbFirst => Place { line: y / 8, byte: x, bit: 7 - y % 8 },
            Self::Columns => Place { line: x, ..from_high(y) },
            Self::ColumnsLsbFirst => Place { line: x, ..from_low(y) },
            Self::Planes => plane(7 - x % 8),
            Self::PlanesLsbFirst => plane(x % 8),
        }
    }

    fn is_inverted(self) -> bool {
        matches!(self, Self::RowsInverted | Self::PagesInverted)
    }
}

/// A display that can only draw pixels, and that knows which were drawn.
#[derive(Clone, Debug)]
pub struct Reference<C> {
    width: u32,
    height: u32,
    pixels: Vec<Option<C>>,
}

impl<C: PixelColor> Reference<C> {
    pub fn new(width: u32, height: u32) -> Self {
        Self { width, height, pixels: vec![None; width as usize * height as usize] }
    }

    /// Asks for the colour of every pixel there is; `None` leaves it as it was.
    pub fn draw(&mut self, color: impl Fn(i32, i32) -> Option<C>) {
        let (width, height) = (self.width.cast_signed(), self.height.cast_signed());
        let places = (0..height).flat_map(|y| (0..width).map(move |x| (x, y)));
        for ((x, y), pixel) in places.zip(&mut self.pixels) {
            *pixel = color(x, y).or(*pixel);
        }
    }

    pub fn pixels(&self) -> &[Option<C>] {
        &self.pixels
    }
}

impl<C: Code> Reference<C> {
    /// `memory` with the drawn pixels in it.
    pub fn packed(&self, packing: Packing, spacing: Spacing, mut memory: Vec<u8>) -> Vec<u8> {
        let (width, height, bits) = (self.width as usize, self.height as usize, C::BITS as usize);
        for (index, color) in self.pixels.iter().enumerate() {
            let Some(color) = color else { continue };
            let code = if packing.is_inverted() { !color.code() } else { color.code() };
            for number in 0..bits {
                let Place { line, byte, bit } = packing.place((index % width, index / width), height, (number, bits));
                let byte = &mut memory[spacing.before + line * spacing.stride + byte];
                *byte = *byte & !(1 << bit) | (code >> number & 1) << bit;
            }
        }
        memory
    }
}

impl<C> OriginDimensions for Reference<C> {
    fn size(&self) -> Size {
        Size::new(self.width, self.height)
    }
}

impl<C: PixelColor> DrawTarget for Reference<C> {
    type Color = C;
    type Error = Infallible;

    fn draw_iter<I: IntoIterator<Item = Pixel<C>>>(&mut self, pixels: I) -> Result<(), Infallible> {
        for Pixel(point, color) in pixels {
            let inside = |at: i32, size: u32| usize::try_from(at).ok().filter(|&at| at < size as usize);
            if let (Some(x), Some(y)) = (inside(point.x, self.width), inside(point.y, self.height)) {
                self.pixels[y * self.width as usize + x] = Some(color);
            }
        }
        Ok(())
    }
}

/// Draws on a frame in the middle of memory, which must hold what the reference has, and no more; then
/// again with bytes around the lines.
pub fn conform<C: Code + Debug, L: Layout<C>>(
    packing: Packing,
    expected: &Reference<C>,
    draw: impl Fn(&mut Frame<C, L, &mut [u8]>),
) {
    let size = expected.size();
    let stride = L::SHAPE.stride(size.width, size.height);
    for spacing in [Spacing { before: 0, stride }, Spacing { before: 3, stride: stride + 2 }] {
        let lines = usize::try_from(L::SHAPE.lines(size.width, size.height)).expect("few");
        let needed = spacing.before + lines * spacing.stride;
        let mut memory = vec![GUARD; needed + 16];
        let mut frame =
            Frame::<C, L, _>::with_spacing(&mut memory[8..], size, spacing).expect("8 bytes more than enough");
        draw(&mut frame);
        for ((x, y), &color) in places(frame.bounds()).zip(expected.pixels()) {
            assert!(color.is_none() || frame.pixel(Point::new(x, y)) == color, "{packing:?}, {size}: {x}, {y}");
        }
        let drawn = expected.packed(packing, spacing, vec![GUARD; needed]);
        assert_eq!(frame.memory(), drawn, "{packing:?}, {size}, {spacing:?}");
        assert_eq!([&memory[..8], &memory[8 + needed..]], [[GUARD; 8]; 2]);
    }
}

/// The pixels of an area, row by row.
pub fn places(area: Rect) -> impl Iterator<Item = (i32, i32)> {
    area.rows().flat_map(move |y| area.columns().map(move |x| (x, y)))
}

pub fn size_u32(size: usize) -> u32 {
    u32::try_from(size).expect("small")
}

/// Sizes of the tests are small.
pub fn size_i32(size: usize) -> i32 {
    i32::try_from(size).expect("small")
}
