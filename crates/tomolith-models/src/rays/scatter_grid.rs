//! Scattered light on cells larger than voxels, and from there to voxels.
//!
//! Cells hold what segments leave in them; doses of voxels are interpolated ([`Coarse`]), and what both smear out may be brought back
//! ([`Sharpen`]) in cells that are all resin: those of which all corners are, so a body smaller than a cell may be missed. Where
//! absorption is a map, cells hold fluence, and a voxel takes its own part of it.

use super::segment::Lattice;
use super::solid::Solid;
use super::{Optics, Scattered};
use crate::DoseLayout;
use crate::cell_blur::{CellBlur, Sharpen, full_cells};
use crate::coarse::Coarse;
use std::borrow::Cow;
use std::sync::Arc;
use tomolith_core::dose::scattered::CellGrid;
use tomolith_optics::light::Light;
use tomolith_optics::vial::Vial;

/// The cells of a model.
pub(super) struct ScatterGrid {
    pub(super) lattice: Lattice,
    coarse: Coarse,
    /// None where cells are voxels, or are left as they are.
    sharpen: Option<Sharpen>,
    voxels: usize,
    /// What every voxel takes of a light's fluence, where cells sum that.
    takes: Vec<Option<Arc<Vec<f32>>>>,
}

impl ScatterGrid {
    /// Cells of some voxels along an edge.
    pub(super) fn new(
        vial: &dyn Vial,
        lights: &[Light],
        optics: &[Optics],
        fine: &DoseLayout,
        scattered: &Scattered,
    ) -> Self {
        let smooth = scattered.smooth;
        let bodies = || optics.iter().flat_map(|optics| &optics.obstacles);
        let in_resin = |at| vial.in_resin(at) && !bodies().any(|body| body.surface.contains(at));
        let coarse = Coarse::new(fine, smooth, in_resin);
        let sharpen = || {
            let is_full = full_cells(&coarse.layout, in_resin);
            Sharpen::new(
                &coarse.layout,
                &is_full,
                CellBlur::cells(smooth, fine.grid.pitch_mm),
            )
        };
        ScatterGrid {
            lattice: Lattice::new(&coarse.layout),
            sharpen: (scattered.is_sharp && smooth > 1).then(sharpen),
            voxels: fine.len(),
            takes: if smooth > 1 {
                takes(lights, fine)
            } else {
                vec![None; lights.len()]
            },
            coarse,
        }
    }

    /// Whether cells hold a light's fluence instead of its dose.
    pub(super) fn is_fluence(&self, light: usize) -> bool {
        self.takes[light].is_some()
    }

    /// The cells as data; also how much they are sharpened. None where they hold fluence.
    pub(super) fn form(&self) -> Option<(CellGrid, Option<[f32; 3]>)> {
        if self.takes.iter().any(Option::is_some) {
            return None;
        }
        let is_full = self.sharpen.as_ref().map(|s| Arc::clone(s.is_full()));
        let sharpened = self.sharpen.as_ref().map(Sharpen::strength);
        Some((self.coarse.form(is_full.unwrap_or_default()), sharpened))
    }

    /// Dark cells.
    pub(super) fn cells(&self) -> Vec<f32> {
        vec![0.0; self.coarse.layout.len()]
    }

    /// dose += a light's scattered light, which both cells of a voxel that a solid cuts get alike
    pub(super) fn add(&self, light: usize, cells: &[f32], solid: Option<&Solid>, dose: &mut [f32]) {
        let cells = match &self.sharpen {
            Some(sharpen) => Cow::Owned(sharpen.of(cells)),
            None => Cow::Borrowed(cells),
        };
        let takes = &self.takes[light];
        if takes.is_none() && solid.is_none() {
            self.coarse.spread(&cells, dose);
            return;
        }
        let mut voxels = vec![0.0; self.voxels];
        self.coarse.spread(&cells, &mut voxels);
        if let Some(takes) = takes {
            weigh(&mut voxels, takes);
        }
        match solid {
            Some(solid) => solid.cells().add_even(&voxels, dose),
            None => dose.iter_mut().zip(&voxels).for_each(|(d, v)| *d += v),
        }
    }

    /// The transpose of [`add`](Self::add).
    pub(super) fn collect(&self, light: usize, c: &[f32], solid: Option<&Solid>) -> Vec<f32> {
        let mut voxels = match solid {
            Some(solid) => Cow::Owned(solid.cells().collect_even(c)),
            None => Cow::Borrowed(c),
        };
        if let Some(takes) = &self.takes[light] {
            weigh(voxels.to_mut(), takes);
        }
        let mut cells = self.cells();
        self.coarse.gather(&voxels, &mut cells);
        match &self.sharpen {
            Some(sharpen) => sharpen.of(&cells),
            None => cells,
        }
    }
}

/// voxels *= weights
fn weigh(voxels: &mut [f32], weights: &[f32]) {
    voxels.iter_mut().zip(weights).for_each(|(v, w)| *v *= w);
}

/// What every voxel takes of the fluence of each light, 1/mm; None for a light that meets the same resin everywhere.
fn takes(lights: &[Light], layout: &DoseLayout) -> Vec<Option<Arc<Vec<f32>>>> {
    let of_light = |light: &Light| {
        let plain = light.resin.uptake().active_per_mm;
        let means = light.map.as_ref()?.means(&layout.grid, plain);
        Some(Arc::new(layout.field_of(&means)))
    };
    let mut found: Vec<Option<Arc<Vec<f32>>>> = Vec::with_capacity(lights.len());
    for (i, light) in lights.iter().enumerate() {
        // The lights of a job share one map
        let same = |other: &Light| match (&other.map, &light.map) {
            (Some(a), Some(b)) => Arc::ptr_eq(a, b) && other.resin == light.resin,
            _ => false,
        };
        let shared = lights[..i].iter().position(same);
        found.push(shared.map_or_else(|| of_light(light), |j| found[j].clone()));
    }
    found
}
