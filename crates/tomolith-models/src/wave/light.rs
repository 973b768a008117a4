//! Dose and pullback of one light.

use super::coherent::Coherent;
use super::frame_rotation::{FrameRotation, Sorted, TILE, TileEntries};
use super::memory::frames_together;
use super::number::Number;
use super::resample::Resample;
use super::spectrum::{Scratch, Windows};
use crate::{PatternLayout, Work};
use std::ops::Range;
use std::sync::Mutex;
use tomolith_core::dose::waves;
use tomolith_core::error::Result;
use tomolith_core::parallel::InParallel;
use tomolith_fourier::Complex;

/// Lanes of a row that are gathered at a time.
const LANES_AT_ONCE: usize = 256;

/// Propagation of light from the plane of its pixels to the samples.
pub(super) trait Propagation<T: Number>: Send + Sync {
    const IS_LINEAR: bool;
    fn windows(&self) -> &Windows<T>;
    /// samples += light of the image whose spectrum lies in the scratch; rows of samples are `row` numbers apart
    fn shine(&self, scratch: &mut Scratch<T>, samples: &mut [T], row: usize);
    /// The derivative's transpose at that image: pixels, column by column, handed to `take`.
    fn send_back(
        &self,
        samples: &[T],
        row: usize,
        scratch: &mut Scratch<T>,
        take: &mut dyn FnMut(usize, &[Complex<T>]),
    );
}

/// How light spreads, as data: its modes, sums of fields at depths, and their transpose.
pub(super) type SpreadingForm = (Vec<waves::WaveMode>, [Vec<Vec<waves::FieldTap>>; 2]);

/// Light and voxels of one light.
pub(super) struct WaveLight<T: Number, P: Propagation<T>> {
    pub(super) propagation: P,
    pub(super) turn: FrameRotation,
    /// Voxels along x and y.
    pub(super) plane: [usize; 2],
    /// Numbers from one row of voxels to the next.
    pub(super) row: usize,
    /// Frames of this light among those of all.
    pub(super) first_frame: usize,
    resample: Resample<T>,
    pool: Mutex<Vec<Scratch<T>>>,
}

impl<T: Number, P: Propagation<T>> WaveLight<T, P> {
    pub(super) fn new(
        propagation: P,
        turn: FrameRotation,
        plane: [usize; 2],
        row: usize,
        first_frame: usize,
    ) -> Self {
        let windows = propagation.windows();
        let resample = Resample::new(&windows.sampling, windows.computed(), windows.last);
        WaveLight {
            propagation,
            turn,
            resample,
            plane,
            row,
            first_frame,
            pool: Mutex::new(Vec::new()),
        }
    }

    /// Which of this light's frames are among these of all lights.
    pub(super) fn local_frames(
        &self,
        frames: &Range<usize>,
        layout: &PatternLayout,
    ) -> Range<usize> {
        let count = layout.grid.frames();
        let local = |f: usize| f.saturating_sub(self.first_frame).min(count);
        local(frames.start)..local(frames.end)
    }

    /// Samples of one frame that voxels are interpolated from: rows of them.
    fn rows(&self) -> usize {
        self.propagation.windows().sampling.along.last().count
            * self.propagation.windows().last.count
    }

    /// Numbers of these samples.
    fn samples(&self) -> usize {
        self.rows() * self.row
    }

    /// Numbers of one frame's samples that are computed.
    fn computed(&self) -> usize {
        self.propagation.windows().sampling.along.computed.count
            * self.propagation.windows().width()
            * self.row
    }

    /// Bytes of the scratches that were needed so far.
    #[cfg(test)]
    pub(super) fn kept_bytes(&self) -> usize {
        let pool = self.pool.lock().unwrap();
        pool.iter().map(Scratch::bytes).sum()
    }

    fn with_scratch<R>(&self, work: impl FnOnce(&mut Scratch<T>) -> R) -> R {
        let lock = || {
            self.pool
                .lock()
                .unwrap_or_else(std::sync::PoisonError::into_inner)
        };
        let found = lock().pop();
        let mut scratch = found.unwrap_or_else(|| self.propagation.windows().scratch());
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
        self.propagation.windows().transform(scratch, columns);
    }

    /// Light of a frame, added to all samples.
    fn light(&self, layout: &PatternLayout, frame: usize, x: &[T], samples: &mut [T]) {
        self.with_scratch(|scratch| {
            self.load(layout, frame, x, scratch);
            if self.resample.is_idle() {
                return self.propagation.shine(scratch, samples, self.row);
            }
            let mut computed = self.cleared(scratch, 1);
            self.propagation.shine(scratch, &mut computed, self.row);
            (self.resample).forth(&computed, samples, &mut scratch.between, self.row);
            scratch.computed = computed;
        });
    }

