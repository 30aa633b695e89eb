//! The stream on its way out: a second thread makes text of records and writes it beside execution. When that thread
//! is behind, the one that executes makes the text itself, so that neither waits while there is work.

use std::io::{self, Write};
use std::sync::mpsc::{Receiver, Sender, SyncSender, TrySendError, channel, sync_channel};
use std::thread::scope;

use super::records::{BlockRecord, Record};
use super::row::Before;
use super::writer::Writer;
use crate::dict::AxisLetter;
use crate::parallel;

/// Records go to the thread in batches of so many. Fuzzing has short programs.
const BATCH: usize = if cfg!(fuzzing) { 2 } else { 512 };
/// A batch whose text has so many bytes is handed on whatever it holds.
const PIECE: usize = 1 << 18;
/// Behind a record with more bytes of comments and calls a batch ends, so that none holds many of them.
const LONG: usize = 1 << 12;
/// Batches under way at most: what writes slowly makes execution wait, not grow.
const QUEUE: usize = 2;

/// Why no more records are taken: the writer had an error, which [`write_beside`] returns.
#[derive(Debug)]
pub(super) struct Closed;

/// A piece of the stream: text, and behind it records.
#[derive(Default)]
struct Batch {
    text: Vec<u8>,
    /// Records of blocks, of which the first `used` count; the others are kept for their memory.
    blocks: Vec<BlockRecord>,
    used: usize,
    /// Other records, each with the number of block records before it.
    rare: Vec<(usize, Record)>,
}

impl Batch {
    /// Makes text of the records.
    fn write(&mut self, writer: &mut Writer) {
        let Self { text, blocks, used, rare } = self;
        let mut rare = rare.drain(..).peekable();
        for (at, record) in blocks.iter().take(*used).enumerate() {
            while let Some((_, record)) = rare.next_if(|(before, _)| *before <= at) {
                writer.write_record(text, &record);
            }
            writer.write(text, record);
        }
        rare.for_each(|(_, record)| writer.write_record(text, &record));
        *used = 0;
    }
}

fn is_long(record: &BlockRecord) -> bool {
    let comments: usize = record.comments.iter().map(|comment| size_of_val(comment) + comment.len()).sum();
    size_of_val(record.calls.as_slice()) + comments > LONG
}

/// Where execution puts its records.
pub(super) struct Records<'o> {
    batch: Batch,
    /// How many block records are in it.
    count: usize,
    /// The thread is behind: the text of this batch is made here.
    here: bool,
    /// Where its records are made, one after the other.
    row: BlockRecord,
    writer: Writer,
    way: Way<'o>,
    closed: bool,
}

/// Where full batches go.
enum Way<'o> {
    /// To the thread that writes, which gives them back empty.
    Beside { full: SyncSender<Batch>, written: Receiver<Batch> },
    /// There is no thread: to the writer at once, and its error here.
    Alone { out: &'o mut (dyn Write + Send), error: Option<io::Error> },
}

impl<'o> Records<'o> {
    fn new(way: Way<'o>, axes: &[AxisLetter]) -> Self {
        Self {
            batch: Batch::default(),
            count: 0,
            here: false,
            row: BlockRecord::default(),
            writer: Writer::new(axes),
            way,
            closed: false,
        }
    }

    /// Whether the writer had an error.
    pub(super) const fn is_closed(&self) -> bool {
        self.closed
    }

