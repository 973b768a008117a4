//! Uniform rays: beams of evenly spaced rays, for the kernel `line` on a single slice.
//!
//! A ray crosses two voxels of a row at most, since rows run along the axis that it is closer to. With m its minor coordinate at the
//! row's lower or upper face, whichever is less, and s = |slope| ≤ 1 what it moves across the row, voxel i gets of the ray's way
//!
//! ```text
//! share(i, m) = clamp((i + 1 − m)/s) − clamp((i − m)/s)          clamp: to [0, 1]
//! dose(i)    += Σ_j share(i, m_j)·x_j                             lanes: sixteen voxels of a row
//! g(j)       += share(v, m_j)·c(v) + (1 − share(v, m_j))·c(v + 1),   v = ⌊m_j⌋      lanes: sixteen rays
//! ```
//! Both directions compute a share from the same single-precision numbers by the same operations, so they are one matrix. The rays of a
//! tile are placed in double precision. Tiles where a ray ends, and those with more than [`MOST`] rays, take the common enumerator.
#![expect(
    unsafe_code,
    reason = "kernel file: registers and run-time dispatch need intrinsics"
)]

use super::kernel::Isa;
use super::strips::{Beam, Major, Strip};
use super::tiles::{TILE, Tile};
use super::uniform_strips::Square;
use std::ops::Range;
use tomolith_core::grid::{PatternGrid, VolumeGrid};

/// Rays that a tile may meet at most: two registers.
pub(super) const MOST: usize = 32;
/// Least slope, in voxels a row: a ray along a face belongs to one side of it.
const LEAST_SLOPE: f32 = 1e-6;
/// Where no voxel is.
const NOWHERE: f32 = 1e9;
/// Rays this much beside a voxel are asked too, as a share of their distance: rounding decides no tap.
const SLACK: f32 = 0.01;

/// A beam of evenly spaced rays.
#[derive(Clone, Debug)]
pub(super) struct UniformRays {
    /// Minor coordinate of the first ray of the beam at row 0, its growth per row, and from ray to ray; voxels.
    first: f64,
    slope: f64,
    spacing: f64,
    /// Column of the first ray, and whether columns fall from ray to ray.
    column: usize,
    reversed: bool,
    /// Weight of a whole row.
    per_row: f32,
}

impl UniformRays {
    /// Of a beam of the kernel `line`; None without any rays.
    pub(super) fn new(beam: &Beam, pixels: &PatternGrid, grid: &VolumeGrid) -> Option<Self> {
        let strip = beam.strips.first()?;
        let [offset, per_mm, slope] = beam.minor(grid);
        let column = strip.column as usize;
        Some(UniformRays {
            first: offset + pixels.column_u(column) * per_mm,
            slope,
            spacing: per_mm.abs() * pixels.pitch_mm[0],
            column,
            reversed: per_mm < 0.0,
            per_row: strip.power * strip.row_mm,
        })
    }

    /// Whether these strips of the beam cross a tile from end to end, and two registers hold them.
    pub(super) fn holds(strips: &[Strip], tile: &Tile, major: Major) -> bool {
        let along = usize::from(major == Major::Y);
        let (first, end) = (tile.start[along], tile.start[along] + tile.size[along]);
        (1..=MOST).contains(&strips.len())
            && strips
                .iter()
                .all(|strip| strip.span[0] <= first as f32 && strip.span[1] >= end as f32)
    }

    /// Rays `strips` of the beam, as a tile sees them.
    pub(super) fn rays(&self, strips: Range<usize>, tile: &Tile, major: Major) -> Rays {
        let (along, across) = major.axes();
        let [row, voxel] = [tile.start[along], tile.start[across]];
        let start = self.first + self.slope * row as f64 - voxel as f64;
        let mut places = [NOWHERE; MOST];
        for (place, ray) in places.iter_mut().zip(strips.clone()) {
            *place = (start + self.spacing * ray as f64) as f32;
        }
        let slope = self.slope as f32;
        let moved = slope.abs().max(LEAST_SLOPE);
        Rays {
            count: strips.len(),
            rows: tile.size[along],
            places,
            steps: std::array::from_fn(|row| slope * row as f32 + slope.min(0.0)),
            moved,
            inverse: 1.0 / moved,
            per_spacing: (1.0 / self.spacing) as f32,
        }
    }

