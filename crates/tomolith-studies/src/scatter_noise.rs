//! Noise and time of the dose by Monte Carlo paths.
//!
//! A square vial (7/8 mm, n 1.24; resin 1.347, attenuation 0.09 per mm, albedo 0.9, Rayleigh), 200 frames of 200 × 20 pixels of
//! 0.05 mm at value 1, 100 × 100 × 50 voxels of 0.05 mm. Five seeds; the noise of a voxel is its standard deviation over its mean,
//! averaged over voxels above half of the 99th percentile. Time × noise² does not depend on the number of paths, so it compares
//! programs at equal noise. Prints a table; see docs/speed.md.
#![expect(clippy::print_stdout, reason = "a study prints its table")]

use std::error::Error;
use std::time::Instant;
use tomolith::field::Field;
use tomolith::grid::{PatternGrid, VolumeGrid};
use tomolith::models::rays::Optics;
use tomolith::models::{
    DoseModel, ModelFamily, ModelInput, OpticalScene, Purpose, Work, monte_carlo,
};
use tomolith::optics::light::Light;
use tomolith::optics::phase::{Scattering, rayleigh::Rayleigh};
use tomolith::optics::resin::Resin;
use tomolith::optics::vial::square::Square;

pub(crate) const SEEDS: u64 = 5;

pub(crate) fn study(_: &[String]) -> Result<(), Box<dyn Error>> {
    println!("| paths | smooth | s per dose | noise, % | largest, % | s × %² |");
    println!("|---|---|---|---|---|---|");
    for (paths, smooth) in [(1, 1), (4, 1), (1, 4), (4, 4)] {
        let mut doses = Vec::new();
        let mut seconds = f64::INFINITY;
        for seed in 0..SEEDS {
            let begin = Instant::now();
            doses.push(dose(paths, smooth, seed)?);
            seconds = seconds.min(begin.elapsed().as_secs_f64());
        }
        let [mean, largest] = noise(&doses);
        println!(
            "| {paths} | {smooth} | {seconds:.2} | {:.2} | {:.1} | {:.2} |",
            100.0 * mean,
            100.0 * largest,
            seconds * (100.0 * mean).powi(2)
        );
    }
    Ok(())
}

/// The dose of all pixels at 1, model included.
fn dose(paths_per_pixel: usize, smooth: usize, seed: u64) -> Result<Vec<f32>, tomolith::Error> {
    let params = monte_carlo::Params {
        paths_per_pixel,
        smooth,
        seed,
        ..monte_carlo::Params::default()
    };
    with_scene(1, |input| even_dose(&*params.build(input)?))
}

/// The dose of all pixels at 1.
pub(crate) fn even_dose<F: Field>(
    model: &dyn DoseModel<Field = F>,
) -> Result<Vec<f32>, tomolith::Error> {
    let mut x = model.new_patterns()?;
    x.fill(1.0);
    let mut dose = model.new_dose()?;
    model.dose(&x, &mut dose, &Work::new())?;
    Ok(model.outputs()[0].volume_of(&dose.to_host()).values)
}

/// Calls `with` with the scene, of so many times fewer frames.
pub(crate) fn with_scene<T>(divisor: usize, with: impl FnOnce(&ModelInput<'_>) -> T) -> T {
    let vial = Square::new(7.0, 8.0, 1.24);
    let pixels = PatternGrid::full_turn((200 / divisor).max(1), 0.0, 20, 200, 0.05);
    let mut light = Light::new(pixels, Resin::absorbing(1.347, 0.009));
    light.resin.attenuation_per_mm = 0.09;
    light.surrounding_index = 1.0;
    let mut optics = Optics::collimated(0.05);
    optics.scattering = Some(Scattering::new(0.081, Rayleigh {}));
    let (grid, work) = (VolumeGrid::centered([50, 100, 100], 0.05), Work::new());
    let (lights, optics) = ([light], [optics]);
    let scene = OpticalScene::new(&vial, &lights, &optics, Purpose::Optimize);
    with(&ModelInput {
        scene,
        grid: &grid,
        cells: None,
        work: &work,
    })
}

/// Mean and largest of the standard deviation over the mean, of bright voxels.
pub(crate) fn noise(doses: &[Vec<f32>]) -> [f64; 2] {
    let count = doses.len() as f64;
    let of_voxel = |i: usize| {
        let values = doses.iter().map(|d| f64::from(d[i]));
        let mean = values.clone().sum::<f64>() / count;
        let squares: f64 = values.map(|v| (v - mean).powi(2)).sum();
        (mean, (squares / (count - 1.0)).sqrt())
    };
    let all: Vec<(f64, f64)> = (0..doses[0].len()).map(of_voxel).collect();
    let mut means: Vec<f64> = all.iter().map(|v| v.0).collect();
    means.sort_by(f64::total_cmp);
    let bright = 0.5 * means[means.len() * 99 / 100];
    let parts = all.iter().filter(|v| v.0 > bright).map(|v| v.1 / v.0);
    let (sum, n, most) = parts.fold((0.0, 0.0, 0.0f64), |a, v| (a.0 + v, a.1 + 1.0, a.2.max(v)));
    [sum / n, most]
}
