//! The set-up sheet as plain text, Markdown and HTML.

use super::document::{Document, Section};
use crate::diag::terminal_safe;

/// Plain text: columns below one another.
pub fn text(document: &Document) -> String {
    let mut lines = vec![document.title.clone(), String::new()];
    let widest = document.facts.iter().map(|(name, _)| name.chars().count()).max().unwrap_or(0);
    for (name, value) in &document.facts {
        lines.push(format!("{}  {value}", padded(name, widest)));
    }
    for section in &document.sections {
        lines.push(String::new());
        lines.push(section.heading.clone());
        if section.rows.is_empty() {
            lines.push(format!("  {}", section.nothing));
            continue;
        }
        let rows = || std::iter::once(&section.head).chain(&section.rows);
        let width = |column: usize| rows().filter_map(|row| row.get(column)).map(|cell| cell.chars().count()).max();
        let widths: Vec<usize> = (0..section.head.len()).map(|column| width(column).unwrap_or(0)).collect();
        for row in rows() {
            let cells = row.iter().zip(&widths).map(|(cell, width)| padded(cell, *width));
            lines.push(format!("  {}", cells.collect::<Vec<_>>().join("  ")));
        }
    }
    lines.iter().map(|line| format!("{}\n", terminal_safe(line.trim_end()))).collect()
}

fn padded(text: &str, width: usize) -> String {
    format!("{text}{:pad$}", "", pad = width.saturating_sub(text.chars().count()))
}

/// Markdown with tables.
pub fn markdown(document: &Document) -> String {
    let mut page = format!("# {}\n\n", marked(&document.title));
    for (name, value) in &document.facts {
        page.push_str(&format!("- {}: {}\n", marked(name), marked(value)));
    }
    for section in &document.sections {
        page.push_str(&format!("\n## {}\n\n", marked(&section.heading)));
        if section.rows.is_empty() {
            page.push_str(&format!("{}\n", marked(&section.nothing)));
            continue;
        }
        page.push_str(&row(&section.head));
        page.push_str(&format!("|{}\n", "---|".repeat(section.head.len())));
        section.rows.iter().for_each(|cells| page.push_str(&row(cells)));
    }
    page
}

fn row(cells: &[String]) -> String {
    format!("| {} |\n", cells.iter().map(|cell| marked(cell)).collect::<Vec<_>>().join(" | "))
}

/// Text that Markdown takes for nothing else.
fn marked(text: &str) -> String {
    let mut out = String::new();
    for character in terminal_safe(text).chars() {
        if matches!(character, '\\' | '`' | '*' | '_' | '[' | ']' | '<' | '>' | '|' | '#' | '&') {
            out.push('\\');
        }
        out.push(character);
    }
    out
}

const STYLE: &str = "body{font:15px/1.4 system-ui,sans-serif;margin:2em;color:#1a1a1a;background:#fff}h1{font-size:1.5em}\
                     h2{font-size:1.15em;margin-top:1.6em}table{border-collapse:collapse}th,td{border:1px solid #999;\
                     padding:.25em .6em;text-align:left;vertical-align:top}th{background:#eee}@media print{body{margin:0}}";

/// One page of HTML without scripts.
pub fn html(document: &Document) -> String {
    let lang = document.lang.code();
    let title = escaped(&document.title);
    let mut page = format!(
        "<!DOCTYPE html>\n<html lang=\"{lang}\">\n<head>\n<meta charset=\"utf-8\">\n<title>{title}</title>\n\
         <style>{STYLE}</style>\n</head>\n<body>\n<h1>{title}</h1>\n<table>\n"
    );
    for (name, value) in &document.facts {
        page.push_str(&format!("<tr><th scope=\"row\">{}</th><td>{}</td></tr>\n", escaped(name), escaped(value)));
    }
    page.push_str("</table>\n");
    document.sections.iter().for_each(|section| page.push_str(&table(section)));
    page.push_str("</body>\n</html>\n");
    page
}

fn table(section: &Section) -> String {
    let heading = format!("<h2>{}</h2>\n", escaped(&section.heading));
    if section.rows.is_empty() {
        return format!("{heading}<p>{}</p>\n", escaped(&section.nothing));
    }
    let cells = |cells: &[String], tag: &str| {
        let cells = cells.iter().map(|cell| format!("<{tag}>{}</{tag}>", escaped(cell)));
        format!("<tr>{}</tr>\n", cells.collect::<String>())
    };
    let rows: String = section.rows.iter().map(|row| cells(row, "td")).collect();
    format!("{heading}<table>\n{}{rows}</table>\n", cells(&section.head, "th"))
}

fn escaped(text: &str) -> String {
    let text = terminal_safe(text);
    text.replace('&', "&amp;").replace('<', "&lt;").replace('>', "&gt;").replace('"', "&quot;")
}
