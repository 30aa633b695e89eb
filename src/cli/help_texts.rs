//! The words of `--help`, in both languages: the one table of them.

use crate::dict::Bilingual;

/// Under which heading the help shows an argument.
#[derive(Clone, Copy, Debug, Eq, PartialEq)]
pub(super) enum Heading {
    Arguments,
    Options,
    Machine,
    Levels,
    Everywhere,
}

impl Heading {
    /// The heading.
    pub const fn text(self) -> Bilingual {
        match self {
            Self::Arguments => Bilingual { en: "Arguments", cs: "Argumenty" },
            Self::Options => Bilingual { en: "Options", cs: "Volby" },
            Self::Machine => Bilingual { en: "Machine and execution", cs: "Stroj a provádění" },
            Self::Levels => Bilingual { en: "Levels of findings", cs: "Úrovně hlášení" },
            Self::Everywhere => Bilingual { en: "Options of every command", cs: "Volby všech příkazů" },
        }
    }
}

/// The help of a command.
pub(super) struct CommandText {
    pub name: &'static str,
    pub about: Bilingual,
    /// What stands below the options.
    pub examples: Bilingual,
}

pub(super) const fn about(name: &'static str, en: &'static str, cs: &'static str, examples: Bilingual) -> CommandText {
    CommandText { name, about: Bilingual { en, cs }, examples }
}

