//! Terminal safety: a terminal gets no control character that it would act on from a program, a name, the configuration
//! or the command line. Every place against every such character, in every form of output.

use std::path::Path;

use cnc872c::diag::Format;
use cnc872c::dict::Lang;
use cnc872c::text::MemoryLoader;
use serde_json::Value;

use crate::cli::Place;
use crate::markers::Request;
use crate::run::{Run, run};

/// Escape sequences, other controls of both sets, DEL, line ends of other systems, marks that reorder or hide text.
const HOSTILE: [&str; 33] = [
    "\u{1b}[2J",
    "\u{1b}]0;title\u{7}",
    "\u{0}",
    "\u{7}",
    "\u{8}",
    "\t",
    "\n",
    "\u{b}",
    "\u{c}",
    "\r",
    "\u{7f}",
    "\u{85}",
    "\u{90}",
    "\u{9b}2J",
    "\u{9d}",
    "\u{ad}",
    "\u{61c}",
    "\u{200b}",
    "\u{200e}",
    "\u{200f}",
    "\u{2028}",
    "\u{2029}",
    "\u{202a}",
    "\u{202b}",
    "\u{202c}",
    "\u{202d}",
    "\u{202e}",
    "\u{2066}",
    "\u{2067}",
    "\u{2068}",
    "\u{2069}",
    "\u{feff}",
    "\u{e0041}",
];

/// Characters that a terminal acts on, or that hide or reorder text, line ends aside: listed here from the standards.
fn is_raw(character: char) -> bool {
    match character {
        '\n' => false,
        '\u{0}'..='\u{1f}' | '\u{7f}'..='\u{9f}' => true,
        '\u{200e}' | '\u{200f}' | '\u{202a}'..='\u{202e}' | '\u{2066}'..='\u{2069}' | '\u{61c}' => true,
        '\u{ad}' | '\u{200b}' | '\u{2028}' | '\u{2029}' | '\u{feff}' | '\u{e0000}'..='\u{e007f}' => true,
        _ => false,
    }
}

/// The text without the colours that the program itself asks for: `ESC [ digits m`.
fn without_colours(text: &str) -> String {
    let mut parts = text.split("\u{1b}[");
    let mut plain = parts.next().unwrap().to_owned();
    for part in parts {
        let rest = part.trim_start_matches(|character: char| character.is_ascii_digit() || character == ';');
        match rest.strip_prefix('m') {
            Some(rest) => plain.push_str(rest),
            None => plain.push_str(&format!("\u{1b}[{part}")),
        }
    }
    plain
}

#[track_caller]
fn assert_safe(text: &str, what: &str) {
    assert!(!text.chars().any(is_raw), "{what}: {text:?}");
}

/// A run with `h` somewhere, and the format of its files.
type With = fn(h: &str) -> (MemoryLoader, String);

const OLD: &str = "%1\nN10 G0 X1 X2\nN20 M30\n";

fn files<const N: usize>(files: [(&str, String); N]) -> (MemoryLoader, String) {
    let loader = files.into_iter().fold(MemoryLoader::new(), |loader, (name, text)| loader.with(name, text));
    (loader, "p.nc".to_owned())
}

/// A project file beside a program.
fn project(text: String) -> (MemoryLoader, String) {
    files([("p.nc", OLD.to_owned()), ("cnc872c.toml", text)])
}

/// A ChannelConfig of a program.
fn channel(text: String) -> (MemoryLoader, String) {
    let project = "channel-config = \"c.xml\"\n".to_owned();
    files([("p.nc", OLD.to_owned()), ("cnc872c.toml", project), ("c.xml", text)])
}

/// The text as TOML writes it without the character itself.
fn toml(h: &str) -> String {
    h.chars().map(|character| format!("\\U{:08X}", u32::from(character))).collect()
}

