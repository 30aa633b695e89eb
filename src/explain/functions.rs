//! Pages about functions and addresses, made from the dictionary and from notes on their use.

use std::fmt::Write as _;

use super::usage::Usage;
use super::{m_usage, usage};
use crate::diag::Code;
use crate::dict::{
    Address, Bilingual, Dialect, GCode, HIGHEST_PARAMETER, Lang, Lasting, M_GROUPS, MRow, ValueForm, capitalized,
    standard_m_functions,
};

fn pick(lang: Lang, en: &'static str, cs: &'static str) -> &'static str {
    Bilingual { en, cs }.get(lang)
}

pub(super) fn g_page(code: GCode, lang: Lang) -> String {
    let group = code.group();
    let members: Vec<String> = GCode::ALL
        .iter()
        .filter(|other| other.group() == group)
        .map(|other| format!("{other}{}", other.lasting().mark(other.is_lasting_decided())))
        .collect();
    let mut page = format!("# {code}: {}\n\n", code.meaning().get(lang));
    let word = pick(lang, "Group", "Skupina");
    let _ = writeln!(page, "- {word} {group}, {}: {}", group.meaning().get(lang), members.join(", "));
    let _ = writeln!(page, "- {}", lasts(code.lasting(), lang));
    if code.is_lasting_decided() {
        let text = pick(
            lang,
            "The mark in brackets is a decision: the manual has none here",
            "Značka v závorce je rozhodnutí: v příručce zde žádná není",
        );
        let _ = writeln!(page, "- {text}");
    }
    let once = pick(lang, "One function of the group in a block", "Z jedné skupiny smí být v bloku jediná funkce");
    let _ = writeln!(page, "- {once}");
    if let Some(usage) = usage::of(code) {
        let names: Vec<String> = usage.codes.iter().map(GCode::to_string).collect();
        add_usage(&mut page, usage, &names, &code.to_string(), lang);
    }
    add_findings(&mut page, &code.to_string(), lang);
    page
}

/// Adds how a function is written, an example, and what else there is to know. Where syntax or example do not have the
/// function, it is there in place of the first of the `names` that they have.
fn add_usage<C>(page: &mut String, usage: &Usage<C>, names: &[String], function: &str, lang: Lang) {
    let with = |text: &str| match names.iter().find(|name| holds_word(text, name)) {
        Some(name) if !holds_word(text, function) => text.replace(name, function),
        _ => text.to_owned(),
    };
    let syntax =
        if names.iter().any(|name| usage.syntax.contains(name)) { with(usage.syntax) } else { function.into() };
    let _ = write!(page, "\n## {}\n\n```\n{syntax}\n```\n", pick(lang, "Syntax", "Zápis"));
    if !usage.notes.is_empty() {
        page.push('\n');
    }
    for note in usage.notes {
        let mut note = note.get(lang).to_owned();
        // The key of a cycle.
        for name in names {
            note = note.replace(&format!("`{name} = "), &format!("`{function} = "));
        }
        bullet(page, &note);
    }
    let _ = write!(page, "\n## {}\n", pick(lang, "Example", "Příklad"));
    if !usage.project.is_empty() {
        let _ = write!(page, "\n```toml\n{}```\n", with(usage.project));
    }
    let mut example = with(usage.example);
    if lang == Lang::Cs {
        for comment in usage::COMMENTS {
            example = example.replace(comment.en, comment.cs);
        }
    }
    let _ = write!(page, "\n```nc\n{example}\n```\n");
}

/// Most characters of a line.
const WIDTH: usize = 90;

/// Adds a line of a list, broken where it is too long.
fn bullet(page: &mut String, text: &str) {
    let mut line = String::from("-");
    for word in text.split(' ') {
        if line.chars().count() + 1 + word.chars().count() > WIDTH {
            let _ = writeln!(page, "{line}");
            line = String::from(" ");
        }
        line.push(' ');
        line.push_str(word);
    }
    let _ = writeln!(page, "{line}");
}

