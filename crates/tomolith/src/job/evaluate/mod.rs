//! Evaluation of patterns: their dose is simulated again and measured.
//!
//! Both `run` and `simulate` end here, with the patterns that stand in `patterns.npz`, so that they report the same
//! numbers to the last bit.

pub(crate) mod around;
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
mod steps;
pub mod trace;

use crate::error::Result;
use crate::grid::{Patterns, Volume, VolumeGrid};
use crate::job::dose::cache::EvaluationModel;
use crate::job::dose::cross_check;
use crate::job::dose::cross_check::CrossCheck;
use crate::job::dose::doses::{Doses, Exposed};
use crate::job::progress::{Event, Progress, Snapshot};
use crate::job::resolve::scheduled::too_bright;
use crate::job::resolve::{ResolvedJob, Species, Voxels};
use crate::metrics::latitude::Latitude;
use crate::metrics::print::{PatternStats, Print};
use crate::metrics::published::slices::Slice;
use crate::metrics::published::{self, Published};
use crate::metrics::surface::Deviation;
use crate::metrics::{Evaluation, Measure, MetricKind, evaluate, gray, iou};
use crate::models::Work;
use crate::report::{ObjectiveReport, OneExposure, ScenarioTable};
use crate::target::label;
use around::Around;
use contact::Contact;

use in_time::{InTime, print_in_time};
use noise::Noise;
use steps::{EvaluationSteps, OwnPrint};

use serde::Serialize;
use tomolith_core::parallel::InParallel;

/// What patterns are worth.
pub(crate) struct Evaluated {
    /// What each species prints; that of the first is the headline.
    pub(crate) species: Vec<SpeciesPrint>,
    /// Numbers of the headline as they were published.
    pub(crate) published: Vec<Published>,
    /// Numbers of each slice of the headline.
    pub(crate) slices: Vec<Slice>,
    /// Every one of several objectives on the optimization's grid.
    pub(crate) objectives: Vec<ObjectiveReport>,
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
    /// All species at one exposure, where there are several.
    pub(crate) one_exposure: Option<OneExposure>,
    /// The same patterns in the job's scenarios.
    pub(crate) scenarios: Option<ScenarioTable>,
    /// Resin outside the voxels of the job that solidifies.
    pub(crate) around: Option<Around>,
    /// What people should know.
    pub(crate) warnings: Vec<String>,
}

/// What a species prints.
pub(crate) struct SpeciesPrint {
    /// Written patterns, turning vial, finer grid.
    pub(crate) evaluation: Evaluation,
    /// Raw patterns on the optimization's grid, when there are raw ones.
    pub(crate) optimization: Option<Evaluation>,
    /// The headline number of the written patterns on that grid.
    pub(crate) written: Measure,
    /// That number while the vial turns; None where the optimization counted that.
    pub(crate) own_turning: Measure,
    /// That of the print that is evaluated, by patterns for few levels before they are rounded.
    pub(crate) unrounded: Measure,
    /// Its dose, averaged to the optimization's voxels.
    pub(crate) dose: Volume<f32>,
    /// Its target on the finer grid.
    pub(crate) fine: Voxels,
    /// Its response there.
    pub(crate) response: Volume<f32>,
    /// How far its surface is off, of the headline; None where that was not measured.
    pub(crate) deviation: Option<Deviation>,
}

/// Responses in the bodies that are to stay dark, vial turning, next to those of the part.
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
        let sums_of = |marked: &dyn Fn(usize) -> bool| {
            let values = response.values.iter().enumerate();
            values
                .filter(|(i, _)| marked(*i))
                .fold((0usize, 0.0f64, 0.0f64), |(n, sum, most), (_, &v)| {
                    (n + 1, sum + f64::from(v), most.max(f64::from(v)))
                })
        };
        let mean = |n: usize, sum: f64| sum / n.max(1) as f64;
        let (voxels, sum, largest) = sums_of(&|i| shares.values[i] >= 0.5);
        let (part, part_sum, _) = sums_of(&|i| labels.values[i] == label::PART);
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
    /// The headline.
    pub(crate) fn first(&self) -> &SpeciesPrint {
        &self.species[0]
    }

    /// Dose at which the print is solid: that of all species together where they have one, else of the headline; None when nothing is.
    pub(crate) fn gel_dose(&self, job: &ResolvedJob) -> Option<f64> {
        if let Some(together) = &self.one_exposure {
            return Some(together.gel_dose);
        }
        let response = &job.first().goal.response;
        let dose = |threshold: f64| f64::from(response.inverse(threshold as f32));
        self.first().evaluation.gel_threshold.map(dose)
    }
}

