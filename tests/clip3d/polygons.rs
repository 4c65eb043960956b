//! Polygons in clip space: what is kept, how many vertices there are, and that shared edges stay shared.

use aquatint::{
    Clip, ClipPlane, ClipVertex, Frustum, Matrix, Point3, Scalar, World,
    clip::{
        sutherland_hodgman::{self, Pipeline, Stage},
        sutherland_hodgman_3d::clip,
        volume::Volume,
        window::Boundary,
    },
};
use heapless::Vec;
use proptest::prelude::*;

use super::{places, vertex, vertices};

/// Room for a triangle or a convex quadrilateral, four planes and the volume.
type List = Vec<ClipVertex<2>, 15>;

fn plane() -> impl Strategy<Value = ClipPlane> {
    let coefficients = prop::array::uniform4(-1_i32 << 29..=1 << 29);
    coefficients.prop_map(|c| ClipPlane::new(c.map(Scalar::from_bits)).expect("in range"))
}

fn planes(most: usize) -> impl Strategy<Value = std::vec::Vec<ClipPlane>> {
    prop::collection::vec(plane(), 0..=most)
}

fn clipped(polygon: &[ClipVertex<2>], planes: &[ClipPlane], volume: Volume) -> List {
    let mut list = List::from_slice(polygon).expect("room");
    clip(&mut list, &mut List::new(), planes, volume).expect("room");
    list
}

/// A triangle whose attributes are the weights of its first two corners, of a scene's size.
fn weighed_triangle() -> impl Strategy<Value = [ClipVertex<2>; 3]> {
    prop::array::uniform3(prop::array::uniform4(-500_000..500_000_i32))
        .prop_map(|[a, b, c]| [vertex((a, [50_000, 0])), vertex((b, [0, 50_000])), vertex((c, [0, 0]))])
}

/// By how much, at least, a place is to the left of all edges of a polygon.
fn left_of_all(polygon: &[ClipVertex<2>], (x, y): (f64, f64)) -> f64 {
    let place = |v: &ClipVertex<2>| (f64::from(v.attributes[0]) / 50_000.0, f64::from(v.attributes[1]) / 50_000.0);
    let edges = polygon.iter().zip(polygon.iter().cycle().skip(1)).map(|(a, b)| (place(a), place(b)));
    let beside = edges.map(|((ax, ay), (bx, by))| (bx - ax) * (y - ay) - (by - ay) * (x - ax));
    beside.fold(f64::MAX, f64::min)
}

