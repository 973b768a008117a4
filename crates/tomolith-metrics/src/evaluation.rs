//! All numbers of a print, and the curves of the report.

use super::error_histogram::ErrorHistogram;
use super::latitude::{Latitude, latitude};
use super::print::Print;
use super::spread::Spread;
use super::surface::Farthest;
use super::{METRICS, Measure};
use serde::ser::{Serialize, SerializeMap, Serializer};
use tomolith_core::grid::VolumeGrid;
use tomolith_core::units::concise;

/// Points of the IoU curve.
const CURVE: usize = 401;
/// Bins of the dose histogram.
const BINS: usize = 120;

/// The numbers of [`METRICS`], in its order. Serializes to a map; what is not defined becomes null.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Measures(pub Vec<(&'static str, Measure)>);

impl Measures {
    /// A number by its name.
    #[must_use]
    pub fn get(&self, name: &str) -> Measure {
        self.0
            .iter()
            .find(|(n, _)| *n == name)
            .and_then(|(_, m)| *m)
    }
}

impl Serialize for Measures {
    fn serialize<S: Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
        let mut map = serializer.serialize_map(Some(self.0.len()))?;
        for (name, value) in &self.0 {
            map.serialize_entry(name, value)?;
        }
        map.end()
    }
}

/// Voxels of part and void over the response.
#[derive(Clone, Debug, PartialEq)]
pub struct Histogram {
    /// Lower end of the first and upper end of the last bin.
    pub range: [f64; 2],
    /// Part and void voxels per bin, all of equal width.
    pub counts: Vec<[u64; 2]>,
}

/// What is known of a print.
#[derive(Clone, Debug, PartialEq)]
pub struct Evaluation {
    /// The numbers.
    pub measures: Measures,
    /// The gel threshold that they belong to.
    pub gel_threshold: Measure,
    /// Over which exposures the print stays nearly as good as at the best one.
    pub latitude: Option<Latitude>,
    /// Where the print's surface and the target's are farthest apart.
    pub farthest: Option<Farthest>,
    /// Half width of the band round the gray values, for a gray target.
    pub half_width: Measure,
    /// Voxels over the error of their response, for a gray target.
    pub errors: Option<ErrorHistogram>,
    /// Pairs of a threshold and the exact IoU there, ascending.
    pub curve: Vec<[f64; 2]>,
    /// Voxels of part and void over the response.
    pub histogram: Histogram,
    /// Response of the part voxels.
    pub part: Option<Spread>,
    /// Response of the void voxels.
    pub void: Option<Spread>,
    /// Where it was measured.
    pub grid: VolumeGrid,
    /// Positions of the vial within one frame's arc that were averaged; 1: standing still.
    pub sub_angles: usize,
    /// What people should know about the numbers, one sentence each.
    pub notes: Vec<String>,
}

impl Evaluation {
    /// Says over how many positions of the vial within a frame the dose was averaged.
    #[must_use]
    pub fn with_sub_angles(mut self, sub_angles: usize) -> Self {
        self.sub_angles = sub_angles;
        self
    }
}

/// Measures everything.
#[must_use]
pub fn evaluate(print: &Print<'_>) -> Evaluation {
    let measures = METRICS
        .iter()
        .map(|kind| (kind.name, (kind.measure)(print).filter(|m| m.is_finite())))
        .collect();
    let scan = print.scan();
    let (part, void) = (scan.part(), scan.void());
    let spreads = || part.iter().chain(&void);
    let low = spreads().map(|s| f64::from(s.min)).fold(0.0, f64::min);
    let high = spreads().map(|s| f64::from(s.max)).fold(low, f64::max);
    // Something to draw even when all is dark
    let range = [low, if high > low { high } else { low + 1.0 }];
    Evaluation {
        measures: Measures(measures),
        gel_threshold: print.gel_threshold(),
        latitude: latitude(print),
        farthest: print.distance().map(|distance| distance.farthest),
        half_width: print.half_width(),
        errors: print.error_histogram(),
        curve: scan.curve(CURVE),
        histogram: Histogram {
            range,
            counts: scan.histogram(range, BINS),
        },
        part,
        void,
        grid: print.grid().clone(),
        sub_angles: 1,
        notes: notes(print),
    }
}

