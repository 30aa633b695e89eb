//! Findings as SARIF 2.1.0, which code scanning services and editors read.

use std::io::{self, Write};

use serde::ser::SerializeMap;
use serde::{Serialize, Serializer};
use serde_json::{Map, Value, json};

use super::edits::gathered;
use super::json_text;
use super::places::Places;
use super::words::{self, Words};
use crate::diag::{Code, Diagnostic, Edit, Report, Reported, explain, terminal_safe};
use crate::dict::Lang;
use crate::text::{Encoding, FileId, Location};

/// Where the schema of SARIF is.
const SCHEMA: &str = "https://docs.oasis-open.org/sarif/sarif/v2.1.0/errata01/os/schemas/sarif-schema-2.1.0.json";

/// The name of the program as an address that never changes; pages about it come with it (`cnc872c explain`).
const INFORMATION: &str = concat!("urn:", env!("CARGO_PKG_NAME"), ":", env!("CARGO_PKG_VERSION"));

/// Writes one log with one run.
pub(super) fn write(report: &Report, lang: Lang, out: &mut dyn Write) -> io::Result<()> {
    let mut codes: Vec<Code> = report.items().map(|item| item.diagnostic.code()).collect();
    codes.sort_unstable();
    codes.dedup();
    let log = Log { places: Places::new(report.sources()), lang, codes };
    json_text::write(&Sarif { schema: SCHEMA, version: "2.1.0", runs: [Run { log: &log, report }] }, out)
}

#[derive(Serialize)]
struct Sarif<'a> {
    #[serde(rename = "$schema")]
    schema: &'static str,
    version: &'static str,
    runs: [Run<'a>; 1],
}

/// The one run of a log. Its results, and the edits of their fixes, are made while they are written: all of them at
/// once are many times what they are about.
struct Run<'a> {
    log: &'a Log<'a>,
    report: &'a Report,
}

impl Serialize for Run<'_> {
    fn serialize<S: Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
        let Self { log, report } = self;
        let mut run = serializer.serialize_map(None)?;
        let driver = json!({
            "name": env!("CARGO_PKG_NAME"),
            "version": env!("CARGO_PKG_VERSION"),
            "semanticVersion": env!("CARGO_PKG_VERSION"),
            "informationUri": INFORMATION,
            "language": language(log.lang),
            "rules": log.codes.iter().map(|&code| log.rule(code)).collect::<Vec<_>>(),
        });
        run.serialize_entry("tool", &json!({"driver": driver}))?;
        run.serialize_entry("invocations", &json!([{"executionSuccessful": !report.is_unusable()}]))?;
        run.serialize_entry("language", language(log.lang))?;
        run.serialize_entry("columnKind", "unicodeCodePoints")?;
        run.serialize_entry("newlineSequences", &["\r\n", "\n", "\r"])?;
        run.serialize_entry("artifacts", &log.artifacts(report))?;
        run.serialize_entry("results", &Results { log, report })?;
        if report.suppressed() > 0 {
            run.serialize_entry("properties", &json!({"suppressed": report.suppressed()}))?;
        }
        run.end()
    }
}

struct Results<'a> {
    log: &'a Log<'a>,
    report: &'a Report,
}

impl Serialize for Results<'_> {
    fn serialize<S: Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
        serializer.collect_seq(self.report.items().map(|item| self.log.result(item)))
    }
}

/// One finding with its fixes.
#[derive(Serialize)]
struct Outcome<'a> {
    #[serde(flatten)]
    said: Value,
    #[serde(skip_serializing_if = "Vec::is_empty")]
    fixes: Vec<Fix<'a>>,
}

#[derive(Serialize)]
#[serde(rename_all = "camelCase")]
struct Fix<'a> {
    description: Value,
    artifact_changes: Vec<Change<'a>>,
}

/// The edits of a fix in one file.
#[derive(Serialize)]
#[serde(rename_all = "camelCase")]
struct Change<'a> {
    artifact_location: Value,
    replacements: Replacements<'a>,
}

struct Replacements<'a> {
    log: &'a Log<'a>,
    edits: &'a [Edit],
}

impl Serialize for Replacements<'_> {
    fn serialize<S: Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
        serializer.collect_seq(
            gathered(self.edits, &self.log.places)
                .iter()
                .map(|edit| json!({"deletedRegion": self.log.region(edit.at), "insertedContent": {"text": edit.text}})),
        )
    }
}

