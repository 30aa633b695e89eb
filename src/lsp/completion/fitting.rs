//! Which words the rules leave to a block: by the unit that it is in, its other words, and the functions in force.

use super::targets::NEAR;
use super::{Context, Source};
use crate::dict::{Address, GCode, GGroup, Lasting, PROGRAM_ENDS};
use crate::query::cursor::unit_of;
use crate::resolve::{Library, UnitKind, m_number};
use crate::syntax::BlockId;

/// The part that a block has in its file (PRG-2 to PRG-7).
#[derive(Clone, Copy, Debug, Eq, PartialEq)]
pub(super) enum Part {
    /// One of the main program.
    Main,
    /// One of a subprogram or macrocycle.
    Inside,
    /// The one that begins a subprogram or macrocycle, or has to.
    Entry,
    /// Behind the end of a macrocycle.
    Behind,
    /// Not known: the file is no program yet.
    Any,
}

impl Part {
    pub(super) fn of(source: &Source<'_>, block: BlockId) -> Self {
        let resolved = &source.analysis.resolved;
        let is_macrocycle = resolved.main().is_none() && Library::number(&source.analysis.path).is_some();
        if is_macrocycle && block == BlockId(0) {
            return Self::Entry;
        }
        match unit_of(source.analysis, block).map(|(_, unit)| unit) {
            Some(unit) if unit.kind == UnitKind::Main => Self::Main,
            Some(unit) if unit.first == block => Self::Entry,
            Some(_) => Self::Inside,
            None if resolved.units().next().is_none() => Self::Any,
            None if is_macrocycle => Self::Behind,
            None => Self::Entry,
        }
    }

    /// Whether the block may have that function, as far as the structure of the file goes.
    pub(super) fn takes_g(self, source: &Source<'_>, context: &Context<'_>, code: GCode) -> bool {
        if code == GCode::G79 {
            let only_l = context.words().all(|word| word.address == Address::L);
            return matches!(self, Self::Entry | Self::Any) && only_l;
        }
        let mut m = context.words().filter_map(|word| m_number(word, source.settings));
        match self {
            Self::Entry | Self::Behind => false,
            Self::Main if code == GCode::G70 => false,
            Self::Main | Self::Inside | Self::Any => !code.is_flow() || !m.any(|m| PROGRAM_ENDS.contains(&m)),
        }
    }
}

/// Whether the block may have that M function beside its calls and jumps (E0413).
pub(super) fn takes_m(context: &Context<'_>, number: u8) -> bool {
    let calls = || context.words().filter_map(|word| word.g_code()).any(GCode::is_flow);
    !PROGRAM_ENDS.contains(&number) || !calls()
}

/// Those of I, J and K that have a use in the block (MOT-3, GRP-4, GRP-7, GRP-8).
pub(super) fn centers(source: &Source<'_>, context: &Context<'_>, codes: &[GCode]) -> &'static [Address] {
    const ALL: [Address; 3] = [Address::I, Address::J, Address::K];
    if codes.iter().any(|code| matches!(code, GCode::G92 | GCode::G93)) {
        return &[];
    }
    let may_be = |group, wanted: fn(GCode) -> bool| {
        let written = codes.iter().copied().find(|code| code.group() == group);
        written.map_or_else(|| may_be_in_force(source, context, group, wanted), wanted)
    };
    let all = context.words().any(|word| word.address == Address::G && word.is_parametric())
        || codes.iter().any(|code| code.makes_words_data())
        || may_be(GGroup::G0, |code| code == GCode::G33)
        || may_be(GGroup::G2, |code| matches!(code, GCode::G09 | GCode::G10))
        || may_be(GGroup::G8, GCode::is_cycle);
    if all {
        &ALL
    } else if may_be(GGroup::G0, |code| matches!(code, GCode::G02 | GCode::G03)) {
        &[Address::I, Address::J]
    } else if codes.contains(&GCode::G23) {
        &[Address::I]
    } else {
        &[]
    }
}

/// Whether a wanted function of a group may be in force from above: the nearest block of the unit that writes one says
/// so. A call, a jump, a parameter, a `/` on the way and what calls the unit leave it open.
fn may_be_in_force(source: &Source<'_>, context: &Context<'_>, group: GGroup, wanted: impl Fn(GCode) -> bool) -> bool {
    let Some(here) = context.block else { return true };
    let unit = unit_of(source.analysis, here).map(|(_, unit)| unit);
    let first = unit.map_or(0, |unit| unit.first.0);
    for block in (first.max(here.0.saturating_sub(NEAR))..here.0).rev().map(BlockId) {
        let words = context.file.words(block);
        let open = words.iter().any(|word| {
            word.address == Address::Skip
                || word.g_code().is_some_and(GCode::is_flow)
                || word.address == Address::G && word.is_parametric()
        });
        let lasts = |code: &GCode| code.group() == group && code.lasting() != Lasting::Block;
        let mut written = words.iter().filter_map(|word| word.g_code()).filter(lasts).peekable();
        if open || written.peek().is_some() {
            return open || written.any(wanted);
        }
    }
    let power_up = || source.settings.machine.power_up.get(group.index()).copied().flatten();
    unit.is_none_or(|unit| unit.kind != UnitKind::Main) || power_up().is_some_and(wanted)
}
