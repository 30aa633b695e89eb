//! Advice in the texts of some diagnostics, in both languages: closed sets of probable meanings.

use super::CenterPlace;
use crate::dict::{Address, GCode, HIGHEST_L, Lang, bilingual};
use crate::sure::Sure;

bilingual! {
    /// What was probably meant by something that is no number (E0106).
    NumberMeant {
        Form
            "a number has at most one sign, digits, and at most one decimal point: `X-12.5`; each number follows its \
            own address",
            "číslo má nejvýše jedno znaménko, číslice a nejvýše jednu desetinnou tečku: „X-12.5“; každé číslo stojí \
            za svou adresou";
        NoAddress "write it behind its address, on the same line", "napsat ho za jeho adresu na tentýž řádek";
        BlockNumber { written: String }
            "if it is a block number, write `{written}`",
            "je-li to číslo bloku, napsat „{written}“";
        Ruler
            "a line between blocks is a comment, between quotes: `\"-----\"`",
            "čára mezi bloky se píše jako komentář do uvozovek: \"-----\"";
        AddressMissing { loose: String, written: String }
            "an address is missing before `{loose}`: `{written}`?",
            "před {loose} chybí adresa: „{written}“?";
        Divided { written: String }
            "nothing is divided here: write the result, `{written}`",
            "dělit se zde nedá: napsat výsledek, „{written}“";
        Undivided
            "nothing is divided here: write the result; `/` is a block skip and stands behind the block number",
            "dělit se zde nedá: napsat výsledek; / znamená vynechání bloku a stojí za číslem bloku";
        Computed
            "there are no expressions; G26 to G29 compute with parameters",
            "výrazy se psát nedají; s parametry počítají G26 až G29";
        Exponent { written: String }
            "a number has no exponent: write `{written}`",
            "číslo se píše bez exponentu: „{written}“";
        ExponentOrAddress { written: String }
            "a number has no exponent: write `{written}`, or another address in place of `E`",
            "číslo se píše bez exponentu: „{written}“; je-li E místo jiné adresy, napsat ji";
        ExponentForm "a number has no exponent: write out its digits", "číslo se píše bez exponentu, všemi číslicemi";
        NotANumber
            "whatever wrote the file had no value here; write the number that was meant",
            "program, který soubor vytvořil, zde neměl platnou hodnotu; napsat číslo, které bylo míněno";
        Fastest
            "rapid motion is programmed by G00; a feed is a number: `F200`",
            "rychloposuv se programuje funkcí G00; posuv je číslo: „F200“";
        Equals { written: String } "write it without `=`: `{written}`", "napsat bez rovnítka: „{written}“";
        EqualsOrMinus { written: String, minus: String }
            "write it without `=`: `{written}`, or `{minus}` if a minus was meant",
            "napsat bez rovnítka: „{written}“, nebo „{minus}“, mělo-li to být minus";
        EqualsForm
            "only an assignment to a parameter has `=`, and only one: `R10=5`; all other words are written without: \
            `X45`",
            "rovnítko patří jen do přiřazení parametru, a to jediné: „R10=5“; ostatní slova se píší bez něj: „X45“";
        Distance
            "write the number without a name: under G91 it is a distance, under G90 a coordinate",
            "napsat jen číslo: při G91 je to přírůstek, při G90 souřadnice";
        FromStart
            "write the number without a name: the distance from the start of the arc to its centre, under G90 too",
            "napsat jen číslo: vzdálenost od začátku oblouku ke středu, a to i při G90";
        SignBehind { written: String }
            "write the sign behind the address: `{written}`",
            "znaménko psát až za adresu: „{written}“";
        SignBeforeEquals { written: String }
            "a sign belongs behind the `=`: `{written}`; to subtract or add, G26 to G29 compute with parameters",
            "znaménko patří až za rovnítko: „{written}“; odčítat nebo sčítat parametry umí G26 až G29";
        OneSpindle { written: String }
            "the control has one spindle: `{written}`",
            "systém má jediné vřeteno: „{written}“";
        ToolName "a tool has a number, not a name: `T1`", "nástroj má číslo, ne jméno: „T1“";
        LetterTwice { written: String }
            "the address is written twice: `{written}`",
            "adresa je napsána dvakrát: „{written}“";
        Radius
            "there is no radius word: write the centre of the arc by `I` and `J`, its distances from the start",
            "poloměr zde zadat nelze: střed oblouku udávají I a J, vzdálenosti od začátku oblouku";
        Parameter
            "R takes the number of a parameter, 0 to 95, and its value: `R10=5.5`",
            "R má číslo parametru 0 až 95 a jeho hodnotu: „R10=5.5“";
    }
}

