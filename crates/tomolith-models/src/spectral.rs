//! Several lights that drive several species: r = M q.
//!
//! # Model
//! Light λ alone gives the dose q_λ, by a separate model. Species s hardens, or is inhibited, by
//!
//! ```text
//! r_s = Σ_λ M_sλ q_λ
//! ```
//!
//! Dual curing has a row of M per network (both colors start the acrylate, only the ultraviolet the epoxy); antagonistic inhibition has
//! one row with a negative entry. The pullback is Mᵀ: c_λ = Σ_s M_sλ c_s, then each light's own pullback.
//!
//! # Source
//! Wang et al., Nat. Commun. 13, 367 (2022), whose two colors are computed one by one; here their patterns may be optimized jointly.
//!
//! # Shapes
//! Patterns: the fields of the lights, one after the other. Dose: one block per species, each laid out like the dose of a light.
//! All lights share one grid.
//!
//! # Limits
//! Whole voxels: a surface that cuts voxels belongs to one species only.
//!
//! # Cost
//! One call of every light's model, and one pass over its dose per species that it drives. Memory: patterns and dose of one light at a
//! time.

use crate::several::{self, Several, SharedModel};
use crate::{DoseLayout, HostModel, PatternLayout};
use std::sync::Arc;
use tomolith_core::dose::Space;
use tomolith_core::dose::form::Joint;
use tomolith_core::error::{Error, Result};

/// The doses of `species` (name, row of M) by models of one light each.
///
/// # Errors
/// [`Error::Shape`] for rows of another length, or models on different voxels; [`Error::Unsupported`] for cut voxels.
///
/// # Panics
/// When there is no light.
pub fn mixed(lights: Vec<HostModel>, species: &[(String, Vec<f64>)]) -> Result<Several> {
    let first = lights[0].outputs()[0].clone();
    for light in &lights {
        let [layout] = light.outputs() else {
            return Err(Error::unsupported(
                "a light's model of several doses",
                "what a light drives is mixed here; models of one dose",
            ));
        };
        if layout.cells.is_some() {
            return Err(Error::unsupported(
                "voxels cut by the surface",
                "several species have several surfaces; whole voxels",
            ));
        }
        if layout.grid != first.grid {
            return Err(Error::shape(
                "voxels of each light",
                first.grid.shape,
                layout.grid.shape,
            ));
        }
    }
    let mut outputs = Vec::with_capacity(species.len());
    for (name, row) in species {
        if row.len() != lights.len() {
            return Err(Error::shape(
                format!("what drives {name}, per light"),
                vec![lights.len()],
                vec![row.len()],
            ));
        }
        let offset = outputs
            .last()
            .map_or(0, |last: &DoseLayout| last.range().end);
        outputs.push(DoseLayout::new(name, first.grid.clone(), offset));
    }
    let mut offset = 0;
    let mut patterns = Vec::with_capacity(lights.len());
    for layout in lights.iter().flat_map(|light| light.patterns()) {
        let active: Vec<_> = layout.runs.iter().map(|r| (r.bottom, r.count)).collect();
        let moved = PatternLayout::new(layout.grid.clone(), layout.quantity, offset, &active);
        offset += moved.len();
        patterns.push(moved);
    }
    let rows = species.iter();
    let matrix = rows.map(|(_, row)| row.iter().map(|&m| m as f32).collect());
    let shown = |(light, joint): (&HostModel, &PatternLayout)| {
        several::shown(std::slice::from_ref(joint), light.patterns())
    };
    let joint = Joint {
        matrix: matrix.collect(),
        lit: (0..lights.len()).map(|light| light..light + 1).collect(),
        shown: lights.iter().zip(&patterns).map(shown).collect(),
        pixels: lights
            .iter()
            .map(|light| light.facts().len(Space::Patterns))
            .collect(),
        patterns,
        outputs,
        describe: |species, lights| {
            let (count, lights) = (lights.len(), lights.join("; "));
            format!("{species} species by {count} lights ({lights})")
        },
    };
    let models = lights.into_iter().map(SharedModel::from);
    Several::new(models.collect(), Arc::new(joint))
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::parallel::Parallel;
    use crate::{DoseModel, Work};
    use tomolith_core::check;
    use tomolith_core::field::{Field, HostField};
    use tomolith_core::grid::{PatternGrid, VolumeGrid};
    use tomolith_optics::light::Light;
    use tomolith_optics::resin::Resin;
    use tomolith_optics::vial::index_matched::IndexMatched;

    fn light(frames: usize, columns: usize, absorption: f64) -> HostModel {
        let pixels = PatternGrid::full_turn(frames, 0.1, 12, columns, 0.1);
        let light = Light::new(pixels, Resin::absorbing(1.48, absorption));
        let grid = VolumeGrid::centered([10, 14, 14], 0.1);
        Box::new(Parallel::new(&IndexMatched { radius_mm: 2.0 }, vec![light], grid).unwrap())
    }

    fn mixing() -> Several {
        let species = [
            ("acrylate".to_owned(), vec![1.0, 0.25]),
            ("epoxy".to_owned(), vec![0.0, 2.0]),
            ("inhibited".to_owned(), vec![1.5, -1.0]),
        ];
        mixed(vec![light(6, 20, 0.2), light(9, 16, 0.4)], &species).unwrap()
    }

    #[test]
    fn it_is_a_linear_model_with_its_adjoint() {
        check::model::model(&mixing(), 11).unwrap();
    }

    #[test]
    fn each_species_gets_what_its_row_says() {
        let (model, work) = (mixing(), Work::new());
        let mut x = model.new_patterns().unwrap();
        let noise = check::noise(3, x.len());
        x.as_mut_slice()
            .iter_mut()
            .zip(noise)
            .for_each(|(x, n)| *x = 1.0 + n);
        let dose = check::dose(&model, &x);
        let alone: Vec<HostField> = (0..2)
            .map(|i| {
                let light = model.of_light(i).unwrap();
                let mut q = light.new_dose().unwrap();
                let patterns = model.shown(i, &x).unwrap();
                light.dose(&patterns, &mut q, &work).unwrap();
                q
            })
            .collect();
        for (layout, row) in model.outputs().iter().zip(&model.joint.matrix) {
            for (i, &found) in dose.as_slice()[layout.range()].iter().enumerate() {
                let expected = row[0] * alone[0].as_slice()[i] + row[1] * alone[1].as_slice()[i];
                assert!((found - expected).abs() <= 1e-5, "{found} {expected}");
            }
        }
        // All frames of both lights, in two parts that cut through the second light
        let mut parts = model.new_dose().unwrap();
        model.dose_of(0..8, &x, &mut parts, &work).unwrap();
        model.dose_of(8..15, &x, &mut parts, &work).unwrap();
        let worst = parts.as_slice().iter().zip(dose.as_slice());
        let worst = worst.map(|(a, b)| (a - b).abs()).fold(0.0, f32::max);
        assert!(worst < 1e-5, "{worst}");
    }
}
