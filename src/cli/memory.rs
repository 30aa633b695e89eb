//! How much memory there is to be had.

use std::fs::read_to_string;

/// A picture takes no more, in bytes.
const MOST: u64 = 2 << 30;

/// The bytes that a picture may take: what this process may still have, and no more than 2 GB.
pub(super) fn room() -> usize {
    let room = [address_space(), free()].into_iter().flatten().min().unwrap_or(MOST).min(MOST);
    usize::try_from(room).unwrap_or(usize::MAX)
}

/// What `ulimit -v` leaves; packing takes a part of it.
#[expect(clippy::disallowed_methods, reason = "the kernel tells it by files")]
fn address_space() -> Option<u64> {
    let limits = read_to_string("/proc/self/limits").ok()?;
    let limit: u64 = field(&limits, "Max address space")?.parse().ok()?;
    let used = kilobytes(&read_to_string("/proc/self/status").ok()?, "VmSize:")?;
    Some(limit.saturating_sub(used) / 2)
}

/// The memory that the machine has left.
#[expect(clippy::disallowed_methods, reason = "the kernel tells it by files")]
fn free() -> Option<u64> {
    Some(kilobytes(&read_to_string("/proc/meminfo").ok()?, "MemAvailable:")? / 10 * 9)
}

/// The first word behind a name at the start of a line.
fn field<'t>(text: &'t str, name: &str) -> Option<&'t str> {
    text.lines().find_map(|line| line.strip_prefix(name)).and_then(|rest| rest.split_whitespace().next())
}

fn kilobytes(text: &str, name: &str) -> Option<u64> {
    Some(field(text, name)?.parse::<u64>().ok()? * 1024)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn fields_of_the_kernel() {
        let limits = "Max processes    7823  7823  processes\nMax address space         1024000   unlimited   bytes\n";
        assert_eq!(field(limits, "Max address space"), Some("1024000"));
        assert_eq!(kilobytes("MemTotal: 9 kB\nMemAvailable:   12 kB\n", "MemAvailable:"), Some(12 * 1024));
        assert!(room() > 0 && room() <= 2 << 30);
    }
}
