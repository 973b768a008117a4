//! Impulse response: how wide a square post comes out.
//!
//! **What it models** a disc of N pixels across, one unit each, and a post of w × w of them whose corner nearest to the axis's far side stands at radius r (Wang et al. 2022,
//! supplement, Note 3). No attenuation, no chemistry, frames over half a turn.
//!
//! **Equation** *plain*: P_θ\[j\] = mean over pixel j of the post's line integrals (exact: the line integral of a square is a trapezoid), dose(x) = mean over θ of
//! P_θ at the pixel that lights x. *Corrected*: P ≥ 0 with the least Σ part·(dose − 1)² + (1 − part)·max(0, dose − ¼)² over the disc's voxels of one pixel: void
//! that stays liquid is left alone. By accelerated projected gradients (Beck and Teboulle, SIAM J. Imaging Sci. 2 (2009) 183) from the plain patterns.
//!
//! FWHM: width of the profile through the post's middle between the first places on both sides of its largest value where it is half of that; zero is the base.
//!
//! **Limits** in the continuum a plain square has 1.122w in its middle and 0.766w in the middle of its edges, so its FWHM is larger than w whatever the steps are.
//! **Cost** plain: milliseconds. Corrected: 8·N²·180/δθ updates an iteration.
//!
//! ```
//! use tomolith_planning::impulse::Post;
//! let post = Post { pixels: 128, width: 5.0, radius: 0.0, step_deg: 1.0 };
//! let [radial, tangential] = post.plain().fwhm();
//! assert!(radial / 5.0 > 1.24 && radial / 5.0 < 1.31 && (radial - tangential).abs() < 0.1);
//! ```

use std::f64::consts::{FRAC_1_SQRT_2, PI};
use tomolith_core::error::{Error, Result, in_range};

/// Samples of a profile in a pixel.
const FINE: usize = 40;
/// Samples along each edge of a voxel in the correction.
const SUB: usize = 2;
/// Iterations of the correction.
const ITERATIONS: usize = 60;
/// Dose up to which void is left alone, where the post has 1.
const VOID: f64 = 0.25;

/// A square post.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Post {
    /// N: pixels across the disc.
    pub pixels: usize,
    /// w, pixels.
    pub width: f64,
    /// Radius of its upper left corner in the second quadrant, in units of the disc's.
    pub radius: f64,
    /// δθ, degrees.
    pub step_deg: f64,
}

/// Patterns of a post, and where it stands.
#[derive(Clone, Debug)]
pub struct Projected {
    post: Post,
    /// [frame, pixel]
    patterns: Vec<Vec<f64>>,
}

impl Post {
    /// Checks every number.
    ///
    /// # Errors
    /// [`Error::Config`] with the option that is out of range.
    pub fn check(&self) -> Result<()> {
        let is_in = (16..=512).contains(&self.pixels);
        in_range(is_in, "--pixels", self.pixels, "16 to 512 pixels")?;
        let is_in = self.width >= 0.5 && self.width <= self.pixels as f64 / 4.0;
        let accepted = "from half a pixel to a quarter of --pixels";
        in_range(is_in, "--width", self.width, accepted)?;
        let is_in = (0.05..=45.0).contains(&self.step_deg);
        in_range(is_in, "--step-deg", self.step_deg, "0.05 to 45 degrees")?;
        let [x, y] = self.middle();
        let reach = x.hypot(y) + self.width * FRAC_1_SQRT_2;
        let is_in = self.radius >= 0.0 && reach <= self.pixels as f64 / 2.0;
        let accepted = "0 or more, with the whole post in the disc";
        in_range(is_in, "--radius", self.radius, accepted)?;
        if Field::new(*self).target().iter().sum::<f64>() <= 0.0 {
            let found = format!(
                "found {}: no voxel of the disc holds a part of the post",
                self.radius
            );
            return Err(Error::config("--radius", found, "a post further in"));
        }
        Ok(())
    }

    /// Middle of the post: right and down of its upper left corner.
    fn middle(&self) -> [f64; 2] {
        let corner = self.radius * self.pixels as f64 / 2.0 * FRAC_1_SQRT_2;
        [-corner + self.width / 2.0, corner - self.width / 2.0]
    }

    fn frames(&self) -> usize {
        (180.0 / self.step_deg).round().max(1.0) as usize
    }

