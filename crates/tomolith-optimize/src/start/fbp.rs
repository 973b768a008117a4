//! Filtered back-projection, in the printer's direction: the ramp-filtered adjoint of the wanted dose.
//!
//! **Equation** with the adjoint Fᵀ, the ramp filter R ([`filter`](crate::filter)), d = M⁻¹(target) and the absorption α(r) of the
//! active species
//!
//! ```text
//! x = c · max(R Fᵀ α⁻² d, 0)      or, negative = "offset",  x = c · (R Fᵀ α⁻² d − min R Fᵀ α⁻² d)
//! ```
//!
//! A voxel's dose is α(r) times its fluence P x: F = α P, Fᵀ = Pᵀ α. The fluence must be α⁻¹ d, and where P R Pᵀ is the identity (no
//! attenuation, SE.11) x = R Pᵀ α⁻¹ d = R Fᵀ α⁻² d (Li et al., eqs. 2 and SE.12). Where absorption is a map α is a field; else φ holds
//! it. Where nothing absorbs no light makes dose, and α⁻² is 0 (S.5.1).
//!
//! **Scale** `fit`: c makes the dose of the part right (least squares, one forward call). `analytic`: c = π/(2Nφ²)
//! (times h³/(p²q) where pixels are not as large as voxels, see [`filter`](crate::filter)), which is right before
//! negative values are cut and needs no call: the start of Li et al. φ is a voxel's share of a pixel's light; with a map, that of a voxel of the largest α,
//! which the others are relative to.
//!
//! **Source** Li et al. (2024), eqs. 2, 3 and SE.10–SE.13; with `offset` Rackson et al. (2021).
//!
//! **Parameters** see [`Params`]. **Limits** linear models only. **Cost** one adjoint and, to fit, one forward call; the filter.

