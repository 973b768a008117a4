//! The method of a job: optimizer, penalties and start, read once, tried with the goal of a species on a few voxels before any work, and refused where
//! they do not go together.

use super::free_parameters::{self, FreeParameters};
use super::goal::Goal;
use crate::error::{Error, Result};
use crate::field::{Field, HostField};
use crate::grid::{Volume, VolumeGrid};
use crate::job::spec::JobSpec;
use crate::job::spec::all_errors::penalty_weight;
use crate::kind::{Kind, Section};
use crate::models::cells::Cells;
use crate::models::{DoseLayout, Family, PatternLayout};
use crate::objective::penalty::{MakePenalty, PENALTIES, Penalties};
use crate::objective::{Objective, ObjectiveInput};
use crate::optimize::start::{InitialPatterns, STARTS};
use crate::optimize::{BuildOptimizer, OPTIMIZERS, Optimizer, Requirements, optimizers};
use crate::response::{Response, dose_for};
use crate::target::{Target, label, label_voxels};
use crate::units::exact;
use serde_json::Value;
use std::path::Path;
use std::sync::Arc;

/// Mean change of the loss over five steps, relative to it, at which the optimization ends where the job names none. Eq. 28 of Li et al. 2024 has 0.001, at which
/// some prints of `docs/choices.md` still become better.
const STEADY: f64 = 0.0005;

/// How patterns are searched: parameters that are typed and in their ranges, and what the rest of the job asks of them.
pub(crate) struct Method {
    /// Where the optimizer begins.
    pub(crate) start: Arc<dyn InitialPatterns>,
    /// What else the optimizer needs.
    pub(crate) requirements: Requirements,
    /// Whether it divides doses by their largest.
    pub(crate) normalizes: bool,
    /// Which parameters of the response are unknowns.
    pub(crate) free: Option<FreeParameters>,
    optimizer: Section,
    /// How many steps the optimizer remembers, where it remembers any.
    pairs: Option<usize>,
    /// Each with its weight.
    penalties: Vec<(f64, Arc<dyn MakePenalty>)>,
}

fn penalty(i: usize, value: &Value) -> Result<(f64, Arc<dyn MakePenalty>)> {
    let mut section = Section::new(format!("penalties[{i}]"), value.clone()).without(&["weight"]);
    let keys = section.value.as_object_mut();
    let weight = keys.and_then(|map| map.remove("weight"));
    let weight = penalty_weight(i, weight.as_ref())?;
    Ok((weight, section.read(PENALTIES)?))
}

impl Method {
    /// Reads the method of a job; `base` is where its files begin.
    pub(crate) fn read(spec: &JobSpec, base: &Path) -> Result<Self> {
        let section = |key: &str, value: &Value| Section::new(key, value.clone()).based(base);
        let optimizer = section("optimizer", &spec.optimizer);
        let penalties = spec
            .penalties
            .iter()
            .enumerate()
            .map(|(i, value)| penalty(i, value));
        let penalties = penalties.collect::<Result<_>>()?;
        let made = optimizer.read(OPTIMIZERS)?;
        let method = made.make()?;
        Ok(Method {
            start: Arc::from(section("start", &spec.start).read(STARTS)?),
            requirements: method.requirements(),
            normalizes: method.normalizes(),
            free: FreeParameters::of(spec, base)?,
            optimizer,
            penalties,
            pairs: made.pairs(),
        })
    }

    pub(crate) fn optimizer<F: Field>(&self) -> Result<Box<dyn Optimizer<F>>> {
        let optimizer = self.optimizer.read(optimizers::<F>())?;
        let remembering = self.pairs.and_then(|pairs| optimizer.with_pairs(pairs));
        remembering.unwrap_or(optimizer).make()
    }

    /// The sum of the penalties.
    pub(crate) fn penalties<F: Field>(&self, lights: &[PatternLayout]) -> Result<Penalties<F>> {
        let make =
            |(weight, penalty): &(f64, Arc<dyn MakePenalty>)| Ok((*weight, penalty.make(lights)?));
        Penalties::new(self.penalties.iter().map(make).collect::<Result<_>>()?)
    }

