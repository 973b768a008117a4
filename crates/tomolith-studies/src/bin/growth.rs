//! How time and memory of every dose model grow: `cargo run --release -p tomolith-studies --bin growth -- [LARGEST] [FOLDER]`.
//!
//! A ball in the middle of N³ voxels, N × N pixels as wide as voxels, N frames of a full turn, for N = 32, 48, 64, 96, 128, … up to LARGEST
//! (default 128); a model whose next size would take more than two minutes ends before it. Each size runs in a process of its own, which
//! builds the job's model and calls dose and adjoint until half a second of processor time has gone. Prints a table, exponents fitted to the
//! four largest sizes, and what 1024³ voxels with 1000 angles would take: the largest size times the larger power of the fitted one and the
//! theory's (memory: N³). FOLDER gets two pictures. See docs/measured/growth.md.
//! Processor time is of all threads (Linux).
#![expect(clippy::print_stdout, reason = "a study prints its table")]

use std::env;
use std::error::Error;
use std::path::{Path, PathBuf};
use std::process::Command;
use tomolith::field::{Field, HostField};
use tomolith::job::{Document, Job, ResolvedJob};
use tomolith::models::{DoseModel, Run};
use tomolith::report::number::significant;
use tomolith::report::plot::{Axis, Plot};

type Fallible<T> = Result<T, Box<dyn Error>>;

/// A model, the resin and the scale it is measured with, and how it should grow.
struct Case {
    name: &'static str,
    keys: &'static str,
    /// Edge of a voxel, mm; the ball grows with N.
    pitch_mm: f64,
    /// Exponent of the dose's time in N.
    theory: f64,
    why: &'static str,
}

const CLEAR: &str = "{ refractive_index = 1.5, absorption_per_mm = 0.05 }";
const SCATTERING: &str = "{ refractive_index = 1.5, absorption_per_mm = 0.05, scattering_per_mm = 0.05, phase.isotropic = {} }";
const NOT_ABSORBING: &str = "{ refractive_index = 1.5, pure_radon = true }";

const CASES: [Case; 6] = [
    Case {
        name: "parallel",
        keys: "model.parallel = {}\n",
        pitch_mm: 0.05,
        theory: 4.0,
        why: "voxels × frames",
    },
    Case {
        name: "rays",
        keys: "model.rays = {}\n",
        pitch_mm: 0.05,
        theory: 4.0,
        why: "pixels × frames × voxels along a ray",
    },
    Case {
        name: "successive_orders",
        keys: "model.successive_orders = {}\n",
        pitch_mm: 0.05,
        theory: 4.0,
        why: "voxels × frames",
    },
    Case {
        name: "monte_carlo",
        keys: "model.monte_carlo = {}\n",
        pitch_mm: 0.05,
        theory: 4.0,
        why: "pixels × frames × cells along a path",
    },
    Case {
        name: "wave",
        keys: "model.wave = { relative_error = 1e-3, rotation_error = 0.03 }\n",
        pitch_mm: 0.0016,
        theory: 4.0,
        why: "frames × depths × a plane's Fourier transform, N² log N",
    },
    Case {
        name: "incoherent_cone",
        keys: "model.incoherent_cone = {}\n",
        pitch_mm: 0.0016,
        theory: 4.0,
        why: "frames × depths × a plane's Fourier transform, N² log N",
    },
];

impl Case {
    /// The ball of N voxels in a vial around it.
    fn job(&self, n: usize) -> String {
        let (size, pitch) = (self.pitch_mm * n as f64, self.pitch_mm);
        let resin = match self.name {
            "successive_orders" | "monte_carlo" => SCATTERING,
            "wave" | "incoherent_cone" => NOT_ABSORBING,
            _ => CLEAR,
        };
        format!(
            "target = {{ phantom = \"sphere\", size_mm = {size} }}\n\
             grid = {{ shape = [{n}, {n}, {n}], pitch_mm = {pitch}, refine = 1, clip = true }}\n\
             resin = {resin}\n\
             vial = {{ index_matched = {{ radius_mm = {} }} }}\n\
             {}\
             light = [{{ wavelength_nm = 405, pixels = [{n}, {n}], angles = {n}, sub_angles = 1, projector = {{ collimated = {{ pixel_pitch_mm = {pitch} }} }} }}]\n\
             resources = {{ memory_gb = 1000 }}\n",
            0.8 * size,
            self.keys,
        )
    }
}

