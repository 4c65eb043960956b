//! Lamps against the formulas in floating point.

use aquatint::{
    Angle, Illumination, Light, Matrix, Model, Point3, Scalar, Vector3, World,
    geometry::{
        light::{Lamp, Lighting, Lit, Surface},
        lights::{Lights, Source},
    },
};
use proptest::prelude::*;

use crate::number;

type Vector = [f64; 3];

fn minus(a: Vector, b: Vector) -> Vector {
    [a[0] - b[0], a[1] - b[1], a[2] - b[2]]
}

fn dot(a: Vector, b: Vector) -> f64 {
    a.iter().zip(b).map(|(a, b)| a * b).sum()
}

fn unit(v: Vector) -> Vector {
    let length = dot(v, v).sqrt();
    v.map(|v| v / length)
}

fn point<S>([x, y, z]: Vector) -> Point3<S> {
    Point3::new(number(x), number(y), number(z))
}

fn vector<S>([x, y, z]: Vector) -> Vector3<S> {
    Vector3::new(number(x), number(y), number(z))
}

/// A lamp and its formula.
#[derive(Clone, Copy, Debug)]
enum Shining {
    Far(Vector),
    Near { at: Vector, reach: f64 },
    Cone { at: Vector, reach: f64, to: Vector, inner: f64, outer: f64 },
}

impl Shining {
    fn source(self, light: u16) -> Source {
        let angle = |degrees: f64| Angle((number(degrees / 360.0).to_bits() & 0xFFFF).try_into().expect("16 bits"));
        let light = Light(light);
        match self {
            Self::Far(direction) => Source::Directional { direction: vector(direction), light },
            Self::Near { at, reach } => Source::Point { position: point(at), light, reach: number(reach) },
            Self::Cone { at, reach, to, inner, outer } => Source::Spot {
                position: point(at),
                direction: vector(to),
                light,
                reach: number(reach),
                inner: angle(inner),
                outer: angle(outer),
            },
        }
    }

    /// The direction towards it and what part of its light arrives.
    fn at(self, place: Vector) -> (Vector, f64) {
        let falloff = |at: Vector, reach: f64| {
            let way = minus(at, place);
            (unit(way), (reach * reach / dot(way, way)).min(4.0))
        };
        match self {
            Self::Far(direction) => (unit(direction), 1.0),
            Self::Near { at, reach } => falloff(at, reach),
            Self::Cone { at, reach, to, inner, outer } => {
                let (way, part) = falloff(at, reach);
                let (inner, outer) = (inner.to_radians().cos(), outer.to_radians().cos());
                let t = ((-dot(way, unit(to)) - outer) / (inner - outer)).clamp(0.0, 1.0);
                (way, part * t * t * (3.0 - 2.0 * t))
            }
        }
    }

    /// How much less sure a highlight is than one before the eye: half-way between opposite directions is anywhere.
    fn opposite(self, place: Vector, eye: Vector) -> f64 {
        let ((to_lamp, _), to_eye) = (self.at(place), unit(minus(eye, place)));
        let sum = [0, 1, 2].map(|i| to_lamp[i] + to_eye[i]);
        2.0 / dot(sum, sum).sqrt()
    }

    /// What part of its light a small error of a cosine may change at the border of its cone, where that is steepest.
    fn unsure(self, place: Vector) -> f64 {
        let Self::Cone { at, reach, inner, outer, .. } = self else { return 0.0 };
        let (_, part) = Self::Near { at, reach }.at(place);
        part * 1.5 * COSINE_ERROR / (inner.to_radians().cos() - outer.to_radians().cos())
    }
}

/// An object, seen from somewhere, and a place on it.
#[derive(Clone, Copy, Debug)]
struct Scene {
    turn: (u16, u16),
    scale: f64,
    shift: Vector,
    eye: Vector,
    place: [i16; 3],
    normal: [i16; 3],
}

