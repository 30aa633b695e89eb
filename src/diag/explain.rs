//! The pages of the diagnostics: shown on a terminal, listed, and taken apart for the tests.
//!
//! Pages are Markdown, of which they use headings, paragraphs with inline code, lists, fenced code and comments.

use super::render::style::{Style, paint};
use super::{Code, Severity};
use crate::dict::Lang;
use crate::sure::Sure;

/// A fenced piece of code of a page.
#[derive(Clone, Debug, Eq, PartialEq)]
pub struct Example<'a> {
    /// The words behind the fence: the language, then what tests need to know, as in `nc expect=E0306 macro`.
    pub info: Vec<&'a str>,
    /// The code, each line with a line feed.
    pub text: String,
}

impl<'a> Example<'a> {
    /// The value of the word `name=…` behind the fence.
    pub fn option(&self, name: &str) -> Option<&'a str> {
        self.info.iter().find_map(|word| word.strip_prefix(name)?.strip_prefix('='))
    }

    /// Whether the fence has the word.
    pub fn has(&self, word: &str) -> bool {
        self.info.contains(&word)
    }

    /// The name of the file that the code is: `as=L9001`, or a second word that is no option, as in `xml Channel.xml`;
    /// for TOML the project file.
    pub fn file_name(&self) -> Option<&'a str> {
        self.option("as").or(match self.info.as_slice() {
            ["toml", ..] => Some("cnc872c.toml"),
            ["xml", name, ..] => Some(name),
            _ => None,
        })
    }
}

/// Every fenced piece of code of a page, in order.
pub fn examples(page: &str) -> Vec<Example<'_>> {
    blocks(page)
        .into_iter()
        .filter_map(|block| match block {
            Block::Code(example) => Some(example),
            Block::Heading(_) | Block::Text(_) => None,
        })
        .collect()
}

/// The page of a diagnostic for a terminal: headings bold, code indented, comments and the words behind fences left
/// out.
pub fn page(code: Code, lang: Lang, colour: bool) -> String {
    terminal(code.page(lang), colour)
}

/// The page of a diagnostic as Markdown for readers: comments, and what tests need to know behind fences, left out.
pub(super) fn markdown(code: Code, lang: Lang) -> String {
    let mut result = String::new();
    for block in blocks(code.page(lang)) {
        if !result.is_empty() {
            result.push('\n');
        }
        match block {
            Block::Heading((level, heading)) => result.push_str(&format!("{} {heading}\n", "#".repeat(level))),
            Block::Text(lines) => lines.iter().for_each(|line| result.push_str(&format!("{line}\n"))),
            Block::Code(Example { info, text }) => {
                result.push_str(&format!("```{}\n{text}```\n", info.first().copied().unwrap_or_default()));
            }
        }
    }
    result
}

/// Every diagnostic in one line: code, name, level, and the first sentence of its page.
pub fn list(lang: Lang) -> String {
    let names = Code::ALL.iter().map(|code| code.name().len()).max().unwrap_or(0);
    let level = |code: Code| match (code.severity(), lang) {
        (_, Lang::En) if code.is_off() => "off    ",
        (_, Lang::Cs) if code.is_off() => "vypnuto ",
        (Severity::Error, Lang::En) => "error  ",
        (Severity::Warning, Lang::En) => "warning",
        (Severity::Error, Lang::Cs) => "chyba   ",
        (Severity::Warning, Lang::Cs) => "varování",
    };
    Code::ALL
        .iter()
        .map(|&code| format!("{code}  {:names$}  {}  {}\n", code.name(), level(code), first_sentence(code, lang)))
        .collect()
}

/// The first sentence of the page, which says what the diagnostic is about.
pub fn first_sentence(code: Code, lang: Lang) -> String {
    let text = blocks(code.page(lang)).into_iter().find_map(|block| match block {
        Block::Text(lines) => Some(lines.join(" ")),
        Block::Heading(_) | Block::Code(_) => None,
    });
    let text = text.unwrap_or_default();
    match text.find(". ") {
        Some(end) => text.get(..=end).sure().to_owned(),
        None => text,
    }
}

