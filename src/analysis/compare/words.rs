//! What `compare` says to people, in both languages.

use crate::dict::bilingual;

bilingual! {
    /// Lines.
    Words {
        Same "the programs do the same", "programy dělají totéž";
        SameSoFar
            "as far as the programs could be executed, they do the same",
            "pokud se programy daly provést, dělají totéž";
        Blocks { old: u64, new: u64 } "blocks {old} → {new}", "bloků {old} → {new}";
        Time { old: String, new: String, delta: String }
            "time {old} → {new} ({delta} s)",
            "čas {old} → {new} ({delta} s)";
        Shift { what: String, by: String, count: String, places: String }
            "{what} {by} in {count} {places}",
            "{what} {by}, {count} {places}";
        Value { what: String, old: String, new: String, count: String, places: String }
            "{what} {old} → {new} in {count} {places}",
            "{what} {old} → {new}, {count} {places}";
        Moved { what: String, new: String, old: String }
            "{what} now in {new} (was {old})",
            "{what} nyní v {new} (bylo {old})";
        Added { count: String, places: String } "{count} added {places}", "přidáno {count} {places}";
        Removed { count: String, places: String } "{count} removed {places}", "odebráno {count} {places}";
        Behind { n: u32 } "after N{n}", "za N{n}";
        OneBlock "1 block", "bloků: 1";
        ManyBlocks { count: u64 } "{count} blocks", "bloků: {count}";
        Dwell "dwell", "prodleva";
        None "none", "není";
        Was { places: String } "was {places}", "bylo {places}";
        Tool { tool: String, changes: usize, blocks: u64 }
            "{tool}: changes {changes}, in blocks {blocks}",
            "{tool}: změn {changes}, v blocích {blocks}";
        NoTool "no tool", "bez nástroje";
        RowSame "the same", "totéž";
        RowSameSoFar "the same as far as executed", "totéž, pokud se daly provést";
        RowAdded "added", "přidán";
        RowRemoved "removed", "odebrán";
        RowBroken "errors", "chyby";
        RowChanges { changes: usize } "changes: {changes}", "změn: {changes}";
        RowChangesAndTime { changes: usize, delta: String }
            "changes: {changes}, time {delta} s",
            "změn: {changes}, čas {delta} s";
        Programs { count: usize, same: usize, different: usize, added: usize, removed: usize, broken: usize }
            "programs {count}: same {same}, different {different}, added {added}, removed {removed}, with errors \
            {broken}",
            "programů {count}: stejných {same}, různých {different}, přidaných {added}, odebraných {removed}, s \
            chybami {broken}";
        More { count: usize } "and {count} more changes; --all lists them", "a dalších změn: {count}; vypíše je --all";
    }
}
