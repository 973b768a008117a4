//! Evaluation of patterns: their dose is simulated again and measured.
//!
//! Both `run` and `simulate` end here, with the patterns that stand in `patterns.npz`, so that they report the same
//! numbers to the last bit.

pub(crate) mod contact;
pub(crate) mod doubts;
pub(crate) mod in_time;
pub(crate) mod light_paths;
pub(crate) mod limits;
pub(crate) mod noise;
pub(crate) mod objectives;
pub(crate) mod prediction;
pub(crate) mod property;
pub(crate) mod scenarios;
pub(crate) mod species;
pub mod trace;

use crate::error::Result;
use crate::field::BLOCK;
use crate::grid::{Patterns, Volume, VolumeGrid};
use crate::job::dose::cache::EvaluationModel;
use crate::job::dose::cross_check;
use crate::job::dose::cross_check::CrossCheck;
use crate::job::dose::doses::{Doses, Exposed};
use crate::job::progress::{Event, Progress, Snapshot};
use crate::job::resolve::scheduled::too_bright;
use crate::job::resolve::{ResolvedJob, Voxels};
use crate::metrics::print::{PatternStats, Print};
use crate::metrics::published::slices::Slice;
use crate::metrics::published::{self, Published};
use crate::metrics::{Evaluation, Measure, MetricKind, evaluate, gray, iou};
use crate::models::Run;
use crate::report::{ObjectiveReport, OneExposure, ScenarioTable};
use crate::target::label;
use contact::Contact;

use in_time::{InTime, print_in_time};
use limits::ENOUGH_BITS;
use noise::Noise;

use serde::Serialize;
use species::Others;
use tomolith_core::parallel::InParallel;

/// What patterns are worth.
pub(crate) struct Evaluated {
    /// Written patterns, turning vial, finer grid: the headline.
    pub(crate) evaluation: Evaluation,
    /// The same with the vial standing still during each frame.
    pub(crate) standing: Evaluation,
    /// Raw patterns on the optimization's own grid, when there are raw ones.
    pub(crate) optimization: Option<Evaluation>,
    /// Every one of several objectives there.
    pub(crate) objectives: Vec<ObjectiveReport>,
    /// The headline number of the written patterns on that grid, beside it.
    pub(crate) written: Measure,
    /// That of the headline by patterns for few levels before they are rounded.
    pub(crate) unrounded: Measure,
    /// Numbers of the headline as they were published.
    pub(crate) published: Vec<Published>,
    /// Numbers of each slice of the headline.
    pub(crate) slices: Vec<Slice>,
    /// Dose of the headline, averaged to the optimization's voxels.
    pub(crate) dose: Volume<f32>,
    /// The target on the finer grid.
    pub(crate) fine: Voxels,
    /// Response of the headline on the finer grid.
    pub(crate) response: Volume<f32>,
    /// What the bodies that are to stay dark get; None without any.
    pub(crate) keep_dark: Option<KeepDark>,
    /// What the print touches of the inserts; None without any.
    pub(crate) contact: Option<Contact>,
    /// Which voxels of the finer grid belong to bodies that are not printed, for the report; None without any.
    pub(crate) bodies: Option<Volume<u8>>,
    /// What Monte Carlo paths leave uncertain; None where none are drawn.
    pub(crate) noise: Option<Noise>,
    /// How far scattered light by orders is from Monte Carlo paths; None where it does not go order by order.
    pub(crate) agreement: Option<CrossCheck>,
    /// The model that gave the doses, and why it was chosen.
    pub(crate) model: String,
    /// The same patterns in time, where the job has a schedule.
    pub(crate) in_time: Option<InTime>,
    /// The prints of further species.
    pub(crate) others: Vec<species::Species>,
    /// All species at one exposure, where there are several.
    pub(crate) one_exposure: Option<OneExposure>,
    /// The same patterns in the job's scenarios.
    pub(crate) scenarios: Option<ScenarioTable>,
    /// What people should know.
    pub(crate) warnings: Vec<String>,
}

