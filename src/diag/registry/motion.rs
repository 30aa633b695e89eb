//! Findings about what execution does: E06xx and W06xx.

/// Hands these rows on, behind those before them.
macro_rules! motion {
    ([$next:ident $($rest:ident)*] $($before:tt)*) => {
        $next! { [$($rest)*] $($before)*
        [W0601] MissingFeed "missing-feed" Warning { thread: bool }
            en (if *thread {
                "a thread is cut before the program sets a feed"
            } else {
                "working motion before the program sets a feed"
            })
            cs (if *thread {
                "řezání závitu dřív, než program zadal posuv"
            } else {
                "pracovní pohyb dřív, než program zadal posuv"
            })
            help "write `F` in this block or before it; otherwise the feed of the program before stays in force"
               | "zadat F v tomto bloku nebo před ním; jinak platí posuv z předchozího programu"
        [E0602] MissingArcCenter "missing-arc-center" Error { radius_word: bool, by: Option<String> }
            en "an arc without its centre: `I` and `J` are missing or zero"
            cs "oblouk bez středu: I a J chybí nebo jsou nulové"
            help "write the distances from the start to the centre: `I` along the first axis of the arc, `J` along the \
                second"
               | "doplnit vzdálenosti od začátku oblouku ke středu: I v první ose oblouku, J ve druhé"
            note (match (by, *radius_word) {
                    (_, true) => "`R` is a parameter on this control, never a radius".to_owned(),
                    (Some(by), false) => format!("it is an arc because {by} is in force"),
                    (None, false) => String::new(),
                })
               | (match (by, *radius_word) {
                    (_, true) => "R je v tomto systému parametr, nikdy poloměr".to_owned(),
                    (Some(by), false) => format!("obloukem je proto, že platí {by}"),
                    (None, false) => String::new(),
                })
        [E0603] ArcRadiusMismatch "arc-radius-mismatch" Error {
            start: String, end: String, points: Box<ArcPoints>, meant: ArcMeant,
        }
            en "the radius is {start} at the start of the arc and {end} at its end"
            cs "poloměr na začátku oblouku je {start}, na konci {end}"
            help (points.help(meant, Lang::En)) | (points.help(meant, Lang::Cs))
            note (points.text(Lang::En)) | (points.text(Lang::Cs))
        [W0604] MissingSpindleSpeed "missing-spindle-speed" Warning { function: GCode, thread: bool }
            en (if *thread {
                "a thread is cut before the program sets a spindle speed".to_owned()
            } else {
                format!("working motion under {function} before the program sets a spindle speed")
            })
            cs (if *thread {
                "řezání závitu dřív, než program zadal otáčky".to_owned()
            } else {
                format!("pracovní pohyb při {function} dřív, než program zadal otáčky")
            })
            help "write `S` in this block or before it" | "zadat S v tomto bloku nebo před ním"
        [W0605] IncrementalFromUnknown "incremental-from-unknown" Warning { axis: char }
            en "{axis} moves by a distance from a position that the program does not know"
            cs "osa {axis} se pohybuje přírůstkem z polohy, kterou program nezná"
            help "program {axis} absolutely (G90) first" | "nejdřív najet osou {axis} absolutně (G90)"
        [W0606] ArcFromUnknown "arc-from-unknown" Warning { axes: String }
            en "the arc starts from a position that is not known ({axes})"
            cs "oblouk začíná v poloze, kterou program nezná ({axes})"
            help "program {axes} absolutely (G90) before the arc" | "před obloukem najet absolutně (G90) osami: {axes}"
        [E0607] SpeedOutsideGear "speed-outside-gear" Error { s: u32, m: u8, min: u32, max: u32, g97: bool }
            en "S{s} is outside range M{m}, which is {min}–{max} rev/min"
            cs "S{s} je mimo rozsah M{m} ({min}–{max} ot/min)"
            help (if *g97 {
                "change the speed, program another range, or let M40 choose it; if S is a cutting speed under G97, set \
                `g97 = \"per-revolution\"`"
            } else {
                "change the speed, program another range, or let M40 choose it"
            })
               | (if *g97 {
                   "změnit otáčky, zadat jiný rozsah, nebo ho nechat vybrat funkcí M40; je-li S při G97 řezná \
                   rychlost, nastavit g97 = \"per-revolution\""
               } else {
                   "změnit otáčky, zadat jiný rozsah, nebo ho nechat vybrat funkcí M40"
               })
        [E0608] OrientedStopUnavailable "oriented-stop-unavailable" Error {}
            en "this machine is configured without the oriented stop M19"
            cs "stroj nemá podle projektového souboru stop vřetena v orientovaném bodě (M19)"
            help "use M05; if the machine has the oriented stop M19, set `oriented-stop = true`"
               | "použít M05; má-li stroj stop v orientovaném bodě (M19), nastavit oriented-stop = true"
        [E0609] CenterWordNotUsable "center-word-not-usable" Error {
            letters: String, place: CenterPlace, written: String,
        }
            en (unused_centers(letters, place, Lang::En))
            cs (unused_centers(letters, place, Lang::Cs))
            help (center_help(letters, written, Lang::En)) | (center_help(letters, written, Lang::Cs))
        [W0610] ArcAfterOriginChange "arc-after-origin-change" Warning {}
            en "an arc right after a change of origin or correction: its start is not where the tool is"
            cs "oblouk hned po změně počátku nebo korekce: nezačíná tam, kde stojí nástroj"
            help "move by a straight line (G00, G01) first" | "nejdřív zařadit přímkový pohyb (G00, G01)"
        [E0611] ArcAxes "arc-axes" Error { plane: String, many: bool, other: Option<Plane> }
            en (if *many {
                "an arc takes at most three axis words".to_owned()
            } else {
                format!("the axis words of the arc do not fit the plane {plane} in force")
            })
            cs (if *many {
                "oblouk smí mít nejvýše tři slova os".to_owned()
            } else {
                format!("slova os oblouku nesouhlasí s platnou rovinou {plane}")
            })
            help (match other {
                Some(Plane { name, function, .. }) => {
                    format!("the machine lacks an axis of this plane: write both axes of {name}, the plane of {function}")
                }
                None => "write both axes of the plane, and one more at most for a helix; here G18 is YZ and G19 is ZX"
                    .to_owned(),
            })
               | (match other {
                   Some(Plane { name, function, .. }) => {
                       format!("stroj některou osu této roviny nemá: uvést obě osy roviny {name}, kterou volí {function}")
                   }
                   None => "uvést obě osy roviny a pro šroubovici nejvýše jednu další; G18 je zde YZ a G19 je ZX".to_owned(),
               })
        [W0612] FunctionNotModelled "function-not-modelled" Warning { what: Unmodelled }
            en (what.message(Lang::En))
            cs (what.message(Lang::Cs))
            help (what.help(Lang::En)) | (what.help(Lang::Cs))
        [W0613] HelixWithoutG09 "helix-without-g09" Warning {}
            en "an arc with a third axis, but G09 is not in force"
            cs "oblouk s třetí osou, ale neplatí G09"
            help "program G09 for a helix, or move the third axis in a block of its own"
               | "pro šroubovici zadat G09, nebo třetí osou jet v samostatném bloku"
        [E0614] SpindleTurn "spindle-turn" Error { axis: char, fault: SpindleFault }
            en ({ let why = fault.text(Lang::En); format!("axis {axis} is the spindle: {why}") })
            cs ({ let why = fault.text(Lang::Cs); format!("osa {axis} je vřeteno: {why}") })
            help (fault.help(Lang::En)) | (fault.help(Lang::Cs))
        [W0615] FeedUnitChanged "feed-unit-changed" Warning {
            feed: String, function: GCode, written: FeedPer, now: FeedPer,
        }
            en ({
                let (written, now) = (written.unit().en, now.unit().en);
                format!("F{feed} was written as {written}, and {function} takes it as {feed} {now}")
            })
            cs ({
                let (written, now) = (written.unit().cs, now.unit().cs);
                format!("F{feed} bylo zadáno v {written} a při {function} platí jako {feed} {now}")
            })
            help "write `F` anew in the block with {function} or before this motion"
               | "zadat F znovu v bloku s {function}, nebo před tímto pohybem"
        [W0616] PlaneMismatch "plane-mismatch" Warning { plane: Plane, fault: PlaneFault, meant: Option<Plane> }
            en ({
                let why = fault.text(Lang::En);
                let name = plane.name;
                format!("{} is the plane {name} here: {why}", plane.function)
            })
            cs ({
                let why = fault.text(Lang::Cs);
                let name = plane.name;
                format!("{} je zde rovina {name}: {why}", plane.function)
            })
            help (meant.map_or_else(String::new, |meant| format!("the plane {} is {}", meant.name, meant.function)))
               | (meant.map_or_else(String::new, |meant| format!("rovina {} je {}", meant.name, meant.function)))
            note "the planes serve the radius corrections G41 and G42; G18 and G19 are the reverse of ISO"
               | "roviny slouží poloměrovým korekcím G41 a G42; G18 a G19 jsou proti ISO prohozené"
        [W0617] NoGearForSpeed "no-gear-for-speed" Warning { s: u32, gears: String }
            en "S{s} is in no spindle range, so M40 chooses none"
            cs "otáčky S{s} nespadají do žádného rozsahu, M40 tedy žádný nevybere"
            help "program a speed that a range holds: {gears}" | "zadat otáčky, které některý rozsah má: {gears}"
        [W0618] CorrectionWithoutEntry "correction-without-entry" Warning { function: GCode }
            en "{function} before the program chooses a correction `D`"
            cs "{function} dřív, než program zvolil korekci D"
            help "write `D` with the number of the tool's correction in this block or before it"
               | "zadat D s číslem korekce nástroje v tomto bloku nebo před ním"
        [W0619] SpindleStopped "spindle-stopped" Warning { thread: bool }
            en (if *thread {
                "a thread is cut while the spindle is stopped (M05)"
            } else {
                "a working motion while the spindle is stopped (M05)"
            })
            cs (if *thread {
                "řezání závitu při zastaveném vřetenu (M05)"
            } else {
                "pracovní pohyb při zastaveném vřetenu (M05)"
            })
            help "start the spindle with M03 or M04 first" | "nejdřív spustit vřeteno funkcí M03 nebo M04"
        [W0620] ToolChangeWithoutTool "tool-change-without-tool" Warning {}
            en "M06 before the program names a tool"
            cs "M06 dřív, než program zvolil nástroj"
            help "write `T` with the number of the tool in this block or before it"
               | "zadat T s číslem nástroje v tomto bloku nebo před ním"
        [W0621] OutsideTravel "outside-travel" Warning { axis: char, value: String, limit: String, above: bool }
            en (if *above {
                format!("{axis}{value} is beyond the travel of the axis, which ends at {limit}")
            } else {
                format!("{axis}{value} is beyond the travel of the axis, which begins at {limit}")
            })
            cs (if *above {
                format!("{axis}{value} je mimo rozsah pohybu osy, který končí na {limit}")
            } else {
                format!("{axis}{value} je mimo rozsah pohybu osy, který začíná na {limit}")
            })
            help "check the value, G90 or G91, and the origin; the travel is `min` and `max` of the axis in the \
                project file"
               | "zkontrolovat hodnotu, G90 nebo G91 a počátek; rozsah je min a max osy v projektovém souboru"
        [W0622] SpindleSpeedZero "spindle-speed-zero" Warning { m: u8, zero: bool }
            en (if *zero {
                format!("a working motion under M{m:02} at S0: the spindle does not turn")
            } else {
                format!("a working motion under M{m:02} before the program sets the spindle speed it writes later")
            })
            cs (if *zero {
                format!("pracovní pohyb při M{m:02} a S0: vřeteno se netočí")
            } else {
                format!("pracovní pohyb při M{m:02} dřív, než program zadal otáčky, které jsou až dál")
            })
            help "write the speed `S` before this motion" | "zadat otáčky S před tímto pohybem"
        [W0623] FunctionWithoutMeaning "function-without-meaning" Warning { m: u8, feed: bool }
            en (if *feed {
                format!("M{m} changes the feed on CNC8x6 and CNC8x9 only: on CNC872 it does nothing")
            } else {
                format!("the ChannelConfig does not define M{m}")
            })
            cs (if *feed {
                format!("M{m} mění posuv jen na CNC8x6 a CNC8x9, na CNC872 nedělá nic")
            } else {
                format!("ChannelConfig funkci M{m} nedefinuje")
            })
            help (match (feed, *m) {
                (true, REDUCED_FEED) => "write the feed itself; when the machine has the function, list it in `MFunctions`",
                (true, _) => "delete it: `F` holds as programmed; when the machine has the function, list it in `MFunctions`",
                (false, _) => "check the number, or list the function in `MFunctions`",
            })
               | (match (feed, *m) {
                   (true, REDUCED_FEED) => "zadat přímo posuv; má-li stroj tuto funkci, uvést ji v MFunctions",
                   (true, _) => "vymazat ji: F platí, jak je programováno; má-li stroj tuto funkci, uvést ji v MFunctions",
                   (false, _) => "zkontrolovat číslo, nebo funkci uvést v MFunctions",
               })
        [W0624] CorrectionOnArc "correction-on-arc" Warning { function: GCode, sides: bool }
            en (if *sides {
                format!("{function} changes the side of the radius correction without G40 between")
            } else {
                format!("the radius correction changes ({function}) on an arc")
            })
            cs (if *sides {
                format!("{function} mění stranu poloměrové korekce bez G40")
            } else {
                format!("poloměrová korekce se mění ({function}) na oblouku")
            })
            help (if *sides { "end the correction with G40 and a straight motion first" } else { "begin and end the \
                correction on a straight motion (G00, G01)"
            }) | (if *sides { "nejdřív korekci ukončit funkcí G40 a přímkovým pohybem" } else { "korekci zapínat a \
                vypínat na přímce (G00, G01)" })
        [W0625] CorrectionLeftOn "correction-left-on" Warning { function: GCode, m: u8 }
            en "M{m:02} while the radius correction {function} is in force"
            cs "M{m:02} při zapnuté poloměrové korekci {function}"
            help "end the correction with G40 and a straight motion before"
               | "před tím korekci ukončit funkcí G40 a přímkovým pohybem"
        [W0626] CycleBlockPlunges "cycle-block-plunges" Warning { cycle: GCode, axis: char, l: u32 }
            en "the block itself moves {axis} in rapid (G00), before {cycle} calls L{l}"
            cs "blok sám najede osou {axis} rychloposuvem (G00), ještě než {cycle} zavolá L{l}"
            help "leave {axis} out of the block and give the depth as L{l} reads it, such as in a parameter"
               | "osu {axis} v bloku vynechat a hloubku zadat tak, jak ji L{l} čte, například v parametru"
        [W0627] CycleOverToolChange "cycle-over-tool-change" Warning { cycle: GCode }
            en "M06 while the fixed cycle {cycle} is in force"
            cs "M06 při zapnutém pevném cyklu {cycle}"
            help "end the cycle with G80 before the tool change" | "před výměnou nástroje cyklus ukončit funkcí G80"
        [W0628] ToolNotChanged "tool-not-changed" Warning { t: String }
            en "T{t} is named, and no M06 follows"
            cs "T{t} je zvolen a žádná M06 po něm nenásleduje"
            help "`T` only names the tool: change it with M06" | "T nástroj jen volí: vymění ho M06"
        [W0629] ArcTurnsBack "arc-turns-back" Warning { function: GCode, meant: GCode, count: u64 }
            en "the path turns back at both ends of the arc; {meant} would join both neighbours smoothly"
            cs "dráha se na obou koncích oblouku obrací; {meant} by na sousední bloky navázal hladce"
            help "check the direction: {function} or {meant}" | "zkontrolovat směr: {function}, nebo {meant}"
            note (times(*count, Lang::En)) | (times(*count, Lang::Cs))
        [W0630] TableWithoutValues "table-without-values" Warning { function: GCode }
            en "{function} without axis words writes nothing"
            cs "{function} bez slov os nic nezapíše"
            help "write the axes with their values in this block, or delete {function}"
               | "zadat v tomto bloku osy s hodnotami, nebo {function} vymazat"

        }
    };
}
pub(super) use motion;
