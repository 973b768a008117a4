//! The kinds that a job names: built, tried on a few voxels before any work, and refused where they do not go together.

use super::in_time;
use super::scene::at_section;
use super::spec::JobSpec;
use crate::error::{Error, Result};
use crate::field::{Field, HostField};
use crate::grid::{Volume, VolumeGrid};
use crate::kind::{Kind, Section};
use crate::models::cells::Cells;
use crate::models::{DoseLayout, Family, PatternLayout};
use crate::objective::penalty::{BuildPenalty, PENALTIES, Penalties};
use crate::objective::preset::SurfaceHandling;
use crate::objective::voxel_weights::{Common, Ground};
use crate::objective::{
    BuildObjective, OBJECTIVES, OF_FRACTIONS, Objective, ObjectiveInput, Sum, process_window,
    threshold,
};
use crate::optimize::start::given::OfFile;
use crate::optimize::start::{BuildStart, InitialPatterns, STARTS};
use crate::optimize::{BuildOptimizer, OPTIMIZERS, Optimizer, Requirements};
use crate::response::{RESPONSES, Response, dose_for};
use crate::target::{Target, label, label_voxels};
use crate::units::exact;
use serde_json::Value;
use std::path::{Path, PathBuf};
use std::sync::Arc;

/// The kinds that a job names, read once: the row of each family's table, the section that it is built from, and what the rest of the job asks of it.
#[derive(Clone)]
pub(crate) struct JobKinds {
    /// What the material makes of a dose.
    pub(crate) response: Arc<dyn Response>,
    objectives: Vec<ObjectiveKind>,
    penalties: Vec<PenaltyKind>,
    optimizer: Named<BuildOptimizer>,
    start: Named<BuildStart>,
    /// The start whose largest pixel bounds the pixels, where it is another one.
    bounding: Option<Named<BuildStart>>,
    /// What the optimizer needs beside it.
    pub(crate) requirements: Requirements,
    /// Whether it divides doses by their largest.
    pub(crate) normalizes: bool,
    /// Where files begin.
    base: PathBuf,
}

/// A row of a family's table, and the section that names it.
#[derive(Clone)]
struct Named<B: 'static> {
    kind: &'static Kind<B>,
    section: Section,
}

impl<B> Named<B> {
    fn read(section: &Section, table: &'static [Kind<B>]) -> Result<Self> {
        let (kind, section) = section.kind(table)?;
        Ok(Named { kind, section })
    }

    /// A number among its parameters, where the job gives it.
    fn number(&self, key: &str) -> Option<f64> {
        self.section.value.get(key)?.as_f64()
    }
}

/// One objective of a job.
#[derive(Clone)]
struct ObjectiveKind {
    /// Its key, without the kind's name.
    path: String,
    common: Common,
    response: Arc<dyn Response>,
    /// None: a word that is no surface, which building it refuses.
    surface: Option<SurfaceHandling>,
    of: Named<BuildObjective>,
}

/// One penalty of a job.
#[derive(Clone)]
struct PenaltyKind {
    weight: f64,
    of: Named<BuildPenalty>,
}

pub(super) fn response(section: Section) -> Result<Arc<dyn Response>> {
    let (kind, inner) = section.kind(RESPONSES)?;
    Ok(Arc::from((kind.build)(&inner)?))
}

impl ObjectiveKind {
    fn read(section: Section, job: &Arc<dyn Response>, base: &Path) -> Result<Self> {
        let path = section.path.clone();
        let (common, section) = Common::split(section)?;
        let response = match &common.response {
            Some(own) => {
                let own = Section::new(format!("{path}.response"), own.clone());
                response(own.based(base))?
            }
            None => Arc::clone(job),
        };
        let of = Named::read(&section, OBJECTIVES)?;
        let surface = match of.section.value.get("surface").map(Value::as_str) {
            None if OF_FRACTIONS.contains(&of.kind.name) => Some(SurfaceHandling::Fraction),
            None | Some(Some("voxel")) => Some(SurfaceHandling::Voxel),
            Some(Some("fraction")) => Some(SurfaceHandling::Fraction),
            Some(Some("cells")) => Some(SurfaceHandling::Cells),
            Some(_) => None,
        };
        Ok(ObjectiveKind {
            path,
            common,
            response,
            surface,
            of,
        })
    }

