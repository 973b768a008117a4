//! What a run and a check tell at their end.

use crate::job::evaluate::SpeciesPrint;
use crate::job::evaluate::in_time::{InTime, TimeSummary};
pub use crate::job::evaluate::limits::Fall;
use crate::job::optimize::Optimized;
use crate::job::output::files::{Done, Headline};
use crate::job::output::folder::Leaves;
use crate::job::resolve::{ResolvedJob, Species};
use crate::metrics::{Evaluation, Measure};
use crate::objective::FoundWindow;
use crate::optimize::{Gap, KeptBy, KeptIterate, Outcome, StopReason};
use crate::report::{
    ExposureWindow, OneExposure, OneMoment, PrintLimits, ScenarioTable, gap_sentence, time_sentence,
};
use crate::units::{concise, counted, duration};
use serde::Serialize;
use std::fmt;
use std::path::{Path, PathBuf};
use std::time::Instant;

/// The headline numbers of a print.
#[derive(Clone, Copy, Debug, PartialEq, Serialize)]
pub struct Quality {
    /// Intersection over union at the threshold.
    pub iou: Measure,
    /// Voxel error rate.
    pub ver: Measure,
    /// Process window: least dose of the part − largest of the void.
    pub pw: Measure,
    /// The threshold.
    pub threshold: Measure,
    /// How well gray values are reproduced; None for a target of part and void.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub gray: Option<GrayQuality>,
}

/// The headline numbers of a gray print, in units of the response.
#[derive(Clone, Copy, Debug, PartialEq, Serialize)]
pub struct GrayQuality {
    /// Half width of the band.
    pub half_width: f64,
    /// Share of the voxels in the band.
    pub in_band: Measure,
    /// Root of the mean square error.
    pub rms_error: Measure,
    /// Largest error where the gray value of the target is at least ½.
    pub max_error_part: Measure,
    /// Largest error where it is less.
    pub max_error_void: Measure,
}

impl Quality {
    /// Names of the numbers for people, and the numbers.
    fn columns(&self) -> ([String; 4], [Measure; 4]) {
        match &self.gray {
            None => (
                ["IoU", "VER", "PW", "threshold"].map(str::to_owned),
                [self.iou, self.ver, self.pw, self.threshold],
            ),
            Some(g) => (
                [
                    format!("in ±{}", g.half_width),
                    "rms error".to_owned(),
                    "max bright".to_owned(),
                    "max dark".to_owned(),
                ],
                [g.in_band, g.rms_error, g.max_error_part, g.max_error_void],
            ),
        }
    }
}

/// One of several species.
#[derive(Clone, Debug, Serialize)]
pub struct SpeciesSummary {
    /// Its name.
    pub name: String,
    /// The written patterns while the vial turns, on the finer grid, at its own best threshold.
    pub evaluation: Quality,
    /// Over which exposures it is nearly as good as at the best one of this species; None where this is unknown.
    pub exposure: Option<ExposureWindow>,
    /// What limits it.
    pub limits: PrintLimits,
}

