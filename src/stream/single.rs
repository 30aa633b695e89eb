//! The record of one block alone, for those who keep what records say in another form.

use super::records::BlockRecord;
use super::row::{Before, Rows};
use super::writer::Writer;
use crate::dict::AxisLetter;
use crate::run::Executed;

/// Makes the text of block records, whichever are asked for.
#[derive(Debug)]
pub(crate) struct SingleRecord {
    rows: Rows,
    row: BlockRecord,
    writer: Writer,
    text: Vec<u8>,
}

impl SingleRecord {
    /// For a machine with these axes.
    pub(crate) fn new(axes: &[AxisLetter]) -> Self {
        Self { rows: Rows::default(), row: BlockRecord::default(), writer: Writer::new(axes), text: Vec::new() }
    }

    /// The record as the stream writes it.
    pub(crate) fn of(&mut self, block: &Executed<'_>) -> &[u8] {
        self.text.clear();
        self.rows.fill(block, &mut self.row, Before::InPlace);
        self.writer.write(&mut self.text, &self.row);
        &self.text
    }
}
