//! Colours of a terminal, and none.

/// How a piece of text is painted.
#[derive(Clone, Copy, Debug, Eq, PartialEq)]
pub(in crate::diag) enum Style {
    /// Bold and red.
    Error,
    /// Bold and yellow.
    Warning,
    /// Bold.
    Strong,
    /// Cyan: code, and the words note and help.
    Accent,
    /// Grey: frames.
    Faint,
}

impl Style {
    const fn codes(self) -> &'static str {
        match self {
            Self::Error => "1;31",
            Self::Warning => "1;33",
            Self::Strong => "1",
            Self::Accent => "36",
            Self::Faint => "38;5;246",
        }
    }
}

/// `text` painted when `colour` is on; as it is when it is off.
pub(in crate::diag) fn paint(text: &str, style: Style, colour: bool) -> String {
    if colour { format!("\u{1b}[{}m{text}\u{1b}[0m", style.codes()) } else { text.to_owned() }
}

/// A painted line whose neighbouring pieces of one colour are one piece: a piece a character is several times as long.
pub(super) fn joined(line: &str) -> String {
    const RESET: &str = "\u{1b}[0m";
    let mut result = String::with_capacity(line.len());
    // The sequence in force, and whether its end has been read but not yet written.
    let (mut open, mut ended) = ("", false);
    let mut rest = line;
    while let Some(start) = rest.find('\u{1b}') {
        let (text, sequence) = rest.split_at(start);
        let (code, after) = sequence.split_at(sequence.find('m').map_or(sequence.len(), |end| end + 1));
        rest = after;
        if ended && !(text.is_empty() && code == open) {
            result.push_str(RESET);
            open = "";
        }
        result.push_str(text);
        if code == RESET {
            ended = true;
            continue;
        }
        if !(ended && code == open) {
            result.push_str(code);
            open = code;
        }
        ended = false;
    }
    if ended {
        result.push_str(RESET);
    }
    result.push_str(rest);
    result
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn neighbours_of_one_colour_are_joined() {
        let (red, blue) = (|text| format!("\u{1b}[31m{text}\u{1b}[0m"), |text| format!("\u{1b}[34m{text}\u{1b}[0m"));
        let pieces = [red("a"), red("b"), blue("c"), " ".to_owned(), blue("d"), blue("e"), "f".to_owned(), red("g")];
        let expected = [red("ab"), blue("c"), " ".to_owned(), blue("de"), "f".to_owned(), red("g")];
        assert_eq!(joined(&pieces.concat()), expected.concat());
        assert_eq!(joined("plain"), "plain");
    }
}