impl NumberMeant {
    /// The mistake in `text`.
    pub(super) fn message(&self, text: &str, lang: Lang) -> String {
        let of_number = matches!(
            self,
            Self::Form
                | Self::Divided { .. }
                | Self::Undivided
                | Self::Exponent { .. }
                | Self::ExponentOrAddress { .. }
                | Self::ExponentForm
                | Self::NotANumber
                | Self::Fastest
        );
        match (lang, of_number, matches!(self, Self::NoAddress | Self::BlockNumber { .. })) {
            (Lang::En, _, true) => format!("the number `{text}` has no address"),
            (Lang::Cs, _, true) => format!("číslo {text} nemá adresu"),
            (Lang::En, true, false) => format!("`{text}` is not a valid number"),
            (Lang::Cs, true, false) => format!("„{text}“ není platné číslo"),
            (Lang::En, false, false) => format!("`{text}` is not a valid word"),
            (Lang::Cs, false, false) => format!("„{text}“ není platné slovo"),
        }
    }

    /// Why it is so.
    pub(super) fn note(&self, lang: Lang) -> &'static str {
        match (self, lang) {
            (Self::Radius | Self::Parameter, Lang::En) => {
                "R is a parameter on this control, never a radius or a height"
            }
            (Self::Radius | Self::Parameter, Lang::Cs) => "R je v tomto systému parametr, nikdy poloměr ani výška",
            _ => "",
        }
    }
}

bilingual! {
    /// What was meant by a comma in a number (E0104).
    CommaMeant {
        Point { written: String }
            "the control knows the decimal point only: write `{written}`",
            "systém zná jen desetinnou tečku: napsat „{written}“";
        Apart { written: String }
            "write `{written}`, or give the second number an address of its own",
            "napsat „{written}“, nebo druhému číslu doplnit adresu";
        Border { written: String }
            "separate words with blanks, never with commas: write `{written}`",
            "slova se oddělují mezerami, nikdy čárkami: napsat „{written}“";
        Whole { address: Address } "{address} takes whole numbers only", "{address} má jen celá čísla";
        WholeWritten { written: String, digits: String }
            "the number is whole: write `{written}`, or `{digits}` if the comma is one too many",
            "je to celé číslo: napsat „{written}“, nebo „{digits}“, je-li čárka navíc";
        Dwell { written: String }
            "the dwell takes whole units of 10 ms; if seconds are meant, write `{written}`",
            "prodleva se zadává v celých jednotkách po 10 ms; jsou-li míněny sekundy, napsat „{written}“";
    }
}

impl CommaMeant {
    /// The mistake.
    pub(super) const fn message(&self, lang: Lang) -> &'static str {
        match (self, lang) {
            (Self::Border { .. }, Lang::En) => "a comma behind a word",
            (Self::Border { .. }, Lang::Cs) => "za slovem je čárka",
            (_, Lang::En) => "a decimal comma",
            (_, Lang::Cs) => "desetinná čárka",
        }
    }
}

bilingual! {
    /// What was meant by a quote without its second one (E0105, W0114).
    QuoteMeant {
        Empty
            "if a comment ends here, write a quote where it begins; else delete this one",
            "končí-li tu komentář, doplnit uvozovky na jeho začátek; jinak tyto uvozovky vymazat";
        Plain "write the plain quote `\"`", "napsat obyčejné uvozovky \"";
        Number
            "write the number without the quote; if a comment begins there, close it",
            "napsat číslo bez uvozovek; začíná-li tu komentář, uzavřít ho";
        Closed
            "if these are words of the program, close the comment before them; if they are a part of the comment, \
            behind them",
            "patří-li do programu, ukončit komentář uvozovkami před nimi; patří-li do komentáře, až za nimi";
    }
}

