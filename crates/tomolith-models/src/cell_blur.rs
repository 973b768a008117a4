//! Blur by cells, and the stencil that undoes it.
//!
//! A mean over an edge h, and linear interpolation between points h apart, take from a wave of wave number k along an axis
//!
//! ```text
//! 1 − v k²/2 + O(k⁴)        v = h²/12 and h²/6
//! ```
//! Second moments v add up. In `successive_orders` light on its way from unscattered light to the dose of voxels meets the mean over pixels that are taken
//! together, over a cell as a source, over a cell as a receiver and interpolation; in `monte_carlo` the last two. On cells h apart
//!
//! ```text
//! u_i → u_i + Σ_axes v/(2h²) (2u_i − u_{i−1} − u_{i+1}) = (1 + v k²/2 + O(k⁴)) u_i
//! ```
//! gives it back, so that waves are off by the fourth power of kh instead of the second. What a cell gains its neighbors lose. Cells that
//! are not all resin neither give nor take: light is not smeared through a wall that cells end at.
//!
//! # Limits
//! Waves shorter than three cells stay smeared, and edges of light within a cell are rounded: docs/scattering.md.

use crate::DoseLayout;
use std::ops::Add;
use std::sync::Arc;
use tomolith_core::parallel::lines;

/// Second moments along x, y, z, mm².
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct CellBlur([f64; 3]);

impl CellBlur {
    /// Of a mean over an edge, mm.
    pub(super) fn mean(edge: f64) -> Self {
        CellBlur([edge * edge / 12.0; 3])
    }

    /// Of linear interpolation between points this far apart, mm.
    pub(super) fn interpolation(edge: f64) -> Self {
        CellBlur([edge * edge / 6.0; 3])
    }

    /// Of a mean over cells of so many voxels along an edge and interpolation to the middles of voxels, less the mean over a
    /// voxel, which is wanted. Middles of voxels meet those of cells where their number is odd: t(1 − t) h² is less there than its mean
    /// over all places.
    pub(super) fn cells(voxels: usize, pitch: f64) -> Self {
        let count = voxels as f64;
        let quarter = (count * pitch).powi(2) / 4.0;
        let met = if voxels % 2 == 1 {
            1.0 - count.powi(-2)
        } else {
            1.0
        };
        CellBlur([quarter * met; 3])
    }

    /// Of pixels `from` wide and high that are taken together to larger ones, mm: a mean over as many as lie in one, which is lit
    /// evenly. In light from all sides half of the width is along either axis.
    pub(super) fn bins(from: [f64; 2], to: [f64; 2]) -> Self {
        let [across, along] = [0, 1].map(|i| (to[i] * to[i] - from[i] * from[i]) / 6.0);
        CellBlur([across / 2.0, across / 2.0, along])
    }
}

impl Add for CellBlur {
    type Output = Self;

    fn add(self, other: Self) -> Self {
        CellBlur(std::array::from_fn(|axis| self.0[axis] + other.0[axis]))
    }
}

/// Brings back what is smeared out on cells.
pub(super) struct Sharpen {
    layout: DoseLayout,
    /// v/(2h²) along x, y, z.
    strength: [f32; 3],
    is_full: IsFull,
}

/// Of each cell, padding included: whether it is all resin.
pub(super) type IsFull = Arc<Vec<bool>>;

/// The cells of which all corners, a millionth of an edge within, are in the resin.
pub(super) fn full_cells(
    layout: &DoseLayout,
    in_resin: impl Fn([f64; 3]) -> bool + Sync,
) -> IsFull {
    const WITHIN: f64 = 0.5 - 1e-6;
    let [nz, _, nx] = layout.grid.shape;
    let half = WITHIN * layout.grid.pitch_mm;
    let is_full = |middle: [f64; 3]| {
        (0..8).all(|corner: u8| {
            let side = |axis: usize| if corner >> axis & 1 == 0 { -half } else { half };
            in_resin(std::array::from_fn(|axis| middle[axis] + side(axis)))
        })
    };
    let mut all = vec![false; layout.len()];
    lines(&mut all, layout.row, |i, line| {
        let (x, y) = (layout.grid.x(i % nx), layout.grid.y(i / nx));
        for (z, full) in line[..nz].iter_mut().enumerate() {
            *full = is_full([x, y, layout.grid.z(z)]);
        }
    });
    Arc::new(all)
}

impl Sharpen {
    /// For fields on cells of which some are all resin.
    pub(super) fn new(layout: &DoseLayout, is_full: &IsFull, CellBlur(moments): CellBlur) -> Self {
        let square = layout.grid.pitch_mm * layout.grid.pitch_mm;
        Sharpen {
            layout: layout.clone(),
            strength: moments.map(|v| (v / (2.0 * square)) as f32),
            is_full: Arc::clone(is_full),
        }
    }

    /// Strength along x, y, z.
    pub(super) fn strength(&self) -> [f32; 3] {
        self.strength
    }

    /// The cells that are sharpened.
    pub(super) fn is_full(&self) -> &IsFull {
        &self.is_full
    }

