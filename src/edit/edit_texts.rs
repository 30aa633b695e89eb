//! What the server says about changes of a program, in both languages.

use crate::dict::bilingual;

bilingual! {
    /// A text about changes.
    EditText {
        CreateMacrocycle { l: u32 } "create macrocycle L{l}", "vytvořit makrocyklus L{l}";
        Allow { name: &'static str } "allow `{name}` in cnc872c.toml", "povolit {name} v cnc872c.toml";
        MacrocycleStream "a macrocycle has no stream of its own: show the one of a program that calls it", "makrocyklus nemá vlastní proud bloků: zobrazte proud partprogramu, který ho volá";
        FixAll "apply all fixes of this file", "použít všechny opravy v tomto souboru";
        Renumber { step: u32 } "renumber the blocks {step} by {step}", "přečíslovat bloky po {step}";
        NumberedAlready "the blocks have these numbers already", "bloky už jsou takto očíslovány";
        NoBlocks "there are no blocks", "program nemá žádné bloky";
        UnreadableNumber { line: u32 } "the number of the block in line {line} cannot be read", "číslo bloku na řádku {line} nelze přečíst";
        JumpByParameter { line: u32 } "where the jump in line {line} leads depends on a parameter", "cíl skoku na řádku {line} závisí na parametru";
        UnclearJump { line: u32 } "it is not clear where the jump in line {line} leads", "není jasné, kam vede skok na řádku {line}";
        DuplicateTarget { number: u32 } "several blocks have the number N{number} that a jump leads to", "číslo N{number}, na které vede skok, má více bloků";
        TooManyBlocks "the program has too many blocks for these numbers", "program má pro tato čísla příliš mnoho bloků";
        TargetTooHigh "a jump would have to lead beyond N9999", "skok by musel vést na číslo vyšší než N9999";
        LineTooLong { line: u32 } "line {line} would get longer than 80 characters", "řádek {line} by byl delší než 80 znaků";
        UnknownCommand { command: String } "unknown command {command}", "neznámý příkaz {command}";
        NoProgram "a program is expected: the URI of a document", "očekává se partprogram: URI dokumentu";
        CannotCompile { errors: usize, first: String } "the program cannot be compiled; errors: {errors}, the first: {first}", "partprogram nelze přeložit; počet chyb: {errors}, první: {first}";
        NotWhole "the program cannot be compiled: execution stops before M02 or M30", "partprogram nelze přeložit: provádění končí před M02 nebo M30";
        SignalsChange "changes in this block:", "v tomto bloku se mění:";
        SignalsHold "in force besides:", "kromě toho platí:";
        AtLine { file: String, line: u32, message: String } "{file}, line {line}: {message}", "{file}, řádek {line}: {message}";
    }
}
