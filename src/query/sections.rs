//! The landmarks of a program for machinists: its units, and in them the tool changes and the headings.
//!
//! A heading is a comment alone in its line after the first block, the first of several such lines, without the dashes
//! around it; or the comment of a block that has nothing but its number. No heading is a comment that holds a block
//! which was taken out (`"N50 X10"`), and what stands directly above a `G79` block: that is the subprogram's title,
//! unless there is a comment in its line; without both it is the comment below. Notes before the first block are no
//! headings either.
//!
//! A tool change is a block with M06, named by the T of the block or the last one before it in the unit (TEC-4); in a
//! file without M06, where a macrocycle changes the tool, a block with T.

use super::analysis::Analysis;
use super::cursor::DOCUMENT;
use super::extents::{adjoin, block_span, comments_above, content_end, stands_alone, unit_span, words_span};
use crate::dict::{Address, TOOL_CHANGE};
use crate::resolve::{Unit, UnitKind};
use crate::syntax::{BlockFlags, BlockId, ParsedFile, Value, Word};
use crate::text::Span;

/// Most sections of a document: an editor shows no more.
const MOST: usize = 10_000;
/// Names are cut after this many characters.
const LONGEST_NAME: usize = 120;

/// The kind of a section.
#[derive(Clone, Copy, Debug, Eq, PartialEq)]
pub(crate) enum SectionKind {
    /// A program.
    Program,
    /// A subprogram or macrocycle.
    Subprogram,
    /// A tool change.
    Tool,
    /// A heading.
    Heading,
}

/// A part of a unit, up to the next one.
#[derive(Clone, Debug)]
pub(crate) struct Section {
    pub(crate) name: String,
    pub(crate) kind: SectionKind,
    /// All of it.
    pub(crate) span: Span,
    /// The text that names it.
    pub(crate) head: Span,
}

/// A unit with its parts.
#[derive(Clone, Debug)]
pub(crate) struct UnitSections {
    pub(crate) unit: Section,
    pub(crate) parts: Vec<Section>,
}

/// The units of the document with their sections, in the order of the text.
pub(crate) fn sections(analysis: &Analysis) -> Vec<UnitSections> {
    let Some(file) = analysis.resolved.file(DOCUMENT) else { return Vec::new() };
    let change = if file.block_ids().any(|block| has_m06(file, block)) { Change::ByM06 } else { Change::ByT };
    let mut left = MOST;
    units_of(analysis).map(|unit| of_unit(file, unit, change, &mut left)).collect()
}

/// The units of the document without their sections.
pub(crate) fn units(analysis: &Analysis) -> impl Iterator<Item = Section> {
    let file = analysis.resolved.file(DOCUMENT);
    file.into_iter().flat_map(|file| units_of(analysis).map(|unit| head(file, unit).0))
}

/// The units of the document; a macrocycle without a block is none yet.
pub(crate) fn units_of(analysis: &Analysis) -> impl Iterator<Item = &Unit> {
    let count = analysis.resolved.file(DOCUMENT).map_or(0, ParsedFile::block_count);
    let is_there = move |unit: &&Unit| unit.kind == UnitKind::Main || unit.first.0 < count;
    analysis.resolved.units().map(|(_, unit)| unit).filter(|unit| unit.file == DOCUMENT).filter(is_there).take(MOST)
}

/// What changes tools in a file.
#[derive(Clone, Copy, Debug, Eq, PartialEq)]
enum Change {
    ByM06,
    ByT,
}

fn of_unit(file: &ParsedFile, unit: &Unit, change: Change, left: &mut usize) -> UnitSections {
    let (unit_section, title) = head(file, unit);
    let text = file.source.text();
    let mut parts: Vec<Section> = Vec::new();
    let mut tool = None;
    let mut line_before = None;
    let commented = !file.all_comments().is_empty();
    let next = file.flags(unit.end).has(BlockFlags::ENTRY).then(|| comments_above(file, unit.end).first()).flatten();
    for block in unit.blocks() {
        if *left == 0 {
            break;
        }
        let t = file.words(block).iter().find(|word| word.address == Address::T);
        tool = t.copied().or(tool);
        let changes = match change {
            Change::ByM06 => has_m06(file, block),
            Change::ByT => t.is_some(),
        };
        let before = parts.len();
        if changes {
            parts.push(tool_change(file, block, tool));
        }
        let comments = if commented { file.comments_behind(block) } else { &[] };
        if !comments.is_empty() {
            let bare = file.words(block).is_empty();
            let words_end = words_span(file, block).end;
            for &comment in comments {
                let own_line = comment.start >= words_end && stands_alone(text, comment);
                let first_line = !line_before.is_some_and(|end| adjoin(text, end, comment.start));
                // Under a line of dashes the heading is the second line.
                let decoration = own_line && heading(file, comment).is_none();
                line_before = (own_line && !(decoration && first_line)).then_some(comment.end);
                let is_title = title == Some(comment) || next.is_some_and(|next| comment.start >= next.start);
                if is_title || !((own_line && first_line) || (bare && !own_line)) {
                    continue;
                }
                if let Some(name) = heading(file, comment) {
                    let head = if own_line { comment } else { block_span(file, block) };
                    parts.push(Section { name: cut(name), kind: SectionKind::Heading, span: head, head });
                }
            }
        }
        *left = left.saturating_sub(parts.len() - before);
    }
    let mut end = unit_section.span.end;
    for part in parts.iter_mut().rev() {
        part.span.end = content_end(file, end).max(part.head.end);
        end = part.head.start;
    }
    UnitSections { unit: unit_section, parts }
}

