//! Optimizers: from a problem to patterns.
//!
//! *What must it do, and who does it.* An [`Optimizer`] improves patterns step by step; it knows a [`Problem`] (model,
//! objective, bounds) and [`Field`]s, no optics and no files. The loop around it, with stopping, history and checkpoints, is
//! [`run()`]; where it begins is [`start`].

pub mod adam;
mod alternating;
pub mod bclp;
pub mod brightness;
pub mod cal;
pub mod check;
pub mod checkpoint;
pub mod filter;
pub mod fista;
pub mod free_response;
pub mod gap;
pub mod gradient;
pub mod keep;
pub mod lbfgs;
pub mod levels;
pub mod osmo;
#[cfg(test)]
mod penalized;
pub mod pm;
pub mod problem;
#[cfg(test)]
pub(crate) mod reference;
pub mod requirements;
pub mod run;
pub mod start;

pub use checkpoint::{Checkpoint, Checkpoints, Contents, DiskSpace};
pub use free_response::{FreeParameter, FreeResponse, Respond};
pub use gap::Gap;
pub use keep::{Keep, KeptBy, KeptIterate};
pub use problem::{Counters, Limits, Position, Problem};
pub use requirements::Requirements;
pub use run::{
    MeasuredPrint, Observer, Outcome, Row, SeenDose, StepReport, Stop, StopReason,
    relative_gradient, run, run_after,
};
use schemars::JsonSchema;
use serde::Serialize;
use serde::de::DeserializeOwned;
pub use start::{InitialPatterns, STARTS, StartInput};
use std::fmt::Debug;
use std::sync::Arc;
use tomolith_core::error::{Error, Result};
use tomolith_core::field::{Field, HostField, PairsPart};
use tomolith_core::kind::{Kind, Read, Section};

/// One method of solving a problem.
///
/// What it remembers between steps, beyond the patterns and the [`Position`], is its memory: it is saved to checkpoints, and
/// a run resumed from one continues with the same bits.
pub trait Optimizer<F: Field>: Send {
    /// From x to a better x inside the bounds; `at` follows. Costs one adjoint and, with a linear model, one forward call.
    ///
    /// # Errors
    /// [`Error::Canceled`]; then x and `at` may be lost.
    fn step(&mut self, problem: &mut Problem<F>, x: &mut F, at: &mut Position<F>) -> Result<Step>;
    /// Whether no step raises the loss.
    fn is_monotone(&self) -> bool {
        false
    }
    /// What it needs of a problem: [`run()`] refuses another one before any work.
    fn requirements(&self) -> Requirements;
    /// Whether it is published with doses divided by their largest: then its patterns have that scale, it follows a rule of its
    /// own, and the loss is only reported.
    fn normalizes(&self) -> bool {
        false
    }
    /// Forgets what it has learned of curvature: the model has become another one, and the patterns stay.
    fn forget(&mut self) {}
    /// What must be saved. Between steps only.
    fn memory(&self) -> Memory<'_>;
    /// Takes back what [`memory`](Self::memory) gave; `x` shows where fields live.
    ///
    /// # Errors
    /// A sentence, when the memory is another method's or of other settings.
    fn restore(&mut self, memory: &mut Checkpoint, problem: &Problem<F>, x: &F) -> Result<()>;
}

/// What a step did.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Step {
    /// Norm of the projected gradient at the beginning of the step: ‖P(x − t·g) − x‖/t; that of the correction, for methods
    /// with a rule of their own.
    pub projected_gradient: f64,
    /// α of the feasible segment, or the step length of a fixed step; 0 when no better point was found.
    pub length: f64,
}

/// The saved memory of an optimizer: numbers and arrays.
#[derive(Default)]
pub struct Memory<'a> {
    /// Anything small.
    pub numbers: serde_json::Value,
    /// Large arrays with their names.
    pub arrays: Vec<(String, SavedArray<'a>)>,
}

/// Element type and bytes (little-endian) of a saved array.
pub struct SavedArray<'a> {
    /// What the elements are.
    pub dtype: safetensors::Dtype,
    /// How many there are.
    pub len: usize,
    /// Gives the bytes; called once, when the array is written.
    pub bytes: Box<dyn Fn() -> std::borrow::Cow<'a, [u8]> + 'a>,
}

