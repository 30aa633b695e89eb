//! Steps on their way to a writer: a second thread makes text of them while execution continues.

use std::io;
use std::sync::mpsc::{Receiver, Sender, SyncSender, channel, sync_channel};
use std::thread::scope;

use super::reader::{Header, Writer};
use super::steps::{Place, Step};
use super::values::Value;
use crate::dict::Micro;
use crate::parallel;
use crate::run::End;

/// Steps go to the thread in batches of so many. Fuzzing has short programs.
const STEPS: usize = if cfg!(fuzzing) { 2 } else { 4096 };
/// A batch with so many changes of values is handed on whatever it holds.
const CHANGES: usize = 1 << 16;
/// Batches under way at most: what writes slowly makes execution wait, not grow.
const QUEUE: usize = 2;

/// Lets `run` have a writer whose steps go to `writer` in a parallel thread; without a thread, `writer`
/// itself. The second result is the first error of `writer` in its thread.
pub fn beside<T>(writer: &mut (dyn Writer + Send), run: impl FnOnce(&mut dyn Writer) -> T) -> (T, io::Result<()>) {
    let (full, messages) = sync_channel(QUEUE);
    let (done, empty) = channel();
    scope(|scope| match parallel::beside(scope, "writer", || write(messages, done)) {
        Some(thread) => {
            let mut here = Beside { writer: Some(writer), full, empty, batch: Batch::default(), begun: false };
            let result = run(&mut here);
            drop(here);
            (result, thread.join().unwrap_or_else(|_| Err(stopped())))
        }
        None => (run(writer), Ok(())),
    })
}

fn stopped() -> io::Error {
    io::Error::other("the writer has stopped")
}

/// What goes to the thread.
enum Message<'w> {
    /// First: where all that follows goes.
    Writer(&'w mut (dyn Writer + Send)),
    Batch(Batch),
    End(End),
}

/// Steps, one after another.
#[derive(Default)]
struct Batch {
    /// Before the first step of all: its values and those before it.
    first: Option<[Vec<Value>; 2]>,
    steps: Vec<Brief>,
    /// Of all steps: which values changed, and to what.
    changes: Vec<(usize, Value)>,
    /// Other files, each with the number of steps before it.
    files: Vec<(usize, u32, String)>,
}

/// A step without its values.
#[derive(Clone, Copy)]
struct Brief {
    place: Place,
    start_s: Option<Micro>,
    end_s: Option<Micro>,
    /// How many changes are its own.
    changes: usize,
}

/// The writer that hands on.
struct Beside<'w> {
    /// Until it goes to the thread.
    writer: Option<&'w mut (dyn Writer + Send)>,
    full: SyncSender<Message<'w>>,
    empty: Receiver<Batch>,
    batch: Batch,
    begun: bool,
}

impl<'w> Beside<'w> {
    fn send(&self, message: Message<'w>) -> io::Result<()> {
        self.full.send(message).map_err(|_| stopped())
    }

    fn hand_on(&mut self) -> io::Result<()> {
        let next = self.empty.try_recv().unwrap_or_default();
        let batch = std::mem::replace(&mut self.batch, next);
        self.send(Message::Batch(batch))
    }
}

impl Writer for Beside<'_> {
    fn wants_lines(&self) -> bool {
        self.writer.as_ref().is_none_or(|writer| writer.wants_lines())
    }

    fn begin(&mut self, header: &Header<'_>) -> io::Result<()> {
        let Some(writer) = self.writer.take() else { return Ok(()) };
        writer.begin(header)?;
        self.send(Message::Writer(writer))
    }

    fn file(&mut self, index: u32, name: &str) -> io::Result<()> {
        self.batch.files.push((self.batch.steps.len(), index, name.to_owned()));
        Ok(())
    }

    fn step(&mut self, step: &Step<'_>) -> io::Result<()> {
        let Step { place, start_s, end_s, values, before, changed } = *step;
        let Batch { first, steps, changes, .. } = &mut self.batch;
        if !self.begun {
            self.begun = true;
            *first = Some([values.to_vec(), before.to_vec()]);
        }
        steps.push(Brief { place, start_s, end_s, changes: changed.len() });
        changes.extend(changed.iter().filter_map(|&index| Some((index, *values.get(index)?))));
        if steps.len() < STEPS && changes.len() < CHANGES { Ok(()) } else { self.hand_on() }
    }

    fn end(&mut self, end: End) -> io::Result<()> {
        self.hand_on()?;
        self.send(Message::End(end))
    }
}

/// The writing thread's copy of the step written last.
#[derive(Default)]
struct Written {
    values: Vec<Value>,
    before: Vec<Value>,
    changed: Vec<usize>,
}

impl Written {
    fn write(&mut self, batch: &mut Batch, writer: &mut dyn Writer) -> io::Result<()> {
        let Batch { first, steps, changes, files } = batch;
        let mut files = files.drain(..).peekable();
        let mut changes = changes.drain(..);
        for (at, brief) in steps.drain(..).enumerate() {
            while let Some((_, index, name)) = files.next_if(|(before, ..)| *before <= at) {
                writer.file(index, &name)?;
            }
            self.advance(brief, first.take(), &mut changes);
            let Self { values, before, changed } = self;
            let Brief { place, start_s, end_s, .. } = brief;
            writer.step(&Step { place, start_s, end_s, values, before, changed })?;
        }
        files.try_for_each(|(_, index, name)| writer.file(index, &name))
    }

    fn advance(
        &mut self,
        brief: Brief,
        first: Option<[Vec<Value>; 2]>,
        changes: &mut impl Iterator<Item = (usize, Value)>,
    ) {
        let Self { values, before, changed } = self;
        for &index in &*changed {
            if let (Some(before), Some(now)) = (before.get_mut(index), values.get(index)) {
                *before = *now;
            }
        }
        changed.clear();
        if let Some(first) = first {
            [*values, *before] = first;
        }
        for (index, value) in changes.take(brief.changes) {
            changed.push(index);
            if let Some(slot) = values.get_mut(index) {
                *slot = value;
            }
        }
    }
}

fn write(messages: Receiver<Message<'_>>, done: Sender<Batch>) -> io::Result<()> {
    let mut writer = None;
    let mut written = Written::default();
    for message in messages {
        match (message, &mut writer) {
            (Message::Writer(given), _) => writer = Some(given),
            (Message::Batch(mut batch), Some(writer)) => {
                written.write(&mut batch, *writer)?;
                // Nobody may want it any more.
                let _ = done.send(batch);
            }
            (Message::End(end), Some(writer)) => writer.end(end)?,
            (Message::Batch(_) | Message::End(_), None) => {}
        }
    }
    Ok(())
}
