//! A test pattern that moves: a frame, two diagonals and a bar, on a 1-bit panel in a window.
//!
//! What the user does is printed. Space stops the bar, a drag moves it, Escape or `q` ends.

use std::error::Error;
use std::process::ExitCode;

use aquatint_simulator::{Event, Key, Panel, Window, Zoom};

const PANEL: Panel = Panel::SSD1306_128X64;
const BAR: u32 = 6;

fn main() -> ExitCode {
    match run() {
        Ok(()) => ExitCode::SUCCESS,
        Err(error) => {
            eprintln!("{error}");
            ExitCode::FAILURE
        }
    }
}

fn run() -> Result<(), Box<dyn Error>> {
    let zoom = Zoom { scale: 4, gap: 1 };
    let first = PANEL.render(&pattern(0), zoom)?;
    let mut window = Window::open("Test pattern", first.width(), first.height())?;
    let mut bar = 0;
    let mut moving = true;
    while window.is_open() {
        window.show(&PANEL.render(&pattern(bar), zoom)?)?;
        for event in window.events() {
            println!("{event:?}");
            match event {
                Event::Key(Key::Escape | Key::Character('q')) => return Ok(()),
                Event::Key(Key::Space) => moving = !moving,
                Event::Drag { dx, .. } => bar = bar.saturating_add_signed(dx / 4),
                Event::Key(_) => {}
            }
        }
        bar = (bar + u32::from(moving)) % PANEL.width;
    }
    Ok(())
}

/// The bytes of one frame: pages, eight pixels a byte, the topmost in the lowest bit.
fn pattern(bar: u32) -> Vec<u8> {
    let mut bytes = vec![0; PANEL.byte_len()];
    for y in 0..PANEL.height {
        for x in 0..PANEL.width {
            let frame = x == 0 || y == 0 || x == PANEL.width - 1 || y == PANEL.height - 1;
            let diagonal = x == y || x + y == PANEL.width - 1;
            if frame || diagonal || (bar..bar + BAR).contains(&x) {
                let byte = (y / 8 * PANEL.width + x) as usize;
                bytes[byte] |= 1 << (y % 8);
            }
        }
    }
    bytes
}
