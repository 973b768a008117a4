//! The print in time: when which frame shines ([`schedule`]), and what the resin makes of it ([`photopolymer`]).
//!
//! *What must it do, and who does it.* A material has a [`State`] on the voxels, a step through a block of time in which lights are even, the
//! step's transpose, and a readout: a volume of the state that bands, metrics and thresholds look at. [`photopolymer::Photopolymer`] has inhibitors, diffusion, curing, bleaching and shading. [`print::PrintRun`] steps a material through a
//! schedule and says what is printed when; [`printing::Printing`] is the same as a dose model, with its derivative; [`diffused::Diffused`] is the
//! linear special case of a dose that diffuses.
//!
//! Equations, units and sources: `docs/material.md`. Units are mm, s, mW, mJ.
//!
//! ```
//! use tomolith_core::grid::VolumeGrid;
//! use tomolith_material::{domain::Domain, mixing::Mixing};
//! use tomolith_material::photopolymer::{Curing, Inhibitor, Network, Params, Photopolymer};
//! // Oxygen takes the first 2 mJ/mm³, then 1 mJ/mm³ gels
//! let oxygen = Inhibitor { capacity_mj_per_mm3: 2.0, ..Inhibitor::default() };
//! let network = Network { inhibitors: vec![oxygen], ..Network::new("acrylate", Curing::threshold(1.0)) };
//! let domain = Domain::new(VolumeGrid::centered([1, 1, 1], 0.05));
//! let material = Photopolymer::new(Params::new(vec![network]), Mixing::identity(1), domain).unwrap();
//! let mut state = material.start().unwrap();
//! material.step(&mut state, &[&[2.5]], 1.0).unwrap(); // 2.5 mJ/mm³ within 1 s
//! let readout = material.readout(0);
//! assert_eq!(readout.scale * state.volumes[readout.volume].as_slice()[0], 0.5); // half the way to gel
//! ```

pub mod curves;
pub mod diffused;
pub mod diffusion;
pub mod domain;
#[cfg(test)]
mod fixtures;
pub mod frozen;
pub mod heights;
mod illumination;
mod lights;
pub mod mixing;
pub mod photopolymer;
pub mod print;
pub mod printing;
mod reaction;
pub mod schedule;
pub mod shaded;

use tomolith_core::dose::DoseModel;
use tomolith_core::field::{Field, HostField};
use tomolith_core::grid::Volume;

/// A dose model on this machine.
pub type Model = dyn DoseModel<Field = HostField>;

/// What a material remembers, on the voxels of its [domain](domain::Domain).
#[derive(Clone, Debug)]
pub struct State {
    /// Time since the start, s.
    pub seconds: f64,
    /// One volume each, in the order of the domain's layout; [`Photopolymer::volumes`](photopolymer::Photopolymer::volumes) names them.
    pub volumes: Vec<HostField>,
}

impl State {
    /// The same volumes, 0: a cotangent to add to.
    #[must_use]
    pub fn zeros_like(&self) -> Self {
        State {
            seconds: self.seconds,
            volumes: self.volumes.iter().map(Field::zeros_like).collect(),
        }
    }
}

/// What bands, metrics and thresholds look at: a volume of the state times a number.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Readout {
    /// Which volume of the state.
    pub volume: usize,
    /// The number.
    pub scale: f32,
    /// The readout at the gel point.
    pub gel: f32,
}

/// The dose that a voxel takes until it gels.
#[derive(Clone, Debug, PartialEq)]
pub struct Requirement {
    /// Dose at the gel point when nothing inhibits, mJ/mm³.
    pub dose: f64,
    /// Volumes of the starting state whose content takes dose first, and how much of it per unit, mJ/mm³.
    pub inhibitors: Vec<(usize, f64)>,
}

/// Absorption of one light in every voxel, array order `[z, y, x]`, 1/mm.
#[derive(Clone, Debug, PartialEq)]
pub struct Absorption {
    /// What makes dose.
    pub active_per_mm: Volume<f32>,
    /// What weakens light, at least as much.
    pub attenuation_per_mm: Volume<f32>,
}
