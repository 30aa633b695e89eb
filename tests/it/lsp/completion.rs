//! The completions at each kind of place, and the text after accepting one.

use std::fs;

use serde_json::{Value, json};
use tempfile::TempDir;

use super::Client;

/// A server in a fresh folder, with one document after the other.
struct Editor {
    folder: TempDir,
    client: Client,
    documents: usize,
}

impl Editor {
    fn new(locale: &str, project: &str, snippets: bool) -> Self {
        let folder = tempfile::tempdir().unwrap();
        fs::write(folder.path().join("cnc872c.toml"), project).unwrap();
        let item = json!({ "completionItem": { "snippetSupport": snippets } });
        let capabilities = json!({ "textDocument": { "completion": item } });
        let (client, _) = Client::initialized(json!({ "locale": locale, "capabilities": capabilities }));
        Self { folder, client, documents: 0 }
    }

    fn english() -> Self {
        Self::new("en", "", false)
    }

    fn file(&self, name: &str, text: &str) {
        let path = self.folder.path().join(name);
        fs::create_dir_all(path.parent().unwrap()).unwrap();
        fs::write(path, text).unwrap();
    }

    /// Opens a text, `|` taken out; its URI and the place of `|`.
    fn open(&mut self, name: &str, text: &str) -> (String, Value) {
        self.documents += 1;
        let name = if name.is_empty() { format!("p{}.nc", self.documents) } else { name.to_owned() };
        let uri = format!("file://{}/{name}", fs::canonicalize(self.folder.path()).unwrap().display());
        let before = text.split('|').next().unwrap();
        let line = before.matches('\n').count();
        let character = before.rsplit('\n').next().unwrap().encode_utf16().count();
        let text = text.replacen('|', "", 1);
        let document = json!({ "uri": uri, "languageId": "cnc872", "version": 1, "text": text });
        self.client.notify("textDocument/didOpen", json!({ "textDocument": document }));
        (uri, json!({ "line": line, "character": character }))
    }

    /// The answer at `|`.
    fn complete_in(&mut self, name: &str, text: &str) -> Value {
        let (uri, position) = self.open(name, text);
        let params = json!({ "textDocument": { "uri": uri }, "position": position });
        let answer = self.client.request("textDocument/completion", params);
        assert!(answer.get("error").is_none(), "{text}: {answer}");
        answer["result"].clone()
    }

    fn complete(&mut self, text: &str) -> Value {
        self.complete_in("", text)
    }

    /// The labels at `|`, in their order.
    fn labels(&mut self, text: &str) -> Vec<String> {
        labels(&self.complete(text))
    }

    /// The text after the item of that label is taken at `|`.
    fn taken(&mut self, text: &str, label: &str) -> String {
        let answer = self.complete(text);
        taken(text, item(&answer, label))
    }

    /// The findings of a text.
    fn findings(&mut self, name: &str, text: &str) -> Vec<String> {
        let (uri, _) = self.open(name, text);
        let found = self.client.findings(&uri, Some(1));
        found.as_array().unwrap().iter().map(|found| found["message"].as_str().unwrap().to_owned()).collect()
    }

    /// The text after a line end was typed at `|`, with the server's edits.
    fn entered(&mut self, text: &str) -> String {
        let (uri, position) = self.open("", text);
        let params = json!({
            "textDocument": { "uri": uri }, "position": position, "ch": "\n",
            "options": { "tabSize": 4, "insertSpaces": true },
        });
        let answer = self.client.request("textDocument/onTypeFormatting", params)["result"].clone();
        let mut text = text.replacen('|', "", 1);
        for edit in answer.as_array().into_iter().flatten().rev() {
            let offset = |at: &Value| {
                let line = usize::try_from(at["line"].as_u64().unwrap()).unwrap();
                let before: usize = text.split_inclusive('\n').take(line).map(str::len).sum();
                before + usize::try_from(at["character"].as_u64().unwrap()).unwrap()
            };
            let range = offset(&edit["range"]["start"])..offset(&edit["range"]["end"]);
            text.replace_range(range, edit["newText"].as_str().unwrap());
        }
        text
    }
}

