//! Whole scenes of any numbers: no panic, nothing outside, and bands with the same pixels as the whole.
#![no_main]

use aquatint::{
    Angle, Clip, Dithered, Frame, Levels, Light, Matrix, Model, Rect, Rows, Scalar, Vector3, View, World,
    geometry::{light::Lamp, projection::Lens, viewport::Viewport},
    hidden::depth::DepthBuffer,
    model::mesh::Mesh,
    pipeline::{Camera, DrawError, Instance, MeshVertex, Workspace, draw_mesh},
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
    normal: [i8; 3],
    triangles: Vec<[u8; 3]>,
    placement: Transform,
}

#[derive(Arbitrary, Debug)]
struct Input {
    things: Vec<Thing>,
    view: Transform,
    projection: Projection,
    /// Left, top, width and height.
    viewport: (i16, i16, u8, u8),
    lamp: ([i32; 3], u16, u16),
    /// Fewer vertices than are needed may be lent.
    lent: u8,
    /// The first row of the second band.
    cut: u8,
}

fuzz_target!(|input: Input| {
    let Some(camera) = camera(&input) else { return };
    let meshes: Vec<_> = input.things.iter().take(3).filter_map(Arrays::new).collect();
    let instances: Vec<_> = meshes.iter().map(Arrays::instance).collect();
    let rows = i32::try_from(HEIGHT).expect("small");
    let cut = i32::from(input.cut) % (rows + 1);
    let lent = usize::from(input.lent).min(VERTICES);

    let (whole, results) = drawn(&instances, &camera, lent, &[0..rows]);
    for (instance, result) in instances.iter().zip(results) {
        let needed = instance.mesh.positions().len();
        match result {
            Ok(()) => assert!(needed <= lent),
            Err(DrawError::TooFewVertices { needed: said }) => assert!(said == needed && needed > lent),
            Err(DrawError::OutOfRange) => {}
            Err(DrawError::Target(never)) => match never {},
        }
    }
    let (bands, _) = drawn(&instances, &camera, lent, &[0..cut, cut..rows]);
    assert_eq!(whole, bands);
});

type Results = Vec<Result<(), DrawError<core::convert::Infallible>>>;

/// The picture, and what was said of each instance last. Whatever a picture had before shows through.
fn drawn(instances: &[Instance], camera: &Camera, lent: usize, bands: &[core::ops::Range<i32>]) -> (Vec<u8>, Results) {
    let mut bytes = vec![0b0101_0011; (WIDTH * HEIGHT / 8) as usize];
    let mut results = vec![];
    for band in bands {
        let window = Rect::new(0, band.start, WIDTH.cast_signed(), band.end);
        let mut depths = vec![7; (window.width() * window.height()) as usize];
        let mut depth = DepthBuffer::new(&mut depths, window).expect("large enough");
        let mut frame = Frame::<BinaryColor, Rows, _>::new(&mut bytes[..], WIDTH, HEIGHT).expect("large enough");
        let mut light = Dithered::new(&mut frame, Levels::ONE_BIT);
        let mut vertices = vec![MeshVertex::EMPTY; lent];
        let mut draw = |instance| {
            draw_mesh(instance, camera, &mut Workspace { vertices: &mut vertices, depth: &mut depth }, &mut light)
        };
        results = instances.iter().map(&mut draw).collect();
    }
    (bytes, results)
}

/// What a mesh borrows.
struct Arrays {
    positions: Vec<[i16; 3]>,
    normals: Vec<[i8; 3]>,
    triangles: Vec<[u16; 3]>,
    placement: Matrix<Model, World>,
}

impl Arrays {
    fn new(thing: &Thing) -> Option<Self> {
        let positions: Vec<_> = thing.positions.iter().copied().take(VERTICES).collect();
        let count = u16::try_from(positions.len()).ok().filter(|&count| count > 0)?;
        let index = |at: u8| u16::from(at) % count;
        let triangles = thing.triangles.iter().take(TRIANGLES).map(|corners| corners.map(index)).collect();
        let normals = vec![thing.normal; positions.len()];
        Some(Self { positions, normals, triangles, placement: matrix(thing.placement) })
    }

    fn instance(&self) -> Instance<'_> {
        let mesh = Mesh::new(&self.positions, &self.normals, &self.triangles).expect("indices are right");
        Instance { mesh, placement: self.placement }
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
    let (direction, ambient, diffuse) = input.lamp;
    let [x, y, z] = direction.map(Scalar::from_bits);
    Some(Camera {
        view: matrix::<World, View>(input.view),
        projection,
        viewport: Viewport::new(rect).ok()?,
        lamp: Lamp { direction: Vector3::new(x, y, z), ambient: Light(ambient), diffuse: Light(diffuse) },
    })
}
