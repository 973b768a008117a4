//! Dose models: patterns → absorbed dose in the resin, with the exact derivative.
//!
//! *What must it do, and who does it.* A [`DoseModel`] is F of the one equation; a [`LinearOperator`] is a dose model
//! whose derivative is its adjoint (rays are; coherent waves are not). [`planner`] chooses the model of a job and says why.
//! *Forward is the printer's direction: light goes from patterns to dose* (computed tomography calls that
//! back-projection).

mod coarse;
pub mod dimmed;
pub mod matrix;
pub mod orders;
pub mod parallel;
pub mod planner;
pub mod rays;
pub mod scatter;
pub mod selection;
mod smear;
pub mod spectral;
pub mod wave;

pub use tomolith_core::dose::{
    DoseLayout, DoseModel, LinearOperator, PatternLayout, Quantity, Run, Steps, ZCoupling, cells,
    layout,
};
use tomolith_core::error::Result;
use tomolith_core::kind::{Kind, Section};

/// The dose model that a job asks for.
#[derive(Clone, Debug, Default)]
pub enum Choice {
    /// The cheapest that is exact for the optics at hand.
    #[default]
    Cheapest,
    /// Collimated light through a z-invariant vial.
    Parallel(parallel::Params),
    /// Rays of any direction through any vial.
    Rays(rays::Params),
    /// Rays in a resin that scatters.
    Scatter(scatter::Params),
    /// Scattering by successive orders.
    Orders(orders::Params),
    /// Coherent light.
    Wave(wave::Params),
    /// Rays that fill a cone, in an index-matched vial.
    Spread(wave::spread::Params),
    /// A stored matrix.
    Matrix(matrix::Params),
}

impl Choice {
    /// Whether dose is linear in the unknowns.
    #[must_use]
    pub fn is_linear(&self) -> bool {
        !matches!(self, Choice::Wave(_))
    }

    /// Whether its kernel takes neighbouring frames together, so that timing a few frames does not predict the time of many.
    #[must_use]
    pub fn joins_frames(&self) -> bool {
        !matches!(self, Choice::Wave(_) | Choice::Spread(_))
    }
}

/// Reads the parameters of a model from its section.
pub type ChooseModel = fn(&Section) -> Result<Choice>;

/// Every dose model; without one in the job the [`planner`] chooses.
pub static MODELS: &[Kind<ChooseModel>] = &[
    parallel::KIND,
    rays::KIND,
    scatter::KIND,
    orders::KIND,
    wave::KIND,
    wave::spread::KIND,
    matrix::KIND,
];
