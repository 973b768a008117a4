//! Distances between the predicted print's surface and the target's.
//!
//! # What it models
//! Both surfaces are iso-surfaces ([`isosurface`](super::isosurface)): the response at the gel threshold, and the
//! target's inside fraction at ½ (0 and 1 by label when no fraction is known). From every corner of the one the distance
//! to the nearest triangle of the other is taken, both ways. A corner weighs a third of the area of its triangles, so
//! mean and 95th percentile are over the surfaces' area, of both together; the Hausdorff distance is the largest of all. Where it
//! is, the other body is looked up: a corner of the print that lies in no target is print without target, one that lies in the
//! target is the end of a print that should go on; and the other way round for corners of the target.
//!
//! # Limits
//! Distances are exact up to f32 between the triangulated surfaces. The iso-surface of a fraction lies within about
//! 0.1 pitch of a flat surface, that of bare labels within half a pitch. Grids of more than 2·10⁸ voxels are averaged
//! over 2³ voxels first (or 3³, …), and so are rough surfaces of more than 4·10⁶ triangles, or of more than there is memory for; the result says so.
//!
//! # Cost
//! A few seconds at 400³ on two cores; memory for the triangles (36 bytes each) and their boxes.
//!
//! # Example
//! A print that is 0.1 mm too large on one side of a slab, and right on the other:
//! ```
//! use tomolith_core::grid::{Volume, VolumeGrid};
//! use tomolith_metrics::print::Print;
//! use tomolith_core::target::label::{PART, VOID};
//! let grid = VolumeGrid::centered([1, 1, 40], 0.1);
//! let ramp = |shift: f64| (0..40).map(|i| (0.5 - (grid.x(i) - shift)).clamp(0.0, 1.0) as f32).collect::<Vec<_>>();
//! let inside = Volume { grid: grid.clone(), values: ramp(0.0) }; // ends at x = 0
//! let response = Volume { grid: grid.clone(), values: ramp(0.1) }; // ends at x = 0.1
//! let labels = Volume { values: inside.values.iter().map(|&s| if s >= 0.5 { PART } else { VOID }).collect(), grid };
//! let print = Print::new(&labels, &response).unwrap().with_inside(&inside).unwrap().with_threshold(0.5).unwrap();
//! let distance = print.distance().unwrap();
//! assert!((distance.hausdorff_mm - 0.1).abs() < 1e-5);
//! assert_eq!(distance.farthest.side.words(), "print without target");
//! ```

use super::isosurface::{Isosurface, isosurface_within, rows_of};
use super::nearest::TriangleTree;
use super::print::Print;
use rayon::slice::ParallelSliceMut;
use serde::Serialize;
use std::sync::{Arc, Mutex, PoisonError};
use tomolith_core::dose::Work;
use tomolith_core::grid::VolumeGrid;
use tomolith_core::parallel::{InParallel, table};

/// Voxels up to which surfaces are taken on the grid of the print.
const FULL_RESOLUTION: usize = 200_000_000;
/// Triangles of one surface up to which it is used; a smooth part has about a million at 400³ voxels.
pub(super) const MOST_TRIANGLES: usize = 4_000_000;
/// Corners whose nearest points are looked up one after the other, each search beginning at the answer of the one before.
const RUN: usize = 1024;

/// Share of the work on a print that distances are; of these, finding a surface, and the distances to it.
const MEASURING: f64 = 0.5;
const FINDING: f64 = 0.2;
const NEAREST: f64 = 0.3;

/// Which body is without the other where surfaces are apart.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize)]
#[serde(rename_all = "snake_case")]
pub enum Side {
    /// What is printed there should not be.
    PrintWithoutTarget,
    /// What should be printed there is not.
    TargetWithoutPrint,
}

impl Side {
    /// In words.
    #[must_use]
    pub fn words(self) -> &'static str {
        match self {
            Side::PrintWithoutTarget => "print without target",
            Side::TargetWithoutPrint => "target without print",
        }
    }
}

/// Where two surfaces are farthest apart.
#[derive(Clone, Copy, Debug, PartialEq, Serialize)]
pub struct Farthest {
    /// The corner [x, y, z] of one surface that is farthest from the other, mm.
    #[serde(rename = "at_xyz_mm")]
    pub at_mm: [f64; 3],
    /// What is wrong there.
    pub side: Side,
}

