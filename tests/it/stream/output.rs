//! What records and streams look like, whatever the program does.

use super::*;

/// Comments of a block: trimmed, in order; those on lines of their own are the next block's; empty ones are left out
/// (BLK-9, LEX-6).
#[test]
fn comments() {
    let found = blocks(
        "%1 \"title\"\n\"before\"\nN10 \"  one\t\" X1 \"\" \"two\" \" \"\n\"three\nN20\n\"řez \\ 'x'\"\nN30 M30 \"end\"\n* \"after\"",
    );
    assert_eq!(column(&found, "comments"), json!([["one", "two"], ["three"], ["řez \\ 'x'", "end"]]));
}

/// Typographic quotes within a comment are text, also at its end when the line ends it (LEX-6, LEX-12).
#[test]
fn quotes_in_comments() {
    let stream = case("%1 \"Díl „A”\nN10 \"„díra”\nN20 \"„b“\" M30 \"").whole();
    assert_eq!(stream.records[0]["title"], "Díl „A”");
    assert_eq!(column(&stream.blocks(), "comments"), json!([["„díra”"], ["„b“"]]));
}

/// Line and column of the `N`, in characters, in any encoding (block-stream.md, LEX-13).
#[test]
fn places() {
    let text = "\u{feff}x\n%1 \"čř\"\r\n  N10 X1 \"žluť\" N20 Y1\r\n\tN30\rN40 \"ž\"X1 n050 N60\n\nN70 M30";
    let shown = |found: Vec<Value>| (column(&found, "line"), column(&found, "column"));
    let expected = (json!([3, 3, 4, 5, 5, 5, 7]), json!([3, 17, 2, 1, 11, 16, 1]));
    assert_eq!(shown(blocks(text)), expected);
    let mut bytes = Vec::new();
    for letter in text.chars().skip(1) {
        bytes.push(if letter.is_ascii() { letter as u8 } else { 0x9f });
    }
    assert_eq!(shown(Case { program: bytes, ..Case::default() }.blocks()), expected);
}

/// Columns of blocks that follow, or go back, within one line that is not ASCII.
#[test]
fn columns_within_a_line() {
    let found = blocks("%1\nN1 \"ž\" N10 M99\"ř\nN20 \"řeřicha\" N30 \"ů\" N40 G73 L30 N50 G73 L20 \"ě\" N60 M30");
    assert_eq!(column(&found, "n"), json!([1, 10, 20, 30, 40, 30, 40, 50, 20, 30, 40, 30, 40, 50, 60]));
    assert_eq!(column(&found, "column"), json!([1, 8, 1, 15, 23, 15, 23, 35, 1, 15, 23, 15, 23, 35, 51]));
    assert_eq!(column(&found, "line"), json!([2, 2, 3, 3, 3, 3, 3, 3, 3, 3, 3, 3, 3, 3, 3]));
}

/// Sizes that a quadratic step anywhere would make unbearable: blocks of one line, calls, jumps, unknown targets,
/// rings.
#[test]
fn large_programs() {
    let of = |count: u32, line: &dyn Fn(u32) -> String| (1..=count).map(line).collect::<String>();
    let one_line = format!("%1 N1 {} N999999 M30", of(20_000, &|n| format!("N{n}0 X1 ")));
    assert_eq!(case(&one_line).whole().end()["blocks"], 20_002);
    let jumps = format!("%1\n{}N9999 M30", of(2000, &|n| format!("N{n} G73 L{n} Q2\n")));
    assert_eq!(case(&jumps).whole().end()["blocks"], 6001);
    let unknown = format!(
        "%1\n{}{}N999999 M30",
        of(5000, &|n| format!("N{n} M05\n")),
        of(20_000, &|n| format!("N{} G73 L{}\n", n + 10_000, 6000 + n % 3000))
    );
    assert_eq!(case(&unknown).run().errors.len(), 10_000);
    let mut macrocycles = case(&format!("%1\n{}N999999 M30", of(6000, &|n| format!("N{n} G72 L{}\n", n % 2000 + 1))));
    for n in 1..=2000 {
        macrocycles = macrocycles.with(&format!("L{n}"), &format!("N1 G79 L{n}\nN2 G70"));
    }
    assert_eq!(macrocycles.whole().end()["blocks"], 18_001);
    let faulty =
        format!("%1\n{}N99999 M30", of(50_000, &|n| format!("N{n} {}\n", if n % 9973 == 0 { "T-1" } else { "X1" })));
    assert_eq!(case(&faulty).run().errors.len(), 5);
    let mut ring = case("%1\nN1 G72 L1\nN2 M30");
    for n in 1..=2000 {
        ring = ring.with(&format!("L{n}"), &format!("N1 G79 L{n}\nN2 G72 L{}\nN3 G72 L1\nN4 G70", n % 2000 + 1));
    }
    // Each call is one of the ring, and the ring is deeper than calls may be.
    assert_eq!(ring.run().errors.len(), 2002);
}

