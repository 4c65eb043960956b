//! What is under test: fill modes behind one face, so that all probes run for each.

use core::{convert::Infallible, ops::Range};

use aquatint::{
    Angle, Clip, Light, Matrix, Model, Rect, Scalar, Target, Vector3, View, World,
    fragment::shade::Shading,
    geometry::{light::Lamp, viewport::Viewport},
    hidden::{
        Hidden,
        depth::{Depth, DepthBuffer},
    },
    model::mesh::Mesh,
    pipeline::{self, Camera, DrawError, Instance, Material, MeshVertex, Workspace, draw_mesh},
};

use super::reference::{self, Corner, Reference, Seen, Solid};

/// A fill mode.
pub trait Renderer {
    /// Surfaces of which the depths, 0 to 1, differ by less may be taken for one.
    const RESOLVES: f64 = 2.0 / 65_535.0;
    /// Whether depths are kept at all.
    const HAS_DEPTH: bool = true;

    /// Draws scenes into one depth buffer, empty before.
    fn draw(scenes: &[Scene], picture: &mut Picture) -> Result<(), DrawError<Infallible>>;

    /// The least and the most light that a pixel may have, if that can be said: corners are off by up to `NEAR`.
    fn light(seen: &Seen) -> Option<[f64; 2]>;
}

/// A depth of some bits as a number from 0 to 1.
pub trait Stored: Depth + Ord {
    fn part(self) -> f64;
}

impl Stored for u8 {
    fn part(self) -> f64 {
        f64::from(self) / 256.0
    }
}

impl Stored for u16 {
    fn part(self) -> f64 {
        f64::from(self) / 65_535.0
    }
}

impl Stored for u32 {
    fn part(self) -> f64 {
        f64::from(self) / 2_147_483_648.0
    }
}

/// Draws with a shading and a depth buffer.
pub fn draw_with<D: Stored, S: Shading<Color = Light> + Copy>(
    scenes: &[Scene],
    picture: &mut Picture,
    shading: S,
    with_face_normals: bool,
) -> Result<(), DrawError<Infallible>> {
    let mut depths = vec![D::FARTHEST; picture.lights.shown.len()];
    let mut buffer = DepthBuffer::new(&mut depths, picture.lights.window).expect("large enough");
    let result = draw_hidden(scenes, (picture, &mut buffer), shading, with_face_normals);
    picture.depths = depths.into_iter().map(Stored::part).collect();
    result
}

/// Draws with any way to hide what is behind.
pub fn draw_hidden<H: Hidden, S: Shading<Color = Light> + Copy>(
    scenes: &[Scene],
    (picture, hidden): (&mut Picture, &mut H),
    shading: S,
    with_face_normals: bool,
) -> Result<(), DrawError<Infallible>> {
    for scene in scenes {
        let mut mesh = Mesh::new(&scene.positions, &scene.normals, &scene.triangles).expect("indices are right");
        let uv: Vec<_> = scene.uvs.iter().map(|uv| uv.map(uv_bits)).collect();
        mesh = mesh.with_uv(&uv).expect("one each");
        if with_face_normals {
            mesh = mesh.with_face_normals(&scene.face_normals).expect("one each");
        }
        let mut vertices = vec![MeshVertex::EMPTY; scene.positions.len()];
        let mut workspace = Workspace { vertices: &mut vertices, hidden: &mut *hidden };
        let instance = Instance::new(mesh, scene.placement).with_material(Material::new(shading));
        draw_mesh(&instance, &scene.scene(), &mut workspace, &mut picture.lights)?;
    }
    Ok(())
}