/// Distances between two surfaces, mm.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct SurfaceDistance {
    /// Mean over the area of both surfaces.
    pub mean_mm: f64,
    /// 95 % of the area of both surfaces is nearer.
    pub p95_mm: f64,
    /// Largest distance, in both directions (Hausdorff).
    pub hausdorff_mm: f64,
    /// Where that is.
    pub farthest: Farthest,
    /// Voxels per edge that were averaged before the surfaces were taken; 1: none.
    pub coarsened: usize,
}

/// The print's surface, and how far each of its corners is from the target's.
#[derive(Clone, Debug, PartialEq)]
pub struct Deviation {
    /// The print's surface.
    pub surface: Isosurface,
    /// Distance of each corner to the target's surface, µm: positive where the corner lies outside of the target (the print is too
    /// large there), negative where it lies in it (too small).
    pub off_um: Vec<f32>,
    /// Voxels per edge that were averaged before the surfaces were taken; 1: none.
    pub coarsened: usize,
}

impl Deviation {
    /// Signs distances by which body is without the other.
    fn of(print: &Print<'_>, surface: Isosurface, distances_mm: &[f32], coarsened: usize) -> Self {
        let signed = |i: usize| {
            let at_mm = surface.corners[i].map(f64::from);
            let share = value_at(print.grid(), at_mm, |i, row| print.target_row(i, row));
            let off_um = 1e3 * distances_mm[i];
            if share < 0.5 { off_um } else { -off_um }
        };
        let off_um = table(distances_mm.len(), signed);
        Deviation {
            surface,
            off_um,
            coarsened,
        }
    }
}

/// Signed distances of the print's surface, `None` when one of the surfaces is empty. Where the target has no print at all, there is no
/// surface to show it.
pub(super) fn deviation(print: &Print<'_>) -> Option<Deviation> {
    let Surfaces {
        printed,
        target,
        coarsened,
        work,
        ..
    } = surfaces(print, FULL_RESOLUTION)?;
    let distances = distances(&printed, &target.tree, 1, &work.part(NEAREST));
    let distances: Vec<f32> = distances.iter().map(|sample| sample.0).collect();
    (!work.is_canceled()).then(|| Deviation::of(print, printed, &distances, coarsened))
}

/// Distances of surfaces, and what a [`Deviation`] takes of them.
pub(super) struct Compared {
    pub(super) distance: SurfaceDistance,
    printed: Isosurface,
    /// Of all corners of the print's surface, mm; of none where only some were looked at.
    of_print: Vec<f32>,
}

impl Compared {
    /// The signed distances, where they were taken from all corners.
    pub(super) fn deviation(self, print: &Print<'_>) -> Option<Deviation> {
        let coarsened = self.distance.coarsened;
        let is_whole = self.of_print.len() == self.printed.corners.len();
        is_whole.then(|| Deviation::of(print, self.printed, &self.of_print, coarsened))
    }
}

/// Distances for a print, `None` when one of the surfaces is empty.
pub(super) fn compared(print: &Print<'_>) -> Option<Compared> {
    compared_on(print, FULL_RESOLUTION)
}

/// A target's surface, made when it is first needed: prints of one target on the same voxels may share it.
#[derive(Default)]
pub struct TargetSurface(Mutex<Option<Arc<Reference>>>);

/// A target's surface, ready for queries.
struct Reference {
    /// Voxels per edge that were averaged.
    coarsened: usize,
    surface: Isosurface,
    tree: TriangleTree,
}

impl TargetSurface {
    /// On voxels that are averaged so far; None where it has more than `most` corners.
    fn reference(
        &self,
        print: &Print<'_>,
        coarsened: usize,
        most: usize,
        work: &Work,
    ) -> Option<Arc<Reference>> {
        let mut made = self.0.lock().unwrap_or_else(PoisonError::into_inner);
        let is_same = |reference: &&Arc<Reference>| {
            reference.coarsened == coarsened && reference.surface.corners.len() <= most
        };
        if let Some(found) = made.as_ref().filter(is_same) {
            return Some(found.clone());
        }
        let fill = |i, row: &mut [f32]| print.target_row(i, row);
        let surface = surface(print.grid(), coarsened, 0.5, fill, most, work)?;
        let reference = Arc::new(Reference {
            coarsened,
            tree: TriangleTree::new(&surface, work),
            surface,
        });
        *made = Some(reference.clone());
        Some(reference)
    }
}

