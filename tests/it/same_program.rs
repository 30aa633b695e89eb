//! What holds of every formatted file: the program stays the same (FMT-1, FMT-3, FMT-7). The fuzz target `format` has
//! this file too.

use std::collections::BTreeMap;
use std::path::Path;
use std::sync::Arc;

use cnc872c::config::Settings;
use cnc872c::diag::Code;
use cnc872c::edit::format;
use cnc872c::session::{Part, Session};
use cnc872c::syntax::{Form, parse};
use cnc872c::text::{Encoding, FileId, MemoryLoader, SourceText};

/// The formatted bytes; `None` when a finding keeps the file as it is.
pub fn formatted(path: &str, bytes: &[u8], settings: &Settings) -> Option<Vec<u8>> {
    let source = source(path, bytes, settings.encoding);
    let mut after = Vec::new();
    let formatted = format(Path::new(path), &source, settings, &mut |part| after.extend_from_slice(part)).ok()?;
    assert!(!formatted.changed || after != bytes, "nothing changed");
    Some(if formatted.changed { after } else { bytes.to_vec() })
}

/// Formats a file and compares: the same records but for places, the same findings but for those about layout, the same
/// comments, no longer line, and nothing to change the second time.
///
/// # Errors
/// What differs, with both texts.
pub fn stays_the_same(path: &str, bytes: &[u8], settings: &Settings) -> Result<(), String> {
    let Some(after) = formatted(path, bytes, settings) else { return Ok(()) };
    let shown = |bytes: &[u8]| source(path, bytes, settings.encoding).text().to_owned();
    let unless = |same: bool, what: String| {
        let texts = || format!("{path}: {what}\n--- before\n{}\n--- after\n{}\n", shown(bytes), shown(&after));
        if same { Ok(()) } else { Err(texts()) }
    };
    let again = formatted(path, &after, settings).unwrap_or_default();
    unless(again == after, format!("formatted again:\n{}", shown(&again)))?;
    let (old, new) = (meaning(path, bytes, settings), meaning(path, &after, settings));
    let codes = old.findings.keys().chain(new.findings.keys());
    for code in codes {
        let [before, now] = [&old, &new].map(|it| it.findings.get(code).copied().unwrap_or(0));
        let layout = matches!(*code, Code::W0108 | Code::E0109);
        unless(now == before || (layout && now < before), format!("{code}: {before} before, {now} after"))?;
    }
    unless(old.records.len() == new.records.len(), "another number of records".to_owned())?;
    for (old, new) in old.records.iter().zip(&new.records) {
        unless(old == new, format!("{old}\nbecame {new}"))?;
    }
    let comments = |bytes: &[u8]| comments(path, bytes, settings.encoding);
    unless(comments(bytes) == comments(&after), "other comments".to_owned())?;
    let [before, now] = [bytes, &after].map(|bytes| long_lines(&shown(bytes)));
    unless(now <= before, format!("{now} lines too long, {before} before"))
}

fn source(path: &str, bytes: &[u8], encoding: Encoding) -> Arc<SourceText> {
    Arc::new(SourceText::decode(path, bytes.to_vec(), encoding).expect("a short text"))
}

/// The executed program: the records without the places in the text, and the findings, without places.
struct Meaning {
    records: Vec<serde_json::Value>,
    findings: BTreeMap<Code, usize>,
}

fn meaning(path: &str, bytes: &[u8], settings: &Settings) -> Meaning {
    let loader = MemoryLoader::new().with(path, bytes.to_vec());
    let session = Session { loader: &loader, settings, progress: None };
    let mut stream = Vec::new();
    if !Session::is_macrocycle_name(Path::new(path)) {
        session.compile(Path::new(path), path, Part::default(), &mut stream).expect("memory takes all");
    }
    let findings = session.check(Path::new(path), path).findings;
    let mut counts = BTreeMap::new();
    findings.items().iter().for_each(|item| *counts.entry(item.code()).or_default() += 1);
    for ((_, code), beyond) in findings.beyond() {
        *counts.entry(code).or_default() += beyond;
    }
    let records = stream.split(|byte| *byte == b'\n').filter(|line| !line.is_empty());
    let records = records.map(|line| without_places(serde_json::from_slice(line).expect("JSON"))).collect();
    Meaning { records, findings: counts }
}

fn without_places(mut value: serde_json::Value) -> serde_json::Value {
    fn strip(value: &mut serde_json::Value) {
        if let Some(fields) = value.as_object_mut() {
            fields.remove("line");
            fields.remove("column");
            fields.values_mut().for_each(strip);
        } else if let Some(items) = value.as_array_mut() {
            items.iter_mut().for_each(strip);
        }
    }
    strip(&mut value);
    value
}

/// The comments as bytes, without the blanks at the ends of open ones.
fn comments(path: &str, bytes: &[u8], encoding: Encoding) -> Vec<Vec<u8>> {
    let source = source(path, bytes, encoding);
    let form = if Session::is_macrocycle_name(Path::new(path)) { Form::Macrocycle } else { Form::Program };
    let file = parse(FileId(0), &source, form, &mut cnc872c::diag::Findings::new());
    let bytes_of = |span: &cnc872c::text::Span| {
        let [start, end] = [span.start, span.end].map(|at| usize::try_from(source.byte_offset(at)).expect("an offset"));
        bytes.get(start..end).expect("within the file").trim_ascii_end().to_vec()
    };
    file.all_comments().iter().map(bytes_of).collect()
}

fn long_lines(text: &str) -> usize {
    text.split(['\n', '\r']).filter(|line| line.chars().count() > 80).count()
}