/// The end of a run.
#[derive(Clone, Debug, Serialize)]
pub struct Summary {
    /// The run folder.
    pub folder: PathBuf,
    /// Its file to read first.
    #[serde(skip)]
    pub report: &'static str,
    /// Iterations done; None for a simulation.
    pub iterations: Option<usize>,
    /// Reason why the optimization ended; None for a simulation.
    pub stopped: Option<StopReason>,
    /// Why there are more iterations than `stop.iterations`; None where there are not.
    #[serde(skip)]
    pub beyond: Option<String>,
    /// How the loss fell in the end; None for a simulation, and where the loss is not what the method lowers.
    pub fall: Option<Fall>,
    /// Which iterate the patterns are; None for a simulation.
    pub kept: Option<KeptIterate>,
    /// How far their loss is from the lowest; None for a simulation, and where that is not known.
    pub gap: Option<Gap>,
    /// The process window that the optimization reached, before the patterns are written; None where no objective looks for it.
    pub found_window: Option<FoundWindow>,
    /// Parameters of the response that were found with the patterns, in words.
    pub found_response: Option<String>,
    /// The written patterns while the vial turns, on the finer grid: the headline.
    pub evaluation: Quality,
    /// The unquantized patterns on the optimization grid; None for a simulation of patterns that are quantized only.
    pub optimization: Option<Quality>,
    /// Over which exposures the print is nearly as good as at the best one; None where this is unknown.
    pub exposure: Option<ExposureWindow>,
    /// Every species where a job names several, the first being that of the numbers above; else empty.
    pub species: Vec<SpeciesSummary>,
    /// All species at one exposure, where there are several.
    pub one_exposure: Option<OneExposure>,
    /// The print in time, per network; empty without a schedule.
    pub in_time: Vec<TimeSummary>,
    /// All networks at one time, where there are several.
    pub one_moment: Option<OneMoment>,
    /// The same patterns in the job's scenarios; None where it has none.
    pub scenarios: Option<ScenarioTable>,
    /// How long the print takes, in a sentence; None where nothing prints, and for gray targets.
    pub print_time: Option<String>,
    /// What limits the print; of the first of several species.
    pub limits: PrintLimits,
    /// The required IoU.
    pub required_iou: Option<f64>,
    /// The required share of voxels in their bands.
    pub required_in_band: Option<f64>,
    /// Voxels [x, y, z] of `evaluation`.
    pub evaluation_voxels: [usize; 3],
    /// Their edge, mm.
    pub evaluation_pitch_mm: f64,
    /// How many times finer they are than the job's; 1 for the job's own.
    pub refine: usize,
    /// At how many angles of each frame the patterns were evaluated; `report.json` has it with the evaluation.
    #[serde(skip)]
    pub sub_angles: usize,
    /// Seconds in all.
    pub seconds: f64,
}

impl Summary {
    /// Whether the required quality was met, by every species.
    #[must_use]
    pub fn is_met(&self) -> bool {
        self.required().all(|(.., missed)| missed.is_none())
    }

    /// What is required: key, number, and what falls short of it, if anything does.
    fn required(&self) -> impl Iterator<Item = (&'static str, f64, Option<String>)> {
        type Of = fn(&Quality) -> Measure;
        let iou: Of = |quality| quality.iou;
        let in_band: Of = |quality| quality.gray.as_ref().and_then(|gray| gray.in_band);
        let all = [
            ("require_iou", self.required_iou, iou),
            ("require_in_band", self.required_in_band, in_band),
        ];
        all.into_iter().filter_map(|(key, asked, measure_of)| {
            let asked = asked?;
            let mut prints: Vec<(&str, &Quality)> = (self.species.iter())
                .map(|species| (species.name.as_str(), &species.evaluation))
                .collect();
            if prints.is_empty() {
                prints.push(("", &self.evaluation));
            }
            let missed = prints.into_iter().find_map(|(name, quality)| {
                let found = measure_of(quality);
                let text = || found.map_or("–".to_owned(), |found| format!("{found:.4}"));
                let is_reached = found.is_some_and(|found| found >= asked);
                (!is_reached).then(|| format!("{name} {}", text()).trim().to_owned())
            });
            Some((key, asked, missed))
        })
    }

    /// What limits the print, in one sentence for every species.
    fn all_limits(&self) -> Vec<String> {
        let sentence_of = |species: &SpeciesSummary| {
            let text = &species.limits.sentence;
            (!text.is_empty()).then(|| format!("{}: {text}", species.name))
        };
        match self.species.is_empty() {
            true => Some(self.limits.sentence.clone())
                .filter(|text| !text.is_empty())
                .into_iter()
                .collect(),
            false => self.species.iter().filter_map(sentence_of).collect(),
        }
    }

