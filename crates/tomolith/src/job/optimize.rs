//! The optimization of a job: from voxels to patterns.

use super::heights;
use super::in_time::planned_in_time;
use super::levels::{self, Levelled};
use super::progress::{Event, Progress};
use super::refinement::{self, Level};
use super::resume::{begin_anew, fingerprint, keep, resumes, tables};
use super::scenarios;
use super::scene::{Scene, Voxels, at_section};
use super::spec::JobSpec;
use super::species::{Row as SpeciesRow, beginnings, planned};
use crate::error::{Error, Result};
use crate::field::{Field, HostField};
use crate::grid::{PatternGrid, Patterns, Volume, VolumeGrid};
use crate::metrics::quick::quick;
use crate::metrics::scan::Scan;
use crate::models::masked::{darken, pixels_through};
use crate::models::scenarios::SharedModel;
use crate::models::sharded::Sharded;
use crate::models::{DoseLayout, DoseModel, OpticalScene, PatternLayout, Quantity, Run};
use crate::objective::{FoundWindow, Objective, PerBlock, Sum};
use crate::optimize::start::given::Given;
use crate::optimize::start::{InitialPatterns, StartInput};
use crate::optimize::{
    self, Checkpoints, Counters, Limits, Observer, Outcome, Problem, Room, Row, StepReport, Stop,
    StopReason,
};
use crate::response::Response;
use crate::units::concise;
use rayon::prelude::*;
use std::borrow::Cow;
use std::ops::ControlFlow;
use std::path::Path;
use std::sync::Arc;
use std::time::Instant;

/// What an optimization came to.
pub(crate) struct Optimized {
    /// Per light, before quantization.
    pub(crate) raw: Vec<Patterns>,
    /// Loss, history, why it ended.
    pub(crate) outcome: Outcome,
    /// Which model, and why.
    pub(crate) model: String,
    /// Voxel-angle updates of one model call.
    pub(crate) updates: u64,
    /// Metrics on the own grid, where they were measured.
    qualities: Vec<Quality>,
    /// How long measuring them took, s.
    pub(crate) metrics_s: f64,
    /// The patterns on few levels of the machine, where they were improved on them.
    pub(crate) levels: Option<Levelled>,
    /// How long that took, s.
    pub(crate) levels_s: f64,
    /// The process window of the patterns before they are written, where an objective looks for it.
    pub(crate) window: Option<FoundWindow>,
    /// That it did nothing, or could not be kept.
    pub(crate) warnings: Vec<String>,
}

impl Optimized {
    /// By how much the IoU on the level's voxels rose over the last quarter of the iterations; None where it was not measured.
    pub(crate) fn gain_in_the_end(&self) -> Option<f64> {
        let last = self.qualities.last()?;
        let begin = last.iteration - last.iteration.div_ceil(4);
        let before = self.qualities.iter().rfind(|q| q.iteration <= begin)?;
        Some(last.iou? - before.iou?)
    }

    /// The metrics after an iteration, where they were measured.
    pub(crate) fn quality_at(&self, iteration: usize) -> Option<Quality> {
        self.qualities
            .iter()
            .copied()
            .find(|q| q.iteration == iteration)
    }
}

/// Metrics after an iteration.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Quality {
    iteration: usize,
    pub(crate) iou: Option<f64>,
    pub(crate) process_window: Option<f64>,
}