fn items(answer: &Value) -> &[Value] {
    answer["items"].as_array().map_or(&[], Vec::as_slice)
}

fn labels(answer: &Value) -> Vec<String> {
    items(answer).iter().map(|item| item["label"].as_str().unwrap().to_owned()).collect()
}

fn item<'a>(answer: &'a Value, label: &str) -> &'a Value {
    let found = items(answer).iter().find(|item| item["label"] == label);
    found.unwrap_or_else(|| panic!("no {label}: {:?}", labels(answer)))
}

/// `text` with `|` after an item is taken. What is typed must begin what the client compares it with.
fn taken(text: &str, item: &Value) -> String {
    let edit = &item["textEdit"];
    let before = text.split('|').next().unwrap();
    let line = before.rfind('\n').map_or(0, |at| at + 1);
    let text = text.replacen('|', "", 1);
    let offset = |at: &Value| {
        let column = usize::try_from(at["character"].as_u64().unwrap()).unwrap();
        let units: Vec<u16> = text[line..].encode_utf16().take(column).collect();
        line + String::from_utf16(&units).unwrap().len()
    };
    let (start, end) = (offset(&edit["range"]["start"]), offset(&edit["range"]["end"]));
    let typed = &text[start..before.len()];
    let filter = item["filterText"].as_str().unwrap();
    assert!(filter.starts_with(typed), "{filter} is not found by {typed}");
    assert!(end >= before.len());
    format!("{}{}{}", &text[..start], edit["newText"].as_str().unwrap(), &text[end..])
}

fn block(text: &str) -> String {
    format!("%1\nN10 G00 X0\nN20 {text}\nN30 M30\n")
}

#[test]
fn g_functions() {
    let mut editor = Editor::english();
    let answer = editor.complete(&block("G|"));
    assert_eq!(answer["isIncomplete"], true, "what is typed next decides about the leading zero");
    assert_eq!(labels(&answer)[..3], ["G00", "G01", "G02"]);
    let g04 = item(&answer, "G04");
    assert_eq!(g04["detail"], "dwell, Q in units of 10 ms");
    let documentation = g04["documentation"]["value"].as_str().unwrap();
    assert!(documentation.contains("Group G10") && documentation.contains("`Q50`"), "{documentation}");
    assert!(item(&answer, "G90")["documentation"]["value"].as_str().unwrap().contains("after power-up"));

    assert_eq!(editor.labels(&block("G1|")), ["G01", "G10", "G14", "G15", "G16", "G17", "G18", "G19"]);
    assert_eq!(editor.labels(&block("g0|")), ["G00", "G01", "G02", "G03", "G04", "G05", "G06", "G07", "G08", "G09"]);
    assert_eq!(editor.taken(&block("G0|"), "G01"), block("G01"));
    assert_eq!(editor.taken(&block("g1| X5"), "G01"), block("G01 X5"));
    assert_eq!(editor.taken(&block("\"řř😀\" G 9|"), "G90"), block("\"řř😀\" G90"));
    assert_eq!(editor.taken(&block("X5G|0"), "G01"), block("X5G01"));
    for text in ["\"G|", "\"G|\"", "X1|", "F|1.5"] {
        let found = editor.labels(&block(text));
        assert!(found.is_empty() || found == ["F"], "{text}: {found:?}");
    }
    assert_eq!(editor.labels("%1\nN10 M30\n*\nG|"), Vec::<String>::new());
    assert_eq!(editor.labels("G|\n%1\nN10 M30\n"), Vec::<String>::new());
}

