//! The table on the screen, and the file of results.

use std::{fmt::Write as _, fs, io};

use crate::{
    items::{Label, OURS},
    name,
};

/// Lines of platform, item, who and instructions, parted by tabs and sorted.
pub const FILE: &str = concat!(env!("CARGO_MANIFEST_DIR"), "/benches/results.tsv");

/// What this platform is called in the file.
const PLATFORM: &str = "host";

/// A line for each item: our count, the peer's, and how many times ours that is. Further peers have lines of their own.
pub fn table(counts: &[(Label, u64)]) -> String {
    let mut ours: Vec<_> = counts.iter().filter(|(label, _)| label.who == OURS).collect();
    ours.sort_by_key(|(label, _)| (label.panel, label.item));
    let mut table = format!("{:20} {OURS:>10} {:>10} {:>8}\n", "instructions", "peer", "ratio");
    for &(label, count) in ours {
        let is_peer = |other: Label| other.who != OURS && (other.item, other.panel) == (label.item, label.panel);
        let mut peers: Vec<_> = counts.iter().filter(|(other, _)| is_peer(*other)).collect();
        peers.sort_by_key(|(peer, _)| peer.who);
        let _ = write!(table, "{:20} {count:>10}", name(label));
        if peers.is_empty() {
            table.push('\n');
        }
        for (line, (peer, theirs)) in peers.into_iter().enumerate() {
            let indent = if line == 0 { 0 } else { 31 };
            let _ = writeln!(table, "{:indent$} {theirs:>10} {:>8} {}", "", ratio(*theirs, count), peer.who);
        }
    }
    table
}

/// To a tenth, rounded down.
fn ratio(theirs: u64, ours: u64) -> String {
    let tenths = (10 * theirs).checked_div(ours).unwrap_or(0);
    format!("{}.{}", tenths / 10, tenths % 10)
}

/// Replaces the lines of this platform in the file.
pub fn write(counts: &[(Label, u64)]) -> io::Result<()> {
    let before = fs::read_to_string(FILE).unwrap_or_default();
    let is_other = |line: &&str| !line.starts_with(&format!("{PLATFORM}\t"));
    let mut lines: Vec<String> = before.lines().filter(is_other).map(str::to_owned).collect();
    lines.extend(counts.iter().map(|&(label, count)| format!("{PLATFORM}\t{}\t{}\t{count}", name(label), label.who)));
    lines.sort();
    fs::write(FILE, lines.join("\n") + "\n")
}
