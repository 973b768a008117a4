//! Several lights that drive several species: r = M q.
//!
//! # Model
//! Light λ alone gives the dose q_λ, by a model of its own. Species s hardens, or is inhibited, by
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

use crate::{DoseLayout, DoseModel, PatternLayout, Run, ZCoupling, own_frames, several};
use rayon::prelude::*;
use std::ops::Range;
use tomolith_core::error::{Error, Result};
use tomolith_core::field::{BLOCK, Field, HostField};

/// Models of single lights, and the matrix M.
pub struct SpectralMixing {
    lights: Vec<Box<dyn DoseModel<Field = HostField>>>,
    /// M, a row per species.
    matrix: Vec<Vec<f32>>,
    patterns: Vec<PatternLayout>,
    outputs: Vec<DoseLayout>,
}

impl SpectralMixing {
    /// The doses of `species` (name, row of M) by models of one light each.
    ///
    /// # Errors
    /// [`Error::Shape`] for rows of another length, or models on different voxels; [`Error::Unsupported`] for cut voxels.
    ///
    /// # Panics
    /// When there is no light.
    pub fn new(
        lights: Vec<Box<dyn DoseModel<Field = HostField>>>,
        species: &[(String, Vec<f64>)],
    ) -> Result<Self> {
        let own = lights[0].outputs()[0].clone();
        for light in &lights {
            let [layout] = light.outputs() else {
                return Err(Error::Unsupported {
                    what: "a light's model of several doses".to_owned(),
                    reason: "what a light drives is mixed here; models of one dose".to_owned(),
                });
            };
            if layout.cells.is_some() {
                return Err(Error::Unsupported {
                    what: "voxels cut by the surface".to_owned(),
                    reason: "several species have several surfaces; whole voxels".to_owned(),
                });
            }
            if layout.grid != own.grid {
                return Err(Error::Shape {
                    what: "voxels of each light".to_owned(),
                    expected: own.grid.shape.to_vec(),
                    found: layout.grid.shape.to_vec(),
                });
            }
        }
        let mut outputs = Vec::with_capacity(species.len());
        for (name, row) in species {
            if row.len() != lights.len() {
                return Err(Error::Shape {
                    what: format!("what drives {name}, per light"),
                    expected: vec![lights.len()],
                    found: vec![row.len()],
                });
            }
            let offset = outputs
                .last()
                .map_or(0, |last: &DoseLayout| last.range().end);
            outputs.push(DoseLayout::new(name, own.grid.clone(), offset));
        }
        let mut offset = 0;
        let mut patterns = Vec::with_capacity(lights.len());
        for layout in lights.iter().flat_map(|light| light.patterns()) {
            let active: Vec<_> = layout.runs.iter().map(|r| (r.bottom, r.count)).collect();
            let moved = PatternLayout::new(layout.grid.clone(), layout.quantity, offset, &active);
            offset += moved.len();
            patterns.push(moved);
        }
        let matrix = species
            .iter()
            .map(|(_, row)| row.iter().map(|&m| m as f32).collect())
            .collect();
        Ok(SpectralMixing {
            lights,
            matrix,
            patterns,
            outputs,
        })
    }

    /// M, a row per species.
    #[must_use]
    pub fn matrix(&self) -> &[Vec<f32>] {
        &self.matrix
    }

    /// The patterns of a light in a field of its own.
    fn own(&self, light: usize, x: &HostField) -> HostField {
        HostField::from_slice(&x.as_slice()[self.patterns[light].range()])
    }

    /// doses += M_·λ q
    fn add(&self, light: usize, q: &HostField, doses: &mut HostField) {
        for (layout, row) in self.outputs.iter().zip(&self.matrix) {
            let m = row[light];
            if m == 0.0 {
                continue;
            }
            let doses = &mut doses.as_mut_slice()[layout.range()];
            let blocks = doses.par_chunks_mut(BLOCK);
            blocks
                .zip(q.as_slice().par_chunks(BLOCK))
                .for_each(|(doses, q)| doses.iter_mut().zip(q).for_each(|(d, &q)| *d += m * q));
        }
    }