/// A mesh, where it is, and who looks at it: in the numbers that both the renderers and the reference get.
#[derive(Clone, Debug)]
pub struct Scene {
    pub positions: Vec<[i16; 3]>,
    pub normals: Vec<[i8; 3]>,
    /// Places of the texture, 0 to 1.
    pub uvs: Vec<[f64; 2]>,
    pub triangles: Vec<[u16; 3]>,
    /// One for each triangle.
    pub face_normals: Vec<[i8; 3]>,
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
            face_normals: vec![[0, 0, 127]; triangles.len()],
            placement,
            camera: camera(view),
        }
    }

    /// One of its triangles alone.
    pub fn only(&self, triangle: usize) -> Self {
        let (triangles, face_normals) = (vec![self.triangles[triangle]], vec![self.face_normals[triangle]]);
        Self { triangles, face_normals, ..self.clone() }
    }

    /// The same with other normals, of the vertices and of the faces.
    pub fn with_normal(mut self, normal: [i8; 3]) -> Self {
        self.normals.fill(normal);
        self.face_normals.fill(normal);
        self
    }

    fn scene(&self) -> pipeline::Scene {
        pipeline::Scene { camera: self.camera, light: lamp() }
    }

    fn solid(&self) -> Solid {
        let to_view = product(rows(&self.camera.view), rows(&self.placement));
        let to_clip = product(rows(&self.camera.projection), to_view);
        let corner = |((&position, &normal), &uv): ((&[i16; 3], &[i8; 3]), &[f64; 2])| {
            let [x, y, z] = position.map(|v| f64::from(v) / 16_384.0);
            let clip = to_clip.map(|[a, b, c, d]| a * x + b * y + c * z + d);
            let world = self.world(normal);
            let uv = uv.map(|v| f64::from(uv_bits(v)) / 4_096.0);
            Corner { clip, light: lambert(world), normal: world, uv }
        };
        let corners: Vec<_> = self.positions.iter().zip(&self.normals).zip(&self.uvs).map(corner).collect();
        let triangles: Vec<_> = self.triangles.iter().map(|triangle| triangle.map(usize::from)).collect();
        let by_sum = |triangle: &[usize; 3]| {
            let [a, b, c] = triangle.map(|corner| corners[corner].normal);
            lambert(unit([0, 1, 2].map(|axis| a[axis] + b[axis] + c[axis])))
        };
        let by_face = self.face_normals.iter().map(|normal| lambert(self.world(*normal)));
        let flat = by_face.zip(&triangles).map(|(light, triangle)| [light, by_sum(triangle)]).collect();
        Solid { corners, triangles, flat }
    }

    /// A normal in the world, as long as it was rounded to: about 1. The matrix may scale.
    fn world(&self, normal: [i8; 3]) -> [f64; 3] {
        let [x, y, z] = normal.map(f64::from);
        let turned = rows(&self.placement).map(|[a, b, c, _]| a * x + b * y + c * z);
        let scale = length(&turned[..3]) / length(&[x, y, z]).max(1.0);
        [0, 1, 2].map(|axis| turned[axis] / (127.0 * scale.max(1e-9)))
    }
}

pub fn length(vector: &[f64]) -> f64 {
    vector.iter().map(|v| v * v).sum::<f64>().sqrt()
}

pub fn unit(vector: [f64; 3]) -> [f64; 3] {
    let length = length(&vector).max(1e-9);
    vector.map(|v| v / length)
}

/// Ambient light and diffuse, 0 to 65535.
pub fn lambert(normal: [f64; 3]) -> f64 {
    let lamp = lamp();
    let direction = unit([lamp.direction.x, lamp.direction.y, lamp.direction.z].map(|v| v.to_num::<f64>()));
    let cosine: f64 = normal.iter().zip(direction).map(|(a, b)| a * b).sum();
    (f64::from(lamp.ambient.0) + DIFFUSE * cosine.clamp(0.0, 1.0)).min(65_535.0)
}

/// What the lamp adds at most.
pub const DIFFUSE: f64 = 58_981.0;

/// That of all scenes.
pub fn lamp() -> Lamp {
    Lamp {
        direction: Vector3::new(number(0.4), number(0.6), number(0.69)),
        ambient: Light(6_554),
        diffuse: Light(58_981),
    }
}

/// A texture coordinate as a mesh has it.
#[expect(clippy::cast_possible_truncation, reason = "a float-to-int cast saturates")]
pub fn uv_bits(v: f64) -> i16 {
    (v * 4_096.0).round() as i16
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
    /// 0 to 1, of the last that was drawn.
    pub depths: Vec<f64>,
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
        Self { lights, depths: vec![0.0; pixels] }
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