/// Responses in the bodies that are to stay dark, vial turning, beside those of the part.
#[derive(Clone, Copy, Debug, PartialEq, Serialize)]
pub(crate) struct KeepDark {
    /// Their volume, mm³.
    pub(crate) volume_mm3: f64,
    /// Mean in them.
    pub(crate) mean: f64,
    /// The largest.
    pub(crate) largest: f64,
    /// Mean in the part.
    pub(crate) part_mean: f64,
}

impl KeepDark {
    fn of(shares: &Volume<f32>, labels: &Volume<u8>, response: &Volume<f32>) -> Self {
        let of = |marked: &dyn Fn(usize) -> bool| {
            let values = response.values.iter().enumerate();
            values
                .filter(|(i, _)| marked(*i))
                .fold((0usize, 0.0f64, 0.0f64), |(n, sum, most), (_, &v)| {
                    (n + 1, sum + f64::from(v), most.max(f64::from(v)))
                })
        };
        let mean = |n: usize, sum: f64| sum / n.max(1) as f64;
        let (voxels, sum, largest) = of(&|i| shares.values[i] >= 0.5);
        let (part, part_sum, _) = of(&|i| labels.values[i] == label::PART);
        KeepDark {
            volume_mm3: voxels as f64 * shares.grid.voxel_mm3(),
            mean: mean(voxels, sum),
            largest,
            part_mean: mean(part, part_sum),
        }
    }
}

impl std::fmt::Display for KeepDark {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        let share = |value: f64| 100.0 * value / self.part_mean;
        write!(
            f,
            "{:.3} % of the part's mean response on average, {:.2} % at most",
            share(self.mean),
            share(self.largest)
        )
    }
}

impl Evaluated {
    /// Dose at which the print is solid: that of all species together where they have one, else of the headline; None when nothing is.
    pub(crate) fn gel_dose(&self, job: &ResolvedJob) -> Option<f64> {
        if let Some(together) = &self.one_exposure {
            return Some(together.gel_dose);
        }
        let response = job.response();
        let dose = |threshold: f64| f64::from(response.inverse(threshold as f32));
        self.evaluation.gel_threshold.map(dose)
    }
}

