//! What holds no pixel, and what is refused.

use aquatint::{
    Angle, Clip, Light, Matrix, Model, Rect, Scalar, Vector3, View, World,
    fragment::shade::{Flat, Gouraud, Phong, Shading, Stippled, Textured, Unlit},
    fragment::texture::{LightTexture, Sampler},
    geometry::{
        face::Faces,
        light::Lamp,
        projection::{Lens, ProjectionError, ViewBox},
        viewport::{BadViewport, Viewport},
    },
    hidden::depth::DepthBuffer,
    model::mesh::Mesh,
    pipeline::{Camera, DepthBias, DrawError, Instance, Material, MeshVertex, Scene, Workspace, draw_mesh},
};

use crate::common::{Canvas, Shape, VIEW, camera_scene, number, panel, scene};

fn drawn<S: Shading<Color = Light>>(
    mesh: Mesh<'_>,
    placement: Matrix<Model, World>,
    shading: S,
    scene: &Scene,
) -> Result<usize, DrawError<core::convert::Infallible>> {
    let mut canvas = Canvas::new(VIEW);
    let mut depths = [0_u16; 128];
    let mut buffer = DepthBuffer::new(&mut depths, VIEW).expect("large enough");
    let mut vertices = vec![MeshVertex::EMPTY; mesh.positions().len()];
    let mut workspace = Workspace { vertices: &mut vertices, hidden: &mut buffer };
    let bias = DepthBias { constant: -7, slope: 3 };
    let material = Material { faces: Faces::Both, bias, ..Material::new(shading) };
    let instance = Instance::new(mesh, placement).with_material(material);
    draw_mesh(&instance, scene, &mut workspace, &mut canvas)?;
    Ok(canvas.colors.iter().flatten().count())
}

/// By every shading, and all of them the same.
fn pixels(mesh: Mesh<'_>, placement: Matrix<Model, World>, scene: &Scene) -> usize {
    static TEXELS: [Light; 1] = [Light(0x5000)];
    let texture = || Sampler::new(LightTexture::new(&TEXELS, 1, 1).expect("a texture"));
    let counts = [
        drawn(mesh, placement, Gouraud, scene),
        drawn(mesh, placement, Flat, scene),
        drawn(mesh, placement, Phong, scene),
        drawn(mesh, placement, Textured::new(texture(), Unlit), scene),
        drawn(mesh, placement, Textured::new(texture(), Gouraud).affine(), scene),
        drawn(mesh, placement, Stippled::new(Gouraud, [0xFF]), scene),
    ];
    assert!(counts.iter().all(|count| *count == counts[0]), "{counts:?}");
    counts[0].expect("in range")
}

#[test]
fn triangles_without_area() {
    let corners = [[0; 3], [9_000, 100, 50], [-5_000, 7_000, 0]];
    for indices in [[0, 0, 0], [0, 1, 1], [1, 0, 1], [2, 2, 0]] {
        let indices = [indices];
        let mesh = Mesh::new(&corners, &[[0, 0, 127]; 3], &indices).expect("indices are right");
        assert_eq!(pixels(mesh, Matrix::IDENTITY, &scene(VIEW)), 0);
    }
    for corners in
        [[[1_000, 2_000, 0]; 3], [[-9_000, 0, 0], [0; 3], [9_000, 0, 0]], [[0, 0, -9_000], [0; 3], [0, 0, 9_000]]]
    {
        let mesh = Mesh::new(&corners, &[[0, 0, 127]; 3], &[[0, 1, 2]]).expect("indices are right");
        assert_eq!(pixels(mesh, Matrix::IDENTITY, &scene(VIEW)), 0);
    }
}

#[test]
fn singular_matrices_draw_nothing_or_say_so() {
    let (nil, one) = (Scalar::ZERO, Scalar::ONE);
    let zero = [[nil; 4]; 4];
    let shape: Shape = panel(VIEW, [0.0; 2]);
    assert_eq!(pixels(shape.mesh(), Matrix::IDENTITY, &scene(VIEW)), 128);
    // All rows zero, each of the three places of a matrix.
    assert_eq!(pixels(shape.mesh(), Matrix::from_rows(zero), &scene(VIEW)), 0);
    for scene_of in [scene as fn(Rect) -> Scene, camera_scene] {
        let mut by_view = scene_of(VIEW);
        by_view.camera.view = Matrix::<World, View>::from_rows(zero);
        assert_eq!(pixels(shape.mesh(), Matrix::IDENTITY, &by_view), 0);
        let mut by_lens = scene_of(VIEW);
        by_lens.camera.projection = Matrix::<View, Clip>::from_rows(zero);
        assert_eq!(pixels(shape.mesh(), Matrix::IDENTITY, &by_lens), 0);
    }
    // One row zero: flat, so without area, or all at one depth.
    for row in 0..3 {
        let mut rows = [[one, nil, nil, nil], [nil, one, nil, nil], [nil, nil, one, nil], [nil, nil, nil, one]];
        rows[row] = [nil; 4];
        let want = if row == 2 { 128 } else { 0 };
        assert_eq!(pixels(shape.mesh(), Matrix::from_rows(rows), &scene(VIEW)), want, "row {row}");
    }
    // Scaled to nothing.
    assert_eq!(pixels(shape.mesh(), Matrix::scale(nil), &camera_scene(VIEW)), 0);
    // Too far: refused, and nothing drawn.
    for far in [Scalar::MAX, Scalar::MIN, Scalar::from_num(5000)] {
        let placement = Matrix::translation(far, nil, nil);
        assert_eq!(drawn(shape.mesh(), placement, Gouraud, &scene(VIEW)), Err(DrawError::OutOfRange));
    }
    let endless = Matrix::from_rows([[Scalar::MIN; 4]; 4]);
    assert_eq!(drawn(shape.mesh(), endless, Gouraud, &scene(VIEW)), Err(DrawError::OutOfRange));
}

