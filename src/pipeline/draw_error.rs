//! What can go wrong while a mesh is drawn.

use core::{error::Error, fmt};

use super::MOST_PLANES;
use crate::error::OutOfRange;

/// Why a mesh was not drawn.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum DrawError<E> {
    /// The workspace holds fewer vertices than the mesh has. Nothing was drawn.
    TooFewVertices {
        /// How many are needed.
        needed: usize,
    },
    /// The instance is cut by more than [`MOST_PLANES`]. Nothing was drawn.
    TooManyPlanes,
    /// Placement, view and projection may take a vertex more than 4096 from the origin of clip
    /// space. Nothing was drawn.
    OutOfRange,
    /// The target failed while drawing.
    Target(E),
}

impl<E: fmt::Display> fmt::Display for DrawError<E> {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::TooFewVertices { needed } => write!(f, "{needed} vertices are needed"),
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
