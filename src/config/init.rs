//! A commented project file, made of the table of keys: what `cnc872c init` writes. In force is what was asked for or
//! found; the rest is commented out with `#`, so that another control gets its own values.

use std::fmt::Write;

use super::row::Row;
use super::sections::{Form, SECTIONS, Section};
use crate::dict::{Bilingual, Dialect, Lang};

/// Most characters of a line.
const WIDTH: usize = 110;

const INTRODUCTION: Bilingual = Bilingual {
    en: "\
# The machine that the programs in this folder and below it are for. Lines with # before them are not in force: they
# show what holds without them, or an example. To use one, delete its # and that of the [table] above it.
# More about a key: cnc872c explain KEY.
",
    cs: "\
# Stroj, pro který jsou programy v této složce a pod ní. Řádky s # na začátku neplatí: ukazují, co platí bez nich,
# nebo příklad. K použití stačí smazat # před řádkem a před [tabulkou] nad ním.
# Víc o klíči řekne „cnc872c explain KLÍČ“.
",
};

/// Why the folders with macrocycles are not in force.
const AMBIGUOUS: Bilingual = Bilingual {
    en: "\
# Left out, for programs would call macrocycles of another folder: a number is there twice, or some programs have theirs
# beside them. As it is, each program finds those in its own folder.
",
    cs: "\
# Vynecháno, programy by volaly makrocykly z jiné složky: některé číslo je tu dvakrát, nebo mají některé programy své
# makrocykly vedle sebe. Takto každý program najde ty ve své složce.
",
};

/// Why the ChannelConfig is not in force.
const DOUBTFUL: Bilingual = Bilingual {
    en: "# Left out: there are several, or this one has errors.\n",
    cs: "# Vynecháno: je jich tu víc, nebo má tento chyby.\n",
};

/// The files that a project file may name, in its folder.
#[derive(Clone, Debug, Default)]
pub struct Surroundings {
    /// Folders with macrocycles, relative, with `/`; none when only the folder of the programs has them.
    pub macrocycles: Vec<String>,
    /// Whether programs may find another macrocycle than theirs when all these folders are searched; the key then stays
    /// a comment.
    pub is_ambiguous: bool,
    /// The ChannelConfig, relative; of several one.
    pub channel_config: Option<String>,
    /// Whether there are several, or this one has errors; the key then stays a comment.
    pub channel_is_doubtful: bool,
}

/// A project file for that control, its comments in `lang`.
pub fn initial(dialect: Dialect, found: &Surroundings, lang: Lang) -> String {
    let mut text = INTRODUCTION.get(lang).to_owned();
    for section in SECTIONS {
        match section.form {
            Form::Keys(rows) if section.name.is_empty() => root(&mut text, rows, (dialect, found), lang),
            // Lists stand before the tables, each in one line.
            Form::List(..) => {}
            // The outer table of others, without keys; and sets that are like the first.
            Form::Keys([]) => {}
            Form::Keys(..) if is_like_the_first(section) => {}
            Form::Keys(rows) => {
                head(&mut text, section.name, section, lang);
                for row in rows {
                    key(&mut text, row, dialect, lang);
                }
            }
            Form::Tables(_, rows) => {
                head(&mut text, &format!("{}.{}", section.name, section.example), section, lang);
                for row in rows {
                    key(&mut text, row, dialect, lang);
                }
            }
            Form::Map(..) => {
                head(&mut text, section.name, section, lang);
                // Writing to a `String` cannot fail.
                let _ = writeln!(text, "#{}", section.example);
            }
        }
    }
    text
}

/// Whether it is one of the sets of motion behind the first.
fn is_like_the_first(section: &Section) -> bool {
    matches!(section.name, "motion.sets.2" | "motion.sets.3" | "motion.sets.4")
}

/// What stands before all tables.
fn root(text: &mut String, rows: &[Row], (dialect, found): (Dialect, &Surroundings), lang: Lang) {
    text.push('\n');
    for row in rows {
        let quoted = |name: &String| toml_edit::Value::from(name.as_str()).to_string();
        if row.name == "dialect" {
            line(text, &format!("{} = \"{}\"", row.name, dialect.name()), row.meaning, lang);
        } else if row.name == "channel-config" {
            match &found.channel_config {
                _ if !dialect.has_channel_config() => {}
                Some(name) => {
                    let doubtful = found.channel_is_doubtful;
                    text.push_str(if doubtful { DOUBTFUL.get(lang) } else { "" });
                    let comment = if doubtful { "#" } else { "" };
                    line(text, &format!("{comment}{} = {}", row.name, quoted(name)), row.meaning, lang);
                }
                None => key(text, row, dialect, lang),
            }
        } else if row.name == "macrocycles" {
            let folders: Vec<String> = found.macrocycles.iter().map(quoted).collect();
            let value = if folders.is_empty() {
                "#macrocycles = [\".\"]".to_owned()
            } else {
                let comment = if found.is_ambiguous { "#" } else { "" };
                format!("{comment}macrocycles = [{}]", folders.join(", "))
            };
            if !folders.is_empty() && found.is_ambiguous {
                text.push_str(AMBIGUOUS.get(lang));
            }
            line(text, &value, row.meaning, lang);
        } else {
            key(text, row, dialect, lang);
        }
    }
    for section in SECTIONS {
        if let Form::List(rows) = section.form {
            let values: Vec<String> = rows.iter().map(|row| row.line(dialect)).collect();
            line(text, &format!("#{} = [{{ {} }}]", section.name, values.join(", ")), section.meaning, lang);
        }
    }
}

