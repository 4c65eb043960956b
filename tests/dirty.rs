//! Dirty windows: what they look like, and against a slow truth by snapshots of the memory.

#[macro_use]
mod reference;
#[path = "dirty/model.rs"]
mod model;
#[path = "dirty/pictures.rs"]
mod pictures;
#[path = "dirty/words.rs"]
mod words;

use core::{convert::Infallible, fmt::Debug};

use aquatint::{
    Changed, Code, Columns, Dirty, Frame, Grain, Inverted, LsbFirst, MsbFirst, Pages, Planes, Rect, Rows, Target,
    TooSmall, display::layout::Layout,
};
use embedded_graphics::{
    Pixel,
    draw_target::DrawTarget,
    geometry::Point,
    pixelcolor::{BinaryColor, Gray2, Gray4, Gray8},
};
use model::{Canvas, Scene, scene};
use proptest::{collection::vec, prelude::*};
use reference::{
    Packing,
    drawings::{draw_in_windows, draw_shapes},
    steps::{Step, step},
};

// Sizes at the ends.

#[test]
fn lines_of_more_than_65535_bytes_count_to_their_end() {
    for column in [0, 1, 65_533, 65_534, 65_535, 65_536, 69_999] {
        let mut frame = Frame::<Gray8, Rows, _>::new(vec![0; 140_000], 70_000, 2).expect("enough");
        let mut dirty = Dirty::new([Changed::NOTHING; 2]);
        let Ok(()) = dirty.track(&mut frame).draw_iter([Pixel(Point::new(column, 1), Gray8::new(1))]);
        let [window] = &dirty.windows(&frame, Grain::BYTES).collect::<Vec<_>>()[..] else { panic!("one") };
        let expected = if column < 65_535 { column..column + 1 } else { 65_535..70_000 };
        assert_eq!((window.area().columns(), window.area().rows()), (expected, 1..2));
    }
}

#[test]
fn frames_without_pixels_have_no_windows() {
    for (width, height) in [(0, 0), (0, 9), (9, 0), (0, u32::MAX), (u32::MAX, 0)] {
        on_every_layout!(nothing_to_send(width, height));
    }
}

fn nothing_to_send<C: Code + Debug, L: Layout<C>>(_: Packing, width: u32, height: u32) {
    let mut frame = Frame::<C, L, _>::with_array([0; 3], width, height).expect("nothing is needed");
    let mut dirty = Dirty::new([Changed::EVERYTHING; 3]);
    let Ok(()) = dirty.track(&mut frame).clear(C::from_code(0xFF));
    dirty.mark(&frame, Rect::new(i32::MIN, i32::MIN, i32::MAX, i32::MAX));
    let mut other = Frame::<C, L, _>::with_array([0; 3], width, height).expect("nothing is needed");
    dirty.compare(&frame, &other);
    dirty.copy(&frame, &mut other);
    assert_eq!(dirty.windows(&frame, Grain::SSD1680).count(), 0);
}

#[test]
fn without_entries_everything_counts_as_changed() {
    let mut frame = Frame::<BinaryColor, Pages, _>::with_array([0; 24], 12, 16).expect("enough");
    let mut dirty = Dirty::new([Changed::NOTHING; 0]);
    let Ok(()) = dirty.track(&mut frame).clear(BinaryColor::On);
    dirty.clear();
    assert!(!dirty.is_clean());
    assert_eq!(dirty.windows(&frame, Grain::SSD1306).map(|window| window.area()).collect::<Vec<_>>(), [frame.bounds()]);
}

#[test]
fn frames_of_different_sizes_differ_everywhere_and_are_not_copied() {
    let frame = Frame::<BinaryColor, Rows, _>::with_array([1; 6], 16, 3).expect("enough");
    let mut shown = Frame::<BinaryColor, Rows, _>::with_array([0; 6], 24, 2).expect("enough");
    let mut dirty = Dirty::new([Changed::NOTHING; 3]);
    dirty.compare(&frame, &shown);
    assert_eq!(dirty.entries(), [Changed::EVERYTHING; 3]);
    dirty.copy(&frame, &mut shown);
    assert_eq!(shown.bytes(), [0; 6]);
}

#[test]
fn a_copy_needs_room() {
    let frame = Frame::<BinaryColor, Rows, _>::with_array([1, 2, 3, 4, 5, 6], 24, 2).expect("enough");
    let mut dirty = Dirty::new([Changed::NOTHING; 2]);
    dirty.mark(&frame, Rect::new(8, 0, 24, 2));
    let window = dirty.windows(&frame, Grain::BYTES).next().expect("marked");
    let mut memory = [9; 5];
    assert_eq!(window.copy_to(&mut memory[..3]), Err(TooSmall { needed: 4 }));
    assert_eq!(memory, [9; 5]);
    assert_eq!(window.copy_to(&mut memory), Ok(&[2, 3, 5, 6][..]));
    assert_eq!(memory[4], 9);
}

// Against snapshots.

proptest! {
    #![proptest_config(ProptestConfig::with_cases(1500))]

    #[test]
    fn what_one_call_changes_is_what_is_marked(scene in scene(), steps in vec(step(), 1..6)) {
        on_every_layout!(track_steps(&scene, &steps));
    }

    #[test]
    fn windows_bring_the_panel_up_to_date(scene in scene(), steps in vec(step(), 1..5)) {
        on_every_layout!(send_steps(&scene, &steps));
    }

    #[test]
    fn drawings_of_embedded_graphics_bring_it_too(scene in scene(), x in -20..40, y in -20..20) {
        on_every_layout!(send_drawings(&scene, Point::new(x, y)));
    }

    #[test]
    fn two_frames_are_compared_and_copied(scene in scene(), noise in vec(any::<u8>(), 8), steps in vec(step(), 0..3)) {
        on_every_layout!(compare(&scene, &noise, &steps));
    }

    #[test]
    fn areas_are_marked_by_hand(scene in scene(), corners in any::<[i32; 4]>(), small in any::<[i8; 4]>()) {
        on_every_layout!(mark_area(&scene, corners));
        on_every_layout!(mark_area(&scene, small.map(i32::from)));
    }
}

