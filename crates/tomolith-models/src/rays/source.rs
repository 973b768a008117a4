//! Source of rays: pixels of frames → path segments in the resin.

use super::Emission;
use std::f64::consts::{FRAC_PI_4, TAU};
use std::sync::Arc;
use std::sync::atomic::{AtomicU64, Ordering};
use tomolith_core::grid::PatternGrid;
use tomolith_core::parallel::InParallel;
use tomolith_optics::light::Light;
use tomolith_optics::motion::{Motion, turned};
use tomolith_optics::power_balance::PowerBalance;
use tomolith_optics::projector::{Projector, Ray};
use tomolith_optics::random::Stream;
use tomolith_optics::space::{PathSegment, SpaceTracer};

/// Rays of one light.
pub(super) struct Source {
    pub(super) pixels: PatternGrid,
    projector: Arc<dyn Projector>,
    motion: Motion,
    pub(super) tracer: SpaceTracer,
    samples: Vec<Sample>,
    sub_angles: usize,
    /// Seed of the paths of scattered light; None: unscattered light only.
    seed: Option<u64>,
    /// How often other paths have been drawn.
    round: AtomicU64,
    /// Segments as seen at azimuth 0, where every frame has the same.
    shared: Option<Shared>,
}

/// A ray of a pixel: where in the pixel (−½ to ½ of its pitch), and where in the aperture (the unit disc).
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct Sample {
    pub(super) within: [f64; 2],
    pub(super) aperture: [f64; 2],
}

/// The ray through the middle of pixel and aperture.
const MIDDLE: Sample = Sample {
    within: [0.0; 2],
    aperture: [0.0; 2],
};

/// The golden ratio − 1: its multiples leave the most even gaps.
const GOLDEN: f64 = 0.618_033_988_749_894_9;

/// Segments of all pixels of one frame.
struct Shared {
    /// First segment of each (column, row from below), and one more.
    starts: Vec<u32>,
    segments: Vec<PathSegment>,
}

impl Source {
    pub(super) fn new(
        light: &Light,
        projector: Arc<dyn Projector>,
        motion: Motion,
        emission: &Emission,
        tracer: SpaceTracer,
        is_round: bool,
    ) -> Self {
        let samples = samples(emission.rays_per_pixel, projector.has_aperture());
        let mut source = Source {
            pixels: light.pixels.clone(),
            projector,
            motion,
            tracer,
            samples,
            sub_angles: light.sub_angles.max(1),
            seed: emission.scattered.map(|scattered| scattered.seed),
            round: AtomicU64::new(0),
            shared: None,
        };
        let alike = is_round && motion.is_symmetric() && emission.scattered.is_none();
        source.shared = alike.then(|| source.trace_once());
        source
    }

    /// Draws the paths of another round; whether it is another one.
    pub(super) fn renew(&self, round: u64) -> bool {
        self.round.swap(round, Ordering::Relaxed) != round
    }

    /// Seed of the first paths; None: unscattered light only.
    pub(super) fn first_seed(&self) -> Option<u64> {
        self.seed
    }

    /// Seed of the present paths; None: unscattered light only.
    fn seed(&self) -> Option<u64> {
        let round = self.round.load(Ordering::Relaxed);
        self.seed.map(|seed| seed.wrapping_add(round))
    }

    /// Random points of a segment: (frame, column), row and segment count.
    pub(super) fn points(&self, [pair, row, segment]: [usize; 3]) -> Stream {
        // Other numbers than those of paths
        let seed = !self.seed().unwrap_or(1);
        Stream::new([seed, pair as u64, row as u64, segment as u64])
    }

    /// Whether paths of scattered light are drawn.
    pub(super) fn is_scattering(&self) -> bool {
        self.seed.is_some()
    }

    /// Whether the axis is normal to the optical axis.
    pub(super) fn is_level(&self) -> bool {
        self.motion.tilt_rad == 0.0
    }

    /// What lies between the heights of two rows' rays above one place, mm: the rows stand across the optical axis, which may lean.
    pub(super) fn row_step_mm(&self) -> f64 {
        self.pixels.pitch_mm[1] / self.motion.tilt_rad.cos()
    }

    /// Rays per pixel and frame.
    pub(super) fn rays(&self) -> usize {
        self.samples.len() * self.sub_angles
    }

    /// Traces the pixels of a frame at azimuth 0.
    fn trace_once(&self) -> Shared {
        let (columns, rows) = (self.pixels.columns, self.pixels.rows);
        let by_pixel: Vec<Vec<PathSegment>> = (0..columns * rows).par_map(|i| {
            let mut segments = Vec::new();
            self.trace(i / rows, i % rows, 0.0, |segment| segments.push(segment));
            segments
        });
        let mut starts = vec![0];
        for segments in &by_pixel {
            starts.push(starts[starts.len() - 1] + segments.len() as u32);
        }
        Shared {
            starts,
            segments: by_pixel.into_iter().flatten().collect(),
        }
    }

