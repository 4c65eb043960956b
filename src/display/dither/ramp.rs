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
//! Where a fill ends is one division of 32 bits. A run across `n` switches is `n + 1` fills, whatever its length: a row of
//! a 4 × 4 mask has four switches from a level of the panel to the next, one of 8 × 8 has eight. Between two levels below
//! some dozen pixels, and where a panel of many levels has a switch every few pixels, the thresholds are cheaper.

use core::ops::Range;

use super::{Dithered, Mask};
use crate::{
    colour::Light,
    num::{FRACTION_16_15, bits, from_16_15, index, low_index, low_u8, to_16_15},
    shade::Shade,
    target::{Code, Target},
    vary::Ramp,
};

/// Runs between two levels that are shorter are dithered pixel by pixel.
const SHORTEST: u32 = 48;

/// Fills of fewer pixels, on average, cost more than the thresholds of their pixels.
const LEAST_FILL: u32 = 9;

/// What lights must reach between two levels to show the brighter one: 16.15 numbers, computed for a row when one asks.
#[derive(Clone, Copy, Debug)]
pub(super) struct Switches {
    rows: [[u32; 8]; 8],
    /// Of which rows, a bit each …
    known: u8,
    /// … and between which level and the next.
    code: u8,
    /// The last flat light of each row.
    flat: [Flat; 8],
}

/// How one light is shown in a row.
#[derive(Clone, Copy, Debug)]
struct Flat {
    light: Light,
    /// The darker of its two codes …
    code: u8,
    /// … and in which of eight columns the brighter one is shown, the first of them in the highest bit.
    byte: u8,
}

impl Flat {
    /// Black is the darkest code everywhere.
    const BLACK: Self = Self { light: Light::BLACK, code: 0, byte: 0 };
}

impl Switches {
    pub(super) const UNKNOWN: Self = Self { rows: [[0; 8]; 8], known: 0, code: 0, flat: [Flat::BLACK; 8] };

    /// Those of the columns 0 to 7 of a row, of which every eighth is alike, above the level of a code.
    #[inline]
    fn of_row(&mut self, code: u8, row: i32, exceeded: impl FnOnce() -> [u32; 8]) -> &[u32; 8] {
        if self.code != code {
            (self.code, self.known) = (code, 0);
        }
        let phase = index(row & 7);
        if self.known >> phase & 1 == 0 {
            self.known |= 1 << phase;
            if let Some(switches) = self.rows.get_mut(phase) {
                // A light must be greater: at least one more.
                *switches = exceeded().map(|light| (light + 1) << FRACTION_16_15);
            }
        }
        self.rows.get(phase).unwrap_or(&[u32::MAX; 8])
    }
}

