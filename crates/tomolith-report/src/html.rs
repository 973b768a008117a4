//! `report.html`: one page without any outside resource.
//!
//! The best exposure and what limits the print; headline numbers with the vial turning, as it prints, and standing still; dose
//! histogram and IoU over the threshold; the surface in the colors of its deviation; three slices of target, dose and error; the history of the optimization; sinogram and frames; all numbers; times,
//! warnings, the job. Text from outside (part, job, warnings) is escaped. The page needs no script; the
//! one it may have makes a slider of buttons.

mod curves;
mod tables;

use super::ceiling::{self, time_sentence};
use super::figures::{
    BODIES, FATES, LightScale, dose_bar, error_bar, property, shown_half_width, sinogram, slices,
    strip,
};
use super::number::{escape, significant, told_apart};
use super::picture::Color;
use super::species::{drive, together};
use super::{
    MapReport, ReportData, ScenarioTable, SpeciesReport, growth, latitude, limits, objectives,
    relief, time,
};
use std::fmt::Write as _;
use tomolith_metrics::{Evaluation, METRICS, Measure, MetricKind, surface_deviation};

/// Numbers at the head of the page.
const HEADLINE: [&str; 9] = [
    "iou",
    "time_mm",
    "pw",
    "ver",
    "gamma",
    "surface_mean_mm",
    "hausdorff_mm",
    "over_mm3",
    "under_mm3",
];

/// Numbers at the head of the page of a gray target.
const GRAY_HEADLINE: [&str; 4] = ["in_band", "rms_error", "max_error_part", "max_error_void"];

/// The page.
#[must_use]
pub fn report_html(data: &ReportData<'_>) -> String {
    let title = escape(data.part);
    let mut page = format!(
        "<!doctype html>\n<html lang=\"en\"><head><meta charset=\"utf-8\"><title>{title} · Tomolith</title>\
         <meta name=\"viewport\" content=\"width=device-width, initial-scale=1\"><style>{}</style></head><body>",
        include_str!("style.css")
    );
    page.push_str(&head(data));
    page.push_str("<main>");
    for part in [
        first(data),
        warnings(data),
        cards(data),
        curves::dose_plots(data),
        ceiling::section(&data.trade_off()),
        surface(data),
        slices_section(data),
        species(data),
        objectives::section(data.objectives),
        data.scenarios
            .map(ScenarioTable::section)
            .unwrap_or_default(),
        maps(data),
        in_time(data),
        curves::history(data.history),
        patterns(data),
        tables::table(data),
        tables::published(data),
        tables::times_and_movies(data),
        notes(data),
        tables::job(data),
    ] {
        page.push_str(&part);
    }
    let _ = writeln!(
        page,
        "</main><footer>{}{} · Numbers are predictions of a model, not measurements. \
         Doses are relative unless the job says otherwise.</footer></body></html>",
        escape(data.program),
        if data.created.is_empty() {
            String::new()
        } else {
            format!(", {}", escape(data.created))
        },
    );
    page
}

fn head(data: &ReportData<'_>) -> String {
    let mut facts = data.facts.clone();
    for light in &data.lights {
        let g = &light.patterns.grid;
        let wave = light
            .wavelength_nm
            .map_or(String::new(), |nm| format!(", {} nm", significant(nm, 4)));
        let name = if light.name.is_empty() {
            "Light".to_owned()
        } else {
            format!("Light {}", light.name)
        };
        facts.push((
            name,
            format!(
                "{} frames of {} × {}, {} bit{wave}",
                g.frames(),
                g.columns,
                g.rows,
                light.bits
            ),
        ));
    }
    let facts: String = facts
        .iter()
        .map(|(name, value)| format!("<li><b>{}</b>{}</li>", escape(name), escape(value)))
        .collect();
    format!(
        "<header><div class=\"brand\">Tomolith print report</div><h1>{}</h1><p class=\"lead\">{}{}{}</p><ul class=\"facts\">{facts}</ul></header>",
        escape(data.part),
        sentence(data.evaluation),
        first_of(data),
        time_sentence(data.evaluation.measures.get("time_mm"), data.ceiling)
            .map_or_else(String::new, |text| format!(" {}", escape(&text))),
    )
}

