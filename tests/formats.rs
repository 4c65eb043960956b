//! Feature `defmt`: which public types can be logged. All errors can.

use std::{collections::BTreeSet, fs, path::Path};

/// Types that are shown by `Debug` but not logged, and why. Those that lend something need no reason.
const LEFT_OUT: [(&str, &[&str]); 6] = [
    (
        "names in types, of which there are no values or values that hold nothing",
        &[
            "columns::Columns",
            "kernel::Atkinson",
            "kernel::Burkes",
            "kernel::FloydSteinberg",
            "kernel::JarvisJudiceNinke",
            "kernel::Sierra",
            "kernel::SierraLite",
            "kernel::Stucki",
            "layout::Inverted",
            "layout::LsbFirst",
            "layout::MsbFirst",
            "pages::Pages",
            "planes::Planes",
            "rows::Rows",
            "space::Clip",
            "space::Model",
            "space::View",
            "space::World",
            "unpainted::Unpainted",
            "words::Words",
        ],
    ),
    (
        "hold functions",
        &["gradient::LinearGradient", "gradient::RadialGradient", "mapped::Mapped", "shader::Shader", "span::SpanFn"],
    ),
    (
        "as long as a picture or a table",
        &[
            "codes::CodeMask",
            "frame::Frame",
            "gamma::Gamma",
            "halftone::DotGain",
            "layout::Memory",
            "mask::CoverageMask",
            "revolved::Parts",
        ],
    ),
    (
        "under way through a row, a curve or a triangle",
        &["hilbert::Hilbert", "perspective::PerspectiveRun", "shade::Placed", "slopes::Slopes", "vary::Ramp"],
    ),
    (
        "prepared from values that can be logged",
        &[
            "lights::ModelLights",
            "packing::Facts",
            "pieces::Curve",
            "ray::Ray",
            "stroke::Stroked",
            "transform::MeshTransform",
        ],
    ),
    (
        "what lent memory is made of",
        &[
            "active::ActiveFace",
            "edge::AreaEdge",
            "edge::Pieces",
            "edge::Straight",
            "hierarchy::Node",
            "object_space::ComparedFace",
            "object_space::PartBound",
            "scan::ActiveEdge",
            "separate::Node",
        ],
    ),
];

/// A public type: its name behind that of its file, whether it lends something, is shown by `Debug`, can be logged.
struct Type {
    name: String,
    lends: bool,
    is_shown: bool,
    is_logged: bool,
}

/// Files and folders below a folder of `src/`: the name of each module and its text.
fn modules(folder: &Path) -> Vec<(String, String)> {
    let mut found = vec![];
    for entry in fs::read_dir(folder).expect("a folder") {
        let path = entry.expect("an entry").path();
        let stem = |path: &Path| path.file_stem().and_then(|stem| stem.to_str()).expect("a name in ASCII").to_owned();
        if path.is_dir() {
            found.extend(modules(&path));
        } else {
            let name = if path.ends_with("mod.rs") { stem(folder) } else { stem(&path) };
            found.push((name, fs::read_to_string(path).expect("text")));
        }
    }
    found
}

/// The public types of a module, outside of macros.
fn types(module: &str, text: &str) -> Vec<Type> {
    let (mut attributes, mut found) = (String::new(), vec![]);
    for line in text.lines() {
        if line.starts_with("#[") {
            attributes += line;
            continue;
        }
        if let Some(item) = line.strip_prefix("pub struct ").or(line.strip_prefix("pub enum ")) {
            let end = item.find(|sign: char| !sign.is_alphanumeric()).unwrap_or(item.len());
            let (name, rest) = item.split_at(end);
            let by_hand = |words: &str| is_behind(text, words, name);
            found.push(Type {
                name: format!("{module}::{name}"),
                lends: rest.starts_with("<'"),
                is_shown: attributes.contains("Debug"),
                is_logged: attributes.contains("defmt::Format") || by_hand("] |it:") || by_hand("defmt::Format for"),
            });
        }
        if !line.starts_with("///") {
            attributes.clear();
        }
    }
    found
}

/// Whether a name stands somewhere behind some words.
fn is_behind(text: &str, words: &str, name: &str) -> bool {
    let ends = |rest: &str| !rest.starts_with(|sign: char| sign.is_alphanumeric());
    let behind = |at: usize| text[at + words.len()..].trim_start().strip_prefix(name);
    text.match_indices(words).any(|(at, _)| behind(at).is_some_and(ends))
}

fn all_modules() -> Vec<(String, String)> {
    modules(&Path::new(env!("CARGO_MANIFEST_DIR")).join("src"))
}

#[test]
fn what_is_shown_can_be_logged_or_is_named_here() {
    let all = all_modules();
    let types = all.iter().flat_map(|(module, text)| types(module, text));
    let left_out: BTreeSet<_> =
        types.filter(|it| it.is_shown && !it.lends && !it.is_logged).map(|it| it.name).collect();
    let named: BTreeSet<_> = LEFT_OUT.iter().flat_map(|(_, names)| names.iter().map(ToString::to_string)).collect();
    assert_eq!(left_out, named);
}

