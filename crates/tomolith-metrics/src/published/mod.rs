//! Numbers of the dose as the publications define them, so that they can be compared with theirs.
//!
//! [`METRICS`](super::METRICS) are of the response; these are of the dose, each with its source. They work on anybody's arrays: a dose,
//! a target and labels ([`label`](tomolith_core::target::label)) of the same voxels.
//!
//! | name | definition | source |
//! |---|---|---|
//! | `pw` | min in − max out | AID eq. 10 |
//! | `pw_trimmed` | as `pw` of percentiles: α in the part, 100 − α outside | AID 2.1, last paragraph |
//! | `ipdr` | max in − min in | AID eq. 11; VAMToolbox `calcIPDR` |
//! | `ipdr_trimmed` | of percentiles 100 − α and α | AID 2.1 |
//! | `ver` | #{out > min in}/(in + out) | Rackson 2021; AID eq. 12 |
//! | `ver_trimmed` | min in replaced by its percentile α | AID 2.1 |
//! | `threshold_jaccard`, `jaccard` | threshold of the largest Jaccard index, and that index | Bhattacharya 2021, BCLP S.8 |
//! | `bclp_*` | norms of the band error for p → 0, 1, 2, ∞ (`norms.rs`) | BCLP S.8 |
//! | `light_*` | where the light goes ([`budget`]) | – |
//!
//! AID: Pellizzon et al., arXiv 2602.12178. BCLP: Li et al., Additive Manufacturing 94 (2024) 104447. Nicolet et al.,
//! ACM TOG 43 (2024). Rackson et al., Additive Manufacturing 48 (2021) 102367.
//!
//! PW, IPDR, VER and thresholds are of the *dose*, as published; the band error is of the *response*. Percentiles are
//! those of linear interpolation between order statistics. What is not defined (no part, no void, a dark dose) has no
//! value.
//!
//! ```
//! use tomolith_core::grid::{Volume, VolumeGrid};
//! use tomolith_metrics::print::Print;
//! use tomolith_metrics::published::{Options, of_print, value_of};
//! use tomolith_core::target::label::{PART, VOID};
//! let grid = VolumeGrid::centered([1, 1, 4], 0.1);
//! let volume = |values: &[f32]| Volume { grid: grid.clone(), values: values.to_vec() };
//! let (dose, target) = (volume(&[0.2, 0.8, 0.9, 0.4]), volume(&[0.0, 1.0, 1.0, 0.0]));
//! let labels = Volume { grid: grid.clone(), values: vec![VOID, PART, PART, VOID] };
//! let print = Print::new(&labels, &dose).unwrap();
//! let (numbers, _) = of_print(&print, &target, &Options::default()).unwrap();
//! let near = |name: &str, expected: f64| (value_of(&numbers, name).unwrap() - expected).abs() < 1e-6;
//! assert!(near("pw", 0.4) && near("ipdr", 0.1)); // 0.8 − 0.4, 0.9 − 0.8
//! ```

pub mod budget;
mod norms;
mod order;
pub mod slices;
pub mod unit_systems;

pub use order::percentiles;

use super::Measure;
use super::print::Print;
use super::scan::Scan;
use norms::TargetBand;
use serde::Serialize;
use slices::Slice;
use tomolith_core::error::{Error, Result, in_range};
use tomolith_core::grid::{Patterns, Volume};
use tomolith_core::response::{Identity, Response};

/// A number as it was published.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct Published {
    /// Its name, the same in every run.
    pub name: String,
    /// Who defined it so, with the equation.
    pub source: &'static str,
    /// The number; none where it is not defined.
    pub value: Measure,
    /// Its unit, empty for a plain number.
    pub unit: &'static str,
    /// Its definition in words.
    pub note: String,
}

/// The number of a name.
#[must_use]
pub fn value_of(numbers: &[Published], name: &str) -> Measure {
    numbers.iter().find(|n| n.name == name)?.value
}

