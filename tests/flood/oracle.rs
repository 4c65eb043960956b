//! Slow and exact: pixels on a sheet, and a breadth-first search through them, one by one.

use std::{cell::Cell, collections::VecDeque};

use aquatint::{Connectivity, Inside, Rect, Runs};
use embedded_graphics::{
    Pixel,
    draw_target::DrawTarget,
    geometry::{Dimensions, Point},
    image::GetPixel,
    pixelcolor::{Gray8, GrayColor},
    primitives::Rectangle,
};

/// A picture anywhere, of somebody else's making: it can be drawn on and read pixel by pixel.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Sheet {
    pub area: Rect,
    pub codes: Vec<u8>,
    /// How many more times it can be drawn on before it fails.
    pub patience: u32,
}

impl Sheet {
    pub fn new(area: Rect, codes: Vec<u8>) -> Self {
        assert_eq!(codes.len(), area.width() as usize * area.height() as usize);
        Self { area, codes, patience: u32::MAX }
    }

    pub fn index(&self, Point { x, y }: Point) -> Option<usize> {
        let inside = self.area.contains(Point::new(x, y));
        inside.then(|| {
            y.abs_diff(self.area.top) as usize * self.area.width() as usize + x.abs_diff(self.area.left) as usize
        })
    }

    pub fn code(&self, at: Point) -> Option<u8> {
        self.index(at).map(|index| self.codes[index])
    }
}

impl GetPixel for Sheet {
    type Color = Gray8;

    fn pixel(&self, at: Point) -> Option<Gray8> {
        self.code(at).map(Gray8::new)
    }
}

impl Dimensions for Sheet {
    fn bounding_box(&self) -> Rectangle {
        self.area.into()
    }
}

impl DrawTarget for Sheet {
    type Color = Gray8;
    type Error = &'static str;

    fn draw_iter<I: IntoIterator<Item = Pixel<Gray8>>>(&mut self, pixels: I) -> Result<(), &'static str> {
        self.patience = self.patience.checked_sub(1).ok_or("the bus is gone")?;
        for Pixel(at, color) in pixels {
            let index = self.index(at).unwrap_or_else(|| panic!("{at} is outside"));
            self.codes[index] = color.luma();
        }
        Ok(())
    }
}

/// The region, pixel by pixel: `true` for those of `sheet`, in the order of its codes.
pub fn region(sheet: &Sheet, seed: Point, by: Connectivity, inside: impl Fn(u8) -> bool, window: Rect) -> Vec<bool> {
    let sides = [(0, -1), (-1, 0), (1, 0), (0, 1)];
    let corners = [(-1, -1), (1, -1), (-1, 1), (1, 1)];
    let neighbours = if by == Connectivity::Four { sides.to_vec() } else { [sides, corners].concat() };
    let is_inside = |at: Point| window.contains(at) && sheet.code(at).is_some_and(&inside);
    let mut found = vec![false; sheet.codes.len()];
    let mut queue: VecDeque<Point> = is_inside(seed).then_some(seed).into_iter().collect();
    found.iter_mut().zip(0..).filter(|(_, index)| Some(*index) == sheet.index(seed)).for_each(|(found, _)| {
        *found = !queue.is_empty();
    });
    while let Some(Point { x, y }) = queue.pop_front() {
        for &(dx, dy) in &neighbours {
            let (Some(x), Some(y)) = (x.checked_add(dx), y.checked_add(dy)) else { continue };
            let at = Point::new(x, y);
            if let Some(index) = sheet.index(at).filter(|&index| !found[index] && is_inside(at)) {
                found[index] = true;
                queue.push_back(at);
            }
        }
    }
    found
}

/// A picture that counts how often it is asked for 32 pixels.
pub struct Counted<'p, P> {
    pub picture: &'p P,
    pub asked: Cell<u32>,
}

impl<P: GetPixel> GetPixel for Counted<'_, P> {
    type Color = P::Color;

    fn pixel(&self, at: Point) -> Option<P::Color> {
        self.picture.pixel(at)
    }
}

impl<P: Dimensions> Dimensions for Counted<'_, P> {
    fn bounding_box(&self) -> Rectangle {
        self.picture.bounding_box()
    }
}

impl<P: Runs> Runs for Counted<'_, P> {
    fn runs(&self, place: Point, inside: Inside<P::Color>, seeds: u32, free: u32) -> u32 {
        self.asked.set(self.asked.get() + 1);
        assert_eq!(seeds & !free, 0, "seeds are free");
        self.picture.runs(place, inside, seeds, free)
    }
}