/// Where hostile text may stand, so that a finding shows or names it.
const PLACES: [(&str, With); 34] = [
    ("comment", |h| files([("p.nc", format!("%1\nN10 G0 X1 \"A{h}B\" X2\nN20 M30\n"))])),
    ("long line", |h| {
        let (blanks, comment) = (" ".repeat(300), format!("\"{h}{h}{h}\""));
        files([("p.nc", format!("%1\nN10{blanks}G0 X1 {comment} X2 {comment}{blanks}\nN20 M30\n"))])
    }),
    ("name of the program", |h| files([("p.nc", format!("%1 \"A{h}B\" %2\nN20 M30\n"))])),
    ("between words", |h| files([("p.nc", format!("%1\nN10 G0 X1 ?{h}? X2\nN20 M30\n"))])),
    ("inside a number", |h| files([("p.nc", format!("%1\nN10 G0 X1{h}5 X2 X3\nN20 M30\n"))])),
    ("behind an address", |h| files([("p.nc", format!("%1\nN10 G0 X{h}5 X2 X3\nN20 M30\n"))])),
    ("before the program", |h| files([("p.nc", format!("N1 {h} %1\nN10 G0 X1 X2\nN20 M30\n"))])),
    ("after the program", |h| files([("p.nc", format!("{OLD}*\nX5 {h}"))])),
    ("name of a program", |h| {
        let name = format!("a{h}b.nc");
        (MemoryLoader::new().with(&name, OLD), name)
    }),
    ("name of a missing program", |h| (MemoryLoader::new(), format!("a{h}b.nc"))),
    ("name of a macrocycle's folder", |h| {
        let macros = format!("m{h}");
        files([
            ("p.nc", "%1\nN10 G72 L5\nN20 M30\n".to_owned()),
            ("cnc872c.toml", format!("macrocycles = [\"m{}\"]", toml(h))),
            (&format!("{macros}/L5"), "N1 G79 L5\nN2 X1 X2\nN3 G70\n".to_owned()),
        ])
    }),
    ("folder without the macrocycle", |h| {
        files([
            ("p.nc", "%1\nN10 G72 L5\nN20 M30\n".to_owned()),
            ("cnc872c.toml", format!("macrocycles = [\"m{}\"]", toml(h))),
        ])
    }),
    ("two macrocycles of one number", |h| {
        files([
            ("p.nc", "%1\nN10 G72 L5\nN20 M30\n".to_owned()),
            ("cnc872c.toml", format!("macrocycles = [\"m{}\"]", toml(h))),
            (&format!("m{h}/L5"), String::new()),
            (&format!("m{h}/L05"), String::new()),
        ])
    }),
    ("comment of a macrocycle", |h| {
        files([
            ("p.nc", "%1\nN10 G72 L5\nN20 M30\n".to_owned()),
            ("L5", format!("N1 G79 L5 \"{h}\nN2 X1 \"{h}\" X2\nX3\nN3 G70\n")),
        ])
    }),
    ("key, raw", |h| project(format!("\"a{h}b\" = 1\n"))),
    ("key, escaped", |h| project(format!("\"a{}b\" = 1\n", toml(h)))),
    ("key, twice", |h| project(format!("\"a{}b\" = 1\n\"a{}b\" = 1\n", toml(h), toml(h)))),
    ("key of a table", |h| project(format!("[\"a{}b\"]\nx = 1\n", toml(h)))),
    ("key of a parameter", |h| project(format!("[parameters]\n\"R{}\" = 1\n", toml(h)))),
    ("key of a lint", |h| project(format!("[lints]\n\"empty-block{}\" = \"deny\"\n", toml(h)))),
    ("key of an operation", |h| project(format!("[operations]\n\"0{}\" = \"add\"\n", toml(h)))),
    ("key of a cycle", |h| project(format!("[cycles]\n\"G8{}\" = 8100\n", toml(h)))),
    ("value, raw", |h| project(format!("dialect = \"cnc{h}\"\n"))),
    ("value, escaped", |h| project(format!("dialect = \"cnc{}\"\n", toml(h)))),
    ("value of a lint", |h| project(format!("[lints]\nempty-block = \"{}\"\n", toml(h)))),
    ("axis", |h| project(format!("[[axes]]\nletter = \"{}\"\nkind = \"{}\"\n", toml(h), toml(h)))),
    ("comment of the project file", |h| project(format!("x = 1 # {h}\n"))),
    ("path of a missing ChannelConfig", |h| project(format!("channel-config = \"c{}.xml\"\n", toml(h)))),
    ("path of a broken ChannelConfig", |h| {
        files([
            ("p.nc", OLD.to_owned()),
            ("cnc872c.toml", format!("channel-config = \"c{}.xml\"\n", toml(h))),
            (&format!("c{h}.xml"), "<a>".to_owned()),
        ])
    }),
    ("value of a ChannelConfig", |h| channel(format!("<a><MFunctions><MFunc No='{h}5x'/></MFunctions></a>"))),
    ("attribute of a ChannelConfig", |h| channel(format!("<a><MFunctions><MFunc No='50' X{h}='1'/></MFunctions></a>"))),
    ("element of a ChannelConfig", |h| channel(format!("<a><MFunctions><MFun{h} No='50'/></MFunctions></a>"))),
    ("closing tag of a ChannelConfig", |h| channel(format!("<a><b{h}></a{h}>"))),
    ("entity of a ChannelConfig", |h| channel(format!("<a>&x{h};</a><!-- {h} -->"))),
];

