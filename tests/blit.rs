//! Images onto frames and frames moved in themselves: pictures in the source, and a slow reference
//! that draws a pixel at a time.

use core::fmt::Debug;

use aquatint::{
    Code, Rect, TooSmall,
    display::blit::{Bitmap, Geometry, PageBitmap, RasterOp, scroll_pages, scroll_rows},
};
use embedded_graphics::{
    geometry::{Point, Size},
    pixelcolor::{BinaryColor, Gray2, Gray4, Gray8},
};
use proptest::{collection::vec, prelude::*};

/// Codes of pixels, row by row.
#[derive(Clone, Debug, PartialEq, Eq)]
struct Picture {
    width: usize,
    codes: Vec<u8>,
}

impl Picture {
    fn height(&self) -> usize {
        self.codes.len().checked_div(self.width).unwrap_or(0)
    }

    fn at(&self, x: i64, y: i64) -> Option<u8> {
        let (x, y) = (usize::try_from(x).ok()?, usize::try_from(y).ok()?);
        if x < self.width { self.codes.get(y * self.width + x).copied() } else { None }
    }
}

/// Where a pixel lies: the byte and how far its code is shifted.
#[derive(Clone, Copy, Debug)]
enum Packing {
    Rows { bits: usize },
    Pages,
}

impl Packing {
    fn place(self, stride: usize, x: usize, y: usize) -> (usize, usize) {
        match self {
            Self::Rows { bits } => (y * stride + x * bits / 8, 8 - bits - x * bits % 8),
            Self::Pages => (y / 8 * stride + x, y % 8),
        }
    }

    fn mask(self) -> u8 {
        match self {
            Self::Rows { bits } => 0xFF >> (8 - bits),
            Self::Pages => 1,
        }
    }

    fn read(self, bytes: &[u8], geometry: Geometry) -> Picture {
        let (width, height) = (geometry.size.width as usize, geometry.size.height as usize);
        let places = (0..height).flat_map(|y| (0..width).map(move |x| self.place(geometry.stride, x, y)));
        Picture { width, codes: places.map(|(byte, shift)| bytes[byte] >> shift & self.mask()).collect() }
    }

    /// `bytes` with all the pixels in them.
    fn write(self, bytes: &[u8], geometry: Geometry, picture: &Picture) -> Vec<u8> {
        let mut bytes = bytes.to_vec();
        for (index, code) in picture.codes.iter().enumerate() {
            let (byte, shift) = self.place(geometry.stride, index % picture.width, index / picture.width);
            bytes[byte] = bytes[byte] & !(self.mask() << shift) | code << shift;
        }
        bytes
    }
}

/// What is drawn: a part of a picture, at a place.
#[derive(Clone, Debug)]
struct Drawing {
    source: Picture,
    mask: Option<Picture>,
    part: Rect,
    at: Point,
    op: RasterOp,
}

impl Drawing {
    /// The target after it.
    fn on(&self, target: &Picture, code_mask: u8) -> Picture {
        let mut result = target.clone();
        let part = self.part.intersection(Rect::new(0, 0, size_i32(self.source.width), size_i32(self.source.height())));
        for (index, code) in result.codes.iter_mut().enumerate() {
            let (x, y) = (index % target.width, index / target.width);
            let from =
                |place: usize, at: i32, first: i32| i64::try_from(place).unwrap() - i64::from(at) + i64::from(first);
            let (x, y) = (from(x, self.at.x, part.left), from(y, self.at.y, part.top));
            let inside = (i64::from(part.left)..part.right.into()).contains(&x)
                && (i64::from(part.top)..part.bottom.into()).contains(&y);
            let shown = self.mask.as_ref().is_none_or(|mask| mask.at(x, y) == Some(1));
            if let (true, Some(new)) = (inside && shown, self.source.at(x, y)) {
                *code = code_mask
                    & match self.op {
                        RasterOp::Copy => new,
                        RasterOp::Or => *code | new,
                        RasterOp::AndNot => *code & !new,
                        RasterOp::Xor => *code ^ new,
                    };
            }
        }
        result
    }
}

