//! Excerpts with their marks, drawn by ariadne.
//!
//! Ariadne knows only the small texts that it gets: it numbers their lines from one, and calls them by their index.
//! Its drawing is read line by line; line numbers and places become those of the programs.

use std::fmt::{Debug, Display};

use ariadne::{Cache, Color, Config, IndexType, Label, Report, ReportKind, Source};

use super::excerpt::Excerpt;
use super::style::{Style, joined, paint};
use crate::diag::terminal_safe;
use crate::text::LineColumn;

/// A mark of an excerpt with what it says.
pub(super) struct Mark {
    /// Index of the excerpt.
    pub excerpt: usize,
    /// Index of the mark in it.
    pub mark: usize,
    /// Its text, on one line.
    pub text: Option<String>,
    /// Whether it is the place of the finding.
    pub primary: bool,
}

/// The frame of a finding: a line for each place and each line of the programs. The file of the first mark comes first.
/// `names` are those of the files of the excerpts. Returns the lines, and the width that line numbers take.
pub(super) fn draw(
    excerpts: &[Excerpt],
    names: &[&str],
    marks: &[Mark],
    main: Style,
    colour: bool,
) -> (Vec<String>, usize) {
    let span = |mark: &Mark| {
        let range = excerpts.get(mark.excerpt).and_then(|excerpt| excerpt.marks.get(mark.mark)).cloned();
        (mark.excerpt, range.unwrap_or_default())
    };
    let line = |mark: &Mark| {
        let (excerpt, range) = span(mark);
        let text = excerpts.get(excerpt).map(|excerpt| excerpt.text.chars().take(range.start));
        (excerpt, text.map(|before| before.filter(|character| *character == '\n').count()))
    };
    let mut report = Report::build(ReportKind::Error, marks.iter().find(|mark| mark.primary).map_or((0, 0..0), span))
        .with_config(Config::new().with_color(colour).with_index_type(IndexType::Char));
    // Ariadne keeps the marks of a file together only when their lines rise, and underlines those of a line beside the
    // first of them, if that has words.
    let mut order: Vec<&Mark> = marks.iter().collect();
    order.sort_by_key(|mark| (mark.excerpt, line(mark).1, mark.text.is_none(), span(mark).1.start));
    for (place, mark) in (0..).zip(order) {
        let hue = if !mark.primary {
            Color::Cyan
        } else if main == Style::Error {
            Color::Red
        } else {
            Color::Yellow
        };
        let label = Label::new(span(mark)).with_color(hue).with_order(place);
        let accompanied = || marks.iter().any(|other| other.text.is_some() && line(other) == line(mark));
        report.add_label(match &mark.text {
            Some(text) => label.with_message(text),
            // Ariadne underlines a mark without words only beside one that has some: see `underlined`.
            None if accompanied() => label,
            None => label.with_message(""),
        });
    }
    let mut drawn = Vec::new();
    let sources = Texts(excerpts.iter().map(|excerpt| Source::from(excerpt.text.as_str())).collect());
    if report.finish().write(sources, &mut drawn).is_err() {
        drawn.clear();
    }
    let last = excerpts.iter().flat_map(|excerpt| excerpt.numbers.iter().flatten()).max().copied().unwrap_or(1);
    let translation = Translation { excerpts, names, marks, width: last.to_string().len(), colour };
    let drawn = String::from_utf8_lossy(&drawn);
    (translation.lines(&drawn), translation.width)
}

struct Texts<'a>(Vec<Source<&'a str>>);

impl<'a> Cache<usize> for Texts<'a> {
    type Storage = &'a str;

    fn fetch(&mut self, index: &usize) -> Result<&Source<&'a str>, impl Debug> {
        self.0.get(*index).ok_or("no such text")
    }

    fn display<'b>(&self, index: &'b usize) -> Option<impl Display + 'b> {
        Some(index)
    }
}

/// What ariadne draws, in terms of the programs.
struct Translation<'a> {
    excerpts: &'a [Excerpt],
    names: &'a [&'a str],
    marks: &'a [Mark],
    width: usize,
    colour: bool,
}

