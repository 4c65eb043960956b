//! The whole pipeline: the same picture on every target, and against rays cast in floating point.

mod exact;
mod rays;

use core::{convert::Infallible, ops::Range};

use aquatint::{
    Angle, Code, Dithered, Frame, Levels, Light, Matrix, Model, OnDrawTarget, Pages, Point2, Rect, Rows, Scalar,
    Target, Triangle, Vector3, View, World,
    display::layout::Layout,
    geometry::{face::is_front, light::Lamp, projection::Lens, transform::MeshTransform, viewport::Viewport},
    hidden::depth::DepthBuffer,
    model::mesh::Mesh,
    pipeline::{Camera, DrawError, Instance, MeshVertex, Scene, Workspace, draw_mesh},
    vary::{Ramp, Vertex},
};
use embedded_graphics::{
    Pixel,
    draw_target::DrawTarget,
    geometry::{OriginDimensions, Point, Size},
    image::GetPixel,
    pixelcolor::{BinaryColor, Gray4},
};
use exact::{Overdraw, Random};
use proptest::prelude::*;
use rays::Seen;

const ONE: i16 = 1 << 14;

/// A cube of edge 2 whose faces share no vertex: one light a face.
fn cube() -> Solid {
    let (mut positions, mut normals, mut triangles) = (vec![], vec![], vec![]);
    for axis in 0..3 {
        for side in [1, -1] {
            let base = u16::try_from(positions.len()).expect("few");
            for (u, v) in [(-1, -1), (side, -side), (1, 1), (-side, side)] {
                let mut position = [0; 3];
                (position[axis], position[(axis + 1) % 3], position[(axis + 2) % 3]) = (side * ONE, u * ONE, v * ONE);
                let mut normal = [0; 3];
                normal[axis] = if side > 0 { 127 } else { -127 };
                positions.push(position);
                normals.push(normal);
            }
            triangles.extend([[base, base + 1, base + 2], [base, base + 2, base + 3]]);
        }
    }
    Solid { positions, normals, triangles }
}

/// A mesh that owns its arrays.
struct Solid {
    positions: Vec<[i16; 3]>,
    normals: Vec<[i8; 3]>,
    triangles: Vec<[u16; 3]>,
}

impl Solid {
    fn mesh(&self) -> Mesh<'_> {
        Mesh::new(&self.positions, &self.normals, &self.triangles).expect("indices are right")
    }
}

/// A floor of 4 × 4 at y = −1/8, seen from above; times the scale of its placement.
const FLOOR: Mesh = match Mesh::new(
    &[
        [-2 * ONE, -ONE / 8, -2 * ONE],
        [-2 * ONE, -ONE / 8, 32_767],
        [32_767, -ONE / 8, 32_767],
        [32_767, -ONE / 8, -2 * ONE],
    ],
    &[[0, 127, 0]; 4],
    &[[0, 1, 2], [0, 2, 3]],
) {
    Ok(mesh) => mesh,
    Err(_) => panic!(),
};

fn number(value: f64) -> Scalar {
    Scalar::saturating_from_num(value)
}

fn scene(view: Rect) -> Scene {
    let aspect = number(f64::from(view.width()) / f64::from(view.height()));
    let lens = Lens { field_of_view: Angle::from_degrees(60.0), aspect, near: number(0.5), far: number(64.0) };
    let camera = Camera {
        view: Matrix::<World, View>::translation(Scalar::ZERO, Scalar::ZERO, number(-4.5)),
        projection: Matrix::perspective(lens).expect("a lens"),
        viewport: Viewport::new(view).expect("a viewport"),
    };
    let light = Lamp {
        direction: Vector3::new(number(1.0), number(2.0), number(3.0)),
        ambient: Light(9_000),
        diffuse: Light(50_000),
    };
    Scene { camera, light }
}

fn turned(y: u16, x: u16) -> Matrix<Model, World> {
    Matrix::<Model, Model>::rotation_y(Angle(y)).then(&Matrix::rotation_x(Angle(x)))
}

