//! `--diff`: what fixing, formatting or renumbering would change, as a unified diff.

use std::ops::Range;

use imara_diff::{Algorithm, Diff, InternedInput, Interner};

use crate::diag::terminal_safe;
use crate::text::{Encoding, SourceText};

/// Lines that a hunk shows around what changes.
const CONTEXT: usize = 3;

/// The lines of a file, each with its line feed: `patch` knows no other line ends, so that a file which has only
/// carriage returns is one line.
pub fn lines(bytes: &[u8]) -> Vec<Vec<u8>> {
    bytes.split_inclusive(|&byte| byte == b'\n').map(<[u8]>::to_vec).collect()
}

/// The lines of a file as a terminal may have them: decoded, no control characters, line ends alike.
pub fn safe_lines(bytes: &[u8], encoding: Encoding) -> Vec<Vec<u8>> {
    let Ok(source) = SourceText::decode("", bytes.to_vec(), encoding) else { return Vec::new() };
    let text = source.text();
    let end = if text.contains('\n') { '\n' } else { '\r' };
    let line = |line: &str| {
        let text = line.trim_end_matches(['\r', '\n']);
        let end = if line.ends_with(end) { "\n" } else { "" };
        format!("{}{end}", terminal_safe(text)).into_bytes()
    };
    text.split_inclusive(end).map(line).collect()
}

/// The unified diff of a file, `---` and `+++` with its name included; nothing when the lines are the same. `colors`
/// marks what goes and what comes.
pub fn unified(name: &str, before: &[Vec<u8>], after: &[Vec<u8>], colors: bool) -> Vec<u8> {
    let changes = changes(before, after);
    let mut out = Vec::new();
    if changes.is_empty() {
        return out;
    }
    let name = terminal_safe(name);
    // A tab ends a name with blanks in it.
    let end = if name.contains(' ') { "\t" } else { "" };
    out.extend_from_slice(format!("--- {name}{end}\n+++ {name}{end}\n").as_bytes());
    let near = |a: &Change, b: &Change| b.before.start - a.before.end <= 2 * CONTEXT;
    for hunk in changes.chunk_by(near) {
        self::hunk(&mut out, hunk, before, after, colors);
    }
    out
}

/// Lines that are replaced by others; either may be none.
#[derive(Clone, Debug, Eq, PartialEq)]
struct Change {
    before: Range<usize>,
    after: Range<usize>,
}

/// What differs, in order.
fn changes(before: &[Vec<u8>], after: &[Vec<u8>]) -> Vec<Change> {
    let interner = Interner::new(before.len() + after.len());
    let mut input = InternedInput { before: Vec::new(), after: Vec::new(), interner };
    input.update_before(before.iter());
    input.update_after(after.iter());
    let mut diff = Diff::compute(Algorithm::Histogram, &input);
    diff.postprocess_no_heuristic(&input);
    let lines = |range: Range<u32>| range.start as usize..range.end as usize;
    diff.hunks().map(|hunk| Change { before: lines(hunk.before), after: lines(hunk.after) }).collect()
}

fn hunk(out: &mut Vec<u8>, changes: &[Change], before: &[Vec<u8>], after: &[Vec<u8>], colors: bool) {
    let (Some(first), Some(last)) = (changes.first(), changes.last()) else { return };
    let lead = first.before.start.min(CONTEXT);
    let trail = (before.len() - last.before.end).min(CONTEXT);
    let header = |range: Range<usize>| match range.len() {
        // Without lines the number is that of the line before.
        0 => format!("{},0", range.start),
        1 => format!("{}", range.start + 1),
        length => format!("{},{length}", range.start + 1),
    };
    let old = header(first.before.start - lead..last.before.end + trail);
    let new = header(first.after.start - lead..last.after.end + trail);
    out.extend_from_slice(format!("@@ -{old} +{new} @@\n").as_bytes());
    let mut at = first.before.start - lead;
    for change in changes {
        write(out, b' ', before.get(at..change.before.start), None);
        write(out, b'-', before.get(change.before.clone()), colors.then_some("\u{1b}[31m"));
        write(out, b'+', after.get(change.after.clone()), colors.then_some("\u{1b}[32m"));
        at = change.before.end;
    }
    write(out, b' ', before.get(at..at + trail), None);
}

