//! What the scenes are made of: flat shapes before a screen of 16 × 8 pixels, without perspective.

use core::{convert::Infallible, ops::Range};

use aquatint::{
    Clip, Light, Matrix, Model, Rect, Scalar, Target, Vector3, View, World,
    fragment::shade::Shading,
    geometry::{light::Lamp, viewport::Viewport},
    hidden::Hidden,
    model::mesh::Mesh,
    pipeline::{Camera, DrawError, Instance, Material, MeshVertex, Scene, Workspace, draw_mesh},
};
use embedded_graphics::{geometry::Point, image::GetPixel};

pub const VIEW: Rect = Rect::new(0, 0, 16, 8);

/// To the nearest.
pub fn number(value: f64) -> Scalar {
    Scalar::saturating_from_num(value)
}

/// A place of a mesh, 2.14.
#[expect(clippy::cast_possible_truncation, reason = "a float-to-int cast saturates")]
pub fn place(place: [f64; 3]) -> [i16; 3] {
    place.map(|v| (v * 16_384.0).round() as i16)
}

/// A mesh that owns its arrays.
#[derive(Clone, Debug, Default)]
pub struct Shape {
    pub positions: Vec<[i16; 3]>,
    pub normals: Vec<[i8; 3]>,
    pub triangles: Vec<[u16; 3]>,
    pub lights: Vec<Light>,
    pub uv: Vec<[i16; 2]>,
}

impl Shape {
    pub fn mesh(&self) -> Mesh<'_> {
        let mesh = Mesh::new(&self.positions, &self.normals, &self.triangles).expect("indices are right");
        mesh.with_lights(&self.lights).and_then(|mesh| mesh.with_uv(&self.uv)).expect("one each")
    }

    /// The same in one light of its own.
    pub fn in_light(mut self, light: u16) -> Self {
        self.lights.fill(Light(light));
        self
    }
}

/// A rectangle of pixels that faces the viewer, at depths from its left to its right end: −1 is the near plane, 1 the
/// far one. Texture coordinates are one texture across and down.
pub fn panel(pixels: Rect, [left, right]: [f64; 2]) -> Shape {
    let corner = |x: i32, y: i32, z: f64| place([f64::from(x) / 8.0 - 1.0, 1.0 - f64::from(y) / 4.0, z]);
    let Rect { left: x, top: y, right: to_x, bottom: to_y } = pixels;
    Shape {
        positions: vec![corner(x, to_y, left), corner(to_x, to_y, right), corner(to_x, y, right), corner(x, y, left)],
        normals: vec![[0, 0, -127]; 4],
        triangles: vec![[0, 1, 2], [0, 2, 3]],
        lights: vec![Light::WHITE; 4],
        uv: vec![[0, 4095], [4095, 4095], [4095, 0], [0, 0]],
    }
}

/// No perspective: places of the mesh are places of the view. A lamp at the viewer's.
pub fn scene(view: Rect) -> Scene {
    let [one, nil] = [1.0, 0.0].map(number);
    let rows = [[one, nil, nil, nil], [nil, one, nil, nil], [nil, nil, one, nil], [nil, nil, nil, one]];
    let camera = Camera {
        view: Matrix::<World, View>::IDENTITY,
        projection: Matrix::<View, Clip>::from_rows(rows),
        viewport: Viewport::new(view).expect("a viewport"),
    };
    let direction = Vector3::new(nil, nil, -one);
    Scene { camera, light: Lamp { direction, ambient: Light(0), diffuse: Light::WHITE } }
}

/// Draws a shape on the small screen.
pub fn draw<S: Shading, H: Hidden, T: Target<Color = S::Color>>(
    shape: &Shape,
    material: Material<S>,
    hidden: &mut H,
    target: &mut T,
) -> Result<(), DrawError<T::Error>> {
    draw_in(&scene(VIEW), &shape.mesh(), material, (hidden, target))
}

