//! How a word is written: its address in upper case, no blanks within, its number by the style (FMT-2, FMT-5).

use crate::config::{Codes, Numbers, Style};
use crate::dict::Address;

/// Appends a well-formed word as the style writes it; `false`, and nothing is appended, when it is not well-formed.
pub(super) fn write(word: &str, style: Style, out: &mut String) -> bool {
    let length = out.len();
    let done = Writer { rest: word, style, out }.word().is_some();
    if !done {
        out.truncate(length);
    }
    done
}

/// Whether a word is written as the style writes it, by a quick look: many that are get `false`.
pub(super) fn is_tidy(word: &str, style: Style) -> bool {
    let digits = |bytes: &[u8]| !bytes.is_empty() && bytes.iter().all(u8::is_ascii_digit);
    match word.as_bytes() {
        [b'G' | b'M', code @ ..] => match style.codes {
            Codes::TwoDigits => digits(code) && (code.len() == 2 || (code.len() > 2 && !code.starts_with(b"0"))),
            Codes::Short => digits(code) && (code.len() == 1 || !code.starts_with(b"0")),
            Codes::Keep => digits(code),
        },
        [b'N' | b'T' | b'D' | b'L' | b'Q' | b'H' | b'P', number @ ..] => digits(number),
        [b'A'..=b'C' | b'U'..=b'Z' | b'I'..=b'K' | b'F' | b'S', value @ ..] if style.numbers == Numbers::Keep => {
            let value = value.strip_prefix(b"-").unwrap_or(value);
            let mut points = 0;
            let number = |byte: &u8| byte.is_ascii_digit() || (*byte == b'.' && std::mem::replace(&mut points, 1) == 0);
            value.first().is_some_and(u8::is_ascii_digit) && value.iter().all(number)
        }
        _ => false,
    }
}

struct Writer<'a, 'b> {
    rest: &'a str,
    style: Style,
    out: &'b mut String,
}

