//! What is looked at after each iteration: progress, the print now and then, and whether it is good enough.

use crate::field::{Counter, Field, HostField};
use crate::job::progress::{Event, Progress, Snapshot};
use crate::job::resolve::{ResolvedJob, Voxels};
use crate::metrics::quick::{Quick, quick, quick_of};
use crate::metrics::scan::Scan;
use crate::models::{DoseLayout, PatternLayout};
use crate::optimize::{DiskSpace, MeasuredPrint, Observer, Row, StepReport};
use std::cell::OnceCell;
use std::ops::ControlFlow;
use std::time::Instant;
use tomolith_core::parallel::table;

/// A loss that cannot fall.
const NOTHING_TO_DO: &str = "the loss of the start is 0, so nothing was optimized: either these patterns print the part already, or the objective counts no voxel; its weights, regions and bands say which";

/// What to say when no step was better than the start, whose patterns are then the result. A method that normalizes its doses
/// begins with its first step, and is idle when its loss never changes.
pub(crate) fn idle(history: &[Row], normalizes: bool, bits: Option<u32>) -> Option<String> {
    let (start, steps) = history.get(usize::from(normalizes)..)?.split_first()?;
    if steps.is_empty() && start.iteration == 0 && start.loss == 0.0 {
        return Some(NOTHING_TO_DO.to_owned());
    }
    let moves = |row: &Row| row.loss < start.loss || normalizes && row.loss != start.loss;
    if steps.is_empty() || start.loss == 0.0 || steps.iter().any(moves) {
        return None;
    }
    let why = bits.map_or_else(
        || "a shorter step or another start may help".to_owned(),
        |bits| {
            format!(
                "bounds.bits = {bits} rounds changes below half a level away: more bits or a longer step may help"
            )
        },
    );
    let what = match normalizes {
        true => "all steps have the same loss, the patterns are those of the first one",
        false => "no step lowered the loss, the patterns are those of the start",
    };
    Some(format!("{what}; {why}"))
}

/// Iterations that are measured before only every second one is, and again before every fourth, and so on.
const MEASURED: usize = 8;

/// Whether the print is measured after an iteration: the start, each up to 8, every second up to 16, every fourth up to
/// 32, …: at least ten points for any run of ten iterations, and seldom enough to cost less than 2 % of the time.
pub(crate) fn is_measured(iteration: usize) -> bool {
    let step = (iteration.saturating_sub(1) / MEASURED + 1).next_power_of_two();
    iteration.is_multiple_of(step)
}

/// Reports progress, measures the print now and then, and stops at the loss or IoU of `[stop]`.
pub(crate) struct Watch<'a, F> {
    pub(crate) job: &'a ResolvedJob,
    /// Iterations of all levels.
    pub(crate) iterations: usize,
    pub(crate) updates: u64,
    /// Layouts of the patterns of all lights, and of the doses of all species.
    pub(crate) lights: &'a [PatternLayout],
    pub(crate) doses: &'a [DoseLayout],
    /// Labels in the order of the dose field's voxels; the padding is outside.
    pub(crate) labels: Vec<u8>,
    /// Where those lie.
    pub(crate) layout: DoseLayout,
    /// What counts doses by these labels where they live, once it is needed.
    pub(crate) counter: OnceCell<Option<Box<dyn Counter<F>>>>,
    /// Of every species.
    pub(crate) voxels: &'a [Voxels],
    /// The print after the last step, where it was measured.
    pub(crate) print: Option<MeasuredPrint>,
    pub(crate) metrics_s: f64,
    pub(crate) warnings: Vec<String>,
    pub(crate) progress: &'a mut dyn Progress,
}