/// A lamp without a direction, and normals of no length, give ambient light.
#[test]
fn no_direction_is_dark() {
    fn picture<S: Shading<Color = Light>>(shape: &Shape, shading: S, scene: &Scene) -> String {
        let mut canvas = Canvas::new(VIEW);
        let mut hidden = aquatint::hidden::convex::Convex;
        crate::common::draw_in(scene, &shape.mesh(), Material::new(shading), (&mut hidden, &mut canvas))
            .expect("in range");
        canvas.picture()
    }

    let mut shape = panel(VIEW, [0.0; 2]);
    shape.normals = vec![[0; 3]; 4];
    let nil = Scalar::ZERO;
    let light = Lamp { direction: Vector3::new(nil, nil, nil), ambient: Light(0x3000), diffuse: Light::WHITE };
    for light in [light, Lamp { ambient: Light(0x3000), ..scene(VIEW).light }] {
        let scene = Scene { camera: scene(VIEW).camera, light };
        let want = "3333333333333333\n".repeat(8);
        assert_eq!(picture(&shape, Gouraud, &scene), want);
        assert_eq!(picture(&shape, Flat, &scene), want);
        assert_eq!(picture(&shape, Phong, &scene), want);
    }
}

#[test]
fn lenses_without_depth_are_refused() {
    let lens = |near: f64, far: f64| {
        let [near, far] = [near, far].map(number);
        Matrix::perspective(Lens { field_of_view: Angle::from_degrees(60.0), aspect: Scalar::ONE, near, far })
    };
    assert!(lens(0.5, 0.6).is_ok());
    for (near, far) in [(1.0, 1.0), (2.0, 1.0), (0.0, 1.0), (-1.0, 1.0), (0.1, 1.0), (1.0, 5_000.0)] {
        assert_eq!(lens(near, far), Err(ProjectionError::Range), "{near} to {far}");
    }
    let boxed = |near: f64, far: f64| {
        let [near, far] = [near, far].map(number);
        Matrix::orthographic(ViewBox { height: Scalar::ONE, aspect: Scalar::ONE, near, far })
    };
    assert!(boxed(-1.0, 1.0).is_ok());
    assert_eq!(boxed(1.0, 1.0), Err(ProjectionError::Depths));
    assert_eq!(boxed(2.0, 1.0), Err(ProjectionError::Depths));
}

#[test]
fn viewports_without_pixels_are_refused() {
    for rect in [
        Rect::new(0, 0, 0, 0),
        Rect::new(0, 0, 0, 5),
        Rect::new(0, 0, 5, 0),
        Rect::new(3, 3, 2, 9),
        Rect::new(i32::MAX, 0, i32::MIN, 9),
        Rect::new(-4097, 0, 1, 1),
    ] {
        assert_eq!(Viewport::new(rect), Err(BadViewport), "{rect:?}");
    }
    assert!(Viewport::new(Rect::new(-4096, -4096, 4096, 4096)).is_ok());
}

/// A target or a depth buffer beside the viewport, or of no pixels: nothing is drawn, and nothing is wrong.
#[test]
fn windows_beside_each_other() {
    let shape = panel(VIEW, [0.0; 2]);
    for (of_depths, of_target) in [
        (Rect::new(0, 0, 0, 0), VIEW),
        (VIEW, Rect::new(0, 0, 0, 0)),
        (Rect::new(100, 0, 116, 8), VIEW),
        (VIEW, Rect::new(0, -9, 16, 0)),
        (Rect::new(0, 0, 8, 8), Rect::new(8, 0, 16, 8)),
    ] {
        let mut depths = [0_u16; 128];
        let mut buffer = DepthBuffer::new(&mut depths, of_depths).expect("large enough");
        let mut canvas = Canvas::new(of_target);
        crate::common::draw(&shape, Material::new(Gouraud), &mut buffer, &mut canvas).expect("in range");
        assert!(canvas.colors.iter().all(Option::is_none) && depths.iter().all(|depth| *depth == 0));
    }
    // Where both are, it is drawn, and only there.
    let mut depths = [0_u16; 128];
    let mut buffer = DepthBuffer::new(&mut depths, Rect::new(-3, 2, 9, 7)).expect("large enough");
    let mut canvas = Canvas::new(Rect::new(5, -2, 20, 5));
    crate::common::draw(&shape, Material::new(Gouraud), &mut buffer, &mut canvas).expect("in range");
    assert_eq!((canvas.colors.iter().flatten().count(), depths.iter().filter(|depth| **depth > 0).count()), (12, 12));
    let _: Camera = scene(VIEW).camera;
}
