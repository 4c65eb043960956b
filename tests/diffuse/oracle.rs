//! Error diffusion as the textbooks draw it: a whole picture of errors, one pixel after the other.

use aquatint::display::diffuse::Scan;

/// A kernel as a picture: `X` is the pixel, digits (and letters from A for 10) are weights.
#[derive(Clone, Copy, Debug)]
pub struct Drawn {
    pub rows: [&'static str; 3],
    pub divisor: i64,
}

pub const FLOYD_STEINBERG: Drawn = Drawn { rows: ["..X7.", ".351.", "....."], divisor: 16 };
pub const SIERRA_LITE: Drawn = Drawn { rows: ["..X2.", ".11..", "....."], divisor: 4 };
pub const SIERRA: Drawn = Drawn { rows: ["..X53", "24542", ".232."], divisor: 32 };
pub const BURKES: Drawn = Drawn { rows: ["..X84", "24842", "....."], divisor: 32 };
pub const JARVIS: Drawn = Drawn { rows: ["..X75", "35753", "13531"], divisor: 48 };
pub const STUCKI: Drawn = Drawn { rows: ["..X84", "24842", "12421"], divisor: 42 };
pub const ATKINSON: Drawn = Drawn { rows: ["..X11", ".111.", "..1.."], divisor: 8 };

impl Drawn {
    /// Columns ahead, rows down, weight.
    fn weights(self) -> Vec<(i64, usize, i64)> {
        let weight = |sign: char| sign.to_digit(16).map(i64::from);
        let row = |(down, row): (usize, &'static str)| {
            (-2..).zip(row.chars()).filter_map(move |(ahead, sign)| Some((ahead, down, weight(sign)?)))
        };
        self.rows.into_iter().enumerate().flat_map(row).collect()
    }

    /// Rounded down; kernels that are no power of two take their part first.
    fn share(self, error: i64, weight: i64) -> i64 {
        if self.divisor.count_ones() == 1 {
            (error * weight).div_euclid(self.divisor)
        } else {
            error.div_euclid(self.divisor) * weight
        }
    }
}

/// The codes of a picture.
pub fn diffuse(lights: &[Vec<u16>], levels: &[u16], kernel: Drawn, scan: Scan) -> Vec<Vec<u8>> {
    let (width, weights) = (lights[0].len(), kernel.weights());
    let last = i64::try_from(width).expect("small") - 1;
    let is_whole = weights.iter().map(|(_, _, weight)| weight).sum::<i64>() == kernel.divisor;
    let mut errors = vec![vec![0_i64; width]; lights.len() + 2];
    let mut codes = vec![vec![0; width]; lights.len()];
    for (y, row) in lights.iter().enumerate() {
        let is_leftwards = scan == Scan::Serpentine && y % 2 == 1;
        let order: Vec<usize> = if is_leftwards { (0..width).rev().collect() } else { (0..width).collect() };
        for x in order {
            let light = row[x].clamp(levels[0], levels[levels.len() - 1]);
            let value = i64::from(light) + errors[y][x];
            // The first of equally near ones is the darker.
            let nearest = (0..levels.len()).min_by_key(|&code| (i64::from(levels[code]) - value).abs()).expect("some");
            codes[y][x] = u8::try_from(nearest).expect("at most 256");
            let error = (value - i64::from(levels[nearest])).clamp(-32_767, 32_767);
            let mut rest = error;
            let mut give = |ahead: i64, down: usize, share: i64| {
                let to = i64::try_from(x).expect("small") + if is_leftwards { -ahead } else { ahead };
                // What would leave at a side goes to the outermost pixel, from the same row to the next.
                let down = if down == 0 && !(0..=last).contains(&to) { 1 } else { down };
                errors[y + down][usize::try_from(to.clamp(0, last)).expect("inside")] += share;
            };
            for &(ahead, down, weight) in &weights {
                let share = kernel.share(error, weight);
                rest -= share;
                give(ahead, down, share);
            }
            if is_whole {
                give(0, 1, rest);
            }
        }
        for (row, column) in [(1, 0), (1, width - 1), (2, 0), (2, width - 1)] {
            let error = &mut errors[y + row][column];
            *error = (*error).clamp(i16::MIN.into(), i16::MAX.into());
        }
    }
    codes
}
