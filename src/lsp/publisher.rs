//! Which findings the client has: those of all open documents together, by file.

use std::collections::{BTreeMap, BTreeSet};
use std::path::{Path, PathBuf};

use gen_lsp_types::{Diagnostic, Uri};

/// The findings of every file, with a revision that grows when they change.
#[derive(Debug, Default)]
pub(super) struct Publisher {
    by_root: BTreeMap<PathBuf, BTreeMap<Uri, Vec<Diagnostic>>>,
    union: BTreeMap<Uri, (u64, Vec<Diagnostic>)>,
    revision: u64,
}

impl Publisher {
    /// Sets what was found from one open document on; the files whose findings changed.
    pub(super) fn set(&mut self, root: &Path, found: BTreeMap<Uri, Vec<Diagnostic>>) -> Vec<Uri> {
        let before = self.by_root.insert(root.to_path_buf(), found);
        self.update(root, before)
    }

    /// Forgets what was found from a document that is closed; the files whose findings changed.
    pub(super) fn remove(&mut self, root: &Path) -> Vec<Uri> {
        let before = self.by_root.remove(root);
        self.update(root, before)
    }

    fn update(&mut self, root: &Path, before: Option<BTreeMap<Uri, Vec<Diagnostic>>>) -> Vec<Uri> {
        let mut touched: BTreeSet<Uri> = before.into_iter().flat_map(BTreeMap::into_keys).collect();
        touched.extend(self.by_root.get(root).into_iter().flat_map(BTreeMap::keys).cloned());
        touched.into_iter().filter(|uri| self.unite(uri)).collect()
    }

    /// Puts the findings of a file together anew; whether they changed. Documents that share a macrocycle find the same
    /// in it.
    fn unite(&mut self, uri: &Uri) -> bool {
        let mut all: Vec<Diagnostic> = Vec::new();
        for found in self.by_root.values().filter_map(|found| found.get(uri)) {
            if all.is_empty() {
                all.clone_from(found);
                continue;
            }
            // Both are sorted by place; of one place there are few.
            for diagnostic in found {
                let at = all.partition_point(|known| known.range < diagnostic.range);
                let same = |known: &&Diagnostic| known.range == diagnostic.range;
                let mut there = all.iter().skip(at).take_while(same);
                if !there.any(|known| known.code == diagnostic.code) {
                    all.insert(at, diagnostic.clone());
                }
            }
        }
        if self.get(uri).1 == all {
            return false;
        }
        self.revision += 1;
        self.union.insert(uri.clone(), (self.revision, all));
        true
    }

    /// The findings of a file, and their revision.
    pub(super) fn get(&self, uri: &Uri) -> (u64, &[Diagnostic]) {
        self.union.get(uri).map_or((0, &[]), |(revision, found)| (*revision, found))
    }
}

#[cfg(test)]
mod tests {
    use gen_lsp_types::{Code, Message, Position, Range};

    use super::*;

    fn diagnostic(line: u32, code: &str) -> Diagnostic {
        let at = Position { line, character: 0 };
        Diagnostic {
            range: Range { start: at, end: at },
            code: Some(Code::String(code.to_owned())),
            message: Message::String(String::new()),
            ..Diagnostic::default()
        }
    }

    #[test]
    fn documents_share_a_macrocycle() {
        let uri = Uri::parse("file:///L1").unwrap();
        let of = |all: &[(u32, &str)]| {
            BTreeMap::from([(uri.clone(), all.iter().map(|(line, code)| diagnostic(*line, code)).collect())])
        };
        let lines = |publisher: &Publisher| -> Vec<u32> {
            publisher.get(&uri).1.iter().map(|diagnostic| diagnostic.range.start.line).collect()
        };
        let mut publisher = Publisher::default();
        assert_eq!(publisher.set(Path::new("a"), of(&[(1, "E0101"), (5, "E0102")])).len(), 1);
        assert_eq!(publisher.set(Path::new("b"), of(&[(1, "E0101"), (3, "E0103"), (5, "E0999")])).len(), 1);
        assert_eq!(lines(&publisher), [1, 3, 5, 5]);
        assert_eq!(publisher.set(Path::new("b"), of(&[(1, "E0101")])).len(), 1);
        assert_eq!(publisher.remove(Path::new("b")), []);
        assert_eq!(lines(&publisher), [1, 5]);
        assert_eq!(publisher.remove(Path::new("a")).len(), 1);
        assert_eq!(lines(&publisher), Vec::<u32>::new());
    }
}
