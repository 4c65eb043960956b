//! What must be seen, in doubles and without clipping, at the centre of every pixel.
//!
//! A triangle with corners `v₀ v₁ v₂` in clip space, as columns (x, y, w) of a matrix `M`, covers the point `p` = (x, y, 1) of
//! the view where all three parts of `b = M⁻¹ p` are positive: `b` is what the corners weigh, divided by `w`. That
//! holds for corners behind the eye, too, so nothing has to be cut. `Σb` is 1/w; `Σ bᵢ aᵢ / Σb` is an attribute with its
//! perspective; `Σ bᵢ wᵢ aᵢ` is one that is linear on the screen, as Gouraud shading has it.
//! M. Olano and T. Greer, "Triangle scan conversion using 2D homogeneous coordinates", Graphics Hardware 1997.

use std::collections::HashSet;

use super::compare::NEAR;

/// Pixels across and down.
#[derive(Clone, Copy, Debug)]
pub struct View {
    pub width: usize,
    pub height: usize,
}

/// A corner in clip space, and what it carries.
#[derive(Clone, Copy, Debug)]
pub struct Corner {
    pub clip: [f64; 4],
    pub light: f64,
    /// In the world, about 1 long.
    pub normal: [f64; 3],
    pub uv: [f64; 2],
}

/// Triangles that name corners, counter-clockwise as seen from the front.
#[derive(Clone, Debug, Default)]
pub struct Solid {
    pub corners: Vec<Corner>,
    pub triangles: Vec<[usize; 3]>,
    /// The lights of each as a whole: by its own normal, and by the sum of those of its corners.
    pub flat: Vec<[f64; 2]>,
}

/// The nearest surface at the centre of a pixel.
#[derive(Clone, Copy, Debug)]
pub struct Seen {
    /// Its number among all triangles.
    pub triangle: usize,
    /// 1 at the near plane, 0 at the far one, linear in 1/w.
    pub depth: f64,
    /// That of the next surface behind it.
    pub next_depth: f64,
    /// Linear on the screen. No number can be said of a triangle that has to be cut: the pieces are linear each by
    /// itself. So it has the least and the most of its corners.
    pub light: [f64; 2],
    /// With perspective.
    pub uv: [f64; 2],
    /// The changes of depth and of light from pixel to pixel.
    pub slopes: [f64; 2],
    /// The lights of the triangle as a whole.
    pub flat: [f64; 2],
    /// Whether the triangle is one on the screen, too, because nobody has to cut it.
    pub is_whole: bool,
    /// Those of the corners.
    pub corner_normals: [[f64; 3]; 3],
    /// What of the corners arrives here, linear on the screen, and how that changes across and down.
    pub linear: [f64; 3],
    pub linear_slopes: [[f64; 3]; 2],
    /// Texture coordinates of the corners.
    pub corner_uvs: [[f64; 2]; 3],
    /// Texture coordinates on the way between the first column of a block of eight and that of the next, and how far they
    /// are off at most if corners are.
    pub chord: Option<[[f64; 2]; 2]>,
}

/// A picture.
#[derive(Clone, Debug)]
pub struct Reference {
    pub view: View,
    pub seen: Vec<Option<Seen>>,
    /// How many front faces cover each centre.
    pub layers: Vec<u32>,
    /// Pixels from each centre to the nearest edge of a front face, or to where one is cut; far is 9.
    pub edge: Vec<f64>,
    /// The same, of edges that no two front faces share.
    pub border: Vec<f64>,
}

impl Reference {
    /// Draws solids.
    pub fn new(view: View, solids: &[Solid]) -> Self {
        let pixels = view.width * view.height;
        let mut picture = Self {
            view,
            seen: vec![None; pixels],
            layers: vec![0; pixels],
            edge: vec![9.0; pixels],
            border: vec![9.0; pixels],
        };
        let mut first = 0;
        for solid in solids {
            picture.solid(solid, first);
            first += solid.triangles.len();
        }
        picture
    }

