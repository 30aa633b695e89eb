//! The keys of `[motion]` and of the tables in it.

use super::Takes;
use super::motion::{MotionKey, Profile, Recognition};
use super::row::{Default, Row, row};
use crate::dict::Decimal;

const fn number(min: i64, max: i64) -> Takes {
    Takes::Number { min: Decimal::from_thousandths(min), max: Decimal::from_thousandths(max) }
}

const fn default(thousandths: i64) -> Default {
    Default::Number(Decimal::from_thousandths(thousandths))
}

/// The least that is above 0, in thousandths.
const ABOVE_ZERO: i64 = 1;
/// The most that eight digits hold, as thousandths of a whole number.
const EIGHT_DIGITS: i64 = 99_999_999_000;
/// The same of thousandths.
const DIMENSION: i64 = 69_999_999;

fn recognitions() -> Vec<&'static str> {
    Recognition::ALL.iter().map(|recognition| recognition.name()).collect()
}

fn profiles() -> Vec<&'static str> {
    Profile::ALL.iter().map(|profile| profile.name()).collect()
}

pub(super) const RECOGNITION: Row = row(
    "recognition",
    Takes::OneOf(recognitions),
    Default::Text("automatic"),
    (
        "how blocks that join continuously are recognised: `\"manual\"`: by G23 and G24 alone; `\"automatic\"`: by the angle too (R97)",
        "jak se poznává plynulá návaznost bloků: `\"manual\"`: jen podle G23 a G24; `\"automatic\"`: i podle úhlu (R97)",
    ),
    "CNT-3",
);
pub(super) const PROFILE: Row = row(
    "profile",
    Takes::OneOf(profiles),
    Default::ByDialect(|dialect| format!("\"{}\"", Profile::of(dialect).name())),
    (
        "course of the velocity: `\"ramps\"`: no envelope velocity; `\"linear\"`; `\"parabolic\"`, which needs P in set 1 (R338)",
        "průběh rychlosti: `\"ramps\"`: bez obálkové rychlosti; `\"linear\"`; `\"parabolic\"`, které potřebuje P v 1. sadě (R338)",
    ),
    "VEL-9, VEL-10, VEL-11",
);
pub(super) const RAPID: Row = row(
    "rapid-mm-min",
    Takes::NumberOrAxes { min: Decimal::from_thousandths(ABOVE_ZERO), max: Decimal::whole(9_999_999) },
    Default::Number(Decimal::whole(10_000)),
    (
        "velocity of G00: one number along the path, or a table by axis letter, as `{ X = 12000, Z = 6000 }`, with 10000 for those it lacks; deg/min of rotary axes",
        "rychlost G00: jedno číslo po dráze, nebo tabulka podle písmen os, např. `{ X = 12000, Z = 6000 }`; osy v ní neuvedené mají 10000; u rotačních os st/min",
    ),
    "VEL-2",
);

