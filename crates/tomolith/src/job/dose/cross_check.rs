//! Error of the scattered light of `successive_orders` against Monte Carlo paths, for the patterns at hand.
//!
//! A sample of the lit pixels is followed by Monte Carlo paths, twice, with independent draws; what they leave in cells of some voxels, less their
//! unscattered light, is an unbiased estimate of the scattered dose. In blocks of cells, with o by orders and a, b by paths,
//!
//! ```text
//! error² = mean (o − a)(o − b)        noise² = mean (a − b)²/2
//! ```
//! over the blocks of the part and of the void. The noise of a and b is independent, so it is not in the mean of the product; what is
//! left of it there is about noise²/√blocks, which is stated as the least error that can be seen. The 99.9th percentile is of
//! |o − (a + b)/2|: the noise of the paths is in it, so the error is below. All over the part's mean dose.
//!
//! Far from the light such numbers say nothing, since all is little there. Over the blocks whose scattered dose by orders is less than a
//! tenth of the part's mean, Σo / Σ(a + b)/2 − 1 is stated, with its standard error √Σ(a − b)² / Σ(a + b).

use super::doses::lit_rows;
use crate::error::Result;
use crate::field::HostField;
use crate::grid::{Patterns, Volume, VolumeGrid};
use crate::job::resolve::{ResolvedJob, Voxels};
use crate::models::{DoseModel, Family, ModelInput, Work};
use crate::optics::light::{Light, Selection};
use crate::optics::random::Stream;
use crate::target::label;
use crate::units::concise;
use serde::Serialize;
use std::fmt;

/// Errors of the dose by orders, over the part's mean dose.
#[derive(Clone, Copy, Debug, PartialEq, Serialize)]
pub(crate) struct CrossCheck {
    /// Root mean square over the blocks of the part, and of the void.
    pub(crate) part: f64,
    /// See `part`.
    pub(crate) void: f64,
    /// What 999 of 1000 blocks of the part, and of the void, stay below; with the noise of the paths.
    pub(crate) most_in_part: f64,
    /// See `most_in_part`.
    pub(crate) most_in_void: f64,
    /// The least that these paths could have seen.
    pub(crate) seen: f64,
    /// Where scattered light is dim: by how much orders are above paths there, and the standard error of that; None without such blocks.
    pub(crate) dim: Option<[f64; 2]>,
    /// Edge of a block, mm.
    pub(crate) block_mm: f64,
    /// Paths of each of the two estimates.
    pub(crate) paths: usize,
}

/// Paths of an estimate, about.
pub(crate) const PATHS: usize = 400_000;
/// Paths of a pixel at most, where few are lit: eight pixels still have a third of all paths.
const MOST_PER_PIXEL: usize = 1 << 14;
/// Blocks along the longest edge of the grid.
const BLOCKS: usize = 16;
/// An error that is worth a warning.
const WORTH_SAYING: f64 = 0.01;
/// Scattered light below this part of its mean in the part is dim.
const DIM: f64 = 0.1;

impl CrossCheck {
    /// Of patterns on the grid of voxels, vial standing, by about so many paths, twice; None where scattered light does not go order
    /// by order.
    pub(crate) fn of(
        job: &ResolvedJob,
        voxels: &Voxels,
        patterns: &[Patterns],
        most_paths: usize,
        work: &Work,
    ) -> Result<Option<Self>> {
        let grid = &voxels.labels.grid;
        let family = job.optics.family(grid)?;
        let Some(random) = family.compared_with() else {
            return Ok(None);
        };
        let (whole, by_orders) = scattered(&family, job, grid, patterns, work)?;
        let longest = grid.shape.iter().copied().max();
        let block = longest.unwrap_or(1).div_ceil(BLOCKS);
        let edge = cell_edge(grid.shape, block);
        let cells = cells_of(grid, edge);
        let mut paths = 0;
        let mut by_paths = |seed: u64| -> Result<Volume<f32>> {
            let (sample, count) = sampled(patterns, seed, most_paths);
            let paths_per_pixel = paths_per_pixel(most_paths, count);
            paths = count * paths_per_pixel;
            let random = random(paths_per_pixel, seed);
            Ok(scattered(&random, job, &cells, &sample, work)?.1)
        };
        let estimates = [by_paths(1)?, by_paths(2)?];
        let mean = part_mean(&whole, &voxels.labels);
        let by_orders = in_cells(&by_orders, &cells, edge);
        let found = errors(&by_orders, &estimates, &voxels.labels, block, edge);
        let over_mean = |error: f64| if mean > 0.0 { error / mean } else { 0.0 };
        Ok(Some(CrossCheck {
            part: over_mean(found.rms[0]),
            void: over_mean(found.rms[1]),
            most_in_part: over_mean(found.most[0]),
            most_in_void: over_mean(found.most[1]),
            seen: over_mean(found.seen),
            dim: found.dim,
            block_mm: block as f64 * grid.pitch_mm,
            paths,
        }))
    }

