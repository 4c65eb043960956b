//! Flood fill against a slow, exact search: every layout, every kind of target, torture pictures, bad input.

mod in_place;
mod layouts;
mod oracle;
mod patterns;
mod targets;
mod torture;

use aquatint::Rect;
use embedded_graphics::geometry::Point;
use oracle::Sheet;

/// A picture from text: `#` is 1, anything else 0.
fn sheet(rows: &[&str]) -> Sheet {
    let (width, height) = (rows.first().map_or(0, |row| row.len()), rows.len());
    let area = Rect::new(0, 0, i32::try_from(width).expect("short"), i32::try_from(height).expect("few"));
    Sheet::new(area, rows.concat().bytes().map(|sign| u8::from(sign == b'#')).collect())
}

/// Text from a picture; 2 and more are figures.
fn text(sheet: &Sheet) -> Vec<String> {
    let sign = |&code: &u8| ['.', '#'].get(usize::from(code)).copied().unwrap_or(char::from(b'0' + code));
    sheet.codes.chunks(sheet.area.width().max(1) as usize).map(|row| row.iter().map(sign).collect()).collect()
}

/// Every pixel of an area.
fn places(area: Rect) -> impl Iterator<Item = Point> {
    area.rows().flat_map(move |y| area.columns().map(move |x| Point::new(x, y)))
}
