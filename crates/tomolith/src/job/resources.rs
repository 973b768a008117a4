//! What the machine has: memory and disk.

use crate::error::{Error, Result};
use std::path::Path;

/// Memory that can still be used, MB (10⁶ bytes); None where the system does not say (only Linux does).
#[must_use]
pub fn available_memory_mb() -> Option<u64> {
    let text = std::fs::read_to_string("/proc/meminfo").ok()?;
    let line = text
        .lines()
        .find(|line| line.starts_with("MemAvailable:"))?;
    let kib: u64 = line.split_whitespace().nth(1)?.parse().ok()?;
    let machine = kib * 1024 / 1_000_000;
    Some(container_memory_mb().map_or(machine, |limit| limit.min(machine)))
}

/// What is left of the limit of the control group, MB. Its file cache does not count: it is given up when needed.
fn container_memory_mb() -> Option<u64> {
    let read = |name: &str| std::fs::read_to_string(format!("/sys/fs/cgroup/{name}")).ok();
    let limit: u64 = read("memory.max")?.trim().parse().ok()?;
    let stat = read("memory.stat")?;
    let used: u64 = stat
        .lines()
        .find_map(|line| line.strip_prefix("anon "))?
        .trim()
        .parse()
        .ok()?;
    Some(limit.saturating_sub(used) / 1_000_000)
}

/// Free space where `path` is or will be, MB; None where the system does not say.
#[must_use]
pub fn available_disk_mb(path: &Path) -> Option<u64> {
    #[cfg(unix)]
    {
        let absolute = std::path::absolute(path).ok()?;
        let existing = absolute.ancestors().find(|p| p.exists())?;
        let stat = rustix::fs::statvfs(existing).ok()?;
        Some(stat.f_bavail.saturating_mul(stat.f_frsize) / 1_000_000)
    }
    #[cfg(not(unix))]
    {
        let _ = path;
        None
    }
}

/// Refuses what the machine cannot hold; `key` is the key of the job that asks for most of it.
///
/// # Errors
/// [`Error::Config`] with the estimate.
pub fn require(
    key: &str,
    what: &str,
    needed_mb: u64,
    available_mb: Option<u64>,
    accepted: &str,
) -> Result<()> {
    match available_mb {
        Some(available_mb) if needed_mb > available_mb => Err(Error::config(
            key,
            format!("{what}: {needed_mb} MB needed, {available_mb} MB available"),
            accepted,
        )),
        _ => Ok(()),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    #[cfg(target_os = "linux")]
    fn the_machine_says_what_it_has() {
        assert!(available_memory_mb().unwrap() > 10);
        assert!(available_disk_mb(Path::new("not/there/yet")).unwrap() > 0);
    }

    #[test]
    fn too_much_is_refused_with_the_estimate() {
        require("grid", "memory", 10, Some(10), "").unwrap();
        require("grid", "memory", 10, None, "").unwrap();
        let message = require(
            "grid.pitch_mm",
            "memory for the optimisation",
            11,
            Some(10),
            "a larger pitch",
        )
        .unwrap_err()
        .to_string();
        assert_eq!(
            message,
            "grid.pitch_mm: memory for the optimisation: 11 MB needed, 10 MB available; accepted: a larger pitch"
        );
    }
}
