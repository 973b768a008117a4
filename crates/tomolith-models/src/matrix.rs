//! The `matrix` dose model: any linear map from patterns to dose, as sparse rows.
//!
//! # Model
//! dose = A x with a stored matrix A: measured, or computed by any program. Dose sums rows of A, the adjoint rows of Aᵀ
//! (stored next to A), so both are exact transposes and do not depend on the number of threads.
//!
//! # Shapes
//! Rows of the file are voxels in array order `[z, y, x]`, columns are pixels in array order `[angle, row, column]`, the
//! lights one after the other. A matrix of `ny·nx` rows and `frames·columns` columns is *tiled over z*: row i of the
//! patterns, counted from the lowest, lights slice i alone, all by the same matrix; there must then be as many rows as
//! slices.
//!
//! # Limits
//! Fewer than 2³² pixels and lanes of dose. What pixels and voxels *are* is the job's word: the file holds numbers only.
//! The evaluation cannot refine the grid, nor turn the vial within a frame.
//!
//! # Cost
//! 16 bytes of memory per entry (A and Aᵀ); one multiply-add per entry and slice, limited by the memory's speed.
//!
//! # Example
//! A 2D matrix serves every height:
//! ```
//! use tomolith_core::field::{Field, HostField};
//! use tomolith_core::grid::{PatternGrid, VolumeGrid};
//! use tomolith_io::csr::Csr;
//! use tomolith_models::{DoseModel, Work, matrix::MatrixModel};
//! // Two pixels of one frame, three voxels: the first pixel lights voxels 0 and 1, the second voxel 2
//! let csr = Csr::from_entries(3, 2, &[(0, 0, 0.5), (1, 0, 0.25), (2, 1, 1.0)]);
//! let pixels = PatternGrid::full_turn(1, 0.0, 4, 2, 0.1);
//! let model = MatrixModel::new(&csr, vec![pixels], VolumeGrid::centered([4, 1, 3], 0.1)).unwrap();
//! let mut x = model.new_patterns().unwrap();
//! x.fill(2.0);
//! let mut dose = model.new_dose().unwrap();
//! model.dose(&x, &mut dose, &Work::new()).unwrap();
//! let volume = model.outputs()[0].volume_of(dose.as_slice());
//! assert_eq!(volume.values[..6], [1.0, 0.5, 2.0, 1.0, 0.5, 2.0]); // two slices of four
//! ```

use super::{
    Capabilities, DoseLayout, DoseModel, HostModel, MakeFamily, ModelFamily, ModelInput, ModelKind,
    OpticalScene, PatternLayout, Quantity, Work, ZCoupling, elements_of,
};
use schemars::JsonSchema;
use serde::{Deserialize, Serialize};
use std::ops::Range;
use std::path::{Path, PathBuf};
use std::sync::Arc;
use tomolith_core::dose::{Facts, Space};
use tomolith_core::error::{Error, Result};
use tomolith_core::field::{Field, HostField};
use tomolith_core::grid::{PatternGrid, VolumeGrid};
use tomolith_core::parallel::{InParallel, lines};
use tomolith_io::csr::Csr;

/// Keys of `[model.matrix]`.
#[derive(Clone, Debug, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct Params {
    /// `.npz` of `scipy.sparse.save_npz`, CSR; relative to the job file.
    pub file: PathBuf,
}

/// Row of [`MODELS`](super::MODELS).
pub const KIND: ModelKind = ModelKind {
    name: "matrix",
    summary: "A stored sparse matrix from pixels to voxels: any linear model, measured or computed.",
    example: "[model.matrix]\nfile = \"matrix.npz\"\n",
    schema: tomolith_core::kind::schema_of::<Params>,
    build: MakeFamily {
        read: |section| {
            let Params { file } = section.parse()?;
            let file = section.file(&file);
            Ok(Arc::new(Params { file }))
        },
        unasked: None,
    },
};

