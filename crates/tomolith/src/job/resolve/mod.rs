//! A job as objects: model, objective, start and evaluation, for the layers below and for programs with another loop.
//!
//! A [`Job`] says what is wanted; a [`ResolvedJob`] has read its files, built its shape, vial, lights and grid, and refused what does not fit
//! together. Its [`Task`](crate::job::Task) is what an optimizer needs, on the finest voxels of the optimization; what patterns print is
//! [`evaluate`](ResolvedJob::evaluate)d as `tomolith run` does it: written with the job's bits, the vial turning, on finer voxels, and in time where the
//! job has a schedule.
//!
//! ```
//! use std::path::Path;
//! use tomolith::field::Field;
//! use tomolith::job::{Document, Job, ResolvedJob};
//! use tomolith::models::Work;
//! use tomolith::objective::Objective;
//!
//! let text = r#"
//!     target = { phantom = "gear", size_mm = 3.0 }      # or mesh = "part.stl"
//!     grid = { pitch_mm = 0.15 }
//!     resin = { refractive_index = 1.5, absorption_per_mm = 0.1 }
//!     vial = { index_matched = { radius_mm = 3.0 } }
//!     light = [{ pixels = [32, 24], angles = 40, projector = { collimated = { pixel_pitch_mm = 0.15 } } }]
//! "#;
//! let job = Job::from_document(Document::toml(Path::new("gear.toml"), text)?)?;
//! let (job, work) = (ResolvedJob::new(&job)?, Work::new());
//! let task = job.task(&work)?;
//! let begin = job.evaluate(&task.patterns(&task.start), &work)?;
//!
//! // A projected gradient with a fixed step, in place of the job's method
//! let (mut x, mut dose) = (task.start.clone(), task.model.new_dose()?);
//! let (mut cotangent, mut gradient) = (dose.zeros_like(), x.zeros_like());
//! let bounds = task.bounds()?;
//! let mut losses = Vec::new();
//! for _ in 0..15 {
//!     task.model.dose(&x, &mut dose, &work)?;
//!     losses.push(task.objective.value_and_gradient(&dose, &mut cotangent));
//!     task.model.pullback(&x, &cotangent, &mut gradient, &work)?;
//!     let step = 0.1 * x.max_abs() / gradient.max_abs();
//!     x.move_along(&gradient, -step, &bounds);
//! }
//! assert!(losses[14] < 0.5 * losses[0]); // the loss falls to less than half
//!
//! let end = job.evaluate(&task.patterns(&x), &work)?;
//! let iou = |print: &tomolith::job::Prediction| print.evaluation.measures.get("iou").unwrap();
//! assert!(iou(&end) > iou(&begin) && iou(&end) > 0.9); // and the print is better than that of the start
//! # Ok::<(), tomolith::Error>(())
//! ```

pub(crate) mod acting;
pub(crate) mod budget;
pub(crate) mod card;
pub(crate) mod cells;
pub(crate) mod clip;
pub(crate) mod compatibility;
pub(crate) mod extent;
pub(crate) mod free_parameters;
pub(crate) mod goal;
pub(crate) mod grid;
pub(crate) mod identity;
pub(crate) mod light;
pub(crate) mod lights_in_time;
pub(crate) mod machine;
pub(crate) mod material;
pub(crate) mod method;
pub(crate) mod multiresolution;
pub(crate) mod optics;
pub(crate) mod point_spread;
pub(crate) mod property;
pub(crate) mod reach;
pub(crate) mod refinement;
pub(crate) mod remarks;
pub mod resources;
pub(crate) mod row_ends;
pub(crate) mod scenarios;
pub(crate) mod schedule;
pub(crate) mod scheduled;
pub(crate) mod selection;
mod settings;
pub(crate) mod species;
pub(crate) mod time_refusals;
pub(crate) mod voxels;

