//! From the units of a font to the screen, in one rounding.
//!
//! A font is drawn on a grid of some hundred or thousand units an em, y upwards. What becomes of it is linear:
//!
//! ```text
//!   ▲ y      units · size / units an em        sixteenths of a pixel ── trace
//!   │ ╱╲     ─────── affine map ──────▶                  or
//!   ●────▶ x           + place                 256ths of a pixel ────── trace_fine
//! ```
//!
//! The four factors are numbers of 30 bits with a common power of two, so that a product fits 62 bits whatever the size
//! and the font. A place keeps 16 binary digits behind the 256ths of a pixel until it is rounded.

use crate::{
    affine::Affine,
    num::{Scalar, Subpixel, divide_round, low_i32, saturate_i32},
    space::{Point2, Rect},
};

/// Digits of a factor: two products of 30 and 31 bits and a sum fit 62.
const DIGITS: u32 = 30;
/// Binary digits behind 256ths of a pixel in a [`Place`].
const PLACE_DIGITS: u32 = 16;
/// The same behind pixels.
const PIXEL_DIGITS: u32 = PLACE_DIGITS + 8;

/// A place on the screen in 2⁻¹⁶ of 256ths of a pixel: x and y.
pub(crate) type Place = [i64; 2];

/// A box in font units: left, bottom, right, top.
pub(crate) type Sides = [i32; 4];

/// Where a glyph goes, as a map of its coordinates.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) struct EmMap {
    /// What x and y, in font units, give to the x of the screen in 256ths of a pixel, times 2^`shift` …
    x: [i32; 2],
    /// … and to its y.
    y: [i32; 2],
    shift: u32,
    origin: Place,
}

impl EmMap {
    /// An em of so many units becomes `size` pixels, then comes the map, then the origin goes to `at`.
    ///
    /// Factors are right to 2⁻²⁹ of the largest one. A size that is not positive is none.
    pub(crate) fn new((size, units_per_em): (Subpixel, u16), map: Affine, at: Point2) -> Self {
        let ([xx, xy], [yx, yy], moved) = map.parts();
        let size = i64::from(size.to_bits().max(0));
        // y points upwards in a font. Below 2⁶², in 2⁻¹² of 256ths of a pixel.
        let products = [xx, xy, yx, yy].map(|factor| i64::from(factor.to_bits()) * size);
        let largest = products.iter().map(|product| product.unsigned_abs()).max().unwrap_or(0);
        let up = largest.leading_zeros().saturating_sub(2).min(61);
        let factors = products.map(|product| divide_round(product << up, i64::from(units_per_em.max(1))));
        let digits = u64::BITS - factors.iter().map(|f| f.unsigned_abs()).max().unwrap_or(0).leading_zeros();
        let down = digits.saturating_sub(DIGITS);
        let [xx, xy, yx, yy] = factors.map(|factor| low_i32(factor >> down));
        let origin = [at.x, at.y].map(place).into_iter().zip([moved.x, moved.y].map(place));
        let mut sums = origin.map(|(at, moved)| at + moved);
        Self {
            x: [xx, -xy],
            y: [yx, -yy],
            // Where it would be less than nothing, every unit is farther from the next than a screen is wide.
            shift: (up + 12).saturating_sub(down).min(62),
            origin: [sums.next().unwrap_or(0), sums.next().unwrap_or(0)],
        }
    }

    /// The same with its origin at a point given in whole font units.
    pub(crate) fn moved(self, [x, y]: [i32; 2]) -> Self {
        let along = |row| shifted(combined(row, [x, y]), self.shift);
        let [from_x, from_y] = self.origin;
        Self { origin: [from_x.saturating_add(along(self.x)), from_y.saturating_add(along(self.y))], ..self }
    }

    /// The same, farther by so much.
    pub(crate) const fn farther(self, [x, y]: Place) -> Self {
        let [from_x, from_y] = self.origin;
        Self { origin: [from_x.saturating_add(x), from_y.saturating_add(y)], ..self }
    }

