//! What a job is about, before any heavy work: the shape, the optics, the grid, and what they will cost.

use super::build::Optics;
use super::compatibility::wall_tolerance_mm;
use super::device;
use super::estimate::{self, Extent, FIELDS_PER_SCENARIO};
use super::folder::RunFolder;
use super::kinds::known_elsewhere;
use super::read::Job;
use super::refinement::{self, Level};
use super::resolve::{JobKinds, counted_as, try_kinds};
use super::resources::{available_disk_mb, compared, free_memory_mb, memory_budget_mb, require};
use super::scenarios::{self, Scenario};
use super::spec::{GridSpec, JobSpec};
use super::{cells, clip, in_time, light, multiresolution, property, species, time_refusals};
use crate::error::{Error, Result};
use crate::exposure::Printer;
use crate::field::HostField;
use crate::grid::{PatternGrid, Volume, VolumeGrid};
use crate::io::npy::read_patterns;
use crate::models::{DoseLayout, PatternLayout, Run};
use crate::models::{OpticalScene, Purpose, planner};
use crate::objective::penalty::Penalties;
use crate::objective::{ObjectiveInput, Sum};
use crate::optics::light::Light;
use crate::optimize::start::InitialPatterns;
use crate::optimize::{Keep, Optimizer};
use crate::ranks::Communicator;
use crate::report;
use crate::response::{Response, dose_for};
use crate::target::{
    self, Resolution, Role, Shape, Target, default_grid, label, label_columns, label_voxels,
};
use crate::units::concise;
use serde_json::Value;
use std::path::{Path, PathBuf};
use std::sync::Arc;

/// Least memory of a quasi-Newton method that is still worth having.
const LEAST_MEMORY: usize = 3;
/// Parts of a voxel that are rounding of the job's lengths.
const ROUNDING: f64 = 1e-6;

/// A job that can be run.
pub(crate) struct Scene {
    /// The tables; the optimizer's memory may have been lowered.
    pub(crate) spec: JobSpec,
    /// The folder that files of the tables begin in.
    pub(crate) base: PathBuf,
    /// Name of the part.
    pub(crate) name: String,
    /// The shape.
    pub(crate) shape: Arc<dyn Shape>,
    /// The kinds that the job names.
    pub(crate) kinds: JobKinds,
    /// Whether its surface cuts voxels of the optimization into cells.
    pub(crate) has_cells: bool,
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
    pub(crate) mixing: Option<Vec<species::Row>>,
    /// Further species, on the same voxels.
    pub(crate) others: Vec<Scene>,
    /// The same job with some keys set otherwise, on the same voxels.
    pub(crate) scenarios: Vec<Scenario>,
    /// Choices that were made.
    pub(crate) notes: Vec<String>,
    /// What may be wrong.
    pub(crate) warnings: Vec<String>,
    /// The processes that share the frames of the optimization; None: this one works alone.
    pub(crate) ranks: Option<Arc<dyn Communicator>>,
}

/// The target on a grid.
#[derive(Clone)]
pub(crate) struct Voxels {
    pub(crate) target: Target,
    pub(crate) labels: Volume<u8>,
    /// Smallest inside fraction of voxels that light should reach.
    least: f32,
}

/// Smallest inside fraction that light should reach where the objective sees fractions: thinner slivers are left to chance.
const SLIVER: f32 = 0.05;

impl Scene {
    /// Reads the target and refuses whatever can be refused before heavy work.
    ///
    /// # Errors
    /// Everything of the sections "Bad input": see [`Error`].
    pub(crate) fn new(job: &Job, run: &Run) -> Result<Self> {
        Self::of_all_species(job, run).map_err(|e| job.locate(e))
    }

    fn of_all_species(job: &Job, run: &Run) -> Result<Self> {
        let of_first = |e| match job.spec.species.is_empty() {
            true => e,
            false => species::at_species(&job.spec, 0, e),
        };
        let mut scene = Self::of_species(job, 0, None, run).map_err(of_first)?;
        for s in 1..job.spec.species.len() {
            let other = Self::of_species(job, s, Some(&scene.grid), run);
            scene
                .others
                .push(other.map_err(|e| species::at_species(&job.spec, s, e))?);
        }
        species::must_fit(&scene)?;
        in_time::must_be_shaded(&scene)?;
        scene.scenarios = scenarios::of_job(job, &scene, run)?;
        Ok(scene)
    }

