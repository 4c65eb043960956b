//! Colours that are changed: glass, and bands of a cartoon.

use aquatint::{
    Alpha, Blended, Coverage, Light, OnDrawTarget, Rect,
    fragment::{
        shade::{Gouraud, Mapped, Phong, Unlit},
        toon::Bands,
    },
    hidden::{convex::Convex, depth::DepthBuffer},
    pipeline::Material,
};

use crate::common::{Canvas, VIEW, draw, panel};

/// White, half of which is seen.
fn glass() -> Material<Mapped<Unlit, impl Fn(Light) -> Alpha<Light>>> {
    Material::new(Mapped::new(Unlit, |light| Alpha::new(light, Coverage::from_byte(128))))
}

#[test]
fn panes_of_glass_brighten_what_is_behind_them() {
    let mut canvas = Canvas::filled(VIEW, 0x2000);
    let mut depths = [0_u16; 128];
    let mut buffer = DepthBuffer::new(&mut depths, VIEW).expect("large enough");
    let wall = panel(Rect::new(4, 0, 12, 8), [0.0; 2]).in_light(0x4000);
    draw(&wall, Material::new(Gouraud), &mut buffer, &mut canvas).expect("in range");
    // From the back to the front: one behind the wall, two before it.
    let mut buffer = buffer.without_writing();
    for (pane, z) in [(Rect::new(0, 1, 16, 7), 0.5), (Rect::new(2, 2, 10, 6), -0.25), (Rect::new(6, 3, 14, 5), -0.5)] {
        let mut blended = Blended::new(&mut canvas);
        let mut target = OnDrawTarget::new(&mut blended);
        draw(&panel(pane, [z; 2]), glass(), &mut buffer, &mut target).expect("in range");
    }
    let want = "\
2222444444442222
9999444444449999
99ccaaaaaa449999
99ccaaddddaacc99
99ccaaddddaacc99
99ccaaaaaa449999
9999444444449999
2222444444442222
";
    assert_eq!(canvas.picture(), want);
}

/// The order of two panes does not matter where they hide nothing of each other; where depths are stored it does.
#[test]
fn glass_that_hides_is_no_glass() {
    let drawn = |zs: [f64; 2]| {
        let mut canvas = Canvas::filled(VIEW, 0);
        let mut depths = [0_u16; 128];
        let mut buffer = DepthBuffer::new(&mut depths, VIEW).expect("large enough");
        for z in zs {
            let mut blended = Blended::new(&mut canvas);
            let mut target = OnDrawTarget::new(&mut blended);
            draw(&panel(VIEW, [z; 2]), glass(), &mut buffer, &mut target).expect("in range");
        }
        canvas.at(7, 3).expect("drawn").0 >> 12
    };
    assert_eq!((drawn([0.5, -0.5]), drawn([-0.5, 0.5])), (0xC, 0x8));
}

#[test]
fn bands_have_edges() {
    let mut ramp = panel(VIEW, [0.0; 2]);
    ramp.lights = [0, 0xFFFF, 0xFFFF, 0].map(Light).to_vec();
    let bands = Bands::even(3).expect("three");
    let mut by_corners = Canvas::new(VIEW);
    let material = Material::new(Mapped::new(Gouraud, |light| bands.of(light)));
    draw(&ramp, material, &mut Convex, &mut by_corners).expect("in range");
    assert_eq!(by_corners.picture(), "00000888888fffff\n".repeat(8));
    let mut by_pixels = Canvas::new(VIEW);
    let material = Material::new(Mapped::new(Phong, |light| bands.of(light)));
    draw(&ramp, material, &mut Convex, &mut by_pixels).expect("in range");
    assert_eq!(by_pixels.picture(), by_corners.picture(), "the lamp strikes squarely");
}
