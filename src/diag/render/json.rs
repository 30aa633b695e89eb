//! Findings as one JSON object, for other programs.

use std::collections::BTreeMap;
use std::io::{self, Write};

use schemars::{JsonSchema, generate::SchemaSettings};
use serde::{Serialize, Serializer};

use super::edits::gathered;
use super::json_text;
use super::places::Places;
use crate::diag::{Diagnostic, Report, Reported, Severity, terminal_safe};
use crate::dict::Lang;
use crate::text::Location;

/// The name and version of the form.
const SCHEMA: &str = "cnc872c.diagnostics/1";

/// Writes the object in one line.
pub(super) fn write(report: &Report, lang: Lang, out: &mut dyn Write) -> io::Result<()> {
    let form = Form { places: Places::new(report.sources()), lang };
    json_text::write(&document(&form, report), out)
}

/// The JSON Schema (2020-12) of the object that [`Format::Json`](super::Format::Json) writes.
pub fn schema() -> serde_json::Value {
    let settings = SchemaSettings::draft2020_12().for_serialize();
    let mut schema = settings.into_generator().into_root_schema_for::<Document<'static>>().to_value();
    if let Some(root) = schema.as_object_mut() {
        root.insert("$id".to_owned(), format!("urn:{}", SCHEMA.replace('/', ":")).into());
    }
    schema
}

/// The findings of one run of cnc872c.
#[derive(Serialize, JsonSchema)]
#[schemars(title = "cnc872c diagnostics")]
struct Document<'a> {
    /// The program that found them.
    tool: Tool,
    /// The programs and macrocycles that were checked, as the user named them.
    files: &'a [String],
    /// Name and version of this form.
    #[schemars(extend("const" = SCHEMA))]
    schema: &'static str,
    /// The findings, sorted by file and place.
    #[schemars(with = "Vec<Item<'a>>")]
    diagnostics: Items<'a>,
    /// How many there are.
    summary: Summary,
}

/// The program that found something.
#[derive(Serialize, JsonSchema)]
struct Tool {
    /// Its name.
    name: &'static str,
    /// Its version.
    version: &'static str,
}

/// One finding.
#[derive(Serialize, JsonSchema)]
#[schemars(rename = "Diagnostic")]
struct Item<'a> {
    /// Its code, as in `cnc872c explain CODE`.
    #[schemars(regex(pattern = "^[EW][0-9]{4}$"))]
    code: &'static str,
    /// Its name, as in `-W NAME`.
    name: &'static str,
    /// Its severity in this run.
    severity: Level,
    /// The mistake, in one sentence.
    message: String,
    /// What to write instead.
    #[serde(skip_serializing_if = "Option::is_none")]
    #[schemars(with = "String")]
    help: Option<String>,
    /// Why it is so.
    notes: Vec<String>,
    /// The file it is in.
    file: &'a str,
    /// Where.
    span: Range,
    /// Other places that explain it.
    labels: Vec<Label<'a>>,
    /// The calls that led there, outermost first.
    calls: Vec<Call<'a>>,
    /// Changes, each of which may fix it: the certain one, then those that are offered.
    fixes: Vec<Fix<'a>>,
}

/// How serious a finding is.
#[derive(Clone, Copy, Serialize, JsonSchema)]
#[serde(rename_all = "lowercase")]
enum Level {
    Error,
    Warning,
}

/// From `start` up to, not including, `end`.
#[derive(Clone, Copy, Serialize, JsonSchema)]
#[schemars(rename = "Span")]
struct Range {
    /// The first character.
    start: Position,
    /// The first character behind it.
    end: Position,
}

/// A place in a file.
#[derive(Clone, Copy, Serialize, JsonSchema)]
struct Position {
    /// Line, from 1.
    #[schemars(range(min = 1))]
    line: u32,
    /// Column in characters, from 1.
    #[schemars(range(min = 1))]
    column: u32,
    /// Bytes of the file before it.
    offset: u64,
}