/// The head of a table.
fn head(text: &mut String, name: &str, section: &Section, lang: Lang) {
    text.push('\n');
    line(text, &format!("#[{name}]"), section.meaning, lang);
}

/// A key with its default, or an example.
fn key(text: &mut String, row: &Row, dialect: Dialect, lang: Lang) {
    line(text, &format!("#{}", row.line(dialect)), row.meaning, lang);
}

/// A line, with its meaning behind it; where there is no room for all of it, up to the first `;` or `:`.
fn line(text: &mut String, code: &str, meaning: Bilingual, lang: Lang) {
    let meaning = meaning.get(lang).replace('`', "");
    let room = WIDTH.saturating_sub(code.chars().count().max(36) + 4);
    let parts = [Some(meaning.as_str()), meaning.split(';').next(), meaning.split(':').next()];
    let shown = parts.into_iter().flatten().find(|part| part.chars().count() <= room);
    // Writing to a `String` cannot fail.
    let _ = match shown {
        Some(shown) => writeln!(text, "{code:36}  # {shown}"),
        None => writeln!(text, "{code}"),
    };
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::config::Settings;
    use crate::config::tests::Run;

    fn all() -> impl Iterator<Item = (Dialect, Lang, String)> {
        let pairs = Dialect::ALL.into_iter().flat_map(|dialect| [Lang::En, Lang::Cs].map(|lang| (dialect, lang)));
        pairs.map(|(dialect, lang)| (dialect, lang, initial(dialect, &Surroundings::default(), lang)))
    }

    /// project-file.md: in force is the dialect, so that editing it gives another machine whole.
    #[test]
    fn sets_nothing_but_the_dialect() {
        for (dialect, _, text) in all() {
            let run = Run::plain(&text);
            assert!(run.findings.is_empty(), "{text}{:?}", run.findings);
            assert_eq!(format!("{:?}", run.settings()), format!("{:?}", Settings::new(dialect)));
            assert!(text.lines().count() <= 120, "{}", text.lines().count());
            assert!(text.lines().all(|line| line.chars().count() <= 120), "{text}");
            for rule in ["MFN-", "ADR-", "§"] {
                assert!(!text.contains(rule), "{text}");
            }
        }
    }

    /// Each key of `[motion]`, `[format]` and `[restart]` has its meaning beside it: a clause that stands alone, with
    /// none of its values cut off.
    #[test]
    fn keys_say_what_they_are() {
        let mut looked_at = 0;
        for (_, _, text) in all() {
            let mut table = "";
            for line in text.lines() {
                if line.starts_with("#[") {
                    table = line;
                } else if ["#[motion]", "#[format]", "#[restart]"].iter().any(|name| table.starts_with(name))
                    && line.contains(" = ")
                {
                    looked_at += 1;
                    let (_, meaning) = line.split_once("  # ").unwrap_or_else(|| panic!("{line} says nothing"));
                    assert!(meaning.split(' ').count() > 1 || meaning.len() > 12, "{line}");
                    assert!(!meaning.contains("\":"), "{line}: a value without the others");
                }
            }
        }
        assert!(looked_at > 80, "{looked_at}");
    }

    /// Each key, without its `#` and that of its table, is in a valid file.
    #[test]
    fn every_line_can_be_used() {
        for (dialect, _, text) in all() {
            let lines: Vec<&str> = text.lines().collect();
            let is_code = |line: &str| line.starts_with('#') && !line.starts_with("# ");
            let mut table = None;
            // The ChannelConfig of the example is not there.
            let is_code = |line: &str| is_code(line) && !line.starts_with("#channel-config");
            for (at, line) in lines.iter().enumerate().filter(|(_, line)| is_code(line)) {
                if line.starts_with("#[") {
                    table = Some(at);
                    continue;
                }
                let used = |other: usize| other == at || Some(other) == table;
                let uncommented = lines.iter().enumerate().map(|(other, line)| match line.strip_prefix('#') {
                    Some(code) if used(other) => format!("{code}\n"),
                    _ => format!("{line}\n"),
                });
                let run = Run::plain(&uncommented.collect::<String>());
                assert!(run.findings.is_empty(), "{dialect:?} {line}: {:?}", run.findings);
            }
        }
    }

    #[test]
    fn what_is_there_is_named() {
        let found = Surroundings {
            macrocycles: vec!["macros".to_owned()],
            is_ambiguous: false,
            channel_config: Some("Channel.xml".to_owned()),
            channel_is_doubtful: false,
        };
        let text = initial(Dialect::Cnc872, &found, Lang::En);
        assert!(text.contains("\nmacrocycles = [\"macros\"]") && text.contains("\nchannel-config = \"Channel.xml\""));
        assert!(!initial(Dialect::Cnc8x9, &found, Lang::En).contains("channel-config"));
        let text = initial(Dialect::Cnc872, &Surroundings::default(), Lang::En);
        assert!(text.contains("\n#channel-config = \"Channel.xml\"") && text.contains(", output = 1 }]"), "{text}");
    }
}
