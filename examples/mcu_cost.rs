//! What one feature costs: the flash, RAM and stack of a firmware that draws nothing else, and its instructions.
//!
//! `FEATURE` says, when compiling, which; `.ci/firmware report` builds all of them for all cores and writes `REPORT.md`. On
//! the panel of `mcu_grey`, but nothing is sent. Run on the desk, it prints the bytes that would be.
#![cfg_attr(target_os = "none", no_std, no_main)]
#![cfg_attr(
    target_os = "none",
    expect(clippy::too_many_arguments, reason = "the entry macro makes them of the statics")
)]

mod features;
#[path = "features/grey.rs"]
mod panel;
#[path = "features/plain.rs"]
mod plain;
mod scene;

#[cfg(target_os = "none")]
mod board;

#[cfg(target_os = "none")]
mod counting {
    use core::hint::black_box;

    use aquatint::Rect;

    use crate::{
        board::{report, semihosting, stack, ticks},
        features::{FRAMES, Feature, Screen},
    };

    /// Takes what is sent, and prints it or does nothing with it. One for both, so that each feature is linked once.
    struct Wire {
        prints: bool,
    }

    impl Screen for Wire {
        fn window(&mut self, area: Rect) {
            black_box(area);
        }

        fn data(&mut self, bytes: &[u8]) {
            if self.prints {
                semihosting::hex(bytes);
            }
        }
    }

    /// Counts the frames of a feature, and then prints them.
    pub fn count<F: Feature>(feature: &mut F) {
        stack::paint();
        for number in 0..FRAMES {
            let mut drawn = None;
            let instructions = ticks::measure(|| drawn = draw(feature, number, false));
            report("instructions", instructions);
            if drawn.is_none() {
                semihosting::exit(1);
            }
        }
        report("stack", stack::high_water());
        for number in 0..FRAMES {
            semihosting::puts("sent ");
            semihosting::decimal(number.into());
            semihosting::puts(" ");
            draw(feature, number, true);
            semihosting::puts("\n");
        }
    }

    /// A function of its own, so that it is linked once and its stack is its own.
    #[inline(never)]
    fn draw<F: Feature>(feature: &mut F, number: u16, prints: bool) -> Option<()> {
        feature.draw(number, &mut Wire { prints })
    }
}

/// The features by name, and the statics that hold their memory.
macro_rules! features {
    ($($name:literal => $memory:ident: $feature:ty),* $(,)?) => {
        #[cfg(target_os = "none")]
        #[cortex_m_rt::entry]
        fn main() -> ! {
            // First in the function: the entry macro makes them mutable references that only `main` has. Those of
            // features that are not drawn are not linked.
            $(static mut $memory: $feature = <$feature as features::Feature>::NEW;)*

            match option_env!("FEATURE") {
                $(Some($name) => counting::count($memory),)*
                _ => {}
            }
            board::semihosting::exit(0)
        }

        /// Prints what one feature, or all of them, would send.
        #[cfg(not(target_os = "none"))]
        fn main() {
            let wanted = std::env::args().nth(1);
            let is_wanted = |name: &str| wanted.as_ref().is_none_or(|wanted| wanted == name);
            $(if is_wanted($name) {
                features::print_sent::<$feature>();
            })*
        }
    };
}

features! {
    "nothing" => NOTHING: features::Nothing,
    "lines" => LINES: features::Lines,
    "polygons" => POLYGONS: features::Polygons,
    "flat" => FLAT: features::flat::Flat,
    "photo" => PHOTO: features::Photo,
    "text" => TEXT: features::Texts,
    "flood" => FLOOD: features::Floods,
    "solid" => SOLID: features::Solid,
    "scanline" => SCANLINE: features::Scanline,
    "changes" => CHANGES: features::Changes,
    "plain_lines" => PLAIN_LINES: plain::Lines,
    "plain_polygons" => PLAIN_POLYGONS: plain::Polygons,
}