/// Another place that explains a finding.
#[derive(Serialize, JsonSchema)]
struct Label<'a> {
    /// The file it is in.
    file: &'a str,
    /// Where.
    span: Range,
    /// Its text.
    message: String,
}

/// A call on the way to a finding.
#[derive(Serialize, JsonSchema)]
struct Call<'a> {
    /// `G71`, `G72`, or the cycle function that calls a macrocycle.
    #[schemars(regex(pattern = "^G(71|72|8[1-9])$"))]
    by: &'static str,
    /// What was called.
    l: u32,
    /// The file of the calling block.
    file: &'a str,
    /// The number of the calling block.
    n: u32,
    /// The line of the calling block, from 1.
    #[schemars(range(min = 1))]
    line: u32,
}

/// A change that fixes what a finding reports.
#[derive(Serialize, JsonSchema)]
struct Fix<'a> {
    /// Its effect.
    title: String,
    /// Whether it is what was meant beyond doubt, so that `check --fix` applies it; else it is offered.
    certain: bool,
    /// Replacements that do not overlap.
    #[schemars(with = "Vec<Edit<'a, 'a>>")]
    edits: Edits<'a>,
}

/// The findings, each made while it is written: all of them at once are many times what they are about.
struct Items<'a> {
    form: &'a Form<'a>,
    report: &'a Report,
}

impl Serialize for Items<'_> {
    fn serialize<S: Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
        serializer.collect_seq(self.report.items().map(|item| self.form.item(item)))
    }
}

/// The edits of a fix, each made while it is written: there may be one for each letter of a file.
struct Edits<'a> {
    form: &'a Form<'a>,
    edits: &'a [crate::diag::Edit],
}

impl Serialize for Edits<'_> {
    fn serialize<S: Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
        serializer.collect_seq(gathered(self.edits, &self.form.places).iter().map(|edit| self.form.edit(edit)))
    }
}

/// One replacement.
#[derive(Serialize, JsonSchema)]
struct Edit<'a, 't> {
    /// The file that is changed.
    file: &'a str,
    /// The replaced range.
    span: Range,
    /// By what.
    text: &'t str,
}

/// How many programs and findings there are.
#[derive(Serialize, JsonSchema)]
struct Summary {
    /// Programs and macrocycles checked.
    files: usize,
    /// Errors found.
    errors: usize,
    /// Warnings found.
    warnings: usize,
    /// How many of the errors and warnings are counted here only.
    #[serde(skip_serializing_if = "Option::is_none")]
    #[schemars(with = "usize")]
    suppressed: Option<usize>,
    /// How many there are of each code.
    by_code: BTreeMap<&'static str, usize>,
    /// The programs that were not executed, so that what only execution finds is not known of them.
    not_executed: Vec<NotExecuted>,
}

/// A program that was not executed.
#[derive(Serialize, JsonSchema)]
struct NotExecuted {
    /// The program.
    file: String,
    /// Why.
    reason: String,
}

fn document<'a>(form: &'a Form<'a>, report: &'a Report) -> Document<'a> {
    Document {
        tool: Tool { name: env!("CARGO_PKG_NAME"), version: env!("CARGO_PKG_VERSION") },
        files: report.files(),
        schema: SCHEMA,
        diagnostics: Items { form, report },
        summary: Summary {
            files: report.programs(),
            errors: report.errors(),
            warnings: report.warnings(),
            suppressed: Some(report.suppressed()).filter(|&count| count > 0),
            by_code: report.by_code().into_iter().map(|(code, count)| (code.as_str(), count)).collect(),
            not_executed: report
                .not_executed()
                .iter()
                .map(|program| NotExecuted { file: program.file.clone(), reason: safe(program.reason(form.lang)) })
                .collect(),
        },
    }
}

struct Form<'a> {
    places: Places<'a>,
    lang: Lang,
}