    /// Sentences about the exposure: one where there is one exposure, else one of each species.
    fn exposures(&self) -> Vec<String> {
        if let Some(one) = &self.one_exposure {
            return vec![one.sentence()];
        }
        let sentence_of = |species: &SpeciesSummary| {
            let window = species.exposure.as_ref()?;
            Some(format!("{}: {}", species.name, window.sentence()))
        };
        match self.species.len() {
            0 | 1 => self.exposure.iter().map(ExposureWindow::sentence).collect(),
            _ => self.species.iter().filter_map(sentence_of).collect(),
        }
    }
}

impl fmt::Display for Summary {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        if let (Some(iterations), Some(reason)) = (self.iterations, self.stopped) {
            let fall = self.fall.filter(|_| reason.is_a_limit());
            let fall = fall.map_or_else(String::new, |fall| format!("; {fall}"));
            let reason = self
                .beyond
                .clone()
                .unwrap_or_else(|| words(reason).to_owned());
            writeln!(f, "{:>28} {iterations} ({reason}{fall})", "iterations")?;
            if let Some(iterate) = self.kept.filter(|iterate| iterate.iteration != iterations) {
                writeln!(f, "{:>28} {}", "kept", earlier(iterate, iterations))?;
            }
            if let Some(text) = self.gap.and_then(gap_sentence) {
                writeln!(f, "{:>28} {text}", "lowest loss")?;
            }
            if let Some(window) = &self.found_window {
                writeln!(f, "{:>28} {}", "optimized for", window.sentence())?;
            }
            if let Some(text) = &self.found_response {
                writeln!(f, "{:>28} {text}", "response found")?;
            }
        }
        let heads = |f: &mut fmt::Formatter<'_>, name: &str, q: &Quality| {
            let ([a, b, c, d], _) = q.columns();
            writeln!(f, "{name:>28} {a:>9} {b:>10} {c:>10} {d:>10}")
        };
        let row = |f: &mut fmt::Formatter<'_>, name: &str, q: &Quality| {
            let number = |m: Measure| m.map_or_else(|| "–".to_owned(), in_column);
            let [a, b, c, d] = q.columns().1.map(number);
            writeln!(f, "{name:>28} {a:>9} {b:>10} {c:>10} {d:>10}")
        };
        let first = self.species.first();
        let first = first.map_or_else(String::new, |species| format!("{}:", species.name));
        heads(f, &first, &self.evaluation)?;
        if let Some(optimization) = &self.optimization {
            row(f, "unwritten, on the job's grid", optimization)?;
        }
        let written = match self.sub_angles {
            1 => "written, one angle a frame",
            _ => "written, turning",
        };
        row(f, written, &self.evaluation)?;
        for species in self.species.iter().skip(1) {
            heads(f, &format!("{}:", species.name), &species.evaluation)?;
            row(f, written, &species.evaluation)?;
        }
        let [x, y, z] = self.evaluation_voxels;
        let finer = match self.refine {
            1 => "the job's own (evaluate.refine = 1)".to_owned(),
            refine => format!("{refine}× finer than the job's"),
        };
        writeln!(
            f,
            "{:>28} {x} × {y} × {z} voxels of {} mm, {finer}",
            "evaluated on",
            concise(self.evaluation_pitch_mm)
        )?;
        for (key, asked, missed) in self.required() {
            let verdict = match missed {
                None => "met".to_owned(),
                Some(found) => format!("NOT met: {found}"),
            };
            writeln!(
                f,
                "{:>28} {asked:9.4} {verdict}",
                format!("required ({key})")
            )?;
        }
        let time = self.print_time.clone();
        let spoiled = self.limits.spoiled.clone().into_iter();
        let texts = spoiled.chain(self.all_limits()).chain(self.exposures());
        for text in texts.chain(time) {
            writeln!(f, "\n{text}")?;
        }
        if let Some(scenarios) = &self.scenarios {
            writeln!(f, "\nScenarios, {}.", scenarios.sentence())?;
        }
        for network in &self.in_time {
            writeln!(f, "\nPrint in time, {network}.")?;
        }
        if let Some(moment) = &self.one_moment {
            writeln!(f, "\nPrint in time. {}", moment.sentence())?;
        }
        writeln!(
            f,
            "\n{:>28} {}",
            "report",
            self.folder.join(self.report).display()
        )
    }
}

