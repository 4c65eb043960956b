//! The picture: a turning solid, a star, text. It knows no board, so that it can be tried on the desk, too.

use aquatint::{
    Angle, Dithered, FillStyle, Frame, Hershey, Levels, Light, Matrix, Model, Pages, Point2, Polygon, Rect, Scalar,
    StrokeStyle, Subpixel, Text, Vector3, View, World,
    fragment::shade::Flat,
    geometry::{light::Lamp, projection::Lens, viewport::Viewport},
    model::solids::DODECAHEDRON,
    pipeline::{Camera, Instance, Material, Scene, SceneMemory, draw_scene},
};
use embedded_graphics::{
    pixelcolor::{BinaryColor, Gray8},
    prelude::*,
    primitives::{Circle, PrimitiveStyleBuilder},
};

/// 128 × 64 pixels in 1 KiB, in the order in which an SSD1306 takes its bytes.
pub type Screen = Frame<BinaryColor, Pages, [u8; 1024]>;

/// Room for the 20 vertices and 36 triangles of a dodecahedron.
pub type Memory = SceneMemory<20, 36, 36, Flat>;

/// From a frame to the next: 128 frames a turn. Angles count 65,536ths of a turn, and wrap around.
pub const STEP: u16 = 512;

/// Draws one frame. `None` if one of the numbers below is out of range.
pub fn draw(screen: &mut Screen, memory: &mut Memory, turn: Angle) -> Option<()> {
    let Ok(()) = screen.clear(BinaryColor::Off);
    draw_solid(screen, memory, turn)?;
    draw_badge(screen)?;
    draw_text(screen);
    Some(())
}

/// On the left a lit dodecahedron, turned about the upright axis and tipped towards us.
fn draw_solid(screen: &mut Screen, memory: &mut Memory, turn: Angle) -> Option<()> {
    let [nil, one, three] = [0, 1, 3].map(Scalar::from_num);
    // 40 degrees, a ninth of a turn: a solid of radius 1, three away, just fits.
    let lens = Lens { field_of_view: Angle(u16::MAX / 9), aspect: one, near: one, far: three * 2 };
    let camera = Camera {
        view: Matrix::<World, View>::translation(nil, nil, -three),
        projection: Matrix::perspective(lens).ok()?,
        viewport: Viewport::new(Rect::new(0, 0, 64, 64)).ok()?,
    };
    let lamp = Lamp { direction: Vector3::new(-one, three, one + one), ambient: Light(6_000), diffuse: Light(59_000) };
    let placement = Matrix::<Model, World>::rotation_y(turn).then(&Matrix::rotation_x(Angle(4_000)));
    let solid = Instance::new(DODECAHEDRON, placement).with_material(Material::new(Flat));
    draw_scene(&[solid], &Scene { camera, light: lamp }, memory, &mut Dithered::new(screen, Levels::ONE_BIT)).ok()
}

/// On the right a grey disc, by embedded-graphics, and a white star on it.
fn draw_badge(screen: &mut Screen) -> Option<()> {
    let grey =
        PrimitiveStyleBuilder::new().fill_color(Gray8::new(130)).stroke_color(Gray8::WHITE).stroke_width(1).build();
    let mut greys = Dithered::new(screen, Levels::ONE_BIT).into_draw_target();
    let Ok(()) = Circle::new(Point::new(74, 0), 46).into_styled(grey).draw(&mut greys);

    let star = [(97, 3), (109, 39), (78, 17), (116, 17), (85, 39)].map(|(x, y)| Point2::corner(x, y));
    let contours = [&star[..]];
    let Ok(()) = Polygon::new(&contours).ok()?.into_styled(FillStyle::new(BinaryColor::On)).draw(screen);
    Some(())
}

/// Below it text of any size, from a font of strokes.
fn draw_text(screen: &mut Screen) {
    let text = Text::new(&Hershey::SIMPLEX, "aquatint", Subpixel::from_num(15), Point2::corner(66, 60));
    let Ok(()) = text.on_whole_pixels().into_styled(StrokeStyle::new(BinaryColor::On)).draw(screen);
}