/// The print's surface and the target's.
struct Surfaces {
    threshold: f64,
    printed: Isosurface,
    target: Arc<Reference>,
    /// Voxels per edge that were averaged.
    coarsened: usize,
    /// What is left of measuring them.
    work: Work,
}

/// Both surfaces on as many voxels as distances are taken on; `None` when one of them is empty.
fn surfaces(print: &Print<'_>, most_voxels: usize) -> Option<Surfaces> {
    let threshold = print.gel_threshold()?;
    let grid = print.grid();
    let mut coarsened = (1..).find(|f| grid.len() / (f * f * f) <= most_voxels)?;
    let work = print.work.part(MEASURING);
    // A closed surface has twice as many triangles as corners
    let most = print.most_triangles / 2;
    let (printed, target) = loop {
        let fill = |i, row: &mut [f32]| print.printed_row(i, threshold, row);
        let printed = surface(grid, coarsened, threshold, fill, most, &work.part(FINDING));
        let target = || {
            print
                .target_surface
                .reference(print, coarsened, most, &work.part(FINDING))
        };
        if let Some(both) = printed.and_then(|printed| Some((printed, target()?))) {
            break both;
        }
        coarsened += 1;
    };
    (!printed.is_empty() && !target.surface.is_empty()).then_some(Surfaces {
        threshold,
        printed,
        target,
        coarsened,
        work,
    })
}

fn compared_on(print: &Print<'_>, most_voxels: usize) -> Option<Compared> {
    let grid = print.grid();
    let Surfaces {
        threshold,
        printed,
        target,
        coarsened,
        work,
    } = surfaces(print, most_voxels)?;
    let each = |surface: &Isosurface| surface.corners.len().div_ceil(print.most_corners).max(1);
    let steps = [each(&printed), each(&target.surface)];
    let mut samples = distances(&printed, &target.tree, steps[0], &work.part(NEAREST));
    let of_print = TriangleTree::new(&printed, &work);
    let back = distances(&target.surface, &of_print, steps[1], &work.part(NEAREST));
    if work.is_canceled() {
        return None;
    }
    let (of_print, of_target) = (largest(&samples)?, largest(&back)?);
    let farthest = if samples[of_print].0 >= back[of_target].0 {
        let at_mm = printed.corners[place(of_print, steps[0])].map(f64::from);
        let share = value_at(grid, at_mm, |i, row| print.target_row(i, row));
        farthest(at_mm, share < 0.5)
    } else {
        let at_mm = target.surface.corners[place(of_target, steps[1])].map(f64::from);
        let response = value_at(grid, at_mm, |i, row| print.printed_row(i, threshold, row));
        farthest(at_mm, response > threshold)
    };
    let is_whole = steps[0] == 1;
    let of_print = samples.iter().map(|sample| sample.0);
    let of_print = of_print
        .take(if is_whole { samples.len() } else { 0 })
        .collect();
    samples.extend(back);
    samples.par_sort_unstable_by(|a, b| a.0.total_cmp(&b.0).then(a.1.total_cmp(&b.1)));
    let area: f64 = samples.iter().map(|s| s.1).sum();
    let mut below = 0.0;
    let p95 = samples.iter().find(|s| {
        below += s.1;
        below >= 0.95 * area
    });
    let distance = SurfaceDistance {
        mean_mm: samples.iter().map(|s| f64::from(s.0) * s.1).sum::<f64>() / area,
        p95_mm: f64::from(p95?.0),
        hausdorff_mm: f64::from(samples.last()?.0),
        farthest,
        coarsened,
    };
    Some(Compared {
        distance,
        printed,
        of_print,
    })
}

fn farthest(at_mm: [f64; 3], is_excess: bool) -> Farthest {
    let side = if is_excess {
        Side::PrintWithoutTarget
    } else {
        Side::TargetWithoutPrint
    };
    Farthest { at_mm, side }
}

/// Position of the largest distance, the first of equal ones.
fn largest(samples: &[(f32, f64)]) -> Option<usize> {
    let indices = 0..samples.len();
    indices.reduce(|best, i| {
        if samples[i].0 > samples[best].0 {
            i
        } else {
            best
        }
    })
}

