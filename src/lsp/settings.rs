//! The settings of the client: an object whose keys are named as in the project file, over which they win.

use std::path::{Path, PathBuf};

use clap::ValueEnum;
use serde_json::{Map, Value};

use crate::config::{Level, Overrides, parse_parameter};
use crate::diag::Code;
use crate::dict::Lang;
use crate::text::Encoding;

/// The section of the client's configuration.
pub(super) const SECTION: &str = "cnc872c";

/// What the client's settings say.
#[derive(Clone, Debug, Default)]
pub(super) struct ClientSettings {
    /// `language`; `None` for `auto`.
    pub(super) lang: Option<Lang>,
    /// The rest.
    pub(super) overrides: Overrides,
}

/// Reads the settings. Folders and files in them are relative to `folder`, the root of the workspace. Values that cannot
/// be used are left out, and named in what comes with the settings.
pub(super) fn read(settings: &Value, folder: &Path) -> (ClientSettings, Vec<String>) {
    let mut reader = Reader { folder, result: ClientSettings::default(), wrong: Vec::new() };
    if let Value::Object(object) = settings {
        reader.object(object, "");
    }
    (reader.result, reader.wrong)
}

struct Reader<'a> {
    folder: &'a Path,
    result: ClientSettings,
    wrong: Vec<String>,
}

impl Reader<'_> {
    fn object(&mut self, object: &Map<String, Value>, before: &str) {
        for (key, value) in object {
            let key = format!("{before}{key}");
            if !value.is_null() && !self.value(&key, value) {
                self.wrong.push(format!("{SECTION}.{key}: {value}"));
            }
        }
    }

    /// Takes the value of a key; whether it could be taken. Keys of others (the extension's own) are left alone.
    fn value(&mut self, key: &str, value: &Value) -> bool {
        let overrides = &mut self.result.overrides;
        match key {
            "language" => match value.as_str() {
                Some("auto" | "") => self.result.lang = None,
                Some(name) => match Lang::from_str(name, true) {
                    Ok(lang) => self.result.lang = Some(lang),
                    Err(_) => return false,
                },
                None => return false,
            },
            "dialect" => return named(value, &mut overrides.dialect),
            "encoding" => return named::<Encoding>(value, &mut overrides.encoding),
            "block-skip" => return flag(value, &mut overrides.block_skip),
            "optional-stop" => return flag(value, &mut overrides.optional_stop),
            "channel-config" => match value.as_str() {
                Some("") => {}
                Some(path) => overrides.channel_config = Some(self.folder.join(path)),
                None => return false,
            },
            "macrocycles" => match value.as_array() {
                Some(folders) => {
                    overrides.macrocycles =
                        folders.iter().filter_map(Value::as_str).map(|f| self.folder.join(f)).collect();
                    return overrides.macrocycles.len() == folders.len();
                }
                None => return false,
            },
            "limits" => {
                if let Value::Object(limits) = value {
                    self.object(limits, "limits.");
                }
            }
            "limits.records" => match value.as_u64() {
                Some(records) if records > 0 => overrides.max_blocks = Some(records),
                _ => return false,
            },
            "parameters" => return self.parameters(value),
            "lints" => return self.lints(value),
            _ => {}
        }
        true
    }

    fn parameters(&mut self, value: &Value) -> bool {
        let Value::Object(parameters) = value else { return false };
        let mut good = true;
        for (name, value) in parameters {
            let value = value.as_str().map_or_else(|| value.to_string(), str::to_owned);
            match parse_parameter(&format!("{name}={value}")) {
                Ok(parameter) => self.result.overrides.parameters.push(parameter),
                Err(_) => good = false,
            }
        }
        good
    }

    fn lints(&mut self, value: &Value) -> bool {
        let Value::Object(lints) = value else { return false };
        let mut good = true;
        for (name, level) in lints {
            let code = Code::find(name).filter(|code| code.is_configurable());
            let level = match level.as_str() {
                Some("allow") => Some(Level::Allow),
                Some("warn") => Some(Level::Warn),
                Some("deny") => Some(Level::Deny),
                _ => None,
            };
            match (code, level) {
                (Some(code), Some(level)) => self.result.overrides.lints.push((code, level)),
                _ => good = false,
            }
        }
        good
    }
}

/// A value of a closed set, by its name on the command line; an empty text is no value.
fn named<T: ValueEnum>(value: &Value, place: &mut Option<T>) -> bool {
    match value.as_str() {
        Some("") => true,
        Some(name) => {
            *place = T::from_str(name, true).ok();
            place.is_some()
        }
        None => false,
    }
}

fn flag(value: &Value, place: &mut Option<bool>) -> bool {
    *place = value.as_bool();
    place.is_some()
}

/// The path of a folder's URI.
pub(super) fn folder_path(uri: &Value) -> Option<PathBuf> {
    gen_lsp_types::Uri::parse(uri.as_str()?).ok()?.to_file_path().ok()
}

/// The folders of the workspace that are on the disk.
pub(super) fn workspace_folders(initialize: &Value) -> Vec<PathBuf> {
    let folders: Vec<PathBuf> = initialize
        .get("workspaceFolders")
        .and_then(Value::as_array)
        .into_iter()
        .flatten()
        .filter_map(|folder| folder_path(folder.get("uri")?))
        .collect();
    if folders.is_empty() { initialize.get("rootUri").and_then(folder_path).into_iter().collect() } else { folders }
}

#[cfg(test)]
mod tests {
    use serde_json::json;

    use super::*;
    use crate::dict::Dialect;

    #[test]
    fn every_key() {
        let (settings, wrong) = read(
            &json!({
                "language": "cs", "dialect": "cnc8x6", "encoding": "windows-1250", "block-skip": true,
                "optional-stop": false, "channel-config": "c.xml", "macrocycles": ["m"],
                "limits": {"records": 5}, "parameters": {"R1": 2.5, "R2": "-1"},
                "lints": {"W0211": "allow", "empty-block": "deny"}, "dialect.extra": 1, "trace": {"server": "off"},
                "channel": null,
            }),
            Path::new("/w"),
        );
        assert_eq!(wrong, Vec::<String>::new());
        let overrides = settings.overrides;
        assert_eq!(settings.lang, Some(Lang::Cs));
        assert_eq!(overrides.dialect, Some(Dialect::Cnc8x6));
        assert_eq!(overrides.encoding, Some(Encoding::Windows1250));
        assert_eq!((overrides.block_skip, overrides.optional_stop), (Some(true), Some(false)));
        assert_eq!(overrides.channel_config, Some(PathBuf::from("/w/c.xml")));
        assert_eq!(overrides.macrocycles, [PathBuf::from("/w/m")]);
        assert_eq!((overrides.max_blocks, overrides.parameters.len(), overrides.lints.len()), (Some(5), 2, 2));
    }

    #[test]
    fn what_cannot_be_used_is_named() {
        let (_, wrong) = read(
            &json!({
                "language": "de", "dialect": "fanuc", "block-skip": 1, "macrocycles": [1], "limits": {"records": -1},
                "parameters": {"R99": 1}, "lints": {"E0101": "allow"}, "channel-config": "", "encoding": null,
            }),
            Path::new("/w"),
        );
        assert_eq!(wrong.len(), 7, "{wrong:?}");
        assert!(wrong.contains(&"cnc872c.limits.records: -1".to_owned()));
    }
}
