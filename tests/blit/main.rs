//! Pictures onto frames and frames moved in themselves: pictures in the source, and a slow reference
//! that draws a pixel at a time.

mod cases;

use aquatint::{
    Code, Columns, Frame, Inverted, LsbFirst, MsbFirst, Pages, Planes, Rect, Rows, Window, Words,
    display::{
        blit::{Blit, Coded, Part, RasterOp},
        layout::Layout,
    },
};
use embedded_graphics::{
    image::GetPixel,
    pixelcolor::{BinaryColor, Gray2, Gray4, Gray8, Rgb565},
    prelude::*,
};
use proptest::prelude::*;

use cases::{Case, Drawing, Picture, Room, case, compare, offset, part};

type Check = fn(&Case) -> Result<(), TestCaseError>;

fn drawn<C: Coded, L: Layout<C>, M: Layout<C>>(case: &Case) -> Result<(), TestCaseError> {
    let drawing = case.drawing;
    let memory = case.source.memory::<C, M>();
    let source = case.source.frame::<C, M, _>(&memory);
    let slow =
        |target: &Picture| drawing.on(target, &Picture::of(&source), None, |old, new| drawing.combined(old, new));
    compare::<C, L>(&case.target, slow, |frame| frame.blit(source.part(drawing.part), drawing.at, drawing.op))
}

fn masked<C, L, M>(case: &Case) -> Result<(), TestCaseError>
where
    C: Coded,
    L: Layout<C>,
    M: Layout<C> + Layout<BinaryColor>,
{
    let drawing = case.drawing;
    // Most often a mask is as large as its picture.
    let size = if case.number.is_multiple_of(4) { case.mask.size } else { case.source.size };
    let room = Room { size, ..case.mask.clone() };
    let (memory, masks) = (case.source.memory::<C, M>(), room.memory::<BinaryColor, M>());
    let source = case.source.frame::<C, M, _>(&memory);
    let mask = room.frame::<BinaryColor, M, _>(&masks);
    let holes = Picture::of(&mask);
    let slow = |target: &Picture| {
        drawing.on(target, &Picture::of(&source), Some(&holes), |old, new| drawing.combined(old, new))
    };
    let part = source.part(drawing.part).with_mask(&mask);
    compare::<C, L>(&case.target, slow, |frame| frame.blit(part, drawing.at, drawing.op))
}

fn painted<C, L, M>(case: &Case) -> Result<(), TestCaseError>
where
    C: Coded,
    L: Layout<C>,
    M: Layout<BinaryColor>,
{
    let drawing = case.drawing;
    let (memory, masks) = (case.source.memory::<BinaryColor, M>(), case.mask.memory::<BinaryColor, M>());
    let source = case.source.frame::<BinaryColor, M, _>(&memory);
    let mask = case.mask.frame::<BinaryColor, M, _>(&masks);
    let holes = case.number.is_multiple_of(4).then(|| Picture::of(&mask));
    let part = if holes.is_some() { Part::from(&source).with_mask(&mask) } else { Part::from(&source) };
    let color = C::from_number(case.number);
    let slow = |target: &Picture| {
        let new = |old, new| if new == 1 { color.number() } else { old };
        drawing.on(target, &Picture::of(&source), holes.as_ref(), new)
    };
    compare::<C, L>(&case.target, slow, |frame| frame.paint(part.part(drawing.part), drawing.at, color))
}

/// Everything that the layouts of a colour can do with each other.
macro_rules! pairs {
    ($check:ident, $color:ty: $($target:ty),* => $sources:tt) => { [$(pairs!(@ $check, $color, $target, $sources)),*].concat() };
    (@ $check:ident, $color:ty, $target:ty, [$($source:ty),*]) => { vec![$($check::<$color, $target, $source> as Check),*] };
}

fn one_bit() -> Vec<Check> {
    macro_rules! all {
        ($check:ident, $color:ty) => {
            pairs!($check, $color: Rows<MsbFirst>, Rows<LsbFirst>, Pages<LsbFirst>, Pages<MsbFirst>, Columns<MsbFirst>,
                Columns<LsbFirst>, Inverted<Rows>, Inverted<Pages>, Inverted<Inverted<Rows>>
                => [Rows<MsbFirst>, Rows<LsbFirst>, Pages<LsbFirst>, Pages<MsbFirst>, Columns<MsbFirst>,
                    Columns<LsbFirst>, Inverted<Rows>, Inverted<Pages>])
        };
    }
    [all!(drawn, BinaryColor), all!(masked, BinaryColor), all!(painted, BinaryColor)].concat()
}

