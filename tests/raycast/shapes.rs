//! Each shape against doubles.

use aquatint::{
    Point3, Scalar, Vector3, World,
    hidden::raycast::{BIAS, Block, Objects, Plane, Ray, Shape, Sphere, Triangle},
};
use proptest::prelude::*;

use super::oracle::{self, ALONG, Expected, V, along, dot, length, minus, of_point, of_vector, unit};

fn point([x, y, z]: [i32; 3]) -> Point3<World> {
    let [x, y, z] = [x, y, z].map(Scalar::from_bits);
    Point3::new(x, y, z)
}

fn vector([x, y, z]: [i32; 3]) -> Vector3<World> {
    let [x, y, z] = [x, y, z].map(Scalar::from_bits);
    Vector3::new(x, y, z)
}

fn double(place: [i32; 3]) -> V {
    place.map(|v| f64::from(v) / 65_536.0)
}

/// Places of a small scene, and of all the world.
fn places() -> impl Strategy<Value = [i32; 3]> {
    let world = 64 << 16;
    prop_oneof![
        3 => prop::array::uniform3(-200_000..200_000_i32),
        2 => prop::array::uniform3(-world..=world),
        1 => prop::array::uniform3((-3..=3_i32).prop_map(|v| v << 16)),
    ]
}

/// Directions of any length, some along axes, of 30 bits at most: of longer ones the last bits are cut off.
fn directions() -> impl Strategy<Value = [i32; 3]> {
    let any = (prop::array::uniform3(any::<i32>()), 2..31_u32).prop_map(|(v, by)| v.map(|v| v >> by));
    let plain = prop::array::uniform3(prop_oneof![Just(0), Just(1), Just(-1), Just(1 << 29), Just(-(1 << 29))]);
    prop_oneof![6 => any, 1 => plain].prop_filter("a direction", |v| *v != [0; 3])
}

/// Rays from a place, towards a place (which makes hits likely) or in any direction.
fn rays() -> impl Strategy<Value = (Ray, V, V)> {
    let aimed = (places(), places()).prop_map(|(from, to)| {
        let way = [0, 1, 2].map(|axis| to[axis] - from[axis]);
        (from, if way == [0; 3] { [1, 0, 0] } else { way })
    });
    prop_oneof![3 => aimed, 1 => (places(), directions())].prop_map(|(from, way)| {
        (Ray::new(point(from), vector(way)).expect("in range"), double(from), unit(double(way)))
    })
}