use crate::error::{Error, Result};
use crate::exposure::Printer;
use crate::field::{Field, HostField};
use crate::grid::VolumeGrid;
use crate::job::spec::JobSpec;
use crate::job::spec::all_errors::with_others;
use crate::job::spec::kinds::known_elsewhere;
use crate::job::spec::read::Job;
use crate::job::spec::species::{Row, at_species};
use crate::models::parallel::kernel::Isa;
use crate::models::{DoseLayout, Family, ModelKind, OpticalScene, Purpose, Work, planner};
use crate::objective::{ObjectiveInput, Sum};
use crate::optics::light::Light;
use crate::optics::vial::Vial;
use crate::optimize::Optimizer;
use crate::ranks::Communicator;
use crate::response::dose_for;
use crate::target::Shape;
use extent::Extent;
use free_parameters::FoundResponse;
use goal::Objectives;
use grid::{bounds_of, grid_of, moved};
use method::Method;
use optics::Optics;
use property::PropertyMap;
use refinement::{Asked, Level};
use remarks::{
    below_gel, chosen, far_threshold, few_angles, given_patterns, large_critical_dose,
    lost_reflections, narrow_arc, on_its_own_grid, part_of_a_turn, two_critical_doses,
};
use resources::{available_disk_mb, bytes_in, require};
use scenarios::Scenario;
use species::named;
use std::path::{Path, PathBuf};
use std::sync::{Arc, OnceLock};

pub(crate) use remarks::at_section;

pub(crate) use species::Species;
pub(crate) use voxels::Voxels;

/// A job that can be run.
pub struct ResolvedJob {
    /// The tables, whose kinds are in the objects below; the machine's time may bound the pixels.
    spec: JobSpec,
    /// The folder that files of the tables begin in.
    pub(crate) base: PathBuf,
    /// Rows of models beyond [`MODELS`](crate::models::MODELS).
    models: &'static [ModelKind],
    /// Name of the part.
    pub(crate) name: String,
    /// At how many angles the evaluation averages a frame, light by light.
    pub(crate) evaluated_angles: Vec<usize>,
    /// Whether the program chooses voxels of the optimization that are finer than pixels, as far as time allows.
    pub(crate) sees_within_pixels: bool,
    /// Whether ends of the run that ask the job's own voxels keep the program from choosing others.
    pub(crate) stop_chooses_voxels: bool,
    /// What hardens in the resin: one species at least.
    pub(crate) species: Vec<Species>,
    /// How patterns are searched.
    pub(crate) method: Method,
    /// Vial and lights.
    pub(crate) optics: Optics,
    /// The machine, one per light.
    pub(crate) printers: Option<Vec<Printer>>,
    /// The job's voxels.
    pub(crate) grid: VolumeGrid,
    /// Voxels of the optimization, from coarse to fine.
    pub(crate) levels: Vec<Level>,
    /// How large it all is.
    pub(crate) extent: Extent,
    /// M, a row per species; None: one species that all lights drive alike.
    pub(crate) mixing: Option<Vec<Row>>,
    /// What the responses become.
    pub(crate) properties: Vec<PropertyMap>,
    /// The same job with some keys set otherwise, on the same voxels.
    pub(crate) scenarios: Vec<Scenario>,
    /// Choices that were made.
    pub(crate) notes: Vec<String>,
    /// What may be wrong.
    pub(crate) warnings: Vec<String>,
    /// Whether it is the coarse version of a job.
    pub(crate) is_toy: bool,
    /// The processes that share the frames of the optimization; None: this one works alone.
    pub(crate) ranks: Option<Arc<dyn Communicator>>,
    /// The targets of all species on the job's voxels, sampled on first use by a caller with another loop.
    voxels: OnceLock<Vec<Voxels>>,
}

impl ResolvedJob {
    /// Reads the files of a job, builds its objects, and refuses whatever can be refused before heavy work.
    ///
    /// # Errors
    /// [`Error::Config`] with the key for whatever does not fit together, and those of files.
    pub fn new(job: &Job) -> Result<Self> {
        Self::under(job, &Work::new())
    }

    /// [`new`](Self::new) as a part of a run.
    pub(crate) fn under(job: &Job, work: &Work) -> Result<Self> {
        Isa::asked()?;
        Self::resolve(job, work)
            .map_err(|e| with_others(&job.document, job.models, &job.base(), job.locate(e)))
    }

    /// The job's voxels; those of the optimization and the evaluation are finer.
    #[must_use]
    pub fn grid(&self) -> &VolumeGrid {
        &self.grid
    }

    /// What is printed, of the first species.
    #[must_use]
    pub fn shape(&self) -> &dyn Shape {
        self.first().shape.as_ref()
    }

