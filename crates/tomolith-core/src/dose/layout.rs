//! How a model's fields are laid out, and the way to and from arrays in file order.
//!
//! Inside, z is the fastest axis: the geometry of one slice serves all heights, so a kernel walks along z. A dose field
//! holds rows of lanes `[y][x][z]`, each row padded to whole vectors of 16 floats (64 bytes; see [`row_of`]); a single slice
//! is a plain plane `[y][x]`. A pattern field holds only
//! *active* pixels: for each (frame, column) one run of rows, from low z to high z.
//!
//! ```
//! use tomolith_core::grid::{Volume, VolumeGrid};
//! use tomolith_core::dose::DoseLayout;
//! let grid = VolumeGrid::centered([2, 1, 3], 0.1);
//! let layout = DoseLayout::new("dose", grid.clone(), 0);
//! assert_eq!(layout.len(), 3 * 16); // three (y, x) rows of two heights, padded to 16
//! let volume = Volume { grid, values: vec![1.0, 2.0, 3.0, 4.0, 5.0, 6.0] };
//! let field = layout.field_of(&volume);
//! assert_eq!(field[16..18], [2.0, 5.0]); // x = 1: z = 0 holds 2, z = 1 holds 5
//! assert_eq!(layout.volume_of(&field), volume);
//! ```

use crate::dose::cells::Cells;
use crate::field::LANES;
use crate::grid::{PatternGrid, Patterns, Volume, VolumeGrid};
use crate::parallel::InParallel;
use std::borrow::Cow;
use std::ops::Range;
use std::sync::Arc;

/// Voxels of a square that changes from the order of fields to that of arrays, along z and along x: 16 kB.
const SQUARE: usize = 64;

/// What a pattern value means to a model.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Quantity {
    /// Areal dose over the whole exposure.
    Energy,
    /// Its square root.
    Amplitude,
}

impl Quantity {
    /// The energy that a value of this kind stands for.
    #[must_use]
    pub fn energy(self, value: f32) -> f32 {
        match self {
            Quantity::Energy => value,
            Quantity::Amplitude => value * value,
        }
    }

    /// The value of this kind that stands for an energy, 0 or above.
    #[must_use]
    pub fn value(self, energy: f32) -> f32 {
        match self {
            Quantity::Energy => energy,
            Quantity::Amplitude => energy.max(0.0).sqrt(),
        }
    }
}

/// Floats that a row of `nz` voxels takes: `nz` rounded up to whole vectors of 16, and long rows to an odd number of
/// them. Rows a power of two apart would all compete for the same few sets of the caches. A single slice has no lanes
/// along z: its rows are single voxels.
///
/// ```
/// use tomolith_core::dose::layout::row_of;
/// assert_eq!(row_of(20), 32); // two vectors
/// assert_eq!(row_of(256), 272); // seventeen vectors instead of sixteen
/// assert_eq!(row_of(1), 1); // a plane
/// ```
#[must_use]
pub fn row_of(nz: usize) -> usize {
    if nz == 1 {
        return 1;
    }
    let vectors = nz.div_ceil(LANES);
    let spread = vectors >= 8 && vectors.is_multiple_of(2);
    (vectors + usize::from(spread)) * LANES
}

/// The dose of one species: where its voxels lie in the model's field.
#[derive(Clone, Debug, PartialEq)]
pub struct DoseLayout {
    /// The species, `"dose"` when there is only one.
    pub species: String,
    /// The voxels.
    pub grid: VolumeGrid,
    /// First element in the field.
    pub offset: usize,
    /// Floats per (y, x) row: [`row_of`] nz; the padding stays zero.
    pub row: usize,
    /// Voxels with two doses: behind the voxels lie the inside cells of those.
    pub cells: Option<Arc<Cells>>,
}

impl DoseLayout {
    /// The layout of a grid, starting at `offset`.
    #[must_use]
    pub fn new(species: &str, grid: VolumeGrid, offset: usize) -> Self {
        let row = row_of(grid.shape[0]);
        DoseLayout {
            species: species.to_owned(),
            grid,
            offset,
            row,
            cells: None,
        }
    }