pub(super) fn m_page(number: u8, lang: Lang) -> String {
    let row = |dialect| standard_m_functions(dialect).find(|row| row.number == number);
    let alike = |a: Option<&MRow>, b: Option<&MRow>| match (a, b) {
        (Some(a), Some(b)) => a.meaning == b.meaning && a.group == b.group && a.lasting == b.lasting,
        (None, None) => true,
        _ => false,
    };
    let mut parts: Vec<(Vec<&str>, Option<&MRow>)> = Vec::new();
    for dialect in Dialect::ALL.into_iter().filter(|dialect| number <= dialect.highest_m()) {
        match parts.iter_mut().find(|(_, other)| alike(*other, row(dialect))) {
            Some((dialects, _)) => dialects.push(dialect.title()),
            None => parts.push((vec![dialect.title()], row(dialect))),
        }
    }
    let free = pick(lang, "by the machine builder", "podle výrobce stroje");
    let mut page = match parts.as_slice() {
        [(_, only)] => format!("# M{number:02}: {}\n", only.map_or(free, |row| row.meaning.get(lang))),
        _ => format!("# M{number:02}\n"),
    };
    for (dialects, row) in &parts {
        let _ = writeln!(page, "\n## {}\n", dialects.join(", "));
        match row {
            Some(row) => {
                if parts.len() > 1 {
                    let _ = writeln!(page, "- {}", capitalized(row.meaning.get(lang)));
                }
                let dialect = Dialect::ALL.into_iter().find(|&dialect| dialects.contains(&dialect.title()));
                let mut members: Vec<String> = dialect
                    .into_iter()
                    .flat_map(standard_m_functions)
                    .filter(|other| other.group == row.group)
                    .map(|other| format!("M{:02}{}", other.number, other.lasting.mark(false)))
                    .collect();
                members.sort();
                let group = match lang {
                    Lang::En => format!("M group {}", row.group),
                    Lang::Cs => format!("{}. skupina M funkcí", row.group),
                };
                let _ = writeln!(page, "- {group}: {}", members.join(", "));
                let _ = writeln!(page, "- {}", lasts(row.lasting, lang));
            }
            None => {
                let has = |channel_config| {
                    let mut of = Dialect::ALL.iter().filter(|dialect| dialects.contains(&dialect.title()));
                    of.any(|dialect| dialect.has_channel_config() == channel_config)
                };
                let rest = M_GROUPS - 1;
                let group = match (lang, has(false), has(true)) {
                    (Lang::En, true, false) => "machine constants R56–R59 give, 10 to 13",
                    (Lang::Cs, true, false) => "strojní konstanty R56–R59, 10 až 13",
                    (Lang::En, false, _) => "MFunctions of the ChannelConfig give",
                    (Lang::Cs, false, _) => "MFunctions v ChannelConfigu",
                    (Lang::En, true, true) => {
                        "machine constants R56–R59 give, 10 to 13, on CNC872 MFunctions of the ChannelConfig"
                    }
                    (Lang::Cs, true, true) => {
                        "strojní konstanty R56–R59, 10 až 13, u CNC872 MFunctions v ChannelConfigu"
                    }
                };
                let text = match lang {
                    Lang::En => format!(
                        "No standard function: what it does is up to the machine builder. M group {rest}, or the group \
                         that {group}"
                    ),
                    Lang::Cs => format!(
                        "Není to standardní funkce: co dělá, určuje výrobce stroje. {rest}. skupina M funkcí, nebo \
                         skupina, kterou určují {group}"
                    ),
                };
                let _ = writeln!(page, "- {text}");
            }
        }
    }
    if let Some(usage) = m_usage::of(number) {
        let names: Vec<String> = usage.codes.iter().map(|code| format!("M{code:02}")).collect();
        add_usage(&mut page, usage, &names, &format!("M{number:02}"), lang);
    }
    add_findings(&mut page, &format!("M{number:02}"), lang);
    page
}

pub(super) fn address_page(address: Address, lang: Lang) -> String {
    let row = address.row();
    let mut page = format!("# {}: {}\n\n", row.letter, row.meaning.get(lang));
    let _ = writeln!(page, "- {}", value(address, lang));
    if row.form != ValueForm::None {
        let sign = pick(lang, "A sign", "Znaménko");
        let point = pick(lang, "A decimal point", "Desetinná tečka");
        let _ = writeln!(page, "- {sign}: {}", allowed(|dialect| address.takes_sign(dialect), lang));
        let _ = writeln!(page, "- {point}: {}", allowed(|dialect| row.form.takes_point(dialect), lang));
    }
    let grouped = matches!(address, Address::G | Address::M);
    let lasting = if grouped {
        pick(lang, "How long it holds depends on its group", "Jak dlouho platí, závisí na skupině")
    } else if row.lasts_until_changed {
        pick(lang, "Holds until changed", "Platí do změny")
    } else {
        pick(lang, "Holds in its own block", "Platí ve svém bloku")
    };
    let times = if grouped {
        pick(lang, "One of each group in a block", "V bloku jedna z každé skupiny")
    } else if address == Address::R {
        pick(lang, "Each parameter once in a block", "V bloku každý parametr jednou")
    } else {
        pick(lang, "Once in a block", "V bloku jednou")
    };
    if !matches!(address, Address::Program | Address::N) {
        if address.axis().is_none() {
            let _ = writeln!(page, "- {lasting}");
        }
        let _ = writeln!(page, "- {times}");
    }
    add_findings(&mut page, &format!("`{}`", row.letter), lang);
    page
}

