//! Batches of rays: pixels in chunks, and the segments or column rays that they send.

use super::Rays;
use super::column_rays::ColumnRay;
use super::segment::{Lattice, Segment};
use super::solid::Pieces;
use super::traversal::{self, Ways};
use crate::Work;
use std::ops::Range;
use tomolith_core::error::Result;
use tomolith_core::parallel::{InParallel, table};
use tomolith_optics::space::PathSegment;

/// Rays whose segments are made and used together: they stay in the second-level cache.
pub(super) const CHUNK: usize = 1 << 14;

/// Segments by major axis.
pub(super) type Bundles = [Vec<Segment>; 3];

/// Segments of unscattered light on voxels, of its pieces inside a solid apart, and of scattered light on coarse cells.
#[derive(Default)]
pub(super) struct RayBatch {
    pub(super) straight: Bundles,
    pub(super) inside: Bundles,
    pub(super) scattered: Bundles,
}

/// What a segment is one of in [`RayBatch`].
#[derive(Clone, Copy)]
pub(super) enum Place {
    Straight,
    Inside,
    Scattered,
}

impl Rays {
    /// (Frame, column) pairs of some frames of a light, in runs that send about [`CHUNK`] rays each.
    pub(super) fn chunks(&self, light: usize, frames: Range<usize>) -> Vec<Range<usize>> {
        let layout = &self.patterns[light];
        let columns = layout.grid.columns;
        let rays = self.sources[light].rays();
        let (mut chunks, mut first, mut sum) = (Vec::new(), frames.start * columns, 0);
        for i in frames.start * columns..frames.end * columns {
            sum += layout.runs[i].count as usize * rays;
            if sum >= CHUNK {
                chunks.push(first..i + 1);
                (first, sum) = (i + 1, 0);
            }
        }
        if sum > 0 {
            chunks.push(first..frames.end * columns);
        }
        chunks
    }

    /// Calls `visit` with the segments of some frames of a light, of pixels that `wants` chooses, chunk by chunk.
    pub(super) fn for_each_chunk(
        &self,
        light: usize,
        frames: Range<usize>,
        wants: impl Fn(usize) -> bool + Sync,
        work: &Work,
        mut visit: impl FnMut(&RayBatch),
    ) -> Result<()> {
        for pairs in self.chunks(light, frames) {
            work.check()?;
            visit(&self.bundles(light, pairs, &wants));
        }
        Ok(())
    }

    /// Passes the column rays of level light on in the same way.
    pub(super) fn for_each_sheets(
        &self,
        light: usize,
        frames: Range<usize>,
        wants: impl Fn(usize) -> bool + Sync,
        work: &Work,
        mut visit: impl FnMut(&[ColumnRay]),
    ) -> Result<()> {
        if let Some(cached) = self.cached_column_rays(work)? {
            cached
                .of_pixels(&self.patterns[light].elements_of(frames))
                .for_each(visit);
            return Ok(());
        }
        for pairs in self.chunks(light, frames) {
            work.check()?;
            visit(&self.column_rays(light, pairs, &wants));
        }
        Ok(())
    }

    /// Segments of some (frame, column) pairs, of pixels that `wants` chooses; in the order of pixels and rays.
    pub(super) fn bundles(
        &self,
        light: usize,
        pairs: Range<usize>,
        wants: impl Fn(usize) -> bool + Sync,
    ) -> RayBatch {
        let (source, layout) = (&self.sources[light], &self.patterns[light]);
        let columns = layout.grid.columns;
        let area = layout.grid.pixel_mm2() / source.rays() as f64;
        let of_pair = |pair: usize| {
            let run = layout.runs[pair];
            let (mut found, mut pieces) = (Vec::new(), Pieces::default());
            for i in 0..run.count as usize {
                let pixel = run.offset + i;
                if !wants(pixel) {
                    continue;
                }
                let row = run.bottom as usize + i;
                let mut count = 0;
                let mut walk = |mut path_segment: PathSegment| {
                    let scatter_grid = self
                        .scatter_grid
                        .as_ref()
                        .filter(|_| path_segment.order > 0);
                    if scatter_grid.is_some_and(|scatter_grid| scatter_grid.is_fluence(light)) {
                        path_segment.uptake.active_per_mm = 1.0;
                    }
                    let lattice =
                        scatter_grid.map_or(&self.lattice, |scatter_grid| &scatter_grid.lattice);
                    let segment = lattice.segment(&path_segment, area, pixel as u32);
                    let Some((axis, segment)) = segment else {
                        return;
                    };
                    let mut push = |place, piece| found.push((place, axis, piece));
                    match &self.solid {
                        _ if scatter_grid.is_some() => push(Place::Scattered, segment),
                        None => push(Place::Straight, segment),
                        Some(solid) => {
                            solid.inside(&path_segment.ray, path_segment.length, &mut pieces);
                            let step = path_segment.ray.direction[axis] / lattice.pitch();
                            segment.cut(step, pieces.found(), |is_inside, piece| {
                                let place = if is_inside {
                                    Place::Inside
                                } else {
                                    Place::Straight
                                };
                                push(place, piece);
                            });
                        }
                    }
                };
                source.for_each_path_segment(pair / columns, pair % columns, row, |path_segment| {
                    count += 1;
                    let points = || source.points([pair, row, count]);
                    self.accumulation.for_each(path_segment, points, &mut walk);
                });
            }
            found
        };
        let by_pair: Vec<Vec<(Place, usize, Segment)>> = pairs.into_iter().par_map(of_pair);
        let mut lit = RayBatch::default();
        for (place, axis, segment) in by_pair.into_iter().flatten() {
            let bundles = match place {
                Place::Straight => &mut lit.straight,
                Place::Inside => &mut lit.inside,
                Place::Scattered => &mut lit.scattered,
            };
            bundles[axis].push(segment);
        }
        lit
    }

    /// dose += what segments of pixels of these values leave
    pub(super) fn add(&self, lattice: &Lattice, bundles: &Bundles, x: &[f32], dose: &mut [f32]) {
        for (axis, segments) in bundles.iter().enumerate() {
            traversal::add(self.gait, Ways::new(lattice, axis), segments, x, dose);
        }
    }

    /// grad += what segments collect of a cotangent
    pub(super) fn collect(
        &self,
        lattice: &Lattice,
        bundles: &Bundles,
        c: &[f32],
        grad: &mut [f32],
    ) {
        for (axis, segments) in bundles.iter().enumerate() {
            let ways = Ways::new(lattice, axis);
            let sum = |i: usize| traversal::collect(self.gait, ways, &segments[i], c);
            let sums = table(segments.len(), sum);
            for (segment, sum) in segments.iter().zip(sums) {
                grad[segment.pixel as usize] += sum;
            }
        }
    }
}
