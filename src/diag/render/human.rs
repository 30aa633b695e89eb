//! Findings for people, on a terminal: what is wrong, the lines of the program, why, and what to write.

use std::collections::BTreeSet;
use std::io::{self, Write};

use super::Shown;
use super::excerpt::Excerpt;
use super::few::{Part, parts};
use super::frame::{self, Mark};
use super::places::Places;
use super::style::{Style, paint};
use super::words::{self, Words};
use crate::diag::{CallSite, Diagnostic, Fix, FixTitle, Report, Reported, Severity, terminal_safe};
use crate::dict::Lang;
use crate::text::{FileId, LineColumn, Span};

/// Calls listed from the finding outwards, before the rest is counted.
const NEAREST_CALLS: usize = 3;
/// Calls listed in all.
const MOST_CALLS: usize = 5;
/// Programs that were not executed and are named.
const MOST_PROGRAMS: usize = 3;
/// Codes that the last line names.
const MOST_CODES: usize = 6;

/// Writes every finding, and a summary.
pub(super) fn write(report: &Report, shown: Shown, out: &mut dyn Write) -> io::Result<()> {
    let human = Human { places: Places::new(report.sources()), lang: shown.lang, colour: shown.colour };
    for part in parts(report, shown.all) {
        match part {
            Part::Finding(item) => out.write_all(human.finding(item).as_bytes())?,
            Part::More(more) => {
                let name = terminal_safe(human.places.name(more.file));
                writeln!(out, "{}\n", words::more(&more, &name, shown.lang))?;
            }
        }
    }
    human.summary(report, out)
}

struct Human<'a> {
    places: Places<'a>,
    lang: Lang,
    colour: bool,
}

