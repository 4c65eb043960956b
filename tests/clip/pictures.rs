//! The figures of the lecture: lines against a window, and a concave polygon that falls apart.

use aquatint::{
    Line, Point2, Rect, SpanFn,
    clip::{cohen_sutherland, liang_barsky, sutherland_hodgman::clip_to_rectangle, window::ClipWindow},
};
use embedded_graphics::geometry::Point;
use heapless::Vec as List;

use super::separate::pieces;

/// Signs in rows.
struct Sheet(Vec<Vec<char>>);

impl Sheet {
    fn new(width: usize, height: usize) -> Self {
        Self(vec![vec!['.'; width]; height])
    }

    fn line(&mut self, (a, b): (Point, Point), sign: char) {
        let bounds = Rect::new(0, 0, i32::try_from(self.0[0].len()).unwrap(), i32::try_from(self.0.len()).unwrap());
        let Ok(()) = Line::new(a, b).spans(&mut SpanFn::new(bounds, |row: i32, columns: core::ops::Range<i32>, ()| {
            let row = &mut self.0[usize::try_from(row).unwrap()];
            columns.for_each(|column| row[usize::try_from(column).unwrap()] = sign);
        }));
    }

    /// The edges of a polygon with its corners on the corners of pixels.
    fn outline(&mut self, polygon: &[Point2], sign: char) {
        let pixel = |corner: Point2| Point::new(corner.x.to_num(), corner.y.to_num());
        for (&a, &b) in polygon.iter().zip(polygon.iter().cycle().skip(1)) {
            self.line((pixel(a), pixel(b)), sign);
        }
    }

    fn text(&self) -> String {
        self.0.iter().map(|row| row.iter().collect::<String>() + "\n").collect()
    }
}

/// Figure "lines to be clipped": the window is `:`, what is cut off `-`, what is left `#`.
#[test]
fn the_lines_of_the_lecture() {
    let window = Rect::new(12, 5, 36, 16);
    let lines = [
        ((15, 7), (22, 10)), // both ends inside
        ((2, 7), (9, 14)),   // both to the left
        ((20, 2), (40, 3)),  // both above
        ((28, 8), (44, 12)), // one end inside
        ((4, 10), (44, 19)), // through
        ((6, 16), (14, 20)), // past the corner
        ((32, 1), (42, 10)), // past the other corner
    ];
    let mut sheet = Sheet::new(48, 21);
    window.rows().for_each(|y| sheet.line((Point::new(window.left, y), Point::new(window.right - 1, y)), ':'));
    for (a, b) in lines.map(|(a, b)| (Point::new(a.0, a.1), Point::new(b.0, b.1))) {
        sheet.line((a, b), '-');
        let part = cohen_sutherland::clip((a, b), window);
        assert_eq!(part, liang_barsky::clip((a, b), window));
        if let Some(part) = part {
            sheet.line(part, '#');
        }
    }
    assert_eq!(sheet.text(), LINES, "\n{}", sheet.text());
}

const LINES: &str = "\
................................................
................................-...............
....................----------...-..............
..............................-----------.......
...................................-............
............::::::::::::::::::::::::-...........
............::::::::::::::::::::::::.--.........
..-.........:::##:::::::::::::::::::...-........
...-........:::::##:::::::::##::::::....-.......
....-.......:::::::##:::::::::####::.....-......
....---.....:::::::::##:::::::::::##--....-.....
......-----.::::::::::::::::::::::::..----......
.......-...-###-::::::::::::::::::::......---...
........-...:::####-::::::::::::::::............
.........-..:::::::#####::::::::::::............
............::::::::::::###--:::::::............
......-......................----...............
.......--........................-----..........
.........--...........................----......
...........--.............................---...
.............--.................................
";

/// Figure "a concave polygon to be clipped": of two towers that are joined below, the window shows the upper part.
const TOWERS: [(i32, i32); 7] = [(2, 22), (2, 2), (8, 2), (17, 18), (26, 2), (32, 2), (32, 22)];

#[test]
fn a_concave_polygon_comes_out_as_one_weird_polygon() {
    let subject = TOWERS.map(|(x, y)| Point2::corner(x, y));
    let mut clipped = List::<Point2, 19>::new();
    clip_to_rectangle(&subject, Rect::new(0, 0, 35, 12), &mut clipped).unwrap();
    let mut sheet = Sheet::new(35, 14);
    sheet.outline(&clipped, '#');
    assert_eq!(sheet.text(), WEIRD, "\n{}", sheet.text());
}

const WEIRD: &str = "\
...................................
...................................
..#######.................#######..
..#......#...............#......#..
..#......#...............#......#..
..#.......#.............#.......#..
..#.......#.............#.......#..
..#........#...........#........#..
..#........#..........#.........#..
..#.........#.........#.........#..
..#.........#........#..........#..
..#..........#.......#..........#..
..###############################..
...................................
";

#[test]
fn a_concave_polygon_comes_out_as_separate_polygons() {
    let subject = TOWERS.map(|(x, y)| Point2::corner(x, y));
    let window = ClipWindow::<Point2>::from(Rect::new(0, 0, 35, 12));
    let mut sheet = Sheet::new(35, 14);
    for (piece, sign) in pieces(&[&subject], &window.half_planes()).iter().zip('A'..) {
        sheet.outline(piece, sign);
    }
    assert_eq!(sheet.text(), SEPARATE, "\n{}", sheet.text());
}

const SEPARATE: &str = "\
...................................
...................................
..AAAAAAA.................BBBBBBB..
..A......A...............B......B..
..A......A...............B......B..
..A.......A.............B.......B..
..A.......A.............B.......B..
..A........A...........B........B..
..A........A..........B.........B..
..A.........A.........B.........B..
..A.........A........B..........B..
..A..........A.......B..........B..
..AAAAAAAAAAAA......BBBBBBBBBBBBB..
...................................
";
