//! Flood fill: the pixels that are joined with a seed, on any display that can be read.
//! Lecture 4.2.2.
//!
//! - **Takes** a picture and a [`Region`]: a seed, and what bounds the region. Sides join pixels, or
//!   sides and corners ([`Connectivity`]).
//! - **Gives** its spans, from top to bottom, once all of it is found: to be filled with a colour, with
//!   any ink, or with whatever a [`Sink`](crate::Sink) does.
//! - **Memory** of the caller's, two slices whose contents do not matter: [`words_needed`], a bit a pixel;
//!   and a queue of any length, six bytes an entry. Its length is a matter of speed alone: what does not
//!   fit is found again by passes over dirty rows. 16 entries are plenty for most pictures, and none
//!   at all are enough for any.
//! - **Cost** proportional to the region, and independent of the width of the screen. Frames of one bit a
//!   pixel are searched 32 pixels at a time.
//!
//! The picture is not written while it is searched. So a fill that is refused leaves it untouched, and ink that
//! looks like the old colour (a dither of it, or the colour itself) is filled like any other.
//!
//! ```text
//!   ··········      ··########      seed S: every pixel of its colour that is
//!   ··oooooo··      ··oooooo##      joined with it by sides (Connectivity::Four)
//!   ··o  S·o··      ··o    o##
//!   ··oooo o··      ··oooo o##
//! ```
//!
//! Without memory for a bit a pixel there is [`InPlace`], which may run out of queue.
//!
//! A. R. Smith, "Tint fill", Computer Graphics (SIGGRAPH) 13(2), 1979; P. S. Heckbert, "A seed fill algorithm",
//! *Graphics Gems*, 1990, for spans instead of pixels. Lecture 4.2.2 has both variants and the spans.

mod in_place;
mod queue;
mod search;
mod spans;
mod visited;

pub use in_place::{InPlace, InPlaceError};
pub use queue::Run;
pub use spans::{Filled, Found};
pub use visited::words_needed;

use embedded_graphics::{draw_target::DrawTarget, geometry::Point, image::GetPixel};

use crate::{
    error::describe,
    runs::{Inside, Runs},
    space::Rect,
    target::{Brush, Ink, Target},
};

use queue::Queue;
use search::Search;
use visited::Visited;

/// What is to be filled. A seed alone, a `Point`, is [`Region::Flood`].
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub enum Region<C> {
    /// Flood fill: the pixels of the seed's colour that are joined with it.
    Flood(Point),
    /// Boundary fill: the pixels joined with the seed, of whatever colour, up to those of the boundary's.
    /// Nothing when the seed lies on it.
    Boundary(Point, C),
}

impl<C> From<Point> for Region<C> {
    fn from(seed: Point) -> Self {
        Self::Flood(seed)
    }
}

impl<C: Copy + PartialEq> Region<C> {
    /// The seed, its colour, and what is inside; `None` when there is no pixel to begin with.
    fn begin<P>(self, picture: &P, window: Rect) -> Option<(Point, C, Inside<C>)>
    where
        P: GetPixel<Color = C> + ?Sized,
    {
        let (seed, border) = match self {
            Self::Flood(seed) => (seed, None),
            Self::Boundary(seed, border) => (seed, Some(border)),
        };
        let color = if window.contains(seed) { picture.pixel(seed)? } else { return None };
        let inside = border.map_or(Inside::Like(color), Inside::Unlike);
        inside.holds(color).then_some((seed, color, inside))
    }
}

/// Which pixels are neighbours.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub enum Connectivity {
    /// Those that share a side. A diagonal line of single pixels bounds the region.
    #[default]
    Four,
    /// Those that share a side or a corner.
    Eight,
}

/// Why nothing was searched. Nothing was drawn either.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub enum Refused {
    /// The visited bitmap is too short; see [`words_needed`].
    TooFewWords {
        /// How many words it must have.
        needed: usize,
    },
    /// The window has more than 65,535 columns or rows.
    TooLarge,
}

describe! {
    Refused,
    Self::TooFewWords { needed } => "{needed} words are needed";
    Self::TooLarge => "more than 65535 columns or rows";
}

/// Why a fill was not done.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub enum FloodError<E> {
    /// Before anything was drawn.
    Refused(Refused),
    /// What the display said, perhaps after a part was drawn.
    Display(E),
}

impl<E: core::fmt::Display> core::fmt::Display for FloodError<E> {
    fn fmt(&self, f: &mut core::fmt::Formatter<'_>) -> core::fmt::Result {
        match self {
            Self::Refused(refused) => refused.fmt(f),
            Self::Display(error) => error.fmt(f),
        }
    }
}

impl<E: core::fmt::Debug + core::fmt::Display> core::error::Error for FloodError<E> {}

