//! The keys of the project file as topics: their pages, made of the table of keys.

use std::fmt::Write;

use super::reference::default;
use super::row::Row;
use super::sections::{Form, SECTIONS, Section};
use crate::dict::{Bilingual, Dialect, Lang};

/// The key that only some controls have.
const CHANNEL_CONFIG: &str = "channel-config";

/// A table of the project file, or a key in it.
#[derive(Clone, Copy, Debug)]
pub struct Key {
    section: &'static Section,
    row: Option<&'static Row>,
}

impl PartialEq for Key {
    fn eq(&self, other: &Self) -> bool {
        self.path() == other.path()
    }
}

impl Eq for Key {}

impl Key {
    /// Every key and table, in the order of the reference page.
    pub fn all() -> impl Iterator<Item = Self> {
        SECTIONS.iter().flat_map(|section| {
            let table = (!section.name.is_empty()).then_some(Self { section, row: None });
            table.into_iter().chain(section.form.rows().iter().map(move |row| Self { section, row: Some(row) }))
        })
    }

    /// The key or table of that name: `limits.feed`, `dialect`, `limits` and `[limits]`. Case does not matter, `_` is
    /// as good as `-`.
    pub fn find(name: &str) -> Option<Self> {
        let plain = name.trim().trim_matches(['[', ']']).to_ascii_lowercase().replace('_', "-");
        Self::all().find(|key| key.path() == plain).or_else(|| Self::by_name(&plain))
    }

    /// A key in a table by name, `corrections.7.radius`, or the table of a name of the control, `parameters.r10`.
    fn by_name(path: &str) -> Option<Self> {
        let (table, name) = path.rsplit_once('.')?;
        let upper = name.to_ascii_uppercase();
        let takes = |section: &Section| match section.form {
            Form::Map(names) | Form::Tables(names, _) => [name, &upper].iter().any(|name| names.number(name).is_some()),
            Form::Keys(_) | Form::List(_) => false,
        };
        let is_named = |key: &Self| key.is_table() && key.section.name == table && takes(key.section);
        Self::of(table, name).or_else(|| Self::all().find(is_named))
    }

    /// Its name with that of its table: `limits.feed`.
    pub fn path(&self) -> String {
        match (self.row, self.section.name) {
            (None, table) => table.to_owned(),
            (Some(row), "") => row.name.to_owned(),
            (Some(row), table) => format!("{table}.{}", row.name),
        }
    }

    /// The key of that name in a table, which a line of the project file names: `feed` in `limits`, `radius` in
    /// `corrections.7`.
    pub fn of(table: &str, name: &str) -> Option<Self> {
        Self::all().find(|key| key.is_in(table) && key.name() == name)
    }

    /// The table that a line of the project file begins: `limits`, `corrections.7`, `corrections`.
    pub fn of_table(table: &str) -> Option<Self> {
        Self::all().find(|key| key.is_table() && (key.holds(table) || key.section.name == table))
    }

    /// Whether it is a table.
    pub const fn is_table(&self) -> bool {
        self.row.is_none()
    }

    /// Whether it is a key of that table.
    pub fn is_in(&self, table: &str) -> bool {
        self.row.is_some() && self.holds(table)
    }

    fn holds(&self, table: &str) -> bool {
        let by_name = matches!(self.section.form, Form::Tables(..));
        if by_name {
            table.rsplit_once('.').is_some_and(|(outer, _)| outer == self.section.name)
        } else {
            table == self.section.name
        }
    }