/// Simulates and measures patterns, per light: the written ones, and the raw ones they were made from; by a model that is there already, where
/// it has their doses.
///
/// # Errors
/// [`Error::Canceled`](crate::Error::Canceled), [`Error::NonFinite`](crate::Error::NonFinite), and what the model
/// refuses.
pub(crate) fn evaluate_patterns(
    job: &ResolvedJob,
    voxels: &Voxels,
    shown: &[Patterns],
    raw: Option<&[Patterns]>,
    evaluation_model: Option<&EvaluationModel>,
    progress: &mut dyn Progress,
    cancel: &Run,
) -> Result<Evaluated> {
    let schedule = job.spec.schedule.as_ref();
    let in_time_share = schedule.map_or(0.0, |_| share::IN_TIME);
    let printing = cancel.part(in_time_share);
    let cancel = &cancel.part(1.0 - in_time_share);
    let mut steps = EvaluationSteps::new(job, shown, evaluation_model, cancel);
    let optimization = steps.on_own_voxels(voxels, raw)?;
    let text = steps.words();
    progress.event(&Event::Note { text });
    let fine = steps.fine_voxels(voxels)?;
    let fine_of_others = species::voxels(job, &steps.grid, cancel)?;
    if raw.is_none() || !steps.looks_at_own() {
        steps.doses.will_show(&[shown]);
    }
    let standing = steps.standing_still(&fine, &fine_of_others)?;
    let written = steps.written;
    let objectives = std::mem::take(&mut steps.objectives);
    let (grid, sub_angles) = (steps.grid.clone(), steps.sub_angles);
    let [is_own_still, is_own_turning] =
        [&steps.still, &steps.turning].map(|exposed| steps.own == *exposed);
    let unrounded =
        raw.filter(|_| job.spec.evaluate.bit_depth < ENOUGH_BITS && !voxels.target.gray);
    let unrounded = unrounded
        .map(|raw| steps.unrounded(&fine, raw))
        .transpose()?
        .flatten();
    let (dose, model, others) = steps.while_turning(fine_of_others)?;
    let mean = averaged(&dose, &job.grid);
    cancel.check()?;
    let numbers = Numbers::of(job, &fine, dose, shown, cancel)?;
    cancel.check()?;
    let Numbers {
        published,
        slices,
        response,
        evaluation,
    } = numbers;
    let standing = standing.unwrap_or_else(|| evaluation.clone());
    let head = |print: &Evaluation| print.measures.get(headline(voxels.target.gray).name);
    let written = match &optimization {
        Some(_) if is_own_turning => head(&evaluation),
        Some(_) if is_own_still => head(&standing),
        _ => written,
    };
    let shares = job.keep_dark(&grid)?;
    let of_shares = |shares: &Volume<f32>| KeepDark::of(shares, &fine.labels, &response);
    let keep_dark = shares.as_ref().map(of_shares);
    let bodies = job.bodies(&grid, shares.as_ref())?;
    if let Some(dark) = &keep_dark {
        let text = format!("keep-dark bodies get {dark}");
        progress.event(&Event::Note { text });
    }
    let contact = evaluation.gel_threshold.and_then(|threshold| {
        let inside = &fine.target.inside;
        Contact::of(job.shape.as_ref(), inside, &response, threshold)
    });
    let own = (&response, evaluation.gel_threshold);
    let scenarios = scenarios::table(job, &fine.labels.values, own, |other| {
        let turning = Exposed::new(&grid, other.optics.lights_turning(sub_angles));
        let mut doses = Doses::new(other);
        doses.will_show(&[shown]);
        let (dose, ..) = doses.of(&turning, shown, &cancel.aside())?;
        Ok(other.responses(dose))
    })?;
    let in_time = in_time(job, voxels, shown, progress, &printing)?;
    let noise = Noise::of(job, voxels, shown, cancel)?;
    let agreement = CrossCheck::of(job, voxels, shown, cross_check::PATHS, cancel)?;
    let warnings = doubts_of(job, shown, &evaluation, (&noise, &agreement), progress)?;
    let one_exposure = together(job, &evaluation, &others, progress);
    show(shown, (&mean, &response), &others, progress);
    Ok(Evaluated {
        evaluation,
        standing,
        optimization,
        objectives,
        written,
        unrounded,
        published,
        slices,
        dose: mean,
        fine,
        response,
        keep_dark,
        contact,
        bodies,
        noise,
        agreement,
        model,
        in_time,
        others,
        one_exposure,
        scenarios,
        warnings,
    })
}

/// Copies for an observer that asked for them: the written patterns and what they print.
fn show(
    shown: &[Patterns],
    (dose, print): (&Volume<f32>, &Volume<f32>),
    others: &[species::Species],
    progress: &mut dyn Progress,
) {
    let wants = progress.wants();
    if !wants.any() {
        return;
    }
    let copies = |wanted: bool, first: &Volume<f32>, of: fn(&species::Species) -> &Volume<f32>| {
        let all = std::iter::once(first).chain(others.iter().map(of));
        all.filter(|_| wanted).cloned().collect()
    };
    progress.snapshot(Snapshot {
        iteration: None,
        patterns: if wants.patterns {
            shown.to_vec()
        } else {
            Vec::new()
        },
        dose: copies(wants.dose, dose, |other| &other.dose),
        print: copies(wants.print, print, |other| &other.response),
    });
}

/// The doses of an evaluation, one after the other, each measured before the next takes its memory: on the optimization's voxels, then on finer ones standing
/// still, then turning.
struct EvaluationSteps<'a> {
    job: &'a ResolvedJob,
    shown: &'a [Patterns],
    cancel: &'a Run,
    /// The finer voxels.
    grid: VolumeGrid,
    own: Exposed,
    still: Exposed,
    turning: Exposed,
    sub_angles: usize,
    doses: Doses<'a>,
    others: Others<'a>,
    own_of_others: Vec<Voxels>,
    /// Every one of several objectives on the optimization's voxels.
    objectives: Vec<ObjectiveReport>,
    /// The headline number of the written patterns on the optimization's voxels, where it is measured apart.
    written: Measure,
}

