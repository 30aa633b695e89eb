//! Which words the rules leave to a block: by the unit that it is in, its other words, and the functions in force.

use super::targets::NEAR;
use super::{Context, Source};
use crate::dict::{Address, GCode, GGroup, Lasting, PROGRAM_ENDS};
use crate::query::cursor::unit_of;
use crate::resolve::{Library, UnitKind, m_number, takes_axis};
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
            return matches!(self, Self::Entry | Self::Any) && context.words().next().is_none();
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

/// Whether the machine has room for the axis in this program (ADR-4).
pub(super) fn takes_letter(source: &Source<'_>, context: &Context<'_>, address: Address) -> bool {
    address.axis().is_none_or(|letter| takes_axis(&source.settings.machine, context.file, letter))
}

/// Whether I, J or K has a use in the block (MOT-3, GRP-4, GRP-7, GRP-8).
pub(super) fn takes_center(source: &Source<'_>, context: &Context<'_>, codes: &[GCode], address: Address) -> bool {
    if codes.iter().any(|code| matches!(code, GCode::G92 | GCode::G93)) {
        return false;
    }
    let in_force = |group| {
        let written = codes.iter().copied().find(|code| code.group() == group);
        written.or_else(|| in_force(source, context, group))
    };
    let is_arc = matches!(in_force(GGroup::G0), Some(GCode::G02 | GCode::G03));
    (is_arc && address != Address::K)
        || codes.iter().any(|code| code.makes_words_data())
        || (codes.contains(&GCode::G23) && address == Address::I)
        || in_force(GGroup::G0) == Some(GCode::G33)
        || matches!(in_force(GGroup::G2), Some(GCode::G09 | GCode::G10))
        || in_force(GGroup::G8).is_some_and(GCode::is_cycle)
}

/// The function of a group that the nearest block above writes, of the same unit and not for itself alone.
fn in_force(source: &Source<'_>, context: &Context<'_>, group: GGroup) -> Option<GCode> {
    let here = context.block?;
    let first = unit_of(source.analysis, here).map_or(0, |(_, unit)| unit.first.0);
    let near = (first.max(here.0.saturating_sub(NEAR))..here.0).rev().map(BlockId);
    let lasts = |code: &GCode| code.group() == group && code.lasting() != Lasting::Block;
    let mut written = near.flat_map(|block| context.file.words(block)).filter_map(|word| word.g_code()).filter(lasts);
    written.next().or_else(|| source.settings.machine.power_up.get(group.index()).copied().flatten())
}
