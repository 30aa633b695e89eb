//! The two languages of the project's users.

/// A language of messages and pages.
#[derive(Clone, Copy, Debug, Default, Eq, PartialEq, clap::ValueEnum)]
pub enum Lang {
    /// English.
    #[default]
    En,
    /// Czech.
    Cs,
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
