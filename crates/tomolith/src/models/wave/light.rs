//! Dose and pullback of one light.

use super::number::Number;
use super::spectrum::{Mode, Scratch, Waves};
use super::turn::{Sorted, TILE, TileEntries, Turn};
use crate::error::{Error, Result};
use crate::models::{PatternLayout, Run};
use rayon::prelude::*;
use rustfft::num_complex::Complex;
use std::ops::Range;
use std::sync::Mutex;

/// Samples of frames that lie in memory together, in bytes: about a volume of 256³.
const TOGETHER: usize = 64 << 20;

/// Lanes of a row that are gathered at a time.
const LANES_AT_ONCE: usize = 256;

/// Waves and voxels of one light.
pub(super) struct WaveLight<T: Number> {
    pub(super) waves: Waves<T>,
    pub(super) turn: Turn,
    /// Voxels along x and y.
    pub(super) plane: [usize; 2],
    /// Numbers from one row of voxels to the next.
    pub(super) row: usize,
    /// Frames of this light among those of all.
    pub(super) first_frame: usize,
    pool: Mutex<Vec<Scratch<T>>>,
}

impl<T: Number> WaveLight<T> {
    pub(super) fn new(
        (waves, turn): (Waves<T>, Turn),
        plane: [usize; 2],
        row: usize,
        first_frame: usize,
    ) -> Self {
        WaveLight {
            waves,
            turn,
            plane,
            row,
            first_frame,
            pool: Mutex::new(Vec::new()),
        }
    }

    /// Numbers of one frame's samples.
    fn samples(&self) -> usize {
        self.waves.sampling.depths * self.waves.width() * self.row
    }

    fn with_scratch<R>(&self, work: impl FnOnce(&mut Scratch<T>) -> R) -> R {
        let lock = || {
            self.pool
                .lock()
                .unwrap_or_else(std::sync::PoisonError::into_inner)
        };
        let found = lock().pop();
        let mut scratch = found.unwrap_or_else(|| self.waves.scratch());
        let result = work(&mut scratch);
        lock().push(scratch);
        result
    }

    /// The spectrum of a frame.
    fn load(&self, layout: &PatternLayout, frame: usize, x: &[T], scratch: &mut Scratch<T>) {
        let columns = layout.grid.columns;
        let runs = layout.runs[frame * columns..][..columns].iter();
        let columns = runs.map(|run| {
            let values = &x[run.offset..][..run.count as usize];
            (run.bottom as usize, values)
        });
        self.waves.transform(scratch, columns);
    }

    /// |ψ|² of a frame at all samples.
    fn light(&self, layout: &PatternLayout, frame: usize, x: &[T], samples: &mut [T]) {
        self.with_scratch(|scratch| {
            self.load(layout, frame, x, scratch);
            self.waves.propagate([scratch], |depth, mode, [field]| {
                self.add_at(depth, mode, samples, |i| field[i].norm_sqr());
            });
        });
    }

    /// |ψ|², 2·Re ψχ* and |χ|² of a frame at all samples, one after the other; χ is the field of `d`.
    fn light_along(
        &self,
        (layout, frame): (&PatternLayout, usize),
        [x, d]: [&[T]; 2],
        samples: &mut [T],
    ) {
        let (first, rest) = samples.split_at_mut(self.samples());
        let (second, third) = rest.split_at_mut(self.samples());
        let two = T::of(2.0);
        self.with_scratch(|of_x| {
            self.load(layout, frame, x, of_x);
            self.with_scratch(|of_d| {
                self.load(layout, frame, d, of_d);
                self.waves
                    .propagate([of_x, of_d], |depth, mode, [psi, chi]| {
                        let both = |i: usize| two * (psi[i] * chi[i].conj()).re;
                        self.add_at(depth, mode, first, |i| psi[i].norm_sqr());
                        self.add_at(depth, mode, second, both);
                        self.add_at(depth, mode, third, |i| chi[i].norm_sqr());
                    });
            });
        });
    }