/// Runs the optimizer of a job, or goes on from the checkpoint in its folder.
///
/// # Errors
/// [`Error::Canceled`] and [`Error::NonFinite`] leave the best patterns so far in the checkpoint folder.
pub(crate) fn optimize(
    scene: &Scene,
    voxels: &Voxels,
    place: &Path,
    resume: bool,
    progress: &mut dyn Progress,
    cancel: &Run,
) -> Result<Optimized> {
    let tables = tables(&scene.spec)?;
    let fingerprint = scene.agreed(fingerprint(&tables, voxels, &scene.base))?;
    scene.must_agree(fingerprint)?;
    let mut checkpoints =
        Checkpoints::new(place, fingerprint, &scene.spec.checkpoint)?.describing(tables);
    let resumed = if resume || scene.is_first() {
        resumes(&checkpoints, resume, progress)
    } else {
        Ok(None)
    };
    let resumed = scene.agreed(resumed)?;
    if resumed.is_none() {
        checkpoints.begin_anew();
    }
    let job_start = scene.start()?;
    let mut carried: Option<Vec<Patterns>> = None;
    let mut bounds = Vec::new();
    let mut pixels: Option<Vec<&PatternGrid>> = None;
    let mut sofar = SoFar::default();
    let own_levels = scene.own_levels();
    for (i, (level, own_level)) in scene.levels.iter().zip(own_levels.as_ref()).enumerate() {
        let is_last = i + 1 == scene.levels.len();
        let stage = scene.agreed(Stage::new(scene, voxels, own_level, progress, cancel))?;
        let stage = stage.shared(scene);
        if i == 0 {
            let text = stage.reason.clone();
            progress.event(&Event::Note { text });
        }
        let mut start = None;
        let own = level.lights.iter().map(|light| &light.pixels).collect();
        if pixels.as_ref() != Some(&own) {
            let given = scene.own_start(level)?;
            let job_start = given
                .as_ref()
                .map_or(job_start.as_ref(), |given| given as _);
            let mut x = stage.start(scene, job_start, cancel)?;
            bounds = match scene.kinds.bounding_start()? {
                None => stage.limits(scene, &x)?,
                Some(own) => {
                    let own = stage.start(scene, own.as_ref(), cancel)?;
                    let bounds = stage.limits(scene, &own)?;
                    sofar.first_loss = stage.first_loss(scene, &own, cancel)?;
                    clip(&mut x, stage.model.patterns(), &bounds)?;
                    bounds
                }
            };
            if scene.kinds.scales_start() && resumed.is_none() {
                stage.brighten(scene, &mut x, &bounds, cancel)?;
            }
            (start, pixels) = (Some(x), Some(own));
        }
        if resumed.is_some_and(|at| i < at) {
            continue;
        }
        let mut x = match (carried.take(), start) {
            (None, Some(x)) => x,
            (None, None) => stage.model.new_patterns()?,
            (Some(raw), _) => {
                let given = Given(scene.own_patterns(level, raw));
                stage.start(scene, &given, cancel)?
            }
        };
        checkpoints.begin_level(i);
        if let Some(shares) = scene.shares(level, stage.model.patterns()) {
            checkpoints.share(shares);
        }
        let ran = stage.run_and_widen(
            scene,
            (&mut x, &bounds),
            &mut checkpoints,
            &mut sofar,
            progress,
            cancel,
        );
        let goes_on = matches!(&ran, Ok(outcome) if outcome.reason != StopReason::Canceled);
        let raw = stage.patterns(&mut x);
        let raw = scene.whole_patterns(level, raw, goes_on && !is_last);
        match ran {
            Ok(outcome) if outcome.reason == StopReason::Canceled => {
                keep(scene, &raw, place, progress, cancel)?;
                return Err(at_section("optimizer", Error::Canceled));
            }
            Ok(outcome) if is_last => {
                let normalizes = scene.optimizer()?.normalizes();
                let mut warnings = sofar.warnings;
                if let Some(text) = idle(&outcome.history, normalizes, scene.spec.bounds.bits) {
                    warnings.push(text.clone());
                    progress.event(&Event::Warning { text });
                }
                let window = stage.window(scene, &x, cancel)?;
                if let Some(text) = window.and_then(|window| window.warning()) {
                    warnings.push(text.clone());
                    progress.event(&Event::Warning { text });
                }
                let begin = Instant::now();
                let levels = match stage.improve(scene, &x, &bounds, progress, cancel) {
                    Ok(levels) => levels,
                    Err(error) => {
                        keep(scene, &raw, place, progress, cancel)?;
                        return Err(at_section("optimizer", error));
                    }
                };
                let raw = stage.levelled(scene, raw, progress, cancel)?;
                return Ok(Optimized {
                    raw,
                    levels,
                    levels_s: begin.elapsed().as_secs_f64(),
                    outcome,
                    updates: stage.model.updates(),
                    model: stage.reason,
                    qualities: sofar.qualities,
                    metrics_s: sofar.metrics_s,
                    window,
                    warnings,
                });
            }
            Ok(outcome) => {
                sofar.rows = outcome.history;
                sofar.counters = outcome.counters;
                carried = Some(raw);
            }
            // A checkpoint that does not fit: nothing was done
            Err(error @ Error::Format { .. }) => return Err(begin_anew(error)),
            Err(error) => {
                keep(scene, &raw, place, progress, cancel)?;
                return Err(at_section("optimizer", error));
            }
        }
    }
    unreachable!("a job has a level")
}

/// What the levels before have done.
#[derive(Default)]
struct SoFar {
    rows: Vec<Row>,
    counters: Counters,
    qualities: Vec<Quality>,
    metrics_s: f64,
    warnings: Vec<String>,
    /// The loss that counts as the first one, where it is not that of the start.
    first_loss: Option<f64>,
}

/// One level, ready to be optimized.
pub(super) struct Stage<'a> {
    level: &'a Level,
    pub(super) voxels: Cow<'a, Voxels>,
    /// Those of further species.
    others: Vec<Voxels>,
    pub(super) model: Box<dyn DoseModel<Field = HostField>>,
    straight: Option<Box<dyn DoseModel<Field = HostField>>>,
    /// That of the job as it is, where `model` is that of all scenarios.
    nominal: Option<SharedModel>,
    /// Pixels that stay dark.
    dark: Vec<bool>,
    /// Which model, and why.
    reason: String,
}

