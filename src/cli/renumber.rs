//! `renumber`: new numbers for the blocks of programs and macrocycles.

use std::sync::Arc;

use super::args::RenumberArgs;
use super::locale::Locale;
use super::rewrite::{self, Made};
use super::status::{Failure, Status};
use super::walk::Target;
use super::words::Words;
use crate::config::Settings;
use crate::dict::Lang;
use crate::edit::renumber::{Numbering, Part, Renumbering, renumbered};
use crate::text::SourceText;

/// Most numbers in comments that are listed for a file.
const MOST_MENTIONS: usize = 20;

pub(super) fn run(args: &RenumberArgs, locale: Locale) -> Result<Status, Failure> {
    let part = match (args.unit, args.from, args.to) {
        (Some(l), ..) => Part::Unit(l),
        (None, None, None) => Part::All,
        (None, from, to) => Part::Blocks(from, to),
    };
    let width = usize::from(args.width);
    let numbering = Numbering { start: args.start, step: args.step, width, part };
    let make = |target: &Target, source: &Arc<SourceText>, bytes: &[u8], settings: &Settings| {
        made(target, source, bytes, settings, numbering, locale.lang)
    };
    rewrite::run(&args.paths, &args.rewrite, &args.common, locale, &make)
}

fn made(
    target: &Target,
    source: &Arc<SourceText>,
    bytes: &[u8],
    settings: &Settings,
    numbering: Numbering,
    lang: Lang,
) -> Made {
    let file = target.name();
    match renumbered(&target.path, source, bytes, settings, numbering) {
        Ok((bytes, Renumbering { mentions, .. })) => {
            let more = mentions.len().saturating_sub(MOST_MENTIONS);
            let mut said: Vec<Words> = mentions
                .into_iter()
                .take(MOST_MENTIONS)
                .map(|(line, old, new)| Words::NumberMentioned { file: file.clone(), line, old, new })
                .collect();
            if more > 0 {
                said.push(Words::MoreMentions { file, more });
            }
            Made { bytes, said, ..Made::unchanged() }
        }
        Err(why) => Made { refused: Some(Words::NotRenumbered { file, why: why.text(lang) }), ..Made::unchanged() },
    }
}
