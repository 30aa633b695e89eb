//! `textDocument/signatureHelp`: the parameters that the macrocycle takes which a block calls, with their values there.

use gen_lsp_types::{Position, TextDocumentPositionParams};
use serde_json::{Value, json};

use super::analysis::Analysis;
use super::places::offset;
use super::snapshot::{Answer, Snapshot};
use crate::dict::{Address, GCode};
use crate::query::callee::{about, inputs};
use crate::query::cursor::{DOCUMENT, block_at, word_at};
use crate::query::flow::Flow;
use crate::query::observe::{executing, observe_inputs};
use crate::query::reach::Reach;
use crate::resolve::Target;

/// Characters after which clients ask by themselves.
pub(super) const TRIGGERS: [&str; 4] = ["L", "l", "R", "r"];

/// Answers the request.
pub(super) fn signature_help(
    snapshot: &Snapshot,
    analysis: &Analysis,
    params: TextDocumentPositionParams,
) -> Answer<Option<Value>> {
    Ok(help(snapshot, analysis, params.position))
}

fn help(snapshot: &Snapshot, analysis: &Analysis, position: Position) -> Option<Value> {
    let file = analysis.resolved.file(DOCUMENT)?;
    let place = offset(&file.source, position, snapshot.client.unit);
    let block = block_at(file, place)?;
    let flow = Flow::of(analysis, file, block).filter(|flow| flow.code == GCode::G72)?;
    let Some(Target::Unit(id)) = flow.target else { return None };
    let reach = Reach::of(analysis);
    let unit = *reach.resolved().unit(id)?;
    let called = reach.resolved().file(unit.file)?;
    let inputs = inputs(&reach.names(unit.file)?, &unit);
    let observation = executing(snapshot.open(), analysis)
        .and_then(|program| observe_inputs(&snapshot.cancel, program, analysis, block, &inputs));
    let observed = observation.as_ref().and_then(|observation| observation.of(block));
    let shown = |index: &u8| {
        let values = observed.and_then(|observed| observed.inputs.get(index)).filter(|values| values.is_known());
        values.map_or_else(|| format!("R{index}"), |values| format!("R{index} = {}", values.list(|value| value)))
    };
    let labels: Vec<String> = inputs.iter().map(shown).collect();
    let at = word_at(file, place).map(|found| found.word).filter(|word| word.address == Address::R);
    let active = at.and_then(|word| inputs.iter().position(|index| *index == word.target()));
    let parameters: Vec<Value> = labels.iter().map(|label| json!({ "label": label })).collect();
    let mut signature = json!({
        "label": format!("{}: {}", unit.name(), labels.join(", ")),
        "documentation": about(called, &unit).join("\n"),
        "parameters": parameters,
    });
    if let (Some(active), Some(signature)) = (active, signature.as_object_mut()) {
        signature.insert("activeParameter".to_owned(), active.into());
    }
    Some(json!({ "signatures": [signature], "activeSignature": 0 }))
}
