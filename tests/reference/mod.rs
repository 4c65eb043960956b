//! The slow truth about a frame: every pixel by itself, and by hand where it lies in the bytes.
#![allow(dead_code, reason = "each test file uses a part")]

pub mod drawings;
pub mod steps;

use core::{convert::Infallible, fmt::Debug};

use aquatint::{Code, Frame, Rect, Target, display::layout::Layout};
use embedded_graphics::{
    Pixel,
    draw_target::DrawTarget,
    geometry::{OriginDimensions, Point, Size},
    image::GetPixel,
};

/// Calls a generic function for each packing that a panel may have.
macro_rules! on_every_layout {
    ($check:ident($($argument:expr),*)) => {
        $check::<BinaryColor, Rows>(Packing::Rows, $($argument),*);
        $check::<BinaryColor, Pages>(Packing::Pages, $($argument),*);
        $check::<Gray2, Rows>(Packing::Rows, $($argument),*);
        $check::<Gray4, Rows>(Packing::Rows, $($argument),*);
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
    /// Bytes of eight rows, the topmost in the lowest bit.
    Pages,
}

/// A display that can only draw pixels, and that knows which were drawn.
#[derive(Clone, Debug)]
pub struct Reference<C> {
    width: u32,
    height: u32,
    pixels: Vec<Option<C>>,
}

impl<C: Code> Reference<C> {
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

    /// `bytes` with the drawn pixels in them.
    pub fn packed(&self, packing: Packing, mut bytes: Vec<u8>) -> Vec<u8> {
        let (width, bits) = (self.width as usize, C::BITS as usize);
        let row_bytes = (width * bits).div_ceil(8);
        for (index, color) in self.pixels.iter().enumerate() {
            let (x, y) = (index % width, index / width);
            let (byte, shift) = match packing {
                Packing::Rows => (y * row_bytes + x * bits / 8, 8 - bits - x * bits % 8),
                Packing::Pages => (y / 8 * width + x, y % 8),
            };
            if let Some(color) = color {
                let mask = (0xFF >> (8 - bits)) << shift;
                bytes[byte] = bytes[byte] & !mask | color.code() << shift;
            }
        }
        bytes
    }
}

impl<C> OriginDimensions for Reference<C> {
    fn size(&self) -> Size {
        Size::new(self.width, self.height)
    }
}

impl<C: Code> DrawTarget for Reference<C> {
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

/// Draws on a frame in the middle of memory, which must hold what the reference has, and no more.
pub fn conform<C: Code + Debug, L: Layout<C>>(
    packing: Packing,
    expected: &Reference<C>,
    draw: impl FnOnce(&mut Frame<C, L, &mut [u8]>),
) {
    let size = expected.size();
    let needed = Frame::<C, L, ()>::bytes_needed(size.width, size.height);
    let mut memory = vec![GUARD; needed + 16];
    let mut frame = Frame::<C, L, _>::new(&mut memory[8..], size.width, size.height).expect("8 bytes more than enough");
    draw(&mut frame);
    for ((x, y), &color) in places(frame.bounds()).zip(expected.pixels()) {
        assert!(color.is_none() || frame.pixel(Point::new(x, y)) == color, "{packing:?}, {size}: {x}, {y}");
    }
    assert_eq!(frame.bytes(), expected.packed(packing, vec![GUARD; needed]), "{packing:?}, {size}");
    assert_eq!([&memory[..8], &memory[8 + needed..]], [[GUARD; 8]; 2]);
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
