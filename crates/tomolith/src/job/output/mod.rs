//! The run folder: its files, the summary, patterns for another machine.

pub mod export;
pub(crate) mod files;
pub mod folder;
pub(crate) mod frames;
pub(crate) mod replace;
mod report;
pub mod summary;
