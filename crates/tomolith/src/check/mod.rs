//! Public properties that every model, objective and optimiser must have.

pub mod model;
