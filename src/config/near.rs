//! The nearest of some names to one that is not known (W0705).

/// Longest name for which a near one is looked for, in bytes.
const LONGEST: usize = 60;

/// The candidate that was probably meant by `name`: that with the fewest letters to change, case and `_` for `-` not
/// counted, and no more than half of them. The first of equals.
pub(super) fn nearest<'a>(name: &str, candidates: impl IntoIterator<Item = &'a str>) -> Option<String> {
    if name.len() > LONGEST {
        return None;
    }
    let plain = |text: &str| text.to_lowercase().replace('_', "-");
    let meant = plain(name);
    candidates
        .into_iter()
        .map(|candidate| (strsim::osa_distance(&meant, &plain(candidate)), candidate))
        .filter(|(distance, candidate)| distance * 2 <= candidate.chars().count().max(meant.chars().count()))
        .min_by_key(|(distance, _)| *distance)
        .map(|(_, candidate)| candidate.to_owned())
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn what_was_meant() {
        let keys = ["dialect", "block-skip", "optional-stop", "records"];
        for (name, expected) in [
            ("dialekt", Some("dialect")),
            ("block_skip", Some("block-skip")),
            ("Block-Skip", Some("block-skip")),
            ("blockskip", Some("block-skip")),
            ("recrods", Some("records")),
            ("xyz", None),
            ("", None),
        ] {
            assert_eq!(nearest(name, keys).as_deref(), expected, "{name}");
        }
        assert_eq!(nearest(&"d".repeat(1_000_000), keys), None);
        let long = "d".repeat(40);
        assert_eq!(nearest(&"d".repeat(LONGEST), [long.as_str()]), Some(long.clone()));
        assert_eq!(nearest(&"d".repeat(LONGEST + 1), [long.as_str()]), None);
    }
}