use super::{BuildStart, InitialPatterns, StartInput};
use crate::filter::{Filter, Projection};
use schemars::JsonSchema;
use serde::{Deserialize, Serialize};
use tomolith_core::dose::Work;
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
    /// Window of the ramp filter: "ram_lak", "shepp_logan", "cosine", "hamming", "hann", or "none" for no filter
    pub filter: Filter,
    /// What becomes of negative values: "clip" or "offset"
    pub negative: Negative,
    /// Where the scale comes from: "fit" (the part's dose right) or "analytic" (the formula alone)
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
    fn patterns(&self, input: &StartInput<F>, work: &Work) -> Result<F> {
        input.require_linear("fbp")?;
        let wanted = input.wanted_dose()?;
        let mut x = input.model.new_patterns()?;
        let source = input.weighed(&input.over_absorption(&wanted, 2)?);
        input
            .model
            .pullback(&x.zeros_like(), &source, &mut x, work)?;
        let lights = input.model.patterns();
        let voxel_mm3 = input.model.grid().voxel_mm3();
        let fluence = input.over_absorption(&wanted, 1)?;
        let projection = Projection::filtered(x, lights, &fluence, self.0.filter, voxel_mm3)?;
        if projection.patterns.any(work.is_canceled()) {
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
            StartScale::Fit => input.scaled(x, &wanted, work),
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

    use crate::reference::{self, Dense, FREE};
    use std::sync::Arc;
    use tomolith_core::check::{self, small::SmallModel};
    use tomolith_core::dose::DoseModel;
    use tomolith_core::grid::{PatternGrid, Volume, VolumeGrid};
    use tomolith_core::near;

    use tomolith_core::target::{Target, label_voxels};
    use tomolith_models::parallel::Parallel;
    use tomolith_optics::absorption_map::AbsorptionMap;
    use tomolith_optics::light::Light;
    use tomolith_optics::resin::Resin;
    use tomolith_optics::vial::index_matched::IndexMatched;

    #[test]
    fn it_follows_the_formulas() {
        // π/(2Nφ²)·Σ 2h(i − j)·(Fᵀ T)_j, then the negative values
        for n in [15, 16] {
            let model = SmallModel::new(n, 24, 1);
            let (target, labels) = model.ring();
            let input = StartInput::new(&model, &target, &labels, &FREE);
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
                let found = Fbp(params).patterns(&input, &Work::new()).unwrap();
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
        // A smooth blob far from the edge; linear interpolation, there and back, blurs it by 3.6 %
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
        near!(dose[middle] / blob[middle], 0.964, 0.005);
    }

    /// A disc of 4 mm in a map of 0.001 per mm in its left half and another number in its right one; the patterns of the start, and the
    /// mean dose in each half, less a rim of two voxels.
    fn disc_in_halves(right: f32, scale: StartScale) -> (Vec<f32>, [f64; 2]) {
        let grid = VolumeGrid::centered([1, 64, 64], 0.1);
        let target = Target {
            name: "disc".to_owned(),
            inside: Volume::from_fn(grid.clone(), |[x, y, _]| f32::from(x.hypot(y) < 2.0)),
            gray: false,
        };
        let labels = label_voxels(&target, |[x, y, _]| x.hypot(y) < 3.2);
        let halves = vec![0.001, right, 0.001, right];
        let map = AbsorptionMap::new([1, 2, 2], 3.2, halves.clone(), halves).unwrap();
        let pixels = PatternGrid::full_turn(90, 0.0, 1, 64, 0.1);
        let light = Light {
            map: Some(Arc::new(map)),
            ..Light::new(pixels, Resin::absorbing(1.5, 0.001))
        };
        let absorption = light.absorption_on(&grid);
        let vial = IndexMatched { radius_mm: 3.2 };
        let model = Parallel::new(&vial, vec![light], grid.clone()).unwrap();
        let input = StartInput {
            absorption: absorption.as_ref(),
            ..StartInput::new(&model, &target, &labels, &FREE)
        };
        let params = Params {
            scale,
            ..Params::default()
        };
        let x = Fbp(params).patterns(&input, &Work::new()).unwrap();
        let dose = check::dose(&model, &x);
        let dose = model.outputs()[0].volume_of(dose.as_slice());
        let mean = |is_right: bool| {
            let found: Vec<f64> = (0..grid.len())
                .filter(|&i| {
                    let [x, y, _] = grid.middle(i);
                    x.hypot(y) < 1.8 && (x > 0.0) == is_right
                })
                .map(|i| f64::from(dose.values[i]))
                .collect();
            found.iter().sum::<f64>() / found.len() as f64
        };
        (x.as_slice().to_vec(), [mean(false), mean(true)])
    }

    #[test]
    fn a_disc_in_an_even_map_is_lit_by_even_beams() {
        // R of the chords 2√(a² − s²) is even within the disc and negative beside it: N frames of 1/(Nα) make its dose 1 (eq. 2)
        let (x, halves) = disc_in_halves(0.001, StartScale::Analytic);
        for column in 0..64 {
            let from_axis = (column as f64 - 31.5).abs() * 0.1;
            let mean = x.iter().skip(column).step_by(64).sum::<f32>() / 90.0;
            let lit = f64::from(mean) * 90.0 * 0.001;
            match from_axis {
                s if s < 1.9 => assert!((lit - 1.0).abs() < 0.04, "{s} mm: {lit}"),
                s if s > 2.0 => assert_eq!(lit, 0.0, "{s} mm"),
                _ => {}
            }
        }
        assert!(halves.iter().all(|d| (d - 1.0).abs() < 2e-3), "{halves:?}");
    }

    #[test]
    fn absorption_is_a_field() {
        // With α in φ alone the halves would have 0.48 and 1.75. Eq. 3 cuts negative values, which lights the right half by 0.1 more; the
        // fit shares that out
        for (scale, expected) in [
            (StartScale::Analytic, [1.0, 1.095]),
            (StartScale::Fit, [0.954, 1.047]),
        ] {
            let (_, found) = disc_in_halves(0.002, scale);
            for (found, expected) in found.iter().zip(expected) {
                assert!((found - expected).abs() < 0.01, "{scale:?}: {found}");
            }
        }
    }

    #[test]
    fn what_does_not_absorb_takes_no_light() {
        let (x, [left, right]) = disc_in_halves(0.0, StartScale::Analytic);
        assert!(x.iter().all(|v| v.is_finite()));
        assert!((left - 1.0).abs() < 0.01, "{left}");
        assert_eq!(right, 0.0);
    }
}
