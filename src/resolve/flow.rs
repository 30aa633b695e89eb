//! Where the calls and jumps that are written with digits lead (§6).

use std::collections::{BTreeMap, BTreeSet};
use std::sync::Arc;

use super::structure::{Context, l_number};
use super::{Resolved, Roles, Target, Unit, UnitId, UnitKind, spelling, targets};
use crate::diag::{Diagnostic, Finding, Findings, Label, LabelText, UnusedMeant};
use crate::dict::{Address, CALL_ELSEWHERE, Decimal, GCode};
use crate::syntax::{BlockFlags, BlockId, Word};
use crate::text::{FileId, Location};

/// A call or jump as written, the only function of its group in the block.
#[derive(Clone, Copy, Debug)]
struct Written {
    code: GCode,
    g: Word,
    l: Word,
}

/// Follows the calls and jumps of every unit not yet followed, and of the macrocycles that they load.
pub(super) fn follow_calls(context: &mut Context<'_, '_>, resolved: &mut Resolved) {
    while let Some(unit) = resolved.units.get(resolved.followed).copied() {
        resolved.followed += 1;
        follow_unit(context, resolved, unit);
    }
    context.report_pending();
}

fn written(resolved: &Resolved, file: FileId, block: BlockId) -> Option<Written> {
    let parsed = resolved.file(file)?;
    if !parsed.flags(block).has(BlockFlags::RICH) {
        return None;
    }
    // Of two that clash (E0307) it is not known which was meant, and so not what L names.
    let roles = Roles::written(parsed.words(block));
    let (code, g) = roles.flow()?;
    Some(Written { code, g, l: roles.l? })
}

/// Finds where a call or jump to a number leads.
type Follow = fn(&mut Context<'_, '_>, &mut Resolved, Unit, Written, u32) -> Option<Target>;

fn follow_unit(context: &mut Context<'_, '_>, resolved: &mut Resolved, unit: Unit) {
    for block in (unit.first.0..unit.end.0).map(BlockId) {
        let Some(written) = written(resolved, unit.file, block) else { continue };
        if written.code == GCode::G71 {
            warn_of_inner_call(context, resolved, unit, written);
        }
        let Some(l) = l_number(written.l) else { continue };
        let follow = [
            (GCode::G71, call_subprogram as Follow),
            (GCode::G72, call_macrocycle as Follow),
            (GCode::G73, jump as Follow),
        ];
        let target = follow
            .into_iter()
            .find(|(code, _)| *code == written.code)
            .and_then(|(_, follow)| follow(context, resolved, unit, written, l));
        let file = resolved.files.get_mut(unit.file.0 as usize).and_then(Arc::get_mut);
        if let (Some(target), Some(file)) = (target, file) {
            let at = file.targets.partition_point(|(known, _)| *known < block);
            file.targets.insert(at, (block, target));
        }
    }
}

/// S4 describes G71 in the main program only (FLW-2).
fn warn_of_inner_call(context: &mut Context<'_, '_>, resolved: &mut Resolved, unit: Unit, written: Written) {
    let called = l_number(written.l);
    // A subprogram that calls itself is a ring, which has its own finding.
    let itself = called.is_some() && unit.kind == UnitKind::Subprogram(called);
    if !matches!(unit.kind, UnitKind::Subprogram(_)) || itself || resolved.subprogram_call_warned {
        return;
    }
    if let Some(parsed) = resolved.file(unit.file) {
        let finding = Finding::SubprogramCallsSubprogram { l: called };
        context.findings.add(Diagnostic::new(finding, parsed.word_place(written.g)));
        resolved.subprogram_call_warned = true;
    }
}

