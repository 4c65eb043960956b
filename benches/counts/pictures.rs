//! Comparing: counts are compared only where the pictures are the same, or differ for a known reason.

use crate::{
    items::{self, Draw, Label, MEMORY, OURS, Surface, Visitor},
    name,
};

/// How a peer's picture may differ from ours.
enum Difference {
    /// No pixel.
    None,
    /// The peer draws our pixels and others, for a reason.
    More,
    /// Less than one bit in this many, for a reason.
    OneIn(usize),
    /// No byte by more than this, for a reason.
    Bytes(u8),
}

/// The one place that lists the items that peers draw otherwise.
fn difference(Label { item, who, .. }: Label) -> Difference {
    match item {
        // Coverage. tiny-skia takes 16 samples a pixel; the others compute in floats, and cut curves into few chords.
        _ if item.ends_with("_aa") && who == "tiny-skia" => Difference::Bytes(64),
        "path_fill_aa" | "word_aa" => Difference::Bytes(40),
        _ if item.ends_with("_aa") => Difference::Bytes(6),
        // aquatint fills the pixels whose centres are inside (the top-left rule, so that neighbours
        // share no pixel); embedded-graphics also draws the outline, in pixels half outside. The whole
        // picture has the same triangle in it.
        // Light is rounded to 8 bits, or to 5 and 6; edges and triangles of embedded-3dgfx are off by up to a pixel.
        "cube" | "torus" if who.starts_with("embedded-3dgfx") => Difference::OneIn(20),
        // Ties of depths.
        "cube" | "torus" | "grow_tree" | "grow_sort" | "way_bsp_tree" | "way_depth_sort" => Difference::OneIn(200),
        // Texels near their edges; embedded-3dgfx interpolates without perspective along the sides of a triangle.
        "quad" if who.starts_with("embedded-3dgfx") => Difference::OneIn(5),
        "quad" => Difference::OneIn(50),
        // Rays meet the edges of triangles unrounded, and see shadows. Without more than back faces left out, the far side of the
        // ring is drawn over the near one.
        "way_rays" | "way_back_faces" => Difference::OneIn(10),
        "grow_rays" | "grow_list" => Difference::OneIn(2),
        "tri_fill" | "tri_fill_x16" | "one_frame" => Difference::More,
        _ => Difference::None,
    }
}

/// The item of ours whose picture an item must give.
fn reference(item: &'static str) -> &'static str {
    match item {
        "eight_bands" => "one_frame",
        _ if item.starts_with("grow_") => "grow_depth",
        _ if item.starts_with("way_") => "way_depth_buffer",
        _ => item.strip_suffix("_rows").unwrap_or(item),
    }
}

/// Draws everything and compares. Says how much was compared, or what is wrong.
pub fn compare() -> Result<String, String> {
    let mut pictures = Pictures(Vec::new());
    items::all(&mut [0; MEMORY], &mut pictures);
    let faults: Vec<String> =
        pictures.0.iter().filter_map(|(label, picture)| pictures.fault(*label, picture)).collect();
    if faults.is_empty() { Ok(format!("{} pictures agree", pictures.0.len())) } else { Err(faults.join("\n")) }
}

/// What everybody drew, packed.
struct Pictures(Vec<(Label, Vec<u8>)>);

impl Visitor for Pictures {
    fn visit<S: Surface>(&mut self, label: Label, surface: &mut S, draw: Draw<S>) {
        items::darken(surface).expect("a picture in memory");
        draw(surface).expect("a picture in memory");
        surface.picture(|bytes| self.0.push((label, bytes.to_vec())));
    }
}

impl Pictures {
    /// What is wrong with a picture.
    fn fault(&self, label: Label, picture: &[u8]) -> Option<String> {
        if picture.iter().all(|&byte| byte == 0) {
            return Some(format!("{} by {} is empty", name(label), label.who));
        }
        let reference = Label { item: reference(label.item), who: OURS, ..label };
        let (_, ours) = self.0.iter().find(|(other, _)| *other == reference)?;
        let bits = |differ: fn(u8, u8) -> u8| -> u32 {
            ours.iter().zip(picture).map(|(&ours, &theirs)| differ(ours, theirs).count_ones()).sum()
        };
        let (missing, more) = (bits(|ours, theirs| ours & !theirs), bits(|ours, theirs| theirs & !ours));
        let farthest = ours.iter().zip(picture).map(|(ours, theirs)| ours.abs_diff(*theirs)).max();
        let agree = match difference(label) {
            Difference::None => missing + more == 0,
            Difference::More => missing == 0,
            Difference::OneIn(bits) => (missing + more) as usize * bits < 8 * picture.len(),
            Difference::Bytes(most) => farthest <= Some(most),
        };
        let counts = format!("{missing} bits missing, {more} more than aquatint's, bytes off by {farthest:?}");
        (!agree || ours.len() != picture.len()).then(|| format!("{} by {}: {counts}", name(label), label.who))
    }
}
