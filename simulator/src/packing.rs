//! Which bits of which byte hold which pixel.

/// The order of pixels in the bytes a panel is sent.
///
/// A byte holds `8 / bits` pixels. A depth that does not divide a byte leaves bits of each byte
/// unused.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum Packing {
    /// Rows from the top, each padded to a whole byte; of the pixels in a byte the leftmost is in
    /// the most significant bits.
    RowsMsbFirst,
    /// Rows from the top, each padded to a whole byte; of the pixels in a byte the leftmost is in
    /// the least significant bits.
    RowsLsbFirst,
    /// Pages, as the SSD1306 has them: a byte holds pixels one below the other (eight of one bit),
    /// the topmost in the least significant bits. Bytes run along x, then comes the next page. The
    /// last page is whole even where the panel ends inside it.
    PagesLsbTop,
}

/// What a packing needs to know of a panel.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Grid {
    width: usize,
    height: usize,
    bits: usize,
}

impl Grid {
    /// A depth outside 1 to 8 is taken as the nearest inside: no byte could hold it otherwise.
    pub(crate) fn new(width: u32, height: u32, bits: u8) -> Self {
        Self { width: width as usize, height: height as usize, bits: usize::from(bits.clamp(1, 8)) }
    }

    pub(crate) fn levels(self) -> u16 {
        1 << self.bits
    }

    fn pixels_per_byte(self) -> usize {
        8 / self.bits
    }

    fn bytes_per_row(self) -> usize {
        self.width.div_ceil(self.pixels_per_byte())
    }
}

impl Packing {
    pub(crate) fn byte_len(self, grid: Grid) -> usize {
        match self {
            Self::RowsMsbFirst | Self::RowsLsbFirst => grid.bytes_per_row().saturating_mul(grid.height),
            Self::PagesLsbTop => {
                let pages = grid.height.div_ceil(grid.pixels_per_byte());
                grid.width.saturating_mul(pages)
            }
        }
    }

    /// One code a pixel, row by row. `bytes` must be as long as [`Self::byte_len`] says.
    pub(crate) fn decode(self, bytes: &[u8], grid: Grid) -> Vec<u8> {
        let mut codes = Vec::with_capacity(grid.width * grid.height);
        for y in 0..grid.height {
            for x in 0..grid.width {
                codes.push(self.code_at(bytes, grid, (x, y)));
            }
        }
        codes
    }

    fn code_at(self, bytes: &[u8], grid: Grid, (x, y): (usize, usize)) -> u8 {
        let per_byte = grid.pixels_per_byte();
        let (byte, shift) = match self {
            Self::RowsMsbFirst => (y * grid.bytes_per_row() + x / per_byte, 8 - grid.bits * (x % per_byte + 1)),
            Self::RowsLsbFirst => (y * grid.bytes_per_row() + x / per_byte, grid.bits * (x % per_byte)),
            Self::PagesLsbTop => (y / per_byte * grid.width + x, grid.bits * (y % per_byte)),
        };
        let mask = u8::MAX >> (8 - grid.bits);
        (bytes[byte] >> shift) & mask
    }
}

#[cfg(test)]
mod tests {
    use super::{Grid, Packing};

    #[test]
    fn rows_are_padded_to_whole_bytes() {
        assert_eq!(Packing::RowsMsbFirst.byte_len(Grid::new(9, 3, 1)), 6);
        assert_eq!(Packing::RowsLsbFirst.byte_len(Grid::new(3, 3, 4)), 6);
        assert_eq!(Packing::RowsMsbFirst.byte_len(Grid::new(5, 2, 2)), 4);
        assert_eq!(Packing::RowsMsbFirst.byte_len(Grid::new(5, 2, 8)), 10);
    }

    #[test]
    fn the_last_page_is_whole() {
        assert_eq!(Packing::PagesLsbTop.byte_len(Grid::new(5, 9, 1)), 10);
    }

    #[test]
    fn no_size_and_no_depth_panics() {
        for packing in [Packing::RowsMsbFirst, Packing::PagesLsbTop] {
            for bits in 0..=u8::MAX {
                assert!(packing.byte_len(Grid::new(u32::MAX, u32::MAX, bits)) > 0);
                assert_eq!(packing.byte_len(Grid::new(0, 0, bits)), 0);
                let grid = Grid::new(3, 3, bits);
                let bytes = vec![0xff; packing.byte_len(grid)];
                let codes = packing.decode(&bytes, grid);
                assert_eq!(codes, [u8::MAX >> (8 - bits.clamp(1, 8)); 9]);
            }
        }
    }
}
