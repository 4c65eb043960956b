//! Planes that cut instances, and bounds that leave them out.

use super::*;
use aquatint::{
    BoundingBox3, BoundingSphere, ClipPlane, HalfSpace,
    fragment::{
        shade::{Flat, Gouraud, Phong, Plain, Textured},
        texture::{BLACK_AND_WHITE, Sampler, Texture},
    },
    geometry::face::Faces,
    model::revolved::{Parts, torus_triangles, vertices},
    pipeline::{DrawError, MOST_PLANES},
};
use proptest::prelude::*;

const VIEW: Rect = Rect::new(0, 0, 32, 22);

/// What lies on the side of a plane to which a normal points.
fn side(normal: [f64; 3], offset: f64) -> HalfSpace<World> {
    let [x, y, z] = normal.map(number);
    HalfSpace::new(Vector3::new(x, y, z), number(offset)).expect("short")
}

fn cut(scene: &Scene, normal: [f64; 3], offset: f64) -> ClipPlane {
    scene.camera.clip_plane(&side(normal, offset)).expect("can be undone")
}

#[track_caller]
fn assert_picture(canvas: &Canvas<char>, wanted: &str) {
    let picture = canvas.picture(|sign| sign);
    assert!(picture == wanted.trim_start(), "\n{picture}");
}

#[test]
fn a_slice_of_a_cube() {
    let scene = scene(VIEW);
    // A slanted slice: between two planes.
    let planes = [cut(&scene, [1.0, 0.5, 0.0], 0.3), cut(&scene, [-1.0, -0.5, 0.0], 0.3)];
    let cube = Instance::new(SQUARES, turned(30.0, 25.0)).with_planes(&planes);
    let whole = Instance { planes: &[], ..cube.with_material(Material::new(Plain('-'))) };
    let front = cube.with_material(Material { bias: DepthBias::BEHIND_LINES, ..Material::new(Plain('o')) });
    let back = cube.with_material(Material { faces: Faces::Back, ..Material::new(Plain('.')) });
    let lines = cube.with_material(Material::new(Plain('#')));
    let mut canvas = Canvas::new(VIEW);
    with_workspace(&mut Convex, |workspace| draw_wireframe(&whole, &scene, workspace, &mut canvas)).expect("drawn");
    let mut memory = vec![0_u16; canvas.pixels.len()];
    let mut depth = DepthBuffer::new(&mut memory, VIEW).expect("enough");
    with_workspace(&mut depth, |workspace| {
        draw_mesh(&front, &scene, workspace, &mut canvas).expect("drawn");
        draw_mesh(&back, &scene, workspace, &mut canvas).expect("drawn");
        draw_wireframe(&lines, &scene, workspace, &mut canvas).expect("drawn");
    });
    assert_picture(
        &canvas,
        "
................................
................................
................................
............####----............
.......--###........---.........
.......---ooooooo......---......
.......-.##ooooooo.-----.-......
........-.o########......-......
........-..o#oooooo......-......
........-..o#oooooo......-......
........-...#ooooooo....-.......
........-...#ooooooo....-.......
........-...-#oooooo....-.......
........-....#ooooooo...-.......
........-....-ooooooo...-.......
.........-...-oooooooo..-.......
.........-...-.ooooooo..-.......
..........-..-.ooooooo#--.......
...........-.-..oooo##..........
............--...###............
............--.--...............
.............--.................
",
    );
}

const FLOOR: Parts<{ vertices(7, 5) }, { torus_triangles(7, 5) }> = Parts::grid::<7, 5>();

/// How far the corners of a mesh are inside of a plane in the world.
fn distances<S>(instance: &Instance<'_, S>, (normal, offset): ([f64; 3], f64)) -> Vec<f64> {
    let distance = |position: &[i16; 3]| {
        let [x, y, z] = position.map(|v| Scalar::from_bits(i32::from(v) * 4));
        let p = instance.placement.transform_point(Point3::new(x, y, z));
        let point = [p.x, p.y, p.z].map(|v| v.to_num::<f64>());
        normal.iter().zip(point).map(|(a, b)| a * b).sum::<f64>() + offset
    };
    instance.mesh.positions().iter().map(distance).collect()
}

/// Where the ray through a pixel's centre meets the plane y = 0 of the world, seen from (0, 1, 3).
fn on_floor((x, y): (i32, i32)) -> Option<[f64; 2]> {
    let half = (39.0_f64 / 2.0).to_radians().tan();
    let across = ((f64::from(x) + 0.5) / f64::from(VIEW.right) * 2.0 - 1.0) * half * f64::from(VIEW.right)
        / f64::from(VIEW.bottom);
    let up = (1.0 - (f64::from(y) + 0.5) / f64::from(VIEW.bottom) * 2.0) * half;
    (up < 0.0).then(|| [across / -up, 3.0 - 1.0 / -up])
}

