//! Frames of what programs are made of. Put down with what is proposed in them, they give no findings.

use gen_lsp_types::CompletionItemKind;

use super::context::Wanted;
use super::items::{Entry, Items, Section};
use super::numbering::{next_numbers, written};
use super::targets::{missing_subprograms, next_subprogram};
use super::texts::ItemText;
use super::{Context, Source};
use crate::dict::{Address, AxisLetter, HIGHEST_L};
use crate::query::cursor::unit_of;
use crate::resolve::{Library, UnitKind};
use crate::syntax::BlockFlags;

/// The part of a file that holds the place.
enum Place {
    /// A document without blocks.
    Empty,
    /// A program unit that goes on.
    Unit,
    /// Behind a unit that has ended.
    Behind,
    /// Something else.
    Other,
}

/// The frames that fit at the place.
pub(super) fn snippets(source: &Source<'_>, context: &Context<'_>, items: &mut Items<'_>) {
    if !context.alone {
        return;
    }
    let own = Library::number(&source.analysis.path);
    let made = match (place(source, context), own) {
        (Place::Empty, Some(l)) => Some(macrocycle(source, context, l)),
        (Place::Empty, None) => Some(program(source, context)),
        (Place::Unit, _) => repeated(source, context),
        (Place::Behind, None) => subprogram(source, context),
        (Place::Behind, Some(_)) | (Place::Other, _) => None,
    };
    let Some((name, about, frame)) = made else { return };
    let (label, typed) = (name.text(source.lang), context.typed);
    let by_percent = typed.starts_with('%');
    if !by_percent && !label.starts_with(&typed.to_lowercase()) {
        return;
    }
    items.add(Entry {
        filter: if by_percent { format!("%{label}") } else { label.clone() },
        label,
        kind: CompletionItemKind::Snippet,
        detail: about.text(source.lang),
        documentation: Some(format!("```nc\n{}\n```", frame.plain)),
        section: if by_percent || typed.len() > 1 { Section::First } else { Section::Snippets },
        order: 0,
        text: frame.plain,
        snippet: Some(frame.snippet),
    });
}

fn place(source: &Source<'_>, context: &Context<'_>) -> Place {
    let file = context.file;
    let Some(previous) = context.previous() else {
        let typed_program = context.wanted == Wanted::Address(Address::Program);
        let empty = file.block_count() == 0 && (file.program.is_none() || typed_program);
        return if empty { Place::Empty } else { Place::Other };
    };
    let Some((_, unit)) = unit_of(source.analysis, previous) else {
        return if source.analysis.resolved.main().is_some() { Place::Behind } else { Place::Other };
    };
    let end = match unit.kind {
        UnitKind::Main => BlockFlags::END,
        UnitKind::Subprogram(_) | UnitKind::Macrocycle(_) => BlockFlags::RETURN,
    };
    if file.flags(previous).has(end) { Place::Behind } else { Place::Unit }
}

/// A name, what it is, and the text.
type Made = (ItemText, ItemText, Frame);

fn program(source: &Source<'_>, context: &Context<'_>) -> Made {
    let lang = source.lang;
    let axis = source.settings.machine.axes.get(0).map_or(AxisLetter::X, |axis| axis.letter);
    let mut frame = Frame::new(context);
    frame.put("%").hole("1").put(" \"").hole(&ItemText::Title.text(lang)).put("\"");
    frame.line("N10 G90 G54");
    frame.line("N20 T").hole("1").put(" M06");
    frame.line("N30 S").hole("1000").put(" M03");
    frame.line(&format!("N40 G00 {axis}")).hole("0");
    frame.line(&format!("N50 G01 {axis}")).hole("10").put(" F").hole("100").end();
    frame.line("N60 M05");
    frame.line("N70 M30");
    (ItemText::NameProgram, ItemText::AboutProgram, frame)
}

fn macrocycle(source: &Source<'_>, context: &Context<'_>, l: u32) -> Made {
    let lang = source.lang;
    let mut frame = Frame::new(context);
    frame.put(&format!("N10 G79 L{l} \"")).hole(&ItemText::Title.text(lang)).put("\"");
    frame.line("N20 ").hole(&format!("\"{}\"", ItemText::Body.text(lang))).end();
    frame.line("N30 G70");
    (ItemText::NameMacrocycle, ItemText::AboutMacrocycle { l }, frame)
}

fn subprogram(source: &Source<'_>, context: &Context<'_>) -> Option<Made> {
    let lang = source.lang;
    let missing = missing_subprograms(source, context.file).first().copied();
    let l = missing.or_else(|| next_subprogram(source))?;
    let numbers = next_numbers(source.analysis, context.file, context.replaced.start, 3)?;
    let mut numbers = numbers.into_iter().map(|number| written(context.file, context.replaced.start, number));
    let mut frame = Frame::new(context);
    frame.put(&format!("{} G79 L{l} \"", numbers.next()?)).hole(&ItemText::Title.text(lang)).put("\"");
    frame.line(&format!("{} ", numbers.next()?)).hole(&format!("\"{}\"", ItemText::Body.text(lang))).end();
    frame.line(&format!("{} G70", numbers.next()?));
    Some((ItemText::NameSubprogram, ItemText::AboutSubprogram { l }, frame))
}

/// A stretch that a jump back repeats; none where its number has more digits than L can.
fn repeated(source: &Source<'_>, context: &Context<'_>) -> Option<Made> {
    let at = context.replaced.start;
    let numbers = next_numbers(source.analysis, context.file, at, 2)?;
    let [first, second] = numbers.as_slice() else { return None };
    if *first > HIGHEST_L {
        return None;
    }
    let mut frame = Frame::new(context);
    let body = format!("\"{}\"", ItemText::Body.text(source.lang));
    frame.put(&format!("{} ", written(context.file, at, *first))).hole(&body).end();
    frame.line(&format!("{} G73 L{first} Q", written(context.file, at, *second))).hole("2");
    Some((ItemText::NameLoop, ItemText::AboutLoop, frame))
}

/// A text with holes to be filled in, and the same with what is proposed for them.
struct Frame {
    snippet: String,
    plain: String,
    holes: u32,
    line_end: &'static str,
}

impl Frame {
    /// With line ends as in the document.
    fn new(context: &Context<'_>) -> Self {
        let text = context.file.source.text();
        let crlf = text.split_once('\n').is_some_and(|(line, _)| line.ends_with('\r'));
        let line_end = if crlf { "\r\n" } else { "\n" };
        Self { snippet: String::new(), plain: String::new(), holes: 0, line_end }
    }

    fn put(&mut self, text: &str) -> &mut Self {
        self.snippet.push_str(text);
        self.plain.push_str(text);
        self
    }

    fn line(&mut self, text: &str) -> &mut Self {
        self.put(self.line_end).put(text)
    }

    fn hole(&mut self, proposed: &str) -> &mut Self {
        self.holes += 1;
        self.snippet.push_str(&format!("${{{}:{proposed}}}", self.holes));
        self.plain.push_str(proposed);
        self
    }

    /// Where the cursor is in the end.
    fn end(&mut self) -> &mut Self {
        self.snippet.push_str("$0");
        self
    }
}
