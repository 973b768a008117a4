//! Walks that are kept: what every pixel leaves in every voxel, stored where that is little.
//!
//! Rays on coarse voxels, those through the cells of a solid above all, take far longer to trace than to sum. Up to [`MOST`]
//! entries their walks are done once, the rays of a pixel are added up, and dose and adjoint are sums along stored rows
//! (those of [`matrix`](crate::models::matrix)). Whether walks are kept depends on the job alone, so a resumed run has the bits
//! of the uninterrupted one.
//!
//! # Cost
//! 16 bytes an entry, 540 MB at most. What is walked before it is known to be too much costs some seconds at most.

use super::segment::Segment;
use super::walk::{self, Ways};
use super::{Lit, Rays};
use crate::error::{Error, Result};
use crate::io::csr::Csr;
use crate::models::matrix::Rows;
use crate::models::{PatternLayout, Run};
use rayon::prelude::*;
use std::ops::Range;

/// Entries that are kept at most.
pub(crate) const MOST: usize = 1 << 25;

/// Bytes of an entry, by place and by pixel.
pub(crate) const BYTES: usize = 16;

/// What one pixel leaves in one place: (place, pixel, energy per voxel volume). Places are voxels, those inside a solid behind
/// all others.
type Entry = (u32, u32, f32);

/// Stored walks, by place and by pixel.
#[derive(Debug)]
pub(super) struct Kept {
    places: Rows,
    pixels: Rows,
    updates: u64,
}

impl Kept {
    /// The walks of all rays of a model; None when they have more than `most` entries, or seem to have twice as many.
    pub(super) fn of(model: &Rays, most: usize, run: &Run) -> Result<Option<Self>> {
        let mut entries = Vec::new();
        for (light, layout) in model.patterns.iter().enumerate() {
            let chunks = model.chunks(light, 0..layout.grid.frames());
            let count = chunks.len();
            for (i, pairs) in chunks.into_iter().enumerate() {
                if run.is_cancelled() {
                    return Err(Error::Cancelled);
                }
                let lit = model.bundles(light, pairs, |_| true);
                entries.extend(merged(model.entries(&lit)));
                // The first chunk tells of the others
                if entries.len() > most || i == 0 && entries.len() * count > 2 * most {
                    return Ok(None);
                }
            }
        }
        let pixels = model.patterns.iter().map(PatternLayout::len).sum();
        let places = model.outputs[0].voxels() * (1 + usize::from(model.solid.is_some()));
        let by_place = Csr::from_entries(places, pixels, &entries);
        drop(entries);
        Ok(Some(Kept {
            updates: by_place.entries() as u64,
            pixels: Rows::of(&by_place.transposed(), |place| place),
            places: Rows::of(&by_place, |pixel| pixel),
        }))
    }

    /// Entries.
    pub(super) fn updates(&self) -> u64 {
        self.updates
    }

    /// sums[place] += what the pixels of a range leave there, for the places from `first` on.
    pub(super) fn add(&self, first: usize, x: &[f32], pixels: &Range<usize>, sums: &mut [f32]) {
        let each = |(i, sum): (usize, &mut f32)| {
            (self.places).add(first + i, x, pixels, std::slice::from_mut(sum));
        };
        sums.par_iter_mut()
            .with_min_len(256)
            .enumerate()
            .for_each(each);
    }

    /// grad[pixel] = Σ entries · c[place]
    pub(super) fn collect(&self, c: &[f32], grad: &mut [f32]) {
        let each = |(pixel, sum): (usize, &mut f32)| {
            *sum = 0.0;
            (self.pixels).add(pixel, c, &(0..usize::MAX), std::slice::from_mut(sum));
        };
        grad.par_iter_mut()
            .with_min_len(256)
            .enumerate()
            .for_each(each);
    }
}

impl Rays {
    /// What segments leave, piece by piece.
    fn entries(&self, lit: &Lit) -> Vec<Entry> {
        let inside = self.outputs[0].voxels() as u32;
        let mut all = Vec::new();
        for (bundles, first) in [(&lit.straight, 0), (&lit.inside, inside)] {
            for (axis, segments) in bundles.iter().enumerate() {
                let ways = Ways::new(&self.lattice, axis);
                let of_segment = |found: &mut Vec<Entry>, segment: &Segment| {
                    walk::for_each(self.gait, ways, segment, |voxel, deposit| {
                        found.push((first + voxel as u32, segment.pixel, deposit));
                    });
                };
                // In the order of the segments, whatever the threads
                let found: Vec<Vec<Entry>> = segments
                    .par_chunks(1024)
                    .map(|segments| {
                        let mut found = Vec::new();
                        segments
                            .iter()
                            .for_each(|segment| of_segment(&mut found, segment));
                        found
                    })
                    .collect();
                all.extend(found.into_iter().flatten());
            }
        }
        all
    }
}

/// Sorted by pixel and place, with what belongs together added up in the order given.
fn merged(mut entries: Vec<Entry>) -> Vec<Entry> {
    entries.par_sort_by_key(|&(place, pixel, _)| (pixel, place));
    entries.dedup_by(|next, sum| {
        let same = (next.0, next.1) == (sum.0, sum.1);
        if same {
            sum.2 += next.2;
        }
        same
    });
    entries
}