/// The program itself, and every command.
pub(super) const COMMANDS: &[CommandText] = &[
    about(
        "cnc872c",
        "Checks and compiles part programs of the CNC8x6, CNC8x9 and CNC872 controls",
        "Kontroluje a překládá partprogramy řídicích systémů CNC8x6, CNC8x9 a CNC872",
        Bilingual {
            en: "\
Examples:
  cnc872c check flange.nc                    every mistake, at its place
  cnc872c compile flange.nc -o flange.jsonl  the blocks as the control executes them
  cnc872c view flange.nc --open              its path, in the browser
  cnc872c motion flange.nc                   how long it takes, and where it is slow
  cnc872c explain E0306                      what a finding means
  cnc872c explain G73                        what a function does

Exit status: 0 no errors, 1 the programs have errors, 2 it could not run.",
            cs: "\
Příklady:
  cnc872c check priruba.nc                     všechny chyby, každá na svém místě
  cnc872c compile priruba.nc -o priruba.jsonl  bloky tak, jak je systém provede
  cnc872c view priruba.nc --open               dráha v prohlížeči
  cnc872c motion priruba.nc                    jak dlouho trvá a kde zpomaluje
  cnc872c explain E0306                        co hlášení znamená
  cnc872c explain G73                          co funkce dělá

Návratový kód: 0 bez chyb, 1 programy mají chyby, 2 nešlo zkontrolovat.",
        },
    ),
    about(
        "check",
        "Checks programs and macrocycles",
        "Zkontroluje programy a makrocykly",
        Bilingual {
            en: "\
Examples:
  cnc872c check flange.nc               one program
  cnc872c check .                       all programs in this folder and the folders in it
  cnc872c check --fix flange.nc         also applies the fixes that are certain
  cnc872c check --diff .                shows what --fix would change
  cnc872c check -L macros flange.nc     macrocycles L… are in the folder macros
  cnc872c check --param R10=25.5 a.nc   R10 comes from the machine's table
  cnc872c check -A empty-block -D W0414 a.nc
  cnc872c check --format json . > findings.json
  postprocessor | cnc872c check -       from standard input

Findings go to standard output. Exit status: 0 no errors, 1 errors found (or warnings, with
--deny-warnings), 2 a file cannot be read, no program is found, or the configuration or the command
line is wrong.",
            cs: "\
Příklady:
  cnc872c check priruba.nc              jeden program
  cnc872c check .                       všechny programy v této složce a ve složkách v ní
  cnc872c check --fix priruba.nc        a také opraví, co má jistou opravu
  cnc872c check --diff .                ukáže, co by --fix změnilo
  cnc872c check -L makra priruba.nc     makrocykly L… jsou ve složce makra
  cnc872c check --param R10=25.5 a.nc   R10 má hodnotu z tabulky stroje
  cnc872c check -A empty-block -D W0414 a.nc
  cnc872c check --format json . > hlaseni.json
  postprocesor | cnc872c check -        ze standardního vstupu

Hlášení jdou na standardní výstup. Návratový kód: 0 bez chyb, 1 nalezeny chyby (s --deny-warnings
i varování), 2 soubor nelze přečíst, žádný program se nenašel, nebo je chyba v konfiguraci či na
příkazovém řádku.",
        },
    ),
    about(
        "compile",
        "Writes the block stream of a program: each executed block, in order, as a line of JSON",
        "Zapíše proud bloků programu: každý provedený blok v pořadí jako řádek JSON",
        Bilingual {
            en: "\
Examples:
  cnc872c compile flange.nc                          to standard output
  cnc872c compile flange.nc -o flange.jsonl          to a file: complete, or not at all
  cnc872c compile flange.nc --from 1000 --limit 20   blocks 1000 to 1019 only
  cnc872c compile flange.nc --param R10=25.5         R10 comes from the machine's table
  cnc872c compile flange.nc | jq 'select(.kind == \"block\") | .position'

Findings go to standard error. A stream is complete when its last record is `end`. Exit status:
0 complete, 1 the program has errors, 2 it could not run; then FILE stays as it was.",
            cs: "\
Příklady:
  cnc872c compile priruba.nc                          na standardní výstup
  cnc872c compile priruba.nc -o priruba.jsonl         do souboru: celý, nebo vůbec
  cnc872c compile priruba.nc --from 1000 --limit 20   jen bloky 1000 až 1019
  cnc872c compile priruba.nc --param R10=25.5         R10 má hodnotu z tabulky stroje
  cnc872c compile priruba.nc | jq 'select(.kind == \"block\") | .position'

Hlášení jdou na standardní chybový výstup. Proud je úplný, když končí záznamem „end“. Návratový
kód: 0 úplný, 1 program má chyby, 2 nešlo zkontrolovat; SOUBOR pak zůstane, jak byl.",
        },
    ),
    about(
        "view",
        "Draws the path of a program: a page with the path in three dimensions beside the text, or a picture",
        "Nakreslí dráhu programu: stránku s dráhou v prostoru vedle textu, nebo obrázek",
        Bilingual {
            en: "\
Examples:
  cnc872c view flange.nc                 writes flange.nc.html, one file that opens in any browser
  cnc872c view flange.nc --open          and opens it
  cnc872c view flange.nc -o flange.svg   a still picture, with axes, scale and numbers
  cnc872c view flange.nc -o flange.png --plane iso
  cnc872c view flange.nc --blocks 500    the first 500 executed blocks only

The page shows the path, the text, what holds at each block, velocities and times; nothing is fetched.
A program with errors is drawn as far as it can be executed. Exit status: 0 no errors, 1 the program has
errors, 2 nothing could be drawn.",
            cs: "\
Příklady:
  cnc872c view priruba.nc                  zapíše priruba.nc.html, jediný soubor pro kterýkoli prohlížeč
  cnc872c view priruba.nc --open           a otevře jej
  cnc872c view priruba.nc -o priruba.svg   obrázek s osami, měřítkem a čísly
  cnc872c view priruba.nc -o priruba.png --plane iso
  cnc872c view priruba.nc --blocks 500     jen prvních 500 provedených bloků

Stránka ukazuje dráhu, text, stav v každém bloku, rychlosti a časy; nic odnikud nestahuje. Program
s chybami je nakreslen, kam až jde provést. Návratový kód: 0 bez chyb, 1 program má chyby, 2 nebylo
možné nic nakreslit.",
        },
    ),
    about(
        "motion",
        "Estimates how the machine moves through a program: its time, where it slows down, and why",
        "Odhadne, jak stroj programem projede: jeho čas, kde zpomalí a proč",
        Bilingual {
            en: "\
Examples:
  cnc872c motion flange.nc                            time, joints, and the slowest of them
  cnc872c motion flange.nc --set accuracy-um=4        with another value, and what it changes
  cnc872c motion flange.nc --set R384=00200008        the same by a machine constant
  cnc872c motion flange.nc --format csv > flange.csv  a row a block, for a table
  cnc872c motion flange.nc --format json | jq 'select(.joint.dot == \"red\")'

The machine is that of [motion] in cnc872c.toml, else one that is assumed: an estimate says what it
rests on. Findings go to standard error. Exit status: 0 complete, 1 the program has errors, 2 it could
not run; then FILE stays as it was.",
            cs: "\
Příklady:
  cnc872c motion priruba.nc                             čas, napojení bloků a nejpomalejší z nich
  cnc872c motion priruba.nc --set accuracy-um=4         s jinou hodnotou, a co se tím změní
  cnc872c motion priruba.nc --set R384=00200008         totéž strojní konstantou
  cnc872c motion priruba.nc --format csv > priruba.csv  řádek na blok, do tabulky
  cnc872c motion priruba.nc --format json | jq 'select(.joint.dot == \"red\")'

Stroj je ten z [motion] v cnc872c.toml, jinak předpokládaný: odhad uvádí, z čeho vychází. Hlášení jdou
na standardní chybový výstup. Návratový kód: 0 úplné, 1 program má chyby, 2 příkaz nešlo provést;
SOUBOR pak zůstane, jak byl.",
        },
    ),
    about(
        "plc",
        "Shows what the PLC program reads of a program: command blocks, change bits, requests to move",
        "Ukáže, co z programu čte PLC program: povelové bloky, změnové bity, požadavky na pohyb",
        Bilingual {
            en: "\
Examples:
  cnc872c plc flange.nc                                 what changes, block by block
  cnc872c plc flange.nc --signals 'ZMM*,PB06,BLK.M[10]' these signals only
  cnc872c plc flange.nc --format vcd -o flange.vcd      waveforms for GTKWave or Surfer
  cnc872c plc flange.nc --find 'M03PI & !M08PI & PO_OSZPI'
  cnc872c plc --list                                    all signals of the control
  cnc872c explain ZMM10PI                               one of them

In conditions `!` binds closest, then == != < <= > >=, then &, then |; rising(…) and falling(…) look
at the step before; numbers are decimal or, as 19h, hexadecimal. Findings go to standard error.
Exit status: 0 complete, 1 the program has errors, 2 it could not run; then FILE stays as it was.
With --find: 0 found, 1 not found, 2 the condition or the program has errors, or it could not run.",
            cs: "\
Příklady:
  cnc872c plc priruba.nc                                 co se mění, blok po bloku
  cnc872c plc priruba.nc --signals 'ZMM*,PB06,BLK.M[10]' jen tyto signály
  cnc872c plc priruba.nc --format vcd -o priruba.vcd     průběhy pro GTKWave nebo Surfer
  cnc872c plc priruba.nc --find 'M03PI & !M08PI & PO_OSZPI'
  cnc872c plc --list                                     všechny signály systému
  cnc872c explain ZMM10PI                                jeden z nich

V podmínkách váže nejtěsněji „!“, pak == != < <= > >=, pak &, pak |; rising(…) a falling(…) hledí na
předchozí krok; čísla jsou desítková, nebo jako 19h šestnáctková. Hlášení jdou na standardní chybový
výstup. Návratový kód: 0 úplné, 1 program má chyby, 2 příkaz nešlo provést; SOUBOR pak zůstane, jak
byl. S --find: 0 nalezeno, 1 nenalezeno, 2 chyba v podmínce nebo v programu, nebo příkaz nešlo provést.",
        },
    ),
    about(
        "report",
        "Writes the set-up sheet of a program: size of the work, tools, functions, parameters, time",
        "Sestaví seřizovací list programu: rozměry, nástroje, funkce, parametry, čas",
        Bilingual {
            en: "\
Examples:
  cnc872c report flange.nc                                     to read here
  cnc872c report flange.nc --format html -o flange-sheet.html  a page to print
  cnc872c report flange.nc --format markdown                   for a wiki
  cnc872c report flange.nc --format json | jq '.tools[].t'

The time is that of `motion`. Findings go to standard error. Exit status: 0 complete, 1 the program has
errors, 2 it could not run; then FILE stays as it was.",
            cs: "\
Příklady:
  cnc872c report priruba.nc                                     k přečtení zde
  cnc872c report priruba.nc --format html -o list-priruba.html  stránka k vytištění
  cnc872c report priruba.nc --format markdown                   pro wiki
  cnc872c report priruba.nc --format json | jq '.tools[].t'

Čas je z „motion“. Hlášení jdou na standardní chybový výstup. Návratový kód: 0 úplné, 1 program má
chyby, 2 příkaz nešlo provést; SOUBOR pak zůstane, jak byl.",
        },
    ),
    about(
        "explain",
        "Explains findings, functions, addresses and keys of the project file",
        "Vysvětlí hlášení, funkce, adresy a klíče projektového souboru",
        Bilingual {
            en: "\
Examples:
  cnc872c explain                     the list of all findings
  cnc872c explain E0306               a finding by its code
  cnc872c explain duplicate-address   or by its name
  cnc872c explain G73 M19             functions
  cnc872c explain '&' X               addresses
  cnc872c explain ZMM10PI             signals of the PLC
  cnc872c explain limits.feed g97     keys of cnc872c.toml
  cnc872c explain radius              the pages that mention a word",
            cs: "\
Příklady:
  cnc872c explain                     seznam všech hlášení
  cnc872c explain E0306               hlášení podle kódu
  cnc872c explain duplicate-address   nebo podle názvu
  cnc872c explain G73 M19             funkce
  cnc872c explain '&' X               adresy
  cnc872c explain ZMM10PI             signály PLC
  cnc872c explain limits.feed g97     klíče souboru cnc872c.toml
  cnc872c explain posuv               stránky, kde je to slovo",
        },
    ),
    about(
        "init",
        "Writes a commented project file cnc872c.toml, never over an existing one",
        "Zapíše projektový soubor cnc872c.toml s poznámkami, existující nikdy nepřepíše",
        Bilingual {
            en: "\
Examples:
  cnc872c init                     into this folder, for the CNC872
  cnc872c init --dialect cnc8x9    for another control
  cnc872c init programs --lang cs  into the folder programs, comments in Czech

All defaults are in the file; what has none is an example behind #.",
            cs: "\
Příklady:
  cnc872c init                     do této složky, pro CNC872
  cnc872c init --dialect cnc8x9    pro jiný systém
  cnc872c init programy --lang en  do složky programy, poznámky anglicky

V souboru jsou všechny výchozí hodnoty; kde žádná není, je za # příklad.",
        },
    ),
    about(
        "lsp",
        "Serves an editor: findings while typing, meanings, jumps (language server on stdin and stdout)",
        "Slouží editoru: hlášení při psaní, významy, skoky (jazykový server na stdin a stdout)",
        Bilingual {
            en: "\
Editors start it themselves; docs/guide/editors.en.md says how they are set up.",
            cs: "\
Editory jej spouštějí samy; jak je nastavit, popisuje docs/guide/editors.cs.md.",
        },
    ),
    about(
        "stats",
        "Writes one row of facts a program: hash, blocks, time, tools, functions, findings",
        "Zapíše o každém programu jeden řádek: otisk, bloky, čas, nástroje, funkce, hlášení",
        Bilingual {
            en: "\
Examples:
  cnc872c stats archive                                       to read here
  cnc872c stats archive --format csv -o archive.csv           for a spreadsheet
  cnc872c stats archive --format arrow -o archive.arrow       for DuckDB, polars, pandas
  cnc872c stats archive --cache ~/.cache/cnc872c --format json

Macrocycles have no row. With --cache a later run executes only what changed: programs, macrocycles,
configuration. Exit status: 0 also when programs have errors, 2 a file cannot be read, no program was
found, or the configuration or the command line is wrong.",
            cs: "\
Příklady:
  cnc872c stats archiv                                        k přečtení zde
  cnc872c stats archiv --format csv -o archiv.csv             pro tabulkový procesor
  cnc872c stats archiv --format arrow -o archiv.arrow         pro DuckDB, polars, pandas
  cnc872c stats archiv --cache ~/.cache/cnc872c --format json

Makrocykly řádek nemají. S --cache se příště provede jen to, co se změnilo: programy, makrocykly,
konfigurace. Návratový kód: 0 i při chybách v programech, 2 soubor nelze přečíst, žádný program se
nenašel, nebo je chyba v konfiguraci či na příkazovém řádku.",
        },
    ),
    about(
        "schema",
        "Prints the JSON Schema of what the other commands write and read",
        "Vypíše JSON Schema toho, co ostatní příkazy zapisují a čtou",
        Bilingual {
            en: "\
Examples:
  cnc872c schema              of a line of the block stream (compile)
  cnc872c schema diagnostics  of check --format json
  cnc872c schema config       of cnc872c.toml, for editors that complete it
  cnc872c schema motion       of a line of motion --format json
  cnc872c schema plc          of a line of plc --format json
  cnc872c schema report       of report --format json
  cnc872c schema state        of state --format json
  cnc872c schema compare      of compare --format json
  cnc872c schema stats        of stats --format json",
            cs: "\
Příklady:
  cnc872c schema              řádku proudu bloků (compile)
  cnc872c schema diagnostics  výstupu check --format json
  cnc872c schema config       souboru cnc872c.toml, pro napovídání v editoru
  cnc872c schema motion       řádku motion --format json
  cnc872c schema plc          řádku plc --format json
  cnc872c schema report       listu report --format json
  cnc872c schema state        odpovědi state --format json
  cnc872c schema compare      výstupu compare --format json
  cnc872c schema stats        výstupu stats --format json",
        },
    ),
    about(
        "completions",
        "Prints a script that lets a shell complete this command line",
        "Vypíše skript, se kterým shell doplňuje tento příkazový řádek",
        Bilingual {
            en: "\
Examples:
  cnc872c completions bash > ~/.local/share/bash-completion/completions/cnc872c
  cnc872c completions fish > ~/.config/fish/completions/cnc872c.fish",
            cs: "\
Příklady:
  cnc872c completions bash > ~/.local/share/bash-completion/completions/cnc872c
  cnc872c completions fish > ~/.config/fish/completions/cnc872c.fish",
        },
    ),
    about(
        "man",
        "Prints the manual page of the program, or of a command",
        "Vypíše manuálovou stránku programu, nebo příkazu",
        Bilingual {
            en: "\
Examples:
  cnc872c man > cnc872c.1
  cnc872c man check > cnc872c-check.1",
            cs: "\
Příklady:
  cnc872c man > cnc872c.1
  cnc872c man check > cnc872c-check.1",
        },
    ),
    about(
        "help",
        "Prints this help, or that of a command",
        "Vypíše tuto nápovědu, nebo nápovědu k příkazu",
        Bilingual { en: "", cs: "" },
    ),
];

