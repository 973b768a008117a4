//! Cached ray matrix: what every pixel leaves in every voxel, stored where it fits.
//!
//! Rays on coarse voxels, those through the cells of a solid above all, take far longer to trace than to sum. Up to [`MOST`]
//! entries they are traced once, the rays of a pixel are added up, and dose and adjoint are sums along stored rows
//! (those of [`matrix`](crate::matrix)). Whether they are stored depends on the job alone, so a resumed run has the bits
//! of the uninterrupted one.
//!
//! # Cost
//! 16 bytes an entry, while they are made and after, 2.1 GB at most; rays that are traced before their number is known to be too large, at most a
//! sixteenth of one call and some more.

use super::Rays;
use super::batch::RayBatch;
use super::segment::Segment;
use super::traversal::{self, Ways};
use crate::matrix::Rows;
use crate::{PatternLayout, Work};
use std::ops::Range;
use tomolith_core::error::Result;
use tomolith_core::grid::VolumeGrid;
use tomolith_core::parallel::{InParallel, elements};
use tomolith_io::csr::Csr;
use tomolith_optics::light::Light;

/// Largest number of cached entries.
pub const MOST: usize = 1 << 27;

/// Bytes of an entry, by place and by pixel.
pub const BYTES: usize = 16;

/// Voxels that a ray crosses for each plane of the grid: one, and tan φ sideways (0.44 on average up to 45°), on 85 % of the planes. Memory of
/// five variants of example 12 is so estimated 3 % too low to 19 % too high.
pub(super) const CROSSED: f64 = 1.2;

/// The size of the cache in entries.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct CachedEntries {
    /// Of a pixel, for each plane of the grid across its longest side.
    pub per_pixel: f64,
    /// Of an update of a dose.
    pub per_update: f64,
}

impl CachedEntries {
    /// Entries of single pixels of so many rays each, of the light that has the most: what rays leave in one voxel is one entry.
    pub(crate) fn of_pixels(lights: &[Light], rays: usize, grid: &VolumeGrid) -> Self {
        let met = |light: &Light| {
            let rays = (rays * light.sub_angles.max(1)) as f64;
            // n rays have n places on each axis, the outermost (1 − 1/n) of a pixel apart
            let wide = |pixel: f64| 1.0 + (1.0 - 1.0 / rays) * pixel / grid.pitch_mm;
            let [across, along] = light.pixels.pitch_mm.map(wide);
            let voxels = across * along.min(grid.shape[0] as f64);
            voxels * (1.0 - (1.0 - 1.0 / voxels).powf(rays))
        };
        CachedEntries {
            per_pixel: CROSSED * lights.iter().map(met).fold(1.0, f64::max),
            per_update: 1.0,
        }
    }
}

/// Pixels that are walked at a time.
const BLOCK: usize = 64;

/// What one pixel leaves in one place: (place, pixel, energy per voxel volume). Places are voxels, those inside a solid behind
/// all others.
type Entry = (u32, u32, f32);

/// Stored walks, by place and by pixel.
#[derive(Debug)]
pub(super) struct RayMatrixCache {
    places: Rows,
    pixels: Rows,
    updates: u64,
}

impl RayMatrixCache {
    /// The walks of all rays of a model; None when they have more than `most` entries, or seem to have twice as many.
    pub(super) fn of(model: &Rays, most: usize, work: &Work) -> Result<Option<Self>> {
        let places = model.output.voxels() * (1 + usize::from(model.solid.is_some()));
        let pixels: usize = model.patterns.iter().map(PatternLayout::len).sum();
        let mut by_pixel = Csr {
            columns: places,
            starts: vec![0; pixels + 1],
            ..Csr::default()
        };
        for (light, layout) in model.patterns.iter().enumerate() {
            let chunks = model.chunks(light, 0..layout.grid.frames());
            let count = chunks.len();
            for (i, pairs) in chunks.into_iter().enumerate() {
                work.check()?;
                let lit = model.bundles(light, pairs.clone(), |_| true);
                // A chunk has all rays of its pixels, and later ones have later pixels
                for (place, pixel, deposit) in
                    model.entries(&lit, layout.elements_of_columns(pairs))
                {
                    by_pixel.starts[pixel as usize + 1] += 1;
                    by_pixel.indices.push(place);
                    by_pixel.values.push(deposit);
                }
                let found = by_pixel.entries();
                // The first chunk tells of the others, and many tell it better
                let expected = found * count / (i + 1);
                if found > most || expected > 2 * most || 16 * i > count && 8 * expected > 9 * most
                {
                    return Ok(None);
                }
            }
        }
        let mut end = 0;
        for start in &mut by_pixel.starts {
            end += *start;
            *start = end;
        }
        by_pixel.indices.shrink_to_fit();
        by_pixel.values.shrink_to_fit();
        Ok(Some(RayMatrixCache {
            updates: by_pixel.entries() as u64,
            places: Rows::of(by_pixel.transposed(), |pixel| pixel),
            pixels: Rows::of(by_pixel, |place| place),
        }))
    }

