//! Surface-aware cells: a voxel that the target's surface cuts has one dose inside and one outside.
//!
//! # Model
//! With s the share of the voxel that is inside and E•, E° the energy per voxel volume that light leaves on either side
//! (Nicolet et al. 2024, § 4.4 and eq. 18):
//!
//! ```text
//! dose• = E•/s        dose° = E°/(1 − s)        s·dose• + (1 − s)·dose° = E• + E°, the dose of the whole voxel
//! ```
//!
//! # Shapes
//! A dose field holds its voxels, of a cut one the *outside* cell, and behind them the inside cells in the order of their voxels.
//! A cell below [`LEAST`] of its voxel is merged into the other: that voxel is not cut.
//!
//! ```
//! use std::sync::Arc;
//! use tomolith_core::grid::{Volume, VolumeGrid};
//! use tomolith_core::dose::{DoseLayout, cells::Cells};
//! let grid = VolumeGrid::centered([1, 1, 3], 0.1);
//! let layout = DoseLayout::new("dose", grid.clone(), 0);
//! let cells = Cells::new(&layout, &Volume { grid, values: vec![0.0, 0.25, 1.0] });
//! let layout = layout.with_cells(Arc::new(cells));
//! // Three voxels, the middle one with 0.2 outside, and 1.0 in its inside cell: mean 0.75·0.2 + 0.25·1
//! assert_eq!(layout.volume_of(&[0.0, 0.2, 0.9, 1.0]).values, [0.0, 0.4, 0.9]);
//! ```

use super::layout::DoseLayout;
use crate::field::BLOCK;
use crate::grid::Volume;
use crate::parallel::InParallel;
use crate::target::label;

/// Share of a voxel below which a cell is merged into the other.
pub const LEAST: f32 = 1e-3;

/// The voxels that are cut.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Cells {
    /// Their elements, counted from the first of their species, ascending.
    voxels: Vec<u32>,
    /// The inside share of each, from [`LEAST`] to 1 − [`LEAST`].
    inside: Vec<f32>,
}

impl Cells {
    /// The cells of a grid whose voxels are inside with these shares (file order `[z, y, x]`).
    ///
    /// # Panics
    /// When `shares` has another shape than the layout.
    #[must_use]
    pub fn new(layout: &DoseLayout, shares: &Volume<f32>) -> Self {
        let plain = DoseLayout {
            cells: None,
            ..layout.clone()
        };
        let shares = plain.field_of(shares);
        let cut = |s: f32| (LEAST..=1.0 - LEAST).contains(&s);
        let voxels: Vec<u32> = (0..shares.len() as u32)
            .filter(|&i| cut(shares[i as usize]))
            .collect();
        Cells {
            inside: voxels.iter().map(|&i| shares[i as usize]).collect(),
            voxels,
        }
    }

    /// How many voxels are cut.
    #[must_use]
    pub fn len(&self) -> usize {
        self.voxels.len()
    }

    /// Whether no voxel is cut.
    #[must_use]
    pub fn is_empty(&self) -> bool {
        self.voxels.is_empty()
    }