impl Human<'_> {
    fn finding(&self, Reported { severity, diagnostic }: &Reported) -> String {
        let style = style_of(*severity);
        let message = terminal_safe(&diagnostic.finding.message(self.lang)).into_owned();
        let header = format!("{}[{}]", severity.text(self.lang), diagnostic.code());
        let mut text = paint(&header, style, self.colour);
        text.push_str(&paint(&format!(": {message}"), Style::Strong, self.colour));
        text.push('\n');
        let (lines, width) = self.frame(diagnostic, style);
        let bar = format!("  {:width$}{}", "", paint("│", Style::Faint, self.colour));
        for line in lines {
            text.push_str(&line);
            text.push('\n');
        }
        for (word, words) in self.remarks(diagnostic) {
            let word = paint(&word, Style::Accent, self.colour);
            text.push_str(&format!("{bar} {word}: {}\n", terminal_safe(&words)));
        }
        let end = format!("{}╯", "─".repeat(width + 2));
        text.push_str(&paint(&end, Style::Faint, self.colour));
        text.push_str("\n\n");
        text
    }

    /// The lines of the programs with their marks.
    fn frame(&self, diagnostic: &Diagnostic, style: Style) -> (Vec<String>, usize) {
        let mut files: Vec<(FileId, Vec<Span>)> = Vec::new();
        let mut marks = Vec::new();
        // The message says what is wrong at the place of the finding itself.
        let primary = (diagnostic.at, None);
        let labels = diagnostic.labels.iter().map(|label| (label.at, Some(label.text.text(self.lang))));
        for (index, (at, text)) in std::iter::once(primary).chain(labels).enumerate() {
            let excerpt = files.iter().position(|(file, _)| *file == at.file).unwrap_or_else(|| {
                files.push((at.file, Vec::new()));
                files.len() - 1
            });
            if let Some((_, spans)) = files.get_mut(excerpt) {
                spans.push(at.span);
                marks.push(Mark {
                    excerpt,
                    mark: spans.len() - 1,
                    text: text.map(|text| terminal_safe(&text).into_owned()),
                    primary: index == 0,
                });
            }
        }
        if self.places.source(diagnostic.at.file).is_none_or(|source| source.is_empty()) && files.len() == 1 {
            // Nothing to show: the file is empty, or could not be read.
            let place = format!("{}:1:1", terminal_safe(self.places.name(diagnostic.at.file)));
            return (vec![frame::place_line(&place, '╭', 1, self.colour)], 1);
        }
        let names: Vec<&str> = files.iter().map(|&(file, _)| self.places.name(file)).collect();
        let excerpts: Vec<Excerpt> =
            files.iter().map(|(file, spans)| Excerpt::new(&self.places, *file, spans)).collect();
        frame::draw(&excerpts, &names, &marks, style, self.colour)
    }

    /// The remarks below the program: the calls, why, what to write.
    fn remarks(&self, diagnostic: &Diagnostic) -> Vec<(String, String)> {
        let calls = calls(&self.places, diagnostic, self.lang).into_iter();
        let notes = calls.chain(diagnostic.finding.note(self.lang));
        let mut remarks: Vec<_> = notes.map(|note| (Words::Note.text(self.lang), note)).collect();
        let mut help = diagnostic.finding.help(self.lang);
        let message = diagnostic.finding.message(self.lang);
        // A help says already what the fix does, unless it cannot name what the fix writes.
        let unsaid = diagnostic.fixes.iter().filter(|fix| match (&help, &fix.title) {
            (None, _) => true,
            (Some(help), FixTitle::Write { text }) => {
                let said = |word: &str| help.contains(word) || message.contains(word);
                !help.contains(text.as_str()) && !text.split_whitespace().any(said)
            }
            (Some(_), _) => false,
        });
        let unsaid: Vec<&Fix> = unsaid.collect();
        // A help that names no word takes the one that the fix writes.
        let one = match (&mut help, unsaid.as_slice()) {
            (Some(help), [Fix { title: FixTitle::Write { text }, .. }]) if !help.contains(['`', '„']) => {
                help.push_str(": ");
                help.push_str(&Words::Quoted { word: text.clone() }.text(self.lang));
                true
            }
            _ => false,
        };
        let unsaid = unsaid.into_iter().filter(|_| !one).map(|fix| fix.title.text(self.lang));
        remarks.extend(help.iter().cloned().chain(unsaid).map(|help| (Words::Help.text(self.lang), help)));
        remarks
    }

    /// The last lines: how many, what can be fixed, where to read on.
    fn summary(&self, report: &Report, out: &mut dyn Write) -> io::Result<()> {
        let style = match (report.errors(), report.warnings()) {
            (0, 0) => Style::Strong,
            (0, _) => Style::Warning,
            (_, _) => Style::Error,
        };
        writeln!(out, "{}", paint(&words::summary(report, self.lang), style, self.colour))?;
        let by_code = report.by_code();
        // The lines around show a code alone, and codes that are found once each.
        let several = by_code.len() > 1 && by_code.values().any(|&count| count > 1);
        if several || by_code.len() > MOST_CODES {
            let counts: Vec<String> = by_code.iter().map(|(code, count)| format!("{code} ×{count}")).collect();
            writeln!(out, "{}", counts.join(", "))?;
        }
        for program in report.not_executed().iter().take(MOST_PROGRAMS) {
            let (file, reason) = (terminal_safe(&program.file).into_owned(), program.reason(self.lang));
            writeln!(out, "{}", Words::NotExecuted { file, reason }.text(self.lang))?;
        }
        let more = report.not_executed().len().saturating_sub(MOST_PROGRAMS);
        if more > 0 {
            writeln!(out, "{}", Words::MoreNotExecuted { count: more }.text(self.lang))?;
        }
        for program in report.stayed_unknown().iter().take(MOST_PROGRAMS) {
            writeln!(out, "{}: {}", terminal_safe(&program.file), program.text(self.lang))?;
        }
        // `--fix` changes only files that the command names or finds.
        let named: BTreeSet<&str> = report.files().iter().map(String::as_str).collect();
        let is_fixable = |item: &Reported| {
            item.diagnostic.certain_fix().is_some() && named.contains(self.places.name(item.diagnostic.at.file))
        };
        let fixable = report.items().filter(|item| is_fixable(item)).count();
        if fixable > 0 && report.programs() > 0 && !report.is_fixed() {
            writeln!(out, "{}", Words::Fixable { count: fixable }.text(self.lang))?;
        }
        if !by_code.is_empty() {
            let names: Vec<&str> = by_code.keys().take(MOST_CODES).map(|code| code.as_str()).collect();
            let more = if by_code.len() > MOST_CODES { " …" } else { "" };
            let codes = format!("{}{more}", names.join(" "));
            writeln!(out, "{}", Words::Explain { codes }.text(self.lang))?;
        }
        Ok(())
    }
}

/// The calls that led to the finding, the nearest first.
pub(super) fn calls(places: &Places<'_>, diagnostic: &Diagnostic, lang: Lang) -> Vec<String> {
    let called_by = |call: &CallSite| {
        let LineColumn { line, .. } = places.start(call.at);
        let place = if call.at.file == diagnostic.at.file {
            Words::Line { line }.text(lang)
        } else {
            format!("{}:{line}", places.name(call.at.file))
        };
        words::called_by(call, &place, lang)
    };
    let nearest_first = diagnostic.calls.iter().rev();
    let count = diagnostic.calls.len();
    if count <= MOST_CALLS {
        return nearest_first.map(called_by).collect();
    }
    let far = MOST_CALLS - NEAREST_CALLS;
    let mut calls: Vec<String> = nearest_first.clone().take(NEAREST_CALLS).map(called_by).collect();
    calls.push(Words::MoreCalls { count: count - MOST_CALLS }.text(lang));
    calls.extend(nearest_first.skip(count - far).map(called_by));
    calls
}

const fn style_of(severity: Severity) -> Style {
    match severity {
        Severity::Error => Style::Error,
        Severity::Warning => Style::Warning,
    }
}
