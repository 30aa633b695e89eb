//! The configuration of a run: project file, ChannelConfig and command line put together.

use std::io::{self, ErrorKind};
use std::path::{Component, Path, PathBuf};

use super::draft::Draft;
use super::motion::From;
use super::motion_constants::is_digits;
use super::motion_values::assemble;
use super::reader::read;
use super::{Axes, MFunctions, Overrides, Purpose, Settings, SpindleAxis, channel, constants};
use crate::diag::{ConfigNeed, ConfigProblem, Diagnostic, Finding, Findings, terminal_safe};
use crate::dict::{AxisLetter, Dialect, MOMENTARY_GROUPS};
use crate::sure::small;
use crate::text::{
    BrokenLink, DecodeError, Encoding, Loader, Location, NotUtf8, SourceText, Sources, Span, without_ways_back,
};

/// Puts the settings of a run together: the defaults, over them the project file (when there is one), over that what
/// the command line says, value by value (§11, §13 Configuration).
///
/// The files read join `sources` under the names by which they were reached; paths in the project file are relative to
/// its folder. What is wrong joins `findings` at its place: E0701 for what cannot be read, E0702–E0706 for values,
/// W0705 for unknown names. They get the levels of the run. A wrong value leaves the default in force; when `findings`
/// then has an error, the run must end with status 2 before any program is read.
pub fn configure(
    project: Option<&Path>,
    overrides: &Overrides,
    loader: &dyn Loader,
    sources: &mut Sources,
    findings: &mut Findings,
) -> Settings {
    let mut draft = Draft::new(overrides.dialect);
    let mut files = Files { loader, sources, findings };
    if let Some(path) = project {
        files.project(path, &mut draft);
    }
    let folder = project.and_then(Path::parent).unwrap_or(Path::new(""));
    files.macrocycles(&mut draft, folder, overrides);
    draft.settings.arguments = overrides.arguments();
    override_settings(&mut draft.settings, overrides);
    files.findings.set_levels(draft.settings.levels(Purpose::Check));
    if !draft.axes.is_empty() {
        draft.settings.machine.axes = Axes::new(draft.axes.iter().map(|(axis, _)| *axis));
    }
    draft.settings.machine.gears.sort_by_key(|gear| gear.m);
    check_machine(&draft, files.findings);
    if !draft.dialect_is_unusable || overrides.dialect.is_some() {
        let dialect = draft.settings.machine.dialect;
        check_dialect(&draft, dialect, files.findings);
        if !dialect.has_channel_config() {
            constants::apply(&draft.constants, &mut draft.settings.machine.m_functions, files.findings);
        }
        files.tried(&overrides.motion, &mut draft);
        assemble(&mut draft, dialect, overrides.computes_motion, files.findings);
        files.channel_config(&mut draft, folder, overrides);
        set_m_power_up(&mut draft, files.findings);
    }
    draft.settings
}

/// Puts what the command line says over the settings of the project file, but for what names files and motion.
fn override_settings(settings: &mut Settings, overrides: &Overrides) {
    settings.encoding = overrides.encoding.unwrap_or(settings.encoding);
    settings.block_skip = overrides.block_skip.unwrap_or(settings.block_skip);
    settings.optional_stop = overrides.optional_stop.unwrap_or(settings.optional_stop);
    settings.lints.extend(overrides.lints.iter().copied().filter(|(code, _)| code.is_configurable()));
    settings.machine.parameters.extend(overrides.parameters.iter().copied());
    let limits = &mut settings.machine.limits;
    limits.records = overrides.max_blocks.unwrap_or(limits.records);
}

/// `name` in `folder`, without the parts that lead nowhere, and without those that lead back where that is the same
/// place (it is not behind a link): `q/../m` is `m`, so that one file has one name.
fn join(folder: &Path, name: &str, loader: &dyn Loader) -> PathBuf {
    let path: PathBuf = folder.join(name).components().filter(|part| *part != Component::CurDir).collect();
    let short = without_ways_back(&path);
    let same = !short.as_os_str().is_empty() && loader.canonical(&short) == loader.canonical(&path);
    if same { short } else { path }
}

