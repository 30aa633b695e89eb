//! The record of one block alone, for those who keep what records say in another form.

use super::row::Rows;
use super::writer::Writer;
use crate::dict::AxisLetter;
use crate::run::Executed;

/// Makes the text of block records, whichever are asked for.
#[derive(Debug)]
pub(crate) struct SingleRecord {
    rows: Rows,
    writer: Writer,
    text: Vec<u8>,
}

impl SingleRecord {
    /// For a machine with these axes.
    pub(crate) fn new(axes: &[AxisLetter]) -> Self {
        Self { rows: Rows::default(), writer: Writer::new(axes), text: Vec::new() }
    }

    /// The record as the stream writes it.
    pub(crate) fn of(&mut self, block: &Executed<'_>) -> &[u8] {
        self.text.clear();
        self.writer.write(&mut self.text, self.rows.of(block));
        &self.text
    }
}