/// A field at a place: linear between the middles of voxels, beyond the outermost as there.
fn value_at(grid: &VolumeGrid, place_mm: [f64; 3], fill: impl Fn(usize, &mut [f32])) -> f64 {
    let first = [grid.x(0), grid.y(0), grid.z(0)];
    let neighbors = |axis: usize| {
        let last = grid.shape[2 - axis] - 1;
        let at = ((place_mm[axis] - first[axis]) / grid.pitch_mm).clamp(0.0, last as f64);
        let share = at.fract();
        let low = at as usize;
        [(low, 1.0 - share), ((low + 1).min(last), share)]
    };
    let [xs, ys, zs] = [0, 1, 2].map(neighbors);
    let mut sum = 0.0;
    for (iz, z) in zs {
        for (iy, y) in ys {
            for (ix, x) in xs {
                let mut voxel = [0.0f32];
                fill(grid.index(iz, iy, ix), &mut voxel);
                sum += x * y * z * f64::from(voxel[0]);
            }
        }
    }
    sum
}

/// Iso-surface, after averaging over `factor`³ voxels; None where it has more than `most` corners.
fn surface(
    grid: &VolumeGrid,
    factor: usize,
    level: f64,
    fill: impl Fn(usize, &mut [f32]) + Sync,
    most: usize,
    work: &Work,
) -> Option<Isosurface> {
    if factor == 1 {
        return isosurface_within(grid, level, fill, most, work);
    }
    let (coarse, values) = averaged(grid, factor, &fill, &work.part(0.7));
    let fill = rows_of(&values);
    isosurface_within(&coarse, level, fill, most, &work.part(0.3))
}

/// Means over blocks of voxels; blocks at the far ends may be cut off.
fn averaged(
    grid: &VolumeGrid,
    factor: usize,
    fill: &(impl Fn(usize, &mut [f32]) + Sync),
    work: &Work,
) -> (VolumeGrid, Vec<f32>) {
    let shape = grid.shape.map(|n| n.div_ceil(factor));
    let pitch_mm = grid.pitch_mm * factor as f64;
    let [low, _] = grid.bounds_mm();
    let coarse = VolumeGrid {
        shape,
        pitch_mm,
        height_mm: pitch_mm,
        // The blocks start at the low corner
        center_mm: std::array::from_fn(|i| low[i] + 0.5 * pitch_mm * shape[2 - i] as f64),
    };
    let range = |i: usize, axis: usize| i * factor..((i + 1) * factor).min(grid.shape[axis]);
    let mut values = vec![0.0; coarse.len()];
    let planes = work.steps(shape[0]);
    values
        .chunks_mut(shape[1] * shape[2])
        .enumerate()
        .par_each_with(
            || (vec![0.0f32; grid.shape[2]], vec![0.0f64; shape[2]]),
            |(row, sums), (z, plane)| {
                if planes.is_canceled() {
                    return;
                }
                planes.add(1);
                for (y, out) in plane.chunks_mut(shape[2]).enumerate() {
                    sums.fill(0.0);
                    for (iz, iy) in range(z, 0).flat_map(|z| range(y, 1).map(move |y| (z, y))) {
                        fill(grid.index(iz, iy, 0), row);
                        for (sum, block) in sums.iter_mut().zip(row.chunks(factor)) {
                            block.iter().for_each(|&value| *sum += f64::from(value));
                        }
                    }
                    let rows = range(z, 0).len() * range(y, 1).len();
                    for (x, (out, sum)) in out.iter_mut().zip(&*sums).enumerate() {
                        *out = (sum / (rows * range(x, 2).len()) as f64) as f32;
                    }
                }
            },
        );
    (coarse, values)
}

/// Which of `step` corners in a row is taken the `i`-th time: not always the same, since corners lie in pairs on both sides of a row of voxels.
fn place(i: usize, step: usize) -> usize {
    let golden = 0.618_033_988_749_895;
    i * step + ((i as f64 * golden).fract() * step as f64) as usize
}

