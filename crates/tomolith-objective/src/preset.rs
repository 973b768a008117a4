//! What the presets share: how part and void become bands.

use super::band::{Band, BandObjective, Bands};
use super::{BoxedObjective, Chosen, MakeObjective, ObjectiveInput};
use schemars::JsonSchema;
use serde::{Deserialize, Serialize};
use std::fmt::Debug;
use std::sync::Arc;
use tomolith_core::dose::DoseLayout;
use tomolith_core::error::{Error, Result};
use tomolith_core::field::Field;
use tomolith_core::grid::Volume;
use tomolith_core::parallel::{elements, table};
use tomolith_core::target::label;
use tomolith_core::units::exact;

/// How voxels that the surface cuts are weighed.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Deserialize, Serialize, JsonSchema)]
#[serde(rename_all = "lowercase")]
pub enum SurfaceHandling {
    /// A voxel is part when at least half of it is inside, void otherwise.
    #[default]
    Voxel,
    /// A voxel is part with its inside fraction s and void with 1 − s.
    Fraction,
    /// A voxel that the surface cuts has two doses: the inside one is part with weight s, the outside one void with 1 − s.
    Cells,
}

impl SurfaceHandling {
    /// Its name in a job.
    fn name(self) -> &'static str {
        match self {
            SurfaceHandling::Voxel => "voxel",
            SurfaceHandling::Fraction => "fraction",
            SurfaceHandling::Cells => "cells",
        }
    }

    fn refused(self, reason: &str) -> Error {
        Error::unsupported(format!("surface = \"{}\"", self.name()), reason)
    }

    /// Refuses bands of voxels on a field of cells, and the other way round.
    fn must_fit(self, layout: &DoseLayout) -> Result<()> {
        match (self, &layout.cells) {
            (SurfaceHandling::Cells, None) => {
                Err(self.refused("the model has whole voxels; [model.rays]"))
            }
            (SurfaceHandling::Voxel | SurfaceHandling::Fraction, Some(_)) => {
                Err(self
                    .refused("another objective has cells; surface = \"cells\" in every objective"))
            }
            _ => Ok(()),
        }
    }
}

/// Parameters that are bands and powers, and nothing else: a preset of the band objective.
pub trait Preset: Debug + Send + Sync + Sized + 'static {
    /// What they are for a target.
    type Bands: BuildBands;
    /// The bands and powers.
    ///
    /// # Errors
    /// [`Error::Config`] with the key of a parameter out of range.
    fn bands(&self) -> Result<Self::Bands>;
    /// How voxels that the surface cuts are weighed.
    fn surface(&self) -> SurfaceHandling;
    /// As [`MakeObjective::thresholds`].
    fn thresholds(&self) -> Option<[f64; 2]> {
        None
    }
    /// As [`MakeObjective::epsilon`].
    fn epsilon(&self) -> Option<f64> {
        None
    }
    /// As [`MakeObjective::with`].
    fn with(&self, _chosen: Chosen) -> Option<Self> {
        None
    }
}

/// Bands and powers that a target makes an objective.
pub trait BuildBands {
    /// The objective of a target.
    ///
    /// # Errors
    /// [`Error::Unsupported`] for a target or a surface that they do not go with, [`Error::Config`] for bands out of range.
    fn build<F: Field>(
        &self,
        surface: SurfaceHandling,
        input: &ObjectiveInput,
    ) -> BoxedObjective<F>;
}

impl<F: Field, P: Preset> MakeObjective<F> for P {
    fn check(&self) -> Result<()> {
        self.bands().map(drop)
    }

    fn make(&self, input: &ObjectiveInput) -> BoxedObjective<F> {
        self.bands()?.build(Preset::surface(self), input)
    }

    fn surface(&self) -> SurfaceHandling {
        Preset::surface(self)
    }

    fn thresholds(&self) -> Option<[f64; 2]> {
        Preset::thresholds(self)
    }

    fn epsilon(&self) -> Option<f64> {
        Preset::epsilon(self)
    }

    fn with(&self, chosen: Chosen) -> Option<Arc<dyn MakeObjective<F>>> {
        let other = Preset::with(self, chosen)?;
        Some(Arc::new(other))
    }
}

/// The powers of a band objective and the bands of part and void.
#[derive(Clone, Copy, Debug)]
pub struct PartAndVoid {
    /// Band of part voxels.
    pub part: Band,
    /// Band of void voxels.
    pub void: Band,
    /// Power of the distance.
    pub p: f64,
    /// Power of the norm.
    pub q: f64,
}

