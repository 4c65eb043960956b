//! E-paper with an SSD1680: rows, 1 is white, a row padded to whole bytes.
//!
//! Clear such a frame to `BinaryColor::On`, which is paper here.

use std::ops::Range;

use aquatint::{Changed, Dirty, DirtyWindow, Frame, Grain, Rows, TooSmall};
use aquatint_simulator::Panel;
use display_interface::{DisplayError, WriteOnlyDataCommand};
use display_interface_spi::SPIInterface;
use embedded_graphics::{pixelcolor::BinaryColor, prelude::*, primitives::Rectangle};
use embedded_hal::{
    delay::DelayNs,
    digital::{InputPin, OutputPin},
    spi::SpiDevice,
};
use epd_waveshare::{epd2in9_v2::Epd2in9, prelude::*};
use weact_studio_epd::WeActStudio213BlackWhiteDriver;

use crate::bus::{Bus, Cost, Packet, Pin};
use crate::{assert_shows, one_bit};

/// Shows a frame of 122 × 250 by `weact-studio-epd`: 43 bus writes, 16,059 bytes, no copy.
///
/// That is four times the frame: the driver fills the controller's memories of old and new pixels, before and after
/// the refresh, so that a fast refresh may follow. `write_bw_buffer` and `full_refresh` alone send it once.
pub fn show<I: WriteOnlyDataCommand, B: InputPin, R: OutputPin, D: DelayNs>(
    panel: &mut WeActStudio213BlackWhiteDriver<I, B, R, D>,
    frame: &Frame<BinaryColor, Rows, impl AsRef<[u8]>>,
) -> Result<(), DisplayError> {
    // 122 pixels fill 15¼ bytes: 16, as the driver wants them.
    panel.full_update_from_buffer(frame.bytes())
}

/// Shows rows that changed, without the flicker of a full refresh: three times their 16 bytes each, no copy.
///
/// The full width, because the driver wants a window in one piece.
pub fn show_rows<I: WriteOnlyDataCommand, B: InputPin, R: OutputPin, D: DelayNs>(
    panel: &mut WeActStudio213BlackWhiteDriver<I, B, R, D>,
    frame: &Frame<BinaryColor, Rows, impl AsRef<[u8]>>,
    rows: Range<u8>,
) -> Result<(), DisplayError> {
    let (start, end) = (u32::from(rows.start), u32::from(rows.end));
    let bytes = &frame.bytes()[16 * usize::from(rows.start)..16 * usize::from(rows.end)];
    panel.fast_partial_update_from_buffer(bytes, 0, start, 128, end - start)
}

/// Shows what changed, by one fast refresh: three times the bytes of each window.
///
/// A window as wide as the panel goes out in place. The driver wants the others in one piece too: they are copied
/// into `buffer`, for which the largest window has to be small enough.
pub fn show_dirty<I: WriteOnlyDataCommand, B: InputPin, R: OutputPin, D: DelayNs>(
    panel: &mut WeActStudio213BlackWhiteDriver<I, B, R, D>,
    frame: &Frame<BinaryColor, Rows, impl AsRef<[u8]>>,
    dirty: &mut Dirty<impl AsRef<[Changed]> + AsMut<[Changed]>>,
    buffer: &mut [u8],
) -> Result<(), DisplayError> {
    if dirty.is_clean() {
        return Ok(());
    }
    for window in dirty.windows(frame, Grain::SSD1680) {
        let ([x, y, width, height], bytes) = in_one_piece(&window, buffer)?;
        panel.write_partial_bw_buffer(bytes, x, y, width, height)?;
    }
    panel.fast_refresh()?;
    // Old and new pixels, for the next fast refresh.
    for window in dirty.windows(frame, Grain::SSD1680) {
        let ([x, y, width, height], bytes) = in_one_piece(&window, buffer)?;
        panel.write_partial_red_buffer(bytes, x, y, width, height)?;
        panel.write_partial_bw_buffer(bytes, x, y, width, height)?;
    }
    dirty.clear();
    Ok(())
}

