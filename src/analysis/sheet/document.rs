//! The set-up sheet as tables of text, before it takes one of its forms for people.

use super::extents::Extents;
use super::reader::{Path, Sheet, ToolUse};
use super::words::Words;
use crate::analysis::motion::{Summary, Total, clock};
use crate::dict::{Address, AxisLetter, Lang};

/// A heading with a table below it.
#[derive(Clone, Debug, Eq, PartialEq)]
pub struct Section {
    /// The heading.
    pub heading: String,
    /// The titles of the columns.
    pub head: Vec<String>,
    /// Its rows; what a program does not have is a sentence.
    pub rows: Vec<Vec<String>>,
    /// In place of rows.
    pub nothing: String,
}

/// The sheet.
#[derive(Clone, Debug, Eq, PartialEq)]
pub struct Document {
    /// Its language.
    pub lang: Lang,
    /// The title.
    pub title: String,
    /// Facts, each with its name.
    pub facts: Vec<(String, String)>,
    /// Tables.
    pub sections: Vec<Section>,
}

/// Puts the sheet together; `assumed`: the machine is not configured.
pub fn document(sheet: &Sheet, summary: &Summary, assumed: bool, lang: Lang) -> Document {
    let say = |words: Words| words.text(lang);
    let head = &sheet.head;
    let number = head.number.map(|number| format!("%{number}"));
    let title = head.title.as_ref().map(|title| format!("\"{title}\""));
    let program: Vec<String> = [number, title].into_iter().flatten().collect();
    let time = summary.total.text(lang);
    let time = if assumed { format!("{time} ({})", say(Words::Assumed)) } else { time };
    Document {
        lang,
        title: say(Words::Title { name: head.name.clone() }),
        facts: vec![
            (say(Words::Program), program.join(" ")),
            (say(Words::Control), head.dialect.to_owned()),
            (say(Words::Time), time),
        ],
        sections: vec![
            size(sheet, lang),
            tools(sheet, summary, lang),
            m_functions(sheet, lang),
            parameters(sheet, lang),
            units(sheet, lang),
        ],
    }
}

fn section(heading: Words, head: &[Words], rows: Vec<Vec<String>>, lang: Lang) -> Section {
    Section {
        heading: heading.text(lang),
        head: head.iter().map(|words| words.text(lang)).collect(),
        rows,
        nothing: Words::Nothing.text(lang),
    }
}

fn size(sheet: &Sheet, lang: Lang) -> Section {
    let parts = [(Words::Working, &sheet.size.working), (Words::All, &sheet.size.all)];
    let rows = parts.into_iter().flat_map(|(what, extents)| {
        let what = what.text(lang);
        let missing = missing(extents, lang);
        extents.axes().map(move |(letter, reach)| {
            let diameter = letter == AxisLetter::X && sheet.head.diameter;
            let letter = letter.to_string();
            let letter = if diameter { Words::Diameter { letter }.text(lang) } else { letter };
            let [from, to, size] = match reach.known {
                Some((least, greatest)) => [least, greatest, greatest.minus(least)].map(|value| value.to_string()),
                None => [(); 3].map(|()| Words::Unknown.text(lang)),
            };
            let [size, missing] = match reach.known {
                _ if !reach.lacks => [size, String::new()],
                Some(_) => [Words::AtLeast { what: size }.text(lang), missing.clone()],
                None => [size, missing.clone()],
            };
            vec![what.clone(), letter, from, to, size, missing]
        })
    });
    let rows = rows.collect();
    let head = [Words::Motions, Words::Axis, Words::From, Words::To, Words::Size, Words::MissingBlocks];
    section(Words::Work, &head, rows, lang)
}

/// How many blocks are named in a cell.
const NAMED: usize = 8;

/// The blocks whose reach is not known.
fn missing(extents: &Extents, lang: Lang) -> String {
    let blocks = extents.unknown_blocks();
    let mut named: Vec<String> = blocks.iter().take(NAMED).map(ToString::to_string).collect();
    if blocks.len() > NAMED {
        named.push("…".to_owned());
    }
    Words::Missing { blocks: named.join(", ") }.text(lang)
}

