//! Diffusion by cosine modes: exact in time for an even D between walls that nothing passes.
//!
//! **Equation** v = Σ_k v̂_k cos(k_x(x + ½h)) cos … with k = π(i, j, l)/(n h) along x, y, z, so that no mode has flux through the walls;
//! v̂_k ← g(|k|²)·v̂_k. Diffusion over t: g = e^(−D|k|²t). Any such map is symmetric: it is its own transpose.
//!
//! **Source** eigenfunctions of the Laplacian with Neumann walls; transforms (DCT-II and DCT-III) by [`tomolith_fourier::cosine`].
//!
//! **Cost** three passes over the volume, two transforms of length n per line and axis; the multiplier is applied within the middle pass.
//!
//! ```
//! use tomolith_core::grid::VolumeGrid;
//! use tomolith_material::{domain::Domain, diffusion::spectral::{Modes, Spectral}};
//! // One period of 0.2 mm along x, 40 samples: D = 1e-4 mm²/s takes e^(−Dk²·40 s) = 0.0193 of it
//! let domain = Domain::new(VolumeGrid::centered([1, 1, 40], 0.005));
//! let wave: Vec<f32> = (0..40).map(|i| (std::f32::consts::TAU * (i as f32 + 0.5) / 40.0).cos()).collect();
//! let mut v = wave.clone();
//! let spectral = Spectral::new(domain.layout());
//! spectral.multiply(&mut v, &Modes::diffusion(&spectral, 1e-4, 40.0));
//! assert!((v[0] / wave[0] - 0.0193).abs() < 1e-4);
//! ```

use std::f64::consts::PI;
use tomolith_core::dose::DoseLayout;
use tomolith_core::field::{HostField, LANES};
use tomolith_core::parallel::InParallel;
use tomolith_fourier::{Complex, Cosine};

/// Transforms for one layout.
#[derive(Clone)]
pub struct Spectral {
    layout: DoseLayout,
    /// Along z, y, x; None for an axis of one voxel.
    plans: [Option<Cosine>; 3],
}

/// What every mode is multiplied with.
pub enum Modes {
    /// A product of factors along z, y, x.
    Product([Vec<f32>; 3]),
    /// One per mode, in the order of the layout.
    Table(HostField),
}

impl Modes {
    /// e^(−Dk²t), mm²/s and s.
    #[must_use]
    pub fn diffusion(spectral: &Spectral, diffusion: f64, seconds: f64) -> Self {
        let factor = |axis: usize| {
            let scale = spectral.scale(axis);
            spectral
                .squares(axis)
                .into_iter()
                .map(|k2| (scale * (-diffusion * k2 * seconds).exp()) as f32)
                .collect()
        };
        Modes::Product([factor(0), factor(1), factor(2)])
    }

    /// g(|k|²), k in 1/mm.
    #[must_use]
    pub fn of(spectral: &Spectral, g: impl Fn(f64) -> f64 + Sync) -> Self {
        let [kz, ky, kx] = [0, 1, 2].map(|axis| spectral.squares(axis));
        let scale = spectral.scale(0) * spectral.scale(1) * spectral.scale(2);
        let row = spectral.layout.row;
        let mut table = HostField::zeros(spectral.layout.voxels());
        if !table.as_slice().is_empty() {
            let planes = table.as_mut_slice().chunks_mut(kx.len() * row).zip(&ky);
            planes.par_each(|(plane, ky)| {
                for (row, kx) in plane.chunks_exact_mut(row).zip(&kx) {
                    for (value, kz) in row.iter_mut().zip(&kz) {
                        *value = (scale * g(kx + ky + kz)) as f32;
                    }
                }
            });
        }
        Modes::Table(table)
    }
}

/// Lines that are transformed side by side, so that a cache line is used whole.
struct Lines {
    buffer: Vec<f32>,
    scratch: Vec<Complex<f32>>,
}

impl Lines {
    fn of(plan: &Option<Cosine>) -> Self {
        Lines {
            buffer: vec![0.0; plan.as_ref().map_or(0, Cosine::len) * LANES],
            scratch: plan.as_ref().map_or(Vec::new(), Cosine::scratch),
        }
    }
}

