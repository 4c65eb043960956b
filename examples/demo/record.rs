//! Pictures of the panels in files: one PNG a panel, and one animation of all of them.

use std::path::{Path, PathBuf};

use aquatint_simulator::{Animation, Picture, Zoom, save_png};
use indicatif::{ProgressBar, ProgressStyle};

use crate::{
    scene,
    screens::{Content, Screen},
};

/// Frames a second of the animation.
const PACE: u16 = 16;
/// Colour around the panels.
const DESK: [u8; 3] = [36, 38, 42];

/// The frame of which the still pictures are taken.
pub const STILL: u16 = 5;

/// Draws the frames, writes the files and says which.
pub fn record(screens: &mut [Screen], content: &Content<'_>, frames: u16, out: &Path) -> Result<Vec<PathBuf>, String> {
    std::fs::create_dir_all(out).map_err(|e| format!("{}: {e}", out.display()))?;
    let bar = ProgressBar::new(frames.into()).with_style(style());
    let stills = panels(screens, &at(content, STILL))?;
    let animated = out.join("demo.png");
    let shown = Picture::above(&stills, 12, DESK);
    let mut animation = Animation::create(&animated, (shown.width(), shown.height()), PACE).map_err(text)?;
    for frame in 0..frames {
        let pictures = panels(screens, &at(content, frame))?;
        animation.push(&Picture::above(&pictures, 12, DESK)).map_err(text)?;
        bar.inc(1);
    }
    animation.finish().map_err(text)?;
    bar.finish_and_clear();
    let mut written = vec![animated];
    for (screen, still) in screens.iter().zip(&stills) {
        let path = out.join(screen.file_name).with_extension("png");
        save_png(still, &path).map_err(text)?;
        written.push(path);
    }
    Ok(written)
}

/// The content with the mesh as it stands in a frame.
pub fn at<'a>(content: &Content<'a>, frame: u16) -> Content<'a> {
    Content { placement: scene::placement(frame), ..*content }
}

fn panels(screens: &mut [Screen], content: &Content<'_>) -> Result<Vec<Picture>, String> {
    screens.iter_mut().map(|screen| picture(screen, content, screen.zoom)).collect()
}

/// What a person sees on a panel.
pub fn picture(screen: &mut Screen, content: &Content<'_>, zoom: Zoom) -> Result<Picture, String> {
    let panel = screen.panel;
    panel.render(screen.draw(content)?, zoom).map_err(text)
}

fn style() -> ProgressStyle {
    ProgressStyle::with_template("{wide_bar} frame {pos} of {len}, {eta} left").unwrap_or(ProgressStyle::default_bar())
}

fn text(error: impl std::error::Error) -> String {
    error.to_string()
}
