//! Letters of lines, for pictures without fonts: the same on every computer. Drawn for this project on a grid of 4 by
//! 6: x to the right, y down from the top of capitals; the base line is at 6, and two more are below it.

/// The strokes of a character, each a chain of points `xy` in digits; nothing for one that is not drawn.
const fn strokes(character: char) -> &'static [&'static str] {
    match character {
        '0' => &["103041453616050110"],
        '1' => &["112026", "1636"],
        '2' => &["0110304142060646"],
        '3' => &["01103041422313", "234445361605"],
        '4' => &["36300444"],
        '5' => &["400002324345361605"],
        '6' => &["4130100105163645433202"],
        '7' => &["004016"],
        '8' => &["103041423313020110", "133344453616050413"],
        '9' => &["443414120110304145361605"],
        'A' => &["062046", "1434"],
        'B' => &["00063645443303", "0030414233"],
        'C' => &["4130100105163645"],
        'D' => &["00062645412000"],
        'E' => &["40000646", "0333"],
        'F' => &["400006", "0333"],
        'G' => &["41301001051636454323"],
        'H' => &["0006", "4046", "0343"],
        'I' => &["2026"],
        'J' => &["4045361605"],
        'K' => &["0006", "400346"],
        'L' => &["000646"],
        'M' => &["0600234046"],
        'N' => &["06004640"],
        'Ø' => &["103041453616050110", "0640"],
        'O' => &["103041453616050110"],
        'P' => &["06003041423303"],
        'Q' => &["103041453616050110", "2446"],
        'R' => &["06003041423303", "2346"],
        'S' => &["413010010213334445361605"],
        'T' => &["0040", "2026"],
        'U' => &["000516364540"],
        'V' => &["002640"],
        'W' => &["0016233640"],
        'X' => &["0046", "4006"],
        'Y' => &["002340", "2326"],
        'Z' => &["00400646"],
        'a' => &["123243461605143444"],
        'c' => &["4332120305163645"],
        'g' => &["4332120305163645", "42473818"],
        'd' => &["4046", "44341405163645"],
        'e' => &["04444332120305163645"],
        'h' => &["0006", "0312324346"],
        'i' => &["2226", "2021"],
        'l' => &["2026"],
        'm' => &["0602", "03122226", "23324246"],
        'n' => &["0602", "0312324346"],
        'o' => &["123243453616050312"],
        'p' => &["0208", "0312324345361605"],
        'r' => &["0602", "041232"],
        's' => &["423212030414343645361605"],
        't' => &["10152636", "0232"],
        'u' => &["0205163645", "4246"],
        'w' => &["0216243642"],
        'y' => &["0226", "4206"],
        '.' => &["2526"],
        '-' => &["1333"],
        '+' => &["1333", "2224"],
        ':' => &["2122", "2526"],
        '…' => &["0506", "2526", "4546"],
        '/' => &["0640"],
        '%' => &["0640", "0001111000", "3536464535"],
        _ => &[],
    }
}

/// The lines of a text, from the left end of its base line; `size` is the height of a capital.
pub(super) fn lines(text: &str, [x, y]: [f64; 2], size: f64, advance: f64, mut line: impl FnMut(&[[f64; 2]])) {
    let step = size / 6.0;
    let mut left = x;
    for character in text.chars() {
        for stroke in strokes(character) {
            let digits: Vec<f64> = stroke.chars().filter_map(|digit| digit.to_digit(10)).map(f64::from).collect();
            let places: Vec<[f64; 2]> = digits
                .chunks_exact(2)
                .filter_map(|pair| Some([left + pair.first()? * step, y - size + pair.get(1)? * step]))
                .collect();
            line(&places);
        }
        left += advance;
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn strokes_are_chains_on_the_grid() {
        let drawn = ('\u{20}'..='\u{2100}').filter(|character| !strokes(*character).is_empty());
        assert!(drawn.clone().count() > 40);
        for (character, stroke) in
            drawn.flat_map(|character| strokes(character).iter().map(move |stroke| (character, stroke)))
        {
            let digits: Vec<u32> = stroke.chars().map(|digit| digit.to_digit(10).unwrap()).collect();
            assert!(digits.len() >= 4 && digits.len().is_multiple_of(2), "{character}: {stroke}");
            assert!(digits.chunks(2).all(|at| at[0] <= 4 && at[1] <= 8), "{character}: {stroke}");
        }
        for text in [
            "N0123456789…",
            "X Y Z mm",
            "-.",
            "yellow dots not drawn",
            "motions",
            "not the whole program",
            "assumed machine",
        ] {
            assert!(text.chars().all(|letter| letter == ' ' || !strokes(letter).is_empty()), "{text}");
        }
    }
}
