//! Program text made fit for a message: never raw control characters, never endless.

use std::borrow::Cow;

use crate::text::is_unsafe;

/// Longest piece of program text that a message repeats, in characters.
const LONGEST: usize = 40;

/// `text` as a terminal may have it: what [`is_unsafe`] finds as `\u{…}`, the rest as it is. The last defence of every
/// rendering for people, whatever a message repeats.
pub fn terminal_safe(text: &str) -> Cow<'_, str> {
    if !text.chars().any(is_unsafe) {
        return Cow::Borrowed(text);
    }
    let mut result = String::with_capacity(text.len() + 16);
    for character in text.chars() {
        push_safe(&mut result, character);
    }
    Cow::Owned(result)
}

fn push_safe(result: &mut String, character: char) {
    if is_unsafe(character) {
        result.extend(character.escape_unicode());
    } else {
        result.push(character);
    }
}

/// `text` for a message: control characters and bidirectional marks as `\u{…}`, shortened in the middle of nowhere.
pub fn shown(text: &str) -> String {
    let mut result = String::new();
    for (count, character) in text.chars().enumerate() {
        if count == LONGEST {
            result.push('…');
            break;
        }
        push_safe(&mut result, character);
    }
    result
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn terminals_get_no_raw_controls() {
        assert_eq!(shown("a\u{1b}[2Jb\u{202e}"), "a\\u{1b}[2Jb\\u{202e}");
        assert_eq!(shown(&"x".repeat(100)).chars().count(), LONGEST + 1);
    }

    #[test]
    fn only_what_is_unsafe_is_escaped() {
        assert!(matches!(terminal_safe("příruba ⌀50 „x“ → 日本"), Cow::Borrowed(_)));
        assert_eq!(terminal_safe("a\tb\u{85}\u{61c}c\nd"), "a\\u{9}b\\u{85}\\u{61c}c\\u{a}d");
    }
}