    /// The array of computed samples of a scratch, `times` of them, all 0.
    fn cleared(&self, scratch: &mut Scratch<T>, times: usize) -> Vec<T> {
        let mut computed = std::mem::take(&mut scratch.computed);
        computed.clear();
        computed.resize(times * self.computed(), T::zero());
        computed
    }

    /// dose += light of some frames
    pub(super) fn add_dose(
        &self,
        layout: &PatternLayout,
        frames: Range<usize>,
        x: &[T],
        dose: &mut [T],
        work: &Work,
    ) -> Result<()> {
        let lit: Vec<usize> = frames.filter(|&f| is_lit(layout, f, x)).collect();
        let light = |frame: usize, samples: &mut [T]| self.light(layout, frame, x, samples);
        self.add([dose], &lit, light, work)
    }

    /// doses += what `light(frame, samples)` leaves at the samples of frames: those of each dose one after the other
    fn add<const N: usize>(
        &self,
        mut doses: [&mut [T]; N],
        frames: &[usize],
        light: impl Fn(usize, &mut [T]) + Sync,
        work: &Work,
    ) -> Result<()> {
        let size = self.samples();
        let bytes = N * size * std::mem::size_of::<T>();
        let together = frames_together(bytes, rayon::current_num_threads());
        let mut samples = vec![T::zero(); N * size * together.min(frames.len())];
        for frames in frames.chunks(together) {
            work.check()?;
            samples
                .chunks_mut(N * size)
                .zip(frames)
                .par_each(|(samples, &frame)| {
                    samples.fill(T::zero());
                    light(frame, samples);
                });
            for (which, dose) in doses.iter_mut().enumerate() {
                self.turn_onto(frames, which, N, &samples, dose);
            }
        }
        Ok(())
    }

    /// dose += samples of frames, of which this dose's is one of several
    fn turn_onto(
        &self,
        frames: &[usize],
        which: usize,
        doses: usize,
        samples: &[T],
        dose: &mut [T],
    ) {
        let [nx, ny] = self.plane;
        let of_dose = self.rows();
        let band = TILE * nx * self.row;
        dose.chunks_mut(band).enumerate().par_each_with(
            TileEntries::default,
            |entries, (tile, rows)| {
                let ys = tile * TILE..((tile + 1) * TILE).min(ny);
                for x in (0..nx).step_by(TILE) {
                    let xs = x..(x + TILE).min(nx);
                    for (i, &frame) in frames.iter().enumerate() {
                        let first = (i * doses + which) * of_dose;
                        let (xs, ys) = (xs.clone(), ys.clone());
                        let sampling = &self.propagation.windows().sampling;
                        self.turn.enumerate(frame, first, xs, ys, sampling, entries);
                        self.gather(entries, tile * TILE, samples, rows);
                    }
                }
            },
        );
    }

    /// rows += what the entries of a tile bring; `rows` begin at voxel row `y`.
    fn gather(&self, entries: &TileEntries<T>, y: usize, samples: &[T], rows: &mut [T]) {
        for first in (0..self.propagation.windows().voxels).step_by(LANES_AT_ONCE) {
            let lanes = (self.propagation.windows().voxels - first).min(LANES_AT_ONCE);
            for (i, &column) in entries.voxels.iter().enumerate() {
                let range = entries.starts[i] as usize..entries.starts[i + 1] as usize;
                let at = (column as usize - y * self.plane[0]) * self.row + first;
                let (slots, weights) = (&entries.slots[range.clone()], &entries.weights[range]);
                let out = &mut rows[at..];
                T::add_rows(out, samples, slots, weights, self.row, first, lanes);
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
                let (xs, ys) = (x..(x + TILE).min(nx), y..(y + TILE).min(ny));
                let sampling = &self.propagation.windows().sampling;
                self.turn
                    .enumerate(frame, 0, xs, ys, sampling, &mut entries);
                sorted.sort(&entries);
                for first in (0..self.propagation.windows().voxels).step_by(LANES_AT_ONCE) {
                    let lanes = (self.propagation.windows().voxels - first).min(LANES_AT_ONCE);
                    for (i, &sample) in sorted.samples.iter().enumerate() {
                        let range = sorted.starts[i] as usize..sorted.starts[i + 1] as usize;
                        let at = sample as usize * self.row + first;
                        let (voxels, weights) =
                            (&sorted.voxels[range.clone()], &sorted.weights[range]);
                        let out = &mut samples[at..];
                        T::add_rows(out, cotangent, voxels, weights, self.row, first, lanes);
                    }
                }
            }
        }
    }