impl<'a> Stage<'a> {
    pub(super) fn new(
        scene: &Scene,
        voxels: &'a Voxels,
        level: &'a Level,
        progress: &mut dyn Progress,
        cancel: &Run,
    ) -> Result<Self> {
        let voxels = if level.grid == scene.grid {
            Cow::Borrowed(voxels)
        } else {
            Cow::Owned(scene.voxels_under(&level.grid, &cancel.aside())?)
        };
        let others = scene.others.iter();
        let others = others.map(|other| other.voxels_under(&level.grid, &cancel.aside()));
        let others = others.collect::<Result<Vec<_>>>()?;
        let all: Vec<&Voxels> = std::iter::once(voxels.as_ref()).chain(&others).collect();
        let optics = OpticalScene {
            lights: &level.lights,
            ..scene.optimizing()
        };
        let asked = scene.optics.model.as_ref();
        let plan = if scene.is_optimized_in_time() {
            planned_in_time(scene, (asked, optics), level, &all, cancel)?
        } else {
            planned(scene, asked, optics, &level.grid, Some(&all), cancel)?
        };
        let straight = plan.surrogate.as_deref();
        let known = straight.unwrap_or(&plan.model);
        let of_bodies = dark_pixels(scene, &level.grid, known, progress, cancel)?;
        let mut dark = of_bodies.clone().unwrap_or_else(|| plan.dark.clone());
        for (dark, left_out) in dark.iter_mut().zip(&plan.dark) {
            *dark |= left_out;
        }
        let model = plan.model.and_dark(of_bodies.unwrap_or_default());
        let (model, nominal) = scenarios::joined(scene, model, &dark, level, cancel)?;
        Ok(Stage {
            level,
            voxels,
            others,
            model,
            straight: plan.surrogate,
            nominal,
            dark,
            reason: plan.reason,
        })
    }

    /// The same with the dose of the frames of all ranks, where the scene's frames are shared. Called by all ranks.
    fn shared(mut self, scene: &Scene) -> Self {
        let Some(ranks) = &scene.ranks else {
            return self;
        };
        let of_all = |model| Sharded::new(model, Arc::clone(ranks));
        self.straight = (self.straight).map(|model| Box::new(of_all(model)) as Box<_>);
        self.model = Box::new(of_all(self.model));
        self.reason = format!(
            "{}; its frames are shared by {} ranks",
            self.reason,
            ranks.size()
        );
        self
    }

    pub(super) fn start(
        &self,
        scene: &Scene,
        start: &dyn InitialPatterns,
        cancel: &Run,
    ) -> Result<HostField> {
        let own = self.nominal.as_deref().unwrap_or(self.model.as_ref());
        let models = (own, self.straight.as_deref());
        let mut x = starting_patterns(scene, &self.all_voxels(), models, start, cancel)?;
        darken(x.as_mut_slice(), &self.dark);
        Ok(x)
    }

    /// The loss of the start that bounds the pixels, where a run ends at a part of it.
    fn first_loss(&self, scene: &Scene, own: &HostField, cancel: &Run) -> Result<Option<f64>> {
        if scene.spec.stop.relative_loss.is_none() {
            return Ok(None);
        }
        let mut dose = self.model.new_dose()?;
        self.model.dose(own, &mut dose, cancel)?;
        Ok(Some(self.objective(scene, 0)?.value(&dose)))
    }

    /// Takes the patterns with the lowest loss, of those given and further files, each as bright as suits the objective best; for doses that are linear in
    /// them. One dose call each, two where the bounds hold what would be brighter.
    fn brighten(
        &self,
        scene: &Scene,
        x: &mut HostField,
        bounds: &[Limits],
        cancel: &Run,
    ) -> Result<()> {
        if !self.model.is_linear() {
            return Ok(());
        }
        let objective = self.objective(scene, 0)?;
        let mut dose = self.model.new_dose()?;
        let mut lowest = f64::INFINITY;
        let further = match scene.ranks {
            None => scene.kinds.further_starts(),
            Some(_) => Vec::new(),
        };
        let mut candidate = x.clone();
        for next in std::iter::once(None).chain(further.iter().map(Some)) {
            if let Some(file) = next {
                candidate = self.start(scene, file, cancel)?;
                clip(&mut candidate, self.model.patterns(), bounds)?;
            }
            let both = (&mut candidate, &mut dose);
            let loss = self.scale(&objective, both, bounds, cancel)?;
            if loss < lowest {
                lowest = loss;
                x.clone_from(&candidate);
            }
            if lowest == 0.0 {
                break;
            }
        }
        Ok(())
    }

    /// Multiplies patterns by the factor with which their loss is lowest, unless the bounds spoil it; that loss.
    #[expect(clippy::cast_possible_truncation, reason = "fields are f32")]
    fn scale(
        &self,
        objective: &Sum<HostField>,
        (x, dose): (&mut HostField, &mut HostField),
        bounds: &[Limits],
        cancel: &Run,
    ) -> Result<f64> {
        self.model.dose(x, dose, cancel)?;
        let own = objective.value(dose);
        let (factor, mut loss) = optimize::brightness::lowest(&|factor| {
            let mut scaled = dose.clone();
            scaled.scale(factor as f32);
            objective.value(&scaled)
        });
        let mut scaled = x.clone();
        scaled.scale(factor as f32);
        let mut within = scaled.clone();
        clip(&mut within, self.model.patterns(), bounds)?;
        // Ranks ask for a dose together
        if x.any(within.as_slice() != scaled.as_slice()) {
            self.model.dose(&within, dose, cancel)?;
            loss = objective.value(dose);
        }
        if loss < own {
            *x = within;
        }
        Ok(loss.min(own))
    }

