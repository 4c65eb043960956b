//! Where colours land: two verbs that frames, dithers and borrowed displays all understand.
//!
//! They mirror `fill_solid` and `fill_contiguous` of embedded-graphics, a row at a time: *fill a
//! run with an ink* and *write a run of colours*. A packed [`Frame`](crate::Frame) does both a byte
//! at a time; [`OnDrawTarget`](crate::OnDrawTarget) lends them to any display driver.

use core::ops::Range;

use crate::{
    colour::Light,
    num::{count, index},
    phase::{bits_of, bits_of_bytes, phase},
    shade::Shade,
    space::Rect,
    span::Sink,
    vary::Ramp,
};
use embedded_graphics::{
    draw_target::DrawTarget,
    geometry::{Point, Size},
    pixelcolor::{
        PixelColor,
        raw::{RawData, RawU1, RawU2, RawU4, RawU8},
    },
    primitives::Rectangle,
};

/// Takes runs of colours.
pub trait Target {
    /// What a pixel is given.
    type Color: Copy;
    /// What can go wrong; [`Infallible`](core::convert::Infallible) in memory.
    type Error;

    /// The pixels that exist. Whatever is asked for outside is not drawn.
    fn bounds(&self) -> Rect;

    /// Gives the pixels of a run colours that repeat every `N` columns, counted on the screen: the first one
    /// is for the columns 0, `N`, 2`N` … One colour is a plain run.
    ///
    /// With 1, 2, 4 or 8 colours a packed frame is filled a word at a time.
    ///
    /// # Errors
    /// What the display behind says.
    fn fill_run<const N: usize>(
        &mut self,
        row: i32,
        columns: Range<i32>,
        colors: [Self::Color; N],
    ) -> Result<(), Self::Error>;

    /// Writes one colour a pixel from the left; `None` leaves the pixel as it was.
    ///
    /// Ends with the run or with the colours, whichever is shorter.
    ///
    /// # Errors
    /// What the display behind says.
    fn write_run(
        &mut self,
        row: i32,
        columns: Range<i32>,
        colors: impl Iterator<Item = Option<Self::Color>>,
    ) -> Result<(), Self::Error>;

    /// Gives one pixel a colour.
    ///
    /// # Errors
    /// What the display behind says.
    #[inline]
    fn set(&mut self, row: i32, column: i32, color: Self::Color) -> Result<(), Self::Error> {
        self.fill_run(row, column..column.saturating_add(1), [color])
    }

    /// Writes one colour a pixel from the left, to every pixel.
    ///
    /// As [`write_run`](Self::write_run), for those that know that no pixel is left out. There is a colour for each pixel;
    /// what the pixels get for which there is none is not said.
    ///
    /// # Errors
    /// What the display behind says.
    #[inline]
    fn write_all(
        &mut self,
        row: i32,
        columns: Range<i32>,
        colors: impl Iterator<Item = Self::Color>,
    ) -> Result<(), Self::Error> {
        self.write_run(row, columns, colors.map(Some))
    }

    /// Gives every pixel of a run one of two colours that repeat every eight columns, counted on the screen: the highest
    /// bit is for the columns 0, 8, 16 …
    ///
    /// # Errors
    /// What the display behind says.
    #[inline]
    fn fill_bits(
        &mut self,
        row: i32,
        columns: Range<i32>,
        [off, on]: [Self::Color; 2],
        byte: u8,
    ) -> Result<(), Self::Error> {
        self.fill_run(row, columns, bits_of(byte).map(|bit| if bit { on } else { off }))
    }

    /// Gives every pixel of a run one of two colours, eight at a time: `next` gives a byte for eight columns, of which
    /// the first is a multiple of eight and in the highest bit. It begins at or before the run.
    ///
    /// A packed frame of one bit a pixel takes the bytes as they are.
    ///
    /// # Errors
    /// What the display behind says.
    fn write_bits(
        &mut self,
        row: i32,
        columns: Range<i32>,
        [off, on]: [Self::Color; 2],
        next: impl FnMut() -> u8,
    ) -> Result<(), Self::Error> {
        let before = index(columns.start & 7);
        let colors = bits_of_bytes(next).skip(before).map(|bit| Some(if bit { on } else { off }));
        self.write_run(row, columns, colors)
    }

