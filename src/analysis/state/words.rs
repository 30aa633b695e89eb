//! What `state` says to people, in both languages.

use super::place::{Arrival, Asked, CallAt, Place, PlaceFault};
use crate::analysis::motion::clock;
use crate::dict::{Lang, bilingual};

bilingual! {
    /// Headings, cells, and why there is no answer.
    Words {
        Before { place: String, name: String } "Before {place} of {name}", "Před {place} v {name}";
        Behind { place: String, name: String } "Behind {place} of {name}", "Za {place} v {name}";
        Block { n: u32, line: u32, seq: u64 } "N{n} (line {line}, seq {seq})", "N{n} (řádek {line}, seq {seq})";
        BlockIn { n: u32, file: String, line: u32, seq: u64 }
            "N{n} of {file} (line {line}, seq {seq})",
            "N{n} v {file} (řádek {line}, seq {seq})";
        Main "in the main program", "v hlavním programu";
        Call { l: u32, by: String, n: u32, line: u32, pass: u32, of: u32 }
            "L{l} called by {by} in N{n} (line {line}), pass {pass} of {of}",
            "L{l} voláno {by} z N{n} (řádek {line}), průchod {pass} z {of}";
        Calls "Calls", "Volání";
        Counter { n: u32, line: u32, left: u32, of: u32 }
            "N{n} (line {line}): {left} of {of} left",
            "N{n} (řádek {line}): zbývá {left} z {of}";
        Counters "Jump counters", "Počítadla skoků";
        Position "Position", "Poloha";
        GFunctions "G functions", "G funkce";
        MFunctions "M functions", "M funkce";
        Values "Values", "Hodnoty";
        Parameters "Parameters", "Parametry";
        Progress "Progress", "Průběh";
        Done "done", "hotovo";
        Left "left", "zbývá";
        ThisTool "this tool", "tento nástroj";
        Blocks "blocks", "bloků";
        Path "path, mm", "dráha, mm";
        Time "time", "čas";
        AtLeast
            "times and paths are at least these: some are not known",
            "časy a dráhy jsou nejméně takové: některé nejsou známy";
        NoTimes { blocks: u64 }
            "no times: more than {blocks} blocks, and the project file has no [motion]",
            "bez časů: bloků je víc než {blocks} a projektový soubor nemá [motion]";
        NoMotion
            "no times, and paths as far as lengths are known: the project file has no [motion]",
            "bez časů, dráhy jen ze známých délek: projektový soubor nemá [motion]";
        NextToolChange { seq: u64 } "next tool change: seq {seq}", "příští výměna nástroje: seq {seq}";
        NextStop { seq: u64 } "next stop: seq {seq}", "příští zastavení: seq {seq}";
        NextRapid { seq: u64 } "next rapid traverse: seq {seq}", "příští rychloposuv: seq {seq}";
        PowerUp "since power-up", "od zapnutí";
        By { n: u32, line: u32 } "N{n} (line {line})", "N{n} (řádek {line})";
        ByIn { n: u32, line: u32, l: u32 } "N{n} (line {line}) in L{l}", "N{n} (řádek {line}) v L{l}";
        NotProgrammed "not programmed yet", "dosud neprogramováno";
        ValueNotKnown "not known here", "zde není známo";
        OthersNotKnown "others", "ostatní";
        FromMachine "from the machine's table, not known here", "z tabulky stroje, zde neznámý";
        NotKnown { why: String } "not known: {why}", "není známa: {why}";
        Gear "gear", "převodový stupeň";
        Tool "in the spindle", "ve vřetenu";
        DynamicSet "dynamic set", "sada dynamiky";
        NoBlock { place: String } "{place}: there is no such block", "{place}: takový blok neexistuje";
        NoBlockNear { place: String, near: u32 }
            "{place}: there is no such block; the nearest number is N{near}",
            "{place}: takový blok neexistuje; nejbližší číslo je N{near}";
        NotExecuted { place: String } "{place} is never executed", "{place} se nikdy neprovede";
        Beyond { place: String, blocks: u64 }
            "{place}: blocks that the program executes: {blocks}, the first is seq 0",
            "{place}: bloků, které program provede: {blocks}, první má seq 0";
        Last { place: String }
            "{place}: nothing comes behind it, the program ends there",
            "{place}: za ním už nic není, program zde končí";
        TooLate { time: String } "--time: the program takes {time}", "--time: program trvá {time}";
        Passes { place: String, count: u64 } "{place}: --pass counts to {count}", "{place}: --pass jde do {count}";
        NoFile { file: String }
            "--file {file}: no macrocycle of that name is executed",
            "--file {file}: makrocyklus toho jména se neprovádí";
        NoProgram "the program executes no block", "program neprovede žádný blok";
        Several { place: String, count: u64 }
            "{place} is executed {count} times; choose one with --pass:",
            "{place} se provede {count}krát; jedno z provedení vybrat volbou --pass:";
        Pass { seq: u64, n: u32, line: u32, calls: String }
            "N{n}, line {line}, seq {seq}, {calls}",
            "N{n}, řádek {line}, seq {seq}, {calls}";
        MorePasses { more: u64 } "  and {more} more", "  a dalších {more}";
        ShortCall { l: u32, n: u32, pass: u32, of: u32 } "L{l} from N{n} ({pass}/{of})", "L{l} z N{n} ({pass}/{of})";
    }
}

