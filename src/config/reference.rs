//! The reference page of the project file, made of the table of keys.

use std::fmt::Write;

use super::MFunctions;
use super::names::{Names, group, m_group};
use super::row::{Default, Row};
use super::sections::{Form, SECTIONS, Section};
use crate::dict::{Bilingual, Dialect, GCode, Lang};

const INTRODUCTION: Bilingual = Bilingual {
    en: "\
The project file says which machine the programs are for. It is TOML, found in the program's folder or the nearest
folder above it; `--config FILE` names one. Paths in it are relative to its folder. Every key may be left out. Options of
the command line take precedence, value by value.

A key that is not known is a warning (W0705); a value of the wrong type or outside its range is an error at its place
(E0702), and then no program is read. Numbers are taken by their digits, without binary fractions; one that is finer
than 0.001 is rounded, halves away from zero, with a warning (W0303). `cnc872c init` writes a commented file.
",
    cs: "\
Projektový soubor říká, pro jaký stroj programy jsou. Je to soubor TOML ve složce programu nebo v nejbližší složce nad
ní; jiný určí `--config SOUBOR`. Cesty v něm se počítají od jeho složky. Každý klíč lze vynechat. Přednost má to, co je
na příkazovém řádku, hodnotu po hodnotě.

Neznámý klíč je varování (W0705); hodnota nesprávného typu nebo mimo rozsah je chyba na svém místě (E0702) a žádný
program se pak nečte. Čísla se berou podle číslic, bez dvojkových zlomků; číslo s více než třemi desetinnými místy se
zaokrouhlí, poloviny směrem od nuly, a dá varování (W0303). Soubor s komentáři zapíše `cnc872c init`.
",
};

/// The reference page of `cnc872c.toml` in `lang`, Markdown: every key with its type, range, default and meaning.
pub fn reference(lang: Lang) -> String {
    let mut page = format!("# cnc872c.toml\n\n{}", INTRODUCTION.get(lang));
    for section in SECTIONS {
        // Writing to a `String` cannot fail.
        let _ = self::section(&mut page, section, lang);
    }
    page
}

fn section(page: &mut String, section: &Section, lang: Lang) -> std::fmt::Result {
    let title = match section.form {
        Form::Keys(..) if section.name.is_empty() => {
            Bilingual { en: "Before all tables", cs: "Před všemi tabulkami" }.get(lang).to_owned()
        }
        Form::Keys(..) | Form::Map(..) => format!("`[{}]`", section.name),
        Form::Tables(..) => format!("`[{}.…]`", section.name),
        Form::List(..) => format!("`[[{}]]`", section.name),
    };
    let mut meaning = section.meaning.get(lang).chars();
    let meaning: String = meaning.next().into_iter().flat_map(char::to_uppercase).chain(meaning).collect();
    writeln!(page, "\n## {title}\n\n{meaning}. ({})\n", section.rule)?;
    if let Some(option) = section.option {
        let words = Bilingual { en: "On the command line:", cs: "Na příkazovém řádku:" }.get(lang);
        let options = option.split(", ").map(|option| format!("`{option}`")).collect::<Vec<_>>().join(", ");
        writeln!(page, "{words} {options}.\n")?;
    }
    match section.form {
        Form::Keys(rows) | Form::List(rows) => keys(page, rows, lang),
        Form::Map(names) => map(page, names, lang),
        Form::Tables(names, rows) => {
            let words = Bilingual { en: "Names:", cs: "Jména:" }.get(lang);
            writeln!(page, "{words} {}.\n", names.shown(lang))?;
            keys(page, rows, lang)
        }
    }
}

fn keys(page: &mut String, rows: &[Row], lang: Lang) -> std::fmt::Result {
    let head = Bilingual {
        en: "| key | takes | default | meaning | rule |",
        cs: "| klíč | hodnota | výchozí | význam | pravidlo |",
    };
    writeln!(page, "{}\n|---|---|---|---|---|", head.get(lang))?;
    for row in rows {
        let (takes, default) = (row.takes.shown(lang), default(row.default, lang));
        let option = row.option.map(|option| format!(" (`{option}`)")).unwrap_or_default();
        let (name, meaning, rule) = (row.name, row.meaning.get(lang), row.rule);
        writeln!(page, "| `{name}`{option} | {takes} | {default} | {meaning} | {rule} |")?;
    }
    Ok(())
}

pub(super) fn default(default: Default, lang: Lang) -> String {
    match default {
        Default::ByDialect(value) => {
            let values = Dialect::ALL.map(|dialect| format!("{}: `{}`", dialect.name(), value(dialect)));
            values.join(", ")
        }
        Default::Nothing => "–".to_owned(),
        Default::Required => Bilingual { en: "must be there", cs: "musí být uvedeno" }.get(lang).to_owned(),
        Default::Is(value) => format!("`{value}`"),
        Default::Words(words) => words.get(lang).to_owned(),
    }
}

fn map(page: &mut String, names: Names, lang: Lang) -> std::fmt::Result {
    let head = Bilingual { en: "| key | takes |", cs: "| klíč | hodnota |" };
    writeln!(page, "{}\n|---|---|", head.get(lang))?;
    if names == Names::Groups {
        for (name, number) in names.listed().unwrap_or_default() {
            let default = match m_group(number) {
                Some(group) => {
                    let defaults = MFunctions::standard(Dialect::default());
                    defaults.defaults().get(usize::from(group)).copied().flatten().map(|m| m.to_string())
                }
                None => group(number).and_then(GCode::power_up).map(|code| code.number().to_string()),
            };
            let word = Bilingual { en: "default", cs: "výchozí" }.get(lang);
            let takes = names.takes(number).shown(lang);
            match default {
                Some(default) => writeln!(page, "| `{name}` | {takes}; {word} `{default}` |")?,
                None => writeln!(page, "| `{name}` | {takes} |")?,
            }
        }
        return Ok(());
    }
    let number = names.listed().and_then(|listed| listed.first().map(|(_, number)| *number)).unwrap_or(0);
    writeln!(page, "| {} | {} |", names.shown(lang), names.takes(number).shown(lang))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn every_key_in_both_languages() {
        let (en, cs) = (reference(Lang::En), reference(Lang::Cs));
        for section in SECTIONS {
            for row in section.form.rows() {
                let key = format!("| `{}`", row.name);
                assert!(en.contains(&key) && cs.contains(&key), "{key}");
                assert!(en.contains(row.meaning.en) && cs.contains(row.meaning.cs), "{key}");
            }
        }
        assert!(en.contains("| `nesting` | whole number 1–1000 | `32` | most calls open at once | FLW-2 |"));
        assert!(cs.contains("| `G0` | `0`, `1`, `2`, `3`, `33`; výchozí `0` |"), "{cs}");
        assert!(cs.contains("| `R0` až `R95` | ±69999.999, nebo celé číslo do ±99999999 |"), "{cs}");
        assert!(cs.contains("## `[[gears]]`\n\nRozsahy otáček vřetena. (MFN-9)"), "{cs}");
    }

    /// Cells hold no character that would end them.
    #[test]
    fn tables_are_whole() {
        for line in reference(Lang::Cs).lines().chain(reference(Lang::En).lines()) {
            if line.starts_with('|') {
                let cells = line.matches('|').count();
                assert!(cells == 3 || cells == 6, "{line}");
            }
        }
    }
}
