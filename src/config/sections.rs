//! Every table of `cnc872c.toml`. The keys in them are in [`keys`](super::keys) and
//! [`motion_keys`](super::motion_keys).

use super::names::Names;
use super::reader::Reader;
use super::row::Row;
use super::{keys, motion_keys};
use crate::dict::Bilingual;
use crate::text::Location;

/// A table of the project file.
#[derive(Clone, Copy, Debug)]
pub(super) struct Section {
    /// Its name; empty for what comes before all tables. A table in a table has the names of both, with a point
    /// between: `motion.times`; the outer one is a section too, with keys.
    pub name: &'static str,
    /// Its contents.
    pub form: Form,
    /// Its effect.
    pub meaning: Bilingual,
    /// The rule.
    pub rule: &'static str,
    /// The option of the command line that wins over it; the editor's settings have a key of its name then.
    pub option: Option<&'static str>,
    /// For names of the control: one with a value, as TOML; for tables by name, one of the names.
    pub example: &'static str,
    /// Ends one table with keys; the place is that of its header.
    pub done: fn(&mut Reader<'_>, Location),
}

/// The contents of a table.
#[derive(Clone, Copy, Debug)]
pub(super) enum Form {
    /// These keys: `[limits]`.
    Keys(&'static [Row]),
    /// A list of tables with these keys: `[[axes]]`.
    List(&'static [Row]),
    /// Names of one kind, each with a value that depends on the name: `[parameters]`.
    Map(Names),
    /// Names of one kind, each a table with these keys: `[corrections.7]`.
    Tables(Names, &'static [Row]),
}

impl Form {
    /// The keys of its tables.
    pub(super) const fn rows(self) -> &'static [Row] {
        match self {
            Self::Keys(rows) | Self::List(rows) | Self::Tables(_, rows) => rows,
            Self::Map(_) => &[],
        }
    }
}

impl Section {
    /// The name of the section that it is in: empty for the document; `None` for the document itself.
    pub(super) fn parent(&self) -> Option<&'static str> {
        if self.name.is_empty() { None } else { Some(self.name.rsplit_once('.').map_or("", |(parent, _)| parent)) }
    }

    /// Its name in the section that it is in.
    pub(super) fn own_name(&self) -> &'static str {
        self.name.rsplit_once('.').map_or(self.name, |(_, name)| name)
    }

    /// The sections in it.
    pub(super) fn children(&self) -> impl Iterator<Item = &'static Self> {
        let name = self.name;
        SECTIONS.iter().filter(move |section| section.parent() == Some(name))
    }
}

/// The options of the command line that win over the project file, as `--dialect`.
#[cfg(test)]
pub fn options() -> Vec<&'static str> {
    let rows = SECTIONS.iter().flat_map(|section| section.form.rows()).filter_map(|row| row.option);
    rows.chain(SECTIONS.iter().filter_map(|section| section.option)).flat_map(|option| option.split(", ")).collect()
}

/// Whether the table of that name is a list: `[[axes]]`.
pub(super) fn is_list(name: &str) -> bool {
    SECTIONS.iter().any(|section| section.name == name && matches!(section.form, Form::List(..)))
}

/// Tables: name and rule, option and example where there are any; what is in them, and what ends one; what they set in
/// English and Czech.
macro_rules! sections {
    ($($name:literal $rule:literal $(option $option:literal)? $(example $example:literal)?
        : $form:ident($($of:expr),*) $(, $done:ident)? => $en:literal, $cs:literal;)*) => {
        /// Every table of the project file, in the order in which the reference page shows them; the first is what
        /// comes before all tables.
        pub(super) const SECTIONS: &[Section; [$($name),*].len()] = &[$({
            let section = Section {
                name: $name,
                form: Form::$form($($of),*),
                meaning: Bilingual { en: $en, cs: $cs },
                rule: $rule,
                option: None,
                example: "",
                done: |_, _| {},
            };
            $(let section = Section { option: Some($option), ..section };)?
            $(let section = Section { example: $example, ..section };)?
            $(let section = Section { done: |reader, at| reader.$done(at), ..section };)?
            section
        }),*];
    };
}