    /// Element and inside share of every cut voxel.
    pub fn iter(&self) -> impl Iterator<Item = (usize, f32)> + '_ {
        let shares = self.inside.iter().copied();
        self.voxels.iter().map(|&i| i as usize).zip(shares)
    }

    /// What every element of the field is, from the labels of its voxels (`field`, cells included): outside cells are void and
    /// inside cells part, where the voxel counts.
    pub fn label(&self, field: &mut [u8]) {
        let (voxels, inside) = field.split_at_mut(field.len() - self.len());
        for ((voxel, _), inside) in self.iter().zip(inside) {
            if voxels[voxel] != label::OUTSIDE {
                (voxels[voxel], *inside) = (label::VOID, label::PART);
            }
        }
    }

    /// Sets all outside cells of cut voxels, and all inside cells, of a field.
    pub fn fill(&self, [outside, inside]: [f32; 2], field: &mut [f32]) {
        let (voxels, cells) = field.split_at_mut(field.len() - self.len());
        self.iter().for_each(|(voxel, _)| voxels[voxel] = outside);
        cells.fill(inside);
    }

    /// The part of its voxel that every element of a field has: 1 where it is not cut.
    #[must_use]
    pub fn shares(&self, elements: usize) -> Vec<f32> {
        let mut shares = vec![1.0; elements - self.len()];
        self.iter().for_each(|(voxel, s)| shares[voxel] = 1.0 - s);
        shares.extend(&self.inside);
        shares
    }

    /// Both cells of a cut voxel get what the voxel has.
    pub fn append<T: Copy>(&self, field: &mut Vec<T>) {
        for &voxel in &self.voxels {
            field.push(field[voxel as usize]);
        }
    }

    /// Voxels with their outside cells → voxels.
    pub fn average(&self, inside: &[f32], voxels: &mut [f32]) {
        for ((voxel, s), &inside) in self.iter().zip(inside) {
            voxels[voxel] = s * inside + (1.0 - s) * voxels[voxel];
        }
    }

    /// dose += the doses of energies left outside and inside, per voxel volume; `dose` has voxels and inside cells.
    pub fn add(&self, [outside, inside]: [&[f32]; 2], dose: &mut [f32]) {
        let (voxels, cells) = dose.split_at_mut(outside.len());
        let mut lit = outside.to_vec();
        add(&mut lit, inside);
        for ((voxel, s), cell) in self.iter().zip(cells) {
            lit[voxel] = outside[voxel] / (1.0 - s);
            *cell += inside[voxel] / s;
        }
        add(voxels, &lit);
    }

    /// The transpose of [`add`](Self::add): what a unit of energy outside and inside of every voxel is worth.
    pub fn collect(&self, cotangent: &[f32]) -> [Vec<f32>; 2] {
        let (voxels, cells) = cotangent.split_at(cotangent.len() - self.len());
        let (mut outside, mut inside) = (voxels.to_vec(), voxels.to_vec());
        for ((voxel, s), cell) in self.iter().zip(cells) {
            outside[voxel] /= 1.0 - s;
            inside[voxel] = cell / s;
        }
        [outside, inside]
    }

    /// dose += a dose that is the same in both cells of a voxel.
    pub fn add_even(&self, voxels: &[f32], dose: &mut [f32]) {
        let (voxel_doses, cells) = dose.split_at_mut(voxels.len());
        add(voxel_doses, voxels);
        for ((voxel, _), cell) in self.iter().zip(cells) {
            *cell += voxels[voxel];
        }
    }

    /// The transpose of [`add_even`](Self::add_even).
    pub fn collect_even(&self, cotangent: &[f32]) -> Vec<f32> {
        let (voxels, cells) = cotangent.split_at(cotangent.len() - self.len());
        let mut sums = voxels.to_vec();
        for ((voxel, _), cell) in self.iter().zip(cells) {
            sums[voxel] += cell;
        }
        sums
    }
}

/// sums += terms
fn add(sums: &mut [f32], terms: &[f32]) {
    let blocks = sums.chunks_mut(BLOCK).zip(terms.chunks(BLOCK));
    blocks.par_each(|(sums, terms)| {
        sums.iter_mut()
            .zip(terms)
            .for_each(|(sum, term)| *sum += term)
    });
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::grid::VolumeGrid;
    use std::sync::Arc;

    fn layout(shares: &[f32]) -> DoseLayout {
        let grid = VolumeGrid::centered([1, 1, shares.len()], 1.0);
        let layout = DoseLayout::new("dose", grid.clone(), 0);
        let values = shares.to_vec();
        let cells = Cells::new(&layout, &Volume { grid, values });
        layout.with_cells(Arc::new(cells))
    }

    #[test]
    fn cells_below_a_thousandth_are_merged_and_doses_add_up() {
        let layout = layout(&[0.0, 9e-4, 0.2, 0.9992, 0.75, 1.0]);
        let cells = layout.cells.clone().unwrap();
        assert_eq!(cells.iter().collect::<Vec<_>>(), [(2, 0.2), (4, 0.75)]);
        assert_eq!(layout.len(), 8);
        let (outside, inside) = ([1.0, 2.0, 3.0, 4.0, 5.0, 6.0], [0.5; 6]);
        let mut dose = vec![0.0; 8];
        cells.add([&outside, &inside], &mut dose);
        assert_eq!(dose, [1.5, 2.5, 3.0 / 0.8, 4.5, 20.0, 6.5, 2.5, 0.5 / 0.75]);
        let volume = layout.volume_of(&dose).values;
        for (found, expected) in volume.iter().zip([1.5f32, 2.5, 3.5, 4.5, 5.5, 6.5]) {
            assert!((found - expected).abs() < 1e-6, "{volume:?}");
        }
        let mut labels = layout.field_of(&Volume::new(
            layout.grid.clone(),
            vec![
                label::VOID,
                label::VOID,
                label::VOID,
                label::PART,
                0,
                label::PART,
            ],
        ));
        cells.label(&mut labels);
        assert_eq!(labels, [1, 1, 1, 2, 0, 2, 2, 0]);
        assert_eq!(cells.shares(8), [1.0, 1.0, 0.8, 1.0, 0.25, 1.0, 0.2, 0.75]);
    }
}
