//! How near two numbers are as they are written.

use crate::dict::HIGHEST_L;

/// A sort key: how many digits have to be put in, left out, changed, or exchanged with their neighbours to make one of
/// the other, and then how far they are from each other.
pub(super) fn distance(one: u32, other: u32) -> (usize, u32) {
    (strsim::osa_distance(&one.to_string(), &other.to_string()), one.abs_diff(other))
}

/// The numbers of at most four digits that one slip makes of `number`.
pub(super) fn slips(number: u32) -> impl Iterator<Item = u32> {
    let digits: Vec<u8> = number.to_string().into_bytes();
    let mut texts: Vec<Vec<u8>> = Vec::new();
    for at in 0..=digits.len() {
        let (before, behind) = digits.split_at(at);
        for digit in b'0'..=b'9' {
            texts.push([before, &[digit], behind].concat());
            if let Some((_, behind)) = behind.split_first() {
                texts.push([before, &[digit], behind].concat());
            }
        }
        if let Some((_, behind)) = behind.split_first() {
            texts.push([before, behind].concat());
        }
        if let [first, second, behind @ ..] = behind {
            texts.push([before, &[*second, *first], behind].concat());
        }
    }
    let value = |text: Vec<u8>| String::from_utf8(text).ok()?.parse::<u32>().ok();
    texts.into_iter().filter_map(value).filter(move |slip| *slip != number && (1..=HIGHEST_L).contains(slip))
}

/// The whole number that a text begins with, and the text behind it.
pub(super) fn leading_number(text: &str) -> Option<(u32, &str)> {
    let digits = text.bytes().take_while(u8::is_ascii_digit).count();
    let (digits, behind) = text.split_at(digits);
    Some((digits.parse().ok()?, behind))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn apart() {
        for (one, other, apart) in [(3, 30, 1), (3, 10, 2), (12, 21, 1), (100, 101, 1), (5, 5, 0), (1234, 43, 3)] {
            assert_eq!((distance(one, other).0, distance(other, one).0), (apart, apart), "{one} {other}");
        }
    }

    /// Every slip is one apart, and there is none besides.
    #[test]
    fn all_slips() {
        for number in [3, 40, 101, 1234, 9999] {
            let mut found: Vec<u32> = slips(number).collect();
            found.sort_unstable();
            found.dedup();
            let expected: Vec<u32> = (1..=9999).filter(|other| distance(number, *other).0 == 1).collect();
            let without_zeros: Vec<u32> = found.iter().copied().filter(|slip| expected.contains(slip)).collect();
            assert_eq!(without_zeros, expected, "{number}");
        }
    }
}