    /// c ← M_·λᵀ cotangent
    fn unmix(&self, light: usize, cotangent: &HostField, c: &mut HostField) {
        c.fill(0.0);
        for (layout, row) in self.outputs.iter().zip(&self.matrix) {
            let m = row[light];
            let own = cotangent.as_slice()[layout.range()].par_chunks(BLOCK);
            c.as_mut_slice()
                .par_chunks_mut(BLOCK)
                .zip(own)
                .for_each(|(c, own)| c.iter_mut().zip(own).for_each(|(c, &o)| *c += m * o));
        }
    }
}

impl DoseModel for SpectralMixing {
    type Field = HostField;

    fn patterns(&self) -> &[PatternLayout] {
        &self.patterns
    }

    fn outputs(&self) -> &[DoseLayout] {
        &self.outputs
    }

    fn new_patterns(&self) -> Result<HostField> {
        Ok(HostField::zeros(
            self.patterns.last().map_or(0, |last| last.range().end),
        ))
    }

    fn new_dose(&self) -> Result<HostField> {
        Ok(HostField::zeros(
            self.outputs.last().map_or(0, |last| last.range().end),
        ))
    }

    fn dose(&self, x: &HostField, dose: &mut HostField, run: &Run) -> Result<()> {
        dose.fill(0.0);
        let mut q = self.lights[0].new_dose()?;
        for (i, light) in self.lights.iter().enumerate() {
            let part = several::part(&self.lights, run);
            light.dose(&self.own(i, x), &mut q, &part)?;
            self.add(i, &q, dose);
        }
        Ok(())
    }

    fn pullback(
        &self,
        x: &HostField,
        cotangent: &HostField,
        grad: &mut HostField,
        run: &Run,
    ) -> Result<()> {
        let mut c = self.lights[0].new_dose()?;
        for (i, light) in self.lights.iter().enumerate() {
            self.unmix(i, cotangent, &mut c);
            let mut own = light.new_patterns()?;
            let part = several::part(&self.lights, run);
            light.pullback(&self.own(i, x), &c, &mut own, &part)?;
            grad.as_mut_slice()[self.patterns[i].range()].copy_from_slice(own.as_slice());
        }
        Ok(())
    }

    fn dose_of(
        &self,
        frames: Range<usize>,
        x: &HostField,
        dose: &mut HostField,
        run: &Run,
    ) -> Result<()> {
        let mut q = self.lights[0].new_dose()?;
        for (i, own) in own_frames(&self.patterns, &frames) {
            q.fill(0.0);
            self.lights[i].dose_of(own, &self.own(i, x), &mut q, run)?;
            self.add(i, &q, dose);
        }
        Ok(())
    }

    fn pullback_of(
        &self,
        frames: Range<usize>,
        x: &HostField,
        cotangent: &HostField,
        grad: &mut HostField,
        run: &Run,
    ) -> Result<()> {
        let mut c = self.lights[0].new_dose()?;
        for (i, own) in own_frames(&self.patterns, &frames) {
            self.unmix(i, cotangent, &mut c);
            let (light, layout) = (&self.lights[i], &self.patterns[i]);
            let mut back = light.new_patterns()?;
            light.pullback_of(own.clone(), &self.own(i, x), &c, &mut back, run)?;
            let range = layout.elements_of(own);
            let own = range.start - layout.offset..range.end - layout.offset;
            grad.as_mut_slice()[range].copy_from_slice(&back.as_slice()[own]);
        }
        Ok(())
    }

    fn along(&self, x: &HostField, d: &HostField, run: &Run) -> Result<Option<Vec<HostField>>> {
        let own = |i: usize| Ok([self.own(i, x), self.own(i, d)]);
        let add = |i: usize, q: &HostField, doses: &mut HostField| self.add(i, q, doses);
        several::along(&self.lights, own, || self.new_dose(), add, run)
    }

