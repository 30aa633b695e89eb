//! Where the calls and jumps that are written with digits lead (§6).

use std::collections::BTreeSet;
use std::sync::Arc;

use super::holes::swallowed;
use super::load::Context;
use super::spelling::leading_number;
use super::{Known, Resolved, Roles, Target, Unit, UnitId, UnitKind, l_number, spelling, targets};
use crate::diag::{Finding, LabelText};
use crate::dict::{Address, CALL_ELSEWHERE, Decimal, GCode};
use crate::syntax::{BlockFlags, BlockId, ParsedFile, Word};
use crate::text::{FileId, Location};

/// A call or jump as written, the only function of its group in the block.
#[derive(Clone, Copy, Debug)]
struct Written {
    unit: Unit,
    code: GCode,
    g: Location,
    l: Word,
    /// The place of the number of L.
    at: Location,
}

/// Follows the calls and jumps of every unit not yet followed, and of the macrocycles that they load.
pub(super) fn follow_calls(context: &mut Context<'_, '_>, resolved: &mut Resolved) {
    while let Some(unit) = resolved.units.get(resolved.followed).copied() {
        resolved.followed += 1;
        for block in unit.blocks() {
            let Some(written) = written(resolved, unit, block) else { continue };
            let target = context.follow(resolved, &written);
            let file = resolved.files.get_mut(unit.file.0 as usize).and_then(Arc::get_mut);
            if let (Some(target), Some(file)) = (target, file) {
                let at = file.targets.partition_point(|(known, _)| *known < block);
                file.targets.insert(at, (block, target));
            }
        }
    }
    context.report_open_ends(resolved);
}

fn written(resolved: &Resolved, unit: Unit, block: BlockId) -> Option<Written> {
    let parsed = resolved.file(unit.file)?;
    if !parsed.flags(block).has(BlockFlags::RICH) {
        return None;
    }
    // Of two that clash (E0307) it is not known which was meant, and so not what L names.
    let roles = Roles::written(parsed.words(block));
    let (code, g) = roles.flow()?;
    let l = roles.l?;
    Some(Written { unit, code, g: parsed.word_place(g), l, at: parsed.value_place(l) })
}

impl Context<'_, '_> {
    /// Where a call or jump leads, when that is known.
    fn follow(&mut self, resolved: &mut Resolved, written: &Written) -> Option<Target> {
        let number = l_number(written.l);
        if written.code == GCode::G71 {
            let target = number.and_then(|number| self.follow_subprogram(resolved, written, number));
            // One that is wrong has its finding.
            if number.is_none() || target.is_some() && !written.l.is_faulty() {
                self.warn_of_inner_call(resolved, written, number);
            }
            target.map(Target::Unit)
        } else if written.code == GCode::G72 {
            self.follow_macrocycle(resolved, written, number?).map(Target::Unit)
        } else {
            self.follow_jump(resolved, written, number?).map(Target::Block)
        }
    }

    /// S4 describes G71 in the main program only (FLW-2).
    fn warn_of_inner_call(&mut self, resolved: &mut Resolved, written: &Written, called: Option<u32>) {
        let Written { unit, g, .. } = *written;
        // A subprogram that calls itself is a ring, which has its own finding.
        let itself = called.is_some() && unit.kind == UnitKind::Subprogram(called);
        if matches!(unit.kind, UnitKind::Subprogram(_)) && !itself && resolved.is_first_inner_call() {
            self.report(g, Finding::SubprogramCallsSubprogram { l: called });
        }
    }

    fn follow_subprogram(&mut self, resolved: &mut Resolved, written: &Written, l: u32) -> Option<UnitId> {
        if written.l.is_faulty() {
            // It has its finding: the number that its fix makes of it is a guess.
            return resolved.subprogram(l).filter(|_| !matches!(written.unit.kind, UnitKind::Macrocycle(_)));
        }
        let mut diagnostic = match targets::subprogram(resolved, self.library, &written.unit, l, written.at) {
            Known::Yes(id) => return Some(id),
            Known::Unknown => return None,
            Known::No(diagnostic) => *diagnostic,
        };
        let Finding::UnknownSubprogram {
            from_macrocycle: false, macrocycle: false, unread: None, without_entry, ..
        } = &mut diagnostic.finding
        else {
            self.findings.add(diagnostic);
            return None;
        };
        match self.open.without_entry(l) {
            Some((_, true)) => {}
            Some((stray, false)) => {
                // Its number may be what is wrong with it.
                *without_entry = Some(stray.block).filter(|number| *number > 0);
                let at = stray.at;
                self.findings.add(diagnostic.with_label(at, LabelText::WithoutEntry));
            }
            None => self.open.calls.push((l, diagnostic)),
        }
        None
    }

    fn follow_macrocycle(&mut self, resolved: &mut Resolved, written: &Written, l: u32) -> Option<UnitId> {
        let fault = match self.macrocycle(resolved, l) {
            Ok(id) => return Some(id),
            Err(fault) => fault,
        };
        let block = targets::has_block(resolved, &written.unit, l);
        let namesake = targets::Namesake { subprogram: resolved.subprogram(l).is_some(), block };
        self.open.miss(l, fault, namesake, written.at);
        None
    }

