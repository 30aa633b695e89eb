//! The pages of `explain` as documents of the editor.

use gen_lsp_types::{TextDocumentContentParams, TextDocumentContentResult};
use lsp_server::ErrorCode;

use super::findings::SCHEME;
use super::snapshot::{Answer, Refusal, Snapshot};
use crate::dict::Lang;
use crate::explain::Topic;

/// The text of `cnc872c:/explain/LANG/NAME.md`: a finding by its code, a function, an address, a key of the project
/// file.
pub(super) fn text_document_content(
    _: &Snapshot,
    params: TextDocumentContentParams,
) -> Answer<TextDocumentContentResult> {
    let text = page(params.uri.scheme(), params.uri.path());
    text.map(|text| TextDocumentContentResult { text })
        .ok_or_else(|| Refusal { code: ErrorCode::InvalidParams, message: format!("no such document: {}", params.uri) })
}

fn page(scheme: &str, path: &str) -> Option<String> {
    let (lang, name) = path.strip_prefix("/explain/")?.split_once('/')?;
    let lang = match lang {
        "en" => Lang::En,
        "cs" => Lang::Cs,
        _ => return None,
    };
    if scheme != SCHEME {
        return None;
    }
    // The two addresses that a path has to write otherwise.
    let name = name.strip_suffix(".md")?.replace("%25", "%").replace("%26", "&");
    let topics = Topic::find(&name).ok()?;
    let pages: Vec<String> = topics.into_iter().map(|topic| topic.page(lang)).collect();
    Some(pages.join("\n"))
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::diag::Code;

    #[test]
    fn pages() {
        assert_eq!(page(SCHEME, "/explain/cs/E0307.md").as_deref(), Some(Code::E0307.page(Lang::Cs)));
        for (path, begin) in [
            ("/explain/en/G73.md", "# G73: jump"),
            ("/explain/cs/M19.md", "# M19: "),
            ("/explain/en/%25.md", "# %: program number"),
            ("/explain/en/&.md", "# &: "),
            ("/explain/cs/limits.feed.md", "# limits.feed: "),
        ] {
            assert!(page(SCHEME, path).unwrap().starts_with(begin), "{path}");
        }
        for path in ["/explain/de/E0307.md", "/explain/en/E9999.md", "/explain/en/E0307", "/E0307.md", ""] {
            assert_eq!(page(SCHEME, path), None, "{path}");
        }
        assert_eq!(page("file", "/explain/en/E0307.md"), None);
    }
}