/// One size of a model.
#[derive(Clone, Copy)]
struct Size {
    n: usize,
    dose_s: f64,
    adjoint_s: f64,
    peak_mb: f64,
}

/// Processor time of this process so far, s.
fn processor_s() -> Fallible<f64> {
    let stat = std::fs::read_to_string("/proc/self/stat")?;
    let after_name = stat.rsplit(") ").next().ok_or("no name in stat")?;
    let ticks = after_name
        .split(' ')
        .skip(11)
        .take(2)
        .map(str::parse::<f64>);
    Ok(ticks.sum::<Result<f64, _>>()? / 100.0)
}

/// Highest memory of this process so far, MB.
fn peak_mb() -> Fallible<f64> {
    let status = std::fs::read_to_string("/proc/self/status")?;
    let line = status.lines().find(|line| line.starts_with("VmHWM"));
    let kilobytes = line.and_then(|line| line.split_whitespace().nth(1));
    Ok(kilobytes.ok_or("no peak in status")?.parse::<f64>()? / 1024.0)
}

/// Processor seconds of a call, repeated until half a second has gone.
fn timed(mut call: impl FnMut() -> tomolith::Result<()>) -> Fallible<f64> {
    call()?;
    let begin = processor_s()?;
    for count in 1.. {
        call()?;
        let gone = processor_s()? - begin;
        if gone >= 0.5 {
            return Ok(gone / f64::from(count));
        }
    }
    unreachable!("the loop ends by its return");
}

/// A child process: measures one size and prints it.
fn measure(case: &Case, n: usize) -> Fallible<()> {
    let text = case.job(n);
    let job = Job::from_document(Document::toml(Path::new("growth.toml"), &text)?)?;
    let run = Run::new();
    let task = ResolvedJob::new(&job)?.task(&run)?;
    let model: &dyn DoseModel<Field = HostField> = task.model.as_ref();
    let mut x = model.new_patterns()?;
    x.fill(1.0);
    let mut dose = model.new_dose()?;
    let mut gradient = x.zeros_like();
    let dose_s = timed(|| model.dose(&x, &mut dose, &run))?;
    let adjoint_s = timed(|| model.pullback(&x, &dose, &mut gradient, &run))?;
    println!("{dose_s} {adjoint_s} {}", peak_mb()?);
    Ok(())
}

/// One size in a process of its own.
fn in_a_process(case: &Case, n: usize) -> Fallible<Size> {
    let output = Command::new(env::current_exe()?)
        .args(["one", case.name, &n.to_string()])
        .output()?;
    let said = String::from_utf8(output.stdout)?;
    let numbers: Result<Vec<f64>, _> = said.split_whitespace().map(str::parse).collect();
    let [dose_s, adjoint_s, peak_mb] = numbers?[..] else {
        let why = String::from_utf8_lossy(&output.stderr).into_owned();
        return Err(format!("{} at {n}: {why}", case.name).into());
    };
    Ok(Size {
        n,
        dose_s,
        adjoint_s,
        peak_mb,
    })
}

/// Exponent of a power law through the last four points: least squares of the logarithms.
fn exponent(sizes: &[Size], of: impl Fn(&Size) -> f64) -> f64 {
    let last = &sizes[sizes.len().saturating_sub(4)..];
    let points = || last.iter().map(|s| ((s.n as f64).ln(), of(s).ln()));
    let count = last.len() as f64;
    let x = points().map(|p| p.0).sum::<f64>() / count;
    let y = points().map(|p| p.1).sum::<f64>() / count;
    let spread: f64 = points().map(|p| (p.0 - x).powi(2)).sum();
    points().map(|p| (p.0 - x) * (p.1 - y)).sum::<f64>() / spread
}

/// A number at N = 1024 if it grows so from the largest size on.
fn at_1024(sizes: &[Size], exponent: f64, of: impl Fn(&Size) -> f64) -> f64 {
    let last = sizes.last().map_or([f64::NAN; 2], |s| [s.n as f64, of(s)]);
    last[1] * (1024.0 / last[0]).powf(exponent)
}

