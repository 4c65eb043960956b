//! Bands, tiles and strips of cells give the whole.

use aquatint::{
    Coverage, Outline, Point2, Polygon, Polyline, Rect, Rule, Stroke, Stroked, Subpixel, raster::area::AreaEdge,
};
use heapless::Vec as List;
use proptest::{collection::vec, prelude::*};

use super::{WINDOW, apart, drawn, point, polygons::covered, rule};

/// The part of a picture of the window that lies in a piece of it.
fn part(picture: &[u16], piece: Rect) -> Vec<u16> {
    let width = WINDOW.width() as usize;
    let place = |x: i32, y: i32| (y - WINDOW.top) as usize * width + (x - WINDOW.left) as usize;
    piece.rows().flat_map(|y| piece.columns().map(move |x| picture[place(x, y)])).collect()
}

/// The greatest difference of the pieces of a window from the whole.
fn difference(outline: &impl Outline, rule: Rule, (width, height): (i32, i32)) -> u16 {
    let whole = drawn(outline, rule, WINDOW);
    let mut most = 0;
    for top in WINDOW.rows().step_by(height as usize) {
        for left in WINDOW.columns().step_by(width as usize) {
            let piece = Rect::new(left, top, left + width, top + height).intersection(WINDOW);
            most = most.max(apart(&drawn(outline, rule, piece), &part(&whole, piece)));
        }
    }
    most
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(500))]

    #[test]
    fn bands_are_the_whole_to_the_bit(corners in vec(point(), 3..9), rule in rule(), height in 1..9_i32) {
        let contours = [&corners[..]];
        prop_assert_eq!(difference(&Polygon::new(&contours).expect("in range"), rule, (32, height)), 0);
    }

    #[test]
    fn tiles_are_the_whole_but_for_their_sides(corners in vec(point(), 3..9), rule in rule(), size in (1..20_i32, 1..9_i32)) {
        let contours = [&corners[..]];
        let off = difference(&Polygon::new(&contours).expect("in range"), rule, size);
        prop_assert!(off <= TILES, "{}", off);
    }

    #[test]
    fn strokes_are_the_same_in_pieces(corners in vec(point(), 2..5), width in 1..60_i32, size in (1..20_i32, 1..9_i32)) {
        let stroke = Stroke::of_width(Subpixel::from_bits(width));
        let line = Stroked::new(Polyline::new(&corners).expect("in range"), stroke);
        prop_assert_eq!(difference(&line, Rule::NonZero, (32, size.1)), 0);
        prop_assert!(difference(&line, Rule::NonZero, size) <= TILES);
    }

    #[test]
    fn cells_are_a_matter_of_speed(corners in vec(point(), 3..9), rule in rule(), cells in 0..40_usize) {
        let contours = [&corners[..]];
        let polygon = Polygon::new(&contours).expect("in range");
        let mut cells = vec![Coverage::FULL; cells];
        let short = covered(&polygon, rule, WINDOW, &mut List::<AreaEdge, 256>::new(), &mut cells);
        let off = apart(&short, &drawn(&polygon, rule, WINDOW));
        prop_assert!(off <= TILES, "{off}");
    }
}

/// 32768ths: where an edge enters from outside of the cells its height is parted, rounded down.
const TILES: u16 = 6;

#[test]
fn the_first_row_of_a_band_may_be_any() {
    let corners = [(3, -70), (470, 120), (77, 333), (215, 12)].map(|(x, y)| Point2::from_sixteenths(x, y));
    let contours = [&corners[..]];
    let polygon = Polygon::new(&contours).expect("in range");
    for top in WINDOW.rows() {
        let band = Rect::new(WINDOW.left, top, WINDOW.right, WINDOW.bottom);
        let whole = part(&drawn(&polygon, Rule::EvenOdd, WINDOW), band);
        assert_eq!(drawn(&polygon, Rule::EvenOdd, band), whole);
    }
}

/// Two borders of it cross in the middle of the least band of a row: which is left of the other there may not depend on
/// the rows above.
#[test]
fn edges_that_cross_in_the_middle_of_a_band_have_one_order() {
    let corners = [(0, 176), (7, -2438), (4635, 150), (28, 151)].map(|(x, y)| Point2::from_sixteenths(x, y));
    let line = Stroked::new(Polyline::new(&corners).expect("in range"), Stroke::of_width(Subpixel::from_bits(19)));
    assert_eq!(difference(&line, Rule::NonZero, (32, 1)), 0);
}
