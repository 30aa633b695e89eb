//! Findings about the words of a block: E03xx and W03xx.

/// Hands these rows on, behind those before them.
macro_rules! words {
    ([$next:ident $($rest:ident)*] $($before:tt)*) => {
        $next! { [$($rest)*] $($before)*
        [E0301] UnknownAddress "unknown-address" Error { address: String, meant: AddressMeant }
            en "`{address}` is no address of this control"
            cs "{address} není adresa tohoto systému"
            help (meant.text(Lang::En)) | (meant.text(Lang::Cs))
        [E0302] ValueOutOfRange "value-out-of-range" Error {
            address: Address, range: String, mode: Option<GCode>, call: Option<String>,
        }
            en ({
                let under = mode.map_or_else(String::new, |mode| format!(" under {mode}"));
                format!("{address} takes {range}{under}")
            })
            cs ({
                let range = range_cs(range);
                let under = mode.map_or_else(String::new, |mode| format!(" při {mode}"));
                format!("{address} má{under} rozsah {range}")
            })
            help (match call {
                Some(call) => format!("if a call is meant, write `{call}`"),
                None => other_range(*address, range, *mode, Lang::En).to_owned(),
            })
               | (match call {
                   Some(call) => format!("mělo-li to být volání, napsat „{call}“"),
                   None => other_range(*address, range, *mode, Lang::Cs).to_owned(),
               })
        [W0303] FinerThanResolution "finer-than-resolution" Warning { rounded: String }
            en "more than three decimals: {rounded} is used here"
            cs "víc než tři desetinná místa: počítá se zde s {rounded}"
            help "write three decimals at most" | "psát nejvýše tři desetinná místa"
        [E0304] PointNotAllowed "decimal-point-not-allowed" Error { address: Address, meant: PointMeant }
            en (if meant.is_dwell() {
                "the dwell takes whole units of 10 ms".to_owned()
            } else {
                format!("{address} takes no decimal point")
            })
            cs (if meant.is_dwell() {
                "prodleva se zadává v celých jednotkách po 10 ms".to_owned()
            } else {
                format!("{address} nesmí mít desetinnou tečku")
            })
            help (meant.text(Lang::En)) | (meant.text(Lang::Cs))
        [E0305] SignNotAllowed "sign-not-allowed" Error { address: Address, key: String }
            en "{address} takes no sign"
            cs "{address} nesmí mít znaménko"
            help (if key.is_empty() && is_value(*address) {
                "write the number without it, or the letter of an axis if that is meant".to_owned()
            } else if key.is_empty() {
                "write the number without it".to_owned()
            } else {
                let plain = key.replacen('1', "", 1);
                format!("on a Czech keyboard `+` is the key of 1: write `{key}` if that is meant, else `{plain}`")
            })
               | (if key.is_empty() && is_value(*address) {
                   "napsat číslo bez něj, nebo písmeno osy, je-li míněna".to_owned()
               } else if key.is_empty() {
                   "napsat číslo bez něj".to_owned()
               } else {
                   let plain = key.replacen('1', "", 1);
                   format!("na české klávesnici je + na klávese číslice 1: je-li míněna, napsat „{key}“, jinak „{plain}“")
               })
        [E0306] DuplicateAddress "duplicate-address" Error { address: String, unnumbered: bool }
            en "`{address}` is written twice in this block"
            cs "{address} je v bloku dvakrát"
            help (if *unnumbered {
                unnumbered_line(Lang::En)
            } else {
                "keep one of them, or begin a new block with `N…`"
            })
               | (if *unnumbered {
                   unnumbered_line(Lang::Cs)
               } else {
                   "nechat jen jedno slovo, nebo začít nový blok „N…“"
               })
        [E0307] ConflictingG "conflicting-g-functions" Error {
            first: GCode, second: GCode, group: GGroup, unnumbered: bool,
        }
            en (if first == second {
                format!("{first} is written twice in this block")
            } else if first.group() == second.group() {
                format!("{first} and {second} are both of group {group}")
            } else {
                format!("{first} calls a macrocycle by the cycle map, and so the block cannot hold {second} as well")
            })
            cs (if first == second {
                format!("{first} je v bloku dvakrát")
            } else if first.group() == second.group() {
                format!("{first} a {second} jsou obě ze skupiny {group}")
            } else {
                format!("{first} volá makrocyklus podle mapy cyklů, {second} proto v bloku být nemůže")
            })
            help (if *unnumbered {
                unnumbered_line(Lang::En)
            } else {
                "one function of a group per block: delete one, or give it a block of its own"
            })
               | (if *unnumbered {
                   unnumbered_line(Lang::Cs)
               } else {
                   "z jedné skupiny smí být v bloku jediná funkce: jednu vymazat, nebo jí dát vlastní blok"
               })
        [E0308] ConflictingM "conflicting-m-functions" Error {
            first: u8, second: u8, group: u8, dialect: Dialect, unnumbered: bool,
        }
            en (if first == second {
                format!("M{first:02} is written twice in this block")
            } else {
                format!("M{first:02} and M{second:02} are both of M group {group}")
            })
            cs (if first == second {
                format!("M{first:02} je v bloku dvakrát")
            } else {
                let of = of_group(*group);
                format!("M{first:02} a M{second:02} jsou obě {of} skupiny M funkcí")
            })
            help (if *unnumbered {
                unnumbered_line(Lang::En)
            } else {
                "one function of a group per block: delete one, or give it a block of its own"
            })
               | (if *unnumbered {
                   unnumbered_line(Lang::Cs)
               } else {
                   "z jedné skupiny smí být v bloku jediná funkce: jednu vymazat, nebo jí dát vlastní blok"
               })
            note (match (*group >= 10, dialect.has_channel_config()) {
                (true, true) => {
                    "functions that the machine builder added are in the groups that `channel-config` gives"
                }
                (true, false) => {
                    "functions that the machine builder added are in the groups that R56–R59 of `machine-constants` \
                    give"
                }
                (false, _) => "",
            })
               | (match (*group >= 10, dialect.has_channel_config()) {
                   (true, true) => "funkce výrobce stroje jsou ve skupinách podle channel-config",
                   (true, false) => "funkce výrobce stroje jsou ve skupinách podle R56–R59 v machine-constants",
                   (false, _) => "",
               })
        [E0309] UnknownG "unknown-g-function" Error { number: u32 }
            en "G{number:02} is no function of this control"
            cs "G{number:02} není funkce tohoto systému"
            help (foreign_g(*number, Lang::En)) | (foreign_g(*number, Lang::Cs))
        [E0310] TooManyWords "too-many-words" Error { address: Address, limit: usize }
            en "more than {limit} `{address}` words in one block"
            cs "v bloku je více než {limit} slov {address}"
            help "share them out among several blocks" | "rozdělit je do více bloků"
        [E0311] UnknownAxis "unknown-axis" Error { axis: char, axes: String, limit: Option<usize> }
            en (match limit {
                Some(limit) => format!(
                    "axis {axis} is one too many: beside X, Y, Z the control has {limit} axes, one of the three A, B \
                    or C"
                ),
                None => format!("this machine has no axis {axis}"),
            })
            cs (match limit {
                Some(limit) => {
                    format!("osa {axis} je navíc: kromě X, Y, Z má systém {limit} osy a jedna z nich je A, B nebo C")
                }
                None => format!("stroj nemá osu {axis}"),
            })
            help (if limit.is_some() {
                format!(
                    "the program uses {axes} before it; the axes of the machine are named under [[axes]] in \
                    cnc872c.toml"
                )
            } else {
                format!("the configured axes are {axes}")
            })
               | (if limit.is_some() {
                   format!("dřív program používá osy {axes}; osy stroje se uvádějí v [[axes]] v souboru cnc872c.toml")
               } else {
                   format!("nastavené osy jsou {axes}")
               })
        [E0312] CorrectionDigits "length-correction-digits" Error {}
            en "`&` takes four digits, each 0, 1 or 2"
            cs "& má čtyři číslice, každou 0, 1 nebo 2"
            help "write four digits, each 0, 1 or 2; for example `&0010`"
               | "zadat čtyři číslice, každou 0, 1 nebo 2; například „&0010“"

        }
    };
}
pub(super) use words;
