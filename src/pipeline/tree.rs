//! Trees of faces, drawn from the back to the front: no depths, no memory for pixels. Lecture 5.8.4.

use heapless::vec::Vec;

use super::{
    Bounds, DrawError, Instance, Scene, Workspace, each_clipped, eye,
    fragments::{Fragments, MeshTriangle, Piece},
    prepared,
    surface::Surface,
    vertex::MeshVertex,
};
use crate::{
    cut::Cut,
    fragment::shade::{Gouraud, Shading},
    geometry::{face::signed_area, light::Lighting},
    hidden::{
        Hidden,
        bsp::{self, MOST_CUTS, Tree},
    },
    illumination::Illumination,
    model::assembly::Face,
    space::{Clip, Point4, Rect},
    target::Target,
};

/// An instance, and the tree of the triangles of its mesh.
#[derive(Clone, Copy, Debug)]
pub struct TreeInstance<'a, S = Gouraud, B = ()> {
    /// What is drawn.
    pub instance: Instance<'a, S, B>,
    /// In what order.
    pub tree: Tree<'a>,
}

/// Draws a mesh as [`draw_mesh`](super::draw_mesh) does, its faces in the painter's order that a tree has for them.
///
/// With [`Convex`](crate::hidden::convex::Convex) there is no depth at all;
/// with a depth buffer, the tree's mesh and others hide each other. What is seen is what a depth buffer shows; where two faces
/// are at almost the same depth, either may be the one that is.
///
/// Faces in which the tree has splits are drawn once for each piece, and each time all their spans are computed: of each the part
/// that belongs to the piece is drawn.
///
/// Memory: 12 bytes a vertex, lent by the caller; 1.1 kB of stack more than [`draw_mesh`](super::draw_mesh).
///
/// # Errors
/// [`DrawError`].
///
/// ```
/// # use aquatint::{Angle, Frame, Levels, Dithered, Light, Matrix, Rect, Rows, Scalar, Vector3, View, World};
/// # use aquatint::{geometry::{light::Lamp, projection::Lens, viewport::Viewport}, hidden::bsp::{Choice, TreeArrays}};
/// # use aquatint::{model::assembly::Assembly, pipeline::{Camera, MeshVertex, Scene}};
/// use aquatint::{
///     hidden::{bsp::{Tree, Triangles}, convex::Convex},
///     model::solids::CUBE,
///     pipeline::{Instance, TreeInstance, Workspace, draw_tree},
/// };
/// # use embedded_graphics::pixelcolor::BinaryColor;
/// # let one = Scalar::ONE;
/// # let lens = Lens { field_of_view: Angle::from_degrees(40.0), aspect: one, near: one, far: one * 8 };
/// # let camera = Camera {
/// #     view: Matrix::<World, View>::translation(Scalar::ZERO, Scalar::ZERO, one * -5),
/// #     projection: Matrix::perspective(lens)?,
/// #     viewport: Viewport::new(Rect::new(0, 0, 64, 64))?,
/// # };
/// # let direction = Vector3::new(one, one, one);
/// # let scene = Scene { camera, light: Lamp { direction, ambient: Light(9000), diffuse: Light(50_000) } };
/// # let mut frame = Frame::<BinaryColor, Rows, _>::with_array([0; 512], 64, 64)?;
/// # let mut target = Dithered::new(&mut frame, Levels::ONE_BIT);
/// # let mut vertices = [MeshVertex::EMPTY; 24];
/// # let Assembly::Triangles(list) = CUBE.assembly() else { return Ok(()) };
/// # let arrays = TreeArrays::<12, 12, 0>::build(Triangles::new(CUBE.positions(), list), Choice::best_of(5))?;
///
/// let tree: Tree = arrays.tree();
/// let mut workspace = Workspace { vertices: &mut vertices, hidden: &mut Convex };
/// let cube = TreeInstance { instance: Instance::new(CUBE, Matrix::IDENTITY), tree };
/// draw_tree(&cube, &scene, &mut workspace, &mut target)?;
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
pub fn draw_tree<S, B, L, H, T>(
    TreeInstance { instance, tree }: &TreeInstance<'_, S, B>,
    scene: &Scene<L>,
    workspace: &mut Workspace<'_, H>,
    target: &mut T,
) -> Result<(), DrawError<T::Error>>
where
    S: Shading,
    B: Bounds,
    L: Lighting,
    H: Hidden,
    T: Target<Color = S::Color>,
{
    let Some(surface) = prepared(instance, scene, workspace.vertices)? else { return Ok(()) };
    let mut fragments = Fragments::new(surface.viewport, workspace.hidden, target);
    let eye = eye::eye(&instance.placement.then(&scene.camera.view).then(&scene.camera.projection));
    for piece in tree.back_to_front(eye) {
        draw_piece(tree, *piece, &surface, &mut fragments).map_err(DrawError::Target)?;
    }
    Ok(())
}

/// A triangle, or a piece of one, if it shows a side that is wanted.
fn draw_piece<S, I, H, T>(
    tree: &Tree<'_>,
    piece: bsp::Piece,
    surface: &Surface<'_, S, I>,
    fragments: &mut Fragments<'_, H, T>,
) -> Result<(), T::Error>
where
    S: Shading,
    I: Illumination,
    H: Hidden,
    T: Target<Color = S::Color>,
{
    let Some(corners) = tree.triangles().vertices(piece.triangle) else { return Ok(()) };
    let Some(vertices) = surface.vertices_of(corners) else { return Ok(()) };
    let face = Face { corners, number: usize::from(piece.triangle) };
    let are_projected = vertices.iter().all(|vertex| vertex.is_projected());
    let [a, b, c] = vertices.map(MeshVertex::position);
    let side = surface.faces.shows(signed_area(a, b, c));
    if are_projected && side.is_none() {
        return Ok(());
    }
    // There is room: a tree has been checked for that. Not collected, for which the linker must see it.
    let mut kept = Vec::<Cut, MOST_CUTS>::new();
    for cut in cuts(tree, piece, surface).take(MOST_CUTS) {
        let _ = kept.push(cut);
    }
    let mut draw = |triangle: &_, piece: &_| fragments.draw_within(&kept[..], surface, (triangle, piece));
    match side {
        Some(side) if are_projected => draw(&MeshTriangle { face, side }, &Piece::of_vertices(vertices)),
        _ => each_clipped(surface, face, &mut draw),
    }
}

/// What cuts a piece, on the screen.
fn cuts<S: Shading, I: Illumination>(
    tree: &Tree<'_>,
    piece: bsp::Piece,
    surface: &Surface<'_, S, I>,
) -> impl Iterator<Item = Cut> {
    let places = tree.triangles().corners(piece.triangle).unwrap_or_default();
    tree.cuts_of(piece).map(move |(plane, is_front)| {
        let corners = places.map(|place| on_screen(surface.viewport.rect(), &surface.transform.apply(place)));
        let cut = Cut::of_values(&corners, places.map(|place| plane.of_vertex(place)));
        if is_front { cut } else { cut.other() }
    })
}

/// A homogeneous place on the screen, in pixels; its `w` is twice the point's.
fn on_screen(view: Rect, point: &Point4<Clip>) -> [i64; 3] {
    let [x, y, w] = [point.x, point.y, point.w].map(|v| i64::from(v.to_bits()));
    let [left, top, right, bottom] = [view.left, view.top, view.right, view.bottom].map(i64::from);
    [w * (left + right) + x * (right - left), w * (top + bottom) - y * (bottom - top), 2 * w]
}
