//! Parameters: those in use around the place, those that the configuration gives, and the control words of arithmetic.

use std::collections::BTreeMap;

use gen_lsp_types::CompletionItemKind;

use super::items::{Entry, Items, Section};
use super::targets::NEAR;
use super::texts::ItemText;
use super::{Context, Source};
use crate::diag::shown;
use crate::dict::{Address, FIRST_CONTROL, GCode, Operation};
use crate::syntax::{BlockFlags, BlockId, Value};

/// The parameters in use, each with its first value: `R10=` to be assigned, or `R10` to be read.
pub(super) fn parameters(source: &Source<'_>, context: &Context<'_>, items: &mut Items<'_>, assigned: bool) {
    let lang = source.lang;
    let configured = &source.settings.machine.parameters;
    let mut known: BTreeMap<u8, Option<ItemText>> = BTreeMap::new();
    for (&index, value) in configured {
        known.insert(index, Some(ItemText::Configured { value: value.to_string() }));
    }
    for (index, text) in in_use(context) {
        let slot = known.entry(index).or_default();
        if text.is_some() {
            *slot = text;
        }
    }
    let (head, digits) = match context.digits() {
        Some(digits) if !context.typed.is_empty() => (context.head(), digits),
        Some("") => ("R", ""),
        Some(_) | None => return,
    };
    for (index, text) in known {
        let there = context.words().any(|word| word.address == Address::R && word.target() == index);
        let number = index.to_string();
        if (assigned && there) || !number.starts_with(digits) {
            continue;
        }
        let label = if assigned { format!("R{index}=") } else { format!("R{index}") };
        items.add(Entry {
            kind: CompletionItemKind::Variable,
            detail: text.unwrap_or(ItemText::Unassigned).text(lang),
            documentation: None,
            section: Section::Second,
            order: u32::from(index),
            filter: format!("{head}{number}"),
            text: unassigned(context, &label),
            label,
            snippet: None,
        });
    }
}

/// The text of an item, without its `=` where one stands behind the cursor.
fn unassigned(context: &Context<'_>, label: &str) -> String {
    if context.is_assigned() { label.trim_end_matches('=').to_owned() } else { label.to_owned() }
}

/// The parameters that blocks near the place assign or read, with their first value there.
fn in_use(context: &Context<'_>) -> BTreeMap<u8, Option<ItemText>> {
    let file = context.file;
    let text = file.source.text();
    let here = context.block.map_or(0, |block| block.0);
    let near = here.saturating_sub(NEAR)..here.saturating_add(NEAR).min(file.block_count());
    let mut known: BTreeMap<u8, Option<ItemText>> = BTreeMap::new();
    for block in near.map(BlockId).filter(|block| file.flags(*block).has(BlockFlags::RICH)) {
        for word in file.words(block) {
            let typed = word.start() < context.at && context.at <= word.span(text).end;
            if typed || word.is_faulty() {
                continue;
            }
            if let Value::Parameter { index, .. } = word.value() {
                known.entry(index).or_default();
            }
            if word.address == Address::R && !word.is_void() {
                let value = shown(file.source.slice(word.parts(text).value));
                let slot = known.entry(word.target()).or_default();
                slot.get_or_insert(ItemText::Assigned { value, n: file.shown_number(block) });
            }
        }
    }
    known
}

/// The control words that the arithmetic of the block still needs.
pub(super) fn control_words(source: &Source<'_>, context: &Context<'_>, items: &mut Items<'_>) {
    let Some(code) = arithmetic(context) else { return };
    for index in control_range(code) {
        let there = context.words().any(|word| word.address == Address::R && word.target() == index);
        let number = index.to_string();
        let digits = if context.typed.is_empty() { Some("") } else { context.digits() };
        if there || digits.is_none_or(|digits| !number.starts_with(digits)) {
            continue;
        }
        let head = if context.typed.is_empty() { "R" } else { context.head() };
        items.add(Entry {
            label: format!("R{index}="),
            kind: CompletionItemKind::Variable,
            detail: ItemText::ControlWord { code }.text(source.lang),
            documentation: Some(ItemText::ControlForm.text(source.lang)),
            section: Section::First,
            order: u32::from(index),
            filter: format!("{head}{number}"),
            text: unassigned(context, &format!("R{index}=")),
            snippet: None,
        });
    }
}

/// After `R5=` of a block with arithmetic: the operations of the machine.
pub(super) fn operations(source: &Source<'_>, context: &Context<'_>, target: u8, items: &mut Items<'_>) {
    let is_control = arithmetic(context).is_some_and(|code| control_range(code).contains(&target));
    let Some(digits) = context.digits().filter(|_| is_control && context.head().is_empty()) else { return };
    for (&code, &operation) in &source.settings.machine.operations {
        let number = format!("{code:02}");
        if !number.starts_with(digits) && !digits.starts_with(&number) {
            continue;
        }
        let second = if operation.takes_two() { ("11", "${2:11}") } else { ("00", "00") };
        items.add(Entry {
            label: format!("{number} {}", formula(operation)),
            kind: CompletionItemKind::Operator,
            detail: operation.name().to_owned(),
            documentation: Some(ItemText::ControlForm.text(source.lang)),
            section: Section::First,
            order: u32::from(code),
            filter: if digits.len() > number.len() { digits.to_owned() } else { number.clone() },
            text: format!("{number}10{}12", second.0),
            snippet: Some(format!("{number}${{1:10}}{}${{3:12}}", second.1)),
        });
    }
}

/// The function of the block that performs arithmetic.
fn arithmetic(context: &Context<'_>) -> Option<GCode> {
    context.words().filter_map(|word| word.g_code()).find(|code| code.operations() > 0)
}

fn control_range(code: GCode) -> std::ops::Range<u8> {
    FIRST_CONTROL..FIRST_CONTROL + u8::try_from(code.operations()).unwrap_or(0)
}

/// What an operation makes of its operands a and b.
const fn formula(operation: Operation) -> &'static str {
    match operation {
        Operation::Add => "a + b",
        Operation::Sub => "a − b",
        Operation::Mul => "a · b",
        Operation::Div => "a / b",
        Operation::Neg => "−a",
        Operation::Abs => "|a|",
        Operation::Sqrt => "√a",
        Operation::Sin => "sin a",
        Operation::Cos => "cos a",
        Operation::Tan => "tan a",
        Operation::Asin => "asin a",
        Operation::Acos => "acos a",
        Operation::Atan => "atan a",
        Operation::Atan2 => "atan2(y = a, x = b)",
        Operation::Mod => "a mod b",
        Operation::Min => "min(a, b)",
        Operation::Max => "max(a, b)",
        Operation::Round => "round a",
        Operation::Trunc => "trunc a",
        Operation::Copy => "a",
    }
}
