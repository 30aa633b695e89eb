//! `compare` of words whose values nobody knows (CMP-1, PAR-5).

use crate::cli::Place;

/// What `compare` says of two programs that begin alike.
fn compared(old: &str, new: &str) -> String {
    let whole = |blocks: &str| {
        format!("%1\nN10 G90 G00 X0 Y0 Z50 T1 M06 S100 M03\n{blocks}N50 G01 X9 F100\nN60 M30\n").into_bytes()
    };
    let place = Place::with(&[("old.nc", &whole(old)), ("new.nc", &whole(new))]);
    let run = place.run(&["compare", "old.nc", "new.nc", "--lang", "en"]);
    assert!(run.code < Some(2), "{run:?}");
    run.stdout
}

/// A word counts each time that its value takes effect anew.
#[test]
fn words_written_again() {
    for (blocks, again) in [
        ("N20 MR40\nN30 M05\n", "N40 MR40\n"),
        ("N20 MR40\n", "N40 MR40\n"),
        ("N20 G04 QR40\n", "N40 G04 QR40\n"),
        ("N20 &R40\nN30 &0010\n", "N40 &R40\n"),
        ("N20 DR40\nN30 D5\n", "N40 DR40\n"),
        ("N20 HR40\nN30 H5\n", "N40 HR40\n"),
        ("N20 TR40 M06\nN30 T5 M06\n", "N40 TR40 M06\n"),
        ("N20 XR40\nN30 X5\n", "N40 XR40\n"),
        ("N15 G91\nN20 XR40\n", "N40 XR40\nN45 G90\n"),
        ("N20 G01 FR40 X2\nN30 F50 X3\n", "N40 FR40 X4\n"),
    ] {
        let whole = format!("{blocks}{again}");
        assert!(!compared(&whole, blocks).contains("do the same"), "{whole}: {}", compared(&whole, blocks));
        assert!(compared(&whole, &whole).contains("the programs do the same"), "{whole}");
    }
    let (once, again) = ("N20 FR40 DR41\n", "N20 FR40 DR41\nN40 FR40 DR41\n");
    assert!(compared(again, once).contains("the programs do the same"), "{}", compared(again, once));
}

/// The value before is one that nobody knows, not none.
#[test]
fn values_before() {
    let (old, new) = ("N20 XR40\nN30 X5\nN40 XR40\n", "N20 XR40\nN30 X5\nN40 XR42\n");
    assert!(compared(old, new).contains("X R40 → R42"), "{}", compared(old, new));
}

/// CMP-3: a line about added or removed blocks names the places in both programs.
#[test]
fn added_blocks_have_both_places() {
    let old = "%1\nN10 G90 G54 G00 X0 Y0 Z10 T1\nN20 M06 S900 M03 F100\nN30 G01 X5\nN40 X7\nN50 X99\nN99 M30\n";
    let new = old.replace("N40 X7\n", "N40 X7\nN42 Y5\nN44 Y6\n");
    let place = Place::with(&[("o.nc", old.as_bytes()), ("n.nc", new.as_bytes())]);
    let run = place.run(&["compare", "o.nc", "n.nc", "--lang", "en"]).ends(1);
    assert!(run.stdout.contains("T1: 2 blocks added after N40 (N42–N44)\n"), "{}", run.stdout);
    let run = place.run(&["compare", "n.nc", "o.nc", "--lang", "cs"]).ends(1);
    assert!(run.stdout.contains("T1: odebráno bloků: 2 za N40 (N42–N44)\n"), "{}", run.stdout);
}
