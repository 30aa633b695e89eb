//! Marked samples: the findings of a sample are exactly those that its marker lines name, at the places that their
//! carets cover. A marker is a comment line under the text: `"   ^^^ E0306`, or `"@ LINE:COL-LINE:COL CODE` anywhere.

use std::collections::BTreeSet;
use std::fs;
use std::path::{Path, PathBuf};

use cnc872c::config::{Overrides, configure, find_project, parse_parameter};
use cnc872c::diag::{Code, Findings, Severity};
use cnc872c::session::{Part, Session};
use cnc872c::text::{LineColumn, Sources};

use crate::disk::{TestDisk, files};

/// A finding as a test compares it: file, start, end, code.
type Place = (String, (u32, u32), (u32, u32), String);

/// A sample's request for the run.
#[derive(Debug, Default)]
pub struct Request {
    pub overrides: Overrides,
    pub compile: bool,
    /// `plc` with these signals.
    pub plc: Option<String>,
}

/// The lines of a file, split at LF only, as text: markers are ASCII whatever the code page.
fn lines(bytes: &[u8]) -> Vec<String> {
    if let Some(wide) = bytes.strip_prefix(&[0xff, 0xfe]) {
        let units: Vec<u16> = wide.chunks(2).map(|pair| u16::from_le_bytes([pair[0], pair[1]])).collect();
        return String::from_utf16(&units).unwrap().lines().map(str::to_owned).collect();
    }
    bytes
        .split(|byte| *byte == b'\n')
        .map(|line| line.iter().map(|byte| char::from(*byte)).collect::<String>().trim_end_matches('\r').to_owned())
        .collect()
}

fn place(text: &str) -> Option<(u32, u32)> {
    let (line, column) = text.split_once(':')?;
    Some((line.parse().ok()?, column.parse().ok()?))
}

/// The findings that the marker lines of a file expect.
fn expected(name: &str, bytes: &[u8]) -> BTreeSet<Place> {
    let mut places = BTreeSet::new();
    let mut marked = 0;
    for (index, line) in lines(bytes).iter().enumerate() {
        let body = line
            .strip_prefix('"')
            .or_else(|| line.strip_prefix('#'))
            .or_else(|| line.trim_start().strip_prefix("<!--").map(|rest| rest.trim_end_matches("-->").trim_end()));
        let words: Vec<&str> = body.unwrap_or_default().split_whitespace().collect();
        let is_code = |text: &str| Code::find(text).is_some() && text.len() == 5;
        match words.as_slice() {
            ["@", span, code] if is_code(code) => {
                let (start, end) = span.split_once('-').expect("a span");
                let (start, end) = (place(start).expect("a place"), place(end).expect("a place"));
                places.insert((name.to_owned(), start, end, (*code).to_owned()));
            }
            [carets, code] if carets.bytes().all(|byte| byte == b'^') && is_code(code) => {
                let from = u32::try_from(line.find('^').expect("a caret")).unwrap() + 1;
                let to = from + u32::try_from(carets.len()).unwrap();
                places.insert((name.to_owned(), (marked, from), (marked, to), (*code).to_owned()));
            }
            _ => marked = u32::try_from(index).unwrap() + 1,
        }
    }
    places
}

/// The `"!` lines of a program.
pub fn request(bytes: &[u8]) -> Request {
    let mut request = Request::default();
    for line in lines(bytes) {
        let Some(rest) = line.strip_prefix("\"!") else { continue };
        let rest = rest.trim();
        if rest == "compile" {
            request.compile = true;
        } else if let Some(signals) = rest.strip_prefix("plc=") {
            request.plc = Some(signals.to_owned());
            request.overrides.computes_motion = true;
        } else if let Some(dialect) = rest.strip_prefix("dialect=") {
            option(&mut request.overrides, "--dialect", dialect);
        } else if let Some(args) = rest.strip_prefix("args=") {
            options(&mut request.overrides, args);
        } else {
            panic!("what is `{rest}`?");
        }
    }
    request
}

/// Applies options written as on the command line.
pub fn options(overrides: &mut Overrides, args: &str) {
    let mut words = args.split_whitespace();
    while let Some(word) = words.next() {
        match word.split_once('=') {
            Some((name, value)) => option(overrides, name, value),
            None if ["--block-skip", "--optional-stop"].contains(&word) => option(overrides, word, ""),
            None => option(overrides, word, words.next().expect("a value")),
        }
    }
}

fn option(overrides: &mut Overrides, name: &str, value: &str) {
    use clap::ValueEnum;
    use cnc872c::config::Level;
    let mut level = |level| overrides.lints.push((Code::find(value).expect("a code"), level));
    match name {
        "--dialect" => overrides.dialect = Some(ValueEnum::from_str(value, true).expect("a dialect")),
        "--encoding" => overrides.encoding = Some(ValueEnum::from_str(value, true).expect("an encoding")),
        "--block-skip" => overrides.block_skip = Some(true),
        "--optional-stop" => overrides.optional_stop = Some(true),
        "--max-blocks" => overrides.max_blocks = Some(value.parse().expect("a number")),
        "--param" => overrides.parameters.push(parse_parameter(value).expect("a parameter")),
        "-A" => level(Level::Allow),
        "-W" => level(Level::Warn),
        "-D" => level(Level::Deny),
        "-L" => overrides.macrocycles.push(value.into()),
        other => panic!("what is {other}?"),
    }
}