    /// What holds the resin.
    #[must_use]
    pub fn vial(&self) -> &dyn Vial {
        self.optics.vial.as_ref()
    }

    /// The projectors' pixels, and the resin as their light sees it.
    #[must_use]
    pub fn lights(&self) -> &[Light] {
        &self.optics.lights
    }

    /// What people should know, one sentence each.
    #[must_use]
    pub fn warnings(&self) -> &[String] {
        &self.warnings
    }

    /// The method of the job.
    ///
    /// # Errors
    /// [`Error::Config`].
    pub fn optimizer(&self) -> Result<Box<dyn Optimizer<HostField>>> {
        self.method.optimizer()
    }

    /// The targets of all species on the job's voxels, sampled once.
    pub(crate) fn own_voxels(&self, work: &Work) -> Result<&[Voxels]> {
        if let Some(known) = self.voxels.get() {
            return Ok(known);
        }
        let voxels = self.voxels(&self.grid, &work.aside())?;
        self.must_start(&voxels)?;
        Ok(self.voxels.get_or_init(|| voxels))
    }

    /// Refuses a part of which no voxel is half filled, or of which too much is where nothing prints.
    ///
    /// # Errors
    /// [`Error::Config`] with the key; [`Error::Canceled`].
    pub fn must_print(&self, work: &Work) -> Result<()> {
        let voxels = self.own_voxels(work)?;
        self.warnings_of(voxels).map(drop)
    }

    fn resolve(job: &Job, work: &Work) -> Result<Self> {
        let (spec, base) = (&job.spec, job.base());
        time_refusals::must_fit(spec)?;
        let mut optics = Optics::with_models(spec, &base, job.models)?;
        let printers = machine::printers(spec, &base, &optics.lights)?;
        let mut notes = optics.leave_dark(printers.as_deref().unwrap_or_default());
        let method = Method::read(spec, &base).map_err(known_elsewhere)?;
        notes.extend(given_patterns(&method, &optics)?);
        let mut species = Species::of_job(job, &method, optics.model.as_ref(), work)?;
        let properties = property::of_job(spec, &base)?;
        let bounds_mm = bounds_of(&species);
        let placed = grid_of(spec, &optics, bounds_mm);
        let on = placed.as_ref().ok().map(|(grid, _)| grid);
        let units = species::must_be_held(&mut species, spec, &optics, on)?;
        if spec.target.insert_shadow.unwrap_or(true) {
            optics.add_inserts(species[0].shape.as_ref())?;
        }
        let (grid, moved_mm) = placed?;
        notes.extend(moved(moved_mm));
        notes.extend(chosen(spec, &method));
        notes.extend(card::none_for(
            spec.resources.device.as_deref(),
            optics.card.as_ref(),
        ));
        let cut_off = species::must_be_on(&species, spec, &optics, &grid, work)?;
        time_refusals::must_be_stable(spec, &grid)?;
        let light = must_be_lit(spec, &optics, &species, &grid)?;
        for (s, species) in species.iter().enumerate() {
            for (path, common) in species.goal.common() {
                let checked = common.check_files(&grid, &base).map_err(|e| e.under(path));
                checked.map_err(|e| at_species(spec, s, e))?;
            }
        }
        let family = family(&optics, &species, &grid)?;
        let asked = Asked {
            spec,
            method: &method,
            species: &species,
        };
        let levels = refinement::levels(asked, &optics, family.as_ref(), &grid, bounds_mm);
        let refines = family.capabilities().refines;
        let sees_within_pixels = refinement::is_free(asked, refines);
        let stop_chooses_voxels = refinement::depends_on_stop(asked, refines);
        notes.extend(refinement::held_back(asked, family.as_ref()));
        let finest = &levels[levels.len() - 1];
        if refinement::are_sharpened(asked, family.as_ref(), finest) {
            for species in &mut species {
                species.goal =
                    refinement::sharpened(&species.goal).unwrap_or_else(|| species.goal.clone());
            }
        }
        let chosen = || refinement::evaluation_refine(&grid, &levels);
        let refine = spec.evaluate.refine.unwrap_or_else(chosen);
        let memory = method.pairs().unwrap_or(0);
        let extent = Extent::new(&optics, &grid, bounds_mm, refine, memory);
        let of_shapes = species
            .iter()
            .map(|species| species.shape.warnings())
            .collect();
        let evaluated_angles = refinement::evaluated_angles(spec, &optics.lights, bounds_mm);
        let mut resolved = ResolvedJob {
            evaluated_angles,
            sees_within_pixels,
            stop_chooses_voxels,
            name: spec.target.name(),
            warnings: [
                named(&species, of_shapes),
                cut_off,
                on_its_own_grid(spec).into_iter().collect(),
                far_threshold(spec, &species[0].goal).into_iter().collect(),
                below_gel(spec, &species[0].goal).into_iter().collect(),
                large_critical_dose(spec).into_iter().collect(),
                two_critical_doses(spec).into_iter().collect(),
                scenarios::worst_of_one(spec).into_iter().collect(),
                (refinement::unheard(spec, &levels, &grid).into_iter()).collect(),
                light,
                units,
            ]
            .concat(),
            notes,
            is_toy: job.is_toy,
            ranks: None,
            voxels: OnceLock::new(),
            levels,
            mixing: spec.mixing()?,
            properties,
            species,
            method,
            scenarios: Vec::new(),
            spec: spec.clone(),
            models: job.models,
            base,
            optics,
            printers,
            grid,
            extent,
        };
        resolved.extent = budget::extent(&resolved, &family)?;
        resolved.finish(&job.folder())?;
        species::must_fit(&resolved)?;
        lights_in_time::must_be_shaded(&resolved)?;
        resolved.scenarios = scenarios::of_job(&resolved)?;
        Ok(resolved)
    }

