//! `format`: one layout for programs and macrocycles.

use std::sync::Arc;

use super::args::FormatArgs;
use super::locale::Locale;
use super::rewrite::{self, Made};
use super::status::{Failure, Status};
use super::walk::Target;
use super::words::Words;
use crate::config::Settings;
use crate::edit::{Formatted, format};
use crate::text::SourceText;

pub(super) fn run(args: &FormatArgs, locale: Locale) -> Result<Status, Failure> {
    rewrite::run(&args.paths, &args.rewrite, &args.common, locale, &make)
}

fn make(target: &Target, source: &Arc<SourceText>, settings: &Settings, out: &mut dyn FnMut(&[u8])) -> Made {
    match format(&target.path, source, settings, out) {
        Ok(Formatted { changed, lines_left }) => {
            let said = (lines_left > 0).then(|| Words::LinesLeft { file: target.name(), lines: lines_left });
            Made { changed, said: said.into_iter().collect(), ..Made::unchanged() }
        }
        Err(outcome) => Made { findings: Some((outcome.sources, outcome.findings)), ..Made::unchanged() },
    }
}
