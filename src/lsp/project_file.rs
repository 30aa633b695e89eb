//! Completion and hover in the project file, made of the rows of its keys.

use std::path::{Path, PathBuf};
use std::sync::Arc;

use gen_lsp_types::{Position, Range, Uri};
use serde_json::{Value, json};

use super::places::{Places, offset};
use super::snapshot::{Answer, Snapshot};
use crate::config::{Key, PROJECT_FILE};
use crate::diag::Code;
use crate::dict::{Dialect, Lang};
use crate::resolve::Library;
use crate::sure::small;
use crate::text::{Loader, SourceText, Span};

/// Kinds of items, as the protocol numbers them.
const MODULE: u32 = 9;
const PROPERTY: u32 = 10;
const VALUE: u32 = 12;

/// An open project file.
pub(super) struct ProjectFile {
    pub(super) path: PathBuf,
    pub(super) source: Arc<SourceText>,
}

/// The open project file that a request is about.
pub(super) fn of_request(snapshot: &Snapshot, params: &Value) -> Option<ProjectFile> {
    let uri = Uri::parse(params.pointer("/textDocument/uri")?.as_str()?).ok()?;
    let path = snapshot.files.path_of(&uri);
    let document =
        snapshot.files.buffer(&path).filter(|_| path.file_name().is_some_and(|name| name == PROJECT_FILE))?;
    Some(ProjectFile { source: Arc::clone(&document.source), path })
}

fn place(snapshot: &Snapshot, params: &Value) -> Option<(ProjectFile, u32)> {
    let file = of_request(snapshot, params)?;
    let position: Position = serde_json::from_value(params.get("position")?.clone()).ok()?;
    let at = offset(&file.source, position, snapshot.client.unit);
    Some((file, at))
}

/// A line with the table that it is in.
struct Line<'t> {
    table: &'t str,
    text: &'t str,
    span: Span,
}

impl<'t> Line<'t> {
    /// The key that the line sets.
    fn key(&self) -> Option<&'t str> {
        let (key, _) = self.text.split_once('=')?;
        let key = key.trim().trim_matches('"');
        (!key.is_empty() && !key.starts_with(['#', '['])).then_some(key)
    }

    /// The table that the line begins.
    fn header(&self) -> Option<&'t str> {
        let name = self.text.trim_start().strip_prefix('[')?.trim_start_matches('[');
        name.split(']').next().map(str::trim).filter(|name| !name.is_empty())
    }
}

fn lines(source: &SourceText) -> Vec<Line<'_>> {
    let mut table = "";
    let spans = (0..source.lines().count()).map(|line| source.line_span(line));
    let lines = spans.map(|span| {
        let mut line = Line { table, text: source.slice(span), span };
        if let Some(header) = line.header() {
            table = header;
            line.table = header;
        }
        line
    });
    lines.collect()
}

/// `textDocument/completion`: keys of the table, values of a key, tables.
pub(super) fn completion(snapshot: &Snapshot, params: &Value) -> Answer<Value> {
    let Some((file, at)) = place(snapshot, params) else { return Ok(Value::Null) };
    let lines = lines(&file.source);
    let Some(line) = lines.iter().find(|line| line.span.start <= at && at <= line.span.end) else {
        return Ok(Value::Null);
    };
    let mut places = Places::new(&file.source, snapshot.client.unit);
    let (lang, dialect) = (snapshot.client.lang(), dialect(&lines));
    let mut items = Items { lang, dialect, list: Vec::new() };
    let before = file.source.slice(Span::new(line.span.start, at));
    if before.trim_start().starts_with('#') {
        return Ok(Value::Null);
    }
    if let Some((_, typed)) = before.split_once('=') {
        let from = at.saturating_sub(small(typed.trim_start().len()));
        let range = places.range(Span::new(from, line.span.end));
        if let Some(key) = line.key().and_then(|name| Key::of(line.table, name)) {
            for choice in key.choices() {
                items.add(&choice, VALUE, &key, &choice, range);
            }
        }
        return Ok(items.finish());
    }
    let range = places.range(line.span);
    let sets = |table: &str, name: &str| lines.iter().any(|line| line.table == table && line.key() == Some(name));
    if !before.trim_start().starts_with('[') {
        let fits = |key: &Key| key.is_in(line.table) && key.is_for(dialect) && !sets(line.table, key.name());
        for key in Key::all().filter(fits) {
            for text in lines_of(snapshot, &file.path, &key, dialect) {
                items.add(key.name(), PROPERTY, &key, &text, range);
            }
        }
        items.names(line.table, range, |name| sets(line.table, name));
    }
    for key in Key::all().filter(Key::is_table) {
        let header = key.line(dialect);
        if header.starts_with("[[") || !lines.iter().any(|line| line.header() == Some(header.trim_matches(['[', ']'])))
        {
            items.add(&header, MODULE, &key, &header, range);
        }
    }
    Ok(items.finish())
}

