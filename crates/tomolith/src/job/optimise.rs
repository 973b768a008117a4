//! The optimisation of a job: from voxels to patterns.

use super::folder::RunFolder;
use super::progress::{Event, Progress};
use super::scene::{Scene, Voxels};
use super::spec::JobSpec;
use crate::error::{Error, Result};
use crate::field::{BLOCK, Field, HostField};
use crate::grid::Patterns;
use crate::io::npy::{PatternPair, write_patterns};
use crate::metrics::scan::Scan;
use crate::models::darkened::{Darkened, darken, pixels_through};
use crate::models::{DoseModel, Run, planner};
use crate::optimize::start::StartInput;
use crate::optimize::{
    self, Checkpoints, Limits, Observer, Outcome, Problem, StepReport, Stop, StopReason,
};
use rayon::prelude::*;
use std::borrow::Cow;
use std::ops::ControlFlow;
use std::path::Path;
use std::time::Instant;

/// What an optimisation came to.
pub(crate) struct Optimised {
    /// Per light, before quantisation.
    pub(crate) raw: Vec<Patterns>,
    /// Loss, history, why it ended.
    pub(crate) outcome: Outcome,
    /// Which model, and why.
    pub(crate) model: String,
    /// Voxel-angle updates of one model call.
    pub(crate) updates: u64,
    /// Metrics on the own grid, where they were measured.
    qualities: Vec<Quality>,
}

impl Optimised {
    /// The metrics after an iteration, where they were measured.
    pub(crate) fn quality_at(&self, iteration: usize) -> Option<Quality> {
        self.qualities
            .iter()
            .copied()
            .find(|q| q.iteration == iteration)
    }
}

/// Metrics after an iteration.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Quality {
    iteration: usize,
    pub(crate) iou: Option<f64>,
    pub(crate) process_window: Option<f64>,
}

/// Runs the optimiser of a job, or goes on from the checkpoint in its folder.
///
/// # Errors
/// [`Error::Cancelled`] and [`Error::NonFinite`] leave the best patterns so far in the checkpoint folder.
pub(crate) fn optimise(
    scene: &Scene,
    voxels: &Voxels,
    folder: &RunFolder,
    resume: bool,
    progress: &mut dyn Progress,
    cancel: &Run,
) -> Result<Optimised> {
    let spec = &scene.spec;
    let lights = scene.optics.lights.clone();
    let plan = planner::plan(
        scene.optics.vial.as_ref(),
        lights,
        scene.grid.clone(),
        Some(&voxels.wanted()),
        cancel,
    )?;
    progress.event(&Event::Note {
        text: plan.reason.clone(),
    });
    let dark = dark_pixels(scene, plan.model.as_ref(), progress, cancel)?;
    let model: Box<dyn DoseModel<Field = HostField>> = match &dark {
        Some(dark) => Box::new(Darkened::new(plan.model, dark)),
        None => plan.model,
    };
    let model = model.as_ref();
    let objective = scene.objective(&model.outputs()[0], voxels)?;
    let mut start = starting_patterns(scene, voxels, model, cancel)?;
    darken(&mut start, dark.as_deref().unwrap_or_default());
    let limits = limits(spec, &start);
    let mut problem = Problem::new(model, &objective, &limits, cancel)?;
    let mut optimizer = scene.optimizer()?;
    let mut checkpoints = Checkpoints::new(
        folder.checkpoint(),
        fingerprint(scene, voxels)?,
        &spec.checkpoint,
    )?;
    let mut x = if resumes(&checkpoints, resume, progress)? {
        model.new_patterns()?
    } else {
        start
    };

    let stop = Stop {
        iterations: spec.stop.iterations,
        projected_gradient: spec.stop.projected_gradient.unwrap_or(0.0),
        seconds: spec.stop.wall_s,
    };
    let updates = model.updates();
    let mut watch = Watch {
        scene,
        updates,
        labels: model.outputs()[0].field_of(&voxels.labels),
        first: None,
        qualities: Vec::new(),
        measuring_s: 0.0,
        progress,
    };
    let ran = optimize::run(
        &mut problem,
        optimizer.as_mut(),
        &mut x,
        &stop,
        Some(&mut checkpoints),
        &mut [&mut watch],
    );
    let qualities = watch.qualities;
    darken(&mut x, dark.as_deref().unwrap_or_default());
    let raw: Vec<Patterns> = model
        .patterns()
        .iter()
        .map(|layout| layout.patterns_of(x.as_slice()))
        .collect();
    match ran {
        Ok(outcome) if outcome.reason != StopReason::Cancelled => Ok(Optimised {
            raw,
            outcome,
            model: plan.reason,
            updates,
            qualities,
        }),
        stopped => {
            keep(scene, &raw, &folder.checkpoint(), progress)?;
            Err(stopped.err().unwrap_or(Error::Cancelled))
        }
    }
}