    /// samples of a depth += a function of the field's elements, weighted as the mode is
    fn add_at(&self, depth: usize, mode: &Mode, samples: &mut [T], value: impl Fn(usize) -> T) {
        let (voxels, width) = (self.waves.voxels, self.waves.width());
        let weight = T::of(mode.weight);
        let of_depth = &mut samples[depth * width * self.row..][..width * self.row];
        for (j, row) in of_depth.chunks_exact_mut(self.row).enumerate() {
            for (i, to) in row[..voxels].iter_mut().enumerate() {
                *to = *to + weight * value(j * voxels + i);
            }
        }
    }

    /// dose += light of some frames
    pub(super) fn add_dose(
        &self,
        layout: &PatternLayout,
        frames: Range<usize>,
        x: &[T],
        dose: &mut [T],
        run: &Run,
    ) -> Result<()> {
        let lit: Vec<usize> = frames.filter(|&f| is_lit(layout, f, x)).collect();
        let light = |frame: usize, samples: &mut [T]| self.light(layout, frame, x, samples);
        self.add([dose], &lit, light, run)
    }

    /// doses += coefficients of α ↦ F(x + αd)
    pub(super) fn add_along(
        &self,
        layout: &PatternLayout,
        [x, d]: [&[T]; 2],
        doses: [&mut [T]; 3],
        run: &Run,
    ) -> Result<()> {
        let frames = 0..layout.grid.frames();
        let is_lit = |&f: &usize| is_lit(layout, f, x) || is_lit(layout, f, d);
        let lit: Vec<usize> = frames.filter(is_lit).collect();
        let light = |frame: usize, samples: &mut [T]| {
            self.light_along((layout, frame), [x, d], samples);
        };
        self.add(doses, &lit, light, run)
    }

    /// doses += what `light(frame, samples)` leaves at the samples of frames: those of each dose one after the other
    fn add<const N: usize>(
        &self,
        mut doses: [&mut [T]; N],
        frames: &[usize],
        light: impl Fn(usize, &mut [T]) + Sync,
        run: &Run,
    ) -> Result<()> {
        let size = self.samples();
        let bytes = N * size * std::mem::size_of::<T>();
        let together = (TOGETHER / bytes.max(1)).clamp(rayon::current_num_threads(), 16);
        let mut samples = vec![T::zero(); N * size * together.min(frames.len())];
        for frames in frames.chunks(together) {
            if run.is_cancelled() {
                return Err(Error::Cancelled);
            }
            samples
                .par_chunks_mut(N * size)
                .zip(frames)
                .for_each(|(samples, &frame)| {
                    samples.fill(T::zero());
                    light(frame, samples);
                });
            for (which, dose) in doses.iter_mut().enumerate() {
                self.turn_onto(frames, (which, N), &samples, dose);
            }
        }
        Ok(())
    }

    /// dose += samples of frames, of which this dose's is one of several
    fn turn_onto(
        &self,
        frames: &[usize],
        (which, of): (usize, usize),
        samples: &[T],
        dose: &mut [T],
    ) {
        let [nx, ny] = self.plane;
        let of_dose = self.waves.sampling.depths * self.waves.width();
        let band = TILE * nx * self.row;
        dose.par_chunks_mut(band).enumerate().for_each_init(
            TileEntries::default,
            |entries, (tile, rows)| {
                let ys = tile * TILE..((tile + 1) * TILE).min(ny);
                for x in (0..nx).step_by(TILE) {
                    let xs = x..(x + TILE).min(nx);
                    for (i, &frame) in frames.iter().enumerate() {
                        let place = (frame, (i * of + which) * of_dose);
                        let area = (xs.clone(), ys.clone());
                        let sampling = &self.waves.sampling;
                        self.turn.enumerate(place, area, sampling, entries);
                        self.gather(entries, ys.start, samples, rows);
                    }
                }
            },
        );
    }

    /// rows += what the entries of a tile bring; `rows` begin at voxel row `y`.
    fn gather(&self, entries: &TileEntries<T>, y: usize, samples: &[T], rows: &mut [T]) {
        for first in (0..self.waves.voxels).step_by(LANES_AT_ONCE) {
            let lanes = (self.waves.voxels - first).min(LANES_AT_ONCE);
            for (i, &column) in entries.voxels.iter().enumerate() {
                let own = entries.starts[i] as usize..entries.starts[i + 1] as usize;
                let at = (column as usize - y * self.plane[0]) * self.row + first;
                let listed = (&entries.slots[own.clone()], &entries.weights[own]);
                T::add_rows(&mut rows[at..], samples, listed, (self.row, first, lanes));
            }
        }
    }