/// Data that the results share.
struct Log<'a> {
    places: Places<'a>,
    lang: Lang,
    /// The codes found, sorted: the rules.
    codes: Vec<Code>,
}

impl Log<'_> {
    fn rule(&self, code: Code) -> Value {
        json!({
            "id": code.as_str(),
            "name": code.name(),
            "shortDescription": message(&explain::first_sentence(code, self.lang)),
            "help": {
                "text": escaped(&explain::page(code, self.lang, false)),
                "markdown": escaped(&explain::markdown(code, self.lang)),
            },
            "defaultConfiguration": {"level": code.severity().name()},
        })
    }

    fn artifacts(&self, report: &Report) -> Vec<Value> {
        let artifact = |(id, source): (FileId, &std::sync::Arc<crate::text::SourceText>)| {
            let mut artifact = json!({"location": self.artifact_location(id)});
            if let Some(name) = registered_name(source.encoding()) {
                set(&mut artifact, "encoding", name.into());
            }
            artifact
        };
        report.sources().iter().map(artifact).collect()
    }

    fn result<'a>(&'a self, Reported { severity, diagnostic }: &'a Reported) -> Outcome<'a> {
        let Diagnostic { finding, at, labels, calls, fixes } = diagnostic;
        let code = finding.code();
        let mut text = terminal_safe(&finding.message(self.lang)).into_owned();
        if let Some(help) = finding.help(self.lang) {
            text.push('\n');
            text.push_str(&terminal_safe(&help));
        }
        let mut said = json!({
            "ruleId": code.as_str(),
            "ruleIndex": self.codes.binary_search(&code).unwrap_or_default(),
            "level": severity.name(),
            "message": message(&text),
            "locations": [{"physicalLocation": self.physical(*at)}],
        });
        if !labels.is_empty() {
            let labels = labels.iter().zip(1..).map(|(label, id)| {
                json!({
                    "id": id,
                    "physicalLocation": self.physical(label.at),
                    "message": message(&terminal_safe(&label.text.text(self.lang))),
                })
            });
            set(&mut said, "relatedLocations", labels.collect());
        }
        if !calls.is_empty() {
            // The nearest call first.
            let frames = calls.iter().rev().map(|call| {
                let line = Words::Line { line: self.places.start(call.at).line }.text(self.lang);
                json!({"location": {
                    "physicalLocation": self.physical(call.at),
                    "message": message(&words::called_by(call, &line, self.lang)),
                }})
            });
            set(&mut said, "stacks", json!([{"frames": frames.collect::<Vec<_>>()}]));
        }
        let fixes = fixes.iter().filter(|fix| fix.certain.is_some()).map(|fix| Fix {
            description: message(&terminal_safe(&fix.title.text(self.lang))),
            artifact_changes: fix
                .edits
                .chunk_by(|one, next| one.at.file == next.at.file)
                .filter_map(|edits| {
                    Some(Change {
                        artifact_location: self.artifact_location(edits.first()?.at.file),
                        replacements: Replacements { log: self, edits },
                    })
                })
                .collect(),
        });
        Outcome { said, fixes: fixes.collect() }
    }

    fn physical(&self, at: Location) -> Value {
        json!({"artifactLocation": self.artifact_location(at.file), "region": self.region(at)})
    }

    fn artifact_location(&self, file: FileId) -> Value {
        let mut location = json!({"uri": uri(self.places.name(file), std::path::MAIN_SEPARATOR)});
        if self.places.source(file).is_some() {
            set(&mut location, "index", file.0.into());
        }
        location
    }

    fn region(&self, at: Location) -> Value {
        let (start, end) = (self.places.start(at), self.places.end(at));
        let (first, last) = self.places.bytes(at);
        json!({
            "startLine": start.line,
            "startColumn": start.column,
            "endLine": end.line,
            "endColumn": end.column,
            "byteOffset": first,
            "byteLength": last - first,
        })
    }
}

/// Sets a member of an object.
fn set(object: &mut Value, member: &str, value: Value) {
    object.as_object_mut().unwrap_or(&mut Map::new()).insert(member.to_owned(), value);
}

fn message(text: &str) -> Value {
    json!({"text": escaped(text)})
}

