//! What was meant by an L without use (W0402): other controls write calls and tables with it, and digits are exchanged.

use super::functions::Functions;
use super::{Unit, UnitKind};
use crate::diag::UnusedMeant;
use crate::dict::{Address, GCode, GGroup};
use crate::syntax::{BlockId, ParsedFile, Word};

/// The call or jump of a block whose digits are exchanged, `G17 L100` for `G71 L100`, `G37 L190` for `G73 L190`, or of
/// which one is missing: `G7 L100`.
pub(super) fn exchanged_call(units: &[Unit], words: &[Word], functions: &Functions) -> Option<(GCode, u32)> {
    let other = words.iter().any(|word| !matches!(word.address, Address::G | Address::L | Address::Q | Address::Skip));
    let mut codes = words.iter().filter(|word| word.address == Address::G);
    let (Some(written), None) = (codes.next(), codes.next()) else { return None };
    let code = written.g_code().filter(|_| !other)?;
    let l = functions.roles.l.and_then(super::l_number)?;
    let meant = if code == GCode::G17 || code == GCode::G07 && is_unit(units, l) {
        GCode::G71
    } else if code == GCode::G37 || code == GCode::G07 {
        GCode::G73
    } else {
        return None;
    };
    Some((meant, l))
}

/// The call or jump that was meant by an L without its function: other controls repeat calls with P.
fn written_with(code: GCode, words: &[Word], l: u32) -> String {
    let count = words.iter().find(|word| matches!(word.address, Address::P | Address::Q)).and_then(|word| word.whole());
    count.map_or_else(|| format!("{code} L{l}"), |count| format!("{code} L{l} Q{count}"))
}

/// The meaning of an L in a block that lost its function: a subprogram, a block, or either.
pub(super) fn lost_function(file: &ParsedFile, units: &[Unit], words: &[Word], l: Word) -> UnusedMeant {
    let Some(number) = super::l_number(l) else { return UnusedMeant::Target };
    let call = is_unit(units, number).then(|| written_with(GCode::G71, words, number));
    let jump = has_block_near(file, units, l, number).then(|| written_with(GCode::G73, words, number));
    match (call, jump) {
        (Some(call), Some(jump)) => UnusedMeant::CallOrJump { call, jump },
        (Some(written), None) => UnusedMeant::Alone { written },
        (None, Some(written)) => UnusedMeant::Jump { written },
        (None, None) => UnusedMeant::Target,
    }
}

/// Whether L and its count stand alone in a block, and L names something: a call or jump that lost its function has one
/// finding.
pub(super) fn is_call_alone(file: &ParsedFile, units: &[Unit], words: &[Word]) -> bool {
    let known = |word: &Word| matches!(word.address, Address::L | Address::P | Address::Q | Address::Skip);
    let l = words.iter().find(|word| word.address == Address::L).filter(|_| words.iter().all(known));
    l.is_some_and(|l| lost_function(file, units, words, *l) != UnusedMeant::Target)
}

/// Whether a block not far from a word, in the same unit, has the number.
pub(super) fn has_block_near(file: &ParsedFile, units: &[Unit], word: Word, number: u32) -> bool {
    /// So many blocks before and behind it are looked at.
    const BLOCKS: u32 = 1 << 10;
    let Some(block) = file.block_at(word.start()) else { return false };
    let near = units.iter().find(|unit| unit.contains(block)).map(|unit| {
        let first = unit.first.0.max(block.0.saturating_sub(BLOCKS));
        (first..unit.end.0.min(block.0.saturating_add(BLOCKS))).map(BlockId)
    });
    near.into_iter().flatten().any(|near| file.number(near) == Some(number))
}

/// Whether the file has a subprogram of that number.
pub(super) fn is_unit(units: &[Unit], l: u32) -> bool {
    units.iter().any(|unit| unit.kind == UnitKind::Subprogram(Some(l)))
}

/// What was meant by an L without use: other controls write tables and calls with it.
pub(super) fn meant(words: &[Word], functions: &Functions, l: Word) -> UnusedMeant {
    let spiral = functions.of_group(GGroup::G2).is_some_and(|(code, _)| code == GCode::G10);
    let called = words.iter().find(|word| word.address == Address::P).and_then(|word| word.whole());
    if spiral {
        UnusedMeant::Tables
    } else if let (Some(_), Some(number), Some(count)) = (functions.calls_elsewhere(), called, l.whole()) {
        UnusedMeant::Call { written: format!("G71 L{number} Q{count}") }
    } else if let (Some(_), None, Some(number)) = (functions.calls_elsewhere(), called, l.whole()) {
        UnusedMeant::Call { written: format!("G71 L{number}") }
    } else {
        UnusedMeant::Target
    }
}