    fn solid(&mut self, solid: &Solid, first: usize) {
        let corners = |triangle: &[usize; 3]| triangle.map(|corner| solid.corners[corner]);
        let faces: Vec<_> = (first..)
            .zip(&solid.triangles)
            .filter_map(|(number, triangle)| Some((number, triangle, Face::new(corners(triangle))?)))
            .collect();
        let sides = |&[a, b, c]: &[usize; 3]| [(a, b), (b, c), (c, a)];
        let all: HashSet<_> = faces.iter().flat_map(|(_, triangle, _)| sides(triangle)).collect();
        for (number, triangle, face) in &faces {
            self.fill(*number, face, solid.flat[number - first]);
            for (from, to) in sides(triangle) {
                let ends = [from, to].map(|corner| solid.corners[corner].clip);
                self.line(ends, !all.contains(&(to, from)));
            }
            face.cuts().for_each(|ends| self.line(ends, true));
        }
    }

    /// The centre of a pixel in the view, −1 to 1.
    fn centre(&self, at: usize) -> [f64; 2] {
        let (x, y) = (float(at % self.view.width) + 0.5, float(at / self.view.width) + 0.5);
        [2.0 * x / float(self.view.width) - 1.0, 1.0 - 2.0 * y / float(self.view.height)]
    }

    /// Where it is in pixels from the corner of the view.
    fn screen(&self, [x, y, _, w]: [f64; 4]) -> [f64; 2] {
        [f64::midpoint(1.0, x / w) * float(self.view.width), f64::midpoint(1.0, -y / w) * float(self.view.height)]
    }

    /// The pixels that points may reach, with a margin.
    fn reach(&self, points: &[[f64; 2]]) -> impl Iterator<Item = usize> + use<> {
        let range = |axis: usize, length: usize| {
            let along = points.iter().map(|point| point[axis]);
            let (low, high) = (along.clone().fold(f64::MAX, f64::min), along.fold(f64::MIN, f64::max));
            whole(low - 2.0, length)..whole(high + 3.0, length)
        };
        let (columns, rows, width) = (range(0, self.view.width), range(1, self.view.height), self.view.width);
        rows.flat_map(move |y| columns.clone().map(move |x| y * width + x))
    }

    fn fill(&mut self, number: usize, face: &Face, flat: [f64; 2]) {
        let pixels: Vec<usize> = if face.corners.iter().all(|corner| corner.clip[3] > 1e-3) {
            self.reach(&face.corners.map(|corner| self.screen(corner.clip))).collect()
        } else {
            (0..self.seen.len()).collect()
        };
        let step = [2.0 / float(self.view.width), 2.0 / float(self.view.height)];
        for at in pixels {
            let place = Place { view: self.centre(at), step, into: float(at % self.view.width % 8) };
            let Some(here) = face.at(place, number).map(|seen| Seen { flat, ..seen }) else { continue };
            self.layers[at] += 1;
            let seen = &mut self.seen[at];
            let next = seen.map_or(-1.0, |other| if here.depth > other.depth { other.depth } else { here.depth });
            match seen {
                Some(other) if other.depth >= here.depth => other.next_depth = other.next_depth.max(next),
                _ => *seen = Some(Seen { next_depth: next, ..here }),
            }
        }
    }

    /// Notes how near an edge passes.
    fn line(&mut self, ends: [[f64; 4]; 2], is_border: bool) {
        let Some(ends) = in_front(ends) else { return };
        let [a, b] = ends.map(|end| self.screen(end));
        for at in self.reach(&[a, b]) {
            let centre = [float(at % self.view.width) + 0.5, float(at / self.view.width) + 0.5];
            let distance = distance(centre, a, b);
            self.edge[at] = self.edge[at].min(distance);
            if is_border {
                self.border[at] = self.border[at].min(distance);
            }
        }
    }
}

/// What is in front of the eye of an edge.
fn in_front([a, b]: [[f64; 4]; 2]) -> Option<[[f64; 4]; 2]> {
    let least = 1e-6;
    let cut =
        |inside: [f64; 4], outside: [f64; 4]| mix(inside, outside, (inside[3] - least) / (inside[3] - outside[3]));
    match (a[3] > least, b[3] > least) {
        (true, true) => Some([a, b]),
        (true, false) => Some([a, cut(a, b)]),
        (false, true) => Some([cut(b, a), b]),
        (false, false) => None,
    }
}