    /// The larger of the errors in part and void.
    pub(crate) fn worst(&self) -> f64 {
        self.part.max(self.void)
    }

    /// Whether the error is worth a warning, and no noise of the paths.
    pub(crate) fn is_far_off(&self) -> bool {
        self.worst() > WORTH_SAYING && self.worst() > 2.0 * self.seen
    }

    /// What people must know when the two do not agree.
    pub(crate) fn warning(&self) -> Option<String> {
        self.is_far_off().then(|| {
            let worst = self.worst();
            format!(
                "scattered light by successive orders is {:.1} % of the part's mean dose off Monte Carlo paths: use a smaller model.successive_orders.cell_mm, \
                 or [model.monte_carlo]",
                100.0 * worst
            )
        })
    }
}

impl fmt::Display for CrossCheck {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let off = |error: f64| {
            let least = 100.0 * self.seen;
            if error > self.seen {
                format!("{:.2} %", 100.0 * error)
            } else {
                format!("less than {least:.2} %")
            }
        };
        write!(
            f,
            "{} of the part's mean dose off Monte Carlo paths in the part, {} in the void (rms over blocks of {} mm, twice {} paths); \
             99.9 % of the blocks within {:.1} % and {:.1} %, noise of the paths included",
            off(self.part),
            off(self.void),
            concise(self.block_mm),
            self.paths,
            100.0 * self.most_in_part,
            100.0 * self.most_in_void
        )?;
        match self.dim {
            Some([off, noise]) => write!(
                f,
                "; where scattered light is below {:.0} % of its mean in the part: {:+.1} % of what is there, ± {:.1} %",
                100.0 * DIM,
                100.0 * off,
                100.0 * noise
            ),
            None => Ok(()),
        }
    }
}

/// The dose of patterns by a family, and what of it is scattered light.
fn scattered(
    family: &Family,
    job: &ResolvedJob,
    grid: &VolumeGrid,
    patterns: &[Patterns],
    work: &Work,
) -> Result<(Volume<f32>, Volume<f32>)> {
    let lights = lit(job, patterns);
    let optics = job.optics.scene().lit_by(&lights);
    let input = ModelInput::new(optics, grid, work)?;
    let whole = dose(family.build(&input)?.as_ref(), patterns, work)?;
    let straight = dose(family.unscattered(&input)?.as_ref(), patterns, work)?;
    let scattered = less(&whole, &straight);
    Ok((whole, scattered))
}

/// Voxels along the edge of a cell: some that fit into a block and the grid, at least four cells to the edge of a block.
fn cell_edge(shape: [usize; 3], block: usize) -> usize {
    let fits = |&edge: &usize| {
        let mut all = shape.iter().chain([&block]);
        all.all(|n| n.is_multiple_of(edge))
    };
    (1..=block / 4).rev().find(fits).unwrap_or(1)
}

/// Cells of some voxels along an edge.
fn cells_of(grid: &VolumeGrid, edge: usize) -> VolumeGrid {
    VolumeGrid {
        shape: grid.shape.map(|n| n / edge),
        pitch_mm: grid.pitch_mm * edge as f64,
        height_mm: grid.height_mm * edge as f64,
        ..grid.clone()
    }
}