    /// What follows from all of it: more remarks, and what it needs in time, memory and disk.
    fn finish(&mut self, folder: &Path) -> Result<()> {
        let notes = self.printers.iter().flatten().flat_map(Printer::notes);
        self.warnings.extend(notes.cloned());
        self.warnings.extend(multiresolution::left_out(self));
        self.warnings.extend(self.uneven_turns()?);
        self.bound_by_time()?;
        self.fit_memory()?;
        // A checkpoint that is there gives its place to the next one
        let held = bytes_in(&folder.join("checkpoint")) / 1_000_000;
        let disk = available_disk_mb(folder).map(|free| free + held);
        require(
            "output.folder",
            "disk for the run folder",
            self.extent.disk_mb(),
            disk,
            "a folder on a larger disk, or a smaller job",
        )
    }

    /// Notes on which voxels the patterns will be optimized.
    pub(crate) fn note_levels(&mut self) {
        self.notes
            .extend(refinement::note(&self.levels, &self.grid));
    }

    /// Bounds the pixels by what the machine can give in the time that it has.
    fn bound_by_time(&mut self) -> Result<()> {
        let Some((white, seconds)) = machine::white_in_time(&self.spec, &self.first().goal)? else {
            return Ok(());
        };
        let max = self.spec.bounds.max.map_or(white, |max| max.min(white));
        if max <= self.spec.bounds.min {
            return Err(Error::config(
                "printer.time_s",
                format!(
                    "in {seconds} s a pixel gives {white:.4}, no more than bounds.min = {}",
                    self.spec.bounds.min
                ),
                "more time or more light",
            ));
        }
        self.spec.bounds.max = Some(max);
        self.notes.push(format!(
            "in {seconds} s the brightest pixel gives {white:.4}: bounds.max is {max:.4}"
        ));
        Ok(())
    }

    /// The finer grid of the evaluation.
    pub(crate) fn fine_grid(&self) -> VolumeGrid {
        self.grid.refined(self.extent.refine)
    }

    /// At how many angles of a frame patterns are evaluated at most: one where all vials stand still.
    pub(crate) fn most_evaluated_angles(&self) -> usize {
        self.evaluated_angles.iter().copied().max().unwrap_or(1)
    }

    /// Whether the optimization counts that the vial turns during each frame.
    pub(crate) fn optimizes_turning(&self) -> bool {
        let turns = |light: &&Light| light.pixels.frame_arc > 0.0;
        self.levels.last().is_some_and(|level| {
            let mut turning = level.lights.iter().filter(turns).peekable();
            turning.peek().is_some() && turning.all(|light| light.sub_angles > 1)
        })
    }

