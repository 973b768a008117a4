//! A job as objects: model, objective, start and evaluation, for programs with a loop of their own.
//!
//! A [`Job`] says what is wanted; a [`ResolvedJob`] has read its files, built its shape, vial, lights and grid, and refused what does not fit
//! together. Its [`Task`] is what an optimizer needs, on the finest voxels of the optimization; what patterns print is
//! [`evaluate`](ResolvedJob::evaluate)d as `tomolith run` does it: written with the job's bits, the vial turning, on finer voxels, and in time where the
//! job has a schedule.
//!
//! ```
//! use std::path::Path;
//! use tomolith::field::Field;
//! use tomolith::job::{Document, Job, ResolvedJob};
//! use tomolith::models::Run;
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
//! let (job, run) = (ResolvedJob::new(&job)?, Run::new());
//! let task = job.task(&run)?;
//! let begin = job.evaluate(&task.patterns(&task.start), &run)?;
//!
//! // A projected gradient with a fixed step, in place of the job's method
//! let (mut x, mut dose) = (task.start.clone(), task.model.new_dose()?);
//! let (mut cotangent, mut gradient) = (dose.zeros_like(), x.zeros_like());
//! let bounds = task.bounds()?;
//! let mut losses = Vec::new();
//! for _ in 0..15 {
//!     task.model.dose(&x, &mut dose, &run)?;
//!     losses.push(task.objective.value_and_gradient(&dose, &mut cotangent));
//!     task.model.pullback(&x, &cotangent, &mut gradient, &run)?;
//!     let step = 0.1 * x.max_abs() / gradient.max_abs();
//!     x.move_along(&gradient, -step, &bounds);
//! }
//! assert!(losses[14] < 0.5 * losses[0]); // the loss falls to less than half
//!
//! let end = job.evaluate(&task.patterns(&x), &run)?;
//! let iou = |print: &tomolith::job::Prediction| print.evaluation.measures.get("iou").unwrap();
//! assert!(iou(&end) > iou(&begin) && iou(&end) > 0.9); // and the print is better than that of the start
//! # Ok::<(), tomolith::Error>(())
//! ```

use crate::error::{Error, Result};
use crate::field::{Bounds, HostField};
use crate::grid::{Patterns, Volume, VolumeGrid};
use crate::job::dose::written::Written;
use crate::job::evaluate::evaluate_patterns;
use crate::job::evaluate::in_time::InTime;
use crate::job::evaluate::in_time::TimeSummary;
use crate::job::optimize::Stage;
use crate::job::progress::Silent;
use crate::job::resolve::{Scene, Voxels};
use crate::job::spec::read::Job;
use crate::metrics::Evaluation;
use crate::models::Run;
use crate::models::scenarios::SharedModel;
use crate::objective::Sum;
use crate::objective::penalty::Penalties;
use crate::optics::light::Light;
use crate::optics::vial::Vial;
use crate::optimize::{Limits, Optimizer, problem};
use crate::report::OneExposure;
use crate::target::{Shape, Target};

/// A job whose tables are objects; see the [module page](self).
pub struct ResolvedJob {
    pub(crate) scene: Scene,
    pub(crate) voxels: Voxels,
}

/// What patterns print.
#[derive(Clone, Debug)]
pub struct Prediction {
    /// The print of the dose of a turn, measured.
    pub evaluation: Evaluation,
    /// The prints of all species by their names, the first one's again; empty where there is one.
    pub species: Vec<(String, Evaluation)>,
    /// What they become at one exposure, where there are several.
    pub one_exposure: Option<OneExposure>,
    /// What each network becomes over time, where the job has a schedule; else empty.
    pub in_time: Vec<TimeSummary>,
}

/// What an optimizer needs.
pub struct Task {
    /// F, on the finest voxels of the optimization.
    pub model: SharedModel,
    /// L, of that dose.
    pub objective: Sum<HostField>,
    /// R, the price of patterns by themselves.
    pub penalties: Penalties<HostField>,
    /// Where the job begins.
    pub start: HostField,
    /// The bounds of each light's pixels.
    pub limits: Vec<Limits>,
    /// The target on the same voxels.
    pub target: Target,
    /// Which of them are part, void, or do not count ([`label`](crate::target::label)).
    pub labels: Volume<u8>,
}

