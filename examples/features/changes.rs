//! A gauge of which only what has changed is sent.

use aquatint::{Changed, Dirty};
use embedded_graphics::{
    mono_font::{MonoTextStyleBuilder, ascii::FONT_6X10},
    prelude::*,
    primitives::{PrimitiveStyle, Rectangle},
    text::{Baseline, Text},
};

use super::{BYTES, Feature, PANEL, Screen, frame};
use crate::panel::{BLACK, GRAIN, HEIGHT, WHITE};

/// A number and a bar; everything is sent the first time.
pub struct Changes {
    bytes: [u8; BYTES],
    dirty: Dirty<[Changed; HEIGHT as usize]>,
}

impl Feature for Changes {
    const NEW: Self = Self { bytes: [0; BYTES], dirty: Dirty::new([Changed::NOTHING; HEIGHT as usize]) };

    fn draw(&mut self, number: u16, screen: &mut impl Screen) -> Option<()> {
        let Self { bytes, dirty } = self;
        let mut picture = frame(bytes)?;
        if number == 0 {
            let Ok(()) = picture.clear(BLACK);
            *dirty = Dirty::new([Changed::EVERYTHING; HEIGHT as usize]);
        }
        let style = MonoTextStyleBuilder::new().font(&FONT_6X10).text_color(WHITE).background_color(BLACK).build();
        let digits = [[b'0', b'7'], [b'0', b'8'], [b'1', b'1'], [b'2', b'6']].get(usize::from(number))?;
        let mut tracked = dirty.track(&mut picture);
        let digits = core::str::from_utf8(digits).ok()?;
        let Ok(_) = Text::with_baseline(digits, Point::new(2, 1), style, Baseline::Top).draw(&mut tracked);
        let bar = Rectangle::new(Point::new(20, 1), Size::new(4 + 9 * u32::from(number), 6));
        let Ok(()) = bar.intersection(&PANEL.into()).into_styled(PrimitiveStyle::with_fill(WHITE)).draw(&mut tracked);
        for window in dirty.windows(&picture, GRAIN) {
            screen.window(window.area());
            window.slices().for_each(|bytes| screen.data(bytes));
        }
        dirty.clear();
        Some(())
    }
}
