//! Identity: the response is the dose.
//!
//! **Equation** M(d) = d, dM/dd = 1, M⁻¹(m) = m. **Parameters** none. **Cost** none: kernels skip it.
//!
//! ```
//! use tomolith_core::response::{Identity, Response};
//! assert_eq!(Identity.value_and_slope(0.3), (0.3, 1.0));
//! assert!(Identity.is_identity());
//! ```

use super::{BuildResponse, Response, ResponseForm};
use crate::kind::Kind;
use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

/// M(d) = d
#[derive(Clone, Copy, Debug, Default)]
pub struct Identity;

/// It has no parameters.
#[derive(Clone, Debug, Default, Deserialize, Serialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct Params {}

/// The row of the table.
pub const KIND: Kind<BuildResponse> = Kind {
    name: "identity",
    summary: "the response is the dose",
    example: "[response.identity]",
    schema: crate::kind::schema_of::<Params>,
    build: |section| {
        section.parse::<Params>()?;
        Ok(Box::new(Identity))
    },
};

impl Response for Identity {
    fn value(&self, dose: f32) -> f32 {
        dose
    }

    fn value_and_slope(&self, dose: f32) -> (f32, f32) {
        (dose, 1.0)
    }

    fn inverse(&self, response: f32) -> f32 {
        response
    }

    fn form(&self) -> ResponseForm<'_> {
        ResponseForm::Identity
    }
}
