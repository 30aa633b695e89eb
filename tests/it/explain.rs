//! The pages of the diagnostics: every code has one in each language, and their examples are run.

use std::collections::BTreeMap;

use cnc872c::diag::Code;
use cnc872c::diag::explain::{Example, examples};
use cnc872c::dict::Lang;
use cnc872c::explain::Topic;
use cnc872c::text::MemoryLoader;

use crate::markers::{Request, options};
use crate::run::run;

const LANGS: [(Lang, &str, &str); 2] = [(Lang::En, "en", "Rule: "), (Lang::Cs, "cs", "Pravidlo: ")];

/// The kind of a fence on a page.
enum Fence<'a> {
    /// A file that the next programs use.
    File(&'a str),
    /// A program, or a macrocycle checked by itself, and the codes that it must give.
    Program { name: &'a str, codes: Vec<Code> },
}

fn fence<'a>(example: &Example<'a>) -> Fence<'a> {
    let codes = match (example.option("expect"), example.has("ok")) {
        (Some(codes), false) => codes.split(',').map(|code| Code::find(code).expect("a code")).collect(),
        (None, true) => Vec::new(),
        (None, false) => return Fence::File(example.file_name().expect("expect=, ok, or the name of a file")),
        (Some(_), true) => panic!("a program is ok or is not"),
    };
    let name = example.file_name().unwrap_or("program.nc");
    assert_eq!(example.has("macro"), name.starts_with('L'), "a macrocycle is called L and its number");
    Fence::Program { name, codes }
}

fn request(example: &Example<'_>) -> Request {
    let mut request = Request { compile: example.has("compile"), ..Request::default() };
    if let Some(dialect) = example.option("dialect") {
        options(&mut request.overrides, &format!("--dialect={dialect}"));
    }
    for args in example.info.iter().filter_map(|word| word.strip_prefix("args=")) {
        options(&mut request.overrides, args);
    }
    request
}

/// Pages are shown as they are written: their lines are short.
#[test]
fn lines_of_pages() {
    for code in Code::ALL {
        for (lang, folder, _) in LANGS {
            let long = code.page(lang).lines().find(|line| line.chars().count() > 120);
            assert_eq!(long, None, "{folder}/{code}");
        }
    }
}

/// Runs the examples of one page; gives what differs.
fn differences(page: &str) -> Vec<String> {
    let mut files: BTreeMap<&str, String> = BTreeMap::new();
    let mut differences = Vec::new();
    for example in examples(page) {
        match fence(&example) {
            Fence::File(name) => {
                files.insert(name, example.text);
            }
            Fence::Program { name, codes } => {
                let folder = files
                    .iter()
                    .fold(MemoryLoader::new(), |loader, (name, text)| loader.with(*name, text.as_bytes()))
                    .with(name, example.text.as_bytes());
                let found = run(&folder, name, &request(&example));
                if found.codes() != codes {
                    let text = found.text(cnc872c::diag::Format::Short, Lang::En);
                    differences.push(format!("expected {codes:?}\n{}{text}", example.text));
                }
                files.retain(|name, _| !name.starts_with('L'));
            }
        }
    }
    differences
}

/// diagnostics.md: every finding has a page. Its examples give exactly the codes behind their fences.
#[test]
fn examples_of_all_pages() {
    let mut wrong = Vec::new();
    for &code in Code::ALL {
        for (lang, folder, _) in LANGS {
            let found = differences(code.page(lang));
            wrong.extend(found.into_iter().map(|text| format!("docs/explain/{folder}/{code}.md: {text}\n")));
        }
    }
    assert!(wrong.is_empty(), "{} examples differ:\n{}", wrong.len(), wrong.concat());
}

/// A page begins with its code and name, ends with its rule, shows its code and a program without it.
#[test]
fn form_of_all_pages() {
    for &code in Code::ALL {
        for (lang, folder, rule) in LANGS {
            let place = format!("docs/explain/{folder}/{code}.md");
            let page = code.page(lang);
            assert!(page.starts_with(&format!("# {code}: {}\n\n", code.name())), "{place}: the title");
            assert!(page.lines().last().unwrap().starts_with(rule), "{place}: the last line is not `{rule}…`");
            if page.contains("<!-- no example") {
                continue;
            }
            let programs: Vec<Vec<Code>> = examples(page)
                .iter()
                .filter_map(|example| match fence(example) {
                    Fence::Program { codes, .. } => Some(codes),
                    Fence::File(_) => None,
                })
                .collect();
            assert!(programs.iter().any(|codes| codes.contains(&code)), "{place}: no example of {code}");
            assert!(programs.iter().any(Vec::is_empty), "{place}: no example of what is right");
        }
    }
}