    /// The optimizer's name in a job.
    pub(crate) fn name(&self) -> &'static str {
        self.requirements.name
    }

    /// How many steps the optimizer remembers, where it remembers any.
    pub(crate) fn pairs(&self) -> Option<usize> {
        self.pairs
    }

    /// Mean change of the loss at which the optimization ends where the job names none; 0: never, because the losses of other methods than `lbfgs` rise and fall
    /// on their way.
    pub(crate) fn steady(&self) -> f64 {
        if self.pairs.is_some() { STEADY } else { 0.0 }
    }

    /// Lets the optimizer remember so many steps, where it remembers any.
    pub(crate) fn set_pairs(&mut self, pairs: usize) {
        self.pairs = self.pairs.map(|_| pairs);
    }

    /// Whether a penalty compares pixels of different frames.
    pub(crate) fn penalizes_frames(&self) -> bool {
        let mut penalties = self.penalties.iter();
        penalties.any(|(_, penalty)| penalty.joins_frames())
    }

    /// Whether it compares doses with the target itself, and so knows part and void alone, instead of minimizing the objectives.
    pub(crate) fn needs_target(&self) -> bool {
        self.requirements.target.is_some()
    }
}

/// Makes the objective on a few voxels, so that what the job cannot have is refused before heavy work.
pub(crate) fn try_kinds(
    spec: &JobSpec,
    goal: &Goal,
    method: &Method,
    model: Option<&Family>,
    gray: bool,
) -> Result<()> {
    let grid = VolumeGrid::centered([4, 4, 4], 0.1);
    let mut layout = DoseLayout::new("dose", grid.clone(), 0);
    if goal.cells_key().is_some() {
        let halves = Volume::filled(grid.clone(), 0.5);
        let cells = Cells::new(&layout, &halves);
        layout = layout.with_cells(Arc::new(cells));
    }
    let target = Target {
        name: String::new(),
        // Part and void, so that the bands of both are tried
        inside: Volume {
            values: (0..grid.len()).map(|i| (i % 2) as f32).collect(),
            grid,
        },
        gray,
    };
    let labels = label_voxels(&target, |_| true);
    let response = Arc::clone(&goal.response);
    let input = ObjectiveInput {
        layout: &layout,
        labels: &labels,
        target: &target,
        response: Arc::clone(&response),
    };
    let objective = goal.on_host().sum(&input, false)?;
    solid_at(spec, response.as_ref())?;
    method.penalties::<HostField>(&[])?;
    let is = Are {
        linear: model.is_none_or(|model| model.capabilities().is_linear()),
        in_time: spec.optimizes_cure(),
        convex: objective.is_convex(),
        tolerant: gray || tolerates_dose(&objective, &layout, &labels),
    };
    fit_together(spec, &method.requirements, is)?;
    free_parameters::must_be_minimized(goal, method)?;
    // Of a gray target the values are not known yet
    if method.start.asks_for_doses() && !gray {
        dose_for(response.as_ref(), 1.0).map_err(|e| e.under("response"))?;
    }
    Ok(())
}

/// A dose that no void of a print can do without.
const LITTLE: f32 = 1e-3;

/// Whether an objective leaves some void voxel alone that has a little dose.
fn tolerates_dose(
    objective: &dyn Objective<HostField>,
    layout: &DoseLayout,
    labels: &Volume<u8>,
) -> bool {
    let dose = HostField::from_slice(&vec![LITTLE; layout.len()]);
    let mut slope = dose.zeros_like();
    objective.value_and_gradient(&dose, &mut slope);
    let labels = layout.field_of(labels);
    let mut voxels = labels.iter().zip(slope.as_slice()).take(layout.voxels());
    voxels.any(|(&label, &slope)| label == label::VOID && slope <= 0.0)
}

