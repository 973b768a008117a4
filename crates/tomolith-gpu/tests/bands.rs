//! The band loss on a card beside that of the host: all kinds of bands, powers and responses.

mod common;
#[path = "common/portable.rs"]
mod portable;

use common::{SMALL, gpu};
use std::sync::Arc;
use tomolith_core::check::noise;
use tomolith_core::dose::DoseLayout;
use tomolith_core::field::{Band, BandKernel, BandLoss, Bands, Field, HostField};
use tomolith_core::grid::VolumeGrid;
use tomolith_core::near;
use tomolith_core::response::table::Beyond;
use tomolith_core::response::{Identity, Logistic, Response, Table, logistic};
use tomolith_gpu::{Gpu, GpuField};

const LEN: usize = 24 * 31 * 48;

fn bands() -> Vec<Bands> {
    let part = Band::new(0.9, f32::INFINITY, 1.0);
    let void = Band::new(f32::NEG_INFINITY, 0.3, 0.7);
    let shares: Vec<f32> = noise(1, LEN).iter().map(|v| 1.3 * v.abs() - 0.15).collect();
    let shares: Vec<f32> = shares
        .iter()
        .map(|s| if *s < 0.0 { -1.0 } else { s.min(1.0) })
        .collect();
    let shared = |scale, widen| Bands::Shared {
        inside: shares.clone(),
        part,
        void,
        scale,
        widen,
    };
    let some = |seed| {
        noise(seed, LEN)
            .iter()
            .map(|v| 0.2 * v.abs())
            .collect::<Vec<f32>>()
    };
    let lower = some(2);
    let upper: Vec<f32> = lower.iter().map(|v| v + 0.4).collect();
    vec![
        Bands::labels(
            (0..LEN).map(|i| (i / 5 % 3) as u8).collect(),
            &[(1, void), (2, part)],
        ),
        shared(Vec::new(), Vec::new()),
        shared(some(3), some(4)),
        Bands::Voxels {
            lower: lower.into(),
            upper: upper.into(),
            weight: some(5).into(),
        },
    ]
}

fn responses() -> Vec<Arc<dyn Response>> {
    let params = logistic::Params {
        steepness: 5.0,
        midpoint: 0.4,
        ..logistic::Params::default()
    };
    let table = Table::new(&[0.0, 0.3, 0.7, 1.0], &[0.0, 0.1, 0.8, 1.0], Beyond::Linear);
    vec![
        Arc::new(Identity),
        Arc::new(Logistic::new(params).unwrap()),
        Arc::new(table.unwrap()),
    ]
}

/// A dose field of the card, with 16 elements before and behind those of a loss.
fn like(gpu: &Gpu) -> GpuField {
    GpuField::for_dose(
        gpu,
        &DoseLayout::new("dose", VolumeGrid::centered([48, 31, 24], 0.1), 32),
    )
}

#[test]
fn values_gradients_and_slopes_are_those_of_the_host() {
    let Some(gpu) = gpu(SMALL) else { return };
    let like = like(&gpu);
    let values: Vec<f32> = noise(7, like.len()).iter().map(|v| 1.5 * v.abs()).collect();
    let steps = noise(8, like.len());
    let on_host = |values: &[f32]| HostField::from_slice(values);
    let on_card = |values: &[f32]| {
        let mut field = like.zeros_like();
        field.copy_from_host(values);
        field
    };
    let (dose, step) = (on_host(&values), on_host(&steps));
    let (there, along) = (on_card(&values), on_card(&steps));
    for (b, bands) in bands().into_iter().enumerate() {
        for response in responses() {
            for [p, q] in [[1.0, 1.0], [2.0, 2.0], [3.0, 1.0], [1.5, 2.0], [0.5, 0.5]] {
                let what = format!("bands {b}, p = {p}, q = {q}, {response:?}");
                let loss = BandLoss::new(16..16 + LEN, bands.clone(), p, q, response.clone());
                let loss = Arc::new(loss.unwrap());
                let host = <HostField as Field>::Bands::new(&loss, &dose);
                let card = <GpuField as Field>::Bands::new(&loss, &there);
                let near = |found: f64, expected: f64, what: &str| {
                    near!(found, expected, 2e-5 * expected.abs(), "{what}");
                };
                near(card.value(&there), host.value(&dose), &what);
                let (mut g, mut h) = (dose.zeros_like(), there.clone());
                let expected = host.value_and_gradient(&dose, &mut g);
                near(card.value_and_gradient(&there, &mut h), expected, &what);
                let most = g.max_abs();
                // Where a power is below 1, the slope near the edge of a band is that of the rounding
                let tolerance = if p < 1.0 { 1e-3 } else { 1e-4 };
                for (i, (found, expected)) in h.to_host().iter().zip(g.as_slice()).enumerate() {
                    assert!(
                        (found - expected).abs() < tolerance * most,
                        "{what}: {found} instead of {expected} at {i}"
                    );
                }
                let (expected, slope) = host.slope_along(&dose, &step, 0.01);
                let found = card.slope_along(&there, &along, 0.01);
                near(found.0, expected, &what);
                let size = g.norm() * step.norm();
                assert!(
                    (found.1 - slope).abs() < 1e-5 * size,
                    "{what}: slope {} instead of {slope}",
                    found.1
                );
                let mut moved = there.clone();
                let mut gradient = along.clone();
                let mut at = dose.clone();
                at.axpy(0.01, &step);
                near(
                    card.advance(&mut moved, &mut gradient, 0.01),
                    host.value(&at),
                    &what,
                );
            }
        }
    }
    portable::assert_portable(gpu.sources().iter().map(|(name, text)| (name, text)));
}

#[test]
fn a_dose_that_is_no_number_makes_a_loss_that_is_none() {
    let Some(gpu) = gpu(SMALL) else { return };
    let like = like(&gpu);
    let bands = bands().swap_remove(1);
    let loss = BandLoss::new(16..16 + LEN, bands, 2.0, 2.0, Arc::new(Identity)).unwrap();
    let card = <GpuField as Field>::Bands::new(&Arc::new(loss), &like);
    let mut dose = like.zeros_like();
    dose.fill(0.5);
    assert!(card.value(&dose).is_finite());
    dose.write(10_000, &[f32::NAN]);
    assert!(card.value(&dose).is_nan());
}
