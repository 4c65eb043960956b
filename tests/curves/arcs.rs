//! Arcs and ovals against sines in floating point.

use std::f64::consts::{SQRT_2, TAU};

use aquatint::{Angle, Chord, OutOfRange, Oval, Point2, RoundedRectangle, Sector, Subpixel, pixel_bounds};
use proptest::{prelude::*, sample::select};

use crate::{distance, recorder::Recorder};

const LIMIT: i32 = 1 << 26;

fn oval(center: (i32, i32), radii: [i32; 2]) -> Result<Oval, OutOfRange> {
    Oval::new(Point2::from_sixteenths(center.0, center.1), radii.map(Subpixel::from_bits))
}

fn xy(point: Point2) -> [f64; 2] {
    [point.x, point.y].map(|v| f64::from(v.to_bits()))
}

/// The point of an oval at an angle in parts of which 65,536 are a turn.
fn exact((x, y): (i32, i32), radii: [i32; 2], angle: f64) -> [f64; 2] {
    let (sin, cos) = (angle / 65_536.0 * TAU).sin_cos();
    [f64::from(x) + f64::from(radii[0]) * cos, f64::from(y) + f64::from(radii[1]) * sin]
}

/// Checks everything about one arc.
fn check(center: (i32, i32), radii: [i32; 2], (start, sweep): (u16, i32)) -> Result<(), TestCaseError> {
    let arc = oval(center, radii).expect("in range").arc(Angle(start), sweep);
    let vertices = Recorder::of(&arc).contours.remove(0);
    let pieces = vertices.len() - 1;
    prop_assert!(pieces.is_power_of_two() && pieces <= 65_536);
    prop_assert_eq!(vertices[0], arc.start_point());

    // A sine is off by 5.2 · 10⁻¹⁰ at most.
    let radius = f64::from(radii[0].max(radii[1]));
    let rounding = (0.5 + radius * 5.2e-10) * SQRT_2 + 1e-6;
    let n = f64::from(u32::try_from(pieces).expect("few"));
    let at = |index: f64| exact(center, radii, f64::from(start) + f64::from(sweep) * index / n);
    for (index, vertex) in (0_u32..).zip(&vertices) {
        let [x, y] = [0, 1].map(|axis| xy(*vertex)[axis] - at(index.into())[axis]);
        prop_assert!(x.hypot(y) <= rounding, "vertex {} of {} is {} off", index, pieces, x.hypot(y));
    }
    let samples = if pieces > 256 { 2 } else { 8 };
    for (index, ends) in (0_u32..).zip(vertices.windows(2)) {
        for sample in 0..samples {
            let point = at(f64::from(index) + f64::from(sample) / f64::from(samples));
            let off = distance(point, [xy(ends[0]), xy(ends[1])]);
            prop_assert!(off <= 0.96, "{} sixteenths off in piece {} of {}", off, index, pieces);
        }
    }
    // Half as many would not do.
    let angle = f64::from(sweep) / 65_536.0 * TAU;
    prop_assert!(pieces == 1 || 4.0 * radius * angle * angle / (8.0 * n * n) > 0.19, "{} pieces", pieces);
    Ok(())
}

fn radius() -> impl Strategy<Value = i32> {
    prop_oneof![8 => 0..4000_i32, 3 => 0..40_i32, 1 => 0..1_000_000_i32]
}

fn sweep() -> impl Strategy<Value = i32> {
    prop_oneof![4 => -65_536..=65_536_i32, 1 => -300..300_i32, 2 => select(vec![0, 16_384, -16_384, 65_536, -65_536])]
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(10_000))]

    #[test]
    fn arcs_are_less_than_a_sixteenth_off(
        center in (-9000..9000_i32, -9000..9000_i32), radii in [radius(), radius()], start in any::<u16>(),
        sweep in sweep(),
    ) {
        check(center, radii, (start, sweep))?;
    }

    #[test]
    fn an_oval_is_symmetric_in_both_axes(
        center in (-9000..9000_i32, -9000..9000_i32), radii in [radius(), radius()],
    ) {
        let recorded = Recorder::of(&oval(center, radii).expect("in range"));
        prop_assert_eq!(&recorded.closed, &[true]);
        let mut points: Vec<_> = recorded.contours[0]
            .iter()
            .map(|point| (point.x.to_bits() - center.0, point.y.to_bits() - center.1))
            .collect();
        points.sort_unstable();
        let mirrored = |mirror: fn((i32, i32)) -> (i32, i32)| {
            let mut points: Vec<_> = points.iter().copied().map(mirror).collect();
            points.sort_unstable();
            points
        };
        prop_assert_eq!(&mirrored(|(x, y)| (-x, y)), &points);
        prop_assert_eq!(&mirrored(|(x, y)| (x, -y)), &points);
        if radii[0] == radii[1] {
            prop_assert_eq!(&mirrored(|(x, y)| (y, x)), &points);
        }
    }
}

#[test]
fn the_largest_arcs_are_less_than_a_sixteenth_off() {
    for radii in [[LIMIT - 1, LIMIT - 1], [LIMIT - 1, 3], [0, LIMIT - 1], [30_000_000, 9_000_000]] {
        for arc in [(0, 65_536), (777, -65_536), (9, 1), (40_000, 20_000)] {
            check((0, 0), radii, arc).expect("within the bound");
        }
    }
}

