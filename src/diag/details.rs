//! Closed sets of reasons that the texts of some diagnostics name, in both languages.

use std::collections::BTreeMap;

use crate::dict::{Address, GCode, Lang, bilingual};
use crate::text::{BrokenLink, NotUtf8};

bilingual! {
    /// Why a file cannot be read.
    Problem {
        NotFound "no such file", "soubor neexistuje";
        Pattern
            "no such file; the shell passed the pattern on as it is: name the files, or their folder",
            "soubor neexistuje; shell předal vzor tak, jak je: uvést soubory, nebo jejich složku";
        Denied "permission denied", "přístup odepřen";
        Directory "it is a folder", "je to složka";
        FileAsFolder "a file is named as a folder", "soubor je zde uveden jako složka";
        BadName "no file can have this name", "takový název soubor mít nemůže";
        NotAFile "it is not a regular file", "není to obyčejný soubor";
        Link "it is a link that leads to no file", "je to odkaz, který k žádnému souboru nevede";
        TooLarge "it is larger than 4 GiB", "je větší než 4 GiB";
        NotUtf8 { line: usize, byte: String }
            "it is not in UTF-8, as `encoding` says: byte {byte} in line {line}",
            "není v UTF-8, jak určuje encoding: bajt {byte} na řádku {line}";
        Changing "it is being written to", "právě se do něj zapisuje";
        MacrocycleGiven
            "it is a macrocycle; name the program that calls it",
            "je to makrocyklus; uvést program, který ho volá";
        Other { reason: String } "{reason}", "{reason}";
    }
}

impl Problem {
    /// What an error of the operating system says.
    pub fn from_io(error: &std::io::Error) -> Self {
        if BrokenLink::is(error) {
            return Self::Link;
        }
        if let Some(NotUtf8 { line, byte }) = NotUtf8::of(error) {
            return Self::NotUtf8 { line, byte: format!("{byte:02X}h") };
        }
        [
            (std::io::ErrorKind::NotFound, Self::NotFound),
            (std::io::ErrorKind::PermissionDenied, Self::Denied),
            (std::io::ErrorKind::IsADirectory, Self::Directory),
            (std::io::ErrorKind::NotADirectory, Self::FileAsFolder),
            (std::io::ErrorKind::InvalidFilename, Self::BadName),
            // The disk loader's error for pipes and devices.
            (std::io::ErrorKind::Unsupported, Self::NotAFile),
            (std::io::ErrorKind::FileTooLarge, Self::TooLarge),
            (std::io::ErrorKind::ResourceBusy, Self::Changing),
        ]
        .into_iter()
        .find(|(kind, _)| *kind == error.kind())
        .map_or_else(|| Self::Other { reason: error.to_string() }, |(_, problem)| problem)
    }
}

bilingual! {
    /// What went wrong in parameter arithmetic (PAR-10).
    ArithmeticFault {
        DivisionByZero "a division by zero", "dělení nulou";
        NegativeRoot { operand: String }
            "the square root of a negative number ({operand})",
            "odmocnina ze záporného čísla {operand}";
        NoAngle { operand: String }
            "no angle has the sine or cosine {operand}",
            "žádný úhel nemá sinus ani kosinus {operand}";
        NoTangent { operand: String } "the tangent of {operand}° does not exist", "tangens {operand}° neexistuje";
        ResultOutOfRange { result: String, limit: String }
            "the result {result} is outside ±{limit}",
            "výsledek {result} je mimo ±{limit}";
    }
}

