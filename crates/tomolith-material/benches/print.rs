//! A printed second, by its parts but for the light: `cargo bench -p tomolith-material --bench print`.
//!
//! 200³ voxels, one step of the material per second. What light costs is in `docs/speed.md`: 25 frames are 2·10⁸ updates less those of the corners.
//! Wall and processor seconds; the best of three.
#![expect(clippy::print_stdout, reason = "a bench prints its table")]

use std::time::Instant;
use tomolith_core::field::Field;
use tomolith_core::grid::{Volume, VolumeGrid};
use tomolith_core::target::label;
use tomolith_material::curves::Curves;
use tomolith_material::diffusion::Scheme;
use tomolith_material::domain::Domain;
use tomolith_material::mixing::Mixing;
use tomolith_material::photopolymer::{Curing, Inhibitor, Network, Params, Photopolymer};
use tomolith_material::print::Moment;

const N: usize = 200;
const PITCH: f64 = 0.05;

/// Processor seconds of this process, by hundredths.
fn processor_s() -> f64 {
    let stat = std::fs::read_to_string("/proc/self/stat").unwrap_or_default();
    let fields: Vec<&str> = stat.rsplit(')').next().unwrap_or("").split(' ').collect();
    let ticks = |i: usize| fields.get(i).and_then(|t| t.parse::<f64>().ok());
    (ticks(12).unwrap_or(0.0) + ticks(13).unwrap_or(0.0)) / 100.0
}

fn time(name: &str, mut work: impl FnMut()) {
    let mut best = [f64::INFINITY; 2];
    for _ in 0..3 {
        let (wall, processor) = (Instant::now(), processor_s());
        work();
        best[0] = best[0].min(wall.elapsed().as_secs_f64());
        best[1] = best[1].min(processor_s() - processor);
    }
    println!("{name:<55} {:8.3} s {:8.3} s", best[0], best[1]);
}

fn material(domain: &Domain, curing: Curing, scheme: Scheme, half: Option<f64>) -> Photopolymer {
    let oxygen = Inhibitor {
        diffusion_mm2_per_s: 1e-4,
        half_saturation: half,
        ..Inhibitor::default()
    };
    let network = Network {
        inhibitors: vec![oxygen],
        ..Network::new("acrylate", curing)
    };
    let params = Params::new(vec![network]).diffusing_by(scheme);
    Photopolymer::new(params, Mixing::identity(1), domain.clone()).unwrap()
}

fn main() {
    let grid = VolumeGrid::centered([N; 3], PITCH);
    let domain = Domain::new(grid.clone());
    let threads = rayon::current_num_threads();
    println!(
        "{threads} threads, {N}³ voxels{:>35} {:>10}",
        "wall", "processor"
    );
    let mut light = domain.zeros();
    light.fill(0.01);
    let rate = |exponent: f64| Curing::RateLaw {
        rate_per_s: 1.0,
        exponent,
        gel_conversion: 0.3,
    };
    let mut resin = Volume::filled(grid.clone(), true);
    resin.values[0] = false;
    let walled = domain.clone().with_walls(&resin).unwrap();
    let plain = || Curing::threshold(1.0);
    for (name, domain, curing, scheme, half) in [
        (
            "faces, zeroth order, threshold",
            &domain,
            plain(),
            Scheme::Faces,
            None,
        ),
        ("the same with walls", &walled, plain(), Scheme::Faces, None),
        (
            "faces, zeroth order, rate law m = 1/2",
            &domain,
            rate(0.5),
            Scheme::Faces,
            None,
        ),
        (
            "faces, smooth, rate law m = 0.7",
            &domain,
            rate(0.7),
            Scheme::Faces,
            Some(0.05),
        ),
        (
            "spectral, zeroth order, threshold",
            &domain,
            plain(),
            Scheme::Spectral,
            None,
        ),
    ] {
        let material = material(domain, curing, scheme, half);
        let mut state = material.start().unwrap();
        time(&format!("step: {name}"), || {
            material.step(&mut state, &[light.as_slice()], 1.0).unwrap();
        });
    }
    let material = material(&domain, plain(), Scheme::Faces, None);
    let state = material.start().unwrap();
    let mut curves = Curves::new(&material, 0, &Volume::filled(grid, label::PART)).unwrap();
    time("curves of a moment", || {
        curves.watch(&Moment {
            seconds: 1.0,
            steps: [1, 2],
            block_s: 1.0,
            material: &material,
            state: &state,
            absorbed: &[light.as_slice()],
        });
    });
}
