//! The errors of the TOML parser in our own words (E0701).

use toml_edit::{Document, TomlError};

use super::reader::to_span;
use super::sections::is_list;
use crate::diag::{ConfigProblem, shown};
use crate::text::Span;

/// How the parser's messages begin, and what we say instead; the first that fits counts.
const PROBLEMS: &[(&str, ConfigProblem)] = &[
    ("missing escaped value", ConfigProblem::Escape),
    ("too few unicode value digits", ConfigProblem::Escape),
    ("string values must be quoted", ConfigProblem::UnquotedText),
    ("missing value", ConfigProblem::NoValue),
    ("invalid value", ConfigProblem::NoValue),
    ("key with no value", ConfigProblem::NoEquals),
    ("missing assignment", ConfigProblem::NoEquals),
    ("unquoted keys cannot be empty", ConfigProblem::KeyForm),
    ("invalid unquoted key", ConfigProblem::KeyForm),
    ("keys cannot be multi-line", ConfigProblem::KeyForm),
    ("invalid boolean", ConfigProblem::FlagForm),
    ("unclosed", ConfigProblem::BracketOpen),
    ("extra comma", ConfigProblem::Comma),
    ("missing comma", ConfigProblem::Comma),
    ("missing key for inline table element", ConfigProblem::Comma),
    ("unexpected key or value", ConfigProblem::OneKeyALine),
    ("unexpected content", ConfigProblem::OneKeyALine),
    ("integer number overflowed", ConfigProblem::NumberTooLarge),
    ("floating-point number overflowed", ConfigProblem::NumberTooLarge),
    ("unexpected leading zero", ConfigProblem::NumberForm),
    ("`_` may only go between digits", ConfigProblem::NumberForm),
    ("invalid mantissa", ConfigProblem::NumberForm),
    ("invalid fraction", ConfigProblem::NumberForm),
    ("invalid exponent", ConfigProblem::NumberForm),
    ("radix must be lowercase", ConfigProblem::NumberForm),
    ("integers with a radix", ConfigProblem::NumberForm),
    ("redundant", ConfigProblem::NumberForm),
    ("unexpected sign", ConfigProblem::NumberForm),
    ("invalid hexadecimal number", ConfigProblem::NumberForm),
    ("invalid octal number", ConfigProblem::NumberForm),
    ("invalid binary number", ConfigProblem::NumberForm),
    ("carriage return must be followed by newline", ConfigProblem::LineEnd),
    ("invalid comment character", ConfigProblem::ControlCharacter),
    ("cannot recurse further", ConfigProblem::TooDeep),
    ("recursion limit", ConfigProblem::TooDeep),
];

/// The mistake in `text`, of which the parser says `error`, and where reading broke off.
pub(super) fn toml_problem(text: &str, error: &TomlError) -> (ConfigProblem, Span) {
    match earlier(text, error) {
        Some(first) => problem(text, &first),
        None => problem(text, error),
    }
}

/// The parser looks at the form of the whole text before it looks at the values: the fault in an earlier line, if any.
fn earlier(text: &str, error: &TomlError) -> Option<TomlError> {
    let before = text.get(..error.span()?.start)?;
    let lines = before.get(..before.rfind('\n')? + 1)?;
    // Brackets and texts of many lines may be open only because the lines end here.
    let open = |error: &TomlError| error.message().starts_with("unclosed") || error.message().contains("multi-line");
    Document::parse(lines).err().filter(|error| !open(error))
}

