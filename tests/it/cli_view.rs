//! `view` on the real binary: where the page goes, what it holds, and what is left when it cannot be made.

use std::io::Read;

use serde_json::Value;

use crate::cli::{BAD, GOOD, Place, Run};

/// A program of ten executed blocks: a subprogram of four, called twice.
const CALLS: &str =
    "%7 \"CALLS\"\nN10 G0 G90 X0 Y0\nN20 G71 L5 Q2\nN30 M30\nN40 G79 L5\nN50 G1 X10 F100\nN60 X0\nN70 G70\n";

/// The header of the data that a page holds.
fn header(page: &[u8]) -> Value {
    let page = std::str::from_utf8(page).unwrap();
    let (_, rest) = page.split_once("id=\"cnc872c-data\">").unwrap();
    let (text, _) = rest.split_once("</script>").unwrap();
    let (mut bytes, mut held, mut bits) = (Vec::new(), 0_u32, 0);
    for character in text.chars() {
        let code = match character {
            '¡' => 0,
            '¢' => 13,
            '£' => 60,
            other => u32::from(other),
        };
        held = held << 7 | code;
        bits += 7;
        if bits >= 8 {
            bits -= 8;
            bytes.push((held >> bits) as u8);
            held &= (1 << bits) - 1;
        }
    }
    let mut inflated = Vec::new();
    flate2::read::DeflateDecoder::new(&bytes[..]).read_to_end(&mut inflated).unwrap();
    let length = u32::from_le_bytes(inflated[..4].try_into().unwrap()) as usize;
    serde_json::from_slice(&inflated[4..4 + length]).unwrap()
}

#[test]
fn the_page_stands_beside_the_program() {
    let place = Place::with(&[("parts/a.nc", GOOD.as_bytes())]);
    place.run(&["view", "parts/a.nc"]).ends(0).says("written: parts/a.nc.html");
    let page = place.read("parts/a.nc.html");
    let header = header(&page);
    assert_eq!(header["schema"], "cnc872c.path/1");
    assert_eq!((&header["blocks"], &header["count"], &header["whole"]), (&3.into(), &3.into(), &true.into()));
    assert_eq!(header["program"]["title"], "PLATE");
    let text = String::from_utf8(page).unwrap();
    for fetching in ["src=\"", "href=\"", "fetch(", "XMLHttpRequest", "import(", "url("] {
        assert!(!text.contains(fetching), "the page fetches something: {fetching}");
    }
    assert!(text.contains("<html lang=\"en\" data-lang=\"\">"));
}

#[test]
fn it_goes_where_it_is_told() {
    let place = Place::with(&[("a.nc", GOOD.as_bytes())]);
    place.run(&["view", "a.nc", "-o", "x.html", "--lang", "cs"]).ends(0).says("zapsáno: x.html");
    assert!(String::from_utf8(place.read("x.html")).unwrap().contains("data-lang=\"cs\""));
    let piped = place.run_with_stdin(&["view", "-", "-o", "-"], GOOD.as_bytes()).ends(0);
    assert_eq!(header(piped.stdout.as_bytes())["program"]["name"], "-");
    place.run_with_stdin(&["view", "-"], GOOD.as_bytes()).ends(2).says("name a file after -o");
    place.run(&["view", "a.nc", "-o", "a.nc"]).ends(2).says("view writes no .nc");
    place.run(&["view", "a.nc", "-o", "a.PDF"]).ends(2).says("view writes no .PDF");
    place.run(&["view", "x.html", "-o", "x.html"]).ends(2).says("what the picture is made from");
    let mut alone = place.command(&["view", "a.nc", "-o", "x.html", "--open"]);
    Run::of(alone.env("PATH", "").output().unwrap()).ends(2).says("x.html is written, but");
    place.run(&["view", "a.nc", "-o", "missing/x.html"]).ends(2).says("cannot write missing/x.html");
    place.run(&["view", "no.nc"]).ends(2);
    assert_eq!(place.list(), ["a.nc", "x.html"]);
}

