//! What an editor and its server share: documents, files of the disk, settings; and what must be found in them.

use std::collections::BTreeMap;
use std::io;
use std::path::{Path, PathBuf};
use std::sync::{Arc, Mutex, PoisonError};

use cnc872c::config::{Level, Overrides, PROJECT_FILE, configure, find_project, parse_parameter};
use cnc872c::diag::{Code, Findings, Report, Severity};
use cnc872c::dict::{Dialect, Lang};
use cnc872c::session::Session;
use cnc872c::text::{ColumnUnit, Loader, MemoryLoader, Sources};
use serde_json::{Value, json};

/// Files that may be open, on the disk, or both: path and URI.
pub const FILES: [(&str, &str); 10] = [
    ("/w/p.nc", "file:///w/p.nc"),
    ("/w/L9001", "file:///w/L9001"),
    ("/w/cnc872c.toml", "file:///w/cnc872c.toml"),
    ("/w/m/L1.MRC", "file:///w/m/L1.MRC"),
    ("/w/channel.xml", "file:///w/channel.xml"),
    ("/w/q.nc", "file:///w/q.nc"),
    ("/w/L9002.NC", "file:///w/L9002.NC"),
    ("/w/s/cnc872c.toml", "file:///w/s/cnc872c.toml"),
    ("/w/s/č s.nc", "file:///w/s/%C4%8D%20s.nc"),
    ("Untitled-1", "untitled:Untitled-1"),
];

/// The path of a file as the server knows it: a document that is no file is in the root of the workspace.
pub fn path(file: usize, rooted: bool) -> PathBuf {
    let path = Path::new(FILES[file].0);
    if rooted { Path::new("/w").join(path) } else { path.to_path_buf() }
}

/// Files of the disk, which change.
#[derive(Default)]
pub struct Disk(Mutex<Arc<MemoryLoader>>, Mutex<BTreeMap<PathBuf, Vec<u8>>>);

impl Disk {
    /// A small project, which no program can run for long in.
    pub fn new() -> Self {
        let disk = Self::default();
        disk.set(Path::new("/cnc872c.toml"), Some("[limits]\nrecords = 300\n".into()));
        disk.set(Path::new("/w/cnc872c.toml"), Some(format!("{}[limits]\nrecords = 300\n", crate::PROJECT).into()));
        disk.set(Path::new("/w/p.nc"), Some("%1\nN1 G79 L9001\nN2 M30\n".into()));
        disk.set(Path::new("/w/L9001"), Some("N1 G79 L9001\nN2 X1,5\nN3 G70\n".into()));
        disk.set(Path::new("/w/m/L1.MRC"), Some("N1 G79 L1\nN2 R1=R2\nN3 G70\n".into()));
        disk
    }

    /// Writes a file, or takes it away.
    pub fn set(&self, path: &Path, bytes: Option<Vec<u8>>) {
        let mut files = self.1.lock().unwrap_or_else(PoisonError::into_inner);
        match bytes {
            Some(bytes) => files.insert(path.to_path_buf(), bytes),
            None => files.remove(path),
        };
        let loader = files.iter().fold(MemoryLoader::new(), |loader, (path, bytes)| loader.with(path, bytes.clone()));
        *self.0.lock().unwrap_or_else(PoisonError::into_inner) = Arc::new(loader);
    }

    /// The files at this moment.
    pub fn now(&self) -> Arc<MemoryLoader> {
        Arc::clone(&self.0.lock().unwrap_or_else(PoisonError::into_inner))
    }
}

impl Loader for Disk {
    fn read(&self, path: &Path) -> io::Result<Vec<u8>> {
        self.now().read(path)
    }

    fn list(&self, folder: &Path) -> Vec<PathBuf> {
        self.now().list(folder)
    }

    fn folders(&self, folder: &Path) -> Vec<PathBuf> {
        self.now().folders(folder)
    }

    fn canonical(&self, path: &Path) -> PathBuf {
        path.to_path_buf()
    }
}

/// The settings that a byte encodes: as the client sends them, as the library takes them, and their language.
pub fn settings(bits: u8) -> (Value, Overrides, Option<Lang>) {
    let mut value = json!({ "limits": { "records": 300 } });
    let mut overrides = Overrides { max_blocks: Some(300), ..Overrides::default() };
    match bits & 3 {
        1 => (value["dialect"], overrides.dialect) = (json!("cnc8x6"), Some(Dialect::Cnc8x6)),
        2 => (value["dialect"], overrides.dialect) = (json!("cnc8x9"), Some(Dialect::Cnc8x9)),
        3 => value["dialect"] = json!("none"),
        _ => {}
    }
    let lang = (bits & 4 != 0).then_some(Lang::Cs);
    if lang.is_some() {
        value["language"] = json!("cs");
    }
    if bits & 8 != 0 {
        (value["block-skip"], overrides.block_skip) = (json!(true), Some(true));
    }
    if bits & 16 != 0 {
        value["lints"] = json!({ "W0214": "deny", "W0211": "allow" });
        let code = |name| Code::find(name).expect("a code");
        overrides.lints = vec![(code("W0211"), Level::Allow), (code("W0214"), Level::Deny)];
    }
    if bits & 32 != 0 {
        value["macrocycles"] = json!(["/w/m"]);
        overrides.macrocycles = vec!["/w/m".into()];
    }
    if bits & 64 != 0 {
        value["channel-config"] = json!("/w/channel.xml");
        overrides.channel_config = Some("/w/channel.xml".into());
    }
    if bits & 128 != 0 {
        value["parameters"] = json!({ "R1": 2.5, "R99": 1 });
        overrides.parameters = vec![parse_parameter("R1=2.5").expect("a parameter")];
    }
    (value, overrides, lang)
}

