//! How long a job will take: the rates of this machine ([`benchmark`](super::benchmark)) times what the job asks for.
//!
//! An optimization that ends before its last iteration takes less.

use crate::job::resolve::extent::{Extent, VECTORS};
use crate::job::run::benchmark::{CallRates, Rates};
use crate::optics::light::Light;
use crate::optimize::levels;
use crate::units::{counted, duration};

/// Seconds that scenarios may take, and share of the memory, before that is worth a warning.
const LONG_S: f64 = 600.0;

const LARGE_MEMORY: f64 = 0.25;

/// Passes over the dose of an iteration, the line search's included.
const PASSES: f64 = 5.0;

/// Forward and adjoint calls in addition to those of the iterations: the start, its dose, the raw patterns' dose.
const OTHER_CALLS: f64 = 4.0;

/// Models of the evaluation: on the job's voxels as optimized and turning, on finer ones turning.
const MODELS: f64 = 3.0;

/// What measuring a thinned copy costs, times so many: on the finer grid the metrics, the published numbers and the surface's file; on
/// the job's own the metrics and files; for each pixel, at the price of a voxel, a PNG, a movie, its check and the arrays.
const MEASURES_PER_FINE_VOXEL: f64 = 0.9;
const MEASURES_PER_VOXEL: f64 = 2.4;

const MEASURES_PER_PIXEL: f64 = 0.8;

/// Measures for each pixel of a machine's canvas: PNG, movie, its check, `frames.npz`.
const MEASURES_PER_CANVAS_PIXEL: f64 = 0.3;

/// What a job asks for.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Demand<'a> {
    pub(crate) extent: &'a Extent,
    /// The most iterations there will be.
    pub(crate) iterations: usize,
    /// Angles at which a frame of the optimization and of the evaluation is averaged.
    pub(crate) sub_angles: [f64; 2],
    /// Whether the optimization does not count the turning, so that the evaluation asks what it costs.
    pub(crate) misses_turning: bool,
    /// Monte Carlo paths of the evaluation for each of the optimization, where light is followed along such.
    pub(crate) monte_carlo_paths: Option<usize>,
    /// Whether patterns are improved on few levels afterwards.
    pub(crate) levels: bool,
    /// Limit of the optimization's time, s.
    pub(crate) wall_s: Option<f64>,
    /// How many times longer than the rates say an iteration takes: what a job does in it beyond models and objectives.
    pub(crate) longer: f64,
}

/// How long it will take, s.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct Cost {
    /// The optimization, when no iteration is saved.
    pub(crate) optimization_s: f64,
    /// Everything else: sampling, evaluation, files.
    pub(crate) rest_s: f64,
}

/// Angles at which a frame is averaged, mean over the frames of all lights.
pub(crate) fn mean_sub_angles(lights: &[Light]) -> f64 {
    let frames = lights.iter().map(|light| light.pixels.frames());
    let angles = lights
        .iter()
        .map(|light| light.pixels.frames() * light.sub_angles);
    angles.sum::<usize>() as f64 / frames.sum::<usize>().max(1) as f64
}