    /// Pixel columns of rays `strips`, in their order.
    pub(super) fn columns(&self, strips: Range<usize>) -> impl Iterator<Item = usize> + use<> {
        let (column, reversed) = (self.column, self.reversed);
        strips.map(move |ray| if reversed { column - ray } else { column + ray })
    }

    /// Weight of a whole row.
    pub(super) fn per_row(&self) -> f32 {
        self.per_row
    }
}

/// The rays that meet a tile.
pub(super) struct Rays {
    pub(super) count: usize,
    rows: usize,
    /// Minor coordinate of each at the tile's first face, in voxels of the tile.
    places: [f32; MOST],
    /// What is added to it for the lower end of each row.
    steps: [f32; TILE],
    /// |slope|, and 1/|slope|.
    moved: f32,
    inverse: f32,
    /// Rays per voxel.
    per_spacing: f32,
}

impl Rays {
    /// Rays that may light a voxel at most.
    fn taps(&self) -> usize {
        ((1.0 + self.moved) * self.per_spacing + 1.0 + 2.0 * SLACK) as usize + 1
    }

    /// Adds to the voxels of a tile what rays of these values bring: `[row · TILE + across]`.
    pub(super) fn add_dose(&self, isa: Isa, values: &[f32; MOST], out: &mut Square) {
        match isa {
            #[cfg(target_arch = "x86_64")]
            // SAFETY: AVX-512F was detected (Isa values other than Scalar come from `available`).
            Isa::Avx512 => unsafe { x86::dose(self, values, out) },
            _ => plain_dose(self, values, out),
        }
    }

    /// What the cotangent of a tile gives to the rays.
    pub(super) fn adjoint(&self, isa: Isa, cotangent: &Square) -> [f32; MOST] {
        match isa {
            #[cfg(target_arch = "x86_64")]
            // SAFETY: AVX-512F was detected, as above.
            Isa::Avx512 => unsafe { x86::adjoint(self, cotangent) },
            _ => plain_adjoint(self, cotangent),
        }
    }

    /// The first voxel of a ray in a row, counted from the one before the tile, and its share of the way; the next one has the rest.
    fn cut(&self, ray: usize, row: usize) -> (usize, f32) {
        let place = self.places[ray] + self.steps[row];
        let voxel = place.floor();
        if voxel < -1.0 {
            return (0, 1.0);
        }
        let share = ((voxel + 1.0 - place) * self.inverse).min(1.0);
        ((voxel + 1.0).min(TILE as f32 + 1.0) as usize, share)
    }
}

/// Voxels of a row and one beyond either end, and one more that a ray beyond them reaches.
const WIDE: usize = TILE + 3;

/// The plain twin of the dose.
fn plain_dose(rays: &Rays, values: &[f32; MOST], out: &mut Square) {
    for (row, out) in out.chunks_exact_mut(TILE).enumerate().take(rays.rows) {
        let mut line = [0.0f32; WIDE];
        for (ray, value) in values.iter().enumerate().take(rays.count) {
            let (voxel, share) = rays.cut(ray, row);
            line[voxel] += share * value;
            line[voxel + 1] += (1.0 - share) * value;
        }
        for (out, sum) in out.iter_mut().zip(&line[1..]) {
            *out += sum;
        }
    }
}

/// The plain twin of the adjoint.
fn plain_adjoint(rays: &Rays, cotangent: &Square) -> [f32; MOST] {
    let mut sums = [0.0; MOST];
    for (row, values) in cotangent.chunks_exact(TILE).enumerate().take(rays.rows) {
        let mut line = [0.0f32; WIDE];
        line[1..=TILE].copy_from_slice(values);
        for (ray, sum) in sums.iter_mut().enumerate().take(rays.count) {
            let (voxel, share) = rays.cut(ray, row);
            *sum += share * line[voxel] + (1.0 - share) * line[voxel + 1];
        }
    }
    sums
}

