//! A job that was read and whose every number is in its range.

use super::all_errors::with_others;
use super::document::Document;
use super::job_files::{absolute, make_absolute};
use super::kinds::{KindFamily, families, with_defaults};
use super::output::LEAST_REFINE;
use super::{not_finite, profiles, validate};
use crate::error::{Error, Result};
use crate::exposure::PrinterSpec;
use crate::job::spec::{Angles, JobSpec, default_objective};
use crate::models::ModelKind;
use crate::target::TargetSpec;
use std::path::{Path, PathBuf};

/// How many times coarser a quick trial is: at least the first; more, up to the second, until images have `TOY_PIXELS` pixels across.
const TOY: [usize; 2] = [3, 6];
const TOY_PIXELS: usize = 80;
/// Its limits.
const TOY_EDGE: usize = 12;
const TOY_FRAMES: usize = 36;
const TOY_ITERATIONS: usize = 3;
/// Rays, or paths, of a pixel, where a job asks for more: by the tables of models and their keys.
const TOY_RAYS: u64 = 4;
const RAYS: [[&str; 2]; 2] = [
    ["rays", "rays_per_pixel"],
    ["monte_carlo", "paths_per_pixel"],
];

/// A job: its tables, and the text they came from.
#[derive(Clone, Debug)]
pub struct Job {
    /// The text, for messages that say where.
    pub document: Document,
    /// The tables.
    pub spec: JobSpec,
    /// Whether a finished run of another job may be replaced.
    pub(crate) overwrite: bool,
    /// Whether it is a quick trial of the job that was read.
    pub(crate) is_toy: bool,
    /// Rows of models beyond [`MODELS`](crate::models::MODELS).
    pub(crate) models: &'static [ModelKind],
}

impl Job {
    /// Reads a job file, applies overrides (`stop.iterations=10`) and checks every range.
    ///
    /// # Errors
    /// [`Error::Io`]; [`Error::Config`] with key path, file and line, or the override's name.
    pub fn read(file: &Path, overrides: &[String]) -> Result<Self> {
        Self::changed(Document::read(file)?, overrides)
    }

    /// A job from a document with overrides.
    ///
    /// # Errors
    /// As [`read`](Self::read).
    pub fn changed(mut document: Document, overrides: &[String]) -> Result<Self> {
        overrides
            .iter()
            .try_for_each(|assignment| document.set(assignment))?;
        Self::from_document(document)
    }

    /// A job from a document.
    ///
    /// # Errors
    /// [`Error::Config`] with key path, file and line, or the override's name.
    pub fn from_document(document: Document) -> Result<Self> {
        Self::with_models(document, &[])
    }

    /// A job from a document, whose `[model]` may also be one of these rows: models of another crate.
    ///
    /// # Errors
    /// As [`from_document`](Self::from_document).
    pub fn with_models(mut document: Document, models: &'static [ModelKind]) -> Result<Self> {
        let base = base_of(&document);
        let mut root = document.root.clone();
        let filled = profiles::fill(&mut root, &base, |key| document.option(key).is_some());
        filled.map_err(|e| document.locate(e))?;
        document.root = root;
        let spec = JobSpec::from_document(&document).and_then(|spec| {
            validate::tables(&spec).map_err(|e| document.locate(e))?;
            Ok(spec)
        });
        let spec = spec.map_err(|first| with_others(&document, models, &base, first))?;
        Ok(Job {
            document,
            spec,
            overwrite: false,
            is_toy: false,
            models,
        })
    }

    /// Its name: the file's, without ending.
    #[must_use]
    pub fn name(&self) -> String {
        let stem = self
            .document
            .file
            .file_stem()
            .map(|stem| stem.to_string_lossy().into_owned());
        stem.unwrap_or_else(|| "job".to_owned())
    }

    /// The same job with another run folder, named by an option of the command line.
    #[must_use]
    pub fn with_folder(mut self, folder: &Path, option: &str) -> Self {
        let option = format!("{option} {}", folder.display());
        self.document.overridden("output.folder", option);
        self.spec.output.folder = Some(folder.to_owned());
        self
    }