/// Where the cell of a voxel stands in their array.
fn cell_of(i: usize, [_, ny, nx]: [usize; 3], edge: usize) -> usize {
    let (z, y, x) = (i / (ny * nx), i / nx % ny, i % nx);
    (z / edge * (ny / edge) + y / edge) * (nx / edge) + x / edge
}

/// Means of the voxels of each cell.
fn in_cells(volume: &Volume<f32>, cells: &VolumeGrid, edge: usize) -> Volume<f32> {
    let mut sums = vec![0.0f64; cells.len()];
    for (i, &value) in volume.values.iter().enumerate() {
        sums[cell_of(i, volume.grid.shape, edge)] += f64::from(value);
    }
    let count = edge.pow(3) as f64;
    Volume {
        grid: cells.clone(),
        values: sums.into_iter().map(|sum| (sum / count) as f32).collect(),
    }
}

/// Paths of each of so many lit pixels.
fn paths_per_pixel(most: usize, count: usize) -> usize {
    (most / count.max(1)).clamp(1, MOST_PER_PIXEL)
}

/// The lights of a job with the pixels that patterns light.
fn lit(job: &ResolvedJob, patterns: &[Patterns]) -> Vec<Light> {
    let mut lights = job.optics.lights_standing();
    for (light, patterns) in lights.iter_mut().zip(patterns) {
        light.active = Some(lit_rows(patterns));
        light.selection = Selection::default();
    }
    lights
}

/// Some of the lit pixels at random, brighter by as much as they are fewer; and how many.
fn sampled(patterns: &[Patterns], seed: u64, most: usize) -> (Vec<Patterns>, usize) {
    let lit: usize = patterns
        .iter()
        .map(|p| p.values.iter().filter(|v| **v != 0.0).count())
        .sum();
    let share = (most as f64 / lit.max(1) as f64).min(1.0);
    let mut count = 0;
    let mut sample = patterns.to_vec();
    for (light, patterns) in sample.iter_mut().enumerate() {
        for (i, value) in patterns.values.iter_mut().enumerate() {
            let chosen = Stream::new([seed, light as u64, i as u64, 7]).uniform() < share;
            *value = if chosen {
                (f64::from(*value) / share) as f32
            } else {
                0.0
            };
            count += usize::from(*value != 0.0);
        }
    }
    (sample, count)
}

fn dose(
    model: &dyn DoseModel<Field = HostField>,
    patterns: &[Patterns],
    work: &Work,
) -> Result<Volume<f32>> {
    let mut x = model.new_patterns()?;
    for (layout, patterns) in model.patterns().iter().zip(patterns) {
        layout.fill_field(patterns, x.as_mut_slice());
    }
    let mut dose = model.new_dose()?;
    model.dose(&x, &mut dose, work)?;
    Ok(model.outputs()[0].volume_of(dose.as_slice()))
}

fn less(a: &Volume<f32>, b: &Volume<f32>) -> Volume<f32> {
    let values = a.values.iter().zip(&b.values).map(|(a, b)| a - b).collect();
    Volume {
        grid: a.grid.clone(),
        values,
    }
}

fn part_mean(dose: &Volume<f32>, labels: &Volume<u8>) -> f64 {
    let part = dose
        .values
        .iter()
        .zip(&labels.values)
        .filter(|(_, l)| **l == label::PART);
    let (sum, count) = part.fold((0.0, 0.0f64), |(s, n), (v, _)| (s + f64::from(*v), n + 1.0));
    sum / count.max(1.0)
}

/// Errors in part and void.
struct Errors {
    /// Root mean square, without the noise of the paths.
    rms: [f64; 2],
    /// 99.9th percentile, with it.
    most: [f64; 2],
    /// The least that could be seen.
    seen: f64,
    /// Where scattered light is dim: how much more it is by orders than by paths, and the standard error of that.
    dim: Option<[f64; 2]>,
}

