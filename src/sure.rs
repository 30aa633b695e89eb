//! What cannot be otherwise. Tests and fuzzing, which are built with debug assertions, stop where it is; users get a
//! default, since no fault of ours may take an editor or a run down.

/// A count of bytes, lines, words or the like of texts, each of which has less than 4 GiB.
#[inline]
#[track_caller]
pub fn small(count: usize) -> u32 {
    debug_assert!(u32::try_from(count).is_ok(), "{count} is no count of a text");
    u32::try_from(count).unwrap_or(u32::MAX)
}

/// Something that is always there.
pub trait Sure<T> {
    /// Gives it; with debug assertions it panics when it is missing.
    fn sure(self) -> T;
}

impl<T: Default> Sure<T> for Option<T> {
    #[inline]
    #[track_caller]
    fn sure(self) -> T {
        debug_assert!(self.is_some(), "what is always there is missing");
        self.unwrap_or_default()
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn what_is_there() {
        assert_eq!((small(7), Some("a").sure()), (7, "a"));
    }

    #[test]
    #[should_panic(expected = "is missing")]
    fn what_is_missing() {
        None::<u32>.sure();
    }

    #[test]
    #[should_panic(expected = "4294967296 is no count")]
    fn what_is_too_large() {
        small(1 << 32);
    }
}
