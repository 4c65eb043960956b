//! Panels on the desk.
//!
//! A display of 1 to 8 bits a pixel shows what its controller makes of the packed bytes it is
//! sent. This crate does the controller's part: it takes those bytes, takes them apart by the rules
//! of the panel's data sheet, and shows the result in the panel's own colours, as a file, in a
//! terminal or in a window. It shares no code with whatever packed the bytes, so a nibble in the
//! wrong place is seen here and not first on the board.
//!
//! | module       | what is in it                                                                |
//! |--------------|------------------------------------------------------------------------------|
//! | `panel`      | [`Panel`]: size, depth, layout and looks of one display                      |
//! | `packing`    | [`Packing`]: which bits of which byte hold which pixel                       |
//! | `codes`      | [`Codes`]: the bytes taken apart, one code a pixel; [`WrongLength`]          |
//! | `light`      | [`Response`]: how much light each code gives                                 |
//! | `theme`      | [`Theme`]: the colours of the darkest code, the lightest code and the gaps   |
//! | `zoom`       | [`Zoom`]: how large a panel pixel is drawn                                   |
//! | `picture`    | [`Picture`]: what the eye sees, in sRGB                                      |
//! | `file`       | [`save_png`] and [`Animation`]: small PNG files, whole or not there at all   |
//! | `terminal`   | [`half_blocks`] and [`braille`]: a picture as text                           |
//! | `window`     | `Window`, with the feature `window`: a live picture, keys and mouse drags    |
//!
//! ```
//! use aquatint_simulator::{Packing, Panel, Zoom, half_blocks};
//!
//! // Eight by two pixels, one bit each, the leftmost in the highest bit.
//! let panel = Panel { width: 8, height: 2, ..Panel::SHARP_400X240 };
//! let codes = panel.codes(&[0b1000_0001, 0b0001_1000])?;
//! assert_eq!(codes.get(0, 0), Some(1));
//! assert_eq!(codes.get(3, 1), Some(1));
//!
//! let picture = panel.render(&[0b1000_0001, 0b0001_1000], Zoom { scale: 4, gap: 1 })?;
//! assert_eq!((picture.width(), picture.height()), (32, 8));
//! println!("{}", half_blocks(&picture));
//! # Ok::<(), aquatint_simulator::WrongLength>(())
//! ```

#![forbid(unsafe_code)]
#![deny(missing_docs)]

mod codes;
mod draft;
mod file;
mod frames;
mod light;
mod packing;
mod palette;
mod panel;
mod picture;
mod render;
mod terminal;
mod theme;
#[cfg(feature = "window")]
mod window;
#[cfg(feature = "window")]
mod window_events;
mod zoom;

pub use codes::{Codes, WrongLength};
pub use file::{Animation, SaveError, save_png};
pub use light::Response;
pub use packing::Packing;
pub use panel::Panel;
pub use picture::Picture;
pub use terminal::{braille, half_blocks};
pub use theme::Theme;
#[cfg(feature = "window")]
pub use window::{Window, WindowError, display_available};
#[cfg(feature = "window")]
pub use window_events::{Event, Key};
pub use zoom::Zoom;
