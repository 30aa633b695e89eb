//! One finding at its place.

use super::{Code, Finding, FixTitle, LabelText};
use crate::text::{FileId, Location};

/// A finding, where it is, what else belongs to it, and how it may be fixed.
#[derive(Clone, Debug)]
pub struct Diagnostic {
    /// The mistake.
    pub finding: Finding,
    /// Where.
    pub at: Location,
    /// Other places that explain it.
    pub labels: Vec<Label>,
    /// The calls that led there, outermost first; for findings that depend on them.
    pub calls: Vec<CallSite>,
    /// Changes a machine may apply.
    pub fixes: Vec<Fix>,
}

/// Another place that explains a finding.
#[derive(Clone, Debug)]
pub struct Label {
    /// The place.
    pub at: Location,
    /// Its text.
    pub text: LabelText,
}

/// By what a unit was called.
#[derive(Clone, Copy, Debug, Eq, Hash, PartialEq)]
pub enum CallKind {
    /// G71: a subprogram.
    Subprogram,
    /// G72: a macrocycle.
    Macrocycle,
    /// The cycle map: G81–G89, by number.
    Cycle(u8),
}

impl CallKind {
    /// Whether what it calls is a macrocycle.
    pub const fn is_macrocycle(self) -> bool {
        match self {
            Self::Subprogram => false,
            Self::Macrocycle | Self::Cycle(_) => true,
        }
    }

    /// As the stream and the findings name it: `G71`, `G72`, `G81`–`G89`.
    pub const fn name(self) -> &'static str {
        match self {
            Self::Subprogram => "G71",
            Self::Macrocycle => "G72",
            Self::Cycle(81) => "G81",
            Self::Cycle(82) => "G82",
            Self::Cycle(83) => "G83",
            Self::Cycle(84) => "G84",
            Self::Cycle(85) => "G85",
            Self::Cycle(86) => "G86",
            Self::Cycle(87) => "G87",
            Self::Cycle(88) => "G88",
            Self::Cycle(_) => "G89",
        }
    }
}

/// One call on the way to a finding.
#[derive(Clone, Copy, Debug, Eq, PartialEq)]
pub struct CallSite {
    /// By what.
    pub by: CallKind,
    /// What was called.
    pub l: u32,
    /// Number of the calling block.
    pub n: u32,
    /// The calling block's `N` word.
    pub at: Location,
}

/// A change that fixes what a finding reports.
#[derive(Clone, Debug)]
pub struct Fix {
    /// Its effect.
    pub title: FixTitle,
    /// Replacements that do not overlap.
    pub edits: Vec<Edit>,
    /// Why it is what was meant beyond doubt, so that `check --fix` applies it; `None` where it is only offered.
    pub certain: Option<Certain>,
}

/// Why a fix is certain: nobody who made one slip of the keyboard can have meant anything else, and no number, word or
/// comment becomes another one. Whatever is not in this list is offered, and never applied by itself.
#[derive(Clone, Copy, Debug, Eq, PartialEq)]
pub enum Certain {
    /// A decimal comma between the digits of a dimensional word: `X36,12`.
    DecimalComma,
    /// Letters that look like digits and are the whole number: `XO`.
    LettersAlone,
    /// Blanks between a sign and the number: `X-  36.12`.
    BlankBehindSign,
    /// Addresses in lower case, in a file that has most of them so.
    LowerCase,
    /// Typographic quotes around a comment without a word of a block in it.
    Quotes,
    /// A typographic minus before a number.
    Minus,
    /// A blank that is none of ASCII, between two words.
    Blank,
    /// UTF-16 without an error in it.
    Utf16,
    /// `(text)`, `; text` without a word of a block in it.
    Comment,
}

/// One replacement.
#[derive(Clone, Debug)]
pub struct Edit {
    /// The place that it replaces.
    pub at: Location,
    /// By what; ASCII, so that it is the same in every code page, but for the whole text of a file in UTF-16.
    pub text: String,
}

impl Fix {
    /// A change of one place that is offered, but not applied by itself.
    pub fn offer(title: FixTitle, at: Location, text: impl Into<String>) -> Self {
        Self { title, edits: vec![Edit { at, text: text.into() }], certain: None }
    }
}

impl Diagnostic {
    /// `finding` at `at`, alone.
    pub fn new(finding: Finding, at: Location) -> Self {
        Self { finding, at, labels: Vec::new(), calls: Vec::new(), fixes: Vec::new() }
    }

    /// Its code.
    pub fn code(&self) -> Code {
        self.finding.code()
    }

    /// Which of several findings of its code at one place it is: the operands of a control word are parameters of their
    /// own.
    pub(super) const fn which(&self) -> u8 {
        if let Finding::UnassignedParameter { parameter, .. } = self.finding { parameter.saturating_add(1) } else { 0 }
    }

    /// With another place.
    #[must_use]
    pub fn with_label(mut self, at: Location, text: LabelText) -> Self {
        self.labels.push(Label { at, text });
        self
    }

    /// With a fix that replaces one place.
    #[must_use]
    pub fn with_fix(self, why: Certain, title: FixTitle, at: Location, text: impl Into<String>) -> Self {
        self.with_edits(Some(why), title, vec![Edit { at, text: text.into() }])
    }

    /// With a change of several edits: a fix where it is certain, else an offer.
    #[must_use]
    pub fn with_edits(mut self, certain: Option<Certain>, title: FixTitle, edits: Vec<Edit>) -> Self {
        self.fixes.push(Fix { title, edits, certain });
        self
    }

    /// With a change of one place that is offered, but not applied by itself.
    #[must_use]
    pub fn with_offer(mut self, title: FixTitle, at: Location, text: impl Into<String>) -> Self {
        self.fixes.push(Fix::offer(title, at, text));
        self
    }

    /// With a change of several edits that is offered, but not applied by itself.
    #[must_use]
    pub fn with_offers(self, title: FixTitle, edits: Vec<Edit>) -> Self {
        self.with_edits(None, title, edits)
    }

    /// The fix that a machine may apply by itself.
    pub fn certain_fix(&self) -> Option<&Fix> {
        self.fixes.iter().find(|fix| fix.certain.is_some())
    }

    /// The file it is in.
    pub const fn file(&self) -> FileId {
        self.at.file
    }
}
