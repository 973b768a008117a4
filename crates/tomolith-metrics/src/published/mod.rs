//! Numbers with the signs and normalizations of the publications, so that they can be laid beside theirs.
//!
//! Authors use the same words for different numbers. [`METRICS`](super::METRICS) holds one definition of each; here is
//! every other one that was found, under a name of its own and with its source. They work on anybody's arrays: a dose,
//! a target and labels ([`label`](tomolith_core::target::label)) of the same voxels.
//!
//! | name | definition | source |
//! |---|---|---|
//! | `pw` | min in − max out | AID eq. 10 |
//! | `pw_overlap` | max out − min in, *below* 0 is good | Rackson 2021 (quoted by AID 2.1); VAMToolbox `calcPW` |
//! | `pw_overlap_max1` | the same of dose/max | Rackson 2021: its doses are normalized by the maximum |
//! | `pw_max1`, `pw_mean1` | min in − max out of dose/max, and of dose/(mean in the part) | AID eq. 10 of an OSMO dose; Tomolith |
//! | `pw_trimmed` | as `pw` of percentiles: α in the part, 100 − α outside | AID 2.1, last paragraph |
//! | `ipdr` | max in − min in | AID eq. 11; VAMToolbox `calcIPDR` |
//! | `ipdr_from_max1` | 1 − min in, of dose/max | Rackson 2021; BCLP table S2 |
//! | `ipdr_max1`, `ipdr_mean1` | max in − min in of dose/max, of dose/(mean in the part) | AID eq. 11 of an OSMO dose; Tomolith |
//! | `ipdr_trimmed` | of percentiles 100 − α and α | AID 2.1 |
//! | `ver` | #{out > min in}/(in + out) | Rackson 2021; AID eq. 12 |
//! | `ver_inclusive` | #{out ≥ min in}/(in + out) | VAMToolbox `calcVER` |
//! | `ver_box` | #{out > min in}/(all voxels of the array) | BCLP table S2: of the simulation volume |
//! | `ver_trimmed` | min in replaced by its percentile α | AID 2.1 |
//! | `cv` | standard deviation/mean in the part | VAMToolbox `calcCV` |
//! | `threshold_jaccard`, `jaccard` | threshold of the largest Jaccard index, and that index | Bhattacharya 2021, BCLP S.8 |
//! | `threshold_max1`, `threshold_mean1` | that threshold of dose/max, and of dose/(mean in the part) | –, Tomolith |
//! | `jaccard_0_1` | the largest over t in [0, 1] | Nicolet 2024 eq. 21 |
//! | `jaccard_grid` | the largest over 100 thresholds from 0 to 1.3, strictly above, in the whole box | Dr.TVAM 0.9 |
//! | `threshold_otsu`, `jaccard_otsu` | Otsu's threshold ([`otsu`]), and the index there | Kelly 2019, BCLP S.8 |
//! | `threshold_lowest`, `jaccard_lowest` | lowest dose in the part, which still gels | Rackson 2021, BCLP S.8 |
//! | `relative_time` | brightest pixel/`threshold_jaccard` | Dr.TVAM 0.9 |
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
//! use tomolith_metrics::published::{Options, published, value_of};
//! use tomolith_core::target::label::{PART, VOID};
//! let grid = VolumeGrid::centered([1, 1, 4], 0.1);
//! let volume = |values: &[f32]| Volume { grid: grid.clone(), values: values.to_vec() };
//! let (dose, target) = (volume(&[0.2, 0.8, 0.9, 0.4]), volume(&[0.0, 1.0, 1.0, 0.0]));
//! let labels = Volume { grid: grid.clone(), values: vec![VOID, PART, PART, VOID] };
//! let numbers = published(&dose, &target, &labels, &Options::default()).unwrap();
//! let near = |name: &str, expected: f64| (value_of(&numbers, name).unwrap() - expected).abs() < 1e-6;
//! assert!(near("pw", 0.4) && near("pw_overlap", -0.4)); // 0.8 − 0.4 and its opposite
//! assert!(near("ipdr_from_max1", 1.0 - 0.8 / 0.9)); // the largest dose is 0.9
//! ```

pub mod budget;
mod norms;
mod order;
pub mod otsu;
pub mod slices;
pub mod unit_systems;