#[test]
fn a_program_with_errors_is_drawn_as_far_as_execution_comes() {
    let late = "%1\nN10 G0 G90 X0\nN20 G1 X5 F100\nN30 G71 LR5\nN40 M30\n";
    let place = Place::with(&[("bad.nc", BAD.as_bytes()), ("late.nc", late.as_bytes())]);
    place.run(&["view", "bad.nc"]).ends(1).says("E0306");
    let found = header(&place.read("bad.nc.html"));
    assert_eq!(found["program"]["number"], 1, "also of a program that is not executed");
    assert_eq!((&found["whole"], &found["findings"][0]["code"]), (&false.into(), &"E0306".into()));
    assert_eq!(found["texts"][0][0], "skeletons");
    assert!(found["texts"][0][1].as_u64().unwrap() > 20, "the text is there");
    place.run(&["view", "late.nc"]).ends(1).says("W0503");
    let found = header(&place.read("late.nc.html"));
    assert_eq!((&found["whole"], &found["count"]), (&false.into(), &2.into()));
}

/// An earlier picture shows more than one of nothing; where there is none, the page shows the findings.
#[test]
fn a_program_that_is_not_executed_leaves_the_picture_of_before() {
    let place = Place::with(&[("a.nc", GOOD.as_bytes())]);
    for output in ["a.nc.html", "a.svg", "a.png"] {
        place.run(&["view", "a.nc", "-o", output]).ends(0);
        let before = place.read(output);
        place.put("a.nc", "%1\nN10 G0 X0 X5\nN20 M30\n");
        let run = place.run(&["view", "a.nc", "-o", output]).ends(1).says("stays as it was");
        assert!(!run.stderr.contains("written:"), "{run:?}");
        assert_eq!(place.read(output), before, "{output}");
        place.put("a.nc", GOOD);
    }
    assert_eq!(place.list(), ["a.nc", "a.nc.html", "a.png", "a.svg"], "nothing half written");
}

/// The same bytes from every working folder, and none of them names a folder of the computer.
#[test]
fn a_page_holds_no_folders_of_its_author() {
    let program = "%1 \"P\"\nN10 G0 G90 X0 Y0\nN20 G72 L9001\nN30 G72 L9002\nN40 M30\n";
    let place = Place::with(&[
        ("home/someone/shop/part.nc", program.as_bytes()),
        ("home/someone/shop/cnc872c.toml", b"macrocycles = [\"macros\", \"../others\"]\n"),
        ("home/someone/shop/macros/L9001", b"N1 G79 L9001\nN2 G1 X5 F100\nN3 G70\n"),
        ("home/someone/others/L9002", b"N1 G79 L9002\nN2 G1 Y5 F100 \"no rule\"\nN3 G70\n"),
    ]);
    let pages = [
        ("", "home/someone/shop/part.nc".to_owned()),
        ("home/someone/shop", "part.nc".to_owned()),
        ("home/someone/others", "../shop/part.nc".to_owned()),
        ("home", place.path("home/someone/shop/part.nc").to_string_lossy().into_owned()),
    ]
    .map(|(folder, program)| {
        let page = place.path("page.html");
        let mut command = place.command(&["view", &program, "-o", page.to_str().unwrap()]);
        Run::of(command.current_dir(place.path(folder)).output().unwrap()).ends(0);
        place.read("page.html")
    });
    let header = header(&pages[0]);
    let names: Vec<&str> =
        header["files"].as_array().unwrap().iter().map(|file| file["name"].as_str().unwrap()).collect();
    assert_eq!(names, ["part.nc", "macros/L9001", "L9002"]);
    assert_eq!(header["program"]["name"], "part.nc");
    assert!(!header.to_string().contains("someone"));
    assert!(pages.iter().all(|page| *page == pages[0]));
    assert!(String::from_utf8_lossy(&pages[0]).contains("<title>part.nc</title>"));
    // Nor do a comparison, and the options with which a command starts where the page shows.
    let [old, new, out] = ["part.nc", "part.nc", "page.html"].map(|name| place.path("home/someone/shop").join(name));
    let (others, config) = (place.path("home/someone/others"), place.path("home/someone/shop/cnc872c.toml"));
    let given =
        ["-L", others.to_str().unwrap(), "-L", "home/someone/shop/macros", "--config", config.to_str().unwrap()];
    let given = [&given[..], &["--param", "R1=-2.5", "--block-skip", "--dialect", "cnc872"]].concat();
    let files = [old.to_str().unwrap(), new.to_str().unwrap(), "-o", out.to_str().unwrap()];
    place.run(&[&["compare"], &files[..], &given].concat()).ends(0);
    let page = std::fs::read(out).unwrap();
    assert!(!String::from_utf8_lossy(&page).contains("someone"));
    let header = self::header(&page);
    assert!(!header.to_string().contains("someone"), "{header}");
    assert_eq!(header["compared"]["old"]["name"], "part.nc");
    let arguments = "--dialect cnc872 --config cnc872c.toml -L others -L macros --param R1=-2.5 --block-skip";
    assert_eq!(header["arguments"], serde_json::json!(arguments.split(' ').collect::<Vec<_>>()));
    // Words of findings name files too.
    place.put("home/someone/shop/macros/L9001", "N1 G79 L9003\nN2 G70\n");
    let mut command = place.command(&["view", place.path("home/someone/shop/part.nc").to_str().unwrap()]);
    Run::of(command.output().unwrap()).ends(1).says("E0216");
    let header = self::header(&place.read("home/someone/shop/part.nc.html"));
    assert!(!header.to_string().contains("someone"), "{header}");
    assert!(header["findings"][0]["message"]["en"].as_str().unwrap().contains("macros/L9001"), "{header}");
}

