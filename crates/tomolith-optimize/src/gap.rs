//! How far a loss is from the lowest one: the certificate of a convex problem.
//!
//! **Equation** for a convex F with the gradient g at x, over patterns h within the bounds
//!
//! ```text
//! F(h) ≥ F(x) + g·(h − x) ≥ F(x) + Σ_i min( g_i·(min_i − x_i), g_i·(max_i − x_i) ) = bound
//! ```
//!
//! So no patterns do better than `bound`, whatever method looks for them. It holds at any x, and the highest one of a run counts; it nears
//! the loss as x nears an optimum. It is a bound for these voxels, this model and this largest pixel, not for the print.
//!
//! **Source** Frank and Wolfe, Naval Research Logistics Quarterly 3 (1956) 95; as a certificate: Jaggi, ICML 2013, eq. 2.
//!
//! **Limits** linear model, convex objective in the dose (identity response) and penalties, a finite largest pixel; otherwise there is no
//! bound. Gradients are f32: with |g·(h − x)| summed to G, the bound is right to about 10⁻⁶·G. **Cost** one adjoint call.

use serde::Serialize;

/// A loss, and one that no patterns go below.
#[derive(Clone, Copy, Debug, PartialEq, Serialize)]
pub struct Gap {
    /// The loss of the patterns.
    pub loss: f64,
    /// The loss that no patterns within the bounds go below.
    pub bound: f64,
}

impl Gap {
    /// How much of the loss might still go, 0 for an optimum.
    #[must_use]
    pub fn relative(&self) -> f64 {
        if self.loss <= self.bound {
            0.0
        } else {
            (self.loss - self.bound) / self.loss
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::fista::Fista;
    use crate::lbfgs::Lbfgs;
    use crate::reference::solve;
    use crate::{Counters, Limits, Optimizer, Outcome, Stop, StopReason};
    use serde_json::json;
    use std::sync::Arc;
    use tomolith_core::check::{self, small::SmallModel};
    use tomolith_core::error::Error;
    use tomolith_core::field::{Field, HostField};
    use tomolith_core::response::{Identity, Logistic};
    use tomolith_objective::Objective;
    use tomolith_objective::check::of_ring;

    const LIMITS: Limits = Limits { min: 0.0, max: 0.3 };

    fn outcome(
        model: &SmallModel,
        objective: &dyn Objective<HostField>,
        optimizer: &mut dyn Optimizer<HostField>,
        stop: &Stop,
    ) -> Result<Outcome, Error> {
        solve(model, objective, LIMITS, 0.05, optimizer, stop).1
    }

    #[test]
    fn no_method_and_no_patterns_go_below_the_bound_which_nears_the_optimum() {
        let model = SmallModel::new(18, 6, 9);
        for (name, keys, near) in [
            ("l2", json!({}), 1e-4),
            ("process_window", json!({ "outliers": 0.1 }), 0.05),
        ] {
            let objective = of_ring(&model, name, keys, Arc::new(Identity));
            let by = |iterations| {
                let mut lbfgs = Lbfgs::new(Default::default()).unwrap();
                outcome(&model, &*objective, &mut lbfgs, &Stop::after(iterations)).unwrap()
            };
            let best = by(3000).gap().unwrap();
            assert!(best.relative() < near, "{name}: {best:?}");
            for iterations in [0, 3, 30] {
                let early = by(iterations).gap().unwrap();
                assert!(
                    early.bound <= best.loss && early.loss >= best.loss,
                    "{name}: {early:?}, {best:?}"
                );
            }
            // Any patterns within the bounds
            for seed in 0..50 {
                let mut x = check::noisy_patterns(&model, seed);
                x.scale(0.15);
                x.shift(0.15);
                let loss = objective.value(&check::dose(&model, &x));
                assert!(loss > best.bound, "{name}, {seed}");
            }
        }
        // Another method ends at the same optimum
        let l2 = of_ring(&model, "l2", json!({}), Arc::new(Identity));
        let mut fista = Fista::new(Default::default()).unwrap();
        let other = outcome(&model, &*l2, &mut fista, &Stop::after(2000)).unwrap();
        let gap = other.gap().unwrap();
        assert!(gap.relative() < 1e-2, "{gap:?}");
        // The bound is looked for after the last row
        let Counters {
            model_s,
            objective_s,
            ..
        } = other.counters;
        let of_loop = other.history.last().unwrap().seconds;
        assert!(
            model_s + objective_s <= of_loop,
            "{model_s} + {objective_s} of {of_loop} s"
        );
    }

    #[test]
    fn a_run_stops_by_its_gap_and_refuses_one_that_is_not_known() {
        let model = SmallModel::new(18, 6, 9);
        let stop = Stop {
            gap: 0.5,
            ..Stop::after(3000)
        };
        let keys = json!({ "outliers": 0.1 });
        let convex = of_ring(&model, "process_window", keys, Arc::new(Identity));
        let mut lbfgs = Lbfgs::new(Default::default()).unwrap();
        let ended = outcome(&model, &*convex, &mut lbfgs, &stop).unwrap();
        let gap = ended.gap().unwrap();
        assert_eq!(ended.reason, StopReason::Gap);
        assert!(
            gap.relative() <= 0.5 && ended.history.len() < 3000,
            "{gap:?}"
        );
        let logistic = Arc::new(Logistic::new(Default::default()).unwrap());
        let curved = of_ring(&model, "l2", json!({}), logistic);
        let mut lbfgs = Lbfgs::new(Default::default()).unwrap();
        let refused = outcome(&model, &*curved, &mut lbfgs, &stop);
        assert!(matches!(refused, Err(Error::Unsupported { what, .. }) if what == "stop.gap"));
        let mut lbfgs = Lbfgs::new(Default::default()).unwrap();
        let without = outcome(&model, &*curved, &mut lbfgs, &Stop::after(5)).unwrap();
        assert_eq!(without.bound, None);
    }

    #[test]
    fn the_gap_is_relative_to_the_loss() {
        let gap_of = |bound| Gap { loss: 2.0, bound };
        assert_eq!(
            (gap_of(1.5).relative(), gap_of(2.1).relative()),
            (0.25, 0.0)
        );
    }
}
