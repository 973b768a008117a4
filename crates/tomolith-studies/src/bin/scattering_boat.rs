//! The boat in a resin that scatters, by what the optimization knows of it: `cargo run --release -p tomolith-studies --bin
//! scattering_boat -- 3DBenchy.stl`.
//!
//! Table 2 of Nicolet et al. 2024 at half its resolution: 256³ voxels, 360 frames of 256² pixels, their resin (μ_a 0.1299, μ_s 0.1707
//! per mm, Rayleigh) and vial (15.33/16.77 mm, n 1.514; resin 1.4849), boat of 9.5 mm, 40 iterations. All patterns are judged with
//! scattering, on the same voxels, standing still. Prints a table; see docs/measured/scattering.md.
#![expect(clippy::print_stdout, reason = "a study prints its table")]

use std::error::Error;
use std::path::Path;
use std::time::Instant;
use tomolith::job::{Job, Silent, run, simulate};
use tomolith::models::Run;

/// Name; what the optimization takes for the resin; its objective; IoU, Γ and η of the article, per cent.
const ROWS: [(&str, &str, &str, [f64; 3]); 5] = [
    (
        "Radon, L2",
        "absorption_per_mm = 0.1299\npure_radon = true",
        "l2",
        [82.45, 4.49, 3.25],
    ),
    (
        "absorption only, L2",
        "absorption_per_mm = 0.3006",
        "l2",
        [85.97, 6.29, 3.19],
    ),
    ("scattering, L2", SCATTERING, "l2", [99.31, 3.60, 3.19]),
    (
        "scattering, threshold 0.70, 0.90",
        SCATTERING,
        "threshold",
        [100.0, 6.29, 2.80],
    ),
    (
        "scattering, threshold 0.85, 0.95",
        SCATTERING,
        "threshold = { lower = 0.85, upper = 0.95 }",
        [100.0, 6.29, 2.80],
    ),
];

const SCATTERING: &str =
    "absorption_per_mm = 0.1299\nscattering_per_mm = 0.1707\nphase.rayleigh = {}";

fn job(
    folder: &Path,
    name: &str,
    mesh: &Path,
    resin: &str,
    objective: &str,
) -> Result<Job, Box<dyn Error>> {
    let objective = if objective.contains('=') {
        objective.to_owned()
    } else {
        format!("{objective} = {{}}")
    };
    let text = format!(
        "objective.{objective}
[target]
mesh = {mesh:?}
size_mm = 9.5
[grid]
shape = [256, 256, 256]
[resin]
refractive_index = 1.4849
{resin}
[vial.cylinder]
inner_radius_mm = 7.665
outer_radius_mm = 8.385
refractive_index = 1.514
[[light]]
pixels = [256, 256]
angles = 360
projector.collimated = {{ pixel_pitch_mm = 0.06 }}
[stop]
iterations = 40
[evaluate]
refine = 1
sub_angles = 1
"
    );
    let file = folder.join(format!("{name}.toml"));
    std::fs::write(&file, text)?;
    Ok(Job::read(&file, &[])?.with_folder(&folder.join(name), "folder"))
}

fn main() -> Result<(), Box<dyn Error>> {
    let mesh = std::env::args().nth(1).ok_or("give the boat's mesh")?;
    let mesh = std::fs::canonicalize(mesh)?;
    let folder = tempfile::tempdir()?;
    let cancel = Run::new();
    println!(
        "optimized with                     IoU %   (article)   Γ %   (article)   η %   (article)   optimization s"
    );
    for (i, (name, resin, objective, article)) in ROWS.into_iter().enumerate() {
        let own = job(folder.path(), &format!("own{i}"), &mesh, resin, objective)?;
        let start = Instant::now();
        run(&own, false, &mut Silent, &cancel)?;
        let whole = start.elapsed().as_secs_f64();
        let history = std::fs::read_to_string(own.folder().join("history.csv"))?;
        let seconds = seconds_of(&history).unwrap_or(whole);
        let judge = job(
            folder.path(),
            &format!("judge{i}"),
            &mesh,
            SCATTERING,
            objective,
        )?;
        let patterns = own.folder().join("patterns.npz");
        simulate(&judge, &patterns, &mut Silent, &cancel)?;
        let text = std::fs::read_to_string(judge.folder().join("report.json"))?;
        let report: serde_json::Value = serde_json::from_str(&text)?;
        let number = |key: &str| report["evaluation"][key].as_f64().unwrap_or(f64::NAN);
        println!(
            "{name:33} {:6.2}   ({:6.2})  {:5.2}  ({:5.2})     {:5.2}  ({:5.2})     {seconds:6.1}",
            100.0 * number("iou"),
            article[0],
            number("gamma"),
            article[1],
            100.0 * number("eta"),
            article[2],
        );
        for done in [own.folder(), judge.folder()] {
            std::fs::remove_dir_all(done)?;
        }
    }
    Ok(())
}

/// Seconds of the last line of a history.
fn seconds_of(history: &str) -> Option<f64> {
    let mut lines = history.lines();
    let place = lines
        .next()?
        .split(',')
        .position(|name| name == "seconds")?;
    lines.last()?.split(',').nth(place)?.parse().ok()
}
