//! BCLP in physical units: the parameter sweeps of Li et al. 2024, section 3.4, on a small picture. 500 voxels a cm and α = 0.001 per cm, as in their
//! Supplementary Table 1; 64² voxels for their 512², so the orderings are theirs and not the losses.

use crate::{Finished, image, job_of, losses};
use tomolith::grid::Volume;
use tomolith::io::npy;
use tomolith::job::{Job, ResolvedJob, Silent};
use tomolith::models::Work;

const JOB: &str = r#"
    target = { size_mm = 1.2, height_mm = 0.02 }
    grid = { pitch_mm = 0.02, refine = 1, shape = [64, 64, 1] }
    resin = { refractive_index = 1.5, absorption_per_mm = 1e-4 }
    vial = { index_matched = { radius_mm = 1.0 } }
    light = [{ pixels = [64, 1], angles = 60, projector = { collimated = { pixel_pitch_mm = 0.02 } } }]
    objectives = [{ bclp = { epsilon = 0.05, p = 2, q = 1 } }]
    stop = { iterations = 60 }
    evaluate = { refine = 1 }
"#;

fn job(changes: &[&str]) -> Job {
    let image = image("target.image", "rings.png");
    job_of(JOB, &[&[&*image], changes].concat()).unwrap()
}

/// What a run ends with.
struct Ended {
    loss: f64,
    /// Voxels out of ±0.05, and the largest distance from it.
    out: f64,
    largest: f64,
    dose: Vec<f32>,
}

fn ended(changes: &[&str]) -> Ended {
    let run = Finished::run(job(changes), &mut Silent);
    let report = run.report();
    let number = |key: &str| report["published"][key]["value"].as_f64().unwrap();
    Ended {
        loss: *losses(&run.path("")).last().unwrap(),
        out: number("bclp_l0"),
        largest: number("bclp_linf"),
        dose: npy::read_volume(&run.path("dose.npy")).unwrap().1,
    }
}

#[test]
fn a_wider_band_has_a_smaller_loss() {
    // Section 3.4.2: 0, 0.879, 6.20, 18.9
    let losses = ["0.2", "0.1", "0.05", "0"]
        .map(|e| ended(&[&format!("objectives[0].bclp.epsilon={e}")]).loss);
    assert_eq!(losses[0], 0.0);
    assert!(
        losses.windows(2).all(|pair| pair[0] < pair[1]),
        "{losses:?}"
    );
}

#[test]
fn a_steep_response_helps_up_to_a_point() {
    // Section 3.4.1: 97.6 for a linear response; 53.5, 9.05, 49.3 for B = 10, 25, 150
    let logistic = |steepness: &str| {
        let response =
            format!("response={{ logistic = {{ steepness = {steepness}, midpoint = 0.5 }} }}");
        ended(&[&response]).loss
    };
    let linear = ended(&[]).loss;
    let losses = ["10", "25", "150"].map(logistic);
    assert!(linear > losses[0] && losses[0] > losses[1], "{losses:?}");
    assert!(losses[2] > losses[1], "{losses:?}");
}

#[test]
fn a_small_p_keeps_more_voxels_in_the_band_and_a_large_one_the_largest_error_small() {
    // Section 3.4.4
    let all = ["0.5", "1", "2", "20"].map(|p| ended(&[&format!("objectives[0].bclp.p={p}")]));
    let out = all.each_ref().map(|ended| ended.out);
    let largest = all.each_ref().map(|ended| ended.largest);
    assert!(out.windows(2).all(|pair| pair[0] < pair[1]), "{out:?}");
    // Between 0.5 and 1 it hardly changes
    assert!(largest[0] > largest[2], "{largest:?}");
    let fall = largest[1..].windows(2).all(|pair| pair[0] > pair[1]);
    assert!(fall, "{largest:?}");
}

/// Errors of a disc (root of the sum of squares) beside the axis whose voxels have the first of two numbers, all others the second: a run each.
fn errors_in_a_disc(key: &str, runs: [[f32; 2]; 3], changes: &[&str]) -> [f32; 3] {
    let resolved = ResolvedJob::new(&job(&[])).unwrap();
    let task = resolved.task(&Work::new()).unwrap();
    let grid = task.target.inside.grid.clone();
    // A quarter of the inscribed circle's area
    let is_disc = |[x, y, _]: [f64; 3]| (x - 0.2).hypot(y) < 0.32;
    let folder = tempfile::tempdir().unwrap();
    runs.map(|[inside, outside]| {
        let number = |middle| if is_disc(middle) { inside } else { outside };
        let file = folder.path().join("disc.npy");
        let numbers = Volume::from_fn(grid.clone(), number);
        npy::write_volume(&file, &numbers, &Work::new()).unwrap();
        let file = format!(
            "objectives[0].{key}={{ file = {:?} }}",
            file.display().to_string()
        );
        let dose = ended(&[changes, &[&file]].concat()).dose;
        let pairs = dose.iter().zip(&task.target.inside.values).enumerate();
        let squares = pairs
            .filter(|(i, _)| is_disc(grid.middle(*i)))
            .map(|(_, (a, b))| (a - b).powi(2));
        squares.sum::<f32>().sqrt()
    })
}

#[test]
fn a_disc_that_weighs_more_is_nearer_to_its_picture() {
    // Section 3.4.3, eq. 30; the spatial sum of weights stays
    let errors = errors_in_a_disc("weights", [[0.1, 1.3], [1.0, 1.0], [3.5, 0.17]], &[]);
    assert!(
        errors.windows(2).all(|pair| pair[0] > pair[1]),
        "{errors:?}"
    );
}

#[test]
fn a_disc_with_a_wide_tolerance_is_farther_from_its_picture() {
    // Section 3.4.3, eq. 29: 0.4, 0.1 and 0 in the disc, 0.1 outside of it; the last two are "almost identical"
    let runs = [[0.4, 0.1], [0.1, 0.1], [0.0, 0.1]];
    let errors = errors_in_a_disc("tolerance", runs, &["objectives[0].bclp.epsilon=0"]);
    assert!(errors[0] > errors[1] && errors[1] > errors[2], "{errors:?}");
    assert!(errors[0] > 2.0 * errors[1], "{errors:?}");
}
