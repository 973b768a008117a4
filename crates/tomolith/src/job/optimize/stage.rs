//! One level of the optimization: its voxels, its model, its objective, and the loop on it.

use super::gray_levels::Levelled;
use super::start::{limits, start_input, starting_patterns};
use super::watch::Watch;
use super::{gray_levels, row_balance};
use crate::dose::Space;
use crate::dose::form::Form;
use crate::error::{Error, Result};
use crate::field::{Field, HostField};
use crate::grid::{Patterns, Volume, VolumeGrid};
use crate::job::dose::cache::EvaluationModel;
use crate::job::dose::in_time::planned_in_time;
use crate::job::dose::scenarios::joined;
use crate::job::dose::species::planned;
use crate::job::progress::{Event, Progress};
use crate::job::resolve::card::Card;
use crate::job::resolve::free_parameters::FoundResponse;
use crate::job::resolve::goal::{Goal, Objectives};
use crate::job::resolve::refinement::Level;
use crate::job::resolve::{ResolvedJob, Species, Voxels, refinement, scenarios};
use crate::models::masked::{darken, pixels_through};
use crate::models::rays::Optics;
use crate::models::scenarios::SharedModel;
use crate::models::sharded::Sharded;
use crate::models::{DoseLayout, DoseModel, OpticalScene, Work, planner};
use crate::objective::{FoundWindow, Objective, PerBlock, Sum};
use crate::optimize;
use crate::optimize::start::InitialPatterns;
use crate::optimize::{
    Checkpoints, Counters, Limits, Optimizer, Outcome, Problem, Row, Stop, StopReason,
};
use crate::units::concise;
use std::borrow::Cow;
use std::cell::OnceCell;
use std::sync::Arc;
use std::time::Instant;
#[cfg(feature = "gpu")]
use tomolith_gpu::{GpuField, model_on};

/// Part of what a print may lose in IoU (`bounds.tolerance`) by which it may still rise where the loss is steady.
const RISE: f64 = 0.5;

/// What to say where a card computes doses alone.
const LOOP_HERE: &str = "; the loop around its doses runs on the processor";

/// Bytes that the loop takes on a card, at least, for so many numbers of patterns and of the dose, and pairs of the method.
pub(crate) fn bytes_on_card(patterns: usize, dose: usize, pairs: usize) -> u64 {
    (((pairs + 6) * patterns + 3 * dose) * size_of::<f32>()) as u64
}

/// What the levels before have done.
#[derive(Default)]
pub(crate) struct SoFar {
    pub(crate) rows: Vec<Row>,
    pub(crate) counters: Counters,
    pub(crate) metrics_s: f64,
    pub(crate) warnings: Vec<String>,
    /// The loss that counts as the first one, where it is not that of the start.
    pub(crate) first_loss: Option<f64>,
    /// By how many steps the thresholds lie further apart than those of the job.
    pub(crate) wider: usize,
}

/// What is done with the patterns after the last iteration.
pub(crate) struct EndOfLevel {
    /// On few levels of the machine, where they were improved on them.
    pub(crate) levels: Option<Levelled>,
    /// With rows rescaled so that all heights are done at once, where the job asks for it.
    pub(crate) levelled: Option<Vec<Patterns>>,
    /// How long that took, s.
    pub(crate) seconds: f64,
    /// Their process window, where an objective looks for it.
    pub(crate) window: Option<FoundWindow>,
}

/// What the iterations on a level need besides patterns.
pub(crate) struct Around<'a> {
    /// The iteration to end after, counted from the first of all levels.
    pub(crate) until: usize,
    /// By how many steps the thresholds lie further apart than those of the job.
    pub(crate) wider: usize,
    /// Mean change of the loss at which they end where the job names none; 0: never.
    pub(crate) change: f64,
    pub(crate) bounds: &'a [Limits],
    pub(crate) checkpoints: Option<&'a mut Checkpoints>,
    pub(crate) sofar: &'a mut SoFar,
    pub(crate) progress: &'a mut dyn Progress,
    pub(crate) work: &'a Work,
}

