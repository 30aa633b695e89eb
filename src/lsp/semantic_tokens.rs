//! Colours by meaning.
//!
//! | in the program | type | modifier |
//! |---|---|---|
//! | `%1200` | namespace | declaration |
//! | `N120` | label | declaration |
//! | L of a jump | label | |
//! | L of a call | function | |
//! | L of a `G79` block | function | declaration |
//! | `/` | modifier | |
//! | G of group G7 (calls, jumps, entry, end), M00, M01, M02, M30, `*` | keyword | |
//! | G of group G0 (interpolation) and of fixed cycles | method | |
//! | every other G: modal states, dwell, tables, arithmetic | type | |
//! | every other M | macro | |
//! | letters of axes, I, J, K | property | |
//! | letters of F, S, T, D, H, P, Q, `&`, L without a call or jump | parameter | |
//! | `R10` where it is assigned | variable | modification |
//! | `R10` where it is read | variable | |
//! | `=`, a sign before a parameter | operator | |
//! | numbers | number | |
//! | the title | comment | documentation |
//! | other comments, text before `%` and after `*`, which is not read | comment | |
//!
//! No token spans lines, none overlaps another. A word with a finding about its form is one token.

use gen_lsp_types::{
    Range, SemanticToken, SemanticTokens, SemanticTokensLegend, SemanticTokensOptions, SemanticTokensParams,
    SemanticTokensRangeParams,
};

use super::analysis::Analysis;
use super::places::{Places, span};
use super::snapshot::{Answer, Snapshot};
use crate::dict::{Address, GCode, GGroup, OPTIONAL_STOP, PROGRAM_ENDS, PROGRAM_STOP};
use crate::query::cursor::{DOCUMENT, block_at};
use crate::sure::small;
use crate::syntax::{BlockFlags, BlockId, ParsedFile, Word};
use crate::text::Span;

/// Documents of more bytes are coloured by ranges only: their tokens would be some megabytes after every key.
const LARGEST: u32 = 1 << 20;
/// Most tokens of an answer.
const MOST: usize = 200_000;

/// The types, in the order of the legend.
#[derive(Clone, Copy, Debug)]
enum Kind {
    Namespace,
    Label,
    Function,
    Modifier,
    Keyword,
    Method,
    Type,
    Macro,
    Property,
    Parameter,
    Variable,
    Operator,
    Number,
    Comment,
}

const TYPES: [&str; 14] = [
    "namespace",
    "label",
    "function",
    "modifier",
    "keyword",
    "method",
    "type",
    "macro",
    "property",
    "parameter",
    "variable",
    "operator",
    "number",
    "comment",
];

const MODIFIERS: [&str; 3] = ["declaration", "modification", "documentation"];
const DECLARATION: u32 = 1;
const MODIFICATION: u32 = 1 << 1;
const DOCUMENTATION: u32 = 1 << 2;

/// The capability of the server.
pub(super) fn options() -> SemanticTokensOptions {
    let names = |names: &[&str]| names.iter().map(|name| (*name).to_owned()).collect();
    SemanticTokensOptions {
        legend: SemanticTokensLegend { token_types: names(&TYPES), token_modifiers: names(&MODIFIERS) },
        range: Some(true.into()),
        full: Some(true.into()),
        ..SemanticTokensOptions::default()
    }
}

/// `textDocument/semanticTokens/full`; null for long documents, which clients then colour by ranges.
pub(super) fn full(
    snapshot: &Snapshot,
    analysis: &Analysis,
    _: SemanticTokensParams,
) -> Answer<Option<SemanticTokens>> {
    Ok(tokens(snapshot, analysis, None))
}

/// `textDocument/semanticTokens/range`.
pub(super) fn range(
    snapshot: &Snapshot,
    analysis: &Analysis,
    params: SemanticTokensRangeParams,
) -> Answer<Option<SemanticTokens>> {
    Ok(tokens(snapshot, analysis, Some(params.range)))
}

