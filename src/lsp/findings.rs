//! Findings as the client shows them.

use std::collections::BTreeMap;
use std::path::Path;

use gen_lsp_types::{
    Code as LspCode, CodeDescription, Diagnostic as LspDiagnostic, DiagnosticRelatedInformation, DiagnosticSeverity,
    DiagnosticTag, Location as LspLocation, Message, Uri,
};

use super::files::EditorFiles;
use super::places::{Places, location};
use super::texts::Text;
use crate::diag::{Code, Diagnostic, Report, Reported, Severity};
use crate::dict::Lang;
use crate::text::{ColumnUnit, FileId};

/// The scheme of the server's own documents: `cnc872c:/explain/cs/E0307.md`.
pub(super) const SCHEME: &str = "cnc872c";

/// The findings of a report by the files they are in.
pub(super) fn by_file(
    report: &Report,
    files: &EditorFiles,
    unit: ColumnUnit,
    lang: Lang,
) -> BTreeMap<Uri, Vec<LspDiagnostic>> {
    let mut found: BTreeMap<Uri, Vec<LspDiagnostic>> = BTreeMap::new();
    let mut current: Option<(FileId, Uri, Places<'_>)> = None;
    for item in report.items() {
        let file = item.diagnostic.file();
        if current.as_ref().is_none_or(|(known, ..)| *known != file) {
            current = report.sources().get(file).and_then(|source| {
                let uri = files.uri_of(Path::new(source.name()))?;
                Some((file, uri, Places::new(source, unit)))
            });
        }
        let Some((_, uri, places)) = &mut current else { continue };
        let converter = Converter { report, files, unit, lang };
        found.entry(uri.clone()).or_default().push(converter.diagnostic(item, places));
    }
    for (id, source) in report.sources().iter() {
        let beyond = report.beyond(id);
        let Some(uri) = files.uri_of(Path::new(source.name())).filter(|_| beyond > 0) else { continue };
        let found = found.entry(uri).or_default();
        let message = Text::NotShown { shown: found.len(), all: found.len() + beyond }.text(lang);
        let diagnostic = LspDiagnostic {
            severity: Some(DiagnosticSeverity::Information),
            source: Some("cnc872c".to_owned()),
            message: Message::String(message),
            ..LspDiagnostic::default()
        };
        found.insert(0, diagnostic);
    }
    found
}

/// Makes findings of a report what the client shows.
#[derive(Clone, Copy)]
pub(super) struct Converter<'a> {
    pub(super) report: &'a Report,
    pub(super) files: &'a EditorFiles,
    pub(super) unit: ColumnUnit,
    pub(super) lang: Lang,
}

impl Converter<'_> {
    /// One finding; `places` are those of its file.
    pub(super) fn diagnostic(&self, item: &Reported, places: &mut Places<'_>) -> LspDiagnostic {
        let Reported { severity, diagnostic } = item;
        let code = diagnostic.code();
        LspDiagnostic {
            range: places.range(diagnostic.at.span),
            severity: Some(match severity {
                Severity::Error => DiagnosticSeverity::Error,
                Severity::Warning => DiagnosticSeverity::Warning,
            }),
            code: Some(LspCode::String(code.as_str().to_owned())),
            code_description: page(code, self.lang).map(|href| CodeDescription { href }),
            source: Some("cnc872c".to_owned()),
            message: Message::String(message(diagnostic, self.lang)),
            tags: tag(code).map(|tag| vec![tag]),
            related_information: Some(self.related(diagnostic)).filter(|related| !related.is_empty()),
            data: None,
        }
    }

    fn related(&self, diagnostic: &Diagnostic) -> Vec<DiagnosticRelatedInformation> {
        let labels = diagnostic.labels.iter().map(|label| (label.at, label.text.text(self.lang)));
        let calls = diagnostic.calls.iter().rev().map(|call| {
            let (n, by, l) = (call.n, call.by.name(), call.l);
            (call.at, Text::CalledBy { n, by, l }.text(self.lang))
        });
        labels
            .chain(calls)
            .filter_map(|(at, message)| {
                let location: LspLocation = location(self.files, self.report.sources(), at, self.unit)?;
                Some(DiagnosticRelatedInformation { location, message })
            })
            .collect()
    }
}

/// The message with its note and its help.
fn message(diagnostic: &Diagnostic, lang: Lang) -> String {
    let mut message = diagnostic.finding.message(lang);
    let remarks = [
        diagnostic.finding.note(lang).map(|note| Text::Note { note }.text(lang)),
        diagnostic.finding.help(lang).map(|help| Text::Help { help }.text(lang)),
    ];
    for remark in remarks.into_iter().flatten() {
        message.push('\n');
        message.push_str(&remark);
    }
    message
}

/// Where the page of a code is: a document that the server gives (`workspace/textDocumentContent`).
pub(super) fn page(code: Code, lang: Lang) -> Option<Uri> {
    let lang = lang.code();
    Uri::parse(&format!("{SCHEME}:/explain/{lang}/{code}.md")).ok()
}

/// Findings about what has no effect are shown faded, and a form that is only tolerated, struck through.
fn tag(code: Code) -> Option<DiagnosticTag> {
    const UNNECESSARY: [Code; 8] =
        [Code::W0110, Code::E0206, Code::W0211, Code::W0214, Code::E0218, Code::W0402, Code::W0403, Code::W0506];
    const DEPRECATED: Code = Code::W0213;
    let unnecessary = UNNECESSARY.contains(&code).then_some(DiagnosticTag::Unnecessary);
    unnecessary.or((code == DEPRECATED).then_some(DiagnosticTag::Deprecated))
}

#[cfg(test)]
mod tests {
    use std::sync::Arc;

    use super::*;
    use crate::diag::{Finding, Findings};
    use crate::text::{Location, MemoryLoader, SourceText, Sources, Span};

    /// One line counts the findings beyond the limit.
    #[test]
    fn what_is_not_shown() {
        let (mut sources, mut findings) = (Sources::new(), Findings::new());
        let file = sources.add(SourceText::from_text("/p.nc", "N".repeat(10_010)));
        for at in 0..10_005 {
            let at = Location { file, span: Span::new(at, at + 1) };
            findings.add(Diagnostic::new(Finding::EmptyBlock { block: 1, function: None }, at));
        }
        let mut report = Report::new();
        report.add_program(&sources, findings);
        let files = EditorFiles::new(Arc::new(MemoryLoader::new()));
        let found = by_file(&report, &files, ColumnUnit::Utf16, Lang::En);
        let all = found.values().next().unwrap();
        assert_eq!(all.len(), 10_001);
        assert_eq!(all[0].message, Message::String("10000 of 10005 findings are shown".to_owned()));
        assert_eq!(all[0].severity, Some(DiagnosticSeverity::Information));
    }
}
