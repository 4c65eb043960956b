//! A target without pixels: what is drawn on it only leaves its depths.

use core::{convert::Infallible, marker::PhantomData, ops::Range};

use crate::{num::count, space::Rect, target::Target};

/// Takes colours of any kind and drops them. A mesh that is [drawn](super::draw_mesh) on it hides what is behind it,
/// and is not seen itself.
///
/// ```
/// use aquatint::{Rect, Target, pipeline::Unpainted};
/// use embedded_graphics::pixelcolor::BinaryColor;
///
/// assert_eq!(Unpainted::<BinaryColor>::new().bounds(), Rect::new(i32::MIN, i32::MIN, i32::MAX, i32::MAX));
/// ```
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Unpainted<C>(PhantomData<C>);

impl<C> Unpainted<C> {
    /// A target of any size.
    #[must_use]
    pub const fn new() -> Self {
        Self(PhantomData)
    }
}

impl<C: Copy> Target for Unpainted<C> {
    type Color = C;
    type Error = Infallible;

    fn bounds(&self) -> Rect {
        Rect::new(i32::MIN, i32::MIN, i32::MAX, i32::MAX)
    }

    #[inline]
    fn fill_run<const N: usize>(&mut self, _: i32, _: Range<i32>, _: [C; N]) -> Result<(), Infallible> {
        Ok(())
    }

    /// Looks at every colour: the depth test may hide in them.
    #[inline]
    fn write_run(
        &mut self,
        _: i32,
        columns: Range<i32>,
        colors: impl Iterator<Item = Option<C>>,
    ) -> Result<(), Infallible> {
        colors.take(count(columns.start.abs_diff(columns.end).into())).for_each(drop);
        Ok(())
    }

    #[inline]
    fn write_all(&mut self, _: i32, _: Range<i32>, _: impl Iterator<Item = C>) -> Result<(), Infallible> {
        Ok(())
    }
}
