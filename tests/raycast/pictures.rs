//! What is seen: shadows, mirrors, and the same pixels by bands.

use aquatint::{
    Dithered, Frame, Levels, Light, Matrix, Rect, Rows, Scalar, Window, Words,
    geometry::{projection::ViewBox, viewport::Viewport},
    hidden::raycast::{Hierarchy, Node, Objects, Shape},
    pipeline::{Camera, Finish, NoRays, PixelRays, Raycast, draw_rays},
};
use embedded_graphics::{image::GetPixel, pixelcolor::BinaryColor, prelude::Point};

use super::scenes::{FINISHES, LAMP, camera, perspective, plane, scene, sphere, still_life, vector};

const VIEW: Rect = Rect::new(0, 0, 64, 32);

fn frame() -> Frame<Light, Words, Vec<u8>> {
    Frame::new(vec![0; 64 * 32 * 2], 64, 32).expect("large enough")
}

fn rays() -> PixelRays {
    PixelRays::new(&camera([0.5, 1.25, 6.0], [0.0, -0.1, 0.0], VIEW)).expect("an eye")
}

/// Ten shades, from `0` to `9`.
fn picture<O: Objects>(scene: &Raycast<'_, O>, rays: &PixelRays) -> String {
    let mut frame = frame();
    draw_rays(scene, rays, &mut frame).expect("in memory");
    let shade =
        |x, y| frame.pixel(Point::new(x, y)).map_or(' ', |Light(light)| char::from(b'0' + (light / 6_554) as u8));
    (0..32).map(|y| (0..64).map(|x| shade(x, y)).collect::<String>() + "\n").collect()
}

fn assert_picture(got: &str, expected: &str) {
    let expected: String =
        expected.lines().map(str::trim).filter(|line| !line.is_empty()).map(|line| line.to_owned() + "\n").collect();
    assert!(got == expected, "\n{got}");
}

#[test]
fn balls_a_box_and_a_triangle_on_a_floor() {
    let shapes = still_life();
    assert_picture(&picture(&scene(&shapes[..]), &rays()), STILL_LIFE);
    let mut nodes = [Node::default(); 10];
    let tree = Hierarchy::new(&shapes, &mut nodes).expect("two for each");
    assert_picture(&picture(&scene(tree), &rays()), STILL_LIFE);
}

/// The shadow of a ball above a floor, straight from above.
#[test]
fn a_round_shadow() {
    let shapes = [plane([0.0; 3], [0.0, 1.0, 0.0]), sphere([0.0, 5.0, 0.0], 1.0)];
    let camera = Camera { projection: perspective(60.0, VIEW), ..camera([0.0, 3.0, 0.001], [0.0, 0.0, 0.0], VIEW) };
    let mut scene = scene(&shapes[..]);
    scene.lamp.direction = vector([0.0, 1.0, 0.0]);
    let got = picture(&scene, &PixelRays::new(&camera).expect("an eye"));
    for (y, line) in (0..).zip(got.lines()) {
        for (x, sign) in (0..).zip(line.chars()) {
            // Pixels are 3 · tan 30° / 16 apart.
            let away = (f64::from(x) - 31.5).hypot(f64::from(y) - 15.5) * 3.0 * 0.57735 / 16.0;
            let expected = if away < 1.0 { '0' } else { '6' };
            assert!(sign == expected || (away - 1.0).abs() < 0.01, "{x}, {y}: {away}\n{got}");
        }
    }
}

/// In a wall that is all mirror the other half of the picture is seen turned around.
#[test]
fn a_flat_mirror() {
    let shapes = [
        plane([0.0, 0.0, -2.0], [0.0, 0.0, 1.0]),
        sphere([-1.5, 0.25, 2.0], 0.75),
        // Where the mirror says that it is.
        sphere([-1.5, 0.25, -6.0], 0.75),
    ];
    let rays = PixelRays::new(&camera([0.0, 0.0, 4.0], [0.0; 3], VIEW)).expect("an eye");
    let finishes = [Finish { diffuse: 0, mirror: u16::MAX }, Finish::MATTE];
    // The lamp is in the plane of the mirror, so that it lights both alike.
    let lamp = aquatint::geometry::light::Lamp { direction: vector([1.0, 1.0, 0.0]), ..LAMP };
    let of = |shapes: &[Shape]| {
        picture(&Raycast { objects: shapes, finishes: &finishes, lamp, background: Light(20_000) }, &rays)
    };
    let (mirrored, direct) = (of(&shapes[..2]), of(&[Shape::NOTHING, shapes[1], shapes[2]]));
    assert!(mirrored.matches(['1', '0']).count() > 100, "\n{mirrored}");
    let differences = mirrored.chars().zip(direct.chars()).filter(|(a, b)| a != b).count();
    assert!(differences <= 4, "{differences}\n{mirrored}\n{direct}");
}

