//! `init`: a project file to begin with.

use crate::cli::{GOOD, Place};

#[test]
fn a_file_for_each_control() {
    let place = Place::with(&[("a.nc", GOOD.as_bytes()), ("sub/a.nc", GOOD.as_bytes())]);
    let run = place.run(&["init"]).ends(0);
    assert!(run.stdout.is_empty() && run.stderr.starts_with("cnc872c.toml is written"), "{run:?}");
    place.run(&["init", "sub", "--dialect", "cnc8x9", "--lang", "cs"]).ends(0).says("sub/cnc872c.toml je zapsán");
    let text = |name: &str| String::from_utf8(place.read(name)).unwrap();
    assert!(text("cnc872c.toml").contains("\ndialect = \"cnc872\" "));
    assert!(text("cnc872c.toml").contains("\n#g97 = \"per-minute\" "));
    let czech = text("sub/cnc872c.toml");
    assert!(czech.contains("\ndialect = \"cnc8x9\" ") && czech.contains("\n#feed = 24000 "), "{czech}");
    assert!(czech.contains("# řídicí systém, pro který programy jsou"), "{czech}");
    place.run(&["check", "a.nc", "sub/a.nc", "--deny-warnings"]).ends(0);
}

/// A file that is there stays, whatever it is; so does a link.
#[test]
fn nothing_is_overwritten() {
    let place = Place::with(&[("cnc872c.toml", b"mine"), ("folder/x", b""), ("dir/cnc872c.toml/x", b"")]);
    place.run(&["init"]).ends(2).says("cnc872c.toml exists, and stays as it is");
    place.run(&["init", "."]).ends(2).says("exists");
    assert_eq!(place.read("cnc872c.toml"), b"mine");
    place.run(&["init", "dir"]).ends(2);
    place.run(&["init", "nothing"]).ends(2).says("nothing: there is no such folder");
    #[cfg(unix)]
    {
        std::os::unix::fs::symlink("elsewhere", place.path("folder/cnc872c.toml")).unwrap();
        place.run(&["init", "folder", "--lang", "cs"]).ends(2).says("už existuje");
        assert!(!place.path("folder/elsewhere").exists());
    }
}

/// Folders of macrocycles and a ChannelConfig that are there are named; programs then find them.
#[test]
fn what_is_there_is_in_force() {
    let cycle = b"N1 G79 L9001\nN2 G70\n";
    let files: [(&str, &[u8]); 5] = [
        ("a.nc", b"%1\nN10 G90 G00 X0\nN20 G72 L9001\nN30 M30\n"),
        ("cycles/mill/L9001", cycle),
        ("notes.xml", b"<notes/>"),
        ("Channel.xml", b"<ChannelConfig><MFunctions><MFunc No='3'/></MFunctions></ChannelConfig>"),
        (".git/L5", cycle),
    ];
    let place = Place::with(&files);
    place.run(&["check", "a.nc"]).ends(1);
    place.run(&["init"]).ends(0);
    let text = String::from_utf8(place.read("cnc872c.toml")).unwrap();
    assert!(text.contains("\nmacrocycles = [\"cycles/mill\"]"), "{text}");
    assert!(text.contains("\nchannel-config = \"Channel.xml\""), "{text}");
    place.run(&["check", "a.nc"]).ends(0);
}

/// The folders stay a comment where programs would call the macrocycle of another job: a job has its macrocycles beside
/// it and others are elsewhere, or a number is there twice. Only macrocycles make a folder one of them.
#[test]
fn folders_of_several_jobs_are_left_out() {
    let cycle: &[u8] = b"N1 G79 L3\nN2 G00 Z-50\nN3 G70\n";
    let call: &[u8] = b"%1\nN10 G90 G00 X0\nN20 G72 L3\nN30 M30\n";
    let plain: &[u8] = b"%1\nN10 G90 G00 X0\nN30 M30\n";
    let written = |files: &[(&str, &[u8])]| {
        let place = Place::with(files);
        place.run(&["init"]).ends(0);
        let text = String::from_utf8(place.read("cnc872c.toml")).unwrap();
        let key = text.lines().find(|line| line.contains("macrocycles = [\"")).unwrap();
        (key.split("  #").next().unwrap().trim().to_owned(), text.contains("# Left out"), place)
    };
    let (key, said, place) = written(&[("A/a.nc", call), ("B/L3", cycle), ("B/b.nc", call)]);
    assert_eq!((key.as_str(), said), ("#macrocycles = [\"B\"]", true));
    assert!(place.run(&["check", "A/a.nc"]).ends(1).stdout.contains("E0405"));
    let (key, said, place) = written(&[("1/L3", cycle), ("1/a.nc", call), ("2/L3", cycle), ("2/a.nc", call)]);
    assert_eq!((key.as_str(), said), ("#macrocycles = [\"1\", \"2\"]", true));
    place.run(&["check", "."]).ends(0);
    let (key, said, _) = written(&[("jobs/a.nc", plain), ("1/L3", cycle), ("2/l03.mrc", cycle)]);
    assert_eq!((key.as_str(), said), ("#macrocycles = [\"1\", \"2\"]", true));
    let (key, said, _) = written(&[("a.nc", call), ("L4", cycle), ("lib/L3", cycle)]);
    assert_eq!((key.as_str(), said), ("macrocycles = [\".\", \"lib\"]", false));
    let below = [("1/a.nc", call), ("1/macros/L3", cycle), ("2/b.nc", call)];
    let (key, said, place) = written(&below);
    assert_eq!((key.as_str(), said), ("#macrocycles = [\"1/macros\"]", true));
    assert!(place.run(&["check", "2/b.nc"]).ends(1).stdout.contains("E0405"));
    let (key, said, _) = written(&[("1/a.nc", call), ("1/b/c.nc", call), ("1/macros/L3", cycle)]);
    assert_eq!((key.as_str(), said), ("macrocycles = [\"1/macros\"]", false));
    let (key, said, _) = written(&[("a/L12.nc", plain), ("b/L5.txt", b"Notes: N10 is slow"), ("c/L3", cycle)]);
    assert_eq!((key.as_str(), said), ("macrocycles = [\"c\"]", false));
}

/// A ChannelConfig is in force when there is no other and `check` takes it. A project file above is told of.
#[test]
fn channels_and_projects_above() {
    let channel = |group: u8| format!("<C><MFunctions><MFunc No='91' GroupNo='{group}'/></MFunctions></C>");
    let written = |files: &[(&str, &str)]| {
        let files: Vec<(&str, &[u8])> = files.iter().map(|(name, text)| (*name, text.as_bytes())).collect();
        let place = Place::with(&[&[("a.nc", GOOD.as_bytes())], files.as_slice()].concat());
        place.run(&["init"]).ends(0);
        place.run(&["check", "a.nc"]).ends(0);
        let text = String::from_utf8(place.read("cnc872c.toml")).unwrap();
        (text.contains("\nchannel-config = \"A.xml\""), text.contains("\n#channel-config = \"A.xml\""))
    };
    assert_eq!(written(&[("A.xml", &channel(10))]), (true, false));
    assert_eq!(written(&[("A.xml", &channel(10)), ("B.xml", &channel(11))]), (false, true));
    assert_eq!(written(&[("A.xml", &channel(99))]), (false, true));
    let place = Place::with(&[("cnc872c.toml", b"dialect = \"cnc8x6\"\n"), ("sub/a.nc", GOOD.as_bytes())]);
    place.run(&["init", "sub", "--lang", "en"]).ends(0).says("takes the place of cnc872c.toml");
}
