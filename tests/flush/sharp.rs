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

use aquatint::{Changed, Dirty, Frame, Grain, Rows, Spacing};
use aquatint_simulator::Panel;
use embedded_graphics::{
    image::GetPixel,
    pixelcolor::BinaryColor,
    prelude::*,
    primitives::{Circle, PrimitiveStyle, Rectangle},
};
use embedded_hal::{delay::DelayNs, digital::OutputPin, spi::SpiBus};

use crate::bus::{Bus, Cost, Event};
use crate::{assert_shows, one_bit};

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

    /// Sends the lines that changed, in one transfer: 2 bus writes and 52 bytes each, 1 and 2 more.
    pub fn flush_dirty(
        &mut self,
        frame: &Frame<BinaryColor, Rows, impl AsRef<[u8]>>,
        dirty: &mut Dirty<impl AsRef<[Changed]> + AsMut<[Changed]>>,
    ) -> Result<(), S::Error> {
        if dirty.is_clean() {
            return Ok(());
        }
        self.select();
        let mut before = WRITE;
        for window in dirty.windows(frame, Grain::SHARP) {
            let lines = window.area().rows().map(|row| u8::try_from(row + 1).unwrap_or_default());
            for (line, row) in lines.zip(window.slices()) {
                self.bus.write(&[before, line.reverse_bits()])?;
                self.bus.write(row)?;
                before = 0;
            }
        }
        self.bus.write(&[0, 0])?;
        dirty.clear();
        self.deselect()
    }

    /// Sends a frame that is [`addressed`]: 1 bus write, 12,482 bytes, no copy.
    pub fn flush_addressed(&mut self, frame: &Frame<BinaryColor, Rows, impl AsRef<[u8]>>) -> Result<(), S::Error> {
        self.select();
        self.bus.write(frame.memory())?;
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

/// Bytes of the whole transfer: command and address, and for each line pixels, end and the next address.
const ADDRESSED: usize = 2 + (LINE + 2) * 240;

/// An empty frame with all that goes between the lines on the wires; drawing does not touch it.
pub fn addressed() -> Frame<BinaryColor, Rows, Vec<u8>> {
    let mut memory = vec![0; ADDRESSED];
    memory[..2].copy_from_slice(&[WRITE, 1_u8.reverse_bits()]);
    // Behind the last line there is one more byte of nothing.
    for (line, next) in memory[2..].chunks_exact_mut(LINE + 2).zip((2..=240_u8).chain([0])) {
        line[LINE..].copy_from_slice(&[0, next.reverse_bits()]);
    }
    let spacing = Spacing { before: 2, stride: LINE + 2 };
    Frame::with_spacing(memory, Size::new(400, 240), spacing).expect("large enough")
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
fn only_lines_that_changed_go_out() {
    let (bus, mut frame, mut dirty) = (Bus::default(), picture(), Dirty::new([Changed::NOTHING; 240]));
    let mut panel = set_up(&bus);
    panel.flush_dirty(&frame, &mut dirty).expect("infallible");
    assert_eq!(bus.events(), [], "nothing has changed");

    let dot = Circle::new(Point::new(200, 17), 3).into_styled(PrimitiveStyle::with_fill(BinaryColor::On));
    let point = Pixel(Point::new(399, 239), frame.pixel(Point::new(399, 239)).expect("inside").invert());
    let mut tracked = dirty.track(&mut frame);
    let Ok(()) = tracked.fill_solid(&Rectangle::new(Point::new(200, 17), Size::new(9, 3)), BinaryColor::Off);
    let (Ok(()), Ok(())) = (dot.draw(&mut tracked), point.draw(&mut tracked));
    panel.flush_dirty(&frame, &mut dirty).expect("infallible");

    let rows: Vec<&[u8]> = frame.bytes().chunks_exact(LINE).collect();
    let line = |command: u8, number: u8| {
        let row = rows[usize::from(number) - 1];
        [&[command, number.reverse_bits()], row].concat()
    };
    assert_eq!(bus.bytes(), [line(WRITE, 18), line(0, 19), line(0, 20), line(0, 240), vec![0, 0]].concat());
    assert_eq!(bus.cost(frame.bytes()), Cost { writes: 9, bytes: 4 * 52 + 2, in_place: 4 });
    assert!(bus.writes()[1].is(rows[17]) && bus.writes()[7].is(rows[239]));
    assert!(dirty.is_clean());
}

#[test]
fn addresses_in_memory_make_it_one_write() {
    let (bus, frame) = (Bus::default(), one_bit(addressed()));
    set_up(&bus).flush_addressed(&frame).expect("infallible");

    assert_eq!(bus.cost(frame.memory()), Cost { writes: 1, bytes: 12_482, in_place: 1 });
    assert!(bus.writes()[0].is(frame.memory()));
    assert_shows(Panel::SHARP_400X240, &receive(&bus.bytes()), &picture());
}