/// A key that holds a number.
pub(super) const NUMBERS: [(MotionKey, Row); MotionKey::ALL.len()] = [
    (
        MotionKey::Cycle,
        row(
            "cycle-ms",
            number(ABOVE_ZERO, 1_000_000),
            Default::Nothing,
            (
                "interpolation cycle Ts in ms, which no source gives: without it the criteria of accuracy and overload limit nothing",
                "takt interpolace Ts v ms, který prameny neuvádějí: bez něj kritéria přesnosti a přetížení nic neomezují",
            ),
            "VEL-4, VEL-5",
        ).with_example("2"),
    ),
    (
        MotionKey::Angle,
        row(
            "angle-deg",
            number(0, 180_000),
            default(60_000),
            (
                "tolerance angle: an angle between blocks that is not below it breaks continuity (R39)",
                "toleranční úhel: úhel návaznosti, který není menší, poruší plynulost (R39)",
            ),
            "CNT-2",
        ),
    ),
    (
        MotionKey::Accel,
        row(
            "accel-mm-s2",
            number(ABOVE_ZERO, EIGHT_DIGITS),
            default(500_000),
            (
                "acceleration of working motion outside continuity (R52)",
                "zrychlení pracovního posuvu mimo plynulou návaznost (R52)",
            ),
            "VEL-8",
        ),
    ),
    (
        MotionKey::AccelContinuous,
        row(
            "accel-continuous-mm-s2",
            number(0, EIGHT_DIGITS),
            default(0),
            (
                "acceleration of working motion within continuity; 0: `accel-mm-s2` (R236)",
                "zrychlení pracovního posuvu při plynulé návaznosti; 0: `accel-mm-s2` (R236)",
            ),
            "VEL-8",
        ),
    ),
    (
        MotionKey::AccelRapid,
        row(
            "accel-rapid-mm-s2",
            number(ABOVE_ZERO, EIGHT_DIGITS),
            default(1_000_000),
            ("acceleration of G00 (R237)", "zrychlení rychloposuvu G00 (R237)"),
            "VEL-8",
        ),
    ),
    (
        MotionKey::ShortestBlock,
        row(
            "shortest-block-ms",
            number(0, 1_000_000),
            Default::ByDialect(|dialect| dialect.shortest_block_ms().to_string()),
            ("shortest time of a block in a continuous stretch", "nejkratší trvání bloku při plynulé návaznosti"),
            "CNT-2, VEL-6",
        ),
    ),
    (
        MotionKey::BreakLength,
        row(
            "break-length-mm",
            number(-DIMENSION, DIMENSION),
            default(0),
            (
                "a shorter block breaks continuity, arcs too; 0 or negative: off (R382)",
                "kratší blok poruší plynulost, i kruhový; 0 nebo záporné: vypnuto (R382)",
            ),
            "CNT-2",
        ),
    ),
    (
        MotionKey::MergeLength,
        row(
            "merge-length-mm",
            number(-DIMENSION, DIMENSION),
            default(0),
            (
                "a shorter linear block is joined to its neighbour; 0 or negative: off (R383)",
                "kratší lineární blok se přidruží k sousednímu; 0 nebo záporné: vypnuto (R383)",
            ),
            "CNT-4",
        ),
    ),
    (
        MotionKey::Accuracy,
        row(
            "accuracy-um",
            number(0, 9_999_999),
            default(0),
            (
                "criterion of accuracy; 0: off (R384, decades 1 to 4)",
                "kritérium přesnosti; 0: vypnuto (R384, dekády 1 až 4)",
            ),
            "VEL-4",
        ),
    ),
    (
        MotionKey::Red,
        row(
            "red-percent",
            number(0, 100_000),
            default(20_000),
            (
                "a joint slower than this part of the programmed velocity has a red dot; 0: none for that (R384, R409, decades 5 to 6)",
                "napojení pomalejší než tolik procent programované rychlosti má červenou tečku; 0: kvůli tomu žádné (R384, R409, dekády 5 až 6)",
            ),
            "DOT-1",
        ),
    ),
    (
        MotionKey::Overload,
        row(
            "overload-mm-s2",
            number(0, EIGHT_DIGITS),
            default(0),
            (
                "dynamic criterion; 0: off (R385, decades 1 to 7)",
                "dynamické kritérium; 0: vypnuto (R385, dekády 1 až 7)",
            ),
            "VEL-5",
        ),
    ),
    (
        MotionKey::RaiseLength,
        row(
            "raise-length-mm",
            number(-DIMENSION, DIMENSION),
            default(0),
            (
                "linear: in a shorter block the velocity does not rise above those of its joints; 0 or negative: off (R386)",
                "linear: v kratším bloku rychlost nestoupne nad rychlosti v jeho krajích; 0 nebo záporné: vypnuto (R386)",
            ),
            "VEL-9",
        ),
    ),
    (
        MotionKey::Raise,
        row(
            "raise-ms",
            number(0, EIGHT_DIGITS),
            default(500_000),
            (
                "time criterion for a rise of velocity; 0 means 500 (R395)",
                "kritérium času pro nárůst rychlosti; 0 znamená 500 (R395)",
            ),
            "VEL-9, VEL-12",
        ),
    ),
    (
        MotionKey::LookAhead,
        row(
            "look-ahead",
            Takes::Whole { min: 1, max: Some(1_000_000) },
            Default::Whole(500),
            ("how many blocks the control sees", "kolik bloků systém předvídá"),
            "VEL-9",
        ),
    ),
    (
        MotionKey::Centripetal,
        row(
            "centripetal-mm-s2",
            number(0, EIGHT_DIGITS),
            default(0),
            (
                "greatest centripetal acceleration of arcs; 0: off (R411, decades 1 to 7, tenths, when decade 8 is 1)",
                "největší odstředivé zrychlení na kruhu; 0: vypnuto (R411, dekády 1 až 7 v desetinách, je-li 8. dekáda 1)",
            ),
            "VEL-3",
        ),
    ),
    (
        MotionKey::ConstantCutting,
        row(
            "constant-cutting-rpm",
            number(ABOVE_ZERO, 99_999_000),
            Default::Nothing,
            (
                "spindle speed to assume in G97 where S is a cutting speed",
                "otáčky vřetena, které se předpokládají při G97, kde S je řezná rychlost",
            ),
            "VEL-1",
        ).with_example("1000"),
    ),
    (
        MotionKey::Settle,
        row(
            "settle-ms",
            number(0, 1_000_000_000),
            default(0),
            (
                "wait at the end of each motion in G23 and G24 that is not continued: until the tolerance R06–R07 is reached",
                "čekání na konci každého pohybu při G23 a G24, na který se plynule nenavazuje: na dojetí odchylky R06–R07",
            ),
            "TIM-1",
        ),
    ),
    (
        MotionKey::BlockGap,
        row(
            "block-gap-ms",
            number(0, 1_000_000_000),
            default(0),
            ("gap before each block in G98", "prodleva před každým blokem při G98"),
            "TIM-1",
        ),
    ),
];

