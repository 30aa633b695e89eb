//! Above a unit: which blocks call it. Above a program: how long it is. Times where motion is configured. Above a tool
//! change: what holds there.

use std::collections::BTreeMap;

use gen_lsp_types::{CodeLens, CodeLensParams, Command, Location as LspLocation, Uri};
use serde_json::{Value, json};

use super::analysis::Analysis;
use super::places::{Places, location};
use super::snapshot::{Answer, Snapshot};
use crate::dict::{Address, TOOL_CHANGE};
use crate::query::cursor::DOCUMENT;
use crate::query::executed::path;
use crate::query::hover_texts::Said;
use crate::query::observe::{Observation, executing, observe_motion};
use crate::query::shown::count;
use crate::resolve::{Target, Unit, UnitId, UnitKind};
use crate::session::Session;
use crate::syntax::{BlockFlags, ParsedFile, Word};
use crate::text::{FileId, Span};

/// The command that shows what holds at a place: a URI, a position; the client has it.
const STATE_HERE: &str = "cnc872c.stateHere";

/// Most tool changes that have a lens.
const TOOL_CHANGES: usize = 200;

/// The command that shows a list of places: a URI, a position, locations; the client has it.
const SHOW_REFERENCES: &str = "cnc872c.showReferences";

/// `textDocument/codeLens`.
pub(super) fn code_lens(
    snapshot: &Snapshot,
    analysis: &Analysis,
    params: CodeLensParams,
) -> Answer<Option<Vec<CodeLens>>> {
    let Some(file) = analysis.resolved.file(DOCUMENT) else { return Ok(None) };
    let uri = params.text_document.uri;
    let mut places = Places::new(&file.source, snapshot.client.unit);
    let mut lenses = Vec::new();
    let units: Vec<(UnitId, Unit)> = analysis
        .resolved
        .units()
        .filter(|(_, unit)| unit.file == DOCUMENT && unit.kind != UnitKind::Main)
        .map(|(id, unit)| (id, *unit))
        .collect();
    let observation = observed(snapshot, analysis, &units);
    if let Some((word, totals)) = file.program.zip(observation.as_ref().map(|seen| totals(snapshot, seen))) {
        let range = places.range(word.span(file.source.text()));
        lenses.push(lens(range, totals, "", None));
    }
    let mut called = if Session::is_macrocycle_name(&analysis.path) {
        callers_of_macrocycle(snapshot, analysis)
    } else {
        callers(snapshot, analysis)
    };
    for (at, (id, unit)) in units.into_iter().enumerate() {
        let callers = called.remove(&id).unwrap_or_default();
        let title = match callers.len() {
            // What executes it leads there by a parameter or a fixed cycle.
            0 if !analysis.executable && snapshot.open().any(|open| open.has_executed(analysis)) => Said::CallUnseen,
            1 => Said::OneCall,
            count => Said::Calls { count },
        };
        let range = places.range(unit.entry.span);
        let arguments = json_list(&uri, &range.start, &callers);
        let lang = snapshot.client.lang();
        let total = observation.as_ref().and_then(|seen| seen.moves.as_ref()?.units.get(at).copied());
        let title = match total.filter(|total| !total.is_nothing()) {
            Some(total) => Said::WithTime { text: title.text(lang), time: total.text(lang) }.text(lang),
            None => title.text(lang),
        };
        lenses.push(lens(range, title, SHOW_REFERENCES, Some(arguments)));
    }
    if snapshot.client.lists("/experimental/commands/commands", STATE_HERE)
        && executing(snapshot.open(), analysis).is_some()
    {
        let title = Said::StateHere.text(snapshot.client.lang());
        for range in tool_changes(file).map(|span| places.range(span)) {
            let arguments = vec![json!(uri), json!(range.start)];
            lenses.push(lens(range, title.clone(), STATE_HERE, Some(arguments)));
        }
    }
    Ok(Some(lenses))
}

