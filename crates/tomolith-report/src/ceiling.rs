//! The ceiling of the pixels that a run looked for: what was tried, on pixels of twice the width, and what was chosen.

use super::latitude::ExposureWindow;
use super::number::{self, significant};
use serde::{Deserialize, Serialize};
use tomolith_metrics::Evaluation;
use tomolith_optimize::Gap;

/// How good a print is; None: unknown, as surfaces are where they are left out.
#[derive(Clone, Copy, Debug, Default, PartialEq, Serialize, Deserialize)]
pub struct CeilingQuality {
    /// IoU.
    pub iou: Option<f64>,
    /// VER.
    pub ver: Option<f64>,
    /// Mean deviation of the surface, mm.
    pub surface_mean_mm: Option<f64>,
    /// Γ, %.
    pub gamma: Option<f64>,
}

impl CeilingQuality {
    /// The four in this order; not a number where one is unknown.
    #[must_use]
    pub fn numbers(&self) -> [f64; 4] {
        let all = [self.iou, self.ver, self.surface_mean_mm, self.gamma];
        all.map(|value| value.unwrap_or(f64::NAN))
    }
}

/// A ceiling that was tried.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct CeilingPoint {
    /// Ceiling over the brightest pixel within the bound of the start.
    pub factor: f64,
    /// Of every print.
    #[serde(rename = "prints")]
    pub qualities: Vec<CeilingQuality>,
}

/// What another ceiling than the one found brought on the voxels that the optimization ended on.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct FinestTrial {
    /// The other ceiling over the one found: 2, or 1/√2 where hardly any light lies above that.
    pub tried: f64,
    /// Prints below the ceiling that was found; without surfaces.
    pub before: Vec<CeilingQuality>,
    /// Some iterations later, below the other.
    pub after: Vec<CeilingQuality>,
    /// By how much the ceiling therefore changed; 1: not at all.
    pub changed_by: f64,
}

/// What a search for the lowest ceiling found.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct CeilingReport {
    /// The brightest pixel of all lights within the bound of the start, for the frames of the run, in the unit of patterns.
    pub brightest: f64,
    /// Mean dose in the part where every pixel of every frame of the run is 1, mJ/mm³; 0 with several lights.
    pub even_dose: f64,
    /// Frames times the brightest pixel without a ceiling, of all lights together: what pixels that are always white would send.
    pub white: f64,
    /// What was tried, in order; the first is without a ceiling.
    pub points: Vec<CeilingPoint>,
    /// Which of them was chosen; None where none below the bound of the start is good enough.
    pub chosen: Option<usize>,
    /// That one on the finest voxels, once it was tried there.
    pub finest: Option<FinestTrial>,
}

/// Quality at a print time: a ceiling, and what it prints; of several prints the worst numbers.
#[derive(Clone, Copy, Debug, Default, PartialEq, Serialize, Deserialize)]
pub struct TradeOff {
    /// The brightest pixel, in the unit of patterns.
    pub brightest: f64,
    /// N·M/t, mm.
    pub print_time_mm: Option<f64>,
    /// Where the job's power and critical dose are known.
    pub time_s: Option<f64>,
    /// IoU.
    pub iou: Option<f64>,
    /// VER.
    pub ver: Option<f64>,
    /// Mean deviation of the surface, mm.
    pub surface_mean_mm: Option<f64>,
    /// Whether the run took it.
    pub is_chosen: bool,
    /// Whether the numbers are those of the run's evaluation, and not of pixels of twice the width: those had another ceiling than the
    /// run.
    pub is_evaluated: bool,
}

/// What a run prints of a species, and over which exposures.
#[derive(Clone, Copy, Debug)]
pub struct RunPrint<'a> {
    /// Its numbers.
    pub evaluation: &'a Evaluation,
    /// The exposures, where they are known.
    pub exposure: Option<&'a ExposureWindow>,
}

impl RunPrint<'_> {
    /// A number at the best exposure; None where the report's is that of another one.
    fn at_best(&self, name: &str) -> Option<f64> {
        let reported = self.exposure?.reported_percent?;
        let value = self.evaluation.measures.get(name);
        value.filter(|v| v.is_finite() && (reported - 100.0).abs() < 1e-7)
    }
}

