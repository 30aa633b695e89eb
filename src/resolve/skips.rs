//! `/` in the wrong place (BLK-6), and in blocks that give structure (BLK-10).

use super::UnitKind;
use super::functions::Functions;
use super::judge_block::BlockJudge;
use crate::diag::{Diagnostic, Edit, Finding, FixTitle};
use crate::dict::{Address, PROGRAM_ENDS};
use crate::syntax::{BlockFlags, BlockId, Word};
use crate::text::{Location, Span};

impl BlockJudge<'_> {
    /// `/` where it is not what was meant (BLK-6), or in a block that gives structure (BLK-10).
    pub(super) fn check_skip(
        &mut self,
        block: BlockId,
        words: &[Word],
        functions: &Functions,
        flags: BlockFlags,
        unit: Option<UnitKind>,
    ) {
        let Some(&skip) = words.iter().find(|word| word.address == Address::Skip) else { return };
        let ends = match functions.m.get(1).copied().flatten() {
            Some((number, _)) if PROGRAM_ENDS.contains(&number) => Some(format!("M{number:02}")),
            _ if flags.has(BlockFlags::RETURN) && !matches!(unit, Some(UnitKind::Main)) => Some("G70".to_owned()),
            _ => None,
        };
        // Of a `/` that was meant for the next block one finding is enough.
        let mut before_next = false;
        for (place, _) in words.iter().enumerate().filter(|(_, word)| word.address == Address::Skip) {
            before_next |= self.check_skip_place(block, words, place);
        }
        if let Some(function) = ends
            && !flags.has(BlockFlags::ENTRY)
            && !before_next
        {
            self.report(skip, Finding::SkippableStructure { function });
        }
    }

    /// Warns of a `/` that begins its line or stands directly before an `N` on the same line (BLK-6). Gives whether it
    /// is such an `N`.
    fn check_skip_place(&mut self, block: BlockId, words: &[Word], place: usize) -> bool {
        let Some(&skip) = words.get(place) else { return false };
        let source = &self.file.source;
        let line = source.line_span(source.lines().line_at(skip.start()));
        let before = place.checked_sub(1).and_then(|before| words.get(before).copied()).or(self.file.n_word(block));
        let begins_line = before.is_none_or(|word| word.span(source.text()).end <= line.start);
        let is_last = place + 1 == words.len();
        let on_line = |at: u32| line.start <= at && at < line.end;
        let next = self.file.n_word(block.next()).filter(|next| is_last && on_line(next.start()));
        if !begins_line && next.is_none() {
            return false;
        }
        let place = self.file.word_place(skip);
        let entry = next.is_some() && self.file.flags(block.next()).has(BlockFlags::ENTRY);
        let finding = Finding::SkipBeforeBlockNumber { block: self.file.shown_number(block), entry };
        let mut diagnostic = Diagnostic::new(finding, place);
        if let Some(next) = next.filter(|_| !entry && self.takes_skip(block.next(), line)) {
            let text = source.slice(place.span);
            let behind = Span::empty(next.span(source.text()).end);
            diagnostic = diagnostic.with_offer(
                FixTitle::MoveSkip { block: self.file.shown_number(block.next()) },
                Location { span: behind, ..place },
                format!(" {text}"),
            );
            let mut removed = place;
            // The blanks behind it go too, so that the block number takes its place.
            if source.slice(Span::new(place.span.end, next.start())).bytes().all(|byte| matches!(byte, b' ' | b'\t')) {
                removed.span.end = next.start();
            }
            if let Some(fix) = diagnostic.fixes.first_mut() {
                fix.edits.insert(0, Edit { at: removed, text: String::new() });
            }
        }
        self.judged.findings.add(diagnostic);
        next.is_some()
    }

    /// Whether a `/` can move into the block, which is on that line: the block has none, or one that moves on itself,
    /// and the `/` will not stand before the next `N` again.
    fn takes_skip(&self, mut block: BlockId, line: Span) -> bool {
        /// Blocks looked at: more in one line are no program.
        const MOST: usize = 16;
        for _ in 0..MOST {
            let words = self.file.words(block);
            let followed = self.file.n_word(block.next()).is_some_and(|next| next.start() < line.end);
            let is_skip = |word: &Word| word.address == Address::Skip;
            let Some((last, others)) = words.split_last() else { return !followed };
            if others.iter().any(is_skip) {
                return false;
            }
            if !is_skip(last) {
                return true;
            }
            if !followed || others.is_empty() {
                return false;
            }
            block = block.next();
        }
        true
    }
}
