//! Where the light of a job goes, before any work: some rays of every light, and what becomes of their power.

use super::optics::Optics;
use crate::error::{Error, Result};
use crate::grid::{PatternGrid, VolumeGrid};
use crate::optics::light::{Light, Selection};
use crate::optics::power_balance::PowerBalance;

/// Frames, rows and columns that are looked at.
const FRAMES: usize = 6;
const ACROSS: usize = 16;
/// Largest part of the power that limits may take without a word.
const CUT: f64 = 1e-3;

/// What may be wrong with the light of rays; nothing is traced where the model is none of rays.
/// Refuses a light that never reaches the resin, and says where it ends.
pub(crate) fn must_arrive(optics: &Optics, grid: &VolumeGrid) -> Result<Vec<String>> {
    let family = optics.family(grid)?;
    if !family.capabilities().is_traced {
        return Ok(Vec::new());
    }
    let few: Vec<Light> = optics.lights.iter().map(thinned).collect();
    let job = optics.scene().lit_by(&few);
    let rays = family.rays(&job, &VolumeGrid::centered([1, 1, 1], 1.0));
    let Some(model) = rays.transpose()? else {
        return Ok(Vec::new());
    };
    let mut warnings = Vec::new();
    for (i, light) in few.iter().enumerate() {
        let frames = light.pixels.frames();
        let mut account = PowerBalance::default();
        for frame in 0..frames {
            account.add(&model.balance(i, frame), 1.0 / frames as f64);
        }
        if account.absorbed + account.transmitted == 0.0 {
            return Err(Error::config(
                format!("light[{i}]"),
                format!("none of its light reaches the resin: {}", ends(&account)),
                "a projector, vial and axis that let light into the resin",
            ));
        }
        if account.cut > CUT {
            warnings.push(format!(
                "light[{i}]: {:.2} % of its power is dropped after too many interfaces or scattering events \
                 (model.monte_carlo.orders)",
                100.0 * account.cut
            ));
        }
    }
    Ok(warnings)
}

/// The same light with few pixels over all that may be lit, and few frames.
fn thinned(light: &Light) -> Light {
    let grid = &light.pixels;
    let step = grid.frames().div_ceil(FRAMES).max(1);
    let [low, high] = light.selection.field_mm(grid);
    let [columns, rows] = [grid.columns, grid.rows].map(|pixels| pixels.min(ACROSS));
    Light {
        pixels: PatternGrid {
            azimuths: grid.azimuths.iter().copied().step_by(step).collect(),
            rows,
            columns,
            pitch_mm: [
                (high[0] - low[0]) / columns as f64,
                (high[1] - low[1]) / rows as f64,
            ],
            offset_mm: std::array::from_fn(|axis| f64::midpoint(low[axis], high[axis])),
            ..grid.clone()
        },
        selection: Selection::default(),
        sub_angles: 1,
        active: None,
        ..light.clone()
    }
}

/// Where power went that did not reach the resin.
fn ends(account: &PowerBalance) -> String {
    let parts = [
        ("is reflected at the walls", account.reflected),
        (
            "misses the vial, or passes through its walls only",
            account.missed,
        ),
        ("ends at bodies", account.blocked),
        ("is taken by the bath", account.bath),
        ("is given up", account.dropped + account.cut),
    ];
    let parts = parts.iter().filter(|(_, share)| *share > 5e-4);
    let parts: Vec<String> = parts
        .map(|(what, share)| format!("{:.1} % {what}", 100.0 * share))
        .collect();
    parts.join(", ")
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::job::resolve::optics::tests::spec;
    use std::path::Path;

    fn found(changes: &[&str]) -> Result<Vec<String>> {
        let grid = VolumeGrid::centered([8, 8, 8], 1.0);
        must_arrive(&Optics::new(&spec(changes), Path::new("")).unwrap(), &grid)
    }

    #[test]
    fn light_that_cannot_reach_the_resin_is_refused_with_where_it_ends() {
        let tilted = "motion.tilt_deg=1";
        assert!(found(&[tilted]).unwrap().is_empty());
        // A vial 300 mm off the axis: nothing meets it
        let Err(Error::Config {
            key, found: text, ..
        }) = found(&["motion.offset_mm=[0, 300]"])
        else {
            panic!("accepted");
        };
        assert!(
            key == "light[0]" && text.contains("100.0 % misses"),
            "{text}"
        );
        // From water into glass of index 1.2 at 80° to its face's normal along z: total reflection
        let steep = [
            "motion.tilt_deg=79",
            "vial.surrounding_index=3.9",
            "vial.cylinder.refractive_index=1.2",
        ];
        let Err(Error::Config { found: text, .. }) = found(&steep) else {
            panic!("accepted");
        };
        assert!(text.contains("100.0 % is reflected"), "{text}");
    }

    #[test]
    fn a_limit_that_takes_more_than_a_thousandth_is_told() {
        let milk = [
            "resin.attenuation_per_mm=0.4",
            "resin.scattering_per_mm=0.3",
            "model={ monte_carlo = { orders = 1 } }",
        ];
        let warnings = found(&milk).unwrap();
        assert!(
            warnings.len() == 1 && warnings[0].contains("model.monte_carlo.orders"),
            "{warnings:?}"
        );
        assert!(
            found(&[milk[0], milk[1], "model={ monte_carlo = {} }"])
                .unwrap()
                .is_empty()
        );
    }
}
