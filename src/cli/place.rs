//! The place of a program that `state` and `restart` are asked about.

use super::args::PlaceArgs;
use super::words::Words;
use crate::analysis::state::{Asked, Place};
use crate::dict::Decimal;

/// A place, as the command line names it.
pub(super) enum Named {
    /// One that execution alone tells.
    At(Asked),
    /// So many seconds after program start.
    Time(f64, Asked),
}

impl Named {
    /// The place of the arguments, one of which there is.
    ///
    /// # Errors
    /// When it is not written as one.
    pub fn of(args: &PlaceArgs, after: bool) -> Result<Self, Words> {
        let asked = |place| Asked { place, file: args.file_of.clone(), pass: args.pass, after };
        if let Some(text) = &args.time {
            let seconds = seconds(text).ok_or_else(|| Words::TimeForm { text: text.clone() })?;
            return Ok(Self::Time(seconds, asked(Place::Seq(0))));
        }
        let place = match args {
            PlaceArgs { n: Some(n), .. } => Place::N(number(n, 'N').ok_or_else(|| Words::NForm { text: n.clone() })?),
            PlaceArgs { line: Some(line), .. } => Place::Line(*line),
            PlaceArgs { at_tool: Some(tool), .. } => {
                let number = number(tool, 'T').ok_or_else(|| Words::ToolForm { text: tool.clone() })?;
                Place::Tool(Decimal::whole(i64::from(number)))
            }
            PlaceArgs { seq, .. } => Place::Seq(seq.unwrap_or(0)),
        };
        Ok(Self::At(asked(place)))
    }
}

/// A number, with its address or without.
fn number(text: &str, address: char) -> Option<u32> {
    let digits = text.strip_prefix([address, address.to_ascii_lowercase()]).unwrap_or(text);
    digits.chars().all(|c| c.is_ascii_digit()).then(|| digits.parse().ok()).flatten()
}

/// `0:12:30`, `12:30.5`, `750`.
fn seconds(text: &str) -> Option<f64> {
    let parts: Vec<&str> = text.split(':').collect();
    let digits = |part: &str| !part.is_empty() && part.chars().all(|c| c.is_ascii_digit() || c == '.');
    if parts.len() > 3 || !parts.iter().all(|part| digits(part)) {
        return None;
    }
    let below_60 = |part: &&str| part.parse::<f64>().is_ok_and(|value| value < 60.0);
    if !parts.iter().skip(1).all(below_60) {
        return None;
    }
    parts.iter().try_fold(0.0, |sum, part| part.parse::<f64>().ok().map(|value| sum * 60.0 + value))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn times_and_numbers() {
        assert_eq!(seconds("0:12:30"), Some(750.0));
        assert_eq!(seconds("12:30.5"), Some(750.5));
        assert_eq!(seconds("750"), Some(750.0));
        assert!(["", ":", "1::2", "-1", "1:2:3:4", "x", "0:70", "1:60:00"].iter().all(|text| seconds(text).is_none()));
        assert_eq!((number("N120", 'N'), number("120", 'N'), number("T120", 'N')), (Some(120), Some(120), None));
    }
}