impl CeilingReport {
    /// The ceilings that were tried, the longest print first, with the times of a run that ended with these prints, one a species, and with this brightest pixel.
    #[must_use]
    pub fn trade_off(&self, prints: &[RunPrint<'_>], brightest: f64) -> Vec<TradeOff> {
        let Some(RunPrint {
            evaluation,
            exposure,
        }) = prints.first()
        else {
            return Vec::new();
        };
        // All at the best exposure, which is not the reported one where the job names a threshold
        let dose = exposure.and_then(|window| window.dose?.best);
        let seconds = exposure.and_then(|window| window.time_s?.best);
        let mm = evaluation
            .measures
            .get("print_time_mm")
            .filter(|v| v.is_finite());
        let known = mm
            .zip(dose)
            .zip(exposure.and_then(|window| window.reported_percent));
        let white_of_run = known.map(|((mm, dose), percent)| mm * dose / percent * 100.0);
        let at = |brightest: f64, white: f64| TradeOff {
            brightest,
            print_time_mm: dose.map(|dose| white / dose),
            time_s: seconds
                .zip(white_of_run)
                .map(|(s, of_run)| s * white / of_run),
            ..TradeOff::default()
        };
        let changed_by = self.finest.as_ref().map_or(1.0, |trial| trial.changed_by);
        let is_changed = (changed_by - 1.0).abs() > 1e-9;
        let tried = |(i, point): (usize, &CeilingPoint)| {
            let of_point = |k: usize, worse: fn(f64, f64) -> f64| {
                let values = point.qualities.iter().map(|quality| quality.numbers()[k]);
                values.filter(|value| value.is_finite()).reduce(worse)
            };
            TradeOff {
                iou: of_point(0, f64::min),
                ver: of_point(1, f64::max),
                surface_mean_mm: of_point(2, f64::max),
                is_chosen: self.chosen == Some(i) && !is_changed,
                ..at(self.brightest * point.factor, self.white * point.factor)
            }
        };
        // Its brightest pixel may lie below its ceiling
        let white = match self.chosen {
            Some(_) if !is_changed => None,
            Some(i) => white_of_run.or(Some(self.white * self.points[i].factor * changed_by)),
            None => white_of_run,
        };
        let of_run = |value: fn(&RunPrint<'_>) -> Option<f64>, worse: fn(f64, f64) -> f64| {
            let values: Option<Vec<f64>> = prints.iter().map(value).collect();
            values?.into_iter().reduce(worse)
        };
        let run_row = white.map(|white| TradeOff {
            iou: of_run(|print| print.exposure.map(|window| window.best), f64::min),
            ver: of_run(|print| print.at_best("ver"), f64::max),
            surface_mean_mm: of_run(|print| print.at_best("surface_mean_mm"), f64::max),
            is_chosen: true,
            is_evaluated: true,
            ..at(brightest, white)
        });
        let tried = self.points.iter().enumerate().map(tried);
        let mut rows: Vec<TradeOff> = tried.chain(run_row).collect();
        rows.sort_by(|a, b| b.brightest.total_cmp(&a.brightest));
        rows
    }

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
                "{found}on pixels of twice the width that changes IoU by {} and VER by {}",
                number::change(change(0), 4),
                number::change(change(1), 4),
            ),
        }
    }

    /// Warns of a ceiling that had to rise.
    #[must_use]
    pub fn warning(&self) -> Option<String> {
        let trial = self
            .finest
            .as_ref()
            .filter(|trial| trial.changed_by > 1.0)?;
        Some(format!(
            "the ceiling of the pixels that was found on a coarser level makes the print worse than bounds.tolerance allows: {0}. It was raised to {1} times, and the print takes up to {1} times as \
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
            "on the finest voxels {} times the ceiling changed IoU by {}, VER by {} and Γ by {} %",
            significant(self.tried, 3),
            number::change(change(0), 4),
            number::change(change(1), 4),
            number::change(
                100.0 * change(3)
                    / self
                        .before
                        .first()
                        .map_or(f64::NAN, |print| print.numbers()[3]),
                1
            ),
        )
    }
}

/// By how much a number of the first print differs.
fn change(i: usize, [from, to]: [&[CeilingQuality]; 2]) -> f64 {
    let number_of =
        |prints: &[CeilingQuality]| prints.first().map_or(f64::NAN, |print| print.numbers()[i]);
    number_of(to) - number_of(from)
}

/// How far a loss is from the lowest one; None where the bound says nothing that a loss above 0 does not.
#[must_use]
pub fn gap_sentence(gap: Gap) -> Option<String> {
    let percent = 100.0 * gap.relative();
    (gap.bound > 0.0).then(|| {
        format!(
            "no patterns within the bounds have a loss below {} ({} % below that of these patterns)",
            significant(gap.bound, 5),
            significant(percent, 3)
        )
    })
}

