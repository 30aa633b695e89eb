//! Another number for a block, a subprogram or a parameter, everywhere at once, where everywhere is known.

use std::path::PathBuf;

use gen_lsp_types::{
    PrepareRenameParams, PrepareRenamePlaceholder, PrepareRenameResult, RenameParams, TextEdit, WorkspaceEdit,
};

use super::analysis::Analysis;
use super::edits::workspace_edit;
use super::places::{Places, offset};
use super::snapshot::{Answer, Refusal, Snapshot};
use super::workspace;
use crate::dict::{HIGHEST_BLOCK, HIGHEST_L, HIGHEST_PARAMETER};
use crate::edit::line_length::first_long_line;
use crate::query::cursor::DOCUMENT;
use crate::query::names::{Name, Naming, Usage};
use crate::query::navigation_texts::NavigationText;
use crate::query::reach::Reach;
use crate::query::rename_doubts::Doubts;

/// `textDocument/prepareRename`: the number, or why it cannot be changed.
pub(super) fn prepare(
    snapshot: &Snapshot,
    analysis: &Analysis,
    params: PrepareRenameParams,
) -> Answer<Option<PrepareRenameResult>> {
    let Some(file) = analysis.resolved.file(DOCUMENT) else { return Ok(None) };
    let unit = snapshot.client.unit;
    let place = offset(&file.source, params.text_document_position_params.position, unit);
    let reach = Reach::of(analysis);
    let Some(naming) = reach.naming_at(place).filter(|naming| is_number(naming, place)) else { return Ok(None) };
    let refused = doubts(snapshot, &reach, naming.name).against_any();
    if let Some(reason) = refused.filter(|_| macrocycle(snapshot, analysis, naming.name).is_none()) {
        return Err(Refusal::new(reason.text(snapshot.client.lang())));
    }
    Ok(Some(PrepareRenameResult::PrepareRenamePlaceholder(PrepareRenamePlaceholder {
        range: Places::new(&file.source, unit).range(naming.number),
        placeholder: file.source.slice(naming.number).to_owned(),
    })))
}

/// `textDocument/rename`.
pub(super) fn rename(snapshot: &Snapshot, analysis: &Analysis, params: RenameParams) -> Answer<Option<WorkspaceEdit>> {
    let failed = |reason: NavigationText| Refusal::new(reason.text(snapshot.client.lang()));
    if let Some(edit) = of_macrocycle(snapshot, analysis, &params) {
        return edit.map(Some).map_err(failed);
    }
    let edits = edits(snapshot, analysis, &params).map_err(failed)?;
    // Only the document itself changes.
    let document = analysis.files.buffer(&analysis.path);
    Ok(document.and_then(|document| workspace_edit(snapshot, &document.uri, None, edits)))
}

/// Another number for a macrocycle, everywhere in the workspace; `None` when something else is renamed, or the client
/// renames no files.
fn of_macrocycle(
    snapshot: &Snapshot,
    analysis: &Analysis,
    params: &RenameParams,
) -> Option<Result<WorkspaceEdit, NavigationText>> {
    let file = analysis.resolved.file(DOCUMENT)?;
    let place = offset(&file.source, params.text_document_position_params.position, snapshot.client.unit);
    let naming = Reach::of(analysis).naming_at(place).filter(|naming| is_number(naming, place))?;
    let (l, path) = macrocycle(snapshot, analysis, naming.name)?;
    let new = number_of(&params.new_name, naming.name)
        .and_then(|digits| digits.parse().map_err(|_| NavigationText::SubprogramNumber));
    Some(new.and_then(|new| {
        let edit = workspace::rename(snapshot, l, new, &path)?;
        serde_json::from_value(edit).map_err(|_| NavigationText::NothingToRename)
    }))
}

/// The number and file of a macrocycle whose file can be renamed.
fn macrocycle(snapshot: &Snapshot, analysis: &Analysis, name: Name) -> Option<(u32, PathBuf)> {
    let Name::Macrocycle(l) = name else { return None };
    let mut reach = Reach::of(analysis);
    let file = reach.macrocycle(l).and_then(|id| reach.resolved().unit(id)).map(|unit| unit.file)?;
    let mapped = analysis.settings.machine.cycles.values().any(|mapped| *mapped == l);
    reach.path(file).filter(|_| workspace::can_rename(snapshot) && !mapped).map(|path| (l, path))
}

fn doubts<'a>(snapshot: &'a Snapshot, reach: &'a Reach<'a>, name: Name) -> Doubts<'a> {
    let found = snapshot.found.as_ref().map(|found| &found.report);
    Doubts { found, cancel: &snapshot.cancel, reach, name }
}

/// Whether the number itself is meant, or its address, and not a function that takes it.
fn is_number(naming: &Naming, offset: u32) -> bool {
    naming.written && naming.around.start <= offset && offset <= naming.around.end
}

