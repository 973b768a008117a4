//! The print in time: curves, phases, the ideal exposure, and the part as it grows.

use super::number::{clock, significant, told_apart};
use serde_json::{Value, json};
use std::fmt::Write as _;
use tomolith_core::grid::Volume;
use tomolith_metrics::Evaluation;

/// A moment of the print.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct TimePoint {
    /// Time, s.
    pub seconds: f64,
    /// Drive that was absorbed so far, mJ.
    pub imbued_mj: f64,
    /// The part of it in voxels that are solid, mJ.
    pub contribution_mj: f64,
    /// Contrast of the dose; NaN while all is the same.
    pub contrast: f64,
    /// The same as it is printed (S12): NaN where its low class is empty.
    pub printed_contrast: f64,
    /// Solid ∩ part over solid ∪ part.
    pub jaccard: f64,
    /// Solid share of part and of void.
    pub solid: [f64; 2],
    /// Energy that all lights have sent to the vial so far, mJ.
    pub sent_mj: f64,
}

/// What a network becomes over time.
#[derive(Clone, Debug)]
pub struct TimeReport<'a> {
    /// Its name.
    pub name: &'a str,
    /// Moments, ascending.
    pub points: Vec<TimePoint>,
    /// Least dose that makes the part solid, mJ; None where it depends on the power.
    pub requirement_mj: Option<f64>,
    /// When the contribution meets it, s.
    pub ideal_s: Option<f64>,
    /// Largest share of it that was reached, where it never is.
    pub reached: Option<f64>,
    /// When the first voxel is solid, and when the Jaccard index is largest, s; None where nothing becomes solid.
    pub phases_s: [Option<f64>; 2],
    /// What is solid when the Jaccard index is largest.
    pub evaluation: Option<&'a Evaluation>,
    /// When each voxel became solid, s; NaN where it never did.
    pub cure_times: Option<&'a Volume<f32>>,
    /// Degree of cure (1: solid) of some moments, s.
    pub snapshots: &'a [(f64, Volume<f32>)],
}

impl TimeReport<'_> {
    /// Largest Jaccard index.
    fn best(&self) -> Option<&TimePoint> {
        let at = self.phases_s[1]?;
        self.points.iter().find(|point| point.seconds >= at)
    }

    /// The window of times within which the Jaccard index is at most 0.01 below its largest, s.
    #[must_use]
    pub fn window_s(&self) -> Option<[f64; 2]> {
        let least = self.best()?.jaccard - 0.01;
        let good = |point: &&TimePoint| point.jaccard >= least;
        let first = self.points.iter().find(good)?;
        let last = self.points.iter().rfind(good)?;
        Some([first.seconds, last.seconds])
    }
}

/// One line per moment: `time.csv`.
#[must_use]
pub fn csv(points: &[TimePoint]) -> String {
    let mut text =
        "seconds,imbued_mj,contribution_mj,contrast,contrast_as_printed,jaccard,solid_part,solid_void,sent_mj\n"
            .to_owned();
    let number = |contrast: f64| match contrast.is_finite() {
        true => contrast.to_string(),
        false => String::new(),
    };
    for p in points {
        let [contrast, printed] = [p.contrast, p.printed_contrast].map(number);
        // Writing into a string cannot fail
        let _ = writeln!(
            text,
            "{},{},{},{contrast},{printed},{},{},{},{}",
            p.seconds, p.imbued_mj, p.contribution_mj, p.jaccard, p.solid[0], p.solid[1], p.sent_mj
        );
    }
    text
}

pub(super) fn time_json(time: &TimeReport<'_>) -> Value {
    // What is not finite is null
    let column = |of: fn(&TimePoint) -> f64| time.points.iter().map(of).collect::<Vec<_>>();
    let evaluation = time.evaluation.map(super::json::evaluation_json);
    json!({
        "name": time.name,
        "induction_end_s": time.phases_s[0],
        "best_s": time.phases_s[1],
        "best_jaccard": time.best().map(|p| p.jaccard),
        "best_mj": time.best().map(|p| p.sent_mj),
        "window_s": time.window_s(),
        "ideal_exposure_s": time.ideal_s,
        "requirement_mj": time.requirement_mj,
        "largest_share_of_requirement": time.reached,
        "evaluation": evaluation.unwrap_or_default(),
        "curves": {
            "seconds": column(|p| p.seconds),
            "imbued_mj": column(|p| p.imbued_mj),
            "contribution_mj": column(|p| p.contribution_mj),
            "contrast": column(|p| p.contrast),
            "jaccard": column(|p| p.jaccard),
            "solid_part": column(|p| p.solid[0]),
            "solid_void": column(|p| p.solid[1]),
            "sent_mj": column(|p| p.sent_mj),
        },
    })
}

/// Seconds, and minutes where there are some.
fn minutes(seconds: f64) -> String {
    format!("{} s{}", significant(seconds, 3), in_minutes(seconds))
}

/// What follows seconds: minutes in brackets where there are some.
pub(super) fn in_minutes(seconds: f64) -> String {
    if seconds < 60.0 {
        String::new()
    } else {
        format!(" ({})", clock(seconds))
    }
}

impl TimeReport<'_> {
    /// What happens when, in words.
    #[must_use]
    pub fn sentence(&self) -> String {
        let time = self;
        let s = |v: f64| significant(v, 3);
        let end = time.points.last().map_or(0.0, |p| p.seconds);
        let (Some(begin), Some(best)) = (time.phases_s[0], time.best()) else {
            let why = match time.reached {
                Some(share) if share >= 1.0 => format!(
                    "The part absorbs {} % of what it needs in all, but too unevenly, or so slowly that inhibitor flows back.",
                    s(100.0 * share)
                ),
                Some(share) => format!(
                    "The part absorbs {} % of what it needs. More turns, or more power, would help.",
                    s(100.0 * share)
                ),
                None => "More turns, or more power, would help.".to_owned(),
            };
            return format!("Nothing becomes solid within {} s. {why}", s(end));
        };
        let mut text = format!(
            "The first voxel is solid after {} s. The print is best after {}: solid and part then overlap with an IoU of {}, and \
         {} mJ have been sent to the vial.",
            s(begin),
            minutes(best.seconds),
            significant(best.jaccard, 4),
            s(best.sent_mj),
        );
        let window = time.window_s();
        if window.is_some_and(|[low, high]| low == high) {
            text.push_str(" At the moments before and after it is more than 0.01 worse.");
        } else if let Some([low, high]) = window {
            let said = told_apart(&[low, best.seconds, high], 3);
            let until = if high >= end {
                "the end".to_owned()
            } else {
                format!("{} s", said[2])
            };
            let _ = write!(
                text,
                " It stays within 0.01 of that from {} s to {until}.",
                said[0]
            );
        }
        if best.seconds >= end {
            text.push_str(
                " The schedule ends there; more turns would show whether it gets better still.",
            );
        }
        match (time.ideal_s, time.reached) {
            (Some(ideal), _) => {
                let _ = write!(
                    text,
                    " What solid voxels have absorbed meets what the part needs after {} (ideal exposure).",
                    minutes(ideal)
                );
            }
            (None, Some(share)) => {
                let _ = write!(
                    text,
                    " Solid voxels absorb at most {} % of what the part needs.",
                    s(100.0 * share)
                );
            }
            (None, None) => {}
        }
        text
    }
}
