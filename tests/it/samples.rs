//! The samples: valid programs have no findings and a complete stream in which every record is valid; findings and
//! streams are compared with `snapshots/`.

use std::collections::BTreeSet;
use std::fmt::Write as _;
use std::fs;
use std::path::{Path, PathBuf};
use std::sync::LazyLock;

use cnc872c::diag::Format;
use cnc872c::dict::Lang;
use cnc872c::session::Session;
use cnc872c::text::{Encoding, SourceText};
use serde_json::Value;

use crate::disk::TestDisk;
use crate::disk::files;
use crate::json_schema::{Validator, validator_for};
use crate::markers::{Request, request};
use crate::run::{Run, run};

/// Streams with more lines are shortened to their first and last ones.
const LONGEST: usize = 400;
const FIRST: usize = 40;
const LAST: usize = 5;
/// Sources with more lines are left out of the snapshots of findings.
const LONGEST_SOURCE: usize = 60;

/// The schema of the records, compiled once.
pub static RECORDS: LazyLock<Validator> = LazyLock::new(|| validator_for(&cnc872c::stream::schema()));

pub fn root() -> &'static Path {
    Path::new(env!("CARGO_MANIFEST_DIR"))
}

/// A program or macrocycle of a sample.
struct Sample {
    /// As a snapshot is named after it.
    name: String,
    folder: PathBuf,
    file: String,
}

impl Sample {
    /// The file at `path` in the folder of its project, `folder`.
    fn of(path: &Path, folder: &Path) -> Self {
        let within = |root: &Path| -> Vec<&str> {
            path.strip_prefix(root).unwrap().iter().map(|part| part.to_str().unwrap()).collect()
        };
        let name = within(&root().join("samples")).split_off(1).join("-");
        Self {
            name: name.strip_suffix(".nc").unwrap_or(&name).to_owned(),
            folder: folder.to_path_buf(),
            file: within(folder).join("/"),
        }
    }

    fn is_macrocycle(&self) -> bool {
        Session::is_macrocycle_name(Path::new(&self.file))
    }

    fn run(&self, request: &Request) -> Run {
        run(&TestDisk { root: self.folder.clone() }, &self.file, request)
    }
}

/// The valid programs, with the macrocycles of their projects.
fn valid() -> Vec<Sample> {
    let mut folders: Vec<PathBuf> =
        fs::read_dir(root().join("samples/projects")).unwrap().map(|entry| entry.unwrap().path()).collect();
    folders.sort();
    folders.insert(0, root().join("samples/ok"));
    let mut samples = Vec::new();
    for folder in folders {
        for path in files(&folder) {
            let is_program = path.extension().is_some_and(|extension| extension == "nc");
            if is_program || Session::is_macrocycle_name(&path) {
                samples.push(Sample::of(&path, &folder));
            }
        }
    }
    samples
}

/// Forty correct programs from the rules of the manuals, for the mills and lathes of each control, are among the valid
/// ones.
#[test]
fn forty_programs_of_mills_and_lathes() {
    let programs = |folder: &str| {
        let is_program = |path: &PathBuf| path.extension().is_some_and(|extension| extension == "nc");
        files(&root().join("samples/projects").join(folder)).into_iter().filter(is_program).count()
    };
    let machines = ["milling-8x6", "milling-8x9", "milling-872", "turning-8x6", "turning-8x9", "turning-872"];
    let counts = machines.map(programs);
    assert!(counts.iter().all(|count| *count >= 6) && counts.iter().sum::<usize>() >= 40, "{counts:?}");
}

/// The erroneous samples: single programs, and of each folder its program, or else its macrocycle.
fn erroneous() -> Vec<Sample> {
    let mut samples = Vec::new();
    let mut entries: Vec<PathBuf> =
        fs::read_dir(root().join("samples/err")).unwrap().map(|entry| entry.unwrap().path()).collect();
    entries.sort();
    for entry in entries {
        if entry.is_file() {
            samples.push(Sample::of(&entry, &root().join("samples/err")));
            continue;
        }
        let program = entry.join("program.nc");
        let program = if program.is_file() {
            program
        } else {
            let inner = files(&entry);
            inner.iter().find(|path| Session::is_macrocycle_name(path)).expect("a macrocycle").clone()
        };
        let name = entry.file_name().unwrap().to_str().unwrap().to_owned();
        samples.push(Sample { name, ..Sample::of(&program, &entry) });
    }
    samples
}

/// Compares `text` with `snapshots/FOLDER/NAME.snap`.
fn compare(folder: &str, name: &str, text: &str) {
    let mut settings = insta::Settings::clone_current();
    settings.set_snapshot_path(root().join("snapshots").join(folder));
    settings.set_prepend_module_to_snapshot(false);
    settings.set_omit_expression(true);
    settings.bind(|| insta::assert_snapshot!(name, text));
}

/// Calls `test` for every sample and names those for which it fails.
fn for_each(samples: &[Sample], test: impl Fn(&Sample)) {
    let failed: Vec<&str> = samples
        .iter()
        .filter(|sample| std::panic::catch_unwind(std::panic::AssertUnwindSafe(|| test(sample))).is_err())
        .map(|sample| sample.name.as_str())
        .collect();
    assert!(failed.is_empty(), "{} samples fail: {}", failed.len(), failed.join(", "));
}