fn more_bits() -> Vec<Check> {
    macro_rules! of_rows {
        ($color:ty) => {
            [
                pairs!(drawn, $color: Rows, Rows<LsbFirst>, Inverted<Rows> => [Rows, Rows<LsbFirst>, Inverted<Rows>]),
                pairs!(masked, $color: Rows, Rows<LsbFirst>, Inverted<Rows> => [Rows, Rows<LsbFirst>, Inverted<Rows>]),
                pairs!(painted, $color: Rows, Rows<LsbFirst>, Inverted<Rows> => [Rows, Rows<LsbFirst>, Inverted<Rows>]),
                pairs!(painted, $color: Rows => [Pages, Columns]),
            ]
            .concat()
        };
    }
    let planes = pairs!(drawn, Gray2: Planes, Planes<LsbFirst>, Rows => [Planes, Planes<LsbFirst>, Rows]);
    let words = pairs!(drawn, Rgb565: Words, Words<LsbFirst> => [Words, Words<LsbFirst>]);
    let on_them = [pairs!(painted, Gray2: Planes => [Rows, Pages]), pairs!(painted, Rgb565: Words => [Rows, Pages])];
    [of_rows!(Gray2), of_rows!(Gray4), of_rows!(Gray8), planes, words, on_them.concat()].concat()
}

fn moved<C: Coded, L: Layout<C>>(case: &Case) -> Result<(), TestCaseError> {
    let Drawing { part: area, at, .. } = case.drawing;
    let whole = Drawing { op: RasterOp::Copy, ..case.drawing };
    let slow = |picture: &Picture| whole.on(picture, picture, None, |_, new| new);
    compare::<C, L>(&case.target, slow, |frame| frame.copy_within(area, at))?;

    let (color, size) = (C::from_number(case.number), case.target.size);
    let area_seen = area.intersection(Rect::of_size(size));
    let is_inside = |x: i64, y: i64| {
        (i64::from(area_seen.left)..area_seen.right.into()).contains(&x)
            && (i64::from(area_seen.top)..area_seen.bottom.into()).contains(&y)
    };
    let slow = |picture: &Picture| {
        picture.map(|x, y, old| {
            let (from_x, from_y) = (x - i64::from(at.x), y - i64::from(at.y));
            let source = picture.at(from_x, from_y).filter(|_| is_inside(from_x, from_y));
            if is_inside(x, y) { source.unwrap_or(color.number()) } else { old }
        })
    };
    compare::<C, L>(&case.target, slow, |frame| frame.scroll(area, at, color))
}

fn all_layouts() -> Vec<Check> {
    vec![
        moved::<BinaryColor, Rows>,
        moved::<BinaryColor, Rows<LsbFirst>>,
        moved::<BinaryColor, Pages>,
        moved::<BinaryColor, Pages<MsbFirst>>,
        moved::<BinaryColor, Columns>,
        moved::<BinaryColor, Columns<LsbFirst>>,
        moved::<BinaryColor, Inverted<Pages>>,
        moved::<Gray2, Rows>,
        moved::<Gray2, Rows<LsbFirst>>,
        moved::<Gray2, Planes>,
        moved::<Gray4, Rows>,
        moved::<Gray8, Rows>,
        moved::<Rgb565, Words>,
    ]
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(20_000))]

    #[test]
    fn one_bit_pictures(case in case(), which: prop::sample::Index) {
        which.get(&one_bit())(&case)?;
    }

    #[test]
    fn deeper_pictures(case in case(), which: prop::sample::Index) {
        which.get(&more_bits())(&case)?;
    }

    #[test]
    fn moved_pictures(case in case(), which: prop::sample::Index) {
        which.get(&all_layouts())(&case)?;
    }

    // Through a window: what is seen of it, and nothing else.
    #[test]
    fn windows(case in case(), area in part(), top in offset()) {
        let Drawing { part, at, op } = case.drawing;
        let memory = case.source.memory::<BinaryColor, Rows>();
        let source = case.source.frame::<BinaryColor, Rows, _>(&memory);
        // In a window that begins at the end of `i32`, nothing has coordinates.
        let area = Rect { left: area.left.max(-999), top: area.top.max(-999), ..area };
        let slow = |picture: &Picture| {
            let seen = area.intersection(Rect::of_size(case.target.size));
            let corner = [at.x, area.left, at.y, area.top].map(i64::from);
            picture.map(|x, y, old| {
                let inside = seen.contains(Point::new(small(x), small(y)));
                let part = part.intersection(Rect::of_size(case.source.size));
                let x = x - corner[0] - corner[1] + i64::from(part.left);
                let y = y - corner[2] - corner[3] + i64::from(part.top);
                let drawn = i32::try_from(x).ok().zip(i32::try_from(y).ok()).filter(|(x, y)| part.contains(Point::new(*x, *y)));
                let new = drawn.and_then(|(x, y)| source.pixel(Point::new(x, y))).filter(|_| inside);
                new.map_or(old, |new| case.drawing.combined(old, new.number()))
            })
        };
        compare::<BinaryColor, Pages>(&case.target, slow, |frame| {
            Window::part(frame, area).blit(source.part(part), at, op);
        })?;

        // A band, from rows anywhere.
        let shifted = Drawing { at: Point::new(at.x, at.y.saturating_sub(top)), ..case.drawing };
        let slow = |picture: &Picture| shifted.on(picture, &Picture::of(&source), None, |old, new| if new == 1 { 1 } else { old });
        let is_addressable = top > i32::MIN && top.checked_add(200).is_some();
        if !is_addressable || at.y.checked_sub(top).is_none() {
            return Ok(());
        }
        compare::<BinaryColor, Pages>(&case.target, slow, |frame| {
            Window::band(frame, top).paint(source.part(part), at, BinaryColor::On);
        })?;
    }
}

