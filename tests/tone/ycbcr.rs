//! Y′CbCr against its definition, and what there and back costs.

use crate::exact::{all_colours, some_colours};
use aquatint::{YCbCr, tone::luma::Standard};

const STANDARDS: [(Standard, f64, f64); 2] = [(Standard::Bt601, 0.299, 0.114), (Standard::Bt709, 0.2126, 0.0722)];

#[test]
fn each_component_is_within_0_51_of_the_exact_one() {
    for (standard, kr, kb) in STANDARDS {
        for rgb in some_colours(5) {
            let [red, green, blue] = rgb.map(f64::from);
            let y = kr * red + (1.0 - kr - kb) * green + kb * blue;
            let (cb, cr) = (128.0 + (blue - y) / (2.0 - 2.0 * kb), 128.0 + (red - y) / (2.0 - 2.0 * kr));
            let got = YCbCr::from_rgb(rgb, standard);
            assert_eq!(got.y, standard.luma(rgb));
            for (got, exact) in [(got.y, y), (got.cb, cb.min(255.0)), (got.cr, cr.min(255.0))] {
                assert!((f64::from(got) - exact).abs() <= 0.51, "{standard:?} {rgb:?}: {got} {exact}");
            }
        }
    }
}

#[test]
fn there_and_back_over_all_colours() {
    for (standard, expected) in [(Standard::Bt601, (1, 12_777_313)), (Standard::Bt709, (1, 12_636_304))] {
        let (mut worst, mut lost) = (0, 0);
        for rgb in all_colours() {
            let back = YCbCr::from_rgb(rgb, standard).to_rgb(standard);
            lost += u32::from(back != rgb);
            worst = rgb.into_iter().zip(back).map(|(a, b)| a.abs_diff(b)).fold(worst, u8::max);
        }
        assert_eq!((worst, lost), expected, "{standard:?}");
    }
}

#[test]
fn greys_are_greys_and_nothing_else_is() {
    for (standard, ..) in STANDARDS {
        for code in 0..=255 {
            let grey = YCbCr::from_rgb([code; 3], standard);
            assert_eq!(grey, YCbCr { y: code, cb: 128, cr: 128 });
            assert_eq!(grey.to_rgb(standard), [code; 3]);
        }
    }
}

/// Back to colours, for all 2²⁴ combinations, most of which are none.
#[test]
fn each_channel_is_the_nearest_and_clipped() {
    for (standard, kr, kb) in STANDARDS {
        for [y, cb, cr] in some_colours(5) {
            let (luma, blue, red) = (f64::from(y), f64::from(cb) - 128.0, f64::from(cr) - 128.0);
            let (red, blue) = (luma + red * (2.0 - 2.0 * kr), luma + blue * (2.0 - 2.0 * kb));
            let green = (luma - kr * red - kb * blue) / (1.0 - kr - kb);
            for (got, exact) in (YCbCr { y, cb, cr }).to_rgb(standard).into_iter().zip([red, green, blue]) {
                assert!((f64::from(got) - exact.clamp(0.0, 255.0)).abs() <= 0.51, "{standard:?} {y} {cb} {cr}");
            }
        }
    }
}
