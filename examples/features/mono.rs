//! The panel of `mcu_mono`: an SSD0303 with 96 × 16 pixels of one bit, in pages of eight rows.

use aquatint::{Grain, Levels, Pages, Rect};
use embedded_graphics::pixelcolor::BinaryColor;

pub type Color = BinaryColor;
pub type Layout = Pages;
pub const WIDTH: u32 = 96;
pub const HEIGHT: u32 = 16;
pub const BLACK: Color = BinaryColor::Off;
pub const WHITE: Color = BinaryColor::On;
pub const LEVELS: Levels<'static> = Levels::ONE_BIT;
/// Which features are shown if `PART` does not say it: not all fit in the flash of the board.
pub const PART: Option<&str> = Some("flat");
/// A page at a time; three commands of two bytes, and the byte that says that data follow.
pub const GRAIN: Grain = Grain { columns: 1, rows: 8, overhead: 7 };

/// A window in lines of bytes: the first byte and the one behind the last, the first line and the one behind the last.
pub const fn in_bytes(area: Rect) -> [i32; 4] {
    [area.left, area.right, area.top / 8, area.bottom / 8]
}