fn size_i32(size: usize) -> i32 {
    i32::try_from(size).expect("small")
}

/// Draws in the middle of memory that is full of noise: all of it must be as the slow way has it.
fn compare(
    packing: Packing,
    geometry: Geometry,
    noise: &[u8],
    (fast, slow): (impl FnOnce(&mut [u8]) -> Result<(), TooSmall>, impl FnOnce(&Picture) -> Picture),
) -> Result<(), TestCaseError> {
    let lines = match packing {
        Packing::Rows { .. } => geometry.size.height,
        Packing::Pages => geometry.size.height.div_ceil(8),
    };
    let end = 8 + geometry.stride * lines as usize;
    let memory: Vec<u8> = noise.iter().copied().cycle().take(end + 8).collect();
    let mut drawn = memory.clone();
    prop_assert_eq!(fast(&mut drawn[8..]), Ok(()));
    let expected = packing.write(&memory[8..end], geometry, &slow(&packing.read(&memory[8..], geometry)));
    prop_assert_eq!(&drawn[8..end], &expected[..], "{:?} {:?}", packing, geometry);
    prop_assert_eq!(&drawn[..8], &memory[..8]);
    prop_assert_eq!(&drawn[end..], &memory[end..]);
    Ok(())
}

// Strategies.

fn op() -> impl Strategy<Value = RasterOp> {
    prop_oneof![Just(RasterOp::Copy), Just(RasterOp::Or), Just(RasterOp::AndNot), Just(RasterOp::Xor)]
}

fn offset() -> impl Strategy<Value = i32> {
    prop_oneof![20 => -80..80_i32, 1 => Just(i32::MIN), 1 => Just(i32::MAX), 1 => Just(i32::MIN + 9)]
}

fn place() -> impl Strategy<Value = Point> {
    (offset(), offset()).prop_map(|(x, y)| Point::new(x, y))
}

fn part() -> impl Strategy<Value = Rect> {
    let some = (-9..70_i32, -9..70_i32, -9..80_i32, -9..80_i32).prop_map(|(l, t, r, b)| Rect::new(l, t, r, b));
    prop_oneof![3 => Just(Rect::new(i32::MIN, i32::MIN, i32::MAX, i32::MAX)), 2 => some]
}

fn size() -> impl Strategy<Value = Size> {
    let edge = || prop_oneof![9 => 0..70_u32, 1 => 60..150_u32];
    (edge(), edge()).prop_map(|(width, height)| Size::new(width, height))
}

/// Sizes of the target and of the source, where it is drawn and which part, how, and noise.
fn case() -> impl Strategy<Value = (Size, Size, Point, Rect, RasterOp, Vec<u8>)> {
    (size(), size(), place(), part(), op(), vec(any::<u8>(), 257))
}

fn row_stride(size: Size, bits: usize) -> usize {
    (size.width as usize * bits).div_ceil(8)
}

