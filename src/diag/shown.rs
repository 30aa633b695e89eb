//! Program text made fit for a message: never raw control characters, never endless.

use std::borrow::Cow;

use crate::text::is_unsafe;

/// Longest piece of program text that a message repeats, in characters.
const LONGEST: usize = 40;

/// `text` as a terminal may have it: what `is_unsafe` finds as `\u{…}`, the rest as it is. The last defence of every
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

/// The name of the control character or foreign blank that `text` is, once or repeated. The text is one that [`shown`]
/// made.
pub(super) fn control_name(text: &str) -> Option<String> {
    if let Some(blank) = text.chars().next().filter(|_| text.chars().all(super::is_blank)) {
        return Some(format!("U+{:04X}", u32::from(blank)));
    }
    let escaped = text.strip_prefix("\\u{")?;
    let (code, _) = escaped.split_once('}')?;
    let unit = format!("\\u{{{code}}}");
    let rest = text.replace(&unit, "");
    if !matches!(rest.as_str(), "" | "…") {
        return None;
    }
    name_of(code)
}

/// The name of the first control character among others in `text`, and the text without it.
pub(super) fn control_inside(text: &str) -> Option<(String, String)> {
    let (before, rest) = text.split_once("\\u{")?;
    let (code, after) = rest.split_once('}')?;
    name_of(code).map(|name| (name, format!("{before}{after}")))
}

/// The name of the character with that code, in hexadecimal digits.
fn name_of(code: &str) -> Option<String> {
    let character = u32::from_str_radix(code, 16).ok().and_then(char::from_u32)?;
    let code = u32::from(character);
    let name = match character {
        '\0' => "NUL",
        '\u{7}' => "BEL",
        '\u{8}' => "BS",
        '\u{b}' => "VT",
        '\u{c}' => "FF",
        '\u{11}' => "XON",
        '\u{13}' => "XOFF",
        '\u{1a}' => "Ctrl-Z",
        '\u{1b}' => "ESC",
        '\u{7f}' => "DEL",
        _ => return Some(format!("U+{code:04X}")),
    };
    Some(format!("{name} ({code:02X}h)"))
}

/// `text` for a message: control characters and bidirectional marks as `\u{…}`, tabs as blanks, shortened in the middle
/// of nowhere.
pub fn shown(text: &str) -> String {
    let mut result = String::new();
    for (count, character) in text.chars().enumerate() {
        if count == LONGEST {
            result.push('…');
            break;
        }
        push_safe(&mut result, if character == '\t' { ' ' } else { character });
    }
    result
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn terminals_get_no_raw_controls() {
        assert_eq!(shown("a\u{1b}[2Jb\u{202e}"), "a\\u{1b}[2Jb\\u{202e}");
        assert_eq!(shown("N20\tG1"), "N20 G1");
        assert_eq!(shown(&"x".repeat(100)).chars().count(), LONGEST + 1);
    }

    #[test]
    fn characters_that_do_not_show_are_named() {
        let inside = |text: &str| control_inside(&shown(text));
        assert_eq!(inside("X\u{0}6"), Some(("NUL (00h)".to_owned(), "X6".to_owned())));
        assert_eq!(inside("X\u{feff}6"), Some(("U+FEFF".to_owned(), "X6".to_owned())));
        assert_eq!(inside("X6"), None);
    }

    #[test]
    fn only_what_is_unsafe_is_escaped() {
        assert!(matches!(terminal_safe("příruba ⌀50 „x“ → 日本"), Cow::Borrowed(_)));
        assert_eq!(terminal_safe("a\tb\u{85}\u{61c}c\nd"), "a\\u{9}b\\u{85}\\u{61c}c\\u{a}d");
    }
}