/// Words that do not fit into the block come last and give the reason.
#[test]
fn clashes() {
    let mut editor = Editor::english();
    let answer = editor.complete(&block("G90 G01 G| X1"));
    let found = labels(&answer);
    let clashing = ["G00", "G01", "G02", "G03", "G30", "G33", "G90", "G91"];
    assert_eq!(found[found.len() - clashing.len()..], clashing);
    assert_eq!(item(&answer, "G02")["detail"], "circular interpolation, clockwise – clashes with G01 in this block");
    let answer = editor.complete(&block("M03 M0|"));
    assert_eq!(labels(&answer), ["M00", "M01", "M02", "M06", "M07", "M08", "M09", "M03", "M04", "M05"]);
}

#[test]
fn m_functions_of_the_machine() {
    let mut editor = Editor::new("cs", "dialect = \"cnc8x9\"\n[machine-constants]\nR56 = \"00009192\"\n", false);
    let answer = editor.complete(&block("M9|"));
    assert_eq!(labels(&answer), ["M09", "M91", "M92"]);
    assert_eq!(item(&answer, "M91")["detail"], "funkce stroje, skupina 10");
    assert_eq!(editor.taken(&block("m9|"), "M91"), block("M91"));
    let answer = editor.complete(&block("M08|"));
    assert_eq!(item(&answer, "M08")["detail"], "zapnutí chlazení 1");
}

#[test]
fn calls_and_jumps() {
    let mut editor = Editor::new("en", "macrocycles = [\"cycles\"]\n", false);
    editor.file("cycles/L9001.NC", "N10 G79 L9001 \"pocket\"\nN20 G70\n");
    editor.file("cycles/l9002", "\"a grid of holes\"\nN10 G79 L9002\nN20 G70\n");
    editor.file("cycles/readme.txt", "");
    let program = |block: &str| {
        format!(
            "%1\nN10 G00 X0 \"start\"\nN20 X1 Y2\nN30 {block}\nN40 G71 L100\nN50 M30\n\
             N100 G79 L100 \"hole\"\nN110 G01 F1\nN120 G70\nN200 G79 L200\nN210 G70\n"
        )
    };
    let answer = editor.complete(&program("G71 L|"));
    assert_eq!(labels(&answer), ["L100", "L200"]);
    assert_eq!(item(&answer, "L100")["detail"], "hole, called 1×");
    assert_eq!(item(&answer, "L200")["detail"], "not called");
    assert_eq!(editor.taken(&program("G71 l1|"), "L100"), program("G71 L100"));
    assert_eq!(editor.labels(&program("G71 L2|")), ["L200"]);
    assert_eq!(editor.labels(&program("G71 |"))[..2], ["L100", "L200"]);

    let answer = editor.complete(&program("G72 L|"));
    assert_eq!(labels(&answer), ["L9001", "L9002"]);
    assert_eq!(item(&answer, "L9001")["detail"], "pocket, L9001.NC");
    assert_eq!(item(&answer, "L9002")["detail"], "a grid of holes, l9002");

    let answer = editor.complete(&program("G73 L| Q3"));
    assert_eq!(labels(&answer), ["L20", "L10", "L40", "L50"], "the nearest first, those before the jump first");
    assert_eq!(item(&answer, "L10")["detail"], "start");
    assert_eq!(item(&answer, "L20")["detail"], "X1 Y2");
    assert_eq!(editor.taken(&program("G73 L1|"), "L10"), program("G73 L10"));
    assert_eq!(editor.labels(&program("L|")), ["L"], "without a function only what L is");

    let end = "%1\nN10 G71 L7\nN20 M30\nN30 G79 L|\nN40 G70\n";
    assert_eq!(editor.labels(end), ["L7", "L1"], "what is called, then a free number");
    let more = "%1\nN10 G71 L100\nN20 M30\nN30 G79 L100\nN40 G70\nN50 G79 L|";
    assert_eq!(editor.labels(more), ["L200"]);
    let answer = editor.complete_in("cycles/L77.nc", "N10 G79 L|\nN20 G70\n");
    assert_eq!(labels(&answer), ["L77"]);
}