/// The unit itself, and the comment that is its title.
pub(crate) fn head(file: &ParsedFile, unit: &Unit) -> (Section, Option<Span>) {
    let span = unit_span(file, unit);
    let name = |title: Option<&str>, name: String| match title {
        Some(title) => cut(&format!("{name} {title}")),
        None => name,
    };
    if unit.kind == UnitKind::Main {
        let head = file.program.map_or(Span::empty(span.start), |word| word.span(file.source.text()));
        let number = file.program.and_then(Word::whole).map_or_else(String::new, |number| number.to_string());
        let title = file.title.map(|title| file.comment_text(title));
        return (
            Section { name: name(title, format!("%{number}")), kind: SectionKind::Program, span, head },
            file.title,
        );
    }
    let above = comments_above(file, unit.first);
    let text = file.source.text();
    let (below, beside): (Vec<Span>, Vec<Span>) =
        file.comments_behind(unit.first).iter().partition(|comment| stands_alone(text, **comment));
    let mut titles = beside.into_iter().chain(above.iter().copied()).chain(below);
    let title = titles.find(|comment| heading(file, *comment).is_some()).or(match unit.kind {
        UnitKind::Macrocycle(_) => file.title,
        UnitKind::Main | UnitKind::Subprogram(_) => None,
    });
    let shown = title.and_then(|title| heading(file, title)).map(|title| without_number(title, &unit.name()));
    let head = words_span(file, unit.first);
    let section = Section { name: name(shown, unit.name()), kind: SectionKind::Subprogram, span, head };
    (section, title)
}

/// The title of a unit that begins with its number, without that.
fn without_number<'t>(title: &'t str, number: &str) -> &'t str {
    let (first, rest) = title.split_at_checked(number.len()).unwrap_or(("", title));
    let rest = rest.trim_start_matches([':', '-', '=', ' ', '\t', ',']);
    if first.eq_ignore_ascii_case(number) && !rest.is_empty() && !rest.starts_with(|c: char| c.is_ascii_digit()) {
        rest
    } else {
        title
    }
}

fn has_m06(file: &ParsedFile, block: BlockId) -> bool {
    file.flags(block).has(BlockFlags::RICH) && file.words(block).iter().any(|word| word.is_m(TOOL_CHANGE))
}

fn tool_change(file: &ParsedFile, block: BlockId, tool: Option<Word>) -> Section {
    let text = file.source.text();
    let head = words_span(file, block);
    let comment = file.comments_behind(block).iter().find(|c| c.start < head.end || !stands_alone(text, **c));
    let number = file.number(block).map(|number| format!("N{number}"));
    let tool = match tool.map(Word::value) {
        Some(Value::Number(number)) => format!("T{number}"),
        Some(Value::Parameter { index, .. }) => format!("TR{index}"),
        Some(Value::None) | None => "M06".to_owned(),
    };
    let comment = comment.and_then(|comment| heading(file, *comment)).map(str::to_owned);
    let name: Vec<String> = number.into_iter().chain([tool]).chain(comment).collect();
    Section { name: cut(&name.join(" ")), kind: SectionKind::Tool, span: head, head }
}

/// The text of a comment, without dashes around it; `None` when it is empty, or a block that was taken out.
pub(crate) fn heading(file: &ParsedFile, comment: Span) -> Option<&str> {
    let said = file.comment_text(comment).trim_matches(['-', '=', '*', '_', '#', '~', '+', '.', ' ', '\t']);
    let mut characters = said.trim_start_matches(['/', ' ']).chars();
    let is_block = characters.next().is_some_and(|c| c.eq_ignore_ascii_case(&'N'))
        && characters.next().is_some_and(|c| c.is_ascii_digit());
    (!said.is_empty() && !is_block).then_some(said)
}

fn cut(name: &str) -> String {
    name.chars().take(LONGEST_NAME).collect()
}