impl Demand<'_> {
    /// Dose calls of the evaluation.
    fn evaluation_s(&self, rates: &Rates) -> f64 {
        let refine = self.extent.refine;
        let CallRates {
            dose,
            updates_per_frame,
            ..
        } = rates.evaluating;
        let updates = updates_per_frame * self.extent.frames as f64;
        // On the job's voxels, too, where these are coarser
        let also = f64::from(u8::from(self.misses_turning && refine > 1));
        if let Some(more) = self.monte_carlo_paths {
            // On the job's voxels raw, written, and twice for the noise; on finer ones, which a path crosses more of
            return more as f64 * (4.0 + also + refine as f64) * dose.seconds(updates);
        }
        // Raw and written on the job's voxels, turning on finer ones
        let [optimizing, turning] = self.sub_angles;
        let tried = self.extent.work(rates.evaluating_refine);
        let calls = (2.0 * optimizing + also * turning) * self.extent.work(1)
            + turning * self.extent.work(refine);
        (3.0 + also) * dose.begin_s + calls / tried * updates * dose.per_update_s
    }

    /// A dose of the evaluation, vial turning: that of a scenario.
    fn turning_s(&self, rates: &Rates) -> f64 {
        let CallRates {
            dose,
            updates_per_frame,
            ..
        } = rates.evaluating;
        let updates = updates_per_frame * self.extent.frames as f64;
        let share =
            self.extent.work(self.extent.refine) / self.extent.work(rates.evaluating_refine);
        dose.begin_s + self.sub_angles[1] * share * updates * dose.per_update_s
    }

    /// What scenarios cost, in words; whether it is much, with a budget of so many MB.
    pub(crate) fn of_scenarios(
        &self,
        rates: &Rates,
        budget_mb: Option<u64>,
    ) -> Option<(String, bool)> {
        let count = self.extent.scenarios;
        if count == 0 {
            return None;
        }
        let extent = &self.extent.of_the_job_alone();
        let alone = Demand { extent, ..*self }.cost(rates);
        let all = self.cost(rates);
        let [seconds, alone_s] = [all, alone].map(|cost| cost.optimization_s + cost.rest_s);
        let [memory_mb, alone_mb] = [self.extent, extent].map(Extent::optimization_mb);
        let more_mb = memory_mb.saturating_sub(alone_mb);
        let text = format!(
            "{}: an iteration computes {} doses in place of one; with them the run takes {} in place of {}, its optimization {memory_mb} MB in place of {alone_mb} MB",
            counted(count, "scenario"),
            count + 1,
            duration(seconds),
            duration(alone_s)
        );
        let is_large =
            budget_mb.is_some_and(|budget| more_mb as f64 > LARGE_MEMORY * budget as f64);
        Some((text, seconds - alone_s > LONG_S || is_large))
    }

    /// The same work where all iterations take so long, s, if that is longer than the rates say.
    pub(crate) fn as_timed(self, rates: &Rates, iterations_s: Option<f64>) -> Self {
        let by_rates = self.iterations as f64 * self.step_s(rates);
        let longer = iterations_s.map_or(1.0, |timed_s| (timed_s / by_rates).max(1.0));
        Demand { longer, ..self }
    }

    /// An iteration, s.
    fn step_s(&self, rates: &Rates) -> f64 {
        let (extent, sub_angles) = (self.extent, self.sub_angles[0]);
        let [_, _, dose_s, adjoint_s] = seconds(&rates.calls, extent.frames as f64);
        let vectors = extent.active_pixels as f64 * rates.vector_s;
        // Finer voxels and more angles are more updates of a call; what begins it, and the pixels, are the same
        let of_levels =
            |all_s: f64, begin_s: f64| begin_s + extent.effort * (all_s - begin_s).max(0.0);
        let step_s = sub_angles
            * (rates.doses_per_step * of_levels(dose_s, rates.calls.dose.begin_s)
                + of_levels(adjoint_s, rates.calls.adjoint.begin_s))
            + extent.effort * PASSES * rates.objective_s
            + (4 * extent.memory + VECTORS) as f64 * vectors;
        self.longer * step_s
    }

    /// Rates times work.
    pub(crate) fn cost(&self, rates: &Rates) -> Cost {
        let Demand {
            extent, iterations, ..
        } = *self;
        let sub_angles = self.sub_angles[0];
        let (voxels, finer) = (extent.grid.len() as f64, extent.refine.pow(3) as f64);
        let frames = extent.frames as f64;
        let [model_s, first_s, dose_s, adjoint_s] = seconds(&rates.calls, frames);
        let [evaluate_s, ..] = seconds(&rates.evaluating, frames);
        let optimization_s = (iterations as f64 * self.step_s(rates))
            .min(self.wall_s.unwrap_or(f64::INFINITY))
            + extent.models() * (OTHER_CALLS * sub_angles * dose_s + first_s + model_s)
            + if self.levels {
                let [doses, adjoints] = levels::CALLS.map(|calls| calls as f64);
                sub_angles * (doses * dose_s + adjoints * adjoint_s)
            } else {
                0.0
            };
        let measuring = rates.measuring;
        let files = extent.pixels as f64 * MEASURES_PER_PIXEL
            + extent.canvas as f64 * MEASURES_PER_CANVAS_PIXEL;
        let measures_s = MEASURES_PER_FINE_VOXEL * measuring.seconds(voxels * finer)
            + MEASURES_PER_VOXEL * measuring.seconds(voxels)
            + files * measuring.mean_s;
        Cost {
            optimization_s,
            rest_s: (MODELS + extent.scenarios as f64) * evaluate_s
                + self.evaluation_s(rates)
                + extent.scenarios as f64 * self.turning_s(rates)
                + measures_s
                // Above all what a target's surface crosses
                + voxels * (finer.powf(2.0 / 3.0) + 1.0) * rates.sampling_s,
        }
    }
}