/// Where patterns come from.
#[derive(Clone, Copy, Default)]
pub(crate) struct Origin<'a> {
    /// The raw ones that the written ones were made from.
    pub(crate) raw: Option<&'a [Patterns]>,
    /// A model that is there already, where it has their doses.
    pub(crate) model: Option<&'a EvaluationModel>,
    /// Whether they were optimized for this part.
    pub(crate) is_optimized: bool,
}

/// Simulates and measures the written patterns, per light.
///
/// # Errors
/// [`Error::Canceled`](crate::Error::Canceled), [`Error::NonFinite`](crate::Error::NonFinite), and what the model
/// refuses.
pub(crate) fn evaluate_patterns(
    job: &ResolvedJob,
    voxels: &[Voxels],
    shown: &[Patterns],
    origin: Origin<'_>,
    progress: &mut dyn Progress,
    work: &Work,
) -> Result<Evaluated> {
    let raw = origin.raw;
    let in_time_share = if job.schedule().is_some() {
        share::IN_TIME
    } else {
        0.0
    };
    let printing = work.part(in_time_share);
    let work = &work.part(1.0 - in_time_share);
    let mut steps = EvaluationSteps::new(job, shown, origin.model, work);
    let (optimization, objectives) = steps.unwritten(voxels, raw)?;
    let [written, own_turning] = steps.on_own_voxels(voxels, raw.is_some())?;
    let text = steps.words();
    progress.event(&Event::Note { text });
    let unrounded = steps.unrounded(voxels, raw)?;
    let grid = steps.grid.clone();
    let stats = PatternStats::of(shown);
    let (doses, model) = steps.while_turning()?;
    // Only now: a dose takes as much memory again while it is brought into the order of arrays
    let fine = steps.fine_voxels(voxels)?;
    drop(steps);
    let mut published = None;
    let mut species = Vec::with_capacity(job.species.len());
    for (s, (fine, dose)) in fine.into_iter().zip(doses).enumerate() {
        let mean = averaged(&dose, &job.grid);
        work.check()?;
        let measured = numbers(job, s, &fine, dose, shown, stats, work)?;
        work.check()?;
        let evaluation = measured
            .evaluation
            .with_sub_angles(job.most_evaluated_angles());
        published = published.or(measured.published);
        species.push(SpeciesPrint {
            written: headline_of(job, &written, s, &evaluation, &fine),
            own_turning: headline_of(job, &own_turning, s, &evaluation, &fine),
            evaluation,
            optimization: optimization.get(s).cloned(),
            unrounded: unrounded.get(s).copied().flatten(),
            dose: mean,
            fine,
            response: measured.response,
            deviation: measured.deviation,
        });
    }
    let (published, slices) = published.unwrap_or_default();
    let first = &species[0];
    let shares = job.keep_dark(&grid)?;
    let keep_dark = shares.as_ref();
    let keep_dark =
        keep_dark.map(|shares| KeepDark::of(shares, &first.fine.labels, &first.response));
    let bodies = job.bodies(&grid, shares.as_ref())?;
    if let Some(dark) = &keep_dark {
        let text = format!("keep-dark bodies get {dark}");
        progress.event(&Event::Note { text });
    }
    let threshold = first.evaluation.gel_threshold;
    let contact = threshold.and_then(|threshold| {
        let inside = &first.fine.target.inside;
        Contact::of(job.shape(), inside, &first.response, threshold)
    });
    let scenarios = in_scenarios(job, shown, first, &grid, work)?;
    let in_time = in_time(job, voxels, shown, progress, &printing)?;
    let noise = Noise::of(job, &voxels[0], shown, work)?;
    let agreement = CrossCheck::of(job, &voxels[0], shown, cross_check::PATHS, work)?;
    let mut warnings = doubts_of(job, shown, &species, &noise, &agreement, progress)?;
    let around = around::of_resin(job, shown, &species, !origin.is_optimized, work)?;
    if let Some(text) = around.as_ref().map(Around::warning) {
        warnings.push(text.clone());
        progress.event(&Event::Warning { text });
    }
    let one_exposure = together(job, &species, &mut warnings, progress);
    show(shown, &job.species, &species, progress);
    Ok(Evaluated {
        species,
        published,
        slices,
        objectives,
        keep_dark,
        contact,
        bodies,
        noise,
        agreement,
        model,
        in_time,
        one_exposure,
        scenarios,
        around,
        warnings,
    })
}

