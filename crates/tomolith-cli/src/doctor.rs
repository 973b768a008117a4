//! `tomolith doctor`: what this machine has, and whether the program computes on it what closed forms say.

use crate::arguments::Manner;
use crate::screen::{done, say};
use serde::Serialize;
use serde_json::json;
use std::collections::BTreeMap;
use std::time::Instant;
use tomolith::field::Field;
use tomolith::job::{Document, Job, ResolvedJob, Silent, resources, run};
use tomolith::models::Work;
use tomolith::models::parallel::kernel::Isa;
use tomolith::{Error, Result};

/// Even light from 120 angles in a disc of resin of 2 mm, which absorbs μ = 0.2 per mm.
const DISC: &str = r#"
target = { phantom = { cylinder = { size_mm = 3.0, height_mm = 0.4 } } }
grid = { pitch_mm = 0.05, region = "cylinder" }
resin = { refractive_index = 1.5, absorption_per_mm = 0.2 }
vial = { index_matched = { radius_mm = 2.0 } }
light = [{ pixels = [84, 8], angles = 120, projector = { collimated = { pixel_pitch_mm = 0.05 } } }]
"#;
/// N μ exp(−μ R) in its middle.
const MIDDLE: f64 = 120.0 * 0.2 * 0.670_320_046_035_639_3;

/// A gear, run from end to end.
const GEAR: &str = r#"
target = { phantom = "gear", size_mm = 3.0 }
grid = { pitch_mm = 0.1 }
resin = { refractive_index = 1.5, absorption_per_mm = 0.1 }
vial = { index_matched = { radius_mm = 3.0 } }
light = [{ pixels = [44, 20], angles = 60, projector = { collimated = { pixel_pitch_mm = 0.1 } } }]
stop = { iterations = 15 }
output = { movie = "none" }
"#;
/// What it prints at least.
const PRINTS: f64 = 0.9;

/// A check against what is known.
#[derive(Serialize)]
struct Check {
    name: &'static str,
    found: String,
    is_right: bool,
}

/// Says what the machine has, and tries the program on it; whether all of it is right.
pub(crate) fn doctor(json: bool) -> Result<bool> {
    let machine = machine()?;
    if !json {
        machine.iter().for_each(|(name, text)| line(name, text));
    }
    let checks = [middle()?, pair()?, gear()?];
    let is_right = checks.iter().all(|check| check.is_right);
    let machine: BTreeMap<&str, String> = machine.into_iter().collect();
    let found = json!({ "machine": machine, "checks": checks, "is_right": is_right });
    done(Manner::with_json(json), found, || {
        for check in &checks {
            let verdict = if check.is_right { "right" } else { "WRONG" };
            line(check.name, &format!("{verdict}: {}", check.found));
        }
        if !is_right {
            say("this program computes wrongly on this machine: please report these lines");
        }
    });
    Ok(is_right)
}

fn line(name: &str, text: &str) {
    say(&format!("{name:>14} {text}"));
}

fn machine() -> Result<Vec<(&'static str, String)>> {
    let isa = Isa::asked()?;
    let threads = std::thread::available_parallelism().map_or(1, usize::from);
    let gb = |mb: u64| format!("{:.1} GB", mb as f64 / 1e3);
    let budget = resources::memory_budget_mb(None);
    Ok(vec![
        (
            "program",
            format!(
                "Tomolith {}, {}",
                env!("CARGO_PKG_VERSION"),
                std::env::consts::ARCH
            ),
        ),
        ("threads", format!("{threads}; `--threads` takes fewer")),
        (
            "instructions",
            format!("{}; TOMOLITH_ISA takes another set", isa.name()),
        ),
        (
            "memory",
            match (resources::free_memory_mb(), budget) {
                (Some(free), Some(planned)) => format!(
                    "a run plans with {} ({:.0} % of this computer's memory); {} are free now",
                    gb(planned),
                    100.0 * resources::SHARE,
                    gb(free)
                ),
                _ => "not known here: `resources.memory_gb` bounds what a run takes".to_owned(),
            },
        ),
        (
            "disk here",
            format!(
                "{} free",
                resources::available_disk_mb(std::path::Path::new("."))
                    .map_or_else(|| "not known".into(), gb)
            ),
        ),
        ("cards", cards()),
    ])
}

