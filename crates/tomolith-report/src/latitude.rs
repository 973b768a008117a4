//! The best exposure, and how far it may be off: for `report.json`, the page, and the last lines of a run.

use super::number::{significant, told_apart};
use serde::Serialize;
use tomolith_core::response::Response;
use tomolith_metrics::latitude::{Latitude, TOLERANCE};
use tomolith_metrics::{Evaluation, Measure};

/// A range round the best value; an end is none where there is no limit.
#[derive(Clone, Copy, Debug, PartialEq, Serialize)]
pub struct Bracket {
    /// The lowest value that is good enough.
    pub low: Measure,
    /// The best value.
    pub best: Measure,
    /// The highest value that is good enough.
    pub high: Measure,
}

impl Bracket {
    fn of(values: [f64; 3]) -> Self {
        let [low, best, high] = values.map(|v| Some(v).filter(|v| v.is_finite()));
        Bracket { low, best, high }
    }

    pub(super) fn map(self, f: impl Fn(f64) -> f64) -> Self {
        let [low, best, high] = self.ascending().map(|value| value.map(&f));
        Bracket { low, best, high }
    }

    /// From the lowest to the highest.
    #[must_use]
    pub fn ascending(&self) -> [Measure; 3] {
        [self.low, self.best, self.high]
    }
}

/// Over which exposures a print is nearly as good as at the best one.
#[derive(Clone, Copy, Debug, PartialEq, Serialize)]
pub struct ExposureWindow {
    /// What stays nearly as good: `iou` or `rms_error`.
    pub measure: &'static str,
    /// Its value at the best exposure.
    pub best: f64,
    /// By how much it may be worse.
    pub tolerance: f64,
    /// Gel thresholds, in units of the response; none for gray targets. The highest belongs to the shortest exposure: a resin that
    /// gels at twice the dose takes twice the time.
    pub threshold: Option<Bracket>,
    /// The doses of these thresholds, in units of the job.
    pub dose: Option<Bracket>,
    /// Exposures, % of the best one.
    pub percent: Bracket,
    /// Time to print, all lights together, s; none where the job does not give times.
    pub time_s: Option<Bracket>,
    /// The exposure that everything else in the report belongs to, % of the best one: 100 unless the job sets a threshold.
    pub reported_percent: Measure,
}

impl ExposureWindow {
    /// Of an evaluation of this response; `time_s` is the time to print at the evaluation's own threshold. None where nothing
    /// prints, where the print is best for a dose of 0 or below, and for a gray target whose response is not the dose: an exposure does not scale it.
    #[must_use]
    pub fn new(
        evaluation: &Evaluation,
        response: &dyn Response,
        time_s: Option<f64>,
    ) -> Option<Self> {
        match evaluation.latitude? {
            Latitude::Thresholds { iou, at } => {
                let dose_of = |threshold: f64| {
                    if threshold.is_finite() && !response.is_identity() {
                        f64::from(response.inverse(threshold as f32))
                    } else {
                        threshold
                    }
                };
                let dose = at.map(dose_of);
                let [low, best, high] = dose;
                // An exposure scales doses: none brings one to a dose of 0 or below
                if best <= 0.0 {
                    return None;
                }
                // At s times the best exposure, what gels is what got best/s
                let percent = |dose: f64| 100.0 * best / dose;
                let reported = evaluation.gel_threshold.map(|t| percent(dose_of(t)));
                let percents = [high, best, low].map(percent);
                Some(ExposureWindow {
                    threshold: Some(Bracket::of(at)),
                    dose: Some(Bracket::of(dose)),
                    ..Self::of_percent("iou", iou, percents, reported, time_s)
                })
            }
            Latitude::Exposures { rms, at } if response.is_identity() => {
                let [_, best, _] = at;
                let percent = at.map(|factor| 100.0 * factor / best);
                let reported = Some(100.0 / best);
                Some(Self::of_percent(
                    "rms_error",
                    rms,
                    percent,
                    reported,
                    time_s,
                ))
            }
            Latitude::Exposures { .. } => None,
        }
    }

