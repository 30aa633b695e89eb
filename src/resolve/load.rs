//! From the text of a program or macrocycle to its units with checked blocks and known targets.

use std::sync::Arc;

use super::foreign::Origin;
use super::open_ends::OpenEnds;
use super::{Library, MacrocycleFault, Resolved, UnitId, flow, rings};
use crate::config::Settings;
use crate::diag::{Diagnostic, Finding, Findings};
use crate::syntax::{Form, parse};
use crate::text::{Location, SourceText, Sources, path_name};

/// What resolving works with.
pub(super) struct Context<'a, 'l> {
    pub(super) settings: &'a Settings,
    pub(super) library: &'a mut Library<'l>,
    pub(super) sources: &'a mut Sources,
    pub(super) findings: &'a mut Findings,
    /// Findings that wait until all calls have been followed.
    pub(super) open: OpenEnds,
}

/// Resolves the program in `source`, or the macrocycle whose file is named after that number, and the macrocycles that
/// its written calls lead to.
pub fn resolve(
    source: &Arc<SourceText>,
    macrocycle: Option<u32>,
    settings: &Settings,
    library: &mut Library<'_>,
    sources: &mut Sources,
    findings: &mut Findings,
) -> Resolved {
    let file = sources.add(Arc::clone(source));
    let mut found = Findings::with_levels(*findings.levels());
    let form = if macrocycle.is_some() { Form::Macrocycle } else { Form::Program };
    let mut parsed = parse(file, source, form, &mut found);
    let case = parsed.take_case();
    let origin = Origin::of(&parsed);
    let mut resolved = Resolved::default();
    let mut context = Context { settings, library, sources, findings: &mut found, open: OpenEnds::default() };
    if let Some(l) = macrocycle {
        context.add_macrocycle(&mut resolved, parsed, l);
        flow::follow_calls(&mut context, &mut resolved);
        rings::check(&mut context, &resolved);
    } else if parsed.program.is_some() {
        context.add_program(&mut resolved, parsed);
        flow::follow_calls(&mut context, &mut resolved);
        flow::check_unused(&mut context, &resolved);
        rings::check(&mut context, &resolved);
    } else {
        parsed.take_findings_at_star().into_iter().for_each(|found| context.findings.add(found));
    }
    resolved.written_files = resolved.files.len();
    add_case(case, &mut found);
    origin.give(settings, found, findings);
    resolved
}

/// Gives the finding of addresses in lower case; of a single one none when its word has another finding, because the
/// word is to be looked at anyway (LEX-11).
fn add_case(case: Option<Diagnostic>, findings: &mut Findings) {
    let Some(case) = case else { return };
    let at_word = |at: Location| {
        // Its letter, or its number.
        let behind = at.span.start.checked_sub(case.at.span.start);
        at.file == case.at.file && matches!(behind, Some(0 | 1))
    };
    // A conflict is a finding of both its words.
    let of_word = |found: &Diagnostic| at_word(found.at) || found.labels.iter().any(|label| at_word(label.at));
    let single = matches!(case.finding, Finding::LowercaseAddress { count: 1 });
    if !(single && findings.items().iter().any(of_word)) {
        findings.add(case);
    }
}

impl Resolved {
    /// The unit of macrocycle `l`, loaded and resolved when it was not before: for calls whose number comes from a
    /// parameter or the cycle map.
    ///
    /// # Errors
    /// Why there is no such macrocycle.
    pub fn load_macrocycle(
        &mut self,
        l: u32,
        settings: &Settings,
        library: &mut Library<'_>,
        sources: &mut Sources,
        findings: &mut Findings,
    ) -> Result<UnitId, MacrocycleFault> {
        let mut context = Context { settings, library, sources, findings, open: OpenEnds::default() };
        let known = self.units.len();
        let unit = context.macrocycle(self, l)?;
        if self.units.len() > known {
            flow::follow_calls(&mut context, self);
        }
        Ok(unit)
    }
}

impl Context<'_, '_> {
    /// The unit of macrocycle `l`; its own calls are not followed yet.
    pub(super) fn macrocycle(&mut self, resolved: &mut Resolved, l: u32) -> Result<UnitId, MacrocycleFault> {
        if let Some(&id) = resolved.macrocycles.get(&l) {
            return Ok(id);
        }
        let path = self.library.find(l)?;
        let source = self.library.load(&path, &path_name(&path), self.settings.encoding)?;
        let file = self.sources.add(Arc::clone(&source));
        let mut findings = Findings::with_levels(*self.findings.levels());
        let mut parsed = parse(file, &source, Form::Macrocycle, &mut findings);
        add_case(parsed.take_case(), &mut findings);
        if Self::is_program(&parsed) {
            return Ok(self.add_misnamed(resolved, parsed, l));
        }
        self.findings.append(findings);
        Ok(self.add_macrocycle(resolved, parsed, l))
    }

    pub(super) fn report(&mut self, at: Location, finding: Finding) {
        self.findings.add(Diagnostic::new(finding, at));
    }
}

#[cfg(test)]
mod tests {
    use std::path::Path;

    use super::*;
    use crate::syntax::BlockId;
    use crate::text::{FileId, MemoryLoader};

    fn resolve(body: &str) -> (Arc<SourceText>, Resolved, Findings) {
        let source = Arc::new(SourceText::from_text("t.nc", format!("%1\n{body}")));
        let (loader, settings) = (MemoryLoader::new(), Settings::default());
        let mut library = Library::new(&loader, &settings.macrocycles, Path::new("t.nc"));
        let (mut sources, mut findings) = (Sources::new(), Findings::new());
        let resolved = super::resolve(&source, None, &settings, &mut library, &mut sources, &mut findings);
        (source, resolved, findings)
    }

    /// FLW-5: jumps reach numbers of up to four digits; of a number that stands twice, the first block.
    #[test]
    fn blocks_by_number() {
        let (_, resolved, _) = resolve("N30 X1\nN9999 X2\nN10 X3\nN30 X4\nN10000 X5\nN10 X6\nN30 X7\nN5 M30\n");
        for (number, block) in [(5, Some(7)), (10, Some(2)), (30, Some(0)), (9999, Some(1)), (10_000, None), (20, None)]
        {
            assert_eq!(resolved.numbered(FileId(0), number), block.map(BlockId), "{number}");
        }
    }
}