#[test]
fn blocks_of_a_long_unit() {
    let mut editor = Editor::english();
    let long: String = (1..=3000).map(|n| format!("N{n} X{n}\n")).collect();
    let answer = editor.complete(&format!("%1\n{long}N3001 G73 L|\n{}N9000 M30\n", long.replace('N', "N5")));
    assert_eq!(answer["isIncomplete"], true);
    assert_eq!(items(&answer).len(), 500);
    assert_eq!(labels(&answer)[0], "L3000");
}

#[test]
fn parameters() {
    let mut editor = Editor::new("en", "[parameters]\nR20 = 1.5\n[operations]\n1 = \"add\"\n2 = \"sqrt\"\n", true);
    let program = |block: &str| format!("%1\nN10 R10=25.5 R11=R10\nN20 G90 XR12\nN30 {block}\nN40 R10=7 M30\n");
    let answer = editor.complete(&program("XR|"));
    assert_eq!(labels(&answer), ["R10", "R11", "R12", "R20"]);
    let details: Vec<&Value> = items(&answer).iter().map(|item| &item["detail"]).collect();
    assert_eq!(details, ["= 25.5 in N10", "= R10 in N10", "not assigned here", "= 1.5 by configuration"]);
    assert_eq!(editor.taken(&program("X-r1|"), "R11"), program("X-R11"));
    assert_eq!(editor.taken(&program("R5=|"), "R20"), program("R5=R20"));
    assert_eq!(editor.labels(&program("R10=1 R1|")), ["R11=", "R12="]);
    assert_eq!(editor.taken(&program("R1|"), "R10="), program("R10="));

    let answer = editor.complete(&program("G27 R5=1 R|"));
    assert_eq!(labels(&answer)[0], "R6=");
    assert!(!labels(&answer).contains(&"R7=".to_owned()));
    let answer = editor.complete(&program("G26 R5=|"));
    assert_eq!(labels(&answer)[..2], ["01 a + b", "02 √a"]);
    assert_eq!(item(&answer, "01 a + b")["textEdit"]["newText"], "01${1:10}${2:11}${3:12}");
    assert_eq!(editor.labels(&program("G26 R5=-02|")), ["02 √a"]);
}

/// The centre of an arc comes before all other addresses.
#[test]
fn centre_of_an_arc() {
    let mut editor = Editor::english();
    assert_eq!(editor.labels(&block("G02 |"))[..3], ["I", "J", "X"]);
    assert_eq!(editor.labels(&block("G01 |"))[..2], ["X", "Y"]);
}

#[test]
fn words_of_a_block() {
    let mut editor = Editor::new("en", "[[axes]]\nletter = \"X\"\n[[axes]]\nletter = \"C\"\n", false);
    let answer = editor.complete(&block("G01 X1 |"));
    let found = labels(&answer);
    assert_eq!(found[..2], ["C", "F"], "axes of the machine that are not there yet, then the rest");
    for absent in ["X", "Y", "L", "Q", "G00", "N30"] {
        assert!(!found.contains(&absent.to_owned()), "{absent}");
    }
    assert!(found.contains(&"G90".to_owned()) && found.contains(&"M08".to_owned()));
    let documentation = item(&answer, "C")["documentation"]["value"].as_str().unwrap();
    assert!(documentation.contains("rotary") && documentation.contains("±69999.999°"), "{documentation}");
    assert!(editor.labels(&block("G04 |")).contains(&"Q".to_owned()));
    assert_eq!(editor.labels(&block("F|")), ["F"]);
    assert_eq!(editor.labels(&block("Y|")), Vec::<String>::new(), "no such axis");
    assert_eq!(editor.labels("%1\nN10 M30\nN20 G79 L5 |\nN30 G70"), Vec::<String>::new());
}

