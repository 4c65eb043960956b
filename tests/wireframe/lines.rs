//! Which pixels, in floating point.

use super::*;
use aquatint::{
    fragment::shade::{Plain, Stippled},
    geometry::face::Faces,
};
use proptest::prelude::*;

const VIEW: Rect = Rect::new(0, 0, 64, 48);

/// The edges of the squares that face the eye, each once.
pub fn front_edges(corners: &[[f64; 3]]) -> Vec<[usize; 2]> {
    let Assembly::Polygons { indices, .. } = SQUARES.assembly() else { unreachable!() };
    let mut edges = vec![];
    for square in indices.chunks(4) {
        let [a, b, c] = [0, 1, 2].map(|i| corners[usize::from(square[i])]);
        // y runs down.
        if (b[0] - a[0]) * (c[1] - a[1]) - (c[0] - a[0]) * (b[1] - a[1]) < 0.0 {
            for side in 0..4 {
                let [p, q] = [side, (side + 1) % 4].map(|i| usize::from(square[i]));
                edges.push([p.min(q), p.max(q)]);
            }
        }
    }
    edges.sort_unstable();
    edges.dedup();
    edges
}

/// Whether rounding may turn a square of the cube the other way.
pub fn is_edge_on(corners: &[[f64; 3]]) -> bool {
    let Assembly::Polygons { indices, .. } = SQUARES.assembly() else { unreachable!() };
    indices.chunks(4).any(|square| {
        let [a, b, c] = [0, 1, 2].map(|i| corners[usize::from(square[i])]);
        ((b[0] - a[0]) * (c[1] - a[1]) - (c[0] - a[0]) * (b[1] - a[1])).abs() < 20.0
    })
}

/// Whether rounding may change the driving axis of a line.
pub fn is_diagonal([a, b]: [[f64; 3]; 2]) -> bool {
    ((b[1] - a[1]).abs() - (b[0] - a[0]).abs()).abs() < 0.3
}

/// How far a pixel's centre is from a line, across its driving axis; none beyond its ends.
pub fn aside([a, b]: [[f64; 3]; 2], (x, y): (i32, i32)) -> Option<f64> {
    let [x, y] = [x, y].map(|v| f64::from(v) + 0.5);
    let steep = (b[1] - a[1]).abs() > (b[0] - a[0]).abs();
    let axes = |x: f64, y: f64| if steep { (y, x) } else { (x, y) };
    let ((a, p), (b, q), (at, across)) = (axes(a[0], a[1]), axes(b[0], b[1]), axes(x, y));
    // An end's pixel may begin half a pixel before it.
    let (low, high) = (a.min(b), a.max(b));
    if at < low - 0.57 || at > high + 0.57 {
        return None;
    }
    let way = if high - low < 1e-9 { 0.0 } else { (at.clamp(low, high) - a) / (b - a) };
    Some((across - p - (q - p) * way).abs())
}

/// How far a pixel is along the driving axis of a line, from 0 to 1, and how long that is.
pub fn along([a, b]: [[f64; 3]; 2], (x, y): (i32, i32)) -> (f64, f64) {
    let steep = (b[1] - a[1]).abs() > (b[0] - a[0]).abs();
    let (from, to, at) = if steep { (a[1], b[1], y) } else { (a[0], b[0], x) };
    (((f64::from(at) + 0.5 - from) / (to - from)).clamp(0.0, 1.0), (to - from).abs())
}

/// The pixels that an edge must have, where rounding cannot move it to another.
fn certain([a, b]: [[f64; 3]; 2]) -> Vec<(i32, i32)> {
    let steep = (b[1] - a[1]).abs() > (b[0] - a[0]).abs();
    let axes = |p: [f64; 3]| if steep { (p[1], p[0]) } else { (p[0], p[1]) };
    let (a, b) = (axes(a), axes(b));
    let (first, last) = if a.0 < b.0 { (a, b) } else { (b, a) };
    #[expect(clippy::cast_possible_truncation, reason = "on the screen")]
    let pixel = |v: f64| v.floor() as i32;
    let mut pixels = vec![];
    for step in pixel(first.0) + 1..pixel(last.0) {
        let way = (f64::from(step) + 0.5 - first.0) / (last.0 - first.0);
        let across = first.1 + (last.1 - first.1) * way;
        if (0.1..0.9).contains(&(across - across.floor())) {
            pixels.push(if steep { (pixel(across), step) } else { (step, pixel(across)) });
        }
    }
    pixels
}

