//! The slow truth about dirty lines: memory before and after, byte by byte.

use core::{fmt::Debug, marker::PhantomData, ops::Range};

use aquatint::{
    Changed, Code, Dirty, DirtyWindow, Frame, Grain, Rect, Spacing, Target, Tracked, display::layout::Layout,
};
use embedded_graphics::{
    draw_target::DrawTarget,
    geometry::{Point, Size},
    image::GetPixel,
};
use proptest::{prelude::*, sample::select};

use crate::reference::steps::Step;

/// A frame, what is in it, and how it is tracked and sent.
#[derive(Clone, Debug)]
pub struct Scene {
    pub size: Size,
    /// Whether there are bytes around the lines.
    pub gaps: bool,
    pub seed: u8,
    pub entries: usize,
    pub grain: Grain,
}

pub fn scene() -> impl Strategy<Value = Scene> {
    // In every layout, long lines are drawn on in several blocks.
    let size = prop_oneof![11 => (1..70_u32, 1..20_u32), 1 => (100..1200_u32, 1..4_u32)];
    let size = size.prop_map(|(width, height)| Size::new(width, height));
    let entries = prop_oneof![3 => Just(64_usize), 1 => 0..8_usize];
    (size, any::<bool>(), any::<u8>(), entries, grain()).prop_map(|(size, gaps, seed, entries, grain)| Scene {
        size,
        gaps,
        seed,
        entries,
        grain,
    })
}

fn grain() -> impl Strategy<Value = Grain> {
    let known = vec![
        Grain::BYTES,
        Grain::SSD1306,
        Grain::SSD1322,
        Grain::SSD1680,
        Grain::ST7306,
        Grain::ST7920,
        Grain::SHARP,
        Grain { columns: u32::MAX, rows: u32::MAX, overhead: u32::MAX },
    ];
    let any = (0..20_u32, 0..20_u32, 0..40_u32);
    prop_oneof![select(known), any.prop_map(|(columns, rows, overhead)| Grain { columns, rows, overhead })]
}

/// Memory of a frame with guards before and behind, and how to look at it.
pub struct Canvas<C, L> {
    pub memory: Vec<u8>,
    size: Size,
    spacing: Spacing,
    packing: PhantomData<(C, L)>,
}

impl<C, L> Clone for Canvas<C, L> {
    fn clone(&self) -> Self {
        Self { memory: self.memory.clone(), packing: PhantomData, ..*self }
    }
}

/// Bytes before and behind the memory of the frame.
const MARGIN: usize = 5;

impl<C: Code + Debug, L: Layout<C>> Canvas<C, L> {
    const PLANES: usize = L::SHAPE.planes as usize;

    /// With any bytes in it.
    pub fn new(scene: &Scene) -> Self {
        let size = scene.size;
        let shortest = L::SHAPE.stride(size.width, size.height);
        let packed = Spacing { before: 0, stride: shortest };
        let spacing = if scene.gaps { Spacing { before: 3, stride: shortest + 2 } } else { packed };
        let lines = usize::try_from(L::SHAPE.lines(size.width, size.height)).expect("few");
        let length = 2 * MARGIN + spacing.before + lines * spacing.stride;
        // Long stretches alike, so that some of what is drawn changes nothing.
        let memory = (0..length).map(|at| if at % 7 < 5 { scene.seed } else { scene.seed.wrapping_mul(7) }).collect();
        Self { memory, size, spacing, packing: PhantomData }
    }

    pub fn frame(&mut self) -> Frame<C, L, &mut [u8]> {
        let end = self.memory.len() - MARGIN;
        Frame::with_spacing(&mut self.memory[MARGIN..end], self.size, self.spacing).expect("enough")
    }

    /// Lines of one plane.
    pub fn lines(&self) -> usize {
        usize::try_from(L::SHAPE.lines(self.size.width, self.size.height)).expect("few") / Self::PLANES
    }

    pub fn line_bytes(&self) -> usize {
        L::SHAPE.stride(self.size.width, self.size.height)
    }

    /// Where a byte of a line is in memory.
    fn at(&self, plane: usize, line: usize, byte: usize) -> usize {
        MARGIN + self.spacing.before + (plane * self.lines() + line) * self.spacing.stride + byte
    }