fn call_subprogram(
    context: &mut Context<'_, '_>,
    resolved: &mut Resolved,
    unit: Unit,
    written: Written,
    l: u32,
) -> Option<Target> {
    let at = resolved.file(unit.file).map(|parsed| parsed.value_place(written.l)).unwrap_or_default();
    let mut diagnostic = match targets::subprogram(resolved, context.library, &unit, l, at) {
        Ok(id) => return Some(Target::Unit(id)),
        Err(diagnostic) => *diagnostic,
    };
    if written.l.is_faulty() {
        // It has its finding: what its fix makes of it is a guess.
        return None;
    }
    if let Finding::UnknownSubprogram { from_macrocycle: false, macrocycle, without_entry, .. } =
        &mut diagnostic.finding
    {
        if resolved.has_nameless_subprogram() {
            // It may be the one whose L is missing or malformed: that has its finding.
            return None;
        }
        if !*macrocycle && let Some((stray, known)) = context.pending.without_entry(l) {
            if known {
                return None;
            }
            *without_entry = Some(stray.block);
            diagnostic = diagnostic.with_label(stray.at, LabelText::WithoutEntry);
        }
    }
    context.findings.add(diagnostic);
    None
}

fn call_macrocycle(
    context: &mut Context<'_, '_>,
    resolved: &mut Resolved,
    unit: Unit,
    written: Written,
    l: u32,
) -> Option<Target> {
    match context.macrocycle(resolved, l) {
        Ok(id) => Some(Target::Unit(id)),
        Err(fault) => {
            let subprogram = resolved.subprogram(l).is_some();
            let namesake = targets::Namesake { subprogram, block: targets::has_block(resolved, &unit, l) };
            if let Some(parsed) = resolved.file(unit.file) {
                context.pending.miss(l, fault, namesake, parsed.value_place(written.l));
            }
            None
        }
    }
}

fn jump(
    context: &mut Context<'_, '_>,
    resolved: &mut Resolved,
    unit: Unit,
    written: Written,
    l: u32,
) -> Option<Target> {
    let at = resolved.file(unit.file).map(|parsed| parsed.value_place(written.l)).unwrap_or_default();
    match targets::jump_target(resolved, &unit, l, at) {
        Ok(block) => Some(Target::Block(block)),
        // It has its finding: what its fix makes of it is a guess.
        Err(_) if written.l.is_faulty() => None,
        Err(diagnostic) => {
            if let Some(diagnostic) = diagnostic {
                context.findings.add(*diagnostic);
            }
            None
        }
    }
}