fn solid() -> Instance<'static, Plain<()>> {
    Instance::new(SQUARES, Matrix::IDENTITY).with_material(Material::new(Plain(())))
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(400))]
    #[test]
    fn a_hidden_line_cube_shows_the_edges_of_its_front_faces(y in 0..360_i32, x in 0..360_i32) {
        let scene = scene(VIEW);
        let cube = Instance { placement: pose(y, x), ..solid() };
        let corners = projected(&cube, &scene);
        let lines: Vec<_> = front_edges(&corners).iter().map(|edge| edge.map(|i| corners[i])).collect();
        for canvas in [hidden_lines(&cube, &scene, VIEW), edges(&cube, &scene, VIEW)] {
            for at in canvas.places().filter(|&(x, y)| canvas.at(x, y).is_some()) {
                let nearest = lines.iter().filter_map(|&line| aside(line, at)).fold(9.0, f64::min);
                prop_assert!(nearest <= 0.5 + 0.14, "{:?} is {} beside all edges", at, nearest);
            }
            for (x, y) in lines.iter().flat_map(|&line| certain(line)) {
                prop_assert!(canvas.at(x, y).is_some(), "{}, {} of an edge is missing", x, y);
            }
        }
    }

    #[test]
    fn bands_have_the_lines_of_the_whole(y in 0..360_i32, x in 0..360_i32, near in 0..30_i32, height in 1..20_i32) {
        let mut scene = scene(VIEW);
        // Up to through the near plane.
        scene.camera.view = Matrix::translation(number(0.2), number(0.1), number(f64::from(near) / 10.0 - 3.0));
        let cube = Instance::new(SQUARES, pose(y, x));
        let whole = hidden_lines(&cube, &scene, VIEW);
        let mut top = 0;
        while top < VIEW.bottom {
            let band = Rect::new(0, top, VIEW.right, (top + height).min(VIEW.bottom));
            let part = hidden_lines(&cube, &scene, band);
            for (x, y) in part.places() {
                prop_assert_eq!(part.at(x, y), whole.at(x, y), "{}, {}", x, y);
            }
            top = band.bottom;
        }
    }

    #[test]
    fn light_is_linear_between_the_ends(y in 0..90_i32, x in 0..90_i32, a in any::<u16>(), b in any::<u16>()) {
        let scene = scene(VIEW);
        let positions = [[-9000, 0, 9000], [9000, 2000, -9000], [9000, -2000, -9000]];
        // Two ends of one line, whose third corner is the second's neighbour.
        let lights = [Light(a), Light(b), Light(b)];
        let mesh = Mesh::new(&positions, &[[0, 0, 127]; 3], &[[0, 1, 2]]).and_then(|mesh| mesh.with_lights(&lights));
        let mut line = Instance::new(mesh.expect("fits"), pose(y - 45, x - 45));
        line.material.faces = Faces::Both;
        let mut full = scene;
        full.light.ambient = Light::WHITE;
        let corners = projected(&line, &full);
        prop_assume!(![[0, 1], [1, 2], [2, 0]].iter().any(|edge| is_diagonal(edge.map(|i| corners[i]))));
        let canvas = edges(&line, &full, VIEW);
        for at in canvas.places() {
            let Some(Light(light)) = canvas.at(at.0, at.1) else { continue };
            let excess = |[p, q]: [usize; 2]| {
                let (line, [from, to]) = ([corners[p], corners[q]], [p, q].map(|i| f64::from(lights[i].0)));
                aside(line, at).filter(|&aside| aside <= 0.64)?;
                let (way, length) = along(line, at);
                // Less than half a pixel for rounded ends, and a unit each for reflecting twice and for the sum.
                let allowed = (to - from).abs() / (2.5 * length.max(0.5)) + 4.0;
                Some((f64::from(light) - from - (to - from) * way).abs() - allowed)
            };
            let error = [[0, 1], [1, 2], [2, 0]].into_iter().filter_map(excess).fold(f64::MAX, f64::min);
            prop_assert!(error <= 0.0, "{:?}: {} too far off", at, error);
        }
    }
}

