//! The configuration of a run: project file, ChannelConfig and command line put together.

use std::io::{self, ErrorKind};
use std::path::{Component, Path, PathBuf};

use super::motion_constants::is_digits;
use super::motion_values::{Layer, assemble};
use super::project::{Project, Texts, letter};
use super::taken::Setting;
use super::{
    Axes, MFunctions, Machine, MayMove, Motion, Overrides, Purpose, Settings, SpindleAxis, channel, constants,
};
use crate::diag::{ConfigNeed, ConfigProblem, Diagnostic, Finding, Findings, terminal_safe};
use crate::dict::{AxisLetter, Dialect, MOMENTARY_GROUPS};
use crate::text::{
    BrokenLink, DecodeError, Encoding, FileId, Loader, Location, SourceText, Sources, Span, without_ways_back,
};

/// Puts the settings of a run together: the defaults, over them the project file (when there is one), over that what the
/// command line says, value by value (§11, §13 Configuration).
///
/// The files read join `sources` under the names by which they were reached; paths in the project file are relative to
/// its folder. What is wrong joins `findings` at its place: E0701 for what cannot be read, E0702–E0706 for values, W0705
/// for unknown names. They get the levels of the run. A wrong value leaves the default in force; when `findings` then has
/// an error, the run must end with status 2 before any program is read.
pub fn configure(
    project: Option<&Path>,
    overrides: &Overrides,
    loader: &dyn Loader,
    sources: &mut Sources,
    findings: &mut Findings,
) -> Settings {
    let fallback = overrides.encoding.unwrap_or_default();
    let mut files = Files { loader, sources, findings };
    let (values, file) = project.map_or_else(Default::default, |path| files.project(path, fallback));
    let dialect = overrides.dialect.or(value(values.dialect)).unwrap_or_default();
    let known = overrides.dialect.is_some() || !values.dialect_unusable;
    let mut settings = Settings::new(dialect);
    settings.encoding = overrides.encoding.or(value(values.encoding)).unwrap_or_default();
    settings.block_skip = overrides.block_skip.or(value(values.block_skip)).unwrap_or(false);
    settings.optional_stop = overrides.optional_stop.or(value(values.optional_stop)).unwrap_or(false);
    let folder = project.and_then(Path::parent).unwrap_or(Path::new(""));
    settings.macrocycles = if overrides.macrocycles.is_empty() {
        let named = values.macrocycles.iter().flat_map(|list| &list.value);
        let folders: Vec<_> = named.map(|(name, at)| (join(folder, name, files.loader), *at)).collect();
        files.check_folders(&folders, file);
        folders.into_iter().map(|(folder, _)| folder).collect()
    } else {
        overrides.macrocycles.clone()
    };
    let lints = values.lints.iter().map(|lint| lint.value).chain(overrides.lints.iter().copied());
    settings.format = values.format;
    settings.lints = lints.filter(|(code, _)| code.is_configurable()).collect();
    files.findings.set_levels(settings.levels(Purpose::Check));
    if let Some(extensions) = &values.extensions {
        settings.extensions = extensions.value.iter().map(|(name, _)| name.to_ascii_lowercase()).collect();
    }
    set_machine(&mut settings.machine, &values, overrides);
    check_machine(&settings.machine, &values, file, files.findings);
    if known {
        check_dialect(&values, file, dialect, files.findings);
        if !dialect.has_channel_config() {
            let text = files.sources.get(file).map_or("", |source| source.text());
            constants::apply(&values.constants, (file, text), &mut settings.machine.m_functions, files.findings);
        }
        settings.machine.motion = files.motion(&values, file, dialect, overrides);
        files.channel_config(&values, file, folder, overrides, &mut settings);
        set_m_power_up(&mut settings.machine, &values, file, files.findings);
    }
    settings
}

fn value<T>(setting: Option<Setting<T>>) -> Option<T> {
    setting.map(|setting| setting.value)
}

/// `name` in `folder`, without the parts that lead nowhere, and without those that lead back where that is the same place
/// (it is not behind a link): `q/../m` is `m`, so that one file has one name.
fn join(folder: &Path, name: &str, loader: &dyn Loader) -> PathBuf {
    let path: PathBuf = folder.join(name).components().filter(|part| *part != Component::CurDir).collect();
    let short = without_ways_back(&path);
    let same = !short.as_os_str().is_empty() && loader.canonical(&short) == loader.canonical(&path);
    if same { short } else { path }
}

