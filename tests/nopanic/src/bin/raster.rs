//! Lines, strokes, dashes, shapes of every kind, area averaging and floods.
#![no_std]
#![no_main]

use core::{convert::Infallible, hint::black_box, ops::Range};

use aquatint::{
    Alpha, AntialiasedStyle, Blended, Cap, Chord, Circle, Connectivity, Coverage, CoverageMask, Covered, Dashed,
    DdaLine, Ellipse, FillStyle, Flatten, Flood, Frame, InPlace, Join, Line, Outline, Oval, Oversampled, Path, Pen,
    Placed, Point2, Polygon, Polyline, RampLine, Region, RoundedRectangle, Rows, Rule, Sector, Segment, Sink, SpanFn,
    Stipple, Stroke, StrokeStyle, Stroked, SvgPath, Triangle, curve,
    cut::Cut,
    pixel_bounds,
    raster::{
        area::{self, AreaEdge, Scratch},
        flood::{Run, words_needed},
        scan::{self, ActiveEdge},
    },
    vary::{Ramp, Vertex},
};
use embedded_graphics::{
    geometry::Point,
    image::GetPixel,
    pixelcolor::{BinaryColor, Gray4},
    prelude::*,
    primitives::{self, StrokeAlignment, StyledDimensions, StyledDrawable},
    transform::Transform,
};
use heapless::Vec;
use nopanic::{any, side, keep, lent, part, text};

#[cortex_m_rt::entry]
fn main() -> ! {
    lines();
    rounds();
    paths();
    polygons();
    ovals();
    svg();
    curves();
    areas();
    triangles();
    floods();
    primitives();
    loop {}
}

fn sink() -> impl Sink<Error = Infallible> {
    SpanFn::new(any(), |row: i32, columns: Range<i32>, ()| keep((row, columns)))
}

