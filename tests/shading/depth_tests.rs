//! Every test of depth in a scene of two panels, and second passes.

use aquatint::{
    Light, Rect,
    fragment::shade::{Gouraud, Stippled},
    hidden::depth::{Depth, DepthBuffer, DepthFunction, DepthTest, Nearer},
    pipeline::Material,
};

use crate::common::{Canvas, Shape, VIEW, draw, panel};

/// A leaning panel, then a level one with a test: what is seen, and which depths are stored at the end.
fn after<D: Depth + Ord + PartialEq, F: DepthFunction>(nothing: D, function: F) -> (String, Vec<D>, Vec<D>) {
    let mut canvas = Canvas::new(VIEW);
    let mut depths = vec![nothing; 128];
    let mut buffer = DepthBuffer::new(&mut depths, VIEW).expect("large enough");
    // Nearer on the left; nothing on the right.
    let leaning = panel(Rect::new(0, 0, 12, 8), [-0.5, 0.5]).in_light(0x4000);
    draw(&leaning, Material::new(Gouraud), &mut buffer, &mut canvas).expect("in range");
    let mut before = vec![];
    for row in 0..8 {
        before.extend_from_slice(buffer.run(row, 0..16).expect("inside"));
    }
    let mut buffer = buffer.with_test(function);
    let level = panel(Rect::new(0, 2, 16, 6), [0.0; 2]).in_light(0xA000);
    draw(&level, Material::new(Gouraud), &mut buffer, &mut canvas).expect("in range");
    (canvas.picture(), before, depths)
}

/// Rows 2 to 5 of the picture; the others are of the leaning panel.
fn middle<F: DepthFunction>(function: F) -> String {
    let (picture, _, _) = after(0_u16, function);
    let rows: Vec<_> = picture.lines().collect();
    assert!(rows[..2].iter().chain(&rows[6..]).all(|row| *row == "444444444444...."), "{picture}");
    assert!(rows[2..6].iter().all(|row| *row == rows[2]), "{picture}");
    assert_eq!(after(0_u8, function).0, picture, "8 bits");
    assert_eq!(after(0_u32, function).0, picture, "32 bits");
    rows[2].to_owned()
}

#[test]
fn every_test_shows_what_it_lets_pass() {
    assert_eq!(middle(Nearer), "444444aaaaaaaaaa");
    assert_eq!(middle(DepthTest::Nearer), "444444aaaaaaaaaa");
    assert_eq!(middle(DepthTest::NotFarther), "444444aaaaaaaaaa");
    assert_eq!(middle(DepthTest::Farther), "aaaaaa444444....");
    assert_eq!(middle(DepthTest::NotNearer), "aaaaaa444444....");
    assert_eq!(middle(DepthTest::Never), "444444444444....");
    assert_eq!(middle(DepthTest::Equal), "444444444444....");
    assert_eq!(middle(DepthTest::NotEqual), "aaaaaaaaaaaaaaaa");
    assert_eq!(middle(DepthTest::Always), "aaaaaaaaaaaaaaaa");
}

#[test]
fn what_passes_is_stored_unless_writing_is_off() {
    for test in [DepthTest::Nearer, DepthTest::Farther, DepthTest::NotEqual, DepthTest::Always] {
        let (stored, unstored) = (after(0_u16, test), without_writing(test));
        assert_eq!(stored.0, unstored.0, "{test:?}: the pictures are the same");
        assert_ne!(stored.1, stored.2, "{test:?}");
        assert_eq!(unstored.1, unstored.2, "{test:?}");
    }
    let (_, before, depths) = after(0_u16, DepthTest::Always);
    assert!((depths[32..96].iter()).all(|depth| *depth == depths[32]), "level");
    assert_eq!(before[..32], depths[..32]);
}

