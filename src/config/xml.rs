//! XML, parsed with its faults in our own words (E0701). Nothing but the text itself is ever read: external entities
//! stay unknown, and declarations of internal ones, with which a small text could swell without end, are refused.

use std::collections::HashSet;

use roxmltree::{Document, Error, ParsingOptions, TextPos};

use super::reader::to_span;
use crate::diag::{ConfigProblem, shown};
use crate::sure::Sure;
use crate::text::{SourceText, Span};

/// Most attributes of one element: the parser compares each with each.
const MOST_ATTRIBUTES: usize = 2_000;
/// Most entries of namespaces: each element that declares one gets a list of all that are in force.
const MOST_NAMESPACES: usize = 10_000_000;

/// The document that `source` holds, in time and memory that grow with its length, however deep its elements are
/// nested.
///
/// # Errors
/// The mistake and its place, when it is not well-formed or asks for more than is read.
pub(super) fn parse(source: &SourceText) -> Result<Document<'_>, (ConfigProblem, Span)> {
    let text = source.text();
    if let Some(entity) = declared_entity(text) {
        return Err((ConfigProblem::EntityDeclared, entity));
    }
    if let Some(element) = overloaded(text) {
        return Err((ConfigProblem::TooMany, element));
    }
    let options = ParsingOptions { allow_dtd: true, ..ParsingOptions::default() };
    Document::parse_with_options(text, options).map_err(|error| {
        let end = Span::empty(to_span(0..text.trim_end().len()).end);
        let ended = matches!(error, Error::UnclosedRootNode | Error::UnexpectedEndOfStream | Error::NoRootNode);
        let at = Some(error.pos()).filter(|_| !ended).and_then(|place| offset(text, place));
        let at = at.map_or(end, Span::empty);
        (problem(&error, text, at), at)
    })
}

/// The place of the first declaration of an internal entity.
fn declared_entity(text: &str) -> Option<Span> {
    let declaration = "<!ENTITY";
    text.find("<!DOCTYPE")?;
    text.match_indices(declaration).map(|(at, _)| at).find_map(|at| {
        let rest = text.get(at + declaration.len()..)?.trim_start();
        let rest = rest.strip_prefix('%').map_or(rest, str::trim_start);
        let value = rest.trim_start_matches(|c: char| !c.is_whitespace()).trim_start();
        value.starts_with(['"', '\'']).then(|| to_span(at..at + declaration.len()))
    })
}

/// The place of the first element with more attributes, or more namespaces in force, than are read.
fn overloaded(text: &str) -> Option<Span> {
    let bytes = text.as_bytes();
    let mut prefixes = HashSet::new();
    let mut declarations = 0_usize;
    let mut at = 0;
    while let Some(found) = bytes.get(at..).and_then(|rest| memchr::memchr(b'<', rest)) {
        let start = at + found;
        let rest = text.get(start..).sure();
        let skipped = [("<!--", "-->"), ("<![CDATA[", "]]>"), ("<?", "?>")];
        if let Some((_, close)) = skipped.into_iter().find(|(open, _)| rest.starts_with(open)) {
            // Without its end the text is malformed, and nothing after it counts.
            at = start + rest.find(close)?;
            continue;
        }
        let mut attributes = 0;
        let mut place = start + 1;
        while let Some((name, end)) = attribute(text, place) {
            attributes += 1;
            place = end;
            if let Some(prefix) = name.strip_prefix("xmlns") {
                declarations += 1;
                prefixes.insert(prefix);
            }
        }
        if attributes > MOST_ATTRIBUTES || declarations.saturating_mul(prefixes.len()) > MOST_NAMESPACES {
            return Some(to_span(start..start + 1));
        }
        at = place;
    }
    None
}

/// The next attribute of the tag that goes on at `from`: its name and where it ends.
fn attribute(text: &str, from: usize) -> Option<(&str, usize)> {
    let rest = text.get(from..)?;
    let quote = rest.find(['"', '\'', '>', '<'])?;
    let (before, value) = rest.split_at_checked(quote)?;
    let delimiter = value.chars().next().filter(|c| ['"', '\''].contains(c))?;
    let length = value.get(1..)?.find([delimiter, '<'])?;
    let end = from + quote + 1 + length;
    let name = before.trim_end().strip_suffix('=')?.trim_end();
    let name = name.rsplit(char::is_whitespace).next()?;
    (text.as_bytes().get(end) != Some(&b'<')).then_some((name, end + 1))
}