fn soft_sink() -> impl for<'c> Sink<Covered<'c>, Error = Infallible> {
    SpanFn::new(any(), |row: i32, columns: Range<i32>, covered: Covered<'_>| keep((row, columns, covered.at(any()))))
}

/// Draws with any style on a frame.
fn styled<S, D>(shape: &D, style: &S)
where
    D: StyledDrawable<S, Color = BinaryColor> + StyledDimensions<S>,
{
    let mut bytes = [0; 64];
    let Ok(mut frame) = Frame::<BinaryColor, Rows, _>::new(lent(&mut bytes), side(), side()) else { return };
    keep(shape.draw_styled(style, &mut frame).is_ok());
    keep(shape.styled_bounding_box(style));
}

fn soft<D: StyledDrawable<AntialiasedStyle<Gray4>, Color = Alpha<Gray4>>>(shape: &D) {
    let mut bytes = [0; 64];
    let Ok(mut frame) = Frame::<Gray4, Rows, _>::new(lent(&mut bytes), side(), side()) else { return };
    let style = AntialiasedStyle::fill(Gray4::new(any())).with_stroke(Gray4::new(any()), any()).with_shape(stroke());
    let style = black_box(style.with_rule(black_box(Rule::NonZero)).with_curve(black_box(Default::default())));
    keep(shape.draw_styled(&style, &mut Blended::new(&mut frame)).is_ok());
}

fn stroke() -> Stroke {
    let stroke = if any() { Stroke::new(any()) } else { Stroke::of_width(any()) };
    stroke.with_join(black_box(Join::Miter { limit: 4 })).with_cap(black_box(Cap::Butt))
}

fn stroke_style() -> StrokeStyle<BinaryColor> {
    StrokeStyle::new(black_box(BinaryColor::On)).with_width(any()).with_stroke(stroke())
}

fn fill_style() -> FillStyle<BinaryColor> {
    FillStyle::new(black_box(BinaryColor::On)).with_rule(black_box(Rule::EvenOdd))
}

fn lines() {
    let line = Line::new(any(), any());
    keep((line.spans(&mut sink()), line.stroke_spans(stroke(), &mut sink())));
    keep((line.bounding_box(), line.translate(any())));
    styled(&line, &stroke_style());
    let dda = DdaLine::new(any(), any());
    keep((dda.spans(&mut sink()), dda.bounding_box()));
    styled(&dda, &stroke_style());
    let stippled = Stipple::new(any()).times(any()).along(line);
    keep((stippled.spans(&mut sink()), stippled.bounding_box()));
    styled(&stippled, &stroke_style());
    let end = || Vertex { position: any(), attributes: any::<[u16; 2]>() };
    if let Ok(line) = RampLine::new([end(), end()]) {
        let mut sink = SpanFn::new(any(), |row: i32, columns: Range<i32>, ramp: Ramp<2>| keep((row, columns, ramp)));
        keep(line.spans(&mut sink));
    }
}

fn rounds() {
    let (circle, ellipse) = (Circle::new(any(), any()), Ellipse::new(any(), any()));
    let alignment = black_box(StrokeAlignment::Center);
    keep((circle.spans(&mut sink()), circle.stroke_spans(any(), alignment, &mut sink()), circle.contains(any())));
    keep((ellipse.spans(&mut sink()), ellipse.stroke_spans(any(), alignment, &mut sink()), ellipse.contains(any())));
    keep((Circle::with_center(any(), any()), Ellipse::with_center(any(), any()), Ellipse::from(circle)));
    styled(&circle, &fill_style());
    styled(&circle, &stroke_style());
    styled(&ellipse, &fill_style());
    styled(&ellipse, &stroke_style());
    keep((circle.bounding_box(), ellipse.bounding_box(), circle.translate(any()), ellipse.translate(any())));
}

/// All that any outline can do.
fn outline<O: Outline>(outline: &O) {
    let (mut edges, rule) = (Vec::<ActiveEdge, 16>::new(), black_box(Rule::NonZero));
    keep(scan::fill(outline, rule, &mut edges, &mut sink()));
    keep((pixel_bounds(outline), scan::peak_edges(outline), scan::contains(outline, rule, any())));
    let (mut edges, mut cells) = (Vec::<AreaEdge, 12>::new(), [Coverage::NONE; 64]);
    let scratch = Scratch { edges: &mut edges, cells: lent(&mut cells) };
    keep(area::fill(outline, rule, scratch, &mut soft_sink()));
    strokes(outline);
}

fn strokes<O: Outline>(outline: &O) {
    let stroked = Stroked::new(outline, stroke());
    keep(stroked.spans(&mut Vec::<ActiveEdge, 16>::new(), &mut sink()));
    keep(stroked.spans_of_pieces(&mut sink()));
    let lengths = [any(); 6];
    let dashed = Dashed::new(outline, part(&lengths), any()).within(any());
    styled(&dashed, &stroke_style());
    soft(&dashed);
    keep(dashed.bounding_box());
}

fn segments() -> [Segment; 6] {
    let arc = Oval::circle(any(), any()).map_or(Segment::Close, |oval| Segment::Arc(oval.arc(any(), any())));
    let curve = [Segment::QuadTo(any(), any()), Segment::CubicTo(any(), any(), any())];
    [Segment::MoveTo(any()), Segment::LineTo(any()), curve[0], curve[1], arc, Segment::Close]
}

fn paths() {
    let segments = segments();
    let Ok(path) = Path::new(part(&segments)) else { return };
    outline(&path);
    traced(&path);
    styled(&path, &fill_style());
    soft(&path);
    keep(path.styled_bounding_box(&AntialiasedStyle::stroke(Gray4::new(any()), any())));
    let placed = Placed::new(path, any());
    traced(&placed.translate(any()));
    styled(&placed, &fill_style());
}

/// What differs from outline to outline: how it is traced. The rest is that of a path.
fn traced<O: Outline + Dimensions + ContainsPoint>(shape: &O) {
    shape.trace(&mut Kept);
    shape.trace_fine(&mut Kept);
    keep((shape.bounding_box(), shape.contains(any())));
}

fn polygons() {
    let corners = [any::<Point2>(); 8];
    let contours = [part(&corners), part(&corners)];
    let Ok(polygon) = Polygon::new(part(&contours)) else { return };
    traced(&polygon);
    styled(&polygon, &fill_style());
    let mut edges = Vec::<ActiveEdge, 16>::new();
    keep(polygon.spans(black_box(Rule::EvenOdd), &mut edges, &mut sink()));
    let (Ok(open), Ok(closed)) = (Polyline::new(part(&corners)), Polyline::closed(part(&corners))) else { return };
    strokes(&open);
    closed.trace_fine(&mut Kept);
    keep((open.bounding_box(), closed.bounding_box()));
    let Ok(rounded) = RoundedRectangle::new(any(), any()) else { return };
    traced(&rounded.with_radii(any()));
    keep(rounded.radii());
}

fn ovals() {
    let Ok(oval) = Oval::new(any(), any()) else { return };
    traced(&oval);
    let arc = oval.arc(any(), any());
    traced(&arc);
    traced(&Chord(arc));
    traced(&Sector(arc));
    styled(&oval, &fill_style());
    keep(arc.start_point());
}

fn svg() {
    match SvgPath::new(text()) {
        Ok(path) => {
            traced(&path.with_map(any()).scaled(any()));
            styled(&path, &fill_style());
            keep(path.translate(any()).bounding_box());
        }
        Err(error) => keep((error.offset, error.problem)),
    }
}

struct Kept;

impl Pen for Kept {
    fn move_to(&mut self, point: Point2) {
        keep(point);
    }

    fn line_to(&mut self, point: Point2) {
        keep(point);
    }

    fn close(&mut self) {
        keep(());
    }
}

fn curves() {
    curve::quadratic(&mut Kept, any());
    curve::cubic(&mut Kept, any());
    let mut kept = Kept;
    let mut pen = Flatten::new(&mut kept);
    pen.move_to(any());
    pen.line_to(any());
    pen.quad_to(any(), any());
    pen.cubic_to(any(), any(), any());
    if let Ok(oval) = Oval::new(any(), any()) {
        pen.arc(&oval.arc(any(), any()));
    }
    pen.close();
}

fn areas() {
    let mut bytes = [0; 64];
    let Some(mut mask) = CoverageMask::new(lent(&mut bytes), any()) else { return };
    let (mut edges, mut cells) = (Vec::<AreaEdge, 12>::new(), [Coverage::NONE; 64]);
    let segments = segments();
    let Ok(path) = Path::new(part(&segments)) else { return };
    let scratch = Scratch { edges: &mut edges, cells: lent(&mut cells) };
    keep(area::fill(&path, black_box(Rule::NonZero), scratch, &mut mask));
    keep((mask.bytes().len(), mask.spans(any(), &mut soft_sink())));
    mask.clear();
    let mut soft = soft_sink();
    let mut fine = Oversampled::new(lent(&mut cells), &mut soft);
    keep(fine.span(any(), any()..any(), ()));
    keep(scan::fill(&path, Rule::NonZero, &mut Vec::<ActiveEdge, 16>::new(), &mut fine));
    keep(fine.finish());
}

fn triangles() {
    let corner = || Vertex { position: any(), attributes: any::<[u16; 2]>() };
    if let Ok(triangle) = Triangle::new([corner(), corner(), corner()]) {
        let mut sink = SpanFn::new(any(), |row: i32, columns: Range<i32>, ramp: Ramp<2>| keep((row, columns, ramp)));
        keep(triangle.spans(&mut sink));
    }
    let cuts = [Cut::of_edge(any(), any()), Cut::of_values(&any(), any())];
    keep((cuts[0].other(), cuts[1].keeps(any(), any()), cuts[1].keep(any(), any()..any())));
}

fn floods() {
    let (mut bytes, mut memory, mut queue) = ([0; 64], [0; 64], [Run::default(); 8]);
    let Ok(mut frame) = Frame::<Gray4, Rows, _>::new(lent(&mut bytes), side(), side()) else { return };
    keep((words_needed(any(), any()), frame.pixel(any())));
    let (color, by) = (Gray4::new(any()), black_box(Connectivity::Four));
    let region = if any() { Region::Boundary(any(), color) } else { Region::Flood(any()) };
    let mut flood = Flood::new(lent(&mut memory), lent(&mut queue)).with_connectivity(by);
    keep(flood.fill(&mut frame, any::<Point>(), color).is_ok());
    let mut flood = flood.with_window(any());
    keep((flood.fill(&mut frame, region, color).is_ok(), flood.fill_with(&mut frame, region, color).is_ok()));
    if let Ok(found) = flood.search(&frame, region) {
        keep(found.spans(&mut sink()));
    }
    let mut in_place = InPlace::new(lent(&mut queue)).with_connectivity(by);
    keep(in_place.fill(&mut frame, region, color).is_ok());
    keep(in_place.with_window(any()).fill(&mut frame, region, color).is_ok());
}

/// Those of embedded-graphics, antialiased.
fn primitives() {
    soft(&primitives::Line::new(any(), any()));
    soft(&primitives::Ellipse::new(any(), any()));
    soft(&primitives::Triangle::new(any(), any(), any()));
    soft(&primitives::Rectangle::new(any(), any()));
    soft(&primitives::RoundedRectangle::with_equal_corners(any(), any()));
    let points = [any::<Point>(); 8];
    soft(&primitives::Polyline::new(part(&points)));
}
