//! The kinds that a job names: read once, tried on a few voxels before any work, and refused where they do not go together.

use super::free_parameters;
use super::free_parameters::FreeParameters;
use crate::error::{Error, Result};
use crate::field::{Field, HostField};
use crate::grid::{Volume, VolumeGrid};
use crate::job::resolve::at_section;
use crate::job::spec::JobSpec;
use crate::job::spec::all_errors::penalty_weight;
use crate::kind::{Kind, Section};
use crate::models::cells::Cells;
use crate::models::{DoseLayout, Family, PatternLayout};
use crate::objective::penalty::{MakePenalty, Penalties, penalties};
use crate::objective::preset::SurfaceHandling;
use crate::objective::voxel_weights::{Common, Ground};
use crate::objective::{Chosen, MakeObjective, Objective, ObjectiveInput, Sum, objectives};
use crate::optimize::start::{InitialPatterns, STARTS};
use crate::optimize::{BuildOptimizer, MakeOptimizer, Optimizer, Requirements, optimizers};
use crate::report::number::significant;
use crate::response::{RESPONSES, Response, dose_for};
use crate::target::{Target, label, label_voxels};
use crate::units::exact;
use serde_json::Value;
use std::path::{Path, PathBuf};
use std::sync::Arc;

/// The kinds that a job names, read once: parameters that are typed and in their ranges, and what the rest of the job asks of them.
#[derive(Clone)]
pub(crate) struct JobKinds {
    /// What the material makes of a dose.
    pub(crate) response: Arc<dyn Response>,
    /// Which of its parameters are unknowns.
    pub(crate) free: Option<FreeParameters>,
    /// What is minimized, and how, for fields of the host.
    on_host: Minimized<HostField>,
    sections: Arc<Sections>,
    /// What the program chose of a single objective.
    chosen: Option<Chosen>,
    /// How many steps the optimizer remembers, where that is not what the job says.
    memory: Option<usize>,
    /// Where the optimizer begins.
    pub(crate) start: Arc<dyn InitialPatterns>,
    /// What the optimizer needs beside it.
    pub(crate) requirements: Requirements,
    /// Whether it divides doses by their largest.
    pub(crate) normalizes: bool,
}

/// The sections of a job that say what is minimized, and how.
struct Sections {
    objectives: Vec<Section>,
    penalties: Vec<Value>,
    optimizer: Section,
    /// Where files begin.
    base: PathBuf,
}

/// What a job minimizes, and how, for fields F.
#[derive(Clone)]
pub(crate) struct Minimized<F: Field> {
    objectives: Vec<JobObjective<F>>,
    /// Each with its weight.
    penalties: Vec<(f64, Arc<dyn MakePenalty<F>>)>,
    optimizer: Arc<dyn MakeOptimizer<F>>,
    base: PathBuf,
}

/// One objective of a job.
#[derive(Clone)]
pub(crate) struct JobObjective<F: Field = HostField> {
    /// Its key, without the kind's name.
    path: String,
    /// Its key.
    pub(crate) key: String,
    pub(crate) common: Common,
    pub(crate) response: Arc<dyn Response>,
    of: Arc<dyn MakeObjective<F>>,
}

pub(crate) fn response(section: &Section) -> Result<Arc<dyn Response>> {
    section.read(RESPONSES).map(Arc::from)
}

impl<F: Field> JobObjective<F> {
    fn read(section: Section, job: &Arc<dyn Response>) -> Result<Self> {
        let path = section.path.clone();
        let (common, section) = Common::split(section)?;
        let response = match &common.response {
            Some(own) => response(&section.within("response", own.clone()))?,
            None => Arc::clone(job),
        };
        let (kind, section) = section.kind(objectives::<F>())?;
        Ok(JobObjective {
            of: (kind.build)(&section)?,
            key: section.path,
            path,
            common,
            response,
        })
    }

    /// What people should know of regions that change nothing.
    pub(crate) fn warnings(&self, ground: &Ground<'_>) -> Result<Vec<String>> {
        let grid = &ground.layout.grid;
        let [nz, ny, nx] = grid.shape;
        let empty = self.common.empty_regions(ground)?;
        let say = |key: String| {
            let so = if key == "region" {
                "no voxel has this objective"
            } else {
                "it changes nothing"
            };
            format!(
                "{}.{key} holds no voxel that counts, so {so}; voxels of this grid lie from z = {} to {} mm, up to {} mm from the axis: \
                 change its radius_mm or z_mm, or leave it out",
                self.path,
                significant(grid.z(0), 3),
                significant(grid.z(nz - 1), 3),
                significant(grid.x(nx - 1).hypot(grid.y(ny - 1)), 3),
            )
        };
        Ok(empty.into_iter().map(say).collect())
    }