/// Up to the first block with an error, be it written or found by execution.
#[test]
fn a_program_is_drawn_up_to_its_first_error() {
    for (error, drawn) in [("N40 X0 X5", 3), ("N40 G2 X20 Y20 I15 J0", 3), ("N40 G71 L5", 3), ("N40 X0", 6)] {
        let program = format!("%1\nN10 G90 G0 X0 Y0 Z0\nN20 G1 X50 F100\nN30 Y30\n{error}\nN50 Y0\nN60 M30\n");
        let place = Place::with(&[("a.nc", program.as_bytes())]);
        let status = i32::from(drawn < 6);
        place.run(&["view", "a.nc"]).ends(status);
        let header = header(&place.read("a.nc.html"));
        assert_eq!((&header["count"], &header["whole"]), (&drawn.into(), &(drawn == 6).into()), "{error}");
    }
}

/// Lathes: X and Z alone in a plane of lathes, or G74.
#[test]
fn a_lathe_is_drawn_in_zx() {
    let mill = "%1\nN10 G90 G0 X0 Y0 Z0\nN20 G1 X50 F100\nN30 M30\n";
    let turning = "%1\nN10 G19 G90 G0 X10 Z0\nN20 G1 X50 F100\nN30 Z-20\nN40 M30\n";
    let files = [
        ("mill.nc", mill.to_owned(), [false, false]),
        ("turn.nc", turning.to_owned(), [true, false]),
        ("diameters.nc", turning.replace("G19", "G17 G74"), [true, true]),
        ("side.nc", turning.replace("G19 G90 G0", "G19 G90 G0 Y5"), [false, false]),
    ];
    for (name, text, [lathe, diameter]) in files {
        let place = Place::with(&[(name, text.as_bytes())]);
        place.run(&["view", name]).ends(0);
        let header = header(&place.read(&format!("{name}.html")));
        assert_eq!((&header["turning"], &header["diameter"]), (&lathe.into(), &diameter.into()), "{name}");
        let svg = |plane: &[&str]| {
            place.run(&[&["view", name, "-o", "a.svg"], plane].concat()).ends(0);
            String::from_utf8(place.read("a.svg")).unwrap()
        };
        assert_eq!(svg(&[]) == svg(&["--plane", "ZX"]), lathe, "{name}");
        assert_eq!(svg(&[]).contains(">ØX</text>"), diameter, "{name}");
    }
}

