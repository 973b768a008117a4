//! The half ramp P: what a quasi-Newton method takes for the inverse curvature of patterns before it has measured any.
//!
//! **Equation** A voxel sees a pixel and its neighbors, so the curvature of a loss is large for patterns that are smooth along a row of
//! pixels and small for fine ones: Fᵀ F acts like 1/|f| on patterns that a dose can tell apart (Kak and Slaney 1988, section 3.3), f the
//! frequency along the columns. P acts like |f|^½ on every row of every frame:
//!
//! ```text
//! P = MᵀM,   M(z) = (1 − 0.9142/z)(1 − 0.5014/z) / ((1 − 0.8573/z)(1 − 0.3186/z)),   1/z one column earlier
//! ```
//!
//! |M|² is within 3 % of 1.41·|sin(πf)|^½ from a period of 2 columns to one of 64, and levels off at 0.19. As a product with
//! its own transpose P is symmetric and positive, whatever pixels are active. The full ramp is what inverts Fᵀ F; but a loss
//! looks at few voxels, and its root took fewer steps on the targets it was tried on (`docs/choices.md`).
//!
//! **Layout** of a backend's data: frame by frame the active rows of every column ([`ColumnRun`]). Pixels that are no elements count as dark.
//! **Bits** of the host: in f32, products rounded before they are added; M from the first to the last active column of a frame, then Mᵀ
//! back; rows of short frames go side by side through one pass. **Cost** two recursions, 16 operations a pixel, and a copy.

use super::group::Group;
use super::{Field as _, HostField, LANES};
use crate::parallel::InParallel;
use std::ops::Range;
use std::sync::Arc;
use wide::f32x8;

/// Rows of pixels that one pass filters side by side. Their elements of a column lie in one stretch of memory, long enough for the processor to fetch ahead.
const ROWS: usize = 4 * LANES;

/// Zero and pole of each factor of M.
pub const SECTIONS: [[f32; 2]; 2] = [[0.9142, 0.8573], [0.5014, 0.3186]];

/// The active rows of a column of a frame.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct ColumnRun {
    /// First element in the field.
    pub first: usize,
    /// The row of that element; the rows above it follow.
    pub bottom: usize,
    /// How many rows.
    pub count: usize,
}

/// Where the rows of pixels are; see the [module](self).
#[derive(Clone, Debug)]
pub struct HalfRamp {
    /// Every frame, in the order of the field: its columns. Together they are all of the field.
    pub frames: Vec<Vec<ColumnRun>>,
}

/// P where the fields F live.
pub trait HalfRampKernel<F>: Send + Sync {
    /// Brings the data to where `like` lives.
    fn new(ramp: HalfRamp, like: &F) -> Self;
    /// out ← P·x
    fn apply(&self, x: &F, out: &mut F);
}

/// [`HalfRampKernel`] in host memory: frames in batches of rows of pixels, which are filtered side by side.
#[derive(Clone, Debug)]
pub struct HostHalfRamp(Arc<[Batch]>);

/// Neighboring frames whose rows are filtered side by side, or one that is higher.
#[derive(Debug)]
struct Batch {
    frames: Vec<Frame>,
    /// From the first to the last column in which any of them has active rows.
    columns: Range<usize>,
    /// Elements of the field.
    elements: Range<usize>,
}

/// The active pixels of a frame.
#[derive(Debug)]
struct Frame {
    /// From the first to the last column that has active rows.
    runs: Vec<ColumnRun>,
    /// The first of these columns.
    column: usize,
    /// Lowest active row.
    bottom: usize,
    /// Rows from there to above the highest active one.
    height: usize,
    /// Lane of the lowest row.
    lane: usize,
    elements: usize,
}