bilingual! {
    /// What was probably meant by characters that the control does not know.
    Meant {
        Nothing
            "delete it; if it is meant as a comment, put it between quotes: `\"comment\"`",
            "vymazat; má-li to být komentář, dát ho do uvozovek: \"komentář\"";
        Control "delete it; it does not show in an editor", "vymazat ho; v editoru nemusí být vidět";
        Number
            "a number has digits, a sign and a decimal point only",
            "číslo tvoří jen číslice, znaménko a desetinná tečka";
        Comment "put comments between quotes: `\"comment\"`", "komentář se píše do uvozovek: \"komentář\"";
        MinusInside { written: String }
            "write the plain minus of the keyboard: `{written}`",
            "napsat obyčejné minus z klávesnice: „{written}“";
        BlankInside { code: String, written: String }
            "write `{written}`; the blank in it is {code}, which the control does not know",
            "napsat „{written}“; mezera je zde {code}, který systém nezná";
        Minus "write the plain minus of the keyboard: `-`", "napsat obyčejné minus z klávesnice: „-“";
        Blank { code: String } "write a plain blank; this one is {code}", "napsat obyčejnou mezeru; toto je {code}";
        LookAlike { code: String }
            "write it anew in plain letters and digits; this character is {code}",
            "napsat znovu obyčejnými písmeny a číslicemi; tento znak je {code}";
        BlockEnd "delete it: a block ends where the next `N` begins", "vymazat ho: blok končí tam, kde začíná další N";
        Variable { written: String }
            "there are no variables `#`; write a parameter: `{written}`",
            "proměnné # zde nejsou; napsat parametr: „{written}“";
        Expression
            "there are no variables `#` and no expressions; write a parameter, as in `XR10`; G26 to G29 compute",
            "proměnné # ani výrazy zde nejsou; napsat parametr, například „XR10“; počítají G26 až G29";
        Computed
            "there are no expressions; G26 to G29 compute with parameters",
            "výrazy se psát nedají; s parametry počítají G26 až G29";
        Brackets { written: String } "write it without brackets: `{written}`", "napsat bez závorek: „{written}“";
        ProgramName { written: String }
            "a program is named by its number: `{written}`",
            "program se označuje číslem: „{written}“";
        CommentOrWords { words: String, comment: String }
            "if it belongs to the program, write it alone: `{words}`; if it is a comment, put it between quotes: \
            `\"{comment}\"`",
            "patří-li to do programu, napsat jen „{words}“; je-li to komentář, dát ho do uvozovek: \"{comment}\"";
        CzechKeys { written: String }
            "on a Czech keyboard digits are typed with Shift: if a digit is meant, write `{written}`",
            "číslice se na české klávesnici píší se Shiftem: je-li míněna číslice, napsat „{written}“";
        CzechKeyOrBlank { written: String }
            "on a Czech keyboard digits are typed with Shift: if a digit is meant, write `{written}`; if a blank, a \
            plain one: the fixed blank of Windows-1250 looks like this in CP852",
            "číslice se na české klávesnici píší se Shiftem: je-li míněna číslice, napsat „{written}“; je-li míněna \
            mezera, napsat obyčejnou: pevná mezera z kódování Windows-1250 vypadá v CP852 takto";
        BlankOfWindows
            "if a blank is meant, write a plain one: the fixed blank of Windows-1250 looks like this in CP852",
            "je-li míněna mezera, napsat obyčejnou: pevná mezera z kódování Windows-1250 vypadá v CP852 takto";
        Accent { written: String }
            "if the address is meant, write `{written}`; else delete it",
            "je-li to adresa, napsat „{written}“, jinak vymazat";
        OpenQuote { text: String }
            "a quote is missing where the comment begins, here or further left: `\"{text}\"`",
            "chybí uvozovky, kterými komentář začíná, zde nebo dále vlevo: \"{text}\"";
        SwallowedBefore { words: String }
            "the comment before swallows `{words}`: fix its quotes",
            "předchozí komentář spolkl „{words}“: opravit jeho uvozovky";
        CommentBefore { words: String }
            "put the comment between quotes, together with `{words}` where that is a part of it",
            "komentář dát do uvozovek, a to i s {words}, pokud k němu patří";
    }
}

/// What looks like a minus.
pub const MINUS: [char; 5] = ['−', '–', '—', '‐', '‑'];

impl Meant {
    /// What those characters suggest.
    pub fn of(text: &str) -> Self {
        let code = |character: char| format!("U+{:04X}", u32::from(character));
        if !text.is_empty() && text.chars().all(crate::text::is_unsafe) {
            return Self::Control;
        }
        if text.contains(MINUS) {
            Self::Minus
        } else if text.contains(['#', '[', ']']) {
            Self::Expression
        } else if let Some(blank) = text.chars().find(|character| !character.is_ascii() && character.is_whitespace()) {
            Self::Blank { code: code(blank) }
        } else if let Some(letter) =
            text.chars().find(|character| character.is_alphanumeric() && *character > '\u{24f}')
        {
            Self::LookAlike { code: code(letter) }
        } else {
            Self::Nothing
        }
    }

    /// With the word as it is written here.
    #[must_use]
    pub fn with_word(self, word: &str) -> Self {
        let written = super::shown(word);
        if let Self::Blank { code } = self {
            Self::BlankInside { code, written }
        } else if self == Self::Minus {
            Self::MinusInside { written }
        } else {
            self
        }
    }

    /// The characters' meaning between an address and its number.
    pub fn inside(text: &str) -> Self {
        let meant = Self::of(text);
        if meant == Self::Nothing { Self::Number } else { meant }
    }
}

