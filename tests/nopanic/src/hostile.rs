//! Values as a reckless caller passes them, from a generator of random numbers: the same in every run.
//!
//! Rounds differ in how wild they are. In a tame round all values make sense, so that things are drawn; in the wildest
//! none needs to.

use core::sync::atomic::{AtomicU32, Ordering};

use aquatint::{
    Affine, Angle, Clip, Coverage, Light, Matrix, Point2, Rect, Scalar, Subpixel, View, World, tone::xyz::Tristimulus,
};
use embedded_graphics::{
    geometry::{Point, Size},
    primitives::Rectangle,
};

use crate::{Any, AnyRows, any};

/// How many of 256 values are wild, round by round.
const WILDNESS: [u32; 5] = [0, 4, 0, 32, 200];

static STATE: AtomicU32 = AtomicU32::new(1);
static WILD: AtomicU32 = AtomicU32::new(0);

/// Begins a round; its values depend on its number alone.
pub fn begin(round: u32) {
    STATE.store(round.wrapping_add(1).wrapping_mul(0x9E37_79B9) | 1, Ordering::Relaxed);
    WILD.store(WILDNESS[round as usize % WILDNESS.len()], Ordering::Relaxed);
}

/// 32 random bits: Marsaglia's xorshift. The high ones are the better ones.
#[inline(never)]
fn word() -> u32 {
    let mut state = STATE.load(Ordering::Relaxed);
    state ^= state << 13;
    state ^= state >> 17;
    state ^= state << 5;
    STATE.store(state, Ordering::Relaxed);
    state.wrapping_mul(0x2545_F491)
}

/// A random number below `end`, which is at most 2^16.
fn below(end: u32) -> u32 {
    ((word() >> 16) * end) >> 16
}

fn is_wild() -> bool {
    word() >> 24 < WILD.load(Ordering::Relaxed)
}

/// What is likeliest to break something.
#[inline(never)]
fn wild() -> i32 {
    match below(8) {
        0 => 0,
        1 => 1,
        2 => -1,
        3 => i32::MIN,
        4 => i32::MAX,
        5 => below(100).cast_signed() - 30,
        6 => (1_i32 << below(32)).wrapping_add(below(3).cast_signed() - 1),
        _ => word().cast_signed(),
    }
}

/// A number from `from` on and below `to`, or a wild one.
#[inline(never)]
fn number(from: i32, to: i32) -> i32 {
    if is_wild() { wild() } else { from + below((to - from).cast_unsigned()).cast_signed() }
}

/// A number of some pixels from the origin, in sixteenths.
fn subpixel(from: i32, to: i32) -> Subpixel {
    Subpixel::from_bits(number(from * 16, to * 16))
}

/// Often a whole number.
#[inline(never)]
fn scalar() -> Scalar {
    let value = number(-2 << 14, 2 << 14) << 2;
    Scalar::from_bits(if below(4) == 0 { value & !0xFFFF } else { value })
}

#[inline(never)]
fn wide() -> i64 {
    i64::from(number(-8, 56)) << if is_wild() { below(33) } else { 0 }
}

macro_rules! any {
    ($($kind:ty = $value:expr),* $(,)?) => { $(
        impl Any for $kind {
            #[inline(never)]
            fn any() -> Self {
                $value
            }
        }
    )* };
}

any!(
    bool = below(2) == 0,
    char = if is_wild() {
        char::from_u32(below(0x1_0000) << below(6)).unwrap_or('\0')
    } else {
        char::from(32 + below(96) as u8)
    },
    i8 = word() as i8,
    u8 = if below(2) == 0 { word() as u8 } else { number(0, 9) as u8 },
    i16 = number(-20_000, 20_000) as i16,
    u16 = number(0, 8) as u16,
    i32 = number(-8, 56),
    u32 = number(0, 48).cast_unsigned(),
    i64 = wide(),
    u64 = wide().cast_unsigned(),
    usize = number(0, 24) as usize,
    Affine = Affine::new([scalar(), scalar()], [scalar(), scalar()], any()),
    Angle = Angle(word() as u16),
    Coverage = Coverage::new(word() as u16),
    Light = Light(word() as u16),
    Point = Point::new(number(-8, 56), number(-8, 40)),
    Point2 = Point2::new(subpixel(-8, 56), subpixel(-8, 40)),
    Rect = Rect::new(number(-8, 12), number(-8, 12), number(8, 48), number(8, 40)),
    Rectangle = Rectangle::new(any(), any()),
    Scalar = scalar(),
    Size = Size::new(any(), any()),
    Subpixel = subpixel(0, 24),
    Tristimulus = Tristimulus::from_bits(number(-50, 6000)),
);