    /// The voxels of every species.
    fn all_voxels(&self) -> Vec<&Voxels> {
        std::iter::once(self.voxels.as_ref())
            .chain(&self.others)
            .collect()
    }

    /// The loss of all species; with thresholds that lie so many steps further apart than those of the job.
    pub(super) fn objective(&self, scene: &Scene, wider: usize) -> Result<Sum<HostField>> {
        let outputs = self.model.outputs();
        let own = |scene: &Scene, layout: &DoseLayout, voxels: &Voxels| {
            let wider = match wider {
                0 => None,
                steps => refinement::widened(&scene.kinds, steps),
            };
            scene.objective(wider.as_ref().unwrap_or(&scene.kinds), layout, voxels)
        };
        if outputs.len() == 1 {
            return own(scene, &outputs[0], &self.voxels);
        }
        // Scenarios ask the same of every output
        let same = (scene, self.voxels.as_ref());
        let of_species = scene.species().zip(self.all_voxels());
        let asked = of_species.chain(std::iter::repeat_n(same, scene.scenarios.len()));
        let mut parts: Vec<(&DoseLayout, Box<dyn Objective<HostField>>)> = Vec::new();
        for ((scene, voxels), layout) in asked.zip(outputs) {
            let alone = DoseLayout {
                offset: 0,
                ..layout.clone()
            };
            parts.push((layout, Box::new(own(scene, &alone, voxels)?)));
        }
        let joined = PerBlock::new(parts, scenarios::join(&scene.spec));
        Sum::new(vec![(1.0, Box::new(joined))])
    }

    pub(super) fn limits(&self, scene: &Scene, start: &HostField) -> Result<Vec<Limits>> {
        let normalizes = scene.optimizer()?.normalizes();
        Ok(limits(&scene.spec, self.model.as_ref(), start, normalizes))
    }

    /// The process window of patterns, where an objective looks for it.
    fn window(&self, scene: &Scene, x: &HostField, cancel: &Run) -> Result<Option<FoundWindow>> {
        if !scene.kinds.seeks_window() {
            return Ok(None);
        }
        let mut dose = self.model.new_dose()?;
        self.model.dose(x, &mut dose, &cancel.aside())?;
        Ok(self.objective(scene, 0)?.window(&dose))
    }

    /// The patterns in `x`, whose pixels that are to stay dark are made dark.
    fn patterns(&self, x: &mut HostField) -> Vec<Patterns> {
        darken(x.as_mut_slice(), &self.dark);
        levels::patterns(self.model.patterns(), x)
    }

    /// The patterns with rows rescaled so that all heights are done at once, where the job asks for it.
    fn levelled(
        &self,
        scene: &Scene,
        raw: Vec<Patterns>,
        progress: &mut dyn Progress,
        cancel: &Run,
    ) -> Result<Vec<Patterns>> {
        let asked = scene
            .spec
            .schedule
            .as_ref()
            .is_some_and(|s| s.level_heights);
        if !asked {
            return Ok(raw);
        }
        let own = scene.species().map(|species| species.voxels(&scene.grid));
        let own = own.collect::<Result<Vec<_>>>()?;
        let voxels: Vec<&Voxels> = own.iter().collect();
        heights::level(scene, &voxels, raw, progress, cancel)
    }

    /// The patterns on few levels of the machine, where the job has few.
    fn improve(
        &self,
        scene: &Scene,
        x: &HostField,
        bounds: &[Limits],
        progress: &mut dyn Progress,
        cancel: &Run,
    ) -> Result<Option<Levelled>> {
        let model = self.model.as_ref();
        let objective = self.objective(scene, 0)?;
        let mut problem = Problem::new(model, &objective, bounds, cancel)?
            .with_penalties(scene.penalties(model.patterns())?);
        levels::improve(scene, &mut problem, x, progress)
    }

    /// Runs the optimizer on this level, and goes on with a wider window where the loss becomes 0 before the iterations are over.
    fn run_and_widen(
        &self,
        scene: &Scene,
        (x, bounds): (&mut HostField, &[Limits]),
        checkpoints: &mut Checkpoints,
        sofar: &mut SoFar,
        progress: &mut dyn Progress,
        cancel: &Run,
    ) -> Result<Outcome> {
        let own = (scene, 0);
        let mut outcome = self.run(own, (x, bounds), Some(checkpoints), sofar, progress, cancel)?;
        for steps in 1.. {
            let at = outcome.history.last().map_or(0, |row| row.iteration);
            if outcome.reason != StopReason::ZeroLoss || at >= self.level.until {
                break;
            }
            let mut widened = false;
            for species in scene.species() {
                widened |= refinement::widened(&species.kinds, steps).is_some();
            }
            if !widened {
                break;
            }
            progress.event(&Event::Note {
                text: format!("every voxel is within its thresholds after iteration {at}: the thresholds now move {} further apart", concise(refinement::WIDER * steps as f64)),
            });
            sofar.rows = outcome.history;
            sofar.counters = outcome.counters;
            outcome = self.run((scene, steps), (x, bounds), None, sofar, progress, cancel)?;
        }
        Ok(outcome)
    }

