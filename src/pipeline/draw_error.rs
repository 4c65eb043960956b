//! What can go wrong while a mesh is drawn.

use core::{convert::Infallible, error::Error, fmt};

use super::MOST_PLANES;
use crate::error::OutOfRange;

/// Why a mesh was not drawn.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub enum DrawError<E> {
    /// The workspace holds fewer vertices than the mesh has. Nothing was drawn.
    TooFewVertices {
        /// How many are needed.
        needed: usize,
    },
    /// More faces show in a [picture by rows](super::Scanlines) than there is room for. Nothing was drawn.
    TooFewFaces {
        /// How many are needed.
        needed: usize,
    },
    /// More faces reach into some row than there is room for, or there is no room at all for runs or buckets. Nothing was
    /// drawn.
    TooFewActive {
        /// How many are needed, at the most.
        needed: usize,
    },
    /// Faces hide each other in more parts than [`draw_compared`](super::draw_compared) has room for. Nothing was drawn.
    TooFewBounds {
        /// So many are enough; fewer may be.
        needed: usize,
    },
    /// Faces must be split, and there is no room for more pieces, their corners or their cuts in a
    /// [depth sort](super::draw_sorted). Nothing was drawn.
    TooFewPieces,
    /// The instance is cut by more than [`MOST_PLANES`]. Nothing was drawn.
    TooManyPlanes,
    /// Placement, view and projection may take a vertex more than 4096 from the origin of clip
    /// space. Nothing was drawn.
    OutOfRange,
    /// The target failed while drawing.
    Target(E),
}

impl DrawError<Infallible> {
    /// The same for any target: none has been drawn on.
    pub(super) const fn before_drawing<E>(self) -> DrawError<E> {
        match self {
            Self::TooFewVertices { needed } => DrawError::TooFewVertices { needed },
            Self::TooFewFaces { needed } => DrawError::TooFewFaces { needed },
            Self::TooFewActive { needed } => DrawError::TooFewActive { needed },
            Self::TooFewBounds { needed } => DrawError::TooFewBounds { needed },
            Self::TooFewPieces => DrawError::TooFewPieces,
            Self::TooManyPlanes => DrawError::TooManyPlanes,
            Self::OutOfRange => DrawError::OutOfRange,
        }
    }
}

impl<E: fmt::Display> fmt::Display for DrawError<E> {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::TooFewVertices { needed } => write!(f, "{needed} vertices are needed"),
            Self::TooFewFaces { needed } => write!(f, "{needed} faces are needed"),
            Self::TooFewActive { needed } => write!(f, "{needed} active faces are needed"),
            Self::TooFewBounds { needed } => write!(f, "{needed} bounds of parts are needed"),
            Self::TooFewPieces => write!(f, "more pieces of split faces are needed"),
            Self::TooManyPlanes => write!(f, "more than {MOST_PLANES} planes cut an instance"),
            Self::OutOfRange => OutOfRange.fmt(f),
            Self::Target(error) => error.fmt(f),
        }
    }
}

impl<E: Error + 'static> Error for DrawError<E> {
    fn source(&self) -> Option<&(dyn Error + 'static)> {
        if let Self::Target(error) = self { Some(error) } else { None }
    }
}
