//! Advice about text behind `*`, which ends the file.

use crate::dict::{Lang, bilingual};

/// The end of a program behind `*` (E0205).
#[derive(Clone, Copy, Debug, Eq, PartialEq)]
pub struct UnreadEnd {
    /// M02 or M30.
    pub function: u8,
    /// Where it is.
    pub unread: Unread,
}

/// Text behind `*`, which the control does not read.
#[derive(Clone, Copy, Debug, Eq, PartialEq)]
pub struct Unread {
    /// Its line.
    pub line: u32,
    /// The surroundings of the `*`.
    pub star: Star,
}

/// The probable meaning of a `*`.
#[derive(Clone, Copy, Debug, Eq, PartialEq)]
pub enum Star {
    /// It begins a line.
    Line,
    /// It begins a line, before a block number without its N: `*120 X5`.
    Number {
        /// That line has the unread text.
        own: bool,
    },
    /// It begins a line, before a block: `*N120 X5`.
    Block,
    /// It is between two factors.
    Product,
    /// It is within a block.
    Slip,
}

impl UnreadEnd {
    /// The mistake.
    pub(super) fn message(self, lang: Lang) -> String {
        let Self { function: m, unread: Unread { line, .. } } = self;
        match lang {
            Lang::En => format!("the program has no end: M{m:02} in line {line} is after `*`, which ends the file"),
            Lang::Cs => {
                format!("program nemá konec: M{m:02} na řádku {line} je až za hvězdičkou, která ukončuje soubor")
            }
        }
    }
}

impl Unread {
    /// What to write.
    pub(super) const fn help(self, lang: Lang) -> &'static str {
        match (lang, self.star) {
            (Lang::En, Star::Line) => "put the line with `*` between quotes, or delete the `*`",
            (Lang::Cs, Star::Line) => "řádek s hvězdičkou dát do uvozovek, nebo hvězdičku vymazat",
            (Lang::En, Star::Number { own: true }) => "write `N` in place of the `*`",
            (Lang::Cs, Star::Number { own: true }) => "místo hvězdičky napsat N",
            (Lang::En, Star::Number { own: false }) => "write `N` in place of the `*`, or put the line between quotes",
            (Lang::Cs, Star::Number { own: false }) => "místo hvězdičky napsat N, nebo řádek dát do uvozovek",
            (Lang::En, Star::Block) => "delete the `*`, or put the line between quotes",
            (Lang::Cs, Star::Block) => "hvězdičku vymazat, nebo řádek dát do uvozovek",
            (Lang::En, Star::Product) => "if a product is meant, G26 to G29 compute it; if not, delete the `*`",
            (Lang::Cs, Star::Product) => "je-li míněn součin, počítají ho G26 až G29; není-li, hvězdičku vymazat",
            (Lang::En, Star::Slip) => "delete the `*`",
            (Lang::Cs, Star::Slip) => "hvězdičku vymazat",
        }
    }
}

bilingual! {
    /// What was probably meant by text behind `*` (W0110).
    AfterEndMeant {
        Text "move it before `*`, or make it a comment", "přesunout před hvězdičku, nebo z něj udělat komentář";
        Program "put it into a file of its own", "dát ho do samostatného souboru";
        Separator { line: String }
            "`*` ends the file: a line between blocks is a comment, `\"{line}\"`",
            "hvězdička ukončuje soubor; řádek mezi bloky se píše jako komentář: \"{line}\"";
        Product
            "there are no expressions: products are computed by G26 to G29; `*` ends the file",
            "výrazy se psát nedají: součiny počítají G26 až G29; hvězdička ukončuje soubor";
    }
}

impl AfterEndMeant {
    /// The mistake.
    pub(super) const fn message(&self, lang: Lang) -> &'static str {
        match (self, lang) {
            (Self::Program, Lang::En) => "a second program after `*`: the control never reads it",
            (Self::Program, Lang::Cs) => "za hvězdičkou je druhý program, systém ho nikdy nečte",
            (Self::Text | Self::Product | Self::Separator { .. }, Lang::En) => {
                "the control never reads what follows `*`"
            }
            (Self::Text | Self::Product | Self::Separator { .. }, Lang::Cs) => "text za hvězdičkou systém nikdy nečte",
        }
    }
}
