use super::start::starting_patterns;
use super::watch::{idle, is_measured};
use super::*;
use crate::field::HostField;
use crate::job::Job;
use crate::models::{DoseModel, planner};
use crate::optimize::Row;

#[test]
fn a_run_that_stayed_at_its_start_says_so() {
    let history = |losses: &[f64]| -> Vec<Row> {
        let row = |(iteration, &loss): (usize, &f64)| Row {
            response: Vec::new(),
            print: None,
            iteration,
            loss,
            projected_gradient: None,
            step: None,
            forward: 0,
            adjoint: 0,
            seconds: 0.0,
        };
        losses.iter().enumerate().map(row).collect()
    };
    assert_eq!(idle(&history(&[2.0, 3.0, 1.9]), false, None), None);
    assert_eq!(idle(&history(&[2.0]), false, Some(4)), None);
    assert_eq!(idle(&history(&[0.0, 0.0]), false, None), None);
    let said = idle(&history(&[2.0, 2.0, 2.5]), false, Some(4)).unwrap();
    assert!(said.contains("bounds.bits = 4"), "{said}");
    // Row 0 of a method with a start and a scale of its own says nothing of its steps
    assert_eq!(idle(&history(&[2.0, 9.0, 9.5]), true, None), None);
    assert!(idle(&history(&[2.0, 9.0, 9.0]), true, None).is_some());
    assert_eq!(idle(&history(&[2.0]), true, None), None);
}

/// A job whose light spreads: its voxels, its models, and where it begins.
fn started(model: &str) -> (Voxels, planner::ModelPlan, HostField) {
    let folder = tempfile::tempdir().unwrap();
    let file = folder.path().join("job.toml");
    let text = format!(
        r#"
        target = {{ phantom = {{ sphere = {{}} }}, size_mm = 0.02 }}
        grid = {{ pitch_mm = 0.001 }}
        resin = {{ refractive_index = 1.5, pure_radon = true }}
        vial = {{ index_matched = {{ radius_mm = 0.02 }} }}
        light = [{{ wavelength_nm = 405, pixels = [36, 24], angles = 24,
            projector = {{ collimated = {{ pixel_pitch_mm = 0.001 }} }} }}]
        model = {model}
        objective = {{ threshold = {{ lower = 0.7, upper = 0.9 }} }}
        optimizer = {{ lbfgs = {{}} }}
        stop = {{ iterations = 1 }}
        "#
    );
    std::fs::write(&file, text).unwrap();
    let job = Job::read(&file, &[]).unwrap();
    let scene = Scene::new(&job, &Run::new()).unwrap();
    let voxels = scene.voxels(&scene.grid).unwrap();
    let (asked, wanted) = (scene.optics.model.as_ref(), voxels.wanted());
    let (optics, run) = (scene.optimizing(), Run::new());
    let plan = planner::plan(asked, optics, &scene.grid, Some(&wanted), &run).unwrap();
    let models = (&plan.model as _, plan.surrogate.as_deref());
    let start = scene.kinds.start.as_ref();
    let x = starting_patterns(&scene, &[&voxels], models, start, &Run::new()).unwrap();
    (voxels, plan, x)
}

/// Dose of a model at the voxels of the part.
fn in_part(model: &dyn DoseModel<Field = HostField>, x: &HostField, voxels: &Voxels) -> Vec<f64> {
    let mut dose = model.new_dose().unwrap();
    model.dose(x, &mut dose, &Run::new()).unwrap();
    let dose = model.outputs()[0].volume_of(dose.as_slice());
    let all = dose.values.iter().zip(&voxels.labels.values);
    let own = all.filter(|(_, label)| **label == crate::target::label::PART);
    own.map(|(dose, _)| f64::from(*dose)).collect()
}

/// Σd / Σd²: 1 where no other factor brings doses nearer to 1.
fn factor(doses: &[f64]) -> f64 {
    doses.iter().sum::<f64>() / doses.iter().map(|d| d * d).sum::<f64>()
}

#[test]
fn a_start_of_waves_brings_the_dose_that_is_wanted_whatever_the_pupil_takes() {
    for model in ["{ wave = {} }", "{ wave = { numerical_aperture = 0.02 } }"] {
        let (voxels, plan, x) = started(model);
        let found = factor(&in_part(&plan.model, &x, &voxels));
        assert!((found - 1.0).abs() < 1e-5, "{model}: {found}");
        let mut energies = x.clone();
        for value in energies.as_mut_slice() {
            *value *= *value;
        }
        let straight = plan.surrogate.as_deref().unwrap();
        let rays = factor(&in_part(straight, &energies, &voxels));
        let off = (rays - 1.0).abs();
        // What fades of the pixels' band is little; a narrow pupil takes more
        assert!(
            if model.contains("aperture") {
                off > 0.1
            } else {
                off < 0.1
            },
            "{rays}"
        );
    }
}

#[test]
fn a_start_of_light_that_spreads_is_that_of_straight_light_in_energies() {
    let (voxels, plan, x) = started("{ incoherent_cone = { half_angle_deg = 0.5 } }");
    let straight = plan.surrogate.as_deref().unwrap();
    let [own, rays] = [&plan.model as _, straight].map(|m| factor(&in_part(m, &x, &voxels)));
    assert!((rays - 1.0).abs() < 1e-5, "{rays}");
    // Roots of energies would be off by several times
    assert!((own - 1.0).abs() < 0.1, "{own}");
}

#[test]
fn measured_iterations_thin_out_evenly() {
    let measured = |last: usize| (0..=last).filter(|&i| is_measured(i)).collect::<Vec<_>>();
    assert_eq!(
        measured(40),
        [
            0, 1, 2, 3, 4, 5, 6, 7, 8, 10, 12, 14, 16, 20, 24, 28, 32, 40
        ]
    );
    assert!(measured(10).len() >= 10);
    assert_eq!(measured(1024).len(), 1 + 8 + 4 * 7);
}
