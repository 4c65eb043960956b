//! OLEDs of four bits a pixel on SPI, by hand: the crate `ssd1322` is for embedded-hal 0.2 and sends byte by byte,
//! `ssd1327` the same and for embedded-graphics 0.6.
//!
//! The left pixel is in the high nibble, if the panel was initialised for that by A0h: on the SSD1322
//! 14h 11h (nibble re-map *on*), on the SSD1327 51h (nibble re-map *off*, columns re-mapped). Most code has these.

use std::{convert::Infallible, ops::Range};

use aquatint::{Changed, Dirty, Frame, Grain, Levels, Rect, Rows};
use aquatint_simulator::Panel;
use embedded_graphics::{pixelcolor::Gray4, prelude::*, primitives::Rectangle};
use embedded_hal::{digital::OutputPin, spi::SpiDevice};

use crate::bus::{Bus, Cost, Packet};
use crate::{assert_shows, drawn};

/// Sends rows to an SSD1322 of 256 × 64: 6 bus writes, 7 bytes and 128 a row, no copy.
///
/// Its columns are addressed in fours, and the module's 256 are the middle ones of the controller's 480: 28 to 91.
pub fn flush_ssd1322<S: SpiDevice>(
    bus: &mut S,
    dc: &mut impl OutputPin<Error = Infallible>,
    frame: &Frame<Gray4, Rows, impl AsRef<[u8]>>,
    rows: Range<u8>,
) -> Result<(), S::Error> {
    let bytes = &frame.bytes()[128 * usize::from(rows.start)..128 * usize::from(rows.end)];
    let window = [rows.start, rows.end - 1];
    for (command, data) in [(0x15, &[28, 91][..]), (0x75, &window), (0x5C, bytes)] {
        let Ok(()) = dc.set_low();
        bus.write(&[command])?;
        let Ok(()) = dc.set_high();
        bus.write(data)?;
    }
    Ok(())
}

/// Sends what changed to an SSD1322: for each window 5 bus writes and 7 bytes, and a write for each row, no copy.
///
/// A window begins and ends at columns of four pixels, which are two bytes.
pub fn flush_ssd1322_dirty<S: SpiDevice>(
    bus: &mut S,
    dc: &mut impl OutputPin<Error = Infallible>,
    frame: &Frame<Gray4, Rows, impl AsRef<[u8]>>,
    dirty: &mut Dirty<impl AsRef<[Changed]> + AsMut<[Changed]>>,
) -> Result<(), S::Error> {
    for window in dirty.windows(frame, Grain::SSD1322) {
        let Rect { left, top, right, bottom } = window.area();
        let [first, last, top, bottom] =
            [28 + left / 4, 28 + right / 4 - 1, top, bottom - 1].map(|at| u8::try_from(at).unwrap_or(u8::MAX));
        for (command, data) in [(0x15, &[first, last][..]), (0x75, &[top, bottom]), (0x5C, &[])] {
            let Ok(()) = dc.set_low();
            bus.write(&[command])?;
            let Ok(()) = dc.set_high();
            if !data.is_empty() {
                bus.write(data)?;
            }
        }
        for row in window.slices() {
            bus.write(row)?;
        }
    }
    dirty.clear();
    Ok(())
}

/// Sends a frame to an SSD1327 of 128 × 128: 2 bus writes, 8198 bytes, no copy.
///
/// Columns are addressed in twos, arguments of commands count as commands, and data need none.
pub fn flush_ssd1327<S: SpiDevice>(
    bus: &mut S,
    dc: &mut impl OutputPin<Error = Infallible>,
    frame: &Frame<Gray4, Rows, impl AsRef<[u8]>>,
) -> Result<(), S::Error> {
    let Ok(()) = dc.set_low();
    bus.write(&[0x15, 0, 63, 0x75, 0, 127])?;
    let Ok(()) = dc.set_high();
    bus.write(frame.bytes())
}

