//! The lowest ceiling of the pixels at which a job prints as well as without one.
//!
//! A projector's white is fixed, so a print lasts as long as its brightest pixel asks for: its time is proportional to M/t, the largest pixel over the dose at the
//! best threshold. Where a job names no largest pixel, the program looks for a low one.
//!
//! **Method** The job is optimized on pixels, frames and voxels of twice the width (about a sixteenth of the cost of an iteration) within the bound of the start.
//! From there the ceiling falls by factors of 2 below the brightest pixel, each time for a few iterations more, until the print is worse by more than the job
//! tolerates; then one step of √2 back. What limits the print at a low ceiling are edges, whose errors scale with the width of a pixel: on pixels of twice the width
//! IoU and VER may lose twice as much; the mean deviation and Γ are relative, and may lose the same. Γ, the range of exposures that print, holds the ceiling
//! where IoU says nothing: even light prints a disc, too, but within no range of exposures. A frame that stands for half the arc holds half the dose.
//!
//! **Several lights** have ceilings of their own, at one factor below the brightest pixel of each. **Species**: each print must be good enough.
//!
//! **Limits** The bound of the start stays where a job names `bounds.max` or `printer.time_s`, starts from given patterns, rounds in every step, prints in time, ends
//! after some seconds (`stop.wall_s`), is gray, has few levels or scenarios, looks for a process window or a response, weighs voxels by files, or uses another method than `lbfgs`;
//! where the unknowns of the model are amplitudes; and where the coarser level cannot be made.
//!
//! **Cost** 28 + 8·(2 to 9) iterations on the coarser level; docs/fidelity.md has measured shares of the loop.

use super::stage::{SoFar, Stage};
use super::start::clip;
use crate::error::{Error, Result};
use crate::field::{Field, HostField};
use crate::grid::Volume;
use crate::job::levels;
use crate::job::multiresolution::{coarser_grid, coarser_lights, is_large_enough};
use crate::job::progress::Silent;
use crate::job::refinement::Level;
use crate::job::scene::{Scene, Voxels};
use crate::job::spec::{Ceiling, CeilingTolerance};
use crate::metrics::print::Print;
use crate::metrics::{MetricKind, gamma, iou, surface_deviation, ver};
use crate::models::{Quantity, Run};
use crate::optimize::start::InitialPatterns;
use crate::optimize::{Limits, StopReason};
use crate::report::{CeilingPoint, CeilingReport};
use crate::target::label;
use std::time::Instant;

/// How much wider pixels, frames and voxels are where ceilings are tried.
const FACTOR: usize = 2;
/// Iterations within the bound of the start, and at each ceiling, at most. After 16 within the bound the star of docs/fidelity.md, which gains most from bright pixels, has
/// not yet gained it.
const FIRST: usize = 28;
const EACH: usize = 8;
/// Ceilings are tried down to 2⁻⁸ of the brightest pixel.
const MOST_HALVES: i32 = 8;

/// Ceilings that were found.
pub(crate) struct FoundCeiling {
    /// Of each light, for the frames of the finest level; None where no ceiling below the start's bound is good enough.
    largest: Option<Vec<f64>>,
    /// Frames of each light on that level.
    frames: Vec<usize>,
    /// What was tried.
    pub(crate) report: CeilingReport,
    /// How long it took, s.
    pub(crate) seconds: f64,
}

impl FoundCeiling {
    /// Lowers bounds to the ceilings; `level` says for which frames the bounds are.
    pub(super) fn lower(&self, bounds: &mut [Limits], level: &Level) {
        let found = self.largest.iter().flatten().zip(&self.frames);
        for ((bound, light), (largest, frames)) in bounds.iter_mut().zip(&level.lights).zip(found) {
            let per_frame = *frames as f64 / light.pixels.frames() as f64;
            bound.max = bound.max.min(largest * per_frame);
        }
    }
}

/// Looks for the ceilings of a job; None where it keeps the bound of its start.
///
/// # Errors
/// [`Error::Canceled`].
pub(super) fn find(scene: &Scene, voxels: &Voxels, cancel: &Run) -> Result<Option<FoundCeiling>> {
    let Some(level) = coarser_level(scene, voxels.target.gray) else {
        return Ok(None);
    };
    match find_on(&level, scene, voxels, cancel) {
        Err(Error::Canceled) => Err(Error::Canceled),
        // Pixels of twice the width may be too wide for the model, or miss the part; what is wrong with the job itself is told by its own level
        found => Ok(found.ok().flatten()),
    }
}

