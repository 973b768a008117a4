//! Convolutions of fields on cells, as products of Fourier transforms of zero-padded arrays.
//!
//! Fields are `[y][x][z]`, the layout of a dose. A spectrum holds the half of it that is not redundant, as `[k_z][k_x][k_y]`: every step
//! transforms lines that lie contiguous in memory and leaves out those that hold only zeros. Everything is summed in a fixed
//! order, so the bits do not depend on the number of threads.

use std::sync::Arc;
use tomolith_core::dose::scattered::KernelSpectrum;
use tomolith_core::parallel::{InParallel, elements, table};
use tomolith_fourier::{Complex, ComplexToReal, Fft, RealToComplex};

/// Half the Fourier transform of a padded field.
pub(super) type Spectrum = Vec<Complex<f32>>;

/// The transform of a kernel: real where it is even, imaginary where it is odd.
pub(super) struct Kernel {
    values: Vec<f32>,
    is_odd: bool,
}

/// Transforms fields of one shape.
pub(super) struct Convolver {
    /// Cells along x, y, z.
    cells: [usize; 3],
    /// Elements from one z line of a field to the next.
    row: usize,
    padded: [usize; 3],
    along_x: [Arc<dyn Fft<f32>>; 2],
    along_y: [Arc<dyn Fft<f32>>; 2],
    to_z: Arc<dyn RealToComplex<f32>>,
    from_z: Arc<dyn ComplexToReal<f32>>,
}

/// Lines of y that are gathered together: a cache line of the spectrum.
const TOGETHER: usize = 8;

impl Convolver {
    /// For fields of these cells (x, y, z) whose z lines are `row` elements apart.
    pub(super) fn new(cells: [usize; 3], row: usize) -> Self {
        let padded = cells.map(|n| smooth_even(2 * n - 1));
        let (to_z, from_z) = tomolith_fourier::real(padded[2]);
        Convolver {
            cells,
            row,
            along_x: tomolith_fourier::complex(padded[0]),
            along_y: tomolith_fourier::complex(padded[1]),
            to_z,
            from_z,
            padded,
        }
    }

    /// Elements along x, y, z of the arrays that are transformed.
    pub(super) fn padded(&self) -> [usize; 3] {
        self.padded
    }

    pub(super) fn form(&self, kernel: &Kernel) -> KernelSpectrum {
        let [px, py, _] = self.padded;
        let nk = self.frequencies();
        let place = |i: usize| ((i % nk) * px + i / nk % px) * py + i / (nk * px);
        KernelSpectrum {
            values: table(self.len(), |i| kernel.values[place(i)]),
            is_odd: kernel.is_odd,
        }
    }

    /// Number of frequencies along z.
    fn frequencies(&self) -> usize {
        self.padded[2] / 2 + 1
    }

    /// Elements of a spectrum.
    pub(super) fn len(&self) -> usize {
        self.frequencies() * self.padded[0] * self.padded[1]
    }

    pub(super) fn transform(&self, field: &[f32]) -> Spectrum {
        self.transform_of(self.cells, self.row, field)
    }

    fn transform_of(&self, [nx, ny, nz]: [usize; 3], row: usize, field: &[f32]) -> Spectrum {
        let [px, py, pz] = self.padded;
        let nk = self.frequencies();
        let zero = Complex::new(0.0, 0.0);
        let mut planes = vec![zero; ny * nk * px];
        planes.chunks_mut(nk * px).enumerate().par_each_with(
            || (vec![0.0; pz], self.to_z.make_output_vec()),
            |(line, of_line), (y, plane)| {
                for x in 0..nx {
                    line[..nz].copy_from_slice(&field[(y * nx + x) * row..][..nz]);
                    line[nz..].fill(0.0);
                    let lengths = self.to_z.process(line, of_line);
                    debug_assert!(lengths.is_ok());
                    for (k, &value) in of_line.iter().enumerate() {
                        plane[k * px + x] = value;
                    }
                }
                self.along_x[0].process(plane);
            },
        );
        let mut spectrum = vec![zero; nk * px * py];
        spectrum
            .chunks_mut(px * py)
            .enumerate()
            .par_each(|(k, slab)| {
                for y in 0..ny {
                    let line = &planes[(y * nk + k) * px..][..px];
                    for (x, &value) in line.iter().enumerate() {
                        slab[x * py + y] = value;
                    }
                }
                self.along_y[0].process(slab);
            });
        spectrum
    }

    /// field += the field of a spectrum
    pub(super) fn add_field(&self, mut spectrum: Spectrum, field: &mut [f32]) {
        let [px, py, _] = self.padded;
        let [nx, _, nz] = self.cells;
        let nk = self.frequencies();
        spectrum
            .chunks_mut(px * py)
            .par_each(|slab| self.along_y[1].process(slab));
        let spectrum = &spectrum;
        field
            .chunks_mut(TOGETHER * nx * self.row)
            .enumerate()
            .par_each_with(
                || {
                    (
                        vec![Complex::new(0.0, 0.0); TOGETHER * nk * px],
                        self.from_z.make_input_vec(),
                        self.from_z.make_output_vec(),
                    )
                },
                |(planes, of_line, line), (block, rows)| {
                    let lit = rows.len() / (nx * self.row);
                    for (i, values) in spectrum.chunks_exact(py).enumerate() {
                        for j in 0..lit {
                            planes[j * nk * px + i] = values[block * TOGETHER + j];
                        }
                    }
                    for (plane, rows) in planes
                        .chunks_exact_mut(nk * px)
                        .zip(rows.chunks_exact_mut(nx * self.row))
                    {
                        self.along_x[1].process(plane);
                        for (x, column) in rows.chunks_exact_mut(self.row).enumerate() {
                            for (k, value) in of_line.iter_mut().enumerate() {
                                *value = plane[k * px + x];
                            }
                            // Rounding aside these are real
                            of_line[0].im = 0.0;
                            of_line[nk - 1].im = 0.0;
                            let lengths = self.from_z.process(of_line, line);
                            debug_assert!(lengths.is_ok());
                            for (sum, value) in column[..nz].iter_mut().zip(&*line) {
                                *sum += value;
                            }
                        }
                    }
                },
            );
    }

