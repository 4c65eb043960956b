//! Wireframes: the edges of a mesh, as lines that know their depth. Lecture 2.4, 3.5.3 and 5.6.
//!
//! ```text
//!   Faces::Both             Faces::Front            on faces pushed back
//!       ●────────●              ●────────●              ●────────●
//!     ╱ │      ╱ │            ╱        ╱ │            ╱░░░░░░░░╱▒│
//!    ●────────●  │           ●────────●  │           ●────────●▒▒│
//!    │  ●─────│──●           │        │  ●           │▓▓▓▓▓▓▓▓│▒▒●
//!    │ ╱      │ ╱            │        │ ╱            │▓▓▓▓▓▓▓▓│▒╱
//!    ●────────●              ●────────●              ●────────●
//! ```

use core::ops::Range;

use super::{
    Bounds, ClippedTriangle, DrawError, Instance, Scene, Workspace,
    fragments::{DepthBias, Fragments},
    prepared,
    surface::Surface,
    vertex::{ClipVertex, MeshVertex},
};
use crate::{
    clip::{liang_barsky_3d, volume::Volume},
    colour::Light,
    fragment::shade::LineShading,
    geometry::{
        face::{Side, signed_area},
        light::Lighting,
        viewport::{ScreenPoint, fine},
    },
    hidden::Hidden,
    illumination::Illumination,
    model::assembly::Face,
    num::{saturate_u32, to_16_15},
    raster::ramp_line::RampLine,
    space::{Point2, Rect},
    span::Sink,
    target::Target,
    vary::Ramp,
};

/// Draws the edges of the triangles that show a side which is wanted, as lines of single pixels.
///
/// Each pixel of a line is tested and remembered as one of a face is, at the depth of the line moved by the material's
/// [bias](DepthBias). [`Gouraud`](crate::fragment::shade::Gouraud) gives a line the light from end to end,
/// [`Plain`](crate::fragment::shade::Plain) one colour; [`Fogged`](crate::fragment::shade::Fogged) lines grow dim with the distance.
///
/// - Of a solid by itself that is convex, the front faces have no hidden edges: [`Convex`](crate::hidden::convex::Convex)
///   does.
/// - **Hidden lines** are removed by faces in the depth buffer. Draw them first with [`draw_mesh`](super::draw_mesh), with the bias
///   [`BEHIND_LINES`](DepthBias::BEHIND_LINES): on [`Unpainted`](super::Unpainted), so that only lines are seen; or on the same target, in their shading or in
///   the colour of the paper, and the lines stand on them.
/// - **Polygons** of an [assembly](crate::model::assembly::Assembly::Polygons) are outlined, without the diagonals that make
///   triangles of them. Of triangles, all edges are drawn.
/// - **Drawn how often.** An edge between two faces that are both drawn is drawn for each of them: the same pixels, at the
///   same depths, in the same light if they show the same side. A depth buffer that asks for what is strictly [nearer](crate::hidden::depth::Nearer) and
///   remembers it lets the second go. Without one, a colour that is mixed or inverted is so twice.
///
/// An edge that leaves the view is clipped before the perspective divide, to the guard band and not to the window, so bands and
/// windows have the pixels of the whole.
///
/// Memory: as [`draw_mesh`](super::draw_mesh). Cost: vertices as there; three divisions a line, some additions a pixel.
///
/// ```
/// use aquatint::{
///     Angle, Frame, Matrix, Model, Rows, World,
///     fragment::shade::Plain,
///     hidden::convex::Convex,
///     model::solids::DODECAHEDRON,
///     pipeline::{Instance, Material, MeshVertex, Workspace, draw_wireframe},
/// };
/// use embedded_graphics::pixelcolor::BinaryColor;
/// # use aquatint::{Light, Rect, Scalar, Vector3, View, pipeline::{Camera, Scene}};
/// # use aquatint::geometry::{light::Lamp, projection::Lens, viewport::Viewport};
/// # use embedded_graphics::{geometry::Point, image::GetPixel};
/// # let [nil, one] = [0, 1].map(Scalar::from_num);
/// # let field_of_view = Angle::from_degrees(39.0);
/// # let lens = Lens { field_of_view, aspect: Scalar::from_num(1.5), near: one, far: one * 8 };
/// # let camera = Camera {
/// #     view: Matrix::<World, View>::translation(nil, nil, Scalar::from_num(-3)),
/// #     projection: Matrix::perspective(lens).unwrap(),
/// #     viewport: Viewport::new(Rect::new(0, 0, 27, 18)).unwrap(),
/// # };
/// # let light = Lamp { direction: Vector3::new(nil, one, one), ambient: Light(0), diffuse: Light(60_000) };
/// # let scene = Scene { camera, light };
///
/// let mut frame = Frame::<BinaryColor, Rows, _>::with_array([0; 72], 27, 18).unwrap();
/// let turned = Matrix::<Model, World>::rotation_y(Angle::from_degrees(20.0));
/// let solid = Instance::new(DODECAHEDRON, turned).with_material(Material::new(Plain(BinaryColor::On)));
/// let mut workspace = Workspace { vertices: &mut [MeshVertex::EMPTY; 20], hidden: &mut Convex };
/// draw_wireframe(&solid, &scene, &mut workspace, &mut frame).unwrap();
/// # let sign = |color| if color == Some(BinaryColor::On) { '#' } else { '.' };
/// # let row = |y| (0..27).map(|x| sign(frame.pixel(Point::new(x, y)))).collect::<String>();
/// # let picture: Vec<_> = (0..18).map(row).collect();
/// assert_eq!(picture, [
///     "..........###..............",
///     "..........#..#####.........",
///     ".........##.......##.......",
///     "........#..####....##......",
///     ".......##......####.#......",
///     ".......#.........#...#.....",
///     "......#..........#...#.....",
///     "......#..........#...#.....",
///     ".....#...........#...#.....",
///     ".....#...........#...##....",
///     "......#..........#...#.....",
///     "......#..........#...#.....",
///     ".......#.........#...#.....",
///     ".......##......####.#......",
///     "........#..####....##......",
///     ".........##.......##.......",
///     "..........#..#####.........",
///     "..........###..............",
/// ]);
/// ```
///
/// # Errors
/// [`DrawError`].
pub fn draw_wireframe<S, B, L, H, T>(
    instance: &Instance<'_, S, B>,
    scene: &Scene<L>,
    workspace: &mut Workspace<'_, H>,
    target: &mut T,
) -> Result<(), DrawError<T::Error>>
where
    S: LineShading,
    B: Bounds,
    L: Lighting,
    H: Hidden,
    T: Target<Color = S::Color>,
{
    let Some(surface) = prepared(instance, scene, workspace.vertices)? else { return Ok(()) };
    let mut fragments = Fragments::new(surface.viewport, workspace.hidden, target);
    draw_edges(&surface, &mut fragments).map_err(DrawError::Target)
}

