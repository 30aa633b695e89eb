//! How fast a file is parsed, and parsed again after an edit in its middle: `cargo run --release --example speed FILE`.

use std::time::Instant;

use tree_sitter::{InputEdit, Parser, Point};

fn main() {
    let path = std::env::args().nth(1).expect("a file");
    let mut text = std::fs::read_to_string(path).expect("a readable file in UTF-8");
    let mut parser = Parser::new();
    parser.set_language(&tree_sitter_cnc872_check::language()).expect("a language that the library knows");

    let start = Instant::now();
    let mut tree = parser.parse(&text, None).expect("a tree");
    let seconds = start.elapsed().as_secs_f64();
    println!("{} bytes in {seconds:.2} s, {:.1} MB/s", text.len(), text.len() as f64 / 1e6 / seconds);

    let at = text[..text.len() / 2].rfind('\n').expect("lines");
    text.insert_str(at, " F7");
    let row = text[..at].matches('\n').count();
    let column = at - text[..at].rfind('\n').map_or(0, |end| end + 1);
    tree.edit(&InputEdit {
        start_byte: at,
        old_end_byte: at,
        new_end_byte: at + 3,
        start_position: Point { row, column },
        old_end_position: Point { row, column },
        new_end_position: Point { row, column: column + 3 },
    });
    let start = Instant::now();
    let again = parser.parse(&text, Some(&tree)).expect("a tree");
    println!("after an edit in its middle: {:.2} ms", start.elapsed().as_secs_f64() * 1e3);
    assert!(!again.root_node().has_error());
}