impl QuoteMeant {
    /// The message of W0114.
    pub(super) fn swallows(&self, words: &str, lang: Lang) -> String {
        match (self, lang) {
            (Self::Empty, Lang::En) => "the line ends in an empty comment without closing quote".to_owned(),
            (Self::Empty, Lang::Cs) => "řádek končí prázdným komentářem bez koncových uvozovek".to_owned(),
            (Self::Number, Lang::En) => format!("a quote within a number makes a comment of `{words}`"),
            (Self::Number, Lang::Cs) => format!("uvozovky uvnitř čísla dělají z „{words}“ komentář"),
            (Self::Plain | Self::Closed, Lang::En) => {
                format!("the comment has no closing quote and swallows `{words}`")
            }
            (Self::Plain | Self::Closed, Lang::Cs) => format!("komentář bez koncových uvozovek spolkl „{words}“"),
        }
    }
}

/// Whether a minus before a number of that address may be that of a position, whose letter is another key.
pub(super) const fn is_value(address: Address) -> bool {
    matches!(address, Address::F | Address::S | Address::T | Address::D | Address::H | Address::P | Address::Q)
}

/// Whether the separate number holds the letter that belongs before it: `4Y0`.
pub(super) fn is_exchanged(loose: &str) -> bool {
    let number = loose.starts_with(|first: char| first.is_ascii_digit() || "+-.".contains(first));
    number && loose.contains(|c: char| c.is_ascii_alphabetic()) && !loose.contains('=')
}

/// Words to write, one of those that ` / ` separates, each between quotes.
pub(super) fn either(words: &str, lang: Lang) -> String {
    match lang {
        Lang::En => format!("`{}`", words.replace(" / ", "` or `")),
        Lang::Cs => format!("„{}“", words.replace(" / ", "“ nebo „")),
    }
}

bilingual! {
    /// What was probably meant by a name that is no address (E0301).
    AddressMeant {
        Word
            "delete the word, or write the address that was meant",
            "slovo vymazat, nebo napsat adresu, která byla míněna";
        Zero "a program is numbered with `%`; the digit zero is `0`", "číslo programu se píše s %; číslice nula je „0“";
        Radius
            "there is no radius word: write the centre of the arc by `I` and `J`, its distances from the start",
            "poloměr zde zadat nelze: střed oblouku udávají I a J, vzdálenosti od začátku oblouku";
        Rounding
            "corners are not rounded or chamfered by a word: write the arc or the line as a block of its own",
            "zaoblení ani zkosení rohu se slovem nezadává: napsat oblouk nebo úsečku jako samostatný blok";
        Polar
            "polar coordinates do not exist here: write those of the axes",
            "polární souřadnice zde nejsou: napsat souřadnice os";
        Spindle
            "M19 orients the spindle; its angle is the word of the spindle axis: `C90`",
            "vřeteno polohuje M19; úhel udává slovo osy vřetena: „C90“";
        SpeedLimit
            "the program cannot limit the speed; `S` is the speed itself",
            "otáčky zde omezit nelze; S jsou přímo otáčky";
        Named
            "an address is one letter; values with names are parameters: `R10=5`",
            "adresa je jediné písmeno; pojmenované hodnoty jsou zde parametry: „R10=5“";
    }
}

impl super::Finding {
    /// A letter that is no address.
    pub fn unknown_address(letter: char) -> Self {
        let letter = letter.to_ascii_uppercase();
        let meant = if letter == 'O' { AddressMeant::Zero } else { AddressMeant::Word };
        Self::UnknownAddress { address: letter.to_string(), meant }
    }
}

