//! Threads, also where the system gives few or no threads.

use std::sync::Once;
use std::thread::{Builder, available_parallelism};

use crossbeam_channel::bounded;

/// Lets the work that follows be done by this thread alone when the system gives no threads (a container with a limit
/// of processes): the pool would end the program. For commands, whose work begins in one thread.
pub(super) fn prepare() {
    static ONCE: Once = Once::new();
    ONCE.call_once(|| {
        if !can_start(wanted()) {
            // It fails when there is a pool already, which then works.
            let _ = rayon::ThreadPoolBuilder::new().num_threads(1).use_current_thread().build_global();
        }
    });
}

/// The size of the pool, and one for the work besides it.
#[expect(clippy::disallowed_methods, reason = "the pool reads the same variable")]
fn wanted() -> usize {
    let said =
        std::env::var("RAYON_NUM_THREADS").ok().and_then(|number| number.parse().ok()).filter(|&number| number > 0);
    said.unwrap_or_else(|| available_parallelism().map_or(1, usize::from)) + 1
}

/// Whether so many threads can be there at once.
fn can_start(threads: usize) -> bool {
    let (hold, wait) = bounded::<()>(0);
    std::thread::scope(|scope| {
        let started = (0..threads).all(|_| {
            let wait = wait.clone();
            Builder::new().spawn_scoped(scope, move || wait.recv().is_ok()).is_ok()
        });
        drop(hold);
        started
    })
}