impl Scene {
    fn placement(&self) -> Matrix<Model, World> {
        let [x, y, z] = self.shift.map(number);
        let turned = Matrix::<Model, Model>::rotation_y(Angle(self.turn.0))
            .then(&Matrix::<Model, Model>::rotation_x(Angle(self.turn.1)));
        turned.then(&Matrix::<Model, Model>::scale(number(self.scale))).then(&Matrix::translation(x, y, z))
    }

    fn got(&self, surface: Surface, ambient: u16, sources: [Source; 2]) -> u16 {
        let placement = self.placement();
        let lit = Lit { placement: &placement, eye: point(self.eye), surface };
        Lights { ambient: Light(ambient), sources }.for_object(&lit).on(self.place, self.normal).0
    }

    fn world_place(&self) -> Vector {
        let rows = self.placement().rows().map(|row| row.map(|v| v.to_num::<f64>()));
        let [x, y, z] = self.place.map(|v| f64::from(v) / 16_384.0);
        [0, 1, 2].map(|i| dot([x, y, z], [rows[i][0], rows[i][1], rows[i][2]]) + rows[i][3])
    }

    /// All in the world, in floating point; a lamp counts that stands higher over the surface than `grazing`.
    fn exact(&self, surface: Surface, ambient: u16, shining: [(Shining, u16); 2], grazing: f64) -> f64 {
        let rows = self.placement().rows().map(|row| row.map(|v| v.to_num::<f64>()));
        let turned = |v: Vector| [0, 1, 2].map(|i| dot([rows[i][0], rows[i][1], rows[i][2]], v));
        let place = self.world_place();
        let normal = unit(turned(self.normal.map(f64::from)));
        let to_eye = unit(minus(self.eye, place));
        let (mut diffuse, mut specular) = (0.0, 0.0);
        for (shining, light) in shining {
            let (direction, part) = shining.at(place);
            let (cosine, light) = (dot(normal, direction), part * f64::from(light));
            if cosine > grazing {
                diffuse += light * cosine.max(0.0);
                let half_way = unit([0, 1, 2].map(|i| direction[i] + to_eye[i]));
                specular += light * dot(normal, half_way).max(0.0).powi(1 << surface.shininess);
            }
        }
        let part = |light: f64, of: u16| light.min(65_535.0) * f64::from(of) / 65_535.0;
        (part(f64::from(ambient), surface.diffuse) + part(diffuse, surface.diffuse) + part(specular, surface.specular))
            .min(65_535.0)
    }
}

fn somewhere(size: f64) -> impl Strategy<Value = Vector> {
    prop::array::uniform3(-size..size)
}

fn shining() -> impl Strategy<Value = (Shining, u16)> {
    let direction = || somewhere(5.0).prop_filter("a direction", |v| dot(*v, *v) > 0.1);
    let kind = prop_oneof![
        direction().prop_map(Shining::Far),
        (somewhere(20.0), 0.1..20.0_f64).prop_map(|(at, reach)| Shining::Near { at, reach }),
        (somewhere(20.0), 0.1..20.0_f64, direction(), 1.0..60.0_f64, 10.0..110.0_f64)
            .prop_map(|(at, reach, to, inner, more)| Shining::Cone { at, reach, to, inner, outer: inner + more }),
    ];
    (kind, any::<u16>())
}

fn scene() -> impl Strategy<Value = Scene> {
    let normal = prop::array::uniform3(-100..100_i32).prop_filter("a normal", |v| v.iter().any(|&v| v != 0));
    (
        any::<(u16, u16)>(),
        0.2..5.0_f64,
        somewhere(10.0),
        somewhere(20.0),
        prop::array::uniform3(-16_384..16_384_i16),
        normal,
    )
        .prop_map(|(turn, scale, shift, eye, place, normal)| {
            let normal = aquatint::illumination::unit_normal(normal);
            Scene { turn, scale, shift, eye, place, normal }
        })
}

/// Told in `geometry/lights.rs`.
const COSINE_ERROR: f64 = 4.0 / 16_384.0;

