//! The messages of the command line on stderr, in both languages.

use std::io;
use std::path::Path;

use crate::diag::{Code, Problem, terminal_safe};
use crate::dict::{Bilingual, Lang, bilingual};
use crate::text::path_name;

bilingual! {
    /// One thing to say.
    Words {
        CannotWrite { file: String, reason: String }
            "cannot write {file}: {reason}",
            "nelze zapsat {file}: {reason}";
        CannotWriteStdout { reason: String }
            "cannot write to standard output: {reason}",
            "nelze zapisovat na standardní výstup: {reason}";
        StdoutClosed
            "standard output is closed: there is nowhere to write to",
            "standardní výstup je uzavřen: není kam zapisovat";
        OutputIsProgram { file: String }
            "{file} is what the stream is made from (program, macrocycle, project file or ChannelConfig): another \
            file belongs after -o",
            "z {file} proud bloků vzniká (program, makrocyklus, projekt nebo ChannelConfig): za -o patří jiný soubor";
        CacheDamaged { folder: String, count: usize }
            "{folder}: {count} damaged entries of the cache are made anew",
            "{folder}: poškozené záznamy mezipaměti se vytvoří znovu: {count}";
        OutputIsRead { file: String }
            "{file} is one of the files that are read: another file belongs after -o",
            "{file} je jeden z čtených souborů: za -o patří jiný soubor";
        RestartIsProgram { file: String }
            "{file} is what the new program is made from (program, macrocycle, project file or ChannelConfig): \
            another file belongs after -o",
            "z {file} nový program vzniká (program, makrocyklus, projekt nebo ChannelConfig): za -o patří jiný soubor";
        ColumnsOnTerminal
            "Arrow columns are no text for a terminal: name a file after -o, or a program after |",
            "sloupce Arrow nejsou text pro terminál: uvést soubor za -o, nebo program za |";
        NotWhole { file: String }
            "the stream of {file} has no end: execution stopped before M02 or M30",
            "proud bloků programu {file} nemá konec: provádění skončilo před M02 nebo M30";
        PictureIsProgram { file: String }
            "{file} is what the picture is made from (program, macrocycle, project file or ChannelConfig): another \
            file belongs after -o",
            "z {file} obrázek vzniká (program, makrocyklus, projekt nebo ChannelConfig): za -o patří jiný soubor";
        PictureNeedsName
            "a program from standard input has no name for its picture: name a file after -o",
            "program ze standardního vstupu nemá jméno pro obrázek: za -o uvést soubor";
        PictureTooLarge
            "there is not enough memory for a picture of that size",
            "na obrázek této velikosti není dost paměti";
        PictureWritten { file: String }
            "written: {file}",
            "zapsáno: {file}";
        PictureKept { file: String }
            "{file} stays as it was: nothing of the program can be drawn",
            "{file} zůstává beze změny: z programu není co nakreslit";
        EmptyPart { executed: u64, last: u64 }
            "no block is in that part: the program executes {executed} blocks, seq 0 to {last}",
            "v té části není žádný blok: provedených bloků: {executed}, seq 0 až {last}";
        PictureNeedsMemory
            "the program is too long for one picture: it would take more than 2 GB of memory, or more than there is; \
             draw a part of it with --blocks and --from",
            "na jeden obrázek je program příliš dlouhý: potřeboval by přes 2 GB paměti, nebo víc, než jí je; \
             nakreslit jen část pomocí --blocks a --from";
        RedLeftOut { count: usize }
            "{count} red dots are not drawn: others stand at the same places, the page has them all",
            "nekreslených červených teček: {count}; na jejich místech už jiné stojí, stránka je má všechny";
        YellowLeftOut { count: usize }
            "{count} yellow dots are not drawn: they are too many for a picture, the page has them all",
            "nekreslených žlutých teček: {count}; na obrázek je jich příliš mnoho, stránka je má všechny";
        MotionsLeftOut { count: usize }
            "motions that are not drawn: {count}; their start or end is not known, or they move none of X, Y, Z",
            "nekreslených pohybů: {count}; není znám jejich začátek nebo konec, nebo nepohybují žádnou z os X, Y, Z";
        StaleMotions { count: usize }
            "motions drawn from a position of another origin, where the tool does not stand: {count}",
            "pohyby nakreslené z polohy v jiném počátku, kde nástroj nestojí: {count}";
        OptionOfPictures { option: String }
            "{option} goes with a still picture: -o part.svg or -o part.png",
            "{option} patří k obrázku: -o dil.svg nebo -o dil.png";
        NothingToOpen
            "--open opens a file, and -o - writes none: name a file after -o",
            "--open otevírá soubor a -o - žádný nezapíše: za -o uvést soubor";
        AssumedMachine
            "the machine of the estimate is assumed: nothing is configured in [motion]",
            "stroj pro odhad je předpokládaný: v [motion] není nastaveno nic";
        NeedMotion { names: String }
            "{names}: no value without [motion] in the project file",
            "{names}: bez [motion] v projektovém souboru nemá hodnotu";
        CannotOpen { file: String, opener: String, reason: String }
            "{file} is written, but {opener} did not open it: {reason}",
            "{file} je zapsán, ale {opener} ho neotevřel: {reason}";
        NoSuchPicture { extension: String }
            "view writes no .{extension}: name a page (.html) or a picture (.svg, .png) after -o",
            "view nezapisuje .{extension}: za -o uvést stránku (.html) nebo obrázek (.svg, .png)";
        Interrupted
            "interrupted; no file is left half written",
            "přerušeno; žádný soubor nezůstal zapsaný napůl";
        OnlyMacrocycles { file: String }
            "{file} is a macrocycle: it has no row of its own",
            "{file} je makrocyklus: vlastní řádek nemá";
        NoPrograms { folder: String }
            "no program found in {folder}; programs are files .nc .ncp .mpf .txt (or `extensions` of the project file) \
             with a line that begins with % and a number, and macrocycles L…",
            "ve složce {folder} není žádný program; hledají se soubory .nc .ncp .mpf .txt (nebo extensions z \
             projektu), v nichž řádek začíná znakem % a číslem, a makrocykly L…";
        OutwardLink { link: String }
            "{link}: not searched, the link leads out of the folder",
            "{link}: neprohledáno, odkaz vede ven ze složky";
        DanglingLink { link: String }
            "{link}: the link leads to no file",
            "{link}: odkaz nevede k žádnému souboru";
        SpecialFile { file: String }
            "{file}: not read, it is a pipe or a device: name it to check it",
            "{file}: nečteno, je to roura nebo zařízení: ke kontrole uvést jménem";
        FixedOne { file: String }
            "{file}: 1 fix applied",
            "{file}: provedena 1 oprava";
        Fixed { file: String, count: usize }
            "{file}: {count} fixes applied",
            "{file}: provedeno oprav: {count}";
        FixApplied { file: String, line: u32, column: u32, code: Code, title: String }
            "  {file}:{line}:{column}: {code} {title}",
            "  {file}:{line}:{column}: {code} {title}";
        FixesNotListed { file: String, more: usize }
            "  {file}: {more} more",
            "  {file}: dalších {more}";
        FixLink { file: String }
            "{file}: not fixed, because a link leads to it: name the file to fix it",
            "{file}: neopraveno, vede k němu odkaz: k opravě soubor uvést jménem";
        FixForeign { file: String }
            "{file}: not fixed, because it does not look like a program for this control: name the file to fix it",
            "{file}: neopraveno, nevypadá jako program pro tento systém: k opravě soubor uvést jménem";
        LinesLeft { file: String, lines: usize }
            "{file}: lines left as they are, because they could not be read: {lines}; `cnc872c check` says why",
            "{file}: řádků ponechaných beze změny, protože je nelze přečíst: {lines}; proč, řekne „cnc872c check“";
        Rewrote { changed: usize, same: usize }
            "changed: {changed}, unchanged: {same}",
            "změněno: {changed}, beze změny: {same}";
        WouldRewrite { changed: usize, same: usize }
            "would change: {changed}, unchanged: {same}",
            "změnilo by se: {changed}, beze změny: {same}";
        RewriteLink { file: String }
            "{file}: left as it is, because a link leads to it: name the file to change it",
            "{file}: ponecháno beze změny, vede k němu odkaz: ke změně soubor uvést jménem";
        RewriteNeedsFile { file: String }
            "{file} is no regular file and cannot be replaced",
            "{file} není obyčejný soubor a nelze jej nahradit";
        RewriteChanged { file: String }
            "{file}: left as it is, because it changed meanwhile",
            "{file}: ponecháno beze změny, protože se soubor mezitím změnil";
        NotRenumbered { file: String, why: String }
            "{file}: not renumbered: {why}",
            "{file}: nepřečíslováno: {why}";
        NumberMentioned { file: String, line: u32, old: u32, new: u32 }
            "{file}:{line}: the comment names N{old}, which is N{new} now",
            "{file}:{line}: komentář uvádí N{old}, což je teď N{new}";
        MoreMentions { file: String, more: usize }
            "{file}: such comments besides: {more}",
            "{file}: dalších takových komentářů: {more}";
        CannotRead { file: String, reason: String }
            "{file}: cannot be read: {reason}",
            "{file}: nelze přečíst: {reason}";
        FixElsewhere { file: String, count: usize }
            "{file}: not fixed, because it is not among the files to check; fixes offered: {count}",
            "{file}: neopraveno, není mezi kontrolovanými soubory; nabízených oprav: {count}";
        FixChanged { file: String }
            "{file}: not fixed, because it changed meanwhile",
            "{file}: neopraveno, protože se soubor mezitím změnil";
        FixNeedsFile { file: String }
            "--fix changes files, and {file} is not one: give a regular file",
            "--fix mění soubory a {file} souborem není: zadat obyčejný soubor";
        ServerOfEditors
            "this is the language server: it waits for an editor's messages on standard input; Ctrl-D ends it",
            "toto je jazykový server: čeká na zprávy editoru na standardním vstupu; ukončí jej Ctrl-D";
        ChannelConfigDialect { dialect: String }
            "--channel-config does not go with {dialect}: only cnc872 has a ChannelConfig",
            "--channel-config nelze použít s {dialect}: ChannelConfig má jen cnc872";
        Written { file: String }
            "{file} is written; its comments say what to set",
            "{file} je zapsán; co nastavit, říkají komentáře v něm";
        FileExists { file: String }
            "{file} exists, and stays as it is",
            "{file} už existuje a zůstává, jak je";
        NoSuchFolder { folder: String }
            "{folder}: there is no such folder",
            "{folder}: složka neexistuje";
        NoFolder { folder: String }
            "-L {folder}: there is no such folder",
            "-L {folder}: složka neexistuje";
        LevelUnknown { option: String, name: String }
            "{option} {name}: no finding has this code or name; `cnc872c explain` lists them all",
            "{option} {name}: žádné hlášení nemá tento kód ani název; všechna vypíše „cnc872c explain“";
        LevelUnknownNear { option: String, name: String, near: String }
            "{option} {name}: no finding has this code or name; perhaps {near} is meant",
            "{option} {name}: žádné hlášení nemá tento kód ani název; možná mělo být {near}";
        LevelOfError { option: String, name: String }
            "{option} {name}: it is an error and cannot be switched off; only warnings and E0109 have a level",
            "{option} {name}: je to chyba a vypnout nejde; nastavit lze jen varování a E0109";
        Parameter { text: String, fault: String }
            "--param {text}: {fault}",
            "--param {text}: {fault}";
        NothingToExplain { name: String }
            "{name}: there is no such diagnostic, function, address, key or signal, and no page has the word; \
             `cnc872c explain` lists the findings",
            "{name}: takové hlášení, funkce, adresa, klíč ani signál není a žádná stránka to slovo nemá; hlášení \
             vypíše „cnc872c explain“";
        NothingToExplainNear { name: String, near: String }
            "{name}: there is no such diagnostic, function, address, key or signal; perhaps {near} is meant",
            "{name}: takové hlášení, funkce, adresa, klíč ani signál není; možná mělo být {near}";
        PhasesFormat
            "--phases goes with --format json",
            "--phases patří k --format json";
        SetForm { text: String }
            "--set {text}: write a key of [motion] or a machine constant and its value, as in accuracy-um=4",
            "--set {text}: patří sem klíč z [motion] nebo strojní konstanta s hodnotou, například accuracy-um=4";
        SetUnknown { text: String, key: String }
            "--set {text}: {key} is neither a key of [motion] nor a machine constant",
            "--set {text}: {key} není klíč z [motion] ani strojní konstanta";
        SetUnknownNear { text: String, key: String, near: String }
            "--set {text}: {key} is neither a key of [motion] nor a machine constant; perhaps {near} is meant",
            "--set {text}: {key} není klíč z [motion] ani strojní konstanta; možná mělo být {near}";
        SetConstant { text: String, key: String }
            "--set {text}: motion does not depend on {key}",
            "--set {text}: pohyb na {key} nezávisí";
        SetDialect { text: String, dialect: String }
            "--set {text}: on {dialect} [motion] describes the machine, not its constants",
            "--set {text}: u {dialect} se pohyb počítá podle [motion], ne podle konstant";
        JerkFree { blocks: u64 }
            "P is not known where it counts: the jerk is not limited there, and the time is at least this; such \
            blocks: {blocks}",
            "P tam, kde platí, není známo: ryv tam není omezen a čas je nejméně takový; takových bloků: {blocks}";
        NoWholeTime { file: String }
            "the time of {file} is not known: execution stopped before M02 or M30",
            "čas programu {file} není znám: provádění skončilo před M02 nebo M30";
        NoWholeSheet { file: String }
            "there is no set-up sheet of {file}: execution stopped before M02 or M30",
            "seřizovací list programu {file} nelze sestavit: provádění skončilo před M02 nebo M30";
        Place { text: String }
            "{text}",
            "{text}";
        ProjectAbove { above: String }
            "for the programs here it takes the place of {above}",
            "pro zdejší programy platí místo {above}";
        StdinTwice
            "standard input can be read once only: name a file for the other program",
            "standardní vstup lze číst jen jednou: druhý program zadat souborem";
        CompareFolder { folder: String }
            "{folder} is a folder: compare takes two programs or two folders",
            "{folder} je složka: compare porovnává dva programy nebo dvě složky";
        CompareFoldersJson
            "two folders are compared as a table only: --format json takes two programs",
            "dvě složky se porovnávají jen do tabulky: --format json patří ke dvěma programům";
        CompareFoldersPage
            "two folders are compared as a table only: -o takes two programs",
            "dvě složky se porovnávají jen do tabulky: -o patří ke dvěma programům";
        NoSuchComparison { extension: String }
            "compare writes no .{extension}: name a page (.html) after -o",
            "compare nezapisuje .{extension}: za -o uvést stránku (.html)";
        PageIsProgram { file: String }
            "{file} is read by compare (program, macrocycle, project file or ChannelConfig): another file belongs \
            after -o",
            "{file} příkaz compare čte (program, makrocyklus, projekt nebo ChannelConfig): za -o patří jiný soubor";
        ComparisonNeedsMemory
            "the programs are too long for one page: it would take more than 2 GB of memory, or more than there is; \
             without -o they are compared as text",
            "na jednu stránku jsou programy příliš dlouhé: potřebovala by přes 2 GB paměti, nebo víc, než jí je; \
             bez -o se porovnají textem";
        ProgramChanged { file: String }
            "{file} changed while it was compared",
            "{file} se během porovnávání změnil";
        NForm { text: String }
            "--n {text}: a block number belongs here, as in --n 120",
            "--n {text}: patří sem číslo bloku, například --n 120";
        ToolForm { text: String }
            "--at-tool {text}: a tool number belongs here, as in --at-tool T5",
            "--at-tool {text}: patří sem číslo nástroje, například --at-tool T5";
        TimeForm { text: String }
            "--time {text}: write hours, minutes and seconds, as in 0:12:30",
            "--time {text}: patří sem hodiny, minuty a sekundy, například 0:12:30";
        Signals { text: String }
            "--signals: {text}",
            "--signals: {text}";
        ListFormat
            "--list is a table, or JSON with --format json",
            "--list je tabulka, nebo JSON s --format json";
        Foreign { text: String }
            "{text}",
            "{text}";
        NoMFunction { number: u32 }
            "M{number} is no function of any of the controls: M functions are M00 to M99, on CNC872 M100 too",
            "M{number} není funkcí žádného ze systémů: M funkce jsou M00 až M99, na CNC872 také M100";
        NoCommand { name: String }
            "there is no command {name}; `cnc872c help` lists them",
            "příkaz {name} není; všechny vypíše „cnc872c help“";
        CheckingFiles
            "checking",
            "kontrola";
        Blocks
            "blocks",
            "bloků";
    }
}

