//! Paths: as text, and the ways back in them.

use std::path::{Component, Path, PathBuf};

/// The path for messages, and as the name of its text: bytes that are no UTF-8, as shares of old systems have them,
/// come as `\\xff`. Two files have two names, so that their findings stay apart.
pub fn path_name(path: &Path) -> String {
    if let Some(name) = path.to_str() {
        return name.to_owned();
    }
    let mut name = String::new();
    for piece in path.as_os_str().as_encoded_bytes().utf8_chunks() {
        name.push_str(piece.valid());
        piece.invalid().iter().for_each(|byte| name.push_str(&format!("\\x{byte:02x}")));
    }
    name
}

/// The last part of a path as text; all of one that has none.
pub fn last_name(path: &Path) -> String {
    path_name(path.file_name().map_or(path, Path::new))
}

/// Whether the path leads back somewhere: `q/../m`.
pub fn has_way_back(path: &Path) -> bool {
    path.components().any(|part| part == Component::ParentDir)
}

/// The way back through a relative path: `../..` for `a/b`.
pub fn way_back(path: &Path) -> PathBuf {
    path.components().map(|_| Component::ParentDir).collect()
}

/// The path without the names that it leads into and back out of: `m` for `q/../m`. Where one of them is a link, that
/// may be another place.
pub fn without_ways_back(path: &Path) -> PathBuf {
    let mut short = PathBuf::new();
    for part in path.components() {
        let back = part == Component::ParentDir && matches!(short.components().next_back(), Some(Component::Normal(_)));
        if back {
            short.pop();
        } else {
            short.push(part);
        }
    }
    short
}

#[cfg(all(test, unix))]
mod tests {
    use std::ffi::OsStr;
    use std::os::unix::ffi::OsStrExt;

    use super::*;

    #[test]
    fn ways_back() {
        for (path, short) in
            [("q/../m", "m"), ("../m", "../m"), ("a/b/../../../m", "../m"), ("/../m", "/../m"), ("a/b", "a/b")]
        {
            assert_eq!(without_ways_back(Path::new(path)), Path::new(short), "{path}");
        }
        assert!(has_way_back(Path::new("a/../b")) && !has_way_back(Path::new("a/..b")));
        assert_eq!(way_back(Path::new("a/b")), Path::new("../.."));
    }

    #[test]
    fn names_stay_apart() {
        let name = |bytes: &[u8]| path_name(Path::new(OsStr::from_bytes(bytes)));
        assert_eq!(name("díly/a.nc".as_bytes()), "díly/a.nc");
        assert_eq!(name(b"m\xff/\xe8.nc"), "m\\xff/\\xe8.nc");
        assert_ne!(name(b"\xff.nc"), name(b"\xfe.nc"));
    }
}
