//! What the wave model saves against the published algorithm, and what that costs in accuracy: the tables of `docs/validation.md`.
//!
//! `waves errors | rotation | savings [N …] | times [N …] | frame N [edge, mm …] | work | limit`
//!
//! The [`twin`] is the published algorithm. `errors` compares |ψ|² of random patterns of single pixels before rotation, `rotation` after it; `savings`
//! gives what each saving alone costs in accuracy, `times` seconds per gradient (a dose and a pullback) for N³ voxels and one frame, `frame` those of
//! the model alone, `work` its Fourier operations at the article's size; `limit` compares waves with rays while everything grows.
#![expect(clippy::print_stdout, reason = "a bench prints its tables")]

mod errors;
mod twin;

use std::time::Instant;
use tomolith::Error;
use tomolith::field::{Field, HostField};
use tomolith::grid::{PatternGrid, VolumeGrid};
use tomolith::models::parallel::Parallel;
use tomolith::models::wave::{Params, Wave};
use tomolith::models::{DoseModel, Run};
use tomolith::optics::light::Light;
use tomolith::optics::resin::Resin;
use tomolith::optics::vial::index_matched::IndexMatched;
use twin::{Gather, Savings, Twin, WAVENUMBER};

/// Random amplitudes of single pixels, 0 or 1: the worst case of the notes.
fn random_pixels(len: usize) -> Vec<f64> {
    tomolith::check::noise(11, len)
        .iter()
        .map(|&v| f64::from(u8::from(v > 0.0)))
        .collect()
}

/// Edges of the article's volumes, mm.
const EDGES: [f64; 3] = [0.1, 1.0, 10.0];

/// Window over pattern that holds how far the steepest component on the axis travels sideways, and no more.
fn tight_window(pitch: f64) -> f64 {
    let slope = 0.5 / pitch / (WAVENUMBER.powi(2) - (0.5 / pitch).powi(2)).max(0.0).sqrt();
    (1.0 + 0.5 * slope).min(2.0)
}

/// The savings that are tried alone, with their names, for N pixels of a pitch.
fn savings_of(n: usize, pitch: f64) -> Vec<(&'static str, Savings)> {
    let window = tight_window(pitch);
    // Frequencies along the depth reach from those of the corner of the band to 1/λ
    let corner = (WAVENUMBER.powi(2) - 0.5 / pitch.powi(2)).max(0.0).sqrt();
    let nodes = std::f64::consts::PI * (WAVENUMBER - corner) * n as f64 * pitch + 8.0;
    let nodes = Some((nodes.ceil() as usize).min(n));
    let none = Savings::NONE;
    let one_transform = Savings {
        one_transform: true,
        ..none
    };
    let mirror = Savings {
        mirror: true,
        ..none
    };
    let gather = |gather| Savings { gather, ..none };
    let basis = Savings {
        nodes,
        ..gather(Gather::Basis)
    };
    let all = Savings {
        one_transform: true,
        mirror: true,
        window,
        ..basis
    };
    vec![
        ("as the published code", none),
        ("one transform", one_transform),
        ("mirror", mirror),
        ("tight window", Savings { window, ..none }),
        ("Chebyshev depths", Savings { nodes, ..none }),
        ("gather", gather(Gather::Planes)),
        ("Chebyshev depths as a basis", basis),
        ("all of these", all),
    ]
}

/// Seconds per gradient of one frame, on one thread; in brackets what of them the turning takes.
fn times(sizes: &[usize]) -> Result<(), Error> {
    let names: Vec<&str> = savings_of(64, 1.0).iter().map(|(name, _)| *name).collect();
    println!(
        "| N | edge, mm | {} | Tomolith | code/Tomolith |",
        names.join(" | ")
    );
    println!("|{}", "---|".repeat(names.len() + 4));
    let pool = one_thread()?;
    for &n in sizes {
        for edge in EDGES {
            let pitch = edge / n as f64;
            let x: Vec<f32> = random_pixels(n * n).iter().map(|&v| v as f32).collect();
            let cotangent = tomolith::check::noise(5, n * n * n);
            let twins: Vec<[f64; 2]> = (savings_of(n, pitch).into_iter())
                .map(|(_, savings)| {
                    Twin::<f32>::new(n, pitch, savings).gradient(&x, &cotangent, 0.4)
                })
                .collect();
            let (ours, _) = pool.install(|| ours(n, pitch))?;
            let shown = |[all, turning]: &[f64; 2]| format!("{all:.3} ({turning:.3})");
            let shown: Vec<String> = twins.iter().map(shown).collect();
            println!(
                "| {n} | {edge} | {} | {ours:.4} | {:.0} |",
                shown.join(" | "),
                twins[0][0] / ours
            );
        }
    }
    Ok(())
}

