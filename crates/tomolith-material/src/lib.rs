//! The print in time: when which frame shines ([`schedule`]), and what the resin makes of it ([`Material`]).
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
//! use tomolith_material::{Material, domain::Domain, mixing::Mixing};
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

use domain::Domain;
use mixing::Mixing;
use tomolith_core::dose::DoseModel;
use tomolith_core::error::Result;
use tomolith_core::field::{Field, HostField};
use tomolith_core::grid::Volume;

/// A dose model on this machine.
pub type Model = dyn DoseModel<Field = HostField>;

/// What a material remembers, on the voxels of its [`Domain`].
#[derive(Clone, Debug)]
pub struct State {
    /// Time since the start, s.
    pub seconds: f64,
    /// One volume each, in the order of the domain's layout; [`Material::volumes`] names them.
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

/// A resin that answers light over time.
///
/// Energies that a block of frames leaves are slices in the order of the domain's layout, mJ/mm³, one per light; an empty slice is a light that is dark.
pub trait Material: Send + Sync {
    /// Which light drives which network, and how strongly.
    fn drives(&self) -> &Mixing;
    /// The voxels.
    fn domain(&self) -> &Domain;
    /// Names of the networks, one per row of [`drives`](Self::drives).
    fn species(&self) -> Vec<String>;
    /// Names of the volumes of a state.
    fn volumes(&self) -> Vec<String>;
    /// The state before the first frame.
    ///
    /// # Errors
    /// When there is not enough memory.
    fn start(&self) -> Result<State>;
    /// What a block of time makes of the state, in which lights leave these energies, evenly over `seconds`.
    ///
    /// # Errors
    /// [`Error::Config`](tomolith_core::Error::Config) at `step_s` for a step above [`longest_step_s`](Self::longest_step_s).
    fn step(&self, state: &mut State, absorbed: &[&[f32]], seconds: f64) -> Result<()>;
    /// The transpose of the step's derivative, at the state before the step: the cotangent goes from after the step to before it, and `grad` of
    /// each light that is not dark is overwritten.
    ///
    /// # Errors
    /// As [`step`](Self::step).
    fn pullback_step(
        &self,
        before: &State,
        absorbed: &[&[f32]],
        seconds: f64,
        cotangent: &mut State,
        grad: &mut [HostField],
    ) -> Result<()>;
    /// What is looked at, per network.
    fn readout(&self, species: usize) -> Readout;
    /// The longest step that is stable, s.
    fn longest_step_s(&self) -> f64 {
        f64::INFINITY
    }
    /// The dose that gels; None where it depends on the power.
    fn requirement(&self, species: usize) -> Option<Requirement>;
    /// How a light is absorbed now; None where that never changes.
    fn absorption(&self, _state: &State, _light: usize) -> Option<Absorption> {
        None
    }
    /// The dose model of a light was made anew from [`absorption`](Self::absorption).
    fn light_was_renewed(&self, _state: &mut State, _light: usize) {}
}
