//! Programs that are not executed to their end: because only the machine knows a parameter, which every command says
//! (PAR-5), and `restart` finds the nearest place before the value is lost (RST-4); or because of errors, in folders.

use crate::cli::Place;

/// How often N15 jumps is known to the machine alone.
const UNKNOWN_JUMP: &str = "%1\nN10 G90 G00 X0 Y0 Z5\nN12 X5\nN15 G73 L12 QR50\nN20 X7\nN30 M30\n";
const OTHER: &str = "%1\nN10 G90 G00 X0 Y0 Z5\nN30 M30\n";

#[test]
fn why_a_program_does_not_come_to_its_end() {
    let place = Place::with(&[("u.nc", UNKNOWN_JUMP.as_bytes()), ("o.nc", OTHER.as_bytes())]);
    for (args, status) in [
        (&["compare", "u.nc", "o.nc"][..], 2),
        (&["compare", "o.nc", "u.nc", "-A", "W0503"], 2),
        (&["restart", "u.nc", "--n", "12", "--pass", "1"], 1),
        (&["restart", "u.nc", "--list", "-A", "W0503"], 1),
        (&["state", "u.nc", "--n", "20"], 1),
        (&["report", "u.nc"], 1),
    ] {
        let run = place.run(args).ends(status);
        assert!(run.stderr.contains("error[W0503]: R50 is read"), "{args:?}\n{}", run.stderr);
        assert!(run.stdout.is_empty(), "{args:?}\n{}", run.stdout);
    }
    let run = place.run(&["state", "u.nc", "--n", "12", "--pass", "1"]).ends(0);
    assert!(run.stderr.contains("warning[W0503]"), "{}", run.stderr);
}

#[test]
fn a_start_before_a_value_is_lost() {
    let cuts: String = (0..20).map(|at| format!("N{} X{at}\n", 50 + at)).collect();
    let text = format!(
        "%1\nN10 G54 G90 G00 X0 Y0 Z50 F200\nN20 T5 M06\nN30 S900 M03\nN40 R10=R50\n{cuts}N80 Z60\nN90 G01 XR10\nN99 M30\n"
    );
    let place = Place::with(&[("p.nc", text.as_bytes())]);
    let run = place.run(&["restart", "p.nc", "--n", "68", "--safe", "70"]).ends(1);
    assert!(run.stderr.contains("the value of R10 is not known"), "{}", run.stderr);
    assert!(run.stderr.contains("N40"), "{}", run.stderr);
    let run = place.run(&["state", "p.nc", "--n", "60"]).ends(0);
    assert!(run.stdout.contains("R10  not known here  N40 (line 5)"), "{}", run.stdout);
    let run = place.run(&["restart", "p.nc", "--list", "--safe", "70"]).ends(0);
    let listed: Vec<&str> = run.stdout.lines().map(|line| line.split_whitespace().nth(2).unwrap()).collect();
    assert_eq!(listed, ["N10", "N20"], "{}", run.stdout);
}

/// A program for another control (W0113) is executed as any other: its arcs are judged, a cycle of that control is
/// a call that cannot be followed (§13).
#[test]
fn a_program_for_another_control() {
    let text = "%1\nN10 G90 G0 X0 Y0 Z5 F100\nN20 G02 X5 Y5\nN30 G71 U2 R1\nN40 G71 P50 Q60 U0.4 W0.1 F0.2\n\
                N50 G02 X9 Y9\nN60 M30\n";
    let place = Place::with(&[("p.nc", text.as_bytes())]);
    let run = place.run(&["check", "--format", "short", "p.nc"]).ends(1);
    assert_eq!(run.stdout.lines().count(), 5, "{}", run.stdout);
    assert!(
        run.stdout.contains("p.nc:3:5: error[E0602]") && run.stdout.contains("p.nc:6:5: error[E0602]"),
        "{}",
        run.stdout
    );
    let run = place.run(&["check", "p.nc"]).ends(1);
    assert!(run.stdout.contains("after N30 positions are not known: its call cannot be followed"), "{}", run.stdout);
}

/// CMP-5, CMP-7: errors in a program that only one folder has are reported; with `--partial` programs are the same as
/// far as both were executed.
#[test]
fn folders_with_errors() {
    let fine = "%1\nN10 G0 G90 X0\nN20 M30\n".as_bytes();
    let wrong = "%1\nN10 G0 G90 X0\nN20 X1 X2\nN30 M30\n".as_bytes();
    let files = [("a/a.nc", fine), ("b/a.nc", fine), ("b/b.nc", wrong), ("a/c.nc", wrong), ("b/c.nc", wrong)];
    let place = Place::with(&files);
    let run = place.run(&["compare", "a", "b", "--color", "never"]).ends(2);
    assert_eq!(
        run.stdout,
        "a.nc  the same\nb.nc  errors\nc.nc  errors\nprograms 3: same 1, different 0, added 0, removed 0, with errors 2\n"
    );
    assert_eq!(run.stderr.matches("error[E0306]").count(), 3, "{}", run.stderr);
    let run = place.run(&["compare", "a", "b", "--partial"]).ends(1);
    assert_eq!(
        run.stdout,
        "a.nc  the same\nb.nc  added\nc.nc  the same as far as executed\n\
        programs 3: same 2, different 0, added 1, removed 0, with errors 0\n"
    );
    place.run(&["compare", "a", "a", "--partial"]).ends(0);
    let run = place.run(&["compare", "a", "nothere"]).ends(2);
    assert!(run.stderr.contains("no such file"), "{}", run.stderr);
}
