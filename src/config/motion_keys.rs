//! The keys of `[motion]` and of the tables in it.

use super::draft::Draft;
use super::motion::{Profile, Recognition, SetKey};
use super::number::parse_decimal;
use super::row::Default::{ByDialect, Is, Nothing};
use super::row::{Row, row, rows};
use super::takes::{Takes, number, one_of, whole};
use crate::dict::{Decimal, Dialect};

/// The least that is above 0, in thousandths.
const ABOVE_ZERO: i64 = 1;
/// The most that eight digits hold, as thousandths of a whole number.
const EIGHT_DIGITS: i64 = 99_999_999_000;
/// The same of thousandths.
const DIMENSION: i64 = 69_999_999;

rows! {
    /// The keys of a dynamic set.
    SET:
    "parabolic" "VEL-11" example "50000":
        number(0, EIGHT_DIGITS, |it, value| it.set_of_motion(SetKey::Parabolic, value)), Nothing =>
        "parabolic acceleration P as the digits of the constant: 50000 where the control shows 50.000; the jerk is \
        P/32.768 mm/s³",
        "parabolické zrychlení P jako číslice konstanty: 50000 tam, kde systém ukazuje 50.000; ryv je P/32.768 mm/s³";
    "linear-mm-s2" "VEL-11" example "600":
        number(0, EIGHT_DIGITS, |it, value| it.set_of_motion(SetKey::Linear, value)), Nothing =>
        "linear acceleration A", "lineární zrychlení A";
    "accuracy-um" "VEL-4" example "8":
        number(0, 9_999_999, |it, value| it.set_of_motion(SetKey::Accuracy, value)), Nothing =>
        "criterion of accuracy", "kritérium přesnosti";
    "overload-mm-s2" "VEL-5" example "10000":
        number(0, EIGHT_DIGITS, |it, value| it.set_of_motion(SetKey::Overload, value)), Nothing =>
        "dynamic criterion", "dynamické kritérium";
    "centripetal-mm-s2" "VEL-3" example "400":
        number(0, EIGHT_DIGITS, |it, value| it.set_of_motion(SetKey::Centripetal, value)), Nothing =>
        "greatest centripetal acceleration of arcs", "největší odstředivé zrychlení na kruhu";
}

/// The keys of the set for G00.
pub(super) const RAPID_SET: &[Row] = SET.split_at(2).0;

