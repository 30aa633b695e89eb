//! The words between findings, in both languages.

use super::few::More;
use crate::diag::{CallKind, CallSite, LIMIT_PER_CODE, Report};
use crate::dict::{Lang, bilingual};

bilingual! {
    /// The words of lines that hold no findings, and those that lead in.
    Words {
        Note "note", "poznámka";
        Help "help", "nápověda";
        Line { line: u32 } "line {line}", "řádek {line}";
        MoreCalls { count: usize } "… {count} more calls", "… dalších volání: {count}";
        NotExecuted { file: String, reason: String }
            "{file} was not executed because of {reason}",
            "{file} nebyl proveden kvůli {reason}";
        MoreNotExecuted { count: usize }
            "more programs that were not executed: {count}",
            "další neprovedené programy: {count}";
        Fixable { count: usize }
            "fixable with cnc872c check --fix: {count}",
            "opravitelné pomocí cnc872c check --fix: {count}";
        Quoted { word: String } "`{word}`", "„{word}“";
        Explain { codes: String } "details: cnc872c explain {codes}", "podrobnosti: cnc872c explain {codes}";
    }
}

/// The call, as in `called by N80 G71 L100 (line 9)`; `place` is `line 9`, or `part.nc:9` in another file.
pub(super) fn called_by(call: &CallSite, place: &str, lang: Lang) -> String {
    let CallSite { by, l, n, .. } = call;
    let name = by.name();
    match (by, lang) {
        (CallKind::Subprogram | CallKind::Macrocycle, Lang::En) => format!("called by N{n} {name} L{l} ({place})"),
        (CallKind::Subprogram | CallKind::Macrocycle, Lang::Cs) => format!("voláno z bloku N{n} {name} L{l} ({place})"),
        (CallKind::Cycle(_), Lang::En) => format!("called by N{n} {name} as L{l} ({place})"),
        (CallKind::Cycle(_), Lang::Cs) => format!("voláno z bloku N{n} {name} jako L{l} ({place})"),
    }
}

/// The last words of a run: `2 programs: 3 errors, 1 warning`.
pub(super) fn summary(report: &Report, lang: Lang) -> String {
    let (errors, warnings) = (report.errors(), report.warnings());
    let counts = match (errors, warnings, lang) {
        (0, 0, Lang::En) => "no errors".to_owned(),
        (0, 0, Lang::Cs) => "bez chyb".to_owned(),
        (_, 0, _) => counted(errors, ERRORS, lang),
        (0, _, _) => counted(warnings, WARNINGS, lang),
        (_, _, _) => format!("{}, {}", counted(errors, ERRORS, lang), counted(warnings, WARNINGS, lang)),
    };
    if report.programs() == 0 { counts } else { format!("{}: {counts}", counted(report.programs(), PROGRAMS, lang)) }
}

/// Findings of one code in one file that are not shown.
pub(super) fn more(more: &More, file: &str, lang: Lang) -> String {
    let More { code, count, counted, .. } = *more;
    let name = code.name();
    match (count == counted, counted, lang) {
        (true, _, Lang::En) => format!("{file}: {count} more {code} ({name}) are counted, but not kept"),
        (true, _, Lang::Cs) => format!("{file}: {code} ({name}) ještě {count}×, jen započteno"),
        (_, 0, Lang::En) => format!("{file}: {count} more {code} ({name}); --all shows them"),
        (_, 0, Lang::Cs) => format!("{file}: {code} ({name}) ještě {count}×; vypíše je --all"),
        (_, _, Lang::En) => format!("{file}: {count} more {code} ({name}); --all shows the first {LIMIT_PER_CODE}"),
        (_, _, Lang::Cs) => format!("{file}: {code} ({name}) ještě {count}×; --all vypíše prvních {LIMIT_PER_CODE}"),
    }
}

/// How many findings are not shown.
pub(super) fn suppressed(count: usize, lang: Lang) -> String {
    match lang {
        Lang::En if count == 1 => "1 more finding is counted, but not shown".to_owned(),
        Lang::En => format!("{count} more findings are counted, but not shown"),
        Lang::Cs => format!("další hlášení, která jsou započtena, ale ne vypsána: {count}"),
    }
}

/// A counted noun: English for one and for more; Czech for one, for two to four, for five and more.
type Noun = ([&'static str; 2], [&'static str; 3]);

const ERRORS: Noun = (["error", "errors"], ["chyba", "chyby", "chyb"]);
const WARNINGS: Noun = (["warning", "warnings"], ["varování", "varování", "varování"]);
const PROGRAMS: Noun = (["program", "programs"], ["program", "programy", "programů"]);

fn counted(count: usize, (en, cs): Noun, lang: Lang) -> String {
    let [one_en, more_en] = en;
    let [one_cs, few_cs, many_cs] = cs;
    let noun = match (lang, count) {
        (Lang::En, 1) => one_en,
        (Lang::En, _) => more_en,
        (Lang::Cs, 1) => one_cs,
        (Lang::Cs, 2..=4) => few_cs,
        (Lang::Cs, _) => many_cs,
    };
    format!("{count} {noun}")
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn plurals() {
        let cs = |count| counted(count, ERRORS, Lang::Cs);
        assert_eq!(
            [0, 1, 2, 4, 5, 21, 22, 100].map(cs),
            ["0 chyb", "1 chyba", "2 chyby", "4 chyby", "5 chyb", "21 chyb", "22 chyb", "100 chyb"]
        );
        let en = |count| counted(count, PROGRAMS, Lang::En);
        assert_eq!([0, 1, 2].map(en), ["0 programs", "1 program", "2 programs"]);
        assert_eq!(
            [1, 3, 5].map(|count| counted(count, WARNINGS, Lang::Cs)),
            ["1 varování", "3 varování", "5 varování"]
        );
    }
}
