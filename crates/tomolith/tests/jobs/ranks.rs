//! One job on several ranks, each a thread of this process: the same patterns as a process alone makes, up to the order of sums.

use crate::{StopAfter, job_of, losses};
use std::path::{Path, PathBuf};
use std::sync::Arc;
use std::thread;
use std::time::Duration;
use tomolith::io::npy::read_patterns;
use tomolith::job::{self, Job, Leaves, Progress, Silent, Summary};
use tomolith::models::Work;
use tomolith::ranks::{Communicator, Threads};
use tomolith::{Error, Result};

const JOB: &str = r#"
target = { phantom = "gear", size_mm = 3.0 }
grid = { pitch_mm = 0.15, refine = 1 }
resin = { refractive_index = 1.4849, absorption_per_mm = 0.1 }
vial = { cylinder = { inner_radius_mm = 3.0, outer_radius_mm = 3.4, refractive_index = 1.58 } }
light = [{ pixels = [32, 16], angles = 40, projector = { collimated = { pixel_pitch_mm = 0.15 } } }]
evaluate = { refine = 1, sub_angles = 1 }
stop = { iterations = 4 }
"#;

// Few iterations: L-BFGS keeps its memory in 16 bits, so that a difference in the last bit of a sum grows some ten times an iteration.

/// Waves on lengths where they matter; their unknowns are amplitudes.
const WAVES: [&str; 8] = [
    "model={wave={}}",
    "target={phantom={sphere={}}, size_mm=0.02}",
    "grid.pitch_mm=0.001",
    "resin={refractive_index=1.5, pure_radon=true}",
    "vial={index_matched={radius_mm=0.02}}",
    "light=[{wavelength_nm=405, pixels=[36, 24], angles=12, projector={collimated={pixel_pitch_mm=0.001}}}]",
    "optimizer={gradient={}}",
    "stop.iterations=1",
];

/// Image, vial and resin as they might be.
const SCENARIOS: [&str; 3] = [
    "scenario=[{set={\"light[0].offset_mm\"=[0.05, 0]}}, {set={vial.cylinder.inner_radius_mm=3.05}}, {set={resin.absorption_per_mm=0.12}}]",
    "robust.of=worst",
    "optimizer={fista={}}",
];

/// Two species by two lights, of which the second inhibits one.
const SPECIES: [&str; 3] = [
    "light=[{name=\"violet\", pixels=[32, 16], angles=40, projector={collimated={pixel_pitch_mm=0.15}}}, {name=\"uv\", pixels=[28, 14], angles=31, projector={collimated={pixel_pitch_mm=0.15}}}]",
    "species=[{name=\"soft\", driven_by={violet=1.0, uv=-0.2}}, {name=\"stiff\", driven_by={uv=2.0}, target={phantom=\"sphere\", size_mm=1.0}}]",
    "optimizer={fista={}}",
];

const PENALTIES: &str = "penalties=[{smoothness={}, weight=1e-3}, {sparsity={}, weight=1e-3}]";

/// A job with keys set otherwise, in a folder of its own.
fn job(folder: &Path, changes: &[&str]) -> Job {
    let job = job_of(JOB, changes).unwrap();
    job.with_folder(&folder.join("run"), "--output")
}

/// What every rank came to, rank 0's request to stop after `stop` iterations included.
fn on_ranks(
    size: usize,
    jobs: impl Fn(usize) -> Job + Sync,
    resume: bool,
    stop: usize,
) -> Vec<Result<Option<Summary>>> {
    let work = |rank: Threads| {
        let job = jobs(rank.rank());
        let ranks: Arc<dyn Communicator> = Arc::new(rank);
        let work = Work::with_patience(Duration::MAX);
        let mut watch = StopAfter(stop, &work);
        let progress: &mut dyn Progress = match ranks.is_first() {
            true => &mut watch,
            false => &mut Silent,
        };
        job::run_among(&job, resume, Leaves::Patterns, &ranks, progress, &work)
    };
    thread::scope(|scope| {
        let ranks = Threads::ranks(size).into_iter();
        let threads: Vec<_> = ranks.map(|rank| scope.spawn(|| work(rank))).collect();
        let joined = threads.into_iter().map(|thread| thread.join());
        joined.map(|found| found.unwrap()).collect()
    })
}

/// The patterns before quantization, and the losses of the run, in its folder.
fn outcome(job: &Job) -> (Vec<f32>, Vec<f64>) {
    let arrays = read_patterns(&job.folder().join("patterns.npz")).unwrap();
    let patterns = arrays.into_iter().flat_map(|array| array.raw.unwrap());
    (patterns.collect(), losses(&job.folder()))
}

