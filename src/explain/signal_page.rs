//! The pages of signals of the PLC, and of the names that a part program does not determine.

use crate::analysis::plc::{dictionary, run_time};
use crate::dict::{Dialect, Lang};

/// The page of a signal, Markdown.
pub(super) fn signal_page(name: &str, lang: Lang) -> String {
    let Some(signal) = dictionary::find(name) else { return String::new() };
    let row = signal.row;
    let controls: Vec<&str> =
        Dialect::ALL.into_iter().filter(|dialect| row.is_of(*dialect)).map(Dialect::title).collect();
    let controls = controls.join(", ");
    let form = signal.form().name();
    let mut page = format!("# {name}: {}\n\n- {form}, S0 {}; {controls}\n", signal.meaning(lang), row.section);
    page.push_str(&format!("- {} (PLC-{})\n", row.value_text().get(lang), row.rule));
    if let Some(place) = signal.place() {
        page.push_str(&match lang {
            Lang::En => {
                format!("- NC axis {place} is axis {} of `[[axes]]`; `plc --list` shows its letter\n", place + 1)
            }
            Lang::Cs => {
                format!("- NC osa {place} je {}. osa z `[[axes]]`; její písmeno ukáže `plc --list`\n", place + 1)
            }
        });
    }
    let same: Vec<&str> = dictionary::signals()
        .iter()
        .filter(|other| other.cell == signal.cell && other.name != signal.name)
        .map(|other| other.name.as_str())
        .collect();
    if !same.is_empty() {
        let same = same.join(", ");
        page.push_str(&match lang {
            Lang::En => format!("- The same: {same}\n"),
            Lang::Cs => format!("- Totéž: {same}\n"),
        });
    }
    page
}

/// The page of a name that a part program does not determine, Markdown.
pub(super) fn run_time_page(name: &str, lang: Lang) -> String {
    let Some(known) = run_time::find(name) else { return String::new() };
    let reason = known.reason.text(lang);
    match lang {
        Lang::En => format!("# {name}\n\nA part program does not determine it: {reason}.\n\nS0 {}\n", known.section),
        Lang::Cs => format!("# {name}\n\nPartprogram tuto buňku neurčuje: {reason}.\n\nS0 {}\n", known.section),
    }
}
