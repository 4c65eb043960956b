//! Pixels of two bytes: marked by the byte, sent whole.

use core::convert::Infallible;

use aquatint::{Changed, Dirty, Frame, Grain, LsbFirst, MsbFirst, Target, Words, display::layout::Layout};
use embedded_graphics::{
    Pixel,
    draw_target::DrawTarget,
    geometry::{Point, Size},
    pixelcolor::{Rgb565, RgbColor, raw::RawU16},
    primitives::Rectangle,
};
use proptest::prelude::*;

proptest! {
    #![proptest_config(ProptestConfig::with_cases(10_000))]

    #[test]
    fn pixels_of_two_bytes_are_sent_whole(way in 0..4_u8, corner in any::<[i8; 2]>(), code in any::<u16>()) {
        draw_words::<MsbFirst>(way, corner, code);
        draw_words::<LsbFirst>(way, corner, code);
    }
}

fn draw_words<O>(way: u8, [x, y]: [i8; 2], code: u16)
where
    Words<O>: Layout<Rgb565>,
{
    // Rows of three blocks each.
    let blank = || Frame::<Rgb565, Words<O>, _>::new(vec![0x15; 2 * 150 * 5], 150, 5).expect("enough");
    let mut dirty = Dirty::new([Changed::NOTHING; 5]);
    let (mut frame, mut plain, color) = (blank(), blank(), Rgb565::from(RawU16::new(code)));
    let old = frame.bytes().to_vec();
    let area = Rectangle::new(Point::new(x.into(), (y % 6).into()), Size::new(120, 2));
    draw_in_way(way, &mut dirty.track(&mut frame), area, color);
    draw_in_way(way, &mut plain, area, color);
    assert_eq!(frame.bytes(), plain.bytes());

    let mut panel = old.clone();
    for ((old, new), entry) in old.chunks(300).zip(frame.bytes().chunks(300)).zip(dirty.entries()) {
        let differs: Vec<_> = (0..300).filter(|&at| old[at] != new[at]).collect();
        let expected = differs.first().zip(differs.last()).map_or(0..0, |(first, last)| *first..last + 1);
        assert_eq!(entry.bytes(300), expected);
    }
    for window in dirty.windows(&frame, Grain::BYTES) {
        for (row, slice) in window.area().rows().zip(window.slices()) {
            assert_eq!(slice.len(), 2 * window.area().width() as usize);
            let at = 300 * row.unsigned_abs() as usize + 2 * window.area().left.unsigned_abs() as usize;
            panel[at..at + slice.len()].copy_from_slice(slice);
        }
    }
    assert_eq!(panel, frame.bytes());
}

fn draw_in_way<T>(way: u8, target: &mut T, area: Rectangle, color: Rgb565)
where
    T: Target<Color = Rgb565, Error = Infallible> + DrawTarget<Color = Rgb565, Error = Infallible>,
{
    let run = area.top_left.x..area.top_left.x.saturating_add(120);
    let Ok(()) = match way {
        0 => target.fill_solid(&area, color),
        1 => target.draw_iter([Pixel(area.top_left, color), Pixel(area.top_left + Point::new(3, 1), color)]),
        2 => target.fill_contiguous(&area, [color, Rgb565::BLUE].into_iter().cycle()),
        _ => target.fill_run(area.top_left.y, run, [color, Rgb565::RED, color, Rgb565::GREEN]),
    };
}
