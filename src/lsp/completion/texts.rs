//! What items of completion say, in both languages.

use crate::dict::{GCode, GGroup, bilingual};

bilingual! {
    /// A text of an item.
    ItemText {
        NextBlock "next block number", "další číslo bloku";
        Group { group: GGroup, meaning: &'static str } "Group {group}: {meaning}.", "Skupina {group}: {meaning}.";
        MGroup { group: u8 } "Group {group}.", "Skupina {group}.";
        Modal "Holds until another function of its group.", "Platí do další funkce téže skupiny.";
        OneBlock "Holds in its own block only.", "Platí jen ve svém bloku.";
        PowerUp "In force after power-up, M02 and M30.", "Platí po zapnutí a po M02 a M30.";
        Clashes { with: String } "clashes with {with} in this block", "vylučuje se s {with} v tomto bloku";
        OfMachine { group: u8 } "function of the machine, group {group}", "funkce stroje, skupina {group}";
        BreakCont "Breaks continuous motion at the start of the block.", "Přeruší plynulou návaznost na začátku bloku.";
        BreakContEnd "Breaks continuous motion at the end of the block.", "Přeruší plynulou návaznost na konci bloku.";
        ChangePos "Moves the machine: positions are unknown after it.", "Mění polohu stroje: poté jsou polohy neznámé.";
        NeedsDwell
            "Needs `Q`, the time in units of 10 ms: `Q50` is half a second.",
            "Vyžaduje `Q`, dobu po 10 ms: `Q50` je půl sekundy.";
        NeedsSubprogram
            "Needs `L`, the number of the subprogram; `Q`: how many times.",
            "Vyžaduje `L`, číslo podprogramu; `Q`: kolikrát.";
        NeedsMacrocycle
            "Needs `L`, the number of the macrocycle; `Q`: how many times.",
            "Vyžaduje `L`, číslo makrocyklu; `Q`: kolikrát.";
        NeedsBlock
            "Needs `L`, the number of the block; `Q`: how many jumps.",
            "Vyžaduje `L`, číslo bloku; `Q`: počet skoků.";
        NeedsEntry
            "Needs `L`, its number; nothing else stands in the block.",
            "Vyžaduje `L`, své číslo; nic jiného v bloku nestojí.";
        NeedsCentre
            "`I` and `J` are the distances from the start to the centre.",
            "`I` a `J` jsou vzdálenosti středu od začátku oblouku.";
        NeedsControl { last: usize }
            "Needs its control words in the same block, `R5` to `R{last}`.",
            "Vyžaduje řídicí slova v témže bloku, `R5` až `R{last}`.";
        NeedsOneControl "Needs its control word `R5` in the same block.", "Vyžaduje řídicí slovo `R5` v témže bloku.";
        DynamicSet "`I1` to `I4` chooses the dynamic set.", "`I1` až `I4` volí sadu dynamiky.";
        MakesData
            "The axis words of the block are data; nothing moves.",
            "Slova os v bloku jsou data; nic se nepohybuje.";
        CallsMacrocycle { l: u32 }
            "Calls macrocycle L{l} after every motion.",
            "Po každém pohybu volá makrocyklus L{l}.";
        Linear "linear axis", "lineární osa";
        Rotary "rotary axis", "rotační osa";
        Range { range: String } "Value: {range}.", "Hodnota: {range}.";
        FourDigits "four digits, each 0, 1 or 2", "čtyři číslice, každá 0, 1 nebo 2";
        ParameterRange "0–95, then `=` and a number or parameter", "0–95, pak `=` a číslo nebo parametr";
        UntilChanged "Holds until changed.", "Platí do změny.";
        Called { count: usize } "called {count}×", "volán {count}×";
        InProgram { count: u32 } "{count}× in the program", "{count}× v programu";
        NotCalled "not called", "není volán";
        NextSubprogram "next free number of a subprogram", "další volné číslo podprogramu";
        Missing "called, but not there yet", "volán, ale zatím chybí";
        OwnNumber "the number of this macrocycle", "číslo tohoto makrocyklu";
        Assigned { value: String, n: u32 } "= {value} in N{n}", "= {value} v bloku N{n}";
        Configured { value: String } "= {value} by configuration", "= {value} podle konfigurace";
        Unassigned "not assigned here", "zde nepřiřazen";
        ControlWord { code: GCode } "control word of {code}", "řídicí slovo {code}";
        ControlForm
            "Eight digits `oo aa bb rr`: operation, parameter of the first operand, of the second, of the result. `-` \
            before them: whole-number arithmetic.",
            "Osm číslic `oo aa bb rr`: operace, parametr prvního operandu, druhého operandu, výsledku. Znaménko `-` \
            před nimi: celočíselná aritmetika.";
        NameProgram "program", "program";
        NameSubprogram "subprogram", "podprogram";
        NameMacrocycle "macrocycle", "makrocyklus";
        NameLoop "loop", "smyčka";
        AboutProgram "a new program", "nový program";
        AboutSubprogram { l: u32 } "a new subprogram L{l}", "nový podprogram L{l}";
        AboutMacrocycle { l: u32 } "the frame of macrocycle L{l}", "kostra makrocyklu L{l}";
        AboutLoop "a stretch that is repeated by G73", "úsek opakovaný skokem G73";
        Title "title", "název";
        Body "body", "tělo";
    }
}