/// The vertices in an order of their own.
fn sorted(list: &[ClipVertex<2>]) -> std::vec::Vec<String> {
    let mut keys: std::vec::Vec<_> = list.iter().map(|v| format!("{v:?}")).collect();
    keys.sort();
    keys
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(8_000))]

    #[test]
    fn a_boundary_adds_one_vertex_at_most_to_a_convex_polygon(
        corners in prop::array::uniform3(vertices()), is_triangle in any::<bool>(), planes in planes(4), is_view in any::<bool>(),
    ) {
        let mut polygon = corners.map(vertex).to_vec();
        if !is_triangle {
            // A parallelogram: its corners are in one plane, exactly.
            let [a, b, c] = corners.map(|(place, _)| place.map(|v| v / 4));
            let fourth = core::array::from_fn(|i| a[i] + c[i] - b[i]);
            polygon = [a, b, c, fourth].map(|place| vertex((place, [7, 7]))).to_vec();
        }
        let volume = if is_view { Volume::View } else { Volume::GuardBand };
        let kept = clipped(&polygon, &planes, volume);
        prop_assert!(kept.len() <= polygon.len() + planes.len() + 7, "{} vertices", kept.len());
    }

    #[test]
    fn what_is_kept_is_what_is_inside(
        triangle in weighed_triangle(), planes in planes(2), weights in prop::array::uniform3(1..100_u16),
    ) {
        let kept = clipped(&triangle, &planes, Volume::GuardBand);
        let sum: f64 = weights.iter().map(|&w| f64::from(w)).sum();
        let [p, q, r] = weights.map(|w| f64::from(w) / sum);
        prop_assume!([p, q, r].iter().all(|&w| w > 0.01));
        // Distances are linear, too.
        let inside = |boundary: &dyn Boundary<ClipVertex<2>>| {
            let [a, b, c] = triangle.each_ref().map(|v| boundary.distance(v) as f64);
            let most = a.abs().max(b.abs()).max(c.abs()).max(1.0);
            (p * a + q * b + r * c) / most
        };
        let faces = Volume::GuardBand.faces();
        let depth = faces.iter().map(|face| inside(face)).chain(planes.iter().map(|plane| inside(plane))).fold(f64::MAX, f64::min);
        let left = left_of_all(&kept, (p, q));
        if depth > 0.01 {
            prop_assert!(!kept.is_empty() && left > -1e-4, "{left} inside");
        } else if depth < -0.01 {
            prop_assert!(kept.is_empty() || left < 1e-4, "{left} outside");
        }
    }

    #[test]
    fn a_cut_is_the_same_from_both_ends_after_every_plane(a in vertices(), b in vertices(), planes in planes(4)) {
        // An edge there and back: what is cut out of one way is cut out of the other.
        let mut edge = Vec::<ClipVertex<2>, 4>::from_slice(&[vertex(a), vertex(b)]).expect("room");
        let mut next = Vec::<ClipVertex<2>, 4>::new();
        let faces = Volume::GuardBand.faces();
        let boundaries = planes.iter().map(|p| p as &dyn Boundary<_>).chain(faces.iter().map(|f| f as &dyn Boundary<_>));
        for boundary in boundaries {
            sutherland_hodgman::clip(&edge, |v| boundary.distance(v), &mut next).expect("room");
            edge.clear();
            for &vertex in &next {
                if !edge.contains(&vertex) {
                    edge.push(vertex).expect("room");
                }
            }
            prop_assert!(edge.len() <= 2, "{:?}", edge);
        }
    }

    #[test]
    fn turned_round_it_is_the_same_polygon(corners in prop::array::uniform3(vertices()), planes in planes(3)) {
        let [a, b, c] = corners.map(vertex);
        let kept = clipped(&[a, b, c], &planes, Volume::GuardBand);
        prop_assert_eq!(sorted(&kept), sorted(&clipped(&[b, a, c], &planes, Volume::GuardBand)));
    }

    #[test]
    fn stages_in_a_row_give_what_lists_give(
        corners in prop::array::uniform3(vertices()), planes in prop::collection::vec(plane(), 3), is_view in any::<bool>(),
    ) {
        let (mut list, mut next) = (List::from_slice(&corners.map(vertex)).expect("room"), List::new());
        for plane in &planes {
            sutherland_hodgman::clip(&list, |v| plane.distance(v), &mut next).expect("room");
            core::mem::swap(&mut list, &mut next);
        }
        let mut stages: std::vec::Vec<_> = planes.into_iter().map(Stage::new).collect();
        let mut between = List::new();
        Pipeline::new(&mut stages).clip(&corners.map(vertex), |v| between.push(v)).expect("room");
        // They begin at different vertices.
        prop_assert_eq!(sorted(&list), sorted(&between));

        let volume = if is_view { Volume::View } else { Volume::GuardBand };
        for face in volume.faces() {
            sutherland_hodgman::clip(&list, |v| face.distance(v), &mut next).expect("room");
            core::mem::swap(&mut list, &mut next);
        }
        let (mut stages, mut given) = (volume.faces().map(Stage::new), List::new());
        Pipeline::new(&mut stages).clip(&between, |v| given.push(v)).expect("room");
        prop_assert_eq!(sorted(&list), sorted(&given));
    }

    #[test]
    fn what_is_kept_can_be_divided_by_w(corners in prop::array::uniform3(vertices()), planes in planes(3)) {
        for vertex in &clipped(&corners.map(vertex), &planes, Volume::GuardBand) {
            let [x, y, z, w] = [vertex.point.x, vertex.point.y, vertex.point.z, vertex.point.w].map(|v| i64::from(v.to_bits()));
            prop_assert!(w >= 1 << 13, "w is {w}");
            // Rounded to the nearest after each boundary: a unit or two beside it.
            prop_assert!(z.abs() <= w + 2 && x.abs().max(y.abs()) <= 4 * w + 5, "{x} {y} {z} {w}");
        }
    }

    #[test]
    fn a_polygon_behind_the_eye_is_gone(corners in prop::array::uniform3(places())) {
        let behind = corners.map(|[x, y, z, w]| vertex(([x, y, z, w.min(8191)], [0; 2])));
        prop_assert!(clipped(&behind, &[], Volume::GuardBand).is_empty());
    }
}

#[test]
fn a_triangle_with_corners_behind_the_eye() {
    let one = 1 << 16;
    let corner = |x: i32, z: i32, w: i32| vertex(([x * one, 0, z * one, w * one], [0, 0]));
    // One corner in front of the eye, one behind it, one in its plane.
    let kept = clipped(&[corner(0, 0, 1), corner(0, 0, -1), corner(1, 0, 0)], &[], Volume::View);
    let places: std::vec::Vec<_> =
        kept.iter().map(|v| (v.point.x.to_num::<f64>(), v.point.w.to_num::<f64>())).collect();
    assert_eq!(places, [(0.125, 0.125), (0.5, 0.5), (0.0, 1.0), (0.0, 0.125)]);
}

#[test]
fn no_room_is_said() {
    let one = 1 << 16;
    let corner = |x: i32| vertex(([x * one, 0, 0, one], [0, 0]));
    let mut list = Vec::<_, 3>::from_slice(&[corner(0), corner(3), corner(5)]).expect("room");
    assert!(clip(&mut list, &mut Vec::<_, 1>::new(), &[], Volume::View).is_err());
}

#[test]
fn a_polygon_of_the_world_against_the_sides_of_a_frustum() {
    let frustum = Frustum::new(&Matrix::<World, Clip>::IDENTITY).expect("in range");
    let corner = |x: i32, y: i32| Point3::<World>::new(Scalar::from_num(x), Scalar::from_num(y), Scalar::ZERO);
    let (mut stages, mut kept) = (frustum.sides().map(Stage::new), Vec::<_, 10>::new());
    Pipeline::new(&mut stages).clip(&[corner(0, 0), corner(3, 0), corner(0, 3)], |v| kept.push(v)).expect("room");
    let places: std::vec::Vec<_> = kept.iter().map(|v| (v.x.to_num::<i32>(), v.y.to_num::<i32>())).collect();
    assert_eq!(places, [(0, 0), (1, 0), (1, 1), (0, 1)]);
}