    fn of_percent(
        measure: &'static str,
        best: f64,
        percent: [f64; 3],
        reported_percent: Measure,
        time_s: Option<f64>,
    ) -> Self {
        // A threshold of 0 is reached by any exposure, one that is infinite by none
        let percent = Bracket::of(percent.map(|p| if p > 0.0 { p } else { f64::NAN }));
        let reported_percent = reported_percent.filter(|p| p.is_finite() && *p > 0.0);
        let time_s = time_s.zip(reported_percent);
        ExposureWindow {
            measure,
            best,
            tolerance: TOLERANCE,
            threshold: None,
            dose: None,
            percent,
            time_s: time_s.map(|(s, reported)| percent.map(|percent| s * percent / reported)),
            reported_percent,
        }
    }

    /// The name of the measure for people.
    fn measure_name(&self) -> &'static str {
        if self.measure == "iou" {
            "IoU"
        } else {
            "the rms error"
        }
    }

    /// In words, one or two sentences.
    #[must_use]
    pub fn sentence(&self) -> String {
        let worse = significant(self.tolerance, 2);
        let mut text = match self.dose.and_then(|dose| dose.best) {
            Some(dose) => format!(
                "At the best exposure resin gels at a dose of {}",
                significant(dose, 3)
            ),
            None => format!(
                "The best exposure has an rms error of {}",
                significant(self.best, 3)
            ),
        };
        text += &format!(
            "; {} is at most {worse} worse {} of it",
            self.measure_name(),
            from_to(&self.percent, "%")
        );
        if let Some(time) = &self.time_s {
            text += &times(time);
        }
        text.push('.');
        if let Some(reported) = self.reported_percent
            && (reported - 100.0).abs() >= 0.05
        {
            text += &format!(
                " All other numbers are for {} % of it.",
                significant(reported, 3)
            );
        }
        text
    }
}

/// A range in words: digits enough to tell its ends and its best value apart.
pub(super) fn from_to(bracket: &Bracket, unit: &str) -> String {
    let known: Vec<f64> = bracket.ascending().into_iter().flatten().collect();
    let mut texts = told_apart(&known, 3).into_iter();
    let [low, _, high] = bracket
        .ascending()
        .map(|value| value.and_then(|_| texts.next()));
    match (low, high) {
        (Some(a), Some(b)) => format!("from {a} {unit} to {b} {unit}"),
        (Some(a), None) => format!("from {a} {unit} on"),
        (None, Some(b)) => format!("up to {b} {unit}"),
        (None, None) => "at any".to_owned(),
    }
}

/// Times of exposures and the best of them, s, as the end of a sentence.
pub(super) fn times(time: &Bracket) -> String {
    let best = time.best.map_or_else(String::new, |best| {
        format!(", best {} s", significant(best, 3))
    });
    format!(" ({}{best})", from_to(time, "s"))
}

#[cfg(test)]
mod tests {
    use super::*;
    use tomolith_core::grid::{Volume, VolumeGrid};
    use tomolith_core::response::Identity;
    use tomolith_core::target::label::{PART, VOID};
    use tomolith_metrics::evaluate;
    use tomolith_metrics::print::Print;

    /// Part from 0.75 up, void up to 0.5: every threshold between them is right, 0.625 the best.
    fn evaluation(threshold: Option<f64>) -> Evaluation {
        let grid = VolumeGrid::centered([1, 1, 4], 0.5);
        let labels = Volume::new(grid.clone(), vec![PART, PART, VOID, VOID]);
        let response = Volume::new(grid, vec![0.875, 0.75, 0.5, 0.125]);
        let mut print = Print::new(&labels, &response).unwrap();
        if let Some(threshold) = threshold {
            print = print.with_threshold(threshold).unwrap();
        }
        evaluate(&print)
    }

