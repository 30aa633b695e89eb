//! Advice about words that mean something else on other controls.

use crate::dict::{Lang, bilingual};

bilingual! {
    /// A legal word that is written for what it means on other controls (W0116).
    OtherMeaning {
        Call { l: i64 }
            "M98 does not call subprogram L{l} on this control",
            "M98 v tomto systému podprogram L{l} nevolá";
        SpeedLimit "G92 does not limit the speed on this control", "G92 v tomto systému neomezuje otáčky";
        Thread
            "G92 cuts no thread on this control: it writes a table",
            "G92 v tomto systému neřeže závit, ale zapisuje tabulku";
        ToolWithOffset { written: String, tool: i64 }
            "`{written}` is tool {tool} on this control",
            "{written} je v tomto systému nástroj {tool}";
        ModalOrigin
            "G53 holds until another zero offset: this motion still counts from it",
            "G53 platí do dalšího posunutí: i tento pohyb se počítá od něj";
        CuttingSpeed { s: i64 }
            "S{s} under G97 is a cutting speed on this control",
            "S{s} je při G97 v tomto systému řezná rychlost";
        RepeatByP { p: i64 } "P{p} does not repeat the jump on this control", "P{p} v tomto systému skok neopakuje";
    }
}

impl OtherMeaning {
    /// What to write instead; `count`: of the calls, where it is written.
    pub(super) fn help(&self, count: Option<i64>, lang: Lang) -> String {
        let count = count.map_or_else(String::new, |count| format!(" Q{count}"));
        match (self, lang) {
            (Self::Call { l }, Lang::En) => format!("a subprogram is called by `G71 L{l}{count}`"),
            (Self::Call { l }, Lang::Cs) => format!("podprogram volá „G71 L{l}{count}“"),
            (Self::Thread, Lang::En) => {
                "a thread is cut by G33, pass by pass; the values of a table are written without a feed".to_owned()
            }
            (Self::Thread, Lang::Cs) => {
                "závit řeže G33, po jednotlivých třískách; do bloku s hodnotami tabulky F nepatří".to_owned()
            }
            (Self::ToolWithOffset { tool, .. }, _) => {
                let tool = tool % 100;
                match lang {
                    Lang::En => format!("tool {tool} with correction {tool} is `T{tool} D{tool}`"),
                    Lang::Cs => format!("nástroj {tool} s korekcí {tool} se píše „T{tool} D{tool}“"),
                }
            }
            (Self::ModalOrigin, Lang::En) => {
                "behind a retraction write the zero offset of the work again, such as `G54`".to_owned()
            }
            (Self::ModalOrigin, Lang::Cs) => {
                "po odjezdu znovu zadat posunutí nulového bodu, například „G54“".to_owned()
            }
            (Self::CuttingSpeed { .. }, Lang::En) => {
                "with the speed of the spindle in S the feed is under G94 or G95; the key `g97` says what G97 is"
                    .to_owned()
            }
            (Self::CuttingSpeed { .. }, Lang::Cs) => {
                "otáčky vřetena udává S při G94 a G95; co znamená G97, určuje klíč g97".to_owned()
            }
            (Self::RepeatByP { p }, Lang::En) => format!("the number of jumps is written with `Q`: `Q{p}`"),
            (Self::RepeatByP { p }, Lang::Cs) => format!("počet skoků udává Q: „Q{p}“"),
            (Self::SpeedLimit, Lang::En) => {
                "the program cannot limit the speed: delete both; `S` would be the speed itself".to_owned()
            }
            (Self::SpeedLimit, Lang::Cs) => "otáčky zde omezit nelze: vymazat obojí; S by byly přímo otáčky".to_owned(),
        }
    }
}

/// The name of a G number of other controls in this language, where that is clear.
pub(super) fn foreign_g(number: u32, lang: Lang) -> &'static str {
    let (en, cs) = match number {
        20 | 21 => ("lengths are always in millimetres here", "délky jsou zde vždy v milimetrech"),
        28 => ("the reference point is approached by G30", "do reference se najíždí funkcí G30"),
        32 | 76 => ("threads are cut by G33", "závit se řeže funkcí G33"),
        43 | 44 | 49 => ("length corrections are chosen by `&` and `D`", "délkové korekce se volí adresami & a D"),
        50 => (
            "conversions are cancelled by G34; the program cannot limit the speed, and `S` beside it is the speed \
            itself",
            "přepočty ruší G34; otáčky zde omezit nelze: vymazat G50 i S",
        ),
        51 => ("coordinates are scaled by G36", "měřítko se zadává funkcí G36"),
        52 => ("origins are shifted by G54–G59, G92 and G93", "počátky se posouvají funkcemi G54–G59, G92 a G93"),
        60 | 61 => ("the basic state without continuous motion is G98", "základní stav bez plynulé jízdy je G98"),
        62 | 64 => ("continuous motion is G23", "plynulá jízda je G23"),
        65 | 66 => ("a macrocycle is called by G72", "makrocyklus se volá funkcí G72"),
        67 => (
            "a macrocycle is called by G72, in each block anew",
            "makrocyklus se volá funkcí G72, v každém bloku znovu",
        ),
        68 => ("a plane is transformed by G38 or G39", "rovina se transformuje funkcí G38 nebo G39"),
        69 => ("conversions are cancelled by G34", "přepočty ruší G34"),
        99 => ("feed per revolution is G95", "posuv na otáčku je G95"),
        _ => ("delete it, or write the function that was meant", "vymazat ji, nebo napsat funkci, která byla míněna"),
    };
    match lang {
        Lang::En => en,
        Lang::Cs => cs,
    }
}
