//! Errors of the wave model's light by its sampling: a table of docs/validation.md.
//!
//! |ψ|² of random patterns of single pixels, before rotation, by the model and by the published algorithm (the [`twin`]) in several windows.
#![expect(clippy::print_stdout, reason = "a study prints its tables")]

mod twin;

use tomolith::Error;
use tomolith::field::Field;
use tomolith::grid::{PatternGrid, VolumeGrid};
use tomolith::models::wave::{self, Params};
use tomolith::models::{DoseModel, Work};
use tomolith::optics::light::Light;
use tomolith::optics::resin::Resin;
use tomolith::optics::vial::index_matched::IndexMatched;
use twin::{Twin, WAVENUMBER};

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

/// What stands between the first and the last bracket of a model's description.
fn sampling_of(model: &impl DoseModel) -> String {
    let described = model.describe();
    let begin = described.find('(').map_or(0, |i| i + 1);
    let end = described.rfind(')').unwrap_or(described.len());
    described[begin..end].to_owned()
}

/// |ψ|² `[x][u][z]` at some depths of n³ voxels, `off` voxels from their planes.
fn light_of_twin(twin: &Twin, x: &[f64], off: f64) -> Vec<Vec<f64>> {
    let planes = (0..twin.n).step_by(5);
    planes
        .map(|k| twin.intensity(x, twin.depth(k) - off * twin.pitch))
        .collect()
}

/// |ψ|² by the model, which is described: light comes from +x, so depth falls with x, in a vial with room to spare.
fn light_of_model(
    n: usize,
    pitch: f64,
    params: &Params,
    off: f64,
    x: &[f64],
) -> Result<(String, Vec<Vec<f64>>), Error> {
    let grid = VolumeGrid::centered([n, n, n], pitch).about([off * pitch, 0.0, 0.0]);
    let light = Light::new(
        PatternGrid::full_turn(1, 0.0, n, n, pitch),
        Resin::pure_radon(1.5),
    );
    let vial = IndexMatched {
        radius_mm: pitch * n as f64,
    };
    let model = wave::model(&vial, vec![light], params, grid)?;
    let mut field = model.new_patterns()?;
    let values: Vec<f32> = x.iter().map(|&v| v as f32).collect();
    field.copy_from_host(&values);
    let mut dose = model.new_dose()?;
    model.dose(&field, &mut dose, &Work::new())?;
    let layout = &model.outputs()[0];
    let at = |z, y, x| f64::from(dose.as_slice()[layout.index(z, y, x)]);
    let plane = |k: usize| (0..n * n).map(|i| at(i % n, i / n, n - 1 - k)).collect();
    Ok((sampling_of(&model), (0..n).step_by(5).map(plane).collect()))
}

/// Relative L2, and the largest difference over the largest value.
fn distance(a: &[Vec<f64>], b: &[Vec<f64>]) -> [f64; 2] {
    let (mut error, mut square, mut worst, mut most) = (0.0, 0.0, 0.0f64, 0.0f64);
    for (a, b) in a.iter().flatten().zip(b.iter().flatten()) {
        error += (a - b).powi(2);
        square += b * b;
        worst = worst.max((a - b).abs());
        most = most.max(b.abs());
    }
    [(error / square).sqrt(), worst / most]
}

/// |ψ|² of patterns of random pixels before rotation: the published window, and the model, against a window eight times as wide.
pub(crate) fn study(_: &[String]) -> Result<(), Box<dyn std::error::Error>> {
    let n = 64;
    let x = random_pixels(n * n);
    println!(
        "| edge, mm | edge of the band | window 2N: L2 | largest | tight window: L2 | largest |"
    );
    println!("|---|---|---|---|---|---|");
    for edge in EDGES {
        for soft_edge in [0.0, 0.25] {
            let pitch = edge / 550.0;
            let light = |window| light_of_twin(&Twin::new(n, pitch, window, soft_edge), &x, 0.3);
            let exact = light(8.0);
            let [double, tight] = [2.0, tight_window(pitch)]
                .map(|window| distance(&light(window), &exact))
                .map(|[l2, largest]| format!("{l2:.1e} | {largest:.1e}"));
            println!("| {edge} | {soft_edge} | {double} | {tight} |");
        }
    }
    println!("\n| edge, mm | asked | on planes: L2 | largest | between: L2 | largest | sampling |");
    println!("|---|---|---|---|---|---|---|");
    for edge in EDGES {
        // The pixels of the article, N = 550, of which a corner
        let pitch = edge / 550.0;
        let wide = Twin::new(n, pitch, 8.0, 0.25);
        for asked in [1e-2, 1e-3, 1e-4] {
            let params = Params {
                relative_error: asked,
                rotation_error: 1e-5,
                ..Params::default()
            };
            let mut found = Vec::new();
            let mut described = String::new();
            for off in [0.0, 0.5] {
                let light;
                (described, light) = light_of_model(n, pitch, &params, off, &x)?;
                found.push(distance(&light, &light_of_twin(&wide, &x, off)));
            }
            let [on, between] = [found[0], found[1]];
            println!(
                "| {edge} | {asked:.0e} | {:.1e} | {:.1e} | {:.1e} | {:.1e} | {} |",
                on[0], on[1], between[0], between[1], described
            );
        }
    }
    Ok(())
}
