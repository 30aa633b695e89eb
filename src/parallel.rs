//! Work on several threads: with the feature `parallel`, and where the system gives threads. Else the same work is done by
//! the caller, with the same result.

use std::thread::{Scope, ScopedJoinHandle};

/// How many threads share the work; 1: there is nothing to be won by parting it.
#[cfg(feature = "parallel")]
pub fn threads() -> usize {
    rayon::current_num_threads()
}

/// How many threads share the work; 1: there is nothing to be won by parting it.
#[cfg(not(feature = "parallel"))]
pub const fn threads() -> usize {
    1
}

/// Does both, side by side.
#[cfg(feature = "parallel")]
pub fn join<A: Send, B: Send>(a: impl FnOnce() -> A + Send, b: impl FnOnce() -> B + Send) -> (A, B) {
    rayon::join(a, b)
}

/// Does both, one after the other.
#[cfg(not(feature = "parallel"))]
pub fn join<A: Send, B: Send>(a: impl FnOnce() -> A + Send, b: impl FnOnce() -> B + Send) -> (A, B) {
    (a(), b())
}

/// What `work` makes of each item, in the order of the items.
#[cfg(feature = "parallel")]
pub fn map<T: Send, R: Send>(items: Vec<T>, work: impl Fn(T) -> R + Sync) -> Vec<R> {
    use rayon::prelude::*;
    items.into_par_iter().map(&work).collect()
}

/// What `work` makes of each item, in the order of the items.
#[cfg(not(feature = "parallel"))]
pub fn map<T: Send, R: Send>(items: Vec<T>, work: impl Fn(T) -> R + Sync) -> Vec<R> {
    items.into_iter().map(work).collect()
}

/// Does `work` in a thread of that name beside what follows; `None`, and the work is dropped, without a thread to do it.
pub fn beside<'scope, T: Send + 'scope>(
    scope: &'scope Scope<'scope, '_>,
    name: &str,
    work: impl FnOnce() -> T + Send + 'scope,
) -> Option<ScopedJoinHandle<'scope, T>> {
    if !cfg!(feature = "parallel") {
        return None;
    }
    std::thread::Builder::new().name(name.to_owned()).spawn_scoped(scope, work).ok()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_order_of_items_stays() {
        assert_eq!(map((0..1000).collect(), |number: u32| number * 2), (0..1000).map(|n| n * 2).collect::<Vec<_>>());
        assert_eq!(join(|| 1, || 2), (1, 2));
        assert!(threads() >= 1);
    }
}
