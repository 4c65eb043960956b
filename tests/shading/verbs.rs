//! What frames do in their own way is what the default methods of `Target` do: `write_bits`, `write_all` and `set`, on all
//! layouts; and `write_all` of a dithered target is `write_run`.

use core::{convert::Infallible, ops::Range};

use aquatint::{
    BAYER_8X8, BLUE_NOISE_64, Code, Columns, Dithered, Frame, Inverted, Levels, Light, LsbFirst, MsbFirst,
    OnDrawTarget, Pages, Planes, R2Noise, Rect, Rows, Target, Window,
    display::{
        dither::{Mask, Method},
        layout::Layout,
    },
};
use embedded_graphics::pixelcolor::{BinaryColor, Gray2, Gray4, Gray8};
use proptest::prelude::*;

pub const WIDTH: u32 = 61;
pub const HEIGHT: u32 = 19;

/// A target that does only what it must.
pub struct Least<'t, T>(pub &'t mut T);

impl<T: Target> Target for Least<'_, T> {
    type Color = T::Color;
    type Error = T::Error;

    fn bounds(&self) -> Rect {
        self.0.bounds()
    }

    fn fill_run<const N: usize>(
        &mut self,
        row: i32,
        columns: Range<i32>,
        colors: [T::Color; N],
    ) -> Result<(), T::Error> {
        self.0.fill_run(row, columns, colors)
    }

    fn write_run(
        &mut self,
        row: i32,
        columns: Range<i32>,
        colors: impl Iterator<Item = Option<T::Color>>,
    ) -> Result<(), T::Error> {
        self.0.write_run(row, columns, colors)
    }
}

/// Draws on a frame with bits in it already: itself, a part of it, a band, as another's display. Gives all its bytes.
pub fn on_target<C: Code, L: Layout<C>>(way: u8, draw: &impl Draw<C>) -> Vec<u8> {
    let mut bytes = vec![0; Frame::<C, L, ()>::bytes_needed(WIDTH, HEIGHT)];
    for (at, byte) in (0_u32..).zip(&mut bytes) {
        *byte = at.wrapping_mul(2_654_435_769).to_be_bytes()[0];
    }
    let mut frame = Frame::<C, L, _>::new(bytes, WIDTH, HEIGHT).expect("large enough");
    match way {
        0 => draw.on(&mut frame),
        1 => draw.on(&mut Window::part(&mut frame, Rect::new(3, 2, 53, 16))),
        2 => draw.on(&mut Window::band(&mut frame, -5)),
        _ => draw.on(&mut OnDrawTarget::new(&mut frame)),
    }
    frame.memory().to_vec()
}

/// What is drawn, on a target of any kind.
pub trait Draw<C> {
    fn on<T: Target<Color = C, Error = Infallible>>(&self, target: &mut T);
}

/// Calls a function for every layout of every depth, and for every way to draw on it.
#[macro_export]
macro_rules! on_all_targets {
    ($check:ident, $all:expr) => {
        for way in 0..4 {
            $check::<BinaryColor, Rows<MsbFirst>>($all, way);
            $check::<BinaryColor, Rows<LsbFirst>>($all, way);
            $check::<BinaryColor, Inverted<Rows>>($all, way);
            $check::<BinaryColor, Pages>($all, way);
            $check::<BinaryColor, Inverted<Pages>>($all, way);
            $check::<BinaryColor, Columns>($all, way);
            $check::<Gray2, Rows<MsbFirst>>($all, way);
            $check::<Gray2, Rows<LsbFirst>>($all, way);
            $check::<Gray2, Planes>($all, way);
            $check::<Gray4, Rows>($all, way);
            $check::<Gray4, Inverted<Rows<LsbFirst>>>($all, way);
            $check::<Gray8, Rows>($all, way);
        }
    };
}

/// Some verbs; with only the defaults if `least`.
#[derive(Clone, Debug)]
struct Verbs {
    row: i32,
    columns: Range<i32>,
    bytes: Vec<u8>,
    verb: u8,
}

struct Drawn<'v> {
    verbs: &'v [Verbs],
    least: bool,
}

impl Verbs {
    fn on<T: Target<Error = Infallible>>(&self, target: &mut T)
    where
        T::Color: Code,
    {
        let Self { row, columns, bytes, verb } = self;
        let mut bytes = bytes.iter().copied().cycle();
        let mut next = || bytes.next().expect("one at least");
        let Ok(()) = match verb {
            0 => target.write_bits(
                *row,
                columns.clone(),
                [T::Color::from_code(next()), T::Color::from_code(next())],
                next,
            ),
            1 => target.write_all(*row, columns.clone(), core::iter::repeat_with(|| T::Color::from_code(next()))),
            _ => target.set(*row, columns.start, T::Color::from_code(next())),
        };
    }
}