/// The keys of `[motion]`, in the order of the reference page; those with one number have a name in the code too.
macro_rules! motion {
    ({ $($first:literal $first_rule:literal: $first_takes:expr, $first_default:expr
        => $first_en:literal, $first_cs:literal;)* }
     { $($key:ident $name:literal $rule:literal $(example $example:literal)?
        : $takes:ident($min:expr, $max:expr), $default:expr => $en:literal, $cs:literal;)* }
     { $($last:literal $last_rule:literal: $last_takes:expr, $last_default:expr
        => $last_en:literal, $last_cs:literal;)* }) => {
        /// The keys of `[motion]` that hold a number.
        #[derive(Clone, Copy, Debug, Eq, Ord, PartialEq, PartialOrd)]
        pub enum MotionKey {
            $(#[doc = concat!("`", $name, "`.")] $key,)*
        }

        impl MotionKey {
            /// Every one, in the order of the reference page.
            pub const ALL: [Self; [$($name),*].len()] = [$(Self::$key),*];
            /// How many keys stand before them in [`MOTION`].
            const FIRST: usize = [$($first),*].len();
        }

        /// The keys of `[motion]`.
        pub(super) static MOTION: &[Row] = &[
            $(row($first, $first_takes, $first_default, ($first_en, $first_cs), $first_rule),)*
            $(row($name, $takes($min, $max, |it, value| it.$takes(MotionKey::$key, value)), $default, ($en, $cs), $rule)
                $(.with_example($example))?,)*
            $(row($last, $last_takes, $last_default, ($last_en, $last_cs), $last_rule),)*
        ];
    };
}

motion! {{
    "profile" "VEL-9, VEL-10, VEL-11":
        one_of!(Profile, Draft::set_profile), ByDialect(|dialect| format!("\"{}\"", Profile::of(dialect).name())) =>
        "course of the velocity; `\"ramps\"`: no envelope velocity; `\"linear\"`; `\"parabolic\"`, which needs P in \
        set 1 (R338)",
        "průběh rychlosti; `\"ramps\"`: bez obálkové rychlosti; `\"linear\"`; `\"parabolic\"`, které potřebuje P v 1. \
        sadě (R338)";
    "recognition" "CNT-3": one_of!(Recognition, Draft::set_recognition), Is("\"automatic\"") =>
        "how blocks that join continuously are recognised; `\"manual\"`: by G23 and G24 alone; `\"automatic\"`: by \
        the angle too (R97)",
        "jak se poznává plynulá návaznost bloků; `\"manual\"`: jen podle G23 a G24; `\"automatic\"`: i podle úhlu \
        (R97)";
}
{
    Cycle "cycle-ms" "VEL-4, VEL-5" example "2": number(ABOVE_ZERO, 1_000_000), Nothing =>
        "interpolation cycle Ts in ms, which no source gives: without it the criterion of accuracy and the dynamic \
        criterion limit nothing",
        "takt interpolace Ts v ms, který příručky systému neuvádějí: bez něj kritérium přesnosti a dynamické kritérium \
        nic neomezují";
    Angle "angle-deg" "CNT-2": number(0, 180_000), Is("60") =>
        "tolerance angle: an angle between blocks that is not below it breaks continuity (R39)",
        "toleranční úhel: úhel návaznosti, který není menší, poruší plynulost (R39)";
    Accel "accel-mm-s2" "VEL-8": number(ABOVE_ZERO, EIGHT_DIGITS), Is("500") =>
        "acceleration of working motion outside continuity (R52)",
        "zrychlení pracovního posuvu mimo plynulou návaznost (R52)";
    AccelContinuous "accel-continuous-mm-s2" "VEL-8": number(0, EIGHT_DIGITS), Is("0") =>
        "acceleration of working motion within continuity; 0: `accel-mm-s2` (R236)",
        "zrychlení pracovního posuvu při plynulé návaznosti; 0: `accel-mm-s2` (R236)";
    AccelRapid "accel-rapid-mm-s2" "VEL-8": number(ABOVE_ZERO, EIGHT_DIGITS), Is("1000") =>
        "acceleration of G00 (R237)", "zrychlení rychloposuvu G00 (R237)";
    ShortestBlock "shortest-block-ms" "CNT-2, VEL-6":
        number(0, 1_000_000), ByDialect(|dialect| dialect.shortest_block_ms().to_string()) =>
        "shortest time of a block in a continuous stretch", "nejkratší trvání bloku při plynulé návaznosti";
    BreakLength "break-length-mm" "CNT-2": number(-DIMENSION, DIMENSION), Is("0") =>
        "a shorter block breaks continuity, arcs too; 0 or negative: off (R382)",
        "kratší blok poruší plynulost, i kruhový; 0 nebo záporné: vypnuto (R382)";
    MergeLength "merge-length-mm" "CNT-4": number(-DIMENSION, DIMENSION), Is("0") =>
        "a shorter linear block is joined to its neighbour; 0 or negative: off (R383)",
        "kratší lineární blok se přidruží k sousednímu; 0 nebo záporné: vypnuto (R383)";
    Accuracy "accuracy-um" "VEL-4": number(0, 9_999_999), Is("0") =>
        "criterion of accuracy; 0: off (R384, decades 1 to 4)",
        "kritérium přesnosti; 0: vypnuto (R384, dekády 1 až 4)";
    Red "red-percent" "DOT-1": number(0, 100_000), Is("20") =>
        "a joint slower than this part of the programmed velocity has a red dot; 0: none for that (R384, R409, \
        decades 5 to 6)",
        "napojení pod tolika procenty programované rychlosti má červenou tečku; 0: kvůli tomu žádné (R384, R409, \
        dekády 5 až 6)";
    Overload "overload-mm-s2" "VEL-5": number(0, EIGHT_DIGITS), Is("0") =>
        "dynamic criterion; 0: off (R385, decades 1 to 7)",
        "dynamické kritérium; 0: vypnuto (R385, dekády 1 až 7)";
    RaiseLength "raise-length-mm" "VEL-9": number(-DIMENSION, DIMENSION), Is("0") =>
        "a shorter block is no faster than its joints; `\"linear\"` alone; 0 or negative: off (R386)",
        "v kratším bloku rychlost nestoupne nad tu v jeho krajích; jen `\"linear\"`; 0 nebo záporné: vypnuto (R386)";
    Raise "raise-ms" "VEL-9, VEL-12": number(0, EIGHT_DIGITS), Is("500") =>
        "time criterion for a rise of velocity; 0 means 500 (R395)",
        "kritérium času pro nárůst rychlosti; 0 znamená 500 (R395)";
    LookAhead "look-ahead" "VEL-9": whole(1, 1_000_000), Is("500") =>
        "how many blocks the control sees", "kolik bloků systém předvídá";
    Centripetal "centripetal-mm-s2" "VEL-3": number(0, EIGHT_DIGITS), Is("0") =>
        "greatest centripetal acceleration of arcs; 0: off (R411, decades 1 to 7, tenths, when decade 8 is 1)",
        "největší odstředivé zrychlení na kruhu; 0: vypnuto (R411, dekády 1 až 7 v desetinách, je-li 8. dekáda 1)";
    ConstantCutting "constant-cutting-rpm" "VEL-1" example "1000": number(ABOVE_ZERO, 99_999_000), Nothing =>
        "spindle speed to assume in G97 where S is a cutting speed",
        "otáčky vřetena předpokládané při G97, kde S je řezná rychlost";
    Settle "settle-ms" "TIM-1": number(0, 1_000_000_000), Is("0") =>
        "wait at the end of each motion that is not continued (G23, G24): until the tolerance R06–R07 is reached",
        "čekání na konci pohybu, na který se plynule nenavazuje (G23, G24): na dojetí odchylky R06–R07";
    BlockGap "block-gap-ms" "TIM-1": number(0, 1_000_000_000), Is("0") =>
        "gap before each block in G98", "prodleva před každým blokem při G98";
}
{
    "rapid-mm-min" "VEL-2":
        Takes::Rapid {
            min: Decimal::from_thousandths(ABOVE_ZERO),
            max: Decimal::whole(9_999_999),
            set: Draft::set_rapid,
        },
        Is("10000") =>
        "velocity of G00: one number along the path, or a table by axis letter, as `{ X = 12000, Z = 6000 }`, with \
        10000 for those it lacks; deg/min of rotary axes",
        "rychlost G00: jedno číslo po dráze, nebo tabulka podle písmen os, např. `{ X = 12000, Z = 6000 }`; osy v ní \
        neuvedené mají 10000; u rotačních os st/min";
}}

impl MotionKey {
    fn row(self) -> Option<&'static Row> {
        MOTION.get(Self::FIRST + self as usize)
    }

    /// As in the project file.
    pub fn name(self) -> &'static str {
        self.row().map_or("", |row| row.name)
    }

    /// What holds without it.
    pub(super) fn default(self, dialect: Dialect) -> Option<Decimal> {
        parse_decimal(&self.row()?.literal(dialect)?)
    }
}
