//! Throughput of the dose models: `cargo bench -p tomolith --bench models` (add `-- quick` for the 256³ rows alone, `-- plane`
//! for single slices of 512² and packs of 64 of them, `-- matrix FILE` for a stored matrix of such a slice; `peers_2d.py`
//! beside this file runs both next to other programs; `-- frame` for the gradient of one frame of 180).
//!
//! One *update* is one voxel lit by one frame, counted after all masks. Per update the kernel reads two floats of lanes and
//! does two fused multiply-adds, half that where two opposite frames are one; dose and lanes themselves are streamed once
//! per call. The best of three calls counts.
#![expect(clippy::print_stdout, reason = "a bench prints its table")]

use std::path::Path;
use std::time::Instant;
use tomolith::field::{Field, HostField};
use tomolith::grid::{PatternGrid, VolumeGrid};
use tomolith::io::csr::Csr;
use tomolith::models::matrix::MatrixModel;
use tomolith::models::parallel::{Kernel, Parallel};
use tomolith::models::{DoseModel, Work};
use tomolith::optics::light::Light;
use tomolith::optics::resin::Resin;
use tomolith::optics::vial::{Vial, cylinder::Cylinder, index_matched::IndexMatched};

/// A row of the table: geometry at n³ voxels, n × n pixels.
struct Case {
    name: &'static str,
    vial: Box<dyn Vial>,
    resin: Resin,
    kernel: Kernel,
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
        kernel: Kernel::DistanceDriven,
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
    let glass = Cylinder::new(8.0, 8.7, 1.58);
    let mut cases = vec![
        straight(256, radon, "straight"),
        straight(256, absorbing, "absorbing"),
        Case {
            name: "cylinder",
            vial: Box::new(glass),
            resin: absorbing,
            kernel: Kernel::DistanceDriven,
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

/// The rows of one slice of 512² voxels, and of many 2D problems with one geometry, which are as many slices.
fn planes() -> Vec<Case> {
    let cases_of = |slices: usize| {
        cases(true).into_iter().map(move |case| Case {
            n: 512,
            slices,
            ..case
        })
    };
    let line = Case {
        kernel: Kernel::Line,
        slices: 1,
        ..straight(512, Resin::pure_radon(1.4849), "line")
    };
    cases_of(1).chain([line]).chain(cases_of(PACK)).collect()
}

/// 2D problems of a pack.
const PACK: usize = 64;

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

impl Case {
    fn grid(&self) -> VolumeGrid {
        let pitch = self.grid_mm / self.n as f64;
        VolumeGrid::centered([self.slices, self.n, self.n], pitch)
    }

    fn pixels(&self) -> PatternGrid {
        let pitch = self.field_mm / self.n as f64;
        PatternGrid::full_turn(self.angles, 0.0, self.slices, self.n, pitch)
    }
}

/// Times both calls of a model and prints a row for each.
fn rows(
    case: &Case,
    model: &dyn DoseModel<Field = HostField>,
    updates: f64,
    built: f64,
) -> Result<(), tomolith::Error> {
    let work = Work::new();
    let (mut x, mut dose) = (model.new_patterns()?, model.new_dose()?);
    x.fill(1.0);
    let mut grad = x.zeros_like();
    // Pixels read once, lanes written and read once, dose read and written once, two floats a tap from the caches;
    // opposite frames of pure Radon share lanes and taps
    let share = if case.resin.pure_radon { 0.5 } else { 1.0 };
    let streamed = (1.0 + 2.0 * share) * x.len() as f64 + 2.0 * dose.len() as f64;
    let bytes = 8.0 * share + 4.0 * streamed / updates;
    let forward = best_of_three(|| model.dose(&x, &mut dose, &work).expect("never canceled"));
    let adjoint = best_of_three(|| {
        model
            .pullback(&x, &dose, &mut grad, &work)
            .expect("never canceled")
    });
    for (call, seconds) in [("dose", forward), ("adjoint", adjoint)] {
        println!(
            "{:10} {:>4}²·{:<4} {call:8} {seconds:8.4}  {:7.2} G  {bytes:12.2}  {:7}  {built:7.3}",
            case.name,
            case.n,
            case.slices,
            updates / seconds / 1e9,
            peak_mb().unwrap_or_default(),
        );
    }
    Ok(())
}

/// A matrix of one slice of 512² voxels by 360 frames of 512 columns.
fn matrix(file: &Path) -> Result<(), tomolith::Error> {
    let straight = straight(512, Resin::pure_radon(1.4849), "matrix");
    let case = Case {
        slices: 1,
        ..straight
    };
    let start = Instant::now();
    let model = MatrixModel::new(&Csr::read(file)?, vec![case.pixels()], case.grid())?;
    let built = start.elapsed().as_secs_f64();
    rows(&case, &model, (512 * 512 * case.angles) as f64, built)
}

/// Processor seconds of this thread so far (Linux).
fn processor_s() -> Option<f64> {
    let text = std::fs::read_to_string("/proc/thread-self/schedstat").ok()?;
    Some(text.split_whitespace().next()?.parse::<f64>().ok()? * 1e-9)
}

/// Processor seconds of one thread for the gradient of one frame of 180 at 200³: taken from that of all frames, and computed alone.
fn one_frame() -> Result<(), tomolith::Error> {
    println!("model      all frames, s  frame 45 alone, s  its dose, s  ratio");
    for case in cases(true) {
        let case = Case {
            n: 200,
            slices: 200,
            angles: 180,
            ..case
        };
        let light = Light::new(case.pixels(), case.resin);
        let model = Parallel::new(case.vial.as_ref(), vec![light], case.grid())?;
        let work = Work::new();
        let (mut x, mut dose) = (model.new_patterns()?, model.new_dose()?);
        x.fill(1.0);
        model.dose(&x, &mut dose, &work)?;
        let mut grad = x.zeros_like();
        let pool = rayon::ThreadPoolBuilder::new().num_threads(1).build();
        let pool = pool.expect("a thread");
        let least = |call: &mut (dyn FnMut() + Send)| {
            let timed = |_| {
                pool.install(|| {
                    let start = processor_s().unwrap_or(f64::NAN);
                    call();
                    processor_s().unwrap_or(f64::NAN) - start
                })
            };
            (0..3).map(timed).fold(f64::MAX, f64::min)
        };
        let never = "never canceled";
        let all = least(&mut || model.pullback(&x, &dose, &mut grad, &work).expect(never));
        let one = least(&mut || {
            let done = model.pullback_of(45..46, &x, &dose, &mut grad, &work);
            done.expect(never);
        });
        let mut sum = dose.zeros_like();
        let forward = least(&mut || model.dose_of(45..46, &x, &mut sum, &work).expect(never));
        println!(
            "{:10} {all:13.4}  {one:17.4}  {forward:11.4}  {:5.0}",
            case.name,
            all / one
        );
    }
    Ok(())
}

fn main() -> Result<(), tomolith::Error> {
    let arguments: Vec<String> = std::env::args().collect();
    let asked = |name: &str| arguments.iter().any(|a| a == name);
    if asked("frame") {
        return one_frame();
    }
    println!("{} threads", rayon::current_num_threads());
    println!("model      voxels     call      seconds  updates/s  bytes/update  peak MB  build s");
    if let Some(i) = arguments.iter().position(|a| a == "matrix") {
        return matrix(Path::new(&arguments[i + 1]));
    }
    let cases = if asked("plane") {
        planes()
    } else {
        cases(asked("quick"))
    };
    for case in cases {
        let lights = vec![Light::new(case.pixels(), case.resin)];
        let (vial, run) = (case.vial.as_ref(), Work::new());
        let start = Instant::now();
        let model = Parallel::under(vial, lights, case.kernel, case.grid(), &run)?;
        let built = start.elapsed().as_secs_f64();
        rows(&case, &model, model.updates() as f64, built)?;
    }
    Ok(())
}
