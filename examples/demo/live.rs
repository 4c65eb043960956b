//! The live window: drag to turn, keys to change panel, dithering and model.

use aquatint::{Angle, display::dither::Method, model::mesh::Mesh};
use aquatint_simulator::{Event, Key, Picture, Window, Zoom};

use crate::{
    record::picture,
    scene,
    screens::{Content, Screen},
};

const TITLE: &str = "aquatint: drag to turn, P panel, D dithering, M model, Esc ends";

/// What the window shows just now.
struct View {
    screen: usize,
    mesh: usize,
    method: Method,
    around: Angle,
    down: Angle,
    spins: bool,
}

/// Opens the window and runs until it is closed.
pub fn run(screens: &mut [Screen], meshes: &[Mesh<'_>], caption: &str) -> Result<(), String> {
    let mut view =
        View { screen: 0, mesh: 0, method: Method::Ordered4x4, around: Angle(0), down: Angle(0x400), spins: true };
    let mut window = Window::open(TITLE, 832, 512).map_err(|e| e.to_string())?;
    while window.is_open() {
        for event in window.events() {
            if !view.handle(event, screens.len(), meshes.len()) {
                return Ok(());
            }
        }
        if view.spins {
            view.around.0 = view.around.0.wrapping_add(0x120);
        }
        let placement = scene::turned(view.around, view.down);
        let content = Content { mesh: meshes[view.mesh], placement, method: view.method, caption };
        let screen = &mut screens[view.screen];
        let zoom = Zoom { scale: 800 / screen.panel.width, ..screen.zoom };
        let shown = picture(screen, &content, zoom)?;
        window.show(&Picture::above(&[shown], 16, [36, 38, 42])).map_err(|e| e.to_string())?;
    }
    Ok(())
}

impl View {
    /// False when the window is to be closed.
    fn handle(&mut self, event: Event, screens: usize, meshes: usize) -> bool {
        match event {
            Event::Drag { dx, dy } => {
                self.spins = false;
                self.around = moved(self.around, dx);
                self.down = moved(self.down, dy);
            }
            Event::Key(Key::Character('p' | 'P')) => self.screen = (self.screen + 1) % screens,
            Event::Key(Key::Character('m' | 'M')) => self.mesh = (self.mesh + 1) % meshes,
            Event::Key(Key::Character('d' | 'D')) => {
                self.method = if self.method == Method::Nearest { Method::Ordered4x4 } else { Method::Nearest };
            }
            Event::Key(Key::Space) => self.spins = !self.spins,
            Event::Key(Key::Escape | Key::Character('q' | 'Q')) => return false,
            Event::Key(_) => {}
        }
        true
    }
}

/// 400 pixels of the hand are a full turn.
fn moved(angle: Angle, pixels: i32) -> Angle {
    let parts = (pixels * 164).rem_euclid(0x1_0000);
    Angle(angle.0.wrapping_add(u16::try_from(parts).unwrap_or(0)))
}