    /// What the voxels of a cotangent ask of the samples of a frame: the transpose of the gathering.
    fn ask(&self, frame: usize, cotangent: &[T], samples: &mut [T]) {
        let [nx, ny] = self.plane;
        let (mut entries, mut sorted) = (TileEntries::default(), Sorted::default());
        samples.fill(T::zero());
        for y in (0..ny).step_by(TILE) {
            for x in (0..nx).step_by(TILE) {
                let area = (x..(x + TILE).min(nx), y..(y + TILE).min(ny));
                let sampling = &self.waves.sampling;
                self.turn
                    .enumerate((frame, 0), area, sampling, &mut entries);
                sorted.sort(&entries);
                for first in (0..self.waves.voxels).step_by(LANES_AT_ONCE) {
                    let lanes = (self.waves.voxels - first).min(LANES_AT_ONCE);
                    for (i, &sample) in sorted.samples.iter().enumerate() {
                        let own = sorted.starts[i] as usize..sorted.starts[i + 1] as usize;
                        let at = sample as usize * self.row + first;
                        let listed = (&sorted.voxels[own.clone()], &sorted.weights[own]);
                        let place = (self.row, first, lanes);
                        T::add_rows(&mut samples[at..], cotangent, listed, place);
                    }
                }
            }
        }
    }

    /// grad of this light's pixels = F′(x)ᵀ cotangent; `grad` holds the pixels of this light only.
    pub(super) fn pull_back(
        &self,
        layout: &PatternLayout,
        x: &[T],
        cotangent: &[T],
        grad: &mut [T],
        run: &Run,
    ) -> Result<()> {
        let columns = layout.grid.columns;
        let mut rest = grad;
        let mut frames = Vec::with_capacity(layout.grid.frames());
        for frame in 0..layout.grid.frames() {
            let len = layout.elements_of(frame..frame + 1).len();
            let (own, others) = rest.split_at_mut(len);
            frames.push((frame, own));
            rest = others;
        }
        frames.into_par_iter().for_each_init(
            || vec![T::zero(); self.samples()],
            |samples, (frame, grad)| {
                grad.fill(T::zero());
                // Dark patterns are stationary: there F′ = 0
                if run.is_cancelled() || !is_lit(layout, frame, x) {
                    return;
                }
                self.ask(frame, cotangent, samples);
                let runs = &layout.runs[frame * columns..][..columns];
                let first = layout.elements_of(frame..frame + 1).start;
                self.with_scratch(|scratch| {
                    self.load(layout, frame, x, scratch);
                    self.send_back(samples, scratch, |column, values| {
                        let run = &runs[column];
                        let own = &mut grad[run.offset - first..][..run.count as usize];
                        for (to, value) in own.iter_mut().zip(&values[run.bottom as usize..]) {
                            *to = value.re;
                        }
                    });
                });
            },
        );
        if run.is_cancelled() {
            return Err(Error::Cancelled);
        }
        Ok(())
    }

    /// ∂/∂x of Σ samples·|ψ|²: 2·Re of the adjoint of ψ ↦ samples·ψ
    fn send_back(
        &self,
        samples: &[T],
        scratch: &mut Scratch<T>,
        take: impl FnMut(usize, &[Complex<T>]),
    ) {
        let (voxels, width) = (self.waves.voxels, self.waves.width());
        let cotangent = |depth: usize, mode: &Mode, field: &mut [Complex<T>]| {
            let twice = T::of(2.0 * mode.weight);
            let of_depth = &samples[depth * width * self.row..][..width * self.row];
            let rows = of_depth.chunks_exact(self.row);
            for (row, field) in rows.zip(field.chunks_exact_mut(voxels)) {
                for (&asked, value) in row.iter().zip(field) {
                    *value = value.scale(twice * asked);
                }
            }
        };
        self.waves.pull_back(scratch, cotangent, take);
    }
}

/// Whether any pixel of a frame is lit.
fn is_lit<T: Number>(layout: &PatternLayout, frame: usize, x: &[T]) -> bool {
    let own = layout.elements_of(frame..frame + 1);
    x[own].iter().any(|v| !v.is_zero())
}
