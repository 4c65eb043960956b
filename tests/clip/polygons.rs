//! Sutherland-Hodgman: winding, both fill rules, number of vertices, any order, any input.

use aquatint::{
    FillStyle, Point2, Polygon, Rect, Rule,
    clip::{
        convex::ConvexWindow,
        sutherland_hodgman::{Pipeline, Stage, clip, clip_to_rectangle},
        window::{Boundary, ClipWindow, HalfPlane},
    },
    vary::Vertex,
};
use core::convert::Infallible;
use embedded_graphics::{
    Pixel,
    draw_target::DrawTarget,
    geometry::{Dimensions, Point},
    pixelcolor::BinaryColor,
    prelude::{Drawable, Primitive},
    primitives::Rectangle,
};
use heapless::Vec as List;
use proptest::prelude::*;

use super::{corners, exact::Overdraw, oracle, places};

/// As `k` boundaries and `n` vertices make at most; twelve vertices and six boundaries here.
type Clipped = List<Point2, { 12 + 6 * 6 }>;

pub fn point((x, y): (i32, i32)) -> Point2 {
    Point2::from_sixteenths(x, y)
}

fn pipelined(polygon: &[Point2], half_planes: &[HalfPlane]) -> Clipped {
    let (mut stages, mut clipped) = (List::<_, 8>::new(), Clipped::new());
    let mut pipeline = Pipeline::build(half_planes.iter().copied(), &mut stages).expect("eight are enough");
    pipeline.clip(polygon, |vertex| clipped.push(vertex)).expect("the bound");
    clipped
}

/// The same by one list after the other.
fn listed(polygon: &[Point2], half_planes: &[HalfPlane]) -> Clipped {
    let (mut clipped, mut next) = (Clipped::new(), Clipped::new());
    clipped.extend_from_slice(polygon).expect("short");
    for side in half_planes {
        clip(&clipped, |vertex| Boundary::distance(side, vertex), &mut next).expect("the bound");
        core::mem::swap(&mut clipped, &mut next);
    }
    clipped
}

/// The vertices, beginning with the least, so that lists that differ in where they begin are equal.
fn rotated(polygon: &[Point2]) -> Vec<(i32, i32)> {
    let places: Vec<_> = polygon.iter().copied().map(oracle::place).collect();
    let rotations = (0..places.len().max(1)).map(|by| {
        let (end, start) = places.split_at(by);
        [start, end].concat()
    });
    rotations.min().expect("one at least")
}

/// A place in cells of 15 pixels. With at most four of them between two corners, an edge crosses every third line
/// of pixels at whole sixteenths.
pub fn cells() -> impl Strategy<Value = Point2> {
    (-2..=2_i32, -2..=2_i32).prop_map(|(x, y)| Point2::corner(x * 15, y * 15))
}

/// A window of whole pixels whose crossings with edges between [`cells`] need no rounding.
pub fn exact_windows() -> impl Strategy<Value = Rect> {
    let range = || (-12..12_i32, 1..14_i32);
    (range(), range()).prop_map(|((x, w), (y, h))| Rect::new(x * 3, y * 3, (x + w) * 3, (y + h) * 3))
}

/// Convex windows of three to six corners: points on a circle, in order, either way round.
pub fn convex_windows() -> impl Strategy<Value = Vec<Point2>> {
    const CIRCLE: [(i32, i32); 12] = [
        (100, 0),
        (87, 50),
        (50, 87),
        (0, 100),
        (-50, 87),
        (-87, 50),
        (-100, 0),
        (-87, -50),
        (-50, -87),
        (0, -100),
        (50, -87),
        (87, -50),
    ];
    let chosen = prop::sample::subsequence(CIRCLE.to_vec(), 3..7);
    (chosen, 1..30_i32, -300..300_i32, -300..300_i32, any::<bool>()).prop_map(|(mut corners, scale, x, y, turn)| {
        if turn {
            corners.reverse();
        }
        corners.iter().map(|corner| point((x + corner.0 * scale / 10, y + corner.1 * scale / 10))).collect()
    })
}

/// Counts how often each pixel is drawn.
struct Canvas(Overdraw);

impl Dimensions for Canvas {
    fn bounding_box(&self) -> Rectangle {
        self.0.window().into()
    }
}

impl DrawTarget for Canvas {
    type Color = BinaryColor;
    type Error = Infallible;

    fn draw_iter<I: IntoIterator<Item = Pixel<BinaryColor>>>(&mut self, pixels: I) -> Result<(), Infallible> {
        pixels.into_iter().for_each(|Pixel(at, _)| self.0.add(at.y, at.x..at.x + 1));
        Ok(())
    }
}

