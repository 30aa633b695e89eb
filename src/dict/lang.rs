//! The two languages of the project's users.

/// A language of messages and pages.
#[derive(Clone, Copy, Debug, Default, Eq, PartialEq)]
#[cfg_attr(feature = "cli", derive(clap::ValueEnum))]
pub enum Lang {
    /// English.
    #[default]
    En,
    /// Czech.
    Cs,
}

impl Lang {
    /// `en`, `cs`.
    pub const fn code(self) -> &'static str {
        match self {
            Self::En => "en",
            Self::Cs => "cs",
        }
    }

    /// The language that options and settings call so: `en`, `cs`, in either case.
    pub fn named(name: &str) -> Option<Self> {
        match name.to_ascii_lowercase().as_str() {
            "en" => Some(Self::En),
            "cs" => Some(Self::Cs),
            _ => None,
        }
    }
}

/// One text in both languages.
#[derive(Clone, Copy, Debug, Eq, PartialEq)]
pub struct Bilingual {
    /// In English.
    pub en: &'static str,
    /// In Czech.
    pub cs: &'static str,
}

impl Bilingual {
    /// The text in `lang`.
    pub const fn get(self, lang: Lang) -> &'static str {
        match lang {
            Lang::En => self.en,
            Lang::Cs => self.cs,
        }
    }
}

/// The text with its first letter in upper case.
pub(crate) fn capitalized(text: &str) -> String {
    let mut characters = text.chars();
    characters.next().into_iter().flat_map(char::to_uppercase).chain(characters).collect()
}

/// Declares a closed set of texts: an enum whose rows are a name, fields, and the text in English and Czech, both
/// format strings with the fields by name.
macro_rules! bilingual {
    ($(#[$doc:meta])* $name:ident {
        $($variant:ident $({ $($field:ident : $ty:ty),* })? $en:literal, $cs:literal;)*
    }) => {
        $(#[$doc])*
        #[derive(Clone, Debug, Eq, PartialEq)]
        #[allow(missing_docs, reason = "the texts say it")]
        pub enum $name {
            $(#[doc = $en] $variant $({ $($field: $ty),* })?,)*
        }

        impl $name {
            /// The text in `lang`.
            pub fn text(&self, lang: $crate::dict::Lang) -> String {
                match (self, lang) {
                    $(
                        (Self::$variant $({ $($field),* })?, $crate::dict::Lang::En) => format!($en),
                        (Self::$variant $({ $($field),* })?, $crate::dict::Lang::Cs) => format!($cs),
                    )*
                }
            }
        }
    };
}
pub(crate) use bilingual;
