//! Separate polygons: no edges there and back for simple subjects, the same area for all.

use aquatint::{
    Point2, Rect, Rule,
    clip::{
        convex::ConvexWindow,
        separate::{Node, separate},
        sutherland_hodgman::Full,
        window::{Boundary, ClipWindow, HalfPlane},
    },
};
use heapless::Vec as List;
use proptest::prelude::*;

use super::{
    corners, oracle, places,
    polygons::{cells, convex_windows, exact_windows, fill, point},
};

type Polygons = Vec<Vec<Point2>>;

pub fn pieces(contours: &[&[Point2]], half_planes: &[HalfPlane]) -> Polygons {
    let (mut memory, mut corners, mut found) = (List::<Node, 200>::new(), List::<Point2, 200>::new(), vec![]);
    let mut pieces = separate(contours, half_planes.iter().copied(), &mut memory).expect("the bound");
    while pieces.next_into(&mut corners).expect("as long as the memory") {
        found.push(corners.to_vec());
    }
    assert_eq!((pieces.next_into(&mut corners), corners.len()), (Ok(false), 0), "and no more");
    found
}

/// Whether no edge touches another but its neighbours, and those only in their common corner.
fn is_simple(polygon: &[Point2]) -> bool {
    let edges: Vec<_> = oracle::edges(polygon).collect();
    let count = edges.len();
    let pairs = (0..count).flat_map(|i| (i + 1..count).map(move |j| (i, j)));
    let goes_on = |(a, b): (usize, usize)| oracle::cross(edges[a], edges[b]) != 0;
    count >= 3
        && pairs.into_iter().all(|(i, j)| match (j - i, i + count - j) {
            (1, _) => goes_on((i, j)),
            (_, 1) => goes_on((j, i)),
            _ => !oracle::touch(edges[i], edges[j]),
        })
}

/// Simple polygons through random places: of edges that touch, two are exchanged again and again; corners that are
/// still in the way are left out.
fn simple(place: impl Strategy<Value = Point2>) -> impl Strategy<Value = Vec<Point2>> {
    prop::collection::vec(place, 3..12).prop_filter_map("all in line", |mut polygon| {
        while polygon.len() >= 3 {
            untangle(&mut polygon);
            if is_simple(&polygon) {
                return Some(polygon);
            }
            let shorter = (0..polygon.len()).map(|without| {
                let mut shorter = polygon.clone();
                shorter.remove(without);
                shorter
            });
            polygon = shorter.clone().find(|shorter| is_simple(shorter)).or_else(|| shorter.clone().next())?;
        }
        None
    })
}

fn untangle(polygon: &mut [Point2]) {
    let count = polygon.len();
    for _ in 0..60 {
        let edges: Vec<_> = oracle::edges(polygon).collect();
        let mut pairs = (0..count).flat_map(|i| (i + 2..count).map(move |j| (i, j)));
        let touching = pairs.find(|&(i, j)| i + count - j > 1 && oracle::touch(edges[i], edges[j]));
        let Some((i, j)) = touching else { return };
        polygon[i + 1..=j].reverse();
    }
}

/// Whether two edges run along each other in opposite directions.
fn are_there_and_back(one: (oracle::Place, oracle::Place), other: (oracle::Place, oracle::Place)) -> bool {
    let along = |p: oracle::Place| {
        let [x, y] = [i128::from(one.1.0) - i128::from(one.0.0), i128::from(one.1.1) - i128::from(one.0.1)];
        x * i128::from(p.0) + y * i128::from(p.1)
    };
    let in_line = oracle::cross(one, (one.0, other.0)) == 0 && oracle::cross(one, (one.0, other.1)) == 0;
    in_line && along(other.0) > along(other.1) && along(one.0).max(along(other.1)) < along(one.1).min(along(other.0))
}