pub use order::percentiles;

use super::Measure;
use super::print::{PatternStats, Print};
use super::scan::Scan;
use norms::TargetBand;
use serde::Serialize;
use slices::Slice;
use tomolith_core::error::{Error, Result};
use tomolith_core::grid::{Patterns, Volume};
use tomolith_core::parallel::table;
use tomolith_core::response::{Identity, Response};
use tomolith_core::units::exact;

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
        }
    }
}

impl Options<'_> {
    fn validate(&self) -> Result<()> {
        let within = |key: &str, value: f64, end: f64, accepted: &str| {
            if (0.0..end).contains(&value) {
                return Ok(());
            }
            Err(Error::config(
                key,
                format!("found {}", exact(value)),
                accepted,
            ))
        };
        within(
            "epsilon",
            self.epsilon,
            f64::INFINITY,
            "a finite number, 0 or above",
        )?;
        within(
            "trim_percent",
            self.trim_percent,
            50.0,
            "per cent, 0 to below 50",
        )
    }
}

/// Every published number of a dose; all three volumes are of the same voxels.
///
/// # Errors
/// [`Error::Shape`] when they are not; [`Error::NonFinite`] when the dose of a part or void voxel is not finite;
/// [`Error::Config`] for options out of range.
pub fn published(
    dose: &Volume<f32>,
    target: &Volume<f32>,
    labels: &Volume<u8>,
    options: &Options<'_>,
) -> Result<Vec<Published>> {
    by_slices(dose, target, labels, options).map(|(numbers, _)| numbers)
}

/// As [`published`], with the numbers of every slice ([`slices`](slices::slices)), which some of them are made of.
///
/// # Errors
/// As [`published`].
pub fn by_slices(
    dose: &Volume<f32>,
    target: &Volume<f32>,
    labels: &Volume<u8>,
    options: &Options<'_>,
) -> Result<(Vec<Published>, Vec<Slice>)> {
    of_print(&Print::new(labels, dose)?, target, options)
}

/// As [`by_slices`], of a print whose response is the dose: what the metrics count of it is counted once.
///
/// # Errors
/// As [`published`].
pub fn of_print(
    print: &Print<'_>,
    target: &Volume<f32>,
    options: &Options<'_>,
) -> Result<(Vec<Published>, Vec<Slice>)> {
    options.validate()?;
    let (dose, labels, scan) = (print.response(), print.labels(), print.scan());
    if target.grid.shape != dose.grid.shape || target.values.len() != dose.values.len() {
        return Err(Error::Shape {
            what: "target".to_owned(),
            expected: dose.grid.shape.to_vec(),
            found: target.grid.shape.to_vec(),
        });
    }
    let run = print.run();
    let otsu = otsu::otsu(dose, labels, scan);
    run.check()?;
    // One look for all that is asked below
    let lowest = scan.part().map(|p| p.min);
    let thresholds = lowest
        .iter()
        .flat_map(|t| [*t, t.next_down()].map(f64::from));
    scan.look_at(
        &thresholds.chain(otsu).collect::<Vec<_>>(),
        &order::ranks(scan, options.trim_percent),
    );
    let slices = slices::slices_under(dose, labels, options.trim_percent, &run.part(SLICES));
    run.check()?;
    let mut list = List::default();
    ranges(&mut list, scan, dose);
    trimmed(&mut list, scan, options.trim_percent);
    thresholds_of(&mut list, scan, dose, labels, otsu);
    relative_time(&mut list, scan, options.patterns);
    run.check()?;
    band_errors(&mut list, dose, target, labels, options);
    run.check()?;
    slices::worst(&mut list, &slices);
    budget::list(&mut list, dose, labels, options.patterns);
    run.check()?;
    Ok((list.0, slices))
}

/// Share of the work on a print that the numbers of its slices are.
const SLICES: f64 = 0.3;

const RACKSON: &str = "Rackson et al. 2021";
const VAMTOOLBOX: &str = "VAMToolbox 2.0";
const AID_PW: &str = "Pellizzon et al. 2025, eq. 10";
const AID_IPDR: &str = "Pellizzon et al. 2025, eq. 11";
const AID_VER: &str = "Pellizzon et al. 2025, eq. 12";
const AID_TRIM: &str = "Pellizzon et al. 2025, section 2.1";
const BCLP_TABLE: &str = "Li et al. 2024, supplementary table 2";
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

