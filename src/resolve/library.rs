//! The macrocycles that programs may call: files named `L` and their number, on the search path (PRG-6).

use std::collections::BTreeMap;
use std::path::{Path, PathBuf};
use std::sync::Arc;

use super::spelling::distance;
use crate::config::MayMove;
use crate::diag::Problem;
use crate::dict::HIGHEST_L;
use crate::text::{Encoding, Loader, Numbered, SourceText, path_name};

/// Why a macrocycle cannot be called.
#[derive(Clone, Debug, Eq, PartialEq)]
pub enum MacrocycleFault {
    /// No file of that number; where was searched.
    Missing {
        /// The folders, for the message.
        searched: String,
        /// The one whose number is written nearly so.
        near: Option<u32>,
    },
    /// No file of that number, and only the machine has it (FLW-12).
    OfMachine {
        /// The project file says which axes it may move.
        axes_named: bool,
    },
    /// Two files of that number.
    Ambiguous {
        /// One.
        first: String,
        /// The other.
        second: String,
    },
    /// The file cannot be read.
    Unreadable {
        /// It.
        file: String,
        /// Why.
        problem: Problem,
    },
}

/// Finds macrocycle files. Each folder is listed once, in a run over many programs too.
pub struct Library<'a> {
    loader: &'a dyn Loader,
    folders: Vec<PathBuf>,
    index: Option<Arc<Numbered>>,
    of_machine: Option<&'a BTreeMap<u32, MayMove>>,
}

impl<'a> Library<'a> {
    /// Searches `folders`, or the folder of `program` when there are none.
    pub fn new(loader: &'a dyn Loader, folders: &[PathBuf], program: &Path) -> Self {
        let folders = if folders.is_empty() {
            vec![program.parent().map(Path::to_path_buf).unwrap_or_default()]
        } else {
            folders.to_vec()
        };
        Self { loader, folders, index: None, of_machine: None }
    }

    /// The same, with those that only the machine has.
    #[must_use]
    pub fn with_machine(mut self, macrocycles: &'a BTreeMap<u32, MayMove>) -> Self {
        self.of_machine = Some(macrocycles);
        self
    }

    /// The number of the macrocycle that a file of that name holds: `L` and digits, with no extension or `.NC`, `.NCP`,
    /// `.MRC`, `.TXT`, in either case.
    pub fn number(path: &Path) -> Option<u32> {
        let name = path.file_name()?.to_str()?.to_ascii_uppercase();
        let digits = name.strip_prefix('L')?;
        let digits = [".NC", ".NCP", ".MRC", ".TXT"]
            .into_iter()
            .find_map(|extension| digits.strip_suffix(extension))
            .unwrap_or(digits);
        if digits.is_empty() || !digits.bytes().all(|byte| byte.is_ascii_digit()) {
            return None;
        }
        digits.trim_start_matches('0').parse().ok().filter(|number| (1..=HIGHEST_L).contains(number))
    }

    /// The file of macrocycle `l`.
    ///
    /// # Errors
    /// [`MacrocycleFault::Missing`], [`MacrocycleFault::OfMachine`] or [`MacrocycleFault::Ambiguous`].
    pub fn find(&mut self, l: u32) -> Result<PathBuf, MacrocycleFault> {
        let of_machine = self.of_machine.and_then(|known| known.get(&l));
        match self.index().get(&l).map(Vec::as_slice) {
            None | Some([]) if let Some(may_move) = of_machine => {
                Err(MacrocycleFault::OfMachine { axes_named: may_move.names_axes() })
            }
            None | Some([]) => {
                let name = |folder: &PathBuf| match path_name(folder) {
                    name if name.is_empty() => ".".to_owned(),
                    name => name,
                };
                let searched = self.folders.iter().map(name).collect::<Vec<_>>().join(", ");
                let near = self.index().keys().copied().min_by_key(|number| distance(*number, l));
                let near = near.filter(|near| distance(*near, l).0 == 1);
                Err(MacrocycleFault::Missing { searched, near })
            }
            Some([only]) => Ok(only.clone()),
            Some([first, second, ..]) => {
                Err(MacrocycleFault::Ambiguous { first: path_name(first), second: path_name(second) })
            }
        }
    }

    /// Whether only the machine has macrocycle `l` (FLW-12).
    pub fn is_of_machine(&mut self, l: u32) -> bool {
        matches!(self.find(l), Err(MacrocycleFault::OfMachine { .. }))
    }

    /// The files that can be called, as a text: another text, another library.
    pub fn listing(&mut self) -> String {
        format!("{:?}", self.index())
    }

    fn index(&mut self) -> &Numbered {
        let Self { loader, folders, index, of_machine: _ } = self;
        index.get_or_insert_with(|| loader.numbered(folders, &|| number_files(*loader, folders)))
    }

    /// The text of a macrocycle file, called `name`.
    ///
    /// # Errors
    /// [`MacrocycleFault::Unreadable`].
    pub fn load(&self, path: &Path, name: &str, fallback: Encoding) -> Result<Arc<SourceText>, MacrocycleFault> {
        let unreadable =
            |error| MacrocycleFault::Unreadable { file: name.to_owned(), problem: Problem::from_io(&error) };
        self.loader.load(path, name, fallback).map_err(unreadable)
    }

    /// The macrocycles that can be called, by number; of two files of one number the first.
    pub fn all(&mut self) -> impl Iterator<Item = (u32, &Path)> {
        self.index().iter().filter_map(|(number, paths)| Some((*number, paths.first()?.as_path())))
    }
}

/// The macrocycle files of the folders by number.
fn number_files(loader: &dyn Loader, folders: &[PathBuf]) -> Numbered {
    let mut index = Numbered::new();
    for path in folders.iter().flat_map(|folder| loader.list(folder)) {
        if let Some(number) = Library::number(&path) {
            let files = index.entry(number).or_default();
            // One file reached by two names is not two files.
            if !files.iter().any(|known| loader.canonical(known) == loader.canonical(&path)) {
                files.push(path);
            }
        }
    }
    index
}

impl std::fmt::Debug for Library<'_> {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        f.debug_struct("Library").field("folders", &self.folders).finish_non_exhaustive()
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::text::MemoryLoader;

    /// PRG-6: case, leading zeros and four extensions.
    #[test]
    fn names() {
        for name in ["L9001", "l9001", "L09001", "L9001.NC", "l9001.mrc", "dir/L9001.Txt"] {
            assert_eq!(Library::number(Path::new(name)), Some(9001), "{name}");
        }
        for name in ["L", "L9001.toml", "LX1", "9001", "L10000", "L0", "L+5", "L-5"] {
            assert_eq!(Library::number(Path::new(name)), None, "{name}");
        }
    }

    #[test]
    fn two_files_of_one_number() {
        let loader = MemoryLoader::new().with("m/L1", "").with("m/L01.NC", "").with("m/L2", "");
        let mut library = Library::new(&loader, &[PathBuf::from("m")], Path::new("p.nc"));
        assert!(matches!(library.find(1), Err(MacrocycleFault::Ambiguous { .. })));
        assert_eq!(library.find(2), Ok(PathBuf::from("m/L2")));
        assert_eq!(library.find(3), Err(MacrocycleFault::Missing { searched: "m".to_owned(), near: Some(2) }));
    }
}