/// What published numbers need besides the arrays.
#[derive(Clone, Copy, Debug)]
pub struct Options<'a> {
    /// M of the one equation, for the band error.
    pub response: &'a dyn Response,
    /// Whether the target's values are gray and to be reproduced; else part is 1 and void is 0.
    pub gray: bool,
    /// ε of the band error, in units of the response, 0 or above.
    pub epsilon: f64,
    /// α of trimmed numbers: per cent taken from each end of each region, 0 to below 50.
    pub trim_percent: f64,
    /// The patterns that made the dose, one entry per light; empty when they are not known.
    pub patterns: &'a [Patterns],
    /// Whether the dose is the absorbed light of these patterns, and no fluence or weighted sum.
    pub is_absorbed: bool,
}

/// As in the publications: ε = 0.05 (BCLP) and α = 0.025 % (AID, figure 14); the response is the dose.
impl Default for Options<'_> {
    fn default() -> Self {
        Options {
            response: &Identity,
            gray: false,
            epsilon: 0.05,
            trim_percent: 0.025,
            patterns: &[],
            is_absorbed: true,
        }
    }
}

impl Options<'_> {
    fn validate(&self) -> Result<()> {
        let (epsilon, trim) = (self.epsilon, self.trim_percent);
        let is_in = epsilon.is_finite() && epsilon >= 0.0;
        in_range(is_in, "epsilon", epsilon, "a finite number, 0 or above")?;
        let is_in = (0.0..50.0).contains(&trim);
        in_range(is_in, "trim_percent", trim, "per cent, 0 to below 50")
    }
}

/// Every published number of a print whose response is the dose, with the numbers of every slice that some of them are made of
/// ([`slices`]). The target is of the same voxels; what the metrics count of the print is counted once.
///
/// # Errors
/// [`Error::Shape`] when it is not; [`Error::Config`] for options out of range; [`Error::Canceled`].
pub fn of_print(
    print: &Print<'_>,
    target: &Volume<f32>,
    options: &Options<'_>,
) -> Result<(Vec<Published>, Vec<Slice>)> {
    options.validate()?;
    let (dose, labels, scan) = (print.response(), print.labels(), print.scan());
    if target.grid.shape != dose.grid.shape || target.values.len() != dose.values.len() {
        return Err(Error::shape("target", dose.grid.shape, target.grid.shape));
    }
    let work = &print.work;
    // One pass for all numbers below
    let lowest = scan.part().map(|p| f64::from(p.min));
    scan.look_at(lowest.as_slice(), &order::ranks(scan, options.trim_percent));
    let slices = slices::slices(dose, labels, options.trim_percent, &work.part(SLICES));
    work.check()?;
    let mut list = List::default();
    ranges(&mut list, scan);
    trimmed(&mut list, scan, options.trim_percent);
    best_threshold(&mut list, scan);
    work.check()?;
    band_errors(&mut list, dose, target, labels, options);
    work.check()?;
    slices::worst(&mut list, &slices);
    budget::list(&mut list, dose, labels, options);
    work.check()?;
    Ok((list.0, slices))
}

/// Share of the work on a print that the numbers of its slices are.
const SLICES: f64 = 0.3;

const AID_PW: &str = "Pellizzon et al. 2025, eq. 10";
const AID_IPDR: &str = "Pellizzon et al. 2025, eq. 11";
const AID_VER: &str = "Pellizzon et al. 2025, eq. 12";
const AID_TRIM: &str = "Pellizzon et al. 2025, section 2.1";
const BCLP_NORMS: &str = "Li et al. 2024, supplement S.8";
const TOMOLITH: &str = "Tomolith";

/// Numbers on their way into the report.
#[derive(Default)]
struct List(Vec<Published>);

impl List {
    fn add(
        &mut self,
        name: impl Into<String>,
        source: &'static str,
        unit: &'static str,
        value: Measure,
        note: impl Into<String>,
    ) {
        self.0.push(Published {
            name: name.into(),
            source,
            value: value.filter(|v| v.is_finite()),
            unit,
            note: note.into(),
        });
    }
}