/// The pixels whose light would pass a body that is to stay dark, when there is one.
///
/// # Errors
/// [`Error::Config`] when that leaves no pixel.
fn dark_pixels(
    scene: &Scene,
    model: &dyn DoseModel<Field = HostField>,
    progress: &mut dyn Progress,
    cancel: &Run,
) -> Result<Option<Vec<bool>>> {
    let Some(places) = scene.keep_dark(&scene.grid)? else {
        return Ok(None);
    };
    let dark = pixels_through(model, &places, cancel)?;
    let (count, all) = (dark.iter().filter(|dark| **dark).count(), dark.len());
    if count == all {
        return Err(Error::config(
            "target.body",
            "every pixel that lights the part lights a keep-dark body too",
            "a keep-dark body that leaves ways for light to the part",
        ));
    }
    let share = 100.0 * count as f64 / all as f64;
    progress.event(&Event::Note {
        text: format!(
            "{share:.1} % of the pixels stay dark: their light would pass a keep-dark body"
        ),
    });
    Ok(Some(dark))
}

/// Where the optimisation begins: within the bounds that the job gives.
fn starting_patterns(
    scene: &Scene,
    voxels: &Voxels,
    model: &dyn DoseModel<Field = HostField>,
    cancel: &Run,
) -> Result<HostField> {
    let bounds = &scene.spec.bounds;
    let limits = Limits {
        min: bounds.min,
        max: bounds.max.unwrap_or(f64::INFINITY),
    };
    let response = scene.response()?;
    let input = StartInput {
        model,
        target: &voxels.target,
        labels: &voxels.labels,
        response: response.as_ref(),
        limits: &vec![limits; scene.spec.light.len()],
    };
    scene.start()?.patterns(&input, cancel)
}

/// The bounds of every light. Where the job sets no upper one it is the largest pixel of the start: without a bound a few
/// pixels at the silhouette grow far beyond all others, and the projector's grey levels are spent on them.
fn limits(spec: &JobSpec, start: &HostField) -> Vec<Limits> {
    let largest = f64::from(start.max_abs());
    let natural = if largest > spec.bounds.min {
        largest
    } else {
        f64::INFINITY
    };
    let limits = Limits {
        min: spec.bounds.min,
        max: spec.bounds.max.unwrap_or(natural),
    };
    vec![limits; spec.light.len()]
}

/// Whether there is a checkpoint to go on from; it is removed when the run is not to be resumed.
fn resumes(checkpoints: &Checkpoints, resume: bool, progress: &mut dyn Progress) -> Result<bool> {
    let file = checkpoints.file();
    if !resume {
        if file.exists() {
            std::fs::remove_file(&file).map_err(|e| Error::io(&file, e))?;
        }
        return Ok(false);
    }
    let checkpoint = checkpoints.open()?;
    let text = match &checkpoint {
        Some(checkpoint) => format!("resuming after iteration {}", checkpoint.iteration()),
        None => "no checkpoint to resume: starting anew".to_owned(),
    };
    progress.event(&Event::Note { text });
    Ok(checkpoint.is_some())
}

/// The best patterns of a run that did not end well.
fn keep(scene: &Scene, raw: &[Patterns], folder: &Path, progress: &mut dyn Progress) -> Result<()> {
    std::fs::create_dir_all(folder).map_err(|e| Error::io(folder, e))?;
    let path = folder.join("patterns.npz");
    let pairs: Vec<PatternPair<'_>> = raw
        .iter()
        .enumerate()
        .map(|(i, shown)| PatternPair {
            light: scene.light_name(i),
            shown,
            raw: None,
        })
        .collect();
    write_patterns(&path, &pairs)?;
    let text = format!(
        "the best patterns so far are in {}; `--resume` goes on from the last checkpoint",
        path.display()
    );
    progress.event(&Event::Note { text });
    Ok(())
}

/// Metrics may take this share of an optimisation's time.
const MEASURING_SHARE: f64 = 0.02;

