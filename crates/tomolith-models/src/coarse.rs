//! Scattered light on coarser voxels: it is smooth, so a few random segments say more about it there.
//!
//! Doses between the middles of cells are interpolated linearly along x, y and z; beyond the outermost middles they stay as
//! they are there. [`Coarse::spread`] adds cells to voxels, [`Coarse::gather`] is its transpose. A voxel of which a part is resin gets
//! that part of its dose ([`Coarse::with_shares`]) where cells hold what resin would get.

use crate::layout::DoseLayout;
use std::sync::Arc;
use tomolith_core::dose::scattered::CellGrid;
use tomolith_core::grid::VolumeGrid;
use tomolith_core::parallel::InParallel;

/// The coarse cells of a grid of voxels.
#[derive(Clone, Debug)]
pub(super) struct Coarse {
    pub(super) layout: DoseLayout,
    fine: DoseLayout,
    /// Along x, y, z: the cell below each voxel's middle, and the weight of the next one.
    places: [Vec<(usize, f32)>; 3],
    /// Part of each (y, x) of voxels that gets its dose; None: all of all.
    pub(super) shares: Option<Arc<Vec<f32>>>,
}

impl Coarse {
    /// Cells of `factor` voxels along each edge, one layer of them outside of the grid on every side. Layers whose middles lie beyond the grid hold
    /// next to no light where the resin ends with the grid: voxels beside them keep the dose of the layer within.
    pub(super) fn new(
        fine: &DoseLayout,
        factor: usize,
        in_resin: impl Fn([f64; 3]) -> bool,
    ) -> Self {
        let shape = fine.grid.shape.map(|n| n.div_ceil(factor) + 2);
        let pitch_mm = fine.grid.pitch_mm * factor as f64;
        let low = fine.grid.bounds_mm()[0];
        let counts = [shape[2], shape[1], shape[0]];
        let center_mm =
            std::array::from_fn(|i| low[i] - pitch_mm + counts[i] as f64 * pitch_mm / 2.0);
        let grid = VolumeGrid {
            shape,
            pitch_mm,
            height_mm: pitch_mm,
            center_mm,
        };
        let ends = ends(&grid, fine.grid.bounds_mm(), in_resin);
        Self::between(grid, fine, ends)
    }

    /// Any cells, at least two along each axis.
    pub(super) fn of_grid(cells: VolumeGrid, fine: &DoseLayout) -> Self {
        let [nz, ny, nx] = cells.shape;
        let ends = [nx, ny, nz].map(|count| [0, count - 1]);
        Self::between(cells, fine, ends)
    }

    /// Cells that are interpolated from one to another of them along x, y, z.
    fn between(cells: VolumeGrid, fine: &DoseLayout, ends: [[usize; 2]; 3]) -> Self {
        let low = cells.bounds_mm()[0];
        let places = |axis: usize, voxels: usize, middle: &dyn Fn(usize) -> f64| {
            let [first, last] = ends[axis].map(|end| end as f64);
            let place = |i: usize| {
                let place = (middle(i) - low[axis]) / cells.pitch_mm - 0.5;
                let place = place.clamp(first, last);
                let below = (place as usize).min(cells.shape[2 - axis] - 2);
                (below, (place - below as f64) as f32)
            };
            (0..voxels).map(place).collect()
        };
        let [nz, ny, nx] = fine.grid.shape;
        let places = [
            places(0, nx, &|i| fine.grid.x(i)),
            places(1, ny, &|i| fine.grid.y(i)),
            places(2, nz, &|i| fine.grid.z(i)),
        ];
        Coarse {
            layout: DoseLayout::new("dose", cells, 0),
            fine: fine.clone(),
            places,
            shares: None,
        }
    }

    /// Voxels of which so much gets dose, for each (y, x).
    pub(super) fn with_shares(self, shares: Arc<Vec<f32>>) -> Self {
        Coarse {
            shares: Some(shares),
            ..self
        }
    }

    /// As data, with the cells that are all resin.
    pub(super) fn form(&self, is_full: Arc<Vec<bool>>) -> CellGrid {
        CellGrid {
            layout: self.layout.clone(),
            is_full,
            places: self.places.clone(),
        }
    }