    /// Whether only one of evaluation and optimization counts that the vial turns.
    pub(crate) fn misses_turning(&self) -> bool {
        (self.most_evaluated_angles() > 1) != self.optimizes_turning()
    }

    /// What light passes in the optimization, and the surface where an objective has cells.
    pub(crate) fn optimizing(&self) -> OpticalScene<'_> {
        optimizing(&self.optics, &self.species)
    }

    /// Refuses a start that asks for doses which the material does not have, once the values of gray targets are known.
    pub(crate) fn must_start(&self, voxels: &[Voxels]) -> Result<()> {
        if !self.method.start.asks_for_doses() {
            return Ok(());
        }
        for (s, (species, voxels)) in self.species.iter().zip(voxels).enumerate() {
            let Some(highest) = voxels.highest_gray() else {
                continue;
            };
            let dose = dose_for(species.goal.response.as_ref(), highest);
            dose.map_err(|e| at_species(&self.spec, s, e.under("response")))?;
        }
        Ok(())
    }

    /// Takes the response that was found with the patterns, where one was.
    pub(crate) fn respond_as(&mut self, found: Option<&FoundResponse>) {
        if let Some(FoundResponse { response, .. }) = found {
            let goals = self.species.iter_mut().map(|species| &mut species.goal);
            goals.for_each(|goal| goal.set_response(response));
        }
    }

    /// The sum of the objectives of a species, or of variants that differ from them in a parameter or the kind of fields.
    pub(crate) fn objective<F: Field>(
        &self,
        species: &Species,
        objectives: &Objectives<F>,
        layout: &DoseLayout,
        voxels: &Voxels,
    ) -> Result<Sum<F>> {
        let Voxels { target, labels, .. } = voxels;
        let input = ObjectiveInput {
            layout,
            labels,
            target,
            response: Arc::clone(&species.goal.response),
        };
        let sum = objectives.sum(&input, true);
        sum.map(|sum| sum.scaled(layout.grid.voxel_mm3() / self.grid.voxel_mm3()))
    }
}

/// What light passes in an optimization for the parts of species.
fn optimizing<'a>(optics: &'a Optics, species: &'a [Species]) -> OpticalScene<'a> {
    let cells = species.iter().find(|species| species.has_cells);
    OpticalScene {
        solid: cells.map(|species| &species.shape),
        purpose: Purpose::Optimize,
        ..optics.scene()
    }
}

/// The family of models of an optimization.
fn family(optics: &Optics, species: &[Species], grid: &VolumeGrid) -> Result<Family> {
    planner::choose(optics.model.as_ref(), &optimizing(optics, species), grid)
}

/// Refuses light that does not reach the resin, or that no model gives on a grid; says what may be wrong with it.
fn must_be_lit(
    spec: &JobSpec,
    optics: &Optics,
    species: &[Species],
    grid: &VolumeGrid,
) -> Result<Vec<String>> {
    let each = species.iter().map(|species| {
        let printed = species.printed();
        let held = optics.must_hold(spec, printed, species.wall_tolerance_mm);
        let moved = optics.moved_away(printed).into_iter();
        Ok(moved.chain(optics.coarse(printed)).chain(held?).collect())
    });
    let of_parts = named(species, each.collect::<Result<Vec<Vec<String>>>>()?);
    // A missing file is reported before numbers that do not suit it
    let covered = optics.family(grid)?.check(&optics.scene(), grid)?;
    optics.must_be_evaluated(spec)?;
    let light = light::must_arrive(optics, grid)?;
    let absorbs = spec.resin.absorption_per_mm.is_some_and(|a| a > 0.0);
    let unused = (spec.resin.pure_radon && absorbs)
        .then(|| "resin.pure_radon = true: the absorption is not used".to_owned());
    Ok([
        few_angles(spec).into_iter().collect(),
        narrow_arc(spec).into_iter().collect(),
        part_of_a_turn(spec).into_iter().collect(),
        lost_reflections(spec, optics).into_iter().collect(),
        optics.dark_inside(),
        optics.of_meshes.clone(),
        optics.through_walls(),
        optics.coarse_voxels(grid).into_iter().collect(),
        of_parts,
        light,
        covered,
        unused.into_iter().collect(),
    ]
    .concat())
}

#[cfg(test)]
mod tests;
