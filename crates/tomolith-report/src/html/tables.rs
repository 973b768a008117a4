//! Tables of the page: what the machine does, every number, as it was published, movies and times, the job.

use super::super::number::{clock, escape, significant};
use super::super::{LightReport, MovieReport, ReportData};
use super::{GRAY_HEADLINE, in_voxels, is_gray, shown};
use std::fmt::Write as _;
use tomolith_metrics::{Better, Evaluation, METRICS, MetricKind};

/// Time, energy and use of the light.
pub(super) fn machine(light: &LightReport<'_>) -> String {
    let budget = &light.budget;
    let of = if light.name.is_empty() {
        String::new()
    } else {
        format!(", light {}", escape(light.name))
    };
    let number = |value: Option<f64>, unit: &str| {
        value.map_or_else(
            || "–".to_owned(),
            |value| format!("{} {unit}", significant(value, 3)),
        )
    };
    let canvas = light.canvas.map_or_else(
        || "the patterns as they are".to_owned(),
        |[columns, rows]| format!("{columns} × {rows} pixels"),
    );
    let brightest = light.irradiance.map(|irradiance| {
        let own = number(Some(irradiance.white_mw_per_cm2), "mW/cm²");
        let share = irradiance.peak_mw_per_cm2.map_or_else(String::new, |peak| {
            let percent = 100.0 * irradiance.white_mw_per_cm2 / peak;
            format!(", {} % of what the printer gives", significant(percent, 3))
        });
        ("White, while it shines", own + &share)
    });
    let rows: String = [
        ("Device", canvas),
        (
            match light.irradiance {
                // A schedule is what it is, whenever the print is done
                Some(_) => "Length of the schedule",
                None => "Time to print",
            },
            budget.time_s.map_or_else(|| "–".to_owned(), clock),
        ),
        ("Turns of the vial", number(budget.turns, "")),
        (
            "White, of a frame over the whole print",
            number(budget.white_mj_per_mm2, "mJ/mm²"),
        ),
        (
            "Energy at the vial per turn",
            number(budget.energy_per_turn_mj, "mJ"),
        ),
        ("Energy at the vial in all", number(budget.energy_mj, "mJ")),
        (
            "Share of the device's light that is used",
            number(Some(100.0 * budget.light_used), "%"),
        ),
    ]
    .into_iter()
    .chain(brightest)
    .map(|(name, value)| format!("<tr><td>{name}</td><td>{value}</td></tr>"))
    .collect();
    let missing = if light.irradiance.is_some() {
        "<p class=\"note\">The job's schedule says how long and how bright the light is.</p>"
    } else if light.patterns.grid.frame_arc == 0.0 {
        "<p class=\"note\">Frames of a list of angles (light.angles.list_deg) have no times.</p>"
    } else if budget.time_s.is_none() {
        "<p class=\"note\">Times need resin.critical_dose_mj_per_mm3 and printer.peak_irradiance_mw_per_cm2.</p>"
    } else {
        ""
    };
    format!(
        "<section><h2>On the printer{of}</h2><table class=\"plain\"><tbody>{rows}</tbody></table>{missing}</section>"
    )
}

pub(super) fn table(data: &ReportData<'_>) -> String {
    let columns: Vec<(&str, String, &Evaluation)> = [
        ("Turning", Some(data.evaluation)),
        ("Standing still", data.standing),
        ("Optimization", data.optimization),
    ]
    .into_iter()
    .filter_map(|(name, e)| {
        e.map(|e| {
            (
                name,
                format!("{} µm voxels", significant(e.grid.pitch_mm * 1e3, 3)),
                e,
            )
        })
    })
    .collect();
    let heads: String = columns
        .iter()
        .map(|(name, grid, _)| format!("<th>{name}<br>{grid}</th>"))
        .collect();
    let mut rows = String::new();
    let known = |kind: &&MetricKind| {
        let mut measured = columns.iter().map(|c| c.2.measures.get(kind.name));
        measured.any(|m| m.is_some())
    };
    // The numbers of the other kind of target are left out; a gray target's own come first
    let mut kinds: Vec<&MetricKind> = METRICS.iter().filter(known).collect();
    kinds.sort_by_key(|kind| is_gray(data) && !GRAY_HEADLINE.contains(&kind.name));
    for kind in kinds {
        let better = match kind.better {
            Better::Higher => " ↑",
            Better::Lower => " ↓",
            Better::Neutral => "",
        };
        let unit = match kind.unit {
            "response" | "" => "",
            "mm" => "µm",
            unit => unit,
        };
        let _ = write!(
            rows,
            "<tr><td>{}{better} <span class=\"unit\">{unit}</span><small>{}</small></td>",
            escape(kind.title),
            escape(kind.summary)
        );
        for (i, (_, _, evaluation)) in columns.iter().enumerate() {
            let measure = evaluation.measures.get(kind.name);
            let (value, _) = shown(kind, measure, 4);
            let voxels = in_voxels(kind, measure, evaluation.grid.pitch_mm);
            let class = if i == 0 { " class=\"head\"" } else { "" };
            let _ = write!(
                rows,
                "<td{class}>{value} <span class=\"unit\">{voxels}</span></td>"
            );
        }
        rows.push_str("</tr>");
    }
    let gray = if is_gray(data) {
        " For a gray target, “part” is where its value is at least ½."
    } else {
        ""
    };
    format!(
        "<section><h2>All numbers</h2><p class=\"muted\">↑ larger is better, ↓ smaller is better. The first columns are on the evaluation's voxels, from the patterns as they were written; \
         the last one is of the patterns before they are written, on the job's own voxels, the vial standing still.{gray}</p><div class=\"scroll\"><table><thead><tr><th></th>{heads}</tr></thead><tbody>{rows}</tbody></table></div></section>"
    )
}

