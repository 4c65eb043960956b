//! What embedded-graphics draws, on any target.

use embedded_graphics::{
    Drawable,
    draw_target::{DrawTarget, DrawTargetExt},
    geometry::{Point, Size},
    image::{Image, ImageRaw},
    mono_font::{MonoTextStyleBuilder, ascii::FONT_6X10},
    pixelcolor::Gray8,
    primitives::{Circle, Line, Primitive, PrimitiveStyle, PrimitiveStyleBuilder, Rectangle, Triangle},
    text::Text,
};

/// Primitives and letters.
pub fn draw_shapes<D: DrawTarget<Color: From<Gray8>>>(target: &mut D, at: Point) -> Result<(), D::Error> {
    let [ink, paper, grey] = [255, 0, 0x96].map(|luma| D::Color::from(Gray8::new(luma)));
    let outlined = PrimitiveStyleBuilder::new().stroke_width(2).stroke_color(ink).fill_color(grey).build();
    Rectangle::new(at, Size::new(23, 9)).into_styled(outlined).draw(target)?;
    Circle::new(at + Point::new(12, -4), 17).into_styled(outlined).draw(target)?;
    Triangle::new(at, at + Point::new(31, 5), at + Point::new(4, 22))
        .into_styled(PrimitiveStyle::with_fill(paper))
        .draw(target)?;
    Line::new(at - Point::new(9, 3), at + Point::new(40, 19))
        .into_styled(PrimitiveStyle::with_stroke(ink, 3))
        .draw(target)?;
    // With a background, letters are areas of colours and not single pixels.
    let style = MonoTextStyleBuilder::new().font(&FONT_6X10).text_color(ink).background_color(grey).build();
    Text::new("Bx,\ny?", at + Point::new(5, 7), style).draw(target)?;
    Ok(())
}

/// The same, and an image, through the adaptors of embedded-graphics.
pub fn draw_in_windows<D: DrawTarget<Color: From<Gray8>>>(target: &mut D, at: Point) -> Result<(), D::Error> {
    let window = Rectangle::new(at + Point::new(3, 2), Size::new(14, 11));
    draw_shapes(&mut target.clipped(&window), at - Point::new(8, 3))?;
    draw_shapes(&mut target.cropped(&window), Point::new(-6, 4))?;
    draw_shapes(&mut target.translated(Point::new(-7, 9)), at)?;
    let mut grey = target.color_converted::<Gray8>();
    let pixels = ImageRaw::<Gray8>::new(&[10, 200, 90, 255, 0, 140], 3);
    Image::new(&pixels, at).draw(&mut grey)?;
    draw_shapes(&mut grey.cropped(&window), Point::new(3, 5))
}