    /// The samples of a column's pixels: along the axis shifted from the even ones, within their spacing, by an amount that follows from the column's place.
    /// Level rays of one height meet one slice of voxels; heights that all columns shared would light some slices more than
    /// others, in every voxel alike. A single ray stays in the middle. The place, not the number, decides: an image
    /// beside the axis has the rays of a larger one.
    fn samples_of(&self, column: usize) -> impl Iterator<Item = Sample> {
        let count = self.samples.len();
        let place = self.pixels.column_u(column) / self.pixels.pitch_mm[0];
        // Half a spacing is added so that no pixel on or next to the axis lies at the leap from 1 to 0
        let offset = (0.5 + place * GOLDEN).rem_euclid(1.0) - 0.5;
        let offset = if count > 1 {
            offset / count as f64
        } else {
            0.0
        };
        self.samples.iter().map(move |sample| Sample {
            within: [sample.within[0], sample.within[1] + offset],
            ..*sample
        })
    }

    fn ray(&self, column: usize, row: usize, sample: &Sample, azimuth: f64) -> Ray {
        let [across, along] = self.pixels.pitch_mm;
        let point = [
            self.pixels.column_u(column) + sample.within[0] * across,
            self.pixels.row_z(self.pixels.rows - 1 - row) + sample.within[1] * along,
        ];
        let ray = self.projector.ray(point, sample.aperture);
        self.motion.seen_from_vial(ray, azimuth)
    }

    fn trace(&self, column: usize, row: usize, azimuth: f64, mut visit: impl FnMut(PathSegment)) {
        for sample in self.samples_of(column) {
            let ray = self.ray(column, row, &sample, azimuth);
            self.tracer
                .segments(ray, None)
                .into_iter()
                .for_each(&mut visit);
        }
    }

    /// Traces what is scattered, too; `exposure` counts frames and their sub-angles.
    fn trace_scattered(
        &self,
        column: usize,
        row: usize,
        azimuth: f64,
        exposure: usize,
        seed: u64,
        mut visit: impl FnMut(PathSegment),
    ) {
        let pixel = (column * self.pixels.rows + row) as u64;
        for (i, sample) in self.samples_of(column).enumerate() {
            let mut random = Stream::new([seed, exposure as u64, pixel, i as u64]);
            let ray = self.ray(column, row, &sample, azimuth);
            let segments = self.tracer.segments(ray, Some(&mut random));
            segments.into_iter().for_each(&mut visit);
        }
    }

    /// The azimuths that a frame is averaged over.
    pub(super) fn azimuths(&self, frame: usize) -> impl Iterator<Item = f64> {
        let (middle, count) = (self.pixels.azimuths[frame], self.sub_angles as f64);
        (0..self.sub_angles)
            .map(move |sub| middle + ((sub as f64 + 0.5) / count - 0.5) * self.pixels.frame_arc)
    }

    /// Where every frame has the same segments, they as seen at azimuth 0, and the first of each pixel (column by column from the lowest row), and one more.
    pub(super) fn shared(&self) -> Option<(&[PathSegment], &[u32])> {
        let shared = self.shared.as_ref()?;
        Some((&shared.segments, &shared.starts))
    }

    /// Calls `visit` with every segment of the light of a pixel (row counted from below) in a frame.
    pub(super) fn for_each_path_segment(
        &self,
        frame: usize,
        column: usize,
        row: usize,
        mut visit: impl FnMut(PathSegment),
    ) {
        for (sub, azimuth) in self.azimuths(frame).enumerate() {
            if let Some(seed) = self.seed() {
                let exposure = frame * self.sub_angles + sub;
                self.trace_scattered(column, row, azimuth, exposure, seed, &mut visit);
                continue;
            }
            let Some(shared) = &self.shared else {
                self.trace(column, row, azimuth, &mut visit);
                continue;
            };
            let pixel = column * self.pixels.rows + row;
            let range = shared.starts[pixel] as usize..shared.starts[pixel + 1] as usize;
            for segment in &shared.segments[range] {
                let ray = Ray {
                    from: turned(segment.ray.from, azimuth),
                    direction: turned(segment.ray.direction, azimuth),
                };
                visit(PathSegment { ray, ..*segment });
            }
        }
    }

    /// Segments of a pixel's middle ray, and where the power of its rays goes.
    pub(super) fn trace_pixel(
        &self,
        frame: usize,
        column: usize,
        row: usize,
    ) -> (Vec<PathSegment>, PowerBalance) {
        let azimuth = self.pixels.azimuths[frame];
        let middle = self.ray(column, row, &MIDDLE, azimuth);
        (
            self.tracer.trace(middle).segments,
            self.balance_of(frame, column, row),
        )
    }

