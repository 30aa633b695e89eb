//! The names of files on a page: none is a folder of the computer that made it, and the same program gives the same
//! bytes from every working folder.

use std::path::{Path, PathBuf};

use crate::diag::Finding;
use crate::text::{Loader, last_name, path_name};

/// Names files by their places in the folder of the program.
#[derive(Clone, Copy)]
pub struct Naming<'a> {
    /// The program that is shown.
    pub program: &'a Path,
    /// Tells where files are.
    pub loader: &'a dyn Loader,
}

impl Naming<'_> {
    /// The program's own name.
    pub fn program(&self) -> String {
        last_name(self.program)
    }

    /// The name of another file: its path from the program's folder, with slashes; of a file elsewhere its last part
    /// alone.
    pub fn of(&self, name: &str) -> String {
        let path = Path::new(name);
        if path_name(self.program) == name {
            return self.program();
        }
        let inside = self.canonical(path).strip_prefix(self.folder()).ok().map(joined);
        inside.filter(|name| !name.is_empty()).unwrap_or_else(|| last_name(path))
    }

    /// A finding whose words name no folders either.
    pub fn in_finding(&self, finding: &Finding) -> Finding {
        let mut named = finding.clone();
        if let Finding::UnreadableFile { file: Some(file), .. } | Finding::MacrocycleNumberMismatch { file, .. } =
            &mut named
        {
            *file = self.of(file);
        }
        if let Finding::DuplicateMacrocycle { first, second, .. } = &mut named {
            (*first, *second) = (self.of(first), self.of(second));
        }
        named
    }

    fn folder(&self) -> PathBuf {
        self.canonical(self.program.parent().unwrap_or(Path::new("")))
    }

    fn canonical(&self, path: &Path) -> PathBuf {
        self.loader.canonical(if path.as_os_str().is_empty() { Path::new(".") } else { path })
    }
}

fn joined(path: &Path) -> String {
    path.components().map(|part| path_name(Path::new(part.as_os_str()))).collect::<Vec<_>>().join("/")
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::text::MemoryLoader;

    #[test]
    fn names_hold_no_folders() {
        let loader = MemoryLoader::new();
        let naming = Naming { program: Path::new("/shop/parts/part.nc"), loader: &loader };
        assert_eq!(naming.program(), "part.nc");
        for (path, name) in [
            ("/shop/parts/part.nc", "part.nc"),
            ("/shop/parts/macros/L9001", "macros/L9001"),
            ("/opt/customer/L9001", "L9001"),
            ("-", "-"),
        ] {
            assert_eq!(naming.of(path), name);
        }
    }
}
