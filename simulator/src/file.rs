//! Pictures and animations as PNG files.
//!
//! A panel has few colours, so files have a palette and 1, 2, 4 or 8 bits a pixel; only a picture of
//! more than 256 colours is written in full colour.

use std::error::Error;
use std::fmt;
use std::io;
use std::path::{Path, PathBuf};

use crate::draft::Draft;
use crate::frames::Frames;
use crate::picture::Picture;

/// Writes a picture to a PNG file, replacing what was there.
///
/// # Errors
///
/// [`SaveError::Write`] when the file cannot be written, or the picture has no pixels. No part of a
/// file is left behind, and a file of that name is still what it was.
pub fn save_png(picture: &Picture, path: &Path) -> Result<(), SaveError> {
    let mut frames = Frames::new((picture.width(), picture.height()));
    frames.push(picture);
    Draft::create(path)
        .and_then(|draft| draft.publish(|file| frames.write_still(file)))
        .map_err(|source| SaveError::write(path, source))
}

/// An animated PNG file in the making, shown over and over by everything that shows web pages.
///
/// Frames are kept in memory, one byte a pixel, and written by [`Animation::finish`]: the palette
/// and the number of frames stand at the start of the file and are known only at the end. So a
/// recording can be stopped at any frame. Dropped unfinished, it leaves no file behind.
#[derive(Debug)]
pub struct Animation {
    draft: Draft,
    frames: Frames,
    frames_per_second: u16,
}

impl Animation {
    /// Starts an animation of pictures of this width and height. No frames a second count as one.
    ///
    /// # Errors
    ///
    /// [`SaveError::Write`] when no file can be written there: now, and not after all the frames
    /// have been drawn.
    pub fn create(path: &Path, size: (u32, u32), frames_per_second: u16) -> Result<Self, SaveError> {
        let draft = Draft::create(path).map_err(|source| SaveError::write(path, source))?;
        Ok(Self { draft, frames: Frames::new(size), frames_per_second })
    }

    /// Adds a frame.
    ///
    /// # Errors
    ///
    /// [`SaveError::WrongSize`] when the picture is of another size. The animation is still good.
    pub fn push(&mut self, picture: &Picture) -> Result<(), SaveError> {
        let expected = self.frames.size();
        let found = (picture.width(), picture.height());
        if found != expected {
            return Err(SaveError::WrongSize { expected, found });
        }
        self.frames.push(picture);
        Ok(())
    }

    /// Writes the file, of as many frames as there are, replacing what was there.
    ///
    /// # Errors
    ///
    /// [`SaveError::NoFrames`] when there are none, and [`SaveError::Write`] when the file cannot be
    /// written. No part of a file is left behind, and a file of that name is still what it was.
    pub fn finish(self) -> Result<(), SaveError> {
        if self.frames.is_empty() {
            return Err(SaveError::NoFrames);
        }
        let path = self.draft.path().to_path_buf();
        self.draft
            .publish(|file| self.frames.write_animated(file, self.frames_per_second))
            .map_err(|source| SaveError::write(&path, source))
    }
}

/// Why there is no file.
#[derive(Debug)]
pub enum SaveError {
    /// The file could not be written.
    Write {
        /// The file.
        path: PathBuf,
        /// What went wrong.
        source: io::Error,
    },
    /// A frame was of another size than the animation.
    WrongSize {
        /// Width and height of the animation.
        expected: (u32, u32),
        /// Width and height of the frame.
        found: (u32, u32),
    },
    /// The animation was finished before its first frame.
    NoFrames,
}

impl SaveError {
    fn write(path: &Path, source: io::Error) -> Self {
        let path = path.to_path_buf();
        Self::Write { path, source }
    }
}

impl fmt::Display for SaveError {
    fn fmt(&self, formatter: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Write { path, source } => {
                write!(formatter, "cannot write {}: {source}", path.display())
            }
            Self::WrongSize { expected, found } => {
                write!(formatter, "expected a frame of {}x{}, found {}x{}", expected.0, expected.1, found.0, found.1)
            }
            Self::NoFrames => formatter.write_str("an animation needs at least one frame"),
        }
    }
}

impl Error for SaveError {
    fn source(&self) -> Option<&(dyn Error + 'static)> {
        match self {
            Self::Write { source, .. } => Some(source),
            Self::WrongSize { .. } | Self::NoFrames => None,
        }
    }
}