fn notes(print: &Print<'_>) -> Vec<String> {
    let mut notes = Vec::new();
    let scan = print.scan();
    if scan.part().is_none() {
        notes.push("No voxel belongs to the part, so most numbers are not defined.".to_owned());
    } else if print.gel_threshold().is_none() {
        notes.push("No threshold prints any of the part.".to_owned());
    }
    if let Some(distance) = print.distance()
        && distance.coarsened > 1
    {
        notes.push(format!(
            "Surface distances were measured on voxels {} times as large, of {} mm.",
            distance.coarsened,
            concise(print.grid().pitch_mm * distance.coarsened as f64)
        ));
    }
    notes
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::print::samples::row;
    use tomolith_core::grid::Volume;
    use tomolith_core::target::label::{OUTSIDE, PART, VOID};

    #[test]
    fn two_slices_that_differ_are_both_counted() {
        // Upper slice right, lower slice wrong: numbers are of the whole volume, not of either slice
        let grid = VolumeGrid::centered([2, 1, 4], 0.1);
        let labels = vec![VOID, PART, PART, VOID, VOID, PART, PART, VOID];
        let response = vec![0.1, 0.9, 0.9, 0.1, 0.8, 0.2, 0.9, 0.1];
        let labels = Volume::new(grid.clone(), labels);
        let response = Volume::new(grid, response);
        let evaluation = evaluate(&Print::new(&labels, &response).unwrap());
        let get = |name| evaluation.measures.get(name).unwrap();
        // t in [0.1, 0.2): 4 of 4 + 1
        assert!((get("iou") - 0.8).abs() < 1e-12);
        assert!((get("pw") + 0.6).abs() < 1e-6);
        assert!((get("ver") - 0.125).abs() < 1e-12);
        assert!((get("over_mm3") - 1e-3).abs() < 1e-12);
        assert_eq!(get("under_mm3"), 0.0);
        let counts = evaluation.histogram.counts.iter().flatten();
        assert_eq!(counts.sum::<u64>(), 8);
    }

    #[test]
    fn nothing_defined_becomes_null_and_nothing_becomes_infinite() {
        for (labels, response) in [
            (vec![], vec![]),
            (vec![OUTSIDE; 2], vec![f32::NAN; 2]),
            (vec![VOID; 2], vec![0.0; 2]),
            (vec![PART; 2], vec![0.0; 2]),
            (vec![PART; 2], vec![1e30, 1e38]),
            (vec![PART, VOID], vec![-1e38, 1e38]),
        ] {
            let (labels, response) = (row(&labels), row(&response));
            let evaluation = evaluate(&Print::new(&labels, &response).unwrap());
            let json = serde_json::to_value(&evaluation.measures).unwrap();
            assert_eq!(json.as_object().unwrap().len(), METRICS.len());
            for (name, value) in json.as_object().unwrap() {
                assert!(
                    value.is_null() || value.as_f64().unwrap().is_finite(),
                    "{name}: {value}"
                );
            }
        }
    }

    #[test]
    fn the_table_has_the_names_of_the_report() {
        let names: Vec<&str> = METRICS.iter().map(|m| m.name).collect();
        let surfaces = "surface_mean_mm surface_p95_mm hausdorff_mm";
        let gray = "in_band rms_error max_error_part max_error_void";
        let others = "iou best_threshold ver pw ipdr gamma eta print_time_mm cv over_mm3 under_mm3";
        let listed = format!("{others} {surfaces} {gray}");
        assert_eq!(names.join(" "), listed, "a new metric is listed here, too");
    }
}