/// Of things a scene is made of: two placements, two views and a lens for each of them.
#[rustfmt::skip]
static ROWS: [[[i32; 4]; 4]; 6] = [
    [[65_536, 0, 0, 0], [0, 65_536, 0, 0], [0, 0, 65_536, 0], [0, 0, 0, 65_536]],
    [[52_429, 0, 39_322, 6_000], [0, 65_536, 0, -9_000], [-39_322, 0, 52_429, 20_000], [0, 0, 0, 65_536]],
    [[65_536, 0, 0, 0], [0, 52_429, 39_322, 0], [0, -39_322, 52_429, -200_000], [0, 0, 0, 65_536]],
    [[52_429, 0, 39_322, 0], [0, 65_536, 0, 0], [-39_322, 0, 52_429, 200_000], [0, 0, 0, 65_536]],
    [[65_536, 0, 0, 0], [0, 98_304, 0, 0], [0, 0, -78_643, -144_179], [0, 0, -65_536, 0]],
    [[65_536, 0, 0, 0], [0, 98_304, 0, 0], [0, 0, 78_643, -144_179], [0, 0, 65_536, 0]],
];

/// Those of one of the matrices, now and then with other numbers in it.
#[inline(never)]
fn rows(which: u32) -> [[Scalar; 4]; 4] {
    let rows = if is_wild() { &[[0x7FFF_FFFF; 4]; 4] } else { &ROWS[which as usize] };
    let noise = 1 << below(12);
    rows.map(|row| row.map(|value| if is_wild() { scalar() } else { Scalar::from_bits(value & -noise) }))
}

impl AnyRows for () {
    fn any_rows() -> [[Scalar; 4]; 4] {
        rows(if below(4) == 0 { below(6) } else { below(2) })
    }
}

/// A view and the lens for it.
pub fn view_and_lens() -> (Matrix<World, View>, Matrix<View, Clip>) {
    let which = below(2);
    (Matrix::from_rows(rows(2 + which)), Matrix::from_rows(rows(4 + which)))
}

/// Some of it, or all.
fn length(most: usize) -> usize {
    if is_wild() || below(8) == 0 { below(most as u32 + 1) as usize } else { most }
}

/// Memory of any length.
pub fn lent<T>(memory: &mut [T]) -> &mut [T] {
    let length = length(memory.len());
    memory.get_mut(..length).unwrap_or_default()
}

/// A slice of any length.
pub fn part<T>(of: &[T]) -> &[T] {
    of.get(..length(of.len())).unwrap_or_default()
}

/// Any number of any values, kept in `memory`.
#[inline(never)]
pub fn some<T: Any>(memory: &mut [T]) -> &[T] {
    for item in &mut *memory {
        *item = any();
    }
    part(memory)
}

/// Words, paths of SVG and glyphs of Hershey's, and what is none of these.
static TEXTS: [&str; 10] = [
    "",
    "Aquatint",
    "two\nlines, and \u{e9}\u{1f600}\n\n.",
    "M1 2L30 4 20 40z",
    "M0 0c10 20 30 40 5 6s1 2 3 4q1 1 2 2t3 3a5 6 30 1 0 20 20zh9v9l-4-4",
    "m1e9-1e9A1e-9 99999999 400 0 1 -.5.5.5z",
    "M 3 3 L 4 5 R 9",
    " 8MWRMNV RRMVV RPSTS",
    " 12H]RFRGNJ RT[YXZVZT",
    "~~~}}}|||\u{7f}  \t\t0123456789",
];

/// Width or height of a frame. One without width takes no memory, however high it is; it takes time to fill.
pub fn side() -> u32 {
    any::<u32>() & 0xFF
}

/// What a sink takes, which is as large as a picture may be.
pub fn window() -> Rect {
    let Rect { left, top, right, bottom } = any();
    Rect::new(left.max(-300), top.max(-300), right.min(300), bottom.min(300))
}

/// Any text.
#[inline(never)]
pub fn text() -> &'static str {
    let text = TEXTS[below(10) as usize];
    text.get(..length(text.len())).unwrap_or(text)
}

/// Any of these.
#[inline(never)]
pub fn one_of<T: Copy, const N: usize>(choices: &[T; N]) -> T {
    choices[below(N as u32) as usize]
}
