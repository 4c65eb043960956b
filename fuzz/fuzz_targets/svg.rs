//! Any text as SVG path data: an error with a place in it, or a path with the same contours however it is traced.
#![no_main]

use aquatint::{Affine, Outline, Pen, Point2, Scalar, SvgPath};
use arbitrary::Arbitrary;
use libfuzzer_sys::fuzz_target;

#[derive(Arbitrary, Debug)]
struct Input<'a> {
    map: [i32; 4],
    to: (i32, i32),
    data: &'a str,
}

/// Counts contours.
#[derive(Default)]
struct Counted {
    contours: usize,
    closed: usize,
}

impl Pen for Counted {
    fn move_to(&mut self, _: Point2) {
        self.contours += 1;
    }

    fn line_to(&mut self, _: Point2) {
        assert!(self.contours > self.closed, "a contour is open");
    }

    fn close(&mut self) {
        self.closed += 1;
    }
}

fn check(path: &SvgPath) {
    let (mut coarse, mut fine) = (Counted::default(), Counted::default());
    path.trace(&mut coarse);
    path.trace_fine(&mut fine);
    assert_eq!((coarse.contours, coarse.closed), (fine.contours, fine.closed));
}

fuzz_target!(|input: Input| {
    let path = match SvgPath::new(input.data) {
        Ok(path) => path,
        Err(error) => return assert!(input.data.is_char_boundary(error.offset), "{error}"),
    };
    check(&path);
    let [a, b, c, d] = input.map.map(Scalar::from_bits);
    check(&path.with_map(Affine::new([a, b], [c, d], Point2::from_sixteenths(input.to.0, input.to.1))));
    check(&path.scaled(a));
});
