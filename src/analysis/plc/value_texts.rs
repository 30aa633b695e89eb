//! What gives the value of signals, in both languages: by rule, and by cell where a rule is about cells of many kinds.

use super::dictionary::{Cell, Flag};
use crate::dict::Bilingual;

/// What gives the value of the signals of a rule, PLC-1 to PLC-15.
pub const fn rule_text(rule: u8) -> Bilingual {
    let (en, cs) = match rule {
        1 => (
            "The function in force in BCD: M95 is 95h, M100 is 100h. Groups 1, 7 and 9 have a value only in their \
             block; without a function there is none",
            "Platná funkce v BCD: M95 je 95h, M100 je 100h. Skupiny 1, 7 a 9 mají hodnotu jen ve svém bloku; bez \
             funkce hodnota chybí",
        ),
        2 => (
            "1 for the length of a block that programs the group, even with the same function, and where M02, M30, a \
             stop or M40 changes it",
            "1 po dobu bloku, ve kterém je skupina programována, i stejnou funkcí, a tam, kde ji mění M02, M30, stop \
            nebo M40",
        ),
        3 => ("1 in blocks of which it is true", "1 v blocích, pro které to platí"),
        4 => (
            "1 when the axis is written in a block that moves, or is one of the two of an arc. AxNC counts in the \
             order of the machine; in PO_OS and SM_PO X, Y, Z are these letters, 4, 5, 6 … the other ones in the \
             order of the machine. Beyond its axes it is 0",
            "1, když je osa zapsána v bloku s pohybem nebo je jednou ze dvou os oblouku. AxNC se počítá v pořadí \
             stroje; v PO_OS a SM_PO jsou X, Y, Z tato písmena, 4, 5, 6 … ostatní v pořadí stroje. Za osami stroje je \
             0",
        ),
        5 => (
            "1 when the programmed coordinate falls, 0 when it rises. No value when the axis does not move, when its \
             distance is 0 or unknown, when it turns back within the block, or under G31, G35, G36, G38, G39",
            "1, když programovaná souřadnice klesá, 0, když roste. Bez hodnoty, když se osa nepohybuje, když je její \
             dráha 0 nebo neznámá, když se v bloku obrací, nebo při G31, G35, G36, G38, G39",
        ),
        6 => ("As in the block stream: see the cell", "Jako v proudu bloků: viz buňku"),
        7 => (
            "Two decades in BCD; no value while nothing is programmed. M100, and an H above 99, with a fraction or a \
             sign, do not fit: 00h and W0901",
            "Dvě dekády v BCD; bez hodnoty, dokud není nic programováno. M100 a H nad 99, s desetinnou částí nebo se \
             znaménkem se nevejdou: 00h a W0901",
        ),
        8 => (
            "S / max · output · 7FFFh, both of the gear in force; no value without [[gears]], without a known gear, \
             and where S is a cutting speed",
            "S / max · output · 7FFFh, obojí zařazeného stupně; bez hodnoty, když chybí [[gears]], když stupeň není \
             znám a když je S řezná rychlost",
        ),
        9 => (
            "1 for one block, the one in which the function is written; M01 also when optional stop is off",
            "1 po dobu jednoho bloku, ve kterém je funkce zapsána; M01 i při vypnutém volitelném stopu",
        ),
        10 => (
            "By the function in force, those of power-up included; ranges under M40 by the gear, without a value when \
             that is not known",
            "Podle platné funkce, i té po zapnutí; rozsahy při M40 podle zařazeného stupně, bez hodnoty, když není \
            znám",
        ),
        11 => ("While the function is in force; AUTPI always", "Dokud funkce platí; AUTPI vždy"),
        12 => (
            "1 in a block that writes the word, even with the same value",
            "1 v bloku, ve kterém je slovo zapsáno, i se stejnou hodnotou",
        ),
        13 => (
            "Under M41–M44, and under M40 with [[gears]]; else no value",
            "Při M41–M44 a při M40 s [[gears]]; jinak bez hodnoty",
        ),
        14 => ("1 in a block with a dwell above 0", "1 v bloku s prodlevou větší než 0"),
        17 => ("1 in the step in which the program stands", "1 v kroku, ve kterém program stojí"),
        _ => (
            "With [motion]: 1 in a stretch of two blocks or more, else 0; without it no value",
            "S [motion]: 1 v úseku dvou nebo více bloků, jinak 0; bez [motion] bez hodnoty",
        ),
    };
    Bilingual { en, cs }
}

