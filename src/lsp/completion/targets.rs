//! What L can name: subprograms, macrocycles, blocks, and the number of a new subprogram.

use std::collections::{BTreeMap, BTreeSet};
use std::path::Path;

use gen_lsp_types::CompletionItemKind;

use super::items::{Entry, Items, Section};
use super::texts::ItemText;
use super::{Context, Source};
use crate::diag::{Findings, shown};
use crate::dict::{Address, GCode, GGroup, HIGHEST_L};
use crate::query::callee::about;
use crate::query::cursor::{DOCUMENT, unit_of};
use crate::query::extents::{comments_above, stands_alone};
use crate::resolve::{Library, Target, Unit, UnitKind};
use crate::syntax::{BlockFlags, BlockId, Form, ParsedFile, parse};
use crate::text::{FileId, Loader, Span};

/// Most macrocycles that are offered at once.
const MACROCYCLES: usize = 1000;
/// Longest macrocycle, in bytes, that is read for its title.
const LONGEST: u64 = 1 << 20;
/// Most blocks that are offered at once, on either side of the cursor.
const BLOCKS: usize = 250;
/// Most blocks that are looked at, on either side.
pub(super) const NEAR: u32 = 10_000;

/// The numbers that begin with the digits typed after L, as the function of the block takes them. Whether there is one
/// that does.
pub(super) fn targets(source: &Source<'_>, context: &Context<'_>, items: &mut Items<'_>) -> bool {
    let mut codes = context.words().filter_map(|word| word.g_code()).filter(|code| code.group() == GGroup::G7);
    let Some(code) = codes.next() else { return false };
    let mut offer = Offer { source, context, items };
    if code == GCode::G71 {
        offer.subprograms();
    } else if code == GCode::G72 {
        offer.macrocycles();
    } else if code == GCode::G73 {
        offer.blocks();
    } else if code == GCode::G79 {
        offer.new_subprogram();
    } else {
        return false;
    }
    true
}

struct Offer<'a, 'c, 'i, 'f> {
    source: &'a Source<'c>,
    context: &'a Context<'c>,
    items: &'i mut Items<'f>,
}

impl Offer<'_, '_, '_, '_> {
    fn add(&mut self, l: u32, kind: CompletionItemKind, detail: String, section: Section, order: u32) {
        self.add_told(l, kind, detail, &[], section, order);
    }

    /// The same with the comments that say what it is.
    fn add_told(
        &mut self,
        l: u32,
        kind: CompletionItemKind,
        detail: String,
        told: &[String],
        section: Section,
        order: u32,
    ) {
        let Some(filter) = filter(self.context, l) else { return };
        let (label, text) = (format!("L{l}"), format!("L{l}"));
        let documentation =
            (told.len() > 1).then(|| told.iter().map(|line| escaped(line)).collect::<Vec<_>>().join("  \n"));
        self.items.add(Entry { label, kind, detail, documentation, section, order, filter, text, snippet: None });
    }

    fn subprograms(&mut self) {
        let Source { analysis, lang, .. } = *self.source;
        let own = self.context.block.and_then(|block| unit_of(analysis, block)).map(|(id, _)| id);
        let mut calls: BTreeMap<u32, usize> = BTreeMap::new();
        for (_, target) in analysis.resolved.targets(DOCUMENT).iter().copied() {
            if let Target::Unit(unit) = target {
                *calls.entry(unit.0).or_default() += 1;
            }
        }
        for (id, unit) in analysis.resolved.units() {
            let UnitKind::Subprogram(Some(l)) = unit.kind else { continue };
            if Some(id) == own {
                continue;
            }
            let called = match calls.get(&id.0) {
                Some(&count) => ItemText::Called { count },
                None => ItemText::NotCalled,
            };
            let told: Vec<String> = about(self.context.file, unit).into_iter().map(shown).collect();
            let title = told.first().map(|title| format!("{title}, ")).unwrap_or_default();
            let detail = format!("{title}{}", called.text(lang));
            self.add_told(l, CompletionItemKind::Function, detail, &told, Section::First, l);
        }
    }

