//! All commands, against segments by hand.

use aquatint::{Affine, Path, Scalar, Segment};
use embedded_graphics::{geometry::Point, transform::Transform};

use super::{at, coarse, fine, path};

#[test]
fn absolute_and_relative_commands_are_the_same() {
    let pairs = [
        ("M3 4L5 6L1 2", "m3 4l2 2l-4-4"),
        ("M3 4L5 6 1 2", "m3 4 2 2-4-4"),
        ("M3 4L5 6M7 8L9 9", "m3 4l2 2m2 2l2 1"),
        ("M3 4L5 6ZM5 5L9 9", "m3 4l2 2zm2 1l4 4"),
        ("M3 4H9V8H1z", "m3 4h6v4h-8z"),
        ("M3 4H9 5V8 9", "m3 4h6-4v4 1"),
        ("M3 4C5 6 7 8 9 1S2 3 4 5 8 8 1 1", "m3 4c2 2 4 4 6-3s-7 2-5 4 4 3-3-4"),
        ("M3 4Q9 6 7 8T2 3 1 9", "m3 4q6 2 4 4t-5-5-1 6"),
        ("M3 4A5 6 30 0 1 9 9 5 6 30 1 0 1 2", "m3 4a5 6 30 0 1 6 5 5 6 30 1 0-8-7"),
        ("M3 4a1 1 0 01.5.5", "M3 4 a 1 , 1 , 0 , 0 , 1 , 0.5 , 0.5"),
        ("M.5-.25L.5.75", "M 0.5,-25e-2 L+5E-1 0.75e0"),
        ("M3 4S5 6 7 8T1 2", "M3 4C3 4 5 6 7 8Q7 8 1 2"),
        ("M3 4C5 6 7 8 9 1T1 2S5 6 7 8", "M3 4C5 6 7 8 9 1Q9 1 1 2C1 2 5 6 7 8"),
        ("M3 4Q5 6 7 8Z T1 2", "M3 4Q5 6 7 8Z Q3 4 1 2"),
        ("M3 4A0 6 30 0 1 9 9", "M3 4L9 9"),
        ("M3 4A-5-6 30 0 1 9 9", "M3 4A5 6 30 0 1 9 9"),
        ("M3 4L9 9A5 5 0 0 1 9 9", "M3 4L9 9"),
        ("M3 4A5 6 390 0 1 9 9", "M3 4A5 6-330 0 1 9 9"),
    ];
    for (one, other) in pairs {
        assert_eq!(coarse(&path(one)), coarse(&path(other)), "{one} and {other}");
        assert_eq!(fine(&path(one)), fine(&path(other)), "{one} and {other}");
    }
}

#[test]
fn relative_steps_do_not_drift() {
    // 0.1 is 6554 parts of 65536, a little more; and that a thousand times.
    let data = "M0 0".to_owned() + &"h.1v.1".repeat(1000);
    let traced = fine(&path(&data));
    assert_eq!(traced.contours[0].last(), Some(&(25_602, 25_602)));
}

#[test]
fn curves_are_cut_for_the_size_at_which_they_are_drawn() {
    let icon = path("M1 1Q20 3 4 23.3");
    let times = |by: i32| icon.scaled(Scalar::from_num(by));
    let corners = [(1.0, 1.0), (20.0, 3.0), (4.0, 23.3)];
    #[expect(clippy::cast_possible_truncation, reason = "small")]
    let [from, control, to] =
        corners.map(|(x, y): (f64, f64)| at((x * 640.0).round() as i32, (y * 640.0).round() as i32));
    let segments = [Segment::MoveTo(from), Segment::QuadTo(control, to)];
    assert_eq!(coarse(&times(40)), coarse(&Path::new(&segments).expect("in range")));
    assert!(coarse(&times(40)).contours[0].len() >= 5 * coarse(&times(1)).contours[0].len());
    // A fine trace is one that is sixteen times as large.
    assert_eq!(fine(&times(3)), coarse(&times(48)));
}

#[test]
fn maps_and_moves_are_applied_before_anything_is_rounded() {
    let icon = path("M.01 .02L3.51 2.03");
    let large = icon.with_map(Affine::scale(Scalar::from_num(100), Scalar::from_num(200)));
    assert_eq!(coarse(&large).contours, [[(16, 64), (5616, 6496)]]);
    let mut moved = large;
    assert_eq!(moved.translate_mut(Point::new(2, -3)), &large.translate(Point::new(2, -3)));
    assert_eq!(coarse(&moved).contours, [[(48, 16), (5648, 6448)]]);
    assert_eq!(fine(&moved).contours, [[(768, 256), (90_368, 103_168)]]);
}

#[test]
fn what_does_not_fit_sixteen_times_as_large_is_enlarged() {
    let far = path("M0 0Q30000 0 20000 30000").scaled(Scalar::from_num(100));
    let enlarged: Vec<_> = coarse(&far).contours[0].iter().map(|&(x, y)| (16 * x, 16 * y)).collect();
    assert_eq!(fine(&far).contours, [enlarged]);
    let near = path("M0 0Q30000 0 20000 30000").scaled(Scalar::from_num(8));
    assert!(fine(&near).contours[0].iter().any(|(x, _)| x % 16 != 0));
}