/// What the rules leave to a block: by its unit, its other words, and what is in force.
#[test]
fn words_that_a_block_takes() {
    let mut editor = Editor::new("en", "dialect = \"cnc8x9\"\n", false);
    let units = "N90 M30\nN100 G79 L1\nN110 X5\nN120 G70\n";
    // Each: text, what is offered, what is not.
    for (text, there, absent) in [
        ("%1\nN10 G01 X5 |\n", "Y F G90 M03", "I J K G70 G79"),
        ("%1\nN10 G02 X5 |\n", "I J", "K"),
        ("%1\nN10 G02 X5 I5\nN20 X9 |\n", "I J", "K"),
        ("%1\nN10 G09 G90\nN20 G02 X9 |\n", "I J K", ""),
        ("%1\nN10 G23 |\n", "I", "J K"),
        ("%1\nN10 G35 |\n", "I J K", ""),
        ("%1\nN10 G02 G92 X1 |\n", "", "I J K"),
        ("%1\nN10 G81\nN20 X1 |\n", "I J K", ""),
        ("%1\nN10 M30 |\n", "G90", "G71 G72 G73"),
        ("%1\nN10 G71 |\n", "M03", "M02 M30"),
        ("%1\nN10 A1 U1 C1 |\n", "X", "B V W"),
        ("%1\nN10 U1 V1 |\n", "A B C", "W"),
        ("%1\nN10 M30\nN20 |\n", "G79", "X G00 M03"),
        ("%1\nN10 M30\nN20 L5 |\nN30 G70\n", "G79", "X G00 M03"),
        ("%1\nN10 G02 X2 Y0 I1 G71 L5\nN15 X5 |\nN20 M30\nN30 G79 L5\nN40 G01 X0 G70\n", "I J", ""),
        ("%1\nN10 G71 L5\nN20 M30\nN30 G79 L5\nN40 X4 |\nN50 G70\n", "I J", ""),
        ("%1\nN10 G02 X1 I1\nN15 /G01 X5\nN20 X9 |\n", "I J", ""),
        ("%1\nN10 GR1 X4 |\n", "I J K", ""),
    ] {
        let text = if text.contains("M30") { text.to_owned() } else { format!("{text}{units}") };
        let found = editor.labels(&text);
        let offered = |label: &&str| found.contains(&(*label).to_owned());
        let missing: Vec<_> = there.split_whitespace().filter(|label| !offered(label)).collect();
        let wrong: Vec<_> = absent.split_whitespace().filter(offered).collect();
        assert!(missing.is_empty() && wrong.is_empty(), "{text}: {missing:?} {wrong:?} {found:?}");
    }
    let sub = "%1\nN10 R3=5 M30\nN100 G79 L1\nN110 |\nN120 G70\n";
    assert!(editor.labels(sub).contains(&"G70".to_owned()) && !editor.labels(sub).contains(&"G79".to_owned()));
    assert_eq!(editor.labels(&sub.replace("G79 L1", "G79 LR|").replace("N110 |", "N110")), Vec::<String>::new());
    assert_eq!(labels(&editor.complete_in("L7", "N1 |\nN2 G70\n")), ["G79"]);
    assert_eq!(labels(&editor.complete_in("L8", "N1 G79 L8\nN2 G70\nN3 |\n")), Vec::<String>::new());
}

