//! Sharp memory LCD LS027B7DH01, 400 × 240; others of the family differ in size alone, up to 255 lines.
//!
//! By hand: of the crates, `sharp-memory-display` is under the GPL and for embedded-hal 0.2, `memory-lcd-spi`
//! needs a nightly compiler, and `ls013b7dh03` knows one size and packs its own buffer.
//!
//! On the wires: a byte of command; for each line its address, counted from 1, its pixels and a byte
//! of nothing; one more byte of nothing. A 1 is white. The panel wants the *lowest* bit of an
//! address first, the leftmost pixel first, and M0, the command's first bit, first; SPI here sends the highest
//! bit first, so addresses are reversed and M0 is 80h. VCOM is inverted by the pin EXTCOMIN (EXTMODE is high).

use std::{convert::Infallible, ops::Range};

use aquatint::{Frame, Levels, Rows};
use aquatint_simulator::Panel;
use embedded_graphics::{pixelcolor::BinaryColor, prelude::*, primitives::Rectangle};
use embedded_hal::{delay::DelayNs, digital::OutputPin, spi::SpiBus};

use crate::bus::{Bus, Cost, Event};
use crate::{assert_shows, draw_picture, one_bit};

/// M0: write lines.
const WRITE: u8 = 0x80;
/// Bytes of pixels in a line.
const LINE: usize = 400 / 8;

/// The panel's wires. A bus and not a device, because this chip select is active *high*.
pub struct Sharp<S, P, D> {
    pub bus: S,
    pub select: P,
    pub delay: D,
}

impl<S: SpiBus, P: OutputPin<Error = Infallible>, D: DelayNs> Sharp<S, P, D> {
    /// Sends lines: 2 bus writes and 52 bytes a line, 1 and 2 more; pixels are not copied.
    pub fn flush(
        &mut self,
        frame: &Frame<BinaryColor, Rows, impl AsRef<[u8]>>,
        lines: Range<u8>,
    ) -> Result<(), S::Error> {
        let rows = frame.bytes().chunks_exact(LINE).skip(lines.start.into());
        self.select();
        let mut before = WRITE;
        for (line, row) in lines.zip(rows) {
            self.bus.write(&[before, (line + 1).reverse_bits()])?;
            self.bus.write(row)?;
            before = 0;
        }
        self.bus.write(&[0, 0])?;
        self.deselect()
    }

    /// Sends a frame that has room for the addresses: 2 bus writes, 12,482 bytes, no copy.
    pub fn flush_spaced(&mut self, memory: &[u8; SPACED]) -> Result<(), S::Error> {
        self.select();
        self.bus.write(&[WRITE, 1_u8.reverse_bits()])?;
        self.bus.write(memory)?;
        self.deselect()
    }

    /// Chip select must be up some µs before the first clock (tsSCS): 6 are enough for the whole family.
    fn select(&mut self) {
        let Ok(()) = self.select.set_high();
        self.delay.delay_us(6);
    }

    /// And stay up after the last one (thSCS): 2.
    fn deselect(&mut self) -> Result<(), S::Error> {
        self.bus.flush()?;
        self.delay.delay_us(2);
        let Ok(()) = self.select.set_low();
        Ok(())
    }
}

/// Bytes of a frame with two spare ones behind each line.
const SPACED: usize = (LINE + 2) * 240;

/// Puts into the spare bytes the end of the line and the address of the next one; once is enough.
///
/// A frame of 416 × 240 on this memory has them in its last 16 columns, where nothing may be drawn: draw on
/// `frame.clipped(…)` of the left 400.
pub fn address(memory: &mut [u8; SPACED]) {
    for (line, next) in memory.chunks_exact_mut(LINE + 2).zip(2..=241_u8) {
        let address = if next <= 240 { next.reverse_bits() } else { 0 };
        line[LINE..].copy_from_slice(&[0, address]);
    }
}

fn set_up(bus: &Bus) -> Sharp<Bus, impl OutputPin<Error = Infallible>, Bus> {
    Sharp { bus: bus.clone(), select: bus.pin("SCS"), delay: bus.clone() }
}

fn picture() -> Frame<BinaryColor, Rows, Vec<u8>> {
    one_bit(Frame::new(vec![0; LINE * 240], 400, 240).expect("large enough"))
}

/// A panel of 240 lines: checks command, addresses and ends, and gives the pixels.
fn receive(bytes: &[u8]) -> Vec<u8> {
    let (&command, lines) = bytes.split_first().expect("a command");
    let (lines, &[end]) = lines.split_at(240 * 52) else { panic!("one more byte") };
    assert_eq!((command, end), (0b1000_0000, 0));
    let mut pixels = Vec::new();
    for (number, line) in (1..=240_u8).zip(lines.chunks_exact(52)) {
        // Bits as they come: the lowest one first.
        let address: u8 = (0..8).map(|bit| ((line[0] >> (7 - bit)) & 1) << bit).sum();
        assert_eq!((address, line[51]), (number, 0));
        pixels.extend(&line[1..51]);
    }
    pixels
}

#[test]
fn lines_go_out_in_place() {
    let (bus, frame) = (Bus::default(), picture());
    set_up(&bus).flush(&frame, 0..240).expect("infallible");

    assert_eq!(bus.cost(frame.bytes()), Cost { writes: 481, bytes: 12_482, in_place: 240 });
    assert_eq!(bus.writes()[0].bytes, [0b1000_0000, 0b1000_0000]);
    assert_eq!(bus.writes()[4].bytes, [0, 0b1100_0000]);
    for (row, write) in frame.bytes().chunks_exact(LINE).zip(bus.writes().iter().skip(1).step_by(2)) {
        assert!(write.is(row));
    }
    assert_shows(Panel::SHARP_400X240, &receive(&bus.bytes()), &frame);

    let events = bus.events();
    assert_eq!(events[..2], [Event::Pin("SCS", true), Event::Delay(6000)]);
    assert_eq!(events[events.len() - 2..], [Event::Delay(2000), Event::Pin("SCS", false)]);
}

#[test]
fn some_lines_cost_less() {
    let (bus, frame) = (Bus::default(), picture());
    set_up(&bus).flush(&frame, 100..103).expect("infallible");

    assert_eq!(bus.cost(frame.bytes()), Cost { writes: 7, bytes: 3 * 52 + 2, in_place: 3 });
    assert_eq!(bus.writes()[0].bytes, [0b1000_0000, 101_u8.reverse_bits()]);
    assert!(bus.writes()[5].is(&frame.bytes()[102 * LINE..103 * LINE]));
}

#[test]
fn addresses_in_memory_make_it_one_write() {
    let (bus, mut memory) = (Bus::default(), [0; SPACED]);
    address(&mut memory);
    let mut frame = Frame::<BinaryColor, Rows, _>::new(&mut memory[..], 416, 240).expect("large enough");
    draw_picture(&mut frame.clipped(&Rectangle::new(Point::zero(), Size::new(400, 240))), Levels::ONE_BIT);
    set_up(&bus).flush_spaced(&memory).expect("infallible");

    assert_eq!(bus.cost(&memory), Cost { writes: 2, bytes: 12_482, in_place: 1 });
    assert!(bus.writes()[1].is(&memory));
    assert_shows(Panel::SHARP_400X240, &receive(&bus.bytes()), &picture());
}