/// How far one job's result is from another's.
#[derive(Debug)]
struct Difference {
    /// The root of the mean square over all pixels, over the brightest pixel.
    rms: f64,
    /// The largest of a pixel, over the brightest pixel.
    largest: f64,
    /// The largest of a loss, over that loss.
    loss: f64,
}

fn difference(one: &Job, other: &Job) -> Difference {
    let ((a, losses), (b, other_losses)) = (outcome(one), outcome(other));
    assert_eq!((a.len(), losses.len()), (b.len(), other_losses.len()));
    let top = f64::from(a.iter().copied().fold(0.0, f32::max));
    let apart = || {
        a.iter()
            .zip(&b)
            .map(|(a, b)| f64::from((a - b).abs()) / top)
    };
    let of_losses = losses.iter().zip(&other_losses);
    let of_losses = of_losses.map(|(a, b)| (a - b).abs() / a.abs().max(1e-9));
    let squares: f64 = apart().map(|difference| difference * difference).sum();
    Difference {
        rms: (squares / a.len() as f64).sqrt(),
        largest: apart().fold(0.0, f64::max),
        loss: of_losses.fold(0.0, f64::max),
    }
}

#[test]
#[ignore = "slow"]
fn ranks_make_the_patterns_of_a_process_alone() {
    for (size, changes) in [
        (2, vec![]),
        (3, vec!["light.angles=41", "optimizer={fista={}}"]),
        (2, vec!["optimizer={osmo={}}"]),
        (2, vec!["optimizer={cal={}}", "start.fbp.scale=analytic"]),
        (2, vec![PENALTIES, "optimizer={gradient={}}"]),
        (
            2,
            vec![
                "multiresolution={levels=1, iterations=2}",
                "stop.iterations=2",
            ],
        ),
        (4, vec!["model={rays={}}", "light.angles=6"]),
        (2, WAVES.to_vec()),
        (3, SCENARIOS.to_vec()),
        (2, SPECIES.to_vec()),
    ] {
        let folders = [(); 2].map(|()| tempfile::tempdir().unwrap());
        let [alone, shared] = folders
            .each_ref()
            .map(|folder| job(folder.path(), &changes));
        job::run_leaving(&alone, false, Leaves::Patterns, &mut Silent, &Work::new()).unwrap();
        let found = on_ranks(size, |_| shared.clone(), false, usize::MAX);
        let found: Vec<bool> = found.into_iter().map(|r| r.unwrap().is_some()).collect();
        let expected: Vec<bool> = (0..size).map(|rank| rank == 0).collect();
        assert_eq!(found, expected, "{changes:?}");
        let apart = difference(&alone, &shared);
        // What L-BFGS remembers has 8 bits of mantissa: the last bit of a sum moves single pixels, and a loss of fourth powers by some of the last
        // bits of a dose (1.0e-6 with AVX-512, less with AVX2). Differences are relative to the brightest pixel, which the lowest ceiling makes darker
        assert!(apart.rms < 2e-5, "{size} ranks, {changes:?}: {apart:?}");
        assert!(apart.largest < 1e-3, "{size} ranks, {changes:?}: {apart:?}");
        assert!(apart.loss < 1e-5, "{size} ranks, {changes:?}: {apart:?}");
    }
}

#[test]
fn what_cannot_be_shared_is_refused_before_any_work() {
    for (changes, key) in [
        (vec!["light.angles=2"], "light[0].angles"),
        (vec!["model={monte_carlo={}}"], "model"),
        (
            vec!["penalties=[{smoothness={angles=1.0}, weight=1}]"],
            "penalties",
        ),
        (
            vec![
                "material={diffusion={mm2_per_s=1e-4}}",
                "schedule={seconds_per_turn=20.0, turns=1, power={energy_mj_per_mm2=1.0}}",
                "resin.critical_dose_mj_per_mm3=0.8",
            ],
            "material.diffusion",
        ),
        (vec!["evaluate.bit_depth=2"], "evaluate.levels"),
        (
            vec!["light.selection.min_contribution=0.1"],
            "light.selection.min_contribution",
        ),
    ] {
        let folder = tempfile::tempdir().unwrap();
        let job = job(folder.path(), &changes);
        let mut found = on_ranks(3, |_| job.clone(), false, usize::MAX).into_iter();
        match found.next().unwrap() {
            Err(Error::Config { key: found, .. }) => assert_eq!(found, key),
            other => panic!("{changes:?}: {other:?}"),
        }
        assert!(found.all(|other| matches!(other, Err(Error::Rank { rank: 0 }))));
        assert!(!job.folder().exists(), "{changes:?}");
    }
}