    /// What becomes of bytes of zeros where an area is filled with what makes all bits ones.
    pub fn filled(&self, area: Rect) -> [Vec<u8>; 2] {
        let mut canvas = self.clone();
        canvas.memory.fill(0);
        let blank = canvas.memory.clone();
        let zero = canvas.frame().pixel(Point::zero()).expect("a pixel").code();
        let Ok(()) = canvas.frame().fill_solid(&area.into(), C::from_code(!zero));
        [blank, canvas.memory]
    }

    /// Changes single bits.
    pub fn scatter(&mut self, noise: &[u8]) {
        for &byte in noise {
            let (line, at) = (usize::from(byte) % self.lines(), usize::from(byte) * 5 % self.line_bytes());
            let at = self.at(usize::from(byte) / 2 % Self::PLANES, line, at);
            self.memory[at] ^= 1 << (byte % 8);
        }
    }

    /// This memory with the lines of another one in it.
    pub fn with_lines_of(&self, other: &Self) -> Vec<u8> {
        let mut canvas = self.clone();
        canvas.copy_lines(other);
        canvas.memory
    }

    pub fn copy_lines(&mut self, other: &Self) {
        for plane in 0..Self::PLANES {
            for line in 0..self.lines() {
                for byte in 0..self.line_bytes() {
                    let at = self.at(plane, line, byte);
                    self.memory[at] = other.memory[other.at(plane, line, byte)];
                }
            }
        }
    }

    pub fn nothing(&self) -> Vec<Range<usize>> {
        vec![0..0; self.lines()]
    }

    /// From the first to the last byte of each line that was another one before, in any plane.
    pub fn differences(&self, old: &[u8]) -> Vec<Range<usize>> {
        let differs = |line, byte| {
            (0..Self::PLANES).map(move |plane| self.at(plane, line, byte)).any(|at| self.memory[at] != old[at])
        };
        let line = |line| {
            let changed: Vec<_> = (0..self.line_bytes()).filter(|&byte| differs(line, byte)).collect();
            changed.first().zip(changed.last()).map_or(0..0, |(first, last)| *first..last + 1)
        };
        (0..self.lines()).map(line).collect()
    }

    /// Draws a step without tracking; single pixels are calls of their own.
    pub fn draw(&mut self, step: &Step) -> Vec<Range<usize>> {
        let calls = match step {
            Step::DrawIter(pixels) => pixels.iter().map(|pixel| Step::DrawIter(vec![*pixel])).collect(),
            call => vec![call.clone()],
        };
        let mut changed = self.nothing();
        for call in calls {
            let old = self.memory.clone();
            call.draw(&mut self.frame());
            join(&mut changed, &self.differences(&old));
        }
        changed
    }

