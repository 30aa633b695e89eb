//! W0901: M functions and H that do not fit the byte in which the compatible command block has them (PLC-7).

use super::dictionary::{Cell, Signal};
use super::values::fits_byte;
use crate::diag::{Finding, Findings};
use crate::dict::Address;
use crate::run::Executed;

/// The only M function that has three digits.
const THREE_DIGITS: u8 = 100;

/// The bytes among the chosen signals.
#[derive(Debug)]
pub(super) struct Fits {
    /// M groups, with the names of their bytes.
    groups: Vec<(u8, &'static str)>,
    h: Option<&'static str>,
}

impl Fits {
    pub(super) fn of(signals: &[&'static Signal]) -> Self {
        let mut fits = Self { groups: Vec::new(), h: None };
        for signal in signals {
            if let Cell::GroupByte(group) = signal.cell {
                fits.groups.push((group, &signal.name));
            } else if signal.cell == Cell::HByte {
                fits.h = Some(&signal.name);
            }
        }
        fits
    }

    /// Reports what the block writes and does not fit.
    pub(super) fn check(&self, block: &Executed<'_>, findings: &mut Findings) {
        if !self.groups.is_empty() && block.m_written().contains(&THREE_DIGITS) {
            self.check_m(block, findings);
        }
        if let Some(byte) = self.h
            && let Some(h) = block.h().filter(|h| !fits_byte(*h) && block.written(Address::H))
        {
            let finding =
                Finding::DoesNotFit { word: format!("H{h}"), byte: byte.to_owned(), cell: "BLK.H".to_owned() };
            report(block, Address::H, 0, finding, findings);
        }
    }

    fn check_m(&self, block: &Executed<'_>, findings: &mut Findings) {
        let group = block.settings().machine.m_functions.group(THREE_DIGITS);
        let Some((_, byte)) = self.groups.iter().find(|(chosen, _)| *chosen == group) else { return };
        let finding = Finding::DoesNotFit {
            word: format!("M{THREE_DIGITS}"),
            byte: (*byte).to_owned(),
            cell: format!("BLK.M[{group}]"),
        };
        // The words follow the order of their meanings, whether written out or taken from a parameter.
        let which = block.m_written().iter().position(|number| *number == THREE_DIGITS).unwrap_or(0);
        report(block, Address::M, which, finding, findings);
    }
}

/// Reports a finding at the value of one of the words of an address.
fn report(block: &Executed<'_>, address: Address, which: usize, finding: Finding, findings: &mut Findings) {
    let Some(file) = block.file() else { return };
    let (_, id) = block.at();
    if let Some(word) = file.words(id).iter().filter(|word| word.address == address).nth(which) {
        findings.add(block.found(finding, file.value_place(*word)));
    }
}
