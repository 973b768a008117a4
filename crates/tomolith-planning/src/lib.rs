//! Turns measurements into the tables of a machine and a resin, a run into power, time and turns, and a printer into the voxel it can make.
//!
//! *What must it do, and who does it.* [`gray`], [`response`], [`kinetics`], [`absorbance`] and [`discs`] fit what was measured; [`delivered`] adds up the light of frames and
//! [`plan`] says how long and how bright they are to be shown; [`voxel`], [`buildup`] and [`impulse`] are formulas for a design. Published
//! measurements, with which tests work too, are in examples/calibration. Equations and worked examples are in docs/exposure.md and docs/analysis.md.

pub mod absorbance;
pub mod buildup;
pub mod delivered;
pub mod discs;
pub mod gray;
pub mod impulse;
pub mod kinetics;
pub mod measured;
pub mod plan;
pub mod quantity;
pub mod response;
pub mod voxel;