impl AddressMeant {
    /// Advice for a name with a value.
    pub fn by_name(name: &str) -> Self {
        match name.to_ascii_uppercase().as_str() {
            "CR" | "AR" => Self::Radius,
            "RND" | "RNDM" | "CHF" | "CHR" | "RN" => Self::Rounding,
            "AP" | "RP" => Self::Polar,
            "SPOS" | "SPOSA" => Self::Spindle,
            "LIMS" => Self::SpeedLimit,
            _ => Self::Named,
        }
    }
}

bilingual! {
    /// What was probably meant by text outside a comment (E0111).
    TextMeant {
        Comment { text: String }
            "if it is meant as a comment, put it between quotes: `\"{text}\"`",
            "má-li to být komentář, dát ho do uvozovek: \"{text}\"";
        WithWords { text: String, words: String, all: String }
            "put the comment between quotes: `\"{all}\"`; where `{words}` belongs to the program, `\"{text}\" {words}`",
            "komentář dát do uvozovek: \"{all}\"; patří-li {words} do programu, tak \"{text}\" {words}";
        Addressed { address: Address, text: String }
            "if it is a word, write the number of `{address}`; if it is a comment, put it between quotes: `\"{text}\"`",
            "je-li to slovo, napsat číslo adresy {address}; je-li to komentář, dát ho do uvozovek: \"{text}\"";
        OpenQuote { text: String }
            "a quote is missing where the comment begins, here or further left: `\"{text}\"`",
            "chybí uvozovky, kterými komentář začíná, zde nebo dále vlevo: \"{text}\"";
        SwallowedBefore { words: String }
            "the comment before swallows `{words}`: fix its quotes",
            "předchozí komentář spolkl „{words}“: opravit jeho uvozovky";
        InNumber { words: String }
            "a quote within a number makes a comment of `{words}`: write the number without it",
            "uvozovky uvnitř čísla dělají z „{words}“ komentář: napsat číslo bez nich";
        Unit
            "delete it: lengths are in mm, feeds in mm/min, under G95 in mm/rev",
            "vymazat: délky jsou v mm, posuvy v mm/min, při G95 v mm/ot";
        OtherUnit
            "feeds are in mm/min: write the number for that, without a unit",
            "posuvy jsou v mm/min: přepočítat číslo a jednotku nepsat";
        Call
            "there is no such statement; a subprogram is called by `G71 L100`, a macrocycle by `G72 L9001`",
            "takový příkaz zde není; podprogram se volá „G71 L100“, makrocyklus „G72 L9001“";
        Jump
            "there is no such statement; a jump, for example to block N190, is `G73 L190`",
            "takový příkaz zde není; skok například na blok N190 se píše „G73 L190“";
        JumpTo { l: u32 }
            "there is no such statement; a jump to block N{l} is `G73 L{l}`",
            "takový příkaz zde není; skok na blok N{l} se píše „G73 L{l}“";
        Cycle
            "there is no such statement; fixed cycles are G81 to G89, in force until G80 or another of their group",
            "takový příkaz zde není; pevné cykly jsou G81 až G89 a platí až do G80 nebo jiné funkce své skupiny";
        Frame
            "there is no such statement; origins are chosen by G54 to G59",
            "takový příkaz zde není; počátky se volí funkcemi G54 až G59";
        Tool
            "there is no such statement; a tool is called by `T1 M06`",
            "takový příkaz zde není; nástroj se volá „T1 M06“";
        Transform
            "there is no such statement; transformations are G31 and G35 to G39",
            "takový příkaz zde není; transformace jsou G31 a G35 až G39";
        Center
            "there is no such statement; the centre of an arc is written in its block by `I` and `J`",
            "takový příkaz zde není; střed oblouku se píše do jeho bloku adresami I a J";
        Correction
            "the radius is corrected by G41 and G42, with a correction `D`",
            "poloměr korigují funkce G41 a G42 s korekcí D";
        NoNeed "there is no such statement: delete it", "takový příkaz zde není: vymazat ho";
        Entry
            "there is no such statement; a subprogram begins with `G79 L100`",
            "takový příkaz zde není; podprogram začíná „G79 L100“";
        Definition
            "values have no names here; parameters are R0 to R95: `R10=5`",
            "hodnoty zde nemají jména; parametry jsou R0 až R95: „R10=5“";
        Return
            "there is no such statement; a subprogram ends with G70",
            "takový příkaz zde není; podprogram končí funkcí G70";
        End
            "there is no such statement; a program ends with M30, a subprogram with G70",
            "takový příkaz zde není; program končí funkcí M30, podprogram G70";
        Condition
            "there are no conditions and loops; a jump, for example to block N190, is `G73 L190`; `G73 L190 Q2` jumps \
            twice, the stretch runs three times",
            "podmínky ani cykly zde nejsou; skok například na blok N190 se píše „G73 L190“; „G73 L190 Q2“ skočí \
            dvakrát, úsek proběhne třikrát";
        ConditionTo { l: u32 }
            "there are no conditions and loops; a jump to block N{l} is `G73 L{l}`; `G73 L{l} Q2` jumps twice, the \
            stretch runs three times",
            "podmínky ani cykly zde nejsou; skok na blok N{l} se píše „G73 L{l}“; „G73 L{l} Q2“ skočí dvakrát, úsek \
            proběhne třikrát";
        Message
            "a message to the operator is a comment here: write the text alone, between quotes",
            "hlášení pro obsluhu je zde komentář: napsat jen text v uvozovkách";
    }
}

