//! What the emulated panels show, feature by feature: `mcu_grey`, `mcu_mono` and `mcu_cost` draw it from here.
//!
//! The crate that has this module says in its module `panel` on what: colours, layout, size. Each feature has memory of
//! its own, its picture too, so that what it takes can be seen.
#![allow(dead_code, reason = "each example uses a part")]

mod changes;
pub mod flat;
mod flood;
pub mod lines;
mod photo;
mod polygons;
mod scanline;
mod shadow;
mod solid;
mod text;

pub use self::{
    changes::Changes, flood::Floods, lines::Lines, photo::Photo, polygons::Polygons, scanline::Scanline,
    shadow::Shadow, solid::Solid, text::Texts,
};

use aquatint::{Frame, Rect};

use crate::panel::{Color, HEIGHT, Layout, PART, WIDTH};

/// Frames of each feature.
pub const FRAMES: u16 = 4;
/// The whole panel.
pub const PANEL: Rect = Rect::new(0, 0, WIDTH.cast_signed(), HEIGHT.cast_signed());
/// Bytes of the whole panel.
pub const BYTES: usize = Frame::<Color, Layout, ()>::bytes_needed(WIDTH, HEIGHT);

/// The panel's pixels on lent bytes, packed as it takes them. The bytes alone are kept, and not the frame, which is not all
/// zeros: a static of zeros takes no flash.
pub type Picture<'b> = Frame<Color, Layout, &'b mut [u8]>;

/// What the bytes show.
fn frame(bytes: &mut [u8; BYTES]) -> Option<Picture<'_>> {
    Frame::new(&mut bytes[..], WIDTH, HEIGHT).ok()
}

/// A black picture.
fn black(bytes: &mut [u8; BYTES]) -> Option<Picture<'_>> {
    bytes.fill(0);
    frame(bytes)
}

/// A panel, or what takes its place.
pub trait Screen {
    /// Chooses the pixels that `data` fills, line by line; its borders lie between bytes.
    fn window(&mut self, area: Rect);

    /// Sends bytes into the window. Further calls go on where the last one stopped.
    fn data(&mut self, bytes: &[u8]);
}

/// Something to draw, and the memory that it takes.
pub trait Feature {
    const NEW: Self;

    /// Draws a frame and sends it; `None` if some of the constants were wrong.
    fn draw(&mut self, number: u16, screen: &mut impl Screen) -> Option<()>;
}

/// Sends a whole picture.
fn send(picture: &Picture<'_>, screen: &mut impl Screen) {
    screen.window(PANEL);
    screen.data(picture.bytes());
}

/// Memory of all features.
pub struct Memory<'m> {
    pub flat: &'m mut (Lines, Polygons, Photo, Floods, Changes),
    pub soft: &'m mut Texts,
    pub solid: &'m mut (Solid, Scanline),
}

pub const FLAT: (Lines, Polygons, Photo, Floods, Changes) =
    (Lines::NEW, Polygons::NEW, Photo::NEW, Floods::NEW, Changes::NEW);
pub const SOLID: (Solid, Scanline) = (Solid::NEW, Scanline::NEW);

/// Shows all frames of all features, or of those that `PART` says when compiling, where the flash is too small for all.
#[expect(clippy::inline_always, reason = "so that of the others nothing is linked")]
#[inline(always)]
pub fn tour<S: Screen, L: FnMut(u32, &[u8])>(memory: Memory<'_>, mut shown: Shown<'_, S, L>) -> Option<()> {
    let Memory { flat, soft, solid } = memory;
    if is_shown("flat") {
        let (lines, polygons, photo, floods, changes) = flat;
        shown.show(lines)?;
        shown.show(polygons)?;
        shown.show(photo)?;
        shown.show(floods)?;
        shown.show(changes)?;
    }
    if is_shown("soft") {
        shown.show(soft)?;
    }
    if is_shown("solid") {
        let (solid, scanline) = solid;
        shown.show(solid)?;
        shown.show(scanline)?;
    }
    Some(())
}