fn value(address: Address, lang: Lang) -> String {
    let ranges = address.ranges_text(lang);
    match (address.row().form, lang) {
        (ValueForm::Whole { .. } | ValueForm::Technological, Lang::En) => format!("A whole number: {ranges}"),
        (ValueForm::Whole { .. } | ValueForm::Technological, Lang::Cs) => format!("Celé číslo: {ranges}"),
        (ValueForm::Feed | ValueForm::Auxiliary, Lang::En) => format!("A number: {ranges}"),
        (ValueForm::Feed | ValueForm::Auxiliary, Lang::Cs) => format!("Číslo: {ranges}"),
        (ValueForm::Dimension, Lang::En) => {
            format!("A number: {ranges}; without a point whole units: X3620 is 3620 mm")
        }
        (ValueForm::Dimension, Lang::Cs) => format!("Číslo: {ranges}; bez tečky celé jednotky: X3620 je 3620 mm"),
        (ValueForm::Parameter, Lang::En) => format!(
            "The number of the parameter, 0–{HIGHEST_PARAMETER}, and its value: {ranges}, or a whole number of up to \
             eight digits. R10=25.5 assigns, XR10 uses"
        ),
        (ValueForm::Parameter, Lang::Cs) => format!(
            "Číslo parametru 0–{HIGHEST_PARAMETER} a hodnota: {ranges}, nebo celé číslo nejvýše o osmi číslicích. \
             R10=25.5 přiřadí, XR10 použije"
        ),
        (ValueForm::None, Lang::En) => "Has no value; digits after it are read and not evaluated".to_owned(),
        (ValueForm::None, Lang::Cs) => "Nemá hodnotu; číslice za ní se přečtou, ale nevyhodnocují".to_owned(),
        (ValueForm::CorrectionDigits, Lang::En) => {
            "Four digits, each 0, 1 or 2; which axis and which direction they mean is in the machine's manual"
                .to_owned()
        }
        (ValueForm::CorrectionDigits, Lang::Cs) => {
            "Čtyři číslice 0, 1 nebo 2; které ose a kterému směru patří, udává příručka stroje".to_owned()
        }
    }
}

/// On which controls something is allowed.
fn allowed(on: impl Fn(Dialect) -> bool, lang: Lang) -> String {
    let dialects: Vec<&str> = Dialect::ALL.into_iter().filter(|&dialect| on(dialect)).map(Dialect::title).collect();
    match dialects.len() {
        0 => pick(lang, "no", "ne").to_owned(),
        count if count == Dialect::ALL.len() => pick(lang, "yes", "ano").to_owned(),
        _ => format!("{} {}", pick(lang, "on", "na"), dialects.join(", ")),
    }
}

fn lasts(lasting: Lasting, lang: Lang) -> &'static str {
    match lasting {
        Lasting::Modal => pick(lang, "Holds until another of its group", "Platí do další funkce skupiny"),
        Lasting::Default => pick(
            lang,
            "Holds until another of its group, and after power-up, M02 and M30 (+)",
            "Platí do další funkce skupiny a po zapnutí, M02 a M30 (+)",
        ),
        Lasting::Block => pick(
            lang,
            "Holds in its own block only (x); what was in force before holds again after it",
            "Platí jen ve svém bloku (x); co platilo před ním, platí zase po něm",
        ),
    }
}

/// Adds the diagnostics whose pages name that word.
pub(super) fn add_findings(page: &mut String, word: &str, lang: Lang) {
    let about: Vec<String> = Code::ALL
        .iter()
        .map(|code| (code, code.page(lang)))
        .filter(|(_, page)| page.contains(word) && prose(page).any(|line| holds_word(line, word)))
        .map(|(code, _)| format!("- {code} {}", code.name()))
        .collect();
    if !about.is_empty() {
        let title = pick(lang, "Related findings", "Související hlášení");
        let _ = write!(page, "\n## {title}\n\n{}\n", about.join("\n"));
    }
}

/// The lines of a page outside its examples.
fn prose(page: &str) -> impl Iterator<Item = &str> {
    page.lines().scan(false, |inside, line| {
        let fence = line.starts_with("```");
        *inside ^= fence;
        Some(if fence || *inside { "" } else { line })
    })
}

fn holds_word(line: &str, word: &str) -> bool {
    line.match_indices(word).any(|(at, _)| {
        let before = line.get(..at).and_then(|text| text.chars().next_back());
        let after = line.get(at + word.len()..).and_then(|text| text.chars().next());
        let joined = |character: Option<char>| character.is_some_and(|character| character.is_ascii_alphanumeric());
        !joined(before) && !joined(after)
    })
}
