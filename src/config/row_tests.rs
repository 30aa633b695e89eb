//! Every row of the table of keys is read, and checked by what it says: these tests know no key by name.

use super::names::Names;
use super::row::{Default, Row};
use super::schema_tests::fits;
use super::sections::{Form, ROOT, SECTIONS, Section, options};
use super::takes::{List, Takes, lasting};
use super::tests::Run;
use crate::diag::Code;
use crate::dict::Dialect;

/// Values that the row takes, as TOML, each of which must lead to other settings.
fn taken(takes: Takes) -> Vec<String> {
    let quoted = |text: &str| format!("'{text}'");
    match takes {
        Takes::Flag(_) => vec!["true".to_owned(), "false".to_owned()],
        Takes::Path(_) => vec![quoted("Channel.xml"), quoted("Other.xml")],
        Takes::Texts(List::Paths, _) => vec!["['a']".to_owned(), "['own', 'a']".to_owned()],
        Takes::Texts(List::Extensions, _) => vec!["['nc']".to_owned(), "['H', 'tap']".to_owned()],
        Takes::Texts(List::Letters, _) => vec!["['Z']".to_owned(), "[]".to_owned()],
        Takes::OneOf(choices, _) => choices().into_iter().map(quoted).collect(),
        Takes::Whole { min, max, .. } => {
            let highest = max.unwrap_or(min + 1_000_000);
            vec![min.to_string(), (min + 1).to_string(), highest.to_string()]
        }
        Takes::Speed { .. } => vec!["0".to_owned(), "1".to_owned(), "9999".to_owned()],
        Takes::Number { min, max, .. } => vec![min.to_string(), "1.5".to_owned(), max.to_string()],
        Takes::Rapid { min, max, .. } => {
            vec![min.to_string(), "1.5".to_owned(), max.to_string(), "{ X = 5000 }".to_owned()]
        }
        Takes::ParameterValue(_) => vec!["-1.5".to_owned(), "99999999".to_owned()],
        Takes::GFunction(group) => lasting(group).map(|code| code.number().to_string()).collect(),
        // Those of the group are found by trying.
        Takes::MFunction => (0..=100).map(|number| number.to_string()).collect(),
        Takes::Constant(_) => vec!["'91'".to_owned(), "92".to_owned(), "-9.5".to_owned()],
    }
}

/// A value for a key that must be there.
fn needed(row: &Row) -> String {
    let values = taken(row.takes);
    // The upper end of a gear is not below its lower one.
    let value = if row.name == "max" { values.last() } else { values.first() };
    value.unwrap().clone()
}

/// The text that sets one key of a table, with what else the table must have.
fn with_key(section: &Section, row: &Row, value: &str) -> String {
    let others = section.form.rows().iter().filter(|other| other.name != row.name);
    let others = others.filter(|other| matches!(other.default, Default::Required));
    let others: String = others.map(|other| format!("{} = {}\n", other.name, needed(other))).collect();
    let head = match section.form {
        Form::Keys(..) if section.parent().is_none() => String::new(),
        Form::Keys(..) => format!("[{}]\n", section.name),
        Form::List(..) => format!("[[{}]]\n", section.name),
        Form::Tables(names, ..) => format!("[{}.{}]\n", section.name, name_of(names)),
        Form::Map(..) => unreachable!("it has no rows"),
    };
    // The criteria are computed with the cycle.
    let needs_cycle = section.name == "motion" && ["accuracy-um", "overload-mm-s2"].contains(&row.name);
    let cycle = if needs_cycle { "cycle-ms = 2\n" } else { "" };
    format!("{head}{others}{cycle}{} = {value}\n", row.name)
}

/// One of the names.
fn name_of(names: Names) -> String {
    let tried = ["X", "G81", "L9001", "R340", "R5", "7", "W0214", "rapid", "M06"];
    tried.into_iter().find(|name| names.number(name).is_some()).unwrap().to_owned()
}

fn settings(text: &str) -> Option<String> {
    let run = Run::plain(text);
    run.findings.is_empty().then(|| format!("{:?}", run.settings()))
}

