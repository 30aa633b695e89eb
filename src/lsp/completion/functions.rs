//! G and M functions: what they are, and which the block has no room for.

use gen_lsp_types::CompletionItemKind;

use super::fitting::{Part, takes_m};
use super::items::{Entry, Items, Section};
use super::texts::ItemText;
use super::{Context, Source};
use crate::config::MFunction;
use crate::dict::{GCode, GGroup, Lasting, MRow, standard_m_functions};
use crate::resolve::m_number;

/// The G functions whose number begins with the digits typed. Those that the block has no room for come last when a
/// number is being typed, and not at all among all words.
pub(super) fn g_functions(source: &Source<'_>, context: &Context<'_>, items: &mut Items<'_>, all: bool) {
    let lang = source.lang;
    let there: Vec<GCode> = context.words().filter_map(|word| word.g_code()).collect();
    let digits = if all { Some("") } else { context.digits() };
    let part = context.block.map_or(Part::Any, |block| Part::of(source, block));
    for &code in GCode::ALL.iter().filter(|code| part.takes_g(source, context, **code)) {
        let Some(form) = digits.and_then(|digits| two_digits(code.number(), digits)) else { continue };
        let clash = there.iter().find(|other| other.group() == code.group());
        if all && clash.is_some() {
            continue;
        }
        let meaning = code.meaning().get(lang);
        items.add(Entry {
            label: code.to_string(),
            kind: CompletionItemKind::Function,
            detail: match clash {
                Some(with) => format!("{meaning} – {}", ItemText::Clashes { with: with.to_string() }.text(lang)),
                None => meaning.to_owned(),
            },
            documentation: Some(g_documentation(source, code)),
            section: if clash.is_some() { Section::Clashing } else { Section::G },
            order: u32::from(code.number()),
            filter: filter(context, 'G', &form, all),
            text: code.to_string(),
            snippet: None,
        });
    }
}

/// What stands before the digits in the text that the client compares with what is typed.
fn filter(context: &Context<'_>, letter: char, form: &str, all: bool) -> String {
    if all { format!("{letter}{form}") } else { format!("{}{form}", context.head()) }
}

/// The number as it is being typed, with a leading zero or without; `None` when other digits are typed.
fn two_digits(number: u8, typed: &str) -> Option<String> {
    let long = format!("{number:02}");
    let form = if typed.is_empty() || typed.starts_with('0') { long } else { number.to_string() };
    form.starts_with(typed).then_some(form)
}

fn g_documentation(source: &Source<'_>, code: GCode) -> String {
    let lang = source.lang;
    let machine = &source.settings.machine;
    let group = code.group();
    let mut lines = vec![
        format!("**{code}** – {}", code.meaning().get(lang)),
        ItemText::Group { group, meaning: group.meaning().get(lang) }.text(lang),
    ];
    let power_up = machine.power_up.get(group.index()).copied().flatten() == Some(code);
    lines.push(lasting(code.lasting()).text(lang));
    if power_up {
        lines.push(ItemText::PowerUp.text(lang));
    }
    lines.extend(needs(code).map(|needs| needs.text(lang)));
    let cycle = machine.cycles.get(&code.number()).map(|l| ItemText::CallsMacrocycle { l: *l }.text(lang));
    lines.extend(cycle);
    lines.join("\n\n")
}

const fn lasting(lasting: Lasting) -> ItemText {
    match lasting {
        Lasting::Modal | Lasting::Default => ItemText::Modal,
        Lasting::Block => ItemText::OneBlock,
    }
}

/// What else the block of a function needs.
fn needs(code: GCode) -> Option<ItemText> {
    let by_code = [
        (GCode::G02, ItemText::NeedsCentre),
        (GCode::G03, ItemText::NeedsCentre),
        (GCode::G04, ItemText::NeedsDwell),
        (GCode::G23, ItemText::DynamicSet),
        (GCode::G26, ItemText::NeedsOneControl),
        (GCode::G71, ItemText::NeedsSubprogram),
        (GCode::G72, ItemText::NeedsMacrocycle),
        (GCode::G73, ItemText::NeedsBlock),
        (GCode::G79, ItemText::NeedsEntry),
    ];
    if let Some((_, needs)) = by_code.into_iter().find(|(known, _)| *known == code) {
        return Some(needs);
    }
    if code.group() == GGroup::G4 {
        return Some(ItemText::NeedsControl { last: 4 + code.operations() });
    }
    code.makes_words_data().then_some(ItemText::MakesData)
}

/// The M functions that the machine has by the standard or by its configuration; others as for G.
pub(super) fn m_functions(source: &Source<'_>, context: &Context<'_>, items: &mut Items<'_>, all: bool) {
    let machine = &source.settings.machine;
    let lang = source.lang;
    let there: Vec<u8> = context.words().filter_map(|word| m_number(word, source.settings)).collect();
    let digits = if all { Some("") } else { context.digits() };
    for function in (0..=machine.dialect.highest_m()).filter_map(|number| machine.m_functions.get(number)) {
        let Some(form) = digits.and_then(|digits| two_digits(function.number, digits)) else { continue };
        let row = standard_m_functions(machine.dialect).find(|row| row.number == function.number);
        let missing = function.number == 19 && !machine.oriented_stop;
        if (row.is_none() && !function.configured) || missing || !takes_m(context, function.number) {
            continue;
        }
        let clash = there.iter().find(|other| machine.m_functions.group(**other) == function.group);
        if all && clash.is_some() {
            continue;
        }
        let meaning = meaning(source, function, row);
        let label = format!("M{:02}", function.number);
        items.add(Entry {
            detail: match clash {
                Some(with) => format!("{meaning} – {}", ItemText::Clashes { with: format!("M{with:02}") }.text(lang)),
                None => meaning,
            },
            kind: CompletionItemKind::Function,
            documentation: Some(m_documentation(source, function, row)),
            section: if clash.is_some() { Section::Clashing } else { Section::M },
            order: u32::from(function.number),
            filter: filter(context, 'M', &form, all),
            text: label.clone(),
            label,
            snippet: None,
        });
    }
}

fn meaning(source: &Source<'_>, function: MFunction, row: Option<&MRow>) -> String {
    let group = function.group;
    row.map_or_else(|| ItemText::OfMachine { group }.text(source.lang), |row| row.meaning.get(source.lang).to_owned())
}

fn m_documentation(source: &Source<'_>, function: MFunction, row: Option<&MRow>) -> String {
    let lang = source.lang;
    let mut lines = vec![format!("**M{:02}** – {}", function.number, meaning(source, function, row))];
    if let Some(row) = row {
        lines.push(ItemText::MGroup { group: function.group }.text(lang));
        lines.push(lasting(row.lasting).text(lang));
        if row.lasting == Lasting::Default {
            lines.push(ItemText::PowerUp.text(lang));
        }
    }
    let attributes = [
        (function.break_cont, ItemText::BreakCont),
        (function.break_cont_end, ItemText::BreakContEnd),
        (function.change_pos, ItemText::ChangePos),
    ];
    lines.extend(attributes.into_iter().filter(|(set, _)| *set).map(|(_, text)| text.text(lang)));
    lines.join("\n\n")
}