    /// Part of the voxels (y, x) that gets dose.
    fn share(&self, y: usize, x: usize) -> f32 {
        let at = y * self.fine.grid.shape[2] + x;
        self.shares.as_ref().map_or(1.0, |shares| shares[at])
    }

    /// Floats of one y of cells: `[x][z]`.
    fn plane(&self) -> usize {
        self.layout.grid.shape[2] * self.layout.row
    }

    /// fine += interpolated cells
    pub(super) fn spread(&self, cells: &[f32], fine: &mut [f32]) {
        let (plane, row) = (self.plane(), self.layout.row);
        let [of_x, of_y, of_z] = &self.places;
        let fine_row = self.fine.row;
        fine[self.fine.range()]
            .chunks_mut(fine_row * self.fine.grid.shape[2])
            .zip(of_y)
            .enumerate()
            .par_each_with(
                || vec![0.0; row],
                |line, (of_voxels, (voxels, &(y, next_y)))| {
                    let planes = [
                        &cells[y * plane..][..plane],
                        &cells[(y + 1) * plane..][..plane],
                    ];
                    let voxels = voxels.chunks_exact_mut(fine_row).zip(of_x).enumerate();
                    for (i, (voxels, &(x, next_x))) in voxels {
                        let share = self.share(of_voxels, i);
                        line.fill(0.0);
                        for (plane, wy) in planes.iter().zip([1.0 - next_y, next_y]) {
                            for (x, wx) in [(x, 1.0 - next_x), (x + 1, next_x)] {
                                let cells = &plane[x * row..][..row];
                                for (sum, cell) in line.iter_mut().zip(cells) {
                                    *sum += share * wy * wx * cell;
                                }
                            }
                        }
                        for (voxel, &(z, next)) in voxels.iter_mut().zip(of_z) {
                            *voxel += (1.0 - next) * line[z] + next * line[z + 1];
                        }
                    }
                },
            );
    }

    /// cells = transpose of [`spread`](Self::spread) on `fine`
    pub(super) fn gather(&self, fine: &[f32], cells: &mut [f32]) {
        let (plane, row) = (self.plane(), self.layout.row);
        let [of_x, of_y, of_z] = &self.places;
        let fine_row = self.fine.row;
        // Along z and x within every y of voxels, then along y
        let planes: Vec<Vec<f32>> = fine[self.fine.range()]
            .chunks(fine_row * self.fine.grid.shape[2])
            .enumerate()
            .par_map(|(of_voxels, voxels)| {
                let (mut sums, mut line) = (vec![0.0; plane], vec![0.0; row]);
                let voxels = voxels.chunks_exact(fine_row).zip(of_x).enumerate();
                for (i, (voxels, &(x, next_x))) in voxels {
                    let share = self.share(of_voxels, i);
                    line.fill(0.0);
                    for (&voxel, &(z, next)) in voxels.iter().zip(of_z) {
                        line[z] += (1.0 - next) * voxel;
                        line[z + 1] += next * voxel;
                    }
                    for (x, wx) in [(x, 1.0 - next_x), (x + 1, next_x)] {
                        for (sum, value) in sums[x * row..][..row].iter_mut().zip(&line) {
                            *sum += share * wx * value;
                        }
                    }
                }
                sums
            });
        cells.chunks_mut(plane).enumerate().par_each(|(y, cells)| {
            cells.fill(0.0);
            for (sums, &(below, next)) in planes.iter().zip(of_y) {
                let weight = match y.checked_sub(below) {
                    Some(0) => 1.0 - next,
                    Some(1) => next,
                    _ => continue,
                };
                for (cell, sum) in cells.iter_mut().zip(sums) {
                    *cell += weight * sum;
                }
            }
        });
    }
}

/// The first and the last layer of cells along x, y and z whose middles lie within a box, not on its faces, or in the resin beyond it.
fn ends(
    cells: &VolumeGrid,
    [low, high]: [[f64; 3]; 2],
    in_resin: impl Fn([f64; 3]) -> bool,
) -> [[usize; 2]; 3] {
    let [nz, ny, nx] = cells.shape;
    let rounding = 1e-6 * cells.pitch_mm;
    let mut is_lit = [nx, ny, nz].map(|count| vec![false; count]);
    for i in 0..cells.len() {
        let middle = cells.middle(i);
        let in_resin = in_resin(middle);
        for (axis, at) in [i % nx, i / nx % ny, i / (nx * ny)].into_iter().enumerate() {
            let from_faces = (middle[axis] - low[axis]).min(high[axis] - middle[axis]);
            is_lit[axis][at] |= in_resin || from_faces > rounding;
        }
    }
    is_lit.map(|is_lit| {
        let first = is_lit.iter().position(|&is_lit| is_lit);
        let last = is_lit.iter().rposition(|&is_lit| is_lit);
        [first.unwrap_or_default(), last.unwrap_or(is_lit.len() - 1)]
    })
}

