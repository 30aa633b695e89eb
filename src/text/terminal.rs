//! Characters that a terminal must not get as they are.

use std::io::{self, Write};

/// Whether a terminal might act on the character: controls, the marks that reorder text, and characters without a shape
/// of their own, which could hide what a name or a program says.
pub(crate) fn is_unsafe(character: char) -> bool {
    character.is_control()
        || matches!(character,
            '\u{ad}' | '\u{61c}' | '\u{180e}' | '\u{200b}'..='\u{200f}' | '\u{2028}'..='\u{202e}' | '\u{2060}'..='\u{206f}'
            | '\u{fe00}'..='\u{fe0f}' | '\u{feff}' | '\u{fff9}'..='\u{fffb}' | '\u{e0000}'..='\u{e0fff}')
}

/// Writes a part of a string of JSON in which nothing else is to be escaped: what is unsafe as `\uXXXX`, which means
/// the same to every reader of JSON.
pub(crate) fn write_json_safe<W: ?Sized + Write>(out: &mut W, fragment: &str) -> io::Result<()> {
    if !fragment.contains(is_unsafe) {
        return out.write_all(fragment.as_bytes());
    }
    for character in fragment.chars() {
        if is_unsafe(character) {
            for unit in character.encode_utf16(&mut [0; 2]) {
                write!(out, "\\u{unit:04x}")?;
            }
        } else {
            write!(out, "{character}")?;
        }
    }
    Ok(())
}