impl Spectral {
    /// Transforms for volumes of this layout (without cells).
    #[must_use]
    pub fn new(layout: &DoseLayout) -> Self {
        let plans = layout
            .grid
            .shape
            .map(|n| (n > 1).then(|| tomolith_fourier::cosine(n)));
        Spectral {
            layout: layout.clone(),
            plans,
        }
    }

    /// k² of the modes along z, y or x (axis 0, 1, 2), 1/mm².
    fn squares(&self, axis: usize) -> Vec<f64> {
        let grid = &self.layout.grid;
        let n = grid.shape[axis];
        let pitch = if axis == 0 {
            grid.height_mm
        } else {
            grid.pitch_mm
        };
        let first = PI / (n as f64 * pitch);
        (0..n).map(|i| (i as f64 * first).powi(2)).collect()
    }

    /// What a transform there and back multiplies with, inverted.
    fn scale(&self, axis: usize) -> f64 {
        let n = self.layout.grid.shape[axis];
        if n > 1 { 2.0 / n as f64 } else { 1.0 }
    }

    /// Multiplies the modes of a volume; padding stays as it is.
    ///
    /// # Panics
    /// When the volume is shorter than the layout.
    pub fn multiply(&self, volume: &mut [f32], modes: &Modes) {
        let volume = &mut volume[..self.layout.voxels()];
        if volume.is_empty() {
            return;
        }
        self.along_z_and_x(volume, true);
        self.along_y(volume, modes);
        self.along_z_and_x(volume, false);
    }

    fn along_z_and_x(&self, volume: &mut [f32], forward: bool) {
        let ([nz, _, nx], row) = (self.layout.grid.shape, self.layout.row);
        let [of_z, _, of_x] = &self.plans;
        let transform = if forward {
            Cosine::forward
        } else {
            Cosine::inverse
        };
        let start = || (Lines::of(of_z), Lines::of(of_x));
        volume
            .chunks_mut(nx * row)
            .par_each_with(start, |(z_lines, x_lines), plane| {
                if let Some(plan) = of_z {
                    for line in plane.chunks_exact_mut(row) {
                        transform(plan, &mut line[..nz], &mut z_lines.scratch);
                    }
                }
                let Some(plan) = of_x else { return };
                for from in (0..nz).step_by(LANES) {
                    let lanes = LANES.min(nz - from);
                    for x in 0..nx {
                        for lane in 0..lanes {
                            x_lines.buffer[lane * nx + x] = plane[x * row + from + lane];
                        }
                    }
                    for line in x_lines.buffer.chunks_exact_mut(nx).take(lanes) {
                        transform(plan, line, &mut x_lines.scratch);
                    }
                    for x in 0..nx {
                        for lane in 0..lanes {
                            plane[x * row + from + lane] = x_lines.buffer[lane * nx + x];
                        }
                    }
                }
            });
    }

