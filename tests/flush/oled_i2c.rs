//! SSD1306 on I²C, three ways: the byte 40h, "data follow", must come before the frame in the same transfer.

use aquatint::{Frame, Pages, Spacing};
use aquatint_simulator::Panel;
use display_interface::DisplayError;
use embedded_graphics::{geometry::Size, pixelcolor::BinaryColor};
use embedded_hal::i2c::{I2c, Operation};
use ssd1306::{I2CDisplayInterface, Ssd1306, command::AddrMode, prelude::*};

use crate::bus::{Bus, Cost, Event};
use crate::{assert_shows, one_bit};

const ADDRESS: u8 = 0x3C;
/// 00h, "commands follow"; 21h: columns from 0 to 127; 22h: pages from 0 to 7.
const WHOLE_PANEL: [u8; 7] = [0x00, 0x21, 0, 127, 0x22, 0, 7];

/// Sends a frame by the crate `ssd1306`: 66 bus writes, 1096 bytes. `display-interface-i2c` copies 16 bytes at
/// a time behind a 40h.
pub fn flush_by_driver(
    panel: &mut Ssd1306<I2CInterface<impl I2c>, DisplaySize128x64, ssd1306::mode::BasicMode>,
    frame: &Frame<BinaryColor, Pages, impl AsRef<[u8]>>,
) -> Result<(), DisplayError> {
    panel.set_draw_area((0, 0), (128, 64))?;
    panel.draw(frame.bytes())
}

/// Sends a frame in two transfers: 3 bus writes, 1032 bytes, no copy.
///
/// For a HAL that keeps the promise of [`I2c::transaction`]: adjacent writes go out as one.
pub fn flush<I: I2c>(bus: &mut I, frame: &Frame<BinaryColor, Pages, impl AsRef<[u8]>>) -> Result<(), I::Error> {
    bus.write(ADDRESS, &WHOLE_PANEL)?;
    bus.transaction(ADDRESS, &mut [Operation::Write(&[0x40]), Operation::Write(frame.bytes())])
}

/// Sends a frame with its 40h in front, for any HAL: 2 bus writes, 1032 bytes, no copy.
///
/// For a frame [`with_prefix`].
pub fn flush_with_prefix<I: I2c>(
    bus: &mut I,
    frame: &Frame<BinaryColor, Pages, impl AsRef<[u8]>>,
) -> Result<(), I::Error> {
    bus.write(ADDRESS, &WHOLE_PANEL)?;
    bus.write(ADDRESS, frame.memory())
}

/// An empty frame with a byte in front, which is 40h for good: drawing does not touch it.
pub fn with_prefix() -> Frame<BinaryColor, Pages, [u8; 1 + 1024]> {
    let mut memory = [0; 1 + 1024];
    memory[0] = 0x40;
    let spacing = Spacing { before: 1, stride: 128 };
    Frame::with_spacing(memory, Size::new(128, 64), spacing).expect("large enough")
}

fn picture() -> Frame<BinaryColor, Pages, [u8; 1024]> {
    one_bit(Frame::with_array([0; 1024], 128, 64).expect("large enough"))
}

/// What a transfer that must start with `first` has behind it.
fn behind(first: u8, bytes: &[u8]) -> &[u8] {
    assert_eq!(bytes[0], first);
    &bytes[1..]
}

#[test]
fn the_driver_copies() {
    let (bus, frame) = (Bus::default(), picture());
    let interface = I2CDisplayInterface::new(bus.clone());
    let mut panel = Ssd1306::new(interface, DisplaySize128x64, DisplayRotation::Rotate0);
    panel.init_with_addr_mode(AddrMode::Horizontal).expect("infallible");
    bus.forget();
    flush_by_driver(&mut panel, &frame).expect("infallible");

    assert_eq!(bus.cost(frame.bytes()), Cost { writes: 66, bytes: 4 + 4 + 64 * 17, in_place: 0 });
    let writes = bus.writes();
    assert_eq!(writes[0].bytes, [0x00, 0x21, 0, 127]);
    assert_eq!(writes[1].bytes, [0x00, 0x22, 0, 7]);
    let received: Vec<u8> = writes[2..].iter().flat_map(|write| behind(0x40, &write.bytes)).copied().collect();
    assert_eq!(received, frame.bytes());
    assert_shows(Panel::SSD1306_128X64, &received, &frame);
}

#[test]
fn a_transaction_takes_the_frame_in_place() {
    let (mut bus, frame) = (Bus::default(), picture());
    flush(&mut bus, &frame).expect("infallible");

    let [window, prefix, data] = &bus.writes()[..] else { panic!("three writes") };
    assert_eq!((&window.bytes[..], &prefix.bytes[..]), (&WHOLE_PANEL[..], &[0x40][..]));
    assert!(data.is(frame.bytes()));
    let wires = [Event::Start(ADDRESS), Event::Write(window.clone()), Event::Stop, Event::Start(ADDRESS)];
    let wires = wires.into_iter().chain([Event::Write(prefix.clone()), Event::Write(data.clone()), Event::Stop]);
    assert_eq!(bus.events(), wires.collect::<Vec<_>>());
    assert_eq!(bus.cost(frame.bytes()), Cost { writes: 3, bytes: 1032, in_place: 1 });
    assert_shows(Panel::SSD1306_128X64, &data.bytes, &frame);
}

#[test]
fn a_prefix_in_memory_makes_it_one_write() {
    let (mut bus, frame) = (Bus::default(), one_bit(with_prefix()));
    flush_with_prefix(&mut bus, &frame).expect("infallible");

    let [window, data] = &bus.writes()[..] else { panic!("two writes") };
    assert_eq!(window.bytes, WHOLE_PANEL);
    assert!(data.is(frame.memory()));
    assert_eq!(bus.cost(frame.memory()), Cost { writes: 2, bytes: 1032, in_place: 1 });
    assert_shows(Panel::SSD1306_128X64, behind(0x40, &data.bytes), &picture());
}
