//! `[restart]`: how programs are started in the middle.

use super::Takes;
use super::keys::letters;
use super::project::Project;
use super::reader::Reader;
use super::row::{Row, row, words};
use super::taken::Values;
use crate::dict::AxisLetter;

const TOOL_AXIS: Row = row(
    "tool-axis",
    Takes::OneOf(letters),
    words("`\"Z\"`; none on a lathe (G74)", "`\"Z\"`; na soustruhu (G74) žádná"),
    (
        "the axis along which the tool leaves the workpiece and comes back to it, upwards by its greater values",
        "osa, po které nástroj opouští obrobek a vrací se k němu, nahoru k větším hodnotám",
    ),
    "RST-2",
)
.with_example("\"Z\"");

/// `[restart]`.
pub(super) const RESTART: &[Row] = &[TOOL_AXIS];

impl Project {
    /// `[restart]`.
    pub(super) fn restart(&mut self, _: &mut Reader<'_>, values: &Values) {
        let named = |name: &str| AxisLetter::ALL.into_iter().find(|letter| letter.name() == name);
        self.tool_axis = values.choice(&TOOL_AXIS, named);
    }
}
