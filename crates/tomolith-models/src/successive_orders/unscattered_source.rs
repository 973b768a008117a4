//! The unscattered light of one light as a source: what cells of scattered light need to know of it.

use super::harmonics::Harmonic;
use crate::Work;
use std::ops::Range;
use tomolith_core::dose::scattered::{Bins, LightOnCells};
use tomolith_core::error::Result;
use tomolith_core::field::HostField;

/// What one field of unscattered light tells: the moment of each of these harmonics is the field times its weight.
#[derive(Clone, Debug, PartialEq)]
pub(super) struct Channel(pub(super) Vec<(Harmonic, f64)>);

impl Channel {
    /// The weight of a harmonic; None when the field says nothing about it.
    pub(super) fn weight(&self, harmonic: Harmonic) -> Option<f64> {
        let found = self.0.iter().find(|(known, _)| *known == harmonic);
        found.map(|&(_, weight)| weight)
    }
}

/// The unscattered light of one light on cells, by direction. Light on cells is smooth where the cells are, so pixels are taken together
/// to larger ones ([`Bins`](super::bins::Bins)).
pub(super) trait UnscatteredSource: Send + Sync {
    /// What each field tells.
    fn channels(&self) -> &[Channel];

    /// The fields of some of this light's frames, for the values of its pixels.
    fn fields(&self, frames: Range<usize>, x: &[f32], work: &Work) -> Result<Vec<HostField>>;

    /// grad += transpose of [`fields`](Self::fields); `grad` has the pixels of all frames
    fn add_adjoint(
        &self,
        frames: Range<usize>,
        fields: &[HostField],
        grad: &mut [f32],
        work: &Work,
    ) -> Result<()>;

    /// Cells that are lit by pixels, of all fields.
    fn updates(&self) -> u64;

    /// The source as data: its bins, and their light on cells; None where that is too much.
    fn form(&self, work: &Work) -> Result<Option<(Bins, LightOnCells)>>;
}
