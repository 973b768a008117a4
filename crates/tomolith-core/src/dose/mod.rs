//! Patterns → absorbed dose: what a model of light is, whoever computes it.
//!
//! A [`DoseModel`] is F of the one equation; a [`LinearOperator`] is a dose model whose derivative is its adjoint (rays are; coherent waves
//! are not). *Forward is the printer's direction: light goes from patterns to dose* (computed tomography calls that back-projection).
//! Layouts say which pixel and which voxel an element of a field is.

pub mod cells;
mod forward;
pub mod layout;

use crate::error::Result;
use crate::field::Field;
pub use crate::run::{Run, Steps};
pub use layout::{DoseLayout, PatternLayout, Quantity, elements_of, frames_of, own_frames};
use std::ops::Range;

/// How far along z a pattern row reaches: whether a job may be cut into z slabs.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum ZCoupling {
    /// Rows light their own heights only.
    None,
    /// Rows light heights up to this distance, mm.
    Halo(f64),
    /// No bound.
    Full,
}

/// A map from patterns to dose with its exact derivative.
///
/// Patterns of all lights lie one after the other in one field, and so do the doses of all species; the layouts say
/// where. The field layouts are the model's own; [`PatternLayout`] and [`DoseLayout`] translate to array order.
pub trait DoseModel: Send + Sync {
    /// Where the numbers live.
    type Field: Field;

    /// One per light.
    fn patterns(&self) -> &[PatternLayout];
    /// One per species.
    fn outputs(&self) -> &[DoseLayout];
    /// Dark patterns.
    ///
    /// # Errors
    /// When there is not enough memory.
    fn new_patterns(&self) -> Result<Self::Field>;
    /// Zero dose.
    ///
    /// # Errors
    /// When there is not enough memory.
    fn new_dose(&self) -> Result<Self::Field>;
    /// F(x); overwrites `dose`.
    ///
    /// # Errors
    /// [`Error::Canceled`](crate::Error::Canceled).
    fn dose(&self, x: &Self::Field, dose: &mut Self::Field, run: &Run) -> Result<()>;
    /// F′(x)ᵀ c; overwrites `grad`.
    ///
    /// # Errors
    /// [`Error::Canceled`](crate::Error::Canceled).
    fn pullback(
        &self,
        x: &Self::Field,
        cotangent: &Self::Field,
        grad: &mut Self::Field,
        run: &Run,
    ) -> Result<()>;
    /// Dose of some frames only, *added* to `dose`: printing in time, streaming, sharding by angle.
    ///
    /// # Errors
    /// [`Error::Canceled`](crate::Error::Canceled).
    fn dose_of(
        &self,
        frames: Range<usize>,
        x: &Self::Field,
        dose: &mut Self::Field,
        run: &Run,
    ) -> Result<()>;
    /// The elements of F′(x)ᵀ c that belong to some frames: *overwrites* these of `grad` and leaves all others. By default all are computed and these
    /// taken; models that know their frames take the time of these alone.
    ///
    /// # Errors
    /// As [`pullback`](Self::pullback).
    fn pullback_of(
        &self,
        frames: Range<usize>,
        x: &Self::Field,
        cotangent: &Self::Field,
        grad: &mut Self::Field,
        run: &Run,
    ) -> Result<()> {
        let mut all = grad.zeros_like();
        self.pullback(x, cotangent, &mut all, run)?;
        take_elements(self.patterns(), &frames, &all, grad);
        Ok(())
    }
    /// α ↦ F(x + α d) − F(x) as coefficient fields of α, α² … (`[F(d)]` for linear models), or None where it is no polynomial. Searches know F(x).
    ///
    /// # Errors
    /// [`Error::Canceled`](crate::Error::Canceled), or not enough memory.
    fn along(
        &self,
        x: &Self::Field,
        d: &Self::Field,
        run: &Run,
    ) -> Result<Option<Vec<Self::Field>>>;
    /// How far a row reaches along z.
    fn z_coupling(&self) -> ZCoupling;
    /// Whether F is linear, so that F(x + αd) = F(x) + αF(d): one dose call serves a whole line search.
    fn is_linear(&self) -> bool;
    /// Before the step of an iteration (the first is 1): draws other Monte Carlo paths where the model's schedule wants them, and says
    /// whether it did. It is another map then.
    fn renew(&self, _iteration: usize) -> bool {
        false
    }
    /// Whether [`renew`](Self::renew) ever does.
    fn is_renewed(&self) -> bool {
        false
    }
    /// Voxel-angle updates of one dose call after all masks: what throughput is counted in.
    fn updates(&self) -> u64;
    /// The model of light `i` alone, with one output, where the doses of the lights are computed one by one; None where they are not.
    fn of_light(&self, _i: usize) -> Option<&dyn DoseModel<Field = Self::Field>> {
        None
    }
    /// One line for people: which model, which kernel.
    fn describe(&self) -> String;
}

