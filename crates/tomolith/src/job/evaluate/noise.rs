//! Noise that Monte Carlo paths leave in the dose of a resin that scatters.
//!
//! Patterns that were optimized on one set of paths may fit the noise of these paths. They are therefore evaluated by others, sixteen
//! times as many, on smaller cells; here the two views stand side by side, with the noise that is left in the judgment: the root mean square
//! difference of two such sets of paths, over √2, per voxel.

use crate::error::Result;
use crate::grid::{Patterns, Volume};
use crate::job::dose::doses::standing_by;
use crate::job::evaluate::print;
use crate::job::resolve::{ResolvedJob, Voxels};
use crate::metrics::{Measure, iou, pw};
use crate::models::{Family, Purpose, Work};
use crate::target::label;
use serde::Serialize;
use std::fmt;

/// A dose by Monte Carlo paths, on the optimization's voxels, standing still.
#[derive(Clone, Copy, Debug, PartialEq, Serialize)]
pub(crate) struct Noise {
    /// Paths of a pixel in a frame: in the optimization, and in the judgment.
    pub(crate) training_paths: usize,
    /// See `training_paths`.
    pub(crate) evaluation_paths: usize,
    /// IoU on the paths of the optimization.
    pub(crate) training_iou: Measure,
    /// IoU on independent paths.
    pub(crate) independent_iou: Measure,
    /// Process window on the paths of the optimization.
    pub(crate) training_pw: Measure,
    /// Process window on independent paths.
    pub(crate) independent_pw: Measure,
    /// Noise of a voxel of the part in the judgment, over the part's mean response.
    pub(crate) part: f64,
    /// Noise of a voxel of the void, over the part's mean response.
    pub(crate) void: f64,
}

/// A gap of the IoU that is worth a warning.
const WORTH_SAYING: f64 = 0.01;
/// Noise of a voxel that is worth a warning: worst voxels, of which IoU and PW tell, are off by three to four times as much.
const LOUD: f64 = 0.02;
/// Paths of a pixel that a job may ask for.
const MOST_PATHS: f64 = 4096.0;

impl Noise {
    /// Of patterns under a model; None where it draws no paths.
    pub(crate) fn of(
        job: &ResolvedJob,
        voxels: &Voxels,
        patterns: &[Patterns],
        work: &Work,
    ) -> Result<Option<Self>> {
        let family = job.optics.family(&job.grid)?;
        let Some(paths) = family.monte_carlo_paths() else {
            return Ok(None);
        };
        let response = |family: &Family, purpose: Purpose| -> Result<Volume<f32>> {
            let dose = standing_by(Some(family), purpose, job, patterns, work)?;
            Ok(job.first().goal.responses(dose))
        };
        let measures = |response: &Volume<f32>| -> Result<[Measure; 2]> {
            let print = print(job, job.first(), voxels, response, Work::new())?;
            Ok([(iou::KIND.measure)(&print), (pw::KIND.measure)(&print)])
        };
        let [training_iou, training_pw] = measures(&response(&family, Purpose::Probe)?)?;
        let evaluating = Purpose::Evaluate { refine: 1 };
        let first = response(&family, evaluating)?;
        let second = response(&paths.redrawn, evaluating)?;
        let [independent_iou, independent_pw] = measures(&first)?;
        let [part, void] = differences(&first, &second, &voxels.labels);
        Ok(Some(Noise {
            training_paths: paths.optimizing,
            evaluation_paths: paths.evaluating,
            training_iou,
            independent_iou,
            training_pw,
            independent_pw,
            part,
            void,
        }))
    }

    /// The warning when the patterns fit the paths that they were optimized with, or when these are too few to decide.
    pub(crate) fn warning(&self) -> Option<String> {
        let both = [self.misfit(), self.loudness()];
        both.into_iter()
            .flatten()
            .reduce(|a, b| format!("{a}; {b}"))
    }

    fn misfit(&self) -> Option<String> {
        let (training, independent) = (self.training_iou?, self.independent_iou?);
        (training - independent > WORTH_SAYING).then(|| {
            format!(
                "the patterns are fitted to the noise of their {} paths a pixel: IoU {training:.4} on these paths, {independent:.4} on independent ones; \
                 raise model.monte_carlo.paths_per_pixel, or use more frames",
                self.training_paths
            )
        })
    }