    /// grad of the pixels of some of this light's frames = F′(x)ᵀ cotangent; `grad` holds these only.
    pub(super) fn pull_back(
        &self,
        layout: &PatternLayout,
        frames: Range<usize>,
        x: &[T],
        cotangent: &[T],
        grad: &mut [T],
        work: &Work,
    ) -> Result<()> {
        let columns = layout.grid.columns;
        let frames = layout.split_frames(frames, grad);
        frames.into_iter().par_each(|(frame, grad)| {
            grad.fill(T::zero());
            // Dark patterns of waves are stationary: there F′ = 0
            if work.is_canceled() || !(P::IS_LINEAR || is_lit(layout, frame, x)) {
                return;
            }
            let runs = &layout.runs[frame * columns..][..columns];
            let first = layout.elements_of(frame..frame + 1).start;
            let mut take = |column: usize, values: &[Complex<T>]| {
                let work = &runs[column];
                let pixels = &mut grad[work.offset - first..][..work.count as usize];
                for (to, value) in pixels.iter_mut().zip(&values[work.bottom as usize..]) {
                    *to = value.re;
                }
            };
            self.with_scratch(|scratch| {
                let mut samples = std::mem::take(&mut scratch.samples);
                samples.resize(self.samples(), T::zero());
                self.ask(frame, cotangent, &mut samples);
                self.load(layout, frame, x, scratch);
                self.send_back(&samples, scratch, &mut take);
                scratch.samples = samples;
            });
        });
        work.check()
    }
}

impl<T: Number, P: Propagation<T>> WaveLight<T, P> {
    /// What samples ask of the pixels of the frame whose spectrum lies in the scratch.
    fn send_back(
        &self,
        samples: &[T],
        scratch: &mut Scratch<T>,
        take: &mut dyn FnMut(usize, &[Complex<T>]),
    ) {
        if self.resample.is_idle() {
            return self.propagation.send_back(samples, self.row, scratch, take);
        }
        let mut computed = self.cleared(scratch, 1);
        (self.resample).back(samples, &mut computed, &mut scratch.between, self.row);
        self.propagation
            .send_back(&computed, self.row, scratch, take);
        scratch.computed = computed;
    }
}

impl<P: Propagation<f32>> WaveLight<f32, P> {
    pub(super) fn form(&self, (modes, [forth, back]): SpreadingForm) -> waves::WaveLight {
        let windows = self.propagation.windows();
        waves::WaveLight {
            transforms: windows.form(),
            modes,
            forth,
            back,
            closer: self.resample.form(),
            rotation: self.turn.data.clone(),
        }
    }
}

impl<T: Number> WaveLight<T, Coherent<T>> {
    /// doses += coefficients of α and α² of F(x + αd)
    pub(super) fn add_along(
        &self,
        layout: &PatternLayout,
        [x, d]: [&[T]; 2],
        doses: [&mut [T]; 2],
        work: &Work,
    ) -> Result<()> {
        let frames = 0..layout.grid.frames();
        let is_lit = |&f: &usize| is_lit(layout, f, x) || is_lit(layout, f, d);
        let lit: Vec<usize> = frames.filter(is_lit).collect();
        let light = |frame: usize, samples: &mut [T]| {
            self.light_along(layout, frame, [x, d], samples);
        };
        self.add(doses, &lit, light, work)
    }

    /// 2·Re ψχ* and |χ|² of a frame at all samples, one after the other; χ is the field of `d`.
    fn light_along(
        &self,
        layout: &PatternLayout,
        frame: usize,
        [x, d]: [&[T]; 2],
        samples: &mut [T],
    ) {
        self.with_scratch(|of_x| {
            self.load(layout, frame, x, of_x);
            self.with_scratch(|of_d| {
                self.load(layout, frame, d, of_d);
                if self.resample.is_idle() {
                    return self
                        .propagation
                        .shine_along([of_x, of_d], samples, self.row);
                }
                let mut computed = self.cleared(of_x, 2);
                let scratches = [&mut *of_x, of_d];
                (self.propagation).shine_along(scratches, &mut computed, self.row);
                let parts = computed.chunks_exact(self.computed());
                for (part, samples) in parts.zip(samples.chunks_exact_mut(self.samples())) {
                    (self.resample).forth(part, samples, &mut of_x.between, self.row);
                }
                of_x.computed = computed;
            });
        });
    }
}

fn is_lit<T: Number>(layout: &PatternLayout, frame: usize, x: &[T]) -> bool {
    let elements = layout.elements_of(frame..frame + 1);
    x[elements].iter().any(|v| !v.is_zero())
}