/// Tells progress, measures the print now and then, and stops at the loss or IoU that was asked for.
struct Watch<'a> {
    scene: &'a Scene,
    updates: u64,
    /// Labels in the order of the dose field; the padding is outside.
    labels: Vec<u8>,
    /// Norm of the first projected gradient.
    first: Option<f64>,
    qualities: Vec<Quality>,
    /// Time spent on metrics.
    measuring_s: f64,
    progress: &'a mut dyn Progress,
}

impl Watch<'_> {
    fn reached(&mut self, report: &StepReport<'_, HostField>) -> bool {
        let stop = &self.scene.spec.stop;
        let (loss, asked) = (stop.loss, stop.iou);
        let quality = self.measure(report, asked.is_some());
        let enough = asked
            .zip(quality.and_then(|q| q.iou))
            .is_some_and(|(asked, iou)| iou >= asked);
        report.row.loss <= loss || enough
    }

    /// Metrics of the dose at hand: always when they decide, else as long as they cost little.
    fn measure(&mut self, report: &StepReport<'_, HostField>, always: bool) -> Option<Quality> {
        let elapsed = report.row.seconds;
        let affordable = self.measuring_s <= MEASURING_SHARE * elapsed;
        if !(always || affordable) {
            return None;
        }
        let start = Instant::now();
        let quality = self.quality(report.row.iteration, report.dose);
        self.measuring_s += start.elapsed().as_secs_f64();
        self.qualities.extend(quality);
        quality
    }

    fn quality(&self, iteration: usize, dose: &HostField) -> Option<Quality> {
        let response = self.scene.response().ok()?;
        let values: Cow<'_, [f32]> = if response.is_identity() {
            Cow::Borrowed(dose.as_slice())
        } else {
            Cow::Owned(
                dose.as_slice()
                    .par_iter()
                    .map(|&d| response.value(d))
                    .collect(),
            )
        };
        let scan = Scan::new(&self.labels, &values).ok()?;
        let (part, void) = (scan.part(), scan.void());
        Some(Quality {
            iteration,
            iou: scan.best_plateau().map(|plateau| plateau.iou),
            process_window: part
                .zip(void)
                .map(|(part, void)| f64::from(part.min) - f64::from(void.max)),
        })
    }
}

impl Observer<HostField> for Watch<'_> {
    fn on_step(&mut self, report: &StepReport<'_, HostField>) -> ControlFlow<()> {
        let row = report.row;
        if self.first.is_none() {
            self.first = row.projected_gradient;
        }
        let calls = (row.forward + row.adjoint) as f64;
        self.progress.event(&Event::Iteration {
            iteration: row.iteration,
            iterations: self.scene.spec.stop.iterations,
            loss: row.loss,
            projected_gradient: row
                .projected_gradient
                .zip(self.first)
                .map(|(now, first)| now / first),
            elapsed_s: row.seconds,
            updates_per_s: calls * self.updates as f64 / report.counters.model_s.max(1e-9),
        });
        if self.reached(report) {
            ControlFlow::Break(())
        } else {
            ControlFlow::Continue(())
        }
    }
}

/// What makes a checkpoint belong to this job: its tables but those that change no iteration, and the voxels.
fn fingerprint(scene: &Scene, voxels: &Voxels) -> Result<u64> {
    let mut tables =
        serde_json::to_value(&scene.spec).map_err(|e| Error::config("", e.to_string(), "a job"))?;
    if let Some(map) = tables.as_object_mut() {
        for unimportant in ["target", "stop", "checkpoint", "evaluate", "output"] {
            map.remove(unimportant);
        }
    }
    let labels: Vec<u64> = voxels.labels.values.par_chunks(BLOCK).map(hash).collect();
    let inside: Vec<u64> = voxels
        .target
        .inside
        .values
        .par_chunks(BLOCK)
        .map(|block| hash(bytemuck::cast_slice(block)))
        .collect();
    let parts = [
        hash(tables.to_string().as_bytes()),
        hash(bytemuck::cast_slice(&labels)),
        hash(bytemuck::cast_slice(&inside)),
    ];
    Ok(hash(bytemuck::cast_slice(&parts)))
}

/// FNV-1a, 64 bits.
fn hash(bytes: &[u8]) -> u64 {
    bytes.iter().fold(0xcbf2_9ce4_8422_2325, |h, &b| {
        (h ^ u64::from(b)).wrapping_mul(0x0000_0100_0000_01b3)
    })
}

impl Scene {
    /// Name of a light for files: none when there is only one.
    pub(crate) fn light_name(&self, i: usize) -> Option<&str> {
        if self.spec.light.len() == 1 {
            None
        } else {
            self.spec.light[i].name.as_deref()
        }
    }
}