    fn angle(&self, frame: usize) -> f64 {
        PI * frame as f64 / self.frames() as f64
    }

    /// ∫ of the line integrals of the post up to a place `s` from its middle's.
    fn cumulated(&self, theta: f64, s: f64) -> f64 {
        let (a, b) = (
            self.width * theta.cos().abs(),
            self.width * theta.sin().abs(),
        );
        let (long, short) = (a.max(b), a.min(b));
        let area = self.width * self.width;
        if short < 1e-12 * long {
            return area * (s / long + 0.5).clamp(0.0, 1.0);
        }
        // Four corners of a trapezoid: its integral is a sum of four parabolas
        let corner = |at: f64| 0.5 * (s - at).max(0.0).powi(2);
        let (outer, inner) = ((long + short) / 2.0, (long - short) / 2.0);
        area / (long * short) * (corner(-outer) - corner(-inner) - corner(inner) + corner(outer))
    }

    /// Patterns of plain back-projection.
    #[must_use]
    pub fn plain(&self) -> Projected {
        let [x, y] = self.middle();
        let n = self.pixels;
        let frame = |k: usize| {
            let theta = self.angle(k);
            let at = x * theta.cos() + y * theta.sin();
            let edge = |j: usize| self.cumulated(theta, j as f64 - n as f64 / 2.0 - at);
            (0..n).map(|j| edge(j + 1) - edge(j)).collect()
        };
        Projected {
            post: *self,
            patterns: (0..self.frames()).map(frame).collect(),
        }
    }

    /// Patterns corrected iteratively.
    #[must_use]
    pub fn corrected(&self) -> Projected {
        let field = Field::new(*self);
        let target = field.target();
        let mut x = self.plain().patterns.concat();
        // Scaled so that the mean dose of the post is 1
        let scale = target.iter().sum::<f64>() / dot(&field.dose(&x), &target);
        x.iter_mut().for_each(|v| *v *= scale);
        let step = 1.0 / field.largest();
        let (mut ahead, mut momentum) = (x.clone(), 1.0f64);
        for _ in 0..ITERATIONS {
            let dose = field.dose(&ahead);
            let rest: Vec<f64> = dose
                .iter()
                .zip(&target)
                .map(|(d, part)| part * (d - 1.0) + (1.0 - part) * (d - VOID).max(0.0))
                .collect();
            let gradient = field.adjoint(&rest);
            let moved = ahead
                .iter()
                .zip(&gradient)
                .map(|(v, g)| (v - step * g).max(0.0));
            let next: Vec<f64> = moved.collect();
            let larger = 0.5 * (1.0 + (1.0 + 4.0 * momentum * momentum).sqrt());
            let share = (momentum - 1.0) / larger;
            ahead = next
                .iter()
                .zip(&x)
                .map(|(n, o)| n + share * (n - o))
                .collect();
            (x, momentum) = (next, larger);
        }
        Projected {
            post: *self,
            patterns: x.chunks(self.pixels).map(<[f64]>::to_vec).collect(),
        }
    }
}

impl Projected {
    /// Dose at a place, pixels from the axis.
    #[must_use]
    pub fn dose(&self, x: f64, y: f64) -> f64 {
        let half = self.post.pixels as f64 / 2.0;
        let of_frame = |(k, row): (usize, &Vec<f64>)| {
            let theta = self.post.angle(k);
            let at = (x * theta.cos() + y * theta.sin() + half).floor();
            if at >= 0.0 {
                row.get(at as usize).copied().unwrap_or(0.0)
            } else {
                0.0
            }
        };
        self.patterns.iter().enumerate().map(of_frame).sum::<f64>() / self.patterns.len() as f64
    }

    /// Profile through the post's middle, along an edge of the post: places in pixels from there, doses.
    #[must_use]
    pub fn profile(&self, along_x: bool) -> Vec<[f64; 2]> {
        let [x, y] = self.post.middle();
        let reach = (2.5 * self.post.width + 3.0).ceil() as i32 * FINE as i32;
        let place = |i: i32| (f64::from(i) + 0.5) / FINE as f64;
        (-reach..reach)
            .map(|i| {
                let s = place(i);
                let dose = if along_x {
                    self.dose(x + s, y)
                } else {
                    self.dose(x, y + s)
                };
                [s, dose]
            })
            .collect()
    }

