//! Vertices far beside the view: all of it is covered, or it is said that they are too far.

use aquatint::{Matrix, World, pipeline::DrawError};

use crate::{
    probes::scaled,
    renderer::{Picture, Renderer, Scene, VIEW, number},
};

/// A triangle around the whole view, with corners at ±10ⁿ.
pub fn cover_all_or_are_refused<R: Renderer>() {
    for exponent in 1..=9 {
        let scale = 10_f64.powi(exponent);
        // So far in front of the eye that the plane is all that is seen.
        let back = Matrix::<World, World>::translation(number(0.0), number(0.0), number(-2.0));
        let corners = [[-16_384, -16_384, 0], [16_384, -16_384, 0], [0, 32_767, 0]];
        let scene = Scene::new(&corners, &[[0, 1, 2]], scaled(scale).then(&back), VIEW);
        let mut picture = Picture::new(VIEW);
        match R::draw(&[scene], &mut picture) {
            Ok(()) => assert!(picture.lights.writes.iter().all(|count| *count == 1), "10^{exponent}"),
            Err(error) => {
                assert_eq!(error, DrawError::OutOfRange);
                assert_eq!(picture.drawn(), 0);
                assert!(exponent > 2, "10^{exponent} is refused");
            }
        }
        println!("10^{exponent}: {} pixels", picture.drawn());
    }
}