fn mix(a: [f64; 4], b: [f64; 4], t: f64) -> [f64; 4] {
    [0, 1, 2, 3].map(|axis| a[axis] + t * (b[axis] - a[axis]))
}

/// From a point to a segment.
fn distance([x, y]: [f64; 2], a: [f64; 2], b: [f64; 2]) -> f64 {
    let (dx, dy) = (b[0] - a[0], b[1] - a[1]);
    let length = dx * dx + dy * dy;
    let along = if length > 0.0 { (((x - a[0]) * dx + (y - a[1]) * dy) / length).clamp(0.0, 1.0) } else { 0.0 };
    (a[0] + along * dx - x).hypot(a[1] + along * dy - y)
}

#[expect(clippy::cast_precision_loss, reason = "small numbers")]
pub fn float(value: usize) -> f64 {
    value as f64
}

/// Rounded down, and inside of the view.
#[expect(clippy::cast_possible_truncation, clippy::cast_sign_loss, reason = "it is clamped")]
fn whole(value: f64, length: usize) -> usize {
    value.clamp(0.0, float(length)) as usize
}

/// The centre of a pixel in the view, the way to the next ones, and how far into a block of eight columns it is.
#[derive(Clone, Copy)]
struct Place {
    view: [f64; 2],
    step: [f64; 2],
    into: f64,
}

impl Place {
    fn beside(&self) -> [[f64; 2]; 2] {
        let [x, y] = self.view;
        [[x + self.step[0], y], [x, y + self.step[1]]]
    }
}

/// A triangle that shows its front.
struct Face {
    corners: [Corner; 3],
    /// The inverse of its matrix.
    inverse: [[f64; 3]; 3],
}

impl Face {
    fn new(corners: [Corner; 3]) -> Option<Self> {
        let [a, b, c] = corners.map(|Corner { clip: [x, y, _, w], .. }| [x, y, w]);
        let (bc, ca, ab) = (cross(b, c), cross(c, a), cross(a, b));
        let determinant = a[0] * bc[0] + a[1] * bc[1] + a[2] * bc[2];
        let inverse = [bc, ca, ab].map(|row| row.map(|v| v / determinant));
        (determinant > 0.0).then_some(Self { corners, inverse })
    }

    /// What the corners weigh at a place of the view, divided by w.
    fn weights(&self, [x, y]: [f64; 2]) -> [f64; 3] {
        self.inverse.map(|row| row[0] * x + row[1] * y + row[2])
    }

    fn depth(&self, weights: [f64; 3]) -> f64 {
        let z: f64 = weights.iter().zip(&self.corners).map(|(weight, corner)| weight * corner.clip[2]).sum();
        (1.0 - z) / 2.0
    }

    /// What the corners weigh, linear on the screen.
    fn linear(&self, weights: [f64; 3]) -> [f64; 3] {
        [0, 1, 2].map(|corner| weights[corner] * self.corners[corner].clip[3])
    }

    /// What is seen at a place, unless it is beside, before the near plane or the eye, or behind the far plane.
    fn at(&self, place: Place, triangle: usize) -> Option<Seen> {
        let weights = self.weights(place.view);
        let over_w: f64 = weights.iter().sum();
        let depth = self.depth(weights);
        if !weights.iter().all(|weight| *weight >= 0.0) || !(0.0..=1.0).contains(&depth) || over_w > 8.0 {
            return None;
        }
        let light = |weights: [f64; 3]| -> f64 {
            self.linear(weights).iter().zip(&self.corners).map(|(weight, corner)| weight * corner.light).sum()
        };
        let slope = |value: &dyn Fn([f64; 3]) -> f64| {
            let here = value(weights);
            let [across, down] = place.beside().map(|place| value(self.weights(place)) - here);
            across.hypot(down)
        };
        let slopes = [slope(&|weights| self.depth(weights)), slope(&light)];
        let is_whole = self.is_whole();
        let light = if is_whole { [light(weights); 2] } else { self.lights() };
        let linear = self.linear(weights);
        let linear_slopes = place.beside().map(|beside| {
            let beside = self.linear(self.weights(beside));
            [0, 1, 2].map(|corner| beside[corner] - linear[corner])
        });
        Some(Seen {
            triangle,
            depth,
            next_depth: -1.0,
            light,
            uv: [0, 1].map(|axis| self.uv(weights, axis)),
            slopes,
            flat: [0.0; 2],
            is_whole,
            corner_normals: self.corners.map(|corner| corner.normal),
            linear,
            linear_slopes,
            corner_uvs: self.corners.map(|corner| corner.uv),
            chord: is_whole.then(|| self.chord(place)).flatten(),
        })
    }

