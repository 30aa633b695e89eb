//! Machine constants: each decade of each one, and whole tables as machines have them.

use std::path::Path;

use cnc872c::config::{Constant, MotionKey, Overrides, Profile, Recognition, SetKey, SetValue, Settings, configure};
use cnc872c::diag::Findings;
use cnc872c::dict::{Decimal, Lang};
use cnc872c::text::{MemoryLoader, Sources};

/// The settings of a project file, and the codes of what is wrong with it.
fn configured(text: &str) -> (Settings, Vec<String>) {
    let (settings, findings) = read(text);
    let codes = findings.items().iter().map(|found| found.code().as_str().to_owned()).collect();
    (settings, codes)
}

fn findings_of(text: &str) -> Findings {
    read(text).1
}

fn read(text: &str) -> (Settings, Findings) {
    let loader = MemoryLoader::new().with("cnc872c.toml", text.as_bytes());
    let (mut sources, mut findings) = (Sources::new(), Findings::new());
    let path = Path::new("cnc872c.toml");
    let overrides = Overrides { computes_motion: true, ..Overrides::default() };
    let settings = configure(Some(path), &overrides, &loader, &mut sources, &mut findings);
    (settings, findings)
}

fn with(constants: &str) -> (Settings, Vec<String>) {
    configured(&format!("dialect = \"cnc8x9\"\n[motion]\ncycle-ms = 2\n[machine-constants]\n{constants}"))
}

/// The numbers from 10 to the power of a decade below it, one to each decade: 1 in decade 1, 2 in decade 2 …
fn digit_in(decade: u32) -> (u32, String) {
    (decade % 9 + 1, format!("{:08}", (decade % 9 + 1) * 10_u32.pow(decade - 1)))
}

/// The value of a decade in a whole number.
const fn whole(decade: u32, first: u32, last: u32) -> i64 {
    if decade < first || decade > last { 0 } else { ((decade % 9 + 1) * 10_u32.pow(decade - first)) as i64 * 1000 }
}

/// Keys in thousandths or digits: constant, key, the decades that hold it, whether they are thousandths.
const NUMBERS: [(u16, MotionKey, u32, u32, bool); 9] = [
    (39, MotionKey::Angle, 1, 8, true),
    (236, MotionKey::AccelContinuous, 1, 8, false),
    (382, MotionKey::BreakLength, 1, 8, true),
    (383, MotionKey::MergeLength, 1, 8, true),
    (384, MotionKey::Accuracy, 1, 4, false),
    (384, MotionKey::Red, 5, 6, false),
    (385, MotionKey::Overload, 1, 7, false),
    (395, MotionKey::Raise, 1, 8, false),
    (52, MotionKey::Accel, 1, 4, false),
];

#[test]
fn decades_of_numbers() {
    for (constant, key, first, last, thousandths) in NUMBERS {
        for decade in 1..=8 {
            let (_, digits) = digit_in(decade);
            let (settings, codes) = with(&format!("R{constant} = \"{digits}\"\n"));
            let found = settings.machine.motion.given(key).value.unwrap_or_default().thousandths();
            let expected = whole(decade, first, last);
            let expected = if thousandths { expected / 1000 } else { expected };
            // What no machine can do is refused; so is an angle above 180 degrees.
            let refused = codes.iter().any(|code| code == "E0702" || code == "W0707");
            assert!(found == expected || refused, "R{constant} {digits}: {found} {codes:?}");
            if decade <= last.min(4) {
                assert!(!refused, "R{constant} {digits}: {codes:?}");
                assert_eq!(found, expected, "R{constant} {digits}");
            }
        }
    }
}

#[test]
fn signs_and_forms() {
    let length = |text: &str| {
        let (settings, codes) = with(&format!("R382 = {text}\n"));
        (settings.machine.motion.number(MotionKey::BreakLength).thousandths(), codes)
    };
    assert_eq!(length("\"-00000500\""), (-500, vec![]));
    assert_eq!(length("\"500\""), (500, vec![]));
    assert_eq!(length("0.5"), (500, vec![]));
    assert_eq!(length("\"0.500\"").1, ["E0702"]);
    assert_eq!(length("\"123456789\"").1, ["E0702"]);
    assert_eq!(with("R384 = \"-8\"\n").1, ["E0702"]);
}

