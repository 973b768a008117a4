//! Where a material is: its voxels, which of them hold resin, and whether air lies on top.
//!
//! State volumes have the layout of the dose, so that light, state and readout need no copies: rows of lanes along z.

use std::sync::Arc;
use tomolith_core::dose::DoseLayout;
use tomolith_core::error::{Error, Result};
use tomolith_core::field::HostField;
use tomolith_core::grid::{Volume, VolumeGrid};

/// Voxels, walls and air.
#[derive(Clone, Debug)]
pub struct Domain {
    layout: DoseLayout,
    /// 1 where there is resin, 0 elsewhere, padding included; None: everywhere in the box.
    resin: Option<Arc<HostField>>,
    air: bool,
}

impl Domain {
    /// A box of resin between walls that nothing passes.
    #[must_use]
    pub fn new(grid: VolumeGrid) -> Self {
        Domain {
            layout: DoseLayout::new("state", grid, 0),
            resin: None,
            air: false,
        }
    }

    /// Walls: glass and bodies are where `resin` (file order) is false; nothing flows through their faces.
    ///
    /// # Errors
    /// [`Error::Shape`] for another shape.
    pub fn with_walls(mut self, resin: &Volume<bool>) -> Result<Self> {
        if resin.grid.shape != self.layout.grid.shape {
            return Err(Error::shape(
                "voxels of resin",
                self.layout.grid.shape,
                resin.grid.shape,
            ));
        }
        let field: Vec<f32> = self
            .layout
            .field_of(resin)
            .into_iter()
            .map(|r| f32::from(u8::from(r)))
            .collect();
        let all = !resin.values.contains(&false);
        self.resin = (!all).then(|| Arc::new(HostField::from_slice(&field)));
        Ok(self)
    }

    /// Air on top: it keeps inhibitors saturated at the uppermost face.
    #[must_use]
    pub fn with_air_on_top(mut self) -> Self {
        self.air = true;
        self
    }

    /// The layout of every volume of the state.
    #[must_use]
    pub fn layout(&self) -> &DoseLayout {
        &self.layout
    }

    /// The voxels.
    #[must_use]
    pub fn grid(&self) -> &VolumeGrid {
        &self.layout.grid
    }

    /// 1 where there is resin and 0 elsewhere, in the order of the layout; None: resin everywhere.
    #[must_use]
    pub fn resin(&self) -> Option<&[f32]> {
        self.resin.as_ref().map(|r| r.as_slice())
    }

    /// Whether air lies on top.
    #[must_use]
    pub fn has_air(&self) -> bool {
        self.air
    }

    /// A volume of the state, 0.
    #[must_use]
    pub fn zeros(&self) -> HostField {
        HostField::zeros(self.layout.len())
    }

    /// A volume of one value where there is resin.
    #[must_use]
    pub fn even(&self, value: f32) -> HostField {
        self.filled(|_| value)
    }

    /// A volume of a value per height (z in mm), where there is resin.
    pub(crate) fn filled(&self, of_height: impl Fn(f64) -> f32) -> HostField {
        let mut field = self.zeros();
        let nz = self.grid().shape[0];
        let column: Vec<f32> = (0..nz).map(|iz| of_height(self.grid().z(iz))).collect();
        if !column.is_empty() {
            let rows = field.as_mut_slice().chunks_exact_mut(self.layout.row);
            rows.for_each(|row| row[..nz].copy_from_slice(&column));
        }
        self.only_resin(&mut field);
        field
    }

    /// Sets to 0 what is no resin.
    pub(crate) fn only_resin(&self, field: &mut HostField) {
        if let Some(resin) = self.resin() {
            let values = field.as_mut_slice().iter_mut().zip(resin);
            values.for_each(|(v, r)| *v *= r);
        }
    }
}