/// Shows them on the panel of a board and reports what that took; `sent` says how many bytes went to the panel so far.
#[cfg(target_os = "none")]
#[inline(always)]
pub fn run(memory: Memory<'_>, shadow: &mut Shadow, screen: &mut impl Screen, sent: impl Fn() -> u32) -> ! {
    use crate::board::{look, report, semihosting, stack};

    let mut counted = 0;
    let mut look = |number, bytes: &[u8]| {
        look(number, bytes);
        report("bus", sent() - counted);
        counted = sent();
    };
    let is_done = tour(memory, Shown::new(screen, shadow, &mut look)).is_some();
    report("stack", stack::high_water());
    semihosting::exit(u8::from(!is_done))
}

fn is_shown(part: &str) -> bool {
    option_env!("PART").or(PART).is_none_or(|wanted| wanted == part)
}

/// The panel, and beside it what it must show.
pub struct Shown<'s, S, L> {
    screen: &'s mut S,
    shadow: &'s mut Shadow,
    /// Sees the bytes of the whole panel after each frame.
    look: &'s mut L,
    number: u32,
}

impl<'s, S, L> Shown<'s, S, L> {
    pub fn new(screen: &'s mut S, shadow: &'s mut Shadow, look: &'s mut L) -> Self {
        Self { screen, shadow, look, number: 0 }
    }
}

impl<S: Screen, L: FnMut(u32, &[u8])> Shown<'_, S, L> {
    /// All frames of a feature. A function of its own for each, so that their stacks do not add up.
    #[inline(never)]
    fn show(&mut self, feature: &mut impl Feature) -> Option<()> {
        for number in 0..FRAMES {
            feature.draw(number, self)?;
            (self.look)(self.number, self.shadow.bytes());
            self.number += 1;
        }
        Some(())
    }
}

impl<S: Screen, L> Screen for Shown<'_, S, L> {
    fn window(&mut self, area: Rect) {
        self.screen.window(area);
        self.shadow.window(area);
    }

    fn data(&mut self, bytes: &[u8]) {
        self.screen.data(bytes);
        self.shadow.data(bytes);
    }
}

/// Prints what the panel must show, on the desk.
#[cfg(not(target_os = "none"))]
pub fn print() {
    let mut look = |number: u32, bytes: &[u8]| {
        print!("frame {number} ");
        print_hex(bytes);
        println!();
    };
    let (mut flat, mut soft, mut solid) = (FLAT, Texts::NEW, SOLID);
    let memory = Memory { flat: &mut flat, soft: &mut soft, solid: &mut solid };
    let mut shadow = Shadow::NEW;
    tour(memory, Shown::new(&mut Nowhere, &mut shadow, &mut look)).expect("the constants fit");
}

#[cfg(not(target_os = "none"))]
fn print_hex(bytes: &[u8]) {
    for byte in bytes {
        print!("{byte:02x}");
    }
}

/// Prints what a feature sends.
#[cfg(not(target_os = "none"))]
pub fn print_sent<F: Feature>() {
    struct Printer;

    impl Screen for Printer {
        fn window(&mut self, _: Rect) {}

        fn data(&mut self, bytes: &[u8]) {
            print_hex(bytes);
        }
    }

    let mut feature = Box::new(F::NEW);
    for number in 0..FRAMES {
        print!("sent {number} ");
        feature.draw(number, &mut Printer).expect("the constants fit");
        println!();
    }
}

/// No feature: what any firmware takes.
pub struct Nothing;

impl Feature for Nothing {
    const NEW: Self = Self;

    fn draw(&mut self, _: u16, screen: &mut impl Screen) -> Option<()> {
        screen.data(&[0]);
        Some(())
    }
}

/// No panel.
pub struct Nowhere;

impl Screen for Nowhere {
    fn window(&mut self, _: Rect) {}

    fn data(&mut self, _: &[u8]) {}
}
