//! SSD1306 on SPI, awaited: the processor draws the next frame while DMA sends this one.
//!
//! By hand, because the feature `async` of the crate `ssd1306` takes its blocking `I2CDisplayInterface::new` away,
//! and cargo would switch it on for the blocking examples beside this one too.

use std::convert::Infallible;

use aquatint::{Frame, Pages};
use aquatint_simulator::Panel;
use embassy_futures::{block_on, join::join};
use embedded_graphics::{pixelcolor::BinaryColor, prelude::*};
use embedded_hal::digital::OutputPin;
use embedded_hal_async::spi::SpiDevice;

use crate::bus::{Bus, Cost, Event, Packet};
use crate::{assert_shows, one_bit};

/// Sends a frame: 2 bus writes, 1030 bytes, no copy. The panel is in horizontal addressing mode.
pub async fn flush<S: SpiDevice>(
    bus: &mut S,
    dc: &mut impl OutputPin<Error = Infallible>,
    frame: &Frame<BinaryColor, Pages, impl AsRef<[u8]>>,
) -> Result<(), S::Error> {
    let Ok(()) = dc.set_low();
    bus.write(&[0x21, 0, 127, 0x22, 0, 7]).await?;
    let Ok(()) = dc.set_high();
    bus.write(frame.bytes()).await
}

fn empty() -> Frame<BinaryColor, Pages, [u8; 1024]> {
    Frame::with_array([0; 1024], 128, 64).expect("large enough")
}

#[test]
fn a_frame_goes_out_in_place() {
    let (mut bus, frame) = (Bus::default(), one_bit(empty()));
    let mut dc = bus.pin("D/C");
    block_on(flush(&mut bus, &mut dc, &frame)).expect("infallible");

    let window = Packet::Command(vec![0x21, 0, 127, 0x22, 0, 7]);
    assert_eq!(bus.packets(), [window, Packet::Data(frame.bytes().to_vec())]);
    assert_eq!(bus.cost(frame.bytes()), Cost { writes: 2, bytes: 1030, in_place: 1 });
    assert!(bus.writes()[1].is(frame.bytes()));
    assert_shows(Panel::SSD1306_128X64, &bus.writes()[1].bytes, &frame);
}

#[test]
fn the_next_frame_is_drawn_meanwhile() {
    let (mut bus, front, mut back) = (Bus::default(), one_bit(empty()), empty());
    let (mut dc, mut drawing) = (bus.pin("D/C"), bus.pin("drawing"));
    let draw = async {
        let Ok(()) = drawing.set_high();
        back.clear(BinaryColor::On)
    };
    let (sent, Ok(())) = block_on(join(flush(&mut bus, &mut dc, &front), draw));

    sent.expect("infallible");
    assert!(bus.writes()[1].is(front.bytes()) && back.bytes() == [0xFF; 1024]);
    let at = |event| bus.events().iter().position(|it| *it == event).expect("it happened");
    assert!(at(Event::Pin("CS", false)) < at(Event::Pin("drawing", true)));
    assert!(at(Event::Pin("drawing", true)) < at(Event::Pin("CS", true)));
}