    fn z_coupling(&self) -> ZCoupling {
        several::z_coupling(&self.lights)
    }

    fn is_linear(&self) -> bool {
        several::is_linear(&self.lights)
    }

    fn renew(&self, iteration: usize, x: &HostField, run: &Run) -> Result<bool> {
        several::renew(&self.lights, iteration, |i| Ok(self.own(i, x)), run)
    }

    fn is_renewed(&self) -> bool {
        several::is_renewed(&self.lights)
    }

    fn updates(&self) -> u64 {
        several::updates(&self.lights)
    }

    fn of_light(&self, i: usize) -> Option<&dyn DoseModel<Field = HostField>> {
        self.lights.get(i).map(AsRef::as_ref)
    }

    fn describe(&self) -> String {
        let lights: Vec<String> = self.lights.iter().map(|light| light.describe()).collect();
        format!(
            "{} species by {} lights ({})",
            self.outputs.len(),
            lights.len(),
            lights.join("; ")
        )
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::parallel::Parallel;
    use tomolith_core::check;
    use tomolith_core::grid::{PatternGrid, VolumeGrid};
    use tomolith_optics::light::Light;
    use tomolith_optics::resin::Resin;
    use tomolith_optics::vial::index_matched::IndexMatched;

    fn light(
        frames: usize,
        columns: usize,
        absorption: f64,
    ) -> Box<dyn DoseModel<Field = HostField>> {
        let pixels = PatternGrid::full_turn(frames, 0.1, 12, columns, 0.1);
        let light = Light::new(pixels, Resin::absorbing(1.48, absorption));
        let grid = VolumeGrid::centered([10, 14, 14], 0.1);
        Box::new(Parallel::new(&IndexMatched { radius_mm: 2.0 }, vec![light], grid).unwrap())
    }

    fn mixing() -> SpectralMixing {
        let species = [
            ("acrylate".to_owned(), vec![1.0, 0.25]),
            ("epoxy".to_owned(), vec![0.0, 2.0]),
            ("inhibited".to_owned(), vec![1.5, -1.0]),
        ];
        SpectralMixing::new(vec![light(6, 20, 0.2), light(9, 16, 0.4)], &species).unwrap()
    }

    #[test]
    fn it_is_a_linear_model_with_its_adjoint() {
        check::model::model(&mixing(), 11).unwrap();
    }

    #[test]
    fn each_species_gets_what_its_row_says() {
        let (model, run) = (mixing(), Run::new());
        let mut x = model.new_patterns().unwrap();
        let noise = check::noise(3, x.len());
        x.as_mut_slice()
            .iter_mut()
            .zip(noise)
            .for_each(|(x, n)| *x = 1.0 + n);
        let mut dose = model.new_dose().unwrap();
        model.dose(&x, &mut dose, &run).unwrap();
        let alone: Vec<HostField> = (0..2)
            .map(|i| {
                let light = model.of_light(i).unwrap();
                let mut q = light.new_dose().unwrap();
                light.dose(&model.own(i, &x), &mut q, &run).unwrap();
                q
            })
            .collect();
        for (layout, row) in model.outputs().iter().zip(model.matrix()) {
            for (i, &found) in dose.as_slice()[layout.range()].iter().enumerate() {
                let expected = row[0] * alone[0].as_slice()[i] + row[1] * alone[1].as_slice()[i];
                assert!((found - expected).abs() <= 1e-5, "{found} {expected}");
            }
        }
        // All frames of both lights, in two parts that cut through the second light
        let mut parts = model.new_dose().unwrap();
        model.dose_of(0..8, &x, &mut parts, &run).unwrap();
        model.dose_of(8..15, &x, &mut parts, &run).unwrap();
        let worst = parts.as_slice().iter().zip(dose.as_slice());
        let worst = worst.map(|(a, b)| (a - b).abs()).fold(0.0, f32::max);
        assert!(worst < 1e-5, "{worst}");
    }
}