    /// The layout with two doses in some voxels.
    #[must_use]
    pub fn with_cells(mut self, cells: Arc<Cells>) -> Self {
        self.cells = Some(cells);
        self
    }

    /// Elements of voxels, padding included: what a field has before its inside cells.
    #[must_use]
    pub fn voxels(&self) -> usize {
        self.row * self.grid.shape[1] * self.grid.shape[2]
    }

    /// Elements in the field, padding and cells included.
    #[must_use]
    pub fn len(&self) -> usize {
        self.voxels() + self.cells.as_ref().map_or(0, |cells| cells.len())
    }

    /// Whether there is no element.
    #[must_use]
    pub fn is_empty(&self) -> bool {
        self.len() == 0
    }

    /// Elements of this species in the field.
    #[must_use]
    pub fn range(&self) -> Range<usize> {
        self.offset..self.offset + self.len()
    }

    /// Indices of cut voxels in arrays in file order, in the order of their inside cells.
    #[must_use]
    pub fn cut_voxels(&self) -> Vec<usize> {
        let [_, ny, nx] = self.grid.shape;
        let cells = self.cells.iter().flat_map(|cells| cells.iter());
        let place = |(element, _)| (element % self.row) * ny * nx + element / self.row;
        cells.map(place).collect()
    }

    /// Element of voxel `[iz, iy, ix]`.
    #[must_use]
    pub fn index(&self, iz: usize, iy: usize, ix: usize) -> usize {
        self.offset + (iy * self.grid.shape[2] + ix) * self.row + iz
    }

    /// The voxels of this species, of cut ones the mean of both cells, in the order of the field without its cells; `field` is
    /// the whole field of the model.
    ///
    /// # Panics
    /// When the field is shorter than the layout.
    #[must_use]
    pub fn voxels_of<'a>(&self, field: &'a [f32]) -> Cow<'a, [f32]> {
        let (voxels, inside) = field[self.range()].split_at(self.voxels());
        let Some(cells) = &self.cells else {
            return Cow::Borrowed(voxels);
        };
        let mut voxels = voxels.to_vec();
        cells.average(inside, &mut voxels);
        Cow::Owned(voxels)
    }

    /// This species as an array in file order `[z, y, x]`, of cut voxels the mean of both cells; `field` is the whole field of
    /// the model.
    ///
    /// # Panics
    /// When the field is shorter than the layout.
    #[must_use]
    pub fn volume_of(&self, field: &[f32]) -> Volume<f32> {
        let [nz, ny, nx] = self.grid.shape;
        let field = self.voxels_of(field);
        // Zeroed memory comes from the system page by page, in the threads that fill it
        let mut values = vec![0.0; nz * ny * nx];
        if values.is_empty() {
            return Volume::new(self.grid.clone(), values);
        }
        let mut rows: Vec<Vec<&mut [f32]>> = (0..ny).map(|_| Vec::with_capacity(nz)).collect();
        for (i, line) in values.chunks_mut(nx).enumerate() {
            rows[i % ny].push(line);
        }
        // In squares: the field has neighbors along z together, the array those along x
        let rows = rows.into_iter().zip(field.chunks(self.row * nx));
        rows.par_each(|(mut lines, field)| {
            let mut square = [[0.0f32; SQUARE]; SQUARE];
            for (slab, lines) in lines.chunks_mut(SQUARE).enumerate() {
                for first in (0..nx).step_by(SQUARE) {
                    let width = SQUARE.min(nx - first);
                    for x in 0..width {
                        let column = (first + x) * self.row + slab * SQUARE;
                        let column = &field[column..][..lines.len()];
                        for (line, &value) in square.iter_mut().zip(column) {
                            line[x] = value;
                        }
                    }
                    for (line, row) in lines.iter_mut().zip(&square) {
                        line[first..][..width].copy_from_slice(&row[..width]);
                    }
                }
            }
        });
        Volume::new(self.grid.clone(), values)
    }

    /// An array in file order as the elements of this species (length [`len`](Self::len), padding = default); both cells of a
    /// cut voxel get its value.
    ///
    /// # Panics
    /// When the volume has another shape.
    #[must_use]
    pub fn field_of<T: Copy + Default + Send + Sync>(&self, volume: &Volume<T>) -> Vec<T> {
        assert_eq!(
            volume.grid.shape, self.grid.shape,
            "volume of another shape"
        );
        let [nz, ny, nx] = self.grid.shape;
        let mut field = vec![T::default(); self.voxels()];
        if field.is_empty() {
            return field;
        }
        field
            .chunks_mut(self.row * nx)
            .enumerate()
            .par_each(|(iy, rows)| {
                for iz in 0..nz {
                    let line = &volume.values[(iz * ny + iy) * nx..][..nx];
                    for (ix, &value) in line.iter().enumerate() {
                        rows[ix * self.row + iz] = value;
                    }
                }
            });
        if let Some(cells) = &self.cells {
            cells.append(&mut field);
        }
        field
    }
}

