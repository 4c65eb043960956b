//! What a blit must know of two layouts to choose its way.

use crate::{
    display::layout::{Columns, Inverted, Memory, Order, Pages, Planes, Rows, Words},
    num::low_index,
};

/// Layouts between which pictures are moved: all that there are.
pub trait Packing: sealed::Sealed {
    #[doc(hidden)]
    const FACTS: Facts;
}

/// What a layout does with bits.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Facts {
    along: Along,
    msb_first: bool,
    pub(super) is_inverted: bool,
}

/// What a line of bytes runs along.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum Along {
    Rows,
    Columns,
    Pages,
    Planes,
    Words,
}

impl Facts {
    const fn new<O: Order>(along: Along) -> Self {
        Self { along, msb_first: O::MSB_FIRST, is_inverted: false }
    }

    /// A pixel of one bit.
    pub(super) fn is_on(self, memory: Memory<&[u8]>, column: usize, row: usize) -> bool {
        let (line, byte, place) = match self.along {
            Along::Columns => (column, row / 8, row),
            Along::Pages => (row / 8, column, row),
            Along::Rows | Along::Planes | Along::Words => (row, column / 8, column),
        };
        let place = low_index(place) % 8;
        let bit = if self.msb_first { 0x80 >> place } else { 1 << place };
        let byte = memory.bytes.get(line.saturating_mul(memory.stride).saturating_add(byte));
        byte.is_some_and(|byte| (byte & bit != 0) != self.is_inverted)
    }
}

/// How pixels get from one layout into another.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Way {
    /// Lines of both run along rows, in the same order of bits.
    Rows { msb_first: bool },
    /// Along columns.
    Columns { msb_first: bool },
    /// Both are pages.
    Pages { msb_first: bool },
    /// Rows become pages.
    Transposed { rows_msb_first: bool, pages_msb_first: bool },
    /// One at a time.
    Pixels,
}

impl Way {
    pub(super) const fn new(target: Facts, source: Facts) -> Self {
        let (msb_first, is_same) = (target.msb_first, target.msb_first == source.msb_first);
        match (target.along, source.along) {
            (Along::Rows, Along::Rows) | (Along::Words, Along::Words) if is_same => Self::Rows { msb_first },
            (Along::Columns, Along::Columns) if is_same => Self::Columns { msb_first },
            (Along::Pages, Along::Pages) if is_same => Self::Pages { msb_first },
            (Along::Pages, Along::Rows) => {
                Self::Transposed { rows_msb_first: source.msb_first, pages_msb_first: target.msb_first }
            }
            _ => Self::Pixels,
        }
    }
}

mod sealed {
    pub trait Sealed {}
}

macro_rules! packing {
    ($($layout:ident),*) => { $(
        impl<O: Order> sealed::Sealed for $layout<O> {}
        impl<O: Order> Packing for $layout<O> {
            const FACTS: Facts = Facts::new::<O>(Along::$layout);
        }
    )* };
}

packing!(Rows, Columns, Pages, Planes, Words);

impl<L: Packing> sealed::Sealed for Inverted<L> {}
impl<L: Packing> Packing for Inverted<L> {
    const FACTS: Facts = Facts { is_inverted: !L::FACTS.is_inverted, ..L::FACTS };
}