fn without_writing(test: DepthTest) -> (String, Vec<u16>, Vec<u16>) {
    #[derive(Clone, Copy)]
    struct Quiet(DepthTest);
    impl DepthFunction for Quiet {
        const STORES: bool = false;
        fn passes<D: Depth + Ord>(self, stored: D, depth: D) -> bool {
            self.0.passes(stored, depth)
        }
    }
    let by_hand = after(0_u16, Quiet(test));
    // The same by the method.
    let mut canvas = Canvas::new(VIEW);
    let mut depths = [0_u16; 128];
    let mut buffer = DepthBuffer::new(&mut depths, VIEW).expect("large enough");
    let leaning = panel(Rect::new(0, 0, 12, 8), [-0.5, 0.5]).in_light(0x4000);
    draw(&leaning, Material::new(Gouraud), &mut buffer, &mut canvas).expect("in range");
    let mut buffer = buffer.with_test(test).without_writing();
    let level = panel(Rect::new(0, 2, 16, 6), [0.0; 2]).in_light(0xA000);
    draw(&level, Material::new(Gouraud), &mut buffer, &mut canvas).expect("in range");
    assert_eq!((canvas.picture(), depths.to_vec()), (by_hand.0.clone(), by_hand.2.clone()));
    by_hand
}

/// Two passes over two panels that cross: the second one, at equal depth, meets exactly what the first one has left.
#[test]
fn a_second_pass_at_equal_depth() {
    let shapes: [Shape; 2] = [panel(VIEW, [-0.7, 0.6]).in_light(0x3000), panel(VIEW, [0.3, -0.4]).in_light(0x7000)];
    let mut first = Canvas::new(VIEW);
    let mut depths = [0_u16; 128];
    let mut buffer = DepthBuffer::new(&mut depths, VIEW).expect("large enough");
    for shape in &shapes {
        draw(shape, Material::new(Gouraud), &mut buffer, &mut first).expect("in range");
    }
    let mut buffer = buffer.with_test(DepthTest::Equal).without_writing();
    let mut second = Canvas::new(VIEW);
    // In the other order, and two lights that say which.
    for (shape, light) in [(&shapes[1], 0x8000), (&shapes[0], 0x2000)] {
        let shape = shape.clone().in_light(light);
        draw(&shape, Material::new(Gouraud), &mut buffer, &mut second).expect("in range");
    }
    let again = |light: Option<Light>| Some(Light(if light?.0 >> 12 == 7 { 0x8000 } else { 0x2000 }));
    let upper = |light: Option<Light>| light.map(|light| (light.0 + 0x800) >> 12);
    for (first, second) in first.colors.iter().zip(&second.colors) {
        assert_eq!(upper(again(first.map(|light| Light(light.0 + 0x100)))), upper(*second));
    }
    assert!(first.picture().contains("33") && first.picture().contains('7'), "{}", first.picture());
}

/// Nothing passes twice, where `Nearer` is strict; where a test lets equals pass, it does.
#[test]
fn the_same_mesh_again() {
    let shape = panel(VIEW, [-0.7, 0.6]).in_light(0x3000);
    for (test, count) in [(DepthTest::Nearer, 0), (DepthTest::NotFarther, 128), (DepthTest::NotEqual, 0)] {
        let mut depths = [0_u16; 128];
        let mut buffer = DepthBuffer::new(&mut depths, VIEW).expect("large enough");
        draw(&shape, Material::new(Gouraud), &mut buffer, &mut Canvas::new(VIEW)).expect("in range");
        // Pixel by pixel, in parts, and filtered.
        let mut again = Canvas::new(VIEW);
        let mut buffer = buffer.with_test(test);
        draw(&shape, Material::new(Gouraud), &mut buffer, &mut again).expect("in range");
        assert_eq!(again.colors.iter().flatten().count(), count, "{test:?}");
        let mut filtered = Canvas::new(VIEW);
        draw(&shape, Material::new(Stippled::new(Gouraud, [0xFF])), &mut buffer, &mut filtered).expect("in range");
        assert_eq!(filtered.colors.iter().flatten().count(), count, "{test:?}");
    }
}
