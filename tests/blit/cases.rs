//! Frames full of noise, what is drawn on them, and the slow way of drawing it.

use core::convert::Infallible;

use aquatint::{
    Frame, Rect, Spacing,
    display::{
        blit::{Coded, RasterOp},
        layout::Layout,
    },
};
use embedded_graphics::{image::GetPixel, prelude::*};
use proptest::{collection::vec, prelude::*};

/// A frame in memory with bytes before it, between its lines and behind it.
#[derive(Clone, Debug)]
pub struct Room {
    pub size: Size,
    pub before: usize,
    pub gap: usize,
    pub noise: Vec<u8>,
}

impl Room {
    pub fn memory<C: Coded, L: Layout<C>>(&self) -> Vec<u8> {
        let Size { width, height } = self.size;
        let lines = usize::try_from(L::SHAPE.lines(width, height)).expect("small");
        let bytes = self.before + self.stride::<C, L>() * lines + 9;
        self.noise.iter().copied().cycle().take(bytes).collect()
    }

    pub fn stride<C: Coded, L: Layout<C>>(&self) -> usize {
        L::SHAPE.stride(self.size.width, self.size.height) + self.gap
    }

    pub fn frame<C: Coded, L: Layout<C>, B: AsRef<[u8]>>(&self, memory: B) -> Frame<C, L, B> {
        let spacing = Spacing { before: self.before, stride: self.stride::<C, L>() };
        Frame::with_spacing(memory, self.size, spacing).expect("as much as it needs")
    }
}

/// Numbers of pixels, row by row.
#[derive(Clone, Debug)]
pub struct Picture {
    pub width: usize,
    pub numbers: Vec<u32>,
}

impl Picture {
    pub fn of<C: Coded>(source: &(impl GetPixel<Color = C> + OriginDimensions)) -> Self {
        let points = source.bounding_box().points();
        let numbers = points.map(|point| source.pixel(point).expect("inside").number()).collect();
        Self { width: source.size().width as usize, numbers }
    }

    pub fn at(&self, x: i64, y: i64) -> Option<u32> {
        let (x, y) = (usize::try_from(x).ok()?, usize::try_from(y).ok()?);
        if x < self.width { self.numbers.get(y * self.width + x).copied() } else { None }
    }

    /// Each pixel as a function of its place and of what it was.
    pub fn map(&self, new: impl Fn(i64, i64, u32) -> u32) -> Self {
        let place = |index: usize| i64::try_from(index).expect("small");
        let at = |(index, old): (usize, &u32)| new(place(index % self.width), place(index / self.width), *old);
        Self { width: self.width, numbers: self.numbers.iter().enumerate().map(at).collect() }
    }

    pub fn write<C: Coded>(&self, target: &mut impl DrawTarget<Color = C, Error = Infallible>) {
        let points = target.bounding_box().points();
        let pixels = points.zip(&self.numbers).map(|(point, number)| Pixel(point, C::from_number(*number)));
        let Ok(()) = target.draw_iter(pixels);
    }
}

/// What is drawn: a part of a picture, at a place.
#[derive(Clone, Copy, Debug)]
pub struct Drawing {
    pub part: Rect,
    pub at: Point,
    pub op: RasterOp,
}

impl Drawing {
    /// The target after it; `new` is what is drawn where a pixel of the source is.
    pub fn on(
        self,
        target: &Picture,
        source: &Picture,
        mask: Option<&Picture>,
        new: impl Fn(u32, u32) -> u32,
    ) -> Picture {
        let seen = [Some(source), mask].into_iter().flatten().fold(self.part, |part, of| {
            let height = of.numbers.len().checked_div(of.width).unwrap_or(0);
            part.intersection(Rect::new(0, 0, size_i32(of.width), size_i32(height)))
        });
        target.map(|x, y, old| {
            let x = x - i64::from(self.at.x) + i64::from(seen.left);
            let y = y - i64::from(self.at.y) + i64::from(seen.top);
            let inside = (i64::from(seen.left)..seen.right.into()).contains(&x)
                && (i64::from(seen.top)..seen.bottom.into()).contains(&y);
            let shown = mask.is_none_or(|mask| mask.at(x, y) == Some(1));
            source.at(x, y).filter(|_| inside && shown).map_or(old, |source| new(old, source))
        })
    }

    pub fn combined(self, old: u32, new: u32) -> u32 {
        match self.op {
            RasterOp::Copy => new,
            RasterOp::Or => old | new,
            RasterOp::AndNot => old & !new,
            RasterOp::Xor => old ^ new,
        }
    }
}

pub fn size_i32(size: usize) -> i32 {
    i32::try_from(size).expect("small")
}

/// Draws in the middle of memory that is full of noise: all of it must be as the slow way has it.
pub fn compare<C: Coded, L: Layout<C>>(
    room: &Room,
    slow: impl FnOnce(&Picture) -> Picture,
    fast: impl FnOnce(&mut Frame<C, L, &mut [u8]>),
) -> Result<(), TestCaseError> {
    let (mut drawn, mut expected) = (room.memory::<C, L>(), room.memory::<C, L>());
    let mut frame = room.frame::<C, L, _>(&mut expected[..]);
    slow(&Picture::of(&frame)).write(&mut frame);
    fast(&mut room.frame::<C, L, _>(&mut drawn[..]));
    prop_assert_eq!(drawn, expected);
    Ok(())
}

// Cases.

#[derive(Clone, Debug)]
pub struct Case {
    pub target: Room,
    pub source: Room,
    pub mask: Room,
    pub drawing: Drawing,
    pub number: u32,
}

pub fn op() -> impl Strategy<Value = RasterOp> {
    prop_oneof![Just(RasterOp::Copy), Just(RasterOp::Or), Just(RasterOp::AndNot), Just(RasterOp::Xor)]
}

pub fn offset() -> impl Strategy<Value = i32> {
    prop_oneof![20 => -80..80_i32, 9 => -9..9_i32, 1 => Just(i32::MIN), 1 => Just(i32::MAX), 1 => Just(i32::MIN + 9)]
}

pub fn place() -> impl Strategy<Value = Point> {
    (offset(), offset()).prop_map(|(x, y)| Point::new(x, y))
}

pub fn part() -> impl Strategy<Value = Rect> {
    let some = (-9..70_i32, -9..70_i32, -9..80_i32, -9..80_i32).prop_map(|(l, t, r, b)| Rect::new(l, t, r, b));
    prop_oneof![3 => Just(Rect::new(i32::MIN, i32::MIN, i32::MAX, i32::MAX)), 2 => some]
}

pub fn room() -> impl Strategy<Value = Room> {
    let edge = || prop_oneof![9 => 0..70_u32, 1 => 60..150_u32];
    (edge(), edge(), 0..4_usize, prop_oneof![Just(0), 0..5_usize], vec(any::<u8>(), 61..97))
        .prop_map(|(width, height, before, gap, noise)| Room { size: Size::new(width, height), before, gap, noise })
}

pub fn case() -> impl Strategy<Value = Case> {
    let drawing = (part(), place(), op()).prop_map(|(part, at, op)| Drawing { part, at, op });
    (room(), room(), room(), drawing, any::<u32>()).prop_map(|(target, source, mask, drawing, number)| Case {
        target,
        source,
        mask,
        drawing,
        number,
    })
}
