//! The lowest ceiling of the pixels at which a job prints as well as without one.
//!
//! A projector's white is fixed, so a print lasts as long as its brightest pixel asks for: its time is proportional to N·M/t, the frames times the largest pixel over the dose at the
//! best threshold. Where a job names no largest pixel, the program looks for a low one.
//!
//! **Method** The job is optimized on pixels, frames and voxels of twice the width (about a sixteenth of the cost of an iteration) within the bound of the start.
//! From there the ceiling falls by factors of 2 below the brightest pixel, each time for a few iterations more, until the print is worse by more than the job
//! tolerates; then one step of √2 back. What limits the print at a low ceiling are edges, whose errors scale with the width of a pixel: on pixels of twice the width
//! IoU and VER may lose twice as much; the mean deviation and Γ are relative, and may lose the same. Γ, the range of exposures that print, holds the ceiling
//! where IoU says nothing: even light prints a disc, too, but within no range of exposures. Where the lower ceiling has the better IoU, both ranges end at the IoU of the higher one. A frame that stands for half the arc holds half the dose.
//!
//! **Start** The optimization goes on from what was found there, which stands for a tenth of its iterations. From there boat, dog-bones and cuvette of docs/fidelity.md print the same
//! with a fifth less of them; the double tube loses 0.0011 in IoU with a fifth less, and 0.0005 with a tenth. Where pixels are so few that the start has the lower loss, it begins there.
//!
//! **Several lights** have one ceiling each, at one factor below the brightest pixel of each. **Species**: each print must be good enough.
//!
//! **Limits** The bound of the start stays where a job names `bounds.max` or `printer.time_s`, starts from given patterns, rounds in every step, prints in time, ends
//! after some seconds (`stop.wall_s`), is gray, has few levels or scenarios, looks for a process window or a response, weighs voxels by files, or uses another method than `lbfgs`;
//! where the unknowns of the model are amplitudes; and where the coarser level cannot be made.
//!
//! **Cost** 28 + 8·(2 to 9) iterations on the coarser level, less the tenth of the iterations; docs/fidelity.md has measured shares of the loop.

use super::stage::Stage;
use super::start::clip;
use crate::error::{Error, Result};
use crate::field::{Field, HostField};
use crate::grid::{Patterns, Volume};
use crate::job::dose::doses::{Exposed, doses_by};
use crate::job::progress::Silent;
use crate::job::resolve::multiresolution::{coarser_grid, coarser_lights, is_large_enough};
use crate::job::resolve::refinement::{self, Level};
use crate::job::resolve::{ResolvedJob, Voxels};
use crate::metrics::print::Print;
use crate::metrics::{MetricKind, gamma, iou, surface_deviation, ver};
use crate::models::{Purpose, Quantity, Work};
use crate::objective::Objective;
use crate::optimize;
use crate::optimize::start::InitialPatterns;
use crate::optimize::start::given::Given;
use crate::optimize::{Checkpoints, Limits, Problem, Stop, StopReason, lbfgs};
use crate::report::{CeilingPoint, CeilingQuality, CeilingReport};
use crate::target::label;
use serde::{Deserialize, Serialize};
use std::time::Instant;

/// How much wider pixels, frames and voxels are where ceilings are tried.
const FACTOR: usize = 2;
/// Iterations within the bound of the start, and at each ceiling, at most. After 16 within the bound the star of docs/fidelity.md, which gains most from bright pixels, has
/// not yet gained it.
const FIRST: usize = 28;
const EACH: usize = 8;
/// Iterations of a job from which on a trial says what the ceiling costs, and not what further iterations bring.
const SETTLED: usize = 30;
/// The search stands for one of so many of the job's iterations.
pub(crate) const SHARE: usize = 10;
/// An iteration on the coarser level, with what is measured there, takes one of so many parts of one of the loop: measured between 6 and 14.
const CHEAPER: usize = 8;
/// Corners of each surface that mean deviations are taken from.
const CORNERS: usize = 20_000;
/// Part of the start's loss on the coarser level below which other patterns begin better on the finest one, too: there the start has two fifths of that loss or more.
const CLEARLY: f64 = 0.1;
/// Ceilings are tried down to 2⁻⁸ of the brightest pixel.
const MOST_HALVES: i32 = 8;

