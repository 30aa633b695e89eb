//! The edits of a fix, gathered where they are many.

use std::borrow::Cow;

use super::places::Places;
use crate::diag::Edit;
use crate::text::Span;

/// So many edits are given one by one.
const FEW: usize = 100;
/// Most bytes between two edits that become one.
const NEAR: u32 = 256;
/// Most bytes of an edit to which another one is added.
const LONG: usize = 4096;

/// The edits in order, those that are near each other as one when there are many: a file in lower case has one for each
/// letter, and places take many times the room of the text.
pub(super) fn gathered<'e>(edits: &'e [Edit], places: &Places<'_>) -> Cow<'e, [Edit]> {
    if edits.len() <= FEW {
        return Cow::Borrowed(edits);
    }
    let mut gathered: Vec<Edit> = Vec::new();
    for edit in edits {
        match gathered.last_mut().and_then(|last| Some((between(last, edit, places)?, last))) {
            Some((text, last)) => {
                last.text.push_str(text);
                last.text.push_str(&edit.text);
                last.at.span.end = edit.at.span.end;
            }
            None => gathered.push(edit.clone()),
        }
    }
    Cow::Owned(gathered)
}

/// The text between two edits that can become one: the same in every code page.
fn between<'p>(last: &Edit, next: &Edit, places: &Places<'p>) -> Option<&'p str> {
    let (from, to) = (last.at.span.end, next.at.span.start);
    let joins = last.at.file == next.at.file && from <= to && to - from <= NEAR && last.text.len() < LONG;
    let text = places.source(last.at.file).filter(|_| joins)?.slice(Span::new(from, to));
    text.is_ascii().then_some(text)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::diag::render::samples;
    use crate::text::{FileId, Location};

    /// A text after the edits.
    fn applied(text: &str, edits: &[Edit]) -> String {
        let mut text = text.to_owned();
        for edit in edits.iter().rev() {
            text.replace_range(edit.at.span.range(), &edit.text);
        }
        text
    }

    #[test]
    fn many_become_few_that_do_the_same() {
        let text = format!("%1\n{}", "n10 x5 \"příruba\" y7\n".repeat(1000));
        let sources = samples::sources(&[("a.nc", text.as_bytes())]);
        let places = Places::new(&sources);
        let edit = |(at, letter): (usize, char)| {
            let at = u32::try_from(at).unwrap();
            let at = Location { file: FileId(0), span: Span::new(at, at + 1) };
            Edit { at, text: letter.to_ascii_uppercase().to_string() }
        };
        let is_word = |letter: char| matches!(letter, 'n' | 'x' | 'y');
        let edits: Vec<Edit> = text.char_indices().filter(|&(_, letter)| is_word(letter)).map(edit).collect();
        let gathered = gathered(&edits, &places);
        // A comment with letters that differ between code pages stands between them.
        assert_eq!((edits.len(), gathered.len()), (3000, 1001));
        assert_eq!(applied(&text, &gathered), applied(&text, &edits));
        assert!(gathered.iter().all(|edit| edit.text.is_ascii()));
        assert!(matches!(super::gathered(&edits[..FEW], &places), Cow::Borrowed(_)));
    }
}
