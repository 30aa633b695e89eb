//! The keys of `cnc872c.toml`: type, range and field, default, meaning in both languages, and the rule each comes from.
//! The tables that they belong to are in [`sections`](super::sections).

use super::draft::{Draft, narrow};
use super::format::{Codes, Numbers};
use super::row::Default::{ByDialect, Is, Nothing, Required};
use super::row::{Row, row, rows, words};
use super::takes::{List, Takes, number, one_of, whole};
use super::{ArcCenters, G97, SpindleAxis};
use crate::dict::{AxisLetter, Dialect};
use crate::text::Encoding;

/// The words for a linear and a rotary axis.
const AXIS_KINDS: [(&str, bool); 2] = [("linear", false), ("rotary", true)];
/// Any position or distance (§2), in thousandths.
const DIMENSION: i64 = 69_999_999;
/// Greatest S that can be configured, in rev/min (§11).
const HIGHEST_SPEED: i64 = 99_999;

/// A speed of a gear.
const fn speed(set: fn(&mut Draft, i64)) -> Takes {
    Takes::Speed { max: HIGHEST_SPEED, set }
}

fn spindle_axes() -> Vec<(&'static str, SpindleAxis)> {
    let letters = AxisLetter::ALL.map(|letter| (letter.name(), SpindleAxis::Letter(letter)));
    letters.into_iter().chain([(SpindleAxis::NONE, SpindleAxis::None)]).collect()
}

