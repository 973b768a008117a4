//! A model whose pixels give less light, or none, or spread it: F(B·D·x) with D = 0 or a common factor per pixel, B the
//! spread of their light where there is one, and the derivative D·Bᵀ·F′(B·D·x)ᵀ.
//!
//! The factor is that of a dose convention (`resin.dose_convention`). Rays that may not pass a place are taken away in this way: [`pixels_through`] finds them by the adjoint of an indicator,
//! which is positive exactly for the pixels that bring light there. An active run of rows cannot have holes; this can.
//! Every method that calls the model sees dark pixels as pixels without effect, and leaves them alone.
//!
//! **Cost** a copy of the patterns per call, none where no pixel is dark and the factor is 1.

use super::blurred::Spreads;
use super::{DoseModel, HostModel, PatternLayout, Quantity, Work, elements_of, frames_of};
use crate::several::SharedModel;
use std::borrow::Cow;
use std::ops::Range;
use tomolith_core::dose::form::Form;
use tomolith_core::dose::regions::{ByElement, Regions};
use tomolith_core::dose::{Facts, Renewal, Space};
use tomolith_core::error::Result;
use tomolith_core::field::{BLOCK, Field, HostField};
use tomolith_core::grid::Volume;
use tomolith_core::parallel::{InParallel, table};

/// A model with dark pixels, a factor, spread light, all or none of these: the one place for each.
pub struct MaskedModel {
    model: HostModel,
    spreads: Option<Spreads>,
    /// One per pixel, or none at all.
    dark: Vec<bool>,
    factor: f32,
}

/// Which pixels (elements of a pattern field) bring light to a voxel that is marked; `places` in file order `[z, y, x]`.
///
/// # Errors
/// [`Error::Canceled`](tomolith_core::Error::Canceled), or not enough memory.
pub fn pixels_through(
    model: &dyn DoseModel<Field = HostField>,
    places: &Volume<bool>,
    work: &Work,
) -> Result<Vec<bool>> {
    if model.of_light(0).is_some() {
        let lights = (0..model.patterns().len()).filter_map(|i| model.of_light(i));
        let through: Result<Vec<_>> = lights.map(|l| pixels_through(&*l, places, work)).collect();
        return through.map(|lights| lights.concat());
    }
    let marks = Volume::new(
        places.grid.clone(),
        places
            .values
            .iter()
            .map(|&p| f32::from(u8::from(p)))
            .collect(),
    );
    let mut marked = model.new_dose()?;
    for layout in model.outputs() {
        marked.as_mut_slice()[layout.range()].copy_from_slice(&layout.field_of(&marks));
    }
    let mut light = model.new_patterns()?;
    model.pullback(&light.zeros_like(), &marked, &mut light, work)?;
    Ok(table(light.len(), |i| light.as_slice()[i] > 0.0))
}

impl MaskedModel {
    /// A model of which some pixels stay dark (none: an empty list), and all light has a factor above 0 (amplitudes its root).
    ///
    /// # Panics
    /// When `dark` is neither empty nor as long as the model's pattern fields.
    #[must_use]
    pub fn new(model: HostModel, dark: Vec<bool>, factor: f64) -> Self {
        let is_amplitude = |p: &PatternLayout| p.quantity == Quantity::Amplitude;
        let factor = if model.patterns().iter().any(is_amplitude) {
            factor.sqrt()
        } else {
            factor
        };
        let masked = MaskedModel {
            model,
            spreads: None,
            dark: Vec::new(),
            factor: factor as f32,
        };
        masked.and_dark(dark)
    }

    /// The model of pixels whose light is spread over those of the inner one. It has no dark pixels yet.
    pub(crate) fn with_spreads(mut self, spreads: Spreads) -> Self {
        self.spreads = Some(spreads);
        self
    }

    /// The model with further dark pixels; an empty list has none.
    ///
    /// # Panics
    /// As [`new`](Self::new).
    #[must_use]
    pub fn and_dark(mut self, dark: Vec<bool>) -> Self {
        if dark.is_empty() {
            return self;
        }
        let pixels: usize = self.patterns().iter().map(PatternLayout::len).sum();
        assert_eq!(dark.len(), pixels, "one mark per active pixel");
        if self.dark.is_empty() {
            self.dark = dark;
        } else {
            let pairs = self.dark.iter_mut().zip(dark);
            pairs.for_each(|(dark, more)| *dark |= more);
        }
        self
    }

