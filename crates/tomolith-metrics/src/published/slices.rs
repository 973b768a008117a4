//! The same numbers slice by slice: how even a print is along the axis (Pellizzon et al., figure 15).

use super::super::buckets::runs;
use super::{List, Measure};
use serde::Serialize;
use tomolith_core::dose::Work;
use tomolith_core::grid::Volume;
use tomolith_core::parallel::InParallel;

/// Numbers of one slice perpendicular to the axis; not defined without part, or without void.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct Slice {
    /// Height of its center, mm.
    pub z_mm: f64,
    /// Part voxels.
    pub part: usize,
    /// Void voxels.
    pub void: usize,
    /// min in − max out
    pub pw: Measure,
    /// max in − min in
    pub ipdr: Measure,
    /// #{out > min in}/(in + out)
    pub ver: Measure,
    /// `pw` of percentiles.
    pub pw_trimmed: Measure,
    /// `ipdr` of percentiles.
    pub ipdr_trimmed: Measure,
}

/// Every slice, from the lowest z, without those that a run was canceled before; `trim_percent` as in
/// [`Options`](super::Options). All arrays are of the same voxels.
pub(super) fn slices(
    dose: &Volume<f32>,
    labels: &Volume<u8>,
    trim_percent: f64,
    work: &Work,
) -> Vec<Slice> {
    let [_, ny, nx] = dose.grid.shape;
    let size = (nx * ny).max(1);
    let each = |(iz, (values, labels)): (usize, (&[f32], &[u8]))| {
        let [mut part, mut void] = [const { Vec::new() }; 2];
        for (class, work) in runs(labels) {
            let chosen = if class == 0 { &mut part } else { &mut void };
            chosen.extend_from_slice(&values[work]);
        }
        slice(dose.grid.z(iz), &part, &void, trim_percent)
    };
    let slices = dose.values.chunks(size);
    let steps = work.steps(dose.grid.shape[0]);
    let slices = slices
        .zip(labels.values.chunks(size))
        .enumerate()
        .par_map(|slice| {
            steps.add(1);
            (!steps.is_canceled()).then(|| each(slice))
        });
    slices.into_iter().flatten().collect()
}

fn slice(z_mm: f64, part: &[f32], void: &[f32], alpha: f64) -> Slice {
    let least = part.iter().copied().reduce(f32::min);
    let wrong = least.map(|min| void.iter().filter(|d| **d > min).count());
    let [low, high, out] = ends(part, void, 0.0);
    let [low_trimmed, high_trimmed, out_trimmed] = ends(part, void, alpha);
    let less = |a: Measure, b: Measure| Some(a? - b?);
    Slice {
        z_mm,
        part: part.len(),
        void: void.len(),
        pw: less(low, out),
        ipdr: less(high, low),
        ver: wrong.map(|n| n as f64 / (part.len() + void.len()) as f64),
        pw_trimmed: less(low_trimmed, out_trimmed),
        ipdr_trimmed: less(high_trimmed, low_trimmed),
    }
}

/// Percentiles α and 100 − α of the part, 100 − α of the void.
fn ends(part: &[f32], void: &[f32], alpha: f64) -> [Measure; 3] {
    [
        percentile(part, alpha),
        percentile(part, 100.0 - alpha),
        percentile(void, 100.0 - alpha),
    ]
}

/// Linear between order statistics.
fn percentile(values: &[f32], percent: f64) -> Measure {
    let last = values.len().checked_sub(1)?;
    let place = last as f64 * percent / 100.0;
    let (i, share) = (place.floor() as usize, place.fract());
    // From whichever end is nearer: few values lie beyond a trimmed one
    let [low, high] = if 2 * i < last {
        at_rank(values.iter().copied(), i + 1)
    } else {
        let [above, value] = at_rank(values.iter().map(|value| -value), last - i);
        [-value, -above]
    };
    let [low, high] = [low, high].map(f64::from);
    Some(low + share * (high - low))
}

/// Values that are sorted at a time, at least.
const SORTED: usize = 64;