/// A valid program gives no finding at all; neither do the macrocycles of the projects by themselves (PAR-5).
#[test]
fn valid_samples_have_no_findings() {
    let samples = valid();
    assert!(samples.len() >= 20, "the samples are gone");
    for_each(&samples, |sample| {
        let checked = sample.run(&Request::default());
        assert_eq!(checked.text(Format::Short, Lang::En), "", "{}", sample.file);
        if !sample.is_macrocycle() {
            let compiled = sample.run(&Request { compile: true, ..Request::default() });
            assert_eq!(compiled.text(Format::Short, Lang::En), "", "{}", sample.file);
            assert_eq!(compiled.executed, checked.executed, "check and compile execute the same blocks (FLW-11)");
        }
    });
}

/// block-stream.md: a stream is complete when its last record is `end`; every record is valid by the schema.
#[test]
fn streams_of_valid_samples() {
    let programs: Vec<Sample> = valid().into_iter().filter(|sample| !sample.is_macrocycle()).collect();
    for_each(&programs, |sample| {
        let compiled = sample.run(&Request { compile: true, ..Request::default() });
        let lines = compiled.lines();
        let mut blocks = 0_u64;
        for line in &lines {
            let record: Value = serde_json::from_str(line).unwrap();
            if let Err(error) = RECORDS.validate(&record) {
                panic!("{error}: {line}");
            }
            blocks += u64::from(record["kind"] == "block");
        }
        let first: Value = serde_json::from_str(lines.first().unwrap()).unwrap();
        let last: Value = serde_json::from_str(lines.last().unwrap()).unwrap();
        assert_eq!((&first["kind"], &last["kind"]), (&"program".into(), &"end".into()));
        assert_eq!(last["blocks"], blocks);
        let version = concat!("cnc872c ", env!("CARGO_PKG_VERSION"));
        compare("streams", &sample.name, &shortened(&lines).replace(version, "cnc872c [version]"));
    });
}

fn shortened(lines: &[&str]) -> String {
    if lines.len() <= LONGEST {
        return lines.join("\n");
    }
    let (first, last) = (&lines[..FIRST], &lines[lines.len() - LAST..]);
    let left_out = lines.len() - FIRST - LAST;
    format!("{}\n… {left_out} records …\n{}", first.join("\n"), last.join("\n"))
}

/// The texts of the findings, in both languages, with the program that has them.
#[test]
fn findings_of_erroneous_samples() {
    let samples = erroneous();
    assert!(samples.len() >= 90, "the samples are gone");
    for_each(&samples, |sample| {
        let bytes = fs::read(sample.folder.join(&sample.file)).unwrap();
        let found = sample.run(&request(&bytes));
        assert_ne!(found.report.items().len(), 0);
        let source = SourceText::decode("", bytes, Encoding::Cp852).unwrap();
        let mut text = String::new();
        if source.text().lines().count() <= LONGEST_SOURCE {
            // Characters that a terminal would not show are escaped.
            let lines = source.text().trim_end_matches('\n').split('\n');
            for line in lines {
                writeln!(text, "| {}", cnc872c::diag::terminal_safe(line)).unwrap();
            }
        }
        for (lang, name) in [(Lang::En, "en"), (Lang::Cs, "cs")] {
            let (short, human) = (found.text(Format::Short, lang), found.text(Format::Human, lang));
            write!(text, "\n--- {name}, short\n{short}\n--- {name}, human\n{human}").unwrap();
        }
        compare("findings", &sample.name, &text);
    });
}

/// Every file under `snapshots/` is written by a test: of a sample that still exists, or one that a test names.
#[test]
fn no_orphaned_snapshots() {
    let of = |folder: &str, samples: Vec<Sample>| -> BTreeSet<String> {
        samples.into_iter().map(|sample| format!("{folder}/{}.snap", sample.name)).collect()
    };
    let programs = valid().into_iter().filter(|sample| !sample.is_macrocycle()).collect();
    let mut known = of("streams", programs);
    known.append(&mut of("findings", erroneous()));
    let tests: String = ["tests", "src"]
        .iter()
        .flat_map(|folder| files(&root().join(folder)))
        .filter(|path| path.extension().is_some_and(|extension| extension == "rs"))
        .map(|path| fs::read_to_string(path).unwrap())
        .collect();
    let folder = root().join("snapshots");
    let mut found = BTreeSet::new();
    for path in files(&folder) {
        let name = path.strip_prefix(&folder).unwrap().to_str().unwrap().replace('\\', "/");
        let stem = path.file_stem().unwrap().to_str().unwrap();
        let named =
            !name.starts_with("streams/") && !name.starts_with("findings/") && tests.contains(&format!("\"{stem}\""));
        assert!(known.contains(&name) || named, "snapshots/{name} is written by no test: delete it");
        found.insert(name);
    }
    let missing: Vec<&String> = known.difference(&found).collect();
    assert!(missing.is_empty(), "no snapshots: {missing:?}; write them with INSTA_UPDATE=always cargo test --test it");
}
