//! ST7789 on SPI by the crate `mipidsi`: shapes straight on the display, or a frame of four bits as its memory.

use std::ops::{Range, RangeInclusive};

use aquatint::{Dithered, FillStyle, Frame, Levels, Light, OnDrawTarget, Point2, Polygon, Rows, Target};
use embedded_graphics::{
    draw_target::DrawTarget,
    image::{GetPixel, Image, ImageRaw},
    pixelcolor::{BinaryColor, Gray4, Rgb565, raw::RawU16},
    prelude::*,
};
use mipidsi::{Builder, Display, interface::SpiInterface, models::ST7789};

use crate::bus::{Bus, Cost, Packet, Pin};
use crate::drawn;

/// Fills a polygon straight on a display of any kind, without a frame.
///
/// By `mipidsi`: for each span one window and one run of pixels, which are 7 bus writes (of them one empty) and
/// 11 bytes, and 2 for each pixel.
pub fn fill<D: DrawTarget>(display: &mut D, polygon: Polygon, color: D::Color) -> Result<(), D::Error> {
    polygon.into_styled(FillStyle::new(color)).draw(display)
}

/// Fills rows with one light in 16 greys, dithered: as much as a polygon for each row.
///
/// One light is a pattern of four pixels, and goes out as a run. Light that *changes* along a row would cost a
/// window a pixel: dither that into a frame, and [`flush`] it.
pub fn fill_rows<D>(display: &mut D, rows: Range<i32>, light: Light) -> Result<(), D::Error>
where
    D: DrawTarget<Color: From<Gray4>>,
{
    let mut greys = display.color_converted::<Gray4>();
    let mut target = OnDrawTarget::new(&mut greys);
    let mut dithered = Dithered::new(&mut target, Levels::SRGB_16);
    let columns = dithered.bounds().columns();
    for row in rows {
        dithered.fill_run(row, columns.clone(), [light])?;
    }
    Ok(())
}

/// Sends a frame of 240 × 240 in 16 greys: 28,800 bytes of memory where RGB565 would take 115,200.
///
/// By `mipidsi`: one window, 119 bus writes, 115,211 bytes, widened in the KiB of buffer of the `SpiInterface`.
pub fn flush<D>(display: &mut D, frame: &Frame<Gray4, Rows, impl AsRef<[u8]>>) -> Result<(), D::Error>
where
    D: DrawTarget<Color: From<Gray4>>,
{
    let picture = ImageRaw::<Gray4>::new(frame.bytes(), frame.size().width);
    Image::new(&picture, Point::zero()).draw(&mut display.color_converted())
}

type Tft<'a> = Display<SpiInterface<'a, Bus, Pin>, ST7789, Pin>;

fn set_up<'a>(bus: &Bus, buffer: &'a mut [u8]) -> Tft<'a> {
    let interface = SpiInterface::new(bus.clone(), bus.pin("D/C"), buffer);
    let builder = Builder::new(ST7789, interface).display_size(240, 240).reset_pin(bus.pin("RST"));
    let display = builder.init(&mut bus.clone()).expect("infallible");
    bus.forget();
    display
}

/// Pixels that came for a window.
struct Window {
    columns: RangeInclusive<u16>,
    rows: RangeInclusive<u16>,
    pixels: Vec<Rgb565>,
}

/// Takes the packets apart as the controller does: 2Ah columns, 2Bh rows, 2Ch pixels, all the highest byte first.
fn receive(packets: &[Packet]) -> Vec<Window> {
    let range = |data: &[u8]| {
        let &[a, b, c, d] = data else { panic!("first and last") };
        u16::from_be_bytes([a, b])..=u16::from_be_bytes([c, d])
    };
    let color = |bytes: &[u8]| Rgb565::from(RawU16::new(u16::from_be_bytes([bytes[0], bytes[1]])));
    let mut windows: Vec<Window> = Vec::new();
    let mut command = 0;
    for packet in packets {
        match (packet, command) {
            (Packet::Command(bytes), _) => command = bytes[0],
            (Packet::Data(data), 0x2A) => windows.push(Window { columns: range(data), rows: 0..=0, pixels: vec![] }),
            (Packet::Data(data), 0x2B) => windows.last_mut().expect("2Ah").rows = range(data),
            (Packet::Data(data), 0x2C) => {
                windows.last_mut().expect("2Ah").pixels.extend(data.chunks_exact(2).map(color));
            }
            _ => panic!("another command"),
        }
    }
    windows
}