#[cfg(target_arch = "x86_64")]
mod x86 {
    use super::{MOST, Rays, SLACK, Square, TILE};
    #[cfg(doc)]
    use super::{plain_adjoint, plain_dose};
    use std::arch::x86_64::*;

    /// Sixteen of thirty-two values.
    #[target_feature(enable = "avx512f")]
    fn half(values: &[f32; MOST], first: usize) -> __m512 {
        let window = &values[first..first + 16];
        // SAFETY: the window has sixteen floats.
        unsafe { _mm512_loadu_ps(window.as_ptr()) }
    }

    #[target_feature(enable = "avx512f")]
    fn to_unit(value: __m512) -> __m512 {
        _mm512_min_ps(
            _mm512_max_ps(value, _mm512_setzero_ps()),
            _mm512_set1_ps(1.0),
        )
    }

    /// See [`plain_dose`].
    #[target_feature(enable = "avx512f")]
    pub(super) fn dose(rays: &Rays, values: &[f32; MOST], out: &mut Square) {
        let places = [half(&rays.places, 0), half(&rays.places, 16)];
        let values = [half(values, 0), half(values, 16)];
        let lanes = _mm512_setr_ps(
            0., 1., 2., 3., 4., 5., 6., 7., 8., 9., 10., 11., 12., 13., 14., 15.,
        );
        let upper = _mm512_add_ps(lanes, _mm512_set1_ps(1.0));
        let inverse = _mm512_set1_ps(rays.inverse);
        let per_spacing = _mm512_set1_ps(rays.per_spacing);
        let (next, most) = (_mm512_set1_epi32(1), _mm512_set1_epi32(MOST as i32));
        let taps = rays.taps();
        for (out, &step) in out.chunks_exact_mut(TILE).zip(&rays.steps).take(rays.rows) {
            // The first ray that may reach a voxel: its upper end lies behind the voxel's lower face
            let nearest = _mm512_set1_ps(rays.places[0] + step + rays.moved);
            let number = _mm512_fmsub_ps(
                _mm512_sub_ps(lanes, nearest),
                per_spacing,
                _mm512_set1_ps(SLACK),
            );
            let mut ray =
                _mm512_cvt_roundps_epi32::<{ _MM_FROUND_TO_NEG_INF | _MM_FROUND_NO_EXC }>(number);
            let step = _mm512_set1_ps(step);
            let mut sum = _mm512_setzero_ps();
            for _ in 0..taps {
                let is_one = _mm512_cmplt_epu32_mask(ray, most);
                let place = _mm512_permutex2var_ps(places[0], ray, places[1]);
                let place = _mm512_add_ps(place, step);
                let share =
                    |face: __m512| to_unit(_mm512_mul_ps(_mm512_sub_ps(face, place), inverse));
                let share = _mm512_sub_ps(share(upper), share(lanes));
                let value = _mm512_permutex2var_ps(values[0], ray, values[1]);
                sum = _mm512_mask3_fmadd_ps(share, value, sum, is_one);
                ray = _mm512_add_epi32(ray, next);
            }
            // SAFETY: `out` has sixteen floats.
            unsafe {
                let before = _mm512_loadu_ps(out.as_ptr());
                _mm512_storeu_ps(out.as_mut_ptr(), _mm512_add_ps(before, sum));
            }
        }
    }