    /// Whether voxels that the surface cuts have two doses.
    pub(crate) fn has_cells(&self) -> bool {
        self.of.surface() == SurfaceHandling::Cells
    }

    /// The objective of a dose; `on_grid` whether fields of voxels fit the input's grid.
    pub(crate) fn build(
        &self,
        input: &ObjectiveInput<'_>,
        base: &Path,
        on_grid: bool,
    ) -> Result<Box<dyn Objective<F>>> {
        let mut input = input.clone();
        input.response = Arc::clone(&self.response);
        let at_key = |error: Error| at_section(&self.key, error.under(&self.key));
        let mut objective = self.of.make(&input).map_err(at_key)?;
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
                .map_err(|e| e.under(&self.key))?;
        }
        Ok(objective)
    }
}

/// A penalty and its weight.
fn penalty<F: Field>((i, value): (usize, &Value)) -> Result<(f64, Arc<dyn MakePenalty<F>>)> {
    let mut section = Section::new(format!("penalties[{i}]"), value.clone());
    let own = section.value.as_object_mut();
    let weight = own.and_then(|map| map.remove("weight"));
    let weight = penalty_weight(i, weight.as_ref())?;
    Ok((weight, section.read(penalties::<F>())?))
}

impl<F: Field> Minimized<F> {
    fn read(sections: &Sections, response: &Arc<dyn Response>) -> Result<Self> {
        let objective = |own: &Section| JobObjective::read(own.clone(), response);
        let penalties = sections.penalties.iter().enumerate().map(penalty);
        Ok(Minimized {
            objectives: sections
                .objectives
                .iter()
                .map(objective)
                .collect::<Result<_>>()?,
            penalties: penalties.collect::<Result<_>>()?,
            optimizer: sections.optimizer.read(optimizers::<F>())?,
            base: sections.base.clone(),
        })
    }

    /// A new optimizer.
    pub(crate) fn optimizer(&self) -> Result<Box<dyn Optimizer<F>>> {
        self.optimizer.make()
    }

    /// The sum of the objectives; `on_grid` whether fields of voxels fit the input's grid.
    pub(crate) fn objective(&self, input: &ObjectiveInput<'_>, on_grid: bool) -> Result<Sum<F>> {
        let build = |own: &JobObjective<F>| {
            let objective = own.build(input, &self.base, on_grid)?;
            Ok((own.common.weight, objective))
        };
        Sum::new(self.objectives.iter().map(build).collect::<Result<_>>()?)
    }

    /// The sum of the penalties.
    pub(crate) fn penalties(&self, lights: &[PatternLayout]) -> Result<Penalties<F>> {
        let build =
            |(weight, own): &(f64, Arc<dyn MakePenalty<F>>)| Ok((*weight, own.make(lights)?));
        Penalties::new(self.penalties.iter().map(build).collect::<Result<_>>()?)
    }

    /// Takes a parameter of the only objective that the program chooses; false where there are several, another one, or the job names it.
    fn choose(&mut self, chosen: Chosen) -> bool {
        let [own] = self.objectives.as_mut_slice() else {
            return false;
        };
        let other = own.of.with(chosen);
        if let Some(of) = &other {
            own.of = Arc::clone(of);
        }
        other.is_some()
    }

    /// Lets the optimizer remember so many steps, where it remembers any.
    fn set_memory(&mut self, pairs: usize) {
        if let Some(optimizer) = self.optimizer.with_pairs(pairs) {
            self.optimizer = optimizer;
        }
    }

    /// Takes another response in place of the job's.
    fn set_response(&mut self, response: &Arc<dyn Response>) {
        for own in &mut self.objectives {
            if own.common.response.is_none() {
                own.response = Arc::clone(response);
            }
        }
    }
}

impl JobKinds {
    /// Reads the kinds of a job; `base` is where its files begin.
    ///
    /// # Errors
    /// [`Error::Config`] with the key of what is no kind, or of a parameter.
    pub(crate) fn read(spec: &JobSpec, base: &Path) -> Result<Self> {
        let section = |key: &str, value: &Value| Section::new(key, value.clone()).based(base);
        let response = response(&section("response", &spec.response))?;
        let objectives = spec.objectives()?.into_iter();
        let sections = Sections {
            objectives: objectives.map(|own| own.based(base)).collect(),
            penalties: spec.penalties.clone(),
            optimizer: section("optimizer", &spec.optimizer),
            base: base.to_owned(),
        };
        let on_host: Minimized<HostField> = Minimized::read(&sections, &response)?;
        let method = on_host.optimizer()?;
        Ok(JobKinds {
            start: Arc::from(section("start", &spec.start).read(STARTS)?),
            requirements: method.requirements(),
            normalizes: method.normalizes(),
            free: FreeParameters::of(spec, base)?,
            response,
            on_host,
            sections: Arc::new(sections),
            chosen: None,
            memory: None,
        })
    }