/// Whether it is a blank, but not one that the control knows.
pub fn is_blank(character: char) -> bool {
    !character.is_ascii() && character.is_whitespace()
}

/// The end of a main program that has another one behind it (E0206).
#[derive(Clone, Copy, Debug, Eq, PartialEq)]
pub struct EarlyEnd {
    /// M02 or M30, by number.
    pub function: u8,
    /// The number of its block.
    pub block: u32,
}

/// A function whose effect is not modelled (W0612).
#[derive(Clone, Debug, Eq, PartialEq)]
pub enum Unmodelled {
    /// G05 to G08, or a fixed cycle that nothing maps (GRP-6, GRP-8).
    Function(GCode),
    /// Macrocycles that only the machine has, by number, and whether the project file names their axes (FLW-12).
    Macrocycles(BTreeMap<u32, bool>),
}

impl Unmodelled {
    /// The unknown part of it.
    pub fn message(&self, lang: Lang) -> String {
        let words = match self {
            Self::Function(cycle) if cycle.is_cycle() => UnmodelledText::Cycle { cycle: cycle.to_string() },
            Self::Function(function) => UnmodelledText::Function { function: function.to_string() },
            Self::Macrocycles(numbers) => {
                let list = numbers.keys().map(|l| format!("L{l}")).collect::<Vec<_>>().join(", ");
                if numbers.len() == 1 {
                    UnmodelledText::Macrocycle { list }
                } else {
                    UnmodelledText::Macrocycles { list }
                }
            }
        };
        words.text(lang)
    }

    /// What would make it known; empty when nothing would.
    pub fn help(&self, lang: Lang) -> String {
        match self {
            Self::Function(cycle) if cycle.is_cycle() => {
                UnmodelledText::NameCycle { cycle: cycle.to_string() }.text(lang)
            }
            Self::Macrocycles(numbers) if !numbers.values().all(|axes_named| *axes_named) => {
                UnmodelledText::NameAxes.text(lang)
            }
            Self::Function(_) | Self::Macrocycles(_) => String::new(),
        }
    }
}

bilingual! {
    /// The sentences of [`Unmodelled`].
    UnmodelledText {
        Function { function: String }
            "what {function} does is not modelled: the programmed path counts",
            "účinek {function} se nemodeluje: počítá se s programovanou dráhou";
        Cycle { cycle: String }
            "how the fixed cycle {cycle} moves is not known: its blocks have no motion here",
            "jak se pevný cyklus {cycle} pohybuje, není známo: jeho bloky zde nemají žádný pohyb";
        NameCycle { cycle: String }
            "name the macrocycle that the machine runs for it in the project file: `[cycles]`, `{cycle} = …`",
            "uvést v projektovém souboru makrocyklus, který stroj při něm provádí: [cycles], {cycle} = …";
        Macrocycle { list: String }
            "only the machine has macrocycle {list}: what it does is not known here",
            "makrocyklus {list} má jen stroj: co dělá, zde není známo";
        Macrocycles { list: String }
            "only the machine has the macrocycles {list}: what they do is not known here",
            "makrocykly {list} má jen stroj: co dělají, zde není známo";
        NameAxes
            "`axes` under `[machine-macrocycles]` says which axes it moves; the positions of the others then stay \
            known",
            "axes v [machine-macrocycles] určí, kterými osami pohybuje; polohy ostatních pak zůstanou známy";
    }
}

bilingual! {
    /// The control that a program was written for, when that is none of ours.
    OtherControl {
        Fanuc "Fanuc, or one like it (Haas, Mitsubishi)", "Fanuc nebo jemu podobný (Haas, Mitsubishi)";
        LinuxCnc "LinuxCNC", "LinuxCNC";
        Sinumerik "Sinumerik", "Sinumerik";
        Heidenhain "Heidenhain", "Heidenhain";
        Iso "an ISO control such as Fanuc or LinuxCNC", "ISO systém jako Fanuc nebo LinuxCNC";
    }
}

impl OtherControl {
    /// As tables call it.
    pub const fn name(&self) -> &'static str {
        match self {
            Self::Fanuc => "fanuc",
            Self::LinuxCnc => "linuxcnc",
            Self::Sinumerik => "sinumerik",
            Self::Heidenhain => "heidenhain",
            Self::Iso => "iso",
        }
    }
}

