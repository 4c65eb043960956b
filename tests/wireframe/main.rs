//! Wireframes: pictures, and lines against edges projected in floating point.

mod fog;
mod hostile;
mod lines;
mod pictures;
mod planes;

use core::{convert::Infallible, ops::Range};

use aquatint::{
    Angle, Light, Matrix, Model, Point3, Rect, Scalar, Target, Vector3, View, World,
    fragment::shade::{LineShading, Shading},
    geometry::{light::Lamp, projection::Lens, viewport::Viewport},
    hidden::{Hidden, convex::Convex, depth::DepthBuffer},
    model::{assembly::Assembly, mesh::Mesh, solids::CUBE},
    pipeline::{
        Bounds, Camera, DepthBias, Instance, Material, MeshVertex, Scene, Unpainted, Workspace, draw_mesh,
        draw_wireframe,
    },
};

/// The cube of six squares, so without diagonals.
const SQUARES: Mesh = match Mesh::with_assembly(
    CUBE.positions(),
    CUBE.normals(),
    Assembly::Polygons {
        counts: &[4; 6],
        indices: &[0, 1, 3, 2, 0, 2, 6, 4, 0, 4, 5, 1, 1, 5, 7, 3, 2, 3, 7, 6, 4, 6, 7, 5],
    },
) {
    Ok(mesh) => mesh,
    Err(_) => panic!(),
};

fn number(value: f64) -> Scalar {
    Scalar::saturating_from_num(value)
}

/// An eye 3 in front of the origin. Near plane at 1, far at 8.
fn scene(view: Rect) -> Scene {
    let aspect = number(f64::from(view.width()) / f64::from(view.height()));
    let lens = Lens { field_of_view: Angle::from_degrees(39.0), aspect, near: number(1.0), far: number(8.0) };
    let camera = Camera {
        view: Matrix::<World, View>::translation(Scalar::ZERO, Scalar::ZERO, number(-3.0)),
        projection: Matrix::perspective(lens).expect("a lens"),
        viewport: Viewport::new(view).expect("a viewport"),
    };
    let light = Lamp {
        direction: Vector3::new(number(-1.0), number(2.0), number(3.0)),
        ambient: Light(9_000),
        diffuse: Light(50_000),
    };
    Scene { camera, light }
}

fn turned(y: f32, x: f32) -> Matrix<Model, World> {
    let turn = |degrees: f32| Angle::from_degrees(degrees);
    Matrix::<Model, Model>::rotation_y(turn(y)).then(&Matrix::rotation_x(turn(x)))
}

/// What each pixel was given, and how often.
#[derive(Clone, PartialEq, Debug)]
struct Canvas<C> {
    bounds: Rect,
    pixels: Vec<(u32, Option<C>)>,
}

impl<C: Copy> Canvas<C> {
    fn new(bounds: Rect) -> Self {
        Self { bounds, pixels: vec![(0, None); bounds.width() as usize * bounds.height() as usize] }
    }

    fn index(&self, x: i32, y: i32) -> usize {
        let index = |v: i32| usize::try_from(v).expect("inside");
        index(y - self.bounds.top) * self.bounds.width() as usize + index(x - self.bounds.left)
    }

    fn at(&self, x: i32, y: i32) -> Option<C> {
        self.pixels[self.index(x, y)].1
    }

    fn count(&self, x: i32, y: i32) -> u32 {
        self.pixels[self.index(x, y)].0
    }

    fn places(&self) -> impl Iterator<Item = (i32, i32)> + use<C> {
        let bounds = self.bounds;
        bounds.rows().flat_map(move |y| bounds.columns().map(move |x| (x, y)))
    }

    fn picture(&self, sign: impl Fn(C) -> char) -> String {
        let rows = self.pixels.chunks(self.bounds.width() as usize);
        rows.map(|row| row.iter().map(|pixel| pixel.1.map_or('.', &sign)).collect::<String>() + "\n").collect()
    }
}

impl<C: Copy> Target for Canvas<C> {
    type Color = C;
    type Error = Infallible;

    fn bounds(&self) -> Rect {
        self.bounds
    }

    fn fill_run<const N: usize>(&mut self, row: i32, columns: Range<i32>, colors: [C; N]) -> Result<(), Infallible> {
        assert_eq!(N, 1);
        self.write_run(row, columns, core::iter::repeat(Some(colors[0])))
    }

    fn write_run(
        &mut self,
        row: i32,
        columns: Range<i32>,
        colors: impl Iterator<Item = Option<C>>,
    ) -> Result<(), Infallible> {
        assert_eq!(self.bounds.clip_run(row, columns.clone()), Some(columns.clone()), "outside");
        for (column, color) in columns.zip(colors) {
            let index = self.index(column, row);
            if color.is_some() {
                self.pixels[index] = (self.pixels[index].0 + 1, color);
            }
        }
        Ok(())
    }
}

