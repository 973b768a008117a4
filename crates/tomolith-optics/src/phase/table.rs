//! A phase function that was measured or computed: a table over the angle.
//!
//! # Model
//! Values at given angles (degrees, growing from 0 to 180), linear in the cosine between them, scaled to an integral of 1.
//! With `normalized = true` the values are densities per unit of solid angle that must integrate to 1 within 1 %: a check.

use super::{BuildPhase, Phase};
use crate::random::Stream;
use schemars::JsonSchema;
use serde::{Deserialize, Serialize};
use std::f64::consts::TAU;
use tomolith_core::error::{Error, Result};
use tomolith_core::kind::{Kind, Section, schema_of};

/// See the [module page](self).
#[derive(Clone, Debug)]
pub struct PhaseTable {
    /// Cosines, growing from −1 to 1.
    cosines: Vec<f64>,
    /// Densities there.
    densities: Vec<f64>,
    /// Distribution there.
    below: Vec<f64>,
}

impl PhaseTable {
    /// A table of values over cosines that grow from −1 to 1; returns it with the integral that the values had.
    fn new(cosines: Vec<f64>, values: Vec<f64>) -> (Self, f64) {
        let mut below = vec![0.0];
        for i in 1..cosines.len() {
            let area = (cosines[i] - cosines[i - 1]) * (values[i] + values[i - 1]) / 2.0;
            below.push(below[i - 1] + area);
        }
        let total = below[below.len() - 1];
        let scaled = |v: Vec<f64>| v.into_iter().map(|v| v / total).collect();
        let table = PhaseTable {
            cosines,
            densities: scaled(values),
            below: scaled(below),
        };
        (table, total)
    }
}

impl Phase for PhaseTable {
    fn density(&self, cosine: f64) -> f64 {
        let i = self
            .cosines
            .partition_point(|&c| c < cosine)
            .clamp(1, self.cosines.len() - 1);
        let part = (cosine - self.cosines[i - 1]) / (self.cosines[i] - self.cosines[i - 1]);
        self.densities[i - 1] + part * (self.densities[i] - self.densities[i - 1])
    }

    fn draw(&self, random: &mut Stream) -> f64 {
        let xi = random.uniform();
        let i = self
            .below
            .partition_point(|&b| b < xi)
            .clamp(1, self.below.len() - 1);
        let width = self.cosines[i] - self.cosines[i - 1];
        let (a, b) = (self.densities[i - 1], self.densities[i]);
        let wanted = xi - self.below[i - 1];
        // The root of a·t + (b − a)·t²/2w = wanted that does not cancel
        let root = (a * a + 2.0 * (b - a) * wanted / width).max(0.0).sqrt();
        let t = if a + root > 0.0 {
            2.0 * wanted / (a + root)
        } else {
            0.0
        };
        (self.cosines[i - 1] + t).clamp(-1.0, 1.0)
    }
}

/// Keys of `[resin.phase.table]`.
#[derive(Clone, Debug, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct Params {
    /// Angles of scattering, degrees, growing from 0 to 180.
    pub angles_deg: Vec<f64>,
    /// One value >= 0 per angle.
    pub values: Vec<f64>,
    /// Whether the values must integrate to 1 over the sphere.
    #[serde(default)]
    pub normalized: bool,
}

/// Row of [`PHASES`](super::PHASES).
pub const KIND: Kind<BuildPhase> = Kind {
    name: "table",
    summary: "Values over the angle of scattering, measured or computed.",
    example: "[resin.phase.table]\nangles_deg = [0.0, 30.0, 90.0, 180.0]\nvalues = [1.0, 0.6, 0.1, 0.15]\n",
    schema: schema_of::<Params>,
    build,
};

fn build(section: &Section) -> Result<Box<dyn Phase>> {
    let params: Params = section.parse()?;
    let angles = &params.angles_deg;
    let grows = angles.windows(2).all(|pair| pair[0] < pair[1]);
    if angles.len() < 2 || !grows || angles[0] != 0.0 || angles[angles.len() - 1] != 180.0 {
        let accepted = "growing numbers, the first 0, the last 180";
        return Err(section.refused("angles_deg", format!("{angles:?}"), accepted));
    }
    let sound = params.values.iter().all(|v| v.is_finite() && *v >= 0.0);
    if params.values.len() != angles.len() || !sound || params.values.iter().all(|&v| v == 0.0) {
        let accepted = format!("{} numbers >= 0, not all 0", angles.len());
        return Err(section.refused("values", format!("{:?}", params.values), accepted));
    }
    let cosines = angles.iter().rev().map(|a| a.to_radians().cos()).collect();
    let (table, integral) = PhaseTable::new(cosines, params.values.iter().rev().copied().collect());
    if params.normalized && (TAU * integral - 1.0).abs() > 0.01 {
        let found = format!(
            "the values integrate to {:.4} over the sphere",
            TAU * integral
        );
        return Err(Error::config(
            format!("{}.values", section.path),
            found,
            "an integral of 1 within 1 %, or normalized = false",
        ));
    }
    Ok(Box::new(table))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_normalized_table_must_integrate_to_one_over_the_sphere() {
        let built = |value: f64| {
            let table = serde_json::json!({ "angles_deg": [0.0, 180.0], "values": [value, value], "normalized": true });
            build(&Section::new("resin.phase.table", table))
        };
        let isotropic = 1.0 / (2.0 * TAU); // 1/4π
        assert!((built(isotropic).unwrap().density(0.3) - 0.5).abs() < 1e-12);
        let text = built(2.0 * isotropic).unwrap_err().to_string();
        assert!(text.contains("integrate to 2.0000"), "{text}");
    }
}
