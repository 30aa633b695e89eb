//! The unknown after a fault (§13): the functions of some G groups.

use crate::dict::GGroup;

/// Some G groups.
#[derive(Clone, Copy, Debug, Default, Eq, PartialEq)]
pub(super) struct Groups(u16);

impl Groups {
    /// Those with functions that last: a malformed G leaves them unknown. What holds in its own block only is unknown
    /// there.
    pub(super) fn lasting() -> Self {
        let lasting = |group: &GGroup| !matches!(group, GGroup::G4 | GGroup::G7);
        GGroup::ALL.into_iter().filter(lasting).fold(Self::default(), Self::with)
    }

    /// One more.
    #[must_use]
    pub(super) const fn with(self, group: GGroup) -> Self {
        Self(self.0 | 1 << group.index())
    }

    /// One less.
    #[must_use]
    pub(super) const fn without(self, group: GGroup) -> Self {
        Self(self.0 & !(1 << group.index()))
    }

    /// Those of both.
    #[must_use]
    pub(super) const fn and(self, other: Self) -> Self {
        Self(self.0 | other.0)
    }

    pub(super) const fn has(self, group: GGroup) -> bool {
        self.0 & 1 << group.index() != 0
    }

    /// Whether one of `groups` is among them.
    pub(super) fn has_any(self, groups: &[GGroup]) -> bool {
        self.0 != 0 && groups.iter().any(|group| self.has(*group))
    }

    pub(super) const fn is_empty(self) -> bool {
        self.0 == 0
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn sets() {
        let groups = Groups::default().with(GGroup::G0).with(GGroup::G9);
        assert!(groups.has(GGroup::G9) && !groups.has(GGroup::G1) && !groups.is_empty());
        assert!(groups.has_any(&[GGroup::G1, GGroup::G0]) && !groups.has_any(&[GGroup::G1]));
        assert!(groups.without(GGroup::G0).without(GGroup::G9).is_empty());
        assert!(!Groups::lasting().has(GGroup::G4) && Groups::lasting().has(GGroup::G11));
        assert!(Groups::default().and(groups).has(GGroup::G0));
    }
}
