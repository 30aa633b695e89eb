//! The machine as the planner sees it, in mm, degrees and seconds.

use crate::config::{Profile, Recognition};

/// The machine. What belongs to a dynamic set comes with each block.
#[derive(Clone, Debug, PartialEq)]
pub struct Model {
    /// How joints are recognised.
    pub recognition: Recognition,
    /// Tolerance angle, degrees.
    pub angle_deg: f64,
    /// The profile.
    pub profile: Profile,
    /// Acceleration of working motion outside continuity, and of threads, mm/s².
    pub accel: f64,
    /// Acceleration of G00, mm/s².
    pub accel_rapid: f64,
    /// Shortest time of a block in a stretch, seconds.
    pub shortest_s: f64,
    /// A shorter block breaks continuity, mm; 0: off.
    pub break_mm: f64,
    /// A shorter linear block is joined to its neighbour, mm; 0: off.
    pub merge_mm: f64,
    /// Part of the programmed velocity below which a joint has a red dot.
    pub red: f64,
    /// In a shorter block the velocity does not rise above those of its joints (linear), mm; 0: off.
    pub raise_mm: f64,
    /// Time criterion for a rise of velocity, seconds.
    pub raise_s: f64,
    /// Blocks that the control sees.
    pub look_ahead: usize,
    /// Interpolation cycle, milliseconds; 0 where it is not known, so that no criterion limits anything.
    pub cycle_ms: f64,
    /// A criterion is on that needs the cycle, which is not known: times are lower bounds.
    pub lacks_cycle: bool,
    /// Wait at the end of a motion that is not continued, seconds.
    pub settle_s: f64,
    /// Whether somebody gave that wait.
    pub settle_given: bool,
    /// Gap before each block in G98, seconds.
    pub gap_s: f64,
    /// Whether somebody gave that gap.
    pub gap_given: bool,
}