fn track_steps<C: Code + Debug, L: Layout<C>>(_: Packing, scene: &Scene, steps: &[Step]) {
    let mut plain = Canvas::<C, L>::new(scene);
    let mut tracked = Canvas::<C, L>::new(scene);
    let mut exact = Dirty::new(vec![Changed::NOTHING; plain.lines().max(1)]);
    for step in steps.iter().flat_map(|step| [step, step]) {
        let changed = plain.draw(step);
        tracked.track(&mut exact, |target| step.draw(target));
        assert_eq!(tracked.memory, plain.memory, "{step:?}");
        let marked: Vec<_> = exact.entries().iter().map(|entry| entry.bytes(plain.line_bytes())).collect();
        assert_eq!(marked, changed, "{step:?}");
        exact.clear();
    }
}

fn send_steps<C: Code + Debug, L: Layout<C>>(_: Packing, scene: &Scene, steps: &[Step]) {
    let mut canvas = Canvas::<C, L>::new(scene);
    let mut dirty = Dirty::new(vec![Changed::NOTHING; scene.entries]);
    let old = canvas.memory.clone();
    let mut changed = canvas.nothing();
    for step in steps {
        let by_step = canvas.clone().draw(step);
        model::join(&mut changed, &by_step);
        canvas.track(&mut dirty, |target| step.draw(target));
    }
    if scene.entries > 0 {
        // Entries stand for 1, 2, 4 … lines, for as few as they suffice.
        let shared = (0..32).map(|log2| 1 << log2).find(|lines| lines * scene.entries >= canvas.lines()).expect("some");
        let marked = dirty.entries().iter().map(|entry| entry.bytes(canvas.line_bytes()));
        let expected = changed.chunks(shared).map(model::hull).chain(core::iter::repeat(0..0));
        marked.zip(expected).for_each(|(marked, expected)| assert_eq!(marked, expected));
        changed = changed.chunks(shared).flat_map(|lines| lines.iter().map(|_| model::hull(lines))).collect();
    } else {
        changed = vec![0..canvas.line_bytes(); canvas.lines()];
    }
    canvas.check_windows(&dirty, &changed, &old, scene.grain);
}

fn send_drawings<C: Code + Debug + From<Gray8>, L: Layout<C>>(_: Packing, scene: &Scene, at: Point) {
    let mut plain = Canvas::<C, L>::new(scene);
    let mut canvas = plain.clone();
    let old = canvas.memory.clone();
    let mut dirty = Dirty::new(vec![Changed::NOTHING; canvas.lines()]);
    canvas.track(&mut dirty, |target| draw_all(target, at));
    draw_all(&mut plain.frame(), at);
    assert_eq!(canvas.memory, plain.memory);
    let changed: Vec<_> = dirty.entries().iter().map(|entry| entry.bytes(canvas.line_bytes())).collect();
    for (marked, differs) in changed.iter().zip(canvas.differences(&old)) {
        assert_eq!(model::hull(&[marked.clone(), differs]), *marked, "what differs is marked");
    }
    canvas.check_windows(&dirty, &changed, &old, scene.grain);
}

fn draw_all<D: DrawTarget<Color: From<Gray8>, Error = Infallible>>(target: &mut D, at: Point) {
    let Ok(()) = draw_shapes(target, at);
    let Ok(()) = draw_in_windows(target, at);
}

fn compare<C: Code + Debug, L: Layout<C>>(_: Packing, scene: &Scene, noise: &[u8], steps: &[Step]) {
    let mut canvas = Canvas::<C, L>::new(scene);
    // The panel's copy lies otherwise in memory, and differs somewhat.
    let mut shown = Canvas::<C, L>::new(&Scene { gaps: !scene.gaps, ..scene.clone() });
    shown.copy_lines(&canvas);
    for step in steps {
        step.draw(&mut canvas.frame());
    }
    canvas.scatter(noise);
    let old = canvas.with_lines_of(&shown);
    let mut dirty = Dirty::new(vec![Changed::NOTHING; canvas.lines()]);
    dirty.compare(&canvas.frame(), &shown.frame());
    let marked: Vec<_> = dirty.entries().iter().map(|entry| entry.bytes(canvas.line_bytes())).collect();
    assert_eq!(marked, canvas.differences(&old));
    canvas.check_windows(&dirty, &marked, &old, scene.grain);

    let before = shown.clone();
    dirty.copy(&canvas.frame(), &mut shown.frame());
    assert_eq!(canvas.with_lines_of(&shown), canvas.memory, "all is copied");
    let mut expected = before;
    expected.copy_lines(&canvas);
    assert_eq!(shown.memory, expected.memory, "and nothing between the lines");
}

fn mark_area<C: Code + Debug, L: Layout<C>>(_: Packing, scene: &Scene, [left, top, right, bottom]: [i32; 4]) {
    let mut canvas = Canvas::<C, L>::new(scene);
    let area = Rect::new(left, top, right, bottom);
    let mut dirty = Dirty::new(vec![Changed::NOTHING; canvas.lines()]);
    dirty.mark(&canvas.frame(), area);
    // The bytes of the area are those that a fill changes.
    let [old, new] = canvas.filled(area);
    canvas.memory = new;
    let marked: Vec<_> = dirty.entries().iter().map(|entry| entry.bytes(canvas.line_bytes())).collect();
    assert_eq!(marked, canvas.differences(&old));
}
