//! **aquatint**: filled polygons, dithered light and shaded 3D for displays of 1 to 8 bits a pixel.
//!
//! A fixed-point graphics pipeline, from vertices to the bytes on the wire, for microcontrollers:
//! `no_std`, no heap, no `unsafe`, no panics. It speaks [`embedded-graphics`](embedded_graphics):
//! shapes are `Drawable`s on any `DrawTarget`, and its packed frames are `DrawTarget`s.
//!
//! # The map
//!
//! ```text
//!  model        geometry       clip          raster        hidden        fragment       display
//!  mesh    ──▶  transform, ──▶ keep the  ──▶ lines,   ──▶  who is   ──▶  shade,    ──▶  light → levels →
//!               project,       visible       shapes        in front      texture        bits → bytes
//!               light          part          become spans
//! ```
//!
//! | stage | takes | gives |
//! |---|---|---|
//! | [`model`] | arrays, fonts in flash | a checked mesh, typefaces |
//! | [`geometry`] | vertices, matrices, lamps | screen points with depth; light |
//! | [`clip`] | lines, polygons, points in clip space | what is inside |
//! | [`raster`] | lines, outlines, strokes, text, triangles | spans, with their coverage where they are antialiased |
//! | [`hidden`] | fragments with depth, faces, planes or rays | what is in front |
//! | [`fragment`] | spans, coverage, corners of triangles; sub-frames | colours: shading, textures, patterns, pictures, gradients; blending; motion blur |
//! | [`tone`] | colours of any system | light, corrected colours |
//! | [`display`] | light or colours | packed bytes |
//!
//! Modules in the root are *words*, which every stage may use; stages never use each other. Only
//! [`pipeline`] knows them all: it draws a scene in one call. Every stage can be used alone.
//!
//! # Shapes on any display
//!
//! ```
//! use aquatint::{FillStyle, Frame, Pages, Point2, Polygon};
//! use embedded_graphics::{pixelcolor::BinaryColor, prelude::*};
//!
//! // A frame in the byte order of an SSD1306, 1 KiB.
//! let mut frame = Frame::<BinaryColor, Pages, _>::with_array([0; 1024], 128, 64).unwrap();
//!
//! // Corners on sixteenths of a pixel, filled by pixel centres.
//! let star = [(64, 2), (82, 60), (33, 24), (95, 24), (46, 60)].map(|(x, y)| Point2::corner(x, y));
//! let contours = [&star[..]];
//! let polygon = Polygon::new(&contours).unwrap();
//! polygon.into_styled(FillStyle::new(BinaryColor::On)).draw(&mut frame)?;
//!
//! let bytes_for_the_bus: &[u8] = frame.bytes();
//! # assert_eq!(bytes_for_the_bus.len(), 1024);
//! # Ok::<(), core::convert::Infallible>(())
//! ```
//!
//! # Features
//!
//! - `defmt`: errors and plain values can be logged by `defmt`; numbers in fixed point as fractions, `24/16`.
//! - `ttf`: [text] from TrueType and OpenType fonts, read by `ttf-parser`. Stroke fonts are there without.

#![no_std]
#![forbid(unsafe_code)]
#![deny(missing_docs)]

mod affine;
mod angle;
mod arc;
mod blend;
mod colour;
mod coverage;
pub mod curve;
pub mod cut;
mod edge;
mod em;
mod error;
mod fog;
pub mod illumination;
mod lines;
mod list;
mod matrix;
mod num;
mod on_draw_target;
mod outcode;
mod outline;
mod palette;
mod phase;
mod pieces;
mod polynomial;
mod runs;
mod shade;
pub mod slopes;
mod sort;
mod space;
mod span;
mod srgb;
mod stretch;
mod style;
mod svg;
mod svg_arc;
mod svg_data;
mod svg_number;
mod target;
pub mod text;
mod typeface;
pub mod vary;

pub mod clip;
pub mod display;
pub mod fragment;
pub mod geometry;
pub mod hidden;
pub mod model;
pub mod pipeline;
pub mod raster;
pub mod tone;