/// What the machine is, M functions excepted.
fn set_machine(machine: &mut Machine, values: &Project, overrides: &Overrides) {
    if !values.axes.is_empty() {
        machine.axes = Axes::new(values.axes.iter().map(|axis| axis.value));
    }
    for function in &values.power_up {
        if let Some(slot) = machine.power_up.get_mut(function.value.group().index()) {
            *slot = Some(function.value);
        }
    }
    machine.parameters =
        values.parameters.iter().map(|r| r.value).chain(overrides.parameters.iter().copied()).collect();
    machine.operations = values.operations.iter().map(|operation| operation.value).collect();
    machine.cycles = values.cycles.iter().map(|cycle| cycle.value).collect();
    machine.macrocycles =
        values.machine_macrocycles.iter().map(|(number, axes)| (*number, may_move(axes.as_ref()))).collect();
    machine.gears = values.gears.iter().map(|gear| gear.value).collect();
    machine.gears.sort_by_key(|gear| gear.m);
    let without_plus = |digits: &str| digits.strip_prefix('+').unwrap_or(digits).to_owned();
    let constants = values.constants.iter().map(|constant| (constant.value.0, without_plus(&constant.value.1)));
    machine.constants = constants.collect();
    machine.corrections = values.corrections.iter().map(|correction| correction.value).collect();
    machine.start = values.start.iter().map(|position| position.value).collect();
    machine.oriented_stop = value(values.oriented_stop).unwrap_or(machine.oriented_stop);
    machine.tool_axis = value(values.tool_axis);
    machine.spindle_axis = value(values.spindle_axis).unwrap_or(machine.spindle_axis);
    machine.oriented_position = value(values.oriented_position).unwrap_or(machine.oriented_position);
    machine.g97 = value(values.g97).unwrap_or(machine.g97);
    machine.arc_centers = value(values.arc_centers).unwrap_or(machine.arc_centers);
    let limits = &mut machine.limits;
    limits.records = overrides.max_blocks.or(value(values.records)).unwrap_or(limits.records);
    limits.nesting = value(values.nesting).unwrap_or(limits.nesting);
    limits.feed = value(values.feed).unwrap_or(limits.feed);
    limits.speed = value(values.speed).unwrap_or(limits.speed);
    limits.arc_tolerance = value(values.arc_tolerance).unwrap_or(limits.arc_tolerance);
}

/// The axes that a macrocycle of the machine may move: any, unless they are listed.
fn may_move(axes: Option<&Texts>) -> MayMove {
    match axes {
        None => MayMove::All,
        Some(axes) => MayMove::Only(axes.value.iter().filter_map(|(name, _)| letter(name)).collect()),
    }
}

/// Reports a value of the project file that does not fit the others (E0702).
fn misfit(findings: &mut Findings, file: FileId, key: impl Into<String>, span: Span, needs: ConfigNeed) {
    let finding = Finding::ConfigurationValue { key: key.into(), needs };
    findings.add(Diagnostic::new(finding, Location { file, span }));
}

/// Values that must fit one another on any control (§13): letters of axes, ends of gears.
fn check_machine(machine: &Machine, values: &Project, file: FileId, findings: &mut Findings) {
    let missing = |letter| {
        let needs =
            ConfigNeed::NoSuchAxis { letter: String::from(AxisLetter::name(letter)), axes: machine.axes.letters() };
        machine.axes.index(letter).is_none().then_some(needs)
    };
    if let Some(setting) = values.spindle_axis
        && let SpindleAxis::Letter(letter) = setting.value
        && let Some(needs) = missing(letter)
    {
        misfit(findings, file, "spindle-axis", setting.at, needs);
    }
    if let Some(setting) = values.tool_axis
        && let Some(needs) = missing(setting.value)
    {
        misfit(findings, file, "restart.tool-axis", setting.at, needs);
    }
    for setting in &values.start {
        if let Some(needs) = missing(setting.value.0) {
            misfit(findings, file, format!("start.{}", setting.value.0), setting.key, needs);
        }
    }
    for (number, axes) in &values.machine_macrocycles {
        for (name, at) in axes.iter().flat_map(|axes| &axes.value) {
            if let Some(needs) = letter(name).and_then(missing) {
                misfit(findings, file, format!("machine-macrocycles.L{number}.axes"), *at, needs);
            }
        }
    }
    for (key, end) in &values.gear_ends {
        if let Some(end) = end
            && end.value > machine.limits.speed
        {
            let needs = ConfigNeed::Whole { min: 0, max: i64::from(machine.limits.speed) };
            misfit(findings, file, format!("gears.{key}"), end.at, needs);
        }
    }
}

/// M functions at power-up, by the groups of the whole configuration (MFN-7).
fn set_m_power_up(machine: &mut Machine, values: &Project, file: FileId, findings: &mut Findings) {
    for setting in &values.m_power_up {
        let (group, number) = setting.value;
        let key = || format!("power-up.M{group}");
        if MOMENTARY_GROUPS.contains(&group) {
            misfit(findings, file, key(), setting.at, ConfigNeed::BlockOnly { group });
        } else if machine.m_functions.group(number) != group || number > machine.dialect.highest_m() {
            misfit(findings, file, key(), setting.at, ConfigNeed::MOfGroup { group });
        } else if let Some(slot) = machine.m_power_up.get_mut(usize::from(group)) {
            *slot = Some(number);
        }
    }
}