/// Ceilings that were found.
#[derive(Serialize, Deserialize)]
pub(crate) struct FoundCeiling {
    /// Of each light, for the frames of the finest level; None where no ceiling below the start's bound is good enough.
    largest: Option<Vec<f64>>,
    /// Frames of each light on that level.
    frames: Vec<usize>,
    /// Patterns below the lowest ceiling that is good enough, to go on from; None where none is, and where the job begins with its start nevertheless.
    #[serde(skip)]
    patterns: Option<Vec<Patterns>>,
    /// The start on the coarser level, where the job goes on from such patterns.
    start: Option<CoarseStart>,
    /// What was tried.
    pub(crate) report: CeilingReport,
    /// How long it took, s.
    pub(crate) seconds: f64,
}

/// What is known of the start of a job from that on the coarser level.
#[derive(Serialize, Deserialize)]
struct CoarseStart {
    /// The largest pixel that it allows each light, for the frames of the finest level.
    largest: Vec<f64>,
    loss: f64,
}

impl FoundCeiling {
    /// The patterns to go on from, once.
    pub(crate) fn take_patterns(&mut self) -> Option<Vec<Patterns>> {
        self.patterns.take()
    }

    /// Bounds of the start, as far as they are known without it.
    pub(crate) fn of_start(&self, job: &ResolvedJob, level: &Level) -> Option<Vec<Limits>> {
        let largest = self.for_frames(&self.start.as_ref()?.largest, level);
        let limits = largest.enumerate().map(|(light, max)| Limits {
            min: job.bounds_of(light).0,
            max,
        });
        Some(limits.collect())
    }

    /// Whether patterns with this loss are better than the start, however it comes out on the level itself.
    pub(crate) fn is_clearly_better(&self, loss: f64) -> bool {
        (self.start.as_ref()).is_some_and(|start| loss < CLEARLY * start.loss)
    }

    /// Whether there is a ceiling below the bound of the start.
    pub(crate) fn is_lower(&self) -> bool {
        self.largest.is_some()
    }

    /// Whether the ceiling times a factor may print well on the finest level. Not where the search tried it and IoU or VER lost more than twice what they may:
    /// on the finest level the published boat and the one of 9.5 mm still lose a third of that, which is too much. Surfaces are left out, as in all trials of that
    /// level. Jobs of few iterations try it: they gain more from the trial's iterations than the ceiling costs.
    pub(crate) fn may_become(&self, factor: f64, job: &ResolvedJob) -> bool {
        let points = &self.report.points;
        let asked = self.report.chosen.map_or(1.0, |i| points[i].factor) * factor;
        let tried = (points.iter()).find(|point| (point.factor / asked - 1.0).abs() < 1e-6);
        tried
            .filter(|_| job.stop().iterations >= SETTLED)
            .is_none_or(|tried| {
                let without_surfaces = |print: &CeilingQuality| CeilingQuality {
                    surface_mean_mm: None,
                    ..*print
                };
                let qualities: Vec<_> = tried.qualities.iter().map(without_surfaces).collect();
                are_good(job, 2 * FACTOR, &points[0].qualities, &qualities)
            })
    }

    /// Lowers bounds to the ceilings; `level` says for which frames the bounds are.
    pub(crate) fn lower(&self, bounds: &mut [Limits], level: &Level) {
        let largest = self.largest.as_deref().unwrap_or_default();
        for (bound, largest) in bounds.iter_mut().zip(self.for_frames(largest, level)) {
            bound.max = bound.max.min(largest);
        }
    }

    /// Largest pixels of the finest level's frames, for those of a level.
    fn for_frames(&self, largest: &[f64], level: &Level) -> impl Iterator<Item = f64> {
        let lights = level.lights.iter().zip(&self.frames);
        lights.zip(largest).map(|((light, frames), largest)| {
            largest * (*frames as f64 / light.pixels.frames() as f64)
        })
    }
}

/// Iterations that looking for ceilings takes in all, in those of the loop; 0 for a job that stays within the bound of its start. Those that it saves are left out: a search may find nothing.
pub(crate) fn iterations(job: &ResolvedJob, voxels: &[Voxels]) -> usize {
    let level = coarser_level(job, voxels);
    level.map_or(0, |level| {
        let tried = level.until + 4 * level.until.div_ceil(3).min(EACH);
        tried.div_ceil(CHEAPER) + super::finest::TRY
    })
}