impl<C: Code> Draw<C> for Drawn<'_> {
    fn on<T: Target<Color = C, Error = Infallible>>(&self, target: &mut T) {
        for verbs in self.verbs {
            if self.least { verbs.on(&mut Least(target)) } else { verbs.on(target) }
        }
    }
}

fn check_verbs<C: Code, L: Layout<C>>(verbs: &[Verbs], way: u8) {
    let [own, least] = [false, true].map(|least| on_target::<C, L>(way, &Drawn { verbs, least }));
    assert_eq!(own, least, "{}, way {way}: {verbs:?}", core::any::type_name::<L>());
}

pub fn run() -> impl Strategy<Value = (i32, Range<i32>)> {
    let length = prop_oneof![0..10_i32, 0..100_i32, 40..70_i32];
    (-6..22_i32, -40..70_i32, length).prop_map(|(row, start, length)| (row, start..start + length))
}

fn verbs() -> impl Strategy<Value = Verbs> {
    (run(), prop::collection::vec(any::<u8>(), 1..9), 0..3_u8).prop_map(|((row, columns), bytes, verb)| Verbs {
        row,
        columns,
        bytes,
        verb,
    })
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(400))]
    #[test]
    fn frames_write_as_the_defaults_do(all in prop::collection::vec(verbs(), 1..5)) {
        on_all_targets!(check_verbs, &all);
    }
}

/// Lights to every pixel of some runs, on one dithered target, whose memory of the last step goes on.
struct Lights<'v, M> {
    runs: &'v [(i32, Range<i32>, Vec<u16>)],
    mask: M,
    levels: Levels<'v>,
    all: bool,
}

impl<C: Code, M: Mask + Copy> Draw<C> for Lights<'_, M> {
    fn on<T: Target<Color = C, Error = Infallible>>(&self, target: &mut T) {
        let mut dithered = Dithered::new(target, self.levels).with_method(self.mask);
        for (row, columns, lights) in self.runs {
            let lights = lights.iter().copied().map(Light).cycle();
            let Ok(()) = if self.all {
                dithered.write_all(*row, columns.clone(), lights)
            } else {
                dithered.write_run(*row, columns.clone(), lights.map(Some))
            };
        }
    }
}

/// Rows, columns and the lights there.
type Runs = [(i32, Range<i32>, Vec<u16>)];

fn check_lights<C: Code, L: Layout<C>, M: Mask + Copy>((runs, mask, levels): (&Runs, M, Levels<'_>), way: u8) {
    let [all, run] = [true, false].map(|all| on_target::<C, L>(way, &Lights { runs, mask, levels, all }));
    assert_eq!(all, run, "{}, way {way}: {runs:?}", core::any::type_name::<L>());
}

/// What Levels there are for few codes.
const UNEVEN: [&[u16]; 3] = [&[5_000, 60_000], &[0, 1], &[100, 20_000, 20_001, 65_000]];

proptest! {
    #![proptest_config(ProptestConfig::with_cases(400))]
    #[test]
    fn all_lights_are_dithered_as_a_run(
        runs in prop::collection::vec(
            (run(), prop::collection::vec(prop_oneof![any::<u16>(), Just(0), Just(u16::MAX)], 1..80)), 1..4
        ),
    ) {
        let runs: Vec<_> = runs.into_iter().map(|((row, columns), lights)| (row, columns, lights)).collect();
        let levels = [Levels::ONE_BIT, Levels::LINEAR_4].into_iter();
        for levels in levels.chain(UNEVEN.map(|lights| Levels::new(lights).expect("rising"))) {
            for way in 0..4 {
                check_lights::<BinaryColor, Rows, _>((&runs, Method::Ordered4x4, levels), way);
                check_lights::<BinaryColor, Rows<LsbFirst>, _>((&runs, &BAYER_8X8, levels), way);
                check_lights::<BinaryColor, Pages, _>((&runs, &BLUE_NOISE_64, levels), way);
                check_lights::<BinaryColor, Columns, _>((&runs, Method::Nearest, levels), way);
                check_lights::<Gray2, Planes, _>((&runs, R2Noise, levels), way);
                check_lights::<Gray4, Rows, _>((&runs, Method::Ordered4x4, levels), way);
            }
        }
    }
}
