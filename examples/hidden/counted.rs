//! Counting: pixels while they are drawn, and the instructions that the benches have counted.

use std::ops::Range;

use aquatint::{Rect, Target};

/// What `cargo bench` has counted: platform, item, who, instructions.
const RESULTS: &str = include_str!("../../benches/results.tsv");

/// The instructions of one of our items on the desk.
pub fn instructions(item: &str, panel: &str) -> Option<u64> {
    let begins = format!("host\t{item}/{panel}\taquatint\t");
    RESULTS.lines().find_map(|line| line.strip_prefix(&begins)?.parse().ok())
}

/// A target that counts how often each pixel is given.
pub struct Counted<T> {
    target: T,
    writes: Vec<u32>,
}

impl<T: Target> Counted<T> {
    pub fn new(target: T) -> Self {
        let bounds = target.bounds();
        let pixels = bounds.width() as usize * bounds.height() as usize;
        Self { target, writes: vec![0; pixels] }
    }

    /// How often a pixel that was given at all was given, in the mean.
    #[expect(clippy::cast_precision_loss, reason = "few pixels")]
    pub fn overdraw(&self) -> f64 {
        let given = self.writes.iter().filter(|writes| **writes > 0).count();
        f64::from(self.writes.iter().sum::<u32>()) / given.max(1) as f64
    }

    fn count(&mut self, row: i32, column: i32) {
        let Rect { left, top, .. } = self.target.bounds();
        let place = row.abs_diff(top) * self.target.bounds().width() + column.abs_diff(left);
        if let Some(writes) = self.writes.get_mut(place as usize) {
            *writes += 1;
        }
    }
}

impl<T: Target> Target for Counted<T> {
    type Color = T::Color;
    type Error = T::Error;

    fn bounds(&self) -> Rect {
        self.target.bounds()
    }

    fn fill_run<const N: usize>(
        &mut self,
        row: i32,
        columns: Range<i32>,
        colors: [T::Color; N],
    ) -> Result<(), T::Error> {
        columns.clone().for_each(|column| self.count(row, column));
        self.target.fill_run(row, columns, colors)
    }

    fn write_run(
        &mut self,
        row: i32,
        columns: Range<i32>,
        colors: impl Iterator<Item = Option<T::Color>>,
    ) -> Result<(), T::Error> {
        let colors: Vec<_> = colors.take(columns.len()).collect();
        for (column, color) in columns.clone().zip(&colors) {
            if color.is_some() {
                self.count(row, column);
            }
        }
        self.target.write_run(row, columns, colors.into_iter())
    }
}