/// Errors of doses in cells, weighted with the voxels that each has in a place; blocks and cells have so many voxels along an edge.
fn errors(
    orders: &Volume<f32>,
    [a, b]: &[Volume<f32>; 2],
    labels: &Volume<u8>,
    block: usize,
    cell: usize,
) -> Errors {
    let shape = labels.grid.shape.map(|n| n.div_ceil(block));
    // Sums of the three doses and voxels, of the part's voxels and of the void's in each block
    let mut blocks = vec![[[0.0f64; 4]; 2]; shape.iter().product()];
    let [_, ny, nx] = labels.grid.shape;
    for (i, label) in labels.values.iter().enumerate() {
        let place = match *label {
            label::PART => 0,
            label::VOID => 1,
            _ => continue,
        };
        let (z, y, x) = (i / (ny * nx), i / nx % ny, i % nx);
        let at = (z / block * shape[1] + y / block) * shape[2] + x / block;
        let in_cell = cell_of(i, labels.grid.shape, cell);
        let values = [
            orders.values[in_cell],
            a.values[in_cell],
            b.values[in_cell],
            1.0,
        ];
        for (sum, value) in blocks[at][place].iter_mut().zip(values) {
            *sum += f64::from(value);
        }
    }
    let (mut seen, mut most) = (0.0f64, [0.0; 2]);
    let rms = [0, 1].map(|place| {
        let (mut product, mut noise) = (0.0, 0.0);
        let mut off = Vec::new();
        // Blocks that are at least half of this place
        let half = 0.5 * block.pow(3) as f64;
        for &[o, a, b, n] in blocks
            .iter()
            .map(|block| &block[place])
            .filter(|s| s[3] >= half)
        {
            product += (o - a) * (o - b) / (n * n);
            noise += 0.5 * ((a - b) / n).powi(2);
            off.push(((o - 0.5 * (a + b)) / n).abs());
        }
        let count = off.len().max(1) as f64;
        off.sort_by(f64::total_cmp);
        let place_of = (0.999 * off.len() as f64).ceil() as usize;
        most[place] = *off.get(place_of.max(1) - 1).unwrap_or(&0.0);
        seen = seen.max((noise / count / count.sqrt()).sqrt());
        (product / count).max(0.0).sqrt()
    });
    Errors {
        rms,
        most,
        seen,
        dim: dim(&blocks, 0.5 * block.pow(3) as f64),
    }
}

