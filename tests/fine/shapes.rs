//! Curves, arcs and what is made of them, against their formulas.

use std::f64::consts::TAU;

use aquatint::{
    Affine, Angle, Arc, Chord, Outline, Oval, Path, Placed, Point2, RoundedRectangle, Scalar, Sector, Segment, Subpixel,
};
use proptest::{array::uniform4, prelude::*};

use super::{Place, apart, coarse, fine, from_contour, from_edge, large, place, point};

/// A vertex is rounded once; sines are hardly off.
const VERTEX: f64 = 0.76;
/// With a quarter between curve and chord. The unit is a 256th of a pixel.
const EDGE: f64 = 0.96;
/// The coarse contour is as far off, in sixteenths.
const COARSE: f64 = 16.0 * EDGE + EDGE + 0.01;

/// Vertices at equal steps of the parameter, and edges between them that are nowhere farther off than said.
fn assert_follows(vertices: &[(i32, i32)], curve: impl Fn(f64) -> Place, slack: f64) {
    let steps = f64::from(u32::try_from(vertices.len() - 1).expect("few"));
    for (step, pair) in (0_u32..).zip(vertices.windows(2)) {
        let [a, b] = [pair[0], pair[1]].map(place);
        for (at, vertex) in [(f64::from(step), a), (f64::from(step) + 1.0, b)] {
            let off = apart(vertex, curve(at / steps));
            assert!(off <= VERTEX + slack, "{vertex:?} at {at} of {steps} is {off} off");
        }
        for part in [0.25, 0.5, 0.75] {
            let off = from_edge(curve((f64::from(step) + part) / steps), [a, b]);
            assert!(off <= EDGE + slack, "between {a:?} and {b:?}: {off} off");
        }
    }
}

fn assert_near_the_coarse_one(outline: &impl Outline) {
    let (fine, coarse) = (fine(outline), coarse(outline));
    assert_eq!((fine.contours.len(), fine.closed), (coarse.contours.len(), coarse.closed));
    for (fine, coarse) in fine.contours.iter().zip(coarse.contours) {
        let coarse: Vec<_> = coarse.iter().map(|&(x, y)| (16 * x, 16 * y)).collect();
        // Some eighty of them.
        for &vertex in fine.iter().step_by(fine.len() / 80 + 1) {
            let off = from_contour(place(vertex), &coarse);
            assert!(off <= COARSE, "{vertex:?} is {off} from the coarse contour");
        }
    }
}

/// A Bezier curve of any degree.
fn bezier(points: &[Point2], t: f64) -> Place {
    let mut points: Vec<_> = points.iter().map(|&point| large(point)).collect();
    while points.len() > 1 {
        points = points.windows(2).map(|p| [0, 1].map(|axis| p[0][axis] + t * (p[1][axis] - p[0][axis]))).collect();
    }
    points[0]
}

fn ellipse(center: Point2, radii: [i32; 2], turns: f64) -> Place {
    let ([x, y], [rx, ry]) = (large(center), radii.map(|radius| 16.0 * f64::from(radius)));
    [x + rx * (turns * TAU).cos(), y + ry * (turns * TAU).sin()]
}

