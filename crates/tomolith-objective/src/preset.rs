//! What the presets share: how part and void become bands.

use super::band::{Band, BandObjective, Bands};
use super::buffer::near_the_other_kind;
use super::{BoxedObjective, Chosen, MakeObjective, ObjectiveInput, threshold};
use schemars::JsonSchema;
use serde::{Deserialize, Serialize};
use std::borrow::Cow;
use std::sync::Arc;
use tomolith_core::dose::DoseLayout;
use tomolith_core::error::{Error, Result, in_range};
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

/// A preset of the band objective: parameters in their ranges.
#[derive(Clone, Debug)]
pub(crate) struct BandPreset {
    pub(crate) part: Band,
    pub(crate) void: Band,
    /// Powers of the distance and of the norm.
    pub(crate) p: f64,
    pub(crate) q: f64,
    pub(crate) surface: SurfaceHandling,
    /// Half the width of the bands around the values of a gray target; None for a preset that refuses one.
    pub(crate) gray_half_width: Option<f32>,
    /// Voxels this near to one of the other kind do not count, mm.
    pub(crate) buffer_mm: f64,
    /// As [`MakeObjective::thresholds`].
    pub(crate) thresholds: Option<[f64; 2]>,
    /// As [`MakeObjective::epsilon`].
    pub(crate) epsilon: Option<f64>,
    /// Parameters of which the program chooses those that are None.
    pub(crate) open: Option<threshold::Params>,
}

impl BandPreset {
    pub(crate) fn new([part, void]: [Band; 2], [p, q]: [f64; 2], surface: SurfaceHandling) -> Self {
        BandPreset {
            part,
            void,
            p,
            q,
            surface,
            gray_half_width: None,
            buffer_mm: 0.0,
            thresholds: None,
            epsilon: None,
            open: None,
        }
    }

    /// Bands around 1 in the part and 0 in the void, or around the values of a gray target.
    pub(crate) fn around_target(
        half_width: f32,
        [of_part, of_void]: [f32; 2],
        powers: [f64; 2],
        surface: SurfaceHandling,
    ) -> Self {
        let around = |value, weight| Band::new(value - half_width, value + half_width, weight);
        let bands = [around(1.0, of_part), around(0.0, of_void)];
        BandPreset {
            gray_half_width: Some(half_width),
            ..BandPreset::new(bands, powers, surface)
        }
    }

    fn part_and_void(&self, input: &ObjectiveInput) -> Result<Bands> {
        must_be_part_and_void(input)?;
        self.surface.must_fit(input.layout)?;
        let labels = if self.buffer_mm > 0.0 {
            Cow::Owned(without_buffer(input, self.buffer_mm))
        } else {
            Cow::Borrowed(input.labels)
        };
        if self.surface == SurfaceHandling::Voxel {
            return Ok(Bands::labels(
                input.layout.field_of(&labels),
                &[(label::PART, self.part), (label::VOID, self.void)],
            ));
        }
        let Shares { inside, scale } = Shares::new(self.surface, input, &labels)?;
        Ok(Bands::Shared {
            inside,
            part: self.part,
            void: self.void,
            scale,
            widen: Vec::new(),
        })
    }

    fn around_values(&self, half_width: f32, input: &ObjectiveInput) -> Result<Bands> {
        if self.surface != SurfaceHandling::Voxel {
            return Err(self.surface.refused(
                "the target is gray, so its values are not inside fractions; use surface = \"voxel\"",
            ));
        }
        let values = input.layout.field_of(&input.target.inside);
        let labels = input.layout.field_of(input.labels);
        let shifted = |by: f32| -> Arc<[f32]> { values.iter().map(|v| v + by).collect() };
        let lower = shifted(-half_width);
        let upper = if half_width == 0.0 {
            lower.clone()
        } else {
            shifted(half_width)
        };
        let weight = labels.iter().map(|&label| match label {
            label::PART => self.part.weight,
            label::VOID => self.void.weight,
            _ => 0.0,
        });
        Ok(Bands::Voxels {
            lower,
            upper,
            weight: weight.collect(),
        })
    }
}

impl<F: Field> MakeObjective<F> for BandPreset {
    fn make(&self, input: &ObjectiveInput) -> BoxedObjective<F> {
        check_shape("labels", &input.labels.grid.shape, input)?;
        check_shape("target", &input.target.inside.grid.shape, input)?;
        let bands = match self.gray_half_width {
            Some(half_width) if input.target.gray => self.around_values(half_width, input)?,
            _ => self.part_and_void(input)?,
        };
        Ok(Box::new(BandObjective::<F>::new(
            input.layout.range(),
            bands,
            self.p,
            self.q,
            input.response.clone(),
        )?))
    }

    fn surface(&self) -> SurfaceHandling {
        self.surface
    }

    fn thresholds(&self) -> Option<[f64; 2]> {
        self.thresholds
    }

    fn epsilon(&self) -> Option<f64> {
        self.epsilon
    }

    fn with(&self, chosen: Chosen) -> Option<Arc<dyn MakeObjective<F>>> {
        let other = self.open.as_ref()?.with(chosen)?;
        Some(Arc::new(other))
    }
}

/// The labels, voxels of a buffer at the surface as if outside.
fn without_buffer(input: &ObjectiveInput, buffer_mm: f64) -> Volume<u8> {
    let mut labels = input.labels.clone();
    let buffer = near_the_other_kind(input.target, buffer_mm);
    elements(&mut labels.values, |i, l| {
        if buffer[i] {
            *l = label::OUTSIDE;
        }
    });
    labels
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
    /// Refuses a gray target, and a surface that the model does not have.
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
            let pairs = self.scale.iter_mut().zip(factors);
            pairs.for_each(|(scale, factor)| *scale *= factor);
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
pub(crate) const LARGEST: f64 = 1e9;
/// Largest power: beyond it the largest distance alone would decide.
pub(crate) const HIGHEST_POWER: f64 = 100.0;

/// Refuses what is below 0 or too large for a weight.
pub(crate) fn not_negative(key: &str, value: f64) -> Result<()> {
    let accepted = format!("a number from 0 to {LARGEST:e}");
    in_range((0.0..=LARGEST).contains(&value), key, value, accepted)
}

/// Refuses `low` at or above `high`.
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