    /// The sharper field. Its own transpose.
    pub(super) fn of(&self, field: &[f32]) -> Vec<f32> {
        let [nz, ny, nx] = self.layout.grid.shape;
        let row = self.layout.row;
        let [along_x, along_y, along_z] = self.strength;
        let mut sharp = field.to_vec();
        lines(&mut sharp[self.layout.range()], row, |i, line| {
            let (y, x) = (i / nx, i % nx);
            let (cells, is_full) = (&field[i * row..][..nz], &self.is_full[i * row..][..nz]);
            let mut take = |from: Option<usize>, strength: f32| {
                let Some(from) = from else {
                    return;
                };
                let (other, also) = (
                    &field[from * row..][..nz],
                    &self.is_full[from * row..][..nz],
                );
                for k in 0..nz {
                    let is_open = f32::from(u8::from(is_full[k] & also[k]));
                    line[k] += is_open * strength * (cells[k] - other[k]);
                }
            };
            take((x > 0).then(|| i - 1), along_x);
            take((x + 1 < nx).then_some(i + 1), along_x);
            take((y > 0).then(|| i - nx), along_y);
            take((y + 1 < ny).then_some(i + nx), along_y);
            for k in 1..nz {
                let is_open = f32::from(u8::from(is_full[k - 1] & is_full[k]));
                let step = is_open * along_z * (cells[k - 1] - cells[k]);
                line[k - 1] += step;
                line[k] -= step;
            }
        });
        sharp
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use std::f64::consts::PI;
    use tomolith_core::check::noise;
    use tomolith_core::grid::VolumeGrid;

    fn sharpen(shape: [usize; 3], blur: CellBlur) -> Sharpen {
        let layout = DoseLayout::new("dose", VolumeGrid::centered(shape, 0.3), 0);
        let is_full = full_cells(&layout, |_| true);
        Sharpen::new(&layout, &is_full, blur)
    }

    #[test]
    fn waves_come_back_to_the_fourth_power_of_their_number() {
        // A mean takes sin(kh/2)/(kh/2), linear interpolation its square
        let half = |phase: f64| (phase / 2.0).sin() / (phase / 2.0);
        let all = CellBlur::mean(0.3) + CellBlur::mean(0.3) + CellBlur::interpolation(0.3);
        for axis in 0..3 {
            let mut shape = [1; 3];
            shape[2 - axis] = 33;
            let sharpen = sharpen(shape, all);
            let left = |phase: f64| {
                let mut wave = vec![0.0; sharpen.layout.len()];
                let place = |i: usize| {
                    let mut at = [0; 3];
                    at[2 - axis] = i;
                    sharpen.layout.index(at[0], at[1], at[2])
                };
                for i in 0..33 {
                    let smeared = half(phase).powi(4) * (phase * (i as f64 - 16.0)).cos();
                    wave[place(i)] = smeared as f32;
                }
                1.0 - f64::from(sharpen.of(&wave)[place(16)])
            };
            let (long, short) = (left(PI / 8.0), left(PI / 4.0));
            assert!((short / long - 16.0).abs() < 2.0, "{short} {long}");
            // A wave of 8 cells: 1.0 % is missing, 9.8 % without
            assert!((0.009..0.011).contains(&short), "{short}");
            assert!((1.0 - half(PI / 4.0).powi(4) - 0.098).abs() < 1e-3);
        }
    }

    #[test]
    fn it_is_its_own_transpose_and_keeps_energy_where_cells_are_partly_resin() {
        let mut sharpen = sharpen(
            [5, 6, 7],
            CellBlur::mean(0.5) + CellBlur::bins([0.1; 2], [0.4, 0.2]),
        );
        let is_full = Arc::make_mut(&mut sharpen.is_full);
        is_full
            .iter_mut()
            .step_by(5)
            .for_each(|is_full| *is_full = false);
        let fields = [1, 2].map(|seed| {
            let mut field = vec![0.0; sharpen.layout.len()];
            let values = noise(seed, 5 * 42);
            for (line, values) in field.chunks_mut(sharpen.layout.row).zip(values.chunks(5)) {
                line[..5].copy_from_slice(values);
            }
            field
        });
        let sharp = [0, 1].map(|i| sharpen.of(&fields[i]));
        let dot = |a: &[f32], b: &[f32]| a.iter().zip(b).map(|(a, b)| a * b).sum::<f32>();
        let (forth, back) = (dot(&sharp[0], &fields[1]), dot(&fields[0], &sharp[1]));
        assert!((forth - back).abs() < 1e-4, "{forth} {back}");
        assert_ne!(sharp[0], fields[0]);
        let sums = [&sharp[0], &fields[0]].map(|field| field.iter().sum::<f32>());
        assert!((sums[0] - sums[1]).abs() < 1e-4, "{sums:?}");
    }

    #[test]
    fn pixels_as_they_are_smear_nothing() {
        assert_eq!(CellBlur::bins([0.1, 0.2], [0.1, 0.2]), CellBlur([0.0; 3]));
    }
}
