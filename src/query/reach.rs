//! Everything that a document leads to: its own file, and the macrocycles that it calls, also those of the cycle map.

use std::borrow::Cow;
use std::path::{Path, PathBuf};

use super::analysis::Analysis;
use super::cancel::Cancel;
use super::cursor::{DOCUMENT, word_at};
use super::names::{Name, Names, Naming};
use crate::diag::Findings;
use crate::dict::GGroup;
use crate::resolve::{Resolved, Unit, UnitId, UnitKind};
use crate::syntax::{BlockFlags, BlockId, ParsedFile};
use crate::text::{FileId, Sources, Span};

/// Blocks between two looks at whether the answer is still wanted.
const STRIDE: u32 = 1 << 12;

/// An analysis with all files that are known without executing the program.
#[derive(Debug)]
pub(crate) struct Reach<'a> {
    pub(crate) analysis: &'a Analysis,
    resolved: Cow<'a, Resolved>,
    sources: Cow<'a, Sources>,
    /// A macrocycle of the cycle map cannot be loaded.
    pub(crate) misses: bool,
}

impl<'a> Reach<'a> {
    pub(crate) fn of(analysis: &'a Analysis) -> Self {
        let mut reach = Self {
            analysis,
            resolved: Cow::Borrowed(&analysis.resolved),
            sources: Cow::Borrowed(&analysis.sources),
            misses: false,
        };
        if !analysis.settings.machine.cycles.is_empty() {
            reach.follow_cycles();
        }
        reach
    }

    /// Loads what the cycle map calls: execution alone knows when, but not what.
    fn follow_cycles(&mut self) {
        let machine = &self.analysis.settings.machine;
        let power_up = machine.power_up.get(GGroup::G8.index()).copied().flatten();
        let mut wanted: Vec<u32> =
            power_up.and_then(|code| machine.cycles.get(&code.number())).copied().into_iter().collect();
        let mut looked_at = 0;
        loop {
            while let Some(names) = self.names(FileId(looked_at)) {
                looked_at += 1;
                for block in names.file.block_ids().filter(|block| names.file.flags(*block).has(BlockFlags::RICH)) {
                    for l in names.file.words(block).iter().filter_map(|word| names.mapped(*word)) {
                        if !wanted.contains(&l) {
                            wanted.push(l);
                        }
                    }
                }
            }
            let known = self.files().count();
            for l in wanted.clone() {
                self.misses |= self.macrocycle(l).is_none();
            }
            if self.files().count() == known {
                return;
            }
        }
    }

    pub(crate) fn resolved(&self) -> &Resolved {
        &self.resolved
    }

    /// The unit of a macrocycle, loaded when it was not yet.
    pub(crate) fn macrocycle(&mut self, l: u32) -> Option<UnitId> {
        let known = self.resolved.units().find(|(_, unit)| unit.kind == UnitKind::Macrocycle(l)).map(|(id, _)| id);
        if known.is_some() {
            return known;
        }
        let session = self.analysis.session();
        let mut library = session.library(&self.analysis.path);
        let (resolved, sources) = (self.resolved.to_mut(), self.sources.to_mut());
        resolved.load_macrocycle(l, &self.analysis.settings, &mut library, sources, &mut Findings::new()).ok()
    }

    /// The files, the document first.
    pub(crate) fn files(&self) -> impl Iterator<Item = FileId> + '_ {
        (0..).map(FileId).take_while(|file| self.resolved.file(*file).is_some())
    }

    /// The names in a file.
    pub(crate) fn names(&self, file: FileId) -> Option<Names<'_>> {
        let parsed = self.resolved.file(file)?;
        let macrocycle = self.resolved.units().find_map(|(_, unit)| match unit.kind {
            UnitKind::Macrocycle(l) if unit.file == file => Some(l),
            UnitKind::Macrocycle(_) | UnitKind::Main | UnitKind::Subprogram(_) => None,
        });
        Some(Names { machine: &self.analysis.settings.machine, file: parsed, macrocycle })
    }

    /// The canonical path of a file.
    pub(crate) fn path(&self, file: FileId) -> Option<PathBuf> {
        if file == DOCUMENT {
            return Some(self.analysis.path.clone());
        }
        let parsed = self.resolved.file(file)?;
        Some(self.analysis.loader.canonical(Path::new(parsed.source.name())))
    }

    /// The file at that canonical path.
    pub(crate) fn file_at(&self, path: &Path) -> Option<FileId> {
        self.files().find(|file| self.path(*file).as_deref() == Some(path))
    }

    /// The names in the word of the document at `offset`.
    pub(crate) fn naming_at(&self, offset: u32) -> Option<Naming> {
        let names = self.names(DOCUMENT)?;
        let at = word_at(names.file, offset)?;
        let touches = |span: Span| span.start <= offset && offset <= span.end && at.span.start <= span.start;
        let mut best: Option<(Span, Naming)> = None;
        for naming in names.of_block(at.block?, |_| true) {
            let place = [Some(naming.around), naming.function].into_iter().flatten().find(|place| touches(*place));
            // Of the parts of a word, as of two words, the one that begins at a border is meant.
            if let Some(place) = place.filter(|place| best.is_none_or(|(known, _)| known.start < place.start)) {
                best = Some((place, naming));
            }
        }
        best.map(|(_, naming)| naming)
    }

    /// Every place in a file that names `name`, in the order of the text. Those found until nobody wants them any more.
    pub(crate) fn occurrences(&self, file: FileId, name: Name, cancel: &Cancel) -> Vec<Naming> {
        let Some(names) = self.names(file) else { return Vec::new() };
        let mut found = Vec::new();
        for block in names.file.block_ids() {
            if block.0.is_multiple_of(STRIDE) && cancel.is_cancelled() {
                break;
            }
            found.extend(names.of_block(block, |known| known == name));
        }
        found.sort_by_key(|naming| naming.number.start);
        found
    }

    /// The unit of a block.
    pub(crate) fn unit_of(&self, file: FileId, block: BlockId) -> Option<(UnitId, &Unit)> {
        self.resolved.units().find(|(_, unit)| unit.file == file && unit.contains(block))
    }

    /// All of a unit, and the number that names it, else its first word.
    pub(crate) fn unit_place(&self, unit: &Unit) -> Option<(Span, Span)> {
        let names = self.names(unit.file)?;
        let file = names.file;
        let begin = if unit.kind == UnitKind::Main { file.program } else { file.n_word(unit.first) };
        let begin = begin.map_or(Span::empty(file.start), |word| word.span(file.source.text()));
        let last = unit.end.0.checked_sub(1).filter(|last| unit.contains(BlockId(*last)));
        let all = last.map_or(begin, |last| begin.to(block_span(file, BlockId(last))));
        let own = match unit.kind {
            UnitKind::Main => None,
            UnitKind::Subprogram(l) => l.map(Name::Subprogram),
            UnitKind::Macrocycle(l) => Some(Name::Macrocycle(l)),
        };
        let definition = own.and_then(|own| names.of_block(unit.first, |name| name == own).first().copied());
        Some((all, definition.map_or(begin, |naming| naming.number)))
    }
}

/// From the `N` of a block to the end of its last word.
pub(crate) fn block_span(file: &ParsedFile, block: BlockId) -> Span {
    let text = file.source.text();
    let Some(begin) = file.n_word(block).map(|word| word.span(text)) else { return Span::empty(file.start) };
    file.words(block).last().map_or(begin, |word| begin.to(word.span(text)))
}
