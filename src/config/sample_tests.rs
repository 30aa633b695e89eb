//! The project files of the samples, each finding at its mark, and files made at random.

use std::path::PathBuf;

use super::Overrides;
use super::tests::{EXAMPLE, Run};
use crate::dict::Lang;
use crate::text::MemoryLoader;

/// A marked file: the text, and under a place a comment line with carets and the code found there.
fn marks(text: &str) -> Vec<(u32, u32, u32, String)> {
    let mut marks = Vec::new();
    for (line, comment) in (1..).zip(text.lines().skip(1)) {
        let Some(start) = comment.find('^') else {
            continue;
        };
        let carets = comment[start..].find(|c| c != '^').unwrap_or(comment.len() - start);
        let code = comment[start + carets..].split_whitespace().next().unwrap_or_default();
        let column = |at: usize| u32::try_from(at + 1).unwrap();
        marks.push((line, column(start), column(start + carets), code.to_owned()));
    }
    marks
}

macro_rules! samples {
    ($($test:ident $folder:literal $($xml:literal)?;)*) => {$(
        #[test]
        fn $test() {
            let toml = include_str!(concat!("../../samples/err/", $folder, "/cnc872c.toml"));
            let loader = MemoryLoader::new().with("cnc872c.toml", toml);
            $(let loader = loader.with($xml, include_str!(concat!("../../samples/err/", $folder, "/", $xml)));)?
            let run = Run::with(Some("cnc872c.toml"), &Overrides::default(), &loader);
            for (file, source) in run.sources.iter() {
                let found: Vec<_> = run
                    .findings
                    .iter()
                    .filter(|found| found.at.file == file)
                    .map(|found| {
                        let start = source.line_column(found.at.span.start);
                        let end = source.line_column(found.at.span.end);
                        (start.line, start.column, end.column, found.code().to_string())
                    })
                    .collect();
                assert_eq!(found, marks(source.text()), "{}", source.name());
            }
        }
    )*};
}

samples! {
    sample_unreadable_configuration "E0701-unreadable-configuration";
    sample_channel_config_of_old_control "E0702-channel-config" "Channel.xml";
    sample_dialect "E0702-dialect";
    sample_m_functions "E0702-m-functions" "Channel.xml";
    sample_types "E0702-types";
    sample_values "E0702-values";
    sample_m_function_fixed "E0703-m-function-fixed" "Channel.xml";
    sample_m_function_repeated "E0704-m-function-repeated" "Channel.xml";
    sample_unknown_configuration_key "W0705-unknown-configuration-key" "Channel.xml";
    sample_machine_constant "E0706-machine-constant";
}

/// Pieces of which hostile files are made.
const PARTS: &[&str] = &[
    "<MFunctions>",
    "</MFunctions>",
    "<MFunc ",
    "/>",
    ">",
    "<",
    "No='91'",
    " GroupNo=\"10\"",
    "='",
    "&amp;",
    "&#x0;",
    "&x;",
    "<!--",
    "-->",
    "<![CDATA[",
    "]]>",
    "<!DOCTYPE a [",
    "<!ENTITY x SYSTEM 'y'>",
    "<!ENTITY",
    "]>",
    "č",
    "R1",
    "<?xml version='1.0'?>",
    "xmlns:x='u'",
    "x:",
    "\r\n",
    "\u{feff}",
    "\0",
    "[axes]\n",
    "[[axes]]\n",
    "letter = 'X'\n",
    "dialect = ",
    "'cnc8x9'\n",
    "[parameters]\n",
    "R1 = 5.5\n",
    " = ",
    "1e5",
    "_",
    ".",
    "[",
    "]",
    "{",
    "}",
    "\n",
    "\"",
    "'''",
    "[lints]\n",
    "W0214",
    "#",
];

proptest::proptest! {
    /// Any file is read without a panic, and every finding has a place in its text.
    #[test]
    fn any_text_is_read(
        parts in proptest::collection::vec(proptest::sample::select(PARTS), 0..40),
        noise in "\\PC{0,8}",
        cut in 0_usize..1000,
    ) {
        let text = format!("{noise}{}", parts.concat());
        let (xml, rest) = text.split_at(text.floor_char_boundary(cut % (text.len() + 1)));
        let (first, second) = EXAMPLE.split_at(EXAMPLE.floor_char_boundary(cut));
        for (toml, xml) in [(&format!("{first}{noise}{second}"), xml), (&text, rest)] {
            let loader = MemoryLoader::new().with("cnc872c.toml", toml.as_str()).with("Channel.xml", xml);
            let overrides = Overrides { channel_config: Some(PathBuf::from("Channel.xml")), ..Overrides::default() };
            let run = Run::with(Some("cnc872c.toml"), &overrides, &loader);
            for found in &run.findings {
                let source = run.sources.get(found.at.file).unwrap();
                assert!(source.text().get(found.at.span.range()).is_some(), "{found:?}");
                assert!(!found.finding.message(Lang::Cs).is_empty());
            }
        }
    }
}
