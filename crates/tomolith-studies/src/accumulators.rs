//! The three accumulators of Nicolet et al. 2024, Fig. 4, in a resin that scatters.
//!
//! Even light of 24 frames of 32 × 16 pixels through a cylinder of glass, μ_a = μ_s = 0.15 per mm, Rayleigh; 32 × 32 × 16 voxels of
//! 0.125 mm; 16 paths a pixel, scattered light summed on voxels. Each is run with eight seeds; the mean is compared with the
//! integral's, noise is the rms deviation of a voxel over the mean dose. Prints a table; see docs/validation.md.
#![expect(clippy::print_stdout, reason = "a study prints its table")]

use std::error::Error;
use std::sync::Arc;
use std::time::Instant;
use tomolith::field::{Field, HostField};
use tomolith::grid::{PatternGrid, VolumeGrid};
use tomolith::models::rays::accumulation::Accumulation;
use tomolith::models::{DoseModel, Run, monte_carlo, rays::Optics};
use tomolith::optics::light::Light;
use tomolith::optics::phase::{Scattering, rayleigh::Rayleigh};
use tomolith::optics::resin::Resin;
use tomolith::optics::vial::cylinder::Cylinder;

const SEEDS: u64 = 8;

/// Doses of some seeds, and seconds of one.
fn doses(accumulation: Accumulation) -> Result<(Vec<HostField>, f64), Box<dyn Error>> {
    let mut light = Light::new(
        PatternGrid::full_turn(24, 0.0, 16, 32, 0.125),
        Resin::absorbing(1.48, 0.15),
    );
    light.resin.attenuation_per_mm = 0.3;
    let mut optics = Optics::collimated(0.125);
    optics.scattering = Some(Scattering {
        per_mm: 0.15,
        phase: Arc::new(Rayleigh {}),
    });
    let vial = Cylinder {
        inner_radius_mm: 3.5,
        outer_radius_mm: 4.0,
        refractive_index: 1.52,
    };
    let start = Instant::now();
    let mut found = Vec::new();
    for seed in 1..=SEEDS {
        let params = monte_carlo::Params {
            paths_per_pixel: 16,
            accumulation,
            seed,
            smooth: 1,
            ..monte_carlo::Params::default()
        };
        let grid = VolumeGrid::centered([16, 32, 32], 0.125);
        let optics = std::slice::from_ref(&optics);
        let model = monte_carlo::model(&vial, std::slice::from_ref(&light), optics, &params, grid)?;
        let mut x = DoseModel::new_patterns(&model)?;
        x.fill(1.0);
        let mut dose = DoseModel::new_dose(&model)?;
        model.dose(&x, &mut dose, &Run::new())?;
        found.push(dose);
    }
    Ok((found, start.elapsed().as_secs_f64() / SEEDS as f64))
}

/// Sum of all doses, and rms deviation of an element from the mean of its seeds, over the mean element that is lit.
fn spread(doses: &[HostField]) -> (f64, f64) {
    let count = doses.len() as f64;
    let (mut sum, mut squares, mut lit) = (0.0, 0.0, 0.0);
    for i in 0..doses[0].as_slice().len() {
        let of = || doses.iter().map(|dose| f64::from(dose.as_slice()[i]));
        let mean = of().sum::<f64>() / count;
        sum += mean;
        if mean > 0.0 {
            lit += 1.0;
            squares += of().map(|v| (v - mean).powi(2)).sum::<f64>() / (count - 1.0);
        }
    }
    (sum, (squares / lit).sqrt() / (sum / lit))
}

pub(crate) fn study(_: &[String]) -> Result<(), Box<dyn Error>> {
    println!(
        "accumulator            mean / integral's − 1   noise %   s a dose   noise² × s, integral = 1"
    );
    let ratio = |majorant_per_mm: f64| Accumulation::Ratio { majorant_per_mm };
    let kinds = [
        ("integral", Accumulation::Integral),
        ("simple", Accumulation::Simple),
        ("ratio, 1 per mm", ratio(1.0)),
        ("ratio, 10 per mm", ratio(10.0)),
        ("ratio, 60 per mm", ratio(60.0)),
    ];
    let mut first = None;
    for (name, kind) in kinds {
        let (doses, seconds) = doses(kind)?;
        let (sum, noise) = spread(&doses);
        let (whole, cost) = *first.get_or_insert((sum, noise * noise * seconds));
        println!(
            "{name:22} {:20.4}   {:8.2}   {seconds:8.3}   {:10.1}",
            sum / whole - 1.0,
            100.0 * noise,
            noise * noise * seconds / cost
        );
    }
    Ok(())
}