    /// The same with its origin at the nearest corner of a pixel.
    pub(crate) fn snapped(self) -> Self {
        let nearest = |along: i64| along.saturating_add(1 << (PIXEL_DIGITS - 1)) >> PIXEL_DIGITS << PIXEL_DIGITS;
        Self { origin: self.origin.map(nearest), ..self }
    }

    /// Where a point of the font goes.
    #[inline]
    pub(crate) fn apply(&self, x: Scalar, y: Scalar) -> Place {
        let of = [x.to_bits(), y.to_bits()];
        let [from_x, from_y] = self.origin;
        // 16 digits behind the units become the 16 digits of a place.
        let along = |row| combined(row, of) >> self.shift;
        [from_x.saturating_add(along(self.x)), from_y.saturating_add(along(self.y))]
    }

    /// Where its origin goes.
    pub(crate) const fn origin(&self) -> Place {
        self.origin
    }

    /// Which way a line of text runs on the screen: the signs of x and y.
    pub(crate) const fn direction(&self) -> [i32; 2] {
        [self.x[0].signum(), self.y[0].signum()]
    }

    /// How far a box reaches from the origin.
    pub(crate) fn spread(&self, [left, bottom, right, top]: Sides) -> Spread {
        let reach = |[a, b]: [i32; 2]| {
            let product = |factor: i32, of: i32| i64::from(factor) * i64::from(of);
            let (across, up) = ([product(a, left), product(a, right)], [product(b, bottom), product(b, top)]);
            let end = |pick: fn(i64, i64) -> i64| {
                let [least, most] = [across, up].map(|[one, other]| pick(one, other));
                shifted(least.saturating_add(most), self.shift)
            };
            [end(i64::min), end(i64::max)]
        };
        let [[left, right], [top, bottom]] = [self.x, self.y].map(reach);
        Spread { least: [left, top], most: [right, bottom] }
    }
}

/// A rectangle about the origin of a glyph, in the units of a [`Place`].
#[derive(Clone, Copy, Debug)]
pub(crate) struct Spread {
    least: Place,
    most: Place,
}

impl Spread {
    /// The pixels that it may touch where the origin is, and one more on each side for what is rounded.
    #[inline(never)]
    pub(crate) fn pixels_at(self, [x, y]: Place) -> Rect {
        let pixel = |of: i64, from: i64, margin: i64| saturate_i32((from.saturating_add(of) >> PIXEL_DIGITS) + margin);
        let ([left, top], [right, bottom]) = (self.least, self.most);
        Rect::new(pixel(left, x, -1), pixel(top, y, -1), pixel(right, x, 2), pixel(bottom, y, 2))
    }
}

/// The point of the screen, in sixteenths of a pixel.
#[inline]
pub(crate) fn coarse(place: Place) -> Point2 {
    rounded(place, PLACE_DIGITS + 4)
}

/// The point of a screen sixteen times as large, in 256ths of a pixel.
#[inline]
pub(crate) fn fine(place: Place) -> Point2 {
    rounded(place, PLACE_DIGITS)
}

#[inline]
fn rounded(place: Place, digits: u32) -> Point2 {
    let [x, y] = place.map(|along| saturate_i32(along.saturating_add(1 << (digits - 1)) >> digits));
    Point2::from_sixteenths(x, y)
}

/// A coordinate of the screen as one of a place.
pub(crate) const fn place(along: Subpixel) -> i64 {
    (along.to_bits() as i64) << (PLACE_DIGITS + 4)
}

/// `row[0]·of[0] + row[1]·of[1]`: at most 2⁶² each, since a factor is below 2³¹.
#[inline]
fn combined([a, b]: [i32; 2], [x, y]: [i32; 2]) -> i64 {
    (i64::from(a) * i64::from(x)).saturating_add(i64::from(b) * i64::from(y))
}

