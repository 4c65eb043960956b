//! Frames of every layout and depth: drawing, reading, blits, windows, turns, dirty windows, other byte orders.
#![no_std]
#![no_main]

use core::{convert::Infallible, hint::black_box};

use aquatint::{
    Blit, Changed, Columns, Dirty, FourColor, Frame, Grain, Inside, Inverted, Light, LsbFirst, MsbFirst, OnDrawTarget,
    Pages, PerPixel, Planes, RasterOp, Rgb332, Rows, Runs, SevenColor, SixColor, Target, ThreeColor, Turn, Turned,
    Window, Words,
    display::{
        blit::{Coded, Part},
        frame::Spacing,
        layout::{Layout, Shape},
        reencode,
        transpose::{BitOrder, Transpose},
    },
};
use embedded_graphics::{
    image::GetPixel,
    pixelcolor::{BinaryColor, Gray2, Gray4, Gray8, Rgb565},
    prelude::*,
};
use nopanic::{any, keep, lent, part};

#[cortex_m_rt::entry]
fn main() -> ! {
    one_bit();
    more_bits();
    colours();
    shape();
    reencode();
    transpose();
    loop {}
}

fn one_bit() {
    let color = black_box(BinaryColor::On);
    everything::<_, Rows>(color);
    everything::<_, Pages>(color);
    everything::<_, Columns<LsbFirst>>(color);
    frame::<_, Rows<LsbFirst>>(color);
    frame::<_, Pages<MsbFirst>>(color);
    frame::<_, Columns>(color);
    frame::<_, Inverted<Rows>>(color);
    frame::<_, Inverted<Pages>>(color);
    masked::<BinaryColor, Rows>();
    masked::<BinaryColor, Pages>();
    masked::<Gray4, Rows>();
}

fn more_bits() {
    frame::<_, Rows>(black_box(Gray2::BLACK));
    everything::<_, Planes>(black_box(Gray2::BLACK));
    frame::<_, Inverted<Planes<LsbFirst>>>(black_box(Gray2::BLACK));
    everything::<_, Rows>(black_box(Gray4::BLACK));
    frame::<_, Rows<LsbFirst>>(black_box(Gray4::BLACK));
    frame::<_, Rows>(black_box(Gray8::BLACK));
}

fn colours() {
    everything::<_, Words>(any::<Light>());
    frame::<_, Words<LsbFirst>>(black_box(Rgb565::BLACK));
    frame::<_, Rows>(Rgb332::new(any(), any(), any()));
    frame::<_, Planes>(black_box(ThreeColor::Black));
    frame::<_, Rows>(black_box(FourColor::Black));
    frame::<_, Rows>(black_box(SixColor::Black));
    frame::<_, Rows>(black_box(SevenColor::Black));
}

type Lent<'a, C, L> = Frame<C, L, &'a mut [u8]>;

/// Drawing and reading.
#[inline(never)]
fn frame<C: Coded + PartialEq, L: Layout<C>>(color: C) {
    let mut bytes = [0; 512];
    let Ok(mut frame) = Lent::<C, L>::new(lent(&mut bytes), any(), any()) else { return };
    drawn_on(&mut frame, color);
    keep((frame.bytes(), frame.memory(), frame.plane(any()), frame.stride(), frame.size()));
    frame.lines().for_each(keep);
    keep((frame.pixel(any()), frame.runs(any(), Inside::Like(color), any(), any())));
}

/// All that a frame can do.
#[inline(never)]
fn everything<C: Coded + PartialEq, L: Layout<C>>(color: C) {
    frame::<C, L>(color);
    let mut bytes = [0; 512];
    keep((Frame::<C, L, _>::with_array([0; 64], any(), any()).is_ok(), Frame::<C, L, ()>::bytes_needed(any(), any())));
    keep(Frame::<C, L, _>::with_slice(part(&bytes), any(), any()).is_ok());
    let spacing = Spacing { before: any(), stride: any() };
    let Ok(mut frame) = Lent::<C, L>::with_spacing(lent(&mut bytes), any(), spacing) else { return };
    keep(PerPixel::new(&mut frame).runs(any(), black_box(Inside::Unlike(color)), any(), any()));
    adapted(&mut frame, color);
    frame.copy_within(any(), any());
    frame.scroll(any(), any(), color);
    blits::<C, L>(&mut frame, color);
    dirty::<C, L>(&mut frame, color);
}

/// As one of this crate's targets and as one of embedded-graphics.
fn drawn_on<C: PixelColor, T>(target: &mut T, color: C)
where
    T: Target<Color = C, Error = Infallible> + DrawTarget<Color = C, Error = Infallible>,
{
    let Ok(()) = target.fill_run(any(), any()..any(), [color]);
    let Ok(()) = target.fill_run(any(), any()..any(), [color, color, color]);
    let Ok(()) = target.fill_run(any(), any()..any(), [color; 8]);
    let Ok(()) = target.write_run(any(), any()..any(), core::iter::repeat_with(|| any::<bool>().then_some(color)));
    let Ok(()) = target.write_all(any(), any()..any(), core::iter::repeat(color));
    let Ok(()) = target.set(any(), any(), color);
    let Ok(()) = target.fill_bits(any(), any()..any(), [color; 2], any());
    let Ok(()) = target.write_bits(any(), any()..any(), [color; 2], any::<u8>);
    let Ok(()) = target.fill_tile(any(), &black_box([[color; 8]; 8]));
    let Ok(()) = target.draw_iter([Pixel(any(), color); 3]);
    let Ok(()) = target.fill_solid(&any(), color);
    let Ok(()) = target.fill_contiguous(&any(), core::iter::repeat_n(color, any()));
    let Ok(()) = target.clear(color);
}

