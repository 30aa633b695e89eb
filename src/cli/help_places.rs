//! The words of `--help` of the commands that ask about a place of a program.

use super::help_texts::{ArgumentText, CommandText, Heading, about, arg};
use crate::dict::Bilingual;
use Heading::{Arguments, Options};

/// The commands.
pub(super) const COMMANDS: &[CommandText] = &[
    about!(
        "state",
        "Tells what holds at a place of a program: position, functions, values, parameters, calls, time left",
        "Řekne, co v daném místě programu platí: poloha, funkce, hodnoty, parametry, volání, zbývající čas"
    ),
    about!(
        "restart",
        "Writes a program that starts at a place of another one, with everything that holds there",
        "Zapíše program, který začíná v daném místě jiného, se vším, co tam platí"
    ),
    about!(
        "compare",
        "Tells what two programs do differently; how they are written does not matter",
        "Řekne, co dva programy dělají jinak; na způsobu zápisu nezáleží"
    ),
];

/// The arguments.
pub(super) const ARGUMENTS: &[ArgumentText] = &[
    arg("", "n", Options, "The block with this number", "Blok s tímto číslem"),
    arg("", "line", Options, "The block on this line; of several the first", "Blok na tomto řádku; z několika první"),
    arg("", "seq", Options, "The executed block with this seq, from 0", "Provedený blok s tímto seq, od 0"),
    arg(
        "",
        "time",
        Options,
        "The block being executed this long after program start",
        "Blok, který se provádí po této době od startu programu",
    ),
    arg("", "at_tool", Options, "The M06 of this tool", "M06 tohoto nástroje"),
    arg(
        "",
        "file_of",
        Options,
        "The macrocycle that N or the line is of; else the program",
        "Makrocyklus, ke kterému N nebo řádek patří; jinak program",
    ),
    arg(
        "",
        "pass",
        Options,
        "Which execution of the block in the whole run, from 1",
        "Kolikáté provedení bloku v celém běhu, od 1",
    ),
    arg("state", "after", Options, "The state behind the block, not before it", "Stav za blokem, ne před ním"),
    arg("state", "format", Options, "The form of the answer", "Tvar odpovědi"),
    arg("state", "all", Options, "Show all findings", "Vypsat všechna hlášení"),
    arg("restart", "after", Options, "Start behind the block, not with it", "Začít za blokem, ne tímto blokem"),
    arg(
        "restart",
        "list",
        Options,
        "List the tool changes and rapids at which the program can start",
        "Vypsat výměny nástrojů a rychloposuvy, kterými lze začít",
    ),
    arg(
        "restart",
        "safe",
        Options,
        "Where the tool moves across, on its axis, as the program writes it",
        "Výška přejezdu v ose nástroje, jak ji zapisuje program",
    ),
    arg(
        "restart",
        "clearance",
        Options,
        "How far above the place rapid ends",
        "Jak vysoko nad místem končí rychloposuv",
    ),
    arg(
        "restart",
        "all_m",
        Options,
        "Restore M functions of groups 10 to 14 too, in the order of their last writing",
        "Obnovit i M funkce skupin 10 až 14, v pořadí jejich posledního zápisu",
    ),
    arg(
        "restart",
        "output",
        Options,
        "Write the program to FILE instead of standard output",
        "Zapsat program do SOUBORU místo na standardní výstup",
    ),
    arg("restart", "all", Options, "Show all findings", "Vypsat všechna hlášení"),
    arg("compare", "old", Arguments, "The first program, or folder", "První program nebo složka"),
    arg("compare", "new", Arguments, "The second program, or folder", "Druhý program nebo složka"),
    arg(
        "compare",
        "tolerance",
        Options,
        "Positions that differ by so much at most are the same, mm and degrees",
        "Polohy, které se liší nejvýše o tolik, jsou stejné, mm a stupně",
    ),
    arg(
        "compare",
        "feed_tolerance",
        Options,
        "F and S that differ by so many per cent of the larger one at most are the same",
        "F a S, které se liší nejvýše o tolik procent z většího z nich, jsou stejné",
    ),
    arg("compare", "parameters", Options, "Compare parameters and jumps too", "Porovnat i parametry a skoky"),
    arg(
        "compare",
        "partial",
        Options,
        "Compare programs with errors as far as they can be executed",
        "Porovnat i programy s chybami, a to tak daleko, jak je lze provést",
    ),
    arg("compare", "format", Options, "The form of the answer", "Tvar odpovědi"),
    arg(
        "compare",
        "output",
        Options,
        "Also write a page (.html) to FILE: both paths in one picture, and the changes",
        "Navíc zapsat do SOUBORU stránku (.html): obě dráhy v jednom obrázku a seznam změn",
    ),
    arg(
        "compare",
        "all",
        Options,
        "List all changes, not the first 40 lines",
        "Vypsat všechny změny, ne jen prvních 40 řádků",
    ),
];

/// The names of values, in both languages.
pub(super) const VALUES: &[Bilingual] = &[
    Bilingual { en: "OLD", cs: "STARÝ" },
    Bilingual { en: "NEW", cs: "NOVÝ" },
    Bilingual { en: "LINE", cs: "ŘÁDEK" },
    Bilingual { en: "TIME", cs: "ČAS" },
    Bilingual { en: "PASS", cs: "PRŮCHOD" },
];