/// How much more scattered light is by orders than by paths in the blocks, of at least so many voxels, where it is little.
fn dim(blocks: &[[[f64; 4]; 2]], least: f64) -> Option<[f64; 2]> {
    let (sum, count) = (blocks.iter()).fold((0.0, 0.0), |(sum, count), [part, _]| {
        (sum + part[0], count + part[3])
    });
    let limit = DIM * sum / f64::max(count, 1.0);
    let is_dim = |&&[o, _, _, n]: &&[f64; 4]| n >= least && o < limit * n;
    let (mut orders, mut paths, mut squares) = (0.0, 0.0, 0.0);
    for &[o, a, b, _] in blocks.iter().flatten().filter(is_dim) {
        orders += 2.0 * o;
        paths += a + b;
        squares += (a - b).powi(2);
    }
    (paths > 0.0).then(|| [orders / paths - 1.0, f64::sqrt(squares) / paths])
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::grid::{PatternGrid, VolumeGrid};

    #[test]
    fn a_known_error_is_found_under_noise_larger_than_it() {
        let grid = VolumeGrid::centered([32, 32, 32], 0.1);
        let volume = |value: &dyn Fn(usize) -> f64| Volume {
            grid: grid.clone(),
            values: (0..grid.len()).map(|i| value(i) as f32).collect(),
        };
        let noisy = |seed: u64| {
            volume(&|i| 1.0 + 0.5 * (Stream::new([seed, i as u64, 0, 0]).uniform() - 0.5))
        };
        let labels = Volume {
            grid: grid.clone(),
            values: (0..grid.len())
                .map(|i| {
                    if i < grid.len() / 2 {
                        label::PART
                    } else {
                        label::VOID
                    }
                })
                .collect(),
        };
        // Half per cent too much in the part, as much too little in the void; a voxel's noise is 14 %, a block's of 8 voxels 5 %
        let orders = volume(&|i| if i < grid.len() / 2 { 1.005 } else { 0.995 });
        let Errors {
            rms: [part, void],
            most,
            seen,
            dim,
        } = errors(&orders, &[noisy(1), noisy(2)], &labels, 2, 1);
        assert!(
            seen < 0.01 && part < 0.005 + seen && void < 0.005 + seen,
            "{part} {void} {seen}"
        );
        // Means of two blocks of 8 voxels, each even between ±0.25: 3.6 % of noise, of which 999 of 1000 lie within about 3.3 times
        assert!(most.iter().all(|m| (0.1..0.14).contains(m)), "{most:?}");
        // Nothing is dim here; with a void of a twentieth, of which orders have 3 % too much, that is found
        assert_eq!(dim, None);
        let scale = |i: usize| if i < grid.len() / 2 { 1.0 } else { 0.05 };
        let dimmer = |v: &Volume<f32>| volume(&|i| scale(i) * f64::from(v.values[i]));
        let more = volume(&|i| if i < grid.len() / 2 { 1.0 } else { 0.05 * 1.03 });
        let both = [dimmer(&noisy(1)), dimmer(&noisy(2))];
        let [off, noise] = errors(&more, &both, &labels, 2, 1).dim.unwrap();
        assert!(
            (off - 0.03).abs() < 5.0 * noise && noise < 0.002,
            "{off} {noise}"
        );
        let worse = volume(&|i| if i < grid.len() / 2 { 1.05 } else { 1.0 });
        let [part, void] = errors(&worse, &[noisy(1), noisy(2)], &labels, 2, 1).rms;
        assert!((part - 0.05).abs() < 0.003 && void < 0.01, "{part} {void}");
    }

    #[test]
    fn cells_are_whole_parts_of_blocks_and_grid_and_hold_means() {
        assert_eq!(cell_edge([256; 3], 16), 4);
        assert_eq!(cell_edge([400, 200, 400], 25), 5);
        assert_eq!(cell_edge([32; 3], 2), 1);
        assert_eq!(cell_edge([250, 256, 256], 16), 2);
        let grid = VolumeGrid::centered([4, 8, 6], 0.1);
        let linear = |[x, y, z]: [f64; 3]| (1.0 + 2.0 * x - 3.0 * y + 0.5 * z) as f32;
        let cells = cells_of(&grid, 2);
        let found = in_cells(&Volume::from_fn(grid, linear), &cells, 2);
        let expected = Volume::from_fn(cells, linear);
        for (a, b) in found.values.iter().zip(&expected.values) {
            assert!((a - b).abs() < 1e-6, "{a} {b}");
        }
    }

    #[test]
    fn an_error_that_cannot_be_seen_is_said_to_be_less_than_what_can() {
        let found = CrossCheck {
            part: 0.0123,
            void: 0.0004,
            most_in_part: 0.03,
            most_in_void: 0.011,
            seen: 0.002,
            dim: Some([0.11, 0.02]),
            block_mm: 0.3,
            paths: 400_000,
        };
        let text = found.to_string();
        assert!(
            text.starts_with("1.23 % of") && text.contains("less than 0.20 % in the void"),
            "{text}"
        );
        assert!(
            text.ends_with("+11.0 % of what is there, ± 2.0 %"),
            "{text}"
        );
        assert!(found.warning().unwrap().contains("1.2 %"));
        assert_eq!(
            CrossCheck {
                seen: 0.01,
                ..found
            }
            .warning(),
            None
        );
    }

    #[test]
    fn few_pixels_get_as_many_paths_as_all_would() {
        assert_eq!(
            [1_000_000, 100, 0].map(|n| paths_per_pixel(PATHS, n)),
            [1, 4000, 1 << 14]
        );
    }

    #[test]
    fn a_sample_of_pixels_sends_as_much_as_all() {
        let mut patterns = Patterns::dark(PatternGrid::full_turn(50, 0.0, 100, 200, 0.1));
        patterns.values.fill(0.5);
        let (sample, count) = sampled(&[patterns.clone()], 3, PATHS);
        let sum = |p: &Patterns| p.values.iter().map(|&v| f64::from(v)).sum::<f64>();
        let expected = PATHS as f64 / 1e6;
        assert!((count as f64 / 1e6 - expected).abs() < 5.0 * (expected / 1e6).sqrt());
        assert!((sum(&sample[0]) / sum(&patterns) - 1.0).abs() < 0.01);
    }
}
