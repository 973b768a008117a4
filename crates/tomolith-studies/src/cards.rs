//! What a graphics card does in the time of the processor: whole jobs on both, and doses and adjoints alone: the tables of docs/cards.md, which has
//! the commands.
//!
//! The program needs no other file, so the one binary may be carried to a machine with a card. Without a mesh a gyroid stands in for the boat. Run
//! folders go to `out/cards/`.
#![expect(clippy::print_stdout, reason = "a study prints its tables")]

use serde_json::Value;
use std::path::Path;
use std::time::Instant;
use tomolith::field::Field;
use tomolith::gpu::{Asked, Gpu, model_on};
use tomolith::grid::{PatternGrid, VolumeGrid};
use tomolith::job::{self, Document, Job, Silent};
use tomolith::models::rays::Optics;
use tomolith::models::{
    DoseModel, ModelFamily, ModelInput, OpticalScene, Purpose, Work, monte_carlo, parallel, rays,
};
use tomolith::optics::light::Light;
use tomolith::optics::resin::Resin;
use tomolith::optics::vial::index_matched::IndexMatched;

use crate::scatter_noise;

type Failure = Box<dyn std::error::Error>;

/// The published boat: 256³ voxels, 400 frames of 400² pixels.
const BENCHMARK: Size = Size {
    voxels: 256,
    frames: 400,
    pixels: 400,
    edge_mm: 8.5,
    pixel: 0.025 * 256.0 / 8.5,
};

/// A whole job: title, size, what fills the vial and stands around it, iterations.
const JOBS: [(&str, Size, &str, usize); 8] = [
    (
        "published benchmark, index-matched",
        BENCHMARK,
        "vial.index_matched.radius_mm = 10.191\nresin = { refractive_index = 1.347, absorption_per_mm = 0.08 }",
        40,
    ),
    (
        "published benchmark, cylinder",
        BENCHMARK,
        "vial.cylinder = { inner_radius_mm = 6.0, outer_radius_mm = 7.0, refractive_index = 1.54 }\n\
         resin = { refractive_index = 1.347, absorption_per_mm = 0.08 }",
        40,
    ),
    (
        "published benchmark, scattering",
        BENCHMARK,
        "vial.cylinder = { inner_radius_mm = 6.0, outer_radius_mm = 7.0, refractive_index = 1.54 }\n\
         resin = { refractive_index = 1.347, absorption_per_mm = 0.04, scattering_per_mm = 0.04, phase = \"rayleigh\" }",
        40,
    ),
    (
        "boat of 9.5 mm, index-matched",
        Size {
            voxels: 400,
            edge_mm: 9.5,
            pixel: 1.0,
            ..BENCHMARK
        },
        "vial.index_matched.radius_mm = 8.0\nresin = { refractive_index = 1.4849, absorption_per_mm = 0.1 }",
        40,
    ),
    (
        "tilted light, cylinder",
        Size {
            voxels: 128,
            frames: 120,
            pixels: 200,
            ..BENCHMARK
        },
        "motion.tilt_deg = 6.8\nvial.cylinder = { inner_radius_mm = 6.0, outer_radius_mm = 7.0, refractive_index = 1.54 }\n\
         resin = { refractive_index = 1.347, absorption_per_mm = 0.08 }",
        20,
    ),
    ("waves, 10 mm", waves(10.0), WAVES, 2),
    ("waves, 1 mm", waves(1.0), WAVES, 2),
    ("waves, 0.1 mm", waves(0.1), WAVES, 2),
];

const WAVES: &str =
    "resin = { refractive_index = 1.5, pure_radon = true }\nmodel.wave = {}\nevaluate.refine = 1";

/// The article's volume of coherent light.
const fn waves(edge_mm: f64) -> Size {
    Size {
        voxels: 550,
        frames: 600,
        pixels: 880,
        edge_mm,
        pixel: 1.0,
    }
}

/// Voxels and pixels along an edge, frames, the edge of the volume, and the width of a pixel in voxels.
#[derive(Clone, Copy)]
struct Size {
    voxels: usize,
    frames: usize,
    pixels: usize,
    edge_mm: f64,
    pixel: f64,
}

impl Size {
    /// The same volume with so many times fewer voxels along an edge, pixels and frames.
    fn over(self, divisor: usize) -> Self {
        let [voxels, frames, pixels] =
            [self.voxels, self.frames, self.pixels].map(|n| (n / divisor).max(8));
        Size {
            voxels,
            frames,
            pixels,
            ..self
        }
    }
}

