//! Both line clippers: exact, equal to each other, in clip space and against any planes.

use aquatint::{
    ClipPlane, ClipVertex, HalfSpace, Point3, Scalar, Vector3, World,
    clip::{
        cohen_sutherland_3d,
        liang_barsky_3d::{self, clip_to},
        volume::Volume,
    },
};
use proptest::prelude::*;

use super::{oracle, places, point3, point4, vertex, vertices};

/// Coordinates and attributes as one list.
fn numbers(ClipVertex { point, attributes: [a, b] }: ClipVertex<2>) -> [i32; 6] {
    let [x, y, z, w] = [point.x, point.y, point.z, point.w].map(Scalar::to_bits);
    [x, y, z, w, i32::from(a), i32::from(b)]
}

type End = ([i32; 4], [u16; 2]);

fn is_exact((a, b): (End, End), volume: Volume) -> Result<(), TestCaseError> {
    let width = if volume == Volume::View { 1 } else { 4 };
    let (start, end) = (vertex(a), vertex(b));
    let distances = oracle::pairs(oracle::volume_distances(a.0, width), oracle::volume_distances(b.0, width));
    let expected = oracle::line_part((numbers(start), numbers(end)), distances);
    let both = |(start, end)| (numbers(start), numbers(end));
    prop_assert_eq!(liang_barsky_3d::clip((start, end), volume).map(both), expected);
    prop_assert_eq!(cohen_sutherland_3d::clip((start, end), volume).map(both), expected);
    let turned = expected.map(|(near, far)| (far, near));
    prop_assert_eq!(liang_barsky_3d::clip((end, start), volume).map(both), turned, "the same both ways");
    prop_assert_eq!(cohen_sutherland_3d::clip((end, start), volume).map(both), turned, "the same both ways");
    // Points alone are cut as vertices are.
    let points = liang_barsky_3d::clip((start.point, end.point), volume);
    prop_assert_eq!(points, liang_barsky_3d::clip((start, end), volume).map(|(a, b)| (a.point, b.point)));
    Ok(())
}

