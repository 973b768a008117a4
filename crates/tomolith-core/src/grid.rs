//! What an array index means in mm and rad.
//!
//! Frame: right-handed, mm, z = rotation axis, up, origin = center of the vial. Files and API arrays are in C order:
//! dose `[z, y, x]` with index 0 = most negative coordinate, patterns `[angle, row, column]` with row 0 = top (+z) and
//! columns growing along (−sin α, cos α, 0). Sample i of n sits at `(i − (n−1)/2)·pitch` from the center, for even and
//! odd n alike. See `docs/conventions.md`.
//!
//! ```
//! use tomolith_core::grid::sample;
//! assert_eq!(sample(0, 4, 1.0), -1.5); // even: no sample on the center
//! assert_eq!(sample(1, 3, 1.0), 0.0); // odd: the middle sample is the center
//! ```

mod mask;

pub use mask::PixelMask;
use std::f64::consts::TAU;

/// Coordinate of sample `i` of `n`, relative to the center, in the unit of `pitch`.
#[must_use]
pub fn sample(i: usize, n: usize, pitch: f64) -> f64 {
    (i as f64 - (n as f64 - 1.0) / 2.0) * pitch
}

/// A box of voxels: cubes, or square columns that are lower or higher than wide.
///
/// Files, metrics and most models know cubes alone. An optimization may look at voxels that are as high as a row of pixels and
/// finer across: collimated light is the same at all heights of a row.
#[derive(Clone, Debug, PartialEq)]
pub struct VolumeGrid {
    /// Counts `[nz, ny, nx]`, the order of the arrays.
    pub shape: [usize; 3],
    /// Edge of a voxel along x and y, mm.
    pub pitch_mm: f64,
    /// Edge of a voxel along z, mm.
    pub height_mm: f64,
    /// Center of the box `[x, y, z]` in the resin frame, mm.
    pub center_mm: [f64; 3],
}

impl VolumeGrid {
    /// A box centered on the origin, `shape = [nz, ny, nx]`.
    #[must_use]
    pub fn centered(shape: [usize; 3], pitch_mm: f64) -> Self {
        VolumeGrid {
            shape,
            pitch_mm,
            height_mm: pitch_mm,
            center_mm: [0.0; 3],
        }
    }

    /// The same box about another center, mm.
    #[must_use]
    pub fn about(self, center_mm: [f64; 3]) -> Self {
        VolumeGrid { center_mm, ..self }
    }

    /// Number of voxels.
    #[must_use]
    pub fn len(&self) -> usize {
        self.shape.iter().product()
    }

    /// Whether there is no voxel at all.
    #[must_use]
    pub fn is_empty(&self) -> bool {
        self.len() == 0
    }

    /// x of the centers of column `ix`, mm.
    #[must_use]
    pub fn x(&self, ix: usize) -> f64 {
        self.center_mm[0] + sample(ix, self.shape[2], self.pitch_mm)
    }

    /// y of the centers of row `iy`, mm.
    #[must_use]
    pub fn y(&self, iy: usize) -> f64 {
        self.center_mm[1] + sample(iy, self.shape[1], self.pitch_mm)
    }

    /// z of the centers of slice `iz`, mm.
    #[must_use]
    pub fn z(&self, iz: usize) -> f64 {
        self.center_mm[2] + sample(iz, self.shape[0], self.height_mm)
    }

    /// Center `[x, y, z]` of the voxel at a position in an array, mm.
    #[must_use]
    pub fn middle(&self, index: usize) -> [f64; 3] {
        let [_, ny, nx] = self.shape;
        [
            self.x(index % nx),
            self.y(index / nx % ny),
            self.z(index / (nx * ny)),
        ]
    }

    /// Position of `[iz, iy, ix]` in an array.
    #[must_use]
    pub fn index(&self, iz: usize, iy: usize, ix: usize) -> usize {
        (iz * self.shape[1] + iy) * self.shape[2] + ix
    }

    /// Lowest and highest corner `[x, y, z]` of the box (outer faces of the voxels), mm.
    #[must_use]
    pub fn bounds_mm(&self) -> [[f64; 3]; 2] {
        let n = [self.shape[2], self.shape[1], self.shape[0]];
        let edges = [self.pitch_mm, self.pitch_mm, self.height_mm];
        let half: [f64; 3] = std::array::from_fn(|i| n[i] as f64 * edges[i] / 2.0);
        let c = self.center_mm;
        [
            std::array::from_fn(|i| c[i] - half[i]),
            std::array::from_fn(|i| c[i] + half[i]),
        ]
    }

    /// Volume of one voxel, mm³.
    #[must_use]
    pub fn voxel_mm3(&self) -> f64 {
        self.pitch_mm * self.pitch_mm * self.height_mm
    }

    /// The same box with `factor` times as many voxels along each edge.
    #[must_use]
    pub fn refined(&self, factor: usize) -> Self {
        self.divided(factor, factor)
    }

    /// The same box with `across` times as many voxels along x and y, and `along` times as many along z.
    #[must_use]
    pub fn divided(&self, across: usize, along: usize) -> Self {
        let [nz, ny, nx] = self.shape;
        VolumeGrid {
            shape: [nz * along, ny * across, nx * across],
            pitch_mm: self.pitch_mm / across as f64,
            height_mm: self.height_mm / along as f64,
            center_mm: self.center_mm,
        }
    }
}

