//! One picture of shapes, the same to the pixel on every kind of target and in bands.

use aquatint::{
    Code, FillStyle, Frame, Line, Pages, Point2, Polygon, Rows, Rule, StrokeStyle, display::layout::Layout,
};
use embedded_graphics::{
    image::GetPixel,
    mock_display::MockDisplay,
    pixelcolor::{BinaryColor, Gray2, Gray4, Gray8},
    prelude::*,
    primitives::Rectangle,
};

const WIDTH: u32 = 26;
const HEIGHT: u32 = 19;

/// A pentagram by the even-odd rule, a triangle, and a line that comes from far outside.
const PICTURE: &str = "\
..........................
.......#................##
.......##........#....##..
.......##........#####....
......###........#####....
......####......########..
.#####....######.########.
..###.....####...########.
....#.....##.....#######..
........##........######..
....####.##.......#####...
....########......#####...
..#####..###......####....
##.##......#......###.....
...#........#.....###.....
..................##......
...................#......
..........................
..........................
";

/// Draws the three shapes.
fn draw<D: DrawTarget>(target: &mut D, on: D::Color) -> Result<(), D::Error>
where
    D::Color: PixelColor,
{
    let star = [(8, 0), (13, 15), (0, 6), (16, 6), (3, 15)].map(|(x, y)| Point2::corner(x, y));
    let triangle = [(264, 24), (408, 100), (300, 290)].map(|(x, y)| Point2::from_sixteenths(x, y));
    let style = FillStyle::new(on);
    Polygon::new(&[&star]).expect("in range").into_styled(style.with_rule(Rule::EvenOdd)).draw(target)?;
    Polygon::new(&[&triangle]).expect("in range").into_styled(style).draw(target)?;
    // Ends far outside: only what is visible is drawn.
    let line = Line::new(Point::new(-46, 36), Point::new(64, -19));
    line.into_styled(StrokeStyle::new(on)).draw(target)
}

fn picture<C: PixelColor>(target: &impl GetPixel<Color = C>, on: C) -> String {
    let sign = |x, y| if target.pixel(Point::new(x, y)) == Some(on) { '#' } else { '.' };
    (0..19).map(|y| (0..26).map(|x| sign(x, y)).collect::<String>() + "\n").collect()
}

fn on_frame<C: Code, L: Layout<C>>(on: C) -> String {
    let bytes = vec![0; Frame::<C, L, ()>::bytes_needed(WIDTH, HEIGHT)];
    let mut frame = Frame::<C, L, _>::new(bytes, WIDTH, HEIGHT).expect("large enough");
    let Ok(()) = draw(&mut frame, on);
    picture(&frame, on)
}

#[test]
fn every_layout_shows_the_picture() {
    assert_eq!(on_frame::<BinaryColor, Rows>(BinaryColor::On), PICTURE);
    assert_eq!(on_frame::<BinaryColor, Pages>(BinaryColor::On), PICTURE);
    assert_eq!(on_frame::<Gray2, Rows>(Gray2::WHITE), PICTURE);
    assert_eq!(on_frame::<Gray4, Rows>(Gray4::WHITE), PICTURE);
    assert_eq!(on_frame::<Gray8, Rows>(Gray8::new(0xA5)), PICTURE);
}

#[test]
fn a_display_of_another_maker_shows_the_picture() {
    let mut display = MockDisplay::new();
    // Shapes overlap each other; the display is larger than the picture.
    display.set_allow_overdraw(true);
    draw(&mut display.cropped(&Rectangle::new(Point::zero(), Size::new(WIDTH, HEIGHT))), BinaryColor::On)
        .expect("infallible");
    let sign = |x, y| if display.get_pixel(Point::new(x, y)) == Some(BinaryColor::On) { '#' } else { '.' };
    let shown: String = (0..19).map(|y| (0..26).map(|x| sign(x, y)).collect::<String>() + "\n").collect();
    assert_eq!(shown, PICTURE);
}

#[test]
fn bands_make_the_same_picture() {
    for height in [1, 3, 8, 19] {
        let mut frame = Frame::<BinaryColor, Pages, _>::new([0; 26 * 3], WIDTH, HEIGHT).expect("large enough");
        for top in (0..19).step_by(height) {
            let band = Rectangle::new(Point::new(0, top), Size::new(WIDTH, u32::try_from(height).expect("small")));
            let Ok(()) = draw(&mut frame.clipped(&band), BinaryColor::On);
        }
        assert_eq!(picture(&frame, BinaryColor::On), PICTURE, "bands of {height}");
    }
}
