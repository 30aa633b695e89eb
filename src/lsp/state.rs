//! `cnc872c/state`: what holds at the place of the cursor when the program is executed.

use gen_lsp_types::Position;
use serde::Deserialize;
use serde_json::{Value, json};

use super::analysis::Analysis;
use super::places::offset;
use super::snapshot::{Answer, Refusal, Snapshot};
use crate::analysis::state::{Arrival, Asked, Place, PlaceFault, document, fault_text, passes_text, text};
use crate::edit::edit_texts::EditText;
use crate::query;
use crate::query::cursor::{DOCUMENT, block_at};
use crate::query::hover_texts::Said;
use crate::query::observe::{MOST, executing};
use crate::query::state::{Executions, Indexed};
use crate::session::Session;
use crate::text::Loader;

/// A place in a program or macrocycle.
#[derive(Clone, Debug, Deserialize)]
pub(super) struct StateParams {
    position: Position,
    /// Which executed block, of those that a former answer listed.
    #[serde(default)]
    seq: Option<u64>,
    /// What holds behind the block, not before it.
    #[serde(default)]
    pub(super) after: bool,
    /// Of `cnc872c/restart`: where the tool's axis is clear of everything.
    #[serde(default)]
    pub(super) safe: Option<String>,
}

/// The block at a place, when its program is executed.
pub(super) enum Here<'a> {
    /// No block is there, or the answer is not wanted any more.
    Nowhere,
    /// One execution of it.
    At {
        /// The program.
        program: &'a query::analysis::Analysis,
        /// Its execution.
        indexed: &'a Indexed,
        /// Which executed block.
        seq: u64,
    },
    /// Several executions, for the user to choose one.
    Several(Value),
}

/// A place gives `{ "seq", "text", "state" }`: the executed block, the table of `cnc872c state`, and its JSON. A block
/// that is executed several times gives `{ "count", "message", "passes": [{ "pass", "seq", "text" }] }`: the first of
/// its executions, one of which is asked for by its `seq`. Null where no block is.
pub(super) fn state(snapshot: &Snapshot, analysis: &Analysis, params: StateParams) -> Answer<Value> {
    let lang = snapshot.client.lang();
    let (program, indexed, seq) = match here(snapshot, analysis, &params)? {
        Here::Nowhere => return Ok(Value::Null),
        Here::Several(passes) => return Ok(passes),
        Here::At { program, indexed, seq } => (program, indexed, seq),
    };
    if indexed.has_error_before(seq, params.after) {
        return Err(Refusal::new(EditText::ErrorBefore.text(lang)));
    }
    let name = name(snapshot, program);
    let Some(found) = indexed.at(program, seq, params.after, &snapshot.cancel) else { return Ok(Value::Null) };
    Ok(json!({
        "seq": seq,
        "text": text(&found, &name, &program.settings, lang),
        "state": document(&found, &name, &program.settings),
    }))
}

/// Which executed block a request is about.
pub(super) fn here<'a>(snapshot: &'a Snapshot, analysis: &'a Analysis, params: &StateParams) -> Answer<Here<'a>> {
    let lang = snapshot.client.lang();
    let Some(file) = analysis.resolved.file(DOCUMENT) else { return Ok(Here::Nowhere) };
    let place = offset(&file.source, params.position, snapshot.client.unit);
    let block = block_at(file, place).filter(|_| place <= file.end);
    let Some(block) = block.filter(|block| file.n_word(*block).is_some()) else { return Ok(Here::Nowhere) };
    let Some(program) = executing(snapshot.open(), analysis) else {
        let macrocycle = Session::is_macrocycle_name(&analysis.path);
        let why = if macrocycle { Said::NoProgram } else { Said::HasErrors };
        return Err(Refusal::new(why.text(lang)));
    };
    let Some(indexed) = Indexed::of(program, &snapshot.cancel) else { return Ok(Here::Nowhere) };
    let asked_for = |place| Asked { place, file: None, pass: None, after: params.after };
    if let Some(seq) = params.seq {
        let blocks = indexed.executed();
        return if seq < blocks {
            Ok(Here::At { program, indexed, seq })
        } else {
            Err(Refusal::new(fault_text(&PlaceFault::Beyond { blocks }, &asked_for(Place::Seq(seq)), lang)))
        };
    }
    let asked = asked_for(Place::N(file.shown_number(block)));
    match indexed.executions(program, analysis, block) {
        Executions::One(seq) => Ok(Here::At { program, indexed, seq }),
        Executions::Several(arrivals, count) => Ok(Here::Several(several(&arrivals, count, snapshot))),
        Executions::Never(true) => Err(Refusal::new(EditText::TooLong { blocks: MOST }.text(lang))),
        Executions::Never(false) => Err(Refusal::new(fault_text(&PlaceFault::NotExecuted, &asked, lang))),
    }
}

fn several(arrivals: &[Arrival], count: u64, snapshot: &Snapshot) -> Value {
    let lang = snapshot.client.lang();
    let rows = passes_text(arrivals, lang);
    let passes = (1..).zip(arrivals).zip(rows).map(
        |((pass, arrival), text): ((u64, &Arrival), String)| json!({ "pass": pass, "seq": arrival.seq, "text": text }),
    );
    let n = arrivals.first().map_or(0, |arrival| arrival.n);
    let message = EditText::Passes { n, count }.text(lang);
    json!({ "count": count, "message": message, "passes": passes.collect::<Vec<_>>() })
}

/// The program as the user knows it: its path below the folder of the workspace.
pub(super) fn name(snapshot: &Snapshot, program: &query::analysis::Analysis) -> String {
    let root = snapshot.files.canonical(&snapshot.client.root());
    program.path.strip_prefix(root).unwrap_or(&program.path).to_string_lossy().into_owned()
}
