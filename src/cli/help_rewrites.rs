//! The words of `--help` of `format` and `renumber`, in both languages.

use super::help_texts::Heading::{Arguments, Options};
use super::help_texts::{ArgumentText, CommandText, about, arg};
use crate::dict::Bilingual;

/// The commands.
pub(super) const COMMANDS: &[CommandText] = &[
    about!(
        "format",
        "Gives programs and macrocycles one layout, and changes nothing that the control executes",
        "Upraví zápis programů a makrocyklů; co systém provede, se nemění"
    ),
    about!("renumber", "Gives blocks new numbers; jumps follow", "Přečísluje bloky; skoky se upraví"),
];

/// Their arguments and options.
pub(super) const ARGUMENTS: &[ArgumentText] = &[
    arg(
        "",
        "paths",
        Arguments,
        "Programs, macrocycles, folders to search for them, or - for standard input, which goes to standard output",
        "Programy, makrocykly, složky k prohledání, nebo - pro standardní vstup, z něhož se píše na standardní výstup",
    ),
    arg(
        "",
        "check",
        Options,
        "Change nothing, and name the files that would change. Exit with status 1 when there are some",
        "Nic neměnit a vypsat soubory, které by se změnily. Jsou-li nějaké, skončit kódem 1",
    ),
    arg(
        "",
        "diff",
        Options,
        "Change nothing, and show the changes as a unified diff. Exit with status 1 when there is something",
        "Nic neměnit a ukázat změny (unified diff). Je-li co měnit, skončit kódem 1",
    ),
    arg("renumber", "step", Options, "From one number to the next", "Krok mezi čísly"),
    arg("renumber", "start", Options, "The first number", "První číslo"),
    arg("renumber", "unit", Options, "Only this subprogram", "Jen tento podprogram"),
    arg("renumber", "from", Options, "Only from this block on", "Jen od tohoto bloku"),
    arg("renumber", "to", Options, "Only up to and including this block", "Jen po tento blok včetně"),
    arg(
        "renumber",
        "width",
        Options,
        "Digits of N, filled up with zeros; 0 for none",
        "Počet číslic za N, doplněný nulami; 0 bez nul",
    ),
];
