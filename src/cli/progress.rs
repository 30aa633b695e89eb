//! A bar on stderr during long work, for people only: nothing is shown when stderr is no terminal, nor during the first
//! half second.

use std::io::{self, IsTerminal};
use std::sync::atomic::{AtomicU64, Ordering};
use std::sync::{Arc, Condvar, Mutex, PoisonError};
use std::thread::JoinHandle;
use std::time::Duration;

use indicatif::{ProgressBar, ProgressDrawTarget, ProgressStyle};

use super::words::Words;
use crate::dict::Lang;

/// Shorter work shows nothing.
const PATIENCE: Duration = Duration::from_millis(500);
/// How often the bar moves.
const STEP: Duration = Duration::from_millis(100);

/// The counted things.
#[derive(Clone, Copy, Debug)]
pub(super) enum Counted {
    /// Files, of so many.
    Files(u64),
    /// Executed blocks, nobody knows of how many.
    Blocks,
}

/// Work under way. The bar disappears when this is dropped.
#[derive(Debug)]
pub(super) struct Progress {
    shared: Arc<Shared>,
    thread: Option<JoinHandle<()>>,
}

#[derive(Debug, Default)]
struct Shared {
    done: AtomicU64,
    finished: Mutex<bool>,
    wake: Condvar,
}

impl Progress {
    /// Begins. `stdout_in_use` says that results are written while the work goes on: on a terminal they and the bar
    /// would mix.
    pub fn start(counted: Counted, stdout_in_use: bool, lang: Lang) -> Self {
        let visible = io::stderr().is_terminal() && !(stdout_in_use && io::stdout().is_terminal());
        let shared = Arc::new(Shared::default());
        let thread = visible.then(|| {
            let shared = Arc::clone(&shared);
            std::thread::Builder::new().spawn(move || show(&shared, counted, lang)).ok()
        });
        Self { shared, thread: thread.flatten() }
    }

    /// So much is done.
    pub fn set(&self, done: u64) {
        self.shared.done.store(done, Ordering::Relaxed);
    }

    /// One more is done.
    pub fn advance(&self) {
        self.shared.done.fetch_add(1, Ordering::Relaxed);
    }
}

impl Drop for Progress {
    fn drop(&mut self) {
        *self.shared.finished.lock().unwrap_or_else(PoisonError::into_inner) = true;
        self.shared.wake.notify_all();
        if let Some(thread) = self.thread.take() {
            let _ = thread.join();
        }
    }
}

/// Whether the work was finished within that time.
fn finished_within(shared: &Shared, time: Duration) -> bool {
    let finished = shared.finished.lock().unwrap_or_else(PoisonError::into_inner);
    let wait = shared.wake.wait_timeout_while(finished, time, |finished| !*finished);
    *wait.unwrap_or_else(PoisonError::into_inner).0
}

fn show(shared: &Shared, counted: Counted, lang: Lang) {
    if finished_within(shared, PATIENCE) {
        return;
    }
    let bar = bar(counted, lang);
    while !finished_within(shared, STEP) {
        bar.set_position(shared.done.load(Ordering::Relaxed));
        bar.tick();
    }
    bar.finish_and_clear();
}

fn bar(counted: Counted, lang: Lang) -> ProgressBar {
    let (length, template) = match counted {
        Counted::Files(files) => {
            (Some(files), format!("{} {{wide_bar}} {{pos}}/{{len}}", Words::CheckingFiles.text(lang)))
        }
        Counted::Blocks => (None, format!("{{spinner}} {{human_pos}} {} {{elapsed}}", Words::Blocks.text(lang))),
    };
    let bar = ProgressBar::with_draw_target(length, ProgressDrawTarget::stderr());
    match ProgressStyle::with_template(&template) {
        Ok(style) => bar.with_style(style),
        Err(_) => bar,
    }
}
