//! A target with its model, a method to be tried on it, and what is measured on the way.

use crate::clock::Clock;
use serde_json::{Value, json};
use std::ops::ControlFlow;
use std::path::Path;
use std::sync::Arc;
use tomolith::Error;
use tomolith::field::{Field, HostField};
use tomolith::grid::{PatternGrid, Patterns, Volume, VolumeGrid};
use tomolith::kind::Section;
use tomolith::metrics::published::{Options, published, value_of};
use tomolith::metrics::scan::Scan;
use tomolith::models::planner::{self, ModelPlan};
use tomolith::models::rays::Optics;
use tomolith::models::{DoseModel, OpticalScene, Purpose, Run};
use tomolith::objective::{OBJECTIVES, Objective, ObjectiveInput};
use tomolith::optics::light::Light;
use tomolith::optics::resin::Resin;
use tomolith::optics::vial::index_matched::IndexMatched;
use tomolith::optimize::start::given::Given;
use tomolith::optimize::start::{InitialPatterns, STARTS, StartInput};
use tomolith::optimize::{
    Limits, OPTIMIZERS, Outcome, Problem, PublishedScale, StepReport, Stop, run,
};
use tomolith::response::Identity;
use tomolith::target::{self, Target, TargetSpec, label, label_voxels};

/// Mean dose of the part at which doses are compared.
const MEAN: f64 = 0.9;

/// A target with its model: parallel light, no absorption, frames over half a turn.
pub(crate) struct Case {
    pub(crate) name: &'static str,
    /// `[target]` of a job.
    spec: Value,
    /// Edge of the field, mm.
    field_mm: f64,
    frames: usize,
    target: Target,
    pub(crate) labels: Volume<u8>,
    plan: ModelPlan,
}

impl Case {
    /// `shape` counts voxels \[z, y, x\]; pixels are as large.
    pub(crate) fn new(
        name: &'static str,
        spec: Value,
        field_mm: f64,
        shape: [usize; 3],
        frames: usize,
    ) -> Result<Self, Error> {
        let pixels = half_turn(frames, shape[0], shape[1], field_mm / shape[1] as f64);
        Self::with_pixels(name, spec, field_mm, shape, pixels)
    }

    /// The same case with voxels of half the size and the same pixels.
    pub(crate) fn finer(&self) -> Result<Self, Error> {
        let shape = self.labels.grid.shape;
        let fine = [
            if shape[0] == 1 { 1 } else { 2 * shape[0] },
            2 * shape[1],
            2 * shape[2],
        ];
        let pixels = half_turn(self.frames, shape[0], shape[1], self.labels.grid.pitch_mm);
        Self::with_pixels(self.name, self.spec.clone(), self.field_mm, fine, pixels)
    }

    fn with_pixels(
        name: &'static str,
        spec: Value,
        field_mm: f64,
        shape: [usize; 3],
        pixels: PatternGrid,
    ) -> Result<Self, Error> {
        let parsed: TargetSpec = Section::new("target", spec.clone()).parse()?;
        let grid = VolumeGrid::centered(shape, field_mm / shape[1] as f64);
        let solid = target::build(&parsed, Path::new("."), "target")?;
        let target = target::voxelize(solid.as_ref(), name, &grid)?;
        let labels = label_voxels(&target, |[x, y, _]| x.hypot(y) < field_mm / 2.0);
        let is_part = |&l: &u8| u8::from(l == label::PART);
        let wanted = Volume {
            grid: grid.clone(),
            values: labels.values.iter().map(is_part).collect(),
        };
        let frames = pixels.frames();
        let light = Light::new(pixels, Resin::pure_radon(1.4849));
        let vial = IndexMatched {
            radius_mm: 0.75 * field_mm,
        };
        let scene = OpticalScene {
            vial: &vial,
            optics: &[Optics::collimated(light.pixels.pitch_mm[0])],
            lights: &[light],
            solid: None,
            purpose: Purpose::Optimize,
            dose_factor: 1.0,
            trial_failed: None,
        };
        let plan = planner::plan(None, scene, &grid, Some(&wanted), &Run::new())?;
        Ok(Case {
            name,
            spec,
            field_mm,
            frames,
            target,
            labels,
            plan,
        })
    }