/// A sum of factors times whole font units as a [`Place`].
const fn shifted(sum: i64, shift: u32) -> i64 {
    match shift.checked_sub(PLACE_DIGITS) {
        Some(down) => sum >> if down > 62 { 62 } else { down },
        None => sum.saturating_mul(1 << (PLACE_DIGITS - shift)),
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use proptest::prelude::*;

    /// Where a point goes, exactly, in 256ths of a pixel.
    fn exact(size: i32, units: u16, map: [i32; 4], at: [i32; 2], [x, y]: [f64; 2]) -> [f64; 2] {
        let scale = f64::from(size) / 16.0 * 256.0 / f64::from(units);
        let [xx, xy, yx, yy] = map.map(|factor| f64::from(factor) / 65_536.0 * scale);
        let [from_x, from_y] = at.map(|along| f64::from(along) * 16.0);
        [from_x + xx * x - xy * y, from_y + yx * x - yy * y]
    }

    fn map_of(map: [i32; 4]) -> Affine {
        let [xx, xy, yx, yy] = map.map(Scalar::from_bits);
        Affine::new([xx, xy], [yx, yy], Point2::default())
    }

    proptest! {
        #![proptest_config(ProptestConfig::with_cases(5_000))]
        #[test]
        fn places_are_exact_to_a_256th_of_a_256th(
            size in 1..16_000_i32, units in 16..=16_384_u16, map in prop::array::uniform4(-70_000..70_000_i32),
            at in prop::array::uniform2(-100_000..100_000_i32), point in prop::array::uniform2(-16_384..16_384_i32),
            pen in 0..100_000_i32,
        ) {
            let at_point = Point2::from_sixteenths(at[0], at[1]);
            let em = EmMap::new((Subpixel::from_bits(size), units), map_of(map), at_point);
            let [x, y] = point.map(|along| Scalar::from_num(along));
            let got = em.moved([pen, 0]).apply(x, y);
            let want = exact(size, units, map, at, [f64::from(pen) + f64::from(point[0]), f64::from(point[1])]);
            // 2⁻²⁹ of what the largest factor makes of 116,000 units, and a few units in the last place.
            let reach = f64::from(size) * 16.0 / f64::from(units) * 140_000.0;
            for (got, want) in got.into_iter().zip(want) {
                #[expect(clippy::cast_precision_loss, reason = "less than 53 bits")]
                let error = got as f64 / 65_536.0 - want;
                prop_assert!(error.abs() <= reach / f64::from(1 << 28) + 1e-4, "{error}");
            }
        }

        #[test]
        fn nothing_overflows(
            size: i32, units: u16, map: [i32; 4], at: [i32; 2], point: [i32; 2], pen: [i32; 2], sides: [i32; 4],
        ) {
            let em = EmMap::new((Subpixel::from_bits(size), units), map_of(map), Point2::from_sixteenths(at[0], at[1]));
            let em = em.moved(pen).moved(pen).farther([i64::MAX, i64::MIN]);
            let place = em.apply(Scalar::from_bits(point[0]), Scalar::from_bits(point[1]));
            let (_, _, _) = (coarse(place), fine(place), em.spread(sides).pixels_at(place));
        }

        #[test]
        fn a_spread_holds_the_points_of_its_box(
            size in 1..1600_i32, map in prop::array::uniform4(-70_000..70_000_i32), sides in prop::array::uniform4(-900..900_i32),
            inside in prop::array::uniform2(0..=100_i32),
        ) {
            let [left, bottom, width, height] = sides;
            let sides = [left, bottom, left + width.abs(), bottom + height.abs()];
            let em = EmMap::new((Subpixel::from_bits(size), 1000), map_of(map), Point2::corner(7, -9));
            let [x, y] = [left + width.abs() * inside[0] / 100, bottom + height.abs() * inside[1] / 100];
            let point = coarse(em.apply(Scalar::from_num(x), Scalar::from_num(y)));
            let pixels = em.spread(sides).pixels_at(em.origin());
            let [x, y] = [point.x, point.y].map(|along| along.to_bits() >> 4);
            prop_assert!(pixels.columns().contains(&x) && pixels.rows().contains(&y), "{pixels:?} {x} {y}");
        }
    }
}