/// The largest dose of part and void, and the mean in the part.
fn scales(scan: &Scan<'_>) -> [Measure; 2] {
    let (part, void) = (scan.part(), scan.void());
    let largest = part.iter().chain(&void).map(|s| f64::from(s.max));
    [largest.reduce(f64::max), part.map(|p| p.mean)]
}

/// Process window, in-part dose range, voxel error rate and coefficient of variation from the extremes.
fn ranges(list: &mut List, scan: &Scan<'_>, dose: &Volume<f32>) {
    let (part, void) = (scan.part(), scan.void());
    let min_in = part.map(|p| f64::from(p.min));
    let max_in = part.map(|p| f64::from(p.max));
    let max_out = void.map(|v| f64::from(v.max));
    let [max, mean] = scales(scan);
    let per = |value: Measure, unit: Measure| {
        let (value, unit) = (value?, unit?);
        (unit > 0.0).then(|| value / unit)
    };
    let gap = min_in.zip(max_out).map(|(i, o)| i - o);
    let overlap = gap.map(|gap| 0.0 - gap);
    let range = max_in.zip(min_in).map(|(h, l)| h - l);

    list.add("pw", AID_PW, "dose", gap, "min in − max out");
    list.add(
        "pw_overlap",
        VAMTOOLBOX,
        "dose",
        overlap,
        "max out − min in: below 0 is good",
    );
    list.add(
        "pw_overlap_max1",
        RACKSON,
        "",
        per(overlap, max),
        "max out − min in of dose/max: below 0 is good",
    );
    list.add(
        "pw_max1",
        AID_PW,
        "",
        per(gap, max),
        "min in − max out of dose/max, as of methods that normalize",
    );
    list.add(
        "pw_mean1",
        TOMOLITH,
        "",
        per(gap, mean),
        "min in − max out of dose/(mean in the part): fair between methods",
    );

    list.add("ipdr", AID_IPDR, "dose", range, "max in − min in");
    let from_top = per(min_in, max).map(|m| 1.0 - m);
    list.add(
        "ipdr_from_max1",
        BCLP_TABLE,
        "",
        from_top,
        "1 − min in of dose/max (Rackson et al. 2021)",
    );
    list.add(
        "ipdr_max1",
        AID_IPDR,
        "",
        per(range, max),
        "max in − min in of dose/max",
    );
    list.add(
        "ipdr_mean1",
        TOMOLITH,
        "",
        per(range, mean),
        "max in − min in of dose/(mean in the part)",
    );

    let [n_in, n_out] = scan.totals();
    let counted = (n_in + n_out) as f64;
    let above = part.map(|p| scan.count_above(f64::from(p.min))[1] as f64);
    let from = part.map(|p| scan.count_above(f64::from(p.min.next_down()))[1] as f64);
    list.add(
        "ver",
        AID_VER,
        "",
        above.map(|w| w / counted),
        "#{out > min in}/(in + out)",
    );
    list.add(
        "ver_inclusive",
        VAMTOOLBOX,
        "",
        from.map(|w| w / counted),
        "#{out ≥ min in}/(in + out)",
    );
    let voxels = dose.values.len() as f64;
    list.add(
        "ver_box",
        BCLP_TABLE,
        "",
        above.map(|w| w / voxels),
        "#{out > min in}/(all voxels of the array)",
    );
    let cv = part.map(|p| p.deviation / p.mean);
    list.add(
        "cv",
        VAMTOOLBOX,
        "",
        cv,
        "standard deviation/mean in the part",
    );
}

/// The same from percentiles: α per cent of the voxels are left out at each end of each region.
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