impl<'a> EvaluationSteps<'a> {
    fn new(
        job: &'a ResolvedJob,
        shown: &'a [Patterns],
        evaluation_model: Option<&'a EvaluationModel>,
        cancel: &'a Run,
    ) -> Self {
        let sub_angles = job.evaluated_angles();
        let grid = job.fine_grid();
        let [still, turning] =
            [1, sub_angles].map(|n| Exposed::new(&grid, job.optics.lights_turning(n)));
        EvaluationSteps {
            job,
            shown,
            cancel,
            own: Exposed::new(&job.grid, job.optics.lights.clone()),
            grid,
            still,
            turning,
            sub_angles,
            doses: Doses::by(evaluation_model, job),
            others: Others::new(job),
            own_of_others: Vec::new(),
            objectives: Vec::new(),
            written: None,
        }
    }

    /// Whether the finer voxels are the optimization's, so that one dose serves both.
    fn looks_at_own(&self) -> bool {
        self.own == self.still || self.own == self.turning
    }

    fn words(&self) -> String {
        let [nz, ny, nx] = self.grid.shape;
        let how = match self.sub_angles {
            1 => "the vial stands still during each frame".to_owned(),
            n => format!("standing still, and turning ({n} angles per frame)"),
        };
        format!("evaluating on {nx} × {ny} × {nz} voxels: {how}")
    }

    /// The raw patterns on the optimization's voxels, where there are raw ones; and the written ones, where no later step looks at these.
    fn on_own_voxels(
        &mut self,
        voxels: &Voxels,
        raw: Option<&[Patterns]>,
    ) -> Result<Option<Evaluation>> {
        let Some(raw) = raw else {
            return Ok(None);
        };
        let (job, cancel) = (self.job, self.cancel);
        self.own_of_others = species::voxels(job, &job.grid, cancel)?;
        self.doses.will_show(&[raw, self.shown]);
        let (dose, of_others, _) =
            (self.doses).of(&self.own, raw, &cancel.part(share::OWN_DOSE))?;
        (self.others).optimized(&self.own_of_others, of_others, cancel)?;
        self.objectives = objectives::measured(job, voxels, &dose)?;
        cancel.check()?;
        let response = job.responses(dose);
        let run = cancel.part(share::OWN_NUMBERS);
        let evaluation = measure(job, voxels, &response, raw, run)?;
        self.doses.give_back(response);
        if !self.looks_at_own() {
            let (dose, of_others, _) =
                (self.doses).of(&self.own, self.shown, &cancel.part(share::OWN_DOSE))?;
            (self.others).written(&self.own_of_others, of_others, cancel)?;
            self.written = headline_of(job, voxels, dose, cancel.part(share::OWN_NUMBERS))?;
        }
        let sub_angles = job.optics.lights.iter().map(|light| light.sub_angles);
        Ok(Some(
            evaluation.with_sub_angles(sub_angles.max().unwrap_or(1)),
        ))
    }

    fn fine_voxels(&self, own: &Voxels) -> Result<Voxels> {
        if self.grid == self.job.grid {
            return Ok(own.clone());
        }
        (self.job).voxels_under(&self.grid, &self.cancel.part(share::SAMPLING))
    }

    /// The written patterns while the vial stands still; None where frames have no arc, so that it turns in none.
    fn standing_still(
        &mut self,
        fine: &Voxels,
        of_others: &[Voxels],
    ) -> Result<Option<Evaluation>> {
        if self.still == self.turning {
            return Ok(None);
        }
        let (job, cancel) = (self.job, self.cancel);
        let (dose, doses_of_others, _) =
            (self.doses).of(&self.still, self.shown, &cancel.part(share::STANDING))?;
        if self.own == self.still {
            (self.others).written(&self.own_of_others, doses_of_others.clone(), cancel)?;
        }
        self.others.standing(of_others, doses_of_others, cancel)?;
        let response = job.responses(dose);
        let run = cancel.part(share::NUMBERS);
        let standing = measure(job, fine, &response, self.shown, run)?;
        self.doses.give_back(response);
        Ok(Some(standing))
    }

    /// The headline number of raw patterns on the finer voxels, turning.
    fn unrounded(&mut self, fine: &Voxels, raw: &[Patterns]) -> Result<Measure> {
        let run = self.cancel.aside();
        self.doses.will_show(&[raw, self.shown]);
        let (dose, ..) = self.doses.of(&self.turning, raw, &run)?;
        let found = headline_of(self.job, fine, dose, run)?;
        self.doses.will_show(&[self.shown]);
        Ok(found)
    }

