//! Items as the client gets them.

use gen_lsp_types::{
    CompletionItem, CompletionItemKind, CompletionItemTextEdit, CompletionList, Documentation, InsertTextFormat,
    MarkupContent, MarkupKind, Range, TextEdit,
};

use crate::query::cancel::Cancel;

/// In which order items are shown.
#[derive(Clone, Copy, Debug, Eq, Ord, PartialEq, PartialOrd)]
pub(super) enum Section {
    /// The most likely items.
    First,
    /// Less near than the first.
    Second,
    Addresses,
    G,
    M,
    Snippets,
    /// What would be a finding in this block.
    Clashing,
}

/// One item.
#[derive(Clone, Debug)]
pub(super) struct Entry {
    pub(super) label: String,
    pub(super) kind: CompletionItemKind,
    pub(super) detail: String,
    /// Markdown.
    pub(super) documentation: Option<String>,
    pub(super) section: Section,
    /// Its place in the section.
    pub(super) order: u32,
    /// The text that the client compares with the typed one.
    pub(super) filter: String,
    /// The inserted text.
    pub(super) text: String,
    /// The same with places to fill in, for clients that can.
    pub(super) snippet: Option<String>,
}

/// The items of one answer.
#[derive(Debug)]
pub(super) struct Items<'a> {
    /// The replaced range.
    pub(super) range: Range,
    /// Whether the client fills in snippets.
    pub(super) snippets: bool,
    /// Whether there are more.
    pub(super) incomplete: bool,
    /// Whether nobody wants them any more.
    pub(super) cancel: &'a Cancel,
    pub(super) list: Vec<CompletionItem>,
}

impl Items<'_> {
    pub(super) fn add(&mut self, entry: Entry) {
        let Entry { label, kind, detail, documentation, section, order, filter, text, snippet } = entry;
        let snippet = snippet.filter(|_| self.snippets);
        let format = snippet.is_some().then_some(InsertTextFormat::Snippet);
        self.list.push(CompletionItem {
            label,
            kind: Some(kind),
            detail: Some(detail).filter(|detail| !detail.is_empty()),
            documentation: documentation
                .map(|value| Documentation::MarkupContent(MarkupContent { kind: MarkupKind::Markdown, value })),
            sort_text: Some(format!("{}{order:010}", section as u8)),
            filter_text: Some(filter),
            insert_text_format: format,
            text_edit: Some(CompletionItemTextEdit::TextEdit(TextEdit {
                range: self.range,
                new_text: snippet.unwrap_or(text),
            })),
            ..CompletionItem::default()
        });
    }

    pub(super) fn finish(mut self) -> CompletionList {
        self.list.sort_by(|a, b| a.sort_text.cmp(&b.sort_text));
        CompletionList { is_incomplete: self.incomplete, items: self.list, ..CompletionList::default() }
    }
}
