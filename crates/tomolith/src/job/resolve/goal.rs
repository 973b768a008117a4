//! What a job asks of the dose of a species: the material's response and the objectives, read once.

use crate::error::{Error, Result};
use crate::field::{BLOCK, Field, HostField};
use crate::grid::Volume;
use crate::job::resolve::at_section;
use crate::job::spec::JobSpec;
use crate::kind::Section;
use crate::objective::preset::SurfaceHandling;
use crate::objective::voxel_weights::{Common, Ground};
use crate::objective::{Chosen, MakeObjective, Objective, ObjectiveInput, Sum, objectives};
use crate::report::number::significant;
use crate::response::{RESPONSES, Response};
use std::path::{Path, PathBuf};
use std::sync::Arc;
use tomolith_core::parallel::InParallel;

/// The goal of the dose of a species: objectives and response, as typed parameters in their ranges.
#[derive(Clone)]
pub(crate) struct Goal {
    /// What the material makes of a dose.
    pub(crate) response: Arc<dyn Response>,
    on_host: Objectives<HostField>,
    sections: Arc<[Section]>,
    /// What the program chose of a single objective.
    chosen: Option<Chosen>,
}

/// The objectives of a species, for fields F.
#[derive(Clone)]
pub(crate) struct Objectives<F: Field> {
    all: Vec<JobObjective<F>>,
    /// Where files begin.
    base: PathBuf,
}

#[derive(Clone)]
pub(crate) struct JobObjective<F: Field = HostField> {
    /// Its key, without the kind's name.
    path: String,
    pub(crate) key: String,
    pub(crate) common: Common,
    pub(crate) response: Arc<dyn Response>,
    maker: Arc<dyn MakeObjective<F>>,
}

pub(crate) fn response(section: &Section) -> Result<Arc<dyn Response>> {
    section.read(RESPONSES).map(Arc::from)
}

