//! What several tests make.

use crate::Model;
use crate::diffused::Span;
use crate::domain::Domain;
use crate::mixing::Mixing;
use crate::photopolymer::{Curing, Inhibitor, Network, Params, Photopolymer};
use tomolith_core::error::{Error, Result};
use tomolith_core::field::HostField;

/// Largest difference between two fields.
pub(crate) fn apart(a: &HostField, b: &HostField) -> f32 {
    let pairs = a.as_slice().iter().zip(b.as_slice());
    pairs.map(|(a, b)| (a - b).abs()).fold(0.0, f32::max)
}

pub(crate) fn domain_of(model: &Model) -> Domain {
    Domain::new(model.grid().clone())
}

/// Oxygen of so many mJ/mm³ that diffuses, mm²/s.
pub(crate) fn oxygen(capacity: f64, diffusion: f64) -> Inhibitor {
    Inhibitor {
        capacity_mj_per_mm3: capacity,
        diffusion_mm2_per_s: diffusion,
        ..Inhibitor::default()
    }
}

/// A network that gels at a dose, mJ/mm³, once its inhibitors are used up.
pub(crate) fn network(inhibitors: Vec<Inhibitor>, dose: f64) -> Network {
    Network {
        inhibitors,
        ..Network::new("acrylate", Curing::threshold(dose))
    }
}

/// A network whose dose diffuses, mm²/s.
pub(crate) fn wandering(dose: f64, diffusion: f64) -> Network {
    Network {
        dose_diffusion_mm2_per_s: diffusion,
        ..network(Vec::new(), dose)
    }
}

pub(crate) fn photopolymer(network: Network, domain: Domain) -> Photopolymer {
    Photopolymer::new(Params::new(vec![network]), Mixing::identity(1), domain).unwrap()
}

/// Light that is even over so many seconds.
pub(crate) fn even(seconds: f64) -> Span {
    Span {
        before_s: 0.0,
        seconds,
        share: 1.0,
    }
}

/// The key that is refused, and what is accepted.
pub(crate) fn refused<T>(result: Result<T>) -> [String; 2] {
    match result {
        Err(Error::Config { key, accepted, .. }) => [key, accepted],
        Err(other) => panic!("{other}"),
        Ok(_) => panic!("it was accepted"),
    }
}
