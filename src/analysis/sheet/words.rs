//! Texts of the set-up sheet, in both languages.

use crate::dict::bilingual;

bilingual! {
    /// Headings and cells.
    Words {
        Title { name: String } "Set-up sheet: {name}", "Seřizovací list: {name}";
        Program "Program", "Program";
        Control "Control", "Systém";
        Time "Time", "Čas";
        AtLeast { what: String } "at least {what}", "nejméně {what}";
        Assumed
            "estimated for an assumed machine: [motion] is not configured",
            "odhad pro předpokládaný stroj: [motion] není nastaveno";
        Work "Size of the work", "Rozměry";
        Motions "Motions", "Pohyby";
        Axis "Axis", "Osa";
        Working "working motions", "pracovní pohyby";
        All "all motions", "všechny pohyby";
        From "from", "od";
        To "to", "do";
        Size "size", "rozměr";
        Diameter { letter: String } "{letter} (diameter)", "{letter} (průměr)";
        MissingBlocks "missing", "chybí";
        Missing { blocks: String } "without {blocks}", "bez {blocks}";
        Tools "Tools", "Nástroje";
        Tool "Tool", "Nástroj";
        NoTool "before the first M06", "před prvním M06";
        First "first in", "poprvé v";
        Changes "changes", "výměn";
        Path "working path", "pracovní dráha";
        Rapid "G00", "G00";
        Feeds "F", "F";
        Speeds "S", "S";
        CuttingSpeed { speeds: String } "{speeds} (constant cutting speed)", "{speeds} (konstantní řezná rychlost)";
        Revolutions { speeds: String } "{speeds} rev/min", "{speeds} ot/min";
        D "D", "D";
        Reach "reach", "rozsah";
        MFunctions "M functions", "M funkce";
        M "M", "M";
        Count "times", "počet";
        Parameters "Parameters read from the machine", "Parametry čtené ze stroje";
        Parameter "Parameter", "Parametr";
        Value "taken as", "předpokládá se";
        Unknown "not known", "neznámo";
        PartlyUnknown "partly not known", "zčásti neznámo";
        Units "Subprograms and macrocycles", "Podprogramy a makrocykly";
        Unit "Unit", "Celek";
        Subprogram { l: u32 } "subprogram L{l}", "podprogram L{l}";
        Macrocycle { l: u32 } "macrocycle L{l}", "makrocyklus L{l}";
        Runs "runs", "průchodů";
        Nothing "none", "žádné";
    }
}
