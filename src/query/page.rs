//! A short text for a popup, in Markdown or plain, as the client takes it.

/// Characters that mean something in Markdown.
const SPECIAL: &[char] =
    &['\\', '`', '*', '_', '{', '}', '[', ']', '<', '>', '(', ')', '#', '+', '-', '.', '!', '|', '~', '&', '$'];

/// A text in the making.
#[derive(Debug)]
pub(crate) struct Page {
    markdown: bool,
    text: String,
    /// The last thing added is an item of a list.
    in_list: bool,
}

impl Page {
    /// Empty.
    pub(crate) const fn new(markdown: bool) -> Self {
        Self { markdown, text: String::new(), in_list: false }
    }

    /// Part of a program: `G01`.
    pub(crate) fn code(&self, text: &str) -> String {
        if !self.markdown || text.is_empty() {
            text.to_owned()
        } else if text.contains('`') {
            self.user(text)
        } else {
            format!("`{text}`")
        }
    }

    /// Text of the user, in which nothing is markup.
    pub(crate) fn user(&self, text: &str) -> String {
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
    pub(crate) fn heading(&mut self, name: &str, meaning: &str) {
        let text = if self.markdown { format!("**`{name}`** {meaning}") } else { format!("{name}: {meaning}") };
        self.line(&text);
    }

    /// A sentence that says what the items after it are about.
    pub(crate) fn title(&mut self, text: &str) {
        let text = if self.markdown { format!("**{text}**") } else { text.to_owned() };
        self.line(&text);
    }

    /// A paragraph.
    pub(crate) fn line(&mut self, text: &str) {
        if !self.text.is_empty() {
            self.text.push_str(if self.markdown { "\n\n" } else { "\n" });
        }
        self.text.push_str(text);
        self.in_list = false;
    }

    /// Lines of the user that stay lines.
    pub(crate) fn quote(&mut self, lines: &[&str]) {
        let shown: Vec<String> = lines.iter().map(|line| self.user(line)).collect();
        if !shown.is_empty() {
            self.line(&shown.join(if self.markdown { "  \n" } else { "\n" }));
        }
    }

    /// An item of a list.
    pub(crate) fn item(&mut self, label: &str, value: &str) {
        if self.markdown {
            self.text.push_str(if self.in_list { "\n- " } else { "\n\n- " });
        } else {
            self.text.push('\n');
        }
        self.text.push_str(&format!("{label}: {value}"));
        self.in_list = true;
    }

    /// What follows is about something else.
    pub(crate) fn rule(&mut self) {
        if self.text.is_empty() {
            return;
        }
        if self.markdown {
            self.line("---");
        } else {
            self.text.push('\n');
        }
    }

    /// The text.
    pub(crate) fn finish(self) -> String {
        self.text
    }
}