    fn loudness(&self) -> Option<String> {
        let noise = self.part.max(self.void);
        (noise > LOUD).then(|| {
            // Noise falls with the root of their number
            let enough = (self.training_paths as f64 * (noise / LOUD).powi(2)).ceil();
            let advice = if enough <= MOST_PATHS {
                format!("about {enough} paths a pixel would bring it to {:.0} %", 100.0 * LOUD)
            } else {
                format!("even {MOST_PATHS} paths a pixel, the largest value, would leave more than {:.0} %", 100.0 * LOUD)
            };
            format!(
                "Monte Carlo paths leave a noise of {:.1} % of the part's mean response in a voxel: IoU, PW and thresholds of this report are \
                 blurred by it; raise model.monte_carlo.paths_per_pixel (now {}; {advice})",
                100.0 * noise, self.training_paths
            )
        })
    }
}

impl fmt::Display for Noise {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let number = |m: Measure| m.map_or_else(|| "–".to_owned(), |m| format!("{m:.4}"));
        write!(
            f,
            "IoU {}, PW {} on the paths of the optimization ({} a pixel); {}, {} on independent ones ({} a pixel, noise of a voxel {:.2} % in the part, {:.2} % in the void)",
            number(self.training_iou),
            number(self.training_pw),
            self.training_paths,
            number(self.independent_iou),
            number(self.independent_pw),
            self.evaluation_paths,
            100.0 * self.part,
            100.0 * self.void
        )
    }
}

/// Noise of one of two equal measurements in part and void, over the part's mean.
fn differences(first: &Volume<f32>, second: &Volume<f32>, labels: &Volume<u8>) -> [f64; 2] {
    let (mut squares, mut counts, mut sum) = ([0.0; 2], [0.0; 2], 0.0);
    for ((&a, &b), &label) in first.values.iter().zip(&second.values).zip(&labels.values) {
        let place = match label {
            label::PART => 0,
            label::VOID => 1,
            _ => continue,
        };
        if place == 0 {
            sum += f64::from(a);
        }
        squares[place] += f64::from(a - b).powi(2);
        counts[place] += 1.0;
    }
    let mean = sum / f64::max(counts[0], 1.0);
    std::array::from_fn(|i| {
        let rms = (squares[i] / f64::max(counts[i], 1.0) / 2.0).sqrt();
        if mean > 0.0 { rms / mean } else { 0.0 }
    })
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::grid::VolumeGrid;

    #[test]
    fn the_noise_of_one_of_two_measurements_is_their_difference_over_root_two() {
        let grid = VolumeGrid::centered([1, 1, 4], 1.0);
        let volume = |values: [f32; 4]| Volume {
            grid: grid.clone(),
            values: values.to_vec(),
        };
        let labels = Volume {
            grid: grid.clone(),
            values: vec![label::PART, label::PART, label::VOID, label::OUTSIDE],
        };
        let [part, void] = differences(
            &volume([1.0, 3.0, 0.5, 9.0]),
            &volume([1.2, 2.8, 0.3, 0.0]),
            &labels,
        );
        assert!((part - 0.2 / 2.0f64.sqrt() / 2.0).abs() < 1e-7);
        assert!((void - 0.2 / 2.0f64.sqrt() / 2.0).abs() < 1e-7);
    }

    #[test]
    fn a_gap_is_said() {
        let noise = |independent: f64| Noise {
            training_paths: 4,
            evaluation_paths: 64,
            training_iou: Some(1.0),
            independent_iou: Some(independent),
            training_pw: Some(0.2),
            independent_pw: Some(0.05),
            part: 0.012,
            void: 0.03,
        };
        tomolith_core::contains!(
            noise(0.77).warning().unwrap(),
            "IoU 1.0000 on these paths, 0.7700"
        );
        // 3 % in the void is too much to decide, and the warning names it too
        let quiet = |independent: f64| Noise {
            void: 0.012,
            ..noise(independent)
        };
        assert_eq!(quiet(0.995).warning(), None);
        assert!(!quiet(0.77).warning().unwrap().contains("leave a noise"));
        let text = noise(0.995).warning().unwrap();
        tomolith_core::contains!(text, "a noise of 3.0 %", "now 4; about 9 paths a pixel");
        tomolith_core::contains!(noise(0.77).warning().unwrap(), "; Monte Carlo paths leave");
        let loud = Noise {
            part: 0.9,
            ..quiet(1.0)
        };
        assert!(loud.warning().unwrap().contains("even 4096 paths"));
        assert!(noise(0.77).to_string().contains("1.20 % in the part"));
    }
}