/// Block skip, on and off (BLK-6).
#[test]
fn block_skip() {
    let program = "%1\nN10 / X1\nN20 R1=1\nN30 /1 G73 L20 Q5\nN40 R1=2 / \nN50 M30";
    let stream = case(program).whole();
    assert_fields(&stream.records[0], &json!({"block_skip": null}));
    assert_eq!(stream.blocks().len(), 15);
    assert_fields(&stream.blocks()[0], &json!({"skippable": true, "first_block": true}));
    assert_fields(&stream.blocks()[1], &json!({"skippable": null}));
    let stream = case(program).args("--block-skip").whole();
    assert_fields(&stream.records[0], &json!({"block_skip": true}));
    let found = stream.blocks();
    assert_eq!(column(&found, "n"), json!([20, 50]));
    assert_eq!(column(&found, "seq"), json!([0, 1]));
    assert_fields(&found[0], &json!({"first_block": true, "last_block": null, "position": null}));
    assert_fields(&stream.end(), &json!({"blocks": 2}));
}

/// A skipped block is not executed, as the target of a jump neither: execution goes on behind it (BLK-6, FLW-3).
#[test]
fn jump_to_a_skipped_block() {
    let found = case("%1\nN10 G73 L30\nN20 M99\nN30 / M98\nN40 M30").args("--block-skip").blocks();
    assert_eq!(column(&found, "n"), json!([10, 40]));
    assert_eq!(found[0]["jump"], json!({"to": 30}));
}

/// `--from` and `--limit` write a part of the block records; everything else is as in the whole stream.
#[test]
fn parts() {
    let program = "%1\nN10 X0\nN20 G72 L7 Q2\nN30 X5\nN40 M30";
    let of = |from, limit| {
        let part = Part { from, limit };
        Case { part, ..case(program).with("L7", "N1 G79 L7\nN2 G91 X1\nN3 G90 G70") }.whole()
    };
    let all = of(0, None);
    assert_eq!(all.blocks().len(), 10);
    for (from, limit) in
        [(0, Some(0)), (0, Some(3)), (4, None), (4, Some(2)), (9, Some(u64::MAX)), (20, Some(1)), (u64::MAX, None)]
    {
        let part = of(from, limit);
        let wanted: Vec<Value> = all
            .records
            .iter()
            .filter(|record| {
                record["kind"] != "block" || {
                    let seq = record["seq"].as_u64().unwrap();
                    seq >= from && limit.is_none_or(|limit| seq - from < limit)
                }
            })
            .cloned()
            .collect();
        assert_eq!(part.records, wanted, "{from} {limit:?}");
    }
    assert_fields(&all.end(), &json!({"blocks": 10, "path_mm": 5, "path_mm_by_type": {"rapid": 5}}));
}