fn sizes_up_to(largest: usize) -> impl Iterator<Item = usize> {
    let steps = (5..).flat_map(|k| [1usize << k, 3 << (k - 1)]);
    steps.take_while(move |n| *n <= largest)
}

/// All sizes of a model that end within two minutes.
fn grown(case: &Case, largest: usize) -> Fallible<Vec<Size>> {
    let mut sizes: Vec<Size> = Vec::new();
    for n in sizes_up_to(largest) {
        if let Some(last) = sizes.last() {
            let ratio = (n as f64 / last.n as f64).powf(case.theory);
            if 3.0 * (last.dose_s + last.adjoint_s) * ratio > 120.0 {
                break;
            }
        }
        let size = in_a_process(case, n)?;
        println!(
            "| {} | {n} | {} | {} | {:.0} |",
            case.name,
            significant(size.dose_s, 2),
            significant(size.adjoint_s, 2),
            size.peak_mb
        );
        sizes.push(size);
    }
    Ok(sizes)
}

/// Dose times of three models, and the theory's slope through the largest size of each.
fn picture(all: &[(&Case, Vec<Size>)]) -> String {
    let times = || {
        all.iter()
            .flat_map(|(_, sizes)| sizes.iter().map(|s| s.dose_s))
    };
    let (low, high) = times().fold((f64::MAX, 0.0f64), |(a, b), t| (a.min(t), b.max(t)));
    let largest = all
        .iter()
        .flat_map(|(_, sizes)| sizes.iter().map(|s| s.n))
        .max();
    let mut plot = Plot::new(
        Axis::log("N", 28.0, 1.2 * largest.unwrap_or(64) as f64),
        Axis::log("processor seconds a dose", 0.5 * low, 2.0 * high),
    );
    let classes = ["accent", "gel", "still"];
    for ((case, sizes), class) in all.iter().zip(classes) {
        let points: Vec<[f64; 2]> = sizes.iter().map(|s| [s.n as f64, s.dose_s]).collect();
        plot.dots(&points, class, case.name);
        let (Some(first), Some(last)) = (sizes.first(), sizes.last()) else {
            continue;
        };
        let theory = |n: f64| [n, last.dose_s * (n / last.n as f64).powf(case.theory)];
        plot.line(&[theory(first.n as f64), theory(last.n as f64)], class, "");
    }
    plot.file("Time of a dose: measured (dots) and theory (lines)")
}

fn main() -> Fallible<()> {
    let arguments: Vec<String> = env::args().skip(1).collect();
    if let [one, name, n] = &arguments[..]
        && one == "one"
    {
        let case = CASES
            .iter()
            .find(|case| case.name == name)
            .ok_or("no such model")?;
        return measure(case, n.parse()?);
    }
    let largest = arguments.first().map_or(Ok(128), |n| n.parse())?;
    println!("| model | N | dose, processor s | adjoint, processor s | peak, MB |");
    println!("|---|---|---|---|---|");
    let grow = |case| grown(case, largest).map(|sizes| (case, sizes));
    let all: Vec<(&Case, Vec<Size>)> = CASES.iter().map(grow).collect::<Result<_, _>>()?;
    println!(
        "\n| model | exponent of the dose | theory | of the adjoint | of the peak | a dose of 1024³ × 1000, processor h | its peak, GB |"
    );
    println!("|---|---|---|---|---|---|---|");
    for (case, sizes) in &all {
        let dose = exponent(sizes, |s| s.dose_s);
        let hours = at_1024(sizes, dose.max(case.theory), |s| s.dose_s) * 1000.0 / 1024.0 / 3600.0;
        println!(
            "| {} | {dose:.2} | {:.0}: {} | {:.2} | {:.2} | {} | {:.0} |",
            case.name,
            case.theory,
            case.why,
            exponent(sizes, |s| s.adjoint_s),
            exponent(sizes, |s| s.peak_mb),
            significant(hours, 2),
            at_1024(sizes, 3.0, |s| s.peak_mb) / 1024.0
        );
    }
    if let Some(folder) = arguments.get(1) {
        let (light, others) = all.split_at(3);
        let folder = PathBuf::from(folder);
        std::fs::write(folder.join("growth-light.svg"), picture(light))?;
        std::fs::write(folder.join("growth-paths-and-waves.svg"), picture(others))?;
    }
    Ok(())
}