#[cfg(test)]
mod tests {
    use super::*;
    use tomolith_core::check::noise;
    use tomolith_core::grid::Volume;

    #[test]
    fn a_layer_whose_middle_lies_on_the_face_of_the_grid_is_beyond_it() {
        // 15 voxels are seven cells and a half: the middle of the last layer lies where the grid ends
        for pitch in [0.45, 0.15, 0.1, 0.07] {
            let fine = VolumeGrid::centered([15; 3], pitch);
            let cells = VolumeGrid {
                shape: [9; 3],
                pitch_mm: 2.0 * pitch,
                height_mm: 2.0 * pitch,
                center_mm: [-0.5 * pitch; 3],
            };
            let [low, high] = fine.bounds_mm();
            let beyond = cells.middle(cells.len() - 1)[0] - high[0];
            assert!(beyond.abs() < 1e-9 * pitch, "{beyond}");
            let found = ends(&cells, [low, high], |_| false);
            assert_eq!(found, [[1, 7]; 3], "{pitch}");
        }
    }

    #[test]
    fn layers_beyond_the_wall_of_the_resin_take_nothing() {
        let grid = VolumeGrid::centered([9, 8, 14], 0.1);
        let fine = DoseLayout::new("dose", grid, 0);
        // The wall of a cuvette at the faces of the grid along x and y; along z the resin goes on
        let in_resin = |[x, y, _]: [f64; 3]| x.abs() < 0.7 && y.abs() < 0.4;
        let coarse = Coarse::new(&fine, 4, in_resin);
        let cells = Volume::from_fn(coarse.layout.grid.clone(), |at| {
            f32::from(u8::from(in_resin(at)))
        });
        let mut found = vec![0.0; fine.len()];
        coarse.spread(&coarse.layout.field_of(&cells), &mut found);
        let found = fine.volume_of(&found);
        // 14 voxels are three cells and a half: the last middle lies in the resin's last half
        let off = found
            .values
            .iter()
            .map(|v| (v - 1.0).abs())
            .fold(0.0, f32::max);
        assert!(off < 1e-6, "{off}");
    }

    #[test]
    fn a_dose_that_is_linear_in_space_is_interpolated_exactly_and_gather_is_the_transpose() {
        let grid = VolumeGrid::centered([9, 11, 14], 0.1);
        let fine = DoseLayout::new("dose", grid, 0);
        let coarse = Coarse::new(&fine, 4, |_| true);
        let linear = |[x, y, z]: [f64; 3]| (1.0 + 2.0 * x - 3.0 * y + 0.5 * z) as f32;
        let fill =
            |layout: &DoseLayout| layout.field_of(&Volume::from_fn(layout.grid.clone(), linear));
        let (cells, expected) = (fill(&coarse.layout), fill(&fine));
        let mut found = vec![0.0; fine.len()];
        coarse.spread(&cells, &mut found);
        for (a, b) in expected.iter().zip(&found) {
            assert!((a - b).abs() < 1e-5, "{a} {b}");
        }
        let (d, mut c) = (noise(1, coarse.layout.len()), noise(2, fine.len()));
        // Padding holds no voxels
        let holds: Vec<bool> = fill(&fine).iter().map(|&v| v != 0.0).collect();
        c.iter_mut()
            .zip(&holds)
            .for_each(|(c, &holds)| *c *= f32::from(u8::from(holds)));
        let mut forward = vec![0.0; fine.len()];
        coarse.spread(&d, &mut forward);
        let mut back = vec![0.0; coarse.layout.len()];
        coarse.gather(&c, &mut back);
        let dot =
            |a: &[f32], b: &[f32]| a.iter().zip(b).map(|(a, b)| f64::from(a * b)).sum::<f64>();
        assert!((dot(&forward, &c) - dot(&d, &back)).abs() < 1e-4);
    }
}