fn write(out: &mut Vec<u8>, sign: u8, lines: Option<&[Vec<u8>]>, color: Option<&str>) {
    for line in lines.unwrap_or_default() {
        let text = line.strip_suffix(b"\n").unwrap_or(line);
        out.extend_from_slice(color.unwrap_or_default().as_bytes());
        out.push(sign);
        out.extend_from_slice(text);
        if color.is_some() {
            out.extend_from_slice(b"\x1b[0m");
        }
        out.push(b'\n');
        if text.len() == line.len() {
            out.extend_from_slice(b"\\ No newline at end of file\n");
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn diff(before: &str, after: &str) -> String {
        String::from_utf8(unified("a.nc", &lines(before.as_bytes()), &lines(after.as_bytes()), false)).unwrap()
    }

    #[test]
    fn lines_that_are_alike() {
        assert_eq!(diff("", ""), "");
        assert_eq!(diff("%1\nN1 M30\n", "%1\nN1 M30\n"), "");
    }

    #[test]
    fn a_hunk_for_changes_that_are_near() {
        let text =
            |x: &str| format!("1\n2\n3\n4\n5 {x}\n6\n7\n8\n9\n10\n11 {x}\n12\n13\n14\n15\n16\n17\n18\n19 {x}\r\n20");
        assert_eq!(
            diff(&text("x"), &text("X")),
            "--- a.nc\n+++ a.nc\n@@ -2,13 +2,13 @@\n 2\n 3\n 4\n-5 x\n+5 X\n 6\n 7\n 8\n 9\n 10\n-11 x\n+11 X\n 12\n \
             13\n 14\n@@ -16,5 +16,5 @@\n 16\n 17\n 18\n-19 x\r\n+19 X\r\n 20\n\\ No newline at end of file\n"
        );
    }

    #[test]
    fn lines_more_or_fewer() {
        assert_eq!(diff("a\nb\n", "a\nx\ny\nb\n"), "--- a.nc\n+++ a.nc\n@@ -1,2 +1,4 @@\n a\n+x\n+y\n b\n");
        assert_eq!(diff("", "a\n"), "--- a.nc\n+++ a.nc\n@@ -0,0 +1 @@\n+a\n");
        assert_eq!(diff("a", "a\n"), "--- a.nc\n+++ a.nc\n@@ -1 +1 @@\n-a\n\\ No newline at end of file\n+a\n");
        assert_eq!(diff("a\na\n", "a\n"), "--- a.nc\n+++ a.nc\n@@ -1,2 +1 @@\n a\n-a\n");
    }

    /// Lines that come and go far apart are hunks of their own, and those between them stay.
    #[test]
    fn lines_more_or_fewer_in_several_places() {
        let text = |from: u32, to: u32| (from..=to).map(|line| format!("N{line} X{line}\n")).collect::<String>();
        let before = format!("%1\n{}\n\n{}N21 Y1 Y2\n{}", text(1, 10), text(11, 20), text(22, 30));
        let after = format!("%1\n{}\n{}N21 Y1\n  Y2\n{}", text(1, 10), text(11, 20), text(22, 30));
        let hunks = "@@ -10,7 +10,6 @@\n N9 X9\n N10 X10\n \n-\n N11 X11\n N12 X12\n N13 X13\n\
                     @@ -21,7 +20,8 @@\n N18 X18\n N19 X19\n N20 X20\n-N21 Y1 Y2\n+N21 Y1\n+  Y2\n N22 X22\n\x20\
                     N23 X23\n N24 X24\n";
        assert_eq!(diff(&before, &after), format!("--- a.nc\n+++ a.nc\n{hunks}"));
    }

    proptest::proptest! {
        /// The lines that stay, and those that come, are the lines afterwards.
        #[test]
        fn changes_lead_from_one_to_the_other(
            before in proptest::collection::vec(0_u8..4, 0..20),
            after in proptest::collection::vec(0_u8..4, 0..20),
        ) {
            let [before, after] = [before, after].map(|lines| lines.into_iter().map(|it| vec![it]).collect::<Vec<_>>());
            let (mut made, mut at) = (Vec::new(), 0);
            for change in changes(&before, &after) {
                made.extend_from_slice(&before[at..change.before.start]);
                made.extend_from_slice(&after[change.after]);
                at = change.before.end;
            }
            made.extend_from_slice(&before[at..]);
            proptest::prop_assert_eq!(made, after);
        }
    }

    /// LEX-8: line ends of old Macintosh computers. A patch has the bytes of the file; a terminal is shown its lines.
    #[test]
    fn carriage_returns_alone() {
        let no_end = "\n\\ No newline at end of file\n";
        let expected = format!("--- a.nc\n+++ a.nc\n@@ -1 +1 @@\n-%1\rN1 X0,5\r{no_end}+%1\rN1 X0.5\r{no_end}");
        assert_eq!(diff("%1\rN1 X0,5\r", "%1\rN1 X0.5\r"), expected);
        assert_eq!(safe_lines(b"%1\rN1", Encoding::Cp852), [b"%1\n".to_vec(), b"N1".to_vec()]);
    }

    /// LEX-13: on a terminal the text is decoded, and nothing in it acts on the terminal.
    #[test]
    fn lines_for_a_terminal() {
        let lines = safe_lines(b"\"p\xfd\xa1ruba\x1b[2J\r\nx", Encoding::Cp852);
        let shown: Vec<_> = lines.iter().map(|line| String::from_utf8_lossy(line)).collect();
        assert_eq!(shown, ["\"příruba\\u{1b}[2J\n", "x"]);
    }
}
