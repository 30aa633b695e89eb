//! Texts of the account of a program's motion, in both languages.

use super::times::{Break, Limit};
use crate::dict::bilingual;

bilingual! {
    /// Lines and parts of lines.
    Words {
        Whole { time: String } "{time}", "{time}";
        AtLeast { time: String, blocks: u64 }
            "at least {time}; blocks of unknown time: {blocks}",
            "nejméně {time}; bloků s neznámým časem: {blocks}";
        WithoutApproach { time: String } "{time} without the approach", "{time} bez prvního nájezdu";
        Least "at least", "nejméně";
        AtLeastSo { time: String } "at least {time}", "nejméně {time}";
        AtLeastWithoutApproach { time: String }
            "at least {time}, without the approach",
            "nejméně {time}, bez prvního nájezdu";
        JerkFree { blocks: u64 }
            "P is not known where it counts: the jerk is not limited there; such blocks: {blocks}",
            "P tam, kde platí, není známo: ryv tam není omezen; takových bloků: {blocks}";
        LacksCycle
            "The interpolation cycle Ts (cycle-ms) is not known: the criterion of accuracy and the dynamic criterion \
            limit nothing, the time is a lower bound",
            "Takt interpolace Ts (cycle-ms) není znám: kritérium přesnosti a dynamické kritérium nic neomezují, čas je \
            dolní mez";
        CountAsZero { what: String }
            "Count as 0, because no time is given: {what}",
            "S nulovým časem se počítají, protože čas není zadán: {what}";
        Override "override 100 % (M48, M49)", "override 100 % (M48, M49)";
        Assumed
            "The machine is assumed, nothing is configured in [motion]. The estimate rests on",
            "Stroj je předpokládaný, v [motion] není nastaveno nic. Odhad vychází z hodnot";
        AllAssumed
            "[motion] gives no value, all are assumed. The estimate rests on",
            "[motion] žádnou hodnotu neudává, všechny jsou předpokládané. Odhad vychází z hodnot";
        Configured { values: String } "Configured: {values}", "Nastaveno: {values}";
        AlsoAssumed { values: String } "Assumed: {values}", "Předpokládá se: {values}";
        Changed "Changed against the configured machine", "Změny proti nastavenému stroji";
        Off "off", "vypnuto";
        TimeBefore { before: String, after: String, change: String }
            "time {before} → {after} ({change} s)",
            "čas {before} → {after} ({change} s)";
        JointsBefore { before: u64, after: u64 }
            "continuous joints {before} → {after}",
            "plynulých napojení {before} → {after}";
        DotsBefore { before: u64, after: u64 } "red dots {before} → {after}", "červených teček {before} → {after}";
        Nothing "nothing differs", "nic se neliší";
        Time "Time", "Čas";
        Dwell "dwell (G04)", "prodlevy (G04)";
        Functions "functions", "funkce";
        Settle "waits at the end of motions", "čekání na konci pohybů";
        Gaps "gaps before blocks", "prodlevy mezi bloky";
        Ideal "at programmed velocities, without ramps", "programovanými rychlostmi, bez ramp";
        NoJerk "with the same limits and no limit of jerk", "se stejnými mezemi bez omezení ryvu";
        Tools "Tools", "Nástroje";
        NoTool "before the first M06", "před prvním M06";
        Joints "Joints", "Napojení";
        Continuous "continuous", "plynulých";
        BrokenBy { reason: String } "broken: {reason}", "přerušených: {reason}";
        Limits "Continuous joints are limited by", "Plynulá napojení omezuje";
        Dots "Dots", "Tečky";
        Yellow "yellow", "žlutých";
        Red "red", "červených";
        MeanFeed { feed: String }
            "Mean feed of working motion: {feed} mm/min",
            "Průměrný posuv pracovních pohybů: {feed} mm/min";
        RedJoints "Red joints", "Červená napojení";
        MoreRed "There are more; --all lists them", "Jsou i další; vypíše je --all";
        NoRed "No joint has a red dot", "Žádné napojení nemá červenou tečku";
        After { n: u32, with: u32 } "N{n} after N{with}", "N{n} po N{with}";
        Costs { seconds: String } "costs about {seconds} s", "ztráta asi {seconds} s";
        Times { times: u64 } "{times} times", "{times}krát";
        Angle { angle: String } "{angle}°", "{angle}°";
        Stops "stop", "zastavení";
        Feed { feed: String, programmed: String } "{feed} of {programmed} mm/min", "{feed} z {programmed} mm/min";
    }
}

bilingual! {
    /// What would make a joint faster.
    Help {
        Mode "write G23 into both blocks", "zapsat G23 do obou bloků";
        NoMotion
            "where the order allows it, write what the blocks between them hold in a block that moves",
            "kde to pořadí dovolí, zapsat obsah bloků mezi nimi do bloku s pohybem";
        Dwell "without G04 the motion goes on", "bez G04 pohyb pokračuje";
        Stop "write M00 or M01 where the machine stops anyway", "M00 nebo M01 zapsat tam, kde se stroj stejně zastaví";
        MFunction
            "write the M function where the machine stops anyway",
            "M funkci zapsat tam, kde se stroj stejně zastaví";
        Unknown
            "give F and a known position before it; per revolution also S, or constant-cutting-rpm under G97",
            "zadat před ním F a známou polohu; posuv na otáčku potřebuje i S, při G97 constant-cutting-rpm";
        ShortLength
            "longer blocks, or merge-length-mm, which joins short ones",
            "delší bloky, nebo merge-length-mm, které krátké přidruží";
        ShortTime "longer blocks, or a lower feed", "delší bloky, nebo menší posuv";
        Angle "an arc in the corner, or more points along a curve", "oblouk v rohu, nebo hustší body podél křivky";
        Feed "the other block has a lower feed", "druhý z bloků má menší posuv";
        Centripetal "a larger radius", "větší poloměr";
        ShortestBlock "longer blocks: points farther apart", "delší bloky: body dál od sebe";
        Corner
            "a smaller angle: an arc in the corner, or more points along a curve",
            "menší úhel: oblouk v rohu, nebo hustší body podél křivky";
        LookAhead
            "longer blocks: more way lies in those that the control sees",
            "delší bloky: v těch, které systém předvídá, je pak víc dráhy";
        Ramp "see the slower place near it", "viz pomalejší místo poblíž";
    }
}

impl Help {
    /// For a broken joint with a dot; none where nothing but another program helps.
    pub const fn of_break(reason: Break) -> Option<Self> {
        match reason {
            Break::Mode => Some(Self::Mode),
            Break::NoMotion => Some(Self::NoMotion),
            Break::Dwell => Some(Self::Dwell),
            Break::Stop => Some(Self::Stop),
            Break::MFunction => Some(Self::MFunction),
            Break::Unknown => Some(Self::Unknown),
            Break::ShortLength => Some(Self::ShortLength),
            Break::ShortTime => Some(Self::ShortTime),
            Break::Angle => Some(Self::Angle),
            Break::Start | Break::Rapid | Break::OtherMotion | Break::Axes => None,
        }
    }

    /// For a continuous joint.
    pub const fn of_limit(limit: Limit) -> Self {
        match limit {
            Limit::Feed => Self::Feed,
            Limit::Centripetal => Self::Centripetal,
            Limit::ShortestBlock => Self::ShortestBlock,
            Limit::Accuracy | Limit::Overload => Self::Corner,
            Limit::LookAhead => Self::LookAhead,
            Limit::Ramp => Self::Ramp,
        }
    }
}
