//! A light: its pixels, when they shine, and what the resin does at its wavelength. Every dose model takes such lights; what only one of them needs
//! (a kernel, rays per pixel) is a parameter of that model.
//!
//! ```
//! use tomolith_core::grid::PatternGrid;
//! use tomolith_optics::{light::Light, resin::Resin};
//! // 8 frames of 12 × 20 pixels of 0.1 mm
//! let light = Light::new(PatternGrid::full_turn(8, 0.1, 12, 20, 0.1), Resin::absorbing(1.48, 0.2));
//! assert_eq!(light.layout(0).len(), 8 * 12 * 20); // all pixels active
//! ```

use crate::absorption_map::AbsorptionMap;
use crate::interface::Polarization;
use crate::point_spread::PointSpread;
use crate::resin::Resin;
use crate::trace::{Bath, Tracer};
use crate::vial::Vial;
use std::sync::Arc;
use tomolith_core::dose::{PatternLayout, Quantity};
use tomolith_core::error::{Error, Result, in_range};
use tomolith_core::grid::{PatternGrid, PixelMask, Volume, VolumeGrid};

/// One light: its pixels and what the resin does at its wavelength.
#[derive(Clone, Debug)]
pub struct Light {
    /// Frames, rows, columns.
    pub pixels: PatternGrid,
    /// The resin at this wavelength.
    pub resin: Resin,
    /// Vacuum wavelength, nm: what waves diffract by.
    pub wavelength_nm: f64,
    /// Index of what surrounds the vial.
    pub surrounding_index: f64,
    /// Absorption that changes across the plane; None: the resin's plain numbers everywhere.
    pub map: Option<Arc<AbsorptionMap>>,
    /// What weakens light before the vial.
    pub bath: Option<Bath>,
    /// How the projector spreads the light of a pixel over its neighbors; None: each keeps its own.
    pub point_spread: Option<Arc<PointSpread>>,
    /// Polarization at the projector.
    pub polarization: Polarization,
    /// Positions within a frame's arc that are averaged; 1: the vial stands still during a frame.
    pub sub_angles: usize,
    /// Rows that may be lit, per (frame, column): `(bottom, count)` counted from the lowest row. None: all.
    pub active: Option<Vec<(u32, u32)>>,
    /// Which pixels a planner makes unknowns; it sets `active`.
    pub selection: Selection,
}

impl Light {
    /// Unpolarized light of 405 nm in air, standing still, all pixels active.
    #[must_use]
    pub fn new(pixels: PatternGrid, resin: Resin) -> Self {
        Light {
            pixels,
            resin,
            wavelength_nm: 405.0,
            surrounding_index: 1.0,
            map: None,
            bath: None,
            point_spread: None,
            polarization: Polarization::Unpolarized,
            sub_angles: 1,
            active: None,
            selection: Selection::default(),
        }
    }

    /// Absorption of the active species at the middle of each voxel, 1/mm, where it is a map; None where it is the same everywhere.
    #[must_use]
    pub fn absorption_on(&self, grid: &VolumeGrid) -> Option<Volume<f32>> {
        let map = self.map.as_ref()?;
        let plain = self.resin.uptake();
        let absorption = |middle| map.uptake(middle, plain).active_per_mm as f32;
        Some(Volume::from_fn(grid.clone(), absorption))
    }

    /// Traces its level rays through a vial and its bath, with the resin's plain numbers.
    #[must_use]
    pub fn tracer(&self, vial: &dyn Vial) -> Tracer {
        Tracer::new(vial, self.resin, self.surrounding_index, self.polarization).in_bath(self.bath)
    }

    /// Refuses a light without pixels, or a resin in which nothing absorbs.
    ///
    /// # Errors
    /// [`Error::Config`].
    pub fn check(&self) -> Result<()> {
        if self.pixels.is_empty() {
            return Err(Error::config(
                "light",
                format!("{:?} frames, rows, columns", self.pixels.shape()),
                "at least one pixel",
            ));
        }
        let resin = &self.resin;
        let absorbs = resin.absorption_per_mm > 0.0 && resin.absorption_per_mm.is_finite();
        in_range(
            resin.pure_radon || absorbs,
            "resin.absorption_per_mm",
            resin.absorption_per_mm,
            "a finite number > 0 (or `pure_radon = true`)",
        )?;
        Ok(())
    }

    /// Where its active pixels lie in a field, from `offset` on.
    #[must_use]
    pub fn layout(&self, offset: usize) -> PatternLayout {
        let all = vec![(0, self.pixels.rows as u32); self.pixels.frames() * self.pixels.columns];
        let active = self.active.as_deref().unwrap_or(&all);
        PatternLayout::new(self.pixels.clone(), Quantity::Energy, offset, active)
    }
}

/// Which pixels of a light may be unknowns.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Selection {
    /// A pixel may be lit where all of them allow it.
    pub masks: Vec<Arc<PixelMask>>,
    /// Share of the best pixel's light that a pixel must bring to the part, 0 to below 1.
    pub min_contribution: f64,
    /// Whether the projector's background also lights pixels whose light misses the part.
    pub has_background: bool,
}

impl Selection {
    /// Whether it leaves anything dark.
    #[must_use]
    pub fn is_any(&self) -> bool {
        !self.masks.is_empty() || self.min_contribution > 0.0
    }

    /// Whether a pixel `[frame, row, column]` may be lit.
    #[must_use]
    pub fn allows(&self, at: [usize; 3]) -> bool {
        self.masks.iter().all(|mask| mask.allows(at))
    }

    /// Lowest and highest corner [u, z] of what may be lit in all frames alike, mm.
    #[must_use]
    pub fn field_mm(&self, pixels: &PatternGrid) -> [[f64; 2]; 2] {
        let whole = pixels.field_mm();
        let still = self.masks.iter().filter(|mask| mask.is_still());
        let fields = still.map(|mask| mask.field_mm(pixels));
        fields.fold(whole, |[low, high], field| {
            [
                std::array::from_fn(|i| low[i].max(field[0][i])),
                std::array::from_fn(|i| high[i].min(field[1][i])),
            ]
        })
    }

    /// The selection with every mask changed.
    #[must_use]
    pub fn mapped(&self, change: impl Fn(&PixelMask) -> PixelMask) -> Self {
        Selection {
            masks: self.masks.iter().map(|m| Arc::new(change(m))).collect(),
            ..self.clone()
        }
    }
}