/// Remembers the light of each pixel.
struct Lights {
    bounds: Rect,
    lights: Vec<Option<Light>>,
}

impl Lights {
    fn new(bounds: Rect) -> Self {
        Self { bounds, lights: vec![None; bounds.width() as usize * bounds.height() as usize] }
    }

    fn at(&self, x: i32, y: i32) -> Option<Light> {
        let index = |v: i32| usize::try_from(v).expect("inside");
        self.lights[index(y - self.bounds.top) * self.bounds.width() as usize + index(x - self.bounds.left)]
    }
}

impl Target for Lights {
    type Color = Light;
    type Error = Infallible;

    fn bounds(&self) -> Rect {
        self.bounds
    }

    fn fill_run<const N: usize>(
        &mut self,
        row: i32,
        columns: Range<i32>,
        colors: [Light; N],
    ) -> Result<(), Infallible> {
        self.write_run(row, columns, core::iter::repeat(Some(colors[0])))
    }

    fn write_run(
        &mut self,
        row: i32,
        columns: Range<i32>,
        lights: impl Iterator<Item = Option<Light>>,
    ) -> Result<(), Infallible> {
        assert!(self.bounds.clip_run(row, columns.clone()) == Some(columns.clone()), "outside");
        let width = self.bounds.width() as usize;
        let start = usize::try_from(row - self.bounds.top).expect("inside") * width;
        for (column, light) in columns.zip(lights) {
            let pixel = &mut self.lights[start + usize::try_from(column - self.bounds.left).expect("inside")];
            *pixel = light.or(*pixel);
        }
        Ok(())
    }
}

/// Draws meshes with a depth buffer over `window`.
fn draw<T: Target<Color = Light>>(
    instances: &[Instance],
    scene: &Scene,
    window: Rect,
    target: &mut T,
) -> Result<(), DrawError<T::Error>> {
    let mut depths = vec![0_u16; window.width() as usize * window.height() as usize];
    let mut depth = DepthBuffer::new(&mut depths, window).expect("large enough");
    let mut vertices = vec![MeshVertex::EMPTY; 64];
    for instance in instances {
        draw_mesh(instance, scene, &mut Workspace { vertices: &mut vertices, hidden: &mut depth }, target)?;
    }
    Ok(())
}

const VIEW: Rect = Rect::new(0, 0, 32, 24);

/// The picture of a cube as codes, on a frame of some kind.
fn cube_on<C: Code + core::fmt::Debug, L: Layout<C>>(levels: Levels, height: i32) -> Vec<C>
where
    Frame<C, L, Vec<u8>>: GetPixel<Color = C>,
{
    let cube = cube();
    let mesh = cube.mesh();
    let bytes = vec![0; Frame::<C, L, ()>::bytes_needed(32, 24)];
    let mut frame = Frame::<C, L, _>::new(bytes, 32, 24).expect("large enough");
    let instance = Instance::new(mesh, turned(0x1400, 0x1700));
    // Bands: a depth buffer of a few rows at a time.
    for top in (0..24).step_by(usize::try_from(height).expect("positive")) {
        let band = Rect::new(0, top, 32, (top + height).min(24));
        let mut light = Dithered::new(&mut frame, levels);
        draw(&[instance], &scene(VIEW), band, &mut light).expect("in range");
    }
    (0..24)
        .flat_map(|y| (0..32).map(move |x| (x, y)))
        .map(|(x, y)| frame.pixel(Point::new(x, y)).expect("inside"))
        .collect()
}

fn picture<C: Code>(codes: &[C]) -> String {
    let sign = |color: &C| match (C::BITS, color.code()) {
        (_, 0) => '.',
        (1, _) => '#',
        (_, code) => char::from_digit(code.into(), 16).expect("four bits"),
    };
    codes.chunks(32).map(|row| row.iter().map(sign).collect::<String>() + "\n").collect()
}

