//! The words of `--help` of the commands that ask about a place of a program.

use super::help_texts::{ArgumentText, CommandText, Heading, about, arg};
use crate::dict::Bilingual;
use Heading::{Arguments, Options};

/// The commands.
pub(super) const COMMANDS: &[CommandText] = &[
    about(
        "state",
        "Tells what holds at a place of a program: position, functions, values, parameters, calls, time left",
        "Řekne, co v daném místě programu platí: poloha, funkce, hodnoty, parametry, volání, zbývající čas",
        Bilingual {
            en: "\
Examples:
  cnc872c state flange.nc --n 120                before N120; executed several times, its passes are listed
  cnc872c state flange.nc --n 120 --pass 3       before its third execution
  cnc872c state flange.nc --n 30 --file L9001    before N30 of macrocycle L9001
  cnc872c state flange.nc --line 45 --after      behind the block on line 45
  cnc872c state flange.nc --time 0:12:30         before the block that is under way then
  cnc872c state flange.nc --at-tool T5           before the M06 of T5
  cnc872c state flange.nc --n 120 --format json | jq .position

Times are those of `motion`. Findings go to standard error. Exit status: 0 found, 1 the program has errors
before the place, 2 there is no such place or several, or it could not run.",
            cs: "\
Příklady:
  cnc872c state priruba.nc --n 120               před N120; provádí-li se vícekrát, vypíše průchody
  cnc872c state priruba.nc --n 120 --pass 3      před jeho třetím provedením
  cnc872c state priruba.nc --n 30 --file L9001   před N30 makrocyklu L9001
  cnc872c state priruba.nc --line 45 --after     za blokem na řádku 45
  cnc872c state priruba.nc --time 0:12:30        před blokem, který se v tu dobu provádí
  cnc872c state priruba.nc --at-tool T5          před M06 nástroje T5
  cnc872c state priruba.nc --n 120 --format json | jq .position

Časy jsou z „motion“. Hlášení jdou na standardní chybový výstup. Návratový kód: 0 nalezeno, 1 program má
před místem chyby, 2 takové místo není nebo jich je více, nebo příkaz nešlo provést.",
        },
    ),
    about(
        "restart",
        "Writes a program that starts at a place of another one, with everything that holds there",
        "Zapíše program, který začíná v daném místě jiného, se vším, co tam platí",
        Bilingual {
            en: "\
Examples:
  cnc872c restart flange.nc --n 4310 --pass 3 -o rest.nc   from the third execution of N4310
  cnc872c restart flange.nc --at-tool T5 --safe 100        from the M06 of T5; the tool moves across at Z100
  cnc872c restart flange.nc --time 0:12:30 --clearance 5   feed begins 5 mm above the place
  cnc872c restart flange.nc --list                         where it can start: tool changes and rapids

The tool rises, moves across, comes down in rapid to --clearance and goes to the place at F. Without --safe
it rises to where the program itself stood with this tool. Read the comments of the new program before START.
Exit status: 0 written, 1 no start is possible there or the program has errors, 2 there is no such place or
several, --safe is missing, or it could not run.",
            cs: "\
Příklady:
  cnc872c restart priruba.nc --n 4310 --pass 3 -o zbytek.nc   od třetího provedení N4310
  cnc872c restart priruba.nc --at-tool T5 --safe 100          od M06 nástroje T5; přejezd ve výšce Z100
  cnc872c restart priruba.nc --time 0:12:30 --clearance 5     posuv začne 5 mm nad místem
  cnc872c restart priruba.nc --list                           kde lze začít: výměny nástrojů a rychloposuvy

Nástroj vyjede nahoru, přejede, rychloposuvem sjede na --clearance a na místo dojede s F. Bez --safe vyjede
tam, kde s tímto nástrojem stál sám program. Před stiskem START přečíst komentáře nového programu.
Návratový kód: 0 zapsáno, 1 v daném místě začít nelze nebo program má chyby, 2 takové místo není nebo jich
je více, chybí --safe, nebo příkaz nešlo provést.",
        },
    ),
    about(
        "compare",
        "Tells what two programs do differently; how they are written does not matter",
        "Řekne, co dva programy dělají jinak; na způsobu zápisu nezáleží",
        Bilingual {
            en: "\
Examples:
  cnc872c compare old.nc new.nc                     what is cut differently
  cnc872c compare archive/ new/                     two folders: a line for each program
  cnc872c compare old.nc new.nc --tolerance 0.01    positions up to 0.01 mm apart are the same
  cnc872c compare old.nc new.nc -o changes.html     both paths in one picture
  cnc872c compare old.nc new.nc --format json | jq '.changes[].kind'

Exit status: 0 the same, 1 different, 2 it could not run, or a program has errors.",
            cs: "\
Příklady:
  cnc872c compare stary.nc novy.nc                    co se obrobí jinak
  cnc872c compare archiv/ nove/                       dvě složky: řádek na program
  cnc872c compare stary.nc novy.nc --tolerance 0.01   polohy do 0.01 mm od sebe jsou stejné
  cnc872c compare stary.nc novy.nc -o zmeny.html      obě dráhy v jednom obrázku
  cnc872c compare stary.nc novy.nc --format json | jq '.changes[].kind'

Návratový kód: 0 stejné, 1 různé, 2 příkaz nešlo provést nebo program má chyby.",
        },
    ),
];

/// The arguments.
pub(super) const ARGUMENTS: &[ArgumentText] = &[
    arg(
        "state",
        "file",
        Arguments,
        "The program, or - for standard input. A macrocycle is executed with the program that calls it",
        "Program, nebo - pro standardní vstup. Makrocyklus se provádí s programem, který ho volá",
    ),
    arg("", "n", Options, "The block with this number", "Blok s tímto číslem"),
    arg("", "line", Options, "The block on this line; of several the first", "Blok na tomto řádku; z několika první"),
    arg("", "seq", Options, "The executed block with this seq, from 0", "Provedený blok s tímto seq, od 0"),
    arg(
        "",
        "time",
        Options,
        "The block that is under way so long after program start",
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
    arg(
        "restart",
        "file",
        Arguments,
        "The program, or - for standard input. A macrocycle is executed with the program that calls it",
        "Program, nebo - pro standardní vstup. Makrocyklus se provádí s programem, který ho volá",
    ),
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
        "F and S that differ by so many per cent at most are the same",
        "F a S, které se liší nejvýše o tolik procent, jsou stejné",
    ),
    arg("compare", "parameters", Options, "Compare parameters and jumps too", "Porovnat i parametry a skoky"),
    arg(
        "compare",
        "partial",
        Options,
        "Compare programs with errors as far as they can be executed",
        "Programy s chybami porovnat, pokud je lze provést",
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
