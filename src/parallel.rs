//! Work on several threads: with the feature `parallel`, and where the system gives threads. Else the same work is done
//! by the caller, with the same result.

use std::panic::resume_unwind;
use std::sync::mpsc::{SyncSender, sync_channel};
use std::thread::{Builder, JoinHandle, Scope, ScopedJoinHandle};

/// Items go to the thread of a [`Fold`] in batches of so many. Fuzzing has short programs.
const ITEMS: usize = if cfg!(fuzzing) { 2 } else { 512 };
/// Batches under way at most: a slow thread makes its caller wait, not grow.
const BATCHES: usize = 4;

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

/// Does `work` in a thread of that name beside what follows; `None`, and the work is dropped, without a thread to do
/// it.
pub fn beside<'scope, T: Send + 'scope>(
    scope: &'scope Scope<'scope, '_>,
    name: &str,
    work: impl FnOnce() -> T + Send + 'scope,
) -> Option<ScopedJoinHandle<'scope, T>> {
    if !cfg!(feature = "parallel") {
        return None;
    }
    Builder::new().name(name.to_owned()).spawn_scoped(scope, work).ok()
}

/// Does `work` in a thread of that name, which ends by itself; `None`, and the work is dropped, without a thread to do
/// it.
pub fn apart<T: Send + 'static>(name: &str, work: impl FnOnce() -> T + Send + 'static) -> Option<JoinHandle<T>> {
    if !cfg!(feature = "parallel") {
        return None;
    }
    Builder::new().name(name.to_owned()).spawn(work).ok()
}

/// Adds items to a state, in their order: in a separate thread once there are more than a few, while the caller finds
/// the next ones.
#[derive(Debug)]
pub struct Fold<T, S> {
    name: &'static str,
    add: fn(&mut S, &T),
    /// Without the items of the thread.
    state: S,
    batch: Vec<T>,
    thread: Thread<T, S>,
}

#[derive(Debug)]
enum Thread<T, S> {
    /// Few items came so far.
    NotYet,
    /// There is none to be had.
    Never,
    There(SyncSender<Vec<T>>, JoinHandle<S>),
}

impl<T: Send + 'static, S: Clone + Send + 'static> Fold<T, S> {
    /// From a state that no item was added to. `name`: of the thread.
    pub const fn new(name: &'static str, state: S, add: fn(&mut S, &T)) -> Self {
        Self { name, add, state, batch: Vec::new(), thread: Thread::NotYet }
    }

    /// The next item.
    #[inline]
    pub fn push(&mut self, item: T) {
        self.batch.push(item);
        if self.batch.len() == ITEMS {
            self.hand_on();
        }
    }

    /// The state with all items.
    ///
    /// # Panics
    /// When adding an item did.
    pub fn finish(mut self) -> S {
        if let Thread::There(full, thread) = self.thread {
            // A thread that takes no more has panicked.
            let _ = full.send(self.batch);
            drop(full);
            return thread.join().unwrap_or_else(|panic| resume_unwind(panic));
        }
        self.batch.iter().for_each(|item| (self.add)(&mut self.state, item));
        self.state
    }

    #[cold]
    fn hand_on(&mut self) {
        if matches!(self.thread, Thread::NotYet) {
            self.thread = self.start();
        }
        match &self.thread {
            Thread::There(full, _) => {
                let batch = std::mem::replace(&mut self.batch, Vec::with_capacity(ITEMS));
                // A thread that takes no more has panicked, as the end tells.
                let _ = full.send(batch);
            }
            Thread::NotYet | Thread::Never => {
                let Self { add, state, batch, .. } = self;
                batch.drain(..).for_each(|item| add(state, &item));
            }
        }
    }

    fn start(&self) -> Thread<T, S> {
        let (full, batches) = sync_channel::<Vec<T>>(BATCHES);
        let (add, mut state) = (self.add, self.state.clone());
        let work = move || {
            batches.iter().flatten().for_each(|item| add(&mut state, &item));
            state
        };
        apart(self.name, work).map_or(Thread::Never, |thread| Thread::There(full, thread))
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_fold_adds_all_items_in_their_order() {
        for count in [0, 1, ITEMS - 1, ITEMS, ITEMS + 1, ITEMS * (BATCHES + 3) + 7] {
            let mut fold = Fold::new("test", Vec::new(), |all: &mut Vec<usize>, item| all.push(*item));
            (0..count).for_each(|item| fold.push(item));
            assert_eq!(fold.finish(), (0..count).collect::<Vec<_>>());
        }
    }

    #[test]
    #[should_panic(expected = "of item 700")]
    fn a_panic_in_the_thread_comes_to_the_caller() {
        let mut fold = Fold::new("test", (), |(), item: &usize| assert!(*item < ITEMS + 188, "of item {item}"));
        (0..ITEMS * 20).for_each(|item| fold.push(item));
        fold.finish();
    }

    #[test]
    fn the_order_of_items_stays() {
        assert_eq!(map((0..1000).collect(), |number: u32| number * 2), (0..1000).map(|n| n * 2).collect::<Vec<_>>());
        assert_eq!(join(|| 1, || 2), (1, 2));
        assert!(threads() >= 1);
    }
}
