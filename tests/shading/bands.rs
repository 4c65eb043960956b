//! Every fill mode drawn in bands and in tiles is the whole picture.

use core::convert::Infallible;

use aquatint::{
    Angle, Code, Dithered, Frame, Levels, Light, Matrix, Model, Pages, Point3, Rect, Rows, Target, Vector3, Window,
    World,
    display::layout::Layout,
    fragment::{
        shade::{Corner, Flat, Gouraud, Mapped, Phong, Shader, Shading, Stippled, Textured, Unlit},
        texture::{Bilinear, LightTexture, Mirror, Sampler},
        toon::Bands,
    },
    geometry::{
        face::Faces,
        light::Surface,
        lights::{Lights, Source},
    },
    hidden::depth::DepthBuffer,
    pipeline::{DepthBias, Instance, Material, MeshVertex, Scene, Workspace, draw_mesh},
};
use embedded_graphics::{
    geometry::Point,
    image::GetPixel,
    pixelcolor::{BinaryColor, Gray4},
};

use crate::common::{Shape, camera_scene, number, place};

const WIDTH: u32 = 67;
const HEIGHT: u32 = 45;
const VIEW: Rect = Rect::new(0, 0, 67, 45);

/// Two boxes one through the other, a floor that the near plane cuts, and a large wall behind.
fn shape() -> Shape {
    let mut shape = Shape::default();
    let mut quadrangle = |corners: [[f64; 3]; 4], normal: [i8; 3]| {
        let first = u16::try_from(shape.positions.len()).expect("few");
        shape.positions.extend(corners.map(|corner| place(corner.map(|v| v / 8.0))));
        shape.normals.extend([normal; 4]);
        shape.lights.extend([0xFFFF, 0xC000, 0x9000, 0xE000].map(Light));
        shape.uv.extend([[0, 0], [9_000, 300], [8_192, 8_192], [-500, 7_000]]);
        shape.triangles.extend([[first, first + 1, first + 2], [first, first + 2, first + 3]]);
    };
    for [x, y, z, half] in [[-0.4, 0.1, -3.0, 0.7], [0.5, -0.1, -3.3, 0.8]] {
        let at = |dx: f64, dy: f64, dz: f64| {
            let (sin, cos) = (0.6_f64).sin_cos();
            [x + half * (dx * cos + dz * sin), y + half * (dy + 0.3 * dx), z + half * (dz * cos - dx * sin)]
        };
        quadrangle([at(-1.0, -1.0, 1.0), at(1.0, -1.0, 1.0), at(1.0, 1.0, 1.0), at(-1.0, 1.0, 1.0)], [60, 0, 110]);
        quadrangle([at(1.0, -1.0, 1.0), at(1.0, -1.0, -1.0), at(1.0, 1.0, -1.0), at(1.0, 1.0, 1.0)], [100, 40, -60]);
        quadrangle([at(-1.0, -1.0, -1.0), at(-1.0, -1.0, 1.0), at(-1.0, 1.0, 1.0), at(-1.0, 1.0, -1.0)], [-110, 0, 60]);
    }
    quadrangle([[-9.0, -0.9, 1.0], [9.0, -0.9, 1.0], [9.0, -0.9, -14.0], [-9.0, -0.9, -14.0]], [0, 127, 0]);
    quadrangle([[-14.0, -6.0, -9.0], [14.0, -6.0, -15.0], [14.0, 9.0, -15.0], [-14.0, 9.0, -9.0]], [20, 0, 120]);
    shape
}

fn lights() -> Lights<2> {
    let [x, y, z, reach] = [1.0, 1.5, -0.5, 3.0].map(number);
    let [dx, dy, dz] = [-0.3, 0.5, 0.7].map(number);
    Lights {
        ambient: Light(5_000),
        sources: [
            Source::Point { position: Point3::new(x, y, z), light: Light(40_000), reach },
            Source::Directional { direction: Vector3::new(dx, dy, dz), light: Light(30_000) },
        ],
    }
}

/// Draws what lies in the window of both the target and the depths.
fn draw<S: Shading<Color = Light>, T: Target<Error = Infallible>>(
    shading: S,
    levels: Levels<'_>,
    window: Rect,
    target: &mut T,
) where
    T::Color: Code,
{
    let shape = shape();
    let scene = Scene { camera: camera_scene(VIEW).camera, light: lights() };
    let mut depths = vec![0_u16; window.width() as usize * window.height() as usize];
    let mut buffer = DepthBuffer::new(&mut depths, window).expect("large enough");
    let mut vertices = vec![MeshVertex::EMPTY; shape.positions.len()];
    let placement = Matrix::<Model, World>::scale(number(8.0)).then(&Matrix::<World, World>::rotation_z(Angle(900)));
    let bias = DepthBias { constant: 3, slope: 1 };
    let material = Material { faces: Faces::Both, surface: Surface::GLOSSY, bias, ..Material::new(shading) };
    let instance = Instance::new(shape.mesh(), placement).with_material(material);
    let mut workspace = Workspace { vertices: &mut vertices, hidden: &mut buffer };
    let mut dithered = Dithered::new(target, levels);
    draw_mesh(&instance, &scene, &mut workspace, &mut dithered).expect("in range");
}

