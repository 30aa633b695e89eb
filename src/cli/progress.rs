//! A bar on stderr during long work, for people only: nothing is shown when stderr is no terminal, nor during the first
//! half second.

use std::io::{self, IsTerminal};
use std::sync::Arc;
use std::sync::atomic::{AtomicU64, Ordering};
use std::sync::mpsc::{Receiver, RecvTimeoutError, Sender, channel};
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
    done: Arc<AtomicU64>,
    /// Ends the thread when it is dropped.
    under_way: Option<Sender<()>>,
    thread: Option<JoinHandle<()>>,
}

impl Progress {
    /// Begins. `stdout_in_use` says that results are written while the work goes on: on a terminal they and the bar
    /// would mix.
    pub fn start(counted: Counted, stdout_in_use: bool, lang: Lang) -> Self {
        let visible = io::stderr().is_terminal() && !(stdout_in_use && io::stdout().is_terminal());
        let done = Arc::new(AtomicU64::default());
        let (under_way, ended) = channel();
        let thread = visible.then(|| {
            let done = Arc::clone(&done);
            std::thread::Builder::new().spawn(move || show(&done, &ended, counted, lang)).ok()
        });
        Self { done, under_way: Some(under_way), thread: thread.flatten() }
    }

    /// Takes how much is done, of work that nobody stops.
    pub fn counter(&self) -> impl Fn(u64) -> bool + Sync + use<> {
        let counted = Arc::clone(&self.done);
        move |done| {
            counted.store(done, Ordering::Relaxed);
            true
        }
    }

    /// One more is done.
    pub fn advance(&self) {
        self.done.fetch_add(1, Ordering::Relaxed);
    }
}

impl Drop for Progress {
    fn drop(&mut self) {
        self.under_way = None;
        if let Some(thread) = self.thread.take() {
            let _ = thread.join();
        }
    }
}

fn show(done: &AtomicU64, ended: &Receiver<()>, counted: Counted, lang: Lang) {
    let is_over = |time: Duration| ended.recv_timeout(time) != Err(RecvTimeoutError::Timeout);
    if is_over(PATIENCE) {
        return;
    }
    let bar = bar(counted, lang);
    while !is_over(STEP) {
        bar.set_position(done.load(Ordering::Relaxed));
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
