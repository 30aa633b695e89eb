//! Numbers as written, read exactly (LEX-4, LEX-5, ADR-2).

use crate::dict::Decimal;

/// A number as written.
#[derive(Clone, Copy, Debug, Default, Eq, PartialEq)]
pub struct Number {
    /// Its value, rounded to 0.001, halves away from zero; saturated far outside every range.
    pub value: Decimal,
    /// `-` was written.
    pub minus: bool,
    /// `+` was written.
    pub plus: bool,
    /// A decimal point was written.
    pub point: bool,
    /// Rounding changed the value.
    pub rounded: bool,
}

/// More than any range of the language, and far from overflow.
const HUGE: i64 = 1_000_000_000;

impl Number {
    /// Reads `[+-]digits[.digits]`; `None` when it is anything else or has no digit.
    pub fn parse(text: &[u8]) -> Option<Self> {
        Self::leading(text).filter(|(_, rest)| rest.is_empty()).map(|(number, _)| number)
    }

    /// Reads the number that `text` begins with, and gives what comes after it; `None` when there is no digit.
    #[inline(always)]
    pub fn leading(text: &[u8]) -> Option<(Self, &[u8])> {
        let (minus, plus) = (text.first() == Some(&b'-'), text.first() == Some(&b'+'));
        let unsigned = text.get(usize::from(minus | plus)..)?;
        let Unsigned { magnitude, point, rounded, length } =
            unsigned.first_chunk().and_then(|eight| Unsigned::in_eight(*eight)).or_else(|| Unsigned::read(unsigned))?;
        let value = Decimal::from_thousandths(if minus { -magnitude } else { magnitude });
        Some((Self { value, minus, plus, point, rounded }, unsigned.get(length..)?))
    }
}

/// A number without its sign.
#[derive(Clone, Copy, Debug, Eq, PartialEq)]
struct Unsigned {
    /// In thousandths.
    magnitude: i64,
    point: bool,
    rounded: bool,
    /// How many bytes it has.
    length: usize,
}

impl Unsigned {
    /// Reads the number that `text` begins with.
    #[cold]
    #[inline(never)]
    fn read(text: &[u8]) -> Option<Self> {
        let (whole, rest) = leading_digits(text);
        let has_whole = rest.len() < text.len();
        let mut number =
            Self { magnitude: whole * 1000, point: false, rounded: false, length: text.len() - rest.len() };
        if let [b'.', decimals @ ..] = rest {
            let count = decimals.iter().take_while(|byte| byte.is_ascii_digit()).count();
            let (kept, dropped) = decimals.get(..count)?.split_at(count.min(3));
            let (fraction, _) = leading_digits(kept);
            let up = dropped.first().is_some_and(|digit| *digit >= b'5');
            number.magnitude += fraction * scale(kept.len())? + i64::from(up);
            number.point = true;
            number.rounded = dropped.iter().any(|digit| *digit != b'0');
            number.length += 1 + count;
            return (has_whole || count > 0).then_some(number);
        }
        has_whole.then_some(number)
    }

