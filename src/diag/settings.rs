//! What is wrong with a project file or a machine constant, in both languages.

use crate::dict::{Lang, bilingual};

bilingual! {
    /// Why a configuration file cannot be read at all.
    ConfigProblem {
        File { problem: String } "{problem}", "{problem}";
        TooDeep "its elements are nested too deeply", "elementy jsou do sebe vnořeny příliš hluboko";
        NotFound { name: String } "there is no file `{name}`", "soubor {name} neexistuje";
        Denied { name: String } "access to `{name}` is denied", "přístup k {name} je odepřen";
        Directory { name: String } "`{name}` is a directory", "{name} je složka";
        NotAFile { name: String } "`{name}` is not a regular file", "{name} není obyčejný soubor";
        Link { name: String }
            "`{name}` is a link that leads to no file",
            "{name} je odkaz, který k žádnému souboru nevede";
        TooLarge "it is larger than 4 GiB", "je větší než 4 GiB";
        Utf16 "it is in UTF-16; it must be in UTF-8", "je v kódování UTF-16; musí být v UTF-8";
        NotUtf8 { line: usize, byte: String }
            "it is not in UTF-8, byte {byte} in line {line}; it must be in UTF-8",
            "není v kódování UTF-8, bajt {byte} na řádku {line}; musí být v UTF-8";
        NotToml "this is not TOML", "toto není TOML";
        KeyTwice { key: String } "`{key}` is defined twice", "{key} je zde dvakrát";
        ListAsTable { key: String }
            "`[{key}]` beside `[[{key}]]`: each is written `[[{key}]]`",
            "[{key}] vedle [[{key}]]: každá tabulka se píše [[{key}]]";
        KeyHasValue { key: String }
            "`{key}` has a value already and cannot be a table too",
            "{key} už má hodnotu a nemůže být také tabulkou";
        KeyForm
            "a key has the letters a–z, digits, `-` and `_`; any other is written in quotes",
            "klíč má písmena a–z, číslice, - a _; jakýkoli jiný patří do uvozovek";
        NoEquals "`=` and a value are missing after a key", "za klíčem chybí = a hodnota";
        NoValue "a value is missing", "chybí hodnota";
        UnquotedText
            "a text is written in quotes, a number is written as `12` or `-0.5`",
            "text patří do uvozovek, číslo se píše jako 12 nebo -0.5";
        TextOpen "a text is not closed by its quote", "text není ukončen uvozovkou";
        Escape "inside `\"…\"` write `\\\\`, or use `'…'`", "v textu mezi \" se \\ píše dvakrát; mezi ' jednou";
        ControlCharacter "a control character", "je zde řídicí znak";
        BracketOpen "a bracket is not closed", "závorka není uzavřena";
        Comma "a comma is missing or superfluous", "čárka chybí nebo přebývá";
        DecimalComma "a number has a decimal point, not a comma", "číslo má desetinnou tečku, ne čárku";
        OneKeyALine "a line holds one key and its value", "na řádku je jeden klíč a jeho hodnota";
        NumberForm
            "a number is written as `12`, `-0.5` or `10_000`, without leading zeros",
            "číslo se píše jako 12, -0.5 nebo 10_000, bez úvodních nul";
        NumberTooLarge "the number is too large", "číslo je příliš velké";
        FlagForm "`true` or `false` is misspelled", "true nebo false je napsáno chybně";
        LineEnd "a line ends with CR alone", "řádek končí samotným CR";
        NotXml "this is not XML", "toto není XML";
        ClosingTag { expected: String, actual: String }
            "`<{expected}>` is open, but `</{actual}>` closes",
            "otevřen je <{expected}>, ale uzavírá se </{actual}>";
        ElementOpen "it ends before all its elements are closed", "končí dřív, než jsou všechny elementy uzavřeny";
        NoElement "it holds no element", "neobsahuje žádný element";
        AttributeTwice { name: String } "the attribute `{name}` is set twice", "atribut {name} je zde dvakrát";
        UnknownEntity { name: String }
            "`&{name};` has no meaning here; other files are never read",
            "&{name}; zde nic neznamená; z jiných souborů se nic nenačítá";
        EntityDeclared
            "it declares entities; only those of XML itself are known",
            "deklaruje entity; známy jsou jen ty, které má samo XML";
        Ampersand "`&` is written `&amp;`", "& se píše &amp;";
        LessThan "in a value `<` is written `&lt;`", "v hodnotě se < píše &lt;";
        UnknownPrefix { prefix: String } "the prefix `{prefix}` is not declared", "předpona {prefix} není deklarována";
        DeclarationPlace "`<?xml` is only allowed at the very beginning", "<?xml stojí na samém začátku, nebo vůbec ne";
        CommentForm "a comment must not hold `--`", "komentář nesmí obsahovat --";
        TooMany "it holds more attributes or elements than are read", "má víc atributů nebo elementů, než se čte";
    }
}