fn tokens(snapshot: &Snapshot, analysis: &Analysis, range: Option<Range>) -> Option<SemanticTokens> {
    let file = analysis.resolved.file(DOCUMENT)?;
    let unit = snapshot.client.unit;
    let wanted = match range {
        Some(range) => span(&file.source, range, unit),
        None if file.source.len() <= LARGEST => Span::new(0, file.source.len()),
        None => return None,
    };
    let mut places = Places::new(&file.source, unit);
    let mut data = Vec::new();
    let (mut line, mut column) = (0, 0);
    for token in Painter::paint(file, wanted, &|| snapshot.cancel.is_cancelled()) {
        let at = places.position(token.span.start);
        let delta_line = at.line.saturating_sub(line);
        data.push(SemanticToken {
            delta_line,
            delta_start: if delta_line == 0 { at.character.saturating_sub(column) } else { at.character },
            length: unit.count(file.source.slice(token.span)),
            token_type: token.kind as u32,
            token_modifiers_bitset: token.modifiers,
        });
        (line, column) = (at.line, at.character);
    }
    Some(SemanticTokens { result_id: None, data })
}

#[derive(Clone, Copy, Debug)]
struct Painted {
    span: Span,
    kind: Kind,
    modifiers: u32,
}

/// Finds the tokens of a part of a file.
struct Painter<'a> {
    file: &'a ParsedFile,
    wanted: Span,
    painted: Vec<Painted>,
}

impl<'a> Painter<'a> {
    fn paint(file: &'a ParsedFile, wanted: Span, cancelled: &dyn Fn() -> bool) -> Vec<Painted> {
        let mut painter = Self { file, wanted, painted: Vec::new() };
        painter.unread(Span::new(0, file.start));
        painter.header();
        let first = block_at(file, wanted.start).unwrap_or_default();
        for block in (first.0..file.block_count()).map(BlockId) {
            let begins = file.n_word(block).map_or(u32::MAX, Word::start);
            let full = painter.painted.len() >= MOST;
            if begins >= wanted.end || full || (block.0.is_multiple_of(1 << 12) && cancelled()) {
                break;
            }
            painter.block(block);
        }
        painter.end();
        painter.in_order()
    }

    /// In the order of the text. Where a word of another control is a finding, words may share its characters, and
    /// comments may stand before the `%`: the first of two that meet counts.
    fn in_order(mut self) -> Vec<Painted> {
        self.painted.sort_by_key(|painted| painted.span);
        let mut end = 0;
        self.painted.retain(|painted| {
            let apart = painted.span.start >= end;
            end = if apart { painted.span.end } else { end };
            apart
        });
        self.painted.truncate(MOST);
        self.painted
    }

    fn add(&mut self, span: Span, kind: Kind, modifiers: u32) {
        if !span.is_empty() && span.start < self.wanted.end && self.wanted.start < span.end {
            self.painted.push(Painted { span, kind, modifiers });
        }
    }

    fn header(&mut self) {
        let first = self.file.n_word(BlockId(0)).map_or(u32::MAX, Word::start);
        if self.wanted.start >= first {
            return;
        }
        if let Some(word) = self.file.program {
            // Behind the `%` of another control, its number may stand on the next line.
            let span = word.span(self.file.source.text());
            let line = self.file.source.slice(span).split(['\r', '\n']).next().unwrap_or_default().trim_end();
            self.add(Span::new(span.start, span.start + small(line.len())), Kind::Namespace, DECLARATION);
        }
        for &comment in self.file.comments_before_blocks() {
            let modifiers = if self.file.title == Some(comment) { DOCUMENTATION } else { 0 };
            self.add(comment, Kind::Comment, modifiers);
        }
    }

    fn block(&mut self, block: BlockId) {
        if let Some(word) = self.file.n_word(block) {
            self.add(word.span(self.file.source.text()), Kind::Label, DECLARATION);
        }
        let words = self.file.words(block);
        let rich = self.file.flags(block).has(BlockFlags::RICH);
        let mut functions = words.iter().filter(|_| rich).filter_map(|word| word.g_code());
        let flow = functions.find(|code| code.group() == GGroup::G7);
        for &word in words {
            self.word(word, flow);
        }
        for &comment in self.file.comments_behind(block) {
            self.add(comment, Kind::Comment, 0);
        }
    }