impl BuildBands for PartAndVoid {
    fn build<F: Field>(
        &self,
        surface: SurfaceHandling,
        input: &ObjectiveInput,
    ) -> BoxedObjective<F> {
        self.build_with_labels(surface, input, input.labels)
    }
}

impl PartAndVoid {
    /// As [`build`](BuildBands::build), with other labels than the input's.
    ///
    /// # Errors
    /// As [`build`](BuildBands::build).
    pub fn build_with_labels<F: Field>(
        &self,
        surface: SurfaceHandling,
        input: &ObjectiveInput,
        labels: &Volume<u8>,
    ) -> BoxedObjective<F> {
        check_shape("labels", &labels.grid.shape, input)?;
        must_be_part_and_void(input)?;
        surface.must_fit(input.layout)?;
        let bands = if surface == SurfaceHandling::Voxel {
            Bands::labels(
                input.layout.field_of(labels),
                &[(label::PART, self.part), (label::VOID, self.void)],
            )
        } else {
            let Shares { inside, scale } = Shares::new(surface, input, labels)?;
            Bands::Shared {
                inside,
                part: self.part,
                void: self.void,
                scale,
                widen: Vec::new(),
            }
        };
        finish(bands, self.p, self.q, input)
    }
}

/// Which share of each element of a dose field is part.
pub(crate) struct Shares {
    /// s, negative where an element does not count.
    pub(crate) inside: Vec<f32>,
    /// Factor of both weights, s and 1 − s; empty for 1.
    pub(crate) scale: Vec<f32>,
}

impl Shares {
    /// The shares of a target of part and void.
    ///
    /// # Errors
    /// [`Error::Unsupported`] for a gray target, and for a surface that the model does not have.
    pub(crate) fn new(
        surface: SurfaceHandling,
        input: &ObjectiveInput,
        labels: &Volume<u8>,
    ) -> Result<Self> {
        must_be_part_and_void(input)?;
        surface.must_fit(input.layout)?;
        let counts = |label: u8| label == label::PART || label == label::VOID;
        let mut labels = input.layout.field_of(labels);
        if surface == SurfaceHandling::Fraction {
            let mut inside = input.layout.field_of(&input.target.inside);
            elements(&mut inside, |i, s| {
                *s = if counts(labels[i]) {
                    s.clamp(0.0, 1.0)
                } else {
                    -1.0
                };
            });
            return Ok(Shares::of(inside));
        }
        // Inside cells are part and outside ones void, each weighed by its share of the voxel
        let mut scale = Vec::new();
        if let Some(cells) = &input.layout.cells {
            cells.label(&mut labels);
            scale = cells.shares(labels.len());
        }
        let inside = table(labels.len(), |i| match labels[i] {
            label::PART => 1.0,
            label::VOID => 0.0,
            _ => -1.0,
        });
        Ok(Shares { inside, scale })
    }

    /// Shares of elements that weigh the same.
    pub(crate) fn of(inside: Vec<f32>) -> Self {
        Shares {
            inside,
            scale: Vec::new(),
        }
    }

    /// Weights of an element as part and as void; None where it does not count.
    pub(crate) fn weights(&self, i: usize) -> Option<[f64; 2]> {
        let s = f64::from(self.inside[i]);
        let scale = self.scale.get(i).map_or(1.0, |&scale| f64::from(scale));
        (s >= 0.0).then_some([scale * s, scale * (1.0 - s)])
    }

    /// Sums of both weights.
    pub(crate) fn totals(&self) -> [f64; 2] {
        let weights = (0..self.inside.len()).filter_map(|i| self.weights(i));
        weights.fold([0.0; 2], |sum, w| [sum[0] + w[0], sum[1] + w[1]])
    }

    /// Multiplies the weights; no factors change nothing.
    pub(crate) fn scale(&mut self, factors: &[f32]) {
        if self.scale.is_empty() {
            self.scale = factors.to_vec();
        } else {
            let own = self.scale.iter_mut().zip(factors);
            own.for_each(|(own, factor)| *own *= factor);
        }
    }
}

/// Refuses a gray target.
fn must_be_part_and_void(input: &ObjectiveInput) -> Result<()> {
    if !input.target.gray {
        return Ok(());
    }
    Err(Error::unsupported(
        "an objective of part and void",
        "the target is gray; l2, l1, dose_matching and bclp reproduce gray values",
    ))
}

/// Bands around the target's own values: `[f − half_width, f + half_width]`, part and void weighed apart.
#[derive(Clone, Copy, Debug)]
pub struct AroundTarget {
    /// Half the width of the bands, in units of the response.
    pub half_width: f32,
    /// Weight of part voxels.
    pub part_weight: f32,
    /// Weight of void voxels.
    pub void_weight: f32,
    /// Power of the distance.
    pub p: f64,
    /// Power of the norm.
    pub q: f64,
}