/// The headline number of a species' written patterns on the optimization's voxels, from the print that is evaluated where that is the same.
fn headline_of(
    job: &ResolvedJob,
    print: &Option<OwnPrint>,
    s: usize,
    evaluation: &Evaluation,
    fine: &Voxels,
) -> Measure {
    match print.as_ref()? {
        OwnPrint::Apart(measured) => measured[s],
        OwnPrint::Evaluated => {
            let head = headline(fine.target.gray).name;
            at_best_threshold(job, evaluation).or(evaluation.measures.get(head))
        }
    }
}

/// What the patterns of the headline print in each scenario of the job.
fn in_scenarios(
    job: &ResolvedJob,
    shown: &[Patterns],
    print: &SpeciesPrint,
    grid: &VolumeGrid,
    work: &Work,
) -> Result<Option<ScenarioTable>> {
    let (labels, threshold) = (&print.fine.labels.values, print.evaluation.gel_threshold);
    scenarios::table(job, labels, &print.response, threshold, |scenario| {
        let turning = Exposed::new(grid, scenario.optics.lights_turning(&job.evaluated_angles));
        let mut doses = Doses::new(job, &scenario.optics);
        doses.will_show(&[shown]);
        let (mut doses, _) = doses.of(&turning, shown, &work.aside())?;
        Ok(job.first().goal.responses(doses.swap_remove(0)))
    })
}

/// Copies for an observer that wants them: the written patterns and what they print.
fn show(
    shown: &[Patterns],
    species: &[Species],
    prints: &[SpeciesPrint],
    progress: &mut dyn Progress,
) {
    let wants = progress.wants();
    if !wants.any() {
        return;
    }
    let copies = |is_wanted: bool, volume_of: fn(&SpeciesPrint) -> &Volume<f32>| {
        let all = prints.iter().filter(|_| is_wanted);
        all.map(|print| volume_of(print).clone()).collect()
    };
    let each = species.iter().zip(prints).filter(|_| wants.target);
    progress.snapshot(Snapshot {
        iteration: None,
        patterns: if wants.patterns {
            shown.to_vec()
        } else {
            Vec::new()
        },
        dose: copies(wants.dose, |print| &print.dose),
        print: copies(wants.print, |print| &print.response),
        target: each
            .map(|(species, print)| print.fine.shown(species))
            .collect(),
    });
}

/// Numbers as they were published, and those of each slice.
type PublishedNumbers = (Vec<Published>, Vec<Slice>);

/// What is measured of a print.
struct Measured {
    response: Volume<f32>,
    evaluation: Evaluation,
    deviation: Option<Deviation>,
    published: Option<PublishedNumbers>,
}

/// Measures a print; of the first one its surface and the numbers of publications, too.
fn numbers(
    job: &ResolvedJob,
    s: usize,
    fine: &Voxels,
    dose: Volume<f32>,
    shown: &[Patterns],
    stats: PatternStats,
    work: &Work,
) -> Result<Measured> {
    let (species, is_first) = (&job.species[s], s == 0);
    let material = species.goal.response.as_ref();
    let options = published::Options {
        response: material,
        gray: fine.target.gray,
        patterns: shown,
        is_absorbed: job.is_absorbed(s),
        trim_percent: job.evaluation().trim_percent,
        epsilon: species.half_width(),
    };
    let inside = &fine.target.inside;
    let work = work.part(share::PUBLISHED / job.species.len() as f64);
    let is_dose = material.is_identity();
    let mut published = None;
    if is_first && !is_dose {
        let print = Print::new(&fine.labels, &dose)?;
        published = Some(published::of_print(&print, inside, &options)?);
    }
    let response = if is_dose {
        dose
    } else {
        species.goal.responses(dose)
    };
    let print = print(job, species, fine, &response, work)?.with_patterns(stats);
    if is_first && is_dose {
        // The dose is the response: what was counted of one serves the other
        published = Some(published::of_print(&print, inside, &options)?);
    }
    let evaluation = evaluate(&print);
    let deviation = is_first.then(|| print.into_measured_deviation());
    Ok(Measured {
        evaluation,
        deviation: deviation.flatten(),
        published,
        response,
    })
}

