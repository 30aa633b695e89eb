//! Samples of `format` and `renumber`: a program or macrocycle and the text that it becomes, by the rule that the
//! folder's name begins with. Without `expected.txt` the command refuses the file and leaves it; `arguments.txt` has
//! more arguments, `says.txt` what stands on standard error.

use std::collections::BTreeSet;
use std::fs;
use std::path::{Path, PathBuf};

use cnc872c::config::{Overrides, configure};
use cnc872c::diag::Findings;
use cnc872c::session::{Part, Session};
use cnc872c::text::{MemoryLoader, Sources};
use serde_json::Value;

use crate::cli::Place;
use crate::disk::TestDisk;
use crate::same_program::stays_the_same;
use crate::samples::root;

struct Sample {
    folder: PathBuf,
    /// The file's name.
    name: String,
    before: Vec<u8>,
    expected: Option<Vec<u8>>,
}

fn samples(command: &str) -> Vec<Sample> {
    let entries = fs::read_dir(root().join("samples").join(command)).unwrap();
    let mut folders: Vec<PathBuf> = entries.map(|entry| entry.unwrap().path()).collect();
    folders.sort();
    folders.into_iter().map(sample).collect()
}

fn sample(folder: PathBuf) -> Sample {
    let mut names = fs::read_dir(&folder).unwrap().map(|entry| entry.unwrap().file_name().into_string().unwrap());
    let name = names.find(|name| !name.ends_with(".txt") && !name.ends_with(".toml")).expect("a program");
    let before = fs::read(folder.join(&name)).unwrap();
    let expected = fs::read(folder.join("expected.txt")).ok();
    Sample { folder, name, before, expected }
}

/// Runs the command on a copy of a sample.
fn run(command: &str, sample: &Sample) {
    let text = |name: &str| fs::read_to_string(sample.folder.join(name)).unwrap_or_default();
    let place =
        Place::with(&[(&sample.name, sample.before.as_slice()), ("cnc872c.toml", text("cnc872c.toml").as_bytes())]);
    let arguments = text("arguments.txt");
    let arguments: Vec<&str> = [command, &sample.name].into_iter().chain(arguments.split_whitespace()).collect();
    let run = place.run(&arguments).ends(i32::from(sample.expected.is_none()));
    let after = place.read(&sample.name);
    let expected = sample.expected.as_ref().unwrap_or(&sample.before);
    let shown = |bytes: &[u8]| String::from_utf8_lossy(bytes).into_owned();
    assert_eq!(shown(&after), shown(expected), "{}", sample.folder.display());
    assert_eq!(&after, expected, "{}", sample.folder.display());
    for line in text("says.txt").lines() {
        assert!(run.stderr.contains(line), "{}: {line}\n{}", sample.folder.display(), run.stderr);
    }
}

/// Each rule from 1 to `last` has a sample.
fn assert_rules(family: &str, last: usize, samples: &[Sample]) {
    let named = |sample: &Sample| {
        let name = sample.folder.file_name().unwrap().to_string_lossy().into_owned();
        name.strip_prefix(family)?.split('-').nth(1)?.parse().ok()
    };
    let rules: BTreeSet<usize> = samples.iter().filter_map(named).collect();
    assert_eq!(rules, (1..=last).collect());
}

/// FMT-1 to FMT-7, and that each formatted file is the same program as before.
#[test]
fn formatted_samples() {
    let samples = samples("format");
    assert_rules("FMT", 7, &samples);
    for sample in samples {
        run("format", &sample);
        let project = sample.folder.join("cnc872c.toml");
        let project = project.is_file().then_some(project);
        let mut findings = Findings::new();
        let settings = configure(
            project.as_deref(),
            &Overrides::default(),
            &TestDisk { root: root().to_path_buf() },
            &mut Sources::new(),
            &mut findings,
        );
        assert!(!findings.has_errors(), "{}", sample.folder.display());
        if let Err(difference) = stays_the_same(&sample.name, &sample.before, &settings) {
            panic!("{difference}");
        }
    }
}

/// REN-1 to REN-5, and that each renumbered file is the same program but for the numbers.
#[test]
fn renumbered_samples() {
    let samples = samples("renumber");
    assert_rules("REN", 5, &samples);
    for sample in samples {
        run("renumber", &sample);
        if let Some(expected) = &sample.expected {
            let (before, after) = (records(&sample.before), records(expected));
            // Double numbers (E0204) keep a program from being compiled.
            assert!(before.is_empty() || before == after, "{}: {before:?} {after:?}", sample.folder.display());
        }
    }
}

/// The records of a program without the numbers of its blocks (REN-5).
fn records(bytes: &[u8]) -> Vec<Value> {
    fn strip(value: &mut Value) {
        if let Some(fields) = value.as_object_mut() {
            fields.retain(|name, _| !matches!(name.as_str(), "n" | "to" | "column"));
            fields.values_mut().for_each(strip);
        } else if let Some(items) = value.as_array_mut() {
            items.iter_mut().for_each(strip);
        }
    }
    let loader = MemoryLoader::new().with("p.nc", bytes.to_vec());
    let settings = cnc872c::config::Settings::default();
    let session = Session { loader: &loader, settings: &settings, progress: None };
    let mut stream = Vec::new();
    session.compile(Path::new("p.nc"), "p.nc", Part::default(), &mut stream).unwrap();
    let lines = stream.split(|byte| *byte == b'\n').filter(|line| !line.is_empty());
    lines
        .map(|line| {
            let mut record = serde_json::from_slice(line).unwrap();
            strip(&mut record);
            record
        })
        .collect()
}