/// What a job will do and cost.
#[derive(Clone, Debug, Serialize)]
pub struct Plan {
    /// Name of the part.
    pub part: String,
    /// The dose model, and why.
    pub model: String,
    /// Voxels [x, y, z].
    pub voxels: [usize; 3],
    /// Their edge, mm.
    pub pitch_mm: f64,
    /// Voxels [x, y, z] of the evaluation.
    pub evaluation_voxels: [usize; 3],
    /// Frames of all lights.
    pub frames: usize,
    /// Pixels of all frames.
    pub pixels: usize,
    /// Pixels whose light can reach the target: an upper bound of the unknowns.
    pub active_pixels: usize,
    /// Memory of the largest stage, MB.
    pub memory_mb: u64,
    /// Memory that it may plan with, MB.
    pub memory_budget_mb: Option<u64>,
    /// Size of the run folder, MB.
    pub disk_mb: u64,
    /// Time of the whole run on this machine when all iterations are needed, s.
    pub seconds: f64,
    /// The most iterations there will be.
    pub iterations: usize,
    /// Part of the time that is the optimization's, s; less when it ends early.
    pub optimization_s: f64,
    /// Measured updates per second.
    pub updates_per_s: f64,
    /// Choices that were made.
    pub notes: Vec<String>,
    /// What may be wrong.
    pub warnings: Vec<String>,
}

impl fmt::Display for Plan {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let times = |[x, y, z]: [usize; 3]| format!("{x} × {y} × {z}");
        writeln!(f, "{:>12} {}", "part", self.part)?;
        writeln!(f, "{:>12} {}", "model", self.model)?;
        writeln!(
            f,
            "{:>12} {} voxels of {} mm",
            "grid",
            times(self.voxels),
            concise(self.pitch_mm)
        )?;
        writeln!(
            f,
            "{:>12} {} voxels",
            "evaluation",
            times(self.evaluation_voxels)
        )?;
        let active = 100.0 * self.active_pixels as f64 / self.pixels.max(1) as f64;
        writeln!(
            f,
            "{:>12} {}, {}, at most {active:.0} % of them are used",
            "patterns",
            counted(self.frames, "frame"),
            counted(self.pixels, "pixel")
        )?;
        let available = self
            .memory_budget_mb
            .map(|mb| format!(" of {mb} MB in the budget"))
            .unwrap_or_default();
        writeln!(f, "{:>12} {} MB{available}", "memory", self.memory_mb)?;
        writeln!(f, "{:>12} {} MB", "disk", self.disk_mb)?;
        writeln!(
            f,
            "{:>12} at most {} iterations: {}; evaluation and files: {} ({}updates/s on this machine with its present load)",
            "time",
            self.iterations,
            duration(self.optimization_s),
            duration(self.seconds - self.optimization_s),
            large(self.updates_per_s)
        )?;
        for note in &self.notes {
            writeln!(f, "{:>12} {note}", "")?;
        }
        for warning in &self.warnings {
            writeln!(f, "{:>12} {warning}", "warning")?;
        }
        Ok(())
    }
}

/// A number as a column holds it: four decimals, or an exponent where these would say nothing or be too many.
fn in_column(value: f64) -> String {
    let size = value.abs();
    if size > 0.0 && !(5e-5..1e5).contains(&size) {
        return format!("{value:.2e}");
    }
    // A zero has no sign
    format!("{:.4}", value + 0.0)
}