/// One level, ready to be optimized.
pub(crate) struct Stage<'a> {
    pub(crate) job: &'a ResolvedJob,
    pub(crate) level: &'a Level,
    /// Of every species.
    pub(crate) voxels: Cow<'a, [Voxels]>,
    pub(crate) model: SharedModel,
    pub(crate) straight: Option<Box<dyn DoseModel<Field = HostField>>>,
    /// That of the job as it is, where `model` is that of all scenarios.
    pub(crate) nominal: Option<SharedModel>,
    /// Pixels that stay dark; none where it is empty.
    pub(crate) dark: Vec<bool>,
    /// Which model, and why.
    pub(crate) reason: String,
    /// The response that was found, where its parameters are unknowns.
    pub(crate) found: Option<FoundResponse>,
    /// Finer voxels on which ceilings are judged, once they are needed.
    pub(crate) finer: OnceCell<Vec<Voxels>>,
}

impl Around<'_> {
    /// The same for some further iterations.
    fn again(&mut self) -> Around<'_> {
        Around {
            checkpoints: self.checkpoints.as_deref_mut(),
            sofar: self.sofar,
            progress: self.progress,
            ..*self
        }
    }
}

impl<'a> Stage<'a> {
    /// A level with its model, or with one that is there already.
    pub(crate) fn new(
        job: &'a ResolvedJob,
        voxels: &'a [Voxels],
        level: &'a Level,
        evaluation_model: Option<EvaluationModel>,
        progress: &mut dyn Progress,
        work: &Work,
    ) -> Result<Self> {
        let voxels = if level.grid == job.grid {
            Cow::Borrowed(voxels)
        } else {
            Cow::Owned(job.voxels(&level.grid, &work.aside())?)
        };
        if let Some(EvaluationModel { model, reason, .. }) = evaluation_model {
            return Ok(Stage {
                job,
                level,
                voxels,
                model,
                straight: None,
                nominal: None,
                dark: Vec::new(),
                reason,
                found: None,
                finer: OnceCell::new(),
            });
        }
        let optics = job.optimizing().lit_by(&level.lights);
        let asked = job.optics.model.as_ref();
        let plan = if job.is_optimized_in_time() {
            planned_in_time(job, asked, optics, level, &voxels, work)?
        } else {
            planned(job, asked, optics, &level.grid, Some(&voxels), work)?
        };
        let straight = plan.surrogate.as_deref();
        let known = straight.unwrap_or(&plan.model);
        let of_bodies = dark_pixels(job, &level.grid, optics, known, progress, work)?;
        let mut dark = of_bodies.clone().unwrap_or_else(|| plan.dark.clone());
        for (dark, left_out) in dark.iter_mut().zip(&plan.dark) {
            *dark |= left_out;
        }
        let model = plan.model.and_dark(of_bodies.unwrap_or_default());
        let (model, nominal) = joined(job, model, &dark, level, work)?;
        let loop_there = !plan.is_on_card || model.form().is_some();
        let place = if loop_there { "" } else { LOOP_HERE };
        Ok(Stage {
            job,
            level,
            voxels,
            model,
            straight: plan.surrogate,
            nominal,
            dark,
            reason: plan.reason + place,
            found: None,
            finer: OnceCell::new(),
        })
    }

    /// The stage with the dose of the frames of all ranks, where the job's frames are shared. Called by all ranks.
    pub(crate) fn shared(mut self) -> Self {
        let Some(ranks) = &self.job.ranks else {
            return self;
        };
        let of_all = |model| Sharded::new(model, Arc::clone(ranks));
        self.nominal = (self.nominal).map(|model| Arc::new(of_all(model)) as SharedModel);
        self.straight = (self.straight).map(|model| Box::new(of_all(model.into())) as Box<_>);
        self.model = Arc::new(of_all(self.model));
        self.reason = format!(
            "{}; its frames are shared by {} ranks",
            self.reason,
            ranks.size()
        );
        self
    }

    pub(crate) fn start(&self, start: &dyn InitialPatterns, work: &Work) -> Result<HostField> {
        let model = self.nominal.as_deref().unwrap_or(self.model.as_ref());
        let straight = self.straight.as_deref();
        let mut x = starting_patterns(self.job, &self.voxels, model, straight, start, work)?;
        darken(x.as_mut_slice(), &self.dark);
        Ok(x)
    }

    /// What follows the last iteration: the response that was found, few levels, heights, and the process window. `raw` are the patterns in `x`.
    pub(crate) fn end(
        &mut self,
        outcome: &Outcome,
        x: &HostField,
        raw: &[Patterns],
        bounds: &[Limits],
        progress: &mut dyn Progress,
        work: &Work,
    ) -> Result<EndOfLevel> {
        if let Some(free) = &self.job.method.free {
            self.found = free.found(&outcome.response)?;
        }
        let begin = Instant::now();
        let levels = self.improve(x, bounds, progress, work)?;
        let levelled = self.levelled(raw, progress, work)?;
        Ok(EndOfLevel {
            levels,
            levelled,
            seconds: begin.elapsed().as_secs_f64(),
            window: self.window(x, work)?,
        })
    }

