//! The print in time: curves, phases, the ideal exposure, and the part as it grows.

use super::number::{clock, significant, told_apart};
use serde_json::{Value, json};
use std::fmt::Write as _;
use tomolith_core::grid::Volume;
use tomolith_material::curves::{CurvePoint, IdealExposure, Phases};
use tomolith_metrics::Evaluation;

/// What a network becomes over time.
#[derive(Clone, Debug)]
pub struct TimeReport {
    /// Its name.
    pub name: String,
    /// Moments, ascending.
    pub points: Vec<CurvePoint>,
    /// Energy that all lights have sent to the vial at each of these moments, mJ.
    pub sent_mj: Vec<f64>,
    /// Least dose that makes the part solid, mJ; None where it depends on the power.
    pub requirement_mj: Option<f64>,
    /// When the contribution meets it.
    pub ideal: IdealExposure,
    /// When the first voxel is solid, and when the Jaccard index is largest.
    pub phases: Phases,
    /// What is solid then.
    pub evaluation: Option<Evaluation>,
    /// When each voxel became solid, s; ∞ where it never did.
    pub cure_times: Volume<f32>,
    /// Degree of cure (1: solid) of some moments, s.
    pub snapshots: Vec<(f64, Volume<f32>)>,
}

impl TimeReport {
    /// The moment of the largest Jaccard index, and the energy that was sent by then, mJ.
    #[must_use]
    pub fn best(&self) -> Option<(&CurvePoint, f64)> {
        let at = self.phases.curing_end_s?;
        let mut moments = self.points.iter().zip(self.sent_mj.iter().copied());
        moments.find(|(point, _)| point.seconds >= at)
    }

    /// When the contribution meets the requirement, s.
    #[must_use]
    pub fn ideal_s(&self) -> Option<f64> {
        match self.ideal {
            IdealExposure::At(seconds) => Some(seconds),
            IdealExposure::NotReached(_) | IdealExposure::NoRequirement => None,
        }
    }

    /// The largest share of the requirement that was reached, where it never is met.
    #[must_use]
    pub fn reached(&self) -> Option<f64> {
        match self.ideal {
            IdealExposure::NotReached(share) => Some(share),
            IdealExposure::At(_) | IdealExposure::NoRequirement => None,
        }
    }

    /// The window of times within which the Jaccard index is at most 0.01 below its largest, s.
    #[must_use]
    pub fn window_s(&self) -> Option<[f64; 2]> {
        let least = self.best()?.0.jaccard - 0.01;
        let good = |point: &&CurvePoint| point.jaccard >= least;
        let first = self.points.iter().find(good)?;
        let last = self.points.iter().rfind(good)?;
        Some([first.seconds, last.seconds])
    }

    /// One line per moment: `time.csv`.
    #[must_use]
    pub fn csv(&self) -> String {
        let mut text =
            "seconds,imbued_mj,contribution_mj,contrast,contrast_as_printed,jaccard,solid_part,solid_void,sent_mj\n"
                .to_owned();
        let number = |contrast: f64| match contrast.is_finite() {
            true => contrast.to_string(),
            false => String::new(),
        };
        for (p, sent_mj) in self.points.iter().zip(&self.sent_mj) {
            let [contrast, printed] = [p.contrast, p.printed_contrast].map(number);
            // Writing into a string cannot fail
            let _ = writeln!(
                text,
                "{},{},{},{contrast},{printed},{},{},{},{sent_mj}",
                p.seconds, p.imbued_mj, p.contribution_mj, p.jaccard, p.gelled[0], p.gelled[1]
            );
        }
        text
    }
}

pub(super) fn time_json(time: &TimeReport) -> Value {
    // What is not finite is null
    let column =
        |number_of: fn(&CurvePoint) -> f64| time.points.iter().map(number_of).collect::<Vec<_>>();
    let evaluation = time.evaluation.as_ref().map(super::json::evaluation_json);
    json!({
        "name": time.name,
        "induction_end_s": time.phases.induction_end_s,
        "best_s": time.phases.curing_end_s,
        "best_jaccard": time.best().map(|(p, _)| p.jaccard),
        "best_mj": time.best().map(|(_, mj)| mj),
        "window_s": time.window_s(),
        "ideal_exposure_s": time.ideal_s(),
        "requirement_mj": time.requirement_mj,
        "largest_share_of_requirement": time.reached(),
        "evaluation": evaluation.unwrap_or_default(),
        "curves": {
            "seconds": column(|p| p.seconds),
            "imbued_mj": column(|p| p.imbued_mj),
            "contribution_mj": column(|p| p.contribution_mj),
            "contrast": column(|p| p.contrast),
            "jaccard": column(|p| p.jaccard),
            "solid_part": column(|p| p.gelled[0]),
            "solid_void": column(|p| p.gelled[1]),
            "sent_mj": time.sent_mj,
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

impl TimeReport {
    /// What happens when, in words.
    #[must_use]
    pub fn sentence(&self) -> String {
        let time = self;
        let s = |v: f64| significant(v, 3);
        let end = time.points.last().map_or(0.0, |p| p.seconds);
        let (Some(begin), Some((best, sent_mj))) = (time.phases.induction_end_s, time.best())
        else {
            let why = match time.reached() {
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
            s(sent_mj),
        );
        let window = time.window_s();
        if window.is_some_and(|[low, high]| low == high) {
            text.push_str(" At the moments before and after it is more than 0.01 worse.");
        } else if let Some([low, high]) = window {
            let texts = told_apart(&[low, best.seconds, high], 3);
            let until = if high >= end {
                "the end".to_owned()
            } else {
                format!("{} s", texts[2])
            };
            let _ = write!(
                text,
                " It stays within 0.01 of that from {} s to {until}.",
                texts[0]
            );
        }
        if best.seconds >= end {
            text.push_str(
                " The schedule ends there; more turns would show whether it gets better still.",
            );
        }
        match time.ideal {
            IdealExposure::At(ideal) => {
                let _ = write!(
                    text,
                    " What solid voxels have absorbed meets what the part needs after {} (ideal exposure).",
                    minutes(ideal)
                );
            }
            IdealExposure::NotReached(share) => {
                let _ = write!(
                    text,
                    " Solid voxels absorb at most {} % of what the part needs.",
                    s(100.0 * share)
                );
            }
            IdealExposure::NoRequirement => {}
        }
        text
    }
}