/// The same, so far back that its own lines are seen on it.
fn pushed<'a, S: Copy>(instance: &Instance<'a, S>) -> Instance<'a, S> {
    Instance { material: Material { bias: DepthBias::BEHIND_LINES, ..instance.material }, ..*instance }
}

/// The workspace of up to 64 vertices.
fn with_workspace<H: Hidden, R>(hidden: &mut H, draw: impl FnOnce(&mut Workspace<'_, H>) -> R) -> R {
    draw(&mut Workspace { vertices: &mut [MeshVertex::EMPTY; 64], hidden })
}

/// Faces without a depth test.
fn faces<S: Shading, B: Bounds>(instance: &Instance<'_, S, B>, scene: &Scene, bounds: Rect) -> Canvas<S::Color> {
    let mut canvas = Canvas::new(bounds);
    with_workspace(&mut Convex, |workspace| draw_mesh(instance, scene, workspace, &mut canvas)).expect("drawn");
    canvas
}

/// The corners of a mesh on the screen, in pixels, and how far in front of the eye each is.
fn projected<S>(instance: &Instance<'_, S>, scene: &Scene) -> Vec<[f64; 3]> {
    let rows = |matrix: [[Scalar; 4]; 4]| matrix.map(|row| row.map(|v| v.to_num::<f64>()));
    let to_view = instance.placement.then(&scene.camera.view);
    let projection = rows(*scene.camera.projection.rows());
    let view = scene.camera.viewport.rect();
    let place = |position: &[i16; 3]| {
        let [x, y, z] = position.map(|v| Scalar::from_bits(i32::from(v) * 4));
        let p = to_view.transform_point(Point3::new(x, y, z));
        let point = [p.x.to_num::<f64>(), p.y.to_num(), p.z.to_num(), 1.0];
        let [x, y, _, w] = projection.map(|row| row.iter().zip(point).map(|(a, b)| a * b).sum::<f64>());
        let along = |v: f64, from: i32, to: i32| f64::from(from) + f64::midpoint(v / w, 1.0) * f64::from(to - from);
        [along(x, view.left, view.right), along(-y, view.top, view.bottom), w]
    };
    instance.mesh.positions().iter().map(place).collect()
}

/// By degrees, and a bit.
fn pose(y: i32, x: i32) -> Matrix<Model, World> {
    Matrix::<Model, Model>::rotation_y(degrees(y)).then(&Matrix::rotation_x(degrees(x)))
}

fn degrees(v: i32) -> Angle {
    #[expect(clippy::cast_sign_loss, clippy::cast_possible_truncation, reason = "modulo a turn")]
    Angle((v * 182 + 70) as u16)
}

/// Edges without a depth test.
fn edges<S: LineShading>(instance: &Instance<'_, S>, scene: &Scene, bounds: Rect) -> Canvas<S::Color> {
    let mut canvas = Canvas::new(bounds);
    with_workspace(&mut Convex, |workspace| draw_wireframe(instance, scene, workspace, &mut canvas)).expect("drawn");
    canvas
}

/// Edges on faces, both on one canvas.
fn edges_on_faces<S: LineShading, F: Shading<Color = S::Color>>(
    faces: &Instance<'_, F>,
    lines: &Instance<'_, S>,
    scene: &Scene,
    bounds: Rect,
) -> Canvas<S::Color> {
    let mut canvas = Canvas::new(bounds);
    let mut memory = vec![0_u16; canvas.pixels.len()];
    let mut depth = DepthBuffer::new(&mut memory, bounds).expect("enough");
    with_workspace(&mut depth, |workspace| {
        draw_mesh(faces, scene, workspace, &mut canvas).expect("drawn");
        draw_wireframe(lines, scene, workspace, &mut canvas).expect("drawn");
    });
    canvas
}

/// Edges that faces hide, which are not seen themselves.
fn hidden_lines<S: LineShading + Copy>(instance: &Instance<'_, S>, scene: &Scene, bounds: Rect) -> Canvas<S::Color> {
    let mut canvas = Canvas::new(bounds);
    let mut memory = vec![0_u16; canvas.pixels.len()];
    let mut depth = DepthBuffer::new(&mut memory, bounds).expect("enough");
    with_workspace(&mut depth, |workspace| {
        draw_mesh(&pushed(instance), scene, workspace, &mut Unpainted::new()).expect("drawn");
        draw_wireframe(instance, scene, workspace, &mut canvas).expect("drawn");
    });
    canvas
}
