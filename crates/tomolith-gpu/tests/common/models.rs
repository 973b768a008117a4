//! What tests of dose models share.

use tomolith_core::check::{self, noise};
use tomolith_core::dose::{DoseLayout, DoseModel, Work, frames_of};
use tomolith_core::field::Field;
use tomolith_gpu::GpuField;
use tomolith_optics::light::Light;

/// Noise on the voxels of a dose, 0 in what fills up its rows.
pub(crate) fn noise_of(layout: &DoseLayout, seed: u64) -> Vec<f32> {
    let mut values = noise(seed, layout.len());
    let nz = layout.grid.shape[0];
    let rows = values[..layout.voxels()].chunks_mut(layout.row);
    rows.for_each(|row| row[nz..].fill(0.0));
    values
}

pub(crate) fn assert_near(found: &[f32], expected: &[f32], tolerance: f32, what: &str) {
    let most = expected.iter().fold(0.0f32, |m, v| m.max(v.abs()));
    assert!(most > 0.0 && found.len() == expected.len(), "{what}");
    let worst = (found.iter().zip(expected).enumerate())
        .max_by(|a, b| (a.1.0 - a.1.1).abs().total_cmp(&(b.1.0 - b.1.1).abs()))
        .unwrap();
    let (i, (found, expected)) = worst;
    assert!(
        (found - expected).abs() <= tolerance * most,
        "{what}: element {i} is {found} instead of {expected}, the largest {most}"
    );
}

/// A light whose pixels are not all active: columns end early.
pub(crate) fn with_dark_ends(mut light: Light) -> Light {
    let [frames, rows, columns] = light.pixels.shape();
    let run = |i: usize| ((i % 3) as u32, (rows - 3 - i % 4) as u32);
    light.active = Some((0..frames * columns).map(run).collect());
    light
}

/// Pixels that stay dark in the tests of masked models.
pub(crate) fn some_dark(pixels: usize) -> Vec<bool> {
    (0..pixels).map(|i| i % 11 == 3).collect()
}

/// Asserts that dose and adjoint are one matrix to `tolerance`, whose columns of dark pixels are 0; that a call again has the same bits; and
/// that frames one by one add up. The patterns that it took, and their dose.
pub(crate) fn assert_one_matrix(
    model: &dyn DoseModel<Field = GpuField>,
    dark: &[bool],
    tolerance: f64,
    what: &str,
) -> [GpuField; 2] {
    let x = check::noisy_patterns(model, 3);
    let mut c = model.new_dose().unwrap();
    c.copy_from_host(&noise_of(&model.outputs()[0], 4));
    let (dose, grad) = (check::dose(model, &x), check::adjoint(model, &c));
    let (left, right) = (dose.dot(&c), grad.dot(&x));
    let size = dose.norm() * c.norm();
    assert!(
        (left - right).abs() < tolerance * size,
        "{what}: {left} {right} of {size}"
    );
    let marks = dark.iter().zip(grad.to_host());
    assert!(marks.into_iter().all(|(&dark, grad)| !dark || grad == 0.0));
    assert_eq!(check::dose(model, &x).to_host(), dose.to_host(), "{what}");
    assert_eq!(
        check::adjoint(model, &c).to_host(),
        grad.to_host(),
        "{what}"
    );
    let (mut sum, mut alone) = (model.new_dose().unwrap(), grad.zeros_like());
    let work = Work::new();
    for frame in 0..frames_of(model.patterns()) {
        let frame = frame..frame + 1;
        model.dose_of(frame.clone(), &x, &mut sum, &work).unwrap();
        model.pullback_of(frame, &x, &c, &mut alone, &work).unwrap();
    }
    assert_near(&sum.to_host(), &dose.to_host(), 1e-6, what);
    assert_eq!(alone.to_host(), grad.to_host(), "{what}");
    [x, dose]
}