    /// Runs the optimizer on this level, after the iterations of those before.
    fn run(
        &self,
        (scene, wider): (&Scene, usize),
        (x, bounds): (&mut HostField, &[Limits]),
        checkpoints: Option<&mut Checkpoints>,
        sofar: &mut SoFar,
        progress: &mut dyn Progress,
        cancel: &Run,
    ) -> Result<Outcome> {
        let model = self.model.as_ref();
        // What is watched on the way is the first species, the part
        let layout = model.outputs()[0].clone();
        let objective = self.objective(scene, wider)?;
        let spec = &scene.spec;
        let mut optimizer = scene.optimizer()?;
        let mut problem = Problem::new(model, &objective, bounds, cancel)?
            .with_penalties(scene.penalties(model.patterns())?)
            .with_bits(spec.bounds.bits)?;
        let response = scene.response();
        let input = start_input(model, &self.voxels, response.as_ref(), &[]);
        if optimizer.requirements().target.is_some() {
            problem = problem.with_target(input.target_field()?);
        }
        if optimizer.requirements().edges.is_some() {
            problem = problem.with_edges(input.edge_field()?);
        }
        problem.counters = sofar.counters;
        let stop = Stop {
            iterations: self.level.until,
            projected_gradient: spec.stop.projected_gradient.unwrap_or(0.0),
            change: spec.stop.change.unwrap_or(0.0),
            gap: spec.stop.gap.unwrap_or(0.0),
            relative_loss: spec.stop.relative_loss.unwrap_or(0.0),
            first_loss: sofar.first_loss,
            seconds: spec.stop.wall_s,
            keep: spec.stop.keep,
        };
        let mut labels = layout.field_of(&self.voxels.labels);
        labels.truncate(layout.voxels());
        let mut watch = Watch {
            scene,
            iterations: scene.levels.last().map_or(0, |level| level.until),
            updates: model.updates(),
            labels,
            layout,
            is_gray: self.voxels.target.gray,
            qualities: std::mem::take(&mut sofar.qualities),
            metrics_s: sofar.metrics_s,
            warnings: std::mem::take(&mut sofar.warnings),
            progress,
        };
        let ran = optimize::run_after(
            std::mem::take(&mut sofar.rows),
            &mut problem,
            optimizer.as_mut(),
            x,
            &stop,
            checkpoints,
            &mut [&mut watch],
        );
        (sofar.qualities, sofar.metrics_s) = (watch.qualities, watch.metrics_s);
        sofar.warnings = watch.warnings;
        ran
    }
}

/// What to say when no step was better than the start, whose patterns are then the result. A method that normalizes its doses
/// begins with its first step, and is idle when its loss never changes.
fn idle(history: &[Row], normalizes: bool, bits: Option<u32>) -> Option<String> {
    let (start, steps) = history.get(usize::from(normalizes)..)?.split_first()?;
    let moves = |row: &Row| row.loss < start.loss || normalizes && row.loss != start.loss;
    if steps.is_empty() || start.loss == 0.0 || steps.iter().any(moves) {
        return None;
    }
    let why = bits.map_or_else(
        || "a shorter step or another start may help".to_owned(),
        |bits| {
            format!(
                "bounds.bits = {bits} rounds changes below half a level away: more bits or a longer step may help"
            )
        },
    );
    Some(format!(
        "no step lowered the loss, the patterns are those of the start; {why}"
    ))
}

/// The pixels whose light would pass a body that is to stay dark, when there is one.
///
/// # Errors
/// [`Error::Config`] when that leaves no pixel.
fn dark_pixels(
    scene: &Scene,
    grid: &VolumeGrid,
    model: &dyn DoseModel<Field = HostField>,
    progress: &mut dyn Progress,
    cancel: &Run,
) -> Result<Option<Vec<bool>>> {
    let Some(shares) = scene.keep_dark(grid)? else {
        return Ok(None);
    };
    let places = Volume {
        values: shares.values.iter().map(|&share| share >= 0.5).collect(),
        grid: shares.grid,
    };
    let dark = pixels_through(model, &places, cancel)?;
    let (count, all) = (dark.iter().filter(|dark| **dark).count(), dark.len());
    if count == all {
        return Err(Error::config(
            "target.body",
            "every pixel that lights the part lights a keep-dark body too",
            "a keep-dark body that leaves light a path to the part",
        ));
    }
    let share = 100.0 * count as f64 / all as f64;
    progress.event(&Event::Note {
        text: format!(
            "{share:.1} % of the pixels stay dark: their light would pass a keep-dark body"
        ),
    });
    Ok(Some(dark))
}

/// What a start or a method's marks are computed from.
fn start_input<'a>(
    model: &'a dyn DoseModel<Field = HostField>,
    voxels: &'a Voxels,
    response: &'a dyn Response,
    limits: &'a [Limits],
) -> StartInput<'a> {
    StartInput {
        model,
        target: &voxels.target,
        labels: &voxels.labels,
        response,
        limits,
    }
}

/// Part of the mean energy of lit pixels that every pixel has at the start of amplitudes: one that is dark, and lights nothing with
/// others together, would stay dark for ever.
const GLIMMER: f64 = 0.01;

