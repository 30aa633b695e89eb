//! Every table of `cnc872c.toml`: its keys, and the function that takes their values. The keys themselves are in
//! [`keys`](super::keys), or beside what they configure.

use super::format::FORMAT;
use super::keys;
use super::motion_keys;
use super::names::Names;
use super::project::Project;
use super::reader::Reader;
use super::restart::RESTART;
use super::row::Row;
use super::taken::{Named, Values};
use crate::dict::Bilingual;

/// A table of the project file.
#[derive(Clone, Copy, Debug)]
pub(super) struct Section {
    /// Its name; empty for what comes before all tables. A table in a table has the names of both, with a point between:
    /// `motion.times`; the outer one is a section of its own, with keys.
    pub name: &'static str,
    /// What is in it.
    pub form: Form,
    /// What it sets.
    pub meaning: Bilingual,
    /// The rule.
    pub rule: &'static str,
    /// The option of the command line that wins over it; the editor's settings have a key of its name then.
    pub option: Option<&'static str>,
    /// For names of the control: one with a value, as TOML; for tables by name, one of the names.
    pub example: &'static str,
}

/// Takes the values of one table; called when the table is there.
pub(super) type TakeValues = fn(&mut Project, &mut Reader<'_>, &Values);
/// Takes one name of a table with its value.
pub(super) type TakeNamed = fn(&mut Project, &Named);
/// Takes the values of the table of one name.
pub(super) type TakeNamedValues = fn(&mut Project, &mut Reader<'_>, u16, &Values);

/// What is in a table.
#[derive(Clone, Copy, Debug)]
pub(super) enum Form {
    /// These keys: `[limits]`.
    Keys(&'static [Row], TakeValues),
    /// A list of tables with these keys: `[[axes]]`.
    List(&'static [Row], TakeValues),
    /// Names of one kind, each with a value that depends on the name: `[parameters]`.
    Map(Names, TakeNamed),
    /// Names of one kind, each a table with these keys: `[corrections.7]`.
    Tables(Names, &'static [Row], TakeNamedValues),
}

impl Form {
    /// The keys of its tables.
    pub(super) const fn rows(self) -> &'static [Row] {
        match self {
            Self::Keys(rows, _) | Self::List(rows, _) | Self::Tables(_, rows, _) => rows,
            Self::Map(..) => &[],
        }
    }
}

const fn section(name: &'static str, form: Form, meaning: (&'static str, &'static str), rule: &'static str) -> Section {
    Section { name, form, meaning: Bilingual { en: meaning.0, cs: meaning.1 }, rule, option: None, example: "" }
}

impl Section {
    const fn with_option(self, option: &'static str) -> Self {
        Self { option: Some(option), ..self }
    }

    const fn with_example(self, example: &'static str) -> Self {
        Self { example, ..self }
    }

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

/// What comes before all tables.
pub(super) const ROOT: &Section =
    &section("", Form::Keys(keys::ROOT, Project::root), ("the control and its modes", "systém a jeho režimy"), "§11");

/// Every table of the project file, in the order in which the reference page shows them.
pub(super) const SECTIONS: &[Section] = &[
    *ROOT,
    section(
        "axes",
        Form::List(keys::AXIS, Project::axis),
        (
            "the axes in the order of the machine; without any, all nine letters X Y Z A B C U V W exist; CNC8x6 and CNC8x9 have at most six, the sixth one of A, B, C",
            "osy v pořadí stroje; není-li uvedena žádná, existuje všech devět písmen X Y Z A B C U V W; CNC8x6 a CNC8x9 mají nejvýše šest os, šestá je A, B nebo C",
        ),
        "ADR-4",
    ),
    section(
        "start",
        Form::Map(Names::Axes, Project::start),
        (
            "programmed positions before the first block, by axis; X is a radius where G74 holds at power-up",
            "programované polohy před prvním blokem, podle os; X je poloměr tam, kde po zapnutí platí G74",
        ),
        "MOT-2",
    )
    .with_example("X = 0.0"),
    section(
        "power-up",
        Form::Map(Names::Groups, Project::power_up),
        (
            "the function of each G and M group that holds at program start and after M02 and M30, by its number",
            "funkce každé skupiny G a M, která platí na začátku programu a po M02 a M30, svým číslem",
        ),
        "GRP-3, MFN-7",
    )
    .with_example("G5 = 54"),
    section(
        "parameters",
        Form::Map(Names::Parameters, Project::parameter),
        ("the machine's parameter table at program start", "tabulka parametrů stroje na začátku programu"),
        "PAR-5",
    )
    .with_example("R10 = 25.5")
    .with_option("--param"),
    section(
        "operations",
        Form::Map(Names::Operations, Project::operation),
        (
            "the operation behind each code `oo` of the control words of G26 to G29",
            "operace za každým kódem „oo“ v řídicích slovech funkcí G26 až G29",
        ),
        "PAR-9",
    )
    .with_example("\"01\" = \"add\""),
    section(
        "cycles",
        Form::Map(Names::Cycles, Project::cycle),
        (
            "the macrocycle that a fixed cycle calls after each motion, by its number",
            "makrocyklus, který pevný cyklus volá po každém pohybu, svým číslem",
        ),
        "GRP-6",
    )
    .with_example("G81 = 8100"),
    section(
        "machine-macrocycles",
        Form::Tables(Names::Macrocycles, keys::MACHINE_MACROCYCLE, Project::machine_macrocycle),
        (
            "macrocycles that only the machine has; a file of that number on the search path wins",
            "makrocykly, které má jen stroj; soubor téhož čísla na cestě hledání má přednost",
        ),
        "FLW-12",
    )
    .with_example("L9001"),
    section(
        "gears",
        Form::List(keys::GEAR, Project::gear),
        ("the speed ranges of the spindle", "rozsahy otáček vřetena"),
        "MFN-9",
    ),
    section(
        "machine-constants",
        Form::Map(Names::Constants, Project::constant),
        (
            "machine constants as the control shows them: eight digits as a text, or a number with three decimals; R56 to R59 give M groups 10 to 13 on CNC8x6 and CNC8x9, four functions of two digits each; others give what `[motion]` says",
            "strojní konstanty, jak je ukazuje systém: osm číslic jako text, nebo číslo se třemi desetinnými místy; R56 až R59 určují u CNC8x6 a CNC8x9 M skupiny 10 až 13, každá čtyři funkce po dvou číslicích; jiné udávají totéž co `[motion]`",
        ),
        "MFN-5",
    )
    .with_example("R340 = 1.0"),
    section(
        "motion",
        Form::Keys(motion_keys::MOTION, Project::motion),
        (
            "what motion is computed with; on CNC8x6 and CNC8x9 the machine constants give the same values, each once",
            "s čím se počítá pohyb; u CNC8x6 a CNC8x9 udávají tytéž hodnoty strojní konstanty, každou jen jednou",
        ),
        "CNT, VEL",
    ),
    section(
        "motion.times",
        Form::Map(Names::Timed, Project::motion_time),
        (
            "seconds that functions take; a block takes the longest of its own",
            "sekundy, které trvají funkce; blok trvá podle té nejdelší z nich",
        ),
        "TIM-1",
    )
    .with_example("M06 = 6.5"),
    section(
        "motion.sets",
        Form::Keys(&[], |_, _, _| {}),
        (
            "the dynamic sets, which count with the parabolic profile only; a set or value that is missing, or 0, is that of set 1, then that of `[motion]`",
            "sady pro dynamické řízení, které platí jen při parabolickém průběhu; sada nebo hodnota, která chybí nebo je 0, je z 1. sady, pak z [motion]",
        ),
        "VEL-14",
    ),
    section(
        "motion.sets.1",
        Form::Keys(motion_keys::SET, Project::motion_set),
        (
            "the set of G23 I1, which holds from the start (R406 to R411)",
            "sada pro G23 I1, platná od začátku (R406 až R411)",
        ),
        "VEL-14",
    ),
    section(
        "motion.sets.2",
        Form::Keys(motion_keys::SET, Project::motion_set),
        ("the set of G23 I2 (R412 to R417)", "sada pro G23 I2 (R412 až R417)"),
        "VEL-14",
    ),
    section(
        "motion.sets.3",
        Form::Keys(motion_keys::SET, Project::motion_set),
        ("the set of G23 I3 (R418 to R423)", "sada pro G23 I3 (R418 až R423)"),
        "VEL-14",
    ),
    section(
        "motion.sets.4",
        Form::Keys(motion_keys::SET, Project::motion_set),
        ("the set of G23 I4 (R424 to R429)", "sada pro G23 I4 (R424 až R429)"),
        "VEL-14",
    ),
    section(
        "motion.sets.rapid",
        Form::Keys(motion_keys::RAPID_SET, Project::motion_set),
        ("the set of G00 (R430 to R432)", "sada pro G00 (R430 až R432)"),
        "VEL-8",
    ),
    section(
        "corrections",
        Form::Tables(Names::Corrections, keys::CORRECTION, Project::correction),
        (
            "radius corrections by the number of D, as they are in the control's table; for the picture of the corrected path",
            "poloměrové korekce podle čísla D, jak jsou v tabulce systému; pro obraz korigované dráhy",
        ),
        "EQU-1",
    )
    .with_example("7"),
    section(
        "limits",
        Form::Keys(keys::LIMITS, Project::limits),
        ("where the compiler draws a line", "meze překladače"),
        "§11",
    ),
    section(
        "format",
        Form::Keys(FORMAT, Project::format),
        ("how `format` lays out programs", "jak `format` upravuje zápis programů"),
        "FMT-5",
    ),
    section(
        "restart",
        Form::Keys(RESTART, Project::restart),
        ("how `restart` comes to a place of a program", "jak `restart` najíždí na místo v programu"),
        "RST-2",
    ),
    section(
        "lints",
        Form::Map(Names::Lints, Project::lint),
        ("levels of warnings, and of E0109, by name or code", "úrovně varování a hlášení E0109, podle jména nebo kódu"),
        "§11",
    )
    .with_example("empty-block = \"allow\"")
    .with_option("-D, -W, -A"),
];

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
