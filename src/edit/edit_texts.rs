//! Texts of the server about changes of a program, in both languages.

use crate::diag::Code;
use crate::dict::bilingual;

bilingual! {
    /// A text about changes.
    EditText {
        CreateMacrocycle { l: u32 } "create macrocycle L{l}", "vytvořit makrocyklus L{l}";
        Allow { name: &'static str } "allow `{name}` in cnc872c.toml", "povolit {name} v cnc872c.toml";
        MacrocycleStream
            "a macrocycle has no stream of its own: show the one of a program that calls it",
            "makrocyklus nemá vlastní proud bloků: zobrazte proud partprogramu, který ho volá";
        FixAll "apply all fixes of this file", "použít všechny opravy v tomto souboru";
        Renumber { step: u32 } "renumber the blocks {step} by {step}", "přečíslovat bloky po {step}";
        NumberedAlready "the blocks have these numbers already", "bloky už jsou takto očíslovány";
        NoBlocks "there are no blocks", "program nemá žádné bloky";
        Unread { line: u32, code: Code } "line {line} cannot be read ({code})", "řádek {line} nelze přečíst ({code})";
        UnreadableNumber { line: u32 }
            "the number of the block in line {line} cannot be read",
            "číslo bloku na řádku {line} nelze přečíst";
        JumpByParameter { block: u32, line: u32, word: String }
            "where N{block} in line {line} jumps depends on a parameter: {word}",
            "kam skáče N{block} na řádku {line}, závisí na parametru: {word}";
        NoSuchBlock { number: u32 } "there is no block N{number} in that place", "blok N{number} tam není";
        PartBackwards { from: u32, to: u32 }
            "N{to} (--to) stands before N{from} (--from)",
            "blok N{to} (--to) je před blokem N{from} (--from)";
        NoSuchUnit { l: u32 } "there is no subprogram L{l} in the file", "podprogram L{l} v souboru není";
        NumberTaken { number: u32 }
            "the new number N{number} belongs to a block outside the part: name a free one by --start",
            "nové číslo N{number} už má blok mimo číslovanou část: volné určí --start";
        UnclearJump { line: u32 }
            "it is not clear where the jump in line {line} leads",
            "není jasné, kam vede skok na řádku {line}";
        DuplicateTarget { number: u32 }
            "several blocks have the number N{number} that a jump leads to",
            "číslo N{number}, na které vede skok, má více bloků";
        TooManyBlocks
            "the program has too many blocks for these numbers",
            "program má pro tato čísla příliš mnoho bloků";
        TargetTooHigh { step: u32 }
            "a jump would have to lead beyond N9999; the largest step that works is {step}",
            "skok by musel vést na číslo vyšší než N9999; největší možný krok je {step}";
        TargetTooFar
            "a jump would have to lead beyond N9999, whatever the step",
            "skok by musel vést na číslo vyšší než N9999 při každém kroku";
        LineTooLong { line: u32 }
            "line {line} would get longer than 80 characters",
            "řádek {line} by byl delší než 80 znaků";
        UnknownCommand { command: String } "unknown command {command}", "neznámý příkaz {command}";
        NoProgram "a program is expected: the URI of a document", "očekává se partprogram: URI dokumentu";
        CannotCompile { errors: usize, first: String }
            "the program cannot be compiled; errors: {errors}, the first: {first}",
            "partprogram nelze přeložit; počet chyb: {errors}, první: {first}";
        NotWhole
            "the program cannot be compiled: execution stops before M02 or M30",
            "partprogram nelze přeložit: provádění končí před M02 nebo M30";
        ErrorBefore
            "the program has errors before this block: what holds here is not known",
            "před tímto blokem má program chyby: co zde platí, není známo";
        TooLong { blocks: u64 }
            "the block is not among the first {blocks} that are executed: ask `cnc872c state`",
            "blok není mezi prvními {blocks} provedenými: zeptejte se příkazem cnc872c state";
        Passes { n: u32, count: u64 }
            "N{n} is executed {count} times: which execution?",
            "N{n} se provede {count}krát: které provedení?";
        NoHeight { text: String }
            "{text} is no height in mm with at most three decimals",
            "{text} není výška v mm s nejvýš třemi desetinnými místy";
        SignalsChange "changes in this block:", "v tomto bloku se mění:";
        SignalsHold "in force besides:", "kromě toho platí:";
        AtLine { file: String, line: u32, message: String }
            "{file}, line {line}: {message}",
            "{file}, řádek {line}: {message}";
    }
}
