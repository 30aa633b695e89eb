//! The data of a page: header and columns, packed.

use serde_json::{Map, Value, json};

use super::column::Column;
use super::container::Container;
use super::rows::{APART, Rows};
use super::text::{Head, Text};
use super::times::Times;

/// Name and version of the form.
pub const SCHEMA: &str = "cnc872c.path/1";

/// The part of a page's header besides its rows.
#[derive(Debug)]
pub(super) struct About<'v> {
    /// The program record of the stream.
    pub program: Map<String, Value>,
    /// The names of its files on the page.
    pub names: &'v [String],
    /// The fields of the records `machine` and `total` of the motion stream that the page shows.
    pub motion: [Value; 2],
    /// Blocks executed of the whole program.
    pub blocks: u64,
    /// Whether the program ended with M02 or M30, without errors.
    pub whole: bool,
    pub findings: Vec<Value>,
    pub equidistant: Option<Value>,
    /// How far working motions go, and all.
    pub size: [Value; 2],
    /// What another program does differently.
    pub compared: Option<Value>,
    /// The arguments with which a command executes the program the same way.
    pub arguments: &'v [String],
}

/// Packs rows and texts.
pub(super) fn pack(rows: &Rows, times: &Times, about: About<'_>) -> Vec<u8> {
    let mut container = Container::default();
    let mut per = Map::new();
    let (text, (positions, times)) = crate::parallel::join(|| Text::of(rows), || (positions(rows), times.pack(rows)));
    let named = |name: &'static str, column| (name.to_owned(), column);
    let mut columns = plain_columns(rows);
    if !rows.plain {
        columns.push(named("seq.row", &rows.row_of));
    }
    for (name, tally) in &positions {
        per.insert(name.clone(), json!(tally.per()));
        columns.push((name.clone(), tally.column()));
    }
    let [first, second] = &rows.arcs;
    // Both columns count in the same parts.
    let arcs = super::tally::alike(first, second);
    per.insert("arc".to_owned(), json!(arcs[0].per()));
    for (name, tally) in ["arc.0", "arc.1"].into_iter().zip(&arcs) {
        columns.push(named(name, tally.column()));
    }
    columns.push(named("row.param", &rows.params));
    columns.push(named("block.own", &rows.files.own));
    columns.push(named("text.skeleton", &text.skeleton));
    columns.push(named("skeleton.bytes", &text.skeleton_bytes));
    columns.push(named("comment.bytes", &text.comment_bytes));
    let mut foretold = Map::new();
    for (letter, column, foretell) in &text.numbers {
        if *foretell {
            foretold.insert(letter.to_string(), json!("row"));
        }
        columns.push((format!("text.{letter}"), column));
    }
    columns.extend(times.columns.iter().map(|(name, column)| (name.clone(), column)));
    container.add_all(columns);
    container.add_text("skeletons", text.skeletons);
    container.add_text("comments", text.comments);
    let mut header = Map::new();
    let mut put = |name: &str, value: Value| drop(header.insert(name.to_owned(), value));
    put("schema", json!(SCHEMA));
    put("generator", json!(concat!("cnc872c ", env!("CARGO_PKG_VERSION"))));
    put("program", Value::Object(about.program));
    let [machine, total] = about.motion;
    put("machine", machine);
    put("total", total);
    put("files", Value::Array(files(rows, about.names, &text.heads)));
    put("blocks", json!(about.blocks));
    put("from", json!(rows.part.from));
    put("count", json!(rows.count()));
    put("whole", json!(about.whole));
    put("states", Value::Array(rows.states.values().to_vec()));
    put("extras", Value::Array(rows.extras.values().to_vec()));
    put("shapes", Value::Array(rows.shapes.values().to_vec()));
    put("calls", Value::Array(rows.contexts.called().to_vec()));
    put("codes", Value::Array(times.codes));
    put("accels", json!(times.accels));
    put("start_s", json!(times.start_s));
    put("beyond", times.beyond.json());
    let ways = rows.ways.iter().chain([&rows.way]).map(|way| Value::from(way.to_f64()));
    put("ways", json!({ "apart": APART, "mm": ways.collect::<Value>() }));
    put("foretold", Value::Object(foretold));
    put("per", Value::Object(per));
    put("turning", json!(rows.turning.is_lathe()));
    put("diameter", json!(rows.turning.diameter));
    put("findings", Value::Array(about.findings));
    let [working, all] = about.size;
    put("size", json!({ "working": working, "all": all }));
    if let Some(equidistant) = about.equidistant {
        put("equidistant", equidistant);
    }
    if !rows.given.is_empty() {
        put("given", Value::Object(rows.given.clone()));
    }
    if !about.arguments.is_empty() {
        put("arguments", json!(about.arguments));
    }
    if let Some(compared) = about.compared {
        header.insert("compared".to_owned(), compared);
    }
    container.finish(header)
}

/// The columns that each page has as its rows count them.
fn plain_columns(rows: &Rows) -> Vec<(String, &Column)> {
    let columns = [
        ("row.block", &rows.block),
        ("row.before", &rows.before),
        ("row.state", &rows.state),
        ("row.extra", &rows.extra),
        ("row.shape", &rows.shape),
        ("row.feed", &rows.feed),
        ("block.n", &rows.files.n),
        ("block.line", &rows.files.line),
        ("block.column", &rows.files.column),
        ("seq.context", &rows.context_of),
        ("seq.left", &rows.left),
        ("context.parent", &rows.contexts.parent),
        ("context.block", &rows.contexts.block),
        ("context.call", &rows.contexts.call),
        ("context.pass", &rows.contexts.pass),
        ("context.of", &rows.contexts.of),
    ];
    columns.map(|(name, column)| (name.to_owned(), column)).into()
}

/// The columns of positions, of the axes that are ever known.
fn positions(rows: &Rows) -> Vec<(String, super::tally::Tally)> {
    let coded = |axis: usize| {
        rows.positions.coded(axis, |row| {
            let shape = rows.shape.get(row).and_then(|shape| rows.shape_keys.get(usize::try_from(shape).ok()?));
            shape.is_some_and(|shape| shape.coded & (1 << axis) != 0)
        })
    };
    let named = rows.letters.iter().enumerate().map(|(axis, letter)| (format!("pos.{letter}"), coded(axis)));
    named.filter(|(_, tally)| tally.len() > 0).collect()
}

/// The files on the page: their names, their heads, the numbers of their blocks and comments.
fn files(rows: &Rows, names: &[String], heads: &[Head]) -> Vec<Value> {
    let mut files = Vec::new();
    for ((file, name), Head { text, comments }) in rows.files.iter().zip(names).zip(heads) {
        files.push(json!({
            "name": name,
            "blocks": file.starts.len(),
            "comments": file.comments.len(),
            "head": text,
            "head_comments": comments,
        }));
    }
    files
}