/// Text of a message string: braces mean placeholders in SARIF, and are doubled where they do not.
fn escaped(text: &str) -> String {
    text.replace('{', "{{").replace('}', "}}")
}

const fn language(lang: Lang) -> &'static str {
    lang.code()
}

/// The encoding's name in the IANA registry.
const fn registered_name(encoding: Encoding) -> Option<&'static str> {
    match encoding {
        Encoding::Utf8 => Some("UTF-8"),
        Encoding::Cp852 => Some("IBM852"),
        Encoding::Windows1250 => Some("windows-1250"),
        Encoding::Iso88592 => Some("ISO-8859-2"),
        Encoding::Utf16Le | Encoding::Utf16Be => Some("UTF-16"),
        Encoding::Kamenicky => None,
    }
}

/// The file of that name as a URI reference: relative as the user gave it, or absolute with `file:`.
fn uri(name: &str, separator: char) -> String {
    let mut path = String::with_capacity(name.len());
    for byte in name.bytes() {
        match byte {
            b'A'..=b'Z' | b'a'..=b'z' | b'0'..=b'9' | b'-' | b'.' | b'_' | b'~' | b'/' => path.push(char::from(byte)),
            _ if char::from(byte) == separator => path.push('/'),
            _ => path.push_str(&format!("%{byte:02X}")),
        }
    }
    let drive = separator == '\\' && path.get(1..).is_some_and(|rest| rest.starts_with("%3A/"));
    if drive {
        format!("file:///{}", path.replacen("%3A", ":", 1))
    } else if path.starts_with("//") {
        format!("file:{path}")
    } else if path.starts_with('/') {
        format!("file://{path}")
    } else {
        path
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::diag::Format;
    use crate::diag::render::samples::{self, rendered};
    use crate::json_schema::validator_for;

    fn sarif(report: &Report, lang: Lang) -> Value {
        serde_json::from_str(&rendered(Format::Sarif, report, lang, true)).unwrap()
    }

    /// The schema of the OASIS committee, see `tests/data/README.md`; one of its patterns has a bracket too many.
    #[test]
    fn all_logs_are_after_the_schema() {
        let (wrong, meant) = ("^[a-zA-Z]{2}|^[a-zA-Z]{2}-[a-zA-Z]{2}]?$", "^[a-zA-Z]{2}(-[a-zA-Z]{2})?$");
        let schema = include_str!("../../../tests/data/sarif-2.1.0.json").replace(wrong, meant);
        let schema: Value = serde_json::from_str(&schema).unwrap();
        let validator = validator_for(&schema);
        let reports = [samples::plain(), samples::called(), samples::mixed(), samples::hostile(), Report::new()];
        for (report, lang) in reports.iter().flat_map(|report| [(report, Lang::En), (report, Lang::Cs)]) {
            let log = sarif(report, lang);
            assert_eq!(validator.validate(&log), Ok(()));
        }
        let mut wrong = sarif(&samples::plain(), Lang::En);
        wrong["runs"][0]["results"][0]["level"] = "fatal".into();
        assert!(!validator.is_valid(&wrong), "the schema tells right from wrong");
    }

    #[test]
    fn a_result() {
        let log = sarif(&samples::called(), Lang::En);
        let run = &log["runs"][0];
        assert_eq!(run["columnKind"], "unicodeCodePoints");
        let result = &run["results"][0];
        let file = json!({"index": 1, "uri": "cykly/%1B%5B31mL9081"});
        let region =
            json!({"startLine": 2, "startColumn": 7, "endLine": 2, "endColumn": 10, "byteOffset": 19, "byteLength": 3});
        assert_eq!(result["locations"], json!([{"physicalLocation": {"artifactLocation": file, "region": region}}]));
        assert_eq!(
            result["fixes"],
            json!([{"description": {"text": "write `D2`"}, "artifactChanges": [{
                "artifactLocation": file,
                "replacements": [{"deletedRegion": region, "insertedContent": {"text": "D2"}}],
            }]}])
        );
        assert_eq!(result["relatedLocations"][0]["message"]["text"], "R1 got the value 2.5 here");
        let frames = result["stacks"][0]["frames"].as_array().unwrap();
        let calls: Vec<&Value> = frames.iter().map(|frame| &frame["location"]["message"]["text"]).collect();
        assert_eq!(calls, ["called by N110 G81 as L9081 (line 6)", "called by N80 G71 L100 (line 3)"]);
        assert_eq!(run["artifacts"][1]["location"]["uri"], "cykly/%1B%5B31mL9081");
        let rule = &run["tool"]["driver"]["rules"][0];
        assert_eq!((&rule["id"], &rule["name"]), (&"E0510".into(), &"unusable-parameter-value".into()));
        assert!(rule["help"]["text"].as_str().unwrap().starts_with("E0510: unusable-parameter-value\n"));
    }

    /// Each result names its rule by its place in the list of rules, and offsets are bytes of the file.
    #[test]
    fn rules_and_offsets() {
        let log = sarif(&samples::mixed(), Lang::Cs);
        let run = &log["runs"][0];
        for result in run["results"].as_array().unwrap() {
            let index = usize::try_from(result["ruleIndex"].as_u64().unwrap()).unwrap();
            assert_eq!(run["tool"]["driver"]["rules"][index]["id"], result["ruleId"]);
        }
        let region = &run["results"][0]["locations"][0]["physicalLocation"]["region"];
        assert_eq!(
            (&region["startColumn"], &region["byteOffset"], &region["byteLength"]),
            (&13.into(), &26.into(), &3.into())
        );
        assert_eq!(run["artifacts"][0]["encoding"], "IBM852");
    }

    #[test]
    fn a_run_that_could_not_do_what_it_should() {
        let mut report = samples::mixed();
        let successful =
            |report: &Report| sarif(report, Lang::En)["runs"][0]["invocations"][0]["executionSuccessful"].clone();
        assert_eq!(successful(&report), true);
        report.set_unusable();
        assert_eq!(successful(&report), false);
    }

    /// A fix with many edits names each file once.
    #[test]
    fn edits_of_one_file_are_one_change() {
        let sources = samples::sources(&[("a.nc", b"%1 n1 x5"), ("b.nc", b"n2")]);
        let place = |file, what| samples::find(&sources, file, what, 0);
        let edits = [(0, "n"), (0, "x"), (1, "n")]
            .map(|(file, what)| Edit { at: place(file, what), text: what.to_uppercase() });
        let mut diagnostic = Diagnostic::new(crate::diag::Finding::MissingProgramStart { number: 1 }, place(0, "n"));
        diagnostic =
            diagnostic.with_fix(crate::diag::Certain::LowerCase, crate::diag::FixTitle::UpperCase, place(0, "n"), "N");
        diagnostic.fixes[0].edits = edits.to_vec();
        let log = sarif(&samples::report(&sources, [diagnostic]), Lang::En);
        let changes = log["runs"][0]["results"][0]["fixes"][0]["artifactChanges"].as_array().unwrap();
        let counts: Vec<usize> =
            changes.iter().map(|change| change["replacements"].as_array().unwrap().len()).collect();
        assert_eq!(counts, [2, 1]);
    }

    #[test]
    fn messages_hold_no_placeholders() {
        let report = samples::hostile();
        assert!(!samples::is_raw(&rendered(Format::Sarif, &report, Lang::En, true)));
        let text = &sarif(&report, Lang::En)["runs"][0]["results"][0]["message"]["text"];
        assert!(text.as_str().unwrap().starts_with("`\\u{{7}}\\u{{1b}}[31m` is text outside a comment\n"), "{text}");
    }

    #[test]
    fn what_is_left_out_is_counted() {
        assert_eq!(sarif(&samples::plain(), Lang::En)["runs"][0].get("properties"), None);
        assert_eq!(sarif(&samples::many(10_003), Lang::En)["runs"][0]["properties"]["suppressed"], 3);
    }

    #[test]
    fn names_as_uris() {
        assert_eq!(uri("díly/a b:1%.nc", '/'), "d%C3%ADly/a%20b%3A1%25.nc");
        assert_eq!(uri("a\\b.nc", '/'), "a%5Cb.nc");
        assert_eq!(uri("a\\b.nc", '\\'), "a/b.nc");
        assert_eq!(uri("/nc/1.nc", '/'), "file:///nc/1.nc");
        assert_eq!(uri("C:\\nc\\1.nc", '\\'), "file:///C:/nc/1.nc");
        assert_eq!(uri("\\\\host\\nc\\1.nc", '\\'), "file://host/nc/1.nc");
    }
}