/// Some frames of n² pixels around n³ voxels of the same size, in a vial that holds them.
fn scene(n: usize, pitch: f64, frames: usize) -> (IndexMatched, Light, VolumeGrid) {
    let pixels = PatternGrid::full_turn(frames, 0.4, n, n, pitch);
    let vial = IndexMatched {
        radius_mm: 0.5 * pitch * n as f64,
    };
    let grid = VolumeGrid::centered([n, n, n], pitch);
    (vial, Light::new(pixels, Resin::pure_radon(1.5)), grid)
}

/// Seconds per frame of the model's dose and pullback, of a few frames, and operations of its Fourier transforms.
fn ours(n: usize, pitch: f64) -> Result<(f64, Wave), Error> {
    let frames = if n > 300 { 4 } else { 8 };
    let (vial, light, grid) = scene(n, pitch, frames);
    let model = Wave::new(&vial, vec![light], &Params::default(), grid)?;
    let (mut x, mut dose) = (model.new_patterns()?, model.new_dose()?);
    x.fill(1.0);
    let mut gradient = x.zeros_like();
    let run = Run::new();
    let mut least = f64::INFINITY;
    for _ in 0..2 {
        let begin = Instant::now();
        model.dose(&x, &mut dose, &run)?;
        model.pullback(&x, &dose, &mut gradient, &run)?;
        least = least.min(begin.elapsed().as_secs_f64() / frames as f64);
    }
    Ok((least, model))
}

/// Seconds of a dose and a pullback of one frame of N² pixels onto N³ voxels, one thread.
fn frame(arguments: &[String]) -> Result<(), Error> {
    let pool = one_thread()?;
    let numbers: Vec<f64> = arguments.iter().filter_map(|a| a.parse().ok()).collect();
    let (n, edges) = numbers.split_first().unwrap_or((&64.0, &EDGES));
    let edges = if edges.is_empty() { &EDGES } else { edges };
    println!("| N | edge, mm | seconds | Fourier operations | sampling |");
    println!("|---|---|---|---|---|");
    for edge in edges {
        let pitch = edge / n;
        let (seconds, model) = pool.install(|| ours(*n as usize, pitch))?;
        let operations = model.operations() / model.patterns()[0].grid.frames() as f64;
        println!(
            "| {n} | {edge} | {seconds:.4} | {operations:.2e} | {} |",
            sampling_of(&model)
        );
    }
    Ok(())
}

fn one_thread() -> Result<rayon::ThreadPool, Error> {
    let pool = rayon::ThreadPoolBuilder::new().num_threads(1).build();
    pool.map_err(|e| Error::config("threads", e.to_string(), "one thread"))
}

/// What stands between the first and the last bracket of a model's description.
fn sampling_of(model: &Wave) -> String {
    let described = model.describe();
    let begin = described.find('(').map_or(0, |i| i + 1);
    let end = described.rfind(')').unwrap_or(described.len());
    described[begin..end].to_owned()
}