/// The published ways to choose the gel threshold, and the Jaccard index there.
fn thresholds_of(
    list: &mut List,
    scan: &Scan<'_>,
    dose: &Volume<f32>,
    labels: &Volume<u8>,
    otsu: Measure,
) {
    const BHATTACHARYA: &str = "Bhattacharya et al. 2021 (Li et al. 2024, S.8)";
    const KELLY: &str = "Kelly et al. 2019 (Li et al. 2024, S.8)";
    const NICOLET: &str = "Nicolet et al. 2024, eq. 21";
    const LOWEST: &str = "Rackson et al. 2021 (Li et al. 2024, S.8)";
    let index = |t: Measure| t.and_then(|t| scan.iou_at(t));
    let best = scan.best_plateau();
    let middle = best.map(|b| b.middle());
    list.add(
        "threshold_jaccard",
        BHATTACHARYA,
        "dose",
        middle,
        "middle of the longest range of best Jaccard index",
    );
    let [max, mean] = scales(scan);
    let per = |scale: Measure| Some(middle? / scale.filter(|s| *s > 0.0)?);
    list.add(
        "threshold_max1",
        BHATTACHARYA,
        "",
        per(max),
        "that threshold for dose/max, as of methods that normalize",
    );
    list.add(
        "threshold_mean1",
        TOMOLITH,
        "",
        per(mean),
        "that threshold for dose/(mean in the part): fair between methods",
    );
    list.add(
        "jaccard",
        BHATTACHARYA,
        "",
        best.map(|b| b.iou),
        "Jaccard index (IoU) there",
    );
    let limited = best.and_then(|best| {
        if best.from <= 1.0 && best.to > 0.0 {
            return Some(best.iou);
        }
        // All that happens in [0, 1] happens at a dose in it; rare, so it may cost a copy
        let inside = table(dose.values.len(), |i| {
            dose.values[i].clamp(0.0, 1.0f32.next_up())
        });
        let scan = Scan::new(&labels.values, &inside).ok()?;
        Some(scan.best_plateau()?.iou)
    });
    list.add(
        "jaccard_0_1",
        NICOLET,
        "",
        limited,
        "largest Jaccard index over thresholds in [0, 1]",
    );
    let steps = (0..100).map(|i| 1.3 * f64::from(i) / 99.0);
    let box_index = scan
        .part()
        .map(|_| norms::largest_index(dose, labels, steps));
    list.add(
        "jaccard_grid",
        "Dr.TVAM 0.9",
        "",
        box_index,
        "largest over 100 thresholds from 0 to 1.3, whole box",
    );
    list.add(
        "threshold_otsu",
        KELLY,
        "dose",
        otsu,
        "Otsu's threshold of 256 bins",
    );
    list.add(
        "jaccard_otsu",
        KELLY,
        "",
        index(otsu),
        "Jaccard index there",
    );
    let lowest = scan.part().map(|p| p.min);
    list.add(
        "threshold_lowest",
        LOWEST,
        "dose",
        lowest.map(f64::from),
        "lowest dose in the part",
    );
    let all_in = index(lowest.map(|t| f64::from(t.next_down())));
    list.add(
        "jaccard_lowest",
        LOWEST,
        "",
        all_in,
        "Jaccard index of all that got at least that dose",
    );
}