    /// Its size in words.
    pub(crate) fn size(&self) -> String {
        let [z, y, x] = self.labels.grid.shape;
        let part = self.labels.values.iter().filter(|&&l| l == label::PART);
        format!(
            "{z} × {y} × {x} voxels, {} in the part, {} frames over half a turn",
            part.count(),
            self.frames
        )
    }

    pub(crate) fn model(&self) -> &dyn DoseModel<Field = HostField> {
        &self.plan.model
    }

    fn objective(&self, name: &str, json: Value) -> Result<Box<dyn Objective<HostField>>, Error> {
        let input = ObjectiveInput {
            layout: &self.model().outputs()[0],
            labels: &self.labels,
            target: &self.target,
            response: Arc::new(Identity),
        };
        let objective = Section::new("objective", json!({ name: json })).read(OBJECTIVES)?;
        objective.make(&input)
    }

    fn input<'a>(&'a self, limits: &'a [Limits]) -> StartInput<'a> {
        StartInput {
            model: self.model(),
            target: &self.target,
            labels: &self.labels,
            response: &Identity,
            limits,
        }
    }

    /// The largest pixel of `[start.fbp]`.
    pub(crate) fn brightest(&self) -> Result<f64, Error> {
        let start = self.start("fbp")?;
        Ok(f64::from(
            start.as_slice().iter().copied().fold(0.0, f32::max),
        ))
    }

    fn start(&self, name: &str) -> Result<HostField, Error> {
        let start = Section::new("start", json!(name)).read(STARTS)?;
        start.patterns(&self.input(&[Limits::default()]), &Run::new())
    }

    /// Runs a method and measures where `track` wants it.
    pub(crate) fn solve(
        &self,
        method: &Method,
        start: Origin,
        largest: f64,
        track: Track,
    ) -> Result<Solved, Error> {
        let limits = [Limits {
            max: largest,
            ..Limits::default()
        }];
        let input = self.input(&limits);
        let flag = Run::new();
        let mut x = match start {
            Origin::Row(name) => self.start(name)?,
            Origin::Given(given) => given.patterns(&input, &flag)?,
        };
        let objective = self.objective(method.objective.0, method.objective.1.clone())?;
        let section = Section::new("optimizer", json!({ method.optimizer: method.params }));
        let mut optimizer = section.read(OPTIMIZERS)?.make()?;
        let mut problem = Problem::new(self.model(), objective.as_ref(), &limits, &flag)?
            .with_target(input.target_field()?);
        let stop = Stop {
            iterations: track.iterations,
            ..Stop::default()
        };
        let mut watch = Watch {
            case: self,
            track,
            clock: Clock::new(),
            samples: Vec::new(),
            losses: Vec::new(),
            converged: None,
            error: None,
        };
        let outcome = {
            let mut observer = |report: &StepReport<HostField>| watch.see(report);
            let optimizer = optimizer.as_mut();
            run(
                &mut problem,
                optimizer,
                &mut x,
                &stop,
                None,
                &mut [&mut observer],
            )?
        };
        match watch.error {
            Some(error) => Err(error),
            None => Ok(Solved {
                outcome,
                samples: watch.samples,
                converged: watch.converged,
                patterns: self.patterns_of(&x),
            }),
        }
    }

    fn patterns_of(&self, x: &HostField) -> Vec<Patterns> {
        let lights = self.model().patterns().iter();
        lights
            .map(|light| light.patterns_of(x.as_slice()))
            .collect()
    }

    /// Measures what these patterns print.
    pub(crate) fn quality_of(&self, patterns: Vec<Patterns>) -> Result<Quality, Error> {
        let limits = [Limits::default()];
        let x = Given(patterns).patterns(&self.input(&limits), &Run::new())?;
        let mut dose = self.model().new_dose()?;
        self.model().dose(&x, &mut dose, &Run::new())?;
        self.measure(&mut dose)
    }

