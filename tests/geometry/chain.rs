//! From a mesh place to the screen, all roundings of all matrices together, against floating point.

use aquatint::{
    Angle, Matrix, Model, Point3, Rect, Vector3, View, World,
    geometry::{projection::Lens, transform::MeshTransform, viewport::Viewport},
};

use crate::number;

/// A random number from 0 to 1, the same in each run.
struct Random(u64);

impl Random {
    fn unit(&mut self) -> f64 {
        self.0 = self.0.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
        f64::from(u32::try_from(self.0 >> 33).expect("31 bits")) / f64::from(1_u32 << 31)
    }

    fn between(&mut self, low: f64, high: f64) -> f64 {
        low + (high - low) * self.unit()
    }
}

type Rows = [[f64; 4]; 4];

fn floats<From, To>(matrix: &Matrix<From, To>) -> Rows {
    matrix.rows().map(|row| row.map(|v| v.to_num()))
}

fn transformed(rows: &Rows, point: [f64; 4]) -> [f64; 4] {
    rows.map(|row| row.iter().zip(point).map(|(a, b)| a * b).sum())
}

/// What is exact here: the matrices as they are, in 16.16, multiplied without rounding.
fn exact_on_screen(chain: &[Rows], place: [i16; 3], view: Rect) -> Option<[f64; 3]> {
    let [x, y, z] = place.map(|v| f64::from(v) / 16_384.0);
    let [x, y, z, w] = chain.iter().fold([x, y, z, 1.0], |point, rows| transformed(rows, point));
    let visible = w >= 0.125 && z.abs() <= w && x.abs() <= 4.0 * w && y.abs() <= 4.0 * w;
    let along =
        |v: f64, near: i32, far: i32| f64::midpoint(near.into(), far.into()) + v / w * f64::from(far - near) / 2.0;
    visible.then(|| [along(x, view.left, view.right), along(-y, view.top, view.bottom), (w - z) / (2.0 * w)])
}

/// The largest errors on a view of 400 × 240: in sixteenths of a pixel and in units of 65535.
fn worst(near: f64, random: &mut Random) -> (f64, f64) {
    let view = Rect::new(0, 0, 400, 240);
    let viewport = Viewport::new(view).expect("a viewport");
    let (mut place_error, mut depth_error, mut seen) = (0.0_f64, 0.0_f64, 0);
    while seen < 20_000 {
        let [around, down] =
            [0; 2].map(|_| Angle(number(random.unit()).to_bits().to_le_bytes().map(u16::from)[0] * 257));
        let turn = Matrix::<Model, Model>::rotation_y(around).then(&Matrix::rotation_x(down));
        let [x, y, z] = [0; 3].map(|_| number(random.between(-3.0, 3.0)));
        let scale = Matrix::<Model, Model>::scale(number(random.between(0.2, 3.0)));
        let placement: Matrix<Model, World> = turn.then(&scale).then(&Matrix::translation(x, y, z));
        let eye = Point3::new(x, y.saturating_add(number(0.5)), z.saturating_add(number(random.between(near, 6.0))));
        let up = Vector3::new(number(0.0), number(1.0), number(0.0));
        let Some(camera) = Matrix::<World, View>::look_at(eye, Point3::new(x, y, z), up) else { continue };
        let lens = Lens {
            field_of_view: Angle::from_degrees(60.0),
            aspect: number(5.0 / 3.0),
            near: number(near),
            far: number(64.0),
        };
        let projection = Matrix::perspective(lens).expect("a lens");
        let transform = MeshTransform::new(&placement.then(&camera).then(&projection)).expect("in range");
        let chain = [floats(&placement), floats(&camera), floats(&projection)];
        for _ in 0..40 {
            let place =
                [0; 3].map(|_| number(random.between(-0.5, 0.5)).to_bits()).map(|v| i16::try_from(v).unwrap_or(0));
            let Some([x, y, depth]) = exact_on_screen(&chain, place, view) else { continue };
            let got = viewport.project(&transform.apply(place));
            for (got, exact) in [(got.position.x, x), (got.position.y, y)] {
                place_error = place_error.max((got.to_num::<f64>() - exact).abs() * 16.0);
            }
            depth_error = depth_error.max((f64::from(got.depth) / 256.0 - depth * 65_536.0).abs());
            seen += 1;
        }
    }
    (place_error, depth_error)
}

/// The bounds told in `geometry/mod.rs`; half a sixteenth of each is the rounding to sixteenths.
#[test]
fn the_errors_of_the_whole_chain_are_as_told() {
    let mut random = Random(1);
    for (near, place, depth) in [(0.125, 1.75, 14.0), (0.5, 0.875, 4.0), (1.0, 0.75, 2.0)] {
        let (place_error, depth_error) = worst(near, &mut random);
        println!("near {near}: {place_error} sixteenths, {depth_error} of 65536");
        assert!(place_error <= place && depth_error <= depth, "near {near}: {place_error}, {depth_error}");
        assert!(place_error > 0.5, "the test sees more than the last rounding");
    }
}
