//! A model whose pixels give less light, or none: F(D·x) with D = 0 or a common factor per pixel, and its derivative
//! D·F′(D·x)ᵀ.
//!
//! The factor is that of a dose convention (`resin.dose_convention`). Rays that may not pass a place are taken away in this way: [`pixels_through`] finds them by the adjoint of an indicator,
//! which is positive exactly for the pixels that bring light there. An active run of rows cannot have holes; this can.
//! Every method that calls the model sees dark pixels as pixels without effect, and leaves them alone.
//!
//! **Cost** a copy of the patterns per forward call.

use super::{DoseLayout, DoseModel, PatternLayout, Run, ZCoupling};
use rayon::prelude::*;
use std::ops::Range;
use tomolith_core::error::Result;
use tomolith_core::field::{Field, HostField};
use tomolith_core::grid::Volume;

/// A model with dark pixels, or a factor.
pub struct MaskedModel {
    model: Box<dyn DoseModel<Field = HostField>>,
    /// One per pixel, or none at all.
    dark: Vec<bool>,
    factor: f32,
}

/// Which pixels (elements of a pattern field) bring light to a voxel that is marked; `places` in file order `[z, y, x]`.
///
/// # Errors
/// [`Error::Cancelled`](tomolith_core::Error::Cancelled), or not enough memory.
pub fn pixels_through(
    model: &dyn DoseModel<Field = HostField>,
    places: &Volume<bool>,
    run: &Run,
) -> Result<Vec<bool>> {
    if model.of_light(0).is_some() {
        let lights = (0..model.patterns().len()).filter_map(|i| model.of_light(i));
        let through: Result<Vec<_>> = lights.map(|l| pixels_through(l, places, run)).collect();
        return through.map(|lights| lights.concat());
    }
    let layout = &model.outputs()[0];
    let marks = Volume {
        grid: places.grid.clone(),
        values: places
            .values
            .iter()
            .map(|&p| f32::from(u8::from(p)))
            .collect(),
    };
    let mut marked = model.new_dose()?;
    marked.as_mut_slice()[layout.range()].copy_from_slice(&layout.field_of(&marks));
    let mut light = model.new_patterns()?;
    model.pullback(&light.zeros_like(), &marked, &mut light, run)?;
    Ok(light.as_slice().par_iter().map(|&v| v > 0.0).collect())
}

impl MaskedModel {
    /// Switches pixels of a model off.
    ///
    /// # Panics
    /// When `dark` has another length than the model's pattern fields.
    #[must_use]
    pub fn new(model: Box<dyn DoseModel<Field = HostField>>, dark: &[bool]) -> Self {
        let pixels: usize = model.patterns().iter().map(PatternLayout::len).sum();
        assert_eq!(dark.len(), pixels, "one mark per active pixel");
        MaskedModel {
            model,
            dark: dark.to_vec(),
            factor: 1.0,
        }
    }

    /// All light of a model times a factor above 0.
    #[must_use]
    pub fn by(model: Box<dyn DoseModel<Field = HostField>>, factor: f32) -> Self {
        MaskedModel {
            model,
            dark: Vec::new(),
            factor,
        }
    }

    fn masked(&self, x: &HostField) -> HostField {
        let mut x = x.clone();
        self.dim(&mut x);
        x
    }

    /// x ← D·x
    fn dim(&self, x: &mut HostField) {
        darken(x, &self.dark);
        if self.factor != 1.0 {
            x.scale(self.factor);
        }
    }
}

/// Sets dark pixels to 0; none are where `dark` is empty.
pub fn darken(x: &mut HostField, dark: &[bool]) {
    x.as_mut_slice()
        .par_iter_mut()
        .zip(dark)
        .for_each(|(x, &dark)| *x = if dark { 0.0 } else { *x });
}

impl DoseModel for MaskedModel {
    type Field = HostField;

    fn patterns(&self) -> &[PatternLayout] {
        self.model.patterns()
    }

    fn outputs(&self) -> &[DoseLayout] {
        self.model.outputs()
    }

    fn new_patterns(&self) -> Result<HostField> {
        self.model.new_patterns()
    }

    fn new_dose(&self) -> Result<HostField> {
        self.model.new_dose()
    }

    fn dose(&self, x: &HostField, dose: &mut HostField, run: &Run) -> Result<()> {
        self.model.dose(&self.masked(x), dose, run)
    }

    fn pullback(
        &self,
        x: &HostField,
        cotangent: &HostField,
        grad: &mut HostField,
        run: &Run,
    ) -> Result<()> {
        self.model.pullback(&self.masked(x), cotangent, grad, run)?;
        self.dim(grad);
        Ok(())
    }

    fn dose_of(
        &self,
        frames: Range<usize>,
        x: &HostField,
        dose: &mut HostField,
        run: &Run,
    ) -> Result<()> {
        self.model.dose_of(frames, &self.masked(x), dose, run)
    }

    fn along(&self, x: &HostField, d: &HostField, run: &Run) -> Result<Option<Vec<HostField>>> {
        self.model.along(&self.masked(x), &self.masked(d), run)
    }

