//! Record batches as an Arrow IPC stream.

use std::io::{self, Write};

use arrow_array::RecordBatch;
use arrow_ipc::convert::metadata_to_fb;
use arrow_ipc::writer::{
    DictionaryTracker, EncodedData, IpcDataGenerator, IpcWriteContext, IpcWriteOptions, StreamWriter, write_message,
};
use arrow_ipc::{MessageArgs, MessageHeader, RecordBatchArgs, root_as_message};
use arrow_schema::{ArrowError, Schema, SchemaRef};
use flatbuffers::FlatBufferBuilder;

use super::batches::io_error;
use super::{Batches, End};

/// Writes an Arrow IPC stream.
pub struct Ipc<W: Write> {
    state: State<W>,
}

enum State<W: Write> {
    New(W),
    Open { writer: Box<StreamWriter<W>>, schema: SchemaRef, begun: bool },
    Done,
}

impl<W: Write> std::fmt::Debug for Ipc<W> {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        f.debug_struct("Ipc").finish_non_exhaustive()
    }
}

impl<W: Write> Ipc<W> {
    /// Writes to `out`, a buffer at a time.
    pub const fn new(out: W) -> Self {
        Self { state: State::New(out) }
    }
}

impl<W: Write> Batches for Ipc<W> {
    fn begin(&mut self, schema: &SchemaRef) -> io::Result<()> {
        if let State::New(out) = std::mem::replace(&mut self.state, State::Done) {
            let writer = Box::new(StreamWriter::try_new(out, schema).map_err(io_error)?);
            self.state = State::Open { writer, schema: SchemaRef::clone(schema), begun: false };
        }
        Ok(())
    }

    fn batch(&mut self, batch: RecordBatch) -> io::Result<()> {
        let State::Open { writer, begun, .. } = &mut self.state else { return Ok(()) };
        *begun = true;
        writer.write(&batch).map_err(io_error)
    }

    fn end(&mut self, end: &End) -> io::Result<()> {
        let State::Open { writer, schema, begun } = &mut self.state else { return Ok(()) };
        if !*begun {
            // Dictionaries come before the first batch, whatever is in it.
            writer.write(&RecordBatch::new_empty(SchemaRef::clone(schema))).map_err(io_error)?;
        }
        let options = IpcWriteOptions::default();
        let last = last_batch(schema, end, &options).map_err(io_error)?;
        write_message(writer.get_mut(), last, &options).map_err(io_error)?;
        writer.finish().map_err(io_error)
    }
}

/// A batch without rows that carries metadata: the writer of batches has no place for them.
fn last_batch(schema: &Schema, end: &End, options: &IpcWriteOptions) -> Result<EncodedData, ArrowError> {
    let generator = IpcDataGenerator::default();
    let mut tracker = DictionaryTracker::new(false);
    generator.schema_to_bytes_with_dictionary_tracker(schema, &mut tracker, options);
    let empty = RecordBatch::new_empty(schema.clone().into());
    let (_, encoded) = generator.encode(&empty, &mut tracker, options, &mut IpcWriteContext::default())?;
    let unreadable = || ArrowError::IpcError("the last batch cannot be made".to_owned());
    let message = root_as_message(&encoded.ipc_message).map_err(|_| unreadable())?;
    let batch = message.header_as_record_batch().ok_or_else(unreadable)?;
    let mut builder = FlatBufferBuilder::new();
    let nodes: Vec<_> = batch.nodes().into_iter().flatten().copied().collect();
    let buffers: Vec<_> = batch.buffers().into_iter().flatten().copied().collect();
    let args = RecordBatchArgs {
        length: 0,
        nodes: Some(builder.create_vector(&nodes)),
        buffers: Some(builder.create_vector(&buffers)),
        ..RecordBatchArgs::default()
    };
    let header = arrow_ipc::RecordBatch::create(&mut builder, &args);
    let metadata = metadata_to_fb(&mut builder, &end.0);
    let args = MessageArgs {
        version: message.version(),
        header_type: MessageHeader::RecordBatch,
        header: Some(header.as_union_value()),
        bodyLength: message.bodyLength(),
        custom_metadata: Some(metadata),
    };
    let message = arrow_ipc::Message::create(&mut builder, &args);
    builder.finish(message, None);
    Ok(EncodedData { ipc_message: builder.finished_data().to_vec(), arrow_data: encoded.arrow_data })
}
