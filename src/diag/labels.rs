//! The texts of secondary places and of fixes, in both languages.

use crate::dict::bilingual;

bilingual! {
    /// The text of a secondary place.
    LabelText {
        First { what: String } "`{what}` is the first one", "první je {what}";
        FirstBlock { block: u32 } "N{block} is used here first", "N{block} je poprvé zde";
        EndsHere { function: u8 } "M{function:02} ends the program here", "M{function:02} končí program už zde";
        EndHere { function: u8 }
            "M{function:02} is here, after subprograms",
            "M{function:02} je až zde, za podprogramy";
        FileEnds "the file ends here", "zde soubor končí";
        InPlaceOfG70 { function: u8 } "M{function:02} is here in place of G70", "místo G70 je zde M{function:02}";
        WithoutEntry
            "these blocks end with G70, but no G79 begins them",
            "tyto bloky končí funkcí G70, ale žádná G79 je nezačíná";
        ParameterValue { parameter: u8, value: String }
            "R{parameter} got the value {value} here",
            "zde dostal R{parameter} hodnotu {value}";
        ParameterGiven { parameter: u8, value: String }
            "R{parameter} is {value} by the configuration or the command line",
            "R{parameter} má hodnotu {value} z konfigurace nebo z příkazového řádku";
        AssignedHere { parameter: u8 } "R{parameter} is assigned here", "zde se do R{parameter} přiřazuje";
        InForce { function: String } "{function} is in force", "platí {function}";
        MakesArc { function: String }
            "it is an arc because {function} is in force",
            "je to oblouk, protože platí {function}";
        BlockHere { block: u32 } "block N{block} is here", "blok N{block} je zde";
        UnitBegins { l: u32 } "L{l} begins here", "L{l} začíná zde";
        MacrocycleFile { name: String } "one of them: {name}", "jeden z nich: {name}";
        ShowsIt { text: String }
            "such a control writes `{text}`",
            "takto píše „{text}“ jiný systém";
        FeedPerRevolution "written as a feed per revolution", "zadáno jako posuv na otáčku";
        FeedPerMinute "written as a feed per minute", "zadáno jako posuv za minutu";
        PositionLost { m: u8 }
            "M{m:02} moves the machine: from here on the position is not known",
            "M{m:02} hýbe strojem: od tohoto místa není poloha známa";
        GearHere { m: u8 } "M{m} is programmed here", "zde je programováno M{m}";
    }
}

bilingual! {
    /// The effect of a fix.
    FixTitle {
        Write { text: String } "write `{text}`", "napsat „{text}“";
        PlainQuotes "write plain quotes `\"`", "napsat obyčejné uvozovky \"";
        Utf8 "write the file in UTF-8", "zapsat soubor v UTF-8";
        PlainBlank "write a plain blank", "napsat obyčejnou mezeru";
        Comment "make a comment of it, between quotes", "udělat z toho komentář v uvozovkách";
        Delete { text: String } "delete `{text}`", "vymazat „{text}“";
        Insert { text: String } "insert `{text}`", "vložit „{text}“";
        DeleteBlock { block: u32 } "delete N{block}", "vymazat N{block}";
        DeleteSubprogram { l: u32 } "delete the subprogram L{l}", "vymazat podprogram L{l}";
        UpperCase "write addresses in upper case", "psát adresy velkými písmeny";
        MoveSkip { block: u32 } "move `/` behind N{block}", "přesunout „/“ za N{block}";
    }
}