impl<F: Field> Watch<'_, F> {
    /// Copies for an observer that wants them.
    fn show(&mut self, report: &StepReport<'_, F>) {
        let wants = self.progress.wants();
        if !wants.any() || self.job.ranks.is_some() {
            return;
        }
        let mut patterns = Vec::new();
        if wants.patterns {
            let x = HostField::from_slice(&report.patterns.to_host());
            patterns = super::gray_levels::patterns(self.lights, &x);
        }
        let (mut dose, mut print) = (Vec::new(), Vec::new());
        let is_asked = wants.dose || wants.print;
        if let Some(whole) = is_asked.then(|| report.dose.whole().ok()).flatten() {
            let bytes = whole.host_bytes();
            let field = bytemuck::cast_slice(&bytes);
            for (species, layout) in self.job.species.iter().zip(self.doses) {
                let volume = layout.volume_of(field);
                if wants.print {
                    print.push(species.goal.responses(volume.clone()));
                }
                if wants.dose {
                    dose.push(volume);
                }
            }
        }
        let each = self.job.species.iter().zip(self.voxels);
        let each = each.filter(|_| wants.target);
        let target = each
            .map(|(species, voxels)| voxels.shown(species))
            .collect();
        self.progress.snapshot(Snapshot {
            iteration: Some(report.row.iteration),
            patterns,
            dose,
            print,
            target,
        });
    }

    fn reached(&mut self, report: &StepReport<'_, F>) -> bool {
        let stop = self.job.stop();
        let (loss, asked) = (stop.loss, stop.iou);
        let begin = Instant::now();
        self.print = self.measure(report, asked.is_some());
        self.metrics_s += begin.elapsed().as_secs_f64();
        let enough = asked
            .zip(self.print.and_then(|print| print.iou))
            .is_some_and(|(asked, iou)| iou >= asked);
        report.row.loss <= loss || enough
    }

    /// Metrics of the dose at hand: exact and always when they decide, else now and then, and over some thresholds only.
    fn measure(&self, report: &StepReport<'_, F>, decides: bool) -> Option<MeasuredPrint> {
        let iteration = report.row.iteration;
        let last = iteration == self.iterations;
        // A gray target has no IoU worth following
        let is_gray = self.voxels[0].target.gray;
        if !(decides || !is_gray && (last || is_measured(iteration))) {
            return None;
        }
        if decides {
            let whole = report.dose.whole().ok()?;
            return self.of_response(&whole, exact);
        }
        let (known, from) = report.dose.known();
        let mut found = self.quick(known)?;
        let response = &self.job.first().goal.response;
        if from > f32::NEG_INFINITY && found.lowest < response.value(from) {
            found = self.quick(&*report.dose.whole().ok()?)?;
        }
        Some(MeasuredPrint {
            iou: Some(found.iou),
            process_window: found.process_window,
        })
    }

    /// The metrics of a dose over some thresholds, counted where it lives if that is possible.
    fn quick(&self, dose: &F) -> Option<Quick> {
        let is_identity = self.job.first().goal.response.is_identity();
        let has_cells = self.layout.len() != self.layout.voxels();
        if is_identity && !has_cells {
            let counter = || dose.counter(&self.labels);
            if let Some(counter) = self.counter.get_or_init(counter) {
                return quick_of(counter.as_ref(), dose);
            }
        }
        self.of_response(dose, quick)
    }

    /// What `measure` makes of the labels and the response of each voxel.
    fn of_response<R>(&self, dose: &F, measure: impl Fn(&[u8], &[f32]) -> R) -> R {
        let response = &self.job.first().goal.response;
        let bytes = dose.host_bytes();
        let dose = self.layout.voxels_of(bytemuck::cast_slice(&bytes));
        if response.is_identity() {
            return measure(&self.labels, &dose);
        }
        measure(
            &self.labels,
            &table(dose.len(), |i| response.value(dose[i])),
        )
    }
}

/// Metrics over all thresholds.
fn exact(labels: &[u8], response: &[f32]) -> Option<MeasuredPrint> {
    let scan = Scan::new(labels, response).ok()?;
    let (part, void) = (scan.part(), scan.void());
    Some(MeasuredPrint {
        iou: scan.best_plateau().map(|plateau| plateau.iou),
        process_window: part
            .zip(void)
            .map(|(part, void)| f64::from(part.min) - f64::from(void.max)),
    })
}

impl<F: Field> Observer<F> for Watch<'_, F> {
    fn on_step(&mut self, report: &StepReport<'_, F>) -> ControlFlow<()> {
        let row = report.row;
        let calls = (row.forward + row.adjoint) as f64;
        let is_reached = self.reached(report);
        self.progress.event(&Event::Iteration {
            iteration: row.iteration,
            iterations: self.iterations,
            loss: row.loss,
            projected_gradient: report.relative_gradient,
            forward_calls: row.forward,
            adjoint_calls: row.adjoint,
            print: self.print,
            elapsed_s: row.seconds,
            updates_per_s: calls * self.updates as f64 / report.counters.model_s.max(1e-9),
        });
        self.show(report);
        if is_reached {
            ControlFlow::Break(())
        } else {
            ControlFlow::Continue(())
        }
    }

    fn print(&self) -> Option<MeasuredPrint> {
        self.print
    }

    fn on_disk_space(&mut self, space: &DiskSpace) {
        match space {
            DiskSpace::Full(error) => {
                let text = format!(
                    "no checkpoint can be written ({error}): the run goes on, but a crash or Ctrl-C would lose its work; \
                     free some disk space, and checkpoints will be written again"
                );
                self.warnings.push(text.clone());
                self.progress.event(&Event::Warning { text });
            }
            DiskSpace::FreeAgain => {
                let text = "disk space is free again: a checkpoint was written".to_owned();
                self.progress.event(&Event::Note { text });
            }
        }
    }
}