/// How long a print takes at a given power, up to a factor.
fn relative_time(list: &mut List, scan: &Scan<'_>, patterns: &[Patterns]) {
    let brightest = f64::from(PatternStats::of(patterns).max);
    let threshold = scan.best_plateau().map(|b| b.middle());
    let time = threshold.filter(|t| *t > 0.0).map(|t| brightest / t);
    list.add(
        "relative_time",
        "Dr.TVAM 0.9",
        "",
        time.filter(|_| brightest > 0.0),
        "brightest pixel/best threshold: proportional to the time to print at a given power",
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
    use tomolith_core::check::noise;
    use tomolith_core::grid::VolumeGrid;
    use tomolith_core::target::label::{OUTSIDE, PART, VOID};

    fn volume<T: Clone>(shape: [usize; 3], values: &[T]) -> Volume<T> {
        Volume {
            grid: VolumeGrid::centered(shape, 0.1),
            values: values.to_vec(),
        }
    }

    fn numbers(labels: &[u8], dose: &[f32], options: &Options<'_>) -> Vec<Published> {
        let shape = [1, 1, labels.len()];
        let target: Vec<f32> = labels
            .iter()
            .map(|l| f32::from(u8::from(*l == PART)))
            .collect();
        published(
            &volume(shape, dose),
            &volume(shape, &target),
            &volume(shape, labels),
            options,
        )
        .unwrap()
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
        let mean = 2.5 / 3.0;
        for (name, expected) in [
            ("pw", -0.125),
            ("pw_overlap", 0.125),
            ("pw_overlap_max1", 0.1),
            ("pw_max1", -0.1),
            ("pw_mean1", -0.125 / mean),
            ("ipdr", 0.75),
            ("ipdr_from_max1", 0.6),
            ("ipdr_max1", 0.6),
            ("ipdr_mean1", 0.75 / mean),
            ("ver", 1.0 / 6.0),
            ("ver_inclusive", 2.0 / 6.0),
            ("ver_box", 1.0 / 7.0),
            ("cv", (0.875f64 / 9.0).sqrt() / mean),
            // Half way between neighbors: part 0.625 and 1, void 0.5625
            ("pw_trimmed", 0.0625),
            ("ipdr_trimmed", 0.375),
            ("ver_trimmed", 0.0),
            // Best from 0.625 to 0.75: two of three; at 0.25 all three and two of the void
            ("threshold_jaccard", 0.6875),
            ("threshold_max1", 0.55),
            ("threshold_mean1", 0.6875 / mean),
            ("jaccard", 2.0 / 3.0),
            ("jaccard_0_1", 2.0 / 3.0),
            ("jaccard_grid", 0.5),
            ("threshold_lowest", 0.5),
            ("jaccard_lowest", 3.0 / 5.0),
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
            assert!(
                (value - expected).abs() < 1e-9,
                "{name}: {value} instead of {expected}"
            );
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
    fn numbers_of_normalized_doses_do_not_depend_on_the_scale() {
        let labels: Vec<u8> = (0..200).map(|i| [PART, VOID][i % 2]).collect();
        let dose: Vec<f32> = noise(3, 200)
            .iter()
            .zip(&labels)
            .map(|(v, l)| 0.4 * f32::from(*l) + 0.2 * v)
            .collect();
        let scaled: Vec<f32> = dose.iter().map(|d| 4.0 * d).collect();
        let [a, b] = [&dose, &scaled].map(|d| numbers(&labels, d, &Options::default()));
        for name in [
            "pw_overlap_max1",
            "pw_max1",
            "pw_mean1",
            "ipdr_from_max1",
            "ipdr_max1",
            "ipdr_mean1",
            "ver",
            "ver_trimmed",
            "cv",
            "jaccard",
            "jaccard_otsu",
        ] {
            let (a, b) = (value_of(&a, name).unwrap(), value_of(&b, name).unwrap());
            assert!((a - b).abs() < 1e-9, "{name}: {a} {b}");
        }
        for name in [
            "pw",
            "pw_trimmed",
            "ipdr",
            "threshold_otsu",
            "threshold_lowest",
        ] {
            let (a, b) = (value_of(&a, name).unwrap(), value_of(&b, name).unwrap());
            assert!((4.0 * a - b).abs() < 1e-6, "{name}: {a} {b}");
        }
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
            [
                value_of(&dark, "pw"),
                value_of(&dark, "pw_max1"),
                value_of(&dark, "jaccard")
            ],
            [Some(0.0), None, None]
        );
    }

    #[test]
    fn wrong_shapes_and_options_are_refused() {
        let dose = volume([1, 1, 2], &[0.5f32, 0.2]);
        let labels = volume([1, 1, 2], &[PART, VOID]);
        let short = volume([1, 1, 1], &[1.0f32]);
        let refused = published(&dose, &short, &labels, &Options::default());
        assert!(matches!(refused, Err(Error::Shape { what, .. }) if what == "target"));
        for (options, wanted) in [
            (
                Options {
                    epsilon: -1.0,
                    ..Options::default()
                },
                "epsilon",
            ),
            (
                Options {
                    trim_percent: 50.0,
                    ..Options::default()
                },
                "trim_percent",
            ),
        ] {
            let refused = published(&dose, &dose, &labels, &options);
            assert!(matches!(refused, Err(Error::Config { key, .. }) if key == wanted));
        }
        let bad = volume([1, 1, 2], &[f32::NAN, 0.2]);
        assert!(matches!(
            published(&bad, &bad, &labels, &Options::default()),
            Err(Error::NonFinite { .. })
        ));
    }
}