/// With a limit of k records, k are written, and there is no end (FLW-9, §13 Checking).
#[test]
fn record_limit() {
    let program = "%1\nN10 X0\nN20 G73 L10 Q9999\nN30 G73 L10 Q9999\nN40 M30";
    let stream = case(program).args("--max-blocks=5").run();
    assert_eq!(stream.errors, ["E0410"]);
    assert_eq!(column(&stream.blocks(), "seq"), json!([0, 1, 2, 3, 4]));
    assert_eq!(stream.end()["kind"], "block");
    assert_eq!(case("%1\nN10 X0\nN20\nN30 M30").args("--max-blocks=3").whole().blocks().len(), 3);
}

/// After an error there is no end record, and no record of the block with the error (block-stream.md).
#[test]
fn errors_end_the_stream() {
    let stream = case("%1\nN10 R1=1\nN20 G26 R5=04010203 R2=0\nN30 XR3\nN40 M30").config(OPERATIONS).run();
    assert_eq!(stream.errors[0], "E0509");
    assert!(stream.records.iter().all(|record| record["kind"] != "end"));
    let stream = case("%1\nN10 X0\nN20 XR1\nN30 M30").run();
    assert_eq!(stream.errors, ["W0503"]);
    assert_eq!(stream.blocks().len(), 1);
    assert!(stream.records.iter().all(|record| record["kind"] != "end"));
    // The block with the error is no record, nor is any after it, though execution goes on.
    let stream = case("%1\nN10 G0 X0\nN20 X1 K5\nN30 X2\nN40 M30").run();
    assert_eq!(stream.errors, ["E0609"]);
    assert_eq!(stream.blocks().len(), 1);
    assert!(stream.records.iter().all(|record| record["kind"] != "end"));
    let stream = case("%1\nN10 XR1 R2=R1\nN20 YR2\nN30 M30").args("--param R1=-2.5").whole();
    assert_eq!(stream.blocks()[1]["position"], json!({"X": -2.5, "Y": -2.5}));
}

