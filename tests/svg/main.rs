//! SVG path data: the grammar, the commands, arcs, and icons as pictures.

mod arcs;
mod commands;
mod errors;
mod generated;
mod pictures;

use aquatint::{Outline, Pen, Point2, SvgPath};

type Contour = Vec<(i32, i32)>;

/// Contours, and how many of them were closed.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
struct Recorder {
    contours: Vec<Contour>,
    closed: usize,
}

impl Pen for Recorder {
    fn move_to(&mut self, point: Point2) {
        self.contours.push(vec![(point.x.to_bits(), point.y.to_bits())]);
    }

    fn line_to(&mut self, point: Point2) {
        self.contours.last_mut().expect("a contour").push((point.x.to_bits(), point.y.to_bits()));
    }

    fn close(&mut self) {
        self.closed += 1;
    }
}

/// From sixteenths of a unit.
fn at(x: i32, y: i32) -> Point2 {
    Point2::from_sixteenths(x, y)
}

fn coarse(outline: &impl Outline) -> Recorder {
    let mut pen = Recorder::default();
    outline.trace(&mut pen);
    pen
}

fn fine(outline: &impl Outline) -> Recorder {
    let mut pen = Recorder::default();
    outline.trace_fine(&mut pen);
    pen
}

fn path(data: &str) -> SvgPath<'_> {
    SvgPath::new(data).unwrap_or_else(|error| panic!("{data}: {error}"))
}