/// Reports a value of the project file that does not fit the others (E0702).
fn misfit(findings: &mut Findings, key: impl Into<String>, at: Location, needs: ConfigNeed) {
    findings.add(Diagnostic::new(Finding::ConfigurationValue { key: key.into(), needs }, at));
}

/// Values that must fit one another on any control (§13): letters of axes, ends of gears.
fn check_machine(draft: &Draft, findings: &mut Findings) {
    let machine = &draft.settings.machine;
    let mut letters: Vec<(AxisLetter, String, Location)> = Vec::new();
    let mut named = |path: &str, letter: AxisLetter, is_key: bool| {
        let place = draft.places.get(path);
        letters.extend(place.map(|place| (letter, path.to_owned(), if is_key { place.key } else { place.at })));
    };
    if let SpindleAxis::Letter(letter) = machine.spindle_axis {
        named("spindle-axis", letter, false);
    }
    if let Some(letter) = machine.tool_axis {
        named("restart.tool-axis", letter, false);
    }
    for letter in machine.start.keys() {
        named(&format!("start.{letter}"), *letter, true);
    }
    let moved = draft.moved_axes.iter();
    letters.extend(moved.map(|(l, letter, at)| (*letter, format!("machine-macrocycles.L{l}.axes"), *at)));
    for (letter, key, at) in letters.into_iter().filter(|(letter, ..)| machine.axes.index(*letter).is_none()) {
        let needs = ConfigNeed::NoSuchAxis { letter: letter.name().to_owned(), axes: machine.axes.letters() };
        misfit(findings, key, at, needs);
    }
}

/// M functions at power-up, by the groups of the whole configuration (MFN-7).
fn set_m_power_up(draft: &mut Draft, findings: &mut Findings) {
    let machine = &mut draft.settings.machine;
    for &(group, number, at) in &draft.m_power_up {
        let key = || format!("power-up.M{group}");
        if MOMENTARY_GROUPS.contains(&group) {
            misfit(findings, key(), at, ConfigNeed::BlockOnly { group });
        } else if machine.m_functions.group(number) != group || number > machine.dialect.highest_m() {
            misfit(findings, key(), at, ConfigNeed::MOfGroup { group });
        } else if let Some(slot) = machine.m_power_up.get_mut(usize::from(group)) {
            *slot = Some(number);
        }
    }
}

/// Reports values of the file that the control of the run does not have (§13 Configuration).
fn check_dialect(draft: &Draft, dialect: Dialect, findings: &mut Findings) {
    if let Some((_, place)) = draft.axes.get(dialect.axes()) {
        misfit(findings, "axes", place.key, ConfigNeed::TooManyAxes { limit: dialect.axes() });
    }
    let extra: Vec<_> = draft.axes.iter().filter(|(axis, _)| !axis.letter.is_of_the_planes()).collect();
    if let Some((sixth, place)) = extra.get(2)
        && !dialect.takes_sixth_axis(sixth.letter)
    {
        misfit(findings, "axes.letter", place.at, ConfigNeed::SixthAxis { letter: sixth.letter.to_string() });
    }
    // Of more axes than the control has, the finding above is enough.
    let has_room = draft.axes.len() <= dialect.axes() && dialect.axes() < AxisLetter::ALL.len();
    if let Some((fourth, place)) = extra.get(3).filter(|_| has_room) {
        misfit(findings, "axes.letter", place.at, ConfigNeed::FourthBeside { letter: fourth.letter.to_string() });
    }
    if dialect.has_channel_config() {
        for constant in draft.constants.iter().filter(|constant| constants::group_of(constant.number).is_some()) {
            let key = format!("machine-constants.R{}", constant.number);
            misfit(findings, key, constant.place.key, ConfigNeed::NotForDialect { dialect: dialect.name().to_owned() });
        }
    }
}

/// The files of a configuration.
struct Files<'a> {
    loader: &'a dyn Loader,
    sources: &'a mut Sources,
    findings: &'a mut Findings,
}

