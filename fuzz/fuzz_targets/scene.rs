//! Whole scenes of any numbers: no panic, nothing outside, and bands with the same pixels as the whole.
#![no_main]

#[path = "scene_ways.rs"]
mod ways;

use aquatint::{
    Angle, Clip, Dithered, Frame, Levels, Light, Matrix, Model, Rect, Rows, Scalar, Vector3, View, World,
    fragment::{
        shade::{Corner, Flat, Gouraud, Mapped, Phong, Shader, Shading, Stippled, Textured, Unlit},
        texture::{Bilinear, ClampToEdge, LightTexture, Sampler},
    },
    geometry::{
        face::Faces,
        light::{Lamp, Lighting, Surface},
        lights::{Lights, Source},
        projection::Lens,
        viewport::Viewport,
    },
    hidden::{
        Hidden,
        convex::Convex,
        depth::{Depth, DepthBuffer, DepthTest},
    },
    model::{
        assembly::{Assembly, RESTART},
        mesh::Mesh,
    },
    pipeline::{
        Camera, DepthBias, DrawError, Instance, Material, MeshVertex, Scene, Workspace, draw_mesh,
    },
};
use arbitrary::Arbitrary;
use embedded_graphics::pixelcolor::BinaryColor;
use libfuzzer_sys::fuzz_target;

/// Of the picture.
const WIDTH: u32 = 48;
const HEIGHT: u32 = 32;

/// Vertices and triangles of a mesh, at most.
const VERTICES: usize = 16;
const TRIANGLES: usize = 24;

/// A matrix of any elements, or one that is likely to show something.
#[derive(Arbitrary, Clone, Copy, Debug)]
enum Transform {
    Any([[i32; 4]; 4]),
    Pose { turns: [u16; 3], by: [i16; 3], scale: u16 },
}

#[derive(Arbitrary, Clone, Copy, Debug)]
enum Projection {
    Any([[i32; 4]; 4]),
    Perspective { field_of_view: u16, aspect: u16, near: u16, far: u32 },
}

#[derive(Arbitrary, Debug)]
struct Thing {
    positions: Vec<[i16; 3]>,
    normals: [[i8; 3]; 4],
    uv: [[i16; 2]; 4],
    lights: [u16; 4],
    has: [bool; 3],
    assembly: Kind,
    triangles: Vec<[u8; 3]>,
    placement: Transform,
    look: Look,
}

#[derive(Arbitrary, Clone, Copy, Debug)]
enum Kind {
    Triangles,
    Strip,
    Fan,
    Polygons,
}

#[derive(Arbitrary, Clone, Copy, Debug)]
struct Look {
    mode: Mode,
    sides: u8,
    bias: (i16, i8),
    surface: (u16, u16, u8),
}

#[derive(Arbitrary, Clone, Copy, Debug)]
enum Mode {
    Gouraud,
    Flat,
    Phong,
    Unlit,
    Textured,
    LitTexture,
    BilinearTexture,
    Affine,
    Mapped,
    Stippled([u8; 3]),
    Shader,
}

#[derive(Arbitrary, Clone, Copy, Debug)]
enum Bits {
    Eight,
    Sixteen,
    ThirtyTwo,
    None,
}

#[derive(Arbitrary, Debug)]
struct Input {
    things: Vec<Thing>,
    view: Transform,
    projection: Projection,
    /// Left, top, width and height.
    viewport: (i16, i16, u8, u8),
    lamp: ([i32; 3], u16, u16),
    /// Where a second lamp is, and how far it reaches; if there is one.
    near: Option<([i32; 3], i32)>,
    bits: Bits,
    test: u8,
    is_quiet: bool,
    /// Fewer vertices than are needed may be lent.
    lent: u8,
    /// The first row of the second band.
    cut: u8,
}

