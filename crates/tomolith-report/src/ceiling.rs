//! The ceiling of the pixels that a run looked for: what was tried, on pixels of twice the width, and what was chosen.

use super::number::significant;
use serde_json::{Value, json};

/// A ceiling that was tried.
#[derive(Clone, Debug, PartialEq)]
pub struct CeilingPoint {
    /// Ceiling over the brightest pixel within the bound of the start.
    pub factor: f64,
    /// IoU, VER, mean surface deviation (mm) and Γ (%) of every print.
    pub qualities: Vec<[f64; 4]>,
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
}

impl CeilingReport {
    /// In words.
    #[must_use]
    pub fn sentence(&self) -> String {
        let Some(point) = self.chosen.map(|i| &self.points[i]) else {
            return "pixels may be as bright as the brightest of the start: with a lower ceiling the part prints worse on pixels of twice the width".to_owned();
        };
        let of =
            |point: &CeilingPoint, i: usize| point.qualities.first().map_or(f64::NAN, |own| own[i]);
        let change =
            |i: usize| of(point, i) - self.points.first().map_or(f64::NAN, |first| of(first, i));
        format!(
            "no pixel is brighter than {}, which makes the print last {} % as long as without a ceiling; on pixels of twice the width that changes IoU by {:+.4} \
             and VER by {:+.4}",
            significant(self.brightest * point.factor, 3),
            significant(100.0 * point.factor, 2),
            change(0),
            change(1),
        )
    }
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
    let quality = |[iou, ver, mean, gamma]: &[f64; 4]| json!({ "iou": number(*iou), "ver": number(*ver), "surface_mean_mm": number(*mean), "gamma": number(*gamma) });
    let point = |point: &CeilingPoint| {
        let prints: Vec<Value> = point.qualities.iter().map(quality).collect();
        json!({ "factor": point.factor, "prints": prints })
    };
    json!({
        "brightest": number(ceiling.brightest),
        "even_dose": number(ceiling.even_dose),
        "chosen": ceiling.chosen,
        "points": ceiling.points.iter().map(point).collect::<Vec<_>>(),
    })
}
