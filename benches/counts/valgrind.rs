//! Counting: this program runs itself under callgrind, which counts every instruction exactly.
//!
//! Each item is counted in two processes that differ in one thing: one draws the item once, the
//! other calls a function that draws nothing in its place. The difference is the drawing alone. It
//! takes no symbols, no markers and no warm-up, and it does not depend on the load of the machine.

use std::{
    hint::black_box,
    num::NonZero,
    process::Command,
    sync::{
        Mutex,
        atomic::{AtomicUsize, Ordering},
    },
    thread,
};

use crate::{
    items::{self, Draw, Label, MEMORY, Surface, Visitor},
    name,
};

/// The argument that makes this program draw one item, to be counted.
pub const COUNTED: &str = "--counted";

/// The part of a process that is counted: draws the item `wanted` once, or nothing.
pub fn draw(wanted: &str, draws: bool) {
    items::all(&mut [0; MEMORY], &mut One { wanted, draws });
}

struct One<'a> {
    wanted: &'a str,
    draws: bool,
}

impl Visitor for One<'_> {
    fn visit<S: Surface>(&mut self, label: Label, surface: &mut S, draw: Draw<S>) {
        if format!("{} {}", name(label), label.who) == self.wanted {
            items::darken(surface).expect("a picture in memory");
            let draw = if self.draws { draw } else { items::nothing };
            black_box(draw)(black_box(surface)).expect("a picture in memory");
        }
    }
}

/// Counts the instructions of each item, on all cores of the machine.
pub fn count(labels: &[Label]) -> Result<Vec<(Label, u64)>, String> {
    if Command::new("valgrind").arg("--version").output().is_err() {
        return Err("valgrind is not installed; on Debian or Ubuntu: apt-get install valgrind".into());
    }
    let (next, counts) = (AtomicUsize::new(0), Mutex::new(Vec::new()));
    let work = || {
        while let Some(&label) = labels.get(next.fetch_add(1, Ordering::Relaxed)) {
            let counted = difference(label).map(|count| (label, count));
            counts.lock().expect("no thread panics with the lock").push(counted);
        }
    };
    thread::scope(|scope| {
        for _ in 0..thread::available_parallelism().map_or(1, NonZero::get) {
            scope.spawn(work);
        }
    });
    counts.into_inner().expect("no thread panics with the lock").into_iter().collect()
}

/// What drawing the item takes more than drawing nothing.
fn difference(label: Label) -> Result<u64, String> {
    let (something, nothing) = (total(label, "1")?, total(label, "0")?);
    something.checked_sub(nothing).ok_or_else(|| format!("{label:?}: less than nothing"))
}

/// All instructions of a process that draws the item, or nothing.
fn total(label: Label, draws: &str) -> Result<u64, String> {
    let this = std::env::current_exe().map_err(|why| why.to_string())?;
    let output = Command::new("valgrind")
        .args(["--tool=callgrind", "--callgrind-out-file=/dev/null"])
        .arg(this)
        .args([COUNTED, &name(label), label.who, draws])
        .output()
        .map_err(|why| why.to_string())?;
    let said = String::from_utf8_lossy(&output.stderr);
    let collected = said.lines().find_map(|line| line.split_once("Collected : "));
    match collected.and_then(|(_, number)| number.trim().parse().ok()) {
        Some(total) if output.status.success() => Ok(total),
        _ => Err(format!("{label:?}: {}\n{said}", output.status)),
    }
}
