//! Coverage that is kept and shown again.

use std::ops::Range;

use aquatint::{
    Coverage, CoverageMask, Covered, Point2, Polygon, Rect, Rule, SpanFn,
    raster::area::{AreaEdge, Scratch, fill},
};
use embedded_graphics::geometry::{Point, Size};
use heapless::Vec as List;
use proptest::{collection::vec, prelude::*, sample::select};

use super::drawn;

const SIZE: Size = Size::new(40, 9);

/// What a mask gives to a window, each pixel once at most and in order.
fn shown<B: AsRef<[u8]>>(mask: &CoverageMask<B>, at: Point, window: Rect) -> Vec<u8> {
    let mut picture = vec![0; window.width() as usize * window.height() as usize];
    let mut last = (i32::MIN, i32::MIN);
    let mut sink = SpanFn::new(window, |row: i32, columns: Range<i32>, covered: Covered<'_>| {
        assert_eq!(window.clip_run(row, columns.clone()), Some(columns.clone()));
        assert!(last <= (row, columns.start), "out of order");
        last = (row, columns.end);
        for (offset, column) in columns.enumerate() {
            let place = (i64::from(row) - i64::from(window.top)) * i64::from(window.width()) + i64::from(column)
                - i64::from(window.left);
            picture[usize::try_from(place).expect("inside")] = covered.at(offset).to_byte();
        }
    });
    let Ok(()) = mask.spans(at, &mut sink);
    picture
}

fn offset() -> impl Strategy<Value = i32> {
    prop_oneof![6 => -50..50_i32, 1 => any::<i32>(), 1 => select(vec![i32::MIN, i32::MAX, i32::MAX - 3, i32::MIN + 3])]
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(1_000))]

    #[test]
    fn a_mask_is_shown_at_any_place(bytes in vec(prop_oneof![Just(0), any::<u8>()], 360), at in (offset(), offset()), corner in (offset(), offset()), size in (0..60_i32, 0..12_i32)) {
        let mask = CoverageMask::new(&bytes[..], SIZE).expect("memory enough");
        let window = Rect::new(corner.0, corner.1, corner.0.saturating_add(size.0), corner.1.saturating_add(size.1));
        let expected: Vec<u8> = window.rows().flat_map(|y| window.columns().map(move |x| (x, y))).map(|(x, y)| {
            let (x, y) = (i64::from(x) - i64::from(at.0), i64::from(y) - i64::from(at.1));
            let is_inside = (0..40).contains(&x) && (0..9).contains(&y);
            if is_inside { bytes[usize::try_from(y * 40 + x).expect("inside")] } else { 0 }
        }).collect();
        prop_assert_eq!(shown(&mask, Point::new(at.0, at.1), window), expected);
    }

    #[test]
    fn a_shape_kept_is_the_shape_to_eight_bits(corners in vec((-50..700_i32, -50..200_i32), 3..6)) {
        let corners: Vec<_> = corners.into_iter().map(|(x, y)| Point2::from_sixteenths(x, y)).collect();
        let contours = [&corners[..]];
        let polygon = Polygon::new(&contours).expect("in range");
        let mut mask = CoverageMask::new(vec![0; 360], SIZE).expect("memory enough");
        let (mut edges, mut cells) = (List::<AreaEdge, 16>::new(), [Coverage::NONE; 64]);
        let Ok(()) = fill(&polygon, Rule::NonZero, Scratch { edges: &mut edges, cells: &mut cells }, &mut mask);
        let window = Rect::of_size(SIZE);
        let direct: Vec<u8> = drawn(&polygon, Rule::NonZero, window).into_iter().map(|part| Coverage::new(part).to_byte()).collect();
        prop_assert_eq!(mask.bytes(), &direct[..]);
        prop_assert_eq!(shown(&mask, Point::zero(), window), direct);
    }
}

#[test]
fn masks_keep_the_greater_coverage_and_are_cleared() {
    use aquatint::Sink;
    let mut mask = CoverageMask::new([0; 8], Size::new(4, 2)).expect("memory enough");
    let [some, more] = [100, 200].map(Coverage::from_byte);
    let Ok(()) = mask.span(1, 0..3, Covered::Evenly(some));
    let Ok(()) = mask.span(1, 1..4, Covered::Each(&[Coverage::NONE, more, more]));
    let Ok(()) = mask.span(0, 2..3, Covered::Evenly(Coverage::FULL));
    assert_eq!(mask.bytes(), [0, 0, 255, 0, 100, 100, 200, 200]);
    // Spans that no rasteriser gives.
    for (row, columns) in [(2, 0..1), (-1, 0..4), (0, -3..2), (i32::MAX, 0..i32::MAX), (0, i32::MIN..i32::MAX)] {
        let Ok(()) = mask.span(row, columns, Covered::Evenly(Coverage::FULL));
    }
    assert_eq!(mask.bytes(), [0, 0, 255, 0, 100, 100, 200, 200]);
    mask.clear();
    assert_eq!(mask.bytes(), [0; 8]);
    assert!(CoverageMask::new([0; 7], Size::new(4, 2)).is_none());
    assert!(CoverageMask::new([0; 7], Size::new(u32::MAX, u32::MAX)).is_none());
    assert!(CoverageMask::new([0; 0], Size::new(0, u32::MAX)).is_some());
}