/// Documents of an editor over the files of a disk.
struct Overlay<'a> {
    disk: Arc<MemoryLoader>,
    open: &'a BTreeMap<PathBuf, String>,
}

impl Loader for Overlay<'_> {
    fn read(&self, path: &Path) -> io::Result<Vec<u8>> {
        self.open.get(path).map_or_else(|| self.disk.read(path), |text| Ok(text.clone().into_bytes()))
    }

    fn list(&self, folder: &Path) -> Vec<PathBuf> {
        let mut files = self.disk.list(folder);
        files.extend(self.open.keys().filter(|path| path.parent() == Some(folder)).cloned());
        files.sort();
        files.dedup();
        files
    }

    fn folders(&self, folder: &Path) -> Vec<PathBuf> {
        self.disk.folders(folder)
    }

    fn canonical(&self, path: &Path) -> PathBuf {
        path.to_path_buf()
    }
}

/// A finding as an editor has it: range, code, severity, and how the message begins.
pub type Shown = ([u64; 4], String, u64, String);

/// Whether an open project file has errors: the server goes on with the last configuration that had none.
pub fn is_configuration_faulty(disk: &Disk, open: &BTreeMap<PathBuf, String>, overrides: &Overrides) -> bool {
    let loader = Overlay { disk: disk.now(), open };
    open.keys().filter(|path| path.file_name().is_some_and(|name| name == PROJECT_FILE)).any(|path| {
        let (mut sources, mut findings) = (Sources::new(), Findings::new());
        configure(Some(path), overrides, &loader, &mut sources, &mut findings);
        findings.has_errors()
    })
}

/// The findings in every file from the open documents on, each checked alone. More than one document may lead to the
/// same file.
pub fn expected(
    disk: &Disk,
    open: &BTreeMap<PathBuf, String>,
    overrides: &Overrides,
    unit: ColumnUnit,
    lang: Lang,
) -> BTreeMap<PathBuf, Vec<Vec<Shown>>> {
    let loader = Overlay { disk: disk.now(), open };
    let mut all: BTreeMap<PathBuf, Vec<Vec<Shown>>> = BTreeMap::new();
    for path in open.keys() {
        let mut found: BTreeMap<PathBuf, Vec<Shown>> = BTreeMap::new();
        for (file, shown) in checked(&loader, path, overrides, unit, lang) {
            found.entry(file).or_default().push(shown);
        }
        for (file, found) in found {
            all.entry(file).or_default().push(found);
        }
    }
    all
}

fn checked(
    loader: &Overlay<'_>,
    path: &Path,
    overrides: &Overrides,
    unit: ColumnUnit,
    lang: Lang,
) -> Vec<(PathBuf, Shown)> {
    let project = find_project(path.parent().unwrap_or(Path::new("")), loader);
    let (mut sources, mut findings) = (Sources::new(), Findings::new());
    let settings = configure(project.as_deref(), overrides, loader, &mut sources, &mut findings);
    let mut report = Report::new();
    report.add(&sources, findings);
    let configures = path.file_name().is_some_and(|name| name == PROJECT_FILE)
        || path.extension().is_some_and(|extension| extension == "xml");
    if report.errors() == 0 && !configures {
        let session = Session { loader, settings: &settings, progress: None };
        let outcome = session.check(path, &path.to_string_lossy());
        report.add_program(&outcome.sources, outcome.findings);
    }
    let shown = report.items().map(|item| {
        let at = item.diagnostic.at;
        let source = report.sources().get(at.file).expect("a file of the run");
        let place = |offset| {
            let (line, column) = source.position_of(offset, unit);
            [line as u64, u64::from(column)]
        };
        let ([a, b], [c, d]) = (place(at.span.start), place(at.span.end));
        let severity = match item.severity {
            Severity::Error => 1,
            Severity::Warning => 2,
        };
        let message = item.diagnostic.finding.message(lang);
        (source.name().into(), ([a, b, c, d], item.diagnostic.code().to_string(), severity, message))
    });
    shown.collect()
}

/// The offset of a place that an editor names. Places behind the end of a line are its end, lines behind the last are
/// the end of the text, and a column inside a character is the begin of it.
pub fn offset(text: &str, line: u64, column: u64, unit: ColumnUnit) -> usize {
    let (mut start, mut left) = (0, line);
    while left > 0 {
        let Some(end) = text[start..].find(['\n', '\r']).map(|at| start + at) else { return text.len() };
        start = end + if text[end..].starts_with("\r\n") { 2 } else { 1 };
        left -= 1;
    }
    let mut passed = 0;
    for (at, character) in text[start..].char_indices() {
        passed += u64::from(unit.width(character));
        if passed > column || matches!(character, '\n' | '\r') {
            return start + at;
        }
    }
    text.len()
}

/// Whether an editor can name `offset` so.
pub fn is_exact(text: &str, line: u64, column: u64, unit: ColumnUnit) -> bool {
    let offset = offset(text, line, column, unit);
    let before = &text[..offset];
    let lines = before.matches('\n').count() + before.matches('\r').count() - before.matches("\r\n").count();
    let start = before.rfind(['\n', '\r']).map_or(0, |at| at + 1);
    lines as u64 == line && u64::from(unit.count(&before[start..])) == column
}
