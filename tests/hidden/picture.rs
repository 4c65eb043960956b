//! A picture in light that counts how often each pixel is given.

use core::{convert::Infallible, ops::Range};

use aquatint::{Light, Rect, Target};

/// What no surface covers.
pub const GROUND: Light = Light(1);

#[derive(Clone, Debug)]
pub struct Picture {
    pub window: Rect,
    pub lights: Vec<Light>,
    pub writes: Vec<u16>,
}

impl Picture {
    pub fn new(window: Rect) -> Self {
        let pixels = usize::try_from(window.width() * window.height()).expect("small");
        Self { window, lights: vec![GROUND; pixels], writes: vec![0; pixels] }
    }

    fn place(&self, row: i32, column: i32) -> usize {
        let inside = self.window.columns().contains(&column) && self.window.rows().contains(&row);
        assert!(inside, "{column}, {row} is outside");
        let (down, right) = (row.abs_diff(self.window.top), column.abs_diff(self.window.left));
        usize::try_from(down * self.window.width() + right).expect("small")
    }

    /// What a pixel has.
    pub fn at(&self, row: i32, column: i32) -> Light {
        self.lights[self.place(row, column)]
    }

    /// Whether a pixel has been given.
    pub fn is_covered(&self, row: i32, column: i32) -> bool {
        self.writes[self.place(row, column)] > 0
    }

    /// The pixels in which two pictures differ.
    pub fn differing(&self, other: &Self) -> Vec<(i32, i32)> {
        let pixels = self.window.rows().flat_map(|row| self.window.columns().map(move |column| (column, row)));
        let lights = self.lights.iter().zip(&other.lights);
        pixels.zip(lights).filter(|(_, (a, b))| a != b).map(|(pixel, _)| pixel).collect()
    }
}

impl Target for Picture {
    type Color = Light;
    type Error = Infallible;

    fn bounds(&self) -> Rect {
        self.window
    }

    fn fill_run<const N: usize>(
        &mut self,
        row: i32,
        columns: Range<i32>,
        colors: [Light; N],
    ) -> Result<(), Infallible> {
        let period = i32::try_from(N).expect("small");
        let color = |column: i32| colors[usize::try_from(column.rem_euclid(period)).expect("not negative")];
        self.write_run(row, columns.clone(), columns.map(|column| Some(color(column))))
    }

    fn write_run(
        &mut self,
        row: i32,
        columns: Range<i32>,
        colors: impl Iterator<Item = Option<Light>>,
    ) -> Result<(), Infallible> {
        for (column, color) in columns.zip(colors) {
            if let Some(color) = color {
                let place = self.place(row, column);
                self.lights[place] = color;
                self.writes[place] += 1;
            }
        }
        Ok(())
    }
}