proptest! {
    #![proptest_config(ProptestConfig::with_cases(20_000))]

    /// The bound told in `geometry/lights.rs`: a part of the light, and of a highlight by its exponent.
    #[test]
    fn lights_are_what_the_formulas_say(
        scene in scene(), first in shining(), second in shining(), ambient in any::<u16>(),
        diffuse in any::<u16>(), specular in any::<u16>(), shininess in 0..=7_u8,
    ) {
        let surface = Surface { diffuse, specular, shininess };
        let got = scene.got(surface, ambient, [first.0.source(first.1), second.0.source(second.1)]);
        // A lamp that grazes the surface may have a highlight or none: there it begins, and not from nothing.
        let [least, most] = [COSINE_ERROR, -COSINE_ERROR].map(|grazing| scene.exact(surface, ambient, [first, second], grazing));
        let place = scene.world_place();
        let cones = [first, second].map(|(shining, light)| f64::from(light) * shining.unsure(place));
        let opposite = first.0.opposite(place, scene.eye).max(second.0.opposite(place, scene.eye));
        // Each lamp gives diffuse light, and a highlight.
        let bound = 64.0 + f64::from(1_u32 << shininess) * 8.0 * opposite + cones.iter().sum::<f64>() * 2.0;
        let close = f64::from(got) >= least - bound && f64::from(got) <= most + bound;
        // A lamp next to the surface is seen in another direction from the next place.
        let near = |shining: Shining| match shining {
            Shining::Far(_) => false,
            Shining::Near { at, .. } | Shining::Cone { at, .. } => {
                let d = minus(at, scene.shift);
                dot(d, d).sqrt() < scene.scale * 2.5
            }
        };
        let eye = minus(scene.eye, scene.shift);
        let far = !near(first.0) && !near(second.0) && dot(eye, eye).sqrt() > scene.scale * 2.5;
        prop_assert!(!far || close, "{} for {} to {}, bound {}", got, least, most, bound);
    }

    #[test]
    fn no_scene_overflows(
        rows in crate::rows(), ends in any::<[[i32; 3]; 4]>(), reach in any::<i32>(), angles in any::<[u16; 2]>(),
        place in crate::place(), normal in any::<[i16; 3]>(), bytes in any::<[i8; 3]>(),
        diffuse in any::<u16>(), specular in any::<u16>(), shininess in any::<u8>(), light in any::<u16>(),
    ) {
        let [a, b, c, d] = ends.map(|v| v.map(Scalar::from_bits));
        let (position, light, reach) = (Point3::new(a[0], a[1], a[2]), Light(light), Scalar::from_bits(reach));
        let [inner, outer] = angles.map(Angle);
        let direction = Vector3::new(c[0], c[1], c[2]);
        let sources = [
            Source::Directional { direction: Vector3::new(b[0], b[1], b[2]), light },
            Source::Point { position, light, reach },
            Source::Spot { position, direction, light, reach, inner, outer },
        ];
        let placement = Matrix::from_rows(rows);
        let lit = Lit { placement: &placement, eye: Point3::new(d[0], d[1], d[2]), surface: Surface { diffuse, specular, shininess } };
        let lights = Lights { ambient: light, sources }.for_object(&lit);
        let none = Lights { ambient: light, sources: [] }.for_object(&lit);
        prop_assert!(lights.on(place, normal) >= none.on(place, normal));
        prop_assert_eq!(lights.on_vertex(place, bytes), lights.on(place, bytes.map(|v| i16::from(v) * 129)));
        let lamp = Lamp { direction, ambient: light, diffuse: light }.for_object(&lit);
        prop_assert_eq!(lamp.on_vertex(place, bytes), lamp.on(place, bytes.map(|v| i16::from(v) * 129)));
        let _ = lamp.on(place, normal);
    }
}

