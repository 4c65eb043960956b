//! Rasterisation against slow, exact oracles, on random and hostile input.

mod exact;

use aquatint::{
    Line, Point2, Polygon, Rect, Rule, SpanFn, Triangle,
    raster::scan::ActiveEdge,
    vary::{Ramp, Vertex},
};
use embedded_graphics::geometry::Point;
use exact::{Overdraw, is_inside};
use heapless::Vec as List;
use proptest::{prelude::*, sample::select};

const WINDOW: Rect = Rect::new(-3, -2, 29, 24);

/// Coordinates of all kinds: on centres, on corners, anywhere, and at the ends of what is accepted.
fn sixteenths() -> impl Strategy<Value = i32> {
    const END: i32 = (1 << 26) - 1;
    prop_oneof![
        4 => -100..500_i32,
        2 => (-5..30_i32).prop_map(|pixel| pixel * 16 + 8),
        2 => (-5..30_i32).prop_map(|pixel| pixel * 16),
        1 => -20_000..20_000_i32,
        1 => select(vec![-END, END, 0, 8, -8]),
        1 => -END..=END,
    ]
}

fn vertices(count: core::ops::Range<usize>) -> impl Strategy<Value = Vec<Point2>> {
    prop::collection::vec((sixteenths(), sixteenths()).prop_map(|(x, y)| Point2::from_sixteenths(x, y)), count)
}

fn contours() -> impl Strategy<Value = Vec<Vec<Point2>>> {
    prop::collection::vec(vertices(0..12), 1..4)
}

/// The pixels of a polygon, with an active edge list of `N`.
fn fill<const N: usize>(contours: &[Vec<Point2>], rule: Rule, window: Rect) -> Overdraw {
    let borrowed: Vec<&[Point2]> = contours.iter().map(Vec::as_slice).collect();
    let polygon = Polygon::new(&borrowed).expect("in range");
    let (mut active, mut pixels) = (List::<ActiveEdge, N>::new(), Overdraw::new(window));
    let Ok(()) =
        polygon.spans(rule, &mut active, &mut SpanFn::new(window, |row, columns, ()| pixels.add(row, columns)));
    pixels
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(10_000))]

    #[test]
    fn a_polygon_holds_the_pixels_whose_centres_are_inside(contours in contours()) {
        for rule in [Rule::NonZero, Rule::EvenOdd] {
            let pixels = fill::<16>(&contours, rule, WINDOW);
            for (x, y) in pixels.places() {
                let expected = u32::from(is_inside(&contours, rule, (x, y)));
                prop_assert_eq!(pixels.count(x, y), expected, "{:?} at {}, {}", rule, x, y);
            }
        }
    }

    #[test]
    fn a_short_list_of_edges_changes_no_pixel(contours in contours()) {
        for rule in [Rule::NonZero, Rule::EvenOdd] {
            let plenty = fill::<64>(&contours, rule, WINDOW);
            prop_assert_eq!(&fill::<0>(&contours, rule, WINDOW), &plenty);
            prop_assert_eq!(&fill::<2>(&contours, rule, WINDOW), &plenty);
            prop_assert_eq!(&fill::<5>(&contours, rule, WINDOW), &plenty);
        }
    }

    #[test]
    fn a_band_holds_the_same_pixels_as_the_whole(contours in contours(), top in -2..15_i32, height in 0..9_i32) {
        let whole = fill::<16>(&contours, Rule::NonZero, WINDOW);
        let band = Rect { top, bottom: top + height, ..WINDOW };
        let part = fill::<16>(&contours, Rule::NonZero, band);
        for (x, y) in part.places() {
            prop_assert_eq!(part.count(x, y), whole.count(x, y));
        }
    }
}

#[test]
fn vertices_out_of_range_are_refused_before_anything_is_drawn() {
    for bad in [1 << 26, -(1 << 26), i32::MIN, i32::MAX] {
        let contour = [Point2::corner(0, 0), Point2::corner(5, 0), Point2::from_sixteenths(0, bad)];
        assert!(Polygon::new(&[&contour]).is_err());
    }
    assert!(Polygon::new(&[]).is_ok());
    assert!(Polygon::new(&[&[]]).is_ok());
}