    #[expect(clippy::cast_possible_truncation, reason = "doses are f32")]
    fn measure(&self, dose: &mut HostField) -> Result<Quality, Error> {
        let layout = &self.model().outputs()[0];
        let labels = layout.field_of(&self.labels);
        let nothing = |what| Error::config(what, "none", "some");
        let scale = PublishedScale::of(dose.as_slice(), &labels).ok_or_else(|| nothing("dose"))?;
        let own = Window::of(&labels, dose)?;
        dose.scale(scale.at_mean(1.0, MEAN) as f32);
        let scan = Scan::new(&labels, dose.as_slice())?;
        Ok(Quality {
            loss: self.objective("ospw", json!({}))?.value(dose),
            own,
            common: Window::of(&labels, dose)?,
            iou: scan.best_plateau().map_or(0.0, |p| p.iou),
            largest: scale.largest,
            part_mean: scale.part_mean,
        })
    }

    /// PW and IPDR without 0.05 % of each region, as in figure 14 of Pellizzon et al.
    pub(crate) fn trimmed(&self, patterns: Vec<Patterns>) -> Result<Window, Error> {
        let limits = [Limits::default()];
        let x = Given(patterns).patterns(&self.input(&limits), &Run::new())?;
        let mut dose = self.model().new_dose()?;
        self.model().dose(&x, &mut dose, &Run::new())?;
        let dose = self.model().outputs()[0].volume_of(dose.as_slice());
        let numbers = published(
            &dose,
            &self.target.inside,
            &self.labels,
            &Options::default(),
        )?;
        let of = |name| value_of(&numbers, name).unwrap_or(f64::NAN);
        Ok(Window {
            pw: of("pw_trimmed"),
            ipdr: of("ipdr_trimmed"),
        })
    }

    /// 1/L for squared bands, 1/(2·‖F‖²), by power iteration.
    #[expect(clippy::cast_possible_truncation, reason = "fields are f32")]
    pub(crate) fn longest_step(&self) -> Result<f64, Error> {
        let (run, model) = (Run::new(), self.model());
        let (mut x, mut dose) = (model.new_patterns()?, model.new_dose()?);
        x.fill(1.0);
        let mut square = 0.0;
        for _ in 0..10 {
            let norm = x.norm();
            x.scale((1.0 / norm) as f32);
            model.dose(&x, &mut dose, &run)?;
            let mut next = x.zeros_like();
            model.pullback(&x, &dose, &mut next, &run)?;
            square = next.norm();
            x = next;
        }
        Ok(0.5 / square)
    }
}

/// Frames over half a turn: with parallel light and no absorption the other half sends the same rays again.
fn half_turn(frames: usize, rows: usize, columns: usize, pitch_mm: f64) -> PatternGrid {
    let mut pixels = PatternGrid::full_turn(2 * frames, 0.0, rows, columns, pitch_mm);
    pixels.azimuths.truncate(frames);
    pixels
}