#[test]
fn a_cube_on_one_bit() {
    let rows = cube_on::<BinaryColor, Rows>(Levels::ONE_BIT, 24);
    let expected = include_str!("pictures/cube_1bit.txt");
    assert_eq!(picture(&rows), expected, "\n{}", picture(&rows));
    assert_eq!(cube_on::<BinaryColor, Pages>(Levels::ONE_BIT, 24), rows);
}

#[test]
fn a_cube_on_four_bits() {
    let codes = cube_on::<Gray4, Rows>(Levels::LINEAR_16, 24);
    let expected = include_str!("pictures/cube_4bit.txt");
    assert_eq!(picture(&codes), expected, "\n{}", picture(&codes));
}

#[test]
fn bands_of_any_height_give_the_whole_picture() {
    let (one_bit, four_bits) =
        (cube_on::<BinaryColor, Pages>(Levels::ONE_BIT, 24), cube_on::<Gray4, Rows>(Levels::LINEAR_16, 24));
    for height in [1, 2, 7, 8, 16] {
        assert_eq!(cube_on::<BinaryColor, Pages>(Levels::ONE_BIT, height), one_bit);
        assert_eq!(cube_on::<Gray4, Rows>(Levels::LINEAR_16, height), four_bits);
    }
}

/// A display of another maker: it knows `draw_iter` alone, and breaks after some pixels.
struct Display {
    pixels: Vec<Option<BinaryColor>>,
    left: usize,
}

impl OriginDimensions for Display {
    fn size(&self) -> Size {
        Size::new(32, 24)
    }
}

impl DrawTarget for Display {
    type Color = BinaryColor;
    type Error = &'static str;

    fn draw_iter<I: IntoIterator<Item = Pixel<BinaryColor>>>(&mut self, pixels: I) -> Result<(), &'static str> {
        for Pixel(Point { x, y }, color) in pixels {
            self.left = self.left.checked_sub(1).ok_or("bus error")?;
            self.pixels[usize::try_from(y * 32 + x).expect("inside")] = Some(color);
        }
        Ok(())
    }
}

/// The cube of the other tests on a display that fails after some pixels.
fn cube_on_display(left: usize) -> (Display, Result<(), DrawError<&'static str>>) {
    let cube = cube();
    let mesh = cube.mesh();
    let mut display = Display { pixels: vec![None; 32 * 24], left };
    let mut on_display = OnDrawTarget::new(&mut display);
    let mut light = Dithered::new(&mut on_display, Levels::ONE_BIT);
    let instance = Instance::new(mesh, turned(0x1400, 0x1700));
    let result = draw(&[instance], &scene(VIEW), VIEW, &mut light);
    (display, result)
}

#[test]
fn any_display_shows_the_same_cube() {
    let (display, result) = cube_on_display(usize::MAX);
    assert_eq!(result, Ok(()));
    let frame = cube_on::<BinaryColor, Rows>(Levels::ONE_BIT, 24);
    let shown: Vec<_> = display.pixels.iter().map(|pixel| pixel.unwrap_or(BinaryColor::Off)).collect();
    assert_eq!(shown, frame);
    assert!(display.pixels.contains(&None), "pixels beside the cube are left alone");
}

#[test]
fn an_error_of_the_display_ends_the_drawing() {
    let (display, result) = cube_on_display(20);
    assert_eq!(result, Err(DrawError::Target("bus error")));
    assert_eq!(display.pixels.iter().flatten().count(), 20);
}