impl Words {
    /// A file that could not be written. A new file that is "not found" lacks its folder.
    pub fn cannot_write(path: &Path, error: &io::Error, lang: Lang) -> Self {
        let file = path_name(path);
        let reason = match (error.kind(), lang) {
            (io::ErrorKind::NotFound, Lang::En) => "there is no such folder".to_owned(),
            (io::ErrorKind::NotFound, Lang::Cs) => "složka neexistuje".to_owned(),
            _ => reason(error, lang),
        };
        Self::CannotWrite { file, reason }
    }

    /// The text in `lang`, with no character that a terminal might act on.
    pub fn shown(&self, lang: Lang) -> String {
        terminal_safe(&self.text(lang)).into_owned()
    }
}

/// How a line to the user begins.
pub const fn error_prefix(lang: Lang) -> &'static str {
    match lang {
        Lang::En => "error",
        Lang::Cs => "chyba",
    }
}

/// Why writing or reading failed, in the user's language where there is a text for it.
pub fn reason(error: &io::Error, lang: Lang) -> String {
    const TEXTS: [(io::ErrorKind, Bilingual); 5] = [
        (
            io::ErrorKind::AlreadyExists,
            Bilingual { en: "something else has this name", cs: "tento název už má něco jiného" },
        ),
        (io::ErrorKind::StorageFull, Bilingual { en: "the disk is full", cs: "disk je plný" }),
        (io::ErrorKind::QuotaExceeded, Bilingual { en: "the disk quota is used up", cs: "disková kvóta je vyčerpána" }),
        (io::ErrorKind::ReadOnlyFilesystem, Bilingual { en: "the disk is read-only", cs: "disk je jen pro čtení" }),
        (io::ErrorKind::FileTooLarge, Bilingual { en: "it is too large", cs: "soubor je příliš velký" }),
    ];
    let text = TEXTS.iter().find(|(kind, _)| *kind == error.kind());
    text.map_or_else(|| Problem::from_io(error).text(lang), |(_, text)| text.get(lang).to_owned())
}