#[test]
fn next_block_number() {
    let mut editor = Editor::english();
    let mut first = |text: &str| editor.labels(text).first().cloned().unwrap_or_default();
    assert_eq!(first("%1\n|"), "N10");
    assert_eq!(first("%1\nN10 G0\nN15 X1\n|"), "N20", "the step of the last two");
    assert_eq!(first("%1\nN10 G0\nN20 X1\n|\nN30 M30"), "N25", "between two");
    assert_eq!(first("%1\nN10 G0\nN20 X1\n|\nN21 M30"), "N31", "no room between");
    assert_eq!(first("%1\nN9980 G0\nN9990 X1\n|"), "N10000");
    assert_eq!(first("%1\nN99999980 G0\nN99999990 X1\n|"), "N99999995");
    assert_eq!(first("%1\nN0010 G0\nN0020 X1\n|"), "N0030");
    assert_eq!(first("%1\nN10 G0\nN20 M30\nN1000 G79 L1\n|"), "N1010", "another unit is no step");
    assert_eq!(first("%1\nN100 M30\nN10 G79 L1\n|\nN30 G70\n"), "N20");
    assert_eq!(first("%1\nN20 G0\nN30 G0\nN10 X1\n|\nN5 M30"), "N40", "N20 and N30 are taken");
    assert_ne!(first("%1\nN10 G0\nN20 X1\n|\nY5\nN30 M30"), "N25", "Y5 would get into another block");
    assert_eq!(editor.taken("%1\nN10 G0\n  n|", "N20"), "%1\nN10 G0\n  N20 ");
    assert_eq!(editor.taken("%1\nN10 G0\nN2| X1", "N20"), "%1\nN10 G0\nN20 X1");
    assert_eq!(editor.taken("N10 G0\nN|", "N20"), "N10 G0\nN20 ", "also without %");
    assert_eq!(editor.labels("%1\nN10 G0\nN3|"), Vec::<String>::new());
}

#[test]
fn snippets() {
    for (locale, axes) in [("en", ""), ("cs", "[[axes]]\nletter = \"Z\"\n"), ("en", "dialect = \"cnc8x6\"\n")] {
        let mut editor = Editor::new(locale, axes, false);
        let names: [&str; 4] = if locale == "cs" {
            ["program", "makrocyklus", "smyčka", "podprogram"]
        } else {
            ["program", "macrocycle", "loop", "subprogram"]
        };
        let [program, macrocycle, repeated, subprogram] = names;
        for typed in ["|", "%|", "pro|", "\n\"c\"\n|"] {
            let text = editor.taken(typed, program);
            assert_eq!(editor.findings("", &text), Vec::<String>::new(), "{text}");
        }
        let answer = editor.complete_in("L9001", "|");
        let text = taken("|", item(&answer, macrocycle));
        assert_eq!(editor.findings("L9001.NC", &text), Vec::<String>::new(), "{text}");

        for frame in ["%1\r\nN10 G00 X0\r\n|\r\nN20 M30\r\n", "%1\nN10 G00 X0\ns|\nN20 M30\n"] {
            let frame = if axes.contains('Z') { frame.replace('X', "Z") } else { frame.to_owned() };
            let frame = if locale == "cs" { frame } else { frame.replace("s|", "l|") };
            let text = editor.taken(&frame, repeated);
            assert_eq!(editor.findings("", &text), Vec::<String>::new(), "{text}");
            assert_eq!(frame.contains("\r\n"), text.contains("Q2\r\n") && !text.replace("\r\n", "").contains('\n'));
        }
        let frame = "%1\nN10 G71 L50\nN20 M30\n|\n*\n";
        let text = editor.taken(frame, subprogram);
        assert!(text.contains("\nN30 G79 L50 "), "{text}");
        assert_eq!(editor.findings("", &text), Vec::<String>::new(), "{text}");
    }
    let mut editor = Editor::new("en", "", true);
    let answer = editor.complete("%1\nN10 G0\nloo|\nN20 M30");
    assert_eq!(labels(&answer), ["loop"]);
    let edit = item(&answer, "loop");
    assert_eq!(edit["insertTextFormat"], 2);
    assert_eq!(edit["textEdit"]["newText"], "N13 ${1:\"body\"}$0\nN16 G73 L13 Q${2:2}");
    assert!(!editor.labels("%1\nN9990 G0\n|").contains(&"loop".to_owned()), "L cannot name N10000");
    assert!(!editor.labels("%1\nN10 M30\n|").contains(&"loop".to_owned()));
    assert!(editor.labels("%1\nN10 M30\n|").contains(&"subprogram".to_owned()));
}