impl<'a> Memory<'a> {
    /// Numbers, and fields with their names.
    pub fn of<F: Field>(numbers: impl Serialize, fields: &[(&str, &'a F)]) -> Self {
        let arrays = fields.iter();
        let arrays = arrays.map(|&(name, field)| (name.to_owned(), SavedArray::of_field(field)));
        Memory {
            numbers: serde_json::json!(numbers),
            arrays: arrays.collect(),
        }
    }
}

impl<'a> SavedArray<'a> {
    /// A field, as f32.
    pub fn of_field<F: Field>(field: &'a F) -> Self {
        SavedArray {
            dtype: safetensors::Dtype::F32,
            len: field.len(),
            bytes: Box::new(|| field.host_bytes()),
        }
    }

    /// Truth values, a byte each.
    pub fn of_flags(flags: &'a [bool]) -> Self {
        SavedArray {
            dtype: safetensors::Dtype::U8,
            len: flags.len(),
            bytes: Box::new(|| flags.iter().map(|flag| u8::from(*flag)).collect()),
        }
    }

    /// Bytes that it takes.
    pub fn size(&self) -> usize {
        self.len * self.dtype.bitsize() / 8
    }

    /// Bytes that only their writer understands.
    pub fn of_part(part: PairsPart<'a>) -> Self {
        SavedArray {
            dtype: safetensors::Dtype::U8,
            len: part.len,
            bytes: part.bytes,
        }
    }
}

/// Reads fields back from a saved memory, by their names.
///
/// # Errors
/// When there is no array of such a name and size.
pub fn read_saved_fields<F: Field>(
    reader: &mut Checkpoint,
    fields: &mut [(&str, &mut F)],
) -> Result<()> {
    for (name, field) in fields {
        let mut values = vec![0.0f32; field.len()];
        reader.array(name, bytemuck::cast_slice_mut(&mut values))?;
        field.copy_from_host(&values);
    }
    Ok(())
}

/// Zeros like `x`: the fields of a method that begins.
fn zeros<F: Field, const N: usize>(x: &F) -> [F; N] {
    std::array::from_fn(|_| x.zeros_like())
}

/// Reads the numbers of a saved memory.
///
/// # Errors
/// When they are those of another method.
pub fn read_saved_numbers<T: serde::de::DeserializeOwned>(reader: &Checkpoint) -> Result<T> {
    T::deserialize(reader.numbers()).map_err(|_| {
        Error::unsupported("the checkpoint", "its memory is that of another optimizer")
    })
}

/// A method with its parameters, of which a run makes an optimizer.
pub trait MakeOptimizer<F: Field = HostField>: Debug + Send + Sync {
    /// An optimizer that has not begun.
    ///
    /// # Errors
    /// [`Error::Config`] with the key of a parameter out of range; never for parameters that a row [read](BuildOptimizer).
    fn make(&self) -> Result<Box<dyn Optimizer<F>>>;
    /// How many steps it remembers as pairs of fields, where it remembers any.
    fn pairs(&self) -> Option<usize> {
        None
    }
    /// The optimizer that remembers so many pairs; None for one that remembers none.
    fn with_pairs(&self, _pairs: usize) -> Option<Arc<dyn MakeOptimizer<F>>> {
        None
    }
}

/// Reads the parameters of a method from its section.
pub type BuildOptimizer<F = HostField> = Read<Arc<dyn MakeOptimizer<F>>>;

/// The `build` of a row whose parameters are P; refuses those out of range.
fn read<F: Field, P>(section: &Section) -> Result<Arc<dyn MakeOptimizer<F>>>
where
    P: MakeOptimizer<F> + DeserializeOwned + JsonSchema + 'static,
{
    let params: P = section.parse()?;
    params.make().map_err(|e| e.under(&section.path))?;
    Ok(Arc::new(params))
}

/// Every optimizer, for patterns in host memory.
pub static OPTIMIZERS: &[Kind<BuildOptimizer>] = optimizers();

/// Every optimizer, wherever patterns live.
#[must_use]
pub const fn optimizers<F: Field>() -> &'static [Kind<BuildOptimizer<F>>] {
    const {
        &[
            lbfgs::kind(),
            gradient::kind(),
            fista::kind(),
            adam::kind(),
            osmo::kind(),
            cal::kind(),
            pm::kind(),
            bclp::kind(),
        ]
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::check;
    use serde_json::json;
    use tomolith_core::check::refuses;

    #[test]
    fn every_row_passes_the_check() {
        for row in OPTIMIZERS {
            let method = (row.build)(&tomolith_core::check::example(row)).unwrap();
            let folder = tempfile::tempdir().unwrap();
            let checked = check::optimizer(&*method, folder.path());
            checked.unwrap_or_else(|e| panic!("{}: {e}", row.name));
        }
    }

    #[test]
    fn parameters_out_of_range_are_named() {
        for (kind, json, key) in [
            ("lbfgs", json!({"memory": 0}), "memory"),
            ("lbfgs", json!({"memory": 31}), "memory"),
            ("lbfgs", json!({"tolerance": -1.0}), "tolerance"),
            ("gradient", json!({"step": 0.0}), "step"),
            ("gradient", json!({"momentum": 0.9}), "momentum"),
            ("fista", json!({"curvature": 0.0}), "curvature"),
            ("fista", json!({"step": -1.0}), "step"),
            ("adam", json!({"step": 0.0}), "step"),
            ("adam", json!({"beta_1": 1.0}), "beta_1"),
            ("osmo", json!({"inhibition": -0.1}), "inhibition"),
            ("osmo", json!({"inhibition": 1.1}), "inhibition"),
            ("cal", json!({"learning_rate": 0.0}), "learning_rate"),
            ("cal", json!({"sigmoid": -1.0}), "sigmoid"),
            ("cal", json!({"momentum": 1.0}), "momentum"),
            ("cal", json!({"filter": "ramlak"}), "filter"),
            // No step fits all units, so it must be given
            ("bclp", json!({}), "step"),
        ] {
            let section = Section::new("optimizer", json!({ kind: json }));
            let key = format!("optimizer.{kind}.{key}");
            refuses(section.read(OPTIMIZERS), &key);
        }
        // A program can give what no job can
        let lbfgs = lbfgs::Params {
            tolerance: f64::NAN,
            ..Default::default()
        };
        let osmo = osmo::Params {
            inhibition: f64::NAN,
            ..Default::default()
        };
        let made: [Result<Box<dyn Optimizer<HostField>>>; 2] = [lbfgs.make(), osmo.make()];
        assert!(made.iter().all(Result::is_err));
    }
}
