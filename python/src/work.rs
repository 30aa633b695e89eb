//! Long work: without the interpreter's lock, and stopped by Ctrl-C.

use std::sync::atomic::{AtomicBool, Ordering};
use std::sync::mpsc::{RecvTimeoutError, sync_channel};
use std::sync::{Arc, Mutex, PoisonError};
use std::time::Duration;

use pyo3::exceptions::PyRuntimeError;
use pyo3::prelude::*;
use rayon::{ThreadPool, ThreadPoolBuilder};

/// So often it is asked whether somebody pressed Ctrl-C.
const ASK: Duration = Duration::from_millis(50);

/// Asked from time to time during long work with the number of blocks executed; `false`: it has to stop.
pub type GoesOn<'a> = dyn Fn(u64) -> bool + Sync + 'a;

/// The threads of this process. A process that was forked has none of the threads of its parent, and gets its own.
fn pool() -> PyResult<Arc<ThreadPool>> {
    static POOL: Mutex<Option<(u32, Arc<ThreadPool>)>> = Mutex::new(None);
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
/// The exception that a signal raises, as Ctrl-C does; the work has stopped then.
pub fn work<T: Send>(py: Python<'_>, work: impl FnOnce(&GoesOn<'_>) -> T + Send) -> PyResult<T> {
    let pool = pool()?;
    let cancelled = AtomicBool::new(false);
    let mut raised = None;
    let made = py.detach(|| {
        let mut made = None;
        let (done, wait) = sync_channel(1);
        pool.in_place_scope(|scope| {
            let (made, cancelled) = (&mut made, &cancelled);
            scope.spawn(move |_| {
                // Gone when the work is done, also by a panic.
                let _done = done;
                *made = Some(work(&|_| !cancelled.load(Ordering::Relaxed)));
            });
            while let Err(RecvTimeoutError::Timeout) = wait.recv_timeout(ASK) {
                if raised.is_none()
                    && let Err(error) = Python::attach(|py| py.check_signals())
                {
                    cancelled.store(true, Ordering::Relaxed);
                    raised = Some(error);
                }
            }
            let _: Result<(), _> = wait.try_recv();
        });
        made
    });
    match (raised, made) {
        (Some(error), _) => Err(error),
        (None, Some(made)) => Ok(made),
        (None, None) => Err(PyRuntimeError::new_err("the work ended without a result")),
    }
}
