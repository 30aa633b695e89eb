//! Findings as workflow commands of GitHub Actions, which shows them beside the lines of a change.

use std::io::{self, Write};

use super::places::Places;
use crate::diag::{Report, terminal_safe};
use crate::dict::Lang;

/// Writes `::error file=…,line=…,col=…,endLine=…,endColumn=…,title=E0306::message` for every finding. The help, where
/// there is one, is a second line of the message.
pub(super) fn write(report: &Report, lang: Lang, out: &mut dyn Write) -> io::Result<()> {
    let places = Places::new(report.sources());
    for item in report.items() {
        let (at, finding) = (item.diagnostic.at, &item.diagnostic.finding);
        let (start, end) = (places.start(at), places.end(at));
        let (command, code) = (item.severity.name(), item.diagnostic.code());
        let file = property(&terminal_safe(places.name(at.file)));
        let mut message = data(&terminal_safe(&finding.message(lang)));
        if let Some(help) = finding.help(lang) {
            message.push_str("%0A");
            message.push_str(&data(&terminal_safe(&help)));
        }
        writeln!(
            out,
            "::{command} file={file},line={},col={},endLine={},endColumn={},title={code}::{message}",
            start.line, start.column, end.line, end.column
        )?;
    }
    Ok(())
}

/// Text after the last `::`.
fn data(text: &str) -> String {
    text.replace('%', "%25").replace('\r', "%0D").replace('\n', "%0A")
}

/// The value of a property.
fn property(text: &str) -> String {
    data(text).replace(':', "%3A").replace(',', "%2C")
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::diag::render::samples::{self, rendered};
    use crate::diag::{Diagnostic, Finding, Format};

    #[test]
    fn commands() {
        insta::assert_snapshot!(rendered(Format::Github, &samples::plain(), Lang::En, true), @"
        ::error file=part.nc,line=2,col=14,endLine=2,endColumn=16,title=E0306::`X` is written twice in this block%0Akeep one of them, or begin a new block with `N…`
        ::error file=part.nc,line=3,col=9,endLine=3,endColumn=14,title=E0104::a decimal comma%0Athe control knows the decimal point only: write `X36.12`
        ::warning file=part.nc,line=4,col=1,endLine=4,endColumn=4,title=W0214::block N30 is empty%0Adelete it, or say in a comment what it is for
        ");
        insta::assert_snapshot!(rendered(Format::Github, &samples::called(), Lang::Cs, false), @r"::error file=cykly/\u{1b}[31mL9081,line=2,col=7,endLine=2,endColumn=10,title=E0510::R1 má hodnotu 2.5, ale D musí být celé číslo");
    }

    #[test]
    fn what_delimits_commands_is_escaped() {
        let sources = samples::sources(&[("C:\\a,b%.nc", b"")]);
        let at = crate::text::Location::default();
        let report = samples::report(&sources, [Diagnostic::new(Finding::MissingProgramStart { number: 1 }, at)]);
        insta::assert_snapshot!(rendered(Format::Github, &report, Lang::En, false), @r"::error file=C%3A\a%2Cb%25.nc,line=1,col=1,endLine=1,endColumn=1,title=E0201::no `%25`: the control would ignore the whole file%0Abegin the program with `%25` and its number: `%251`");
    }
}
