//! The words of `--help`, in both languages; the examples of the commands are in `help`.

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

/// A command, with its examples from `help/NAME.en.txt` and `help/NAME.cs.txt`.
macro_rules! about {
    ($name:literal, $en:literal, $cs:literal) => {
        CommandText {
            name: $name,
            about: Bilingual { en: $en, cs: $cs },
            examples: Bilingual {
                en: include_str!(concat!("help/", $name, ".en.txt")),
                cs: include_str!(concat!("help/", $name, ".cs.txt")),
            },
        }
    };
}
pub(super) use about;

/// The program itself, and every command.
pub(super) const COMMANDS: &[CommandText] = &[
    about!(
        "cnc872c",
        "Checks and compiles part programs of the CNC8x6, CNC8x9 and CNC872 controls",
        "Kontroluje a překládá partprogramy řídicích systémů CNC8x6, CNC8x9 a CNC872"
    ),
    about!("check", "Checks programs and macrocycles", "Zkontroluje programy a makrocykly"),
    about!(
        "compile",
        "Writes the block stream of a program: each executed block, in order, as a line of JSON",
        "Zapíše proud bloků programu: každý provedený blok v pořadí jako řádek JSON"
    ),
    about!(
        "view",
        "Draws the path of a program: a page with the path in three dimensions beside the text, or a picture",
        "Nakreslí dráhu programu: stránku s dráhou v prostoru vedle textu, nebo obrázek"
    ),
    about!(
        "motion",
        "Estimates how the machine moves through a program: its time, where it slows down, and why",
        "Odhadne, jak stroj programem projede: jak dlouho to trvá, kde zpomalí a proč"
    ),
    about!(
        "plc",
        "Shows what the PLC program reads of a program: command blocks, change bits, requests to move",
        "Ukáže, co z programu čte PLC program: povelové bloky, změnové bity, požadavky na pohyb"
    ),
    about!(
        "report",
        "Writes the set-up sheet of a program: size of the work, tools, functions, parameters, time",
        "Sestaví seřizovací list programu: rozměry, nástroje, funkce, parametry, čas"
    ),
    about!(
        "explain",
        "Explains findings, functions, addresses and keys of the project file",
        "Vysvětlí hlášení, funkce, adresy a klíče projektového souboru"
    ),
    about!(
        "init",
        "Writes a commented project file cnc872c.toml, never over an existing one",
        "Zapíše projektový soubor cnc872c.toml s komentáři, existující nikdy nepřepíše"
    ),
    about!(
        "lsp",
        "Serves an editor: findings while typing, meanings, jumps (language server on stdin and stdout)",
        "Jazykový server pro editor: hlášení při psaní, významy, přechody (na stdin a stdout)"
    ),
    about!(
        "stats",
        "Writes one row of facts a program: hash, blocks, time, tools, functions, findings",
        "Zapíše o každém programu jeden řádek: otisk, bloky, čas, nástroje, funkce, hlášení"
    ),
    about!(
        "schema",
        "Prints the JSON Schema of what the other commands write and read",
        "Vypíše JSON Schema toho, co ostatní příkazy zapisují a čtou"
    ),
    about!(
        "completions",
        "Prints a script that lets a shell complete this command line",
        "Vypíše skript, se kterým shell doplňuje tento příkazový řádek"
    ),
    about!(
        "man",
        "Prints the manual page of the program, or of a command",
        "Vypíše manuálovou stránku programu, nebo příkazu"
    ),
    CommandText {
        name: "help",
        about: Bilingual {
            en: "Prints this help, or that of a command",
            cs: "Vypíše tuto nápovědu, nebo nápovědu k příkazu",
        },
        examples: Bilingual { en: "", cs: "" },
    },
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
        "Programs, macrocycles, folders to search for them, or - for standard input. A folder and the folders in it are searched for .nc, .ncp, .mpf and .txt files in which a line begins with % and a number, and for macrocycles L…; \
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
        "Codes or names of findings, functions, addresses, keys, signals of the PLC; any other word lists the pages \
         that have it. None: the list of all findings",
        "Kódy nebo názvy hlášení, funkce, adresy, klíče, signály PLC; u jiného slova se vypíšou stránky, na kterých je. Bez argumentu: seznam všech hlášení",
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
    arg("schema", "schema", Arguments, "Which schema", "Které schéma"),
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
        "Show what --fix would change, as a unified diff, and change nothing. Exit with status 1 when there is \
        something",
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
    arg("compile", "limit", Options, "Write at most this many blocks", "Zapsat nejvýše tolik bloků"),
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
        "View shown in the picture; else the plane that shows most of the working motions",
        "Směr pohledu na obrázku; jinak rovina, v níž je vidět nejvíc pracovních pohybů",
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
        "",
        "file",
        Arguments,
        "The program, or - for standard input. A macrocycle is executed with the program that calls it",
        "Program, nebo - pro standardní vstup. Makrocyklus se provádí s programem, který ho volá",
    ),
    arg(
        "",
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
        "List all red joints, not just the first 20, and all findings",
        "Vypsat všechna červená napojení, ne jen prvních 20, a všechna hlášení",
    ),
    arg(
        "motion",
        "set",
        Options,
        "Try another value of a key of [motion] or of a machine constant; may be given again",
        "Zkusit jinou hodnotu klíče z [motion] nebo strojní konstanty; lze opakovat",
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
        "Also show the steps that change nothing, and all findings",
        "V tabulce i kroky, které nic nemění, a všechna hlášení",
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
        "format",
        Options,
        "Form of the sheet; by default from the extension of the output file, otherwise human",
        "Tvar listu; bez volby podle přípony výstupního souboru, jinak human",
    ),
    arg(
        "stats",
        "paths",
        Arguments,
        "Programs, or folders to search for them as check does",
        "Programy, nebo složky k prohledání jako u check",
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
        if cfg!(feature = "arrow") {
            "How findings are shown; arrow: the stream is written as Arrow columns"
        } else {
            "How findings are shown"
        },
        if cfg!(feature = "arrow") {
            "Jak se hlášení vypíšou; arrow: proud se zapíše jako sloupce Arrow"
        } else {
            "Jak se hlášení vypíšou"
        },
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
        "The project file, else cnc872c.toml in the program's folder or the nearest folder above it; for standard \
         input in the working folder",
        "Projektový soubor; jinak cnc872c.toml ve složce programu nebo v nejbližší nad ní; pro standardní vstup v \
         pracovní složce",
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
        "A folder with macrocycles; may be given again, searched in this order. Else those under `macrocycles` in the \
         project file, else the program's folder",
        "Složka s makrocykly; lze opakovat, hledá se v tomto pořadí. Jinak složky z klíče `macrocycles` projektového \
         souboru, jinak složka programu",
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
        "Execute at most this many blocks; 10000000 unless configured",
        "Kolik bloků smí program nejvýše provést; není-li nastaveno, 10000000",
    ),
    arg(
        "",
        "deny",
        Levels,
        "Make this warning an error, by code or name (`cnc872c explain` lists them); if repeated, the last one wins",
        "Z tohoto varování udělat chybu, podle kódu nebo názvu (vypíše je „cnc872c explain“); při opakování platí \
        poslední",
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
