//! How well a gray target is reproduced: the share of voxels in the band, and errors of the response.
//!
//! With the gray value f of the target and the response m of each voxel that counts, and the half width ε of the band (that of
//! the objective: Li et al., Additive Manufacturing 94 (2024) 104447, eq. 1, ask for |m − f| ≤ ε):
//!
//! ```text
//! in_band         = #{|m − f| ≤ ε} / #            rms_error      = √(Σ (m − f)² / #)
//! max_error_part  = max |m − f| where f ≥ ½       max_error_void = max |m − f| where f < ½
//! ```
//!
//! None of them is defined for a target of part and void; the gel threshold plays no role.
//!
//! ```
//! use tomolith_core::grid::{Volume, VolumeGrid};
//! use tomolith_metrics::{evaluate, print::Print};
//! use tomolith_core::target::label::{PART, VOID};
//! let grid = VolumeGrid::centered([1, 1, 4], 0.1);
//! let volume = |values: [f32; 4]| Volume { grid: grid.clone(), values: values.to_vec() };
//! let (wanted, response) = (volume([0.0, 0.25, 0.5, 1.0]), volume([0.0, 0.5, 0.53, 0.9]));
//! let labels = Volume { grid: grid.clone(), values: vec![VOID, VOID, PART, PART] };
//! let print = Print::new(&labels, &response).unwrap().with_gray(&wanted, 0.05).unwrap();
//! let measures = evaluate(&print).measures;
//! // Errors 0, 0.25, 0.03 and −0.1: two of four are within 0.05
//! assert_eq!(measures.get("in_band"), Some(0.5));
//! assert!((measures.get("rms_error").unwrap() - (0.0734f64 / 4.0).sqrt()).abs() < 1e-6);
//! assert!((measures.get("max_error_part").unwrap() - 0.1).abs() < 1e-6);
//! assert!((measures.get("max_error_void").unwrap() - 0.25).abs() < 1e-6);
//! ```

use super::buckets::class;
use super::{Better, Measure, MetricKind};
use tomolith_core::field::BLOCK;
use tomolith_core::parallel::InParallel;

/// Parts of the half width by which a voxel may leave the band through rounding to f32.
const ROUNDING: f64 = 1e-5;

/// Errors of a gray print, in units of the response.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct GrayErrors {
    /// Share of the voxels in the band.
    pub in_band: f64,
    /// Root of the mean square error.
    pub rms: f64,
    /// Largest error of part voxels (f ≥ ½) and of void voxels; `None` without any.
    pub largest: [Measure; 2],
    /// Σ m²/#, Σ m·f/# and Σ f²/#: what the rms error is at other exposures.
    moments: [f64; 3],
}

impl GrayErrors {
    /// The least rms error over all exposures, and the exposures [low, best, high] over which it is at most `tolerance` larger, 1
    /// being the exposure as it is. For a response that is proportional to the dose: m becomes s·m at an exposure s, and with
    /// A = Σ m²/#, B = Σ m·f/#, C = Σ f²/# the error is √(A·s² − 2·B·s + C). `None` when all is dark.
    pub(super) fn exposures(&self, tolerance: f64) -> Option<(f64, [f64; 3])> {
        let [a, b, c] = self.moments;
        let best = b / a;
        let least = (c - b * best).max(0.0).sqrt();
        let reach = (tolerance * (2.0 * least + tolerance) / a).sqrt();
        (best > 0.0 && reach.is_finite())
            .then(|| (least, [(best - reach).max(0.0), best, best + reach]))
    }
}

#[derive(Clone, Copy, Default)]
struct Sums {
    counts: [u64; 2],
    in_band: u64,
    squares: f64,
    largest: [f64; 2],
    moments: [f64; 3],
}

impl Sums {
    fn of(labels: &[u8], response: &[f32], wanted: &[f32], half_width: f64) -> Self {
        let mut sums = Sums::default();
        for ((&label, &m), &f) in labels.iter().zip(response).zip(wanted) {
            let Some(class) = class(label) else {
                continue;
            };
            let (m, f) = (f64::from(m), f64::from(f));
            let error = (m - f).abs();
            let moments = [m * m, m * f, f * f];
            sums.moments = std::array::from_fn(|i| sums.moments[i] + moments[i]);
            sums.counts[class] += 1;
            sums.in_band += u64::from(error <= half_width * (1.0 + ROUNDING));
            sums.squares += error * error;
            sums.largest[class] = sums.largest[class].max(error);
        }
        sums
    }

    fn join(self, other: &Sums) -> Self {
        let two = |f: &dyn Fn(usize) -> f64| [f(0), f(1)];
        Sums {
            counts: [0, 1].map(|c| self.counts[c] + other.counts[c]),
            in_band: self.in_band + other.in_band,
            squares: self.squares + other.squares,
            largest: two(&|c| self.largest[c].max(other.largest[c])),
            moments: std::array::from_fn(|i| self.moments[i] + other.moments[i]),
        }
    }
}

