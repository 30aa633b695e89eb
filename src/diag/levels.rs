//! The severity that each code has in a run.

use std::sync::LazyLock;

use super::{Code, LIMIT_PER_CODE, Severity};

/// What each code is in this run: an error, a warning, or allowed. Findings carry it from the moment they are added, so
/// that limits, counts, the exit status and the stream all see the same severity.
#[derive(Clone, Copy, Debug, Eq, PartialEq)]
pub struct Levels {
    of: [Option<Severity>; Code::ALL.len()],
    kept: usize,
}

impl Levels {
    /// Each code with what `severity` gives for it; `None` allows it.
    pub fn new(severity: impl Fn(Code) -> Option<Severity>) -> Self {
        let mut levels = Self { of: [None; Code::ALL.len()], kept: LIMIT_PER_CODE };
        for (slot, code) in levels.of.iter_mut().zip(Code::ALL) {
            *slot = severity(*code);
        }
        levels
    }

    /// The same, with so many findings of each code kept for each file.
    #[must_use]
    pub const fn keeping(self, kept: usize) -> Self {
        Self { kept, ..self }
    }

    /// How many findings of each code are kept for each file.
    pub const fn kept(&self) -> usize {
        self.kept
    }

    /// The severity of a code in this run; `None` when it is allowed.
    pub fn of(&self, code: Code) -> Option<Severity> {
        self.of.get(code as usize).copied().flatten()
    }

    /// Whether a finding of that code is an error in this run and unless configured: a warning that is denied is none.
    pub fn is_fault(&self, code: Code) -> bool {
        code.severity() == Severity::Error && self.of(code) == Some(Severity::Error)
    }
}

impl Default for Levels {
    /// The levels of the registry.
    fn default() -> Self {
        // Findings are made for each part of a text, and each block that is followed.
        static OF_REGISTRY: LazyLock<Levels> =
            LazyLock::new(|| Levels::new(|code| (!code.is_off()).then_some(code.severity())));
        *OF_REGISTRY
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn each_code_has_its_own() {
        let changed =
            [(Code::E0109, Some(Severity::Warning)), (Code::W0214, Some(Severity::Error)), (Code::W0110, None)];
        let of =
            |code: Code| changed.iter().find(|(other, _)| *other == code).map_or(Some(code.severity()), |(_, to)| *to);
        let levels = Levels::new(of);
        for &code in Code::ALL {
            assert_eq!(levels.of(code), of(code), "{code}");
        }
        assert!(!levels.is_fault(Code::E0109) && !levels.is_fault(Code::W0214) && levels.is_fault(Code::E0101));
    }
}
