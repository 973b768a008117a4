//! Dose matching: the response, a sigmoid of the dose, equals the target.
//!
//! **Equation** L = Σ_v w_v·|M(d_v) − f_v|: the band [f, f] with p = q = 1.
//!
//! **Source** Bhattacharya, Toombs and Taylor, Additive Manufacturing 47 (2021) 102299; in the form of Li et al. (2024),
//! eq. 7. Their sigmoid is `[response.logistic]`; with the identity response this is [`l1`](super::least).
//!
//! **Parameters** those of [`l1`](super::least::Params). **Limits** not convex through a sigmoid. **Cost** one pass; the
//! response costs about 2 ns per voxel.

use super::least::{Params, to_power};
use super::{BuildObjective, read};
use tomolith_core::field::Field;
use tomolith_core::kind::{Kind, schema_of};

/// The row of the table.
#[must_use]
pub const fn kind<F: Field>() -> Kind<BuildObjective<F>> {
    Kind {
        name: "dose_matching",
        summary: "DM: the response (use [response.logistic]) equals the target, in absolute deviation",
        example: "[objective.dose_matching]",
        schema: schema_of::<Params>,
        build: |section| read(section, |params| to_power(1.0, params)),
    }
}