    /// FWHM along x and y, pixels.
    #[must_use]
    pub fn fwhm(&self) -> [f64; 2] {
        [true, false].map(|along_x| fwhm(&self.profile(along_x)))
    }
}

/// Width at half of the largest value of a profile.
fn fwhm(profile: &[[f64; 2]]) -> f64 {
    let peak = (0..profile.len())
        .max_by(|&a, &b| profile[a][1].total_cmp(&profile[b][1]))
        .unwrap_or(0);
    let half = profile[peak][1] / 2.0;
    let crossing = |mut indices: Box<dyn Iterator<Item = usize>>, inward: i64| {
        indices.find(|&i| profile[i][1] < half).map(|i| {
            let [[x0, y0], [x1, y1]] = [profile[i], profile[(i as i64 + inward) as usize]];
            x0 + (half - y0) / (y1 - y0) * (x1 - x0)
        })
    };
    let right = crossing(Box::new(peak..profile.len()), -1);
    let left = crossing(Box::new((0..=peak).rev()), 1);
    match (left, right) {
        (Some(left), Some(right)) => right - left,
        _ => f64::NAN,
    }
}

fn dot(a: &[f64], b: &[f64]) -> f64 {
    a.iter().zip(b).map(|(a, b)| a * b).sum()
}

/// Voxels of one pixel in the disc, and the pixels that light their samples.
struct Field {
    post: Post,
    /// Middles of the voxels.
    places: Vec<[f64; 2]>,
}

impl Field {
    fn new(post: Post) -> Self {
        let n = post.pixels;
        let half = n as f64 / 2.0;
        let place = |i: usize| [(i % n) as f64 + 0.5 - half, (i / n) as f64 + 0.5 - half];
        let places = (0..n * n)
            .map(place)
            .filter(|[x, y]| x.hypot(*y) <= half - 0.75);
        Field {
            post,
            places: places.collect(),
        }
    }

    /// Part of each voxel that is post.
    fn target(&self) -> Vec<f64> {
        let (middle, half) = (self.post.middle(), self.post.width / 2.0);
        let shared = |c: f64, m: f64| ((c + 0.5).min(m + half) - (c - 0.5).max(m - half)).max(0.0);
        let place = |[x, y]: &[f64; 2]| shared(*x, middle[0]) * shared(*y, middle[1]);
        self.places.iter().map(place).collect()
    }

    /// Every (voxel, pixel), SUB² times each with the weight of a sample in a frame.
    fn each(&self, mut visit: impl FnMut(usize, usize)) {
        let n = self.post.pixels;
        let half = n as f64 / 2.0;
        for frame in 0..self.post.frames() {
            let (sin, cos) = self.post.angle(frame).sin_cos();
            let sample = |i: usize| (i as f64 + 0.5) / SUB as f64 - 0.5;
            for sub in 0..SUB * SUB {
                let shift = sample(sub % SUB) * cos + sample(sub / SUB) * sin + half;
                for (voxel, [x, y]) in self.places.iter().enumerate() {
                    let pixel = ((x * cos + y * sin + shift) as usize).min(n - 1);
                    visit(voxel, frame * n + pixel);
                }
            }
        }
    }

    fn weight(&self) -> f64 {
        1.0 / (SUB * SUB * self.post.frames()) as f64
    }

    fn dose(&self, x: &[f64]) -> Vec<f64> {
        let mut dose = vec![0.0; self.places.len()];
        self.each(|voxel, pixel| dose[voxel] += x[pixel]);
        let weight = self.weight();
        dose.iter_mut().for_each(|d| *d *= weight);
        dose
    }

    fn adjoint(&self, dose: &[f64]) -> Vec<f64> {
        let mut x = vec![0.0; self.post.frames() * self.post.pixels];
        self.each(|voxel, pixel| x[pixel] += dose[voxel]);
        let weight = self.weight();
        x.iter_mut().for_each(|v| *v *= weight);
        x
    }

    /// The largest eigenvalue of adjoint·dose, a little over: it belongs to even patterns nearly.
    fn largest(&self) -> f64 {
        let mut x = vec![1.0; self.post.frames() * self.post.pixels];
        let mut value = 1.0;
        for _ in 0..6 {
            let next = self.adjoint(&self.dose(&x));
            value = dot(&next, &next).sqrt() / dot(&x, &x).sqrt();
            x = next;
        }
        1.05 * value
    }
}