/// Where a window is, in whole bytes, and its bytes.
fn in_one_piece<'m>(window: &DirtyWindow<'m>, buffer: &'m mut [u8]) -> Result<([u32; 4], &'m [u8]), DisplayError> {
    let area = window.area();
    let place = [area.left.cast_unsigned(), area.top.cast_unsigned(), area.width().next_multiple_of(8), area.height()];
    let copy = |_: TooSmall| DisplayError::OutOfBoundsError;
    Ok((place, window.contiguous().map_or_else(|| window.copy_to(buffer).map_err(copy), Ok)?))
}

/// Shows a frame of 128 × 296 by `epd-waveshare`: 4740 bus writes of one byte each.
///
/// The driver sets `SINGLE_BYTE_WRITE` for this panel, as for most of its panels; each byte is an SPI
/// transaction of its own.
pub fn show_by_waveshare<S: SpiDevice, B: InputPin, C: OutputPin, R: OutputPin, D: DelayNs>(
    panel: &mut Epd2in9<S, B, C, R, D>,
    (spi, delay): (&mut S, &mut D),
    frame: &Frame<BinaryColor, Rows, impl AsRef<[u8]>>,
) -> Result<(), S::Error> {
    panel.update_frame(spi, frame.bytes(), delay)?;
    panel.display_frame(spi, delay)
}

type Weact = WeActStudio213BlackWhiteDriver<SPIInterface<Bus, Pin>, Pin, Pin, Bus>;

const WEACT: Panel = Panel { name: "WeAct 2.13\"", width: 122, height: 250, ..Panel::SHARP_400X240 };
const WAVESHARE: Panel = Panel { name: "Waveshare 2.9\" V2", width: 128, height: 296, ..Panel::SHARP_400X240 };

fn set_up_weact(bus: &Bus) -> Weact {
    let interface = SPIInterface::new(bus.clone(), bus.pin("D/C"));
    let mut panel = Weact::new(interface, bus.pin("BUSY"), bus.pin("RST"), bus.clone());
    panel.init().expect("infallible");
    bus.forget();
    panel
}

fn picture(panel: &Panel) -> Frame<BinaryColor, Rows, Vec<u8>> {
    one_bit(Frame::new(vec![0; panel.byte_len()], panel.width, panel.height).expect("large enough"))
}

fn command(command: u8, data: &[u8]) -> [Packet; 2] {
    [Packet::Command(vec![command]), Packet::Data(data.to_vec())]
}

/// Rows of the controller's memory and what goes there; 24h are the new pixels, 26h the old ones.
fn load(memory: u8, rows: Range<u8>, bytes: &[u8]) -> Vec<Packet> {
    load_window(memory, 0..16, rows, bytes)
}

/// A window, in bytes of a row and in rows.
fn load_window(memory: u8, columns: Range<u8>, rows: Range<u8>, bytes: &[u8]) -> Vec<Packet> {
    let packets = [
        command(0x44, &[columns.start, columns.end - 1]),
        command(0x45, &[rows.start, 0, rows.end - 1, 0]),
        command(0x4E, &[columns.start]),
        command(0x4F, &[rows.start, 0]),
        command(memory, bytes),
    ];
    packets.into_iter().flatten().collect()
}

#[test]
fn a_frame_goes_out_in_place_four_times() {
    let (bus, frame) = (Bus::default(), picture(&WEACT));
    show(&mut set_up_weact(&bus), &frame).expect("infallible");

    let both = [load(0x26, 0..250, frame.bytes()), load(0x24, 0..250, frame.bytes())].concat();
    let refresh = [&command(0x22, &[0xF7])[..], &[Packet::Command(vec![0x20])]].concat();
    assert_eq!(bus.packets(), [&both[..], &refresh, &both].concat());
    assert_eq!(bus.cost(frame.bytes()), Cost { writes: 43, bytes: 16_059, in_place: 4 });
    let whole: Vec<_> = bus.writes().into_iter().filter(|write| write.is(frame.bytes())).collect();
    assert_eq!(whole.len(), 4);
    assert_shows(WEACT, &whole[3].bytes, &frame);
}

#[test]
fn rows_go_out_in_place_three_times() {
    let (bus, frame) = (Bus::default(), picture(&WEACT));
    let mut panel = set_up_weact(&bus);
    show(&mut panel, &frame).expect("infallible");
    bus.forget();
    show_rows(&mut panel, &frame, 100..140).expect("infallible");

    let rows = &frame.bytes()[16 * 100..16 * 140];
    let packets = bus.packets();
    assert_eq!(packets[..10], load(0x24, 100..140, rows));
    let after = [load(0x26, 100..140, rows), load(0x24, 100..140, rows)].concat();
    assert_eq!(packets[packets.len() - 20..], after);
    assert_eq!(bus.writes().iter().filter(|write| write.is(rows)).count(), 3);
    // The waveform, 32h and 153 bytes, comes once between them.
    assert_eq!(bus.cost(frame.bytes()), Cost { writes: 35, bytes: 3 * (14 + 640) + 154 + 3, in_place: 3 });
}

