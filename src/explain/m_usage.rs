//! Notes on standard M functions beyond the tables, by number; an example for each, executed by a test.

use super::usage::{Usage, note, usage};
use crate::dict::Bilingual;

const SPINDLE: &[Bilingual] = &[
    note(
        "S gives the speed, in the block or before it; without any, working motions under G95 get W0604",
        "Otáčky udává S v bloku nebo před ním; bez něj mají pracovní pohyby při G95 W0604",
    ),
    note(
        "It also ends the oriented stop M19, while which the spindle is an axis",
        "Ukončí také orientovaný stop M19, při kterém je vřeteno osou",
    ),
];

const GEAR: &[Bilingual] = &[note(
    "M40: the range follows from S, by `[[gears]]` of the project file; M41 to M44 choose one, and an S outside it is \
         E0607",
    "M40: rozsah se volí podle S z `[[gears]]` v projektovém souboru; M41 až M44 ho určí a S mimo něj je E0607",
)];

const STOP: &[Bilingual] = &[
    note(
        "While the program stands, spindle and coolants are off; START brings back what was in force, unless the \
         block says otherwise",
        "Po dobu stání je vypnuto vřeteno i chlazení; START vrátí, co platilo, pokud blok neurčí jinak",
    ),
    note(
        "M01 stops only while optional stop is switched on: `optional-stop`, --optional-stop",
        "M01 zastaví, jen je-li zapnut volitelný stop: `optional-stop`, --optional-stop",
    ),
];

const END: &[Bilingual] = &[
    note(
        "M02 and M30 do the same. G functions and M groups 2 to 6 and 8 go back to what holds after power-up",
        "M02 a M30 dělají totéž. Funkce G a M skupiny 2 až 6 a 8 se vrátí na to, co platí po zapnutí",
    ),
    note(
        "Only subprograms may come after it. In a subprogram or macrocycle it ends the whole program (W0215): they \
         end with G70",
        "Za ní smějí být jen podprogramy. V podprogramu nebo makrocyklu ukončí celý program (W0215): ty končí funkcí \
        G70",
    ),
];

const CLAMP: &[Bilingual] = &[note(
    "It holds in its block only; the workpiece stays clamped after M10 and released after M11 in the next blocks too",
    "Platí jen ve svém bloku; po M10 zůstane obrobek upnut a po M11 uvolněn i v dalších blocích",
)];

const COOLANT: &[Bilingual] = &[
    note(
        "M07 and M08 are exchanged between the controls: coolant 2 and 1 on CNC8x6 and CNC8x9, 1 and 2 on CNC872. M09 \
         ends both, M17 starts both",
        "M07 a M08 jsou mezi systémy prohozené: chlazení 2 a 1 u CNC8x6 a CNC8x9, 1 a 2 u CNC872. M09 vypne obě, M17 \
         zapne obě",
    ),
    note(
        "M50, M51, M52 are coolants 3, 4 and both; M53 ends them",
        "M50, M51, M52 jsou chlazení 3, 4 a obě; vypne je M53",
    ),
];

/// Standard M functions, in groups that are written alike.
pub(super) const USAGES: &[Usage<u8>] = &[
    usage(&[0, 1], "M00", "N10 G90 G00 Z100\nN20 M00 \"turn the part\"\nN30 Z2", STOP),
    usage(&[2, 30], "M30", "N10 G90 G00 Z100\nN20 M30", END),
    usage(&[3, 4], "S… M03", "N10 S1200 M03\nN20 G90 G00 Z2\nN30 M05", SPINDLE),
    usage(
        &[5],
        "M05",
        "N10 S1200 M03\nN20 G90 G00 Z2\nN30 M05",
        &[note(
            "It also ends the oriented stop M19, while which the spindle is an axis",
            "Ukončí také orientovaný stop M19, při kterém je vřeteno osou",
        )],
    ),
    usage(
        &[6],
        "T… M06",
        "N10 T3 M06\nN20 S1200 M03",
        &[
            note(
                "T only names the tool, M06 changes it; without a T before: W0620",
                "T nástroj jen určí, vymění ho M06; bez předchozího T: W0620",
            ),
            note(
                "Whether the change moves the axes is in the ChannelConfig: `ChangePos`. Then their positions are \
                 unknown after it",
                "Zda výměna pohne osami, je v ChannelConfigu: `ChangePos`. Polohy os pak nejsou známé",
            ),
        ],
    ),
    usage(
        &[19],
        "M19",
        "N10 M19\nN20 G90 G00 C90\nN30 M05",
        &[
            note(
                "Until M03, M04 or M05 the spindle is a rotary axis, F in degrees per minute: by `spindle-axis`, else \
                C, A or B",
                "Do M03, M04 nebo M05 je vřeteno rotační osou, F ve stupních za minutu: podle `spindle-axis`, jinak \
                C, A nebo B",
            ),
            note(
                "It puts the spindle at `oriented-position`, 0 unless configured. A machine without it: \
                `oriented-stop = false`",
                "Natočí vřeteno do `oriented-position`, není-li nastavena, do 0. Stroj bez ní: `oriented-stop = false`",
            ),
        ],
    ),
    usage(&[40, 41, 42, 43, 44], "M40 S…", "N10 M40 S1200 M03", GEAR),
    usage(&[7, 8, 9, 17], "M08", "N10 M08\nN20 G90 G00 Z2\nN30 M09", COOLANT),
    usage(&[50, 51, 52, 53], "M50", "N10 M50\nN20 G90 G00 Z2\nN30 M53", COOLANT),
    usage(
        &[36, 37],
        "M37",
        "N10 G90 G00 X0\nN20 M37 G01 X10 F200\nN30 M36",
        &[note(
            "CNC8x6 and CNC8x9: M37 reduces the feed to a hundredth, until M36. The stream has F as programmed and \
             `feed_scale` 0.01",
            "CNC8x6 a CNC8x9: M37 zmenší posuv na setinu, do M36. V proudu bloků je F, jak je naprogramováno, a \
             `feed_scale` 0.01",
        )],
    ),
    usage(
        &[48, 49],
        "M49",
        "N10 M49\nN20 G90 G01 X10 F200\nN30 M48",
        &[note(
            "M49: the feed override of the panel has no effect; M48: it has",
            "M49: ruční ovládání posuvu na panelu neúčinkuje; M48: účinkuje",
        )],
    ),
    usage(&[10, 11], "M10", "N10 M10\nN20 G90 G00 X0\nN30 M11", CLAMP),
    usage(&[60], "M60", "N10 G90 G00 Z100\nN20 M60\nN30 X0 Y0", &[]),
];

/// The notes on a function beyond the tables.
pub(super) fn of(number: u8) -> Option<&'static Usage<u8>> {
    USAGES.iter().find(|usage| usage.codes.contains(&number))
}
