//! Machine constants R56–R59: M groups 10–13 of CNC8x6 and CNC8x9 (MFN-5).

use super::draft::WrittenConstant;
use super::motion::From;
use super::motion_constants::Written;
use super::{MFunction, MFunctions};
use crate::diag::{ConstantProblem, Diagnostic, Finding, Findings, LabelText};
use crate::text::Location;

/// The constants that give M groups, and the group of the first; the others follow.
const CONSTANTS: std::ops::RangeInclusive<u16> = 56..=59;
const FIRST_GROUP: u8 = 10;
/// Eight decades: four functions of two digits.
const DIGITS: usize = 8;

/// The M group that a machine constant gives; `None` for the other constants.
pub(super) fn group_of(constant: u16) -> Option<u8> {
    let place = u8::try_from(constant.checked_sub(*CONSTANTS.start())?).ok()?;
    CONSTANTS.contains(&constant).then(|| FIRST_GROUP + place)
}

/// Puts the functions that R56–R59 name into groups 10–13: two digits each, `00` is none, missing leading digits are
/// zeros; a number may stand as the control shows it, with a point before the last three. E0706 at the value for more
/// than eight digits, a sign, in a text a point, a function of groups 1–9, or one named before, in the order of the
/// text; nothing of such a constant is set. The other constants are passed over.
pub(super) fn apply(constants: &[WrittenConstant], functions: &mut MFunctions, findings: &mut Findings) {
    let mut named: Vec<(u8, Location)> = Vec::new();
    for constant in constants {
        let Some(group) = group_of(constant.number).filter(|_| constant.place.from == From::Key) else {
            continue;
        };
        match functions_of(&as_digits(&constant.written), functions, &named) {
            Ok(list) => {
                for m in list {
                    named.push((m, constant.place.at));
                    if let Some(known) = functions.get(m) {
                        functions.set(MFunction { group, configured: true, ..known });
                    }
                }
            }
            Err(problem) => {
                let first = named.iter().find(|(m, _)| problem == ConstantProblem::Twice { m: *m });
                let finding = Finding::MachineConstant { constant: format!("R{}", constant.number), problem };
                let diagnostic = Diagnostic::new(finding, constant.place.at);
                findings.add(match first {
                    Some((m, at)) => diagnostic.with_label(*at, LabelText::First { what: format!("M{m:02}") }),
                    None => diagnostic,
                });
            }
        }
    }
}

/// The digits of a constant: of a number as the control shows it, with three decimals, those before and behind the
/// point.
fn as_digits(Written { digits, quoted }: &Written) -> String {
    match digits.split_once('.') {
        Some((whole, thousandths)) if !quoted && thousandths.len() == 3 => format!("{whole}{thousandths}"),
        Some(_) | None => digits.clone(),
    }
}

/// The functions of one constant, or the first thing wrong with it.
fn functions_of(digits: &str, functions: &MFunctions, named: &[(u8, Location)]) -> Result<Vec<u8>, ConstantProblem> {
    if digits.len() > DIGITS || !digits.bytes().all(|byte| byte.is_ascii_digit()) {
        return Err(ConstantProblem::Digits);
    }
    let mut rest: u32 = digits.parse().map_err(|_| ConstantProblem::Digits)?;
    let mut list = Vec::new();
    while rest > 0 {
        list.push(u8::try_from(rest % 100).unwrap_or(0));
        rest /= 100;
    }
    list.reverse();
    list.retain(|&m| m != 0);
    for (place, &m) in list.iter().enumerate() {
        if let Some(function) = functions.get(m).filter(|function| function.standard) {
            return Err(ConstantProblem::Standard { m, group: function.group });
        }
        if named.iter().any(|(other, _)| *other == m) || list.iter().take(place).any(|&other| other == m) {
            return Err(ConstantProblem::Twice { m });
        }
    }
    Ok(list)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::config::draft::Place;
    use crate::diag::Code;
    use crate::dict::{Dialect, Lang};
    use crate::text::{FileId, Span};

    fn applied(constants: &[(u16, &str)]) -> (MFunctions, Vec<Diagnostic>) {
        let at = |at| Location { file: FileId(0), span: Span::empty(at) };
        let constants: Vec<_> = (0..)
            .zip(constants)
            .map(|(place, (number, digits))| WrittenConstant {
                number: *number,
                written: Written { digits: (*digits).to_owned(), quoted: true },
                place: Place { key: at(place), at: at(place), from: From::Key },
            })
            .collect();
        let mut functions = MFunctions::standard(Dialect::Cnc8x9);
        let mut findings = Findings::new();
        apply(&constants, &mut functions, &mut findings);
        (functions, findings.into_sorted())
    }

    /// MFN-5: eight decades; `00` is none, missing leading digits are zeros.
    #[test]
    fn groups_10_to_13() {
        let (functions, findings) =
            applied(&[(56, "91929394"), (57, "95000096"), (58, "97"), (59, "00"), (39, "60.0")]);
        assert!(findings.is_empty());
        let groups: Vec<_> = functions.configured().map(|m| (m.number, m.group)).collect();
        assert_eq!(groups, [(91, 10), (92, 10), (93, 10), (94, 10), (95, 11), (96, 11), (97, 12)]);
        assert!(functions.configured().all(|m| !m.standard && !m.break_cont));
    }

    #[test]
    fn faults() {
        for (constants, problem) in [
            (&[(56, "919293949")][..], ConstantProblem::Digits),
            (&[(56, "000000091")], ConstantProblem::Digits),
            (&[(56, "-91")], ConstantProblem::Digits),
            (&[(56, "+91")], ConstantProblem::Digits),
            (&[(56, "91.0")], ConstantProblem::Digits),
            (&[(57, "03000000")], ConstantProblem::Standard { m: 3, group: 2 }),
            (&[(57, "36")], ConstantProblem::Standard { m: 36, group: 4 }),
            (&[(56, "91920091")], ConstantProblem::Twice { m: 91 }),
            (&[(58, "91"), (56, "9091")], ConstantProblem::Twice { m: 91 }),
        ] {
            let (_, findings) = applied(constants);
            assert_eq!(findings.len(), 1, "{constants:?}");
            assert_eq!(findings[0].code(), Code::E0706);
            let constant = format!("R{}", constants.last().unwrap().0);
            assert_eq!(findings[0].finding, Finding::MachineConstant { constant, problem }, "{constants:?}");
        }
        let (_, findings) = applied(&[(56, "91"), (57, "91")]);
        assert_eq!(findings[0].labels.len(), 1);
        assert!(findings[0].finding.message(Lang::Cs).starts_with("strojní konstanta R57 uvádí M91"));
    }

    /// A constant with a fault sets nothing, so it causes no second finding.
    #[test]
    fn a_faulty_constant_sets_nothing() {
        let (functions, findings) = applied(&[(56, "9103"), (57, "91")]);
        assert_eq!(findings.len(), 1);
        assert_eq!(functions.group(91), 11);
    }
}
