//! The perspective divide against exact fractions.

use aquatint::{
    Clip, Point4, Rect, Scalar,
    geometry::viewport::{FARTHEST, NEAREST, Viewport},
};
use proptest::prelude::*;

/// 256ths of a sixteenth of a pixel from the exact place, and depths below the exact one.
fn errors(view: Rect, point: Point4<Clip>) -> ([f64; 2], i128) {
    let got = Viewport::new(view).expect("a viewport").project(&point);
    let [x, y, z, w] = [point.x, point.y, point.z, point.w].map(|v| i128::from(v.to_bits()));
    // In 2⁻²⁰ of a sixteenth.
    let place = |v: i128, near: i32, far: i32| {
        let (near, far) = (i128::from(near), i128::from(far));
        (((near + far) * 8) << 20) + ((v * (far - near) * 8) << 20).div_euclid(w)
    };
    let off = |got: aquatint::Subpixel, exact: i128| {
        let error = i32::try_from((i128::from(got.to_bits()) << 20) - exact).expect("near");
        f64::from(error) / 4096.0
    };
    let places =
        [off(got.position.x, place(x, view.left, view.right)), off(got.position.y, place(-y, view.top, view.bottom))];
    let depth = (((w - z) << 24) / (2 * w)).clamp(FARTHEST.into(), NEAREST.into());
    (places, depth - i128::from(got.depth))
}

fn viewport() -> impl Strategy<Value = Rect> {
    let size = || prop_oneof![1..300_i32, 1..8192_i32];
    (-4096..4095_i32, -4096..4095_i32, size(), size())
        .prop_map(|(left, top, w, h)| Rect::new(left, top, (left + w).min(4096), (top + h).min(4096)))
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(50_000))]

    #[test]
    fn points_in_the_guard_band_are_where_they_belong(
        view in viewport(),
        exponent in 13..28_u32, mantissa in any::<u32>(),
        x in -400..=400_i32, y in any::<i16>(), z in any::<i16>(), ends in 0..9_u8,
    ) {
        let w = i64::from((1 << exponent) + mantissa % (1 << exponent));
        let part = |v: i64, of: i64| Scalar::from_bits(i32::try_from(v * w / of).expect("less than 4w"));
        let z = match ends { 0 => i64::from(i16::MIN), 1 => 1 << 15, _ => z.into() };
        let point = Point4::new(part(x.into(), 100), part(i64::from(y) * 4, 1 << 15), part(z, 1 << 15), part(1, 1));
        let ([across, down], depth) = errors(view, point);
        prop_assert!(across.abs() <= 132.0 && down.abs() <= 132.0, "off by {} and {} 256ths", across, down);
        prop_assert!((0..=1).contains(&depth), "depth too small by {}", depth);
    }

    #[test]
    fn no_point_overflows(view in viewport(), point in prop::array::uniform4(crate::element())) {
        let [x, y, z, w] = point;
        let got = Viewport::new(view).expect("a viewport").project(&Point4::new(x, y, z, w));
        prop_assert!((FARTHEST..=NEAREST).contains(&got.depth));
        // 8 viewports from its middle at the most, so that triangles of such points are in range.
        prop_assert!(got.position.x.to_num::<i32>().abs() <= 5 * 8192 && got.position.y.to_num::<i32>().abs() <= 5 * 8192);
    }
}