bilingual! {
    /// The values that a configured key takes.
    ConfigNeed {
        Text "takes a text", "musí být text";
        Flag "takes true or false", "musí být true nebo false";
        Whole { min: i64, max: i64 }
            "takes a whole number from {min} to {max}",
            "musí být celé číslo od {min} do {max}";
        ZeroOrOne "is 0 or 1", "je 0, nebo 1";
        Number { min: String, max: String } "takes a number from {min} to {max}", "musí být číslo od {min} do {max}";
        NumberOrAxes { min: String, max: String }
            "takes a number from {min} to {max}, or a table of such by axis letter",
            "musí být číslo od {min} do {max}, nebo tabulka takových čísel podle písmen os";
        EightDigits
            "takes at most eight digits; as a text they have no point: 200.008 is \"00200008\"",
            "má nejvýše osm číslic; jako text jsou bez tečky: 200.008 je \"00200008\"";
        NoSign "has no sign", "je bez znaménka";
        Decade { decade: u32, digits: String }
            "takes one of {digits} in decade {decade}",
            "má mít v {decade}. dekádě jedno z: {digits}";
        ParameterNumber "names a parameter here: 00 to 94", "zde uvádí parametr: 00 až 94";
        AboveZero "is an acceleration above 0", "je zrychlení větší než 0";
        GivenTwice { key: String }
            "gives what `{key}` of `[motion]` gives already",
            "udává totéž, co už udává {key} v [motion]";
        Recognition
            "takes 1 (manual) or 2 (automatic) in decade 1, the rightmost digit: automatic is written R97 = \
            \"00000002\"",
            "má mít v 1. dekádě, tedy na posledním místě, 1 (ruční) nebo 2 (automatické): automatické se zapíše R97 = \
            \"00000002\"";
        AtLeast { min: i64 } "takes a whole number, {min} or more", "musí být celé číslo {min} nebo větší";
        Constant "takes a number, or its digits as a text", "musí být číslo, nebo jeho číslice jako text";
        Table "takes a table", "musí být tabulka";
        List { name: String }
            "takes a list: each of its tables is written `[[{name}]]`",
            "musí být seznam: každá jeho tabulka se píše [[{name}]]";
        Texts "takes a list of texts, as `[\"macros\"]`", "musí být seznam textů, např. [\"makra\"]";
        Letters "takes a list of axis letters, as `[\"Z\"]`", "musí být seznam písmen os, např. [\"Z\"]";
        Extensions
            "takes a list of extensions, as `[\"nc\", \"txt\"]`",
            "musí být seznam přípon, např. [\"nc\", \"txt\"]";
        Folder { name: String } "names `{name}`, which is no folder", "uvádí {name}, ale taková složka není";
        NoSuchAxis { letter: String, axes: String }
            "names {letter}, which `[[axes]]` does not list: {axes}",
            "uvádí osu {letter}, kterou [[axes]] nemá: {axes}";
        SixthAxis { letter: String }
            "makes {letter} the 6th axis; on this control that is A, B or C",
            "má na místě 6. osy {letter}; u tohoto systému to může být A, B nebo C";
        FourthBeside { letter: String }
            "makes {letter} the fourth axis beside X, Y and Z; this control has three",
            "je {letter} už čtvrtá osa kromě X, Y a Z; tento systém má tři";
        MOfGroup { group: u8 } "takes an M function of group {group}", "musí být M funkce skupiny {group}";
        BlockOnly { group: u8 }
            "cannot be set: functions of M group {group} hold in their block only",
            "nastavit nelze: funkce M skupiny {group} platí jen ve svém bloku";
        OneOf { choices: String } "takes one of {choices}", "musí být jedno z: {choices}";
        Missing { key: String } "lacks `{key}`", "nemá uvedeno {key}";
        Repeated "is defined twice", "je uvedeno dvakrát";
        TooManyAxes { limit: usize }
            "lists more axes than the control has, {limit}",
            "má více os než systém, tedy {limit}";
        NotForDialect { dialect: String } "does not exist on {dialect}", "u {dialect} neplatí";
        ErrorLevel
            "is an error and cannot be switched off; only warnings and E0109 have a level",
            "je chyba a vypnout nejde; nastavit lze jen varování a E0109";
        Range "has a lower end above its upper end", "má dolní mez vyšší než horní";
        GOfGroup { group: String }
            "takes a lasting function of group {group}",
            "musí být trvalá funkce skupiny {group}";
        ParameterValue
            "takes a number within ±69999.999, or a whole number of up to eight digits",
            "musí být číslo v rozsahu ±69999.999, nebo celé číslo nejvýše o osmi číslicích";
    }
}

