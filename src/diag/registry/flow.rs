//! Findings about calls and jumps: E04xx and W04xx.

/// Hands these rows on, behind those before them.
macro_rules! flow {
    ([$next:ident $($rest:ident)*] $($before:tt)*) => {
        $next! { [$($rest)*] $($before)*
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
            help "`Q` goes with G71, G72, G73 or, as the dwell time, with G04"
               | "Q patří ke G71, G72, G73 nebo jako délka prodlevy ke G04"
        [E0404] UnknownSubprogram "unknown-subprogram" Error {
            l: u32, near: Option<u32>, macrocycle: bool, from_macrocycle: bool, without_entry: Option<u32>,
            uncalled: Option<u32>, unread: Option<Unread>, block: bool,
        }
            en (if let Some(Unread { line, .. }) = unread {
                format!("subprogram L{l} in line {line} is after `*`, which ends the file")
            } else if *from_macrocycle {
                format!("a macrocycle cannot call subprogram L{l}: subprograms belong to the program's file")
            } else {
                format!("there is no subprogram L{l} in this file")
            })
            cs (if let Some(Unread { line, .. }) = unread {
                format!("podprogram L{l} na řádku {line} je až za hvězdičkou, která ukončuje soubor")
            } else if *from_macrocycle {
                format!("makrocyklus nemůže volat podprogram L{l}: podprogramy patří k souboru programu")
            } else {
                format!("podprogram L{l} v souboru není")
            })
            help (match without_entry {
                _ if let Some(unread) = unread => unread.help(Lang::En).to_owned(),
                Some(block) => format!("if it begins with N{block}, `G79 L{l}` belongs in it, or in a block before it"),
                None if let Some(other) = uncalled => format!(
                    "nothing calls L{other}: if it is meant, write `G79 L{l}` where it begins, or `G71 L{other}` in \
                    the calls"
                ),
                None if *macrocycle => format!("L{l} is a macrocycle: call it with `G72 L{l}`"),
                None if *block => format!("N{l} is a block here: jump to it with `G73 L{l}`"),
                None if *from_macrocycle => "call a macrocycle with G72".to_owned(),
                None => nearest(near.as_ref(), "the nearest one is `G71 L", "`"),
            })
               | (match without_entry {
                   _ if let Some(unread) = unread => unread.help(Lang::Cs).to_owned(),
                   Some(block) => format!("začíná-li blokem N{block}, patří „G79 L{l}“ do něj, nebo do bloku před ním"),
                   None if let Some(other) = uncalled => format!(
                       "L{other} nic nevolá: je-li míněn, napsat na jeho začátku „G79 L{l}“, nebo ve voláních „G71 \
                       L{other}“"
                   ),
                   None if *macrocycle => format!("L{l} je makrocyklus: zavolat ho pomocí „G72 L{l}“"),
                   None if *block => format!("N{l} je zde blok: skok na něj je „G73 L{l}“"),
                   None if *from_macrocycle => "volat makrocyklus pomocí G72".to_owned(),
                   None => nearest(near.as_ref(), "nejbližší je „G71 L", "“"),
               })
        [E0405] UnknownMacrocycle "unknown-macrocycle" Error {
            l: u32, searched: String, subprogram: bool, calls: usize, near: Option<u32>, block: bool,
        }
            en (if *calls > 1 {
                format!("macrocycle L{l} is not on the search path; {calls} blocks call it")
            } else {
                format!("macrocycle L{l} is not on the search path")
            })
            cs (if *calls > 1 {
                format!("makrocyklus L{l} se nenašel; program ho volá {calls}×")
            } else {
                format!("makrocyklus L{l} se nenašel")
            })
            help (match (subprogram, near) {
                (true, _) => format!("L{l} is a subprogram of this file: call it with `G71 L{l}`"),
                _ if *block => format!("N{l} is a block here: jump to it with `G73 L{l}`"),
                (false, Some(near)) => format!(
                    "the nearest one is `G72 L{near}`; if L{l} is meant, name its folder with `-L` or under \
                    `macrocycles` in cnc872c.toml"
                ),
                (false, None) => format!(
                    "name its folder with `-L` or under `macrocycles` in cnc872c.toml; if only the machine has it, \
                    `L{l} = {{}}` under `[machine-macrocycles]` there"
                ),
            })
               | (match (subprogram, near) {
                   (true, _) => format!("L{l} je podprogram tohoto souboru: zavolat ho pomocí „G71 L{l}“"),
                   _ if *block => format!("N{l} je zde blok: skok na něj je „G73 L{l}“"),
                   (false, Some(near)) => format!(
                       "nejbližší je „G72 L{near}“; je-li míněno L{l}, uvést jeho složku volbou -L nebo v macrocycles \
                       v souboru cnc872c.toml"
                   ),
                   (false, None) => format!(
                       "uvést jeho složku volbou -L nebo v macrocycles v souboru cnc872c.toml; má-li ho jen stroj, \
                       zapsat tam v [machine-macrocycles] L{l} = {{}}"
                   ),
               })
            note ({ let searched = crate::diag::terminal_safe(searched); format!("searched: {searched}") })
               | ({ let searched = crate::diag::terminal_safe(searched); format!("hledalo se v: {searched}") })
        [E0406] UnknownJumpTarget "unknown-jump-target" Error {
            l: u32, near: Option<u32>, line: Option<u32>, subprogram: bool, wrong: Option<u32>,
        }
            en "there is no block N{l} to jump to"
            cs "blok N{l}, na který se má skočit, neexistuje"
            help (match (line, near) {
                (Some(line), _) => format!("line {line} lacks its block number: write `N{l}` there"),
                (None, Some(n)) => format!("the nearest block of this unit is N{n}: `G73 L{n}`"),
                (None, None) if *subprogram => format!("L{l} is a subprogram here: call it with `G71 L{l}`"),
                (None, None) => wrong.map_or_else(String::new, |wrong| {
                    format!("N{wrong} does not fit between its neighbours: if it is meant, write `N{l}` there")
                }),
            })
               | (match (line, near) {
                   (Some(line), _) => format!("řádku {line} chybí číslo bloku: napsat tam „N{l}“"),
                   (None, Some(n)) => format!("nejbližší blok tohoto celku je N{n}: „G73 L{n}“"),
                   (None, None) if *subprogram => format!("L{l} je zde podprogram: zavolat ho pomocí „G71 L{l}“"),
                   (None, None) => wrong.map_or_else(String::new, |wrong| {
                       format!("N{wrong} nezapadá mezi sousední čísla: je-li míněn, napsat tam „N{l}“")
                   }),
               })
        [E0407] JumpOutOfUnit "jump-out-of-unit" Error { l: u32 }
            en "block N{l} is in another unit of the program"
            cs "blok N{l} je v jiném programovém celku"
            help "a jump stays in its main program, subprogram or macrocycle; to run another unit call it with G71 or \
                G72"
               | "skákat se smí jen uvnitř hlavního programu, podprogramu nebo makrocyklu; jiný celek volat pomocí G71 \
                   nebo G72"
        [E0408] RecursiveCall "recursive-call" Error { ring: String }
            en "this call leads back to a unit that is still running: {ring}"
            cs "toto volání vede zpět do celku, který ještě běží: {ring}"
            help "break the ring; to repeat something, use `Q` or a jump with G73"
               | "kruh přerušit; k opakování slouží Q nebo skok G73"
        [E0409] NestingTooDeep "nesting-too-deep" Error { limit: u32 }
            en "more than {limit} calls are open at once"
            cs "otevřených volání je více než {limit}"
            help "call fewer units from within one another" | "volat méně celků jeden z druhého"
        [E0410] ExpansionLimit "expansion-limit" Error { limit: u64, repeats: String }
            en ({
                let (count, noun) = (grouped(*limit, ','), if *limit == 1 { "block" } else { "blocks" });
                format!("the program executes more than {count} {noun}")
            })
            cs ({
                let (count, noun) = (grouped(*limit, ' '), blocks_cs(*limit));
                format!("program provede více než {count} {noun}")
            })
            help "if intended, raise `records` under [limits], or `--max-blocks`"
               | "je-li to záměr, zvýšit records v [limits], nebo --max-blocks"
            note (if repeats.is_empty() { String::new() } else { format!("what multiplies here: {repeats}") })
               | (if repeats.is_empty() { String::new() } else { format!("co se zde násobí: {repeats}") })
        [E0411] MissingDwell "missing-dwell" Error { meant: DwellMeant }
            en "G04 without `Q`"
            cs "G04 bez Q"
            help (meant.text(Lang::En)) | (meant.text(Lang::Cs))
        [W0412] DwellTakesRepeat "dwell-takes-repeat" Warning { function: GCode }
            en "`Q` is the dwell of G04 here, not the repeats of {function}"
            cs "Q je zde délka prodlevy G04, ne počet opakování {function}"
            help "the {function} is done once; give G04 a block of its own"
               | "{function} se provede jednou; G04 dát do samostatného bloku"
        [E0413] FlowAfterEnd "flow-after-end" Error { function: GCode }
            en "{function} in the block that ends the program"
            cs "{function} v bloku, který ukončuje program"
            help "give M02 or M30 a block of its own" | "M02 nebo M30 dát do samostatného bloku"
        [W0414] SubprogramCallsSubprogram "subprogram-calls-subprogram" Warning { l: Option<u32> }
            en "a subprogram calls another one with G71"
            cs "podprogram volá pomocí G71 další podprogram"
            help "make the called one a macrocycle and call it with G72"
               | "z volaného udělat makrocyklus a volat ho pomocí G72"
            note "the manual describes G71 in the main program only; not every machine may follow"
               | "příručka popisuje G71 jen v hlavním programu; ne každý stroj to musí umět"

        }
    };
}
pub(super) use flow;