/// What every hit promises, and what doubles expect.
fn check(shape: Shape, (ray, origin, direction): (Ray, V, V), expected: Expected) -> Result<(), TestCaseError> {
    let shapes = [shape];
    let hit = shapes.nearest(&ray);
    prop_assert_eq!(hit.is_some(), shapes.is_hit(&ray));
    let Some(hit) = hit else {
        prop_assert!(expected.distances.is_none() || !expected.is_sure, "missed {:?}", expected);
        return Ok(());
    };
    let Some([least, most]) = expected.distances else {
        return Err(TestCaseError::fail(format!("hit {hit:?}")));
    };
    let distance: f64 = hit.distance.to_num();
    prop_assert!((least..=most).contains(&distance), "{} of {:?}", distance, expected);
    let off = length(minus(of_point(hit.position), along(origin, distance, direction)));
    prop_assert!(off < ALONG, "{} beside the ray", off);
    let normal = of_vector(hit.normal);
    prop_assert!((length(normal) - 1.0).abs() < 1.0 / 4_096.0, "{:?}", normal);
    prop_assert!(dot(normal, direction) < 1.0 / 4_096.0, "{:?} faces away", normal);
    Ok(())
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(20_000))]

    #[test]
    fn spheres((ray, origin, direction) in rays(), center in places(), radius in 1..=200_000_i32) {
        let Ok(sphere) = Sphere::new(point(center), Scalar::from_bits(radius)) else { return Ok(()) };
        let expected = oracle::sphere(double(center), f64::from(radius) / 65_536.0, origin, direction);
        check(Shape::Sphere(sphere), (ray, origin, direction), expected)?;
        if let Some(hit) = [Shape::Sphere(sphere)].nearest(&ray) {
            let out = minus(of_point(hit.position), double(center));
            prop_assert!((length(out) - f64::from(radius) / 65_536.0).abs() < ALONG, "{:?} is not on it", hit);
            let exact = unit(minus(along(origin, hit.distance.to_num(), direction), double(center)));
            let side = dot(exact, of_vector(hit.normal)).signum();
            let off = length(minus(of_vector(hit.normal), exact.map(|v| v * side)));
            let least = 1.0 / 4_096.0 + ALONG / (f64::from(radius) / 65_536.0);
            prop_assert!(off < least, "{} of {}", off, least);
        }
    }

    #[test]
    fn planes((ray, origin, direction) in rays(), place in places(), normal in directions()) {
        let plane = Plane::new(point(place), vector(normal)).expect("in range");
        check(Shape::Plane(plane), (ray, origin, direction), oracle::plane(double(place), unit(double(normal)), origin, direction))?;
    }

    #[test]
    fn blocks((ray, origin, direction) in rays(), one in places(), other in places()) {
        let block = Block::new(point(one), point(other)).expect("in range");
        let (min, max) = ([0, 1, 2].map(|i| one[i].min(other[i])), [0, 1, 2].map(|i| one[i].max(other[i])));
        check(Shape::Block(block), (ray, origin, direction), oracle::block(double(min), double(max), origin, direction))?;
    }

    #[test]
    fn triangles((ray, origin, direction) in rays(), corners in prop::array::uniform3(places())) {
        let triangle = Triangle::new(corners.map(point)).expect("in range");
        check(Shape::Triangle(triangle), (ray, origin, direction), oracle::triangle(corners.map(double), origin, direction))?;
    }

    /// Small ones, as of a fine mesh, at which the rays are aimed.
    #[test]
    fn small_triangles(from in places(), at in places(), ways in prop::array::uniform3(prop::array::uniform3(-4_000..4_000_i32))) {
        let world = 64 << 16;
        let corners = ways.map(|way| [0, 1, 2].map(|axis| (at[axis] + way[axis]).clamp(-world, world)));
        let way = [0, 1, 2].map(|axis| at[axis] - from[axis]);
        prop_assume!(way != [0; 3]);
        let ray = Ray::new(point(from), vector(way)).expect("in range");
        let triangle = Triangle::new(corners.map(point)).expect("in range");
        let (origin, direction) = (double(from), unit(double(way)));
        check(Shape::Triangle(triangle), (ray, origin, direction), oracle::triangle(corners.map(double), origin, direction))?;
    }

    /// The angle of incidence is the angle of reflection, and the mirror itself is not hit again.
    #[test]
    fn mirrors((ray, _, direction) in rays(), place in places(), normal in directions()) {
        let shapes = [Shape::Plane(Plane::new(point(place), vector(normal)).expect("in range"))];
        let Some(hit) = shapes.nearest(&ray) else { return Ok(()) };
        let normal = of_vector(hit.normal);
        let exact = along(direction, -2.0 * dot(direction, normal), normal);
        let back = ray.reflected(&hit);
        // Where it goes shows on a plane across, one unit on.
        let start = along(of_point(hit.position), BIAS.to_num(), normal);
        let at = along(start, 1.0, exact);
        prop_assume!(at.iter().all(|v| v.abs() < 63.0) && dot(direction, normal) < -0.01);
        let [x, y, z] = at.map(Scalar::from_num::<f64>);
        let [a, b, c] = exact.map(Scalar::from_num::<f64>);
        let screen = [Shape::Plane(Plane::new(Point3::new(x, y, z), Vector3::new(a, b, c)).expect("in range"))];
        let seen = screen.nearest(&back).expect("ahead");
        let off = length(minus(of_point(seen.position), at));
        prop_assert!(off < 1.0 / 2_048.0, "{} off", off);
        prop_assert!(!shapes.is_hit(&back));
    }

    /// A lamp that is near is hidden by what is before it, not by what is behind it.
    #[test]
    fn rays_between_places_end_there(from in places(), to in places(), at in 0.1..0.9_f64, behind in 1.1..1.5_f64) {
        let (start, way) = (double(from), minus(double(to), double(from)));
        prop_assume!(length(way) > 0.5);
        let ray = Ray::between(point(from), point(to)).expect("in range");
        let wall = |t: f64| {
            let [x, y, z] = along(start, t, way).map(Scalar::from_num::<f64>);
            let [a, b, c] = way.map(Scalar::from_num::<f64>);
            Plane::new(Point3::new(x, y, z), Vector3::new(a, b, c)).ok().map(Shape::Plane)
        };
        prop_assert!([wall(at).expect("between")].is_hit(&ray));
        prop_assert!(wall(behind).is_none_or(|wall| ![wall].is_hit(&ray)));
    }
}

/// Along and within the planes of the sides, and through edges and corners, where quotients are 0 / 0.
#[test]
fn rays_in_the_sides_of_a_block() {
    let whole = |place: [i32; 3]| place.map(|v| v << 16);
    let block = Block::new(point(whole([-1; 3])), point(whole([1; 3]))).expect("in range");
    let all = |most: i32| {
        let line = move || -most..=most;
        line().flat_map(move |x| line().flat_map(move |y| line().map(move |z| [x, y, z])))
    };
    let mut hits = 0;
    for (from, way) in all(2).flat_map(|from| all(1).map(move |way| (from, way))).filter(|(_, way)| *way != [0; 3]) {
        let slabs = || (0..3).map(|axis| (from[axis], way[axis]));
        let is_beside = slabs().any(|(at, step)| step == 0 && at.abs() > 1);
        let moving = || slabs().filter(|(_, step)| *step != 0);
        let entry = moving().map(|(at, step)| -1 - at * step).max().expect("a direction");
        let exit = moving().map(|(at, step)| 1 - at * step).min().expect("a direction");
        let steps = if entry > 0 { entry } else { exit };
        let expected = (!is_beside && entry <= exit && steps > 0).then_some(steps);
        let ray = Ray::new(point(whole(from)), vector(whole(way))).expect("in range");
        let hit = [Shape::Block(block)].nearest(&ray);
        let place = expected.map(|steps| point(whole([0, 1, 2].map(|axis| from[axis] + steps * way[axis]))));
        assert_eq!(hit.map(|hit| hit.position), place, "{from:?} {way:?}");
        hits += usize::from(hit.is_some());
    }
    assert!(hits > 300, "{hits}");
}
