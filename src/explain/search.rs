//! Which pages mention a word: `explain posuv`, `explain radius`.

use super::Topic;
use crate::dict::Lang;

/// A page that has the words.
#[derive(Clone, Debug)]
pub struct Hit {
    /// The topic.
    pub topic: Topic,
    /// Whether its title has the words, not only its text.
    pub in_title: bool,
}

/// Most letters that an ending has: `vrtání`, `vrtat`, `vrtací` are one word.
const ENDING: usize = 3;
/// Letters that are left of a word without its ending.
const STEM: usize = 4;

/// The pages that have words which begin with those of `query`, in either language; upper and lower case, and letters
/// with and without accents, are alike. Those with the words in their titles come first.
pub fn search(query: &str) -> Vec<Hit> {
    pages(&words(query))
}

/// The same, whatever endings the words have.
pub fn search_stems(query: &str) -> Vec<Hit> {
    let mut wanted = words(query);
    for word in &mut wanted {
        let letters = word.chars().count();
        *word = word.chars().take(letters.saturating_sub(ENDING).max(STEM)).collect();
    }
    pages(&wanted)
}

fn pages(wanted: &[String]) -> Vec<Hit> {
    if wanted.is_empty() {
        return Vec::new();
    }
    let has = |text: &str| {
        let there = words(text);
        wanted.iter().all(|wanted| there.iter().any(|word| word.starts_with(wanted.as_str())))
    };
    let hit = |topic: Topic| {
        let langs = [Lang::En, Lang::Cs];
        let in_title = langs.iter().any(|&lang| has(&topic.title(lang)));
        (in_title || langs.iter().any(|&lang| has(&topic.page(lang)))).then_some(Hit { topic, in_title })
    };
    let mut hits: Vec<Hit> = Topic::all().filter_map(hit).collect();
    hits.sort_by_key(|hit| !hit.in_title);
    hits
}

/// The words of a text, in lower case and without accents.
fn words(text: &str) -> Vec<String> {
    let folded: String = text.chars().flat_map(char::to_lowercase).map(without_accent).collect();
    folded.split(|c: char| !c.is_alphanumeric()).filter(|word| !word.is_empty()).map(str::to_owned).collect()
}

/// A Czech letter without its accent.
const fn without_accent(letter: char) -> char {
    match letter {
        'á' => 'a',
        'č' => 'c',
        'ď' => 'd',
        'é' | 'ě' => 'e',
        'í' => 'i',
        'ň' => 'n',
        'ó' => 'o',
        'ř' => 'r',
        'š' => 's',
        'ť' => 't',
        'ú' | 'ů' => 'u',
        'ý' => 'y',
        'ž' => 'z',
        other => other,
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn names(query: &str) -> Vec<String> {
        search(query).into_iter().map(|hit| hit.topic.name()).collect()
    }

    #[test]
    fn words_of_either_language() {
        let feed = names("posuv");
        for name in ["G94", "G95", "F", "limits.feed", "W0601"] {
            assert!(feed.contains(&name.to_owned()), "{name}: {feed:?}");
        }
        let radius = names("radius");
        for name in ["G41", "G02", "corrections.radius", "E0603"] {
            assert!(radius.contains(&name.to_owned()), "{name}: {radius:?}");
        }
        assert_eq!(names("rezna rychlost"), names("Řezná RYCHLOST"));
        for query in ["vrtání", "vrtat", "Vrtání"] {
            let drilling: Vec<String> = search_stems(query).into_iter().map(|hit| hit.topic.name()).collect();
            assert!(drilling.contains(&"G81".to_owned()), "{drilling:?}");
        }
        assert!(names("řezná rychlost").contains(&"G96".to_owned()));
        // Titles first.
        let hits = search("posuv");
        assert!(hits.windows(2).all(|pair| pair[0].in_title >= pair[1].in_title));
    }

    #[test]
    fn nothing_is_found_for_nothing() {
        assert!(names("").is_empty() && names("  --").is_empty() && names("qwertz").is_empty());
    }
}