#[test]
fn the_singularities_of_the_lecture() {
    // Vertices on the centre lines of rows (y = 8, 24, 40 … sixteenths), horizontal and coincident edges.
    let cases: [(&[(i32, i32)], &str); 4] = [
        // Centres on the left and top edges are inside, on the right edge and the lower tip outside.
        (&[(8, 8), (72, 8), (40, 40)], "####.\n.##..\n.....\n"),
        // A vertex on a centre line where the outline passes through it counts once.
        (&[(0, 0), (64, 24), (0, 64)], "#....\n####.\n##...\n#....\n"),
        // A horizontal edge on a centre line: the upper border is inside, the lower is not.
        (&[(0, 8), (48, 8), (48, 40), (0, 40)], "###..\n###..\n.....\n"),
        // An edge there and back again adds nothing.
        (&[(0, 0), (32, 0), (32, 48), (32, 0), (48, 0), (48, 48), (0, 48)], "###..\n###..\n###..\n"),
    ];
    for (corners, expected) in cases {
        let contour: Vec<_> = corners.iter().map(|&(x, y)| Point2::from_sixteenths(x, y)).collect();
        let height = expected.lines().count();
        let window = Rect::new(0, 0, 5, i32::try_from(height).expect("few rows"));
        assert_eq!(fill::<8>(&[contour], Rule::NonZero, window).picture(), expected, "{corners:?}");
    }
}

#[test]
fn the_fill_rules_differ_inside_a_pentagram() {
    let star = [(8, 0), (13, 15), (0, 6), (16, 6), (3, 15)].map(|(x, y)| Point2::corner(x, y)).to_vec();
    let window = Rect::new(0, 0, 16, 15);
    let non_zero = fill::<8>(std::slice::from_ref(&star), Rule::NonZero, window);
    let even_odd = fill::<8>(std::slice::from_ref(&star), Rule::EvenOdd, window);
    // Centres on a right edge are outside, so the picture is not quite symmetric.
    let expected = "\
................
.......#........
.......##.......
.......##.......
......###.......
......####......
.##############.
..############..
....########....
.....######.....
....#######.....
....########....
....###..###....
...##......#....
...#........#...
";
    assert_eq!(non_zero.picture(), expected);
    assert_eq!((non_zero.count(8, 8), even_odd.count(8, 8)), (1, 0), "the middle");
    assert_eq!((non_zero.count(8, 3), even_odd.count(8, 3)), (1, 1), "an arm");
}

/// The pixels of a triangle.
fn fill_triangle(corners: [Point2; 3], pixels: &mut Overdraw) {
    let triangle = Triangle::new(corners.map(|position| Vertex { position, attributes: [] })).expect("in range");
    let window = pixels.window();
    let Ok(()) = triangle.spans(&mut SpanFn::new(window, |row, columns, _: Ramp<0>| pixels.add(row, columns)));
}

fn triangle_corner() -> impl Strategy<Value = Point2> {
    const END: i32 = (1 << 20) - 1;
    let coordinate = || prop_oneof![4 => -100..500_i32, 2 => (-5..30_i32).prop_map(|p| p * 16 + 8), 1 => -END..=END];
    (coordinate(), coordinate()).prop_map(|(x, y)| Point2::from_sixteenths(x, y))
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(10_000))]

    #[test]
    fn a_triangle_is_the_polygon_of_its_corners(corners in [triangle_corner(), triangle_corner(), triangle_corner()]) {
        let expected = fill::<4>(&[corners.to_vec()], Rule::NonZero, WINDOW);
        let [a, b, c] = corners;
        for order in [[a, b, c], [b, c, a], [c, b, a], [a, c, b]] {
            let mut pixels = Overdraw::new(WINDOW);
            fill_triangle(order, &mut pixels);
            prop_assert_eq!(&pixels, &expected);
        }
    }

    #[test]
    fn attributes_are_the_plane_through_the_corners(
        corners in [triangle_corner(), triangle_corner(), triangle_corner()],
        values in [any::<u16>(), any::<u16>(), any::<u16>()],
    ) {
        let mut index = 0;
        let vertices = corners.map(|position| {
            index += 1;
            Vertex { position, attributes: [values[index - 1]] }
        });
        let triangle = Triangle::new(vertices).expect("in range");
        let mut worst = 0.0_f64;
        let sink = |row: i32, columns: core::ops::Range<i32>, ramp: Ramp<1>| {
            for (column, [got]) in columns.zip(ramp) {
                let exact = exact::interpolated(corners, values, (column, row));
                worst = worst.max((f64::from(got) - exact).abs());
            }
        };
        let Ok(()) = triangle.spans(&mut SpanFn::new(WINDOW, sink));
        // Half a unit of rounding, and 2^-17 for each of up to 65,536 pixels from the first corner.
        prop_assert!(worst <= 0.5 + 1.1, "off by {}", worst);
    }
}