/// Whether the place may swallow the character: line ends and blanks between words and in XML are no fault.
fn checked(with: With, h: &str) -> Run {
    let (loader, name) = with(h);
    run(&loader, &name, &Request::default())
}

#[test]
fn nothing_raw_in_findings() {
    for (place, with) in PLACES {
        for h in HOSTILE {
            let run = checked(with, h);
            assert!(!run.codes().is_empty(), "{place} shows nothing of {h:?}");
            for lang in [Lang::En, Lang::Cs] {
                for format in [Format::Human, Format::Short, Format::Json, Format::Sarif, Format::Github] {
                    let text = run.text(format, lang);
                    let what = format!("{place}, {format:?}, {lang:?}");
                    assert_safe(&text, &what);
                    // A line end in a name would make two lines of one finding.
                    let lines = match format {
                        Format::Human => continue,
                        Format::Short | Format::Github => run.codes().len(),
                        Format::Json | Format::Sarif => 1,
                    };
                    assert_eq!(text.lines().count(), lines, "{what}: {text:?}");
                }
                assert_safe(&without_colours(&run.coloured(Format::Human, lang)), &format!("{place}, in colours"));
            }
        }
    }
}

/// Programs get names as they are, also those that are escaped for terminals.
#[test]
fn names_in_json_are_exact() {
    let program = PLACES.iter().find(|(place, _)| *place == "name of a program").unwrap().1;
    let shown = |run: &Run, format| serde_json::from_str::<Value>(&run.text(format, Lang::En)).unwrap();
    for h in HOSTILE {
        let run = checked(program, h);
        assert_eq!(shown(&run, Format::Json)["diagnostics"][0]["file"], format!("a{h}b.nc"));
    }
}

/// The block stream may go to a terminal too.
#[test]
fn nothing_raw_in_the_stream() {
    for h in HOSTILE {
        // A line end ends a comment too (LEX-6).
        let comment = if matches!(h, "\n" | "\r") { "" } else { h };
        let name = format!("a{h}b/p{h}.nc");
        let loader = MemoryLoader::new()
            .with(&name, format!("%1 \"T{comment}T\"\nN10 G0 G90 X0 \"C{comment}C\"\nN20 G72 L5\nN30 M30\n"))
            .with(format!("a{h}b/L5"), format!("N1 G79 L5\nN2 G0 X1 \"M{comment}M\"\nN3 G70\n"));
        let run = run(&loader, &name, &Request { compile: true, ..Request::default() });
        assert_eq!(run.codes(), [], "{h:?}");
        assert_safe(std::str::from_utf8(&run.stream).unwrap(), &format!("stream with {h:?}"));
        let records = run.records();
        let texts: Vec<&Value> = records.iter().flat_map(|record| [&record["title"], &record["comments"][0]]).collect();
        for text in [format!("T{comment}T"), format!("C{comment}C"), format!("M{comment}M")] {
            assert!(texts.iter().any(|found| **found == text), "{h:?}: {texts:?}");
        }
        assert_eq!(records[0]["name"], name);
        let file = records.iter().find(|record| record["kind"] == "file").unwrap();
        assert_eq!(Path::new(file["name"].as_str().unwrap()), Path::new(&format!("a{h}b/L5")));
    }
}

/// All at once, as one argument or name on disk; NUL and `/` cannot be in those.
fn all() -> String {
    HOSTILE.concat().replace('\0', "")
}

/// Nothing raw in what the program wrote, plain and in colours, in both languages; the name is there, escaped.
#[track_caller]
fn assert_told(place: &Place, arguments: &[&str]) {
    for options in [&[][..], &["--lang", "cs"], &["--color", "always"], &["--color", "always", "--lang", "cs"]] {
        let line = [options, arguments].concat();
        let run = place.run(&line);
        let text = without_colours(&format!("{}{}", run.stdout, run.stderr));
        assert_safe(&text, &format!("{line:?}"));
        assert!(text.contains("\\u{1b}[2J"), "{line:?}: {text}");
    }
}

