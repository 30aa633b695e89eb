//! The words of `--help` of `format` and `renumber`, in both languages.

use super::help_texts::Heading::{Arguments, Options};
use super::help_texts::{ArgumentText, CommandText, about, arg};
use crate::dict::Bilingual;

/// The commands.
pub(super) const COMMANDS: &[CommandText] = &[
    about(
        "format",
        "Gives programs and macrocycles one layout, and changes nothing that the control executes",
        "Upraví zápis programů a makrocyklů; co systém provede, se nemění",
        Bilingual {
            en: "\
Examples:
  cnc872c format flange.nc             one program
  cnc872c format .                     all programs in this folder and the folders in it
  cnc872c format --check .             changes nothing, names the files that would change
  cnc872c format --diff flange.nc      shows the changes
  cnc872c format - < a.nc > b.nc       from standard input to standard output

[format] of the project file says how G and M codes and numbers are written. Lines that cannot be
read stay as they are. Exit status: 0 done, also when programs have errors; 1 --check or --diff
found something to change; 2 a file cannot be read or written, or no program is found.",
            cs: "\
Příklady:
  cnc872c format priruba.nc            jeden program
  cnc872c format .                     všechny programy v této složce a ve složkách v ní
  cnc872c format --check .             nic nezmění, vypíše soubory, které by se změnily
  cnc872c format --diff priruba.nc     ukáže změny
  cnc872c format - < a.nc > b.nc       ze standardního vstupu na standardní výstup

Jak se píšou kódy G a M a čísla, určuje [format] v projektovém souboru. Řádky, které nelze přečíst,
zůstanou, jak jsou. Návratový kód: 0 hotovo, i když programy mají chyby; 1 --check nebo --diff
našly, co změnit; 2 soubor nelze přečíst či zapsat, nebo se žádný program nenašel.",
        },
    ),
    about(
        "renumber",
        "Gives blocks new numbers; jumps follow",
        "Přečísluje bloky; skoky se upraví",
        Bilingual {
            en: "\
Examples:
  cnc872c renumber flange.nc                      N10, N20, … through the whole file
  cnc872c renumber --step 5 --start 100 flange.nc
  cnc872c renumber --unit L100 flange.nc          only the subprogram L100
  cnc872c renumber --from N200 --to N400 --start 200 --step 1 flange.nc
  cnc872c renumber --diff flange.nc               shows the changes

A file stays as it is where a jump goes by a parameter, or a line cannot be read. Exit status:
0 done; 1 a file cannot be renumbered, or --check or --diff found something to change; 2 a file
cannot be read or written, or no program is found.",
            cs: "\
Příklady:
  cnc872c renumber priruba.nc                     N10, N20, … v celém souboru
  cnc872c renumber --step 5 --start 100 priruba.nc
  cnc872c renumber --unit L100 priruba.nc         jen podprogram L100
  cnc872c renumber --from N200 --to N400 --start 200 --step 1 priruba.nc
  cnc872c renumber --diff priruba.nc              ukáže změny

Soubor zůstane, jak je, když cíl skoku závisí na parametru nebo když některý řádek nelze přečíst.
Návratový kód: 0 hotovo; 1 soubor nelze přečíslovat, nebo --check či --diff našly, co změnit;
2 soubor nelze přečíst či zapsat, nebo se žádný program nenašel.",
        },
    ),
];

/// Their arguments and options.
pub(super) const ARGUMENTS: &[ArgumentText] = &[
    arg(
        "format",
        "paths",
        Arguments,
        "Programs, macrocycles, folders to search for them, or - for standard input, which goes to standard output",
        "Programy, makrocykly, složky k prohledání, nebo - pro standardní vstup, z něhož se píše na standardní výstup",
    ),
    arg(
        "format",
        "check",
        Options,
        "Change nothing, and name the files that would change. Exit with status 1 when there are some",
        "Nic neměnit a vypsat soubory, které by se změnily. Jsou-li nějaké, skončit kódem 1",
    ),
    arg(
        "format",
        "diff",
        Options,
        "Change nothing, and show the changes as a unified diff. Exit with status 1 when there is something",
        "Nic neměnit a ukázat změny (unified diff). Je-li co měnit, skončit kódem 1",
    ),
    arg(
        "renumber",
        "paths",
        Arguments,
        "Programs, macrocycles, folders to search for them, or - for standard input, which goes to standard output",
        "Programy, makrocykly, složky k prohledání, nebo - pro standardní vstup, z něhož se píše na standardní výstup",
    ),
    arg(
        "renumber",
        "check",
        Options,
        "Change nothing, and name the files that would change. Exit with status 1 when there are some",
        "Nic neměnit a vypsat soubory, které by se změnily. Jsou-li nějaké, skončit kódem 1",
    ),
    arg(
        "renumber",
        "diff",
        Options,
        "Change nothing, and show the changes as a unified diff. Exit with status 1 when there is something",
        "Nic neměnit a ukázat změny (unified diff). Je-li co měnit, skončit kódem 1",
    ),
    arg("renumber", "step", Options, "From one number to the next", "Krok mezi čísly"),
    arg("renumber", "start", Options, "The first number", "První číslo"),
    arg("renumber", "unit", Options, "Only this subprogram", "Jen tento podprogram"),
    arg("renumber", "from", Options, "Only from this block on", "Jen od tohoto bloku"),
    arg("renumber", "to", Options, "Only up to this block, it included", "Jen po tento blok včetně"),
    arg(
        "renumber",
        "width",
        Options,
        "Digits of N, filled up with zeros; 0 for none",
        "Počet číslic za N, doplněný nulami; 0 bez nul",
    ),
];