/// Numbers with other authors' signs and normalizations.
pub(super) fn published(data: &ReportData<'_>) -> String {
    let text =
        |about: &serde_json::Value, key: &str| escape(about[key].as_str().unwrap_or_default());
    let rows: String = data
        .published
        .iter()
        .filter(|(_, about)| about["source"].is_string())
        .map(|(name, about)| {
            let value = about["value"]
                .as_f64()
                .map_or("–".to_owned(), |v| significant(v, 4));
            format!(
                "<tr><td>{}</td><td>{value} {}</td><td>{}</td><td>{}</td></tr>",
                escape(name),
                text(about, "unit"),
                text(about, "note"),
                text(about, "source"),
            )
        })
        .collect();
    if rows.is_empty() {
        return String::new();
    }
    format!(
        "<section><details><summary>Numbers as they were published</summary><div class=\"scroll\"><table><thead><tr><th>Name</th><th>Value</th><th>Definition</th><th>Source</th></tr></thead><tbody>{rows}</tbody></table></div></details></section>"
    )
}

pub(super) fn times_and_movies(data: &ReportData<'_>) -> String {
    let mut out = String::new();
    if !data.movies.is_empty() {
        let column = |name: &str, cell: &dyn Fn(&MovieReport) -> String| {
            let cells: String = data
                .movies
                .iter()
                .map(|m| format!("<td>{}</td>", cell(m)))
                .collect();
            format!("<tr><td>{name}</td>{cells}</tr>")
        };
        let heads: String = data
            .movies
            .iter()
            .map(|movie| {
                format!(
                    "<th class=\"file\">{}</th>",
                    escape(&movie.file).replace('_', "_<wbr>")
                )
            })
            .collect();
        let rows = [
            column("Largest gray error", &|m| {
                format!("{} of 255", m.check.largest_error)
            }),
            column("rms gray error", &|m| significant(m.check.rms_error, 2)),
            column("Frames", &|m| m.check.frames.to_string()),
            column("Rate", &|m| {
                format!("{} /s", significant(m.check.frame_rate, 4))
            }),
            column("Pixels", &|m| {
                format!("{} × {}", m.check.width, m.check.height)
            }),
            column("Size", &|m| {
                format!("{} MB", significant(m.check.bytes as f64 / 1e6, 3))
            }),
        ]
        .concat();
        let _ = write!(
            out,
            "<section><h2>Movie</h2><p class=\"muted\">Written, then decoded again and compared with the frames. H.264 is lossy: the PNG frames are exact.</p>\
             <div class=\"scroll\"><table class=\"movies\"><thead><tr><th>File</th>{heads}</tr></thead><tbody>{rows}</tbody></table></div></section>"
        );
    }
    let longest = data.timings.iter().map(|t| t.seconds).fold(0.0, f64::max);
    if longest > 0.0 {
        let wholes = data.timings.iter().filter(|t| !t.name.contains(": "));
        let total: f64 = wholes.map(|t| t.seconds).sum();
        let rows: String = data
            .timings
            .iter()
            .map(|t| {
                format!(
                    "<div class=\"row\"><label>{}</label><div><i style=\"width:{:.1}%\"></i></div><span>{} s</span></div>",
                    escape(&t.name),
                    100.0 * t.seconds / longest,
                    significant(t.seconds, 3),
                )
            })
            .collect();
        let _ = write!(
            out,
            "<section><h2>Where the time went</h2><p class=\"muted\">{} s until this page was written.</p><div class=\"time\">{rows}</div></section>",
            significant(total, 3),
        );
    }
    out
}

pub(super) fn job(data: &ReportData<'_>) -> String {
    if data.job_text.is_empty() {
        return String::new();
    }
    format!(
        "<section><details><summary>The job, with every default</summary><pre>{}</pre></details></section>",
        escape(data.job_text)
    )
}
