//! Sentences of the page: plain text, keys between grave accents.

use crate::number::significant;
use crate::{ReportData, SpeciesReport, gap_sentence, time_sentence};
use serde::Serialize;
use tomolith_core::units::counted;
use tomolith_metrics::Evaluation;

/// A sentence about one of several things.
#[derive(Serialize)]
pub(super) struct Named<'a> {
    name: &'a str,
    sentence: String,
}

/// See the [module page](self).
#[derive(Serialize)]
pub(super) struct Texts<'a> {
    /// The result.
    pub(super) lead: String,
    print_time: Option<String>,
    facts: Vec<(String, String)>,
    exposure: Vec<String>,
    limits: Vec<Named<'a>>,
    one_exposure: Option<String>,
    one_moment: Option<String>,
    time: Vec<Named<'a>>,
    scenarios: Option<String>,
    gap: Option<String>,
    ceiling: Option<String>,
}

impl<'a> Texts<'a> {
    pub(super) fn of(data: &'a ReportData<'a>) -> Self {
        let evaluation = data.first().evaluation;
        let print_time_mm = evaluation.measures.get("print_time_mm");
        Texts {
            lead: spoiled(data) + &sentence(evaluation) + &first_of(data),
            print_time: time_sentence(print_time_mm, data.ceiling),
            facts: facts(data),
            exposure: exposures(data),
            limits: limits(data),
            one_exposure: data.one_exposure.map(crate::OneExposure::sentence),
            one_moment: data.one_moment.as_ref().map(crate::OneMoment::sentence),
            time: (data.time.iter())
                .map(|network| Named {
                    name: &network.name,
                    sentence: network.sentence(),
                })
                .collect(),
            scenarios: data.scenarios.map(crate::ScenarioTable::sentence),
            gap: data.gap.and_then(gap_sentence),
            ceiling: data.ceiling.map(crate::CeilingReport::sentence),
        }
    }
}

/// Facts of the job, then of each light.
fn facts(data: &ReportData<'_>) -> Vec<(String, String)> {
    let lights = data.lights.iter().map(|light| {
        let g = &light.patterns.grid;
        let wave = light.wavelength_nm;
        let wave = wave.map_or(String::new(), |nm| format!(", {} nm", significant(nm, 4)));
        let (frames, columns, rows, bits) = (g.frames(), g.columns, g.rows, light.bits);
        (
            format!("Light {}", light.name).trim_end().to_owned(),
            format!(
                "{} of {columns} × {rows}, {bits} bit{wave}",
                counted(frames, "frame")
            ),
        )
    });
    data.facts.iter().cloned().chain(lights).collect()
}

/// Over which exposures the print of each species stays nearly as good, or why the report cannot say so.
fn exposures(data: &ReportData<'_>) -> Vec<String> {
    if data.species.len() > 1 {
        let sentence_of = |species: &SpeciesReport<'_>| {
            let window = species.exposure.as_ref()?;
            Some(format!("{}: {}", species.name, window.sentence()))
        };
        return data.species.iter().filter_map(sentence_of).collect();
    }
    let first = data.first();
    let iou = first.evaluation.measures.get("iou");
    vec![match &first.exposure {
        Some(window) => window.sentence(),
        None if iou.is_none_or(|iou| iou == 0.0) => {
            "No exposure is the best: nothing of the part prints at any threshold.".to_owned()
        }
        None => {
            "No exposure is the best: the response is not the dose itself, so that more light does not scale the gray values.".to_owned()
        }
    }]
}

fn limits<'a>(data: &ReportData<'a>) -> Vec<Named<'a>> {
    let is_only = data.species.len() == 1;
    let limits_of = |species: &SpeciesReport<'a>| Named {
        name: if is_only { "" } else { species.name },
        sentence: species.limits.sentence.clone(),
    };
    data.species.iter().map(limits_of).collect()
}

/// Which of several species the headline is about, and what all of them reach together.
fn first_of(data: &ReportData<'_>) -> String {
    let (first, others) = (data.first(), &data.species[1..]);
    let Some(one) = data.one_exposure else {
        let sentence_of =
            |other: &SpeciesReport<'_>| format!(" {}: {}", other.name, sentence(other.evaluation));
        let others: String = others.iter().map(sentence_of).collect();
        return match others.is_empty() {
            true => others,
            false => format!(" That is {}.{others}", first.name),
        };
    };
    let iou_of = |(species, iou): (&SpeciesReport<'_>, &f64)| {
        format!("{} {}", species.name, significant(*iou, 4))
    };
    let all: Vec<String> = data.species.iter().zip(&one.iou).map(iou_of).collect();
    format!(
        " These numbers are of {} at its own best exposure. At one exposure for all the species reach {}.",
        first.name,
        all.join(", ")
    )
}

/// What spoils the print comes first.
fn spoiled(data: &ReportData<'_>) -> String {
    let spoiled = data.first().limits.spoiled.as_ref();
    spoiled.map_or_else(String::new, |text| format!("{text} "))
}

/// The result in words.
fn sentence(evaluation: &Evaluation) -> String {
    let get = |name| evaluation.measures.get(name);
    if let (Some(half_width), Some(in_band), Some(rms)) =
        (evaluation.half_width, get("in_band"), get("rms_error"))
    {
        return format!(
            "The response of {} % of the voxels lies within ±{} of the target's gray value; the rms error is {}.",
            significant(100.0 * in_band, 3),
            significant(half_width, 3),
            significant(rms, 3),
        );
    }
    let (Some(iou), Some(over), Some(under), Some(threshold)) = (
        get("iou"),
        get("over_mm3"),
        get("under_mm3"),
        evaluation.gel_threshold,
    ) else {
        return evaluation.notes.join(" ");
    };
    let surface = get("surface_mean_mm").map_or_else(String::new, |mean| {
        let mean = significant(mean * 1e3, 2);
        format!(" Its surface is {mean} µm off on average.")
    });
    format!(
        "At a gel threshold of {} the predicted print and the part overlap with an IoU of {} on voxels of {} µm: {}.{surface}",
        significant(threshold, 3),
        significant(iou, 4),
        significant(1e3 * evaluation.grid.pitch_mm, 3),
        differences([over, under]),
    )
}

/// What gels that should not, and what does not gel that should, mm³.
fn differences([over, under]: [f64; 2]) -> String {
    let mm3 = |volume: f64| format!("{} mm³", significant(volume, 2));
    match [over, under].map(|volume| volume > 0.0) {
        [false, false] => "all of the part gels, and nothing else".to_owned(),
        [true, false] => format!("all of the part gels, and {} besides", mm3(over)),
        [false, true] => format!(
            "{} of the part does not gel, and nothing gels that should not",
            mm3(under)
        ),
        [true, true] => format!(
            "{} gels that should not, {} does not gel that should",
            mm3(over),
            mm3(under)
        ),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn what_is_right_is_said_in_plain_words() {
        assert_eq!(
            differences([0.0; 2]),
            "all of the part gels, and nothing else"
        );
        assert_eq!(
            differences([0.5, 0.0]),
            "all of the part gels, and 0.5 mm³ besides"
        );
        assert_eq!(
            differences([0.0, 0.5]),
            "0.5 mm³ of the part does not gel, and nothing gels that should not"
        );
        assert!(differences([0.5; 2]).starts_with("0.5 mm³ gels that should not, 0.5 mm³ does"));
    }
}