type Bytes<C, L> = Frame<C, L, Vec<u8>>;

fn frame<C: Code, L: Layout<C>>(height: u32) -> Bytes<C, L> {
    Frame::new(vec![0; Frame::<C, L, ()>::bytes_needed(WIDTH, height)], WIDTH, height).expect("large enough")
}

/// Codes of a row.
fn row<C: Code>(target: &impl GetPixel<Color = C>, y: i32) -> Vec<u8> {
    VIEW.columns().map(|x| target.pixel(Point::new(x, y)).expect("inside").code()).collect()
}

fn check_on<C: Code, L: Layout<C>, S: Shading<Color = Light> + Copy>(shading: S, levels: Levels<'_>, name: &str) {
    let mut whole = frame::<C, L>(HEIGHT);
    draw(shading, levels, VIEW, &mut whole);
    let lit = VIEW.rows().flat_map(|y| row(&whole, y)).filter(|code| *code > 0).count();
    assert!(lit > 400, "{name}: {lit}");
    // Bands with memory for themselves alone.
    for height in [1, 7] {
        for top in (0..45).step_by(height) {
            let bottom = (top + i32::try_from(height).expect("small")).min(45);
            let mut band = frame::<C, L>(bottom.abs_diff(top));
            let mut window = Window::band(&mut band, top);
            draw(shading, levels, Rect::new(0, top, 67, bottom), &mut window);
            for y in top..bottom {
                assert_eq!(row(&band, y - top), row(&whole, y), "{name}: row {y} in bands of {height}");
            }
        }
    }
    // Columns of tiles on one frame, where the depths end.
    for width in [1, 5, 16] {
        let mut tiled = frame::<C, L>(HEIGHT);
        for left in (0..67).step_by(width) {
            let right = (left + i32::try_from(width).expect("small")).min(67);
            draw(shading, levels, Rect::new(left, 0, right, 45), &mut tiled);
        }
        assert!(tiled.bytes() == whole.bytes(), "{name}: tiles of {width}");
    }
}

fn check<S: Shading<Color = Light> + Copy>(shading: S, name: &str) {
    check_on::<BinaryColor, Rows, S>(shading, Levels::ONE_BIT, name);
    check_on::<BinaryColor, Pages, S>(shading, Levels::ONE_BIT, name);
    check_on::<Gray4, Rows, S>(shading, Levels::SRGB_16, name);
}

static TEXELS: [Light; 16] = {
    let mut lights = [Light::BLACK; 16];
    let mut at = 0;
    while at < 16 {
        lights[at] = Light(([9, 3, 14, 1, 0, 12, 7, 15, 2, 10, 5, 13, 8, 4, 11, 6][at]) * 4_096);
        at += 1;
    }
    lights
};

fn texture() -> Sampler<LightTexture<'static>> {
    Sampler::new(LightTexture::new(&TEXELS, 4, 4).expect("a texture"))
}

#[test]
fn without_textures() {
    check(Gouraud, "Gouraud");
    check(Flat, "flat");
    check(Phong, "Phong");
    check(Unlit, "unlit");
}

#[test]
fn with_textures() {
    check(Textured::new(texture(), Unlit), "textured");
    check(Textured::new(texture().with_filter(Bilinear).with_wrap(Mirror), Gouraud), "bilinear, in light");
    check(Textured::new(texture(), Flat).affine(), "affine");
    check(Textured::new(texture(), Phong), "textured, Phong");
}

#[test]
fn changed_and_left_out() {
    let bands = Bands::even(4).expect("four");
    check(Mapped::new(Gouraud, move |light| bands.of(light)), "bands");
    check(Stippled::new(Gouraud, [0b1100_1010, 0b0101_0011, 0b1111_0000]), "stippled");
    check(Stippled::new(Textured::new(texture(), Flat), [0b1100_1010, 0b0101_0011]), "stippled texture");
    let rings = Shader::new(
        |corner: &Corner| [corner.light.0, corner.position[0].cast_unsigned() ^ 0x8000],
        |[light, along]: [u16; 2]| (along & 0x100 == 0).then_some(Light(light)),
    );
    check(rings, "shader");
    check(Mapped::new(rings, |light: Light| Light(!light.0)), "shader, negative");
}
