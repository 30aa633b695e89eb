//! Threads that work while the server listens. A panic in a job ends the job, not its thread.

use std::collections::{BTreeSet, VecDeque};
use std::panic::{AssertUnwindSafe, catch_unwind};
use std::path::PathBuf;
use std::sync::{Arc, Condvar, Mutex, MutexGuard, PoisonError};
use std::thread;

use super::snapshot::Needs;

type Job = Box<dyn FnOnce() + Send>;

/// Jobs of one lane are done one after the other: those that execute one program.
pub(super) type Lane = (PathBuf, Needs);

/// A few threads that take jobs in the order given, of each lane one at a time.
#[derive(Debug)]
pub(super) struct Workers {
    queue: Arc<Queue>,
}

#[derive(Default)]
struct Queue {
    state: Mutex<State>,
    changed: Condvar,
}

#[derive(Default)]
struct State {
    jobs: VecDeque<(Option<Lane>, Job)>,
    busy: BTreeSet<Lane>,
    /// No more jobs come.
    closed: bool,
}

impl Workers {
    /// `count` threads named `name`; they end with the value.
    pub(super) fn new(name: &str, count: usize) -> std::io::Result<Self> {
        let queue = Arc::new(Queue::default());
        for _ in 0..count {
            let queue = Arc::clone(&queue);
            thread::Builder::new().name(name.to_owned()).spawn(move || {
                while let Some((lane, job)) = queue.next() {
                    let _ = catch_unwind(AssertUnwindSafe(job));
                    if let Some(lane) = lane {
                        queue.state().busy.remove(&lane);
                        queue.changed.notify_all();
                    }
                }
            })?;
        }
        Ok(Self { queue })
    }

    /// Puts a job into the queue.
    pub(super) fn run(&self, lane: Option<Lane>, job: impl FnOnce() + Send + 'static) {
        self.queue.state().jobs.push_back((lane, Box::new(job)));
        self.queue.changed.notify_one();
    }
}

impl Drop for Workers {
    fn drop(&mut self) {
        self.queue.state().closed = true;
        self.queue.changed.notify_all();
    }
}

impl Queue {
    fn state(&self) -> MutexGuard<'_, State> {
        self.state.lock().unwrap_or_else(PoisonError::into_inner)
    }

    /// The next job whose lane is free; waits for one. `None` when no more come.
    fn next(&self) -> Option<(Option<Lane>, Job)> {
        let mut state = self.state();
        loop {
            let State { jobs, busy, closed } = &mut *state;
            let is_free = |(lane, _): &(Option<Lane>, Job)| lane.as_ref().is_none_or(|lane| !busy.contains(lane));
            if let Some(job) = jobs.iter().position(is_free).and_then(|at| jobs.remove(at)) {
                busy.extend(job.0.clone());
                return Some(job);
            }
            if *closed {
                return None;
            }
            state = self.changed.wait(state).unwrap_or_else(PoisonError::into_inner);
        }
    }
}

impl std::fmt::Debug for Queue {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        f.debug_struct("Queue").finish_non_exhaustive()
    }
}

/// The message of a panic, for the log.
pub(super) fn panic_message(panic: &(dyn std::any::Any + Send)) -> String {
    let text = panic.downcast_ref::<&str>().map(|text| (*text).to_owned());
    text.or_else(|| panic.downcast_ref::<String>().cloned()).unwrap_or_else(|| "no message".to_owned())
}

/// Runs `work`; what a panic says instead of its result.
pub(super) fn guarded<T>(work: impl FnOnce() -> T) -> Result<T, String> {
    catch_unwind(AssertUnwindSafe(work)).map_err(|panic| panic_message(panic.as_ref()))
}

#[cfg(test)]
mod tests {
    use crossbeam_channel::unbounded;

    use super::*;

    /// Of two threads one stays free for others, whatever waits in a lane; a lane keeps its order.
    #[test]
    fn one_of_a_lane_at_a_time() {
        let workers = Workers::new("test", 2).unwrap();
        let (begun, begins) = unbounded();
        let (go_on, wait) = unbounded::<()>();
        let lane = || Some((PathBuf::from("long.nc"), Needs::Run));
        for job in 1..=3 {
            let (begun, wait) = (begun.clone(), wait.clone());
            workers.run(lane(), move || {
                begun.send(job).unwrap();
                wait.recv().unwrap();
            });
        }
        workers.run(None, move || begun.send(9).unwrap());
        let mut first = [begins.recv().unwrap(), begins.recv().unwrap()];
        first.sort_unstable();
        assert_eq!(first, [1, 9]);
        for next in [2, 3] {
            go_on.send(()).unwrap();
            assert_eq!(begins.recv().unwrap(), next);
        }
        go_on.send(()).unwrap();
    }

    /// A panic ends its job; the thread takes the next one, and a guard returns its message.
    #[test]
    fn a_panic_ends_its_job_only() {
        let workers = Workers::new("test", 1).unwrap();
        let (into, out) = unbounded();
        workers.run(None, || panic!("in a job"));
        let last = into.clone();
        workers.run(None, move || into.send(guarded(|| -> u8 { panic!("in {}", "an answer") })).unwrap());
        workers.run(None, move || last.send(guarded(|| 7)).unwrap());
        assert_eq!(out.recv().unwrap(), Err("in an answer".to_owned()));
        assert_eq!(out.recv().unwrap(), Ok(7));
    }
}
