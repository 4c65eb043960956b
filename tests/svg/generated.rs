//! Paths of random commands, written in random ways: against segments, and against another parser.

use aquatint::{Path, Segment, SvgError, SvgPath, SvgProblem};
use proptest::{collection::vec, prelude::*, sample::select};
use svgtypes::{SimplePathSegment, SimplifyingPathParser};

use super::{Contour, Recorder, at, coarse, fine};

/// A segment of whole sixteenths, and how it is written.
#[derive(Clone, Copy, Debug)]
struct Written {
    letter: usize,
    is_relative: bool,
    /// Repeats the letter where it could be left out.
    is_long: bool,
    points: [(i32, i32); 3],
}

fn written() -> impl Strategy<Value = Written> {
    let point = (-4000..4000_i32, -4000..4000_i32);
    (0..9_usize, any::<bool>(), any::<bool>(), [point.clone(), point.clone(), point])
        .prop_map(|(letter, is_relative, is_long, points)| Written { letter, is_relative, is_long, points })
}

/// A number, so that it ends where another begins.
fn number(sixteenths: i32, separator: &str) -> String {
    let exact = f64::from(sixteenths) / 16.0;
    let text = exact.to_string();
    let short = if text.starts_with("0.") { text[1..].to_owned() } else { text };
    if short.starts_with('-') && separator == " " { short } else { separator.to_owned() + &short }
}

/// Writes a path as text, and as segments.
struct Writer {
    text: String,
    segments: Vec<Segment>,
    begin: (i32, i32),
    last: (i32, i32),
    cubic: Option<(i32, i32)>,
    quad: Option<(i32, i32)>,
    before: String,
}

impl Writer {
    fn write(&mut self, step: Written, separator: &str) {
        let letter =
            if self.segments.is_empty() { "M" } else { ["M", "L", "H", "V", "C", "S", "Q", "T", "Z"][step.letter] };
        let (lower, last) = (letter.to_lowercase(), self.last);
        let verb = if step.is_relative { lower.clone() } else { letter.to_owned() };
        let is_repeated = self.before == verb && verb.to_lowercase() != "z";
        let mut arguments = vec![];
        let base = if step.is_relative { last } else { (0, 0) };
        let mut give = |(x, y): (i32, i32)| arguments.extend([x - base.0, y - base.1]);
        let reflected = |control: Option<(i32, i32)>| control.map_or(last, |(x, y)| (2 * last.0 - x, 2 * last.1 - y));
        let [a, b, c] = step.points;
        let (mut cubic, mut quad) = (None, None);
        let point = |(x, y): (i32, i32)| at(x, y);
        let (segment, to) = match letter {
            "M" => (Segment::MoveTo(point(a)), a),
            "L" => (Segment::LineTo(point(a)), a),
            "H" => (Segment::LineTo(at(a.0, last.1)), (a.0, last.1)),
            "V" => (Segment::LineTo(at(last.0, a.1)), (last.0, a.1)),
            "C" => {
                give(a);
                give(b);
                cubic = Some(b);
                (Segment::CubicTo(point(a), point(b), point(c)), c)
            }
            "S" => {
                give(b);
                cubic = Some(b);
                (Segment::CubicTo(point(reflected(self.cubic)), point(b), point(c)), c)
            }
            "Q" => {
                give(b);
                quad = Some(b);
                (Segment::QuadTo(point(b), point(c)), c)
            }
            "T" => {
                quad = Some(reflected(self.quad));
                (Segment::QuadTo(point(reflected(self.quad)), point(c)), c)
            }
            _ => (Segment::Close, self.begin),
        };
        match letter {
            "H" => arguments.push(to.0 - base.0),
            "V" => arguments.push(to.1 - base.1),
            "Z" => {}
            _ => give(to),
        }
        if letter == "M" {
            self.begin = to;
        }
        let has_verb = step.is_long || !is_repeated;
        self.text += if has_verb { &verb } else { "" };
        for (index, argument) in arguments.into_iter().enumerate() {
            let is_first = index == 0 && has_verb;
            self.text += &number(argument, if is_first { " " } else { separator });
        }
        self.segments.push(segment);
        (self.last, self.cubic, self.quad) = (to, cubic, quad);
        // Behind a move, an edge needs no letter.
        self.before = if lower == "m" { if step.is_relative { "l" } else { "L" }.to_owned() } else { verb };
    }
}