/// Comments and texts are no part of the records, and passes of a loop share what was planned of them.
#[test]
fn texts_cost_the_page_their_compressed_bytes() {
    let blocks = |block: &dyn Fn(u32) -> String| {
        let body: String = (3..4000).map(|n| format!("N{n} {}\n", block(n))).collect();
        format!("%1\nN1 G90 G0 X0 Y0 Z0\nN2 G1 X1 F1000\n{body}N4000 M30\n")
    };
    let place = Place::with(&[
        ("comments.nc", blocks(&|n| format!("X{} \"comment number {n}\"", n % 100)).as_bytes()),
        ("parameters.nc", blocks(&|n| format!("R{}={}.5 X{}", 10 + n % 50, n, n % 100)).as_bytes()),
    ]);
    for name in ["comments", "parameters"] {
        place.run(&["view", &format!("{name}.nc")]).ends(0);
        let header = header(&place.read(&format!("{name}.nc.html")));
        assert!(header.to_string().len() < 20_000, "{name}");
        assert!(!header.to_string().contains("comment number"));
    }
}

/// What would take too much memory is given up, and nothing else is done with it.
#[test]
fn a_picture_gives_up_before_memory_runs_out() {
    use cnc872c::session::Session;
    use cnc872c::view::{Collector, Keep, Part};
    let body: String = (3..9000).map(|n| format!("N{n} X{}\n", n % 100)).collect();
    let program = format!("%1\nN1 G90 G0 X0 Y0 Z0\nN2 G1 X1 F1000\n{body}N9000 M30\n");
    let loader = cnc872c::text::MemoryLoader::new().with("a.nc", program);
    let settings = cnc872c::config::Settings::default();
    let too_large = |keep: Keep, part: Part, room: fn() -> usize| {
        let mut collector = Collector::new(&settings, part, keep).within(room);
        let session = Session { loader: &loader, settings: &settings, progress: None };
        let run = session.draw(std::path::Path::new("a.nc"), "a.nc", collector.sink());
        (collector.is_too_large(), run.whole.is_some())
    };
    let all = Part { from: 0, blocks: None };
    assert_eq!(too_large(Keep::Records, all, || 100_000), (true, false));
    assert_eq!(too_large(Keep::Records, all, || 100_000_000), (false, true));
    // Blocks that are not drawn cost nothing but their places in the text.
    assert_eq!(too_large(Keep::Records, Part { from: 0, blocks: Some(10) }, || 500_000), (false, true));
}

/// Lines that others cover, and red dots at one place, are drawn once; the picture says how many dots that leaves out.
#[test]
fn a_zigzag_is_thinned() {
    let body: String =
        (3..30_000).map(|n| format!("N{n} X{} Y0.{:03}\n", if n % 2 == 0 { 0 } else { 100 }, n / 40)).collect();
    let program = format!("%1\nN1 G23 G17 G90 G0 X0 Y0 Z0\nN2 G1 X1 F1000\n{body}N30000 M30\n");
    let place = Place::with(&[("zigzag.nc", program.as_bytes())]);
    place.run(&["view", "zigzag.nc", "-o", "a.svg"]).ends(0).says("red dots are not drawn");
    let svg = String::from_utf8(place.read("a.svg")).unwrap();
    assert!(svg.len() < 300_000, "{}", svg.len());
    assert!(svg.contains("red dots not drawn</text>") && !dots(&svg, "dot red").is_empty());
    assert!(!svg.contains("<image"), "few lines are left");
}

/// Holes of a cycle that is not mapped have no line; behind a change of origin a line starts where no tool stands
/// (MOT-8).
#[test]
fn motions_of_cycles_and_from_another_origin_are_told() {
    let holes = "%1\nN1 G90 G0 X0 Y0 Z5\nN2 G81 X10 Y10 Z-5 F100\nN3 X20\nN4 G80\nN5 X1 Y1\nN6 M30\n";
    let origins = "%1\nN1 G90 G54 G0 X0 Y0 Z5\nN2 X50\nN3 G55\nN4 G1 X-200 F100\nN5 X-180\nN6 M30\n";
    let place = Place::with(&[("holes.nc", holes.as_bytes()), ("origins.nc", origins.as_bytes())]);
    place.run(&["view", "holes.nc", "-o", "a.svg"]).ends(0).says("motions that are not drawn: 4");
    let told = place.run(&["view", "origins.nc", "-o", "b.svg"]).ends(0);
    told.says("motions that are not drawn: 1").says("drawn from a position of another origin");
    let svg = String::from_utf8(place.read("b.svg")).unwrap();
    assert!(svg.contains("1 motion from another origin</text>") && svg.contains("class=\"linear\""));
}

