//! What tests of dose models share.

use tomolith_core::check::noise;
use tomolith_core::dose::DoseLayout;

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
