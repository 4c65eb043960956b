//! What antialiasing takes of the heap while it draws: nothing.
//!
//! `cargo test --test heap -- --nocapture` prints the peaks of the peers on the desk, and beside them the memory that our
//! fill is lent. What peers took before, such as the 32 KB of `ab_glyph_rasterizer`'s picture in floats, and what they take
//! of the stack is not among it.

#[expect(dead_code, reason = "only some of it is drawn here")]
#[path = "../benches/items/mod.rs"]
mod items;

use std::{
    alloc::{GlobalAlloc, Layout, System},
    cell::Cell,
};

use items::{Draw, Label, MEMORY, OURS, Surface, Visitor};

/// The system's heap, which counts for each thread.
struct Counted;

thread_local! {
    /// Bytes that are taken, and the most that were.
    static TAKEN: Cell<(usize, usize)> = const { Cell::new((0, 0)) };
}

/// The heap grows and shrinks. What a thread frees that another took counts as nothing.
fn count(grown: usize, shrunk: usize) {
    TAKEN.with(|taken| {
        let (now, most) = taken.get();
        let now = (now + grown).saturating_sub(shrunk);
        taken.set((now, most.max(now)));
    });
}

// SAFETY: all is left to the system's allocator; counting allocates nothing.
unsafe impl GlobalAlloc for Counted {
    unsafe fn alloc(&self, layout: Layout) -> *mut u8 {
        count(layout.size(), 0);
        // SAFETY: as the caller promises.
        unsafe { System.alloc(layout) }
    }

    unsafe fn dealloc(&self, place: *mut u8, layout: Layout) {
        count(0, layout.size());
        // SAFETY: as the caller promises.
        unsafe { System.dealloc(place, layout) }
    }

    unsafe fn realloc(&self, place: *mut u8, layout: Layout, size: usize) -> *mut u8 {
        // Both are there while bytes are copied.
        count(size, 0);
        count(0, layout.size());
        // SAFETY: as the caller promises.
        unsafe { System.realloc(place, layout, size) }
    }
}

#[global_allocator]
static HEAP: Counted = Counted;

/// Draws the antialiased items, and looks at the heap meanwhile.
struct Peaks(Vec<(Label, usize)>);

impl Visitor for Peaks {
    fn visit<S: Surface>(&mut self, label: Label, surface: &mut S, draw: Draw<S>) {
        if label.panel != items::SOFT {
            return;
        }
        items::darken(surface).expect("a picture in memory");
        let before = TAKEN.get().0;
        TAKEN.set((before, before));
        draw(surface).expect("a picture in memory");
        let peak = TAKEN.get().1 - before;
        self.0.push((label, peak));
    }
}

#[test]
fn coverage_takes_no_heap() {
    let mut peaks = Peaks(Vec::new());
    items::all(&mut [0; MEMORY], &mut peaks);
    println!("aquatint is lent {} bytes", items::LENT);
    for (Label { item, who, .. }, peak) in &peaks.0 {
        println!("{item:15} {who:20} {peak:6} bytes of the heap");
        assert!(*peak == 0 || *who != OURS, "{item}: {peak}");
        // That it is counted at all shows where it has to be taken.
        assert!(*peak > 0 || *who != "tiny-skia", "{item} by {who}");
    }
    assert!(peaks.0.iter().filter(|(label, _)| label.who == OURS).count() >= 6);
}