    /// Gives the pixels of a run light that changes evenly from one to the next.
    ///
    /// Pixel by pixel, unless the target can do better; [`Dithered`](crate::Dithered) can.
    ///
    /// # Errors
    /// What the display behind says.
    #[inline]
    fn fill_ramp(&mut self, row: i32, columns: Range<i32>, light: Ramp<1>) -> Result<(), Self::Error>
    where
        Self::Color: From<Light>,
    {
        self.write_run(row, columns, light.map(|[light]| Some(Light(light).into())))
    }

    /// Gives the pixels of a run one light, as [`fill_run`](Self::fill_run) does; what is found on the way stays in `shade` for
    /// the next run. A shade is for one target, or for those that show light alike.
    ///
    /// # Errors
    /// What the display behind says.
    #[inline]
    fn fill_shade(&mut self, row: i32, columns: Range<i32>, shade: &mut Shade) -> Result<(), Self::Error>
    where
        Self::Color: From<Light>,
    {
        self.fill_run(row, columns, [shade.light().into()])
    }

    /// Gives the pixels of an area colours that repeat every eight columns and eight rows, counted on the screen:
    /// the pixel (x, y) that of `tile[y & 7][x & 7]`.
    ///
    /// A run for each row, unless the target can do better; a packed frame can.
    ///
    /// # Errors
    /// What the display behind says.
    fn fill_tile(&mut self, area: Rect, tile: &[[Self::Color; 8]; 8]) -> Result<(), Self::Error> {
        let visible = area.intersection(self.bounds());
        visible.rows().try_for_each(|row| match phase(tile, row) {
            Some(colors) => self.fill_run(row, visible.columns(), colors),
            None => Ok(()),
        })
    }
}

/// What a shape is filled with: a colour, a pattern, a picture, a gradient …
///
/// Every colour of embedded-graphics is an ink, and so is [`Light`](crate::Light). An ink is fixed to the screen, so that
/// bands, tiles and partial redraws agree to the pixel.
///
/// ```
/// use core::ops::Range;
///
/// use aquatint::{Ink, Target};
/// use embedded_graphics::pixelcolor::BinaryColor;
///
/// /// Every other row.
/// struct Lines;
///
/// impl Ink for Lines {
///     type Color = BinaryColor;
///
///     fn fill<T: Target<Color = BinaryColor>>(&self, target: &mut T, row: i32, columns: Range<i32>) -> Result<(), T::Error> {
///         target.fill_run(row, columns, [BinaryColor::from(row % 2 == 0)])
///     }
/// }
/// ```
pub trait Ink {
    /// What a pixel is given.
    type Color: Copy;

    /// Fills a run of pixels on a target; parts of it may lie outside of the target.
    ///
    /// # Errors
    /// What the target says.
    fn fill<T: Target<Color = Self::Color>>(
        &self,
        target: &mut T,
        row: i32,
        columns: Range<i32>,
    ) -> Result<(), T::Error>;
}

/// A colour is the simplest ink.
impl<C: PixelColor> Ink for C {
    type Color = C;

    #[inline]
    fn fill<T: Target<Color = C>>(&self, target: &mut T, row: i32, columns: Range<i32>) -> Result<(), T::Error> {
        target.fill_run(row, columns, [*self])
    }
}

/// Consumes the spans of a shape and fills them with an ink.
#[derive(Debug)]
pub struct Brush<'t, T, I> {
    target: &'t mut T,
    ink: I,
}

impl<'t, T: Target, I: Ink<Color = T::Color>> Brush<'t, T, I> {
    /// Paints on `target` with `ink`.
    pub const fn new(target: &'t mut T, ink: I) -> Self {
        Self { target, ink }
    }
}

impl<T: Target, I: Ink<Color = T::Color>> Sink for Brush<'_, T, I> {
    type Error = T::Error;

    fn bounds(&self) -> Rect {
        self.target.bounds()
    }

    fn span(&mut self, row: i32, columns: Range<i32>, (): ()) -> Result<(), T::Error> {
        self.ink.fill(self.target, row, columns)
    }
}