/// A part of a page.
enum Block<'a> {
    /// A heading with its level.
    Heading((usize, &'a str)),
    /// Lines of a paragraph or of a list.
    Text(Vec<&'a str>),
    /// Fenced code.
    Code(Example<'a>),
}

fn blocks(page: &str) -> Vec<Block<'_>> {
    let mut blocks = Vec::new();
    let mut text = Vec::new();
    let mut lines = page.lines();
    while let Some(line) = lines.next() {
        let line = line.trim_end();
        let level = line.bytes().take_while(|&byte| byte == b'#').count();
        let heading = line.get(level..).and_then(|rest| rest.strip_prefix(' ')).filter(|_| level > 0);
        let fence = line.strip_prefix("```");
        let comment = line.starts_with("<!--");
        if (heading.is_some() || fence.is_some() || comment || line.is_empty()) && !text.is_empty() {
            blocks.push(Block::Text(std::mem::take(&mut text)));
        }
        if let Some(heading) = heading {
            blocks.push(Block::Heading((level, heading)));
        } else if let Some(info) = fence {
            let code = lines.by_ref().take_while(|line| line.trim_end() != "```");
            let text = code.flat_map(|line| [line, "\n"]).collect();
            blocks.push(Block::Code(Example { info: info.split_whitespace().collect(), text }));
        } else if comment {
            if !line.contains("-->") {
                lines.by_ref().find(|line| line.contains("-->"));
            }
        } else if !line.is_empty() {
            text.push(line);
        }
    }
    if !text.is_empty() {
        blocks.push(Block::Text(text));
    }
    blocks
}

/// A page as a terminal shows it: headings bold, code indented, tables in columns.
pub fn terminal(page: &str, colour: bool) -> String {
    let mut result = String::new();
    let mut blocks = blocks(page).into_iter().peekable();
    while let Some(block) = blocks.next() {
        // A heading over nothing: its text was a comment.
        let over_nothing =
            matches!((&block, blocks.peek()), (Block::Heading((2.., _)), None | Some(Block::Heading(_))));
        if over_nothing {
            continue;
        }
        if !result.is_empty() {
            result.push('\n');
        }
        match block {
            Block::Heading((_, heading)) => {
                result.push_str(&paint(heading, Style::Strong, colour));
                result.push('\n');
            }
            Block::Text(lines) if lines.iter().all(|line| line.starts_with('|')) => {
                push_table(&mut result, &lines, colour);
            }
            Block::Text(lines) => push_text(&mut result, &lines, colour),
            Block::Code(example) => {
                if let Some(name) = example.file_name() {
                    result.push_str(&format!("    {}\n", paint(&format!("{name}:"), Style::Faint, colour)));
                }
                for line in example.text.lines() {
                    if !line.is_empty() {
                        result.push_str("    ");
                        result.push_str(&paint(line, Style::Accent, colour));
                    }
                    result.push('\n');
                }
            }
        }
    }
    result
}

/// Most characters of a line of a table; the last column is broken.
const TABLE_WIDTH: usize = 110;

/// Appends a table: columns under one another, the heads bold, without the signs that Markdown needs.
fn push_table(result: &mut String, lines: &[&str], colour: bool) {
    let cells = |line: &str| -> Vec<String> {
        let line = line.trim_matches('|').replace("\\|", "\u{0}");
        line.split('|').map(|cell| cell.trim().replace('\u{0}', "|").replace('`', "")).collect()
    };
    let is_rule = |line: &&&str| line.chars().all(|character| matches!(character, '|' | '-' | ':' | ' '));
    let rows: Vec<Vec<String>> = lines.iter().filter(|line| !is_rule(line)).map(|line| cells(line)).collect();
    let columns = rows.iter().map(Vec::len).max().unwrap_or(0);
    let width = |column: usize| {
        let lengths = rows.iter().filter_map(|row| row.get(column)).map(|cell| cell.chars().count());
        lengths.max().unwrap_or(0)
    };
    let indent: usize = (0..columns.saturating_sub(1)).map(|column| width(column) + 2).sum();
    for (at, row) in rows.iter().enumerate() {
        let mut line = String::new();
        for (column, cell) in row.iter().enumerate() {
            if column + 1 < columns {
                line.push_str(cell);
                line.extend(std::iter::repeat_n(' ', width(column) + 2 - cell.chars().count()));
            } else {
                let room = TABLE_WIDTH.saturating_sub(indent).max(20);
                line.push_str(&broken(cell, room).join(&format!("\n{}", " ".repeat(indent))));
            }
        }
        result.push_str(&paint(line.trim_end(), Style::Strong, colour && at == 0));
        result.push('\n');
    }
}

/// The text in lines of at most so many characters, broken at blanks.
fn broken(text: &str, room: usize) -> Vec<String> {
    let mut lines: Vec<String> = vec![String::new()];
    for word in text.split(' ') {
        let Some(last) = lines.last_mut() else { continue };
        if last.is_empty() {
            last.push_str(word);
        } else if last.chars().count() + 1 + word.chars().count() > room {
            lines.push(word.to_owned());
        } else {
            last.push(' ');
            last.push_str(word);
        }
    }
    lines
}

/// Appends a paragraph; in colour, what stands between backquotes is painted instead.
fn push_text(result: &mut String, lines: &[&str], colour: bool) {
    let mut code = false;
    for line in lines {
        if colour {
            for (index, piece) in line.split('`').enumerate() {
                code ^= index > 0;
                result.push_str(&paint(piece, Style::Accent, code && !piece.is_empty()));
            }
        } else {
            result.push_str(line);
        }
        result.push('\n');
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_table_in_columns() {
        let page = "# T\n\n| there | here |\n|---|---|\n| `O1001`, `x` | `%1001` |\n| a \\| b | word word |\n";
        assert_eq!(terminal(page, false), "T\n\nthere     here\nO1001, x  %1001\na | b     word word\n");
        let long = format!("| a | b |\n|---|---|\n| x | {} |\n", "word ".repeat(40));
        assert!(terminal(&long, false).lines().all(|line| line.chars().count() <= TABLE_WIDTH));
    }

    const PAGE: &str = "# E0000: test-page\n\nUse `N10\nG0` or `X`.\nMore.\n\n## Example\n\n<!-- no example:\nnone \
        -->\n\n## Why\n- `a`: b\n```nc expect=E0306,E0307 macro as=L9001\n%1\n\nN10\n```\n```toml\na = 1\n```\n";

    #[test]
    fn a_page_without_colour() {
        insta::assert_snapshot!(terminal(PAGE, false), @"
        E0000: test-page

        Use `N10
        G0` or `X`.
        More.

        Why

        - `a`: b

            L9001:
            %1

            N10

            cnc872c.toml:
            a = 1
        ");
    }

    #[test]
    fn all_pages_as_markdown() {
        for &code in Code::ALL {
            for lang in [Lang::En, Lang::Cs] {
                let text = markdown(code, lang);
                assert!(text.starts_with(&format!("# {code}: {}\n\n", code.name())), "{text}");
                assert!(!text.contains("expect=") && !text.contains("<!--"), "{text}");
                let plain = |text: &str| examples(text).into_iter().map(|example| example.text).collect::<Vec<_>>();
                assert_eq!(plain(&text), plain(code.page(lang)), "{code}");
            }
        }
    }

    #[test]
    fn a_page_in_colour() {
        insta::assert_snapshot!(terminal(PAGE, true).replace('\u{1b}', "^"), @"
        ^[1mE0000: test-page^[0m

        Use ^[36mN10^[0m
        ^[36mG0^[0m or ^[36mX^[0m.
        More.

        ^[1mWhy^[0m

        - ^[36ma^[0m: b

            ^[38;5;246mL9001:^[0m
            ^[36m%1^[0m

            ^[36mN10^[0m

            ^[38;5;246mcnc872c.toml:^[0m
            ^[36ma = 1^[0m
        ");
    }

    #[test]
    fn the_examples_of_a_page() {
        let found = examples(PAGE);
        assert_eq!(found.len(), 2);
        let example = found.first().unwrap();
        assert_eq!(example.info, ["nc", "expect=E0306,E0307", "macro", "as=L9001"]);
        assert_eq!(example.text, "%1\n\nN10\n");
        assert_eq!((example.option("expect"), example.option("dialect")), (Some("E0306,E0307"), None));
        assert!(example.has("macro") && !example.has("ok"));
        let crlf = PAGE.replace('\n', "\r\n");
        assert_eq!(examples(&crlf), found);
        assert_eq!(terminal(&crlf, true), terminal(PAGE, true));
    }

    /// Every page, in both languages: begins with its code and name, shows what is wrong and what is right, names its
    /// rule, and nothing of its Markdown reaches the terminal.
    #[test]
    fn all_pages() {
        for &code in Code::ALL {
            for (lang, rule) in [(Lang::En, "Rule: "), (Lang::Cs, "Pravidlo: ")] {
                let text = code.page(lang);
                let plain = page(code, lang, false);
                assert!(text.starts_with(&format!("# {code}: {}\n\n", code.name())), "{code}");
                assert!(text.ends_with('\n') && text.lines().last().unwrap().starts_with(rule), "{code} {lang:?}");
                assert!(!plain.contains("```") && !plain.contains("<!--") && !plain.contains("expect="), "{code}");
                let examples = examples(text);
                let expects =
                    |example: &Example<'_>| example.option("expect").is_some_and(|it| it.contains(code.as_str()));
                assert!(examples.iter().any(expects) || text.contains("<!-- no example: "), "{code} {lang:?}");
            }
        }
    }

    #[test]
    fn the_list_has_a_line_for_each() {
        for lang in [Lang::En, Lang::Cs] {
            let list = list(lang);
            assert_eq!(list.lines().count(), Code::ALL.len());
            for (line, code) in list.lines().zip(Code::ALL) {
                assert!(line.starts_with(code.as_str()) && line.ends_with('.'), "{line}");
            }
        }
        insta::assert_snapshot!(list(Lang::Cs).lines().take(3).collect::<Vec<_>>().join("\n"), @"
        E0101  unknown-character            chyba     Mimo komentář je znak, který jazyk partprogramu nezná.
        E0102  split-number                 chyba     Uvnitř čísla nebo mezi znaménkem a číslicemi je mezera nebo tabulátor.
        E0103  missing-value                chyba     Za adresou chybí číslo.
        ");
    }
}