    /// The objective of a dose; `on_grid` whether fields of voxels fit the input's grid.
    fn build(
        &self,
        input: &ObjectiveInput<'_>,
        base: &Path,
        on_grid: bool,
    ) -> Result<Box<dyn Objective<HostField>>> {
        let mut input = input.clone();
        input.response = Arc::clone(&self.response);
        let inner = &self.of.section;
        let build = self.of.kind.build;
        let mut objective = build(inner, &input).map_err(|e| at_section(&inner.path, e))?;
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
        let common = if on_grid {
            self.common.clone()
        } else {
            self.common.clone().without_fields()
        };
        let voxel_weights = common.voxel_weights(&ground);
        let voxel_weights = voxel_weights.map_err(|e| e.under(&self.path))?;
        let weighed = objective.set_voxel_weights(&voxel_weights);
        weighed.map_err(|e| at_section(&self.path, e.under(&self.path)))?;
        if on_grid || self.common.knows_tolerance() {
            objective
                .must_be_reached()
                .map_err(|e| e.under(&inner.path))?;
        }
        Ok(objective)
    }
}

impl PenaltyKind {
    fn read(i: usize, value: &Value) -> Result<Self> {
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
        let of = Named::read(&section, PENALTIES)?;
        Ok(PenaltyKind { weight, of })
    }
}

impl JobKinds {
    /// Reads the kinds of a job; `base` is where its files begin.
    ///
    /// # Errors
    /// [`Error::Config`] with the key of what is no kind, or of a parameter of the response or the optimizer.
    pub(super) fn read(spec: &JobSpec, base: &Path) -> Result<Self> {
        let of_job = Section::new("response", spec.response.clone());
        let response = response(of_job.based(base))?;
        let objective = |section| ObjectiveKind::read(section, &response, base);
        let objectives = spec.objectives()?.into_iter().map(objective);
        let objectives = objectives.collect::<Result<Vec<_>>>()?;
        let penalties = spec.penalties.iter().enumerate();
        let penalties = penalties.map(|(i, value)| PenaltyKind::read(i, value));
        let penalties = penalties.collect::<Result<Vec<_>>>()?;
        let optimizer = Section::new("optimizer", spec.optimizer.clone());
        let optimizer = Named::read(&optimizer, OPTIMIZERS)?;
        let method = (optimizer.kind.build)(&optimizer.section)?;
        let start = Section::new("start", spec.start.clone());
        let bounding = spec.start.pointer("/patterns/bounds_as");
        let bounding = bounding.map(|own| Section::new("start.patterns.bounds_as", own.clone()));
        let bounding = bounding.map(|own| Named::read(&own, STARTS)).transpose()?;
        Ok(JobKinds {
            objectives,
            penalties,
            requirements: method.requirements(),
            normalizes: method.normalizes(),
            optimizer,
            start: Named::read(&start, STARTS)?,
            bounding,
            response,
            base: base.to_owned(),
        })
    }

    /// A new optimizer.
    pub(super) fn optimizer(&self) -> Result<Box<dyn Optimizer<HostField>>> {
        (self.optimizer.kind.build)(&self.optimizer.section)
    }