impl ModelFamily for Params {
    fn name(&self) -> &'static str {
        KIND.name
    }

    fn capabilities(&self) -> Capabilities {
        Capabilities {
            is_stored: true,
            ..Capabilities::default()
        }
    }

    fn unsupported(&self, scene: &OpticalScene<'_>, _grid: &VolumeGrid) -> Option<&'static str> {
        let is_cut = scene.solid.is_some();
        let cut = is_cut.then_some("a stored matrix has whole voxels only");
        cut.or(scene.point_spread())
    }

    /// Reads the file, which is read again when it is needed.
    fn check(&self, scene: &OpticalScene<'_>, grid: &VolumeGrid) -> Result<Vec<String>> {
        let fits = Csr::read(&self.file).and_then(|csr| depth(&csr, &pixels(scene), grid));
        fits.map(|_| Vec::new()).map_err(|error| {
            let (found, accepted) = match error {
                Error::Format {
                    path,
                    found,
                    accepted,
                } => (format!("{}: {found}", path.display()), accepted),
                Error::Shape {
                    what,
                    expected,
                    found,
                } => (
                    format!("{} holds {found:?}", self.file.display()),
                    format!("{expected:?}: {what}"),
                ),
                other => (
                    other.to_string(),
                    "an .npz of scipy.sparse.save_npz, relative to the job file".to_owned(),
                ),
            };
            Error::config("model.matrix.file", found, accepted)
        })
    }

    fn evaluates_alike(&self, _scene: &OpticalScene<'_>, _grid: &VolumeGrid) -> bool {
        true
    }

    fn build(&self, input: &ModelInput<'_>) -> Result<HostModel> {
        let csr = Csr::read(&self.file)?;
        let model = MatrixModel::new(&csr, pixels(&input.scene), input.grid.clone())?;
        Ok(Box::new(model))
    }

    fn merit(&self) -> String {
        format!("from {}", self.file.display())
    }
}

fn pixels(scene: &OpticalScene<'_>) -> Vec<PatternGrid> {
    let lights = scene.lights.iter();
    lights.map(|light| light.pixels.clone()).collect()
}

/// Sums along stored rows: `out[i] += Σ value · source[offset]`, for `depth` lanes at a time.
#[derive(Clone, Debug)]
pub(super) struct Rows {
    starts: Vec<usize>,
    /// Where in the source field the lanes begin.
    offsets: Vec<u32>,
    values: Vec<f32>,
}

impl Rows {
    pub(super) fn of(matrix: Csr, offset_of: impl Fn(u32) -> u32) -> Self {
        let mut offsets = matrix.indices;
        for offset in &mut offsets {
            *offset = offset_of(*offset);
        }
        Rows {
            starts: matrix.starts,
            offsets,
            values: matrix.values,
        }
    }

    /// Entries of row `i` whose offsets lie in `range`; offsets grow along a row.
    fn entries(&self, i: usize, range: &Range<usize>) -> impl Iterator<Item = (usize, f32)> {
        let all = self.starts[i]..self.starts[i + 1];
        let before = |end: usize| {
            self.offsets[all.clone()].partition_point(|&offset| (offset as usize) < end)
        };
        let part = all.start + before(range.start)..all.start + before(range.end);
        let offsets = self.offsets[part.clone()].iter().map(|&o| o as usize);
        offsets.zip(self.values[part].iter().copied())
    }

    /// Adds row `i` to `out`; one lane is summed in f64.
    pub(super) fn add(&self, i: usize, source: &[f32], range: &Range<usize>, out: &mut [f32]) {
        if let [out] = out {
            let terms = self
                .entries(i, range)
                .map(|(at, value)| f64::from(value) * f64::from(source[at]));
            *out += terms.sum::<f64>() as f32;
            return;
        }
        for (at, value) in self.entries(i, range) {
            let source = &source[at..at + out.len()];
            for (out, source) in out.iter_mut().zip(source) {
                *out += value * source;
            }
        }
    }
}

/// See the [module page](self).
#[derive(Clone, Debug)]
pub struct MatrixModel {
    patterns: Vec<PatternLayout>,
    output: DoseLayout,
    /// Slices that one entry serves: 1, or all of them.
    depth: usize,
    forward: Rows,
    adjoint: Rows,
    updates: u64,
}