/// The numbers of the blocks that write M06.
fn tool_changes(file: &ParsedFile) -> impl Iterator<Item = Span> + '_ {
    let changes = |word: &Word| word.address == Address::M && word.whole() == Some(i64::from(TOOL_CHANGE));
    let blocks = file.block_ids().filter(|block| file.flags(*block).has(BlockFlags::RICH));
    let changing = blocks.filter(move |block| file.words(*block).iter().any(changes));
    changing.filter_map(|block| Some(file.n_word(block)?.span(file.source.text()))).take(TOOL_CHANGES)
}

fn lens(range: gen_lsp_types::Range, title: String, command: &str, arguments: Option<Vec<Value>>) -> CodeLens {
    let command = Command { title, tooltip: None, command: command.to_owned(), arguments };
    CodeLens { range, command: Some(command), data: None }
}

fn json_list(uri: &Uri, position: &gen_lsp_types::Position, places: &[LspLocation]) -> Vec<Value> {
    vec![json!(uri), json!(position), json!(places)]
}

/// An execution to the end; `None` for programs that are not executed, or not to their end.
fn observed(snapshot: &Snapshot, analysis: &Analysis, units: &[(UnitId, Unit)]) -> Option<Observation> {
    let program = analysis.executable.then_some(analysis)?;
    let reach: Vec<_> = units.iter().map(|(_, unit)| (unit.first, unit.end)).collect();
    let observation = observe_motion(&snapshot.cancel, program, analysis, [], &reach, &[])?;
    observation.end.is_some().then_some(observation)
}

/// Blocks executed, the path, and the time where motion is configured.
fn totals(snapshot: &Snapshot, observation: &Observation) -> String {
    let lang = snapshot.client.lang();
    let (blocks, path) = (count(observation.executed), path(observation, lang));
    let text = Said::Totals { blocks, path }.text(lang);
    match &observation.moves {
        Some(seen) => Said::WithTime { text, time: seen.total.text(lang) }.text(lang),
        None => text,
    }
}

/// The same of a document that is a macrocycle: its calls in all open programs and what they lead to.
fn callers_of_macrocycle(snapshot: &Snapshot, analysis: &Analysis) -> BTreeMap<UnitId, Vec<LspLocation>> {
    let mut found: Vec<LspLocation> = Vec::new();
    for program in &snapshot.analyses {
        let is_here = |unit: UnitId| {
            let file = program.resolved.unit(unit).and_then(|unit| program.resolved.file(unit.file));
            file.is_some_and(|file| program.is(file.source.name(), analysis))
        };
        found.extend(callers(snapshot, program).into_iter().filter(|(unit, _)| is_here(*unit)).flat_map(|(_, at)| at));
    }
    // Several programs may lead to the same macrocycles.
    found.sort_by_key(|place| (place.uri.clone(), place.range.start.line, place.range.start.character));
    found.dedup();
    let own = analysis.resolved.units().map(|(id, _)| id).next();
    own.map(|own| (own, found)).into_iter().collect()
}

/// The blocks of a program and its macrocycles that call units, by unit, in the order of the text.
fn callers(snapshot: &Snapshot, program: &Analysis) -> BTreeMap<UnitId, Vec<LspLocation>> {
    let mut found: BTreeMap<UnitId, Vec<LspLocation>> = BTreeMap::new();
    let files = (0..).map(FileId).map_while(|index| Some((index, program.resolved.file(index)?)));
    for (index, file) in files {
        for block in file.block_ids() {
            if block.0.is_multiple_of(1 << 16) && snapshot.cancel.is_cancelled() {
                return found;
            }
            if file.flags(block).has(BlockFlags::RICH)
                && let Some(Target::Unit(unit)) = program.resolved.target(index, block)
            {
                let place = location(&snapshot.files, &program.sources, file.n_place(block), snapshot.client.unit);
                found.entry(unit).or_default().extend(place);
            }
        }
    }
    found
}