/// What gives the value of a cell, where its rule is about cells of many kinds (PLC-3, PLC-6).
pub(super) const fn value_of(cell: Cell) -> Option<Bilingual> {
    let (en, cs) = match cell {
        Cell::Flag(flag) => return fact(flag),
        Cell::Tool => (
            "The T in force, in BCD: T12 is 12h; no value before the first T",
            "Platné T v BCD: T12 je 12h; bez hodnoty před prvním T",
        ),
        Cell::H => (
            "The H in force, as written, with sign and fraction; no value before the first H",
            "Platné H, jak je zapsáno, se znaménkem a desetinnou částí; bez hodnoty před prvním H",
        ),
        Cell::Delay => (
            "Q of G04 in s, a hundredth of the number written; no value without G04",
            "Q funkce G04 v s, setina zapsaného čísla; bez G04 bez hodnoty",
        ),
        Cell::Position(_) => (
            "The programmed coordinate after the block; no value while it is not known, and beyond the axes of the \
            machine",
            "Programovaná souřadnice po bloku; bez hodnoty, dokud není známa, a za osami stroje",
        ),
        Cell::BlockLen => (
            "Length of the programmed path, `length_mm` of the record, of rotary axes alone `length_deg`; no value \
             without motion or when the start is unknown",
            "Délka programované dráhy, `length_mm` záznamu, u samotných rotačních os `length_deg`; bez hodnoty, když \
             se v bloku nic nepohybuje nebo není znám začátek",
        ),
        Cell::FeedProgr => (
            "The F in force, also under G00; no value before the first F",
            "Platné F, i při G00; bez hodnoty před prvním F",
        ),
        Cell::SpindleSpeed => (
            "The S in force, also while the spindle stands; no value before the first S, and where S is a cutting \
            speed",
            "Platné S, i když vřeteno stojí; bez hodnoty před prvním S a když je S řezná rychlost",
        ),
        Cell::ParabAccel => (
            "P/500 of the dynamic set in force, while G00 is in force of that of G00; only with [motion] and the \
             profile parabolic, under G00 or in G23; else no value",
            "P/500 platné sady dynamiky, při G00 sady rychloposuvu; jen s [motion] a parabolickým průběhem, při G00 \
             nebo G23; jinak bez hodnoty",
        ),
        Cell::LinearAccel => (
            "`linear-mm-s2` of the dynamic set in force, while G00 is in force of that of G00; only with [motion] and \
             the profile parabolic, under G00 or in G23; else no value",
            "`linear-mm-s2` platné sady dynamiky, při G00 sady rychloposuvu; jen s [motion] a parabolickým průběhem, \
             při G00 nebo G23; jinak bez hodnoty",
        ),
        Cell::TimeDist => (
            "With [motion]: whole milliseconds in a stretch of two blocks or more; else no value",
            "S [motion]: celé milisekundy v úseku dvou nebo více bloků; jinak bez hodnoty",
        ),
        Cell::Group(_)
        | Cell::Mark(_)
        | Cell::Moves(_)
        | Cell::Request(_)
        | Cell::Backwards(_)
        | Cell::GroupByte(_)
        | Cell::HByte
        | Cell::ToolByte(_)
        | Cell::SpeedByte { .. }
        | Cell::Written(_)
        | Cell::Spindle(_)
        | Cell::Range(_)
        | Cell::Coolant12(_)
        | Cell::Coolant34(_)
        | Cell::Gear
        | Cell::Stretch => return None,
    };
    Some(Bilingual { en, cs })
}

/// What gives the value of a fact of the block (PLC-3).
const fn fact(flag: Flag) -> Option<Bilingual> {
    let (en, cs) = match flag {
        Flag::First => (
            "1 in the first executed block, `first_block` of the record",
            "1 v prvním provedeném bloku, `first_block` záznamu",
        ),
        Flag::Last => (
            "1 in the block whose M02 or M30 ends the program, `last_block` of the record",
            "1 v bloku, jehož M02 nebo M30 ukončí program, `last_block` záznamu",
        ),
        Flag::Stop => (
            "1 in a block that writes M00, `stop` of the record; 0 while the program stands at it",
            "1 v bloku, ve kterém je zapsáno M00, `stop` záznamu; 0, když na něm program stojí",
        ),
        Flag::CondStop => (
            "1 in a block that writes M01, also when optional stop is off, `cond_stop` of the record",
            "1 v bloku, ve kterém je zapsáno M01, i při vypnutém volitelném stopu, `cond_stop` záznamu",
        ),
        Flag::HProg => (
            "1 in a block that writes H, even with the same value, `h_set` of the record",
            "1 v bloku, ve kterém je zapsáno H, i se stejnou hodnotou, `h_set` záznamu",
        ),
        Flag::TProg => (
            "1 in a block that writes T, even with the same value, `t_set` of the record",
            "1 v bloku, ve kterém je zapsáno T, i se stejnou hodnotou, `t_set` záznamu",
        ),
        Flag::RevFeed => (
            "1 while F is in mm per revolution, `rev_feed` of the record",
            "1, dokud je F v mm na otáčku, `rev_feed` záznamu",
        ),
        Flag::ContinuousMode => (
            "1 while G23 is in force, `continuous_mode` of the record",
            "1, dokud platí G23, `continuous_mode` záznamu",
        ),
        Flag::ConstCutSpeed => (
            "1 while the cutting speed is held constant, `const_cut_speed` of the record",
            "1, dokud se udržuje konstantní řezná rychlost, `const_cut_speed` záznamu",
        ),
        Flag::Reference => (
            "1 in a block that writes G30, with or without axes; 0 while the program stands in it",
            "1 v bloku, ve kterém je zapsáno G30, s osami i bez nich; 0, když v něm program stojí",
        ),
        Flag::Rapid | Flag::Thread | Flag::Automatic | Flag::Dwell | Flag::Standing => return None,
    };
    Some(Bilingual { en, cs })
}
