//! Things that can be drawn, at random, on a frame and on its reference.

use core::{convert::Infallible, ops::Range};

use aquatint::{Code, Target};
use embedded_graphics::{
    Pixel,
    draw_target::DrawTarget,
    geometry::{Point, Size},
    pixelcolor::PixelColor,
    primitives::Rectangle,
};
use proptest::{collection::vec, option, prelude::*, sample::select};

use super::Reference;

/// One thing drawn; colours are codes, of which a colour takes the lower bits.
#[derive(Clone, Debug)]
pub enum Step {
    Clear(u8),
    FillSolid(Rectangle, u8),
    /// An area, and how many colours there are for it.
    FillContiguous(Rectangle, u64),
    DrawIter(Vec<(Point, u8)>),
    /// Colours that repeat.
    FillRun(i32, Range<i32>, Vec<u8>),
    WriteRun(i32, Range<i32>, Vec<Option<u8>>),
}

/// Any of them, small ones near the origin and some that reach as far as numbers do.
pub fn step() -> impl Strategy<Value = Step> {
    prop_oneof![
        1 => any::<u8>().prop_map(Step::Clear),
        4 => (area(), any::<u8>()).prop_map(|(area, code)| Step::FillSolid(area, code)),
        4 => (area(), colors()).prop_map(|(area, number)| Step::FillContiguous(area, number)),
        4 => vec((point(), any::<u8>()), 0..20).prop_map(Step::DrawIter),
        4 => run_step(),
    ]
}

/// Runs alone.
pub fn run_step() -> impl Strategy<Value = Step> {
    prop_oneof![
        (place(), run(), repeating()).prop_map(|(row, columns, codes)| Step::FillRun(row, columns, codes)),
        (place(), run(), vec(option::of(any::<u8>()), 0..70))
            .prop_map(|(row, columns, codes)| Step::WriteRun(row, columns, codes)),
    ]
}

fn repeating() -> impl Strategy<Value = Vec<u8>> {
    select(vec![1_usize, 3, 4, 8]).prop_flat_map(|length| vec(any::<u8>(), length))
}

fn place() -> impl Strategy<Value = i32> {
    prop_oneof![9 => -12..45_i32, 1 => select(vec![i32::MIN, i32::MIN + 1, -70_000, i32::MAX - 1, i32::MAX])]
}

fn length() -> impl Strategy<Value = u32> {
    prop_oneof![9 => 0..60_u32, 1 => select(vec![70_000, u32::MAX / 2, 1 << 31, u32::MAX - 1, u32::MAX])]
}

fn point() -> impl Strategy<Value = Point> {
    (place(), place()).prop_map(|(x, y)| Point::new(x, y))
}

fn area() -> impl Strategy<Value = Rectangle> {
    (point(), length(), length()).prop_map(|(corner, width, height)| Rectangle::new(corner, Size::new(width, height)))
}

fn run() -> impl Strategy<Value = Range<i32>> {
    (place(), place()).prop_map(|(start, end)| start..end)
}

/// Too few, or more than anything takes.
fn colors() -> impl Strategy<Value = u64> {
    prop_oneof![0..900_u64, Just(u64::MAX)]
}

/// Different colours, of which any number can be left out at no cost.
struct Numbered<C> {
    numbers: Range<u64>,
    color: fn(u8) -> C,
}

fn code_number(number: u64) -> u8 {
    number.wrapping_mul(0x9E37_79B9_7F4A_7C15).to_be_bytes()[0]
}

impl<C> Iterator for Numbered<C> {
    type Item = C;

    fn next(&mut self) -> Option<C> {
        self.nth(0)
    }

    fn nth(&mut self, number: usize) -> Option<C> {
        self.numbers.nth(number).map(code_number).map(self.color)
    }
}

impl Step {
    pub fn draw<C: Code, T>(&self, target: &mut T)
    where
        T: Target<Color = C, Error = Infallible> + DrawTarget<Color = C, Error = Infallible>,
    {
        self.draw_in(target, C::from_code);
    }