/// [`find`], or what the checkpoint says was found before the run was cut off.
///
/// # Errors
/// As [`find`], and where the checkpoint cannot be read.
pub(crate) fn find_once(
    job: &ResolvedJob,
    voxels: &[Voxels],
    checkpoints: &mut Checkpoints,
    is_resumed: bool,
    work: &Work,
) -> Result<Option<FoundCeiling>> {
    let earlier = match is_resumed {
        true => checkpoints.open()?,
        false => None,
    };
    let earlier = earlier.and_then(|earlier| serde_json::from_value(earlier.found().clone()).ok());
    // A list of one: nothing that was found is not nothing that is known
    let [found]: [Option<FoundCeiling>; 1] = match earlier {
        Some(found) => found,
        None => [find(job, voxels, work)?],
    };
    checkpoints.remember(serde_json::to_value([&found]).unwrap_or_default());
    Ok(found)
}

/// Looks for the ceilings of a job; None where it stays within the bound of its start.
pub(crate) fn find(
    job: &ResolvedJob,
    voxels: &[Voxels],
    work: &Work,
) -> Result<Option<FoundCeiling>> {
    let Some(level) = coarser_level(job, voxels) else {
        return Ok(None);
    };
    match find_on(&level, job, voxels, work) {
        Err(Error::Canceled) => Err(Error::Canceled),
        // Pixels of twice the width may be too wide for the model, or miss the part; errors of the job itself show on its own level
        found => Ok(found.ok().flatten()),
    }
}

fn find_on(
    level: &Level,
    job: &ResolvedJob,
    voxels: &[Voxels],
    work: &Work,
) -> Result<Option<FoundCeiling>> {
    let begin = Instant::now();
    let work = &work.aside();
    let stage = Stage::new(job, voxels, level, None, &mut Silent, work)?;
    let mut x = stage.start(bounding_start(job), work)?;
    if stage.model.quantity() != Quantity::Energy {
        return Ok(None);
    }
    let of_start = stage.limits(&x);
    let even_dose = stage.even_dose(&x, work)?;
    let start_loss = stage.loss(&x, work)?;
    stage.improve_within(&mut x, &of_start, level.until, work)?;
    let search = Search {
        stage: &stage,
        of_start: &of_start,
        work,
    };
    let (tried, mut best) = search.descend(x)?;
    let patterns = tried.good.filter(|_| may_begin_elsewhere(job));
    let patterns = patterns.map(|_| stage.patterns(&mut best));
    let frames = |level: &Level| -> Vec<usize> {
        level
            .lights
            .iter()
            .map(|light| light.pixels.frames())
            .collect()
    };
    let (fine, coarse) = (frames(finest(job)), frames(level));
    let per_frame = |(fine, coarse): (&usize, &usize)| *coarse as f64 / *fine as f64;
    let per_frame: Vec<f64> = fine.iter().zip(&coarse).map(per_frame).collect();
    let of_finest = |largest: &[f64]| -> Vec<f64> {
        let pairs = largest.iter().zip(&per_frame);
        pairs.map(|(bright, share)| bright * share).collect()
    };
    let brightest = of_finest(&tried.brightest);
    // Lower bounds of frames with twice the arc are another light. Where iterations are few or voxels as wide as pixels, the losses of both starts differ by up to ten
    let is_alike = job.sees_within_pixels && job.stop().iterations >= SETTLED;
    let is_dark = of_start.iter().all(|limits| limits.min == 0.0);
    let is_of_job = patterns.is_some() && job.method.start.files().is_none();
    let is_as_here = is_alike && is_dark && is_of_job;
    let start = is_as_here.then(|| CoarseStart {
        largest: of_finest(&of_start.iter().map(|limits| limits.max).collect::<Vec<_>>()),
        loss: start_loss,
    });
    // Without a bound there is none to be known
    let start = start.filter(|start| start.largest.iter().all(|max| max.is_finite()));
    let white = |(frames, bright): (&usize, &f64)| *frames as f64 * bright;
    let white = fine.iter().zip(&brightest).map(white).sum();
    let largest = tried.good.map(|i| {
        brightest
            .iter()
            .map(|bright| bright * tried.points[i].factor)
            .collect()
    });
    Ok(Some(FoundCeiling {
        largest,
        frames: fine,
        patterns,
        start,
        report: CeilingReport {
            brightest: brightest.iter().copied().fold(0.0, f64::max),
            white,
            even_dose: even_dose / per_frame.iter().copied().fold(f64::INFINITY, f64::min),
            chosen: tried.good,
            points: tried.points,
            finest: None,
        },
        seconds: begin.elapsed().as_secs_f64(),
    }))
}

