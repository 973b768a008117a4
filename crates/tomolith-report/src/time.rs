//! The print in time: curves, phases, the ideal exposure, and the part as it grows.

use super::growth;
use super::number::{clock, escape, significant, told_apart};
use super::plot::{Axis, Plot};
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
    /// Degree of cure (1: solid) and when, with the labels of the same voxels.
    pub snapshots: &'a [(f64, Volume<f32>)],
    /// Labels of those voxels.
    pub labels: &'a Volume<u8>,
}

impl TimeReport<'_> {
    /// Solid share of part and of void at a time, linear between moments.
    pub(super) fn solid_at(&self, seconds: f64) -> [f64; 2] {
        let after = self.points.partition_point(|p| p.seconds < seconds);
        let last = self.points.len().saturating_sub(1);
        let ends = [after.saturating_sub(1), after].map(|i| self.points.get(i.min(last)));
        let [Some(a), Some(b)] = ends else {
            return [0.0; 2];
        };
        let share = match b.seconds - a.seconds {
            0.0 => 0.0,
            apart => ((seconds - a.seconds) / apart).clamp(0.0, 1.0),
        };
        [0, 1].map(|i| a.solid[i] + share * (b.solid[i] - a.solid[i]))
    }

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
    let number = |v: Option<f64>| v.filter(|v| v.is_finite()).map_or(Value::Null, Value::from);
    let column = |of: &dyn Fn(&TimePoint) -> f64| -> Vec<Value> {
        time.points.iter().map(|p| number(Some(of(p)))).collect()
    };
    let evaluation = time.evaluation.map(super::json::evaluation_json);
    json!({
        "name": time.name,
        "induction_end_s": number(time.phases_s[0]),
        "best_s": number(time.phases_s[1]),
        "best_jaccard": number(time.best().map(|p| p.jaccard)),
        "best_mj": number(time.best().map(|p| p.sent_mj)),
        "window_s": time.window_s(),
        "ideal_exposure_s": number(time.ideal_s),
        "requirement_mj": number(time.requirement_mj),
        "largest_share_of_requirement": number(time.reached),
        "evaluation": evaluation.unwrap_or_default(),
        "curves": {
            "seconds": column(&|p| p.seconds),
            "imbued_mj": column(&|p| p.imbued_mj),
            "contribution_mj": column(&|p| p.contribution_mj),
            "contrast": column(&|p| p.contrast),
            "jaccard": column(&|p| p.jaccard),
            "sent_mj": column(&|p| p.sent_mj),
        },
    })
}

/// The section of a network; `number` tells the sliders of a page apart, `above_um` is the pitch of the voxels of the numbers above.
pub(super) fn section(time: &TimeReport<'_>, number: usize, above_um: f64) -> String {
    let title = if number == 0 && time.name == "resin" {
        "The print in time".to_owned()
    } else {
        format!("The print in time: {}", escape(time.name))
    };
    format!(
        "<section><h2>{title}</h2><p>{}</p><p class=\"muted\">{}</p><div class=\"two\"><div>{}</div><div>{}</div></div>{}</section>",
        sentence(time),
        voxels(time, above_um),
        jaccard_plot(time),
        energy_plot(time),
        growth::slider(time, number),
    )
}

/// On which voxels it is printed, in words.
fn voxels(time: &TimeReport<'_>, above_um: f64) -> String {
    let own_um = 1e3 * time.labels.grid.pitch_mm;
    let own = significant(own_um, 3);
    if (above_um - own_um).abs() < 1e-6 * own_um {
        return format!("Printed on voxels of {own} µm, as the dose above.");
    }
    format!(
        "Printed on the job's own voxels of {own} µm. The numbers above are of voxels of {} µm, so the two cannot be compared.",
        significant(above_um, 3)
    )
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

/// What happens when, in words.
fn sentence(time: &TimeReport<'_>) -> String {
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
        "The first voxel is solid after {} s. The print is best after <b>{}</b>: solid and part then overlap with a Jaccard index of <b>{}</b>, and \
         <b>{} mJ</b> have been sent to the vial.",
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

fn jaccard_plot(time: &TimeReport<'_>) -> String {
    let end = time.points.last().map_or(1.0, |p| p.seconds);
    let mut plot = Plot::new(
        Axis::linear("time in s", 0.0, end),
        Axis::linear("", 0.0, 1.0),
    );
    let line = |of: &dyn Fn(&TimePoint) -> f64| -> Vec<[f64; 2]> {
        let points = time.points.iter().map(|p| [p.seconds, of(p)]);
        points.filter(|p| p[1].is_finite()).collect()
    };
    if let Some([low, high]) = time.window_s() {
        plot.band(low, high, "window", "best");
    }
    plot.line(&line(&|p| p.contrast), "still", "contrast");
    plot.line(&line(&|p| p.solid[0]), "part", "part solid");
    plot.line(&line(&|p| p.solid[1]), "void", "void solid");
    plot.line(&line(&|p| p.jaccard), "accent", "Jaccard");
    plot.svg("Jaccard index, solid shares and contrast over time")
}

fn energy_plot(time: &TimeReport<'_>) -> String {
    let end = time.points.last().map_or(1.0, |p| p.seconds);
    let most = time.points.last().map_or(1.0, |p| p.imbued_mj);
    let most = most.max(time.requirement_mj.unwrap_or(0.0));
    let mut plot = Plot::new(
        Axis::linear("time in s", 0.0, end),
        Axis::linear("absorbed drive in mJ", 0.0, most),
    );
    let line = |of: &dyn Fn(&TimePoint) -> f64| -> Vec<[f64; 2]> {
        time.points.iter().map(|p| [p.seconds, of(p)]).collect()
    };
    plot.line(&line(&|p| p.imbued_mj), "void", "in all voxels");
    plot.line(&line(&|p| p.contribution_mj), "accent", "in solid voxels");
    if let Some(needed) = time.requirement_mj {
        plot.line(&[[0.0, needed], [end, needed]], "still", "needed");
    }
    if let Some(ideal) = time.ideal_s {
        plot.line_at(ideal, "gel", "ideal");
    }
    plot.svg("Absorbed drive over time")
}
