//! The few colours of a panel, counted.

use std::collections::HashMap;

use png::BitDepth;

use crate::picture::Picture;

/// Up to 256 colours, in the order they were met.
#[derive(Debug, Default)]
pub(crate) struct Palette {
    colours: Vec<[u8; 3]>,
    indices: HashMap<[u8; 3], u8>,
}

impl Palette {
    /// The index of every pixel, with new colours added, or `None` when there are too many.
    pub(crate) fn indices(&mut self, picture: &Picture) -> Option<Vec<u8>> {
        let mut indices = Vec::with_capacity(picture.rgb().len() / 3);
        // Neighbours mostly share their colour: this saves most of the look-ups.
        let mut previous = None;
        for pixel in picture.rgb().chunks_exact(3) {
            let colour = [pixel[0], pixel[1], pixel[2]];
            let index = match previous {
                Some((same, index)) if same == colour => index,
                _ => self.index(colour)?,
            };
            previous = Some((colour, index));
            indices.push(index);
        }
        Some(indices)
    }

    fn index(&mut self, colour: [u8; 3]) -> Option<u8> {
        if let Some(&index) = self.indices.get(&colour) {
            return Some(index);
        }
        let index = u8::try_from(self.colours.len()).ok()?;
        self.colours.push(colour);
        self.indices.insert(colour, index);
        Some(index)
    }

    /// The way back from indices to red, green and blue bytes.
    pub(crate) fn rgb(&self, indices: &[u8]) -> Vec<u8> {
        indices.iter().flat_map(|&index| self.colours[usize::from(index)]).collect()
    }

    /// All colours, as a PNG file has them.
    pub(crate) fn bytes(&self) -> &[u8] {
        self.colours.as_flattened()
    }

    /// The fewest bits that hold every index.
    pub(crate) fn depth(&self) -> BitDepth {
        match self.colours.len() {
            0..=2 => BitDepth::One,
            3..=4 => BitDepth::Two,
            5..=16 => BitDepth::Four,
            _ => BitDepth::Eight,
        }
    }
}

/// Packs indices as PNG does: the leftmost in the highest bits, rows padded to whole bytes.
pub(crate) fn pack(indices: &[u8], width: u32, depth: BitDepth) -> Vec<u8> {
    let bits = depth as usize;
    indices
        .chunks(width.max(1) as usize)
        .flat_map(|row| row.chunks(8 / bits))
        .map(|pixels| {
            let slots = (0..8 / bits).map(|slot| 8 - bits * (slot + 1));
            pixels.iter().zip(slots).fold(0, |byte, (index, shift)| byte | index << shift)
        })
        .collect()
}

#[cfg(test)]
mod tests {
    use super::{Palette, pack};
    use crate::picture::Picture;
    use png::BitDepth;

    /// As many greys as asked for, then, from 256 on, as many reds.
    fn colourful(colours: u32) -> Picture {
        let rgb = (0..colours).flat_map(|colour| {
            let [_, _, more, grey] = colour.to_be_bytes();
            [grey.saturating_add(more), grey, grey]
        });
        Picture::from_rgb(colours, 1, rgb.collect()).expect("three bytes a pixel")
    }

    #[test]
    fn the_depth_is_the_least_that_does() {
        for (colours, depth) in [
            (1, BitDepth::One),
            (2, BitDepth::One),
            (3, BitDepth::Two),
            (4, BitDepth::Two),
            (5, BitDepth::Four),
            (16, BitDepth::Four),
            (17, BitDepth::Eight),
            (256, BitDepth::Eight),
        ] {
            let mut palette = Palette::default();
            let picture = colourful(colours);
            let indices = palette.indices(&picture).expect("256 colours at most");
            assert_eq!(palette.depth(), depth, "{colours} colours");
            assert_eq!(palette.rgb(&indices), picture.rgb());
        }
    }

    #[test]
    fn there_is_no_palette_of_257_colours() {
        assert_eq!(Palette::default().indices(&colourful(257)), None);
    }

    #[test]
    fn rows_are_packed_one_by_one() {
        assert_eq!(pack(&[1, 0, 1, 0, 1, 1], 3, BitDepth::One), [0b1010_0000, 0b0110_0000]);
        assert_eq!(pack(&[1, 2, 3], 3, BitDepth::Four), [0x12, 0x30]);
        assert_eq!(pack(&[7, 8], 1, BitDepth::Eight), [7, 8]);
        assert!(pack(&[], 0, BitDepth::Two).is_empty());
    }
}
