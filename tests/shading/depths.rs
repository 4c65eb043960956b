//! Depths over triangles of any shape, from the near plane to the far one: against doubles, and never around the end.

use aquatint::{
    Light, Rect,
    fragment::shade::Gouraud,
    hidden::depth::{Depth, DepthBuffer, DepthTest},
    pipeline::Material,
};
use proptest::prelude::*;

use crate::common::{Canvas, Shape, VIEW, draw, draw_in, panel, scene};

const SCREEN: Rect = Rect::new(0, 0, 512, 256);

/// The depths of all pixels of a triangle whose corners are sixteenths of pixels on the screen and nearnesses from −16384,
/// at the near plane, to 16384.
fn stored<D: Depth + Ord>(corners: [[i16; 3]; 3], nothing: D) -> Vec<(i32, i32, D)> {
    // A sixteenth of a pixel is 4 units across and 8 down.
    let positions = corners.map(|[x, y, z]| [4 * x - 16_384, 16_384 - 8 * y, z]);
    let shape = Shape {
        positions: positions.to_vec(),
        normals: vec![[0, 0, -127]; 3],
        triangles: vec![[0, 1, 2], [0, 2, 1]],
        lights: vec![Light::WHITE; 3],
        uv: vec![[0; 2]; 3],
    };
    let mut canvas = Canvas::new(SCREEN);
    let mut depths = vec![nothing; 512 * 256];
    let buffer = DepthBuffer::new(&mut depths, SCREEN).expect("large enough");
    let mut buffer = buffer.with_test(DepthTest::Always);
    draw_in(&scene(SCREEN), &shape.mesh(), Material::new(Gouraud), (&mut buffer, &mut canvas)).expect("in range");
    let places = SCREEN.rows().flat_map(|y| SCREEN.columns().map(move |x| (x, y)));
    let drawn = places.zip(&canvas.colors).zip(depths).filter(|((_, light), _)| light.is_some());
    drawn.map(|(((x, y), _), depth)| (x, y, depth)).collect()
}

/// What they should be, from 0 to 1.
fn exact(corners: [[i16; 3]; 3], (x, y): (i32, i32)) -> f64 {
    let [[ax, ay, az], [bx, by, bz], [cx, cy, cz]] = corners.map(|corner| corner.map(f64::from));
    let area = (bx - ax) * (cy - ay) - (cx - ax) * (by - ay);
    let (px, py) = (f64::from(x) * 16.0 + 8.0 - ax, f64::from(y) * 16.0 + 8.0 - ay);
    let along_x = ((bz - az) * (cy - ay) - (cz - az) * (by - ay)) / area;
    let along_y = ((cz - az) * (bx - ax) - (bz - az) * (cx - ax)) / area;
    (1.0 - (az + along_x * px + along_y * py) / 16_384.0) / 2.0
}

/// The greatest error of a pixel, in units of 16 bits.
fn worst(corners: [[i16; 3]; 3]) -> [f64; 2] {
    let exact = |x, y| (exact(corners, (x, y)) * 65_536.0).clamp(ENDS, 65_536.0 - ENDS);
    let error = |depth: f64, x, y| (depth - exact(x, y)).abs();
    let of_16 = stored(corners, 0_u16).into_iter().map(|(x, y, depth)| error(f64::from(depth), x, y));
    let of_32 = stored(corners, 0_u32).into_iter().map(|(x, y, depth)| error(f64::from(depth) / 32_768.0, x, y));
    [of_16.fold(0.0, f64::max), of_32.fold(0.0, f64::max)]
}

/// The ends of depths are kept clear by so many units.
const ENDS: f64 = 3.0;

/// Measured: 2.51 units of a triangle that reaches from one plane to the other, and up to three more where the ends of its depths are
/// cut off.
const MOST: f64 = 6.0;

fn corner(reach: i16) -> impl Strategy<Value = [i16; 3]> {
    let z = prop_oneof![Just(-16_384_i16), Just(16_384), Just(-16_383), Just(16_383), -16_384..=16_384_i16];
    (0..reach, 0..reach / 2, z).prop_map(|(x, y, z)| [x, y, z])
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(1_500))]
    #[test]
    fn depths_are_right_and_never_around_the_end(
        corners in prop_oneof![
            prop::array::uniform3(corner(8_191)), prop::array::uniform3(corner(2_000)), prop::array::uniform3(corner(300))
        ],
    ) {
        let [of_16, of_32] = worst(corners);
        prop_assert!(of_16 <= MOST && of_32 <= MOST, "{} and {} of {:?}", of_16, of_32, corners);
    }
}

/// At the near plane, all of it.
#[test]
fn what_lies_on_the_near_plane_is_seen() {
    fn check<D: Depth + Ord>(nothing: D) {
        let mut canvas = Canvas::new(VIEW);
        let mut depths = [nothing; 128];
        let mut buffer = DepthBuffer::new(&mut depths, VIEW).expect("large enough");
        draw(&panel(VIEW, [-1.0; 2]), Material::new(Gouraud), &mut buffer, &mut canvas).expect("in range");
        assert_eq!(canvas.picture(), "ffffffffffffffff\n".repeat(8));
        // Nothing is before it.
        let mut again = Canvas::new(VIEW);
        let mut buffer = buffer.with_test(DepthTest::Nearer);
        draw(&panel(VIEW, [-1.0; 2]), Material::new(Gouraud), &mut buffer, &mut again).expect("in range");
        draw(&panel(VIEW, [-0.9, 1.0]), Material::new(Gouraud), &mut buffer, &mut again).expect("in range");
        assert!(again.colors.iter().all(Option::is_none));
    }
    check(0_u8);
    check(0_u16);
    check(0_u32);
}
