//! `MFunctions` of a ChannelConfig (MFN-2, MFN-3; S0 8.3.5).

use roxmltree::{Attribute, Node};

use super::mfunctions::ChannelList;
use super::near::nearest;
use super::reader::to_span;
use super::{MFunction, MFunctions, xml};
use crate::diag::{ConfigNeed, Diagnostic, Finding, Findings, LabelText, NameKind, shown};
use crate::sure::Sure;
use crate::text::{FileId, Location, SourceText, Span};

/// The element that holds the M functions.
const LIST: &str = "MFunctions";
/// One M function: as in the examples of S0, and as in its table.
const ELEMENTS: [&str; 2] = ["MFunc", "MFuncs"];
/// The attributes of one M function.
const ATTRIBUTES: [&str; 5] = ["No", "GroupNo", "BreakCont", "BreakContEnd", "ChangePos"];
/// Highest M number that can be configured.
const HIGHEST_M: u8 = 100;
/// Highest M group.
const HIGHEST_GROUP: u8 = 14;

/// Sets the functions that the ChannelConfig `source`, which is `file` of the run, names. E0701 when it is no XML;
/// E0702 for values of the wrong form or range, E0703 for a standard function in another group, E0704 for one number
/// with different data, W0705 for unknown attributes, W0708 for a document without `MFunctions`; what one of these is
/// found of is not set.
pub(super) fn read(source: &SourceText, file: FileId, functions: &mut MFunctions, findings: &mut Findings) {
    let document = match xml::parse(source) {
        Ok(document) => document,
        Err((reason, span)) => {
            let at = Location { file, span };
            findings.add(Diagnostic::new(Finding::UnreadableConfiguration { reason }, at));
            return;
        }
    };
    let mut lists = document.descendants().filter(|node| node.tag_name().name() == LIST).peekable();
    let missing = lists.peek().is_none();
    functions.set_channel(if missing { ChannelList::Missing } else { ChannelList::Read });
    let mut reader = Reader { file, source, functions, findings, seen: Vec::new() };
    if missing {
        let at = reader.tag_name(document.root_element());
        reader.add(Finding::NoMFunctions {}, at);
    }
    for list in lists {
        for element in list.children().filter(Node::is_element) {
            reader.element(element);
        }
    }
}

/// A function that the document names, and where its number stands.
type Named = (MFunction, Span);

struct Reader<'a> {
    file: FileId,
    source: &'a SourceText,
    functions: &'a mut MFunctions,
    findings: &'a mut Findings,
    seen: Vec<Named>,
}

