//! `init`: a commented project file, never over an existing one.

use std::fs::{self, OpenOptions};
use std::io::{ErrorKind, Write};
use std::path::{Path, PathBuf};

use super::args::InitArgs;
use super::locale::Locale;
use super::status::{Failure, Status, tell};
use super::words::Words;
use crate::config::{PROJECT_FILE, Surroundings, initial};
use crate::dict::Lang;
use crate::disk::{DiskLoader, entries};
use crate::session::Session;
use crate::text::{Loader, path_name};

pub(super) fn run(args: &InitArgs, locale: Locale) -> Result<Status, Failure> {
    let path = args.folder.as_deref().map_or_else(|| PathBuf::from(PROJECT_FILE), |folder| folder.join(PROJECT_FILE));
    let file = path_name(&path);
    let found = surroundings(args.folder.as_deref().unwrap_or(Path::new("")));
    write(&path, &initial(args.dialect.unwrap_or_default(), &found, locale.lang), locale.lang)?;
    tell(&Words::Written { file }, locale.lang);
    Ok(Status::Fine)
}

/// Levels of folders in which macrocycles are looked for.
const DEPTH: usize = 3;
/// Bytes of an XML file that are looked at.
const HEAD: usize = 1 << 16;

/// The files in the folder that a project file may name.
fn surroundings(folder: &Path) -> Surroundings {
    let mut macrocycles = Vec::new();
    search(folder, "", DEPTH, &mut macrocycles);
    // Those beside the programs are found without being named.
    if macrocycles == ["."] {
        macrocycles.clear();
    }
    let configs = entries(folder).unwrap_or_default().into_iter().filter(|entry| {
        let is_xml = entry.path.extension().is_some_and(|extension| extension.eq_ignore_ascii_case("xml"));
        is_xml && entry.is_file() && DiskLoader::default().head(&entry.path, HEAD).is_ok_and(|head| is_channel(&head))
    });
    let names = configs.filter_map(|entry| Some(entry.path.file_name()?.to_str()?.to_owned()));
    Surroundings { macrocycles, channel_config: names.into_iter().next() }
}

/// Whether it begins as a ChannelConfig.
fn is_channel(head: &[u8]) -> bool {
    let text = String::from_utf8_lossy(head);
    text.contains("<ChannelConfig") || text.contains("<MFunctions")
}

/// Adds the folders that hold macrocycles, `name` and those below.
fn search(folder: &Path, name: &str, depth: usize, found: &mut Vec<String>) {
    let entries = entries(folder).unwrap_or_default();
    if entries.iter().any(|entry| entry.is_file() && Session::is_macrocycle_name(&entry.path)) {
        found.push(if name.is_empty() { "." } else { name }.to_owned());
    }
    for entry in entries.iter().filter(|entry| depth > 0 && entry.is_folder() && !entry.is_link()) {
        let Some(own) = entry.path.file_name().and_then(|own| own.to_str()) else { continue };
        if !own.starts_with('.') {
            let name = if name.is_empty() { own.to_owned() } else { format!("{name}/{own}") };
            search(&entry.path, &name, depth - 1, found);
        }
    }
}

/// Writes a file that is not there yet. A link counts as a file, wherever it leads.
fn write(path: &Path, text: &str, lang: Lang) -> Result<(), Words> {
    let file = path_name(path);
    let opened = OpenOptions::new().write(true).create_new(true).open(path);
    let written = opened.and_then(|mut new| {
        let written = new.write_all(text.as_bytes()).and_then(|()| new.sync_all());
        // A part of a file would prevent the next attempt.
        written.inspect_err(|_| drop(fs::remove_file(path)))
    });
    written.map_err(|error| match (error.kind(), path.parent()) {
        (ErrorKind::AlreadyExists, _) => Words::FileExists { file },
        (ErrorKind::NotFound, Some(folder)) => Words::NoSuchFolder { folder: path_name(folder) },
        _ => Words::cannot_write(path, &error, lang),
    })
}
