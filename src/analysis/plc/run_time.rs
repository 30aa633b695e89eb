//! The other names of S0 8.1–8.4: what a part program does not determine, and why.

use std::sync::LazyLock;

use super::dictionary::{AXIS_NAMES, signals};
use crate::diag::RunTimeReason::{self as Reason, Bits, Bytes, Configuration, Inputs, NoGroup, Plc, Running, Unsaid};
use crate::dict::Dialect;

/// The values of the `x` in a name.
#[derive(Clone, Copy, Debug)]
enum Members {
    /// Nothing: it is one name.
    One,
    /// X, Y, Z, 4–16.
    Axes,
    /// X, Y, Z, 4–6.
    SixAxes,
    /// 0–4.
    Parameters,
    /// 0–9.
    Licences,
    /// 1–5.
    Spaces,
    /// 0–2.
    Geometric,
}

/// Names with a common reason.
struct Row {
    section: &'static str,
    members: Members,
    reason: Reason,
    /// Separated by blanks; `~` is the place of the member.
    names: &'static str,
}

const fn row(section: &'static str, members: Members, reason: Reason, names: &'static str) -> Row {
    Row { section, members, reason, names }
}

use Members::{Axes, Geometric, Licences, One, Parameters, SixAxes, Spaces};

const ROWS: &[Row] = &[
    row("8.1.1", One, Running, "B_POL_EX B_INK_EX B_POL B_INK DIFCIT_X"),
    row("8.1.1", Spaces, Running, "POSITION_POS~_EX"),
    row("8.1.1", One, Plc, "POS_SPACE_PLC POS_SPACE_MMM"),
    row("8.1.2", One, Running, "VYSOVERS REQ_SPEED_PM REQ_SPEED_PT"),
    row(
        "8.1.2",
        One,
        Inputs,
        "ACT_SPEED_PM ACT_SPEED2_PM AVG_SPEED_PM AVG_SPEED2_PM ACT_SPEED_PT ACT_SPEED2_PT AVG_SPEED_PT AVG_SPEED2_PT",
    ),
    row("8.1.2", One, Plc, "SIM_SPEED_PT OTACKY_VR REQW_SPEED2_PM"),
    row("8.1.3", One, Plc, "REQ_EXT_SPINDLE_GEAR REQ_MAN_SPINDLE_GEAR"),
    row("8.1", One, Bytes { names: "BZH08PI, BZH08MAN, BZH09, BZH10, BZH13" }, "BZH"),
    row("8.1.4", Axes, Plc, "MP~PI"),
    row("8.1.4", One, Bits { names: "MPXPI … MP16PI" }, "BZH08PI BZH08PI2"),
    row("8.1.5", Axes, Plc, "MP~MAN"),
    row("8.1.5", One, Bits { names: "MPXMAN … MP16MAN" }, "BZH08MAN BZH08MAN2"),
    row("8.1.6", SixAxes, Running, "MP~"),
    row("8.1.7", One, Bits { names: "PO_OSXPI … PO_OS16PI" }, "PB20PI PB20PI2"),
    row("8.1.7", One, Running, "PB20"),
    row("8.1.7", SixAxes, Running, "PO_OS~"),
    row("8.1.9", Axes, Plc, "VAZBA_~"),
    row("8.1.9", One, Bits { names: "VAZBA_X … VAZBA_16" }, "VAZBAPI VAZBAPI2"),
    row("8.1.10", Axes, Running, "POLOHV_~"),
    row("8.1.10", One, Bits { names: "POLOHV_X … POLOHV_16" }, "POLOHV POLOHVPI2"),
    row(
        "8.1.11",
        One,
        Running,
        "ACK_AUTMAN INPOS_STOP AUTMAN_CONT_NC AUTMAN_CONT_TOC AUTMAN_CONT_SELECT AUTMAN_CONT_G00",
    ),
    row(
        "8.1.11",
        One,
        Plc,
        "EN_AUTMAN REQ_EXT_G00_AUTMAN REQ_EXT_SELECT_AUTMAN REQ_EXT_CONT_AUTMAN REQ_EXT_FEED_AUTMAN EXT_FEED_AUTMAN \
         EXT_FEED_G00_AUTMAN AUTMAN_REQ",
    ),
    row("8.1.11", Axes, Plc, "EXM_~0 EXM_~1"),
    row("8.1.12", One, Plc, "STOPPI STOP_REQ STOP_EMERGENCY_REQ"),
    row("8.1.13", One, Plc, "START_DISABLE START_SUSPEND"),
    row("8.1.14", One, Running, "PO_F"),
    row("8.1.15", One, Running, "PO_POL"),
    row("8.1.17", One, Running, "INPOS"),
    row("8.1.18", One, Running, "BZH13"),
    row("8.1.19", One, Plc, "FEED_OVR BZH09 BZH10 FEED_OVR_MULTIPLIER"),
    row("8.1.20", One, Plc, "SPEED_OVR SPEED_OVR_EXT SPEED_OVR_MULTIPLIER"),
    row("8.1.22", One, Running, "BLOCK_RESTART STATUS_RESTART BLOCK_IDLE BLOCK_INIT BLOCK_MOVE BLOCK_DELAY BLOCK_DONE"),
    row("8.1.23", One, Running, "HOMING HOMING_SINGLE HOMING_PLC HOMING_GROUP"),
    row("8.1.23", One, Plc, "HOMING_REQ REFPOINT_DIST HOMING_START_REQ SLS_REFER NlcAxisEnable NlcServoEnable"),
    row("8.1.23", Axes, Inputs, "KR~ KRR~ ZPR~"),
    row("8.1.24", Axes, Inputs, "KH~0 KH~1 ZP~0 ZP~1"),
    row("8.2.2", One, Running, "CAPI"),
    row("8.3.1", One, Running, "BLK.Backward BLK.SelBlock BLK.Cont BLK.TchlOff BLK.Partial"),
    row("8.3.1", One, NoGroup, "BLK.M0"),
    row("8.3.1", Parameters, Unsaid, "BLK.IPlc~ BLK.RPlc~"),
    row("8.3.2", One, Running, "CNT_NEXT_BLOCKS"),
    row("8.3.3", One, NoGroup, "BLK.M[0]"),
    row("8.3.3", Parameters, Unsaid, "BLK.IPlcParams[~]"),
    row("8.3.3", Geometric, Unsaid, "BLK.AxG[~]"),
    row("8.3.4", Parameters, Unsaid, "BLK.RPlcParams[~]"),
    row("8.3.4", One, Unsaid, "BLK.Scale BLK.FeedMax BLK.FeedCriterial BLK.SpindleSpeedLimit BLK.ConstCuttingSpeed"),
    row(
        "8.3.6",
        One,
        Running,
        "SF_RUN SF_BLOCKINPROGR SF_BLOCKFINISHED SF_NOTINPOS SF_INDICATIONMODE \
         SF_SIMULATIONMODE SF_HIGHSPEEDMODE SF_CONDSTOPMODE SF_MANUALMODE SF_BLOCKBYBLOCK SF_LS SF_SLS SF_BACKWARD \
         SF_STOPPOSCHANGED",
    ),
    row("8.4.1", One, Plc, "LIMIT_FEED_REQ LIMIT_FEED_G00_REQ LIMIT_FEED LIMIT_FEED_G00"),
    row("8.4.2", One, Running, "SYST_TIME_INFO SYST_DATE_INFO UTC_TIME_INFO UTC_DATE_INFO FILETIME_INFO"),
    row(
        "8.4.2",
        One,
        Running,
        "TIME_MIN TIME_HOUR TIME_HUND TIME_SEC DATE_YEAR DATE_DAY DATE_MON LOW_FILETIME HIGH_FILETIME",
    ),
    row("8.4.3", One, Inputs, "PTLTOC_P1 PTLTOC_P1_2 PTLTOC_P2 PTLTOC_P2_2"),
    row("8.4.3", One, Plc, "DISPTOC1 DISPTOC2 BUSY_DISPTOC1 BUSY_DISPTOC2"),
    row("8.4.3", One, Plc, "TOC_ROW TOC_COLUMN TOC_CHAR1 TOC_CHAR2 TOC_CHAR3 TOC_CHAR4 TOC_SIZE TOC_INV"),
    row("8.4.5", One, Plc, "PLC_MEM_BACKUP REQ_BACKUP_MEM"),
    row(
        "8.4.6",
        One,
        Configuration,
        "dwAxNCAcceleration dwAxNCAccelerationRT dwAxNCAccelerationEmergency rAxNCParabAccel rAxNCParabAccelRT \
         rAxNCParabAccelEmergency dwAxNCLinearAccel dwAxNCLinearAccelRT dwAxNCLinearAccelEmergency dwAxNcFeed \
         dwAxNcFeedRT",
    ),
    row("8.4.6", One, Running, "rAxGParabAccel dwAxGLinearAccel"),
    row("8.4.6", One, Plc, "REQ_PARABACCEL REQ_LINEARACCEL"),
    row("8.4.7", One, Running, "HwKeyConnected"),
    row("8.4.7", Licences, Running, "FeaturePlc~"),
];