#[test]
fn a_whole_turn_ends_where_it_began() {
    for (start, sweep) in [(0, 65_536), (1234, -65_536), (77, i32::MAX), (65_535, i32::MIN)] {
        let arc = oval((5, 7), [500, 300]).expect("in range").arc(Angle(start), sweep);
        let vertices = Recorder::of(&arc).contours.remove(0);
        assert_eq!(vertices.first(), vertices.last());
        assert_eq!(pixel_bounds(&arc), pixel_bounds(&oval((5, 7), [500, 300]).expect("in range")));
    }
}

#[test]
fn ovals_out_of_range_are_refused() {
    let end = LIMIT - 1;
    assert!(oval((0, 0), [end, end]).is_ok());
    assert!(oval((end, -end), [0, 0]).is_ok());
    for (center, radii) in [
        ((0, 0), [LIMIT, 1]),
        ((1, 0), [end, 1]),
        ((0, -9), [1, end - 8]),
        ((0, 0), [-1, 5]),
        ((0, 0), [5, i32::MIN]),
        ((LIMIT, 0), [0, 0]),
        ((i32::MIN, i32::MAX), [i32::MAX, i32::MAX]),
    ] {
        assert_eq!(oval(center, radii), Err(OutOfRange), "{center:?} {radii:?}");
    }
}

#[test]
fn sectors_and_chords_are_closed_arcs() {
    let arc = oval((0, 0), [8, 8]).expect("in range").arc(Angle(0), 16_384);
    assert_eq!(Recorder::of(&arc).svg(), "M8,0 L7,3 L6,6 L3,7 L0,8");
    assert_eq!(Recorder::of(&Chord(arc)).svg(), "M8,0 L7,3 L6,6 L3,7 L0,8 Z");
    assert_eq!(Recorder::of(&Sector(arc)).svg(), "M0,0 L8,0 L7,3 L6,6 L3,7 L0,8 Z");
}

fn rounded([a, b]: [(i32, i32); 2], radii: [i32; 4]) -> Result<RoundedRectangle, OutOfRange> {
    let corners = [a, b].map(|(x, y)| Point2::from_sixteenths(x, y));
    RoundedRectangle::new(corners, Subpixel::ZERO).map(|rectangle| rectangle.with_radii(radii.map(Subpixel::from_bits)))
}

fn drawn_radii(corners: [(i32, i32); 2], radii: [i32; 4]) -> [i32; 4] {
    rounded(corners, radii).expect("in range").radii().map(Subpixel::to_bits)
}

#[test]
fn radii_that_do_not_fit_shrink_together() {
    let corners = [(0, 0), (160, 80)];
    assert_eq!(drawn_radii(corners, [10, 20, 30, 40]), [10, 20, 30, 40]);
    assert_eq!(drawn_radii(corners, [40, 40, 40, 40]), [40; 4]);
    assert_eq!(drawn_radii(corners, [200, 200, 200, 200]), [40; 4]);
    // The left side, 80 of 160, is worse off than the bottom, 160 of 240.
    assert_eq!(drawn_radii(corners, [40, 0, 120, 120]), [20, 0, 60, 60]);
    assert_eq!(drawn_radii(corners, [-5, i32::MIN, i32::MAX, 0]), [0, 0, 80, 0]);
    assert_eq!(drawn_radii([(7, 7), (7, 90)], [3, 4, 5, 6]), [0; 4]);
    assert_eq!(drawn_radii([(160, 0), (0, 80)], [200; 4]), [40; 4]);
    assert_eq!(drawn_radii([(1 - LIMIT, 1 - LIMIT), (LIMIT - 1, LIMIT - 1)], [i32::MAX; 4]), [LIMIT - 1; 4]);
    assert_eq!(rounded([(0, 0), (LIMIT, 5)], [0; 4]), Err(OutOfRange));
}

#[test]
fn a_rounded_rectangle_without_radii_is_a_rectangle_and_with_the_largest_an_oval() {
    let corners = [(0, 0), (160, 80)];
    let sharp = Recorder::of(&rounded(corners, [0; 4]).expect("in range"));
    assert_eq!(sharp.svg(), "M0,0 L160,0 L160,80 L0,80 Z");
    let round = Recorder::of(&rounded([(-50, -50), (50, 50)], [50; 4]).expect("in range"));
    let circle = Recorder::of(&oval((0, 0), [50, 50]).expect("in range"));
    let sorted = |recorder: &Recorder| {
        let mut points: Vec<_> = recorder.contours[0].iter().map(|p| (p.x.to_bits(), p.y.to_bits())).collect();
        points.sort_unstable();
        points.dedup();
        points
    };
    assert_eq!(sorted(&round), sorted(&circle));
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(10_000))]

    #[test]
    fn a_rounded_rectangle_stays_in_its_rectangle_and_touches_its_sides(
        (left, top) in (-3000..3000_i32, -3000..3000_i32), (width, height) in (0..3000_i32, 0..3000_i32),
        radii in [radius(), radius(), radius(), radius()],
    ) {
        let rectangle = rounded([(left, top), (left + width, top + height)], radii).expect("in range");
        let contour = Recorder::of(&rectangle).contours.remove(0);
        let (x, y) = (contour.iter().map(|p| p.x.to_bits()), contour.iter().map(|p| p.y.to_bits()));
        prop_assert_eq!((x.clone().min(), x.max()), (Some(left), Some(left + width)));
        prop_assert_eq!((y.clone().min(), y.max()), (Some(top), Some(top + height)));
        prop_assert!(contour.windows(2).all(|ends| ends[0] != ends[1]), "an edge without length");
    }
}
