//! Who may use whom, checked against the source text: stages use words, and never each other.

use std::{collections::BTreeSet, fs, path::Path};

/// Files directly in `src/`, and what each uses: only words above it, so that there is no cycle.
const WORDS: [(&str, &[&str]); 41] = [
    ("error", &[]),
    ("num", &[]),
    ("palette", &[]),
    ("list", &[]),
    ("sort", &["list"]),
    ("angle", &["num"]),
    ("colour", &["num"]),
    ("coverage", &["num"]),
    ("fog", &["colour", "error", "num"]),
    ("illumination", &["colour", "num"]),
    ("space", &["num"]),
    ("srgb", &["colour", "num", "palette"]),
    ("blend", &["colour", "coverage", "num", "palette", "srgb"]),
    ("style", &["coverage", "num"]),
    ("span", &["space"]),
    ("outcode", &["space"]),
    ("matrix", &["num", "space"]),
    ("edge", &["num", "space"]),
    ("cut", &["edge", "num", "space"]),
    ("vary", &["num", "space"]),
    ("slopes", &["num", "space", "vary"]),
    ("polynomial", &["num", "space"]),
    ("pieces", &["angle", "edge", "num", "polynomial", "space"]),
    ("outline", &["edge", "num", "pieces", "space"]),
    ("stretch", &["edge", "num", "outline", "pieces", "space"]),
    ("affine", &["angle", "num", "outline", "pieces", "space"]),
    ("arc", &["angle", "edge", "error", "num", "outline", "pieces", "space"]),
    ("curve", &["arc", "outline", "pieces", "space"]),
    ("em", &["affine", "num", "space"]),
    ("typeface", &["curve", "em", "num", "outline", "space"]),
    ("lines", &["typeface"]),
    ("text", &["affine", "em", "lines", "num", "outline", "space", "typeface"]),
    ("svg_number", &["error", "num"]),
    ("svg_arc", &["angle", "num", "svg_number"]),
    ("svg_data", &["num", "svg_arc", "svg_number"]),
    ("svg", &["affine", "curve", "edge", "num", "outline", "space", "svg_data", "svg_number"]),
    ("phase", &["num"]),
    ("shade", &["colour", "num"]),
    ("target", &["colour", "num", "phase", "shade", "space", "span", "vary"]),
    ("on_draw_target", &["num", "phase", "space", "target"]),
    ("runs", &["on_draw_target", "space", "target"]),
];
/// Folders; each may use every word.
const STAGES: [&str; 8] = ["model", "geometry", "clip", "raster", "hidden", "fragment", "tone", "display"];
/// The two modules that join the stages; the first has a folder, too.
const ABOVE_ALL: [&str; 2] = ["pipeline", "lib"];

/// Every file of `src/`: its path in there and its text.
fn sources() -> Vec<(String, String)> {
    let root = Path::new(env!("CARGO_MANIFEST_DIR")).join("src");
    let (mut folders, mut files) = (vec![root.clone()], vec![]);
    while let Some(folder) = folders.pop() {
        for entry in fs::read_dir(folder).expect("a folder") {
            let path = entry.expect("an entry").path();
            if path.is_dir() {
                folders.push(path);
                continue;
            }
            let name = path.strip_prefix(&root).expect("inside").components().map(|part| part.as_os_str().to_str());
            let name = name.collect::<Option<Vec<_>>>().expect("names in ASCII").join("/");
            files.push((name, fs::read_to_string(path).expect("text")));
        }
    }
    files
}

/// The word or stage of a file.
fn module(file: &str) -> &str {
    file.split(['/', '.']).next().unwrap_or(file)
}

/// The modules that a file names, outside of comments and of its tests.
fn uses(file: &str, text: &str) -> BTreeSet<String> {
    let text = without_tests(text);
    let code: String = text.lines().flat_map(|line| [line.split("//").next().unwrap_or(line), "\n"]).collect();
    let behind = |prefix| code.match_indices(prefix).flat_map(|(at, prefix)| heads(&code[at + prefix.len()..]));
    // From within a stage it takes two `super` to leave it, from a folder in it three.
    let (depth, is_mod) = (file.matches('/').count(), file.ends_with("/mod.rs"));
    let leaves =
        |head: &&str| depth == 0 || (depth == 1 && (is_mod || *head == "super")) || (is_mod && *head == "super");
    behind("crate::").chain(behind("super::").filter(leaves)).map(str::to_owned).collect()
}

/// Cuts out the unit tests, which rustfmt ends by a brace at the beginning of a line.
fn without_tests(text: &str) -> String {
    let Some((code, tests)) = text.split_once("\n#[cfg(test)]\n") else { return text.to_owned() };
    let behind = tests.split_once("\n}\n").map_or("", |(_, behind)| behind);
    code.to_owned() + &without_tests(behind)
}