    /// The optimizer's name in a job.
    pub(super) fn method(&self) -> &'static str {
        self.optimizer.kind.name
    }

    /// The same with an optimizer that keeps so many steps.
    pub(super) fn set_memory(&mut self, memory: usize) {
        self.optimizer.section.value["memory"] = memory.into();
    }

    /// Where the optimizer begins.
    pub(super) fn start(&self) -> Result<Box<dyn InitialPatterns>> {
        (self.start.kind.build)(&self.start.section)
    }

    /// The start whose largest pixel bounds the pixels; None where it is the one that the optimizer begins at.
    pub(super) fn bounding_start(&self) -> Result<Option<Box<dyn InitialPatterns>>> {
        let build = |own: &Named<BuildStart>| (own.kind.build)(&own.section);
        self.bounding.as_ref().map(build).transpose()
    }

    /// Whether given patterns are as bright as suits the objective best.
    pub(super) fn scales_start(&self) -> bool {
        self.starts_as_given() && self.start.section.value["scaled"] == Value::Bool(true)
    }

    /// Further patterns to choose from.
    pub(super) fn further_starts(&self) -> Vec<OfFile> {
        let files = self.start.section.value["or"].as_array();
        let files = files.into_iter().flatten().filter_map(Value::as_str);
        files.map(|file| OfFile(self.base.join(file))).collect()
    }

    /// Whether the start asks for the doses with which the material responds as the target wants.
    pub(super) fn asks_for_doses(&self) -> bool {
        !["zero", "patterns"].contains(&self.start.kind.name)
    }

    /// Whether it begins at patterns that are to be taken as they are.
    pub(super) fn starts_as_given(&self) -> bool {
        self.start.kind.name == "patterns"
    }

    /// The sum of the objectives; `on_grid` whether fields of voxels fit the input's grid.
    pub(super) fn objective(
        &self,
        input: &ObjectiveInput<'_>,
        on_grid: bool,
    ) -> Result<Sum<HostField>> {
        let build = |own: &ObjectiveKind| {
            let objective = own.build(input, &self.base, on_grid)?;
            Ok((own.common.weight, objective))
        };
        Sum::new(self.objectives.iter().map(build).collect::<Result<_>>()?)
    }

    /// The sum of the penalties.
    pub(super) fn penalties(&self, lights: &[PatternLayout]) -> Result<Penalties<HostField>> {
        let build =
            |own: &PenaltyKind| Ok((own.weight, (own.of.kind.build)(&own.of.section, lights)?));
        Penalties::new(self.penalties.iter().map(build).collect::<Result<_>>()?)
    }

    /// Whether a penalty compares pixels of different frames.
    pub(super) fn penalizes_frames(&self) -> bool {
        let angles = |own: &PenaltyKind| own.of.number("angles");
        self.penalties.iter().filter_map(angles).any(|w| w > 0.0)
    }

    /// What every objective may have, and its key.
    pub(super) fn common(&self) -> impl Iterator<Item = (&str, &Common)> {
        (self.objectives.iter()).map(|own| (own.path.as_str(), &own.common))
    }

    /// The key that asks for surface-aware cells, when there is one.
    pub(super) fn cells_key(&self) -> Option<String> {
        let has_cells = |own: &&ObjectiveKind| own.surface == Some(SurfaceHandling::Cells);
        let own = self.objectives.iter().find(has_cells)?;
        Some(format!("{}.surface", own.of.section.path))
    }

    /// Whether all objectives weigh a voxel by its inside fraction, none has numbers of its own for the job's voxels, and the method minimizes
    /// them: one that compares doses with the target itself knows part and void alone.
    pub(super) fn sees_fractions(&self) -> bool {
        let sees = |own: &ObjectiveKind| {
            own.surface == Some(SurfaceHandling::Fraction) && !own.common.has_fields()
        };
        self.requirements.target.is_none() && self.objectives.iter().all(sees)
    }

    /// Whether an objective looks for the process window itself.
    pub(super) fn seeks_window(&self) -> bool {
        let is_window = |own: &ObjectiveKind| own.of.kind.name == process_window::NAME;
        self.objectives.iter().any(is_window)
    }

    /// Half width ε of the band round gray values, of the first objective that has one.
    pub(super) fn epsilon(&self) -> Option<f64> {
        let mut objectives = self.objectives.iter();
        objectives.find_map(|own| own.of.number("epsilon"))
    }

    /// ε of the first BCLP objective.
    pub(super) fn bclp_epsilon(&self) -> Option<f64> {
        let bclp = |own: &&ObjectiveKind| own.of.kind.name == "bclp";
        let mut objectives = self.objectives.iter().filter(bclp);
        objectives.find_map(|own| own.of.number("epsilon"))
    }

    /// The same with a wider window: what the void may have at most is `lower`. None where the job has another objective, or names thresholds.
    pub(super) fn with_lower(&self, lower: f64) -> Option<Self> {
        self.with_threshold("lower", lower, &["lower", "upper"])
    }

    /// The same with deviations to another power. None where the job has another objective, or names the power.
    pub(super) fn with_exponent(&self, exponent: f64) -> Option<Self> {
        self.with_threshold("exponent", exponent, &["exponent"])
    }

    /// The same with another number in its one objective, where that is [`threshold`] and the job names none of some keys.
    fn with_threshold(&self, key: &str, number: f64, unless: &[&str]) -> Option<Self> {
        let [own] = self.objectives.as_slice() else {
            return None;
        };
        let parameters = &own.of.section.value;
        let is_named = unless.iter().any(|key| parameters.get(key).is_some());
        if own.of.kind.name != threshold::NAME || is_named {
            return None;
        }
        let mut other = self.clone();
        other.objectives[0].of.section.value[key] = number.into();
        Some(other)
    }
}

/// Builds every kind once on a few voxels, so that bad parameters are refused before heavy work.
pub(super) fn try_kinds(
    spec: &JobSpec,
    kinds: &JobKinds,
    model: Option<&Family>,
    gray: bool,
) -> Result<()> {
    let grid = VolumeGrid::centered([4, 4, 4], 0.1);
    let mut layout = DoseLayout::new("dose", grid.clone(), 0);
    if kinds.cells_key().is_some() {
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
    let response = Arc::clone(&kinds.response);
    let input = ObjectiveInput {
        layout: &layout,
        labels: &labels,
        target: &target,
        response: Arc::clone(&response),
    };
    let objective = kinds.objective(&input, false)?;
    solid_at(spec, response.as_ref())?;
    kinds.penalties(&[])?;
    let is = Are {
        linear: model.is_none_or(|model| model.capabilities().is_linear()),
        in_time: in_time::is_optimized(spec),
        convex: objective.is_convex(),
        tolerant: gray || tolerates_dose(&objective, &layout, &labels),
    };
    fit_together(spec, &kinds.requirements, is)?;
    kinds.start()?;
    // Of a gray target the values are not known yet
    if kinds.asks_for_doses() && !gray {
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
pub(super) fn counted_as(spec: &JobSpec, gray: bool) -> Result<()> {
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
