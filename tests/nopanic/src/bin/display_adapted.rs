//! Frames seen through what changes places; blits, and what has changed.
#![no_std]
#![no_main]

use core::convert::Infallible;

use aquatint::{
    Blit, Changed, Columns, Dirty, Frame, Grain, Inside, Light, LsbFirst, OnDrawTarget, Pages, PerPixel, Planes,
    RasterOp, Rows, Runs, Target, Turn, Turned, Window, Words,
    display::{
        blit::{Coded, Part},
        layout::Layout,
    },
};
use embedded_graphics::{
    image::GetPixel,
    pixelcolor::{BinaryColor, Gray2, Gray4},
    prelude::*,
};
use nopanic::{any, endless, keep, lent, near, near_rectangle, one_of, side, some};

/// What a caller lends.
struct Memory {
    bytes: [u8; 4096],
    other: [u8; 4096],
    bits: [u8; 512],
    changed: [Changed; 16],
}

const MEMORY: Memory = Memory { bytes: [0; 4096], other: [0; 4096], bits: [0; 512], changed: [Changed::NOTHING; 16] };

nopanic::entries! { MEMORY;
    window_rows = window::<BinaryColor, Rows>,
    window_pages = window::<BinaryColor, Pages>,
    window_light = window::<Light, Words>,
    turned_rows = turned::<BinaryColor, Rows>,
    turned_pages = turned::<BinaryColor, Pages>,
    turned_light = turned::<Light, Words>,
    on_draw_target_rows = on_draw_target::<BinaryColor, Rows>,
    on_draw_target_light = on_draw_target::<Light, Words>,
    per_pixel_runs = per_pixel::<BinaryColor, Rows>,
    copy_within_rows = copy_within::<BinaryColor, Rows>,
    copy_within_pages = copy_within::<BinaryColor, Pages>,
    copy_within_columns = copy_within::<BinaryColor, Columns<LsbFirst>>,
    copy_within_planes = copy_within::<Gray2, Planes>,
    copy_within_grey = copy_within::<Gray4, Rows>,
    copy_within_light = copy_within::<Light, Words>,
    blit_rows = blit::<BinaryColor, Rows>,
    blit_pages = blit::<BinaryColor, Pages>,
    blit_columns = blit::<BinaryColor, Columns<LsbFirst>>,
    blit_planes = blit::<Gray2, Planes>,
    blit_grey = blit::<Gray4, Rows>,
    blit_light = blit::<Light, Words>,
    blit_window_rows = blit_window::<BinaryColor, Rows>,
    blit_window_grey = blit_window::<Gray4, Rows>,
    blit_masked_rows = masked::<BinaryColor, Rows>,
    blit_masked_pages = masked::<BinaryColor, Pages>,
    blit_masked_grey = masked::<Gray4, Rows>,
    paint_rows = paint::<BinaryColor, Rows, Rows>,
    paint_pages = paint::<BinaryColor, Pages, Pages>,
    paint_planes = paint::<Gray2, Planes, Rows>,
    paint_grey = paint::<Gray4, Rows, Rows>,
    paint_light = paint::<Light, Words, Pages>,
    paint_light_by_columns = paint::<Light, Words, Columns<LsbFirst>>,
    tracked_rows = tracked::<BinaryColor, Rows>,
    tracked_pages = tracked::<BinaryColor, Pages>,
    tracked_light = tracked::<Light, Words>,
    dirty_compare_rows = compared::<BinaryColor, Rows>,
    dirty_compare_pages = compared::<BinaryColor, Pages>,
    dirty_compare_planes = compared::<Gray2, Planes>,
    dirty_compare_light = compared::<Light, Words>,
    dirty_windows_rows = windows::<BinaryColor, Rows>,
    dirty_windows_pages = windows::<BinaryColor, Pages>,
    dirty_windows_planes = windows::<Gray2, Planes>,
}

type Lent<'a, C, L> = Frame<C, L, &'a mut [u8]>;

fn frame<C: Coded, L: Layout<C>>(bytes: &mut [u8]) -> Option<Lent<'_, C, L>> {
    Lent::new(lent(bytes), side(), side()).ok()
}

fn color<C: Coded>() -> C {
    C::from_number(any())
}

/// As one of this crate's targets and as one of embedded-graphics.
fn drawn_on<C: Coded, T>(target: &mut T)
where
    T: Target<Color = C, Error = Infallible> + DrawTarget<Color = C, Error = Infallible>,
{
    let Ok(()) = target.fill_run(any(), any()..any(), [color()]);
    let Ok(()) = target.fill_run(any(), any()..any(), [color(); 8]);
    let Ok(()) = target.write_run(any(), near(), endless(|| any::<bool>().then(color)));
    let Ok(()) = target.write_all(any(), near(), endless(color));
    let Ok(()) = target.set(any(), any(), color());
    let Ok(()) = target.fill_bits(any(), any()..any(), [color(); 2], any());
    let Ok(()) = target.write_bits(any(), near(), [color(); 2], any::<u8>);
    let Ok(()) = target.fill_tile(any(), &[[color(); 8]; 8]);
    let Ok(()) = target.draw_iter([Pixel(any(), color()); 3]);
    let Ok(()) = target.fill_solid(&any(), color());
    let Ok(()) = target.fill_contiguous(&near_rectangle(), endless(color));
    let Ok(()) = target.clear(color());
}

