//! Every diagnostic: code, name, level, fields, English and Czech text. Everything else about diagnostics is made from
//! these rows: `explain`, the reference pages, JSON names, `[lints]`.
//!
//! A text is a format string with the fields by name, or an expression in parentheses over the fields that gives a
//! string; an empty help or note is left out. Messages are short and complete alone; the note says why, the help says
//! what to write.

use super::advice::{
    center_help, control_digits, is_exchanged, of_group, other_range, range_cs, unnumbered_line, unused_centers,
};
use super::other_controls::foreign_g;
use super::rows::{Severity, diagnostics, optional_text, text};
use super::{
    AddressMeant, AfterEndMeant, ArcMeant, ArcPoints, ArithmeticFault, CenterPlace, CommaMeant, ConfigNeed,
    ConfigProblem, ConstantProblem, DwellMeant, EarlyEnd, JointBreak, JointLimit, KnownNames, Meant, NameKind, NotUsed,
    NumberMeant, OtherControl, OtherMeaning, ParameterNeed, PlaneFault, PointMeant, SpindleFault, TargetMeant,
    TextMeant, Unmodelled, Unread, UnreadEnd, UnusedMeant, ValueMeant,
};
use crate::dict::{Address, Dialect, FeedPer, GCode, GGroup, Lang, Plane};
use crate::sure::Sure;

/// A number with its thousands apart.
fn grouped(number: u64, separator: char) -> String {
    let digits = number.to_string();
    let ends = (1..=digits.len()).rev();
    let apart = |(digit, left): (char, usize)| {
        let separator = (left % 3 == 1 && left > 1).then_some(separator);
        std::iter::once(digit).chain(separator)
    };
    digits.chars().zip(ends).flat_map(apart).collect()
}

/// Blocks in Czech behind their number.
const fn blocks_cs(count: u64) -> &'static str {
    match count {
        1 => "blok",
        2..=4 => "bloky",
        _ => "bloků",
    }
}

/// `text` with the nearest thing in it, or nothing when there is none.
fn nearest<T: std::fmt::Display>(candidate: Option<&T>, before: &str, after: &str) -> String {
    candidate.map(|found| format!("{before}{found}{after}")).unwrap_or_default()
}