/// The keys of `[motion]`, in the order of the reference page.
pub(super) const MOTION: &[Row] = &{
    let mut rows = [RAPID; MotionKey::ALL.len() + 3];
    let (mut rest, mut numbers) = (rows.as_mut_slice(), NUMBERS.as_slice());
    if let [first, second, others @ ..] = rest {
        (*first, *second) = (PROFILE, RECOGNITION);
        rest = others;
        while let ([row, others @ ..], [(_, number), more @ ..]) = (rest, numbers) {
            *row = *number;
            (rest, numbers) = (others, more);
        }
    }
    rows
};

pub(super) const PARABOLIC: Row = row(
    "parabolic",
    number(0, EIGHT_DIGITS),
    Default::Nothing,
    (
        "parabolic acceleration P as the digits of the constant: 50000 where the control shows 50.000; the jerk is P/32.768 mm/s³",
        "parabolické zrychlení P jako číslice konstanty: 50000 tam, kde systém ukazuje 50.000; ryv je P/32.768 mm/s³",
    ),
    "VEL-11",
).with_example("50000");
pub(super) const LINEAR: Row = row(
    "linear-mm-s2",
    number(0, EIGHT_DIGITS),
    Default::Nothing,
    ("linear acceleration A", "lineární zrychlení A"),
    "VEL-11",
)
.with_example("600");
const SET_ACCURACY: Row = row(
    "accuracy-um",
    number(0, 9_999_999),
    Default::Nothing,
    ("criterion of accuracy", "kritérium přesnosti"),
    "VEL-4",
)
.with_example("8");
const SET_OVERLOAD: Row = row(
    "overload-mm-s2",
    number(0, EIGHT_DIGITS),
    Default::Nothing,
    ("dynamic criterion", "dynamické kritérium"),
    "VEL-5",
)
.with_example("10000");
const SET_CENTRIPETAL: Row = row(
    "centripetal-mm-s2",
    number(0, EIGHT_DIGITS),
    Default::Nothing,
    ("greatest centripetal acceleration of arcs", "největší odstředivé zrychlení na kruhu"),
    "VEL-3",
)
.with_example("400");

/// The keys of a dynamic set.
pub(super) const SET: &[Row] = &[PARABOLIC, LINEAR, SET_ACCURACY, SET_OVERLOAD, SET_CENTRIPETAL];
/// The keys of the set for G00.
pub(super) const RAPID_SET: &[Row] = &[PARABOLIC, LINEAR];