/// Warnings of a print, sent at once: how sure its model is, and what looks wrong in its patterns and its job.
fn doubts_of(
    job: &ResolvedJob,
    shown: &[Patterns],
    prints: &[SpeciesPrint],
    noise: &Option<Noise>,
    agreement: &Option<CrossCheck>,
    progress: &mut dyn Progress,
) -> Result<Vec<String>> {
    let evaluation = &prints[0].evaluation;
    let of_paths = noise.map(|noise| format!("Monte Carlo paths: {noise}"));
    let of_orders = agreement.map(|agreement| format!("scattering by orders: {agreement}"));
    for text in of_paths.into_iter().chain(of_orders) {
        progress.event(&Event::Note { text });
    }
    let too_thin = match job.sees_own_voxels() {
        true => Vec::new(),
        false => job.too_thin(prints.iter().map(|print| &print.fine.target)),
    };
    let warnings: Vec<String> = noise
        .and_then(|noise| noise.warning())
        .into_iter()
        .chain(agreement.and_then(|agreement| agreement.warning()))
        .chain(doubts::of_light(shown))
        .chain(doubts::of_dose(evaluation, shown))
        .chain(doubts::of_bound(job, shown))
        .chain(doubts::of_background(job, shown))
        .chain(doubts::of_threshold(job, evaluation))
        .chain(too_bright(job, shown)?)
        .chain(too_thin)
        .collect();
    for text in warnings.iter().cloned() {
        progress.event(&Event::Warning { text });
    }
    Ok(warnings)
}

/// All species at one exposure, and what each prints then, reported at once.
fn together(
    job: &ResolvedJob,
    prints: &[SpeciesPrint],
    warnings: &mut Vec<String>,
    progress: &mut dyn Progress,
) -> Option<OneExposure> {
    // Gray values have no threshold that one dose could meet
    let is_gray = |print: &SpeciesPrint| print.evaluation.half_width.is_some();
    if prints.len() < 2 || prints.iter().any(is_gray) {
        return None;
    }
    let named = || {
        let species = job.species.iter().zip(prints);
        species
            .map(|(species, print)| (species.name.as_deref().unwrap_or_default(), species, print))
    };
    let over_doses = |(name, species, print): (_, &Species, &SpeciesPrint)| {
        let response = &species.goal.response;
        let dose =
            |&[threshold, iou]: &[f64; 2]| [f64::from(response.inverse(threshold as f32)), iou];
        let curve: Vec<[f64; 2]> = print.evaluation.curve.iter().map(dose).collect();
        (name, curve)
    };
    let curves: Vec<_> = named().map(over_doses).collect();
    let Some(together) = OneExposure::of(&curves) else {
        let text = "no exposure prints something of every species: one of them gets too little light next to the others. The numbers of each species are those of its own best exposure".to_owned();
        warnings.push(text.clone());
        progress.event(&Event::Warning { text });
        return None;
    };
    for ((name, _, print), iou) in named().zip(&together.iou) {
        let evaluation = &print.evaluation;
        let alone = evaluation.measures.get("iou").zip(evaluation.gel_threshold);
        if let Some((best, threshold)) = alone {
            let text = format!(
                "{name}: IoU {best:.4} at a threshold of {threshold:.3}; {iou:.4} together with the others, where all networks gel at a dose of {:.3}",
                together.gel_dose
            );
            progress.event(&Event::Note { text });
        }
    }
    Some(together)
}

/// The print in time on the job's voxels, where the job has a schedule.
fn in_time(
    job: &ResolvedJob,
    voxels: &[Voxels],
    shown: &[Patterns],
    progress: &mut dyn Progress,
    work: &Work,
) -> Result<Option<InTime>> {
    if job.schedule().is_none() {
        return Ok(None);
    }
    let text = "printing in time, on the job's voxels".to_owned();
    progress.event(&Event::Note { text });
    print_in_time(job, voxels, shown, work)
}

/// Numbers of what is solid at this response.
pub(crate) fn measure_at(
    job: &ResolvedJob,
    voxels: &Voxels,
    response: &Volume<f32>,
    threshold: f64,
    patterns: &[Patterns],
) -> Result<Evaluation> {
    let mut print = Print::under(&voxels.labels, response, Work::new())?
        .with_most_triangles(job.most_triangles())
        .with_inside(&voxels.target.inside)?
        .with_target_surface(&voxels.surface)
        .with_threshold(threshold)?
        .with_patterns(PatternStats::of(patterns));
    if !job.evaluation().surfaces {
        print = print.without_distance();
    }
    Ok(evaluate(&print).with_sub_angles(job.most_evaluated_angles()))
}

/// Shares of an evaluation, as an index-matched job on voxels half as large takes them.
mod share {
    /// The print in time, of a job that has a schedule: what it takes depends on the schedule, and was not measured. The others share the rest.
    pub(crate) const IN_TIME: f64 = 0.5;
    /// Dose and numbers on the job's voxels, each: of the raw patterns, of the written ones, and of these while the vial turns.
    pub(crate) const OWN_DOSE: f64 = 0.06;
    pub(crate) const OWN_NUMBERS: f64 = 0.04;
    /// The finer voxels.
    pub(crate) const SAMPLING: f64 = 0.06;
    /// Their dose.
    pub(crate) const TURNING: f64 = 0.33;
    /// Its numbers, with the published ones.
    pub(crate) const PUBLISHED: f64 = 0.31;
}