/// R387: the first N executed blocks; and from a later one on.
#[test]
fn a_part_of_the_program() {
    let place = Place::with(&[("a.nc", CALLS.as_bytes())]);
    for (options, from, count) in [
        (&[][..], 0, 11),
        (&["--blocks", "4"], 0, 4),
        (&["--from", "3"], 3, 8),
        (&["--from", "3", "--blocks", "5"], 3, 2),
    ] {
        place.run(&[&["view", "a.nc"], options].concat()).ends(0);
        let header = header(&place.read("a.nc.html"));
        assert_eq!((&header["from"], &header["count"]), (&from.into(), &count.into()), "{options:?}");
        assert_eq!((&header["blocks"], &header["whole"]), (&11.into(), &true.into()));
    }
    // Nothing is drawn of nothing.
    let before = place.read("a.nc.html");
    for empty in [&["--from", "50"][..], &["--blocks", "0"]] {
        let run = place.run(&[&["view", "a.nc"], empty].concat()).ends(2);
        run.says("the program executes 11 blocks, seq 0 to 10");
        place.run(&[&["view", "a.nc", "-o", "new.svg"], empty].concat()).ends(2);
    }
    assert!(place.read("a.nc.html") == before && !place.list().contains(&"new.svg".to_owned()));
}

/// The second pass of a subprogram that leaves everything as it was adds no rows.
#[test]
fn repeats_share_their_rows() {
    let place = Place::with(&[
        ("few.nc", CALLS.replace("Q2", "Q3").as_bytes()),
        ("many.nc", CALLS.replace("Q2", "Q3000").as_bytes()),
    ]);
    let rows = |name: &str| {
        place.run(&["view", name]).ends(0);
        let header = header(&place.read(&format!("{name}.html")));
        let columns = header["columns"].as_array().unwrap().clone();
        columns.iter().find(|column| column[0] == "row.block").unwrap()[1].as_u64().unwrap()
    };
    assert_eq!(rows("few.nc"), rows("many.nc"));
}

fn sample(name: &str) -> Vec<u8> {
    std::fs::read(crate::samples::root().join("samples").join(name)).unwrap()
}

/// What stands between quotes behind each `data-seq=` of an element of that class.
fn dots(svg: &str, class: &str) -> Vec<u64> {
    let elements = svg.split('<').filter(|element| element.contains(&format!("class=\"{class}\"")));
    let seq = |element: &str| element.split("data-seq=\"").nth(1)?.split('"').next()?.parse().ok();
    let mut seqs: Vec<u64> = elements.filter_map(seq).collect();
    seqs.sort_unstable();
    seqs
}

/// Joints with dots of both colours.
const JOINTS: &str = "%1 \"JOINTS\"\nN10 G23 G17 G90 G0 X0 Y0 Z0\nN20 G1 X10 F1000\nN30 X20 Y5\nN40 X30\nN50 Y20 Z4\nN60 X10 Y30\n\
    N70 X0 Y20\nN80 X5 Y15\nN90 M30\n";

/// DOT-1: every dot of the motion stream, each red one with its number.
#[test]
fn a_still_picture_has_the_dots_of_the_motion_stream() {
    let place = Place::with(&[("joints.nc", JOINTS.as_bytes())]);
    place.run(&["view", "joints.nc", "-o", "a.svg"]).ends(0).says("written: a.svg");
    let svg = String::from_utf8(place.read("a.svg")).unwrap();
    let motion = place.run(&["motion", "joints.nc", "--format", "json"]).ends(0).stdout;
    let records: Vec<Value> = motion.lines().map(|line| serde_json::from_str(line).unwrap()).collect();
    for (class, dot) in [("dot red", "red"), ("dot yellow", "yellow")] {
        let with_dot = records.iter().filter(|record| record["joint"]["dot"] == dot);
        let expected: Vec<u64> = with_dot.map(|record| record["seq"].as_u64().unwrap()).collect();
        assert!(!expected.is_empty());
        assert_eq!(dots(&svg, class), expected, "{dot}");
    }
    assert!(svg.starts_with("<svg ") && svg.contains("width=\"1600\" height=\"1000\""));
    assert!(svg.contains(">N"), "red dots have numbers");
    for (plane, other) in [("XY", "XZ"), ("XZ", "YZ"), ("YZ", "iso"), ("iso", "XY")] {
        let of = |plane: &str| {
            place.run(&["view", "joints.nc", "-o", "p.svg", "--plane", plane, "--size", "640x400"]).ends(0);
            String::from_utf8(place.read("p.svg")).unwrap()
        };
        let (svg, again) = (of(plane), of(plane));
        assert!(svg.contains("width=\"640\" height=\"400\""));
        assert_eq!(svg, again);
        assert_ne!(svg, of(other), "{plane}, {other}");
    }
    place.run(&["view", "joints.nc", "--plane", "XZ"]).ends(2).says("--plane goes with a still picture");
    place.run(&["view", "joints.nc", "--size", "800x600"]).ends(2).says("--size goes with a still picture");
    place.run(&["view", "joints.nc", "--open", "-o", "-"]).ends(2).says("-o - writes none");
    for size in ["640", "63x100", "20001x100", "10001x10000"] {
        place.run(&["view", "joints.nc", "-o", "p.svg", "--size", size]).ends(2).says("1600x1000");
    }
    place.run(&["view", "joints.nc", "-o", "p.svg", "--plane", "YX"]).ends(2);
}

