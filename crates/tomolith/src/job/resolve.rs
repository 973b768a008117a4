//! The kinds that a job names: built, tried on a few voxels before any work, and refused where they do not go together.

use super::cells;
use super::scene::at_section;
use super::spec::JobSpec;
use crate::error::{Error, Result};
use crate::field::{Field, HostField};
use crate::grid::{Volume, VolumeGrid};
use crate::kind::{Kind, Section};
use crate::models::cells::Cells;
use crate::models::{DoseLayout, Family, PatternLayout};
use crate::objective::penalty::{PENALTIES, Penalties};
use crate::objective::voxel_weights::{Common, Ground};
use crate::objective::{OBJECTIVES, Objective, ObjectiveInput, Sum};
use crate::optimize::start::{InitialPatterns, STARTS};
use crate::optimize::{BuildOptimizer, OPTIMIZERS, Optimizer, Requirements};
use crate::response::{RESPONSES, Response, dose_for};
use crate::target::{Target, label, label_voxels};
use crate::units::exact;
use serde_json::Value;
use std::path::Path;
use std::sync::Arc;

pub(super) fn response(section: Section) -> Result<Arc<dyn Response>> {
    let (kind, inner) = section.kind(RESPONSES)?;
    Ok(Arc::from((kind.build)(&inner)?))
}

pub(super) fn optimizer(spec: &JobSpec) -> Result<Box<dyn Optimizer<HostField>>> {
    let section = Section::new("optimizer", spec.optimizer.clone());
    let (kind, inner) = section.kind(OPTIMIZERS)?;
    (kind.build)(&inner)
}

pub(super) fn start(spec: &JobSpec) -> Result<Box<dyn InitialPatterns>> {
    let section = Section::new("start", spec.start.clone());
    let (kind, inner) = section.kind(STARTS)?;
    (kind.build)(&inner)
}

/// The sum of a job's objectives; `base` is where files begin, `on_grid` whether fields of voxels fit the input's grid.
pub(super) fn objectives(
    spec: &JobSpec,
    input: &ObjectiveInput<'_>,
    base: &Path,
    on_grid: bool,
) -> Result<Sum<HostField>> {
    let mut parts: Vec<(f64, Box<dyn Objective<HostField>>)> = Vec::new();
    for section in spec.objectives()? {
        let path = section.path.clone();
        let (common, section) = Common::split(section)?;
        let mut input = input.clone();
        if let Some(own) = &common.response {
            let own = Section::new(format!("{path}.response"), own.clone());
            input.response = response(own.based(base))?;
        }
        let (kind, inner) = section.kind(OBJECTIVES)?;
        let mut objective = (kind.build)(&inner, &input).map_err(|e| at_section(&inner.path, e))?;
        let ObjectiveInput {
            layout,
            labels,
            target,
            ..
        } = input;
        let ground = Ground {
            layout,
            labels,
            target,
            base,
        };
        let (weight, knows_tolerance) = (common.weight, common.knows_tolerance());
        let common = if on_grid {
            common
        } else {
            common.without_fields()
        };
        let voxel_weights = common.voxel_weights(&ground).map_err(|e| e.under(&path))?;
        objective.set_voxel_weights(&voxel_weights)?;
        if on_grid || knows_tolerance {
            objective
                .must_be_reached()
                .map_err(|e| e.under(&inner.path))?;
        }
        parts.push((weight, objective));
    }
    Sum::new(parts)
}

/// The sum of a job's penalties.
pub(super) fn penalties(spec: &JobSpec, lights: &[PatternLayout]) -> Result<Penalties<HostField>> {
    let mut parts = Vec::new();
    for (i, value) in spec.penalties.iter().enumerate() {
        let mut section = Section::new(format!("penalties[{i}]"), value.clone());
        let weight = section
            .value
            .as_object_mut()
            .and_then(|map| map.remove("weight"));
        let weight = weight.as_ref().and_then(Value::as_f64).ok_or_else(|| {
            Error::config(
                format!("penalties[{i}].weight"),
                weight.map_or("the key is missing".to_owned(), |w| format!("found {w}")),
                "a number, 0 or more",
            )
        })?;
        let (kind, inner) = section.kind(PENALTIES)?;
        parts.push((weight, (kind.build)(&inner, lights)?));
    }
    Penalties::new(parts)
}

/// Builds every kind once on a few voxels, so that bad parameters are refused before heavy work.
pub(super) fn try_kinds(
    spec: &JobSpec,
    model: Option<&Family>,
    grey: bool,
    base: &Path,
) -> Result<()> {
    let grid = VolumeGrid::centered([4, 4, 4], 0.1);
    let mut layout = DoseLayout::new("dose", grid.clone(), 0);
    if cells::key(spec)?.is_some() {
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
        grey,
    };
    let labels = label_voxels(&target, |_| true);
    let response = response(Section::new("response", spec.response.clone()).based(base))?;
    let objective = objectives(
        spec,
        &ObjectiveInput {
            layout: &layout,
            labels: &labels,
            target: &target,
            response: response.clone(),
        },
        base,
        false,
    )?;
    solid_at(spec, response.as_ref())?;
    penalties(spec, &[])?;
    let is = Are {
        linear: model.is_none_or(|model| model.capabilities().is_linear()),
        convex: objective.is_convex(),
        tolerant: grey || tolerates_dose(&objective, &layout, &labels),
    };
    fit_together(spec, &optimizer(spec)?.requirements(), is)?;
    start(spec)?;
    // Of a gray target the values are not known yet
    if asks_for_doses(spec)? && !grey {
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

/// Whether the start asks for the doses with which the material responds as the target wants.
pub(super) fn asks_for_doses(spec: &JobSpec) -> Result<bool> {
    let (kind, _) = Section::new("start", spec.start.clone()).kind(STARTS)?;
    Ok(!["zero", "patterns"].contains(&kind.name))
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
    convex: bool,
    tolerant: bool,
}

/// Refuses what an optimizer cannot have beside it, with the key of the other.
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
    let cases: [(Reason, bool, &str); 3] = [
        (convex, !is.convex, not_convex),
        (linear, !is.linear, "waves"),
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
        Some(
            (row.build)(&Section::new("optimizer", value))
                .ok()?
                .requirements(),
        )
    };
    let names = OPTIMIZERS.iter().filter_map(|row| {
        let without = need(&needs(row)?).is_none();
        without.then_some(row.name)
    });
    names.collect::<Vec<_>>().join(", ")
}

/// Refuses goals that count part and void for a target that has none, and the other way round.
pub(super) fn counted_as(spec: &JobSpec, grey: bool) -> Result<()> {
    let (stop, evaluate) = (&spec.stop, &spec.evaluate);
    let of_part = "needs a target of part and void, but this one is gray";
    let of_gray = "needs a gray target, but this one has part and void";
    for (key, is_there, found, accepted) in [
        (
            "stop.iou",
            grey && stop.iou.is_some(),
            of_part,
            "stop.loss (bclp: 0 when every voxel is in its band) or stop.change",
        ),
        (
            "evaluate.require_iou",
            grey && evaluate.require_iou.is_some(),
            of_part,
            "evaluate.require_in_band, the share of voxels in their bands",
        ),
        (
            "evaluate.require_in_band",
            !grey && evaluate.require_in_band.is_some(),
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