#[cfg(feature = "gpu")]
fn cards() -> String {
    let all = tomolith::gpu::adapters();
    let names: Vec<&str> = (all.iter().filter(|card| !card.is_software))
        .map(|card| card.name.as_str())
        .collect();
    match (names.is_empty(), all.is_empty()) {
        (true, true) => "none with Vulkan, Metal or DX12".to_owned(),
        (true, false) => "none but software with Vulkan, Metal or DX12".to_owned(),
        (false, _) => format!(
            "{}; `--device gpu` computes there (docs/cards.md)",
            names.join(", ")
        ),
    }
}

#[cfg(not(feature = "gpu"))]
fn cards() -> String {
    "this program was built without them (`--features gpu`: docs/cards.md)".to_owned()
}

fn job(text: &str) -> Result<Job> {
    Job::from_document(Document::toml("doctor.toml", text)?)
}

/// Even light in the middle of a disc of resin, by Bouguer's law.
fn middle() -> Result<Check> {
    let work = Work::new();
    let task = ResolvedJob::new(&job(DISC)?)?.task(&work)?;
    let mut x = task.start.clone();
    x.fill(1.0);
    let mut dose = task.model.new_dose()?;
    let begin = Instant::now();
    task.model.dose(&x, &mut dose, &work)?;
    let seconds = begin.elapsed().as_secs_f64();
    let volume = task.model.outputs()[0].volume_of(dose.as_slice());
    let [nz, ny, nx] = volume.grid.shape;
    // The four voxels round the axis
    let around = [[1, 1], [1, 0], [0, 1], [0, 0]]
        .map(|[dy, dx]| f64::from(*volume.at(nz / 2, ny / 2 - dy, nx / 2 - dx)));
    let found = around.iter().sum::<f64>() / 4.0;
    let error = (found / MIDDLE - 1.0).abs();
    Ok(Check {
        name: "absorption",
        found: format!(
            "dose {found:.4} in the middle of a disc, N μ exp(−μR) is {MIDDLE:.4} ({:.1e} updates/s)",
            task.model.updates() as f64 / seconds
        ),
        is_right: error < 2e-4,
    })
}

/// ⟨F x, c⟩ and ⟨x, Fᵀ c⟩.
fn pair() -> Result<Check> {
    let work = Work::new();
    let task = ResolvedJob::new(&job(DISC)?)?.task(&work)?;
    let model = task.model.as_ref();
    let (mut x, mut dose) = (model.new_patterns()?, model.new_dose()?);
    let mut c = model.new_dose()?;
    // Numbers without a pattern, the same on every machine
    let mut state = 1u32;
    let mut next = || {
        state = state.wrapping_mul(1_664_525).wrapping_add(1_013_904_223);
        (state >> 8) as f32 / (1u32 << 24) as f32
    };
    x.as_mut_slice()
        .iter_mut()
        .for_each(|value| *value = next());
    let marks = model.outputs()[0].grid.len();
    let marks = tomolith::grid::Volume {
        grid: model.outputs()[0].grid.clone(),
        values: (0..marks).map(|_| next() - 0.5).collect(),
    };
    let range = model.outputs()[0].range();
    c.as_mut_slice()[range].copy_from_slice(&model.outputs()[0].field_of(&marks));
    let mut back = x.zeros_like();
    model.dose(&x, &mut dose, &work)?;
    model.pullback(&x, &c, &mut back, &work)?;
    let [left, right] = [dose.dot(&c), x.dot(&back)];
    let size = (dose.dot(&dose) * c.dot(&c)).sqrt();
    let error = (left - right).abs() / size;
    Ok(Check {
        name: "adjoint",
        found: format!("⟨Fx, c⟩ and ⟨x, Fᵀc⟩ differ by {error:.1e} of |Fx|·|c|"),
        is_right: error < 1e-6,
    })
}

/// A whole run in a folder for things that pass.
fn gear() -> Result<Check> {
    let folder = std::env::temp_dir().join(format!("tomolith-doctor-{}", std::process::id()));
    let begin = Instant::now();
    let job = job(GEAR)?.with_folder(&folder, "doctor");
    let summary = run(&job, false, &mut Silent, &Work::new());
    let removed = std::fs::remove_dir_all(&folder).map_err(|e| Error::io(&folder, e));
    let iou = summary?.evaluation.iou.unwrap_or(0.0);
    removed?;
    Ok(Check {
        name: "a run",
        found: format!(
            "a gear of 3 mm prints with IoU {iou:.3}, {PRINTS} or more is expected ({:.1} s, files in {})",
            begin.elapsed().as_secs_f64(),
            std::env::temp_dir().display()
        ),
        is_right: iou >= PRINTS,
    })
}
