//! What the machine has: memory and disk.

use crate::error::{Error, Result};
use std::path::Path;

/// Share of the computer's memory that a run plans with where nobody says how much.
pub const SHARE: f64 = 0.8;

/// Memory that a run may plan with, MB (10⁶ bytes): what the job gives it, or a fixed share of the computer's. It does not depend on what
/// else runs. None where the system does not say how much it has (only Linux does) and the job neither.
#[must_use]
#[expect(
    clippy::cast_possible_truncation,
    clippy::cast_sign_loss,
    reason = "memory is a positive number of megabytes"
)]
pub fn memory_budget_mb(given_gb: Option<f64>) -> Option<u64> {
    let given = given_gb.map(|gb| gb * 1e3);
    let share = || Some(computer_memory_mb()? as f64 * SHARE);
    given.or_else(share).map(|mb| mb as u64)
}

/// Memory of the computer, or of the container it runs in, MB.
fn computer_memory_mb() -> Option<u64> {
    let machine = meminfo_mb("MemTotal:")?;
    let limit = std::fs::read_to_string("/sys/fs/cgroup/memory.max").ok();
    let limit: Option<u64> = limit.and_then(|text| text.trim().parse().ok());
    Some(limit.map_or(machine, |bytes| machine.min(bytes / 1_000_000)))
}

/// Memory that is free now, MB.
#[must_use]
pub fn free_memory_mb() -> Option<u64> {
    meminfo_mb("MemAvailable:")
}

fn meminfo_mb(name: &str) -> Option<u64> {
    let text = std::fs::read_to_string("/proc/meminfo").ok()?;
    let line = text.lines().find(|line| line.starts_with(name))?;
    let kib: u64 = line.split_whitespace().nth(1)?.parse().ok()?;
    Some(kib * 1024 / 1_000_000)
}

/// Free space where `path` is or will be, MB; None where the system does not say.
#[must_use]
pub fn available_disk_mb(path: &Path) -> Option<u64> {
    #[cfg(unix)]
    {
        let absolute = std::path::absolute(path).ok()?;
        let existing = absolute.ancestors().find(|p| p.exists())?;
        let stat = rustix::fs::statvfs(existing).ok()?;
        // Systems without blocks (/proc) hold no files: whoever writes there reports that it fails
        (stat.f_blocks > 0).then(|| stat.f_bavail.saturating_mul(stat.f_frsize) / 1_000_000)
    }
    #[cfg(not(unix))]
    {
        let _ = path;
        None
    }
}

/// Bytes of the files of a folder; 0 where there is none.
pub(crate) fn bytes_in(folder: &Path) -> u64 {
    let entries = std::fs::read_dir(folder).into_iter().flatten().flatten();
    let bytes = entries.filter_map(|entry| entry.metadata().ok());
    bytes.map(|file| file.len()).sum()
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
            compared(what, needed_mb, available_mb),
            accepted,
        )),
        _ => Ok(()),
    }
}

/// The memory or disk that is needed, and what there is.
pub(crate) fn compared(what: &str, needed_mb: u64, available_mb: u64) -> String {
    let available = match available_mb {
        0 => "less than 1".to_owned(),
        mb => mb.to_string(),
    };
    format!("{what}: {needed_mb} MB needed, {available} MB available")
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    #[cfg(target_os = "linux")]
    fn the_machine_says_what_it_has() {
        let all = memory_budget_mb(None).unwrap();
        assert!(all > 10 && all < meminfo_mb("MemTotal:").unwrap());
        // It stays what it is, however much is taken meanwhile
        let taken = vec![1u8; 50_000_000];
        assert_eq!(memory_budget_mb(None), Some(all));
        assert_eq!((memory_budget_mb(Some(1.5)), taken[7]), (Some(1500), 1));
        assert!(available_disk_mb(Path::new("not/there/yet")).unwrap() > 0);
        assert_eq!(available_disk_mb(Path::new("/proc/run")), None);
        let folder = tempfile::tempdir().unwrap();
        std::fs::write(folder.path().join("a"), [0; 70]).unwrap();
        assert_eq!(
            (bytes_in(folder.path()), bytes_in(Path::new("not/there"))),
            (70, 0)
        );
    }

    #[test]
    fn too_much_is_refused_with_the_estimate() {
        require("grid", "memory", 10, Some(10), "").unwrap();
        require("grid", "memory", 10, None, "").unwrap();
        let message = require("grid", "memory", 10, Some(0), "").unwrap_err();
        tomolith_core::contains!(
            message.to_string(),
            "10 MB needed, less than 1 MB available"
        );
        let message = require(
            "grid.pitch_mm",
            "memory for the optimization",
            11,
            Some(10),
            "a larger pitch",
        )
        .unwrap_err()
        .to_string();
        assert_eq!(
            message,
            "grid.pitch_mm: memory for the optimization: 11 MB needed, 10 MB available; accepted: a larger pitch"
        );
    }
}
