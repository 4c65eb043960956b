//! Lamps of all kinds and the vertices' own lights, through the pipeline.

use aquatint::{
    Light, Matrix, Model, Point3, Rect, Vector3, World,
    fragment::shade::{Flat, Gouraud, Phong, Shading, Unlit},
    geometry::{
        light::{Lighting, Surface},
        lights::{Lights, Source},
    },
    hidden::convex::Convex,
    pipeline::{Instance, Material, MeshVertex, Scene, Workspace, draw_mesh},
};

use crate::common::{Canvas, Shape, VIEW, camera_scene, draw, number, panel, place};

const SCREEN: Rect = Rect::new(0, 0, 96, 96);

/// A wall that fills the view, at a distance of 4: −2 to 2 across and down. One quadrangle, or so many across.
fn wall(quads: i16) -> Shape {
    let places = || (0..=quads).flat_map(move |row| (0..=quads).map(move |column| (column, row)));
    let along = |at: i16| (f64::from(at) / f64::from(quads) - 0.5) * 2.1;
    let positions: Vec<_> = places().map(|(column, row)| place([along(column), along(row), -2.0])).collect();
    let triangles = places().filter(|(column, row)| *column < quads && *row < quads).flat_map(|(column, row)| {
        let at = |column: i16, row: i16| (row * (quads + 1) + column).cast_unsigned();
        let [a, b, c, d] = [at(column, row), at(column + 1, row), at(column + 1, row + 1), at(column, row + 1)];
        [[a, b, c], [a, c, d]]
    });
    let count = positions.len();
    Shape {
        triangles: triangles.collect(),
        normals: vec![[0, 0, 127]; count],
        lights: vec![Light::WHITE; count],
        uv: vec![[0; 2]; count],
        positions,
    }
}

fn drawn<S: Shading<Color = Light>, L: Lighting>(shape: &Shape, shading: S, surface: Surface, light: L) -> Canvas {
    let mut canvas = Canvas::new(SCREEN);
    let scene = Scene { camera: camera_scene(SCREEN).camera, light };
    let mut vertices = vec![MeshVertex::EMPTY; shape.positions.len()];
    let material = Material { surface, ..Material::new(shading) };
    let instance = Instance::new(shape.mesh(), Matrix::<Model, World>::scale(number(2.0))).with_material(material);
    let mut workspace = Workspace { vertices: &mut vertices, hidden: &mut Convex };
    draw_mesh(&instance, &scene, &mut workspace, &mut canvas).expect("in range");
    assert!(canvas.colors.iter().all(Option::is_some), "the wall fills the view");
    canvas
}

/// Nothing but highlights.
const MIRROR: Surface = Surface { diffuse: 0, specular: u16::MAX, shininess: 8 };

/// The middle of the brightest pixels of a part of the screen.
fn brightest(canvas: &Canvas, part: Rect) -> [f64; 2] {
    let places = || part.rows().flat_map(|y| part.columns().map(move |x| (x, y)));
    let light = |(x, y)| f64::from(canvas.at(x, y).expect("drawn").0);
    let most = places().map(light).fold(0.0, f64::max);
    assert!(most > 50_000.0, "{most}");
    let bright: Vec<_> = places().filter(|at| light(*at) > 0.97 * most).collect();
    let mean = |of: fn(&(i32, i32)) -> i32| {
        bright.iter().map(|at| f64::from(of(at)) + 0.5).sum::<f64>() / crate::common::float(bright.len())
    };
    [mean(|at| at.0), mean(|at| at.1)]
}

/// Where a place of the wall is on the screen.
fn on_screen([x, y]: [f64; 2]) -> [f64; 2] {
    [48.0 + x * 24.0, 48.0 - y * 24.0]
}

fn assert_near(got: [f64; 2], want: [f64; 2]) {
    assert!((got[0] - want[0]).hypot(got[1] - want[1]) < 1.5, "{got:?} for {want:?}");
}

fn vector(v: [f64; 3]) -> Vector3<World> {
    let [x, y, z] = v.map(number);
    Vector3::new(x, y, z)
}

/// A lamp beside the viewer is mirrored half-way; one far away where the angle is that of the way out.
#[test]
fn highlights_are_where_the_half_vector_is_the_normal() {
    for [x, y] in [[1.0, 0.5], [-0.8, 0.7], [0.0, 0.0], [0.4, -1.1]] {
        let [px, py, pz] = [2.0 * x, 2.0 * y, 0.0].map(number);
        let position = Point3::new(px, py, pz);
        let near = Source::Point { position, light: Light::WHITE, reach: number(4.0) };
        let canvas = drawn(&wall(1), Phong, MIRROR, Lights { ambient: Light(0), sources: [near] });
        assert_near(brightest(&canvas, SCREEN), on_screen([x, y]));
        let far = Source::Directional { direction: vector([x, y, 4.0]), light: Light::WHITE };
        let canvas = drawn(&wall(1), Phong, MIRROR, Lights { ambient: Light(0), sources: [far] });
        assert_near(brightest(&canvas, SCREEN), on_screen([x, y]));
    }
}

