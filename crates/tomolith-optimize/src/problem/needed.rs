//! Doses where the loss may feel them.
//!
//! A search along x + α·(x̄ − x), α ∈ [0, 1], leaves out a [region](tomolith_core::dose::Regions) of voxels where neither end of the segment costs anything: there
//! the loss and its derivatives are 0 all along it. Those of x̄ are known by a bound of its dose, those of x by the dose itself or by the bound of the
//! search before. A region that is left out keeps an earlier dose, which costs nothing either; where it is needed again, F(x) is computed anew.
//! Losses, gradients and steps are those of the whole dose; sums over several steps round otherwise.

use super::{Position, Problem};
use std::borrow::Cow;
use std::time::Instant;
use tomolith_core::dose::{Quantity, Regions};
use tomolith_core::error::Result;
use tomolith_core::field::Field;
use tomolith_core::work::Work;

/// The share of a limit from which on a region stays known, and becomes known with others.
const NEAR: f32 = 0.95;
/// The share of the regions that are lit up to which leaving out the others takes less time than the whole dose.
const MOST: f64 = 0.7;
/// Where it did not, it is tried again at every so manyth dose.
const AGAIN: u64 = 8;

impl<'a, F: Field> Problem<'a, F> {
    /// The regions of the model, and from what dose on the loss may feel each; None where it feels all, or where that is not known.
    fn limited(&self) -> Option<(&'a dyn Regions<F>, &[f32])> {
        let is_plain = self.model.is_linear()
            && self.model.renewal().is_none()
            && self.model.quantity() == Quantity::Energy;
        let regions = self.model.regions().filter(|_| is_plain)?;
        let find = || {
            let limits = regions.least(&*self.objective.fixed()?.harmless()?);
            let may_be_left_out = |limit: &f32| *limit > 0.0 && limit.is_finite();
            limits.iter().any(may_be_left_out).then_some(limits)
        };
        let limits = self.limits.get_or_init(find).as_ref()?;
        Some((regions, limits))
    }

    /// F(step), where the loss may feel it on the way to x + step, over the cotangent of a position; false where too little can be left out.
    pub(super) fn needed_dose(&mut self, x: &F, step: &F, at: &mut Position<F>) -> Result<bool> {
        let Some((regions, limits)) = self.limited() else {
            return Ok(false);
        };
        let left_little = !at.unknown.is_empty() && !at.unknown.contains(&true);
        if left_little && !self.counters.forward.is_multiple_of(AGAIN) {
            return Ok(false);
        }
        let begin = Instant::now();
        at.unknown.resize(limits.len(), false);
        let bounds = regions.bounds(x, step, self.work)?;
        let mut needed = self.needed(limits, &bounds, at, regions);
        let lit = bounds
            .iter()
            .zip(&needed)
            .filter(|(bound, _)| **bound > 0.0);
        let (lit, computed) = lit.fold((0.0, 0.0), |(lit, computed), (_, needed)| {
            (lit + 1.0, computed + f64::from(u8::from(*needed)))
        });
        let is_worth_it = computed < MOST * lit;
        if !is_worth_it {
            needed.fill(true);
        }
        let missing = needed.iter().zip(&at.unknown);
        let missing: Vec<bool> = missing
            .map(|(needed, unknown)| *needed && *unknown)
            .collect();
        if missing.contains(&true) {
            regions.dose_in(&missing, x, &mut at.dose, self.work)?;
        }
        at.unknown = needed.iter().map(|needed| !needed).collect();
        if is_worth_it {
            at.cotangent.fill(0.0);
            regions.dose_in(&needed, step, &mut at.cotangent, self.work)?;
            self.counters.forward += 1;
        }
        self.counters.model_s += begin.elapsed().as_secs_f64();
        Ok(is_worth_it)
    }

    /// The regions in which something may cost on the way, from the bounds of its end.
    fn needed(
        &self,
        limits: &[f32],
        bounds: &[f32],
        at: &Position<F>,
        regions: &dyn Regions<F>,
    ) -> Vec<bool> {
        let exceeds = |i: usize, share: f32| limits[i] == 0.0 || bounds[i] > share * limits[i];
        let all = 0..limits.len();
        // What is near its limit stays known, and becomes known together with what must: it is soon needed
        let must = all.clone().any(|i| at.unknown[i] && exceeds(i, 1.0));
        let is_near = |i: usize| exceeds(i, NEAR) && (must || !at.unknown[i]);
        let mut needed: Vec<bool> = all.map(is_near).collect();
        let in_doubt = needed.iter().zip(&at.unknown);
        let in_doubt: Vec<bool> = in_doubt.map(|(near, unknown)| !near && !unknown).collect();
        let costs = regions.holds_any(&at.cotangent, &in_doubt);
        let pairs = needed.iter_mut().zip(costs);
        pairs.for_each(|(needed, costs)| *needed |= costs);
        needed
    }

    /// The dose of a position in all voxels.
    ///
    /// # Errors
    /// Those of the model, but for a request to stop.
    pub(crate) fn whole_dose<'b>(&self, x: &F, at: &'b Position<F>) -> Result<Cow<'b, F>> {
        let mut dose = Cow::Borrowed(&at.dose);
        if let Some((regions, _)) = self.limited().filter(|_| at.unknown.contains(&true)) {
            regions.dose_in(&at.unknown, x, dose.to_mut(), &Work::new())?;
        }
        Ok(dose)
    }

    /// The dose from which on that of a position is known in all voxels; those that are not known are below it.
    pub(crate) fn known_from(&self, at: &Position<F>) -> f32 {
        let limits = self.limited().map_or(&[][..], |(_, limits)| limits);
        let unknown = limits
            .iter()
            .zip(&at.unknown)
            .filter(|(_, unknown)| **unknown);
        let limits = unknown
            .map(|(limit, _)| *limit)
            .filter(|limit| limit.is_finite());
        limits.fold(f32::NEG_INFINITY, f32::max)
    }
}

#[cfg(test)]
mod tests;
