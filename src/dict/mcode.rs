//! The standard technological functions (§8 of the language). What is in no row belongs to group 14.

use super::{Bilingual, Dialect, Lasting};

/// Number of M groups, group 0 not used: an array indexed by group has this length.
pub const M_GROUPS: usize = 15;

/// The groups whose functions hold in their block only (MFN-6).
pub const MOMENTARY_GROUPS: [u8; 3] = [1, 7, 9];

/// Feed reduced 1:100 (TEC-6).
pub const REDUCED_FEED: u8 = 37;
/// The functions that say how F counts on CNC8x6 and CNC8x9 (TEC-6).
pub const FEED_FUNCTIONS: [u8; 2] = [36, REDUCED_FEED];
/// The group of M36 and M37 (TEC-6).
pub const FEED_GROUP: usize = 4;

/// The group of stops and of the end of the program.
pub const PROGRAM_GROUP: usize = 1;
/// The program stands until START (MFN-8).
pub const PROGRAM_STOP: u8 = 0;
/// The same, with optional stop (MFN-8).
pub const OPTIONAL_STOP: u8 = 1;

/// The spindle's group.
pub const SPINDLE_GROUP: usize = 2;
/// The spindle turns.
pub const SPINDLE_TURNS: [u8; 2] = [3, 4];
/// The spindle stands.
pub const SPINDLE_STOP: u8 = 5;
/// The spindle stops in an oriented position (MFN-10).
pub const ORIENTED_STOP: u8 = 19;

/// The group of spindle ranges.
pub const GEAR_GROUP: usize = 3;
/// The range follows from S (MFN-9).
pub const GEAR_BY_SPEED: u8 = 40;
/// The functions of ranges 1 to 4.
pub const GEARS: std::ops::RangeInclusive<u8> = gear_function(1)..=gear_function(4);

/// The function of a range, 1–4.
pub const fn gear_function(range: u8) -> u8 {
    GEAR_BY_SPEED + range
}

/// The call of a subprogram on other controls; on this one a function of the machine builder.
pub const CALL_ELSEWHERE: u8 = 98;

/// The group of coolant 1 and 2.
pub const COOLANT_12_GROUP: usize = 5;
/// Coolant 1 and 2 on, and off.
pub const COOLANT_12: [u8; 2] = [17, 9];
/// The group of coolant 3 and 4.
pub const COOLANT_34_GROUP: usize = 6;
/// Coolant 3 and 4 on, and off.
pub const COOLANT_34: [u8; 2] = [52, 53];

/// The group of M10 and M11: the workpiece is clamped, released.
pub const CLAMP_GROUP: u8 = 7;
/// The groups whose functions have no standard meaning: those of the machine builder.
pub const BUILDER_GROUPS: std::ops::RangeInclusive<usize> = 10..=14;
/// The last of these: its functions do not exclude each other, each may hold beside the others (MFN-3).
pub const OTHER_GROUP: u8 = 14;

/// Tool change.
pub const TOOL_CHANGE: u8 = 6;

/// Groups that are switched off while the program stands and at its end, with the functions that do it when no others
/// are configured: spindle, coolant 1 and 2, coolant 3 and 4 (MFN-6, MFN-8).
pub const HELD_AT_STOP: [(usize, u8); 3] =
    [(SPINDLE_GROUP, SPINDLE_STOP), (COOLANT_12_GROUP, COOLANT_12[1]), (COOLANT_34_GROUP, COOLANT_34[1])];

/// The functions that end a program.
pub const PROGRAM_ENDS: [u8; 2] = [2, 30];

/// A row of the dictionary of M functions.
#[derive(Clone, Copy, Debug)]
pub struct MRow {
    /// Number.
    pub number: u8,
    /// Group, 1–13.
    pub group: u8,
    /// How long it holds; [`Lasting::Default`] is `+`.
    pub lasting: Lasting,
    /// The rule of the language that says most of it, such as `MFN-8`.
    pub rule: &'static str,
    /// Its effect.
    pub meaning: Bilingual,
}

const fn row(number: u8, group: u8, lasting: Lasting, rule: &'static str, en: &'static str, cs: &'static str) -> MRow {
    MRow { number, group, lasting, rule, meaning: Bilingual { en, cs } }
}