bilingual! {
    /// Why a word I, J or K has no use in its block (MOT-3, GRP-4, GRP-7, GRP-8).
    CenterPlace {
        ThirdInArc "I and J give the centre", "střed oblouku udávají I a J";
        OtherLetters
            "I and J give the centre, in the order of the axes of the arc",
            "střed oblouku udávají I a J v pořadí jeho os";
        InTableBlock "a G92 or G93 block takes axis words", "blok s G92 nebo G93 má slova os";
        NoUse
            "it is no arc, and no function in force takes such words",
            "není to oblouk a neplatí funkce, která taková slova používá";
    }
}

bilingual! {
    /// Why a joint in G23 is not passed continuously (CNT-2).
    JointBreak {
        Angle { angle: String, allowed: String }
            "the angle is {angle}°, {allowed}° or more",
            "úhel návaznosti je {angle}°, tedy {allowed}° nebo víc";
        ShortLength { limit: String }
            "one of the blocks is shorter than {limit} mm",
            "jeden z bloků je kratší než {limit} mm";
        ShortTime { limit: String }
            "one of the blocks lasts less than {limit} ms",
            "jeden z bloků trvá méně než {limit} ms";
        MFunction "an M function breaks it", "ruší ji M funkce";
        NoMotion "blocks without motion are between them", "mezi nimi jsou bloky bez pohybu";
        Dwell "G04 stops the motion", "pohyb zastaví G04";
    }
}

bilingual! {
    /// What makes a continuous joint slow.
    JointLimit {
        Feed "by the programmed feed", "omezuje ji programovaný posuv";
        Centripetal "by the centripetal acceleration of an arc", "omezuje ji odstředivé zrychlení na kruhu";
        ShortestBlock "by the shortest time of a block", "omezuje ji nejkratší trvání bloku";
        Accuracy "by the criterion of accuracy", "omezuje ji kritérium přesnosti";
        Overload "by the dynamic criterion", "omezuje ji dynamické kritérium";
        LookAhead
            "by stopping within the blocks that the control sees",
            "omezuje ji zastavení v blocích, které systém předvídá";
        Ramp "by the acceleration from or to a slower place", "omezuje ji zrychlení od pomalejšího místa nebo k němu";
    }
}