pub fn draw_in<S: Shading, H: Hidden, T: Target<Color = S::Color>, L: aquatint::geometry::light::Lighting>(
    scene: &Scene<L>,
    mesh: &Mesh<'_>,
    material: Material<S>,
    (hidden, target): (&mut H, &mut T),
) -> Result<(), DrawError<T::Error>> {
    let mut vertices = vec![MeshVertex::EMPTY; mesh.positions().len()];
    let instance = Instance::new(*mesh, Matrix::<Model, World>::IDENTITY).with_material(material);
    draw_mesh(&instance, scene, &mut Workspace { vertices: &mut vertices, hidden }, target)
}

/// Remembers the colour of each pixel.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Canvas<C = Light> {
    pub bounds: Rect,
    pub colors: Vec<Option<C>>,
}

impl<C: Copy> Canvas<C> {
    pub fn new(bounds: Rect) -> Self {
        Self { bounds, colors: vec![None; bounds.width() as usize * bounds.height() as usize] }
    }

    pub fn at(&self, x: i32, y: i32) -> Option<C> {
        let index = |v: i32| usize::try_from(v).expect("inside");
        self.colors[index(y - self.bounds.top) * self.bounds.width() as usize + index(x - self.bounds.left)]
    }
}

impl Canvas {
    pub fn filled(bounds: Rect, light: u16) -> Self {
        let mut canvas = Self::new(bounds);
        canvas.colors.fill(Some(Light(light)));
        canvas
    }

    /// `.` not drawn, else the upper four bits of the light, which may be a hair too dark: the cosine is below 1.
    pub fn picture(&self) -> String {
        let sign = |light: &Option<Light>| {
            light.map_or('.', |light| {
                char::from_digit(u32::from(light.0.saturating_add(0x40) >> 12), 16).expect("a digit")
            })
        };
        let rows = self.colors.chunks(self.bounds.width() as usize);
        rows.map(|row| row.iter().map(sign).collect::<String>() + "\n").collect()
    }
}

impl<C: Copy> Target for Canvas<C> {
    type Color = C;
    type Error = Infallible;

    fn bounds(&self) -> Rect {
        self.bounds
    }

    fn fill_run<const N: usize>(&mut self, row: i32, columns: Range<i32>, colors: [C; N]) -> Result<(), Infallible> {
        let Some(columns) = self.bounds.clip_run(row, columns) else { return Ok(()) };
        let n = i32::try_from(N).expect("few");
        let colors =
            columns.clone().map(|column| Some(colors[usize::try_from(column.rem_euclid(n)).expect("positive")]));
        self.write_run(row, columns, colors)
    }

    fn write_run(
        &mut self,
        row: i32,
        columns: Range<i32>,
        colors: impl Iterator<Item = Option<C>>,
    ) -> Result<(), Infallible> {
        let Some(visible) = self.bounds.clip_run(row, columns.clone()) else { return Ok(()) };
        let index = |v: i32| usize::try_from(v).expect("inside");
        let start =
            index(row - self.bounds.top) * self.bounds.width() as usize + index(visible.start - self.bounds.left);
        let colors = colors.skip(index(visible.start - columns.start)).take(visible.len());
        for (place, color) in self.colors[start..].iter_mut().zip(colors) {
            *place = color.or(*place);
        }
        Ok(())
    }
}

impl GetPixel for Canvas {
    type Color = Light;

    fn pixel(&self, point: Point) -> Option<Light> {
        self.bounds.contains(point).then(|| self.at(point.x, point.y)).flatten()
    }
}

/// At the origin, looking down −z, near 0.5, far 20, the view as high as it is far away; a lamp behind the viewer.
pub fn camera_scene(view: Rect) -> Scene {
    let aspect = f64::from(view.width()) / f64::from(view.height());
    let (near, far) = (0.5, 20.0);
    let rows = [
        [2.0 / aspect, 0.0, 0.0, 0.0],
        [0.0, 2.0, 0.0, 0.0],
        [0.0, 0.0, -(far + near) / (far - near), -2.0 * far * near / (far - near)],
        [0.0, 0.0, -1.0, 0.0],
    ];
    let mut scene = scene(view);
    scene.camera.projection = Matrix::<View, Clip>::from_rows(rows.map(|row| row.map(number)));
    scene.light.direction = Vector3::new(number(0.0), number(0.0), number(1.0));
    scene
}

#[expect(clippy::cast_precision_loss, reason = "small numbers")]
pub fn float(value: usize) -> f64 {
    value as f64
}