/// Which of several species the headline is about, and what all of them reach together.
fn first_of(data: &ReportData<'_>) -> String {
    let Some((first, others)) = data.species.split_first() else {
        return String::new();
    };
    let Some(one) = data.one_exposure else {
        let of = |other: &SpeciesReport<'_>| {
            format!(" {}: {}", escape(other.name), sentence(other.evaluation))
        };
        let others: String = others.iter().map(of).collect();
        return match others.is_empty() {
            true => others,
            false => format!(" That is {}.{others}", escape(first.name)),
        };
    };
    let of = |(species, iou): (&SpeciesReport<'_>, &f64)| {
        format!("{} <b>{}</b>", escape(species.name), significant(*iou, 4))
    };
    let all: Vec<String> = data.species.iter().zip(&one.iou).map(of).collect();
    format!(
        " That is {} alone. At one exposure the species reach {}.",
        escape(first.name),
        all.join(", ")
    )
}

/// What a reader looks for first: how long to expose, and what to change.
fn first(data: &ReportData<'_>) -> String {
    let exposure = latitude::section(data);
    let of_species: Vec<_> = data
        .species
        .iter()
        .map(|own| (own.name, own.limits))
        .collect();
    let limits = match of_species.len() {
        0 | 1 => limits::section(data.limits),
        _ => limits::section_of_species(&of_species),
    };
    format!("<div class=\"two\">{exposure}{limits}</div>")
}

/// The prints of the species beside the first.
fn species(data: &ReportData<'_>) -> String {
    let of = |species: &SpeciesReport<'_>| {
        let own = data.of_species(species);
        format!(
            "<section><h2>Species {}</h2><p class=\"muted\">{}</p><p>{}</p></section>{}{}",
            escape(species.name),
            escape(&drive(species)),
            sentence(species.evaluation),
            curves::dose_plots(&own),
            slices_section(&own),
        )
    };
    let Some((first, others)) = data.species.split_first() else {
        return String::new();
    };
    let intro = if others.is_empty() {
        String::new()
    } else {
        format!(
            "<section><h2>Several species</h2><p>Everything above is about <b>{}</b> ({}). The others follow.</p>{}</section>",
            escape(first.name),
            escape(&drive(first)),
            together(data),
        )
    };
    others
        .iter()
        .fold(intro, |page, species| page + &of(species))
}

/// The print in time.
fn in_time(data: &ReportData<'_>) -> String {
    let own_um = 1e3 * data.evaluation.grid.pitch_mm;
    let together = data.one_moment.as_ref().map_or_else(String::new, |moment| {
        format!(
            "<section><h2>The print in time: when to stop</h2><p>{}</p></section>",
            escape(&moment.sentence())
        )
    });
    let networks = data.time.iter().enumerate();
    let page = networks.fold(together, |page, (i, network)| {
        page + &time::section(network, i, own_um)
    });
    match data.time.iter().all(|network| network.snapshots.is_empty()) {
        true => page,
        false => page + growth::SCRIPT,
    }
}

/// Properties of the printed material.
fn maps(data: &ReportData<'_>) -> String {
    let of = |map: &MapReport<'_>| {
        let name = escape(map.name);
        let Some(spread) = map.spread() else {
            return format!("<section><h2>Predicted {name}</h2><p>Nothing is solid.</p></section>");
        };
        let said = told_apart(&spread, 3);
        let [low, median, high] = [0, 1, 2].map(|i| &said[i]);
        let unit = escape(map.unit);
        format!(
            "<section><h2>Predicted {name}</h2><p>From {low} to {high} {unit} where something is solid, half of it below {median} {unit}. \
             Nothing is drawn where all is liquid.</p>{}</section>",
            property(map)
        )
    };
    data.maps.iter().map(of).collect()
}

/// The surface, for a target that has one.
fn surface(data: &ReportData<'_>) -> String {
    let of_part = data.deviation.filter(|_| !is_gray(data));
    of_part.map_or_else(String::new, |deviation| {
        relief::section(deviation, data.evaluation.grid.pitch_mm)
    })
}

