//! Which patterns print best: the tables of docs/fidelity.md, which says how rows are made.
//!
//! Every row is a whole job of the program. Its written patterns (8 bits) are evaluated by `simulate` on voxels of a quarter of a pixel while
//! the vial turns (4 angles a frame), under one job for all rows of a target. Run folders go to `out/fidelity/`.
//!
//!     cargo run --release -p tomolith-studies -- fidelity boat.stl bones,star default,ceiling glass
#![expect(clippy::print_stdout, reason = "a study prints its table")]

use serde_json::Value;
use std::path::{Path, PathBuf};
use tomolith::Error;
use tomolith::job::{self, Document, Job, Silent, Summary};
use tomolith::models::Work;

/// A target, the glass that holds it, and the pixels that print it.
struct Case {
    name: &'static str,
    target: &'static str,
    /// Absorption, 1/mm.
    absorption: f64,
    glass: &'static str,
    /// Columns, rows, frames, pixel pitch in mm.
    light: (usize, usize, usize, f64),
}

/// The vial of examples 01 and 14.
const CYLINDER: &str =
    "vial.cylinder = { inner_radius_mm = 7.6, outer_radius_mm = 8.3, refractive_index = 1.58 }";
/// The vial of example 04.
const TUBES: &str = "vial.double_tube = { outer_radius_mm = 7.354, resin_outer_radius_mm = 6.363, resin_inner_radius_mm = 3.18, \
    inner_radius_mm = 2.58, outer_refractive_index = 1.5, inner_refractive_index = 1.5, core_refractive_index = 1.33 }";

const CASES: [Case; 6] = [
    Case {
        name: "gear",
        target: "phantom.gear = { size_mm = 6.0 }",
        absorption: 0.054,
        glass: CYLINDER,
        light: (176, 64, 180, 0.056),
    },
    Case {
        name: "gyroid",
        target: "phantom.gyroid = { size_mm = 6.0 }",
        absorption: 0.1,
        glass: CYLINDER,
        light: (160, 96, 180, 0.075),
    },
    Case {
        name: "boat",
        target: "mesh = \"BOAT\"\nsize_mm = 9.5",
        absorption: 0.1,
        glass: CYLINDER,
        light: (160, 96, 180, 0.1),
    },
    Case {
        name: "star",
        target: "phantom.siemens_star = { size_mm = 4.0, height_mm = 0.55, spokes = 24, hub_mm = 0.4 }",
        absorption: 0.1,
        glass: CYLINDER,
        light: (128, 24, 120, 0.048),
    },
    Case {
        name: "bones",
        target: "phantom.dog_bones = { size_mm = 5.0, height_mm = 1.0, count = 3 }",
        absorption: 0.1,
        glass: CYLINDER,
        light: (128, 32, 120, 0.06),
    },
    Case {
        name: "hollow gear",
        target: "phantom.hollow_gear = { size_mm = 10.0, height_mm = 2.0, teeth = 16, wall_mm = 0.4, floor_mm = 0.0 }",
        absorption: 0.03,
        glass: TUBES,
        light: (150, 40, 180, 0.1),
    },
];

/// Name, title, and the keys that make a row of the default job.
const ROWS: [(&str, &str, &[&str]); 11] = [
    (
        "start",
        "start (FBP)",
        &["stop.iterations=0", "objective.threshold.surface=voxel"],
    ),
    ("osmo", "OSMO", &["optimizer.osmo={}", "objective.osmo={}"]),
    (
        "edges",
        "OSMO with edges",
        &["optimizer.osmo.edges=true", "objective.osmo={}"],
    ),
    (
        "cal",
        "CAL",
        &[
            "optimizer.cal.sigmoid=0.05",
            "objective.osmo={ d_h = 0.8, d_l = 0.7 }",
        ],
    ),
    (
        "pm",
        "PM",
        &["optimizer.pm={}", "objective.pm={ d_h = 0.9, d_l = 0.7 }"],
    ),
    (
        "bclp",
        "BCLP, ε = 0.1",
        &[
            "objective.bclp={ epsilon = 0.1, q = 2 }",
            "bounds.ceiling=start",
        ],
    ),
    (
        "published",
        "threshold 0.85, 0.95 on whole voxels",
        &[
            "objective.threshold={ lower = 0.85, upper = 0.95, surface = \"voxel\" }",
            "bounds.ceiling=start",
        ],
    ),
    (
        "voxels",
        "threshold 0.70, 0.90 on whole voxels",
        &[
            "objective.threshold={ lower = 0.7, upper = 0.9, surface = \"voxel\" }",
            "bounds.ceiling=start",
        ],
    ),
    (
        "start-bound",
        "default within the bound of the start",
        &["bounds.ceiling=start"],
    ),
    ("default", "**default**", &[]),
    (
        "ceiling",
        "ceiling",
        &[
            "grid.refine=4",
            "light.sub_angles=4",
            "stop.iterations=150",
            "stop.change=0",
            "bounds.ceiling=start",
        ],
    ),
];

