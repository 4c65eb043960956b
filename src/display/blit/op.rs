//! Raster operations on words.

use core::ops::{BitAnd, BitXor};

use embedded_graphics::pixelcolor::{PixelColor, raw::RawData};

use super::packing::Facts;
use crate::num::{low_index, low_u8};

/// A colour that is stored as a number: every colour of embedded-graphics.
pub trait Coded: PixelColor {
    /// Bits a pixel.
    const BITS: u32;

    /// The colour of a number; bits above [`BITS`](Self::BITS) are ignored.
    fn from_number(number: u32) -> Self;

    /// The number of this colour.
    fn number(self) -> u32;
}

impl<C> Coded for C
where
    C: PixelColor + From<C::Raw> + Into<C::Raw>,
    <C::Raw as RawData>::Storage: Into<u32>,
{
    const BITS: u32 = low_index(C::Raw::BITS_PER_PIXEL);

    fn from_number(number: u32) -> Self {
        C::Raw::from_u32(number).into()
    }

    fn number(self) -> u32 {
        self.into().into_inner().into()
    }
}

/// What becomes of a pixel of the target where one of the source falls on it, bit by bit of their codes.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub enum RasterOp {
    /// It is the source.
    Copy,
    /// Bits of the source are set.
    Or,
    /// Bits of the source are cleared.
    AndNot,
    /// Bits of the source are inverted. Drawn twice, it is gone.
    Xor,
}

impl RasterOp {
    /// The code that one becomes.
    pub(super) const fn apply(self, old: u32, new: u32) -> u32 {
        match self {
            Self::Copy => new,
            Self::Or => old | new,
            Self::AndNot => old & !new,
            Self::Xor => old ^ new,
        }
    }
}

/// An operation on stored bits, in words `W` of repeated bytes.
#[derive(Clone, Copy, Debug)]
pub(super) struct Op<W> {
    kind: Kind<W>,
    /// Bits of the source to be inverted first.
    flip: W,
}

#[derive(Clone, Copy, Debug)]
enum Kind<W> {
    Copy,
    /// Bits of the source take those of a colour: or and and-not are white and black.
    Paint(W),
    Xor,
}

impl Op<u8> {
    /// An inverted source is turned over on its way. On an inverted target a copy is turned over too,
    /// and what is painted has the other colour.
    #[inline]
    pub(super) fn new(op: RasterOp, target: Facts, source: Facts) -> Self {
        let (white, black) = if target.is_inverted { (0, 0xFF) } else { (0xFF, 0) };
        let kind = match op {
            RasterOp::Copy => Kind::Copy,
            RasterOp::Or => Kind::Paint(white),
            RasterOp::AndNot => Kind::Paint(black),
            RasterOp::Xor => Kind::Xor,
        };
        let is_flipped = source.is_inverted != (op == RasterOp::Copy && target.is_inverted);
        Self { kind, flip: if is_flipped { 0xFF } else { 0 } }
    }

    /// Bits of the source are painted in a colour of at most eight bits.
    #[inline]
    pub(super) fn paint<C: Coded>(color: C, target: Facts, source: Facts) -> Self {
        let bits = C::BITS.clamp(1, 8);
        // As often as it fits into a byte.
        let color = low_u8((color.number() & (0xFF >> (8 - bits))) * (0xFF / ((1 << bits) - 1)));
        let color = if target.is_inverted { !color } else { color };
        Self { kind: Kind::Paint(color), flip: if source.is_inverted { 0xFF } else { 0 } }
    }

    /// The operation on stored bits, where it is one of the usual ones.
    #[inline]
    pub(super) const fn plain(self) -> Option<RasterOp> {
        match (self.kind, self.flip) {
            (Kind::Copy, 0) => Some(RasterOp::Copy),
            (Kind::Paint(0xFF), 0) => Some(RasterOp::Or),
            (Kind::Paint(0), 0) => Some(RasterOp::AndNot),
            (Kind::Xor, 0) => Some(RasterOp::Xor),
            _ => None,
        }
    }

    /// In words.
    #[inline]
    pub(super) fn map<W>(self, repeated: impl Fn(u8) -> W) -> Op<W> {
        let kind = match self.kind {
            Kind::Copy => Kind::Copy,
            Kind::Paint(color) => Kind::Paint(repeated(color)),
            Kind::Xor => Kind::Xor,
        };
        Op { kind, flip: repeated(self.flip) }
    }
}

impl<W: Copy + BitAnd<Output = W> + BitXor<Output = W>> Op<W> {
    /// What becomes of the bits of the target, as far as they are meant.
    #[inline]
    pub(super) fn merged(self, old: W, new: W, mask: W) -> W {
        let new = new ^ self.flip;
        let change = match self.kind {
            Kind::Copy => old ^ new,
            Kind::Paint(color) => (old ^ color) & new,
            Kind::Xor => new,
        };
        old ^ (change & mask)
    }
}
