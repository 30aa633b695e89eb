//! Says of a program with errors that it is one for another control.

use std::sync::Arc;

use crate::config::Settings;
use crate::diag::{Code, Diagnostic, Finding, Findings, LabelText, shown};
use crate::syntax::{ParsedFile, foreign};
use crate::text::{Location, SourceText, Span};

/// A file, once it is parsed: where its program begins.
pub(super) struct Origin {
    source: Arc<SourceText>,
    /// Before the `%`, or at the start of the file: this finding comes before those about the `%` word.
    place: Location,
    /// What stands before a readable `%` word is no program; else all of the text is looked at.
    from: u32,
}

impl Origin {
    pub(super) fn of(parsed: &ParsedFile) -> Self {
        let source = Arc::clone(&parsed.source);
        let first = source.first_offset();
        let percent = source.text().as_bytes().get(parsed.start as usize) == Some(&b'%');
        let place = Span::empty(if percent { parsed.start } else { first });
        let readable = parsed.program.is_some_and(|word| !word.is_faulty());
        Self { source, place: parsed.at(place), from: if readable { parsed.start } else { first } }
    }

    /// Gives the findings of the program. When there are errors in the file, and its text is for another control, says
    /// so, and gives one finding of each line.
    pub(super) fn give(self, settings: &Settings, found: Findings, findings: &mut Findings) {
        let file = self.place.file;
        // Text after `*` counts too: `*` ends blocks elsewhere. A program number written as elsewhere is one slip, with
        // a fix.
        let telling = |code| found.levels().is_fault(code) || code == Code::W0110;
        let slip = |finding: &Finding| matches!(finding, Finding::MissingValue { address, .. } if address == "%");
        let tells = |item: &Diagnostic| item.at.file == file && telling(item.code()) && !slip(&item.finding);
        let wrong = found.items().iter().any(tells) && settings.severity(Code::W0113).is_some();
        let Some(foreign) = wrong.then(|| foreign(self.source.text(), self.from)).flatten() else {
            return findings.append(found);
        };
        findings.append_one_a_line(found, file, self.source.lines());
        let finding = Finding::OtherControlProgram { control: foreign.control };
        let mut diagnostic = Diagnostic::new(finding, self.place);
        if !foreign.line.range().contains(&(self.place.span.start as usize)) {
            diagnostic = diagnostic.with_label(
                Location { file, span: foreign.line },
                LabelText::ShowsIt { text: shown(self.source.slice(foreign.line)) },
            );
        }
        findings.add(diagnostic);
    }
}