    /// The scene of one species; on these voxels where they are given.
    pub(super) fn of_species(
        job: &Job,
        s: usize,
        on: Option<&VolumeGrid>,
        run: &Run,
    ) -> Result<Self> {
        let mut spec = job.spec.of_species(s);
        for pointer in ["/patterns/file", "/patterns/bounds_as/patterns/file"] {
            if let Some(Value::String(file)) = spec.start.pointer_mut(pointer) {
                *file = job.base().join(&*file).to_string_lossy().into_owned();
            }
        }
        RunFolder::check(&job.folder())?;
        let mut optics = Optics::new(&spec, &job.base())?;
        let printers = device::printers(&spec, &job.base(), &optics.lights)?;
        let mut notes = optics.leave_dark(printers.as_deref().unwrap_or_default());
        notes.extend(given_patterns(&spec, &optics)?);
        let shape = target::build_under(&spec.target, &job.base(), "target", run)
            .map_err(|e| at_target(&spec, e))?;
        let shape: Arc<dyn Shape> = Arc::from(shape);
        let kinds = JobKinds::read(&spec, &job.base()).map_err(known_elsewhere)?;
        let has_cells = kinds.cells_key().is_some();
        try_kinds(&spec, &kinds, optics.model.as_ref(), shape.is_gray())
            .map_err(known_elsewhere)?;
        cells::must_fit(&kinds, shape.as_ref(), optics.model.as_ref())?;
        time_refusals::must_be_whole(&spec, &kinds)?;
        property::must_fit(&spec, &job.base())?;
        counted_as(&spec, shape.is_gray())?;
        let unit = ask_for_unit(&spec, &optics, shape.as_ref());
        let placed = match on {
            Some(grid) => Ok((grid.clone(), 0.0)),
            None => grid_of(
                &spec,
                &optics,
                bounds_of(&spec, shape.as_ref(), &job.base(), run)?,
            ),
        };
        optics.wall_tolerance_mm =
            wall_tolerance_mm(&spec, placed.as_ref().ok().map(|(grid, _)| grid))?;
        let touching = optics
            .must_hold(&spec, shape.as_ref())
            .map_err(|e| asking(e, unit.as_deref()))?;
        if spec.target.insert_shadow.unwrap_or(true) {
            optics.add_inserts(shape.as_ref())?;
        }
        let (grid, moved_mm) = placed?;
        notes.extend(moved(moved_mm));
        notes.extend(chosen(&spec));
        must_be_seen(shape.as_ref(), &grid, unit.as_deref())?;
        time_refusals::must_be_stable(&spec, &grid)?;
        let cut_off = clip::must_hold(&spec.grid, &grid, shape.as_ref())?;
        // A file that is missing is told before numbers that do not suit it
        let covered = optics.family(&grid)?.check(&optics.scene(), &grid)?;
        optics.must_be_judged(&spec)?;
        let light = light::must_arrive(&optics, &grid)?;
        for (path, common) in kinds.common() {
            common
                .check_files(&grid, &job.base())
                .map_err(|e| e.under(path))?;
        }
        let lit = optimizing(&optics, &shape, has_cells);
        let family = planner::choose(optics.model.as_ref(), &lit, &grid)?;
        let of = (&optics, family.as_ref());
        let levels = refinement::levels((&spec, &kinds), of, &grid, shape.bounds_mm());
        let sharpened = refinement::sharpened((&spec, &kinds), family.as_ref(), &levels);
        let kinds = sharpened.unwrap_or(kinds);
        let chosen = || refinement::judged(&grid, &levels);
        let refine = spec.evaluate.refine.unwrap_or_else(chosen);
        let memory = quasi_newton_memory(&job.resolved().optimizer).unwrap_or(0);
        let canvases = printers.iter().flatten().map(Printer::canvas_grid);
        let plain = Extent::new(&optics, &grid, shape.bounds_mm(), refine, memory);
        let last = &levels[levels.len() - 1];
        let finest = last.grid.clone();
        let turned = OpticalScene {
            lights: &last.lights,
            ..lit
        };
        let kept = family.cost(&turned, &finest).unwrap_or_default();
        let kept_of_the_job = family.cost(&lit, &grid)?;
        let entries = [&kept, &kept_of_the_job].map(|cost| cost.cached_bytes.unwrap_or_default());
        let of_the_job = (&grid, &optics.lights[..], spec.stop.iterations);
        let effort = refinement::effort(&levels, of_the_job, entries);
        let extent = Extent {
            effort: effort * (1 + spec.scenario.len()) as f64,
            cached_entries: kept.cached_entries,
            cached_bytes: kept.cached_bytes,
            finest,
            fields: with_fields(&spec, &kinds, shape.is_gray())
                + if has_cells { cells::FIELDS } else { 0 },
            canvas: canvases.map(|canvas| canvas.len()).sum(),
            stacked: bytes_stacked(&spec),
            scenarios: spec.scenario.len(),
            working_mb: [
                kept_of_the_job.working_bytes as f64 / 1e6,
                judged_mb(&optics, &grid, refine)?,
            ],
            ..plain
        };
        let mut scene = Scene {
            base: job.base(),
            name: spec.target.name(),
            warnings: [
                shape.warnings(),
                cut_off.into_iter().collect(),
                few_angles(&spec).into_iter().collect(),
                on_its_own_grid(&spec).into_iter().collect(),
                optics.leaning(shape.as_ref()),
                optics.moved_away(shape.as_ref()),
                optics.coarse(shape.as_ref()),
                touching,
                light,
                covered,
                unit.into_iter().collect(),
            ]
            .concat(),
            notes,
            ranks: None,
            shape,
            has_cells,
            levels,
            mixing: spec.mixing()?,
            others: Vec::new(),
            scenarios: Vec::new(),
            kinds,
            spec,
            optics,
            printers,
            grid,
            extent,
        };
        let notes = scene.printers.iter().flatten().flat_map(Printer::notes);
        scene.warnings.extend(notes.cloned());
        scene.warnings.extend(multiresolution::left_out(&scene));
        scene.bound_by_time()?;
        if scene.spec.resin.pure_radon
            && scene.spec.resin.absorption_per_mm.is_some_and(|a| a > 0.0)
        {
            scene
                .warnings
                .push("resin.pure_radon = true: the absorption is not used".to_owned());
        }
        scene.fit_memory()?;
        let disk = available_disk_mb(&job.folder());
        require(
            "output.folder",
            "disk for the run folder",
            scene.extent.disk_mb(),
            disk,
            "a folder on a larger disk, or a smaller job",
        )?;
        Ok(scene)
    }