    /// The loss of all species, with the response that was found; with thresholds that lie so many steps further apart than those of the job.
    pub(crate) fn objective(&self, wider: usize) -> Result<Sum<HostField>> {
        self.objective_on(wider, &|goal| Ok(goal.on_host().clone()))
    }

    /// The same for fields of any kind, for which `objectives` reads a goal's.
    fn objective_on<F: Field>(
        &self,
        wider: usize,
        objectives: &dyn Fn(&Goal) -> Result<Objectives<F>>,
    ) -> Result<Sum<F>> {
        let mut sum = self.objective_of_job(wider, objectives)?;
        if let Some(found) = &self.found {
            sum.set_response(&found.response)?;
        }
        Ok(sum)
    }

    fn objective_of_job<F: Field>(
        &self,
        wider: usize,
        objectives: &dyn Fn(&Goal) -> Result<Objectives<F>>,
    ) -> Result<Sum<F>> {
        let (job, outputs) = (self.job, self.model.outputs());
        let objective_of = |species: &Species, layout: &DoseLayout, voxels: &Voxels| {
            let goal = goal_of(species, wider);
            job.objective(species, &objectives(&goal)?, layout, voxels)
        };
        if let [output] = outputs {
            return objective_of(job.first(), output, &self.voxels[0]);
        }
        // Scenarios, which one species has, ask the same of every output
        let asked = job.species.iter().zip(self.voxels.iter()).cycle();
        let mut parts: Vec<(&DoseLayout, Box<dyn Objective<F>>)> = Vec::new();
        for ((species, voxels), layout) in asked.zip(outputs) {
            let alone = DoseLayout {
                offset: 0,
                ..layout.clone()
            };
            parts.push((layout, Box::new(objective_of(species, &alone, voxels)?)));
        }
        let joined = PerBlock::new(parts, scenarios::join(job));
        Sum::new(vec![(1.0, Box::new(joined))])
    }

    pub(crate) fn limits(&self, start: &HostField) -> Vec<Limits> {
        limits(self.job, self.model.as_ref(), start)
    }

    /// The process window of patterns, where an objective looks for it.
    fn window(&self, x: &HostField, work: &Work) -> Result<Option<FoundWindow>> {
        if !self
            .job
            .species
            .iter()
            .any(|species| species.goal.seeks_window())
        {
            return Ok(None);
        }
        let mut dose = self.model.new_dose()?;
        self.model.dose(x, &mut dose, &work.aside())?;
        Ok(self.objective(0)?.window(&dose))
    }

    /// The patterns in `x`, whose pixels that are to stay dark are made dark.
    pub(crate) fn patterns(&self, x: &mut HostField) -> Vec<Patterns> {
        darken(x.as_mut_slice(), &self.dark);
        gray_levels::patterns(self.model.patterns(), x)
    }

    /// The patterns with rows rescaled so that all heights are done at once; None where the job does not ask for it.
    fn levelled(
        &self,
        raw: &[Patterns],
        progress: &mut dyn Progress,
        work: &Work,
    ) -> Result<Option<Vec<Patterns>>> {
        let job = self.job;
        let asked = job
            .schedule()
            .is_some_and(|schedule| schedule.level_heights);
        if !asked {
            return Ok(None);
        }
        let voxels = job.voxels(&job.grid, &work.aside())?;
        row_balance::level(job, &voxels, raw.to_vec(), progress, work).map(Some)
    }

    /// The patterns as the machine shows them best, where it has few levels, or pixels that change them. Those of many levels that print worse on finer voxels, of
    /// which the loss does not know, are left as they were.
    fn improve(
        &self,
        x: &HostField,
        bounds: &[Limits],
        progress: &mut dyn Progress,
        work: &Work,
    ) -> Result<Option<Levelled>> {
        let (job, model) = (self.job, self.model.as_ref());
        let objective = self.objective(0)?;
        let mut problem = Problem::new(model, &objective, bounds, work)?
            .with_penalties(job.method.penalties(model.patterns())?);
        let Some(found) = gray_levels::improve(job, &mut problem, x)? else {
            return Ok(None);
        };
        let evaluate = job.evaluation();
        let few = evaluate.has_few_levels().then_some(evaluate.bit_depth);
        let mut text = gray_levels::sentence(few, &found.gain);
        let is_worse = few.is_none() && self.prints_worse(x, &found, work)?;
        if is_worse {
            text += "; on finer voxels the print is worse, so the patterns stay as they were";
        }
        progress.event(&Event::Note { text });
        Ok((!is_worse).then_some(found))
    }

