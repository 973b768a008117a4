//! Voxel error rate.
//!
//! ```text
//! VER = #{void: m > min over part m} / (#part + #void)
//! ```
//!
//! (Other authors count m ≥ min.) None without part.

use super::print::Print;
use super::{Better, Measure, Metric, MetricKind};

/// See the [module page](self).
pub struct Ver;

impl Metric for Ver {
    fn measure(&self, print: &Print<'_>) -> Measure {
        let scan = print.scan();
        let smallest = scan.part()?.min;
        let [part, void] = scan.totals();
        let wrong = scan.count_above(f64::from(smallest))[1];
        Some(wrong as f64 / (part + void) as f64)
    }
}

/// Row of [`METRICS`](super::METRICS).
pub const KIND: MetricKind = MetricKind {
    name: "ver",
    title: "Voxel error rate",
    summary: "Share of the voxels that gel wrongly once the last voxel of the part has gelled.",
    unit: "",
    better: Better::Lower,
    metric: &Ver,
};

#[cfg(test)]
mod tests {
    use super::*;
    use crate::grid::{Volume, VolumeGrid};
    use crate::target::label::{OUTSIDE, PART, VOID};

    fn measure(labels: &[u8], response: &[f32]) -> Measure {
        let grid = VolumeGrid::centered([1, 1, labels.len()], 0.5);
        let labels = Volume {
            grid: grid.clone(),
            values: labels.to_vec(),
        };
        let response = Volume {
            grid,
            values: response.to_vec(),
        };
        Ver.measure(&Print::new(&labels, &response).unwrap())
    }

    fn near(found: Measure, expected: f64) -> bool {
        found.is_some_and(|found| (found - expected).abs() < 1e-6)
    }

    #[test]
    fn counts_void_above_the_weakest_part_voxel() {
        let labels = [PART, PART, VOID, VOID, VOID, OUTSIDE];
        // 0.5 is the weakest; 0.6 is wrong, an equal 0.5 is not
        assert!(near(measure(&labels, &[0.5, 0.9, 0.6, 0.5, 0.1, 0.9]), 0.2));
        assert_eq!(measure(&[PART], &[1.0]), Some(0.0));
        assert_eq!(measure(&[VOID], &[1.0]), None);
    }
}