/// Refuses a threshold at which no dose makes the resin solid, or every one.
fn solid_at(spec: &JobSpec, response: &dyn Response) -> Result<()> {
    let [low, high] = response.range();
    match spec.evaluate.threshold {
        Some(threshold) if threshold <= low || threshold >= high => Err(Error::config(
            "evaluate.threshold",
            format!(
                "found {}, but the response goes from {} to {}",
                exact(threshold),
                exact(low),
                exact(high)
            ),
            "a response between these two",
        )),
        _ => Ok(()),
    }
}

/// What a job's model and objective are.
#[derive(Clone, Copy)]
struct Are {
    linear: bool,
    /// Whether patterns are optimized against a print with a memory.
    in_time: bool,
    convex: bool,
    tolerant: bool,
}

/// Refuses a setting that the optimizer cannot work with, with the key of that setting.
fn fit_together(spec: &JobSpec, needs: &Requirements, is: Are) -> Result<()> {
    let method = format!("optimizer.{}", needs.name);
    for (reason, is_there, key, other) in [
        (
            needs.continuous,
            spec.bounds.bits.is_some(),
            "bounds.bits",
            "rounding in every step",
        ),
        (
            needs.unpenalized,
            !spec.penalties.is_empty(),
            "penalties[0]",
            "penalties",
        ),
    ] {
        if let Some(reason) = reason.filter(|_| is_there) {
            return Err(Error::config(
                key,
                format!("{method} with {other}: {reason}"),
                "only one of the two",
            ));
        }
    }
    let not_convex = "an objective and a response that are not convex together";
    let convex = |needs: &Requirements| needs.convex;
    let linear = |needs: &Requirements| needs.linear;
    let tolerant = |needs: &Requirements| needs.tolerant;
    let no_dose = "an objective that allows no dose at all in the void ([objective.osmo] and \
                   [objective.threshold] allow some)";
    let cases: [(Reason, bool, &str); 4] = [
        (convex, !is.convex, not_convex),
        (linear, !is.linear, "waves"),
        (linear, is.in_time, "a print in time (schedule.optimize)"),
        (tolerant, !is.tolerant, no_dose),
    ];
    for (need, is_there, other) in cases {
        if let Some(reason) = need(needs).filter(|_| is_there) {
            return Err(Error::config(
                method,
                format!("cannot be combined with {other}: {reason}"),
                methods_without(need),
            ));
        }
    }
    Ok(())
}

/// Why a method needs something.
type Reason = fn(&Requirements) -> Option<&'static str>;

/// The optimizers that do not need it.
fn methods_without(need: Reason) -> String {
    let needs = |row: &Kind<BuildOptimizer>| {
        let example: toml::Table = row.example.parse().ok()?;
        let value = serde_json::to_value(example.get("optimizer")?.get(row.name)?).ok()?;
        let method = (row.build)(&Section::new("optimizer", value)).ok()?;
        Some(method.make().ok()?.requirements())
    };
    let names = optimizers::<HostField>().iter().filter_map(|row| {
        let without = need(&needs(row)?).is_none();
        without.then_some(row.name)
    });
    names.collect::<Vec<_>>().join(", ")
}

/// Refuses goals that count part and void for a target that has none, and the other way round.
pub(crate) fn counted_as(spec: &JobSpec, gray: bool) -> Result<()> {
    let (stop, evaluate) = (&spec.stop, &spec.evaluate);
    let of_part = "needs a target of part and void, but this one is gray";
    let of_gray = "needs a gray target, but this one has part and void";
    for (key, is_there, found, accepted) in [
        (
            "stop.iou",
            gray && stop.iou.is_some(),
            of_part,
            "stop.loss (bclp: 0 when every voxel is in its band) or stop.change",
        ),
        (
            "evaluate.require_iou",
            gray && evaluate.require_iou.is_some(),
            of_part,
            "evaluate.require_in_band, the share of voxels in their bands",
        ),
        (
            "evaluate.require_in_band",
            !gray && evaluate.require_in_band.is_some(),
            of_gray,
            "evaluate.require_iou",
        ),
    ] {
        if is_there {
            return Err(Error::config(key, found, accepted));
        }
    }
    Ok(())
}
