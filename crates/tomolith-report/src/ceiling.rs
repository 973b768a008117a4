//! The ceiling of the pixels that a run looked for: what was tried, on pixels of twice the width, and what was chosen.

use super::number::significant;
use serde_json::{Value, json};

/// IoU, VER, mean surface deviation (mm) and Γ (%) of a print.
pub type Quality = [f64; 4];

/// A ceiling that was tried.
#[derive(Clone, Debug, PartialEq)]
pub struct CeilingPoint {
    /// Ceiling over the brightest pixel within the bound of the start.
    pub factor: f64,
    /// Of every print.
    pub qualities: Vec<Quality>,
}

/// What another ceiling than the one found brought on the voxels that the optimization ended on.
#[derive(Clone, Debug, PartialEq)]
pub struct FinestTrial {
    /// The other ceiling over the one found: 2, or 1/√2 where hardly any light lies above that.
    pub tried: f64,
    /// Prints below the ceiling that was found; without surfaces.
    pub before: Vec<Quality>,
    /// Some iterations later, below the other.
    pub after: Vec<Quality>,
    /// By how much the ceiling therefore changed; 1: not at all.
    pub changed_by: f64,
}

/// What a search for the lowest ceiling found.
#[derive(Clone, Debug, PartialEq)]
pub struct CeilingReport {
    /// The brightest pixel of all lights within the bound of the start, for the frames of the run, mJ/mm².
    pub brightest: f64,
    /// Mean dose in the part where every pixel of every frame of the run is 1, mJ/mm³.
    pub even_dose: f64,
    /// What was tried, in order; the first is without a ceiling.
    pub points: Vec<CeilingPoint>,
    /// Which of them was chosen; None where none below the bound of the start is good enough.
    pub chosen: Option<usize>,
    /// That one on the finest voxels, once it was tried there.
    pub finest: Option<FinestTrial>,
}

impl CeilingReport {
    /// In words.
    #[must_use]
    pub fn sentence(&self) -> String {
        let Some(point) = self.chosen.map(|i| &self.points[i]) else {
            return "pixels may be as bright as the brightest of the start: with a lower ceiling the part prints worse on pixels of twice the width".to_owned();
        };
        let change = |i: usize| change(i, [&self.points[0].qualities, &point.qualities]);
        let changed_by = self.finest.as_ref().map_or(1.0, |trial| trial.changed_by);
        let factor = point.factor * changed_by;
        let found = format!(
            "no pixel is brighter than {}, which makes the print last {} % as long as without a ceiling; ",
            significant(self.brightest * factor, 3),
            significant(100.0 * factor, 2),
        );
        match &self.finest {
            Some(trial) if changed_by != 1.0 => found + &trial.sentence(),
            _ => format!(
                "{found}on pixels of twice the width that changes IoU by {:+.4} and VER by {:+.4}",
                change(0),
                change(1),
            ),
        }
    }

    /// Warns of a ceiling that had to rise.
    #[must_use]
    pub fn warning(&self) -> Option<String> {
        let trial = self.finest.as_ref().filter(|own| own.changed_by > 1.0)?;
        Some(format!(
            "the ceiling of the pixels that was found on a coarser level makes the print worse than bounds.tolerance allows: {}. It was raised, and the print takes {} times as \
             long; for the faster print raise bounds.tolerance, for the brightest pixels set bounds.ceiling = \"start\"",
            trial.sentence(),
            significant(trial.changed_by, 3)
        ))
    }
}

impl FinestTrial {
    /// What the other ceiling brought.
    fn sentence(&self) -> String {
        let change = |i: usize| change(i, [&self.before, &self.after]);
        format!(
            "on the finest voxels {} times the ceiling changed IoU by {:+.4}, VER by {:+.4} and Γ by {:+.1} %",
            significant(self.tried, 3),
            change(0),
            change(1),
            100.0 * change(3) / self.before.first().map_or(f64::NAN, |own| own[3]),
        )
    }
}

/// By how much a number of the first print differs.
fn change(i: usize, [from, to]: [&[Quality]; 2]) -> f64 {
    let of = |prints: &[Quality]| prints.first().map_or(f64::NAN, |own| own[i]);
    of(to) - of(from)
}

/// How long a print takes, in a sentence: M/t, and how many times an even exposure where its dose is known. None for prints without a time.
#[must_use]
pub fn time_sentence(time_mm: Option<f64>, ceiling: Option<&CeilingReport>) -> Option<String> {
    let time = time_mm?;
    let even = ceiling
        .map(|own| time * own.even_dose)
        .filter(|times| times.is_finite() && *times > 0.0);
    let even = even.map_or_else(String::new, |times| {
        format!(
            ": {} times as long as an even exposure of all pixels",
            significant(times, 2)
        )
    });
    Some(format!(
        "Print time M/t {} mm (brightest pixel over gel dose){even}.",
        significant(time, 3)
    ))
}

/// For `report.json`.
pub(super) fn ceiling_json(ceiling: &CeilingReport) -> Value {
    let number = |value: f64| {
        Some(value)
            .filter(|v| v.is_finite())
            .map_or(Value::Null, Value::from)
    };
    let quality = |[iou, ver, mean, gamma]: &Quality| json!({ "iou": number(*iou), "ver": number(*ver), "surface_mean_mm": number(*mean), "gamma": number(*gamma) });
    let prints = |own: &[Quality]| own.iter().map(quality).collect::<Vec<_>>();
    let point = |point: &CeilingPoint| json!({ "factor": point.factor, "prints": prints(&point.qualities) });
    let finest = |trial: &FinestTrial| {
        let [before, after] = [&trial.before, &trial.after].map(|own| prints(own));
        json!({ "tried": trial.tried, "before": before, "after": after, "changed_by": trial.changed_by })
    };
    json!({
        "brightest": number(ceiling.brightest),
        "even_dose": number(ceiling.even_dose),
        "chosen": ceiling.chosen,
        "points": ceiling.points.iter().map(point).collect::<Vec<_>>(),
        "finest": ceiling.finest.as_ref().map(finest),
    })
}
