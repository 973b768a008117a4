//! What a grid cuts off a shape.

use crate::{Resolution, Shape, default_grid};
use tomolith_core::error::Result;
use tomolith_core::grid::VolumeGrid;
use tomolith_core::work::Work;

/// Parts of a voxel that are rounding of lengths.
pub const ROUNDING: f64 = 1e-6;

/// Voxels along the longest edge of the shape, on which its volume is measured.
const ACROSS: f64 = 96.0;

/// Whether some of a box `[low, high]` (mm) lies outside a grid.
#[must_use]
pub fn cuts(grid: &VolumeGrid, [low, high]: [[f64; 3]; 2]) -> bool {
    let [first, last] = grid.bounds_mm();
    let slack = ROUNDING * grid.pitch_mm;
    !(0..3).all(|i| first[i] <= low[i] + slack && last[i] >= high[i] - slack)
}

/// Share of the shape's volume outside a grid, measured on 96 voxels along its longest edge; None where the grid holds its box.
///
/// ```
/// use tomolith_core::{grid::VolumeGrid, work::Work};
/// use tomolith_target::{TargetSpec, build, clip::cut_off};
/// let spec: TargetSpec = toml::from_str("phantom = \"sphere\"\nsize_mm = 2.0").unwrap();
/// let shape = build(&spec, std::path::Path::new("."), "target").unwrap();
/// let share = |nz| cut_off(&VolumeGrid::centered([nz, 20, 20], 0.1), &*shape, &Work::new()).unwrap();
/// assert_eq!(share(20), None);
/// // Two caps of 0.5 mm: 2·π·0.25·(1 − 0.5/3) of 4/3·π
/// assert!((share(10).unwrap() - 0.3125).abs() < 1e-3);
/// ```
///
/// # Errors
/// As [`Shape::sample_under`].
pub fn cut_off(grid: &VolumeGrid, shape: &dyn Shape, work: &Work) -> Result<Option<f64>> {
    let part = shape.bounds_mm();
    if !cuts(grid, part) {
        return Ok(None);
    }
    let bounds = grid.bounds_mm();
    let longest = (0..3).map(|i| part[1][i] - part[0][i]).fold(0.0, f64::max);
    let fine = default_grid(part, Resolution::Pitch(longest / ACROSS))?;
    let values = shape.sample_under(&fine, &work.aside())?.values;
    // Share of a voxel along an axis that lies in the grid
    let within = |axis: usize, middle: f64| {
        let half = fine.pitch_mm / 2.0;
        let low = (middle - half).max(bounds[0][axis]);
        let high = (middle + half).min(bounds[1][axis]);
        ((high - low) / fine.pitch_mm).max(0.0)
    };
    let (mut all, mut inside) = (0.0, 0.0);
    for (i, &value) in values.iter().enumerate().filter(|(_, value)| **value > 0.0) {
        let value = f64::from(value);
        let middle = fine.middle(i);
        all += value;
        inside += value
            * (0..3)
                .map(|axis| within(axis, middle[axis]))
                .product::<f64>();
    }
    let lost = if all > 0.0 { 1.0 - inside / all } else { 0.0 };
    Ok(Some(lost.max(0.0)))
}
