//! Damaged files for the tests of readers.

use crate::random::SplitMix;
use std::panic::{AssertUnwindSafe, catch_unwind};
use std::time::{Duration, Instant};

/// Lets a test read damaged files for a share of `TOMOLITH_FUZZ_SECONDS` (by default two seconds): how many of them it could read, and how many
/// there were.
///
/// # Panics
/// Where a reader panics, or takes more than five seconds.
pub fn rounds(share: f64, read: impl Fn(&mut SplitMix) -> bool) -> [u64; 2] {
    let seconds = std::env::var("TOMOLITH_FUZZ_SECONDS").ok();
    let seconds = seconds.and_then(|s| s.parse().ok()).unwrap_or(2.0);
    let start = Instant::now();
    let (mut done, mut round) = (0, 0);
    while start.elapsed().as_secs_f64() < share * seconds {
        let begin = Instant::now();
        let result = catch_unwind(AssertUnwindSafe(|| read(&mut SplitMix(round))));
        let is_read = result.unwrap_or_else(|_| panic!("round {round}: the reader panicked"));
        assert!(begin.elapsed() < Duration::from_secs(5), "round {round}");
        done += u64::from(is_read);
        round += 1;
    }
    [done, round]
}

/// A few changes: bytes, cuts, repetitions, and numbers that break careless readers.
pub fn mutate(bytes: &mut Vec<u8>, random: &mut SplitMix) {
    const WORDS: [&[u8]; 22] = [
        b"\xff\xff\xff\xff",
        b"\0\0\0\0",
        b"\xff\xff\xff\x7f",
        b"-1",
        b"99999999999999999999",
        b"nan",
        b"1e999",
        b"0",
        b"\n",
        b"<",
        b"/",
        b"-9223372036854775808",
        b"[",
        b"]",
        b"{",
        b"}",
        b"\"",
        b"'''",
        b"=",
        b".",
        b"-",
        b"\xff",
    ];
    for _ in 0..1 + random.below(4) {
        let at = random.below(bytes.len() + 1);
        match random.below(6) {
            0 if at < bytes.len() => bytes[at] = random.bits() as u8,
            1 if at < bytes.len() => bytes[at] ^= 1 << random.below(8),
            2 => bytes.truncate(at),
            3 => {
                let end = (at + random.below(64)).min(bytes.len());
                let piece = bytes[at..end].to_vec();
                let to = random.below(bytes.len() + 1);
                bytes.splice(to..to, piece);
            }
            4 => {
                let end = (at + random.below(16)).min(bytes.len());
                bytes.drain(at..end);
            }
            _ => {
                let word = WORDS[random.below(WORDS.len())];
                let end = if random.below(2) == 0 {
                    at
                } else {
                    (at + word.len()).min(bytes.len())
                };
                bytes.splice(at..end, word.iter().copied());
            }
        }
    }
}
