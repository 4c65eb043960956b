//! Shapes that share edges share pixels, and none of their area is lost or counted twice.

use aquatint::{Outline, Pen, Point2, Polygon, Rect, Rule};
use proptest::{collection::vec, prelude::*};

use super::{WINDOW, apart, drawn, oracle, point, worst};

/// Cells across and down.
const ACROSS: usize = 5;
const DOWN: usize = 4;
/// 32768ths of a pixel that a sum of shapes may be off: edges are rounded in other bands on the other side.
const SUM: i32 = 4;

/// The corners of a grid, moved so little that cells stay apart, and all of them by a part of a pixel.
fn corners() -> impl Strategy<Value = Vec<Point2>> {
    let jitter = vec((-40..=40_i32, -40..=40_i32), (ACROSS + 1) * (DOWN + 1));
    (jitter, 0..16_i32, 0..16_i32).prop_map(|(jitter, right, down)| {
        let place = |(index, (x, y)): (usize, (i32, i32))| {
            let whole = |cell: usize| i32::try_from(cell).expect("few") * 90;
            Point2::from_sixteenths(
                whole(index % (ACROSS + 1)) + x + right + 8,
                whole(index / (ACROSS + 1)) + y + down + 8,
            )
        };
        jitter.into_iter().enumerate().map(place).collect()
    })
}

/// The four corners of a cell, clockwise.
fn quad(corners: &[Point2], index: usize) -> [Point2; 4] {
    let upper = index / ACROSS * (ACROSS + 1) + index % ACROSS;
    let lower = upper + ACROSS + 1;
    [corners[upper], corners[upper + 1], corners[lower + 1], corners[lower]]
}

/// The outer border of the grid.
fn border(corners: &[Point2]) -> Vec<Point2> {
    let (wide, last) = (ACROSS + 1, (ACROSS + 1) * (DOWN + 1) - 1);
    let right = (1..=DOWN).map(|row| row * wide + ACROSS);
    let left = (1..DOWN).rev().map(|row| row * wide);
    let around = (0..wide).chain(right).chain((DOWN * wide..last).rev()).chain(left);
    around.map(|index| corners[index]).collect()
}

fn polygon(corners: &[Point2]) -> Vec<u16> {
    drawn(&Polygon::new(&[corners]).expect("in range"), Rule::NonZero, WINDOW)
}

/// An outline that is drawn several times.
struct Repeated<O>(O, usize);

impl<O: Outline> Outline for Repeated<O> {
    fn trace<P: Pen>(&self, pen: &mut P) {
        (0..self.1).for_each(|_| self.0.trace(pen));
    }

    fn trace_fine<P: Pen>(&self, pen: &mut P) {
        (0..self.1).for_each(|_| self.0.trace_fine(pen));
    }
}

/// A part of a slanting bar, between two of its steps.
fn bar(origin: (i32, i32), step: (i32, i32), across: (i32, i32), steps: [i32; 2]) -> [Point2; 4] {
    let at = |along: i32, wide: i32| {
        let (x, y) = (origin.0 + along * step.0 + wide * across.0, origin.1 + along * step.1 + wide * across.1);
        Point2::from_sixteenths(x, y)
    };
    [at(steps[0], 0), at(steps[1], 0), at(steps[1], 1), at(steps[0], 1)]
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(1_000))]

    #[test]
    fn cells_that_abut_sum_to_the_whole(corners in corners()) {
        let mut sums = vec![0_i32; WINDOW.width() as usize * WINDOW.height() as usize];
        for index in 0..ACROSS * DOWN {
            let cell = polygon(&quad(&corners, index));
            sums.iter_mut().zip(cell).for_each(|(sum, part)| *sum += i32::from(part));
        }
        let whole = polygon(&border(&corners));
        for (sum, whole) in sums.iter().zip(&whole) {
            prop_assert!((sum - i32::from(*whole)).abs() <= SUM, "{sum} {whole}");
        }
    }

    #[test]
    fn a_shape_upon_itself_is_the_shape(corners in vec(point(), 3..7), times in 2..4_usize) {
        let contours = [&corners[..]];
        let shape = Polygon::new(&contours).expect("in range");
        let once = drawn(&shape, Rule::NonZero, WINDOW);
        let off = apart(&drawn(&Repeated(&shape, times), Rule::NonZero, WINDOW), &once);
        prop_assert!(off <= 4, "{off}");
        let even = drawn(&Repeated(&shape, 2), Rule::EvenOdd, WINDOW);
        prop_assert_eq!(even.iter().max(), Some(&0));
    }

    #[test]
    fn parts_that_overlap_along_their_sides_are_one(
        origin in (0..400_i32, 0..300_i32), step in (-40..40_i32, -40..40_i32), across in (-90..90_i32, -90..90_i32),
        ends in (0..4, 4..6, 6..10),
    ) {
        let parts = [[0, ends.1], [ends.0, ends.2]].map(|steps| bar(origin, step, across, steps));
        let both = drawn(&Polygon::new(&[&parts[0], &parts[1]]).expect("in range"), Rule::NonZero, WINDOW);
        let whole = bar(origin, step, across, [0, ends.2]);
        let off = apart(&both, &polygon(&whole));
        prop_assert!(off <= 32, "{off}");
        let exact = oracle::coverage(&Polygon::new(&[&whole]).expect("in range"), Rule::NonZero, WINDOW);
        prop_assert!(worst(&both, &exact) <= 1.0);
    }
}

#[test]
fn nothing_is_lost_between_slanting_stripes() {
    // Stripes from far outside of the window to far outside, on each of its sides.
    let window = Rect::new(0, 0, 24, 24);
    for slant in [-3000, -170, -16, -1, 0, 1, 5, 90, 1600] {
        let mut sums = vec![0_i32; 24 * 24];
        let line = |stripe: i32| [(stripe * 7 - slant, -500), (stripe * 7 + slant, 900)];
        for stripe in -600..600 {
            let ([a, b], [c, d]) = (line(stripe), line(stripe + 1));
            let corners = [a, c, d, b].map(|(x, y)| Point2::from_sixteenths(x, y));
            let part = drawn(&Polygon::new(&[&corners]).expect("in range"), Rule::NonZero, window);
            sums.iter_mut().zip(part).for_each(|(sum, part)| *sum += i32::from(part));
        }
        let (least, most) = (sums.iter().min(), sums.iter().max());
        assert!(sums.iter().all(|sum| (sum - 32_768).abs() <= SUM), "{slant}: {least:?} to {most:?}");
    }
}