/// The findings of a file of a folder, with the file names as they are in it.
pub fn findings(folder: &Path, file: &str, request: &Request) -> Vec<(Place, Severity)> {
    let disk = TestDisk { root: folder.to_path_buf() };
    let project = find_project(Path::new(""), &disk);
    let (mut sources, mut findings) = (Sources::new(), Findings::new());
    let settings = configure(project.as_deref(), &request.overrides, &disk, &mut sources, &mut findings);
    let mut all = listed(&sources, findings.items(), |code| settings.severity(code));
    if findings.has_errors() {
        return all;
    }
    let session = Session { loader: &disk, settings: &settings, progress: None };
    let outcome = if let Some(signals) = &request.plc {
        crate::plc::signals(&session, file, signals)
    } else if request.compile {
        let mut stream = Vec::new();
        session.compile(Path::new(file), file, Part::default(), &mut stream).expect("memory").outcome
    } else {
        session.check(Path::new(file), file)
    };
    let severity = |code| outcome.findings.levels().of(code);
    all.extend(listed(&outcome.sources, outcome.findings.items(), severity));
    all
}

fn listed(
    sources: &Sources,
    items: &[cnc872c::diag::Diagnostic],
    severity: impl Fn(Code) -> Option<Severity>,
) -> Vec<(Place, Severity)> {
    let at = |place: LineColumn| (place.line, place.column);
    items
        .iter()
        .filter_map(|found| {
            let source = sources.get(found.at.file).expect("a file of the run");
            assert!(found.at.span.end <= source.len(), "{}: span outside the file", found.code());
            let start = at(source.line_column(found.at.span.start));
            let end = at(source.line_column(found.at.span.end));
            Some(((source.name().to_owned(), start, end, found.code().to_string()), severity(found.code())?))
        })
        .collect()
}

/// Checks one sample; gives what differs, and how many findings there are.
fn compare(sample: &Path) -> (Option<String>, usize) {
    let (folder, file) = if sample.is_dir() {
        let program = sample.join("program.nc");
        let file = if program.is_file() {
            "program.nc".to_owned()
        } else {
            let mut names: Vec<String> = fs::read_dir(sample)
                .unwrap()
                .map(|entry| entry.unwrap().file_name().into_string().unwrap())
                .filter(|name| name.starts_with(['L', 'l']))
                .collect();
            names.sort();
            names.first().expect("a macrocycle").clone()
        };
        (sample.to_path_buf(), file)
    } else {
        (sample.parent().unwrap().to_path_buf(), sample.file_name().unwrap().to_str().unwrap().to_owned())
    };
    let request = request(&fs::read(folder.join(&file)).unwrap());
    let found = findings(&folder, &file, &request);
    let places: BTreeSet<Place> = found.iter().map(|(place, _)| place.clone()).collect();
    let mut wanted = BTreeSet::new();
    if sample.is_dir() {
        for path in files(sample) {
            let name = path.strip_prefix(sample).unwrap().to_str().unwrap().to_owned();
            wanted.extend(expected(&name, &fs::read(&path).unwrap()));
        }
    } else {
        wanted = expected(&file, &fs::read(sample).unwrap());
    }
    if places == wanted {
        return (None, found.len());
    }
    let mut difference = format!("{}\n", sample.display());
    for place in wanted.difference(&places) {
        difference += &format!("    missing    {place:?}\n");
    }
    for place in places.difference(&wanted) {
        difference += &format!("    unexpected {place:?}\n");
    }
    (Some(difference), found.len())
}

/// Checks the samples of a folder; gives their names and the numbers of their findings.
fn compare_all(folder: &str) -> Vec<(PathBuf, usize)> {
    let root = Path::new(env!("CARGO_MANIFEST_DIR")).join("samples").join(folder);
    let mut samples: Vec<PathBuf> = fs::read_dir(&root).unwrap().map(|entry| entry.unwrap().path()).collect();
    samples.sort();
    assert!(samples.len() > 40, "the samples are gone");
    let compared: Vec<_> = samples.iter().map(|sample| compare(sample)).collect();
    let differences: Vec<&str> = compared.iter().filter_map(|(difference, _)| difference.as_deref()).collect();
    assert!(differences.is_empty(), "{} samples differ:\n{}", differences.len(), differences.concat());
    samples.into_iter().zip(compared.into_iter().map(|(_, count)| count)).collect()
}

/// One erroneous sample, or more, for every code.
#[test]
fn erroneous_samples() {
    compare_all("err");
}

/// What each rule of the language makes of programs.
#[test]
fn rule_samples() {
    compare_all("rules");
}

/// Programs with one slip each, as people make them: one finding, or two.
#[test]
fn slips() {
    let wrong: Vec<_> = compare_all("slips").into_iter().filter(|(_, count)| !(1..=2).contains(count)).collect();
    assert!(wrong.is_empty(), "{wrong:?}");
}
