//! ST7565 on SPI by the crate `st7565`, in its raw mode: page by page, because the controller's column stops at
//! the end of a page.

use aquatint::{Frame, Pages};
use aquatint_simulator::Panel;
use display_interface::{DisplayError, WriteOnlyDataCommand};
use display_interface_spi::SPIInterface;
use embedded_graphics::pixelcolor::BinaryColor;
use st7565::{DisplaySpecs, ST7565, displays::DOGL128_6_EXT12V, modes::RawMode};

use crate::bus::{Bus, Cost, Packet};
use crate::{assert_shows, one_bit};

/// Sends a frame: 24 bus writes, 1048 bytes, no copy.
pub fn flush<DI: WriteOnlyDataCommand>(
    panel: &mut ST7565<DI, DOGL128_6_EXT12V, RawMode, 128, 64, 8>,
    frame: &Frame<BinaryColor, Pages, impl AsRef<[u8]>>,
) -> Result<(), DisplayError> {
    for (page, bytes) in (0..).zip(frame.bytes().chunks_exact(128)) {
        panel.set_page(page)?;
        // The glass is 128 of the controller's 132 columns; raw mode leaves it to the caller which.
        panel.set_column(DOGL128_6_EXT12V::COLUMN_OFFSET)?;
        panel.write_pixel_data(bytes)?;
    }
    Ok(())
}

#[test]
fn eight_pages_go_out_in_place() {
    let bus = Bus::default();
    let frame = one_bit(Frame::<_, Pages, _>::with_array([0; 1024], 128, 64).expect("large enough"));
    let interface = SPIInterface::new(bus.clone(), bus.pin("D/C"));
    flush(&mut ST7565::new(interface, DOGL128_6_EXT12V).into_raw_mode(), &frame).expect("infallible");

    let pages = (0xB0..).zip(frame.bytes().chunks_exact(128));
    let packets = pages.flat_map(|(page, bytes)| {
        // B0h + page; 10h + column's high nibble, low nibble.
        let [page, column] = [vec![page], vec![0x10, 0x04]].map(Packet::Command);
        [page, column, Packet::Data(bytes.to_vec())]
    });
    assert_eq!(bus.packets(), packets.collect::<Vec<_>>());
    assert_eq!(bus.cost(frame.bytes()), Cost { writes: 24, bytes: 1048, in_place: 8 });

    let data = bus.writes().into_iter().skip(2).step_by(3);
    let received: Vec<u8> = data.flat_map(|write| write.bytes).collect();
    assert_shows(Panel::SSD1306_128X64, &received, &frame);
}
