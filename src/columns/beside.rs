//! Columns of blocks made beside execution: a second thread puts records into rows, and gives full batches back.

use std::io;
use std::sync::mpsc::{Receiver, Sender, SyncSender, channel, sync_channel};
use std::thread::JoinHandle;

use arrow_array::RecordBatch;
use arrow_schema::{ArrowError, SchemaRef};

use super::batches::Rows;
use super::blocks::put;
use super::table::{ROWS, Table};
use crate::config::Axis;
use crate::parallel;
use crate::stream::BlockRecord;

/// Records go to the thread in so many at once.
const RECORDS: usize = 512;
/// So many times under way at most: a slow thread makes execution wait, not grow.
const QUEUE: usize = 4;

/// A record under way.
#[derive(Default)]
struct UnderWay {
    record: BlockRecord,
    /// It has only what may differ from the row before.
    follows: bool,
}

impl UnderWay {
    fn put(&self, table: &mut Table, axes: &[Axis]) {
        if self.follows { put::<true>(table, &self.record, axes) } else { put::<false>(table, &self.record, axes) }
    }
}

/// What comes back.
enum Made {
    Batch(Result<RecordBatch, ArrowError>),
    /// Records that were put into rows, for their memory.
    Used(Vec<UnderWay>),
}

/// Who puts records into rows.
enum Way {
    /// Few records came so far.
    NotYet,
    /// There is no thread: who executes does.
    Alone,
    Beside {
        full: SyncSender<Vec<UnderWay>>,
        made: Receiver<Made>,
        thread: JoinHandle<()>,
    },
}

/// Records on their way to rows.
pub(super) struct Records {
    axes: Vec<Axis>,
    /// The first `used` count; the others are kept for their memory.
    records: Vec<UnderWay>,
    used: usize,
    /// How many rows the batch under way has.
    rows: usize,
    /// The `seq` of its last row.
    last: Option<u64>,
    way: Way,
}

impl Records {
    /// None so far, of a machine with these axes.
    pub const fn new(axes: Vec<Axis>) -> Self {
        Self { axes, records: Vec::new(), used: 0, rows: 0, last: None, way: Way::NotYet }
    }

    /// The next record, as `fill` makes it. That is given a record to write over, and the `seq` of the row before in
    /// the same batch, and says whether it made only what may differ from that.
    #[inline]
    pub fn push(&mut self, rows: &mut Rows<'_>, fill: impl FnOnce(&mut BlockRecord, Option<u64>) -> bool) {
        if self.records.len() == self.used {
            self.records.push(UnderWay::default());
        }
        if let Some(UnderWay { record, follows }) = self.records.get_mut(self.used) {
            *follows = fill(record, self.last);
            self.rows = (self.rows + 1) % ROWS;
            self.last = (self.rows > 0).then_some(record.seq);
        }
        self.used += 1;
        // Hands the records on when they are many.
        if self.used == RECORDS {
            self.hand_on(rows);
        }
    }

    fn hand_on(&mut self, rows: &mut Rows<'_>) {
        if matches!(self.way, Way::NotYet) {
            self.way = start(&self.axes, rows);
        }
        match &self.way {
            Way::Beside { full, made, .. } => {
                let mut next = Vec::new();
                for made in made.try_iter() {
                    match made {
                        Made::Batch(batch) => rows.take(batch),
                        Made::Used(records) => next = records,
                    }
                }
                // A thread that takes no more has panicked, as the end tells.
                let _ = full.send(std::mem::replace(&mut self.records, next));
            }
            Way::NotYet | Way::Alone => {
                for record in self.records.iter().take(self.used) {
                    record.put(&mut rows.table, &self.axes);
                    rows.row();
                }
            }
        }
        self.used = 0;
    }

    /// Puts the last records into rows.
    pub fn finish(mut self, rows: &mut Rows<'_>) {
        self.records.truncate(self.used);
        if let Way::NotYet = self.way {
            self.way = Way::Alone;
        }
        self.hand_on(rows);
        if let Way::Beside { full, made, thread } = self.way {
            drop(full);
            for made in made {
                if let Made::Batch(batch) = made {
                    rows.take(batch);
                }
            }
            if thread.join().is_err() {
                rows.fail(io::Error::other("the columns are not whole"));
            }
        }
    }
}

fn start(axes: &[Axis], rows: &mut Rows<'_>) -> Way {
    let (full, records) = sync_channel(QUEUE);
    let (give, made) = channel();
    let (table, schema) = rows.columns();
    let axes = axes.to_vec();
    match parallel::apart("columns", move || build(table, &schema, &axes, &records, &give)) {
        Some(thread) => Way::Beside { full, made, thread },
        None => Way::Alone,
    }
}

fn build(mut table: Table, schema: &SchemaRef, axes: &[Axis], records: &Receiver<Vec<UnderWay>>, made: &Sender<Made>) {
    // Who executes may want no more.
    for records in records {
        for record in &records {
            record.put(&mut table, axes);
            if table.end_row() {
                let _ = made.send(Made::Batch(table.batch(schema)));
            }
        }
        let _ = made.send(Made::Used(records));
    }
    if table.has_rows() {
        let _ = made.send(Made::Batch(table.batch(schema)));
    }
}
