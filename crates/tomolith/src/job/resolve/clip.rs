//! Whether the grid of a job holds the part, and how much it cuts off where the job allows that.

use crate::error::{Error, Result};
use crate::grid::VolumeGrid;
use crate::job::spec::GridSpec;
use crate::models::Work;
use crate::target::Shape;
use crate::target::clip::{ROUNDING, cut_off};
use crate::units::concise;

/// Share of the part's volume that a grid may cut off without being refused: what rounding to voxels cuts.
const STRAY: f64 = 1e-3;

/// Refuses a grid that cuts the part, unless the job asks for it; says how much is cut off.
pub(crate) fn must_hold(
    spec: &GridSpec,
    grid: &VolumeGrid,
    shape: &dyn Shape,
    work: &Work,
) -> Result<Option<String>> {
    let Some(counts) = spec.shape else {
        return Ok(None);
    };
    let Some(cut_off) = cut_off(grid, shape, work)? else {
        return Ok(None);
    };
    let percent = concise(format!("{:.2}", 100.0 * cut_off).parse().unwrap_or(0.0));
    if spec.clip || cut_off <= STRAY {
        return Ok(Some(format!(
            "the grid cuts off {percent} % of the part's volume: patterns, numbers and print are those of the rest; \
             use more voxels in grid.shape or a larger grid.pitch_mm"
        )));
    }
    let (part, bounds) = (shape.bounds_mm(), grid.bounds_mm());
    let times = |sizes: [String; 3]| sizes.join(" × ");
    let sizes =
        |corners: [[f64; 3]; 2]| times([0, 1, 2].map(|i| concise(corners[1][i] - corners[0][i])));
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
            sizes(bounds),
            sizes(part),
        ),
        format!(
            "at least {needed:?} voxels, a larger grid.pitch_mm, or grid.clip = true to print what is left"
        ),
    ))
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::job::resolve::optics::tests::shape;

    /// A cylinder of 2 mm across and 2 mm high about the origin.
    fn cylinder() -> Box<dyn Shape> {
        let size = serde_json::json!({ "size_mm": 2.0, "height_mm": 2.0 });
        shape(serde_json::json!({ "phantom": { "cylinder": size } }))
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
            &Work::new(),
        )
    }

    #[test]
    fn a_grid_that_cuts_the_part_is_refused_with_the_numbers_unless_it_may() {
        assert_eq!(found([20, 20, 20], false).unwrap(), None);
        let message = found([20, 20, 10], false).unwrap_err().to_string();
        tomolith_core::contains!(
            message,
            "grid.shape: 20 × 20 × 10 voxels of 0.1 mm are 2 × 2 × 1 mm, but the part is 2 × 2 × 2 mm",
            " % of its volume would be cut off",
            "at least [20, 20, 20] voxels",
            "grid.clip = true"
        );
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