fuzz_target!(|input: Input| {
    let Some(camera) = camera(&input) else { return };
    let meshes: Vec<_> = input.things.iter().take(3).filter_map(Arrays::new).collect();
    let (direction, ambient, diffuse) = input.lamp;
    let [x, y, z] = direction.map(Scalar::from_bits);
    let direction = Vector3::new(x, y, z);
    let (ambient, light) = (Light(ambient), Light(diffuse));
    if let Some((place, reach)) = input.near {
        let [x, y, z] = place.map(Scalar::from_bits);
        let position = aquatint::Point3::new(x, y, z);
        let near = Source::Point { position, light, reach: Scalar::from_bits(reach) };
        let spot = Source::Spot {
            position,
            direction,
            light,
            reach: Scalar::from_bits(reach),
            inner: Angle(ambient.0),
            outer: Angle(light.0),
        };
        check(&input, &meshes, &Scene { camera, light: Lights { ambient, sources: [near, spot] } });
    } else {
        check(&input, &meshes, &Scene { camera, light: Lamp { direction, ambient, diffuse: light } });
    }
});

type Results = Vec<Result<(), DrawError<core::convert::Infallible>>>;

fn check<L: Lighting>(input: &Input, meshes: &[Arrays], scene: &Scene<L>) {
    let rows = i32::try_from(HEIGHT).expect("small");
    let cut = i32::from(input.cut) % (rows + 1);
    let lent = usize::from(input.lent).min(VERTICES);
    let draw = |bands: &[core::ops::Range<i32>]| match input.bits {
        Bits::Eight => drawn(input, (meshes, scene), bands, 7_u8),
        Bits::Sixteen => drawn(input, (meshes, scene), bands, 7_u16),
        Bits::ThirtyTwo => drawn(input, (meshes, scene), bands, 7_u32),
        Bits::None => in_bands(input, (meshes, scene), bands, |_, draw| draw.all(&mut Convex)),
    };
    let (whole, results) = draw(&[0..rows]);
    for (arrays, result) in meshes.iter().zip(results) {
        let needed = arrays.positions.len();
        match result {
            Ok(()) => assert!(needed <= lent),
            Err(DrawError::TooFewVertices { needed: said }) => assert!(said == needed && needed > lent),
            Err(DrawError::OutOfRange) => {}
            Err(DrawError::Target(never)) => match never {},
            Err(other) => panic!("{other:?}"),
        }
    }
    if let [a, b, ..] = meshes {
        ways::check([a, b], scene);
    }
    // What decides nothing about depths knows no bands.
    if !matches!(input.bits, Bits::None) {
        let (bands, _) = draw(&[0..cut, cut..rows]);
        assert_eq!(whole, bands);
    }
}

/// With a depth buffer of a band.
fn drawn<D: Depth + Ord, L: Lighting>(
    input: &Input,
    all: (&[Arrays], &Scene<L>),
    bands: &[core::ops::Range<i32>],
    old: D,
) -> (Vec<u8>, Results) {
    const TESTS: [DepthTest; 8] = [
        DepthTest::Nearer,
        DepthTest::NotFarther,
        DepthTest::Equal,
        DepthTest::NotEqual,
        DepthTest::Farther,
        DepthTest::NotNearer,
        DepthTest::Always,
        DepthTest::Never,
    ];
    in_bands(input, all, bands, |window, draw| {
        let mut depths = vec![old; (window.width() * window.height()) as usize];
        let buffer = DepthBuffer::new(&mut depths, window).expect("large enough");
        match (input.test, input.is_quiet) {
            (0..128, false) => draw.all(&mut { buffer }),
            (0..128, true) => draw.all(&mut buffer.without_writing()),
            (test, false) => draw.all(&mut buffer.with_test(TESTS[usize::from(test) % 8])),
            (test, true) => draw.all(&mut buffer.with_test(TESTS[usize::from(test) % 8]).without_writing()),
        }
    })
}

/// What is drawn in a band.
struct Draw<'d, L> {
    meshes: &'d [Arrays],
    scene: &'d Scene<L>,
    vertices: &'d mut [MeshVertex],
    bytes: &'d mut [u8],
}

