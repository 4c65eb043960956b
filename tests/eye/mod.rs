//! What the eye sees of an error.
//!
//! The error is filtered as the eye filters (R. Näsänen, "Visibility of halftone dot textures", IEEE
//! Trans. SMC 14(6), 1984) at 45 pixels a degree, that is 160 dpi at 40 cm, and told as a ratio to white.

use core::f64::consts::TAU;

type Complex = (f64, f64);

/// In place; the length is a power of two.
fn fourier(values: &mut [Complex]) {
    if values.len() < 2 {
        return;
    }
    let (mut even, mut odd): (Vec<_>, Vec<_>) = values.chunks(2).map(|two| (two[0], two[1])).unzip();
    fourier(&mut even);
    fourier(&mut odd);
    let half = values.len() / 2;
    for (at, ((a, b), (c, d))) in even.into_iter().zip(odd).enumerate() {
        #[expect(clippy::cast_precision_loss, reason = "small")]
        let (sin, cos) = (-TAU * at as f64 / (2 * half) as f64).sin_cos();
        let (re, im) = (c * cos - d * sin, c * sin + d * cos);
        (values[at], values[at + half]) = ((a + re, b + im), (a - re, b - im));
    }
}

/// Columns and rows of the pictures that are judged.
const SIDE: usize = 256;

/// Decibels below white of the error that is seen, of 256 × 256 pixels.
pub fn hpsnr(errors: &[f64]) -> f64 {
    let mut rows: Vec<Vec<Complex>> =
        errors.chunks(SIDE).map(|row| row.iter().map(|&error| (error, 0.0)).collect()).collect();
    for row in &mut rows {
        fourier(row);
    }
    let frequency = |at: usize| f64::from(u16::try_from(at.min(SIDE - at)).expect("small")) / 256.0 * 45.0;
    let mut sum = 0.0;
    for x in 0..SIDE {
        let mut column: Vec<Complex> = rows.iter().map(|row| row[x]).collect();
        fourier(&mut column);
        for (y, (re, im)) in column.into_iter().enumerate() {
            let seen = (-frequency(x).hypot(frequency(y)) / (0.525 * 11_f64.ln() + 3.91)).exp();
            sum += (re * re + im * im) * seen * seen;
        }
    }
    let pixels = 65_536.0;
    -10.0 * (sum / pixels / pixels).log10()
}