/// Where the optimization begins: within the bounds that the job gives. A model whose unknowns are amplitudes begins at the
/// roots of what straight light would begin with.
pub(super) fn starting_patterns(
    scene: &Scene,
    voxels: &[&Voxels],
    (model, straight): (
        &dyn DoseModel<Field = HostField>,
        Option<&dyn DoseModel<Field = HostField>>,
    ),
    start: &dyn InitialPatterns,
    cancel: &Run,
) -> Result<HostField> {
    let bounds = &scene.spec.bounds;
    let given = scene.spec.light.iter().map(|light| Limits {
        min: light.bounds.min.unwrap_or(bounds.min),
        max: light.bounds.max.or(bounds.max).unwrap_or(f64::INFINITY),
    });
    let limits: Vec<Limits> = given.collect();
    let response = scene.response();
    let input = |model| start_input(model, voxels[0], response.as_ref(), &limits);
    let known = straight.unwrap_or(model);
    let mut x = match scene.rows() {
        Some(rows) if !start.is_given() => {
            starting_lights(scene, (&rows, voxels), known, start, (&limits, cancel))?
        }
        _ => start.patterns(&input(known), cancel)?,
    };
    if model.patterns()[0].quantity == Quantity::Energy {
        return Ok(x);
    }
    into_amplitudes(&mut x, GLIMMER)?;
    if start.is_given() && scene.kinds.starts_as_given() {
        return Ok(x);
    }
    // A pupil takes light that rays would have brought
    input(model).scaled_anew(x, cancel)
}

/// Brings patterns into bounds.
fn clip(x: &mut HostField, lights: &[PatternLayout], bounds: &[Limits]) -> Result<()> {
    let bounds = x.compile_bounds(&optimize::problem::bounds(lights, bounds)?);
    let step = x.zeros_like();
    x.move_along(&step, 0.0, &bounds);
    Ok(())
}

/// Where each light begins: with the species that it drives most, as if it were alone.
fn starting_lights(
    scene: &Scene,
    (rows, voxels): (&[SpeciesRow], &[&Voxels]),
    model: &dyn DoseModel<Field = HostField>,
    start: &dyn InitialPatterns,
    (limits, cancel): (&[Limits], &Run),
) -> Result<HostField> {
    let mut x = model.new_patterns()?;
    let scenes: Vec<&Scene> = scene.species().collect();
    for (i, begins) in beginnings(rows).into_iter().enumerate() {
        let (Some((s, factor)), Some(alone)) = (begins, model.of_light(i)) else {
            continue;
        };
        let response = scenes[s].response();
        let input = start_input(alone, voxels[s], response.as_ref(), &limits[i..=i]);
        let mut own = start.patterns(&input, cancel)?;
        own.scale((factor * scene.dose_needed(s, i)?) as f32);
        x.as_mut_slice()[model.patterns()[i].range()].copy_from_slice(own.as_slice());
    }
    Ok(x)
}

/// Energies → amplitudes, none of them dark.
///
/// # Errors
/// [`Error::Config`] when all are dark: no step leads away from there.
fn into_amplitudes(x: &mut HostField, glimmer: f64) -> Result<()> {
    let lit = x.as_slice().iter().filter(|&&v| v > 0.0);
    let (count, sum) = lit.fold((0.0, 0.0), |(n, s), &v| (n + 1.0, s + f64::from(v)));
    let (count, sum) = (x.total(count), x.total(sum));
    if count == 0.0 {
        return Err(Error::config(
            "start",
            "patterns that are dark everywhere",
            "a start that is not dark: the gradient of [model.wave] is zero at dark patterns",
        ));
    }
    let least = glimmer * sum / count;
    for value in x.as_mut_slice() {
        *value = f64::from(*value).max(least).sqrt() as f32;
    }
    Ok(())
}

/// The bounds of every light. Where the job sets no upper one it is the largest pixel of the start: without a bound a few
/// pixels at the silhouette grow far beyond all others, and the projector's gray levels are spent on them. A method that
/// normalizes its doses has a scale of its own, to which the start says nothing.
pub(super) fn limits(
    spec: &JobSpec,
    model: &dyn DoseModel<Field = HostField>,
    start: &HostField,
    normalizes: bool,
) -> Vec<Limits> {
    let quantity = model.patterns()[0].quantity;
    let of_all = start.max_abs();
    let alone = |layout: &PatternLayout| {
        let own = &start.as_slice()[layout.range()];
        let own = own.iter().fold(0.0f32, |most, v| most.max(v.abs()));
        // A light that begins dark may become as bright as the others
        if own > 0.0 { own } else { of_all }
    };
    let lights = model.patterns().iter().zip(&spec.light);
    let limits = lights.map(|(layout, light)| {
        let largest = if spec.species.is_empty() {
            of_all
        } else {
            alone(layout)
        };
        let largest = f64::from(quantity.energy(largest));
        let min = light.bounds.min.unwrap_or(spec.bounds.min);
        let natural = if largest > min && !normalizes {
            largest
        } else {
            f64::INFINITY
        };
        let max = light.bounds.max.or(spec.bounds.max);
        Limits {
            min,
            max: max.unwrap_or(natural),
        }
    });
    limits.collect()
}

