//! What the same patterns print in the job and in its scenarios.
//!
//! All of them gel at one dose, that of the job: nobody knows which scenario a print is. The window over scenarios is the least dose of the
//! part in any of them less the largest of the void in any of them, both trimmed (`evaluate.trim_percent`).

use crate::number::significant;
use serde::Serialize;
use tomolith_metrics::Measure;

/// A scenario; the first one is the job as it is.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct ScenarioRow {
    /// Its name.
    pub name: String,
    /// Best IoU, at the threshold that is best in this scenario.
    pub iou: Measure,
    /// IoU at the job's threshold.
    pub iou_at_threshold: Measure,
    /// Γ, %.
    pub gamma: Measure,
    /// Least response of the part, trimmed.
    pub part_low: Measure,
    /// Largest response of the void, trimmed.
    pub void_high: Measure,
}

/// All scenarios.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct ScenarioTable {
    /// What the optimization minimized over them.
    pub of: &'static str,
    /// The job's threshold.
    pub threshold: Measure,
    /// The job, then its scenarios.
    pub rows: Vec<ScenarioRow>,
    /// Least dose of the part in any of them − largest of the void in any of them.
    pub window: Measure,
    /// The least IoU at the job's threshold.
    pub worst_iou: Measure,
}

impl ScenarioTable {
    /// The table of these rows.
    #[must_use]
    pub fn new(join: &'static str, threshold: Measure, rows: Vec<ScenarioRow>) -> Self {
        let least = |measure_of: fn(&ScenarioRow) -> Measure| -> Measure {
            let all: Option<Vec<f64>> = rows.iter().map(measure_of).collect();
            all?.into_iter().reduce(f64::min)
        };
        let low = least(|row| row.part_low);
        let high = least(|row| row.void_high.map(|high| -high));
        ScenarioTable {
            of: join,
            threshold,
            window: low.zip(high).map(|(low, high)| low + high),
            worst_iou: least(|row| row.iou_at_threshold),
            rows,
        }
    }

    /// The one that prints worst at the job's threshold.
    fn worst(&self) -> Option<&ScenarioRow> {
        let iou = |row: &&ScenarioRow| row.iou_at_threshold.unwrap_or(f64::INFINITY);
        self.rows.iter().min_by(|a, b| iou(a).total_cmp(&iou(b)))
    }

    /// In words.
    #[must_use]
    pub fn sentence(&self) -> String {
        let number = |m: Measure| significant(m.unwrap_or(f64::NAN), 4);
        let job = self.rows.first();
        let alone = job.and_then(|row| row.part_low.zip(row.void_high));
        let count = self.rows.len().saturating_sub(1);
        format!(
            "over the job and {count} scenario{}: IoU at least {} at the job's threshold ({}; the job {}), trimmed window {} (the job {})",
            if count == 1 { "" } else { "s" },
            number(self.worst_iou),
            self.worst().map_or("none", |row| row.name.as_str()),
            number(job.and_then(|row| row.iou_at_threshold)),
            number(self.window),
            number(alone.map(|(low, high)| low - high))
        )
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_window_is_between_the_worst_of_either_side() {
        let row = |iou: f64, low: f64, high: f64| ScenarioRow {
            name: format!("at {iou}"),
            iou: Some(iou),
            iou_at_threshold: Some(iou - 0.01),
            gamma: None,
            part_low: Some(low),
            void_high: Some(high),
        };
        let rows = vec![
            row(0.99, 0.8, 0.5),
            row(0.95, 0.9, 0.75),
            row(0.97, 0.7, 0.4),
        ];
        let table = ScenarioTable::new("mean", Some(0.6), rows);
        assert!((table.window.unwrap() + 0.05).abs() < 1e-12); // 0.7 − 0.75
        assert!((table.worst_iou.unwrap() - 0.94).abs() < 1e-12);
        let text = table.sentence();
        tomolith_core::contains!(text, "2 scenarios", "window −0.05 (the job 0.3)");
        assert!(text.contains("(at 0.95; the job 0.98)"), "{text}");
    }
}