#[test]
fn a_mesh_covers_each_pixel_once_along_either_diagonal() {
    let mut random = exact::Random(7);
    for _ in 0..200 {
        // A jittered grid of 5 × 5 corners that covers the window and more; cells stay convex, because
        // no corner moves by a quarter of the spacing.
        let corner = |i: i32, j: i32, random: &mut exact::Random| {
            let mut at = |k: i32| k * 128 - 64 + if (1..4).contains(&k) { random.below(60) - 30 } else { 0 };
            (at(i), at(j))
        };
        let grid: Vec<Vec<Point2>> = (0..5)
            .map(|j| (0..5).map(|i| corner(i, j, &mut random)).map(|(x, y)| Point2::from_sixteenths(x, y)).collect())
            .collect();
        let mut pixels = Overdraw::new(Rect::new(0, 0, 24, 24));
        for j in 0..4 {
            for i in 0..4 {
                let [a, b, c, d] = [grid[j][i], grid[j][i + 1], grid[j + 1][i + 1], grid[j + 1][i]];
                let halves = if random.below(2) == 0 { [[a, b, c], [a, c, d]] } else { [[a, b, d], [d, b, c]] };
                for half in halves {
                    fill_triangle(half, &mut pixels);
                }
            }
        }
        assert!(pixels.places().all(|(x, y)| pixels.count(x, y) == 1), "\n{}", pixels.picture());
    }
}

#[test]
fn triangles_out_of_range_are_refused() {
    for bad in [1 << 20, -(1 << 20), i32::MIN, i32::MAX] {
        let corner = |x, y| Vertex { position: Point2::from_sixteenths(x, y), attributes: [0_u16] };
        assert!(Triangle::new([corner(0, 0), corner(bad, 3), corner(4, 9)]).is_err());
    }
}

/// The pixels of a line in the order in which they come.
fn line_pixels(line: Line, window: Rect) -> Vec<(i32, i32)> {
    let mut pixels = vec![];
    let sink = |row, columns: core::ops::Range<i32>, ()| pixels.extend(columns.map(|column| (column, row)));
    let Ok(()) = line.spans(&mut SpanFn::new(window, sink));
    pixels
}

fn any_coordinate() -> impl Strategy<Value = i32> {
    prop_oneof![
        3 => -40..40_i32,
        1 => -3000..3000_i32,
        1 => any::<i32>(),
        1 => select(vec![i32::MIN, i32::MIN + 1, i32::MAX - 1, i32::MAX, 0]),
    ]
}

fn any_line() -> impl Strategy<Value = Line> {
    let point = || (any_coordinate(), any_coordinate()).prop_map(|(x, y)| Point::new(x, y));
    (point(), point()).prop_map(|(a, b)| Line::new(a, b))
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(10_000))]

    #[test]
    fn the_visible_pixels_of_a_line_are_those_of_the_whole_line(
        line in any_line(), left in any_coordinate(), top in any_coordinate(),
    ) {
        // Near the origin half of the time, so that most lines show.
        for (left, top) in [(left.min(i32::MAX - 20), top.min(i32::MAX - 15)), (left % 30, top % 30)] {
            let window = Rect::new(left, top, left + 20, top + 15);
            let mut pixels = line_pixels(line, window);
            pixels.sort_unstable();
            prop_assert_eq!(pixels, exact::line(line, window));
        }
    }

    #[test]
    fn a_line_is_the_same_from_both_ends(line in any_line()) {
        let window = Rect::new(-50, -50, 50, 50);
        prop_assert_eq!(line_pixels(line, window), line_pixels(Line::new(line.end, line.start), window));
    }
}

#[test]
fn every_direction_is_connected_and_symmetric() {
    let window = Rect::new(-50, -50, 50, 50);
    for (x, y) in (-40..=40).flat_map(|x| (-40..=40).map(move |y| (x, y))) {
        let there = line_pixels(Line::new(Point::zero(), Point::new(x, y)), window);
        assert_eq!(there, line_pixels(Line::new(Point::new(x, y), Point::zero()), window), "to {x}, {y}");
        assert_eq!(there.len(), usize::try_from(x.abs().max(y.abs())).expect("small") + 1);
        assert!(there.windows(2).all(|p| p[0].0.abs_diff(p[1].0) <= 1 && p[0].1.abs_diff(p[1].1) <= 1));
        assert!(there.contains(&(0, 0)) && there.contains(&(x, y)));
    }
}