impl Translation<'_> {
    fn lines(&self, drawn: &str) -> Vec<String> {
        let mut excerpt = None;
        // The first line is the header, which is written without ariadne.
        let lines = drawn.lines().skip(1).filter_map(|line| self.line(line.trim_end(), &mut excerpt));
        let lines = underlined(lines);
        if self.colour { lines.iter().map(|line| joined(line)).collect() } else { lines }
    }

    /// One line; `None` for the end of the frame. `excerpt` is the one that is being drawn.
    fn line(&self, line: &str, excerpt: &mut Option<usize>) -> Option<String> {
        let (paint, rest) = margin(line);
        let width = self.width;
        match rest.chars().next()? {
            corner @ ('╭' | '├') => {
                *excerpt = rest.split_once("[\u{1b}[0m ").or_else(|| rest.split_once("[ ")).and_then(|(_, place)| {
                    let (index, _) = place.split_once(':')?;
                    index.parse().ok()
                });
                Some(self.place(corner, (*excerpt)?))
            }
            '0'..='9' => {
                let digits = rest.bytes().take_while(u8::is_ascii_digit).count();
                let (number, rest) = rest.split_at(digits);
                let line = number.parse::<usize>().ok()?.checked_sub(1)?;
                let number = self.excerpts.get((*excerpt)?)?.numbers.get(line).copied().flatten()?;
                Some(format!(" {paint}{number:width$}{rest}"))
            }
            '─' => None,
            _ => Some(format!("  {:width$}{paint}{rest}", "")),
        }
    }

    /// The line that says where the excerpt is.
    fn place(&self, corner: char, excerpt: usize) -> String {
        let mark =
            self.marks.iter().filter(|mark| mark.excerpt == excerpt).min_by_key(|mark| (!mark.primary, mark.mark));
        let LineColumn { line, column } = mark
            .and_then(|mark| self.excerpts.get(excerpt)?.places.get(mark.mark).copied())
            .unwrap_or(LineColumn { line: 1, column: 1 });
        let name = self.names.get(excerpt).map(|name| terminal_safe(name)).unwrap_or_default();
        place_line(&format!("{name}:{line}:{column}"), corner, self.width, self.colour)
    }
}

/// Marks without words lose the arrow that leads to none.
fn underlined(drawn: impl Iterator<Item = String>) -> Vec<String> {
    let mut lines: Vec<String> = Vec::new();
    for line in drawn {
        let plain = visible(&line);
        let leads_nowhere = plain.split_once('│').is_some_and(|(_, rest)| {
            let arrow = rest.trim();
            arrow.strip_prefix('╰').is_some_and(|line| !line.is_empty() && line.chars().all(|part| part == '─'))
        });
        match lines.last_mut() {
            Some(mark) if leads_nowhere && mark.contains('┬') => *mark = mark.replace('┬', "─"),
            _ => lines.push(line),
        }
    }
    lines
}

/// A line without its colour sequences.
fn visible(line: &str) -> String {
    let mut parts = line.split('\u{1b}');
    let first = parts.next().unwrap_or_default().to_owned();
    parts.fold(first, |text, part| text + part.split_once('m').map_or(part, |(_, rest)| rest))
}

/// `╭─[ part.nc:4:13 ]`, where numbers take `width` characters.
pub(super) fn place_line(place: &str, corner: char, width: usize, colour: bool) -> String {
    let (open, close) = (paint(&format!("{corner}─["), Style::Faint, colour), paint("]", Style::Faint, colour));
    format!("  {:width$}{open} {place} {close}", "")
}

/// The colour sequences before the first visible character of a line, and the line from there on.
fn margin(line: &str) -> (String, &str) {
    let mut paint = String::new();
    let mut rest = line.trim_start_matches(' ');
    while let Some((code, after)) = rest.strip_prefix("\u{1b}[").and_then(|sequence| sequence.split_once('m')) {
        paint.push_str("\u{1b}[");
        paint.push_str(code);
        paint.push('m');
        rest = after.trim_start_matches(' ');
    }
    (paint, rest)
}
