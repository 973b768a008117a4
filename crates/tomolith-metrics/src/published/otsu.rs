//! Otsu's threshold.
//!
//! **Equation** the threshold that makes the variance between the two classes largest,
//! ω₀·ω₁·(μ₁ − μ₀)², over the edges of 256 equal bins between the smallest and the largest dose; class means are those
//! of the doses themselves. Of several equal maxima the middle is taken. **Source** N. Otsu, IEEE Trans. SMC 9 (1979) 62;
//! used for the Jaccard index of Kelly et al. 2019 (Li et al. 2024, supplement S.8).

use super::super::scan::Scan;
use tomolith_core::field::BLOCK;
use tomolith_core::grid::Volume;
use tomolith_core::parallel::InParallel;
use tomolith_core::target::label;

const BINS: usize = 256;

/// The threshold over part and void voxels; none when all doses are equal.
#[must_use]
pub fn otsu(dose: &Volume<f32>, labels: &Volume<u8>, scan: &Scan<'_>) -> Option<f64> {
    let spreads = || scan.part().into_iter().chain(scan.void());
    let low = spreads().map(|s| f64::from(s.min)).reduce(f64::min)?;
    let high = spreads().map(|s| f64::from(s.max)).reduce(f64::max)?;
    let width = (high - low) / BINS as f64;
    if width.is_nan() || width <= 0.0 {
        return None;
    }
    let bins = histogram(dose, labels, low, width);
    let (n, sum) = bins.iter().fold((0.0, 0.0), |a, b| (a.0 + b.0, a.1 + b.1));
    let mut below = (0.0, 0.0);
    let (mut best, mut edges) = (0.0f64, [0usize; 2]);
    for (edge, bin) in (1..BINS).zip(&bins) {
        below = (below.0 + bin.0, below.1 + bin.1);
        let above = (n - below.0, sum - below.1);
        if below.0 == 0.0 || above.0 == 0.0 {
            continue;
        }
        let variance = below.0 * above.0 * (above.1 / above.0 - below.1 / below.0).powi(2);
        if variance > best * (1.0 + 1e-12) {
            (best, edges) = (variance, [edge, edge]);
        } else if variance >= best * (1.0 - 1e-12) && edges[1] + 1 == edge {
            edges[1] = edge;
        }
    }
    Some(low + width * 0.5 * (edges[0] + edges[1]) as f64)
}

/// Number and sum of the doses of each bin.
fn histogram(dose: &Volume<f32>, labels: &Volume<u8>, low: f64, width: f64) -> Vec<(f64, f64)> {
    let blocks: Vec<Vec<(f64, f64)>> = dose
        .values
        .chunks(BLOCK)
        .zip(labels.values.chunks(BLOCK))
        .par_map(|(dose, labels)| {
            let mut bins = vec![(0.0, 0.0); BINS];
            for (&d, _) in dose
                .iter()
                .zip(labels)
                .filter(|(_, l)| **l == label::PART || **l == label::VOID)
            {
                let d = f64::from(d);
                let bin = &mut bins[(((d - low) / width) as usize).min(BINS - 1)];
                *bin = (bin.0 + 1.0, bin.1 + d);
            }
            bins
        });
    let mut bins = vec![(0.0, 0.0); BINS];
    for block in blocks {
        bins.iter_mut()
            .zip(block)
            .for_each(|(bin, b)| *bin = (bin.0 + b.0, bin.1 + b.1));
    }
    bins
}

#[cfg(test)]
mod tests {
    use super::*;
    use tomolith_core::grid::VolumeGrid;
    use tomolith_core::target::label::{PART, VOID};

    fn threshold(values: &[f32]) -> Option<f64> {
        let grid = VolumeGrid::centered([1, 1, values.len()], 0.1);
        let labels: Vec<u8> = (0..values.len())
            .map(|i| if i % 2 == 0 { PART } else { VOID })
            .collect();
        let scan = Scan::new(&labels, values).unwrap();
        let dose = Volume {
            grid: grid.clone(),
            values: values.to_vec(),
        };
        otsu(
            &dose,
            &Volume {
                grid,
                values: labels.clone(),
            },
            &scan,
        )
    }

    #[test]
    fn two_heaps_are_cut_in_the_middle_of_the_gap() {
        let found = threshold(&[0.1, 0.1, 0.12, 0.9, 0.9, 0.88]).unwrap();
        assert!((found - 0.5).abs() < 0.01, "{found}");
        assert_eq!(threshold(&[0.3, 0.3]), None);
    }

    #[test]
    fn it_is_the_largest_variance_between_classes_of_a_full_search() {
        let values: Vec<f32> = (0..2000)
            .map(|i| ((i * 7919) % 2003) as f32 / 2003.0)
            .map(|u| u * u * u)
            .collect();
        let between = |t: f64| {
            let (low, high): (Vec<f64>, Vec<f64>) =
                values.iter().map(|v| f64::from(*v)).partition(|v| *v <= t);
            let mean = |v: &[f64]| v.iter().sum::<f64>() / v.len() as f64;
            low.len() as f64 * high.len() as f64 * (mean(&high) - mean(&low)).powi(2)
        };
        let found = threshold(&values).unwrap();
        let best = (1..1000)
            .map(|i| between(f64::from(i) / 1000.0))
            .fold(0.0, f64::max);
        assert!(
            between(found) > 0.9999 * best,
            "{found}: {} of {best}",
            between(found)
        );
    }
}
