//! A run that was cut off on any level of its voxels goes on with the same bits.

use crate::{StopAfter, history, job_of};
use std::path::Path;
use tomolith::Error;
use tomolith::io::npy::read_patterns;
use tomolith::job;
use tomolith::models::Work;

const GEAR: &str = r#"
        target = { phantom = "gear", size_mm = 2.0 }
        grid = { pitch_mm = 0.2 }
        resin = { refractive_index = 1.5, absorption_per_mm = 0.1 }
        vial = { index_matched = { radius_mm = 2.0 } }
        light = [{ pixels = [16, 12], angles = 20, projector = { collimated = { pixel_pitch_mm = 0.2 } } }]
        stop = { iterations = 8 }
    "#;

/// Oxygen that flows, simulated anew before iterations 3, 5 and 7.
const OXYGEN: &str = r#"
        schedule = { seconds_per_turn = 5.0, turns = 3, optimize = "frozen", rounds = 3 }
        [[material.photopolymer.networks]]
        name = "resin"
        curing = { threshold = { critical_dose_mj_per_mm3 = 0.4 } }
        inhibitors = [{ capacity_mj_per_mm3 = 0.2, diffusion_mm2_per_s = 1e-3 }]
    "#;

fn run(text: &str, folder: &Path, resume: bool, stop_after: usize) -> Result<usize, Error> {
    let job = job_of(text, &[""; 0])?.with_folder(folder, "");
    let work = Work::new();
    let summary = job::run(&job, resume, &mut StopAfter(stop_after, &work), &work)?;
    Ok(summary.iterations.unwrap_or(0))
}

/// The patterns of a run that is not cut off, and those of runs that are cut off after these iterations and go on.
fn must_go_on(text: &str, cuts: &[usize]) {
    let folder = tempfile::tempdir().unwrap();
    let whole = folder.path().join("whole");
    assert_eq!(run(text, &whole, false, usize::MAX).unwrap(), 8);
    let expected = read_patterns(&whole.join("patterns.npz")).unwrap();
    let measured = |folder: &Path| history(folder, ["loss", "iou", "process_window"]);
    for &stop_after in cuts {
        let cut = folder.path().join(format!("cut-{stop_after}"));
        let stopped = run(text, &cut, false, stop_after);
        assert!(matches!(stopped, Err(Error::Canceled)), "{stopped:?}");
        assert!(cut.join("checkpoint/state.safetensors").exists());
        assert_eq!(run(text, &cut, true, usize::MAX).unwrap(), 8);
        let found = read_patterns(&cut.join("patterns.npz")).unwrap();
        assert_eq!(found, expected, "cut off after {stop_after}");
        assert_eq!(
            measured(&cut),
            measured(&whole),
            "cut off after {stop_after}"
        );
    }
}

#[test]
fn a_run_goes_on_with_the_same_bits_from_every_level() {
    // Four iterations on coarse voxels, four on fine ones
    must_go_on(GEAR, &[2, 4, 6]);
}

#[test]
fn a_print_in_time_goes_on_with_what_its_simulation_found() {
    // Before a simulation, and after one
    must_go_on(&format!("{GEAR}{OXYGEN}"), &[2, 3, 6]);
}