fn tools(sheet: &Sheet, summary: &Summary, lang: Lang) -> Section {
    let rows = sheet.tools.iter().map(|tool| {
        vec![
            tool.tool.map_or_else(|| Words::NoTool.text(lang), |number| format!("T{number}")),
            tool.first.to_string(),
            tool.changes.to_string(),
            time(summary.of_tool(tool.tool), lang),
            path(tool.working, lang),
            path(tool.rapid, lang),
            feeds(tool, lang),
            speeds(tool, lang),
            with_unknown(tool.d.iter().map(ToString::to_string), Address::D, tool, lang).join(", "),
            reach(&tool.extents, sheet.head.diameter, lang),
        ]
    });
    let head = [
        Words::Tool,
        Words::First,
        Words::Changes,
        Words::Time,
        Words::Path,
        Words::Rapid,
        Words::Feeds,
        Words::Speeds,
        Words::D,
        Words::Reach,
    ];
    section(Words::Tools, &head, rows.collect(), lang)
}

fn time(total: Total, lang: Lang) -> String {
    let time = clock(total.time_s);
    if total.lacks_more_than_approach() { Words::AtLeast { what: time }.text(lang) } else { time }
}

fn path(path: Path, lang: Lang) -> String {
    let Some(length) = path.known() else { return Words::Unknown.text(lang) };
    let length = format!("{} mm", length.rounded());
    if path.is_lower_bound() { Words::AtLeast { what: length }.text(lang) } else { length }
}

fn feeds(tool: &ToolUse, lang: Lang) -> String {
    let feeds = tool.feeds.iter().map(|(counts, feeds)| format!("{} {}", range(*feeds), counts.shown(lang)));
    with_unknown(feeds, Address::F, tool, lang).join("; ")
}

fn speeds(tool: &ToolUse, lang: Lang) -> String {
    let speeds = tool.speeds.map(|speeds| Words::Revolutions { speeds: range(speeds) });
    let cutting = tool.cutting_speeds.map(|speeds| Words::CuttingSpeed { speeds: range(speeds) });
    let speeds = [speeds, cutting].into_iter().flatten().map(|words| words.text(lang));
    with_unknown(speeds, Address::S, tool, lang).join("; ")
}

/// The known values of F, S or D, and whether there are others.
fn with_unknown(known: impl Iterator<Item = String>, of: Address, tool: &ToolUse, lang: Lang) -> Vec<String> {
    let mut values: Vec<String> = known.collect();
    if tool.undetermined.contains(&of) {
        values.push(if values.is_empty() { Words::Unknown } else { Words::PartlyUnknown }.text(lang));
    }
    values
}

fn range<T: PartialEq + ToString>((least, greatest): (T, T)) -> String {
    if least == greatest { least.to_string() } else { format!("{} – {}", least.to_string(), greatest.to_string()) }
}

fn reach(extents: &Extents, diameter: bool, lang: Lang) -> String {
    let mut lacks = false;
    let axes = extents.axes().map(|(letter, reach)| {
        lacks |= reach.lacks;
        let sign = if diameter && letter == AxisLetter::X { "⌀" } else { "" };
        match reach.known {
            None => format!("{letter}{sign} {}", Words::Unknown.text(lang)),
            Some((least, greatest)) => {
                let what = format!("{letter}{sign} {least} … {greatest}");
                if reach.lacks { Words::AtLeast { what }.text(lang) } else { what }
            }
        }
    });
    let axes = axes.collect::<Vec<_>>().join("; ");
    if lacks { format!("{axes} ({})", missing(extents, lang)) } else { axes }
}

fn m_functions(sheet: &Sheet, lang: Lang) -> Section {
    let rows = sheet.m_functions.iter();
    let rows = rows.map(|(number, used)| vec![format!("M{number:02}"), used.count.to_string(), used.first.to_string()]);
    section(Words::MFunctions, &[Words::M, Words::Count, Words::First], rows.collect(), lang)
}

fn parameters(sheet: &Sheet, lang: Lang) -> Section {
    let rows = sheet.parameters.iter().map(|(index, used)| {
        let value = used.value.map_or_else(|| Words::Unknown.text(lang), |value| value.to_string());
        vec![format!("R{index}"), value, used.first.to_string()]
    });
    section(Words::Parameters, &[Words::Parameter, Words::Value, Words::First], rows.collect(), lang)
}

fn units(sheet: &Sheet, lang: Lang) -> Section {
    let rows = sheet.units.iter().map(|unit| {
        let l = unit.l;
        let name = if unit.macrocycle { Words::Macrocycle { l } } else { Words::Subprogram { l } };
        vec![name.text(lang), unit.runs.to_string()]
    });
    section(Words::Units, &[Words::Unit, Words::Runs], rows.collect(), lang)
}