/// Flood fill with a visited bitmap: always complete.
///
/// ```
/// use aquatint::{Flood, Frame, Pages, raster::flood::{Run, words_needed}};
/// use embedded_graphics::{pixelcolor::BinaryColor, prelude::*, primitives::{Circle, PrimitiveStyle}};
///
/// let mut frame = Frame::<BinaryColor, Pages, _>::with_array([0; 1024], 128, 64).unwrap();
/// Circle::new(Point::new(10, 10), 40).into_styled(PrimitiveStyle::with_stroke(BinaryColor::On, 1)).draw(&mut frame)?;
///
/// let (mut memory, mut queue) = ([0; words_needed(128, 64)], [Run::default(); 16]);
/// let mut flood = Flood::new(&mut memory, &mut queue);
/// let filled = flood.fill(&mut frame, Point::new(30, 30), BinaryColor::On).unwrap();
/// assert_eq!((filled.pixels, filled.bounds.left, filled.bounds.bottom), (1124, 11, 49));
/// # Ok::<(), core::convert::Infallible>(())
/// ```
///
/// The outside, by corners too, up to a boundary, with a pattern:
///
/// ```
/// # use aquatint::{Flood, Frame, Pages, raster::flood::{Run, words_needed}};
/// # use embedded_graphics::{pixelcolor::BinaryColor, prelude::*};
/// use aquatint::{Connectivity, Pattern, Region};
/// # let mut frame = Frame::<BinaryColor, Pages, _>::with_array([0; 1024], 128, 64).unwrap();
/// # let (mut memory, mut queue) = ([0; words_needed(128, 64)], [Run::default(); 16]);
/// let mut flood = Flood::new(&mut memory, &mut queue).with_connectivity(Connectivity::Eight);
/// let outside = Region::Boundary(Point::new(0, 0), BinaryColor::On);
/// let stripes = Pattern::new([[BinaryColor::On, BinaryColor::Off, BinaryColor::Off, BinaryColor::Off]]);
/// flood.fill_with(&mut frame, outside, stripes).unwrap();
/// assert_eq!(frame.bytes()[..6], [0xFF, 0, 0, 0, 0xFF, 0]);
/// ```
#[derive(Debug)]
pub struct Flood<'a> {
    memory: &'a mut [u32],
    queue: &'a mut [Run],
    connectivity: Connectivity,
    window: Option<Rect>,
}

impl<'a> Flood<'a> {
    /// Lends the visited bitmap, [`words_needed`] long, and a queue of any length. What they hold does not
    /// matter, now or between fills.
    #[must_use]
    pub const fn new(memory: &'a mut [u32], queue: &'a mut [Run]) -> Self {
        Self { memory, queue, connectivity: Connectivity::Four, window: None }
    }

    /// Which pixels are neighbours; those that share a side by default.
    #[must_use]
    pub const fn with_connectivity(self, connectivity: Connectivity) -> Self {
        Self { connectivity, ..self }
    }

    /// Keeps to a part of the picture, whose size then decides how many words are needed.
    #[must_use]
    pub const fn with_window(self, window: Rect) -> Self {
        Self { window: Some(window), ..self }
    }

    /// Fills a region with one colour. Nothing when the seed lies outside of the picture or the window.
    ///
    /// # Errors
    /// [`FloodError`].
    pub fn fill<T>(
        &mut self,
        target: &mut T,
        region: impl Into<Region<<T as GetPixel>::Color>>,
        color: <T as GetPixel>::Color,
    ) -> Result<Filled, FloodError<T::Error>>
    where
        T: Runs + DrawTarget<Color = <T as GetPixel>::Color>,
    {
        let found = self.search(target, region).map_err(FloodError::Refused)?;
        found.paint(target, color).map_err(FloodError::Display)
    }

    /// Fills a region with an ink. Nothing when the seed lies outside of the picture or the window.
    ///
    /// # Errors
    /// [`FloodError`].
    pub fn fill_with<T>(
        &mut self,
        target: &mut T,
        region: impl Into<Region<<T as GetPixel>::Color>>,
        ink: impl Ink<Color = <T as GetPixel>::Color>,
    ) -> Result<Filled, FloodError<T::Error>>
    where
        T: Runs + Target<Color = <T as GetPixel>::Color>,
    {
        let found = self.search(target, region).map_err(FloodError::Refused)?;
        found.spans(&mut Brush::new(target, ink)).map_err(FloodError::Display)
    }

    /// Finds a region without drawing. What is found may be drawn in any way, and on another target.
    ///
    /// ```
    /// use aquatint::{Brush, Dithered, Flood, Frame, Levels, Light, Rows, raster::flood::{Run, words_needed}};
    /// use embedded_graphics::{pixelcolor::BinaryColor, prelude::*};
    ///
    /// let mut frame = Frame::<BinaryColor, Rows, _>::with_array([0; 32], 16, 16).unwrap();
    /// let (mut memory, mut queue) = ([0; words_needed(16, 16)], [Run::default(); 4]);
    /// let mut flood = Flood::new(&mut memory, &mut queue);
    /// let region = flood.search(&frame, Point::new(5, 5)).unwrap();
    ///
    /// let mut light = Dithered::new(&mut frame, Levels::ONE_BIT);
    /// region.spans(&mut Brush::new(&mut light, Light(32_768)))?;
    /// assert_eq!(frame.bytes()[..4].iter().map(|byte| byte.count_ones()).sum::<u32>(), 16);
    /// # Ok::<(), core::convert::Infallible>(())
    /// ```
    ///
    /// # Errors
    /// [`Refused`].
    pub fn search<P: Runs>(&mut self, picture: &P, region: impl Into<Region<P::Color>>) -> Result<Found<'_>, Refused> {
        let window = part(picture.bounding_box().into(), self.window);
        let mut visited = Visited::new(self.memory, window)?;
        if let Some((seed, _, inside)) = region.into().begin(picture, window) {
            let (queue, connectivity) = (Queue::new(self.queue), self.connectivity);
            Search { picture, inside, window, connectivity, queue, visited: &mut visited }.from(seed);
        }
        Ok(Found::new(visited, window))
    }
}

/// What of a picture lies in a window, if there is one.
fn part(bounds: Rect, window: Option<Rect>) -> Rect {
    window.map_or(bounds, |window| window.intersection(bounds))
}