/// Iterations that are measured before only every second one is, and again before every fourth, and so on.
const MEASURED: usize = 8;

/// Whether the print is measured after an iteration: the start, each up to 8, every second up to 16, every fourth up to
/// 32, …: at least ten points for any run of ten iterations, and seldom enough to cost less than 2 % of the time.
fn is_measured(iteration: usize) -> bool {
    let step = (iteration.saturating_sub(1) / MEASURED + 1).next_power_of_two();
    iteration.is_multiple_of(step)
}

/// Tells progress, measures the print now and then, and stops at the loss or IoU that was asked for.
struct Watch<'a> {
    scene: &'a Scene,
    /// Iterations of all levels.
    iterations: usize,
    updates: u64,
    /// Labels in the order of the dose field's voxels; the padding is outside.
    labels: Vec<u8>,
    /// Where those lie.
    layout: DoseLayout,
    /// A gray target has no IoU worth following.
    is_gray: bool,
    qualities: Vec<Quality>,
    metrics_s: f64,
    warnings: Vec<String>,
    progress: &'a mut dyn Progress,
}

impl Watch<'_> {
    fn reached(&mut self, report: &StepReport<'_, HostField>) -> bool {
        let stop = &self.scene.spec.stop;
        let (loss, asked) = (stop.loss, stop.iou);
        let begin = Instant::now();
        let quality = self.measure(report, asked.is_some());
        self.metrics_s += begin.elapsed().as_secs_f64();
        let enough = asked
            .zip(quality.and_then(|q| q.iou))
            .is_some_and(|(asked, iou)| iou >= asked);
        report.row.loss <= loss || enough
    }

    /// Metrics of the dose at hand: exact and always when they decide, else now and then, and over some thresholds only.
    fn measure(&mut self, report: &StepReport<'_, HostField>, decides: bool) -> Option<Quality> {
        let iteration = report.row.iteration;
        let last = iteration == self.iterations;
        if !(decides || !self.is_gray && (last || is_measured(iteration))) {
            return None;
        }
        let response = self.scene.response();
        let dose = self.layout.voxels_of(report.dose.as_slice());
        let values: Cow<'_, [f32]> = if response.is_identity() {
            dose
        } else {
            Cow::Owned(dose.par_iter().map(|&d| response.value(d)).collect())
        };
        let quality = if decides {
            exact(iteration, &self.labels, &values)
        } else {
            quick(&self.labels, &values).map(|(iou, process_window)| Quality {
                iteration,
                iou: Some(iou),
                process_window,
            })
        };
        self.qualities.extend(quality);
        quality
    }
}

/// Metrics over all thresholds.
fn exact(iteration: usize, labels: &[u8], response: &[f32]) -> Option<Quality> {
    let scan = Scan::new(labels, response).ok()?;
    let (part, void) = (scan.part(), scan.void());
    Some(Quality {
        iteration,
        iou: scan.best_plateau().map(|plateau| plateau.iou),
        process_window: part
            .zip(void)
            .map(|(part, void)| f64::from(part.min) - f64::from(void.max)),
    })
}

impl Observer<HostField> for Watch<'_> {
    fn on_step(&mut self, report: &StepReport<'_, HostField>) -> ControlFlow<()> {
        let row = report.row;
        let calls = (row.forward + row.adjoint) as f64;
        self.progress.event(&Event::Iteration {
            iteration: row.iteration,
            iterations: self.iterations,
            loss: row.loss,
            projected_gradient: report.relative_gradient,
            elapsed_s: row.seconds,
            updates_per_s: calls * self.updates as f64 / report.counters.model_s.max(1e-9),
        });
        if self.reached(report) {
            ControlFlow::Break(())
        } else {
            ControlFlow::Continue(())
        }
    }

    fn on_room(&mut self, room: &Room) {
        match room {
            Room::None(error) => {
                let text = format!(
                    "no checkpoint can be written ({error}): the run goes on, but a crash or Ctrl-C would lose its work; \
                     free some disk space, and checkpoints will be written again"
                );
                self.warnings.push(text.clone());
                self.progress.event(&Event::Warning { text });
            }
            Room::Again => {
                let text = "disk space is free again: a checkpoint was written".to_owned();
                self.progress.event(&Event::Note { text });
            }
        }
    }
}

