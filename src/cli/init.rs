//! `init`: a commented project file, never over an existing one.

use std::collections::HashSet;
use std::fs::{self, OpenOptions};
use std::io::{ErrorKind, Write};
use std::path::{Path, PathBuf};
use std::sync::Arc;

use super::args::InitArgs;
use super::locale::Locale;
use super::status::{Failure, Status, tell};
use super::walk::has_extension;
use super::words::Words;
use crate::config::{EXTENSIONS, Overrides, PROJECT_FILE, Surroundings, configure, find_project, initial};
use crate::diag::Findings;
use crate::dict::Lang;
use crate::disk::{self, DiskLoader, entries};
use crate::resolve::{Library, begins_macrocycle};
use crate::text::{Encoding, Loader, SourceText, Sources, path_name};

pub(super) fn run(args: &InitArgs, locale: Locale) -> Result<Status, Failure> {
    let path = args.folder.as_deref().map_or_else(|| PathBuf::from(PROJECT_FILE), |folder| folder.join(PROJECT_FILE));
    let file = path_name(&path);
    let folder = args.folder.as_deref().unwrap_or(Path::new(""));
    let found = surroundings(folder);
    let above = find_project(folder, &DiskLoader::default());
    write(&path, &initial(args.dialect.unwrap_or_default(), &found, locale.lang), locale.lang)?;
    tell(&Words::Written { file }, locale.lang);
    if let Some(above) = above {
        tell(&Words::ProjectAbove { above: path_name(&above) }, locale.lang);
    }
    Ok(Status::Fine)
}

/// Levels of folders in which macrocycles are looked for.
const DEPTH: usize = 3;
/// Bytes of an XML file that are looked at.
const HEAD: usize = 1 << 16;

/// The files in the folder that a project file may name.
fn surroundings(folder: &Path) -> Surroundings {
    let mut found = Folders::default();
    found.search(folder, "", DEPTH);
    let is_ambiguous = found.is_ambiguous();
    let mut macrocycles = found.macrocycles;
    // Those beside the programs are found without being named.
    if macrocycles == ["."] {
        macrocycles.clear();
    }
    let configs = entries(folder).unwrap_or_default().into_iter().filter(|entry| {
        let is_xml = entry.path.extension().is_some_and(|extension| extension.eq_ignore_ascii_case("xml"));
        is_xml && entry.is_file() && head(&entry.path).is_some_and(|head| is_channel(&head))
    });
    let configs: Vec<PathBuf> = configs.map(|entry| entry.path).collect();
    let name = |path: &PathBuf| Some(path.file_name()?.to_str()?.to_owned());
    let channel_is_doubtful = configs.len() > 1 || configs.iter().any(|path| has_errors(path));
    let channel_config = configs.first().and_then(name);
    Surroundings { macrocycles, is_ambiguous, channel_config, channel_is_doubtful }
}

/// Whether a ChannelConfig would keep programs from being read.
fn has_errors(channel: &Path) -> bool {
    let overrides = Overrides { channel_config: Some(channel.to_path_buf()), ..Overrides::default() };
    let mut findings = Findings::new();
    configure(None, &overrides, &DiskLoader::default(), &mut Sources::default(), &mut findings);
    findings.has_errors()
}

/// The first bytes of a file.
fn head(path: &Path) -> Option<Vec<u8>> {
    DiskLoader::default().head(path, HEAD).ok()
}

/// Whether it begins as a ChannelConfig.
fn is_channel(head: &[u8]) -> bool {
    let text = String::from_utf8_lossy(head);
    text.contains("<ChannelConfig") || text.contains("<MFunctions")
}

/// Folders by what they hold.
#[derive(Default)]
struct Folders {
    /// Those with macrocycles, relative.
    macrocycles: Vec<String>,
    /// Those with programs, relative.
    programs: Vec<String>,
    /// The numbers that names of files in `macrocycles` say.
    numbers: Vec<u32>,
}

impl Folders {
    /// Looks at a folder, whose name is `name`, and at those below.
    fn search(&mut self, folder: &Path, name: &str, depth: usize) {
        let entries = entries(folder).unwrap_or_default();
        let files = || entries.iter().filter(|entry| entry.is_file()).map(|entry| entry.path.as_path());
        let relative = if name.is_empty() { "." } else { name };
        if files().any(is_macrocycle) {
            self.macrocycles.push(relative.to_owned());
            self.numbers.extend(files().filter_map(Library::number));
        }
        if files().any(is_program) {
            self.programs.push(relative.to_owned());
        }
        for entry in entries.iter().filter(|entry| depth > 0 && entry.is_folder() && !entry.is_link()) {
            let Some(own) = entry.path.file_name().and_then(|own| own.to_str()) else { continue };
            if !own.starts_with('.') {
                let name = if name.is_empty() { own.to_owned() } else { format!("{name}/{own}") };
                self.search(&entry.path, &name, depth - 1);
            }
        }
    }

    /// Whether programs would find another macrocycle than the one meant for them, if all folders were searched: a
    /// number is there twice, or macrocycles are beside some programs or below them, and other programs elsewhere.
    fn is_ambiguous(&self) -> bool {
        let is_shared = self.programs.iter().any(|folder| self.macrocycles.contains(folder));
        let is_in = |folder: &str, job: &str| job == "." || Path::new(folder).starts_with(job);
        let is_elsewhere = |job: &str| self.programs.iter().any(|other| !is_in(other, job));
        let of_a_job = |folder: &String| self.programs.iter().any(|job| is_in(folder, job) && is_elsewhere(job));
        let numbers: HashSet<_> = self.numbers.iter().collect();
        numbers.len() < self.numbers.len()
            || (is_shared && self.programs.len() > 1)
            || self.macrocycles.iter().any(of_a_job)
    }
}

/// Whether the file is a macrocycle, by its name and its first block.
fn is_macrocycle(path: &Path) -> bool {
    let source = || SourceText::decode("", head(path)?, Encoding::default()).ok();
    Library::number(path).is_some() && source().is_some_and(|source| begins_macrocycle(&Arc::new(source)))
}

/// Whether the file is a program, by its name and its text.
fn is_program(path: &Path) -> bool {
    let is_named = has_extension(path, EXTENSIONS) || Library::number(path).is_some();
    is_named && !is_macrocycle(path) && disk::is_program(path).unwrap_or(false)
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
