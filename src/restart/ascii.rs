//! Texts for comments of part programs: every code page has ASCII.

/// The letters of Czech and their neighbours with what is written for them without marks.
const PLAIN: [(&str, char); 30] = [
    ("áä", 'a'),
    ("čć", 'c'),
    ("ď", 'd'),
    ("éěë", 'e'),
    ("íî", 'i'),
    ("ľĺ", 'l'),
    ("ňń", 'n'),
    ("óôöő", 'o'),
    ("řŕ", 'r'),
    ("šśß", 's'),
    ("ť", 't'),
    ("úůüű", 'u'),
    ("ý", 'y'),
    ("žźż", 'z'),
    ("ÁÄ", 'A'),
    ("ČĆ", 'C'),
    ("Ď", 'D'),
    ("ÉĚË", 'E'),
    ("ÍÎ", 'I'),
    ("ĽĹ", 'L'),
    ("ŇŃ", 'N'),
    ("ÓÔÖŐ", 'O'),
    ("ŘŔ", 'R'),
    ("ŠŚ", 'S'),
    ("Ť", 'T'),
    ("ÚŮÜŰ", 'U'),
    ("Ý", 'Y'),
    ("ŽŹŻ", 'Z'),
    ("„“”\"", '\''),
    ("–—", '-'),
];

/// The text in ASCII without quotes and control characters; what has no likeness becomes `_`.
pub(super) fn ascii(text: &str) -> String {
    let plain = |character: char| match character {
        ' '..='~' if character != '"' => character,
        _ => PLAIN.iter().find(|(marked, _)| marked.contains(character)).map_or('_', |(_, plain)| *plain),
    };
    text.chars().map(plain).collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn what_every_code_page_has() {
        assert_eq!(ascii("příruba „A“\u{7}\"µ"), "priruba 'A'_'_");
    }
}
