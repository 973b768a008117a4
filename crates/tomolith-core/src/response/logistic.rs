//! Generalized logistic: induction at low dose, saturation at high dose.
//!
//! **Equation** with u = 1/(1 + e^(−B(d − M)))
//!
//! ```text
//! response  M(d)  = A + (K − A)·u^(1/ν)
//! slope     dM/dd = (K − A)·(B/ν)·u^(1/ν)·(1 − u)
//! inverse   d     = M − ln( ((K − A)/(m − A))^ν − 1 ) / B
//! ```
//!
//! **Source** Li et al., Additive Manufacturing 94 (2024) 104447, supplement, eqs. SE.16, SE.17, SE.18. Their symbols are our
//! keys: A `lower`, K `upper`, B `steepness`, M′ `midpoint`, ν `asymmetry`. The response of dose matching is this one with
//! ν = 1.
//!
//! **Parameters** see [`Params`]; doses and responses are relative. **Limits** the inverse brings a response outside
//! (A, K) to the nearest one inside, a fraction of 10⁻⁷ of K − A from either end. **Cost** about 2 ns per voxel when
//! ν = 1, several times that otherwise.
//!
//! ```
//! use tomolith_core::response::{Logistic, Response, logistic::Params};
//! let response = Logistic::new(Params::default()).unwrap();
//! assert!((response.value(0.5) - 0.5).abs() < 1e-6); // the midpoint responds halfway between 0 and 1
//! // slope there: (K − A)·B·u·(1 − u) = 10/4
//! assert!((response.value_and_slope(0.5).1 - 2.5).abs() < 1e-5);
//! ```

use super::{BuildResponse, Response, ResponseForm};
use crate::error::{Error, Result};
use crate::field::Lanes;
use crate::field::group::Group;
use crate::kind::{Kind, check_ranges};
use crate::units::exact;
use wide::{f32x8, u32x8};

crate::keys! {
    /// The parameters of a generalized logistic response.
    pub struct Params {
        /// A: response at low dose
        #[schemars(range(min = -1e9, max = 1e9))]
        pub lower: f64 = 0.0,
        /// K: response at high dose, above `lower`
        #[schemars(range(min = -1e9, max = 1e9))]
        pub upper: f64 = 1.0,
        /// B: steepness per unit of dose
        #[schemars(extend("exclusiveMinimum" = 0.0, "maximum" = 1e6))]
        pub steepness: f64 = 10.0,
        /// M: dose of the steepest slope when `asymmetry` is 1
        #[schemars(range(min = -1e9, max = 1e9))]
        pub midpoint: f64 = 0.5,
        /// ν: moves the steepest slope toward either end
        #[schemars(extend("exclusiveMinimum" = 0.0, "maximum" = 100.0))]
        pub asymmetry: f64 = 1.0,
    }
}

impl Params {
    fn validate(&self) -> Result<()> {
        check_ranges("", self)?;
        if self.lower >= self.upper {
            return Err(Error::config(
                "lower",
                format!(
                    "lower {} is not below upper {}",
                    exact(self.lower),
                    exact(self.upper)
                ),
                "lower < upper",
            ));
        }
        Ok(())
    }
}

/// A generalized logistic response.
#[derive(Clone, Debug)]
pub struct Logistic {
    params: Params,
    lower: f32,
    range: f32,
    steepness: f32,
    midpoint: f32,
    exponent: f32,
}

/// The row of the table.
pub const KIND: Kind<BuildResponse> = Kind {
    name: "logistic",
    summary: "generalized logistic curve with induction and saturation",
    example: "[response.logistic]\nsteepness = 10.0\nmidpoint = 0.5",
    schema: crate::kind::schema_of::<Params>,
    build: |section| {
        let response = Logistic::new(section.parse()?).map_err(|e| e.under(&section.path))?;
        Ok(Box::new(response))
    },
};

impl Logistic {
    /// A response with these parameters.
    ///
    /// # Errors
    /// [`Error::Config`] with the key of the first parameter that is out of range.
    #[expect(clippy::cast_possible_truncation, reason = "kernels work in f32")]
    pub fn new(params: Params) -> Result<Self> {
        params.validate()?;
        Ok(Logistic {
            lower: params.lower as f32,
            range: (params.upper - params.lower) as f32,
            steepness: params.steepness as f32,
            midpoint: params.midpoint as f32,
            exponent: (1.0 / params.asymmetry) as f32,
            params,
        })
    }

    /// u and 1 − u
    #[inline]
    fn falling(&self, dose: f32x8) -> (f32x8, f32x8) {
        let falling = exp(f32x8::splat(-self.steepness) * (dose - f32x8::splat(self.midpoint)));
        let u = f32x8::ONE / (f32x8::ONE + falling);
        // Not 1 − u, which loses the tail
        (u, falling * u)
    }

    /// M(d) and dM/dd of eight doses.
    #[inline]
    fn eight(&self, dose: f32x8) -> (f32x8, f32x8) {
        let (u, rest) = self.falling(dose);
        let height = if self.exponent == 1.0 {
            u
        } else {
            f32x8::from(u.to_array().map(|u| u.powf(self.exponent)))
        };
        let rise = f32x8::splat(self.range * self.steepness * self.exponent) * height * rest;
        (
            f32x8::splat(self.lower) + f32x8::splat(self.range) * height,
            rise,
        )
    }
}