/// The offset of a line and column as the parser counts them: lines end with LF, columns are characters.
fn offset(text: &str, at: TextPos) -> Option<u32> {
    let line = usize::try_from(at.row).ok()?.checked_sub(1)?;
    let column = usize::try_from(at.col).ok()?.checked_sub(1)?;
    let start = match line.checked_sub(1) {
        None => 0,
        Some(before) => memchr::memchr_iter(b'\n', text.as_bytes()).nth(before)? + 1,
    };
    let rest = text.get(start..)?;
    let within = rest.char_indices().map(|(at, _)| at).chain([rest.len()]).nth(column)?;
    u32::try_from(start + within).ok()
}

fn problem(error: &Error, text: &str, at: Span) -> ConfigProblem {
    match error {
        Error::UnexpectedCloseTag(expected, actual, _) => {
            ConfigProblem::ClosingTag { expected: shown(expected), actual: shown(actual) }
        }
        Error::UnclosedRootNode | Error::UnexpectedEndOfStream => ConfigProblem::ElementOpen,
        Error::NoRootNode if text.rfind('<') > text.rfind('>') => ConfigProblem::ElementOpen,
        Error::NoRootNode => ConfigProblem::NoElement,
        Error::DuplicatedAttribute(name, _) => ConfigProblem::AttributeTwice { name: shown(name) },
        Error::DuplicatedNamespace(name, _) => ConfigProblem::AttributeTwice { name: shown(&format!("xmlns:{name}")) },
        Error::UnknownEntityReference(name, _) => ConfigProblem::UnknownEntity { name: shown(name) },
        Error::MalformedEntityReference(_) => ConfigProblem::Ampersand,
        Error::InvalidAttributeValue(_) => ConfigProblem::LessThan,
        Error::InvalidChar(..) if text.get(at.start as usize..).is_some_and(|rest| rest.starts_with('<')) => {
            ConfigProblem::LessThan
        }
        Error::UnknownNamespace(prefix, _) => ConfigProblem::UnknownPrefix { prefix: shown(prefix) },
        Error::UnexpectedDeclaration(_) => ConfigProblem::DeclarationPlace,
        Error::InvalidComment(_) => ConfigProblem::CommentForm,
        Error::NonXmlChar(..) => ConfigProblem::ControlCharacter,
        Error::NodesLimitReached | Error::AttributesLimitReached | Error::NamespacesLimitReached => {
            ConfigProblem::TooMany
        }
        Error::InvalidXmlPrefixUri(_)
        | Error::UnexpectedXmlUri(_)
        | Error::UnexpectedXmlnsUri(_)
        | Error::InvalidElementNamePrefix(_)
        | Error::UnexpectedEntityCloseTag(_)
        | Error::EntityReferenceLoop(_)
        | Error::DtdDetected
        | Error::InvalidName(_)
        | Error::InvalidChar(..)
        | Error::InvalidChar2(..)
        | Error::InvalidString(..)
        | Error::InvalidExternalID(_)
        | Error::EntityResolver(..)
        | Error::InvalidCharacterData(_)
        | Error::UnknownToken(_) => ConfigProblem::NotXml,
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn fault(text: &str) -> (ConfigProblem, u32) {
        let source = SourceText::from_text("c.xml", text);
        let (problem, at) = parse(&source).map(|_| ()).expect_err(text);
        (problem, at.start)
    }

    fn is_read(text: &str) -> bool {
        parse(&SourceText::from_text("c.xml", text)).is_ok()
    }

    /// §11: malformed XML, each fault at its place and in our words.
    #[test]
    fn faults_and_places() {
        let name = |name: &str| name.to_owned();
        for (text, expected, at) in [
            ("<a>\n <b></a>", ConfigProblem::ClosingTag { expected: name("b"), actual: name("a") }, 8),
            ("<a>\n <b/>\n", ConfigProblem::ElementOpen, 9),
            ("<a", ConfigProblem::ElementOpen, 2),
            ("", ConfigProblem::NoElement, 0),
            ("<!-- č -->", ConfigProblem::NoElement, 11),
            ("<a x='1' x='2'/>", ConfigProblem::AttributeTwice { name: name("x") }, 9),
            ("<a>č &x;</a>", ConfigProblem::UnknownEntity { name: name("x") }, 6),
            ("<a>č & x</a>", ConfigProblem::Ampersand, 6),
            ("<a x='<'/>", ConfigProblem::LessThan, 6),
            ("<a x 1='2'/>", ConfigProblem::NotXml, 5),
            ("<p:a/>", ConfigProblem::UnknownPrefix { prefix: name("p") }, 1),
            ("\n<?xml version='1.0'?><a/>", ConfigProblem::DeclarationPlace, 1),
            ("<a><!-- -- --></a>", ConfigProblem::CommentForm, 3),
            ("<a>\u{1}</a>", ConfigProblem::ControlCharacter, 3),
            ("No=1", ConfigProblem::NotXml, 0),
            ("<a/><b/>", ConfigProblem::NotXml, 4),
        ] {
            assert_eq!(fault(text), (expected, at), "{text}");
        }
    }

    /// Lines end with CR LF too, and a byte-order mark takes no column.
    #[test]
    fn places_after_cr_lf_and_bom() {
        let source = SourceText::from_text("c.xml", "\u{feff}<a>\r\n <č></a>");
        let (_, at) = parse(&source).map(|_| ()).expect_err("not closed");
        let place = source.line_column(at.start);
        assert_eq!((place.line, place.column), (2, 5));
        assert!(is_read("\u{feff}<?xml version=\"1.0\" encoding=\"utf-8\"?><a/>"));
    }

    /// §11: external entities are never fetched; a document type that only names them is no fault.
    #[test]
    fn entities() {
        assert!(is_read("<!DOCTYPE a SYSTEM \"http://example.invalid/a.dtd\"><a/>"));
        assert!(is_read("<!DOCTYPE a [<!ENTITY x SYSTEM \"file:///etc/passwd\">]><a/>"));
        assert_eq!(
            fault("<!DOCTYPE a [<!ENTITY x SYSTEM \"file:///etc/passwd\">]><a>&x;</a>").0,
            ConfigProblem::UnknownEntity { name: "x".to_owned() }
        );
        assert_eq!(fault("<!DOCTYPE a [<!ENTITY x 'y'>]><a>&x;</a>"), (ConfigProblem::EntityDeclared, 13));
        assert_eq!(fault("<!DOCTYPE a [<!ENTITY % x 'y'>]><a/>"), (ConfigProblem::EntityDeclared, 13));
        assert!(is_read("<a><!-- <!ENTITY x 'y'> --></a>"));
        let source = SourceText::from_text("c.xml", "<!DOCTYPE a [<!ENTITY x 'y'>]><a>&x;</a>");
        assert_eq!(source.slice(parse(&source).map(|_| ()).expect_err("declares").1), "<!ENTITY");
        assert!(is_read("<a x='&lt;&amp;&#65;'/>"));
    }

    /// Nesting needs no stack, and what would take quadratic time or memory is refused.
    #[test]
    fn large_and_deep_documents() {
        let count = 100_000;
        assert!(is_read(&format!("{}{}", "<a>".repeat(count), "</a>".repeat(count))));
        assert_eq!(fault(&"<a>".repeat(count)).0, ConfigProblem::ElementOpen);
        assert!(is_read(&format!("<a>{}</a>", "<b x='1' y=\"a>b\"/>\n".repeat(count))));
        let attributes: String = (0..count).map(|i| format!(" a{i}='1'")).collect();
        assert_eq!(fault(&format!("<r><a{attributes}/></r>")), (ConfigProblem::TooMany, 3));
        let attributes = |count: usize| (0..count).map(|i| format!(" a{i}='1'")).collect::<String>();
        assert!(is_read(&format!("<r><a{}/></r>", attributes(MOST_ATTRIBUTES))));
        let refused = format!("<r><a/><a{}/></r>", attributes(MOST_ATTRIBUTES + 1));
        assert_eq!(fault(&refused), (ConfigProblem::TooMany, 7));
        let quoted = |count: usize| (0..count).map(|i| format!(" a{i} = \"b='1' c='2'\"")).collect::<String>();
        assert!(is_read(&format!("<r><a{}/></r>", quoted(MOST_ATTRIBUTES))));
        assert_eq!(fault(&format!("<r><a{}/></r>", quoted(MOST_ATTRIBUTES + 1))).0, ConfigProblem::TooMany);
        let declarations =
            |count: usize| (0..count).map(|i| format!("<a xmlns:n{}='u'>", i % 2_500)).collect::<String>();
        assert_eq!(overloaded(&declarations(MOST_NAMESPACES / 2_500)), None);
        assert!(overloaded(&declarations(MOST_NAMESPACES / 2_500 + 1)).is_some());
        let namespaces: String = (0..count).map(|i| format!("<a xmlns:n{i}='{i}'>")).collect();
        assert_eq!(fault(&namespaces).0, ConfigProblem::TooMany);
        assert!(is_read(&format!("<a>{}</a>", "<b xmlns:x='urn:x' x:y='1'/>".repeat(count))));
    }
}