sections! {
    "" "§11": Keys(keys::ROOT) =>
        "the control and its modes", "systém a jeho režimy";
    "axes" "ADR-4": List(keys::AXIS), axis =>
        "the axes in the order of the machine; without any, all nine letters X Y Z A B C U V W exist; CNC8x6 and \
        CNC8x9 have at most six, the sixth one of A, B, C",
        "osy v pořadí stroje; není-li uvedena žádná, existuje všech devět písmen X Y Z A B C U V W; CNC8x6 a CNC8x9 \
        mají nejvýše šest os, šestá je A, B nebo C";
    "start" "MOT-2" example "X = 0.0": Map(Names::Axes) =>
        "programmed positions before the first block, by axis; X is a radius where G74 holds at power-up",
        "programované polohy před prvním blokem, podle os; X je poloměr tam, kde po zapnutí platí G74";
    "power-up" "GRP-3, MFN-7" example "G5 = 54": Map(Names::Groups) =>
        "the function of each G and M group that holds at program start and after M02 and M30, by its number",
        "funkce každé skupiny G a M, která platí na začátku programu a po M02 a M30, svým číslem";
    "parameters" "PAR-5" option "--param" example "R10 = 25.5": Map(Names::Parameters) =>
        "the machine's parameter table at program start", "tabulka parametrů stroje na začátku programu";
    "operations" "PAR-9" example "\"01\" = \"add\"": Map(Names::Operations) =>
        "the operation behind each code `oo` of the control words of G26 to G29",
        "operace za každým kódem „oo“ v řídicích slovech funkcí G26 až G29";
    "cycles" "GRP-6" example "G81 = 8100": Map(Names::Cycles) =>
        "the macrocycle that a fixed cycle calls after each motion, by its number",
        "makrocyklus, který pevný cyklus volá po každém pohybu, svým číslem";
    "machine-macrocycles" "FLW-12" example "L9001":
        Tables(Names::Macrocycles, keys::MACHINE_MACROCYCLE), machine_macrocycle =>
        "macrocycles that only the machine has; a file of that number on the search path wins",
        "makrocykly, které má jen stroj; soubor téhož čísla na cestě hledání má přednost";
    "gears" "MFN-9": List(keys::GEAR), gear =>
        "the speed ranges of the spindle", "rozsahy otáček vřetena";
    "machine-constants" "MFN-5" example "R340 = 1.0": Map(Names::Constants) =>
        "machine constants as the control shows them: eight digits as a text, or a number with three decimals; R56 to \
        R59 give M groups 10 to 13 on CNC8x6 and CNC8x9, four functions of two digits each; others give what \
        `[motion]` says",
        "strojní konstanty, jak je ukazuje systém: osm číslic jako text, nebo číslo se třemi desetinnými místy; R56 \
        až R59 určují u CNC8x6 a CNC8x9 M skupiny 10 až 13, každá čtyři funkce po dvou číslicích; jiné udávají totéž \
        co `[motion]`";
    "motion" "CNT, VEL": Keys(motion_keys::MOTION), motion =>
        "what motion is computed with; on CNC8x6 and CNC8x9 the machine constants give the same values, each once",
        "s čím se počítá pohyb; u CNC8x6 a CNC8x9 udávají tytéž hodnoty strojní konstanty, každou jen jednou";
    "motion.times" "TIM-1" example "M06 = 6.5": Map(Names::Timed) =>
        "seconds that functions take; a block takes the longest of its own",
        "sekundy, které trvají funkce; blok trvá podle té nejdelší z nich";
    "motion.sets" "VEL-14": Keys(&[]) =>
        "the dynamic sets, which count with the parabolic profile only; a set or value that is missing, or 0, is that \
        of set 1, then that of `[motion]`",
        "sady pro dynamické řízení, které platí jen při parabolickém průběhu; sada nebo hodnota, která chybí nebo je \
        0, je z 1. sady, pak z [motion]";
    "motion.sets.1" "VEL-14": Keys(motion_keys::SET), motion_set =>
        "the set of G23 I1, which holds from the start (R406 to R411)",
        "sada pro G23 I1, platná od začátku (R406 až R411)";
    "motion.sets.2" "VEL-14": Keys(motion_keys::SET), motion_set =>
        "the set of G23 I2 (R412 to R417)", "sada pro G23 I2 (R412 až R417)";
    "motion.sets.3" "VEL-14": Keys(motion_keys::SET), motion_set =>
        "the set of G23 I3 (R418 to R423)", "sada pro G23 I3 (R418 až R423)";
    "motion.sets.4" "VEL-14": Keys(motion_keys::SET), motion_set =>
        "the set of G23 I4 (R424 to R429)", "sada pro G23 I4 (R424 až R429)";
    "motion.sets.rapid" "VEL-8": Keys(motion_keys::RAPID_SET), motion_set =>
        "the set of G00 (R430 to R432)", "sada pro G00 (R430 až R432)";
    "corrections" "EQU-1" example "7": Tables(Names::Corrections, keys::CORRECTION) =>
        "radius corrections by the number of D, as they are in the control's table; for the picture of the corrected \
        path",
        "poloměrové korekce podle čísla D, jak jsou v tabulce systému; pro obraz korigované dráhy";
    "limits" "§11": Keys(keys::LIMITS) =>
        "where the compiler draws a line", "meze překladače";
    "format" "FMT-5": Keys(keys::FORMAT) =>
        "how `format` lays out programs", "jak `format` upravuje zápis programů";
    "restart" "RST-2": Keys(keys::RESTART) =>
        "how `restart` comes to a place of a program", "jak `restart` najíždí na místo v programu";
    "lints" "§11" option "-D, -W, -A" example "empty-block = \"allow\"": Map(Names::Lints) =>
        "levels of warnings, and of E0109, by name or code",
        "úrovně varování a hlášení E0109, podle jména nebo kódu";
}

/// What comes before all tables.
pub(super) const ROOT: &Section = {
    let [root, ..] = SECTIONS;
    root
};

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn names_are_unique() {
        let mut tables: Vec<_> = SECTIONS.iter().map(|section| section.name).collect();
        tables.sort_unstable();
        tables.dedup();
        assert_eq!(tables.len(), SECTIONS.len());
        for section in SECTIONS {
            let own = section.form.rows().iter().map(|row| row.name);
            let mut names: Vec<_> = own.chain(section.children().map(Section::own_name)).collect();
            let count = names.len();
            names.sort_unstable();
            names.dedup();
            assert_eq!(names.len(), count, "{}", section.name);
        }
    }

    /// A table in a table is read with the outer one.
    #[test]
    fn each_table_is_in_one_with_keys() {
        for section in SECTIONS {
            let Some(parent) = section.parent() else { continue };
            let parent = SECTIONS.iter().find(|other| other.name == parent).unwrap();
            assert!(matches!(parent.form, Form::Keys(..)), "{}", section.name);
        }
    }
}