impl<T: Target, M: Mask> Dithered<'_, '_, T, M>
where
    T::Color: Code,
{
    /// A run of one light.
    #[inline]
    pub(super) fn fill_flat(&mut self, row: i32, columns: Range<i32>, light: Light) -> Result<(), T::Error> {
        let last = self.switches.flat.get(index(row & 7)).copied().unwrap_or(Flat::BLACK);
        let Flat { code, byte, .. } = if last.light == light { last } else { self.find_flat(row, light) };
        self.target.fill_bits(row, columns, neighbours(code), byte)
    }

    /// The same of a light that knows how it is shown.
    #[inline]
    pub(super) fn draw_shade(&mut self, row: i32, columns: Range<i32>, shade: &mut Shade) -> Result<(), T::Error> {
        let (code, byte) = shade.in_row(row, |light| {
            let Flat { code, byte, .. } = self.find_flat(row, light);
            (code, byte)
        });
        self.target.fill_bits(row, columns, neighbours(code), byte)
    }

    /// How a light is shown in a row, which is kept for the next run.
    #[inline(never)]
    fn find_flat(&mut self, row: i32, light: Light) -> Flat {
        self.shades.move_to(light);
        let code = self.shades.darker();
        let (shades, mask) = (&self.shades, &self.mask);
        let switches = self.switches.of_row(code, row, || shades.switches(mask.eight(row)));
        // Below zero, so that the highest bit is set, where the switch is reached.
        let below = to_16_15(light.0) + 1;
        let bits =
            |switches: &[u32]| switches.iter().fold(0, |bits, switch| bits << 1 | switch.wrapping_sub(below) >> 31);
        let byte = low_u8(match switches {
            [a @ .., _, _, _, _] if M::IN_FOUR => bits(a) * 0x11,
            all => bits(all),
        });
        let flat = Flat { light, code, byte: byte ^ turned::<T::Color>(code) };
        if let Some(last) = self.switches.flat.get_mut(index(row & 7)) {
            *last = flat;
        }
        flat
    }

    /// Draws a run in the best way.
    #[inline]
    pub(super) fn draw_ramp(&mut self, row: i32, columns: Range<i32>, ramp: Ramp<1>) -> Result<(), T::Error> {
        let length = bits(columns.end.wrapping_sub(columns.start));
        if !M::REPEATS {
            self.write_run(row, columns, ramp.map(|[light]| Some(Light(light))))
        } else if length < SHORTEST && self.is_in_one_step(length, &ramp) {
            self.draw_in_one_step(row, columns, ramp)
        } else if self.is_steep(&ramp) {
            self.write_run(row, columns, ramp.map(|[light]| Some(Light(light))))
        } else {
            self.draw_rays(row, columns, ramp)
        }
    }

    /// Whether there are so many switches that the thresholds are cheaper.
    #[inline]
    fn is_steep(&mut self, ramp: &Ramp<1>) -> bool {
        self.shades.move_to(Light(from_16_15(ramp.fine()[0])));
        let (dark, bright) = self.shades.ends();
        let switches = if M::IN_FOUR { 4 } else { 8 };
        let columns = LEAST_FILL * switches * (ramp.steps()[0].cast_signed().unsigned_abs() >> FRACTION_16_15);
        bright.saturating_sub(dark) < columns
    }

    /// Whether the run begins and ends between the same two levels.
    #[inline]
    fn is_in_one_step(&mut self, length: u32, ramp: &Ramp<1>) -> bool {
        let light = |mut ramp: Ramp<1>| Light(from_16_15(ramp.next_fine()[0]));
        self.shades.move_to(light(ramp.clone()));
        self.shades.is_at(light(ramp.clone().skipped(length.wrapping_sub(1))))
    }

    /// Pixel by pixel between two levels: one comparison each.
    #[inline]
    fn draw_in_one_step(&mut self, row: i32, columns: Range<i32>, ramp: Ramp<1>) -> Result<(), T::Error> {
        let code = self.shades.darker();
        let turned = turned::<T::Color>(code);
        // From a multiple of eight on: what lies before the run is not written.
        let mut ramp = ramp.skipped(bits(columns.start & 7).wrapping_neg());
        let (shades, mask) = (&self.shades, &self.mask);
        let switches = self.switches.of_row(code, row, || shades.switches(mask.eight(row)));
        self.target.write_bits(row, columns, neighbours(code), move || {
            let byte = switches.iter().fold(0, |byte, switch| {
                let [light] = ramp.next_fine();
                byte << 1 | u8::from(light >= *switch)
            });
            byte ^ turned
        })
    }

    /// The same of lights of any kind, where there are but two levels.
    #[inline]
    pub(super) fn write_one_step(
        &mut self,
        row: i32,
        columns: Range<i32>,
        mut lights: impl Iterator<Item = Light>,
    ) -> Result<(), T::Error> {
        let colors = [T::Color::from_code(0), T::Color::from_code(1)];
        let (shades, mask) = (&self.shades, &self.mask);
        let switches = self.switches.of_row(0, row, || shades.switches(mask.eight(row)));
        // Pixels of the first eight that are before the run, and all that are in it.
        let (mut before, mut left) = (index(columns.start & 7), index(columns.end.wrapping_sub(columns.start)));
        self.target.write_bits(row, columns, colors, move || {
            let end = before.saturating_add(left).min(8);
            let wanted = switches.get(core::mem::take(&mut before)..end).unwrap_or_default();
            left -= wanted.len();
            let byte = wanted.iter().fold(0_u8, |byte, switch| {
                let light = lights.next().unwrap_or_default();
                byte << 1 | u8::from(to_16_15(light.0) >= *switch)
            });
            byte.checked_shl(8 - low_index(end)).unwrap_or(0)
        })
    }

    /// Fill by fill.
    #[inline(never)]
    fn draw_rays(&mut self, row: i32, columns: Range<i32>, ramp: Ramp<1>) -> Result<(), T::Error> {
        let Some(visible) = self.target.bounds().clip_run(row, columns.clone()) else { return Ok(()) };
        let mut ramp = ramp.skipped(bits(visible.start.wrapping_sub(columns.start)));
        let mut start = visible.start;
        while start < visible.end {
            let ([fine], [step]) = (ramp.fine(), ramp.steps());
            let light = Light(from_16_15(fine));
            self.shades.move_to(light);
            let next = self.next_switch(row, fine, step.cast_signed());
            let left = bits(visible.end.wrapping_sub(start));
            let length = next.map_or(left, |switch| steps_to(switch, fine, step.cast_signed())).min(left).max(1);
            let end = start.wrapping_add(length.cast_signed());
            self.fill_flat(row, start..end, light)?;
            ramp = ramp.skipped(length);
            start = end;
        }
        Ok(())
    }

    /// The light at which the codes of eight columns change next, a 16.15 number: the first above if it rises, that
    /// below which they change if it falls.
    fn next_switch(&mut self, row: i32, fine: u32, step: i32) -> Option<u32> {
        let (dark, bright) = self.shades.ends();
        let (shades, mask) = (&self.shades, &self.mask);
        let switches = self.switches.of_row(shades.darker(), row, || shades.switches(mask.eight(row)));
        let ends = [(bright + 1) << FRACTION_16_15, dark << FRACTION_16_15];
        let all = switches.iter().copied().chain(ends);
        // The fraction of the light itself does not count: it is below the next whole one.
        if step > 0 { all.filter(|&switch| switch > fine).min() } else { all.filter(|&switch| switch <= fine).max() }
    }
}

/// The colours of a code and of the next, between which bits choose that are [turned over](turned).
///
/// With one bit a pixel, a code and the next are always off and on, in either order: constants.
#[inline]
fn neighbours<C: Code>(code: u8) -> [C; 2] {
    if C::BITS == 1 { [0, 1].map(C::from_code) } else { [code, code.wrapping_add(1)].map(C::from_code) }
}

/// Which bits are to be turned over, if on comes before off: all or none.
#[inline]
const fn turned<C: Code>(code: u8) -> u8 {
    if C::BITS == 1 { 0_u8.wrapping_sub(code & 1) } else { 0 }
}

/// After how many steps a light that rises has reached a switch, or one that falls is below it.
fn steps_to(switch: u32, fine: u32, step: i32) -> u32 {
    if step > 0 {
        switch.saturating_sub(fine).div_ceil(step.unsigned_abs())
    } else {
        fine.saturating_sub(switch).checked_div(step.unsigned_abs()).map_or(u32::MAX, |steps| steps.saturating_add(1))
    }
}