impl MatrixModel {
    /// The model of a matrix for these pixels (one grid per light) and voxels.
    ///
    /// # Errors
    /// [`Error::Shape`] when the matrix does not fit; [`Error::Unsupported`] when it is too large to be numbered.
    pub fn new(matrix: &Csr, pixels: Vec<PatternGrid>, grid: VolumeGrid) -> Result<Self> {
        let depth = depth(matrix, &pixels, &grid)?;
        let mut patterns = Vec::with_capacity(pixels.len());
        let mut offset = 0;
        for grid in pixels {
            let all = vec![(0, grid.rows as u32); grid.frames() * grid.columns];
            let layout = PatternLayout::new(grid, Quantity::Energy, offset, &all);
            offset += layout.len();
            patterns.push(layout);
        }
        let output = DoseLayout::new("dose", grid, 0);
        if u32::try_from(offset.max(output.len())).is_err() {
            return Err(Error::unsupported(
                "this matrix",
                format!(
                    "{offset} pixels and {} lanes of dose, of 2³² each at most",
                    output.len()
                ),
            ));
        }
        let places = Places {
            patterns: &patterns,
            output: &output,
            depth,
        };
        Ok(Self::arranged(matrix, &places))
    }

    fn arranged(matrix: &Csr, places: &Places<'_>) -> Self {
        // Rows and columns in the order of the fields, so that sums walk through memory
        let (voxel, pixel) = (places.voxel_ranks(), places.pixel_ranks());
        let entries: Vec<(u32, u32, f32)> = (0..matrix.rows())
            .flat_map(|row| {
                matrix
                    .row(row)
                    .map(move |(column, value)| (row, column, value))
            })
            .map(|(row, column, value)| (voxel[row], pixel[column as usize], value))
            .collect();
        let ordered = Csr::from_entries(matrix.rows(), matrix.columns, &entries);
        let depth = places.depth as u32;
        MatrixModel {
            patterns: places.patterns.to_vec(),
            output: places.output.clone(),
            depth: places.depth,
            updates: places.updates(&ordered),
            adjoint: Rows::of(ordered.transposed(), |rank| places.dose_offset(rank)),
            forward: Rows::of(ordered, |rank| rank * depth),
        }
    }

    /// Number of stored entries.
    #[must_use]
    pub fn entries(&self) -> usize {
        self.forward.values.len()
    }
}

/// Slices that one entry serves: 1, or all of them.
fn depth(matrix: &Csr, pixels: &[PatternGrid], grid: &VolumeGrid) -> Result<usize> {
    let [nz, ny, nx] = grid.shape;
    let whole = [grid.len(), pixels.iter().map(PatternGrid::len).sum()];
    let tile = [ny * nx, pixels.iter().map(|g| g.frames() * g.columns).sum()];
    let found = [matrix.rows(), matrix.columns];
    if found == tile && pixels.iter().all(|g| g.rows == nz) {
        return Ok(nz);
    }
    if found == whole {
        return Ok(1);
    }
    Err(Error::shape(
        format!("matrix [voxels, pixels] (or {tile:?} when there are as many rows as slices)"),
        whole,
        found,
    ))
}

/// The matrix of a linear model in array order: rows `[z, y, x]`, columns `[angle, row, column]` of one light after the
/// other. Pixels that are not active have no entries.
///
/// Pixels are lit one by one, those of a column together that are too far apart to light the same slice: for small jobs.
///
/// # Errors
/// [`Error::Unsupported`] when the model is not linear or has several species; [`Error::Canceled`].
pub fn matrix_of(model: &dyn DoseModel<Field = HostField>, work: &Work) -> Result<Csr> {
    let refused = |reason: &str| Err(Error::unsupported("a matrix of this model", reason));
    if !model.is_linear() {
        return refused("its dose is not linear in the patterns");
    }
    let [output] = model.outputs() else {
        return refused("it has more than one species");
    };
    let mut impulses = Impulses::new(model, output)?;
    let frames: usize = model.patterns().iter().map(|p| p.grid.frames()).sum();
    let (steps, aside) = (work.steps(frames), work.aside());
    let mut first_frame = 0;
    let mut first_pixel = 0;
    for layout in model.patterns() {
        let grid = &layout.grid;
        for frame in 0..grid.frames() {
            for column in 0..grid.columns {
                impulses.light(
                    model,
                    layout,
                    first_frame + frame,
                    [frame, column],
                    first_pixel,
                    &aside,
                )?;
            }
            steps.add(1);
        }
        first_frame += grid.frames();
        first_pixel += grid.len();
    }
    if u32::try_from(output.grid.len().max(first_pixel)).is_err() {
        return refused("it has more than 2³² voxels or pixels");
    }
    Ok(Csr::from_entries(
        output.grid.len(),
        first_pixel,
        &impulses.entries,
    ))
}

