//! One file read for itself: what it calls does not matter.

use std::collections::BTreeMap;
use std::hash::{DefaultHasher, Hash, Hasher};
use std::io;
use std::path::{Path, PathBuf};
use std::sync::Arc;

use crate::config::Settings;
use crate::diag::{Code, Findings};
use crate::resolve::Resolved;
use crate::session::{Outcome, Session};
use crate::syntax::ParsedFile;
use crate::text::{Encoding, Loader, SourceText};

/// The findings in a file, and its parts. `path` says whether it is a program or a macrocycle.
pub(super) fn resolve(path: &Path, source: &Arc<SourceText>, settings: &Settings) -> (Outcome, Resolved) {
    let mut settings = settings.clone();
    settings.macrocycles.clear();
    let alone = Alone(source);
    Session { loader: &alone, settings: &settings, progress: None }.resolve(path, source.name())
}

/// The meaning of a file, without places. Two texts with the same blocks are executed alike.
#[derive(Debug)]
pub(super) struct Reading {
    /// How many findings there are of each code.
    findings: BTreeMap<Code, usize>,
    /// A hash of the blocks and comments.
    blocks: u64,
}

impl Reading {
    /// What was read.
    pub(super) fn of(file: &ParsedFile, found: &Findings) -> Self {
        let mut findings = BTreeMap::new();
        found.items().iter().for_each(|item| *findings.entry(item.code()).or_default() += 1);
        found.beyond().for_each(|((_, code), beyond)| *findings.entry(code).or_default() += beyond);
        let mut hash = DefaultHasher::new();
        (file.outside.len(), file.program_end().0).hash(&mut hash);
        file.block_ids().for_each(|block| (file.flags(block).0, file.words(block).len()).hash(&mut hash));
        file.all_words().for_each(|word| word.essence().hash(&mut hash));
        file.all_comments().iter().for_each(|comment| file.comment_text(*comment).hash(&mut hash));
        Self { findings, blocks: hash.finish() }
    }

    /// Whether the same is read in the text that was made of this one, with the same findings but for those that layout
    /// puts right (FMT-7).
    pub(super) fn stays_in(&self, new: &Self) -> bool {
        let count = |reading: &Self, code| reading.findings.get(code).copied().unwrap_or(0);
        let mut codes = self.findings.keys().chain(new.findings.keys());
        self.blocks == new.blocks
            && codes.all(|code| {
                let (before, now) = (count(self, code), count(new, code));
                now == before || (now < before && matches!(code, Code::W0108 | Code::E0109))
            })
    }
}

struct Alone<'a>(&'a Arc<SourceText>);

impl Loader for Alone<'_> {
    fn read(&self, _: &Path) -> io::Result<Vec<u8>> {
        Err(io::ErrorKind::NotFound.into())
    }

    fn load(&self, _: &Path, _: &str, _: Encoding) -> io::Result<Arc<SourceText>> {
        Ok(Arc::clone(self.0))
    }

    fn list(&self, _: &Path) -> Vec<PathBuf> {
        Vec::new()
    }

    fn folders(&self, _: &Path) -> Vec<PathBuf> {
        Vec::new()
    }

    fn canonical(&self, path: &Path) -> PathBuf {
        path.to_path_buf()
    }
}
