//! What a projector of few levels prints: rounded, diffused and optimized patterns of a job, as docs/choices.md has them.
//!
//! All patterns are evaluated by `simulate` as the job says (written, the vial turning, finer voxels). *Rounded* takes the nearest level of the
//! brightest pixel; *diffused* carries the error of a pixel to the same pixel of the next frame, at the one of eight full scales that prints
//! best; *optimized* is `evaluate.levels = "optimized"`.
//!
//! ```sh
//! cargo run --release -p tomolith-studies -- levels examples/01-gear.toml 1,2,3,4,5
//! ```
//!
//! Run folders go to `out/levels/`.
#![expect(clippy::print_stdout, reason = "a study prints its table")]

use std::path::{Path, PathBuf};
use tomolith::Error;
use tomolith::exposure::quantize;
use tomolith::grid::{PatternGrid, Patterns};
use tomolith::io::npy::{PatternPair, read_patterns, write_patterns};
use tomolith::job::summary::Quality;
use tomolith::job::{self, Job, Silent};
use tomolith::models::Run;

/// Full scales over the brightest pixel.
const SCALES: [f32; 8] = [1.0, 0.85, 0.7, 0.55, 0.45, 0.35, 0.25, 0.18];

pub(crate) fn study(arguments: &[String]) -> Result<(), Box<dyn std::error::Error>> {
    let [file, bits] = arguments else {
        return Err("give a job and numbers of bits: levels JOB.toml 1,2,3".into());
    };
    let case = Case {
        file: PathBuf::from(file),
        folder: PathBuf::from("out/levels").join(Path::new(file).file_stem().unwrap_or_default()),
    };
    println!("| bits | rounded | diffused | optimized |\n|---|---|---|---|");
    let fine = case.folder.join("fine");
    let unrounded = case.run(&["evaluate.bit_depth=16".to_owned()], &fine)?;
    let patterns = fine.join("patterns.npz");
    for bits in bits.split(',').filter_map(|bits| bits.parse().ok()) {
        let keys = |levels: &str| {
            let depth = format!("evaluate.bit_depth={bits}");
            vec![depth, format!("evaluate.levels={levels}")]
        };
        let wanted = wanted(&patterns)?;
        let plain = quantize(&wanted, bits)?.patterns();
        let rounded = cell(&case.judged(&keys("rounded"), &plain, "rounded")?);
        let diffused = case.diffused(&keys("rounded"), &wanted, bits)?;
        let optimized = case.run(&keys("optimized"), &case.folder.join("optimized"))?;
        println!("| {bits} | {rounded} | {diffused} | {optimized} |");
    }
    println!("unrounded: {unrounded}");
    Ok(())
}

/// A job file, and where its runs go.
struct Case {
    file: PathBuf,
    folder: PathBuf,
}

impl Case {
    fn job(&self, keys: &[String], folder: &Path) -> Result<Job, Error> {
        Ok(Job::read(&self.file, keys)?
            .with_folder(folder, "")
            .overwriting())
    }

    /// Optimizes and judges.
    fn run(&self, keys: &[String], folder: &Path) -> Result<String, Error> {
        let job = self.job(keys, folder)?;
        let summary = job::run(&job, false, &mut Silent, &Run::new())?;
        Ok(cell(&summary.evaluation))
    }

    /// What is shown, judged.
    fn judged(&self, keys: &[String], shown: &Patterns, name: &str) -> Result<Quality, Error> {
        let file = self.folder.join(format!("{name}.npz"));
        let pair = PatternPair {
            light: None,
            shown,
            raw: None,
        };
        write_patterns(&file, &[pair], &Run::new())?;
        let job = self.job(keys, &self.folder.join(name))?;
        Ok(job::simulate(&job, &file, &mut Silent, &Run::new())?.evaluation)
    }

    /// The full scale that prints best.
    fn diffused(&self, keys: &[String], wanted: &Patterns, bits: u32) -> Result<String, Error> {
        let mut best: Option<Quality> = None;
        for scale in SCALES {
            let shown = diffused(wanted, scale, bits);
            let print = self.judged(keys, &shown, "diffused")?;
            if best.as_ref().is_none_or(|best| best.iou < print.iou) {
                best = Some(print);
            }
        }
        Ok(best.as_ref().map(cell).unwrap_or_default())
    }
}

/// The patterns of a run; of their grid only the counts matter here.
fn wanted(file: &Path) -> Result<Patterns, Error> {
    let light = read_patterns(file)?.remove(0);
    let [frames, rows, columns] = light.shape;
    Ok(Patterns {
        grid: PatternGrid::full_turn(frames, 0.0, rows, columns, 1.0),
        values: light.shown,
    })
}

/// Error diffusion at a share of the brightest pixel as the full scale.
fn diffused(wanted: &Patterns, scale: f32, bits: u32) -> Patterns {
    let full = scale * wanted.values.iter().copied().fold(0.0, f32::max);
    let mut cut = wanted.clone();
    cut.values
        .iter_mut()
        .for_each(|value| *value = value.min(full));
    tomolith::optimize::levels::diffused(&cut, bits)
}

/// IoU, VER and process window.
fn cell(print: &Quality) -> String {
    let [iou, ver, pw] = [print.iou, print.ver, print.pw].map(|m| m.unwrap_or(f64::NAN));
    format!("{iou:.4} · {ver:.3} · {pw:.3}")
}