    /// The dose of the written patterns while the vial turns, the model that gave it, and the prints of further species.
    fn while_turning(
        mut self,
        of_others: Vec<Voxels>,
    ) -> Result<(Volume<f32>, String, Vec<species::Species>)> {
        let cancel = self.cancel;
        let (dose, doses_of_others, model) =
            (self.doses).of(&self.turning, self.shown, &cancel.part(share::TURNING))?;
        drop(self.doses);
        if self.own == self.turning {
            (self.others).written(&self.own_of_others, doses_of_others.clone(), cancel)?;
        }
        if self.still == self.turning {
            (self.others).standing(&of_others, doses_of_others.clone(), cancel)?;
        }
        let others = (self.others).turning(of_others, doses_of_others, self.shown, cancel)?;
        Ok((dose, model, others))
    }
}

/// The numbers of the headline.
struct Numbers {
    published: Vec<Published>,
    slices: Vec<Slice>,
    response: Volume<f32>,
    evaluation: Evaluation,
}

impl Numbers {
    fn of(
        job: &ResolvedJob,
        fine: &Voxels,
        dose: Volume<f32>,
        shown: &[Patterns],
        cancel: &Run,
    ) -> Result<Self> {
        let material = job.response();
        let options = published::Options {
            response: material.as_ref(),
            gray: fine.target.gray,
            patterns: shown,
            trim_percent: job.spec.evaluate.trim_percent,
            epsilon: job.half_width(),
        };
        let inside = &fine.target.inside;
        let run = cancel.part(share::PUBLISHED);
        let (published, slices, response, evaluation) = if material.is_identity() {
            // The dose is the response: what was counted of one serves the other
            let stats = PatternStats::of(shown);
            let print = print_under(job, fine, &dose, run)?.with_patterns(stats);
            let (published, slices) = published::of_print(&print, inside, &options)?;
            let evaluation = evaluate(&print);
            drop(print);
            (published, slices, dose, evaluation)
        } else {
            let (published, slices) = published::by_slices(&dose, inside, &fine.labels, &options)?;
            let response = job.responses(dose);
            let evaluation = measure(job, fine, &response, shown, run)?;
            (published, slices, response, evaluation)
        };
        Ok(Numbers {
            published,
            slices,
            response,
            evaluation: evaluation.with_sub_angles(job.evaluated_angles()),
        })
    }
}

/// What people should know of a print, told at once: how sure its model is, and what of its patterns and its job looks wrong.
fn doubts_of(
    job: &ResolvedJob,
    shown: &[Patterns],
    evaluation: &Evaluation,
    (noise, agreement): (&Option<Noise>, &Option<CrossCheck>),
    progress: &mut dyn Progress,
) -> Result<Vec<String>> {
    let of_paths = noise.map(|noise| format!("Monte Carlo paths: {noise}"));
    let of_orders = agreement.map(|agreement| format!("scattering by orders: {agreement}"));
    for text in of_paths.into_iter().chain(of_orders) {
        progress.event(&Event::Note { text });
    }
    let warnings: Vec<String> = noise
        .and_then(|noise| noise.warning())
        .into_iter()
        .chain(agreement.and_then(|agreement| agreement.warning()))
        .chain(doubts::of_light(shown))
        .chain(doubts::of_dose(evaluation, shown))
        .chain(doubts::of_bound(&job.spec, shown))
        .chain(doubts::of_threshold(&job.spec, evaluation))
        .chain(too_bright(&job.spec, shown)?)
        .collect();
    for text in warnings.iter().cloned() {
        progress.event(&Event::Warning { text });
    }
    Ok(warnings)
}

/// All species at one exposure, and what each prints then, told at once.
fn together(
    job: &ResolvedJob,
    evaluation: &Evaluation,
    others: &[species::Species],
    progress: &mut dyn Progress,
) -> Option<OneExposure> {
    let all: Vec<&Evaluation> = std::iter::once(evaluation)
        .chain(others.iter().map(|own| &own.evaluation))
        .collect();
    let together = one_exposure(job, &all)?;
    for text in of_each_species(job, &all, &together) {
        progress.event(&Event::Note { text });
    }
    Some(together)
}