/// Bytes for a source of this many, which are not those of the target.
fn source_bytes(noise: &[u8], bytes: usize) -> Vec<u8> {
    noise.iter().rev().copied().cycle().take(bytes + 3).collect()
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(1000))]

    #[test]
    fn rows_on_rows((target, source, at, part, op, noise) in case(), gap in 0..5_usize, masked: bool) {
        let case = (target, source, at, part, op);
        rows_on_rows_of::<BinaryColor>(case, &noise, gap, masked)?;
        rows_on_rows_of::<Gray2>(case, &noise, gap, masked)?;
        rows_on_rows_of::<Gray4>(case, &noise, gap, masked)?;
        rows_on_rows_of::<Gray8>(case, &noise, gap, masked)?;
    }

    #[test]
    fn rows_on_pages((target, source, at, part, op, noise) in case(), gap in 0..5_usize, masked: bool) {
        let geometry = Geometry { size: target, stride: target.width as usize + gap };
        let (bitmap, drawing, bytes) = (source_bytes(&noise, row_stride(source, 1) * source.height as usize), (part, at, op), masked);
        let bitmap = Source::new(source, bitmap, bytes.then_some(&noise[..]));
        let slow = bitmap.drawing::<BinaryColor>(drawing);
        let fast = |bytes: &mut [u8]| bitmap.bitmap::<BinaryColor>()?.crop(part).draw_on_pages(bytes, geometry, at, op);
        compare(Packing::Pages, geometry, &noise, (fast, |picture: &Picture| slow.on(picture, 1)))?;
    }

    #[test]
    fn pages_on_pages((target, source, at, _, op, noise) in case(), gap in 0..5_usize) {
        let geometry = Geometry { size: target, stride: target.width as usize + gap };
        let of_source = Geometry { size: source, stride: source.width as usize + gap };
        let bytes = source_bytes(&noise, of_source.stride * source.height.div_ceil(8) as usize);
        let picture = Packing::Pages.read(&bytes, of_source);
        let slow = Drawing { source: picture, mask: None, part: Rect::new(0, 0, 999, 999), at, op };
        let fast = |target: &mut [u8]| PageBitmap::new(&bytes, of_source)?.draw_on_pages(target, geometry, at, op);
        compare(Packing::Pages, geometry, &noise, (fast, |picture: &Picture| slow.on(picture, 1)))?;
    }

    #[test]
    fn scrolled_rows((size, _, by, _, _, noise) in case(), gap in 0..5_usize, code: u8) {
        scroll_rows_of::<BinaryColor>(size, by, &noise, (gap, code))?;
        scroll_rows_of::<Gray2>(size, by, &noise, (gap, code))?;
        scroll_rows_of::<Gray4>(size, by, &noise, (gap, code))?;
        scroll_rows_of::<Gray8>(size, by, &noise, (gap, code))?;
    }

    #[test]
    fn scrolled_pages((size, _, by, _, _, noise) in case(), gap in 0..5_usize, on: bool) {
        let geometry = Geometry { size, stride: size.width as usize + gap };
        let fast = |bytes: &mut [u8]| scroll_pages(bytes, geometry, by, BinaryColor::from(on));
        compare(Packing::Pages, geometry, &noise, (fast, |picture: &Picture| scrolled(picture, by, on.into())))?;
    }
}

/// The bytes of a source and of its mask.
struct Source<'n> {
    size: Size,
    bytes: Vec<u8>,
    mask: Option<&'n [u8]>,
    masks: Vec<u8>,
}

impl<'n> Source<'n> {
    fn new(size: Size, bytes: Vec<u8>, mask: Option<&'n [u8]>) -> Self {
        let length = row_stride(size, 1) * size.height as usize;
        let masks = mask.unwrap_or(&[0]).iter().copied().cycle().skip(7).take(length).collect();
        Self { size, bytes, mask, masks }
    }

    fn bitmap<C: Code>(&self) -> Result<Bitmap<'_, C>, TooSmall> {
        let bitmap = Bitmap::new(&self.bytes, self.size.width, self.size.height)?;
        if self.mask.is_some() { bitmap.with_mask(&self.masks) } else { Ok(bitmap) }
    }

    fn drawing<C: Code>(&self, (part, at, op): (Rect, Point, RasterOp)) -> Drawing {
        let read = |bytes: &[u8], bits: usize| {
            Packing::Rows { bits }.read(bytes, Geometry { size: self.size, stride: row_stride(self.size, bits) })
        };
        let source = read(&self.bytes, C::BITS as usize);
        Drawing { source, mask: self.mask.map(|_| read(&self.masks, 1)), part, at, op }
    }
}