/// The control that the file is for.
fn dialect(lines: &[Line<'_>]) -> Dialect {
    let mut set = lines.iter().filter(|line| line.table.is_empty() && line.key() == Some("dialect"));
    let value = set.find_map(|line| line.text.split_once('=')).map(|(_, value)| value.trim_start());
    let named = |dialect: &Dialect| {
        value.is_some_and(|value| value.get(1..).is_some_and(|name| name.starts_with(dialect.name())))
    };
    Dialect::ALL.into_iter().find(named).unwrap_or_default()
}

/// The lines that can be offered for a key. A path that is not there would end every run, so those beside the file are
/// offered: folders with macrocycles, else the folder itself, and XML files.
fn lines_of(snapshot: &Snapshot, file: &Path, key: &Key, dialect: Dialect) -> Vec<String> {
    let folder = file.parent().unwrap_or(Path::new(""));
    let name = |path: PathBuf| Some(toml_edit::Value::from(path.file_name()?.to_str()?).to_string());
    match key.path().as_str() {
        "macrocycles" => {
            let holds =
                |folder: &PathBuf| snapshot.files.list(folder).iter().any(|path| Library::number(path).is_some());
            let folders: Vec<String> =
                snapshot.files.folders(folder).into_iter().filter(holds).filter_map(name).collect();
            let folders = if folders.is_empty() { vec!["\".\"".to_owned()] } else { folders };
            folders.into_iter().map(|folder| format!("macrocycles = [{folder}]")).collect()
        }
        "channel-config" => {
            let is_xml =
                |path: &PathBuf| path.extension().is_some_and(|extension| extension.eq_ignore_ascii_case("xml"));
            let files = snapshot.files.list(folder).into_iter().filter(is_xml).filter_map(name);
            files.map(|file| format!("channel-config = {file}")).collect()
        }
        _ => vec![key.line(dialect)],
    }
}

/// Items in the making.
struct Items {
    lang: Lang,
    dialect: Dialect,
    list: Vec<Value>,
}

impl Items {
    fn add(&mut self, label: &str, kind: u32, key: &Key, text: &str, range: Range) {
        self.push(label, kind, key.meaning(self.lang), &key.page(self.dialect, self.lang), text, range);
    }

    /// The names of the control that a table takes; of findings those whose level can be set.
    fn names(&mut self, table: &str, range: Range, there: impl Fn(&str) -> bool) {
        if table != "lints" {
            return;
        }
        for code in
            Code::ALL.iter().filter(|code| code.is_configurable() && !there(code.name()) && !there(code.as_str()))
        {
            let page = code.page(self.lang);
            let title = page.lines().next().unwrap_or_default().trim_start_matches(['#', ' ']);
            self.push(code.name(), PROPERTY, title, page, &format!("{} = \"allow\"", code.name()), range);
        }
    }

    fn push(&mut self, label: &str, kind: u32, detail: &str, page: &str, text: &str, range: Range) {
        self.list.push(json!({
            "label": label,
            "kind": kind,
            "detail": detail,
            "documentation": { "kind": "markdown", "value": page },
            "sortText": format!("{:04}", self.list.len()),
            "filterText": text,
            "textEdit": { "range": range, "newText": text },
        }));
    }

    fn finish(self) -> Value {
        json!({ "isIncomplete": false, "items": self.list })
    }
}

/// `textDocument/hover`: the page of the key or table; of a finding's level that of the finding.
pub(super) fn hover(snapshot: &Snapshot, params: &Value) -> Answer<Value> {
    let Some((file, at)) = place(snapshot, params) else { return Ok(Value::Null) };
    let lang = snapshot.client.lang();
    let lines = lines(&file.source);
    let Some(line) = lines.iter().find(|line| line.span.start <= at && at <= line.span.end) else {
        return Ok(Value::Null);
    };
    let dialect = dialect(&lines);
    let lint =
        || line.key().filter(|_| line.table == "lints").and_then(Code::find).map(|code| code.page(lang).to_owned());
    let key = || line.key().and_then(|name| Key::of(line.table, name)).map(|key| key.page(dialect, lang));
    let table = || Key::of_table(line.table).map(|key| key.page(dialect, lang));
    let Some(page) = lint().or_else(key).or_else(table).filter(|_| line.key().is_some() || line.header().is_some())
    else {
        return Ok(Value::Null);
    };
    let range = Places::new(&file.source, snapshot.client.unit).range(line.span);
    Ok(json!({ "contents": { "kind": "markdown", "value": page }, "range": range }))
}