/// The prints of several species at one exposure.
fn one_exposure(job: &ResolvedJob, evaluations: &[&Evaluation]) -> Option<OneExposure> {
    let over_doses = |(s, (own, evaluation)): (usize, (&ResolvedJob, &&Evaluation))| {
        let response = own.response();
        let dose =
            |&[threshold, iou]: &[f64; 2]| [f64::from(response.inverse(threshold as f32)), iou];
        let curve: Vec<[f64; 2]> = evaluation.curve.iter().map(dose).collect();
        (job.species_name(s).unwrap_or_default(), curve)
    };
    // Gray values have no threshold that one dose could meet
    if evaluations.iter().any(|own| own.half_width.is_some()) {
        return None;
    }
    let species = job.species().zip(evaluations).enumerate();
    let curves: Vec<_> = species.map(over_doses).collect();
    OneExposure::of(&curves)
}

/// A line for each species of several: IoU at its own best threshold, and together with the others.
fn of_each_species(
    job: &ResolvedJob,
    evaluations: &[&Evaluation],
    together: &OneExposure,
) -> Vec<String> {
    let of_one = |(s, (evaluation, iou)): (usize, (&&Evaluation, &f64))| {
        Some(format!(
            "{}: IoU {:.4} at a threshold of {:.3}; {iou:.4} together with the others, where all networks gel at a dose of {:.3}",
            job.species_name(s).unwrap_or_default(),
            evaluation.measures.get("iou")?,
            evaluation.gel_threshold?,
            together.gel_dose
        ))
    };
    let all = evaluations.iter().zip(&together.iou).enumerate();
    all.filter_map(of_one).collect()
}

/// The print in time on the job's voxels, where the job has a schedule.
fn in_time(
    job: &ResolvedJob,
    voxels: &Voxels,
    shown: &[Patterns],
    progress: &mut dyn Progress,
    cancel: &Run,
) -> Result<Option<InTime>> {
    if job.spec.schedule.is_none() {
        return Ok(None);
    }
    let text = "printing in time, on the job's voxels".to_owned();
    progress.event(&Event::Note { text });
    let others = job.others.iter().map(|s| s.voxels(&job.grid));
    let others = others.collect::<Result<Vec<_>>>()?;
    let all: Vec<&Voxels> = std::iter::once(voxels).chain(&others).collect();
    print_in_time(job, &all, shown, cancel)
}

/// Numbers of what is solid at this response.
pub(crate) fn measure_at(
    job: &ResolvedJob,
    voxels: &Voxels,
    response: &Volume<f32>,
    threshold: f64,
    patterns: &[Patterns],
) -> Result<Evaluation> {
    let mut print = Print::under(&voxels.labels, response, Run::new())?
        .with_most_triangles(job.most_triangles())
        .with_inside(&voxels.target.inside)?
        .with_threshold(threshold)?
        .with_patterns(PatternStats::of(patterns));
    if !job.spec.evaluate.surfaces {
        print = print.without_distance();
    }
    Ok(evaluate(&print).with_sub_angles(job.evaluated_angles()))
}

/// Shares of an evaluation, as an index-matched job on voxels half as large takes them.
mod share {
    /// The print in time, of a job that has a schedule: what it takes depends on the schedule, and was not measured. The others share the rest.
    pub(crate) const IN_TIME: f64 = 0.5;
    /// Dose and numbers of the raw and of the written patterns on the job's own voxels, each.
    pub(crate) const OWN_DOSE: f64 = 0.04;
    pub(crate) const OWN_NUMBERS: f64 = 0.03;
    /// The finer voxels.
    pub(crate) const SAMPLING: f64 = 0.05;
    /// Their doses.
    pub(crate) const STANDING: f64 = 0.2;
    pub(crate) const TURNING: f64 = 0.25;
    /// The numbers of the first; those of the second, with the published ones.
    pub(crate) const NUMBERS: f64 = 0.12;
    pub(crate) const PUBLISHED: f64 = 0.24;
}

/// The one number that says how good a print is: IoU, or the rms error of a gray target.
pub(crate) fn headline(is_gray: bool) -> &'static MetricKind {
    if is_gray { &gray::RMS } else { &iou::KIND }
}