/// The first name of a path, or of each path of a list in braces.
fn heads(path: &str) -> Vec<&str> {
    let path = path.trim_start();
    if !path.starts_with('{') {
        let name = path.split(|sign: char| !sign.is_alphanumeric() && !"_*".contains(sign)).next();
        return name.into_iter().filter(|name| !name.is_empty()).collect();
    }
    let (mut depth, mut names) = (0, vec![]);
    for (at, sign) in path.char_indices() {
        depth += i32::from(sign == '{') - i32::from(sign == '}');
        match (depth, sign) {
            (0, _) => break,
            (1, '{' | ',') => names.extend(heads(&path[at + 1..])),
            _ => {}
        }
    }
    names
}

fn is_allowed(from: &str, to: &str) -> bool {
    let word = |name: &str| WORDS.iter().find(|(word, _)| *word == name);
    let own = from == to || ABOVE_ALL.contains(&from);
    own || word(from).is_some_and(|(_, used)| used.contains(&to)) || STAGES.contains(&from) && word(to).is_some()
}

/// What a file uses and may not.
fn breaches(file: &str, text: &str) -> Vec<String> {
    uses(file, text).into_iter().filter(|used| !is_allowed(module(file), used)).collect()
}

#[test]
fn files_are_words_and_folders_are_stages() {
    let found: BTreeSet<_> = sources()
        .iter()
        .map(|(file, _)| file.split_once('/').map_or(file.clone(), |(stage, _)| format!("{stage}/")))
        .collect();
    let words = WORDS.map(|(word, _)| word).into_iter().chain(ABOVE_ALL).map(|word| format!("{word}.rs"));
    let folders = STAGES.into_iter().chain([ABOVE_ALL[0]]).map(|stage| format!("{stage}/"));
    assert_eq!(found, words.chain(folders).collect());
}

#[test]
fn words_use_only_words_above_them_in_the_table() {
    for (at, (word, used)) in WORDS.iter().enumerate() {
        for name in *used {
            assert!(WORDS[..at].iter().any(|(above, _)| above == name), "{word} uses {name}");
        }
    }
}

#[test]
fn every_file_uses_what_it_may() {
    for (file, text) in sources() {
        assert_eq!(breaches(&file, &text), [""; 0], "{file} uses these against the table");
    }
}

#[test]
fn the_table_has_no_arrow_that_the_source_has_not() {
    let sources = sources();
    for (word, allowed) in WORDS {
        let file = format!("{word}.rs");
        let (_, text) = sources.iter().find(|(name, _)| *name == file).expect("listed");
        let used = uses(&file, text);
        assert!(allowed.iter().all(|name| used.contains(*name)), "{word} uses only {used:?}");
    }
}

#[test]
fn a_stage_that_uses_another_is_caught() {
    let planted =
        |line: &str| breaches("raster/polygon.rs", &format!("//! Polygons.\n\nuse crate::num::bits;\n{line}\n"));
    assert_eq!(planted("use crate::display::frame;"), ["display"]);
    assert_eq!(
        planted("use crate::{\n    edge::{Edge, first_row},\n    hidden::{depth::{self}, x},\n    span,\n};"),
        ["hidden"]
    );
    assert_eq!(planted("use crate::{{clip, geometry}, model};"), ["clip", "geometry", "model"]);
    assert_eq!(planted("fn f() { crate::pipeline::draw_mesh() }"), ["pipeline"]);
    assert_eq!(planted("use super::super::display;"), ["super"]);
    assert_eq!(planted("use super::{super::display};"), ["super"]);
    assert_eq!(planted("use crate::{space, Frame};"), ["Frame"]);
    assert_eq!(planted("use crate::*;"), ["*"]);
    assert_eq!(planted("#[cfg(test)]\nmod tests {\n    use crate::clip;\n}\nuse crate::hidden::depth;"), ["hidden"]);
    assert_eq!(breaches("raster/mod.rs", "use super::{clip, edge};"), ["clip"]);
    assert_eq!(breaches("span.rs", "use super::{num, space::Rect};"), ["num"]);
}

#[test]
fn what_is_allowed_and_what_is_no_code_is_not_caught() {
    let harmless = "//! See [`Frame`](crate::Frame).\nuse super::{bresenham::Line, triangle};\nuse crate::{raster::polygon, num};\n\
                    let here = 1; // not crate::display\n#[cfg(test)]\nmod tests {\n    use crate::display;\n}\n";
    assert_eq!(breaches("raster/polygon.rs", harmless), [""; 0]);
    assert_eq!(breaches("pipeline.rs", "use crate::{display::frame, num};"), [""; 0]);
}

#[test]
fn every_file_says_first_what_it_is_and_has_at_most_400_lines() {
    for (file, text) in sources() {
        assert!(text.starts_with("//! "), "{file} begins without a sentence about itself");
        assert!(text.lines().count() <= 400, "{file} has {} lines", text.lines().count());
    }
}