fn floor_scene() -> Scene {
    let mut scene = scene(VIEW);
    scene.camera.view = Matrix::translation(number(0.0), number(-1.0), number(-3.0));
    scene
}

/// How often each pixel was drawn.
fn counts<C>(canvas: &Canvas<C>) -> Vec<u32> {
    canvas.pixels.iter().map(|pixel| pixel.0).collect()
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(300))]
    #[test]
    fn a_cut_floor_is_watertight_and_ends_at_the_plane(turn in 0.0..6.3_f64, offset in -1.0..1.0_f64, tilt in -1.0..1.0_f64) {
        let scene = floor_scene();
        let normal = [turn.cos(), tilt, turn.sin()];
        let planes = [cut(&scene, normal, offset)];
        let mesh = FLOOR.mesh().expect("fits");
        // As large as the view.
        let floor = Instance::new(mesh, Matrix::scale(number(1.5))).with_material(Material::new(Plain('#')));
        let (whole, part) = (faces(&floor, &scene, VIEW), faces(&floor.with_planes(&planes), &scene, VIEW));
        for at in part.places() {
            let Some([x, z]) = on_floor(at) else { continue };
            let inside = x * normal[0] + z * normal[2] + offset;
            // A pixel of the rows that are far away is 0.3 long.
            let margin = 0.004 + 0.01 * (3.0 - z);
            if inside.abs() > margin {
                let wanted = if inside > 0.0 { whole.count(at.0, at.1) } else { 0 };
                prop_assert_eq!(part.count(at.0, at.1), wanted, "{:?}, {}", at, inside);
            }
            prop_assert!(part.count(at.0, at.1) <= 1, "no pixel twice");
        }
        // What two sides of a plane show is the whole. Where rounding turns a piece of less than a pixel over, once in 50,000
        // pictures, one pixel differs.
        let other = [scene.camera.clip_plane(&side(normal, offset).opposite()).expect("can be undone")];
        let rest = faces(&floor.with_planes(&other), &scene, VIEW);
        let differs = |&(x, y): &(i32, i32)| part.count(x, y) + rest.count(x, y) != whole.count(x, y);
        let different: Vec<_> = part.places().filter(differs).collect();
        prop_assert!(different.len() <= 1, "{:?}", different);
    }

    #[test]
    fn every_shading_is_cut_alike(y in 0..360_i32, x in 0..360_i32, turn in 0.0..6.3_f64, offset in -0.8..0.8_f64) {
        let scene = scene(VIEW);
        let planes = [cut(&scene, [turn.cos(), 0.3, turn.sin()], offset), cut(&scene, [0.0, 1.0, 0.1], 0.4)];
        let cube = Instance::new(CUBE, pose(y, x)).with_planes(&planes);
        let texture = Texture::new(&[0x80, 0x40], 2, 2, &BLACK_AND_WHITE).expect("fits");
        let gouraud = counts(&faces(&cube, &scene, VIEW));
        prop_assert_eq!(&gouraud, &counts(&faces(&cube.with_material(Material::new(Flat)), &scene, VIEW)));
        prop_assert_eq!(&gouraud, &counts(&faces(&cube.with_material(Material::new(Phong)), &scene, VIEW)));
        let textured = Material::new(Textured::new(Sampler::new(texture), Gouraud));
        prop_assert_eq!(&gouraud, &counts(&faces(&cube.with_material(textured), &scene, VIEW)));
    }

    #[test]
    fn lines_end_at_the_planes(y in 0..360_i32, x in 0..360_i32, turn in 0.0..6.3_f64, offset in -0.8..0.8_f64) {
        let scene = scene(VIEW);
        let normal = [turn.cos(), 0.3, turn.sin()];
        let planes = [cut(&scene, normal, offset)];
        let cube = Instance::new(SQUARES, pose(y, x)).with_material(Material::new(Plain(())));
        let (whole, part) = (edges(&cube, &scene, VIEW), edges(&cube.with_planes(&planes), &scene, VIEW));
        let (corners, distances) = (projected(&cube, &scene), distances(&cube, (normal, offset)));
        if lines::is_edge_on(&corners) {
            return Ok(());
        }
        let all = lines::front_edges(&corners);
        for at in whole.places() {
            // How far inside of the plane the edges are there.
            let inside: Vec<_> = all.iter().filter_map(|&[a, b]| {
                let line = [corners[a], corners[b]];
                lines::aside(line, at).filter(|&aside| aside <= 0.9)?;
                let ((way, _), [near, far]) = (lines::along(line, at), [line[0][2], line[1][2]]);
                let way = way * near / (far - way * (far - near));
                Some(distances[a] + (distances[b] - distances[a]) * way)
            }).collect();
            let near = (-1..=1).flat_map(|dy| (-1..=1).map(move |dx| (at.0 + dx, at.1 + dy)));
            let mut near = near.filter(|&(x, y)| VIEW.columns().contains(&x) && VIEW.rows().contains(&y));
            // A pixel is 0.1 wide; the end that was cut is rounded, which moves the others by one.
            let margin = 0.35;
            if !inside.is_empty() && inside.iter().all(|&inside| inside < -margin) {
                prop_assert_eq!(part.at(at.0, at.1), None, "{:?}", at);
            } else if inside.iter().all(|&inside| inside > margin) && whole.at(at.0, at.1).is_some() {
                prop_assert!(near.any(|(x, y)| part.at(x, y).is_some()), "{:?}", at);
            }
        }
    }

    #[test]
    fn bounds_change_no_picture(y in 0..360_i32, dx in -4.0..4.0_f64, dy in -3.0..3.0_f64, dz in -4.0..4.0_f64) {
        let scene = scene(VIEW);
        let placement = pose(y, y).then(&Matrix::translation(number(dx), number(dy), number(dz)));
        let cube = Instance::new(CUBE, placement);
        let picture = faces(&cube, &scene, VIEW);
        let ball = BoundingSphere::new(Point3::<Model>::ORIGIN, 65_540);
        prop_assert_eq!(&faces(&cube.with_bounds(ball), &scene, VIEW), &picture);
        let walls = BoundingBox3::of_places(CUBE.positions()).expect("some");
        prop_assert_eq!(&faces(&cube.with_bounds(walls), &scene, VIEW), &picture);
    }
}