/// Seconds to make a model, of its first call beyond others, of a dose and of an adjoint.
fn seconds(rates: &CallRates, frames: f64) -> [f64; 4] {
    let updates = rates.updates_per_frame * frames;
    [rates.making, rates.first, rates.dose, rates.adjoint].map(|rate| rate.seconds(updates))
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::job::resolve::extent::tests::extent;
    use crate::job::run::benchmark::{CallRate, MeasuringRate};

    fn rates() -> Rates {
        let rate = |begin_s, per_update_s| CallRate {
            begin_s,
            per_update_s,
        };
        Rates {
            model: String::new(),
            calls: CallRates {
                updates_per_frame: 100.0,
                making: rate(0.25, 1e-4),
                first: rate(0.05, 2e-3),
                dose: rate(0.5, 1e-3),
                adjoint: rate(0.1, 5e-4),
            },
            evaluating: CallRates {
                updates_per_frame: 200.0,
                making: rate(0.5, 1e-3),
                first: rate(7.0, 7.0),
                dose: rate(1.0, 1e-3),
                adjoint: rate(7.0, 7.0),
            },
            doses_per_step: 1.0,
            evaluating_refine: 1,
            objective_s: 0.01,
            vector_s: 1e-5,
            sampling_s: 1e-3,
            measuring: MeasuringRate {
                per_voxel_s: 2e-3,
                per_face_s: 0.0,
                mean_s: 2e-3,
            },
        }
    }

    #[test]
    fn time_is_work_times_rates() {
        let extent = extent();
        let demand = Demand {
            extent: &extent,
            iterations: 7,
            sub_angles: [1.0, 4.0],
            misses_turning: true,
            monte_carlo_paths: None,
            levels: false,
            wall_s: None,
            longer: 1.0,
        };
        let cost = demand.cost(&rates());
        // A dose: 30 frames of 100 updates at 1000/s, and ½ s = 3.5 s; an adjoint: at 2000/s, and 0.1 s. A step: both, 5
        // passes, 44 vectors of 500 pixels. The first dose takes 6.05 s more,
        // and making the model 0.55 s
        let step = 3.5 + 1.6 + 5.0 * 0.01 + 44.0 * 500.0 * 1e-5;
        let expected = 7.0 * step + 4.0 * 3.5 + 6.05 + 0.55;
        tomolith_core::near!(cost.optimization_s, expected, 1e-9);
        // A dose of the evaluation: 30 frames of 200 updates at 1000/s, 6 s, and 1 s to begin with; on the own voxels twice and
        // turning (2 + 4 angles), turning on eight times as many: 4·1 + (6 + 4·8)·6 = 232 s. Making its model takes 6.5 s, three times; 0.9
        // measures of each fine voxel, 2.4 of the own grid's, 0.8 of each pixel; both grids sampled, the finer one at four times the price
        let measures = 1000.0 * (0.9 * 8.0 + 2.4) + 0.8 * 2000.0;
        let rest = 232.0 + measures * 2e-3 + 5.0 * 1000.0 * 1e-3 + 3.0 * 6.5;
        tomolith_core::near!(cost.rest_s, rest, 1e-9);
        // What was timed counts where it is longer
        let timed = |seconds| demand.as_timed(&rates(), Some(seconds)).cost(&rates());
        assert_eq!(timed(1.0), cost);
        let longer = timed(100.0).optimization_s - cost.optimization_s;
        tomolith_core::near!(longer, 100.0 - 7.0 * step, 1e-9);
        // Monte Carlo paths: sixteen times as many, five times on the job's voxels and once on finer ones, worth two
        let paths = Demand {
            monte_carlo_paths: Some(16),
            ..demand
        }
        .cost(&rates());
        assert!((paths.rest_s - rest - (16.0 * 7.0 * 7.0 - 232.0)).abs() < 1e-9);
        // Averaged frames cost as many calls; a limit of the wall time cuts the iterations, not the rest
        let averaged = Demand {
            sub_angles: [3.0, 4.0],
            ..demand
        };
        let more = averaged.cost(&rates()).optimization_s - cost.optimization_s;
        tomolith_core::near!(more, 2.0 * (7.0 * 5.1 + 4.0 * 3.5), 1e-9);
        // Three times the updates: of a dose 3 s, of an adjoint 1.5 s, and the passes over the dose; not what begins a call, nor the pixels
        let finer = Extent {
            effort: 3.0,
            ..extent.clone()
        };
        let finer = Demand {
            extent: &finer,
            ..demand
        }
        .cost(&rates());
        let more = finer.optimization_s - cost.optimization_s;
        tomolith_core::near!(more, 7.0 * 2.0 * (3.0 + 1.5 + 0.05), 1e-9);
        // A scenario: three times the effort and models of the optimization, and of the evaluation two models (6.5 s) and two doses on
        // the finer voxels, at 4 angles of 48 s and 1 s to begin with
        let scenarios = Extent {
            scenarios: 2,
            effort: 3.0,
            fields: 4,
            ..extent.clone()
        };
        let with_scenarios = Demand {
            extent: &scenarios,
            ..demand
        };
        let more = with_scenarios.cost(&rates());
        let begun = 2.0 * (4.0 * 3.5 + 6.05 + 0.55);
        assert!((more.optimization_s - finer.optimization_s - begun).abs() < 1e-9);
        assert!((more.rest_s - rest - 2.0 * (6.5 + 1.0 + 4.0 * 48.0)).abs() < 1e-9);
        let (text, is_much) = with_scenarios.of_scenarios(&rates(), Some(1000)).unwrap();
        assert!(
            text.starts_with("2 scenarios: an iteration computes 3 doses"),
            "{text}"
        );
        let long = Demand {
            iterations: 100,
            ..with_scenarios
        };
        assert!(!is_much && long.of_scenarios(&rates(), None).unwrap().1);
        assert_eq!(demand.of_scenarios(&rates(), None), None);
        let limited = Demand {
            wall_s: Some(1.0),
            ..demand
        }
        .cost(&rates());
        assert_eq!(
            (limited.optimization_s, limited.rest_s),
            (1.0 + 4.0 * 3.5 + 6.05 + 0.55, cost.rest_s)
        );
    }
}