/// A line of a part program without its comments (LEX-6, LEX-12), and with words of prose as one mark: what was meant
/// as a comment and is none differs too.
fn without_comments(line: &str) -> String {
    let mut comment = false;
    let mut code = String::new();
    for character in line.chars() {
        if matches!(character, '"' | '„' | '“' | '”') {
            comment = !comment;
            code.push('"');
        } else if !comment {
            code.push(character);
        }
    }
    let is_prose = |word: &&str| word.chars().filter(|character| character.is_alphabetic()).count() > 2;
    let words: Vec<&str> = code.split(' ').map(|word| if is_prose(&word) { "…" } else { word }).collect();
    words.join(" ")
}

/// The text of an example without its comments.
fn uncommented(example: &Example<'_>) -> String {
    let language = *example.info.first().unwrap();
    let line = |line: &str| match language {
        "nc" => without_comments(line),
        "toml" => line.split(" #").next().unwrap_or_default().trim_end().to_owned(),
        _ => line.to_owned(),
    };
    example.text.lines().map(|text| line(text) + "\n").collect()
}

/// Both languages show the same programs, comments aside.
#[test]
fn the_same_examples_in_both_languages() {
    for &code in Code::ALL {
        let of = |lang| -> Vec<(Vec<&str>, String)> {
            let found = examples(code.page(lang));
            found.into_iter().map(|example| (example.info.clone(), uncommented(&example))).collect()
        };
        assert_eq!(of(Lang::En), of(Lang::Cs), "{code}");
    }
}

/// No page without its code.
#[test]
fn no_page_too_many() {
    for (_, folder, _) in LANGS {
        let root = std::path::Path::new(env!("CARGO_MANIFEST_DIR")).join("docs/explain").join(folder);
        let mut pages: Vec<String> = crate::disk::files(&root)
            .iter()
            .map(|path| path.file_name().unwrap().to_str().unwrap().to_owned())
            .filter(|name| name.len() == "E0101.md".len())
            .collect();
        pages.sort();
        let mut wanted: Vec<String> = Code::ALL.iter().map(|code| format!("{code}.md")).collect();
        wanted.sort();
        assert_eq!(pages, wanted, "{folder}");
    }
}

/// The examples of functions are executed. What their pages announce is expected: copying is not modelled, positions
/// are unknown after G30, a change of origin.
#[test]
fn examples_of_functions() {
    let announced = [Code::W0612, Code::W0605, Code::W0610];
    let mut wrong = Vec::new();
    let topics = Topic::all().filter(|topic| matches!(topic, Topic::G(_) | Topic::M(_)));
    for topic in topics {
        let page = topic.page(Lang::En);
        let mut folder = MemoryLoader::new().with("L8100", "N1 G79 L8100\nN2 G91 G01 Z-1 F100\nN3 G90 G70\n");
        let mut programs = 0;
        for example in examples(&page).into_iter().filter(|example| !example.info.is_empty()) {
            if let Some(name) = example.file_name() {
                folder = folder.with(name, example.text);
                continue;
            }
            programs += 1;
            let end = if ["M30", "M02"].iter().any(|end| example.text.contains(end)) { "" } else { "N9999 M30\n" };
            let folder = folder.clone().with("a.nc", format!("%1\n{}{end}", example.text));
            let mut request = Request::default();
            let old = matches!(topic, Topic::M(36 | 37));
            options(&mut request.overrides, if old { "--dialect=cnc8x9" } else { "" });
            let found = run(&folder, "a.nc", &request);
            if found.codes().iter().any(|code| !announced.contains(code)) {
                let text = found.text(cnc872c::diag::Format::Short, Lang::En);
                wrong.push(format!("{}: {text}\n{}", topic.name(), example.text));
            }
        }
        assert!(programs > 0, "{}", topic.name());
    }
    assert!(wrong.is_empty(), "{}", wrong.join("\n"));
}
