//! Peers that draw antialiased, on the desk, with floats and a heap; each gives all bytes of the mask.

use core::convert::Infallible;

use ab_glyph::{Font as _, FontRef, ScaleFont as _};
use ab_glyph_rasterizer::{Rasterizer, point};
use embedded_graphics::{
    Pixel,
    draw_target::DrawTarget,
    geometry::{OriginDimensions, Point, Size},
    pixelcolor::BinaryColor,
};
use tiny_skia::{FillRule, Mask, PathBuilder, PathStroker, Transform};
use zeno::{Command, PathBuilder as _, Vector};

use super::{
    peers::{Polygons, Shapes, Surface},
    soft::{SIZE, Soft, Writes, font},
};

/// A point in floats.
#[expect(clippy::cast_precision_loss, reason = "small numbers")]
fn float(Point { x, y }: Point) -> (f32, f32) {
    (x as f32, y as f32)
}

/// What all of them are to the items.
macro_rules! surface {
    ($peer:ty, clear: $clear:expr, bytes: $bytes:expr) => {
        impl OriginDimensions for $peer {
            fn size(&self) -> Size {
                SIZE
            }
        }

        impl DrawTarget for $peer {
            type Color = BinaryColor;
            type Error = Infallible;

            /// Nothing is drawn like that.
            fn draw_iter<I: IntoIterator<Item = Pixel<BinaryColor>>>(&mut self, _pixels: I) -> Result<(), Infallible> {
                Ok(())
            }

            fn clear(&mut self, _color: BinaryColor) -> Result<(), Infallible> {
                let clear: fn(&mut Self) = $clear;
                clear(self);
                Ok(())
            }
        }

        impl Shapes for $peer {
            fn triangle(&mut self, corners: [Point; 3], color: BinaryColor) -> Result<(), Infallible> {
                self.polygon(&corners, color)
            }
        }

        impl Surface for $peer {
            fn picture(&self, look: impl FnOnce(&[u8])) {
                let bytes: fn(&Self) -> &[u8] = $bytes;
                look(bytes(self));
            }
        }
    };
}

/// 4 × 4 samples.
pub struct TinySkia(Mask);

impl TinySkia {
    pub fn new() -> Self {
        Self(Mask::new(SIZE.width, SIZE.height).expect("not empty"))
    }

    fn fill(&mut self, path: PathBuilder) {
        let path = path.finish().expect("not empty");
        self.0.fill_path(&path, FillRule::Winding, true, Transform::identity());
    }
}

surface!(TinySkia, clear: |peer| peer.0.data_mut().fill(0), bytes: |peer| peer.0.data());

impl Polygons for TinySkia {
    fn polygon(&mut self, corners: &[Point], _color: BinaryColor) -> Result<(), Infallible> {
        let mut path = PathBuilder::new();
        for (index, (x, y)) in corners.iter().copied().map(float).enumerate() {
            if index == 0 { path.move_to(x, y) } else { path.line_to(x, y) }
        }
        path.close();
        self.fill(path);
        Ok(())
    }
}

impl Soft for TinySkia {
    fn heart(&mut self, points: [Point; 6]) {
        let [tip, a, b, top, c, d] = points.map(float);
        let mut path = PathBuilder::new();
        path.move_to(tip.0, tip.1);
        path.cubic_to(a.0, a.1, b.0, b.1, top.0, top.1);
        path.cubic_to(c.0, c.1, d.0, d.1, tip.0, tip.1);
        path.close();
        self.fill(path);
    }

    fn stroke(&mut self, ends: [Point; 2], width: u16) {
        let [from, to] = ends.map(float);
        let mut path = PathBuilder::new();
        path.move_to(from.0, from.1);
        path.line_to(to.0, to.1);
        let stroke = tiny_skia::Stroke { width: width.into(), ..Default::default() };
        let line = path.finish().expect("not empty");
        let stroked = PathStroker::new().stroke(&line, &stroke, 1.0).expect("not empty");
        self.0.fill_path(&stroked, FillRule::Winding, true, Transform::identity());
    }
}

/// Exact areas, in floats.
pub struct Zeno(Vec<u8>);

impl Zeno {
    pub fn new() -> Self {
        Self(vec![0; (SIZE.width * SIZE.height) as usize])
    }

    fn draw<'a>(&mut self, path: &[Command], style: impl Into<zeno::Style<'a>>) {
        zeno::Mask::new(path).size(SIZE.width, SIZE.height).style(style).render_into(&mut self.0, None);
    }
}

surface!(Zeno, clear: |peer| peer.0.fill(0), bytes: |peer| &peer.0);