/// Process window, in-part dose range and voxel error rate from the extremes.
fn ranges(list: &mut List, scan: &Scan<'_>) {
    let (part, void) = (scan.part(), scan.void());
    let [min_in, max_in] = [part.map(|p| p.min), part.map(|p| p.max)].map(|v| v.map(f64::from));
    let max_out = void.map(|v| f64::from(v.max));
    let gap = min_in.zip(max_out).map(|(i, o)| i - o);
    list.add("pw", AID_PW, "dose", gap, "min in − max out");
    let range = max_in.zip(min_in).map(|(h, l)| h - l);
    list.add("ipdr", AID_IPDR, "dose", range, "max in − min in");
    let [n_in, n_out] = scan.totals();
    let ver = min_in.map(|low| scan.count_above(low)[1] as f64 / (n_in + n_out) as f64);
    list.add("ver", AID_VER, "", ver, "#{out > min in}/(in + out)");
}

/// Process window, IPDR and VER from percentiles: α per cent of the voxels are left out at each end of each region.
fn trimmed(list: &mut List, scan: &Scan<'_>, alpha: f64) {
    let [low, high, out] = order::percentiles(scan, alpha);
    let note = |text: &str| {
        format!(
            "{text}, percentiles {alpha} and {} of each region",
            100.0 - alpha
        )
    };
    let gap = low.zip(out).map(|(i, o)| i - o);
    list.add(
        "pw_trimmed",
        AID_TRIM,
        "dose",
        gap,
        note("min in − max out"),
    );
    let range = high.zip(low).map(|(h, l)| h - l);
    list.add(
        "ipdr_trimmed",
        AID_TRIM,
        "dose",
        range,
        note("max in − min in"),
    );
    let [n_in, n_out] = scan.totals();
    let ver = low.map(|low| scan.count_above(low)[1] as f64 / (n_in + n_out) as f64);
    list.add(
        "ver_trimmed",
        AID_TRIM,
        "",
        ver,
        note("#{out > min in}/(in + out)"),
    );
}

/// The threshold of the best Jaccard index, and that index.
fn best_threshold(list: &mut List, scan: &Scan<'_>) {
    const BHATTACHARYA: &str = "Bhattacharya et al. 2021 (Li et al. 2024, S.8)";
    let best = scan.best_plateau();
    list.add(
        "threshold_jaccard",
        BHATTACHARYA,
        "dose",
        best.map(|b| b.middle()),
        "middle of the longest range of best IoU",
    );
    list.add(
        "jaccard",
        BHATTACHARYA,
        "",
        best.map(|b| b.iou),
        "IoU there",
    );
}