    /// There, the multiplier, and back.
    fn along_y(&self, volume: &mut [f32], modes: &Modes) {
        let ([nz, ny, nx], row) = (self.layout.grid.shape, self.layout.row);
        // The rows of each x, for a thread to own
        let mut columns: Vec<Vec<&mut [f32]>> = (0..nx).map(|_| Vec::with_capacity(ny)).collect();
        for (i, line) in volume.chunks_exact_mut(row).enumerate() {
            columns[i % nx].push(line);
        }
        let plan = &self.plans[1];
        columns.into_iter().enumerate().par_each_with(
            || Lines::of(plan),
            |lines, (x, mut rows)| {
                let at = |y: usize, z: usize| match modes {
                    Modes::Product([of_z, of_y, of_x]) => of_x[x] * of_y[y] * of_z[z],
                    Modes::Table(table) => table.as_slice()[(y * nx + x) * row + z],
                };
                let Some(plan) = plan else {
                    for (z, value) in rows[0].iter_mut().enumerate().take(nz) {
                        *value *= at(0, z);
                    }
                    return;
                };
                for from in (0..nz).step_by(LANES) {
                    let lanes = LANES.min(nz - from);
                    for (y, row) in rows.iter().enumerate() {
                        for lane in 0..lanes {
                            lines.buffer[lane * ny + y] = row[from + lane];
                        }
                    }
                    for (lane, line) in lines.buffer.chunks_exact_mut(ny).take(lanes).enumerate() {
                        plan.forward(line, &mut lines.scratch);
                        for (y, value) in line.iter_mut().enumerate() {
                            *value *= at(y, from + lane);
                        }
                        plan.inverse(line, &mut lines.scratch);
                    }
                    for (y, row) in rows.iter_mut().enumerate() {
                        for lane in 0..lanes {
                            row[from + lane] = lines.buffer[lane * ny + y];
                        }
                    }
                }
            },
        );
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::domain::Domain;
    use tomolith_core::check::noise;
    use tomolith_core::grid::{Volume, VolumeGrid};
    use tomolith_core::near;

    #[test]
    fn nothing_changes_without_time_and_every_factor_is_that_of_its_mode() {
        for shape in [[1, 9, 7], [5, 1, 6], [18, 7, 11], [4, 6, 1], [1, 1, 1]] {
            let grid = VolumeGrid {
                height_mm: 0.07,
                ..VolumeGrid::centered(shape, 0.05)
            };
            let domain = Domain::new(grid.clone());
            let spectral = Spectral::new(domain.layout());
            let values = noise(4, grid.len());
            let volume = Volume::new(grid.clone(), values);
            let field = domain.layout().field_of(&volume);
            let mut same = field.clone();
            spectral.multiply(&mut same, &Modes::diffusion(&spectral, 1e-4, 0.0));
            for (a, b) in field.iter().zip(&same) {
                assert!((a - b).abs() < 2e-6, "{shape:?}");
            }
            // A product of one cosine per axis is an eigenfunction
            let orders = shape.map(|n| n.min(3) - 1);
            let wave = |i: usize, n: usize, order: usize| {
                (PI * order as f64 * (i as f64 + 0.5) / n as f64).cos()
            };
            let mut mode = Volume::filled(grid.clone(), 0.0f32);
            for (i, v) in mode.values.iter_mut().enumerate() {
                let at = [
                    i / shape[2] / shape[1],
                    i / shape[2] % shape[1],
                    i % shape[2],
                ];
                *v = (0..3)
                    .map(|a| wave(at[a], shape[a], orders[a]))
                    .product::<f64>() as f32;
            }
            let pitch = [0.07, 0.05, 0.05];
            let k2: f64 = (0..3)
                .map(|a| (PI * orders[a] as f64 / (shape[a] as f64 * pitch[a])).powi(2))
                .sum();
            for (modes, factor) in [
                (
                    Modes::diffusion(&spectral, 1e-4, 7.0),
                    (-1e-4 * k2 * 7.0).exp(),
                ),
                (
                    Modes::of(&spectral, |k2| 1.0 / (1.0 + k2)),
                    1.0 / (1.0 + k2),
                ),
            ] {
                let mut field = domain.layout().field_of(&mode);
                spectral.multiply(&mut field, &modes);
                let found = domain.layout().volume_of(&field);
                for (a, b) in mode.values.iter().zip(&found.values) {
                    near!(f64::from(*a) * factor, f64::from(*b), 2e-6, "{shape:?}");
                }
            }
        }
    }

    #[test]
    fn a_smooth_spot_spreads_by_2dt_exactly_and_keeps_its_mass() {
        let domain = Domain::new(VolumeGrid::centered([40, 36, 38], 0.05));
        let layout = domain.layout();
        let sigma2 = 0.1f64 * 0.1;
        let g = domain.grid().clone();
        let bell = Volume::from_fn(g.clone(), |middle| {
            let r2: f64 = middle.iter().map(|v| v * v).sum();
            (-r2 / (2.0 * sigma2)).exp() as f32
        });
        let mut spot = HostField::from_slice(&layout.field_of(&bell));
        let moments = |field: &HostField| {
            let volume = layout.volume_of(field.as_slice());
            let (mut mass, mut square) = (0.0, 0.0);
            for (i, &v) in volume.values.iter().enumerate() {
                mass += f64::from(v);
                square += f64::from(v) * g.middle(i)[0].powi(2);
            }
            (mass, square / mass)
        };
        let (mass, before) = moments(&spot);
        let spectral = Spectral::new(layout);
        spectral.multiply(
            spot.as_mut_slice(),
            &Modes::diffusion(&spectral, 1e-4, 60.0),
        );
        let (after, variance) = moments(&spot);
        assert!((after / mass - 1.0).abs() < 1e-6);
        assert!(((variance - before) / (2.0 * 1e-4 * 60.0) - 1.0).abs() < 1e-3);
    }
}
