//! SSD1306 on SPI by the crate `ssd1306`, in its basic mode: it keeps no buffer of its own.

use std::ops::Range;

use aquatint::{Changed, Dirty, Frame, Grain, Pages, Rect};
use aquatint_simulator::Panel;
use display_interface::{DisplayError, WriteOnlyDataCommand};
use embedded_graphics::{pixelcolor::BinaryColor, prelude::*, primitives::Rectangle};
use ssd1306::{Ssd1306, command::AddrMode, mode::BasicMode, prelude::*};

use crate::bus::{Bus, Cost, Packet};
use crate::one_bit;

/// Sends a frame: 3 bus writes, 1030 bytes, no copy.
///
/// The panel was set up by `init_with_addr_mode(AddrMode::Horizontal)`: then a page follows the one above.
pub fn flush<DI: WriteOnlyDataCommand>(
    panel: &mut Ssd1306<DI, DisplaySize128x64, BasicMode>,
    frame: &Frame<BinaryColor, Pages, impl AsRef<[u8]>>,
) -> Result<(), DisplayError> {
    panel.set_draw_area((0, 0), (128, 64))?;
    panel.draw(frame.bytes())
}

/// Sends a window: a bus write for each page and two more, no copy.
pub fn flush_window<DI: WriteOnlyDataCommand>(
    panel: &mut Ssd1306<DI, DisplaySize128x64, BasicMode>,
    frame: &Frame<BinaryColor, Pages, impl AsRef<[u8]>>,
    columns: Range<u8>,
    pages: Range<u8>,
) -> Result<(), DisplayError> {
    let (start, end) = ((columns.start, 8 * pages.start), (columns.end, 8 * pages.end));
    panel.set_draw_area(start, end)?;
    // The driver counts the last row in here, and only here: with `end` it would send a page too many.
    panel.bounded_draw(frame.bytes(), 128, start, (end.0, end.1 - 1))
}

/// Sends what changed: for each window 2 bus writes, 6 bytes, and a write for each of its pages, no copy.
pub fn flush_dirty<DI: WriteOnlyDataCommand>(
    panel: &mut Ssd1306<DI, DisplaySize128x64, BasicMode>,
    frame: &Frame<BinaryColor, Pages, impl AsRef<[u8]>>,
    dirty: &mut Dirty<impl AsRef<[Changed]> + AsMut<[Changed]>>,
) -> Result<(), DisplayError> {
    for window in dirty.windows(frame, Grain::SSD1306) {
        let [left, top, right, bottom] = corners(window.area());
        panel.set_draw_area((left, top), (right, bottom))?;
        for page in window.slices() {
            panel.draw(page)?;
        }
    }
    dirty.clear();
    Ok(())
}

/// No coordinate is more than 128.
fn corners(area: Rect) -> [u8; 4] {
    [area.left, area.top, area.right, area.bottom].map(|at| u8::try_from(at).unwrap_or(128))
}

/// The panel and its picture; what `init` sends is the driver's matter.
fn set_up(bus: &Bus) -> Ssd1306<impl WriteOnlyDataCommand, DisplaySize128x64, BasicMode> {
    let interface = SPIInterface::new(bus.clone(), bus.pin("D/C"));
    let mut panel = Ssd1306::new(interface, DisplaySize128x64, DisplayRotation::Rotate0);
    panel.init_with_addr_mode(AddrMode::Horizontal).expect("infallible");
    assert!(bus.packets().contains(&Packet::Command(vec![0x20, 0x00])), "horizontal addressing");
    bus.forget();
    panel
}

fn picture() -> Frame<BinaryColor, Pages, [u8; 1024]> {
    one_bit(Frame::with_array([0; 1024], 128, 64).expect("large enough"))
}

#[test]
fn a_frame_goes_out_in_place() {
    let (bus, frame) = (Bus::default(), picture());
    flush(&mut set_up(&bus), &frame).expect("infallible");

    // 21h: columns from 0 to 127; 22h: pages from 0 to 7.
    let window = [[0x21, 0, 127], [0x22, 0, 7]].map(|bytes| Packet::Command(bytes.to_vec()));
    let [columns, pages] = window;
    assert_eq!(bus.packets(), [columns, pages, Packet::Data(frame.bytes().to_vec())]);
    assert_eq!(bus.cost(frame.bytes()), Cost { writes: 3, bytes: 1030, in_place: 1 });
    assert!(bus.writes()[2].is(frame.bytes()));
    crate::assert_shows(Panel::SSD1306_128X64, &bus.writes()[2].bytes, &frame);
}

#[test]
fn a_window_goes_out_in_place() {
    let (bus, frame) = (Bus::default(), picture());
    flush_window(&mut set_up(&bus), &frame, 40..72, 2..5).expect("infallible");

    let mut expected = [[0x21, 40, 71], [0x22, 2, 4]].map(|bytes| Packet::Command(bytes.to_vec())).to_vec();
    expected.extend((2..5).map(|page| Packet::Data(frame.bytes()[128 * page + 40..128 * page + 72].to_vec())));
    assert_eq!(bus.packets(), expected);
    assert_eq!(bus.cost(frame.bytes()), Cost { writes: 5, bytes: 6 + 3 * 32, in_place: 3 });
}

#[test]
fn what_changed_goes_out_in_place() {
    let (bus, mut frame, mut dirty) = (Bus::default(), picture(), Dirty::new([Changed::NOTHING; 8]));
    let mut panel = set_up(&bus);
    let old = frame.bytes().to_vec();
    let mut tracked = dirty.track(&mut frame);
    // In pages 2 and 3 the same columns; in pages 4 and 7 others.
    for (corner, size) in [((40, 20), (24, 10)), ((80, 35), (8, 3)), ((0, 63), (1, 1))] {
        let area = Rectangle::new(corner.into(), size.into());
        for color in [BinaryColor::On, BinaryColor::Off] {
            let Ok(()) = tracked.fill_solid(&area, color);
        }
    }
    flush_dirty(&mut panel, &frame, &mut dirty).expect("infallible");

    let window = |columns: [u8; 2], pages: [u8; 2]| {
        [[0x21, columns[0], columns[1]], [0x22, pages[0], pages[1]]].map(|bytes| Packet::Command(bytes.to_vec()))
    };
    let data = |start: usize, end: usize| Packet::Data(frame.bytes()[start..end].to_vec());
    let expected = [
        &window([40, 63], [2, 3])[..],
        &[data(2 * 128 + 40, 2 * 128 + 64), data(3 * 128 + 40, 3 * 128 + 64)],
        &window([80, 87], [4, 4]),
        &[data(4 * 128 + 80, 4 * 128 + 88)],
        &window([0, 0], [7, 7]),
        &[data(7 * 128, 7 * 128 + 1)],
    ];
    assert_eq!(bus.packets(), expected.concat());
    assert_eq!(bus.cost(frame.bytes()), Cost { writes: 10, bytes: 3 * 6 + 2 * 24 + 8 + 1, in_place: 4 });
    assert!(dirty.is_clean() && frame.bytes() != old);
}
