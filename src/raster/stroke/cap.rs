//! How a stroke ends.
//!
//! ```text
//!   butt           square              round
//!   ━━━━━━━●       ━━━━━━━●━━━━●       ━━━━━━━●─●╮
//!          ┃              ┃    ┃              ┃   ●
//!   ┄┄┄┄┄┄┄○       ┄┄┄┄┄┄┄○    ┃       ┄┄┄┄┄┄┄○   ●     ○ the end of the line
//!          ┃              ┃    ┃              ┃   ●
//!   ━━━━━━━●       ━━━━━━━●━━━━●       ━━━━━━━●─●╯
//! ```

use super::{direction::Direction, join::Corner};
use crate::{outline::Pen, space::Point2, style::Cap};

/// Draws what is behind the end of a segment that arrives there in a direction.
pub(super) fn cap(at: Point2, direction: Direction, (cap, width, turn): (Cap, u16, (i32, i32)), pen: &mut impl Pen) {
    match cap {
        Cap::Butt => {}
        Cap::Round => Corner::about_end(at, direction).round(width, turn, pen),
        Cap::Square => {
            let right = direction.right().half(width);
            let (ahead, left) = (right.left(), right.reversed());
            pen.move_to(left.from(at));
            pen.line_to(left.plus(ahead).from(at));
            pen.line_to(right.plus(ahead).from(at));
            pen.line_to(right.from(at));
            pen.close();
        }
    }
}
