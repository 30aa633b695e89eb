//! The form of the rows of the registry, and further facts about codes.

use super::Code;
use crate::named::named;

named! {
    /// How serious a finding is, unless configured.
    #[derive(Clone, Copy, Debug, Eq, Hash, Ord, PartialEq, PartialOrd)]
    pub enum Severity {
        /// The program is wrong, or means something else than written.
        Error "error" ("error", "chyba"),
        /// The program is legal, but probably not intended.
        Warning "warning" ("warning", "varování"),
    }
}

macro_rules! text {
    (($text:expr)) => {
        String::from($text)
    };
    ($text:literal) => {
        format!($text)
    };
}

macro_rules! optional_text {
    () => {
        String::new()
    };
    ($text:tt) => {
        text!($text)
    };
}

/// Makes `Code` and `Finding` of the rows.
macro_rules! diagnostics {
    ([] $(
        [$code:ident] $variant:ident $name:literal $severity:ident { $($field:ident : $ty:ty),* $(,)? }
            en $en:tt
            cs $cs:tt
            $(help $help_en:tt | $help_cs:tt)?
            $(note $note_en:tt | $note_cs:tt)?
    )*) => {
        /// The code of a diagnostic. Codes are never reused.
        #[derive(Clone, Copy, Debug, Eq, Hash, Ord, PartialEq, PartialOrd)]
        pub enum Code {
            $(#[doc = $name] $code,)*
        }

        impl Code {
            /// Every code, in order of definition.
            pub const ALL: &'static [Self] = &[$(Self::$code),*];

            /// The code as written: `E0306`.
            pub const fn as_str(self) -> &'static str {
                match self { $(Self::$code => stringify!($code),)* }
            }

            /// The kebab-case name: `duplicate-address`.
            pub const fn name(self) -> &'static str {
                match self { $(Self::$code => $name,)* }
            }

            /// Its level unless configured.
            pub const fn severity(self) -> Severity {
                match self { $(Self::$code => Severity::$severity,)* }
            }

            /// Its page in `lang`, Markdown.
            pub const fn page(self, lang: Lang) -> &'static str {
                match (self, lang) {
                    $(
                        (Self::$code, Lang::En) =>
                            include_str!(concat!("../../../docs/explain/en/", stringify!($code), ".md")),
                        (Self::$code, Lang::Cs) =>
                            include_str!(concat!("../../../docs/explain/cs/", stringify!($code), ".md")),
                    )*
                }
            }
        }

        /// What was found, with what its texts name.
        #[derive(Clone, Debug, PartialEq)]
        #[allow(missing_docs, reason = "the texts of each row say what its fields are")]
        pub enum Finding {
            $(#[doc = $name] $variant { $($field: $ty),* },)*
        }

        #[allow(unused_variables, reason = "not every text names every field")]
        impl Finding {
            /// Its code.
            pub const fn code(&self) -> Code {
                match self { $(Self::$variant { .. } => Code::$code,)* }
            }

            /// The mistake, in one sentence.
            pub fn message(&self, lang: Lang) -> String {
                match (self, lang) {
                    $(
                        (Self::$variant { $($field),* }, Lang::En) => text!($en),
                        (Self::$variant { $($field),* }, Lang::Cs) => text!($cs),
                    )*
                }
            }

            /// What to write instead, where that can be said.
            pub fn help(&self, lang: Lang) -> Option<String> {
                let help = match (self, lang) {
                    $(
                        (Self::$variant { $($field),* }, Lang::En) => optional_text!($($help_en)?),
                        (Self::$variant { $($field),* }, Lang::Cs) => optional_text!($($help_cs)?),
                    )*
                };
                Some(help).filter(|help| !help.is_empty())
            }

            /// Why it is so.
            pub fn note(&self, lang: Lang) -> Option<String> {
                let note = match (self, lang) {
                    $(
                        (Self::$variant { $($field),* }, Lang::En) => optional_text!($($note_en)?),
                        (Self::$variant { $($field),* }, Lang::Cs) => optional_text!($($note_cs)?),
                    )*
                };
                Some(note).filter(|note| !note.is_empty())
            }
        }
    };
}
pub(super) use diagnostics;
pub(super) use {optional_text, text};

impl Code {
    /// The diagnostic of that code (`E0306`) or name (`duplicate-address`).
    pub fn find(code_or_name: &str) -> Option<Self> {
        Self::ALL
            .iter()
            .copied()
            .find(|code| code.as_str().eq_ignore_ascii_case(code_or_name) || code.name() == code_or_name)
    }

    /// Whether it is allowed unless `[lints]` asks for it.
    pub const fn is_off(self) -> bool {
        matches!(self, Self::W0628 | Self::W0629 | Self::W0801 | Self::W0802 | Self::W0804)
    }

    /// Whether it is an error of structure or flow: which block leads where is then not certain, and a program without
    /// blocks has such a finding.
    pub fn prevents_execution(self) -> bool {
        let structure = self.severity() == Severity::Error;
        structure && ["E02", "E04"].iter().any(|family| self.as_str().starts_with(family))
    }

    /// Whether it says that characters could not be read as words (FMT-6, REN-5).
    pub const fn is_malformed(self) -> bool {
        matches!(
            self,
            Self::E0101
                | Self::E0102
                | Self::E0103
                | Self::E0104
                | Self::E0105
                | Self::E0106
                | Self::E0107
                | Self::E0111
        )
    }

    /// Whether its level may be changed: warnings, and E0109.
    pub fn is_configurable(self) -> bool {
        self.severity() == Severity::Warning || self == Self::E0109
    }
}

impl std::fmt::Display for Code {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        f.write_str(self.as_str())
    }
}