/// Copies the elements of some frames.
fn take_elements<F: Field>(lights: &[PatternLayout], frames: &Range<usize>, all: &F, to: &mut F) {
    let all = all.to_host();
    for (range, _) in elements_of(lights, frames) {
        to.write(range.start, &all[range]);
    }
}

/// A linear dose model; every one of them is a [`DoseModel`].
pub trait LinearOperator: Send + Sync {
    /// Where the numbers live.
    type Field: Field;

    /// One per light.
    fn patterns(&self) -> &[PatternLayout];
    /// One per species.
    fn outputs(&self) -> &[DoseLayout];
    /// Dark patterns.
    ///
    /// # Errors
    /// When there is not enough memory.
    fn new_patterns(&self) -> Result<Self::Field>;
    /// Zero dose.
    ///
    /// # Errors
    /// When there is not enough memory.
    fn new_dose(&self) -> Result<Self::Field>;
    /// dose += A x, of these frames only.
    ///
    /// # Errors
    /// [`Error::Canceled`](crate::Error::Canceled).
    fn add_forward(
        &self,
        frames: Range<usize>,
        x: &Self::Field,
        dose: &mut Self::Field,
        run: &Run,
    ) -> Result<()>;
    /// grad = Aᵀ c
    ///
    /// # Errors
    /// [`Error::Canceled`](crate::Error::Canceled).
    fn adjoint(&self, cotangent: &Self::Field, grad: &mut Self::Field, run: &Run) -> Result<()>;
    /// The elements of Aᵀ c that belong to some frames, as [`DoseModel::pullback_of`].
    ///
    /// # Errors
    /// [`Error::Canceled`](crate::Error::Canceled).
    fn adjoint_of(
        &self,
        frames: Range<usize>,
        cotangent: &Self::Field,
        grad: &mut Self::Field,
        run: &Run,
    ) -> Result<()> {
        let mut all = grad.zeros_like();
        self.adjoint(cotangent, &mut all, run)?;
        take_elements(self.patterns(), &frames, &all, grad);
        Ok(())
    }
    /// Number of frames of all lights.
    fn frames(&self) -> usize {
        frames_of(self.patterns())
    }
    /// How far a row reaches along z.
    fn z_coupling(&self) -> ZCoupling;
    /// As [`DoseModel::renew`].
    fn renew(&self, _iteration: usize) -> bool {
        false
    }
    /// As [`DoseModel::is_renewed`].
    fn is_renewed(&self) -> bool {
        false
    }
    /// Voxel-angle updates of one forward call after all masks.
    fn updates(&self) -> u64;
    /// One line for people.
    fn describe(&self) -> String;
}

impl<A: LinearOperator> DoseModel for A {
    type Field = A::Field;

    crate::forward!(LinearOperator, self => *self; patterns, outputs, new_patterns, new_dose, z_coupling, renew, is_renewed, updates, describe);

    fn dose(&self, x: &Self::Field, dose: &mut Self::Field, run: &Run) -> Result<()> {
        dose.fill(0.0);
        self.add_forward(0..self.frames(), x, dose, run)
    }

    fn pullback(
        &self,
        _x: &Self::Field,
        cotangent: &Self::Field,
        grad: &mut Self::Field,
        run: &Run,
    ) -> Result<()> {
        self.adjoint(cotangent, grad, run)
    }

    fn dose_of(
        &self,
        frames: Range<usize>,
        x: &Self::Field,
        dose: &mut Self::Field,
        run: &Run,
    ) -> Result<()> {
        self.add_forward(frames, x, dose, run)
    }

    fn pullback_of(
        &self,
        frames: Range<usize>,
        _x: &Self::Field,
        cotangent: &Self::Field,
        grad: &mut Self::Field,
        run: &Run,
    ) -> Result<()> {
        self.adjoint_of(frames, cotangent, grad, run)
    }

    fn along(
        &self,
        _x: &Self::Field,
        d: &Self::Field,
        run: &Run,
    ) -> Result<Option<Vec<Self::Field>>> {
        let mut dose = LinearOperator::new_dose(self)?;
        self.add_forward(0..self.frames(), d, &mut dose, run)?;
        Ok(Some(vec![dose]))
    }

    fn is_linear(&self) -> bool {
        true
    }
}
