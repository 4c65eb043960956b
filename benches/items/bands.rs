//! A picture that is drawn in eight bands, each through a frame of an eighth of its height.

use core::{convert::Infallible, marker::PhantomData};

use aquatint::{Frame, Window};
use embedded_graphics::{
    Pixel,
    draw_target::DrawTarget,
    geometry::{OriginDimensions, Size},
};

use super::{
    ours::{Ink, Ours, Packed, Sheet},
    peers::{Shapes, Surface},
    scene::one_frame,
};

/// The bands one after the other in one memory, so that the whole picture can be compared. A device
/// with less memory would send each and use its memory again.
pub struct Bands<'m, C, L> {
    memory: &'m mut [u8],
    size: Size,
    sheet: &'m Sheet<L>,
    color: PhantomData<C>,
}

impl<'m, C: Ink, L: Packed<C>> Bands<'m, C, L> {
    /// `height` is a multiple of eight lines.
    pub fn new(memory: &'m mut [u8], (width, height): (u32, u32), sheet: &'m Sheet<L>) -> Self {
        let memory = &mut memory[..Frame::<C, L, ()>::bytes_needed(width, height)];
        Self { memory, size: Size::new(width, height), sheet, color: PhantomData }
    }

    /// Draws the picture of `one_frame`.
    pub fn draw(&mut self) -> Result<(), Infallible> {
        let Size { width, height } = self.size;
        let mut top = 0;
        for band in self.memory.chunks_mut(self.memory.len() / 8) {
            // Too small a memory would show in the picture.
            let Ok(mut frame) = Frame::<C, L, _>::new(band, width, height / 8) else { return Ok(()) };
            one_frame(&mut Ours { target: Window::band(&mut frame, top), sheet: self.sheet })?;
            top += (height / 8).cast_signed();
        }
        Ok(())
    }
}

impl<C, L> OriginDimensions for Bands<'_, C, L> {
    fn size(&self) -> Size {
        self.size
    }
}

/// As a whole: for clearing.
impl<C: Ink, L: Packed<C>> DrawTarget for Bands<'_, C, L> {
    type Color = C;
    type Error = Infallible;

    fn draw_iter<I: IntoIterator<Item = Pixel<C>>>(&mut self, pixels: I) -> Result<(), Infallible> {
        let Ok(mut frame) = Frame::<C, L, _>::new(&mut *self.memory, self.size.width, self.size.height) else {
            return Ok(());
        };
        frame.draw_iter(pixels)
    }
}

impl<C: Ink, L: Packed<C>> Shapes for Bands<'_, C, L> {}

impl<C: Ink, L: Packed<C>> Surface for Bands<'_, C, L> {
    fn picture(&self, look: impl FnOnce(&[u8])) {
        look(self.memory);
    }
}