bilingual! {
    /// The kind of thing that a name in a configuration file refers to.
    NameKind {
        Key "key", "klíč";
        Attribute "attribute", "atribut";
        Element "element", "element";
    }
}

bilingual! {
    /// The names that a table knows, where they are names of the control, or the table that knows a name.
    KnownNames {
        Groups
            "the groups are G0 to G11 but G4, and M2 to M14 but M7 and M9",
            "skupiny jsou G0 až G11 kromě G4 a M2 až M14 kromě M7 a M9";
        Parameters "parameters are R0 to R95", "parametry jsou R0 až R95";
        Corrections "entries are 1 to 99, by D", "položky jsou 1 až 99, podle D";
        Operations "codes are \"00\" to \"99\"", "kódy jsou \"00\" až \"99\"";
        Cycles "fixed cycles are G81 to G89", "pevné cykly jsou G81 až G89";
        Macrocycles "macrocycles are L1 to L9999", "makrocykly jsou L1 až L9999";
        Timed "M functions take time, and T, S, H, P, D, F", "čas lze zadat u M funkcí a u T, S, H, P, D, F";
        Constants "machine constants are R0 to R999", "strojní konstanty jsou R0 až R999";
        Axes "axes are X, Y, Z, A, B, C, U, V, W", "osy jsou X, Y, Z, A, B, C, U, V, W";
        OfTable { table: String } "the key belongs under `[{table}]`", "klíč patří pod [{table}]";
        BeforeTables
            "the key belongs before the first table",
            "klíč patří před první tabulku";
        Lints "`cnc872c explain` lists all codes and names", "všechny kódy a jména vypíše „cnc872c explain“";
    }
}