/// The outlines of all faces that show a side that is wanted.
fn draw_edges<S, I, H, T>(surface: &Surface<'_, S, I>, fragments: &mut Fragments<'_, H, T>) -> Result<(), T::Error>
where
    S: LineShading,
    I: Illumination,
    H: Hidden,
    T: Target<Color = S::Color>,
{
    let (mut faces, mut before) = (surface.mesh.faces().peekable(), None);
    while let Some(Face { corners, number }) = faces.next() {
        // The triangles of a polygon are a fan: the first has its first edge, the last has its last one.
        let is_first = before.replace(number) != Some(number);
        let is_last = faces.peek().is_none_or(|next| next.number != number);
        let Some(side) = shown(surface, corners) else { continue };
        let [a, b, c] = corners;
        for (edge, is_outline) in [([a, b], is_first), ([b, c], true), ([c, a], is_last)] {
            if is_outline {
                draw_edge(surface, edge, side, fragments)?;
            }
        }
    }
    Ok(())
}

/// The side that a triangle shows, if it is wanted.
fn shown<S: LineShading, I: Illumination>(surface: &Surface<'_, S, I>, corners: [u16; 3]) -> Option<Side> {
    let vertices = corners.map(|index| surface.vertex(index));
    if vertices.iter().all(MeshVertex::is_projected) {
        let [a, b, c] = vertices.each_ref().map(MeshVertex::position);
        return surface.faces.shows(signed_area(a, b, c));
    }
    shown_by_pieces(surface, corners)
}

/// Before the divide it may seem to be the other side: what is left of the triangle tells.
#[inline(never)]
fn shown_by_pieces<S: LineShading, I: Illumination>(surface: &Surface<'_, S, I>, corners: [u16; 3]) -> Option<Side> {
    let mut polygon = ClippedTriangle::from(
        corners.map(|index| ClipVertex { point: surface.transform.apply(surface.position(index)), attributes: [] }),
    );
    surface.clip(&mut polygon, &mut ClippedTriangle::new());
    let [first, rest @ ..] = &polygon[..] else { return None };
    let place = |vertex: &ClipVertex<[u16; 0]>| surface.project(&vertex.point).position;
    let areas = rest.windows(2).map(|pair| match pair {
        [second, third] => signed_area(place(first), place(second), place(third)),
        _ => 0,
    });
    surface.faces.shows(areas.sum())
}

