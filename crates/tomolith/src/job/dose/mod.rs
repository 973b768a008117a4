//! Doses of patterns: models on given voxels, patterns as the machine shows them, processes that share frames.

pub mod cache;
pub(crate) mod cross_check;
pub(crate) mod doses;
pub(crate) mod in_time;
pub(crate) mod model_probe;
pub(crate) mod ranks;
pub(crate) mod scenarios;
pub(crate) mod species;
pub(crate) mod written;
