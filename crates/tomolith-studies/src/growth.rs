//! How time and memory of every dose model grow: `growth [LARGEST] [FOLDER]`, see docs/growth.md.
//!
//! N = 32, 48, 64, 96, 128, … up to LARGEST (default 128), each in a separate process, which calls dose and adjoint until half a second of
//! processor time (of all threads; Linux) has gone, a call of more than a minute once. FOLDER gets four pictures. `growth from FILE [FOLDER]`
//! takes the sizes from a file in place of measuring them; `growth one MODEL N` prints dose and adjoint, processor s, and peak, MB, of one.
#![expect(clippy::print_stdout, reason = "a study prints its table")]

use std::env;
use std::error::Error;
use std::path::Path;
use std::process::Command;
use tomolith::field::{Field, HostField};
use tomolith::job::{Document, Job, ResolvedJob};
use tomolith::models::{DoseModel, Work};
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
        // One of the four paths a pixel that are the default: a path costs the same
        keys: "model.monte_carlo = { paths_per_pixel = 1 }\n",
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

#[derive(Clone, Copy)]
struct Size {
    n: usize,
    dose_s: f64,
    adjoint_s: f64,
    peak_mb: f64,
}

/// A call that takes as long is measured once, processor s.
const LONG_S: f64 = 60.0;

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

/// Processor seconds of a call, repeated until half a second has gone. The first call is left out, as it builds tables and touches memory for the
/// first time, but where it takes so long that this is lost in it.
fn timed(mut call: impl FnMut() -> tomolith::Result<()>) -> Fallible<f64> {
    let begin = processor_s()?;
    call()?;
    let first = processor_s()? - begin;
    if first >= LONG_S {
        return Ok(first);
    }
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
    let work = Work::new();
    let task = ResolvedJob::new(&job)?.task(&work)?;
    let model: &dyn DoseModel<Field = HostField> = task.model.as_ref();
    let mut x = model.new_patterns()?;
    x.fill(1.0);
    let mut dose = model.new_dose()?;
    let mut gradient = x.zeros_like();
    let dose_s = timed(|| model.dose(&x, &mut dose, &work))?;
    let adjoint_s = timed(|| model.pullback(&x, &dose, &mut gradient, &work))?;
    println!("{dose_s} {adjoint_s} {}", peak_mb()?);
    Ok(())
}

/// One size in a separate process.
fn in_a_process(case: &Case, n: usize) -> Fallible<Size> {
    let output = Command::new(env::current_exe()?)
        .args(["growth", "one", case.name, &n.to_string()])
        .output()?;
    let text = String::from_utf8(output.stdout)?;
    let numbers: Result<Vec<f64>, _> = text.split_whitespace().map(str::parse).collect();
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

/// Exponent of a power law through the last four points, from which larger sizes are reckoned.
fn exponent(sizes: &[Size], number_of: impl Fn(&Size) -> f64) -> f64 {
    fitted(&sizes[sizes.len().saturating_sub(4)..], number_of)
}

/// The exponents through all points from N = 64 on, and through the last four.
fn exponents(sizes: &[Size], number_of: impl Fn(&Size) -> f64) -> String {
    let from = sizes.iter().position(|s| s.n >= 64).unwrap_or(0);
    format!(
        "{:.2}, {:.2}",
        fitted(&sizes[from..], &number_of),
        exponent(sizes, &number_of)
    )
}

/// Exponent of a power law through points: least squares of the logarithms.
fn fitted(sizes: &[Size], number_of: impl Fn(&Size) -> f64) -> f64 {
    let points = || sizes.iter().map(|s| ((s.n as f64).ln(), number_of(s).ln()));
    let count = sizes.len() as f64;
    let x = points().map(|p| p.0).sum::<f64>() / count;
    let y = points().map(|p| p.1).sum::<f64>() / count;
    let spread: f64 = points().map(|p| (p.0 - x).powi(2)).sum();
    points().map(|p| (p.0 - x) * (p.1 - y)).sum::<f64>() / spread
}

/// A number at N = 1024 if it grows so from the largest size on.
fn at_1024(sizes: &[Size], exponent: f64, number_of: impl Fn(&Size) -> f64) -> f64 {
    let last = sizes
        .last()
        .map_or([f64::NAN; 2], |s| [s.n as f64, number_of(s)]);
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
            "| {} | {n} | {:.1e} | {:.1e} | {:.0} |",
            case.name, size.dose_s, size.adjoint_s, size.peak_mb
        );
        sizes.push(size);
    }
    Ok(sizes)
}

/// What a picture shows of each size.
#[derive(Clone, Copy)]
struct Shown {
    label: &'static str,
    title: &'static str,
    number_of: fn(&Size) -> f64,
    /// The theory's exponent.
    exponent: fn(&Case) -> f64,
}

const TIME: Shown = Shown {
    label: "processor seconds a dose",
    title: "Time of a dose: measured (dots) and theory (lines)",
    number_of: |size| size.dose_s,
    exponent: |case| case.theory,
};
const MEMORY: Shown = Shown {
    label: "peak of the process, MB",
    title: "Memory: measured (dots) and N³ (lines)",
    number_of: |size| size.peak_mb,
    exponent: |_| 3.0,
};

