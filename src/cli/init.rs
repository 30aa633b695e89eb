//! `init`: a commented project file, never over an existing one.

use std::fs::{self, OpenOptions};
use std::io::{ErrorKind, Write};
use std::path::{Path, PathBuf};

use super::args::InitArgs;
use super::locale::Locale;
use super::status::{Failure, Status, tell};
use super::words::Words;
use crate::config::{PROJECT_FILE, initial};
use crate::dict::Lang;
use crate::text::path_name;

pub(super) fn run(args: &InitArgs, locale: Locale) -> Result<Status, Failure> {
    let path = args.folder.as_deref().map_or_else(|| PathBuf::from(PROJECT_FILE), |folder| folder.join(PROJECT_FILE));
    let file = path_name(&path);
    write(&path, &initial(args.dialect.unwrap_or_default(), locale.lang), locale.lang)?;
    tell(&Words::Written { file }, locale.lang);
    Ok(Status::Fine)
}

/// Writes a file that is not there yet. A link counts as a file, wherever it leads.
fn write(path: &Path, text: &str, lang: Lang) -> Result<(), Words> {
    let file = path_name(path);
    let opened = OpenOptions::new().write(true).create_new(true).open(path);
    let written = opened.and_then(|mut new| {
        let written = new.write_all(text.as_bytes()).and_then(|()| new.sync_all());
        // A part of a file would stand in the way of the next attempt.
        written.inspect_err(|_| drop(fs::remove_file(path)))
    });
    written.map_err(|error| match (error.kind(), path.parent()) {
        (ErrorKind::AlreadyExists, _) => Words::FileExists { file },
        (ErrorKind::NotFound, Some(folder)) => Words::NoSuchFolder { folder: path_name(folder) },
        _ => Words::cannot_write(path, &error, lang),
    })
}