/// The values before and at a rank, 0 = the smallest, which has none before it but itself. There are as many values.
fn at_rank(values: impl Iterator<Item = f32>, rank: usize) -> [f32; 2] {
    let mut smallest: Vec<f32> = Vec::with_capacity(2 * rank + SORTED);
    let mut bound = f32::INFINITY;
    for value in values {
        if smallest.len() <= rank || value < bound {
            if smallest.len() == smallest.capacity() {
                smallest.select_nth_unstable_by(rank, f32::total_cmp);
                smallest.truncate(rank + 1);
                bound = smallest[rank];
            }
            smallest.push(value);
        }
    }
    let (before, &mut value, _) = smallest.select_nth_unstable_by(rank, f32::total_cmp);
    [
        before.iter().copied().reduce(f32::max).unwrap_or(value),
        value,
    ]
}

pub(super) fn worst(list: &mut List, slices: &[Slice]) {
    const FIGURE: &str = "Pellizzon et al. 2025, figure 15";
    let pw = slices.iter().filter_map(|s| s.pw).reduce(f64::min);
    list.add(
        "pw_worst_slice",
        FIGURE,
        "dose",
        pw,
        "smallest min in − max out of a slice",
    );
    let ipdr = slices.iter().filter_map(|s| s.ipdr).reduce(f64::max);
    list.add(
        "ipdr_worst_slice",
        FIGURE,
        "dose",
        ipdr,
        "largest max in − min in of a slice",
    );
    let ver = slices.iter().filter_map(|s| s.ver).reduce(f64::max);
    list.add(
        "ver_worst_slice",
        FIGURE,
        "",
        ver,
        "largest voxel error rate of a slice",
    );
}

#[cfg(test)]
mod tests {
    use super::*;
    use tomolith_core::grid::VolumeGrid;
    use tomolith_core::target::label::{OUTSIDE, PART, VOID};

    #[test]
    fn every_slice_has_its_own_numbers() {
        let grid = VolumeGrid::centered([3, 1, 4], 1.0);
        let labels = vec![
            PART, PART, VOID, VOID, PART, VOID, VOID, OUTSIDE, VOID, VOID, VOID, OUTSIDE,
        ];
        let values = vec![
            0.75, 1.0, 0.25, 0.5, 0.5, 0.75, 0.25, 9.0, 0.0, 0.0, 0.0, 9.0,
        ];
        let dose = Volume::new(grid.clone(), values);
        let found = slices(&dose, &Volume::new(grid, labels), 25.0, &Work::new());
        let numbers = |s: &Slice| (s.z_mm, s.pw, s.ipdr, s.ver);
        assert_eq!(
            numbers(&found[0]),
            (-1.0, Some(0.25), Some(0.25), Some(0.0))
        );
        assert_eq!(
            numbers(&found[1]),
            (0.0, Some(-0.25), Some(0.0), Some(1.0 / 3.0))
        );
        assert_eq!(numbers(&found[2]), (1.0, None, None, None));
        // A quarter of the way in from either end: 0.8125 − 0.4375 and 0.9375 − 0.8125
        assert_eq!(
            (found[0].pw_trimmed, found[0].ipdr_trimmed),
            (Some(0.375), Some(0.125))
        );
    }

    #[test]
    fn percentiles_are_those_of_all_values_in_order() {
        // Many values, some of them equal, more than are sorted at a time
        let values: Vec<f32> = (0..5000)
            .map(|i| (i * 7919 % 1009) as f32 / 7.0 - 50.0)
            .collect();
        for count in [1, 2, 3, 100, 5000] {
            let (values, mut sorted) = (&values[..count], values[..count].to_vec());
            sorted.sort_by(f32::total_cmp);
            for percent in [0.0, 0.025, 3.0, 49.9, 50.0, 60.0, 99.975, 100.0] {
                let place = (count - 1) as f64 * percent / 100.0;
                let at = |i: f64| f64::from(sorted[i as usize]);
                let [low, high] = [at(place.floor()), at(place.ceil())];
                let expected = low + place.fract() * (high - low);
                assert_eq!(
                    percentile(values, percent),
                    Some(expected),
                    "{count} {percent}"
                );
            }
        }
        assert_eq!(percentile(&[], 50.0), None);
    }
}