/// Fills the spans of a shape on a display with one colour.
#[derive(Debug)]
pub(crate) struct Paint<'d, D: DrawTarget> {
    display: &'d mut D,
    bounds: Rect,
    color: D::Color,
}

impl<'d, D: DrawTarget> Paint<'d, D> {
    pub(crate) fn new(display: &'d mut D, color: D::Color) -> Self {
        let bounds = display.bounding_box().into();
        Self { display, bounds, color }
    }
}

impl<D: DrawTarget> Sink for Paint<'_, D> {
    type Error = D::Error;

    fn bounds(&self) -> Rect {
        self.bounds
    }

    #[inline]
    fn span(&mut self, row: i32, columns: Range<i32>, (): ()) -> Result<(), D::Error> {
        self.display.fill_solid(&run_area(row, &columns), self.color)
    }
}

/// A run that is not empty, as a rectangle.
#[inline]
pub(crate) fn run_area(row: i32, columns: &Range<i32>) -> Rectangle {
    Rectangle::new(Point::new(columns.start, row), Size::new(columns.start.abs_diff(columns.end), 1))
}

/// The colours of the visible part of an area whose colours come row by row.
///
/// Those of hidden pixels are taken and dropped, in one go where they lie together.
pub(crate) struct VisibleColors<I> {
    colors: I,
    /// To be dropped before the next row.
    hidden: u64,
    /// Between the end of a visible row and the beginning of the next.
    between: u64,
    width: usize,
}

impl<I: Iterator> VisibleColors<I> {
    /// `visible` is a part of `area`.
    pub(crate) fn new(colors: I, area: Rect, visible: Rect) -> Self {
        let above = u64::from(visible.top.abs_diff(area.top)) * u64::from(area.width());
        let hidden = above.saturating_add(u64::from(visible.left.abs_diff(area.left)));
        let between = u64::from(area.width().saturating_sub(visible.width()));
        Self { colors, hidden, between, width: count(u64::from(visible.width())) }
    }

    /// The colours of the next visible row. To be used up before the one after it is asked for.
    pub(crate) fn row(&mut self) -> impl Iterator<Item = I::Item> {
        if let Some(last) = count(self.hidden).checked_sub(1) {
            self.colors.nth(last);
        }
        self.hidden = self.between;
        self.colors.by_ref().take(self.width)
    }
}

/// Writes an area whose colours come row by row, as far as it is seen.
pub(crate) fn write_area<T: Target>(
    target: &mut T,
    area: Rect,
    colors: impl Iterator<Item = T::Color>,
) -> Result<(), T::Error> {
    let visible = area.intersection(target.bounds());
    let mut colors = VisibleColors::new(colors, area, visible);
    for row in visible.rows() {
        target.write_run(row, visible.columns(), colors.row().map(Some))?;
    }
    Ok(())
}

/// A colour that is stored as a code of 1, 2, 4 or 8 bits: every such colour of embedded-graphics.
pub trait Code: PixelColor {
    /// Bits a pixel.
    const BITS: u32;

    /// The colour of a code; bits above [`BITS`](Self::BITS) are ignored.
    fn from_code(code: u8) -> Self;

    /// The code of this colour.
    fn code(self) -> u8;
}

impl<C> Code for C
where
    C: PixelColor + From<C::Raw> + Into<C::Raw>,
    C::Raw: RawCode,
{
    const BITS: u32 = <C::Raw as RawCode>::BITS;

    fn from_code(code: u8) -> Self {
        C::Raw::from_u32(u32::from(code)).into()
    }

    fn code(self) -> u8 {
        self.into().byte()
    }
}

/// embedded-graphics' raw data types of up to eight bits.
pub trait RawCode: RawData + sealed::Sealed {
    /// Bits a pixel.
    const BITS: u32;

    /// The bits, in the low end of a byte.
    fn byte(self) -> u8;
}

mod sealed {
    pub trait Sealed {}
}

macro_rules! raw_code {
    ($($raw:ty: $bits:literal),*) => { $(
        impl sealed::Sealed for $raw {}
        impl RawCode for $raw {
            const BITS: u32 = $bits;

            fn byte(self) -> u8 {
                self.into_inner()
            }
        }
    )* };
}

raw_code!(RawU1: 1, RawU2: 2, RawU4: 4, RawU8: 8);