/// Seen through what changes places.
fn adapted<C: PixelColor, L: Layout<C>>(frame: &mut Frame<C, L, &mut [u8]>, color: C) {
    let mut window = Window::part(frame, any());
    drawn_on(&mut window, color);
    keep(window.pixel(any()));
    let mut turned = Turned::new(frame, black_box(Turn::Half));
    drawn_on(&mut turned, color);
    keep((turned.pixel(any()), turned.size()));
    let mut band = Window::band(frame, any());
    let mut display = OnDrawTarget::new(&mut band);
    drawn_on(&mut display, color);
}

fn blits<C: Coded, L: Layout<C>>(frame: &mut Frame<C, L, &mut [u8]>, color: C) {
    let (source, op) = ([0; 64], black_box(RasterOp::Copy));
    let Ok(source) = Frame::<C, L, _>::with_slice(part(&source), any(), any()) else { return };
    frame.blit(&source, any(), op);
    frame.blit(source.part(any()).part(any()), any(), op);
    Window::part(frame, any()).blit(source.part(any()), any(), op);
    paints::<_, _, Rows>(frame, color);
    paints::<_, _, Pages>(frame, color);
    paints::<_, _, Columns<LsbFirst>>(frame, color);
}

fn paints<C: Coded, L: Layout<C>, M: Layout<BinaryColor>>(frame: &mut Frame<C, L, &mut [u8]>, color: C) {
    let bits = [0; 64];
    let Ok(shape) = Frame::<BinaryColor, M, _>::with_slice(part(&bits), any(), any()) else { return };
    frame.paint(&shape, any(), color);
    Window::band(frame, any()).paint(Part::from(&shape).part(any()), any(), color);
}

fn masked<C: Coded, L: Layout<C> + Layout<BinaryColor>>() {
    let (bits, mut bytes) = ([0; 64], [0; 64]);
    let Ok(mask) = Frame::<BinaryColor, L, _>::with_slice(part(&bits), any(), any()) else { return };
    let Ok(source) = Frame::<C, L, _>::with_slice(part(&bits), any(), any()) else { return };
    let Ok(mut rows) = Frame::<C, L, _>::new(lent(&mut bytes), any(), any()) else { return };
    rows.blit(source.part(any()).with_mask(&mask), any(), black_box(RasterOp::Copy));
    Window::part(&mut rows, any()).blit(source.part(any()).with_mask(&mask), any(), black_box(RasterOp::Copy));
}

fn shape() {
    let shape = Shape { is_vertical: any(), rows_per_line: any(), bits: any(), planes: any() };
    keep((shape.stride(any(), any()), shape.lines(any(), any())));
}

fn dirty<C: PixelColor, L: Layout<C>>(frame: &mut Frame<C, L, &mut [u8]>, color: C) {
    let (mut entries, mut other) = ([Changed::NOTHING; 16], [0; 512]);
    let mut dirty = Dirty::new(lent(&mut entries));
    dirty.mark(frame, any());
    let mut tracked = dirty.track(frame);
    drawn_on(&mut tracked, color);
    keep(tracked.pixel(any()));
    let Ok(mut shown) = Frame::<C, L, _>::new(lent(&mut other), any(), any()) else { return };
    dirty.compare(frame, &shown);
    dirty.copy(frame, &mut shown);
    keep((dirty.is_clean(), dirty.entries().iter().map(|entry| entry.bytes(any()).len()).max()));
    let mut memory = [0; 64];
    for window in dirty.windows(frame, Grain { columns: any(), rows: any(), overhead: any() }) {
        let window = window.plane(any());
        window.slices().for_each(keep);
        keep((window.area(), window.byte_len(), window.contiguous(), window.copy_to(lent(&mut memory)).is_ok()));
    }
    dirty.clear();
    dirty.mark_all();
}

fn reencode() {
    let (rows, mut out) = ([0; 64], [0; 64]);
    keep((reencode::st7306_bytes(any()), reencode::it8951_bytes(any())));
    keep(reencode::st7306_tiles([part(&rows), part(&rows)], any(), lent(&mut out)));
    keep(reencode::it8951_words(part(&rows), any(), lent(&mut out)));
    reencode::it8951_in_place(lent(&mut out));
}

fn transpose() {
    let (rows, mut pages) = ([0; 64], [0; 64]);
    let order = black_box(BitOrder::HighFirst);
    let transpose = Transpose::new(any(), any()).with_orders(order, black_box(order));
    keep(transpose.rows_to_pages(part(&rows), lent(&mut pages)));
    keep(transpose.pages_to_rows(part(&rows), lent(&mut pages)));
}
