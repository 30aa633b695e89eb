//! Rows as JSON, CSV, and lines for people.

use std::collections::BTreeMap;
use std::fmt::Write;

use super::row::{Reach, Row, SCHEMA};
use crate::analysis::json;
use crate::analysis::motion::clock;
use crate::diag::terminal_safe;

/// Before the rows of JSON.
pub fn json_head() -> String {
    format!("{{\n  \"schema\": \"{SCHEMA}\",\n  \"programs\": [")
}

/// Before a row of JSON; `first`: none stands before it.
pub const fn json_break(first: bool) -> &'static str {
    if first { "\n    " } else { ",\n    " }
}

/// A row of JSON.
pub fn json_row(row: &Row) -> String {
    json::text(row, true)
}

/// Behind the rows of JSON.
pub const fn json_end() -> &'static str {
    "\n  ]\n}\n"
}

/// The first line of CSV.
pub const CSV_HEAD: &str = "path,hash,number,title,dialect,encoding,blocks,executed,time_s,lower_bound,path_mm_by_type,\
                            extents_working,extents_all,tools,m,g,h,subprograms,macrocycles,parameters,findings\r\n";

/// A row of CSV (RFC 4180): empty where there is no value, items of lists with blanks between.
pub fn csv(row: &Row) -> String {
    let cells = [
        row.path.clone(),
        row.hash.clone().unwrap_or_default(),
        text(row.number),
        row.title.clone().unwrap_or_default(),
        row.dialect.clone().unwrap_or_default(),
        row.encoding.clone().unwrap_or_default(),
        row.blocks.to_string(),
        text(row.executed),
        text(row.time_s),
        if row.lower_bound { "true".to_owned() } else { String::new() },
        pairs(&row.path_mm_by_type),
        reach(&row.extents.working),
        reach(&row.extents.all),
        list(&row.tools),
        list(&row.m),
        list(&row.g),
        list(&row.h),
        list(&row.subprograms),
        list(&row.macrocycles),
        list(&row.parameters),
        pairs(&row.findings),
    ];
    let mut line = String::new();
    for (at, cell) in cells.iter().enumerate() {
        if at > 0 {
            line.push(',');
        }
        if cell.contains(['"', ',', '\r', '\n']) {
            let _ = write!(line, "\"{}\"", cell.replace('"', "\"\""));
        } else {
            line.push_str(cell);
        }
    }
    line + "\r\n"
}

fn text<T: ToString>(value: Option<T>) -> String {
    value.map_or_else(String::new, |value| value.to_string())
}

fn list<T: ToString>(items: &[T]) -> String {
    items.iter().map(T::to_string).collect::<Vec<_>>().join(" ")
}

fn pairs<T: ToString>(values: &BTreeMap<String, T>) -> String {
    values.iter().map(|(key, value)| format!("{key}={}", value.to_string())).collect::<Vec<_>>().join(" ")
}

fn reach(reach: &Reach) -> String {
    reach.iter().map(|(axis, [least, greatest])| format!("{axis}={least}..{greatest}")).collect::<Vec<_>>().join(" ")
}

/// A line for people: path, number and title, blocks, time, tools, findings.
pub fn human(row: &Row) -> String {
    let mut line = row.path.clone();
    if let Some(number) = row.number {
        let _ = write!(line, "  %{number}");
    }
    if let Some(title) = &row.title {
        let _ = write!(line, " \"{title}\"");
    }
    let _ = write!(line, "  {}", row.blocks);
    if let Some(executed) = row.executed {
        let _ = write!(line, " → {executed}");
    }
    if let Some(time) = row.time_s {
        let _ = write!(line, "  {}{}", if row.lower_bound { "≥ " } else { "" }, clock(time.0));
    }
    for tool in &row.tools {
        let _ = write!(line, " T{tool}");
    }
    if !row.findings.is_empty() {
        let _ = write!(line, "  {}", pairs(&row.findings).replace('=', "×"));
    }
    terminal_safe(&line).into_owned() + "\n"
}
