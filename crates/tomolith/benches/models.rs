//! Throughput of the dose models: `cargo bench -p tomolith --bench models` (add `-- quick` for the 256³ rows alone, `-- plane`
//! for single slices).
//!
//! One *update* is one voxel lit by one frame, counted after all masks. Per update the kernel reads two floats of lanes and
//! does two fused multiply-adds, half that where two opposite frames are one; dose and lanes themselves are streamed once per call. The best of three calls counts.
#![expect(clippy::print_stdout, reason = "a bench prints its table")]

use std::time::Instant;
use tomolith::field::Field;
use tomolith::grid::{PatternGrid, VolumeGrid};
use tomolith::models::parallel::{Light, Parallel};
use tomolith::models::{DoseModel, Run};
use tomolith::optics::resin::Resin;
use tomolith::optics::vial::{Vial, cylinder::Cylinder, index_matched::IndexMatched};

/// A row of the table: geometry at n³ voxels, n × n pixels.
struct Case {
    name: &'static str,
    vial: Box<dyn Vial>,
    resin: Resin,
    n: usize,
    /// Slices, and rows of pixels.
    slices: usize,
    angles: usize,
    /// Edge of the grid and of the field of pixels, mm.
    grid_mm: f64,
    field_mm: f64,
}

fn straight(n: usize, resin: Resin, name: &'static str) -> Case {
    let vial = Box::new(IndexMatched { radius_mm: 6.0 });
    Case {
        name,
        vial,
        resin,
        n,
        slices: n,
        angles: 360,
        grid_mm: 6.4,
        field_mm: 6.4,
    }
}

fn cases(quick: bool) -> Vec<Case> {
    let radon = Resin::pure_radon(1.4849);
    let absorbing = Resin::absorbing(1.4849, 0.1);
    let glass = Cylinder {
        inner_radius_mm: 8.0,
        outer_radius_mm: 8.7,
        refractive_index: 1.58,
    };
    let mut cases = vec![
        straight(256, radon, "straight"),
        straight(256, absorbing, "absorbing"),
        Case {
            name: "cylinder",
            vial: Box::new(glass),
            resin: absorbing,
            n: 256,
            slices: 256,
            angles: 360,
            grid_mm: 6.4,
            field_mm: 10.5,
        },
    ];
    if !quick {
        cases.extend([64, 128, 512].map(|n| straight(n, absorbing, "absorbing")));
    }
    cases
}

/// The rows of one slice of 512² voxels.
fn planes() -> Vec<Case> {
    let plane = |case: Case| Case {
        n: 512,
        slices: 1,
        ..case
    };
    cases(true).into_iter().map(plane).collect()
}

fn best_of_three(mut call: impl FnMut()) -> f64 {
    let time = |_| {
        let start = Instant::now();
        call();
        start.elapsed().as_secs_f64()
    };
    (0..3).map(time).fold(f64::MAX, f64::min)
}

/// Highest memory of this process so far, MB (Linux).
fn peak_mb() -> Option<u64> {
    let status = std::fs::read_to_string("/proc/self/status").ok()?;
    let line = status.lines().find(|l| l.starts_with("VmHWM"))?;
    Some(line.split_whitespace().nth(1)?.parse::<u64>().ok()? / 1024)
}

fn main() -> Result<(), tomolith::Error> {
    let asked = |name: &str| std::env::args().any(|a| a == name);
    let cases = if asked("plane") {
        planes()
    } else {
        cases(asked("quick"))
    };
    println!("{} threads", rayon::current_num_threads());
    println!("model      voxels     call      seconds  updates/s  bytes/update  peak MB  build s");
    for case in cases {
        let pixels = PatternGrid::full_turn(
            case.angles,
            0.0,
            case.slices,
            case.n,
            case.field_mm / case.n as f64,
        );
        let grid =
            VolumeGrid::centered([case.slices, case.n, case.n], case.grid_mm / case.n as f64);
        let start = Instant::now();
        let model = Parallel::new(
            case.vial.as_ref(),
            vec![Light::new(pixels, case.resin)],
            grid,
        )?;
        let built = start.elapsed().as_secs_f64();
        let run = Run::new();
        let (mut x, mut dose) = (model.new_patterns()?, model.new_dose()?);
        x.fill(1.0);
        let mut grad = x.zeros_like();
        let updates = DoseModel::updates(&model) as f64;
        // Pixels read once, lanes written and read once, dose read and written once, two floats a tap from the caches;
        // opposite frames of pure Radon share lanes and taps
        let share = if case.resin.pure_radon { 0.5 } else { 1.0 };
        let streamed = (1.0 + 2.0 * share) * x.len() as f64 + 2.0 * dose.len() as f64;
        let bytes = 8.0 * share + 4.0 * streamed / updates;
        let forward = best_of_three(|| model.dose(&x, &mut dose, &run).expect("never cancelled"));
        let adjoint = best_of_three(|| {
            model
                .pullback(&x, &dose, &mut grad, &run)
                .expect("never cancelled")
        });
        for (call, seconds) in [("dose", forward), ("adjoint", adjoint)] {
            println!(
                "{:10} {:>4}²·{:<4} {call:8} {seconds:8.3}  {:7.1} G  {bytes:12.2}  {:7}  {built:7.3}",
                case.name,
                case.n,
                case.slices,
                updates / seconds / 1e9,
                peak_mb().unwrap_or_default(),
            );
        }
    }
    Ok(())
}