    /// What is minimized, and how, for fields of the host.
    pub(crate) fn on_host(&self) -> &Minimized<HostField> {
        &self.on_host
    }

    /// The same for fields of another kind.
    ///
    /// # Errors
    /// As [`read`](Self::read).
    #[cfg_attr(
        not(feature = "gpu"),
        expect(dead_code, reason = "all fields are the host's")
    )]
    pub(crate) fn on<F: Field>(&self) -> Result<Minimized<F>> {
        let mut own = Minimized::read(&self.sections, &self.response)?;
        if let Some(chosen) = self.chosen {
            own.choose(chosen);
        }
        if let Some(pairs) = self.memory {
            own.set_memory(pairs);
        }
        Ok(own)
    }

    /// The objectives.
    pub(crate) fn objectives(&self) -> &[JobObjective] {
        &self.on_host.objectives
    }

    /// The optimizer's name in a job.
    pub(crate) fn method(&self) -> &'static str {
        self.requirements.name
    }

    /// How many steps the optimizer remembers, where it remembers any.
    pub(crate) fn pairs(&self) -> Option<usize> {
        self.on_host.optimizer.pairs()
    }

    /// Lets the optimizer remember so many steps, where it remembers any.
    pub(crate) fn set_pairs(&mut self, pairs: usize) {
        self.on_host.set_memory(pairs);
        self.memory = Some(pairs);
    }

    /// Takes another response in place of the job's.
    pub(crate) fn set_response(&mut self, response: &Arc<dyn Response>) {
        self.on_host.set_response(response);
        self.response = Arc::clone(response);
    }

    /// Whether a penalty compares pixels of different frames.
    pub(crate) fn penalizes_frames(&self) -> bool {
        self.on_host
            .penalties
            .iter()
            .any(|(_, own)| own.joins_frames())
    }

    /// What every objective may have, and its key.
    pub(crate) fn common(&self) -> impl Iterator<Item = (&str, &Common)> {
        (self.objectives().iter()).map(|own| (own.path.as_str(), &own.common))
    }

    /// The key that asks for surface-aware cells, when there is one.
    pub(crate) fn cells_key(&self) -> Option<String> {
        let own = self.objectives().iter().find(|own| own.has_cells())?;
        Some(format!("{}.surface", own.key))
    }

    /// Whether all objectives weigh a voxel by its inside fraction, none has numbers of its own for the job's voxels, and the method minimizes
    /// them: one that compares doses with the target itself knows part and void alone.
    pub(crate) fn sees_fractions(&self) -> bool {
        let sees = |own: &JobObjective| {
            own.of.surface() == SurfaceHandling::Fraction && !own.common.has_fields()
        };
        self.requirements.target.is_none() && self.objectives().iter().all(sees)
    }

    /// Whether an objective looks for the process window itself.
    pub(crate) fn seeks_window(&self) -> bool {
        self.objectives().iter().any(|own| own.of.seeks_window())
    }

    /// Thresholds [void, part] of the first objective, where it has any.
    pub(crate) fn thresholds(&self) -> Option<[f64; 2]> {
        self.objectives().first()?.of.thresholds()
    }

    /// Half width ε of the band round the target's values, of the first objective that has one.
    pub(crate) fn epsilon(&self) -> Option<f64> {
        self.objectives().iter().find_map(|own| own.of.epsilon())
    }

    /// The same with a parameter that the program chooses. None where the job has several objectives, another one, or names the parameter.
    pub(crate) fn with(&self, chosen: Chosen) -> Option<Self> {
        let mut other = self.clone();
        other.chosen = Some(chosen);
        other.on_host.choose(chosen).then_some(other)
    }
}

/// Makes the objective on a few voxels, so that what the job cannot have is refused before heavy work.
pub(crate) fn try_kinds(
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
    let objective = kinds.on_host().objective(&input, false)?;
    solid_at(spec, response.as_ref())?;
    kinds.on_host().penalties(&[])?;
    let is = Are {
        linear: model.is_none_or(|model| model.capabilities().is_linear()),
        in_time: spec.optimizes_cure(),
        convex: objective.is_convex(),
        tolerant: gray || tolerates_dose(&objective, &layout, &labels),
    };
    fit_together(spec, &kinds.requirements, is)?;
    free_parameters::must_be_minimized(kinds)?;
    // Of a gray target the values are not known yet
    if kinds.start.asks_for_doses() && !gray {
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
