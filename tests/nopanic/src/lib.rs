//! Arguments of which the compiler knows nothing, and a panic handler that cannot be linked.
//!
//! Each program in `bin` calls the public functions of one stage with such arguments. None is ever run: that it can be
//! linked proves that no call can panic, whatever is passed to it.
#![no_std]

use core::{hint::black_box, panic::PanicInfo};

use aquatint::{
    Affine, Angle, Coverage, Light, Matrix, Point2, Point3, Point4, Rect, Scalar, Subpixel, Vector3,
    tone::xyz::Tristimulus,
};
use embedded_graphics::{
    geometry::{Point, Size},
    primitives::Rectangle,
};

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

/// What can be made of nothing that the compiler knows.
pub trait Any {
    /// Any value.
    fn any() -> Self;
}

/// Any value, as far as the compiler knows.
#[inline(always)]
pub fn any<T: Any>() -> T {
    T::any()
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

impl<T: Any, const N: usize> Any for [T; N] {
    #[inline(always)]
    fn any() -> Self {
        [(); N].map(|()| T::any())
    }
}

impl<A: Any, B: Any> Any for (A, B) {
    #[inline(always)]
    fn any() -> Self {
        (A::any(), B::any())
    }
}

macro_rules! any_in_space {
    ($($kind:ident($($part:ident),*)),*) => { $(
        impl<S> Any for $kind<S> {
            #[inline(always)]
            fn any() -> Self {
                $(let $part = any();)*
                Self::new($($part),*)
            }
        }
    )* };
}

any_in_space!(Point3(x, y, z), Vector3(x, y, z), Point4(x, y, z, w));

impl<A, B> Any for Matrix<A, B> {
    fn any() -> Self {
        Self::from_rows(any())
    }
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

/// Any text.
#[inline(always)]
pub fn text() -> &'static str {
    black_box("")
}

/// Keeps the compiler from leaving out what nobody asked for.
#[inline(always)]
pub fn keep<T>(value: T) {
    black_box(&value);
}
