//! What hovers, hints and lenses say, in both languages.

use crate::dict::bilingual;

bilingual! {
    /// A text about a word, a block or an execution.
    Said {
        UntilNext "holds until another function of its group", "platí do další funkce téže skupiny";
        UntilNextAndDefault
            "holds until another function of its group; also after power-up, M02 and M30",
            "platí do další funkce téže skupiny; také po zapnutí, M02 a M30";
        InBlock "holds in its block only", "platí jen ve svém bloku";
        UntilChanged "holds until changed", "platí do změny";
        GGroup { group: String, meaning: &'static str } "group {group}: {meaning}", "skupina {group}: {meaning}";
        MGroup { group: u8 } "group {group} of the M functions", "skupina {group} funkcí M";
        ByBuilder "what it does is up to the machine builder", "co dělá, určuje výrobce stroje";
        BreakCont "breaks continuous motion at the start of the block", "na začátku bloku přeruší plynulou návaznost";
        BreakContEnd "breaks continuous motion at the end of the block", "na konci bloku přeruší plynulou návaznost";
        ChangePos "moves the machine; positions are unknown after it", "pohne strojem; polohy po něm nejsou známy";
        LinearAxis "linear axis", "lineární osa";
        RotaryAxis "rotary axis", "rotační osa";
        CuttingSpeed "constant cutting speed", "konstantní řezná rychlost";
        DynamicSet "dynamic set of G23", "sada dynamiky funkce G23";
        Reserved "reserved for functions of the control", "vyhrazen pro funkce řídicího systému";
        MayControl
            "with G26–G29 in the block, a control word of parameter arithmetic",
            "s G26–G29 v bloku řídicí slovo aritmetiky parametrů";
        Control { formula: String } "control word: {formula}", "řídicí slovo: {formula}";
        InWholes "in whole numbers", "v celých číslech";
        Dwell { s: String } "dwell {s} s", "časová prodleva {s} s";
        Plc "the PLC reads", "PLC čte";
        PlcAtStop "while the program stands", "když program stojí";

        Subprogram { name: String } "calls subprogram {name}", "volá podprogram {name}";
        Macrocycle { name: String } "calls macrocycle {name}", "volá makrocyklus {name}";
        Times { text: String, times: i64 } "{text}, {times}×", "{text}, {times}×";
        Target "target", "cíl";
        Inputs "takes", "přebírá";
        HintPlane { g: u8, name: &'static str }
            "G{g} is the plane {name} on this control",
            "G{g} je v tomto systému rovina {name}";
        HintControl { formula: String } "The block computes {formula}.", "Blok počítá {formula}.";
        HintDwell { s: String } "The dwell is counted in units of 10 ms: {s} s.", "Prodleva se zadává po 10 ms: {s} s.";
        InFile { file: String } "in {file}", "v souboru {file}";
        Title { title: String } "“{title}”", "„{title}“";
        Jump { to: u32 } "jumps to N{to}", "skok na blok N{to}";
        Stretch { from: u32, to: u32, passes: String }
            "N{from}–N{to} run {passes}× in a row",
            "bloky N{from}–N{to} se provedou {passes}× za sebou";
        TakenThenOn { times: String }
            "taken {times}×, then execution goes on with the next block",
            "provede se {times}×, pak se pokračuje dalším blokem";
        Always "always taken", "provede se vždy";

        Runs { n: u32, runs: String } "N{n} runs {runs}×", "blok N{n} se provede {runs}×";
        RunsUnknown { n: u32 } "how often N{n} runs is not known", "kolikrát se provede blok N{n}, není známo";
        NeverRuns { n: u32 } "N{n} never runs", "blok N{n} se neprovede";
        Cut { most: String } "within the first {most} executed blocks", "v prvních {most} provedených blocích";
        NoFurther { last: u32 }
            "execution can be followed up to N{last} only",
            "průběh lze sledovat jen po blok N{last}";
        InProgram { file: String } "in program {file}", "v programu {file}";
        StateHere "state here", "stav zde";
        HasErrors
            "not executed: the program or its configuration has errors",
            "neprovádí se: program nebo jeho konfigurace obsahuje chyby";
        NoProgram
            "no open program calls this macrocycle: nothing is known of its execution",
            "žádný otevřený program tento makrocyklus nevolá: o průběhu není nic známo";
        Position "position after the block", "poloha po bloku";
        Unknown "unknown", "neznámá";
        AtLeast { path: String } "at least {path}", "nejméně {path}";
        Length "length of the motion", "délka pohybu";
        DwellTime "dwell", "prodleva";
        Taken "jump taken", "skok se provede";
        GInForce "G functions in force", "platné funkce G";
        MInForce "M functions after the block", "funkce M po bloku";
        Technology "technology", "technologie";
        Before { r: u8 } "R{r} before the block, as its words read it", "R{r} před blokem (tu hodnotu čtou jeho slova)";
        After { r: u8 } "R{r} after the block", "R{r} po bloku";
        Here "value of the word", "hodnota slova";
        Axes "axes", "osy";
        Executed "executed blocks", "provedené bloky";
        Path "path", "dráha";
        End "end", "konec";

        HintStretch { from: u32, to: u32, passes: String, jumps: String }
            "N{from}–N{to} run {passes}× in a row each time they are reached: Q counts the jumps, not the runs. In \
            the whole program the jump is taken {jumps}×.",
            "Bloky N{from}–N{to} se při každém příchodu provedou {passes}× za sebou: Q udává počet skoků, ne \
            provedení. V celém programu se skok provede {jumps}×.";
        HintForward { times: String, jumps: String }
            "Taken {times}× before execution goes on with the next block. In the whole program it is taken {jumps}×.",
            "Provede se {times}×, než se pokračuje dalším blokem. V celém programu se provede {jumps}×.";
        Called { runs: String } "called {runs}×", "voláno {runs}×";
        HintCalled
            "How often it is executed in the whole program; every repeat by Q counts.",
            "Kolikrát se v celém programu provede; počítá se každé opakování podle Q.";
        HintValue { r: u8, values: String } "R{r} before the block: {values}", "R{r} před blokem: {values}";
        OneCall "1 call", "volání: 1";
        CallUnseen "called by a parameter or a fixed cycle", "volá ho parametr nebo pevný cyklus";
        Calls { count: usize } "{count} calls", "volání: {count}";
        BlockTime "time", "doba";
        Velocities "velocity at the start / greatest / at the end", "rychlost na začátku / největší / na konci";
        Unplanned { command: String }
            "the program is too long to plan its motion here; see {command}",
            "program je příliš dlouhý, jeho pohyb se zde nepočítá; viz {command}";
        JointBefore "joint with the motion before", "napojení na předchozí pohyb";
        JointStops { reason: String } "stop: {reason}", "zastavení: {reason}";
        JointLimited { limit: String } "limited by: {limit}", "omezuje: {limit}";
        WithTime { text: String, time: String } "{text}, time {time}", "{text}, čas {time}";
        Totals { blocks: String, path: String }
            "executed blocks: {blocks}, path {path}",
            "provedené bloky: {blocks}, dráha {path}";
    }
}