/// The help of an argument or option.
pub(super) struct ArgumentText {
    /// Empty: of every command that has it.
    pub command: &'static str,
    pub id: &'static str,
    pub heading: Heading,
    pub help: Bilingual,
}

pub(super) const fn arg(
    command: &'static str,
    id: &'static str,
    heading: Heading,
    en: &'static str,
    cs: &'static str,
) -> ArgumentText {
    ArgumentText { command, id, heading, help: Bilingual { en, cs } }
}

use Heading::{Arguments, Everywhere, Levels, Machine, Options};

/// Every argument and option.
pub(super) const ARGUMENTS: &[ArgumentText] = &[
    arg(
        "check",
        "paths",
        Arguments,
        "Programs, macrocycles, folders to search for them, or - for standard input. A folder is searched with the \
         folders in it for .nc .ncp .mpf .txt with a line that begins with % and a number, and for macrocycles L…; \
         hidden files and links that lead out are left out",
        "Programy, makrocykly, složky k prohledání, nebo - pro standardní vstup. Ve složce a ve složkách v ní se \
         hledají soubory .nc .ncp .mpf .txt s řádkem, který začíná znakem % a číslem, a makrocykly L…; skryté soubory \
         a odkazy vedoucí ven se vynechají",
    ),
    arg(
        "compile",
        "file",
        Arguments,
        "The program, or - for standard input. A macrocycle is compiled with the program that calls it",
        "Program, nebo - pro standardní vstup. Makrocyklus se překládá s programem, který ho volá",
    ),
    arg(
        "view",
        "file",
        Arguments,
        "The program, or - for standard input. A macrocycle is drawn with the program that calls it",
        "Program, nebo - pro standardní vstup. Makrocyklus se kreslí s programem, který ho volá",
    ),
    arg(
        "explain",
        "names",
        Arguments,
        "Codes or names of findings, functions, addresses, keys, signals of the PLC; any other word lists the pages that \
         have it. None: the list of all findings",
        "Kódy nebo názvy hlášení, funkce, adresy, klíče, signály PLC; jiné slovo vypíše stránky, kde je. Nic: seznam všech \
         hlášení",
    ),
    arg("init", "folder", Arguments, "The folder, else this one", "Složka; jinak tato"),
    arg("init", "dialect", Options, "The control, else cnc872", "Řídicí systém; jinak cnc872"),
    arg(
        "lsp",
        "stdio",
        Options,
        "Over standard input and output: the only way there is; for clients that say so",
        "Po standardním vstupu a výstupu: jiný způsob není; pro klienty, kteří to uvádějí",
    ),
    arg("schema", "schema", Arguments, "Of what", "Čeho"),
    arg("completions", "shell", Arguments, "For which shell", "Pro který shell"),
    arg("", "command", Arguments, "Of which command", "Ke kterému příkazu"),
    arg(
        "check",
        "fix",
        Options,
        "Change the files where a finding has a certain fix, then report what is left. Encoding and line ends stay",
        "Upravit soubory tam, kde má hlášení jistou opravu, a vypsat, co zbývá. Kódování a konce řádků zůstanou",
    ),
    arg(
        "check",
        "diff",
        Options,
        "Show what --fix would change, as a unified diff, and change nothing. Exit with status 1 when there is something",
        "Ukázat, co by --fix změnilo (unified diff), a nic neměnit. Je-li co měnit, skončit kódem 1",
    ),
    arg(
        "check",
        "deny_warnings",
        Options,
        "Exit with status 1 when there are warnings",
        "Skončit kódem 1 i při varováních",
    ),
    arg(
        "check",
        "allow_empty",
        Options,
        "Exit with status 0 when no program is found",
        "Skončit kódem 0, i když se žádný program nenajde",
    ),
    arg(
        "compile",
        "output",
        Options,
        "Write to this file. It is replaced when the stream is complete, and left as it was otherwise",
        "Zapsat do tohoto souboru. Nahradí se, až když je proud úplný, jinak zůstane, jak byl",
    ),
    arg(
        "compile",
        "from",
        Options,
        "Leave out the blocks before this seq, the number of the record; not N",
        "Vynechat bloky před tímto seq, pořadím záznamu; ne N",
    ),
    arg("compile", "limit", Options, "Write at most so many blocks", "Zapsat nejvýše tolik bloků"),
    arg(
        "view",
        "output",
        Options,
        "Write to this file instead of FILE.html beside the program. A name with .svg or .png makes a still picture",
        "Zapsat do tohoto souboru místo SOUBOR.html vedle programu. Jméno s .svg nebo .png dá obrázek",
    ),
    arg(
        "view",
        "plane",
        Options,
        "What a picture looks at; else the plane that shows most of the working motions",
        "Na co se obrázek dívá; jinak rovina, v níž je vidět nejvíc pracovních pohybů",
    ),
    arg(
        "view",
        "size",
        Options,
        "Size of a picture in pixels, else 1600x1000",
        "Velikost obrázku v pixelech, jinak 1600x1000",
    ),
    arg("view", "open", Options, "Open the page when it is written", "Zapsanou stránku otevřít"),
    arg(
        "view",
        "from",
        Options,
        "Leave out the executed blocks before this seq",
        "Vynechat provedené bloky před tímto seq",
    ),
    arg(
        "view",
        "blocks",
        Options,
        "Draw the first N executed blocks only",
        "Nakreslit jen prvních N provedených bloků",
    ),
    arg(
        "motion",
        "file",
        Arguments,
        "The program, or - for standard input. A macrocycle is executed with the program that calls it",
        "Program, nebo - pro standardní vstup. Makrocyklus se provádí s programem, který ho volá",
    ),
    arg(
        "motion",
        "output",
        Options,
        "Write to this file. It is replaced when all is written, and left as it was otherwise",
        "Zapsat do tohoto souboru. Nahradí se, až když je vše zapsáno, jinak zůstane, jak byl",
    ),
    arg("motion", "format", Options, "The form of the output", "Tvar výstupu"),
    arg(
        "motion",
        "phases",
        Options,
        "With json: the parts of each motion with constant jerk",
        "S json: úseky každého pohybu se stálým ryvem",
    ),
    arg(
        "motion",
        "all",
        Options,
        "List all red joints, not the first 20; of the findings all",
        "Vypsat všechna červená napojení, ne jen prvních 20; z hlášení všechna",
    ),
    arg(
        "motion",
        "set",
        Options,
        "Try another value of a key of [motion] or of a machine constant; may be given again",
        "Zkusit jinou hodnotu klíče z [motion] nebo strojní konstanty; lze opakovat",
    ),
    arg(
        "plc",
        "file",
        Arguments,
        "The program, or - for standard input. A macrocycle is executed with the program that calls it",
        "Program, nebo - pro standardní vstup. Makrocyklus se provádí s programem, který ho volá",
    ),
    arg(
        "plc",
        "output",
        Options,
        "Write to this file. It is replaced when all is written, and left as it was otherwise",
        "Zapsat do tohoto souboru. Nahradí se, až když je vše zapsáno, jinak zůstane, jak byl",
    ),
    arg("plc", "format", Options, "The form of the output", "Tvar výstupu"),
    arg(
        "plc",
        "signals",
        Options,
        "These signals: names and patterns with *, separated by commas. Else on cnc872 the signals BLK, on the others \
         the compatible ones",
        "Tyto signály: názvy a vzory s *, oddělené čárkami. Jinak na cnc872 signály BLK, na ostatních kompatibilní",
    ),
    arg(
        "plc",
        "compat",
        Options,
        "Also the compatible signals of CNC8x6 and CNC8x9, where --signals or cnc872 leave them out",
        "I kompatibilní signály CNC8x6 a CNC8x9, které --signals nebo cnc872 vynechá",
    ),
    arg(
        "plc",
        "all",
        Options,
        "In the table also the steps that change nothing; of the findings all",
        "V tabulce i kroky, které nic nemění; z hlášení všechna",
    ),
    arg(
        "plc",
        "find",
        Options,
        "The places where this condition holds; status 1 when there is none",
        "Místa, kde tato podmínka platí; kód 1, když žádné není",
    ),
    arg(
        "plc",
        "list",
        Options,
        "All signals of the control; no program is needed",
        "Všechny signály systému, bez programu",
    ),
    arg("plc", "from", Options, "Leave out the steps of blocks before this seq", "Vynechat kroky bloků před tímto seq"),
    arg("plc", "limit", Options, "The steps of at most so many blocks", "Kroky nejvýše tolika bloků"),
    arg(
        "report",
        "file",
        Arguments,
        "The program, or - for standard input. A macrocycle is executed with the program that calls it",
        "Program, nebo - pro standardní vstup. Makrocyklus se provádí s programem, který ho volá",
    ),
    arg(
        "report",
        "output",
        Options,
        "Write to this file. It is replaced when all is written, and left as it was otherwise",
        "Zapsat do tohoto souboru. Nahradí se, až když je vše zapsáno, jinak zůstane, jak byl",
    ),
    arg("report", "format", Options, "The form of the sheet", "Tvar listu"),
    arg(
        "stats",
        "paths",
        Arguments,
        "Programs, or folders to search for them as check does",
        "Programy, nebo složky k prohledání jako u check",
    ),
    arg(
        "stats",
        "output",
        Options,
        "Write to this file. It is replaced when all is written, and left as it was otherwise",
        "Zapsat do tohoto souboru. Nahradí se, až když je vše zapsáno, jinak zůstane, jak byl",
    ),
    arg("stats", "format", Options, "The form of the rows", "Tvar řádků"),
    arg(
        "stats",
        "cache",
        Options,
        "Keep rows in this folder, and execute only what changed since",
        "Ukládat řádky do této složky a provádět jen to, co se od té doby změnilo",
    ),
    arg(
        "compile",
        "format",
        Options,
        "How findings are shown; arrow: the stream is written as Arrow columns",
        "Jak se hlášení vypíšou; arrow: proud se zapíše jako sloupce Arrow",
    ),
    arg(
        "compile",
        "all",
        Options,
        "Show all findings; else at most 20 of each code and file (human, short)",
        "Vypsat všechna hlášení; jinak nejvýše 20 od každého kódu a souboru (human, short)",
    ),
    arg("report", "all", Options, "Show all findings", "Vypsat všechna hlášení"),
    arg("", "format", Options, "How findings are shown", "Jak se hlášení vypíšou"),
    arg(
        "",
        "all",
        Options,
        "Show all findings; else at most 20 of each code and file (human, short)",
        "Vypsat všechna hlášení; jinak nejvýše 20 od každého kódu a souboru (human, short)",
    ),
    arg(
        "",
        "dialect",
        Machine,
        "The control, else `dialect` of the project file, else cnc872",
        "Řídicí systém; jinak dialect z projektu, jinak cnc872",
    ),
    arg(
        "",
        "config",
        Machine,
        "The project file, else cnc872c.toml in the program's folder or the nearest folder above it; for standard input \
         in the working folder",
        "Projektový soubor; jinak cnc872c.toml ve složce programu nebo v nejbližší nad ní; pro standardní vstup v pracovní \
         složce",
    ),
    arg(
        "",
        "channel_config",
        Machine,
        "The ChannelConfig XML whose MFunctions the machine has (cnc872)",
        "ChannelConfig (XML), jehož MFunctions stroj má (cnc872)",
    ),
    arg(
        "",
        "macrocycles",
        Machine,
        "A folder with macrocycles; may be given again, searched in this order. Else the program's folder",
        "Složka s makrocykly; lze opakovat, hledá se v tomto pořadí. Jinak složka programu",
    ),
    arg(
        "",
        "param",
        Machine,
        "The value of a parameter at program start; may be given again",
        "Hodnota parametru na začátku programu; lze opakovat",
    ),
    arg("", "block_skip", Machine, "Leave out the blocks with /", "Vynechat bloky s /"),
    arg("", "optional_stop", Machine, "M01 stops", "M01 zastavuje"),
    arg(
        "",
        "encoding",
        Machine,
        "Code page of files that are not UTF-8; cp852 unless configured",
        "Kódová stránka souborů, které nejsou v UTF-8; není-li nastavena, cp852",
    ),
    arg(
        "",
        "max_blocks",
        Machine,
        "Most blocks that a program may execute; 10000000 unless configured",
        "Kolik bloků smí program nejvýše provést; není-li nastaveno, 10000000",
    ),
    arg(
        "",
        "deny",
        Levels,
        "Make this warning an error, by code or name (`cnc872c explain` lists them); if repeated, the last one wins",
        "Z tohoto varování udělat chybu, podle kódu nebo názvu (vypíše je „cnc872c explain“); při opakování platí poslední",
    ),
    arg("", "warn", Levels, "Make it a warning", "Udělat z něj varování"),
    arg("", "allow", Levels, "Do not show it", "Nevypisovat ho"),
    arg(
        "",
        "color",
        Everywhere,
        "Colours; auto: on a terminal, unless NO_COLOR is set",
        "Barvy; auto: na terminálu, není-li nastaveno NO_COLOR",
    ),
    arg(
        "",
        "lang",
        Everywhere,
        "Language of texts, else by LC_ALL, LC_MESSAGES, LANG",
        "Jazyk textů; jinak podle LC_ALL, LC_MESSAGES, LANG",
    ),
    arg("", "help", Everywhere, "Print help", "Vypsat nápovědu"),
    arg("", "version", Everywhere, "Print the version", "Vypsat verzi"),
];

/// The names of values, in both languages. Those not listed are the same in both.
pub(super) const VALUES: &[Bilingual] = &[
    Bilingual { en: "PATH", cs: "CESTA" },
    Bilingual { en: "FILE", cs: "SOUBOR" },
    Bilingual { en: "DIR", cs: "SLOŽKA" },
    Bilingual { en: "NAME", cs: "NÁZEV" },
    Bilingual { en: "CODE", cs: "KÓD" },
    Bilingual { en: "COMMAND", cs: "PŘÍKAZ" },
    Bilingual { en: "FORMAT", cs: "FORMÁT" },
    Bilingual { en: "DIALECT", cs: "SYSTÉM" },
    Bilingual { en: "ENCODING", cs: "KÓDOVÁNÍ" },
    Bilingual { en: "WHEN", cs: "KDY" },
    Bilingual { en: "LANG", cs: "JAZYK" },
    Bilingual { en: "SCHEMA", cs: "SCHÉMA" },
    Bilingual { en: "SIGNALS", cs: "SIGNÁLY" },
    Bilingual { en: "CONDITION", cs: "PODMÍNKA" },
    Bilingual { en: "KEY=VALUE", cs: "KLÍČ=HODNOTA" },
];
