//! `explain`: pages about findings, functions, addresses and keys of the project file; else those that mention a word.

use std::io::{IsTerminal, Write};

use super::args::ExplainArgs;
use super::locale::Locale;
use super::status::{Failure, Status, complain, stdout};
use super::words::Words;
use crate::diag::Finding;
use crate::diag::explain::{list, terminal};
use crate::dict::{Bilingual, Lang};
use crate::explain::{Hit, Topic, Unknown, search, search_stems};

/// Most pages that a search lists.
const MOST_HITS: usize = 40;

pub(super) fn run(args: &ExplainArgs, locale: Locale) -> Result<Status, Failure> {
    let mut out = stdout()?;
    let colors = locale.colors(out.is_terminal());
    let mut status = Status::Fine;
    if args.names.is_empty() {
        out.write_all(list(locale.lang).as_bytes())?;
    }
    let mut shown = Vec::new();
    for name in &args.names {
        let text = match Topic::find(name) {
            Ok(topics) => {
                let pages: Vec<String> = topics
                    .iter()
                    .map(|topic| terminal(&topic.page(locale.lang), colors).trim_end().to_owned())
                    .collect();
                pages.join("\n\n")
            }
            Err(unknown) => match hits(name, &unknown) {
                Some(hits) => listed(name, &hits, locale.lang),
                None => {
                    status = Status::Unusable;
                    complain(&hint(name, unknown, locale.lang), locale.lang);
                    continue;
                }
            },
        };
        shown.push(format!("{}\n", text.trim_end()));
    }
    // Of wrong usage nothing is on standard output.
    if status == Status::Fine {
        out.write_all(shown.join("\n").as_bytes())?;
    }
    out.flush()?;
    Ok(status)
}

/// The pages that mention a word. What has digits is a code or function, misspelled or of another control.
fn hits(name: &str, unknown: &Unknown) -> Option<Vec<Hit>> {
    match unknown {
        Unknown::Word(_) | Unknown::M(_) => None,
        Unknown::Name(_) if name.contains(|c: char| c.is_ascii_digit()) || name.chars().count() < 3 => None,
        Unknown::Name(near) => {
            let hits = Some(search(name)).filter(|hits| !hits.is_empty());
            // A name that is nearly right is a slip, no word to look for.
            hits.or_else(|| near.is_none().then(|| search_stems(name))).filter(|hits| !hits.is_empty())
        }
    }
}

/// The pages found, a line each.
fn listed(query: &str, hits: &[Hit], lang: Lang) -> String {
    let name = crate::diag::terminal_safe(query);
    let head = match lang {
        Lang::En => format!("Pages about \"{name}\":\n"),
        Lang::Cs => format!("Stránky, kde je „{name}“:\n"),
    };
    let shown = hits.get(..MOST_HITS).unwrap_or(hits);
    let width = shown.iter().map(|hit| hit.topic.name().chars().count()).max().unwrap_or(0);
    let line = |hit: &Hit| format!("  {:width$}  {}\n", hit.topic.name(), hit.topic.title(lang).replace('`', ""));
    let mut text: String = std::iter::once(head).chain(shown.iter().map(line)).collect();
    let more = hits.len() - shown.len();
    if more > 0 {
        let words = Bilingual { en: "more", cs: "dalších" }.get(lang);
        text.push_str(&match lang {
            Lang::En => format!("  … {more} {words}\n"),
            Lang::Cs => format!("  … {words} {more}\n"),
        });
    }
    text
}

fn hint(name: &str, unknown: Unknown, lang: Lang) -> Words {
    let name = name.to_owned();
    match unknown {
        Unknown::Word(finding) => foreign_word(&finding, lang),
        Unknown::M(number) => Words::NoMFunction { number },
        Unknown::Name(Some(near)) => Words::NothingToExplainNear { name, near: near.to_owned() },
        Unknown::Name(None) => Words::NothingToExplain { name },
    }
}

fn foreign_word(finding: &Finding, lang: Lang) -> Words {
    let message = finding.message(lang);
    match finding.help(lang) {
        Some(help) => Words::Foreign { text: format!("{message}; {help}") },
        None => Words::Foreign { text: message },
    }
}