/// A number of three models over N, and the theory's slope through the largest size of each.
fn picture(all: &[(&Case, Vec<Size>)], shown: Shown) -> String {
    let numbers = || {
        all.iter()
            .flat_map(|(_, sizes)| sizes.iter().map(shown.number_of))
    };
    let (low, high) = numbers().fold((f64::MAX, 0.0f64), |(a, b), t| (a.min(t), b.max(t)));
    let largest = all
        .iter()
        .flat_map(|(_, sizes)| sizes.iter().map(|s| s.n))
        .max();
    let mut plot = Plot::new(
        Axis::log("N", 28.0, 1.2 * largest.unwrap_or(64) as f64),
        Axis::log(shown.label, 0.5 * low, 2.0 * high),
    );
    let classes = ["accent", "gel", "void"];
    for ((case, sizes), class) in all.iter().zip(classes) {
        let points: Vec<[f64; 2]> = sizes
            .iter()
            .map(|s| [s.n as f64, (shown.number_of)(s)])
            .collect();
        plot.dots(&points, class, case.name);
        let Some(last) = sizes.last() else {
            continue;
        };
        let exponent = (shown.exponent)(case);
        let theory = |n: f64| {
            [
                n,
                (shown.number_of)(last) * (n / last.n as f64).powf(exponent),
            ]
        };
        // No lower than the plot
        let first = sizes.iter().map(|s| s.n as f64);
        let first = first
            .filter(|n| theory(*n)[1] >= 0.5 * low)
            .reduce(f64::min);
        let first = first.unwrap_or(last.n as f64);
        plot.line(&[theory(first), theory(last.n as f64)], class, "");
    }
    plot.file(shown.title)
}

/// Exponents of all models, and what they come to at 1024: time by the larger of the fitted and the theory's, memory by N³.
fn print_fits(all: &[(&Case, Vec<Size>)]) {
    println!(
        "\n| model | exponent of the dose: from 64, of the four largest | theory | of the adjoint | of the peak | a dose of 1024³ × 1000, processor h | its peak, GB |"
    );
    println!("|---|---|---|---|---|---|---|");
    for (case, sizes) in all {
        let dose = exponent(sizes, |s| s.dose_s);
        let hours = at_1024(sizes, dose.max(case.theory), |s| s.dose_s) * 1000.0 / 1024.0 / 3600.0;
        println!(
            "| {} | {} | {:.0}: {} | {} | {} | {} | {:.0} |",
            case.name,
            exponents(sizes, |s| s.dose_s),
            case.theory,
            case.why,
            exponents(sizes, |s| s.adjoint_s),
            exponents(sizes, |s| s.peak_mb),
            significant(hours, 2),
            at_1024(sizes, 3.0, |s| s.peak_mb) / 1024.0
        );
    }
}

/// The sizes in a table, as this program prints it.
fn read(file: &Path) -> Fallible<Vec<(&'static Case, Vec<Size>)>> {
    let text = std::fs::read_to_string(file)?;
    let sizes_of = |case: &'static Case| {
        let start = format!("| {} | ", case.name);
        let rows = text.lines().filter_map(|line| line.strip_prefix(&start));
        let sizes: Vec<Size> = rows.filter_map(row).collect();
        match sizes.is_empty() {
            true => Err(format!("{}: no size of {}", file.display(), case.name).into()),
            false => Ok((case, sizes)),
        }
    };
    CASES.iter().map(sizes_of).collect()
}

/// A row without the name of its model; none where it is one of another table.
fn row(line: &str) -> Option<Size> {
    let cells: Vec<&str> = line.trim_end_matches([' ', '|']).split(" | ").collect();
    let [n, dose, adjoint, peak] = cells[..] else {
        return None;
    };
    Some(Size {
        n: n.parse().ok()?,
        dose_s: dose.parse().ok()?,
        adjoint_s: adjoint.parse().ok()?,
        peak_mb: peak.parse().ok()?,
    })
}

fn write_pictures(all: &[(&Case, Vec<Size>)], folder: &Path) -> Fallible<()> {
    let (light, others) = all.split_at(3);
    for (name, cases, shown) in [
        ("growth-light.svg", light, TIME),
        ("growth-paths-and-waves.svg", others, TIME),
        ("growth-light-memory.svg", light, MEMORY),
        ("growth-paths-and-waves-memory.svg", others, MEMORY),
    ] {
        std::fs::write(folder.join(name), picture(cases, shown))?;
    }
    Ok(())
}

pub(crate) fn study(arguments: &[String]) -> Fallible<()> {
    if let [one, name, n] = arguments
        && one == "one"
    {
        let case = CASES
            .iter()
            .find(|case| case.name == name)
            .ok_or("no such model")?;
        return measure(case, n.parse()?);
    }
    let (all, folder) = match arguments {
        [from, file, folder @ ..] if from == "from" => (read(Path::new(file))?, folder.first()),
        _ => {
            let largest = arguments.first().map_or(Ok(128), |n| n.parse())?;
            println!("| model | N | dose, processor s | adjoint, processor s | peak, MB |");
            println!("|---|---|---|---|---|");
            let grow = |case| grown(case, largest).map(|sizes| (case, sizes));
            let all = CASES.iter().map(grow).collect::<Result<_, _>>()?;
            (all, arguments.get(1))
        }
    };
    print_fits(&all);
    match folder {
        Some(folder) => write_pictures(&all, Path::new(folder)),
        None => Ok(()),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_size_is_read_as_it_is_printed() {
        let size = row("32 | 0.00072 | 9.0e-7 | 1496 |").unwrap();
        let numbers = [size.dose_s, size.adjoint_s, size.peak_mb];
        assert_eq!((size.n, numbers), (32, [7.2e-4, 9e-7, 1496.0]));
        assert!(row("4.10 | 4: voxels × frames | 3.99 | 2.57 | 0.031 | 28 |").is_none());
    }
}
