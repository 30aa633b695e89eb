//! Long work: without the interpreter's lock, and stopped by Ctrl-C.

use std::panic::{AssertUnwindSafe, catch_unwind, resume_unwind};
use std::sync::atomic::{AtomicBool, Ordering};
use std::sync::mpsc::{RecvTimeoutError, sync_channel};
use std::sync::{Arc, Mutex, PoisonError};
use std::time::Duration;

use pyo3::exceptions::PyRuntimeError;
use pyo3::prelude::*;
use rayon::{ThreadPool, ThreadPoolBuilder};

/// So often it is asked whether somebody pressed Ctrl-C.
const ASK: Duration = Duration::from_millis(50);
/// So long cancelled work is waited for.
const STOPS: Duration = Duration::from_millis(500);

/// Asked from time to time during long work with the number of blocks executed; `false`: it has to stop.
pub type GoesOn<'a> = dyn Fn(u64) -> bool + Sync + 'a;

/// The threads, and the process that has them.
static POOL: Mutex<Option<(u32, Arc<ThreadPool>)>> = Mutex::new(None);

/// The threads of this process. A process that was forked has none of the threads of its parent, and gets its own.
fn pool() -> PyResult<Arc<ThreadPool>> {
    let process = std::process::id();
    let mut known = POOL.lock().unwrap_or_else(PoisonError::into_inner);
    if let Some((of, pool)) = known.as_ref()
        && *of == process
    {
        return Ok(Arc::clone(pool));
    }
    let pool = ThreadPoolBuilder::new().thread_name(|at| format!("cnc872c-{at}")).build();
    let pool = Arc::new(pool.map_err(|error| PyRuntimeError::new_err(error.to_string()))?);
    // Nobody waits for threads that are not there.
    std::mem::forget(known.replace((process, Arc::clone(&pool))));
    Ok(pool)
}

/// What `work` makes, in another thread. Python's own threads run meanwhile.
///
/// # Errors
/// The exception that a signal raises, as Ctrl-C does. The work has stopped then, or stops as soon as it can: it may wait
/// for a pipe that nobody writes.
pub fn work<T: Send + 'static>(py: Python<'_>, work: impl FnOnce(&GoesOn<'_>) -> T + Send + 'static) -> PyResult<T> {
    let cancelled = Arc::new(AtomicBool::new(false));
    let (done, wait) = sync_channel(1);
    let asked = Arc::clone(&cancelled);
    pool()?.spawn(move || {
        let made = catch_unwind(AssertUnwindSafe(|| work(&|_| !asked.load(Ordering::Relaxed))));
        // Nobody waits for work that was cancelled long ago.
        let _: Result<(), _> = done.send(made);
    });
    let made = py.detach(move || {
        loop {
            match wait.recv_timeout(ASK) {
                Ok(made) => return Ok(made),
                Err(RecvTimeoutError::Disconnected) => {
                    return Err(PyRuntimeError::new_err("the work ended without a result"));
                }
                Err(RecvTimeoutError::Timeout) => {
                    if let Err(error) = Python::attach(|py| py.check_signals()) {
                        cancelled.store(true, Ordering::Relaxed);
                        if wait.recv_timeout(STOPS).is_err() {
                            // One of the threads may never come back: the next call gets others.
                            std::mem::forget(POOL.lock().unwrap_or_else(PoisonError::into_inner).take());
                        }
                        return Err(error);
                    }
                }
            }
        }
    });
    made?.map_or_else(|panic| resume_unwind(panic), Ok)
}
