//! Comparing solids: which pixels they cover in each frame, and the bits of the wall.

use std::collections::BTreeMap;

use embedded_graphics::geometry::Size;

use crate::items::{
    OURS,
    solid::{Engine, Engines, FRAMES, each},
    solid_models::Solid,
    solid_peers::Bits,
    solid_wall::exact_texel,
};

const SOLIDS: [(&str, Solid); 2] = [("cube", Solid::Cube), ("torus", Solid::Torus)];

/// The mean number of pixels whose centres are inside, computed in doubles.
fn exact(solid: Solid, panel: &str) -> f64 {
    match (solid, panel) {
        (Solid::Cube, "128x64") => 1747.0,
        (Solid::Cube, _) => 24_584.2,
        (Solid::Torus, "128x64") => 1218.8,
        (Solid::Torus, _) => 17_135.1,
    }
}

/// A solid on a panel.
type Scene = (&'static str, &'static str);

/// What we cover, and what has been said of everybody.
struct Coverage {
    ours: BTreeMap<Scene, Vec<bool>>,
    lines: Vec<String>,
    faults: Vec<String>,
}

/// Draws all solids and compares. Says how the coverages differ, or what is wrong.
pub fn compare() -> Result<String, String> {
    let mut coverage = Coverage { ours: BTreeMap::new(), lines: Vec::new(), faults: Vec::new() };
    each(&mut coverage);
    // Who draws bits covers the same.
    coverage.lines.retain(|line| !line.contains("-1bit:"));
    if coverage.faults.is_empty() { Ok(coverage.lines.join("\n")) } else { Err(coverage.faults.join("\n")) }
}

impl Engines for Coverage {
    fn engine<E: Engine>(&mut self, panel: &'static str, who: &'static str, mut engine: E) {
        for (item, solid) in SOLIDS {
            let mut covered = Vec::new();
            for frame in 0..FRAMES {
                engine.frame(solid, frame);
                covered.extend(engine.covered());
            }
            if who == OURS {
                let (mean, exact) = (mean(&covered), exact(solid, panel));
                let line = format!("{item}/{panel}: {mean:.1} pixels, exactly {exact:.1}");
                self.judge(line, (mean / exact - 1.0).abs() < 0.002);
                self.ours.insert((item, panel), covered);
            } else {
                self.judge_peer((item, panel), who, &covered);
            }
        }
        if E::HAS_WALL {
            engine.wall();
            let mut picture = Vec::new();
            engine.picture(|bytes| picture = bytes.to_vec());
            self.judge_wall((panel, who), engine.size(), &picture);
        }
    }
}

impl Coverage {
    /// Peers may differ where edges pass; embedded-3dgfx rounds vertices to whole pixels and draws all edges.
    fn judge_peer(&mut self, scene: Scene, who: &str, covered: &[bool]) {
        let Some(ours) = self.ours.get(&scene) else { return };
        let differing = |only: bool| {
            let pixels = ours.iter().zip(covered).map(|(ours, theirs)| (*ours != *theirs) && *theirs == only);
            mean(&pixels.collect::<Vec<_>>())
        };
        let (missing, more) = (differing(false), differing(true));
        let most = if who.starts_with("embedded-3dgfx") { 0.06 } else { 0.005 };
        let line = format!("{}/{} by {who}: {missing:.1} pixels missing, {more:.1} more", scene.0, scene.1);
        self.judge(line, missing + more <= most * mean(ours));
    }

    /// Texels are exact but near their edges. embedded-3dgfx interpolates without perspective along the sides of a triangle.
    fn judge_wall(&mut self, (panel, who): (&str, &str), size: Size, picture: &[u8]) {
        let places = (0..size.height).flat_map(|y| (0..size.width).map(move |x| (x, y)));
        let exact = Bits::of(size, places.map(|place| exact_texel(size, place))).bytes;
        let wrong: u32 = picture.iter().zip(&exact).map(|(got, exact)| (got ^ exact).count_ones()).sum();
        let share = f64::from(wrong) / f64::from(size.width * size.height);
        let most = if who.starts_with("embedded-3dgfx") { 0.2 } else { 0.02 };
        self.judge(format!("quad/{panel} by {who}: {:.1} % of the bits are wrong", share * 100.0), share <= most);
    }

    fn judge(&mut self, line: String, is_good: bool) {
        if is_good { &mut self.lines } else { &mut self.faults }.push(line);
    }
}

/// Pixels a frame.
#[expect(clippy::cast_precision_loss, reason = "small numbers")]
fn mean(pixels: &[bool]) -> f64 {
    pixels.iter().filter(|is_covered| **is_covered).count() as f64 / f64::from(FRAMES)
}
