//! A run of light that changes evenly, as few fills instead of a threshold a pixel. Lecture 2.2.2 and 7.4.
//!
//! In a row, each column of a mask has one threshold, and the light only rises or only falls. So a column's pixels switch
//! once, from there on to the end of the level: they are on along a *ray*. Between two switches the codes of eight
//! neighbouring columns repeat, which is a fill:
//!
//! ```text
//!   light      0.1 ─────────▶ 0.3 ────────▶ 0.5
//!   columns    #...#...#...#.#.#.#.#.#.#.#.#.##
//!              └─ fill ────┘└─ fill ──────────┘
//! ```
//!
//! Where a fill ends is one division of 32 bits. A run across `n` switches is `n + 1` fills, whatever its length: 17 at
//! most a level of the panel. Below some dozen pixels the thresholds are cheaper.

use core::ops::Range;

use super::{Dithered, Mask};
use crate::{
    colour::Light,
    num::{FRACTION_16_15, bits, from_16_15},
    target::{Code, Target},
    vary::Ramp,
};

/// Runs that are shorter are dithered pixel by pixel.
const SHORTEST: usize = 48;

impl<T: Target, M: Mask> Dithered<'_, '_, T, M>
where
    T::Color: Code,
{
    /// Draws a run that is inside of the target.
    pub(super) fn draw_ramp(&mut self, row: i32, columns: Range<i32>, ramp: Ramp<1>) -> Result<(), T::Error> {
        if M::REPEATS && columns.len() >= SHORTEST {
            self.draw_rays(row, columns, ramp)
        } else if M::REPEATS && columns.len() >= 8 && self.is_in_one_step(&columns, &ramp) {
            self.draw_in_one_step(row, columns, ramp)
        } else {
            self.write_run(row, columns, ramp.map(|[light]| Some(Light(light))))
        }
    }

    /// Whether the run begins and ends between the same two levels.
    fn is_in_one_step(&mut self, columns: &Range<i32>, ramp: &Ramp<1>) -> bool {
        let light = |ramp: Ramp<1>| ramp.map(|[light]| Light(light)).next().unwrap_or_default();
        let last = columns.end.wrapping_sub(columns.start).wrapping_sub(1);
        self.shades.move_to(light(ramp.clone()));
        self.shades.is_at(light(ramp.clone().skipped(bits(last))))
    }

    /// Pixel by pixel between two levels: one comparison each.
    fn draw_in_one_step(&mut self, row: i32, columns: Range<i32>, mut ramp: Ramp<1>) -> Result<(), T::Error> {
        // What a light must reach, with its fraction.
        let switches = self.shades.switches(self.mask.eight(row)).map(|switch| (switch + 1) << FRACTION_16_15);
        let code = self.shades.darker();
        let (dark, bright) = (T::Color::from_code(code), T::Color::from_code(code.wrapping_add(1)));
        let mut column = columns.start;
        let codes = core::iter::repeat_with(move || {
            let switch = switches.get((column & 7).cast_unsigned() as usize).copied().unwrap_or_default();
            column = column.wrapping_add(1);
            let [light] = ramp.next_fine();
            Some(if light >= switch { bright } else { dark })
        });
        self.target.write_run(row, columns, codes)
    }

    /// Fill by fill.
    fn draw_rays(&mut self, row: i32, columns: Range<i32>, mut ramp: Ramp<1>) -> Result<(), T::Error> {
        let thresholds = self.mask.eight(row);
        let mut start = columns.start;
        while start < columns.end {
            let [fine] = ramp.clone().next_fine();
            let [step] = ramp.steps();
            let light = Light(from_16_15(fine));
            let codes = self.shades.eight(light, thresholds).map(T::Color::from_code);
            let left = bits(columns.end.wrapping_sub(start));
            let switch = self.next_switch(light, step.cast_signed(), thresholds);
            let length = switch.map_or(left, |switch| steps_to(switch, fine, step.cast_signed())).clamp(1, left);
            let end = start.wrapping_add(length.cast_signed());
            self.target.fill_run(row, start..end, codes)?;
            ramp = ramp.skipped(length);
            start = end;
        }
        Ok(())
    }

    /// The light at which the codes of eight columns change next: the first above if it rises, that below which they
    /// change if it falls.
    fn next_switch(&self, light: Light, step: i32, thresholds: [u16; 8]) -> Option<u32> {
        // A light must be greater than a switch: at least one more.
        let (dark, bright) = self.shades.ends();
        let switches = self.shades.switches(thresholds).into_iter().chain([bright]).map(|switch| switch + 1);
        let (all, light) = (switches.chain([dark]), u32::from(light.0));
        if step > 0 { all.filter(|&switch| switch > light).min() } else { all.filter(|&switch| switch <= light).max() }
    }
}

/// After how many steps a light that rises has reached a switch, or one that falls is below it.
fn steps_to(switch: u32, fine: u32, step: i32) -> u32 {
    let switch = switch << FRACTION_16_15;
    if step > 0 {
        switch.saturating_sub(fine).div_ceil(step.unsigned_abs())
    } else {
        fine.saturating_sub(switch).checked_div(step.unsigned_abs()).map_or(u32::MAX, |steps| steps.saturating_add(1))
    }
}
