//! The settings of the client: an object whose keys are named as in the project file, over which they win.

use std::path::{Path, PathBuf};

use serde_json::Value;

use crate::config::{Overrides, client_overrides};
use crate::dict::Lang;

/// The section of the client's configuration.
pub(super) const SECTION: &str = "cnc872c";

/// The client's settings.
#[derive(Clone, Debug, Default)]
pub(super) struct ClientSettings {
    /// `language`; `None` for `auto`.
    pub(super) lang: Option<Lang>,
    /// The rest.
    pub(super) overrides: Overrides,
}

/// Reads the settings. Folders and files in them are relative to `folder`, the root of the workspace. Values that
/// cannot be used are left out, and named in what comes with the settings. Keys of others (the extension's own) are
/// left alone.
pub(super) fn read(settings: &Value, folder: &Path) -> (ClientSettings, Vec<String>) {
    let Value::Object(object) = settings else { return (ClientSettings::default(), Vec::new()) };
    let (overrides, mut wrong) = client_overrides(object, folder);
    let mut lang = None;
    if let Some(value) = object.get("language").filter(|value| !value.is_null()) {
        match value.as_str() {
            Some("auto" | "") => {}
            name => {
                lang = name.and_then(Lang::named);
                if lang.is_none() {
                    wrong.push(format!("language: {value}"));
                }
            }
        }
    }
    let wrong = wrong.into_iter().map(|wrong| format!("{SECTION}.{wrong}")).collect();
    (ClientSettings { lang, overrides }, wrong)
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
    use crate::text::Encoding;

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
                "language": "de", "dialect": "fanuc", "block-skip": 1, "macrocycles": [1],
                "limits": {"records": -1, "record": 5, "other": null},
                "parameters": {"R99": 1}, "lints": {"E0101": "allow"}, "channel-config": "", "encoding": null,
            }),
            Path::new("/w"),
        );
        assert_eq!(wrong.len(), 8, "{wrong:?}");
        assert!(wrong.contains(&"cnc872c.limits.records: -1".to_owned()));
        assert!(wrong.contains(&"cnc872c.limits.record: 5".to_owned()));
    }
}