impl TextMeant {
    /// The advice for a statement of other controls, where `text` begins with one.
    pub fn statement(text: &str) -> Option<Self> {
        let name: String = text.chars().take_while(char::is_ascii_alphabetic).collect();
        let cycle = text.get(name.len()..).is_some_and(|rest| rest.starts_with(|c: char| c.is_ascii_digit()));
        let numbered = text.get(name.len()..).sure().trim_start_matches([' ', '\t']);
        let loop_end = numbered.starts_with(|first: char| first.is_ascii_digit());
        Some(match name.to_ascii_uppercase().as_str() {
            "CALL" | "EXTCALL" | "PCALL" => Self::Call,
            "GOTO" | "GOTOB" | "GOTOF" | "GOTOC" | "GOTOS" | "LBL" => {
                jump_in(text).map_or(Self::Jump, |l| Self::JumpTo { l })
            }
            "TRANS" | "ATRANS" => Self::Frame,
            "TOOL" => Self::Tool,
            "ROT" | "AROT" | "MIRROR" | "AMIRROR" | "SCALE" | "ASCALE" => Self::Transform,
            "CC" => Self::Center,
            "RL" | "RR" if numbered.is_empty() => Self::Correction,
            "STOPRE" => Self::NoNeed,
            "MCALL" | "CYCL" => Self::Cycle,
            "CYCLE" if cycle => Self::Cycle,
            "PROC" => Self::Entry,
            "DEF" | "FN" => Self::Definition,
            "RET" => Self::Return,
            "END" if !loop_end => Self::End,
            "IF" | "ELSE" | "ELSEIF" | "ENDIF" | "WHILE" | "ENDWHILE" | "FOR" | "ENDFOR" | "LOOP" | "ENDLOOP"
            | "REPEAT" | "REPEATB" | "UNTIL" | "CASE" | "END" => {
                jump_in(text).map_or(Self::Condition, |l| Self::ConditionTo { l })
            }
            _ => return None,
        })
    }
}

/// The block that a statement of other controls jumps to: `GOTOB N60`, `IF R20<100 GOTO 60`.
fn jump_in(text: &str) -> Option<u32> {
    let upper = text.to_ascii_uppercase();
    let (_, behind) = upper.split_once("GOTO")?;
    let number = behind.trim_start_matches(['F', 'B', 'C', 'S', ' ', '\t', 'N']);
    let digits: String = number.chars().take_while(char::is_ascii_digit).collect();
    digits.parse().ok().filter(|l| (1..=HIGHEST_L).contains(l))
}