bilingual! {
    /// Why a machine constant, or a key of `[motion]`, is not used for motion.
    UnusedConstant {
        Dialect { dialect: String }
            "{dialect} takes motion from `[motion]` and from no constant",
            "u {dialect} se pohyb počítá podle [motion], ne podle konstant";
        Circles
            "how R232 limits the velocity on circles is in no source; `centripetal-mm-s2` or R411 with 1 in decade 8 \
            does it",
            "jak R232 omezuje rychlost na kruhu, příručky systému neuvádějí; slouží k tomu centripetal-mm-s2 nebo R411 \
            s 1 v 8. dekádě";
        Recognition
            "decade 1, the rightmost digit, is 0: `R97 = 2` is 2.000, and automatic recognition is written R97 = \
            \"00000002\", manual \"00000001\"",
            "v 1. dekádě, tedy na posledním místě, je 0: R97 = 2 je 2.000; automatické rozpoznání se zapíše R97 = \
            \"00000002\", ruční \"00000001\"";
        Envelope { dialect: String }
            "{dialect} has no envelope velocity; `profile = \"ramps\"` holds",
            "{dialect} nemá obálkovou rychlost; platí profile = \"ramps\"";
        ParabolicSet
            "the parabolic profile needs P: `parabolic` under `[motion.sets.1]`, or R407 with R406 enabling it; until \
            then `linear` holds",
            "parabolický průběh potřebuje P: parabolic v [motion.sets.1], nebo R407 povolenou konstantou R406; zatím \
            platí linear";
        CycleTime
            "the criterion is computed with `cycle-ms`, the interpolation cycle Ts, which nobody gave: times are \
            lower bounds",
            "kritérium se počítá s taktem interpolace Ts, a cycle-ms není zadáno: časy jsou dolní meze";
        CloseToWorking
            "R236 is to be at least 100 mm/s² below R52, says the manual; both count as they are written",
            "R236 má být podle příručky systému aspoň o 100 mm/s² menší než R52; obě platí tak, jak jsou zapsány";
        LengthCorrection
            "how decade 8 corrects the criterion for the length of blocks is in no source; the other digits are used",
            "jak 8. dekáda koriguje kritérium na délku bloku, příručky systému neuvádějí; ostatní číslice platí";
        Percentage
            "how a percentage limits the velocity on circles is in no source; with 1 in decade 8 the digits are a \
            centripetal acceleration in tenths of mm/s²",
            "jak procento omezuje rychlost na kruhu, příručky systému neuvádějí; s 1 v 8. dekádě jsou číslice \
            odstředivým zrychlením v desetinách mm/s²";
        TooFast { accel: u32, meant: u32, shown: String }
            "{accel} mm/s² is no acceleration of a machine; probably {shown} is meant, which is {meant} mm/s²",
            "{accel} mm/s² není zrychlení stroje; míněno je asi {shown}, tedy {meant} mm/s²";
    }
}

/// Why W0707 is raised.
#[derive(Clone, Debug, Eq, PartialEq)]
pub enum NotUsed {
    /// The program does not compute the effect of the value.
    Why(UnusedConstant),
    /// The value cannot be; commands that compute motion refuse it with E0702.
    Needs(ConfigNeed),
}

impl NotUsed {
    /// The unused part of a constant (`R384`) or a key (`motion.profile`).
    pub(super) fn message(&self, name: &str, lang: Lang) -> String {
        let constant = !name.contains('.');
        let what = match lang {
            Lang::En if constant => format!("machine constant {name}"),
            Lang::En => format!("`{name}`"),
            Lang::Cs if constant => format!("strojní konstanta {name}"),
            Lang::Cs => name.to_owned(),
        };
        match (self, lang) {
            (Self::Why(UnusedConstant::CloseToWorking), Lang::En) => format!("{what} is close to R52"),
            (Self::Why(UnusedConstant::CloseToWorking), Lang::Cs) => format!("{what} se málo liší od R52"),
            (Self::Why(UnusedConstant::LengthCorrection), Lang::En) => {
                format!("decade 8 of {what} is not used for motion")
            }
            (Self::Why(UnusedConstant::LengthCorrection), Lang::Cs) => {
                format!("8. dekáda strojní konstanty {name} se pro výpočet pohybu nepoužije")
            }
            (Self::Why(_) | Self::Needs(_), Lang::En) => format!("{what} is not used for motion"),
            (Self::Why(_) | Self::Needs(_), Lang::Cs) => format!("{what} se pro výpočet pohybu nepoužije"),
        }
    }

    /// Why.
    pub(super) fn note(&self, lang: Lang) -> String {
        match (self, lang) {
            (Self::Why(why), _) => why.text(lang),
            (Self::Needs(needs), Lang::En) => format!("it {}", needs.text(lang)),
            (Self::Needs(needs), Lang::Cs) => needs.text(lang),
        }
    }
}

bilingual! {
    /// A mistake in one of R56–R59 (MFN-5).
    ConstantProblem {
        Digits
            "takes at most eight digits, without sign and point: four functions of two digits",
            "má nejvýše osm číslic bez znaménka a tečky: čtyři funkce po dvou číslicích";
        Standard { m: u8, group: u8 }
            "names M{m:02}, which is fixed in M group {group}",
            "uvádí M{m:02}, která pevně patří do {group}. skupiny";
        Twice { m: u8 } "names M{m:02}, which is named already", "uvádí M{m:02}, která už je uvedena";
    }
}