    fn z_coupling(&self) -> ZCoupling {
        self.model.z_coupling()
    }

    fn renew(&self, iteration: usize) -> bool {
        self.model.renew(iteration)
    }

    fn is_renewed(&self) -> bool {
        self.model.is_renewed()
    }

    fn is_linear(&self) -> bool {
        self.model.is_linear()
    }

    fn updates(&self) -> u64 {
        self.model.updates()
    }

    fn of_light(&self, i: usize) -> Option<&dyn DoseModel<Field = HostField>> {
        self.model.of_light(i)
    }

    fn describe(&self) -> String {
        let model = self.model.describe();
        let dark = self.dark.iter().filter(|dark| **dark).count();
        if dark > 0 {
            format!("{model}, {dark} of {} pixels dark", self.dark.len())
        } else {
            format!("{model}, dose times {:.6}", self.factor)
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::parallel::{Light, Parallel};
    use tomolith_core::check;
    use tomolith_core::grid::{PatternGrid, VolumeGrid};
    use tomolith_optics::resin::Resin;
    use tomolith_optics::vial::index_matched::IndexMatched;

    /// 8 frames of 12 × 20 pixels through 10 × 16 × 16 voxels, all of 0.1 mm.
    fn model() -> Box<dyn DoseModel<Field = HostField>> {
        let light = Light::new(
            PatternGrid::full_turn(8, 0.1, 12, 20, 0.1),
            Resin::absorbing(1.48, 0.2),
        );
        let grid = VolumeGrid::centered([10, 16, 16], 0.1);
        let vial = IndexMatched { radius_mm: 2.0 };
        Box::new(Parallel::new(&vial, vec![light], grid).unwrap())
    }

    /// A block of 3 × 2 × 2 voxels to one side.
    fn block(grid: &VolumeGrid) -> Volume<bool> {
        let mut places = Volume::filled(grid.clone(), false);
        for iz in 4..7 {
            for iy in 11..13 {
                for ix in 3..5 {
                    places.values[grid.index(iz, iy, ix)] = true;
                }
            }
        }
        places
    }

    #[test]
    fn no_light_reaches_the_places_that_are_to_stay_dark_and_all_other_light_is_left() {
        let model = model();
        let run = Run::new();
        let places = block(&model.outputs()[0].grid);
        let dark = pixels_through(model.as_ref(), &places, &run).unwrap();
        // A block 0.2 mm wide and three rows high: 3 to 5 columns of 20, at three heights (or four, cut) of 12
        let share = dark.iter().filter(|d| **d).count();
        assert!((8 * 3 * 3..=8 * 4 * 5).contains(&share), "{share}");
        let mut full = model.new_patterns().unwrap();
        full.as_mut_slice().fill(1.0);
        let mut plain = model.new_dose().unwrap();
        model.dose(&full, &mut plain, &run).unwrap();
        let darkened = MaskedModel::new(model, &dark);
        let mut dose = darkened.new_dose().unwrap();
        darkened.dose(&full, &mut dose, &run).unwrap();
        let layout = &darkened.outputs()[0];
        let [before, after] = [&plain, &dose].map(|field| layout.volume_of(field.as_slice()));
        for ((&place, &before), &after) in
            places.values.iter().zip(&before.values).zip(&after.values)
        {
            assert!(if place { after == 0.0 } else { after <= before });
        }
        // At heights without a block nothing changes
        let slice = before.grid.shape[1] * before.grid.shape[2];
        assert_eq!(before.values[..slice], after.values[..slice]);
        // A dark pixel alone lights a marked voxel
        let one = dark.iter().position(|d| *d).unwrap();
        let mut single = darkened.new_patterns().unwrap();
        single.as_mut_slice()[one] = 1.0;
        darkened.model.dose(&single, &mut dose, &run).unwrap();
        let lit = layout.volume_of(dose.as_slice());
        assert!(
            places
                .values
                .iter()
                .zip(&lit.values)
                .any(|(place, v)| *place && *v > 0.0)
        );
    }

    #[test]
    fn a_factor_multiplies_every_dose() {
        let run = Run::new();
        let mut x = model().new_patterns().unwrap();
        x.copy_from_host(&check::model::noise(3, x.len()));
        let dose_of = |model: &dyn DoseModel<Field = HostField>| {
            let mut dose = model.new_dose().unwrap();
            model.dose(&x, &mut dose, &run).unwrap();
            dose
        };
        let (plain, scaled) = (
            dose_of(model().as_ref()),
            dose_of(&MaskedModel::by(model(), 0.25)),
        );
        // A power of two: to the bit
        for (plain, scaled) in plain.as_slice().iter().zip(scaled.as_slice()) {
            assert_eq!(0.25 * plain, *scaled);
        }
        check::model::model(&MaskedModel::by(model(), 0.453), 5).unwrap();
    }

    #[test]
    fn it_is_an_exact_pair() {
        let model = model();
        let dark = pixels_through(
            model.as_ref(),
            &block(&model.outputs()[0].grid),
            &Run::new(),
        )
        .unwrap();
        check::model::model(&MaskedModel::new(model, &dark), 5).unwrap();
    }
}