fn find_on(
    level: &Level,
    scene: &Scene,
    voxels: &Voxels,
    cancel: &Run,
) -> Result<Option<FoundCeiling>> {
    let begin = Instant::now();
    let cancel = &cancel.aside();
    let each = Level {
        until: level.until.div_ceil(3).min(EACH),
        ..level.clone()
    };
    let mut stage = Stage::new(scene, voxels, level, None, &mut Silent, cancel)?;
    let mut x = stage.start(scene, bounding_start(scene), cancel)?;
    if stage.model.quantity() != Quantity::Energy {
        return Ok(None);
    }
    let of_start = stage.limits(scene, &x);
    let even_dose = stage.even_dose(&x, cancel)?;
    stage.improve_within(scene, &mut x, &of_start, cancel)?;
    stage.level = &each;
    let tried = Tried::descend(&stage, scene, x, &of_start, cancel)?;
    let frames = |level: &Level| -> Vec<usize> {
        level
            .lights
            .iter()
            .map(|light| light.pixels.frames())
            .collect()
    };
    let (fine, coarse) = (frames(finest(scene)), frames(level));
    let per_frame = |(fine, coarse): (&usize, &usize)| *coarse as f64 / *fine as f64;
    let per_frame: Vec<f64> = fine.iter().zip(&coarse).map(per_frame).collect();
    let brightest: Vec<f64> = (tried.brightest.iter().zip(&per_frame))
        .map(|(own, share)| own * share)
        .collect();
    let largest = tried.good.map(|i| {
        brightest
            .iter()
            .map(|own| own * tried.points[i].factor)
            .collect()
    });
    Ok(Some(FoundCeiling {
        largest,
        frames: fine,
        report: CeilingReport {
            brightest: brightest.iter().copied().fold(0.0, f64::max),
            even_dose: even_dose / per_frame.iter().copied().fold(f64::INFINITY, f64::min),
            chosen: tried.good,
            points: tried.points,
        },
        seconds: begin.elapsed().as_secs_f64(),
    }))
}

/// The start whose brightest pixel bounds all.
fn bounding_start(scene: &Scene) -> &dyn InitialPatterns {
    let start = scene.kinds.start.as_ref();
    let named = start.files().and_then(|files| files.bounds_as.as_deref());
    named.unwrap_or(start)
}

fn finest(scene: &Scene) -> &Level {
    scene.levels.last().expect("a job has a level")
}

