//! Any bytes as ChannelConfig.

#![no_main]

use std::path::PathBuf;

use cnc872c::config::configure;
use cnc872c::diag::{Findings, Report};
use cnc872c::dict::Dialect;
use cnc872c::text::{MemoryLoader, Sources};
use cnc872c_fuzz::{Mode, assert_places, assert_rendered};
use libfuzzer_sys::fuzz_target;

fuzz_target!(|data: &[u8]| {
    let Some((mode, bytes)) = Mode::take(data) else { return };
    let mut overrides = mode.overrides;
    overrides.dialect = Some(Dialect::Cnc872);
    overrides.channel_config = Some(PathBuf::from("channel.xml"));
    let loader = MemoryLoader::new().with("channel.xml", bytes);
    let (mut sources, mut findings) = (Sources::new(), Findings::new());
    let settings = configure(None, &overrides, &loader, &mut sources, &mut findings);
    assert_places(&sources, &findings);
    let mut report = Report::new();
    report.add(&sources, findings);
    assert_rendered(&report, &[("channel.xml", bytes.len())]);
    assert!(settings.machine.m_functions.configured().all(|function| function.number <= 100));
});