/// Warns of subprograms that no G71 names, unless one takes its L from a parameter (PRG-4).
pub(super) fn check_unused(context: &mut Context<'_, '_>, resolved: &Resolved) {
    let Some(parsed) = resolved.file(FileId(0)) else { return };
    let mut named = BTreeSet::new();
    for block in parsed.block_ids() {
        if !parsed.flags(block).has(BlockFlags::RICH) {
            continue;
        }
        let words = parsed.words(block);
        if has_parametric_call(words) {
            return;
        }
        let calls = words.iter().any(|word| word.g_code() == Some(GCode::G71));
        let l = words.iter().copied().find(|word| word.address == Address::L);
        if calls && l.is_none() {
            // It has its finding: it may be to call any of them.
            return;
        }
        // A G71 that clashes with another function of its group names it too, and so does one from a parameter.
        if calls || Roles::written(words).taker.may_be(GCode::G71) {
            let l = l.and_then(l_number);
            // Of a number that no subprogram has, the one that it offers was meant.
            let known =
                |l: u32| if resolved.subprogram(l).is_some() { Some(l) } else { resolved.nearest_subprogram(l) };
            named.extend(l.and_then(known));
        }
        // A jump to the number of a subprogram has its finding: it was to call it.
        if let Some(l) = l.and_then(l_number)
            && words.iter().any(|word| word.g_code() == Some(GCode::G73))
            && resolved.numbered(FileId(0), l).is_none()
        {
            named.insert(l);
        }
        // A G72 that finds no macrocycle, and a G17 with the number of a subprogram, have their findings: they were to call it.
        let written = |code: GCode| words.iter().any(|word| word.g_code() == Some(code));
        if let Some(l) = l.and_then(l_number)
            && (written(GCode::G17) && Roles::written(words).flow().is_none()
                || written(GCode::G72) && context.library.find(l).is_err() && !context.library.is_of_machine(l))
        {
            named.insert(l);
        }
        // An L without its function has its finding too.
        if matches!(Roles::written(words).taker, super::Taker::Nothing) {
            named.extend(l.and_then(l_number));
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
    }
    for (&l, &UnitId(id)) in &resolved.subprograms {
        if let Some(unit) = resolved.units.get(id as usize).filter(|_| !named.contains(&l)) {
            context.findings.add(Diagnostic::new(Finding::UnusedSubprogram { l }, unit.entry));
        }
    }
}

/// Calls of one subprogram that is missing are one finding, at the first of them, where the file has a subprogram that
/// nothing calls: the number in its G79 is wrong, or all calls were to be written anew.
pub(super) fn join_calls(resolved: &Resolved, findings: &mut Findings) {
    let missing = |found: &Diagnostic| {
        let Finding::UnknownSubprogram { l, from_macrocycle, macrocycle, without_entry, .. } = found.finding else {
            return None;
        };
        (!from_macrocycle && !macrocycle && without_entry.is_none()).then_some(l)
    };
    let mut first: BTreeMap<u32, (usize, Location)> = BTreeMap::new();
    for (l, found) in findings.items().iter().filter_map(|found| Some((missing(found)?, found))) {
        let (count, place) = first.entry(l).or_insert((0, found.at));
        *count += 1;
        *place = found.at.min(*place);
    }
    if first.values().all(|(count, _)| *count < 2) {
        return;
    }
    let called: BTreeSet<UnitId> = resolved
        .files
        .iter()
        .flat_map(|file| &file.targets)
        .filter_map(|(_, target)| match target {
            Target::Unit(unit) => Some(*unit),
            Target::Block(_) => None,
        })
        .collect();
    let uncalled: Vec<(u32, UnitId)> =
        resolved.subprograms.iter().map(|(l, unit)| (*l, *unit)).filter(|(_, unit)| !called.contains(unit)).collect();
    findings.revise(|found| {
        let Some(l) = missing(found) else { return true };
        let Some(&(_, place)) = first.get(&l).filter(|(count, _)| *count > 1) else { return true };
        let nearest = uncalled.iter().min_by_key(|(other, _)| spelling::distance(*other, l));
        let Some((other, unit)) = nearest.and_then(|(l, unit)| Some((*l, resolved.unit(*unit)?))) else { return true };
        if let Finding::UnknownSubprogram { near, uncalled, .. } = &mut found.finding
            && found.at == place
        {
            (*near, *uncalled) = (None, Some(other));
            found.labels.push(Label { at: unit.entry, text: LabelText::UnitBegins { l: other } });
        }
        found.at == place
    });
}

/// Whether the block may call a subprogram whose number is not written.
fn has_parametric_call(words: &[Word]) -> bool {
    let roles = Roles::written(words);
    roles.taker.may_be(GCode::G71)
        && words.iter().any(|word| word.address == Address::L && (word.is_parametric() || word.is_void()))
}

/// An L without its function that has the number of a macrocycle: it was to be called.
pub(super) fn name_macrocycles(context: &mut Context<'_, '_>, resolved: &Resolved) {
    let is_open = |found: &Diagnostic| matches!(found.finding, Finding::UnusedTarget { meant: UnusedMeant::Target });
    if !context.findings.items().iter().any(is_open) {
        return;
    }
    let library = &mut *context.library;
    context.findings.revise(|found| {
        let number = resolved.file(found.at.file).filter(|_| is_open(found)).and_then(|file| {
            let block = file.block_at(found.at.span.start)?;
            let words = file.words(block);
            let l = words.iter().find(|word| word.address == Address::L).copied()?;
            let alone = words.iter().all(|word| matches!(word.address, Address::L | Address::Q | Address::Skip));
            l_number(l).filter(|_| alone)
        });
        if let Some(l) = number.filter(|l| library.find(*l).is_ok() || library.is_of_machine(*l)) {
            let meant = UnusedMeant::Macrocycle { written: format!("G72 L{l}") };
            found.finding = Finding::UnusedTarget { meant };
        }
        true
    });
}