/// The result in words.
fn sentence(evaluation: &Evaluation) -> String {
    let get = |name| evaluation.measures.get(name);
    if let (Some(half_width), Some(in_band), Some(rms)) =
        (evaluation.half_width, get("in_band"), get("rms_error"))
    {
        return format!(
            "The response of <b>{} %</b> of the voxels lies within ±{} of the target's gray value; the rms error is {}.",
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
        return evaluation
            .notes
            .iter()
            .map(|n| escape(n))
            .collect::<Vec<_>>()
            .join(" ");
    };
    let mut text = format!(
        "At a gel threshold of {} the predicted print and the part overlap with an IoU of <b>{}</b> on voxels of {} µm: {}.",
        significant(threshold, 3),
        significant(iou, 4),
        significant(1e3 * evaluation.grid.pitch_mm, 3),
        differences([over, under]),
    );
    if let Some(mean) = get("surface_mean_mm") {
        let _ = write!(
            text,
            " Its surface is {} µm off on average.",
            significant(mean * 1e3, 2)
        );
    }
    text
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

fn warnings(data: &ReportData<'_>) -> String {
    let mut all: Vec<&String> = data.warnings.iter().collect();
    all.extend(&data.evaluation.notes);
    if all.is_empty() {
        return String::new();
    }
    let items: String = all
        .iter()
        .map(|w| format!("<li>{}</li>", escape(w)))
        .collect();
    format!("<section class=\"warn\"><h2>Please note</h2><ul>{items}</ul></section>")
}

/// Choices that were made.
fn notes(data: &ReportData<'_>) -> String {
    if data.notes.is_empty() {
        return String::new();
    }
    let items: String = data
        .notes
        .iter()
        .map(|note| format!("<li>{}</li>", escape(note)))
        .collect();
    format!("<section><h2>How it was computed</h2><ul>{items}</ul></section>")
}

/// A measure with its unit, lengths in µm.
fn shown(kind: &MetricKind, value: Measure, digits: usize) -> (String, &'static str) {
    match (value, kind.unit) {
        (None, _) => ("–".to_owned(), ""),
        (Some(v), "mm") => (significant(v * 1e3, digits), "µm"),
        (Some(v), "response") => (significant(v, digits), ""),
        (Some(v), unit) => (significant(v, digits), unit),
    }
}

/// "1 voxel", "0.24 voxels"
pub(super) fn voxels(count: f64) -> String {
    let count = significant(count, 2);
    let plural = if count == "1" { "" } else { "s" };
    format!("{count} voxel{plural}")
}

/// A length in voxels, in brackets; empty for what is no length.
fn in_voxels(kind: &MetricKind, value: Measure, pitch_mm: f64) -> String {
    value
        .filter(|_| kind.unit == "mm")
        .map_or_else(String::new, |mm| format!("({})", voxels(mm / pitch_mm)))
}

/// Whether gray values were asked for.
fn is_gray(data: &ReportData<'_>) -> bool {
    data.evaluation.half_width.is_some()
}

/// Names of the numbers at the head of the page.
fn headline(data: &ReportData<'_>) -> &'static [&'static str] {
    if is_gray(data) {
        &GRAY_HEADLINE
    } else {
        &HEADLINE
    }
}

fn cards(data: &ReportData<'_>) -> String {
    let mut out = String::from("<div class=\"cards\">");
    for kind in headline(data)
        .iter()
        .filter_map(|name| METRICS.iter().find(|k| k.name == *name))
    {
        let digits = if kind.name == "iou" { 4 } else { 3 };
        let measure = data.evaluation.measures.get(kind.name);
        let (value, unit) = shown(kind, measure, digits);
        let voxels = in_voxels(kind, measure, data.evaluation.grid.pitch_mm);
        let still = data.standing.map_or(String::new(), |standing| {
            let (value, unit) = shown(kind, standing.measures.get(kind.name), digits);
            format!("<div class=\"still\"><span>standing still</span><b>{value} {unit}</b></div>")
        });
        let _ = write!(
            out,
            "<div class=\"card\"><h3>{}</h3><div class=\"big\">{value}<small>{unit} {voxels}</small></div><p>{}{}</p>{still}</div>",
            escape(kind.title),
            escape(kind.summary),
            place(kind, data.evaluation),
        );
    }
    out.push_str("</div>");
    if let Some(standing) = data.standing {
        out.push_str(&turning_note(data.evaluation, standing));
    }
    out
}

/// Where the largest deviation is, for its card.
fn place(kind: &MetricKind, evaluation: &Evaluation) -> String {
    match evaluation.farthest {
        Some(farthest) if kind.name == surface_deviation::HAUSDORFF.name => {
            let [x, y, z] = farthest.at_mm.map(|mm| significant(mm, 3));
            let side = farthest.side.words();
            format!(" It is at x = {x}, y = {y}, z = {z} mm: {side}.")
        }
        _ => String::new(),
    }
}

/// Why there are two values.
fn turning_note(turning: &Evaluation, standing: &Evaluation) -> String {
    let (name, title) = if turning.half_width.is_some() {
        ("rms_error", "rms error")
    } else {
        ("pw", "process window")
    };
    let window = match (turning.measures.get(name), standing.measures.get(name)) {
        (Some(turning), Some(standing)) => format!(
            " Here the {title} is {} standing still and {} turning.",
            significant(standing, 3),
            significant(turning, 3)
        ),
        _ => String::new(),
    };
    if turning.sub_angles == 1 {
        return String::new();
    }
    format!(
        "<section><h2>Turning and standing still</h2><p>The vial keeps turning while a frame is shown, so the frame's light lands all along its arc. The large numbers include this \
         ({} positions per frame); “standing still” is what the same patterns would do if the vial stood still during each frame.{window} \
         More frames per turn bring the two together.</p></section>",
        turning.sub_angles,
    )
}

/// Colors and what they stand for.
fn legend(of: impl Iterator<Item = (Color, &'static str)>) -> String {
    let entry = |([r, g, b, a], name): (Color, &str)| {
        let alpha = f64::from(a) / 255.0;
        format!("<span><i style=\"background:rgba({r},{g},{b},{alpha:.2})\"></i>{name}</span>")
    };
    of.map(entry).collect()
}

fn slices_section(data: &ReportData<'_>) -> String {
    let is_there = |mark: u8| data.bodies.is_some_and(|b| b.values.contains(&mark));
    let bodies = BODIES.iter().filter(|(mark, ..)| is_there(*mark));
    let bodies = bodies.map(|(_, color, name)| (*color, *name));
    if let Some(half_width) = shown_half_width(data.evaluation) {
        return format!(
            "<section><h2>Slices through the middle of the image</h2><p class=\"muted\">The gray values of the target, the response to the dose, and the difference. \
             Where a pixel stands for several voxels, it shows the largest difference.</p>{}<div class=\"legends\">{}{}<div class=\"fates\">{}</div></div></section>",
            slices(data),
            dose_bar(data),
            error_bar(half_width),
            legend(bodies),
        );
    }
    let fates = FATES.iter().copied().filter(|(_, name)| !name.is_empty());
    let fates = legend(fates.chain(bodies));
    format!(
        "<section><h2>Slices through the middle of the part's box</h2><p class=\"muted\">The target, the dose with the part's outline in white, and the errors of the print. \
         Where a pixel stands for several voxels, it shows the worst of them.</p>{}<div class=\"legends\">{}<div class=\"fates\">{fates}</div></div></section>",
        slices(data),
        dose_bar(data),
    )
}

fn patterns(data: &ReportData<'_>) -> String {
    data.lights
        .iter()
        .map(|light| {
            let of = if light.name.is_empty() { String::new() } else { format!(" of light {}", escape(light.name)) };
            let scale = LightScale::of(light.patterns, light.full_scale);
            format!(
                "<section><h2>Light patterns{of}</h2><p class=\"muted\">One row of all frames (a sinogram), and some frames. Colors stretch dim light: they follow its \
                 square root. White is {} over the whole exposure, relative as all doses are.</p>{}{}{}</section>",
                significant(f64::from(light.full_scale), 4),
                sinogram(light.patterns, &scale),
                strip(light.patterns, &scale),
                scale.bar(),
            ) + &tables::machine(light)
        })
        .collect()
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