/// Rows, columns and targets that begin anywhere give the pixels of the whole.
#[test]
fn bands_are_the_same_as_the_whole() {
    let (shapes, rays) = (still_life(), rays());
    let scene = scene(&shapes[..]);
    let mut whole = frame();
    draw_rays(&scene, &rays, &mut whole).expect("in memory");
    let mut bands = vec![];
    for top in (0..32).step_by(5) {
        let height = u32::try_from(5.min(32 - top)).expect("positive");
        let mut band = Frame::<Light, Words, _>::new(vec![0; 64 * 5 * 2], 64, height).expect("large enough");
        draw_rays(&scene, &rays, &mut Window::band(&mut band, top)).expect("in memory");
        bands.extend_from_slice(band.bytes());
    }
    assert_eq!(whole.bytes(), bands);
    // To one bit a pixel without a frame of light in between.
    let mut bits = Frame::<BinaryColor, Rows, _>::new([0; 256], 64, 32).expect("large enough");
    draw_rays(&scene, &rays, &mut Dithered::new(&mut bits, Levels::ONE_BIT)).expect("in memory");
    let pixels = || (0..64 * 32).map(|at| Point::new(at % 64, at / 64));
    let lit = pixels().filter(|at| bits.pixel(*at) == Some(BinaryColor::On)).count();
    let light: f64 = pixels().filter_map(|at| whole.pixel(at)).map(|light| f64::from(light.0) / 65_535.0).sum();
    assert!((lit as f64 / light - 1.0).abs() < 0.05, "{lit} of {light}");
}

/// Each pixel's ray against the inverse of the projection in doubles, for views that begin anywhere.
#[test]
fn rays_go_through_the_centres_of_pixels() {
    for (view, degrees) in
        [(VIEW, 50.0), (Rect::new(-100, 3000, 300, 3240), 20.0), (Rect::new(-4096, -4096, 4096, 4096), 120.0)]
    {
        let camera =
            Camera { projection: perspective(degrees, view), ..camera([3.0, 2.0, 5.0], [-1.0, 0.5, 0.0], view) };
        let rays = PixelRays::new(&camera).expect("an eye");
        for row in [view.top, view.top + 7, view.bottom - 1] {
            let columns = [view.left, view.left + 5, view.right - 1];
            for column in columns {
                let ray = rays.run(row, column..column + 1).next().expect("inside");
                // Where the ray meets a wall before the camera, projected.
                let wall = [plane([-1.0, 0.5, 0.0], [4.0, 1.5, 5.0])];
                let Some(hit) = wall.nearest(&ray) else { continue };
                let to_clip = camera.view.then(&camera.projection).rows().map(|row| row.map(|v| v.to_num::<f64>()));
                let place = super::oracle::of_point(hit.position);
                let [x, y, _, w] = to_clip.map(|[a, b, c, d]| a * place[0] + b * place[1] + c * place[2] + d);
                let across = f64::midpoint(x / w, 1.0) * f64::from(view.width()) + f64::from(view.left);
                let down = f64::midpoint(1.0, -y / w) * f64::from(view.height()) + f64::from(view.top);
                let off = (across - f64::from(column) - 0.5).hypot(down - f64::from(row) - 0.5);
                // The eye is right to 2⁻¹⁴.
                let most = 0.002 + 1.0 / 8_192.0 * f64::from(view.height());
                assert!(off < most, "{view:?} {column} {row}: {off}");
            }
        }
        assert_eq!(rays.run(view.top - 1, view.columns()).count(), 0);
        assert_eq!(rays.run(view.top, i32::MIN..i32::MAX).count(), view.width() as usize);
    }
}