/// The errors of voxels that count (part and void), `None` when there are none. Labels, responses and gray values of the same voxels.
#[must_use]
pub fn gray_errors(
    labels: &[u8],
    response: &[f32],
    wanted: &[f32],
    half_width: f64,
) -> Option<GrayErrors> {
    let blocks: Vec<Sums> = labels
        .chunks(BLOCK)
        .zip(response.chunks(BLOCK))
        .zip(wanted.chunks(BLOCK))
        .par_map(|((labels, response), wanted)| Sums::of(labels, response, wanted, half_width));
    let sums = blocks.iter().fold(Sums::default(), Sums::join);
    let count = (sums.counts[0] + sums.counts[1]) as f64;
    (count > 0.0).then(|| GrayErrors {
        in_band: sums.in_band as f64 / count,
        rms: (sums.squares / count).sqrt(),
        largest: [0, 1].map(|c| (sums.counts[c] > 0).then_some(sums.largest[c])),
        moments: sums.moments.map(|sum| sum / count),
    })
}

/// Row of [`METRICS`](super::METRICS): the share of voxels in the band.
pub const IN_BAND: MetricKind = MetricKind {
    name: "in_band",
    title: "Voxels in the band",
    summary: "Share of the voxels whose response lies within the objective's band around their gray value.",
    unit: "",
    better: Better::Higher,
    measure: |print| print.gray_errors().map(|errors| errors.in_band),
};

/// Row of [`METRICS`](super::METRICS): the rms error.
pub const RMS: MetricKind = MetricKind::error(
    "response",
    "rms_error",
    "Rms error",
    "Root mean square difference between response and gray value.",
    |print| print.gray_errors().map(|errors| errors.rms),
);

/// Row of [`METRICS`](super::METRICS): the largest error of bright voxels.
pub const MAX_PART: MetricKind = MetricKind::error(
    "response",
    "max_error_part",
    "Largest error, bright",
    "Largest error where the target's gray value is at least ½.",
    |print| print.gray_errors()?.largest[0],
);

/// Row of [`METRICS`](super::METRICS): the largest error of dark voxels.
pub const MAX_VOID: MetricKind = MetricKind::error(
    "response",
    "max_error_void",
    "Largest error, dark",
    "Largest error where the target's gray value is below ½.",
    |print| print.gray_errors()?.largest[1],
);

#[cfg(test)]
mod tests {
    use super::*;
    use tomolith_core::target::label::{OUTSIDE, PART, VOID};

    #[test]
    fn only_voxels_that_count_are_looked_at_and_blocks_join() {
        let n = 2 * BLOCK + 5;
        let labels: Vec<u8> = (0..n).map(|i| [OUTSIDE, VOID, PART][i % 3]).collect();
        let response: Vec<f32> = (0..n).map(|i| [9.0, 0.25, 0.5][i % 3]).collect();
        let errors = gray_errors(&labels, &response, &vec![0.5; n], 0.1).unwrap();
        let [void, part] = [VOID, PART].map(|l| labels.iter().filter(|x| **x == l).count() as f64);
        assert!((errors.in_band - part / (void + part)).abs() < 1e-12);
        assert!((errors.rms - (void * 0.0625 / (void + part)).sqrt()).abs() < 1e-12);
        assert_eq!(errors.largest, [Some(0.0), Some(0.25)]);
        assert_eq!(gray_errors(&[OUTSIDE], &[1.0], &[0.0], 0.1), None);
    }

    #[test]
    fn the_rms_error_at_other_exposures_is_that_of_the_scaled_response() {
        let wanted = [0.0, 0.25, 0.5, 1.0];
        let response = [0.1f32, 0.25, 0.4, 0.8];
        let rms = |s: f64| {
            let scaled = response.map(|m| (f64::from(m) * s) as f32);
            gray_errors(&[PART; 4], &scaled, &wanted, 0.1).unwrap().rms
        };
        let errors = gray_errors(&[PART; 4], &response, &wanted, 0.1).unwrap();
        let (least, [low, best, high]) = errors.exposures(0.01).unwrap();
        assert!(best > 1.1 && (rms(best) - least).abs() < 1e-7);
        assert!(rms(best - 0.01) > least && rms(best + 0.01) > least);
        for end in [low, high] {
            assert!((rms(end) - least - 0.01).abs() < 1e-7, "{end}");
        }
        let dark = gray_errors(&[PART; 4], &[0.0; 4], &wanted, 0.1).unwrap();
        assert_eq!(dark.exposures(0.01), None);
    }

    #[test]
    fn the_edge_of_the_band_belongs_to_it() {
        let errors = |m: f32| gray_errors(&[PART], &[m], &[0.9], 0.05).unwrap();
        assert_eq!((errors(0.95).in_band, errors(0.8501).in_band), (1.0, 1.0));
        assert_eq!((errors(0.9501).in_band, errors(0.8499).in_band), (0.0, 0.0));
        assert_eq!(errors(0.95).largest[1], None);
    }
}