/// A name that a part program does not determine.
#[derive(Debug)]
pub struct RunTime {
    /// As S0 writes it; for a family with the member.
    pub name: String,
    /// The same with `x` in place of the member, as S0 names the family.
    pub family: Option<String>,
    /// Why.
    pub reason: &'static Reason,
    /// The section of S0.
    pub section: &'static str,
}

impl Members {
    fn each(self) -> Vec<String> {
        let numbers = |range: std::ops::Range<u8>| range.map(|number| number.to_string()).collect();
        match self {
            One => Vec::new(),
            Axes => AXIS_NAMES.iter().map(|&axis| axis.to_owned()).collect(),
            SixAxes => AXIS_NAMES.iter().take(6).map(|&axis| axis.to_owned()).collect(),
            Parameters => numbers(0..5),
            Licences => numbers(0..10),
            Spaces => numbers(1..6),
            Geometric => numbers(0..3),
        }
    }
}

impl RunTime {
    /// Which controls have it: as for signals, those of the command block only CNC872.
    pub fn is_of(&self, dialect: Dialect) -> bool {
        !self.name.starts_with("BLK.") || dialect.has_command_block()
    }
}

static NAMES: LazyLock<Vec<RunTime>> = LazyLock::new(|| ROWS.iter().flat_map(of_row).collect());