    fn macrocycles(&mut self) {
        let analysis = self.source.analysis;
        let own = Library::number(&analysis.path);
        let session = analysis.session();
        let mut library = session.library(&analysis.path);
        let fitting = library.all().filter(|(l, _)| Some(*l) != own && filter(self.context, *l).is_some());
        let found: Vec<(u32, &Path)> = fitting.take(MACROCYCLES + 1).collect();
        self.items.incomplete |= found.len() > MACROCYCLES;
        for l in self.source.settings.machine.macrocycles.keys().filter(|l| filter(self.context, **l).is_some()) {
            self.add(*l, CompletionItemKind::File, "[machine-macrocycles]".to_owned(), Section::First, *l);
        }
        for (l, path) in found.into_iter().take(MACROCYCLES) {
            if self.items.cancel.is_cancelled() {
                return;
            }
            let name = path.file_name().unwrap_or_default().to_string_lossy();
            let told = self.told(path);
            let title = told.first().map(|title| format!("{title}, ")).unwrap_or_default();
            self.add_told(l, CompletionItemKind::File, format!("{title}{name}"), &told, Section::First, l);
        }
    }

    /// The description of a macrocycle in the comments of its file.
    fn told(&self, path: &Path) -> Vec<String> {
        let files = &self.source.analysis.files;
        if files.size(path).is_none_or(|size| size > LONGEST) {
            return Vec::new();
        }
        let name = path.to_string_lossy();
        let Ok(text) = files.load(path, &name, self.source.settings.encoding) else { return Vec::new() };
        let parsed = parse(FileId(0), &text, Form::Macrocycle, &mut Findings::new());
        let (first, end) = (BlockId(0), BlockId(parsed.block_count()));
        let unit = Unit { kind: UnitKind::Macrocycle(0), file: FileId(0), first, end, entry: parsed.n_place(first) };
        about(&parsed, &unit).into_iter().map(shown).collect()
    }

    fn blocks(&mut self) {
        let analysis = self.source.analysis;
        let (file, context) = (self.context.file, self.context);
        let Some(here) = context.block else { return };
        let (first, end) =
            unit_of(analysis, here).map_or((0, file.block_count()), |(_, unit)| (unit.first.0, unit.end.0));
        let is_fitting = |block: &BlockId| {
            file.number(*block).is_some_and(|number| number <= HIGHEST_L && filter(context, number).is_some())
        };
        let nearest = first.max(here.0.saturating_sub(NEAR));
        let farthest = end.min(here.0.saturating_add(NEAR));
        // A jump to its own block is hardly ever meant.
        let mut before = (nearest..here.0).rev().map(BlockId).filter(is_fitting);
        let mut behind = (here.next().0..farthest).map(BlockId).filter(is_fitting);
        let found: Vec<(Section, BlockId)> = before
            .by_ref()
            .take(BLOCKS)
            .map(|block| (Section::First, block))
            .chain(behind.by_ref().take(BLOCKS).map(|block| (Section::Second, block)))
            .collect();
        self.items.incomplete |=
            nearest > first || farthest < end || before.next().is_some() || behind.next().is_some();
        for (section, block) in found {
            let Some(number) = file.number(block) else { continue };
            let detail = title(file, block).unwrap_or_else(|| content(file, block));
            self.add(number, CompletionItemKind::Reference, detail, section, block.0.abs_diff(here.0));
        }
    }