/// How numbers are written: no exponent, no negative zero, no trailing zeros (block-stream.md).
#[test]
fn number_formats() {
    let stream = case(
        "%1\nN10 X-0 Y+0.10 Z-0.000 A-.001 F1.50\nN20 G02 X-0.002 Y0.1 I-0.001\nN30 X0 Y0.1 I0.001 J-0\nN40 R1=-0\nN45 G00 R2=R1 R3=-R1 X-R1\n\
         N50 G00 X69999.999 U-69999.999\nN60 M30",
    )
    .run();
    assert_eq!(stream.errors, Vec::<String>::new());
    assert!(!stream.text.contains("-0,") && !stream.text.contains("-0}"), "{}", stream.text);
    assert!(stream.text.contains(r#""position":{"X":0,"Y":0.1,"Z":0,"A":-0.001}"#), "{}", stream.text);
    assert!(stream.text.contains(r#""feed":1.5,"#));
    let blocks = stream.text.split_once('\n').expect("a first line").1.to_lowercase();
    assert!(!blocks.contains("e-"), "{blocks}");
}

/// Sums are taken over the lengths as written (§13 More), by motion type.
#[test]
fn path_sums() {
    let stream = case(
        "%1\nN5 F100\nN10 X0 Y0\nN40 G91 G01 X1 Y1\nN50 G73 L40 Q2\nN60 G03 X10 Y10 J10\nN70 G33 X0.5\nN80 G00 A5\nN90 M30",
    )
    .whole();
    assert_fields(
        &stream.end(),
        &json!({"path_mm": 20.450_605, "path_mm_by_type": {"linear": 4.242_642, "arc_ccw": 15.707_963, "thread": 0.5}}),
    );
}

/// The same bytes for the same input (block-stream.md).
#[test]
fn deterministic() {
    let program = case("%1\nN10 X0 Y0 F10 R9=1 R2=3 R44=5\nN20 G03 X10 Y10 J10 M06\nN30 G72 L1\nN40 M30")
        .config(GEARS)
        .with("L1", "N1 G79 L1\nN2 G70");
    assert_eq!(program.run().text, program.run().text);
}

/// A block of words that the language has, each address once, with values that may or may not fit.
fn any_block() -> impl Strategy<Value = String> {
    let path = "((G0[01] )?(X-?[0-9]{1,2}(\\.5)? )?(Y-?[0-9]{1,2} )?(Z[0-9] )?(A-?[0-9]{1,3} )?|XR[1-5] )";
    let arc = "(G0[23] X1 Y1 I1 |G02 I[1-9] |G03 X4 Y-?2 Z1 I2 J-?1 |G91 G03 X0 Y0 J3 |G19 G02 X0 Z2 J1 )";
    let table = "(G92 G54 X[1-9] |G93 X5 Y-?2 |G3[1-9] Z2 |G30 X0 |G33 Z[1-9] K1 |G23 I[1-4] )";
    let first = prop_oneof![6 => path, 2 => arc, 1 => table];
    let modal = prop_oneof![
        4 => Just(String::new()),
        1 => "(G9[01]|G7[45]|G24|G09|G10|G8[0-3]|G5[3489]|G34|G9[4567]|G1[789])",
    ];
    let flow = prop_oneof![
        8 => Just(String::new()),
        1 => "( G04 Q[0-9]| G71 L100( Q2)?| G72 L9| G73 L[1-6]0( Q[1-3])?)",
    ];
    let rest =
        "( M0[03-9]| M19| M4[0-4])?( F100)?( T5)?( D[1-3])?( &1000)?( R[1-3]=-?[0-9](\\.[0-9]{3})?)?( R4=R[123])?( /)?";
    (first, modal, flow, rest).prop_map(|(first, modal, flow, rest)| format!("{first}{modal}{flow}{rest}"))
}

proptest! {
    #![proptest_config(ProptestConfig { cases: 200, failure_persistence: None, ..ProptestConfig::default() })]

    /// Whatever the blocks: no panic; records of the schema, counted without a gap, of known positions that follow from
    /// one another; an end exactly when there is no error (block-stream.md).
    #[test]
    fn any_program(lines in proptest::collection::vec(any_block(), 6..14), sub in any_block(), cycle in any_block()) {
        let mut text = "%1 N1 F10 S10 R1=1 R2=2 R3=3 R4=4 R5=5".to_owned();
        for (line, n) in lines.iter().zip(1..) {
            text += &format!("\nN{n}0 {line}");
        }
        text += &format!("\nN999 M30\nN1000 G79 L100\nN1010 {sub}\nN1020 G70");
        let stream = case(&text)
            .config(&format!("{OPERATIONS}{CYCLES}"))
            .args("--max-blocks=300")
            .with("L9", &format!("N1 G79 L9\nN2 {sub}\nN3 G70"))
            .with("L8100", &format!("N1 G79 L8100\nN10 {cycle}\nN20 G70"))
            .with("L8200", "N1 G79 L8200\nN2 G91 Z1\nN3 G70")
            .run();
        let found = stream.blocks();
        for (block, seq) in found.iter().zip(0_u64..) {
            prop_assert_eq!(&block["seq"], seq);
        }
        let ended = stream.records.last().is_some_and(|record| record["kind"] == "end");
        prop_assert_eq!(ended, stream.errors.is_empty() && !stream.records.is_empty());
        for pair in found.windows(2) {
            let (before, after) = (&pair[0], &pair[1]);
            let moved: Vec<&str> =
                after["motion"]["axes"].as_array().into_iter().flatten().filter_map(Value::as_str).collect();
            for letter in ["X", "Y", "Z", "A", "U"] {
                let set = moved.contains(&letter) || after["data"]["g"] == 93 || after["change_pos"] == true || after["words"].get(letter).is_some();
                if !set {
                    prop_assert_eq!(&before["position"][letter], &after["position"][letter]);
                }
            }
            if let Some(sweep) = after["motion"]["sweep_deg"].as_f64() {
                prop_assert!(sweep > 0.0 && sweep <= 360.0);
            }
        }
        let negative_zero = [":-0,", ":-0}"].iter().any(|zero| stream.text.contains(zero));
        prop_assert!(!negative_zero);
    }
}
