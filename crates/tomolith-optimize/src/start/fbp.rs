//! Filtered back-projection, in the printer's direction: the ramp-filtered adjoint of the wanted dose.
//!
//! **Equation** with the adjoint Fᵀ, the ramp filter R ([`filter`](crate::filter)) and d = M⁻¹(target)
//!
//! ```text
//! x = c · max(R Fᵀ d, 0)          or, negative = "offset",  x = c · (R Fᵀ d − min R Fᵀ d)
//! ```
//!
//! **Scale** `fit`: c makes the dose of the part right (least squares, one forward call). `analytic`: c = π/(2Nφ²)
//! (times h³/(p²q) where pixels are not as large as voxels, see [`filter`](crate::filter)), which is right before
//! negative values are cut and needs no call: the start of Li et al., their α⁻² being in φ.
//!
//! **Source** Li et al. (2024), eqs. 2, 3 and SE.10–SE.13; with `offset` Rackson et al. (2021).
//!
//! **Parameters** see [`Params`]. **Limits** linear models only. **Cost** one adjoint and, to fit, one forward call; the filter.
//!
//! ```
//! use tomolith_core::kind::Section;
//! use tomolith_optimize::STARTS;
//! let row = STARTS.iter().find(|row| row.name == "fbp").unwrap();
//! let section = Section::new("start.fbp", serde_json::json!({"filter": "hann", "scale": "analytic"}));
//! assert!((row.build)(&section).is_ok());
//! ```

use super::{BuildStart, InitialPatterns, StartInput};
use crate::filter::{Filter, Projection};
use schemars::JsonSchema;
use serde::{Deserialize, Serialize};
use tomolith_core::dose::Run;
use tomolith_core::error::{Error, Result};
use tomolith_core::field::Field;
use tomolith_core::kind::{Kind, schema_of};

/// What becomes of negative values.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Deserialize, Serialize, JsonSchema)]
#[serde(rename_all = "snake_case")]
pub enum Negative {
    /// They become 0.
    #[default]
    Clip,
    /// All values are raised until the smallest is 0.
    Offset,
}

/// Where the factor c comes from.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Deserialize, Serialize, JsonSchema)]
#[serde(rename_all = "snake_case")]
pub enum StartScale {
    /// Least squares between the dose of the part and the wanted one.
    #[default]
    Fit,
    /// The formula of the inversion, before negative values are cut.
    Analytic,
}

/// The parameters of filtered back-projection.
#[derive(Clone, Debug, Default, Deserialize, Serialize, JsonSchema)]
#[serde(default, deny_unknown_fields)]
pub struct Params {
    /// Window of the ramp filter: "ram_lak" (default), "shepp_logan", "cosine", "hamming", "hann", or "none" for no filter
    pub filter: Filter,
    /// What becomes of negative values: "clip" (default) or "offset"
    pub negative: Negative,
    /// Where the scale comes from: "fit" (default, the part's dose right) or "analytic" (the formula alone)
    pub scale: StartScale,
}

/// Filtered back-projection.
#[derive(Clone, Debug)]
pub struct Fbp(pub Params);

/// The row of the table.
#[must_use]
pub const fn kind<F: Field>() -> Kind<BuildStart<F>> {
    Kind {
        name: "fbp",
        summary: "filtered back-projection: the ramp-filtered adjoint of the target",
        example: "[start.fbp]\nfilter = \"ram_lak\"\nnegative = \"clip\"",
        schema: schema_of::<Params>,
        build: |section| Ok(Box::new(Fbp(section.parse()?))),
    }
}

impl<F: Field> InitialPatterns<F> for Fbp {
    #[expect(clippy::cast_possible_truncation, reason = "fields are f32")]
    fn patterns(&self, input: &StartInput<F>, run: &Run) -> Result<F> {
        input.require_linear("fbp")?;
        let wanted = input.wanted_dose()?;
        let mut x = input.model.new_patterns()?;
        input
            .model
            .pullback(&x.zeros_like(), &input.weighed(&wanted), &mut x, run)?;
        let lights = input.model.patterns();
        let voxel_mm3 = input.model.grid().voxel_mm3();
        let projection =
            Projection::new(x, lights, &wanted)?.filtered(lights, self.0.filter, voxel_mm3)?;
        if projection.patterns.any(run.is_canceled()) {
            return Err(Error::Canceled);
        }
        let inverse = projection.inverse() as f32;
        let mut x = projection.patterns;
        let lowest = match self.0.negative {
            Negative::Clip => 0.0,
            Negative::Offset => x.lowest(),
        };
        x.shift(-lowest);
        x.clamp(0.0, f32::INFINITY);
        match self.0.scale {
            StartScale::Fit => input.scaled(x, &wanted, run),
            StartScale::Analytic => {
                x.scale(inverse);
                input.bounded(x)
            }
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::Limits;
    use crate::reference::{self, Dense};
    use tomolith_core::check::small::SmallModel;
    use tomolith_core::response::Identity;

    #[test]
    fn it_follows_the_formulas() {
        // π/(2Nφ²)·Σ 2h(i − j)·(Fᵀ T)_j, then the negative values
        for n in [15, 16] {
            let model = SmallModel::new(n, 24, 1);
            let (target, labels) = model.ring();
            let input = StartInput {
                model: &model,
                target: &target,
                labels: &labels,
                response: &Identity,
                limits: &[Limits::default()],
            };
            let dense = Dense::new(&model);
            let wanted = dense.target();
            let projection = dense.adjoint(&wanted);
            let share = projection.iter().sum::<f64>() / wanted.iter().sum::<f64>() / 24.0;
            let factor = std::f64::consts::PI / (2.0 * 24.0 * share * share);
            let rows = reference::ramp(&projection, n);
            for (negative, lowest) in [
                (Negative::Clip, 0.0),
                (Negative::Offset, rows.iter().copied().fold(0.0, f64::min)),
            ] {
                let params = Params {
                    negative,
                    scale: StartScale::Analytic,
                    ..Params::default()
                };
                let found = Fbp(params).patterns(&input, &Run::new()).unwrap();
                let expected: Vec<f64> = rows
                    .iter()
                    .map(|v| factor * (v - lowest).max(0.0))
                    .collect();
                reference::assert_near(found.as_slice(), &expected, 1e-5, "fbp");
            }
        }
    }

    #[test]
    fn uncut_it_inverts_the_model() {
        // A smooth blob far from the edge; linear interpolation, there and back, blurs it by a few per cent
        let model = SmallModel::new(48, 96, 1);
        let dense = Dense::new(&model);
        let n = 48;
        let blob: Vec<f64> = (0..n * n)
            .map(|i| {
                let (x, y) = ((i % n) as f64 - 23.5, (i / n) as f64 - 23.5);
                (-(x * x + y * y) / 32.0).exp()
            })
            .collect();
        let rows = reference::ramp(&dense.adjoint(&blob), n);
        let factor = std::f64::consts::PI * 96.0 / 2.0;
        let x: Vec<f64> = rows.iter().map(|v| factor * v).collect();
        let dose = dense.forward(&x);
        let middle = 24 * n + 24;
        assert!(
            (dose[middle] / blob[middle] - 1.0).abs() < 0.05,
            "{} for {}",
            dose[middle],
            blob[middle]
        );
    }
}