impl Polygons for Zeno {
    fn polygon(&mut self, corners: &[Point], _color: BinaryColor) -> Result<(), Infallible> {
        let mut path = Vec::<Command>::new();
        for (index, point) in corners.iter().copied().map(float).enumerate() {
            if index == 0 {
                path.move_to(point)
            } else {
                path.line_to(point)
            };
        }
        path.close();
        self.draw(&path, zeno::Fill::NonZero);
        Ok(())
    }
}

impl Soft for Zeno {
    fn heart(&mut self, points: [Point; 6]) {
        let [tip, a, b, top, c, d] = points.map(|point| Vector::from(float(point)));
        let mut path = Vec::<Command>::new();
        path.move_to(tip).curve_to(a, b, top).curve_to(c, d, tip).close();
        self.draw(&path, zeno::Fill::NonZero);
    }

    fn stroke(&mut self, ends: [Point; 2], width: u16) {
        let [from, to] = ends.map(float);
        let mut path = Vec::<Command>::new();
        path.move_to(from).line_to(to);
        self.draw(&path, zeno::Stroke::new(width.into()));
    }
}

/// Signed areas, in floats.
pub struct AbGlyph {
    rasterizer: Rasterizer,
    bytes: Vec<u8>,
}

impl AbGlyph {
    pub fn new() -> Self {
        let (width, height) = (SIZE.width as usize, SIZE.height as usize);
        Self { rasterizer: Rasterizer::new(width, height), bytes: vec![0; width * height] }
    }

    fn finish(&mut self) {
        let bytes = &mut self.bytes;
        #[expect(clippy::cast_possible_truncation, clippy::cast_sign_loss, reason = "0 to 255")]
        self.rasterizer.for_each_pixel(|index, alpha| bytes[index] = (alpha.min(1.0) * 255.0 + 0.5) as u8);
    }

    fn line(&mut self, from: Point, to: Point) {
        let [(x0, y0), (x1, y1)] = [from, to].map(float);
        self.rasterizer.draw_line(point(x0, y0), point(x1, y1));
    }
}

surface!(AbGlyph, clear: |peer| {
    peer.rasterizer.clear();
    peer.bytes.fill(0);
}, bytes: |peer| &peer.bytes);

impl Polygons for AbGlyph {
    fn polygon(&mut self, corners: &[Point], _color: BinaryColor) -> Result<(), Infallible> {
        for (from, to) in corners.iter().zip(corners.iter().cycle().skip(1)) {
            self.line(*from, *to);
        }
        self.finish();
        Ok(())
    }
}

impl Soft for AbGlyph {
    fn heart(&mut self, points: [Point; 6]) {
        let [tip, a, b, top, c, d] = points.map(float).map(|(x, y)| point(x, y));
        self.rasterizer.draw_cubic(tip, a, b, top);
        self.rasterizer.draw_cubic(top, c, d, tip);
        self.finish();
    }

    /// It has no strokes: the corners are computed for it.
    fn stroke(&mut self, ends: [Point; 2], width: u16) {
        let [(x0, y0), (x1, y1)] = ends.map(float);
        let (dx, dy) = (x1 - x0, y1 - y0);
        let scale = f32::from(width) / 2.0 / dx.hypot(dy);
        let (nx, ny) = (-dy * scale, dx * scale);
        let corners = [(x0 + nx, y0 + ny), (x1 + nx, y1 + ny), (x1 - nx, y1 - ny), (x0 - nx, y0 - ny)];
        let corners = corners.map(|(x, y)| point(x, y));
        for (from, to) in corners.iter().zip(corners.iter().cycle().skip(1)) {
            self.rasterizer.draw_line(*from, *to);
        }
        self.finish();
    }
}

/// With the font reader that belongs to it, which draws glyph by glyph.
impl Writes for AbGlyph {
    #[expect(clippy::cast_possible_truncation, clippy::cast_sign_loss, reason = "inside of the picture")]
    fn write(&mut self, word: &str) {
        let font = FontRef::try_from_slice(font()).expect("a font");
        let units = f32::from(24_u8) * font.height_unscaled() / font.units_per_em().expect("a font");
        let scaled = font.as_scaled(units);
        let (mut x, mut last) = (4.0, None);
        for id in word.chars().map(|character| font.glyph_id(character)) {
            x += last.map_or(0.0, |last| scaled.kern(last, id));
            if let Some(outline) = font.outline_glyph(id.with_scale_and_position(units, ab_glyph::point(x, 40.0))) {
                let corner = outline.px_bounds().min;
                let (left, top) = (corner.x as usize, corner.y as usize);
                outline.draw(|column, row, alpha| {
                    let byte = &mut self.bytes[(top + row as usize) * SIZE.width as usize + left + column as usize];
                    *byte = (*byte).max((alpha.min(1.0) * 255.0 + 0.5) as u8);
                });
            }
            x += scaled.h_advance(id);
            last = Some(id);
        }
    }
}
