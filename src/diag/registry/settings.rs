//! Findings about the project file, motion and the PLC: E07xx to E09xx, W07xx to W09xx.

/// Hands these rows on, behind those before them.
macro_rules! settings {
    ([$next:ident $($rest:ident)*] $($before:tt)*) => {
        $next! { [$($rest)*] $($before)*
        [E0701] UnreadableConfiguration "unreadable-configuration" Error { reason: ConfigProblem }
            en ({ let why = reason.text(Lang::En); format!("the configuration cannot be read: {why}") })
            cs ({ let why = reason.text(Lang::Cs); format!("konfiguraci nelze přečíst: {why}") })
        [E0702] ConfigurationValue "configuration-value" Error { key: String, needs: ConfigNeed }
            en ({ let needs = needs.text(Lang::En); format!("`{key}` {needs}") })
            cs ({ let needs = needs.text(Lang::Cs); format!("{key} {needs}") })
        [E0703] MFunctionFixed "m-function-fixed" Error { m: u8, group: u8 }
            en "M{m:02} is a standard function and cannot leave M group {group}"
            cs "M{m:02} je standardní funkce a nelze ji vyřadit z {group}. skupiny"
            help "write GroupNo=\"{group}\", or leave GroupNo out; the other attributes may be set"
               | "napsat GroupNo=\"{group}\", nebo GroupNo vynechat; ostatní atributy nastavit lze"
        [E0704] MFunctionRepeated "m-function-repeated" Error { m: u8 }
            en "M{m:02} is configured twice with different data"
            cs "M{m:02} je nastavena dvakrát s různými údaji"
            help "keep one of the two elements" | "ponechat jen jeden z obou elementů"
        [W0705] UnknownConfigurationKey "unknown-configuration-key" Warning {
            kind: NameKind, key: String, near: Option<String>, known: Option<KnownNames>,
        }
            en ({ let kind = kind.text(Lang::En); format!("unknown {kind} `{key}`") })
            cs ({ let kind = kind.text(Lang::Cs); format!("neznámý {kind} „{key}“") })
            help (nearest(near.as_ref(), "perhaps `", "` is meant")) | (nearest(near.as_ref(), "možná mělo být „", "“"))
            note (known_names(known.as_ref(), near.as_deref(), Lang::En))
               | (known_names(known.as_ref(), near.as_deref(), Lang::Cs))
        [E0706] MachineConstant "machine-constant" Error { constant: String, problem: ConstantProblem }
            en ({ let what = problem.text(Lang::En); format!("machine constant {constant} {what}") })
            cs ({ let what = problem.text(Lang::Cs); format!("strojní konstanta {constant} {what}") })
        [W0707] ConstantNotUsed "constant-not-used" Warning { name: String, why: NotUsed }
            en (why.message(name, Lang::En))
            cs (why.message(name, Lang::Cs))
            note (why.note(Lang::En)) | (why.note(Lang::Cs))
        [W0708] NoMFunctions "no-m-functions" Warning {}
            en "this ChannelConfig holds no `MFunctions`: it sets no M function"
            cs "tento ChannelConfig neobsahuje MFunctions: žádnou M funkci nenastaví"
            help "name the ChannelConfig that the control reads, or leave `channel-config` out"
               | "zadat ten ChannelConfig, který čte systém, nebo channel-config vynechat"

        [W0801] ContinuityBroken "continuity-broken" Warning { n: u32, with: u32, reason: JointBreak, count: u64 }
            en ({ let why = reason.text(Lang::En); format!("continuous motion from N{with} to N{n} is broken: {why}") })
            cs ({ let why = reason.text(Lang::Cs); format!("plynulá návaznost N{with} a N{n} je porušena: {why}") })
            note (times(*count, Lang::En)) | (times(*count, Lang::Cs))
        [W0802] SlowJoint "slow-joint" Warning {
            n: u32, with: u32, feed: String, programmed: String, limit: JointLimit, count: u64,
        }
            en ({
                let by = limit.text(Lang::En);
                format!("from N{with} to N{n} the velocity drops to {feed} of {programmed} mm/min: {by}")
            })
            cs ({
                let by = limit.text(Lang::Cs);
                format!("mezi N{with} a N{n} klesne rychlost na {feed} z {programmed} mm/min: {by}")
            })
            note (times(*count, Lang::En)) | (times(*count, Lang::Cs))
        [W0803] NoRoomToStop "no-room-to-stop" Warning {
            n: u32, length: String, feed: String, needs: String, count: u64,
        }
            en "N{n} is too short to stop in: {length} mm, and from {feed} mm/min it takes {needs} mm"
            cs "N{n} je na zastavení příliš krátký: má {length} mm a z {feed} mm/min je potřeba {needs} mm"
            help "program a lower feed before it, or a longer last block"
               | "naprogramovat před ním menší posuv, nebo delší poslední blok"
            note (no_room_note(*count, Lang::En)) | (no_room_note(*count, Lang::Cs))
        [W0804] TightBlockTooShort "tight-block-too-short" Warning { n: u32, duration: String, least: u32, count: u64 }
            en "N{n} takes {duration} ms; in G24 blocks join tightly from {least} ms on"
            cs "N{n} trvá {duration} ms; při G24 se těsně napojují bloky od {least} ms"
            help "write longer blocks there, or a lower feed" | "psát tam delší bloky, nebo menší posuv"
            note (times(*count, Lang::En)) | (times(*count, Lang::Cs))
        [W0811] CorrectionCollides "correction-collides" Warning { d: u32, radius: String, arc: Option<String> }
            en (match arc {
                Some(arc) => {
                    format!("the arc of radius {arc} is smaller than the correction D{d} of {radius} on its inner side")
                }
                None => format!(
                    "with the correction D{d} of {radius} nothing is left of this motion between its neighbours"
                ),
            })
            cs (match arc {
                Some(arc) => {
                    format!("oblouk o poloměru {arc} je na vnitřní straně menší než korekce D{d} (poloměr {radius})")
                }
                None => format!("s korekcí D{d} (poloměr {radius}) z tohoto pohybu mezi sousedními nic nezbývá"),
            })
            help "use a smaller tool, or change the contour; `cnc872c view` shows the place in red"
               | "použít menší nástroj, nebo upravit obrys; cnc872c view ukáže místo červeně"
        [W0812] UnknownCorrection "unknown-correction" Warning { d: u32 }
            en "no radius is configured for the correction D{d}: the corrected path is not drawn, and not checked"
            cs "pro korekci D{d} není nastaven poloměr: korigovaná dráha se nekreslí ani nekontroluje"
            help "write the radius of the control's table in the project file: `[corrections.{d}]` with `radius = …`"
               | "zapsat poloměr z tabulky systému do projektového souboru: [corrections.{d}] s radius = …"
        [W0901] DoesNotFit "does-not-fit" Warning { word: String, byte: String, cell: String }
            en "`{word}` does not fit into {byte}: the PLC program reads 00h there"
            cs "{word} se nevejde do {byte}: PLC program tam přečte 00h"
            help "{cell} holds the whole value" | "celou hodnotu má {cell}"
            note "the byte has two decades in BCD: 00 to 99, without a fraction and a sign"
               | "bajt má dvě dekády v BCD: 00 až 99, bez desetinné části a znaménka"
        [E0902] UnknownSignal "unknown-signal" Error { name: String, why: super::SignalProblem }
            en "`{name}` is not a signal that a part program determines"
            cs "{name} není signál, který plyne z partprogramu"
            help (why.help(Lang::En)) | (why.help(Lang::Cs))
            note (why.note(Lang::En)) | (why.note(Lang::Cs))
        [E0903] MalformedCondition "malformed-condition" Error { problem: super::ConditionProblem }
            en (problem.text(Lang::En))
            cs (problem.text(Lang::Cs))
        [E0904] DecimalForBcd "decimal-for-bcd" Error { name: String, number: String, right: String, tool: bool }
            en "`{name}` is in BCD, `{number}` is a decimal number"
            cs "{name} je v BCD, {number} je desítkové číslo"
            help (if right.is_empty() { String::new() } else { format!("write `{right}`") })
               | (if right.is_empty() { String::new() } else { format!("napsat „{right}“") })
            note (if *tool {
                "tool numbers are in BCD too: T12 is 12h"
            } else {
                "the cell holds decimal digits: M95 is 95h, which is 149"
            })
               | (if *tool {
                   "v BCD jsou i čísla nástrojů: T12 je 12h"
               } else {
                   "buňka obsahuje desítkové číslice: M95 je 95h, tedy 149"
               })
        }
    };
}
pub(super) use settings;