/// The panel shows a frame; then an area of it is turned over and shown.
fn show_inverted(area: Rectangle) -> (Bus, Frame<BinaryColor, Rows, Vec<u8>>) {
    let (bus, mut frame, mut dirty) = (Bus::default(), picture(&WEACT), Dirty::new([Changed::NOTHING; 250]));
    let mut panel = set_up_weact(&bus);
    show(&mut panel, &frame).expect("infallible");
    bus.forget();
    for color in [BinaryColor::On, BinaryColor::Off] {
        let Ok(()) = dirty.track(&mut frame).fill_solid(&area, color);
    }
    show_dirty(&mut panel, &frame, &mut dirty, &mut [0; 40]).expect("room for it");
    assert!(dirty.is_clean());
    (bus, frame)
}

#[test]
fn a_narrow_window_is_copied() {
    let (bus, frame) = show_inverted(Rectangle::new(Point::new(101, 200), Size::new(21, 10)));

    // The last byte has two pixels that exist.
    let rows = frame.bytes().chunks_exact(16).skip(200).take(10);
    let bytes = rows.flat_map(|row| &row[12..16]).copied().collect::<Vec<_>>();
    let packets = bus.packets();
    assert_eq!(packets[..10], load_window(0x24, 12..16, 200..210, &bytes));
    let after = [0x26, 0x24].map(|memory| load_window(memory, 12..16, 200..210, &bytes)).concat();
    assert_eq!(packets[packets.len() - 20..], after);
    assert_eq!(bus.cost(frame.bytes()), Cost { writes: 35, bytes: 3 * (14 + 40) + 154 + 3, in_place: 0 });
}

#[test]
fn a_wide_window_goes_out_in_place() {
    let (bus, frame) = show_inverted(Rectangle::new(Point::new(3, 20), Size::new(119, 40)));

    let rows = &frame.bytes()[16 * 20..16 * 60];
    assert_eq!(bus.packets()[..10], load(0x24, 20..60, rows));
    assert_eq!(bus.writes().iter().filter(|write| write.is(rows)).count(), 3);
    assert_eq!(bus.cost(frame.bytes()), Cost { writes: 35, bytes: 3 * (14 + 640) + 154 + 3, in_place: 3 });
}

#[test]
fn a_clean_frame_is_not_refreshed() {
    let (bus, frame) = (Bus::default(), picture(&WEACT));
    let mut panel = set_up_weact(&bus);
    show_dirty(&mut panel, &frame, &mut Dirty::new([Changed::NOTHING; 250]), &mut []).expect("nothing to do");
    assert_eq!(bus.events(), []);
}

#[test]
fn waveshare_goes_out_byte_by_byte() {
    let (mut bus, frame) = (Bus::default(), picture(&WAVESHARE));
    let (mut spi, pins) = (bus.clone(), ["BUSY", "D/C", "RST"].map(|name| bus.pin(name)));
    let [busy, dc, reset] = pins;
    let mut panel = Epd2in9::new(&mut spi, busy, dc, reset, &mut bus, None).expect("infallible");
    bus.forget();
    show_by_waveshare(&mut panel, (&mut spi, &mut bus), &frame).expect("infallible");

    let bytes = frame.bytes().iter().map(|&byte| Packet::Data(vec![byte]));
    let ends = [&command(0x22, &[0xC7])[..], &[Packet::Command(vec![0x20])]].concat();
    let packets: Vec<_> = [Packet::Command(vec![0x24])].into_iter().chain(bytes).chain(ends).collect();
    assert!(bus.packets() == packets, "24h, one write for each byte, 22h C7h, 20h");
    assert_eq!(bus.cost(frame.bytes()), Cost { writes: 4740, bytes: 4740, in_place: 0 });
    assert_shows(WAVESHARE, &bus.bytes()[1..=4736], &frame);
}