diagnostics! {
    [E0101] UnknownCharacter "unknown-character" Error { text: String, meant: Meant }
        en (match (super::shown::control_name(text), super::shown::control_inside(text)) { (Some(name), _) => format!("the character {name} means nothing to the control"), (None, Some((name, rest))) => format!("the character {name} inside `{rest}` means nothing to the control"), (None, None) => format!("`{text}` means nothing to the control") })
        cs (match (super::shown::control_name(text), super::shown::control_inside(text)) { (Some(name), _) => format!("znak {name} řídicí systém nezná"), (None, Some((name, rest))) => format!("znak {name} uvnitř „{rest}“ řídicí systém nezná"), (None, None) => { let what = if text.chars().count() == 1 { "znak" } else { "zápis" }; format!("{what} „{text}“ řídicí systém nezná") } })
        help (meant.text(Lang::En)) | (meant.text(Lang::Cs))
    [E0102] SplitNumber "split-number" Error { joined: String, loose: String, written: String }
        en (if is_exchanged(loose) { format!("the address is inside its number: `{loose}`") } else { "a blank inside a number".to_owned() })
        cs (if is_exchanged(loose) { format!("adresa je uvnitř čísla: „{loose}“") } else { "mezera uvnitř čísla".to_owned() })
        help (match (joined.is_empty(), loose.is_empty(), written.is_empty()) { _ if is_exchanged(loose) => format!("the address stands before its number: `{written}` in place of `{loose}`"), (true, ..) => "write the parameter or the number, not both".to_owned(), (_, true, _) => format!("write `{joined}`, or give the second number an address of its own"), (_, false, true) => format!("an address is missing before `{loose}`; if it goes on with the number before it, write `{joined}`"), (_, false, false) => format!("an address is missing before `{loose}`: `{written}`? If it goes on with the number before it, write `{joined}`") })
           | (match (joined.is_empty(), loose.is_empty(), written.is_empty()) { _ if is_exchanged(loose) => format!("adresa se píše před číslo: „{written}“ místo „{loose}“"), (true, ..) => "napsat buď parametr, nebo číslo".to_owned(), (_, true, _) => format!("napsat „{joined}“, nebo druhému číslu doplnit adresu"), (_, false, true) => format!("před {loose} chybí adresa; patří-li k předchozímu číslu, napsat „{joined}“"), (_, false, false) => format!("před {loose} chybí adresa: „{written}“? Patří-li k předchozímu číslu, napsat „{joined}“") })
        note (if is_exchanged(loose) { "" } else { "blanks are allowed between the address and its number, never inside the number or after its sign" })
           | (if is_exchanged(loose) { "" } else { "mezery smějí být mezi adresou a číslem, nikdy uvnitř čísla ani za jeho znaménkem" })
    [E0103] MissingValue "missing-value" Error { address: String, meant: ValueMeant }
        en "`{address}` has no value"
        cs "adresa {address} nemá hodnotu"
        help (meant.help(address, Lang::En)) | (meant.help(address, Lang::Cs))
        note (meant.note(address, Lang::En)) | (meant.note(address, Lang::Cs))
    [E0104] DecimalComma "decimal-comma" Error { meant: CommaMeant }
        en (meant.message(Lang::En))
        cs (meant.message(Lang::Cs))
        help (meant.text(Lang::En)) | (meant.text(Lang::Cs))
    [E0105] TypographicQuote "typographic-quote" Error { quote: char }
        en "the typographic quote `{quote}` instead of `\"`"
        cs "typografické uvozovky {quote} místo obyčejných \""
        help "write the plain quote `\"`" | "napsat obyčejné uvozovky \""
        note "the control takes only the plain quote for the border of a comment; all that follows would be read as words"
           | "systém ohraničuje komentáře jen obyčejnými uvozovkami; text za jinými by četl jako slova programu"
    [E0106] MalformedNumber "malformed-number" Error { text: String, meant: NumberMeant }
        en (meant.message(text, Lang::En))
        cs (meant.message(text, Lang::Cs))
        help (meant.text(Lang::En)) | (meant.text(Lang::Cs))
        note (meant.note(Lang::En)) | (meant.note(Lang::Cs))
    [E0107] LetterForDigit "letter-for-digit" Error { fixed: String }
        en "a letter in place of a digit"
        cs "místo číslice je písmeno"
        help "write `{fixed}`" | "napsat „{fixed}“"
    [W0108] LowercaseAddress "lowercase-address" Warning { count: usize }
        en (if *count == 1 { "an address in lower case".to_owned() } else { format!("{count} addresses in lower case, the first one here") })
        cs (if *count == 1 { "adresa malým písmenem".to_owned() } else { format!("adresy malými písmeny ({count}×), první je zde") })
        help "write addresses in upper case, as the control's own editor does" | "psát adresy velkými písmeny, jako to dělá editor systému"
    [E0109] LineTooLong "line-too-long" Error { length: usize }
        en "the line has {length} characters; the control reads 80"
        cs "řádek má {length} znaků; systém jich čte 80"
        help "break the line between two words: a block may go on in the next line, a comment may not" | "rozdělit řádek mezi dvěma slovy: blok smí pokračovat na dalším řádku, komentář ne"
    [W0110] TextAfterEnd "text-after-end" Warning { meant: AfterEndMeant }
        en (meant.message(Lang::En))
        cs (meant.message(Lang::Cs))
        help (meant.text(Lang::En)) | (meant.text(Lang::Cs))
    [E0111] StrayText "stray-text" Error { text: String, meant: TextMeant }
        en "`{text}` is text outside a comment"
        cs "„{text}“ je text mimo komentář"
        help (meant.text(Lang::En)) | (meant.text(Lang::Cs))
    [E0112] UnreadableFile "unreadable-file" Error { problem: crate::diag::Problem, file: Option<String> }
        en ({ let (file, reason) = (file.as_deref().unwrap_or("the file"), problem.text(Lang::En)); format!("{file} cannot be read: {reason}") })
        cs ({ let (file, reason) = (file.as_deref().unwrap_or("soubor"), problem.text(Lang::Cs)); format!("{file} nelze přečíst: {reason}") })
    [W0113] OtherControlProgram "other-control" Warning { control: OtherControl }
        en ({ let control = control.text(Lang::En); format!("this program is written for another control: {control}") })
        cs ({ let control = control.text(Lang::Cs); format!("program je napsán pro jiný řídicí systém: {control}") })
        help "let the postprocessor write it for this control; `cnc872c explain W0113` says what to change by hand"
           | "nechat ho vygenerovat postprocesorem pro tento systém; co změnit ručně, řekne „cnc872c explain W0113“"
        note "of each line only the first finding is shown; `-A other-control` shows all" | "z každého řádku je jen první hlášení; všechna ukáže volba -A other-control"
    [W0114] CommentSwallowsWords "comment-swallows-words" Warning { words: String }
        en "the comment has no closing quote and swallows `{words}`"
        cs "komentář bez koncových uvozovek spolkl „{words}“"
        help "if these are words of the program, close the comment before them; if they are a part of the comment, behind them"
           | "patří-li do programu, ukončit komentář uvozovkami před nimi; patří-li do komentáře, až za nimi"
    [E0115] Utf16 "utf-16" Error {}
        en "the file is in UTF-16; the control reads single bytes"
        cs "soubor je v kódování UTF-16; systém čte jednotlivé bajty"
        help "save it as UTF-8, or in the code page of the control" | "uložit ho jako UTF-8, nebo v kódové stránce systému"
    [W0116] OtherMeaning "other-meaning" Warning { meant: OtherMeaning, count: Option<i64> }
        en (meant.text(Lang::En))
        cs (meant.text(Lang::Cs))
        help (meant.help(*count, Lang::En)) | (meant.help(*count, Lang::Cs))

    [E0201] MissingProgramStart "missing-program-start" Error { number: u32 }
        en "no `%`: the control would ignore the whole file"
        cs "chybí %: systém by celý soubor přeskočil"
        help "begin the program with `%` and its number: `%{number}`" | "začít program znakem % a číslem: „%{number}“"
    [E0202] SecondProgramStart "second-program-start" Error { bare: bool }
        en "a second `%` in one file"
        cs "druhé % v jednom souboru"
        help (if *bare { "delete it: a program ends with M30 or M02, and the file with `*` or with nothing" } else { "one file holds one program; put the second into a file of its own, or write `%` in a comment only" })
           | (if *bare { "vymazat ho: program končí M30 nebo M02, soubor hvězdičkou nebo ničím" } else { "soubor obsahuje jeden program; druhý dát do vlastního souboru, jinak % psát jen v komentáři" })
    [E0203] WordOutsideBlock "word-outside-block" Error { word: String, more: usize, blocks: bool, number: i64 }
        en (match (blocks, more) { (false, _) => "the program has no block: no line begins with a block number".to_owned(), (true, 0) => format!("`{word}` comes before the first block"), (true, 1) => format!("`{word}` and another word come before the first block"), (true, _) => format!("`{word}` and {more} other words come before the first block") })
        cs (match (blocks, more) { (false, _) => "program nemá žádný blok: žádný řádek nezačíná číslem bloku".to_owned(), (true, 0) => format!("slovo {word} stojí před prvním blokem"), (true, _) => format!("slovo {word} a další ({more}) stojí před prvním blokem") })
        help (if word.starts_with('/') && *more == 0 && *blocks { format!("write `/` after the number of the block to skip: `N{number} /`") } else { format!("begin each block with its number: `N{number} {word}`") })
           | (if word.starts_with('/') && *more == 0 && *blocks { format!("psát / až za číslo bloku, který se má vynechat: „N{number} /“") } else { format!("každý blok začít jeho číslem: „N{number} {word}“") })
    [E0204] DuplicateBlockNumber "duplicate-block-number" Error { block: u32, last: Option<u32> }
        en (match last { Some(last) => format!("the blocks N{block} to N{last} are in this file twice"), None => format!("block number N{block} is used twice in this file") })
        cs (match last { Some(last) => format!("bloky N{block} až N{last} jsou v souboru dvakrát"), None => format!("číslo bloku N{block} je v souboru dvakrát") })
        help (if last.is_some() { "delete one of the copies, or renumber its blocks" } else { "give one of the blocks a number of its own" })
           | (if last.is_some() { "jednu kopii vymazat, nebo její bloky přečíslovat" } else { "jednomu z bloků dát jiné číslo" })
        note "subprograms count too: one file, one set of block numbers" | "platí i pro podprogramy: v jednom souboru smí být každé číslo bloku jen jednou"
    [E0205] MissingProgramEnd "missing-program-end" Error { skipped: bool, late: Option<u8>, instead: Option<u8>, unread: Option<UnreadEnd> }
        en (match (late, skipped) { _ if unread.is_some() => unread.map(|end| end.message(Lang::En)).unwrap_or_default(), (Some(m), _) => format!("the main program has no end: M{m:02} is after the subprograms"), (None, true) => "with block skip on, the end of the program is left out".to_owned(), (None, false) => "the program has no end: no block holds M02 or M30".to_owned() })
        cs (match (late, skipped) { _ if unread.is_some() => unread.map(|end| end.message(Lang::Cs)).unwrap_or_default(), (Some(m), _) => format!("hlavní program nemá konec: M{m:02} je až za podprogramy"), (None, true) => "při zapnutém vynechávání bloků se vynechá i konec programu".to_owned(), (None, false) => "program nemá konec: v žádném bloku není M02 ani M30".to_owned() })
        help (match (late, instead) { _ if unread.is_some() => unread.map(|end| end.unread.help(Lang::En).to_owned()).unwrap_or_default(), (Some(m), _) => format!("move the subprograms behind the block with M{m:02}"), (None, Some(m)) => format!("write M30 in place of M{m:02}, which does not end the program here"), (None, None) => "end the main program with a block of its own: `N… M30`".to_owned() })
           | (match (late, instead) { _ if unread.is_some() => unread.map(|end| end.unread.help(Lang::Cs).to_owned()).unwrap_or_default(), (Some(m), _) => format!("podprogramy přesunout za blok s M{m:02}"), (None, Some(m)) => format!("místo M{m:02}, které zde program neukončí, napsat M30"), (None, None) => "ukončit hlavní program samostatným blokem: „N… M30“".to_owned() })
    [E0206] BlockAfterProgramEnd "block-after-program-end" Error { block: u32, early: Option<EarlyEnd> }
        en "N{block} comes after the end of the program and belongs to no subprogram"
        cs "blok N{block} stojí za koncem programu a nepatří do žádného podprogramu"
        help (match early { Some(EarlyEnd { function, block }) => format!("the program ends in N{block} with M{function:02}: correct that function if another one is meant (`M03`?), or move the blocks before it"), None => "only subprograms (`G79 L…` to `G70`) may follow M02 or M30; move it before the end, or into a subprogram".to_owned() })
           | (match early { Some(EarlyEnd { function, block }) => format!("program končí už blokem N{block} s M{function:02}: je-li míněna jiná funkce („M03“?), opravit ji, jinak bloky přesunout před něj"), None => "za M02 nebo M30 smějí následovat jen podprogramy (od „G79 L…“ po „G70“); blok přesunout před konec, nebo do podprogramu".to_owned() })
    [E0207] UnterminatedSubprogram "unterminated-subprogram" Error { macrocycle: bool, skipped: bool, last: bool, instead: Option<u8>, unread: Option<Unread> }
        en ({ if let Some(Unread { line, .. }) = unread { let unit = if *macrocycle { "macrocycle" } else { "subprogram" }; format!("the {unit} has no end: G70 in line {line} is after `*`, which ends the file") } else { match (macrocycle, skipped, last) { (_, true, _) => "with block skip on, the G70 that ends this unit is left out", (true, false, _) => "the macrocycle has no end: no block holds G70", (false, false, true) => "the subprogram has no end: no block up to the end of the file holds G70", (false, false, false) => "the subprogram has no end: no block up to the next subprogram holds G70" }.to_owned() } })
        cs ({ if let Some(Unread { line, .. }) = unread { let unit = if *macrocycle { "makrocyklus" } else { "podprogram" }; format!("{unit} nemá konec: G70 na řádku {line} je až za hvězdičkou, která ukončuje soubor") } else { match (macrocycle, skipped, last) { (_, true, _) => "při zapnutém vynechávání bloků se vynechá i G70, které tento celek ukončuje", (true, false, _) => "makrocyklus nemá konec: v žádném bloku není G70", (false, false, true) => "podprogram nemá konec: až do konce souboru v žádném bloku není G70", (false, false, false) => "podprogram nemá konec: až po další podprogram v žádném bloku není G70" }.to_owned() } })
        help (match instead { _ if let Some(unread) = unread => unread.help(Lang::En).to_owned(), Some(m @ (2 | 30)) => format!("write G70 in place of M{m:02}, which ends the whole program"), Some(m) => format!("write G70 in place of M{m:02}, which does not return to the caller here"), None => "end it with a block that holds G70: `N… G70`".to_owned() })
           | (match instead { _ if let Some(unread) = unread => unread.help(Lang::Cs).to_owned(), Some(m @ (2 | 30)) => format!("místo M{m:02}, které ukončí celý program, napsat G70"), Some(m) => format!("místo M{m:02}, které se zde do volajícího programu nevrací, napsat G70"), None => "ukončit ho blokem s G70: „N… G70“".to_owned() })
    [E0208] CrowdedSubprogramStart "crowded-subprogram-start" Error { word: String, unnumbered: bool }
        en "`{word}` in the block that begins a subprogram"
        cs "slovo {word} stojí v úvodním bloku podprogramu"
        help (if *unnumbered { "begin the line with G79 with a block number: `N… G79 L…`" } else { "that block holds its number, G79 and L only: `N… G79 L…`; move the rest into the next block" })
           | (if *unnumbered { "řádek s G79 začít číslem bloku: „N… G79 L…“" } else { "v tomto bloku smí být jen číslo bloku, G79 a L: „N… G79 L…“; ostatní přesunout do dalšího bloku" })
    [E0209] DuplicateSubprogram "duplicate-subprogram" Error { l: u32 }
        en "subprogram L{l} is defined twice in the file"
        cs "podprogram L{l} je v souboru dvakrát"
        help "give one of them a number of its own" | "jednomu z nich dát jiné číslo"
    [E0210] TooManySubprograms "too-many-subprograms" Error {}
        en "more than 99 subprograms in one file"
        cs "v souboru je více než 99 podprogramů"
        help "make macrocycles of some of them: files of their own, called by G72" | "některé převést na makrocykly: samostatné soubory volané pomocí G72"
    [W0211] UnusedSubprogram "unused-subprogram" Warning { l: u32 }
        en "no G71 calls subprogram L{l}"
        cs "podprogram L{l} žádné G71 nevolá"
        help "call it with `G71 L{l}`, or delete it" | "zavolat ho pomocí „G71 L{l}“, nebo ho vymazat"
    [E0212] EndOutsideSubprogram "end-outside-subprogram" Error { finishing: bool }
        en (if *finishing { "G70 with the words of a turning cycle" } else { "G70 in the main program" })
        cs (if *finishing { "G70 se slovy soustružnického cyklu" } else { "G70 v hlavním programu" })
        help (if *finishing { "turning cycles do not exist here, G70 ends a subprogram: write the contour as blocks" } else { "G70 ends subprograms and macrocycles; the main program ends with M02 or M30" })
           | (if *finishing { "soustružnické cykly zde nejsou, G70 ukončuje podprogram: konturu vypsat po blocích" } else { "G70 ukončuje podprogramy a makrocykly; hlavní program končí M02 nebo M30" })
    [W0213] SkipBeforeBlockNumber "skip-before-block-number" Warning { block: u32, entry: bool }
        en (if *block == 0 { "this `/` belongs to the block before it".to_owned() } else { format!("this `/` belongs to block N{block}, before it") })
        cs (if *block == 0 { "toto / patří k předchozímu bloku".to_owned() } else { format!("toto / patří k předchozímu bloku N{block}") })
        help (if *entry { "delete it: a block with G79 cannot be skipped; to leave out a subprogram, write `/` in the block that calls it" } else { "write `/` after the number of the block to skip: `N… /`" })
           | (if *entry { "vymazat ho: blok s G79 vynechat nelze; má-li se vynechat podprogram, napsat / do bloku, který ho volá" } else { "psát / až za číslo bloku, který se má vynechat: „N… /“" })
    [W0214] EmptyBlock "empty-block" Warning { block: u32 }
        en "block N{block} is empty"
        cs "blok N{block} je prázdný"
        help "delete it, or say in a comment what it is for" | "vymazat ho, nebo v komentáři napsat, k čemu je"
    [W0215] ProgramEndInSubprogram "program-end-in-subprogram" Warning { function: u8 }
        en "M{function:02} in here ends the whole program, not only this unit"
        cs "M{function:02} zde ukončí celý program, nejen tento celek"
        help "end subprograms and macrocycles with G70" | "podprogramy a makrocykly ukončovat funkcí G70"
    [E0216] MacrocycleNumberMismatch "macrocycle-number-mismatch" Error { file: String, expected: u32, found: Option<u32> }
        en ({ let file = crate::diag::terminal_safe(file); match found { Some(l) => format!("the file {file} holds macrocycle L{l}"), None => format!("the macrocycle {file} does not begin with G79") } })
        cs ({ let file = crate::diag::terminal_safe(file); match found { Some(l) => format!("soubor {file} obsahuje makrocyklus L{l}"), None => format!("makrocyklus {file} nezačíná funkcí G79") } })
        help "its first block is `N… G79 L{expected}`" | "první blok má být „N… G79 L{expected}“"
    [E0217] DuplicateMacrocycle "duplicate-macrocycle" Error { l: u32, first: String, second: String }
        en ({ let (first, second) = (crate::diag::terminal_safe(first), crate::diag::terminal_safe(second)); format!("two files are macrocycle L{l}: {first} and {second}") })
        cs ({ let (first, second) = (crate::diag::terminal_safe(first), crate::diag::terminal_safe(second)); format!("makrocyklus L{l} je ve dvou souborech: {first} a {second}") })
        help "keep one of them on the search path" | "na cestě hledání nechat jen jeden"
    [E0218] BlockAfterMacrocycleEnd "block-after-macrocycle-end" Error { block: u32 }
        en "N{block} comes after the G70 that ends the macrocycle"
        cs "blok N{block} stojí za G70, které makrocyklus ukončuje"
        help "a macrocycle file holds one unit; move the block before G70, or into another file" | "soubor makrocyklu obsahuje jediný celek; blok přesunout před G70, nebo do jiného souboru"
    [W0219] SkippableStructure "skippable-structure" Warning { function: String }
        en "`/` in the block with {function}: with block skip on, the control goes on behind it"
        cs "/ v bloku s {function}: při zapnutém vynechávání bloků se pokračuje za ním"
        help "give {function} a block of its own without `/`" | "dát {function} do samostatného bloku bez /"
    [W0220] ProgramStartInMacrocycle "program-start-in-macrocycle" Warning {}
        en "a macrocycle file with a `%` line"
        cs "soubor makrocyklu s řádkem %"
        help "delete the `%` word: a macrocycle begins with `N… G79 L…`" | "slovo s % vymazat: makrocyklus začíná blokem „N… G79 L…“"
    [W0221] LineWithoutNumber "line-without-number" Warning { block: u32 }
        en (if *block == 0 { "the line does not begin with a block number: its words belong to the block above".to_owned() } else { format!("the line does not begin with a block number: its words belong to block N{block}") })
        cs (if *block == 0 { "řádek nezačíná číslem bloku: slova patří k bloku nad ním".to_owned() } else { format!("řádek nezačíná číslem bloku: slova patří k bloku N{block}") })
        help "begin a block of its own with `N…`, or move the words to the line of the block that they belong to"
           | "začít samostatný blok „N…“, nebo přesunout slova na řádek bloku, ke kterému patří"

    [W0222] ProgramNamedAsMacrocycle "program-named-as-macrocycle" Warning { l: u32 }
        en "a program in a file with the name of macrocycle L{l}"
        cs "program v souboru, který se jmenuje jako makrocyklus L{l}"
        help "give the file another name: the control calls L{l} by G72 and finds this program" | "soubor přejmenovat: volání G72 L{l} najde místo makrocyklu tento program"

    [E0301] UnknownAddress "unknown-address" Error { address: String, meant: AddressMeant }
        en "`{address}` is no address of this control"
        cs "{address} není adresa tohoto systému"
        help (meant.text(Lang::En)) | (meant.text(Lang::Cs))
    [E0302] ValueOutOfRange "value-out-of-range" Error { address: Address, range: String, mode: Option<GCode>, call: Option<String> }
        en ({ let under = mode.map_or_else(String::new, |mode| format!(" under {mode}")); format!("{address} takes {range}{under}") })
        cs ({ let range = range_cs(range); let under = mode.map_or_else(String::new, |mode| format!(" při {mode}")); format!("{address} má{under} rozsah {range}") })
        help (match call { Some(call) => format!("if a call is meant, write `{call}`"), None => other_range(*address, range, *mode, Lang::En).to_owned() })
           | (match call { Some(call) => format!("mělo-li to být volání, napsat „{call}“"), None => other_range(*address, range, *mode, Lang::Cs).to_owned() })
    [W0303] FinerThanResolution "finer-than-resolution" Warning { rounded: String }
        en "more than three decimals: the control takes {rounded}"
        cs "víc než tři desetinná místa: systém vezme {rounded}"
        help "write three decimals at most" | "psát nejvýše tři desetinná místa"
    [E0304] PointNotAllowed "decimal-point-not-allowed" Error { address: Address, meant: PointMeant }
        en (if meant.is_dwell() { "the dwell takes whole units of 10 ms".to_owned() } else { format!("{address} takes no decimal point") })
        cs (if meant.is_dwell() { "prodleva se zadává v celých jednotkách po 10 ms".to_owned() } else { format!("{address} nesmí mít desetinnou tečku") })
        help (meant.text(Lang::En)) | (meant.text(Lang::Cs))
    [E0305] SignNotAllowed "sign-not-allowed" Error { address: Address }
        en "{address} takes no sign"
        cs "{address} nesmí mít znaménko"
        help "write the number without it" | "napsat číslo bez něj"
    [E0306] DuplicateAddress "duplicate-address" Error { address: String, unnumbered: bool }
        en "`{address}` is written twice in this block"
        cs "{address} je v bloku dvakrát"
        help (if *unnumbered { unnumbered_line(Lang::En) } else { "keep one of them, or begin a new block with `N…`" })
           | (if *unnumbered { unnumbered_line(Lang::Cs) } else { "nechat jen jedno slovo, nebo začít nový blok „N…“" })
    [E0307] ConflictingG "conflicting-g-functions" Error { first: GCode, second: GCode, group: GGroup, unnumbered: bool }
        en (if first.group() == second.group() { format!("{first} and {second} are both of group {group}") } else { format!("{first} calls a macrocycle by the cycle map, and so the block cannot hold {second} as well") })
        cs (if first.group() == second.group() { format!("{first} a {second} jsou obě ze skupiny {group}") } else { format!("{first} volá makrocyklus podle mapy cyklů, {second} proto v bloku být nemůže") })
        help (if *unnumbered { unnumbered_line(Lang::En) } else { "one function of a group per block: delete one, or give it a block of its own" })
           | (if *unnumbered { unnumbered_line(Lang::Cs) } else { "z jedné skupiny smí být v bloku jediná funkce: jednu vymazat, nebo jí dát vlastní blok" })
    [E0308] ConflictingM "conflicting-m-functions" Error { first: u8, second: u8, group: u8, dialect: Dialect, unnumbered: bool }
        en (if first == second { format!("M{first:02} is written twice in this block") } else { format!("M{first:02} and M{second:02} are both of M group {group}") })
        cs (if first == second { format!("M{first:02} je v bloku dvakrát") } else { let of = of_group(*group); format!("M{first:02} a M{second:02} jsou obě {of} skupiny M funkcí") })
        help (if *unnumbered { unnumbered_line(Lang::En) } else { "one function of a group per block: delete one, or give it a block of its own" })
           | (if *unnumbered { unnumbered_line(Lang::Cs) } else { "z jedné skupiny smí být v bloku jediná funkce: jednu vymazat, nebo jí dát vlastní blok" })
        note (match (*group >= 10, dialect.has_channel_config()) { (true, true) => "functions that the machine builder added are in the groups that `channel-config` gives", (true, false) => "functions that the machine builder added are in the groups that R56–R59 of `machine-constants` give", (false, _) => "" })
           | (match (*group >= 10, dialect.has_channel_config()) { (true, true) => "funkce výrobce stroje jsou ve skupinách podle channel-config", (true, false) => "funkce výrobce stroje jsou ve skupinách podle R56–R59 v machine-constants", (false, _) => "" })
    [E0309] UnknownG "unknown-g-function" Error { number: u32 }
        en "G{number:02} is no function of this control"
        cs "G{number:02} není funkce tohoto systému"
        help (foreign_g(*number, Lang::En)) | (foreign_g(*number, Lang::Cs))
    [E0310] TooManyWords "too-many-words" Error { address: Address, limit: usize }
        en "more than {limit} `{address}` words in one block"
        cs "v bloku je více než {limit} slov {address}"
        help "share them out among several blocks" | "rozdělit je do více bloků"
    [E0311] UnknownAxis "unknown-axis" Error { axis: char, axes: String, limit: Option<usize> }
        en (match limit { Some(limit) => format!("axis {axis} is one too many: beside X, Y, Z the control has {limit} axes, one of the three A, B or C"), None => format!("this machine has no axis {axis}") })
        cs (match limit { Some(limit) => format!("osa {axis} je navíc: kromě X, Y, Z má systém {limit} osy a jedna z nich je A, B nebo C"), None => format!("stroj nemá osu {axis}") })
        help (if limit.is_some() { format!("the program uses {axes} before it; the axes of the machine are named under [[axes]] in cnc872c.toml") } else { format!("the configured axes are {axes}") })
           | (if limit.is_some() { format!("dřív program používá osy {axes}; osy stroje se uvádějí v [[axes]] v souboru cnc872c.toml") } else { format!("nastavené osy jsou {axes}") })
    [E0312] CorrectionDigits "length-correction-digits" Error {}
        en "`&` takes four digits, each 0, 1 or 2"
        cs "& má čtyři číslice, každou 0, 1 nebo 2"
        help "write four digits, each 0, 1 or 2; for example `&0010`" | "zadat čtyři číslice, každou 0, 1 nebo 2; například „&0010“"

    [E0401] MissingTarget "missing-target" Error { function: GCode, meant: TargetMeant }
        en "{function} without `L`"
        cs "{function} bez L"
        help (meant.text(Lang::En)) | (meant.text(Lang::Cs))
        note (meant.note(*function, Lang::En)) | (meant.note(*function, Lang::Cs))
    [W0402] UnusedTarget "unused-target" Warning { meant: UnusedMeant }
        en "`L` has no use in this block"
        cs "L zde nemá význam"
        help (meant.text(Lang::En)) | (meant.text(Lang::Cs))
    [W0403] UnusedRepeat "unused-repeat" Warning {}
        en "`Q` has no use in this block"
        cs "Q zde nemá význam"
        help "`Q` goes with G71, G72, G73 or, as the dwell time, with G04" | "Q patří ke G71, G72, G73 nebo jako délka prodlevy ke G04"
    [E0404] UnknownSubprogram "unknown-subprogram" Error { l: u32, near: Option<u32>, macrocycle: bool, from_macrocycle: bool, without_entry: Option<u32>, uncalled: Option<u32>, unread: Option<Unread>, block: bool }
        en (if let Some(Unread { line, .. }) = unread { format!("subprogram L{l} in line {line} is after `*`, which ends the file") } else if *from_macrocycle { format!("a macrocycle cannot call subprogram L{l}: subprograms belong to the program's file") } else { format!("there is no subprogram L{l} in this file") })
        cs (if let Some(Unread { line, .. }) = unread { format!("podprogram L{l} na řádku {line} je až za hvězdičkou, která ukončuje soubor") } else if *from_macrocycle { format!("makrocyklus nemůže volat podprogram L{l}: podprogramy patří k souboru programu") } else { format!("podprogram L{l} v souboru není") })
        help (match without_entry { _ if let Some(unread) = unread => unread.help(Lang::En).to_owned(), Some(block) => format!("if it begins with N{block}, put a block before it: `N… G79 L{l}`"), None if let Some(other) = uncalled => format!("nothing calls L{other}: if it is meant, write `G79 L{l}` where it begins, or `G71 L{other}` in the calls"), None if *macrocycle => format!("L{l} is a macrocycle: call it with `G72 L{l}`"), None if *block => format!("N{l} is a block here: jump to it with `G73 L{l}`"), None if *from_macrocycle => "call a macrocycle with G72".to_owned(), None => nearest(near.as_ref(), "the nearest one is `G71 L", "`") })
           | (match without_entry { _ if let Some(unread) = unread => unread.help(Lang::Cs).to_owned(), Some(block) => format!("začíná-li blokem N{block}, doplnit před něj blok „N… G79 L{l}“"), None if let Some(other) = uncalled => format!("L{other} nic nevolá: je-li míněn, napsat na jeho začátku „G79 L{l}“, nebo ve voláních „G71 L{other}“"), None if *macrocycle => format!("L{l} je makrocyklus: zavolat ho pomocí „G72 L{l}“"), None if *block => format!("N{l} je zde blok: skok na něj je „G73 L{l}“"), None if *from_macrocycle => "volat makrocyklus pomocí G72".to_owned(), None => nearest(near.as_ref(), "nejbližší je „G71 L", "“") })
    [E0405] UnknownMacrocycle "unknown-macrocycle" Error { l: u32, searched: String, subprogram: bool, calls: usize, near: Option<u32>, block: bool }
        en (if *calls > 1 { format!("macrocycle L{l} is not on the search path; {calls} blocks call it") } else { format!("macrocycle L{l} is not on the search path") })
        cs (if *calls > 1 { format!("makrocyklus L{l} se nenašel; program ho volá {calls}×") } else { format!("makrocyklus L{l} se nenašel") })
        help (match (subprogram, near) { (true, _) => format!("L{l} is a subprogram of this file: call it with `G71 L{l}`"), _ if *block => format!("N{l} is a block here: jump to it with `G73 L{l}`"), (false, Some(near)) => format!("the nearest one is `G72 L{near}`; if L{l} is meant, name its folder with `-L` or under `macrocycles` in cnc872c.toml"), (false, None) => format!("name its folder with `-L` or under `macrocycles` in cnc872c.toml; if only the machine has it, `L{l} = {{}}` under `[machine-macrocycles]` there") })
           | (match (subprogram, near) { (true, _) => format!("L{l} je podprogram tohoto souboru: zavolat ho pomocí „G71 L{l}“"), _ if *block => format!("N{l} je zde blok: skok na něj je „G73 L{l}“"), (false, Some(near)) => format!("nejbližší je „G72 L{near}“; je-li míněno L{l}, uvést jeho složku volbou -L nebo v macrocycles v souboru cnc872c.toml"), (false, None) => format!("uvést jeho složku volbou -L nebo v macrocycles v souboru cnc872c.toml; má-li ho jen stroj, zapsat tam v [machine-macrocycles] L{l} = {{}}") })
        note ({ let searched = crate::diag::terminal_safe(searched); format!("searched: {searched}") }) | ({ let searched = crate::diag::terminal_safe(searched); format!("hledalo se v: {searched}") })
    [E0406] UnknownJumpTarget "unknown-jump-target" Error { l: u32, near: Option<u32>, line: Option<u32>, subprogram: bool }
        en "there is no block N{l} to jump to"
        cs "blok N{l}, na který se má skočit, neexistuje"
        help (match (line, near) { (Some(line), _) => format!("line {line} begins with {l}, but not with `N`: write `N{l}` there"), (None, Some(n)) => format!("the nearest block of this unit is N{n}: `G73 L{n}`"), (None, None) if *subprogram => format!("L{l} is a subprogram here: call it with `G71 L{l}`"), (None, None) => String::new() })
           | (match (line, near) { (Some(line), _) => format!("řádek {line} začíná číslem {l} bez N: napsat tam „N{l}“"), (None, Some(n)) => format!("nejbližší blok tohoto celku je N{n}: „G73 L{n}“"), (None, None) if *subprogram => format!("L{l} je zde podprogram: zavolat ho pomocí „G71 L{l}“"), (None, None) => String::new() })
    [E0407] JumpOutOfUnit "jump-out-of-unit" Error { l: u32 }
        en "block N{l} is in another unit of the program"
        cs "blok N{l} je v jiném programovém celku"
        help "a jump stays in its main program, subprogram or macrocycle; to run another unit call it with G71 or G72"
           | "skákat se smí jen uvnitř hlavního programu, podprogramu nebo makrocyklu; jiný celek volat pomocí G71 nebo G72"
    [E0408] RecursiveCall "recursive-call" Error { ring: String }
        en "this call leads back to a unit that is still running: {ring}"
        cs "toto volání vede zpět do celku, který ještě běží: {ring}"
        help "break the ring; to repeat something, use `Q` or a jump with G73" | "kruh přerušit; k opakování slouží Q nebo skok G73"
    [E0409] NestingTooDeep "nesting-too-deep" Error { limit: u32 }
        en "more than {limit} calls are open at once"
        cs "otevřených volání je více než {limit}"
        help "call fewer units from within one another" | "volat méně celků jeden z druhého"
    [E0410] ExpansionLimit "expansion-limit" Error { limit: u64, repeats: String }
        en ({ let (count, noun) = (grouped(*limit, ','), if *limit == 1 { "block" } else { "blocks" }); format!("the program executes more than {count} {noun}") })
        cs ({ let (count, noun) = (grouped(*limit, ' '), blocks_cs(*limit)); format!("program provede více než {count} {noun}") })
        help "if intended, raise `records` under [limits], or `--max-blocks`" | "je-li to záměr, zvýšit records v [limits], nebo --max-blocks"
        note (if repeats.is_empty() { String::new() } else { format!("what multiplies here: {repeats}") })
           | (if repeats.is_empty() { String::new() } else { format!("co se zde násobí: {repeats}") })
    [E0411] MissingDwell "missing-dwell" Error { meant: DwellMeant }
        en "G04 without `Q`"
        cs "G04 bez Q"
        help (meant.text(Lang::En)) | (meant.text(Lang::Cs))
    [W0412] DwellTakesRepeat "dwell-takes-repeat" Warning { function: GCode }
        en "`Q` is the dwell of G04 here, not the repeats of {function}"
        cs "Q je zde délka prodlevy G04, ne počet opakování {function}"
        help "the {function} is done once; give G04 a block of its own" | "{function} se provede jednou; G04 dát do samostatného bloku"
    [E0413] FlowAfterEnd "flow-after-end" Error { function: GCode }
        en "{function} in the block that ends the program"
        cs "{function} v bloku, který ukončuje program"
        help "give M02 or M30 a block of its own" | "M02 nebo M30 dát do samostatného bloku"
    [W0414] SubprogramCallsSubprogram "subprogram-calls-subprogram" Warning { l: Option<u32> }
        en "a subprogram calls another one with G71"
        cs "podprogram volá pomocí G71 další podprogram"
        help "make the called one a macrocycle and call it with G72" | "z volaného udělat makrocyklus a volat ho pomocí G72"
        note "the manual describes G71 in the main program only; not every machine may follow" | "příručka popisuje G71 jen v hlavním programu; ne každý stroj to musí umět"

    [E0501] ParameterNumber "parameter-number" Error {}
        en "there are parameters R0 to R95 only"
        cs "parametry jsou jen R0 až R95"
        help "use a number from 0 to 95, without sign and decimal point" | "použít číslo 0 až 95, bez znaménka a desetinné tečky"
    [W0502] ReservedParameter "reserved-parameter" Warning {}
        en "R95 is reserved for control functions"
        cs "R95 je vyhrazen pro řídicí funkce"
        help "use another parameter" | "použít jiný parametr"
    [W0503] UnassignedParameter "unassigned-parameter" Warning { parameter: u8, compiled: bool }
        en "R{parameter} is read before the program gives it a value"
        cs "R{parameter} se čte dřív, než mu program dal hodnotu"
        help "assign it first: `R{parameter}=…`, or give the machine's value with `--param R{parameter}=…`" | "nejdřív přiřadit: „R{parameter}=…“, nebo zadat hodnotu ze stroje volbou --param R{parameter}=…"
        note (if *compiled { "its value comes from the machine's parameter table: without it nothing is written from here on" } else { "its value comes from the machine's parameter table: what depends on it is not checked" })
           | (if *compiled { "hodnota pochází z tabulky parametrů stroje: bez ní se od tohoto bloku nic nezapíše" } else { "hodnota pochází z tabulky parametrů stroje: co na ní závisí, se nezkontroluje" })
    [W0504] AssignedAndRead "assigned-and-read" Warning { parameter: u8 }
        en "R{parameter} is read here and assigned in the same block: the old value counts"
        cs "R{parameter} se v témže bloku čte i přiřazuje: platí stará hodnota"
        help "assign it in a block before, or after" | "přiřadit ho v bloku před tím, nebo za tím"
    [E0505] MissingControlWord "missing-control-word" Error { function: GCode, missing: String, reference: bool }
        en "{function} needs {missing} in its block"
        cs "{function} potřebuje v bloku {missing}"
        help ({ let first = missing.split(',').next().sure(); if *reference { "the reference point is approached by G30".to_owned() } else { format!("write each control word in the same block, its eight digits oo aa bb rr together: `{first}=…`") } })
           | ({ let first = missing.split(',').next().sure(); if *reference { "do reference se najíždí funkcí G30".to_owned() } else { format!("každé řídicí slovo napsat do téhož bloku, osm číslic oo aa bb rr bez mezer: „{first}=…“") } })
        note (if *function == GCode::G28 { "G26 to G29 compute with parameters" } else { "" })
           | (if *function == GCode::G28 { "G26 až G29 počítají s parametry" } else { "" })
    [W0506] SuperfluousControlWord "superfluous-control-word" Warning { function: GCode, parameter: u8 }
        en "{function} does not use R{parameter}"
        cs "{function} R{parameter} nepoužije"
        help "delete it, or use the function with more operations" | "vymazat ho, nebo použít funkci s více operacemi"
    [E0507] MalformedControlWord "malformed-control-word" Error { field: Option<i64> }
        en (match field { Some(number) => format!("the control word names parameter R{number}; there are R0 to R95"), None => "a control word is a whole number of at most eight digits".to_owned() })
        cs (match field { Some(number) => format!("řídicí slovo uvádí parametr R{number}; jsou jen R0 až R95"), None => "řídicí slovo je celé číslo nejvýše o osmi číslicích".to_owned() })
        help "its digits are `oo aa bb rr`: operation, first operand, second operand, result" | "číslice jsou „oo aa bb rr“: operace, první operand, druhý operand, výsledek"
    [E0508] UnknownOperation "unknown-operation" Error { operation: i64, digits: i64, written: usize }
        en "the configuration does not say what operation {operation:02} means"
        cs "význam kódu operace {operation:02} není v konfiguraci uveden"
        help (if *written > 8 { "a control word has eight digits: `oo aa bb rr`".to_owned() } else { format!("if the control word is right, add the code to cnc872c.toml, by the machine's manual: `[operations]`, `\"{operation:02}\" = \"…\"`") })
           | (if *written > 8 { "řídicí slovo má osm číslic: „oo aa bb rr“".to_owned() } else { format!("je-li řídicí slovo správně, doplnit kód do cnc872c.toml podle příručky stroje: [operations], \"{operation:02}\" = \"…\"") })
        note ({ let split = control_digits(*digits); if *written > 8 { format!("{written} digits are written; they are read as {split}: operation, first operand, second operand, result") } else { format!("the control word is read as {split}: operation, first operand, second operand, result") } })
           | ({ let split = control_digits(*digits); if *written > 8 { format!("je zapsáno {written} číslic; čtou se jako {split}: operace, první operand, druhý operand, výsledek") } else { format!("řídicí slovo se čte jako {split}: operace, první operand, druhý operand, výsledek") } })
    [E0509] ArithmeticError "arithmetic-error" Error { what: ArithmeticFault }
        en (what.text(Lang::En))
        cs (what.text(Lang::Cs))
    [E0510] UnusableParameterValue "unusable-parameter-value" Error { address: Address, parameter: u8, value: String, needs: ParameterNeed }
        en ({ let needs = needs.text(*address, Lang::En); if value.is_empty() { needs } else { format!("R{parameter} is {value}, but {needs}") } })
        cs ({ let needs = needs.text(*address, Lang::Cs); if value.is_empty() { needs } else { format!("R{parameter} má hodnotu {value}, ale {needs}") } })
    [E0511] ParameterNotAllowed "parameter-not-allowed" Error { address: Address }
        en "`{address}` takes a number, not a parameter"
        cs "za {address} musí být číslo, ne parametr"

    [W0601] MissingFeed "missing-feed" Warning { thread: bool }
        en (if *thread { "a thread is cut before the program sets a feed" } else { "working motion before the program sets a feed" })
        cs (if *thread { "řezání závitu dřív, než program zadal posuv" } else { "pracovní pohyb dřív, než program zadal posuv" })
        help "write `F` in this block or before it; otherwise the feed of the program before stays in force" | "zadat F v tomto bloku nebo před ním; jinak platí posuv z předchozího programu"
    [E0602] MissingArcCenter "missing-arc-center" Error { radius_word: bool, by: Option<String> }
        en "an arc without its centre: `I` and `J` are missing or zero"
        cs "oblouk bez středu: I a J chybí nebo jsou nulové"
        help "write the distances from the start to the centre: `I` along the first axis of the arc, `J` along the second" | "doplnit vzdálenosti od začátku oblouku ke středu: I v první ose oblouku, J ve druhé"
        note (match (by, *radius_word) {
                (_, true) => "`R` is a parameter on this control, never a radius".to_owned(),
                (Some(by), false) => format!("it is an arc because {by} is in force"),
                (None, false) => String::new(),
            })
           | (match (by, *radius_word) {
                (_, true) => "R je v tomto systému parametr, nikdy poloměr".to_owned(),
                (Some(by), false) => format!("obloukem je proto, že platí {by}"),
                (None, false) => String::new(),
            })
    [E0603] ArcRadiusMismatch "arc-radius-mismatch" Error { start: String, end: String, points: Box<ArcPoints>, meant: ArcMeant }
        en "the radius is {start} at the start of the arc and {end} at its end"
        cs "poloměr na začátku oblouku je {start}, na konci {end}"
        help (points.help(meant, Lang::En)) | (points.help(meant, Lang::Cs))
        note (points.text(Lang::En)) | (points.text(Lang::Cs))
    [W0604] MissingSpindleSpeed "missing-spindle-speed" Warning { function: GCode }
        en "working motion under {function} before the program sets a spindle speed"
        cs "pracovní pohyb při {function} dřív, než program zadal otáčky"
        help "write `S` in this block or before it" | "zadat S v tomto bloku nebo před ním"
    [W0605] IncrementalFromUnknown "incremental-from-unknown" Warning { axis: char }
        en "{axis} moves by a distance from a position that the program does not know"
        cs "osa {axis} se pohybuje přírůstkem z polohy, kterou program nezná"
        help "program {axis} absolutely (G90) first" | "nejdřív najet osou {axis} absolutně (G90)"
    [W0606] ArcFromUnknown "arc-from-unknown" Warning { axes: String }
        en "the arc starts from a position that is not known ({axes})"
        cs "oblouk začíná v poloze, kterou program nezná ({axes})"
        help "program {axes} absolutely (G90) before the arc" | "před obloukem najet absolutně (G90) osami: {axes}"
    [E0607] SpeedOutsideGear "speed-outside-gear" Error { s: u32, m: u8, min: u32, max: u32, g97: bool }
        en "S{s} is outside range M{m}, which is {min}–{max} rev/min"
        cs "S{s} je mimo rozsah M{m}, tedy {min}–{max} ot/min"
        help (if *g97 { "change the speed, program another range, or let M40 choose it; if S is a cutting speed under G97, set `g97 = \"per-revolution\"`" } else { "change the speed, program another range, or let M40 choose it" })
           | (if *g97 { "změnit otáčky, zadat jiný rozsah, nebo ho nechat vybrat funkcí M40; je-li S při G97 řezná rychlost, nastavit g97 = \"per-revolution\"" } else { "změnit otáčky, zadat jiný rozsah, nebo ho nechat vybrat funkcí M40" })
    [E0608] OrientedStopUnavailable "oriented-stop-unavailable" Error {}
        en "this machine is configured without the oriented stop M19"
        cs "stroj nemá podle konfigurace orientovaný stop M19"
        help "use M05; when the machine has it, set `oriented-stop = true`" | "použít M05; má-li ho stroj, nastavit oriented-stop = true"
    [E0609] CenterWordNotUsable "center-word-not-usable" Error { letters: String, place: CenterPlace, written: String }
        en (unused_centers(letters, place, Lang::En))
        cs (unused_centers(letters, place, Lang::Cs))
        help (center_help(letters, written, Lang::En)) | (center_help(letters, written, Lang::Cs))
    [W0610] ArcAfterOriginChange "arc-after-origin-change" Warning {}
        en "an arc right after a change of origin or correction: its start is not where the tool is"
        cs "oblouk hned po změně počátku nebo korekce: nezačíná tam, kde stojí nástroj"
        help "move by a straight line (G00, G01) first" | "nejdřív zařadit přímkový pohyb (G00, G01)"
    [E0611] ArcAxes "arc-axes" Error { plane: String, many: bool }
        en (if *many { "an arc takes at most three axis words".to_owned() } else { format!("the axis words of the arc do not fit the plane {plane} in force") })
        cs (if *many { "oblouk smí mít nejvýše tři slova os".to_owned() } else { format!("slova os oblouku nesouhlasí s platnou rovinou {plane}") })
        help "write both axes of the plane, and one more at most for a helix; here G18 is YZ and G19 is ZX" | "uvést obě osy roviny a pro šroubovici nejvýše jednu další; G18 je zde YZ a G19 je ZX"
    [W0612] FunctionNotModelled "function-not-modelled" Warning { what: Unmodelled }
        en (what.message(Lang::En))
        cs (what.message(Lang::Cs))
        help (what.help(Lang::En)) | (what.help(Lang::Cs))
    [W0613] HelixWithoutG09 "helix-without-g09" Warning {}
        en "an arc with a third axis, but G09 is not in force"
        cs "oblouk s třetí osou, ale neplatí G09"
        help "program G09 for a helix, or move the third axis in a block of its own" | "pro šroubovici zadat G09, nebo třetí osou jet v samostatném bloku"
    [E0614] SpindleTurn "spindle-turn" Error { axis: char, fault: SpindleFault }
        en ({ let why = fault.text(Lang::En); format!("axis {axis} is the spindle: {why}") })
        cs ({ let why = fault.text(Lang::Cs); format!("osa {axis} je vřeteno: {why}") })
        help (fault.help(Lang::En)) | (fault.help(Lang::Cs))
    [W0615] FeedUnitChanged "feed-unit-changed" Warning { feed: String, function: GCode, written: FeedPer, now: FeedPer }
        en ({ let (written, now) = (written.unit().en, now.unit().en); format!("F{feed} was written as {written}, and {function} takes it as {feed} {now}") })
        cs ({ let (written, now) = (written.unit().cs, now.unit().cs); format!("F{feed} bylo zadáno v {written} a při {function} platí jako {feed} {now}") })
        help "write `F` anew in the block with {function} or before this motion" | "zadat F znovu v bloku s {function}, nebo před tímto pohybem"
    [W0616] PlaneMismatch "plane-mismatch" Warning { plane: Plane, fault: PlaneFault, meant: Option<Plane> }
        en ({ let why = fault.text(Lang::En); let name = plane.name; format!("{} is the plane {name} here: {why}", plane.function) })
        cs ({ let why = fault.text(Lang::Cs); let name = plane.name; format!("{} je zde rovina {name}: {why}", plane.function) })
        help (meant.map_or_else(String::new, |meant| format!("the plane {} is {}", meant.name, meant.function)))
           | (meant.map_or_else(String::new, |meant| format!("rovina {} je {}", meant.name, meant.function)))
        note "the planes serve the radius corrections G41 and G42; G18 and G19 are the reverse of ISO" | "roviny slouží poloměrovým korekcím G41 a G42; G18 a G19 jsou proti ISO prohozené"
    [W0617] NoGearForSpeed "no-gear-for-speed" Warning { s: u32, gears: String }
        en "S{s} is in no spindle range, so M40 chooses none"
        cs "otáčky S{s} nespadají do žádného rozsahu, M40 tedy žádný nevybere"
        help "program a speed that a range holds: {gears}" | "zadat otáčky, které některý rozsah má: {gears}"
    [W0618] CorrectionWithoutEntry "correction-without-entry" Warning { function: GCode }
        en "{function} before the program chooses a correction `D`"
        cs "{function} dřív, než program zvolil korekci D"
        help "write `D` with the number of the tool's correction in this block or before it" | "zadat D s číslem korekce nástroje v tomto bloku nebo před ním"
    [W0619] SpindleStopped "spindle-stopped" Warning { thread: bool }
        en (if *thread { "a thread is cut while the spindle is stopped (M05)" } else { "a working motion while the spindle is stopped (M05)" })
        cs (if *thread { "řezání závitu při zastaveném vřetenu (M05)" } else { "pracovní pohyb při zastaveném vřetenu (M05)" })
        help "start the spindle with M03 or M04 first" | "nejdřív spustit vřeteno funkcí M03 nebo M04"
    [W0620] ToolChangeWithoutTool "tool-change-without-tool" Warning {}
        en "M06 before the program names a tool"
        cs "M06 dřív, než program zvolil nástroj"
        help "write `T` with the number of the tool in this block or before it" | "zadat T s číslem nástroje v tomto bloku nebo před ním"
    [W0621] OutsideTravel "outside-travel" Warning { axis: char, value: String, limit: String, above: bool }
        en (if *above { format!("{axis}{value} is beyond the travel of the axis, which ends at {limit}") } else { format!("{axis}{value} is beyond the travel of the axis, which begins at {limit}") })
        cs (if *above { format!("{axis}{value} je mimo rozsah pohybu osy, který končí na {limit}") } else { format!("{axis}{value} je mimo rozsah pohybu osy, který začíná na {limit}") })
        help "check the value, G90 or G91, and the origin; the travel is `min` and `max` of the axis in the project file" | "zkontrolovat hodnotu, G90 nebo G91 a počátek; rozsah je min a max osy v projektovém souboru"
    [W0622] SpindleSpeedZero "spindle-speed-zero" Warning { m: u8, zero: bool }
        en (if *zero { format!("a working motion under M{m:02} at S0: the spindle does not turn") } else { format!("a working motion under M{m:02} before the program sets the spindle speed it writes later") })
        cs (if *zero { format!("pracovní pohyb při M{m:02} a S0: vřeteno se netočí") } else { format!("pracovní pohyb při M{m:02} dřív, než program zadal otáčky, které jsou až dál") })
        help "write the speed `S` before this motion" | "zadat otáčky S před tímto pohybem"
    [W0623] FunctionWithoutMeaning "function-without-meaning" Warning { m: u8, feed: bool }
        en (if *feed { format!("M{m} does nothing on CNC872, where CNC8x6 and CNC8x9 take the feed by it: it stays as programmed") } else { format!("the ChannelConfig does not define M{m}") })
        cs (if *feed { format!("M{m} na CNC872 nic nedělá: posuv, který mění na CNC8x6 a CNC8x9, zůstává, jak je programován") } else { format!("ChannelConfig funkci M{m} nedefinuje") })
        help (if *feed { "write the feed itself; when the machine has the function, list it in `MFunctions`" } else { "check the number, or list the function in `MFunctions`" }) | (if *feed { "zadat přímo posuv; má-li stroj tuto funkci, uvést ji v MFunctions" } else { "zkontrolovat číslo, nebo funkci uvést v MFunctions" })
    [W0624] CorrectionOnArc "correction-on-arc" Warning { function: GCode, sides: bool }
        en (if *sides { format!("{function} changes the side of the radius correction without G40 between") } else { format!("the radius correction changes ({function}) on an arc") })
        cs (if *sides { format!("{function} mění stranu poloměrové korekce bez G40") } else { format!("poloměrová korekce se mění ({function}) na oblouku") })
        help (if *sides { "end the correction with G40 and a straight motion first" } else { "begin and end the correction on a straight motion (G00, G01)" }) | (if *sides { "nejdřív korekci ukončit funkcí G40 a přímkovým pohybem" } else { "korekci zapínat a vypínat na přímce (G00, G01)" })
    [W0625] CorrectionLeftOn "correction-left-on" Warning { function: GCode, m: u8 }
        en "M{m:02} while the radius correction {function} is in force"
        cs "M{m:02} při zapnuté poloměrové korekci {function}"
        help "end the correction with G40 and a straight motion before" | "před tím korekci ukončit funkcí G40 a přímkovým pohybem"
    [W0626] CycleBlockPlunges "cycle-block-plunges" Warning { cycle: GCode, axis: char, l: u32 }
        en "the block itself moves {axis} in rapid (G00), before {cycle} calls L{l}"
        cs "blok sám najede osou {axis} rychloposuvem (G00), ještě než {cycle} zavolá L{l}"
        help "leave {axis} out of the block and give the depth as L{l} reads it, such as in a parameter" | "osu {axis} v bloku vynechat a hloubku zadat tak, jak ji L{l} čte, například v parametru"
    [W0627] CycleOverToolChange "cycle-over-tool-change" Warning { cycle: GCode }
        en "M06 while the fixed cycle {cycle} is in force"
        cs "M06 při zapnutém pevném cyklu {cycle}"
        help "end the cycle with G80 before the tool change" | "před výměnou nástroje cyklus ukončit funkcí G80"
    [W0628] ToolNotChanged "tool-not-changed" Warning { t: String }
        en "T{t} is named, and no M06 follows"
        cs "T{t} je zvolen a žádné M06 po něm nenásleduje"
        help "`T` only names the tool: change it with M06" | "T nástroj jen volí: vymění ho M06"
    [W0629] ArcTurnsBack "arc-turns-back" Warning { function: GCode, meant: GCode, count: u64 }
        en "the path turns back at both ends of the arc; {meant} would join both neighbours smoothly"
        cs "dráha se na obou koncích oblouku obrací; {meant} by na sousední bloky navázal hladce"
        help "check the direction: {function} or {meant}" | "zkontrolovat směr: {function}, nebo {meant}"
        note (times(*count, Lang::En)) | (times(*count, Lang::Cs))
    [W0630] TableWithoutValues "table-without-values" Warning { function: GCode }
        en "{function} without axis words writes nothing"
        cs "{function} bez slov os nic nezapíše"
        help "write the axes with their values in this block, or delete {function}" | "zadat v tomto bloku osy s hodnotami, nebo {function} vymazat"

    [E0701] UnreadableConfiguration "unreadable-configuration" Error { reason: ConfigProblem }
        en ({ let why = reason.text(Lang::En); format!("the configuration cannot be read: {why}") })
        cs ({ let why = reason.text(Lang::Cs); format!("konfiguraci nelze přečíst: {why}") })
    [E0702] ConfigurationValue "configuration-value" Error { key: String, needs: ConfigNeed }
        en ({ let needs = needs.text(Lang::En); format!("`{key}` {needs}") })
        cs ({ let needs = needs.text(Lang::Cs); format!("{key} {needs}") })
    [E0703] MFunctionFixed "m-function-fixed" Error { m: u8, group: u8 }
        en "M{m:02} is a standard function and cannot leave M group {group}"
        cs "M{m:02} je pevně přiřazená funkce a nelze ji vyřadit z {group}. skupiny"
        help "write GroupNo=\"{group}\", or leave GroupNo out; the other attributes may be set" | "napsat GroupNo=\"{group}\", nebo GroupNo vynechat; ostatní atributy nastavit lze"
    [E0704] MFunctionRepeated "m-function-repeated" Error { m: u8 }
        en "M{m:02} is configured twice with different data"
        cs "M{m:02} je nastavena dvakrát s různými údaji"
        help "keep one of the two elements" | "ponechat jen jeden z obou elementů"
    [W0705] UnknownConfigurationKey "unknown-configuration-key" Warning { kind: NameKind, key: String, near: Option<String>, known: Option<KnownNames> }
        en ({ let kind = kind.text(Lang::En); format!("unknown {kind} `{key}`") })
        cs ({ let kind = kind.text(Lang::Cs); format!("neznámý {kind} „{key}“") })
        help (nearest(near.as_ref(), "perhaps `", "` is meant")) | (nearest(near.as_ref(), "možná mělo být „", "“"))
        note (known_names(known.as_ref(), near.as_deref(), Lang::En)) | (known_names(known.as_ref(), near.as_deref(), Lang::Cs))
    [E0706] MachineConstant "machine-constant" Error { constant: String, problem: ConstantProblem }
        en ({ let what = problem.text(Lang::En); format!("machine constant {constant} {what}") })
        cs ({ let what = problem.text(Lang::Cs); format!("strojní konstanta {constant} {what}") })
    [W0707] ConstantNotUsed "constant-not-used" Warning { name: String, why: NotUsed }
        en (why.message(name, Lang::En))
        cs (why.message(name, Lang::Cs))
        note (why.note(Lang::En)) | (why.note(Lang::Cs))
    [W0708] NoMFunctions "no-m-functions" Warning {}
        en "this ChannelConfig holds no `MFunctions`: it sets no M function"
        cs "tento ChannelConfig neobsahuje MFunctions: žádnou M funkci nenastaví"
        help "name the ChannelConfig that the control reads, or leave `channel-config` out" | "zadat ten ChannelConfig, který čte systém, nebo channel-config vynechat"

    [W0801] ContinuityBroken "continuity-broken" Warning { n: u32, with: u32, reason: JointBreak, count: u64 }
        en ({ let why = reason.text(Lang::En); format!("continuous motion from N{with} to N{n} is broken: {why}") })
        cs ({ let why = reason.text(Lang::Cs); format!("plynulá návaznost N{with} a N{n} je porušena: {why}") })
        note (times(*count, Lang::En)) | (times(*count, Lang::Cs))
    [W0802] SlowJoint "slow-joint" Warning { n: u32, with: u32, feed: String, programmed: String, limit: JointLimit, count: u64 }
        en ({ let by = limit.text(Lang::En); format!("from N{with} to N{n} the velocity drops to {feed} of {programmed} mm/min: {by}") })
        cs ({ let by = limit.text(Lang::Cs); format!("mezi N{with} a N{n} klesne rychlost na {feed} z {programmed} mm/min: {by}") })
        note (times(*count, Lang::En)) | (times(*count, Lang::Cs))
    [W0803] NoRoomToStop "no-room-to-stop" Warning { n: u32, length: String, feed: String, needs: String, count: u64 }
        en "N{n} is too short to stop in: {length} mm, and from {feed} mm/min it takes {needs} mm"
        cs "N{n} je na zastavení příliš krátký: má {length} mm a z {feed} mm/min je potřeba {needs} mm"
        help "program a lower feed before it, or a longer last block" | "naprogramovat před ním menší posuv, nebo delší poslední blok"
        note (no_room_note(*count, Lang::En)) | (no_room_note(*count, Lang::Cs))
    [W0804] TightBlockTooShort "tight-block-too-short" Warning { n: u32, duration: String, least: u32, count: u64 }
        en "N{n} takes {duration} ms; in G24 blocks join tightly from {least} ms on"
        cs "N{n} trvá {duration} ms; při G24 se těsně napojují bloky od {least} ms"
        help "write longer blocks there, or a lower feed" | "psát tam delší bloky, nebo menší posuv"
        note (times(*count, Lang::En)) | (times(*count, Lang::Cs))
    [W0811] CorrectionCollides "correction-collides" Warning { d: u32, radius: String, arc: Option<String> }
        en (match arc { Some(arc) => format!("the arc of radius {arc} is smaller than the correction D{d} of {radius} on its inner side"), None => format!("with the correction D{d} of {radius} nothing is left of this motion between its neighbours") })
        cs (match arc { Some(arc) => format!("oblouk o poloměru {arc} je na vnitřní straně menší než korekce D{d} (poloměr {radius})"), None => format!("s korekcí D{d} (poloměr {radius}) z tohoto pohybu mezi sousedními nic nezbývá") })
        help "use a smaller tool, or change the contour; `cnc872c view` shows the place in red" | "použít menší nástroj, nebo upravit konturu; cnc872c view ukáže místo červeně"
    [W0812] UnknownCorrection "unknown-correction" Warning { d: u32 }
        en "no radius is configured for the correction D{d}: the corrected path is not drawn, and not checked"
        cs "pro korekci D{d} není nastaven poloměr: korigovaná dráha se nekreslí ani nekontroluje"
        help "write the radius of the control's table in the project file: `[corrections.{d}]` with `radius = …`" | "zapsat poloměr z tabulky systému do projektového souboru: [corrections.{d}] s radius = …"
    [W0901] DoesNotFit "does-not-fit" Warning { word: String, byte: String, cell: String }
        en "`{word}` does not fit into {byte}: the PLC program reads 00h there"
        cs "{word} se nevejde do {byte}: PLC program tam přečte 00h"
        help "{cell} holds the whole value" | "celou hodnotu má {cell}"
        note "the byte has two decades in BCD: 00 to 99, without a fraction and a sign" | "bajt má dvě dekády v BCD: 00 až 99, bez desetinné části a znaménka"
    [E0902] UnknownSignal "unknown-signal" Error { name: String, why: super::SignalProblem }
        en "`{name}` is no signal that follows from a part program"
        cs "{name} není signál, který plyne z partprogramu"
        help (why.help(Lang::En)) | (why.help(Lang::Cs))
        note (why.note(Lang::En)) | (why.note(Lang::Cs))
    [E0903] MalformedCondition "malformed-condition" Error { problem: super::ConditionProblem }
        en (problem.text(Lang::En))
        cs (problem.text(Lang::Cs))
    [E0904] DecimalForBcd "decimal-for-bcd" Error { name: String, number: String, right: String, tool: bool }
        en "`{name}` is in BCD, `{number}` is a decimal number"
        cs "{name} je v BCD, {number} je desítkové číslo"
        help (if right.is_empty() { String::new() } else { format!("write `{right}`") })
           | (if right.is_empty() { String::new() } else { format!("napsat „{right}“") })
        note (if *tool { "tool numbers are in BCD too: T12 is 12h" } else { "the cell holds decimal digits: M95 is 95h, which is 149" })
           | (if *tool { "v BCD jsou i čísla nástrojů: T12 je 12h" } else { "buňka obsahuje desítkové číslice: M95 je 95h, tedy 149" })
}

/// The names that the table knows, where they can be said in a line.
fn known_names(known: Option<&KnownNames>, near: Option<&str>, lang: Lang) -> String {
    match (known, near, lang) {
        (Some(known), _, _) => known.text(lang),
        (None, Some("dialect"), Lang::En) => "the run goes on for cnc872, unless --dialect says otherwise".to_owned(),
        (None, Some("dialect"), Lang::Cs) => "kontroluje se pro cnc872, neurčí-li --dialect jinak".to_owned(),
        (None, _, _) => String::new(),
    }
}

/// How often a joint is passed, when more than once.
fn times(count: u64, lang: Lang) -> String {
    match (count, lang) {
        (0 | 1, _) => String::new(),
        (_, Lang::En) => format!("{count} times in this program"),
        (_, Lang::Cs) => format!("v programu {count}×"),
    }
}

/// What happens at a block that is too short to stop in.
fn no_room_note(count: u64, lang: Lang) -> String {
    let why = match lang {
        Lang::En => "without envelope velocity the control brakes at most one block ahead",
        Lang::Cs => "bez obálkové rychlosti systém brzdí nejvýše jeden blok předem",
    };
    let times = times(count, lang);
    if times.is_empty() { why.to_owned() } else { format!("{why}; {times}") }
}