    fn new_subprogram(&mut self) {
        let Source { analysis, lang, .. } = *self.source;
        if let Some(own) = Library::number(&analysis.path) {
            self.add(own, CompletionItemKind::Value, ItemText::OwnNumber.text(lang), Section::First, 0);
            return;
        }
        let missing = missing_subprograms(self.source, self.context.file);
        for &l in &missing {
            self.add(l, CompletionItemKind::Value, ItemText::Missing.text(lang), Section::First, l);
        }
        if let Some(next) = next_subprogram(self.source) {
            self.add(next, CompletionItemKind::Value, ItemText::NextSubprogram.text(lang), Section::Second, 0);
        }
    }
}

/// The text that the client compares with what is typed; `None` when that is another number.
fn filter(context: &Context<'_>, number: u32) -> Option<String> {
    if !matches!(context.wanted, super::context::Wanted::Address(Address::L)) {
        return Some(format!("L{number}"));
    }
    let typed = context.digits()?;
    let digits = typed.trim_start_matches('0');
    let zeros = typed.get(..typed.len() - digits.len())?;
    let number = number.to_string();
    number.starts_with(digits).then(|| format!("{}{zeros}{number}", context.head()))
}

/// The comment that describes a block: the one on its line, else the one directly above.
fn title(file: &ParsedFile, block: BlockId) -> Option<String> {
    let text = file.source.text();
    let beside = file.comments_behind(block).iter().find(|comment| !stands_alone(text, **comment));
    let comment = beside.or_else(|| comments_above(file, block).last())?;
    Some(file.comment_text(*comment)).filter(|text| !text.is_empty()).map(shown)
}

/// A comment in which nothing is Markdown.
fn escaped(line: &str) -> String {
    let mut page = String::new();
    for character in line.chars() {
        if matches!(character, '\\' | '`' | '*' | '_' | '[' | ']' | '<' | '>' | '#' | '|' | '~' | '&' | '$') {
            page.push('\\');
        }
        page.push(character);
    }
    page
}

/// The description of a block without a comment: its words.
fn content(file: &ParsedFile, block: BlockId) -> String {
    let text = file.source.text();
    let spans = file.words(block).iter().map(|word| word.span(text)).take(16);
    let words: Vec<&str> = spans.map(|span: Span| file.source.slice(span)).collect();
    shown(&words.join(" "))
}

/// The subprograms that are called and are not there.
pub(super) fn missing_subprograms(source: &Source<'_>, file: &ParsedFile) -> BTreeSet<u32> {
    let resolved = &source.analysis.resolved;
    let mut missing = BTreeSet::new();
    let last = file.block_count();
    // Of a long program the begin and the end: what lies between calls the same, as a rule.
    let looked_at = (0..last.min(NEAR)).chain(last.saturating_sub(NEAR).max(NEAR)..last).map(BlockId);
    for block in looked_at.filter(|block| file.flags(*block).has(BlockFlags::RICH)) {
        let words = file.words(block);
        if words.iter().any(|word| word.g_code() == Some(GCode::G71)) {
            let l = words.iter().find(|word| word.address == Address::L).and_then(|word| word.whole());
            let l = l.and_then(|l| u32::try_from(l).ok()).filter(|l| (1..=HIGHEST_L).contains(l));
            missing.extend(l.filter(|l| resolved.subprogram(*l).is_none()));
        }
    }
    missing
}

/// A number for one more subprogram: on from the highest, in steps as round as that is.
pub(super) fn next_subprogram(source: &Source<'_>) -> Option<u32> {
    let resolved = &source.analysis.resolved;
    let numbers = resolved.units().filter_map(|(_, unit)| match unit.kind {
        UnitKind::Subprogram(l) => l,
        UnitKind::Main | UnitKind::Macrocycle(_) => None,
    });
    let Some(highest) = numbers.max() else { return Some(1) };
    let step = [100, 10, 1].into_iter().find(|step| highest.is_multiple_of(*step)).unwrap_or(1);
    let next = Some(highest + step).filter(|next| *next <= HIGHEST_L);
    next.or_else(|| (1..=HIGHEST_L).find(|l| resolved.subprogram(*l).is_none()))
}
