//! Grids of triangles that share their edges: each pixel once, with no crack.

use crate::{
    Random,
    probes::{one_by_one, scaled},
    renderer::{Renderer, Scene, VIEW, place},
};

/// Quads of a grid, across and down: 192 triangles.
const QUADS: [u16; 2] = [12, 8];

/// Pixels at the borders that are not looked at: the grid is larger than the view, but not by much.
const MARGIN: usize = 4;

/// A grid before the camera, its inner vertices off by up to a quarter of a quad, at depths of 1 to 3.
fn grid(random: &mut Random) -> Scene {
    let [across, down] = QUADS;
    let mut within = |least: f64, most: f64| least + f64::from(random.below(1 << 16)) / 65_536.0 * (most - least);
    let mut positions = vec![];
    for (row, column) in (0..=down).flat_map(|row| (0..=across).map(move |column| (row, column))) {
        let is_inner = (1..down).contains(&row) && (1..across).contains(&column);
        let [x, y] = if is_inner { [within(-0.25, 0.25), within(-0.25, 0.25)] } else { [0.0; 2] };
        let along = |at: u16, off: f64, of: u16| 1.1 * (2.0 * (f64::from(at) + off) / f64::from(of) - 1.0);
        let depth = within(1.0, 3.0);
        // The view is as high as it is far away, and twice as wide.
        let place_in_world = [along(column, x, across) * depth, -along(row, y, down) * depth / 2.0, -depth];
        positions.push(place(place_in_world.map(|v| v / 2.0)));
    }
    let quads = (0..down).flat_map(|row| (0..across).map(move |column| row * (across + 1) + column));
    let triangles = quads.flat_map(|a| {
        let (b, c, d) = (a + across + 1, a + across + 2, a + 1);
        [[a, b, c], [a, c, d]]
    });
    Scene::new(&positions, &triangles.collect::<Vec<_>>(), scaled(2.0), VIEW)
}

pub fn are_drawn_once<R: Renderer>() {
    let mut random = Random(20);
    let mut times = [0; 3];
    for _ in 0..20 {
        let scene = grid(&mut random);
        assert_eq!(scene.triangles.len(), 192);
        let picture = one_by_one::<R>(&scene);
        let rows = picture.lights.writes.chunks(128).skip(MARGIN).take(64 - 2 * MARGIN);
        for count in rows.flat_map(|row| &row[MARGIN..128 - MARGIN]) {
            times[usize::try_from(*count).expect("small").min(2)] += 1;
        }
    }
    assert_eq!(times, [0, 134_400, 0], "cracks, once, more often");
}