#[test]
fn a_line_end_numbers_the_next_block() {
    let mut editor = Editor::english();
    for (before, after) in [
        ("%1\nN10 G00\n|", "%1\nN10 G00\nN20 "),
        ("%1 \"t\"\n|\n", "%1 \"t\"\nN10 \n"),
        ("%1\nN10 G00\n|\nN20 M30\n", "%1\nN10 G00\nN15 \nN20 M30\n"),
        ("%1\nN10 G0\n|", "%1\nN10 G00\nN20 "),
        ("%1\nN10 G00\n  |\n\nN20 M30\n", "%1\nN10 G00\nN15 \n\nN20 M30\n"),
    ] {
        assert_eq!(editor.entered(before), after);
    }
    for unchanged in [
        "%1\nN10 G00\n| X1\n",
        "%1\nN10 G00\n|\nX1\nN20 M30",
        "%1\nN10 G00\n|\n\nX1\nN20 M30",
        "%1\nN10 G00\n\n|",
        "%1\nN10 G00\n\"c\"\n|",
        "%1\nN10 M30\n|",
        "%1\nN10 M30\n*\n|",
        "%1\nN10 M30\nN20 G79 L1\nN30 G70\n|",
        "N10 G00\n|",
        "abc\n|\n%1\nN10 M30",
        "|%1",
    ] {
        assert_eq!(editor.entered(unchanged), unchanged.replacen('|', "", 1));
    }
}

/// However long the program is, an answer takes a bounded look around the cursor.
#[test]
fn a_long_program() {
    let mut editor = Editor::english();
    let long: String = (1..=60_000).map(|n| format!("N{n} G01 F5 XR{}\n", n % 90)).collect();
    for (line, expected) in [("N|", "N60001"), ("XR|", "R0"), ("G73 L9|", ""), ("N60001 G1|", "G01")] {
        let found = editor.labels(&format!("%1\n{long}{line}\nN300000 M30\n"));
        assert_eq!(found.first().map_or("", String::as_str), expected, "{line}");
    }
}

/// In the project file: what the control of the file has, with its own defaults; paths that are there.
#[test]
fn keys_of_the_control() {
    let mut editor = Editor::new("en", "", false);
    editor.file("macros/L9001", "N1 G79 L9001\nN2 G70\n");
    editor.file("Channel.xml", "<ChannelConfig/>");
    for (text, label, line) in [
        ("dialect = \"cnc8x9\"\n[limits]\n|", "feed", Some("feed = 24000")),
        ("dialect = \"cnc872\"\n[limits]\n|", "feed", Some("feed = 99999")),
        ("dialect = 'cnc8x9' # new\n|", "g97", Some("g97 = \"per-revolution\"")),
        ("dialect = \"cnc8x6\"\n[motion]\n|", "profile", Some("profile = \"ramps\"")),
        ("dialect = \"cnc8x9\"\n|", "channel-config", None),
        ("|", "channel-config", Some("channel-config = \"Channel.xml\"")),
        ("|", "macrocycles", Some("macrocycles = [\"macros\"]")),
    ] {
        let answer = editor.complete_in("cnc872c.toml", text);
        let found = items(&answer).iter().find(|item| item["label"] == label);
        let found = found.map(|item| item["textEdit"]["newText"].as_str().unwrap());
        assert_eq!(found, line, "{text}");
    }
    assert_eq!(
        item(&editor.complete_in("sub/cnc872c.toml", "|"), "macrocycles")["textEdit"]["newText"],
        "macrocycles = [\".\"]"
    );
    assert!(!labels(&editor.complete_in("sub/cnc872c.toml", "|")).contains(&"channel-config".to_owned()));
    let (uri, position) = editor.open("cnc872c.toml", "dialect = \"cnc8x9\"\n[limits]\nfe|ed = 5\n");
    let params = json!({ "textDocument": { "uri": uri }, "position": position });
    let page = editor.client.request("textDocument/hover", params)["result"]["contents"]["value"].to_string();
    assert!(page.contains("feed = 24000"), "{page}");
}
