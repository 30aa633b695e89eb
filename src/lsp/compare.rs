//! `cnc872c/compare`: what an open program and another one, or the saved text of it, do differently.

use std::path::Path;
use std::sync::Arc;

use gen_lsp_types::Uri;
use serde::Deserialize;
use serde_json::{Value, json};

use super::analysis::{Analysis, configuration};
use super::snapshot::{Answer, Refusal, Snapshot};
use crate::analysis::compare::{Side, Steps, Tolerances, compare, for_page, text};
use crate::config::Settings;
use crate::diag::Report;
use crate::dict::bilingual;
use crate::query::observe::MOST;
use crate::session::Session;
use crate::text::{FileId, Loader, Overlay, last_name};
use crate::view::{Collector, Keep, Naming, Part, page};

/// What is compared, beside the document.
#[derive(Debug, Deserialize)]
pub(super) struct CompareParams {
    /// The old program; without it the saved text is the old one.
    #[serde(default)]
    with: Option<Uri>,
    /// Whether a page is wanted.
    #[serde(default)]
    page: bool,
}

bilingual! {
    /// Why nothing is compared.
    Words {
        CannotRead { file: String } "{file} cannot be read", "{file} nelze číst";
        HasErrors { file: String } "{file} has errors: it cannot be compared", "{file} má chyby: nelze ho porovnat";
        Macrocycle "a macrocycle is not compared: compare the programs that call it",
            "makrocyklus se neporovnává: porovnat lze programy, které ho volají";
        TooLong { file: String } "{file} executes too many blocks for the editor: use cnc872c compare",
            "{file} provádí na editor příliš mnoho bloků: použijte cnc872c compare";
    }
}

/// One of the two programs.
struct Program<'a> {
    path: &'a Path,
    /// As it is called in the answer.
    name: String,
    loader: &'a dyn Loader,
    settings: &'a Settings,
}

/// Gives `{ "same", "text", "page"? }`: the text is that of `cnc872c compare`, the page that of its `-o`.
pub(super) fn answer(snapshot: &Snapshot, analysis: &Analysis, params: CompareParams) -> Answer<Value> {
    let lang = snapshot.client.lang();
    let refuse = |words: Words| Refusal::new(words.text(lang));
    let CompareParams { with, page: wants_page } = params;
    let (files, path) = (&snapshot.files, &analysis.path);
    if Session::is_macrocycle_name(path) {
        return Err(refuse(Words::Macrocycle));
    }
    let other = with.as_ref().map_or_else(|| path.clone(), |uri| files.path_of(uri));
    let bytes = if with.is_none() { files.saved(path) } else { files.read(&other) };
    let bytes = bytes.map_err(|_| refuse(Words::CannotRead { file: last_name(&other) }))?;
    let overlay = Overlay { below: files, path: &other, bytes: &bytes };
    let (settings, ..) = configuration(&other, files, &snapshot.client);
    let old_loader: &dyn Loader = if with.is_none() { &overlay } else { files };
    let old = Program { path: &other, name: last_name(&other), loader: old_loader, settings: &settings };
    let new = Program { path, name: last_name(path), loader: files, settings: &analysis.settings };
    let (old_read, new_read) = (old.read(snapshot), new.read(snapshot));
    let ((old_side, old_steps), (new_side, new_steps)) = (old_read.map_err(refuse)?, new_read.map_err(refuse)?);
    let changes = compare(&old_steps, &new_steps, Tolerances::default()).changes;
    drop((old_steps, new_steps));
    let mut found = json!({
        "same": changes.is_empty(),
        "text": text(&old_side, &new_side, &changes, true, lang),
    });
    if let Some(found) = found.as_object_mut().filter(|_| wants_page) {
        let compared = for_page(&old_side, &new_side, &changes);
        let (before, after) = (old.draw(None), new.draw(Some(compared)));
        found.insert("page".to_owned(), json!(page(&after, Some(&before), &new.name, Some(lang))));
    }
    Ok(found)
}

impl Program<'_> {
    /// Its steps.
    fn read(&self, snapshot: &Snapshot) -> Result<(Side, Steps), Words> {
        let Self { path, name, loader, settings } = self;
        let goes_on = |executed| executed <= MOST && !snapshot.cancel.is_cancelled();
        let session = Session { loader: *loader, settings, progress: Some(&goes_on) };
        let (run, side, steps) = session.steps(path, name, false);
        match (run.whole, run.outcome.executed) {
            (Some(_), _) => Ok((side, steps)),
            (None, executed) if executed > MOST => Err(Words::TooLong { file: name.clone() }),
            (None, _) => Err(Words::HasErrors { file: name.clone() }),
        }
    }

    /// The data of its picture.
    fn draw(&self, compared: Option<Value>) -> Vec<u8> {
        let Self { path, name, loader, settings } = self;
        let session = Session { loader: *loader, settings, progress: None };
        let mut collector = Collector::new(settings, Part::default(), Keep::Records);
        let outcome = session.draw(path, name, collector.sink()).outcome;
        let naming = Naming { program: path, loader: *loader };
        let source: Option<&Arc<_>> = outcome.sources.get(FileId(0));
        let view = collector.finish(source, naming, outcome.executed);
        let mut report = Report::new();
        report.add_program(&outcome.sources, outcome.findings);
        view.data(&report, naming, compared)
    }
}
