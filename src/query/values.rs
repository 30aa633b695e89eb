//! The values at each execution of a block: the first few different ones, and the limits of all.

use std::fmt::Display;

/// Different values that are kept.
const KEPT: usize = 4;

/// The different values of one thing, in the order in which they came.
#[derive(Clone, Debug, Eq, PartialEq)]
pub(crate) struct Values<T> {
    kept: Vec<T>,
    /// There are more than are kept.
    more: bool,
    /// Least and greatest of all.
    limits: Option<(T, T)>,
    /// It was not known at least once.
    unknown: bool,
}

impl<T> Default for Values<T> {
    fn default() -> Self {
        Self { kept: Vec::new(), more: false, limits: None, unknown: false }
    }
}

impl<T: Copy + Ord> Values<T> {
    /// Takes the value of one execution; `None`: not known.
    pub(crate) fn add(&mut self, value: Option<T>) {
        let Some(value) = value else {
            self.unknown = true;
            return;
        };
        self.limits = Some(match self.limits {
            Some((least, greatest)) => (least.min(value), greatest.max(value)),
            None => (value, value),
        });
        if !self.more && !self.kept.contains(&value) {
            if self.kept.len() < KEPT {
                self.kept.push(value);
            } else {
                self.more = true;
            }
        }
    }

    /// Whether it was known at least once.
    pub(crate) fn is_known(&self) -> bool {
        !self.kept.is_empty()
    }

    /// Whether nothing came, not even something unknown.
    pub(crate) fn is_empty(&self) -> bool {
        self.kept.is_empty() && !self.unknown
    }

    /// The value, when it was always the same.
    pub(crate) fn only(&self) -> Option<T> {
        match self.kept.as_slice() {
            [only] if !self.unknown => Some(*only),
            _ => None,
        }
    }

    /// The first value.
    pub(crate) fn first(&self) -> Option<T> {
        self.kept.first().copied()
    }

    /// The values made into others; `each` keeps or turns their order.
    pub(crate) fn map<U: Copy + Ord>(&self, each: impl Fn(T) -> U) -> Values<U> {
        let turned = |(a, b): (T, T)| {
            let (a, b) = (each(a), each(b));
            (a.min(b), a.max(b))
        };
        Values {
            kept: self.kept.iter().map(|value| each(*value)).collect(),
            more: self.more,
            limits: self.limits.map(turned),
            unknown: self.unknown,
        }
    }

    /// `10, 20, 30, 40, … (min 10, max 200)`; `?` marks unknown ones.
    pub(crate) fn list<D: Display>(&self, shown: impl Fn(T) -> D) -> String {
        let mut text = self.brief(KEPT, &shown);
        if self.more
            && let Some((least, greatest)) = self.limits
        {
            text.push_str(&format!(" (min {}, max {})", shown(least), shown(greatest)));
        }
        text
    }

    /// `10, 20, 30, …`, at most `count` of them.
    pub(crate) fn brief<D: Display>(&self, count: usize, shown: impl Fn(T) -> D) -> String {
        let mut parts: Vec<String> = self.kept.iter().take(count).map(|value| shown(*value).to_string()).collect();
        if self.more || self.kept.len() > count {
            parts.push("…".to_owned());
        }
        if self.unknown {
            parts.push("?".to_owned());
        }
        parts.join(", ")
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn of(values: impl IntoIterator<Item = i32>) -> Values<i32> {
        let mut result = Values::default();
        for value in values {
            result.add(Some(value));
        }
        result
    }

    #[test]
    fn lists() {
        assert_eq!(of([3, 3, 3]).list(|value| value), "3");
        assert_eq!(of([3, 1, 3, 2]).list(|value| value), "3, 1, 2");
        assert_eq!(of(1..=9).list(|value| value), "1, 2, 3, 4, … (min 1, max 9)");
        assert_eq!(of(1..=9).map(|value| -value).list(|value| value), "-1, -2, -3, -4, … (min -9, max -1)");
        assert_eq!(of(1..=3).brief(2, |value| value), "1, 2, …");
    }

    #[test]
    fn what_is_not_known() {
        let mut values = of([5]);
        assert_eq!(values.only(), Some(5));
        values.add(None);
        assert_eq!((values.only(), values.list(|value| value).as_str()), (None, "5, ?"));
        assert!(of([]).is_empty() && !of([]).is_known());
    }
}