/// Writes the matrix of a linear model as SciPy's CSR `.npz`; returns its number of rows, columns and entries.
///
/// # Errors
/// As [`matrix_of`] and [`Csr::write`].
pub fn export(
    model: &dyn DoseModel<Field = HostField>,
    path: &Path,
    work: &Work,
) -> Result<[usize; 3]> {
    let csr = matrix_of(model, work)?;
    csr.write(path)?;
    Ok([csr.rows(), csr.columns, csr.entries()])
}

/// Lights pixels and notes the voxels that answer.
struct Impulses<'m> {
    output: &'m DoseLayout,
    x: HostField,
    dose: HostField,
    entries: Vec<(u32, u32, f32)>,
}

impl<'m> Impulses<'m> {
    fn new(model: &dyn DoseModel<Field = HostField>, output: &'m DoseLayout) -> Result<Self> {
        Ok(Impulses {
            output,
            x: model.new_patterns()?,
            dose: model.new_dose()?,
            entries: Vec::new(),
        })
    }

    /// Every pixel of one column of one frame.
    fn light(
        &mut self,
        model: &dyn DoseModel<Field = HostField>,
        layout: &PatternLayout,
        frame_of_all: usize,
        [frame, column]: [usize; 2],
        first_pixel: usize,
        work: &Work,
    ) -> Result<()> {
        let grid = &layout.grid;
        let pixels = layout.runs[frame * grid.columns + column];
        // Two pixels at least this many rows apart light no slice together
        let apart = match model.z_coupling() {
            ZCoupling::None => self.rows_apart(grid, 0.0),
            ZCoupling::Halo(mm) => self.rows_apart(grid, mm),
            ZCoupling::Full => grid.rows,
        };
        for first in 0..apart.min(pixels.count as usize) {
            let lit: Vec<usize> = (first..pixels.count as usize).step_by(apart).collect();
            for &i in &lit {
                self.x.as_mut_slice()[pixels.offset + i] = 1.0;
            }
            self.dose.fill(0.0);
            model.dose_of(
                frame_of_all..frame_of_all + 1,
                &self.x,
                &mut self.dose,
                work,
            )?;
            for &i in &lit {
                self.x.as_mut_slice()[pixels.offset + i] = 0.0;
            }
            let row_of_run = |i: usize| grid.rows - 1 - pixels.bottom as usize - i;
            let rows: Vec<usize> = lit.into_iter().map(row_of_run).collect();
            let index =
                |row: usize| first_pixel + (frame * grid.rows + row) * grid.columns + column;
            self.note(grid, &rows, index);
        }
        Ok(())
    }

    fn rows_apart(&self, grid: &PatternGrid, halo: f64) -> usize {
        let pitch = grid.pitch_mm[1];
        let reach = pitch + self.output.grid.pitch_mm + 2.0 * halo;
        ((reach / pitch).ceil() as usize + 1).min(grid.rows)
    }

    /// Notes what is lit: a slice belongs to the nearest of the lit rows.
    fn note(&mut self, grid: &PatternGrid, rows: &[usize], index: impl Fn(usize) -> usize) {
        let [nz, ny, nx] = self.output.grid.shape;
        let distance = |row: usize, iz: usize| (grid.row_z(row) - self.output.grid.z(iz)).abs();
        let owner: Vec<Option<usize>> = (0..nz)
            .map(|iz| {
                let nearest =
                    |a: &&usize, b: &&usize| distance(**a, iz).total_cmp(&distance(**b, iz));
                rows.iter().min_by(nearest).copied()
            })
            .collect();
        let dose = &self.dose.as_slice()[self.output.range()];
        for (place, lanes) in dose.chunks(self.output.row).enumerate() {
            for ((iz, &value), owner) in lanes.iter().enumerate().zip(&owner) {
                if let (true, Some(row)) = (value != 0.0, *owner) {
                    let voxel = (iz * ny + place / nx) * nx + place % nx;
                    self.entries.push((voxel as u32, index(row) as u32, value));
                }
            }
        }
    }
}

/// Where the rows and columns of a matrix lie in the fields.
struct Places<'a> {
    patterns: &'a [PatternLayout],
    output: &'a DoseLayout,
    depth: usize,
}