/// The start whose brightest pixel bounds all.
fn bounding_start(job: &ResolvedJob) -> &dyn InitialPatterns {
    let start = job.method.start.as_ref();
    let named = start.files().and_then(|files| files.bounds_as.as_deref());
    named.unwrap_or(start)
}

/// Whether the optimization may go on from what the search found: it sees inside of pixels, and nothing in the job counts from its start or asks for coarser
/// levels of its own. Patterns for whole voxels of twice the width are a worse start than the job's, but where iterations are few: examples 12 and 14 lose 0.005 and
/// 0.03 in IoU with them, and example 15 gains 0.04.
pub(super) fn may_begin_elsewhere(job: &ResolvedJob) -> bool {
    let stop = job.stop();
    let counts_from_start = stop.relative_loss.is_some() || stop.projected_gradient.is_some();
    let is_better = job.sees_within_pixels || stop.iterations < SETTLED;
    is_better && !job.has_coarse_levels() && !counts_from_start
}

fn finest(job: &ResolvedJob) -> &Level {
    job.levels.last().expect("a job has a level")
}

/// The level on which ceilings are tried; None for a job that stays within the bound of its start.
fn coarser_level(job: &ResolvedJob, voxels: &[Voxels]) -> Option<Level> {
    let (stop, method, finest) = (job.stop(), &job.method, finest(job));
    let goals = job.species.iter().map(|species| &species.goal);
    let mut lights = 0..job.optics.lights.len();
    let names_largest = lights.any(|light| job.bounds_of(light).1.is_some());
    let files = method.start.files();
    let has_given = files.is_some_and(|files| files.bounds_as.is_none());
    let has_scale = method.name() != lbfgs::NAME
        || (goals.into_iter()).any(|goal| goal.seeks_window() || goal.has_fields());
    if !job.bounds().seek_ceiling()
        || names_largest
        || has_given
        || job.schedule().is_some()
        || has_scale
        || voxels.iter().any(|voxels| voxels.target.gray)
        || job.evaluation().has_few_levels()
        || !job.scenarios.is_empty()
        || job.bounds().bits.is_some()
        || method.free.is_some()
        || stop.iterations == 0
        || stop.wall_s.is_some()
        || !is_large_enough(&job.optics, &job.grid, FACTOR)
    {
        return None;
    }
    Some(Level {
        grid: coarser_grid(&finest.grid, FACTOR),
        lights: coarser_lights(&finest.lights, FACTOR),
        until: (2 * stop.iterations).div_ceil(3).min(FIRST),
    })
}

/// Ceilings that were tried, from the highest.
struct Tried {
    /// The brightest pixel of each light within the bound of the start.
    brightest: Vec<f64>,
    points: Vec<CeilingPoint>,
    /// The lowest that is good enough.
    good: Option<usize>,
}

/// What ceilings are tried with.
struct Search<'a> {
    stage: &'a Stage<'a>,
    of_start: &'a [Limits],
    work: &'a Work,
}

