//! An error stays in its block.

use tree_sitter_cnc872_check::parse;

use crate::words::{Outline, programs, tree};

/// Slips, each put between two words of a block.
const SLIPS: [&str; 20] = [
    " X ",
    " X- ",
    " X1,5 ",
    " X36.  12 ",
    " X- 5 ",
    " X1O0 ",
    " XO ",
    " X1.2.3 ",
    " X=5 ",
    " E5 ",
    " R10 ",
    " R10= ",
    " R1O5 ",
    " (roughing) ",
    " ; roughing",
    " ROUGHING ",
    " # ",
    " ř ",
    " X#1 ",
    " 5 ",
];

/// Whatever is wrong in a block, the other blocks have the words that they had.
#[test]
fn per_block() {
    let mut tried = 0;
    for (name, source, _) in programs(&["samples/ok", "samples/projects"]) {
        let text = source.text();
        if text.len() > 10_000 {
            continue;
        }
        let whole = parse(text);
        let before = tree(whole.root_node(), text);
        for (index, block) in before.blocks.iter().enumerate() {
            // Behind the last word of the block's first line, so that no comment takes it in.
            let line = text[block[0].1.end..].find(['\r', '\n']).map_or(text.len(), |at| block[0].1.end + at);
            let words = block.iter().filter(|(kind, range)| kind != "comment" && range.end <= line);
            let Some(at) = words.map(|(_, range)| range.end).max() else { continue };
            let slip = SLIPS[tried % SLIPS.len()];
            tried += 1;
            let broken = format!("{}{slip}{}", &text[..at], &text[at..]);
            let parsed = parse(&broken);
            assert!(parsed.root_node().has_error(), "{name}, block {index}, {slip}");
            let after = tree(parsed.root_node(), &broken);
            assert_eq!(after.blocks.len(), before.blocks.len(), "{name}, block {index}, {slip}");
            for (other, (after, before)) in after.blocks.iter().zip(&before.blocks).enumerate() {
                let moved = |place: usize| if place > at { place + slip.len() } else { place };
                let expected: Vec<_> =
                    before.iter().map(|(kind, range)| (kind.clone(), moved(range.start)..moved(range.end))).collect();
                assert!(other == index || *after == expected, "{name}, block {index}, {slip}: {after:?}");
            }
        }
    }
    assert!(tried > 500, "only {tried}");
}

/// Any prefix of a program, and any rest of it, has a tree that covers it.
#[test]
fn pieces_of_a_program() {
    let text = "text %1 \"T\nN10 G0 XR1 Y-R2 R3=-R4 R5 -.5 “c” / 12\n  Z1.5\r\n*\n rest \u{1a}\0";
    for (at, _) in text.char_indices() {
        for part in [&text[..at], &text[at..]] {
            assert_eq!(parse(part).root_node().end_byte(), part.len(), "{part}");
        }
    }
    assert_eq!(tree(parse("").root_node(), ""), Outline::default());
}