/// One run of active pixels of a (frame, column): rows counted from the *bottom*.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct PixelRun {
    /// First element in the model's field.
    pub offset: usize,
    /// First active row, counted from the lowest row (row `rows − 1` of the image).
    pub bottom: u32,
    /// Number of active rows.
    pub count: u32,
}

/// The patterns of one light: where its active pixels lie in the model's field.
#[derive(Clone, Debug, PartialEq)]
pub struct PatternLayout {
    /// The pixels.
    pub grid: PatternGrid,
    /// What a value means.
    pub quantity: Quantity,
    /// First element in the field.
    pub offset: usize,
    /// Per (frame, column), frame-major: the active rows.
    pub runs: Vec<PixelRun>,
    len: usize,
}

impl PatternLayout {
    /// A layout with these active rows per (frame, column): `(bottom, count)`, rows counted from the lowest.
    ///
    /// # Panics
    /// When there are not `frames·columns` entries.
    #[must_use]
    pub fn new(
        grid: PatternGrid,
        quantity: Quantity,
        offset: usize,
        active: &[(u32, u32)],
    ) -> Self {
        assert_eq!(
            active.len(),
            grid.frames() * grid.columns,
            "one run per frame and column"
        );
        let mut next = offset;
        let runs = active
            .iter()
            .map(|&(bottom, count)| {
                let run = PixelRun {
                    offset: next,
                    bottom,
                    count,
                };
                next += count as usize;
                run
            })
            .collect();
        PatternLayout {
            grid,
            quantity,
            offset,
            runs,
            len: next - offset,
        }
    }

    /// Elements of the pattern field that belong to some of its frames.
    #[must_use]
    pub fn elements_of(&self, frames: Range<usize>) -> Range<usize> {
        let columns = self.grid.columns;
        self.elements_of_columns(frames.start * columns..frames.end * columns)
    }

    /// Elements of the pattern field that belong to some of its columns, counted through all frames.
    #[must_use]
    pub fn elements_of_columns(&self, columns: Range<usize>) -> Range<usize> {
        let begin = |column: usize| {
            let run = self.runs.get(column);
            run.map_or(self.offset + self.len, |run| run.offset)
        };
        begin(columns.start)..begin(columns.end)
    }

