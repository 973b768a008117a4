//! The grid round a shape when the job gives only its resolution.

use tomolith_core::error::{Error, Result};
use tomolith_core::grid::VolumeGrid;
use tomolith_core::units::{Mm, concise};

/// Space on each side of the shape, as a share of its extent along that axis.
const MARGIN: f64 = 0.10;

/// Least space on each side, voxels.
const MARGIN_VOXELS: usize = 4;

/// Most voxels along an axis: beyond it indices and memory are certain to fail later, and less clearly.
const MOST_VOXELS: f64 = 65536.0;
/// Largest edge of a voxel: far beyond any vial, and its volume is still a number.
const LARGEST_PITCH_MM: f64 = 1000.0;

/// How fine the grid is.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Resolution {
    /// Edge of a voxel, mm.
    Pitch(f64),
    /// Number of voxels `[x, y, z]`; the pitch is the smallest with which the shape and its margins fit.
    Shape([usize; 3]),
}

/// The box of a shape plus a margin of 10 % of its extent, and at least 4 voxels, on each side.
///
/// The center of the grid is the center of the box. `bounds` is `[low, high]`, each `[x, y, z]`, mm.
///
/// ```
/// use tomolith_target::{Resolution, default_grid};
/// let grid = default_grid([[0.0; 3], [10.0, 10.0, 1.0]], Resolution::Pitch(0.1)).unwrap();
/// assert_eq!(grid.shape, [18, 120, 120]); // z: 10 + 2·4 voxels; x, y: 100 + 2·10 voxels
/// assert_eq!(grid.center_mm, [5.0, 5.0, 0.5]);
/// let grid = default_grid([[0.0; 3], [10.0, 10.0, 1.0]], Resolution::Shape([60, 60, 60])).unwrap();
/// assert!((grid.pitch_mm - 0.2).abs() < 1e-12); // 12 mm with margins, 60 voxels
/// ```
///
/// # Errors
/// [`Error::Config`] (keys `pitch_mm` and `shape`; put `grid` before with [`Error::under`]) when the pitch is not a
/// positive number or too small, or there are too few voxels for the margins.
pub fn default_grid(bounds: [[f64; 3]; 2], resolution: Resolution) -> Result<VolumeGrid> {
    let extent: [f64; 3] = std::array::from_fn(|i| bounds[1][i] - bounds[0][i]);
    let center_mm = std::array::from_fn(|i| (bounds[0][i] + bounds[1][i]) / 2.0);
    let least = 2 * MARGIN_VOXELS;
    let ([x, y, z], pitch_mm) = match resolution {
        Resolution::Pitch(pitch_mm) => {
            if !(pitch_mm > 0.0 && pitch_mm <= LARGEST_PITCH_MM) {
                return Err(Error::config(
                    "pitch_mm",
                    Mm(pitch_mm).to_string(),
                    format!("a length > 0, at most {}", Mm(LARGEST_PITCH_MM)),
                ));
            }
            // A count that is a whole number up to rounding stays that number
            let count = |e: f64| {
                let margin = (MARGIN * e).max(MARGIN_VOXELS as f64 * pitch_mm);
                ((e + 2.0 * margin) / pitch_mm - 1e-9).ceil()
            };
            let [x, y, z] = extent.map(count);
            if ![x, y, z].iter().all(|n| *n <= MOST_VOXELS) {
                return Err(Error::config(
                    "pitch_mm",
                    format!(
                        "{} makes a grid of {} × {} × {} voxels",
                        Mm(pitch_mm),
                        concise(x),
                        concise(y),
                        concise(z)
                    ),
                    format!("a pitch that needs at most {MOST_VOXELS} voxels along an axis"),
                ));
            }
            ([x, y, z].map(|n| n as usize), pitch_mm)
        }
        Resolution::Shape(shape) => {
            if shape.iter().any(|&n| n <= least || n as f64 > MOST_VOXELS) {
                return Err(Error::config(
                    "shape",
                    format!("{shape:?}"),
                    format!("[x, y, z], each from {} to {MOST_VOXELS}", least + 1),
                ));
            }
            let pitch_mm = (0..3)
                .map(|i| {
                    let n = shape[i] as f64;
                    ((1.0 + 2.0 * MARGIN) * extent[i] / n).max(extent[i] / (n - least as f64))
                })
                .fold(0.0, f64::max);
            (shape, pitch_mm)
        }
    };
    Ok(VolumeGrid::centered([z, y, x], pitch_mm).about(center_mm))
}

/// Volume of a shape on so many voxels along its longest edge and more, mm³.
#[cfg(test)]
pub(crate) fn sampled_volume(shape: &dyn crate::Shape, longest: usize) -> f64 {
    let grid = default_grid(shape.bounds_mm(), Resolution::Shape([longest; 3])).unwrap();
    let values = shape.sample(&grid).unwrap().values;
    assert!(values.iter().all(|v| (0.0..=1.0).contains(v)));
    values.iter().map(|&v| f64::from(v)).sum::<f64>() * grid.voxel_mm3()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_shape_and_four_voxels_fit_on_every_side() {
        let bounds = [[-1.0, 2.0, 0.0], [3.7, 2.2, 1.9]];
        for resolution in [
            Resolution::Pitch(0.07),
            Resolution::Pitch(0.5),
            Resolution::Shape([40, 60, 30]),
            Resolution::Shape([400, 12, 30]),
        ] {
            let grid = default_grid(bounds, resolution).unwrap();
            let [low, high] = grid.bounds_mm();
            for i in 0..3 {
                let extent = bounds[1][i] - bounds[0][i];
                let margin = (MARGIN * extent).max(4.0 * grid.pitch_mm) - 1e-9;
                assert!(bounds[0][i] - low[i] >= margin && high[i] - bounds[1][i] >= margin);
            }
        }
    }

    #[test]
    fn impossible_resolutions_are_refused() {
        let bounds = [[0.0; 3], [1.0; 3]];
        for (resolution, key) in [
            (Resolution::Pitch(0.0), "pitch_mm"),
            (Resolution::Pitch(f64::NAN), "pitch_mm"),
            (Resolution::Pitch(1e-9), "pitch_mm"),
            (Resolution::Shape([8, 100, 100]), "shape"),
            (Resolution::Shape([100, 100, 1 << 20]), "shape"),
        ] {
            let text = default_grid(bounds, resolution).unwrap_err().to_string();
            assert!(text.starts_with(key), "{text}");
        }
    }
}