/// Which iterate is the result, and why, when it is not the last one.
pub(crate) fn earlier(iterate: KeptIterate, iterations: usize) -> String {
    let (iteration, why) = (iterate.iteration, iterate.by.words());
    format!("iteration {iteration} of {iterations} ({why})")
}

/// Why an optimization ended, in words.
fn words(reason: StopReason) -> &'static str {
    match reason {
        StopReason::Iterations => "all of `stop.iterations`",
        StopReason::ZeroLoss => "the loss is zero",
        StopReason::ProjectedGradient => "the projected gradient is small enough",
        StopReason::Steady => "the loss hardly changes any more: `stop.change`",
        StopReason::Gap => "hardly better patterns are possible",
        StopReason::NoProgress => "no further improvement within rounding errors",
        StopReason::Observer => "the requested loss or IoU is reached",
        StopReason::WallTime => "the time is over",
        StopReason::Canceled => "canceled",
    }
}

/// A large number with the letter of its thousands, before a unit.
///
/// ```
/// use tomolith::job::summary::large;
/// assert_eq!([2.46e10, 3.1e8, 4200.0, 12.0].map(large), ["24.6 G ", "310.0 M ", "4.2 k ", "12 "]);
/// ```
#[must_use]
pub fn large(number: f64) -> String {
    for (size, letter) in [(1e9, "G"), (1e6, "M"), (1e3, "k")] {
        if number >= size {
            return format!("{:.1} {letter} ", number / size);
        }
    }
    format!("{number:.0} ")
}

pub(crate) fn summary(
    done: &Done<'_>,
    headline: Headline,
    folder: &Path,
    begin: Instant,
) -> Summary {
    let optimized = done.optimized.as_ref();
    let first = done.evaluated.first();
    Summary {
        folder: folder.to_owned(),
        report: match done.leaves {
            Leaves::All => "report.html",
            Leaves::Metrics | Leaves::Patterns => "report.json",
        },
        iterations: optimized
            .and_then(|o| o.outcome.history.last())
            .map(|row| row.iteration),
        stopped: optimized.map(|o| o.outcome.reason),
        beyond: optimized.and_then(|o| beyond(o, &done.resolved)),
        fall: optimized
            .filter(|o| o.outcome.kept.by == KeptBy::Loss)
            .and_then(|o| fall(&o.outcome)),
        kept: optimized.map(|o| o.outcome.kept),
        gap: optimized.and_then(|o| o.outcome.gap()),
        found_window: optimized.and_then(|o| o.window),
        found_response: optimized.and_then(|o| Some(o.found.as_ref()?.sentence())),
        evaluation: quality(&first.evaluation),
        optimization: first.optimization.as_ref().map(quality),
        exposure: headline.exposures.first().copied().flatten(),
        species: species(done, &headline),
        one_exposure: headline.one_exposure,
        in_time: done
            .evaluated
            .in_time
            .iter()
            .flat_map(InTime::summary)
            .collect(),
        one_moment: done.evaluated.in_time.as_ref().and_then(InTime::together),
        scenarios: done.evaluated.scenarios.clone(),
        print_time: time_sentence(
            first.evaluation.measures.get("print_time_mm"),
            optimized.and_then(|o| Some(&o.ceiling.as_ref()?.report)),
        ),
        limits: headline.limits.into_iter().next().unwrap_or_default(),
        required_iou: done.resolved.evaluation().require_iou,
        required_in_band: done.resolved.evaluation().require_in_band,
        evaluation_voxels: [2, 1, 0].map(|axis| first.evaluation.grid.shape[axis]),
        sub_angles: first.evaluation.sub_angles,
        evaluation_pitch_mm: first.evaluation.grid.pitch_mm,
        refine: done.resolved.extent.refine,
        seconds: begin.elapsed().as_secs_f64(),
    }
}

