//! Fronts, backs and both of faces, and the light on each.

use aquatint::{
    Light, Matrix, Model, Rect, Vector3, World,
    fragment::shade::{Flat, Gouraud, Phong, Shading, Unlit},
    geometry::{face::Faces, light::Lamp},
    hidden::{convex::Convex, depth::DepthBuffer},
    pipeline::{Instance, Material, MeshVertex, Scene, Workspace, draw_mesh},
};

use crate::common::{Canvas, Shape, VIEW, camera_scene, draw, draw_in, number, panel, place, scene};

/// Two panels, of which the right one shows its back.
fn front_and_back() -> Shape {
    let (mut both, back) = (panel(Rect::new(1, 1, 7, 7), [0.0; 2]), panel(Rect::new(9, 1, 15, 7), [0.0; 2]));
    both.positions.extend(back.positions);
    both.normals.extend([[0, 0, 127]; 4]);
    both.triangles.extend([[4, 6, 5], [4, 7, 6]]);
    both.lights.extend(back.lights);
    both.uv.extend(back.uv);
    both
}

fn drawn<S: Shading<Color = Light>>(shading: S, faces: Faces, lamp: Lamp) -> String {
    let mut canvas = Canvas::new(VIEW);
    let material = Material { faces, ..Material::new(shading) };
    let scene = Scene { camera: scene(VIEW).camera, light: lamp };
    draw_in(&scene, &front_and_back().mesh(), material, (&mut Convex, &mut canvas)).expect("in range");
    canvas.picture()
}

/// From the viewer's side, or from the other.
fn lamp(z: f64) -> Lamp {
    let direction = Vector3::new(number(0.0), number(0.0), number(z));
    Lamp { direction, ambient: Light(0x2000), diffuse: Light(0xC000) }
}

fn rows(row: &str) -> String {
    let empty = "................\n";
    empty.to_owned() + &(row.to_owned() + "\n").repeat(6) + empty
}

#[test]
fn fronts_backs_and_both() {
    for (faces, row) in
        [(Faces::Front, ".ffffff........."), (Faces::Back, ".........ffffff."), (Faces::Both, ".ffffff..ffffff.")]
    {
        assert_eq!(drawn(Unlit, faces, lamp(-1.0)), rows(row), "{faces:?}");
    }
}

/// The normal of the right panel points away from the viewer; on its back it is turned around.
#[test]
fn backs_are_lit_by_the_normal_turned_around() {
    fn check<S: Shading<Color = Light> + Copy>(shading: S) {
        assert_eq!(drawn(shading, Faces::Both, lamp(-1.0)), rows(".eeeeee..eeeeee."), "from the viewer");
        assert_eq!(drawn(shading, Faces::Both, lamp(1.0)), rows(".222222..222222."), "from behind");
        assert_eq!(drawn(shading, Faces::Back, lamp(-1.0)), rows(".........eeeeee."));
        assert_eq!(drawn(shading, Faces::Front, lamp(-1.0)), rows(".eeeeee........."));
    }
    check(Gouraud);
    check(Flat);
    check(Phong);
}

#[test]
fn normals_of_faces_are_turned_too() {
    let (shape, normals) = (front_and_back(), [[0, 0, -127], [0, 0, -127], [0, 0, 127], [0, 0, 127]]);
    // Vertex normals that would say otherwise.
    let shape = Shape { normals: vec![[127, 0, 0]; 8], ..shape };
    let mesh = shape.mesh().with_face_normals(&normals).expect("one each");
    for (z, row) in [(-1.0, ".eeeeee..eeeeee."), (1.0, ".222222..222222.")] {
        let mut canvas = Canvas::new(VIEW);
        let material = Material { faces: Faces::Both, ..Material::new(Flat) };
        let scene = Scene { camera: scene(VIEW).camera, light: lamp(z) };
        draw_in(&scene, &mesh, material, (&mut Convex, &mut canvas)).expect("in range");
        assert_eq!(canvas.picture(), rows(row));
    }
}