impl Response for Logistic {
    fn value(&self, dose: f32) -> f32 {
        self.value_and_slope(dose).0
    }

    fn value_and_slope(&self, dose: f32) -> (f32, f32) {
        let (value, slope) = self.eight(f32x8::splat(dose));
        (value.to_array()[0], slope.to_array()[0])
    }

    #[expect(clippy::cast_possible_truncation, reason = "a dose is f32")]
    fn inverse(&self, response: f32) -> f32 {
        let p = &self.params;
        let height =
            ((f64::from(response) - p.lower) / (p.upper - p.lower)).clamp(1e-7, 1.0 - 1e-7);
        (p.midpoint - (height.powf(-p.asymmetry) - 1.0).ln() / p.steepness) as f32
    }

    fn form(&self) -> ResponseForm<'_> {
        ResponseForm::Logistic(&self.params)
    }

    fn range(&self) -> [f64; 2] {
        [self.params.lower, self.params.upper]
    }

    fn lanes(&self, doses: &mut Lanes, slopes: &mut Lanes) {
        let group = Group::of(&doses.0).0.map(|dose| self.eight(dose));
        *doses = Lanes(Group(group.map(|(value, _)| value)).to_array());
        *slopes = Lanes(Group(group.map(|(_, slope)| slope)).to_array());
    }
}

/// e^x for x brought into ±80, to about 10⁻⁷.
#[inline]
fn exp(x: f32x8) -> f32x8 {
    let splat = f32x8::splat;
    // Selections that let a NaN through
    let x = x.simd_gt(splat(80.0)).bitselect(splat(80.0), x);
    let x = x.simd_lt(splat(-80.0)).bitselect(splat(-80.0), x);
    // Adding 1.5·2²³ rounds to an integer, which then stands in the lowest bits of the mantissa
    let round = splat(12_582_912.0);
    let shifted = x * splat(std::f32::consts::LOG2_E) + round;
    let n = shifted - round;
    let bits: u32x8 = bytemuck::cast(shifted);
    let power: f32x8 = bytemuck::cast((bits + u32x8::splat(127)) << 23u32);
    // ln 2 in two parts, so that r is exact
    let r = (x - n * splat(0.693_359_4)) + n * splat(2.121_944_4e-4);
    let series = [720.0, 120.0, 24.0, 6.0, 2.0f32]
        .iter()
        .fold(splat(1.0 / 5040.0), |series, &k| {
            series * r + splat(1.0 / k)
        });
    power * ((series * r + f32x8::ONE) * r + f32x8::ONE)
}

#[cfg(test)]
mod tests {
    use super::super::RESPONSES;
    use super::*;
    use crate::check::refuses;
    use crate::kind::Section;
    use crate::near;
    use serde_json::json;

    #[test]
    fn only_the_product_of_steepness_and_midpoint_counts_where_doses_may_be_scaled() {
        let response_of = |steepness, midpoint| {
            let params = Params {
                steepness,
                midpoint,
                ..Params::default()
            };
            Logistic::new(params).unwrap()
        };
        // Scaled by 4, so that rounding is the same
        let (steep, other) = (response_of(10.0, 0.5), response_of(2.5, 2.0));
        for dose in [0.0f32, 0.125, 0.3, 0.5, 0.71, 1.0, 3.0] {
            assert_eq!(steep.value(dose), other.value(4.0 * dose), "{dose}");
        }
    }

    #[test]
    fn the_exponential_is_right_to_two_units_in_the_last_place() {
        let one = |x: f32| exp(f32x8::splat(x)).to_array()[0];
        for i in -7900..7900 {
            let x = i as f32 * 0.01;
            let error = f64::from(one(x)) / f64::from(x).exp() - 1.0;
            assert!(error.abs() < 2.5e-7, "exp({x}) is off by {error}");
        }
        assert!(one(f32::NAN).is_nan());
    }

    #[test]
    fn closed_forms_of_the_asymmetric_curve() {
        // ν = 2, A = 0.1, K = 0.9 at the midpoint: u = ½, M = 0.1 + 0.8/√2, slope = 0.8·(B/2)/√2·½
        let params = Params {
            lower: 0.1,
            upper: 0.9,
            steepness: 6.0,
            midpoint: 0.4,
            asymmetry: 2.0,
        };
        let response = Logistic::new(params).unwrap();
        let (value, slope) = response.value_and_slope(0.4);
        assert!((f64::from(value) - (0.1 + 0.8 / 2f64.sqrt())).abs() < 1e-6);
        assert!((f64::from(slope) - 0.8 * 3.0 / 2f64.sqrt() * 0.5).abs() < 1e-5);
        for i in 0..30 {
            let dose = i as f32 * 0.05 - 0.2;
            near!(response.inverse(response.value(dose)), dose, 1e-4);
        }
    }

    #[test]
    fn parameters_out_of_range_are_named() {
        for (key, value) in [("steepness", 0.0), ("asymmetry", -1.0), ("lower", 1.0)] {
            let section = Section::new("response", json!({ "logistic": { key: value } }));
            let key = format!("response.logistic.{key}");
            refuses(section.read(RESPONSES), &key);
        }
    }
}
