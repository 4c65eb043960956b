//! Lines with attributes, against what they are at each pixel.

mod exact;

use aquatint::{
    Point2, RampLine, Rect, SpanFn,
    vary::{Ramp, Vertex},
};
use embedded_graphics::geometry::Point;
use exact::line;
use proptest::{prelude::*, sample::select};

const LIMIT: i32 = (1 << 20) - 1;

/// A pixel with two attributes.
type Shaded = (i32, i32, [u16; 2]);

/// Near the window, or as far as a line may reach.
fn coordinate() -> impl Strategy<Value = i32> {
    prop_oneof![
        5 => -640..960_i32,
        2 => -70_000..70_000_i32,
        1 => -LIMIT..=LIMIT,
        1 => select(vec![-LIMIT, -LIMIT + 1, -1, 0, LIMIT - 1, LIMIT]),
    ]
}

fn vertex() -> impl Strategy<Value = Vertex<2>> {
    let attribute = prop_oneof![Just(0), Just(u16::MAX), any::<u16>()];
    let near = (-40..40_i32, -40..40_i32);
    let place = prop_oneof![4 => (coordinate(), coordinate()), 1 => near];
    (place, prop::array::uniform2(attribute))
        .prop_map(|((x, y), attributes)| Vertex { position: Point2::from_sixteenths(x, y), attributes })
}

fn window() -> impl Strategy<Value = Rect> {
    let place = || prop_oneof![6 => -30..30_i32, 1 => select(vec![i32::MIN, -65_540, 65_500, i32::MAX - 40])];
    (place(), place(), 0..40_i32, 0..40_i32).prop_map(|(x, y, width, height)| Rect::new(x, y, x + width, y + height))
}

/// The pixels of a line in a window, in the order of its driving axis.
fn drawn(ends: [Vertex<2>; 2], window: Rect) -> Vec<Shaded> {
    let mut pixels = vec![];
    let mut sink = SpanFn::new(window, |row: i32, columns: core::ops::Range<i32>, ramp: Ramp<2>| {
        assert!(!columns.is_empty() && window.clip_run(row, columns.clone()) == Some(columns.clone()));
        pixels.extend(columns.zip(ramp).map(|(column, attributes)| (column, row, attributes)));
    });
    let Ok(()) = RampLine::new(ends).expect("in range").spans(&mut sink);
    pixels
}

/// The same by the words of the module: where the exact line is at the middle of each step, or at the nearer end.
struct Slowly {
    is_steep: bool,
    /// Along and across, and attributes, of the end that comes first, and of the other.
    ends: [(i128, i128, [u16; 2]); 2],
}

impl Slowly {
    fn new(ends: [Vertex<2>; 2]) -> Self {
        let [(ax, ay), (bx, by)] =
            ends.map(|end| (i128::from(end.position.x.to_bits()), i128::from(end.position.y.to_bits())));
        let is_steep = (by - ay).abs() > (bx - ax).abs();
        let end = |x, y, attributes| if is_steep { (y, x, attributes) } else { (x, y, attributes) };
        let mut ends = [end(ax, ay, ends[0].attributes), end(bx, by, ends[1].attributes)];
        ends.sort_by_key(|&(along, _, attributes)| (along, attributes));
        Self { is_steep, ends }
    }

    /// The pixels, each with the way from the first end to the place that decides, and the whole way, in sixteenths.
    fn pixels(&self, window: Rect) -> Vec<(i32, i32, i128, i128)> {
        let [(start, from, _), (end, to, _)] = self.ends;
        let steps = if self.is_steep { window.rows() } else { window.columns() };
        let steps = steps.map(i128::from).filter(|step| (start >> 4..=end >> 4).contains(step));
        let pixels = steps.map(|step| {
            let (way, whole) = ((16 * step + 8).clamp(start, end) - start, (end - start).max(1));
            let across = (from * whole + (to - from) * way).div_euclid(16 * whole);
            let (x, y) = if self.is_steep { (across, step) } else { (step, across) };
            (i32::try_from(x).expect("near"), i32::try_from(y).expect("near"), way, whole)
        });
        pixels.filter(|&(x, y, ..)| window.contains(Point::new(x, y))).collect()
    }