/// How long a print takes, in a sentence: N·M/t, and how many times an even exposure where its dose is known. None for prints without a time.
#[must_use]
pub fn time_sentence(
    print_time_mm: Option<f64>,
    ceiling: Option<&CeilingReport>,
) -> Option<String> {
    let time = print_time_mm?;
    let even = ceiling
        .map(|ceiling| time * ceiling.even_dose * ceiling.brightest / ceiling.white)
        .filter(|times| times.is_finite() && *times > 0.0);
    let even = even.map_or_else(String::new, |times| {
        format!(
            ": {} times as long as an even exposure of all pixels",
            significant(times, 2)
        )
    });
    Some(format!(
        "Print time N·M/t {} mm (frames times brightest pixel over gel dose){even}.",
        significant(time, 3)
    ))
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::tests::Sample;
    use tomolith_core::near;
    use tomolith_core::response::Identity;

    fn ceiling(changed_by: f64) -> CeilingReport {
        let point = |factor: f64| CeilingPoint {
            factor,
            qualities: vec![
                CeilingQuality {
                    iou: Some(0.9 + 0.01 * factor),
                    ver: Some(0.1),
                    surface_mean_mm: Some(0.01),
                    gamma: Some(5.0),
                },
                CeilingQuality {
                    iou: Some(0.95),
                    ver: Some(0.2),
                    ..CeilingQuality::default()
                },
            ],
        };
        CeilingReport {
            brightest: 8.0,
            even_dose: 1.0,
            white: 80.0,
            points: [1.0, 0.5, 0.25].map(point).to_vec(),
            chosen: Some(1),
            finest: Some(FinestTrial {
                tried: 2.0,
                before: Vec::new(),
                after: Vec::new(),
                changed_by,
            }),
        }
    }

    #[test]
    fn a_ceiling_that_the_finest_voxels_changed_has_a_row_of_its_own() {
        let mut evaluation = Sample::new().evaluation();
        let dose = evaluation.gel_threshold.unwrap();
        let measures = evaluation.measures.0.iter_mut();
        let print_time_mm = measures.filter(|(name, _)| *name == "print_time_mm");
        print_time_mm.for_each(|(_, value)| *value = Some(50.0 / dose));
        let window = ExposureWindow::new(&evaluation, &Identity, Some(30.0)).unwrap();
        fn print<'a>(evaluation: &'a Evaluation, window: &'a ExposureWindow) -> RunPrint<'a> {
            RunPrint {
                evaluation,
                exposure: Some(window),
            }
        }
        let rows = |by: f64| ceiling(by).trade_off(&[print(&evaluation, &window)], 5.0);
        let chosen = |rows: &[TradeOff]| rows.iter().position(|row| row.is_chosen);
        let same = rows(1.0);
        assert_eq!((same.len(), chosen(&same)), (3, Some(1)));
        // Of two prints the worse
        assert_eq!((same[0].iou, same[0].ver), (Some(0.91), Some(0.2)));
        assert_eq!(same[0].surface_mean_mm, Some(0.01));
        let raised = rows(1.5);
        assert_eq!((raised.len(), chosen(&raised)), (4, Some(1)));
        let of_run = |name| evaluation.measures.get(name);
        assert!(raised[1].is_evaluated && raised[1].iou == of_run("iou"));
        assert_eq!(raised[1].ver, of_run("ver"));
        // The run itself takes 30 s: its brightest pixel of 5 counts, not a ceiling of 6 that none reaches
        near!(raised[1].brightest, 5.0, 1e-9);
        near!(raised[1].print_time_mm.unwrap(), 50.0 / dose, 1e-9);
        near!(raised[1].time_s.unwrap(), 30.0, 1e-9);
        near!(raised[0].time_s.unwrap(), 30.0 * 8.0 / 5.0, 1e-9);
        // Of two species the worse
        let mut other = evaluation.clone();
        let ver = other
            .measures
            .0
            .iter_mut()
            .filter(|(name, _)| *name == "ver");
        ver.for_each(|(_, value)| *value = Some(0.7));
        let both = [print(&evaluation, &window), print(&other, &window)];
        assert_eq!(ceiling(1.5).trade_off(&both, 5.0)[1].ver, Some(0.7));
        // The bound of the start is not what was tried on wider pixels
        let without = CeilingReport {
            chosen: None,
            finest: None,
            ..ceiling(1.0)
        };
        let rows = without.trade_off(&[print(&evaluation, &window)], 5.0);
        let chosen = rows.iter().find(|row| row.is_chosen).unwrap();
        assert!(chosen.is_evaluated && rows.len() == 4);
        near!(chosen.print_time_mm.unwrap(), 50.0 / dose, 1e-9);
        // Of a job that names a threshold 4/5 as high the print in the report lasts a quarter longer than the best one
        evaluation.gel_threshold = evaluation.gel_threshold.map(|best| 0.8 * best);
        let measures = evaluation.measures.0.iter_mut();
        let print_time_mm = measures.filter(|(name, _)| *name == "print_time_mm");
        print_time_mm.for_each(|(_, value)| *value = Some(50.0 / (0.8 * dose)));
        let reported = ExposureWindow::new(&evaluation, &Identity, Some(37.5)).unwrap();
        let named = without.trade_off(&[print(&evaluation, &reported)], 5.0);
        for (named, best) in named.iter().zip(&rows) {
            near!(named.brightest, best.brightest, 1e-9);
            near!(
                named.print_time_mm.unwrap(),
                best.print_time_mm.unwrap(),
                1e-9
            );
            near!(named.time_s.unwrap(), best.time_s.unwrap(), 1e-9);
        }
    }
}