#[test]
fn single_decades() {
    for (digit, expected) in [(1, Some(Recognition::Manual)), (2, Some(Recognition::Automatic)), (0, None), (3, None)] {
        let (settings, codes) = with(&format!("R97 = \"0000000{digit}\"\n"));
        match expected {
            Some(recognition) => assert_eq!((settings.machine.motion.recognition.value, codes), (recognition, vec![])),
            // `R97 = 2` is 2.000: a trap, not a machine that cannot be.
            None => assert_eq!(codes, [if digit == 0 { "W0707" } else { "E0702" }]),
        }
    }
    let sets = "R406 = \"1\"\nR407 = \"50000\"\n";
    for (digit, expected) in
        [(0, Some(Profile::Ramps)), (1, Some(Profile::Linear)), (2, Some(Profile::Parabolic)), (3, None)]
    {
        let (settings, codes) = with(&format!("R338 = \"000000{digit}0\"\n{sets}"));
        match expected {
            Some(profile) => assert_eq!((settings.machine.motion.profile.value, codes), (profile, vec![]), "{digit}"),
            None => assert_eq!(codes, ["E0702"]),
        }
    }
}

/// Sets 1 to 4 and that of G00: constants of the values in their order, and the decades that hold them.
#[test]
fn decades_of_sets() {
    for (set, control) in [(1, 406), (2, 412), (3, 418), (4, 424), (0, 430)] {
        for (place, key) in SetKey::ALL.into_iter().enumerate().take(if set == 0 { 2 } else { 5 }) {
            let constant = control + 1 + u16::try_from(place).unwrap();
            // Set 1 has P in any case; decade 8 of R411 must be 1 for a value.
            let base = match (constant, key) {
                (407, _) => String::new(),
                _ => "R406 = \"1\"\nR407 = \"00050000\"\n".to_owned(),
            };
            let word = if control == 406 && constant != 407 { String::new() } else { format!("R{control} = \"1\"\n") };
            for decade in 1..=7 {
                let (digit, _) = digit_in(decade);
                let eighth = if key == SetKey::Centripetal { 10_000_000 } else { 0 };
                let digits = format!("{:08}", digit * 10_u32.pow(decade - 1) + eighth);
                let (settings, codes) = with(&format!("R338 = \"20\"\n{base}{word}R{constant} = \"{digits}\"\n"));
                let set = settings.machine.motion.sets[set].as_ref();
                let found = match set.and_then(|set| set.get(key)).map(|given| given.value) {
                    Some(SetValue::Number(number)) => number.thousandths(),
                    Some(SetValue::Parameter(_)) | None => 0,
                };
                let expected = match key {
                    SetKey::Parabolic | SetKey::Overload => whole(decade, 1, 7),
                    SetKey::Linear => whole(decade, 1, 8),
                    SetKey::Accuracy => whole(decade, 1, 4),
                    SetKey::Centripetal => whole(decade, 1, 7) / 10,
                };
                let refused = codes.iter().any(|code| code == "E0702" || code == "W0707");
                assert!(found == expected || refused, "R{constant} {digits}: {found} not {expected} {codes:?}");
                if decade <= 3 {
                    assert!(!refused, "R{constant} {digits}: {codes:?}");
                }
            }
        }
    }
}

/// Decade 8 of P: 100 and 1000 times smaller.
#[test]
fn smaller_parabolic_accelerations() {
    for (eighth, thousandths) in [(0, 50_000_000), (2, 500_000), (3, 50_000)] {
        let (settings, codes) = with(&format!("R338 = \"20\"\nR406 = \"1\"\nR407 = \"{eighth}0050000\"\n"));
        let motion = &settings.machine.motion;
        assert_eq!(codes, Vec::<String>::new());
        assert_eq!(motion.dynamic(1, SetKey::Parabolic, |_| None), Decimal::from_thousandths(thousandths));
    }
}

/// Each mistake has one finding: no key counts as missing that is there.
#[test]
fn one_finding_for_one_mistake() {
    let sets = |constants: &str| with(&format!("R338 = \"20\"\n{constants}")).1;
    assert_eq!(sets("R406 = \"1\"\nR407 = \"40050000\"\n"), ["E0702"]);
    assert_eq!(sets("R406 = \"1\"\nR407 = \"10050000\"\n"), ["E0702"]);
    assert_eq!(sets("R406 = \"11\"\nR407 = \"95\"\n"), ["E0702"]);
    assert_eq!(sets("R406 = \"1\"\nR407 = \"50.000\"\n"), ["E0702"]);
    assert_eq!(sets("R406 = \"2\"\nR407 = \"50000\"\n"), ["E0702"]);
    assert_eq!(sets("R406 = \"1\"\nR407 = true\n"), ["E0702"]);
    assert_eq!(sets("R406 = \"1\"\nR407 = \"0\"\n"), ["W0707"], "P is missing");
    let own = |text: &str| configured(&format!("[motion]\n{text}")).1;
    assert_eq!(own("profile = \"parabolic\"\n[motion.sets.1]\nparabolic = \"fast\"\n"), ["E0702"]);
    assert_eq!(own("cycle-ms = -1\naccuracy-um = 8\n"), ["E0702"]);
    assert_eq!(own("accuracy-um = 8\noverload-mm-s2 = 5\n"), ["W0707"], "Ts is missing");
}

