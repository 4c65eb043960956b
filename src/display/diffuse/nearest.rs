//! The level nearest to an amount of light and error.

use crate::{colour::Light, display::level::Levels, num::saturate_u16};

/// The levels of a panel, asked pixel by pixel.
pub(super) trait Nearest {
    /// The light as far as the panel can show it.
    fn displayable(&self, light: Light) -> i32;

    /// The code nearest to a value and the light that it gives. In the middle the darker one.
    fn nearest(&mut self, value: i32) -> (u32, i32);
}

/// [`Levels::ONE_BIT`], for which there is nothing to be looked up.
#[derive(Clone, Copy, Debug)]
pub(super) struct OneBit;

impl Nearest for OneBit {
    #[inline]
    fn displayable(&self, light: Light) -> i32 {
        i32::from(light.0)
    }

    #[inline]
    fn nearest(&mut self, value: i32) -> (u32, i32) {
        let is_white = value > i32::from(u16::MAX / 2);
        (u32::from(is_white), -i32::from(is_white) & i32::from(u16::MAX))
    }
}

/// Any levels. Remembers the last two neighbours, between which most of the next pixels are.
#[derive(Clone, Copy, Debug)]
pub(super) struct Steps<'l> {
    levels: Levels<'l>,
    darkest: u16,
    brightest: u16,
    /// The values of the step, both included: beyond the outer levels too.
    from: i32,
    to: i32,
    code: u32,
    dark: i32,
    bright: i32,
}

impl<'l> Steps<'l> {
    pub(super) fn new(levels: Levels<'l>) -> Self {
        let (darkest, brightest) = (levels.around(Light::BLACK).dark, levels.around(Light::WHITE).bright);
        // An empty step, which no value is in.
        Self { levels, darkest, brightest, from: 1, to: 0, code: 0, dark: 0, bright: 0 }
    }

    fn find(&mut self, value: i32) {
        let step = self.levels.around(Light(saturate_u16(value.into())));
        (self.code, self.dark, self.bright) = (step.code.into(), step.dark.into(), step.bright.into());
        self.from = if step.dark == self.darkest { i32::MIN } else { self.dark };
        self.to = if step.bright == self.brightest { i32::MAX } else { self.bright };
    }
}

impl Nearest for Steps<'_> {
    #[inline]
    fn displayable(&self, light: Light) -> i32 {
        light.0.max(self.darkest).min(self.brightest).into()
    }

    #[inline]
    fn nearest(&mut self, value: i32) -> (u32, i32) {
        if value < self.from || value > self.to {
            self.find(value);
        }
        if 2 * value > self.dark + self.bright {
            (self.code.saturating_add(1), self.bright)
        } else {
            (self.code, self.dark)
        }
    }
}
