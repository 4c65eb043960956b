//! Triangles without area, thinner than a pixel, or with corners on centres: exactly the centres that they cover.

use aquatint::{Clip, Matrix, Model, Point2, Rule, View, World};

use crate::{
    Random, exact,
    renderer::{Picture, Renderer, Scene, VIEW, number},
};

/// Sixteenths of a pixel.
type Corners = [[i32; 2]; 3];

/// A triangle on the screen, its corners exactly there, from both sides: one is seen, if there is any area.
fn on_screen(corners: Corners) -> Scene {
    let place = |[x, y]: [i32; 2]| {
        let short = |v: i32| i16::try_from(v).expect("in range");
        [short(16 * (x - 1024)), short(32 * (512 - y)), 0]
    };
    let mut scene = Scene::new(&corners.map(place), &[[0, 1, 2], [0, 2, 1]], Matrix::<Model, World>::IDENTITY, VIEW);
    // w is 1: places of the mesh are places of the view.
    let [one, nil] = [1.0, 0.0].map(number);
    scene.camera.projection = Matrix::<View, Clip>::from_rows([
        [one, nil, nil, nil],
        [nil, one, nil, nil],
        [nil, nil, one, nil],
        [nil, nil, nil, one],
    ]);
    scene
}

/// Draws, compares with the winding number of each centre, and says how many pixels were drawn.
fn drawn<R: Renderer>(corners: Corners) -> usize {
    let mut picture = Picture::new(VIEW);
    R::draw(&[on_screen(corners)], &mut picture).expect("in range");
    let contour = vec![corners.map(|[x, y]| Point2::from_sixteenths(x, y)).to_vec()];
    for (at, count) in (0..).zip(&picture.lights.writes) {
        let is_inside = exact::is_inside(&contour, Rule::NonZero, (at % 128, at / 128));
        assert_eq!(*count, u32::from(is_inside), "{corners:?}, pixel {}, {}", at % 128, at / 128);
    }
    picture.drawn()
}

pub fn without_area<R: Renderer>() {
    let cases = [
        ("a point", [[808, 408]; 3]),
        ("two corners alike", [[808, 408], [808, 408], [1224, 520]]),
        ("a horizontal line", [[808, 408], [1512, 408], [1000, 408]]),
        ("a vertical line", [[808, 8], [808, 1016], [808, 500]]),
        ("a diagonal line through centres", [[168, 168], [808, 808], [488, 488]]),
    ];
    for (name, corners) in cases {
        assert_eq!(drawn::<R>(corners), 0, "{name}");
    }
}

pub fn slivers<R: Renderer>() {
    // A fifth of a pixel high: centres of columns from 50 to 53.
    assert_eq!(drawn::<R>([[800, 407], [864, 407], [864, 410]]), 3);
    assert_eq!(drawn::<R>([[800, 406], [896, 409], [800, 409]]), 4);
    let (mut random, mut sum) = (Random(8), 0);
    for _ in 0..1500 {
        let mut within = |least: i32, most: i32| least + random.below(most - least);
        let (x, y) = (within(0, 2048), within(0, 1000));
        let (dx, dy) = (within(-900, 900), within(-450, 450));
        let mut off = || [within(-3, 4), within(-3, 4)];
        let [[ax, ay], [bx, by]] = [off(), off()];
        // The third corner is within three sixteenths of the edge between the others, or of one of their ends.
        let along = within(0, 17);
        sum += drawn::<R>([
            [x, y],
            [x + dx, y + dy].map(|v| v.clamp(-1000, 3000)),
            [x + dx * along / 16 + ax + bx, y + dy * along / 16 + ay + by].map(|v| v.clamp(-1000, 3000)),
        ]);
    }
    println!("1500 slivers: {sum} pixels");
    assert!(sum > 1000, "{sum}");
}

/// Corners and edges on centres: the top-left rule decides.
pub fn ties<R: Renderer>() {
    let (mut random, mut sum) = (Random(9), 0);
    for _ in 0..1500 {
        let mut halves = || 8 * random.below(24);
        sum += drawn::<R>([(); 3].map(|()| [400 + halves(), 400 + halves()]));
    }
    println!("1500 triangles on centres: {sum} pixels");
    assert!(sum > 10_000, "{sum}");
}
