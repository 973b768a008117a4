//! What tests need to follow a method step by step: the small model as a matrix in f64, the ring, and a run that keeps every
//! iterate. Nothing here uses the code under test but the run itself.

use super::{
    Checkpoint, Limits, Memory, Optimizer, Outcome, Position, Problem, Requirements, Step,
    StepReport, Stop, read_saved_numbers, run,
};
use crate::start::StartInput;
use std::f64::consts::PI;
use std::ops::ControlFlow;
use std::sync::Arc;
use tomolith_core::check::{self, small::SmallModel};
use tomolith_core::dose::{DoseModel, Work};
use tomolith_core::error::Result;
use tomolith_core::field::{Field, HostField};
use tomolith_core::response::Identity;
use tomolith_core::target::label;
use tomolith_objective::check::of_ring;
use tomolith_objective::{Objective, Sum};

/// One slice of the small model: voxels `[y][x]`, pixels `[frame][column]`.
pub(crate) struct Dense {
    rows: Vec<Vec<(usize, f64)>>,
    pixels: usize,
    labels: Vec<u8>,
}

impl Dense {
    pub(crate) fn new(model: &SmallModel) -> Self {
        let (rows, pixels) = model.matrix();
        Dense {
            rows,
            pixels,
            labels: model.ring().1.values,
        }
    }

    pub(crate) fn forward(&self, x: &[f64]) -> Vec<f64> {
        let dose = |row: &Vec<(usize, f64)>| row.iter().map(|&(p, w)| w * x[p]).sum();
        self.rows.iter().map(dose).collect()
    }

    pub(crate) fn adjoint(&self, dose: &[f64]) -> Vec<f64> {
        let mut x = vec![0.0; self.pixels];
        for (row, d) in self.rows.iter().zip(dose) {
            row.iter().for_each(|&(p, w)| x[p] += w * d);
        }
        x
    }

    /// 1 in the part, 0 elsewhere.
    pub(crate) fn target(&self) -> Vec<f64> {
        let part = |&l: &u8| f64::from(u8::from(l == label::PART));
        self.labels.iter().map(part).collect()
    }
}

/// Rows of `columns` pixels through the band-limited ramp, term by term: 2·Σ h(i − j)·b(j).
pub(crate) fn ramp(pixels: &[f64], columns: usize) -> Vec<f64> {
    let h = |i: usize, j: usize| match i.abs_diff(j) {
        0 => 0.25,
        k if k % 2 == 1 => -1.0 / (PI * k as f64).powi(2),
        _ => 0.0,
    };
    let filtered = pixels.chunks(columns).flat_map(|row| {
        (0..columns).map(move |i| 2.0 * (0..columns).map(|j| h(i, j) * row[j]).sum::<f64>())
    });
    filtered.collect()
}

/// No bound but darkness.
pub(crate) const FREE: [Limits; 1] = [Limits {
    min: 0.0,
    max: f64::INFINITY,
}];

/// Compares with a tolerance relative to the largest expected value.
pub(crate) fn assert_near(found: &[f32], expected: &[f64], tolerance: f64, what: &str) {
    assert_eq!(found.len(), expected.len(), "{what}");
    let largest = expected.iter().fold(0.0f64, |m, v| m.max(v.abs()));
    assert!(largest > 0.0, "{what}: all expected values are 0");
    for (i, (&found, &expected)) in found.iter().zip(expected).enumerate() {
        let error = (f64::from(found) - expected).abs() / largest;
        assert!(
            error <= tolerance,
            "{what}: {found} instead of {expected} at {i}"
        );
    }
}

/// What a method makes of even patterns within limits.
pub(crate) fn solve(
    model: &Model,
    objective: &dyn Objective<HostField>,
    limits: Limits,
    even: f32,
    optimizer: &mut dyn Optimizer<HostField>,
    stop: &Stop,
) -> (HostField, Result<Outcome>) {
    let flag = Work::new();
    let mut problem = Problem::new(model, objective, &[limits], &flag).unwrap();
    let mut x = check::even_patterns(model, even);
    let outcome = run(&mut problem, optimizer, &mut x, stop, None, &mut []);
    (x, outcome)
}

/// Any model with fields of the host.
pub(crate) type Model = dyn DoseModel<Field = HostField>;

/// A method that follows a script: what its patterns are, and what loss it claims.
pub(crate) struct Scripted<S> {
    pub(crate) script: Vec<(S, f64)>,
    pub(crate) show: fn(&S, &mut Problem<HostField>, &mut HostField) -> Result<()>,
    pub(crate) normalizes: bool,
    pub(crate) done: usize,
}