    /// The same job, which may replace a finished run of another one.
    #[must_use]
    pub fn overwriting(mut self) -> Self {
        self.overwrite = true;
        self
    }

    /// The folder that paths of meshes and images are relative to.
    #[must_use]
    pub fn base(&self) -> PathBuf {
        base_of(&self.document)
    }

    /// The run folder.
    #[must_use]
    pub fn folder(&self) -> PathBuf {
        self.spec
            .output
            .folder
            .clone()
            .unwrap_or_else(|| Path::new("out").join(self.name()))
    }

    /// The job with every default written out, kinds' parameters included, that runs identically from any folder.
    #[must_use]
    pub fn complete(&self) -> JobSpec {
        let mut spec = with_every_default(self.spec.clone());
        let base = self.base();
        let objectives = spec.objectives.iter_mut().flatten();
        let tables = spec.objective.iter_mut().chain(objectives);
        let tables = tables.chain([&mut spec.response, &mut spec.start, &mut spec.vial.kind]);
        let of_species = spec
            .species
            .iter_mut()
            .flat_map(|s| s.objective.iter_mut().chain(&mut s.response));
        let maps = spec.property.iter_mut().map(|property| &mut property.map);
        let tables = tables.chain(&mut spec.model).chain(of_species).chain(maps);
        for table in tables.filter_map(serde_json::Value::as_object_mut) {
            make_absolute(table, &base);
        }
        for scenario in &mut spec.scenario {
            make_absolute(&mut scenario.set, &base);
        }
        let others = spec.species.iter_mut().filter_map(|s| s.target.as_mut());
        let targets = std::iter::once(&mut spec.target).chain(others);
        let printers = spec.printer.iter_mut().flat_map(PrinterSpec::files_mut);
        let lights = spec.light.iter_mut().flat_map(|light| {
            let curve = light.printer.gray_curve_file.iter_mut();
            curve.chain(&mut light.psf).chain(&mut light.selection.mask)
        });
        let maps = spec.resin.absorption_map.iter_mut();
        let maps =
            maps.flat_map(|map| std::iter::once(&mut map.absorption).chain(&mut map.attenuation));
        let files = targets.flat_map(TargetSpec::files_mut).chain(printers);
        let bodies = spec.obstacles.iter_mut().map(|body| &mut body.mesh);
        for file in files.chain(lights).chain(maps).chain(bodies) {
            *file = absolute(&base, file);
        }
        spec.output.folder = Some(absolute(Path::new(""), &self.folder()));
        spec
    }

    /// The same job as a quick trial: a third of the resolution (down to a sixth, so that images have 80 pixels across), few angles, rays and iterations,
    /// and no quality that is asked for (`evaluate.require_*`), but for those of these keys that the command line sets. What it prints is poor, but every
    /// stage runs.
    #[must_use]
    pub fn toy(mut self) -> Self {
        self.is_toy = true;
        let is_set = |key: &str| self.document.option(key).is_some();
        let spec = &mut self.spec;
        let across = spec.light.iter().flat_map(|light| light.pixels).max();
        let [least, most] = TOY;
        let coarser = across.unwrap_or(0).div_ceil(TOY_PIXELS).clamp(least, most);
        spec.grid
            .pitch_mm
            .iter_mut()
            // Without the last digits of a product: 0.3, not 0.30000000000000004
            .for_each(|pitch| pitch.0 = (pitch.0 * coarser as f64 * 1e9).round() / 1e9);
        for count in spec.grid.shape.iter_mut().flatten() {
            *count = count.div_ceil(coarser).max(TOY_EDGE);
        }
        for (i, light) in spec.light.iter_mut().enumerate() {
            light.pixels = light.pixels.map(|count| count.div_ceil(coarser));
            light.projector.coarsen(coarser as f64);
            light.selection.coarsen(coarser);
            // It is an image on the pixels of the whole job
            light.psf = None;
            match &mut light.angles {
                _ if is_set(&format!("light[{i}].angles")) => {}
                Angles::Even { count, .. } => *count = (*count).min(TOY_FRAMES),
                Angles::List(list) => list.truncate(TOY_FRAMES),
            }
        }
        spec.printer
            .iter_mut()
            .for_each(|printer| printer.coarsen(coarser as f64));
        for [kind, key] in RAYS {
            let rays = spec
                .model
                .as_mut()
                .and_then(|model| model.get_mut(kind)?.get_mut(key));
            if let Some(rays) = rays.filter(|_| !is_set(&format!("model.{kind}.{key}")))
                && rays.as_u64().is_some_and(|rays| rays > TOY_RAYS)
            {
                *rays = TOY_RAYS.into();
            }
        }
        if !is_set("stop.iterations") {
            spec.stop.iterations = spec.stop.iterations.min(TOY_ITERATIONS);
        }
        spec.grid.refine = Some(1);
        spec.evaluate.refine.get_or_insert(LEAST_REFINE);
        spec.evaluate.sub_angles = Some(spec.evaluate.sub_angles.unwrap_or(2).min(2));
        if !is_set("evaluate.require_iou") {
            spec.evaluate.require_iou = None;
        }
        if !is_set("evaluate.require_in_band") {
            spec.evaluate.require_in_band = None;
        }
        self
    }

