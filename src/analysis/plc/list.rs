//! The dictionary as a list: for people, and for programs.

use serde_json::{Value, json};

use super::dictionary::{Signal, signals};
use crate::config::Machine;
use crate::dict::{Dialect, Lang};

/// The signals of a control, one a line: name, type, section of S0, meaning; for an axis the letter that has its place
/// on this machine.
pub fn list_table(machine: &Machine, lang: Lang) -> String {
    let width = of(machine.dialect).map(|signal| signal.name.len()).max().unwrap_or(0);
    let mut text = String::new();
    for signal in of(machine.dialect) {
        let (kind, section) = (signal.form().name(), signal.row.section);
        let meaning = signal.meaning_on(machine, lang);
        text.push_str(&format!("{:width$}  {kind:<5}  S0 {section:<6}  {meaning}\n", signal.name));
    }
    text
}

/// The same as one JSON object.
pub fn list_json(machine: &Machine, lang: Lang) -> Value {
    let row = |signal: &'static Signal| {
        let dialects: Vec<&str> =
            Dialect::ALL.into_iter().filter(|dialect| signal.row.is_of(*dialect)).map(Dialect::name).collect();
        let mut row = json!({
            "name": signal.name,
            "type": signal.form().name(),
            "bcd": signal.is_bcd(),
            "meaning": signal.meaning(lang),
            "dialects": dialects,
            "source": format!("S0 {}", signal.row.section),
            "rule": format!("PLC-{}", signal.row.rule),
        });
        if let (Some(letter), Some(row)) = (letter(signal, machine), row.as_object_mut()) {
            row.insert("axis".to_owned(), letter.into());
        }
        row
    };
    json!({
        "schema": "cnc872c.plc-signals/1",
        "dialect": machine.dialect.name(),
        "signals": of(machine.dialect).map(row).collect::<Vec<_>>(),
    })
}

fn of(dialect: Dialect) -> impl Iterator<Item = &'static Signal> {
    signals().iter().filter(move |signal| signal.row.is_of(dialect))
}

impl Signal {
    /// Its meaning; of an axis with the letter at its place on this machine.
    pub fn meaning_on(&self, machine: &Machine, lang: Lang) -> String {
        match letter(self, machine) {
            Some(letter) => format!("{}: {letter}", self.meaning(lang)),
            None => self.meaning(lang),
        }
    }
}

/// The axis that a signal is about, on this machine.
fn letter(signal: &Signal, machine: &Machine) -> Option<String> {
    let axis = machine.axes.get(signal.axis(machine)?)?;
    Some(axis.letter.to_string())
}
