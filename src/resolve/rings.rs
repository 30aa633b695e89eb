//! Calls that lead back to a unit that is still running (FLW-2).

use super::load::Context;
use super::{Resolved, Target, UnitId};
use crate::diag::{Diagnostic, Finding};
use crate::dict::Address;
use crate::syntax::BlockId;

/// How far the search has come in a unit.
#[derive(Clone, Copy, Eq, PartialEq)]
enum Visit {
    New,
    Open,
    Done,
}

/// Reports each written call that closes a ring: depth first from the main program, then from every unit not yet
/// reached.
pub(super) fn check(context: &mut Context<'_, '_>, resolved: &Resolved) {
    let mut visits = vec![Visit::New; resolved.units.len()];
    for (root, _) in resolved.units() {
        walk(context, resolved, root, &mut visits);
    }
}

/// The calls of a unit to other units, in the order of the text.
fn calls(resolved: &Resolved, id: UnitId) -> Vec<(BlockId, UnitId)> {
    let Some(unit) = resolved.unit(id) else { return Vec::new() };
    let Some(file) = resolved.files.get(unit.file.0 as usize) else { return Vec::new() };
    let from = file.targets.partition_point(|(block, _)| *block < unit.first);
    file.targets
        .iter()
        .skip(from)
        .take_while(|(block, _)| unit.contains(*block))
        .filter_map(|(block, target)| match target {
            Target::Unit(called) => Some((*block, *called)),
            Target::Block(_) => None,
        })
        .collect()
}

/// Depth-first search with an explicit stack: macrocycles may call one another by the thousand.
fn walk(context: &mut Context<'_, '_>, resolved: &Resolved, root: UnitId, visits: &mut [Visit]) {
    if visits.get(root.0 as usize) != Some(&Visit::New) {
        return;
    }
    let mut path = vec![(root, calls(resolved, root), 0_usize)];
    mark(visits, root, Visit::Open);
    while let Some((unit, unit_calls, next)) = path.last_mut() {
        let Some(&(block, called)) = unit_calls.get(*next) else {
            mark(visits, *unit, Visit::Done);
            path.pop();
            continue;
        };
        *next += 1;
        let caller = *unit;
        match visits.get(called.0 as usize) {
            Some(Visit::New) => {
                mark(visits, called, Visit::Open);
                path.push((called, calls(resolved, called), 0));
            }
            Some(Visit::Open) => {
                let from = path.iter().position(|(unit, ..)| *unit == called).unwrap_or(0);
                let units = path.iter().skip(from).map(|(unit, ..)| *unit).chain([called]);
                let ring = ring_text(resolved, &units.collect::<Vec<_>>());
                report(context, resolved, caller, block, ring);
            }
            Some(Visit::Done) | None => {}
        }
    }
}

fn mark(visits: &mut [Visit], unit: UnitId, visit: Visit) {
    if let Some(slot) = visits.get_mut(unit.0 as usize) {
        *slot = visit;
    }
}

/// The units of a ring, the last one being the first again. Of a long ring the middle is left out.
pub fn ring_text(resolved: &Resolved, ring: &[UnitId]) -> String {
    const SHOWN: usize = 12;
    let name = |unit: &UnitId| resolved.unit(*unit).map(super::Unit::name);
    let names: Vec<String> = if ring.len() <= SHOWN {
        ring.iter().filter_map(name).collect()
    } else {
        let (begin, end) = (ring.iter().take(SHOWN / 2), ring.iter().skip(ring.len() - SHOWN / 2));
        begin.filter_map(name).chain(["…".to_owned()]).chain(end.filter_map(name)).collect()
    };
    names.join(" → ")
}

/// At the L of the call that closes the ring.
fn report(context: &mut Context<'_, '_>, resolved: &Resolved, caller: UnitId, block: BlockId, ring: String) {
    let parsed = resolved.unit(caller).and_then(|unit| resolved.file(unit.file));
    let Some(parsed) = parsed else { return };
    let Some(&l) = parsed.words(block).iter().find(|word| word.address == Address::L) else { return };
    context.findings.add(Diagnostic::new(Finding::RecursiveCall { ring }, parsed.word_place(l)));
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::resolve::{Unit, UnitKind};
    use crate::text::FileId;
    use crate::text::Location;

    fn shown(length: u16) -> String {
        let mut resolved = Resolved::default();
        let ring: Vec<UnitId> = (1..=length)
            .map(|l| {
                let (first, end) = (BlockId(0), BlockId(1));
                let kind = UnitKind::Macrocycle(l.into());
                resolved.add_unit(Unit { kind, file: FileId(0), first, end, entry: Location::default() })
            })
            .collect();
        ring_text(&resolved, &ring)
    }

    #[test]
    fn the_middle_of_a_long_ring_is_left_out() {
        assert_eq!(shown(3), "L1 → L2 → L3");
        assert_eq!(shown(12), "L1 → L2 → L3 → L4 → L5 → L6 → L7 → L8 → L9 → L10 → L11 → L12");
        assert_eq!(shown(20), "L1 → L2 → L3 → L4 → L5 → L6 → … → L15 → L16 → L17 → L18 → L19 → L20");
    }
}
