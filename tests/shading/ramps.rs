//! A run of light that changes evenly, dithered in few fills, is the same run dithered pixel by pixel.

use core::{convert::Infallible, ops::Range};

use aquatint::{
    BAYER_2X2, BAYER_4X4, BAYER_8X8, BAYER_16X16, BLUE_NOISE_64, Code, Columns, Dithered, Inverted, Levels, Light,
    LsbFirst, MsbFirst, Pages, Planes, Point2, R2Noise, Rect, Rows, SpanFn, Target, Triangle,
    display::{
        dither::{CROSS_HATCH_8X8, Mask, Method},
        halftone::{DOTS_6X6, DOTS_45_8X8},
        layout::Layout,
        level::linear_levels,
    },
    vary::{Ramp, Vertex},
};
use embedded_graphics::pixelcolor::{BinaryColor, Gray2, Gray4, Gray8};
use proptest::prelude::*;

use crate::{
    on_all_targets,
    verbs::{Draw, on_target, run},
};

/// Light from a number to another over so many pixels.
fn ramp(from: u16, to: u16, pixels: i32) -> Ramp<1> {
    let corner = |x, y, light| Vertex { position: Point2::corner(x, y), attributes: [light] };
    let triangle = Triangle::new([corner(0, 0, from), corner(pixels, 0, to), corner(0, 64, from)]).expect("in range");
    let mut ramp = None;
    let take = |_, _: Range<i32>, first: Ramp<1>| ramp = Some(first);
    let Ok(()) = triangle.spans(&mut SpanFn::new(Rect::new(0, 0, pixels, 1), take));
    ramp.expect("a row of pixels")
}

/// A ramp on a run, which may begin and end beside the target.
#[derive(Clone, Debug)]
struct Lit {
    row: i32,
    columns: Range<i32>,
    ends: [u16; 2],
    pixels: i32,
    /// Pixels of the ramp before the run.
    before: usize,
}

impl Lit {
    fn ramp(&self) -> Ramp<1> {
        let mut ramp = ramp(self.ends[0], self.ends[1], self.pixels);
        if let Some(last) = self.before.checked_sub(1) {
            ramp.nth(last);
        }
        ramp
    }
}

struct Drawn<'v, M> {
    runs: &'v [Lit],
    mask: M,
    levels: Levels<'v>,
    by_ramp: bool,
}

impl<C: Code, M: Mask + Copy> Draw<C> for Drawn<'_, M> {
    fn on<T: Target<Color = C, Error = Infallible>>(&self, target: &mut T) {
        let mut dithered = Dithered::new(target, self.levels).with_method(self.mask);
        for lit in self.runs {
            let (row, columns, ramp) = (lit.row, lit.columns.clone(), lit.ramp());
            let Ok(()) = if self.by_ramp {
                dithered.fill_ramp(row, columns, ramp)
            } else {
                dithered.write_run(row, columns, ramp.map(|[light]| Some(Light(light))))
            };
        }
    }
}

type Case<'v, M> = (&'v [Lit], M, Levels<'v>);

fn check<C: Code, L: Layout<C>, M: Mask + Copy>((runs, mask, levels): Case<'_, M>, way: u8) {
    let draw = |by_ramp| on_target::<C, L>(way, &Drawn { runs, mask, levels, by_ramp });
    assert_eq!(draw(true), draw(false), "{}, way {way}: {runs:?}, {levels:?}", core::any::type_name::<L>());
}

/// From its first pixel to its last a ramp is between its ends: steep, slow, rising, falling, level; ends that are levels.
fn lit() -> impl Strategy<Value = Lit> {
    let end =
        || prop_oneof![any::<u16>(), Just(0), Just(u16::MAX), Just(20_000), Just(20_001), Just(21_845), 0..400_u16];
    let more = prop_oneof![Just(0_u16), 0..20_u16, 0..400_u16, 0..30_000_u16];
    (run(), [end(), end()], more, any::<u16>(), any::<bool>()).prop_map(
        |((row, columns), mut ends, more, at, is_level)| {
            if is_level && at % 3 == 0 {
                ends[1] = ends[0].saturating_add(at % 64);
            }
            let length = i32::try_from(columns.len()).expect("short").max(1);
            let before = usize::from(at) % (usize::from(more) + 1);
            Lit { row, columns, ends, pixels: length + i32::from(more), before }
        },
    )
}

static FIVE: [u16; 5] = linear_levels();