fn oval(center: Point2, radii: [i32; 2]) -> Oval {
    Oval::new(center, radii.map(Subpixel::from_bits)).expect("in range")
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(500))]

    #[test]
    fn curves_are_right_to_a_256th(points in uniform4(prop_oneof![point(400), point(20_000)])) {
        let [a, b, c, d] = points;
        for (segment, points) in [(Segment::QuadTo(b, c), &points[..3]), (Segment::CubicTo(b, c, d), &points[..])] {
            let segments = [Segment::MoveTo(a), segment, Segment::Close];
            let path = Path::new(&segments).expect("in range");
            let traced = fine(&path);
            prop_assert_eq!((traced.contours.len(), traced.closed), (1, 1));
            assert_follows(&traced.contours[0], |t| bezier(points, t), 0.0);
            assert_near_the_coarse_one(&path);
        }
    }

    #[test]
    fn ovals_and_their_arcs_are_right_to_a_256th(
        center in point(9000), radii in (0..2500_i32, 0..2500_i32), start: u16, sweep in -65_536..=65_536_i32,
    ) {
        let radii = [radii.0, radii.1];
        let whole = oval(center, radii);
        let mut around = fine(&whole).contours.remove(0);
        around.push(around[0]);
        assert_follows(&around, |t| ellipse(center, radii, t), 0.0);
        assert_near_the_coarse_one(&whole);

        let arc = whole.arc(Angle(start), sweep);
        let turns = |t: f64| (f64::from(start) + t * f64::from(sweep)) / 65_536.0;
        let of_arc = fine(&arc);
        assert_follows(&of_arc.contours[0], |t| ellipse(center, radii, turns(t)), 0.0);
        // What is made of it has the same vertices.
        let (chord, sector) = (fine(&Chord(arc)), fine(&Sector(arc)));
        prop_assert_eq!((&chord.contours, chord.closed), (&of_arc.contours, 1));
        prop_assert_eq!((&sector.contours[0][1..], sector.closed), (&of_arc.contours[0][..], 1));
        prop_assert!(apart(place(sector.contours[0][0]), large(center)) == 0.0);
        // In a path that begins with it, too.
        let segments = [Segment::Arc(arc)];
        let path = fine(&Path::new(&segments).expect("in range"));
        let mut once = of_arc.contours[0].clone();
        once.dedup();
        let drawn = path.contours.first().map_or(&once[..1], |contour| &contour[..]);
        prop_assert_eq!(drawn, &once[..]);
        assert_near_the_coarse_one(&arc);
        assert_near_the_coarse_one(&Chord(arc));
        assert_near_the_coarse_one(&Sector(arc));
    }

    #[test]
    fn rounded_rectangles_are_right_to_a_256th(one in point(4000), other in point(4000), radii in uniform4(0..3000_i32)) {
        let shape = RoundedRectangle::new([one, other], Subpixel::ZERO).expect("in range");
        let shape = shape.with_radii(radii.map(Subpixel::from_bits));
        let ([a, b], radii) = ([one, other].map(large), shape.radii().map(|radius| 16.0 * f64::from(radius.to_bits())));
        let corners = [[a[0].min(b[0]), a[1].min(b[1])], [a[0].max(b[0]), a[1].max(b[1])]];
        for &vertex in &fine(&shape).contours[0] {
            let off = from_rounded(place(vertex), corners, radii);
            prop_assert!(off <= VERTEX, "{:?} is {} off", vertex, off);
        }
        assert_near_the_coarse_one(&shape);
    }

    #[test]
    fn what_is_placed_is_as_near_as_its_scale_allows(
        points in uniform4(point(3000)), elements in uniform4(-300_000..300_000_i32), to in point(9000),
    ) {
        let [a, b, c, d] = elements.map(Scalar::from_bits);
        let segments = [Segment::MoveTo(points[0]), Segment::CubicTo(points[1], points[2], points[3])];
        let placed = Placed::new(Path::new(&segments).expect("in range"), Affine::new([a, b], [c, d], to));
        let [a, b, c, d] = elements.map(|element| f64::from(element) / 65_536.0);
        let curve = |t| {
            let ([x, y], [left, top]) = (bezier(&points, t), large(to));
            [a * x + b * y + left, c * x + d * y + top]
        };
        // A unit before is at most so much behind, and there it is rounded again.
        let stretched = a.hypot(c).hypot(b.hypot(d));
        if let Some(contour) = fine(&placed).contours.first() {
            assert_follows(contour, curve, stretched);
        }
    }
}

/// How far a point is from the border of a rectangle, with radii in the order of CSS.
fn from_rounded([x, y]: Place, [[left, top], [right, bottom]]: [Place; 2], radii: [f64; 4]) -> f64 {
    let [a, b, c, d] = radii;
    let sides = [
        [[left + a, top], [right - b, top]],
        [[right, top + b], [right, bottom - c]],
        [[right - c, bottom], [left + d, bottom]],
        [[left, bottom - d], [left, top + a]],
    ];
    let centers = [(left + a, top + a), (right - b, top + b), (right - c, bottom - c), (left + d, bottom - d)];
    let outward = [(-1.0, -1.0), (1.0, -1.0), (1.0, 1.0), (-1.0, 1.0)];
    let arcs = centers.into_iter().zip(radii).zip(outward).filter_map(|(((cx, cy), radius), (to_x, to_y))| {
        let is_beside = (x - cx) * to_x >= -1.0 && (y - cy) * to_y >= -1.0;
        is_beside.then(|| ((x - cx).hypot(y - cy) - radius).abs())
    });
    sides.map(|side| from_edge([x, y], side)).into_iter().chain(arcs).fold(f64::INFINITY, f64::min)
}

#[test]
fn a_fine_circle_has_four_times_as_many_vertices() {
    let circle = Oval::circle(Point2::corner(0, 0), Subpixel::from_num(30)).expect("in range");
    assert_eq!((coarse(&circle).contours[0].len(), fine(&circle).contours[0].len()), (128, 512));
    // A turn that is no whole number of sixteenths of a pixel: where the coarse one cannot be.
    let eighth = fine(&circle.arc(Angle(1 << 13), 0));
    assert_eq!(eighth.contours[0][0], (5431, 5431));
    assert_eq!(coarse(&circle.arc(Angle(1 << 13), Arc::TURN)).contours[0][0], (339, 339));
}
