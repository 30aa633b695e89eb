//! `lsp`: the language server, for editors.

use std::io::{self, BufReader, BufWriter, IsTerminal};
use std::sync::Arc;

use super::locale::Locale;
use super::status::{Failure, Status, stdout, tell};
use super::words::Words;
use crate::disk::DiskLoader;
use crate::lsp::{Ended, serve};

pub(super) fn run(locale: Locale) -> Result<Status, Failure> {
    if io::stdin().is_terminal() {
        tell(&Words::ServerOfEditors, locale.lang);
    }
    let input = BufReader::with_capacity(1 << 16, io::stdin());
    drop(stdout()?);
    let output = BufWriter::with_capacity(1 << 16, io::stdout());
    Ok(match serve(Arc::new(DiskLoader::default()), locale.lang, input, output)? {
        Ended::Orderly => Status::Fine,
        Ended::Abruptly => Status::Faulty,
    })
}