/// The pixels of contours that lie in a window.
pub fn fill(contours: &[&[Point2]], rule: Rule, window: Rect) -> Overdraw {
    let mut canvas = Canvas(Overdraw::new(window));
    let polygon = Polygon::new(contours).expect("in range");
    let Ok(()) = polygon.into_styled(FillStyle::new(BinaryColor::On).with_rule(rule)).draw(&mut canvas);
    canvas.0
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(10_000))]

    #[test]
    fn both_rules_fill_a_clipped_polygon_as_the_whole_one(
        subject in prop::collection::vec(cells(), 0..10), window in exact_windows(),
    ) {
        let mut clipped = List::<Point2, 27>::new();
        clip_to_rectangle(&subject, window, &mut clipped).expect("the bound");
        for rule in [Rule::NonZero, Rule::EvenOdd] {
            prop_assert_eq!(fill(&[&clipped], rule, window), fill(&[&subject], rule, window));
        }
        let around = Rect::new(window.left - 3, window.top - 3, window.right + 3, window.bottom + 3);
        let outside = fill(&[&clipped], Rule::NonZero, around);
        for (x, y) in outside.places().filter(|&(x, y)| !window.contains(Point::new(x, y))) {
            prop_assert_eq!(outside.count(x, y), 0, "{}, {} is outside of the window", x, y);
        }
    }

    #[test]
    fn the_winding_is_exact_where_nothing_was_rounded(
        subject in prop::collection::vec(cells(), 3..10), window in exact_windows(),
        samples in prop::collection::vec((0..1000_i32, 0..1000_i32), 40),
    ) {
        let clipped = pipelined(&subject, &ClipWindow::<Point2>::from(window).half_planes());
        for (u, v) in samples {
            // On edges and vertices as well; the far borders see what lies beyond them.
            let inside = |from: i32, to: i32, t: i32| from * 16 + (to - from) * 16 * t / 1000;
            let place = (inside(window.left, window.right, u), inside(window.top, window.bottom, v));
            prop_assert_eq!(oracle::winding(&clipped, place), oracle::winding(&subject, place), "at {:?}", place);
        }
    }

    #[test]
    fn rounding_moves_an_edge_by_half_a_unit_a_boundary(
        subject in corners(-700..700, 3..12), window in convex_windows(), is_rectangle: bool,
        samples in prop::collection::vec((-600..600_i32, -600..600_i32), 60),
    ) {
        let bounds = ClipWindow::new(point((-300, -201)), point((255, 160)));
        let convex = ConvexWindow::new(&window);
        prop_assume!(convex.is_ok());
        let half_planes: Vec<_> =
            if is_rectangle { bounds.half_planes().to_vec() } else { convex.unwrap().half_planes().collect() };
        let clipped = pipelined(&subject, &half_planes);
        let reach = i32::try_from(half_planes.len().div_ceil(2)).expect("few");
        let border = |place| !is_rectangle && oracle::edges(&window).any(|edge| oracle::is_near(place, edge, reach));
        for place in samples {
            let is_inside = half_planes.iter().all(|side| Boundary::distance(side, &point(place)) > 0);
            let is_near = oracle::edges(&subject).any(|edge| oracle::is_near(place, edge, reach));
            if is_inside && !is_near && !border(place) {
                prop_assert_eq!(oracle::winding(&clipped, place), oracle::winding(&subject, place), "at {:?}", place);
            }
        }
    }

    #[test]
    fn stages_give_what_lists_give(
        subject in prop_oneof![corners(-40..40, 0..12), corners(-4..4, 0..12), corners(-3000..3000, 0..12)],
        window in convex_windows(), is_small: bool,
    ) {
        let bounds = ClipWindow::new(point((-2, -3)), point((if is_small { 1 } else { 900 }, 20)));
        let convex = ConvexWindow::new(&window);
        prop_assume!(convex.is_ok());
        for half_planes in [bounds.half_planes().to_vec(), convex.unwrap().half_planes().collect()] {
            let clipped = pipelined(&subject, &half_planes);
            prop_assert_eq!(rotated(&clipped), rotated(&listed(&subject, &half_planes)));
            prop_assert!(clipped.len() <= subject.len() + half_planes.len() * (subject.len() / 2), "the bound");
        }
    }

    #[test]
    fn a_convex_polygon_gains_a_vertex_a_boundary(subject in convex_windows(), window in convex_windows()) {
        let (subject_is_convex, window) = (ConvexWindow::new(&subject).is_ok(), ConvexWindow::new(&window));
        prop_assume!(subject_is_convex && window.is_ok());
        let half_planes: Vec<_> = window.unwrap().half_planes().collect();
        prop_assert!(pipelined(&subject, &half_planes).len() <= subject.len() + half_planes.len());
    }

    #[test]
    fn the_result_does_not_depend_on_where_or_which_way_round_one_begins(
        mut subject in corners(-900..900, 3..12), by in 0..12_usize, window in convex_windows(),
    ) {
        let window = ConvexWindow::new(&window);
        prop_assume!(window.is_ok());
        let half_planes: Vec<_> = window.unwrap().half_planes().collect();
        let clipped = pipelined(&subject, &half_planes);
        let by = by % subject.len();
        subject.rotate_left(by);
        prop_assert_eq!(rotated(&clipped), rotated(&pipelined(&subject, &half_planes)));
        subject.reverse();
        let mut turned = pipelined(&subject, &half_planes);
        turned.reverse();
        prop_assert_eq!(rotated(&clipped), rotated(&turned));
    }

    #[test]
    fn hostile_polygons_and_windows_are_harmless(
        subject in prop::collection::vec(places(), 0..12), min in places(), max in places(),
        window in prop::collection::vec(places(), 0..6), room in 0..4_usize,
    ) {
        let subject: Vec<_> = subject.into_iter().map(point).collect();
        let bounds = ClipWindow::new(point(min), point(max));
        let mut clipped = Clipped::new();
        clip_to_rectangle(&subject, bounds, &mut clipped).expect("the bound holds for rectangles");
        for vertex in &clipped {
            prop_assert!(bounds.outcode(*vertex).is_inside(), "{:?} is outside", vertex);
        }
        let mut short = List::<Point2, 2>::new();
        let fits = clip_to_rectangle(&subject, bounds, &mut short).is_ok();
        prop_assert_eq!(fits, clipped.len() <= 2);

        let window: Vec<_> = window.into_iter().map(point).collect();
        if let Ok(window) = ConvexWindow::new(&window) {
            let (mut stages, mut left) = (List::<Stage<Point2>, 8>::new(), room);
            let mut pipeline = Pipeline::build(window.half_planes(), &mut stages).expect("eight are enough");
            let _ = pipeline.clip(&subject, |_| left.checked_sub(1).map(|less| left = less).ok_or(()));
        }
    }

    #[test]
    fn attributes_are_cut_where_their_edge_is(
        a in (-500..500_i32, -500..500_i32), b in (-500..500_i32, -500..500_i32), light in any::<[u16; 2]>(),
    ) {
        let vertex = |place, light| Vertex { position: point(place), attributes: [light] };
        let bounds = ClipWindow::new(point((-100, -90)), point((110, 95)));
        let mut clipped = List::<Vertex<1>, 10>::new();
        clip_to_rectangle(&[vertex(a, light[0]), vertex(b, light[1])], bounds, &mut clipped).expect("the bound");
        let mut places = List::<Point2, 10>::new();
        clip_to_rectangle(&[point(a), point(b)], bounds, &mut places).expect("the bound");
        let positions: Vec<_> = clipped.iter().map(|vertex| vertex.position).collect();
        prop_assert_eq!(&positions[..], &places[..]);
        let range = light[0].min(light[1])..=light[0].max(light[1]);
        prop_assert!(clipped.iter().all(|vertex| range.contains(&vertex.attributes[0])));
    }
}

#[test]
fn many_stages_need_no_deep_stack() {
    let side = HalfPlane::new(Point2::corner(0, 0), Point2::corner(1, 0)).expect("in range");
    let clip = move || {
        let (mut stages, mut visible) = (vec![Stage::new(side); 10_000], vec![]);
        let triangle = [(-3, 3), (0, -3), (3, 3)].map(|(x, y)| Point2::corner(x, y));
        let mut emit = |vertex| {
            visible.push(vertex);
            Ok::<(), ()>(())
        };
        Pipeline::new(&mut stages).clip(&triangle, &mut emit).expect("never refused");
        visible.len()
    };
    let thread = std::thread::Builder::new().stack_size(64 << 10).spawn(clip).expect("a thread");
    assert_eq!(thread.join().expect("it ends"), 4);
}

#[test]
fn a_window_of_too_many_edges_is_refused() {
    let window = ClipWindow::<Point2>::from(Rect::new(0, 0, 9, 9));
    let mut stages = List::<Stage<Point2>, 3>::new();
    assert!(Pipeline::build(window.half_planes(), &mut stages).is_err());
}
