//! One picture for each way in which pixels get into a frame.

use std::convert::Infallible;

use aquatint::{
    AntialiasedStyle, Blend, Blended, Brush, Circle, Code, Dithered, Ellipse, FillStyle, Flood, Levels, Light, Line,
    LinearGradient, Pattern, Point2, Polygon, Rect, Rule, StrokeStyle, Subpixel, Target, Text, TrueType,
    display::level::linear_levels,
    fragment::{gradient::between, pattern::hatch},
    raster::{
        flood::{Run, words_needed},
        scan::{ActiveEdge, fill},
    },
};
use embedded_graphics::{
    mono_font::{MonoTextStyle, ascii::FONT_6X10},
    pixelcolor::{BinaryColor, Gray2, Gray4, Gray8},
    prelude::*,
    text::{Baseline, Text as MonoText},
};
use heapless::Vec as List;

use crate::{
    HEIGHT, WIDTH,
    parts::{show_mesh, show_photo, show_ramp},
    photo::Photo,
    scene,
    unpacked::Screen,
};

/// What pictures are made of.
pub struct Material<'a> {
    pub photo: Photo,
    pub font: TrueType<'a>,
}

type Drawn = Result<(), Infallible>;

/// A colour of so many bits a pixel, of which the lowest is black.
pub trait Grey: PixelColor + Blend {
    const BITS: u32;

    /// As near as there is to a code, from the highest bit on.
    fn from_highest(code: u16) -> Self;

    /// Its own code.
    fn code(self) -> u16;
}

macro_rules! greys {
    ($($color:ty),*) => { $(
        impl Grey for $color {
            const BITS: u32 = <Self as Code>::BITS;

            fn from_highest(code: u16) -> Self {
                let [high, _] = code.to_be_bytes();
                Self::from_code(high >> (8 - <Self as Code>::BITS))
            }

            fn code(self) -> u16 {
                Code::code(self).into()
            }
        }
    )* };
}

greys!(BinaryColor, Gray2, Gray4, Gray8);

impl Grey for Light {
    const BITS: u32 = 16;

    fn from_highest(code: u16) -> Self {
        Self(code)
    }

    fn code(self) -> u16 {
        self.0
    }
}

/// A grey of 256, whose two bytes are never alike: in the wrong order they are another light.
fn grey<C: Grey>(grey: u8) -> C {
    C::from_highest(u16::from_be_bytes([grey, !grey]))
}

/// The lights of all codes.
fn levels<C: Code>() -> Levels<'static> {
    static FINE: [u16; 256] = linear_levels();
    match <C as Code>::BITS {
        1 => Levels::ONE_BIT,
        2 => Levels::LINEAR_4,
        4 => Levels::LINEAR_16,
        _ => Levels::new(&FINE).unwrap_or(Levels::LINEAR_16),
    }
}

/// Every pixel by itself, with codes that look random.
pub fn pixels<C: Grey>(screen: &mut impl Screen<C>, _: &Material) -> Drawn {
    let mut state = 1_u32;
    let points = screen.bounding_box().points();
    screen.draw_iter(points.map(|point| {
        state = state.wrapping_mul(1_664_525).wrapping_add(1_013_904_223);
        Pixel(point, C::from_highest(u16::try_from(state >> 16).unwrap_or_default()))
    }))
}

/// Thin and thick lines in many directions, and letters.
pub fn lines<C: Grey>(screen: &mut impl Screen<C>, _: &Material) -> Drawn {
    for (number, (shade, width)) in (0..14).zip((128..=u8::MAX).step_by(9).zip([1, 2, 3, 4].into_iter().cycle())) {
        let line = Line::new(Point::new(number * 9 - 3, 3), Point::new(120 - number * 7, 50));
        let style = StrokeStyle::new(grey::<C>(shade)).with_width(width);
        line.into_styled(style).draw(screen)?;
    }
    let style = MonoTextStyle::new(&FONT_6X10, grey::<C>(200));
    MonoText::with_baseline("Packed: 0123456789", Point::new(5, 53), style, Baseline::Top).draw(screen)?;
    Ok(())
}