fn rows_on_rows_of<C: Code>(
    (target, source, at, part, op): (Size, Size, Point, Rect, RasterOp),
    noise: &[u8],
    gap: usize,
    masked: bool,
) -> Result<(), TestCaseError> {
    let bits = C::BITS as usize;
    let geometry = Geometry { size: target, stride: row_stride(target, bits) + gap };
    let bytes = source_bytes(noise, row_stride(source, bits) * source.height as usize);
    let source = Source::new(source, bytes, masked.then_some(noise));
    let slow = source.drawing::<C>((part, at, op));
    let fast = |bytes: &mut [u8]| source.bitmap::<C>()?.crop(part).draw_on_rows(bytes, geometry, at, op);
    compare(Packing::Rows { bits }, geometry, noise, (fast, |picture: &Picture| slow.on(picture, 0xFF >> (8 - bits))))
}

fn scroll_rows_of<C: Code>(size: Size, by: Point, noise: &[u8], (gap, code): (usize, u8)) -> Result<(), TestCaseError> {
    let bits = C::BITS as usize;
    let geometry = Geometry { size, stride: row_stride(size, bits) + gap };
    let color = C::from_code(code & (0xFF >> (8 - bits)));
    let fast = |bytes: &mut [u8]| scroll_rows(bytes, geometry, by, color);
    compare(Packing::Rows { bits }, geometry, noise, (fast, |picture: &Picture| scrolled(picture, by, color.code())))
}

fn scrolled(picture: &Picture, by: Point, fill: u8) -> Picture {
    let from = |place: usize, by: i32| i64::try_from(place).unwrap() - i64::from(by);
    let places = (0..picture.codes.len()).map(|index| (index % picture.width, index / picture.width));
    let codes = places.map(|(x, y)| picture.at(from(x, by.x), from(y, by.y)).unwrap_or(fill)).collect();
    Picture { width: picture.width, codes }
}

// By hand.

const FACE: [u8; 8] =
    [0b0011_1100, 0b0100_0010, 0b1010_0101, 0b1000_0001, 0b1010_0101, 0b1001_1001, 0b0100_0010, 0b0011_1100];

/// Rows of one bit as signs.
fn signs(bytes: &[u8], geometry: Geometry, packing: Packing) -> Vec<String> {
    let picture = packing.read(bytes, geometry);
    picture
        .codes
        .chunks(picture.width)
        .map(|row| row.iter().map(|code| if *code == 0 { '.' } else { '#' }).collect())
        .collect()
}

#[test]
fn a_face_hangs_over_the_corner() {
    let expected = ["#.#.........", "..#.........", ".#..........", "#...........", "............"];
    let (rows, pages) = (Geometry::rows::<BinaryColor>(12, 5), Geometry::pages(12, 5));
    let (mut on_rows, mut on_pages) = ([0; 10], [0; 12]);
    let face = Bitmap::<BinaryColor>::new(&FACE, 8, 8).expect("eight bytes");
    assert_eq!(face.draw_on_rows(&mut on_rows, rows, Point::new(-5, -4), RasterOp::Copy), Ok(()));
    assert_eq!(face.draw_on_pages(&mut on_pages, pages, Point::new(-5, -4), RasterOp::Copy), Ok(()));
    assert_eq!(signs(&on_rows, rows, Packing::Rows { bits: 1 })[..], expected[..]);
    assert_eq!(signs(&on_pages, pages, Packing::Pages)[..], expected[..]);
}

#[test]
fn drawn_twice_with_xor_it_is_gone() {
    let mut pages = [0x5A; 24];
    let face = Bitmap::<BinaryColor>::new(&FACE, 8, 8).expect("eight bytes");
    for _ in 0..2 {
        let at = Point::new(2, 5);
        assert_eq!(face.draw_on_pages(&mut pages, Geometry::pages(12, 16), at, RasterOp::Xor), Ok(()));
    }
    assert_eq!(pages, [0x5A; 24]);
}

