//! Counts the instructions that aquatint and its peers take for the same pictures.
//!
//! `cargo bench` first compares the pictures, then counts every item under valgrind, prints a
//! table and writes the `host` lines of `benches/results.tsv`. `cargo bench -- line` counts only
//! the items whose name contains `line` and writes their lines. `cargo bench -- --test`, like
//! `cargo test --benches`, only compares the pictures. The other lines of the file are written by
//! `.ci/firmware bench`.

mod coverage;
mod pictures;
mod results;
mod valgrind;

#[path = "../items/mod.rs"]
mod items;

use std::process::ExitCode;

use items::{Draw, Label, MEMORY, Surface, Visitor};

fn main() -> ExitCode {
    let arguments: Vec<String> = std::env::args().skip(1).collect();
    if let [mode, wanted @ .., draws] = &arguments[..]
        && mode == valgrind::COUNTED
    {
        valgrind::draw(wanted, draws != "0");
        return ExitCode::SUCCESS;
    }
    let is_benchmark = arguments.iter().any(|argument| argument == "--bench");
    let is_test = arguments.iter().any(|argument| argument == "--test");
    let filter = arguments.iter().find(|argument| !argument.starts_with('-'));
    match run(is_benchmark && !is_test, filter.map(String::as_str)) {
        Ok(()) => ExitCode::SUCCESS,
        Err(why) => {
            eprintln!("{why}");
            ExitCode::FAILURE
        }
    }
}

/// Compares, and then counts if it `is_benchmark`.
fn run(is_benchmark: bool, filter: Option<&str>) -> Result<(), String> {
    println!("{}\n{}", pictures::compare()?, coverage::compare()?);
    if !is_benchmark {
        return Ok(());
    }
    let mut list = Labels(Vec::new());
    items::all(&mut [0; MEMORY], &mut list);
    list.0.retain(|label| filter.is_none_or(|part| name(*label).contains(part)));
    let counts = valgrind::count(&list.0)?;
    print!("{}", results::table(&counts));
    results::write(&counts, filter.is_none()).map_err(|why| format!("{}: {why}", results::FILE))
}

/// Collects what there is.
struct Labels(Vec<Label>);

impl Visitor for Labels {
    fn visit<S: Surface>(&mut self, label: Label, _surface: &mut S, _draw: Draw<S>) {
        self.0.push(label);
    }
}

/// The item with its panel, as the results call it.
fn name(label: Label) -> String {
    format!("{}/{}", label.item, label.panel)
}
