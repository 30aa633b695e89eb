//! A short text for a popup, in Markdown or plain, as the client takes it.

use gen_lsp_types::{MarkupContent, MarkupKind};

use super::client::Client;

/// Characters that mean something in Markdown.
const SPECIAL: &[char] =
    &['\\', '`', '*', '_', '{', '}', '[', ']', '<', '>', '(', ')', '#', '+', '-', '.', '!', '|', '~', '&', '$'];

/// A text in the making.
#[derive(Debug)]
pub(super) struct Page {
    markdown: bool,
    text: String,
    /// The last thing added is an item of a list.
    in_list: bool,
}

impl Page {
    /// Empty, in the form that hovers of that client have: the one that it names first.
    pub(super) fn new(client: &Client) -> Self {
        let form = client.first("/textDocument/hover/contentFormat");
        Self { markdown: form != Some("plaintext"), text: String::new(), in_list: false }
    }

    /// Something as it stands in programs: `G01`.
    pub(super) fn code(&self, text: &str) -> String {
        if !self.markdown || text.is_empty() {
            text.to_owned()
        } else if text.contains('`') {
            self.user(text)
        } else {
            format!("`{text}`")
        }
    }

    /// Text of the user, in which nothing is markup.
    pub(super) fn user(&self, text: &str) -> String {
        if !self.markdown {
            return text.to_owned();
        }
        let mut escaped = String::with_capacity(text.len());
        for character in text.chars() {
            if SPECIAL.contains(&character) {
                escaped.push('\\');
            }
            escaped.push(character);
        }
        escaped
    }

    /// A heading: a thing of programs, and what it is.
    pub(super) fn heading(&mut self, name: &str, meaning: &str) {
        let text = if self.markdown { format!("**`{name}`** {meaning}") } else { format!("{name}: {meaning}") };
        self.line(&text);
    }

    /// A sentence that says what the items after it are about.
    pub(super) fn title(&mut self, text: &str) {
        let text = if self.markdown { format!("**{text}**") } else { text.to_owned() };
        self.line(&text);
    }

    /// A paragraph.
    pub(super) fn line(&mut self, text: &str) {
        if !self.text.is_empty() {
            self.text.push_str(if self.markdown { "\n\n" } else { "\n" });
        }
        self.text.push_str(text);
        self.in_list = false;
    }

    /// An item of a list.
    pub(super) fn item(&mut self, label: &str, value: &str) {
        if self.markdown {
            self.text.push_str(if self.in_list { "\n- " } else { "\n\n- " });
        } else {
            self.text.push('\n');
        }
        self.text.push_str(&format!("{label}: {value}"));
        self.in_list = true;
    }

    /// What follows is about something else.
    pub(super) fn rule(&mut self) {
        if self.text.is_empty() {
            return;
        }
        if self.markdown {
            self.line("---");
        } else {
            self.text.push('\n');
        }
    }

    /// As the protocol has it.
    pub(super) fn content(self) -> MarkupContent {
        let kind = if self.markdown { MarkupKind::Markdown } else { MarkupKind::PlainText };
        MarkupContent { kind, value: self.text }
    }
}
