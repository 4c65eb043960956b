//! One range error for all stages, and the sentences that errors say.
//!
//! An error is small and is born where it can be handled. There is no error of the whole crate.

/// Gives an error type its text and makes it an [`Error`](core::error::Error).
macro_rules! describe {
    ($error:ty, $($pattern:pat => $($text:expr),+;)+) => {
        impl core::fmt::Display for $error {
            fn fmt(&self, f: &mut core::fmt::Formatter<'_>) -> core::fmt::Result {
                match self {
                    $($pattern => write!(f, $($text),+),)+
                }
            }
        }

        impl core::error::Error for $error {}
    };
}

pub(crate) use describe;

/// A coordinate is too far from zero to be computed with exactly. Nothing was drawn.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct OutOfRange;

describe! { OutOfRange, Self => "a coordinate is out of range"; }
