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

use crate::items::{self, Draw, Label, MEMORY, Surface, Visitor};

/// The argument that makes this program draw one item, to be counted.
pub const COUNTED: &str = "--counted";

/// Keeps the C library from filling and copying long blocks by one instruction that repeats itself,
/// which some processors have and which callgrind counts once a byte.
const PLAIN_LOOPS: &str = "glibc.cpu.x86_rep_stosb_threshold=1000000000:glibc.cpu.x86_rep_movsb_threshold=1000000000";

/// What this program does then: draws the item `wanted` (item, panel, who) once, or nothing.
pub fn draw(wanted: &[String], draws: bool) {
    items::all(&mut [0; MEMORY], &mut One { wanted, draws });
}

struct One<'a> {
    wanted: &'a [String],
    draws: bool,
}

impl Visitor for One<'_> {
    fn visit<S: Surface>(&mut self, label: Label, surface: &mut S, draw: Draw<S>) {
        if self.wanted == [label.item, label.panel, label.who] {
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

/// What drawing the item takes more than drawing nothing, for one of its frames.
fn difference(label: Label) -> Result<u64, String> {
    let (something, nothing) = (total(label, "1")?, total(label, "0")?);
    let all = something.checked_sub(nothing).ok_or_else(|| format!("{label:?}: less than nothing"))?;
    Ok(all / u64::from(label.frames))
}

/// All instructions of a process that draws the item, or nothing.
fn total(label: Label, draws: &str) -> Result<u64, String> {
    let this = std::env::current_exe().map_err(|why| why.to_string())?;
    let output = Command::new("valgrind")
        .env("GLIBC_TUNABLES", PLAIN_LOOPS)
        .args(["--tool=callgrind", "--callgrind-out-file=/dev/null"])
        .arg(this)
        .args([COUNTED, label.item, label.panel, label.who, draws])
        .output()
        .map_err(|why| why.to_string())?;
    let said = String::from_utf8_lossy(&output.stderr);
    let collected = said.lines().find_map(|line| line.split_once("Collected : "));
    match collected.and_then(|(_, number)| number.trim().parse().ok()) {
        Some(total) if output.status.success() => Ok(total),
        _ => Err(format!("{label:?}: {}\n{said}", output.status)),
    }
}
