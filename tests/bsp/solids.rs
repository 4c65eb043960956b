//! Solid trees against brute force in 128 bits: places by counting faces along a ray, hits by all triangles.

use aquatint::{
    Model, Point3, Scalar,
    hidden::{
        bsp::{NONE, Tree},
        solid_bsp::{Hit, Place, SolidTree},
    },
    model::solids::{CUBE, DODECAHEDRON, ICOSAHEDRON, TETRAHEDRON},
};
use proptest::prelude::*;

use super::{
    exact::Random,
    shapes::{self, LARGE, Memory, Shape, of_mesh},
};

type Triple = [i128; 3];

fn minus(a: Triple, b: Triple) -> Triple {
    [0, 1, 2].map(|axis| a[axis] - b[axis])
}

fn cross([a, b, c]: Triple, [d, e, f]: Triple) -> Triple {
    [b * f - c * e, c * d - a * f, a * e - b * d]
}

fn dot(a: Triple, b: Triple) -> i128 {
    a.iter().zip(b).map(|(a, b)| a * b).sum()
}

fn corners(shape: &Shape, triangle: usize) -> [Triple; 3] {
    shape.corners(triangle).map(|corner| corner.map(|v| i128::from(v) * 4))
}

/// Where a segment meets a triangle, the border included: part and whole, and whether it leads to the back.
fn meets([a, b, c]: [Triple; 3], from: Triple, to: Triple) -> Option<(i128, i128, bool)> {
    let normal = cross(minus(b, a), minus(c, a));
    let [start, end] = [from, to].map(|end| dot(normal, minus(end, a)));
    if start.signum() == end.signum() {
        return None;
    }
    let along = minus(to, from);
    let sides = [(a, b), (b, c), (c, a)].map(|(p, q)| dot(along, cross(minus(p, from), minus(q, from))).signum());
    let is_inside = !(sides.contains(&1) && sides.contains(&-1));
    is_inside.then_some((start.abs(), (start - end).abs(), start > end))
}

fn first_hit(shape: &Shape, from: Triple, to: Triple) -> Option<Hit> {
    let hit = |triangle: usize| {
        let (part, whole, is_front) = meets(corners(shape, triangle), from, to)?;
        Some((part, whole, u16::try_from(triangle).expect("few"), is_front))
    };
    let nearest = (0..shape.triangles.len()).filter_map(hit).min_by(|a, b| (a.0 * b.1, a.2).cmp(&(b.0 * a.1, b.2)))?;
    let (part, whole, triangle, is_front) = nearest;
    let part = Scalar::from_bits(i32::try_from((part << 16) / whole).expect("0 to 1"));
    Some(Hit { triangle, part, is_front })
}

fn is_on(corners @ [a, b, c]: [Triple; 3], point: Triple) -> bool {
    let normal = cross(minus(b, a), minus(c, a));
    let edges = [(a, b), (b, c), (c, a)];
    let sides = edges.map(|(p, q)| dot(normal, cross(minus(q, p), minus(point, p))));
    dot(normal, minus(point, corners[0])) == 0 && sides.iter().all(|&side| side >= 0)
}

/// By the faces that a ray crosses. One that meets an edge or a corner is turned.
fn place(shape: &Shape, point: Triple) -> Place {
    let all = || (0..shape.triangles.len()).map(|triangle| corners(shape, triangle));
    if all().any(|corners| is_on(corners, point)) {
        return Place::Surface;
    }
    let (mut far, mut random) = ([400_000, 300_007, 100_003], Random(1));
    loop {
        let along = minus(far, point);
        let is_clear = all().all(|corners @ [a, b, c]| {
            let sides = [(a, b), (b, c), (c, a)].map(|(p, q)| dot(along, cross(minus(p, point), minus(q, point))));
            meets(corners, point, far).is_none() || !sides.contains(&0)
        });
        if is_clear {
            let count = all().filter(|corners| meets(*corners, point, far).is_some()).count();
            return if count % 2 == 1 { Place::Inside } else { Place::Outside };
        }
        far = far.map(|v| v + i128::from(random.below(999)));
    }
}

/// How far the nearest plane of a face is, at most.
#[expect(clippy::cast_precision_loss, reason = "as exact as it need be")]
fn nearest_plane(shape: &Shape, point: Triple) -> f64 {
    let distance = |triangle: usize| {
        let [a, b, c] = corners(shape, triangle);
        let normal = cross(minus(b, a), minus(c, a));
        dot(normal, minus(point, a)).abs() as f64 / (dot(normal, normal) as f64).sqrt() / 65_536.0
    };
    (0..shape.triangles.len()).map(distance).fold(f64::MAX, f64::min)
}

fn triple(point: [i32; 3]) -> Triple {
    point.map(i128::from)
}

fn point(point: [i32; 3]) -> Point3<Model> {
    let [x, y, z] = point.map(Scalar::from_bits);
    Point3::new(x, y, z)
}