/// Lines whose ends are on two sides of the view, as far away as each other: they pass edges and corners by a hair.
fn lines_past_an_edge() -> impl Strategy<Value = (End, End)> {
    let edge = prop::array::uniform3(prop_oneof![Just(-1), Just(1), Just(4)]);
    (edge, 8192..400_000_i32, prop::array::uniform4(-300_000..300_000_i32), prop::array::uniform4(-1..=1_i32), 1..4_i32)
        .prop_map(|([x, y, z], w, away, hair, far)| {
            let on_edge = [x * w, y * w, z * w, w];
            let place = |sign: i32, times: i32, hair: [i32; 4]| {
                core::array::from_fn(|i| on_edge[i] + sign * times * away[i] + hair[i])
            };
            ((place(-1, 1, [0; 4]), [0, 9]), (place(1, far, hair), [u16::MAX, 9]))
        })
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(20_000))]

    #[test]
    fn both_clippers_are_exact(a in vertices(), b in vertices(), is_view in any::<bool>()) {
        is_exact((a, b), if is_view { Volume::View } else { Volume::GuardBand })?;
    }

    #[test]
    fn lines_that_pass_an_edge_by_a_hair_are_judged_exactly(line in lines_past_an_edge(), is_view in any::<bool>()) {
        is_exact(line, if is_view { Volume::View } else { Volume::GuardBand })?;
    }

    #[test]
    fn what_is_left_is_in_the_view(a in vertices(), b in vertices()) {
        if let Some((start, end)) = cohen_sutherland_3d::clip((vertex(a), vertex(b)), Volume::View) {
            prop_assert!(Volume::View.is_inside(&start.point) && Volume::View.is_inside(&end.point));
        }
    }

    #[test]
    fn lines_in_clip_space_against_any_planes(
        a in places(), b in places(), planes in prop::collection::vec(prop::array::uniform4(-1_i32 << 29..=1 << 29), 0..6),
    ) {
        let distance = |place: [i32; 4], plane: &[i32; 4]| {
            place.iter().zip(plane).map(|(&v, &c)| i128::from(v) * i128::from(c)).sum::<i128>()
        };
        let distances: Vec<_> = planes.iter().map(|plane| (distance(a, plane), distance(b, plane))).collect();
        let planes: Vec<_> = planes.iter().map(|c| ClipPlane::new(c.map(Scalar::from_bits)).expect("in range")).collect();
        let bits = |(a, b)| (numbers(ClipVertex { point: a, attributes: [0; 2] }), numbers(ClipVertex { point: b, attributes: [0; 2] }));
        let expected = oracle::line_part((a, b), distances);
        let [x, y] = [clip_to((point4(a), point4(b)), &planes), clip_to((point4(b), point4(a)), &planes).map(|(b, a)| (a, b))];
        prop_assert_eq!(x, y, "the same both ways");
        let first_four = |[x, y, z, w, ..]: [i32; 6]| [x, y, z, w];
        prop_assert_eq!(x.map(bits).map(|(a, b)| (first_four(a), first_four(b))), expected);
    }

    #[test]
    fn lines_in_the_world_against_any_half_spaces(
        a in places(), b in places(),
        planes in prop::collection::vec((prop::array::uniform3(-1_i32 << 29..=1 << 29), places(), any::<bool>()), 0..6),
    ) {
        let ([ax, ay, az, _], [bx, by, bz, _]) = (a, b);
        let (a, b) = ([ax, ay, az], [bx, by, bz]);
        let (mut distances, mut sides) = (vec![], vec![]);
        for (normal, [x, y, z, _], is_opposite) in planes {
            let through = [x, y, z];
            let sign = if is_opposite { -1 } else { 1 };
            let distance = |place: [i32; 3]| {
                sign * (0..3).map(|i| i128::from(normal[i]) * (i128::from(place[i]) - i128::from(through[i]))).sum::<i128>()
            };
            distances.push((distance(a), distance(b)));
            let [x, y, z] = normal.map(Scalar::from_bits);
            let side = HalfSpace::through(point3(through), Vector3::<World>::new(x, y, z)).expect("in range");
            sides.push(if is_opposite { side.opposite() } else { side });
            prop_assert_eq!(sides.last().map(|side| side.contains(point3(a))), Some(distance(a) >= 0));
        }
        let bits = |p: Point3<World>| [p.x, p.y, p.z].map(Scalar::to_bits);
        let part = clip_to((point3(a), point3(b)), &sides).map(|(a, b)| (bits(a), bits(b)));
        prop_assert_eq!(part, oracle::line_part((a, b), distances));
    }

    #[test]
    fn outcodes_that_are_wrong_do_no_harm(a in vertices(), b in vertices(), codes in any::<(u8, u8)>()) {
        let _ = cohen_sutherland_3d::clip_with((vertex(a), vertex(b)), codes, Volume::View);
    }
}

#[test]
fn the_cases_of_the_lecture() {
    let one = 1 << 16;
    let line = |a: [i32; 4], b: [i32; 4]| {
        let whole = |[x, y, z, w]: [i32; 4]| point4([x * one, y * one, z * one, w * one]);
        let part = cohen_sutherland_3d::clip((whole(a), whole(b)), Volume::View);
        assert_eq!(liang_barsky_3d::clip((whole(a), whole(b)), Volume::View), part);
        part.map(|(a, b)| [a, b].map(|p| [p.x, p.y, p.z, p.w].map(|v| v.to_num::<f64>())))
    };
    let same = [[0.0, 1.0, -2.0, 3.0], [1.0, 1.0, 1.0, 1.0]];
    assert_eq!(line([0, 1, -2, 3], [1, 1, 1, 1]), Some(same), "inside");
    assert_eq!(line([2, 0, 0, 1], [9, 1, 0, 1]), None, "both to the right");
    assert_eq!(line([0, 0, 0, 2], [4, 0, 0, 2]), Some([[0.0, 0.0, 0.0, 2.0], [2.0, 0.0, 0.0, 2.0]]), "one end");
    assert_eq!(line([-3, 0, 1, 1], [5, 0, 1, 1]), Some([[-1.0, 0.0, 1.0, 1.0], [1.0, 0.0, 1.0, 1.0]]), "through");
    assert_eq!(line([-3, 0, 0, 1], [0, 3, 0, 1]), None, "past the edge");
    assert_eq!(line([-2, 0, 0, 1], [0, 2, 0, 1]), Some([[-1.0, 1.0, 0.0, 1.0]; 2]), "through the edge itself");
    assert_eq!(line([0, 0, 0, 1], [0, 0, 0, -7]), Some([[0.0, 0.0, 0.0, 1.0], [0.0, 0.0, 0.0, 0.125]]), "past the eye");
    assert_eq!(line([0, 0, 0, 0], [5, 0, 0, 0]), None, "in the plane of the eye");
}