    /// See [`plain_adjoint`].
    #[target_feature(enable = "avx512f")]
    pub(super) fn adjoint(rays: &Rays, cotangent: &Square) -> [f32; MOST] {
        let one = _mm512_set1_ps(1.0);
        let inverse = _mm512_set1_ps(rays.inverse);
        let (next, end) = (_mm512_set1_epi32(1), _mm512_set1_epi32(TILE as i32));
        let mut found = [0.0; MOST];
        for (i, found) in found.chunks_exact_mut(16).enumerate() {
            if 16 * i >= rays.count {
                break;
            }
            let places = half(&rays.places, 16 * i);
            let mut sum = _mm512_setzero_ps();
            let rows = cotangent.chunks_exact(TILE).zip(&rays.steps);
            for (values, &step) in rows.take(rays.rows) {
                // SAFETY: `values` has sixteen floats.
                let values = unsafe { _mm512_loadu_ps(values.as_ptr()) };
                let place = _mm512_add_ps(places, _mm512_set1_ps(step));
                let first = _mm512_roundscale_ps::<{ _MM_FROUND_TO_NEG_INF }>(place);
                let way = _mm512_sub_ps(_mm512_add_ps(first, one), place);
                let share = _mm512_min_ps(_mm512_mul_ps(way, inverse), one);
                let voxel = _mm512_cvttps_epi32(first);
                let after = _mm512_add_epi32(voxel, next);
                let look = |voxel: __m512i| {
                    let is_one = _mm512_cmplt_epu32_mask(voxel, end);
                    _mm512_maskz_permutexvar_ps(is_one, voxel, values)
                };
                sum = _mm512_fmadd_ps(share, look(voxel), sum);
                sum = _mm512_fmadd_ps(_mm512_sub_ps(one, share), look(after), sum);
            }
            // SAFETY: `found` has sixteen floats.
            unsafe { _mm512_storeu_ps(found.as_mut_ptr(), sum) };
        }
        found
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use tomolith_core::check::noise;

    /// Some rays of a tile, with sentinels behind them.
    fn rays(slope: f64, spacing: f64, place: f64, count: usize) -> Rays {
        let uniform = UniformRays {
            first: place,
            slope,
            spacing,
            column: 0,
            reversed: false,
            per_row: 1.0,
        };
        let tile = Tile {
            start: [0, 0],
            size: [13, TILE],
        };
        uniform.rays(0..count, &tile, Major::X)
    }

    #[test]
    fn every_path_is_the_length_of_rays_in_voxels_and_the_adjoint_its_transpose() {
        for (slope, spacing, place) in [
            (0.6, 1.17, -9.3),
            (-0.6, 1.17, -0.4),
            (1.0, std::f64::consts::SQRT_2, -16.1),
            (-0.0175, 1.0002, -1.5),
            (0.0, 1.0, -2.0),
            (0.0, 1.0, -2.5),
            (0.3, 0.7, -4.0),
            (-0.9, 2.7, -3.3),
        ] {
            let rays = rays(slope, spacing, place, 31);
            let mut values: [f32; MOST] = [0.0; MOST];
            values[..31].copy_from_slice(&noise(1, 31));
            let mut expected = [0.0f64; TILE * TILE];
            for row in 0..13 {
                for (ray, &value) in values.iter().enumerate().take(31) {
                    let at = |t: f64| place + spacing * ray as f64 + slope * t;
                    let (a, b) = (at(row as f64), at(row as f64 + 1.0));
                    let (low, high) = (a.min(b), a.max(b).max(a.min(b) + 1e-9));
                    for voxel in 0..TILE {
                        let inside = high.min(voxel as f64 + 1.0) - low.max(voxel as f64);
                        expected[row * TILE + voxel] +=
                            f64::from(value) * inside.max(0.0) / (high - low);
                    }
                }
            }
            let mut cotangent = [0.0; TILE * TILE];
            cotangent[..13 * TILE].copy_from_slice(&noise(2, 13 * TILE));
            for isa in Isa::available() {
                let mut out = [0.0; TILE * TILE];
                rays.add_dose(isa, &values, &mut out);
                // Single precision of a place up to 40, over the slope
                let allowed = 1e-5 + 4e-6 / slope.abs().max(0.1);
                let allowed = if slope.abs() < 0.1 { 5e-4 } else { allowed };
                for (i, (&found, &expected)) in out.iter().zip(&expected).enumerate() {
                    assert!(
                        (f64::from(found) - expected).abs() < allowed,
                        "{isa:?} {slope} {spacing}: voxel {i}: {found} for {expected}"
                    );
                }
                let back = rays.adjoint(isa, &cotangent);
                let dot = |a: &[f32], b: &[f32]| -> f64 {
                    let both = a.iter().zip(b);
                    both.map(|(&a, &b)| f64::from(a) * f64::from(b)).sum()
                };
                let (forward, backward) = (dot(&out, &cotangent), dot(&values[..31], &back[..31]));
                assert!(
                    (forward - backward).abs() < 1e-5,
                    "{isa:?} {slope} {spacing}: {forward} {backward}"
                );
            }
        }
    }
}
