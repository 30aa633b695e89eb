//! Program text made fit for a message: never raw control characters, never endless.

/// Longest piece of program text that a message repeats, in characters.
const LONGEST: usize = 40;

/// Whether a terminal might act on the character: controls, and the marks that reorder text.
pub(crate) fn is_unsafe(character: char) -> bool {
    character.is_control()
        || matches!(character, '\u{200b}'..='\u{200f}' | '\u{2028}'..='\u{202e}' | '\u{2060}'..='\u{2069}' | '\u{feff}')
}

/// `text` for a message: control characters and bidirectional marks as `\u{…}`, shortened in the middle of nowhere.
pub fn shown(text: &str) -> String {
    let mut result = String::new();
    for (count, character) in text.chars().enumerate() {
        if count == LONGEST {
            result.push('…');
            break;
        }
        if is_unsafe(character) {
            result.extend(character.escape_unicode());
        } else {
            result.push(character);
        }
    }
    result
}

/// A list of paths for a message: as [`shown`], but not shortened.
pub fn shown_path_list(paths: &str) -> String {
    paths.chars().flat_map(|c| if is_unsafe(c) { c.escape_unicode().collect::<Vec<_>>() } else { vec![c] }).collect()
}

/// A list as in prose: `a, b or c` with the given last joint.
pub fn one_of(items: &[String], joint: &str) -> String {
    match items {
        [] => String::new(),
        [only] => only.clone(),
        [first @ .., last] => format!("{} {joint} {last}", first.join(", ")),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn terminals_get_no_raw_controls() {
        assert_eq!(shown("a\u{1b}[2Jb\u{202e}"), "a\\u{1b}[2Jb\\u{202e}");
        assert_eq!(shown(&"x".repeat(100)).chars().count(), LONGEST + 1);
    }
}
