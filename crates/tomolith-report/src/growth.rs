//! The part as it grows: pictures of some moments, and a slider over them.
//!
//! A picture shows while its radio button is pressed, which needs no script. The page's [`SCRIPT`] hides the buttons and presses them from a slider
//! (`<input type="range">`); a browser that runs no scripts shows the buttons.

use super::figures::growth;
use super::number::significant;
use super::time::TimeReport;
use std::fmt::Write as _;

/// Turns the buttons of every [`slider`] of a page into one; stands behind them.
pub(super) const SCRIPT: &str = concat!("<script>", include_str!("growth.js"), "</script>");

/// The section's part of a network; `number` tells the sliders of a page apart. Empty without snapshots.
pub(super) fn slider(time: &TimeReport<'_>, number: usize) -> String {
    let [Some(first), Some(last)] = [time.snapshots.first(), time.snapshots.last()] else {
        return String::new();
    };
    let best = time.phases_s[1].unwrap_or(0.0);
    let off = |i: usize| (time.snapshots[i].0 - best).abs();
    let all = 0..time.snapshots.len();
    let shown = all.min_by(|&a, &b| off(a).total_cmp(&off(b))).unwrap_or(0);
    let mut out = format!(
        "<h3>As it grows</h3><div class=\"growth\"><div class=\"scale-of-time\" hidden><span>{} s</span>\
         <input type=\"range\" min=\"0\" max=\"{}\" step=\"1\" value=\"{shown}\" aria-label=\"Moment of the print\"><span>{} s</span></div>",
        significant(first.0, 3),
        time.snapshots.len() - 1,
        significant(last.0, 3),
    );
    for (i, (seconds, degree)) in time.snapshots.iter().enumerate() {
        let checked = if i == shown { " checked" } else { "" };
        let _ = write!(
            out,
            "<input type=\"radio\" name=\"growth{number}\" id=\"growth{number}-{i}\"{checked}>\
             <label for=\"growth{number}-{i}\">{}</label><div class=\"grown\"><p>{}</p>{}</div>",
            moment(time, *seconds),
            solid(time, *seconds),
            growth(time.labels, degree),
        );
    }
    out.push_str("</div>");
    out
}

/// "36 s, best".
fn moment(time: &TimeReport<'_>, seconds: f64) -> String {
    let is_best = time.phases_s[1] == Some(seconds);
    let note = if is_best { ", best" } else { "" };
    format!("{} s{note}", significant(seconds, 3))
}

/// What is solid then, in words.
fn solid(time: &TimeReport<'_>, seconds: f64) -> String {
    let [part, void] = time.solid_at(seconds).map(percent);
    format!(
        "<b>{}</b>: {part} of the part and {void} of the void are solid.",
        moment(time, seconds)
    )
}

/// All of it is said only where it is all.
fn percent(share: f64) -> String {
    let said = significant(100.0 * share, 3);
    match said.as_str() {
        "100" if share < 1.0 => "over 99.9 %".to_owned(),
        _ => format!("{said} %"),
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::time::TimePoint;
    use tomolith_core::grid::{Volume, VolumeGrid};
    use tomolith_core::target::label::{PART, VOID};

    fn point(seconds: f64, solid: [f64; 2]) -> TimePoint {
        TimePoint {
            seconds,
            imbued_mj: 0.0,
            contribution_mj: 0.0,
            contrast: 0.0,
            printed_contrast: 0.0,
            jaccard: solid[0] - solid[1],
            solid,
            sent_mj: 0.0,
        }
    }

    #[test]
    fn a_slider_has_a_stop_per_picture_and_says_what_is_solid_there() {
        let grid = VolumeGrid::centered([2, 4, 4], 0.1);
        let labels = (0..grid.len()).map(|i| if i % 4 < 2 { PART } else { VOID });
        let labels = Volume {
            values: labels.collect(),
            grid: grid.clone(),
        };
        let degree = |d: f32| Volume::filled(grid.clone(), d);
        let snapshots = [(0.0, degree(0.0)), (15.0, degree(0.8)), (30.0, degree(1.2))];
        let points = vec![
            point(0.0, [0.0, 0.0]),
            point(10.0, [0.5, 0.0]),
            point(20.0, [0.9, 0.1]),
            point(30.0, [0.9999, 0.25]),
        ];
        let mut time = TimeReport {
            name: "resin",
            points,
            requirement_mj: None,
            ideal_s: None,
            reached: None,
            phases_s: [Some(5.0), Some(15.0)],
            evaluation: None,
            snapshots: &snapshots,
            labels: &labels,
        };
        let page = slider(&time, 7);
        let range = "<input type=\"range\" min=\"0\" max=\"2\" step=\"1\" value=\"1\"";
        assert!(page.contains(range), "{page}");
        assert_eq!(page.matches("type=\"radio\" name=\"growth7\"").count(), 3);
        assert_eq!(page.matches(" checked").count(), 1);
        // Half way between two moments of the curves
        let best = "<b>15 s, best</b>: 70 % of the part and 5 % of the void are solid.";
        assert!(page.contains(best), "{page}");
        assert!(page.contains("<b>30 s</b>: over 99.9 % of the part and 25 % of"));
        time.snapshots = &[];
        assert_eq!(slider(&time, 0), "");
    }

    #[test]
    fn the_script_asks_for_nothing_from_outside() {
        for bad in ["src", "http", "import", "fetch", "eval", "innerHTML"] {
            assert!(!SCRIPT.contains(bad), "{bad}");
        }
        assert_eq!(SCRIPT.matches("</script").count(), 1);
    }
}