#[test]
fn what_cannot_be_drawn_is_said_before_anything_is_drawn() {
    let cube = cube();
    let mesh = cube.mesh();
    let instance = Instance::new(mesh, turned(0, 0));
    let (mut lights, mut depths) = (Lights::new(VIEW), vec![0_u16; 32 * 24]);
    let mut depth = DepthBuffer::new(&mut depths, VIEW).expect("large enough");
    let mut workspace = Workspace { vertices: &mut [MeshVertex::EMPTY; 23], hidden: &mut depth };
    let result = draw_mesh(&instance, &scene(VIEW), &mut workspace, &mut lights);
    assert_eq!(result, Err(DrawError::TooFewVertices { needed: 24 }));

    let huge = Instance::new(mesh, Matrix::scale(number(3000.0)));
    assert_eq!(draw(&[huge], &scene(VIEW), VIEW, &mut lights), Err(DrawError::OutOfRange));
    assert!(lights.lights.iter().all(Option::is_none));
}

/// Every pixel whose five rays agree shows the light of the face that they hit.
fn assert_like_rays(instances: &[Instance], scene: &Scene, view: Rect) -> usize {
    let mut lights = Lights::new(view);
    draw(instances, scene, view, &mut lights).expect("in range");
    let faces: Vec<_> = instances.iter().flat_map(|instance| rays::faces(instance, scene)).collect();
    let (mut sure, mut hits) = (0, 0);
    for (x, y) in view.rows().flat_map(|y| view.columns().map(move |x| (x, y))) {
        let got = lights.at(x, y);
        match rays::seen(&faces, scene, (x, y)) {
            Seen::Unsure => continue,
            Seen::Nothing => assert_eq!(got, None, "pixel {x}, {y}"),
            Seen::Face(light) => assert_eq!(got, Some(light), "pixel {x}, {y}"),
        }
        (sure, hits) = (sure + 1, hits + usize::from(got.is_some()));
    }
    let pixels = lights.lights.len();
    assert!(sure * 100 >= pixels * 85, "only {sure} of {pixels} pixels could be judged");
    hits
}

#[test]
fn a_turning_cube_is_what_rays_see() {
    let cube = cube();
    let mesh = cube.mesh();
    let mut random = Random(1);
    let view = Rect::new(3, 5, 83, 65);
    for _ in 0..100 {
        let mut angle = || u16::try_from(random.below(0x1_0000)).expect("16 bits");
        let instance = Instance::new(mesh, turned(angle(), angle()));
        assert!(assert_like_rays(&[instance], &scene(view), view) > 500);
    }
}

#[test]
fn two_cubes_that_pierce_each_other_are_what_rays_see() {
    let cube = cube();
    let mesh = cube.mesh();
    let mut random = Random(2);
    let view = Rect::new(0, 0, 80, 60);
    for _ in 0..50 {
        let mut angle = || u16::try_from(random.below(0x1_0000)).expect("16 bits");
        let beside = Matrix::<World, World>::translation(number(0.7), number(0.4), number(0.3));
        let first = Instance::new(mesh, turned(angle(), angle()));
        let second = Instance::new(mesh, turned(angle(), angle()).then(&beside));
        assert_like_rays(&[first, second], &scene(view), view);
    }
}

#[test]
fn a_floor_that_passes_under_the_eye_is_what_rays_see() {
    let mut random = Random(3);
    let view = Rect::new(0, 0, 80, 60);
    for _ in 0..100 {
        let mut degrees = |range: i32| f32::from(i16::try_from(random.below(2 * range) - range).expect("small"));
        // Up to 100 units around the eye, of which the far plane leaves 64.
        let placement = Matrix::<Model, World>::scale(number(16.0))
            .then(&Matrix::<World, World>::rotation_y(Angle::from_degrees(degrees(180))));
        let tilt = Matrix::<View, View>::rotation_x(Angle::from_degrees(degrees(40)));
        let mut scene = scene(view);
        scene.camera.view = scene.camera.view.then(&tilt);
        assert_like_rays(&[Instance::new(FLOOR, placement)], &scene, view);
    }
}