/// How the loss fell in the end. Where it had come to rest above that of an earlier iterate, which is kept, it had not converged to the patterns of the run.
fn fall(outcome: &Outcome) -> Option<Fall> {
    let fall = Fall::of(&outcome.history)?;
    let is_among_last = outcome.kept.iteration + fall.last > fall.all;
    (is_among_last || !fall.has_converged()).then_some(fall)
}

/// Why an optimization has more iterations than `stop.iterations`.
fn beyond(optimized: &Optimized, job: &ResolvedJob) -> Option<String> {
    let done = optimized.outcome.history.last()?.iteration;
    let asked = job.stop().iterations;
    let all = job.levels.last().map_or(asked, |level| level.until);
    let ceiling = optimized.ceiling.as_ref();
    let trial = ceiling.and_then(|ceiling| ceiling.report.finest.as_ref());
    let has_changed = trial.is_some_and(|trial| trial.changed_by != 1.0);
    words_beyond(done, [asked, all], has_changed)
}

/// Words on iterations that were done, asked for, and asked for on all levels.
fn words_beyond(
    done: usize,
    [asked, all]: [usize; 2],
    has_another_ceiling: bool,
) -> Option<String> {
    match done.saturating_sub(all) {
        0 if done == all && all > asked => {
            Some("all of `stop.iterations` and `multiresolution.iterations`".to_owned())
        }
        0 => None,
        more if has_another_ceiling => Some(format!(
            "all of `stop.iterations`, and {more} below another ceiling"
        )),
        more => Some(format!(
            "the checkpoint had {more} more than `stop.iterations`"
        )),
    }
}

/// Every species, where the job names several.
fn species(done: &Done<'_>, headline: &Headline) -> Vec<SpeciesSummary> {
    let species = &done.resolved.species;
    if species.len() == 1 {
        return Vec::new();
    }
    let all = species.iter().zip(&done.evaluated.species).enumerate();
    let summary_of = |(s, (species, print)): (usize, (&Species, &SpeciesPrint))| SpeciesSummary {
        name: species.name.clone().unwrap_or_default(),
        evaluation: quality(&print.evaluation),
        exposure: headline.exposures[s],
        limits: headline.limits[s].clone(),
    };
    all.map(summary_of).collect()
}

fn quality(evaluation: &Evaluation) -> Quality {
    let get = |name| evaluation.measures.get(name);
    Quality {
        iou: get("iou"),
        ver: get("ver"),
        pw: get("pw"),
        threshold: evaluation.gel_threshold,
        gray: evaluation.half_width.map(|half_width| GrayQuality {
            half_width,
            in_band: get("in_band"),
            rms_error: get("rms_error"),
            max_error_part: get("max_error_part"),
            max_error_void: get("max_error_void"),
        }),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn numbers_keep_to_their_column() {
        for (value, text) in [
            (0.97504, "0.9750"),
            (-0.0, "0.0000"),
            (-0.00012, "-0.0001"),
            (3.5e-10, "3.50e-10"),
            (-2.7016e37, "-2.70e37"),
        ] {
            assert_eq!(in_column(value), text);
        }
    }

    #[test]
    fn more_iterations_than_the_job_asks_for_are_explained() {
        let reason_of = |done, all, is_another| words_beyond(done, [12, all], is_another);
        assert_eq!(
            [reason_of(12, 12, false), reason_of(9, 12, true)],
            [None, None]
        );
        let why = |reason: Option<String>, expected: &str| {
            tomolith_core::contains!(reason.unwrap(), expected);
        };
        why(reason_of(14, 12, false), "the checkpoint had 2 more");
        why(reason_of(20, 12, true), "8 below another ceiling");
        // 20 iterations on a coarser level are no checkpoint's
        why(reason_of(32, 32, false), "`multiresolution.iterations`");
        why(reason_of(34, 32, false), "the checkpoint had 2 more");
        assert_eq!(reason_of(25, 32, false), None);
    }
}
