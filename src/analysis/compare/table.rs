//! Two folders compared: a line for each program (CMP-7).

use super::json::Side;
use super::words::Words;
use crate::analysis::motion::trimmed;
use crate::diag::terminal_safe;
use crate::dict::Lang;

/// What became of a program.
#[derive(Clone, Debug)]
pub enum Verdict {
    /// Both do the same.
    Same,
    /// They do as far as they could be executed (`--partial`).
    SameSoFar,
    /// They differ in so many changes.
    Different {
        /// How many changes.
        changes: usize,
        /// The old program.
        old: Side,
        /// The new one.
        new: Side,
    },
    /// It is in the old folder alone.
    Removed,
    /// It is in the new folder alone.
    Added,
    /// It has errors, or cannot be read: in one of the folders that have it.
    Broken,
}

/// A program of two folders.
#[derive(Clone, Debug)]
pub struct Row {
    /// Its path in both.
    pub name: String,
    /// What became of it.
    pub verdict: Verdict,
}

/// The table, and how many there are of each.
pub fn table(rows: &[Row], lang: Lang) -> String {
    let width = rows.iter().map(|row| row.name.chars().count()).max().unwrap_or(0);
    let line = |row: &Row| {
        let pad = width.saturating_sub(row.name.chars().count());
        format!("{}{:pad$}  {}", row.name, "", verdict(&row.verdict, lang))
    };
    let count = |is: fn(&Verdict) -> bool| rows.iter().filter(|row| is(&row.verdict)).count();
    let sum = Words::Programs {
        count: rows.len(),
        same: count(|verdict| matches!(verdict, Verdict::Same | Verdict::SameSoFar)),
        different: count(|verdict| matches!(verdict, Verdict::Different { .. })),
        added: count(|verdict| matches!(verdict, Verdict::Added)),
        removed: count(|verdict| matches!(verdict, Verdict::Removed)),
        broken: count(|verdict| matches!(verdict, Verdict::Broken)),
    };
    let lines = rows.iter().map(line).chain([sum.text(lang)]);
    lines.map(|line| format!("{}\n", terminal_safe(&line))).collect()
}

fn verdict(verdict: &Verdict, lang: Lang) -> String {
    match verdict {
        Verdict::Same => Words::RowSame.text(lang),
        Verdict::SameSoFar => Words::RowSameSoFar.text(lang),
        Verdict::Removed => Words::RowRemoved.text(lang),
        Verdict::Added => Words::RowAdded.text(lang),
        Verdict::Broken => Words::RowBroken.text(lang),
        Verdict::Different { changes, old, new } => {
            let changes = *changes;
            match (old.time_s, new.time_s) {
                (Some(before), Some(after)) => {
                    let sign = if after < before { "−" } else { "+" };
                    let delta = format!("{sign}{}", trimmed((after - before).abs(), 1));
                    Words::RowChangesAndTime { changes, delta }.text(lang)
                }
                _ => Words::RowChanges { changes }.text(lang),
            }
        }
    }
}