/// What the metrics look at.
pub(crate) fn print<'a>(
    job: &ResolvedJob,
    voxels: &'a Voxels,
    response: &'a Volume<f32>,
) -> Result<Print<'a>> {
    print_under(job, voxels, response, Run::new())
}

/// The same as a part of a run.
fn print_under<'a>(
    job: &ResolvedJob,
    voxels: &'a Voxels,
    response: &'a Volume<f32>,
    run: Run,
) -> Result<Print<'a>> {
    let inside = &voxels.target.inside;
    let mut print = Print::under(&voxels.labels, response, run)?
        .with_most_triangles(job.most_triangles())
        .with_inside(inside)?
        .with_response(job.response());
    if !job.spec.evaluate.surfaces {
        print = print.without_distance();
    }
    if voxels.target.gray {
        print = print.with_gray(inside, job.half_width())?;
    }
    if let Some(threshold) = job.spec.evaluate.threshold {
        print = print.with_threshold(threshold)?;
    }
    Ok(print)
}

/// The headline number of a dose.
pub(crate) fn headline_of(
    job: &ResolvedJob,
    voxels: &Voxels,
    dose: Volume<f32>,
    run: Run,
) -> Result<Measure> {
    let response = job.responses(dose);
    let print = print_under(job, voxels, &response, run)?;
    Ok((headline(voxels.target.gray).measure)(&print))
}

/// The numbers of a print.
pub(crate) fn measure(
    job: &ResolvedJob,
    voxels: &Voxels,
    response: &Volume<f32>,
    patterns: &[Patterns],
    run: Run,
) -> Result<Evaluation> {
    let stats = PatternStats::of(patterns);
    let print = print_under(job, voxels, response, run.part(1.0))?.with_patterns(stats);
    let evaluation = evaluate(&print);
    // Numbers of a canceled run mean nothing
    run.check().map(|()| evaluation)
}

/// Means over the fine voxels of each coarse one.
pub(crate) fn averaged(fine: &Volume<f32>, grid: &VolumeGrid) -> Volume<f32> {
    let [_, ny, nx] = grid.shape;
    let factor = fine.grid.shape[0] / grid.shape[0].max(1);
    let mut values = vec![0.0f32; grid.len()];
    values
        .chunks_mut((nx * ny).max(1))
        .enumerate()
        .par_each(|(iz, slice)| {
            for (i, value) in slice.iter_mut().enumerate() {
                let (iy, ix) = (i / nx, i % nx);
                let mut sum = 0.0f64;
                for z in iz * factor..(iz + 1) * factor {
                    for y in iy * factor..(iy + 1) * factor {
                        let row = &fine.values[fine.grid.index(z, y, ix * factor)..][..factor];
                        sum += row.iter().map(|&v| f64::from(v)).sum::<f64>();
                    }
                }
                *value = (sum / factor.pow(3) as f64) as f32;
            }
        });
    Volume {
        grid: grid.clone(),
        values,
    }
}

impl ResolvedJob {
    /// Half width of the band round gray values: ε of the first objective that has one, or the BCLP paper's own where there is none.
    fn half_width(&self) -> f64 {
        let given = self.kinds.epsilon();
        given.unwrap_or(published::Options::default().epsilon)
    }

    /// What the material makes of a dose.
    pub(crate) fn responses(&self, mut dose: Volume<f32>) -> Volume<f32> {
        let response = self.response();
        if !response.is_identity() {
            dose.values.chunks_mut(BLOCK).par_each(|block| {
                block
                    .iter_mut()
                    .for_each(|value| *value = response.value(*value))
            });
        }
        dose
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn fine_voxels_are_averaged_where_they_belong() {
        let grid = VolumeGrid::centered([1, 2, 3], 0.2);
        let fine = grid.refined(2);
        let values = (0..fine.len())
            .map(|i| (i / 6 % 4 / 2 * 10 + i % 6 / 2) as f32)
            .collect();
        let mean = averaged(&Volume { grid: fine, values }, &grid);
        assert_eq!(mean.values, [0.0, 1.0, 2.0, 10.0, 11.0, 12.0]);
    }
}