/// motion.md: every output says that the machine is assumed, a picture too.
#[test]
fn a_still_picture_says_what_its_dots_rest_on() {
    let place = Place::with(&[("joints.nc", JOINTS.as_bytes())]);
    let said = "the machine of the estimate is assumed";
    place.run(&["view", "joints.nc", "-o", "a.svg"]).ends(0).says(said);
    place.run(&["view", "joints.nc", "-o", "a.png"]).ends(0).says(said);
    assert!(String::from_utf8(place.read("a.svg")).unwrap().contains(">assumed machine</text>"));
    let page = place.run(&["view", "joints.nc"]).ends(0);
    assert!(!page.stderr.contains(said), "the page says it itself: {page:?}");
    place.put("cnc872c.toml", "[motion]\naccel-mm-s2 = 400\n");
    let run = place.run(&["view", "joints.nc", "-o", "a.svg"]).ends(0);
    assert!(!run.stderr.contains(said), "{run:?}");
    assert!(!String::from_utf8(place.read("a.svg")).unwrap().contains("assumed"));
}

/// What other programs read on stderr is one object, and nothing else.
#[test]
fn findings_as_json_stand_alone() {
    let place = Place::with(&[("bad.nc", BAD.as_bytes()), ("joints.nc", JOINTS.as_bytes())]);
    for line in [&["view", "bad.nc"][..], &["view", "joints.nc", "-o", "a.svg"]] {
        let run = place.run(&[line, &["--format", "json"]].concat());
        serde_json::from_str::<Value>(&run.stderr).unwrap();
    }
}

#[test]
fn a_still_picture_as_png() {
    let place = Place::with(&[("flange.nc", &sample("ok/flange.nc"))]);
    let made = |size: &str| {
        place.run(&["view", "flange.nc", "-o", "a.png", "--size", size]).ends(0);
        place.read("a.png")
    };
    let png = made("320x200");
    assert_eq!(png, made("320x200"), "the same bytes");
    assert_eq!(&png[..8], b"\x89PNG\r\n\x1a\n");
    let side = |at: usize| u32::from_be_bytes(png[at..at + 4].try_into().unwrap());
    assert_eq!((&png[12..16], side(16), side(20)), (&b"IHDR"[..], 320, 200));
}

/// The whole program's time and every dot are in the page, whatever part of it is drawn.
#[test]
fn the_page_has_the_times_of_the_motion_stream() {
    let place = Place::with(&[("flange.nc", &sample("ok/flange.nc"))]);
    let motion = place.run(&["motion", "flange.nc", "--format", "json"]).ends(0).stdout;
    let total: Value = serde_json::from_str(motion.lines().last().unwrap()).unwrap();
    for options in [&[][..], &["--from", "10"], &["--blocks", "20"]] {
        place.run(&[&["view", "flange.nc"], options].concat()).ends(0);
        let header = header(&place.read("flange.nc.html"));
        let near = header["total"]["time_s"].as_f64().unwrap() - total["time_s"].as_f64().unwrap();
        assert!(near.abs() < 1e-6, "{options:?}: {near}");
        assert_eq!(header["machine"]["assumed"], true);
    }
}