    /// The same for a number that ends within eight bytes and has at most three decimals, as nearly all have: without a
    /// step for each digit. `None` when it is another one.
    #[inline]
    fn in_eight(bytes: [u8; 8]) -> Option<Self> {
        // The first byte is the lowest. A digit becomes 0 to 9; adding 0x76 to anything above sets its highest bit.
        let text = u64::from_le_bytes(bytes) ^ 0x3030_3030_3030_3030;
        let others = (((text & 0x7f7f_7f7f_7f7f_7f7f) + 0x7676_7676_7676_7676) | text) & 0x8080_8080_8080_8080;
        let whole_bits = others.trailing_zeros() & !7;
        let behind = text.checked_shr(whole_bits)?;
        let point = behind & 0xff == u64::from(b'.' ^ b'0');
        let (digits, bits, decimals) = if point {
            let bits = (others & (others - 1)).trailing_zeros() & !7;
            let before = (1 << whole_bits) - 1;
            // The point is taken out. Sixty-four: the end is not in sight.
            let digits = text & before | (text >> 8) & !before;
            (digits, bits.checked_sub(8).filter(|bits| *bits < 56)?, (bits - whole_bits) as usize / 8 - 1)
        } else {
            (text, whole_bits, 0)
        };
        // Behind zeros, instead of before something else. Then tens and ones are put together, hundreds and those, and so on.
        let digits = digits.checked_shl(64 - bits)?;
        let pairs = (digits.wrapping_mul(10 << 8 | 1) >> 8) & 0x00ff_00ff_00ff_00ff;
        let fours = (pairs.wrapping_mul(100 << 16 | 1) >> 16) & 0x0000_ffff_0000_ffff;
        let value = i64::try_from(fours.wrapping_mul(10_000 << 32 | 1) >> 32).ok()?;
        let length = bits as usize / 8 + usize::from(point);
        Some(Self { magnitude: value * scale(decimals)?, point, rounded: false, length })
    }
}

/// How many thousandths the last of so many decimals counts; `None` when they are more than three.
#[inline]
fn scale(decimals: usize) -> Option<i64> {
    [1000, 100, 10, 1].get(decimals).copied()
}

/// The value of the digits that `text` begins with, at most [`HUGE`], and what comes after them.
fn leading_digits(text: &[u8]) -> (i64, &[u8]) {
    let mut value = 0;
    let mut rest = text;
    while let [byte @ b'0'..=b'9', after @ ..] = rest {
        value = (value * 10 + i64::from(byte - b'0')).min(HUGE);
        rest = after;
    }
    (value, rest)
}

#[cfg(test)]
mod tests {
    use super::*;

    fn value(text: &str) -> Option<i64> {
        Number::parse(text.as_bytes()).map(|number| number.value.thousandths())
    }

    /// LEX-4, LEX-5.
    #[test]
    fn forms() {
        assert_eq!(value("384."), Some(384_000));
        assert_eq!(value(".12"), Some(120));
        assert_eq!(value("-0.5"), Some(-500));
        assert_eq!(value("+7"), Some(7000));
        for bad in ["", "-", ".", "-.", "1.2.3", "--5", "1-2", "1,5"] {
            assert_eq!(value(bad), None, "{bad}");
        }
    }

    /// ADR-2: to the nearest, halves away from zero.
    #[test]
    fn rounding() {
        assert_eq!(value("1.2345"), Some(1235));
        assert_eq!(value("-1.2345"), Some(-1235));
        assert_eq!(value("1.23449999"), Some(1234));
        assert!(!Number::parse(b"1.2340000").unwrap().rounded);
        assert!(Number::parse(b"1.2340001").unwrap().rounded);
        assert!(value(&"9".repeat(1000)).unwrap() >= HUGE * 1000);
    }

    proptest::proptest! {
        /// Eight bytes at once give what one after the other gives.
        #[test]
        fn eight_bytes(number in "[0-9]{0,7}(\\.[0-9]{0,4})?", rest in "[\\x00-\\x7f]{9}", any in proptest::num::u64::ANY) {
            let written = number.len();
            for bytes in [(number + &rest).into_bytes(), any.to_le_bytes().to_vec()] {
                let eight = Unsigned::in_eight(*bytes.first_chunk().unwrap());
                let read = Unsigned::read(&bytes);
                proptest::prop_assert!(eight.is_none() || eight == read, "{:?}: {:?} {:?}", bytes, eight, read);
                if eight.is_none() && let Some(read) = read {
                    let decimals = bytes.iter().take(read.length).skip_while(|byte| **byte != b'.').count();
                    proptest::prop_assert!(read.length >= 8 || decimals > 4, "{:?}: {:?}, {}", bytes, read, written);
                }
            }
        }
    }
}