/// No constant stops a command that does not compute motion; what cannot be has its default.
#[test]
fn constants_never_stop_check() {
    for constants in
        ["R97 = \"3\"", "R338 = \"30\"", "R52 = 0", "R39 = 190", "R382 = \"0.5\"", "R406 = \"2\"", "R384 = -8"]
    {
        let text = format!("dialect = \"cnc8x9\"\n[machine-constants]\n{constants}\n");
        let loader = MemoryLoader::new().with("cnc872c.toml", text.as_bytes());
        let (mut sources, mut findings) = (Sources::new(), Findings::new());
        let path = Path::new("cnc872c.toml");
        let settings = configure(Some(path), &Overrides::default(), &loader, &mut sources, &mut findings);
        let found: Vec<_> = findings.items().iter().map(|found| found.code().as_str()).collect();
        assert_eq!(found, ["W0707"], "{constants}");
        assert_eq!(settings.machine.motion.number(MotionKey::Accel), Decimal::whole(500), "{constants}");
        assert_eq!(configured(&text).1, ["E0702"], "{constants}");
    }
}

/// A profile or criterion that lacks something has a finding, and another one holds.
#[test]
fn profiles_that_do_not_hold() {
    let of = |text: &str| {
        let (settings, codes) = configured(text);
        (settings.machine.motion.profile.value, settings.machine.motion.profile.from.shown("profile"), codes.concat())
    };
    let old = "dialect = \"cnc8x6\"\n";
    let is = |profile, from: &str, codes: &str| (profile, from.to_owned(), codes.to_owned());
    assert_eq!(of(&format!("{old}[machine-constants]\nR338 = \"10\"\n")), is(Profile::Ramps, "R338", "W0707"));
    assert_eq!(of(&format!("{old}[motion]\nprofile = \"linear\"\n")), is(Profile::Ramps, "motion.profile", "W0707"));
    assert_eq!(of(&format!("{old}[motion]\nprofile = \"ramps\"\n")), is(Profile::Ramps, "motion.profile", ""));
    assert_eq!(of("[motion]\nprofile = \"parabolic\"\n"), is(Profile::Linear, "motion.profile", "W0707"));
    // Without P in set 1 the single constants count.
    let (settings, codes) = with("R338 = \"20\"\nR406 = \"1\"\nR236 = \"300\"\nR384 = \"00200008\"\n");
    assert_eq!(codes, ["W0707"]);
    assert_eq!(settings.machine.motion.number(MotionKey::Accuracy), Decimal::whole(8));
    assert_eq!(settings.machine.motion.number(MotionKey::AccelContinuous), Decimal::whole(300));
}

/// S3 A6.2: R236 at least 100 below R52, where both are given as constants; it counts as written.
#[test]
fn close_accelerations() {
    for (continuous, codes) in [("300", &[][..]), ("301", &["W0707"]), ("400", &["W0707"]), ("0", &[])] {
        let (settings, found) = with(&format!("R52 = \"400\"\nR236 = \"{continuous}\"\n"));
        assert_eq!(found, codes, "{continuous}");
        // 0 is that of other working motion.
        let written = if continuous == "0" { "400" } else { continuous };
        assert_eq!(settings.machine.motion.number(MotionKey::AccelContinuous).to_string(), written);
    }
    assert_eq!(with("R236 = \"399\"\n").1, Vec::<String>::new());
}

/// Each page of a constant shows it in a project file that can be taken as it is.
#[test]
fn examples_of_pages() {
    for constant in Constant::all() {
        let Some(example) = constant.example() else {
            assert_eq!(constant.name(), "R232");
            continue;
        };
        assert!(example.contains(&format!("\n{} = \"", constant.name())), "{example}");
        assert!(constant.page(Lang::Cs).contains(&example), "{example}");
        assert_eq!(configured(&example).1, Vec::<String>::new(), "{example}");
    }
    let (settings, _) = configured(&Constant::find("R384").unwrap().example().unwrap());
    let motion = &settings.machine.motion;
    let value = |key| motion.number(key).thousandths();
    assert_eq!((value(MotionKey::Accuracy), value(MotionKey::Red)), (8000, 20_000));
    let (settings, _) = configured(&Constant::find("R411").unwrap().example().unwrap());
    assert_eq!(settings.machine.motion.number(MotionKey::Centripetal), Decimal::whole(400));
}