impl Files<'_> {
    /// Reads the project file into the draft; nothing when it cannot be read: E0701 at the first byte that is not
    /// UTF-8, else at an empty text of its name. Files that are not in UTF-8 come from Windows, as a rule.
    fn project(&mut self, path: &Path, draft: &mut Draft) {
        let (reason, at) = match self.load(path, Encoding::Windows1250) {
            Ok(source) if source.encoding() == Encoding::Utf8 => return self.read(source, From::Key, draft),
            Ok(source) => self.not_utf_8(source),
            Err(reason) => (reason, self.nowhere(path.display().to_string())),
        };
        self.findings.add(Diagnostic::new(Finding::UnreadableConfiguration { reason }, at));
    }

    /// TOML is UTF-8 and nothing else.
    fn not_utf_8(&mut self, source: SourceText) -> (ConfigProblem, Location) {
        if source.encoding().is_utf16() {
            return (ConfigProblem::Utf16, self.nowhere(source.name().to_owned()));
        }
        // In a code page each character is a byte.
        let bytes = source.encoding().encode(source.text());
        let first = std::str::from_utf8(&bytes).err().map_or(0, |error| error.valid_up_to());
        let byte = bytes.get(first).copied().unwrap_or_default();
        let mut from = source.text().char_indices().skip(first).map(|(at, _)| small(at));
        let span = Span::new(from.next().unwrap_or(source.len()), from.next().unwrap_or(source.len()));
        let line = source.lines().line_at(span.start) + 1;
        let reason = not_utf_8(NotUtf8 { line, byte });
        drop(bytes);
        let file = self.sources.add(source);
        (reason, Location { file, span })
    }

    fn read(&mut self, source: SourceText, from: From, draft: &mut Draft) {
        let file = self.sources.add(source);
        if let Some(source) = self.sources.get(file) {
            read(draft, from, source, file, self.findings);
        }
    }

    /// Sets the folders of macrocycles; those of the project file that are none are reported (E0702, each at its
    /// place).
    fn macrocycles(&mut self, draft: &mut Draft, folder: &Path, overrides: &Overrides) {
        draft.settings.macrocycles.clone_from(&overrides.macrocycles);
        if !overrides.macrocycles.is_empty() {
            return;
        }
        for (name, at) in &draft.macrocycles {
            let folder = join(folder, name, self.loader);
            if !self.loader.is_folder(&folder) {
                let name = terminal_safe(&folder.display().to_string()).into_owned();
                misfit(self.findings, "macrocycles", *at, ConfigNeed::Folder { name });
            }
            draft.settings.macrocycles.push(folder);
        }
    }

    /// Puts what `--set` says over `[motion]` and the machine constants of the project file.
    fn tried(&mut self, values: &[(String, String)], draft: &mut Draft) {
        if !values.is_empty() {
            self.read(SourceText::from_text("--set", set_text(values)), From::Set, draft);
        }
    }

    /// Sets the M functions of the ChannelConfig that the command line names, or else the project file.
    fn channel_config(&mut self, draft: &mut Draft, folder: &Path, overrides: &Overrides) {
        let dialect = draft.settings.machine.dialect;
        let (path, named) = match (&overrides.channel_config, &draft.channel_config) {
            (Some(path), _) => (path.clone(), None),
            (None, Some((name, place))) => (join(folder, name, self.loader), Some(*place)),
            (None, None) => return,
        };
        if dialect.has_channel_config() {
            return self.m_functions(&path, named.map(|place| place.at), &mut draft.settings);
        }
        let (key, at) = match named {
            Some(place) => ("channel-config", place.key),
            None => ("--channel-config", self.nowhere(path.display().to_string())),
        };
        misfit(self.findings, key, at, ConfigNeed::NotForDialect { dialect: dialect.name().to_owned() });
    }

    /// Reads the ChannelConfig at `path`, which `named` names; when it cannot be read, E0701 there, or at an empty text
    /// of its name when the command line names it.
    fn m_functions(&mut self, path: &Path, named: Option<Location>, settings: &mut Settings) {
        match self.load(path, settings.encoding) {
            Ok(source) => {
                let file = self.sources.add(source);
                let functions: &mut MFunctions = &mut settings.machine.m_functions;
                if let Some(source) = self.sources.get(file) {
                    channel::read(source, file, functions, self.findings);
                }
            }
            Err(reason) => {
                let at = named.unwrap_or_else(|| self.nowhere(path.display().to_string()));
                self.findings.add(Diagnostic::new(Finding::UnreadableConfiguration { reason }, at));
            }
        }
    }

    /// An empty place in an empty text of that name.
    fn nowhere(&mut self, name: String) -> Location {
        let file = self.sources.find(&name).unwrap_or_else(|| self.sources.add(SourceText::from_text(name, "")));
        Location { file, span: Span::default() }
    }

    fn load(&self, path: &Path, fallback: Encoding) -> Result<SourceText, ConfigProblem> {
        let name = path.display().to_string();
        let bytes = self.loader.read(path).map_err(|error| unread(&name, &error))?;
        if bytes.starts_with(&[0xff, 0xfe]) || bytes.starts_with(&[0xfe, 0xff]) {
            return Err(ConfigProblem::Utf16);
        }
        let encoding = declared_encoding(&bytes).unwrap_or(fallback);
        SourceText::decode(name, bytes, encoding).map_err(|error| match error {
            DecodeError::TooLarge => ConfigProblem::TooLarge,
            DecodeError::NotUtf8(byte) => not_utf_8(byte),
        })
    }
}