impl Reader<'_> {
    fn element(&mut self, element: Node<'_, '_>) {
        let name = element.tag_name().name();
        if ELEMENTS.contains(&name) {
            self.unknown_attributes(element);
            self.function(element);
        } else if let Some(near) = nearest(name, ELEMENTS) {
            // A misspelled element would be passed over in silence, and its function lost.
            self.unknown(NameKind::Element, name, self.tag_name(element), Some(near));
        }
    }

    fn unknown_attributes(&mut self, element: Node<'_, '_>) {
        for attribute in element.attributes().filter(|attribute| attribute.namespace().is_none()) {
            let name = attribute.name();
            if !ATTRIBUTES.contains(&name) {
                self.unknown(NameKind::Attribute, name, to_span(attribute.range_qname()), nearest(name, ATTRIBUTES));
            }
        }
    }

    fn function(&mut self, element: Node<'_, '_>) {
        let attribute = |name| element.attribute_node(name);
        let number = attribute("No").map(|no| self.number(no, 0, HIGHEST_M));
        let group = attribute("GroupNo").map(|group| self.number(group, 1, HIGHEST_GROUP));
        let [break_cont, break_cont_end, change_pos] = ["BreakCont", "BreakContEnd", "ChangePos"]
            .map(|name| attribute(name).map_or(Some(0), |flag| self.number(flag, 0, 1)).map(|value| value == 1));
        let Some(number) = number else {
            let needs = ConfigNeed::Missing { key: "No".to_owned() };
            let finding = Finding::ConfigurationValue { key: element.tag_name().name().to_owned(), needs };
            self.add(finding, self.tag_name(element));
            return;
        };
        let (Some(number), Some(break_cont), Some(break_cont_end), Some(change_pos)) =
            (number, break_cont, break_cont_end, change_pos)
        else {
            return;
        };
        let Some(known) = self.functions.get(number) else {
            return;
        };
        let own = if known.standard { known.group } else { HIGHEST_GROUP };
        let Some(group) = group.unwrap_or(Some(own)) else {
            return;
        };
        if known.standard && group != own {
            let at = attribute("GroupNo").map_or(Span::default(), |group| value_span(&group));
            self.add(Finding::MFunctionFixed { m: number, group: own }, at);
            return;
        }
        let function = MFunction { group, configured: true, break_cont, break_cont_end, change_pos, ..known };
        self.set(function, attribute("No").map_or(Span::default(), |no| value_span(&no)));
    }

    /// Sets a function, unless the document has named it before.
    fn set(&mut self, function: MFunction, at: Span) {
        match self.seen.iter().find(|(other, _)| other.number == function.number) {
            None => {
                self.seen.push((function, at));
                self.functions.set(function);
            }
            Some((other, _)) if *other == function => {}
            Some(&(_, first)) => {
                let first = Location { file: self.file, span: first };
                let at = Location { file: self.file, span: at };
                let finding = Finding::MFunctionRepeated { m: function.number };
                self.findings.add(
                    Diagnostic::new(finding, at)
                        .with_label(first, LabelText::First { what: format!("M{:02}", function.number) }),
                );
            }
        }
    }

    /// The whole number of an attribute, or a finding at its value.
    fn number(&mut self, attribute: Attribute<'_, '_>, min: u8, max: u8) -> Option<u8> {
        let text = attribute.value().trim_ascii();
        let digits = !text.is_empty() && text.bytes().all(|byte| byte.is_ascii_digit());
        let number = text.parse::<u8>().ok().filter(|number| digits && (min..=max).contains(number));
        if number.is_none() {
            let needs = if max == 1 {
                ConfigNeed::ZeroOrOne
            } else {
                ConfigNeed::Whole { min: i64::from(min), max: i64::from(max) }
            };
            let key = attribute.name().to_owned();
            self.add(Finding::ConfigurationValue { key, needs }, value_span(&attribute));
        }
        number
    }

    fn unknown(&mut self, kind: NameKind, name: &str, at: Span, near: Option<String>) {
        self.add(Finding::UnknownConfigurationKey { kind, key: shown(name), near, known: None }, at);
    }

    fn add(&mut self, finding: Finding, span: Span) {
        self.findings.add(Diagnostic::new(finding, Location { file: self.file, span }));
    }

    /// The name in the start tag of an element.
    fn tag_name(&self, element: Node<'_, '_>) -> Span {
        let start = element.range().start + 1;
        let rest = self.source.text().get(start..).sure();
        let length = rest.find(|c: char| c.is_whitespace() || c == '/' || c == '>').unwrap_or(rest.len());
        to_span(start..start + length)
    }
}