fn window<C: Coded, L: Layout<C>>(memory: &mut Memory) {
    let Some(mut frame) = frame::<C, L>(&mut memory.bytes) else { return };
    let mut window = Window::part(&mut frame, any());
    drawn_on(&mut window);
    keep(window.pixel(any()));
}

fn turned<C: Coded, L: Layout<C>>(memory: &mut Memory) {
    let Some(mut frame) = frame::<C, L>(&mut memory.bytes) else { return };
    let mut turned = Turned::new(
        &mut frame,
        one_of(&[Turn::Clockwise, Turn::Half, Turn::CounterClockwise, Turn::MirroredTopBottom]),
    );
    drawn_on(&mut turned);
    keep((turned.pixel(any()), turned.size()));
}

fn on_draw_target<C: Coded, L: Layout<C>>(memory: &mut Memory) {
    let Some(mut frame) = frame::<C, L>(&mut memory.bytes) else { return };
    let mut band = Window::band(&mut frame, any());
    drawn_on(&mut OnDrawTarget::new(&mut band));
}

fn per_pixel<C: Coded + PartialEq, L: Layout<C>>(memory: &mut Memory) {
    let Some(mut frame) = frame::<C, L>(&mut memory.bytes) else { return };
    let inside = if any() { Inside::Like(color()) } else { Inside::Unlike(color()) };
    keep(PerPixel::new(&mut frame).runs(any(), inside, any(), any()));
}

fn copy_within<C: Coded, L: Layout<C>>(memory: &mut Memory) {
    let Some(mut frame) = frame::<C, L>(&mut memory.bytes) else { return };
    frame.copy_within(any(), any());
    frame.scroll(any(), any(), color());
}

fn op() -> RasterOp {
    one_of(&[RasterOp::Copy, RasterOp::Or, RasterOp::AndNot, RasterOp::Xor])
}

fn blit<C: Coded, L: Layout<C>>(memory: &mut Memory) {
    let Some(mut frame) = frame::<C, L>(&mut memory.bytes) else { return };
    let Ok(source) = Frame::<C, L, _>::with_slice(some(&mut memory.other), side(), side()) else { return };
    frame.blit(&source, any(), op());
    frame.blit(source.part(any()).part(any()), any(), op());
}

fn blit_window<C: Coded, L: Layout<C>>(memory: &mut Memory) {
    let Some(mut frame) = frame::<C, L>(&mut memory.bytes) else { return };
    let Ok(source) = Frame::<C, L, _>::with_slice(some(&mut memory.other), side(), side()) else { return };
    Window::part(&mut frame, any()).blit(source.part(any()), any(), op());
}

fn masked<C: Coded, L: Layout<C> + Layout<BinaryColor>>(memory: &mut Memory) {
    let Some(mut frame) = frame::<C, L>(&mut memory.bytes) else { return };
    let Ok(source) = Frame::<C, L, _>::with_slice(some(&mut memory.other), side(), side()) else { return };
    let Ok(mask) = Frame::<BinaryColor, L, _>::with_slice(some(&mut memory.bits), side(), side()) else { return };
    frame.blit(source.part(any()).with_mask(&mask), any(), op());
    Window::part(&mut frame, any()).blit(source.part(any()).with_mask(&mask), any(), op());
}

fn paint<C: Coded, L: Layout<C>, M: Layout<BinaryColor>>(memory: &mut Memory) {
    let Some(mut frame) = frame::<C, L>(&mut memory.bytes) else { return };
    let Ok(shape) = Frame::<BinaryColor, M, _>::with_slice(some(&mut memory.bits), side(), side()) else { return };
    frame.paint(&shape, any(), color());
    Window::band(&mut frame, any()).paint(Part::from(&shape).part(any()), any(), color());
}

fn tracked<C: Coded, L: Layout<C>>(memory: &mut Memory) {
    let Some(mut frame) = frame::<C, L>(&mut memory.bytes) else { return };
    let mut dirty = Dirty::new(lent(&mut memory.changed));
    dirty.mark(&frame, any());
    let mut tracked = dirty.track(&mut frame);
    drawn_on(&mut tracked);
    keep(tracked.pixel(any()));
}

fn compared<C: Coded, L: Layout<C>>(memory: &mut Memory) {
    let (width, height) = (side(), side());
    let Ok(frame) = Lent::<C, L>::new(lent(&mut memory.bytes), width, height) else { return };
    let height = if any() { height } else { side() };
    let Ok(mut shown) = Lent::<C, L>::new(lent(&mut memory.other), width, height) else { return };
    let mut dirty = Dirty::new(lent(&mut memory.changed));
    dirty.compare(&frame, &shown);
    dirty.copy(&frame, &mut shown);
    keep((dirty.is_clean(), dirty.entries().iter().map(|entry| entry.bytes(any()).len()).max()));
}

fn windows<C: Coded, L: Layout<C>>(memory: &mut Memory) {
    let Some(frame) = frame::<C, L>(&mut memory.bytes) else { return };
    let mut dirty = Dirty::new(lent(&mut memory.changed));
    dirty.mark(&frame, any());
    dirty.mark(&frame, any());
    for window in dirty.windows(&frame, Grain { columns: any(), rows: any(), overhead: any() }) {
        let window = window.plane(any());
        window.slices().for_each(keep);
        keep((window.area(), window.byte_len(), window.contiguous(), window.copy_to(lent(&mut memory.bits)).is_ok()));
    }
    dirty.clear();
    dirty.mark_all();
}
