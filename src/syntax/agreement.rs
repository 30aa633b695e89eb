//! Reading a text in pieces and by the short way gives what lexer and grammar give of the whole text: this is what
//! tests and fuzzing ask.

use std::sync::Arc;

use super::Form;
use super::parse::parse_in;
use crate::diag::Findings;
use crate::text::{FileId, SourceText};

/// The tree and the findings of a text, read in so many pieces, with or without the short way; to be compared.
fn show(pieces: u32, short_way: bool, text: &str, form: Form) -> (String, Vec<String>) {
    let source = Arc::new(SourceText::from_text("t.nc", text));
    let mut findings = Findings::new();
    let parsed = parse_in(pieces, short_way, FileId(0), &source, form, &mut findings);
    let found = findings.into_sorted().iter().map(|found| format!("{found:?}")).collect();
    (format!("{parsed:?}"), found)
}

/// Whether a text gives the same in one piece by lexer and grammar alone, and in several with the short way.
#[cfg(fuzzing)]
pub fn short_way_agrees(text: &str, form: Form) -> bool {
    let whole = show(1, false, text, form);
    (1..=3).all(|pieces| show(pieces, true, text, form) == whole)
}

#[cfg(test)]
mod tests {
    use proptest::prelude::*;

    use super::*;

    /// Reading side by side gives what reading in one piece gives.
    #[test]
    fn pieces_are_equal_to_the_whole() {
        let block = |n: u32| {
            let (second, third) = (n + 1, n + 2);
            format!("N{n} X{n}.5 Y,5 \"c\"\nZ{n} R1=2\r\nN{second} G1 %3 F5 #\rNAME X\nN\nN{third} x1\nN{n}X1Y2\n")
        };
        let body: String = (0..40).map(|n| block(10 * n + 1)).collect();
        for end in ["", "*\nN5 M30", "* \"c\"\n"] {
            for form in [Form::Program, Form::Macrocycle] {
                let text = format!("%1 \"title\"\n{body}{end}\n{body}");
                let whole = show(1, false, &text, form);
                for pieces in [1, 2, 3, 7, 100] {
                    for short_way in [false, true] {
                        let read = show(pieces, short_way, &text, form);
                        assert_eq!(read, whole, "{pieces} pieces, {form:?}, {end:?}, {short_way}");
                    }
                }
            }
        }
    }

    /// A part of a text depends on the text before it.
    #[test]
    fn pieces_see_what_is_before_them() {
        for text in [
            "%1\nG2 7\nN1R",
            "%1\nG2\nN1R\nG1\nN2 R",
            "%1\n\"a\nG2\nb\" N1\nN2 R\n",
            "%1\nN1 G2\nN2 X1IO5\nN3R5",
            "%1\nN1 X5 X5 X5 X5\nNB\rN2",
        ] {
            let whole = show(1, false, text, Form::Program);
            for pieces in 1..6 {
                assert_eq!(show(pieces, true, text, Form::Program), whole, "{pieces} pieces of {text:?}");
            }
        }
    }

    /// What lines are put together from: what is plain, and what is nearly so.
    const ATOMS: [&str; 69] = [
        "N10",
        "N20",
        "N30",
        "N",
        "N.5",
        "N-5",
        "n5",
        "G1",
        "G01",
        "G2",
        "G3",
        "G2 7",
        "R",
        "I",
        "G79",
        "M30",
        "M02",
        "G70",
        "X1.5",
        "Y-2",
        "Z+.25",
        "X.",
        "X-",
        "X",
        "X1.2345",
        "X1.0000",
        "X99999999999999999999",
        "Y1.2.3",
        "X1,5",
        "X1O0",
        "XO",
        "O5",
        "E5",
        "L100",
        "Q2",
        "R1",
        "R1=2",
        "R2=-R3",
        "XR1",
        "X5 5",
        "X5\n5",
        "%1",
        "&5",
        "*",
        "/",
        "/1",
        "\"c\"",
        "\"",
        "(c)",
        ";ab",
        "KONTURA",
        "NAME",
        "XYZ5",
        "#",
        "ř",
        "X#1",
        "X[5]",
        "=",
        "-",
        "5",
        " ",
        "\t",
        "\n",
        "\r\n",
        "\r",
        "\n\n",
        "\nN40 X1\n",
        "\nN50 Y2.5 ",
        "\u{1a}",
    ];

    proptest! {
        /// The short way through plain blocks reads what lexer and grammar read.
        #[test]
        fn the_short_way_reads_the_same(
            picks in proptest::collection::vec((0_usize..ATOMS.len(), any::<bool>()), 0..40),
            macrocycle in any::<bool>(),
            pieces in 1_u32..4,
        ) {
            let mut text = String::from("%1\nN1 X1\n");
            for (atom, blank) in picks {
                text.push_str(ATOMS[atom]);
                text.push_str(if blank { " " } else { "" });
            }
            let form = if macrocycle { Form::Macrocycle } else { Form::Program };
            prop_assert_eq!(show(pieces, true, &text, form), show(1, false, &text, form), "{:?}", text);
        }

        /// The same of any characters.
        #[test]
        fn the_short_way_reads_the_same_of_anything(text in "(N[0-9]{1,2}|[A-Z][0-9]|[ -~\r\n\t]|\n){0,40}") {
            let text = format!("%1\n{text}");
            prop_assert_eq!(show(2, true, &text, Form::Program), show(1, false, &text, Form::Program), "{:?}", text);
        }
    }
}
