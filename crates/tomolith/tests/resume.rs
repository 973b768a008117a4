//! A run that was cut off on any level of its voxels goes on with the same bits.

use std::path::Path;
use tomolith::Error;
use tomolith::io::npy::read_patterns;
use tomolith::job::{self, Document, Event, Job, Progress};
use tomolith::models::Run;

/// Asks to stop after an iteration.
struct StopAfter<'a> {
    iteration: usize,
    run: &'a Run,
}

impl Progress for StopAfter<'_> {
    fn event(&mut self, event: &Event) {
        if let Event::Iteration { iteration, .. } = event
            && *iteration == self.iteration
        {
            self.run.cancel();
        }
    }
}

fn run(folder: &Path, resume: bool, stop_after: usize) -> Result<usize, Error> {
    let text = r#"
        target = { phantom = "gear", size_mm = 2.0 }
        grid = { pitch_mm = 0.2 }
        resin = { refractive_index = 1.5, absorption_per_mm = 0.1 }
        vial = { index_matched = { radius_mm = 2.0 } }
        light = [{ pixels = [16, 12], angles = 20, projector = { collimated = { pixel_pitch_mm = 0.2 } } }]
        stop = { iterations = 8 }
    "#;
    let job =
        Job::from_document(Document::toml(Path::new("gear.toml"), text)?)?.with_folder(folder, "");
    let run = Run::new();
    let mut progress = StopAfter {
        iteration: stop_after,
        run: &run,
    };
    let summary = job::run(&job, resume, &mut progress, &run)?;
    Ok(summary.iterations.unwrap_or(0))
}

#[test]
fn a_run_goes_on_with_the_same_bits_from_every_level() {
    let folder = tempfile::tempdir().unwrap();
    let whole = folder.path().join("whole");
    assert_eq!(run(&whole, false, usize::MAX).unwrap(), 8);
    let expected = read_patterns(&whole.join("patterns.npz")).unwrap();
    // Four iterations on coarse voxels, four on fine ones
    for stop_after in [2, 4, 6] {
        let cut = folder.path().join(format!("cut-{stop_after}"));
        let stopped = run(&cut, false, stop_after);
        assert!(matches!(stopped, Err(Error::Canceled)), "{stopped:?}");
        assert!(cut.join("checkpoint/state.safetensors").exists());
        assert_eq!(run(&cut, true, usize::MAX).unwrap(), 8);
        let found = read_patterns(&cut.join("patterns.npz")).unwrap();
        assert_eq!(found, expected, "cut off after {stop_after}");
    }
}