    fn is_drawn(&self, pixels: &[Shaded], window: Rect) -> Result<(), TestCaseError> {
        let wanted = self.pixels(window);
        let places = |all: &[Shaded]| all.iter().map(|&(x, y, _)| (x, y)).collect::<Vec<_>>();
        prop_assert_eq!(places(pixels), wanted.iter().map(|&(x, y, ..)| (x, y)).collect::<Vec<_>>());
        let [(.., first), (.., last)] = self.ends;
        for (&(.., got), &(.., way, whole)) in pixels.iter().zip(&wanted) {
            for ((got, first), last) in got.into_iter().zip(first).zip(last) {
                let [got, first, last] = [got, first, last].map(i128::from);
                // Where both ends are at one place, one of them is drawn.
                if self.ends[0].0 == self.ends[1].0 {
                    prop_assert!(got == first || got == last);
                    continue;
                }
                // Half a unit, and 2⁻¹⁵ for each pixel from the first end, in parts of whole/2¹⁶.
                let error = ((got - first) * whole - (last - first) * way).abs() << 16;
                let bound = whole * ((1 << 15) + 2 * (way / 16 + 2));
                prop_assert!(error <= bound, "{} is off by {}", got, error / whole);
                prop_assert!((first.min(last)..=first.max(last)).contains(&got), "{} out of range", got);
            }
        }
        Ok(())
    }
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(20_000))]

    #[test]
    fn pixels_are_those_that_hold_the_line(a in vertex(), b in vertex(), window in window()) {
        let pixels = drawn([a, b], window);
        Slowly::new([a, b]).is_drawn(&pixels, window)?;
        prop_assert_eq!(&pixels, &drawn([b, a], window), "the same from both ends");
    }

    #[test]
    fn entered_anywhere_pixels_and_attributes_are_those_of_the_whole_line(
        a in vertex(), b in vertex(), whole in window(), part in window(),
    ) {
        let both = whole.intersection(part);
        let mut pixels = drawn([a, b], whole);
        pixels.retain(|&(x, y, _)| both.contains(Point::new(x, y)));
        prop_assert_eq!(pixels, drawn([a, b], both));
    }

    #[test]
    fn between_centres_of_pixels_it_is_bresenhams_line(
        ends in prop::array::uniform4(prop_oneof![3 => -40..70_i32, 1 => -60_000..60_000_i32]), window in window(),
    ) {
        let [ax, ay, bx, by] = ends;
        let at = |x: i32, y: i32| Vertex { position: Point2::from_sixteenths(16 * x + 8, 16 * y + 8), attributes: [7; 2] };
        let mut pixels: Vec<_> = drawn([at(ax, ay), at(bx, by)], window).iter().map(|&(x, y, _)| (x, y)).collect();
        pixels.sort_unstable();
        prop_assert_eq!(pixels, line(aquatint::Line::new(Point::new(ax, ay), Point::new(bx, by)), window));
    }

    #[test]
    fn pixels_follow_each_other(a in (-900..900_i32, -900..900_i32), b in (-900..900_i32, -900..900_i32)) {
        let [start, end] = [a, b].map(|(x, y)| Vertex { position: Point2::from_sixteenths(x, y), attributes: [0; 2] });
        let pixels = drawn([start, end], Rect::new(-100, -100, 100, 100));
        let step = |a: &Shaded, b: &Shaded| a.0.abs_diff(b.0).max(a.1.abs_diff(b.1));
        let are_neighbours = pixels.windows(2).all(|pair| step(&pair[0], &pair[1]) == 1);
        prop_assert!(are_neighbours);
        // Near to the pixels of both ends: in theirs or in one beside it.
        for (x, y) in [a, b] {
            let near = pixels.iter().any(|&(px, py, _)| (x >> 4).abs_diff(px) + (y >> 4).abs_diff(py) <= 1);
            prop_assert!(near, "none at {x}, {y}");
        }
    }

    #[test]
    fn what_is_out_of_range_is_refused(x in any::<i32>(), y in any::<i32>()) {
        let end = |x: i32, y: i32| Vertex { position: Point2::from_sixteenths(x, y), attributes: [] };
        let is_in_range = x.unsigned_abs() < 1 << 20 && y.unsigned_abs() < 1 << 20;
        prop_assert_eq!(RampLine::new([end(0, 0), end(x, y)]).is_ok(), is_in_range);
        prop_assert_eq!(RampLine::new([end(y, x), end(0, 0)]).is_ok(), is_in_range);
    }
}

#[test]
fn a_line_without_length_is_a_pixel() {
    for (x, y) in (0..32).flat_map(|x| (0..32).map(move |y| (x, y))) {
        let end = |light| Vertex { position: Point2::from_sixteenths(x, y), attributes: [light, 0] };
        let pixels = drawn([end(9), end(3)], Rect::new(-5, -5, 5, 5));
        assert_eq!(pixels.len(), 1);
        assert_eq!((pixels[0].0, pixels[0].1), (x >> 4, y >> 4));
        assert_eq!(pixels, drawn([end(3), end(9)], Rect::new(-5, -5, 5, 5)));
    }
}

#[test]
fn a_wireframe() {
    let window = Rect::new(0, 0, 24, 9);
    let mut picture = [['.'; 24]; 9];
    let end = |x, y, light| Vertex { position: Point2::from_sixteenths(x, y), attributes: [light, 0] };
    let corners = [end(30, 130, 0), end(370, 100, 9), end(190, 8, 5)];
    for (a, b) in [(0, 1), (1, 2), (2, 0)] {
        for (x, y, [light, _]) in drawn([corners[a], corners[b]], window) {
            picture[usize::try_from(y).unwrap()][usize::try_from(x).unwrap()] =
                char::from(b'0' + u8::try_from(light).unwrap());
        }
    }
    let picture: String = picture.map(|row| row.iter().collect::<String>() + "|\n").concat();
    assert_eq!(
        picture,
        "\
...........55...........|
..........4..66.........|
.........4.....67.......|
.......33........77.....|
......2............88...|
.....2...............89.|
...11..........667778899|
..0112223344455.........|
.00.....................|
"
    );
}