fn problem(text: &str, error: &TomlError) -> (ConfigProblem, Span) {
    let range = error.span().unwrap_or(0..0);
    let message = error.message();
    let there = text.get(range.clone()).unwrap_or_default();
    let problem = if message.starts_with("duplicate key") {
        if is_list(there)
            && text.get(..range.start).is_some_and(|before| before.ends_with('[') && !before.ends_with("[["))
        {
            ConfigProblem::ListAsTable { key: shown(there) }
        } else {
            ConfigProblem::KeyTwice { key: shown(there) }
        }
    } else if message.starts_with("cannot extend value") {
        ConfigProblem::KeyHasValue { key: shown(there) }
    } else if message.contains(" string, expected `") {
        // `invalid basic string, expected `"`` and its like: the quote is missing where the line ends.
        ConfigProblem::TextOpen
    } else if message.contains(" string, expected ") && !message.starts_with("string") {
        ConfigProblem::ControlCharacter
    } else {
        PROBLEMS
            .iter()
            .find(|(beginning, _)| message.starts_with(beginning))
            .map_or(ConfigProblem::NotToml, |(_, problem)| problem.clone())
    };
    let comma = text.get(range.start..).is_some_and(|rest| rest.starts_with(','));
    let problem = if problem == ConfigProblem::OneKeyALine && comma {
        ConfigProblem::DecimalComma
    } else if problem == ConfigProblem::UnquotedText && there.is_empty() {
        ConfigProblem::NoValue
    } else {
        problem
    };
    (problem, to_span(range))
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::dict::Lang;

    fn told(text: &str) -> (ConfigProblem, Span) {
        toml_problem(text, &Document::parse(text).expect_err(text))
    }

    /// §11: our own words report malformed TOML; when a new parser changes its messages, this test shows it.
    #[test]
    fn the_parsers_messages_in_our_words() {
        for (text, expected) in [
            ("a = \"cnc872\n", ConfigProblem::TextOpen),
            ("a = 'x", ConfigProblem::TextOpen),
            ("a = \"\"\"x", ConfigProblem::TextOpen),
            ("a = \"\u{1}\"", ConfigProblem::ControlCharacter),
            ("a = 5 # \u{7f}", ConfigProblem::ControlCharacter),
            ("a = \"C:\\data\"", ConfigProblem::Escape),
            ("a = \"\\u12\"", ConfigProblem::Escape),
            ("a = ", ConfigProblem::NoValue),
            ("a = yes", ConfigProblem::UnquotedText),
            ("a = tru", ConfigProblem::FlagForm),
            ("a", ConfigProblem::NoEquals),
            ("a: 5", ConfigProblem::NoEquals),
            ("= 5", ConfigProblem::KeyForm),
            ("ž = 5", ConfigProblem::KeyForm),
            ("[]", ConfigProblem::KeyForm),
            ("[a", ConfigProblem::BracketOpen),
            ("[[a]", ConfigProblem::BracketOpen),
            ("a = [1,", ConfigProblem::BracketOpen),
            ("a = {b=1,,c=2}", ConfigProblem::Comma),
            ("a=1 b=2", ConfigProblem::OneKeyALine),
            ("a = 25,5", ConfigProblem::DecimalComma),
            ("a = 99999999999999999999", ConfigProblem::NumberTooLarge),
            ("a = 1e999", ConfigProblem::NumberTooLarge),
            ("a = 0123", ConfigProblem::NumberForm),
            ("a = 1__0", ConfigProblem::NumberForm),
            ("a = .5", ConfigProblem::NumberForm),
            ("a = 5.", ConfigProblem::NumberForm),
            ("a = 1e", ConfigProblem::NumberForm),
            ("a = 0xZZ", ConfigProblem::NumberForm),
            ("a = 1\r b = 2", ConfigProblem::LineEnd),
            ("a = 2024-13-45", ConfigProblem::NotToml),
            ("{", ConfigProblem::NotToml),
        ] {
            assert_eq!(told(text).0, expected, "{text}");
        }
    }

    #[test]
    fn places_and_names() {
        let (found, at) = told("dialect = \"a\"\n dialect = \"b\"\n");
        assert_eq!(found, ConfigProblem::KeyTwice { key: "dialect".to_owned() });
        assert_eq!(at, Span::new(15, 22));
        assert_eq!(told("a = 1\na.b = 2").0, ConfigProblem::KeyHasValue { key: "a".to_owned() });
        assert_eq!(told("a = \"x\ny").1, Span::empty(6));
        assert!(found.text(Lang::Cs).contains("dvakrát"));
    }

    /// The first fault of the text is reported, in whatever order the parser meets them.
    #[test]
    fn the_first_fault() {
        assert_eq!(told("a = \"x\nb 5\n"), (ConfigProblem::TextOpen, Span::empty(6)));
        assert_eq!(told("a = [\n1,\n2\n3]\nb 5\n").0, ConfigProblem::Comma);
        assert_eq!(told("a = 1\na = 2\nb 5\n").1, Span::new(6, 7));
        assert_eq!(told("a = \"\"\"\nx\"\"\" 5").0, ConfigProblem::OneKeyALine);
        // The end of a line is not cut in two.
        assert_eq!(told("a = 1\r\na = 2\r\n").1, Span::new(7, 8));
    }

    /// Deep nesting and long paths are refused, not followed.
    #[test]
    fn deep_nesting_is_refused() {
        let brackets = format!("a = {}1{}", "[".repeat(100_000), "]".repeat(100_000));
        let path = format!("[{}]", vec!["a"; 100_000].join("."));
        assert_eq!(told(&brackets).0, ConfigProblem::TooDeep);
        assert_eq!(told(&path).0, ConfigProblem::TooDeep);
    }
}
