//! `restart` on lathes.

use crate::cli::Place;
use crate::restart::started;

/// RST-2: a lathe comes to the place along the axis that its project file names, in diameters.
#[test]
fn a_lathe() {
    let lathe = "%1\nN10 G90 G74 G0 X100 Z50\nN20 T1 M06\nN30 G0 X44 Z2\nN40 G1 X40 F100\nN50 Z-10\nN60 M30\n";
    let place = Place::with(&[("a.nc", lathe.as_bytes()), ("cnc872c.toml", b"[restart]\ntool-axis = \"X\"\n")]);
    let run = place.run(&["restart", "a.nc", "--n", "50"]).ends(0);
    let approach = ["G00 G90 X100 ", "G00 Z2 ", "G00 X44 ", "G01 X40 "];
    let mut at = 0;
    for block in approach {
        at += run.stdout[at..].find(block).unwrap_or_else(|| panic!("{block}: {}", run.stdout));
    }
    let way = "\"approach by X, the others, X again: in a bore this way is not clear\"\n";
    assert!(place.run(&["restart", "a.nc", "--n", "50", "--lang", "en"]).ends(0).stdout.contains(way));
    // From the other side of the axis an approach from above would cross the workpiece; facing goes a little beyond it.
    let beyond = |blocks: &str| {
        place.put("b.nc", format!("%1\nN10 G90 G74 T1 M06\nN20 S9 M03 F100\n{blocks}N90 G00 Z100\nN99 M30\n"));
        place.run(&["restart", "b.nc", "--n", "90", "--safe", "140", "--lang", "en"])
    };
    beyond("N30 G00 X-140 Z2\nN40 X-50\nN50 G01 Z-20\n").ends(1).says("the approach would cross the workpiece");
    beyond("N30 G00 X140 Z2\nN40 X-140\nN50 X-50\nN60 G01 Z-20\n").ends(1).says("the approach would cross");
    assert!(beyond("N30 G00 X50 Z0\nN40 G01 X-1.6\n").ends(0).stdout.contains("G00 X2.4 "));
    place.put("cnc872c.toml", "[[axes]]\nletter = \"X\"\n[restart]\ntool-axis = \"Z\"\n");
    place.run(&["restart", "a.nc", "--n", "50"]).ends(2).says("E0702");
}

/// MFN-9: under M40 the gear follows from the last speed of the spindle, also where S has become a cutting speed.
#[test]
fn gears_of_cutting_speeds() {
    let text = "%1\nN10 G90 G74 T1 D1 M06\nN20 S800 M40 M03\nN30 G00 X100 Z50\nN40 G96 S150\nN50 G01 X60 F200\n\
        N60 Z10\nN70 G00 X100\nN900 M30\n";
    let config = "[restart]\ntool-axis = \"X\"\n[[gears]]\nm = 41\nmin = 20\nmax = 500\n[[gears]]\nm = 42\nmin = 400\n\
        max = 3000\n";
    let place = Place::with(&[("a.nc", text.as_bytes()), ("cnc872c.toml", config.as_bytes())]);
    let made = place.run(&["restart", "a.nc", "--lang", "en", "--n", "60", "--safe", "120"]).ends(0).stdout;
    assert!(made.contains("G94 S800 \"speed for the spindle range\"") && made.contains("G96 S150 M03"), "{made}");
    // G94 makes a speed of the spindle of S, whatever it was written as.
    place.put("a.nc", text.replace("N60 Z10", "N52 G94 F100\nN54 G00 X80\nN56 G96 F120\nN60 G01 Z10"));
    let made = place.run(&["restart", "a.nc", "--lang", "en", "--n", "60", "--safe", "120"]).ends(0).stdout;
    assert!(made.contains("G94 S150 \"speed for the spindle range\""), "{made}");
}

/// RST-2: the top of an arc is worked, too, where it is above both ends: a way at the height between would cross it.
#[test]
fn heights_of_arcs() {
    let lathe = "[power-up]\nG1 = 19\nG10 = 74\n[restart]\ntool-axis = \"X\"\n";
    let ball = |arc: &str, rise: &str| {
        let text = format!(
            "%1\nN10 G54 G95 T1 D1 M06\nN20 S800 M03\nN30 G00 X0 Z2\nN40 G01 Z0 F0.2\nN50 {arc}\nN60 G01 Z-40\n\
            N70 G00 X{rise}\nN80 G01 X8 Z-45\nN90 G00 X60\nN99 M30\n"
        );
        started(lathe, &text, &["--n=80"])
    };
    let (bulges, straight) = ("G03 X10 Z-29.142 I0 J-15", "G01 X10 Z-29.142");
    ball(bulges, "12").ends(2).says("--safe is missing");
    assert!(ball(bulges, "32").ends(0).stdout.contains("G00 G90 X32 \"up to the program's highest"));
    assert!(ball(straight, "12").ends(0).stdout.contains("G00 G90 X12 \"up to the program's highest"));
    // The same along Z.
    let dome = "%1\nN10 G19 G54 T1 M06\nN20 G90 G00 X0 Y0 Z5 S800 M03 F200\nN30 G01 Z-5\nN40 G03 X40 I20 J0\nN50 G00 Z3\n\
        N60 X60\nN70 G01 Z-8\nN80 X80\nN90 G00 Z50\nN99 M30\n";
    started("", dome, &["--n=80"]).ends(2).says("--safe is missing");
    let groove = dome.replace("G03", "G02");
    assert!(started("", &groove, &["--n=80"]).ends(0).stdout.contains("G00 G90 Z5 \"up to"), "{groove}");
}
