//! Buckets of f32 values in their order: what [`scan`](super::scan) counts in.
//!
//! A value's *key* is a whole number that rises with it; a *bucket* is all values whose keys share the top 22 bits.

use super::spread::Sums;
use std::ops::Range;
use tomolith_core::dose::Steps;
use tomolith_core::field::BLOCK;
use tomolith_core::target::label;

/// Low bits of a key that the first pass does not look at.
pub(super) const FINE_BITS: u32 = 10;
pub(super) const FINE: usize = 1 << FINE_BITS;
pub(super) const COARSE: usize = 1 << (32 - FINE_BITS);
/// Threads that get separate tables, at most.
pub(super) const TABLES: usize = 16;
/// Whole numbers in the order of the floats: −0 and +0 are the same.
pub(super) fn key(value: f32) -> u32 {
    let bits = (value + 0.0).to_bits();
    if bits >> 31 == 1 {
        !bits
    } else {
        bits | 1 << 31
    }
}

pub(super) fn value_of(key: u32) -> f32 {
    f32::from_bits(if key >> 31 == 1 {
        key & !(1 << 31)
    } else {
        !key
    })
}

/// Voxels of part and void.
pub(super) type Counts = [u64; 2];

#[derive(Clone, Copy, Debug)]
pub(super) struct Bucket {
    /// Top bits of the keys in it.
    pub(super) top: u32,
    pub(super) counts: Counts,
    /// Voxels in higher buckets.
    pub(super) above: Counts,
}

impl Bucket {
    /// Voxels in this bucket and higher ones.
    pub(super) fn up_from_here(&self) -> Counts {
        [
            self.above[0] + self.counts[0],
            self.above[1] + self.counts[1],
        ]
    }

    pub(super) fn start(&self) -> f64 {
        f64::from(value_of(self.top << FINE_BITS))
    }

    /// The first value of the next bucket: all of this bucket's values lie below.
    pub(super) fn end(&self) -> f64 {
        let last = value_of(self.top << FINE_BITS | (FINE as u32 - 1));
        // The last key below zero is that of −0, which no value has
        f64::from(if last == 0.0 { 0.0 } else { last.next_up() })
    }
}

/// Which of the two counts a label belongs to.
pub(super) fn class(label: u8) -> Option<usize> {
    match label {
        label::PART => Some(0),
        label::VOID => Some(1),
        _ => None,
    }
}

/// Neighboring voxels of one class, as long as they go, with their class.
pub(super) fn runs(labels: &[u8]) -> impl Iterator<Item = (usize, Range<usize>)> {
    let mut end = 0;
    let runs = labels.chunk_by(|a, b| a == b).map(move |run| {
        let begin = end;
        end += run.len();
        (class(run[0]), begin..end)
    });
    runs.filter_map(|(class, run)| Some((class?, run)))
}

/// Whole blocks for each thread.
pub(super) fn shares(len: usize) -> Vec<Range<usize>> {
    let blocks = len.div_ceil(BLOCK);
    let threads = rayon::current_num_threads()
        .clamp(1, TABLES)
        .min(blocks.max(1));
    let cut = |i: usize| (i * blocks / threads * BLOCK).min(len);
    (0..threads).map(|i| cut(i)..cut(i + 1)).collect()
}

/// Buckets of a share, and sums of each of its blocks.
pub(super) type Share = (Vec<[u32; 2]>, Vec<[Sums; 2]>);

/// Counts a share, or some of it when work must stop.
pub(super) fn count_share(labels: &[u8], response: &[f32], blocks: &Steps<'_>) -> Share {
    let mut table = vec![[0u32; 2]; COARSE];
    let sums = labels
        .chunks(BLOCK)
        .zip(response.chunks(BLOCK))
        .take_while(|_| !blocks.is_canceled())
        .map(|(labels, values)| {
            blocks.add(1);
            let mut sums = [Sums::EMPTY; 2];
            for (class, run) in runs(labels) {
                let mut class_sums = sums[class];
                for &value in &values[run] {
                    table[(key(value) >> FINE_BITS) as usize][class] += 1;
                    class_sums.add(value);
                }
                sums[class] = class_sums;
            }
            sums
        })
        .collect();
    (table, sums)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn runs_are_neighbors_of_one_class() {
        use label::{OUTSIDE, PART, VOID};
        let labels = [OUTSIDE, PART, PART, VOID, OUTSIDE, VOID, VOID];
        let found: Vec<_> = runs(&labels).collect();
        assert_eq!(found, [(0, 1..3), (1, 3..4), (1, 5..7)]);
        assert_eq!(runs(&[]).count(), 0);
    }

    #[test]
    fn keys_keep_the_order_of_numbers() {
        let values = [f32::MIN, -1.0, -1e-40, 0.0, 1e-40, 0.5, 1.0, f32::MAX];
        for pair in values.windows(2) {
            assert!(key(pair[0]) < key(pair[1]));
        }
        assert_eq!(key(-0.0), key(0.0));
        for value in values {
            assert_eq!(value_of(key(value)), value);
        }
    }
}