/// No edge of the pieces is a bridge.
fn has_no_bridge(pieces: &Polygons) -> bool {
    let edges: Vec<_> = pieces.iter().flat_map(|piece| oracle::edges(piece)).collect();
    edges.iter().all(|&one| edges.iter().all(|&other| !are_there_and_back(one, other)))
}

fn winding(contours: &Polygons, place: oracle::Place) -> i32 {
    contours.iter().map(|contour| oracle::winding(contour, place)).sum()
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(10_000))]

    #[test]
    fn the_pieces_of_a_simple_polygon_have_its_area_and_no_bridges(
        subject in simple(cells()), window in exact_windows(),
        samples in prop::collection::vec((0..1000_i32, 0..1000_i32), 40),
    ) {
        let pieces = pieces(&[&subject], &ClipWindow::<Point2>::from(window).half_planes());
        prop_assert!(has_no_bridge(&pieces), "{:?}", pieces);
        for (u, v) in samples {
            let inside = |from: i32, to: i32, t: i32| from * 16 + (to - from) * 16 * t / 1000;
            let place = (inside(window.left, window.right, u), inside(window.top, window.bottom, v));
            prop_assert_eq!(winding(&pieces, place), oracle::winding(&subject, place), "at {:?}", place);
            let holding = pieces.iter().filter(|piece| oracle::winding(piece, place) != 0).count();
            prop_assert!(holding <= 1, "pieces do not overlap");
        }
        let orientation = oracle::twice_area(&subject).signum();
        prop_assert!(pieces.iter().all(|piece| oracle::twice_area(piece).signum() == orientation));
    }

    #[test]
    fn the_pieces_of_any_contours_are_filled_as_they_are(
        one in prop::collection::vec(cells(), 0..8), other in prop::collection::vec(cells(), 0..6), window in exact_windows(),
    ) {
        let pieces = pieces(&[&one, &other], &ClipWindow::<Point2>::from(window).half_planes());
        let borrowed: Vec<&[Point2]> = pieces.iter().map(Vec::as_slice).collect();
        for rule in [Rule::NonZero, Rule::EvenOdd] {
            prop_assert_eq!(fill(&borrowed, rule, window), fill(&[&one, &other], rule, window));
        }
    }

    #[test]
    fn convex_windows_keep_the_winding_up_to_rounding(
        subject in simple((-700..700_i32, -700..700_i32).prop_map(point)), window in convex_windows(),
        samples in prop::collection::vec((-600..600_i32, -600..600_i32), 60),
    ) {
        let convex = ConvexWindow::new(&window);
        prop_assume!(convex.is_ok());
        let half_planes: Vec<_> = convex.unwrap().half_planes().collect();
        let pieces = pieces(&[&subject], &half_planes);
        let reach = i32::try_from(half_planes.len().div_ceil(2)).expect("few");
        for place in samples {
            let is_inside = half_planes.iter().all(|side| Boundary::distance(side, &point(place)) > 0);
            let near = oracle::edges(&subject).chain(oracle::edges(&window)).any(|edge| oracle::is_near(place, edge, reach));
            if is_inside && !near {
                prop_assert_eq!(winding(&pieces, place), oracle::winding(&subject, place), "at {:?}", place);
                let holding = pieces.iter().filter(|piece| oracle::winding(piece, place) != 0).count();
                prop_assert!(holding <= 1, "pieces do not overlap");
            }
        }
    }

    #[test]
    fn the_pieces_need_no_more_memory_than_is_said(
        subject in prop_oneof![corners(-40..40, 3..12), corners(-4..4, 3..12)], window in convex_windows(),
    ) {
        let window = ConvexWindow::new(&window);
        prop_assume!(window.is_ok());
        let window = window.unwrap();
        let mut memory = List::<Node, 100>::new();
        let ends = separate(&[&subject], window.half_planes(), &mut memory).map(drop);
        prop_assert_eq!(ends, Ok(()));
        prop_assert!(memory.len() <= subject.len() + 2 * window.half_planes().count() * (subject.len() / 2));
    }

    #[test]
    fn hostile_contours_windows_and_memory_are_harmless(
        contours in prop::collection::vec(prop::collection::vec(places(), 0..8), 0..3), min in places(), max in places(),
    ) {
        let contours: Polygons = contours.iter().map(|contour| contour.iter().copied().map(point).collect()).collect();
        let borrowed: Vec<&[Point2]> = contours.iter().map(Vec::as_slice).collect();
        let bounds = ClipWindow::new(point(min), point(max));
        let whole = pieces(&borrowed, &bounds.half_planes());
        for piece in &whole {
            prop_assert!(piece.len() >= 3 && piece.iter().all(|&corner| bounds.outcode(corner).is_inside()));
        }
        let mut memory = List::<Node, 9>::new();
        if let Ok(mut pieces) = separate(&borrowed, bounds.half_planes(), &mut memory) {
            // With a list that is too short, and then with one that is not.
            let (mut short, mut corners) = (List::<Point2, 3>::new(), List::<Point2, 9>::new());
            for piece in &whole {
                if pieces.next_into(&mut short).is_ok() {
                    prop_assert_eq!(&piece[..], &short[..]);
                } else {
                    prop_assert!(piece.len() > 3);
                    prop_assert_eq!(pieces.next_into(&mut corners), Ok(true));
                    prop_assert_eq!(&piece[..], &corners[..]);
                }
            }
        }
    }
}