/// For one of every `step` corners of `from`: the distance to the triangles of a tree, mm, and its share of the area, mm².
fn distances(from: &Isosurface, tree: &TriangleTree, step: usize, work: &Work) -> Vec<(f32, f64)> {
    let corners = 0..from.corners.len() / step;
    let corners: Vec<usize> = corners.map(|i| place(i, step)).collect();
    let runs = work.steps(corners.len().div_ceil(RUN));
    let areas = table(from.triangles.len(), |i| from.area_of(i) / 3.0);
    let mut weights = vec![0.0; from.corners.len()];
    for (triangle, area) in from.triangles.iter().zip(areas) {
        for &corner in triangle {
            weights[corner as usize] += area;
        }
    }
    corners
        .chunks(RUN)
        .par_map(|corners| {
            runs.add(1);
            let mut found = Vec::new();
            if runs.is_canceled() {
                return found;
            }
            let mut before: Option<([f32; 3], f32)> = None;
            for &i in corners {
                let (p, weight) = (from.corners[i], weights[i]);
                let bound = before.map_or(f32::INFINITY, |(q, d)| {
                    let step: f32 = (0..3).map(|i| (p[i] - q[i]).powi(2)).sum();
                    d + step.sqrt()
                });
                let distance = tree.distance(p, bound);
                before = Some((p, distance));
                found.push((distance, weight));
            }
            found
        })
        .concat()
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::print::samples::{ball, labeled, print_of};
    use tomolith_core::grid::Volume;
    use tomolith_core::near;
    use tomolith_core::target::label::{PART, VOID};

    fn compare(grid: &VolumeGrid, radii: [f64; 2], shift: f64, most: usize) -> SurfaceDistance {
        compare_from(grid, radii, shift, most, usize::MAX)
    }

    /// On at most so many voxels, from at most so many corners.
    fn compare_from(
        grid: &VolumeGrid,
        radii: [f64; 2],
        shift: f64,
        most: usize,
        corners: usize,
    ) -> SurfaceDistance {
        let (inside, response) = (ball(grid, radii[0], 0.0), ball(grid, radii[1], shift));
        let labels = labeled(&inside);
        let print = print_of(&labels, &inside, &response).with_most_corners(corners);
        compared_on(&print, most).unwrap().distance
    }

    #[test]
    fn concentric_spheres_are_their_difference_apart_everywhere() {
        let grid = VolumeGrid::centered([40, 41, 42], 0.1);
        let d = compare(&grid, [1.2, 1.35], 0.0, usize::MAX);
        for value in [d.mean_mm, d.p95_mm, d.hausdorff_mm] {
            assert!((value - 0.15).abs() < 0.004, "{d:?}");
        }
        assert_eq!(d.coarsened, 1);
        let near = compare(&grid, [1.2, 1.35], 0.2, usize::MAX);
        let few = compare_from(&grid, [1.2, 1.35], 0.2, usize::MAX, 500);
        near!(few.mean_mm / near.mean_mm, 1.0, 0.03, "{few:?} {near:?}");
        assert!((0.9..=1.0).contains(&(few.hausdorff_mm / near.hausdorff_mm)));
        let same = compare(&grid, [1.2, 1.2], 0.0, usize::MAX);
        assert!(same.hausdorff_mm < 1e-6, "{same:?}");
    }

    #[test]
    fn a_rough_surface_is_averaged_until_there_is_memory_for_it() {
        // Every other voxel of a block gels: hundreds of triangles where a smooth block has some
        let grid = VolumeGrid::centered([32, 32, 32], 0.1);
        let labels = Volume::filled(grid.clone(), PART);
        let parity = |i: usize| (i % 32 + i / 32 % 32 + i / 1024) % 2;
        let values = (0..grid.len()).map(|i| parity(i) as f32 + 0.2).collect();
        let response = Volume::new(grid, values);
        let print = || print_of(&labels, &response, &response);
        let rough = print().deviation().unwrap();
        let few = print().with_most_triangles(20_000).deviation().unwrap();
        assert_eq!(rough.coarsened, 1);
        assert!(rough.surface.triangles.len() > 100_000);
        assert_eq!(few.coarsened, 2);
        assert!(few.surface.triangles.len() <= 20_000);
    }

    #[test]
    fn a_print_that_is_too_large_is_positive_all_over_and_one_that_is_too_small_negative() {
        let grid = VolumeGrid::centered([40, 41, 42], 0.1);
        for (radius, expected) in [(1.35, 150.0), (1.05, -150.0)] {
            let (inside, response) = (ball(&grid, 1.2, 0.0), ball(&grid, radius, 0.0));
            let labels = labeled(&inside);
            let found = print_of(&labels, &inside, &response).deviation().unwrap();
            assert_eq!(found.off_um.len(), found.surface.corners.len());
            for off in &found.off_um {
                assert!((off - expected).abs() < 4.0, "{off} {expected}");
            }
        }
    }

    #[test]
    fn the_place_of_the_largest_deviation_is_told_and_what_is_wrong_there() {
        let grid = VolumeGrid::centered([40, 40, 40], 0.1);
        let inside = Volume::from_fn(grid.clone(), |[x, y, z]| {
            f32::from(u8::from(x.hypot(y).hypot(z) < 1.0))
        });
        let labels = labeled(&inside);
        let farthest = |[x, y, z]: [usize; 3], value: f32| {
            let mut response = inside.clone();
            response.values[grid.index(z, y, x)] = value;
            let print = print_of(&labels, &inside, &response);
            print.distance().unwrap().farthest
        };
        // A loose speck at (1.55, 1.45, −1.05) mm; a hole in the middle of the part, at (0.05, 0.05, 0.05) mm
        for (voxel, value, side) in [
            ([35, 34, 9], 1.0, Side::PrintWithoutTarget),
            ([20, 20, 20], 0.0, Side::TargetWithoutPrint),
        ] {
            let found = farthest(voxel, value);
            assert_eq!(found.side, side);
            let [x, y, z] = voxel;
            for (found, expected) in found.at_mm.iter().zip([grid.x(x), grid.y(y), grid.z(z)]) {
                assert!((found - expected).abs() < 0.051, "{found} {expected}");
            }
        }
    }

    #[test]
    fn a_shifted_sphere_is_farthest_at_its_poles() {
        // Distance at angle θ from the shift is |s·cos θ| up to s²: mean s/2, largest s, 95 % of the area below 0.95 s
        let grid = VolumeGrid::centered([64, 64, 64], 0.05);
        let d = compare(&grid, [1.2, 1.2], 0.1, usize::MAX);
        assert!((d.hausdorff_mm - 0.1).abs() < 0.002, "{d:?}");
        assert!((d.mean_mm - 0.05).abs() < 0.002, "{d:?}");
        assert!((d.p95_mm - 0.095).abs() < 0.002, "{d:?}");
    }

    #[test]
    fn a_coarsened_grid_gives_nearly_the_same_and_says_so() {
        let grid = VolumeGrid::centered([63, 64, 65], 0.05);
        let d = compare(&grid, [1.2, 1.3], 0.05, 40_000);
        assert_eq!(d.coarsened, 2);
        let fine = compare(&grid, [1.2, 1.3], 0.05, usize::MAX);
        assert!((d.mean_mm - fine.mean_mm).abs() < 0.004, "{d:?} {fine:?}");
        assert!((d.hausdorff_mm - 0.15).abs() < 0.005, "{d:?}");
    }

    #[test]
    fn the_mean_of_a_linear_field_over_blocks_is_the_field_at_their_centers() {
        let grid = VolumeGrid::centered([4, 6, 8], 0.5).about([1.0, 2.0, 3.0]);
        let at = |g: &VolumeGrid, i: usize| {
            let [x, y, z] = g.middle(i);
            (x + 10.0 * y + 100.0 * z) as f32
        };
        let fill = |first, row: &mut [f32]| {
            for (i, value) in (first..).zip(row) {
                *value = at(&grid, i);
            }
        };
        let (coarse, values) = averaged(&grid, 2, &fill, &Work::new());
        assert_eq!(coarse.shape, [2, 3, 4]);
        for (i, value) in values.iter().enumerate() {
            assert!((value - at(&coarse, i)).abs() < 1e-3);
        }
    }

    #[test]
    fn one_empty_surface_has_no_distance() {
        let grid = VolumeGrid::centered([4, 4, 4], 1.0);
        let labels = Volume::filled(grid.clone(), VOID);
        let response = Volume::filled(grid, 1.0f32);
        let nothing = Volume::filled(response.grid.clone(), 0.0);
        let print = print_of(&labels, &nothing, &response);
        assert_eq!(print.distance(), None);
    }
}