rows! {
    /// What comes before all tables.
    ROOT:
    "dialect" "§12" option "--dialect": one_of!(Dialect, |it, dialect| it.set_dialect(dialect)), Is("\"cnc872\"") =>
        "the control that the programs are for", "řídicí systém, pro který programy jsou";
    "encoding" "LEX-13" option "--encoding":
        one_of!([Encoding::NAMED], |it, encoding| it.settings.encoding = encoding), Is("\"cp852\"") =>
        "the code page of programs that are not in UTF-8, which is recognised by itself; `utf-8`: all others are an \
        error",
        "kódová stránka programů, které nejsou v UTF-8; to se pozná samo; `utf-8`: jiné jsou chyba";
    "channel-config" "MFN-2" option "--channel-config" example "\"Channel.xml\"":
        Takes::Path(|it, path| it.channel_config = Some((path, it.place))), Nothing =>
        "the ChannelConfig whose `MFunctions` give the M functions; CNC872 only",
        "ChannelConfig, jehož `MFunctions` určují M funkce; jen CNC872";
    "macrocycles" "PRG-6" option "-L" example "[\"macros\"]":
        Takes::Texts(List::Paths, |it, folders| it.macrocycles = folders), words("the program's \
            folder", "složka programu") =>
        "folders to search for macrocycles, in this order; folders in them are not searched",
        "složky, kde se hledají makrocykly, v tomto pořadí; jejich podsložky se neprohledávají";
    "block-skip" "BLK-6" option "--block-skip": Takes::Flag(|it, on| it.settings.block_skip = on), Is("false") =>
        "whether blocks with `/` are left out", "zda se bloky s `/` vynechávají";
    "optional-stop" "MFN-8" option "--optional-stop":
        Takes::Flag(|it, on| it.settings.optional_stop = on), Is("false") =>
        "whether M01 stops the program", "zda M01 program zastaví";
    "oriented-stop" "MFN-10": Takes::Flag(|it, on| it.settings.machine.oriented_stop = on), Is("true") =>
        "whether the machine has the oriented spindle stop M19", "zda stroj má stop vřetena v orientovaném bodě (M19)";
    "spindle-axis" "MFN-10" example "\"C\"":
        one_of!([spindle_axes()], |it, axis| it.settings.machine.spindle_axis = axis),
        words("`\"C\"`, else `\"A\"` or `\"B\"`, if the machine has it", "`\"C\"`, jinak `\"A\"` nebo `\"B\"`, má-li \
            ji stroj") =>
        "the rotary axis that the spindle is while M19 holds; `\"none\"`: the spindle is no axis",
        "rotační osa, kterou je vřeteno po dobu platnosti M19; `\"none\"`: vřeteno osou není";
    "oriented-position" "MFN-10":
        number(-DIMENSION, DIMENSION, |it, deg| it.settings.machine.oriented_position = deg), Is("0") =>
        "position of the spindle after M19, in degrees", "poloha vřetena po M19 ve stupních";
    "g97" "TEC-5":
        one_of!(G97, |it, meaning| it.settings.machine.g97 = meaning),
        ByDialect(|dialect| format!("\"{}\"", G97::of(dialect).name())) =>
        "what G97 means: feed per minute without constant cutting speed, or feed per revolution with it",
        "význam G97: posuv za minutu bez konstantní řezné rychlosti, nebo posuv na otáčku s ní";
    "arc-centers" "MOT-3":
        one_of!(ArcCenters, |it, order| it.settings.machine.arc_centers = order), Is("\"machine-order\"") =>
        "which axes of an arc I and J belong to: in the order of the machine's axes, or of the plane's name (YZ, ZX)",
        "ke kterým osám oblouku patří I a J: v pořadí os stroje, nebo podle názvu roviny (YZ, ZX)";
    "extensions" "§11": Takes::Texts(List::Extensions, Draft::set_extensions), Is("[\"nc\", \"ncp\", \"mpf\", \
    \"txt\"]") =>
        "extensions of programs, where a folder is searched for them; upper and lower case alike",
        "přípony programů, které se hledají ve složce; na velikosti písmen nezáleží";

    /// One of `[[axes]]`.
    AXIS:
    "letter" "ADR-4" example "\"X\"": one_of!(AxisLetter, |it, letter| it.axis.letter = Some(letter)), Required =>
        "letter of the axis, each once", "písmeno osy, každé jednou";
    "kind" "ADR-4" example "\"linear\"":
        one_of!([AXIS_KINDS], |it, rotary| it.axis.rotary = Some(rotary)),
        words("`\"rotary\"` for A, B and C, `\"linear\"` for the others", "`\"rotary\"` pro A, B a C, jinak \
            `\"linear\"`") =>
        "whether the axis travels (millimetres) or turns (degrees)",
        "zda osa jezdí (milimetry), nebo se otáčí (stupně)";
    "min" "§11" example "-10.0": number(-DIMENSION, DIMENSION, |it, min| it.axis.min = Some(min)), Nothing =>
        "least programmed coordinate, in mm or degrees; one below is warned of",
        "nejmenší programovaná souřadnice v mm nebo stupních; menší dá varování";
    "max" "§11" example "650.0": number(-DIMENSION, DIMENSION, |it, max| it.axis.max = Some(max)), Nothing =>
        "greatest programmed coordinate, in mm or degrees; one above is warned of",
        "největší programovaná souřadnice v mm nebo stupních; větší dá varování";

    /// One of `[[gears]]`.
    GEAR:
    "m" "MFN-9" example "41": whole(41, 44, |it, m| it.gear.m = u8::try_from(m).ok()), Required =>
        "the function of the range, M41 to M44, each once", "funkce rozsahu, M41 až M44, každá jednou";
    "min" "MFN-9" example "20": speed(|it, min| it.gear.min = u32::try_from(min).ok()), Required =>
        "least speed of the range in rev/min", "nejnižší otáčky rozsahu v ot/min";
    "max" "MFN-9" example "500": speed(|it, max| it.gear.max = u32::try_from(max).ok()), Required =>
        "greatest speed of the range in rev/min, not below `min`, not above `limits.speed`",
        "nejvyšší otáčky rozsahu v ot/min, ne pod `min`, ne nad `limits.speed`";
    "output" "PLC-8": number(1, 1000, |it, part| it.gear.output = Some(part)), Is("1") =>
        "part of the full voltage at `max`, for PB11 and PB12",
        "část plného napětí při `max`, pro PB11 a PB12";

    /// `[limits]`.
    LIMITS:
    "records" "FLW-9" option "--max-blocks":
        Takes::Whole { min: 1, max: None, set: |it, most| it.limits().records = narrow(most) }, Is("10000000") =>
        "most block records of a stream", "nejvyšší počet záznamů bloků ve výstupu";
    "nesting" "FLW-2": whole(1, 1000, |it, most| it.limits().nesting = narrow(most)), Is("32") =>
        "most calls open at once", "nejvyšší počet současně otevřených volání";
    "feed" "TEC-1":
        number(1000, 9_999_999_000, |it, feed| it.limits().feed = feed),
        ByDialect(|dialect| dialect.highest_feed().to_string()) =>
        "greatest feed per minute in mm/min (G94, G96)", "nejvyšší posuv za minutu v mm/min (G94, G96)";
    "speed" "§2": whole(1, HIGHEST_SPEED, |it, speed| it.limits().speed = narrow(speed)), Is("9999") =>
        "greatest spindle speed S in rev/min", "nejvyšší otáčky vřetena S v ot/min";
    "arc-tolerance" "MOT-4": number(0, DIMENSION, |it, mm| it.limits().arc_tolerance = mm), Is("0.01") =>
        "how far the radii at the start and the end of an arc may differ, in mm; a thousandth of the radius where \
        that is more",
        "o kolik se smí lišit poloměr na začátku a na konci oblouku, v mm; tisícina poloměru tam, kde je to víc";

    /// One of `[corrections]`.
    CORRECTION:
    "radius" "EQU-1" example "5.0": number(0, DIMENSION, Draft::set_correction), Required =>
        "radius of the tool in mm", "poloměr nástroje v mm";

    /// One of `[machine-macrocycles]`.
    MACHINE_MACROCYCLE:
    "axes" "FLW-12" example "[\"Z\"]":
        Takes::Texts(List::Letters, Draft::set_moved_axes), words("any axis", "kteroukoli osou") =>
        "the axes that it may move, `[]` for none; after a call the positions of these are not known",
        "osy, kterými smí pohnout, „[]“ žádnou; jejich polohy pak po volání nejsou známy";

    /// `[format]`.
    FORMAT:
    "codes" "FMT-5": one_of!([Codes::NAMED], |it, codes| it.settings.format.codes = codes), Is("\"two-digits\"") =>
        "how the numbers of G and M are written: `G01`, `G1`, or as they are",
        "jak se píšou čísla G a M: `G01`, `G1`, nebo beze změny";
    "numbers" "FMT-5":
        one_of!([Numbers::NAMED], |it, numbers| it.settings.format.numbers = numbers), Is("\"keep\"") =>
        "how coordinates, F and values of R are written: as they are, or without needless zeros (`X036.120` becomes \
        `X36.12`)",
        "jak se píšou souřadnice, F a hodnoty R: beze změny, nebo bez zbytečných nul (z `X036.120` je `X36.12`)";
    "indent" "FMT-3": whole(1, 8, |it, blanks| it.settings.format.indent = narrow(blanks)), Is("2") =>
        "blanks before a line that continues a block", "mezery před řádkem, na kterém blok pokračuje";
    "blank-lines" "FMT-4": whole(0, 9, |it, lines| it.settings.format.blank_lines = narrow(lines)), Is("1") =>
        "most empty lines in a row", "nejvyšší počet prázdných řádků za sebou";

    /// `[restart]`.
    RESTART:
    "tool-axis" "RST-2" example "\"Z\"":
        one_of!(AxisLetter, |it, letter| it.settings.machine.tool_axis = Some(letter)),
        words("`\"Z\"`; none on a lathe (G74)", "`\"Z\"`; na soustruhu (G74) žádná") =>
        "the axis along which the tool leaves the workpiece; its greater values are up",
        "osa, po které nástroj opouští obrobek; nahoru vedou větší hodnoty";
}