#[test]
fn two_faces_draw_their_edge_once_if_depths_are_remembered() {
    // Two triangles and the diagonal between them.
    let positions = [[-9000, -9000, 0], [9000, -9000, 0], [9000, 9000, 0], [-9000, 9000, 0]];
    let mesh = Mesh::new(&positions, &[[0, 0, 127]; 4], &[[0, 1, 2], [0, 2, 3]]).expect("fits");
    let square = Instance { mesh, placement: turned(20.0, 30.0), ..solid() };
    let scene = scene(VIEW);
    let corners = projected(&square, &scene);
    let diagonal = certain([corners[0], corners[2]]);
    // Away from the corners, where the sides meet it.
    let middle = &diagonal[4..diagonal.len() - 4];
    assert!(middle.len() > 8);
    let counts = |canvas: &Canvas<()>| middle.iter().map(|&(x, y)| canvas.count(x, y)).collect::<Vec<_>>();
    assert_eq!(counts(&edges(&square, &scene, VIEW)), vec![2; middle.len()], "nothing remembers them");
    assert_eq!(counts(&hidden_lines(&square, &scene, VIEW)), vec![1; middle.len()]);
}

#[test]
fn a_bias_brings_lines_to_the_front_or_pushes_them_back() {
    let scene = scene(VIEW);
    let cube = Instance { placement: turned(20.0, 30.0), ..solid() };
    let on = |bias| {
        let mut canvas = Canvas::new(VIEW);
        let mut memory = vec![0_u16; canvas.pixels.len()];
        let mut depth = DepthBuffer::new(&mut memory, VIEW).expect("enough");
        let lines = Instance { material: Material { bias, ..cube.material }, ..cube };
        with_workspace(&mut depth, |workspace| {
            draw_mesh(&cube, &scene, workspace, &mut Unpainted::new()).expect("drawn");
            draw_wireframe(&lines, &scene, workspace, &mut canvas).expect("drawn");
        });
        canvas.pixels.iter().filter(|pixel| pixel.0 > 0).count()
    };
    let all = edges(&cube, &scene, VIEW).pixels.iter().filter(|pixel| pixel.0 > 0).count();
    assert_eq!(on(DepthBias { constant: 3000, slope: 1 }), all);
    // What lies outside of the faces is seen even so.
    assert!(on(DepthBias { constant: -3000, slope: -1 }) < all / 2);
    assert!(on(DepthBias::NONE) < all);
}

#[test]
fn what_is_not_painted_hides_all_the_same() {
    let scene = scene(VIEW);
    let cube = Instance { placement: turned(20.0, 30.0), ..solid() };
    let depths = |draw: &dyn Fn(&mut Workspace<'_, DepthBuffer<'_>>)| {
        let mut memory = vec![0_u16; 64 * 48];
        let mut depth = DepthBuffer::new(&mut memory, VIEW).expect("enough");
        with_workspace(&mut depth, |workspace| draw(workspace));
        memory
    };
    let painted = depths(&|workspace| {
        draw_mesh(&cube, &scene, workspace, &mut Canvas::new(VIEW)).expect("drawn");
    });
    assert!(painted.iter().filter(|&&depth| depth > 0).count() > 500);
    let unpainted = depths(&|workspace| {
        draw_mesh(&cube, &scene, workspace, &mut Unpainted::new()).expect("drawn");
    });
    assert_eq!(unpainted, painted);
    // Pixels that are left out hide nothing, here either.
    let stippled = cube.with_material(Material::new(Stippled::new(Plain(()), [0xAA, 0x55])));
    let half = depths(&|workspace| {
        draw_mesh(&stippled, &scene, workspace, &mut Unpainted::new()).expect("drawn");
    });
    for (at, (half, painted)) in (0..).zip(half.iter().zip(&painted)) {
        assert_eq!(*half, if (at / 64 + at % 64) % 2 == 0 { *painted } else { 0 }, "{at}");
    }
}
