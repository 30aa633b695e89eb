//! Threads that work while the server listens. A panic in a job ends the job, not its thread.

use std::panic::{AssertUnwindSafe, catch_unwind};
use std::thread;

use crossbeam_channel::{Sender, unbounded};

type Job = Box<dyn FnOnce() + Send>;

/// A few threads that take jobs in the order given.
#[derive(Debug)]
pub(super) struct Workers {
    jobs: Sender<Job>,
}

impl Workers {
    /// `count` threads named `name`; they end with the value.
    pub(super) fn new(name: &str, count: usize) -> std::io::Result<Self> {
        let (jobs, queue) = unbounded::<Job>();
        for _ in 0..count {
            let queue = queue.clone();
            thread::Builder::new().name(name.to_owned()).spawn(move || {
                for job in queue {
                    let _ = catch_unwind(AssertUnwindSafe(job));
                }
            })?;
        }
        Ok(Self { jobs })
    }

    /// Puts a job into the queue.
    pub(super) fn run(&self, job: impl FnOnce() + Send + 'static) {
        // The threads hold the other end as long as this one lives.
        let _ = self.jobs.send(Box::new(job));
    }
}

/// What a panic says, for the log.
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
    use super::*;

    /// A panic ends its job; the thread takes the next one, and whoever guards a piece of work hears what happened.
    #[test]
    fn a_panic_ends_its_job_only() {
        let workers = Workers::new("test", 1).unwrap();
        let (into, out) = unbounded();
        workers.run(|| panic!("in a job"));
        let last = into.clone();
        workers.run(move || into.send(guarded(|| -> u8 { panic!("in {}", "an answer") })).unwrap());
        workers.run(move || last.send(guarded(|| 7)).unwrap());
        assert_eq!(out.recv().unwrap(), Err("in an answer".to_owned()));
        assert_eq!(out.recv().unwrap(), Ok(7));
    }
}