#[test]
fn cameras_without_an_eye_are_refused() {
    let good = camera([0.0, 0.0, 4.0], [0.0; 3], VIEW);
    let seen = ViewBox { height: Scalar::ONE, aspect: Scalar::ONE, near: Scalar::ZERO, far: Scalar::ONE };
    let parallel = Camera { projection: Matrix::orthographic(seen).expect("a box"), ..good };
    assert_eq!(PixelRays::new(&parallel), Err(NoRays::NoEye));
    let flat = Camera { view: Matrix::scale(Scalar::ZERO), ..good };
    assert_eq!(PixelRays::new(&flat), Err(NoRays::NoEye));
    let none = Camera { projection: Matrix::from_rows([[Scalar::ZERO; 4]; 4]), ..good };
    assert_eq!(PixelRays::new(&none), Err(NoRays::NoEye));
    let far = Camera { view: Matrix::translation(Scalar::ZERO, Scalar::ZERO, Scalar::from_num(-65)), ..good };
    assert_eq!(PixelRays::new(&far), Err(NoRays::OutOfRange));
    let ends = [Scalar::MIN, Scalar::MAX, Scalar::DELTA];
    for (a, b) in ends.iter().flat_map(|a| ends.map(|b| (*a, b))) {
        let view = Matrix::from_rows([
            [a, b, b, a],
            [b, a, -Scalar::ONE, b],
            [b, b, a, a],
            [Scalar::ZERO, Scalar::ZERO, Scalar::ZERO, Scalar::ONE],
        ]);
        let projection =
            Matrix::from_rows([[a, b, a, Scalar::ZERO], [b, b, a, Scalar::ZERO], [a; 4], [b, a, a, Scalar::ZERO]]);
        for viewport in [good.viewport, Viewport::new(Rect::new(-4096, 4095, 4096, 4096)).expect("a viewport")] {
            for camera in
                [Camera { view, ..good }, Camera { projection, ..good }, Camera { view, projection, viewport }]
            {
                let Ok(rays) = PixelRays::new(&camera) else { continue };
                let _ = rays.run(viewport.rect().top, viewport.rect().columns()).count();
            }
        }
    }
}

#[test]
fn numbers_beyond_the_finishes_have_the_last_one() {
    let shapes = [Shape::NOTHING, sphere([0.0; 3], 1.0)];
    let rays = PixelRays::new(&camera([0.0, 0.0, 4.0], [0.0; 3], VIEW)).expect("an eye");
    let lit = |finishes| {
        let mut frame = frame();
        let scene = Raycast { objects: &shapes[..], finishes, lamp: LAMP, background: Light::BLACK };
        draw_rays(&scene, &rays, &mut frame).expect("in memory");
        frame.pixel(Point::new(32, 16)).expect("inside").0
    };
    let (none, half) = (lit(&[]), lit(&[Finish { diffuse: u16::MAX / 2, mirror: 0 }]));
    assert!(none > 20_000 && half.abs_diff(none / 2) <= 1, "{none} {half}");
    assert_eq!(lit(&FINISHES[2..3]), none);
}

const STILL_LIFE: &str = "
    1111111111111111111111111111111111111111111111111111111111111111
    1111111111111111111111111111111111111111111111111111111111111111
    1111111111111111111111111111111111111111111111111111111111111111
    1111111111111111111111111111111111111111111111111111111111111111
    1111111111111111111111111111111111111111111111111111111111111111
    1111111111111111111111111111111111111111111111111111111111111111
    1111111111111111111113111111111111111111111111111111111111111111
    1111111111111111111113111111111111111111111111111111111111111111
    1111111111111111111113311111111111111111111111111111111111111111
    1555555555555555555533355555555555555555555555555511111111111111
    5555555555555555555533355555555222225555555555555555555555555555
    5555555555555555555533335555522222221555553666666555555555555555
    5555555555555555555533335555522222221155553444444555555555555555
    5555555555555555555333333555322222211115553444444555555555555555
    5555555555555555555333333555222222111135533444444555555555555555
    5555555555555555555333333355522221111135533444444555555555555555
    5555555555555555553333333355515555554435533444444555555555555555
    5555555555555555553887533335511555544335534444444555555555555555
    5555555555555555558876535555511554444400534444444555555555555555
    5555555555555555558765421555544444444000034444444055555555555555
    5555555555555555556654311555550444400000034444444005555555555555
    5555555555555555555543110005555500000005554444440555555555555555
    5555555555555555555321110005555555555555555555555555555555555555
    5555555555555555555511000055555555555555555555555555555555555555
    5555555555555555555555555555555555555555555555555555555555555555
    5555555555555555555555555555555555555555555555555555555555555555
    5555555555555555555555555555555555555555555555555555555555555555
    5555555555555555555555555555555555555555555555555555555555555555
    5555555555555555555555555555555555555555555555555555555555555555
    5555555555555555555555555555555555555555555555555555555555555555
    5555555555555555555555555555555555555555555555555555555555555555
    5555555555555555555555555555555555555555555555555555555555555555
";
