//! Several models that act as one: what a sum over lights ([`spectral`](super::spectral)) and the same light under several scenarios
//! ([`scenarios`](super::scenarios)) have in common.
//!
//! Each model has patterns and a dose of its own; `own` gives the former from the joint patterns, `add` brings the latter to the joint dose.

use crate::{DoseModel, Run, ZCoupling};
use std::ops::Deref;
use tomolith_core::error::Result;
use tomolith_core::field::HostField;

/// Whoever holds a model.
pub(crate) trait Holds: Deref<Target = dyn DoseModel<Field = HostField>> {}

impl<P: Deref<Target = dyn DoseModel<Field = HostField>>> Holds for P {}

/// The part of a run that one of the models has.
pub(crate) fn part(models: &[impl Holds], run: &Run) -> Run {
    run.part(1.0 / models.len() as f64)
}

/// The coupling that reaches farthest.
pub(crate) fn z_coupling(models: &[impl Holds]) -> ZCoupling {
    let reach = |coupling: ZCoupling| match coupling {
        ZCoupling::None => 0.0,
        ZCoupling::Halo(mm) => mm,
        ZCoupling::Full => f64::INFINITY,
    };
    let reaches = models.iter().map(|model| reach(model.z_coupling()));
    match reaches.fold(0.0, f64::max) {
        0.0 => ZCoupling::None,
        mm if mm.is_finite() => ZCoupling::Halo(mm),
        _ => ZCoupling::Full,
    }
}

/// Whether all are linear.
pub(crate) fn is_linear(models: &[impl Holds]) -> bool {
    models.iter().all(|model| model.is_linear())
}

/// Whether any becomes another map on the way.
pub(crate) fn is_renewed(models: &[impl Holds]) -> bool {
    models.iter().any(|model| model.is_renewed())
}

/// Updates of a dose of all.
pub(crate) fn updates(models: &[impl Holds]) -> u64 {
    models.iter().map(|model| model.updates()).sum()
}

/// Lets every model become another map; whether any did.
pub(crate) fn renew(
    models: &[impl Holds],
    iteration: usize,
    own: impl Fn(usize) -> Result<HostField>,
    run: &Run,
) -> Result<bool> {
    let mut any = false;
    for (k, model) in models.iter().enumerate() {
        any |= model.renew(iteration, &own(k)?, run)?;
    }
    Ok(any)
}

/// The joint dose along a step, power by power; None where one of the models has none.
pub(crate) fn along(
    models: &[impl Holds],
    own: impl Fn(usize) -> Result<[HostField; 2]>,
    new_dose: impl Fn() -> Result<HostField>,
    add: impl Fn(usize, &HostField, &mut HostField),
    run: &Run,
) -> Result<Option<Vec<HostField>>> {
    let mut all: Vec<HostField> = Vec::new();
    for (k, model) in models.iter().enumerate() {
        let [x, d] = own(k)?;
        let Some(powers) = model.along(&x, &d, run)? else {
            return Ok(None);
        };
        for (power, q) in powers.iter().enumerate() {
            if power == all.len() {
                all.push(new_dose()?);
            }
            add(k, q, &mut all[power]);
        }
    }
    Ok(Some(all))
}
