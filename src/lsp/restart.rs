//! `cnc872c/restart`: a program that starts at the place of the cursor.

use serde_json::{Value, json};

use super::analysis::{Analysis, configuration};
use super::commands::refuse_errors;
use super::snapshot::{Answer, Refusal, Snapshot};
use super::state::{Here, StateParams, here, name};
use crate::analysis::state::{Asked, Place, fault_text};
use crate::config::parse_position;
use crate::diag::Report;
use crate::dict::Decimal;
use crate::edit::edit_texts::EditText;
use crate::restart::{self, Made, Nearest, Options, Restart, Said, refusal_text};
use crate::session::Session;

/// A place, as that of `cnc872c/state`, gives `{ "name", "text", "message" }`: the new program, and what to say of it.
/// Where no start is possible it gives `{ "refused", "nearest": { "seq", "n" } }`: why, and the nearest earlier place;
/// `{ "safe" }` when the height is missing at which the tool is clear of everything; and the same as that request where
/// a block is executed several times. Null where no block is.
pub(super) fn restart(snapshot: &Snapshot, analysis: &Analysis, params: StateParams) -> Answer<Value> {
    let lang = snapshot.client.lang();
    let (program, seq) = match here(snapshot, analysis, &params)? {
        Here::Nowhere => return Ok(Value::Null),
        Here::Several(passes) => return Ok(passes),
        Here::At { program, seq, .. } => (program, seq),
    };
    let safe =
        params.safe.map(|text| height(&text).ok_or_else(|| Refusal::new(EditText::NoHeight { text }.text(lang))));
    let safe = safe.transpose()?;
    let options = Options { safe, clearance: Decimal::from_thousandths(2000), all_m: false };
    let goes_on = |_| !snapshot.cancel.is_cancelled();
    let session = Session { progress: Some(&goes_on), ..program.session() };
    let asked = Asked { place: Place::Seq(seq), file: None, pass: None, after: params.after };
    let name = name(snapshot, program);
    let Made { outcome, answer } = restart::restart(&session, &program.path, &name, &asked, options, lang);
    if snapshot.cancel.is_cancelled() {
        return Ok(Value::Null);
    }
    Ok(match answer {
        restart::Answer::Program(made) => shown(&made, &name, snapshot),
        restart::Answer::Refused { reason, .. } if reason.asks_for_safe() => json!({ "safe": reason.text(lang) }),
        restart::Answer::Refused { reason, nearest } => {
            let text = refusal_text(&reason, nearest.as_ref(), lang);
            let nearest = nearest.map(|Nearest { seq, n, .. }| json!({ "seq": seq, "n": n }));
            json!({ "refused": text, "nearest": nearest })
        }
        restart::Answer::Place(fault) => return Err(Refusal::new(fault_text(&fault, &asked, lang))),
        restart::Answer::Broken => {
            let (_, sources, findings) = configuration(&program.path, &snapshot.files, &snapshot.client);
            let mut report = Report::new();
            report.add(&sources, findings);
            report.add_program(&outcome.sources, outcome.findings);
            refuse_errors(snapshot, &report)?;
            return Err(Refusal::new(EditText::NotWhole.text(lang)));
        }
    })
}

/// A height in mm, as somebody types it.
fn height(text: &str) -> Option<Decimal> {
    parse_position(&text.trim().replace(',', "."))
}

/// The new program, with a name for it.
fn shown(made: &Restart, name: &str, snapshot: &Snapshot) -> Value {
    let lang = snapshot.client.lang();
    let file = std::path::Path::new(name);
    let stem = file.file_stem().map_or_else(String::new, |stem| stem.to_string_lossy().into_owned());
    let extension = file.extension().map_or_else(String::new, |extension| format!(".{}", extension.to_string_lossy()));
    let written = Said::Written { written_out: made.written_out };
    let message = (made.written_out > 0).then(|| written.text(lang));
    json!({ "name": format!("{stem}-N{}{extension}", made.n), "text": made.text(), "message": message })
}