    /// D·x
    fn masked<'x>(&self, x: &'x HostField) -> Cow<'x, HostField> {
        if self.dark.is_empty() && self.factor == 1.0 {
            return Cow::Borrowed(x);
        }
        let mut x = x.clone();
        self.dim(0..x.len(), &mut x);
        Cow::Owned(x)
    }

    /// All frames.
    fn all(&self) -> Range<usize> {
        0..frames_of(self.patterns())
    }

    /// What the model is lit with: B·D·x of some frames. Where light is spread, the other frames are dark.
    fn lit<'x>(&self, frames: &Range<usize>, x: &'x HostField) -> Result<Cow<'x, HostField>> {
        let x = self.masked(x);
        let Some(spreads) = &self.spreads else {
            return Ok(x);
        };
        let mut lit = self.model.new_patterns()?;
        let layouts = self.model.patterns();
        spreads.carry(frames, layouts, x.as_slice(), lit.as_mut_slice(), 1);
        Ok(Cow::Owned(lit))
    }

    /// x ← D·x in some elements
    fn dim(&self, elements: Range<usize>, x: &mut HostField) {
        let x = &mut x.as_mut_slice()[elements.clone()];
        if !self.dark.is_empty() {
            darken(x, &self.dark[elements]);
        }
        if self.factor != 1.0 {
            let blocks = x.chunks_mut(BLOCK);
            blocks.par_each(|x| x.iter_mut().for_each(|x| *x *= self.factor));
        }
    }
}

/// Sets dark pixels to 0; none are where `dark` is empty.
pub fn darken(x: &mut [f32], dark: &[bool]) {
    let blocks = x.chunks_mut(BLOCK).zip(dark.chunks(BLOCK));
    blocks.par_each(|(x, dark)| {
        let pixels = x.iter_mut().zip(dark);
        pixels.for_each(|(x, &dark)| *x = if dark { 0.0 } else { *x });
    });
}

impl Renewal<HostField> for MaskedModel {
    fn renew(&self, iteration: usize, x: &HostField, work: &Work) -> Result<bool> {
        let renewal = self.model.renewal();
        renewal.map_or(Ok(false), |model| {
            model.renew(iteration, &*self.lit(&self.all(), x)?, work)
        })
    }

    fn memory(&self) -> Option<HostField> {
        self.model.renewal()?.memory()
    }

    fn restore(&self, memory: &HostField) {
        if let Some(renewal) = self.model.renewal() {
            renewal.restore(memory);
        }
    }
}

impl DoseModel for MaskedModel {
    type Field = HostField;

    fn facts(&self) -> Facts<'_> {
        let facts = self.model.facts();
        match &self.spreads {
            None => facts,
            Some(spreads) => Facts {
                patterns: &spreads.patterns,
                z_coupling: spreads.z_reach(facts.z_coupling),
                ..facts
            },
        }
    }

    fn new_field(&self, space: Space) -> Result<HostField> {
        match &self.spreads {
            None => self.model.new_field(space),
            Some(_) => Ok(self.facts().host_field(space)),
        }
    }

    fn updates(&self) -> u64 {
        self.model.updates()
    }

    fn of_light(&self, i: usize) -> Option<SharedModel> {
        self.model.of_light(i)
    }

    fn renewal(&self) -> Option<&dyn Renewal<HostField>> {
        self.model.renewal().map(|_| self as _)
    }

    fn dose(&self, x: &HostField, dose: &mut HostField, work: &Work) -> Result<()> {
        self.model.dose(&*self.lit(&self.all(), x)?, dose, work)
    }

    fn pullback_of(
        &self,
        frames: Range<usize>,
        x: &HostField,
        cotangent: &HostField,
        grad: &mut HostField,
        work: &Work,
    ) -> Result<()> {
        let lit = self.lit(&frames, x)?;
        if let Some(spreads) = &self.spreads {
            let mut back = lit.zeros_like();
            (self.model).pullback_of(frames.clone(), &lit, cotangent, &mut back, work)?;
            let (layouts, grad) = (self.model.patterns(), grad.as_mut_slice());
            spreads.carry(&frames, layouts, back.as_slice(), grad, -1);
        } else {
            (self.model).pullback_of(frames.clone(), &lit, cotangent, grad, work)?;
        }
        for (range, _) in elements_of(self.patterns(), &frames) {
            self.dim(range, grad);
        }
        Ok(())
    }

    fn dose_of(
        &self,
        frames: Range<usize>,
        x: &HostField,
        dose: &mut HostField,
        work: &Work,
    ) -> Result<()> {
        let lit = self.lit(&frames, x)?;
        self.model.dose_of(frames, &lit, dose, work)
    }

    fn along(&self, x: &HostField, d: &HostField, work: &Work) -> Result<Option<Vec<HostField>>> {
        let [x, d] = [self.lit(&self.all(), x)?, self.lit(&self.all(), d)?];
        self.model.along(&x, &d, work)
    }

    /// None of spread light.
    fn form(&self) -> Option<Form> {
        if self.spreads.is_some() {
            return None;
        }
        Some(self.model.form()?.masked(&self.dark, self.factor))
    }

    /// None of spread light.
    fn regions(&self) -> Option<&dyn Regions<HostField>> {
        self.spreads.is_none().then_some(())?;
        self.model.regions().map(|_| self as _)
    }

    fn describe(&self) -> String {
        let mut text = self.model.describe();
        text += &self
            .spreads
            .as_ref()
            .map_or(String::new(), Spreads::describe);
        if self.factor != 1.0 {
            text += &format!(", dose times {:.6}", self.factor);
        }
        let dark = self.dark.iter().filter(|dark| **dark).count();
        if dark > 0 {
            text += &format!(", {dark} of {} pixels dark", self.dark.len());
        }
        text
    }
}