/// EQU-1 to EQU-4: the corrected path in blue, red where there is no room.
#[test]
fn the_equidistant_is_in_the_picture() {
    let files = |folder: &str| {
        let read = |name: &str| sample(&format!("{folder}/{name}"));
        Place::with(&[("cnc872c.toml", &read("cnc872c.toml")), ("a.nc", &read("program.nc"))])
    };
    let place = files("err/W0811-correction-collides");
    place.run(&["view", "a.nc", "-o", "a.svg"]).ends(0).says("W0811");
    let svg = String::from_utf8(place.read("a.svg")).unwrap();
    assert!(svg.contains("<path class=\"equidistant\"") && svg.contains("<path class=\"collision\""));
    place.run(&["view", "a.nc"]).ends(0).says("W0811");
    let pieces = header(&place.read("a.nc.html"))["equidistant"]["pieces"].as_array().unwrap().clone();
    let bad: Vec<u64> =
        pieces.iter().filter(|piece| piece["bad"] == true).map(|piece| piece["seq"].as_u64().unwrap()).collect();
    assert_eq!(bad, [4, 9, 14]);
    let place = files("rules/equ-corrections");
    place.run(&["view", "a.nc", "-o", "a.svg"]).ends(0);
    let svg = String::from_utf8(place.read("a.svg")).unwrap();
    assert!(svg.contains("<path class=\"equidistant\"") && !svg.contains("<path class=\"collision\""));
    // Where it runs: the first motion goes to the offset start of the next one.
    place.run(&["view", "a.nc"]).ends(0);
    let pieces = header(&place.read("a.nc.html"))["equidistant"]["pieces"].as_array().unwrap().clone();
    assert_eq!(pieces[0]["seq"], 1);
    assert_eq!(pieces[0]["points"].as_array().unwrap().len(), 6);
}

/// The command and the picture name the parts that the picture omits.
#[test]
fn too_many_yellow_dots_are_left_out_and_that_is_said() {
    let mut program = String::from("%1\nN1 G23 G17 G90 G0 X0 Y0 Z0\nN2 G1 X1 F3000\n");
    for block in 3..20_030 {
        program.push_str(&format!("N{block} X{block}\n"));
    }
    program.push_str("N20030 M30\n");
    let place = Place::with(&[("long.nc", program.as_bytes())]);
    let said = "yellow dots are not drawn";
    place.run(&["view", "long.nc", "-o", "a.svg"]).ends(0).says(said);
    let svg = String::from_utf8(place.read("a.svg")).unwrap();
    assert!(svg.contains("yellow dots not drawn</text>") && !svg.contains("<circle"));
    place.run(&["view", "long.nc", "-o", "a.png", "--lang", "cs"]).ends(0).says("nekreslených žlutých teček");
    let few = place.run(&["view", "long.nc", "-o", "a.svg", "--blocks", "900"]).ends(0);
    assert!(!few.stderr.contains(said));
    assert_eq!(dots(&String::from_utf8(place.read("a.svg")).unwrap(), "dot yellow").len(), 898);
}

/// A device is written to, as `compile` does; a failing opener is reported.
#[cfg(target_os = "linux")]
#[test]
fn devices_and_openers() {
    let place = Place::with(&[("a.nc", GOOD.as_bytes())]);
    let page = place.run(&["view", "a.nc", "-o", "-"]).ends(0).stdout;
    assert_eq!(place.run(&["view", "a.nc", "-o", "/dev/stdout"]).ends(0).stdout, page);
    place.put("bin/xdg-open", "#!/bin/sh\nexit 3\n");
    let opener = place.path("bin/xdg-open");
    assert!(std::process::Command::new("chmod").arg("+x").arg(&opener).status().unwrap().success());
    let mut command = place.command(&["view", "a.nc", "-o", "x.html", "--open"]);
    let output = command.env("PATH", opener.parent().unwrap()).output().unwrap();
    assert_eq!(output.status.code(), Some(2), "{output:?}");
    assert!(String::from_utf8_lossy(&output.stderr).contains("xdg-open did not open it"), "{output:?}");
}