    fn word(&mut self, word: Word, flow: Option<GCode>) {
        let parts = word.parts(self.file.source.text());
        let letter = Span::new(parts.word.start, parts.word.start + 1);
        let (kind, modifiers, whole) = match word.address {
            Address::Program => (Kind::Namespace, DECLARATION, true),
            Address::N => (Kind::Label, DECLARATION, true),
            Address::Skip => (Kind::Modifier, 0, true),
            Address::G => (g_type(word), 0, !word.is_parametric()),
            Address::M => (m_type(word), 0, !word.is_parametric()),
            Address::L => {
                let (kind, modifiers) = l_type(flow);
                (kind, modifiers, !word.is_parametric())
            }
            Address::R => {
                self.assignment(word);
                return;
            }
            Address::X
            | Address::Y
            | Address::Z
            | Address::A
            | Address::B
            | Address::C
            | Address::U
            | Address::V
            | Address::W
            | Address::I
            | Address::J
            | Address::K => (Kind::Property, 0, false),
            Address::Correction
            | Address::D
            | Address::F
            | Address::S
            | Address::Q
            | Address::H
            | Address::P
            | Address::T => (Kind::Parameter, 0, false),
        };
        if whole || word.is_faulty() || word.is_void() {
            self.add(parts.word, kind, modifiers);
        } else {
            self.add(letter, kind, modifiers);
            self.value(word, parts.value);
        }
    }

    /// `R10=5`, `R11=-R10`.
    fn assignment(&mut self, word: Word) {
        let parts = word.parts(self.file.source.text());
        let target = parts.target.filter(|_| !word.is_faulty() && !word.is_void());
        let Some(target) = target else { return self.add(parts.word, Kind::Variable, MODIFICATION) };
        self.add(Span::new(parts.word.start, target.end), Kind::Variable, MODIFICATION);
        let between = Span::new(target.end, parts.value.start);
        if let Some(at) = self.file.source.slice(between).find('=').and_then(|at| u32::try_from(at).ok()) {
            self.add(Span::new(between.start + at, between.start + at + 1), Kind::Operator, 0);
        }
        self.value(word, parts.value);
    }

    /// A number, or a parameter with its sign.
    fn value(&mut self, word: Word, value: Span) {
        if !word.is_parametric() {
            return self.add(value, Kind::Number, 0);
        }
        let sign = u32::from(word.has_sign());
        self.add(Span::new(value.start, value.start + sign), Kind::Operator, 0);
        self.add(Span::new(value.start + sign, value.end), Kind::Variable, 0);
    }

    /// `*` and what stands after it.
    fn end(&mut self) {
        let star = Span::new(self.file.end.saturating_sub(1), self.file.end);
        let last = self.file.block_count().checked_sub(1).map(BlockId);
        let comments = last.map_or(self.file.comments_before_blocks(), |last| self.file.comments_behind(last));
        if self.file.source.text().get(star.range()) == Some("*")
            && comments.last().is_none_or(|comment| comment.end <= star.start)
        {
            self.add(star, Kind::Keyword, 0);
            self.unread(Span::new(star.end, self.file.source.len()));
        }
    }

    /// Text that the control does not read, line by line.
    fn unread(&mut self, span: Span) {
        let wanted = Span::new(span.start.max(self.wanted.start), span.end.min(self.wanted.end));
        if wanted.is_empty() {
            return;
        }
        let source = &self.file.source;
        let (first, last) = (source.lines().line_at(wanted.start), source.lines().line_at(wanted.end));
        for line in first..=last {
            if self.painted.len() >= MOST {
                return;
            }
            let line = source.line_span(line);
            let within = Span::new(line.start.max(span.start), line.end.min(span.end));
            let text = source.slice(within);
            let count = |text: &str| small(text.len());
            let start = within.start + count(text) - count(text.trim_start());
            self.add(Span::new(start, (start + count(text.trim())).min(within.end)), Kind::Comment, 0);
        }
    }
}

