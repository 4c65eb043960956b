//! Random small pictures on every layout, with random inks, windows, queues and memory.

use aquatint::{
    Code, Columns, Connectivity, Flood, Frame, Inverted, LsbFirst, MsbFirst, Pages, Pattern, Planes, Rect, Region,
    Rows, Spacing, Words,
    display::{layout::Layout, region::Alike},
    raster::flood::{Filled, Run, words_needed},
};
use embedded_graphics::{
    geometry::{Point, Size},
    image::GetPixel,
    pixelcolor::{
        BinaryColor, Gray2, Gray4, Gray8, PixelColor, Rgb565,
        raw::{RawData, RawU16},
    },
};
use proptest::prelude::*;

use crate::{
    oracle::{Sheet, region},
    places,
};

#[derive(Clone, Debug)]
pub struct Case {
    pub sheet: Sheet,
    pub seed: Point,
    pub by: Connectivity,
    /// Boundary fill up to this code.
    pub border: Option<u8>,
    pub ink: [u8; 4],
    pub window: Option<Rect>,
    pub queue: usize,
    /// What the lent memory holds.
    pub litter: u32,
    pub gap: usize,
}

fn window(width: i32, height: i32) -> impl Strategy<Value = Rect> {
    let any = || prop_oneof![4 => -5..80_i32, 1 => any::<i32>(), 1 => Just(i32::MIN), 1 => Just(i32::MAX)];
    prop_oneof![
        (any(), any(), any(), any()).prop_map(|(a, b, c, d)| Rect::new(a, b, c, d)),
        (0..=width, 0..=height, 0..=width, 0..=height).prop_map(|(a, b, c, d)| Rect::new(
            a.min(c),
            b.min(d),
            a.max(c),
            b.max(d)
        )),
    ]
}

/// Pictures of some codes, mostly of one, so that regions are large and ragged.
fn sheets() -> impl Strategy<Value = Sheet> {
    let size = prop_oneof![3 => (0..80_i32, 0..12_i32), 1 => (60..140_i32, 1..5_i32), 1 => (0..5_i32, 0..40_i32)];
    (size, 1..8_u32).prop_flat_map(|((width, height), walls)| {
        let code = prop_oneof![8 - walls => Just(0_u8), walls => 0..4_u8];
        let count = (width * height).unsigned_abs() as usize;
        prop::collection::vec(code, count).prop_map(move |codes| Sheet::new(Rect::new(0, 0, width, height), codes))
    })
}

pub fn cases() -> impl Strategy<Value = Case> {
    sheets().prop_flat_map(|sheet| {
        let (width, height) = (sheet.area.right, sheet.area.bottom);
        let seed = prop_oneof![
            9 => (0..width.max(1), 0..height.max(1)),
            1 => (any::<i32>(), any::<i32>()),
            1 => (prop::sample::select(vec![i32::MIN, i32::MAX, -1, width, 0]), -1..=height),
        ];
        let by = prop_oneof![Just(Connectivity::Four), Just(Connectivity::Eight)];
        let border = prop::option::of(0..4_u8);
        let ink =
            prop_oneof![(0..4_u8).prop_map(|code| [code; 4]), any::<[u8; 4]>().prop_map(|ink| ink.map(|c| c % 4))];
        let memory = (0..10_usize, any::<u32>(), prop_oneof![Just(0_usize), 1..5_usize]);
        (seed, by, border, ink, prop::option::of(window(width, height)), memory).prop_map(
            move |((x, y), by, border, ink, window, (queue, litter, gap))| {
                let (sheet, seed) = (sheet.clone(), Point::new(x, y));
                Case { sheet, seed, by, border, ink, window, queue, litter, gap }
            },
        )
    })
}

fn moved(Rect { left, top, right, bottom }: Rect, (x, y): (i32, i32)) -> Rect {
    Rect::new(left.saturating_add(x), top.saturating_add(y), right.saturating_add(x), bottom.saturating_add(y))
}

impl Case {
    /// The codes with only those bits that a layout has.
    fn masked(mut self, mask: u8) -> Self {
        self.sheet.codes.iter_mut().chain(&mut self.ink).chain(&mut self.border).for_each(|code| *code &= mask);
        self
    }

    /// The same somewhere else.
    pub fn moved(mut self, left: i32, top: i32) -> Self {
        self.sheet.area = moved(self.sheet.area, (left, top));
        self.window = self.window.map(|window| moved(window, (left, top)));
        self.seed = Point::new(self.seed.x.saturating_add(left), self.seed.y.saturating_add(top));
        self
    }

    pub fn seen(&self) -> Rect {
        self.window.map_or(self.sheet.area, |window| window.intersection(self.sheet.area))
    }