    /// The transform of a kernel, given for displacements of 0, 1, … cells along x, y, z (`[y][x][z]`) and by its signs under a turn
    /// of each axis. The size of the padded array is divided out here.
    pub(super) fn kernel(&self, octant: &[f32], parities: [f64; 3]) -> Kernel {
        let [nx, ny, nz] = self.cells;
        let [px, py, pz] = self.padded;
        let scale = 1.0 / (px * py * pz) as f32;
        let mut whole = vec![0.0; px * py * pz];
        // Of a place in the padded array: displacement, and whether it is turned over
        let place = |i: usize, n: usize, p: usize| match i {
            i if i < n => Some((i, false)),
            i if p - i < n => Some((p - i, true)),
            _ => None,
        };
        for (i, line) in whole.chunks_exact_mut(pz).enumerate() {
            let (Some(x), Some(y)) = (place(i % px, nx, px), place(i / px, ny, py)) else {
                continue;
            };
            for (z, value) in line.iter_mut().enumerate() {
                let Some(z) = place(z, nz, pz) else { continue };
                let sign: f64 = [x, y, z]
                    .iter()
                    .zip(parities)
                    .map(|(&(_, turned), parity)| if turned { parity } else { 1.0 })
                    .product();
                // An odd kernel is 0 where its axis does not tell the sides apart
                *value = sign as f32 * scale * octant[(y.0 * nx + x.0) * nz + z.0];
            }
        }
        let is_odd = parities.iter().product::<f64>() < 0.0;
        let spectrum = self.transform_of(self.padded, pz, &whole);
        Kernel {
            values: spectrum
                .iter()
                .map(|v| if is_odd { v.im } else { v.re })
                .collect(),
            is_odd,
        }
    }
}

impl Kernel {
    /// sum += kernel · spectrum; with `turned` the kernel of the opposite displacement, which is the transpose.
    pub(super) fn add(&self, spectrum: &Spectrum, turned: bool, sum: &mut Spectrum) {
        let quarter = match (self.is_odd, turned) {
            (false, _) => None,
            (true, false) => Some(1.0),
            (true, true) => Some(-1.0),
        };
        elements(sum, |i, sum| {
            let (value, kernel) = (spectrum[i], self.values[i]);
            *sum += match quarter {
                None => value * kernel,
                Some(sign) => Complex::new(-value.im, value.re) * (sign * kernel),
            };
        });
    }
}

/// The smallest even number of at least `n` without other factors than 2, 3 and 5.
fn smooth_even(n: usize) -> usize {
    let is_smooth = |mut n: usize| {
        for factor in [2, 3, 5] {
            while n.is_multiple_of(factor) {
                n /= factor;
            }
        }
        n == 1
    };
    (n.max(2)..)
        .find(|&n| n % 2 == 0 && is_smooth(n))
        .unwrap_or(n)
}

#[cfg(test)]
mod tests {
    use super::*;
    use tomolith_core::check::noise;

    #[test]
    fn products_are_the_convolution_of_its_definition_even_and_odd() {
        let [nx, ny, nz] = [5, 4, 7];
        let row = 9;
        let convolver = Convolver::new([nx, ny, nz], row);
        let octant = noise(1, nx * ny * nz);
        let mut field = noise(2, nx * ny * row);
        field
            .chunks_exact_mut(row)
            .for_each(|line| line[nz..].fill(0.0));
        for parities in [[1.0; 3], [-1.0, 1.0, 1.0], [-1.0, 1.0, -1.0]] {
            // Odd kernels vanish in the plane that their axis is normal to
            let mut octant = octant.clone();
            for (i, value) in octant.iter_mut().enumerate() {
                let n = [(i / nz) % nx, i / (nz * nx), i % nz];
                if (0..3).any(|axis| parities[axis] < 0.0 && n[axis] == 0) {
                    *value = 0.0;
                }
            }
            let kernel = convolver.kernel(&octant, parities);
            for turned in [false, true] {
                let mut sum = vec![Complex::new(0.0, 0.0); convolver.len()];
                kernel.add(&convolver.transform(&field), turned, &mut sum);
                let mut found = vec![0.0; field.len()];
                convolver.add_field(sum, &mut found);
                for y in 0..ny {
                    for x in 0..nx {
                        for z in 0..nz {
                            let mut expected = 0.0;
                            for (i, line) in field.chunks_exact(row).enumerate() {
                                for (k, &value) in line[..nz].iter().enumerate() {
                                    let from = [i % nx, i / nx, k];
                                    let mut sign = 1.0;
                                    let at: [usize; 3] = std::array::from_fn(|axis| {
                                        let mut d = [x, y, z][axis] as isize - from[axis] as isize;
                                        d = if turned { -d } else { d };
                                        if d < 0 {
                                            sign *= parities[axis] as f32;
                                        }
                                        d.unsigned_abs()
                                    });
                                    expected +=
                                        sign * value * octant[(at[1] * nx + at[0]) * nz + at[2]];
                                }
                            }
                            let found = found[(y * nx + x) * row + z];
                            assert!((found - expected).abs() < 2e-5, "{found} {expected}");
                        }
                    }
                }
            }
        }
    }
}
