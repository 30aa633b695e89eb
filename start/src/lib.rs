//! Whether standard output was closed when the process started (`cnc872c check part.nc >&-`).
//!
//! Before `main` runs, the Rust runtime opens `/dev/null` for each closed standard stream, so that later nothing tells
//! the lost output from one that was thrown away on purpose. The loader of an ELF file calls what stands in
//! `.init_array` before that. The lint `unsafe_code` refuses the attribute for it, which is why this is a package of
//! its own; there is no unsafe operation in it.

use std::fs::symlink_metadata;
use std::sync::atomic::{AtomicBool, Ordering};

static CLOSED: AtomicBool = AtomicBool::new(false);

#[used]
#[cfg_attr(target_os = "linux", link_section = ".init_array")]
static LOOK: extern "C" fn() = look;

extern "C" fn look() {
    let exists = |path| symlink_metadata(path).is_ok();
    CLOSED.store(exists("/proc/self/fd") && !exists("/proc/self/fd/1"), Ordering::Relaxed);
}

/// Whether standard output was closed when the process started. Known on Linux only; elsewhere `false`.
pub fn stdout_was_closed() -> bool {
    CLOSED.load(Ordering::Relaxed)
}