    /// Whether patterns that were improved for a machine print worse than those before; of gray targets the loss alone says it.
    fn prints_worse(&self, x: &HostField, found: &Levelled, work: &Work) -> Result<bool> {
        if self.voxels.iter().any(|voxels| voxels.target.gray) {
            return Ok(false);
        }
        let lights = self.model.patterns();
        let iou_of = |asked| {
            let shown = gray_levels::shown(self.job, lights, asked)?;
            let found = self.qualities(&shown, false, &[], work)?;
            Ok(found.first().and_then(|print| print.iou))
        };
        let before = iou_of(gray_levels::patterns(lights, x))?;
        Ok(iou_of(found.asked.clone())? < before)
    }

    /// Runs the optimizer on this level, and goes on with a wider window where the loss becomes 0 before the iterations are over.
    pub(crate) fn run_and_widen(
        &self,
        x: &mut HostField,
        mut around: Around<'_>,
    ) -> Result<Outcome> {
        let until = around.until;
        let mut outcome = self.run(x, around.again())?;
        for steps in 1.. {
            let at = outcome.history.last().map_or(0, |row| row.iteration);
            if outcome.reason != StopReason::ZeroLoss || at >= until {
                break;
            }
            let is_wider = |species: &Species| refinement::widened(&species.goal, steps).is_some();
            if !self.job.species.iter().any(is_wider) {
                break;
            }
            around.progress.event(&Event::Note {
                text: format!("every voxel is within its thresholds after iteration {at}: from now on the void's threshold is {}", concise(refinement::lower_after(steps))),
            });
            around.sofar.rows = outcome.history;
            around.sofar.counters = outcome.counters;
            around.sofar.wider = steps;
            around.wider = steps;
            around.checkpoints = None;
            outcome = self.run(x, around.again())?;
        }
        Ok(outcome)
    }

    /// The card that holds patterns, doses and the method's memory in the loop, and the model's form; None where the processor does.
    ///
    /// # Errors
    /// [`Error::Resources`] where its memory is too small.
    pub(crate) fn on_card(&self) -> Result<Option<(&Card, Form)>> {
        let card = self.job.optics.card.as_ref();
        let Some((card, form)) = card.zip(self.model.form()) else {
            return Ok(None);
        };
        let facts = self.model.facts();
        let pairs = self.job.method.pairs().unwrap_or_default();
        let [patterns, dose] = [Space::Patterns, Space::Dose].map(|space| facts.len(space));
        let holds = card.holds(bytes_on_card(patterns, dose, pairs))?;
        Ok(holds.then_some((card, form)))
    }

    /// Runs the optimizer on this level up to an iteration, after those before; on a graphics card where the job has one and the model a form for it.
    pub(crate) fn run(&self, x: &mut HostField, around: Around<'_>) -> Result<Outcome> {
        let (job, wider) = (self.job, around.wider);
        #[cfg(feature = "gpu")]
        if let Some((card, form)) = self.on_card()? {
            let model = model_on(card.gpu(), &form, around.work)?;
            let loss = self.objective_on(wider, &|goal| goal.on::<GpuField>())?;
            let mut there = model.new_patterns()?;
            there.copy_from_host(x.as_slice());
            let ran = self.run_on(
                model.as_ref(),
                loss,
                job.method.optimizer()?,
                &mut there,
                around,
            );
            let found = there.to_host();
            there.gpu().check()?;
            x.copy_from_host(&found);
            return ran;
        }
        let (model, loss) = (self.model.as_ref(), self.objective(wider)?);
        self.run_on(model, loss, job.method.optimizer()?, x, around)
    }

