//! One scene in every way to hide what is behind: that of the example `hidden`. On the desk.

use core::convert::Infallible;

use aquatint::{Dithered, Frame, Levels, Rows};
use embedded_graphics::{
    Pixel,
    draw_target::DrawTarget,
    geometry::{OriginDimensions, Size},
    pixelcolor::BinaryColor,
};

use super::{
    Label, OURS, Visitor,
    peers::{Shapes, Surface},
};

#[path = "../../examples/scene/ways.rs"]
mod scene;

use scene::{Way, Ways};

/// A picture of it on one bit a pixel.
struct Picture {
    frame: Frame<BinaryColor, Rows, Vec<u8>>,
    ways: Ways,
    way: Way,
}

impl Picture {
    #[expect(clippy::unnecessary_wraps, reason = "an item")]
    fn draw(&mut self) -> Result<(), Infallible> {
        self.ways.draw(self.way, &mut Dithered::new(&mut self.frame, Levels::ONE_BIT));
        Ok(())
    }
}

/// Shows all of them.
pub fn all(visitor: &mut impl Visitor) {
    let frame = Frame::new(vec![0; 1024], 128, 64).expect("one each");
    let mut picture = Picture { frame, ways: Ways::new(), way: Way::BackFaces };
    for way in Way::ALL {
        let [item, _] = way.names();
        picture.way = way;
        visitor.visit(Label::new(item, "128x64", OURS), &mut picture, Picture::draw);
    }
}

impl OriginDimensions for Picture {
    fn size(&self) -> Size {
        self.frame.size()
    }
}

impl DrawTarget for Picture {
    type Color = BinaryColor;
    type Error = Infallible;

    fn draw_iter<I: IntoIterator<Item = Pixel<BinaryColor>>>(&mut self, pixels: I) -> Result<(), Infallible> {
        self.frame.draw_iter(pixels)
    }

    fn clear(&mut self, color: BinaryColor) -> Result<(), Infallible> {
        self.frame.clear(color)
    }
}

impl Shapes for Picture {}

impl Surface for Picture {
    fn picture(&self, look: impl FnOnce(&[u8])) {
        look(self.frame.bytes());
    }
}