    fn uv(&self, weights: [f64; 3], axis: usize) -> f64 {
        let sum: f64 = weights.iter().zip(&self.corners).map(|(weight, corner)| weight * corner.uv[axis]).sum();
        sum / weights.iter().sum::<f64>()
    }

    /// Between the ends of a block, and how far off that may be.
    fn chord(&self, place: Place) -> Option<[[f64; 2]; 2]> {
        let end = |into: f64| Place { view: [place.view[0] + into * place.step[0], place.view[1]], ..place };
        let (first, last) = (end(-place.into), end(8.0 - place.into));
        let along = |[a, b]: [f64; 2]| a + (b - a) * place.into / 8.0;
        let chord = [0, 1].map(|axis| along([first, last].map(|end| self.uv(self.weights(end.view), axis))));
        let off = [0, 1].map(|axis| Some(self.uv_off(first, axis)?.max(self.uv_off(last, axis)?)));
        Some([chord, [off[0]?, off[1]?]])
    }

    /// How far off a texture coordinate is at most when corners are off by a thirty-second of a pixel each way. Beside the
    /// triangle what a corner weighs says how much its error counts. None where that may be anything.
    fn uv_off(&self, place: Place, axis: usize) -> Option<f64> {
        let weights = self.weights(place.view);
        let movement = self.linear(weights).iter().map(|weight| weight.abs()).sum::<f64>() * NEAR / 2.0;
        let over_w = |weights: [f64; 3]| weights.iter().sum::<f64>();
        let over = |weights: [f64; 3]| self.uv(weights, axis) * over_w(weights);
        let slope = |value: &dyn Fn([f64; 3]) -> f64| {
            let [across, down] = place.beside().map(|beside| value(self.weights(beside)) - value(weights));
            across.hypot(down)
        };
        let least = over_w(weights) - movement * slope(&over_w);
        let off = movement * (slope(&over) + self.uv(weights, axis).abs() * slope(&over_w)) / least;
        (least > 0.0).then_some(off)
    }

    /// The least and the most light of a corner.
    fn lights(&self) -> [f64; 2] {
        let lights = self.corners.map(|corner| corner.light);
        [lights.into_iter().fold(f64::MAX, f64::min), lights.into_iter().fold(f64::MIN, f64::max)]
    }

    /// Whether nobody has to cut it: far from the eye, between the planes, and within four times the view.
    fn is_whole(&self) -> bool {
        self.corners.iter().all(|Corner { clip: [x, y, z, w], .. }| {
            *w > 0.125 && z.abs() < *w && x.abs() < 3.99 * w && y.abs() < 3.99 * w
        })
    }

    /// Where the near plane, the far plane and that of the eye cut it.
    fn cuts(&self) -> impl Iterator<Item = [[f64; 4]; 2]> + '_ {
        let planes: [fn([f64; 4]) -> f64; 3] = [|[_, _, z, w]| w + z, |[_, _, z, w]| w - z, |[_, _, _, w]| w - 0.125];
        planes.into_iter().filter_map(|plane| self.cut(plane))
    }

    fn cut(&self, plane: fn([f64; 4]) -> f64) -> Option<[[f64; 4]; 2]> {
        let [a, b, c] = self.corners.map(|corner| corner.clip);
        let mut points = [(a, b), (b, c), (c, a)].into_iter().filter_map(|(from, to)| {
            let (before, behind) = (plane(from), plane(to));
            ((before < 0.0) != (behind < 0.0)).then(|| mix(from, to, before / (before - behind)))
        });
        Some([points.next()?, points.next()?])
    }
}

fn cross(a: [f64; 3], b: [f64; 3]) -> [f64; 3] {
    [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]]
}