/// The picture, and what was said of each instance last. Whatever a picture had before shows through.
fn in_bands<L: Lighting>(
    input: &Input,
    (meshes, scene): (&[Arrays], &Scene<L>),
    bands: &[core::ops::Range<i32>],
    draw: impl Fn(Rect, Draw<'_, L>) -> Results,
) -> (Vec<u8>, Results) {
    let mut bytes = vec![0b0101_0011; (WIDTH * HEIGHT / 8) as usize];
    let mut results = vec![];
    for band in bands {
        let window = Rect::new(0, band.start, WIDTH.cast_signed(), band.end);
        let mut vertices = vec![MeshVertex::EMPTY; usize::from(input.lent).min(VERTICES)];
        results = draw(window, Draw { meshes, scene, vertices: &mut vertices, bytes: &mut bytes });
    }
    (bytes, results)
}

static TEXELS: [Light; 8] =
    [Light(0), Light(9_000), Light(60_000), Light(30_000), Light(100), Light(50_000), Light(20_000), Light(65_535)];

impl<L: Lighting> Draw<'_, L> {
    fn all<H: Hidden>(mut self, hidden: &mut H) -> Results {
        let meshes = self.meshes;
        meshes.iter().map(|arrays| self.one(arrays, hidden)).collect()
    }

    fn one<H: Hidden>(&mut self, arrays: &Arrays, hidden: &mut H) -> Result<(), DrawError<core::convert::Infallible>> {
        let texture = || Sampler::new(LightTexture::new(&TEXELS, 4, 2).expect("a texture"));
        match arrays.look.mode {
            Mode::Gouraud => self.with(arrays, hidden, Gouraud),
            Mode::Flat => self.with(arrays, hidden, Flat),
            Mode::Phong => self.with(arrays, hidden, Phong),
            Mode::Unlit => self.with(arrays, hidden, Unlit),
            Mode::Textured => self.with(arrays, hidden, Textured::new(texture(), Unlit)),
            Mode::LitTexture => {
                self.with(arrays, hidden, Textured::new(texture().with_wrap(ClampToEdge), Gouraud))
            }
            Mode::BilinearTexture => {
                self.with(arrays, hidden, Textured::new(texture().with_filter(Bilinear), Phong))
            }
            Mode::Affine => self.with(arrays, hidden, Textured::new(texture(), Flat).affine()),
            Mode::Mapped => self.with(arrays, hidden, Mapped::new(Gouraud, |light: Light| Light(!light.0))),
            Mode::Stippled(tile) => self.with(arrays, hidden, Stippled::new(Flat, tile)),
            Mode::Shader => {
                let corner = |corner: &Corner| [corner.light.0, corner.position[0].cast_unsigned(), corner.index];
                let fragment = |[light, x, _]: [u16; 3]| (x & 0x400 == 0).then_some(Light(light));
                self.with(arrays, hidden, Shader::new(corner, fragment))
            }
        }
    }

    fn with<H: Hidden, S: Shading<Color = Light>>(
        &mut self,
        arrays: &Arrays,
        hidden: &mut H,
        shading: S,
    ) -> Result<(), DrawError<core::convert::Infallible>> {
        let material = arrays.look.material(shading);
        let mut normals = vec![];
        let assembly = arrays.assembly();
        let mut mesh = Mesh::with_assembly(&arrays.positions, &arrays.normals, assembly).expect("indices are right");
        if arrays.has[0] {
            mesh = mesh.with_uv(&arrays.uv).expect("one each");
        }
        if arrays.has[1] {
            mesh = mesh.with_lights(&arrays.lights).expect("one each");
        }
        if arrays.has[2] {
            let count = mesh.faces().map(|face| face.number + 1).max().unwrap_or(0);
            let needed = match assembly {
                Assembly::Polygons { counts, .. } => counts.len(),
                _ => count,
            };
            normals.resize(needed, arrays.normals[0]);
            mesh = mesh.with_face_normals(&normals).expect("one each");
        }
        let mut frame = Frame::<BinaryColor, Rows, _>::new(&mut *self.bytes, WIDTH, HEIGHT).expect("large enough");
        let mut light = Dithered::new(&mut frame, Levels::ONE_BIT);
        let instance = Instance::new(mesh, arrays.placement).with_material(material);
        let mut workspace = Workspace { vertices: &mut *self.vertices, hidden };
        draw_mesh(&instance, self.scene, &mut workspace, &mut light)
    }
}

impl Look {
    fn material<S>(self, shading: S) -> Material<S> {
        let Self { sides, bias: (constant, slope), surface: (diffuse, specular, shininess), .. } = self;
        let faces = [Faces::Front, Faces::Back, Faces::Both][usize::from(sides) % 3];
        let surface = Surface { diffuse, specular, shininess };
        Material { shading, surface, faces, bias: DepthBias { constant, slope } }
    }
}

