//! `view` on the real binary: where the page goes, what it holds, and what is left when it cannot be made.

use std::io::Read;

use serde_json::Value;

use crate::cli::{BAD, GOOD, Place};

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
    place.run(&["view", "a.nc", "-o", "a.nc"]).ends(2).says("the program itself");
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
    assert_eq!((&found["whole"], &found["findings"][0]["code"]), (&false.into(), &"E0306".into()));
    assert!(found["files"][0]["head"].as_str().unwrap().len() + found["skeletons"].as_array().unwrap().len() > 1);
    place.run(&["view", "late.nc"]).ends(1).says("W0503");
    let found = header(&place.read("late.nc.html"));
    assert_eq!((&found["whole"], &found["count"]), (&false.into(), &2.into()));
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
        (&["--from", "50"], 50, 0),
    ] {
        place.run(&[&["view", "a.nc"], options].concat()).ends(0);
        let header = header(&place.read("a.nc.html"));
        assert_eq!((&header["from"], &header["count"]), (&from.into(), &count.into()), "{options:?}");
        assert_eq!((&header["blocks"], &header["whole"]), (&11.into(), &true.into()));
    }
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