impl Scene {
    /// Name of a light for files: none when there is only one.
    pub(crate) fn light_name(&self, i: usize) -> Option<&str> {
        if self.spec.light.len() == 1 {
            None
        } else {
            self.spec.light[i].name.as_deref()
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::job::Job;
    use crate::models::planner;

    #[test]
    fn a_run_that_stayed_at_its_start_says_so() {
        let history = |losses: &[f64]| -> Vec<Row> {
            let row = |(iteration, &loss): (usize, &f64)| Row {
                iteration,
                loss,
                projected_gradient: None,
                step: None,
                forward: 0,
                adjoint: 0,
                seconds: 0.0,
            };
            losses.iter().enumerate().map(row).collect()
        };
        assert_eq!(idle(&history(&[2.0, 3.0, 1.9]), false, None), None);
        assert_eq!(idle(&history(&[2.0]), false, Some(4)), None);
        assert_eq!(idle(&history(&[0.0, 0.0]), false, None), None);
        let said = idle(&history(&[2.0, 2.0, 2.5]), false, Some(4)).unwrap();
        assert!(said.contains("bounds.bits = 4"), "{said}");
        // Row 0 of a method with a start and a scale of its own says nothing of its steps
        assert_eq!(idle(&history(&[2.0, 9.0, 9.5]), true, None), None);
        assert!(idle(&history(&[2.0, 9.0, 9.0]), true, None).is_some());
        assert_eq!(idle(&history(&[2.0]), true, None), None);
    }

    /// A job whose light spreads: its voxels, its models, and where it begins.
    fn started(model: &str) -> (Voxels, planner::ModelPlan, HostField) {
        let folder = tempfile::tempdir().unwrap();
        let file = folder.path().join("job.toml");
        let text = format!(
            r#"
            target = {{ phantom = {{ sphere = {{}} }}, size_mm = 0.02 }}
            grid = {{ pitch_mm = 0.001 }}
            resin = {{ refractive_index = 1.5, pure_radon = true }}
            vial = {{ index_matched = {{ radius_mm = 0.02 }} }}
            light = [{{ wavelength_nm = 405, pixels = [36, 24], angles = 24,
                projector = {{ collimated = {{ pixel_pitch_mm = 0.001 }} }} }}]
            model = {model}
            objective = {{ threshold = {{ lower = 0.7, upper = 0.9 }} }}
            optimizer = {{ lbfgs = {{}} }}
            stop = {{ iterations = 1 }}
            "#
        );
        std::fs::write(&file, text).unwrap();
        let job = Job::read(&file, &[]).unwrap();
        let scene = Scene::new(&job, &Run::new()).unwrap();
        let voxels = scene.voxels(&scene.grid).unwrap();
        let (asked, wanted) = (scene.optics.model.as_ref(), voxels.wanted());
        let (optics, run) = (scene.optimizing(), Run::new());
        let plan = planner::plan(asked, optics, &scene.grid, Some(&wanted), &run).unwrap();
        let models = (&plan.model as _, plan.surrogate.as_deref());
        let start = scene.start().unwrap();
        let x = starting_patterns(&scene, &[&voxels], models, start.as_ref(), &Run::new()).unwrap();
        (voxels, plan, x)
    }

    /// Dose of a model at the voxels of the part.
    fn in_part(
        model: &dyn DoseModel<Field = HostField>,
        x: &HostField,
        voxels: &Voxels,
    ) -> Vec<f64> {
        let mut dose = model.new_dose().unwrap();
        model.dose(x, &mut dose, &Run::new()).unwrap();
        let dose = model.outputs()[0].volume_of(dose.as_slice());
        let all = dose.values.iter().zip(&voxels.labels.values);
        let own = all.filter(|(_, label)| **label == crate::target::label::PART);
        own.map(|(dose, _)| f64::from(*dose)).collect()
    }

    /// Σd / Σd²: 1 where no other factor brings doses nearer to 1.
    fn factor(doses: &[f64]) -> f64 {
        doses.iter().sum::<f64>() / doses.iter().map(|d| d * d).sum::<f64>()
    }

    #[test]
    fn a_start_of_waves_brings_the_dose_that_is_wanted_whatever_the_pupil_takes() {
        for model in ["{ wave = {} }", "{ wave = { numerical_aperture = 0.02 } }"] {
            let (voxels, plan, x) = started(model);
            let found = factor(&in_part(&plan.model, &x, &voxels));
            assert!((found - 1.0).abs() < 1e-5, "{model}: {found}");
            let mut energies = x.clone();
            for value in energies.as_mut_slice() {
                *value *= *value;
            }
            let straight = plan.surrogate.as_deref().unwrap();
            let rays = factor(&in_part(straight, &energies, &voxels));
            let off = (rays - 1.0).abs();
            // What fades of the pixels' band is little; a narrow pupil takes more
            assert!(
                if model.contains("aperture") {
                    off > 0.1
                } else {
                    off < 0.1
                },
                "{rays}"
            );
        }
    }

    #[test]
    fn a_start_of_light_that_spreads_is_that_of_straight_light_in_energies() {
        let (voxels, plan, x) = started("{ incoherent_cone = { half_angle_deg = 0.5 } }");
        let straight = plan.surrogate.as_deref().unwrap();
        let [own, rays] = [&plan.model as _, straight].map(|m| factor(&in_part(m, &x, &voxels)));
        assert!((rays - 1.0).abs() < 1e-5, "{rays}");
        // Roots of energies would be off by several times
        assert!((own - 1.0).abs() < 0.1, "{own}");
    }

    #[test]
    fn measured_iterations_thin_out_evenly() {
        let measured = |last: usize| (0..=last).filter(|&i| is_measured(i)).collect::<Vec<_>>();
        assert_eq!(
            measured(40),
            [
                0, 1, 2, 3, 4, 5, 6, 7, 8, 10, 12, 14, 16, 20, 24, 28, 32, 40
            ]
        );
        assert!(measured(10).len() >= 10);
        assert_eq!(measured(1024).len(), 1 + 8 + 4 * 7);
    }
}
