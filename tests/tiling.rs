//! A random division of the plane, painted cell by cell: each pixel is touched exactly once.

mod exact;

use aquatint::{Point2, Polygon, Rect, Rule, SpanFn, Triangle, raster::scan::ActiveEdge, vary::Ramp, vary::Vertex};
use exact::{Overdraw, is_inside};
use heapless::Vec as List;
use proptest::{collection::vec, prelude::*};

const WINDOW: Rect = Rect::new(-2, -2, 34, 26);
/// Cells across and down.
const ACROSS: usize = 5;
const DOWN: usize = 4;

/// How a cell of the grid is painted.
#[derive(Clone, Copy, Debug)]
enum Cell {
    /// As a polygon of four corners.
    Whole(Rule),
    /// As two triangles, along either diagonal.
    Split { falling: bool },
    /// As one of the contours of a polygon of several cells.
    Shared,
}

fn cell() -> impl Strategy<Value = Cell> {
    prop_oneof![
        Just(Cell::Whole(Rule::NonZero)),
        Just(Cell::Whole(Rule::EvenOdd)),
        any::<bool>().prop_map(|falling| Cell::Split { falling }),
        Just(Cell::Shared),
    ]
}

/// The corners of the grid: moved so little that cells stay apart, and all of them by a part of a pixel.
fn corners() -> impl Strategy<Value = Vec<Point2>> {
    let jitter = vec((-40..=40_i32, -40..=40_i32), (ACROSS + 1) * (DOWN + 1));
    (jitter, 0..16_i32, 0..16_i32).prop_map(|(jitter, right, down)| {
        let place = |(index, (x, y)): (usize, (i32, i32))| {
            let (column, row) = (index % (ACROSS + 1), index / (ACROSS + 1));
            let whole = |cell: usize| i32::try_from(cell).expect("few") * 90;
            Point2::from_sixteenths(whole(column) + x + right + 8, whole(row) + y + down + 8)
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

fn paint(contours: &[[Point2; 4]], rule: Rule, pixels: &mut Overdraw) {
    let contours: Vec<&[Point2]> = contours.iter().map(<[Point2; 4]>::as_slice).collect();
    let (polygon, window) = (Polygon::new(&contours).expect("in range"), pixels.window());
    let mut edges = List::<ActiveEdge, 8>::new();
    let Ok(()) = polygon.spans(rule, &mut edges, &mut SpanFn::new(window, |row, columns, ()| pixels.add(row, columns)));
}

fn paint_triangle(corners: [Point2; 3], pixels: &mut Overdraw) {
    let triangle = Triangle::new(corners.map(|position| Vertex { position, attributes: [] })).expect("in range");
    let window = pixels.window();
    let Ok(()) = triangle.spans(&mut SpanFn::new(window, |row, columns, _: Ramp<0>| pixels.add(row, columns)));
}

/// The outer border of the grid.
fn border(corners: &[Point2]) -> Vec<Point2> {
    let (wide, last) = (ACROSS + 1, (ACROSS + 1) * (DOWN + 1) - 1);
    let top = 0..wide;
    let right = (1..=DOWN).map(|row| row * wide + ACROSS);
    let bottom = (DOWN * wide..last).rev();
    let left = (1..DOWN).rev().map(|row| row * wide);
    top.chain(right).chain(bottom).chain(left).map(|index| corners[index]).collect()
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(10_000))]

    #[test]
    fn cells_share_no_pixel_and_leave_none(corners in corners(), cells in vec(cell(), ACROSS * DOWN)) {
        let mut pixels = Overdraw::new(WINDOW);
        let mut shared = vec![];
        for (index, cell) in cells.iter().enumerate() {
            let [a, b, c, d] = quad(&corners, index);
            match *cell {
                Cell::Whole(rule) => paint(&[[a, b, c, d]], rule, &mut pixels),
                // Where a quadrangle is not convex the diagonal may leave it: then both triangles are not its halves.
                Cell::Split { falling } if is_convex([a, b, c, d]) => {
                    let halves = if falling { [[a, b, c], [a, c, d]] } else { [[a, b, d], [b, c, d]] };
                    for half in halves {
                        paint_triangle(half, &mut pixels);
                    }
                }
                Cell::Split { .. } | Cell::Shared => shared.push([a, b, c, d]),
            }
        }
        paint(&shared, Rule::NonZero, &mut pixels);
        let border = [border(&corners)];
        for (x, y) in pixels.places() {
            let expected = u32::from(is_inside(&border, Rule::NonZero, (x, y)));
            prop_assert_eq!(pixels.count(x, y), expected, "{}, {}\n{}", x, y, pixels.picture());
        }
    }
}

fn is_convex(corners: [Point2; 4]) -> bool {
    let [a, b, c, d] = corners;
    [[a, b, c], [b, c, d], [c, d, a], [d, a, b]].iter().all(|[a, b, c]| aquatint::twice_area(*a, *b, *c) > 0)
}
