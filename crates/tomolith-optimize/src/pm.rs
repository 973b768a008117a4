//! Penalty minimization's solver: a quasi-Newton method with ten pairs within bounds.
//!
//! **Method** [L-BFGS with bounds](super::lbfgs), `memory = 10`. The penalties themselves, ρ₁, ρ₂ and the buffer zone by
//! erosion, are the objective [`pm`](tomolith_objective::pm); doses are absolute, so `bounds.max` is in their units.
//!
//! **Source** Bhattacharya, Toombs and Taylor, Additive Manufacturing 47 (2021) 102299, in the form that the VAMToolbox family
//! runs: L-BFGS-B of Byrd, Lu, Nocedal and Zhu with ten pairs on pixels between 0 and 1. Here the search is exact along the
//! feasible segment (one forward call) where theirs spends up to thirty model calls; the raw descent that Li et al. (2024),
//! section 3.2, read into the scheme is [`bclp`](super::bclp) on the objective `pm`.
//!
//! **Parameters** see [`Params`]. **Limits** as [`lbfgs`]: with p = 1 the loss never rises but the method may stop
//! early, at a kink. **Cost** as there, at most 128 bytes per pixel a step.

use super::lbfgs::{self, Lbfgs};
use super::{BuildOptimizer, MakeOptimizer, Optimizer, read};
use std::sync::Arc;
use tomolith_core::error::Result;
use tomolith_core::field::Field;
use tomolith_core::kind::{Kind, schema_of};

tomolith_core::keys! {
    /// The parameters of penalty minimization's solver.
    pub struct Params {
        /// Number of pairs remembered
        #[schemars(range(min = 1, max = 30))]
        pub memory: usize = 10,
    }
}

/// What it is called in a job.
const NAME: &str = "pm";

/// The row of the table.
#[must_use]
pub const fn kind<F: Field>() -> Kind<BuildOptimizer<F>> {
    Kind {
        name: NAME,
        summary: "penalty minimization as published: quasi-Newton with ten pairs (use [objective.pm])",
        example: "[optimizer.pm]",
        schema: schema_of::<Params>,
        build: read::<F, Params>,
    }
}

impl<F: Field> MakeOptimizer<F> for Params {
    fn make(&self) -> Result<Box<dyn Optimizer<F>>> {
        let params = lbfgs::Params {
            memory: self.memory,
            ..lbfgs::Params::default()
        };
        Ok(Box::new(Lbfgs::new(params)?.named(NAME)))
    }

    fn pairs(&self) -> Option<usize> {
        Some(self.memory)
    }

    fn with_pairs(&self, pairs: usize) -> Option<Arc<dyn MakeOptimizer<F>>> {
        Some(Arc::new(Params { memory: pairs }))
    }
}
