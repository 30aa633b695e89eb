//! Functions over many programs.

use std::ffi::CString;
use std::path::{Path, PathBuf};
use std::sync::{Arc, OnceLock};

use cnc872c::cli::stats_cache::{Cache, fresh};
use cnc872c::cli::walk::{Origin, Target, targets};
use cnc872c::columns::Kept;
use cnc872c::config::EXTENSIONS;
use cnc872c::session::{Outcome, Session};
use cnc872c::stats::{Row, RowTable};
use pyo3::exceptions::PyUserWarning;
use pyo3::prelude::*;
use pyo3::types::PyDict;
use rayon::prelude::*;

use crate::fault::{Fault, json};
use crate::options::{Options, paths};
use crate::setup::Setup;
use crate::table::Table;
use crate::work::{GoesOn, work};

/// How many programs are worked on before their results are put in order.
const AT_ONCE: usize = 1024;

/// Programs with their configuration.
struct Many<'o> {
    setup: Setup<'o>,
    targets: Vec<Target>,
}

/// Which programs count.
struct Search {
    /// Macrocycles too.
    macrocycles: bool,
    /// A folder without programs is no fault.
    empty: bool,
}

impl<'o> Many<'o> {
    /// The programs that `paths` mean. A text replaces the only one.
    fn new(paths: Vec<PathBuf>, text: Option<Arc<[u8]>>, options: &'o Options, search: &Search) -> Result<Self, Fault> {
        if paths.is_empty() && !search.empty {
            return Err(Fault::None);
        }
        let given = text.is_some();
        let mut setup = Setup::new(options, &paths, text)?;
        let mut found = if given {
            paths.into_iter().map(Target::named).collect()
        } else {
            let plain = || EXTENSIONS.iter().map(|extension| (*extension).to_owned()).collect();
            let mut extensions =
                |folder: &Path| setup.folder(folder).map_or_else(plain, |settings| settings.extensions.clone());
            let found = targets(&paths, &mut extensions);
            if let Some(folder) = found.barren.into_iter().next().filter(|_| !search.empty) {
                return Err(Fault::Barren(folder));
            }
            found.targets
        };
        found.retain(|target| search.macrocycles || !Session::is_macrocycle(&target.path, &setup.files));
        for target in &found {
            setup.folder(target.folder());
        }
        Ok(Self { setup, targets: found })
    }

    /// What `each` makes of the programs, in their order; those of the last are given to `take` before the next are
    /// begun.
    fn each<T: Send>(
        &self,
        goes_on: &GoesOn<'_>,
        each: impl Fn(&Target, &Session<'_>) -> Result<T, Fault> + Sync,
        mut take: impl FnMut(Vec<T>) -> Result<(), Fault>,
    ) -> Result<(), Fault> {
        let one = |target: &Target| {
            let settings = self.setup.settings(target.folder()).filter(|_| goes_on(0))?;
            Some(each(target, &Session { loader: &self.setup.files, settings, progress: Some(goes_on) }))
        };
        for some in self.targets.chunks(AT_ONCE) {
            // One program may use all threads itself.
            let made: Result<Vec<T>, Fault> = match some {
                [only] => one(only).into_iter().collect(),
                _ => some.par_iter().filter_map(one).collect(),
            };
            take(made?)?;
        }
        Ok(())
    }
}

/// All findings, as JSON.
#[pyfunction]
pub fn check(
    py: Python<'_>,
    programs: &Bound<'_, PyAny>,
    text: Option<Vec<u8>>,
    options: &Bound<'_, PyDict>,
    allow_empty: bool,
) -> PyResult<String> {
    let options = Options::new(options)?;
    let (paths, text) = (paths(programs)?, text.map(Arc::from));
    let made = work(py, move |goes_on| {
        let mut many = Many::new(paths, text, &options, &Search { macrocycles: true, empty: allow_empty })?;
        let mut report = many.setup.report()?;
        let check = |target: &Target, session: &Session<'_>| {
            let outcome = session.check(&target.path, &target.name());
            if outcome.unusable && target.origin == Origin::Named {
                session.loader.read(&target.path).map_err(|error| Fault::Io(target.path.clone(), error))?;
            }
            Ok(outcome)
        };
        many.each(goes_on, check, |outcomes| {
            outcomes.into_iter().for_each(|outcome: Outcome| outcome.add_to(&mut report));
            Ok(())
        })?;
        Ok(json(&report, options.lang))
    })?;
    made.map_err(|fault: Fault| fault.raise(py))
}

/// A row of facts a program.
#[pyfunction]
pub fn stats(
    py: Python<'_>,
    programs: &Bound<'_, PyAny>,
    text: Option<Vec<u8>>,
    options: &Bound<'_, PyDict>,
    cache: Option<PathBuf>,
) -> PyResult<Table> {
    let options = Options::new(options)?;
    let (paths, text) = (paths(programs)?, text.map(Arc::from));
    let damage = Arc::new(OnceLock::new());
    let told = Arc::clone(&damage);
    let made = work(py, move |goes_on| {
        let cache = match cache {
            Some(folder) => match Cache::open(&folder) {
                Ok(cache) => Some((cache, folder)),
                Err(error) => return Err(Fault::Io(folder, error)),
            },
            None => None,
        };
        if let Some(damage) = cache.as_ref().and_then(|(cache, _)| cache.damage()) {
            told.get_or_init(|| damage.text(options.lang));
        }
        let mut many = Many::new(paths, text, &options, &Search { macrocycles: false, empty: false })?;
        many.setup.report()?;
        let (mut kept, mut failed) = (Kept::default(), None);
        let unkept = |error| Fault::Io(PathBuf::new(), error);
        let mut rows = RowTable::new(&mut kept, &mut failed);
        let row = |target: &Target, session: &Session<'_>| {
            let path = target.name();
            Ok(match (session.loader.read(&target.path), &cache) {
                (Err(error), _) if target.origin == Origin::Named => return Err(Fault::Io(target.path.clone(), error)),
                (Err(_), _) => Row { path, findings: [("E0112".to_owned(), 1)].into(), ..Row::default() },
                (Ok(bytes), Some((cache, _))) => cache.row(session, target, &path, &bytes),
                (Ok(bytes), None) => fresh(session, &target.path, &path, &bytes).0,
            })
        };
        many.each(goes_on, row, |some: Vec<Row>| {
            some.iter().try_for_each(|row| rows.row(row)).map_err(unkept)?;
            match &cache {
                // The last rows of a cancelled run may not be whole.
                Some((cache, _)) if goes_on(0) => cache.write(),
                _ => {}
            }
            Ok(())
        })?;
        if let Some((folder, error)) = cache.and_then(|(cache, folder)| Some((folder, cache.into_fault()?))) {
            return Err(Fault::Io(folder, error));
        }
        rows.end().map_err(unkept)?;
        Ok(Table::from(kept))
    })?;
    if let Some(damage) = damage.get() {
        PyErr::warn(py, &py.get_type::<PyUserWarning>(), &CString::new(damage.as_str())?, 1)?;
    }
    made.map_err(|fault: Fault| fault.raise(py))
}