fn of_row(row: &'static Row) -> Vec<RunTime> {
    let (members, reason, section) = (row.members.each(), &row.reason, row.section);
    let of_name = |pattern: &'static str| -> Vec<RunTime> {
        if members.is_empty() {
            return vec![RunTime { name: pattern.to_owned(), family: None, reason, section }];
        }
        let family = Some(pattern.replace('~', "x"));
        let name = |member: &String| pattern.replace('~', member);
        members.iter().map(|member| RunTime { name: name(member), family: family.clone(), reason, section }).collect()
    };
    row.names.split_whitespace().flat_map(of_name).collect()
}

/// Every name, in the order of S0.
pub fn names() -> &'static [RunTime] {
    &NAMES
}

/// That name, or the family or array of that name; also as PLC programs write it: with an index of the command block, a
/// type, a structure before it, or from the tables of S0 without `BLK.`.
pub fn find(name: &str) -> Option<&'static RunTime> {
    let plain = plain(name);
    let exact = |name: &str| {
        let is_array = |known: &RunTime| known.name.split_once('[').is_some_and(|(array, _)| array == name);
        let named = names().iter().find(|known| known.name == name || known.family.as_deref() == Some(name));
        // An array some of whose elements are signals is no such name.
        let signals = || !signals().iter().any(|signal| signal.name.split_once('[').is_some_and(|(of, _)| of == name));
        named.or_else(|| names().iter().find(|known| is_array(known)).filter(|_| signals()))
    };
    let of_structure = || {
        let (structure, member) = plain.split_once('.')?;
        let (structure, member) = (exact(structure)?, exact(member)?);
        (structure.section == member.section).then_some(member)
    };
    // Short names and words of programs have meanings of their own.
    let in_block = || {
        let word = plain.bytes().skip(1).all(|byte| byte.is_ascii_digit());
        if word { None } else { exact(&format!("{BLOCK}{plain}")) }
    };
    exact(&plain).or_else(of_structure).or_else(in_block)
}