    /// Its name in its table.
    pub fn name(&self) -> &'static str {
        self.row.map_or(self.section.name, |row| row.name)
    }

    /// Whether a machine with this control can have it.
    pub fn is_for(&self, dialect: Dialect) -> bool {
        self.path() != CHANNEL_CONFIG || dialect.has_channel_config()
    }

    /// The line of the project file that sets it to its default on that control, or to an example; of a table the line
    /// that begins it.
    pub fn line(&self, dialect: Dialect) -> String {
        match (self.row, self.section.form) {
            (Some(row), _) => row.line(dialect),
            (None, Form::List(..)) => format!("[[{}]]", self.section.name),
            (None, Form::Tables(..)) => format!("[{}.{}]", self.section.name, self.section.example),
            (None, Form::Keys(..) | Form::Map(..)) => format!("[{}]", self.section.name),
        }
    }

    /// The values that it takes, as TOML, where there are few.
    pub fn choices(&self) -> Vec<String> {
        self.row.map(|row| row.takes.choices()).unwrap_or_default()
    }

    /// Its effect.
    pub fn meaning(&self, lang: Lang) -> &'static str {
        self.row.map_or(self.section.meaning, |row| row.meaning).get(lang)
    }

    /// Its page, Markdown; the example is for that control.
    pub fn page(&self, dialect: Dialect, lang: Lang) -> String {
        let mut page = format!("# {}: {}\n\n", self.path(), self.meaning(lang));
        let pick = |en, cs| Bilingual { en, cs }.get(lang);
        let mut line = |words: &str, value: &str| {
            // Writing to a `String` cannot fail.
            let _ = writeln!(page, "- {words}: {value}");
        };
        line(pick("In", "Kde"), &format!("`cnc872c.toml`{}", self.place(lang)));
        if let Some(row) = self.row {
            line(pick("Takes", "Hodnota"), &row.takes.shown(lang));
            line(pick("Default", "Výchozí"), &default(row.default, lang));
        } else if let Form::Map(names) | Form::Tables(names, _) = self.section.form {
            let shown = names.shown(lang);
            if !shown.is_empty() {
                line(pick("Keys", "Klíče"), &shown);
            }
            if let Some((_, number)) = names.listed().and_then(|listed| listed.into_iter().next())
                && !shown.is_empty()
            {
                line(pick("Values", "Hodnoty"), &names.takes(number).shown(lang));
            }
        }
        for row in self.section.form.rows().iter().filter(|_| self.row.is_none()) {
            line(&format!("`{}`", row.name), row.meaning.get(lang));
        }
        if let Some(option) = self.row.map_or(self.section.option, |row| row.option) {
            let options: Vec<_> = option.split(", ").map(|option| format!("`{option}`")).collect();
            line(pick("On the command line", "Na příkazovém řádku"), &options.join(", "));
        }
        line(pick("Rule", "Pravidlo"), self.row.map_or(self.section.rule, |row| row.rule));
        let _ = write!(page, "\n## {}\n\n```toml\n{}```\n", pick("Example", "Příklad"), self.example(dialect));
        page
    }

    fn place(&self, lang: Lang) -> String {
        match (self.section.name, self.section.form) {
            ("", _) => Bilingual { en: ", before all tables", cs: ", před všemi tabulkami" }.get(lang).to_owned(),
            (table, Form::List(..)) => format!(", `[[{table}]]`"),
            (table, Form::Tables(..)) => format!(", `[{table}.{}]`", self.section.example),
            (table, Form::Keys(..) | Form::Map(..)) => format!(", `[{table}]`"),
        }
    }

    fn example(&self, dialect: Dialect) -> String {
        let value = |row: &Row| row.line(dialect) + "\n";
        let rows = || match self.row {
            Some(row) => value(row),
            None => self.section.form.rows().iter().map(value).collect(),
        };
        match (self.section.name, self.section.form) {
            ("", _) => rows(),
            (table, Form::Keys(..)) => format!("[{table}]\n{}", rows()),
            (table, Form::List(..)) => {
                format!("[[{table}]]\n{}", self.section.form.rows().iter().map(value).collect::<String>())
            }
            (table, Form::Tables(..)) => format!("[{table}.{}]\n{}", self.section.example, rows()),
            (table, Form::Map(..)) => format!("[{table}]\n{}\n", self.section.example),
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::config::tests::Run;

    #[test]
    fn found_by_name() {
        let path = |name: &str| Key::find(name).map(|key| key.path());
        assert_eq!(path("LIMITS.feed").as_deref(), Some("limits.feed"));
        assert_eq!(path("block_skip").as_deref(), Some("block-skip"));
        assert_eq!(path("[[axes]]").as_deref(), Some("axes"));
        // As findings name them.
        for (name, key) in [
            ("parameters.R10", "parameters"),
            ("power-up.G0", "power-up"),
            ("cycles.G81", "cycles"),
            ("machine-constants.R56", "machine-constants"),
            ("operations.01", "operations"),
            ("corrections.7", "corrections"),
            ("corrections.7.radius", "corrections.radius"),
            ("motion.times.M06", "motion.times"),
            ("machine-macrocycles.L9001", "machine-macrocycles"),
            ("lints.W0214", "lints"),
            ("start.X", "start"),
        ] {
            assert_eq!(path(name).as_deref(), Some(key), "{name}");
        }
        assert_eq!(path("parameters.R96"), None);
        // A bare name is a word to search for.
        assert_eq!(path("radius"), None);
        assert_eq!(path(""), None);
    }

    /// The examples of the pages are read without a finding.
    #[test]
    fn every_key_has_a_page() {
        for key in Key::all() {
            let example = key.example(Dialect::default());
            let run = Run::plain(&example);
            assert!(run.findings.is_empty(), "{example}{:?}", run.findings);
            for lang in [Lang::En, Lang::Cs] {
                let page = key.page(Dialect::default(), lang);
                assert!(page.starts_with(&format!("# {}: ", key.path())) && page.contains("```toml\n"), "{page}");
            }
        }
        let page = Key::find("g97").unwrap().page(Dialect::Cnc8x9, Lang::Cs);
        assert!(page.ends_with("\ng97 = \"per-revolution\"\n```\n"), "{page}");
        assert!(page.contains("cnc8x9: `\"per-revolution\"`, cnc872: `\"per-minute\"`"), "{page}");
    }
}
