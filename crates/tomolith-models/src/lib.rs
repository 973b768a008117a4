//! Dose models: patterns → absorbed dose in the resin, with the exact derivative.
//!
//! *What must it do, and who does it.* A [`DoseModel`] is F of the one equation. A [`ModelFamily`] says what it covers and builds models, one row
//! of [`MODELS`] each; the [`planner`] chooses the family of a job and says why.
//! *Forward is the printer's direction: light goes from patterns to dose* (computed tomography calls that
//! back-projection).

mod blurred;
mod cell_blur;
mod coarse;
mod family;
pub mod masked;
pub mod matrix;
pub mod monte_carlo;
pub mod parallel;
pub mod planner;
pub mod rays;
pub mod scenarios;
mod scene;
pub mod selection;
pub mod several;
pub mod sharded;
pub mod spectral;
pub mod successive_orders;
pub mod wave;

pub use family::{
    Capabilities, Cost, Family, HostModel, MakeFamily, ModelFamily, ModelInput, ModelKind,
    MonteCarloPaths, Purpose, Refines, TimedBy,
};
pub use scene::OpticalScene;
pub use tomolith_core::dose::{
    DoseLayout, DoseModel, PatternLayout, Quantity, Steps, Work, ZCoupling, cells, elements_of,
    frames_of, layout, own_frames,
};

/// Every family of dose models, in the order of what they cost; without one in the job the [`planner`] chooses.
pub static MODELS: &[ModelKind] = &[
    parallel::KIND,
    rays::KIND,
    successive_orders::KIND,
    monte_carlo::KIND,
    wave::KIND,
    wave::incoherent_cone::KIND,
    matrix::KIND,
];
