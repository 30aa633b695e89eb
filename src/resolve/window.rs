//! Some blocks of a long straight program, judged alone.

use std::sync::Arc;

use super::blocks::BlockChecker;
use super::letters::Letters;
use super::lines;
use super::{Resolved, Unit, UnitKind};
use crate::config::Settings;
use crate::diag::Findings;
use crate::dict::Address;
use crate::syntax::{BlockFlags, BlockId, Form, ParsedFile, is_suspicious, parse};
use crate::text::{FileId, SourceText, Sources};

/// Resolves `source`, a piece of a program from the `N` of one block up to that of another, as a main program without its
/// begin and end. Its findings are those that the piece has in the whole program, when that has no calls, jumps or
/// subprograms, and block numbers rise.
///
/// `between` are the numbers of the blocks before and after the piece. `None` when the piece says anything that concerns
/// other blocks: numbers that do not rise between those, calls, jumps, ends, skips, parameters, `%`, `*`; or when something in it
/// speaks for another control.
pub fn resolve_window(
    source: &Arc<SourceText>,
    between: (u32, u32),
    settings: &Settings,
    sources: &mut Sources,
    findings: &mut Findings,
) -> Option<Resolved> {
    let text = source.text();
    let begins = text.starts_with(['N', 'n']);
    let ends = text.ends_with(['\n', '\r']);
    if !begins || !ends || memchr::memchr3(b'%', b'*', 0x1a, text.as_bytes()).is_some() || text.contains('\0') {
        return None;
    }
    let file = sources.add(Arc::clone(source));
    let mut parsed = parse(file, source, Form::Macrocycle, findings);
    if !concerns_itself_only(&parsed, between) {
        return None;
    }
    let mut resolved = Resolved::default();
    let (first, end) = (BlockId(0), BlockId(parsed.block_count()));
    let entry = parsed.n_place(first);
    resolved.add_unit(Unit { kind: UnitKind::Main, file: FileId(0), first, end, entry });
    let letters = Letters::default();
    // Whether lines without a block number are findings follows from all lines of the program, and which axes are too many
    // from all its letters.
    let (_, continuing_lines) = lines::check(&parsed, &resolved.units);
    if continuing_lines || Letters::are_limited(&settings.machine) {
        return None;
    }
    let mut checker = BlockChecker::new(settings, &parsed, &letters, findings);
    for block in parsed.block_ids() {
        checker.check(block, Some(UnitKind::Main));
    }
    let judged = checker.finish();
    parsed.refuse(&judged.refused);
    // The whole program may look like one for another control then.
    if !findings.is_empty() && is_suspicious(text) {
        return None;
    }
    resolved.add_file(parsed, Vec::new(), judged.points);
    Some(resolved)
}

/// Whether nothing in the file leads out of it.
fn concerns_itself_only(parsed: &ParsedFile, (before, after): (u32, u32)) -> bool {
    // Whether they are empty follows from the comments around the piece too (BLK-9).
    let last = BlockId(parsed.block_count().saturating_sub(1));
    if parsed.words(BlockId(0)).is_empty() || parsed.words(last).is_empty() {
        return false;
    }
    let mut last = before;
    for block in parsed.block_ids() {
        if let Some(number) = parsed.number(block) {
            if number <= last || number >= after {
                return false;
            }
            last = number;
        }
        let flags = parsed.flags(block);
        let leads_out = [BlockFlags::SKIP, BlockFlags::END, BlockFlags::RETURN, BlockFlags::ENTRY];
        if leads_out.into_iter().any(|flag| flags.has(flag)) {
            return false;
        }
        if !flags.has(BlockFlags::RICH) {
            continue;
        }
        let leads = |address| matches!(address, Address::R | Address::L | Address::Q);
        let alone = parsed.words(block).iter().all(|word| {
            let function = word.g_code().is_some_and(|code| !code.is_flow() && !code.is_cycle());
            !leads(word.address) && !word.is_parametric() && (word.address != Address::G || function)
        });
        if !alone {
            return false;
        }
    }
    true
}

#[cfg(test)]
mod tests {
    use super::*;

    fn is_judged(piece: &str) -> bool {
        let source = Arc::new(SourceText::from_text("t.nc", piece));
        let (mut sources, mut findings) = (Sources::new(), Findings::new());
        resolve_window(&source, (100, 200), &Settings::default(), &mut sources, &mut findings).is_some()
    }

    #[test]
    fn what_concerns_itself_only() {
        for piece in [
            "N101 X1\n",
            "n110 X1\r",
            "N110 G1 X1 Y2 F100\nN120 M8 S100 T1 \"c\"\nN199 G91 X,5\n",
            "N110 G4 M8\n",
            "N110 G2 X5 I5\n",
        ] {
            assert!(is_judged(piece), "{piece:?}");
        }
        for piece in [
            "",
            "X1\nN110 X1\n",
            " N110 X1\n",
            "N110 X1",
            "N110 X1 *\n",
            "N110 X1\n %5\n",
            "N110 X1 \u{1a}\n",
            "N110 X1 \0\n",
            "N110\n",
            "N110 X1\nY1\nN120 X2\n",
            "N110\nN120 X1\n",
            "N110 X1\nN120\n",
            "N100 X1\n",
            "N110 X1\nN200 X1\n",
            "N120 X1\nN110 X1\n",
            "N110 X1\nN110 X1\n",
            "N110 / X1\n",
            "N110 M30\n",
            "N110 G70\n",
            "N110 G79 L5\n",
            "N110 G71 L5\n",
            "N110 G71 X5\n",
            "N110 L5\n",
            "N110 Q5\n",
            "N110 G81\n",
            "N110 G999\n",
            "N110 GR1\n",
            "N110 XR1\n",
            "N110 R1=5\n",
        ] {
            assert!(!is_judged(piece), "{piece:?}");
        }
    }
}