impl<'a> Form<'a> {
    fn item(&'a self, Reported { severity, diagnostic }: &'a Reported) -> Item<'a> {
        let Diagnostic { finding, at, labels, calls, fixes } = diagnostic;
        Item {
            code: finding.code().as_str(),
            name: finding.code().name(),
            severity: match severity {
                Severity::Error => Level::Error,
                Severity::Warning => Level::Warning,
            },
            message: safe(finding.message(self.lang)),
            help: finding.help(self.lang).map(safe),
            notes: finding.note(self.lang).into_iter().map(safe).collect(),
            file: self.places.name(at.file),
            span: self.range(*at),
            labels: labels
                .iter()
                .map(|label| Label {
                    file: self.places.name(label.at.file),
                    span: self.range(label.at),
                    message: safe(label.text.text(self.lang)),
                })
                .collect(),
            calls: calls
                .iter()
                .map(|call| Call {
                    by: call.by.name(),
                    l: call.l,
                    file: self.places.name(call.at.file),
                    n: call.n,
                    line: self.places.start(call.at).line,
                })
                .collect(),
            fixes: [true, false]
                .into_iter()
                .flat_map(|certain| fixes.iter().filter(move |fix| fix.certain.is_some() == certain))
                .map(|fix| Fix {
                    title: safe(fix.title.text(self.lang)),
                    certain: fix.certain.is_some(),
                    edits: Edits { form: self, edits: &fix.edits },
                })
                .collect(),
        }
    }

    fn edit<'t>(&'a self, edit: &'t crate::diag::Edit) -> Edit<'a, 't> {
        Edit { file: self.places.name(edit.at.file), span: self.range(edit.at), text: &edit.text }
    }

    fn range(&self, at: Location) -> Range {
        let (start, end) = (self.places.start(at), self.places.end(at));
        let (first, last) = self.places.bytes(at);
        Range {
            start: Position { line: start.line, column: start.column, offset: first },
            end: Position { line: end.line, column: end.column, offset: last },
        }
    }
}

/// Words for people; names of files and the texts of edits stay as they are.
fn safe(words: String) -> String {
    terminal_safe(&words).into_owned()
}

#[cfg(test)]
mod tests {
    use serde_json::Value;

    use super::*;
    use crate::diag::Format;
    use crate::diag::render::samples::{self, rendered};
    use crate::json_schema::validator_for;

    fn json(report: &Report, lang: Lang) -> Value {
        serde_json::from_str(&rendered(Format::Json, report, lang, true)).unwrap()
    }