    /// The same in the colours that a function gives for the codes.
    pub fn draw_in<C: PixelColor, T>(&self, target: &mut T, color: fn(u8) -> C)
    where
        T: Target<Color = C, Error = Infallible> + DrawTarget<Color = C, Error = Infallible>,
    {
        let Ok(()) = match self {
            Self::Clear(code) => target.clear(color(*code)),
            Self::FillSolid(area, code) => target.fill_solid(area, color(*code)),
            Self::FillContiguous(area, number) => target.fill_contiguous(area, Numbered { numbers: 0..*number, color }),
            Self::DrawIter(pixels) => target.draw_iter(pixels.iter().map(|&(at, code)| Pixel(at, color(code)))),
            Self::FillRun(..) | Self::WriteRun(..) => {
                self.draw_run_in(target, color);
                Ok(())
            }
        };
    }

    /// Draws a run; nothing else.
    pub fn draw_run<C: Code>(&self, target: &mut impl Target<Color = C, Error = Infallible>) {
        self.draw_run_in(target, C::from_code);
    }

    /// The same in the colours that a function gives for the codes.
    pub fn draw_run_in<C>(&self, target: &mut impl Target<Color = C, Error = Infallible>, color: fn(u8) -> C)
    where
        C: PixelColor,
    {
        let Ok(()) = match self {
            Self::FillRun(row, columns, codes) => {
                let colors: Vec<_> = codes.iter().copied().map(color).collect();
                fill_run(target, (*row, columns.clone()), &colors)
            }
            Self::WriteRun(row, columns, codes) => {
                target.write_run(*row, columns.clone(), codes.iter().map(|code| code.map(color)))
            }
            _ => Ok(()),
        };
    }

    /// What the step makes of each pixel, by what the words of the interfaces say.
    pub fn draw_slowly<C: Code>(&self, reference: &mut Reference<C>) {
        self.draw_slowly_in(reference, C::from_code);
    }

    /// The same in the colours that a function gives for the codes.
    pub fn draw_slowly_in<C: PixelColor>(&self, reference: &mut Reference<C>, color: fn(u8) -> C) {
        reference.draw(|x, y| self.code_at(x, y).map(color));
    }

    fn code_at(&self, x: i32, y: i32) -> Option<u8> {
        match self {
            Self::Clear(code) => Some(*code),
            Self::FillSolid(area, code) => index(area, x, y).map(|_| *code),
            Self::FillContiguous(area, number) => index(area, x, y).filter(|index| index < number).map(code_number),
            Self::DrawIter(pixels) => pixels.iter().rfind(|(at, _)| *at == Point::new(x, y)).map(|(_, code)| *code),
            Self::FillRun(row, columns, codes) => {
                let index = x.checked_rem_euclid(i32::try_from(codes.len()).ok()?)?;
                codes.get(usize::try_from(index).ok()?).copied().filter(|_| *row == y && columns.contains(&x))
            }
            Self::WriteRun(row, columns, codes) => {
                let offset = usize::try_from(i64::from(x) - i64::from(columns.start)).ok()?;
                codes.get(offset).copied().flatten().filter(|_| *row == y && columns.contains(&x))
            }
        }
    }
}

/// Fills a run with colours that repeat; how many there are is known when compiling. (`tests/inks.rs` has more numbers.)
fn fill_run<C: PixelColor>(
    target: &mut impl Target<Color = C, Error = Infallible>,
    (row, columns): (i32, Range<i32>),
    colors: &[C],
) -> Result<(), Infallible> {
    macro_rules! of_length {
        ($($length:literal)*) => {
            match colors.len() {
                $($length => target.fill_run::<$length>(row, columns, colors.try_into().expect("of this length")),)*
                other => panic!("{other} colours"),
            }
        };
    }
    of_length!(1 3 4 8)
}

/// The place of a pixel among those of an area, row by row.
///
/// Columns that would lie beyond `i32` do not exist and take no colour, as in `Rectangle::points`.
fn index(area: &Rectangle, x: i32, y: i32) -> Option<u64> {
    let (left, top) = (i64::from(area.top_left.x), i64::from(area.top_left.y));
    let right = (left + i64::from(area.size.width)).min(i32::MAX.into());
    let bottom = top + i64::from(area.size.height);
    let (x, y) = (i64::from(x), i64::from(y));
    let inside = (left..right).contains(&x) && (top..bottom).contains(&y);
    inside.then(|| (y - top).unsigned_abs() * (right - left).unsigned_abs() + (x - left).unsigned_abs())
}