/// The value of an attribute, without its quotes.
fn value_span(attribute: &Attribute<'_, '_>) -> Span {
    to_span(attribute.range_value())
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::diag::Code;
    use crate::dict::{Dialect, Lang};

    fn read_text(text: &str) -> (MFunctions, Vec<Diagnostic>, SourceText) {
        let source = SourceText::from_text("c.xml", text);
        let mut functions = MFunctions::standard(Dialect::Cnc872);
        let mut findings = Findings::new();
        read(&source, FileId(0), &mut functions, &mut findings);
        (functions, findings.into_sorted(), source)
    }

    /// The codes with the text at their places.
    fn found(text: &str) -> Vec<(Code, String)> {
        let (_, findings, source) = read_text(text);
        findings.iter().map(|found| (found.code(), source.slice(found.at.span).to_owned())).collect()
    }

    fn one(attributes: &str) -> String {
        format!("<MFunctions><MFunc {attributes}/></MFunctions>")
    }

    /// S0 8.3.5: the manual's own example.
    const EXAMPLE: &str = r#"
 <ChannelConfig><Other><MFunctions>
   <!-- Skupina 9 -->
  <MFunc No="6" GroupNo="9" BreakCont="1" ChangePos="1"></MFunc>
   <!-- Skupina 10 -->
  <MFunc No="91" GroupNo="10" BreakCont="1"></MFunc>
  <MFuncs No="95" GroupNo="11" BreakContEnd="1"/>
  <MFunc No="096"/>
 </MFunctions></Other><MFunctions><MFunc No='3' BreakCont=' 1 '/></MFunctions></ChannelConfig>"#;

    /// MFN-2, MFN-3, MFN-4.
    #[test]
    fn example_of_the_manual() {
        let (functions, findings, _) = read_text(EXAMPLE);
        assert!(findings.is_empty(), "{findings:?}");
        let configured: Vec<_> = functions.configured().map(|m| (m.number, m.group, m.standard)).collect();
        assert_eq!(configured, [(3, 2, true), (6, 9, true), (91, 10, false), (95, 11, false), (96, 14, false)]);
        let m6 = functions.get(6).unwrap();
        assert_eq!((m6.break_cont, m6.break_cont_end, m6.change_pos), (true, false, true));
        assert!(functions.get(95).unwrap().break_cont_end);
        assert!(functions.get(3).unwrap().break_cont);
        assert_eq!(functions.defaults()[2], Some(5));
    }

    /// MFN-3: new functions may go to any group.
    #[test]
    fn new_functions_in_any_group() {
        for group in 1..=14 {
            let (functions, findings, _) = read_text(&one(&format!("No='100' GroupNo='{group}'")));
            assert!(findings.is_empty());
            assert_eq!(functions.group(100), group);
        }
    }

    #[test]
    fn numbers_out_of_range_or_form() {
        for (attributes, at) in [
            ("No='101'", "101"),
            ("No='-1'", "-1"),
            ("No='6.0'", "6.0"),
            ("No='+6'", "+6"),
            ("No='M6'", "M6"),
            ("No=''", ""),
            ("No='99999999999999999999'", "99999999999999999999"),
            ("No='91' GroupNo='0'", "0"),
            ("No='91' GroupNo = '15'", "15"),
            ("No='6' GroupNo='x'", "x"),
            ("No='91' BreakCont='2'", "2"),
            ("No='91' BreakContEnd='ano'", "ano"),
            ("No='91' ChangePos='-1'", "-1"),
        ] {
            assert_eq!(found(&one(attributes)), [(Code::E0702, at.to_owned())], "{attributes}");
        }
    }

    #[test]
    fn a_function_without_number() {
        assert_eq!(found(&one("GroupNo='10'")), [(Code::E0702, "MFunc".to_owned())]);
        let (_, findings, _) = read_text(&one(""));
        assert_eq!(findings[0].finding.message(Lang::Cs), "MFunc nemá uvedeno No");
    }

    /// MFN-3.
    #[test]
    fn a_standard_function_keeps_its_group() {
        assert_eq!(found(&one("No='8' GroupNo='12'")), [(Code::E0703, "12".to_owned())]);
        assert_eq!(found(&one("No='30' GroupNo='14'")), [(Code::E0703, "14".to_owned())]);
        assert_eq!(found(&one("No='36' GroupNo='12'")), [], "M36 is no standard function of CNC872");
    }

    #[test]
    fn the_same_number_twice() {
        let text = "<MFunctions><MFunc No='91' GroupNo='10'/><MFunc No='091' GroupNo='11'/></MFunctions>";
        let (functions, findings, source) = read_text(text);
        assert_eq!(found(text), [(Code::E0704, "091".to_owned())]);
        assert_eq!(source.slice(findings[0].labels[0].at.span), "91");
        assert_eq!(functions.group(91), 10);
        let same = "<MFunctions><MFunc No='6'/><MFunc No='6' GroupNo='9' BreakCont='0'/></MFunctions>";
        assert_eq!(found(same), []);
    }

    #[test]
    fn unknown_names() {
        assert_eq!(found(&one("No='91' BreakCount='1'")), [(Code::W0705, "BreakCount".to_owned())]);
        let (_, findings, _) = read_text(&one("no='91'"));
        let help = findings.iter().find_map(|found| found.finding.help(Lang::En)).unwrap();
        assert!(help.contains("`No`"), "{help}");
        let others = "<MFunctions xmlns:x='urn:x'><MFunc x:note='1' No='91'/><Comment/><Mfunc No='92'/></MFunctions>";
        assert_eq!(found(others), [(Code::W0705, "Mfunc".to_owned())]);
        assert_eq!(found("<MFunctions><Mfunc/></MFunctions>"), [(Code::W0705, "Mfunc".to_owned())]);
        assert_eq!(found("<MFunctions><Mfunc></Mfunc></MFunctions>"), [(Code::W0705, "Mfunc".to_owned())]);
    }

    #[test]
    fn elements_elsewhere_are_not_read() {
        assert_eq!(found("<a><MFunc No='8' GroupNo='12'/><MFunctions/></a>"), []);
        assert_eq!(found("<a b='&x;'/>"), [(Code::E0701, String::new())]);
    }

    /// Any depth and size around the functions.
    #[test]
    fn large_documents() {
        let (open, close) = ("<a>".repeat(100_000), "</a>".repeat(100_000));
        let (functions, findings, _) = read_text(&format!("{open}{}{close}", one("No='91' GroupNo='10'")));
        assert!(findings.is_empty());
        assert_eq!(functions.group(91), 10);
        let many = "<MFunc No='91' GroupNo='10'/>".repeat(100_000);
        assert_eq!(found(&format!("<MFunctions>{many}</MFunctions>")), []);
    }
}