/// The advice for an acceleration that no machine has is one that a machine has.
#[test]
fn the_point_is_moved() {
    let offered = |digits: &str| {
        let text = format!("dialect = \"cnc8x9\"\n[machine-constants]\nR52 = {digits}\n");
        let found = findings_of(&text);
        let [found] = found.items() else { panic!("{text}") };
        let fix = &found.fixes[0];
        assert!(fix.certain.is_none());
        let now = text.replace(digits, &fix.edits[0].text);
        let (settings, codes) = configured(&now);
        assert_eq!(codes, Vec::<String>::new(), "{now}");
        (settings.machine.motion.number(MotionKey::Accel), found.finding.note(Lang::En).unwrap())
    };
    let (accel, note) = offered("\"50001\"");
    assert_eq!(accel, Decimal::whole(50));
    assert!(note.ends_with("probably 0.050 is meant, which is 50 mm/s²"), "{note}");
    assert_eq!(offered("400.0").0, Decimal::whole(400));
    assert_eq!(offered("\"60000000\"").0, Decimal::whole(60));
}

/// `R97 = 2` is 2.000: the note shows how automatic recognition is written, so that it can be taken over.
#[test]
fn recognition_as_it_is_written() {
    let found = findings_of("dialect = \"cnc8x9\"\n[machine-constants]\nR97 = 2\n");
    let [found] = found.items() else { panic!("{:?}", found.items()) };
    assert_eq!(found.code().as_str(), "W0707");
    for lang in [Lang::En, Lang::Cs] {
        let note = found.finding.note(lang).unwrap();
        assert!(note.contains("R97 = \"00000002\""), "{note}");
    }
    let (settings, codes) = with("R97 = \"00000002\"\n");
    let recognition = &settings.machine.motion.recognition;
    assert_eq!(
        (recognition.value, recognition.from.shown("recognition"), codes),
        (Recognition::Automatic, "R97".to_owned(), vec![])
    );
}

/// Control words: decades 2 to 6 make values those of parameters.
#[test]
fn values_by_parameter() {
    for (place, key) in SetKey::ALL.into_iter().enumerate() {
        let word = 1 + 10_u32.pow(u32::try_from(place).unwrap() + 1);
        let constant = 407 + place;
        let base = if key == SetKey::Parabolic { "" } else { "R407 = \"50000\"\n" };
        let text = format!("R338 = \"20\"\n{base}R406 = \"{word:08}\"\nR{constant} = \"21\"\n");
        let (settings, codes) = with(&text);
        let motion = &settings.machine.motion;
        assert_eq!(codes, Vec::<String>::new(), "{text}");
        let given = motion.sets[1].as_ref().unwrap().get(key).unwrap();
        assert_eq!(given.value, SetValue::Parameter(21), "{text}");
        let value = motion.dynamic(1, key, |number| (number == 21).then(|| Decimal::whole(7)));
        assert_eq!(value, Decimal::whole(7));
    }
}

/// A whole table is pasted: what is not about motion is taken without a word.
#[test]
fn whole_tables() {
    let rest: String = (500..560).map(|number| format!("R{number} = \"{:08}\"\n", number * 7)).collect();
    let text = "R39 = \"00045000\"\nR52 = \"00000400\"\nR97 = \"00000002\"\nR236 = \"00000300\"\nR237 = \"00001200\"\n\
                R338 = \"00000010\"\nR382 = \"-00000001\"\nR383 = \"00000000\"\nR384 = \"00200008\"\nR385 = \"00010000\"\n\
                R395 = \"00000300\"\n";
    let (settings, codes) = with(&format!("{text}{rest}"));
    assert_eq!(codes, Vec::<String>::new());
    let motion = &settings.machine.motion;
    let number = |key| motion.number(key).thousandths();
    assert_eq!(number(MotionKey::Angle), 45_000);
    assert_eq!(number(MotionKey::Accel), 400_000);
    assert_eq!(number(MotionKey::AccelContinuous), 300_000);
    assert_eq!(number(MotionKey::AccelRapid), 1_200_000);
    assert_eq!((number(MotionKey::Accuracy), number(MotionKey::Red)), (8000, 20_000));
    assert_eq!((number(MotionKey::Overload), number(MotionKey::Raise)), (10_000_000, 300_000));
    assert_eq!((motion.profile.value, motion.recognition.value), (Profile::Linear, Recognition::Automatic));
}
