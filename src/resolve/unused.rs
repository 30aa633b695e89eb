//! What was meant by an L without use (W0402): other controls write calls and tables with it, and digits are exchanged.

use super::blocks::{Functions, g_code};
use crate::diag::UnusedMeant;
use crate::dict::{Address, GCode, GGroup};
use crate::syntax::Word;

/// The call or jump of a block whose digits are exchanged: `G17 L100` for `G71 L100`, `G37 L190` for `G73 L190`.
pub(super) fn exchanged_call(words: &[Word], functions: &Functions) -> Option<(GCode, u32)> {
    let other = words.iter().any(|word| !matches!(word.address, Address::G | Address::L | Address::Q | Address::Skip));
    let mut codes = words.iter().filter(|word| word.address == Address::G);
    let (Some(written), None) = (codes.next(), codes.next()) else { return None };
    let code = g_code(*written).filter(|_| !other)?;
    let meant = if code == GCode::G17 {
        GCode::G71
    } else if code == GCode::G37 {
        GCode::G73
    } else {
        return None;
    };
    let l = functions.roles.l.and_then(super::l_number)?;
    Some((meant, l))
}

/// The number in a block of L alone, with P or Q at most: other controls call subprograms so.
pub(super) fn call_alone(words: &[Word]) -> Option<u32> {
    let known = |word: &Word| matches!(word.address, Address::L | Address::P | Address::Q | Address::Skip);
    let l = words.iter().find(|word| word.address == Address::L).filter(|_| words.iter().all(known))?;
    super::l_number(*l)
}

/// The call that was meant by an L alone: other controls repeat it with P.
pub(super) fn alone_written(words: &[Word], l: u32) -> String {
    let count = words.iter().find(|word| matches!(word.address, Address::P | Address::Q)).and_then(|word| word.whole());
    count.map_or_else(|| format!("G71 L{l}"), |count| format!("G71 L{l} Q{count}"))
}

/// What was meant by an L without use: other controls write tables and calls with it.
pub(super) fn meant(words: &[Word], functions: &Functions, l: Word) -> UnusedMeant {
    let spiral = functions.of(GGroup::G2).is_some_and(|(code, _)| code == GCode::G10);
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