#[test]
fn four_bits_keep_their_neighbours() {
    let mut rows = [0x12, 0x34, 0x56];
    let bitmap = Bitmap::<Gray4>::new(&[0xAB, 0xC0], 3, 1).expect("two bytes");
    let geometry = Geometry::rows::<Gray4>(6, 1);
    assert_eq!(bitmap.draw_on_rows(&mut rows, geometry, Point::new(1, 0), RasterOp::Copy), Ok(()));
    assert_eq!(rows, [0x1A, 0xBC, 0x56]);
    let holes = bitmap.with_mask(&[0b1010_0000]).expect("one byte");
    assert_eq!(holes.draw_on_rows(&mut rows, geometry, Point::new(3, 0), RasterOp::Copy), Ok(()));
    assert_eq!(rows, [0x1A, 0xBA, 0x5C]);
}

#[test]
fn whoever_is_too_small_is_told() {
    let too_small = |needed| Err(TooSmall { needed });
    assert_eq!(Bitmap::<Gray4>::new(&[0; 5], 3, 3).map(drop), too_small(6));
    assert_eq!(
        Bitmap::<Gray4>::new(&[0; 6], 3, 3).and_then(|bitmap| bitmap.with_mask(&[0; 2])).map(drop),
        too_small(3)
    );
    assert_eq!(PageBitmap::new(&[0; 5], Geometry::pages(3, 9)).map(drop), too_small(6));
    assert!(Bitmap::<Gray8>::new(&[0; 9], u32::MAX, u32::MAX).is_err());
    assert!(PageBitmap::new(&[0; 9], Geometry::pages(u32::MAX, u32::MAX)).is_err());

    let bitmap = Bitmap::<BinaryColor>::new(&[0xFF; 2], 9, 1).expect("two bytes");
    let (rows, pages) = (Geometry::rows::<BinaryColor>(9, 2), Geometry::pages(9, 9));
    let (at, op) = (Point::zero(), RasterOp::Copy);
    assert_eq!(bitmap.draw_on_rows(&mut [0; 3], rows, at, op), too_small(4));
    assert_eq!(bitmap.draw_on_pages(&mut [0; 17], pages, at, op), too_small(18));
    assert_eq!(scroll_rows(&mut [0; 3], rows, at, BinaryColor::On), too_small(4));
    assert_eq!(scroll_pages(&mut [0; 17], pages, at, BinaryColor::On), too_small(18));
    // A stride that is shorter than a line, and one that no memory has.
    assert_eq!(bitmap.draw_on_rows(&mut [0; 9], Geometry { stride: 1, ..rows }, at, op), too_small(2));
    assert_eq!(bitmap.draw_on_pages(&mut [0; 99], Geometry { stride: 8, ..pages }, at, op), too_small(9));
    assert_eq!(
        bitmap.draw_on_rows(&mut [0; 9], Geometry { stride: usize::MAX, ..rows }, at, op),
        too_small(usize::MAX)
    );
}

#[test]
fn nothing_is_drawn_on_nothing() {
    let empty = Bitmap::<BinaryColor>::new(&[], 0, u32::MAX).expect("no bytes");
    let everything = Bitmap::<BinaryColor>::new(&FACE, 8, 8).expect("eight bytes");
    for size in [(0, 0), (0, 9), (9, 0), (0, u32::MAX), (u32::MAX, 0)] {
        let (rows, pages) = (Geometry::rows::<BinaryColor>(size.0, size.1), Geometry::pages(size.0, size.1));
        for bitmap in [empty, everything] {
            assert_eq!(bitmap.draw_on_rows(&mut [], rows, Point::zero(), RasterOp::Copy), Ok(()));
            assert_eq!(bitmap.draw_on_pages(&mut [], pages, Point::zero(), RasterOp::Copy), Ok(()));
        }
        assert_eq!(scroll_rows(&mut [], rows, Point::new(1, 1), BinaryColor::On), Ok(()));
        assert_eq!(scroll_pages(&mut [], pages, Point::new(1, 1), BinaryColor::On), Ok(()));
    }
}
