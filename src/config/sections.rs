//! Every table of `cnc872c.toml` and what is in it; the keys themselves are in [`keys`](super::keys).

use super::keys::Rows;
use super::names::Names;
use crate::dict::Bilingual;

/// A table of the project file.
#[derive(Clone, Copy, Debug)]
pub(super) struct Section {
    /// Its name; empty for what stands before all tables.
    pub name: &'static str,
    /// What is in it.
    pub form: Form,
    /// What it sets.
    pub meaning: Bilingual,
    /// The rule.
    pub rule: &'static str,
}

/// What is in a table.
#[derive(Clone, Copy, Debug)]
pub(super) enum Form {
    /// These keys.
    Keys(Rows),
    /// A list of tables with these keys.
    List(Rows),
    /// Names of one kind, each with a value that depends on the name.
    Map(Names),
}

const fn section(name: &'static str, form: Form, meaning: (&'static str, &'static str), rule: &'static str) -> Section {
    Section { name, form, meaning: Bilingual { en: meaning.0, cs: meaning.1 }, rule }
}

/// Every table of the project file, in the order of the specification.
pub(super) const SECTIONS: &[Section] = &[
    section("", Form::Keys(Rows::Root), ("the control and its modes", "systém a jeho režimy"), "§11"),
    section(
        "axes",
        Form::List(Rows::Axis),
        (
            "the axes in the order of the machine; without any, all nine letters X Y Z A B C U V W exist; CNC8x6 and CNC8x9 have at most six",
            "osy v pořadí stroje; není-li uvedena žádná, existuje všech devět písmen X Y Z A B C U V W; CNC8x6 a CNC8x9 mají nejvýše šest os",
        ),
        "ADR-4",
    ),
    section(
        "power-up",
        Form::Map(Names::Groups),
        (
            "the function of each G group that holds at program start and after M02 and M30, by its number",
            "funkce každé skupiny G, která platí na začátku programu a po M02 a M30, svým číslem",
        ),
        "GRP-3",
    ),
    section(
        "parameters",
        Form::Map(Names::Parameters),
        ("the machine's parameter table at program start", "tabulka parametrů stroje na začátku programu"),
        "PAR-5",
    ),
    section(
        "operations",
        Form::Map(Names::Operations),
        (
            "the operation behind each code `oo` of the control words of G26 to G29",
            "operace za každým kódem „oo“ v řídicích slovech funkcí G26 až G29",
        ),
        "PAR-9",
    ),
    section(
        "cycles",
        Form::Map(Names::Cycles),
        (
            "the macrocycle that a fixed cycle calls after each motion, by its number",
            "makrocyklus, který pevný cyklus volá po každém pohybu, svým číslem",
        ),
        "GRP-6",
    ),
    section("gears", Form::List(Rows::Gear), ("the speed ranges of the spindle", "rozsahy otáček vřetena"), "MFN-9"),
    section(
        "machine-constants",
        Form::Map(Names::Constants),
        (
            "machine constants as the control shows them; R56 to R59 give M groups 10 to 13 on CNC8x6 and CNC8x9, four functions of two digits each",
            "strojní konstanty, jak je ukazuje systém; R56 až R59 určují u CNC8x6 a CNC8x9 M skupiny 10 až 13, každá čtyři funkce po dvou číslicích",
        ),
        "MFN-5",
    ),
    section("limits", Form::Keys(Rows::Limits), ("where the compiler draws a line", "meze překladače"), "§11"),
    section(
        "lints",
        Form::Map(Names::Lints),
        ("levels of warnings, and of E0109, by name or code", "úrovně varování a hlášení E0109, podle jména nebo kódu"),
        "§11",
    ),
];