/// What `--set` says, as a project file: a line each, so that places count the options.
fn set_text(values: &[(String, String)]) -> String {
    let mut text = String::new();
    for (key, value) in values {
        let constant: Option<u16> = key.strip_prefix('R').and_then(|number| number.parse().ok());
        let is_text = constant.is_some_and(|number| is_digits(number, value));
        let is_value = !is_text && value.parse::<toml_edit::Value>().is_ok();
        let value = if is_value { value.clone() } else { toml_edit::Value::from(value.as_str()).to_string() };
        let table = if constant.is_some() { "machine-constants" } else { "motion" };
        text.push_str(&format!("{table}.{key} = {value}\n"));
    }
    text
}

fn not_utf_8(NotUtf8 { line, byte }: NotUtf8) -> ConfigProblem {
    ConfigProblem::NotUtf8 { line, byte: format!("{byte:02X}h") }
}

/// Why the file of that name cannot be read.
fn unread(name: &str, error: &io::Error) -> ConfigProblem {
    let name = terminal_safe(name).into_owned();
    let kind = error.kind();
    if matches!(kind, ErrorKind::NotFound | ErrorKind::NotADirectory) {
        ConfigProblem::NotFound { name }
    } else if kind == ErrorKind::PermissionDenied {
        ConfigProblem::Denied { name }
    } else if kind == ErrorKind::IsADirectory {
        ConfigProblem::Directory { name }
    } else if kind == ErrorKind::Unsupported {
        ConfigProblem::NotAFile { name }
    } else if kind == ErrorKind::FileTooLarge {
        ConfigProblem::TooLarge
    } else if BrokenLink::is(error) {
        ConfigProblem::Link { name }
    } else {
        ConfigProblem::File { problem: format!("{name}: {}", terminal_safe(&error.to_string())) }
    }
}

/// The code page that an XML declaration names, when it is one of ours.
fn declared_encoding(bytes: &[u8]) -> Option<Encoding> {
    const LONGEST: usize = 200;
    let start = bytes.get(..LONGEST.min(bytes.len()))?;
    let text: String = start.iter().map(|&byte| char::from(byte)).collect();
    let declaration = text.strip_prefix("<?xml")?.split_once("?>")?.0;
    let value = declaration.split_once("encoding")?.1.trim_start().strip_prefix('=')?.trim_start();
    let name = value.split(['"', '\'']).nth(1)?.to_ascii_lowercase();
    match name.as_str() {
        "windows-1250" | "cp1250" => Some(Encoding::Windows1250),
        "iso-8859-2" | "iso8859-2" | "latin2" => Some(Encoding::Iso88592),
        "cp852" | "ibm852" => Some(Encoding::Cp852),
        _ => None,
    }
}
