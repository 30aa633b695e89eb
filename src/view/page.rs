//! The page: one file of HTML with the viewer, its styles and the data. Nothing is fetched.

use super::container::text;
use crate::dict::Lang;

/// The viewer, built from `web/` (see `web/build.mjs`).
const VIEWER: &str = include_str!("viewer/viewer.js");
/// Its styles.
const STYLES: &str = include_str!("viewer/viewer.css");

/// The page for the data of a program. `old`: the data of the program it is compared with. `lang`: the language when it
/// is not the browser's.
pub fn page(data: &[u8], old: Option<&[u8]>, name: &str, lang: Option<Lang>) -> String {
    let (data, old) = (text(data), old.map(text).unwrap_or_default());
    let lang = lang.map_or("", |lang| lang.code());
    let mut page = String::with_capacity(data.len() + old.len() + VIEWER.len() + STYLES.len() + 2048);
    page.push_str("<!doctype html>\n<html lang=\"");
    page.push_str(if lang.is_empty() { "en" } else { lang });
    page.push_str("\" data-lang=\"");
    page.push_str(lang);
    page.push_str("\">\n<head>\n<meta charset=\"utf-8\">\n");
    page.push_str(
        "<meta http-equiv=\"Content-Security-Policy\" content=\"default-src 'none'; script-src 'unsafe-inline'; ",
    );
    page.push_str("style-src 'unsafe-inline'; img-src data: blob:\">\n");
    page.push_str("<meta name=\"viewport\" content=\"width=device-width, initial-scale=1\">\n<title>");
    page.push_str(&escaped(name));
    page.push_str("</title>\n<style>");
    page.push_str(STYLES);
    page.push_str("</style>\n</head>\n<body>\n<noscript>JavaScript</noscript>\n");
    for (id, data) in [("cnc872c-data", data), ("cnc872c-old", old)] {
        if !data.is_empty() {
            page.push_str(&format!("<script type=\"text/plain\" id=\"{id}\">"));
            page.push_str(&data);
            page.push_str("</script>\n");
        }
    }
    page.push_str("<script>");
    page.push_str(VIEWER);
    page.push_str("</script>\n</body>\n</html>\n");
    page
}

/// Text between tags.
pub(super) fn escaped(text: &str) -> String {
    let safe = |character: char| if character.is_control() { '\u{FFFD}' } else { character };
    text.chars().map(safe).collect::<String>().replace('&', "&amp;").replace('<', "&lt;").replace('>', "&gt;")
}

#[cfg(test)]
mod tests {
    use super::*;

    /// One word for one thing.
    #[test]
    #[expect(clippy::disallowed_methods, reason = "the viewer's source")]
    fn reasons_at_joints_have_the_texts_of_motion() {
        use crate::analysis::motion::{Break, Limit};
        let path = concat!(env!("CARGO_MANIFEST_DIR"), "/web/src/i18n.ts");
        let texts = std::fs::read_to_string(path).unwrap();
        let has = |key: String, text: &dyn Fn(Lang) -> String| {
            let line = format!("  {key}: ['{}', '{}'],\n", text(Lang::En), text(Lang::Cs));
            assert!(texts.contains(&line), "{line}");
        };
        for reason in Break::ALL {
            has(format!("broken_{}", reason.name()), &|lang| reason.text(lang));
        }
        for reason in Limit::ALL {
            has(format!("limited_{}", reason.name()), &|lang| reason.text(lang));
        }
    }

    #[test]
    fn what_the_page_embeds_ends_no_script() {
        assert!(!VIEWER.contains("</script"), "web/build.mjs writes <\\/script");
        assert!(!VIEWER.contains("<!--"));
        assert!(!STYLES.contains("</style"));
        let page = page(&[60; 100], Some(&[60; 9]), "<a> & b", None);
        assert_eq!(page.matches("</script>").count(), 3);
        assert!(page.contains("<title>&lt;a&gt; &amp; b</title>"));
    }
}
