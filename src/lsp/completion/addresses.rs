//! Addresses that the block may still have.

use gen_lsp_types::CompletionItemKind;

use super::fitting::centers;
use super::items::{Entry, Items, Section};
use super::texts::ItemText;
use super::{Context, Source};
use crate::dict::{Address, GCode, ValueForm};
use crate::resolve::usable_axes;
use crate::sure::small;

/// In the order of use; G, M and N have items of their own.
const ORDER: [Address; 24] = [
    Address::X,
    Address::Y,
    Address::Z,
    Address::A,
    Address::B,
    Address::C,
    Address::U,
    Address::V,
    Address::W,
    Address::I,
    Address::J,
    Address::K,
    Address::F,
    Address::S,
    Address::T,
    Address::L,
    Address::Q,
    Address::R,
    Address::D,
    Address::H,
    Address::P,
    Address::Correction,
    Address::Skip,
    Address::Program,
];

/// The addresses that the block may still have.
pub(super) fn addresses(source: &Source<'_>, context: &Context<'_>, items: &mut Items<'_>) {
    let codes: Vec<GCode> = context.words().filter_map(|word| word.g_code()).collect();
    let flow = codes.iter().any(|code| code.is_flow());
    let arc = codes.iter().any(|code| matches!(code, GCode::G02 | GCode::G03));
    let (centers, axes) = (centers(source, context, &codes), usable_axes(&source.settings.machine, context.file));
    for address in ORDER {
        let of_other_block = match address {
            Address::L => !flow,
            Address::Q => !flow && !codes.contains(&GCode::G04),
            Address::I | Address::J | Address::K => !centers.contains(&address),
            Address::X
            | Address::Y
            | Address::Z
            | Address::A
            | Address::B
            | Address::C
            | Address::U
            | Address::V
            | Address::W => !address.axis().is_some_and(|axis| axes.contains(&axis)),
            Address::Program => true,
            Address::N
            | Address::Skip
            | Address::G
            | Address::R
            | Address::Correction
            | Address::D
            | Address::F
            | Address::S
            | Address::H
            | Address::P
            | Address::T
            | Address::M => false,
        };
        let there = address != Address::R && context.words().any(|word| word.address == address);
        if !of_other_block && !there {
            let centre = arc && matches!(address, Address::I | Address::J);
            let section = if centre { Section::Second } else { Section::Addresses };
            item(source, address, address.letter(), section, items);
        }
    }
}

/// One address, for what it means; none when the machine has no such axis.
pub(super) fn address_item(source: &Source<'_>, address: Address, filter: &str, items: &mut Items<'_>) {
    item(source, address, filter, Section::Addresses, items);
}

fn item(source: &Source<'_>, address: Address, filter: &str, section: Section, items: &mut Items<'_>) {
    let machine = &source.settings.machine;
    if address.axis().is_some() && machine.axes.index_of(address).is_none() {
        return;
    }
    let order = ORDER.iter().position(|known| *known == address).unwrap_or(ORDER.len());
    let meaning = address.row().meaning.get(source.lang);
    items.add(Entry {
        label: address.letter().to_owned(),
        kind: CompletionItemKind::Field,
        detail: meaning.to_owned(),
        documentation: Some(documentation(source, address)),
        section,
        order: small(order),
        filter: filter.to_owned(),
        text: address.letter().to_owned(),
        snippet: None,
    });
}

fn documentation(source: &Source<'_>, address: Address) -> String {
    let lang = source.lang;
    let machine = &source.settings.machine;
    let row = address.row();
    let axis = machine.axes.index_of(address).and_then(|index| machine.axes.get(index));
    let mut lines = vec![format!("**{address}** – {}", row.meaning.get(lang))];
    if let Some(axis) = axis {
        lines.push(if axis.rotary { ItemText::Rotary } else { ItemText::Linear }.text(lang));
    }
    let range = match row.form {
        ValueForm::None => None,
        ValueForm::Parameter => Some(ItemText::ParameterRange.text(lang)),
        ValueForm::CorrectionDigits => Some(ItemText::FourDigits.text(lang)),
        ValueForm::Whole { .. }
        | ValueForm::Dimension
        | ValueForm::Feed
        | ValueForm::Auxiliary
        | ValueForm::Technological => Some(machine.ranges_text(address, lang)),
    };
    lines.extend(range.map(|range| ItemText::Range { range }.text(lang)));
    if row.lasts_until_changed {
        lines.push(ItemText::UntilChanged.text(lang));
    }
    lines.join("\n\n")
}
