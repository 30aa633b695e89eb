//! Texts of the server about numbers, and why one cannot be changed, in both languages.

use crate::dict::bilingual;

bilingual! {
    /// A text about a number.
    NavigationText {
        OpenMacrocycle { l: u32 } "open macrocycle L{l}", "otevřít makrocyklus L{l}";
        MainProgram "main program", "hlavní program";
        Subprogram "subprogram", "podprogram";
        Macrocycle { file: String } "macrocycle {file}", "makrocyklus {file}";
        NothingToRename "there is no number here that can be changed", "zde není číslo, které by šlo změnit";
        BlockNumber "a block number is a whole number from 1 to 99999999", "číslo bloku je celé číslo od 1 do 99999999";
        ReachableBlock { n: u32 }
            "jumps lead to block N{n}, and G73 reaches block numbers up to 9999 only",
            "na blok N{n} vedou skoky a G73 dosáhne jen na čísla bloků do 9999";
        SubprogramNumber
            "the number of a subprogram or macrocycle is a whole number from 1 to 9999",
            "číslo podprogramu i makrocyklu je celé číslo od 1 do 9999";
        ParameterNumber
            "the number of a parameter is a whole number from 0 to 95",
            "číslo parametru je celé číslo od 0 do 95";
        LineTooLong { line: u32 }
            "line {line} would get longer than 80 characters",
            "řádek {line} by byl delší než 80 znaků";
        BlockExists { n: u32 } "block N{n} exists in this file already", "blok N{n} už v tomto souboru je";
        SubprogramExists { l: u32 }
            "subprogram L{l} exists in this file already",
            "podprogram L{l} už v tomto souboru je";
        WouldLeadHere { call: String }
            "{call} leads nowhere now and would then lead here",
            "{call} teď nikam nevede a pak by vedl sem";
        Unclear { n: u32, l: u32 }
            "what L{l} in block N{n} names is known only when the program runs",
            "co v bloku N{n} označuje L{l}, je známo až za běhu programu";
        JumpByParameter { n: u32, r: u8 }
            "block N{n} takes the number of a block from R{r}: it may jump here",
            "blok N{n} bere číslo bloku z R{r}: může skákat sem";
        CallByParameter { n: u32, r: u8 }
            "block N{n} takes the number of its call from R{r}: it may call this one",
            "blok N{n} bere číslo volaného celku z R{r}: může volat tento";
        Unread { n: u32 }
            "the number behind L in block N{n} cannot be read: it may be this one",
            "číslo za L v bloku N{n} nelze přečíst: může to být toto";
        UnreadUse { what: String, line: u32 }
            "line {line} has {what} in a place that cannot be read: fix that first",
            "na řádku {line} je {what} na místě, které nelze přečíst: nejdřív ho opravte";
        MacrocycleExists { l: u32 } "macrocycle L{l} exists already", "makrocyklus L{l} už existuje";
        MacrocycleFile { l: u32 }
            "the file of macrocycle L{l} is named by its number, and programs that are not open may call it",
            "soubor makrocyklu L{l} se jmenuje podle jeho čísla a volat ho mohou i programy, které nejsou otevřené";
        MacrocycleConfigured { l: u32, key: String }
            "the key {key} of the project file names macrocycle L{l}",
            "na makrocyklus L{l} odkazuje klíč {key} v projektovém souboru";
        Reserved { r: u8 } "R{r} is reserved for control functions", "R{r} je vyhrazen pro řídicí funkce";
        ControlParameter
            "R5–R8 hold the control words of G26–G29, which the program uses",
            "R5–R8 nesou řídicí slova funkcí G26–G29, které program používá";
        Configured { r: u8 } "the configuration gives R{r} a value", "parametru R{r} dává hodnotu konfigurace";
        UsedInMacrocycle { r: u8, l: u32 }
            "macrocycle L{l} uses R{r} too, and programs that are not open may call it",
            "R{r} používá i makrocyklus L{l}, který mohou volat i programy, které nejsou otevřené";
        UnknownMacrocycle { n: u32 }
            "block N{n} may call a macrocycle that is known only when the program runs, and that may use the parameter",
            "blok N{n} může volat makrocyklus, který je znám až za běhu programu a může parametr používat";
        MissingMacrocycle
            "a called macrocycle cannot be loaded, and may use the parameter",
            "makrocyklus, který program volá, není k dispozici a může parametr používat";
        UnknownControlWord { n: u32 }
            "which parameters the control word in block N{n} names is not known",
            "které parametry označuje řídicí slovo v bloku N{n}, není známo";
        NotExecuted
            "the program has errors: which values its parameters have is not known",
            "program obsahuje chyby: jaké hodnoty mají parametry, není známo";
        NeverAssigned { r: u8 }
            "nothing here assigns R{r}: its value comes from the parameter table of the machine",
            "R{r} zde nedostává hodnotu: bere se z tabulky parametrů stroje";
        NeverRead { r: u8 }
            "nothing here reads R{r}: what it is for is not known",
            "R{r} zde nikdo nečte: není známo, k čemu slouží";
        ReadBeforeAssigned { r: u8 }
            "R{r} is read before the program assigns it: its value comes from the parameter table of the machine",
            "R{r} se čte dříve, než dostane hodnotu: bere se z tabulky parametrů stroje";
        ParameterUsed { r: u8 } "R{r} is used already", "R{r} se už používá";
    }
}