#[test]
fn front_and_back_of_a_closed_solid_cover_the_same_pixels_once() {
    let Solid { positions, triangles, .. } = cube();
    let view = Rect::new(0, 0, 60, 60);
    let camera = scene(view).camera;
    let mut random = Random(4);
    for _ in 0..300 {
        let mut angle = || u16::try_from(random.below(0x1_0000)).expect("16 bits");
        let to_clip = turned(angle(), angle()).then(&camera.view).then(&camera.projection);
        let transform = MeshTransform::new(&to_clip).expect("in range");
        let place = |i: u16| camera.viewport.project(&transform.apply(positions[usize::from(i)])).position;
        let (mut front, mut back) = (Overdraw::new(view), Overdraw::new(view));
        for triangle in &triangles {
            let corners: [Point2; 3] = triangle.map(place);
            let pixels = if is_front(corners[0], corners[1], corners[2]) { &mut front } else { &mut back };
            let triangle =
                Triangle::new(corners.map(|position| Vertex { position, attributes: [] })).expect("in range");
            let take = |row, columns, _: Ramp<0>| pixels.add(row, columns);
            let Ok(()) = triangle.spans(&mut aquatint::SpanFn::new(view, take));
        }
        assert_eq!(front, back);
        assert!(front.places().all(|(x, y)| front.count(x, y) <= 1), "\n{}", front.picture());
    }
}

#[test]
fn projected_points_are_within_a_sixteenth_of_the_exact_place() {
    let view = Rect::new(0, 0, 400, 240);
    let viewport = Viewport::new(view).expect("a viewport");
    let mut random = Random(5);
    for scale in [1.0, 8.0, 60.0].into_iter().cycle().take(20_000) {
        let w = f64::from(random.below(1 << 22) + (1 << 13)) / 65_536.0 * scale;
        let mut within = || f64::from(random.below(1 << 17) - (1 << 16)) / 65_536.0 * w;
        let [x, y, z, w] = [within(), within(), within(), w].map(number);
        let got = viewport.project(&aquatint::Point4::new(x, y, z, w));
        let [x, y, z, w] = [x, y, z, w].map(|v| v.to_num::<f64>());
        let exact = [200.0 + x / w * 200.0, 120.0 - y / w * 120.0];
        for (got, exact) in [got.position.x, got.position.y].into_iter().zip(exact) {
            assert!((got.to_num::<f64>() - exact).abs() <= 1.0 / 16.0, "{got} for {exact}, w = {w}");
        }
        // The ends are kept clear.
        let depth = ((w - z) / (2.0 * w) * 65_535.0).clamp(3.0, 65_532.0);
        assert!((f64::from(got.depth >> 8) - depth).abs() <= 2.0, "depth {} for {depth}", got.depth);
    }
}

/// A matrix element of any kind.
fn element() -> impl Strategy<Value = Scalar> {
    prop_oneof![3 => -300_000..300_000_i32, 1 => any::<i32>(), 1 => Just(0), 1 => Just(i32::MIN)]
        .prop_map(Scalar::from_bits)
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(3_000))]

    #[test]
    fn no_matrix_and_no_mesh_panics_or_draws_outside(
        rows in prop::array::uniform4(prop::array::uniform4(element())),
        positions in prop::collection::vec(prop::array::uniform3(any::<i16>()), 3..9),
        triangles in prop::collection::vec(prop::array::uniform3(0..3_u16), 1..6),
        left in -4096..4000_i32, top in -4096..4000_i32,
    ) {
        let normals = vec![[1, 127, -128]; positions.len()];
        let mesh = Mesh::new(&positions, &normals, &triangles).expect("indices are right");
        let instance = Instance::new(mesh, Matrix::IDENTITY);
        let mut scene = scene(Rect::new(left, top, left + 90, top + 60));
        scene.camera.projection = Matrix::from_rows(rows);
        let window = Rect::new(left - 5, top + 5, left + 50, top + 70);
        match draw(&[instance], &scene, window, &mut Lights::new(window)) {
            Ok(()) | Err(DrawError::OutOfRange) => {}
            Err(other) => prop_assert!(false, "{:?}", other),
        }
    }
}