#[test]
fn nothing_raw_of_arguments() {
    let place = Place::with(&[("a.nc", OLD.as_bytes())]);
    let h = all();
    let option = format!("--{h}");
    let inside = format!("missing/{h}");
    let lines: [&[&str]; 32] = [
        &[&h],
        &["check", &h],
        &["check", "a.nc", &h],
        &["check", "a.nc", &option],
        &["check", "a.nc", "--fix", &h],
        &["check", "a.nc", "--format", &h],
        &["check", "a.nc", "--dialect", &h],
        &["check", "a.nc", "--config", &h],
        &["check", "a.nc", "--channel-config", &h],
        &["check", "a.nc", "--param", &h],
        &["check", "a.nc", "--param", &format!("R10={h}")],
        &["check", "a.nc", "--encoding", &h],
        &["check", "a.nc", "--max-blocks", &h],
        &["check", "a.nc", "-D", &h],
        &["check", "a.nc", "-W", &h],
        &["check", "a.nc", "-A", &format!("empty-blok{h}")],
        &["compile", &h],
        &["compile", "a.nc", &h],
        &["compile", &h, "-o", &h],
        &["compile", "a.nc", "-o", &inside],
        &["compile", "a.nc", "--from", &h],
        &["compile", "a.nc", "--limit", &h],
        &["explain", &h],
        &["explain", "G73", &h],
        &["schema", &h],
        &["completions", &h],
        &["man", &h],
        &["help", &h],
        &["lsp", &h],
        &["check", "a.nc", "--color", &h],
        &["check", "a.nc", "--lang", &h],
        &["check", "-L", &h, &inside],
    ];
    for line in lines {
        if line.contains(&"--color") || line.contains(&"--lang") {
            let run = place.run(line).ends(2);
            assert_safe(&run.stderr, &format!("{line:?}"));
            assert!(run.stderr.contains("\\u{1b}[2J"), "{run:?}");
        } else {
            assert_told(&place, line);
        }
    }
}

#[cfg(unix)]
#[test]
fn nothing_raw_of_names_on_disk() {
    let h = all();
    let name = format!("{h}.nc");
    let lower = b"%1\nn10 g0 g90 x1 x2\nn20 g72 L5\nN30 M30\n";
    let place = Place::with(&[(&format!("empty{h}/x"), b"")]);
    assert_told(&place, &["check", &format!("empty{h}")]);
    let fresh = || {
        place.put(&name, lower);
        place.put(&format!("macros{h}/L5"), "n1 g79 l5\nn2 g0 x1 x2\nn3 G70\n");
    };
    let macros = format!("macros{h}");
    for format in ["human", "short", "github"] {
        fresh();
        assert_told(&place, &["check", ".", "--format", format]);
        assert_told(&place, &["check", "-L", &macros, &name, "--format", format]);
        assert_told(&place, &["check", "-L", &name, &name, "--format", format]);
        assert_told(&place, &["compile", "-L", &macros, &name, "--format", format]);
    }
    // Fixes are listed once, so each run has its own file.
    for lang in ["en", "cs"] {
        fresh();
        let run = place.run(&["check", "--fix", "-L", &macros, &name, "--lang", lang]);
        assert_safe(&run.stderr, "what was fixed");
        assert_eq!(run.stderr.lines().count(), 3, "the program, its fix, and the macrocycle that stays: {run:?}");
    }
    assert_told(&place, &["compile", &name, "-o", &name]);
    crate::cli::make_fifo(&place.path(&format!("pipe{h}")));
    assert_told(&place, &["check", "--fix", &format!("pipe{h}")]);
    place.put("cnc872c.toml", "");
    std::fs::rename(place.path("cnc872c.toml"), place.path(&format!("{h}.toml"))).unwrap();
    place.put(&format!("{h}.toml"), "x = 1\n");
    assert_told(&place, &["check", "--config", &format!("{h}.toml"), &name]);
    assert_told(&place, &["check", "--channel-config", &format!("{h}.toml"), &name]);
}

/// Bytes that are no UTF-8 may be controls of a terminal with another character set.
#[cfg(target_os = "linux")]
#[test]
fn nothing_raw_of_names_in_no_encoding() {
    use std::ffi::OsStr;
    use std::os::unix::ffi::OsStrExt;
    let name = OsStr::from_bytes(b"a\x9b2J\xff.nc");
    let place = Place::with(&[]);
    std::fs::write(place.path("").join(name), OLD).unwrap();
    for arguments in [&["check", "."][..], &["check", ".", "--format", "json"], &["check"], &["compile"], &["explain"]]
    {
        let mut command = place.command(arguments);
        if arguments.len() == 1 {
            command.arg(name);
        }
        let output = command.output().unwrap();
        for text in [output.stdout, output.stderr] {
            assert_safe(&String::from_utf8(text).unwrap(), &format!("{arguments:?}"));
        }
    }
}