    #[test]
    fn every_member() {
        let no_version = |text: String| text.replace(env!("CARGO_PKG_VERSION"), "0.0.0");
        let text = no_version(rendered(Format::Json, &samples::plain(), Lang::En, false));
        insta::assert_snapshot!(text.replace("},{\"code\"", "},\n {\"code\""), @r#"
            {"tool":{"name":"cnc872c","version":"0.0.0"},"files":["part.nc"],"schema":"cnc872c.diagnostics/1","diagnostics":[{"code":"E0306","name":"duplicate-address","severity":"error","message":"`X` is written twice in this block","help":"keep one of them, or begin a new block with `N…`","notes":[],"file":"part.nc","span":{"start":{"line":2,"column":14,"offset":26},"end":{"line":2,"column":16,"offset":28}},"labels":[{"file":"part.nc","span":{"start":{"line":2,"column":8,"offset":20},"end":{"line":2,"column":10,"offset":22}},"message":"`X0` is the first one"}],"calls":[],"fixes":[]},
             {"code":"E0104","name":"decimal-comma","severity":"error","message":"a decimal comma","help":"the control knows the decimal point only: write `X36.12`","notes":[],"file":"part.nc","span":{"start":{"line":3,"column":9,"offset":38},"end":{"line":3,"column":14,"offset":43}},"labels":[],"calls":[],"fixes":[{"title":"write `X36.12`","certain":true,"edits":[{"file":"part.nc","span":{"start":{"line":3,"column":9,"offset":38},"end":{"line":3,"column":14,"offset":43}},"text":"36.12"}]}]},
             {"code":"W0214","name":"empty-block","severity":"warning","message":"block N30 is empty","help":"delete it, or say in a comment what it is for","notes":[],"file":"part.nc","span":{"start":{"line":4,"column":1,"offset":50},"end":{"line":4,"column":4,"offset":53}},"labels":[],"calls":[],"fixes":[]}],"summary":{"files":1,"errors":2,"warnings":1,"by_code":{"E0104":1,"E0306":1,"W0214":1},"not_executed":[]}}
            "#);
        let text = no_version(rendered(Format::Json, &samples::called(), Lang::Cs, false));
        insta::assert_snapshot!(text, @r#"{"tool":{"name":"cnc872c","version":"0.0.0"},"files":["díly/a b.nc"],"schema":"cnc872c.diagnostics/1","diagnostics":[{"code":"E0510","name":"unusable-parameter-value","severity":"error","message":"R1 má hodnotu 2.5, ale D musí být celé číslo","notes":[],"file":"cykly/\u001b[31mL9081","span":{"start":{"line":2,"column":7,"offset":19},"end":{"line":2,"column":10,"offset":22}},"labels":[{"file":"díly/a b.nc","span":{"start":{"line":2,"column":8,"offset":22},"end":{"line":2,"column":11,"offset":25}},"message":"zde dostal R1 hodnotu 2.5"}],"calls":[{"by":"G71","l":100,"file":"díly/a b.nc","n":80,"line":3},{"by":"G81","l":9081,"file":"díly/a b.nc","n":110,"line":6}],"fixes":[{"title":"napsat „D2“","certain":true,"edits":[{"file":"cykly/\u001b[31mL9081","span":{"start":{"line":2,"column":7,"offset":19},"end":{"line":2,"column":10,"offset":22}},"text":"D2"}]}]}],"summary":{"files":1,"errors":1,"warnings":0,"by_code":{"E0510":1},"not_executed":[]}}"#);
    }

    /// diagnostics.md: offsets are bytes of the file, columns characters.
    #[test]
    fn offsets_are_bytes_of_the_file() {
        let document = json(&samples::mixed(), Lang::En);
        let span = &document["diagnostics"][0]["span"];
        assert_eq!(span["start"], serde_json::json!({"line": 2, "column": 13, "offset": 26}));
        assert!(document["diagnostics"][0].get("help").is_some());
        let unreadable = &document["diagnostics"][2];
        assert_eq!((&unreadable["code"], unreadable.get("help")), (&Value::from("E0112"), None));
        assert_eq!(unreadable["span"]["end"], serde_json::json!({"line": 1, "column": 1, "offset": 0}));
    }

    #[test]
    fn names_are_exact_and_yet_not_raw() {
        let report = samples::hostile();
        assert!(!samples::is_raw(&rendered(Format::Json, &report, Lang::En, true)));
        assert_eq!(json(&report, Lang::En)["diagnostics"][0]["file"], "a\u{202e}\n\u{1b}]0;x\u{7}b.nc");
    }

    #[test]
    fn what_is_left_out_is_counted() {
        assert_eq!(json(&samples::plain(), Lang::En)["summary"].get("suppressed"), None);
        let summary = &json(&samples::many(10_002), Lang::En)["summary"];
        assert_eq!(
            *summary,
            serde_json::json!({"files": 1, "errors": 0, "warnings": 10_002, "suppressed": 2,
            "by_code": {"W0605": 10_002}, "not_executed": []})
        );
    }

    #[test]
    fn all_documents_are_after_the_schema() {
        let schema = schema();
        assert_eq!(schema["$schema"], "https://json-schema.org/draft/2020-12/schema");
        let validator = validator_for(&schema);
        for report in [samples::plain(), samples::called(), samples::mixed(), samples::hostile(), Report::new()] {
            assert_eq!(validator.validate(&json(&report, Lang::Cs)), Ok(()));
        }
        let mut wrong = json(&samples::plain(), Lang::En);
        wrong["diagnostics"][0]["span"]["start"]["line"] = 0.into();
        assert!(!validator.is_valid(&wrong));
    }
}