    /// Runs with model, objective and method for one kind of fields.
    fn run_on<F: Field>(
        &self,
        model: &dyn DoseModel<Field = F>,
        objective: Sum<F>,
        mut optimizer: Box<dyn Optimizer<F>>,
        x: &mut F,
        around: Around<'_>,
    ) -> Result<Outcome> {
        let job = self.job;
        let Around {
            until,
            change,
            bounds,
            checkpoints,
            sofar,
            progress,
            work,
            ..
        } = around;
        // What is watched on the way is the first species, the part
        let layout = model.outputs()[0].clone();
        let stop = job.stop();
        let fixed;
        let problem = if let Some(free) = &job.method.free {
            Problem::with_free_response(model, free.objective(objective)?, bounds, work)?
        } else {
            fixed = objective;
            Problem::new(model, &fixed, bounds, work)?
        };
        let mut problem = problem
            .with_penalties(job.method.penalties(model.patterns())?)
            .with_bits(job.bounds().bits)?;
        let (response, voxels) = (job.first().goal.response.as_ref(), &self.voxels[0]);
        let input = start_input(model, voxels, None, response, &[]);
        if optimizer.requirements().target.is_some() {
            problem = problem.with_target(input.target_field()?);
        }
        if optimizer.requirements().edges.is_some() {
            problem = problem.with_edges(input.edge_field()?);
        }
        problem.counters = sofar.counters;
        let stop = Stop {
            iterations: until,
            projected_gradient: stop.projected_gradient.unwrap_or(0.0),
            change: stop.change.unwrap_or(change),
            // Where most of the loss is what no light can reach, it changes little while the print still does
            rise: stop
                .change
                .is_none()
                .then_some(RISE * job.bounds().tolerance.iou),
            change_after: stop.change_after.unwrap_or(0),
            gap: stop.gap.unwrap_or(0.0),
            relative_loss: stop.relative_loss.unwrap_or(0.0),
            first_loss: sofar.first_loss,
            seconds: stop.wall_s,
            keep: stop.keep,
        };
        let mut labels = layout.field_of(&voxels.labels);
        labels.truncate(layout.voxels());
        let mut watch = Watch {
            job,
            iterations: job.levels.last().map_or(0, |level| level.until).max(until),
            updates: model.updates(),
            lights: model.patterns(),
            doses: model.outputs(),
            labels,
            layout,
            counter: OnceCell::new(),
            voxels: &self.voxels,
            print: None,
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
        sofar.metrics_s = watch.metrics_s;
        sofar.warnings = watch.warnings;
        ran
    }
}

/// The goal of a species, with thresholds that lie so many steps further apart.
pub(crate) fn goal_of(species: &Species, wider: usize) -> Cow<'_, Goal> {
    let wider = (wider > 0).then(|| refinement::widened(&species.goal, wider));
    let goal = wider.flatten().map(Cow::Owned);
    goal.unwrap_or(Cow::Borrowed(&species.goal))
}

/// The pixels whose light would pass a body that is to stay dark, when there is one, before it is scattered: scattered light reaches every place.
///
/// # Errors
/// [`Error::Config`] when that leaves no pixel.
fn dark_pixels(
    job: &ResolvedJob,
    grid: &VolumeGrid,
    optics: OpticalScene<'_>,
    model: &dyn DoseModel<Field = HostField>,
    progress: &mut dyn Progress,
    work: &Work,
) -> Result<Option<Vec<bool>>> {
    let Some(shares) = job.keep_dark(grid)? else {
        return Ok(None);
    };
    let places = Volume {
        values: shares.values.iter().map(|&share| share >= 0.5).collect(),
        grid: shares.grid,
    };
    let dark = match optics.scatters() {
        true => unscattered_through(optics, model, &places, work)?,
        false => pixels_through(model, &places, work)?,
    };
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

/// [`pixels_through`] for light that is not scattered, as elements of the pattern fields of `model`.
fn unscattered_through(
    optics: OpticalScene<'_>,
    model: &dyn DoseModel<Field = HostField>,
    places: &Volume<bool>,
    work: &Work,
) -> Result<Vec<bool>> {
    let clear: Vec<_> = (optics.optics.iter())
        .map(Optics::without_scattering)
        .collect();
    let optics = OpticalScene {
        optics: &clear,
        solid: None,
        accelerator: None,
        ..optics
    };
    let clear = planner::plan(None, optics, &places.grid, None, work)?.model;
    let through = pixels_through(&clear, places, work)?;
    let through: Vec<f32> = through.iter().map(|&t| f32::from(u8::from(t))).collect();
    let mut field = model.new_patterns()?;
    for (clear, layout) in clear.patterns().iter().zip(model.patterns()) {
        layout.fill_field(&clear.patterns_of(&through), field.as_mut_slice());
    }
    Ok(field.as_slice().iter().map(|&t| t > 0.0).collect())
}