    /// An evaluation of which these thresholds are good enough.
    fn thresholds(at: [f64; 3]) -> Evaluation {
        Evaluation {
            latitude: Some(Latitude::Thresholds { iou: 0.9, at }),
            ..evaluation(None)
        }
    }

    fn window(evaluation: &Evaluation, time_s: Option<f64>) -> Option<ExposureWindow> {
        ExposureWindow::new(evaluation, &Identity, time_s)
    }

    #[test]
    fn exposures_are_the_thresholds_turned_round_and_times_follow() {
        let window = window(&evaluation(None), Some(50.0)).unwrap();
        let close = |bracket: &Bracket, expected: [f64; 3]| {
            for (found, expected) in bracket.ascending().iter().zip(expected) {
                assert!((found.unwrap() - expected).abs() < 1e-9, "{bracket:?}");
            }
        };
        close(&window.threshold.unwrap(), [0.5, 0.625, 0.75]);
        close(&window.dose.unwrap(), [0.5, 0.625, 0.75]);
        close(&window.percent, [250.0 / 3.0, 100.0, 125.0]);
        close(&window.time_s.unwrap(), [125.0 / 3.0, 50.0, 62.5]);
        assert_eq!(window.reported_percent, Some(100.0));
        assert_eq!(
            window.sentence(),
            "At the best exposure resin gels at a dose of 0.625; IoU is at most 0.01 worse from 83.3 % to 125 % of it \
             (from 41.7 s to 62.5 s, best 50 s)."
        );
    }

    #[test]
    fn a_given_threshold_is_another_exposure_and_its_time_is_the_one_that_is_known() {
        let window = window(&evaluation(Some(0.5)), Some(50.0)).unwrap();
        assert_eq!(window.reported_percent, Some(125.0));
        let times = window.time_s.unwrap().ascending();
        assert_eq!(times[1..], [Some(40.0), Some(50.0)]);
        let text = window.sentence();
        assert!(text.ends_with("All other numbers are for 125 % of it."));
    }

    #[test]
    fn a_narrow_window_has_digits_enough() {
        let narrow = thresholds([0.4999, 0.5, 0.5002]);
        let text = window(&narrow, Some(50.0)).unwrap().sentence();
        let expected = "from 99.96 % to 100.02 % of it (from 62.48 s to 62.51 s";
        tomolith_core::contains!(text, expected);
    }

    #[test]
    fn what_has_no_limit_has_none() {
        let mut evaluation = thresholds([0.0, 0.5, f64::INFINITY]);
        let open = window(&evaluation, None).unwrap();
        assert_eq!(open.percent.ascending(), [None, Some(100.0), None]);
        tomolith_core::contains!(open.sentence(), "at any of it");
        let json = serde_json::to_value(open).unwrap();
        assert!(json["threshold"]["high"].is_null() && json["time_s"].is_null());
        evaluation.latitude = None;
        assert_eq!(window(&evaluation, None), None);
    }

    #[test]
    fn no_exposure_brings_a_dose_to_what_is_not_above_zero() {
        for at in [[-0.4, -0.3, -0.2], [-0.1, 0.0, 0.1]] {
            assert_eq!(window(&thresholds(at), Some(50.0)), None);
        }
    }

    #[test]
    fn a_gray_exposure_is_a_factor_of_what_was_written() {
        let mut evaluation = evaluation(None);
        evaluation.latitude = Some(Latitude::Exposures {
            rms: 0.1,
            at: [1.0, 1.25, 1.5],
        });
        let window = window(&evaluation, None).unwrap();
        assert_eq!(window.percent.ascending(), [80.0, 100.0, 120.0].map(Some));
        assert_eq!(
            (window.reported_percent, window.measure),
            (Some(80.0), "rms_error")
        );
        assert_eq!(
            window.sentence(),
            "The best exposure has an rms error of 0.1; the rms error is at most 0.01 worse from 80 % to 120 % of it. \
             All other numbers are for 80 % of it."
        );
    }
}