/// An end of a line on the screen; its depth has 31 bits.
#[derive(Clone, Copy)]
struct End {
    position: Point2,
    depth: u32,
    light: Light,
}

fn draw_edge<S, I, H, T>(
    surface: &Surface<'_, S, I>,
    edge: [u16; 2],
    side: Side,
    fragments: &mut Fragments<'_, H, T>,
) -> Result<(), T::Error>
where
    S: LineShading,
    I: Illumination,
    H: Hidden,
    T: Target<Color = S::Color>,
{
    let end = |index| {
        let (vertex, corner) = (surface.vertex(index), surface.corner(index, side));
        vertex.is_projected().then(|| {
            let light = surface.shading.seen(surface.shading.end(&corner), surface.w(index));
            End { position: vertex.position(), depth: vertex.depth(), light }
        })
    };
    let [a, b] = edge;
    let Some(ends) = end(a).zip(end(b)).or_else(|| clipped_ends(surface, edge, side)) else { return Ok(()) };
    let depths = moved(surface.bias, ends);
    let [a, b] =
        [(ends.0, depths[0]), (ends.1, depths[1])].map(|(end, depth)| (end.position, [depth, to_16_15(end.light.0)]));
    // The guard band is well within the range of lines.
    let Ok(line) = RampLine::fine([a, b]) else { return Ok(()) };
    line.spans(&mut Pen { shading: surface.shading, fragments })
}

/// The ends of the part of an edge that may be projected.
#[inline(never)]
fn clipped_ends<S, I>(surface: &Surface<'_, S, I>, edge: [u16; 2], side: Side) -> Option<(End, End)>
where
    S: LineShading,
    I: Illumination,
{
    let [a, b] = edge.map(|index| {
        let corner = surface.corner(index, side);
        ClipVertex { point: surface.transform.apply(corner.position), attributes: [surface.shading.end(&corner).0] }
    });
    let line = liang_barsky_3d::clip_to((a, b), surface.planes)?;
    let (a, b) = liang_barsky_3d::clip(line, Volume::GuardBand)?;
    let end = |vertex: &ClipVertex<[u16; 1]>| {
        let ScreenPoint { position, depth } = surface.project(&vertex.point);
        let [light] = vertex.attributes;
        End { position, depth: fine(depth), light: surface.shading.seen(Light(light), vertex.point.w) }
    };
    Some((end(&a), end(&b)))
}

/// The depths of both ends with the bias, whose slope is that along the line.
fn moved(bias: DepthBias, (a, b): (End, End)) -> [u32; 2] {
    let depths = [a.depth, b.depth];
    if bias == DepthBias::NONE {
        return depths;
    }
    let distance = |of: fn(Point2) -> i32| of(a.position).abs_diff(of(b.position));
    let sixteenths = distance(|place| place.x.to_bits()).max(distance(|place| place.y.to_bits()));
    let steepness = (u64::from(a.depth.abs_diff(b.depth)) << 4).checked_div(sixteenths.into()).unwrap_or(0);
    bias.moved(depths, saturate_u32(steepness))
}

/// One line on its way to the target: its depth and its light.
struct Pen<'p, 'f, S, H, T> {
    shading: &'p S,
    fragments: &'p mut Fragments<'f, H, T>,
}

impl<S, H, T> Sink<Ramp<2>> for Pen<'_, '_, S, H, T>
where
    S: LineShading,
    H: Hidden,
    T: Target<Color = S::Color>,
{
    type Error = T::Error;

    #[inline]
    fn bounds(&self) -> Rect {
        self.fragments.bounds
    }

    #[inline]
    fn span(&mut self, row: i32, columns: Range<i32>, carried: Ramp<2>) -> Result<(), T::Error> {
        let ([depth, light], [deeper, lighter]) = (carried.fine(), carried.steps());
        let (depth, light) = (Ramp::new([depth], [deeper]), Ramp::new([light], [lighter]));
        let Fragments { hidden, target, .. } = &mut *self.fragments;
        let start = columns.start;
        hidden.split(row, columns, depth, |part| {
            let light = light.clone().skipped(start.abs_diff(part.start));
            self.shading.paint_line((row, part), light, *target)
        })
    }
}
