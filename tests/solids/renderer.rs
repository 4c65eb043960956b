//! What is under test: fill modes behind one face, so that all probes run for each.

use core::{convert::Infallible, ops::Range};

use aquatint::{
    Angle, Clip, Light, Matrix, Model, Rect, Scalar, Target, Vector3, View, World,
    geometry::{light::Lamp, viewport::Viewport},
    hidden::depth::DepthBuffer,
    model::mesh::Mesh,
    pipeline::{Camera, DrawError, Instance, MeshVertex, Workspace, draw_mesh},
};

use super::reference::{self, Corner, Reference, Seen, Solid};

/// A fill mode.
pub trait Renderer {
    /// Draws scenes into one depth buffer, empty before.
    fn draw(scenes: &[Scene], picture: &mut Picture) -> Result<(), DrawError<Infallible>>;

    /// The least and the most light that a pixel may have, not counting that corners are rounded, and how light changes
    /// from pixel to pixel.
    fn light(seen: &Seen) -> ([f64; 2], f64);
}

/// Light at the vertices, linear on the screen between them.
pub enum Gouraud {}

impl Renderer for Gouraud {
    fn draw(scenes: &[Scene], picture: &mut Picture) -> Result<(), DrawError<Infallible>> {
        let mut depth = DepthBuffer::new(&mut picture.depths, picture.lights.window).expect("large enough");
        for scene in scenes {
            let mesh = Mesh::new(&scene.positions, &scene.normals, &scene.triangles).expect("indices are right");
            let mut vertices = vec![MeshVertex::EMPTY; scene.positions.len()];
            let mut workspace = Workspace { vertices: &mut vertices, depth: &mut depth };
            draw_mesh(
                &Instance { mesh, placement: scene.placement },
                &scene.camera,
                &mut workspace,
                &mut picture.lights,
            )?;
        }
        Ok(())
    }

    fn light(seen: &Seen) -> ([f64; 2], f64) {
        (seen.light, seen.slopes[1])
    }
}

/// A mesh, where it is, and who looks at it: in the numbers that both the renderers and the reference get.
#[derive(Clone, Debug)]
pub struct Scene {
    pub positions: Vec<[i16; 3]>,
    pub normals: Vec<[i8; 3]>,
    /// Places of the texture, 0 to 1.
    pub uvs: Vec<[f64; 2]>,
    pub triangles: Vec<[u16; 3]>,
    pub placement: Matrix<Model, World>,
    pub camera: Camera,
}

impl Scene {
    /// Triangles that all face the viewer alike, so that their light says nothing.
    pub fn new(positions: &[[i16; 3]], triangles: &[[u16; 3]], placement: Matrix<Model, World>, view: Rect) -> Self {
        Self {
            positions: positions.to_vec(),
            normals: vec![[0, 0, 127]; positions.len()],
            uvs: vec![[0.0; 2]; positions.len()],
            triangles: triangles.to_vec(),
            placement,
            camera: camera(view),
        }
    }

    /// One of its triangles alone.
    pub fn only(&self, triangle: usize) -> Self {
        Self { triangles: vec![self.triangles[triangle]], ..self.clone() }
    }

    fn solid(&self) -> Solid {
        let to_view = product(rows(&self.camera.view), rows(&self.placement));
        let to_clip = product(rows(&self.camera.projection), to_view);
        let corner = |((&position, &normal), &uv): ((&[i16; 3], &[i8; 3]), &[f64; 2])| {
            let [x, y, z] = position.map(|v| f64::from(v) / 16_384.0);
            let clip = to_clip.map(|[a, b, c, d]| a * x + b * y + c * z + d);
            Corner { clip, light: self.lambert(normal), uv }
        };
        let corners = self.positions.iter().zip(&self.normals).zip(&self.uvs).map(corner).collect();
        Solid { corners, triangles: self.triangles.iter().map(|triangle| triangle.map(usize::from)).collect() }
    }

    /// Ambient light and diffuse, 0 to 65535.
    fn lambert(&self, normal: [i8; 3]) -> f64 {
        let lamp = &self.camera.lamp;
        let direction = [lamp.direction.x, lamp.direction.y, lamp.direction.z].map(|v| v.to_num::<f64>());
        let [x, y, z] = normal.map(f64::from);
        let turned = rows(&self.placement).map(|[a, b, c, _]| a * x + b * y + c * z);
        let dot: f64 = turned.iter().zip(direction).map(|(a, b)| a * b).sum();
        let length = |vector: &[f64]| vector.iter().map(|v| v * v).sum::<f64>().sqrt();
        // A normal is as long as it was rounded to; the matrix may scale.
        let scale = length(&turned[..3]) / length(&[x, y, z]).max(1.0);
        let cosine = dot / (127.0 * scale.max(1e-9) * length(&direction).max(1e-9));
        (f64::from(lamp.ambient.0) + f64::from(lamp.diffuse.0) * cosine.clamp(0.0, 1.0)).min(65_535.0)
    }
}