use Lasting::{Block, Default as Plus, Modal};

const COMMON: [MRow; 23] = [
    row(0, 1, Block, "MFN-8", "program stop", "programový stop"),
    row(1, 1, Block, "MFN-8", "optional stop", "volitelný stop"),
    row(2, 1, Block, "MFN-7", "end of program", "konec partprogramu"),
    row(30, 1, Block, "MFN-7", "end of program", "konec partprogramu"),
    row(3, 2, Modal, "MFN-10", "spindle on, clockwise", "start vřetena ve směru hodinových ručiček"),
    row(4, 2, Modal, "MFN-10", "spindle on, counter-clockwise", "start vřetena proti směru hodinových ručiček"),
    row(5, 2, Plus, "MFN-10", "spindle stop", "stop vřetena"),
    row(19, 2, Modal, "MFN-10", "oriented spindle stop", "stop vřetena v orientovaném bodě"),
    row(41, 3, Modal, "MFN-9", "spindle range 1", "1. rozsah otáček vřetena"),
    row(42, 3, Modal, "MFN-9", "spindle range 2", "2. rozsah otáček vřetena"),
    row(43, 3, Modal, "MFN-9", "spindle range 3", "3. rozsah otáček vřetena"),
    row(44, 3, Modal, "MFN-9", "spindle range 4", "4. rozsah otáček vřetena"),
    row(40, 3, Plus, "MFN-9", "spindle range follows from S", "rozsah otáček vřetena podle S"),
    row(9, 5, Plus, "MFN-7", "coolant 1 and 2 off", "vypnutí chlazení 1 a 2"),
    row(17, 5, Modal, "MFN-7", "coolant 1 and 2 on", "zapnutí chlazení 1 a 2"),
    row(50, 6, Modal, "MFN-7", "coolant 3 on", "zapnutí chlazení 3"),
    row(51, 6, Modal, "MFN-7", "coolant 4 on", "zapnutí chlazení 4"),
    row(53, 6, Plus, "MFN-7", "coolant 3 and 4 off", "vypnutí chlazení 3 a 4"),
    row(52, 6, Modal, "MFN-7", "coolant 3 and 4 on", "zapnutí chlazení 3 a 4"),
    row(10, 7, Block, "MFN-6", "clamp the workpiece", "upnutí obrobku"),
    row(11, 7, Block, "MFN-6", "release the workpiece", "uvolnění obrobku"),
    row(6, 9, Block, "TEC-4", "tool change", "výměna nástroje"),
    row(60, 9, Block, "MFN-6", "workpiece change", "výměna obrobku"),
];

const OVERRIDE: [MRow; 2] = [
    row(49, 8, Modal, "MFN-7", "feed override bypassed", "ruční FEED OVERRIDE přemostěn"),
    row(48, 8, Plus, "MFN-7", "feed override works", "ruční FEED OVERRIDE účinný"),
];

const OLD_ONLY: [MRow; 4] = [
    row(36, 4, Plus, "TEC-6", "feed as programmed", "posuv podle programu"),
    row(37, 4, Modal, "TEC-6", "feed reduced 1:100", "posuv zmenšen 1 : 100"),
    row(7, 5, Modal, "MFN-7", "coolant 2 on", "zapnutí chlazení 2"),
    row(8, 5, Modal, "MFN-7", "coolant 1 on", "zapnutí chlazení 1"),
];

const NEW_ONLY: [MRow; 2] = [
    row(7, 5, Modal, "MFN-7", "coolant 1 on", "zapnutí chlazení 1"),
    row(8, 5, Modal, "MFN-7", "coolant 2 on", "zapnutí chlazení 2"),
];

/// The standard M functions of a dialect, by S4 (CNC8x6, CNC8x9) and S0 8.2.1 (CNC872).
pub fn standard_m_functions(dialect: Dialect) -> impl Iterator<Item = &'static MRow> {
    let own: &'static [MRow] = match dialect {
        Dialect::Cnc8x6 | Dialect::Cnc8x9 => &OLD_ONLY,
        Dialect::Cnc872 => &NEW_ONLY,
    };
    COMMON.iter().chain(&OVERRIDE).chain(own)
}
