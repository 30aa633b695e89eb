//! Why a program cannot start at a place, in both languages.

use super::Nearest;
use super::ascii::ascii;
use super::scan::Spot;
use crate::analysis::motion::clock;
use crate::dict::{Lang, bilingual};

bilingual! {
    /// Why there is no start at a place (RST-4).
    Reason {
        Correction { g: String }
            "{g} is in force: only the program itself can lead the tool to the corrected path",
            "platí {g}: na korigovanou dráhu musí nástroj navést program";
        Position { axis: String } "the position of {axis} is not known", "poloha osy {axis} není známa";
        Stale { axis: String }
            "{axis} has not moved since the origin or the length correction changed: where it stands is not known",
            "osa {axis} se od změny počátku nebo délkové korekce nepohnula: kde stojí, není známo";
        Thread "a thread is being cut (G33)", "řeže se závit (G33)";
        Cycle { g: String } "the fixed cycle {g} is in force", "platí pevný cyklus {g}";
        Origin { g: String, n: u32 } "N{n} wrote an origin by {g}", "N{n} zapsal počátek funkcí {g}";
        Needed { axis: String, n: u32 }
            "the position of {axis} is not known, and N{n} goes on from it",
            "poloha osy {axis} není známa a N{n} z ní pokračuje";
        Stands { axis: String, n: u32 }
            "the position of {axis} is not known, and N{n} moves other axes",
            "poloha osy {axis} není známa a N{n} pohybuje jinými osami";
        Oriented "the spindle is an axis (M19)", "vřeteno je osou (M19)";
        Copying { g: String }
            "{g} is in force, and what it does is not modelled",
            "platí {g}, jejíž činnost se nemodeluje";
        InCycle { l: u32 }
            "the place is inside L{l}, which a fixed cycle calls",
            "místo je uvnitř L{l}, který volá pevný cyklus";
        Converted { g: String }
            "{g} is in force: the tool's axis is not where it points to",
            "platí {g}: osa nástroje nemíří tam, kam její písmeno";
        Conversions { g: String }
            "conversions of coordinates were written one after the other ({g} last): whether they add up is not known",
            "přepočty souřadnic byly zapsány po sobě (poslední {g}): zda se sčítají, není známo";
        Value { name: String } "the value of {name} is not known", "hodnota {name} není známa";
        Lathe
            "G74 makes it a lathe: name the axis of the tool by `tool-axis` of `[restart]` in the project file",
            "podle G74 jde o soustruh: uvést osu nástroje klíčem tool-axis v [restart] projektového souboru";
        NoAxis { axis: String }
            "the machine has no {axis}: name the axis of the tool by `tool-axis` of `[restart]` in the project file",
            "stroj nemá osu {axis}: uvést osu nástroje klíčem tool-axis v [restart] projektového souboru";
        NoFeed "no F is in force for the last part of the approach", "pro poslední část najetí neplatí žádné F";
        FeedUnit { g: String }
            "F was written under {g} and counts otherwise here: the last part of the approach needs an F of its own",
            "F bylo zadáno při {g} a zde má jinou jednotku: poslední část najetí potřebuje vlastní F";
        Standing "F counts per revolution, and the spindle stands", "F je na otáčku a vřeteno stojí";
        StandingInCut
            "the spindle stands, and the tool would feed to where it cut",
            "vřeteno stojí a nástroj by posuvem najel tam, kde obráběl";
        Unwritable { axis: String }
            "the position of {axis} cannot be written in thousandths",
            "polohu osy {axis} nelze zapsat v tisícinách";
        TooLong { blocks: u64, limit: u64 }
            "{blocks} blocks of calls and loops would be written out, --max-blocks allows {limit}",
            "bylo by rozepsáno bloků volání a smyček: {blocks}, --max-blocks dovoluje {limit}";
        Fails { code: String } "a program from there has the error {code}", "program odtud má chybu {code}";
        Differs { field: &'static str, n: u32 }
            "a program from there would differ at N{n}, in `{field}` of the block stream",
            "program odtud by se lišil v N{n}, v `{field}` proudu bloků";
        Length { n: u32 }
            "in a program from there the length of the motion in N{n} would not be known",
            "v programu odtud by nebyla známa délka pohybu v N{n}";
        Longer "a program from there would go on behind the end of this one",
            "program odtud by pokračoval za konec tohoto";
        Shorter { n: u32 } "a program from there would end before N{n}", "program odtud by skončil před N{n}";
        Lowered { axis: String, tool: String }
            "{axis} is parallel to {tool} and does not stand at its highest: the approach would move across with it down",
            "osa {axis} je rovnoběžná s {tool} a nestojí ve své nejvyšší poloze: najetí by s ní dole přejíždělo";
        SafeBelow { axis: String }
            "--safe is not above the place: the tool would move across in rapid where it cut in {axis}",
            "--safe není nad místem: nástroj by rychloposuvem přejížděl tam, kde v ose {axis} obráběl";
        OtherSide
            "X is negative here, and the tool came from there: the approach would cross the workpiece",
            "X je zde záporné a nástroj přijel z této strany: najetí by přejelo obrobek";
        NoSafe { axis: String }
            "--safe is missing: with this tool and origin the program shows no height in {axis} to move across at",
            "chybí --safe: s tímto nástrojem a počátkem program neukazuje v ose {axis} výšku, v níž lze přejíždět";
    }
}

bilingual! {
    /// Comments of the new program; written there without diacritics.
    Note {
        Title { name: String, place: String } "{name} from {place}", "{name} od {place}";
        TitleOfPass { name: String, place: String, pass: u64 }
            "{name} from {place}, pass {pass}",
            "{name} od {place}, průchod {pass}";
        WrittenOut { blocks: u64 }
            "blocks of calls and loops written out: {blocks}",
            "rozepsaná volání a smyčky: bloků {blocks}";
        Skipped
            "there without the blocks with /, as --block-skip says",
            "v nich bez bloků s /, podle --block-skip";
        NotRestored { m: String, group: usize }
            "not restored: {m} of group {group} (--all-m)",
            "neobnoveno: {m} skupiny {group} (--all-m)";
        MachineParameter { r: u8 } "R{r} is read from the machine's table", "R{r} se čte z tabulky stroje";
        Corrections { n: u32 }
            "corrections that N{n} wrote are not written again",
            "korekce zapsané v N{n} se znovu nezapisují";
        Fresh { axis: String }
            "{axis} was not programmed yet: move it to where the program found it",
            "{axis} dosud nebyla programována: najet s ní, kam patří na začátku programu";
        Stands { axis: String }
            "{axis} is not known here: move it clear by hand first",
            "{axis} zde není známa: nejdřív odjet ručně";
        Unseen { axes: String }
            "a macrocycle of the machine may have moved {axes}: move them as it left them",
            "makrocyklus stroje mohl pohnout osami {axes}: najet s nimi, kde je nechal";
        Lathe { axis: String }
            "approach by {axis}, the others, {axis} again: in a bore this way is not clear",
            "najetí osou {axis}, ostatními a znovu {axis}: v díře tato cesta není volná";
        Parameters "parameters read later", "parametry čtené dále";
        Functions "functions in force", "platné funkce";
        ToolChange "tool change", "výměna nástroje";
        ToolChangeOf { n: u32 } "tool change, N{n}", "výměna nástroje, N{n}";
        Tool "tool and corrections", "nástroj a korekce";
        NextTool "next tool", "další nástroj";
        Gear "speed for the spindle range", "otáčky pro rozsah vřetena";
        Spindle "spindle", "vřeteno";
        SpindleOf { n: u32 } "spindle, N{n}", "vřeteno, N{n}";
        Auxiliary "auxiliary functions", "pomocné funkce";
        Function { meaning: String, n: u32 } "{meaning}, N{n}", "{meaning}, N{n}";
        FunctionOf { n: u32 } "N{n}", "N{n}";
        Set "dynamic set of G23", "sada dynamiky pro G23";
        Feed "feed", "posuv";
        FeedOf { n: u32 } "feed, N{n}", "posuv, N{n}";
        Mode "unit of feed in force", "platná jednotka posuvu";
        Reference { axis: String } "{axis} to its reference point", "{axis} do referenčního bodu";
        Safe "up to --safe", "nahoru na --safe";
        Highest "up to the program's highest with this tool", "nahoru na nejvyšší polohu programu s tímto nástrojem";
        Level "the height of the place, which is above --safe", "výška místa, které je nad --safe";
        Across "across", "přejezd";
        Down { clearance: String } "down to {clearance} mm above the place", "dolů na {clearance} mm nad místo";
        Place "to the place at F", "na místo s F";
        AsThere "as at the place", "jak platí v místě";
    }
}

bilingual! {
    /// What is said of a place beside the reason.
    Said {
        Refused { reason: String } "no start there: {reason}", "odtud začít nelze: {reason}";
        Nearest { n: u32, line: u32, seq: u64, time: String }
            "nearest earlier place that works: --seq {seq}, N{n} (line {line}), {time} after program start",
            "nejbližší dřívější místo, odkud lze začít: --seq {seq}, N{n} (řádek {line}), {time} od startu programu";
        NearestIn { n: u32, file: String, line: u32, seq: u64, time: String }
            "nearest earlier place that works: --seq {seq}, N{n} of {file} (line {line}), {time} after program start",
            "nejbližší dřívější místo, odkud lze začít: --seq {seq}, N{n} v {file} (řádek {line}), {time} od startu \
            programu";
        NoNearest "no earlier place was found", "dřívější místo, odkud lze začít, se nenašlo";
        Written { written_out: u64 }
            "blocks of calls and loops written out: {written_out}",
            "rozepsaných bloků volání a smyček: {written_out}";
        Row { seq: u64, n: u32, line: u32, pass: u64, tool: String, kind: String }
            "--seq {seq}  N{n}  line {line}  pass {pass}  {tool}  {kind}",
            "--seq {seq}  N{n}  řádek {line}  průchod {pass}  {tool}  {kind}";
        RowIn { seq: u64, n: u32, file: String, line: u32, pass: u64, tool: String, kind: String }
            "--seq {seq}  N{n} of {file}  line {line}  pass {pass}  {tool}  {kind}",
            "--seq {seq}  N{n} v {file}  řádek {line}  průchod {pass}  {tool}  {kind}";
        Change "tool change", "výměna nástroje";
        Rapid "rapid", "rychloposuv";
        NoTool "no tool", "bez nástroje";
        NoPlaces
            "the program has no tool change and no rapid to start at",
            "v programu není výměna nástroje ani rychloposuv, kterým by šlo začít";
        NoPlacesBecause { why: String }
            "the program cannot start at any tool change or rapid; reason at the first one: {why}",
            "začít nelze žádnou výměnou nástroje ani rychloposuvem; důvod u prvního místa: {why}";
        MoreWithSafe { more: u64 } "places that --safe would open: {more}", "míst, která zpřístupní --safe: {more}";
    }
}

/// A row of the list of places.
pub fn spot_text(spot: &Spot, lang: Lang) -> String {
    let Spot { seq, n, line, pass, .. } = *spot;
    let tool = spot.tool.map_or_else(|| Said::NoTool.text(lang), |tool| format!("T{tool}"));
    let kind = if spot.changes { Said::Change } else { Said::Rapid }.text(lang);
    let row = if spot.file.is_empty() {
        Said::Row { seq, n, line, pass, tool, kind }
    } else {
        Said::RowIn { seq, n, file: spot.file.clone(), line, pass, tool, kind }
    };
    row.text(lang)
}

/// Why there is no start, and where there is one.
pub fn refusal_text(reason: &Reason, nearest: Option<&Nearest>, lang: Lang) -> String {
    let said = Said::Refused { reason: reason.text(lang) }.text(lang);
    if reason.asks_for_safe() {
        return said;
    }
    let nearest = nearest.map_or(Said::NoNearest, |nearest| {
        let Nearest { seq, n, line, .. } = *nearest;
        let time = clock(nearest.time_s);
        match nearest.file.clone() {
            Some(file) => Said::NearestIn { n, file, line, seq, time },
            None => Said::Nearest { n, line, seq, time },
        }
    });
    format!("{said}\n{}", nearest.text(lang))
}

impl Reason {
    /// Whether another `--safe` makes a start possible.
    pub const fn asks_for_safe(&self) -> bool {
        matches!(self, Self::NoSafe { .. } | Self::SafeBelow { .. })
    }
}

impl Note {
    /// As a comment of a part program: ASCII, no quote.
    pub fn comment(&self, lang: Lang) -> String {
        ascii(&self.text(lang))
    }
}