/// Where a run begins.
#[derive(Clone, Copy)]
pub(crate) enum Origin<'a> {
    Row(&'static str),
    Given(&'a Given),
}

/// What is run, with its own objective.
pub(crate) struct Method {
    pub(crate) name: String,
    pub(crate) optimizer: &'static str,
    pub(crate) params: Value,
    pub(crate) objective: (&'static str, Value),
}

impl Method {
    pub(crate) fn new(
        name: impl Into<String>,
        (optimizer, params): (&'static str, Value),
        objective: (&'static str, Value),
    ) -> Self {
        Method {
            name: name.into(),
            optimizer,
            params,
            objective,
        }
    }
}

/// When to measure, and when to stop.
#[derive(Clone, Default)]
pub(crate) struct Track {
    pub(crate) iterations: usize,
    /// Stop at this many model calls, dose and adjoint together.
    pub(crate) calls: Option<u64>,
    /// Measure at the first step with at least so many model calls.
    pub(crate) marks: Vec<u64>,
    /// Measure after these steps.
    pub(crate) steps: Vec<usize>,
    /// Measure when eq. 28 of Li et al. holds with this number, and stop there once all marks are behind.
    pub(crate) change: f64,
}

/// What came of a run.
pub(crate) struct Solved {
    pub(crate) outcome: Outcome,
    /// In the order of the marks; the last step is the last entry.
    pub(crate) samples: Vec<Sample>,
    pub(crate) converged: Option<Sample>,
    pub(crate) patterns: Vec<Patterns>,
}

/// A moment of a run.
#[derive(Clone, Copy)]
pub(crate) struct Sample {
    pub(crate) iteration: usize,
    pub(crate) calls: u64,
    /// Processor seconds of all threads, measuring left out.
    pub(crate) seconds: f64,
    pub(crate) quality: Quality,
}

/// Numbers of a dose; all but `own` and `largest` at a mean part dose of 0.9.
#[derive(Clone, Copy)]
pub(crate) struct Quality {
    /// OSPW(0) at (0.70, 0.90).
    pub(crate) loss: f64,
    /// At the scale at which the method is published.
    pub(crate) own: Window,
    pub(crate) common: Window,
    pub(crate) iou: f64,
    pub(crate) largest: f64,
    pub(crate) part_mean: f64,
}

/// Process window and in-part dose range, eqs. 10 and 11 of Pellizzon et al.
#[derive(Clone, Copy)]
pub(crate) struct Window {
    pub(crate) pw: f64,
    pub(crate) ipdr: f64,
}

impl Window {
    fn of(labels: &[u8], dose: &HostField) -> Result<Self, Error> {
        let scan = Scan::new(labels, dose.as_slice())?;
        let both = scan.part().zip(scan.void());
        let (part, void) = both.ok_or_else(|| Error::config("target", "one region", "two"))?;
        Ok(Window {
            pw: f64::from(part.min) - f64::from(void.max),
            ipdr: f64::from(part.max) - f64::from(part.min),
        })
    }
}

/// Watches a run.
struct Watch<'a> {
    case: &'a Case,
    track: Track,
    clock: Clock,
    samples: Vec<Sample>,
    losses: Vec<f64>,
    converged: Option<Sample>,
    error: Option<Error>,
}

impl Watch<'_> {
    fn see(&mut self, report: &StepReport<HostField>) -> ControlFlow<()> {
        let seconds = self.clock.pause();
        let row = report.row;
        let calls = row.forward + row.adjoint;
        self.losses.push(row.loss);
        let over = row.iteration >= self.track.iterations
            || self.track.calls.is_some_and(|limit| calls >= limit);
        let steady = self.converged.is_none() && self.is_steady();
        let marked = self.track.marks.iter().any(|&mark| calls >= mark)
            || self.track.steps.contains(&row.iteration);
        let mut ends = over;
        if (marked || over || steady) && row.iteration > 0 {
            match self.case.measure(&mut report.dose.clone()) {
                Ok(quality) => {
                    let sample = Sample {
                        iteration: row.iteration,
                        calls,
                        seconds,
                        quality,
                    };
                    if marked || over {
                        self.samples.push(sample);
                        self.track.marks.retain(|&mark| mark > calls);
                    }
                    if steady {
                        self.converged = Some(sample);
                    }
                }
                Err(error) => {
                    self.error = Some(error);
                    ends = true;
                }
            }
        }
        let behind = self.track.steps.iter().all(|&step| step <= row.iteration);
        ends |= self.converged.is_some() && self.track.marks.is_empty() && behind;
        self.clock.resume();
        if ends {
            ControlFlow::Break(())
        } else {
            ControlFlow::Continue(())
        }
    }

    /// Whether the mean change of the last five steps is small, eq. 28 of Li et al.
    fn is_steady(&self) -> bool {
        let Some(last) = self.losses.len().checked_sub(6) else {
            return false;
        };
        let changes = self.losses[last..].windows(2).map(|p| (p[1] - p[0]).abs());
        let newest = self.losses[self.losses.len() - 1];
        changes.sum::<f64>() / 5.0 <= self.track.change * newest
    }
}