pub(crate) fn study(arguments: &[String]) -> Result<(), Failure> {
    let Some(card) = arguments.first() else {
        return Err(
            "cards CARD [MESH | -] [DIVISOR] [WORD]: `tomolith devices` lists cards".into(),
        );
    };
    let mesh = arguments.get(1).filter(|mesh| *mesh != "-");
    let divisor = arguments.get(2).map_or(Ok(1), |n| n.parse::<usize>())?;
    let gpu = Gpu::open(&Asked::Named(card))?;
    println!("{:?}\n", gpu.adapter());
    println!(
        "| job | loop s: card, processor | pixels, start, ceiling s | evaluation s | IoU |\n|---|---|---|---|---|"
    );
    let is_asked = |title: &str| {
        arguments
            .get(3)
            .is_none_or(|word| title.contains(word.as_str()))
    };
    for (title, size, scene, iterations) in JOBS.into_iter().filter(|job| is_asked(job.0)) {
        let size = size.over(divisor.max(1));
        let title = format!("{title}, {}³", size.voxels);
        let text = job_text(size, scene, iterations, mesh);
        let on = |device: &str| finished(&text, &title, device);
        let row = match (on(&format!("gpu:{card}")), on("cpu")) {
            (Ok(card), Ok(processor)) => line(&card, &processor),
            (Err(why), _) | (_, Err(why)) => format!("refused: {why} | | | |"),
        };
        println!("| {title} | {row}");
    }
    println!(
        "\n| model, voxels, frames | updates a call | dose/s | adjoint/s |\n|---|---|---|---|"
    );
    let (strips, rays) = (parallel::Params::default(), rays::Params::default());
    let models: [(&dyn ModelFamily, usize, usize); 6] = [
        (&strips, 1024, 1000),
        (&strips, 512, 1000),
        (&strips, 256, 360),
        (&strips, 128, 90),
        (&rays, 256, 360),
        (&rays, 128, 90),
    ];
    for (family, voxels, frames) in models.into_iter().filter(|_| is_asked("rates")) {
        let size = [voxels, frames].map(|n| (n / divisor.max(1)).max(8));
        let row = rates(&gpu, family, size).unwrap_or_else(|why| format!("refused: {why} | |"));
        println!("| {}, {}³, {} | {row} |", family.name(), size[0], size[1]);
    }
    println!(
        "\n| random paths of a pixel | paths | 10⁶ paths/s: card, processor | noise of a voxel %: card, processor |\n|---|---|---|---|"
    );
    for paths in [1, 4, 16].into_iter().filter(|_| is_asked("paths")) {
        let row =
            of_paths(&gpu, paths, divisor).unwrap_or_else(|why| format!("refused: {why} | | |"));
        println!("| {paths} | {row}");
    }
    Ok(gpu.check()?)
}

/// Paths, rates and noise of doses of both devices, in the scene of the study `scatter_noise`.
fn of_paths(gpu: &Gpu, paths_per_pixel: usize, divisor: usize) -> Result<String, Failure> {
    let params = |seed| monte_carlo::Params {
        paths_per_pixel,
        seed,
        ..monte_carlo::Params::default()
    };
    scatter_noise::with_scene(divisor.max(1), |input| {
        let pixels = input.scene.lights[0].layout(0).len();
        let paths = (pixels * paths_per_pixel) as f64;
        let work = Work::new();
        let measured = |dose: &dyn Fn(u64) -> Result<(f64, Vec<f32>), Failure>| {
            let all: Result<Vec<_>, _> = (0..scatter_noise::SEEDS).map(dose).collect();
            let (seconds, doses): (Vec<f64>, Vec<Vec<f32>>) = all?.into_iter().unzip();
            let least = seconds.into_iter().fold(f64::INFINITY, f64::min);
            let [noise, _] = scatter_noise::noise(&doses);
            Ok::<_, Failure>([1e-6 * paths / least, 100.0 * noise])
        };
        let card = measured(&|seed| {
            let form = params(seed).form(input)?.ok_or("the model has no form")?;
            timed(&*model_on(gpu, &form, &work)?)
        })?;
        let processor = measured(&|seed| timed(&*params(seed).build(input)?))?;
        let both = |i: usize| format!("{:.2}, {:.2}", card[i], processor[i]);
        Ok(format!("{paths:.1e} | {} | {} |", both(0), both(1)))
    })
}

/// Seconds of the second dose of all pixels at 1, with its copy to the host, and that dose.
fn timed<F: Field>(model: &dyn DoseModel<Field = F>) -> Result<(f64, Vec<f32>), Failure> {
    scatter_noise::even_dose(model)?;
    let begin = Instant::now();
    let dose = scatter_noise::even_dose(model)?;
    Ok((begin.elapsed().as_secs_f64(), dose))
}