fn named(asked: &Asked) -> String {
    match asked.place {
        Place::N(n) => format!("N{n}"),
        Place::Line(line) => format!("--line {line}"),
        Place::Seq(seq) => format!("--seq {seq}"),
        Place::Tool(tool) => format!("--at-tool T{tool}"),
    }
}

/// Why there is no answer, one line or, of several executions, a list.
pub fn fault_text(fault: &PlaceFault, asked: &Asked, lang: Lang) -> String {
    let place = named(asked);
    let words = match fault {
        PlaceFault::Missing { near: Some(near) } => Words::NoBlockNear { place, near: *near },
        PlaceFault::Missing { near: None } => Words::NoBlock { place },
        PlaceFault::NotExecuted => Words::NotExecuted { place },
        PlaceFault::Beyond { blocks } if asked.after && !matches!(asked.place, Place::Seq(seq) if seq >= *blocks) => {
            Words::Last { place }
        }
        PlaceFault::Beyond { blocks } => Words::Beyond { place, blocks: *blocks },
        PlaceFault::TooLate { seconds } => Words::TooLate { time: clock(*seconds) },
        PlaceFault::Passes { count } => Words::Passes { place, count: *count },
        PlaceFault::File => match &asked.file {
            Some(file) => Words::NoFile { file: file.clone() },
            None => Words::NoProgram,
        },
        PlaceFault::Several { arrivals, count } => return several(place, arrivals, *count, lang),
    };
    words.text(lang)
}

fn several(place: String, arrivals: &[Arrival], count: u64, lang: Lang) -> String {
    let mut lines = vec![Words::Several { place, count }.text(lang)];
    for (pass, arrival) in (1_usize..).zip(passes_text(arrivals, lang)) {
        lines.push(format!("  --pass {pass}  {arrival}"));
    }
    let more = count - arrivals.len() as u64;
    if more > 0 {
        lines.push(Words::MorePasses { more }.text(lang));
    }
    lines.join("\n")
}

/// Executions of a block, each in a line: where it is, and how execution got there.
pub fn passes_text(arrivals: &[Arrival], lang: Lang) -> Vec<String> {
    let short = |call: &CallAt| Words::ShortCall { l: call.l, n: call.n, pass: call.pass, of: call.of }.text(lang);
    let line = |arrival: &Arrival| {
        let Arrival { seq, n, line, calls } = arrival;
        let calls = match calls.as_slice() {
            [] => Words::Main.text(lang),
            calls => calls.iter().map(short).collect::<Vec<_>>().join(", "),
        };
        Words::Pass { seq: *seq, n: *n, line: *line, calls }.text(lang)
    };
    arrivals.iter().map(line).collect()
}
