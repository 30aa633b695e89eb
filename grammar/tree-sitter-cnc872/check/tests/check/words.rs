//! The words and comments of the tree are those of cnc872c's own parser, at the same places.

use std::collections::BTreeSet;
use std::fs;
use std::ops::Range;
use std::path::Path;
use std::sync::Arc;

use cnc872c::diag::Findings;
use cnc872c::dict::Address;
use cnc872c::resolve::Library;
use cnc872c::syntax::{Form, Kind, Shape, parse, tokens};
use cnc872c::text::{Encoding, FileId, SourceText};
use tree_sitter::Node;
use tree_sitter_cnc872_check as tree_sitter_cnc872;

/// The contents of a file, each with its kind and place: a block is its `N` word, then its words in order, then
/// its comments.
#[derive(Debug, Default, PartialEq)]
pub struct Outline {
    pub header: Vec<(String, Range<usize>)>,
    pub blocks: Vec<Vec<(String, Range<usize>)>>,
}

/// The kind of node that a word with that address is.
fn kind(address: Address) -> &'static str {
    match address {
        Address::Program => "program_number",
        Address::N => "block_number",
        Address::Skip => "skip",
        Address::G => "preparatory_function",
        Address::X
        | Address::Y
        | Address::Z
        | Address::A
        | Address::B
        | Address::C
        | Address::U
        | Address::V
        | Address::W => "axis_word",
        Address::I | Address::J | Address::K => "center_word",
        Address::R => "parameter_assignment",
        Address::Correction | Address::D => "correction_word",
        Address::F => "feed_word",
        Address::S => "speed_word",
        Address::L => "target_word",
        Address::Q => "repeat_word",
        Address::H | Address::P => "auxiliary_function",
        Address::T => "tool_word",
        Address::M => "technological_function",
    }
}

/// Findings of cnc872c about the form of words; they are errors in the tree too.
const FORM: [&str; 11] =
    ["E0101", "E0102", "E0103", "E0104", "E0106", "E0107", "E0111", "E0202", "E0203", "E0301", "E0511"];

/// What cnc872c's parser reads, and the codes of its findings about the form.
pub fn own(source: &Arc<SourceText>, form: Form) -> (Outline, BTreeSet<String>) {
    let mut findings = Findings::new();
    let parsed = parse(FileId(0), source, form, &mut findings);
    let text = source.text();
    let mut outline = Outline::default();
    if let Some(program) = parsed.program {
        outline.header.push((kind(Address::Program).to_owned(), program.span(text).range()));
    }
    let first = parsed.block_ids().next().and_then(|block| parsed.n_word(block));
    let end = first.map_or(parsed.end, |word| word.start());
    for token in tokens(text, parsed.start, end).filter(|token| is_comment(token.kind)) {
        outline.header.push(("comment".to_owned(), token.span().range()));
    }
    for block in parsed.block_ids() {
        let words = parsed.n_word(block).into_iter().chain(parsed.words(block).iter().copied());
        let words = words.map(|word| (kind(word.address).to_owned(), word.span(text).range()));
        let comments = parsed.comments_behind(block).iter().map(|span| ("comment".to_owned(), span.range()));
        outline.blocks.push(words.chain(comments).collect());
    }
    let codes = findings.into_sorted().into_iter().map(|found| found.code().to_string());
    (outline, codes.filter(|code| FORM.contains(&code.as_str())).collect())
}

fn is_comment(kind: Kind) -> bool {
    matches!(kind, Kind::Comment | Kind::Junk(Shape::TypographicComment))
}

/// Reads the contents from the tree.
pub fn tree(root: Node<'_>, text: &str) -> Outline {
    let mut outline = Outline::default();
    let mut cursor = root.walk();
    let things: Vec<Node<'_>> = root.named_children(&mut cursor).collect();
    for node in things {
        match node.kind() {
            "program_number" => outline.header.insert(0, thing(node, text)),
            "comment" => outline.header.push(thing(node, text)),
            "block" => {
                let mut cursor = node.walk();
                let inner: Vec<Node<'_>> = node.named_children(&mut cursor).filter(|node| !node.is_error()).collect();
                let (comments, words): (Vec<_>, Vec<_>) = inner.into_iter().partition(|node| node.kind() == "comment");
                outline.blocks.push(words.into_iter().chain(comments).map(|node| thing(node, text)).collect());
            }
            _ => {}
        }
    }
    outline
}

fn thing(node: Node<'_>, text: &str) -> (String, Range<usize>) {
    let mut range = node.byte_range();
    // A comment that is open at the end of the file holds what DOS editors leave there; for cnc872c it does not
    // (LEX-8).
    const TAIL: [char; 6] = ['\u{1a}', '\0', ' ', '\t', '\r', '\n'];
    if node.kind() == "comment" && text[range.start..].contains(['\u{1a}', '\0']) {
        range.end = range.end.min(text.trim_end_matches(TAIL).len());
    }
    (node.kind().to_owned(), range)
}

fn form(path: &Path) -> Form {
    if Library::number(path).is_some() { Form::Macrocycle } else { Form::Program }
}

/// Every part program of the project, as text.
pub fn programs(folders: &[&str]) -> Vec<(String, Arc<SourceText>, Form)> {
    let mut found = Vec::new();
    for folder in folders {
        for path in crate::files(&crate::root().join(folder)) {
            let name = path.strip_prefix(crate::root()).unwrap().display().to_string();
            let is_program =
                path.extension().is_none_or(|extension| !["toml", "xml", "md"].iter().any(|e| *e == extension));
            if !is_program || name.ends_with(".gitattributes") {
                continue;
            }
            // The code page does not matter here: outside comments all of them are ASCII.
            let Ok(source) = SourceText::decode(name.clone(), fs::read(&path).unwrap(), Encoding::Cp852) else {
                continue;
            };
            found.push((name, Arc::new(source), form(&path)));
        }
    }
    found
}

