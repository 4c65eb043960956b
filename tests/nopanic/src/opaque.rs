//! Values of which the compiler knows nothing, and a panic handler that cannot be linked.

use core::{hint::black_box, panic::PanicInfo};

use aquatint::{
    Affine, Angle, Clip, Coverage, Light, Matrix, Point2, Rect, Scalar, Subpixel, View, World, tone::xyz::Tristimulus,
};
use embedded_graphics::{
    geometry::{Point, Size},
    primitives::Rectangle,
};

use crate::{Any, AnyRows, any};

/// Whoever may panic calls this, which no one defines.
#[cfg(not(feature = "report"))]
unsafe extern "C" {
    safe fn aquatint_panics_here() -> !;
}

/// Defined where the callers are to be listed.
#[cfg(feature = "report")]
#[unsafe(no_mangle)]
#[inline(never)]
extern "C" fn aquatint_panics_here() -> ! {
    loop {
        black_box(());
    }
}

#[panic_handler]
fn panic(_: &PanicInfo) -> ! {
    aquatint_panics_here()
}

/// Calls an entry.
#[inline(always)]
pub fn call<M>(_: &str, entry: impl Fn(&mut M), memory: &mut M, _: u32) {
    entry(black_box(memory));
}

/// After the last entry.
pub fn end() -> ! {
    loop {}
}

macro_rules! any {
    ($($kind:ty = $value:expr),* $(,)?) => { $(
        impl Any for $kind {
            #[inline(always)]
            fn any() -> Self {
                black_box($value)
            }
        }
    )* };
}

any!(
    bool = false,
    char = 'a',
    i8 = 0,
    u8 = 0,
    i16 = 0,
    u16 = 0,
    i32 = 0,
    u32 = 0,
    i64 = 0,
    u64 = 0,
    usize = 0,
    Affine = Affine::IDENTITY,
    Angle = Angle(0),
    Coverage = Coverage::NONE,
    Light = Light::BLACK,
    Point = Point::zero(),
    Point2 = Point2::corner(0, 0),
    Rect = Rect::new(0, 0, 0, 0),
    Rectangle = Rectangle::zero(),
    Scalar = Scalar::ZERO,
    Size = Size::zero(),
    Subpixel = Subpixel::ZERO,
    Tristimulus = Tristimulus::ZERO,
);

impl AnyRows for () {
    #[inline(always)]
    fn any_rows() -> [[Scalar; 4]; 4] {
        any()
    }
}

/// Any view, and any lens.
#[inline(always)]
pub fn view_and_lens() -> (Matrix<World, View>, Matrix<View, Clip>) {
    any()
}

/// Memory of any length.
#[inline(always)]
pub fn lent<T>(memory: &mut [T]) -> &mut [T] {
    black_box(memory)
}

/// A slice of any length.
#[inline(always)]
pub fn part<T>(of: &[T]) -> &[T] {
    black_box(of)
}

/// Any number of any values, kept in `memory`.
#[inline(always)]
pub fn some<T: Any>(memory: &mut [T]) -> &[T] {
    black_box(memory)
}

/// Any width or height of a frame.
#[inline(always)]
pub fn side() -> u32 {
    any()
}

/// Any bounds of a sink.
#[inline(always)]
pub fn window() -> Rect {
    any()
}

/// Any text.
#[inline(always)]
pub fn text() -> &'static str {
    black_box("")
}

/// Any of these.
#[inline(always)]
pub fn one_of<T: Copy, const N: usize>(choices: &[T; N]) -> T {
    const { assert!(N > 0) };
    black_box(choices)[0]
}
