//! Where an optimization begins, and the bounds that follow from it.

use super::stage::Stage;
use crate::error::{Error, Result};
use crate::field::{Field, HostField};
use crate::grid::Volume;
use crate::job::dose::cache::{BoundingStart, RunCache, start_key};
use crate::job::resolve::species::{Row as SpeciesRow, against_inhibition, beginnings};
use crate::job::resolve::{ResolvedJob, Voxels};
use crate::models::{DoseModel, PatternLayout, Quantity, Work};
use crate::objective::{Objective, Sum};
use crate::optimize;
use crate::optimize::Limits;
use crate::optimize::start::given::{Given, GivenFiles, OfFile};
use crate::optimize::start::{InitialPatterns, StartInput};
use crate::response::Response;
use std::borrow::Cow;

/// What a start or a method's marks are computed from; `absorption` where it is a map.
pub(crate) fn start_input<'a, F: Field>(
    model: &'a dyn DoseModel<Field = F>,
    voxels: &'a Voxels,
    absorption: Option<&'a Volume<f32>>,
    response: &'a dyn Response,
    limits: &'a [Limits],
) -> StartInput<'a, F> {
    StartInput {
        model,
        target: &voxels.target,
        labels: &voxels.labels,
        response,
        limits,
        absorption,
    }
}

/// Part of the mean energy of lit pixels that every pixel has at the start of amplitudes: one that is dark, and lights nothing with
/// others together, would stay dark for ever.
const GLIMMER: f64 = 0.01;

/// Where the optimization begins: within the bounds that the job gives. A model whose unknowns are amplitudes begins at the
/// roots of what straight light would begin with.
pub(crate) fn starting_patterns(
    job: &ResolvedJob,
    voxels: &[Voxels],
    model: &dyn DoseModel<Field = HostField>,
    straight: Option<&dyn DoseModel<Field = HostField>>,
    start: &dyn InitialPatterns,
    work: &Work,
) -> Result<HostField> {
    // Files that are scaled are bounded after that
    let is_scaled = job.method.start.files().is_some_and(|files| files.scaled);
    let is_free = is_scaled && start.is_given() && model.is_linear();
    let limits = (0..job.optics.lights.len()).map(|light| match job.bounds_of(light) {
        (min, Some(max)) if !is_free => Limits { min, max },
        (min, _) => Limits {
            min: if is_free { 0.0 } else { min },
            max: f64::INFINITY,
        },
    });
    let limits: Vec<Limits> = limits.collect();
    let response = job.first().goal.response.as_ref();
    let absorption = job.optics.lights[0].absorption_on(&voxels[0].labels.grid);
    let input = |model| start_input(model, &voxels[0], absorption.as_ref(), response, &limits);
    let known = straight.unwrap_or(model);
    let mut x = match job.rows() {
        Some(rows) if !start.is_given() => {
            starting_lights(job, &rows, voxels, known, start, &limits, work)?
        }
        _ => start.patterns(&input(known), work)?,
    };
    if model.quantity() == Quantity::Energy {
        return Ok(x);
    }
    into_amplitudes(&mut x, GLIMMER)?;
    if start.is_given() && job.method.start.is_given() {
        return Ok(x);
    }
    // A pupil takes light that rays would have brought
    input(model).scaled_anew(x, work)
}

/// Brings patterns into bounds.
pub(crate) fn clip(x: &mut HostField, lights: &[PatternLayout], bounds: &[Limits]) -> Result<()> {
    let bounds = x.compile_bounds(&optimize::problem::bounds(lights, bounds)?);
    let step = x.zeros_like();
    x.move_along(&step, 0.0, &bounds);
    Ok(())
}

