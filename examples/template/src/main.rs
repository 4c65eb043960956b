//! A turning solid on an SSD1306 OLED of 128 × 64 pixels, at the I²C pins GP4 (SDA) and GP5 (SCL) of a Raspberry Pi Pico.
#![no_std]
#![no_main]

mod picture;

use aquatint::Angle;
use panic_halt as _;
use picture::{Memory, Screen};
use rp2040_hal::{I2C, Sio, Watchdog, clocks::init_clocks_and_plls, fugit::RateExtU32, gpio, pac};
use ssd1306::{I2CDisplayInterface, Ssd1306, command::AddrMode, prelude::*};

/// The chip runs these 256 bytes first. They set up its flash.
#[unsafe(link_section = ".boot2")]
#[used]
static BOOT2: [u8; 256] = rp2040_boot2::BOOT_LOADER_GENERIC_03H;

/// The crystal of the Pico.
const CRYSTAL_HZ: u32 = 12_000_000;

#[rp2040_hal::entry]
fn main() -> ! {
    // The chip: its clocks at full speed, and two pins as a bus, pulled up.
    let pac::Peripherals {
        WATCHDOG, XOSC, CLOCKS, PLL_SYS, PLL_USB, SIO, IO_BANK0, PADS_BANK0, I2C0, mut RESETS, ..
    } = pac::Peripherals::take().unwrap();
    let mut watchdog = Watchdog::new(WATCHDOG);
    let clocks =
        init_clocks_and_plls(CRYSTAL_HZ, XOSC, CLOCKS, PLL_SYS, PLL_USB, &mut RESETS, &mut watchdog).ok().unwrap();
    let pins = gpio::Pins::new(IO_BANK0, PADS_BANK0, Sio::new(SIO).gpio_bank0, &mut RESETS);
    let sda = pins.gpio4.reconfigure::<gpio::FunctionI2C, gpio::PullUp>();
    let scl = pins.gpio5.reconfigure::<gpio::FunctionI2C, gpio::PullUp>();
    let bus = I2C::i2c0(I2C0, sda, scl, 400.kHz(), &mut RESETS, &clocks.system_clock);

    // The panel: in horizontal mode it takes all of its bytes in one go.
    let mut panel = Ssd1306::new(I2CDisplayInterface::new(bus), DisplaySize128x64, DisplayRotation::Rotate0);
    panel.init_with_addr_mode(AddrMode::Horizontal).unwrap();

    // The picture, some 20 times a second. More than half of the time it is on its way to the panel.
    let mut screen = Screen::with_array([0; 1024], 128, 64).unwrap();
    let mut memory = Memory::NEW;
    let mut turn = Angle(0);
    loop {
        picture::draw(&mut screen, &mut memory, turn).unwrap();
        panel.set_draw_area((0, 0), (128, 64)).unwrap();
        panel.draw(screen.bytes()).unwrap();
        turn.0 = turn.0.wrapping_add(picture::STEP);
    }
}