impl Places<'_> {
    /// Rank in the dose field of every row of the file.
    fn voxel_ranks(&self) -> Vec<u32> {
        let [nz, ny, nx] = self.output.grid.shape;
        let slices = nz / self.depth;
        (0..slices * ny * nx)
            .map(|i| ((i % (ny * nx)) * slices + i / (ny * nx)) as u32)
            .collect()
    }

    /// Rank in the pattern field of every column of the file.
    fn pixel_ranks(&self) -> Vec<u32> {
        let mut ranks = Vec::new();
        for layout in self.patterns {
            let grid = &layout.grid;
            let rows = grid.rows / self.depth;
            let first = ranks.len();
            let rank = |i: usize| {
                let (slot, row) = (i / (rows * grid.columns), i / grid.columns % rows);
                let column = slot * grid.columns + i % grid.columns;
                (first + column * rows + (rows - 1 - row)) as u32
            };
            ranks.extend((0..grid.frames() * rows * grid.columns).map(rank));
        }
        ranks
    }

    /// Where the lanes of a rank begin in the dose field.
    fn dose_offset(&self, rank: u32) -> u32 {
        let slices = (self.output.grid.shape[0] / self.depth) as u32;
        (rank / slices) * self.output.row as u32 + rank % slices * self.depth as u32
    }

    /// Pairs of voxel and frame that have an entry.
    fn updates(&self, ordered: &Csr) -> u64 {
        let mut frame_of = Vec::with_capacity(ordered.columns);
        let mut frames = 0u32;
        for layout in self.patterns {
            let per_frame = layout.grid.columns * layout.grid.rows / self.depth;
            for frame in 0..layout.grid.frames() as u32 {
                frame_of.extend(std::iter::repeat_n(frames + frame, per_frame));
            }
            frames += layout.grid.frames() as u32;
        }
        let pairs: usize = (0..ordered.rows())
            .map(|row| {
                let range = ordered.starts[row]..ordered.starts[row + 1];
                let pixels = &ordered.indices[range];
                pixels
                    .chunk_by(|&a, &b| frame_of[a as usize] == frame_of[b as usize])
                    .count()
            })
            .sum();
        (pairs * self.depth) as u64
    }
}

/// Pattern elements that one task of the adjoint makes.
const CHUNK: usize = 1024;

impl DoseModel for MatrixModel {
    type Field = HostField;

    fn facts(&self) -> Facts<'_> {
        Facts {
            patterns: &self.patterns,
            outputs: std::slice::from_ref(&self.output),
            z_coupling: if self.depth > 1 {
                ZCoupling::None
            } else {
                ZCoupling::Full
            },
            is_linear: true,
        }
    }

    fn new_field(&self, space: Space) -> Result<HostField> {
        Ok(self.facts().host_field(space))
    }

    fn dose_of(
        &self,
        frames: Range<usize>,
        x: &HostField,
        dose: &mut HostField,
        work: &Work,
    ) -> Result<()> {
        let range = self.elements_of(&frames);
        let layout = &self.output;
        let items = layout.grid.shape[0] / self.depth;
        let x = x.as_slice();
        let dose = &mut dose.as_mut_slice()[layout.range()];
        lines(dose, layout.row, |place, lanes| {
            if work.is_canceled() {
                return;
            }
            for (i, out) in lanes.chunks_mut(self.depth).take(items).enumerate() {
                self.forward.add(place * items + i, x, &range, out);
            }
        });
        work.check()
    }

    fn pullback_of(
        &self,
        frames: Range<usize>,
        _x: &HostField,
        cotangent: &HostField,
        grad: &mut HostField,
        work: &Work,
    ) -> Result<()> {
        let (cotangent, all) = (cotangent.as_slice(), 0..usize::MAX);
        let ranks = CHUNK.div_ceil(self.depth);
        let elements = self.elements_of(&frames);
        let first = elements.start / self.depth;
        grad.as_mut_slice()[elements]
            .chunks_mut(ranks * self.depth)
            .enumerate()
            .par_each(|(chunk, grad)| {
                if work.is_canceled() {
                    return;
                }
                grad.fill(0.0);
                for (i, out) in grad.chunks_mut(self.depth).enumerate() {
                    let rank = first + chunk * ranks + i;
                    self.adjoint.add(rank, cotangent, &all, out);
                }
            });
        work.check()
    }

    fn updates(&self) -> u64 {
        self.updates
    }

    fn describe(&self) -> String {
        let tiled = if self.depth > 1 { ", tiled over z" } else { "" };
        format!("matrix ({} entries{tiled})", self.entries())
    }
}

