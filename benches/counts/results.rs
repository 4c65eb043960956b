//! The table on the screen, and the file of results.

use std::{collections::BTreeSet, fmt::Write as _, fs, io};

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
    let items: BTreeSet<_> = counts.iter().map(|(label, _)| (label.panel, label.item)).collect();
    let mut table = format!("{:20} {OURS:>10} {:>10} {:>8}\n", "instructions", "peer", "ratio");
    for item in items {
        write_item(&mut table, counts.iter().filter(|(label, _)| (label.panel, label.item) == item));
    }
    table
}

fn write_item<'c>(table: &mut String, counts: impl Iterator<Item = &'c (Label, u64)>) {
    let (ours, mut peers): (Vec<&(Label, u64)>, Vec<_>) = counts.partition(|(label, _)| label.who == OURS);
    peers.sort_by_key(|(peer, _)| peer.who);
    let Some((label, _)) = ours.first().or(peers.first()) else { return };
    let ours = ours.first().map(|(_, count)| *count);
    let count = ours.map_or_else(String::new, |count| count.to_string());
    let _ = write!(table, "{:20} {count:>10}", name(*label));
    for (line, (peer, theirs)) in peers.iter().enumerate() {
        let indent = if line == 0 { String::new() } else { format!("\n{:31}", "") };
        let ratio = ours.map_or_else(String::new, |ours| ratio(*theirs, ours));
        let _ = write!(table, "{indent} {theirs:>10} {ratio:>8} {}", peer.who);
    }
    table.push('\n');
}

/// To a tenth, rounded down.
fn ratio(theirs: u64, ours: u64) -> String {
    let tenths = (10 * theirs).checked_div(ours).unwrap_or(0);
    format!("{}.{}", tenths / 10, tenths % 10)
}

/// Replaces the lines of what was counted; where that is all, no others of this platform stay.
pub fn write(counts: &[(Label, u64)], is_all: bool) -> io::Result<()> {
    let before = fs::read_to_string(FILE).unwrap_or_default();
    let keys: BTreeSet<String> = counts.iter().map(|(label, _)| key(*label)).collect();
    let is_other = |line: &&str| {
        let is_ours = line.starts_with(&format!("{PLATFORM}\t"));
        !is_ours || !is_all && line.rsplit_once('\t').is_none_or(|(key, _)| !keys.contains(key))
    };
    let mut lines: Vec<String> = before.lines().filter(is_other).map(str::to_owned).collect();
    lines.extend(counts.iter().map(|&(label, count)| format!("{}\t{count}", key(label))));
    lines.sort();
    fs::write(FILE, lines.join("\n") + "\n")
}

fn key(label: Label) -> String {
    format!("{PLATFORM}\t{}\t{}", name(label), label.who)
}
