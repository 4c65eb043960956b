//! What clipping in space looks like.

use aquatint::{
    Clip, HalfSpace, Matrix, Point2, Point3, Point4, Polygon, Rect, Rule, Scalar, SpanFn, Vector3, View,
    clip::{sutherland_hodgman_3d, volume::Volume},
    geometry::viewport::Viewport,
    raster::scan::ActiveEdge,
};
use heapless::Vec;

use super::exact::Overdraw;

const SCREEN: Rect = Rect::new(0, 0, 24, 12);

/// A lens of 90°, from 1 to 9.
fn lens() -> Matrix<View, Clip> {
    let rows = [[0.5, 0.0, 0.0, 0.0], [0.0, 1.0, 0.0, 0.0], [0.0, 0.0, -1.25, -2.25], [0.0, 0.0, -1.0, 0.0]];
    Matrix::from_rows(rows.map(|row| row.map(|v: f64| Scalar::from_num(v))))
}

/// A polygon as it is seen, cut by half-spaces.
fn picture(corners: &[[i32; 3]], sides: &[HalfSpace<View>]) -> String {
    let planes: std::vec::Vec<_> = sides.iter().map(|side| side.in_clip_space(&lens()).unwrap()).collect();
    let place = |&[x, y, z]: &[i32; 3]| {
        let [x, y, z] = [x, y, z].map(Scalar::from_num);
        lens().transform_point(Point3::new(x, y, z))
    };
    let mut polygon: Vec<Point4<Clip>, 16> = corners.iter().map(place).collect();
    let mut spare = Vec::<_, 16>::new();
    sutherland_hodgman_3d::clip(&mut polygon, &mut spare, &planes, Volume::GuardBand).unwrap();
    let view = Viewport::new(SCREEN).unwrap();
    let outline: std::vec::Vec<Point2> = polygon.iter().map(|point| view.project(point).position).collect();
    let (mut pixels, mut edges) = (Overdraw::new(SCREEN), Vec::<ActiveEdge, 16>::new());
    let mut sink = SpanFn::new(SCREEN, |row, columns, ()| pixels.add(row, columns));
    let contours = [&outline[..]];
    Polygon::new(&contours).unwrap().spans(Rule::NonZero, &mut edges, &mut sink).unwrap();
    pixels.picture()
}

#[test]
fn the_floor_goes_on_below_the_eye() {
    // A floor one below the eye, from 8 behind it to 8 in front.
    let floor = [[-4, -1, 8], [4, -1, 8], [4, -1, -8], [-4, -1, -8]];
    let expected = "\
........................
........................
........................
........................
........................
........................
........................
......############......
..####################..
########################
########################
########################
";
    assert_eq!(picture(&floor, &[]), expected);
}

#[test]
fn a_plate_cut_by_two_half_spaces() {
    let plate = [[-4, -2, -3], [4, -2, -3], [4, 2, -3], [-4, 2, -3]];
    let side = |x: i32, y: i32, offset: i32| {
        let [x, y, offset] = [x, y, offset].map(Scalar::from_num);
        HalfSpace::new(Vector3::new(x, y, Scalar::ZERO), offset).unwrap()
    };
    let expected = "\
........................
........................
......##########........
.......#########........
........########........
.........#######........
..........######........
...........#####........
............####........
.............###........
........................
........................
";
    assert_eq!(picture(&plate, &[side(1, 1, 1), side(-1, 0, 2)]), expected);
}
