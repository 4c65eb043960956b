//! SSD1306 on SPI by the crate `ssd1306`, in its basic mode: it keeps no buffer of its own.

use std::ops::Range;

use aquatint::{Frame, Pages};
use aquatint_simulator::Panel;
use display_interface::{DisplayError, WriteOnlyDataCommand};
use embedded_graphics::pixelcolor::BinaryColor;
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
