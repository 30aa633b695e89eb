//! `format`: one layout for programs and macrocycles.

use std::sync::Arc;

use super::args::FormatArgs;
use super::locale::Locale;
use super::rewrite::{self, Made};
use super::status::{Failure, Status};
use super::walk::Target;
use super::words::Words;
use crate::config::Settings;
use crate::edit::format;
use crate::text::SourceText;

pub(super) fn run(args: &FormatArgs, locale: Locale) -> Result<Status, Failure> {
    rewrite::run(&args.paths, &args.rewrite, &args.common, locale, &make)
}

fn make(target: &Target, source: &Arc<SourceText>, bytes: &[u8], settings: &Settings) -> Made {
    match format(&target.path, source, bytes, settings) {
        Ok((bytes, 0)) => Made { bytes, ..Made::unchanged() },
        Ok((bytes, lines)) => {
            let said = vec![Words::LinesLeft { file: target.name(), lines }];
            Made { bytes, said, ..Made::unchanged() }
        }
        Err(outcome) => Made { findings: Some((outcome.sources, outcome.findings)), ..Made::unchanged() },
    }
}
