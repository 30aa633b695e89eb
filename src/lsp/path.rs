//! `cnc872c/path`: the data of the page that shows a program's path, for editors that show it beside the text.

use base64::Engine as _;
use base64::engine::general_purpose::STANDARD;
use gen_lsp_types::Uri;
use serde_json::{Value, json};

use super::analysis::{Analysis, configuration};
use super::snapshot::{Answer, Snapshot};
use crate::config::Purpose;
use crate::diag::Report;
use crate::query;
use crate::query::observe::{MOST, executing};
use crate::session::Session;
use crate::text::{FileId, Loader};
use crate::view::{Collector, Keep, Naming, Part};

/// A program, or a macrocycle that an open program calls, gives `{ "uri", "files", "blocks", "truncated", "data" }`:
/// the program that is shown, the URIs of its files by the index that the data give them, how many blocks were
/// executed, whether there are more, and the data of its page in base 64. `blocks` is 0 when the data hold none of
/// them, as of a program with written errors. Null for what no program executes.
pub(super) fn path(snapshot: &Snapshot, analysis: &Analysis, _: Value) -> Answer<Option<Value>> {
    let program: &query::analysis::Analysis = match executing(snapshot.open(), analysis) {
        Some(program) => program,
        None if Session::is_macrocycle_name(&analysis.path) => return Ok(None),
        // The picture shows its errors.
        None => analysis,
    };
    let (files, settings, path) = (&snapshot.files, &program.settings, &program.path);
    let (_, config_sources, config_findings) = configuration(path, files, &snapshot.client);
    let mut report = Report::new();
    report.add(&config_sources, config_findings);
    let goes_on = |executed| executed <= MOST && !snapshot.cancel.is_cancelled();
    let session = Session { loader: files, settings, progress: Some(&goes_on) };
    let root = files.canonical(&snapshot.client.root());
    let name = path.strip_prefix(root).unwrap_or(path).to_string_lossy().into_owned();
    let mut collector = Collector::new(settings, Part { from: 0, blocks: Some(MOST) }, Keep::Records);
    let outcome = session.run(path, &name, Purpose::Compile, collector.sink()).outcome;
    if snapshot.cancel.is_cancelled() {
        return Ok(None);
    }
    let naming = Naming { program: path, loader: files };
    let view = collector.finish(outcome.sources.get(FileId(0)), naming, outcome.executed);
    report.add_program(&outcome.sources, outcome.findings);
    let uri = |name: &str| files.uri_of(std::path::Path::new(name)).map(|uri| uri.as_str().to_owned());
    let own = files.uri_of(path).as_ref().map(|uri: &Uri| uri.as_str().to_owned());
    let uris: Vec<Option<String>> =
        view.files().enumerate().map(|(index, name)| if index == 0 { own.clone() } else { uri(name) }).collect();
    Ok(Some(json!({
        "uri": own,
        "files": uris,
        "blocks": if view.count() == 0 { 0 } else { outcome.executed },
        "truncated": outcome.executed > MOST,
        "data": STANDARD.encode(view.data(&report, naming, None)),
    })))
}