impl Search<'_> {
    /// Lowers the ceiling from the brightest pixel of `x` as far as prints stay good; the patterns below the lowest such ceiling.
    fn descend(&self, mut x: HostField) -> Result<(Tried, HostField)> {
        let lights = self.stage.model.patterns().iter();
        let brightest = lights.map(|light| {
            let pixels = &x.as_slice()[light.range()];
            f64::from(pixels.iter().fold(0.0f32, |most, &value| most.max(value)))
        });
        let brightest = brightest.collect();
        let mut tried = Tried {
            brightest,
            points: vec![CeilingPoint {
                factor: 1.0,
                qualities: self.stage.qualities(&x, true, &[], self.work)?,
            }],
            good: None,
        };
        if tried.brightest.iter().any(|&bright| bright <= 0.0) {
            return Ok((tried, x));
        }
        let is_above = |factor: f64| {
            let mut lights = self.of_start.iter().zip(&tried.brightest);
            lights.all(|(start, bright)| bright * factor > start.min)
        };
        let lowest = (0..=MOST_HALVES)
            .map(|n| 0.5f64.powi(n))
            .rfind(|&factor| is_above(factor));
        let lowest = lowest.unwrap_or(1.0);
        let mut factor = 1.0;
        while factor > lowest {
            match self.one(&mut tried, &x, factor / 2.0)? {
                Some(half) => x = half,
                None => break,
            }
            factor /= 2.0;
        }
        if factor > lowest {
            let between = factor * std::f64::consts::FRAC_1_SQRT_2;
            x = self.one(&mut tried, &x, between)?.unwrap_or(x);
        }
        Ok((tried, x))
    }

    /// The patterns under a ceiling, from those above it; None where they print worse than the job tolerates.
    fn one(&self, tried: &mut Tried, x: &HostField, factor: f64) -> Result<Option<HostField>> {
        let (stage, work) = (self.stage, self.work);
        let ceiling = |(start, bright): (&Limits, &f64)| Limits {
            min: start.min,
            max: bright * factor,
        };
        let lights = self.of_start.iter().zip(&tried.brightest);
        let limits: Vec<Limits> = lights.map(ceiling).collect();
        let each = stage.level.until.div_ceil(3).min(EACH);
        let mut lowered = x.clone();
        clip(&mut lowered, stage.model.patterns(), &limits)?;
        stage.improve_within(&mut lowered, &limits, each, work)?;
        let without = &tried.points[0].qualities;
        let qualities = stage.qualities(&lowered, true, without, work)?;
        let is_good = are_good(stage.job, FACTOR, without, &qualities);
        tried.points.push(CeilingPoint { factor, qualities });
        if is_good {
            tried.good = Some(tried.points.len() - 1);
        }
        Ok(is_good.then_some(lowered))
    }
}

/// Whether every print is at least as good as another, within what a job tolerates, on pixels so many times as wide as the job's.
pub(crate) fn are_good(
    job: &ResolvedJob,
    wider: usize,
    others: &[CeilingQuality],
    qualities: &[CeilingQuality],
) -> bool {
    let (wider, tolerance) = (wider as f64, &job.bounds().tolerance);
    let within = |(other, quality): (&CeilingQuality, &CeilingQuality)| {
        let [other, quality] = [other, quality].map(CeilingQuality::numbers);
        // Where nothing is known of surfaces or of Γ, it is not worse
        let is_farther = quality[2] > other[2] * (1.0 + tolerance.deviation);
        let is_narrower = quality[3] < other[3] * (1.0 - tolerance.latitude);
        quality[0] >= other[0] - wider * tolerance.iou
            && quality[1] <= other[1] + wider * tolerance.ver
            && !is_narrower
            && !is_farther
    };
    others.iter().zip(qualities).all(within)
}