/// Levels of 1, 2 and 4 bits, even and uneven.
fn levels() -> impl Strategy<Value = Levels<'static>> {
    const UNEVEN: [&[u16]; 5] = [
        &[5_000, 60_000],
        &[0, 1],
        &[65_534, 65_535],
        &[100, 20_000, 20_001, 65_000],
        &[0, 3, 9, 27, 81, 243, 729, 2_187],
    ];
    let of = |lights: &'static [u16]| Levels::new(lights).expect("rising");
    prop::sample::select(vec![
        Levels::ONE_BIT,
        Levels::LINEAR_4,
        Levels::SRGB_4,
        Levels::LINEAR_16,
        Levels::SRGB_16,
        Levels::SRGB_64,
        of(&FIVE),
        of(UNEVEN[0]),
        of(UNEVEN[1]),
        of(UNEVEN[2]),
        of(UNEVEN[3]),
        of(UNEVEN[4]),
    ])
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(1_000))]
    #[test]
    fn by_fills_as_by_pixels_on_all_targets(runs in prop::collection::vec(lit(), 1..5), levels in levels()) {
        fn ordered<C: Code, L: Layout<C>>(case: (&[Lit], Levels<'_>), way: u8) {
            check::<C, L, _>((case.0, Method::Ordered4x4, case.1), way);
        }
        on_all_targets!(ordered, (&runs, levels));
    }

    #[test]
    fn by_fills_as_by_pixels_with_all_masks(runs in prop::collection::vec(lit(), 1..5), levels in levels(), way in 0..4_u8) {
        fn on_both<M: Mask + Copy>(case: Case<'_, M>, way: u8) {
            check::<BinaryColor, Rows, M>(case, way);
            check::<Gray4, Rows, M>(case, way);
        }
        on_both((&runs, Method::Nearest, levels), way);
        on_both((&runs, &BAYER_2X2, levels), way);
        on_both((&runs, &BAYER_4X4, levels), way);
        on_both((&runs, &BAYER_8X8, levels), way);
        on_both((&runs, &DOTS_45_8X8, levels), way);
        on_both((&runs, &CROSS_HATCH_8X8, levels), way);
        // These do not repeat in eight.
        on_both((&runs, &BAYER_16X16, levels), way);
        on_both((&runs, &BLUE_NOISE_64, levels), way);
        on_both((&runs, &DOTS_6X6, levels), way);
        on_both((&runs, R2Noise, levels), way);
    }
}

/// Counts what is asked of it.
struct Counting {
    bounds: Rect,
    fills: usize,
    writes: usize,
    pixels: usize,
}

impl Target for Counting {
    type Color = Gray4;
    type Error = Infallible;

    fn bounds(&self) -> Rect {
        self.bounds
    }

    fn fill_run<const N: usize>(&mut self, _: i32, columns: Range<i32>, _: [Gray4; N]) -> Result<(), Infallible> {
        self.fills += 1;
        self.pixels += columns.len();
        Ok(())
    }

    fn write_run(
        &mut self,
        _: i32,
        columns: Range<i32>,
        _: impl Iterator<Item = Option<Gray4>>,
    ) -> Result<(), Infallible> {
        self.writes += 1;
        self.pixels += columns.len();
        Ok(())
    }
}

fn counted(levels: Levels<'_>, ends: [u16; 2], pixels: i32, row: i32) -> Counting {
    let mut target = Counting { bounds: Rect::new(0, 0, 4_000, 8), fills: 0, writes: 0, pixels: 0 };
    let mut dithered = Dithered::new(&mut target, levels);
    let Ok(()) = dithered.fill_ramp(row, 0..pixels, ramp(ends[0], ends[1], pixels));
    target
}

#[test]
fn a_run_over_all_shades_is_some_fills() {
    for row in 0..8 {
        for pixels in [64, 100, 1_000, 4_000] {
            for ends in [[0, 65_535], [65_535, 0], [30_000, 31_000], [40_000, 40_000]] {
                let one_bit = counted(Levels::ONE_BIT, ends, pixels, row);
                // Four thresholds in a row of 4 × 4, and both ends.
                assert!(one_bit.fills <= 4 + 2 && one_bit.writes == 0, "{}: {ends:?}", one_bit.fills);
                assert_eq!(one_bit.pixels, usize::try_from(pixels).expect("positive"), "each pixel once");
                let four_bits = counted(Levels::LINEAR_16, ends, pixels, row);
                // Four from each level to the next, unless there are so many that fills would be shorter than 9 pixels.
                let switches = 4 * i32::from(ends[0].abs_diff(ends[1])) / (65_535 / 15);
                let most = if pixels < 9 * switches { (0, 1) } else { (15 * 5 + 1, 0) };
                assert!(four_bits.fills <= most.0, "{}: {ends:?}", four_bits.fills);
                assert_eq!(four_bits.writes, most.1, "{ends:?}");
                assert_eq!(four_bits.pixels, one_bit.pixels);
            }
        }
    }
    // Level light is one fill, however long.
    assert_eq!(counted(Levels::ONE_BIT, [40_000, 40_000], 4_000, 1).fills, 1);
}

/// Over the 17 shades that an area has, in any row of an 8 × 8 mask.
#[test]
fn no_row_of_a_larger_mask_needs_more_than_its_thresholds() {
    for row in 0..8 {
        let mut target = Counting { bounds: Rect::new(0, 0, 4_000, 8), fills: 0, writes: 0, pixels: 0 };
        let mut dithered = Dithered::new(&mut target, Levels::ONE_BIT).with_method(&BAYER_8X8);
        let Ok(()) = dithered.fill_ramp(row, 0..4_000, ramp(0, 65_535, 4_000));
        assert!(target.fills <= 8 + 2 && target.writes == 0, "{}", target.fills);
    }
}
