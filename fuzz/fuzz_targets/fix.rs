//! Any bytes as program, fixed until no fix is left: that happens, and nothing but the places of the fixes changes.

#![no_main]

use std::path::Path;

use cnc872c::diag::{Code, Fix};
use cnc872c::edit::apply_fixes;
use cnc872c::session::Session;
use cnc872c::text::{FileId, MemoryLoader, SourceText};
use cnc872c_fuzz::{Mode, assert_places};
use libfuzzer_sys::fuzz_target;

const PROGRAM: FileId = FileId(0);

/// Rounds until no fix is left; overlapping fixes wait for the next round. Of blocks with the same number each is
/// offered the next free one, so that all of them together take one round a block.
const MOST_ROUNDS: usize = 50;

fuzz_target!(|data: &[u8]| {
    let Some((mode, bytes)) = Mode::take(data) else { return };
    let mut bytes = bytes.to_vec();
    let (mut rounds, mut most) = (0, MOST_ROUNDS);
    loop {
        let loader = MemoryLoader::new().with("p.nc", bytes.clone());
        let mut mode = mode.clone();
        mode.with_project = false;
        let settings = mode.settings(&loader);
        let outcome = Session { loader: &loader, settings: &settings, progress: None }.check(Path::new("p.nc"), "p.nc");
        assert_places(&outcome.sources, &outcome.findings);
        let mut found: Vec<_> = outcome.findings.items().iter().filter(|item| item.file() == PROGRAM).collect();
        found.sort_by_key(|item| (item.at, item.code()));
        let fixes: Vec<&Fix> = found.iter().filter_map(|item| item.fixes.first()).collect();
        if fixes.is_empty() {
            break;
        }
        let repeated = found.iter().filter(|item| item.code() == Code::E0204).count();
        most = most.max(MOST_ROUNDS + repeated);
        rounds += 1;
        assert!(rounds <= most, "{rounds} rounds: {:?}", fixes.first());
        let source = outcome.sources.get(PROGRAM).expect("the program");
        let fixed = apply_fixes(source, PROGRAM, &bytes, fixes.iter().copied());
        assert!(!fixed.applied.is_empty() && fixed.bytes != bytes, "a fix that does nothing: {:?}", fixes.first());
        assert_untouched(source, &bytes, &fixed.bytes, &fixes);
        bytes = fixed.bytes;
    }
});

/// The text between the places of the fixes is in the result too, in the same order.
fn assert_untouched(source: &SourceText, before: &[u8], after: &[u8], fixes: &[&Fix]) {
    let mut spans: Vec<(usize, usize)> = fixes
        .iter()
        .flat_map(|fix| fix.edits.iter().map(|edit| edit.at.span))
        .map(|span| (source.byte_offset(span.start) as usize, source.byte_offset(span.end) as usize))
        .collect();
    spans.sort_unstable();
    let (mut at, mut rest) = (0, after);
    for (start, end) in spans.into_iter().chain([(before.len(), before.len())]) {
        if let Some(piece) = before.get(at..start).filter(|piece| !piece.is_empty()) {
            let place = rest.windows(piece.len()).position(|window| window == piece).expect("untouched text");
            rest = &rest[place + piece.len()..];
        }
        at = at.max(end);
    }
}
