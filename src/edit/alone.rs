//! One file read for itself: what it calls does not matter.

use std::collections::BTreeMap;
use std::io;
use std::path::{Path, PathBuf};
use std::sync::Arc;

use crate::config::Settings;
use crate::diag::Code;
use crate::resolve::Resolved;
use crate::session::{Outcome, Session};
use crate::text::{Encoding, Loader, SourceText};

/// The findings in a file, and its parts. `path` says whether it is a program or a macrocycle.
pub(super) fn resolve(path: &Path, source: &Arc<SourceText>, settings: &Settings) -> (Outcome, Resolved) {
    let mut settings = settings.clone();
    settings.macrocycles.clear();
    let alone = Alone(source);
    Session { loader: &alone, settings: &settings, progress: None }.resolve(path, source.name())
}

/// Most blocks that are executed to compare two texts.
const BLOCKS: u64 = 200_000;

/// Whether a rewritten file has the findings of the old one, but for places and those that layout puts right (FMT-7).
pub(super) fn same_findings(path: &Path, old: &Arc<SourceText>, new: &Arc<SourceText>, settings: &Settings) -> bool {
    let [old, new] = [old, new].map(|source| count_findings(path, source, settings));
    let count = |counts: &BTreeMap<Code, usize>, code| counts.get(code).copied().unwrap_or(0);
    old.keys().chain(new.keys()).all(|code| {
        let (before, now) = (count(&old, code), count(&new, code));
        now == before || (now < before && matches!(code, Code::W0108 | Code::E0109))
    })
}

fn count_findings(path: &Path, source: &Arc<SourceText>, settings: &Settings) -> BTreeMap<Code, usize> {
    let mut settings = settings.clone();
    settings.macrocycles.clear();
    let progress = |executed| executed < BLOCKS;
    let session = Session { loader: &Alone(source), settings: &settings, progress: Some(&progress) };
    let findings = session.check(path, source.name()).findings;
    let mut counts = BTreeMap::new();
    findings.items().iter().for_each(|item| *counts.entry(item.code()).or_default() += 1);
    findings.beyond().for_each(|((_, code), beyond)| *counts.entry(code).or_default() += beyond);
    counts
}

/// Whether a finding says that characters could not be read as words (FMT-6, REN-5).
pub(super) const fn is_malformed(code: Code) -> bool {
    matches!(
        code,
        Code::E0101 | Code::E0102 | Code::E0103 | Code::E0104 | Code::E0105 | Code::E0106 | Code::E0107 | Code::E0111
    )
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