/// The light of one source on a white or a shiny plane at the origin that faces +z, the eye before it.
fn on_plane(source: Source, surface: Surface, place: [i16; 3]) -> f64 {
    let lit = Lit { placement: &Matrix::IDENTITY, eye: point([0.0, 0.0, 8.0]), surface };
    f64::from(Lights { ambient: Light::BLACK, sources: [source] }.for_object(&lit).on(place, [0, 0, 1 << 14]).0)
}

#[test]
fn a_lamp_and_one_far_light_give_the_same() {
    let (direction, light) = (vector([1.0, 2.0, 3.0]), Light(50_000));
    let placement = Matrix::rotation_y(Angle(1_234));
    let lit = Lit { placement: &placement, eye: point([0.0, 0.0, 8.0]), surface: Surface::MATTE };
    let lamp = Lamp { direction, ambient: Light(900), diffuse: light }.for_object(&lit);
    let lights = Lights { ambient: Light(900), sources: [Source::Directional { direction, light }] }.for_object(&lit);
    for normal in [[0, 0, 127], [90, 0, 90], [-73, 73, 73], [0, -127, 0]] {
        let (one, other) = (lamp.on_vertex([0; 3], normal).0, lights.on_vertex([0; 3], normal).0);
        assert!(one.abs_diff(other) <= 8, "{one} and {other}");
    }
}

#[test]
fn twice_as_far_a_quarter() {
    let at = |distance: f64| {
        let shining = Shining::Near { at: [0.0, 0.0, distance], reach: 2.0 };
        on_plane(shining.source(12_000), Surface::MATTE, [0; 3])
    };
    for (distance, light) in
        [(0.5, 48_000.0), (1.0, 48_000.0), (2.0, 12_000.0), (4.0, 3_000.0), (8.0, 750.0), (200.0, 1.2)]
    {
        assert!((at(distance) - light).abs() <= 6.0, "{} at {distance}", at(distance));
    }
}

#[test]
fn a_cone_has_a_soft_edge() {
    // The place at 1 to the side is seen at 45°.
    let at = |inner: f64, outer: f64| {
        let (at, to) = ([1.0, 0.0, 1.0], [0.0, 0.0, -1.0]);
        on_plane(Shining::Cone { at, reach: 2.0_f64.sqrt(), to, inner, outer }.source(60_000), Surface::MATTE, [0; 3])
    };
    let full = 60_000.0 * 0.5_f64.sqrt();
    assert!((at(46.0, 60.0) - full).abs() <= 60.0, "inside: {}", at(46.0, 60.0));
    assert_eq!(number(at(30.0, 44.0)), Scalar::ZERO, "outside");
    let (inner, outer) = (30.0_f64.to_radians().cos(), 60.0_f64.to_radians().cos());
    let t = (0.5_f64.sqrt() - outer) / (inner - outer);
    assert!((at(30.0, 60.0) - full * t * t * (3.0 - 2.0 * t)).abs() <= 60.0, "between: {}", at(30.0, 60.0));
    assert!(at(45.5, 45.5) > full - 60.0 && at(44.5, 44.5) < 1.0, "a hard edge");
}

#[test]
fn a_highlight_is_where_a_mirror_would_show_the_lamp() {
    let surface = Surface { diffuse: 0, specular: u16::MAX, shininess: 6 };
    let source = Shining::Far([2.0, 0.0, 8.0]).source(60_000);
    // From the eye at (0, 0, 8), the mirror shows it at (2, 0, 0), just beyond the last place.
    let along: Vec<f64> = (-128..128_i16).map(|x| on_plane(source, surface, [x * 256, 0, 0])).collect();
    assert!(along[255] > 59_500.0 && along[0] < 9_000.0, "{along:?}");
    assert!(along.windows(2).all(|pair| pair[0] <= pair[1] + 256.0), "{along:?}");
    let behind = Shining::Far([2.0, 0.0, -8.0]).source(60_000);
    assert_eq!(number(on_plane(behind, surface, [0; 3])), Scalar::ZERO, "no highlight in the shade");
}
