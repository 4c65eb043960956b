//! Area averaging against the exact area.

mod oracle;
mod polygons;
