//! The depth test: which fragments pass, and whether they are remembered. Lecture 5.6.

use super::depth::Depth;

/// Which fragments pass, by what is stored at their pixel.
pub trait DepthFunction: Copy {
    /// Whether the depths of those that pass are stored.
    const STORES: bool = true;

    /// Whether a fragment at `depth` is seen where `stored` is the depth so far; greater is nearer.
    fn passes<D: Depth + Ord>(self, stored: D, depth: D) -> bool;
}

/// Nearer than what is stored. Strict, so that of two surfaces at the same depth the one drawn first stays.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct Nearer;

impl DepthFunction for Nearer {
    #[inline]
    fn passes<D: Depth + Ord>(self, stored: D, depth: D) -> bool {
        depth > stored
    }
}

/// The usual tests, chosen while the program runs.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub enum DepthTest {
    /// No fragment passes.
    Never,
    /// Nearer ones.
    #[default]
    Nearer,
    /// Those at the same depth, too: for a second pass over the same mesh.
    NotFarther,
    /// Only those at the same depth.
    Equal,
    /// Only those at another depth.
    NotEqual,
    /// Farther ones: what is hidden.
    Farther,
    /// Farther ones and those at the same depth.
    NotNearer,
    /// Every fragment.
    Always,
}

impl DepthFunction for DepthTest {
    #[inline]
    fn passes<D: Depth + Ord>(self, stored: D, depth: D) -> bool {
        match self {
            Self::Never => false,
            Self::Nearer => depth > stored,
            Self::NotFarther => depth >= stored,
            Self::Equal => depth == stored,
            Self::NotEqual => depth != stored,
            Self::Farther => depth < stored,
            Self::NotNearer => depth <= stored,
            Self::Always => true,
        }
    }
}

/// A test whose depths are not stored.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct Unstored<F>(pub(super) F);

impl<F: DepthFunction> DepthFunction for Unstored<F> {
    const STORES: bool = false;

    #[inline]
    fn passes<D: Depth + Ord>(self, stored: D, depth: D) -> bool {
        self.0.passes(stored, depth)
    }
}
