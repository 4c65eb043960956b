//! Whole pictures, as they are and scaled.

use aquatint::{
    Diffusion, Frame, Levels, Light, Rows, Scaler,
    display::{
        diffuse::{FloydSteinberg, SierraLite},
        scale::Filter,
    },
};
use embedded_graphics::{
    geometry::{Point, Size},
    pixelcolor::{BinaryColor, Gray4, Gray8},
};

use crate::photo::{self, SIDE};

#[test]
fn a_picture_is_its_rows() {
    let [codes, ..] = photo::all();
    let picture = Frame::<Gray8, Rows, _>::with_slice(&codes, 256, 256).expect("whole");
    let new = || Frame::<BinaryColor, Rows, _>::new(vec![0; 64 * 200], 300, 200).expect("enough");
    let (mut whole, mut rows) = (new(), new());
    let mut memory = [0; Diffusion::<FloydSteinberg>::memory_needed(256)];
    let mut diffusion = Diffusion::<FloydSteinberg>::new(&mut memory, 256, Levels::ONE_BIT).expect("enough");
    for (y, row) in (0..).zip(codes.chunks(SIDE)) {
        let Ok(()) = diffusion.draw_row(&mut rows, Point::new(-7, 3 + y), row.iter().map(|&c| Light::from_srgb(c)));
    }
    // What is left of the rows is forgotten.
    let Ok(()) = diffusion.draw_picture(&mut whole, Point::new(-7, 3), &picture);
    assert_eq!(whole.bytes(), rows.bytes());
    let far = Point::new(i32::MAX, i32::MAX - 2);
    let Ok(()) = diffusion.draw_picture(&mut whole, far, &picture);
    assert_eq!(whole.bytes(), rows.bytes());
}

#[test]
fn a_scaled_picture_is_its_scaled_rows() {
    let [codes, ..] = photo::all();
    let picture = Frame::<Gray8, Rows, _>::with_slice(&codes, 256, 256).expect("whole");
    for (size, filter) in [((100, 70), Filter::Area), ((300, 400), Filter::Bilinear), ((256, 256), Filter::Area)] {
        let (size, mut expected) = (Size::from(size), vec![]);
        let mut cells = vec![0; Scaler::memory_needed(size)];
        let mut scaler = Scaler::new(&mut cells, Size::new(256, 256), size, filter).expect("possible");
        for row in codes.chunks(SIDE) {
            let lights = row.iter().map(|&code| Light::from_srgb(code));
            let Ok(()) = scaler.push(lights, |_, row| {
                expected.push(row.collect::<Vec<_>>());
                Ok::<_, core::convert::Infallible>(())
            });
        }
        let new = || Frame::<Gray4, Rows, _>::new(vec![0; 40_000], 200, 400).expect("enough");
        let (mut whole, mut rows) = (new(), new());
        let mut memory = vec![0; Diffusion::<SierraLite>::memory_needed(size.width)];
        let mut diffusion = Diffusion::<SierraLite>::new(&mut memory, size.width, Levels::SRGB_16).expect("enough");
        for (y, row) in (0..).zip(expected) {
            let Ok(()) = diffusion.draw_row(&mut rows, Point::new(5, y - 1), row);
        }
        let Ok(()) = diffusion.draw_scaled(&mut whole, Point::new(5, -1), (&picture, &mut scaler));
        assert!(whole.bytes() == rows.bytes(), "{size}");
    }
}