/// Shows windows on a black panel.
fn show(windows: &[Window]) -> Vec<Rgb565> {
    let mut panel = vec![Rgb565::BLACK; 240 * 240];
    for Window { columns, rows, pixels } in windows {
        let places = rows.clone().flat_map(|row| columns.clone().map(move |column| (row, column)));
        assert_eq!(places.clone().count(), pixels.len(), "the window is full");
        for ((row, column), &pixel) in places.zip(pixels) {
            panel[240 * usize::from(row) + usize::from(column)] = pixel;
        }
    }
    panel
}

#[test]
fn a_polygon_costs_a_window_and_a_run_for_each_span() {
    let (bus, mut buffer) = (Bus::default(), [0; 512]);
    let arrow = [(20, 20), (120, 60), (220, 20), (120, 220)].map(|(x, y)| Point2::corner(x, y));
    let contours = [&arrow[..]];
    let polygon = Polygon::new(&contours).expect("in range");
    fill(&mut set_up(&bus, &mut buffer), polygon, Rgb565::CSS_ORANGE).expect("infallible");

    let mut frame = Frame::<BinaryColor, Rows, _>::new(vec![0; 30 * 240], 240, 240).expect("large enough");
    let Ok(()) = fill(&mut frame, polygon, BinaryColor::On);
    let windows = receive(&bus.packets());
    let points = frame.bounding_box().points().map(|point| frame.pixel(point).expect("inside"));
    let color = |bit: BinaryColor| if bit.is_on() { Rgb565::CSS_ORANGE } else { Rgb565::BLACK };
    let shown = show(&windows);
    assert!(shown == points.map(color).collect::<Vec<_>>(), "what a frame shows");

    // Two runs in most rows of the notch, one in most below; at the tips no pixel's centre is inside.
    let spans = shown.chunks(240).flat_map(|row| row.chunk_by(PartialEq::eq)).filter(|run| run[0] != Rgb565::BLACK);
    let spans = spans.count();
    assert_eq!(windows.len(), spans);
    assert!(windows.iter().all(|window| window.rows.clone().count() == 1));
    let pixels: usize = windows.iter().map(|window| window.pixels.len()).sum();
    assert_eq!(bus.cost(&[]), Cost { writes: 7 * spans, bytes: 11 * spans + 2 * pixels, in_place: 0 });
}

#[test]
fn a_dithered_row_costs_a_window() {
    let (bus, mut buffer) = (Bus::default(), [0; 512]);
    fill_rows(&mut set_up(&bus, &mut buffer), 100..104, Light(30_000)).expect("infallible");

    let mut frame = Frame::<Gray4, Rows, _>::new(vec![0; 120 * 240], 240, 240).expect("large enough");
    let Ok(()) = fill_rows(&mut frame, 100..104, Light(30_000));
    let windows = receive(&bus.packets());
    assert_eq!(windows.len(), 4);
    let points = frame.bounding_box().points().map(|point| Rgb565::from(frame.pixel(point).expect("inside")));
    assert!(show(&windows) == points.collect::<Vec<_>>(), "what a frame shows");
    assert_eq!(bus.cost(&[]), Cost { writes: 4 * 7, bytes: 4 * (11 + 480), in_place: 0 });
}

#[test]
fn changing_light_without_a_frame_costs_a_window_for_each_gap() {
    let (bus, mut buffer) = (Bus::default(), [0; 512]);
    let mut display = set_up(&bus, &mut buffer);
    let mut greys = display.color_converted::<Gray4>();
    let mut target = OnDrawTarget::new(&mut greys);
    // One pixel is left as it was.
    let ramp = (0..20).map(|step| (step != 8).then_some(Light(3000 * step)));
    Dithered::new(&mut target, Levels::SRGB_16).write_run(0, 0..20, ramp).expect("infallible");

    let windows = receive(&bus.packets());
    let columns: Vec<_> = windows.iter().map(|window| window.columns.clone()).collect();
    assert_eq!(columns, [0..=7, 9..=19]);
}

#[test]
fn a_frame_of_four_bits_costs_one_window() {
    let (bus, mut buffer) = (Bus::default(), [0; 1024]);
    let frame = Frame::<Gray4, Rows, _>::new(vec![0; 120 * 240], 240, 240).expect("large enough");
    let frame = drawn(frame, Levels::SRGB_16);
    flush(&mut set_up(&bus, &mut buffer), &frame).expect("infallible");

    let windows = receive(&bus.packets());
    let [Window { columns, rows, .. }] = &windows[..] else { panic!("one window") };
    assert_eq!((columns, rows), (&(0..=239), &(0..=239)));
    let points = frame.bounding_box().points().map(|point| Rgb565::from(frame.pixel(point).expect("inside")));
    assert!(show(&windows) == points.collect::<Vec<_>>(), "what the frame shows");
    // 112 buffers full and one half full.
    assert_eq!(bus.cost(frame.bytes()), Cost { writes: 6 + 113, bytes: 11 + 115_200, in_place: 0 });
}