fn picture(height: u32, width: u32) -> Frame<Gray4, Rows, Vec<u8>> {
    drawn(Frame::new(vec![0; 8192], width, height).expect("large enough"), Levels::LINEAR_16)
}

#[test]
fn ssd1322_takes_the_frame_in_place() {
    let (mut bus, frame) = (Bus::default(), picture(64, 256));
    let mut dc = bus.pin("D/C");
    flush_ssd1322(&mut bus, &mut dc, &frame, 0..64).expect("infallible");

    let window = [(0x15, [28, 91]), (0x75, [0, 63])];
    let window = window.map(|(command, data)| [Packet::Command(vec![command]), Packet::Data(data.to_vec())]);
    let picture = [Packet::Command(vec![0x5C]), Packet::Data(frame.bytes().to_vec())];
    assert_eq!(bus.packets(), [window.as_flattened(), &picture].concat());
    assert_eq!(bus.cost(frame.bytes()), Cost { writes: 6, bytes: 8199, in_place: 1 });
    assert!(bus.writes()[5].is(frame.bytes()));
    assert_shows(Panel::SSD1322_256X64, &bus.writes()[5].bytes, &frame);
}

#[test]
fn ssd1322_takes_some_rows_in_place() {
    let (mut bus, frame) = (Bus::default(), picture(64, 256));
    let mut dc = bus.pin("D/C");
    flush_ssd1322(&mut bus, &mut dc, &frame, 10..13).expect("infallible");

    assert_eq!(bus.packets()[3], Packet::Data(vec![10, 12]));
    assert!(bus.writes()[5].is(&frame.bytes()[1280..1664]));
    assert_eq!(bus.cost(frame.bytes()), Cost { writes: 6, bytes: 7 + 3 * 128, in_place: 1 });
}

#[test]
fn ssd1322_takes_what_changed_in_place() {
    let (mut bus, mut frame, mut dirty) = (Bus::default(), picture(64, 256), Dirty::new([Changed::NOTHING; 64]));
    let mut dc = bus.pin("D/C");
    let area = Rectangle::new(Point::new(101, 30), Size::new(6, 3));
    for color in [Gray4::BLACK, Gray4::WHITE] {
        let Ok(()) = dirty.track(&mut frame).fill_solid(&area, color);
    }
    flush_ssd1322_dirty(&mut bus, &mut dc, &frame, &mut dirty).expect("infallible");

    // Columns 100 to 107 are the 25th and 26th four.
    let window = [(0x15, [28 + 25, 28 + 26]), (0x75, [30, 32])];
    let window = window.map(|(command, data)| [Packet::Command(vec![command]), Packet::Data(data.to_vec())]);
    let rows = [30, 31, 32].map(|row| &frame.bytes()[128 * row + 50..128 * row + 54]);
    let picture = [vec![Packet::Command(vec![0x5C])], rows.map(|row| Packet::Data(row.to_vec())).to_vec()];
    assert_eq!(bus.packets(), [window.as_flattened(), picture.concat().as_slice()].concat());
    assert_eq!(bus.cost(frame.bytes()), Cost { writes: 8, bytes: 7 + 3 * 4, in_place: 3 });
    assert!(dirty.is_clean() && bus.writes()[5].is(rows[0]));
}

#[test]
fn ssd1327_takes_the_frame_in_place() {
    let (mut bus, frame) = (Bus::default(), picture(128, 128));
    let mut dc = bus.pin("D/C");
    flush_ssd1327(&mut bus, &mut dc, &frame).expect("infallible");

    let window = Packet::Command(vec![0x15, 0, 63, 0x75, 0, 127]);
    assert_eq!(bus.packets(), [window, Packet::Data(frame.bytes().to_vec())]);
    assert_eq!(bus.cost(frame.bytes()), Cost { writes: 2, bytes: 8198, in_place: 1 });
    assert!(bus.writes()[1].is(frame.bytes()));
    let panel = Panel { name: "SSD1327 128x128", width: 128, height: 128, ..Panel::SSD1322_256X64 };
    assert_shows(panel, &bus.writes()[1].bytes, &frame);
}