/// The job file of a row.
fn job_text(size: Size, scene: &str, iterations: usize, mesh: Option<&String>) -> String {
    let Size {
        voxels,
        frames,
        pixels,
        edge_mm,
        pixel,
    } = size;
    let pitch = edge_mm / voxels as f64;
    let part = match mesh {
        Some(mesh) => format!("target.mesh = {mesh:?}"),
        None => "target.phantom = \"gyroid\"".to_owned(),
    };
    let vial = if scene.contains("vial") {
        String::new()
    } else {
        format!("vial.index_matched.radius_mm = {}\n", 0.81 * edge_mm)
    };
    format!(
        "{scene}\n{vial}{part}\ntarget.size_mm = {}\ngrid = {{ shape = [{voxels}, {voxels}, {voxels}], pitch_mm = {pitch} }}\n\
         objective.threshold = {{ lower = 0.8, upper = 0.95 }}\noptimizer.lbfgs = {{}}\nstop = {{ iterations = {iterations}, change = 0 }}\n\
         [[light]]\nwavelength_nm = 405\npixels = [{pixels}, {pixels}]\nangles = {frames}\nprojector.collimated = {{ pixel_pitch_mm = {} }}\n",
        if edge_mm == BENCHMARK.edge_mm {
            8.0
        } else {
            edge_mm / 1.42
        },
        pixel * pitch,
    )
}

/// The report of a row's job on a device.
fn finished(text: &str, title: &str, device: &str) -> Result<Value, Failure> {
    let mut document = Document::toml(Path::new("cards.toml"), text)?;
    document.set(&format!("resources.device={device:?}"))?;
    let name = format!("{title} {device}").replace(['³', ','], "");
    let folder = Path::new("out/cards").join(name.replace([' ', ':'], "-"));
    let job = Job::from_document(document)?.with_folder(&folder, "");
    let run = job::run(&job, false, &mut Silent, &Work::new())?;
    let report = std::fs::read_to_string(run.folder.join("report.json"))?;
    Ok(serde_json::from_str(&report)?)
}

/// Seconds and IoU of both reports.
fn line(card: &Value, processor: &Value) -> String {
    let seconds = |report: &Value, part: &str| {
        let seconds = report["run"]["timings_s"][part].as_f64();
        seconds.unwrap_or_default()
    };
    let parts = |report: &Value, parts: &[&str]| -> f64 {
        let seconds_of = |part: &&str| seconds(report, &format!("optimizing: {part}"));
        parts.iter().map(seconds_of).sum()
    };
    let both = |number_of: &dyn Fn(&Value) -> f64| {
        format!("{:.1}, {:.1}", number_of(card), number_of(processor))
    };
    let around = ["dose and adjoint", "objective", "steps, checkpoints"];
    format!(
        "{} | {} | {} | {:.5}, {:.5} |",
        both(&|report| parts(report, &around)),
        both(&|report| parts(report, &["pixels and start", "ceiling of the pixels"])),
        both(&|report| seconds(report, "evaluating the written patterns")),
        card["evaluation"]["iou"].as_f64().unwrap_or(f64::NAN),
        processor["evaluation"]["iou"].as_f64().unwrap_or(f64::NAN),
    )
}

/// Updates a call, and rates of dose and adjoint: an absorbing, index-matched cylinder that touches the sides of a cube of voxels, as many columns and
/// rows of pixels as voxels across and up.
fn rates(
    gpu: &Gpu,
    family: &dyn ModelFamily,
    [voxels, frames]: [usize; 2],
) -> Result<String, Failure> {
    /// Calls that are timed together.
    const CALLS: u32 = 4;
    let pitch = 10.0 / voxels as f64;
    let pixels = PatternGrid::full_turn(frames, 0.0, voxels, voxels, pitch);
    let (vial, work) = (IndexMatched { radius_mm: 5.0 }, Work::new());
    let lights = [Light::new(pixels, Resin::absorbing(1.5, 0.1))];
    let optics = [Optics::collimated(pitch)];
    let scene = OpticalScene::new(&vial, &lights, &optics, Purpose::Optimize);
    let grid = VolumeGrid::centered([voxels; 3], pitch);
    let input = ModelInput::new(scene, &grid, &work)?;
    let form = family.form(&input)?.ok_or("the model has no form")?;
    let model = model_on(gpu, &form, &work)?;
    let updates = model.updates() as f64;
    let mut x = model.new_patterns()?;
    x.fill(1.0);
    let (mut dose, mut grad) = (model.new_dose()?, model.new_patterns()?);
    let rate = |work: &mut dyn FnMut() -> Result<(), Failure>| {
        work()?;
        let begin = Instant::now();
        (0..CALLS).try_for_each(|_| work())?;
        Ok::<_, Failure>(updates * f64::from(CALLS) / begin.elapsed().as_secs_f64())
    };
    let forward = rate(&mut || {
        model.dose(&x, &mut dose, &work)?;
        // A number that is read waits for the card
        dose.max_abs();
        Ok(())
    })?;
    let adjoint = rate(&mut || {
        model.pullback(&x, &dose, &mut grad, &work)?;
        grad.max_abs();
        Ok(())
    })?;
    gpu.check()?;
    Ok(format!("{updates:.2e} | {forward:.2e} | {adjoint:.2e}"))
}