impl<S: Send> Optimizer<HostField> for Scripted<S> {
    fn step(
        &mut self,
        problem: &mut Problem<HostField>,
        x: &mut HostField,
        at: &mut Position<HostField>,
    ) -> Result<Step> {
        let (shown, loss) = &self.script[self.done];
        self.done += 1;
        (self.show)(shown, problem, x)?;
        problem.evaluate(x, at)?;
        at.loss = *loss;
        Ok(Step {
            projected_gradient: 1.0,
            length: 1.0,
        })
    }

    fn requirements(&self) -> Requirements {
        Requirements::of("scripted")
    }

    fn normalizes(&self) -> bool {
        self.normalizes
    }

    fn memory(&self) -> Memory<'_> {
        Memory::of::<HostField>(self.done, &[])
    }

    fn restore(
        &mut self,
        memory: &mut Checkpoint,
        _: &Problem<HostField>,
        _: &HostField,
    ) -> Result<()> {
        self.done = read_saved_numbers(memory)?;
        Ok(())
    }
}

/// The ring on a small model.
pub(crate) struct Case {
    pub(crate) model: SmallModel,
    pub(crate) dense: Dense,
    pub(crate) n: usize,
    pub(crate) frames: usize,
}

/// A run with every iterate, the start included.
pub(crate) struct Followed {
    pub(crate) patterns: Vec<Vec<f32>>,
    pub(crate) outcome: Outcome,
}

impl Case {
    pub(crate) fn new() -> Self {
        Self::of(13, 18)
    }

    pub(crate) fn of(n: usize, frames: usize) -> Self {
        let model = SmallModel::new(n, frames, 1);
        Case {
            dense: Dense::new(&model),
            model,
            n,
            frames,
        }
    }

    /// 1 in the part, 0 in the void, −1 where a voxel does not count.
    pub(crate) fn marked_target(&self) -> Vec<f64> {
        let mark = |&l: &u8| match l {
            label::PART => 1.0,
            label::VOID => 0.0,
            _ => -1.0,
        };
        self.dense.labels.iter().map(mark).collect()
    }

    /// Whether a voxel has no neighbor of the other kind by face.
    pub(crate) fn without_neighbors_of_the_other_kind(&self) -> Vec<bool> {
        let part = self.dense.target();
        let n = self.n;
        let alone = |i: usize| {
            let (x, y) = (i % n, i / n);
            let neighbors = [
                (x > 0).then(|| i - 1),
                (x + 1 < n).then(|| i + 1),
                (y > 0).then(|| i - n),
                (y + 1 < n).then(|| i + n),
            ];
            neighbors.iter().flatten().all(|&j| part[j] == part[i])
        };
        (0..n * n).map(alone).collect()
    }

    /// Patterns that are neither uniform nor symmetric.
    pub(crate) fn start(&self) -> Vec<f64> {
        (0..self.n * self.frames)
            .map(|i| f64::from(1.0f32 + 0.5 * ((i * 7 % 11) as f32 / 11.0)))
            .collect()
    }

    pub(crate) fn objective(
        &self,
        name: &str,
        json: serde_json::Value,
    ) -> Box<dyn Objective<HostField>> {
        of_ring(&self.model, name, json, Arc::new(Identity))
    }

    pub(crate) fn weighed_objective(
        &self,
        name: &str,
        json: serde_json::Value,
        weight: f64,
    ) -> Sum<HostField> {
        Sum::new(vec![(weight, self.objective(name, json))]).unwrap()
    }

    pub(crate) fn run(
        &self,
        objective: &dyn Objective<HostField>,
        optimizer: &mut dyn Optimizer<HostField>,
        steps: usize,
        bits: Option<u32>,
    ) -> Followed {
        let (_, patterns, outcome) = self.try_run(objective, optimizer, steps, bits);
        Followed {
            patterns,
            outcome: outcome.unwrap(),
        }
    }

    /// The patterns of the result, every iterate, and the history.
    pub(crate) fn try_run(
        &self,
        objective: &dyn Objective<HostField>,
        method: &mut dyn Optimizer<HostField>,
        steps: usize,
        bits: Option<u32>,
    ) -> (HostField, Vec<Vec<f32>>, Result<Outcome>) {
        let (target, labels) = self.model.ring();
        let input = StartInput::new(&self.model, &target, &labels, &FREE);
        let flag = Work::new();
        let mut problem = Problem::new(&self.model, objective, &[Limits::default()], &flag)
            .unwrap()
            .with_bits(bits)
            .unwrap()
            .with_target(input.target_field().unwrap())
            .with_edges(input.edge_field().unwrap());
        let start: Vec<f32> = self.start().iter().map(|&v| v as f32).collect();
        let mut x = HostField::from_slice(&start);
        let (stop, mut seen) = (Stop::after(steps), Vec::new());
        let mut watch = |report: &StepReport<HostField>| {
            seen.push(report.patterns.to_host());
            ControlFlow::Continue(())
        };
        let observers = &mut [&mut watch as _];
        let outcome = run(&mut problem, method, &mut x, &stop, None, observers);
        (x, seen, outcome)
    }
}