    /// Adds file and line to an error about one of this job's keys, and that its numbers are those of a toy. A number that is not finite
    /// becomes an error of the keys that made it.
    #[must_use]
    pub fn locate(&self, error: Error) -> Error {
        let error = not_finite::blamed(&self.document.root, error);
        let mut error = self.document.locate(error);
        if let Error::Config { key, accepted, .. } = &mut error
            && self.is_toy
            && (key.ends_with("pixels") || key.starts_with("grid"))
        {
            let toy = "; `--toy` counts in pixels and voxels three times as large as the job's";
            // An error may pass here twice
            if !accepted.ends_with(toy) {
                accepted.push_str(toy);
            }
        }
        error
    }
}

fn base_of(document: &Document) -> PathBuf {
    document
        .file
        .parent()
        .map(Path::to_owned)
        .unwrap_or_default()
}

/// The same tables with the defaults of every kind written out.
pub(crate) fn with_every_default(mut spec: JobSpec) -> JobSpec {
    let families = families();
    let pages = |name: &str| {
        families
            .iter()
            .find(|f| f.name == name)
            .map_or(&[][..], |f: &KindFamily| &f.kinds)
    };
    spec.vial.kind = with_defaults(pages("vial"), &spec.vial.kind);
    if let Some(phantom) = &mut spec.target.phantom {
        *phantom = with_defaults(pages("target.phantom"), phantom);
    }
    for light in &mut spec.light {
        light.projector.0 = with_defaults(pages("projector"), &light.projector.0);
    }
    spec.resin.phase = with_defaults(pages("resin.phase"), &spec.resin.phase);
    if let Some(model) = &mut spec.model {
        *model = with_defaults(pages("model"), model);
    }
    spec.response = with_defaults(pages("response"), &spec.response);
    spec.optimizer = with_defaults(pages("optimizer"), &spec.optimizer);
    spec.start = with_defaults(pages("start"), &spec.start);
    if spec.objective.is_none() && spec.objectives.is_none() {
        spec.objective = Some(default_objective(&spec));
    }
    for objective in spec
        .objective
        .iter_mut()
        .chain(spec.objectives.iter_mut().flatten())
    {
        *objective = with_defaults(pages("objective"), objective);
    }
    for penalty in &mut spec.penalties {
        *penalty = with_defaults(pages("penalties"), penalty);
    }
    spec
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::job::tests::job_of;

    #[test]
    fn a_sweep_is_told_from_a_job() {
        let sweep = "job = \"a.toml\"\naxes = [{ key = \"stop.iterations\", values = [1] }]";
        let error = Job::from_document(Document::toml("sweep.toml", sweep).unwrap());
        let error = error.unwrap_err().to_string();
        assert!(error.contains("a sweep where a job is read"), "{error}");
    }

    #[test]
    fn a_whole_job_names_its_files_from_anywhere() {
        let changes = [
            "start={ patterns = { file = \"a.npz\", or = [\"b.npz\"] } }",
            "scenario=[{ set = { \"light[0].selection.mask\" = \"c.npy\" } }]",
        ];
        let job = job_of(crate::job::tests::FULL, &changes).complete();
        let tables = job.to_value().unwrap();
        for (place, name) in [
            ("/start/patterns/file", "a.npz"),
            ("/start/patterns/or/0", "b.npz"),
            ("/scenario/0/set/light[0].selection.mask", "c.npy"),
        ] {
            let file = tables.pointer(place).and_then(|v| v.as_str()).unwrap();
            assert!(Path::new(file).is_absolute(), "{place}: {file}");
            assert!(file.ends_with(name), "{place}: {file}");
        }
    }

    #[test]
    fn a_toy_has_the_counts_that_the_command_line_names() {
        let text = r#"
            target = { phantom = "gear", size_mm = 3.0 }
            grid = { pitch_mm = 0.1 }
            resin = { refractive_index = 1.5, absorption_per_mm = 0.05 }
            vial = { index_matched = { radius_mm = 3.0 } }
            light = [{ pixels = [60, 30], angles = 180, projector = { collimated = { pixel_pitch_mm = 0.1 } } }]
            stop = { iterations = 40 }
            evaluate = { require_iou = 0.9 }
            model = { rays = { rays_per_pixel = 64 } }
        "#;
        let toy = |changes: &[&str]| job_of(text, changes).toy().spec;
        let counts = |assignments: &[&str]| {
            let spec = toy(assignments);
            (
                spec.stop.iterations,
                spec.light[0].angles.count(),
                spec.evaluate.require_iou,
            )
        };
        assert_eq!(counts(&[]), (TOY_ITERATIONS, TOY_FRAMES, None));
        let set = [
            "stop.iterations=12",
            "light.angles=90",
            "evaluate.require_iou=0.5",
        ];
        assert_eq!(counts(&set), (12, 90, Some(0.5)));
        let rays = |set: &[&str]| toy(set).model.unwrap()["rays"]["rays_per_pixel"].clone();
        assert_eq!(rays(&[]), TOY_RAYS);
        assert_eq!(rays(&["model.rays.rays_per_pixel=16"]), 16);
        assert_eq!(rays(&["model={ rays = { rays_per_pixel = 2 } }"]), 2);
        // A third; down to 80 pixels; at most a sixth
        for (pixels, coarse, pitch) in [
            ("[60,30]", [20, 10], 0.3),
            ("[400,90]", [80, 18], 0.5),
            ("[4000,90]", [667, 15], 0.6),
        ] {
            let spec = toy(&[&format!("light.pixels={pixels}")]);
            let found = (
                spec.light[0].pixels,
                spec.grid.pitch_mm.map(|pitch| pitch.0),
            );
            assert_eq!(found, (coarse, Some(pitch)));
        }
    }

    #[test]
    fn counts_that_are_those_of_a_toy_are_told_as_such() {
        let text = "target.phantom = \"gear\"\ntarget.size_mm = 3\nvial.index_matched.radius_mm = 4\n\
             [resin]\nrefractive_index = 1.5\nabsorption_per_mm = 0.1\n\
             [[light]]\npixels = [60, 40]\nangles = 60\nprojector.collimated.pixel_pitch_mm = 0.1\n";
        let job = job_of(text, &[]);
        let blames_toy = |job: &Job, key: &str| {
            let error = Error::config(key, "found", "more of them");
            job.locate(error).to_string().contains("`--toy` counts")
        };
        let toy = job.clone().toy();
        assert!(blames_toy(&toy, "light[0].pixels") && blames_toy(&toy, "grid.pitch_mm"));
        assert!(!blames_toy(&toy, "target.mesh") && !blames_toy(&job, "light[0].pixels"));
    }
}