    /// The [elements of some frames](Self::elements_of), frame by frame; `elements` are those.
    #[must_use]
    pub fn split_frames<'a, T>(
        &self,
        frames: Range<usize>,
        mut elements: &'a mut [T],
    ) -> Vec<(usize, &'a mut [T])> {
        let of_frame = |frame: usize| {
            let count = self.elements_of(frame..frame + 1).len();
            let (values, rest) = std::mem::take(&mut elements).split_at_mut(count);
            elements = rest;
            (frame, values)
        };
        frames.map(of_frame).collect()
    }

    /// Number of active pixels.
    #[must_use]
    pub fn len(&self) -> usize {
        self.len
    }

    /// Whether no pixel is active.
    #[must_use]
    pub fn is_empty(&self) -> bool {
        self.len == 0
    }

    /// Elements of this light in the field.
    #[must_use]
    pub fn range(&self) -> Range<usize> {
        self.offset..self.offset + self.len
    }

    /// Full images of energy in file order, inactive pixels 0; `field` is the whole field of the model.
    ///
    /// # Panics
    /// When the field is shorter than the layout.
    #[must_use]
    pub fn patterns_of(&self, field: &[f32]) -> Patterns {
        let mut patterns = Patterns::dark(self.grid.clone());
        let (rows, columns) = (self.grid.rows, self.grid.columns);
        if patterns.values.is_empty() {
            return patterns;
        }
        patterns
            .values
            .chunks_mut(rows * columns)
            .zip(self.runs.chunks(columns))
            .par_each(|(image, runs)| {
                for (column, run) in runs.iter().enumerate() {
                    let values = &field[run.offset..][..run.count as usize];
                    for (i, &value) in values.iter().enumerate() {
                        image[(rows - 1 - run.bottom as usize - i) * columns + column] =
                            self.quantity.energy(value);
                    }
                }
            });
        patterns
    }

    /// Writes images of energy in file order into the field; inactive pixels are dropped.
    ///
    /// # Panics
    /// When the images have another shape or the field is shorter than the layout.
    pub fn fill_field(&self, patterns: &Patterns, field: &mut [f32]) {
        assert_eq!(
            patterns.grid.shape(),
            self.grid.shape(),
            "patterns of another shape"
        );
        let (rows, columns) = (self.grid.rows, self.grid.columns);
        if patterns.values.is_empty() {
            return;
        }
        let mut rest = &mut field[self.range()];
        let images = patterns.values.chunks(rows * columns);
        let frames = self.runs.chunks(columns).zip(images).map(|(runs, image)| {
            let active = runs.iter().map(|run| run.count as usize).sum();
            let (elements, others) = std::mem::take(&mut rest).split_at_mut(active);
            rest = others;
            (runs, image, elements)
        });
        frames.par_each(|(runs, image, mut elements)| {
            for (column, run) in runs.iter().enumerate() {
                let (values, others) = elements.split_at_mut(run.count as usize);
                elements = others;
                for (i, value) in values.iter_mut().enumerate() {
                    let energy = image[(rows - 1 - run.bottom as usize - i) * columns + column];
                    *value = self.quantity.value(energy);
                }
            }
        });
    }
}

/// Frames of all lights.
#[must_use]
pub fn frames_of(lights: &[PatternLayout]) -> usize {
    lights.iter().map(|light| light.grid.frames()).sum()
}

/// The lights that have some of these frames, which are counted through all lights, and which of their own frames these are.
pub fn own_frames<'a>(
    lights: &'a [PatternLayout],
    frames: &Range<usize>,
) -> impl Iterator<Item = (usize, Range<usize>)> + use<'a> {
    let frames = frames.clone();
    let mut first = 0;
    let of_light = move |(light, layout): (usize, &PatternLayout)| {
        let end = first + layout.grid.frames();
        let local = frames.start.clamp(first, end) - first..frames.end.clamp(first, end) - first;
        first = end;
        (light, local)
    };
    let all = lights.iter().enumerate().map(of_light);
    all.filter(|(_, local)| !local.is_empty())
}

/// Elements of the pattern field that belong to some frames of all lights, light by light, and what a value there means.
pub fn elements_of<'a>(
    lights: &'a [PatternLayout],
    frames: &Range<usize>,
) -> impl Iterator<Item = (Range<usize>, Quantity)> + use<'a> {
    own_frames(lights, frames)
        .map(|(light, local)| (lights[light].elements_of(local), lights[light].quantity))
}