    /// The next block record, as `fill` makes it. It is given a record to write over.
    #[inline]
    pub(super) fn block(&mut self, fill: impl FnOnce(&mut BlockRecord, Before<'_>)) -> Result<(), Closed> {
        let Batch { text, blocks, used, .. } = &mut self.batch;
        let long = if self.here {
            fill(&mut self.row, if self.count > 0 { Before::InPlace } else { Before::Nowhere });
            self.writer.write(text, &self.row);
            text.len() >= PIECE
        } else {
            if blocks.len() == *used {
                blocks.push(BlockRecord::default());
            }
            let (before, slots) = blocks.split_at_mut(*used);
            let Some(slot) = slots.first_mut() else { return Err(Closed) };
            fill(slot, before.last().map_or(Before::Nowhere, Before::Beside));
            *used += 1;
            is_long(slot)
        };
        self.count += 1;
        if self.count < BATCH && !long { Ok(()) } else { self.hand_on() }
    }

    /// The next record of another kind.
    pub(super) fn rare(&mut self, record: Record) {
        let Batch { text, used, rare, .. } = &mut self.batch;
        if self.here { self.writer.write_record(text, &record) } else { rare.push((*used, record)) }
    }

    fn hand_on(&mut self) -> Result<(), Closed> {
        self.count = 0;
        let taken = match &mut self.way {
            Way::Beside { full, written } => {
                let next = written.try_recv().unwrap_or_default();
                let batch = std::mem::replace(&mut self.batch, next);
                match full.try_send(batch) {
                    Ok(()) => {
                        self.here = false;
                        true
                    }
                    Err(TrySendError::Full(batch)) => {
                        self.here = true;
                        full.send(batch).is_ok()
                    }
                    Err(TrySendError::Disconnected(_)) => false,
                }
            }
            Way::Alone { out, error } => {
                self.batch.write(&mut self.writer);
                let result = out.write_all(&self.batch.text);
                self.batch.text.clear();
                *error = result.err();
                error.is_none()
            }
        };
        self.closed = !taken;
        if taken { Ok(()) } else { Err(Closed) }
    }
}

/// Runs `execute`, and writes to `out` the records that it gives, for a machine with these axes, at the same time.
/// Without a thread they are written in between.
///
/// # Errors
/// What `out` says.
pub(super) fn write_beside<T>(
    out: &mut (dyn Write + Send),
    axes: &[AxisLetter],
    execute: impl FnOnce(&mut Records<'_>) -> Result<T, Closed>,
) -> io::Result<T> {
    let stopped = || io::Error::other("the writer has stopped");
    let mut execute = Some(execute);
    let beside = scope(|scope| {
        let (full, batches) = sync_channel(QUEUE);
        let (done, written) = channel();
        let thread = parallel::beside(scope, "writer", || write(out, Writer::new(axes), batches, done))?;
        let execute = execute.take()?;
        let mut records = Records::new(Way::Beside { full, written }, axes);
        let result = execute(&mut records).and_then(|result| records.hand_on().map(|()| result));
        drop(records);
        let written = thread.join().map_err(|_| stopped()).flatten();
        Some(written.and_then(|()| result.map_err(|Closed| stopped())))
    });
    match (beside, execute) {
        (Some(result), _) => result,
        (None, Some(execute)) => write_alone(out, axes, execute),
        (None, None) => Err(stopped()),
    }
}

fn write_alone<T>(
    out: &mut (dyn Write + Send),
    axes: &[AxisLetter],
    execute: impl FnOnce(&mut Records<'_>) -> Result<T, Closed>,
) -> io::Result<T> {
    let mut records = Records::new(Way::Alone { out, error: None }, axes);
    let result = execute(&mut records).and_then(|result| records.hand_on().map(|()| result));
    match (records.way, result) {
        (Way::Alone { error: Some(error), .. }, _) => Err(error),
        (Way::Alone { out, error: None }, Ok(result)) => out.flush().map(|()| result),
        (Way::Alone { .. } | Way::Beside { .. }, _) => Err(io::Error::other("the writer has stopped")),
    }
}

fn write(
    out: &mut (dyn Write + Send),
    mut writer: Writer,
    batches: Receiver<Batch>,
    done: Sender<Batch>,
) -> io::Result<()> {
    for mut batch in batches {
        batch.write(&mut writer);
        out.write_all(&batch.text)?;
        batch.text.clear();
        // Nobody may want it any more.
        let _ = done.send(batch);
    }
    out.flush()
}

#[cfg(test)]
mod tests {
    use std::time::Duration;

    use super::*;
    use crate::stream::records::FileRecord;

    fn put(records: &mut Records, count: u64) -> Result<(), Closed> {
        for seq in 0..count {
            if seq % 700 == 0 {
                let index = u32::try_from(seq).unwrap_or(0);
                records.rare(Record::File(FileRecord { index, name: "a".to_owned() }));
            }
            records.block(|record, _| {
                *record = BlockRecord {
                    seq,
                    comments: vec![if seq % 1900 == 5 { "long".repeat(LONG) } else { "c".repeat(seq as usize % 3) }],
                    ..BlockRecord::default()
                };
            })?;
        }
        Ok(())
    }

    /// Takes its time with some of what it is given.
    #[derive(Default)]
    struct Slow {
        taken: Vec<u8>,
        calls: u32,
        every: u32,
    }

    impl Write for Slow {
        fn write(&mut self, bytes: &[u8]) -> io::Result<usize> {
            self.calls += 1;
            if self.calls.is_multiple_of(self.every) {
                std::thread::sleep(Duration::from_millis(3));
            }
            self.taken.extend_from_slice(bytes);
            Ok(bytes.len())
        }

        fn flush(&mut self) -> io::Result<()> {
            Ok(())
        }
    }

    /// Whichever thread makes the text, the stream is the same.
    #[test]
    fn everything_arrives_in_order() {
        for count in [0, 1, BATCH as u64, 20_000] {
            let mut streams = Vec::new();
            for every in [u32::MAX, 1, 3] {
                let mut out = Slow { every, ..Slow::default() };
                write_beside(&mut out, &[AxisLetter::X], |records| put(records, count)).unwrap();
                streams.push(out.taken);
            }
            let lines = streams[0].split(|byte| *byte == b'\n').filter(|line| !line.is_empty());
            let (blocks, files): (Vec<_>, Vec<_>) = lines
                .map(|line| serde_json::from_slice::<serde_json::Value>(line).unwrap())
                .partition(|record| record["kind"] == "block");
            assert_eq!((blocks.len() as u64, files.len() as u64), (count, count.div_ceil(700)));
            assert!(blocks.iter().enumerate().all(|(at, block)| block["seq"] == at));
            assert!(streams.iter().all(|stream| *stream == streams[0]), "{count}");
        }
    }

    struct Full;

    impl Write for Full {
        fn write(&mut self, _: &[u8]) -> io::Result<usize> {
            Err(io::ErrorKind::StorageFull.into())
        }

        fn flush(&mut self) -> io::Result<()> {
            Ok(())
        }
    }

    #[test]
    fn an_error_comes_back() {
        for count in [1, 1_000_000] {
            let error = write_beside(&mut Full, &[], |records| put(records, count)).unwrap_err();
            assert_eq!(error.kind(), io::ErrorKind::StorageFull);
        }
    }
}
