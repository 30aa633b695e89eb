//! Findings about characters, numbers and lines: E01xx and W01xx.

/// Hands these rows on, behind those before them.
macro_rules! characters {
    ([$next:ident $($rest:ident)*] $($before:tt)*) => {
        $next! { [$($rest)*] $($before)*
        [E0101] UnknownCharacter "unknown-character" Error { text: String, meant: Meant }
            en (match (super::shown::control_name(text), super::shown::control_inside(text)) {
                (Some(name), _) => format!("the character {name} means nothing to the control"),
                (None, Some((name, rest))) => {
                    format!("the character {name} inside `{rest}` means nothing to the control")
                }
                (None, None) => format!("`{text}` means nothing to the control"),
            })
            cs (match (super::shown::control_name(text), super::shown::control_inside(text)) {
                (Some(name), _) => format!("znak {name} řídicí systém nezná"),
                (None, Some((name, rest))) => format!("znak {name} uvnitř „{rest}“ řídicí systém nezná"),
                (None, None) => {
                    let what = if text.chars().count() == 1 { "znak" } else { "zápis" };
                    format!("{what} „{text}“ řídicí systém nezná")
                }
            })
            help (meant.text(Lang::En)) | (meant.text(Lang::Cs))
        [E0102] SplitNumber "split-number" Error { joined: String, loose: String, written: String }
            en (if is_exchanged(loose) {
                format!("the address is inside its number: `{loose}`")
            } else {
                "a blank inside a number".to_owned()
            })
            cs (if is_exchanged(loose) {
                format!("adresa je uvnitř čísla: „{loose}“")
            } else {
                "mezera uvnitř čísla".to_owned()
            })
            help (match (joined.is_empty(), loose.is_empty(), written.is_empty()) {
                (true, ..) if is_exchanged(loose) => {
                    format!("the address stands before its number: `{written}` in place of `{loose}`")
                }
                _ if is_exchanged(loose) => {
                    format!(
                        "the address stands before its number: `{written}` in place of `{loose}`; if only a blank is \
                        too many, write {}",
                        either(joined, Lang::En)
                    )
                }
                (true, true, _) => "write the parameter or the number, not both".to_owned(),
                (true, false, true) => format!("an address is missing before `{loose}`"),
                (true, false, false) => format!("an address is missing before `{loose}`: `{written}`?"),
                (_, true, _) => {
                    format!("write {}, or give the second number an address of its own", either(joined, Lang::En))
                }
                (_, false, true) => format!(
                    "an address is missing before `{loose}`; if it goes on with the number before it, write {}",
                    either(joined, Lang::En)
                ),
                (_, false, false) => format!(
                    "an address is missing before `{loose}`: `{written}`? If it goes on with the number before it, \
                    write {}",
                    either(joined, Lang::En)
                ),
            })
               | (match (joined.is_empty(), loose.is_empty(), written.is_empty()) {
                   (true, ..) if is_exchanged(loose) => {
                       format!("adresa se píše před číslo: „{written}“ místo „{loose}“")
                   }
                   _ if is_exchanged(loose) => format!(
                       "adresa se píše před číslo: „{written}“ místo „{loose}“; je-li navíc jen mezera, napsat {}",
                       either(joined, Lang::Cs)
                   ),
                   (true, true, _) => "napsat buď parametr, nebo číslo".to_owned(),
                   (true, false, true) => format!("před {loose} chybí adresa"),
                   (true, false, false) => format!("před {loose} chybí adresa: „{written}“?"),
                   (_, true, _) => {
                       format!("napsat {}, nebo druhému číslu doplnit adresu", either(joined, Lang::Cs))
                   }
                   (_, false, true) => format!(
                       "před {loose} chybí adresa; patří-li k předchozímu číslu, napsat {}",
                       either(joined, Lang::Cs)
                   ),
                   (_, false, false) => format!(
                       "před {loose} chybí adresa: „{written}“? Patří-li k předchozímu číslu, napsat {}",
                       either(joined, Lang::Cs)
                   ),
               })
            note (if is_exchanged(loose) {
                ""
            } else {
                "blanks are allowed between the address and its number, never inside the number or after its sign"
            })
               | (if is_exchanged(loose) {
                   ""
               } else {
                   "mezery smějí být mezi adresou a číslem, nikdy uvnitř čísla ani za jeho znaménkem"
               })
        [E0103] MissingValue "missing-value" Error { address: String, meant: ValueMeant }
            en "`{address}` has no value"
            cs "adresa {address} nemá hodnotu"
            help (meant.help(address, Lang::En)) | (meant.help(address, Lang::Cs))
            note (meant.note(address, Lang::En)) | (meant.note(address, Lang::Cs))
        [E0104] DecimalComma "decimal-comma" Error { meant: CommaMeant }
            en (meant.message(Lang::En))
            cs (meant.message(Lang::Cs))
            help (meant.text(Lang::En)) | (meant.text(Lang::Cs))
        [E0105] TypographicQuote "typographic-quote" Error { quote: char, meant: QuoteMeant }
            en "the typographic quote `{quote}` instead of `\"`"
            cs "typografické uvozovky {quote} místo obyčejných \""
            help (meant.text(Lang::En)) | (meant.text(Lang::Cs))
            note "the control takes only the plain quote for the border of a comment; all that follows would be read \
                as words"
               | "systém ohraničuje komentáře jen obyčejnými uvozovkami; text za jinými by četl jako slova programu"
        [E0106] MalformedNumber "malformed-number" Error { text: String, meant: NumberMeant }
            en (meant.message(text, Lang::En))
            cs (meant.message(text, Lang::Cs))
            help (meant.text(Lang::En)) | (meant.text(Lang::Cs))
            note (meant.note(Lang::En)) | (meant.note(Lang::Cs))
        [E0107] LetterForDigit "letter-for-digit" Error { fixed: String, without: String, comment: String }
            en "a letter in place of a digit"
            cs "místo číslice je písmeno"
            help (match (fixed.is_empty(), without.is_empty()) {
                _ if !comment.is_empty() => {
                    format!("write `{fixed}`, or put a comment between quotes: `\"{comment}\"`")
                }
                (true, true) => String::new(),
                (false, true) => format!("write `{fixed}`"),
                (true, false) => format!("if the letter is one too many, write `{without}`"),
                (false, false) => format!("write `{fixed}`, or `{without}` if the letter is one too many"),
            })
               | (match (fixed.is_empty(), without.is_empty()) {
                   _ if !comment.is_empty() => {
                       format!("napsat „{fixed}“, nebo komentář dát do uvozovek: \"{comment}\"")
                   }
                   (true, true) => String::new(),
                   (false, true) => format!("napsat „{fixed}“"),
                   (true, false) => format!("je-li písmeno navíc, napsat „{without}“"),
                   (false, false) => format!("napsat „{fixed}“, nebo „{without}“, je-li písmeno navíc"),
               })
        [W0108] LowercaseAddress "lowercase-address" Warning { count: usize }
            en (if *count == 1 {
                "an address in lower case".to_owned()
            } else {
                format!("{count} addresses in lower case, the first one here")
            })
            cs (if *count == 1 {
                "adresa malým písmenem".to_owned()
            } else {
                format!("adresy malými písmeny ({count}×), první je zde")
            })
            help "write addresses in upper case, as the manual does"
               | "psát adresy velkými písmeny jako příručka"
        [E0109] LineTooLong "line-too-long" Error { length: usize }
            en "the line has {length} characters; the control reads 80"
            cs "řádek má {length} znaků; systém jich čte 80"
            help "break the line between two words; a comment that goes on in the next line begins there with its own quote"
               | "rozdělit řádek mezi dvěma slovy; komentář, který pokračuje na dalším řádku, tam musí začít vlastní uvozovkou"
        [W0110] TextAfterEnd "text-after-end" Warning { meant: AfterEndMeant }
            en (meant.message(Lang::En))
            cs (meant.message(Lang::Cs))
            help (meant.text(Lang::En)) | (meant.text(Lang::Cs))
        [E0111] StrayText "stray-text" Error { text: String, meant: TextMeant }
            en "`{text}` is text outside a comment"
            cs "„{text}“ je text mimo komentář"
            help (meant.text(Lang::En)) | (meant.text(Lang::Cs))
        [E0112] UnreadableFile "unreadable-file" Error { problem: crate::diag::Problem, file: Option<String> }
            en ({
                let (file, reason) = (file.as_deref().unwrap_or("the file"), problem.text(Lang::En));
                format!("{file} cannot be read: {reason}")
            })
            cs ({
                let (file, reason) = (file.as_deref().unwrap_or("soubor"), problem.text(Lang::Cs));
                format!("{file} nelze přečíst: {reason}")
            })
        [W0113] OtherControlProgram "other-control" Warning { control: OtherControl }
            en ({
                let control = control.text(Lang::En);
                format!("this program is written for another control: {control}")
            })
            cs ({
                let control = control.text(Lang::Cs);
                format!("program je napsán pro jiný řídicí systém: {control}")
            })
            help "let the postprocessor write it for this control; `cnc872c explain W0113` says what to change by hand"
               | "nechat ho vygenerovat postprocesorem pro tento systém; co změnit ručně, řekne „cnc872c explain W0113“"
            note "of each line only the first finding is shown; `cnc872c check -A other-control` shows all"
               | "z každého řádku je jen první hlášení; všechna ukáže „cnc872c check -A other-control“"
        [W0114] CommentSwallowsWords "comment-swallows-words" Warning { words: String, meant: QuoteMeant }
            en (meant.swallows(words, Lang::En))
            cs (meant.swallows(words, Lang::Cs))
            help (meant.text(Lang::En)) | (meant.text(Lang::Cs))
        [E0115] Utf16 "utf-16" Error {}
            en "the file is in UTF-16; the control reads single bytes"
            cs "soubor je v kódování UTF-16; systém čte jednotlivé bajty"
            help "save it as UTF-8, or in the code page of the control"
               | "uložit ho jako UTF-8, nebo v kódové stránce systému"
        [W0116] OtherMeaning "other-meaning" Warning { meant: OtherMeaning, count: Option<i64> }
            en (meant.text(Lang::En))
            cs (meant.text(Lang::Cs))
            help (meant.help(*count, Lang::En)) | (meant.help(*count, Lang::Cs))

        }
    };
}
pub(super) use characters;