bilingual! {
    /// Why a part program does not determine a name of the PLC interface.
    RunTimeReason {
        Running "only the running control knows it", "zná ji jen běžící systém";
        Plc "the PLC program sets it itself", "nastavuje ji sám PLC program";
        Inputs
            "it comes from the machine: switches, buttons, encoders",
            "přichází ze stroje: ze spínačů, tlačítek, snímačů";
        Configuration "it comes from the configuration of the machine", "pochází z konfigurace stroje";
        NoGroup
            "M groups are numbered from 1, and no function is in group 0",
            "skupiny M funkcí se číslují od 1 a ve skupině 0 není žádná funkce";
        Unsaid
            "the manuals do not say how a part program gives it",
            "příručky systému neříkají, jak ji partprogram udává";
        Bytes { names: &'static str }
            "it is the name of a kind of bytes, which have names of their own: {names}",
            "je to označení druhu bajtů, které mají vlastní názvy: {names}";
        Bits { names: &'static str }
            "its bits have names of their own: {names}",
            "její bity mají vlastní názvy: {names}";
    }
}

/// What can be said of a name that is no signal of the control.
#[derive(Clone, Debug, Eq, PartialEq)]
pub enum SignalProblem {
    /// A part program does not determine it.
    RunTime(RunTimeReason),
    /// A control with that dialect has no command block.
    OtherControl(String),
    /// Like that one.
    Near(String),
    /// Like none.
    Nothing,
}

impl SignalProblem {
    /// Why there is no such signal; empty where nothing can be said.
    pub fn note(&self, lang: Lang) -> String {
        match (self, lang) {
            (Self::RunTime(reason), Lang::En) => format!("a part program does not determine it: {}", reason.text(lang)),
            (Self::RunTime(reason), Lang::Cs) => format!("partprogram tuto buňku neurčuje: {}", reason.text(lang)),
            (Self::OtherControl(dialect), Lang::En) => format!("{dialect} has no command block BLK"),
            (Self::OtherControl(dialect), Lang::Cs) => format!("{dialect} nemá povelový blok BLK"),
            (Self::Near(_) | Self::Nothing, _) => String::new(),
        }
    }

    /// What to write instead; empty where nothing can be said.
    pub fn help(&self, lang: Lang) -> String {
        match (self, lang) {
            (Self::Near(near), Lang::En) => format!("perhaps `{near}` is meant"),
            (Self::Near(near), Lang::Cs) => format!("možná mělo být „{near}“"),
            (Self::Nothing | Self::OtherControl(_), Lang::En) => "`cnc872c plc --list` shows all signals".to_owned(),
            (Self::Nothing | Self::OtherControl(_), Lang::Cs) => {
                "všechny signály vypíše „cnc872c plc --list“".to_owned()
            }
            (Self::RunTime(_), _) => String::new(),
        }
    }
}

bilingual! {
    /// A mistake in a condition of `plc --find`.
    ConditionProblem {
        Empty "the condition is empty", "podmínka je prázdná";
        Character { written: String } "`{written}` has no meaning in a condition", "„{written}“ nemá v podmínce význam";
        NoNumber { written: String } "`{written}` is not a number", "„{written}“ není číslo";
        NumberTooLong "the number has too many digits", "číslo má příliš mnoho číslic";
        HexadecimalLetter { right: String }
            "a hexadecimal number begins with a digit: `{right}`",
            "šestnáctkové číslo začíná číslicí: „{right}“";
        OtherOperator { written: String, right: String }
            "`{written}` is written `{right}` in a condition",
            "místo „{written}“ se v podmínce píše „{right}“";
        NotOfComparison { right: String }
            "`!` belongs to the name alone; the opposite of a comparison is `{right}`",
            "„!“ patří jen k názvu signálu; opak porovnání je „{right}“";
        NoBit { name: String, example: String }
            "`{name}` is not a bit and needs a comparison, as in `{name} {example}`",
            "{name} není bit a musí se porovnat, například „{name} {example}“";
        NumberFirst "a comparison begins with a signal: `PB06 == 19h`", "porovnání začíná signálem: „PB06 == 19h“";
        MissingSignal "a signal is missing here", "zde chybí signál";
        MissingOperand "a signal or a number is missing here", "zde chybí signál nebo číslo";
        NoOperator "`&` or `|` is missing before this", "před tímto chybí „&“ nebo „|“";
        ComparedTwice
            "a comparison cannot be compared again; `&` joins two of them",
            "porovnání nelze dál porovnávat; dvě porovnání spojí „&“";
        Unclosed "a parenthesis is not closed", "závorka není uzavřena";
        Superfluous "this parenthesis closes none", "tato závorka žádnou neuzavírá";
        EdgeParentheses
            "`rising` and `falling` take a condition in parentheses: `rising(M03PI)`",
            "„rising“ a „falling“ mají podmínku v závorkách: „rising(M03PI)“";
        NeverHolds { name: String, low: String, high: String }
            "`{name}` is a whole number from {low} to {high}: this never holds",
            "{name} je celé číslo od {low} do {high}: toto nikdy neplatí";
        TooDeep { limit: usize }
            "more than {limit} parentheses and `!` are within one another",
            "závorek a „!“ je v sobě vnořeno více než {limit}";
        EdgeInEdge "`rising` and `falling` cannot be within one another", "„rising“ a „falling“ nelze vkládat do sebe";
    }
}

/// What an address needs of a value that a parameter gives (PAR-3).
#[derive(Clone, Debug, Eq, PartialEq)]
pub enum ParameterNeed {
    /// No sign.
    NoSign,
    /// A whole number.
    Whole,
    /// A value of that range.
    Range(String),
    /// Four digits 0–2.
    CorrectionDigits,
    /// A number written out (BLK-10).
    WrittenOut(String),
}

impl ParameterNeed {
    /// The text in `lang`, as the rest of a sentence.
    pub fn text(&self, address: Address, lang: Lang) -> String {
        match (self, lang) {
            (Self::NoSign, Lang::En) => format!("{address} takes no sign"),
            (Self::NoSign, Lang::Cs) => format!("{address} nesmí mít znaménko"),
            (Self::Whole, Lang::En) => format!("{address} takes a whole number"),
            (Self::Whole, Lang::Cs) => format!("{address} musí být celé číslo"),
            (Self::Range(range), Lang::En) => format!("{address} takes {range}"),
            (Self::Range(range), Lang::Cs) => format!("{address} má rozsah {}", super::values::range_cs(range)),
            (Self::CorrectionDigits, Lang::En) => format!("{address} takes four digits, each 0, 1 or 2"),
            (Self::CorrectionDigits, Lang::Cs) => format!("{address} má čtyři číslice, každou 0, 1 nebo 2"),
            (Self::WrittenOut(function), Lang::En) => format!("{function} must be written out"),
            (Self::WrittenOut(function), Lang::Cs) => format!("{function} se musí v programu zapsat číslem"),
        }
    }
}
