//! Order statistics without sorting: two passes of counting, exact.

use super::super::buckets::{key, value_of};
use super::super::scan::Scan;
use crate::field::BLOCK;
use crate::grid::Volume;
use crate::target::label;
use rayon::prelude::*;

/// Bits of a key that one pass resolves.
const BITS: u32 = 16;
const TABLE: usize = 1 << BITS;

/// Percentile α and 100 − α of the part, and 100 − α of the void; linear between order statistics.
pub(super) fn percentiles(
    scan: &Scan<'_>,
    labels: &Volume<u8>,
    dose: &Volume<f32>,
    alpha: f64,
) -> [Option<f64>; 3] {
    let totals = scan.totals();
    let rows = [
        (label::PART, totals[0], alpha),
        (label::PART, totals[0], 100.0 - alpha),
        (label::VOID, totals[1], 100.0 - alpha),
    ];
    rows.map(|(wanted, n, percent)| percentile(&labels.values, &dose.values, wanted, n, percent))
}

/// The percentile of the `n` values of a label; none when there are none.
fn percentile(labels: &[u8], values: &[f32], wanted: u8, n: u64, percent: f64) -> Option<f64> {
    let last = n.checked_sub(1)?;
    let place = last as f64 * percent / 100.0;
    let (below, share) = (place.floor(), place.fract());
    let low = value_at(labels, values, wanted, below as u64);
    if share == 0.0 {
        return Some(low);
    }
    let high = value_at(labels, values, wanted, (below as u64 + 1).min(last));
    Some(low + share * (high - low))
}

/// The value of a rank, 0 = the smallest, among those of a label.
fn value_at(labels: &[u8], values: &[f32], wanted: u8, rank: u64) -> f64 {
    let tops = counts(labels, values, wanted, |key| Some(key >> BITS));
    let (top, rest) = find(&tops, rank);
    let lows = counts(labels, values, wanted, |key| {
        (key >> BITS == top).then_some(key & (TABLE as u32 - 1))
    });
    let (low, _) = find(&lows, rest);
    f64::from(value_of(top << BITS | low))
}

/// The cell that a rank falls into, and its rank within.
fn find(counts: &[u64], mut rank: u64) -> (u32, u64) {
    for (cell, &count) in counts.iter().enumerate() {
        if rank < count {
            return (cell as u32, rank);
        }
        rank -= count;
    }
    (counts.len() as u32 - 1, 0)
}

fn counts(
    labels: &[u8],
    values: &[f32],
    wanted: u8,
    cell: impl Fn(u32) -> Option<u32> + Sync,
) -> Vec<u64> {
    let share = values
        .len()
        .div_ceil(rayon::current_num_threads().max(1))
        .max(BLOCK);
    let tables: Vec<Vec<u64>> = labels
        .par_chunks(share)
        .zip(values.par_chunks(share))
        .map(|(labels, values)| {
            let mut table = vec![0u64; TABLE];
            for (_, &value) in labels.iter().zip(values).filter(|(l, _)| **l == wanted) {
                if let Some(cell) = cell(key(value)) {
                    table[cell as usize] += 1;
                }
            }
            table
        })
        .collect();
    let mut sum = vec![0u64; TABLE];
    for table in tables {
        sum.iter_mut().zip(table).for_each(|(sum, n)| *sum += n);
    }
    sum
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::target::label::{PART, VOID};

    #[test]
    fn percentiles_are_those_of_a_sorted_list() {
        for n in [1usize, 2, 3, 10, 997] {
            let values: Vec<f32> = (0..n)
                .map(|i| ((i * 7919) % 1009) as f32 * 0.013 - 3.0)
                .collect();
            let labels: Vec<u8> = (0..n)
                .map(|i| if i % 3 == 2 { VOID } else { PART })
                .collect();
            let mut sorted: Vec<f64> = values
                .iter()
                .zip(&labels)
                .filter(|(_, l)| **l == PART)
                .map(|(v, _)| f64::from(*v))
                .collect();
            sorted.sort_by(f64::total_cmp);
            for percent in [0.0, 0.025, 1.0, 37.5, 50.0, 99.0, 100.0] {
                let place = (sorted.len() - 1) as f64 * percent / 100.0;
                let (i, share) = (place.floor() as usize, place.fract());
                let next = sorted[(i + 1).min(sorted.len() - 1)];
                let expected = sorted[i] + share * (next - sorted[i]);
                let found =
                    percentile(&labels, &values, PART, sorted.len() as u64, percent).unwrap();
                assert!(
                    (found - expected).abs() < 1e-12,
                    "{n} values, {percent} %: {found} {expected}"
                );
            }
        }
        assert_eq!(percentile(&[VOID], &[1.0], PART, 0, 50.0), None);
    }
}
