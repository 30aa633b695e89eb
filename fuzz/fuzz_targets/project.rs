//! Any bytes as project file; what comes of them must serve a run.

#![no_main]

use std::path::Path;

use cnc872c::config::configure;
use cnc872c::diag::{Findings, Report};
use cnc872c::session::{Part, Session};
use cnc872c::text::{MemoryLoader, Sources};
use cnc872c_fuzz::{Mode, assert_outcome, assert_places, assert_rendered};
use libfuzzer_sys::fuzz_target;

const PROGRAM: &str = "%1 \"T\"\nN1 G0 X0 Y0 Z0 R1=5\nN2 G1 X10.5 YR1 F500 S1000 M3\nN3 G2 X20 I5 J0\nN4 G81 X5 R2=1\n\
                       N5 G80 M41 A90\nN6 G26 R5=1020304 M50\nN7 G71 L1 Q3\nN8 M19 C45\nN9 M30\nN20 G79 L1\n\
                       N21 G91 X1\nN22 G70\n";
const MACROCYCLE: &str = "N1 G79 L9001\nN2 Z-5\nN3 G70\n";

fuzz_target!(|data: &[u8]| {
    let Some((mode, bytes)) = Mode::take(data) else { return };
    let mut overrides = mode.overrides;
    if !mode.with_project {
        overrides.dialect = None;
        overrides.encoding = None;
        overrides.block_skip = None;
        overrides.optional_stop = None;
    }
    let loader = MemoryLoader::new()
        .with("cnc872c.toml", bytes)
        .with("p.nc", PROGRAM)
        .with("L9001", MACROCYCLE)
        .with("channel.xml", "<C><MFunctions><MFunc No=\"50\" GroupNo=\"3\" BreakCont=\"1\"/></MFunctions></C>");
    let (mut sources, mut findings) = (Sources::new(), Findings::new());
    let settings = configure(Some(Path::new("cnc872c.toml")), &overrides, &loader, &mut sources, &mut findings);
    assert_places(&sources, &findings);
    let usable = !findings.has_errors();
    let mut report = Report::new();
    report.add(&sources, findings);
    assert_rendered(&report, &[("cnc872c.toml", bytes.len())]);
    if usable {
        let session = Session { loader: &loader, settings: &settings, progress: None };
        let mut stream = Vec::new();
        let run = session.compile(Path::new("p.nc"), "p.nc", Part::default(), &mut stream).expect("memory");
        let whole = run.whole.is_some();
        let report = assert_outcome(run.outcome, &[("p.nc", PROGRAM.len())]);
        let ended = stream.windows(13).any(|window| window == b"\"kind\":\"end\",");
        assert_eq!(ended, report.errors() == 0);
        assert_eq!(whole, ended);
    }
});