#[test]
fn monte_carlo_paths_that_only_a_trial_takes_are_refused_too() {
    let folder = tempfile::tempdir().unwrap();
    // So many cells that successive orders give way to Monte Carlo paths
    let keys = [
        "resin.scattering_per_mm=30",
        "vial={index_matched={radius_mm=4.0}}",
        "resin.refractive_index=1.5",
    ];
    let job = job(folder.path(), &keys);
    let found = on_ranks(2, |_| job.clone(), false, usize::MAX);
    let text = found[0].as_ref().unwrap_err().to_string();
    tomolith_core::contains!(text, "Monte Carlo paths, which would be others in a share");
    assert!(found[1].is_err());
}

#[test]
fn a_rank_with_another_job_or_that_would_stop_elsewhere_ends_all_of_them() {
    let folder = tempfile::tempdir().unwrap();
    for (change, part) in [
        ("resin.absorption_per_mm=0.2", "differ from those of rank 0"),
        ("stop.change=0.5", "its [stop], [checkpoint]"),
    ] {
        let of_rank = |rank| match rank {
            1 => job(folder.path(), &[change]),
            _ => job(folder.path(), &[]),
        };
        let found = on_ranks(2, of_rank, false, usize::MAX);
        assert!(
            matches!(&found[0], Err(Error::Rank { rank: 1 })),
            "{found:?}"
        );
        let message = found[1].as_ref().unwrap_err().to_string();
        tomolith_core::contains!(message, part);
    }
}

#[test]
fn any_number_of_ranks_goes_on_from_a_checkpoint_of_others() {
    let folder = tempfile::tempdir().unwrap();
    let job = job(folder.path(), &["checkpoint.every_s=1e-3"]);
    let checkpoint: PathBuf = job.folder().join("checkpoint/state.safetensors");
    let stopped = on_ranks(2, |_| job.clone(), false, 3);
    let canceled = |found: &Result<_>| matches!(found, Err(Error::Canceled));
    assert!(stopped.iter().all(canceled), "{stopped:?}");
    let saved = std::fs::read(&checkpoint).unwrap();
    assert!(job.folder().join("checkpoint/patterns.npz").exists());
    // A whole run from it, on one process and on three; each begins at the loss that the stopped one had reached
    let mut begins = Vec::new();
    for size in [1, 3] {
        std::fs::write(&checkpoint, &saved).unwrap();
        if size == 1 {
            job::run_leaving(&job, true, Leaves::All, &mut Silent, &Work::new()).unwrap();
        } else {
            let found = on_ranks(size, |_| job.clone().overwriting(), true, usize::MAX);
            assert!(found.iter().all(Result::is_ok), "{found:?}");
        }
        begins.push(losses(&job.folder())[0]);
    }
    let whole = tempfile::tempdir().unwrap();
    let whole = self::job(whole.path(), &[]);
    job::run_leaving(&whole, false, Leaves::Patterns, &mut Silent, &Work::new()).unwrap();
    let reached = losses(&whole.folder())[3];
    for begin in begins {
        tomolith_core::near!(begin, reached, 1e-6 * reached);
    }
}

#[test]
fn ranks_begin_with_the_patterns_of_a_file() {
    let folder = tempfile::tempdir().unwrap();
    let first = job(folder.path(), &[]);
    job::run_leaving(&first, false, Leaves::Patterns, &mut Silent, &Work::new()).unwrap();
    let file = first.folder().join("patterns.npz");
    // Half as many angles: patterns between frames
    for angles in [40, 20] {
        let start = format!(
            "start={{patterns={{file={:?}}}}}",
            file.display().to_string()
        );
        let angles = format!("light.angles={angles}");
        let folders = [(); 2].map(|()| tempfile::tempdir().unwrap());
        let method = "optimizer={gradient={}}";
        let [alone, shared] = folders
            .each_ref()
            .map(|f| job(f.path(), &[&start, &angles, method]));
        job::run_leaving(&alone, false, Leaves::Patterns, &mut Silent, &Work::new()).unwrap();
        let found = on_ranks(2, |_| shared.clone(), false, usize::MAX);
        assert!(found.iter().all(Result::is_ok), "{found:?}");
        let apart = difference(&alone, &shared);
        assert!(apart.largest < 1e-5 && apart.loss < 1e-6, "{apart:?}");
    }
}