    pub fn track(&mut self, dirty: &mut Dirty<Vec<Changed>>, draw: impl FnOnce(&mut Tracked<'_, C, L, &mut [u8]>)) {
        draw(&mut dirty.track(&mut self.frame()));
    }

    /// Holds the windows against what changed in each line.
    pub fn check_windows(&mut self, dirty: &Dirty<Vec<Changed>>, changed: &[Range<usize>], old: &[u8], grain: Grain) {
        let canvas = self.clone();
        let frame = self.frame();
        let base = frame.memory().as_ptr().addr() - MARGIN;
        let mut panel = old.to_vec();
        let (mut cost, mut last) = (0, i32::MIN);
        for window in dirty.windows(&frame, grain) {
            let area = window.area();
            assert_eq!(area.intersection(frame.bounds()), area);
            assert!(is_aligned(area.columns(), canvas.size.width, grain.columns), "{area:?}");
            assert!(is_aligned(area.rows(), canvas.size.height, grain.rows), "{area:?}");
            let lines = if L::SHAPE.is_vertical { area.columns() } else { area.rows() };
            assert!(!area.is_empty() && lines.start >= last, "windows share no line");
            last = lines.end;

            check_bytes(&window, Self::PLANES);
            (0..Self::PLANES).for_each(|plane| check_bytes(&window.clone().plane(plane), 1));
            let places = window.slices().flat_map(|slice| (0..slice.len()).map(|at| slice.as_ptr().addr() - base + at));
            let places: Vec<_> = places.collect();
            assert_eq!(places, canvas.places(area), "slices are the bytes of the area");
            window.slices().flatten().zip(&places).for_each(|(byte, &at)| panel[at] = *byte);
            cost += window.byte_len() as u64 + u64::from(grain.overhead);
        }
        // What the panel shows now is the frame.
        let mut shown = canvas.clone();
        shown.memory = panel;
        assert_eq!(self.with_lines_of(&shown), self.memory);
        assert!(cost <= self.most(changed, grain), "joined windows cost less");
        assert_eq!(cost == 0, changed.iter().all(Range::is_empty), "a window for a change, none for none");
    }

    /// Where the bytes of an area are: what a fill turns over.
    fn places(&self, area: Rect) -> Vec<usize> {
        let [_, filled] = self.filled(area);
        (0..filled.len()).filter(|&at| filled[at] != 0).collect()
    }

    /// What a window for each row of tiles would cost.
    fn most(&self, changed: &[Range<usize>], grain: Grain) -> u64 {
        let shape = L::SHAPE;
        let along = 8 / (shape.bits * shape.rows_per_line);
        let (across_grain, along_grain) =
            if shape.is_vertical { (grain.columns, grain.rows) } else { (grain.rows, grain.columns) };
        // The fewest lines, and bytes, that are whole tiles; or all.
        let lines = fewest(self.lines(), shape.rows_per_line, across_grain);
        let bytes = fewest(self.line_bytes(), along, along_grain);
        let band = |band: &[Range<usize>]| {
            let Range { start, end } = hull(band);
            let wide = (end.div_ceil(bytes) * bytes).min(self.line_bytes()) - start / bytes * bytes;
            if start == end { 0 } else { (Self::PLANES * band.len() * wide) as u64 + u64::from(grain.overhead) }
        };
        changed.chunks(lines).map(band).sum()
    }
}

/// How many units of some pixels are whole grains; `all` if no fewer are.
fn fewest(all: usize, pixels: u32, grain: u32) -> usize {
    let whole = |units: &usize| (*units as u64 * u64::from(pixels)).is_multiple_of(grain.max(1).into());
    (1..all).find(whole).unwrap_or(all.max(1))
}

fn is_aligned(pixels: Range<i32>, size: u32, grain: u32) -> bool {
    let multiple = |at: i32| at.cast_unsigned().is_multiple_of(grain.max(1));
    multiple(pixels.start) && (multiple(pixels.end) || pixels.end.cast_unsigned() == size)
}

/// The three ways to the bytes of a window are one.
fn check_bytes(window: &DirtyWindow, planes: usize) {
    let slices: Vec<&[u8]> = window.slices().collect();
    let bytes = slices.concat();
    let mut memory = vec![0; bytes.len() + 1];
    assert_eq!(window.copy_to(&mut memory), Ok(&bytes[..]));
    assert_eq!(window.copy_to(&mut memory[1..]), Ok(&bytes[..]));
    assert_eq!(window.copy_to(&mut memory[2..]).map_err(|error| error.needed), Err(bytes.len()));
    assert_eq!(window.byte_len(), bytes.len());
    match window.contiguous() {
        Some(all) => assert_eq!((all.as_ptr(), all), (slices[0].as_ptr(), &bytes[..])),
        None => assert!(planes > 1 || slices.windows(2).any(|pair| pair[0].as_ptr_range().end != pair[1].as_ptr())),
    }
}

/// From the first beginning to the last end, of those that are not empty.
pub fn hull(ranges: &[Range<usize>]) -> Range<usize> {
    let ranges = || ranges.iter().filter(|range| !range.is_empty());
    let start = ranges().map(|range| range.start).min();
    start.zip(ranges().map(|range| range.end).max()).map_or(0..0, |(start, end)| start..end)
}

pub fn join(changed: &mut [Range<usize>], more: &[Range<usize>]) {
    for (changed, more) in changed.iter_mut().zip(more) {
        *changed = hull(&[changed.clone(), more.clone()]);
    }
}
