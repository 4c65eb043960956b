//! A live picture in a window.

use std::env;
use std::error::Error;
use std::fmt;

use minifb::{MouseButton, MouseMode, ScaleMode, WindowOptions};

use crate::picture::Picture;
use crate::window_events::{Event, Queue};

const FRAMES_PER_SECOND: usize = 60;

/// The longest side of a window: X11 ends the program when asked for more than it can count.
const LONGEST_SIDE: u32 = 16_384;

/// Whether there is a display to open a window on: on systems with X11, whether `DISPLAY` says
/// where it is. A Wayland desktop has one by way of `XWayland`.
#[must_use]
pub fn display_available() -> bool {
    cfg!(any(target_os = "macos", windows)) || env::var_os("DISPLAY").is_some_and(|display| !display.is_empty())
}

/// A window with a picture in it.
pub struct Window {
    inner: minifb::Window,
    queue: Queue,
    /// Where the mouse was last seen with the left button down.
    grip: Option<(i32, i32)>,
}

impl Window {
    /// Opens a window with a picture of this size inside.
    ///
    /// # Errors
    ///
    /// [`WindowError::NoDisplay`] when there is none, [`WindowError::Size`] when no screen is that
    /// large or a side is 0, and [`WindowError::Refused`] for whatever else the display objects to.
    pub fn open(title: &str, width: u32, height: u32) -> Result<Self, WindowError> {
        if !display_available() {
            return Err(WindowError::NoDisplay);
        }
        let possible = 1..=LONGEST_SIDE;
        if !possible.contains(&width) || !possible.contains(&height) {
            return Err(WindowError::Size { width, height });
        }
        let options = WindowOptions { scale_mode: ScaleMode::UpperLeft, ..WindowOptions::default() };
        // The title goes through C, where it would end at such a character.
        let title = title.replace('\0', " ");
        let mut inner =
            minifb::Window::new(&title, width as usize, height as usize, options).map_err(WindowError::refused)?;
        inner.set_target_fps(FRAMES_PER_SECOND);
        let queue = Queue::default();
        inner.set_input_callback(Box::new(queue.clone()));
        Ok(Self { inner, queue, grip: None })
    }

    /// Shows a picture, pixel for pixel, and listens to the user. Call it for every frame, also when
    /// the picture stays the same: it waits until a sixtieth of a second after the last call.
    ///
    /// A smaller picture is shown in the upper left, and what sticks out of the window is cut.
    ///
    /// # Errors
    ///
    /// [`WindowError::Refused`] when the display does not take it.
    pub fn show(&mut self, picture: &Picture) -> Result<(), WindowError> {
        let pixels: Vec<u32> =
            picture.rgb().chunks_exact(3).map(|pixel| u32::from_be_bytes([0, pixel[0], pixel[1], pixel[2]])).collect();
        if pixels.is_empty() {
            self.inner.update();
        } else {
            let (width, height) = (picture.width() as usize, picture.height() as usize);
            self.inner.update_with_buffer(&pixels, width, height).map_err(WindowError::refused)?;
        }
        self.follow_mouse();
        Ok(())
    }

    /// Whether the user has not closed the window yet.
    #[must_use]
    pub fn is_open(&self) -> bool {
        self.inner.is_open()
    }

    /// What the user did since the last call, as far as [`Window::show`] heard of it.
    pub fn events(&mut self) -> Vec<Event> {
        self.queue.drain()
    }

    fn follow_mouse(&mut self) {
        let Some(position) = self.inner.get_mouse_pos(MouseMode::Pass) else {
            return;
        };
        let position = whole(position);
        // Also when the button is up again: the way to where it was let go belongs to the drag.
        if let Some(grip) = self.grip.filter(|&grip| grip != position) {
            let (dx, dy) = (position.0 - grip.0, position.1 - grip.1);
            self.queue.push(Event::Drag { dx, dy });
        }
        let held = self.inner.get_mouse_down(MouseButton::Left);
        self.grip = held.then_some(position);
    }
}

impl fmt::Debug for Window {
    fn fmt(&self, formatter: &mut fmt::Formatter<'_>) -> fmt::Result {
        formatter
            .debug_struct("Window")
            .field("open", &self.is_open())
            .field("queue", &self.queue)
            .field("grip", &self.grip)
            .finish_non_exhaustive()
    }
}

/// Positions are rounded before they are subtracted, so that a slow drag does not lose its
/// fractions.
#[expect(clippy::cast_possible_truncation, reason = "a float beyond the range of an integer becomes its end")]
fn whole((x, y): (f32, f32)) -> (i32, i32) {
    const FARTHEST: f32 = 1e6;
    let round = |position: f32| position.round().clamp(-FARTHEST, FARTHEST) as i32;
    (round(x), round(y))
}

/// Why there is no window.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum WindowError {
    /// There is no display to open it on.
    NoDisplay,
    /// No screen has room for a window of this size.
    Size {
        /// Pixels across.
        width: u32,
        /// Pixels down.
        height: u32,
    },
    /// The display said no, in its own words.
    Refused(String),
}

impl WindowError {
    fn refused(error: minifb::Error) -> Self {
        let words = match error {
            minifb::Error::WindowCreate(words) | minifb::Error::UpdateFailed(words) => words,
            other => other.to_string(),
        };
        let display = env::var("DISPLAY").map_or_else(|_| "the display".to_owned(), |name| format!("display {name}"));
        Self::Refused(format!("{display} said: {}", words.replace('\n', " ")))
    }
}

impl fmt::Display for WindowError {
    fn fmt(&self, formatter: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::NoDisplay => {
                formatter.write_str("no window: DISPLAY names no X11 display (on Wayland, XWayland provides one)")
            }
            Self::Size { width, height } => {
                write!(formatter, "no window can be {width}x{height} pixels large")
            }
            Self::Refused(words) => write!(formatter, "no window: {words}"),
        }
    }
}

impl Error for WindowError {}
