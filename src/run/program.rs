//! The executed program: a resolved program, and the source of macrocycles that only execution asks for.

use crate::config::Settings;
use crate::diag::Findings;
use crate::resolve::{Library, MacrocycleFault, Resolved, UnitId};
use crate::text::Sources;

/// A resolved program with its configuration. Execution adds the macrocycles whose numbers come from parameters or the
/// cycle map; all interpreters of a program share it.
#[derive(Debug)]
pub struct Program<'a> {
    /// Its units and files.
    pub resolved: Resolved,
    /// The configuration that it is executed with.
    pub settings: &'a Settings,
    /// The macrocycles that it may call.
    pub library: Library<'a>,
    /// The texts of its files.
    pub sources: Sources,
}

impl Program<'_> {
    /// The program as the user named it.
    pub fn name(&self) -> &str {
        self.sources.iter().next().map_or("", |(_, source)| source.name())
    }

    /// The unit of macrocycle `l`.
    pub(super) fn macrocycle(&mut self, l: u32, findings: &mut Findings) -> Result<UnitId, MacrocycleFault> {
        self.resolved.load_macrocycle(l, self.settings, &mut self.library, &mut self.sources, findings)
    }
}
