//! A material without memory: dose adds up, and a scalar response follows.
//!
//! **Equation** E_s = Σ_λ M_sλ ∫q_λ dt, response M(E_s). The order of frames, pauses and powers does not matter. A [`Printing`](crate::printing::Printing) of
//! it is the dose model itself, so that today's responses keep their bits.
//!
//! ```
//! use tomolith_core::{grid::VolumeGrid, response::{Logistic, Response, logistic::Params}};
//! use tomolith_material::{Material, domain::Domain, memoryless::Memoryless, mixing::Mixing};
//! let logistic = Box::new(Logistic::new(Params::default()).unwrap());
//! let domain = Domain::new(VolumeGrid::centered([1, 1, 2], 0.1));
//! let material = Memoryless::new(Mixing::identity(1), domain, vec![logistic], 0.5).unwrap();
//! let mut state = material.start().unwrap();
//! material.step(&mut state, &[&[0.5, 0.75]], 1.0).unwrap();
//! material.step(&mut state, &[&[0.0, 0.25]], 90.0).unwrap();
//! assert_eq!(state.volumes[0].as_slice(), [0.5, 1.0]);
//! assert!((material.response(0).value(0.5) - 0.5).abs() < 1e-6);
//! ```

use crate::domain::Domain;
use crate::mixing::Mixing;
use crate::{Material, Readout, Requirement, State};
use tomolith_core::error::{Error, Result, above_zero};
use tomolith_core::field::{BLOCK, HostField};
use tomolith_core::parallel::InParallel;
use tomolith_core::response::Response;

/// See the [module page](self).
pub struct Memoryless {
    mixing: Mixing,
    domain: Domain,
    responses: Vec<Box<dyn Response>>,
    gel_dose: f64,
}

impl Memoryless {
    /// One response per network; a voxel gels at `gel_dose`, mJ/mm³ (or relative, as the doses are).
    ///
    /// # Errors
    /// [`Error::Config`] for another number of responses than networks (`response`), or a dose that is not above 0 (`gel_dose`).
    pub fn new(
        mixing: Mixing,
        domain: Domain,
        responses: Vec<Box<dyn Response>>,
        gel_dose: f64,
    ) -> Result<Self> {
        if responses.len() != mixing.species() {
            return Err(Error::config(
                "response",
                format!("{} responses", responses.len()),
                format!("{}, one for each species", mixing.species()),
            ));
        }
        above_zero("gel_dose", gel_dose)?;
        Ok(Memoryless {
            mixing,
            domain,
            responses,
            gel_dose,
        })
    }
}

/// sum += Σ_λ weight_λ·energy_λ; lights that are dark are left out.
pub(crate) fn add_mixed(weights: &[f32], absorbed: &[&[f32]], sum: &mut HostField) {
    for (&weight, energy) in weights.iter().zip(absorbed) {
        if weight == 0.0 || energy.is_empty() {
            continue;
        }
        let chunks = sum.as_mut_slice().chunks_mut(BLOCK);
        chunks.zip(energy.chunks(BLOCK)).par_each(|(sum, energy)| {
            let pairs = sum.iter_mut().zip(energy);
            if weight == 1.0 {
                pairs.for_each(|(sum, e)| *sum += e);
            } else {
                pairs.for_each(|(sum, e)| *sum += weight * e);
            }
        });
    }
}

impl Material for Memoryless {
    fn drives(&self) -> &Mixing {
        &self.mixing
    }

    fn domain(&self) -> &Domain {
        &self.domain
    }

    fn species(&self) -> Vec<String> {
        match self.mixing.species() {
            1 => vec!["dose".to_owned()],
            n => (0..n).map(|s| format!("dose_{s}")).collect(),
        }
    }

    fn volumes(&self) -> Vec<String> {
        self.species()
    }

    fn start(&self) -> Result<State> {
        let volumes = (0..self.mixing.species()).map(|_| self.domain.zeros());
        Ok(State {
            seconds: 0.0,
            volumes: volumes.collect(),
        })
    }

    fn step(&self, state: &mut State, absorbed: &[&[f32]], seconds: f64) -> Result<()> {
        for (s, dose) in state.volumes.iter_mut().enumerate() {
            add_mixed(self.mixing.row(s), absorbed, dose);
        }
        state.seconds += seconds;
        Ok(())
    }

    fn pullback_step(
        &self,
        before: &State,
        absorbed: &[&[f32]],
        _seconds: f64,
        cotangent: &mut State,
        grad: &mut [HostField],
    ) -> Result<()> {
        for (light, (grad, energy)) in grad.iter_mut().zip(absorbed).enumerate() {
            if energy.is_empty() {
                continue;
            }
            grad.as_mut_slice().fill(0.0);
            for (s, c) in cotangent.volumes.iter().enumerate() {
                add_mixed(&[self.mixing.row(s)[light]], &[c.as_slice()], grad);
            }
        }
        cotangent.seconds = before.seconds;
        Ok(())
    }

    fn readout(&self, species: usize) -> Readout {
        Readout {
            volume: species,
            scale: 1.0,
            gel: self.gel_dose as f32,
        }
    }

    fn response(&self, species: usize) -> &dyn Response {
        self.responses[species].as_ref()
    }

    fn requirement(&self, _species: usize) -> Option<Requirement> {
        Some(Requirement {
            dose: self.gel_dose,
            inhibitors: Vec::new(),
        })
    }

    fn is_memoryless(&self) -> bool {
        true
    }
}
