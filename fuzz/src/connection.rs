//! The bytes between an editor and its server.

use std::io::{self, BufRead, Read, Write};
use std::sync::Arc;
use std::sync::mpsc::{Receiver, Sender, channel};

use cnc872c::dict::Lang;
use cnc872c::lsp::serve;
use serde_json::Value;

use crate::world::Disk;

/// The bytes that an editor sends, as the server reads them.
pub struct Input {
    from: Receiver<Vec<u8>>,
    piece: Vec<u8>,
    at: usize,
}

impl Input {
    /// Reads what is sent in pieces.
    pub const fn new(from: Receiver<Vec<u8>>) -> Self {
        Self { from, piece: Vec::new(), at: 0 }
    }
}

impl Read for Input {
    fn read(&mut self, buffer: &mut [u8]) -> io::Result<usize> {
        let piece = self.fill_buf()?;
        let length = piece.len().min(buffer.len());
        buffer[..length].copy_from_slice(&piece[..length]);
        self.consume(length);
        Ok(length)
    }
}

impl BufRead for Input {
    fn fill_buf(&mut self) -> io::Result<&[u8]> {
        while self.at == self.piece.len() {
            self.at = 0;
            match self.from.recv() {
                Ok(piece) => self.piece = piece,
                Err(_) => {
                    self.piece = Vec::new();
                    break;
                }
            }
        }
        Ok(&self.piece[self.at..])
    }

    fn consume(&mut self, length: usize) {
        self.at += length;
    }
}

/// The bytes that the server sends.
pub struct Output {
    to: Sender<Vec<u8>>,
    piece: Vec<u8>,
}

impl Output {
    /// Sends a piece with every flush.
    pub const fn new(to: Sender<Vec<u8>>) -> Self {
        Self { to, piece: Vec::new() }
    }
}

impl Write for Output {
    fn write(&mut self, bytes: &[u8]) -> io::Result<usize> {
        self.piece.extend_from_slice(bytes);
        Ok(bytes.len())
    }

    fn flush(&mut self) -> io::Result<()> {
        self.to.send(std::mem::take(&mut self.piece)).map_err(|_| io::ErrorKind::BrokenPipe.into())
    }
}

impl Drop for Output {
    fn drop(&mut self) {
        assert!(self.piece.is_empty(), "a message that is not sent");
    }
}

/// Takes one frame off the front of what the server sent.
pub fn take_frame(bytes: &mut Vec<u8>) -> Option<Value> {
    let end = bytes.windows(4).position(|window| window == b"\r\n\r\n")?;
    let header = std::str::from_utf8(&bytes[..end]).expect("a header of text");
    let length = header.strip_prefix("Content-Length: ").expect("the length, and nothing else");
    let length: usize = length.parse().expect("a number");
    let content = bytes.get(end + 4..end + 4 + length)?;
    let message: Value = serde_json::from_slice(content).expect("JSON");
    assert_message(&message);
    bytes.drain(..end + 4 + length);
    Some(message)
}

/// What must hold of everything that the server says.
fn assert_message(message: &Value) {
    assert_eq!(message["jsonrpc"], "2.0", "{message}");
    let (id, method) = (message.get("id"), message.get("method"));
    let (result, error) = (message.get("result"), message.get("error"));
    match method {
        Some(method) => {
            assert!(method.is_string() && result.is_none() && error.is_none(), "{message}");
            let text = message["params"]["message"].as_str().unwrap_or_default();
            assert!(!text.starts_with("analysis:"), "{message}");
        }
        None => {
            assert!(id.is_some() && result.is_some() != error.is_some(), "{message}");
            assert_ne!(message["error"]["code"], -32603, "{message}");
        }
    }
}

/// Gives bytes to a server as they are; what it answers is well-formed, and it ends.
pub fn run_raw(bytes: &[u8]) {
    let (to, output) = channel();
    let input = io::Cursor::new(bytes.to_vec());
    let disk: Arc<Disk> = Arc::new(Disk::new());
    serve(disk, Lang::En, input, Output::new(to)).expect("threads");
    let mut received: Vec<u8> = output.iter().flatten().collect();
    while take_frame(&mut received).is_some() {}
    assert!(received.is_empty(), "a frame that is cut short");
}
