//! The M functions of a machine: the standard ones and those that configuration adds (MFN-1…MFN-5).

use crate::dict::{Dialect, FEED_FUNCTIONS, Lasting, M_GROUPS, REDUCED_FEED, standard_m_functions};

/// The group that everything not listed belongs to.
const REST: u8 = 14;

/// One M function of the machine.
#[derive(Clone, Copy, Debug, Eq, PartialEq)]
pub struct MFunction {
    /// Number, 0–100.
    pub number: u8,
    /// Group, 1–14.
    pub group: u8,
    /// Whether it is a standard function, fixed in its group.
    pub standard: bool,
    /// Whether configuration names it.
    pub configured: bool,
    /// Continuous motion is broken at the start of the block (MFN-4).
    pub break_cont: bool,
    /// Continuous motion is broken at the end of the block (MFN-4).
    pub break_cont_end: bool,
    /// The function moves the machine (MFN-4).
    pub change_pos: bool,
}

impl MFunction {
    /// Whether it acts at the end of its block (MFN-4).
    pub const fn acts_at_end(&self) -> bool {
        self.break_cont_end && !self.break_cont
    }
}

/// Whether a ChannelConfig lists the M functions of the machine.
#[derive(Clone, Copy, Debug, Default, Eq, PartialEq)]
pub(super) enum ChannelList {
    /// There is no ChannelConfig.
    #[default]
    None,
    /// It has no `MFunctions` (W0708).
    Missing,
    /// It has.
    Read,
}

/// All M functions of a machine, by number.
#[derive(Clone, Debug)]
pub struct MFunctions {
    functions: Vec<MFunction>,
    defaults: [Option<u8>; M_GROUPS],
    /// The list of a ChannelConfig.
    channel: ChannelList,
}

impl MFunctions {
    /// The standard functions of a dialect; every other number is of group 14.
    pub fn standard(dialect: Dialect) -> Self {
        let mut functions: Vec<MFunction> = (0..=100)
            .map(|number| MFunction {
                number,
                group: REST,
                standard: false,
                configured: false,
                break_cont: false,
                break_cont_end: false,
                change_pos: false,
            })
            .collect();
        let mut defaults = [None; M_GROUPS];
        for row in standard_m_functions(dialect) {
            if let Some(function) = functions.get_mut(usize::from(row.number)) {
                function.group = row.group;
                function.standard = true;
            }
            if row.lasting == Lasting::Default
                && let Some(default) = defaults.get_mut(usize::from(row.group))
            {
                *default = Some(row.number);
            }
        }
        Self { functions, defaults, channel: ChannelList::default() }
    }

    /// The function of that number, 0–100.
    pub fn get(&self, number: u8) -> Option<MFunction> {
        self.functions.get(usize::from(number)).copied()
    }

    /// Whether the function in force in its group reduces the feed to a hundredth (M37, TEC-6); on CNC872 none does.
    pub fn reduces_feed(&self, in_force: Option<u8>) -> bool {
        in_force == Some(REDUCED_FEED) && self.get(REDUCED_FEED).is_some_and(|function| function.standard)
    }

    /// The group of that number; 14 for numbers that no table holds.
    pub fn group(&self, number: u8) -> u8 {
        self.get(number).map_or(REST, |function| function.group)
    }

    /// Puts a function in the place of the one with its number.
    pub fn set(&mut self, function: MFunction) {
        if let Some(slot) = self.functions.get_mut(usize::from(function.number)) {
            *slot = function;
        }
    }

    /// Notes that there is a ChannelConfig.
    pub(super) const fn set_channel(&mut self, channel: ChannelList) {
        self.channel = channel;
    }

    /// Whether a function does nothing on this machine that anybody has said (TEC-8): M36 and M37 where they are no
    /// standard functions and not configured, others of group 14 that a ChannelConfig does not list.
    pub fn is_meaningless(&self, number: u8) -> bool {
        let Some(function) = self.get(number).filter(|function| !function.standard && !function.configured) else {
            return false;
        };
        match self.channel {
            ChannelList::None => FEED_FUNCTIONS.contains(&number),
            ChannelList::Missing => false,
            ChannelList::Read => function.group == REST,
        }
    }

    /// The `+` value of each group: what holds after power-up and M02/M30 (MFN-7).
    pub const fn defaults(&self) -> &[Option<u8>; M_GROUPS] {
        &self.defaults
    }

    /// The functions that act at the end of their block alone (`BreakContEnd` without `BreakCont`), by number.
    pub fn at_end(&self) -> impl Iterator<Item = u8> + '_ {
        let at_end = |function: &&MFunction| function.break_cont_end && !function.break_cont;
        self.functions.iter().filter(at_end).map(|function| function.number)
    }

    /// The functions that configuration names, by number.
    pub fn configured(&self) -> impl Iterator<Item = MFunction> + '_ {
        self.functions.iter().copied().filter(|function| function.configured)
    }
}