/// BCLP's norms over the whole, the part and the void, with ε and with 0.
fn band_errors(
    list: &mut List,
    dose: &Volume<f32>,
    target: &Volume<f32>,
    labels: &Volume<u8>,
    options: &Options<'_>,
) {
    let tolerances = [options.epsilon, 0.0];
    let band = TargetBand {
        target,
        labels,
        gray: options.gray,
    };
    let errors = norms::band_errors(dose, band, tolerances, options.response);
    for ((suffix, epsilon), errors) in ["", "_eps0"].into_iter().zip(tolerances).zip(errors) {
        for (title, error) in ["", "_part", "_void"].into_iter().zip(errors) {
            let counted = error.voxels > 0;
            let mut add = |p: &str, unit, value: f64, note: &str| {
                let note = format!("{note}, ε = {epsilon}");
                list.add(
                    format!("bclp_{p}{title}{suffix}"),
                    BCLP_NORMS,
                    unit,
                    counted.then_some(value),
                    note,
                );
            };
            add(
                "l0",
                "voxels",
                error.violated as f64,
                "p → 0: voxels whose response is out of its band",
            );
            add(
                "l1",
                "response",
                error.l1,
                "p = 1: sum of the distances from the band",
            );
            add(
                "l2",
                "response",
                error.l2,
                "p = 2: root of the sum of their squares",
            );
            add(
                "linf",
                "response",
                error.largest,
                "p → ∞: the largest distance from the band",
            );
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::print::samples::row;
    use tomolith_core::check::refuses;
    use tomolith_core::near;
    use tomolith_core::target::label::{OUTSIDE, PART, VOID};

    fn numbers_of(
        labels: &[u8],
        dose: &[f32],
        target: &[f32],
        options: &Options<'_>,
    ) -> Result<Vec<Published>> {
        let (labels, dose) = (row(labels), row(dose));
        let print = Print::new(&labels, &dose)?;
        Ok(of_print(&print, &row(target), options)?.0)
    }

    fn numbers(labels: &[u8], dose: &[f32], options: &Options<'_>) -> Vec<Published> {
        let target = labels.iter().map(|l| f32::from(u8::from(*l == PART)));
        let target: Vec<f32> = target.collect();
        numbers_of(labels, dose, &target, options).unwrap()
    }

    /// Doses that f32 holds exactly: part 0.5, 0.75, 1.25; void 0.25, 0.5, 0.625; outside 2.
    #[test]
    fn every_definition_by_hand() {
        let labels = [PART, PART, PART, VOID, VOID, VOID, OUTSIDE];
        let dose = [0.5, 0.75, 1.25, 0.25, 0.5, 0.625, 2.0];
        let options = Options {
            epsilon: 0.25,
            trim_percent: 25.0,
            ..Options::default()
        };
        let found = numbers(&labels, &dose, &options);
        for (name, expected) in [
            ("pw", -0.125),
            ("ipdr", 0.75),
            ("ver", 1.0 / 6.0),
            // Half way between neighbors: part 0.625 and 1, void 0.5625
            ("pw_trimmed", 0.0625),
            ("ipdr_trimmed", 0.375),
            ("ver_trimmed", 0.0),
            // Best from 0.625 to 0.75: two of three
            ("threshold_jaccard", 0.6875),
            ("jaccard", 2.0 / 3.0),
            // |m − f| = 0.5, 0.25, 0.25 in the part, 0.25, 0.5, 0.625 in the void
            ("bclp_l0", 3.0),
            ("bclp_l1", 0.25 + 0.25 + 0.375),
            ("bclp_l2", (0.25f64.powi(2) * 2.0 + 0.375f64.powi(2)).sqrt()),
            ("bclp_linf", 0.375),
            ("bclp_l0_part", 1.0),
            ("bclp_l1_void", 0.625),
            ("bclp_l1_eps0", 1.0 + 1.375),
            ("bclp_linf_eps0", 0.625),
            ("pw_worst_slice", -0.125),
        ] {
            let value = value_of(&found, name).unwrap_or_else(|| panic!("{name} is missing"));
            near!(value, expected, 1e-9, "{name}");
        }
        assert_eq!(value_of(&found, "light_in_part"), None);
        let mut names: Vec<&str> = found.iter().map(|n| n.name.as_str()).collect();
        names.sort_unstable();
        assert!(names.windows(2).all(|w| w[0] != w[1]), "{names:?}");
        assert!(
            found
                .iter()
                .all(|n| !n.source.is_empty() && !n.note.is_empty())
        );
    }

    #[test]
    fn what_is_not_defined_has_no_value() {
        for (labels, dose) in [
            (vec![], vec![]),
            (vec![OUTSIDE], vec![f32::NAN]),
            (vec![VOID; 2], vec![0.0; 2]),
            (vec![PART; 2], vec![0.0; 2]),
        ] {
            let found = numbers(&labels, &dose, &Options::default());
            assert!(found.iter().all(|n| n.value.is_none_or(f64::is_finite)));
            assert_eq!(value_of(&found, "pw"), None);
        }
        let dark = numbers(&[PART, VOID], &[0.0, 0.0], &Options::default());
        assert_eq!(
            [value_of(&dark, "pw"), value_of(&dark, "jaccard")],
            [Some(0.0), None]
        );
    }

    #[test]
    fn wrong_shapes_and_options_are_refused() {
        let result_of = |dose: [f32; 2], target: &[f32], options: &Options<'_>| {
            numbers_of(&[PART, VOID], &dose, target, options)
        };
        let (dose, plain) = ([0.5, 0.2], Options::default());
        let refused = result_of(dose, &[1.0], &plain);
        assert!(matches!(refused, Err(Error::Shape { what, .. }) if what == "target"));
        let epsilon = Options {
            epsilon: -1.0,
            ..plain
        };
        let trim_percent = Options {
            trim_percent: 50.0,
            ..plain
        };
        refuses(result_of(dose, &dose, &epsilon), "epsilon");
        refuses(result_of(dose, &dose, &trim_percent), "trim_percent");
        let bad = result_of([f32::NAN, 0.2], &dose, &plain);
        assert!(matches!(bad, Err(Error::NonFinite { .. })));
    }
}
