//! What findings about arcs, planes and the spindle name, in both languages.

use std::fmt;

use crate::dict::{Lang, bilingual};

bilingual! {
    /// What was probably meant by I and J that do not fit.
    ArcMeant {
        Nothing
            "correct `I` and `J`, or the end point; `I` and `J` are distances from the start, not coordinates of the \
            centre",
            "opravit I a J, nebo koncový bod; I a J jsou vzdálenosti od začátku oblouku, ne souřadnice středu";
        Coordinates { words: Centers }
            "`I` and `J` fit as coordinates of the centre, but they are distances from the start: write `{words}`",
            "I a J vyhovují jako souřadnice středu, jsou to ale vzdálenosti od začátku oblouku: napsat „{words}“";
        Exchanged { words: Centers }
            "`I` and `J` fit when exchanged: write `{words}`",
            "I a J vyhovují, když se vymění: napsat „{words}“";
        Several { words: Centers }
            "`I` and `J` fit in more than one way: write what is meant, {words}",
            "I a J lze opravit více způsoby: napsat ten, který je záměrem: {words}";
        Distances
            "the arc fits if its end is a distance: if that is meant, write G91 (G90 is in force)",
            "oblouk by vyhověl s koncem zadaným přírůstkově; je-li to záměr, napsat G91 (platí G90)";
        Positions
            "the arc fits if its end is a position: if that is meant, write G90 (G91 is in force)",
            "oblouk by vyhověl s koncem zadaným absolutně; je-li to záměr, napsat G90 (platí G91)";
    }
}

/// I and J that fit, each pair for itself.
#[derive(Clone, Debug, Eq, PartialEq)]
pub struct Centers(pub Vec<[String; 2]>);

impl fmt::Display for Centers {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        for (at, [i, j]) in self.0.iter().enumerate() {
            write!(f, "{}I{i} J{j}", if at == 0 { "" } else { " / " })?;
        }
        Ok(())
    }
}

bilingual! {
    /// Why a word of the spindle's axis cannot be executed.
    SpindleFault {
        Turning { m: u8 }
            "it cannot be positioned while M{m:02} turns it",
            "nelze ho polohovat, když se otáčí (M{m:02})";
        TooFar { degrees: String }
            "one block turns it by {degrees}°, and 69999.999° is the most",
            "jeden blok ho otáčí o {degrees}°, nejvýše smí o 69999.999°";
    }
}

impl SpindleFault {
    /// What to write instead.
    pub fn help(&self, lang: Lang) -> &'static str {
        match (self, lang) {
            (Self::Turning { .. }, Lang::En) => "program M19 first",
            (Self::Turning { .. }, Lang::Cs) => "nejdřív zadat M19",
            (Self::TooFar { .. }, Lang::En) => "split the turn into several blocks",
            (Self::TooFar { .. }, Lang::Cs) => "rozdělit otočení do několika bloků",
        }
    }
}

bilingual! {
    /// How a plane does not fit.
    PlaneFault {
        MissingAxis { axis: char } "the machine has no axis {axis}", "stroj nemá osu {axis}";
        MissingFourth "the machine has no 4th axis", "stroj nemá 4. osu";
        OtherAxes { axes: String, correction: String }
            "the arc moves {axes}, and {correction} corrects the radius in the plane only",
            "oblouk se pohybuje v osách {axes} a {correction} koriguje poloměr jen v rovině";
    }
}

impl PlaneFault {
    /// That an axis is missing, by its letter, or the fourth.
    pub fn missing(axis: Option<char>) -> Self {
        axis.map_or(Self::MissingFourth, |axis| Self::MissingAxis { axis })
    }
}

/// Start, centre and end of an arc, along its two axes in machine order, in mm.
#[derive(Clone, Debug, Eq, PartialEq)]
pub struct ArcPoints {
    /// The letters of the axes.
    pub axes: [char; 2],
    /// Where it starts.
    pub start: [String; 2],
    /// Its centre by I and J.
    pub center: [String; 2],
    /// Where it ends.
    pub end: [String; 2],
    /// X is shown as a radius, while the program writes diameters (G74).
    pub diameters: bool,
}

impl ArcPoints {
    /// What to write; whose I and J are is configured where the arc is not in XY.
    pub(super) fn help(&self, meant: &ArcMeant, lang: Lang) -> String {
        let configured = match lang {
            Lang::En => "; which axis `I` belongs to is `arc-centers` in the project file",
            Lang::Cs => "; ke které ose patří I, určuje arc-centers v projektovém souboru",
        };
        let other = matches!(meant, ArcMeant::Exchanged { .. } | ArcMeant::Several { .. }) && self.axes != ['X', 'Y'];
        format!("{}{}", meant.text(lang), if other { configured } else { "" })
    }

    /// As a note.
    pub fn text(&self, lang: Lang) -> String {
        let point = |[first, second]: &[String; 2]| format!("{}{first} {}{second}", self.axes[0], self.axes[1]);
        let (start, center, end) = (point(&self.start), point(&self.center), point(&self.end));
        match (lang, self.diameters) {
            (Lang::En, false) => format!("start {start}, centre {center}, end {end}"),
            (Lang::Cs, false) => format!("začátek {start}, střed {center}, konec {end}"),
            (Lang::En, true) => format!(
                "start {start}, centre {center}, end {end}; these X are radii (G74 programs diameters, I is a radius)"
            ),
            (Lang::Cs, true) => format!(
                "začátek {start}, střed {center}, konec {end}; X jsou zde poloměry (při G74 se programuje průměr, I \
                je poloměr)"
            ),
        }
    }
}