impl ResolvedJob {
    /// Reads the files of a job, builds its objects and samples the target.
    ///
    /// # Errors
    /// [`Error::Config`] with the key for whatever does not fit together, and those of files.
    pub fn new(job: &Job) -> Result<Self> {
        let scene = Scene::new(job, &Run::new())?;
        let voxels = scene.voxels(&scene.grid).map_err(|e| job.locate(e))?;
        scene.must_start(&voxels).map_err(|e| job.locate(e))?;
        Ok(ResolvedJob { scene, voxels })
    }

    /// The job's voxels; those of the optimization and the evaluation are finer.
    #[must_use]
    pub fn grid(&self) -> &VolumeGrid {
        &self.scene.grid
    }

    /// What is printed.
    #[must_use]
    pub fn shape(&self) -> &dyn Shape {
        self.scene.shape.as_ref()
    }

    /// What holds the resin.
    #[must_use]
    pub fn vial(&self) -> &dyn Vial {
        self.scene.optics.vial.as_ref()
    }

    /// The projectors' pixels, and the resin as their light sees it.
    #[must_use]
    pub fn lights(&self) -> &[Light] {
        &self.scene.optics.lights
    }

    /// What people should know, one sentence each.
    #[must_use]
    pub fn warnings(&self) -> &[String] {
        &self.scene.warnings
    }

    /// The method of the job.
    ///
    /// # Errors
    /// [`Error::Config`].
    pub fn optimizer(&self) -> Result<Box<dyn Optimizer<HostField>>> {
        self.scene.kinds.on_host().optimizer()
    }

    /// Model, objective, start and bounds.
    ///
    /// # Errors
    /// [`Error::Config`] where the model does not fit, [`Error::Canceled`].
    pub fn task(&self, run: &Run) -> Result<Task> {
        let scene = &self.scene;
        let [.., level] = scene.levels.as_slice() else {
            unreachable!("a job has a level")
        };
        let stage = Stage::new(scene, &self.voxels, level, None, &mut Silent, run)?;
        let start = stage.start(scene, scene.kinds.start.as_ref(), run)?;
        Ok(Task {
            limits: stage.limits(scene, &start),
            penalties: scene.kinds.on_host().penalties(stage.model.patterns())?,
            objective: stage.objective(scene, 0)?,
            start,
            target: stage.voxels.target.clone(),
            labels: stage.voxels.labels.clone(),
            model: stage.model,
        })
    }

    /// What patterns (of each light) print, measured as `tomolith run` does.
    ///
    /// # Errors
    /// [`Error::Shape`] for patterns of another size, [`Error::NonFinite`], [`Error::Canceled`].
    pub fn evaluate(&self, patterns: &[Patterns], run: &Run) -> Result<Prediction> {
        let lights = self.lights();
        if patterns.len() != lights.len() {
            return Err(Error::Shape {
                what: "patterns of each light".to_owned(),
                expected: vec![lights.len()],
                found: vec![patterns.len()],
            });
        }
        for (patterns, light) in patterns.iter().zip(lights) {
            let [expected, found] = [&light.pixels, &patterns.grid].map(|grid| grid.shape());
            if expected != found || patterns.values.len() != patterns.grid.len() {
                return Err(Error::Shape {
                    what: "patterns [frame, row, column]".to_owned(),
                    expected: expected.to_vec(),
                    found: found.to_vec(),
                });
            }
        }
        let written = Written::of_raw(patterns.to_vec(), &self.scene)?;
        let shown = &written.shown;
        let (scene, own) = (&self.scene, &self.voxels);
        let evaluated = evaluate_patterns(scene, own, shown, None, None, &mut Silent, run)?;
        let name = |s: usize| scene.species_name(s).unwrap_or_default().to_owned();
        let others = evaluated.others.into_iter().map(|other| other.evaluation);
        let mut species = Vec::new();
        for (i, other) in others.enumerate() {
            if i == 0 {
                species.push((name(0), evaluated.evaluation.clone()));
            }
            species.push((name(i + 1), other));
        }
        let in_time = evaluated.in_time.as_ref().map(InTime::summary);
        Ok(Prediction {
            evaluation: evaluated.evaluation,
            species,
            one_exposure: evaluated.one_exposure,
            in_time: in_time.unwrap_or_default(),
        })
    }
}

impl Task {
    /// The images in a field of patterns, per light.
    #[must_use]
    pub fn patterns(&self, x: &HostField) -> Vec<Patterns> {
        crate::job::optimize::gray_levels::patterns(self.model.patterns(), x)
    }

    /// The bounds of every element of such a field.
    ///
    /// # Errors
    /// [`Error::Config`] for limits that are no range.
    pub fn bounds(&self) -> Result<Bounds> {
        problem::bounds(self.model.patterns(), &self.limits)
    }
}
