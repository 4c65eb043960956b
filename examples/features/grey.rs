//! The panel of `mcu_grey`: an SSD0323 with 128 × 64 pixels of 4 bits.

use aquatint::{Grain, Levels, Rect, Rows};
use embedded_graphics::{pixelcolor::Gray4, prelude::*};

pub type Color = Gray4;
pub type Layout = Rows;
pub const WIDTH: u32 = 128;
pub const HEIGHT: u32 = 64;
pub const BLACK: Color = Gray4::BLACK;
pub const WHITE: Color = Gray4::WHITE;
/// The emulated panel shows code n as the grey 17n of a monitor.
pub const LEVELS: Levels<'static> = Levels::SRGB_16;
/// All features fit in the flash of the board.
pub const PART: Option<&str> = None;
/// Two columns in a byte; 15h and 75h with two arguments each open a window.
pub const GRAIN: Grain = Grain { columns: 2, rows: 1, overhead: 6 };

/// A window in lines of bytes: the first byte and the one behind the last, the first line and the one behind the last.
pub const fn in_bytes(area: Rect) -> [i32; 4] {
    [area.left / 2, area.right / 2, area.top, area.bottom]
}
