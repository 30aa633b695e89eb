//! `renumber`: new numbers for the blocks of programs and macrocycles.

use std::sync::Arc;

use super::args::RenumberArgs;
use super::locale::Locale;
use super::rewrite::{self, Made};
use super::status::{Failure, Status};
use super::walk::Target;
use super::words::Words;
use crate::config::Settings;
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
    let make = |target: &Target, source: &Arc<SourceText>, settings: &Settings, out: &mut dyn FnMut(&[u8])| {
        let file = target.name();
        match renumbered(&target.path, source, settings, numbering, out) {
            Ok((changed, renumbering)) => Made { changed, said: said(&file, renumbering), ..Made::unchanged() },
            Err(why) => {
                let why = why.text(locale.lang);
                Made { refused: Some(Words::NotRenumbered { file, why }), ..Made::unchanged() }
            }
        }
    };
    rewrite::run(&args.paths, &args.rewrite, &args.common, locale, &make)
}

/// The numbers in comments that stood for blocks (REN-4).
fn said(file: &str, Renumbering { mentions, .. }: Renumbering) -> Vec<Words> {
    let more = mentions.len().saturating_sub(MOST_MENTIONS);
    let listed = mentions.into_iter().take(MOST_MENTIONS);
    let mentioned = |(line, old, new)| Words::NumberMentioned { file: file.to_owned(), line, old, new };
    let more = (more > 0).then(|| Words::MoreMentions { file: file.to_owned(), more });
    listed.map(mentioned).chain(more).collect()
}
