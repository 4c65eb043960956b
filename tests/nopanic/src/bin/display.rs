//! Frames of every layout and depth: drawing and reading.
#![no_std]
#![no_main]

use core::convert::Infallible;

use aquatint::{
    Columns, FourColor, Frame, Inside, Inverted, Light, LsbFirst, MsbFirst, Pages, Planes, Rgb332, Rows, Runs,
    SevenColor, SixColor, Target, ThreeColor, Words,
    display::{
        blit::Coded,
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
use nopanic::{any, endless, keep, lent, near, near_rectangle, one_of, part, side, some};

/// What a caller lends.
struct Memory {
    bytes: [u8; 4096],
    other: [u8; 256],
}

const MEMORY: Memory = Memory { bytes: [0; 4096], other: [0; 256] };

nopanic::entries! { MEMORY;
    fill_run_rows = fill_run::<BinaryColor, Rows>,
    fill_run_pages = fill_run::<BinaryColor, Pages>,
    fill_run_columns = fill_run::<BinaryColor, Columns>,
    fill_run_grey_2 = fill_run::<Gray2, Rows>,
    fill_run_planes = fill_run::<Gray2, Planes>,
    fill_run_grey_4 = fill_run::<Gray4, Rows>,
    fill_run_grey_8 = fill_run::<Gray8, Rows>,
    fill_run_light = fill_run::<Light, Words>,
    write_run_rows = write_run::<BinaryColor, Rows>,
    write_run_pages = write_run::<BinaryColor, Pages>,
    write_run_columns = write_run::<BinaryColor, Columns>,
    write_run_grey_2 = write_run::<Gray2, Rows>,
    write_run_planes = write_run::<Gray2, Planes>,
    write_run_grey_4 = write_run::<Gray4, Rows>,
    write_run_grey_8 = write_run::<Gray8, Rows>,
    write_run_light = write_run::<Light, Words>,
    bits_rows = bits::<BinaryColor, Rows>,
    bits_pages = bits::<BinaryColor, Pages>,
    bits_columns = bits::<BinaryColor, Columns>,
    bits_planes = bits::<Gray2, Planes>,
    bits_grey_4 = bits::<Gray4, Rows>,
    bits_light = bits::<Light, Words>,
    fill_tile_rows = fill_tile::<BinaryColor, Rows>,
    fill_tile_pages = fill_tile::<BinaryColor, Pages>,
    fill_tile_planes = fill_tile::<Gray2, Planes>,
    fill_tile_grey_4 = fill_tile::<Gray4, Rows>,
    fill_tile_light = fill_tile::<Light, Words>,
    draw_target_rows = draw_target::<BinaryColor, Rows>,
    draw_target_pages = draw_target::<BinaryColor, Pages>,
    draw_target_columns = draw_target::<BinaryColor, Columns>,
    draw_target_planes = draw_target::<Gray2, Planes>,
    draw_target_grey_4 = draw_target::<Gray4, Rows>,
    draw_target_light = draw_target::<Light, Words>,
    read_rows = read::<BinaryColor, Rows>,
    read_pages = read::<BinaryColor, Pages>,
    read_columns = read::<BinaryColor, Columns>,
    read_planes = read::<Gray2, Planes>,
    read_grey_4 = read::<Gray4, Rows>,
    read_light = read::<Light, Words>,
    everything_rows_lsb = everything::<BinaryColor, Rows<LsbFirst>>,
    everything_pages_msb = everything::<BinaryColor, Pages<MsbFirst>>,
    everything_columns_lsb = everything::<BinaryColor, Columns<LsbFirst>>,
    everything_inverted_rows = everything::<BinaryColor, Inverted<Rows>>,
    everything_inverted_pages = everything::<BinaryColor, Inverted<Pages>>,
    everything_inverted_planes = everything::<Gray2, Inverted<Planes<LsbFirst>>>,
    everything_grey_4_lsb = everything::<Gray4, Rows<LsbFirst>>,
    everything_rgb565 = everything::<Rgb565, Words<LsbFirst>>,
    everything_rgb332 = everything::<Rgb332, Rows>,
    everything_three_colours = everything::<ThreeColor, Planes>,
    everything_four_colours = everything::<FourColor, Rows>,
    everything_six_colours = everything::<SixColor, Rows>,
    everything_seven_colours = everything::<SevenColor, Rows>,
    frame_new,
    shape,
    st7306_tiles,
    it8951_words,
    it8951_in_place,
    rows_to_pages,
    pages_to_rows,
}

type Lent<'a, C, L> = Frame<C, L, &'a mut [u8]>;

fn frame<C: Coded, L: Layout<C>>(memory: &mut Memory) -> Option<Lent<'_, C, L>> {
    Lent::new(lent(&mut memory.bytes), side(), side()).ok()
}

fn color<C: Coded>() -> C {
    C::from_number(any())
}

fn fill_run<C: Coded, L: Layout<C>>(memory: &mut Memory) {
    let Some(mut frame) = frame::<C, L>(memory) else { return };
    let Ok(()) = frame.fill_run(any(), any()..any(), [color()]);
    let Ok(()) = frame.fill_run(any(), any()..any(), [color(), color(), color()]);
    let Ok(()) = frame.fill_run(any(), any()..any(), [color(); 8]);
    let Ok(()) = frame.set(any(), any(), color());
}

fn write_run<C: Coded, L: Layout<C>>(memory: &mut Memory) {
    let Some(mut frame) = frame::<C, L>(memory) else { return };
    let Ok(()) = frame.write_run(any(), near(), endless(|| any::<bool>().then(color)));
    let Ok(()) = frame.write_all(any(), near(), endless(color));
}

fn bits<C: Coded, L: Layout<C>>(memory: &mut Memory) {
    let Some(mut frame) = frame::<C, L>(memory) else { return };
    let Ok(()) = frame.fill_bits(any(), any()..any(), [color(); 2], any());
    let Ok(()) = frame.write_bits(any(), near(), [color(), color()], any::<u8>);
}

fn fill_tile<C: Coded, L: Layout<C>>(memory: &mut Memory) {
    let Some(mut frame) = frame::<C, L>(memory) else { return };
    let Ok(()) = frame.fill_tile(any(), &[[color(); 8]; 8]);
}

fn draw_target<C: Coded, L: Layout<C>>(memory: &mut Memory) {
    if let Some(mut frame) = frame::<C, L>(memory) {
        drawn(&mut frame);
    }
}

fn drawn<C: Coded, T: DrawTarget<Color = C, Error = Infallible>>(target: &mut T) {
    let Ok(()) = target.draw_iter([Pixel(any(), color()); 3]);
    let Ok(()) = target.fill_solid(&any(), color());
    let Ok(()) = target.fill_contiguous(&near_rectangle(), endless(color));
    let Ok(()) = target.clear(color());
}

fn read<C: Coded + PartialEq, L: Layout<C>>(memory: &mut Memory) {
    let Some(frame) = frame::<C, L>(memory) else { return };
    keep((frame.bytes(), frame.memory(), frame.plane(any()), frame.stride(), frame.size()));
    frame.lines().for_each(keep);
    let inside = if any() { Inside::Like(color()) } else { Inside::Unlike(color()) };
    keep((frame.pixel(any()), frame.runs(any(), inside, any(), any())));
}

/// In the layouts that differ little from one of the others.
fn everything<C: Coded + PartialEq, L: Layout<C>>(memory: &mut Memory) {
    fill_run::<C, L>(memory);
    write_run::<C, L>(memory);
    bits::<C, L>(memory);
    fill_tile::<C, L>(memory);
    draw_target::<C, L>(memory);
    read::<C, L>(memory);
}

fn frame_new(memory: &mut Memory) {
    keep(Frame::<Gray4, Rows, ()>::bytes_needed(any(), any()));
    keep(Frame::<BinaryColor, Pages, _>::with_slice(some(&mut memory.other), any(), any()).is_ok());
    let spacing = Spacing { before: any(), stride: any() };
    keep(Lent::<Gray4, Rows>::with_spacing(lent(&mut memory.bytes), any(), spacing).is_ok());
}

fn shape(_: &mut Memory) {
    let shape = Shape { is_vertical: any(), rows_per_line: any(), bits: any(), planes: any() };
    keep((shape.stride(any(), any()), shape.lines(any(), any())));
}

fn st7306_tiles(memory: &mut Memory) {
    keep((reencode::st7306_bytes(any()), reencode::it8951_bytes(any())));
    let rows = some(&mut memory.other);
    keep(reencode::st7306_tiles([rows, part(rows)], any(), lent(&mut memory.bytes)));
}

fn it8951_words(memory: &mut Memory) {
    keep(reencode::it8951_words(some(&mut memory.other), any(), lent(&mut memory.bytes)));
}

fn it8951_in_place(memory: &mut Memory) {
    reencode::it8951_in_place(lent(&mut memory.bytes));
}

fn transpose() -> Transpose {
    let order = || one_of(&[BitOrder::HighFirst, BitOrder::LowFirst]);
    Transpose::new(any(), any()).with_orders(order(), order())
}

fn rows_to_pages(memory: &mut Memory) {
    keep(transpose().rows_to_pages(some(&mut memory.other), lent(&mut memory.bytes)));
}

fn pages_to_rows(memory: &mut Memory) {
    keep(transpose().pages_to_rows(some(&mut memory.other), lent(&mut memory.bytes)));
}
