//! Changes as lines for people (CMP-3).

use std::collections::BTreeMap;

use super::changes::{Blocks, Change, ChangeKind, merged};
use super::json::Side;
use super::steps::Value;
use super::words::Words;
use crate::analysis::motion::{clock, trimmed};
use crate::diag::terminal_safe;
use crate::dict::{Decimal, Lang, Micro};

/// Lines without `--all`.
const MOST: usize = 40;

/// The changes, after what both programs take; at most so many lines as people read, or `all`.
pub fn text(old: &Side, new: &Side, changes: &[Change], all: bool, lang: Lang) -> String {
    let mut lines = vec![format!("{} → {}", old.name, new.name)];
    lines.extend(head(old, new, changes, lang));
    let room = if all { usize::MAX } else { MOST.saturating_sub(lines.len() + 1) };
    lines.extend(changes.iter().take(room).map(|change| line(change, lang)));
    if changes.len() > room {
        lines.push(Words::More { count: changes.len() - room }.text(lang));
    }
    lines.iter().map(|line| format!("{}\n", terminal_safe(line))).collect()
}

/// What both programs take, and how much differs with each tool.
pub(super) fn head(old: &Side, new: &Side, changes: &[Change], lang: Lang) -> Vec<String> {
    let mut lines = vec![Words::Blocks { old: old.blocks, new: new.blocks }.text(lang)];
    if let (Some(before), Some(after)) = (old.time_s, new.time_s) {
        let delta = format!("{:+.1}", after - before).replace('-', "−");
        lines.push(Words::Time { old: clock(before), new: clock(after), delta }.text(lang));
    }
    if changes.is_empty() {
        let words = if old.whole && new.whole { Words::Same } else { Words::SameSoFar };
        lines.push(words.text(lang));
    }
    lines.extend(by_tool(changes, lang));
    lines
}

/// How much differs with each tool, when that is more than one change can say.
fn by_tool(changes: &[Change], lang: Lang) -> Vec<String> {
    let mut of_tools: BTreeMap<Option<Decimal>, Vec<&Change>> = BTreeMap::new();
    for change in changes.iter().filter(|_| changes.len() > 1) {
        of_tools.entry(change.tool).or_default().push(change);
    }
    let tools = of_tools.into_iter().map(|(tool, changes)| (tool, changes.len(), blocks_of(&changes)));
    let named = |tool: Option<Decimal>| tool.map_or_else(|| Words::NoTool.text(lang), |tool| format!("T{tool}"));
    let line = |(tool, changes, blocks)| Words::Tool { tool: named(tool), changes, blocks }.text(lang);
    tools.take(MOST / 4).map(line).collect()
}

/// How many blocks some changes are in, one that has several counted once: of the new program, and of the old one where
/// a change has none in the new one.
fn blocks_of(changes: &[&Change]) -> u64 {
    let union = |blocks: &mut dyn Iterator<Item = &Blocks>| -> u64 {
        let runs = merged(blocks.flat_map(|blocks| blocks.runs.iter().copied()));
        runs.iter().map(|[from, to]| u64::from(to - from) + 1).sum()
    };
    let is_new = |change: &&&Change| change.new_blocks.count > 0;
    let new = union(&mut changes.iter().filter(is_new).map(|change| &change.new_blocks));
    new + union(&mut changes.iter().filter(|change| !is_new(change)).map(|change| &change.old_blocks))
}

/// A change.
pub(super) fn line(change: &Change, lang: Lang) -> String {
    let count = match change.count() {
        1 => Words::OneBlock,
        count => Words::ManyBlocks { count },
    };
    let count = count.text(lang);
    let behind = change.behind.map_or_else(String::new, |n| format!("{} ", Words::Behind { n }.text(lang)));
    let places = format!("{behind}({})", places(change, lang));
    let dwell = || Words::Dwell.text(lang);
    let what = change.what.as_ref().map_or_else(dwell, ToString::to_string);
    let signed = |millionths: i64| {
        let by = Micro::from_millionths(millionths).to_f64();
        format!("{}{}", if by < 0.0 { "−" } else { "+" }, trimmed(by.abs(), 6))
    };
    let plain = |millionths: i64| Micro::from_millionths(millionths).to_string();
    // A machinist reads diameters.
    let shown = |millionths: i64, show: &dyn Fn(i64) -> String| match change.halved {
        true => format!("{} (Ø {})", show(millionths), show(millionths.saturating_mul(2))),
        false => show(millionths),
    };
    let value = |value: &Option<Value>| match value {
        Some(Value::Number(number)) => shown(*number, &plain),
        Some(Value::Text(text)) => text.clone(),
        None => Words::None.text(lang),
    };
    let words = match change.kind {
        ChangeKind::Added => Words::Added { count, places },
        ChangeKind::Removed => Words::Removed { count, places },
        ChangeKind::Position if change.delta.is_some() => {
            Words::Shift { what, by: shown(change.delta.unwrap_or(0), &signed), count, places }
        }
        kind if kind != ChangeKind::Position && change.old.is_some() && change.old == change.new => {
            let at = |blocks: &Blocks| numbers(blocks).unwrap_or_default();
            Words::Moved { what, new: at(&change.new_blocks), old: at(&change.old_blocks) }
        }
        ChangeKind::Position
        | ChangeKind::Feed
        | ChangeKind::Speed
        | ChangeKind::Tool
        | ChangeKind::Function
        | ChangeKind::Dwell
        | ChangeKind::Stop
        | ChangeKind::Correction
        | ChangeKind::Data
        | ChangeKind::Parameter => {
            Words::Value { what, old: value(&change.old), new: value(&change.new), count, places }
        }
    };
    match change.tool {
        Some(tool) => format!("T{tool}: {}", words.text(lang)),
        None => words.text(lang),
    }
}

fn numbers(blocks: &Blocks) -> Option<String> {
    blocks.n.map(|(first, last)| if first == last { format!("N{first}") } else { format!("N{first}–N{last}") })
}

/// `N310–N1514, was N300–N1500`.
fn places(change: &Change, lang: Lang) -> String {
    match (numbers(&change.old_blocks), numbers(&change.new_blocks)) {
        (Some(old), Some(new)) if old == new => new,
        (Some(old), Some(new)) => format!("{new}, {}", Words::Was { places: old }.text(lang)),
        (old, new) => new.or(old).unwrap_or_default(),
    }
}
