//! Triangles, each with three vertices of its own, so that a vertex tells its triangle.

use core::f64::consts::TAU;

use aquatint::{
    hidden::bsp::{Arena, BuildError, Choice, Node, Piece, Split, Tree, Triangles},
    model::mesh::Mesh,
};

use super::exact::Random;

const BUNNY: Mesh<'static> = include!("../../examples/assets/bunny.rs");

/// Triangles that own their arrays.
#[derive(Clone, Debug, Default)]
pub struct Shape {
    pub name: &'static str,
    pub positions: Vec<[i16; 3]>,
    pub normals: Vec<[i8; 3]>,
    pub triangles: Vec<[u16; 3]>,
}

/// Memory for a tree.
pub struct Memory {
    nodes: Vec<Node>,
    pieces: Vec<Piece>,
    cuts: Vec<Split>,
}

impl Memory {
    pub fn new([nodes, pieces, cuts]: [usize; 3]) -> Self {
        Self { nodes: vec![Node::EMPTY; nodes], pieces: vec![Piece::EMPTY; pieces], cuts: vec![Split::EMPTY; cuts] }
    }

    pub fn arena(&mut self) -> Arena<'_> {
        Arena::new(&mut self.nodes, &mut self.pieces, &mut self.cuts)
    }

    /// The tree of a shape; it passes its own checks.
    pub fn build<'a>(&'a mut self, shape: &'a Shape, candidates: usize) -> Result<Tree<'a>, BuildError> {
        self.build_by(shape, Choice::best_of(candidates))
    }

    /// The same, the choice in full.
    pub fn build_by<'a>(&'a mut self, shape: &'a Shape, choice: Choice) -> Result<Tree<'a>, BuildError> {
        let tree = self.arena().build(shape.list(), choice)?;
        Tree::new(tree.triangles(), tree.nodes(), tree.pieces(), tree.cuts()).expect("a right tree");
        Ok(tree)
    }
}

/// Room for anything.
pub const LARGE: [usize; 3] = [32_768, 65_535, 65_535];

impl Shape {
    pub fn of(name: &'static str, triangles: impl IntoIterator<Item = [[i16; 3]; 3]>) -> Self {
        let mut shape = Self { name, ..Self::default() };
        for corners in triangles {
            let first = u16::try_from(shape.positions.len()).expect("few");
            shape.positions.extend(corners);
            shape.normals.extend([normal(corners); 3]);
            shape.triangles.push([first, first + 1, first + 2]);
        }
        shape
    }

    pub fn list(&self) -> Triangles<'_> {
        Triangles::new(&self.positions, &self.triangles)
    }

    pub fn mesh(&self) -> Mesh<'_> {
        Mesh::new(&self.positions, &self.normals, &self.triangles).expect("a mesh")
    }

    pub fn corners(&self, triangle: usize) -> [[i16; 3]; 3] {
        self.triangles[triangle].map(|vertex| self.positions[usize::from(vertex)])
    }

    /// One of the triangles alone.
    pub fn only(&self, triangle: usize) -> Self {
        Self::of(self.name, [self.corners(triangle)])
    }
}

#[expect(clippy::cast_possible_truncation, reason = "a float-to-int cast saturates")]
fn normal([a, b, c]: [[i16; 3]; 3]) -> [i8; 3] {
    let way = |to: [i16; 3]| [0, 1, 2].map(|axis| f64::from(to[axis]) - f64::from(a[axis]));
    let ([bx, by, bz], [cx, cy, cz]) = (way(b), way(c));
    let normal = [by * cz - bz * cy, bz * cx - bx * cz, bx * cy - by * cx];
    let length = normal.iter().map(|v| v * v).sum::<f64>().sqrt().max(1.0);
    normal.map(|v| (v / length * 127.0).round() as i8)
}

#[expect(clippy::cast_possible_truncation, reason = "a float-to-int cast saturates")]
fn place(place: [f64; 3]) -> [i16; 3] {
    place.map(|v| (v * 16_384.0).round() as i16)
}

pub fn of_mesh(name: &'static str, mesh: &Mesh<'_>) -> Shape {
    let corners = |triangle: [u16; 3]| triangle.map(|vertex| mesh.positions()[usize::from(vertex)]);
    Shape::of(name, mesh.triangles().map(corners))
}

pub fn bunny() -> Shape {
    of_mesh("bunny", &BUNNY)
}

/// Two triangles each for `across` × `around` quads of a closed surface of `(u, v)`, both from 0 to 1.
fn surface(name: &'static str, (around, across): (u32, u32), at: impl Fn(f64, f64) -> [f64; 3]) -> Shape {
    let corner =
        |i: u32, j: u32| place(at(f64::from(i % around) / f64::from(around), f64::from(j) / f64::from(across)));
    let quads = (0..around).flat_map(|i| (0..across).map(move |j| (i, j)));
    let triangles = quads.flat_map(|(i, j)| {
        let [a, b, c, d] = [corner(i, j), corner(i + 1, j), corner(i + 1, j + 1), corner(i, j + 1)];
        [[a, b, c], [a, c, d]]
    });
    Shape::of(name, triangles.filter(|[a, b, c]| a != b && b != c && c != a))
}

pub fn torus(around: u32, across: u32) -> Shape {
    surface("torus", (around, across), |u, v| {
        let ((y, x), (up, out)) = ((u * TAU).sin_cos(), (v * TAU).sin_cos());
        let from_axis = 1.0 + 0.5 * out;
        [from_axis * x, from_axis * y, 0.5 * up]
    })
}

pub fn sphere(around: u32, across: u32) -> Shape {
    surface("sphere", (around, across), |u, v| {
        let ((y, x), (out, up)) = ((u * TAU).sin_cos(), (v * TAU / 2.0).sin_cos());
        [out * x, out * y, -up]
    })
}

/// Triangles anywhere within 1, of about some size.
pub fn soup(name: &'static str, count: usize, size: i32, random: &mut Random) -> Shape {
    let mut near = |around: i32, reach: i32| {
        let v = around + random.below(2 * reach + 1) - reach;
        i16::try_from(v.clamp(-20_000, 20_000)).expect("small")
    };
    let triangles = (0..count).map(|_| {
        let middle = [0; 3].map(|zero| i32::from(near(zero, 16_384)));
        [(); 3].map(|()| middle.map(|v| near(v, size)))
    });
    Shape::of(name, triangles.collect::<Vec<_>>())
}

/// Triangles that all reach through the middle of each other.
pub fn crossing(count: usize, random: &mut Random) -> Shape {
    soup("crossing", count, 16_384, random)
}
