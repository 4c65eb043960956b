//! Pixels that are left out hide nothing: stipples, and masks of a user's own.

use aquatint::{
    Light, Rect,
    fragment::shade::{Corner, Gouraud, Shader, Shading, Stippled},
    hidden::{
        convex::Convex,
        depth::{Depth, DepthBuffer},
    },
    pipeline::Material,
};

use crate::common::{Canvas, Shape, VIEW, draw, panel};

/// A near panel with holes, then a far one behind it.
fn before_a_wall<S: Shading<Color = Light>, D: Depth + Ord>(near: &Shape, shading: S, nothing: D) -> String {
    let mut canvas = Canvas::new(VIEW);
    let mut depths = [nothing; 128];
    let mut buffer = DepthBuffer::new(&mut depths, VIEW).expect("large enough");
    draw(near, Material::new(shading), &mut buffer, &mut canvas).expect("in range");
    let wall = panel(Rect::new(0, 0, 16, 6), [0.5; 2]).in_light(0x4000);
    draw(&wall, Material::new(Gouraud), &mut buffer, &mut canvas).expect("in range");
    canvas.picture()
}

/// The tile counts from the corner of the screen, eight columns and as many rows as it has.
#[test]
fn a_stippled_panel_is_seen_through() {
    let near = panel(Rect::new(2, 1, 15, 8), [-0.5; 2]).in_light(0xF000);
    let stippled = Stippled::new(Gouraud, [0b1111_0000, 0b1010_1010, 0b0000_0001]);
    let want = "\
4444444444444444
44f4f4f4f4f4f4f4
4444444f44444444
44ff4444ffff4444
44f4f4f4f4f4f4f4
4444444f44444444
..ff....ffff....
..f.f.f.f.f.f.f.
";
    assert_eq!(before_a_wall(&near, stippled, 0_u16), want);
    assert_eq!(before_a_wall(&near, stippled, 0_u8), want);
    assert_eq!(before_a_wall(&near, stippled, 0_u32), want);
}

#[test]
fn tiles_of_all_and_of_nothing() {
    let near = panel(VIEW, [-0.5; 2]).in_light(0xF000);
    assert_eq!(before_a_wall(&near, Stippled::new(Gouraud, [0xFF]), 0_u16), "ffffffffffffffff\n".repeat(8));
    let wall = "4444444444444444\n".repeat(6) + &"................\n".repeat(2);
    assert_eq!(before_a_wall(&near, Stippled::new(Gouraud, [0; 5]), 0_u16), wall);
    assert_eq!(before_a_wall(&near, Stippled::new(Gouraud, []), 0_u16), wall, "a tile of no rows");
}

/// Two tiles that complement each other leave no pixel out and show none twice.
#[test]
fn stipples_complement_each_other() {
    let tile = [0b1001_0110_u8, 0b0011_1100, 0b1110_0001, 0b0101_0101];
    let mut canvas = Canvas::new(VIEW);
    let shape = panel(VIEW, [0.0; 2]);
    draw(&shape.clone().in_light(0x1000), Material::new(Stippled::new(Gouraud, tile)), &mut Convex, &mut canvas)
        .expect("in range");
    let half = canvas.clone();
    let rest = Stippled::new(Gouraud, tile.map(|bits| !bits));
    draw(&shape.in_light(0x2000), Material::new(rest), &mut Convex, &mut canvas).expect("in range");
    for (before, after) in half.colors.iter().zip(&canvas.colors) {
        assert_eq!(after.map(|light| light.0 >> 12), Some(if before.is_some() { 1 } else { 2 }));
    }
    assert_eq!(half.colors.iter().flatten().count(), 64);
}

/// A disc cut out of a panel, by the places of its corners.
fn disc() -> impl Shading<Color = Light> + Copy {
    let place = |v: i16| v.cast_unsigned() ^ 0x8000;
    Shader::new(
        move |corner: &Corner| [place(corner.position[0]), place(corner.position[1]), corner.color.0],
        |[x, y, light]: [u16; 3]| {
            let along = |v: u16| i64::from(v) - 0x8000;
            // As wide as high on the screen, whose pixels are half as wide in the mesh.
            let (x, y) = (2 * along(x), along(y));
            (x * x + y * y < 15_980 * 15_980).then_some(Light(light))
        },
    )
}

#[test]
fn a_mask_hides_nothing_where_it_gives_no_colour() {
    let near = panel(VIEW, [-0.5; 2]).in_light(0xF000);
    let want = "\
444444ffff444444
44444ffffff44444
4444ffffffff4444
4444ffffffff4444
4444ffffffff4444
4444ffffffff4444
.....ffffff.....
......ffff......
";
    assert_eq!(before_a_wall(&near, disc(), 0_u16), want);
    assert_eq!(before_a_wall(&near, disc(), 0_u32), want);
}

#[test]
fn a_mask_of_a_mask() {
    let mut canvas = Canvas::new(VIEW);
    let near = panel(VIEW, [-0.5; 2]).in_light(0xF000);
    draw(&near, Material::new(Stippled::new(disc(), [0b1010_1010, 0b0101_0101])), &mut Convex, &mut canvas)
        .expect("in range");
    let want = "\
......f.f.......
.....f.f.f......
....f.f.f.f.....
.....f.f.f.f....
....f.f.f.f.....
.....f.f.f.f....
......f.f.f.....
.......f.f......
";
    assert_eq!(canvas.picture(), want);
}
