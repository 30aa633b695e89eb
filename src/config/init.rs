//! A commented project file, made of the table of keys: what `cnc872c init` writes. Defaults are set; what has none, or
//! depends on the machine, is an example behind `#`.

use std::fmt::{self, Write};

use super::names::{Names, group, m_group};
use super::row::{Default, Row};
use super::sections::{Form, SECTIONS, Section};
use super::{MFunctions, keys};
use crate::dict::{Bilingual, Dialect, GCode, Lang};

/// Most characters of a line of a comment.
const WIDTH: usize = 100;

const INTRODUCTION: Bilingual = Bilingual {
    en: "The machine that the programs in this folder and below are for. `cnc872c explain KEY` says more of a key. Lines \
         that begin with #, without a blank after it, are examples: delete the # to use them.",
    cs: "Stroj, pro který jsou programy v této složce a ve složkách v ní. Víc o klíči řekne „cnc872c explain KLÍČ“. Řádky, \
         které začínají # bez mezery, jsou příklady: k použití stačí # smazat.",
};

/// A project file for that control with all keys, each with a comment in `lang`.
pub fn initial(dialect: Dialect, lang: Lang) -> String {
    let mut text = String::new();
    // Writing to a `String` cannot fail.
    let _ = file(&mut text, dialect, lang);
    text
}

fn file(text: &mut String, dialect: Dialect, lang: Lang) -> fmt::Result {
    comment(text, INTRODUCTION.get(lang))?;
    for section in SECTIONS {
        // The outer table of others, without keys of its own.
        if matches!(section.form, Form::Keys([], _)) {
            continue;
        }
        text.push('\n');
        if !section.name.is_empty() {
            comment(text, &sentence(section.meaning.get(lang), section.rule))?;
        }
        match section.form {
            // A machine whose motion is not configured is not the same as one with the defaults.
            Form::Keys(rows, _) if is_motion(section) => {
                writeln!(text, "#[{}]", section.name)?;
                for row in rows {
                    comment(text, &about(row, lang))?;
                    let value = literal(row, dialect).unwrap_or_else(|| row.example.to_owned());
                    writeln!(text, "#{} = {value}", row.name)?;
                }
            }
            Form::Map(..) if is_motion(section) => {
                writeln!(text, "#[{}]\n#{}", section.name, section.example)?;
            }
            Form::Keys(rows, _) => {
                if !section.name.is_empty() {
                    writeln!(text, "[{}]", section.name)?;
                }
                write_keys(text, rows, dialect, lang)?;
            }
            Form::List(rows, _) => {
                writeln!(text, "#[[{}]]", section.name)?;
                examples(text, rows, lang)?;
            }
            Form::Tables(_, rows, _) => {
                writeln!(text, "#[{}.{}]", section.name, section.example)?;
                examples(text, rows, lang)?;
            }
            Form::Map(names, _) => map(text, section, names, dialect)?,
        }
    }
    Ok(())
}

/// Whether a table configures motion.
fn is_motion(section: &Section) -> bool {
    section.name == "motion" || section.parent().is_some_and(|parent| parent.starts_with("motion"))
}

/// Keys, set to their defaults where they have some.
fn write_keys(text: &mut String, rows: &[Row], dialect: Dialect, lang: Lang) -> fmt::Result {
    for row in rows {
        // Only the newest control has one.
        if row.name == keys::CHANNEL_CONFIG.name && !dialect.has_channel_config() {
            continue;
        }
        comment(text, &about(row, lang))?;
        match literal(row, dialect) {
            Some(value) => writeln!(text, "{} = {value}", row.name)?,
            None => writeln!(text, "#{} = {}", row.name, row.example)?,
        }
    }
    Ok(())
}

/// The keys of a table that is an example.
fn examples(text: &mut String, rows: &[Row], lang: Lang) -> fmt::Result {
    for row in rows {
        writeln!(text, "#{} = {}  # {}", row.name, row.example, plain(row.meaning.get(lang)))?;
    }
    Ok(())
}

/// A table whose keys are names of the control: groups with what holds at power-up, an example of the others.
fn map(text: &mut String, section: &Section, names: Names, dialect: Dialect) -> fmt::Result {
    writeln!(text, "[{}]", section.name)?;
    if names != Names::Groups {
        return writeln!(text, "#{}", section.example);
    }
    let functions = MFunctions::standard(dialect);
    for (name, number) in names.listed().unwrap_or_default() {
        let default = match m_group(number) {
            Some(group) => functions.defaults().get(usize::from(group)).copied().flatten(),
            None => group(number).and_then(GCode::power_up).map(GCode::number),
        };
        if let Some(default) = default {
            writeln!(text, "{name} = {default}")?;
        }
    }
    Ok(())
}

/// The default as TOML, where there is one.
pub(super) fn literal(row: &Row, dialect: Dialect) -> Option<String> {
    match row.default {
        Default::Flag(flag) => Some(flag.to_string()),
        Default::Whole(number) => Some(number.to_string()),
        Default::Number(number) => Some(number.to_string()),
        Default::Text("cnc872") => Some(format!("\"{}\"", dialect.name())),
        Default::Text(text) => Some(format!("\"{text}\"")),
        Default::Texts(texts) => {
            let texts: Vec<_> = texts.iter().map(|text| format!("\"{text}\"")).collect();
            Some(format!("[{}]", texts.join(", ")))
        }
        Default::ByDialect(value) => Some(value(dialect)),
        Default::Nothing | Default::Required | Default::Words(_) => None,
    }
}

/// What a key sets and takes.
fn about(row: &Row, lang: Lang) -> String {
    let takes = row.takes.shown(lang);
    sentence(&format!("{}: {takes}", row.meaning.get(lang)), row.rule)
}

fn sentence(meaning: &str, rule: &str) -> String {
    let mut characters = meaning.chars();
    let start: String = characters.next().into_iter().flat_map(char::to_uppercase).collect();
    format!("{start}{} ({rule}).", characters.as_str())
}

/// Without the marks of Markdown.
fn plain(text: &str) -> String {
    text.replace('`', "")
}

/// A comment, in lines that are not too long.
fn comment(text: &mut String, words: &str) -> fmt::Result {
    let mut line = String::from("#");
    for word in plain(words).split_whitespace() {
        if line.chars().count() + 1 + word.chars().count() > WIDTH {
            writeln!(text, "{line}")?;
            line = String::from("#");
        }
        line.push(' ');
        line.push_str(word);
    }
    writeln!(text, "{line}")
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::config::tests::Run;
    use crate::config::{Machine, Settings};

    /// The file sets what holds without it.
    #[test]
    fn sets_the_defaults_of_the_dialect() {
        for dialect in Dialect::ALL {
            for lang in [Lang::En, Lang::Cs] {
                let text = initial(dialect, lang);
                assert_eq!(text.contains("channel-config"), dialect.has_channel_config());
                let run = Run::plain(&text);
                assert!(run.findings.is_empty(), "{text}{:?}", run.findings);
                let settings = run.settings();
                assert_eq!(format!("{settings:?}"), format!("{:?}", Settings::new(dialect)));
                assert_eq!(settings.machine.limits, Machine::new(dialect).limits);
                assert!(text.lines().all(|line| line.chars().count() <= 120), "{text}");
            }
        }
    }
}