impl Frame {
    fn new(mut runs: Vec<ColumnRun>) -> Self {
        let elements = runs.iter().map(|run| run.count).sum();
        let is_lit = |run: &ColumnRun| run.count > 0;
        let column = runs.iter().position(is_lit).unwrap_or(runs.len());
        runs.truncate(
            runs.iter()
                .rposition(is_lit)
                .map_or(column, |last| last + 1),
        );
        runs.drain(..column);
        let lit = || runs.iter().filter(|run| run.count > 0);
        let bottom = lit().map(|run| run.bottom).min().unwrap_or(0);
        let top = lit().map(|run| run.bottom + run.count).max().unwrap_or(0);
        Frame {
            runs,
            column,
            bottom,
            height: top - bottom,
            lane: 0,
            elements,
        }
    }
}

impl Batch {
    /// Every frame, in the order of the field.
    fn all(ramp: HalfRamp) -> Vec<Self> {
        let mut batches: Vec<Batch> = Vec::new();
        let mut end = 0;
        for runs in ramp.frames {
            let mut frame = Frame::new(runs);
            let columns = frame.column..frame.column + frame.runs.len();
            let begin = end;
            end += frame.elements;
            let rows = |batch: &Batch| {
                batch
                    .frames
                    .last()
                    .map_or(0, |last| last.lane + last.height)
            };
            match batches.last_mut() {
                Some(batch) if rows(batch) + frame.height <= ROWS => {
                    frame.lane = rows(batch);
                    batch.columns.start = batch.columns.start.min(columns.start);
                    batch.columns.end = batch.columns.end.max(columns.end);
                    batch.elements.end = end;
                    batch.frames.push(frame);
                }
                _ => batches.push(Batch {
                    frames: vec![frame],
                    columns,
                    elements: begin..end,
                }),
            }
        }
        batches
    }

    /// out ← P·x for its elements: some rows at a time through all columns.
    fn apply(&self, x: &[f32], out: &mut [f32], scratch: &mut Vec<[f32; ROWS]>) {
        let height = self.frames.iter().map(|frame| frame.height).max();
        for row in (0..height.unwrap_or(0)).step_by(ROWS) {
            scratch.clear();
            scratch.resize(self.columns.len(), [0.0; ROWS]);
            self.overlaps(row)
                .for_each(|(column, [element, lane, count])| {
                    let lanes = &mut scratch[column][lane..][..count];
                    copy(&x[element..][..count], lanes);
                });
            recur(scratch.iter_mut());
            self.end_rows(scratch);
            recur(scratch.iter_mut().rev());
            self.overlaps(row)
                .for_each(|(column, [element, lane, count])| {
                    let out = &mut out[element - self.elements.start..][..count];
                    copy(&scratch[column][lane..][..count], out);
                });
        }
    }

    /// What the runs have in common with the rows of the pass from `row` on above the lowest: the column of the batch; first element, first lane,
    /// how many.
    fn overlaps(&self, row: usize) -> impl Iterator<Item = (usize, [usize; 3])> + '_ {
        self.frames.iter().flat_map(move |frame| {
            let first = frame.column - self.columns.start;
            let runs = frame.runs.iter().enumerate();
            runs.map(move |(i, run)| {
                let [element, lane, count] = overlap(run, frame.bottom + row);
                (first + i, [element, frame.lane + lane, count])
            })
        })
    }

    /// M ends with the last active column of a frame, which may come before that of its neighbors.
    fn end_rows(&self, scratch: &mut [[f32; ROWS]]) {
        if let [_] = self.frames.as_slice() {
            return;
        }
        for frame in &self.frames {
            let end = frame.column + frame.runs.len() - self.columns.start;
            for column in &mut scratch[end..] {
                column[frame.lane..frame.lane + frame.height].fill(0.0);
            }
        }
    }
}

impl HalfRampKernel<HostField> for HostHalfRamp {
    fn new(ramp: HalfRamp, like: &HostField) -> Self {
        let batches = Batch::all(ramp);
        let elements = batches.last().map_or(0, |last| last.elements.end);
        assert_eq!(elements, like.len(), "runs of another field");
        HostHalfRamp(batches.into())
    }