/// The inside of a box is its backs: each pixel once. Its outside is in front of that, pixel for pixel.
#[test]
fn the_inside_of_a_box() {
    let side = |vertex: usize, axis: usize| if vertex >> axis & 1 == 1 { 0.8 } else { -0.8 };
    let faces = [[1, 3, 7, 5], [0, 4, 6, 2], [2, 6, 7, 3], [0, 1, 5, 4], [4, 5, 7, 6], [0, 2, 3, 1]];
    let shape = Shape {
        positions: (0..8).map(|vertex| place([0, 1, 2].map(|axis| side(vertex, axis)))).collect(),
        normals: vec![[0, 0, 127]; 8],
        triangles: faces.into_iter().flat_map(|[a, b, c, d]| [[a, b, c], [a, c, d]]).collect(),
        lights: vec![Light::WHITE; 8],
        uv: vec![[0; 2]; 8],
    };
    let screen = Rect::new(0, 0, 64, 64);
    let placement = Matrix::<Model, World>::rotation_x(aquatint::Angle(3000))
        .then(&Matrix::<World, World>::rotation_y(aquatint::Angle(7000)))
        .then(&Matrix::<World, World>::translation(number(0.0), number(0.0), number(-4.0)));
    let mut drawn = [Faces::Front, Faces::Back, Faces::Both].map(|faces| {
        let mut canvas = Canvas::new(screen);
        let mut depths = vec![0_u16; 64 * 64];
        let mut buffer = DepthBuffer::new(&mut depths, screen).expect("large enough");
        let material = Material { faces, ..Material::new(Unlit) };
        let mut vertices = [MeshVertex::EMPTY; 8];
        let mut workspace = Workspace { vertices: &mut vertices, hidden: &mut buffer };
        let instance = Instance::new(shape.mesh(), placement).with_material(material);
        draw_mesh(&instance, &camera_scene(screen), &mut workspace, &mut canvas).expect("in range");
        (canvas, depths)
    });
    let [front, back, both] = &mut drawn;
    assert_eq!(front.0, back.0, "the same outline");
    assert_eq!(front, both, "what is nearer stays");
    let (pixels, behind) = (front.0.colors.iter().flatten().count(), front.1.iter().zip(&back.1));
    assert!(pixels > 500 && behind.filter(|(front, back)| front > back).count() * 100 > pixels * 95);
}

/// A triangle that the near plane cuts shows the side that its pieces show, with the light of that side.
#[test]
fn a_side_of_what_is_cut() {
    let corners = [[-3.0, -1.0, -6.0], [3.0, -1.0, -6.0], [0.0, -1.0, 2.0]];
    let floor = |triangle: [u16; 3]| Shape {
        positions: corners.map(|corner| place(corner.map(|v| v / 8.0))).to_vec(),
        normals: vec![[0, 127, 0]; 3],
        triangles: vec![triangle],
        lights: vec![Light::WHITE; 3],
        uv: vec![[0; 2]; 3],
    };
    let screen = Rect::new(0, 0, 64, 32);
    let drawn = |triangle, faces, up: f64| {
        let mut canvas = Canvas::new(screen);
        let mut scene = camera_scene(screen);
        scene.light = lamp(0.0);
        scene.light.direction = Vector3::new(number(0.0), number(up), number(0.0));
        let material = Material { faces, ..Material::new(Gouraud) };
        let mut vertices = [MeshVertex::EMPTY; 3];
        let shape = floor(triangle);
        let instance = Instance::new(shape.mesh(), Matrix::<Model, World>::scale(number(8.0))).with_material(material);
        let mut workspace = Workspace { vertices: &mut vertices, hidden: &mut Convex };
        draw_mesh(&instance, &scene, &mut workspace, &mut canvas).expect("in range");
        let lights: Vec<_> = canvas.colors.iter().flatten().map(|light| light.0 >> 12).collect();
        assert!(lights.iter().all(|light| *light == lights[0]), "{}", canvas.picture());
        (lights.len(), lights.first().copied())
    };
    let (front, back) = ([0, 2, 1], [0, 1, 2]);
    let (count, light) = drawn(front, Faces::Front, 1.0);
    assert!(count > 200 && light == Some(0xD), "{count} {light:?}");
    assert_eq!(drawn(front, Faces::Both, 1.0), (count, Some(0xD)));
    assert_eq!(drawn(front, Faces::Back, 1.0), (0, None));
    // Its normal points to the lamp above; the side that is seen now is the other one.
    assert_eq!(drawn(back, Faces::Front, 1.0), (0, None));
    assert_eq!(drawn(back, Faces::Back, 1.0), (count, Some(2)));
    assert_eq!(drawn(back, Faces::Both, -1.0), (count, Some(0xD)));
}

/// A panel of which only a part is drawn on the canvas is the same there.
#[test]
fn both_sides_in_a_part_of_the_view() {
    let mut part = Canvas::new(Rect::new(5, 2, 12, 5));
    let material = Material { faces: Faces::Both, ..Material::new(Gouraud) };
    draw(&front_and_back(), material, &mut Convex, &mut part).expect("in range");
    assert_eq!(part.picture(), "ff..fff\nff..fff\nff..fff\n");
}