#[test]
fn a_hole_that_is_cut_becomes_a_part_of_the_outline() {
    let outside = [(0, 0), (9, 0), (9, 9), (0, 9)].map(|(x, y)| Point2::corner(x, y));
    let hole = [(3, 3), (3, 6), (6, 6), (6, 3)].map(|(x, y)| Point2::corner(x, y));
    let window = |rect: Rect| ClipWindow::<Point2>::from(rect).half_planes();
    let whole = pieces(&[&outside, &hole], &window(Rect::new(0, 0, 9, 9)));
    assert!(whole.len() == 2 && whole.contains(&outside.to_vec()) && whole.contains(&hole.to_vec()));
    let half = pieces(&[&outside, &hole], &window(Rect::new(0, 0, 4, 9)));
    assert_eq!(half.len(), 1, "a C");
    assert_eq!(oracle::twice_area(&half[0]), 2 * (4 * 9 - 3) * 256);
    let bar = pieces(&[&outside, &hole], &window(Rect::new(0, 4, 9, 5)));
    assert_eq!(bar.len(), 2, "both sides of the hole");
    assert_eq!(pieces(&[&outside, &hole], &window(Rect::new(4, 4, 5, 5))), Polygons::new(), "within the hole");
}

#[test]
fn more_nodes_than_can_be_numbered_are_refused() {
    let contour = vec![Point2::corner(1, 1); 70_000];
    let mut memory = Box::new(List::<Node, 80_000>::new());
    let no_boundaries: [HalfPlane; 0] = [];
    assert_eq!(separate(&[&contour], no_boundaries, &mut *memory).map(drop), Err(Full));
    // At the very end of the numbers, with room for both cuts and without.
    let below = HalfPlane::new(Point2::corner(0, 0), Point2::corner(1, 0)).expect("in range");
    for (length, expected) in [(65_533, Ok(true)), (65_534, Err(Full)), (65_535, Err(Full))] {
        let mut contour = vec![Point2::corner(1, 1); length];
        (contour[7], contour[9]) = (Point2::corner(1, -1), Point2::corner(5, 5));
        let mut corners = List::<Point2, 8>::new();
        let all = separate(&[&contour], no_boundaries, &mut *memory).map(drop);
        assert_eq!(all, Ok(()));
        let first = separate(&[&contour], [below], &mut *memory).and_then(|mut pieces| {
            let found = pieces.next_into(&mut corners);
            assert_eq!(pieces.next_into(&mut corners), Ok(false));
            found
        });
        assert_eq!(first, expected, "{length}");
    }
}