    fn apply(&self, x: &HostField, out: &mut HostField) {
        let x = x.as_slice();
        let mut rest = out.as_mut_slice();
        let mut parts = Vec::with_capacity(self.0.len());
        for batch in self.0.iter() {
            let out = rest.split_off_mut(..batch.elements.len());
            parts.push((batch, out.unwrap_or_default()));
        }
        parts
            .into_iter()
            .par_each_with(Vec::new, |scratch, (batch, out)| {
                batch.apply(x, out, scratch);
            });
    }
}

/// Copies a run. A call takes longer than the copy of the single pixel of a slice.
fn copy(from: &[f32], to: &mut [f32]) {
    if let ([from], [to]) = (from, &mut *to) {
        *to = *from;
    } else {
        to.copy_from_slice(from);
    }
}

/// What a run has in common with the rows of the pass from `row` on: first element, first lane, how many.
fn overlap(run: &ColumnRun, row: usize) -> [usize; 3] {
    let begin = run.bottom.max(row);
    let end = (run.bottom + run.count).min(row + ROWS);
    if begin < end {
        [run.first + (begin - run.bottom), begin - row, end - begin]
    } else {
        [run.first, 0, 0]
    }
}

/// M along columns, in place.
fn recur<'a>(columns: impl Iterator<Item = &'a mut [f32; ROWS]>) {
    let [[b1, a1], [b2, a2]] = SECTIONS.map(|section| section.map(f32x8::splat));
    let mut states = [[Group::default(); 2]; ROWS / LANES];
    for column in columns {
        let lanes = column.as_chunks_mut::<LANES>().0;
        for (lanes, [first, second]) in lanes.iter_mut().zip(&mut states) {
            let x = Group::of(lanes);
            let y = x.zip(*first, |x, s| x + s);
            *first = x.zip(y, |x, y| a1 * y - b1 * x);
            let z = y.zip(*second, |y, s| y + s);
            *second = y.zip(z, |y, z| a2 * z - b2 * y);
            *lanes = z.to_array();
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::near;
    use std::f64::consts::PI;

    /// Frames of full rectangles.
    fn full(frames: usize, columns: usize, rows: usize) -> HalfRamp {
        let run = |i: usize| ColumnRun {
            first: i * rows,
            bottom: 3,
            count: rows,
        };
        let frame = |f: usize| (0..columns).map(|c| run(f * columns + c)).collect();
        HalfRamp {
            frames: (0..frames).map(frame).collect(),
        }
    }

    /// Runs of different heights, some columns without any.
    fn ragged() -> (HalfRamp, usize) {
        let mut first = 0;
        let mut run = |bottom: usize, count: usize| {
            first += count;
            ColumnRun {
                first: first - count,
                bottom,
                count,
            }
        };
        let frames = (0..3)
            .map(|f| {
                (0..9)
                    .map(|c| run(2 + (c + f) % 4, [0, 5, 33, 0, 17, 16, 1, 40, 0][c]))
                    .collect()
            })
            .collect();
        (HalfRamp { frames }, first)
    }

    /// M as a matrix: its impulse response, in f64.
    fn matrix(columns: usize) -> Vec<Vec<f64>> {
        let mut impulse = vec![0.0f64; columns];
        impulse[0] = 1.0;
        for [b, a] in SECTIONS.map(|section| section.map(f64::from)) {
            let (mut x1, mut y1) = (0.0, 0.0);
            for value in &mut impulse {
                let y = *value - b * x1 + a * y1;
                (x1, y1) = (*value, y);
                *value = y;
            }
        }
        (0..columns)
            .map(|i| {
                (0..columns)
                    .map(|j| if j <= i { impulse[i - j] } else { 0.0 })
                    .collect()
            })
            .collect()
    }

    #[test]
    fn it_is_the_product_of_m_with_its_transpose() {
        let (columns, rows) = (41, 21);
        let m = matrix(columns);
        let values = crate::check::noise(5, 2 * columns * rows);
        let x = HostField::from_slice(&values);
        let mut out = x.zeros_like();
        HostHalfRamp::new(full(2, columns, rows), &x).apply(&x, &mut out);
        for frame in 0..2 {
            for row in 0..rows {
                let at = |column: usize| (frame * columns + column) * rows + row;
                let sum = |factors: &[f64], value_of: &dyn Fn(usize) -> f64| -> f64 {
                    factors
                        .iter()
                        .enumerate()
                        .map(|(i, m)| m * value_of(i))
                        .sum()
                };
                let x = |column: usize| f64::from(values[at(column)]);
                let mx: Vec<f64> = m.iter().map(|of_row| sum(of_row, &x)).collect();
                for column in 0..columns {
                    let transposed: Vec<f64> = m.iter().map(|of_row| of_row[column]).collect();
                    let expected = sum(&transposed, &|i| mx[i]);
                    let found = f64::from(out.as_slice()[at(column)]);
                    near!(found, expected, 1e-5, "{frame}, {row}, {column}");
                }
            }
        }
    }

    #[test]
    fn it_is_symmetric_and_positive_on_runs_of_any_shape() {
        let (ramp, len) = ragged();
        let [x, y] = [3, 4].map(|seed| HostField::from_slice(&crate::check::noise(seed, len)));
        let ramp = HostHalfRamp::new(ramp, &x);
        let [mut px, mut py] = [x.zeros_like(), x.zeros_like()];
        ramp.apply(&x, &mut px);
        ramp.apply(&y, &mut py);
        let (one, other) = (px.dot(&y), x.dot(&py));
        near!(one, other, 1e-5 * x.norm() * y.norm());
        // The least gain is that of patterns without fine detail
        assert!(px.dot(&x) > 0.19 * x.dot(&x));
    }

    #[test]
    fn short_frames_side_by_side_have_the_bits_of_each_alone() {
        // One to three rows, lit in different columns, and one frame without light
        let mut first = 0;
        let frames: Vec<Vec<ColumnRun>> = (0..40)
            .map(|f| {
                let lit = f % 7..30 - f % 11;
                let of_column = |c: usize| ColumnRun {
                    first: 0,
                    bottom: f % 5,
                    count: if f == 9 || !lit.contains(&c) {
                        0
                    } else {
                        1 + f % 3
                    },
                };
                let mut runs: Vec<ColumnRun> = (0..30).map(of_column).collect();
                for run in &mut runs {
                    run.first = first;
                    first += run.count;
                }
                runs
            })
            .collect();
        let x = HostField::from_slice(&crate::check::noise(11, first));
        let mut together = x.zeros_like();
        let all = HalfRamp { frames };
        HostHalfRamp::new(all.clone(), &x).apply(&x, &mut together);
        for runs in all.frames {
            let elements: usize = runs.iter().map(|run| run.count).sum();
            let begin = runs[0].first;
            let moved = |run: ColumnRun| ColumnRun {
                first: run.first - begin,
                ..run
            };
            let frames = vec![runs.into_iter().map(moved).collect()];
            let x = HostField::from_slice(&x.as_slice()[begin..begin + elements]);
            let mut alone = x.zeros_like();
            HostHalfRamp::new(HalfRamp { frames }, &x).apply(&x, &mut alone);
            assert_eq!(
                alone.as_slice(),
                &together.as_slice()[begin..begin + elements]
            );
        }
    }

    #[test]
    fn its_gain_follows_the_root_of_the_frequency() {
        let z = |f: f64| (-2.0 * PI * f).sin_cos();
        let gain = |f: f64| {
            let (sin, cos) = z(f);
            let square = |c: f64| (1.0 - c * cos).powi(2) + (c * sin).powi(2);
            SECTIONS
                .map(|[b, a]| square(b.into()) / square(a.into()))
                .iter()
                .product::<f64>()
        };
        for period in [2.0, 3.0, 5.0, 10.0, 20.0, 40.0, 64.0] {
            let expected = 1.41 * (PI / period).sin().sqrt();
            let found = gain(1.0 / period);
            near!(found / expected, 1.0, 0.03, "period {period}");
        }
        assert!((gain(0.0) / gain(0.5) - 0.14).abs() < 0.01);
    }
}