    /// Notes on which voxels the patterns will be optimized.
    pub(crate) fn note_levels(&mut self) {
        self.notes
            .extend(refinement::note(&self.levels, &self.grid));
    }

    /// Bounds the pixels by what the machine can give in the time that it has.
    fn bound_by_time(&mut self) -> Result<()> {
        let Some((white, seconds)) = device::white_in_time(&self.spec, self.response().as_ref())?
        else {
            return Ok(());
        };
        let max = self.spec.bounds.max.map_or(white, |max| max.min(white));
        if max < self.spec.bounds.min {
            return Err(Error::config(
                "printer.time_s",
                format!(
                    "in {seconds} s a pixel gives {white:.4}, less than bounds.min = {}",
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

    /// Lowers the optimizer's memory and the refinement of the evaluation until both fit, and says so.
    fn fit_memory(&mut self) -> Result<()> {
        let budget = memory_budget_mb(self.spec.resources.memory_gb);
        let fits = |needed: u64| budget.is_none_or(|budget| needed <= budget);
        let asked = self.extent.memory;
        while !fits(self.extent.optimization_mb()) && self.extent.memory > LEAST_MEMORY {
            self.extent.memory -= 1;
        }
        if self.extent.memory < asked {
            let memory = self.extent.memory;
            set_quasi_newton_memory(&mut self.spec.optimizer, memory);
            self.kinds.set_memory(memory);
            self.warnings.push(format!(
                "the memory budget (resources.memory_gb) is too small: optimizer.lbfgs.memory is {memory}, not {asked}"
            ));
        }
        let asked = self.extent.refine;
        while !fits(self.extent.evaluation_mb()) && self.extent.refine > 1 {
            self.extent.refine -= 1;
            self.extent.working_mb[1] = judged_mb(&self.optics, &self.grid, self.extent.refine)?;
        }
        if self.extent.refine < asked {
            let refine = self.extent.refine;
            self.warnings.push(format!(
                "the memory budget (resources.memory_gb) is too small: evaluating on {}, not on a {asked}× finer one",
                match refine {
                    1 => "the job's own grid".to_owned(),
                    refine => format!("a {refine}× finer grid"),
                }
            ));
        }
        for (what, parts) in [
            ("memory for the optimization", self.extent.optimization()),
            ("memory for the evaluation", self.extent.evaluation()),
        ] {
            let [voxels_mb, pixels_mb, frames_mb] = parts;
            let (key, accepted) = if frames_mb > voxels_mb.max(pixels_mb) {
                let accepted =
                    "fewer pixels or voxels, larger errors allowed in the model, fewer --threads";
                ("model".to_owned(), accepted)
            } else if voxels_mb >= pixels_mb {
                let accepted = "fewer voxels (a larger grid.pitch_mm, a smaller grid.shape)";
                (grid_key(&self.spec), accepted)
            } else if what.ends_with("evaluation") && 2.0 * self.extent.canvas_mb() > pixels_mb {
                let accepted =
                    "a smaller canvas (it need only hold the patterns), or fewer light.angles";
                ("printer.canvas".to_owned(), accepted)
            } else {
                let accepted = "fewer pixels or angles (light.pixels, light.angles)";
                (pixels_key(&self.spec), accepted)
            };
            let needed_mb = estimate::whole_mb(parts);
            require(&key, what, needed_mb, budget, accepted)?;
        }
        self.warn_of_others();
        Ok(())
    }

    /// Warns where other programs hold the memory that the run plans with.
    fn warn_of_others(&mut self) {
        let needed = self
            .extent
            .optimization_mb()
            .max(self.extent.evaluation_mb());
        if let Some(free) = free_memory_mb().filter(|&free| free < needed) {
            self.warnings.push(format!(
                "the run needs {needed} MB of memory and {free} MB are free now: it may become slow or be stopped by the system. End other \
                 programs, or make the job smaller (grid.pitch_mm, light.pixels)"
            ));
        }
    }

    /// The finer grid of the evaluation.
    pub(crate) fn fine_grid(&self) -> VolumeGrid {
        self.grid.refined(self.extent.refine)
    }

    /// What light passes in the optimization, and the surface where an objective has cells.
    pub(crate) fn optimizing(&self) -> OpticalScene<'_> {
        optimizing(&self.optics, &self.shape, self.has_cells)
    }

    /// The target on a grid.
    ///
    /// # Errors
    /// As [`target::voxelize`].
    pub(crate) fn voxels(&self, grid: &VolumeGrid) -> Result<Voxels> {
        self.voxels_under(grid, &Run::new())
    }

    /// The same as a part of a run.
    ///
    /// # Errors
    /// As [`voxels`](Self::voxels); [`Error::Canceled`].
    pub(crate) fn voxels_under(&self, grid: &VolumeGrid, run: &Run) -> Result<Voxels> {
        let shape = self.shape.as_ref();
        let target = target::voxelize_under(shape, &self.name, grid, &run.part(0.9))
            .map_err(|e| at_grid(&self.spec, e))?;
        let counts = self.optics.counts(self.spec.grid.region, &self.grid);
        let mut labels = if self.optics.vial.is_invariant() {
            label_columns(&target, |[x, y]| counts([x, y, 0.0]))
        } else {
            label_voxels(&target, counts)
        };
        // There is no resin in an insert
        if let Some(insert) = self.shape.body(Role::Insert) {
            let inside = target::sampled(insert, grid, run)?.values;
            for (label, inside) in labels.values.iter_mut().zip(inside) {
                *label = if inside >= 0.5 {
                    label::OUTSIDE
                } else {
                    *label
                };
            }
        }
        let least = if self.kinds.sees_fractions() {
            SLIVER
        } else {
            0.5
        };
        Ok(Voxels {
            target,
            labels,
            least,
        })
    }

    /// Refuses a start that asks for doses which the material does not have, once the values of a gray target are known.
    ///
    /// # Errors
    /// [`Error::Config`].
    pub(crate) fn must_start(&self, voxels: &Voxels) -> Result<()> {
        if !voxels.target.gray || !self.kinds.asks_for_doses() {
            return Ok(());
        }
        let values = voxels
            .target
            .inside
            .values
            .iter()
            .zip(&voxels.labels.values);
        let counted = values.filter(|(_, label)| **label != label::OUTSIDE);
        let highest = counted.fold(0.0f32, |highest, (&value, _)| highest.max(value));
        dose_for(self.response().as_ref(), f64::from(highest))
            .map(drop)
            .map_err(|e| e.under("response"))
    }

    /// Share of each voxel that no light may pass, when the target has such bodies.
    ///
    /// # Errors
    /// As [`target::voxelize`].
    pub(crate) fn keep_dark(&self, grid: &VolumeGrid) -> Result<Option<Volume<f32>>> {
        let dark = self.shape.body(Role::KeepDark);
        dark.map(|dark| target::sampled(dark, grid, &Run::new()))
            .transpose()
    }

    /// Which voxels belong to bodies that are not printed: inserts, and those that stay dark by these shares.
    ///
    /// # Errors
    /// As [`target::voxelize`].
    pub(crate) fn bodies(
        &self,
        grid: &VolumeGrid,
        dark: Option<&Volume<f32>>,
    ) -> Result<Option<Volume<u8>>> {
        let insert = self.shape.body(Role::Insert).map(|body| body.sample(grid));
        let insert = insert.transpose()?;
        if dark.is_none() && insert.is_none() {
            return Ok(None);
        }
        let mut bodies = Volume::filled(grid.clone(), 0u8);
        for (mark, shares) in [(report::DARK, dark), (report::INSERT, insert.as_ref())] {
            let shares = shares.into_iter().flat_map(|shares| &shares.values);
            for (body, _) in bodies
                .values
                .iter_mut()
                .zip(shares)
                .filter(|(_, s)| **s >= 0.5)
            {
                *body = mark;
            }
        }
        Ok(Some(bodies))
    }

    /// The response of the material.
    pub(crate) fn response(&self) -> Arc<dyn Response> {
        Arc::clone(&self.kinds.response)
    }

    /// The sum of the objectives of the job, or of kinds that differ from its own in these alone.
    ///
    /// # Errors
    /// [`Error::Config`].
    pub(crate) fn objective(
        &self,
        kinds: &JobKinds,
        layout: &DoseLayout,
        voxels: &Voxels,
    ) -> Result<Sum<HostField>> {
        let Voxels { target, labels, .. } = voxels;
        let input = ObjectiveInput {
            layout,
            labels,
            target,
            response: self.response(),
        };
        let sum = kinds.objective(&input, true);
        sum.map(|sum| sum.scaled(layout.grid.voxel_mm3() / self.grid.voxel_mm3()))
    }

    /// The penalties on the patterns.
    ///
    /// # Errors
    /// [`Error::Config`].
    pub(crate) fn penalties(&self, lights: &[PatternLayout]) -> Result<Penalties<HostField>> {
        self.kinds.penalties(lights)
    }

    /// The optimizer.
    ///
    /// # Errors
    /// [`Error::Config`].
    pub(crate) fn optimizer(&self) -> Result<Box<dyn Optimizer<HostField>>> {
        self.kinds.optimizer()
    }

    /// Where the optimizer begins.
    ///
    /// # Errors
    /// [`Error::Config`].
    pub(crate) fn start(&self) -> Result<Box<dyn InitialPatterns>> {
        self.kinds.start()
    }
}

impl Voxels {
    /// Voxels that light should reach: 1 where something is to be printed, else 0.
    pub(crate) fn wanted(&self) -> Volume<u8> {
        let (labels, inside) = (&self.labels.values, &self.target.inside.values);
        let wanted = |(&l, &s): (&u8, &f32)| {
            let least = if self.target.gray {
                f32::MIN_POSITIVE
            } else {
                self.least
            };
            u8::from(l == label::PART || (l == label::VOID && s >= least))
        };
        Volume {
            grid: self.labels.grid.clone(),
            values: labels.iter().zip(inside).map(wanted).collect(),
        }
    }

    /// Voxels that count and that light should not reach, 1, else 0.
    pub(crate) fn unwanted(&self) -> Volume<u8> {
        let mut unwanted = self.wanted();
        for (wanted, &label) in unwanted.values.iter_mut().zip(&self.labels.values) {
            *wanted = u8::from(label != label::OUTSIDE && *wanted == 0);
        }
        unwanted
    }
}

/// Volumes that a further species, and a print in time, take, as objectives with fields.
const PER_SPECIES: usize = 2;
const PER_PRINT: usize = 5;

/// Objectives with numbers of their own for every voxel.
fn with_fields(spec: &JobSpec, kinds: &JobKinds, gray: bool) -> usize {
    let common = kinds.common();
    let count = common
        .filter(|(_, common)| gray || common.has_fields())
        .count();
    // Dose and target of each further species or scenario; state and snapshots of a print in time
    count
        + PER_SPECIES * spec.species.len().saturating_sub(1)
        + FIELDS_PER_SCENARIO * spec.scenario.len()
        + if spec.schedule.is_some() {
            PER_PRINT
        } else {
            0
        }
}

/// Bytes of a canvas pixel in `frames.npz`, 0 when the job asks for none.
fn bytes_stacked(spec: &JobSpec) -> usize {
    let asked = spec.printer.as_ref().is_some_and(|printer| printer.stack);
    usize::from(asked) * if spec.evaluate.bit_depth > 8 { 2 } else { 1 }
}

/// The key that says how many voxels there are.
fn grid_key(spec: &JobSpec) -> String {
    let key = if spec.grid.shape.is_some() {
        "grid.shape"
    } else {
        "grid.pitch_mm"
    };
    key.to_owned()
}

/// The key of the light with the most pixels.
fn pixels_key(spec: &JobSpec) -> String {
    let pixels = |i: &usize| {
        let light = &spec.light[*i];
        light.pixels.iter().product::<usize>() * light.angles.count()
    };
    let largest = (0..spec.light.len()).max_by_key(pixels).unwrap_or(0);
    format!("light[{largest}].pixels")
}

/// Says which key asked for voxels that the memory does not hold.
fn at_grid(spec: &JobSpec, error: Error) -> Error {
    match error {
        Error::Resources {
            what,
            needed_mb,
            available_mb,
            advice,
        } => Error::config(
            grid_key(spec),
            match available_mb {
                Some(mb) => compared(&what, needed_mb, mb),
                None => {
                    format!("{what}: {needed_mb} MB needed, but the system refused to allocate it")
                }
            },
            advice,
        ),
        other => other,
    }
}

/// Finds the key of the first setting that this target does not support.
pub(super) fn at_section(path: &str, error: Error) -> Error {
    match error {
        Error::Unsupported { what, reason } => {
            let (found, accepted) = reason.split_once("; ").unwrap_or((&reason, "another kind"));
            Error::config(path, format!("{what}, but {found}"), accepted)
        }
        other => other,
    }
}

/// Says which key named the file that could not be read.
fn at_target(spec: &JobSpec, error: Error) -> Error {
    let key = match (&spec.target.mesh, &spec.target.stack) {
        (Some(_), _) => "target.mesh",
        (None, Some(_)) => "target.stack",
        (None, None) => "target.image",
    };
    match error {
        Error::Io { .. } => Error::config(key, error.to_string(), "a file that can be read"),
        Error::Mesh { ref accepted, .. } | Error::Format { ref accepted, .. } => {
            let accepted = accepted.clone();
            let text = error.to_string();
            let found = text
                .split("; accepted: ")
                .next()
                .unwrap_or(&text)
                .to_owned();
            Error::config(key, found, accepted)
        }
        other => other,
    }
}

/// A part of a mesh is expected to be no smaller than this share of what the resin holds.
const SMALL: f64 = 0.01;

/// Asks for the unit of a mesh whose part is far too large or small for the vial.
fn ask_for_unit(spec: &JobSpec, optics: &Optics, shape: &dyn Shape) -> Option<String> {
    let across = 2.0 * optics.vial.resin_wall().inscribed_radius();
    let height = |light: &Light| {
        let field = light.pixels.field_mm();
        field[1][1] - field[0][1]
    };
    let room = optics.lights.iter().map(height).fold(across, f64::max);
    let expected = [SMALL * across, room];
    spec.target.ask_for_unit(shape.bounds_mm(), expected)
}

/// Adds a question to what would be accepted.
fn asking(mut error: Error, question: Option<&str>) -> Error {
    if let (Error::Config { accepted, .. }, Some(question)) = (&mut error, question) {
        accepted.push_str("; ");
        accepted.push_str(question);
    }
    error
}

/// Refuses a part smaller than a voxel, where its file may be in another unit.
fn must_be_seen(shape: &dyn Shape, grid: &VolumeGrid, question: Option<&str>) -> Result<()> {
    let [low, high] = shape.bounds_mm();
    let longest = (0..3).map(|i| high[i] - low[i]).fold(0.0, f64::max);
    match question {
        Some(_) if longest < grid.pitch_mm => {
            let found = format!(
                "the part is {} mm long, a voxel of the grid {} mm",
                concise(longest),
                concise(grid.pitch_mm)
            );
            let error = Error::config("target", found, "a target larger than a voxel");
            Err(asking(error, question))
        }
        _ => Ok(()),
    }
}

/// Memory of the frames that are judged at a time, MB.
fn judged_mb(optics: &Optics, grid: &VolumeGrid, refine: usize) -> Result<f64> {
    let grid = grid.refined(refine);
    let scene = OpticalScene {
        purpose: Purpose::Evaluate { refine },
        ..optics.scene()
    };
    let cost = optics.family(&grid)?.cost(&scene, &grid)?;
    Ok(cost.working_bytes as f64 / 1e6)
}

/// The box of all that is to be printed, of all species.
fn bounds_of(spec: &JobSpec, shape: &dyn Shape, base: &Path, run: &Run) -> Result<[[f64; 3]; 2]> {
    let [mut low, mut high] = shape.bounds_mm();
    for (s, species) in spec.species.iter().enumerate().skip(1) {
        let Some(own) = &species.target else { continue };
        let key = format!("species[{s}].target");
        let [l, h] = target::build_under(own, base, &key, run)?.bounds_mm();
        for i in 0..3 {
            (low[i], high[i]) = (low[i].min(l[i]), high[i].max(h[i]));
        }
    }
    Ok([low, high])
}

/// The grid of a job: given, or round the target and cut by the resin; and how far it was moved up to lie on the rows, mm.
fn grid_of(spec: &JobSpec, optics: &Optics, bounds: [[f64; 3]; 2]) -> Result<(VolumeGrid, f64)> {
    let under = |e: Error| e.under("grid");
    let GridSpec {
        pitch_mm,
        shape: counts,
        ..
    } = &spec.grid;
    let grid = match (pitch_mm, counts) {
        (Some(pitch), Some([x, y, z])) => Ok(VolumeGrid {
            shape: [*z, *y, *x],
            pitch_mm: pitch.0,
            height_mm: pitch.0,
            center_mm: [0.0, 0.0, (bounds[0][2] + bounds[1][2]) / 2.0],
        }),
        (None, Some(counts)) => default_grid(bounds, Resolution::Shape(*counts)).map_err(under),
        (pitch, None) => {
            let [across, along] = finest(optics)?.pitch_mm;
            let pitch = pitch.map_or(across.min(along), |pitch| pitch.0);
            let grid = default_grid(bounds, Resolution::Pitch(pitch)).map_err(under)?;
            Ok(cut(&grid, optics.vial.resin_wall().inscribed_radius()))
        }
    }?;
    if !spec.grid.on_rows {
        return Ok((grid, 0.0));
    }
    let rows = finest(optics)?;
    let before = grid.center_mm[2];
    let grid = on_rows(grid, rows, [bounds[0][2], bounds[1][2]]);
    let moved_mm = grid.center_mm[2] - before;
    Ok((grid, moved_mm))
}

/// The pixels with the shortest edge.
fn finest(optics: &Optics) -> Result<&PatternGrid> {
    let edge = |pixels: &PatternGrid| pixels.pitch_mm[0].min(pixels.pitch_mm[1]);
    let pixels = optics.lights.iter().map(|light| &light.pixels);
    let finest = pixels.reduce(|a, b| if edge(b) < edge(a) { b } else { a });
    finest.ok_or_else(|| Error::config("light", "there is none", "at least one [[light]]"))
}

/// Says that the grid does not stand where the target is.
fn moved(moved_mm: f64) -> Option<String> {
    let way = if moved_mm > 0.0 { "up" } else { "down" };
    (moved_mm != 0.0).then(|| {
        format!(
            "the grid is moved {way} by {} mm, so that its slices lie on rows of pixels (grid.on_rows = false turns this off)",
            concise(moved_mm.abs())
        )
    })
}

/// Says that no finer voxels will be looked at.
fn on_its_own_grid(spec: &JobSpec) -> Option<String> {
    (spec.evaluate.refine == Some(1)).then(|| {
        "evaluate.refine = 1: the print is evaluated on the job's own voxels, where IoU is higher than on finer ones; leave the key out for finer voxels"
            .to_owned()
    })
}

/// Directions from which light comes, below which a part cannot take its shape.
const FEW_ANGLES: usize = 12;

/// Warns of light that comes from a handful of directions.
pub(super) fn few_angles(spec: &JobSpec) -> Option<String> {
    let azimuths = spec.light.iter().flat_map(|light| {
        let (azimuths, _) = light.angles.azimuths(light.rotation);
        // Directions that differ by less than a thousandth of a degree are one
        azimuths
            .into_iter()
            .map(|azimuth| (azimuth.to_degrees().rem_euclid(360.0) * 1e3).round() as u64 % 360_000)
    });
    let count = azimuths.collect::<std::collections::BTreeSet<_>>().len();
    (count < FEW_ANGLES).then(|| {
        let from = if count == 1 { "one direction".to_owned() } else { format!("{count} directions") };
        format!(
            "light.angles: light comes from {from} only, so doses add up along stripes and no part takes its shape; \
             use some hundred angles"
        )
    })
}

/// What a job chooses of its method that no line of the screen shows.
fn chosen(spec: &JobSpec) -> Vec<String> {
    let has_edges = spec.optimizer["osmo"]["edges"] == true;
    let edges = has_edges.then_some(
        "optimizer.osmo.edges = true: each step ends with two more halves, at the part's surface",
    );
    let last = (spec.stop.keep == Keep::Last).then_some(
        "stop.keep = \"last\": the patterns are those of the last iteration, the best ones or not",
    );
    [edges, last]
        .into_iter()
        .flatten()
        .map(str::to_owned)
        .collect()
}

/// Moves a grid along z, by half a voxel at most, so that a face of its slices lies on the edge of a row of pixels.
///
/// Slices as high as the rows, but half a row beside them, see the mean of two rows: patterns whose rows alternate between
/// bright and dark would look even to the optimization, and nothing would damp them. On a gear with
/// `surface = "fraction"` that took the IoU of the written patterns from 0.98 to 0.52. A grid that would no longer hold the
/// target (`[low, high]` along z, mm) stays where it is.
fn on_rows(grid: VolumeGrid, rows: &PatternGrid, target: [f64; 2]) -> VolumeGrid {
    let edge = rows.field_mm()[1][1];
    let up = (edge - grid.bounds_mm()[0][2]) / grid.pitch_mm;
    // Rounding of lengths decides neither whether nor, at half a voxel, which way
    let part = up - (up - ROUNDING).round();
    let mut moved = grid.clone();
    moved.center_mm[2] += part * grid.pitch_mm;
    let [low, high] = moved.bounds_mm();
    let slack = ROUNDING * grid.pitch_mm;
    let holds = low[2] <= target[0] + slack && high[2] >= target[1] - slack;
    if part.abs() > ROUNDING && holds {
        moved
    } else {
        grid
    }
}

/// Without the rows and columns that lie wholly beyond `limit` from the axis.
fn cut(grid: &VolumeGrid, limit: f64) -> VolumeGrid {
    let mut cut = grid.clone();
    for (axis, dimension) in [(0, 2), (1, 1)] {
        let half = |n: usize| n as f64 * grid.pitch_mm / 2.0;
        let (n, center) = (grid.shape[dimension], grid.center_mm[axis]);
        let beyond =
            |reach: f64| (((reach - limit) / grid.pitch_mm).floor().max(0.0) as usize).min(n / 2);
        let (high, low) = (beyond(half(n) + center), beyond(half(n) - center));
        cut.shape[dimension] = n - high - low;
        cut.center_mm[axis] = center + half(low) - half(high);
    }
    cut
}

/// The parameter `memory` of the one kind of a section, when it has one.
fn quasi_newton_memory(section: &Value) -> Option<usize> {
    let memory = section
        .as_object()?
        .values()
        .next()?
        .get("memory")?
        .as_u64()?;
    usize::try_from(memory).ok()
}

fn set_quasi_newton_memory(section: &mut Value, memory: usize) {
    if let Value::String(name) = section {
        *section = Value::Object(
            [(name.clone(), Value::Object(serde_json::Map::new()))]
                .into_iter()
                .collect(),
        );
    }
    if let Some(Value::Object(parameters)) = section
        .as_object_mut()
        .and_then(|map| map.values_mut().next())
    {
        parameters.insert("memory".to_owned(), memory.into());
    }
}

/// Refuses patterns to start from that cannot be read or are of other lights; says where their shape is another one.
fn given_patterns(spec: &JobSpec, optics: &Optics) -> Result<Vec<String>> {
    let Some(file) = spec.start.pointer("/patterns/file").and_then(Value::as_str) else {
        return Ok(Vec::new());
    };
    let key = "start.patterns.file";
    let lights = optics.lights.len();
    let accepted = format!(
        "patterns.npz of a run, or an .npz with an array `patterns` [angle, row, column]; of {lights} light(s)"
    );
    let arrays = read_patterns(Path::new(file))
        .map_err(|error| Error::config(key, error.to_string(), accepted.as_str()))?;
    if arrays.len() != lights {
        let found = format!("patterns of {} lights", arrays.len());
        return Err(Error::config(key, found, accepted));
    }
    let others = arrays.iter().zip(&optics.lights).filter_map(|(array, light)| {
        let (found, own) = (array.shape, light.pixels.shape());
        (found != own).then(|| {
            format!("{key}: patterns of {found:?} [angle, row, column] are resampled to {own:?} over the same field of view")
        })
    });
    Ok(others.collect())
}

/// What light passes in an optimization for a shape.
fn optimizing<'a>(
    optics: &'a Optics,
    shape: &'a Arc<dyn Shape>,
    has_cells: bool,
) -> OpticalScene<'a> {
    OpticalScene {
        solid: has_cells.then_some(shape),
        purpose: Purpose::Optimize,
        ..optics.scene()
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_grid_is_cut_by_the_resin_and_stays_where_it_was() {
        let grid = VolumeGrid {
            shape: [3, 40, 50],
            pitch_mm: 0.1,
            height_mm: 0.1,
            center_mm: [0.3, 0.0, 1.0],
        };
        let cut = cut(&grid, 1.95);
        // x from −2.2 to 2.8 keeps whole voxels up to beyond ±1.95: −2.0 … 2.0; y from −2 to 2 stays
        assert_eq!(cut.shape, [3, 40, 40]);
        let [low, high] = cut.bounds_mm();
        assert!(
            (low[0] + 2.0).abs() < 1e-12 && (high[0] - 2.0).abs() < 1e-12,
            "{low:?} {high:?}"
        );
        assert_eq!(super::cut(&grid, 10.0), grid);
    }

    #[test]
    fn slices_lie_on_the_rows_of_the_pixels() {
        let grid = |slices, z| VolumeGrid {
            shape: [slices, 4, 4],
            pitch_mm: 0.1,
            height_mm: 0.1,
            center_mm: [0.0, 0.0, z],
        };
        let rows = |count| PatternGrid::full_turn(3, 0.0, count, 8, 0.1);
        let moved =
            |slices, z, count| on_rows(grid(slices, z), &rows(count), [-0.5, 0.5]).center_mm[2];
        // Even slices about the middle of even rows, and odd ones of odd rows, stay; others move by half a voxel
        assert_eq!((moved(20, 0.0, 32), moved(21, 0.0, 33)), (0.0, 0.0));
        assert!(
            (moved(21, 0.0, 32) - 0.05).abs() < 1e-9,
            "{}",
            moved(21, 0.0, 32)
        );
        assert!((moved(20, 0.03, 32) - 0.0).abs() < 1e-9);
        assert!((moved(20, -0.03, 33) - -0.05).abs() < 1e-9);
        // Ten slices hold the target only where they are
        assert_eq!(moved(10, 0.0, 33), 0.0);
    }

    #[test]
    fn the_memory_of_a_quasi_newton_method_is_found_and_lowered() {
        let mut section = serde_json::json!({ "lbfgs": { "memory": 10 } });
        assert_eq!(quasi_newton_memory(&section), Some(10));
        set_quasi_newton_memory(&mut section, 4);
        assert_eq!(quasi_newton_memory(&section), Some(4));
        assert_eq!(
            quasi_newton_memory(&serde_json::json!({ "gradient": {} })),
            None
        );
    }
}