    fn balance_of(&self, frame: usize, column: usize, row: usize) -> PowerBalance {
        let mut balance = PowerBalance::default();
        for (i, sample) in self.samples_of(column).enumerate() {
            let ray = self.ray(column, row, &sample, self.pixels.azimuths[frame]);
            let pixel = (column * self.pixels.rows + row) as u64;
            let path = match self.seed() {
                Some(seed) => {
                    let mut random = Stream::new([seed, frame as u64, pixel, i as u64]);
                    self.tracer.trace_scattered(ray, &mut random)
                }
                None => self.tracer.trace(ray),
            };
            balance.add(&path.balance, 1.0 / self.samples.len() as f64);
        }
        balance
    }

    /// Where the power of a frame's light goes, mean over its pixels.
    pub(super) fn balance(&self, frame: usize) -> PowerBalance {
        let rows = self.pixels.rows;
        let pixels = self.pixels.columns * rows;
        let of_pixel = |i: usize| self.balance_of(frame, i / rows, i % rows);
        let all: Vec<PowerBalance> = (0..pixels).par_map(of_pixel);
        let mut sum = PowerBalance::default();
        all.iter()
            .for_each(|balance| sum.add(balance, 1.0 / pixels as f64));
        sum
    }
}

/// Points of pixel and aperture, each dimension by itself in even steps: with n rays every pixel has n heights and n places across. (A
/// square lattice has only √n of either, and level rays of √n heights light neighboring slices of voxels unevenly.) Their order
/// is that of an additive recurrence, the golden ratio's or its generalization to four dimensions.
pub(super) fn samples(count: usize, has_aperture: bool) -> Vec<Sample> {
    let even = |step: f64| ranks(count, step).map(|rank| (rank as f64 + 0.5) / count as f64);
    if !has_aperture {
        return even(0.0)
            .zip(even(GOLDEN))
            .map(|(u, v)| Sample {
                within: [u - 0.5, v - 0.5],
                aperture: [0.0; 2],
            })
            .collect();
    }
    // The positive root of g^5 = g + 1
    const G: f64 = 1.167_303_978_261_418_7;
    let [u, v, a, b] = [1, 2, 3, 4].map(|dimension| even(G.powi(-dimension)));
    u.zip(v)
        .zip(a.zip(b))
        .map(|((u, v), (a, b))| Sample {
            within: [u - 0.5, v - 0.5],
            aperture: disc([a, b]),
        })
        .collect()
}

/// The ranks of the fractional parts of i·step, for i from 0; equal ones in the order of i.
fn ranks(count: usize, step: f64) -> impl Iterator<Item = usize> {
    let part = |i: &usize| (*i as f64 * step).fract();
    let mut order: Vec<usize> = (0..count).collect();
    order.sort_by(|i, j| part(i).total_cmp(&part(j)));
    let mut ranks = vec![0; count];
    order
        .iter()
        .enumerate()
        .for_each(|(rank, &i)| ranks[i] = rank);
    ranks.into_iter()
}

/// The unit square onto the unit disc, equal areas to equal areas (Shirley and Chiu, J. Graphics Tools 2, 45 (1997)).
fn disc([u, v]: [f64; 2]) -> [f64; 2] {
    let (a, b) = (2.0 * u - 1.0, 2.0 * v - 1.0);
    if a == 0.0 && b == 0.0 {
        return [0.0; 2];
    }
    let (radius, angle) = if a.abs() > b.abs() {
        (a, FRAC_PI_4 * b / a)
    } else {
        (b, TAU / 4.0 - FRAC_PI_4 * a / b)
    };
    [radius * angle.cos(), radius * angle.sin()]
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn samples_are_centered_and_fill_pixel_and_disc_evenly() {
        assert_eq!(samples(1, true)[0].within, [0.0; 2]);
        assert_eq!(samples(1, true)[0].aperture, [0.0; 2]);
        for (count, has_aperture) in [(1, false), (4, false), (7, true), (16, false), (16, true)] {
            let samples = samples(count, has_aperture);
            for axis in [0, 1] {
                let mut steps: Vec<f64> = samples.iter().map(|s| s.within[axis]).collect();
                steps.sort_by(f64::total_cmp);
                for (i, step) in steps.iter().enumerate() {
                    let even = (i as f64 + 0.5) / count as f64 - 0.5;
                    assert!((step - even).abs() < 1e-12, "{count}: {steps:?}");
                }
            }
        }
        let many = samples(4096, true);
        let mean = |f: &dyn Fn(&Sample) -> f64| many.iter().map(f).sum::<f64>() / 4096.0;
        assert!(mean(&|s| s.within[0]).abs() < 1e-3);
        assert!((mean(&|s| s.within[1].powi(2)) - 1.0 / 12.0).abs() < 1e-3);
        // The mean of r² over the unit disc is ½, of x² and y² ¼ each
        assert!((mean(&|s| s.aperture[0].powi(2)) - 0.25).abs() < 2e-3);
        assert!((mean(&|s| s.aperture[1].powi(2)) - 0.25).abs() < 2e-3);
        assert!(
            many.iter()
                .all(|s| s.aperture[0].hypot(s.aperture[1]) <= 1.0 + 1e-12)
        );
    }
}
