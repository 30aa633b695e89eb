//! Names of files as text.

use std::path::Path;

/// The path for messages, and as the name of its text: bytes that are no UTF-8, as shares of old systems have them, come as
/// `\\xff`. Two files have two names, so that their findings are told apart.
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

#[cfg(all(test, unix))]
mod tests {
    use std::ffi::OsStr;
    use std::os::unix::ffi::OsStrExt;

    use super::*;

    #[test]
    fn names_stay_apart() {
        let name = |bytes: &[u8]| path_name(Path::new(OsStr::from_bytes(bytes)));
        assert_eq!(name("díly/a.nc".as_bytes()), "díly/a.nc");
        assert_eq!(name(b"m\xff/\xe8.nc"), "m\\xff/\\xe8.nc");
        assert_ne!(name(b"\xff.nc"), name(b"\xfe.nc"));
    }
}
