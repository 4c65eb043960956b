//! A panel's bytes taken apart.

use std::error::Error;
use std::fmt;

/// One code a pixel: what the controller drives the glass with.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Codes {
    /// Pixels in a row.
    pub width: u32,
    /// Rows.
    pub height: u32,
    /// How many codes there are; the lightest is `levels - 1`.
    pub levels: u16,
    /// The codes, row by row from the top, from the left in each row.
    pub values: Vec<u8>,
}

impl Codes {
    /// The code at column `x` of row `y`, or `None` outside the panel.
    #[must_use]
    pub fn get(&self, x: u32, y: u32) -> Option<u8> {
        if x >= self.width || y >= self.height {
            return None;
        }
        let index = (y as usize).checked_mul(self.width as usize)?.checked_add(x as usize)?;
        self.values.get(index).copied()
    }
}

/// Bytes were handed over that are not as many as the panel or picture needs.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct WrongLength {
    /// How many bytes there had to be.
    pub expected: usize,
    /// How many there were.
    pub found: usize,
}

impl WrongLength {
    pub(crate) fn check(expected: usize, found: usize) -> Result<(), Self> {
        if expected == found { Ok(()) } else { Err(Self { expected, found }) }
    }
}

impl fmt::Display for WrongLength {
    fn fmt(&self, formatter: &mut fmt::Formatter<'_>) -> fmt::Result {
        let Self { expected, found } = self;
        write!(formatter, "expected {expected} bytes, found {found}")
    }
}

impl Error for WrongLength {}

#[cfg(test)]
mod tests {
    use super::Codes;

    #[test]
    fn there_is_no_code_outside_the_panel() {
        let codes = Codes { width: 2, height: 2, levels: 4, values: vec![0, 1, 2, 3] };
        assert_eq!(codes.get(1, 0), Some(1));
        assert_eq!(codes.get(0, 1), Some(2));
        assert_eq!(codes.get(2, 0), None);
        assert_eq!(codes.get(0, 2), None);
        assert_eq!(codes.get(u32::MAX, u32::MAX), None);
    }
}
