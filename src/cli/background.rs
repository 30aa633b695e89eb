//! Writing beside computing: what is written goes to another thread, which hands it to the system.

use std::io::{self, Write};
use std::sync::mpsc::{Receiver, SyncSender, TrySendError, channel, sync_channel};
use std::thread::{Builder, JoinHandle};

/// Pieces under way at most: a slow disk makes the program wait, not grow.
const QUEUE: usize = 4;

/// A writer in a thread of its own. An error of the inner writer comes back from the next write, or from
/// [`Background::finish`].
pub(super) struct Background<W> {
    pieces: Option<SyncSender<Vec<u8>>>,
    used: Receiver<Vec<u8>>,
    thread: Option<JoinHandle<io::Result<W>>>,
}

impl<W: Write + Send + 'static> Background<W> {
    /// Starts the thread.
    ///
    /// # Errors
    /// When the system gives no thread.
    pub(super) fn start(mut inner: W) -> io::Result<Self> {
        let (pieces, todo) = sync_channel::<Vec<u8>>(QUEUE);
        let (done, used) = channel();
        let thread = Builder::new().name("writer".to_owned()).spawn(move || {
            for piece in todo {
                inner.write_all(&piece)?;
                // The buffer is used again when somebody still wants one.
                let _ = done.send(piece);
            }
            inner.flush()?;
            Ok(inner)
        })?;
        Ok(Self { pieces: Some(pieces), used, thread: Some(thread) })
    }

    /// Waits until all is written, and gives the inner writer back.
    ///
    /// # Errors
    /// What the inner writer said.
    pub(super) fn finish(mut self) -> io::Result<W> {
        self.join()
    }

    fn join(&mut self) -> io::Result<W> {
        drop(self.pieces.take());
        let stopped = || io::Error::other("the writer has stopped");
        self.thread.take().ok_or_else(stopped)?.join().map_err(|_| stopped())?
    }
}

impl<W: Write + Send + 'static> Write for Background<W> {
    /// Hands on all of `bytes` as one piece.
    fn write(&mut self, bytes: &[u8]) -> io::Result<usize> {
        let mut piece = self.used.try_recv().unwrap_or_default();
        piece.clear();
        piece.extend_from_slice(bytes);
        let sent = self.pieces.as_ref().is_some_and(|pieces| match pieces.try_send(piece) {
            Ok(()) => true,
            Err(TrySendError::Full(piece)) => pieces.send(piece).is_ok(),
            Err(TrySendError::Disconnected(_)) => false,
        });
        if sent {
            return Ok(bytes.len());
        }
        match self.join() {
            Ok(_) => Err(io::Error::from(io::ErrorKind::BrokenPipe)),
            Err(error) => Err(error),
        }
    }

    /// Pieces are under way already; [`Background::finish`] waits for them.
    fn flush(&mut self) -> io::Result<()> {
        Ok(())
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn everything_arrives_in_order() {
        let mut writer = Background::start(Vec::new()).unwrap();
        for number in 0..1000 {
            writer.write_all(format!("{number}\n").as_bytes()).unwrap();
        }
        let expected: String = (0..1000).map(|number| format!("{number}\n")).collect();
        assert_eq!(writer.finish().unwrap(), expected.into_bytes());
    }

    struct Full;

    impl Write for Full {
        fn write(&mut self, _: &[u8]) -> io::Result<usize> {
            Err(io::Error::from(io::ErrorKind::StorageFull))
        }

        fn flush(&mut self) -> io::Result<()> {
            Ok(())
        }
    }

    #[test]
    fn an_error_comes_back() {
        let mut writer = Background::start(Full).unwrap();
        let error = (0..1000).find_map(|_| writer.write_all(b"x").err());
        assert_eq!(error.unwrap().kind(), io::ErrorKind::StorageFull);
        let mut writer = Background::start(Full).unwrap();
        writer.write_all(b"x").unwrap();
        assert!(writer.finish().is_err());
    }
}