#[test]
fn all_errors_can_be_logged() {
    let mut errors = 0;
    for (module, text) in all_modules() {
        for it in types(&module, &text) {
            let (_, name) = it.name.split_once("::").expect("a path");
            let is_error = ["describe! {", "core::error::Error for"].iter().any(|words| is_behind(&text, words, name));
            assert!(it.is_logged || !is_error, "{}", it.name);
            errors += usize::from(is_error);
        }
    }
    assert!(errors > 20, "{errors} errors are found");
}

#[test]
fn a_type_without_a_format_is_caught() {
    let of = |text| types("fog", text).pop().expect("a type").is_logged;
    assert!(!of("#[derive(Clone, Debug)]\npub struct BadFog;\n"));
    assert!(of(
        "#[derive(Clone, Debug)]\n#[cfg_attr(feature = \"defmt\", derive(defmt::Format))]\n/// Bad.\npub struct BadFog;\n"
    ));
    assert!(!of("#[cfg_attr(feature = \"defmt\", derive(defmt::Format))]\nstruct Fog;\n\npub struct BadFog;\n"));
    assert!(!of("pub struct BadFog {\n}\n\nformat_fixed! {\n    impl[] |it: BadFogs| \"BadFogs\"\n}\n"));
}

/// Compiles only if it is so. Nothing is logged here: on the desk there is nothing that takes it.
#[cfg(feature = "defmt")]
mod compiled {
    use aquatint::*;
    use core::convert::Infallible;
    use embedded_graphics::pixelcolor::{BinaryColor, Gray4};

    /// A space of the user's, that says nothing about itself.
    enum Workshop {}

    fn is_format<T: defmt::Format>() {}

    #[test]
    fn errors() {
        is_format::<OutOfRange>();
        is_format::<TooSmall>();
        is_format::<SvgError>();
        is_format::<SvgProblem>();
        is_format::<TextureError>();
        is_format::<InPlaceError<Infallible>>();
        is_format::<clip::convex::WindowError>();
        is_format::<clip::sutherland_hodgman::Full>();
        is_format::<display::diffuse::TooShort>();
        is_format::<display::dither::OddFrames>();
        is_format::<display::dither::UnevenRanks>();
        is_format::<display::level::NotRising>();
        is_format::<display::scale::ScaleError>();
        is_format::<fragment::motion::OddSubframes>();
        is_format::<geometry::projection::ProjectionError>();
        is_format::<geometry::viewport::BadViewport>();
        is_format::<hidden::bsp::BuildError>();
        is_format::<hidden::bsp::TreeError>();
        is_format::<hidden::depth::TooFewDepths>();
        is_format::<hidden::raycast::HierarchyError>();
        is_format::<model::mesh::MeshError>();
        is_format::<pipeline::DrawError<Infallible>>();
        is_format::<pipeline::MeshShapesError>();
        is_format::<pipeline::NoRays>();
        is_format::<raster::flood::FloodError<Infallible>>();
        is_format::<raster::flood::Refused>();
        is_format::<tone::panel::NotBrighter>();
        is_format::<tone::xyz::OutOfGamut>();
        #[cfg(feature = "ttf")]
        is_format::<FontError>();
    }

    #[test]
    fn places_in_spaces_that_cannot_be_logged() {
        is_format::<(Point2, Rect)>();
        is_format::<(Point3<Workshop>, Point4<Workshop>, Vector3<Workshop>)>();
        is_format::<Matrix<Workshop, Model>>();
        is_format::<(ClipPlane, Frustum<Workshop>, HalfSpace<Workshop>)>();
        is_format::<(BoundingBox<Point2>, BoundingBox3<Workshop>, BoundingSphere<Workshop>)>();
    }

    #[test]
    fn values() {
        is_format::<(Angle, Affine, Placed<Circle>, Outcode, Verdict)>();
        is_format::<(Light, Alpha<Gray4>, Coverage, CoverageCurve, BlendMode)>();
        is_format::<(Rule, Join, Cap, Stroke)>();
        is_format::<(FillStyle<BinaryColor>, StrokeStyle<Gray4>, AntialiasedStyle<Light>)>();
        is_format::<(Line, Circle, Ellipse, Triangle<2>, RoundedRectangle)>();
        is_format::<(Oval, Arc, Chord, Sector, Segment, Stipple)>();
        is_format::<(Region<Gray4>, Connectivity, Extend, RasterOp, Turn)>();
        is_format::<(Rgb332, ThreeColor, FourColor, SixColor, SevenColor)>();
        is_format::<(Hls, Hsv, YCbCr, Xyz, Chromaticity, Gamut, ColourMatrix)>();
        is_format::<(Spacing, Changed, Grain, GlyphId, FontMetrics, GlyphBox)>();
        is_format::<(geometry::projection::Lens, geometry::viewport::Viewport, geometry::light::Lamp)>();
        is_format::<(geometry::lights::Lights<3>, geometry::quaternion::Quaternion, Fog)>();
        is_format::<(pipeline::Camera, pipeline::Scene, hidden::raycast::Hit, hidden::solid_bsp::Hit)>();
    }
}