/// Fourier work of one gradient at N = 550 and 600 frames, against the published code: 6N transforms of (2N)² a frame.
fn work() -> Result<(), Error> {
    println!("| edge, mm | NA | published code, operations | Tomolith | ratio | sampling |");
    println!("|---|---|---|---|---|---|");
    let (n, frames) = (550, 600.0);
    let m = 2.0 * n as f64;
    let published = frames * 6.0 * n as f64 * 5.0 * m * m * (m * m).log2();
    for (edge, aperture) in [(0.1, None), (0.1, Some(0.3)), (1.0, None), (10.0, None)] {
        let params = Params {
            numerical_aperture: aperture,
            ..Params::default()
        };
        let (vial, light, grid) = scene(n, edge / n as f64, 1);
        let model = Wave::new(&vial, vec![light], &params, grid)?;
        let ours = frames * model.operations();
        println!(
            "| {edge} | {} | {published:.2e} | {ours:.2e} | {:.1} | {} |",
            aperture.map_or("–".to_owned(), |na| na.to_string()),
            published / ours,
            sampling_of(&model)
        );
    }
    Ok(())
}

/// The same patterns by waves and by rays while everything grows.
fn limit() -> Result<(), Error> {
    println!(
        "| edge, mm | pixel, µm | dose of waves against rays, relative L2 | the same, blurred over three voxels |"
    );
    println!("|---|---|---|---|");
    let n = 64;
    for edge in [0.05, 0.1, 0.2, 0.5, 1.0, 2.0, 5.0, 10.0, 20.0] {
        let pitch = edge / n as f64;
        let (vial, light, grid) = scene(n, pitch, 60);
        let rays = Parallel::new(&vial, vec![light.clone()], grid.clone())?;
        let waves = Wave::new(&vial, vec![light], &Params::default(), grid.clone())?;
        // Random blocks of four by four pixels, lit or dark
        let mut energies = DoseModel::new_patterns(&rays)?;
        let blocks = random_pixels(60 * n * n / 16);
        for (i, value) in energies.as_mut_slice().iter_mut().enumerate() {
            *value = blocks[i / (4 * n) * (n / 4) + i % n / 4] as f32;
        }
        let mut amplitudes = energies.clone();
        for value in amplitudes.as_mut_slice() {
            *value = value.sqrt();
        }
        let run = Run::new();
        let dose_of =
            |model: &dyn DoseModel<Field = HostField>, x: &HostField| -> Result<Vec<f32>, Error> {
                let mut dose = model.new_dose()?;
                model.dose(x, &mut dose, &run)?;
                Ok(model.outputs()[0].volume_of(dose.as_slice()).values)
            };
        let (a, b) = (dose_of(&waves, &amplitudes)?, dose_of(&rays, &energies)?);
        println!(
            "| {edge} | {:.2} | {:.4} | {:.4} |",
            1e3 * pitch,
            difference(&a, &b),
            difference(&blurred(&a, n), &blurred(&b, n))
        );
    }
    Ok(())
}

fn difference(a: &[f32], b: &[f32]) -> f64 {
    let sum = |f: &dyn Fn(f64, f64) -> f64| -> f64 {
        a.iter()
            .zip(b)
            .map(|(&a, &b)| f(f64::from(a), f64::from(b)))
            .sum()
    };
    (sum(&|a, b| (a - b).powi(2)) / sum(&|_, b| b * b)).sqrt()
}

/// Means over 3 × 3 × 3 voxels, those at the faces left as they are.
fn blurred(values: &[f32], n: usize) -> Vec<f32> {
    let mut values = values.to_vec();
    for stride in [1, n, n * n] {
        let before = values.clone();
        for i in stride..values.len() - stride {
            values[i] = (before[i - stride] + before[i] + before[i + stride]) / 3.0;
        }
    }
    values
}

pub(crate) fn study(arguments: &[String]) -> Result<(), Box<dyn std::error::Error>> {
    let what = arguments.first().map_or("errors", String::as_str);
    let sizes: Vec<usize> = arguments
        .iter()
        .skip(1)
        .filter_map(|a| a.parse().ok())
        .collect();
    let done = match what {
        "times" if sizes.is_empty() => times(&[64, 128]),
        "times" => times(&sizes),
        "frame" => frame(&arguments[1..]),
        "rotation" => errors::rotation(),
        "savings" if sizes.is_empty() => errors::savings(&[64]),
        "savings" => errors::savings(&sizes),
        "limit" => limit(),
        "work" => work(),
        _ => errors::errors(),
    };
    Ok(done?)
}