/// Values on a [`VolumeGrid`], array order `[z, y, x]`.
#[derive(Clone, Debug, PartialEq)]
pub struct Volume<T> {
    /// Where the values are.
    pub grid: VolumeGrid,
    /// One value per voxel, x fastest.
    pub values: Vec<T>,
}

impl<T: Clone> Volume<T> {
    /// A volume of one value.
    #[must_use]
    pub fn filled(grid: VolumeGrid, value: T) -> Self {
        let values = vec![value; grid.len()];
        Volume { grid, values }
    }
}

impl<T> Volume<T> {
    /// These values, x fastest, z slowest.
    #[must_use]
    pub fn new(grid: VolumeGrid, values: Vec<T>) -> Self {
        Volume { grid, values }
    }

    /// The value of each voxel from its center `[x, y, z]`, mm.
    pub fn from_fn(grid: VolumeGrid, value: impl FnMut([f64; 3]) -> T) -> Self {
        let values = (0..grid.len()).map(|i| grid.middle(i)).map(value).collect();
        Volume { grid, values }
    }

    /// The value at `[iz, iy, ix]`.
    ///
    /// # Panics
    /// When an index is outside the grid.
    #[must_use]
    pub fn at(&self, iz: usize, iy: usize, ix: usize) -> &T {
        &self.values[self.grid.index(iz, iy, ix)]
    }
}

/// The pixels of one light: frames, and a regular grid of rows and columns.
#[derive(Clone, Debug, PartialEq)]
pub struct PatternGrid {
    /// Azimuth α of each frame, rad: the light arrives from there, in the resin frame, counter-clockwise from above.
    pub azimuths: Vec<f64>,
    /// Arc through which the vial turns during one frame, rad (0 for a list of angles).
    pub frame_arc: f64,
    /// Rows; row 0 is the top (+z).
    pub rows: usize,
    /// Columns; they grow along (−sin α, cos α, 0).
    pub columns: usize,
    /// Distance of columns and of rows at the vial, mm.
    pub pitch_mm: [f64; 2],
    /// Offset of the image's center from the rotation axis [u, z], mm.
    pub offset_mm: [f64; 2],
}

impl PatternGrid {
    /// `count` frames over the full turn from `start` (rad), of square pixels about the axis; the vial turns clockwise, so azimuths grow.
    #[must_use]
    pub fn full_turn(count: usize, start: f64, rows: usize, columns: usize, pitch_mm: f64) -> Self {
        PatternGrid {
            azimuths: (0..count)
                .map(|k| start + TAU * k as f64 / count as f64)
                .collect(),
            frame_arc: TAU / count.max(1) as f64,
            rows,
            columns,
            pitch_mm: [pitch_mm; 2],
            offset_mm: [0.0; 2],
        }
    }

    /// Number of frames.
    #[must_use]
    pub fn frames(&self) -> usize {
        self.azimuths.len()
    }

    /// Shape of the array: `[frames, rows, columns]`.
    #[must_use]
    pub fn shape(&self) -> [usize; 3] {
        [self.frames(), self.rows, self.columns]
    }

    /// Number of pixels of all frames.
    #[must_use]
    pub fn len(&self) -> usize {
        self.frames() * self.rows * self.columns
    }

    /// Whether there is no pixel at all.
    #[must_use]
    pub fn is_empty(&self) -> bool {
        self.len() == 0
    }

    /// z of the center of row `row`, mm (row 0 is the highest).
    #[must_use]
    pub fn row_z(&self, row: usize) -> f64 {
        self.offset_mm[1] - sample(row, self.rows, self.pitch_mm[1])
    }

    /// Lateral coordinate u of the center of column `column`, mm.
    #[must_use]
    pub fn column_u(&self, column: usize) -> f64 {
        self.offset_mm[0] + sample(column, self.columns, self.pitch_mm[0])
    }

    /// Lowest and highest corner [u, z] of the image, mm.
    #[must_use]
    pub fn field_mm(&self) -> [[f64; 2]; 2] {
        let half = [
            self.columns as f64 * self.pitch_mm[0] / 2.0,
            self.rows as f64 * self.pitch_mm[1] / 2.0,
        ];
        [-1.0, 1.0].map(|side| std::array::from_fn(|i| self.offset_mm[i] + side * half[i]))
    }

    /// The one pitch of square pixels, mm; None where columns and rows differ.
    #[must_use]
    pub fn square_pitch_mm(&self) -> Option<f64> {
        let [u, z] = self.pitch_mm;
        (u == z).then_some(u)
    }

    /// Area of a pixel, mm².
    #[must_use]
    pub fn pixel_mm2(&self) -> f64 {
        self.pitch_mm[0] * self.pitch_mm[1]
    }
}

/// Pattern values of one light, array order `[angle, row, column]`, mJ/mm² (or relative).
#[derive(Clone, Debug, PartialEq)]
pub struct Patterns {
    /// Which pixel is where.
    pub grid: PatternGrid,
    /// One value per pixel, column fastest.
    pub values: Vec<f32>,
}

impl Patterns {
    /// Dark patterns.
    #[must_use]
    pub fn dark(grid: PatternGrid) -> Self {
        let values = vec![0.0; grid.len()];
        Patterns { grid, values }
    }

    /// The image of one frame, `[row, column]`.
    ///
    /// # Panics
    /// When `frame` is not smaller than the number of frames.
    #[must_use]
    pub fn frame(&self, frame: usize) -> &[f32] {
        let size = self.grid.rows * self.grid.columns;
        &self.values[frame * size..(frame + 1) * size]
    }
}
