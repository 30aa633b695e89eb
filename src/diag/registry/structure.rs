//! Findings about blocks and the structure of a file: E02xx and W02xx.

/// Hands these rows on, behind those before them.
macro_rules! structure {
    ([$next:ident $($rest:ident)*] $($before:tt)*) => {
        $next! { [$($rest)*] $($before)*
        [E0201] MissingProgramStart "missing-program-start" Error { number: u32 }
            en "no `%`: the control would ignore the whole file"
            cs "chybí %: systém by celý soubor přeskočil"
            help "begin the program with `%` and its number: `%{number}`"
               | "začít program znakem % a číslem: „%{number}“"
        [E0202] SecondProgramStart "second-program-start" Error { bare: bool }
            en "a second `%` in one file"
            cs "druhé % v jednom souboru"
            help (if *bare {
                "delete it: a program ends with M30 or M02, and the file with `*` or with nothing"
            } else {
                "one file holds one program; put the second into a file of its own, or write `%` in a comment only"
            })
               | (if *bare {
                   "vymazat ho: program končí M30 nebo M02, soubor hvězdičkou nebo ničím"
               } else {
                   "soubor obsahuje jeden program; druhý dát do vlastního souboru, jinak % psát jen v komentáři"
               })
        [E0203] WordOutsideBlock "word-outside-block" Error { word: String, more: usize, blocks: bool, number: i64 }
            en (match (blocks, more) {
                (false, _) => "the program has no block: no line begins with a block number".to_owned(),
                (true, 0) => format!("`{word}` comes before the first block"),
                (true, 1) => format!("`{word}` and another word come before the first block"),
                (true, _) => format!("`{word}` and {more} other words come before the first block"),
            })
            cs (match (blocks, more) {
                (false, _) => "program nemá žádný blok: žádný řádek nezačíná číslem bloku".to_owned(),
                (true, 0) => format!("slovo {word} stojí před prvním blokem"),
                (true, _) => format!("slovo {word} a další ({more}) stojí před prvním blokem"),
            })
            help (if word.starts_with('/') && *more == 0 && *blocks {
                format!("write `/` after the number of the block to skip: `N{number} /`")
            } else {
                format!("begin each block with its number: `N{number} {word}`")
            })
               | (if word.starts_with('/') && *more == 0 && *blocks {
                   format!("psát / až za číslo bloku, který se má vynechat: „N{number} /“")
               } else {
                   format!("každý blok začít jeho číslem: „N{number} {word}“")
               })
        [E0204] DuplicateBlockNumber "duplicate-block-number" Error {
            block: u32, last: Option<u32>, copied: bool,
        }
            en (match last {
                Some(last) => format!("the blocks N{block} to N{last} are in this file twice"),
                None => format!("block number N{block} is used twice in this file"),
            })
            cs (match last {
                Some(last) => format!("bloky N{block} až N{last} jsou v souboru dvakrát"),
                None => format!("číslo bloku N{block} je v souboru dvakrát"),
            })
            help (if *copied && last.is_none() {
                "delete one of the copies, or give it a number of its own"
            } else if *copied {
                "delete one of the copies, or renumber its blocks"
            } else {
                "give one of the blocks a number of its own"
            })
               | (if *copied && last.is_none() {
                   "jednu kopii vymazat, nebo jí dát jiné číslo"
               } else if *copied {
                   "jednu kopii vymazat, nebo její bloky přečíslovat"
               } else {
                   "jednomu z bloků dát jiné číslo"
               })
            note "subprograms count too: one file, one set of block numbers"
               | "platí i pro podprogramy: v jednom souboru smí být každé číslo bloku jen jednou"
        [E0205] MissingProgramEnd "missing-program-end" Error {
            skipped: bool, late: Option<u8>, instead: Option<u8>, unread: Option<UnreadEnd>,
        }
            en (match (late, skipped) {
                _ if unread.is_some() => unread.map(|end| end.message(Lang::En)).unwrap_or_default(),
                (Some(m), _) => format!("the main program has no end: M{m:02} is after the subprograms"),
                (None, true) => "with block skip on, the end of the program is left out".to_owned(),
                (None, false) => "the program has no end: no block holds M02 or M30".to_owned(),
            })
            cs (match (late, skipped) {
                _ if unread.is_some() => unread.map(|end| end.message(Lang::Cs)).unwrap_or_default(),
                (Some(m), _) => format!("hlavní program nemá konec: M{m:02} je až za podprogramy"),
                (None, true) => "při zapnutém vynechání bloků se vynechá i konec programu".to_owned(),
                (None, false) => "program nemá konec: v žádném bloku není M02 ani M30".to_owned(),
            })
            help (match (late, instead) {
                _ if unread.is_some() => unread.map(|end| end.unread.help(Lang::En).to_owned()).unwrap_or_default(),
                (Some(m), _) => format!("move the subprograms behind the block with M{m:02}"),
                (None, Some(m)) => format!("write M30 in place of M{m:02}, which does not end the program here"),
                (None, None) => "end the main program with a block of its own: `N… M30`".to_owned(),
            })
               | (match (late, instead) {
                   _ if unread.is_some() => unread.map(|end| end.unread.help(Lang::Cs).to_owned()).unwrap_or_default(),
                   (Some(m), _) => format!("podprogramy přesunout za blok s M{m:02}"),
                   (None, Some(m)) => format!("místo M{m:02}, které zde program neukončí, napsat M30"),
                   (None, None) => "ukončit hlavní program samostatným blokem: „N… M30“".to_owned(),
               })
        [E0206] BlockAfterProgramEnd "block-after-program-end" Error { block: u32, early: Option<EarlyEnd> }
            en "N{block} comes after the end of the program and belongs to no subprogram"
            cs "blok N{block} stojí za koncem programu a nepatří do žádného podprogramu"
            help (match early { Some(EarlyEnd { function, block }) => format!("the program ends in N{block} with \
                M{function:02}: correct that function if another one is meant (`M03`?), or move the blocks before it"
            ), None => "only subprograms (`G79 L…` to `G70`) may follow M02 or M30; move it before the end, or into a \
                subprogram".to_owned() })
               | (match early { Some(EarlyEnd { function, block }) => format!("program končí už blokem N{block} s \
                   M{function:02}: je-li míněna jiná funkce („M03“?), opravit ji, jinak bloky přesunout před něj"
               ), None => "za M02 nebo M30 smějí následovat jen podprogramy (od „G79 L…“ po „G70“); blok přesunout \
                   před konec, nebo do podprogramu".to_owned() })
        [E0207] UnterminatedSubprogram "unterminated-subprogram" Error {
            macrocycle: bool, skipped: bool, last: bool, instead: Option<u8>, unread: Option<Unread>,
        }
            en ({
                if let Some(Unread { line, .. }) = unread {
                    let unit = if *macrocycle { "macrocycle" } else { "subprogram" };
                    format!("the {unit} has no end: G70 in line {line} is after `*`, which ends the file")
                } else {
                    match (macrocycle, skipped, last) {
                        (_, true, _) => "with block skip on, the G70 that ends this unit is left out",
                        (true, false, _) => "the macrocycle has no end: no block holds G70",
                        (false, false, true) => {
                            "the subprogram has no end: no block up to the end of the file holds G70"
                        }
                        (false, false, false) => {
                            "the subprogram has no end: no block up to the next subprogram holds G70"
                        }
                    }
                    .to_owned()
                }
            })
            cs ({
                if let Some(Unread { line, .. }) = unread {
                    let unit = if *macrocycle { "makrocyklus" } else { "podprogram" };
                    format!("{unit} nemá konec: G70 na řádku {line} je až za hvězdičkou, která ukončuje soubor")
                } else {
                    match (macrocycle, skipped, last) {
                        (_, true, _) => "při zapnutém vynechání bloků se vynechá i G70, která tento celek ukončuje",
                        (true, false, _) => "makrocyklus nemá konec: v žádném bloku není G70",
                        (false, false, true) => "podprogram nemá konec: až do konce souboru v žádném bloku není G70",
                        (false, false, false) => {
                            "podprogram nemá konec: až po další podprogram v žádném bloku není G70"
                        }
                    }
                    .to_owned()
                }
            })
            help (match instead {
                _ if let Some(unread) = unread => unread.help(Lang::En).to_owned(),
                Some(m @ (2 | 30)) => format!("write G70 in place of M{m:02}, which ends the whole program"),
                Some(m) => format!("write G70 in place of M{m:02}, which does not return to the caller here"),
                None => "end it with a block that holds G70: `N… G70`".to_owned(),
            })
               | (match instead {
                   _ if let Some(unread) = unread => unread.help(Lang::Cs).to_owned(),
                   Some(m @ (2 | 30)) => format!("místo M{m:02}, které ukončí celý program, napsat G70"),
                   Some(m) => format!("místo M{m:02}, které se zde do volajícího programu nevrací, napsat G70"),
                   None => "ukončit ho blokem s G70: „N… G70“".to_owned(),
               })
        [E0208] CrowdedSubprogramStart "crowded-subprogram-start" Error { word: String, unnumbered: bool }
            en "`{word}` in the block that begins a subprogram"
            cs "slovo {word} stojí v úvodním bloku podprogramu"
            help (if *unnumbered {
                "begin the line with G79 with a block number: `N… G79 L…`"
            } else {
                "that block holds its number, G79 and L only: `N… G79 L…`; move the rest into the next block"
            })
               | (if *unnumbered {
                   "řádek s G79 začít číslem bloku: „N… G79 L…“"
               } else {
                   "v tomto bloku smí být jen číslo bloku, G79 a L: „N… G79 L…“; ostatní přesunout do dalšího bloku"
               })
        [E0209] DuplicateSubprogram "duplicate-subprogram" Error { l: u32 }
            en "subprogram L{l} is defined twice in the file"
            cs "podprogram L{l} je v souboru dvakrát"
            help "give one of them a number of its own" | "jednomu z nich dát jiné číslo"
        [E0210] TooManySubprograms "too-many-subprograms" Error {}
            en "more than 99 subprograms in one file"
            cs "v souboru je více než 99 podprogramů"
            help "make macrocycles of some of them: files of their own, called by G72"
               | "některé převést na makrocykly: samostatné soubory volané pomocí G72"
        [W0211] UnusedSubprogram "unused-subprogram" Warning { l: u32 }
            en "no G71 calls subprogram L{l}"
            cs "podprogram L{l} žádná G71 nevolá"
            help "call it with `G71 L{l}`, or delete it" | "zavolat ho pomocí „G71 L{l}“, nebo ho vymazat"
        [E0212] EndOutsideSubprogram "end-outside-subprogram" Error { finishing: bool }
            en (if *finishing { "G70 with the words of a turning cycle" } else { "G70 in the main program" })
            cs (if *finishing { "G70 se slovy soustružnického cyklu" } else { "G70 v hlavním programu" })
            help (if *finishing {
                "turning cycles do not exist here, G70 ends a subprogram: write the contour as blocks"
            } else {
                "G70 ends subprograms and macrocycles; the main program ends with M02 or M30"
            })
               | (if *finishing {
                   "soustružnické cykly zde nejsou, G70 ukončuje podprogram: obrys rozepsat do bloků"
               } else {
                   "G70 ukončuje podprogramy a makrocykly; hlavní program končí M02 nebo M30"
               })
        [W0213] SkipBeforeBlockNumber "skip-before-block-number" Warning { block: u32, entry: bool }
            en (if *block == 0 {
                "this `/` belongs to the block before it".to_owned()
            } else {
                format!("this `/` belongs to block N{block}, before it")
            })
            cs (if *block == 0 {
                "toto / patří k předchozímu bloku".to_owned()
            } else {
                format!("toto / patří k předchozímu bloku N{block}")
            })
            help (if *entry {
                "delete it: a block with G79 cannot be skipped; to leave out a subprogram, write `/` in the block that \
                calls it"
            } else {
                "write `/` after the number of the block to skip: `N… /`"
            })
               | (if *entry {
                   "vymazat ho: blok s G79 vynechat nelze; má-li se vynechat podprogram, napsat / do bloku, který ho \
                   volá"
               } else {
                   "psát / až za číslo bloku, který se má vynechat: „N… /“"
               })
        [W0214] EmptyBlock "empty-block" Warning { block: u32, function: Option<String> }
            en "block N{block} is empty"
            cs "blok N{block} je prázdný"
            help (match function {
                Some(function) => {
                    format!("if the function is meant, write `{function}`; else delete the block")
                }
                None => "delete it, or say in a comment what it is for".to_owned(),
            })
               | (match function {
                   Some(function) => format!("je-li míněna funkce, napsat „{function}“; jinak blok vymazat"),
                   None => "vymazat ho, nebo v komentáři napsat, k čemu je".to_owned(),
               })
        [W0215] ProgramEndInSubprogram "program-end-in-subprogram" Warning { function: u8 }
            en "M{function:02} in here ends the whole program, not only this unit"
            cs "M{function:02} zde ukončí celý program, nejen tento celek"
            help "end subprograms and macrocycles with G70" | "podprogramy a makrocykly ukončovat funkcí G70"
        [E0216] MacrocycleNumberMismatch "macrocycle-number-mismatch" Error {
            file: String, expected: u32, found: Option<u32>,
        }
            en ({
                let file = crate::diag::terminal_safe(file);
                match found {
                    Some(l) => format!("the file {file} holds macrocycle L{l}"),
                    None => format!("the macrocycle {file} does not begin with G79"),
                }
            })
            cs ({
                let file = crate::diag::terminal_safe(file);
                match found {
                    Some(l) => format!("soubor {file} obsahuje makrocyklus L{l}"),
                    None => format!("makrocyklus {file} nezačíná funkcí G79"),
                }
            })
            help "its first block is `N… G79 L{expected}`" | "první blok má být „N… G79 L{expected}“"
        [E0217] DuplicateMacrocycle "duplicate-macrocycle" Error { l: u32, first: String, second: String }
            en ({
                let (first, second) = (crate::diag::terminal_safe(first), crate::diag::terminal_safe(second));
                format!("two files are macrocycle L{l}: {first} and {second}")
            })
            cs ({
                let (first, second) = (crate::diag::terminal_safe(first), crate::diag::terminal_safe(second));
                format!("makrocyklus L{l} je ve dvou souborech: {first} a {second}")
            })
            help "keep one of them on the search path" | "na cestě hledání nechat jen jeden"
        [E0218] BlockAfterMacrocycleEnd "block-after-macrocycle-end" Error { block: u32 }
            en "N{block} comes after the G70 that ends the macrocycle"
            cs "blok N{block} stojí za funkcí G70, která makrocyklus ukončuje"
            help "a macrocycle file holds one unit; move the block before G70, or into another file"
               | "soubor makrocyklu obsahuje jediný celek; blok přesunout před G70, nebo do jiného souboru"
        [W0219] SkippableStructure "skippable-structure" Warning { function: String }
            en "`/` in the block with {function}: with block skip on, the control goes on behind it"
            cs "/ v bloku s {function}: při zapnutém vynechání bloků se pokračuje za ním"
            help "give {function} a block of its own without `/`" | "dát {function} do samostatného bloku bez /"
        [W0220] ProgramStartInMacrocycle "program-start-in-macrocycle" Warning {}
            en "a macrocycle file with a `%` line"
            cs "soubor makrocyklu s řádkem %"
            help "delete the `%` word: a macrocycle begins with `N… G79 L…`"
               | "slovo s % vymazat: makrocyklus začíná blokem „N… G79 L…“"
        [W0221] LineWithoutNumber "line-without-number" Warning { block: u32 }
            en (if *block == 0 {
                "the line does not begin with a block number: its words belong to the block above".to_owned()
            } else {
                format!("the line does not begin with a block number: its words belong to block N{block}")
            })
            cs (if *block == 0 {
                "řádek nezačíná číslem bloku: slova patří k bloku nad ním".to_owned()
            } else {
                format!("řádek nezačíná číslem bloku: slova patří k bloku N{block}")
            })
            help "begin a block of its own with `N…`, or move the words to the line of the block that they belong to"
               | "začít samostatný blok „N…“, nebo přesunout slova na řádek bloku, ke kterému patří"

        [W0222] ProgramNamedAsMacrocycle "program-named-as-macrocycle" Warning { l: u32 }
            en "a program in a file with the name of macrocycle L{l}"
            cs "program v souboru, který se jmenuje jako makrocyklus L{l}"
            help "give the file another name: the control calls L{l} by G72 and finds this program"
               | "soubor přejmenovat: volání G72 L{l} najde místo makrocyklu tento program"

        }
    };
}
pub(super) use structure;
