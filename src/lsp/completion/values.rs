//! The values that tools, feeds, speeds and the like have in the program already.

use std::collections::BTreeMap;

use gen_lsp_types::CompletionItemKind;

use super::items::{Entry, Items, Section};
use super::targets::NEAR;
use super::texts::ItemText;
use super::{Context, Source};
use crate::dict::Address;
use crate::sure::small;
use crate::syntax::BlockId;

/// Most values that are offered.
const MOST: usize = 30;

/// The values that an address has in the blocks around, the most frequent first, for those that begin with the typed
/// digits.
pub(super) fn values(source: &Source<'_>, context: &Context<'_>, address: Address, items: &mut Items<'_>) {
    let of_tools = [Address::T, Address::D, Address::F, Address::S, Address::H, Address::P, Address::Correction];
    let (Some(digits), Some(block), true) = (context.digits(), context.block, of_tools.contains(&address)) else {
        return;
    };
    let file = context.file;
    let text = file.source.text();
    let mut counts: BTreeMap<&str, u32> = BTreeMap::new();
    for block in (block.0.saturating_sub(NEAR)..file.block_count().min(block.0 + NEAR)).map(BlockId) {
        let words = file.words(block).iter().filter(|word| word.address == address && word.is_plain());
        for word in words.filter(|word| word.start() != context.replaced.start) {
            *counts.entry(file.source.slice(word.parts(text).value)).or_default() += 1;
        }
    }
    let mut found: Vec<(&str, u32)> = counts.into_iter().filter(|(value, _)| value.starts_with(digits)).collect();
    found.sort_by_key(|(_, count)| std::cmp::Reverse(*count));
    for (order, (value, count)) in found.into_iter().take(MOST).enumerate() {
        let label = format!("{}{value}", address.letter());
        items.add(Entry {
            kind: CompletionItemKind::Value,
            detail: ItemText::InProgram { count }.text(source.lang),
            documentation: None,
            section: Section::First,
            order: small(order),
            filter: format!("{}{value}", context.head()),
            text: label.clone(),
            snippet: None,
            label,
        });
    }
}
