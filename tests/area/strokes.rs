//! Thin lines keep their light however they are turned.

use std::f64::consts::PI;

use aquatint::{
    Cap, Coverage, Join, Outline, Point2, Polyline, Rect, Rule, Stroke, Stroked, Subpixel, raster::area::AreaEdge,
};
use heapless::Vec as List;
use proptest::{collection::vec, prelude::*};

use super::{WINDOW, drawn, oracle, polygons::covered, worst};

/// Light in pixels.
fn light(outline: &impl Outline) -> f64 {
    drawn(outline, Rule::NonZero, Rect::new(0, 0, 60, 60)).iter().map(|&part| f64::from(part) / 32_768.0).sum()
}

#[expect(clippy::cast_possible_truncation, reason = "rounded")]
fn turned(center: (f64, f64), radius: f64, angle: f64) -> [Point2; 2] {
    let at = |radius: f64| {
        let [x, y] = [center.0 + radius * angle.cos(), center.1 + radius * angle.sin()];
        Point2::from_sixteenths((x * 16.0).round() as i32, (y * 16.0).round() as i32)
    };
    [at(-radius), at(radius)]
}

fn length([a, b]: [Point2; 2]) -> f64 {
    let along = [b.x - a.x, b.y - a.y].map(|v| f64::from(v.to_bits()) / 16.0);
    along[0].hypot(along[1])
}

#[test]
fn a_thin_line_keeps_its_light_in_a_full_turn() {
    let mut worst = [0.0_f64; 3];
    for step in 0..720_u32 {
        let angle = f64::from(step) / 360.0 * PI;
        let ends = turned((30.3, 29.6), 25.0, angle);
        for (width, worst) in [8, 16, 32].into_iter().zip(&mut worst) {
            let line =
                Stroked::new(Polyline::new(&ends).expect("in range"), Stroke::of_width(Subpixel::from_bits(width)));
            let exact = length(ends) * f64::from(width) / 16.0;
            *worst = worst.max((light(&line) / exact - 1.0).abs());
        }
    }
    assert!(worst.iter().all(|off| *off <= 0.01), "{worst:?}");
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(500))]

    /// The union of the pieces of a stroke, by the oracle.
    #[test]
    fn strokes_are_the_areas_of_their_outlines(
        points in vec((-20..480_i32, -20..380_i32), 2..5), width in 1..100_i32, join in 0..3_usize, cap in 0..3_usize,
    ) {
        let points: Vec<_> = points.into_iter().map(|(x, y)| Point2::from_sixteenths(x, y)).collect();
        let join = [Join::Miter { limit: 4 }, Join::Round, Join::Bevel][join];
        let cap = [Cap::Butt, Cap::Round, Cap::Square][cap];
        let stroke = Stroke::of_width(Subpixel::from_bits(width)).with_join(join).with_cap(cap);
        let line = Stroked::new(Polyline::new(&points).expect("in range"), stroke);
        let off = worst(&drawn(&line, Rule::NonZero, WINDOW), &oracle::coverage(&line, Rule::NonZero, WINDOW));
        prop_assert!(off <= 2.0, "{off}");
    }
}

/// A stroke without a list of edges.
fn without_list(line: &impl Outline, rule: Rule) -> Vec<u16> {
    covered(line, rule, WINDOW, &mut List::<AreaEdge, 0>::new(), &mut [Coverage::NONE; 64])
}

#[test]
fn a_stroke_without_a_list_is_the_union_of_its_pieces() {
    let corners = [(20, 40), (380, 60), (390, 300), (120, 310), (200, -30)].map(|(x, y)| Point2::from_sixteenths(x, y));
    for (points, width) in [(&corners[..2], 9), (&corners[..], 9), (&corners[..], 70)] {
        let line = Stroked::new(Polyline::new(points).expect("in range"), Stroke::of_width(Subpixel::from_bits(width)));
        let exact = oracle::coverage(&line, Rule::NonZero, WINDOW);
        let excess: Vec<f64> = without_list(&line, Rule::NonZero)
            .iter()
            .zip(&exact)
            .map(|(ours, exact)| f64::from(*ours) / 128.0 - exact * 256.0)
            .collect();
        // Nothing is missing; too much is where borders of pieces cross, in two pixels a corner or crossing at most.
        assert!(excess.iter().all(|excess| *excess >= -2.0), "{excess:?}");
        let crossed = excess.iter().filter(|excess| **excess > 2.0).count();
        assert!(crossed <= if points.len() == 2 { 0 } else { 20 }, "{crossed}");
        // By the other rule pieces that lie upon each other are a hole, whatever there is for a list.
        let holes = oracle::coverage(&line, Rule::EvenOdd, WINDOW);
        let off = worst(&without_list(&line, Rule::EvenOdd), &holes);
        assert!(off <= 16.0, "{off}");
    }
}