/// What scenes look like, which share a camera.
pub fn seen(scenes: &[Scene]) -> Reference {
    let view = scenes[0].camera.viewport.rect();
    let view = reference::View { width: view.width() as usize, height: view.height() as usize };
    Reference::new(view, &scenes.iter().map(Scene::solid).collect::<Vec<_>>())
}

fn rows<A, B>(matrix: &Matrix<A, B>) -> [[f64; 4]; 4] {
    matrix.rows().map(|row| row.map(|v| v.to_num()))
}

fn product(a: [[f64; 4]; 4], b: [[f64; 4]; 4]) -> [[f64; 4]; 4] {
    a.map(|row| [0, 1, 2, 3].map(|column| (0..4).map(|at| row[at] * b[at][column]).sum()))
}

/// To the nearest.
pub fn number(value: f64) -> Scalar {
    Scalar::saturating_from_num(value)
}

/// A place of a mesh.
#[expect(clippy::cast_possible_truncation, reason = "a float-to-int cast saturates")]
pub fn place(place: [f64; 3]) -> [i16; 3] {
    place.map(|v| (v * 16_384.0).round() as i16)
}

/// Small panels of one bit.
pub const VIEW: Rect = Rect::new(0, 0, 128, 64);

/// At the origin, looking down −z, near 0.4, far 20; the view is as high as it is far away.
pub fn camera(view: Rect) -> Camera {
    let (near, far) = (0.4, 20.0);
    let across = 2.0 * f64::from(view.height()) / f64::from(view.width());
    let rows = [
        [across, 0.0, 0.0, 0.0],
        [0.0, 2.0, 0.0, 0.0],
        [0.0, 0.0, -(far + near) / (far - near), -2.0 * far * near / (far - near)],
        [0.0, 0.0, -1.0, 0.0],
    ];
    Camera {
        view: Matrix::<World, View>::IDENTITY,
        projection: Matrix::<View, Clip>::from_rows(rows.map(|row| row.map(number))),
        viewport: Viewport::new(view).expect("a viewport"),
        lamp: Lamp {
            direction: Vector3::new(number(0.4), number(0.6), number(0.69)),
            ambient: Light(6_554),
            diffuse: Light(58_981),
        },
    }
}

/// Turned about x, then about y, then moved.
pub fn pose([about_x, about_y]: [u16; 2], at: [f64; 3]) -> Matrix<Model, World> {
    let [x, y, z] = at.map(number);
    Matrix::<Model, World>::rotation_x(Angle(about_x))
        .then(&Matrix::<World, World>::rotation_y(Angle(about_y)))
        .then(&Matrix::<World, World>::translation(x, y, z))
}

/// What was drawn.
#[derive(Clone, Debug)]
pub struct Picture {
    pub lights: Lights,
    pub depths: Vec<u16>,
}

/// The light of each pixel, and how often it was written.
#[derive(Clone, Debug)]
pub struct Lights {
    pub window: Rect,
    pub shown: Vec<Option<Light>>,
    pub writes: Vec<u32>,
}

impl Picture {
    pub fn new(window: Rect) -> Self {
        let pixels = window.width() as usize * window.height() as usize;
        let lights = Lights { window, shown: vec![None; pixels], writes: vec![0; pixels] };
        Self { lights, depths: vec![0; pixels] }
    }

    /// 0 to 1.
    pub fn depth(&self, at: usize) -> f64 {
        f64::from(self.depths[at]) / 65_535.0
    }

    /// `.` not drawn, `#` drawn once, a digit when more often.
    pub fn picture(&self) -> String {
        let sign = |&count: &u32| match count {
            0 => '.',
            1 => '#',
            more => char::from_digit(more.min(9), 10).expect("a digit"),
        };
        let rows = self.lights.writes.chunks(self.lights.window.width() as usize);
        rows.map(|row| row.iter().map(sign).collect::<String>() + "\n").collect()
    }

    pub fn drawn(&self) -> usize {
        self.lights.writes.iter().filter(|count| **count > 0).count()
    }
}

impl Lights {
    fn start(&self, row: i32, columns: &Range<i32>) -> usize {
        assert!(self.window.clip_run(row, columns.clone()) == Some(columns.clone()), "outside");
        let index = |v: i32| usize::try_from(v).expect("inside");
        index(row - self.window.top) * self.window.width() as usize + index(columns.start - self.window.left)
    }
}

impl Target for Lights {
    type Color = Light;
    type Error = Infallible;

    fn bounds(&self) -> Rect {
        self.window
    }

    fn fill_run<const N: usize>(
        &mut self,
        row: i32,
        columns: Range<i32>,
        lights: [Light; N],
    ) -> Result<(), Infallible> {
        self.write_run(row, columns, core::iter::repeat(Some(lights[0])))
    }

    fn write_run(
        &mut self,
        row: i32,
        columns: Range<i32>,
        lights: impl Iterator<Item = Option<Light>>,
    ) -> Result<(), Infallible> {
        let start = self.start(row, &columns);
        for (at, light) in (start..).take(columns.len()).zip(lights) {
            self.writes[at] += u32::from(light.is_some());
            self.shown[at] = light.or(self.shown[at]);
        }
        Ok(())
    }
}