bilingual! {
    /// What was probably meant by a call or jump without L (E0401).
    TargetMeant {
        Subprogram "write the number of the subprogram: `L100`", "doplnit číslo podprogramu: „L100“";
        OneOf { known: String }
            "write the number of the subprogram; the file has {known}",
            "doplnit číslo podprogramu; podprogramy v souboru: {known}";
        Millimetres
            "delete it if millimetres are meant: lengths are always in millimetres; if a call is meant, write the \
            number of the subprogram with `L`",
            "měla-li to být volba milimetrů, vymazat ji: délky jsou zde vždy v milimetrech; mělo-li to být volání, \
            doplnit číslo podprogramu s L";
        InPlace { block: String }
            "write the number of the subprogram with `L` in place of `{block}`: `L100`",
            "místo {block} napsat číslo podprogramu s L: „L100“";
        Macrocycle "write the number of the macrocycle: `L9001`", "doplnit číslo makrocyklu: „L9001“";
        Block "write the number of the block to jump to: `L…`", "doplnit číslo bloku, na který se skáče: „L…“";
        Written { written: String } "the number is written with `L`: `{written}`", "cíl se píše s L: „{written}“";
        Turning
            "turning cycles do not exist here: write the passes as blocks, or call a macrocycle by `G72 L…`",
            "soustružnické cykly zde nejsou: rozepsat třísky do bloků, nebo volat makrocyklus „G72 L…“";
        Drilling "the drilling cycles are G81 to G89 here", "vrtací cykly jsou zde G81 až G89";
    }
}

impl TargetMeant {
    /// The plain advice for a call or jump without L.
    pub const fn of(function: GCode) -> Self {
        if matches!(function, GCode::G73) {
            Self::Block
        } else if matches!(function, GCode::G72) {
            Self::Macrocycle
        } else {
            Self::Subprogram
        }
    }

    /// The function's effect here, where people take it for another one.
    pub(super) fn note(&self, function: GCode, lang: Lang) -> String {
        if !matches!(self, Self::Turning | Self::Drilling) {
            return String::new();
        }
        let (en, cs) = if function == GCode::G73 {
            ("jumps to a block", "skáče na blok")
        } else if function == GCode::G72 {
            ("calls a macrocycle", "volá makrocyklus")
        } else {
            ("calls a subprogram", "volá podprogram")
        };
        match lang {
            Lang::En => format!("{function} {en} on this control"),
            Lang::Cs => format!("{function} v tomto systému {cs}"),
        }
    }
}

bilingual! {
    /// What was probably meant by a dwell without Q (E0411).
    DwellMeant {
        Seconds { address: Address, written: String }
            "if {address} is meant as the dwell in seconds, write `{written}` in its place; if not, add the dwell: \
            `Q100` is one second",
            "je-li {address} míněno jako prodleva v sekundách, napsat místo něj „{written}“; jinak doplnit délku \
            prodlevy: „Q100“ je jedna sekunda";
        Perhaps { address: Address, written: String }
            "if {address} is meant in milliseconds, write `{written}` in its place; if it is a coordinate, add the \
            dwell: `Q100` is one second",
            "je-li {address} míněno v milisekundách, napsat místo něj „{written}“; je-li to souřadnice, doplnit délku \
            prodlevy: „Q100“ je jedna sekunda";
        Units
            "write the dwell in units of 10 ms: `Q100` is one second",
            "doplnit délku prodlevy po 10 ms: „Q100“ je jedna sekunda";
        Written { written: String }
            "the dwell is written with `Q`, in units of 10 ms: `{written}`",
            "délka prodlevy se píše s Q v jednotkách po 10 ms: „{written}“";
    }
}

bilingual! {
    /// What was probably meant by a decimal point where none may stand (E0304).
    PointMeant {
        Plain "write a whole number", "napsat celé číslo";
        Whole { written: String } "write `{written}`", "napsat „{written}“";
        WholeOrDigits { written: String, digits: String }
            "write `{written}`, or `{digits}` if the point is one too many",
            "napsat „{written}“, nebo „{digits}“, je-li tečka navíc";
        Dwell "`Q100` is one second", "„Q100“ je jedna sekunda";
        Seconds { written: String }
            "if seconds are meant, write `{written}`",
            "jsou-li míněny sekundy, napsat „{written}“";
        Origin "the origins are G53 to G59", "počátky jsou G53 až G59";
        Function "functions have whole numbers of two digits", "funkce mají jen dvoumístná celá čísla";
    }
}