fn edits(snapshot: &Snapshot, analysis: &Analysis, params: &RenameParams) -> Result<Vec<TextEdit>, NavigationText> {
    let nothing = NavigationText::NothingToRename;
    let Some(file) = analysis.resolved.file(DOCUMENT) else { return Err(nothing) };
    let unit = snapshot.client.unit;
    let place = offset(&file.source, params.text_document_position_params.position, unit);
    let reach = Reach::of(analysis);
    let Some(naming) = reach.naming_at(place).filter(|naming| is_number(naming, place)) else { return Err(nothing) };
    let digits = number_of(&params.new_name, naming.name)?;
    let doubts = doubts(snapshot, &reach, naming.name);
    if let Some(reason) = doubts.against_any() {
        return Err(reason);
    }
    let meant = meant(reach.occurrences(DOCUMENT, naming.name, &snapshot.cancel), &naming);
    if let Some(new) = renamed(naming.name, &digits)
        && new != naming.name
        && let Some(reason) = doubts.against(new, &meant)
    {
        return Err(reason);
    }
    let mut places = Places::new(&file.source, unit);
    let written = |naming: &Naming| match naming.name {
        // In a control word each parameter has two digits.
        Name::Parameter(_) if digits.len() == 1 && naming.is_operand() => format!("0{digits}"),
        Name::Parameter(_) | Name::Block(_) | Name::Subprogram(_) | Name::Macrocycle(_) => digits.clone(),
    };
    if let Some(line) = first_long_line(file, meant.iter().map(|naming| (naming.number, written(naming).len()))) {
        return Err(NavigationText::LineTooLong { line });
    }
    let edits = meant.iter().map(|naming| TextEdit { range: places.range(naming.number), new_text: written(naming) });
    Ok(edits.collect())
}

/// Those that follow when one place gets another number: of two blocks of one number, only the first has jumps.
fn meant(all: Vec<Naming>, chosen: &Naming) -> Vec<Naming> {
    let mut definitions = all.iter().filter(|naming| naming.usage == Usage::Definition).map(|naming| naming.number);
    let first = definitions.next();
    if chosen.usage == Usage::Definition && first != Some(chosen.number) {
        return vec![*chosen];
    }
    let stays = |naming: &Naming| naming.usage == Usage::Definition && Some(naming.number) != first;
    all.into_iter().filter(|naming| !stays(naming)).collect()
}

/// The digits that are to be written: of a block or subprogram as they were typed, with or without its letter.
fn number_of(typed: &str, name: Name) -> Result<String, NavigationText> {
    let (letter, most, reason) = match name {
        Name::Block(_) => ('N', HIGHEST_BLOCK, NavigationText::BlockNumber),
        Name::Subprogram(_) | Name::Macrocycle(_) => ('L', HIGHEST_L, NavigationText::SubprogramNumber),
        Name::Parameter(_) => ('R', u32::from(HIGHEST_PARAMETER), NavigationText::ParameterNumber),
    };
    let typed = typed.trim();
    let digits = typed.strip_prefix([letter, letter.to_ascii_lowercase()]).unwrap_or(typed);
    let number = digits.bytes().all(|byte| byte.is_ascii_digit()).then(|| digits.parse::<u32>().ok()).flatten();
    let is_parameter = matches!(name, Name::Parameter(_));
    match number.filter(|number| *number <= most && (is_parameter || *number > 0)) {
        Some(number) if is_parameter => Ok(number.to_string()),
        Some(_) if digits.len() <= 8 => Ok(digits.to_owned()),
        Some(number) => Ok(number.to_string()),
        None => Err(reason),
    }
}

/// The name with those digits.
fn renamed(name: Name, digits: &str) -> Option<Name> {
    match name {
        Name::Block(_) => digits.parse().ok().map(Name::Block),
        Name::Subprogram(_) => digits.parse().ok().map(Name::Subprogram),
        Name::Macrocycle(_) => digits.parse().ok().map(Name::Macrocycle),
        Name::Parameter(_) => digits.parse().ok().map(Name::Parameter),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn numbers_as_they_are_typed() {
        let number = |typed, name| number_of(typed, name).ok();
        assert_eq!(number(" n0020 ", Name::Block(1)).as_deref(), Some("0020"));
        assert_eq!(number("L07", Name::Subprogram(1)).as_deref(), Some("07"));
        assert_eq!(number("R07", Name::Parameter(1)).as_deref(), Some("7"));
        assert_eq!(number("0000000020", Name::Block(1)).as_deref(), Some("20"));
        for typed in ["", "N", "0", "-1", "+1", "1.5", "L5", "100000000", "X"] {
            assert_eq!(number(typed, Name::Block(1)), None, "{typed}");
        }
        assert_eq!(number("10000", Name::Subprogram(1)), None);
        assert_eq!(number("0", Name::Parameter(1)).as_deref(), Some("0"));
        assert_eq!(number("96", Name::Parameter(1)), None);
    }
}