impl MaskedModel {
    fn own_regions(&self) -> &dyn Regions<HostField> {
        let regions = self.model.regions();
        regions.expect("a model that is asked for its regions has some")
    }
}

impl Regions<HostField> for MaskedModel {
    fn count(&self) -> usize {
        self.own_regions().count()
    }

    fn least(&self, value_of: &ByElement) -> Vec<f32> {
        self.own_regions().least(value_of)
    }

    fn holds_any(&self, field: &HostField, chosen: &[bool]) -> Vec<bool> {
        self.own_regions().holds_any(field, chosen)
    }

    fn bounds(&self, x: &HostField, step: &HostField, work: &Work) -> Result<Vec<f32>> {
        let [x, step] = [self.masked(x), self.masked(step)];
        self.own_regions().bounds(&x, &step, work)
    }

    fn dose_in(
        &self,
        chosen: &[bool],
        x: &HostField,
        dose: &mut HostField,
        work: &Work,
    ) -> Result<()> {
        let x = self.masked(x);
        self.own_regions().dose_in(chosen, &x, dose, work)
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
        let work = Work::new();
        let places = block(&model.outputs()[0].grid);
        let dark = pixels_through(model.as_ref(), &places, &work).unwrap();
        // A block 0.2 mm wide and three rows high: 3 to 5 columns of 20, at three heights (or four, cut) of 12
        let share = dark.iter().filter(|d| **d).count();
        assert!((8 * 3 * 3..=8 * 4 * 5).contains(&share), "{share}");
        let mut full = model.new_patterns().unwrap();
        full.as_mut_slice().fill(1.0);
        let plain = check::dose(&*model, &full);
        let darkened = MaskedModel::new(model, dark.clone(), 1.0);
        let mut dose = check::dose(&darkened, &full);
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
        darkened.model.dose(&single, &mut dose, &work).unwrap();
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
        let mut x = model().new_patterns().unwrap();
        x.copy_from_host(&check::noise(3, x.len()));
        let plain = check::dose(&*model(), &x);
        let scaled = check::dose(&MaskedModel::new(model(), Vec::new(), 0.25), &x);
        // A power of two: to the bit
        for (plain, scaled) in plain.as_slice().iter().zip(scaled.as_slice()) {
            assert_eq!(0.25 * plain, *scaled);
        }
        check::model::model(&MaskedModel::new(model(), Vec::new(), 0.453), 5).unwrap();
    }

    #[test]
    fn marks_and_factor_are_one_mask() {
        let (work, pixels) = (Work::new(), model().new_patterns().unwrap().len());
        let marks = |every: usize| (0..pixels).map(|i| i % every == 0).collect::<Vec<_>>();
        let nested: HostModel = Box::new(MaskedModel::new(model(), marks(3), 0.453));
        let nested = MaskedModel::new(nested, marks(5), 1.0);
        let one = MaskedModel::new(model(), marks(3), 0.453).and_dark(marks(5));
        let either = marks(3).into_iter().zip(marks(5)).map(|(a, b)| a || b);
        assert!(one.dark.iter().copied().eq(either));
        let x = HostField::from_slice(&check::noise(4, pixels));
        let mut dose = [one.new_dose().unwrap(), one.new_dose().unwrap()];
        one.dose(&x, &mut dose[0], &work).unwrap();
        nested.dose(&x, &mut dose[1], &work).unwrap();
        assert_eq!(dose[0].as_slice(), dose[1].as_slice());
        check::model::model(&one, 5).unwrap();
    }

    #[test]
    fn it_is_an_exact_pair() {
        let model = model();
        let dark = pixels_through(
            model.as_ref(),
            &block(&model.outputs()[0].grid),
            &Work::new(),
        )
        .unwrap();
        check::model::model(&MaskedModel::new(model, dark.clone(), 1.0), 5).unwrap();
    }
}
