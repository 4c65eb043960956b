//! Arguments of which the compiler knows nothing, or hostile ones, and what the programs in `bin` are made of.
//!
//! Each program calls the public entry points of one stage, and is used in two ways:
//!
//! - `.ci/nopanic` links it. The panic handler cannot be linked, so that it links proves that no call can panic,
//!   whatever is passed to it. It is not run.
//! - `.ci/stacks` builds it with the feature `run` and runs it on the emulated board. Each entry point is called many
//!   times with hostile arguments, and what it used of the stack is printed.
//!
//! An entry is a function that makes arguments and calls one entry point of the library, or some that belong
//! together. Whatever the caller of the library lends comes from the program's `Memory`, so that the stack that is
//! measured is that of the call.
#![no_std]

#[cfg(feature = "run")]
#[path = "../../../examples/board/mod.rs"]
mod board;
mod endless;
#[cfg(feature = "run")]
mod hostile;
#[cfg(not(feature = "run"))]
mod opaque;
#[cfg(feature = "run")]
mod run;
pub mod scenes;
pub mod shapes;

use core::{hint::black_box, ops::Range};

use aquatint::{Matrix, Point3, Point4, Scalar, Vector3};
use embedded_graphics::{
    geometry::{Point, Size},
    primitives::Rectangle,
};

pub use endless::{Endless, endless};
#[cfg(feature = "run")]
pub use hostile::{lent, one_of, part, side, some, text, view_and_lens, window};
#[cfg(not(feature = "run"))]
pub use opaque::{call, end, lent, one_of, part, side, some, text, view_and_lens, window};
#[cfg(feature = "run")]
pub use run::{call, end};

/// The program: its memory as it begins, and its entries in the order of the table.
///
/// An entry is a function that takes `&mut Memory`, or has a name of its own: `frame_rows = frame::<Rows>`.
/// `.ci/stackbound.py` finds it as `entries::NAME::entry`. Each is called 300 times when the program is run, or as often
/// as is said after the memory.
#[macro_export]
macro_rules! entries {
    (@ $name:ident) => { $name };
    (@ $name:ident $function:expr) => { $function };
    ($memory:expr; $($entries:tt)*) => { $crate::entries! { $memory, 300; $($entries)* } };
    ($memory:expr, $rounds:expr; $($name:ident $(= $function:expr)?),* $(,)?) => {
        mod entries { $(
            pub mod $name {
                #[allow(unused_imports, reason = "a program may import what its other entries need")]
                use super::super::*;

                #[inline(never)]
                pub fn entry(memory: &mut Memory) {
                    ($crate::entries!(@ $name $($function)?))(memory);
                }
            }
        )* }

        #[cortex_m_rt::entry]
        fn main() -> ! {
            static mut LENT: Memory = $memory;
            $($crate::call(stringify!($name), entries::$name::entry, LENT, $rounds);)*
            $crate::end()
        }
    };
}

/// What can be made of nothing that the compiler knows.
pub trait Any {
    /// Any value.
    fn any() -> Self;
}

/// Any value: opaque to the compiler, or hostile.
#[inline(always)]
pub fn any<T: Any>() -> T {
    T::any()
}

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

/// The rows of any matrix.
trait AnyRows {
    fn any_rows() -> [[Scalar; 4]; 4];
}

impl<A, B> Any for Matrix<A, B> {
    #[inline(always)]
    fn any() -> Self {
        Self::from_rows(<() as AnyRows>::any_rows())
    }
}

/// Any columns that do not reach very far out of the picture.
///
/// Who gives a colour for each pixel gives those beside the picture, too, and that takes time.
#[inline(always)]
pub fn near() -> Range<i32> {
    any::<i32>().max(-4000)..any::<i32>().min(4000)
}

/// Any place and size, in which points can be counted through.
#[inline(always)]
pub fn near_rectangle() -> Rectangle {
    let [x, y] = any::<[i8; 2]>().map(i32::from);
    Rectangle::new(Point::new(x, y), Size::new(any::<u8>().into(), any::<u8>().into()))
}

/// Keeps the compiler from leaving out what nobody asked for.
#[inline(always)]
pub fn keep<T>(value: T) {
    black_box(&value);
}
