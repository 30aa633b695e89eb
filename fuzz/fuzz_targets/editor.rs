//! What an editor says to the language server, read from the input: a script, or the bytes of the connection
//! themselves.

#![no_main]

use cnc872c_fuzz::connection::run_raw;
use cnc872c_fuzz::editor::Editor;
use cnc872c_fuzz::script::Script;
use libfuzzer_sys::fuzz_target;

fuzz_target!(|data: &[u8]| {
    match data.split_first() {
        Some((first, bytes)) if first & 0x80 != 0 => run_raw(bytes),
        _ => {
            if let Some(script) = Script::read(data) {
                Editor::run(&script);
            }
        }
    }
});
