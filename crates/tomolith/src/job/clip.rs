//! Whether the grid of a job holds the part, and how much it cuts off where the job allows that.

use super::spec::GridSpec;
use crate::error::{Error, Result};
use crate::grid::VolumeGrid;
use crate::target::{Resolution, Shape, default_grid};
use crate::units::concise;

/// Share of the part's volume that a grid may cut off without being refused: what rounding to voxels cuts.
const STRAY: f64 = 1e-3;
/// Parts of a voxel that are rounding of the job's lengths.
const ROUNDING: f64 = 1e-6;
/// Voxels along the longest edge of the part, on which the volume is measured.
const ACROSS: f64 = 96.0;

/// Refuses a grid that cuts the part, unless the job asks for it; says how much is cut off.
///
/// # Errors
/// [`Error::Config`] at `grid.shape` with both sizes.
pub(super) fn must_hold(
    spec: &GridSpec,
    grid: &VolumeGrid,
    shape: &dyn Shape,
) -> Result<Option<String>> {
    let Some(counts) = spec.shape else {
        return Ok(None);
    };
    let (part, own) = (shape.bounds_mm(), grid.bounds_mm());
    let slack = ROUNDING * grid.pitch_mm;
    let holds = (0..3).all(|i| own[0][i] <= part[0][i] + slack && own[1][i] >= part[1][i] - slack);
    if holds {
        return Ok(None);
    }
    let cut_off = 1.0 - share_within(own, shape)?;
    let percent = concise(format!("{:.2}", 100.0 * cut_off).parse().unwrap_or(0.0));
    if spec.clip || cut_off <= STRAY {
        return Ok(Some(format!(
            "the grid cuts off {percent} % of the part's volume: patterns, numbers and print are those of the rest; \
             use more voxels in grid.shape or a larger grid.pitch_mm"
        )));
    }
    let times = |sizes: [String; 3]| sizes.join(" × ");
    let sizes = |of: [[f64; 3]; 2]| times([0, 1, 2].map(|i| concise(of[1][i] - of[0][i])));
    let needed = [0, 1, 2].map(|i| {
        let middle = grid.center_mm[i];
        let reach = (part[1][i] - middle).max(middle - part[0][i]);
        (2.0 * reach / grid.pitch_mm - ROUNDING).ceil() as usize
    });
    let needed = [0, 1, 2].map(|i| needed[i].max(counts[i]));
    Err(Error::config(
        "grid.shape",
        format!(
            "{} voxels of {} mm are {} mm, but the part is {} mm: {percent} % of its volume would be cut off",
            times(counts.map(|n| n.to_string())),
            concise(grid.pitch_mm),
            sizes(own),
            sizes(part),
        ),
        format!(
            "at least {needed:?} voxels, a larger grid.pitch_mm, or grid.clip = true to print what is left"
        ),
    ))
}

/// Share of the part's volume in a box (mm).
fn share_within(bounds: [[f64; 3]; 2], shape: &dyn Shape) -> Result<f64> {
    let part = shape.bounds_mm();
    let longest = (0..3).map(|i| part[1][i] - part[0][i]).fold(0.0, f64::max);
    let grid = default_grid(part, Resolution::Pitch(longest / ACROSS))?;
    let values = shape.sample(&grid)?.values;
    // Share of voxel i along an axis that lies in the box
    let within = |axis: usize, middle: f64| {
        let half = grid.pitch_mm / 2.0;
        let low = (middle - half).max(bounds[0][axis]);
        let high = (middle + half).min(bounds[1][axis]);
        ((high - low) / grid.pitch_mm).max(0.0)
    };
    let [_, ny, nx] = grid.shape;
    let (mut all, mut kept) = (0.0, 0.0);
    for (i, &value) in values.iter().enumerate().filter(|(_, value)| **value > 0.0) {
        let value = f64::from(value);
        let middle = [grid.x(i % nx), grid.y(i / nx % ny), grid.z(i / (nx * ny))];
        all += value;
        kept += value
            * (0..3)
                .map(|axis| within(axis, middle[axis]))
                .product::<f64>();
    }
    Ok(if all > 0.0 { kept / all } else { 1.0 })
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::kind::Section;
    use std::path::Path;

    /// A cylinder of 2 mm across and 2 mm high about the origin.
    fn cylinder() -> Box<dyn Shape> {
        let target =
            serde_json::json!({ "phantom": { "cylinder": { "size_mm": 2.0, "height_mm": 2.0 } } });
        let spec: crate::target::TargetSpec = Section::new("target", target).parse().unwrap();
        crate::target::build(&spec, Path::new(""), "target").unwrap()
    }

    fn found(counts: [usize; 3], clip: bool) -> Result<Option<String>> {
        let spec = GridSpec {
            shape: Some(counts),
            clip,
            ..GridSpec::default()
        };
        let [x, y, z] = counts;
        must_hold(
            &spec,
            &VolumeGrid::centered([z, y, x], 0.1),
            cylinder().as_ref(),
        )
    }

    #[test]
    fn a_grid_that_cuts_the_part_is_refused_with_the_numbers_unless_it_may() {
        assert_eq!(found([20, 20, 20], false).unwrap(), None);
        let message = found([20, 20, 10], false).unwrap_err().to_string();
        for part in [
            "grid.shape: 20 × 20 × 10 voxels of 0.1 mm are 2 × 2 × 1 mm, but the part is 2 × 2 × 2 mm",
            " % of its volume would be cut off",
            "at least [20, 20, 20] voxels",
            "grid.clip = true",
        ] {
            assert!(message.contains(part), "{part} is not in {message}");
        }
        let percent = |counts| -> f64 {
            let warning = found(counts, true).unwrap().unwrap();
            let text = warning.strip_prefix("the grid cuts off ").unwrap();
            text.split(' ').next().unwrap().parse().unwrap()
        };
        // The upper and lower quarter of it
        let half = percent([20, 20, 10]);
        assert!((half - 50.0).abs() < 0.6, "{half}");
        // A square of 1.4 mm lies in the circle of 2 mm: π − 1.96 mm² of it are cut off
        let expected = 100.0 * (1.0 - 1.96 / std::f64::consts::PI);
        let corners = percent([14, 14, 20]);
        assert!((corners - expected).abs() < 0.6, "{corners} {expected}");
    }
}