/// Stars by both fill rules, in a colour and in a hatch.
pub fn polygons<C: Grey>(screen: &mut impl Screen<C>, _: &Material) -> Drawn {
    let star = |left: i32| [(19, -3), (29, 60), (1, 22), (39, 22), (9, 60)].map(|(x, y)| Point2::corner(left + x, y));
    for (left, rule) in [(0, Rule::EvenOdd), (43, Rule::NonZero)] {
        let star = star(left);
        let contours = [&star[..]];
        let Ok(star) = Polygon::new(&contours) else { continue };
        star.into_styled(FillStyle::new(grey::<C>(150)).with_rule(rule)).draw(screen)?;
    }
    let star = star(86);
    let contours = [&star[..]];
    let Ok(star) = Polygon::new(&contours) else { return Ok(()) };
    let bricks = Pattern::from_bits(hatch::BRICKS, grey::<C>(255), grey(64));
    fill(&star, Rule::NonZero, &mut List::<ActiveEdge, 16>::new(), &mut Brush::new(screen, bricks))
}

/// Dithered: a photograph, a gradient, a ramp, an area of one light.
pub fn light<C: Code>(screen: &mut impl Screen<C>, material: &Material) -> Drawn {
    let mut dithered = Dithered::new(screen, levels::<C>());
    dithered.fill_area(Rect::new(95, 2, 126, 30), Light(23_456))?;
    pure_light(&mut dithered, material)
}

/// The same where each light is a colour.
pub fn pure_light(light: &mut impl Target<Color = Light, Error = Infallible>, material: &Material) -> Drawn {
    show_photo(light, Rect::new(3, 0, 91, 64), &material.photo);
    show_ramp(light, Rect::new(93, 35, 128, 61));
    let kite = [(99, 3), (125, 12), (118, 33), (96, 24)].map(|(x, y)| Point2::corner(x, y));
    let contours = [&kite[..]];
    let Ok(kite) = Polygon::new(&contours) else { return Ok(()) };
    let ramp = LinearGradient::new(Point2::corner(96, 3), Point2::corner(122, 33), between(Light::BLACK, Light::WHITE));
    fill(&kite, Rule::NonZero, &mut List::<ActiveEdge, 16>::new(), &mut Brush::new(light, ramp))
}

/// Letters with soft edges on a black and on a grey ground.
pub fn text<C: Grey>(screen: &mut impl Screen<C>, material: &Material) -> Drawn {
    Circle::new(Point::new(70, 3), 55).into_styled(FillStyle::new(grey::<C>(100))).draw(screen)?;
    let mut screen = Blended::new(screen);
    for (row, size, words) in [(24, 25, "Aquatint"), (40, 13, "of soft edges, & kerned"), (58, 17, "on 256ths")] {
        let text = Text::new(&material.font, words, Subpixel::from_num(size), Point2::corner(2, row));
        text.into_styled(AntialiasedStyle::fill(grey::<C>(255))).draw(&mut screen)?;
    }
    Ok(())
}

/// The spaces in and between rings, each flooded in its way.
pub fn flood<C: Grey>(screen: &mut impl Screen<C>, _: &Material) -> Drawn {
    for size in [Size::new(122, 60), Size::new(77, 41), Size::new(30, 17)] {
        let ring = Ellipse::with_center(Point::new(64, 32), size);
        ring.into_styled(StrokeStyle::new(grey::<C>(255)).with_width(2)).draw(screen)?;
    }
    let (mut memory, mut queue) = ([0; words_needed(WIDTH, HEIGHT)], [Run::default(); 8]);
    let mut flood = Flood::new(&mut memory, &mut queue);
    // Nothing can be refused: the bitmap is as large as the screen.
    let _ = flood.fill(screen, Point::new(64, 32), grey(180));
    let _ = flood.fill(screen, Point::new(64, 20), grey(90));
    let _ = flood.fill_with(screen, Point::new(8, 32), Pattern::from_bits(hatch::DIAGONAL, grey::<C>(140), grey(20)));
    Ok(())
}

/// The bunny, shaded smoothly, in dithered light.
pub fn solid<C: Code>(screen: &mut impl Screen<C>, material: &Material) -> Result<(), String> {
    pure_solid(&mut Dithered::new(screen, levels::<C>()), material)
}

/// The same where each light is a colour.
pub fn pure_solid(light: &mut impl Target<Color = Light, Error = Infallible>, _: &Material) -> Result<(), String> {
    let place = light.bounds();
    show_mesh(light, place, scene::BUNNY, scene::placement(9))
}