/// What the file says and the control of the run does not have (§13 Configuration).
fn check_dialect(values: &Project, file: FileId, dialect: Dialect, findings: &mut Findings) {
    if let Some(axis) = values.axes.get(dialect.axes()) {
        misfit(findings, file, "axes", axis.key, ConfigNeed::TooManyAxes { limit: dialect.axes() });
    }
    let extra: Vec<_> = values.axes.iter().filter(|axis| !axis.value.letter.is_of_the_planes()).collect();
    if let Some(sixth) = extra.get(2)
        && !dialect.takes_sixth_axis(sixth.value.letter)
    {
        let letter = sixth.value.letter.to_string();
        misfit(findings, file, "axes.letter", sixth.at, ConfigNeed::SixthAxis { letter });
    }
    // Of more axes than the control has, the finding above is enough.
    let has_room = values.axes.len() <= dialect.axes() && dialect.axes() < AxisLetter::ALL.len();
    if let Some(fourth) = extra.get(3).filter(|_| has_room) {
        let letter = fourth.value.letter.to_string();
        misfit(findings, file, "axes.letter", fourth.at, ConfigNeed::FourthBeside { letter });
    }
    if dialect.has_channel_config() {
        for constant in &values.constants {
            let number = constant.value.0;
            if constants::group_of(number).is_some() {
                let needs = ConfigNeed::NotForDialect { dialect: dialect.name().to_owned() };
                misfit(findings, file, format!("machine-constants.R{number}"), constant.key, needs);
            }
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
    /// The values of the project file; none when it cannot be read (E0701, at an empty text of its name).
    fn project(&mut self, path: &Path, fallback: Encoding) -> (Project, FileId) {
        let name = path.display().to_string();
        match self.load(path, fallback).and_then(in_utf_8) {
            Ok(source) => {
                let file = self.sources.add(source);
                let Some(source) = self.sources.get(file) else {
                    return (Project::default(), file);
                };
                (Project::read(source, file, self.findings), file)
            }
            Err(reason) => {
                let at = self.nowhere(name);
                self.findings.add(Diagnostic::new(Finding::UnreadableConfiguration { reason }, at));
                (Project::default(), at.file)
            }
        }
    }

    /// Reports folders of `macrocycles` that are none (E0702, each at its place).
    fn check_folders(&mut self, folders: &[(PathBuf, Span)], file: FileId) {
        for (folder, at) in folders {
            if !self.loader.is_folder(folder) {
                let name = terminal_safe(&folder.display().to_string()).into_owned();
                misfit(self.findings, file, "macrocycles", *at, ConfigNeed::Folder { name });
            }
        }
    }

    /// What motion is computed with: the project file, over it what `--set` says.
    fn motion(&mut self, values: &Project, file: FileId, dialect: Dialect, overrides: &Overrides) -> Motion {
        let text =
            |files: &Self, file: FileId| files.sources.get(file).map_or(String::new(), |file| file.text().to_owned());
        let own = text(self, file);
        let base = Layer { values, file, text: &own };
        let computes = overrides.computes_motion;
        if overrides.motion.is_empty() {
            return assemble(&[base], dialect, computes, self.findings);
        }
        let set_text = set_text(&overrides.motion);
        let source = SourceText::from_text("--set", &set_text);
        let set_file = self.sources.add(source);
        let Some(source) = self.sources.get(set_file) else {
            return assemble(&[base], dialect, computes, self.findings);
        };
        let set_values = Project::read(source, set_file, self.findings);
        let set = Layer { values: &set_values, file: set_file, text: &set_text };
        assemble(&[base, set], dialect, computes, self.findings)
    }

    /// Sets the M functions of the ChannelConfig that the command line names, or else the project file `file`.
    fn channel_config(
        &mut self,
        values: &Project,
        file: FileId,
        folder: &Path,
        overrides: &Overrides,
        settings: &mut Settings,
    ) {
        let dialect = settings.machine.dialect;
        let (path, option) = match (&overrides.channel_config, &values.channel_config) {
            (Some(path), _) => (path.clone(), None),
            (None, Some(named)) => (join(folder, &named.value, self.loader), Some(named)),
            (None, None) => return,
        };
        if !dialect.has_channel_config() {
            let (key, at) = match option {
                Some(named) => ("channel-config", Location { file, span: named.key }),
                None => ("--channel-config", self.nowhere(path.display().to_string())),
            };
            let needs = ConfigNeed::NotForDialect { dialect: dialect.name().to_owned() };
            let finding = Finding::ConfigurationValue { key: key.to_owned(), needs };
            self.findings.add(Diagnostic::new(finding, at));
            return;
        }
        self.m_functions(&path, option.map(|named| Location { file, span: named.at }), settings);
    }

    /// Reads the ChannelConfig at `path`, which `named` names; when it cannot be read, E0701 there, or at an empty text of
    /// its name when the command line names it.
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
            DecodeError::NotUtf8(_) => ConfigProblem::NotUtf8,
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

/// TOML is UTF-8 and nothing else.
fn in_utf_8(source: SourceText) -> Result<SourceText, ConfigProblem> {
    if source.encoding() == Encoding::Utf8 { Ok(source) } else { Err(ConfigProblem::NotUtf8) }
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