impl<'a> Writer<'a, '_> {
    fn word(&mut self) -> Option<()> {
        let letter = self.rest.chars().next().filter(char::is_ascii)?.to_ascii_uppercase();
        self.rest = self.rest.get(1..)?;
        self.out.push(letter);
        self.blanks();
        match letter {
            '/' => {
                let digits = self.digits();
                self.out.push_str(digits);
            }
            'R' => self.assignment()?,
            _ => self.value(letter)?,
        }
        self.rest.is_empty().then_some(())
    }

    /// `R10=25.5`, `R10 25.5`, `R10-5`.
    fn assignment(&mut self) -> Option<()> {
        let number = self.digits();
        self.out.push_str(number);
        let blank = self.blanks();
        if let Some(rest) = self.rest.strip_prefix('=') {
            self.rest = rest;
            self.blanks();
            self.out.push('=');
        } else if blank {
            self.out.push(' ');
        }
        (!number.is_empty()).then_some(())?;
        self.value('R')
    }

    /// A number or a parameter, with its sign.
    fn value(&mut self, letter: char) -> Option<()> {
        if let Some(sign @ ('+' | '-')) = self.rest.chars().next() {
            self.out.push(sign);
            self.rest = self.rest.get(1..)?;
        }
        if let Some(rest) = self.rest.strip_prefix(['R', 'r']) {
            self.rest = rest;
            self.blanks();
            let number = self.digits();
            self.out.push('R');
            self.out.push_str(number);
            return (!number.is_empty()).then_some(());
        }
        let whole = self.digits();
        let fraction = self.rest.strip_prefix('.').map(|rest| {
            self.rest = rest;
            self.digits()
        });
        if whole.is_empty() && fraction.is_none_or(str::is_empty) {
            return None;
        }
        self.number(letter, whole, fraction);
        Some(())
    }

    fn number(&mut self, letter: char, whole: &str, fraction: Option<&str>) {
        let significant = || match whole.trim_start_matches('0') {
            "" => "0",
            digits => digits,
        };
        let code = matches!(letter, 'G' | 'M') && fraction.is_none();
        let address = u8::try_from(letter).ok().and_then(Address::from_byte);
        let dimension = address.is_some_and(Address::is_dimensional);
        match (self.style.codes, self.style.numbers) {
            (Codes::TwoDigits, _) if code => {
                if significant().len() < 2 {
                    self.out.push('0');
                }
                self.out.push_str(significant());
            }
            (Codes::Short, _) if code => self.out.push_str(significant()),
            (_, Numbers::Short) if dimension => {
                self.out.push_str(significant());
                let fraction = fraction.unwrap_or_default().trim_end_matches('0');
                if !fraction.is_empty() {
                    self.out.push('.');
                    self.out.push_str(fraction);
                }
            }
            _ => {
                self.out.push_str(whole);
                if let Some(fraction) = fraction {
                    self.out.push('.');
                    self.out.push_str(fraction);
                }
            }
        }
    }

    fn digits(&mut self) -> &'a str {
        let end = self.rest.bytes().take_while(u8::is_ascii_digit).count();
        let (digits, rest) = self.rest.split_at(end);
        self.rest = rest;
        digits
    }

    /// Passes over blanks; whether there was one.
    fn blanks(&mut self) -> bool {
        let rest = self.rest.trim_start_matches([' ', '\t']);
        let some = rest.len() < self.rest.len();
        self.rest = rest;
        some
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn written(word: &str, codes: Codes, numbers: Numbers) -> Option<String> {
        let mut out = String::new();
        let style = Style { codes, numbers, ..Style::default() };
        write(word, style, &mut out).then_some(out)
    }

    /// FMT-2, FMT-5: blanks and case, two digits for codes; numbers stay.
    #[test]
    fn as_without_configuration() {
        for (word, expected) in [
            ("g1", "G01"),
            ("G 001", "G01"),
            ("M100", "M100"),
            ("m0", "M00"),
            ("x  36.120", "X36.120"),
            ("X.5", "X.5"),
            ("x - r5", ""),
            ("x -r 05", "X-R05"),
            ("R10 = 25.5", "R10=25.5"),
            ("r 10 \t 25.5", "R10 25.5"),
            ("R10-5", "R10-5"),
            ("R11= r 10", "R11=R10"),
            ("/ 2", "/2"),
            ("%  1", "%1"),
            ("&0010", "&0010"),
            ("GR1", "GR1"),
            ("X", ""),
            ("X1 5", ""),
            ("R10", ""),
        ] {
            let expected = (!expected.is_empty()).then(|| expected.to_owned());
            assert_eq!(written(word, Codes::TwoDigits, Numbers::Keep), expected, "{word}");
        }
    }

    proptest::proptest! {
        /// The quick look knows no word that would be written otherwise.
        #[test]
        fn tidy_words_stay(word in "[GMNXYZABCUVWIJKFSgRTDLQHP%/][-+]?[0-9]{0,4}[.]?[0-9]{0,3}[.]?") {
            for (_, codes) in Codes::NAMED {
                for (_, numbers) in Numbers::NAMED {
                    if is_tidy(&word, Style { codes, numbers, ..Style::default() }) {
                        proptest::prop_assert_eq!(written(&word, codes, numbers), Some(word.clone()));
                    }
                }
            }
        }
    }

    /// FMT-5: no zeros that say nothing.
    #[test]
    fn short_numbers() {
        for (word, expected) in [
            ("X036.120", "X36.12"),
            ("X.5", "X0.5"),
            ("X36.", "X36"),
            ("X-0.000", "X-0"),
            ("X+00.50", "X+0.5"),
            ("R01=007.0", "R01=7"),
            ("F0100.", "F100"),
            ("S0100", "S0100"),
            ("L0100", "L0100"),
            ("G01", "G1"),
            ("M00", "M0"),
        ] {
            assert_eq!(written(word, Codes::Short, Numbers::Short).as_deref(), Some(expected), "{word}");
        }
    }
}