/// The level on which ceilings are tried; None for a job that keeps the bound of its start.
fn coarser_level(scene: &Scene, is_gray: bool) -> Option<Level> {
    let (spec, kinds, finest) = (&scene.spec, &scene.kinds, finest(scene));
    let all = std::iter::once(scene).chain(&scene.others);
    let names_largest =
        spec.bounds.max.is_some() || spec.light.iter().any(|light| light.bounds.max.is_some());
    let has_given = kinds
        .start
        .files()
        .is_some_and(|files| files.bounds_as.is_none());
    let in_time = spec.schedule.is_some() || spec.material.is_some();
    let has_scale = kinds.pairs().is_none()
        || all.into_iter().any(|scene| {
            scene.kinds.seeks_window()
                || scene.kinds.common().any(|(_, common)| common.has_fields())
        });
    if spec.bounds.ceiling == Ceiling::Start
        || names_largest
        || has_given
        || in_time
        || has_scale
        || is_gray
        || levels::are_few(&spec.evaluate)
        || !scene.scenarios.is_empty()
        || spec.bounds.bits.is_some()
        || kinds.free.is_some()
        || spec.stop.iterations == 0
        || spec.stop.wall_s.is_some()
        || !is_large_enough(&scene.optics, &scene.grid, FACTOR)
    {
        return None;
    }
    Some(Level {
        grid: coarser_grid(&finest.grid, FACTOR),
        lights: coarser_lights(&finest.lights, FACTOR),
        until: (2 * spec.stop.iterations).div_ceil(3).min(FIRST),
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

impl Tried {
    fn descend(
        stage: &Stage<'_>,
        scene: &Scene,
        mut x: HostField,
        of_start: &[Limits],
        cancel: &Run,
    ) -> Result<Self> {
        let lights = stage.model.patterns().iter();
        let brightest = lights.map(|light| {
            let own = &x.as_slice()[light.range()];
            f64::from(own.iter().fold(0.0f32, |most, &value| most.max(value)))
        });
        let brightest = brightest.collect();
        let mut tried = Tried {
            brightest,
            points: vec![CeilingPoint {
                factor: 1.0,
                qualities: stage.qualities(&x, cancel)?,
            }],
            good: None,
        };
        if tried.brightest.iter().any(|&own| own <= 0.0) {
            return Ok(tried);
        }
        let tolerance = &scene.spec.bounds.tolerance;
        let mut factor = 1.0;
        let is_above = |factor: f64| {
            let mut lights = of_start.iter().zip(&tried.brightest);
            lights.all(|(own, bright)| bright * factor > own.min)
        };
        let lowest = (0..=MOST_HALVES)
            .map(|n| 0.5f64.powi(n))
            .rfind(|&factor| is_above(factor));
        let lowest = lowest.unwrap_or(1.0);
        while factor > lowest {
            let half = tried.one(stage, scene, (&x, of_start, factor / 2.0), cancel)?;
            if !tried.is_good(tolerance) {
                break;
            }
            tried.good = Some(tried.points.len() - 1);
            factor /= 2.0;
            x = half;
        }
        if factor > lowest {
            let between = factor * std::f64::consts::FRAC_1_SQRT_2;
            tried.one(stage, scene, (&x, of_start, between), cancel)?;
            if tried.is_good(tolerance) {
                tried.good = Some(tried.points.len() - 1);
            }
        }
        Ok(tried)
    }

    /// The patterns under a ceiling, from those above it.
    fn one(
        &mut self,
        stage: &Stage<'_>,
        scene: &Scene,
        (x, of_start, factor): (&HostField, &[Limits], f64),
        cancel: &Run,
    ) -> Result<HostField> {
        let ceiling = |(own, bright): (&Limits, &f64)| Limits {
            min: own.min,
            max: bright * factor,
        };
        let limits: Vec<Limits> = of_start.iter().zip(&self.brightest).map(ceiling).collect();
        let mut own = x.clone();
        clip(&mut own, stage.model.patterns(), &limits)?;
        stage.improve_within(scene, &mut own, &limits, cancel)?;
        self.points.push(CeilingPoint {
            factor,
            qualities: stage.qualities(&own, cancel)?,
        });
        Ok(own)
    }

    /// Whether every print of the last ceiling is as good as within the bound of the start.
    fn is_good(&self, tolerance: &CeilingTolerance) -> bool {
        let [Some(first), Some(last)] = [self.points.first(), self.points.last()] else {
            return false;
        };
        let coarse = FACTOR as f64;
        let within = |(before, after): (&[f64; 4], &[f64; 4])| {
            // Of a print without a surface nothing is known, which is not more
            let is_farther = after[2] > before[2] * (1.0 + tolerance.deviation);
            after[0] >= before[0] - coarse * tolerance.iou
                && after[1] <= before[1] + coarse * tolerance.ver
                && after[3] >= before[3] * (1.0 - tolerance.latitude)
                && !is_farther
        };
        first.qualities.iter().zip(&last.qualities).all(within)
    }
}

impl Stage<'_> {
    /// Mean dose in the part of the first output where every pixel is 1.
    fn even_dose(&self, like: &HostField, cancel: &Run) -> Result<f64> {
        let mut ones = like.zeros_like();
        ones.fill(1.0);
        let mut dose = self.model.new_dose()?;
        self.model.dose(&ones, &mut dose, cancel)?;
        let dose = self.model.outputs()[0].volume_of(dose.as_slice());
        let pairs = self.voxels.labels.values.iter().zip(&dose.values);
        let in_part = pairs.filter(|(label, _)| **label == label::PART);
        let (count, sum) = in_part.fold((0u64, 0.0), |(n, sum), (_, &dose)| {
            (n + 1, sum + f64::from(dose))
        });
        Ok(sum / count.max(1) as f64)
    }

    /// Some iterations within these limits.
    fn improve_within(
        &self,
        scene: &Scene,
        x: &mut HostField,
        limits: &[Limits],
        cancel: &Run,
    ) -> Result<()> {
        let outcome = self.run(
            (scene, 0),
            (x, limits),
            None,
            &mut SoFar::default(),
            &mut Silent,
            cancel,
        )?;
        match outcome.reason {
            StopReason::Canceled => Err(Error::Canceled),
            _ => Ok(()),
        }
    }

    /// IoU, VER, mean deviation (mm) and Γ of every output.
    fn qualities(&self, x: &HostField, cancel: &Run) -> Result<Vec<[f64; 4]>> {
        let mut dose = self.model.new_dose()?;
        self.model.dose(x, &mut dose, cancel)?;
        let voxels = self.all_voxels();
        let outputs = self.model.outputs().iter().enumerate();
        let of_output = outputs.map(|(i, layout)| {
            let voxels = voxels.get(i).unwrap_or(&voxels[0]);
            let dose: Volume<f32> = layout.volume_of(dose.as_slice());
            let print = Print::under(&voxels.labels, &dose, cancel.aside())?
                .with_inside(&voxels.target.inside)?;
            let measure = |kind: &MetricKind| kind.metric.measure(&print).unwrap_or(f64::NAN);
            Ok([
                &iou::KIND,
                &ver::KIND,
                &surface_deviation::MEAN,
                &gamma::KIND,
            ]
            .map(measure))
        });
        let found = of_output.collect::<Result<Vec<_>>>()?;
        cancel.check()?;
        Ok(found)
    }
}
