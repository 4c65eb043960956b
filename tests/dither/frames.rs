//! Grey from frames.

use aquatint::{
    FrameRateControl, Light,
    display::dither::{Mask, OddFrames},
};

/// Which of 16 pixels are on in a frame.
fn block(frames: u8, number: u32, light: Light) -> [bool; 16] {
    let mask = FrameRateControl::new(frames, number).unwrap();
    core::array::from_fn(|place| {
        let place = i32::try_from(place).unwrap();
        u32::from(light.0) > (65_535 * u32::from(mask.threshold(place % 4, place / 4))) >> 16
    })
}

fn on(block: [bool; 16]) -> u32 {
    block.map(u32::from).iter().sum()
}

#[test]
fn all_shades_are_there_and_the_mean_is_right() {
    for frames in 1..=16 {
        let steps = 16 * u32::from(frames);
        let mut seen = vec![false; steps as usize + 1];
        for light in (0..=u16::MAX).step_by(97).chain([u16::MAX]) {
            let sum: u32 = (0..frames.into()).map(|number| on(block(frames, number, Light(light)))).sum();
            seen[sum as usize] = true;
            let error = f64::from(sum) / f64::from(steps) - f64::from(light) / 65_535.0;
            assert!(error.abs() <= 0.5 / f64::from(steps) + 1.0 / 65_536.0, "{frames} frames, {light}: {error}");
        }
        assert!(seen.iter().all(|&seen| seen), "{frames} frames: {seen:?}");
    }
}

#[test]
fn a_block_ripples_by_one_pixel_and_repeats_after_the_series() {
    for frames in 1..=16 {
        for light in (0..=u16::MAX).step_by(997) {
            let sums = (0..frames.into()).map(|number| on(block(frames, number, Light(light))));
            let (least, most) = (sums.clone().min().unwrap(), sums.max().unwrap());
            assert!(most - least <= 1, "{frames} frames, {light}: {least} to {most}");
            let again = u32::MAX - u32::MAX % u32::from(frames);
            assert_eq!(block(frames, again, Light(light)), block(frames, 0, Light(light)));
        }
    }
}

#[test]
fn black_and_white_do_not_flicker() {
    for number in 0..64 {
        for frames in 1..=16 {
            assert_eq!(block(frames, number, Light::BLACK), [false; 16]);
            assert_eq!(block(frames, number, Light::WHITE), [true; 16]);
        }
    }
}

#[test]
fn series_that_no_panel_shows_are_refused() {
    assert_eq!(FrameRateControl::new(0, 0), Err(OddFrames));
    assert_eq!(FrameRateControl::new(17, 0), Err(OddFrames));
    assert!(FrameRateControl::new(16, u32::MAX).is_ok());
}
