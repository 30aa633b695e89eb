//! What `compare` says to people, in both languages.

use crate::dict::bilingual;

bilingual! {
    /// Lines.
    Words {
        Same "the programs do the same", "programy dělají totéž";
        Blocks { old: u64, new: u64 } "blocks {old} → {new}", "bloků {old} → {new}";
        Time { old: String, new: String, delta: String } "time {old} → {new} ({delta} s)", "čas {old} → {new} ({delta} s)";
        Shift { what: String, by: String, count: String, places: String } "{what} {by} in {count} {places}", "{what} {by}, {count} {places}";
        Value { what: String, old: String, new: String, count: String, places: String } "{what} {old} → {new} in {count} {places}", "{what} {old} → {new}, {count} {places}";
        Moved { what: String, new: String, old: String } "{what} now in {new} (was {old})", "{what} nyní v {new} (bylo {old})";
        Added { count: String, places: String } "{count} added {places}", "přidáno: {count} {places}";
        Removed { count: String, places: String } "{count} removed {places}", "odebráno: {count} {places}";
        OneBlock "1 block", "bloků: 1";
        ManyBlocks { count: u64 } "{count} blocks", "bloků: {count}";
        Dwell "dwell", "prodleva";
        None "none", "není";
        Was { places: String } "was {places}", "bylo {places}";
        More { count: usize } "and {count} more changes; --all lists them", "a dalších změn: {count}; vypíše je --all";
    }
}