    /// What must come out: the codes, and what was filled.
    pub fn expected(&self) -> (Vec<u8>, Filled) {
        let old = self.sheet.code(self.seed).filter(|_| self.seen().contains(self.seed));
        let inside = |code| self.border.map_or(Some(code) == old, |border| code != border);
        let found = region(&self.sheet, self.seed, self.by, inside, self.seen());
        let (mut codes, mut filled) = (self.sheet.codes.clone(), Filled::default());
        for ((Point { x, y }, code), _) in
            places(self.sheet.area).zip(&mut codes).zip(found).filter(|(_, is_found)| *is_found)
        {
            *code = self.ink[(x & 3).unsigned_abs() as usize];
            let Rect { left, top, right, bottom } =
                if filled.pixels == 0 { Rect::new(x, y, x + 1, y + 1) } else { filled.bounds };
            filled.bounds = Rect::new(left.min(x), top.min(y), right.max(x + 1), bottom.max(y + 1));
            filled.pixels += 1;
        }
        (codes, filled)
    }
}

/// Fills on a frame between guard bytes, with memory between guard words, and compares everything.
fn check<C: PixelColor + std::fmt::Debug, L: Layout<C> + Alike<C>>(case: &Case, color: fn(u8) -> C) {
    const GUARD: u8 = 0b1010_0110;
    let Case { sheet, seed, by, ink, litter, .. } = case;
    let (width, height) = (sheet.area.width(), sheet.area.height());
    let spacing = Spacing { before: case.gap, stride: L::SHAPE.stride(width, height) + case.gap };
    let lines = usize::try_from(L::SHAPE.lines(width, height)).expect("few");
    let length = case.gap + lines * spacing.stride;
    let mut bytes = vec![GUARD; length + 40];
    let size = Size::new(width, height);
    let mut frame = Frame::<C, L, _>::with_spacing(&mut bytes[..length], size, spacing).expect("large enough");
    for (at, &code) in places(sheet.area).zip(&sheet.codes) {
        let Ok(()) = embedded_graphics::Drawable::draw(&embedded_graphics::Pixel(at, color(code)), &mut frame);
    }
    let needed = words_needed(case.seen().width(), case.seen().height());
    let (mut memory, mut queue) = (vec![*litter; needed + 3], vec![Run::default(); case.queue]);
    let mut flood = Flood::new(&mut memory, &mut queue).with_connectivity(*by);
    if let Some(window) = case.window {
        flood = flood.with_window(window);
    }
    let region = case.border.map_or((*seed).into(), |border| Region::Boundary(*seed, color(border)));
    let ink = ink.map(color);
    let filled = if ink == [ink[0]; 4] {
        flood.fill(&mut frame, region, ink[0])
    } else {
        flood.fill_with(&mut frame, region, Pattern::new([ink]))
    };
    let (codes, expected) = case.expected();
    assert_eq!(filled, Ok(expected), "{}", std::any::type_name::<L>());
    for (at, code) in places(sheet.area).zip(codes) {
        assert_eq!(frame.pixel(at), Some(color(code)), "{at} in {}", std::any::type_name::<L>());
    }
    let gaps = frame.memory().chunks(spacing.stride.max(1)).flat_map(|line| &line[..case.gap.min(line.len())]);
    assert!(gaps.take(lines * case.gap).all(|&byte| byte == GUARD), "bytes between the lines");
    assert!(bytes[length..].iter().all(|&byte| byte == GUARD), "bytes behind the picture");
    assert!(memory[needed..].iter().all(|word| word == litter), "words behind those needed");
}

fn code<C: Code>(code: u8) -> C {
    C::from_code(code)
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(10_000))]

    #[test]
    fn regions_of_one_bit_are_filled_as_the_oracle_says(case in cases(), layout in 0..8) {
        let case = case.masked(1);
        match layout {
            0 => check::<BinaryColor, Rows>(&case, code),
            1 => check::<BinaryColor, Rows<LsbFirst>>(&case, code),
            2 => check::<BinaryColor, Pages>(&case, code),
            3 => check::<BinaryColor, Pages<MsbFirst>>(&case, code),
            4 => check::<BinaryColor, Columns>(&case, code),
            5 => check::<BinaryColor, Columns<LsbFirst>>(&case, code),
            6 => check::<BinaryColor, Inverted<Rows>>(&case, code),
            _ => check::<BinaryColor, Inverted<Pages>>(&case, code),
        }
    }

    #[test]
    fn regions_of_more_bits_are_filled_as_the_oracle_says(case in cases(), layout in 0..7) {
        match layout {
            0 => check::<Gray2, Rows>(&case, code),
            1 => check::<Gray2, Planes>(&case, code),
            2 => check::<Gray2, Planes<LsbFirst>>(&case, code),
            3 => check::<Gray2, Inverted<Planes>>(&case, code),
            4 => check::<Gray4, Rows<LsbFirst>>(&case, code),
            5 => check::<Gray8, Rows>(&case, code),
            _ => check::<Rgb565, Words>(&case, |code| RawU16::from_u32(u32::from(code) * 0x1084).into()),
        }
    }
}