impl MatrixModel {
    /// Elements of the pattern field that belong to frames: those of neighboring frames are neighbors, across lights too.
    fn elements_of(&self, frames: &Range<usize>) -> Range<usize> {
        let mut parts = elements_of(&self.patterns, frames).map(|(part, _)| part);
        let first = parts.next().unwrap_or_default();
        first.start..parts.last().map_or(first.end, |last| last.end)
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::parallel::Parallel;
    use tomolith_core::check::{self, difference};
    use tomolith_optics::light::Light;
    use tomolith_optics::resin::Resin;
    use tomolith_optics::vial::{cylinder::Cylinder, index_matched::IndexMatched};

    fn must_equal(matrix: &MatrixModel, model: &dyn DoseModel<Field = HostField>) {
        let mut patterns: Vec<_> = Vec::new();
        let (mut x, mut y) = (
            model.new_patterns().unwrap(),
            matrix.new_patterns().unwrap(),
        );
        for (i, (layout, other)) in matrix.patterns().iter().zip(model.patterns()).enumerate() {
            let mut images = tomolith_core::grid::Patterns::dark(layout.grid.clone());
            images.values = check::noise(3 + i as u64, images.values.len());
            other.fill_field(&images, x.as_mut_slice());
            layout.fill_field(&other.patterns_of(x.as_slice()), y.as_mut_slice());
            patterns.push(images);
        }
        let (a, b) = (check::dose(model, &x), check::dose(matrix, &y));
        assert!(difference(b.as_slice(), a.as_slice()) < 1e-6);
        let (x, y) = (check::adjoint(model, &a), check::adjoint(matrix, &a));
        for (layout, other) in matrix.patterns().iter().zip(model.patterns()) {
            let (a, b) = (
                other.patterns_of(x.as_slice()),
                layout.patterns_of(y.as_slice()),
            );
            assert!(difference(&b.values, &a.values) < 1e-6);
        }
    }

    #[test]
    fn the_matrix_of_a_model_is_the_model() {
        let vial = Cylinder::new(2.0, 2.2, 1.58);
        // Pixels finer than voxels in the one light and coarser in the other, so that rows share slices and slices rows
        let light = |frames, rows, columns, pitch| {
            Light::new(
                PatternGrid::full_turn(frames, 0.1, rows, columns, pitch),
                Resin::absorbing(1.48, 0.2),
            )
        };
        let lights = vec![light(3, 9, 20, 0.17), light(2, 3, 9, 0.5)];
        let grid = VolumeGrid::centered([5, 9, 8], 0.3);
        let pixels = lights.iter().map(|light| light.pixels.clone()).collect();
        let model = Parallel::new(&vial, lights, grid.clone()).unwrap();
        let matrix = matrix_of(&model, &Work::new()).unwrap();
        let matrix = MatrixModel::new(&matrix, pixels, grid).unwrap();
        must_equal(&matrix, &model);
        check::model::model(&matrix, 5).unwrap();
        assert!(matrix.updates() <= model.updates());
    }

    #[test]
    fn a_matrix_of_one_slice_serves_all() {
        let vial = IndexMatched { radius_mm: 2.0 };
        let light = |rows| {
            Light::new(
                PatternGrid::full_turn(4, 0.1, rows, 18, 0.2),
                Resin::absorbing(1.48, 0.2),
            )
        };
        let model = |nz| {
            let grid = VolumeGrid::centered([nz, 11, 13], 0.2);
            Parallel::new(&vial, vec![light(nz)], grid).unwrap()
        };
        let csr = matrix_of(&model(1), &Work::new()).unwrap();
        let whole = model(19);
        let pixels = vec![light(19).pixels];
        let matrix = MatrixModel::new(&csr, pixels, whole.outputs()[0].grid.clone()).unwrap();
        assert_eq!(matrix.depth, 19);
        must_equal(&matrix, &whole);
        check::model::model(&matrix, 5).unwrap();
    }

    #[test]
    fn a_matrix_of_another_shape_is_refused() {
        let csr = Csr::from_entries(6, 2, &[(0, 0, 1.0)]);
        let pixels = PatternGrid::full_turn(1, 0.0, 3, 2, 0.1);
        let grid = VolumeGrid::centered([2, 2, 3], 0.1); // 6 voxels a slice, but three rows for two slices
        let error = MatrixModel::new(&csr, vec![pixels], grid).unwrap_err();
        assert!(matches!(error, Error::Shape { ref expected, .. } if expected == &[12, 6]));
    }
}