/// The one number that says how good a print is: IoU, or the rms error of a gray target.
pub(crate) fn headline(is_gray: bool) -> &'static MetricKind {
    if is_gray { &gray::RMS } else { &iou::KIND }
}

/// The best IoU over all thresholds, where the job names one; None for gray targets.
pub(crate) fn at_best_threshold(job: &ResolvedJob, evaluation: &Evaluation) -> Measure {
    job.evaluation().threshold?;
    match evaluation.latitude? {
        Latitude::Thresholds { iou, .. } => Some(iou),
        Latitude::Exposures { .. } => None,
    }
}

/// What the metrics look at, as a part of a run.
pub(crate) fn print<'a>(
    job: &ResolvedJob,
    species: &Species,
    voxels: &'a Voxels,
    response: &'a Volume<f32>,
    work: Work,
) -> Result<Print<'a>> {
    let inside = &voxels.target.inside;
    let mut print = Print::under(&voxels.labels, response, work)?
        .with_most_triangles(job.most_triangles())
        .with_inside(inside)?
        .with_target_surface(&voxels.surface)
        .with_response(species.goal.response.clone());
    if !job.evaluation().surfaces {
        print = print.without_distance();
    }
    if voxels.target.gray {
        print = print.with_gray(inside, species.half_width())?;
    }
    if let Some(threshold) = job.evaluation().threshold {
        print = print.with_threshold(threshold)?;
    }
    Ok(print)
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

#[cfg(test)]
mod tests {
    use super::*;
    use crate::job::progress::Silent;
    use crate::job::tests::job_of;

    #[test]
    fn what_turning_costs_is_measured_on_the_voxels_of_the_job() {
        let text = r#"
            target = { phantom = { sphere = {} }, size_mm = 1.0 }
            grid = { pitch_mm = 0.1 }
            resin = { refractive_index = 1.5, absorption_per_mm = 0.1 }
            vial = { index_matched = { radius_mm = 2.0 } }
            light = [{ pixels = [20, 14], angles = 8, sub_angles = 1, projector = { collimated = { pixel_pitch_mm = 0.1 } } }]
        "#;
        let evaluated = |changes: &[&str], has_raw: bool| {
            let job = ResolvedJob::under(&job_of(text, changes), &Work::new()).unwrap();
            let mut patterns = Patterns::dark(job.optics.lights[0].pixels.clone());
            for (i, value) in patterns.values.iter_mut().enumerate() {
                let is_lit = (5..15).contains(&(i % 20)) && (2..12).contains(&(i / 20 % 14));
                *value = f32::from(u8::from(is_lit)) * (0.5 + (i % 7) as f32);
            }
            let (shown, run) = ([patterns], Work::new());
            let voxels = job.own_voxels(&run).unwrap();
            let raw = has_raw.then_some(&shown[..]);
            let origin = Origin {
                raw,
                ..Origin::default()
            };
            evaluate_patterns(&job, voxels, &shown, origin, &mut Silent, &run).unwrap()
        };
        let steps_of = |changes: &[&str], has_raw| {
            let evaluated = evaluated(changes, has_raw);
            let print = evaluated.first();
            let iou = |print: &Evaluation| print.measures.get("iou");
            let unwritten = print.optimization.as_ref().and_then(iou);
            let steps = [unwritten, print.written, print.own_turning];
            (steps, iou(&print.evaluation))
        };
        let (coarse, coarse_print) = steps_of(&["evaluate.refine=1"], true);
        let ([unwritten, written, turning], fine_print) = steps_of(&["evaluate.refine=2"], true);
        assert!(unwritten.is_some() && unwritten == written && written != turning);
        assert!(turning == coarse_print && turning != fine_print);
        assert_eq!(coarse, [unwritten, written, turning]);
        // Of frames
        for refine in ["evaluate.refine=1", "evaluate.refine=2"] {
            assert_eq!(steps_of(&[refine], false).0, [None, written, turning]);
        }
        // Nothing to ask
        let counted = ["evaluate.refine=2", "light.sub_angles=6"];
        assert_eq!(steps_of(&counted, true).0, [turning, turning, None]);
        assert_eq!(steps_of(&counted, false).0, [None; 3]);
        let standing = ["evaluate.refine=1", "evaluate.sub_angles=1"];
        assert_eq!(
            steps_of(&standing, true),
            ([written, written, None], written)
        );
    }

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