/// What a mesh borrows.
struct Arrays {
    positions: Vec<[i16; 3]>,
    normals: Vec<[i8; 3]>,
    uv: Vec<[i16; 2]>,
    lights: Vec<Light>,
    triangles: Vec<[u16; 3]>,
    /// Of strips and fans: some begin again.
    run: Vec<u16>,
    counts: Vec<u8>,
    has: [bool; 3],
    kind: Kind,
    placement: Matrix<Model, World>,
    look: Look,
}

impl Arrays {
    fn new(thing: &Thing) -> Option<Self> {
        let positions: Vec<_> = thing.positions.iter().copied().take(VERTICES).collect();
        let count = u16::try_from(positions.len()).ok().filter(|&count| count > 0)?;
        let index = |at: u8| u16::from(at) % count;
        let raw = || thing.triangles.iter().take(TRIANGLES);
        let all = 0..positions.len();
        Some(Self {
            normals: all.clone().map(|at| thing.normals[at % 4]).collect(),
            uv: all.clone().map(|at| thing.uv[at % 4]).collect(),
            lights: all.map(|at| Light(thing.lights[at % 4])).collect(),
            triangles: raw().map(|corners| corners.map(index)).collect(),
            run: raw().flatten().map(|&at| if at > 250 { RESTART } else { index(at) }).collect(),
            counts: polygons(raw().count()),
            has: thing.has,
            kind: thing.assembly,
            placement: matrix(thing.placement),
            look: thing.look,
            positions,
        })
    }

    fn assembly(&self) -> Assembly<'_> {
        match self.kind {
            Kind::Triangles => Assembly::Triangles(&self.triangles),
            Kind::Strip => Assembly::Strip(&self.run),
            Kind::Fan => Assembly::Fan(&self.run),
            Kind::Polygons => Assembly::Polygons { counts: &self.counts, indices: self.triangles.as_flattened() },
        }
    }
}

fn rows<A, B>(elements: [[i32; 4]; 4]) -> Matrix<A, B> {
    Matrix::from_rows(elements.map(|row| row.map(Scalar::from_bits)))
}

fn matrix<A, B>(transform: Transform) -> Matrix<A, B> {
    match transform {
        Transform::Any(elements) => rows(elements),
        Transform::Pose { turns: [x, y, z], by, scale } => {
            // Up to 8 away, up to 4 times as large.
            let [dx, dy, dz] = by.map(|v| Scalar::from_bits(i32::from(v) * 16));
            Matrix::<A, A>::scale(Scalar::from_bits(i32::from(scale) * 4))
                .then(&Matrix::<A, A>::rotation_x(Angle(x)))
                .then(&Matrix::<A, A>::rotation_y(Angle(y)))
                .then(&Matrix::<A, A>::rotation_z(Angle(z)))
                .then(&Matrix::translation(dx, dy, dz))
        }
    }
}

/// None where the numbers are refused.
fn camera(input: &Input) -> Option<Camera> {
    let (left, top, width, height) = input.viewport;
    let (left, top) = (i32::from(left), i32::from(top));
    let rect = Rect::new(left, top, left + i32::from(width), top + i32::from(height));
    let projection: Matrix<View, Clip> = match input.projection {
        Projection::Any(elements) => rows(elements),
        Projection::Perspective { field_of_view, aspect, near, far } => Matrix::perspective(Lens {
            field_of_view: Angle(field_of_view),
            aspect: Scalar::from_bits(i32::from(aspect) * 4),
            near: Scalar::from_bits(i32::from(near)),
            far: Scalar::from_bits((far >> 3).cast_signed()),
        })
        .ok()?,
    };
    Some(Camera {
        view: matrix::<World, View>(input.view),
        projection,
        viewport: Viewport::new(rect).ok()?,
    })
}

/// Corners of polygons that have those of so many triangles together: hexagons, and what is left.
fn polygons(triangles: usize) -> Vec<u8> {
    let mut counts = vec![6; triangles / 2];
    counts.extend((triangles % 2 == 1).then_some(3));
    counts
}