fn g_type(word: Word) -> Kind {
    let Some(code) = word.g_code() else { return Kind::Type };
    match code.group() {
        GGroup::G7 => Kind::Keyword,
        GGroup::G0 => Kind::Method,
        GGroup::G8 if code != GCode::G80 => Kind::Method,
        GGroup::G1
        | GGroup::G2
        | GGroup::G3
        | GGroup::G4
        | GGroup::G5
        | GGroup::G6
        | GGroup::G8
        | GGroup::G9
        | GGroup::G10
        | GGroup::G11 => Kind::Type,
    }
}

fn m_type(word: Word) -> Kind {
    let stops = |m: &u8| [PROGRAM_STOP, OPTIONAL_STOP].contains(m) || PROGRAM_ENDS.contains(m);
    let m = word.whole().and_then(|m| u8::try_from(m).ok());
    if m.is_some_and(|m| stops(&m)) { Kind::Keyword } else { Kind::Macro }
}

fn l_type(flow: Option<GCode>) -> (Kind, u32) {
    match flow {
        Some(GCode::G73) => (Kind::Label, 0),
        Some(GCode::G79) => (Kind::Function, DECLARATION),
        Some(code) if code.is_flow() => (Kind::Function, 0),
        Some(_) | None => (Kind::Parameter, 0),
    }
}

#[cfg(test)]
mod tests {
    use std::sync::Arc;

    use super::*;
    use crate::diag::Findings;
    use crate::syntax::{Form, parse};
    use crate::text::{FileId, SourceText};

    /// The tokens of a text, each with what it covers.
    fn painted(text: &str, wanted: Option<Span>) -> Vec<String> {
        let source = Arc::new(SourceText::from_text("t.nc", text));
        let file = parse(FileId(0), &source, Form::Program, &mut Findings::new());
        let all = Span::new(0, source.len());
        let painted = Painter::paint(&file, wanted.unwrap_or(all), &|| false);
        for pair in painted.windows(2) {
            assert!(pair[0].span.end <= pair[1].span.start, "{pair:?}");
        }
        let name = |painted: &Painted| TYPES[painted.kind as usize].to_owned();
        painted.iter().map(|painted| format!("{} {}", name(painted), source.slice(painted.span))).collect()
    }

    #[test]
    fn every_kind() {
        let text = "before\n%1 \"t\"\nN1 /1 G1 X-5 YR1 Z-R2 \"c\" F100\nN2 R1=R2 R3 = 5 G71 L5 Q2\nN3 M3 G90 M30\n\
                    N4 X, L7*\n after\n\nit";
        let expected = "comment before|namespace %1|comment \"t\"|label N1|modifier /1|method G1|property X|number -5|\
                        property Y|variable R1|property Z|operator -|variable R2|comment \"c\"|parameter F|number 100|\
                        label N2|variable R1|operator =|variable R2|variable R3|operator =|number 5|keyword G71|\
                        function L5|parameter Q|number 2|label N3|macro M3|type G90|keyword M30|label N4|property X,|\
                        parameter L7|keyword *|comment after|comment it";
        assert_eq!(painted(text, None).join("|"), expected);
        let at = |part: &str| u32::try_from(text.find(part).unwrap()).unwrap();
        let part = painted(text, Some(Span::new(at("R3"), at("G90"))));
        assert_eq!(
            part.join("|"),
            "variable R3|operator =|number 5|keyword G71|function L5|parameter Q|number 2|label N3|macro M3"
        );
    }

    #[test]
    fn borders() {
        assert_eq!(painted("%1\nN1 \"a*", None).join("|"), "namespace %1|label N1|comment \"a*");
        let radius = painted("%1\nN1 G02 X5 R5.5\nN2 X1 R-3\nN3 G71 100 \u{425}8\nN4 1 M6 [5]", None).join("|");
        assert!(radius.starts_with("namespace %1|label N1|method G02|property X|number 5|"), "{radius}");
        assert_eq!(painted("%\n100\nN1 X1", None).join("|"), "namespace %|label N1|property X|number 1");
        assert_eq!(painted("no program", None), ["comment no program"]);
        assert_eq!(painted("%1*\r\nx", None).join("|"), "namespace %1|keyword *|comment x");
    }
}
