//! What can be typed at a place: words of the block with what they mean, what L and R can name, frames of programs, and
//! the number of the next block.

mod addresses;
mod context;
mod fitting;
mod functions;
mod items;
mod numbering;
mod parameters;
mod snippets;
mod targets;
mod texts;
mod values;

use gen_lsp_types::{CompletionItemKind, CompletionParams, CompletionResponse};

use self::context::{Context, Wanted};
use self::fitting::Part;
use self::items::{Entry, Items, Section};
pub(super) use self::numbering::{next_numbers, written};
use self::texts::ItemText;
use super::analysis::Analysis;
use super::places::{Places, offset};
use super::snapshot::{Answer, Snapshot};
use crate::config::Settings;
use crate::diag::Findings;
use crate::dict::{Address, GCode, Lang};
use crate::query::cursor::DOCUMENT;
use crate::sure::Sure;
use crate::syntax::{Form, parse};
use crate::text::FileId;

/// The characters after which clients ask by themselves. A blank is none: after every word the list would open, and the
/// line end that often follows would take its first item. Block numbers after a line end are for
/// `textDocument/onTypeFormatting`.
pub(super) const TRIGGERS: [&str; 12] = ["N", "G", "M", "L", "R", "n", "g", "m", "l", "r", "=", "%"];

/// The sources of items.
#[derive(Clone, Copy, Debug)]
struct Source<'a> {
    analysis: &'a Analysis,
    settings: &'a Settings,
    lang: Lang,
}

/// `textDocument/completion`.
pub(super) fn completion(
    snapshot: &Snapshot,
    analysis: &Analysis,
    params: CompletionParams,
) -> Answer<Option<CompletionResponse>> {
    let Some(text) = analysis.sources.get(FileId(0)) else { return Ok(None) };
    // A program without `%` has no tree; here it is read as if it began with a block.
    let own = analysis
        .resolved
        .file(DOCUMENT)
        .is_none()
        .then(|| parse(FileId(0), text, Form::Macrocycle, &mut Findings::new()));
    let Some(file) = own.as_ref().or_else(|| analysis.resolved.file(DOCUMENT)) else { return Ok(None) };
    let unit = snapshot.client.unit;
    let at = offset(text, params.text_document_position_params.position, unit);
    let Some(context) = Context::new(file, at) else { return Ok(None) };
    let source = Source { analysis, settings: &analysis.settings, lang: snapshot.client.lang() };
    let mut items = Items {
        range: Places::new(text, unit).range(context.replaced),
        snippets: snapshot.client.has("/textDocument/completion/completionItem/snippetSupport"),
        incomplete: false,
        cancel: &snapshot.cancel,
        list: Vec::new(),
    };
    fill(&source, &context, &mut items);
    Ok(Some(CompletionResponse::CompletionList(items.finish())))
}

fn fill(source: &Source<'_>, context: &Context<'_>, items: &mut Items<'_>) {
    snippets::snippets(source, context, items);
    match context.wanted {
        Wanted::Name => {}
        Wanted::Words => words(source, context, items),
        Wanted::Assignment => {
            parameters::control_words(source, context, items);
            parameters::parameters(source, context, items, true);
        }
        Wanted::Value { target } => {
            if let Some(target) = target {
                parameters::operations(source, context, target, items);
            }
            // The L of a G79 is written out (BLK-10).
            if !context.words().any(|word| word.g_code() == Some(GCode::G79)) {
                parameters::parameters(source, context, items, false);
            }
        }
        Wanted::Address(Address::N) => next_block(source, context, items),
        Wanted::Address(Address::G) => {
            items.incomplete = context.digits() == Some("");
            functions::g_functions(source, context, items, false);
        }
        Wanted::Address(Address::M) => {
            items.incomplete = context.digits() == Some("");
            functions::m_functions(source, context, items, false);
        }
        Wanted::Address(Address::L) if targets::targets(source, context, items) => {}
        Wanted::Address(address) => {
            values::values(source, context, address, items);
            // The meaning of a bare address.
            if context.digits() == Some("") && !context.has_number() {
                addresses::address_item(source, address, context.typed, items);
            }
        }
    }
}

/// Everything that can stand between two words.
fn words(source: &Source<'_>, context: &Context<'_>, items: &mut Items<'_>) {
    // The next key narrows the choice.
    items.incomplete = true;
    next_block(source, context, items);
    let Some(block) = context.block else { return };
    let has_l = context.words().any(|word| word.address == Address::L);
    if !has_l {
        targets::targets(source, context, items);
    }
    // G79 takes no other words but its L.
    if context.words().any(|word| word.g_code() == Some(GCode::G79)) {
        return;
    }
    // The first block of a unit is a G79, and behind a macrocycle there is none.
    match Part::of(source, block) {
        Part::Entry => return functions::g_functions(source, context, items, true),
        Part::Behind => return,
        Part::Main | Part::Inside | Part::Any => {}
    }
    parameters::control_words(source, context, items);
    addresses::addresses(source, context, items);
    functions::g_functions(source, context, items, true);
    functions::m_functions(source, context, items, true);
}

/// The number of a new block, where one may begin.
fn next_block(source: &Source<'_>, context: &Context<'_>, items: &mut Items<'_>) {
    let typed_n = context.wanted == Wanted::Address(Address::N);
    let Some(digits) = context.digits() else { return };
    let file = context.file;
    let outside = file.program.is_none() && file.block_count() == 0 && source.analysis.resolved.main().is_none();
    if !typed_n && (outside || !context.alone) {
        return;
    }
    let numbers = next_numbers(source.analysis, file, context.replaced.start, 1).unwrap_or_default();
    for number in numbers {
        let label = written(file, context.replaced.start, number);
        let figures = label.trim_start_matches('N');
        if !figures.starts_with(digits) {
            continue;
        }
        let rest = file.source.text().get(context.replaced.end as usize..).sure();
        let blank = if rest.starts_with([' ', '\t']) { "" } else { " " };
        items.add(Entry {
            kind: CompletionItemKind::Value,
            detail: ItemText::NextBlock.text(source.lang),
            documentation: None,
            section: Section::First,
            order: 0,
            filter: if typed_n { format!("{}{figures}", context.head()) } else { label.clone() },
            text: format!("{label}{blank}"),
            snippet: None,
            label,
        });
    }
}