/// The prefix of the command block.
const BLOCK: &str = "BLK.";
/// Types that stand before a cell in PLC programs.
const TYPES: [&str; 6] = ["BYTE.", "WORD.", "DWRD.", "DWORD.", "QWRD.", "REAL."];

/// `BLK[1].REAL.H`, as PLC programs write it, is `BLK.H`; `BYTE.PB06` is `PB06`.
pub fn plain(name: &str) -> String {
    let untyped = |name: &str| TYPES.iter().find_map(|kind| name.strip_prefix(kind)).unwrap_or(name).to_owned();
    let indexed = name.strip_prefix("BLK[").and_then(|rest| rest.split_once("].")).map(|(_, cell)| cell);
    match indexed.or_else(|| name.strip_prefix(BLOCK)) {
        Some(cell) => format!("{BLOCK}{}", untyped(cell)),
        None => untyped(name),
    }
}

#[cfg(test)]
mod tests {
    use std::collections::BTreeSet;

    use super::*;
    use crate::analysis::plc::dictionary;

    #[test]
    fn no_name_is_a_signal_and_none_stands_twice() {
        let mut seen = BTreeSet::new();
        for known in names() {
            assert!(dictionary::find(&known.name).is_none(), "{}", known.name);
            assert!(seen.insert(&known.name), "{}", known.name);
        }
        assert!(seen.len() > 300, "{}", seen.len());
    }

    /// S0 8.1–8.4: names, and families by their names there.
    #[test]
    fn names_and_families() {
        for name in ["STOPPI", "MPXPI", "MPxPI", "MP16PI", "MPY", "KHZ0", "BLK.TchlOff", "BLK.IPlcParams[4]", "SF_LS"] {
            assert!(find(name).is_some(), "{name}");
        }
        assert!(find("MP7").is_none() && find("BLK.IPlc5").is_none() && find("stoppi").is_none());
        assert_eq!(find("BLK.Scale").unwrap().reason, &Unsaid);
        assert_eq!(find("KHx1").unwrap().section, "8.1.24");
        for name in [
            "BLK.M0",
            "BLK.M[0]",
            "BLK[0].M[0]",
            "AxG",
            "BLK.AxG",
            "BLK[2].AxG[1]",
            "BLK[1].TchlOff",
            "BLK[BX].IPlc1",
            "BLK[0].REAL.RPlcParams[2]",
            "Scale",
            "SYST_TIME_INFO.TIME_MIN",
            "BYTE.UTC_TIME_INFO.TIME_HOUR",
            "DISPTOC1.TOC_ROW",
            "TOC_ROW",
            "DATE_DAY",
        ] {
            assert!(find(name).is_some(), "{name}");
        }
        for name in ["M0", "M", "T", "BLK.M", "BLK[1].M11", "TOC_ROW.TIME_MIN", "AxG.TOC_ROW", "BLK[1].H", ""] {
            assert!(find(name).is_none(), "{name}");
        }
    }
}
