//! How large a panel pixel is drawn.

/// How many pixels of a picture stand for one pixel of the panel.
///
/// Any two numbers will do; [`Zoom::fitted`] says which are used.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub struct Zoom {
    /// Picture pixels along each side of a panel pixel, the gap included.
    pub scale: u32,
    /// How many of these, at the right and at the bottom, show the space between panel pixels.
    ///
    /// A gap of 1 is a quarter of the way at a scale of 4 and close to half of the area, far more
    /// than on glass. It helps to count pixels; tones are judged without it.
    pub gap: u32,
}

impl Zoom {
    /// A picture as large as the panel, pixel for pixel.
    pub const NONE: Self = Self { scale: 1, gap: 0 };

    /// The longest side of a picture made larger. Beyond it a picture would be too large to keep in
    /// memory long before it is too large to count.
    pub const LONGEST_SIDE: u32 = 8192;

    /// The zoom that is used for a panel of this size.
    ///
    /// The scale is lowered until the longer side of the picture is at most
    /// [`Zoom::LONGEST_SIDE`], but not below 1, and is at least 1; the gap is lowered until one
    /// pixel of each panel pixel is left.
    #[must_use]
    pub fn fitted(self, width: u32, height: u32) -> Self {
        let longest = Self::LONGEST_SIDE / width.max(height).max(1);
        let scale = self.scale.min(longest).max(1);
        Self { scale, gap: self.gap.min(scale - 1) }
    }
}

#[cfg(test)]
mod tests {
    use super::Zoom;

    #[test]
    fn sensible_values_are_kept() {
        let zoom = Zoom { scale: 4, gap: 1 };
        assert_eq!(zoom.fitted(400, 240), zoom);
    }

    #[test]
    fn any_values_are_brought_into_range() {
        let everything = Zoom { scale: u32::MAX, gap: u32::MAX };
        assert_eq!(everything.fitted(128, 64), Zoom { scale: 64, gap: 63 });
        assert_eq!(everything.fitted(u32::MAX, 1), Zoom::NONE);
        assert_eq!(everything.fitted(0, 0), Zoom { scale: 8192, gap: 8191 });
        assert_eq!(Zoom { scale: 0, gap: 9 }.fitted(128, 64), Zoom::NONE);
    }
}