/// Points about a shape: anywhere, on vertices and between them, on the planes of faces.
fn interesting(shape: &Shape, random: &mut Random) -> [i32; 3] {
    let count = i32::try_from(shape.positions.len()).expect("few");
    let mut vertex =
        || shape.positions[usize::try_from(random.below(count)).expect("positive")].map(|v| i32::from(v) * 4);
    let (a, b, c) = (vertex(), vertex(), vertex());
    let triangle = usize::try_from(random.below(count / 3)).expect("positive");
    let [p, q, r] = shape.corners(triangle).map(|corner| corner.map(|v| i32::from(v) * 4));
    let mix = |weights: [i32; 3], a: [i32; 3], b: [i32; 3], c: [i32; 3]| {
        [0, 1, 2].map(|axis| (a[axis] * weights[0] + b[axis] * weights[1] + c[axis] * weights[2]) / 4)
    };
    match random.below(6) {
        0 => a,
        1 => mix([2, 2, 0], a, b, c),
        2 => mix([1, 1, 2], p, q, r),
        3 => mix([2, 2, 0], p, q, r),
        4 => mix([1, 1, 2], p, q, r).map(|v| v + random.below(5) - 2),
        _ => [(); 3].map(|()| random.below(1 << 18) - (1 << 17)),
    }
}

fn all() -> Vec<Shape> {
    vec![
        of_mesh("tetrahedron", &TETRAHEDRON),
        of_mesh("cube", &CUBE),
        of_mesh("icosahedron", &ICOSAHEDRON),
        of_mesh("dodecahedron", &DODECAHEDRON),
        shapes::torus(12, 8),
        shapes::torus(7, 5),
        shapes::sphere(8, 6),
    ]
}

#[test]
fn points_are_where_brute_force_has_them() {
    for shape in all() {
        for candidates in [1, 20] {
            let (mut memory, mut random) = (Memory::new(LARGE), Random(17));
            let solid = SolidTree::new(memory.build(&shape, candidates).expect("room"));
            let (mut counts, mut off) = ([0; 3], 0);
            for _ in 0..2000 {
                let at = interesting(&shape, &mut random);
                let (found, wanted) = (solid.place(point(at)), place(&shape, triple(at)));
                if found != wanted {
                    // Splits are rounded; only one that is next to the surface may be off it, or on it.
                    assert!(found == Place::Surface || wanted == Place::Surface, "{}: {at:?}", shape.name);
                    assert!(nearest_plane(&shape, triple(at)) < 1.0 / 1_048_576.0, "{}: {at:?}", shape.name);
                    off += 1;
                }
                counts[[Place::Inside, Place::Outside, Place::Surface].iter().position(|p| *p == wanted).unwrap()] += 1;
            }
            println!("{}: {counts:?}, {off} off", shape.name);
            assert!(counts.iter().all(|count| *count > 50) && off <= 20, "{}: {counts:?}, {off} off", shape.name);
        }
    }
}

#[test]
fn segments_strike_what_brute_force_strikes() {
    for shape in all() {
        for candidates in [1, 20] {
            let (mut memory, mut random) = (Memory::new(LARGE), Random(23));
            let solid = SolidTree::new(memory.build(&shape, candidates).expect("room"));
            let mut hits = 0;
            for _ in 0..3000 {
                let [from, to] = [(); 2].map(|()| interesting(&shape, &mut random));
                let wanted = first_hit(&shape, triple(from), triple(to));
                let found = solid.first_hit(point(from), point(to)).expect("near");
                assert_eq!(found, wanted, "{}: {from:?} {to:?}", shape.name);
                assert_eq!(solid.line_of_sight(point(from), point(to)), Ok(wanted.is_none()));
                hits += u32::from(wanted.is_some());
            }
            assert!((200..2990).contains(&hits), "{}: {hits}", shape.name);
        }
    }
}

#[test]
fn the_bunny_is_a_solid_enough_for_rays() {
    let (shape, mut memory, mut random) = (shapes::bunny(), Memory::new(LARGE), Random(29));
    let tree = memory.build(&shape, 5).expect("room");
    let solid = SolidTree::new(tree);
    for _ in 0..300 {
        let [from, to] = [(); 2].map(|()| interesting(&shape, &mut random));
        let found = solid.first_hit(point(from), point(to)).expect("near");
        assert_eq!(found, first_hit(&shape, triple(from), triple(to)), "{from:?} {to:?}");
    }
    assert!(tree.nodes().iter().any(|node| node.front == NONE && node.back == NONE));
}

#[test]
fn ends_beyond_the_limit_are_refused() {
    let shape = of_mesh("cube", &CUBE);
    let mut memory = Memory::new(LARGE);
    let tree: Tree<'_> = memory.build(&shape, 5).expect("room");
    let solid = SolidTree::new(tree);
    let limit = 32 << 16;
    for far in [limit, -limit, i32::MAX, i32::MIN] {
        assert!(solid.first_hit(point([0, far, 0]), point([0; 3])).is_err());
        assert!(solid.line_of_sight(point([0; 3]), point([0, 0, far])).is_err());
        assert_eq!(solid.place(point([far, 0, 0])), Place::Outside);
    }
    let far = limit - 1;
    let hit = solid.first_hit(point([far; 3]), point([-far; 3])).expect("in range");
    assert_eq!(hit, first_hit(&shape, [i128::from(far); 3], [-i128::from(far); 3]));
    assert!(hit.is_some_and(|hit| hit.is_front));
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(500))]
    /// Triangles anyhow are no solid, but segments strike them.
    #[test]
    fn soups_are_struck(seed in 1..u32::MAX, ends in prop::array::uniform2(prop::array::uniform3(-140_000..140_000_i32))) {
        let shape = shapes::crossing(6, &mut Random(seed));
        let mut memory = Memory::new(LARGE);
        let solid = SolidTree::new(memory.build(&shape, 3).expect("room"));
        let [from, to] = ends;
        let found = solid.first_hit(point(from), point(to)).expect("near");
        prop_assert_eq!(found, first_hit(&shape, triple(from), triple(to)));
    }
}
