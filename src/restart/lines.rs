//! Blocks as lines of a part program, and the numbers that a program leaves free.

use std::path::Path;

use crate::dict::{HIGHEST_BLOCK, HIGHEST_L};
use crate::sure::small;
use crate::syntax::ParsedFile;
use crate::text::last_name;

/// A preamble has fewer blocks.
const PREAMBLE: u64 = 40;

/// Most characters of a line (LEX-7).
const WIDTH: usize = 80;

/// Consecutive numbers that no block has.
#[derive(Clone, Copy, Debug, Eq, PartialEq)]
pub(super) struct Run {
    first: u32,
    last: u32,
}

impl Run {
    const fn count(self) -> u64 {
        (self.last as u64 + 1).saturating_sub(self.first as u64)
    }

    /// The first number of so many blocks, and the step between them.
    fn start(self, blocks: u64) -> (u32, u32) {
        let tens = self.first.next_multiple_of(10);
        let fits = blocks > 0 && u64::from(tens) + blocks * 10 <= u64::from(self.last);
        if fits { (tens, 10) } else { (self.first, 1) }
    }

    /// The largest run of numbers that a program leaves free up to `highest`.
    fn largest(used: &[u32], highest: u32) -> Self {
        let mut best = Self { first: 1, last: 0 };
        let mut first = 1;
        for number in used.iter().copied().filter(|number| *number <= highest).chain([highest + 1]) {
            let run = Self { first, last: number.saturating_sub(1) };
            if number > first && run.count() > best.count() {
                best = run;
            }
            first = number + 1;
        }
        best
    }
}

/// The free numbers of a program.
#[derive(Clone, Debug)]
pub(super) struct Numbers {
    /// Below the highest that a jump can name.
    low: Run,
    /// Of all.
    high: Run,
}

impl Numbers {
    pub fn of(file: &ParsedFile) -> Self {
        let mut used: Vec<u32> = file.block_ids().filter_map(|block| file.number(block)).collect();
        used.sort_unstable();
        used.dedup();
        Self { low: Run::largest(&used, HIGHEST_L), high: Run::largest(&used, HIGHEST_BLOCK) }
    }

    /// Lines for a preamble and for so many blocks behind it: in the run below 9999 what fits there, in steps of ten
    /// where these fit.
    pub fn lines(&self, behind: u64, line_end: &'static str) -> [Lines; 2] {
        let first = self.run(PREAMBLE);
        let (start, step) = first.start(PREAMBLE);
        let after = start + step * small(PREAMBLE as usize);
        let both = Run { first: after, last: first.last };
        let behind = if behind <= both.count() {
            (after, 1)
        } else {
            Run { first: after.max(self.high.first), ..self.high }.start(0)
        };
        [(start, step), behind].map(|(next, step)| Lines { text: String::new(), blocks: 0, next, step, line_end })
    }

    /// The run that so many blocks fit in.
    const fn run(&self, blocks: u64) -> Run {
        if blocks <= self.low.count() { self.low } else { self.high }
    }
}

/// A block as comments name it: one of a macrocycle with its file.
pub(super) fn named(n: u32, file: u32, file_name: &str) -> String {
    if file == 0 { format!("N{n}") } else { format!("{} N{n}", last_name(Path::new(file_name))) }
}

/// A text as comments, one a line: it goes on in the next where one is too short for it.
pub(super) fn comment_lines(text: &str, line_end: &str) -> String {
    let lines = filled(text.split(' '), WIDTH - 2, "");
    lines.into_iter().map(|line| format!("\"{line}\"{line_end}")).collect()
}

/// Parts with a blank between them, in lines of so many characters at most; all but the first are indented.
fn filled<'p>(parts: impl Iterator<Item = &'p str>, width: usize, indent: &str) -> Vec<String> {
    let mut lines: Vec<String> = Vec::new();
    for part in parts {
        match lines.last_mut() {
            Some(line) if line.len() + 1 + part.len() <= width => {
                line.push(' ');
                line.push_str(part);
            }
            Some(_) => lines.push(format!("{indent}{part}")),
            None => lines.push(part.to_owned()),
        }
    }
    lines
}

/// Blocks with their numbers, as text.
#[derive(Clone, Debug, Default)]
pub(super) struct Lines {
    pub text: String,
    /// How many blocks there are.
    pub blocks: u64,
    next: u32,
    step: u32,
    line_end: &'static str,
}

impl Lines {
    /// A block with a comment; it goes on in the next line where one is too short for it.
    pub fn block(&mut self, words: &[String], comment: &str) {
        let number = format!("N{}", self.next);
        self.next = self.next.saturating_add(self.step);
        self.blocks += 1;
        let comment = format!("\"{}\"", comment.chars().take(WIDTH - 4).collect::<String>());
        let comment = Some(comment.as_str()).filter(|comment| comment.len() > 2);
        let parts = std::iter::once(number.as_str()).chain(words.iter().map(String::as_str)).chain(comment);
        for line in filled(parts, WIDTH, "  ") {
            self.text.push_str(&line);
            self.text.push_str(self.line_end);
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn free_numbers() {
        let run = |used: &[u32], highest| {
            let Run { first, last } = Run::largest(used, highest);
            (first, last)
        };
        assert_eq!(run(&[], 9), (1, 9));
        assert_eq!(run(&[1, 2, 7], 9), (3, 6));
        assert_eq!(run(&[5], 9), (1, 4));
        assert_eq!(run(&[2, 9], 9), (3, 8));
        assert_eq!(Run::largest(&[1, 2, 3], 3).count(), 0);
    }

    /// RST-6: comments name what is not restored, in lines of at most 80 characters (LEX-7).
    #[test]
    fn long_comments() {
        let text = "a macrocycle of the machine may have moved A, B, C, U, V, W: move them as it left them";
        let lines = comment_lines(text, "\n");
        assert_eq!(lines.lines().count(), 2, "{lines}");
        assert!(
            lines.lines().all(|line| line.len() <= WIDTH && line.starts_with('"') && line.ends_with('"')),
            "{lines}"
        );
        assert_eq!(lines.replace("\"\n\"", " "), format!("\"{text}\"\n"));
    }

    /// RST-1: a block that is too long for its line goes on in the next.
    #[test]
    fn long_blocks() {
        let mut lines = Lines { text: String::new(), blocks: 0, next: 10, step: 10, line_end: "\n" };
        let words: Vec<String> = (0..12).map(|index| format!("R{index}=12345.678")).collect();
        lines.block(&words, "why");
        lines.block(&["M08".to_owned()], "");
        assert!(lines.text.lines().all(|line| line.len() <= WIDTH), "{}", lines.text);
        assert!(lines.text.ends_with("\"why\"\nN20 M08\n"), "{}", lines.text);
    }
}