/// A row that nothing reads would leave the settings as they are.
#[test]
fn each_key_changes_the_settings() {
    for section in SECTIONS {
        for row in section.form.rows() {
            let mut seen: Vec<String> = Vec::new();
            for value in taken(row.takes) {
                // Limits of other keys may refuse an end of the range; the default of the dialect refuses other
                // controls' keys.
                if let Some(settings) = settings(&with_key(section, row, &value))
                    && !seen.contains(&settings)
                {
                    seen.push(settings);
                }
            }
            assert!(seen.len() >= 2, "{}.{}: {} different settings", section.name, row.name, seen.len());
        }
        if let Form::Map(names) = section.form {
            let listed = names
                .listed()
                .map_or_else(|| vec![name_of(names)], |list| list.into_iter().map(|(name, _)| name).collect());
            for name in listed {
                let number = names.number(&name).unwrap();
                let text = |value: &String| format!("[{}]\n'{name}' = {value}\n", section.name);
                let mut seen: Vec<String> =
                    taken(names.takes(number)).iter().filter_map(|value| settings(&text(value))).collect();
                seen.extend(settings(""));
                seen.sort_unstable();
                seen.dedup();
                // Group G7 has one lasting function only, M groups 10 to 13 have none without configuration.
                let fixed = ["G7", "M4", "M10", "M11", "M12", "M13"].contains(&name.as_str());
                assert!(seen.len() >= 2 || fixed, "{}.{name}: {} different settings", section.name, seen.len());
            }
        }
    }
}

/// A value that the row's schema refuses is E0702 at the value, and one that it takes is not refused for its type.
#[test]
fn each_key_is_checked_by_its_row() {
    let literals = ["true", "7", "-1", "1.25", "'text'", "'1'", "[]", "['a']", "[1]", "{}", "99999999999", "inf", "''"];
    for section in SECTIONS {
        for row in section.form.rows() {
            for literal in literals {
                let text = with_key(section, row, literal);
                let refused = Run::plain(&text).findings.iter().any(|found| found.code() == Code::E0702);
                // That files and folders exist, and letters are listed, the schema cannot say; numbers that are no JSON
                // it takes.
                if !fits(&text) {
                    assert!(refused, "{text}");
                } else if !matches!(row.takes, Takes::Path(_) | Takes::Texts(List::Paths, _)) && literal != "inf" {
                    assert!(!refused, "{text}");
                }
            }
        }
    }
}

/// What `init` and `explain` show is what the rows take; each key without a default has something to show.
#[test]
fn examples_are_taken() {
    let clean = |text: &str| {
        let run = Run::plain(text);
        assert!(run.findings.is_empty(), "{text}{:?}", run.findings);
    };
    for section in SECTIONS {
        for row in section.form.rows() {
            let value = row.literal(Dialect::default());
            clean(&with_key(section, row, value.as_deref().unwrap_or(row.example)));
        }
        match section.form {
            Form::Map(Names::Groups) | Form::Keys(..) | Form::List(..) => {}
            Form::Map(..) => clean(&format!("[{}]\n{}\n", section.name, section.example)),
            Form::Tables(names, ..) => assert!(names.number(section.example).is_some(), "{}", section.name),
        }
    }
}

/// The default that the table tells is what holds: saying it changes nothing, whatever the control.
#[test]
fn defaults_are_those_of_the_settings() {
    // Only where motion says the source of a value, and that it is configured, the two differ.
    let plain = |text: &str| {
        let settings = settings(text).unwrap();
        settings.replace("from: Key", "from: Default").replace("configured: true, n", "configured: false, n")
    };
    for dialect in Dialect::ALL {
        let head = format!("dialect = '{}'\n", dialect.name());
        for section in SECTIONS.iter().filter(|section| matches!(section.form, Form::Keys(_))) {
            for row in section.form.rows().iter().filter(|row| row.name != "dialect") {
                if let Some(value) = row.literal(dialect) {
                    let text = format!("{head}[{}]\n{} = {value}\n", section.name, row.name).replace("[]\n", "");
                    assert_eq!(plain(&text), plain(&head), "{text}");
                }
            }
        }
    }
}

/// Every option that overrides the file is a key that editors can set too, and the other way round.
#[test]
fn options_are_unique() {
    let mut options = options();
    let count = options.len();
    options.sort_unstable();
    options.dedup();
    assert_eq!(options.len(), count);
    assert!(ROOT.parent().is_none());
}