fn small(place: i64) -> i32 {
    i32::try_from(place).expect("small")
}

// By hand.

static FACE: Frame<BinaryColor, Rows, [u8; 8]> = match Frame::with_array(
    [0b0011_1100, 0b0100_0010, 0b1010_0101, 0b1000_0001, 0b1010_0101, 0b1001_1001, 0b0100_0010, 0b0011_1100],
    8,
    8,
) {
    Ok(face) => face,
    Err(_) => panic!(),
};

/// Rows of one bit as signs.
fn signs(frame: &(impl GetPixel<Color = BinaryColor> + OriginDimensions)) -> Vec<String> {
    let Picture { width, numbers } = Picture::of(frame);
    let sign = |number: &u32| if *number == 0 { '.' } else { '#' };
    numbers.chunks(width).map(|row| row.iter().map(sign).collect()).collect()
}

#[test]
fn a_face_hangs_over_the_corner() {
    let expected = ["#.#.........", "..#.........", ".#..........", "#...........", "............"];
    let mut rows = Frame::<BinaryColor, Rows, _>::with_array([0; 10], 12, 5).expect("ten bytes");
    let mut pages = Frame::<BinaryColor, Pages, _>::with_array([0; 12], 12, 5).expect("twelve bytes");
    rows.blit(&FACE, Point::new(-5, -4), RasterOp::Copy);
    pages.blit(&FACE, Point::new(-5, -4), RasterOp::Copy);
    assert_eq!(signs(&rows)[..], expected[..]);
    assert_eq!(signs(&pages)[..], expected[..]);
}

#[test]
fn drawn_twice_with_xor_it_is_gone() {
    let mut pages = Frame::<BinaryColor, Pages, _>::with_array([0x5A; 24], 12, 16).expect("24 bytes");
    for _ in 0..2 {
        pages.blit(&FACE, Point::new(2, 5), RasterOp::Xor);
    }
    assert_eq!(pages.bytes(), [0x5A; 24]);
}

#[test]
fn four_bits_keep_their_neighbours() {
    let mut rows = Frame::<Gray4, Rows, _>::with_array([0x12, 0x34, 0x56], 6, 1).expect("three bytes");
    let picture = Frame::<Gray4, Rows, _>::with_array([0xAB, 0xC0], 3, 1).expect("two bytes");
    rows.blit(&picture, Point::new(1, 0), RasterOp::Copy);
    assert_eq!(rows.bytes(), [0x1A, 0xBC, 0x56]);
    let mask = Frame::<BinaryColor, Rows, _>::with_array([0b1010_0000], 3, 1).expect("one byte");
    rows.blit(Part::from(&picture).with_mask(&mask), Point::new(3, 0), RasterOp::Copy);
    assert_eq!(rows.bytes(), [0x1A, 0xBA, 0x5C]);
}

#[test]
fn nothing_is_drawn_on_nothing() {
    fn on_nothing<C: Code + Coded, L: Layout<C>>() {
        for (width, height) in [(0, 0), (0, 9), (9, 0), (0, u32::MAX), (u32::MAX, 0)] {
            let mut frame = Frame::<C, L, _>::with_array([], width, height).expect("no bytes");
            let empty = Frame::<BinaryColor, Rows, _>::with_array([], height, width).expect("no bytes");
            let other = Frame::<C, L, _>::with_array([], height, width).expect("no bytes");
            frame.blit(&other, Point::zero(), RasterOp::Copy);
            frame.paint(&FACE, Point::zero(), C::from_number(1));
            frame.paint(&empty, Point::zero(), C::from_number(1));
            frame.copy_within(Rect::new(i32::MIN, i32::MIN, i32::MAX, i32::MAX), Point::new(1, 1));
            frame.scroll(Rect::new(i32::MIN, i32::MIN, i32::MAX, i32::MAX), Point::new(1, i32::MIN), C::from_number(1));
        }
    }
    on_nothing::<BinaryColor, Rows>();
    on_nothing::<BinaryColor, Pages>();
    on_nothing::<BinaryColor, Columns>();
    on_nothing::<Gray2, Planes>();
    on_nothing::<Gray4, Rows>();
}