/// What a workspace's vertices look like, from outside.
fn bytes(vertices: &[MeshVertex]) -> String {
    format!("{vertices:?}")
}

#[test]
fn no_vertex_is_looked_at_where_the_bounds_are_outside() {
    let scene = scene(VIEW);
    let ball = BoundingSphere::new(Point3::<Model>::ORIGIN, 65_540);
    let mut canvas = Canvas::new(VIEW);
    for (x, is_seen) in [(0.0, true), (1.5, true), (-4.0, false), (4.0, false)] {
        let placement = Matrix::translation(number(x), Scalar::ZERO, Scalar::ZERO);
        let cube = Instance::new(CUBE, placement).with_bounds(ball);
        let mut vertices = [MeshVertex::EMPTY; 8];
        let untouched = bytes(&vertices);
        let mut workspace = Workspace { vertices: &mut vertices, hidden: &mut Convex };
        draw_mesh(&cube, &scene, &mut workspace, &mut canvas).expect("drawn");
        draw_wireframe(&cube, &scene, &mut workspace, &mut canvas).expect("drawn");
        assert_eq!(bytes(&vertices) != untouched, is_seen, "at {x}");
    }
}

#[test]
fn too_many_planes_are_an_error_before_anything_is_drawn() {
    let scene = scene(VIEW);
    let planes = [cut(&scene, [1.0, 0.0, 0.0], 9.0); MOST_PLANES + 1];
    let cube = Instance::new(SQUARES, turned(30.0, 25.0));
    let mut canvas = Canvas::new(VIEW);
    let mut workspace = Workspace { vertices: &mut [MeshVertex::EMPTY; 8], hidden: &mut Convex };
    let result = draw_mesh(&cube.with_planes(&planes), &scene, &mut workspace, &mut canvas);
    assert_eq!(result, Err(DrawError::TooManyPlanes));
    let result = draw_wireframe(&cube.with_planes(&planes), &scene, &mut workspace, &mut canvas);
    assert_eq!(result, Err(DrawError::TooManyPlanes));
    assert!(canvas.pixels.iter().all(|pixel| pixel.0 == 0));
    // As many as may be, and all cut nothing.
    assert_eq!(faces(&cube.with_planes(&planes[1..]), &scene, VIEW), faces(&cube, &scene, VIEW));
    // Six that do: the corners of an octahedron's faces are left.
    let tight =
        [[1.0, 1.0, 1.0], [-1.0, 1.0, 1.0], [1.0, -1.0, 1.0], [1.0, 1.0, -1.0], [-1.0, -1.0, 1.0], [1.0, -1.0, -1.0]];
    let tight = tight.map(|normal| cut(&scene, normal, 0.9));
    let kept = faces(&cube.with_planes(&tight), &scene, VIEW).pixels.iter().filter(|pixel| pixel.0 > 0).count();
    let all = faces(&cube, &scene, VIEW).pixels.iter().filter(|pixel| pixel.0 > 0).count();
    assert!(0 < kept && kept < all, "{kept} of {all}");
}