impl<F: Field> JobObjective<F> {
    fn read(section: Section, job: &Arc<dyn Response>) -> Result<Self> {
        let path = section.path.clone();
        let (common, section) = Common::split(section)?;
        let response = match &common.response {
            Some(value) => response(&section.within("response", value.clone()))?,
            None => Arc::clone(job),
        };
        let (kind, section) = section.kind(objectives::<F>())?;
        Ok(JobObjective {
            maker: (kind.build)(&section)?,
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

    /// Whether it changes the patterns.
    fn counts(&self) -> bool {
        self.common.weight != 0.0
    }

    /// Whether voxels that the surface cuts have two doses.
    pub(crate) fn has_cells(&self) -> bool {
        self.maker.surface() == SurfaceHandling::Cells
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
        let mut objective = self.maker.make(&input).map_err(at_key)?;
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

impl<F: Field> Objectives<F> {
    fn read(sections: &[Section], base: &Path, response: &Arc<dyn Response>) -> Result<Self> {
        let objective = |section: &Section| JobObjective::read(section.clone(), response);
        Ok(Objectives {
            all: sections.iter().map(objective).collect::<Result<_>>()?,
            base: base.to_owned(),
        })
    }

    /// Their sum; `on_grid` whether fields of voxels fit the input's grid. Those of no weight are read, so that their errors come before any work, and
    /// left out.
    pub(crate) fn sum(&self, input: &ObjectiveInput<'_>, on_grid: bool) -> Result<Sum<F>> {
        let build = |objective: &JobObjective<F>| {
            let built = objective.build(input, &self.base, on_grid)?;
            Ok((objective.common.weight, built))
        };
        let mut all: Vec<_> = self.all.iter().map(build).collect::<Result<_>>()?;
        if all.iter().any(|(weight, _)| *weight != 0.0) {
            all.retain(|(weight, _)| *weight != 0.0);
        }
        Sum::new(all)
    }

    /// Takes a parameter of the only objective that the program chooses; false where there are several, another one, or the job names it.
    fn choose(&mut self, chosen: Chosen) -> bool {
        let mut counted = self.all.iter_mut().filter(|objective| objective.counts());
        let (Some(objective), None) = (counted.next(), counted.next()) else {
            return false;
        };
        let other = objective.maker.with(chosen);
        if let Some(maker) = &other {
            objective.maker = Arc::clone(maker);
        }
        other.is_some()
    }
}

impl Goal {
    /// Reads what the job of a species asks; `base` is where its files begin.
    pub(crate) fn read(spec: &JobSpec, base: &Path) -> Result<Self> {
        let response = response(&Section::new("response", spec.response.clone()).based(base))?;
        let sections = spec.objectives()?.into_iter();
        let sections: Arc<[Section]> = sections.map(|section| section.based(base)).collect();
        Ok(Goal {
            on_host: Objectives::read(&sections, base, &response)?,
            response,
            sections,
            chosen: None,
        })
    }

    /// The objectives for fields of the host.
    pub(crate) fn on_host(&self) -> &Objectives<HostField> {
        &self.on_host
    }

    /// The objectives for fields of another kind.
    #[cfg_attr(
        not(feature = "gpu"),
        expect(dead_code, reason = "all fields are the host's")
    )]
    pub(crate) fn on<F: Field>(&self) -> Result<Objectives<F>> {
        let mut objectives = Objectives::read(&self.sections, &self.on_host.base, &self.response)?;
        if let Some(chosen) = self.chosen {
            objectives.choose(chosen);
        }
        Ok(objectives)
    }

    /// Whether the job names them in a list.
    pub(crate) fn is_list(&self) -> bool {
        let first = self.sections.first();
        first.is_some_and(|first| first.path.starts_with("objectives["))
    }

    pub(crate) fn objectives(&self) -> &[JobObjective] {
        &self.on_host.all
    }

    /// Those that change the patterns.
    fn counted(&self) -> impl Iterator<Item = &JobObjective> {
        self.objectives()
            .iter()
            .filter(|objective| objective.counts())
    }

    /// Takes another response in place of the job's.
    pub(crate) fn set_response(&mut self, response: &Arc<dyn Response>) {
        for objective in &mut self.on_host.all {
            if objective.common.response.is_none() {
                objective.response = Arc::clone(response);
            }
        }
        self.response = Arc::clone(response);
    }

    /// What the response of the material to a dose is called.
    pub(crate) fn quantity(&self) -> &'static str {
        match self.response.is_identity() {
            true => "dose",
            false => "response",
        }
    }

    /// What the material makes of a dose.
    pub(crate) fn responses(&self, mut dose: Volume<f32>) -> Volume<f32> {
        let response = self.response.as_ref();
        if !response.is_identity() {
            dose.values.chunks_mut(BLOCK).par_each(|block| {
                block
                    .iter_mut()
                    .for_each(|value| *value = response.value(*value))
            });
        }
        dose
    }

    /// What every objective may have, and its key.
    pub(crate) fn common(&self) -> impl Iterator<Item = (&str, &Common)> {
        (self.objectives().iter()).map(|objective| (objective.path.as_str(), &objective.common))
    }

    /// Whether an objective has weights or bands per voxel.
    pub(crate) fn has_fields(&self) -> bool {
        let mut counted = self.counted();
        counted.any(|objective| objective.common.has_fields())
    }

    /// The key that asks for surface-aware cells, when there is one.
    pub(crate) fn cells_key(&self) -> Option<String> {
        let objective = self
            .objectives()
            .iter()
            .find(|objective| objective.has_cells())?;
        Some(format!("{}.surface", objective.key))
    }

    /// Whether all objectives weigh a voxel by its inside fraction, and none has a number for each of the job's voxels.
    pub(crate) fn sees_fractions(&self) -> bool {
        !self.has_fields() && self.weighs_fractions()
    }

    /// Whether all objectives weigh a voxel by its inside fraction.
    pub(crate) fn weighs_fractions(&self) -> bool {
        let weighs =
            |objective: &JobObjective| objective.maker.surface() == SurfaceHandling::Fraction;
        self.counted().all(weighs)
    }

    /// Whether an objective looks for the process window itself.
    pub(crate) fn seeks_window(&self) -> bool {
        self.objectives()
            .iter()
            .any(|objective| objective.maker.seeks_window())
    }

    /// Thresholds [void, part] of the first objective, where it has any.
    pub(crate) fn thresholds(&self) -> Option<[f64; 2]> {
        self.objectives().first()?.maker.thresholds()
    }

    /// Half width ε of the band round the target's values, of the first objective that has one.
    pub(crate) fn epsilon(&self) -> Option<f64> {
        self.objectives()
            .iter()
            .find_map(|objective| objective.maker.epsilon())
    }

    /// The goal with a parameter that the program chooses. None where the job has several objectives, another one, or names the parameter.
    pub(crate) fn with(&self, chosen: Chosen) -> Option<Self> {
        let mut other = self.clone();
        other.chosen = Some(chosen);
        other.on_host.choose(chosen).then_some(other)
    }
}