impl Stage<'_> {
    /// Mean dose in the part of the first output where every pixel is 1; 0 with several lights, which need not shine alike.
    fn even_dose(&self, like: &HostField, work: &Work) -> Result<f64> {
        if self.model.patterns().len() > 1 {
            return Ok(0.0);
        }
        let mut ones = like.zeros_like();
        ones.fill(1.0);
        let mut dose = self.model.new_dose()?;
        self.model.dose(&ones, &mut dose, work)?;
        let dose = self.model.outputs()[0].volume_of(dose.as_slice());
        let pairs = self.voxels[0].labels.values.iter().zip(&dose.values);
        let in_part = pairs.filter(|(label, _)| **label == label::PART);
        let (count, sum) = in_part.fold((0u64, 0.0), |(n, sum), (_, &dose)| {
            (n + 1, sum + f64::from(dose))
        });
        Ok(sum / count.max(1) as f64)
    }

    /// Some iterations within these limits, which nobody watches.
    pub(crate) fn improve_within(
        &self,
        x: &mut HostField,
        limits: &[Limits],
        iterations: usize,
        work: &Work,
    ) -> Result<()> {
        let (job, model) = (self.job, self.model.as_ref());
        let objective = self.objective(0)?;
        let problem = Problem::new(model, &objective, limits, work)?;
        let penalties = job.method.penalties(model.patterns())?;
        let mut problem = problem.with_penalties(penalties);
        let mut optimizer = job.method.optimizer()?;
        let stop = Stop {
            iterations,
            keep: job.stop().keep,
            ..Stop::default()
        };
        let outcome = optimize::run(&mut problem, optimizer.as_mut(), x, &stop, None, &mut [])?;
        match outcome.reason {
            StopReason::Canceled => Err(Error::Canceled),
            _ => Ok(()),
        }
    }

    /// Patterns of a search within bounds.
    pub(crate) fn within(
        &self,
        bounds: &[Limits],
        found: Vec<Patterns>,
        work: &Work,
    ) -> Result<HostField> {
        let found = Given(self.job.own_patterns(self.level, found));
        let mut found = self.start(&found, work)?;
        clip(&mut found, self.model.patterns(), bounds)?;
        Ok(found)
    }

    /// The loss of patterns.
    pub(crate) fn loss(&self, x: &HostField, work: &Work) -> Result<f64> {
        let mut dose = self.model.new_dose()?;
        self.model.dose(x, &mut dose, work)?;
        Ok(self.objective(0)?.value(&dose))
    }

    /// How good every output is, next to other prints of them; nothing of its surface where surfaces are left out. Of a print with a better IoU than the other one, Γ is the
    /// range in which it is better than 95 % of the other's: near a better IoU of its own a range is smaller, and no worse for that.
    pub(crate) fn qualities(
        &self,
        x: &HostField,
        has_surfaces: bool,
        others: &[CeilingQuality],
        work: &Work,
    ) -> Result<Vec<CeilingQuality>> {
        let (doses, voxels) = self.judged(x, work)?;
        let of_output = doses.iter().enumerate().map(|(i, dose)| {
            let voxels = voxels.get(i).unwrap_or(&voxels[0]);
            let print = Print::under(&voxels.labels, dose, work.aside())?;
            let print = print.with_inside(&voxels.target.inside)?;
            let print = match has_surfaces {
                true => print.with_most_corners(CORNERS),
                false => print.without_distance(),
            };
            let other = others.get(i).and_then(|other| other.iou);
            Ok(quality(&print, other))
        });
        let found = of_output.collect::<Result<Vec<_>>>()?;
        work.check()?;
        Ok(found)
    }

    /// Doses of patterns, and the voxels on which they are judged: this level's, or finer ones where the optimization does not see inside of pixels.
    fn judged(&self, x: &HostField, work: &Work) -> Result<(Vec<Volume<f32>>, &[Voxels])> {
        let (job, level) = (self.job, self.level);
        let finer = job.ranks.as_ref().map_or(job.extent.judged_finer, |_| 1);
        let grid = refinement::judged(&level.grid, finer);
        if grid == level.grid {
            let mut dose = self.model.new_dose()?;
            self.model.dose(x, &mut dose, work)?;
            let outputs = self.model.outputs().iter();
            let doses = outputs.map(|layout| layout.volume_of(dose.as_slice()));
            return Ok((doses.collect(), &self.voxels));
        }
        let patterns = self.patterns(&mut x.clone());
        let refine = (level.grid.pitch_mm / grid.pitch_mm).round() as usize;
        let (purpose, family) = (Purpose::Evaluate { refine }, job.optics.model.as_ref());
        let exposed = Exposed::new(&grid, level.lights.clone());
        let doses = doses_by(family, purpose, job, &exposed, &patterns, work)?;
        if self.finer.get().is_none() {
            let _ = self.finer.set(job.voxels(&grid, &work.aside())?);
        }
        Ok((doses, self.finer.get().map_or(&[], Vec::as_slice)))
    }
}

/// How good a print is; `other`: the IoU of the one that it is compared with.
fn quality(print: &Print<'_>, other: Option<f64>) -> CeilingQuality {
    let measure = |kind: &MetricKind| (kind.measure)(print).filter(|v| v.is_finite());
    let iou = measure(&iou::KIND);
    let gamma = match other.filter(|other| iou.is_some_and(|iou| iou > *other)) {
        Some(other) => print.scan().length_near(other).map(|t| 100.0 * t),
        None => measure(&gamma::KIND),
    };
    CeilingQuality {
        iou,
        ver: measure(&ver::KIND),
        surface_mean_mm: measure(&surface_deviation::MEAN),
        gamma,
    }
}
