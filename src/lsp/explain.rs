//! The pages of findings as documents of the editor.

use gen_lsp_types::{TextDocumentContentParams, TextDocumentContentResult};
use lsp_server::ErrorCode;

use super::findings::SCHEME;
use super::requests::{Answer, Refusal, Snapshot};
use crate::diag::Code;
use crate::dict::Lang;

/// The text of `cnc872c:/explain/LANG/CODE.md`.
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
    let code = Code::find(name.strip_suffix(".md")?)?;
    (scheme == SCHEME).then(|| code.page(lang).to_owned())
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn pages() {
        assert_eq!(page(SCHEME, "/explain/cs/E0307.md").as_deref(), Some(Code::E0307.page(Lang::Cs)));
        for path in ["/explain/de/E0307.md", "/explain/en/E9999.md", "/explain/en/E0307", "/E0307.md", ""] {
            assert_eq!(page(SCHEME, path), None, "{path}");
        }
        assert_eq!(page("file", "/explain/en/E0307.md"), None);
    }
}