/// Compares the two parsers on one text; what differs.
fn difference(name: &str, source: &Arc<SourceText>, form: Form) -> Option<String> {
    let text = source.text();
    // A tree knows no names of files: what has no `%` is read as a macrocycle is.
    let form = if text.contains('%') { form } else { Form::Macrocycle };
    let (own, codes) = own(source, form);
    let parsed = tree_sitter_cnc872::parse(text);
    let error = parsed.root_node().has_error();
    if error == codes.is_empty() {
        return Some(format!("{name}: {codes:?}, but {}", parsed.root_node().to_sexp()));
    }
    let tree = tree(parsed.root_node(), text);
    if !error && tree != own {
        let at = tree.blocks.iter().zip(&own.blocks).position(|(tree, own)| tree != own);
        return Some(format!(
            "{name}: {at:?}, {:?} and {:?}, header {:?} and {:?}",
            at.map(|at| &tree.blocks[at]),
            at.map(|at| &own.blocks[at]),
            tree.header,
            own.header
        ));
    }
    None
}

/// Valid programs have no errors in their trees, and the same words and comments.
#[test]
fn valid_samples() {
    let programs = programs(&["samples/ok", "samples/projects", "docs/guide/examples"]);
    assert!(programs.len() > 20);
    for (name, source, form) in programs {
        // The guide fixes their slips.
        if name.ends_with("examples/plate.nc") || name.ends_with("examples/deska.nc") {
            continue;
        }
        let (_, codes) = own(&source, form);
        assert!(codes.is_empty(), "{name}: {codes:?}");
        assert_eq!(difference(&name, &source, form), None);
    }
}

/// A word with a wrong form is an error in the tree; no other fault is one.
#[test]
fn erroneous_samples() {
    let programs = programs(&["samples/err", "samples/rules", "docs/guide/examples"]);
    assert!(programs.len() > 150);
    // The compiler explains the notation of other controls; the tree reads the same text by its letters.
    let foreign = [
        "samples/err/E0411-missing-dwell.nc",
        "samples/rules/flw-foreign.nc",
        "samples/rules/grp-dwell-seconds.nc",
        "samples/rules/grp-dwell.nc",
    ];
    let differences: Vec<String> = programs
        .iter()
        .filter(|(name, ..)| !foreign.iter().any(|foreign| name.ends_with(foreign)))
        .filter_map(|(name, source, form)| difference(name, source, *form))
        .collect();
    assert!(differences.is_empty(), "{}", differences.join("\n"));
}

/// The examples under the productions of the EBNF.
#[test]
fn examples_of_the_ebnf() {
    let ebnf = fs::read_to_string(crate::root().join("grammar/part-program.ebnf")).unwrap();
    let mut examples = 0;
    let mut differences = Vec::new();
    for line in ebnf.lines() {
        let Some(comment) = line.strip_prefix("(* ").and_then(|rest| rest.strip_suffix(" *)")) else { continue };
        let Some((head, text)) = comment.split_once(": ") else { continue };
        let text = [("\\n", "\n"), ("\\r", "\r"), ("\\t", "\t"), ("\\z", "\u{1a}"), ("\\0", "\0")]
            .into_iter()
            .fold(text.trim_start().to_owned(), |text, (escape, character)| text.replace(escape, character));
        let (text, form) = match head.rsplit(' ').next() {
            Some("file") => (text, Form::Program),
            Some("macrocycle") => (text, Form::Macrocycle),
            Some("blocks") => (format!("%1\n{text}"), Form::Program),
            Some("words") => (format!("%1\nN10 {text}"), Form::Program),
            _ => continue,
        };
        examples += 1;
        let source = Arc::new(SourceText::from_text("example", text));
        differences.extend(difference(line, &source, form));
    }
    assert!(examples > 80, "the examples are not found");
    assert!(differences.is_empty(), "{}", differences.join("\n"));
}

/// Every address of the dictionary makes the kind of word that it should.
#[test]
fn every_address() {
    for address in Address::ALL {
        for letter in [address.letter().to_owned(), address.letter().to_lowercase()] {
            let (text, expected) = match address {
                Address::Program => (format!("{letter}1"), kind(*address)),
                Address::Skip => (format!("N1 {letter}"), kind(*address)),
                Address::R => (format!("N1 {letter}1=2"), kind(*address)),
                _ => (format!("N1 {letter}1"), kind(*address)),
            };
            let tree = tree_sitter_cnc872::parse(&text);
            assert!(!tree.root_node().has_error(), "{text}");
            assert!(tree.root_node().to_sexp().contains(&format!("({expected}")), "{text}");
        }
    }
    // Letters that are no address are errors.
    for letter in 'A'..='Z' {
        let known = Address::ALL.iter().any(|address| address.letter().starts_with(letter));
        let tree = tree_sitter_cnc872::parse(&format!("N1 {letter}1=1"));
        let word = tree_sitter_cnc872::parse(&format!("N1 {letter}1"));
        assert_eq!(word.root_node().has_error(), !known || letter == 'R', "{letter}");
        assert_eq!(tree.root_node().has_error(), letter != 'R', "{letter}");
    }
}