    fn follow_jump(&mut self, resolved: &Resolved, written: &Written, l: u32) -> Option<BlockId> {
        match targets::jump_target(resolved, &written.unit, l, written.at) {
            Known::Yes(block) => return Some(block),
            // It has its finding: the number that its fix makes of it is a guess.
            Known::No(_) if written.l.is_faulty() => {}
            Known::No(diagnostic) if matches!(diagnostic.finding, Finding::UnknownJumpTarget { .. }) => {
                self.open.jumps.push((l, *diagnostic));
            }
            Known::No(diagnostic) => self.findings.add(*diagnostic),
            Known::Unknown => {}
        }
        None
    }
}

/// Warns of subprograms that no G71 names, unless one takes its L from a parameter (PRG-4).
pub(super) fn check_unused(context: &mut Context<'_, '_>, resolved: &Resolved) {
    let Some(parsed) = resolved.file(FileId(0)).filter(|_| !resolved.subprograms.is_empty()) else { return };
    let mut named: BTreeSet<u32> = swallowed_numbers(parsed).into_iter().collect();
    for block in parsed.block_ids().filter(|block| parsed.flags(*block).has(BlockFlags::RICH)) {
        let Some(names) = named_by(context, resolved, parsed.words(block)) else { return };
        named.extend(names);
    }
    // A macrocycle cannot call one: where it does, it has E0404.
    for macrocycle in resolved.files().skip(1) {
        let blocks = macrocycle.block_ids().filter(|block| macrocycle.flags(*block).has(BlockFlags::RICH));
        let roles = blocks.map(|block| Roles::written(macrocycle.words(block)));
        let calls = roles.filter(|roles| roles.flow().is_some_and(|(code, _)| code == GCode::G71));
        named.extend(calls.filter_map(|roles| l_number(roles.l?)));
    }
    for (&l, &UnitId(id)) in &resolved.subprograms {
        let Some(unit) = resolved.units.get(id as usize).filter(|_| !named.contains(&l)) else { continue };
        // Where the block has words too many, another number may be meant (E0208).
        let is_crowded = |word: &Word| context.open.crowded.contains(&parsed.word_place(*word));
        if !parsed.words(unit.first).iter().any(is_crowded) {
            context.report(unit.entry, Finding::UnusedSubprogram { l });
        }
    }
}

/// The numbers behind an `L` in words that comments swallow (W0114).
fn swallowed_numbers(parsed: &ParsedFile) -> Vec<u32> {
    let behind_l = swallowed(parsed).flat_map(|span| parsed.source.slice(span).split(['L', 'l']).skip(1));
    behind_l.filter_map(leading_number).map(|(number, _)| number).collect()
}

/// The numbers of the subprograms that a block calls, or was to call and has a finding; `None`: any of them.
fn named_by(context: &mut Context<'_, '_>, resolved: &Resolved, words: &[Word]) -> Option<Vec<u32>> {
    let roles = Roles::written(words);
    let written = |code: GCode| words.iter().any(|word| word.g_code() == Some(code));
    let l = words.iter().copied().find(|word| word.address == Address::L);
    let unread = |l: Word| roles.taker.may_be(GCode::G71) && (l.is_parametric() || l.is_void());
    let unread_g = words.iter().any(|word| word.address == Address::G && word.is_void());
    if l.is_none() && (unread_g || written(GCode::G71))
        || words.iter().any(|word| word.address == Address::L && unread(*word))
    {
        return None;
    }
    let mut named = Vec::new();
    if let Some(l) = l.and_then(l_number) {
        // A G71 that clashes with another function of its group names it too, and so does one from a parameter. Of a
        // number that no subprogram has, the nearest was meant, or any that is one slip away.
        if written(GCode::G71) || roles.taker.may_be(GCode::G71) {
            let exists = |l: &u32| resolved.subprogram(*l).is_some();
            if exists(&l) {
                named.push(l);
            } else {
                named.extend(spelling::slips(l).filter(exists).chain(resolved.nearest_subprogram(l, None)));
            }
        }
        let missing =
            |context: &mut Context<'_, '_>| context.library.find(l).is_err() && !context.library.is_of_machine(l);
        // These have a finding: a jump to the number of a subprogram, an L without its function, G17 for G71, a G72
        // that finds no macrocycle.
        if written(GCode::G73) && resolved.numbered(FileId(0), l).is_none()
            || matches!(roles.taker, super::Taker::Nothing)
            || written(GCode::G17) && roles.flow().is_none()
            || written(GCode::G72) && missing(context)
        {
            named.push(l);
        }
    }
    // M98 and G65 have their findings: they were to call the subprogram.
    let number = |word: &Word| word.number().or_else(|| word.refused_number()).and_then(Decimal::as_whole);
    let calls_elsewhere = |word: &Word| {
        word.address == Address::M && number(word) == Some(i64::from(CALL_ELSEWHERE))
            || word.address == Address::G && matches!(number(word), Some(65 | 66))
    };
    if words.iter().any(calls_elsewhere) {
        // The number of a subprogram is seldom one that P takes.
        let called = words.iter().find(|word| word.address == Address::P).and_then(number);
        named.extend(called.and_then(|called| u32::try_from(called).ok()));
        named.extend(l.and_then(l_number));
    }
    Some(named)
}