/// Where each light begins: with the species that it drives most, as if it were alone.
fn starting_lights(
    job: &ResolvedJob,
    rows: &[SpeciesRow],
    voxels: &[Voxels],
    model: &dyn DoseModel<Field = HostField>,
    start: &dyn InitialPatterns,
    limits: &[Limits],
    work: &Work,
) -> Result<HostField> {
    let mut x = model.new_patterns()?;
    for (i, begins) in beginnings(rows).into_iter().enumerate() {
        let (Some((s, factor)), Some(alone)) = (begins, model.of_light(i)) else {
            continue;
        };
        let response = job.species[s].goal.response.as_ref();
        let absorption = job.optics.lights[i].absorption_on(&voxels[s].labels.grid);
        let (map, limits) = (absorption.as_ref(), &limits[i..=i]);
        let input = start_input(&*alone, &voxels[s], map, response, limits);
        let mut patterns = start.patterns(&input, work)?;
        patterns.scale((factor * job.dose_needed(s, i)?) as f32);
        x.as_mut_slice()[model.patterns()[i].range()].copy_from_slice(patterns.as_slice());
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
/// normalizes its doses has another scale, about which the start says nothing.
pub(crate) fn limits(
    job: &ResolvedJob,
    model: &dyn DoseModel<Field = HostField>,
    start: &HostField,
) -> Vec<Limits> {
    let quantity = model.quantity();
    let of_all = start.max_abs();
    let alone = |layout: &PatternLayout| {
        let pixels = &start.as_slice()[layout.range()];
        let brightest = pixels.iter().fold(0.0f32, |most, v| most.max(v.abs()));
        let largest = start.largest(brightest);
        // A light that begins dark may become as bright as the others
        if largest > 0.0 { largest } else { of_all }
    };
    let times = job.mixing.as_deref().map(against_inhibition);
    let lights = model.patterns().iter().enumerate();
    let limits = lights.map(|(light, layout)| {
        let (largest, times) = match &times {
            None => (of_all, 1.0),
            Some(times) => (alone(layout), times[light]),
        };
        let largest = times * f64::from(quantity.energy(largest));
        let (min, max) = job.bounds_of(light);
        let natural = if largest > min && !job.method.normalizes {
            largest
        } else {
            f64::INFINITY
        };
        Limits {
            min,
            max: max.unwrap_or(natural),
        }
    });
    limits.collect()
}

/// Where a run begins.
pub(crate) struct FirstPatterns {
    pub(crate) patterns: HostField,
    pub(crate) bounds: Vec<Limits>,
    /// The loss of the start that bounds the pixels, where that is another one and the run ends at a part of it.
    pub(crate) loss: Option<f64>,
}

impl Stage<'_> {
    /// The start that the job asks for (`given`: as this rank has it), within bounds that follow from it, or from the start that its files are to be bounded as; of
    /// several files the best, `brightens`: scaled to suit the objective.
    pub(crate) fn first_patterns(
        &self,
        given: Option<&Given>,
        brightens: bool,
        cache: &mut RunCache,
        model: Option<u64>,
        work: &Work,
    ) -> Result<FirstPatterns> {
        let job = self.job;
        let of_job = job.method.start.as_ref();
        let files = of_job.files();
        let start = given.map_or(of_job, |given| given as _);
        let mut patterns = self.start(start, work)?;
        let (bounds, loss) = match files.and_then(|files| files.bounds_as.as_deref()) {
            None => (None, None),
            Some(bounds_as) => {
                let model = model.filter(|_| !bounds_as.is_given());
                let key = model.map(|model| start_key(model, job)).transpose()?;
                let bounding = match cache.take_start(key) {
                    Some(bounding) => bounding,
                    None => self.bounding(bounds_as, work)?,
                };
                let bounds = self.limits(&bounding.patterns);
                let of_dose = |dose| Ok(self.objective(0)?.value(dose));
                let loss = bounding.dose.as_ref().map(of_dose).transpose()?;
                cache.put_start(key, bounding);
                (Some(bounds), loss)
            }
        };
        // Bounds that follow from patterns follow from scaled ones, after a resumption, too
        let brightens = brightens || bounds.is_none();
        if let Some(files) = files.filter(|files| files.scaled && brightens) {
            self.brighten(files, &mut patterns, bounds.as_deref(), work)?;
        }
        if let Some(bounds) = &bounds {
            clip(&mut patterns, self.model.patterns(), bounds)?;
        }
        Ok(FirstPatterns {
            bounds: bounds.unwrap_or_else(|| self.limits(&patterns)),
            patterns,
            loss,
        })
    }

    fn bounding(&self, start: &dyn InitialPatterns, work: &Work) -> Result<BoundingStart> {
        let patterns = self.start(start, work)?;
        let is_asked = self.job.stop().relative_loss.is_some();
        let mut dose = is_asked.then(|| self.model.new_dose()).transpose()?;
        if let Some(dose) = &mut dose {
            self.model.dose(&patterns, dose, work)?;
        }
        Ok(BoundingStart { patterns, dose })
    }

    /// Takes the patterns with the lowest loss, of those given, further files, and those given with the step between two files added; each as bright as
    /// suits the objective best; for doses that are linear in them. One dose call each, three where the bounds hold what would be brighter. Without
    /// bounds each has those that follow from it.
    fn brighten(
        &self,
        files: &GivenFiles,
        x: &mut HostField,
        bounds: Option<&[Limits]>,
        work: &Work,
    ) -> Result<()> {
        if !self.model.is_linear() {
            return Ok(());
        }
        let objective = self.objective(0)?;
        let mut dose = self.model.new_dose()?;
        let mut lowest = f64::INFINITY;
        let given = x.clone();
        let ahead = |[from, to]: &[OfFile; 2]| {
            let mut ahead = self.start(to, work)?;
            ahead.axpy(-1.0, &self.start(from, work)?);
            ahead.axpy(1.0, &given);
            Ok(ahead)
        };
        let as_given = || Ok(given.clone());
        let of_files = (files.or.iter()).map(|file| self.start(file, work));
        let further = of_files.chain(files.step.iter().map(ahead));
        let further = further.filter(|_| self.job.ranks.is_none());
        for candidate in std::iter::once_with(as_given).chain(further) {
            let (candidate, loss) = self.scaled(&objective, candidate?, &mut dose, bounds, work)?;
            if loss < lowest {
                lowest = loss;
                *x = candidate;
            }
            if lowest == 0.0 {
                break;
            }
        }
        Ok(())
    }

    /// Patterns times the factor with which their loss is lowest, within bounds, unless these spoil it; and that loss.
    #[expect(clippy::cast_possible_truncation, reason = "fields are f32")]
    fn scaled(
        &self,
        objective: &Sum<HostField>,
        mut x: HostField,
        dose: &mut HostField,
        bounds: Option<&[Limits]>,
        work: &Work,
    ) -> Result<(HostField, f64)> {
        let lights = self.model.patterns();
        // No light is negative
        clip(&mut x, lights, &vec![Limits::default(); lights.len()])?;
        self.model.dose(&x, dose, work)?;
        let (factor, loss) = optimize::brightness::lowest(&|factor| {
            let mut scaled = dose.clone();
            scaled.scale(factor as f32);
            objective.value(&scaled)
        });
        let within = |patterns: &HostField| {
            let bounds = bounds.map_or_else(|| Cow::Owned(self.limits(patterns)), Cow::Borrowed);
            let mut within = patterns.clone();
            clip(&mut within, lights, &bounds).map(|()| within)
        };
        let mut scaled = x.clone();
        scaled.scale(factor as f32);
        let clipped = within(&scaled)?;
        // Ranks ask for a dose together
        if !x.any(clipped.as_slice() != scaled.as_slice()) {
            return Ok((scaled, loss));
        }
        let mut lowest = (scaled, f64::INFINITY);
        for patterns in [clipped, within(&x)?] {
            self.model.dose(&patterns, dose, work)?;
            let loss = objective.value(dose);
            if loss < lowest.1 {
                lowest = (patterns, loss);
            }
        }
        Ok(lowest)
    }
}
