//! A pen that keeps what it is told.

use std::fmt::Write;

use aquatint::{Outline, Pen, Point2};

/// Contours, and which of them were closed.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct Recorder {
    pub contours: Vec<Vec<Point2>>,
    pub closed: Vec<bool>,
}

impl Recorder {
    pub fn of(outline: &impl Outline) -> Self {
        let mut pen = Self::default();
        outline.trace(&mut pen);
        pen
    }

    /// What an SVG would say, in sixteenths.
    pub fn svg(&self) -> String {
        let mut text = String::new();
        for (contour, closed) in self.contours.iter().zip(&self.closed) {
            for (index, point) in contour.iter().enumerate() {
                let verb = if index == 0 { "M" } else { "L" };
                let _ = write!(text, "{verb}{},{} ", point.x.to_bits(), point.y.to_bits());
            }
            text += if *closed { "Z " } else { "" };
        }
        text.trim_end().to_owned()
    }
}

impl Pen for Recorder {
    fn move_to(&mut self, point: Point2) {
        self.contours.push(vec![point]);
        self.closed.push(false);
    }

    fn line_to(&mut self, point: Point2) {
        assert_eq!(self.closed.last(), Some(&false), "a contour is open");
        self.contours.last_mut().expect("a contour").push(point);
    }

    fn close(&mut self) {
        assert_eq!(self.closed.last(), Some(&false), "a contour is open");
        *self.closed.last_mut().expect("a contour") = true;
    }
}