/// The same of another parser, in 256ths; without arcs.
fn of_svgtypes(data: &str) -> Option<Vec<Segment>> {
    #[expect(clippy::cast_possible_truncation, reason = "in range")]
    let at = |x: f64, y: f64| at((x * 256.0).round() as i32, (y * 256.0).round() as i32);
    let segments = SimplifyingPathParser::from(data).map(|segment| {
        Some(match segment.ok()? {
            SimplePathSegment::MoveTo { x, y } => Segment::MoveTo(at(x, y)),
            SimplePathSegment::LineTo { x, y } => Segment::LineTo(at(x, y)),
            SimplePathSegment::Quadratic { x1, y1, x, y } => Segment::QuadTo(at(x1, y1), at(x, y)),
            SimplePathSegment::CurveTo { x1, y1, x2, y2, x, y } => Segment::CubicTo(at(x1, y1), at(x2, y2), at(x, y)),
            SimplePathSegment::ClosePath => Segment::Close,
        })
    });
    segments.collect()
}

fn are_near(one: &Recorder, other: &Recorder) -> bool {
    let near = |(a, b): (&(i32, i32), &(i32, i32))| a.0.abs_diff(b.0) <= 1 && a.1.abs_diff(b.1) <= 1;
    let is_same = |(one, other): (&Contour, &Contour)| {
        let ends = [one.first().zip(other.first()), one.last().zip(other.last())];
        // Control points that are rounded may make a curve one power of two finer.
        ends.into_iter().flatten().all(near) && (one.len() != other.len() || one.iter().zip(other).all(near))
    };
    one.contours.len() == other.contours.len()
        && one.closed == other.closed
        && one.contours.iter().zip(&other.contours).all(is_same)
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(3000))]

    #[test]
    fn a_path_of_text_is_the_same_as_one_of_segments(
        steps in vec(written(), 1..12), separator in select(vec![" ", ",", " , ", "\n\t", ", "]),
    ) {
        let (text, segments) = (String::new(), vec![]);
        let mut writer = Writer { text, segments, begin: (0, 0), last: (0, 0), cubic: None, quad: None, before: String::new() };
        for &step in &steps {
            writer.write(step, separator);
        }
        let (svg, segments) = (SvgPath::new(&writer.text), Path::new(&writer.segments).expect("in range"));
        let svg = svg.map_err(|error| TestCaseError::fail(format!("{}: {error}", writer.text)))?;
        prop_assert_eq!(coarse(&svg), coarse(&segments), "{}", writer.text);
        prop_assert_eq!(fine(&svg), fine(&segments), "{}", writer.text);
        let theirs = of_svgtypes(&writer.text).expect("a path");
        prop_assert!(are_near(&fine(&svg), &coarse(&Path::new(&theirs).expect("in range"))), "{}", writer.text);
    }

    #[test]
    fn any_text_is_read_as_another_parser_does(
        pieces in vec(select(vec![
            "M", "m", "L", "l", "H", "h", "V", "v", "C", "c", "S", "s", "Q", "q", "T", "t", "Z", "z", " ", " ", ",", "-", ".",
            "+", "e1", "1e-1", "0", "1", "2 3", "4,5", "-6.25-7", "1 2 3 4", ".5.25", "x",
        ]), 0..14),
    ) {
        let data = "M 1 2".to_owned() + &pieces.concat();
        match (SvgPath::new(&data), of_svgtypes(&data)) {
            (Ok(ours), theirs) => {
                let theirs = theirs.ok_or_else(|| TestCaseError::fail(format!("{data} is no path")))?;
                prop_assert!(are_near(&fine(&ours), &coarse(&Path::new(&theirs).expect("in range"))), "{}", data);
            }
            (Err(SvgError { problem: SvgProblem::OutOfRange, .. }), _) | (Err(_), None) => {}
            // It forgives commas behind the last number, and a point behind which no digit follows.
            (Err(error), Some(_)) => {
                let before = data[..error.offset].trim_end();
                prop_assert!(before.ends_with([',', '.']) || data[error.offset..].starts_with(','), "{} {:?}", data, error);
            }
        }
    }
}