pub use affine::{Affine, Placed};
pub use angle::Angle;
pub use arc::{Arc, Chord, Oval, Sector};
pub use blend::{Alpha, Blend, BlendMode};
pub use clip::{
    bounding_box_3d::BoundingBox3,
    bounding_sphere::BoundingSphere,
    bounds::{BoundingBox, BoundingCircle, Verdict},
    clip_plane::ClipPlane,
    convex::ConvexWindow,
    frustum::Frustum,
    half_space::HalfSpace,
    vertex::ClipVertex,
    window::ClipWindow,
};
pub use colour::Light;
pub use coverage::{Coverage, CoverageCurve, Covered};
pub use curve::Flatten;
pub use display::{
    blit::{Blit, Part, RasterOp},
    diffuse::{AlongCurve, Diffusion, Hilbert},
    dirty::{Changed, Dirty, DirtyWindow, Grain, Tracked},
    dither::{
        BAYER_2X2, BAYER_4X4, BAYER_8X8, BAYER_16X16, BLUE_NOISE_16, BLUE_NOISE_64, CodeMask, Dithered,
        DitheredDrawTarget, FrameRateControl, Interleaved, IntoLight, R2Noise, RankMask,
    },
    font::GlyphSheet,
    frame::{Frame, Spacing, TooSmall},
    halftone::DotGain,
    layout::{Columns, Inverted, LsbFirst, MsbFirst, Pages, Planes, Rows, Words},
    level::Levels,
    palette::{ChannelLevels, InkMix, Palette},
    scale::Scaler,
    turned::{Turn, Turned},
    window::Window,
};
pub use error::OutOfRange;
pub use fog::Fog;
pub use fragment::{
    blend::{Blended, OnBackground, SoftBrush},
    gradient::{Extend, LinearGradient, RadialGradient},
    motion::Exposure,
    pattern::{Pattern, Stencil},
    picture::PictureInk,
    texture::{Sampler, Texture, TextureError},
};
pub use illumination::Illumination;
pub use matrix::Matrix;
pub use model::hershey::Hershey;
#[cfg(feature = "ttf")]
pub use model::ttf::{FontError, TrueType};
pub use num::{Scalar, Subpixel};
pub use on_draw_target::OnDrawTarget;
pub use outcode::Outcode;
pub use outline::{Outline, Pen, pixel_bounds};
pub use palette::{FourColor, Rgb332, SevenColor, SixColor, ThreeColor};
pub use pieces::Curve;
pub use raster::{
    area::{CoverageMask, Oversampled},
    bresenham::Line,
    circle::Circle,
    dda::DdaLine,
    ellipse::Ellipse,
    flood::{Connectivity, Flood, InPlace, InPlaceError, Region},
    path::{Path, Segment},
    polygon::Polygon,
    polyline::Polyline,
    ramp_line::RampLine,
    rounded_rectangle::RoundedRectangle,
    stipple::{Stipple, StippledLine},
    stroke::{Stroked, dash::Dashed},
    triangle::Triangle,
};
pub use runs::{Inside, PerPixel, Runs};
pub use shade::Shade;
pub use space::{
    CLIP_LIMIT, Clip, GUARD_BAND, LEAST_W, Model, Point2, Point3, Point4, Rect, Vector3, View, World, twice_area,
};
pub use span::{Sink, SpanFn};
pub use style::{AntialiasedStyle, Cap, FillStyle, Join, Rule, Stroke, StrokeStyle};
pub use svg::{SvgError, SvgPath, SvgProblem};
pub use target::{Brush, Code, Ink, Target};
pub use text::{Glyphs, Text};

pub use tone::{
    colour_matrix::ColourMatrix,
    gamma::Gamma,
    hls::Hls,
    hsv::Hsv,
    panel::PanelRange,
    xyz::{Chromaticity, Gamut, Xyz},
    ycbcr::YCbCr,
};
pub use typeface::{FontMetrics, Glyph, GlyphBox, GlyphId, GlyphPen, Typeface};

/// Compiles what the README shows.
#[cfg(doctest)]
#[doc = include_str!("../README.md")]
pub struct Readme;