pub(crate) fn study(arguments: &[String]) -> Result<(), Box<dyn std::error::Error>> {
    let mut arguments = arguments.iter();
    let boat = arguments.next().map_or("3DBenchy.stl", String::as_str);
    let (cases, rows) = (arguments.next(), arguments.next());
    let asked = |list: Option<&String>, name: &str| {
        list.is_none_or(|list| list.split(',').any(|part| part == name))
    };
    let vials = arguments.next();
    let vial = |&matched: &bool| asked(vials, if matched { "matched" } else { "glass" });
    for matched in [false, true].into_iter().filter(vial) {
        for case in CASES.iter().filter(|case| asked(cases, case.name)) {
            let (columns, count, frames, pitch) = case.light;
            let vial = if matched { "index-matched" } else { "in glass" };
            println!(
                "\n**{}**, {vial}, {columns} × {count} pixels of {pitch} mm, {frames} frames\n",
                case.name
            );
            println!(
                "| patterns | IoU | VER | N·M/t, mm | trimmed PW, IPDR | mean, 95 % deviation, µm | in pixels | s |"
            );
            println!("|---|---|---|---|---|---|---|---|");
            for (row, title, keys) in ROWS.iter().filter(|row| asked(rows, row.0)) {
                let (run, report) = judged(case, matched, boat, row, keys)?;
                println!("{}", line(title, &report, pitch, run.seconds));
            }
        }
    }
    Ok(())
}

/// Runs a row and evaluates the patterns that it wrote.
fn judged(
    case: &Case,
    matched: bool,
    boat: &str,
    row: &str,
    keys: &[&str],
) -> Result<(Summary, Value), Error> {
    let (.., pitch) = case.light;
    let vial = if matched { "matched" } else { "glass" };
    let folder =
        PathBuf::from("out/fidelity").join(format!("{}-{vial}", case.name.replace(' ', "-")));
    let mut changes = vec![
        format!("grid.pitch_mm={pitch}"),
        "evaluate.refine=1".to_owned(),
        "evaluate.sub_angles=1".to_owned(),
    ];
    changes.extend(keys.iter().map(|&key| key.to_owned()));
    let job = job(case, matched, boat, &changes)?.with_folder(&folder.join(row), "");
    let run = job::run(&job, false, &mut Silent, &Work::new())?;
    let judge = [
        format!("grid.pitch_mm={}", pitch / 2.0),
        "evaluate.refine=2".to_owned(),
        "evaluate.sub_angles=4".to_owned(),
    ];
    let judge = self::job(case, matched, boat, &judge)?
        .with_folder(&folder.join(format!("{row}-judged")), "");
    let print = job::simulate(
        &judge,
        &run.folder.join("patterns.npz"),
        &mut Silent,
        &Work::new(),
    )?;
    let file = print.folder.join("report.json");
    let text = std::fs::read_to_string(&file).map_err(|e| Error::Io {
        path: file.clone(),
        source: e,
    })?;
    let report = serde_json::from_str(&text).unwrap_or_default();
    Ok((run, report))
}

fn job(case: &Case, matched: bool, boat: &str, keys: &[String]) -> Result<Job, Error> {
    let (columns, rows, frames, pitch) = case.light;
    let (index, vial) = match matched {
        true => (1.5, "vial.index_matched = { radius_mm = 7.6 }"),
        false => (1.4849, case.glass),
    };
    let text = format!(
        "{vial}\n[resin]\nrefractive_index = {index}\nabsorption_per_mm = {}\n[[light]]\npixels = [{columns}, {rows}]\nangles = {frames}\n\
         projector.collimated = {{ pixel_pitch_mm = {pitch} }}\n[target]\n{}\n",
        case.absorption,
        case.target.replace("BOAT", boat)
    );
    let mut document = Document::toml(Path::new("fidelity.toml"), &text)?;
    for key in keys {
        document.set(key)?;
    }
    Job::from_document(document)
}

/// A row of the table.
fn line(title: &str, report: &Value, pitch: f64, seconds: f64) -> String {
    let number_of = |pointer: &str| {
        report
            .pointer(pointer)
            .and_then(Value::as_f64)
            .unwrap_or(f64::NAN)
    };
    let evaluation = |key: &str| number_of(&format!("/evaluation/{key}"));
    let published = |key: &str| number_of(&format!("/published/{key}/value"));
    let (mean, high) = (evaluation("surface_mean_mm"), evaluation("surface_p95_mm"));
    format!(
        "| {title} | {:.4} | {:.4} | {:.3} | {:.3}, {:.3} | {:.2}, {:.1} | {:.3}, {:.2} | {seconds:.1} |",
        evaluation("iou"),
        evaluation("ver"),
        evaluation("print_time_mm"),
        published("pw_trimmed"),
        published("ipdr_trimmed"),
        1e3 * mean,
        1e3 * high,
        mean / pitch,
        high / pitch,
    )
}