#[test]
fn two_lamps_make_two_highlights() {
    let source = |x: f64| Source::Directional { direction: vector([x, 0.0, 4.0]), light: Light::WHITE };
    let canvas = drawn(&wall(1), Phong, MIRROR, Lights { ambient: Light(0), sources: [source(-1.0), source(1.2)] });
    assert_near(brightest(&canvas, Rect::new(0, 0, 48, 96)), on_screen([-1.0, 0.0]));
    assert_near(brightest(&canvas, Rect::new(48, 0, 96, 96)), on_screen([1.2, 0.0]));
    assert!(canvas.at(48, 48).expect("drawn").0 < 20_000, "dark between them");
}

/// A highlight in the middle of a face is lost between its corners; on many small faces it is not.
#[test]
fn only_phong_shading_shows_a_highlight_inside_of_a_face() {
    let light = Lights {
        ambient: Light(0x1000),
        sources: [Source::Directional { direction: vector([0.0, 0.0, 1.0]), light: Light::WHITE }],
    };
    let middle = |canvas: &Canvas| canvas.at(48, 48).expect("drawn").0;
    assert!(middle(&drawn(&wall(1), Gouraud, MIRROR, light)) < 0x1000);
    assert!(middle(&drawn(&wall(1), Phong, MIRROR, light)) > 0xF000);
    let (fine, exact) = (drawn(&wall(32), Gouraud, MIRROR, light), drawn(&wall(1), Phong, MIRROR, light));
    let off = fine.colors.iter().zip(&exact.colors).map(|(a, b)| a.expect("all").0.abs_diff(b.expect("all").0)).max();
    assert!(off.is_some_and(|off| off < 3_000), "{off:?}");
}

/// A torch: bright inside of its cone, dark beside it, with the eye where it is.
#[test]
fn a_torch_on_a_wall() {
    let [x, y, z] = [0.0, 0.0, 0.0].map(number);
    let torch = Source::Spot {
        position: Point3::new(x, y, z),
        direction: vector([0.0, 0.0, -1.0]),
        light: Light::WHITE,
        reach: number(4.0),
        inner: aquatint::Angle::from_degrees(8.0),
        outer: aquatint::Angle::from_degrees(14.0),
    };
    let canvas = drawn(&wall(1), Phong, Surface::MATTE, Lights { ambient: Light(0), sources: [torch] });
    // The tangents of 8° and 14° are 0.141 and 0.249: 13.5 and 23.9 pixels from the middle.
    for (x, y) in SCREEN.rows().flat_map(|y| SCREEN.columns().map(move |x| (x, y))) {
        let from_middle = (f64::from(x) - 47.5).hypot(f64::from(y) - 47.5);
        let light = canvas.at(x, y).expect("drawn").0;
        assert!(from_middle > 12.5 || light > 60_000, "{x}, {y}: {light}");
        assert!(from_middle < 25.0 || light == 0, "{x}, {y}: {light}");
    }
}

/// How much of the light each vertex gives back: from half a panel to the other, as light itself.
#[test]
fn the_lights_of_vertices() {
    fn picture<S: Shading<Color = Light>>(shape: &Shape, shading: S) -> String {
        let mut canvas = Canvas::new(VIEW);
        draw(shape, Material::new(shading), &mut Convex, &mut canvas).expect("in range");
        canvas.picture()
    }

    let mut shape = panel(VIEW, [0.0; 2]);
    shape.lights = [0x0000, 0xFFFF, 0xFFFF, 0x0000].map(Light).to_vec();
    let ramp = "0123456789abcdef\n".repeat(8);
    assert_eq!(picture(&shape, Gouraud), ramp);
    assert_eq!(picture(&shape, Phong), ramp);
    assert_eq!(picture(&shape, Unlit), "ffffffffffffffff\n".repeat(8));
    // One light a face: that of the first corner.
    shape.triangles = vec![[1, 2, 0], [0, 2, 3]];
    assert_eq!(picture(&shape, Flat).matches(['0', 'f']).count(), 128);
    assert_eq!(picture(&shape.clone().in_light(0x8000), Flat), "8888888888888888\n".repeat(8));
    assert_eq!(picture(&shape.in_light(0), Flat), "0000000000000000\n".repeat(8));
}

/// What a surface gives back counts once.
#[test]
fn a_grey_surface() {
    let mut canvas = Canvas::new(VIEW);
    let surface = Surface { diffuse: 0x8000, ..Surface::MATTE };
    let material = Material { surface, ..Material::new(Gouraud) };
    draw(&panel(VIEW, [0.0; 2]).in_light(0x8FFF), material, &mut Convex, &mut canvas).expect("in range");
    assert_eq!(canvas.picture(), "4444444444444444\n".repeat(8));
}