    /// Entries.
    pub(super) fn updates(&self) -> u64 {
        self.updates
    }

    /// sums[place] += what the pixels of a range leave there, for the places from `first` on.
    pub(super) fn add(&self, first: usize, x: &[f32], pixels: &Range<usize>, sums: &mut [f32]) {
        elements(sums, |i, sum| {
            (self.places).add(first + i, x, pixels, std::slice::from_mut(sum));
        });
    }

    /// grad[pixel] = Σ entries · c[place], for the pixels of a range
    pub(super) fn collect(&self, c: &[f32], pixels: &Range<usize>, grad: &mut [f32]) {
        elements(&mut grad[pixels.clone()], |pixel, sum| {
            *sum = 0.0;
            let pixel = pixels.start + pixel;
            (self.pixels).add(pixel, c, &(0..usize::MAX), std::slice::from_mut(sum));
        });
    }
}

impl Rays {
    /// What the rays of some pixels leave, in the order of pixels and places; `lit` has all segments of these.
    fn entries(&self, lit: &RayBatch, pixels: Range<usize>) -> impl Iterator<Item = Entry> {
        let inside = self.output.voxels() as u32;
        let bundles: Vec<(Ways, &[Segment], u32)> = [(&lit.straight, 0), (&lit.inside, inside)]
            .into_iter()
            .flat_map(|(bundles, first)| (0..3).map(move |axis| (axis, &bundles[axis], first)))
            .map(|(axis, segments, first)| {
                let ways = Ways::new(&self.lattice, axis);
                (ways, segments.as_slice(), first)
            })
            .collect();
        let of_block = |begin: usize| {
            let end = pixels.end.min(begin + BLOCK);
            // Segments come in the order of pixels
            let before = |segments: &[Segment], pixel: usize| {
                segments.partition_point(|segment| (segment.pixel as usize) < pixel)
            };
            let mut left: Vec<&[Segment]> = (bundles.iter())
                .map(|(_, segments, _)| &segments[before(segments, begin)..])
                .collect();
            let (mut all, mut found) = (Vec::new(), Vec::new());
            for pixel in begin..end {
                found.clear();
                for ((ways, _, first), left) in bundles.iter().zip(&mut left) {
                    let segments = left.iter().take_while(|s| s.pixel as usize == pixel);
                    let count = segments.count();
                    for segment in &left[..count] {
                        traversal::for_each(self.gait, *ways, segment, |voxel, deposit| {
                            found.push((first + voxel as u32, deposit));
                        });
                    }
                    *left = &left[count..];
                }
                add_up(&mut found);
                all.extend(found.iter().map(|&(place, sum)| (place, pixel as u32, sum)));
            }
            all
        };
        let blocks: Vec<Vec<Entry>> = pixels.clone().step_by(BLOCK).par_map(of_block);
        blocks.into_iter().flatten()
    }
}

/// Sorts by place, and makes one of those at one place.
fn add_up(found: &mut Vec<(u32, f32)>) {
    // Not stable, but the same for the same rays
    found.sort_unstable_by_key(|&(place, _)| place);
    found.dedup_by(|next, sum| {
        let same = next.0 == sum.0;
        if same {
            sum.1 += next.1;
        }
        same
    });
}
