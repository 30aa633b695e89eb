//! A text with its edits, written part by part: the whole of it is nowhere in memory.

use crate::text::{SourceText, Span};

/// An edit: `before`, the text of `copied`, and `after` take the place of `span`.
#[derive(Clone, Copy, Debug, Eq, PartialEq)]
pub(super) struct Written<'a> {
    /// The replaced place.
    pub span: Span,
    /// ASCII, or in UTF-8 any text.
    pub before: &'a str,
    /// A part of the same text.
    pub copied: Option<Span>,
    /// As `before`.
    pub after: &'a str,
}

/// About so many bytes are given on at once.
const PART: usize = 1 << 16;

/// Writes a text with edits, which come in its order. Before the first edit there is nothing to write.
pub(super) struct Output<'a> {
    source: &'a SourceText,
    /// Up to where the text is written.
    at: u32,
    part: String,
    /// How many bytes were given on.
    given: usize,
    /// They are those of the text so far.
    same: bool,
    out: &'a mut dyn FnMut(&str),
}

impl<'a> Output<'a> {
    pub(super) fn new(source: &'a SourceText, out: &'a mut dyn FnMut(&str)) -> Self {
        Self { source, at: 0, part: String::new(), given: 0, same: true, out }
    }

    /// One more edit.
    pub(super) fn write(&mut self, edit: Written<'_>) {
        self.push_source(Span::new(self.at, edit.span.start));
        self.push(edit.before);
        edit.copied.into_iter().for_each(|copied| self.push_source(copied));
        self.push(edit.after);
        self.at = edit.span.end;
    }

    /// Writes the rest; whether the whole is another text.
    pub(super) fn finish(mut self) -> bool {
        if self.at > 0 || self.given + self.part.len() > 0 {
            self.push_source(Span::new(self.at, self.source.len()));
            self.give();
            return !self.same || self.given != self.source.text().len();
        }
        false
    }

    fn push_source(&mut self, span: Span) {
        let source = self.source;
        let mut text = source.slice(span);
        while text.len() > PART {
            let (part, rest) = text.split_at(text.floor_char_boundary(PART));
            self.push(part);
            text = rest;
        }
        self.push(text);
    }

    fn push(&mut self, text: &str) {
        if self.part.len() + text.len() > PART {
            self.give();
        }
        self.part.push_str(text);
    }

    fn give(&mut self) {
        let old = self.source.text().as_bytes().get(self.given..);
        self.same = self.same && old.is_some_and(|old| old.starts_with(self.part.as_bytes()));
        self.given += self.part.len();
        (self.out)(&self.part);
        self.part.clear();
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// From where to where, the text, and what is copied.
    type Edit<'a> = (u32, u32, &'a str, Option<(u32, u32)>);

    /// What comes of a text with edits, in how many parts, and whether it is another one.
    fn written(text: &str, edits: &[Edit<'_>]) -> (String, usize, bool) {
        let source = SourceText::from_text("a", text);
        let (mut all, mut parts) = (String::new(), 0);
        let mut out = |part: &str| {
            all.push_str(part);
            parts += 1;
        };
        let mut output = Output::new(&source, &mut out);
        for &(start, end, before, copied) in edits {
            let copied = copied.map(|(start, end)| Span::new(start, end));
            output.write(Written { span: Span::new(start, end), before, copied, after: "" });
        }
        let changed = output.finish();
        (all, parts, changed)
    }

    #[test]
    fn nothing_without_edits_and_all_with_some() {
        assert_eq!(written("abc", &[]), (String::new(), 0, false));
        assert_eq!(written("abc", &[(1, 1, "-", None)]), ("a-bc".to_owned(), 1, true));
        assert_eq!(written("abcd", &[(0, 2, "", None)]), ("cd".to_owned(), 1, true));
        assert_eq!(written("ab cd", &[(0, 0, "", Some((3, 5))), (2, 5, "", None)]), ("cdab".to_owned(), 1, true));
    }

    /// A text that edits leave as it was is no other one.
    #[test]
    fn the_same_again() {
        assert_eq!(written("abc", &[(1, 2, "b", None)]), ("abc".to_owned(), 1, false));
        assert!(written("abc", &[(2, 3, "", None)]).2);
        assert!(written("abc", &[(3, 3, "c", None)]).2);
    }

    /// Long texts come in parts, which end where characters do.
    #[test]
    fn parts() {
        let text = "ř".repeat(PART);
        let (all, parts, changed) = written(&text, &[(2, 2, "x", None)]);
        assert_eq!((all, changed), (format!("řx{}", &text[2..]), true));
        assert!(parts > 1);
    }
}