impl BuildBands for AroundTarget {
    /// f is 1 in the part and 0 in the void, or the gray values of a gray target.
    fn build<F: Field>(
        &self,
        surface: SurfaceHandling,
        input: &ObjectiveInput,
    ) -> BoxedObjective<F> {
        let around = |value: f32, weight: f32| {
            Band::new(value - self.half_width, value + self.half_width, weight)
        };
        if !input.target.gray {
            let bands = PartAndVoid {
                part: around(1.0, self.part_weight),
                void: around(0.0, self.void_weight),
                p: self.p,
                q: self.q,
            };
            return bands.build(surface, input);
        }
        if surface != SurfaceHandling::Voxel {
            return Err(surface.refused(
                "the target is gray, so its values are not inside fractions; use surface = \"voxel\"",
            ));
        }
        check_shape("labels", &input.labels.grid.shape, input)?;
        finish(self.gray(input), self.p, self.q, input)
    }
}

impl AroundTarget {
    fn gray(&self, input: &ObjectiveInput) -> Bands {
        let values = input.layout.field_of(&input.target.inside);
        let labels = input.layout.field_of(input.labels);
        let shifted = |by: f32| -> Arc<[f32]> { values.iter().map(|v| v + by).collect() };
        let lower = shifted(-self.half_width);
        let upper = if self.half_width == 0.0 {
            lower.clone()
        } else {
            shifted(self.half_width)
        };
        let weight = labels.iter().map(|&label| match label {
            label::PART => self.part_weight,
            label::VOID => self.void_weight,
            _ => 0.0,
        });
        Bands::Voxels {
            lower,
            upper,
            weight: weight.collect(),
        }
    }
}

fn finish<F: Field>(bands: Bands, p: f64, q: f64, input: &ObjectiveInput) -> BoxedObjective<F> {
    check_shape("target", &input.target.inside.grid.shape, input)?;
    Ok(Box::new(BandObjective::<F>::new(
        input.layout.range(),
        bands,
        p,
        q,
        input.response.clone(),
    )?))
}

fn check_shape(what: &str, found: &[usize; 3], input: &ObjectiveInput) -> Result<()> {
    let expected = input.layout.grid.shape;
    if *found == expected {
        return Ok(());
    }
    Err(Error::shape(
        format!("{what} of the objective"),
        expected,
        found,
    ))
}

/// Largest response that a band can name, and largest weight: their squares and sums are still numbers in f32.
const LARGEST: f64 = 1e9;
/// Largest power: beyond it the largest distance alone would decide.
const HIGHEST_POWER: f64 = 100.0;

/// Refuses what is no response that a band can name.
///
/// # Errors
/// [`Error::Config`] naming the key.
pub(crate) fn finite(key: &str, value: f64) -> Result<()> {
    if value.abs() <= LARGEST {
        Ok(())
    } else {
        Err(Error::config(
            key,
            format!("found {value:?}"),
            format!("a number from {:e} to {LARGEST:e}", -LARGEST),
        ))
    }
}

/// Refuses what is no power above 0.
///
/// # Errors
/// [`Error::Config`] naming the key.
pub(crate) fn positive(key: &str, value: f64) -> Result<()> {
    if value > 0.0 && value <= HIGHEST_POWER {
        Ok(())
    } else {
        Err(Error::config(
            key,
            format!("found {value:?}"),
            format!("a number above 0 and at most {HIGHEST_POWER}"),
        ))
    }
}

/// Refuses what is below 0 or too large for a weight or a width.
///
/// # Errors
/// [`Error::Config`] naming the key.
pub(crate) fn not_negative(key: &str, value: f64) -> Result<()> {
    if (0.0..=LARGEST).contains(&value) {
        Ok(())
    } else {
        Err(Error::config(
            key,
            format!("found {value:?}"),
            format!("a number from 0 to {LARGEST:e}"),
        ))
    }
}

/// Refuses `low` at or above `high`.
///
/// # Errors
/// [`Error::Config`] naming the key of `low`.
pub(crate) fn below(low_key: &str, low: f64, high_key: &str, high: f64) -> Result<()> {
    if low < high {
        return Ok(());
    }
    Err(Error::config(
        low_key,
        format!(
            "{low_key} {} is not below {high_key} {}",
            exact(low),
            exact(high)
        ),
        format!("{low_key} < {high_key}"),
    ))
}
