//! `schema`: what other programs check the data against.

use std::io::Write;

use super::args::{SchemaArgs, SchemaName};
use super::status::{Failure, Status, stdout};
use crate::analysis::{compare, motion, plc, sheet, state};
use crate::{config, diag, stats, stream};

pub(super) fn run(args: &SchemaArgs) -> Result<Status, Failure> {
    let schema = match args.schema {
        SchemaName::Blocks => stream::schema(),
        SchemaName::Diagnostics => diag::schema(),
        SchemaName::Config => config::schema(),
        SchemaName::Motion => motion::schema(),
        SchemaName::Plc => plc::schema(),
        SchemaName::Report => sheet::schema(),
        SchemaName::State => state::schema(),
        SchemaName::Stats => stats::schema(),
        SchemaName::Compare => compare::schema(),
    };
    let mut out = stdout()?;
    out.write_all(format!("{schema:#}\n").as_bytes())?;
    out.flush()?;
    Ok(Status::Fine)
}
