//! Findings in one line each, as editors and grep read them.

use std::io::{self, Write};

use super::few::{Part, parts};
use super::places::Places;
use super::{Shown, words};
use crate::diag::{Report, terminal_safe};
use crate::text::LineColumn;

/// Writes `path:line:column: error[E0306]: message` for every finding. The word of the severity is the same in every
/// language: programs look for it. What is left out has a line without one.
pub(super) fn write(report: &Report, shown: Shown, out: &mut dyn Write) -> io::Result<()> {
    let places = Places::new(report.sources());
    let lang = shown.lang;
    for part in parts(report, shown.all) {
        let item = match part {
            Part::Finding(item) => item,
            Part::More(more) => {
                writeln!(out, "{}", words::more(&more, &terminal_safe(places.name(more.file)), lang))?;
                continue;
            }
        };
        let (severity, code) = (item.severity.name(), item.diagnostic.code());
        let LineColumn { line, column } = places.start(item.diagnostic.at);
        let name = terminal_safe(places.name(item.diagnostic.at.file));
        let message = item.diagnostic.finding.message(lang);
        writeln!(out, "{name}:{line}:{column}: {severity}[{code}]: {}", terminal_safe(&message))?;
    }
    Ok(())
}

#[cfg(test)]
mod tests {
    use crate::diag::Format;
    use crate::diag::render::samples::{self, rendered};
    use crate::dict::Lang;

    #[test]
    fn a_line_each() {
        insta::assert_snapshot!(rendered(Format::Short, &samples::plain(), Lang::En, true), @"
        part.nc:2:14: error[E0306]: `X` is written twice in this block
        part.nc:3:9: error[E0104]: a decimal comma
        part.nc:4:1: warning[W0214]: block N30 is empty
        ");
        insta::assert_snapshot!(rendered(Format::Short, &samples::mixed(), Lang::Cs, false), @"
        dos.nc:2:13: warning[W0503]: R1 se čte dřív, než mu program dal hodnotu
        dos.nc:3:8: error[E0205]: program nemá konec: v žádném bloku není M02 ani M30
        missing.nc:1:1: error[E0112]: soubor nelze přečíst: soubor neexistuje
        missing.nc:1:1: error[E0201]: chybí %: systém by celý soubor přeskočil
        ");
        insta::assert_snapshot!(rendered(Format::Short, &samples::called(), Lang::Cs, false), @r"cykly/\u{1b}[31mL9081:2:7: error[E0510]: R1 má hodnotu 2.5, ale D musí být celé číslo");
    }
}