impl PointMeant {
    /// Whether it is about the dwell of G04.
    pub(super) const fn is_dwell(&self) -> bool {
        matches!(self, Self::Dwell | Self::Seconds { .. })
    }
}

bilingual! {
    /// What was probably meant by an L without use (W0402).
    UnusedMeant {
        Target
            "`L` goes with a function: G71 calls a subprogram, G72 a macrocycle, G73 jumps to a block",
            "L patří k funkci: G71 volá podprogram, G72 makrocyklus, G73 skáče na blok";
        Jump { written: String }
            "if a jump is meant, write `{written}`; a subprogram is called by G71, a macrocycle by G72",
            "měl-li to být skok, napsat „{written}“; podprogram volá G71, makrocyklus G72";
        CallOrJump { call: String, jump: String }
            "if a call is meant, write `{call}`; if a jump, `{jump}`",
            "mělo-li to být volání, napsat „{call}“, měl-li to být skok, „{jump}“";
        Call { written: String }
            "M98 calls nothing here; a subprogram is called by `{written}`",
            "M98 zde nevolá podprogram; volá ho „{written}“";
        Exchanged { written: String }
            "if a call or jump is meant, write `{written}`",
            "mělo-li to být volání nebo skok, napsat „{written}“";
        Alone { written: String }
            "a subprogram is called by `{written}`; a jump is written with G73, the call of a macrocycle with G72",
            "podprogram volá „{written}“; skok se píše s G73, volání makrocyklu s G72";
        Macrocycle { written: String } "a macrocycle is called by `{written}`", "makrocyklus volá „{written}“";
        Tables
            "G10 is the pitch of a spiral here; origins are written by G92 with G54 to G59; X, Y and Z in this block \
            move",
            "G10 je zde stoupání spirály; počátky zapisuje G92 s funkcí G54 až G59; X, Y a Z v tomto bloku jsou pohyb";
    }
}

/// That some of I, J and K have no use (E0609), and why.
pub(super) fn unused_centers(letters: &str, place: &CenterPlace, lang: Lang) -> String {
    let (why, one) = (place.text(lang), letters.len() == 1);
    let (quote, verb) = match (lang, one) {
        (Lang::En, true) => ("`", "means nothing here"),
        (Lang::En, false) => ("`", "mean nothing here"),
        (Lang::Cs, true) => ("", "zde nemá význam"),
        (Lang::Cs, false) => ("", "zde nemají význam"),
    };
    let letters: Vec<String> = letters.chars().map(|letter| format!("{quote}{letter}{quote}")).collect();
    format!("{} {verb}: {why}", letters.join(", "))
}

/// What to write instead of I, J or K without a use (E0609).
pub(super) fn center_help(letters: &str, written: &str, lang: Lang) -> String {
    match (written, lang) {
        ("", Lang::En) if letters.len() > 1 => "delete them, or program the function that they belong to".to_owned(),
        ("", Lang::Cs) if letters.len() > 1 => "vymazat je, nebo zadat funkci, ke které patří".to_owned(),
        ("", Lang::En) => "delete it, or program the function that it belongs to".to_owned(),
        ("", Lang::Cs) => "vymazat ho, nebo zadat funkci, ke které patří".to_owned(),
        (written, Lang::En) => format!("write `{written}`"),
        (written, Lang::Cs) => format!("napsat „{written}“"),
    }
}

/// What to write where a line lacks its block number.
pub(super) const fn unnumbered_line(lang: Lang) -> &'static str {
    match lang {
        Lang::En => "the line does not begin with a block number: begin it with `N…`",
        Lang::Cs => "řádek nezačíná číslem bloku: začít ho „N…“",
    }
}
